//! Exact numbers with algebra: rationals and radicals, enclosures of any precision, decimals; polynomials, their gcds, factors
//! and real roots, and proofs of positivity.

pub mod algebra;
pub mod number;
