//! Extrema: the value is taken at the point, nothing lies beyond it, and it is taken there only.

use super::slopes::STATIONARY;
use super::{Fail, Prover, implies};
use crate::certificate::{Label, Rule};
use crate::claim::syntax::*;
use crate::kernel::analysis::at_the_point;
use crate::kernel::statement::{compare, domain, name, prop};
use crate::kernel::substitution::Substitution;

impl Prover {
    /// Shows an extremum; each part may cost what a claim may.
    pub(super) fn extremum(&mut self, goal: &Prop, e: &Extremum) -> Result<Label, Fail> {
        let mut at = Substitution::default();
        e.at.iter().for_each(|(n, v)| at.replace(&n.text, v));
        let mut from = Vec::new();
        for fact in e.over.iter().flat_map(domain) {
            let fact = at.prop(&fact).map_err(Fail::from)?;
            from.push(self.on_its_own(|c| c.show(&fact))?);
        }
        let there = at.expr(&e.of).map_err(Fail::from)?;
        let taken = compare(there, Relation::Equal, e.value.clone());
        from.push(self.on_its_own(|c| c.show(&taken))?);
        let every = |body: Prop| prop(PropKind::ForAll(e.over.clone(), Box::new(body)));
        let relation = if e.maximum { Relation::LessEqual } else { Relation::GreaterEqual };
        let bound = every(compare(e.of.clone(), relation, e.value.clone()));
        self.stationary = STATIONARY;
        from.push(self.on_its_own(|c| c.show(&bound))?);
        if e.unique {
            let there = at_the_point(e).ok_or(Fail::No("a point"))?;
            let equal = compare(e.of.clone(), Relation::Equal, e.value.clone());
            let only = implies(&equal, &there);
            let every = every(only.clone());
            let shown = self
                .quietly(&every)
                .or_else(|_| self.attempt(|c| c.block(&every, |c, _| c.by_strict_sides(&only, &equal, e))))
                .or_else(|_| self.on_its_own(|c| c.show(&every)));
            from.push(shown?);
        }
        self.emit(Rule::Extremum { from }, goal.clone())
    }

    /// Shows that a greatest or least value is taken at one place only: on either side of it the function lies strictly below or above.
    fn by_strict_sides(&mut self, only: &Prop, equal: &Prop, e: &Extremum) -> Result<Label, Fail> {
        let [(x, place)] = e.at.as_slice() else { return Err(Fail::No("one variable")) };
        let x = name(&x.text);
        let relation = if e.maximum { Relation::Less } else { Relation::Greater };
        let strict = compare(e.of.clone(), relation, e.value.clone());
        let there = compare(x.clone(), Relation::Equal, place.clone());
        self.block(only, |c, _| {
            let equal = c.known(equal).ok_or(Fail::No("the value"))?;
            let mut halves = Vec::new();
            for half in [Relation::LessEqual, Relation::GreaterEqual] {
                let half = compare(x.clone(), half, place.clone());
                c.stationary = STATIONARY;
                halves.push(c.against_opposite(&half, |c, _| {
                    let strict = c.on_its_own(|c| c.without_cases(&strict))?;
                    c.logic(&[&strict, &equal], &half)
                })?);
            }
            c.logic(&[&halves[0], &halves[1]], &there)
        })
    }
}
