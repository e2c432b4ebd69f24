//! The equations that steps put in, from where the draft introduced them on.

use super::{Elaborator, Stuck};
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::kernel::key;
use crate::kernel::statement::{compare, expr, name, numeral};

/// An equation that the draft put in from where it was introduced on.
#[derive(Clone, PartialEq)]
pub(super) struct Equation {
    pub(super) label: Label,
    pub(super) kind: Kind,
}

/// What an equation does.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Kind {
    /// A power that others are written by gets a name: it is not looked into.
    Named,
    /// A power is written by others.
    Written,
    /// A variable or another atom is replaced.
    Replaced,
}

impl Elaborator {
    /// The equations that a step is tried with, one list after the other.
    pub(super) fn lists(&self, rule: &Rule) -> Vec<Vec<Label>> {
        let of = |kinds: &[Kind]| {
            let kept = self.equations.iter().filter(|e| kinds.contains(&e.kind));
            kept.map(|e| e.label.clone()).collect::<Vec<Label>>()
        };
        let all = of(&[Kind::Named, Kind::Written, Kind::Replaced]);
        let mut lists = match rule {
            // The draft saw the bases of powers here.
            Rule::Power => vec![of(&[Kind::Written]), of(&[Kind::Written, Kind::Replaced]), all, Vec::new()],
            _ => vec![all, of(&[Kind::Written, Kind::Replaced]), Vec::new()],
        };
        let mut seen: Vec<Vec<Label>> = Vec::new();
        lists.retain(|list| {
            let new = !seen.contains(list);
            seen.push(list.clone());
            new
        });
        lists
    }

    /// Gives a power a name and shows its sign, so that it is not looked into from here on.
    pub(super) fn named(&mut self, old: &str, power: &Expr) -> Result<(), Stuck> {
        let new = name(&self.fresh_name("r"));
        let label = self.emit(old, Rule::Name, &compare(power.clone(), Relation::Equal, new.clone()))?;
        let minus_one = expr(ExprKind::Negate(Box::new(numeral(1))));
        let terms = vec![
            Term { facts: vec![label.clone()], factor: minus_one },
            Term { facts: Vec::new(), factor: power.clone() },
        ];
        for relation in [Relation::Greater, Relation::GreaterEqual, Relation::NotEqual] {
            let rule = Rule::Combination { times: None, terms: terms.clone() };
            if self.emit(old, rule, &compare(new.clone(), relation, numeral(0))).is_ok() {
                break;
            }
        }
        self.put_in(label, Kind::Named);
        Ok(())
    }

    /// Puts an equation in from here on. A variable that is replaced again is replaced by its last value.
    pub(super) fn put_in(&mut self, label: Label, kind: Kind) {
        let left = |p: Option<Prop>| match p.map(|p| p.kind) {
            Some(PropKind::Compare(sides, _)) => sides.first().map(key::expr),
            _ => None,
        };
        let Some(prop) = self.prop_of(&label) else { return };
        let same = left(Some(prop.clone()));
        let before = self.equations.clone();
        self.equations
            .retain(|e| left(self.facts.iter().rev().find(|f| f.label == e.label).map(|f| f.prop.clone())) != same);
        let using = self.using();
        if self.checker.can_be_put_in(&prop, &using) {
            self.equations.push(Equation { label, kind });
        } else {
            self.equations = before;
        }
    }

    /// The equations that are put in.
    pub(super) fn using(&self) -> Vec<Label> {
        self.equations.iter().map(|e| e.label.clone()).collect()
    }
}
