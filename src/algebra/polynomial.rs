//! Sparse polynomials in several variables over the rationals.
//!
//! Contract: exact ring arithmetic. Terms are kept in lexicographic order, variable 0 first, which
//! is compatible with multiplication, so the leading term of a product is the product of the leading
//! terms and exact division by leading terms is correct.
//!
//! Cost: products take |p|·|q| coefficient operations and as many map insertions.

use malachite::base::num::arithmetic::traits::{Gcd, Lcm, Pow};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::{Natural, Rational};
use std::collections::BTreeMap;

/// Exponents by variable, without trailing zeros.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct Monomial(Vec<u32>);

impl Monomial {
    /// The monomial with these exponents.
    pub fn new(mut exponents: Vec<u32>) -> Monomial {
        while exponents.last() == Some(&0) {
            exponents.pop();
        }
        Monomial(exponents)
    }

    /// The exponent of a variable.
    pub fn exponent(&self, variable: u32) -> u32 {
        self.0.get(variable as usize).copied().unwrap_or(0)
    }

    /// The variables with their exponents, none 0.
    pub fn powers(&self) -> impl Iterator<Item = (u32, u32)> + '_ {
        self.0.iter().enumerate().filter(|p| *p.1 > 0).map(|(v, k)| (u32::try_from(v).unwrap_or(u32::MAX), *k))
    }

    /// The total degree.
    pub fn degree(&self) -> u32 {
        self.0.iter().sum()
    }

    fn times(&self, other: &Monomial) -> Monomial {
        let (long, short) = if self.0.len() >= other.0.len() { (self, other) } else { (other, self) };
        let mut out = long.0.clone();
        for (a, b) in out.iter_mut().zip(&short.0) {
            *a = a.saturating_add(*b);
        }
        Monomial(out)
    }

    fn over(&self, other: &Monomial) -> Option<Monomial> {
        if other.0.len() > self.0.len() {
            return None;
        }
        let mut out = self.0.clone();
        for (a, b) in out.iter_mut().zip(&other.0) {
            *a = a.checked_sub(*b)?;
        }
        Some(Monomial::new(out))
    }
}

/// A polynomial.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct Polynomial {
    terms: BTreeMap<Monomial, Rational>,
}

impl Polynomial {
    /// 0.
    pub fn zero() -> Polynomial {
        Polynomial::default()
    }

    /// 1.
    pub fn one() -> Polynomial {
        Polynomial::constant(Rational::ONE)
    }

    /// A constant.
    pub fn constant(value: Rational) -> Polynomial {
        Polynomial::term(Monomial::default(), value)
    }

    /// A variable.
    pub fn variable(variable: u32) -> Polynomial {
        let mut exponents = vec![0; variable as usize + 1];
        exponents[variable as usize] = 1;
        Polynomial::term(Monomial(exponents), Rational::ONE)
    }

    /// c·monomial.
    pub fn term(monomial: Monomial, c: Rational) -> Polynomial {
        let mut terms = BTreeMap::new();
        if c != 0 {
            terms.insert(monomial, c);
        }
        Polynomial { terms }
    }

    /// The sum of terms, in any order.
    pub fn from_terms(list: impl IntoIterator<Item = (Monomial, Rational)>) -> Polynomial {
        let mut out = Polynomial::zero();
        for (monomial, c) in list {
            out.add_term(monomial, c);
        }
        out
    }

    fn add_term(&mut self, monomial: Monomial, c: Rational) {
        use std::collections::btree_map::Entry;
        match self.terms.entry(monomial) {
            Entry::Vacant(place) => {
                if c != 0 {
                    place.insert(c);
                }
            }
            Entry::Occupied(mut place) => {
                *place.get_mut() += c;
                if *place.get() == 0 {
                    place.remove();
                }
            }
        }
    }

    /// The terms, smallest monomial first.
    pub fn terms(&self) -> impl DoubleEndedIterator<Item = (&Monomial, &Rational)> {
        self.terms.iter()
    }

