//! Orders of terms whose quotient with the next is known, by induction: n! >= n^n·exp(-n), binomial(2*n, n) >= 4^n/(2*sqrt(n)).
//!
//! Method: with Q the quotient of the sides, the goal says Q(n) <= 1, and Q(n + 1) = R(n)·Q(n). R multiplies what each factor of Q
//! grows by: products over an index, factorials, powers, exponentials, roots and polynomials. So R(n) <= 1 is the step. In R a power
//! b^e may be left whose base and exponent both hold n, as ((n + 1)/n)^n. It is written below, and is at least 1 + m·(b - 1) or
//! exp(m·(1 - 1/b)) times b^(e - m), for some m near e.
//!
//! Where R <= 1 from a later number on alone, as (n + 1)^3 <= 3·n^3, what is before it is computed.
//!
//! Limits: [`SHIFTS`], [`POWER`], [`POWERS`], [`NAMES`], [`LATER`].

use super::comparison::single;
use super::facts::negated;
use super::letters::{as_power, natural, product, whole_power};
use super::limits::{holds, over, plus};
use super::sums::Quotient;
use super::{Fail, Prover, implies};
use crate::algebra::Polynomial;
use crate::algebra::gcd::gcd;
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::kernel::statement::{apply, compare, expr, name, numeral, power, prop};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Abs;

/// How far the exponent m of a bound is from that of the power.
const SHIFTS: [i64; 3] = [0, 1, -1];

/// The most powers in a goal that are bounded.
const POWERS: usize = 2;

/// The most variables of a goal in which powers are bounded.
const NAMES: usize = 1;

/// Up to where the growth of a term is tried number by number.
const LATER: u32 = 12;

/// Where besides it is tried.
const FAR: [u32; 5] = [LATER, 17, 50, 200, 1000];

/// The highest whole power of a term.
const POWER: u32 = 4;

/// What a term is multiplied by where a natural number is one more.
#[derive(Default)]
struct Growth {
    /// The factors that multiply.
    above: Vec<Expr>,
    /// The factors that divide.
    below: Vec<Expr>,
    /// The powers whose base and exponent hold the number: whether they multiply, base and exponent.
    powers: Vec<(bool, Quotient, Polynomial)>,
}

impl Growth {
    /// Adds a factor.
    fn put(&mut self, e: Expr, multiplies: bool) {
        if natural(&e) != Some(1) {
            if multiplies { &mut self.above } else { &mut self.below }.push(e);
        }
    }
}

/// The base of a power.
struct Base {
    /// As a quotient of polynomials.
    quotient: Quotient,
    /// As it is written.
    written: Expr,
}

/// Bounds of a power b^m with b > 0.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// 1 + m·(b - 1) <= b^m
    Tangent,
    /// The same with <, for m >= 2.
    StrictTangent,
    /// exp(m·(1 - 1/b)) <= b^m
    ExponentialBelow,
    /// b^m <= exp(m·(b - 1))
    ExponentialAbove,
}

/// A bound of a power from below.
struct Below {
    /// What shows it.
    label: Label,
    /// The bound.
    bound: Expr,
}

impl Prover {
    /// Shows an order of terms by induction on a natural number, by what their quotient grows by.
    pub(super) fn by_growth(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("terms whose quotient with the next is known");
        let (a, relation, b) = single(goal)?;
        if self.inductions > 0 || self.splits > 0 {
            return Err(no());
        }
        let is_greater = relation.is_greater().ok_or_else(no)?;
        let (low, high) = if is_greater { (b, a) } else { (a, b) };
        let (low, high) = (low.clone(), high.clone());
        for n in self.naturals.clone().iter().rev() {
            let both = over(low.clone(), high.clone());
            if !super::induction::is_bound_within(goal, n) && !has_an_exponential(&both, n) {
                continue;
            }
            let Some(start) = self.falls_from(&both, n) else { continue };
            let shown = self.on_its_own(|c| match start {
                0 => c.by_growth_in(goal, (&low, &high), n),
                _ => c.begun_later(goal, n, start, &mut |c| c.by_growth_in(goal, (&low, &high), n)),
            });
            if shown.is_ok() {
                return shown;
            }
        }
        Err(no())
    }

