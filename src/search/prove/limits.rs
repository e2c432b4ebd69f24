//! Limits: by degrees, by asymptotic expansion (`asymptotic_limits`), or by a squeeze between bounds that fall like 1/(n + 1).

use super::facts::minus as difference;
use super::letters::{natural, product, whole_power};
use super::slopes::put_in;
use super::{Fail, Prover};
use crate::algebra::Polynomial;
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::kernel::names::names_in;
use crate::kernel::order::Signs;
use crate::kernel::statement::{apply, compare, expr, name, numeral, prop};
use crate::kernel::substitution::Substitution;
use crate::refute::literal::literal;
use malachite::Rational;
use std::collections::BTreeSet;

/// a + b.
pub(super) fn plus(a: &Expr, b: Expr) -> Expr {
    expr(ExprKind::Sum(vec![(Sign::Plus, a.clone()), (Sign::Plus, b)]))
}

/// a/b.
pub(super) fn over(a: Expr, b: Expr) -> Expr {
    expr(ExprKind::Product(vec![(Factor::Times, a), (Factor::Over, b)]))
}

/// How often an exponential is put in for what grows: for ln(ln(x)) twice.
const EXPONENTIALS: usize = 2;

/// Whether a name occurs in an expression.
pub(super) fn holds(e: &Expr, variable: &str) -> bool {
    let mut names = BTreeSet::new();
    names_in(e, &mut names);
    names.contains(variable)
}

/// Shows that one expression lies below another: for a name, the statement for all its values, and that for this one.
type ShowBound<'a> = dyn FnMut(&mut Prover, &Expr, &Prop, &Prop) -> Result<Label, Fail> + 'a;

impl Prover {
    /// Shows a limit.
    pub(crate) fn limit(&mut self, goal: &Prop, l: &Limit) -> Result<Label, Fail> {
        self.define(&l.value);
        let first = match self.limit_by_degrees(goal, l) {
            Ok(label) => return Ok(label),
            Err(first) => first,
        };
        if self.has_another_limit(l) {
            return Err(first);
        }
        if self.divisors_are_positive(l)
            && let Ok(label) = self.limit_from(1, goal)
        {
            return Ok(label);
        }
        if self.splits > 2 {
            return Err(first);
        }
        self.splits += 1;
        let done = self.squeezed(goal, l);
        self.splits -= 1;
        done.map_err(|_| first)
    }

    /// Whether an expansion tells a number as the limit, or that there is none, and another is claimed.
    fn has_another_limit(&mut self, l: &Limit) -> bool {
        let Some((power, c)) = self.first_term(&l.of, &l.variable.text) else { return false };
        let distance = match power {
            ..0 => return self.letters.number(&c).is_some_and(|q| q != 0),
            0 => difference(&c, &l.value),
            1.. => l.value.clone(),
        };
        self.letters.number(&distance).is_some_and(|q| q != 0)
    }

    /// By rule `limit`, if need be after the sign of the leading coefficient of the divisor.
    pub(super) fn limit_by_degrees(&mut self, goal: &Prop, l: &Limit) -> Result<Label, Fail> {
        self.emit(Rule::Limit { with: Vec::new() }, goal.clone()).or_else(|first| {
            // From 1 on 1/x has a value, from 4 on 1/(1 − 1/x) as well.
            let seen = self.limit_from(1, goal).or_else(|_| self.limit_from(4, goal));
            let seen = seen.or_else(|fail| if self.lead_is_not_zero(l) { self.limit_from(1, goal) } else { Err(fail) });
            seen.map_err(|_| first)
        })
    }

    /// By rule `limit`, the expression having a value from a numeral on.
    fn limit_from(&mut self, least: u32, goal: &Prop) -> Result<Label, Fail> {
        let with = vec![(Name::new("from"), numeral(least))];
        self.emit(Rule::Limit { with }, goal.clone())
    }

    /// Proves that the divisors whose signs are open are positive from 1 on. Returns whether that is a new fact.
    fn divisors_are_positive(&mut self, l: &Limit) -> bool {
        let k = self.fresh("k");
        let binding = self.growing_from(&numeral(1), l, &k);
        let mut map = Substitution::default();
        map.replace(&l.variable.text, &name(&k));
        let mut divisors = Vec::new();
        divisors_in(&l.of, &mut divisors);
        let mut is_new = false;
        // A sine that moves is positive near some places only.
        for d in divisors.iter().filter(|d| holds(d, &l.variable.text) && !turns(d, &l.variable.text)) {
            let Ok(divisor) = map.expr(d) else { continue };
            let positive = compare(divisor, Relation::Greater, numeral(0));
            let every = prop(PropKind::ForAll(vec![binding.clone()], Box::new(positive.clone())));
            is_new |= self.attempt(|c| c.block(&every, |c, _| c.without_cases(&positive))).is_ok();
        }
        is_new
    }

