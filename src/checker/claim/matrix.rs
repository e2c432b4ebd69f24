//! Matrices of written entries, as far as abbreviations need them: their entries, powers to a numeral, inverse and trace.

use super::abbreviation::NODES_LIMIT;
use super::syntax::*;
use super::walk::nodes_in;
use std::collections::BTreeMap;

/// The rows of a matrix.
pub(crate) type Rows = Vec<Vec<Expr>>;

/// Why a matrix cannot be written out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unfit {
    /// It has not as many rows as columns.
    NotSquare,
    /// Its entries are not written in the claim.
    NotWritten,
    /// Its entries would have more than `NODES_LIMIT` nodes.
    TooLarge,
}

/// An expression at a place.
pub(super) fn at(span: Span, kind: ExprKind) -> Expr {
    Expr { kind, span }
}

/// A numeral at a place.
pub(super) fn numeral(span: Span, k: u32) -> Expr {
    at(span, ExprKind::Number(k.to_string()))
}

/// A function of one argument.
pub(super) fn apply(span: Span, function: &str, argument: Expr) -> Expr {
    at(span, ExprKind::Apply(Name { text: function.to_string(), span }, vec![argument]))
}

/// Definitions of matrices by their names, with their entries, or why these are not written.
#[derive(Debug, Default)]
pub struct Matrices(pub(super) BTreeMap<String, Result<Rows, Unfit>>);

impl Matrices {
    /// The entries of an expression that is a matrix by how it is written; `None` for a number. They are counted before they are
    /// built.
    pub fn entries(&self, e: &Expr) -> Result<Option<Rows>, Unfit> {
        let each = |rows: Rows, f: &dyn Fn(Expr) -> Expr| -> Rows {
            rows.into_iter().map(|row| row.into_iter().map(f).collect()).collect()
        };
        Ok(match &e.kind {
            ExprKind::Matrix(rows) => Some(rows.clone()),
            ExprKind::Name(name) => self.0.get(name).cloned().transpose()?,
            ExprKind::Apply(f, arguments) if f.text == "transpose" => match arguments.first() {
                Some(argument) => self.entries(argument)?.map(|rows| transposed(&rows)),
                None => None,
            },
            ExprKind::Negate(a) => {
                self.entries(a)?.map(|rows| each(rows, &|entry| at(e.span, ExprKind::Negate(Box::new(entry)))))
            }
            ExprKind::Sum(list) => {
                let mut parts = Vec::new();
                for (_, part) in list {
                    match self.entries(part)? {
                        Some(rows) => parts.push(rows),
                        None => return Ok(None),
                    }
                }
                let Some((height, width)) = parts.first().map(size) else { return Ok(None) };
                if parts.iter().any(|rows| size(rows) != (height, width)) {
                    return Ok(None);
                }
                is_small(parts.iter().map(nodes_of).fold(0, usize::saturating_add))?;
                let entry = |row: usize, column: usize| {
                    let summands = list.iter().zip(&parts).map(|((sign, _), rows)| (*sign, rows[row][column].clone()));
                    at(e.span, ExprKind::Sum(summands.collect()))
                };
                Some((0..height).map(|row| (0..width).map(|column| entry(row, column)).collect()).collect())
            }
            ExprKind::Product(list) => {
                let mut product: Option<Rows> = None;
                let mut scalars = Vec::new();
                for (operator, factor) in list {
                    match (self.entries(factor)?, product.take(), operator) {
                        (Some(_), _, Factor::Over) => return Ok(None),
                        (Some(rows), None, Factor::Times) => product = Some(rows),
                        (Some(rows), Some(before), Factor::Times) => match times(&before, &rows, e.span)? {
                            Some(rows) => product = Some(rows),
                            None => return Ok(None),
                        },
                        (None, before, _) => {
                            scalars.push((*operator, factor.clone()));
                            product = before;
                        }
                    }
                }
                let Some(product) = product else { return Ok(None) };
                let (height, width) = size(&product);
                let scalar = scalars.iter().map(|(_, e)| nodes_in(e)).fold(1, usize::saturating_add);
                is_small(nodes_of(&product).saturating_add(scalar.saturating_mul(height.saturating_mul(width))))?;
                Some(each(product, &|entry| {
                    let factors = std::iter::once((Factor::Times, entry)).chain(scalars.iter().cloned());
                    if scalars.is_empty() {
                        factors.map(|f| f.1).next().unwrap_or(numeral(e.span, 0))
                    } else {
                        at(e.span, ExprKind::Product(factors.collect()))
                    }
                }))
            }
            _ => None,
        })
    }

    /// The entries of a square matrix.
    pub(super) fn square(&self, e: &Expr) -> Result<Rows, Unfit> {
        let rows = self.entries(e)?.ok_or(Unfit::NotWritten)?;
        let (height, width) = size(&rows);
        if height == width && height > 0 { Ok(rows) } else { Err(Unfit::NotSquare) }
    }

