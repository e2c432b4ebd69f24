//! Limits, and the one analytic lemma.

use super::sign::Known;
use super::term::Atom;
use super::{Checker, Reason, Refusal, Variable, key, rejected};
use crate::claim::syntax::*;
use crate::kernel::analysis::weighted_mean;
use crate::kernel::fraction::Fraction;
use crate::kernel::order::Signs;
use crate::kernel::statement::{Substitution, compare, name, one_minus};

/// What an acceptance says where it rests on the analytic lemma.
pub(super) const LEMMA: &str = crate::kernel::analysis::LEMMA;

impl Checker {
    /// Rule `mean`: `a^(1 - p)*b^p <= (1 - p)*a + p*b` for a, b > 0 and 0 ≤ p ≤ 1; with `<` where a ≠ b and 0 < p < 1.
    ///
    /// Sound: ln is concave, strictly. This is the kernel's one analytic lemma; an acceptance that rests on it says so.
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
            let f = self.fraction(e)?;
            if !self.signs_of(&f, known)?.within(signs) {
                return rejected(Reason::NoValue { part: e.clone(), signs });
            }
        }
        if strict {
            let difference = self.fraction(&a)?.minus(&self.fraction(&b)?, &self.work)?;
            if !self.signs_of(&difference, known)?.within(Signs::NOT_ZERO) {
                return rejected(Reason::Needs(compare(a, Relation::NotEqual, b)));
            }
        }
        self.rests_on.insert(LEMMA.to_string());
        Ok(())
    }

    /// Whether a variable of the claim stands for natural numbers.
    fn kind_of(&self, variable: &str) -> Result<bool, Refusal> {
        match self.scope.iter().rev().find(|v| v.name == variable) {
            Some(v) if v.atom == Atom::Variable(variable.to_string()) => Ok(v.natural),
            _ => rejected(Reason::Undeclared(variable.to_string())),
        }
    }

    /// Rule `limit`: the limit of N/D, polynomials in the variable that grows, by degrees.
    ///
    /// The variable is another one here than outside: no fact says anything of it but that it is at least the numeral
    /// given as `from`.
    ///
    /// Sound: the expression has a value for every x ≥ `from`, all other variables stay as they are, and the
    /// coefficients do not depend on x. If the degree of D is the greater, N/D → 0; if they are equal, N/D tends to the
    /// quotient of the leading coefficients, that of D being shown not to be 0.
    pub(super) fn limit(&mut self, goal: &Prop, with: &[(Name, Expr)], known: &mut Known) -> Result<(), Refusal> {
        let PropKind::Limit(limit) = &goal.kind else { return rejected(Reason::NotALimit) };
        let variable = limit.variable.text.clone();
        let natural = self.kind_of(&variable)?;
        let atom = Atom::Variable(format!("{variable} that grows"));
        self.scope.push(Variable { name: variable, natural, atom: atom.clone() });
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
        if natural {
            self.learn_for_all(&atom, known)?;
        }
        self.defined(&limit.of, known)?;
        self.defined(&limit.value, known)?;
        let (f, value) = (self.fraction(&limit.of)?, self.fraction(&limit.value)?);
        let (top, bottom) = f.parts(&self.work)?;
        let (top, bottom) = (top.coefficients(place), bottom.coefficients(place));
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
        if top.keys().any(|k| k > degree) {
            return rejected(Reason::OtherLimit);
        }
        let quotient = match top.get(degree) {
            Some(c) => Fraction::of(c).times(&Fraction::of(lead).power(-1)?, &self.work)?,
            None => Fraction::integer(0),
        };
        let same = quotient.minus(&value, &self.work)?.is_zero();
        self.scope.pop();
        if same { Ok(()) } else { rejected(Reason::OtherLimit) }
    }

    /// Rule `squeeze`: the limit of F from `for all x >= N: A <= F`, `for all x >= N: F <= B` and the limits of A and B,
    /// all the same.
    ///
    /// Sound: from N on, a numeral, F lies between A and B.
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
                [Constraint::Relation(Relation::Greater | Relation::GreaterEqual, bound)] => {
                    matches!(bound.kind, ExprKind::Number(_))
                }
                _ => false,
            };
            // A bound for all real numbers holds for the natural ones.
            if !unbounded || (binding.natural && !natural) {
                return rejected(Reason::NotUnbounded);
            }
            let at = |e: &Expr| -> Result<Expr, Refusal> {
                let mut map = Substitution::default();
                map.replace(&limit.variable.text, &name(&variable.text));
                Ok(map.expr(e)?)
            };
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
}
