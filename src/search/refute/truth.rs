//! The truth of propositions at an exact point.
//!
//! Contract: a truth value is given only when it is certain. *Undefined* means that an expression has no value at the point;
//! *unknown* that intervals do not decide. Neither is ever taken for false.

use super::evaluate::Assignment;
use super::matrix::{Value, same_size};
use super::number::{self, Missing, Number, Result, holds};
use super::outcome::Broken;
use crate::claim::print;
use crate::claim::syntax::*;
use crate::claim::walk::parts;
use crate::kernel::statement::prop;
use malachite::Rational;
use malachite::base::num::basic::traits::Zero;

impl Assignment {
    /// Whether a side of some comparison certainly has no value.
    pub fn undefined(&self, prop: &Prop) -> bool {
        match &prop.kind {
            PropKind::Compare(sides, _) => sides.iter().any(|e| matches!(self.value(e), Err(Missing::Undefined(_)))),
            PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => {
                list.iter().any(|p| self.undefined(p))
            }
            PropKind::Not(p) => self.undefined(p),
            PropKind::Implies(p, q) => self.undefined(p) || self.undefined(q),
            _ => false,
        }
    }

    /// The truth of a proposition, if certain. Extrema are not decided here.
    pub fn truth(&self, said: &Prop) -> Result<bool> {
        match &said.kind {
            PropKind::Compare(sides, relations) => self.compared(sides, relations),
            PropKind::And(list) => self.conjunction(list),
            PropKind::Or(list) => self.disjunction(list),
            PropKind::Not(inner) => Ok(!self.truth(inner)?),
            PropKind::Implies(p, q) => {
                if self.truth(p)? {
                    self.truth(q)
                } else {
                    Ok(true)
                }
            }
            PropKind::Equivalent(list) => {
                let first = list.first().map_or(Ok(true), |p| self.truth(p))?;
                for part in &list[1..] {
                    if self.truth(part)? != first {
                        return Ok(false);
                    }
                }
                Ok(true)
            }
            PropKind::Exists(bindings, body) => self.exists(bindings, body),
            PropKind::ForAll(bindings, body) => match self.for_all_indices(bindings, body) {
                Err(Missing::Unknown) => self.exists(bindings, &prop(PropKind::Not(body.clone()))).map(|some| !some),
                known => known,
            },
            _ => Err(Missing::Unknown),
        }
    }

    /// Whether a chain of comparisons holds.
    fn compared(&self, sides: &[Expr], relations: &[Relation]) -> Result<bool> {
        let values: Vec<Value> = sides.iter().map(|e| self.value(e)).collect::<Result<_>>()?;
        let mut unknown = false;
        for (place, (pair, relation)) in values.windows(2).zip(relations).enumerate() {
            match (&pair[0], &pair[1]) {
                (Value::Scalar(_), Value::Scalar(_)) if self.identical(&sides[place], &sides[place + 1]) => {
                    if !matches!(relation, Relation::Equal | Relation::LessEqual | Relation::GreaterEqual) {
                        return Ok(false);
                    }
                }
                (Value::Scalar(a), Value::Scalar(b)) => match holds(a, *relation, b) {
                    Some(false) => return Ok(false),
                    Some(true) => {}
                    None => unknown = true,
                },
                (Value::Matrix(a), Value::Matrix(b)) => match matrices_hold(a, *relation, b)? {
                    Some(false) => return Ok(false),
                    Some(true) => {}
                    None => unknown = true,
                },
                _ => return Err(Missing::Unknown),
            }
        }
        if unknown { Err(Missing::Unknown) } else { Ok(true) }
    }

    /// Whether all parts hold.
    fn conjunction(&self, list: &[Prop]) -> Result<bool> {
        let mut unknown = None;
        for part in list {
            match self.truth(part) {
                Ok(false) => return Ok(false),
                Ok(true) => {}
                Err(missing) => unknown = Some(missing),
            }
        }
        unknown.map_or(Ok(true), Err)
    }

    /// Whether a part holds.
    fn disjunction(&self, list: &[Prop]) -> Result<bool> {
        let (mut unknown, mut holds) = (None, false);
        for part in list {
            match self.truth(part) {
                Ok(truth) => holds |= truth,
                // Whether a part without a value spoils the others is a matter of taste: nothing rests on it.
                Err(missing) => unknown = Some(missing),
            }
        }
        match unknown {
            Some(Missing::Undefined(_)) if holds => Err(Missing::Unknown),
            Some(missing) if !holds => Err(missing),
            _ => Ok(holds),
        }
    }

    fn identical(&self, a: &Expr, b: &Expr) -> bool {
        !self.identities.is_empty() && self.identities.contains(&(print::expr(a), print::expr(b)))
    }

