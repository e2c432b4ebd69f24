//! Quotients of texts: a sum or product has one numerator and one denominator, whose factors are kept apart.

use crate::claim::syntax::{Sign, Span};
use crate::export::{Result, unsupported};
use std::collections::BTreeMap;

/// A quotient: the numerator's text, and the denominator's factors with their powers.
#[derive(Clone, Debug)]
pub(super) struct Quotient {
    pub(super) above: String,
    pub(super) below: BTreeMap<String, u32>,
}

impl Quotient {
    pub(super) fn whole(above: impl Into<String>) -> Quotient {
        Quotient { above: above.into(), below: BTreeMap::new() }
    }

    pub(super) fn by(self, other: &Quotient) -> Quotient {
        let mut below = self.below;
        for (factor, power) in &other.below {
            *below.entry(factor.clone()).or_default() += power;
        }
        Quotient { above: times(vec![self.above, other.above.clone()]), below }
    }

    pub(super) fn negated(self) -> Quotient {
        Quotient { above: format!("(- {})", self.above), below: self.below }
    }

    pub(super) fn total(parts: &[Quotient]) -> Quotient {
        let below = common(parts.iter().map(|part| &part.below));
        let above: Vec<String> = parts
            .iter()
            .map(|part| {
                let mut list = vec![part.above.clone()];
                list.extend(factors(&below, &part.below));
                times(list)
            })
            .collect();
        Quotient { above: joined("+", above), below }
    }
}

/// A number or a matrix.
pub(super) enum Value {
    Scalar(Quotient),
    Matrix(Vec<Vec<Quotient>>),
}

pub(super) fn joined(sign: &str, mut parts: Vec<String>) -> String {
    match parts.len() {
        1 => parts.remove(0),
        _ => format!("({sign} {})", parts.join(" ")),
    }
}

pub(super) fn times(factors: Vec<String>) -> String {
    let mut factors: Vec<String> = factors.into_iter().filter(|f| f != "1").collect();
    match factors.len() {
        0 => "1".to_string(),
        1 => factors.remove(0),
        _ => format!("(* {})", factors.join(" ")),
    }
}

/// A denominator written out, without what is in the other one.
pub(super) fn factors(below: &BTreeMap<String, u32>, without: &BTreeMap<String, u32>) -> Vec<String> {
    let mut out = Vec::new();
    for (factor, power) in below {
        let there = without.get(factor).copied().unwrap_or(0);
        out.extend(std::iter::repeat_n(factor.clone(), power.saturating_sub(there) as usize));
    }
    out
}

/// The least common denominator.
pub(super) fn common<'a>(all: impl Iterator<Item = &'a BTreeMap<String, u32>>) -> BTreeMap<String, u32> {
    let mut below: BTreeMap<String, u32> = BTreeMap::new();
    for (factor, power) in all.flatten() {
        let entry = below.entry(factor.clone()).or_default();
        *entry = (*entry).max(*power);
    }
    below
}

impl Value {
    pub(super) fn negated(self) -> Value {
        match self {
            Value::Scalar(q) => Value::Scalar(q.negated()),
            Value::Matrix(rows) => {
                let negated = |row: Vec<Quotient>| row.into_iter().map(Quotient::negated).collect();
                Value::Matrix(rows.into_iter().map(negated).collect())
            }
        }
    }

    /// The sum of numbers or of matrices; `number` says that no summand is a matrix.
    pub(super) fn sum(list: Vec<(Sign, Value)>, number: bool, span: Span) -> Result<Value> {
        let rows = |(sign, value): (Sign, Value)| match if sign == Sign::Minus { value.negated() } else { value } {
            Value::Scalar(q) => vec![vec![q]],
            Value::Matrix(rows) => rows,
        };
        let parts: Vec<Vec<Vec<Quotient>>> = list.into_iter().map(rows).collect();
        let shape = |m: &Vec<Vec<Quotient>>| (m.len(), m.first().map_or(0, Vec::len));
        let Some((rows, columns)) = parts.first().map(shape) else { return unsupported(span, "an empty sum") };
        if parts.iter().any(|p| shape(p) != (rows, columns)) {
            return unsupported(span, "a sum of different sizes");
        }
        let entry = |i: usize, j: usize| {
            let list: Vec<Quotient> = parts.iter().filter_map(|p| p.get(i).and_then(|r| r.get(j)).cloned()).collect();
            Quotient::total(&list)
        };
        let total: Vec<Vec<Quotient>> = (0..rows).map(|i| (0..columns).map(|j| entry(i, j)).collect()).collect();
        // A number again, where no matrix was in the sum.
        Ok(match (number, total.first().and_then(|row| row.first())) {
            (true, Some(only)) if rows == 1 => Value::Scalar(only.clone()),
            _ => Value::Matrix(total),
        })
    }

    pub(super) fn product(self, other: Value, span: Span) -> Result<Value> {
        let scaled = |rows: Vec<Vec<Quotient>>, by: &Quotient| {
            Value::Matrix(rows.into_iter().map(|r| r.into_iter().map(|q| by.clone().by(&q)).collect()).collect())
        };
        Ok(match (self, other) {
            (Value::Scalar(a), Value::Scalar(b)) => Value::Scalar(a.by(&b)),
            (Value::Scalar(a), Value::Matrix(b)) => scaled(b, &a),
            (Value::Matrix(a), Value::Scalar(b)) => scaled(a, &b),
            (Value::Matrix(a), Value::Matrix(b)) => {
                let columns = b.first().map_or(0, Vec::len);
                if a.iter().any(|row| row.len() != b.len()) {
                    return unsupported(span, "a product of matrices whose sizes do not match");
                }
                let entry = |row: &Vec<Quotient>, j: usize| {
                    let list: Vec<Quotient> =
                        row.iter().zip(&b).filter_map(|(x, y)| Some(x.clone().by(y.get(j)?))).collect();
                    Quotient::total(&list)
                };
                Value::Matrix(a.iter().map(|row| (0..columns).map(|j| entry(row, j)).collect()).collect())
            }
        })
    }
}
