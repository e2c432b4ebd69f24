//! Limits at infinity by series in t = 1/n.
//!
//! Contract: [`Engine::limit_by_series`] returns the limit of a form as its variable n grows, or that
//! it is infinite, or `None` where this method does not reach.
//!
//! Why it is right: a constant power c^E with c > 0 is exp(E·ln c); sums, products, quotients with a
//! leading coefficient that cannot vanish, ln of a series with a positive constant term and exp of a
//! series without pole are analytic in t near 0 apart from a pole, and their Laurent coefficients are
//! those of the formal operations. exp(c/t^k + …) with c < 0 vanishes faster than every power of t.
//! So the value tends, as t falls to 0, to the coefficient of t^0 where there is no pole. Coefficients
//! are forms: that one is zero is decided by their normal form, that one is positive by the prover.
//! A coefficient may hold powers of ln n, which grow slower than every power of n: times a positive
//! power of t they vanish. Where a sign, or the limit itself, would depend on ln n, there is no answer.
//!
//! Cost: a fixed number of coefficients ([`TERMS`]), each a form in the other variables and their
//! logarithms.

use super::context::*;
use crate::algebra::form::{Atom, AtomId, Exponent, Form};
use crate::claim::syntax::Relation;
use malachite::Rational;
use malachite::base::num::basic::traits::{One, Zero};

type Result<T> = std::result::Result<T, Failure>;

/// How many coefficients are kept.
const TERMS: usize = 5;

/// The highest power of t by which a rational power may shift a series.
const SHIFT: i64 = 200;

/// Σ terms\[k\]·t^(order + k), up to O(t^(order + number of terms)); the first term is not zero.
#[derive(Clone, Debug)]
struct Series {
    order: i64,
    terms: Vec<Form>,
}

/// What a form tends to.
#[derive(Clone, Debug, PartialEq)]
pub enum Tends {
    /// To this value.
    To(Form),
    /// Beyond every bound.
    Infinitely,
}

impl Series {
    fn constant(value: Form) -> Series {
        let mut terms = vec![Form::integer(0); TERMS];
        terms[0] = value;
        Series { order: 0, terms }.stripped()
    }

    fn end(&self) -> i64 {
        self.order + i64::try_from(self.terms.len()).unwrap_or(i64::MAX / 2)
    }

    fn stripped(mut self) -> Series {
        let zeros = self.terms.iter().take_while(|c| c.is_zero()).count();
        self.terms.drain(..zeros);
        self.order += i64::try_from(zeros).unwrap_or(0);
        self
    }

    fn at(&self, power: i64) -> Form {
        usize::try_from(power - self.order)
            .ok()
            .and_then(|k| self.terms.get(k).cloned())
            .unwrap_or_else(|| Form::integer(0))
    }
}

impl Engine {
    /// The limit of a form as the variable grows through all large values.
    pub fn limit_by_series(&mut self, cx: &mut Context, form: &Form, name: &str) -> Result<Option<Tends>> {
        let variable = self.ring.intern(Atom::Variable(name.to_string()));
        let Some(series) = self.series_of(cx, form, variable)? else {
            // What grows like an exponential has a reciprocal that tends to 0; what may be 0 has none.
            if !self.not_zero(cx, form)? {
                return Ok(None);
            }
            let reciprocal = self.ring.inverse(form)?;
            let vanishes = self.series_of(cx, &reciprocal, variable)?.is_some_and(|s| s.order > 0);
            return Ok(vanishes.then_some(Tends::Infinitely));
        };
        if series.end() <= 0 {
            return Ok(None);
        }
        if series.terms.first().is_some_and(|c| series.order <= 0 && self.depends(c, variable)) {
            return Ok(None);
        }
        if series.order < 0 {
            return Ok(self.not_zero(cx, &series.terms[0])?.then_some(Tends::Infinitely));
        }
        Ok(Some(Tends::To(series.at(0))))
    }

    /// Whether a coefficient holds ln n.
    fn depends(&self, coefficient: &Form, n: AtomId) -> bool {
        self.ring.mentions(coefficient, &|a| a == n)
    }

    fn not_zero(&mut self, cx: &mut Context, form: &Form) -> Result<bool> {
        Ok(self.searched_form_signs(cx, form)?.within(Signs::NOT_ZERO))
    }

    fn shown_positive(&mut self, cx: &mut Context, form: &Form) -> Result<bool> {
        Ok(self.searched_form_signs(cx, form)?.within(Signs::POSITIVE))
    }

