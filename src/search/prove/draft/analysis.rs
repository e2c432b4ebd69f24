//! The rules about powers, recurrences, extrema and limits, and the one analytic lemma.

use super::step::Step;
use super::translate::Atom;
use super::{Draft, Failure, Power, Replaced, rejected};
use crate::claim::syntax::*;
use crate::kernel::analysis::{at_the_point, weighted_mean};
use crate::kernel::fraction::Fraction;
use crate::kernel::names::{names_in_binding, names_in_prop};
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, domain, expr, numeral, one_minus, power, product, prop, sum};
use crate::kernel::substitution::Substitution;
use crate::kernel::text;
use std::collections::BTreeSet;

impl Draft {
    /// The logarithm of an expression, which is shown to be positive: of a power b^E it is E·ln b, so
    /// that it exists before the power is introduced.
    pub(crate) fn log(&mut self, e: &Expr) -> Result<Fraction, Failure> {
        let part = |k: i64| Fraction::integer(k).power(-1);
        match &e.kind {
            ExprKind::Power(base, exponent) => {
                let exponent = self.scalar(exponent)?;
                let base = self.scalar(base)?;
                Ok(exponent.times(&self.logarithm_of(&base)?, &self.work)?)
            }
            ExprKind::Apply(f, arguments) if !self.is_declared(&f.text) => {
                let [argument] = arguments.as_slice() else {
                    return rejected("a function of one argument is given several");
                };
                let x = self.scalar(argument)?;
                match f.text.as_str() {
                    "sqrt" => Ok(self.logarithm_of(&x)?.times(&part(2)?, &self.work)?),
                    "cbrt" => Ok(self.logarithm_of(&x)?.times(&part(3)?, &self.work)?),
                    "exp" => Ok(x),
                    _ => rejected("rule `power` is about powers, roots and exponentials"),
                }
            }
            _ => rejected("rule `power` is about powers, roots and exponentials"),
        }
    }

    /// Rule `power`: `b^E = R` introduces the power b^E, written as R in powers introduced before; with
    /// b^E on both sides it becomes an atom of its own. Exponentials and roots are powers.
    ///
    /// Sound: b > 0 is shown, so b^E = exp L with L = E·ln b. If ln R = L, with R > 0, then R = exp L,
    /// for exp and ln are inverse to each other. Logarithms are sums over the positive factors.
    pub(super) fn power(&mut self, step: &Step) -> Result<(), Failure> {
        let goal = Self::shown(step)?;
        let PropKind::Compare(sides, relations) = &goal.kind else { return rejected("an equation is needed") };
        let ([left, right], [Relation::Equal]) = (sides.as_slice(), relations.as_slice()) else {
            return rejected("an equation is needed");
        };
        let log = self.log(left)?;
        let value = if left == right {
            Fraction::atom(self.intern(Atom::Exponential(log.clone())))
        } else {
            let value = self.scalar(right)?;
            let other = self.logarithm_of(&value)?;
            if !log.minus(&other, &self.work)?.is_zero() {
                return rejected("the logarithms of the two sides differ");
            }
            value
        };
        self.powers.push(Power { log, value, source: self.now });
        self.know(&step.label, goal.clone())
    }

    /// Rule `logarithm`: `A = B` for positive A and B with ln A = ln B.
    ///
    /// Sound: ln is one to one. Both sides are translated, so they have values.
    pub(super) fn logarithm(&mut self, step: &Step) -> Result<(), Failure> {
        let goal = Self::shown(step)?;
        let PropKind::Compare(sides, relations) = &goal.kind else { return rejected("an equation is needed") };
        let ([left, right], [Relation::Equal]) = (sides.as_slice(), relations.as_slice()) else {
            return rejected("an equation is needed");
        };
        let (a, b) = (self.scalar(left)?, self.scalar(right)?);
        let (a, b) = (self.logarithm_of(&a)?, self.logarithm_of(&b)?);
        if !a.minus(&b, &self.work)?.is_zero() {
            return rejected("the logarithms of the two sides differ");
        }
        self.know(&step.label, goal.clone())
    }