    /// How much later than at the least number a term begins to fall, if it is known what it grows by and it falls from some number on
    /// wherever this is tried.
    fn falls_from(&mut self, e: &Expr, n: &str) -> Option<u32> {
        let mut growth = Growth::default();
        self.grows(e, n, true, &mut growth)?;
        let mut by: Vec<(Factor, Expr)> = vec![(Factor::Times, numeral(1))];
        by.extend(growth.above.into_iter().map(|e| (Factor::Times, e)));
        by.extend(growth.below.into_iter().map(|e| (Factor::Over, e)));
        for (multiplies, base, exponent) in growth.powers {
            let base = over(self.letters.written(&base.0), self.letters.written(&base.1));
            let own = power(&base, &self.letters.written(&exponent));
            by.push((if multiplies { Factor::Times } else { Factor::Over }, own));
        }
        let by = compare(expr(ExprKind::Product(by)), Relation::LessEqual, numeral(1));
        let least = self.least(n).unwrap_or(0);
        let grows = |j: u32| {
            let mut place = vec![(n.to_string(), f64::from(least) + f64::from(j))];
            super::trial_points::truth(&by, &mut place, &Default::default()) == Some(false)
        };
        if FAR.iter().any(|j| grows(*j)) {
            return None;
        }
        Some((0..LATER).rev().find(|j| grows(*j)).map_or(0, |j| j + 1))
    }

    /// A statement about a natural number, of those that are so much more than the least and then of each before them.
    pub(super) fn begun_later(
        &mut self,
        goal: &Prop,
        n: &str,
        start: u32,
        later: &mut dyn FnMut(&mut Prover) -> Result<Label, Fail>,
    ) -> Result<Label, Fail> {
        let Some(start) = start.checked_sub(1) else { return later(self) };
        let least = numeral(self.least(n).unwrap_or(0));
        let is_least = compare(name(n), Relation::Equal, least.clone());
        let is_more = compare(name(n), Relation::NotEqual, least.clone());
        let next = plus(&least, numeral(1));
        let next = self.simplified(&next).unwrap_or(next);
        let more = self.block(&implies(&is_more, goal), |c, _| {
            c.without_cases(&compare(name(n), Relation::GreaterEqual, next))?;
            c.begun_later(goal, n, start, later)
        })?;
        let first = self.block(&implies(&is_least, goal), |c, block| {
            c.splits += 1;
            c.put_in(&format!("{block}s"));
            let shown = c.by_value_of(goal, n, &least, block).or_else(|_| c.show(goal));
            c.splits -= 1;
            shown
        })?;
        self.logic(&[&more, &first], goal)
    }

    /// A goal where a variable has this value: what it says with the value in its place.
    fn by_value_of(&mut self, goal: &Prop, n: &str, value: &Expr, block: &str) -> Result<Label, Fail> {
        let here = super::put(goal, n, value)?;
        let shown = self.attempt(|c| c.emit(Rule::Evaluate, here.clone()).or_else(|_| c.without_cases(&here)))?;
        let facts = [shown, format!("{block}s")];
        self.logic(&[&facts[0], &facts[1]], goal).or_else(|_| {
            self.combination(goal.clone(), vec![Term { facts: vec![facts[0].clone()], factor: numeral(1) }])
        })
    }

    /// An order of two terms by induction on a natural number.
    fn by_growth_in(&mut self, goal: &Prop, (low, high): (&Expr, &Expr), n: &str) -> Result<Label, Fail> {
        let (_, relation, _) = single(goal)?;
        let strict = matches!(relation, Relation::Less | Relation::Greater);
        let within = compare(
            over(low.clone(), high.clone()),
            if strict { Relation::Less } else { Relation::LessEqual },
            numeral(1),
        );
        let shown = self.counted_from_zero(&within, n, &mut |c, k, body| {
            c.induction_by(k, None, body, &mut |c, hypothesis, next| c.grown(body, hypothesis, next, k))
        })?;
        self.define(high);
        let positive = compare(high.clone(), Relation::Greater, numeral(0));
        self.without_cases(&positive).or_else(|_| {
            // Of the factors of a product it is seen where what n is more than the least number stands for n.
            self.counted_from_zero(&positive, n, &mut |c, k, body| {
                let binding = Binding::of(Name::new(k), true, Vec::new());
                c.block(&prop(PropKind::ForAll(vec![binding], Box::new(body.clone()))), |c, _| {
                    c.define_sides(body);
                    c.without_cases(body)
                })
            })
        })?;
        self.order_of_sides(goal, &within, &shown, (low, high))
    }

