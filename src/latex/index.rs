//! Indices that stand above and below names: what depends on a bound index, and what no power is.
//!
//! Contract: a name with a bound index below it is a member of a family or refused, never a constant. A letter above a name that
//! is the index of another name in the same formula is refused as a power where it may be an upper index.

use super::binding::relation_of;
use super::document::{Document, Part};
use super::expression::{NESTING_LIMIT, Read, Reader};
use super::name::{Symbol, UPRIGHT, argument, begin, words_of};
use super::refusal::{ambiguous, refused};
use super::scope::{Missing, Role, Scope};
use super::token::{Kind, Token, raw_tokens};
use carom_diagnostic::Diagnostic;
use std::collections::{BTreeMap, BTreeSet};

/// For each Greek letter the names below which it stands, by their keys.
pub(crate) type Indices = BTreeMap<String, BTreeMap<String, Symbol>>;

/// The keys of the names in an index; words that are set upright are none.
fn names_in(tokens: &[Token]) -> BTreeSet<String> {
    let (mut out, mut at) = (BTreeSet::new(), 0);
    while at < tokens.len() {
        let is_word = tokens[at].command().is_some_and(|name| UPRIGHT.contains(&name));
        match argument(tokens, at + 1).ok().filter(|_| is_word) {
            Some((_, next)) => at = next,
            None => {
                out.extend(begin(&tokens[at..]).map(|(symbol, _)| symbol.key()));
                at += 1;
            }
        }
    }
    out
}

/// Whether an index is a sum or a difference, which only a member of a family has.
pub(crate) fn is_shifted(below: &[Token]) -> bool {
    below.len() > 1 && below[1..].iter().any(|t| matches!(t.char(), Some('+' | '-')))
}

impl Reader<'_, '_, '_> {
    /// The bound name that stands below this one, if the whole is not bound itself.
    pub(crate) fn bound_below(&self, symbol: &Symbol) -> Read<Option<String>> {
        let key = symbol.key();
        if self.scope.bound.iter().any(|bound| bound.0 == key) {
            return Ok(None);
        }
        let mut names = symbol.below.as_deref().map(names_in).unwrap_or_default();
        let base = raw_tokens(&symbol.base, 0)?;
        for at in base.iter().enumerate().filter(|(_, t)| t.is_char('_')).map(|(at, _)| at + 1) {
            names.extend(argument(&base, at).map(|(inner, _)| names_in(inner)).unwrap_or_default());
        }
        Ok(self.scope.bound.iter().map(|bound| &bound.0).find(|bound| names.contains(*bound)).cloned())
    }

    /// Whether what a comment says that a name stands for speaks of this bound name.
    pub(crate) fn is_said_with(&self, said: &str, index: &str) -> bool {
        let own = self.scope.bound.iter().rev().find(|bound| bound.0 == index).map(|bound| bound.1.as_str());
        words_of(said).any(|word| Some(word) == own)
    }

    /// Refuses a name that depends on a bound index and is declared as one number, or not at all.
    pub(crate) fn depends_on(&mut self, symbol: &Symbol, index: &str, is_declared: bool) -> Diagnostic {
        let (key, family) = (symbol.key(), symbol.upper_key());
        if !is_declared && symbol.below.is_some() {
            self.scope.missing = Some(Missing::family(symbol));
        }
        // An index within an accent belongs to no family by itself.
        let family = if symbol.below.is_some() { family } else { "a".to_string() };
        let instead = if is_declared { format!(" instead of {key}") } else { String::new() };
        let help = format!(
            "declare a family{instead}, `%carom given {family}(k) real` with an index k of its own; in a word such as max set \
             the index upright, x_{{\\mathrm{{max}}}}"
        );
        refused(format!("{key} depends on {index}, which is bound here: it is no constant"), help, symbol.span)
    }
}

/// The Greek letters in what stands below names in a paper, each with these names.
pub(crate) fn greek_indices(document: &Document) -> Indices {
    let mut out = Indices::new();
    for part in &document.parts {
        let Part::Display(display) = part else { continue };
        for cell in display.rows.iter().flat_map(|row| &row.cells).filter(|cell| depth(cell) <= NESTING_LIMIT) {
            for symbol in (0..cell.len()).filter_map(|at| begin(&cell[at..])).map(|found| found.0) {
                let below = symbol.below.as_deref().map(names_in).unwrap_or_default();
                for index in below.into_iter().filter(|name| name.starts_with('\\')) {
                    out.entry(index).or_default().insert(symbol.key(), symbol.clone());
                }
            }
        }
    }
    out
}

/// How deep groups are nested in these tokens.
fn depth(tokens: &[Token]) -> usize {
    let deeper = |(level, most): (usize, usize), token: &Token| match token.kind {
        Kind::Open => (level + 1, most.max(level + 1)),
        Kind::Close => (level.saturating_sub(1), most),
        _ => (level, most),
    };
    tokens.iter().fold((0, 0), deeper).1
}

/// Refuses a power whose exponent is the lower index of a number in the same formula, as in `p^\mu p_\mu`.
pub(crate) fn no_upper_index(tokens: &[Token], scope: &Scope<'_>) -> Result<(), Diagnostic> {
    let role = |key: &str| scope.names.spelled(key).and_then(|name| scope.roles.get(name));
    let is_number = |symbol: &Symbol| {
        !matches!(role(&symbol.upper_key()), Some(Role::Applied(_))) && !scope.names.is_renamed(&symbol.key())
    };
    let mut lower: Vec<(usize, String, BTreeSet<String>)> = Vec::new();
    let mut upper: Vec<(usize, Symbol, &[Token])> = Vec::new();
    let mut part = 0;
    for (at, token) in tokens.iter().enumerate() {
        part += usize::from(
            relation_of(token).is_some() || matches!(token.char(), Some('+' | '-' | ',')) || token.is("quad"),
        );
        let is_script = at > 0 && matches!(tokens[at - 1].char(), Some('_' | '^'));
        let Some((symbol, next)) = begin(&tokens[at..]).filter(|_| !is_script) else { continue };
        if let Some(below) = symbol.below.as_ref().filter(|_| is_number(&symbol)) {
            lower.push((part, symbol.base.clone(), names_in(below)));
        }
        if tokens.get(at + next).is_some_and(|t| t.is_char('^'))
            && let Ok((above, _)) = argument(tokens, at + next + 1)
            && above.iter().all(|t| t.char().is_some_and(char::is_alphabetic) || matches!(t.kind, Kind::Command(_)))
        {
            upper.push((part, symbol, above));
        }
    }
    for (part, symbol, above) in upper {
        let names = names_in(above);
        let is_index = |(other, base, below): &(usize, String, BTreeSet<String>)| {
            !names.is_disjoint(below) && (*other == part || *base == symbol.base)
        };
        let is_greek =
            names.iter().filter_map(|name| scope.indices.get(name)).any(|lower| lower.values().any(is_number));
        if is_greek || lower.iter().any(is_index) {
            let key = symbol.key();
            let readings = ["a power", "an upper index"];
            let write = [
                "name what has that index below it, `%carom name p_\\mu as pm`, or declare a family, `%carom given p(k) real`",
                "name the components, as in p_0^2 - p_1^2, or write `%carom skip`",
            ];
            return Err(ambiguous(&format!("what stands above {key}"), readings, write, symbol.span));
        }
    }
    Ok(())
}