    /// Rule `replace`: from here on the left side of an equation, which must be an atom, is written as
    /// the right side.
    ///
    /// Sound: they are equal at every point that the facts allow, so a fraction keeps its value.
    pub(super) fn replace(&mut self, step: &Step) -> Result<(), Failure> {
        let fact = self.cited_fact(step)?;
        let PropKind::Compare(sides, relations) = &fact.kind else { return rejected("an equation is needed") };
        let ([left, right], [Relation::Equal]) = (sides.as_slice(), relations.as_slice()) else {
            return rejected("an equation is needed");
        };
        let value = self.scalar(right)?;
        if let ExprKind::Name(variable) = &left.kind
            && self.variable(variable).is_some()
        {
            // A variable may be replaced again.
            let atom = self.intern(Atom::Variable(variable.clone()));
            self.replaced.push(Replaced { atom, value, source: Some(self.now) });
            return Ok(());
        }
        let left = self.scalar(left)?;
        let mut factors = left.factors.iter();
        let single = match (factors.next(), factors.next()) {
            (Some((poly, 1)), None)
                if left.as_number().is_none() && left.coefficient == Fraction::integer(1).coefficient =>
            {
                poly.single_atom()
            }
            _ => None,
        };
        let Some(atom) = single else { return rejected("the left side is not an atom") };
        self.replaced.push(Replaced { atom, value, source: Some(self.now) });
        Ok(())
    }

    /// Rule `unfold`: `u(0) = …` and `u(t + 1) = …` of a sequence; a sum or product over `a..b` equal to
    /// one over `a..b − 1` and its last member, or one over `a + 1..b` and its first, or, where
    /// b = a − 1, to 0 or 1.
    ///
    /// Sound: by definition. The ranges on both sides are shown to be ranges when they are translated.
    pub(super) fn unfold(&mut self, step: &Step) -> Result<(), Failure> {
        let goal = Self::shown(step)?;
        let PropKind::Compare(sides, relations) = &goal.kind else { return rejected("an equation is needed") };
        let ([left, right], [Relation::Equal]) = (sides.as_slice(), relations.as_slice()) else {
            return rejected("an equation is needed");
        };
        let statement = self.statement.clone();
        let expected = match &left.kind {
            ExprKind::Apply(function, arguments) => {
                let Some(u) = statement.sequences.iter().find(|s| s.name == function.text) else {
                    return rejected(&format!("{} is not a sequence", function.text));
                };
                let [index] = arguments.as_slice() else { return rejected("a sequence has one index") };
                let f = self.scalar(index)?;
                self.natural(&f)?;
                if f.is_zero() {
                    u.initial.clone()
                } else {
                    // u(t) = step at t − 1, which must be a natural number.
                    let before = sum(vec![(Sign::Plus, index.clone()), (Sign::Minus, numeral(1))]);
                    let f = self.scalar(&before)?;
                    self.natural(&f)?;
                    let mut map = Substitution::default();
                    map.replace(&u.index, &before);
                    map.expr(&u.step)?
                }
            }
            ExprKind::SumOver(index, body) | ExprKind::ProductOver(index, body) => {
                let is_sum = matches!(left.kind, ExprKind::SumOver(..));
                let over = |index: Index| {
                    let body = body.clone();
                    expr(if is_sum { ExprKind::SumOver(index, body) } else { ExprKind::ProductOver(index, body) })
                };
                let with = |rest: Expr, at: &Expr| -> Result<Expr, Failure> {
                    let mut map = Substitution::default();
                    map.replace(&index.name.text, at);
                    let one = map.expr(body)?;
                    Ok(if is_sum { sum(vec![(Sign::Plus, rest), (Sign::Plus, one)]) } else { product(vec![rest, one]) })
                };
                let shorter = sum(vec![(Sign::Plus, (*index.to).clone()), (Sign::Minus, numeral(1))]);
                let later = sum(vec![(Sign::Plus, (*index.from).clone()), (Sign::Plus, numeral(1))]);
                let last = with(over(Index { to: Box::new(shorter), ..index.clone() }), &index.to)?;
                let first = with(over(Index { from: Box::new(later), ..index.clone() }), &index.from)?;
                let ends = self.scalar(&sum(vec![
                    (Sign::Plus, (*index.to).clone()),
                    (Sign::Plus, numeral(1)),
                    (Sign::Minus, (*index.from).clone()),
                ]))?;
                if ends.is_zero() {
                    numeral(u32::from(!is_sum))
                } else {
                    let value = self.scalar(right)?;
                    let matches = |checker: &mut Draft, e: &Expr| -> Result<bool, Failure> {
                        let other = checker.scalar(e)?;
                        Ok(other.minus(&value, &checker.work)?.is_zero())
                    };
                    // What is tried in vain is not used.
                    let used = self.used.clone();
                    if matches(self, &last).unwrap_or(false) {
                        last
                    } else {
                        self.used = used;
                        first
                    }
                }
            }
            _ => return rejected("a member of a sequence, a sum or a product is needed"),
        };
        self.scalar(left)?;
        let (a, b) = (self.scalar(right)?, self.scalar(&expected)?);
        if !a.minus(&b, &self.work)?.is_zero() {
            return rejected("this is not what the definition says");
        }
        self.know(&step.label, goal.clone())
    }

