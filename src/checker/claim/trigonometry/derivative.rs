//! Derivatives with respect to an angle.

use super::{NODES_LIMIT, Writer};
use crate::claim::definedness::number;
use crate::claim::matrix::{at, numeral};
use crate::claim::syntax::*;
use crate::claim::walk;
use crate::claim::{abbreviation, floor, total};

/// The part of an angle by which is differentiated: the names of its cosine and sine, and how often it is in the angle.
#[derive(Clone)]
pub(super) struct Part {
    cos: String,
    sin: String,
    over: u32,
}

impl Writer<'_> {
    /// The derivatives of a function by some names in turn, at least one of which is an angle. The function is written out.
    pub(super) fn derivatives(&mut self, of: &Expr, by: &[Name], span: Span) -> Option<Expr> {
        // What a definition stands for may depend on the angle, so it is put in.
        let mut out = match self.values.expr(of) {
            Ok(out) => out,
            Err(obstacle) => {
                self.refused(obstacle, span);
                return None;
            }
        };
        for name in by {
            let Some(part) =
                self.angles.get(&name.text).map(|v| Part { cos: v.cos.clone(), sin: v.sin.clone(), over: v.over })
            else {
                out = at(span, ExprKind::Derivative(Box::new(out), vec![name.clone()]));
                continue;
            };
            if let Some(other) = self.tied_to(&name.text) {
                let message = format!("a derivative by {} is ambiguous: a hypothesis ties {0} to {other}", name.text);
                let help = "put the hypothesis into the function: write it in one variable";
                self.fault(message, help, span);
                return None;
            }
            let Some(found) = self.derivative(&out, &part) else {
                if self.nodes > NODES_LIMIT {
                    self.limit("nodes of angles written out", NODES_LIMIT, span);
                } else {
                    let help = "sums, products, quotients, whole powers, sqrt, exp and ln can be; \
                                write the derivative out";
                    self.fault("this cannot be differentiated with respect to an angle".to_string(), help, span);
                }
                return None;
            };
            out = self.with_the_value_of(found, &out);
        }
        Some(out)
    }

    /// The derivative, with `+ 0*f` added where the function f may have no value. A summand without the angle has the derivative 0,
    /// and the summand may divide by something that can be 0: the derivative must have no value there either.
    fn with_the_value_of(&self, derivative: Expr, function: &Expr) -> Expr {
        if total::has_a_value(function, &|name| !self.applied.contains(name), &|_| false) {
            return derivative;
        }
        let span = derivative.span;
        let nothing = vec![(Factor::Times, numeral(span, 0)), (Factor::Times, function.clone())];
        let nothing = at(span, ExprKind::Product(nothing));
        at(span, ExprKind::Sum(vec![(Sign::Plus, derivative), (Sign::Plus, nothing)]))
    }

    /// The derivative with respect to an angle of an expression that is written out already, definitions put in. The rules are
    /// those for sums, products, quotients, whole powers, square roots, exp and ln; `None` for anything else.
    ///
    /// No hypothesis ties the angle to another variable, so that a variable has the derivative 0. A member of a family or
    /// sequence may depend on the angle: it has no derivative here.
    ///
    /// The derivative divides only by what the function divides by and by its roots: it has a value wherever the function is
    /// differentiable.
    fn derivative(&mut self, of: &Expr, part: &Part) -> Option<Expr> {
        let span = of.span;
        // A product of k factors has k terms, each with all factors.
        let copies = if let ExprKind::Product(list) = &of.kind { list.len() } else { 1 };
        self.nodes = self.nodes.saturating_add(walk::nodes_in(of).saturating_mul(copies));
        if self.nodes > NODES_LIMIT {
            return None;
        }
        Some(match &of.kind {
            ExprKind::Name(name) if *name == part.cos || *name == part.sin => {
                let is_cosine = *name == part.cos;
                let other = if is_cosine { part.sin.clone() } else { part.cos.clone() };
                let mut e = at(span, ExprKind::Name(other));
                if is_cosine {
                    e = at(span, ExprKind::Negate(Box::new(e)));
                }
                if part.over > 1 { product(span, vec![by(&e), divided(numeral(span, part.over))]) } else { e }
            }
            ExprKind::Number(_) | ExprKind::Name(_) => numeral(span, 0),
            ExprKind::Negate(a) => {
                let d = self.derivative(a, part)?;
                if is_zero(&d) { d } else { at(span, ExprKind::Negate(Box::new(d))) }
            }
            ExprKind::Sum(list) => {
                let parts = list
                    .iter()
                    .map(|(sign, a)| Some((*sign, self.derivative(a, part)?)))
                    .collect::<Option<Vec<_>>>()?;
                sum(span, parts.into_iter().filter(|(_, d)| !is_zero(d)).collect())
            }
            ExprKind::Product(list) => return self.product_rule(span, list, part),
            ExprKind::Power(base, exponent) => return self.power_rule(span, base, exponent, part),
            ExprKind::Apply(function, list) => return self.chain_rule(of, function, list, part),
            ExprKind::SumOver(..) | ExprKind::ProductOver(..) | ExprKind::Derivative(..) | ExprKind::Matrix(_) => {
                return None;
            }
        })
    }

    /// Σ a₁⋯aₖ′⋯aₙ, where 1/a has the derivative −a′/a².
    fn product_rule(&mut self, span: Span, list: &[(Factor, Expr)], part: &Part) -> Option<Expr> {
        let mut terms = Vec::new();
        for (place, (factor, a)) in list.iter().enumerate() {
            let d = self.derivative(a, part)?;
            if is_zero(&d) {
                continue;
            }
            let mut factors = list.to_vec();
            let sign = match factor {
                Factor::Times => {
                    factors[place] = (Factor::Times, d);
                    Sign::Plus
                }
                // (1/a)′ = −a′/a².
                Factor::Over => {
                    factors[place] =
                        (Factor::Over, at(span, ExprKind::Power(Box::new(a.clone()), Box::new(numeral(span, 2)))));
                    factors.push((Factor::Times, d));
                    Sign::Minus
                }
            };
            if factors[0].0 == Factor::Over {
                factors.insert(0, (Factor::Times, numeral(span, 1)));
            }
            terms.push((sign, product(span, factors)));
        }
        if let [(Sign::Minus, only)] = terms.as_slice() {
            return Some(at(span, ExprKind::Negate(Box::new(only.clone()))));
        }
        if let Some((Sign::Minus, _)) = terms.first() {
            terms.insert(0, (Sign::Plus, numeral(span, 0)));
        }
        Some(sum(span, terms))
    }

    /// k·b^(k − 1)·b′ for a whole number k.
    fn power_rule(&mut self, span: Span, base: &Expr, exponent: &Expr, part: &Part) -> Option<Expr> {
        let d = self.derivative(base, part)?;
        Some(match number(exponent) {
            _ if is_zero(&d) && is_zero(&self.derivative(exponent, part)?) => numeral(span, 0),
            Some((0, 1)) => numeral(span, 0),
            Some((k, 1)) => {
                let less = |k: i128| match u32::try_from(k) {
                    Ok(k) => Some(numeral(span, k)),
                    Err(_) => Some(at(span, ExprKind::Negate(Box::new(numeral(span, u32::try_from(-k).ok()?))))),
                };
                let power = at(span, ExprKind::Power(Box::new(base.clone()), Box::new(less(k - 1)?)));
                product(span, vec![by(exponent), by(&power), by(&d)])
            }
            _ => return None,
        })
    }

    /// The derivatives of sqrt, exp and ln.
    fn chain_rule(&mut self, of: &Expr, function: &Name, list: &[Expr], part: &Part) -> Option<Expr> {
        let span = of.span;
        // A function of the language, and no family, sequence or definition of the claim, depends on its arguments alone.
        let is_known = FUNCTIONS.iter().any(|f| f.0 == function.text)
            || abbreviation::is_one(&function.text)
            || floor::is_function(&function.text);
        if !is_known || self.applied.contains(&function.text) {
            return None;
        }
        let inner = list.iter().map(|a| self.derivative(a, part)).collect::<Option<Vec<Expr>>>()?;
        if inner.iter().all(is_zero) {
            return Some(numeral(span, 0));
        }
        let ([a], [d]) = (list, inner.as_slice()) else { return None };
        Some(match function.text.as_str() {
            "sqrt" => product(span, vec![by(d), divided(numeral(span, 2)), divided(of.clone())]),
            "exp" => product(span, vec![by(d), by(of)]),
            "ln" => product(span, vec![by(d), divided(a.clone())]),
            _ => return None,
        })
    }
}

fn is_zero(e: &Expr) -> bool {
    matches!(&e.kind, ExprKind::Number(text) if text == "0")
}

/// A factor.
fn by(e: &Expr) -> (Factor, Expr) {
    (Factor::Times, e.clone())
}

/// A divisor.
fn divided(e: Expr) -> (Factor, Expr) {
    (Factor::Over, e)
}

fn product(span: Span, factors: Vec<(Factor, Expr)>) -> Expr {
    at(span, ExprKind::Product(factors))
}

/// A sum of any number of summands.
fn sum(span: Span, mut list: Vec<(Sign, Expr)>) -> Expr {
    match list.as_slice() {
        [] => numeral(span, 0),
        [(Sign::Plus, only)] => only.clone(),
        [(Sign::Minus, only)] => at(span, ExprKind::Negate(Box::new(only.clone()))),
        // A sum begins with what is added.
        [(Sign::Minus, _), ..] => {
            list.insert(0, (Sign::Plus, numeral(span, 0)));
            at(span, ExprKind::Sum(list))
        }
        _ => at(span, ExprKind::Sum(list)),
    }
}