    /// Proves that the leading coefficient of the divisor, multiplied out as the kernel does, is not 0. Returns whether that
    /// is a new fact.
    fn lead_is_not_zero(&mut self, l: &Limit) -> bool {
        let Some(reading) = self.read(&l.of, false) else { return false };
        let mut lead = Polynomial::one();
        for f in reading.factors.iter().filter(|f| f.power < 0) {
            let own = self.by_degrees(&f.poly, &l.variable.text).and_then(|mut own| own.pop_last());
            let Some((_, own)) = own else { return false };
            let Ok(power) = u32::try_from(-f.power) else { return false };
            let Some(product) = own.pow(power).ok().and_then(|p| lead.try_mul(&p).ok()) else { return false };
            lead = product;
        }
        let lead = self.letters.written(&lead);
        if self.signs_of(&lead).within(Signs::NOT_ZERO) {
            return false;
        }
        [Relation::Greater, Relation::Less]
            .into_iter()
            .any(|relation| self.quietly(&compare(lead.clone(), relation, numeral(0))).is_ok())
    }

    /// A limit of what holds ln(x), with exp(y) in the place of x: logarithms grow more slowly than all powers, but y does not.
    fn along_an_exponential(&mut self, goal: &Prop, l: &Limit) -> Result<Label, Fail> {
        let x = &l.variable.text;
        if self.exponentials >= EXPONENTIALS || !has_logarithm_of(&l.of, x) {
            return Err(Fail::No("a logarithm of what grows"));
        }
        self.exponentials += 1;
        let shown = self.attempt(|c| {
            if !c.is_whole(&name(x)) {
                return c.along(goal, l, l.variable.clone());
            }
            let y = Name::new(c.fresh("y"));
            let every = prop(PropKind::ForAll(vec![Binding::of(y.clone(), false, Vec::new())], Box::new(goal.clone())));
            let every = c.block(&every, |c, _| c.along(goal, l, y.clone()))?;
            let here = vec![(y, numeral(0))];
            c.emit(Rule::Instance { source: every, with: here, from: Vec::new() }, goal.clone())
        });
        self.exponentials -= 1;
        shown
    }

    /// By rule `along`, from the limit as y grows.
    fn along(&mut self, goal: &Prop, l: &Limit, y: Name) -> Result<Label, Fail> {
        let of = put_in(&l.of, &l.variable.text, &apply("exp", name(&y.text)))?;
        let other = Limit { of, variable: y, value: l.value.clone() };
        let from = self.limit(&prop(PropKind::Limit(Box::new(other.clone()))), &other)?;
        self.emit(Rule::Along { from }, goal.clone())
    }

    fn squeezed(&mut self, goal: &Prop, l: &Limit) -> Result<Label, Fail> {
        let n = name(&l.variable.text);
        let closed = super::integrals::with_values_of_integrals(&l.of);
        if closed != l.of
            && let Ok(label) = self.attempt(|c| c.between(goal, l, (&closed, &closed), &[], 1))
        {
            return Ok(label);
        }
        if let Ok(label) = self.attempt(|c| c.by_closed_sums(goal, l)) {
            return Ok(label);
        }
        if let Ok(label) = self.on_its_own(|c| c.by_a_growing_sum(goal, l)) {
            return Ok(label);
        }
        if let Ok(label) = self.attempt(|c| c.by_closed_members(goal, l)) {
            return Ok(label);
        }
        if let Ok(label) = self.with_half_of_the_time(|c| c.by_contraction(goal, l)) {
            return Ok(label);
        }
        if let Ok(label) = self.with_half_of_the_time(|c| c.by_expansion(goal, l)) {
            return Ok(label);
        }
        if let Ok(label) = self.on_its_own(|c| c.along_an_exponential(goal, l)) {
            return Ok(label);
        }
        if let Ok(label) = self.on_its_own(|c| c.within_falling_bounds(goal, l)) {
            return Ok(label);
        }
        if let Ok(label) = self.on_its_own(|c| c.by_ratios(goal, l)) {
            return Ok(label);
        }
        if let Ok(label) = self.attempt(|c| c.by_absolute_value(goal, l)) {
            return Ok(label);
        }
        if let Ok(label) = self.attempt(|c| c.by_signs_of_a_parameter(goal, l)) {
            return Ok(label);
        }
        let next = plus(&n, numeral(1));
        let falling = |k: u32| over(numeral(k), next.clone());
        let minus = |k: u32| expr(ExprKind::Sum(vec![(Sign::Plus, l.value.clone()), (Sign::Minus, falling(k))]));
        let above = |k: u32| plus(&l.value, falling(k));
        // From 4 on a power of 2 is at least a square.
        for (lower, upper, least) in [
            (l.value.clone(), above(1), 1),
            (minus(1), l.value.clone(), 1),
            (l.value.clone(), above(4), 1),
            (minus(4), l.value.clone(), 1),
            (l.value.clone(), above(4), 4),
            (minus(4), l.value.clone(), 4),
        ] {
            if let Ok(label) = self.attempt(|c| c.between(goal, l, (&lower, &upper), &[], least)) {
                return Ok(label);
            }
        }
        Err(Fail::No("a squeeze"))
    }

