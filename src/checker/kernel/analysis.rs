//! Limits, and the two analytic lemmas.

use super::fraction::Fraction;
use super::known::Known;
use super::order::Signs;
use super::scope::Variable;
use super::slope::is_bound;
use super::statement::{apply, compare, name, numeral, one_minus, power, product, prop, sum};
use super::term::Atom;
use super::{Checker, Reason, Refusal, key, rejected};
use crate::claim::syntax::*;
use num_rational::BigRational;
use num_traits::One;
use std::collections::BTreeMap;

/// What an acceptance says where it rests on rule `mean`.
pub const LEMMA: &str = "the weighted mean inequality for two values";

/// What an acceptance says where it rests on rule `tangent`.
pub(crate) const TANGENT: &str = "exp lies above its tangent";

/// `a^(1 - p)*b^p relation (1 - p)*a + p*b`.
pub fn weighted_mean(a: &Expr, b: &Expr, p: &Expr, relation: Relation) -> Prop {
    let rest = one_minus(p);
    let left = product(vec![power(a, &rest), power(b, p)]);
    let right =
        sum(vec![(Sign::Plus, product(vec![rest, a.clone()])), (Sign::Plus, product(vec![p.clone(), b.clone()]))]);
    compare(left, relation, right)
}

/// `1 + x relation exp(x)`.
pub fn tangent(x: &Expr, relation: Relation) -> Prop {
    let line = sum(vec![(Sign::Plus, numeral(1)), (Sign::Plus, x.clone())]);
    compare(line, relation, apply("exp", x.clone()))
}

/// `x = A`, or `x = A and y = B …`: that the variables of an extremum are at its point; `None` without variables.
pub fn at_the_point(e: &Extremum) -> Option<Prop> {
    let mut there: Vec<Prop> = e.at.iter().map(|(n, v)| compare(name(&n.text), Relation::Equal, v.clone())).collect();
    match there.len() {
        0 | 1 => there.pop(),
        _ => Some(prop(PropKind::And(there))),
    }
}

impl Checker {
    /// Rule `mean`: `a^(1 - p)*b^p <= (1 - p)*a + p*b` for a, b > 0 and 0 ≤ p ≤ 1; with `<` where a ≠ b and 0 < p < 1.
    ///
    /// Sound: ln is concave, strictly. An acceptance that rests on it says so.
    pub(super) fn mean(&mut self, goal: &Prop, with: &[(Name, Expr)], known: &mut Known) -> Result<(), Refusal> {
        self.prop_defined(goal, known)?;
        let find = |name: &str| with.iter().find(|w| w.0.text == name).map(|w| w.1.clone());
        let (Some(a), Some(b), Some(p), 3) = (find("a"), find("b"), find("p"), with.len()) else {
            return rejected(Reason::ValueForNoVariable);
        };
        let shown = key::prop(goal);
        let strict = shown == key::prop(&weighted_mean(&a, &b, &p, Relation::Less));
        if !strict && shown != key::prop(&weighted_mean(&a, &b, &p, Relation::LessEqual)) {
            return rejected(Reason::ItSays(weighted_mean(&a, &b, &p, Relation::LessEqual)));
        }
        let weight = if strict { Signs::POSITIVE } else { Signs::NOT_NEGATIVE };
        for (e, signs) in [(&a, Signs::POSITIVE), (&b, Signs::POSITIVE), (&p, weight), (&one_minus(&p), weight)] {
            if !self.signs_of_expr(e, known)?.within(signs) {
                return rejected(Reason::NoValue { part: e.clone(), signs });
            }
        }
        if strict {
            let difference = sum(vec![(Sign::Plus, a.clone()), (Sign::Minus, b.clone())]);
            if !self.signs_of_expr(&difference, known)?.within(Signs::NOT_ZERO) {
                return rejected(Reason::Needs(compare(a, Relation::NotEqual, b)));
            }
        }
        self.rests_on.insert(LEMMA.to_string());
        Ok(())
    }

    /// Rule `tangent`: `1 + x <= exp(x)`; with `<` where x ≠ 0.
    ///
    /// Sound: f(x) = exp x − 1 − x has f′(x) = exp x − 1, negative for x < 0 and positive for x > 0. So f falls strictly up to
    /// 0 and rises strictly from there, and f(0) = 0. An acceptance that rests on it says so.
    pub(super) fn tangent(&mut self, goal: &Prop, with: &[(Name, Expr)], known: &mut Known) -> Result<(), Refusal> {
        self.prop_defined(goal, known)?;
        let x = match with {
            [(word, x)] if word.text == "x" => x,
            _ => return rejected(Reason::ValueForNoVariable),
        };
        let shown = key::prop(goal);
        let strict = shown == key::prop(&tangent(x, Relation::Less));
        if !strict && shown != key::prop(&tangent(x, Relation::LessEqual)) {
            return rejected(Reason::ItSays(tangent(x, Relation::LessEqual)));
        }
        if strict && !self.signs_of_expr(x, known)?.within(Signs::NOT_ZERO) {
            return rejected(Reason::Needs(compare(x.clone(), Relation::NotEqual, numeral(0))));
        }
        self.rests_on.insert(TANGENT.to_string());
        Ok(())
    }