    /// `for all k natural: P` where every family is constant and k stands in indices only: then P does
    /// not depend on k, and one value decides.
    fn for_all_indices(&self, bindings: &[Binding], body: &Prop) -> Result<bool> {
        let [Binding { names, natural: true, constraints, indices: None, .. }] = bindings else {
            return Err(Missing::Unknown);
        };
        let constant = self.families.values().all(|list| list.iter().all(|q| *q == list[0]));
        let [(name, None)] = names.as_slice() else { return Err(Missing::Unknown) };
        // A member out of its range has no value.
        if !constraints.is_empty() || !self.ranges.is_empty() {
            return Err(Missing::Unknown);
        }
        if !self.ratios.is_empty() {
            return self.for_all_powers(body, &name.text);
        }
        if !constant || !self.only_index(body, &name.text) {
            return Err(Missing::Unknown);
        }
        let mut inner = self.clone();
        inner.indices.insert(name.text.clone(), Rational::ZERO);
        inner.truth(body)
    }

    /// `for all k natural: A = B` where families are geometric and both sides are products of powers
    /// of members with indices k + c: then A = a·ρ^k and B = b·σ^k, equal for all k if for 0 and 1.
    fn for_all_powers(&self, body: &Prop, name: &str) -> Result<bool> {
        fn monomial(point: &Assignment, e: &Expr, index: &str) -> bool {
            match &e.kind {
                ExprKind::Name(n) => n != index,
                ExprKind::Number(_) => true,
                ExprKind::Apply(f, list) => point.ratios.contains_key(&f.text) && list.iter().all(shifted),
                ExprKind::Product(list) => list.iter().all(|(_, a)| monomial(point, a, index)),
                ExprKind::Power(a, b) => monomial(point, a, index) && matches!(b.kind, ExprKind::Number(_)),
                _ => false,
            }
        }
        let PropKind::Compare(sides, relations) = &body.kind else { return Err(Missing::Unknown) };
        let fine = relations.iter().all(|r| *r == Relation::Equal) && sides.iter().all(|e| monomial(self, e, name));
        for k in [0, 1] {
            let mut inner = self.clone();
            inner.indices.insert(name.to_string(), Rational::from(k));
            if !inner.truth(body)? {
                return Ok(false);
            }
        }
        if fine { Ok(true) } else { Err(Missing::Unknown) }
    }

    fn only_index(&self, prop: &Prop, name: &str) -> bool {
        fn inside(point: &Assignment, e: &Expr, name: &str) -> bool {
            match &e.kind {
                ExprKind::Name(n) => n != name,
                ExprKind::Apply(f, list) if point.families.contains_key(&f.text) => list.iter().all(shifted),
                _ => {
                    let mut fine = true;
                    parts(e, &mut |part| fine &= inside(point, part, name));
                    fine
                }
            }
        }
        match &prop.kind {
            PropKind::Compare(sides, _) => sides.iter().all(|e| inside(self, e, name)),
            PropKind::And(list) | PropKind::Or(list) => list.iter().all(|p| self.only_index(p, name)),
            _ => false,
        }
    }

    /// The comparisons that fail in a false proposition, with both sides.
    pub fn broken(&self, prop: &Prop, into: &mut Vec<Broken>) {
        match &prop.kind {
            PropKind::Compare(sides, relations) => {
                for (pair, relation) in sides.windows(2).zip(relations) {
                    let single = Prop { kind: PropKind::Compare(pair.to_vec(), vec![*relation]), span: prop.span };
                    if let (Ok(a), Ok(b)) = (self.number(&pair[0]), self.number(&pair[1])) {
                        let (left, right) = number::sides(&a, &b);
                        into.push(Broken { statement: print::prop(&self.words.prop(&single)), left, right });
                    }
                }
            }
            PropKind::And(list) => {
                for part in list.iter().filter(|p| self.truth(p) == Ok(false)) {
                    self.broken(part, into);
                }
            }
            PropKind::Or(list) | PropKind::Equivalent(list) => list.iter().for_each(|p| self.broken(p, into)),
            PropKind::Not(p) => self.broken(p, into),
            PropKind::Implies(p, q) => {
                self.broken(p, into);
                self.broken(q, into);
            }
            PropKind::Exists(..) | PropKind::ForAll(..) => {
                into.push(Broken {
                    statement: print::prop(&self.words.prop(prop)),
                    left: String::new(),
                    right: String::new(),
                });
            }
            _ => {}
        }
    }
}

/// Whether an index is a natural number for all natural values of what stands in it, if it is for one.
fn shifted(e: &Expr) -> bool {
    match &e.kind {
        ExprKind::Name(_) | ExprKind::Number(_) => true,
        ExprKind::Sum(list) => list.iter().all(|(sign, a)| *sign == Sign::Plus && shifted(a)),
        _ => false,
    }
}

/// Whether two matrices of one size are equal, or different, where the relation is one of these.
fn matrices_hold(a: &[Vec<Number>], relation: Relation, b: &[Vec<Number>]) -> Result<Option<bool>> {
    if !same_size(a, b) || !matches!(relation, Relation::Equal | Relation::NotEqual) {
        return Err(Missing::Unknown);
    }
    let entries = a.iter().flatten().zip(b.iter().flatten());
    let same: Vec<Option<bool>> = entries.map(|(x, y)| holds(x, Relation::Equal, y)).collect();
    // Equal where all entries are, different where one is.
    let equal = match () {
        () if same.contains(&Some(false)) => Some(false),
        () if same.contains(&None) => None,
        () => Some(true),
    };
    Ok(equal.map(|equal| equal == (relation == Relation::Equal)))
}