    /// An order from that of the quotient of its sides beside 1. It is shown of all numbers, for the kernel may take a side apart
    /// into products whose signs are not known.
    fn order_of_sides(
        &mut self,
        goal: &Prop,
        within: &Prop,
        shown: &str,
        (low, high): (&Expr, &Expr),
    ) -> Result<Label, Fail> {
        let (x, y) = (self.fresh("x"), self.fresh("y"));
        let ((_, relation, _), (_, below, _)) = (single(goal)?, single(within)?);
        let (low_one, high_one) = (name(&x), name(&y));
        let quotient = compare(over(low_one.clone(), high_one.clone()), below, numeral(1));
        let order = if relation.is_greater() == Some(true) {
            compare(high_one.clone(), relation, low_one)
        } else {
            compare(low_one, relation, high_one.clone())
        };
        let step = implies(&quotient, &order);
        let every = |own: &str, positive: bool, body: Prop| {
            let constraint = Constraint::Relation(Relation::Greater, numeral(0));
            let binding = Binding::of(Name::new(own), false, positive.then_some(constraint).into_iter().collect());
            prop(PropKind::ForAll(vec![binding], Box::new(body)))
        };
        let of_x = every(&x, false, step.clone());
        let all = self.block(&every(&y, true, of_x.clone()), |c, _| {
            c.block(&of_x, |c, _| {
                c.block(&step, |c, block| {
                    let factor = if relation.is_greater() == Some(true) { negated(high_one) } else { high_one };
                    c.combination(order, vec![Term { facts: vec![format!("{block}s")], factor }])
                })
            })
        })?;
        let at_high = self.instance(&all, high)?;
        let here = self.instance(&at_high, low)?;
        self.logic(&[&here, shown], goal)
    }

    /// Q(k + 1) <= 1 from Q(k) <= 1.
    fn grown(&mut self, body: &Prop, hypothesis: Label, next: &Prop, k: &str) -> Result<Label, Fail> {
        let no = || Fail::No("what a term grows by");
        let ((own, _, _), (later, _, _)) = (single(body)?, single(next)?);
        let mut growth = Growth::default();
        self.grows(own, k, true, &mut growth).ok_or_else(no)?;
        let power = self.one_power(&mut growth).ok_or_else(no)?;
        let Growth { above, below, .. } = growth;
        above.iter().chain(&below).for_each(|e| self.bounds_of_a_number(e));
        let (above, below) = (product(above), product(below));
        let divisor = match &power {
            Some((base, exponent)) => product(vec![below.clone(), self.power_written(base, exponent)]),
            None => below.clone(),
        };
        for law in self.laws(own, k)? {
            self.put_in_law(&law, &Default::default())?;
        }
        self.define(later);
        self.define(&divisor);
        for e in [own, &divisor] {
            self.without_cases(&compare(e.clone(), Relation::Greater, numeral(0)))?;
        }
        let by = over(above.clone(), divisor.clone());
        let moves = compare(later.clone(), Relation::Equal, product(vec![by.clone(), own.clone()]));
        self.enrich(&[later]);
        let moves = self.combination(moves.clone(), Vec::new()).or_else(|_| self.quietly(&moves))?;
        let falls = compare(by, Relation::LessEqual, numeral(1));
        let falls = match &power {
            None => {
                let shown = self.without_cases(&compare(above, Relation::LessEqual, below))?;
                let term = Term { facts: vec![shown], factor: over(numeral(1), divisor) };
                self.combination(falls, vec![term])?
            }
            Some((base, exponent)) => self.falls_by_a_bound(&falls, (&above, &below), base, exponent)?,
        };
        let term = |fact: Label, factor: Expr| Term { facts: vec![fact], factor };
        let terms = vec![term(moves, numeral(1)), term(hypothesis, numeral(1)), term(falls, own.clone())];
        self.combination(next.clone(), terms)
    }