    /// Whether a variable that grows stands for natural numbers. No sequence depends on it.
    pub(super) fn kind_of(&self, variable: &str) -> Result<bool, Refusal> {
        if self.is_tied_by_sequence(variable) {
            return rejected(Reason::Tied(variable.to_string()));
        }
        match self.scope.iter().rev().find(|v| v.name == variable) {
            Some(v) if v.atom == Atom::Variable(variable.to_string()) => Ok(v.natural),
            _ => rejected(Reason::Undeclared(variable.to_string())),
        }
    }

    /// Rule `limit`: the limit of N/D, sums of powers of the variable that grows with rational numbers as exponents, by
    /// degrees; or that it is another than is said.
    ///
    /// The variable is another one here than outside: no fact says anything of it but that it is at least the numeral
    /// given as `from`.
    ///
    /// Sound: the expression has a value for every x ≥ `from`, all other variables stay as they are, and the
    /// coefficients do not depend on x. The degree is the greatest exponent; for x > 0 exponents add up, and a positive power
    /// of x grows without bound. If the degree of D is the greater, N/D → 0; if they are equal, N/D tends to the
    /// quotient of the leading coefficients, that of D being shown not to be 0. If that of N is the greater, and its leading
    /// coefficient is not 0, N/D is not bounded. A limit is one number.
    pub(super) fn limit(&mut self, goal: &Prop, with: &[(Name, Expr)], known: &mut Known) -> Result<(), Refusal> {
        let (limit, denied) = match &goal.kind {
            PropKind::Limit(limit) => (limit, false),
            PropKind::Not(inner) => match &inner.kind {
                PropKind::Limit(limit) => (limit, true),
                _ => return rejected(Reason::NotALimit),
            },
            _ => return rejected(Reason::NotALimit),
        };
        let variable = limit.variable.text.clone();
        let natural = self.kind_of(&variable)?;
        let atom = Atom::Growing(variable.clone());
        let place = self.intern(atom.clone());
        match with {
            [] => {}
            [(word, Expr { kind: ExprKind::Number(least), .. })] if word.text == "from" => {
                let least = Fraction::number(super::term::numeral(least)?);
                let room = Fraction::atom(place).minus(&least, &self.work)?;
                self.learn_signs(&room, Signs::NOT_NEGATIVE, known)?;
                // It is the sum of a number that is not negative and the numeral, which is not negative either.
                let signs = Signs::NOT_NEGATIVE.plus(Signs::of_number(&least.coefficient));
                self.learn_signs(&Fraction::atom(place), signs, known)?;
            }
            _ => return rejected(Reason::ValueForNoVariable),
        }
        // What these facts say of the variable outside, they do not say of this one: it is not in scope yet.
        if natural {
            self.learn_for_all(true, &atom, known)?;
        }
        self.scope.push(Variable { name: variable, natural, atom: atom.clone() });
        self.defined(&limit.of, known)?;
        self.defined(&limit.value, known)?;
        let (f, value) = (self.fraction(&limit.of)?, self.fraction(&limit.value)?);
        let (top, bottom) = f.parts(&self.work)?;
        let exponents = self.exponents_of(place);
        let (top, bottom) = (top.coefficients(&exponents), bottom.coefficients(&exponents));
        for poly in top.values().chain(bottom.values()) {
            if !self.is_free_of(&Fraction::of(poly), &atom)? {
                return rejected(Reason::NotRational);
            }
        }
        if !self.is_free_of(&value, &atom)? {
            return rejected(Reason::NotRational);
        }
        let Some((degree, lead)) = bottom.iter().next_back() else { return rejected(Reason::NotRational) };
        if !self.signs_of(&Fraction::of(lead), known)?.within(Signs::NOT_ZERO) {
            return rejected(Reason::LeadingCoefficient);
        }
        if let Some((_, greatest)) = top.iter().next_back().filter(|(k, _)| **k > *degree) {
            let grows = denied && self.signs_of(&Fraction::of(greatest), known)?.within(Signs::NOT_ZERO);
            self.scope.pop();
            return if grows { Ok(()) } else { rejected(Reason::OtherLimit) };
        }
        let quotient = match top.get(degree) {
            Some(c) => Fraction::of(c).times(&Fraction::of(lead).power(-1)?, &self.work)?,
            None => Fraction::integer(0),
        };
        let difference = quotient.minus(&value, &self.work)?;
        let shown = match denied {
            true => self.signs_of(&difference, known)?.within(Signs::NOT_ZERO),
            false => difference.is_zero(),
        };
        self.scope.pop();
        if shown { Ok(()) } else { rejected(Reason::OtherLimit) }
    }

