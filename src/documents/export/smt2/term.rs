//! Expressions as quotients of polynomials, and comparisons multiplied by their denominators.

use super::Writer;
use super::quotient::{Quotient, Value, common, factors, joined, times};
use crate::claim::definedness;
use crate::claim::syntax::*;
use crate::export::kinds::is_matrix;
use crate::export::{Result, unsupported};
use crate::number::rational;
use std::collections::BTreeMap;

/// The largest exponent that is written out as a product.
const MAX_POWER: u32 = 16;

impl Writer {
    fn scalar(&mut self, e: &Expr) -> Result<Quotient> {
        match self.value(e)? {
            Value::Scalar(q) => Ok(q),
            Value::Matrix(_) => unsupported(e.span, "a matrix where a number is needed"),
        }
    }

    /// A quotient's reciprocal; the divisor's sign is noted if it is plain.
    fn inverse(&mut self, e: &Expr, q: Quotient) -> Quotient {
        let above = times(factors(&q.below, &BTreeMap::new()));
        if q.above == "1" {
            return Quotient::whole(above);
        }
        if self.positive.holds(e, &self.kinds) && !self.plain.contains(&q.above) {
            self.plain.push(q.above.clone());
        }
        Quotient { above, below: BTreeMap::from([(q.above, 1)]) }
    }

    fn value(&mut self, e: &Expr) -> Result<Value> {
        Ok(Value::Scalar(match &e.kind {
            ExprKind::Number(text) => match rational::parse(text) {
                Ok(q) => {
                    let text = q.to_string();
                    Quotient::whole(match text.split_once('/') {
                        Some((a, b)) => format!("(/ {a} {b})"),
                        None => text,
                    })
                }
                Err(fault) => return unsupported(e.span, fault.to_string()),
            },
            ExprKind::Name(name) if name == "infinity" => return unsupported(e.span, "infinity as a number"),
            ExprKind::Name(name) => Quotient::whole(Self::symbol(name)),
            ExprKind::Negate(a) => return Ok(self.value(a)?.negated()),
            ExprKind::Sum(list) => {
                let values = list.iter().map(|(sign, e)| Ok((*sign, self.value(e)?))).collect::<Result<_>>()?;
                return Value::sum(values, list.iter().all(|(_, e)| !is_matrix(e, &self.kinds)), e.span);
            }
            ExprKind::Product(list) => return self.product(list),
            ExprKind::Power(base, exponent) => self.power(base, exponent, e.span)?,
            ExprKind::Apply(f, arguments) => match (f.text.as_str(), arguments.as_slice()) {
                ("sqrt", [a]) => self.root(2, a)?,
                ("cbrt", [a]) => self.root(3, a)?,
                ("det", [a]) => self.determinant(a, e.span)?,
                _ => return unsupported(f.span, format!("{} as a function", f.text)),
            },
            ExprKind::SumOver(..) | ExprKind::ProductOver(..) => {
                return unsupported(e.span, "a sum or product over an index");
            }
            ExprKind::IntegralOver(..) => return unsupported(e.span, "an integral"),
            ExprKind::Derivative(..) => return unsupported(e.span, "a derivative"),
            ExprKind::Matrix(rows) => {
                let rows = rows.iter().map(|r| r.iter().map(|e| self.scalar(e)).collect()).collect::<Result<_>>()?;
                return Ok(Value::Matrix(rows));
            }
        }))
    }

    fn product(&mut self, list: &[(Factor, Expr)]) -> Result<Value> {
        let mut out = Value::Scalar(Quotient::whole("1"));
        for (operator, factor) in list {
            let value = match (operator, self.value(factor)?) {
                (Factor::Times, value) => value,
                (Factor::Over, Value::Scalar(q)) => Value::Scalar(self.inverse(factor, q)),
                (Factor::Over, Value::Matrix(_)) => return unsupported(factor.span, "division by a matrix"),
            };
            out = out.product(value, factor.span)?;
        }
        Ok(out)
    }

