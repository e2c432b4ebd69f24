//! Sparse polynomials over the rationals, and quotients of them kept in factors.
//!
//! Contract: a [`Poly`] holds no zero coefficient; a [`Fraction`] is c·∏ pᵢ^kᵢ with polynomials that
//! are not constant, have leading coefficient 1 and, but for single atoms, no atom as a factor, and
//! whole exponents kᵢ ≠ 0; zero has no factors. Atoms are numbers that somebody else gives a meaning.
//! No common divisor is ever sought: two fractions are equal iff their difference, with the common
//! factors set aside and the rest multiplied out, has no terms.
//!
//! Every product of two terms is counted in [`Work`], so that time and memory are bounded.

use super::{Failure, declined};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use std::collections::BTreeMap;

/// The most products of terms in the check of one certificate.
pub const WORK_LIMIT: u64 = 20_000_000;
/// The most terms of a polynomial.
pub const TERMS_LIMIT: usize = 20_000;
/// The largest exponent of a factor or an atom.
pub const EXPONENT_LIMIT: i64 = 1_000;
/// The most bits of a numerator or denominator.
pub const BITS_LIMIT: u64 = 200_000;

/// Counts products of terms.
#[derive(Clone, Debug, Default)]
pub struct Work(u64);

impl Work {
    /// Counts some work.
    pub fn count(&mut self, amount: usize) -> Result<(), Failure> {
        self.0 = self.0.saturating_add(u64::try_from(amount).unwrap_or(u64::MAX));
        if self.0 > WORK_LIMIT { declined("work") } else { Ok(()) }
    }
}

/// Atoms with positive exponents, in increasing order of the atoms.
pub type Monomial = Vec<(usize, u32)>;

/// A polynomial.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Default)]
pub struct Poly(BTreeMap<Monomial, BigRational>);

impl Poly {
    /// A constant.
    pub fn constant(c: BigRational) -> Poly {
        let mut out = Poly::default();
        out.add_term(Vec::new(), c);
        out
    }

    /// An atom.
    pub fn atom(atom: usize) -> Poly {
        Poly(BTreeMap::from([(vec![(atom, 1)], BigRational::one())]))
    }

    /// The terms.
    pub fn terms(&self) -> impl Iterator<Item = (&Monomial, &BigRational)> {
        self.0.iter()
    }

    /// The atom, if the polynomial is a single one.
    pub fn single_atom(&self) -> Option<usize> {
        match self.0.iter().next() {
            Some((monomial, c)) if self.0.len() == 1 && c.is_one() => match monomial.as_slice() {
                [(atom, 1)] => Some(*atom),
                _ => None,
            },
            _ => None,
        }
    }

    /// Every atom that occurs.
    pub fn atoms(&self) -> impl Iterator<Item = usize> {
        self.0.keys().flatten().map(|power| power.0)
    }

    fn add_term(&mut self, monomial: Monomial, c: BigRational) {
        let sum = self.0.remove(&monomial).unwrap_or_else(BigRational::zero) + c;
        if !sum.is_zero() {
            self.0.insert(monomial, sum);
        }
    }

    /// The product.
    pub fn times(&self, other: &Poly, work: &mut Work) -> Result<Poly, Failure> {
        work.count(self.0.len().saturating_mul(other.0.len()))?;
        let mut out = Poly::default();
        for (m, c) in &self.0 {
            for (n, d) in &other.0 {
                let product = c * d;
                if product.numer().bits().max(product.denom().bits()) > BITS_LIMIT {
                    return declined("digits");
                }
                let mut powers: BTreeMap<usize, u32> = m.iter().copied().collect();
                for (atom, k) in n {
                    let sum = powers.get(atom).copied().unwrap_or(0).saturating_add(*k);
                    if i64::from(sum) > EXPONENT_LIMIT {
                        return declined("degree");
                    }
                    powers.insert(*atom, sum);
                }
                out.add_term(powers.into_iter().collect(), product);
            }
        }
        if out.0.len() > TERMS_LIMIT { declined("terms") } else { Ok(out) }
    }