    /// The atoms that are a power of this one with a rational number as exponent: itself, and its roots.
    pub fn exponents_of(&self, place: usize) -> BTreeMap<usize, BigRational> {
        let itself = Fraction::atom(place);
        let exponent = |(other, atom): (usize, &Atom)| match atom {
            Atom::Power(base, e) if *base == itself => Some((other, e.as_number()?.clone())),
            _ => None,
        };
        let roots = self.atoms.iter().enumerate().filter_map(exponent);
        roots.chain([(place, BigRational::one())]).collect()
    }

    /// Rule `squeeze`: the limit of F from `for all x >= N: A <= F`, `for all x >= M: F <= B` and the limits of A and B,
    /// all the same.
    ///
    /// Sound: from a number on, F lies between A and B. N and M have values, and x is bound in neither.
    pub(super) fn squeeze(&mut self, goal: &Prop, from: &[String]) -> Result<(), Refusal> {
        let PropKind::Limit(limit) = &goal.kind else { return rejected(Reason::NotALimit) };
        let [lower, upper, lower_limit, upper_limit] = from else { return rejected(Reason::NotALimit) };
        let natural = self.kind_of(&limit.variable.text)?;
        for (bound, its_limit, below) in [(lower, lower_limit, true), (upper, upper_limit, false)] {
            let its_limit = self.fact(its_limit)?;
            let PropKind::Limit(other) = &its_limit.kind else { return rejected(Reason::NotALimit) };
            if other.variable.text != limit.variable.text || key::expr(&other.value) != key::expr(&limit.value) {
                return rejected(Reason::OtherLimit);
            }
            let fact = self.fact(bound)?;
            let PropKind::ForAll(bindings, _) = &fact.kind else { return rejected(Reason::NotForAll) };
            let [binding] = bindings.as_slice() else { return rejected(Reason::NotForAll) };
            let [(variable, None)] = binding.names.as_slice() else { return rejected(Reason::NotForAll) };
            let unbounded = match binding.constraints.as_slice() {
                [] => true,
                [bound @ Constraint::Relation(Relation::Greater | Relation::GreaterEqual, _)] => {
                    [variable, &limit.variable].into_iter().all(|v| is_bound(bound, &v.text))
                }
                _ => false,
            };
            // A bound for all real numbers holds for the natural ones.
            if !unbounded || (binding.natural && !natural) {
                return rejected(Reason::NotUnbounded);
            }
            let at = |e: &Expr| super::tree::renamed(e, &limit.variable.text, &variable.text);
            let (a, f) = (at(&other.of)?, at(&limit.of)?);
            let comparison =
                if below { compare(a, Relation::LessEqual, f) } else { compare(f, Relation::LessEqual, a) };
            let expected = Prop { kind: PropKind::ForAll(bindings.clone(), Box::new(comparison)), span: goal.span };
            if key::prop(&expected) != key::prop(&fact) {
                return rejected(Reason::Needs(expected));
            }
        }
        Ok(())
    }

    /// Rule `along`: the limit of F as x grows from that of G as y grows, which is F with exp(y) in the place of x.
    ///
    /// Sound: for x > 0, F at x is G at y = ln(x), for x = exp(ln(x)), and ln(x) grows without bound. What holds for all great
    /// real numbers holds for the natural ones. y is no other name in F, and the limit mentions neither x nor y.
    pub(super) fn along(&mut self, goal: &Prop, from: &str) -> Result<(), Refusal> {
        let PropKind::Limit(limit) = &goal.kind else { return rejected(Reason::NotALimit) };
        let source = self.fact(from)?;
        let PropKind::Limit(other) = &source.kind else { return rejected(Reason::NotALimit) };
        let (x, y) = (&limit.variable.text, &other.variable.text);
        self.kind_of(x)?;
        if self.kind_of(y)? {
            return rejected(Reason::NotUnbounded);
        }
        let mentions = |e: &Expr, name: &str| {
            let mut names = std::collections::BTreeSet::new();
            super::names::names_in(e, &mut names);
            names.contains(name)
        };
        if key::expr(&limit.value) != key::expr(&other.value)
            || mentions(&limit.value, x)
            || mentions(&limit.value, y)
            || (x != y && mentions(&limit.of, y))
        {
            return rejected(Reason::OtherLimit);
        }
        let mut map = super::substitution::Substitution::default();
        map.replace(x, &super::statement::apply("exp", super::statement::name(y)));
        let expected = map.expr(&limit.of)?;
        if key::expr(&expected) != key::expr(&other.of) {
            return rejected(Reason::OtherLimit);
        }
        Ok(())
    }
}
