//! Equations between cosines and sines of parts of π: cos(π/7) − cos(2·π/7) + cos(3·π/7) = 1/2.
//!
//! Method: all arguments are whole multiples of a unit u = π/q, so both sides are polynomials in c = cos u and s = sin u. For
//! q = k·h with h = 1, 2, 3 or 6 the cosine or sine of k·u = π/h is rational, and c² + s² = 1 makes the k-fold cosine a polynomial in
//! c alone, the k-fold sine for an odd k one in s alone (Chebyshev). So c and s are zeros of polynomials with rational coefficients;
//! of their irreducible factors all but one are not 0, by enclosures, so that one is. With it and c² + s² = 1 the equation is sought
//! in the ideal. Where the root r of a number occurs in the difference D, its sign is not a matter of equations: D·D′ = 0 is sought,
//! with −r for r in D′, and D′ is not 0 by enclosures.
//!
//! Certificate: rule `circle` for the k-fold cosine and sine, `evaluate` for what is not 0, combinations for the rest.

use super::circle::of_a_sum;
use super::comparison::single;
use super::facts::negated;
use super::letters::{as_power, product, whole_power};
use super::limits::over;
use super::{Fail, Prover};
use crate::algebra::Polynomial;
use crate::algebra::factor::factor;
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::kernel::statement::{apply, compare, name, numeral};
use crate::kernel::trigonometry::{MULTIPLE_LIMIT, unit_circle};
use crate::refute::literal::literal;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::{Gcd, Lcm};
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::rounding_modes::RoundingMode;

/// The parts of which the cosine, or the sine, is rational, by their denominators.
const RATIONAL: [(&str, [u64; 3]); 2] = [("cos", [3, 2, 1]), ("sin", [6, 2, 1])];

/// The multiples of π/120 are known in roots.
const IN_ROOTS: u64 = 120;

/// The highest degree of the cosine or sine of a unit.
const DEGREE: u32 = 12;

/// A unit u = π/q with its cosine and sine.
struct Unit {
    q: u64,
    argument: Expr,
    cosine: u32,
    sine: u32,
}

impl Unit {
    /// cos(k·u) and sin(k·u) as polynomials in both.
    fn multiple(&self, k: u64) -> Option<[Polynomial; 2]> {
        let own = [self.cosine, self.sine].map(Polynomial::variable);
        (0..k).try_fold([Polynomial::one(), Polynomial::zero()], |sum, _| of_a_sum(&sum, &own))
    }

    /// The part π/h.
    fn part(h: u64) -> Expr {
        product(vec![literal(&Rational::from_unsigneds(1, h)), name(PI)])
    }
}

impl Prover {
    /// Shows an equation between cosines and sines of parts of π.
    pub(super) fn by_parts_of_pi(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let (a, _, b) = single(goal)?;
        let no = || Fail::No("cosines and sines of parts of π");
        if self.checker.statement().declares(PI) {
            return Err(no());
        }
        let q = self.common_denominator(&[a, b]).ok_or_else(no)?;
        let unit = self.unit(q).ok_or_else(no)?;
        let mut known = self.equations_of_unit(&unit)?;
        let open = self.open_factors(goal, 0)?;
        // Roots of numbers, with their squares.
        let roots: Vec<u32> = open.poly.variables().into_iter().filter(|v| self.is_root_of_a_number(*v)).collect();
        for (label, fact) in self.facts() {
            if let Some(k) = self.known_of(&label, &fact)
                && !k.poly.is_constant()
                && k.poly.variables().iter().all(|v| roots.contains(v))
                && matches!(fact.single(), Some((_, Relation::Equal, _)))
            {
                known.push((label, (*fact).clone()));
            }
        }
        if let Ok(label) = self.attempt(|c| c.in_ideal_of(goal, &open.poly, &open.rest, &known)) {
            return Ok(label);
        }
        for root in roots.into_iter().rev() {
            let shown = self.attempt(|c| {
                let coefficients = open.poly.coefficients_in(root);
                let turned = |(i, p): (usize, &Polynomial)| if i % 2 == 1 { p.neg() } else { p.clone() };
                let turned: Vec<Polynomial> = coefficients.iter().enumerate().map(turned).collect();
                let turned = Polynomial::from_coefficients_in(root, &turned);
                let other = c.letters.written(&turned);
                c.evaluated_sign(&other)?;
                let both = open.poly.try_mul(&turned).map_err(|_| no())?;
                let zero =
                    compare(product(vec![c.letters.written(&open.poly), other.clone()]), Relation::Equal, numeral(0));
                let label = c.in_ideal_of(&zero, &both, &[], &known)?;
                let rest = product(open.rest.clone());
                c.combination(goal.clone(), vec![Term { facts: vec![label], factor: over(rest, other) }])
            });
            if shown.is_ok() {
                return shown;
            }
        }
        Err(no())
    }

