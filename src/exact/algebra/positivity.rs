//! Exact proofs that a polynomial is positive, or not negative, where given constraints hold.
//!
//! Contract: [`certify`] returns a [`Certificate`] that has been verified, or `None`, which says
//! nothing. A certificate proves `p ≥ 0`, or `p > 0` when it is [strict](Certificate::is_strict), at
//! every real point where each constraint `g ≥ 0` (strict: `g > 0`) holds.
//!
//! Method, from the cheap to the general: coefficients of one sign after shifting single-variable
//! bounds to 0; Bernstein coefficients on boxes; Sturm's theorem in one variable; and a linear
//! program for `p = Σ λ·∏ gⱼ^αⱼ·s²` with `λ > 0` (module `products`; Handelman, Schmüdgen). All but
//! Sturm's give the same kind of certificate, an identity that anyone can multiply out.
//!
//! ```
//! use carom_exact::algebra::Polynomial;
//! use carom_exact::algebra::positivity::{Constraint, Limits, certify};
//! let (a, b) = (Polynomial::variable(0), Polynomial::variable(1));
//! // a > b > 0 implies a² > b².
//! let constraints = [
//!     Constraint { poly: &a - &b, strict: true },
//!     Constraint { poly: b.clone(), strict: true },
//! ];
//! let p = &(&a * &a) - &(&b * &b);
//! let certificate = certify(&p, &constraints, &[], true, &Limits::default());
//! assert!(certificate.is_some_and(|c| c.is_strict() && c.verify(&p, &constraints)));
//! ```
//!
//! Why it is right: a product of constraints and squares is not negative where the constraints hold,
//! and a sum of such with positive weights is not. The sum is positive if one summand is, for which
//! all its factors are to be strict constraints (none of them: a positive constant).

mod bounds;
#[cfg(test)]
mod laws;
mod products;

use super::roots::{Interval, SignOn};
use super::{Polynomial, Univariate, Var};
use malachite::Rational;
use malachite::base::num::basic::traits::{One, Zero};

/// A condition `poly ≥ 0`, or `poly > 0` when strict.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Constraint {
    /// The polynomial.
    pub poly: Polynomial,
    /// Whether 0 is excluded.
    pub strict: bool,
}

/// What a search may cost.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// How far the degree of products may pass that of the polynomial.
    pub extra_degree: u32,
    /// The most products among which a linear program chooses.
    pub columns: usize,
    /// The most monomials that occur in them.
    pub rows: usize,
    /// The most pivots of a linear program.
    pub pivots: usize,
    /// The most updates of tableau entries.
    pub work: usize,
    /// The highest degree to which Sturm's theorem and Bernstein coefficients are applied.
    pub univariate_degree: u32,
}

impl Default for Limits {
    fn default() -> Self {
        Self { extra_degree: 1, columns: 120, rows: 300, pivots: 500, work: 200_000, univariate_degree: 60 }
    }
}

/// One summand `λ·∏ gⱼ^αⱼ·∏ sₖ²` of a combination.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Summand {
    /// The positive weight λ.
    pub weight: Rational,
    /// The constraints by number, with exponents at least 1.
    pub constraints: Vec<(usize, u32)>,
    /// The polynomials that enter squared.
    pub squares: Vec<Polynomial>,
}

/// A proof that a polynomial is positive, or not negative, under constraints.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Certificate {
    /// The polynomial is this sum of products of constraints and squares.
    Combination {
        /// The summands.
        summands: Vec<Summand>,
        /// Whether one of them is shown to be positive.
        strict: bool,
    },
    /// The polynomial has one variable, and Sturm's theorem gives its sign between two bounds.
    Sturm {
        /// The variable.
        var: Var,
        /// The interval that the single-variable linear constraints cut out.
        interval: Interval,
        /// Whether it has no root there.
        strict: bool,
    },
}

/// A verified proof of `p ≥ 0`, or of `p > 0` if `want_strict`, under the constraints; `None` where
/// none was found. `squares` lists polynomials whose squares may help.
///
/// Cost: at most one Sturm sequence and `2·(extra_degree + 1)` linear programs within the limits.
#[must_use]
pub fn certify(
    p: &Polynomial,
    constraints: &[Constraint],
    squares: &[Polynomial],
    want_strict: bool,
    limits: &Limits,
) -> Option<Certificate> {
    let good =
        |found: Option<Certificate>| found.filter(|c| (c.is_strict() || !want_strict) && c.verify(p, constraints));
    if let Some(value) = p.as_constant() {
        return good(constant(&value, constraints));
    }
    let moderate = p.degree() <= limits.univariate_degree;
    good(bounds::by_coefficients(p, constraints))
        .or_else(|| good(if moderate { sturm(p, constraints) } else { None }))
        .or_else(|| good(if moderate { bounds::by_bernstein(p, constraints) } else { None }))
        .or_else(|| {
            let none: &[Polynomial] = &[];
            let own = products::usual_squares(p);
            let more: Vec<Polynomial> = squares.iter().cloned().chain(own).collect();
            let tries = if squares.is_empty() { [none, &more] } else { [squares, &more] };
            let degrees = p.degree()..=p.degree().saturating_add(limits.extra_degree);
            degrees.flat_map(|degree| tries.map(|squares| (degree, squares))).find_map(|(degree, squares)| {
                good(products::by_products(p, constraints, squares, want_strict, degree, limits))
            })
        })
}

