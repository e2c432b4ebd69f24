//! Powers, exponentials and logarithms of fractions.
//!
//! b^E with a whole number E is multiplied out, and (−1)^E is a product of (−1)^m for products m of natural numbers. With
//! an exponent that is a sum of natural monomials with positive whole coefficients, b^(E + F) = b^E·b^F, (b·c)^E = b^E·c^E and (b^E)^F = b^(E·F) hold for every b (0^0 = 1). Any other exponent
//! that is not whole by its form needs b > 0 (or b ≥ 0 under a root of numerals), and then b^(E + F) = b^E·b^F holds as
//! well. b^(−E) = 1/b^E holds wherever b^(−E) has a value, also for b = 0 and E = 0. Other exponents that may be negative
//! whole numbers stay whole: b may be 0 there.

use super::fraction::{Fraction, Monomial, Poly};
use super::known::Written;
use super::term::Atom;
use super::{Checker, Reason, Refusal, rejected};
use crate::claim::syntax::*;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed};

impl Checker {
    /// cosh x = (e^x + e^−x)/2, sinh x = (e^x − e^−x)/2, sech and tanh by them; equations for exp(x) and exp(−x) are
    /// put in.
    pub(super) fn hyperbolic(
        &mut self,
        name: &str,
        argument: &Expr,
        x: &Fraction,
        depth: usize,
    ) -> Result<Fraction, Refusal> {
        let equations = std::mem::take(&mut self.put_in);
        let plain = self.scalar_in(argument, depth);
        self.put_in = equations;
        let plain = plain?;
        let mut powers = Vec::new();
        for (plain, x) in [(plain.clone(), x.clone()), (plain.negated(), x.negated())] {
            powers.push(match self.put_in_written(&Written::Exponential(plain)) {
                Some(value) => value,
                None => self.exponential(&x)?,
            });
        }
        let half = Fraction::integer(2).power(-1)?;
        let sum = Fraction::sum(&powers, &self.work)?.times(&half, &self.work)?;
        if let Some(last) = powers.last_mut() {
            *last = last.negated();
        }
        let difference = Fraction::sum(&powers, &self.work)?.times(&half, &self.work)?;
        Ok(match name {
            "cosh" => sum,
            "sinh" => difference,
            "sech" => sum.power(-1)?,
            _ => difference.times(&sum.power(-1)?, &self.work)?,
        })
    }

    /// A polynomial with whole coefficients in natural atoms: a whole number, which may be negative.
    pub(super) fn whole(&mut self, f: &Fraction) -> Result<Poly, Refusal> {
        match f.expanded(&self.work) {
            Ok(poly) if poly.terms().all(|t| t.1.is_integer()) && poly.atoms().all(|a| self.is_natural_atom(a)) => {
                Ok(poly)
            }
            Ok(_) | Err(Refusal::Rejected(_)) => rejected(Reason::NotWhole),
            Err(limit) => Err(limit),
        }
    }

    pub(super) fn monomial(&self, monomial: &Monomial) -> Result<Fraction, Refusal> {
        let mut out = Fraction::integer(1);
        for (atom, k) in monomial {
            out.multiply(&Fraction::atom(*atom).power(i64::from(*k))?, &self.work)?;
        }
        Ok(out)
    }

    /// The polynomial, if there are no divisors.
    pub(super) fn polynomial(&self, f: &Fraction) -> Result<Option<Poly>, Refusal> {
        if f.factors.values().any(|k| *k < 0) { Ok(None) } else { Ok(Some(f.expanded(&self.work)?)) }
    }

    /// b^E.
    pub(super) fn power(&mut self, base: &Fraction, exponent: &Fraction) -> Result<Fraction, Refusal> {
        if let Some(k) = exponent.as_integer() {
            return base.power(k);
        }
        if base.as_integer() == Some(1) {
            return Ok(Fraction::integer(1));
        }
        if let (Some(-1), Some(k)) = (base.as_integer(), exponent.as_number().filter(|k| k.is_integer())) {
            return Ok(Fraction::integer(if k.numer().bit(0) { -1 } else { 1 }));
        }
        if self.is_whole(exponent)? {
            let poly = exponent.expanded(&self.work)?;
            return if base.as_integer() == Some(-1) {
                self.sign_power(&poly)
            } else if poly.terms().all(|(_, c)| c.is_positive()) {
                self.natural_power(base, exponent, &poly)
            } else if poly.terms().all(|(_, c)| c.is_negative()) {
                Ok(self.power(base, &exponent.negated())?.power(-1)?)
            } else {
                // A whole number that may be negative.
                Ok(self.atom_fraction(Atom::Power(base.clone(), exponent.clone())))
            };
        }
        let mut out = Fraction::integer(1);
        for part in self.summands(exponent)? {
            let factor = if self.is_whole(&part)? { self.power(base, &part)? } else { self.real_power(base, &part)? };
            out.multiply(&factor, &self.work)?;
        }
        Ok(out)
    }