    /// above/(below·b^e) <= 1, by a bound of b^e.
    fn falls_by_a_bound(
        &mut self,
        falls: &Prop,
        (above, below): (&Expr, &Expr),
        base: &Base,
        exponent: &Polynomial,
    ) -> Result<Label, Fail> {
        let power = self.power_written(base, exponent);
        for by_exponential in [false, true] {
            for shift in SHIFTS {
                let kind = if by_exponential { Kind::ExponentialBelow } else { Kind::Tangent };
                let moved = exponent.add(&Polynomial::integer(shift));
                let Some(least) = self.bound_of_a_power(base, &moved, kind) else { continue };
                let bound = product(vec![least, whole_power(base.written.clone(), -shift)]);
                let high = product(vec![below.clone(), bound]);
                if self.is_denied(&compare(above.clone(), Relation::LessEqual, high)) {
                    continue;
                }
                let shown = self.attempt(|c| {
                    let Below { label, bound } = c.power_at_least(base, &moved, shift, kind)?;
                    if let ExprKind::Apply(..) = bound.kind {
                        c.bounds_of_a_number(&bound);
                    }
                    let high = product(vec![below.clone(), bound]);
                    let shown = c.without_cases(&compare(above.clone(), Relation::LessEqual, high))?;
                    let divisor = product(vec![below.clone(), power.clone()]);
                    let terms = vec![
                        Term { facts: vec![shown], factor: over(numeral(1), divisor) },
                        Term { facts: vec![label], factor: over(numeral(1), power.clone()) },
                    ];
                    c.combination(falls.clone(), terms)
                });
                if shown.is_ok() {
                    return shown;
                }
            }
        }
        Err(Fail::No("a bound of a power"))
    }

    /// b^e from below, by its tangent or by an exponential with the exponent e + shift, here `moved`.
    fn power_at_least(&mut self, base: &Base, moved: &Polynomial, shift: i64, kind: Kind) -> Result<Below, Fail> {
        let exponent = &moved.sub(&Polynomial::integer(shift));
        let (label, least) = self.power_beside(base, moved, kind)?;
        if shift == 0 {
            return Ok(Below { label, bound: least });
        }
        let apart = whole_power(base.written.clone(), -shift);
        let bound = product(vec![least, apart.clone()]);
        let shown = compare(bound.clone(), Relation::LessEqual, self.power_written(base, exponent));
        let label = self.combination(shown, vec![Term { facts: vec![label], factor: apart }])?;
        Ok(Below { label, bound })
    }

    /// A bound of a power b^m, and what shows it.
    fn power_beside(&mut self, base: &Base, exponent: &Polynomial, kind: Kind) -> Result<(Label, Expr), Fail> {
        let no = || Fail::No("a bound of a power");
        let (b, m) = (base.written.clone(), self.letters.written(exponent));
        let bound = self.bound_of_a_power(base, exponent, kind).ok_or_else(no)?;
        self.define(&b);
        self.without_cases(&compare(b.clone(), Relation::Greater, numeral(0)))?;
        let label = match &bound.kind {
            ExprKind::Apply(_, list) if matches!(kind, Kind::ExponentialAbove | Kind::ExponentialBelow) => {
                let all = list.first().ok_or_else(no)?;
                let is_above = kind == Kind::ExponentialAbove;
                let (above, below) = &base.quotient;
                let rate = self.quotient_written(&above.sub(below), if is_above { below } else { above });
                self.exponential_beside((&b, &m), (&rate.ok_or_else(no)?, all), is_above)?
            }
            _ => self.tangent_of_a_power((&b, &m), &bound, kind == Kind::StrictTangent)?,
        };
        Ok((label, bound))
    }

    /// A bound of a power b^m.
    fn bound_of_a_power(&mut self, base: &Base, exponent: &Polynomial, kind: Kind) -> Option<Expr> {
        let (above, below) = &base.quotient;
        let times = above.sub(below).try_mul(exponent).ok()?;
        match kind {
            Kind::Tangent | Kind::StrictTangent => self.quotient_written(&times.add(below), below),
            Kind::ExponentialAbove => Some(apply("exp", self.quotient_written(&times, below)?)),
            Kind::ExponentialBelow => Some(apply("exp", self.quotient_written(&times, above)?)),
        }
    }

