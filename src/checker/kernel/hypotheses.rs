//! The first facts: the domains and hypotheses of a claim, and that its sequences have values.

use super::fraction::Poly;
use super::known::Known;
use super::names::names_in;
use super::order::Signs;
use super::statement::Sequence;
use super::term::Atom;
use super::{Checker, Reason, Refusal, cited, quantifier, rejected, statement, term};
use crate::certificate::Label;
use std::collections::BTreeSet;

impl Checker {
    /// Declares what the claim declares, and takes its domains and hypotheses as facts. A hypothesis is understood to
    /// say of its own expressions that they have values.
    pub(super) fn hypotheses(&mut self) -> Result<(), Refusal> {
        let statement = self.statement.clone();
        for binding in &statement.bindings {
            self.declare_binding(binding)?;
        }
        // A sequence speaks of what the claim declares, never of a variable that a block introduces later, nor of a
        // sequence that is defined after it; and of itself only by the member before.
        for (place, u) in statement.sequences.iter().enumerate() {
            let mut names = BTreeSet::new();
            names_in(&u.step, &mut names);
            names.remove(&u.index);
            names_in(&u.initial, &mut names);
            let known = |n: &String| self.is_declared(n) || term::FUNCTIONS.contains(&n.as_str());
            if let Some(free) = names.iter().find(|n| !known(n)) {
                return rejected(Reason::Undeclared(free.clone()));
            }
            let later = statement.sequences.iter().skip(place + 1).any(|v| names.contains(&v.name));
            let mut first = BTreeSet::new();
            names_in(&u.initial, &mut first);
            if later || first.contains(&u.name) || !statement::steps_once(&u.step, &u.name, &u.index) {
                return rejected(Reason::Sequence(u.name.clone()));
            }
        }
        self.moving_variables_are_free()?;
        let domains = statement.bindings.iter().flat_map(quantifier::domains);
        for prop in domains.chain(statement.assumptions.iter().cloned()) {
            let label = format!("h{}", self.facts.len() + 1);
            self.know(&label, prop)?;
        }
        // Every member has a value, so that a member is one wherever its index is a natural number.
        let all: Vec<Label> = self.facts.iter().map(|f| f.label.clone()).collect();
        for u in &statement.sequences {
            let (scope, binders) = (self.scope.len(), self.binders);
            let mut refused = None;
            for signs in [Signs::ANY, Signs::POSITIVE, Signs::NOT_NEGATIVE] {
                let mut known = self.known(&all, &[])?;
                match self.members(u, signs, &mut known) {
                    Ok(()) => {
                        self.assumed.extend(cited(known.used().0, &all));
                        self.signs_of_members.insert(u.name.clone(), signs);
                        refused = None;
                        break;
                    }
                    Err(Refusal::Rejected(because)) => refused = refused.or(Some(because)),
                    Err(limit) => return Err(limit),
                }
                self.scope.truncate(scope);
                self.binders = binders;
            }
            if let Some(because) = refused {
                return rejected(Reason::Member(u.name.clone(), Box::new(because)));
            }
        }
        Ok(())
    }

    /// Shows that every member of a sequence has a value and one of these signs.
    ///
    /// Sound: by induction. u(0) has a value and such a sign; if u(k) has, then the step has, so that u(k + 1) has.
    fn members(&mut self, u: &Sequence, signs: Signs, known: &mut Known) -> Result<(), Refusal> {
        self.defined(&u.initial, known)?;
        self.need(&u.initial, signs, known)?;
        self.binders += 1;
        let bound = self.binders;
        let before = known.mark();
        let result = self.under(&u.index, bound, |checker| {
            let index = checker.intern(Atom::Bound(bound));
            let member = checker.atom_fraction(Atom::Member(u.name.clone(), Poly::atom(index)));
            if signs != Signs::ANY {
                checker.learn_signs(&member, signs, known)?;
            }
            checker.defined(&u.step, known)?;
            checker.need(&u.step, signs, known)
        });
        self.binders -= 1;
        known.back_to(before);
        result
    }
}
