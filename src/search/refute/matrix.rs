//! Scalars and matrices of numbers: sum, product, determinant.

use super::number::{Missing, Number, Result, add, invert, multiply, negate, of_some_size};
use malachite::Rational;
use malachite::base::num::basic::traits::{One, Zero};

/// A scalar or a matrix of numbers.
pub(super) enum Value {
    Scalar(Number),
    Matrix(Vec<Vec<Number>>),
}

impl Value {
    /// Each number with the other sign.
    pub(super) fn negated(self) -> Value {
        match self {
            Value::Scalar(a) => Value::Scalar(negate(&a)),
            Value::Matrix(rows) => Value::Matrix(rows.iter().map(|r| r.iter().map(negate).collect()).collect()),
        }
    }

    /// The sum of two scalars, or of two matrices of one size.
    pub(super) fn plus(self, other: &Value) -> Result<Value> {
        Ok(match (self, other) {
            (Value::Scalar(a), Value::Scalar(b)) => Value::Scalar(of_some_size(add(&a, b))?),
            (Value::Matrix(a), Value::Matrix(b)) if same_size(&a, b) => {
                Value::Matrix(a.iter().zip(b).map(|(r, s)| r.iter().zip(s).map(|(x, y)| add(x, y)).collect()).collect())
            }
            _ => return Err(Missing::Unknown),
        })
    }

    /// The product with another value; of a scalar that is divided by and said so, with its inverse.
    pub(super) fn times(self, other: Value, divisor: Option<impl Fn() -> String>) -> Result<Value> {
        let inverted = |b: Number| match &divisor {
            Some(said) => invert(&b, said),
            None => Ok(b),
        };
        Ok(match (self, other) {
            (Value::Scalar(a), Value::Scalar(b)) => Value::Scalar(of_some_size(multiply(&a, &inverted(b)?))?),
            (Value::Matrix(m), Value::Scalar(b)) | (Value::Scalar(b), Value::Matrix(m)) => {
                let b = inverted(b)?;
                Value::Matrix(m.iter().map(|r| r.iter().map(|x| multiply(x, &b)).collect()).collect())
            }
            (Value::Matrix(a), Value::Matrix(b)) => {
                if a[0].len() != b.len() {
                    return Err(Missing::Unknown);
                }
                let zero = || Number::Exact(Rational::ZERO);
                let cell = |row: &Vec<Number>, j: usize| {
                    row.iter().zip(&b).fold(zero(), |sum, (x, r)| add(&sum, &multiply(x, &r[j])))
                };
                Value::Matrix(a.iter().map(|row| (0..b[0].len()).map(|j| cell(row, j)).collect()).collect())
            }
        })
    }
}

/// Whether two matrices have as many rows and columns.
pub(super) fn same_size(a: &[Vec<Number>], b: &[Vec<Number>]) -> bool {
    a.iter().map(Vec::len).eq(b.iter().map(Vec::len))
}

/// The determinant, by the first row, of a square matrix of at most five rows.
pub(super) fn determinant(rows: &[Vec<Number>]) -> Result<Number> {
    let Some((first, others)) = rows.split_first() else { return Ok(Number::Exact(Rational::ONE)) };
    if rows.len() > 5 || rows.iter().any(|row| row.len() != rows.len()) {
        return Err(Missing::Unknown);
    }
    let mut sum = Number::Exact(Rational::ZERO);
    for (place, a) in first.iter().enumerate() {
        let without = |row: &Vec<Number>| {
            row.iter().enumerate().filter(|(k, _)| *k != place).map(|(_, x)| x.clone()).collect::<Vec<_>>()
        };
        let minor = determinant(&others.iter().map(without).collect::<Vec<_>>())?;
        let term = multiply(a, &minor);
        sum = add(&sum, &if place % 2 == 0 { term } else { negate(&term) });
    }
    Ok(sum)
}