    /// Shows an order by a bound of a power in it whose base and exponent hold a natural number, as (1 + 1/n)^n < 3.
    pub(super) fn by_bounds_of_powers(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("a power whose base and exponent hold a natural number");
        if self.inductions > 0 || self.splits > 0 {
            return Err(no());
        }
        let (a, relation, b) = single(goal)?;
        let strict = matches!(relation, Relation::Less | Relation::Greater);
        // What is left of a goal in many variables is no easier.
        if super::goals::variables_of(goal).len() > NAMES {
            return Err(no());
        }
        let mut powers = Vec::new();
        for n in &self.naturals {
            [a, b].into_iter().for_each(|e| super::hypergeometric::powers_of_both(e, n, &mut powers));
        }
        for (base, exponent) in powers.into_iter().take(POWERS) {
            let written = power(&base, &exponent);
            let Some(base) = self.base_of(&base) else { continue };
            let Some(exponent) = self.letters.polynomial(&exponent) else { continue };
            let times = self.times_in(goal, &written)?;
            let needs_above =
                self.is_positive_here(&times).map(|positive| positive != (relation.is_greater() == Some(true)));
            let kinds = [Kind::StrictTangent, Kind::Tangent, Kind::ExponentialAbove, Kind::ExponentialBelow];
            for kind in kinds.into_iter().filter(|kind| strict || *kind != Kind::StrictTangent) {
                if needs_above.is_some_and(|above| above != (kind == Kind::ExponentialAbove)) {
                    continue;
                }
                let Some(bound) = self.bound_of_a_power(&base, &exponent, kind) else { continue };
                let mut least = goal.clone();
                if let PropKind::Compare(sides, _) = &mut least.kind {
                    sides.iter_mut().for_each(|e| super::sums::replace(e, &written, &bound));
                }
                if self.is_denied(&least) {
                    continue;
                }
                let shown = self.attempt(|c| {
                    let (label, _) = c.power_beside(&base, &exponent, kind)?;
                    let direct = c.attempt(|c| {
                        let shown = match c.speaks_of_numbers(&least) {
                            true => c.emit(Rule::Evaluate, least.clone())?,
                            false => c.quietly(&least)?,
                        };
                        let times = if kind == Kind::ExponentialAbove { times.clone() } else { negated(times.clone()) };
                        let terms = vec![
                            Term { facts: vec![shown], factor: numeral(1) },
                            Term { facts: vec![label], factor: times },
                        ];
                        c.combination(goal.clone(), terms)
                    });
                    if direct.is_ok() {
                        return direct;
                    }
                    c.bounds_of_a_number(&bound);
                    c.quietly(goal)
                });
                if shown.is_ok() {
                    return shown;
                }
            }
        }
        Err(no())
    }

    /// Whether an order fails somewhere where it is tried.
    fn is_denied(&self, order: &Prop) -> bool {
        [0, 1, 7].iter().chain(&FAR).any(|j| {
            let of = |n: &String| (n.clone(), f64::from(self.least(n).unwrap_or(0)) + f64::from(*j));
            let mut place: super::trial_points::Place = self.naturals.iter().map(of).collect();
            super::trial_points::truth(order, &mut place, &Default::default()) == Some(false)
        })
    }

    /// Whether an expression of natural numbers is positive, where they are a little more than the least.
    fn is_positive_here(&self, e: &Expr) -> Option<bool> {
        let of = |n: &String| (n.clone(), f64::from(self.least(n).unwrap_or(0)) + 3.0);
        let place = self.naturals.iter().map(of).collect();
        super::trial_points::value_here(e, &place).filter(|value| *value != 0.0).map(|value| value > 0.0)
    }

    /// Where an exponential is a number, between which fractions it lies.
    fn bounds_of_a_number(&mut self, e: &Expr) {
        let Some(value) = super::trial_points::value_here(e, &Vec::new()).filter(|v| v.abs() < 1e6) else { return };
        if !self.is_of_numbers(e) {
            return;
        }
        for (relation, by) in [(Relation::Less, 0.0005), (Relation::Greater, -0.0005)] {
            let Ok(bound) = Rational::try_from(((value + by) * 4096.0).round()) else { return };
            let bound = crate::refute::literal::literal(&(bound / Rational::from(4096)));
            let _ = self.emit(Rule::Evaluate, compare(e.clone(), relation, bound));
        }
    }

    /// Whether there is a power whose base and exponent hold a natural number.
    pub(super) fn has_powers_of_both(&self, sides: &[Expr]) -> bool {
        let mut powers = Vec::new();
        for n in &self.naturals {
            sides.iter().for_each(|e| super::hypergeometric::powers_of_both(e, n, &mut powers));
        }
        !powers.is_empty()
    }

    /// The base of a power as a quotient of polynomials.
    fn base_of(&mut self, e: &Expr) -> Option<Base> {
        // The index of no sum is called so: all letters are taken as they are.
        let (above, below) = self.quotient(e, "")?;
        let common = gcd(&above, &below).ok()?;
        let quotient = (above.exact_divide(&common)?, below.exact_divide(&common)?);
        let written = self.quotient_written(&quotient.0, &quotient.1)?;
        Some(Base { quotient, written })
    }

