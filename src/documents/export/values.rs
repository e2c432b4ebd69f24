//! When the expressions of a statement have values.
//!
//! Contract: where all the [`Condition`]s of a statement hold, every expression in it has a value. The conditions are
//! those of [`definedness`], each under the bound names around it, but for those that hold by their form. They are
//! collected from statements whose definitions are put in place. Provers with total functions need them said.

use super::kinds::{Kind, Kinds, bind, is_natural, is_natural_name};
use super::positive::Positive;
use super::{Result, Unsupported};
use crate::claim::definedness::{self, Exponent, Need, Numerals, TooLong};
use crate::claim::syntax::*;
use crate::refute::expand::Statement;
use std::cmp::Ordering;

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

/// The conditions of a statement's sequences and goal.
///
/// # Errors
/// An exponent whose kind is not known.
pub(crate) fn of_statement(statement: &Statement, kinds: &Kinds, positive: &Positive) -> Result<Vec<Condition>> {
    let mut values = Collector::new(kinds, positive);
    for sequence in &statement.sequences {
        values.sequence(&sequence.initial, &sequence.index, &sequence.step)?;
    }
    values.prop(&statement.goal)?;
    Ok(values.found)
}

/// Collects conditions. Each of its functions stops at an exponent whose kind is not known.
pub struct Collector {
    kinds: Kinds,
    /// Indices that may be negative.
    whole: Vec<String>,
    positive: Positive,
    guards: Vec<Guard>,
    /// What was found.
    pub found: Vec<Condition>,
}

impl Collector {
    /// With the kinds of the names in scope, and those that are declared positive.
    pub fn new(kinds: &Kinds, positive: &Positive) -> Collector {
        Collector {
            kinds: kinds.clone(),
            whole: Vec::new(),
            positive: positive.clone(),
            guards: Vec::new(),
            found: Vec::new(),
        }
    }

    fn is_whole_name(&self, name: &str) -> bool {
        is_natural_name(name, &self.kinds) || self.whole.iter().any(|n| n == name)
    }

    fn need(&mut self, need: Need) {
        self.found.push(Condition { guards: self.guards.clone(), need });
    }

    fn under(&mut self, guard: Guard, work: impl FnOnce(&mut Self) -> Result<()>) -> Result<()> {
        let saved = (self.kinds.clone(), self.positive.clone());
        match &guard {
            Guard::Bindings(bindings) => {
                bind(bindings, &mut self.kinds);
                self.positive.declare(bindings);
            }
            Guard::Index(Index { name, from, .. }) if !is_natural(from, &self.kinds) => {
                self.whole.push(name.text.clone())
            }
            Guard::Index(Index { name, .. }) | Guard::Natural(name) => {
                self.kinds.insert(name.text.clone(), Kind::Natural);
            }
        }
        self.guards.push(guard);
        let result = work(self);
        self.guards.pop();
        (self.kinds, self.positive) = saved;
        result
    }

    /// For a sequence by recurrence: at 0 and at every step.
    ///
    /// # Errors
    /// An exponent whose kind is not known.
    pub fn sequence(&mut self, initial: &Expr, index: &str, step: &Expr) -> Result<()> {
        self.expr(initial)?;
        let name = Name { text: index.to_string(), span: step.span };
        self.under(Guard::Natural(name), |inner| inner.expr(step))
    }

    /// A divisor, or the base of a negative power: factor by factor.
    fn not_zero(&mut self, expr: &Expr) -> Result<()> {
        let too_long = |_| Unsupported::limit(TooLong::LIMIT, expr.span);
        match &expr.kind {
            ExprKind::Number(text) if text.bytes().any(|b| (b'1'..=b'9').contains(&b)) => {}
            ExprKind::Negate(a) => self.not_zero(a)?,
            ExprKind::Product(list) => {
                list.iter().filter(|(f, _)| *f == Factor::Times).try_for_each(|(_, e)| self.not_zero(e))?;
            }
            ExprKind::Power(base, exponent) => {
                let plain = self.positive.holds(base, &self.kinds);
                let kind = definedness::exponent(exponent, &|name| self.is_whole_name(name)).map_err(too_long)?;
                match (kind, definedness::numerals(exponent).ok().flatten()) {
                    // That the base is positive is a condition already.
                    (Exponent::Real, _) => {}
                    (Exponent::Root, _) if plain => {}
                    // b^0 is not 0 even where b is.
                    (Exponent::Whole, Some(Numerals { sign: Ordering::Equal, .. })) => {}
                    (Exponent::Whole, None) if !plain => self.need(Need::NotZero(expr.clone())),
                    (Exponent::Root | Exponent::Whole, _) => self.not_zero(base)?,
                }
            }
            _ => self.need(Need::NotZero(expr.clone())),
        }
        Ok(())
    }