    /// The common denominator of the multiples of π whose cosines and sines occur, where one of them is not known in roots.
    fn common_denominator(&mut self, sides: &[&Expr]) -> Option<u64> {
        let mut q = 1u64;
        for letter in self.letters_in(sides) {
            let ExprKind::Apply(f, at) = &letter.kind else { continue };
            let ("cos" | "sin", [v]) = (f.text.as_str(), at.as_slice()) else { continue };
            let turns = self.read(&over(v.clone(), name(PI)), false)?;
            if turns.factors.is_empty() {
                q = q.lcm(u64::try_from(turns.number.denominator_ref()).ok().filter(|d| *d < 1000)?);
            }
        }
        (!IN_ROOTS.is_multiple_of(q)).then_some(q)
    }

    /// The unit π/q, once the cosines and sines of the other parts are written by its own.
    fn unit(&mut self, q: u64) -> Option<Unit> {
        if RATIONAL[0].1.iter().all(|h| !q.is_multiple_of(*h) || q / h > MULTIPLE_LIMIT) {
            return None;
        }
        let argument = Unit::part(q);
        let own = ["cos", "sin"].map(|f| apply(f, argument.clone()));
        self.enrich(&own.iter().collect::<Vec<_>>());
        let mut letters = [0; 2];
        for (e, letter) in own.iter().zip(&mut letters) {
            let reading = self.read(e, false)?;
            let [factor] = reading.factors.as_slice() else { return None };
            *letter = factor.poly.variables().first().copied().filter(|_| factor.poly.degree() == 1)?;
        }
        Some(Unit { q, argument, cosine: letters[0], sine: letters[1] })
    }

    /// Equations between the cosine and the sine of a unit: the circle, what each is a zero of, and both for a multiple that is known in
    /// roots.
    fn equations_of_unit(&mut self, unit: &Unit) -> Result<Vec<(Label, Prop)>, Fail> {
        let with = || Rule::Circle { with: vec![(Name::new("u"), unit.argument.clone())] };
        let round = unit_circle(&unit.argument);
        let circle = match self.known(&round) {
            Some(label) => label,
            None => self.emit(with(), round.clone())?,
        };
        let mut out = vec![(circle.clone(), round)];
        for (place, (f, parts)) in RATIONAL.into_iter().enumerate() {
            let fits = |h: &u64| {
                unit.q.is_multiple_of(*h) && unit.q / h <= MULTIPLE_LIMIT && (f == "cos" || unit.q / h % 2 == 1)
            };
            if let Some(h) = parts.into_iter().find(fits)
                && let Ok(found) = self.attempt(|c| c.zero_of(unit, place, h, &circle))
            {
                out.push(found);
            }
        }
        if out.len() == 1 {
            return Err(Fail::No("a polynomial of small degree"));
        }
        let h = unit.q.gcd(IN_ROOTS);
        if let Some(values) = unit.multiple(unit.q / h).filter(|_| unit.q / h <= MULTIPLE_LIMIT) {
            for (f, value) in ["cos", "sin"].into_iter().zip(values) {
                let shown = compare(apply(f, Unit::part(h)), Relation::Equal, self.letters.written(&value));
                if let Ok(label) = self.emit(with(), shown.clone()) {
                    self.enrich(&[&apply(f, Unit::part(h))]);
                    out.push((label, shown));
                }
            }
        }
        Ok(out)
    }