    fn series_of(&mut self, cx: &mut Context, form: &Form, n: AtomId) -> Result<Option<Series>> {
        self.tick()?;
        let mut product = Series::constant(Form::number(form.coefficient.clone()));
        let mut log: Option<Series> = None;
        // The power of t from factors that are no series by themselves: √n, n^(1/n).
        let mut shift = Rational::ZERO;
        for (atom, exponent) in form.powers.clone() {
            let factor = Form { coefficient: Rational::ONE, powers: vec![(atom, exponent.clone())] };
            if !self.ring.mentions(&factor, &|a| a == n) {
                product = self.series_product(&product, &Series::constant(factor))?;
                continue;
            }
            let Some(base) = self.series_of_atom(cx, atom, n)? else { return Ok(None) };
            match &exponent {
                Exponent::Number(q) => {
                    let base = if i64::try_from(q).is_ok() {
                        base
                    } else {
                        shift += q * Rational::from(base.order);
                        Series { order: 0, terms: base.terms }
                    };
                    let Some(power) = self.series_power(cx, &base, q, n)? else { return Ok(None) };
                    product = self.series_product(&product, &power)?;
                }
                Exponent::Symbolic(symbolic) => {
                    let Some(log_base) = self.series_logarithm(cx, &base, n)? else { return Ok(None) };
                    let Some(times) = self.series_of(cx, symbolic, n)? else { return Ok(None) };
                    let summand = self.series_product(&log_base, &times)?;
                    log = Some(match log {
                        None => summand,
                        Some(sum) => self.series_sum(&[sum, summand])?,
                    });
                }
            }
        }
        if let Some(mut log) = log {
            shift -= self.take_logarithm(&mut log, n)?;
            let Some(power) = self.series_exponential(cx, &log, n)? else { return Ok(None) };
            product = self.series_product(&product, &power)?;
        }
        match i64::try_from(&shift) {
            Ok(k) if k.abs() <= SHIFT => product.order += k,
            _ => return Ok(None),
        }
        Ok(Some(product))
    }

    /// Takes the summand k·ln n out of the constant term and returns k: exp(k·ln n) = t^(−k).
    fn take_logarithm(&mut self, s: &mut Series, n: AtomId) -> Result<Rational> {
        let growing = Form::atom(self.ring.intern(Atom::Logarithm(n)));
        let place = usize::try_from(-s.order).ok().filter(|place| *place < s.terms.len());
        let Some(place) = place else { return Ok(Rational::ZERO) };
        let mut k = Rational::ZERO;
        let mut rest = Vec::new();
        for summand in self.ring.summands(&s.terms[place])? {
            if summand.powers == growing.powers {
                k += summand.coefficient;
            } else {
                rest.push(summand);
            }
        }
        s.terms[place] = self.ring.add(&rest)?;
        *s = s.clone().stripped();
        Ok(k)
    }

    fn series_of_atom(&mut self, cx: &mut Context, atom: AtomId, n: AtomId) -> Result<Option<Series>> {
        if atom == n {
            let mut series = Series::constant(Form::integer(1));
            series.order = -1;
            return Ok(Some(series));
        }
        if !self.ring.atom_mentions(atom, &|a| a == n) {
            return Ok(Some(Series::constant(Form::atom(atom))));
        }
        match &*self.ring.atom(atom) {
            Atom::Sum(poly) => {
                let mut sum = Vec::with_capacity(poly.terms.len());
                for (monomial, c) in &poly.terms {
                    let term = Form { coefficient: c.clone(), powers: monomial.clone() };
                    let Some(series) = self.series_of(cx, &term, n)? else { return Ok(None) };
                    sum.push(series);
                }
                Ok(Some(self.series_sum(&sum)?))
            }
            Atom::Logarithm(inner) => {
                let Some(series) = self.series_of_atom(cx, *inner, n)? else { return Ok(None) };
                self.series_logarithm(cx, &series, n)
            }
            _ => Ok(None),
        }
    }

    fn series_sum(&mut self, list: &[Series]) -> Result<Series> {
        let order = list.iter().map(|s| s.order).min().unwrap_or(0);
        let end = list.iter().map(Series::end).min().unwrap_or(0);
        let mut terms = Vec::new();
        for power in order..end {
            let parts: Vec<Form> = list.iter().map(|s| s.at(power)).collect();
            terms.push(self.ring.add(&parts)?);
        }
        Ok(Series { order: order.min(end), terms }.stripped())
    }

    fn series_product(&mut self, a: &Series, b: &Series) -> Result<Series> {
        let length = a.terms.len().min(b.terms.len());
        let mut terms = Vec::with_capacity(length);
        for k in 0..length {
            let mut parts = Vec::with_capacity(k + 1);
            for i in 0..=k {
                parts.push(self.ring.mul(&a.terms[i], &b.terms[k - i])?);
            }
            terms.push(self.ring.add(&parts)?);
        }
        Ok(Series { order: a.order + b.order, terms }.stripped())
    }

    /// s/c·t^(−order) − 1 for the leading coefficient c.
    fn series_rest(&mut self, s: &Series, lead: &Form) -> Result<Series> {
        let mut terms = vec![Form::integer(0)];
        for c in &s.terms[1..] {
            terms.push(self.ring.div(c, lead)?);
        }
        Ok(Series { order: 0, terms }.stripped())
    }