/// The certificate of a constant that is not negative.
fn constant(value: &Rational, constraints: &[Constraint]) -> Option<Certificate> {
    if *value < Rational::ZERO {
        return None;
    }
    let summand = Summand { weight: value.clone(), constraints: Vec::new(), squares: Vec::new() };
    let summands = if *value > Rational::ZERO { vec![summand] } else { Vec::new() };
    Some(Certificate::combination(summands, constraints))
}

/// Sturm's theorem on the interval of the linear constraints.
fn sturm(p: &Polynomial, constraints: &[Constraint]) -> Option<Certificate> {
    let [var] = p.variables()[..] else {
        return None;
    };
    let interval = bounds::interval(constraints, var);
    let strict = match Univariate::from_polynomial(p, var)?.sign_on(&interval) {
        SignOn::Positive => true,
        SignOn::NonNegative | SignOn::Zero => false,
        _ => return None,
    };
    Some(Certificate::Sturm { var, interval, strict })
}

impl Summand {
    /// Whether it is positive wherever the constraints hold.
    fn is_positive(&self, constraints: &[Constraint]) -> bool {
        self.squares.is_empty() && self.constraints.iter().all(|&(j, _)| constraints.get(j).is_some_and(|g| g.strict))
    }

    /// The polynomial, where the numbers of the constraints are right and no limit is reached.
    fn product(&self, constraints: &[Constraint]) -> Option<Polynomial> {
        let mut product = Polynomial::constant(self.weight.clone());
        for &(j, exponent) in &self.constraints {
            let power = constraints.get(j)?.poly.pow(exponent).ok()?;
            product = product.try_mul(&power).ok()?;
        }
        for square in &self.squares {
            product = product.try_mul(&square.pow(2).ok()?).ok()?;
        }
        Some(product)
    }

    fn text(&self, name: &dyn Fn(Var) -> String, constraints: &[Constraint]) -> String {
        let mut factors = Vec::new();
        for &(j, exponent) in &self.constraints {
            let base = constraints.get(j).map_or("?".to_owned(), |g| bracketed(&g.poly, name));
            factors.push(if exponent == 1 { base } else { format!("{base}^{exponent}") });
        }
        factors.extend(self.squares.iter().map(|s| format!("{}^2", bracketed(s, name))));
        if self.weight != Rational::ONE || factors.is_empty() {
            factors.insert(0, self.weight.to_string());
        }
        factors.join("*")
    }
}

/// The polynomial as a factor in a product.
fn bracketed(p: &Polynomial, name: &dyn Fn(Var) -> String) -> String {
    let text = p.display(name);
    let plain = p.leading_term().is_some_and(|(m, c)| *c == Rational::ONE && m.degree() == 1);
    if p.term_count() == 1 && plain { text } else { format!("({text})") }
}

impl Certificate {
    /// The combination, strict if one of its summands is positive.
    fn combination(summands: Vec<Summand>, constraints: &[Constraint]) -> Self {
        let strict = summands.iter().any(|s| s.is_positive(constraints));
        Self::Combination { summands, strict }
    }

    /// Whether it proves `p > 0`, and not only `p ≥ 0`.
    #[must_use]
    pub fn is_strict(&self) -> bool {
        match self {
            Self::Combination { strict, .. } | Self::Sturm { strict, .. } => *strict,
        }
    }

    /// Checks the certificate from nothing but itself: a combination is multiplied out and compared,
    /// a sign on an interval is determined again.
    #[must_use]
    pub fn verify(&self, p: &Polynomial, constraints: &[Constraint]) -> bool {
        match self {
            Self::Combination { summands, strict } => {
                let mut sum = Polynomial::zero();
                for summand in summands {
                    match summand.product(constraints) {
                        Some(product) if summand.weight > Rational::ZERO => sum = sum.add(&product),
                        _ => return false,
                    }
                }
                sum == *p && (!strict || summands.iter().any(|s| s.is_positive(constraints)))
            }
            Self::Sturm { var, interval, strict } => {
                let sign = Univariate::from_polynomial(p, *var).map(|f| f.sign_on(interval));
                let holds = match sign {
                    Some(SignOn::Positive) => true,
                    Some(SignOn::NonNegative | SignOn::Zero) => !strict,
                    _ => false,
                };
                holds && bounds::interval(constraints, *var) == *interval
            }
        }
    }

    /// The proof in words and formulas.
    #[must_use]
    pub fn explain(&self, name: &dyn Fn(Var) -> String, constraints: &[Constraint]) -> String {
        match self {
            Self::Combination { summands, strict } => {
                let parts: Vec<String> = summands.iter().map(|s| s.text(name, constraints)).collect();
                let sum = if parts.is_empty() { "0".to_owned() } else { parts.join(" + ") };
                let why = match strict {
                    true => "no summand is negative and one is positive",
                    false => "no summand is negative",
                };
                format!("it equals {sum}, where {why}")
            }
            Self::Sturm { var, interval, strict } => {
                let what = if *strict { "has no root and is positive" } else { "is not negative" };
                format!("by Sturm's theorem it {what} for {}", interval.display(&name(*var)))
            }
        }
    }
}
