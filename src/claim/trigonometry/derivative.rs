//! Derivatives with respect to an angle.

use super::{NODES_LIMIT, Writer};
use crate::claim::circle::{cosine_name, sine_name};
use crate::claim::definedness::number;
use crate::claim::matrix::{at, numeral};
use crate::claim::syntax::*;
use crate::claim::total;
use crate::claim::walk;

impl Writer<'_> {
    /// The derivative, with `+ 0*f` added where the function f may have no value. A summand without the angle has the derivative 0,
    /// and the summand may divide by something that can be 0: the derivative must have no value there either.
    pub(super) fn with_the_value_of(&self, derivative: Expr, function: &Expr) -> Expr {
        let plain = |name: &str| !self.applied.contains(name) && !self.values.contains_key(name);
        let named = |name: &str| match self.values.get(name) {
            Some(value) => total::has_a_value(value, &plain, &|_| false),
            None => plain(name),
        };
        if total::has_a_value(function, &named, &|_| false) {
            return derivative;
        }
        let span = derivative.span;
        let nothing = vec![(Factor::Times, numeral(span, 0)), (Factor::Times, function.clone())];
        let nothing = at(span, ExprKind::Product(nothing));
        at(span, ExprKind::Sum(vec![(Sign::Plus, derivative), (Sign::Plus, nothing)]))
    }

    /// The derivative with respect to an angle of an expression that is written out already. The rules are those for sums,
    /// products, quotients, whole powers, square roots, exp and ln; `None` for anything else.
    ///
    /// The angle is named by its part: `angle` is `theta_over_2` and `over` is 2 where θ/2 has the names. The derivative divides
    /// only by what the function divides by and by its roots: it has a value wherever the function is differentiable.
    pub(super) fn derivative(&mut self, of: &Expr, angle: &str, over: u32) -> Option<Expr> {
        let span = of.span;
        // A product of k factors has k terms, each with all factors.
        let copies = if let ExprKind::Product(list) = &of.kind { list.len() } else { 1 };
        self.nodes = self.nodes.saturating_add(walk::nodes_in(of).saturating_mul(copies));
        if self.nodes > NODES_LIMIT {
            return None;
        }
        Some(match &of.kind {
            ExprKind::Name(name) if *name == cosine_name(angle) || *name == sine_name(angle) => {
                let is_cosine = *name == cosine_name(angle);
                let other = if is_cosine { sine_name(angle) } else { cosine_name(angle) };
                let mut e = at(span, ExprKind::Name(other));
                if is_cosine {
                    e = at(span, ExprKind::Negate(Box::new(e)));
                }
                if over > 1 { product(span, vec![by(&e), divided(numeral(span, over))]) } else { e }
            }
            ExprKind::Name(name) => match self.values.get(name).cloned() {
                Some(value) => self.derivative(&value, angle, over)?,
                None => numeral(span, 0),
            },
            ExprKind::Number(_) => numeral(span, 0),
            ExprKind::Negate(a) => {
                let d = self.derivative(a, angle, over)?;
                if is_zero(&d) { d } else { at(span, ExprKind::Negate(Box::new(d))) }
            }
            ExprKind::Sum(list) => {
                let parts = list
                    .iter()
                    .map(|(sign, a)| Some((*sign, self.derivative(a, angle, over)?)))
                    .collect::<Option<Vec<_>>>()?;
                sum(span, parts.into_iter().filter(|(_, d)| !is_zero(d)).collect())
            }
            ExprKind::Product(list) => return self.product_rule(span, list, angle, over),
            ExprKind::Power(base, exponent) => return self.power_rule(span, base, exponent, angle, over),
            ExprKind::Apply(function, list) => return self.chain_rule(of, function, list, angle, over),
            _ => return None,
        })
    }

    /// Σ a₁⋯aₖ′⋯aₙ, where 1/a has the derivative −a′/a².
    fn product_rule(&mut self, span: Span, list: &[(Factor, Expr)], angle: &str, over: u32) -> Option<Expr> {
        let mut terms = Vec::new();
        for (place, (factor, a)) in list.iter().enumerate() {
            let d = self.derivative(a, angle, over)?;
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
    fn power_rule(&mut self, span: Span, base: &Expr, exponent: &Expr, angle: &str, over: u32) -> Option<Expr> {
        let d = self.derivative(base, angle, over)?;
        Some(match number(exponent) {
            _ if is_zero(&d) && is_zero(&self.derivative(exponent, angle, over)?) => numeral(span, 0),
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
    fn chain_rule(&mut self, of: &Expr, function: &Name, list: &[Expr], angle: &str, over: u32) -> Option<Expr> {
        let span = of.span;
        let a = list.first()?;
        let d = self.derivative(a, angle, over)?;
        Some(match function.text.as_str() {
            _ if list.len() == 1 && is_zero(&d) => numeral(span, 0),
            "sqrt" => product(span, vec![by(&d), divided(numeral(span, 2)), divided(of.clone())]),
            "exp" => product(span, vec![by(&d), by(of)]),
            "ln" => product(span, vec![by(&d), divided(a.clone())]),
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
fn sum(span: Span, list: Vec<(Sign, Expr)>) -> Expr {
    match list.as_slice() {
        [] => numeral(span, 0),
        [(Sign::Plus, only)] => only.clone(),
        _ => at(span, ExprKind::Sum(list)),
    }
}
