//! Matrices: their entries as sides of identities.

use super::identity::Side;
use super::*;

impl Writer<'_> {
    /// The entries of a matrix.
    pub(super) fn entries(&mut self, e: &Expr) -> Found<Vec<Vec<Side>>> {
        let times = |c: &Side, rows: Vec<Vec<Side>>| -> Vec<Vec<Side>> {
            rows.into_iter().map(|row| row.into_iter().map(|x| c.clone().times(x)).collect()).collect()
        };
        let add = |a: Vec<Side>, b: Vec<Side>| -> Vec<Side> { a.into_iter().zip(b).map(|(x, y)| x.plus(y)).collect() };
        Ok(match &e.kind {
            ExprKind::Matrix(rows) => {
                rows.iter().map(|row| row.iter().map(|x| Side::Expr(x.clone())).collect()).collect()
            }
            ExprKind::Negate(inner) => times(&minus_one(), self.entries(inner)?),
            ExprKind::Sum(list) => {
                let mut out: Option<Vec<Vec<Side>>> = None;
                for (sign, part) in list {
                    let mut rows = self.entries(part)?;
                    if *sign == Sign::Minus {
                        rows = times(&minus_one(), rows);
                    }
                    out = Some(match out {
                        None => rows,
                        Some(before) => before.into_iter().zip(rows).map(|(a, b)| add(a, b)).collect(),
                    });
                }
                out.unwrap_or_default()
            }
            ExprKind::Product(list) => {
                let (mut numbers, mut out) = (Vec::new(), None::<Vec<Vec<Side>>>);
                for (operator, part) in list {
                    if !self.checker.is_matrix(part) {
                        numbers.push((*operator, part.clone()));
                        continue;
                    }
                    let rows = self.entries(part)?;
                    out = Some(match out {
                        None => rows,
                        Some(before) => before.into_iter().map(|row| row_times(row, &rows)).collect(),
                    });
                }
                let out = out.unwrap_or_default();
                if numbers.is_empty() {
                    return Ok(out);
                }
                if numbers.first().is_some_and(|n| n.0 == Factor::Over) {
                    numbers.insert(0, (Factor::Times, expr(ExprKind::Number("1".to_string()))));
                }
                let c = match numbers.as_slice() {
                    [(Factor::Times, one)] => one.clone(),
                    _ => expr(ExprKind::Product(numbers)),
                };
                times(&Side::Expr(c), out)
            }
            _ => return Err(Open::Untranslated("matrix".to_string(), "its entries")),
        })
    }
}

/// `- 1` as the statement writes it.
fn minus_one() -> Side {
    Side::Expr(expr(ExprKind::Negate(Box::new(expr(ExprKind::Number("1".to_string()))))))
}

fn row_times(row: Vec<Side>, rows: &[Vec<Side>]) -> Vec<Side> {
    let mut out: Option<Vec<Side>> = None;
    for (x, b) in row.into_iter().zip(rows).rev() {
        let scaled: Vec<Side> = b.iter().map(|y| x.clone().times(y.clone())).collect();
        out = Some(match out {
            None => scaled,
            Some(after) => scaled.into_iter().zip(after).map(|(s, t)| s.plus(t)).collect(),
        });
    }
    out.unwrap_or_default()
}