    /// Rule `monotone`: `A^E relation B^E` from `A relation B` between positive values and E > 0.
    ///
    /// Sound: x ↦ x^E = exp(E·ln x) rises strictly on x > 0 if E > 0, so it keeps every relation, `!=`
    /// among them; positive bases give values.
    pub(super) fn monotone(&mut self, step: &Step) -> Result<(), Failure> {
        let goal = Self::shown(step)?;
        let fact = self.cited_fact(step)?;
        let PropKind::Compare(sides, relations) = &fact.kind else { return rejected("a comparison is needed") };
        let ([a, b], [relation]) = (sides.as_slice(), relations.as_slice()) else {
            return rejected("a single comparison is needed");
        };
        let [(_, exponent)] = step.with.as_slice() else { return rejected("one exponent is needed") };
        for e in [a, b, exponent] {
            let f = self.scalar(e)?;
            if !self.signs_of(&f)?.within(Signs::POSITIVE) {
                return rejected(&format!("{} is not shown to be positive", text::expr(e)));
            }
        }
        let shown = compare(power(a, exponent), *relation, power(b, exponent));
        if text::prop(&shown) != text::prop(goal) {
            return rejected("this is not the fact with both sides to that power");
        }
        self.know(&step.label, goal.clone())
    }

    /// Rule `mean`: `a^(1 - p)*b^p <= (1 - p)*a + p*b` for a, b > 0 and 0 ≤ p ≤ 1; with `<` where
    /// a ≠ b and 0 < p < 1.
    ///
    /// Sound: ln is concave, strictly. This is the kernel's one analytic lemma; an acceptance that
    /// rests on it says so. (From exp s ≥ 1 + s: sum the bounds of a/M and b/M by their logarithms, M the
    /// right side.)
    pub(super) fn mean(&mut self, step: &Step) -> Result<(), Failure> {
        let goal = Self::shown(step)?;
        let find = |name: &str| match step.with.iter().find(|w| w.0.text == name) {
            Some((_, value)) => Ok(value.clone()),
            None => rejected(&format!("a value for {name} is needed")),
        };
        if step.with.len() != 3 {
            return rejected("values for a, b and p are needed");
        }
        let (a, b, p) = (find("a")?, find("b")?, find("p")?);
        let key = text::prop(goal);
        let strict = key == text::prop(&weighted_mean(&a, &b, &p, Relation::Less));
        if !strict && key != text::prop(&weighted_mean(&a, &b, &p, Relation::LessEqual)) {
            return rejected("this is not the weighted mean inequality of these values");
        }
        let rest = one_minus(&p);
        let weight = if strict { Signs::POSITIVE } else { Signs::NOT_NEGATIVE };
        for (e, wanted) in [(&a, Signs::POSITIVE), (&b, Signs::POSITIVE), (&p, weight), (&rest, weight)] {
            let f = self.scalar(e)?;
            if !self.signs_of(&f)?.within(wanted) {
                return rejected(&format!("{} is not shown to have the right sign", text::expr(e)));
            }
        }
        if strict {
            let (x, y) = (self.scalar(&a)?, self.scalar(&b)?);
            let difference = x.minus(&y, &self.work)?;
            if !self.signs_of(&difference)?.within(Signs::NOT_ZERO) {
                return rejected("the two values are not shown to differ");
            }
        }
        self.know(&step.label, goal.clone())?;
        Ok(())
    }

