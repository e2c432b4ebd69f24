//! Factors of polynomials: the square-free decomposition, and further splits that come cheaply.
//!
//! Contract: the product of a [`Factored`] is exactly the polynomial that was given. The factors are
//! primitive with positive leading coefficient, not constant, square-free and pairwise coprime. They
//! need not be irreducible: a factor that was not split may still be reducible.
//!
//! Method: contents with respect to each variable, then Yun's algorithm in each part; then
//! - a polynomial whose exponents lie on a line is a univariate polynomial in disguise (univariate,
//!   homogeneous in two variables, binomial) and loses its rational roots and differences of powers;
//! - a polynomial quadratic in a variable splits when its discriminant is a square.

use super::gcd::{content_in, gcd};
use super::polynomial::within;
use super::{Limit, LimitReached, Monomial, Polynomial, Univariate, Var};
use crate::number::rational;
use malachite::Rational;
use malachite::base::num::basic::traits::{One, Zero};

/// The most terms that an exact root of a polynomial may have.
pub const MAX_ROOT_TERMS: usize = 200;

/// The most terms of a discriminant whose square root is looked for.
const MAX_DISCRIMINANT_TERMS: usize = 400;

/// A polynomial as a rational number times powers of coprime factors.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Factored {
    /// The rational factor; 0 exactly for the zero polynomial.
    pub unit: Rational,
    /// The factors with their exponents, at least 1, in the order of the polynomials.
    pub factors: Vec<(Polynomial, u32)>,
}

impl Factored {
    /// The product of everything.
    ///
    /// # Errors
    /// [`LimitReached`] when the product passes the limits of `Polynomial::try_mul`.
    pub fn product(&self) -> Result<Polynomial, LimitReached> {
        let mut product = Polynomial::constant(self.unit.clone());
        for (factor, exponent) in &self.factors {
            product = product.try_mul(&factor.pow(*exponent)?)?;
        }
        Ok(product)
    }
}

/// The square-free decomposition, split further by contents only.
///
/// # Errors
/// [`LimitReached`] from the gcds.
pub fn square_free(p: &Polynomial) -> Result<Factored, LimitReached> {
    let (unit, primitive) = p.primitive_part();
    let mut factors = Vec::new();
    if !primitive.is_constant() {
        let monomial = primitive.monomial_content();
        for &(var, exponent) in monomial.powers() {
            factors.push((Polynomial::variable(var), exponent));
        }
        separate(&divided(&primitive, &Polynomial::monomial(monomial)), &mut factors)?;
    }
    factors.sort();
    Ok(Factored { unit, factors })
}

/// The square-free decomposition with every cheap split of its factors.
///
/// # Errors
/// [`LimitReached`] from the gcds.
pub fn factor(p: &Polynomial) -> Result<Factored, LimitReached> {
    let Factored { unit, factors } = square_free(p)?;
    let mut split = Vec::new();
    for (polynomial, exponent) in factors {
        let mut waiting = vec![polynomial];
        while let Some(polynomial) = waiting.pop() {
            match split_once(&polynomial)? {
                Some((left, right)) => waiting.extend([left, right]),
                None => split.push((polynomial, exponent)),
            }
        }
    }
    split.sort();
    Ok(Factored { unit, factors: split })
}

/// Splits contents off until every part is primitive in each of its variables, then Yun's algorithm.
fn separate(p: &Polynomial, factors: &mut Vec<(Polynomial, u32)>) -> Result<(), LimitReached> {
    if p.is_constant() {
        return Ok(());
    }
    let vars = p.variables();
    for &var in &vars {
        let content = content_in(p, var)?;
        if !content.is_one() {
            separate(&content, factors)?;
            return separate(&divided(p, &content), factors);
        }
    }
    match vars.first() {
        Some(&var) => yun(p, var, factors),
        None => Ok(()),
    }
}

/// Yun's algorithm for a polynomial that is primitive with respect to `var`, so that every factor
/// contains `var` and only multiple factors divide its derivative.
fn yun(p: &Polynomial, var: Var, factors: &mut Vec<(Polynomial, u32)>) -> Result<(), LimitReached> {
    let slope = p.derivative(var);
    let common = gcd(p, &slope)?;
    if common.is_constant() {
        factors.push((p.clone(), 1));
        return Ok(());
    }
    let mut rest = divided(p, &common);
    let mut change = divided(&slope, &common).sub(&rest.derivative(var));
    let mut exponent = 1;
    while !change.is_zero() {
        let factor = gcd(&rest, &change)?;
        rest = divided(&rest, &factor);
        change = divided(&change, &factor).sub(&rest.derivative(var));
        if !factor.is_constant() {
            factors.push((factor, exponent));
        }
        exponent += 1;
    }
    if !rest.is_constant() {
        factors.push((rest.primitive_part().1, exponent));
    }
    Ok(())
}