    /// The irreducible polynomial of which the cosine (0) or sine (1) of a unit is a zero, from that of π/h.
    fn zero_of(&mut self, unit: &Unit, place: usize, h: u64, circle: &Label) -> Result<(Label, Prop), Fail> {
        let no = || Fail::No("a polynomial of small degree");
        let k = unit.q / h;
        let (f, own, other) = [("cos", unit.cosine, unit.sine), ("sin", unit.sine, unit.cosine)][place];
        let of_both = unit.multiple(k).ok_or_else(no)?[place].clone();
        let at_part = apply(f, Unit::part(h));
        let value = self.read(&at_part, false).filter(|r| r.factors.is_empty()).ok_or_else(no)?.number;
        let rule = Rule::Circle { with: vec![(Name::new("u"), unit.argument.clone())] };
        let multiple = self.emit(rule, compare(at_part, Relation::Equal, self.letters.written(&of_both)))?;
        let (quotient, alone) = by_the_circle(&of_both, own, other).ok_or_else(no)?;
        let zero = alone.sub(&Polynomial::constant(value));
        let terms = vec![
            Term { facts: vec![multiple], factor: negated(numeral(1)) },
            Term { facts: vec![circle.clone()], factor: negated(self.letters.written(&quotient)) },
        ];
        // The number near which the polynomial is 0.
        let angle = std::f64::consts::PI / f64::from(u32::try_from(unit.q).map_err(|_| no())?);
        let near = if f == "cos" { angle.cos() } else { angle.sin() };
        let found = factor(&zero).map_err(|_| no())?;
        let sizes: Vec<f64> = found.factors.iter().map(|(p, _)| size_at(p, own, near)).collect();
        let least = (0..sizes.len()).min_by(|i, j| sizes[*i].total_cmp(&sizes[*j])).ok_or_else(no)?;
        let chosen = found.factors[least].0.clone();
        if chosen.degree() > DEGREE {
            return Err(no());
        }
        for (i, (p, _)) in found.factors.iter().enumerate() {
            if i != least {
                let e = self.letters.written(p);
                self.evaluated_sign(&e)?;
            }
        }
        let powers = found.factors.iter().map(|(p, k)| whole_power(self.letters.written(p), i64::from(*k)));
        let factors: Vec<Expr> = std::iter::once(literal(&found.unit)).chain(powers).collect();
        let whole = compare(product(factors), Relation::Equal, numeral(0));
        let label = self.combination(whole, terms)?;
        let shown = compare(self.letters.written(&chosen), Relation::Equal, numeral(0));
        if found.factors.len() == 1 && found.factors[0].1 == 1 {
            let factor = literal(&(Rational::from(1) / &found.unit));
            let label = self.combination(shown.clone(), vec![Term { facts: vec![label], factor }])?;
            return Ok((label, shown));
        }
        let label = self.combination(shown.clone(), Vec::new()).or_else(|_| {
            self.against_opposite(&shown, |c, _| {
                let denied =
                    c.fact(&label).and_then(|p| Some(compare(p.single()?.0.clone(), Relation::NotEqual, numeral(0))));
                let denied = c.combination(denied.ok_or_else(no)?, Vec::new())?;
                c.logic(&[&denied, &label], &shown)
            })
        })?;
        Ok((label, shown))
    }

    /// Shows by enclosures that a number is positive, or that it is negative.
    fn evaluated_sign(&mut self, e: &Expr) -> Result<Label, Fail> {
        let order = |relation| compare(e.clone(), relation, numeral(0));
        self.emit(Rule::Evaluate, order(Relation::Greater))
            .or_else(|_| self.emit(Rule::Evaluate, order(Relation::Less)))
    }

    /// Whether a letter is a root of a number.
    fn is_root_of_a_number(&self, letter: u32) -> bool {
        self.letters.expr(letter).is_some_and(|e| as_power(e).is_some_and(|(base, _)| self.is_of_numbers(&base)))
    }
}

/// The quotient and the remainder by own² + other² − 1, where `other` is not left in the remainder.
fn by_the_circle(p: &Polynomial, own: u32, other: u32) -> Option<(Polynomial, Polynomial)> {
    let mut list = p.coefficients_in(other);
    let own = Polynomial::variable(own);
    let rest = Polynomial::one().sub(&own.try_mul(&own).ok()?);
    let mut quotient = vec![Polynomial::zero(); list.len().saturating_sub(2)];
    for i in (2..list.len()).rev() {
        let lead = std::mem::replace(&mut list[i], Polynomial::zero());
        list[i - 2] = list[i - 2].add(&lead.try_mul(&rest).ok()?);
        quotient[i - 2] = lead;
    }
    let is_free = list.iter().skip(1).all(Polynomial::is_zero);
    let remainder = list.into_iter().next().unwrap_or_else(Polynomial::zero);
    is_free.then(|| (Polynomial::from_coefficients_in(other, &quotient), remainder))
}

/// The absolute value of a polynomial in one variable at a number, beside that of its terms.
fn size_at(p: &Polynomial, variable: u32, x: f64) -> f64 {
    let (mut value, mut terms) = (0.0, 0.0);
    for c in p.coefficients_in(variable).iter().rev() {
        let c = f64::rounding_from(&c.constant_term(), RoundingMode::Nearest).0;
        value = value * x + c;
        terms = terms * x.abs() + c.abs();
    }
    (value / terms).abs()
}