    /// The partial derivative.
    pub fn derivative(&self, atom: usize) -> Poly {
        let mut out = Poly::default();
        for (monomial, c) in &self.0 {
            let Some((_, k)) = monomial.iter().find(|p| p.0 == atom) else { continue };
            let lower =
                monomial.iter().map(|p| if p.0 == atom { (p.0, p.1 - 1) } else { *p }).filter(|p| p.1 > 0).collect();
            out.add_term(lower, c * BigRational::from_integer(BigInt::from(*k)));
        }
        out
    }

    /// The coefficients by powers of an atom.
    pub fn coefficients(&self, atom: usize) -> BTreeMap<u32, Poly> {
        let mut out: BTreeMap<u32, Poly> = BTreeMap::new();
        for (monomial, c) in &self.0 {
            let k = monomial.iter().find(|p| p.0 == atom).map_or(0, |p| p.1);
            let rest = monomial.iter().copied().filter(|p| p.0 != atom).collect();
            out.entry(k).or_default().add_term(rest, c.clone());
        }
        out
    }
}

/// A quotient of polynomials in factors.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Fraction {
    /// The rational factor.
    pub coefficient: BigRational,
    /// The other factors with their exponents.
    pub factors: BTreeMap<Poly, i64>,
}

impl Fraction {
    /// A number.
    pub fn number(coefficient: BigRational) -> Fraction {
        Fraction { coefficient, factors: BTreeMap::new() }
    }

    /// A whole number.
    pub fn integer(k: i64) -> Fraction {
        Fraction::number(BigRational::from_integer(BigInt::from(k)))
    }

    /// An atom.
    pub fn atom(atom: usize) -> Fraction {
        Fraction { coefficient: BigRational::one(), factors: BTreeMap::from([(Poly::atom(atom), 1)]) }
    }

    /// A polynomial: its number, its atoms and what is left become factors.
    pub fn of(poly: &Poly) -> Fraction {
        let Some((_, lead)) = poly.0.iter().next_back() else { return Fraction::integer(0) };
        let mut out = Fraction::number(lead.clone());
        let mut common: BTreeMap<usize, u32> = BTreeMap::new();
        for (place, monomial) in poly.0.keys().enumerate() {
            let powers: BTreeMap<usize, u32> = monomial.iter().copied().collect();
            if place == 0 {
                common = powers;
            } else {
                common.retain(|atom, k| {
                    *k = (*k).min(powers.get(atom).copied().unwrap_or(0));
                    *k > 0
                });
            }
        }
        let mut rest = Poly::default();
        for (monomial, c) in &poly.0 {
            let lower = monomial
                .iter()
                .map(|(atom, k)| (*atom, k - common.get(atom).copied().unwrap_or(0)))
                .filter(|p| p.1 > 0)
                .collect();
            rest.add_term(lower, c / lead);
        }
        for (atom, k) in common {
            out.factors.insert(Poly::atom(atom), i64::from(k));
        }
        if rest.atoms().next().is_some() {
            out.put(&rest, 1);
        }
        out
    }

    fn put(&mut self, poly: &Poly, k: i64) {
        let sum = self.factors.remove(poly).unwrap_or(0).saturating_add(k);
        if sum != 0 {
            self.factors.insert(poly.clone(), sum);
        }
    }

    /// Whether it is 0.
    pub fn is_zero(&self) -> bool {
        self.coefficient.is_zero()
    }

    /// The number, if it is one.
    pub fn as_number(&self) -> Option<&BigRational> {
        if self.factors.is_empty() { Some(&self.coefficient) } else { None }
    }

    /// The whole number of moderate size, if it is one.
    pub fn as_integer(&self) -> Option<i64> {
        let number = self.as_number()?;
        if number.is_integer() { i64::try_from(number.numer()).ok() } else { None }
    }

    /// Every atom that occurs.
    pub fn atoms(&self) -> impl Iterator<Item = usize> {
        self.factors.keys().flat_map(Poly::atoms)
    }

    /// The product.
    pub fn times(&self, other: &Fraction) -> Fraction {
        if self.is_zero() || other.is_zero() {
            return Fraction::integer(0);
        }
        let mut out = self.clone();
        out.coefficient *= &other.coefficient;
        for (poly, k) in &other.factors {
            out.put(poly, *k);
        }
        out
    }