/// The quotient by a divisor that is known to divide.
fn divided(p: &Polynomial, divisor: &Polynomial) -> Polynomial {
    p.exact_divide(divisor).expect("the divisor was found as a common divisor")
}

/// A split of a square-free primitive polynomial into two primitive factors, where one is found.
fn split_once(p: &Polynomial) -> Result<Option<(Polynomial, Polynomial)>, LimitReached> {
    if p.degree() < 2 {
        return Ok(None);
    }
    if let Some(line) = Line::of(p) {
        return Ok(line.factor().map(|found| complement(p, &found)));
    }
    for var in p.variables() {
        if p.degree_in(var) == 2
            // A limit here only means that no split was found.
            && let Ok(Some(found)) = split_quadratic(p, var)
        {
            return Ok(Some(complement(p, &found)));
        }
    }
    Ok(None)
}

/// A factor and its cofactor, both primitive.
fn complement(p: &Polynomial, found: &Polynomial) -> (Polynomial, Polynomial) {
    let found = found.primitive_part().1;
    let rest = divided(p, &found);
    (found, rest)
}

/// A factor of `A·v² + B·v + C` where `B² − 4AC` is a square `s²`: the polynomial divides
/// `(2A·v + B − s)·(2A·v + B + s)` up to the factor `4A`, so the primitive part of the first with
/// respect to `v` divides it.
fn split_quadratic(p: &Polynomial, var: Var) -> Result<Option<Polynomial>, LimitReached> {
    let coefficients = p.coefficients_in(var);
    let [c, b, a] = coefficients.as_slice() else {
        return Ok(None);
    };
    let four = Rational::from(4);
    let discriminant = b.try_mul(b)?.sub(&a.try_mul(c)?.scale(&four));
    if discriminant.term_count() > MAX_DISCRIMINANT_TERMS {
        return Ok(None);
    }
    let Some(root) = exact_root(&discriminant, 2)? else {
        return Ok(None);
    };
    let double = a.scale(&Rational::from(2));
    let line = Polynomial::from_coefficients_in(var, &[b.sub(&root), double]);
    let content = content_in(&line, var)?;
    Ok(Some(divided(&line, &content)))
}

/// The polynomial whose `k`-th power is `p`, with positive leading coefficient for even `k`; `None`
/// where there is none over the rationals, and for `k = 0`.
///
/// Why it is right: the terms of the root are found from the largest down, each being determined by
/// the leading term of what is left; its exponents are at most those of `p` divided by `k`, and its
/// smallest term is the root of the smallest term of `p`. Both cut the search short where there is
/// no root.
///
/// # Errors
/// [`LimitReached`] when a root would have more than [`MAX_ROOT_TERMS`] terms.
pub fn exact_root(p: &Polynomial, k: u32) -> Result<Option<Polynomial>, LimitReached> {
    let (Some((lead, coefficient)), Some((last, last_coefficient))) = (p.leading_term(), p.terms().last()) else {
        return Ok((k > 0).then(Polynomial::zero));
    };
    if k <= 1 {
        return Ok((k == 1).then(|| p.clone()));
    }
    if k > 2 && k.is_multiple_of(2) {
        // The square root with positive leading coefficient is the (k/2)-th power of one of ±r.
        return match exact_root(p, 2)? {
            Some(root) => exact_root(&root, k / 2),
            None => Ok(None),
        };
    }
    let Some(top) = term_root(lead, coefficient, k) else {
        return Ok(None);
    };
    let Some(bottom) = term_root(last, last_coefficient, k) else {
        return Ok(None);
    };
    if p.variables().iter().any(|&var| !p.degree_in(var).is_multiple_of(k)) {
        return Ok(None);
    }
    let mut root = Polynomial::term(top.0.clone(), top.1.clone());
    // The step for the next term t: p − r^k = k·lt(r)^(k−1)·t + smaller.
    let slope = root.pow(k - 1)?.scale(&Rational::from(k));
    let mut rest = p.sub(&root.pow(k)?);
    loop {
        if rest.is_zero() {
            return Ok(Some(root));
        }
        let Some((monomial, coefficient)) = rest.leading_term() else {
            return Ok(None);
        };
        let next = Polynomial::term(monomial.clone(), coefficient.clone()).exact_divide(&slope);
        let Some(next) = next else { return Ok(None) };
        let Some((place, _)) = next.leading_term() else {
            return Ok(None);
        };
        if *place < bottom.0 || root.terms().last().is_some_and(|(m, _)| m <= place) {
            return Ok(None);
        }
        within(Limit::Terms, MAX_ROOT_TERMS, root.term_count() + 1)?;
        if k == 2 {
            // p − (r + t)² = (p − r²) − (2r + t)·t
            let sum = root.scale(&Rational::from(2)).add(&next);
            rest = rest.sub(&sum.try_mul(&next)?);
            root = root.add(&next);
        } else {
            root = root.add(&next);
            rest = p.sub(&root.pow(k)?);
        }
    }
}