    /// The number of terms.
    pub fn len(&self) -> usize {
        self.terms.len()
    }

    /// Whether it is 0.
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// Whether it has no terms; the same as [`Polynomial::is_zero`].
    pub fn is_empty(&self) -> bool {
        self.terms.is_empty()
    }

    /// The constant, if it is one.
    pub fn as_constant(&self) -> Option<Rational> {
        match self.terms.len() {
            0 => Some(Rational::ZERO),
            1 => self.terms.get(&Monomial::default()).cloned(),
            _ => None,
        }
    }

    /// The largest term.
    pub fn leading(&self) -> Option<(&Monomial, &Rational)> {
        self.terms.iter().next_back()
    }

    /// The total degree, 0 for 0.
    pub fn degree(&self) -> u32 {
        self.terms.keys().map(Monomial::degree).max().unwrap_or(0)
    }

    /// The degree in a variable, 0 for 0.
    pub fn degree_in(&self, variable: u32) -> u32 {
        self.terms.keys().map(|m| m.exponent(variable)).max().unwrap_or(0)
    }

    /// The variables that occur.
    pub fn variables(&self) -> Vec<u32> {
        let mut out: Vec<u32> = self.terms.keys().flat_map(|m| m.powers().map(|p| p.0).collect::<Vec<_>>()).collect();
        out.sort_unstable();
        out.dedup();
        out
    }

    /// c·p.
    pub fn scaled(&self, c: &Rational) -> Polynomial {
        if *c == 0 {
            return Polynomial::zero();
        }
        Polynomial { terms: self.terms.iter().map(|(m, d)| (m.clone(), d * c)).collect() }
    }

    /// p^k.
    pub fn power(&self, k: u32) -> Polynomial {
        let mut out = Polynomial::one();
        for _ in 0..k {
            out = &out * self;
        }
        out
    }

    /// The coefficients with respect to a variable, by exponent from 0.
    pub fn coefficients_in(&self, variable: u32) -> Vec<Polynomial> {
        let mut out = vec![Polynomial::zero(); self.degree_in(variable) as usize + 1];
        for (monomial, c) in &self.terms {
            let mut exponents = monomial.0.clone();
            let k = monomial.exponent(variable);
            if let Some(e) = exponents.get_mut(variable as usize) {
                *e = 0;
            }
            out[k as usize].add_term(Monomial::new(exponents), c.clone());
        }
        out
    }

    /// Σ cₖ·vᵏ.
    pub fn from_coefficients_in(variable: u32, coefficients: &[Polynomial]) -> Polynomial {
        let mut out = Polynomial::zero();
        for (k, coefficient) in coefficients.iter().enumerate() {
            let mut exponents = vec![0; variable as usize + 1];
            exponents[variable as usize] = u32::try_from(k).unwrap_or(u32::MAX);
            let power = Monomial::new(exponents);
            for (monomial, c) in &coefficient.terms {
                out.add_term(monomial.times(&power), c.clone());
            }
        }
        out
    }

    /// The derivative by a variable.
    pub fn derivative(&self, variable: u32) -> Polynomial {
        let coefficients: Vec<Polynomial> = self
            .coefficients_in(variable)
            .iter()
            .enumerate()
            .skip(1)
            .map(|(k, c)| c.scaled(&Rational::from(k)))
            .collect();
        Polynomial::from_coefficients_in(variable, &coefficients)
    }

    /// p with a polynomial put for a variable.
    pub fn substitute(&self, variable: u32, value: &Polynomial) -> Polynomial {
        let mut out = Polynomial::zero();
        for coefficient in self.coefficients_in(variable).iter().rev() {
            out = &(&out * value) + coefficient;
        }
        out
    }

    /// The value at a point; variables past its end count as 0.
    pub fn evaluate(&self, point: &[Rational]) -> Rational {
        let mut sum = Rational::ZERO;
        for (monomial, c) in &self.terms {
            let mut term = c.clone();
            for (v, k) in monomial.powers() {
                term *= point.get(v as usize).cloned().unwrap_or(Rational::ZERO).pow(u64::from(k));
            }
            sum += term;
        }
        sum
    }

