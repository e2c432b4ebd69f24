//! When the expressions of a statement have values.
//!
//! Contract: where all the [`Condition`]s of a statement hold, no division by 0, no root or logarithm
//! of a negative number and no derivative of a function without one occurs in it. They are collected
//! from statements whose definitions are put in place. Provers with total functions need them said.

use super::kinds::{Kinds, bind, is_natural};
use crate::claim::syntax::*;

/// What must hold.
#[derive(Clone, Debug)]
pub enum Need {
    /// A divisor.
    NotZero(Expr),
    /// The base of a power with a real exponent, or under a logarithm.
    Positive(Expr),
    /// Under a square root.
    NotNegative(Expr),
    /// Has so many derivatives by the variable, at it.
    Differentiable(Expr, Name, usize),
}

/// What a condition is said of.
#[derive(Clone, Debug)]
pub enum Guard {
    /// All values of bound variables.
    Bindings(Vec<Binding>),
    /// All values of an index of a sum or product.
    Index(Index),
    /// All natural numbers.
    Natural(Name),
}

/// A need under its guards.
#[derive(Clone, Debug)]
pub struct Condition {
    /// The guards, the outermost first.
    pub guards: Vec<Guard>,
    /// The need.
    pub need: Need,
}

/// Collects conditions.
pub struct Collector {
    kinds: Kinds,
    guards: Vec<Guard>,
    /// What was found.
    pub found: Vec<Condition>,
}

impl Collector {
    /// With the kinds of the names in scope.
    pub fn new(kinds: Kinds) -> Collector {
        Collector { kinds, guards: Vec::new(), found: Vec::new() }
    }

    fn need(&mut self, need: Need) {
        self.found.push(Condition { guards: self.guards.clone(), need });
    }

    fn under(&mut self, guard: Guard, work: impl FnOnce(&mut Collector)) {
        let saved = self.kinds.clone();
        match &guard {
            Guard::Bindings(bindings) => bind(bindings, &mut self.kinds),
            Guard::Index(Index { name, .. }) | Guard::Natural(name) => {
                self.kinds.insert(name.text.clone(), super::kinds::Kind::Natural);
            }
        }
        self.guards.push(guard);
        work(self);
        self.guards.pop();
        self.kinds = saved;
    }

    /// For a sequence by recurrence: at 0 and at every step.
    pub fn sequence(&mut self, initial: &Expr, index: &str, step: &Expr) {
        self.expr(initial);
        let name = Name { text: index.to_string(), span: step.span };
        self.under(Guard::Natural(name), |inner| inner.expr(step));
    }

    fn not_zero(&mut self, expr: &Expr) {
        match &expr.kind {
            ExprKind::Number(text) if text.bytes().any(|b| (b'1'..=b'9').contains(&b)) => {}
            ExprKind::Negate(a) => self.not_zero(a),
            ExprKind::Product(list) => {
                list.iter().filter(|(f, _)| *f == Factor::Times).for_each(|(_, e)| self.not_zero(e));
            }
            ExprKind::Power(base, exponent) => {
                if integer_exponent(exponent, &self.kinds) {
                    self.not_zero(base);
                }
            }
            _ => self.need(Need::NotZero(expr.clone())),
        }
    }

    /// For an expression and its parts.
    pub fn expr(&mut self, expr: &Expr) {
        match &expr.kind {
            ExprKind::SumOver(index, body) | ExprKind::ProductOver(index, body) => {
                self.expr(&index.from);
                self.expr(&index.to);
                self.under(Guard::Index(index.clone()), |inner| inner.expr(body));
                return;
            }
            ExprKind::Derivative(body, by) => {
                if let Some(name) = by.first() {
                    self.need(Need::Differentiable((**body).clone(), name.clone(), by.len()));
                }
            }
            ExprKind::Product(list) => {
                for (_, divisor) in list.iter().filter(|(f, _)| *f == Factor::Over) {
                    self.not_zero(divisor);
                }
            }
            ExprKind::Power(base, exponent) => {
                if !integer_exponent(exponent, &self.kinds) {
                    self.need(Need::Positive((**base).clone()));
                } else if matches!(exponent.kind, ExprKind::Negate(_)) {
                    self.not_zero(base);
                }
            }
            ExprKind::Apply(f, arguments) => match (f.text.as_str(), arguments.first()) {
                ("sqrt", Some(a)) => self.need(Need::NotNegative(a.clone())),
                ("cbrt" | "ln", Some(a)) => self.need(Need::Positive(a.clone())),
                _ => {}
            },
            _ => {}
        }
        crate::prove::expand::parts(expr, &mut |part| self.expr(part));
    }

    /// For a proposition; what stands under `exists` is said there.
    pub fn prop(&mut self, prop: &Prop) {
        match &prop.kind {
            PropKind::Compare(sides, _) => sides.iter().for_each(|e| self.expr(e)),
            PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => {
                list.iter().for_each(|p| self.prop(p));
            }
            PropKind::Not(p) => self.prop(p),
            PropKind::Implies(p, q) => {
                self.prop(p);
                self.prop(q);
            }
            PropKind::Exists(..) => {}
            PropKind::ForAll(bindings, body) => {
                self.under(Guard::Bindings(bindings.clone()), |inner| inner.prop(body));
            }
            PropKind::Extremum(extremum) => {
                extremum.at.iter().for_each(|(_, e)| self.expr(e));
                self.expr(&extremum.value);
                self.under(Guard::Bindings(extremum.over.clone()), |inner| inner.expr(&extremum.of));
            }
            PropKind::Limit(limit) => {
                self.expr(&limit.of);
                self.expr(&limit.value);
            }
        }
    }
}

/// Whether an exponent is a natural number, or the negative of a numeral that is one.
pub fn integer_exponent(exponent: &Expr, kinds: &Kinds) -> bool {
    match &exponent.kind {
        ExprKind::Negate(a) => matches!(&a.kind, ExprKind::Number(_)) && is_natural(a, kinds),
        _ => is_natural(exponent, kinds),
    }
}