    /// For an expression and its parts.
    ///
    /// # Errors
    /// An exponent whose kind is not known.
    pub fn expr(&mut self, expr: &Expr) -> Result<()> {
        let needs = definedness::needs(expr, &|name| self.is_whole_name(name));
        for need in needs.map_err(|_| Unsupported::limit(TooLong::LIMIT, expr.span))? {
            match need {
                Need::NotZero(e) => self.not_zero(&e)?,
                // A root of what is positive by its form is a power of the logarithm.
                Need::NotNegative(e) if self.positive.holds(&e, &self.kinds) && !is_square_root(expr) => {
                    self.need(Need::Positive(e));
                }
                Need::NotZeroOrNatural(_, e) if is_natural(&e, &self.kinds) => {}
                Need::NotZeroOrNatural(base, _) if self.positive.holds(&base, &self.kinds) => {
                    self.need(Need::Positive(base));
                }
                Need::Range(from, to) if is_natural(&to, &self.kinds) && plain_range(&from, &to) => {}
                need => self.need(need),
            }
        }
        if let ExprKind::SumOver(index, body) | ExprKind::ProductOver(index, body) = &expr.kind {
            self.expr(&index.from)?;
            self.expr(&index.to)?;
            return self.under(Guard::Index(index.clone()), |inner| inner.expr(body));
        }
        let mut result = Ok(());
        crate::refute::expand::parts(expr, &mut |part| {
            if result.is_ok() {
                result = self.expr(part);
            }
        });
        result
    }

    /// For a proposition; what stands under `exists` is said there.
    ///
    /// # Errors
    /// An exponent whose kind is not known.
    pub fn prop(&mut self, prop: &Prop) -> Result<()> {
        match &prop.kind {
            PropKind::Compare(sides, _) => sides.iter().try_for_each(|e| self.expr(e)),
            PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => {
                list.iter().try_for_each(|p| self.prop(p))
            }
            PropKind::Not(p) => self.prop(p),
            PropKind::Implies(p, q) => {
                self.prop(p)?;
                self.prop(q)
            }
            PropKind::Exists(..) => Ok(()),
            PropKind::ForAll(bindings, body) => self.under(Guard::Bindings(bindings.clone()), |inner| inner.prop(body)),
            PropKind::Extremum(extremum) => {
                extremum.at.iter().try_for_each(|(_, e)| self.expr(e))?;
                self.expr(&extremum.value)?;
                self.under(Guard::Bindings(extremum.over.clone()), |inner| inner.expr(&extremum.of))
            }
            PropKind::Limit(limit) => {
                self.expr(&limit.of)?;
                self.expr(&limit.value)
            }
            PropKind::WrittenLimit(_) => Ok(()),
        }
    }
}

fn is_square_root(e: &Expr) -> bool {
    matches!(&e.kind, ExprKind::Apply(f, _) if f.text == "sqrt")
}

/// Whether a range that ends at a natural number cannot end before it begins, by its form: it begins at 0 or 1, or at a
/// summand of its end.
fn plain_range(from: &Expr, to: &Expr) -> bool {
    let summand = match &to.kind {
        ExprKind::Sum(list) => list.iter().any(|(_, e)| e == from) && list.iter().all(|(s, _)| *s == Sign::Plus),
        _ => to == from,
    };
    summand || matches!(definedness::number(from), Some((0..=1, 1)))
}
