//! Keys of TOML tables that no reader knows.
//!
//! A misspelt key that is passed over changes what a scene says: every reader refuses it, with the same words.

use carom_diagnostic::nearest;
use std::ops::Range;
use toml::de::DeTable;

/// A key that does not belong into its table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct UnknownKey {
    /// What is wrong.
    pub message: String,
    /// What would be right.
    pub help: String,
    /// Where, in bytes.
    pub span: Range<usize>,
}

/// Refuses the first key that is not known; `place` names the table, as in "the wall".
///
/// # Errors
/// The key, with the nearest known one or all of them.
pub(super) fn known(table: &DeTable<'_>, known: &[&str], place: &str) -> Result<(), UnknownKey> {
    let unknown = table.iter().map(|(key, _)| key).find(|key| !known.contains(&key.get_ref().as_ref()));
    let Some(key) = unknown else { return Ok(()) };
    let name = key.get_ref().as_ref();
    let help = match nearest(name, known.iter().copied()) {
        Some(near) => format!("did you mean {near}?"),
        None => format!("the keys here are {}", known.join(", ")),
    };
    Err(UnknownKey { message: format!("unknown key {name} in {place}"), help, span: key.span() })
}
