//! What the names of an equation are, and what its comments decide.

use super::name::{Names, Symbol};
use carom_checker::claim::preamble::Preamble;
use carom_checker::claim::syntax::{Claim, Item};
use carom_diagnostic::Span;
use std::collections::BTreeMap;

/// What a declared name is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Role {
    /// A variable.
    Variable,
    /// A definition without parameters.
    Definition,
    /// A definition with so many parameters, a family or a sequence.
    Applied(usize),
}

/// What a comment says of something that may be read in two ways.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Decisions {
    /// A comma between relations: whether it says `and` (or a condition).
    pub comma_is_and: Option<bool>,
    /// ±: whether both statements are meant (or one of them).
    pub both_signs: Option<bool>,
    /// A number with ± or with digits in parentheses: whether it is a measured value with its uncertainty.
    pub is_measured: Option<bool>,
    /// The number of significant digits to which the printed number of this equation is rounded.
    pub digits: Option<usize>,
    /// Whether e is the base of exponentials.
    pub e_is_base: bool,
    /// Whether `\log` without a base is the natural logarithm (or the one to base 10).
    pub log_is_natural: Option<bool>,
}

/// What the reader of a formula knows.
pub(crate) struct Scope<'a> {
    /// The names of the paper.
    pub names: &'a mut Names,
    /// What the declared names are, by their spelling.
    pub roles: BTreeMap<String, Role>,
    /// Names that a sum, a product, a limit or a quantifier binds: key and spelling.
    pub bound: Vec<(String, String)>,
    /// What comments decide.
    pub decisions: Decisions,
    /// Whether the upper sign of ± is read.
    pub upper: bool,
    /// Where ± or ∓ was read.
    pub double_sign: Option<Span>,
    /// The number of comparisons that hold ± or ∓.
    pub signed: usize,
    /// Whether a comparison with ± says one of two things where it stands.
    pub splits: bool,
    /// Whether an implication, a quantifier or a negation was read.
    pub has_logic: bool,
    /// The name that nothing declares, where the reading ended for want of it.
    pub missing: Option<Missing>,
}

/// A name that nothing declares.
#[derive(Clone, Debug)]
pub(crate) struct Missing {
    /// The name.
    pub symbol: Symbol,
    /// Whether a parenthesis follows it, as behind a function.
    pub applied: bool,
}

/// What the names are that a claim and its preamble declare.
pub(crate) fn roles(claim: &Claim, preamble: &Preamble) -> BTreeMap<String, Role> {
    let mut out = BTreeMap::new();
    for item in preamble.items.iter().chain(&claim.items) {
        match item {
            Item::Given(bindings) => {
                for (name, index) in bindings.iter().flat_map(|binding| &binding.names) {
                    let role = if index.is_some() { Role::Applied(1) } else { Role::Variable };
                    out.insert(name.text.clone(), role);
                }
            }
            Item::Let { name, parameters, .. } => {
                let role = if parameters.is_empty() { Role::Definition } else { Role::Applied(parameters.len()) };
                out.insert(name.text.clone(), role);
            }
            Item::Define { name, .. } => {
                out.insert(name.text.clone(), Role::Applied(1));
            }
            Item::Assume { .. } => {}
        }
    }
    out
}