    /// 1 + m·(b - 1) <= b^m for a natural number m and b > 0, by induction; `least` is the left side. It is `strict` for m >= 2 where b
    /// is other than 1.
    fn tangent_of_a_power(&mut self, (b, m): (&Expr, &Expr), least: &Expr, strict: bool) -> Result<Label, Fail> {
        let j = self.fresh("j");
        let relation = if strict { Relation::Less } else { Relation::LessEqual };
        let slope = super::facts::minus(b, &numeral(1));
        let line = plus(&numeral(1), product(vec![name(&j), slope.clone()]));
        let body = compare(line, relation, power(b, &name(&j)));
        let bent = negated(product(vec![name(&j), whole_power(slope, 2)]));
        self.inductions += 1;
        let every = self.induction_by(&j, strict.then_some(2), &body, &mut |c, hypothesis, next| {
            let terms = vec![
                Term { facts: vec![hypothesis], factor: b.clone() },
                Term { facts: Vec::new(), factor: bent.clone() },
            ];
            c.combination(next.clone(), terms)
        })?;
        self.inductions -= 1;
        let here = self.instance(&every, m)?;
        let shown = compare(least.clone(), relation, power(b, m));
        self.combination(shown, vec![Term { facts: vec![here], factor: numeral(1) }])
    }

    /// exp(m·(1 - 1/b)) <= b^m or, `above` it, b^m <= exp(m·(b - 1)), for b > 0, from the tangent of exp at 0; `rate` is what m is
    /// multiplied by and `all` the product. It is strict where b is seen to be other than 1.
    fn exponential_beside(
        &mut self,
        (b, m): (&Expr, &Expr),
        (rate, all): (&Expr, &Expr),
        above: bool,
    ) -> Result<Label, Fail> {
        let exp = |e: &Expr| apply("exp", e.clone());
        let at = if above { rate.clone() } else { negated(rate.clone()) };
        let line = self.tangent_at(&at)?;
        let relation = self.fact(&line).and_then(|fact| single(&fact).ok().map(|(_, r, _)| r));
        let relation = relation.ok_or(Fail::No("a tangent"))?;
        let ordered = |bound: Expr, own: Expr| {
            if above { compare(own, relation, bound) } else { compare(bound, relation, own) }
        };
        let term = |fact: &Label, factor: Expr| Term { facts: vec![fact.clone()], factor };
        let factor = if above { numeral(1) } else { product(vec![b.clone(), exp(rate)]) };
        let one = self.combination(ordered(exp(rate), b.clone()), vec![term(&line, factor)])?;
        let from = self.emit(Rule::Monotone { from: one }, ordered(power(&exp(rate), m), power(b, m)))?;
        let same = self.emit(Rule::Power, compare(exp(all), Relation::Equal, power(&exp(rate), m)))?;
        let one = numeral(1);
        let terms = vec![term(&same, if above { negated(one.clone()) } else { one.clone() }), term(&from, one)];
        self.combination(ordered(exp(all), power(b, m)), terms)
    }

    /// A power as it is written.
    fn power_written(&mut self, base: &Base, exponent: &Polynomial) -> Expr {
        power(&base.written, &self.letters.written(exponent))
    }