    /// Rule `extremum`: from the domain at the point, the value there, and `for all x …: F <= value`
    /// (>= for a minimum); with `only`, also `for all x …: F = value => x = A` (`and y = B` …).
    ///
    /// Sound: that is the definition of a global extremum that is attained.
    pub(super) fn extremum(&mut self, step: &Step) -> Result<(), Failure> {
        let goal = Self::shown(step)?;
        let PropKind::Extremum(e) = &goal.kind else { return rejected("an extremum is needed") };
        let mut at = Substitution::default();
        let names: BTreeSet<&str> = e.at.iter().map(|a| a.0.text.as_str()).collect();
        for (variable, value) in &e.at {
            at.replace(&variable.text, value);
        }
        for binding in &e.over {
            if binding.natural || binding.names.iter().any(|n| n.1.is_some() || !names.contains(n.0.text.as_str())) {
                return rejected("an extremum is over real variables, with a value for each");
            }
        }
        for fact in e.over.iter().flat_map(domain) {
            self.need(&at.prop(&fact)?)?;
        }
        self.need(&compare(at.expr(&e.of)?, Relation::Equal, e.value.clone()))?;
        let mut free = BTreeSet::new();
        crate::kernel::names::names_in(&e.value, &mut free);
        e.at.iter().for_each(|a| crate::kernel::names::names_in(&a.1, &mut free));
        if names.iter().any(|n| free.contains(*n)) {
            return rejected("the value and the point stand outside the scope of the variables");
        }
        let every = |body: Prop| prop(PropKind::ForAll(e.over.clone(), Box::new(body)));
        let relation = if e.maximum { Relation::LessEqual } else { Relation::GreaterEqual };
        self.need(&every(compare(e.of.clone(), relation, e.value.clone())))?;
        if e.unique {
            let Some(there) = at_the_point(e) else { return rejected("an extremum has a point") };
            let equal = compare(e.of.clone(), Relation::Equal, e.value.clone());
            self.need(&every(prop(PropKind::Implies(Box::new(equal), Box::new(there)))))?;
        }
        self.know(&step.label, goal.clone())
    }

    /// A variable is free to grow if every hypothesis and supposition about it is a lower bound by a
    /// numeral, and no family or sequence depends on it: their members then stay as they are.
    fn unbounded(&self, variable: &str) -> Result<(), Failure> {
        for u in &self.statement.sequences {
            let mut names = BTreeSet::new();
            crate::kernel::names::names_in(&u.step, &mut names);
            names.remove(&u.index);
            crate::kernel::names::names_in(&u.initial, &mut names);
            if names.contains(variable) {
                return rejected(&format!("the sequence {} depends on {variable}", u.name));
            }
        }
        self.work.count(self.statement.bindings.len() + self.blocks.len())?;
        let opened = self.blocks.iter().flat_map(|b| match &b.goal.kind {
            PropKind::ForAll(bindings, _) => bindings.clone(),
            _ => Vec::new(),
        });
        let bindings: Vec<Binding> = self.statement.bindings.iter().cloned().chain(opened).collect();
        let suppositions = self.blocks.iter().filter_map(|b| match &b.goal.kind {
            PropKind::Implies(p, _) => Some(&**p),
            _ => None,
        });
        let lower = |p: &Prop| match &p.kind {
            PropKind::Compare(sides, relations) => match (sides.as_slice(), relations.as_slice()) {
                ([left, right], [Relation::Greater | Relation::GreaterEqual]) => {
                    matches!(&left.kind, ExprKind::Name(n) if n == variable)
                        && matches!(right.kind, ExprKind::Number(_))
                }
                _ => false,
            },
            _ => false,
        };
        let mut props: Vec<Prop> = self.statement.assumptions.iter().chain(suppositions).cloned().collect();
        for binding in &bindings {
            let mut names = BTreeSet::new();
            names_in_binding(binding, &mut names);
            if binding.names.iter().any(|n| n.1.is_some()) && names.contains(variable) {
                return rejected(&format!("a family depends on {variable}"));
            }
            props.extend(domain(binding));
        }
        for p in &props {
            let mut names = BTreeSet::new();
            names_in_prop(p, &mut names);
            if names.contains(variable) && !lower(p) {
                return rejected(&format!("{variable} is not free to grow: {}", text::prop(p)));
            }
        }
        Ok(())
    }

