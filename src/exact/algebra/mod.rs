//! Exact algebra over the rationals: polynomials, their gcds and factors, real roots and
//! proofs of positivity.
//!
//! Contract: no answer rounds or guesses (`semidefinite` searches in doubles, and checks exactly). A function answers exactly, or says that a
//! named limit stopped it ([`LimitReached`]), or (where the type is an `Option`) that it found
//! nothing, which proves nothing.
//!
//! Variables are plain numbers; a caller that has names passes a naming function where text is made.

mod clock;
mod division;
pub mod factor;
pub mod gcd;
mod geobucket;
pub mod gosper;
pub mod ideal;
pub(crate) mod monomial;
pub(crate) mod polynomial;
pub mod positivity;
mod residue;
pub mod roots;
pub mod semidefinite;
pub mod simplex;
mod substitution;
mod text;
pub(crate) mod univariate;

pub use clock::Moment;
pub use monomial::Monomial;
pub use polynomial::Polynomial;
pub use univariate::Univariate;

use std::fmt;

/// The number of a variable.
pub type Var = u32;

/// What a limit counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Limit {
    /// Terms of a polynomial.
    Terms,
    /// The total degree of a polynomial.
    Degree,
    /// Elementary steps of one computation: products of terms, updates of a tableau.
    Work,
    /// Bits of a numerator or denominator.
    Bits,
    /// Pivots of a linear program.
    Pivots,
}

/// An exact computation was stopped: it would have needed more than it was allowed.
///
/// It says nothing about the mathematics; with a larger limit the same call would have answered.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct LimitReached {
    /// What was counted.
    pub limit: Limit,
    /// How much of it was allowed.
    pub allowed: u64,
    /// How much was needed, at least.
    pub needed: u64,
}

impl fmt::Display for LimitReached {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let what = match self.limit {
            Limit::Terms => "terms",
            Limit::Degree => "degree",
            Limit::Work => "elementary steps",
            Limit::Bits => "bits of a coefficient",
            Limit::Pivots => "pivots",
        };
        write!(f, "limit on {what} reached: {} allowed, {} needed", self.allowed, self.needed)
    }
}

impl std::error::Error for LimitReached {}