    /// The whole power; 0 has positive powers only, and the power 0.
    pub fn power(&self, k: i64) -> Result<Fraction, Failure> {
        if k == 0 {
            return Ok(Fraction::integer(1));
        }
        if self.is_zero() {
            return if k > 0 { Ok(Fraction::integer(0)) } else { super::rejected("a division by 0") };
        }
        let bits = self.coefficient.numer().bits().max(self.coefficient.denom().bits());
        let Ok(small) = i32::try_from(k) else { return declined("degree") };
        if bits.saturating_mul(k.unsigned_abs()) > BITS_LIMIT {
            return declined("digits");
        }
        let mut out = Fraction::number(self.coefficient.pow(small));
        for (poly, j) in &self.factors {
            match j.checked_mul(k) {
                Some(j) if j.abs() <= EXPONENT_LIMIT => out.factors.insert(poly.clone(), j),
                _ => return declined("degree"),
            };
        }
        Ok(out)
    }

    /// The opposite.
    pub fn negated(&self) -> Fraction {
        Fraction { coefficient: -self.coefficient.clone(), factors: self.factors.clone() }
    }

    /// The sum: what all summands share is set aside, the rest multiplied out.
    pub fn sum(list: &[Fraction], work: &mut Work) -> Result<Fraction, Failure> {
        let list: Vec<&Fraction> = list.iter().filter(|f| !f.is_zero()).collect();
        let Some(first) = list.first() else { return Ok(Fraction::integer(0)) };
        if list.len() == 1 {
            return Ok((*first).clone());
        }
        let mut common = Fraction::integer(1);
        for poly in list.iter().flat_map(|f| f.factors.keys()) {
            let least = list.iter().map(|f| f.factors.get(poly).copied().unwrap_or(0)).min().unwrap_or(0);
            if least != 0 {
                common.factors.insert(poly.clone(), least);
            }
        }
        let mut sum = Poly::default();
        for fraction in &list {
            let rest = fraction.times(&common.power(-1)?);
            for (monomial, c) in rest.expanded(work)?.0 {
                sum.add_term(monomial, c);
            }
        }
        Ok(Fraction::of(&sum).times(&common))
    }

    /// The difference.
    pub fn minus(&self, other: &Fraction, work: &mut Work) -> Result<Fraction, Failure> {
        Fraction::sum(&[self.clone(), other.negated()], work)
    }

    /// The polynomial; a fraction with denominators is none.
    pub fn expanded(&self, work: &mut Work) -> Result<Poly, Failure> {
        let mut out = Poly::constant(self.coefficient.clone());
        for (poly, k) in &self.factors {
            if *k < 0 || *k > EXPONENT_LIMIT {
                return super::rejected("a polynomial is needed where a fraction stands");
            }
            for _ in 0..*k {
                out = out.times(poly, work)?;
            }
        }
        Ok(out)
    }

    /// Numerator and denominator, multiplied out.
    pub fn parts(&self, work: &mut Work) -> Result<(Poly, Poly), Failure> {
        let mut top = Fraction::number(self.coefficient.clone());
        let mut bottom = Fraction::integer(1);
        for (poly, k) in &self.factors {
            let (side, k) = if *k > 0 { (&mut top, *k) } else { (&mut bottom, k.saturating_neg()) };
            side.factors.insert(poly.clone(), k);
        }
        Ok((top.expanded(work)?, bottom.expanded(work)?))
    }

    /// The number's logarithm as whole multiples of those of primes: (prime, multiplicity). What has no
    /// small prime factor is kept whole: any splitting into factors is right.
    pub fn prime_powers(&self) -> Vec<(BigInt, i64)> {
        let mut out = Vec::new();
        for (number, sign) in [(self.coefficient.numer(), 1), (self.coefficient.denom(), -1)] {
            let mut rest = number.abs();
            for prime in 2u32..1000 {
                let prime = BigInt::from(prime);
                while !rest.is_zero() && (&rest % &prime).is_zero() {
                    rest /= &prime;
                    out.push((prime.clone(), sign));
                }
            }
            if !rest.is_one() && !rest.is_zero() {
                out.push((rest, sign));
            }
        }
        out
    }
}
