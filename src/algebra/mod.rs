//! Exact algebra: polynomials and what is known of their signs, forms with symbolic exponents.
pub mod factor;
pub mod form;
pub mod gcd;
pub mod polynomial;
pub mod positivity;
pub mod simplex;
pub mod univariate;
