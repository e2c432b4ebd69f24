//! A goal from a contradiction: its opposite is supposed as a whole, and the facts are shown to exclude each other.
//!
//! Method: the parts of the opposite become facts, implications among the facts are concluded (modus ponens), and each disjunction
//! and each `!=` is a case distinction, where all else fails. This is one normal form for `prove not (A and B)`, for `assume A`,
//! `prove not B`, and for disjunctions. At the ends stand linear programs and arithmetic of whole numbers.
//!
//! Limits: [`CASES`] nested cases, [`ENDS`] ends.

use super::facts::opposite;
use super::ideal;
use super::{Fail, Prover, implies};
use crate::certificate::{Label, Rule};
use crate::claim::syntax::*;
use crate::kernel::key;
use crate::kernel::statement::compare;

/// The most cases within one another.
const CASES: usize = 7;

/// The most ends of one refutation.
const ENDS: usize = 40;

impl Prover {
    /// Proves a goal from its opposite.
    pub(super) fn by_opposite(&mut self, goal: &Prop) -> Result<Label, Fail> {
        self.against_opposite(goal, |c, _| {
            c.solve_equations();
            c.refuted(goal)
        })
    }

    /// Shows a goal that is shown wherever its opposite is supposed.
    pub(super) fn against_opposite(
        &mut self,
        goal: &Prop,
        run: impl FnOnce(&mut Self, &Prop) -> Result<Label, Fail>,
    ) -> Result<Label, Fail> {
        let other = opposite(goal).ok_or(Fail::No("an opposite"))?;
        let block = self.block(&implies(&other, goal), |c, _| run(c, &other))?;
        self.logic(&[&block], goal)
    }

    /// Shows any goal by an equation that a fact denies, shown in this way.
    pub(super) fn by_denial(
        &mut self,
        goal: &Prop,
        mut show: impl FnMut(&mut Self, &Prop) -> Result<Label, Fail>,
    ) -> Result<Label, Fail> {
        for (denial, fact) in self.facts() {
            if let Some((a, Relation::NotEqual, b)) = fact.single()
                && let Ok(shown) = show(self, &compare(a.clone(), Relation::Equal, b.clone()))
            {
                return self.logic(&[&denial, &shown], goal);
            }
        }
        Err(Fail::No("a denied equation"))
    }

    /// Proves any goal from facts that contradict each other.
    pub(super) fn refuted(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let mut ends = ENDS;
        if let Ok(label) = self.attempt(|c| c.refuted_in_cases(goal, CASES, &mut ends)) {
            return Ok(label);
        }
        if let Ok(label) = self.attempt(|c| c.absurd_by_ideal(goal, &[ideal::FIRST_WORK, ideal::WORK])) {
            return Ok(label);
        }
        self.attempt(|c| c.absurd(1, goal, None)).or_else(|_| self.attempt(|c| c.absurd_in_whole_numbers(goal, 1)))
    }

    fn refuted_in_cases(&mut self, goal: &Prop, depth: usize, ends: &mut usize) -> Result<Label, Fail> {
        *ends = ends.checked_sub(1).ok_or(Fail::No("so many cases"))?;
        let _ = self.conclude_at_once();
        if let Ok(label) = self.attempt(|c| c.absurd(0, goal, None)) {
            return Ok(label);
        }
        let Some((from, parts)) = self.disjunction(goal).filter(|_| depth > 0) else {
            return self.attempt(|c| c.absurd_in_whole_numbers(goal, 0));
        };
        let mut labels = from;
        for part in parts {
            labels.push(self.block(&implies(&part, goal), |c, _| {
                c.solve_equations();
                c.refuted_in_cases(goal, depth - 1, ends)
            })?);
        }
        self.emit(Rule::Logic { from: labels }, goal.clone())
    }

    /// The shortest disjunction among the facts of which no part is known: the facts that say it, and its parts.
    fn disjunction(&mut self, goal: &Prop) -> Option<(Vec<Label>, Vec<Prop>)> {
        let mut found: Vec<(bool, Vec<Label>, Vec<Prop>)> = Vec::new();
        let wanted = key::prop(goal);
        for (label, fact) in self.facts() {
            let parts = match &fact.kind {
                PropKind::Or(parts) => parts.clone(),
                PropKind::Implies(a, b) => opposite(a).into_iter().chain([(**b).clone()]).collect(),
                PropKind::Compare(sides, relations) if *relations == [Relation::NotEqual] => {
                    let side = |r| compare(sides[0].clone(), r, sides[1].clone());
                    vec![side(Relation::Greater), side(Relation::Less)]
                }
                _ => continue,
            };
            let is_open = parts.len() > 1 && !parts.iter().any(|p| self.known(p).is_some());
            // A case that is done stands as `P => goal`.
            let is_done = matches!(&fact.kind, PropKind::Implies(_, b) if key::prop(b) == wanted);
            if is_open && !is_done {
                found.push((matches!(fact.kind, PropKind::Compare(..)), vec![label], parts));
            }
        }
        // What says `!=` comes last: it mostly says where something has a value.
        found.into_iter().min_by_key(|f| (f.0, f.2.len())).map(|f| (f.1, f.2))
    }
}