    /// A power with a small whole exponent, written out.
    fn power(&mut self, base: &Expr, exponent: &Expr, span: Span) -> Result<Quotient> {
        let whole = definedness::number(exponent).filter(|q| q.1 == 1).map(|q| (q.0 < 0, q.0.unsigned_abs()));
        let small = |(negative, k)| Some((negative, u32::try_from(k).ok().filter(|k| *k <= MAX_POWER)?));
        let Some((negative, power)) = whole.and_then(small) else {
            return unsupported(span, "a power whose exponent is no small whole number");
        };
        let mut q = self.scalar(base)?;
        if negative {
            q = self.inverse(base, q);
        }
        let below = q.below.into_iter().map(|(f, p)| (f, p * power)).filter(|p| p.1 > 0).collect();
        Ok(Quotient { above: times(vec![q.above; power as usize]), below })
    }

    /// A determinant of two rows.
    fn determinant(&mut self, matrix: &Expr, span: Span) -> Result<Quotient> {
        let Value::Matrix(rows) = self.value(matrix)? else {
            return unsupported(span, "the determinant of a number");
        };
        let [[a, b], [c, d]] = rows.iter().map(Vec::as_slice).collect::<Vec<_>>()[..] else {
            return unsupported(span, "a determinant beyond two rows");
        };
        Ok(Quotient::total(&[a.clone().by(d), b.clone().by(c).negated()]))
    }

    /// A new variable for a root: its power times the denominator is the numerator.
    fn root(&mut self, degree: u32, under: &Expr) -> Result<Quotient> {
        let q = self.scalar(under)?;
        let below = times(factors(&q.below, &BTreeMap::new()));
        let key = (degree, q.above.clone(), below.clone());
        if let Some(root) = self.roots.get(&key) {
            return Ok(Quotient::whole(root.clone()));
        }
        self.fresh += 1;
        let root = Self::symbol(&format!("root {}", self.fresh));
        self.lines.push(format!("(declare-const {root} Real)"));
        let sign = if self.positive.holds(under, &self.kinds) { ">" } else { ">=" };
        // Below 0 the expression has no value, which is said apart; the root is then not restricted.
        let mut power = vec![root.clone(); degree as usize];
        power.push(below);
        let equation = format!("(and ({sign} {root} 0) (= {} {}))", times(power), q.above);
        let zero = Expr { kind: ExprKind::Number("0".to_string()), span: under.span };
        let has_value = self.compare(under, Relation::GreaterEqual, &zero)?;
        self.lines.push(match sign {
            ">" => format!("(assert {equation})"),
            _ => format!("(assert (=> {has_value} {equation}))"),
        });
        self.roots.insert(key, root.clone());
        Ok(Quotient::whole(root))
    }

    pub(super) fn compare(&mut self, a: &Expr, relation: Relation, b: &Expr) -> Result<String> {
        let (a, b) = match (self.value(a)?, self.value(b)?) {
            (Value::Scalar(a), Value::Scalar(b)) => (a, b),
            (Value::Matrix(a), Value::Matrix(b)) if relation == Relation::Equal => {
                let same = a.len() == b.len() && a.iter().zip(&b).all(|(a, b)| a.len() == b.len());
                if !same {
                    return unsupported(Span::default(), "an equation of different sizes");
                }
                let parts = a.iter().flatten().zip(b.iter().flatten());
                return Ok(joined("and", parts.map(|(a, b)| self.cleared(a, relation, b)).collect()));
            }
            _ => return unsupported(a.span, "a relation of matrices"),
        };
        Ok(self.cleared(&a, relation, &b))
    }

    /// The comparison, multiplied by the denominators.
    fn cleared(&self, a: &Quotient, relation: Relation, b: &Quotient) -> String {
        let (mut left, mut right) = (vec![a.above.clone()], vec![b.above.clone()]);
        let (more_left, more_right) = (factors(&b.below, &a.below), factors(&a.below, &b.below));
        if !matches!(relation, Relation::Equal | Relation::NotEqual) {
            // Whatever multiplies must be positive: what is not plainly so comes in squares.
            for (factor, power) in common([&a.below, &b.below].into_iter()) {
                if power % 2 == 1 && !self.plain.contains(&factor) {
                    left.push(factor.clone());
                    right.push(factor);
                }
            }
        }
        left.extend(more_left);
        right.extend(more_right);
        let (left, right) = (times(left), times(right));
        match relation {
            Relation::Equal => format!("(= {left} {right})"),
            Relation::NotEqual => format!("(not (= {left} {right}))"),
            Relation::Less => format!("(< {left} {right})"),
            Relation::LessEqual => format!("(<= {left} {right})"),
            Relation::Greater => format!("(> {left} {right})"),
            Relation::GreaterEqual => format!("(>= {left} {right})"),
        }
    }
}
