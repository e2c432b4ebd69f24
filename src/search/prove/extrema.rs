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
            from.push(self.on_its_own(|c| c.show(&fact)).map_err(|fail| fail.within("the place"))?);
        }
        let there = at.expr(&e.of).map_err(Fail::from)?;
        let taken = compare(there, Relation::Equal, e.value.clone());
        from.push(self.on_its_own(|c| c.show(&taken)).map_err(|fail| fail.within("the value at the place"))?);
        let every = |body: Prop| prop(PropKind::ForAll(e.over.clone(), Box::new(body)));
        let relation = if e.maximum { Relation::LessEqual } else { Relation::GreaterEqual };
        let bound = every(compare(e.of.clone(), relation, e.value.clone()));
        self.stationary = STATIONARY;
        let place = e.at.iter().map(|(n, value)| (n.text.clone(), value.clone())).collect();
        let outer = std::mem::replace(&mut self.extremal_place, place);
        let shown = self.on_its_own(|c| c.show(&bound));
        self.extremal_place = outer;
        from.push(shown.map_err(|fail| fail.within("the bound"))?);
        if e.unique {
            let shown = self.only_there(e, from.last().cloned().unwrap_or_default());
            from.push(shown.map_err(|fail| fail.within("only at the place"))?);
        }
        self.emit(Rule::Extremum { from }, goal.clone())
    }

    /// Shows that the value is taken at the place only; `bound` is the fact that nothing lies beyond it.
    fn only_there(&mut self, e: &Extremum, bound: Label) -> Result<Label, Fail> {
        let there = at_the_point(e).ok_or(Fail::No("a point"))?;
        let equal = compare(e.of.clone(), Relation::Equal, e.value.clone());
        let only = implies(&equal, &there);
        let every = prop(PropKind::ForAll(e.over.clone(), Box::new(only.clone())));
        self.quietly(&every)
            .or_else(|_| self.attempt(|c| c.block(&every, |c, _| c.by_strict_sides(&only, &equal, e))))
            .or_else(|_| self.on_its_own(|c| c.block(&every, |c, _| c.by_roots_of_the_value(&only, &equal, e, &bound))))
            .or_else(|_| self.attempt(|c| c.block(&every, |c, _| c.by_strict_sides_alone(&only, &equal, e))))
            .or_else(|_| self.on_its_own(|c| c.show(&every)))
    }

    /// Shows that a value is taken at one place only by the equation that says that it is taken, freed of its roots. The bound, at the
    /// place, says that the function has a value.
    fn by_roots_of_the_value(&mut self, only: &Prop, equal: &Prop, e: &Extremum, bound: &str) -> Result<Label, Fail> {
        let there = at_the_point(e).ok_or(Fail::No("a point"))?;
        let point = e.at.iter().map(|(n, _)| (n.text.clone(), name(&n.text))).collect();
        self.instance_at(bound, point)?;
        self.block(only, |c, _| {
            let equal = c.known(equal).ok_or(Fail::No("the value"))?;
            c.by_conjugates(&there, &equal)
        })
    }

    /// Shows that a greatest or least value is taken at one place only: on either side of it the function lies strictly below or above.
    fn by_strict_sides(&mut self, only: &Prop, equal: &Prop, e: &Extremum) -> Result<Label, Fail> {
        let (x, place, strict) = strict_side(e)?;
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

    /// The same, where it is not supposed yet that the value is taken: an equation between logarithms, say, makes their difference 0
    /// wherever it is read.
    fn by_strict_sides_alone(&mut self, only: &Prop, equal: &Prop, e: &Extremum) -> Result<Label, Fail> {
        let (x, place, strict) = strict_side(e)?;
        self.define_sides(equal);
        let mut from = Vec::new();
        for side in [Relation::Less, Relation::Greater] {
            let side = implies(&compare(x.clone(), side, place.clone()), &strict);
            self.stationary = STATIONARY;
            from.push(self.block(&side, |c, _| c.on_its_own(|c| c.without_cases(&strict)))?);
        }
        self.block(only, |c, _| {
            from.push(c.known(equal).ok_or(Fail::No("the value"))?);
            c.emit(Rule::Logic { from }, compare(x, Relation::Equal, place))
        })
    }
}

/// The variable of an extremum, the place, and that the function lies strictly on its side of the value.
fn strict_side(e: &Extremum) -> Result<(Expr, Expr, Prop), Fail> {
    let [(x, place)] = e.at.as_slice() else { return Err(Fail::No("one variable")) };
    let relation = if e.maximum { Relation::Less } else { Relation::Greater };
    Ok((name(&x.text), place.clone(), compare(e.of.clone(), relation, e.value.clone())))
}