    /// (c, q) with p = c·q, q with coprime integer coefficients and a positive leading one.
    pub fn primitive(&self) -> (Rational, Polynomial) {
        let Some((_, lead)) = self.leading() else { return (Rational::ZERO, Polynomial::zero()) };
        let (mut top, mut bottom) = (Natural::ZERO, Natural::ONE);
        for c in self.terms.values() {
            top = top.gcd(c.numerator_ref().clone());
            bottom = bottom.lcm(c.denominator_ref().clone());
        }
        let mut content = Rational::from_naturals(top, bottom);
        if *lead < 0 {
            content = -content;
        }
        let inverse = Rational::ONE / &content;
        (content, self.scaled(&inverse))
    }

    /// The largest monomial that divides every term.
    pub fn common_monomial(&self) -> Monomial {
        let mut list = self.terms.keys();
        let Some(first) = list.next() else { return Monomial::default() };
        let mut out = first.0.clone();
        for monomial in list {
            for (v, e) in out.iter_mut().enumerate() {
                *e = (*e).min(monomial.0.get(v).copied().unwrap_or(0));
            }
        }
        Monomial::new(out)
    }

    /// p / q if the division is exact. q must not be 0.
    pub fn quotient(&self, q: &Polynomial) -> Option<Polynomial> {
        let (lead, c) = q.leading()?;
        let mut rest = self.clone();
        let mut out = Polynomial::zero();
        while let Some((top, d)) = rest.leading() {
            let monomial = top.over(lead)?;
            let factor = d / c;
            for (m, e) in &q.terms {
                rest.add_term(m.times(&monomial), -(e * &factor));
            }
            out.add_term(monomial, factor);
        }
        Some(out)
    }

    /// The text with a name for each variable.
    pub fn text(&self, name: &dyn Fn(u32) -> String) -> String {
        if self.terms.is_empty() {
            return "0".to_string();
        }
        let mut out = String::new();
        for (i, (monomial, c)) in self.terms.iter().rev().enumerate() {
            let negative = *c < 0;
            out.push_str(match (i, negative) {
                (0, true) => "-",
                (0, false) => "",
                (_, true) => " - ",
                (_, false) => " + ",
            });
            let size = if negative { -c } else { c.clone() };
            let powers: Vec<String> = monomial
                .powers()
                .map(|(v, k)| if k == 1 { name(v) } else { format!("{}^{k}", name(v)) })
                .collect();
            if size != 1 || powers.is_empty() {
                out.push_str(&size.to_string());
                if !powers.is_empty() {
                    out.push('*');
                }
            }
            out.push_str(&powers.join("*"));
        }
        out
    }
}

impl std::ops::Add for &Polynomial {
    type Output = Polynomial;
    fn add(self, other: &Polynomial) -> Polynomial {
        let mut out = self.clone();
        for (m, c) in &other.terms {
            out.add_term(m.clone(), c.clone());
        }
        out
    }
}

impl std::ops::Sub for &Polynomial {
    type Output = Polynomial;
    fn sub(self, other: &Polynomial) -> Polynomial {
        let mut out = self.clone();
        for (m, c) in &other.terms {
            out.add_term(m.clone(), -c);
        }
        out
    }
}

impl std::ops::Mul for &Polynomial {
    type Output = Polynomial;
    fn mul(self, other: &Polynomial) -> Polynomial {
        let mut out = Polynomial::zero();
        for (a, c) in &self.terms {
            for (b, d) in &other.terms {
                out.add_term(a.times(b), c * d);
            }
        }
        out
    }
}

impl std::ops::Neg for &Polynomial {
    type Output = Polynomial;
    fn neg(self) -> Polynomial {
        Polynomial { terms: self.terms.iter().map(|(m, c)| (m.clone(), -c)).collect() }
    }
}