    /// Rule `limit`: the limit of N/D, polynomials in a variable that is free to grow, by degrees.
    ///
    /// Sound: all other variables stay as they are while x grows. The coefficients do not depend on x.
    /// If the degree of D is the greater, N/D → 0; if they are equal, N/D tends to the quotient of the
    /// leading coefficients, that of D being shown not to be 0. The expression has a value for every x.
    pub(super) fn limit(&mut self, step: &Step) -> Result<(), Failure> {
        let goal = Self::shown(step)?;
        let PropKind::Limit(limit) = &goal.kind else { return rejected("a limit is needed") };
        let variable = limit.variable.text.clone();
        if self.variable(&variable).is_none() {
            return rejected(&format!("{variable} is not declared here"));
        }
        self.unbounded(&variable)?;
        let atom = self.intern(Atom::Variable(variable.clone()));
        if self.replaced.iter().any(|r| r.atom == atom) {
            return rejected("the variable that grows is replaced");
        }
        let (f, value) = (self.scalar(&limit.of)?, self.scalar(&limit.value)?);
        let (top, bottom) = f.parts(&self.work)?;
        let (top, bottom) = (top.coefficients(atom), bottom.coefficients(atom));
        for poly in top.values().chain(bottom.values()) {
            if !self.is_free_of(&Fraction::of(poly), &variable)? {
                return rejected("a coefficient depends on the variable that grows");
            }
        }
        if !self.is_free_of(&value, &variable)? {
            return rejected("the limit depends on the variable that grows");
        }
        let Some((degree, lead)) = bottom.iter().next_back() else { return rejected("a division by 0") };
        if !self.poly_is_not_zero(lead)? {
            return rejected("the leading coefficient of the denominator may be 0");
        }
        if top.keys().any(|k| k > degree) {
            return rejected("the numerator has the greater degree");
        }
        let quotient = match top.get(degree) {
            Some(c) => Fraction::of(c).times(&Fraction::of(lead).power(-1)?, &self.work)?,
            None => Fraction::integer(0),
        };
        if !quotient.minus(&value, &self.work)?.is_zero() {
            return rejected("the limit is another");
        }
        self.know(&step.label, goal.clone())
    }

    fn poly_is_not_zero(&self, poly: &crate::kernel::fraction::Poly) -> Result<bool, Failure> {
        Ok(self.signs_of(&Fraction::of(poly))?.within(Signs::NOT_ZERO))
    }

    /// Rule `squeeze`: the limit of F from `A <= F`, `F <= B` and the limits of A and B, all the same.
    ///
    /// Sound: the comparisons hold for every value of the variable that the hypotheses allow, and it is
    /// free to grow.
    pub(super) fn squeeze(&mut self, step: &Step) -> Result<(), Failure> {
        let goal = Self::shown(step)?;
        let PropKind::Limit(limit) = &goal.kind else { return rejected("a limit is needed") };
        let (Some(lower), Some(upper), 2) = (
            step.with.iter().find(|w| w.0.text == "lower").map(|w| &w.1),
            step.with.iter().find(|w| w.0.text == "upper").map(|w| &w.1),
            step.with.len(),
        ) else {
            return rejected("values for lower and upper are needed");
        };
        self.unbounded(&limit.variable.text)?;
        self.need(&compare(lower.clone(), Relation::LessEqual, limit.of.clone()))?;
        self.need(&compare(limit.of.clone(), Relation::LessEqual, upper.clone()))?;
        for bound in [lower, upper] {
            let same = Limit { of: bound.clone(), ..(**limit).clone() };
            self.need(&prop(PropKind::Limit(Box::new(same))))?;
        }
        self.know(&step.label, goal.clone())
    }
}