/// The `k`-th root of a single term.
fn term_root(monomial: &Monomial, coefficient: &Rational, k: u32) -> Option<(Monomial, Rational)> {
    let powers = monomial
        .powers()
        .iter()
        .map(|&(var, exponent)| exponent.is_multiple_of(k).then_some((var, exponent / k)))
        .collect::<Option<Vec<_>>>()?;
    let negative = *coefficient < Rational::ZERO;
    if negative && k.is_multiple_of(2) {
        return None;
    }
    let size = if negative { -coefficient } else { coefficient.clone() };
    let root = rational::exact_root(&size, u64::from(k))?;
    let monomial = Monomial::new(&powers).ok()?;
    Some((monomial, if negative { -root } else { root }))
}

/// A polynomial whose exponents lie on a line: `Σ cᵢ·X^(n−i)·Yⁱ` with coprime monomials `X`, `Y`.
struct Line {
    above: Monomial,
    below: Monomial,
    /// `Σ cᵢ·tⁱ`, of degree `n`.
    univariate: Univariate,
}

impl Line {
    /// The line of a primitive polynomial without monomial content, where its exponents lie on one.
    fn of(p: &Polynomial) -> Option<Self> {
        let (first, _) = p.leading_term()?;
        let (last, _) = p.terms().last()?;
        // Without monomial content the ends of the line are coprime: they are X^n and Y^n.
        if !first.gcd(last).is_one() {
            return None;
        }
        let count = first.powers().iter().chain(last.powers()).map(|&(_, e)| e).reduce(integer_gcd)?;
        let root = |m: &Monomial| {
            let powers: Vec<(Var, u32)> = m.powers().iter().map(|&(v, e)| (v, e / count)).collect();
            Monomial::new(&powers).ok()
        };
        let (above, below) = (root(first)?, root(last)?);
        let mut terms = Vec::with_capacity(p.term_count());
        for (monomial, coefficient) in p.terms() {
            let place = match (above.powers().first(), below.powers().first()) {
                (Some(&(var, unit)), _) => count.checked_sub(monomial.exponent(var) / unit)?,
                (None, Some(&(var, unit))) => monomial.exponent(var) / unit,
                (None, None) => return None,
            };
            if *monomial != between(&above, &below, count, place)? {
                return None;
            }
            terms.push((Monomial::small_power(0, place), coefficient.clone()));
        }
        let univariate = Univariate::from_polynomial(&Polynomial::from_terms(terms), 0)?;
        Some(Self { above, below, univariate })
    }

    /// A proper factor: first of the polynomial read in a power of its variable, so that
    /// differences of powers split (`x⁴ − 4 = (x² − 2)(x² + 2)`), in the end of a rational root.
    fn factor(&self) -> Option<Polynomial> {
        let step = self
            .univariate
            .coefficients()
            .iter()
            .zip(0u32..)
            .filter(|(c, _)| **c != 0)
            .map(|(_, i)| i)
            .reduce(integer_gcd)?;
        for power in (1..=step).rev().filter(|m| step % m == 0) {
            let thinned: Vec<_> = self.univariate.coefficients().iter().step_by(power as usize).cloned().collect();
            let thinned = Univariate::new(thinned);
            // The polynomial is square-free, hence so are its thinned ones, and
            // a root of a thinned polynomial of degree 1 would give back the whole polynomial.
            if thinned.degree() < 2 {
                continue;
            }
            if let Some(root) = thinned.rational_roots_if_square_free().first() {
                return self.binomial(root, power);
            }
        }
        None
    }

    /// The factor `Y^m − r·X^m`.
    fn binomial(&self, root: &Rational, power: u32) -> Option<Polynomial> {
        let below = between(&self.above, &self.below, power, power)?;
        let above = between(&self.above, &self.below, power, 0)?;
        Some(Polynomial::from_terms([(below, Rational::ONE), (above, -root)]))
    }
}

/// `X^(n−i)·Y^i`.
fn between(above: &Monomial, below: &Monomial, n: u32, i: u32) -> Option<Monomial> {
    let raise = |m: &Monomial, k: u32| {
        m.powers().iter().map(|&(v, e)| Some((v, e.checked_mul(k)?))).collect::<Option<Vec<_>>>()
    };
    let mut powers = raise(above, n.checked_sub(i)?)?;
    powers.extend(raise(below, i)?);
    Monomial::new(&powers).ok()
}

fn integer_gcd(a: u32, b: u32) -> u32 {
    let (mut a, mut b) = (a, b);
    while b > 0 {
        (a, b) = (b, a % b);
    }
    a
}
