//! Families determined by recurrences among the hypotheses: their members are computed, so these hypotheses always hold.
//!
//! A hypothesis `for all k natural: F(k + d) = step` is a recurrence of order d where the step is made of members F(k), …,
//! F(k + d − 1), members of other such families before k + d, the index and numbers by sums, products and whole powers,
//! and divides by nothing in which an index or a member stands. Then members F(0), …, F(d − 1) may be chosen. Where the step
//! has a value once it has one for every k, so that there is one family that obeys the hypothesis for all k.

use super::evaluate::Assignment;
use super::number::{Missing, Number};
use crate::claim::definedness;
use crate::claim::syntax::*;
use malachite::Rational;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::rc::Rc;

/// The highest order.
const ORDER: usize = 4;

/// The recurrence of a family.
#[derive(Clone, Debug)]
pub struct Recurrence {
    /// Number of initial members.
    pub order: usize,
    /// The initial members whose values a hypothesis gives, by their index.
    pub first: BTreeMap<usize, Expr>,
    index: String,
    step: Expr,
}

/// The recurrences among hypotheses, by family, and the places of the hypotheses that hold by construction then.
pub(crate) fn recurrences(families: &[String], hypotheses: &[Prop]) -> (BTreeMap<String, Recurrence>, Vec<usize>) {
    let mut found: BTreeMap<String, (Recurrence, usize)> = BTreeMap::new();
    let mut several = Vec::new();
    for (place, h) in hypotheses.iter().enumerate() {
        let Some((family, recurrence)) = recurrence(h).filter(|r| families.contains(&r.0)) else { continue };
        if found.insert(family.clone(), (recurrence, place)).is_some() {
            several.push(family);
        }
    }
    several.iter().for_each(|family| drop(found.remove(family)));
    // A step may mention other families that have recurrences.
    loop {
        let fits = |r: &Recurrence| is_step(&r.step, &r.index, r.order, families, &|f| found.contains_key(f));
        let Some(open) = found.iter().find(|(_, r)| !fits(&r.0)).map(|(family, _)| family.clone()) else { break };
        found.remove(&open);
    }
    let mut places: Vec<usize> = found.values().map(|r| r.1).collect();
    for (place, h) in hypotheses.iter().enumerate() {
        if let Some((family, k, value)) = first_member(h)
            && let Some((r, _)) = found.get_mut(&family)
            && k < r.order
            && !speaks_of(value, families)
            && !r.first.contains_key(&k)
        {
            r.first.insert(k, value.clone());
            places.push(place);
        }
    }
    (found.into_iter().map(|(family, (r, _))| (family, r)).collect(), places)
}

/// `for all k natural: F(k + d) = step`.
fn recurrence(h: &Prop) -> Option<(String, Recurrence)> {
    let PropKind::ForAll(bindings, body) = &h.kind else { return None };
    let [Binding { names, natural: true, constraints, indices: None, .. }] = bindings.as_slice() else { return None };
    let ([(index, None)], []) = (names.as_slice(), constraints.as_slice()) else { return None };
    let Some((left, Relation::Equal, step)) = body.single() else { return None };
    let ExprKind::Apply(family, at) = &left.kind else { return None };
    let order = ahead(at.first()?, &index.text).filter(|d| (1..=ORDER).contains(d))?;
    let recurrence = Recurrence { order, first: BTreeMap::new(), index: index.text.clone(), step: step.clone() };
    Some((family.text.clone(), recurrence))
}

/// `F(k) = value` for a numeral k.
fn first_member(h: &Prop) -> Option<(String, usize, &Expr)> {
    let Some((left, Relation::Equal, value)) = h.single() else { return None };
    let ExprKind::Apply(family, at) = &left.kind else { return None };
    let (k, 1) = definedness::number(at.first()?)? else { return None };
    Some((family.text.clone(), usize::try_from(k).ok()?, value))
}