    /// All powers whose base and exponent hold the number as one that divides; what differs from it is put to the other factors.
    fn one_power(&mut self, growth: &mut Growth) -> Option<Option<(Base, Polynomial)>> {
        let slope = |p: &Polynomial| -> Polynomial { p.sub(&Polynomial::constant(p.constant_term())) };
        let lead = |p: &Polynomial| p.terms().next().map(|(_, c)| c.clone()).filter(|_| slope(p).term_count() == 1);
        let mut least: Option<Polynomial> = None;
        for (_, _, exponent) in &growth.powers {
            let own = slope(exponent);
            let size = lead(&own)?.abs();
            if least.as_ref().is_none_or(|p| lead(&slope(p)).is_some_and(|old| size < old.abs())) {
                least = Some(exponent.clone());
            }
        }
        let Some(least) = least else { return Some(None) };
        let first = lead(&slope(&least))?;
        let least = if first < 0 { least.neg() } else { least };
        let first = first.abs();
        let (mut base, mut written) = ((Polynomial::one(), Polynomial::one()), Vec::new());
        for (multiplies, own, exponent) in std::mem::take(&mut growth.powers) {
            let times = i64::try_from(&(lead(&slope(&exponent))? / &first)).ok()?;
            let rest = exponent.sub(&least.scale(&Rational::from(times))).as_constant()?;
            let rest = i64::try_from(&rest).ok()?;
            // It divides: what multiplies is put in upside down.
            let (times, up) = (if multiplies { -times } else { times }, if multiplies { rest } else { -rest });
            base = super::hypergeometric::times(&base, &super::hypergeometric::power(&own, times)?)?;
            // The kernel takes a power of a product apart, and does not look for factors in its base.
            written.push(whole_power(self.quotient_written(&own.0, &own.1)?, times));
            let (above, below) = super::hypergeometric::power(&own, up)?;
            growth.put(self.letters.written(&above), true);
            growth.put(self.letters.written(&below), false);
        }
        let common = gcd(&base.0, &base.1).ok()?;
        let quotient = (base.0.exact_divide(&common)?, base.1.exact_divide(&common)?);
        let written = match written.as_slice() {
            [_] => self.quotient_written(&quotient.0, &quotient.1)?,
            _ => product(written),
        };
        Some((quotient.0 != quotient.1).then_some((Base { quotient, written }, least)))
    }

    /// What a term is multiplied by where n is one more, put to the rest; the term itself multiplies or divides.
    fn grows(&mut self, e: &Expr, n: &str, multiplies: bool, out: &mut Growth) -> Option<()> {
        if !holds(e, n) {
            return Some(());
        }
        if let ExprKind::Product(list) = &e.kind {
            return list.iter().try_for_each(|(how, e)| self.grows(e, n, multiplies == (*how == Factor::Times), out));
        }
        if let Some((above, below)) = self.ratio(e, n) {
            let common = gcd(&above, &below).ok()?;
            out.put(self.letters.written(&above.exact_divide(&common)?), multiplies);
            out.put(self.letters.written(&below.exact_divide(&common)?), !multiplies);
            return Some(());
        }
        if let ExprKind::Apply(f, list) = &e.kind
            && let ("exp", [exponent]) = (f.text.as_str(), list.as_slice())
        {
            let (above, below) = self.quotient(exponent, n)?;
            let letter = self.letters.of(&name(n));
            let by = above.derivative(letter);
            if !below.derivative(letter).is_zero() || !by.derivative(letter).is_zero() {
                return None;
            }
            let by = self.quotient_written(&by, &below)?;
            out.put(apply("exp", by), multiplies);
            return Some(());
        }
        let (base, exponent) = as_power(e)?;
        if let Some(k) = natural(&exponent) {
            return if k <= POWER { (0..k).try_for_each(|_| self.grows(&base, n, multiplies, out)) } else { None };
        }
        let own = self.ratio(&base, n)?;
        let common = gcd(&own.0, &own.1).ok()?;
        let own = (own.0.exact_divide(&common)?, own.1.exact_divide(&common)?);
        if !holds(&exponent, n) {
            let root = |p: &Expr| match &e.kind {
                ExprKind::Apply(f, _) => apply(&f.text, p.clone()),
                _ => power(p, &exponent),
            };
            let (above, below) = (self.letters.written(&own.0), self.letters.written(&own.1));
            for (e, up) in [(above, multiplies), (below, !multiplies)] {
                if natural(&e) != Some(1) {
                    out.put(root(&e), up);
                }
            }
            return Some(());
        }
        let slope = self.slope(&exponent, n)?;
        let next = super::slopes::put_in(&base, n, &plus(&name(n), numeral(1))).ok()?;
        let (above, below) = self.quotient(&next, n)?;
        let (above, below) = super::hypergeometric::power(&(above, below), slope)?;
        out.put(self.letters.written(&above), multiplies);
        out.put(self.letters.written(&below), !multiplies);
        let exponent = self.letters.polynomial(&exponent)?;
        out.powers.push((multiplies, own, exponent));
        Some(())
    }
}

/// Whether an expression holds an exponential of a name.
fn has_an_exponential(e: &Expr, n: &str) -> bool {
    let mut found = matches!(&e.kind, ExprKind::Apply(f, list) if f.text == "exp" && list.iter().any(|e| holds(e, n)));
    crate::claim::walk::parts(e, &mut |part| found |= has_an_exponential(part, n));
    found
}
