//! Conditions under which expressions have values, shown where the kernel does not see them itself.

use super::letters::natural;
use super::limits::holds;
use super::values::over;
use super::{Fail, Prover};
use crate::claim::definedness::{Need, needs};
use crate::claim::syntax::*;
use crate::kernel::key;
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, expr, name, numeral, prop};
use crate::kernel::substitution::Substitution;

impl Prover {
    /// Proves the conditions under which an expression has a value, if the kernel does not see them itself.
    pub(crate) fn define(&mut self, e: &Expr) {
        match &e.kind {
            ExprKind::Number(_) | ExprKind::Name(_) => {}
            ExprKind::Apply(_, list) => list.iter().for_each(|e| self.define(e)),
            ExprKind::Negate(a) => self.define(a),
            ExprKind::Sum(list) => list.iter().for_each(|(_, e)| self.define(e)),
            ExprKind::Product(list) => list.iter().for_each(|(_, e)| self.define(e)),
            ExprKind::Power(a, b) => [a, b].into_iter().for_each(|e| self.define(e)),
            ExprKind::SumOver(index, body) | ExprKind::ProductOver(index, body) => {
                self.define(&index.from);
                self.define(&index.to);
                self.define_members(&index.name, body);
            }
            ExprKind::Derivative(body, _) => return self.define(body),
            ExprKind::Matrix(rows) => rows.iter().flatten().for_each(|e| self.define(e)),
        }
        let naturals = self.naturals.clone();
        for need in needs(e, &|name| naturals.iter().any(|n| n == name)).into_iter().flatten() {
            let zero = numeral(0);
            match need {
                Need::NotZero(d) => self.nonzero(&d),
                Need::Positive(b) => self.sign(&b, Relation::Greater, &zero),
                Need::NotNegative(b) => {
                    // A root of something positive may be divided by. A square is positive where its base is not 0, which the kernel
                    // sees or not.
                    let reading = self.read(&b, false);
                    let is_square = reading.is_some_and(|r| r.number > 0 && r.factors.iter().all(|f| f.power % 2 == 0));
                    if !is_square {
                        self.sign(&b, Relation::Greater, &zero);
                    }
                    self.sign(&b, Relation::GreaterEqual, &zero);
                }
                Need::NotZeroOrNatural(b, k) => {
                    if !self.signs_of(&k).within(Signs::NOT_NEGATIVE) {
                        self.nonzero(&b);
                    }
                }
                Need::Range(from, to) => {
                    let next = expr(ExprKind::Sum(vec![(Sign::Plus, to), (Sign::Plus, numeral(1))]));
                    self.sign(&next, Relation::GreaterEqual, &from);
                }
                Need::Differentiable(..) => {}
            }
        }
    }

    /// Shows for all values of a name that products over an index, such as factorials, by which an expression divides, are positive:
    /// for the index of a sum, and for the variable of an induction.
    fn define_members(&mut self, bound: &Name, body: &Expr) {
        let mut divisors = Vec::new();
        products_divided_by(body, &bound.text, false, &mut divisors);
        for (at, factor) in divisors {
            let key = format!("{} in {}", key::expr(&over(false, at.clone(), &factor)), bound.text);
            if self.failed.contains(&key) || !self.enriched.insert(key.clone()) {
                continue;
            }
            let own = self.fresh("j");
            let mut renamed = Substitution::default();
            renamed.replace(&at.name.text, &name(&own));
            let Ok(factor) = renamed.expr(&factor) else { continue };
            let product = over(false, Index { name: Name::new(own), ..at }, &factor);
            let binding = Binding::of(bound.clone(), true, Vec::new());
            let positive = compare(product, Relation::Greater, numeral(0));
            match self.quietly(&prop(PropKind::ForAll(vec![binding], Box::new(positive)))) {
                Ok(label) => {
                    self.own_indices.insert(label);
                }
                Err(_) => {
                    self.enriched.remove(&key);
                    self.failed.insert(key);
                }
            }
        }
    }

    /// The same for a statement for all values of a name and for what stands under the indices in it.
    pub(super) fn define_for_all(&mut self, bound: &Name, p: &Prop) {
        let mut sides = Vec::new();
        super::goals::sides_in(p, &mut sides);
        for e in &sides {
            self.define_members(bound, e);
            self.define_under_indices(e);
        }
    }

    fn define_under_indices(&mut self, e: &Expr) {
        if let ExprKind::SumOver(index, body) | ExprKind::ProductOver(index, body) = &e.kind {
            self.define_members(&index.name, body);
        }
        crate::claim::walk::parts(e, &mut |part| self.define_under_indices(part));
    }

    fn sign(&mut self, e: &Expr, relation: Relation, bound: &Expr) {
        let seen = natural(bound) == Some(0) && self.signs_of(e).within(Signs::of(relation));
        if !seen {
            let _ = self.quietly(&compare(e.clone(), relation, bound.clone()));
        }
    }

    /// Shows that an expression is not 0, if little effort does.
    pub(super) fn nonzero(&mut self, e: &Expr) {
        if self.signs_of(e).within(Signs::NOT_ZERO) {
            return;
        }
        for relation in [Relation::Greater, Relation::Less, Relation::NotEqual] {
            if self.quietly(&compare(e.clone(), relation, numeral(0))).is_ok() {
                return;
            }
        }
    }

    /// A product of numbers that are positive by their form, such as n!, is positive: by induction on its end. With it one may
    /// divide by it.
    pub(super) fn positive_product(&mut self, e: &Expr, index: &Index, body: &Expr) -> Result<(), Fail> {
        let positive = |e: Expr| compare(e, Relation::Greater, numeral(0));
        let plain = self.letters.polynomial(body).zip(self.letters.polynomial(&index.from)).is_some_and(|(p, from)| {
            let own = |v: u32| matches!(self.letters.expr(v), Some(Expr { kind: ExprKind::Name(n), .. }) if *n == index.name.text);
            !p.is_zero()
                && p.terms().all(|(_, c)| *c > 0)
                && p.variables().into_iter().all(own)
                && from.as_constant().is_some_and(|c| c >= 1)
        });
        if !plain || self.known(&positive(e.clone())).is_some() {
            return Err(Fail::No("a product of positive numbers"));
        }
        let fresh = self.fresh("k");
        let to = Box::new(crate::kernel::statement::name(&fresh));
        let product = expr(ExprKind::ProductOver(Index { to, ..index.clone() }, Box::new(body.clone())));
        let binding = Binding::of(Name::new(fresh), true, Vec::new());
        let every = prop(PropKind::ForAll(vec![binding], Box::new(positive(product))));
        let (splits, inductions) = (std::mem::take(&mut self.splits), std::mem::take(&mut self.inductions));
        let shown = self.all_by_induction(&every, 3);
        (self.splits, self.inductions) = (splits, inductions);
        self.instance(&shown?, &index.to).map(|_| ())
    }
}

/// The products over an index in what an expression divides by, if they depend on a name.
fn products_divided_by(e: &Expr, name: &str, divided: bool, out: &mut Vec<(Index, Expr)>) {
    match &e.kind {
        ExprKind::Product(list) => {
            list.iter().for_each(|(f, e)| products_divided_by(e, name, divided || *f == Factor::Over, out));
        }
        ExprKind::ProductOver(index, body) if divided && holds(e, name) => out.push((index.clone(), (**body).clone())),
        _ => crate::claim::walk::parts(e, &mut |part| products_divided_by(part, name, divided, out)),
    }
}
