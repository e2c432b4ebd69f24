//! Orders of terms whose quotient with the next is known, by induction: n! >= n^n·exp(-n), binomial(2*n, n) >= 4^n/(2*sqrt(n)).
//!
//! Method: with Q the quotient of the sides, the goal says Q(n) <= 1, and Q(n + 1) = R(n)·Q(n). R multiplies what each factor of Q
//! grows by: products over an index, factorials, powers, exponentials, roots and polynomials. So R(n) <= 1 is the step. In R a power
//! b^e may be left whose base and exponent both hold n, as ((n + 1)/n)^n. It is written below, and is at least 1 + m·(b - 1) or
//! exp(m·(1 - 1/b)) times b^(e - m), for some m near e.
//!
//! Limits: [`SHIFTS`], [`POWER`].

use super::comparison::single;
use super::facts::negated;
use super::letters::{as_power, natural, product, whole_power};
use super::limits::{holds, over, plus};
use super::sums::Quotient;
use super::{Fail, Prover};
use crate::algebra::Polynomial;
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::kernel::statement::{apply, compare, name, numeral, power};
use malachite::base::num::arithmetic::traits::Abs;
use malachite::Rational;

/// How far the exponent m of a bound is from that of the power.
const SHIFTS: [i64; 3] = [0, 1, -1];

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
            if !super::induction::is_bound_within(goal, n) || !self.has_a_growth(&both, n) {
                continue;
            }
            if let Ok(label) = self.on_its_own(|c| c.by_growth_in(goal, (&low, &high), n)) {
                return Ok(label);
            }
        }
        Err(no())
    }

    /// Whether it is known what a term grows by.
    fn has_a_growth(&mut self, e: &Expr, n: &str) -> bool {
        self.grows(e, n, true, &mut Growth::default()).is_some()
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
        self.without_cases(&compare(high.clone(), Relation::Greater, numeral(0)))?;
        let factor = if relation.is_greater() == Some(true) { negated(high.clone()) } else { high.clone() };
        self.combination(goal.clone(), vec![Term { facts: vec![shown], factor }])
    }

    /// Q(k + 1) <= 1 from Q(k) <= 1.
    fn grown(&mut self, body: &Prop, hypothesis: Label, next: &Prop, k: &str) -> Result<Label, Fail> {
        let no = || Fail::No("what a term grows by");
        let ((own, _, _), (later, _, _)) = (single(body)?, single(next)?);
        let mut growth = Growth::default();
        self.grows(own, k, true, &mut growth).ok_or_else(no)?;
        let power = self.one_power(&mut growth).ok_or_else(no)?;
        let Growth { above, below, .. } = growth;
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
        let terms =
            vec![term(moves, numeral(1)), term(hypothesis, numeral(1)), term(falls, own.clone())];
        self.combination(next.clone(), terms)
    }

    /// above/(below·b^e) <= 1, by a bound of b^e.
    fn falls_by_a_bound(
        &mut self,
        falls: &Prop,
        (above, below): (&Expr, &Expr),
        base: &Quotient,
        exponent: &Polynomial,
    ) -> Result<Label, Fail> {
        let power = self.power_written(base, exponent);
        for by_exponential in [false, true] {
            for shift in SHIFTS {
                let shown = self.attempt(|c| {
                    let Below { label, bound } = c.power_at_least(base, exponent, shift, by_exponential)?;
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

    /// b^e from below, by its tangent or by an exponential with the exponent e + shift.
    fn power_at_least(
        &mut self,
        base: &Quotient,
        exponent: &Polynomial,
        shift: i64,
        by_exponential: bool,
    ) -> Result<Below, Fail> {
        let no = || Fail::No("a bound of a power");
        let moved = exponent.add(&Polynomial::integer(shift));
        let b = self.quotient_written(&base.0, &base.1).ok_or_else(no)?;
        let m = self.letters.written(&moved);
        self.define(&b);
        self.without_cases(&compare(b.clone(), Relation::Greater, numeral(0)))?;
        let (label, least) = if by_exponential {
            // 1 - 1/b and m times this.
            let rate = (base.0.sub(&base.1), base.0.clone());
            let all = (rate.0.try_mul(&moved).map_err(|_| no())?, rate.1.clone());
            let rate = self.quotient_written(&rate.0, &rate.1).ok_or_else(no)?;
            let all = self.quotient_written(&all.0, &all.1).ok_or_else(no)?;
            self.exponential_below(&b, &m, &rate, &all)?
        } else {
            let all = base.0.sub(&base.1).try_mul(&moved).map_err(|_| no())?.add(&base.1);
            let least = self.quotient_written(&all, &base.1).ok_or_else(no)?;
            (self.tangent_of_a_power(&b, &m, &least)?, least)
        };
        if shift == 0 {
            return Ok(Below { label, bound: least });
        }
        let apart = whole_power(b, -shift);
        let bound = product(vec![least, apart.clone()]);
        let shown = compare(bound.clone(), Relation::LessEqual, self.power_written(base, exponent));
        let label = self.combination(shown, vec![Term { facts: vec![label], factor: apart }])?;
        Ok(Below { label, bound })
    }

    /// 1 + m·(b - 1) <= b^m for a natural number m and b > 0, by induction; `least` is the left side.
    fn tangent_of_a_power(&mut self, b: &Expr, m: &Expr, least: &Expr) -> Result<Label, Fail> {
        let j = self.fresh("j");
        let slope = super::facts::minus(b, &numeral(1));
        let line = plus(&numeral(1), product(vec![name(&j), slope.clone()]));
        let body = compare(line, Relation::LessEqual, power(b, &name(&j)));
        let bent = negated(product(vec![name(&j), whole_power(slope, 2)]));
        self.inductions += 1;
        let every = self.induction_by(&j, None, &body, &mut |c, hypothesis, next| {
            let terms = vec![
                Term { facts: vec![hypothesis], factor: b.clone() },
                Term { facts: Vec::new(), factor: bent.clone() },
            ];
            c.combination(next.clone(), terms)
        })?;
        self.inductions -= 1;
        let here = self.instance(&every, m)?;
        let shown = compare(least.clone(), Relation::LessEqual, power(b, m));
        self.combination(shown, vec![Term { facts: vec![here], factor: numeral(1) }])
    }

    /// exp(m·(1 - 1/b)) <= b^m for b > 0, from the tangent of exp at 0; `rate` is 1 - 1/b and `all` m times this.
    fn exponential_below(&mut self, b: &Expr, m: &Expr, rate: &Expr, all: &Expr) -> Result<(Label, Expr), Fail> {
        let exp = |e: &Expr| apply("exp", e.clone());
        let back = negated(rate.clone());
        let line = compare(plus(&numeral(1), back.clone()), Relation::LessEqual, exp(&back));
        let with = vec![(Name::new("x"), back)];
        let line = self.emit(Rule::Tangent { with }, line)?;
        let one = compare(exp(rate), Relation::LessEqual, b.clone());
        let factor = product(vec![b.clone(), exp(rate)]);
        let one = self.combination(one, vec![Term { facts: vec![line], factor }])?;
        if natural(m) == Some(1) {
            return Ok((one, exp(rate)));
        }
        let powers = compare(power(&exp(rate), m), Relation::LessEqual, power(b, m));
        let powers = self.emit(Rule::Monotone { from: one }, powers)?;
        let same = self.emit(Rule::Power, compare(exp(all), Relation::Equal, power(&exp(rate), m)))?;
        let term = |fact: Label| Term { facts: vec![fact], factor: numeral(1) };
        let shown = compare(exp(all), Relation::LessEqual, power(b, m));
        Ok((self.combination(shown, vec![term(same), term(powers)])?, exp(all)))
    }

    /// A power as it is written.
    fn power_written(&mut self, base: &Quotient, exponent: &Polynomial) -> Expr {
        let base = self.quotient_written(&base.0, &base.1).unwrap_or_else(|| numeral(1));
        power(&base, &self.letters.written(exponent))
    }

    /// All powers whose base and exponent hold the number as one that divides; what differs from it is put to the other factors.
    fn one_power(&mut self, growth: &mut Growth) -> Option<Option<(Quotient, Polynomial)>> {
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
        let mut base = (Polynomial::one(), Polynomial::one());
        for (multiplies, own, exponent) in std::mem::take(&mut growth.powers) {
            let times = i64::try_from(&(lead(&slope(&exponent))? / &first)).ok()?;
            let rest = exponent.sub(&least.scale(&Rational::from(times))).as_constant()?;
            let rest = i64::try_from(&rest).ok()?;
            // It divides: what multiplies is put in upside down.
            let (times, up) = (if multiplies { -times } else { times }, if multiplies { rest } else { -rest });
            base = super::hypergeometric::times(&base, &super::hypergeometric::power(&own, times)?)?;
            let (above, below) = super::hypergeometric::power(&own, up)?;
            growth.put(self.letters.written(&above), true);
            growth.put(self.letters.written(&below), false);
        }
        let common = crate::algebra::gcd::gcd(&base.0, &base.1).ok()?;
        let base = (base.0.exact_divide(&common)?, base.1.exact_divide(&common)?);
        Some((base.0 != base.1).then_some((base, least)))
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
            let common = crate::algebra::gcd::gcd(&above, &below).ok()?;
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
        let common = crate::algebra::gcd::gcd(&own.0, &own.1).ok()?;
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