    /// Σ coefficients\[k\]·u^k, for u without constant term.
    fn series_compose(&mut self, coefficients: &[Rational], u: &Series) -> Result<Series> {
        let mut power = Series::constant(Form::integer(1));
        let mut sum = Vec::new();
        for c in coefficients {
            sum.push(self.series_product(&power, &Series::constant(Form::number(c.clone())))?);
            power = self.series_product(&power, u)?;
        }
        // The series that is cut off starts with u to the number of coefficients.
        let end = u.order.saturating_mul(i64::try_from(coefficients.len()).unwrap_or(1)).min(u.end());
        sum.push(Series { order: end, terms: Vec::new() });
        self.series_sum(&sum)
    }

    fn series_logarithm(&mut self, cx: &mut Context, s: &Series, n: AtomId) -> Result<Option<Series>> {
        let Some(lead) = s.terms.first().cloned() else { return Ok(None) };
        if self.depends(&lead, n) || !self.shown_positive(cx, &lead)? {
            return Ok(None);
        }
        let mut conditions = Vec::new();
        let mut constant = self.logarithm(cx, &lead, "a leading coefficient", &mut conditions)?;
        self.show_conditions(cx, conditions)?;
        if s.order != 0 {
            // ln(t^k) = −k·ln n.
            let growing = Form::atom(self.ring.intern(Atom::Logarithm(n)));
            let growing = self.ring.mul(&growing, &Form::integer(-s.order))?;
            constant = self.ring.add(&[constant, growing])?;
        }
        let u = self.series_rest(s, &lead)?;
        let mut coefficients = vec![Rational::from(0)];
        for k in 1..i64::try_from(TERMS).unwrap_or(1) {
            coefficients.push(Rational::from_signeds(if k % 2 == 1 { 1 } else { -1 }, k));
        }
        let rest = self.series_compose(&coefficients, &u)?;
        Ok(Some(self.series_sum(&[Series::constant(constant), rest])?))
    }

    fn series_exponential(&mut self, cx: &mut Context, s: &Series, n: AtomId) -> Result<Option<Series>> {
        if s.end() <= 0 || (s.order..=0).any(|k| self.depends(&s.at(k), n)) {
            return Ok(None);
        }
        if s.order < 0 {
            // The sign of the leading coefficient c is that of e^c − 1.
            let power = self.exponential(&s.terms[0])?;
            let difference = self.ring.sub(&power, &Form::integer(1))?;
            let negative = self.searched_form_signs(cx, &difference)?.within(Signs::of(Relation::Less));
            let vanishing = Series { order: i64::try_from(TERMS).unwrap_or(1), terms: Vec::new() };
            return Ok(negative.then_some(vanishing));
        }
        let constant = self.exponential(&s.at(0))?;
        let mut u = s.clone();
        if u.order == 0 && !u.terms.is_empty() {
            u.terms[0] = Form::integer(0);
            u = u.stripped();
        }
        let mut coefficients = vec![Rational::ONE];
        for k in 1..i64::try_from(TERMS).unwrap_or(1) {
            let last = coefficients.last().cloned().unwrap_or(Rational::ONE);
            coefficients.push(last / Rational::from(k));
        }
        let power = self.series_compose(&coefficients, &u)?;
        Ok(Some(self.series_product(&Series::constant(constant), &power)?))
    }

    fn series_power(&mut self, cx: &mut Context, s: &Series, q: &Rational, n: AtomId) -> Result<Option<Series>> {
        if let Ok(k @ 1..=SHIFT) = i64::try_from(q) {
            let mut power = s.clone();
            for _ in 1..k {
                power = self.series_product(&power, s)?;
            }
            return Ok(Some(power));
        }
        let Some(lead) = s.terms.first().cloned() else { return Ok(None) };
        let Ok(order) = i64::try_from(&(q * Rational::from(s.order))) else { return Ok(None) };
        let whole = i64::try_from(q).is_ok();
        if self.depends(&lead, n) {
            return Ok(None);
        }
        let fine = if whole { self.not_zero(cx, &lead)? } else { self.shown_positive(cx, &lead)? };
        if !fine || order.abs() > SHIFT {
            return Ok(None);
        }
        let mut conditions = Vec::new();
        let power = self.raise(cx, &lead, &Form::number(q.clone()), "a leading coefficient", &mut conditions)?;
        self.show_conditions(cx, conditions)?;
        // (1 + u)^q by the binomial series.
        let u = self.series_rest(s, &lead)?;
        let mut coefficients = vec![Rational::ONE];
        for k in 1..i64::try_from(TERMS).unwrap_or(1) {
            let last = coefficients.last().cloned().unwrap_or(Rational::ONE);
            coefficients.push(last * (q - Rational::from(k - 1)) / Rational::from(k));
        }
        let mut rest = self.series_compose(&coefficients, &u)?;
        rest.order += order;
        Ok(Some(self.series_product(&Series::constant(power), &rest)?))
    }
}