    /// The sum of the diagonal.
    pub(super) fn trace(&self, e: &Expr) -> Result<ExprKind, Unfit> {
        let rows = self.square(e)?;
        let mut diagonal: Vec<(Sign, Expr)> =
            rows.into_iter().enumerate().filter_map(|(i, row)| Some((Sign::Plus, row.into_iter().nth(i)?))).collect();
        match (diagonal.len(), diagonal.pop()) {
            (1, Some((_, only))) => Ok(only.kind),
            (_, last) => Ok(ExprKind::Sum(diagonal.into_iter().chain(last).collect())),
        }
    }

    /// The matrix of cofactors, turned over its diagonal, divided by the determinant.
    pub(super) fn inverse(&self, e: &Expr) -> Result<ExprKind, Unfit> {
        let rows = self.square(e)?;
        let span = e.span;
        // Each entry is in about as many cofactors as there are entries, and once in the determinant.
        is_small(nodes_of(&rows).saturating_mul(rows.len().saturating_mul(rows.len()).saturating_add(1)))?;
        let cofactor = |row: usize, column: usize| {
            let without = |list: &[Expr]| -> Vec<Expr> {
                list.iter().enumerate().filter(|(j, _)| *j != column).map(|(_, entry)| entry.clone()).collect()
            };
            let minor: Rows =
                rows.iter().enumerate().filter(|(i, _)| *i != row).map(|(_, list)| without(list)).collect();
            let value = match minor.as_slice() {
                [] => numeral(span, 1),
                [only] if only.len() == 1 => only[0].clone(),
                _ => apply(span, "det", at(span, ExprKind::Matrix(minor))),
            };
            if (row + column).is_multiple_of(2) { value } else { at(span, ExprKind::Negate(Box::new(value))) }
        };
        let n = rows.len();
        let turned = (0..n).map(|column| (0..n).map(|row| cofactor(row, column)).collect()).collect();
        let determinant = apply(span, "det", at(span, ExprKind::Matrix(rows.clone())));
        Ok(ExprKind::Product(vec![(Factor::Times, at(span, ExprKind::Matrix(turned))), (Factor::Over, determinant)]))
    }

    /// The power of a matrix to a whole numeral.
    pub(super) fn power(&self, base: &Expr, exponent: i64) -> Result<ExprKind, Unfit> {
        let n = self.square(base)?.len();
        let span = base.span;
        if exponent == 0 {
            let entry = |i: usize, j: usize| numeral(span, u32::from(i == j));
            return Ok(ExprKind::Matrix((0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect()));
        }
        let factor = if exponent > 0 { base.clone() } else { at(span, self.inverse(base)?) };
        let count = usize::try_from(exponent.unsigned_abs()).unwrap_or(usize::MAX);
        if count == 1 {
            return Ok(factor.kind);
        }
        Ok(ExprKind::Product(std::iter::repeat_n((Factor::Times, factor), count).collect()))
    }
}

fn size(rows: &Rows) -> (usize, usize) {
    (rows.len(), rows.first().map_or(0, Vec::len))
}

fn transposed(rows: &Rows) -> Rows {
    (0..size(rows).1).map(|column| rows.iter().map(|row| row[column].clone()).collect()).collect()
}

/// The number of nodes of all entries.
fn nodes_of(rows: &Rows) -> usize {
    rows.iter().flatten().map(nodes_in).fold(0, usize::saturating_add)
}

/// Refuses what has too many nodes.
fn is_small(nodes: usize) -> Result<(), Unfit> {
    if nodes > NODES_LIMIT { Err(Unfit::TooLarge) } else { Ok(()) }
}

/// The product of two matrices; `None` if their sizes do not fit.
fn times(a: &Rows, b: &Rows, span: Span) -> Result<Option<Rows>, Unfit> {
    if size(a).1 != size(b).0 {
        return Ok(None);
    }
    // Each entry of the one is multiplied by a whole row of the other.
    let (height, width) = (size(a).0, size(b).1);
    is_small(nodes_of(a).saturating_mul(width).saturating_add(nodes_of(b).saturating_mul(height)))?;
    let entry = |row: &[Expr], column: usize| {
        let products = row.iter().zip(b).map(|(x, other)| {
            let factors = vec![(Factor::Times, x.clone()), (Factor::Times, other[column].clone())];
            (Sign::Plus, at(span, ExprKind::Product(factors)))
        });
        let mut list: Vec<(Sign, Expr)> = products.collect();
        match (list.len(), list.pop()) {
            (1, Some((_, only))) => only,
            (_, last) => at(span, ExprKind::Sum(list.into_iter().chain(last).collect())),
        }
    };
    Ok(Some(a.iter().map(|row| (0..width).map(|column| entry(row, column)).collect()).collect()))
}
