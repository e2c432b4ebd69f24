//! The names in scope: variables, families and sequences.

use super::term::Atom;
use super::{Checker, NAMES_LIMIT, Reason, Refusal, rejected};
use crate::claim::syntax::{Binding, PI};

/// A name in scope.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Variable {
    pub(super) name: String,
    pub(super) natural: bool,
    /// What it stands for in fractions: itself, or a bound index.
    pub(super) atom: Atom,
}

impl Checker {
    pub(super) fn declare_binding(&mut self, binding: &Binding) -> Result<(), Refusal> {
        for (name, index) in &binding.names {
            if index.is_none() {
                self.declare(&name.text, binding.natural, Atom::Variable(name.text.clone()))?;
            }
        }
        Ok(())
    }

    /// Brings a name into scope, which must be new. `pi` is π in every fact, unless the claim declares it.
    pub(super) fn declare(&mut self, name: &str, natural: bool, atom: Atom) -> Result<(), Refusal> {
        if self.is_declared(name) || name == PI && !self.statement.declares(PI) {
            return rejected(Reason::NameInUse(name.to_string()));
        }
        // Variables come before what is made of them, in the order in which they are declared. How a difference is written,
        // x - y or -(y - x), then does not depend on what was asked before.
        self.intern(atom.clone());
        self.scope.push(Variable { name: name.to_string(), natural, atom });
        if self.scope.len() > NAMES_LIMIT { Err(Refusal::Limit("names")) } else { Ok(()) }
    }

    pub(super) fn is_declared(&self, name: &str) -> bool {
        self.scope.iter().any(|v| v.name == name) || self.is_member(name)
    }

    /// Whether a name is that of a family or sequence.
    pub(super) fn is_member(&self, name: &str) -> bool {
        self.family(name).is_some() || self.is_sequence(name)
    }

    pub(super) fn is_sequence(&self, name: &str) -> bool {
        self.statement.sequences.iter().any(|s| s.name == name)
    }

    /// The declaration of a family. Families are declared by the claim only, never in a block.
    pub(super) fn family(&self, name: &str) -> Option<&Binding> {
        let is_family = |b: &&Binding| b.names.iter().any(|n| n.1.is_some() && n.0.text == name);
        self.statement.bindings.iter().find(is_family)
    }
}