    /// (−1)^E for a whole number E: a term of E counts where its coefficient is odd, for (−1)^(2·m) = 1 and (−1)^(−m) = (−1)^m.
    fn sign_power(&mut self, exponent: &Poly) -> Result<Fraction, Refusal> {
        let mut out = Fraction::integer(1);
        for (monomial, _) in exponent.terms().filter(|(_, c)| c.numer().bit(0)) {
            let factor = match self.monomial(monomial)? {
                one if one.as_integer().is_some() => Fraction::integer(-1),
                monomial => self.atom_fraction(Atom::Power(Fraction::integer(-1), monomial)),
            };
            out.multiply(&factor, &self.work)?;
        }
        Ok(out)
    }

    /// Whether an exponent is a whole number by its form.
    pub(super) fn is_whole(&self, exponent: &Fraction) -> Result<bool, Refusal> {
        Ok(match self.polynomial(exponent)? {
            Some(poly) => poly.terms().all(|t| t.1.is_integer()) && poly.atoms().all(|a| self.is_natural_atom(a)),
            None => false,
        })
    }

    /// b^E where E is not a whole number, so that b > 0, or b ≥ 0 and E is a positive numeral.
    ///
    /// If b is itself c^F with F not whole, or exp F, both are positive or c = 0 under positive numerals:
    /// (c^F)^E = c^(F·E). And b^(p·F/q) = (b^(F/q))^p.
    pub(super) fn real_power(&mut self, base: &Fraction, exponent: &Fraction) -> Result<Fraction, Refusal> {
        if let (true, Some((poly, k)), 1) = (base.coefficient.is_one(), base.factors.iter().next(), base.factors.len())
        {
            let all = exponent.times(&Fraction::integer(*k), &self.work)?;
            match poly.single_atom().and_then(|place| self.atoms.get(place)).cloned() {
                Some(Atom::Power(inner, e)) if !self.is_whole(&e)? => {
                    let product = e.times(&all, &self.work)?;
                    return self.power(&inner, &product);
                }
                Some(Atom::Exponential(log)) => {
                    let product = log.times(&all, &self.work)?;
                    return self.exponential(&product);
                }
                _ => {}
            }
        }
        let (top, rest) = numerator_apart(exponent);
        let atom = Atom::Power(base.clone(), rest);
        self.atom_fraction(atom).power(top)
    }

    /// b^E for a sum E of natural monomials, by the factors of b. Factors that are exponentials or powers with a
    /// symbolic exponent that is not whole are positive, so that (c^F)^E = c^(F·E).
    fn natural_power(&mut self, base: &Fraction, exponent: &Fraction, poly: &Poly) -> Result<Fraction, Refusal> {
        let mut monomials = Vec::new();
        for (monomial, c) in poly.terms() {
            let Ok(k) = i64::try_from(c.numer()) else { return Err(Refusal::Limit("digits")) };
            monomials.push((self.monomial(monomial)?, k));
        }
        let plain = |checker: &mut Checker, factor: &Fraction| -> Result<Fraction, Refusal> {
            let mut out = Fraction::integer(1);
            for (monomial, k) in &monomials {
                let power = match monomial.as_integer() {
                    Some(_) => factor.power(*k)?,
                    None => checker.atom_fraction(Atom::Power(factor.clone(), monomial.clone())).power(*k)?,
                };
                out.multiply(&power, &checker.work)?;
            }
            Ok(out)
        };
        if base.is_zero() {
            return plain(self, base);
        }
        let mut out = Fraction::integer(1);
        if base.coefficient.is_negative() {
            out = self.sign_power(poly)?;
        }
        for (prime, k) in base.prime_powers(&self.work)? {
            let prime = Fraction::number(BigRational::from_integer(prime));
            out.multiply(&plain(self, &prime)?.power(k)?, &self.work)?;
        }
        for (poly, k) in &base.factors {
            let factor = match poly.single_atom().and_then(|place| self.atoms.get(place)).cloned() {
                Some(Atom::Exponential(log)) => {
                    let product = log.times(exponent, &self.work)?;
                    self.exponential(&product)?
                }
                Some(Atom::Power(inner, e)) if e.as_number().is_none() && !self.is_whole(&e)? => {
                    let product = e.times(exponent, &self.work)?;
                    self.power(&inner, &product)?
                }
                Some(Atom::Power(inner, e)) if self.is_whole(&e)? => {
                    // Natural exponents multiply: (c^F)^m = c^(F·m) for each monomial m.
                    let mut out = Fraction::integer(1);
                    for (monomial, k) in &monomials {
                        let atom = Atom::Power(inner.clone(), e.times(monomial, &self.work)?);
                        out.multiply(&self.atom_fraction(atom).power(*k)?, &self.work)?;
                    }
                    out
                }
                _ => plain(self, &Fraction::of(poly))?,
            };
            out.multiply(&factor.power(*k)?, &self.work)?;
        }
        Ok(out)
    }