    /// The limit is the first term of an expansion in powers of 1/x: the expression lies within C/x of it.
    fn within_falling_bounds(&mut self, goal: &Prop, l: &Limit) -> Result<Label, Fail> {
        let no = || Fail::No("an expansion with this limit");
        let plan = self.expansion(&l.of, &l.variable.text, 1).ok_or_else(no)?;
        let terms = plan.nodes.last().map(|root| root.terms.clone()).unwrap_or_default();
        if terms.keys().any(|k| *k < 0) {
            return Err(no());
        }
        let value = terms.get(&0).cloned().unwrap_or(numeral(0));
        let same = match self.is_zero(&difference(&value, &l.value)) {
            true => None,
            false => {
                let same = compare(value, Relation::Equal, l.value.clone());
                Some(self.emit(Rule::Power, same.clone()).or_else(|_| self.without_cases(&same))?)
            }
        };
        let left = self.remainder_of(&plan, 1)?;
        let falling = over(left.bound.clone(), name(&l.variable.text));
        let (lower, upper) = (difference(&l.value, &falling), plus(&l.value, falling));
        let mut sides = [-1, 1].into_iter();
        self.squeeze(goal, l, [&lower, &upper], &left.start, &mut |c, k, every, body| {
            let sign = sides.next().ok_or_else(no)?;
            c.block(every, |c, _| {
                let far = compare(k.clone(), Relation::GreaterEqual, left.start.clone());
                let far = c.known(&far).ok_or_else(no)?;
                let below = product(vec![
                    literal(&Rational::from(-1)),
                    over(numeral(1), product(vec![k.clone(), left.start.clone()])),
                ]);
                let (_, [low, high]) = c.remainder_at(&left, k, &Term { facts: vec![far], factor: below })?;
                let near = if sign < 0 { low } else { high };
                let mut terms = vec![Term { facts: vec![near], factor: over(numeral(1), k.clone()) }];
                let factor = literal(&Rational::from(sign));
                terms.extend(same.iter().map(|same| Term { facts: vec![same.clone()], factor: factor.clone() }));
                c.combination(body.clone(), terms)
            })
        })
    }

    /// Proves the limit after replacing sums by closed forms, or by what the integral test puts below and above them.
    fn by_closed_sums(&mut self, goal: &Prop, l: &Limit) -> Result<Label, Fail> {
        if let Ok((closed, facts)) = self.with_closed_sums(&l.of, &l.variable.text) {
            return self.between(goal, l, (&closed, &closed), &facts, 1);
        }
        let ([lower, upper], facts) = self.between_integrals(&l.of, &l.variable.text)?;
        // At 1 a logarithm is 0, and may divide.
        let mut from = |least| self.attempt(|c| c.between(goal, l, (&lower, &upper), &facts, least));
        from(1).or_else(|_| from(2))
    }

    /// r^n → 0 for r between −1 and 1: it lies between −q^n and q^n for q = (1 + r²)/2, which is at least |r| and less than 1.
    fn by_absolute_value(&mut self, goal: &Prop, l: &Limit) -> Result<Label, Fail> {
        let no = || Fail::No("a power of what is between -1 and 1");
        let (r, n) = super::letters::as_power(&l.of).ok_or_else(no)?;
        if natural(&l.value) != Some(0) || !matches!(&n.kind, ExprKind::Name(n) if *n == l.variable.text) {
            return Err(no());
        }
        // The mean gets a name, so that its powers are powers of one letter.
        let mean = over(plus(&numeral(1), whole_power(r.clone(), 2)), numeral(2));
        let q = name(&self.fresh("q"));
        let named = compare(mean, Relation::Equal, q.clone());
        let label = self.emit(Rule::Name, named.clone())?;
        self.take_in(&label, &named)?;
        for bound in [compare(q.clone(), Relation::Greater, numeral(0)), compare(q.clone(), Relation::Less, numeral(1))]
        {
            self.show(&bound)?;
        }
        let k = self.fresh("k");
        let power = |base: &Expr, at: &Expr| expr(ExprKind::Power(Box::new(base.clone()), Box::new(at.clone())));
        let minus = |e: Expr| expr(ExprKind::Negate(Box::new(e)));
        let upper = power(&q, &n);
        let lower = minus(upper.clone());
        let inside = prop(PropKind::Compare(
            vec![minus(power(&q, &name(&k))), power(&r, &name(&k)), power(&q, &name(&k))],
            vec![Relation::LessEqual; 2],
        ));
        let every = prop(PropKind::ForAll(vec![Binding::of(Name::new(&k), true, Vec::new())], Box::new(inside)));
        let splits = std::mem::replace(&mut self.splits, 0);
        let shown = self.all_by_induction(&every, 0);
        self.splits = splits;
        self.between(goal, l, (&lower, &upper), &[shown?], 1)
    }

