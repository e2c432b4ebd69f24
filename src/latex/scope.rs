//! What the names of an equation are, and what its comments decide.

use super::domain::Domain;
use super::index::Indices;
use super::name::{Names, Symbol, mentions};
use super::outcome::Wanted;
use super::refusal::one_value;
use super::token::Token;
use super::vector::Vectors;
use carom_checker::claim::preamble::Preamble;
use carom_checker::claim::syntax::{Claim, Expr, ExprKind, Item};
use carom_checker::claim::walk;
use carom_diagnostic::{Diagnostic, Span};
use std::collections::BTreeMap;

/// What a declared name is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Role {
    /// A variable.
    Variable,
    /// A definition without parameters.
    Definition,
    /// The same, of a matrix.
    Matrix,
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
    /// Whether words at the ends of an equation are no part of it.
    pub has_remarks: bool,
    /// Whether d before a name is a number, and no differential.
    pub d_is_number: bool,
    /// Whether `\log` without a base is the natural logarithm (or the one to base 10).
    pub log_is_natural: Option<bool>,
}

/// What the reader of a formula knows.
pub(crate) struct Scope<'a> {
    /// The names of the paper.
    pub names: &'a mut Names,
    /// What the declared names are, by their spelling.
    pub roles: BTreeMap<String, Role>,
    /// The domains of the declared variables, by their spelling.
    pub domains: BTreeMap<String, Domain>,
    /// Greek letters that stand below names in the paper, with the names.
    pub indices: &'a Indices,
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
    /// Whether a rounded or measured number was read.
    pub has_printed: bool,
    /// Where a value with a name, such as v(t), was read.
    pub value: Option<Span>,
    /// Whether an implication, a quantifier or a negation was read.
    pub has_logic: bool,
    /// Whether `or`, `not` or `exists` was read.
    pub has_choice: bool,
    /// Whether a range or an index is being read, whose names are natural numbers.
    pub counts: bool,
    /// Whether an exponent is being read, where no number is a measured one.
    pub is_exponent: bool,
    /// Whether what stands in bars is being read.
    pub within_bars: bool,
    /// Where vectors were read.
    pub vectors: Vectors,
    /// The name that nothing declares, where the reading ended for want of it.
    pub missing: Option<Missing>,
}

impl Scope<'_> {
    /// The spelling of a name that is bound from here on: a new one where what is declared around it has its own.
    pub(crate) fn bind(&mut self, symbol: &Symbol) -> Result<String, Diagnostic> {
        let mut name = self.names.of(symbol)?;
        while self.roles.contains_key(&name) || self.bound.iter().any(|bound| bound.1 == name) {
            name = format!("{}_in", name.trim_end_matches('\''));
        }
        self.bound.push((symbol.key(), name.clone()));
        Ok(name)
    }

    /// Takes note of a value with a name; it is one number, so its argument must not vary here.
    pub(crate) fn values_at(&mut self, argument: &[Token], key: &str, span: Span) -> Result<(), Diagnostic> {
        self.value = Some(span);
        match self.bound.iter().any(|(bound, _)| mentions(argument, bound)) {
            true => Err(one_value(key, span)),
            false => Ok(()),
        }
    }
}

/// A name that nothing declares.
#[derive(Clone, Debug)]
pub(crate) struct Missing {
    /// The name.
    pub symbol: Symbol,
    /// What it may be.
    pub wanted: Wanted,
}

impl Missing {
    /// The family that a name with an index below it is a member of.
    pub(crate) fn family(symbol: &Symbol) -> Missing {
        Missing { symbol: Symbol { below: None, ..symbol.clone() }, wanted: Wanted::Family }
    }
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
            Item::Let { name, parameters, value } => {
                let role = match parameters.len() {
                    0 if is_matrix(value, &out) => Role::Matrix,
                    0 => Role::Definition,
                    count => Role::Applied(count),
                };
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

/// Whether an expression is a matrix by its form.
fn is_matrix(value: &Expr, roles: &BTreeMap<String, Role>) -> bool {
    match &value.kind {
        ExprKind::Matrix(_) => true,
        ExprKind::Name(name) => roles.get(name) == Some(&Role::Matrix),
        ExprKind::Apply(name, _) => name.text == "transpose" || name.text == "inverse",
        ExprKind::Negate(_) | ExprKind::Sum(_) | ExprKind::Product(_) | ExprKind::Power(..) => {
            let mut found = false;
            walk::parts(value, &mut |part| found = found || is_matrix(part, roles));
            found
        }
        _ => false,
    }
}