/// The d of an index k + d.
fn ahead(e: &Expr, index: &str) -> Option<usize> {
    match &e.kind {
        ExprKind::Name(n) if n == index => Some(0),
        ExprKind::Sum(list) => match list.as_slice() {
            [(Sign::Plus, Expr { kind: ExprKind::Name(n), .. }), (Sign::Plus, d)] if n == index => {
                let (d, 1) = definedness::number(d)? else { return None };
                usize::try_from(d).ok()
            }
            _ => None,
        },
        _ => None,
    }
}

fn speaks_of(e: &Expr, names: &[String]) -> bool {
    let mut inside = std::collections::BTreeSet::new();
    crate::claim::walk::names_in(e, &mut inside);
    let mut found = names.iter().any(|n| inside.contains(n));
    if let ExprKind::Apply(f, _) = &e.kind {
        found |= names.contains(&f.text);
    }
    crate::claim::walk::parts(e, &mut |part| found |= speaks_of(part, names));
    found
}

/// Whether an expression may be a step of this order.
fn is_step(e: &Expr, index: &str, order: usize, families: &[String], recurrent: &dyn Fn(&str) -> bool) -> bool {
    let part = |e: &Expr| is_step(e, index, order, families, recurrent);
    let constant = |e: &Expr| {
        let mut moving = families.to_vec();
        moving.push(index.to_string());
        !speaks_of(e, &moving)
    };
    if constant(e) {
        return true;
    }
    match &e.kind {
        ExprKind::Name(_) => true,
        ExprKind::Negate(a) => part(a),
        ExprKind::Sum(list) => list.iter().all(|(_, a)| part(a)),
        ExprKind::Product(list) => {
            list.iter().all(|(factor, a)| if *factor == Factor::Times { part(a) } else { constant(a) })
        }
        ExprKind::Power(a, k) => part(a) && definedness::number(k).is_some_and(|(k, d)| d == 1 && k >= 0),
        ExprKind::Apply(f, at) => {
            recurrent(&f.text) && at.first().and_then(|e| ahead(e, index)).is_some_and(|d| d < order)
        }
        _ => false,
    }
}

/// The members that are known so far, by family; copies of a point share them.
pub(crate) type Members = Rc<RefCell<BTreeMap<String, Vec<Rational>>>>;

impl Assignment {
    /// The initial members at a point: given by hypotheses, otherwise taken from the list in turn.
    ///
    /// # Errors
    /// The value given by a hypothesis is not rational.
    pub(super) fn begin(&mut self, family: &str, list: &[Rational]) -> Result<(), Missing> {
        let Some(recurrence) = self.recurrences.get(family) else { return Err(Missing::Unknown) };
        let mut first = Vec::new();
        for k in 0..recurrence.order {
            first.push(match recurrence.first.get(&k) {
                Some(value) => match self.number(value)? {
                    Number::Exact(q) => q,
                    Number::Between(..) => return Err(Missing::Unknown),
                },
                None => list.get(k % list.len().max(1)).cloned().ok_or(Missing::Unknown)?,
            });
        }
        self.members.borrow_mut().insert(family.to_string(), first);
        Ok(())
    }

    /// F(index), with all members before it: no step looks at a later one.
    ///
    /// # Errors
    /// A step has no rational value.
    pub(super) fn recurrent(&self, family: &str, index: usize) -> Result<Rational, Missing> {
        let length = |family: &str| self.members.borrow().get(family).map_or(0, Vec::len);
        for k in 0..=index {
            for (name, recurrence) in self.recurrences.iter() {
                let Some(before) = k.checked_sub(recurrence.order).filter(|_| length(name) <= k) else { continue };
                let mut inner = Assignment { indices: Default::default(), ..self.clone() };
                inner.indices.insert(recurrence.index.clone(), Rational::from(before));
                let Number::Exact(next) = inner.number(&recurrence.step)? else { return Err(Missing::Unknown) };
                self.members.borrow_mut().entry(name.clone()).or_default().push(next);
            }
        }
        let members = self.members.borrow();
        members.get(family).and_then(|list| list.get(index)).cloned().ok_or(Missing::Unknown)
    }
}
