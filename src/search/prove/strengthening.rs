//! Statements about members of recurrences that an induction shows only together with others: T(n) >= 1 together with
//! T(n + 1) >= T(n).
//!
//! Method (C. Flanagan, K. R. M. Leino, "Houdini, an annotation assistant for ESC/Java", 2001): beside the goal stand the signs of each
//! member, its order beside the next one and its order beside the first one, as far as they hold at the start. Those that the step
//! does not show are left out, until it shows all that are left; what remains is shown by one induction. Where the step does not show
//! the goal with all of them, it does not with fewer.
//!
//! Limits: [`SEQUENCES`], [`ROUNDS`].

use super::comparison::single;
use super::induction::all as all_of;
use super::invariants::members_met;
use super::limits::plus;
use super::values::at_next;
use super::{Fail, Prover, implies, put};
use crate::certificate::{Label, Rule};
use crate::claim::syntax::*;
use crate::kernel::key;
use crate::kernel::statement::{apply, compare, name, numeral, prop};

/// The most families and sequences in a goal.
const SEQUENCES: usize = 2;

/// How often statements that the step does not show are left out.
const ROUNDS: usize = 6;

/// The case distinctions within which the parts of a step are shown: without cases of their own.
const SPLITS: usize = 8;

impl Prover {
    /// Shows a comparison of members of recurrences by induction together with signs and orders of members.
    pub(super) fn by_strengthened_induction(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("members of a recurrence");
        let relation = single(goal)?.1;
        if self.inductions > 0 || self.splits > 0 || relation.is_greater().is_none() {
            return Err(no());
        }
        let mut sides = Vec::new();
        super::goals::sides_in(goal, &mut sides);
        let members = members_met(&sides);
        let Some((_, Expr { kind: ExprKind::Name(n), .. })) = members.first().cloned() else { return Err(no()) };
        let mut sequences: Vec<String> = members.into_iter().map(|(u, _)| u).collect();
        sequences.dedup();
        if !self.naturals.contains(&n) || sequences.len() > SEQUENCES || !sequences.iter().all(|u| self.recurs(u)) {
            return Err(no());
        }
        let k = self.fresh("k");
        let base = self.least(&n);
        let mut all = vec![put(goal, &n, &name(&k))?];
        for u in &sequences {
            let (here, next, first) =
                (apply(u, name(&k)), apply(u, plus(&name(&k), numeral(1))), apply(u, numeral(base.unwrap_or(0))));
            use Relation::{Greater, GreaterEqual, Less, LessEqual};
            for (a, b) in [(&here, &numeral(0)), (&next, &here), (&here, &first)] {
                for relation in [Greater, GreaterEqual, Less, LessEqual] {
                    let p = compare(a.clone(), relation, b.clone());
                    if !all.iter().any(|old| key::prop(old) == key::prop(&p)) {
                        all.push(p);
                    }
                }
            }
        }
        let all = self.true_at_the_start(all, &k, base)?;
        let kept = self.shown_together(all, &k, base)?;
        let body = all_of(kept);
        self.inductions += 1;
        let every = self.induction_by(&k, base, &body, &mut |c, _, next| {
            let parts = match &next.kind {
                PropKind::And(parts) => parts.clone(),
                _ => vec![next.clone()],
            };
            let shown = c.parts_of_step(&parts);
            let from = shown.into_iter().collect::<Option<Vec<Label>>>().ok_or_else(no)?;
            c.emit(Rule::Logic { from }, next.clone())
        })?;
        self.inductions -= 1;
        let here = self.instance(&every, &name(&n))?;
        self.logic(&[&here], goal)
    }

    /// Whether facts for all numbers, or its definition, say what the members of a family or sequence are.
    fn recurs(&self, u: &str) -> bool {
        let mut facts = self.checker.facts();
        self.checker.statement().sequences.iter().any(|s| s.name == u)
            || facts.any(|(_, fact)| match &fact.kind {
                PropKind::ForAll(_, body) => matches!(body.single(),
                    Some((Expr { kind: ExprKind::Apply(f, _), .. }, Relation::Equal, _)) if f.text == u),
                _ => false,
            })
    }

    /// The statements that hold at the start; the first one has to.
    fn true_at_the_start(&mut self, all: Vec<Prop>, k: &str, base: Option<u32>) -> Result<Vec<Prop>, Fail> {
        let mut kept = Vec::new();
        let first = numeral(base.unwrap_or(0));
        let _ = self.attempt(|c| {
            c.splits += 1;
            c.put_in_first_members();
            for (place, p) in all.into_iter().enumerate() {
                let here = put(&p, k, &first)?;
                // What a strict order says, a weak one need not.
                if c.quietly(&here).is_ok() {
                    kept.push(p);
                } else if place == 0 {
                    break;
                }
            }
            Err::<(), _>(Fail::No("the statements alone"))
        });
        if kept.is_empty() { Err(Fail::No("the start of an induction")) } else { Ok(kept) }
    }

    /// Those of the statements that a step shows of the next number, where it knows all of them; the first one has to remain.
    fn shown_together(&mut self, mut all: Vec<Prop>, k: &str, base: Option<u32>) -> Result<Vec<Prop>, Fail> {
        let no = || Fail::No("the step of an induction");
        let bound = base.map(|b| Constraint::Relation(Relation::GreaterEqual, numeral(b)));
        let binding = Binding::of(Name::new(k), true, bound.into_iter().collect());
        for _ in 0..ROUNDS {
            let body = prop(PropKind::And(all.clone()));
            let next = at_next(&body, k)?;
            let step = implies(&body, &next);
            let every = prop(PropKind::ForAll(vec![binding.clone()], Box::new(step.clone())));
            let PropKind::And(parts) = &next.kind else { return Err(no()) };
            let mut shown = Vec::new();
            let _ = self.attempt(|c| {
                c.inductions += 1;
                c.block(&every, |c, _| {
                    c.take_signs_at(k);
                    c.define_sides(&step);
                    c.block(&step, |c, _| {
                        shown = c.parts_of_step(parts);
                        Err(no())
                    })
                })
            });
            if !shown.first().is_some_and(Option::is_some) {
                return Err(no());
            }
            let before = all.len();
            let mut is_shown = shown.iter().map(Option::is_some);
            all.retain(|_| is_shown.next() == Some(true));
            if all.len() == before {
                return Ok(all);
            }
        }
        Err(no())
    }

    /// Shows what can be shown of these, once more after the others.
    fn parts_of_step(&mut self, parts: &[Prop]) -> Vec<Option<Label>> {
        let before = std::mem::replace(&mut self.splits, SPLITS);
        let mut shown: Vec<Option<Label>> = vec![None; parts.len()];
        for _ in 0..2 {
            for (p, label) in parts.iter().zip(&mut shown).filter(|(_, label)| label.is_none()) {
                *label = self.attempt(|c| c.show(p)).ok();
                if let Some(label) = label {
                    let _ = self.take_in(label, p);
                }
            }
        }
        self.splits = before;
        shown
    }
}
