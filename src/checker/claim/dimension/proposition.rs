//! The dimensions of declarations and statements.

use super::super::print;
use super::Stop;
use super::expression::{Checker, Meaning};
use super::size::Size;
use crate::claim::free_names::names_in;
use crate::claim::syntax::*;
use std::collections::BTreeSet;

impl<'c> Checker<'c> {
    /// Declarations and hypotheses.
    pub(super) fn items(&mut self, items: &'c [Item]) -> Result<(), Stop> {
        for item in items {
            match item {
                Item::Given(bindings) => bindings.iter().try_for_each(|b| self.binding(b).map(drop))?,
                Item::Let { name, parameters, value } if parameters.is_empty() => {
                    let size = self.of(value)?;
                    if let Some(number) = self.constant(value) {
                        self.constants.insert(name.text.clone(), number);
                    }
                    self.names.insert(name.text.clone(), Meaning::Quantity(size));
                }
                Item::Let { name, parameters, value } => {
                    self.names.insert(name.text.clone(), Meaning::Function(parameters, value));
                }
                Item::Define { name, initial, index, step, .. } => {
                    let own = self.unknowns.fresh(Some(&name.text));
                    self.names.insert(name.text.clone(), Meaning::Quantity(Some(own.clone())));
                    let number = Meaning::Quantity(Some(Size::number()));
                    let before = self.names.insert(index.text.clone(), number);
                    for value in [initial, step] {
                        if let Some(size) = self.of(value)? {
                            let (text, member) = (print::expr(value), format!("a member of {}", name.text));
                            self.equal(&text, value.span, (value, &size), (&member, &own))?;
                        }
                    }
                    self.restore(&index.text, before);
                }
                Item::Assume { prop, .. } => self.prop(prop)?,
            }
        }
        self.settle()
    }

    /// What is proved.
    pub(super) fn goal(&mut self, goal: &'c Prop) -> Result<(), Stop> {
        self.prop(goal)?;
        self.settle()
    }

    /// Declares names, and returns what they meant before.
    fn binding(&mut self, binding: &'c Binding) -> Result<Vec<(&'c str, Option<Meaning<'c>>)>, Stop> {
        let mut before = Vec::new();
        let mut sizes = Vec::new();
        for (name, _) in &binding.names {
            let size = match &binding.unit {
                Some(unit) => {
                    self.declared.insert(name.text.clone());
                    Size::of(unit.dimension())
                }
                // A natural number counts.
                None if binding.natural => Size::number(),
                None => self.unknowns.fresh(Some(&name.text)),
            };
            before.push((
                name.text.as_str(),
                self.names.insert(name.text.clone(), Meaning::Quantity(Some(size.clone()))),
            ));
            sizes.push((name, size));
        }
        let bounds: Vec<&Expr> = binding
            .constraints
            .iter()
            .flat_map(|constraint| match constraint {
                Constraint::Relation(_, bound) => vec![bound],
                Constraint::Interval { from, to, .. } => vec![from, to],
                // A range is one of natural numbers.
                Constraint::Range(..) => Vec::new(),
            })
            .collect();
        for bound in bounds {
            // `x >= 1 in m` means 1 m.
            if binding.unit.is_some() && (self.constant(bound).is_some() || self.is_numeral(bound)) {
                continue;
            }
            let Some(found) = self.of(bound)? else { continue };
            for (name, size) in &sizes {
                let text = format!("the bound {} of {}", print::expr(bound), name.text);
                self.equal(&text, bound.span, (bound, &found), (&name.text, size))?;
            }
        }
        Ok(before)
    }

    /// Whether an expression is made of numbers alone, by functions that every claim has: `3e8`, `2*pi`, `sqrt(2)`.
    fn is_numeral(&self, e: &Expr) -> bool {
        let mut names = BTreeSet::new();
        names_in(e, &mut names);
        let is_own = |name: &String| name == PI || is_built_in(name);
        names.iter().all(|name| is_own(name) && !self.names.contains_key(name))
    }

    /// A statement under names that it binds.
    fn under(&mut self, bindings: &'c [Binding], look: impl FnOnce(&mut Self) -> Result<(), Stop>) -> Result<(), Stop> {
        let mut before = Vec::new();
        for binding in bindings {
            before.extend(self.binding(binding)?);
        }
        let out = look(self);
        before.into_iter().rev().for_each(|(name, meaning)| self.restore(name, meaning));
        out
    }

    fn prop(&mut self, prop: &'c Prop) -> Result<(), Stop> {
        match &prop.kind {
            PropKind::Compare(sides, _) => {
                let mut before: Option<(&Expr, Size)> = None;
                for side in sides {
                    let size = self.of(side)?;
                    if let (Some((other, own)), Some(size)) = (&before, &size) {
                        self.equal(&print::prop(prop), prop.span, (other, own), (&print::expr(side), size))?;
                    }
                    before = size.map(|size| (side, size)).or(before);
                }
                Ok(())
            }
            PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => {
                list.iter().try_for_each(|part| self.prop(part))
            }
            PropKind::Not(inner) => self.prop(inner),
            PropKind::Implies(premise, conclusion) => {
                self.prop(premise)?;
                self.prop(conclusion)
            }
            PropKind::Exists(bindings, body) | PropKind::ForAll(bindings, body) => {
                self.under(bindings, |inner| inner.prop(body))
            }
            PropKind::Extremum(extremum) => self.under(&extremum.over, |inner| {
                for (name, place) in &extremum.at {
                    inner.is_like(prop, name, place)?;
                }
                inner.same(prop, &extremum.of, &extremum.value)
            }),
            PropKind::Limit(limit) => self.same(prop, &limit.of, &limit.value),
            PropKind::WrittenLimit(limit) => {
                // The author need not declare what moves.
                if !self.names.contains_key(limit.variable.text.as_str()) {
                    let size = match limit.natural {
                        true => Size::number(),
                        false => self.unknowns.fresh(Some(&limit.variable.text)),
                    };
                    self.names.insert(limit.variable.text.clone(), Meaning::Quantity(Some(size)));
                }
                if let Towards::Point(point, _) = &limit.towards {
                    self.is_like(prop, &limit.variable, point)?;
                }
                match &limit.value {
                    Tendency::Number(value) => self.same(prop, &limit.of, value),
                    Tendency::Infinite(_) => self.of(&limit.of).map(drop),
                    Tendency::Order { about, size } => {
                        about.iter().try_for_each(|p| self.same(prop, &limit.of, p))?;
                        self.same(prop, &limit.of, size)
                    }
                }
            }
        }
    }

    /// Two expressions of a statement have one dimension.
    fn same(&mut self, prop: &Prop, left: &'c Expr, right: &'c Expr) -> Result<(), Stop> {
        match (self.of(left)?, self.of(right)?) {
            (Some(a), Some(b)) => self.equal(&print::prop(prop), prop.span, (left, &a), (&print::expr(right), &b)),
            _ => Ok(()),
        }
    }

    /// A value that a variable takes has its dimension.
    fn is_like(&mut self, prop: &Prop, name: &Name, value: &'c Expr) -> Result<(), Stop> {
        match (self.names.get(&name.text).cloned(), self.of(value)?) {
            (Some(Meaning::Quantity(Some(own))), Some(size)) => {
                self.equal(&print::prop(prop), prop.span, (value, &size), (&name.text, &own))
            }
            _ => Ok(()),
        }
    }
}
