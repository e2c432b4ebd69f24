//! Values at a point: numbers and matrices of numbers, exact or enclosed, with their arithmetic and comparison.

use super::enclosure::{Enclosure, ROOT_LIMIT};
use super::fraction::Work;
use super::order::Signs;
use super::{Reason, Refusal, rejected};
use crate::claim::syntax::Relation;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

type Fallible<T> = Result<T, Refusal>;

/// A number or a matrix.
pub(super) enum Value {
    Number(Enclosure),
    Matrix(Vec<Vec<Enclosure>>),
}

impl Value {
    pub(super) fn each(&self, change: &dyn Fn(&Enclosure) -> Fallible<Enclosure>) -> Fallible<Value> {
        Ok(match self {
            Value::Number(x) => Value::Number(change(x)?),
            Value::Matrix(rows) => Value::Matrix(
                rows.iter().map(|row| row.iter().map(change).collect()).collect::<Fallible<Vec<Vec<_>>>>()?,
            ),
        })
    }

    pub(super) fn plus(&self, other: &Value, work: &Work) -> Fallible<Value> {
        match (self, other) {
            (Value::Number(a), Value::Number(b)) => Ok(Value::Number(a.plus(b, work)?)),
            (Value::Matrix(a), Value::Matrix(b)) if sizes(a) == sizes(b) => {
                let row = |(r, s): (&Vec<Enclosure>, &Vec<Enclosure>)| {
                    r.iter().zip(s).map(|(x, y)| x.plus(y, work)).collect()
                };
                Ok(Value::Matrix(a.iter().zip(b).map(row).collect::<Fallible<_>>()?))
            }
            _ => rejected(Reason::MatrixSizes),
        }
    }

    pub(super) fn times(&self, other: &Value, work: &Work) -> Fallible<Value> {
        match (self, other) {
            (Value::Number(a), other) => other.each(&|x| a.times(x, work)),
            (_, Value::Number(b)) => self.each(&|x| x.times(b, work)),
            (Value::Matrix(a), Value::Matrix(b)) => {
                if a.first().map(Vec::len) != Some(b.len()) {
                    return rejected(Reason::MatrixSizes);
                }
                let columns = transposed(b);
                let cell = |row: &Vec<Enclosure>, column: &Vec<Enclosure>| {
                    let zero = Enclosure::exact(BigRational::zero());
                    row.iter().zip(column).try_fold(zero, |sum, (x, y)| sum.plus(&x.times(y, work)?, work))
                };
                let row = |row: &Vec<Enclosure>| columns.iter().map(|column| cell(row, column)).collect();
                Ok(Value::Matrix(a.iter().map(row).collect::<Fallible<_>>()?))
            }
        }
    }

    /// Whether a comparison holds; matrices of one size are equal or not.
    pub(super) fn compared(&self, relation: Relation, other: &Value, work: &Work) -> Fallible<Option<bool>> {
        match (self, other) {
            (Value::Number(a), Value::Number(b)) => compared(a, relation, b, work),
            (Value::Matrix(a), Value::Matrix(b)) if sizes(a) == sizes(b) => {
                let entries = a.iter().flatten().zip(b.iter().flatten());
                let same = entries.map(|(x, y)| compared(x, Relation::Equal, y, work)).collect::<Fallible<Vec<_>>>()?;
                match relation {
                    Relation::Equal => Ok(all(&same)),
                    Relation::NotEqual => Ok(all(&same).map(|t| !t)),
                    _ => rejected(Reason::MatrixSizes),
                }
            }
            _ => rejected(Reason::MatrixSizes),
        }
    }
}

pub(super) fn transposed(rows: &[Vec<Enclosure>]) -> Vec<Vec<Enclosure>> {
    let width = rows.first().map_or(0, Vec::len);
    (0..width).map(|j| rows.iter().filter_map(|row| row.get(j).cloned()).collect()).collect()
}

/// The determinant, by the first row, of a square matrix of at most five rows.
pub(super) fn determinant(rows: &[Vec<Enclosure>], work: &Work) -> Fallible<Enclosure> {
    if rows.len() > 5 || rows.iter().any(|row| row.len() != rows.len()) {
        return rejected(Reason::MatrixSizes);
    }
    let Some((first, others)) = rows.split_first() else { return Ok(Enclosure::exact(BigRational::one())) };
    let mut sum = Enclosure::exact(BigRational::zero());
    for (j, x) in first.iter().enumerate() {
        let without = |row: &Vec<Enclosure>| (0..).zip(row).filter(|(i, _)| *i != j).map(|(_, y)| y.clone()).collect();
        let minor = determinant(&others.iter().map(without).collect::<Vec<_>>(), work)?;
        let part = x.times(&minor, work)?;
        sum = if j % 2 == 0 { sum.plus(&part, work)? } else { sum.minus(&part, work)? };
    }
    Ok(sum)
}

fn sizes(rows: &[Vec<Enclosure>]) -> Vec<usize> {
    rows.iter().map(Vec::len).collect()
}

fn compared(a: &Enclosure, relation: Relation, b: &Enclosure, work: &Work) -> Fallible<Option<bool>> {
    let (signs, wanted) = (a.minus(b, work)?.signs(), Signs::of(relation));
    Ok(if signs.within(wanted) {
        Some(true)
    } else if signs.within(wanted.others()) {
        Some(false)
    } else {
        None
    })
}

/// Whether all are true.
pub(super) fn all(truths: &[Option<bool>]) -> Option<bool> {
    if truths.contains(&Some(false)) {
        return Some(false);
    }
    if truths.contains(&None) { None } else { Some(true) }
}

/// b^E for b > 0, or b ≥ 0 and a positive number E.
pub(super) fn real_power(b: &Enclosure, e: &Enclosure, work: &Work) -> Fallible<Enclosure> {
    if let Some(q) = e.number()
        && let Some(k) = q.denom().to_u32().filter(|k| *k <= ROOT_LIMIT)
    {
        let root = if k == 1 { b.clone() } else { b.root(k, work)? };
        let power = root.power(&q.numer().abs(), work)?;
        return if q.is_negative() { power.inverse(work) } else { Ok(power) };
    }
    if b.number().is_some_and(|q| q.is_zero()) {
        return Ok(b.clone());
    }
    b.ln(work)?.times(e, work)?.exp(work)
}