    /// `k >= least`, of the kind of the variable that grows.
    pub(crate) fn growing_from(&self, least: &Expr, l: &Limit, k: &str) -> Binding {
        let bound = (natural(least) != Some(0)).then(|| Constraint::Relation(Relation::GreaterEqual, least.clone()));
        Binding::of(Name::new(k), self.naturals.contains(&l.variable.text), Vec::from_iter(bound))
    }

    /// A limit between two expressions with the same limit, as the facts tell for every value from `least` on.
    pub(crate) fn between(
        &mut self,
        goal: &Prop,
        l: &Limit,
        (lower, upper): (&Expr, &Expr),
        facts: &[Label],
        least: u32,
    ) -> Result<Label, Fail> {
        // A closed form is shown by induction; other bounds are shown at once or not at all.
        let effort = if lower == upper { 0 } else { 2 };
        self.between_by(goal, l, (lower, upper), facts, least, effort)
    }

    /// The same, with this number of cases as already distinguished.
    pub(crate) fn between_by(
        &mut self,
        goal: &Prop,
        l: &Limit,
        (lower, upper): (&Expr, &Expr),
        facts: &[Label],
        least: u32,
        effort: usize,
    ) -> Result<Label, Fail> {
        self.squeeze(goal, l, [lower, upper], &numeral(least), &mut |c, k, every, body| {
            let splits = std::mem::replace(&mut c.splits, effort);
            let shown = if facts.is_empty() {
                c.show(every)
            } else {
                c.block(every, |c, _| {
                    for fact in facts {
                        let here = c.instance(fact, k)?;
                        c.put_in(&here);
                    }
                    c.show(body)
                })
            };
            c.splits = splits;
            shown
        })
    }

    /// A limit between two expressions with the same limit, as `shown` shows for every value from `least` on.
    pub(super) fn squeeze(
        &mut self,
        goal: &Prop,
        l: &Limit,
        [lower, upper]: [&Expr; 2],
        least: &Expr,
        shown: &mut ShowBound<'_>,
    ) -> Result<Label, Fail> {
        let k = self.fresh("k");
        let binding = self.growing_from(least, l, &k);
        let k = name(&k);
        let mut limits = Vec::new();
        for bound in [lower, upper] {
            let same = prop(PropKind::Limit(Box::new(Limit { of: bound.clone(), ..l.clone() })));
            limits.push(self.show(&same)?);
        }
        let mut from = Vec::new();
        for (a, b) in [(lower, &l.of), (&l.of, upper)] {
            let body = super::put(&compare(a.clone(), Relation::LessEqual, b.clone()), &l.variable.text, &k)?;
            let every = prop(PropKind::ForAll(vec![binding.clone()], Box::new(body.clone())));
            from.push(shown(self, &k, &every, &body)?);
        }
        from.extend(limits);
        self.emit(Rule::Squeeze { from }, goal.clone())
    }
}

/// What an expression divides by.
fn divisors_in(e: &Expr, out: &mut Vec<Expr>) {
    if let ExprKind::Product(list) = &e.kind {
        out.extend(list.iter().filter(|f| f.0 == Factor::Over).map(|f| f.1.clone()));
    }
    crate::refute::expand::parts(e, &mut |part| divisors_in(part, out));
}

/// Whether a sine or cosine of what holds a variable stands in an expression.
pub(crate) fn turns(e: &Expr, x: &str) -> bool {
    let mut found = matches!(&e.kind, ExprKind::Apply(f, list)
        if matches!(f.text.as_str(), "sin" | "cos") && list.iter().any(|e| holds(e, x)));
    crate::refute::expand::parts(e, &mut |part| found |= turns(part, x));
    found
}

/// Whether the logarithm of something in which a variable stands occurs.
fn has_logarithm_of(e: &Expr, x: &str) -> bool {
    if matches!(&e.kind, ExprKind::Apply(f, list) if f.text == "ln" && list.iter().any(|u| holds(u, x))) {
        return true;
    }
    let mut found = false;
    crate::claim::walk::parts(e, &mut |part| found |= has_logarithm_of(part, x));
    found
}