    /// The terms of a fraction whose divisors are atoms: those of what they divide, each over them. Itself where it has another
    /// divisor.
    pub(super) fn summands(&self, f: &Fraction) -> Result<Vec<Fraction>, Refusal> {
        let (mut above, mut below) = (f.clone(), Fraction::integer(1));
        above.factors.retain(|_, k| *k > 0);
        for (poly, k) in f.factors.iter().filter(|(_, k)| **k < 0) {
            if poly.single_atom().is_none() {
                return Ok(vec![f.clone()]);
            }
            below.multiply(&Fraction::of(poly).power(*k)?, &self.work)?;
        }
        let term = |(monomial, c): (&Monomial, &BigRational)| {
            self.monomial(monomial)?.times(&Fraction::number(c.clone()), &self.work)?.times(&below, &self.work)
        };
        above.expanded(&self.work)?.terms().map(term).collect()
    }

    /// exp of a fraction: exp(E + F) = exp E·exp F, exp(p·F/q) = exp(F/q)^p,
    /// exp(E·ln x) = x^E, for x > 0 where ln x has a value.
    pub(super) fn exponential(&mut self, log: &Fraction) -> Result<Fraction, Refusal> {
        if log.is_zero() {
            return Ok(Fraction::integer(1));
        }
        let mut out = Fraction::integer(1);
        for part in self.summands(log)? {
            let mut logs = part.factors.iter().filter_map(|(poly, k)| {
                match poly.single_atom().and_then(|place| self.atoms.get(place)) {
                    Some(Atom::Logarithm(x)) if *k == 1 => Some((poly.clone(), x.clone())),
                    _ => None,
                }
            });
            let value = match (logs.next(), logs.next()) {
                (Some((poly, x)), None) => {
                    let mut exponent = part.clone();
                    exponent.factors.remove(&poly);
                    self.power(&x, &exponent)?
                }
                _ => {
                    let (top, rest) = numerator_apart(&part);
                    self.atom_fraction(Atom::Exponential(rest)).power(top)?
                }
            };
            out.multiply(&value, &self.work)?;
        }
        Ok(out)
    }

    /// ln of a fraction; ln exp E = E, and ln b^E = E·ln b where E is not whole, so that b > 0.
    pub(super) fn logarithm(&mut self, x: &Fraction) -> Result<Fraction, Refusal> {
        if x.as_integer() == Some(1) {
            return Ok(Fraction::integer(0));
        }
        if let (true, Some((poly, k)), 1) = (x.coefficient.is_one(), x.factors.iter().next(), x.factors.len()) {
            let k = Fraction::integer(*k);
            match poly.single_atom().and_then(|place| self.atoms.get(place)).cloned() {
                Some(Atom::Exponential(log)) => return log.times(&k, &self.work),
                Some(Atom::Power(base, e)) if !self.is_whole(&e)? => {
                    let log = self.logarithm(&base)?;
                    return log.times(&e, &self.work)?.times(&k, &self.work);
                }
                _ => {}
            }
        }
        Ok(self.atom_fraction(Atom::Logarithm(x.clone())))
    }
}

/// The greatest numerator of an exponent that becomes a power: what is multiplied out has exponents below [`EXPONENT_LIMIT`](super::fraction::EXPONENT_LIMIT).
const NUMERATOR_LIMIT: u64 = 100;

/// p and F/q of p·F/q, p and q positive or negative whole numbers without common divisor; p is 1 or −1 where it is above
/// [`NUMERATOR_LIMIT`].
pub(super) fn numerator_apart(f: &Fraction) -> (i64, Fraction) {
    let top = f.coefficient.numer();
    let short = i64::try_from(top).ok().filter(|top| (1..=NUMERATOR_LIMIT).contains(&top.unsigned_abs()));
    let top = short.unwrap_or(if top.is_negative() { -1 } else { 1 });
    let mut rest = f.clone();
    rest.coefficient /= BigRational::from_integer(BigInt::from(top));
    (top, rest)
}
