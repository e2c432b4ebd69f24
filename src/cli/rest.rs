//! What can be read of a claim file in which some claims have faults.

use crate::claim::diagnostic::Diagnostic;
use crate::claim::parse::parse_under;
use crate::claim::preamble::Preamble;
use crate::claim::syntax::Claim;
use std::collections::BTreeSet;

/// The claims without a fault, the names of the others, and all faults that were found.
pub(super) struct Rest {
    pub claims: Vec<Claim>,
    pub lost: Vec<String>,
    pub faults: Vec<Diagnostic>,
}

/// The claims of a file that has these faults. A fault before the first claim is one of all claims.
///
/// A faulty claim is read as blanks, so that the others keep their places; where that shows further faults, so are theirs.
pub(super) fn rest(source: &str, folder: &Preamble, mut faults: Vec<Diagnostic>) -> Rest {
    let starts = starts(source);
    let name = |claim: &usize| starts.get(*claim).map(|start| start.1.to_owned());
    let mut faulty: BTreeSet<usize> = BTreeSet::new();
    let mut new = faults.clone();
    let claims = loop {
        let before = faulty.len();
        let of = |fault: &Diagnostic| starts.partition_point(|start| start.0 <= fault.span.start).checked_sub(1);
        let Some(more) = new.iter().map(of).collect::<Option<Vec<usize>>>() else { break Vec::new() };
        faulty.extend(more);
        if faulty.len() == before || faulty.len() == starts.len() {
            break Vec::new();
        }
        match parse_under(&blanked(source, &starts, &faulty), folder) {
            Ok((claims, _)) => break claims,
            Err(more) => {
                faults.extend(more.iter().cloned());
                new = more;
            }
        }
    };
    let lost = if claims.is_empty() { (0..starts.len()).collect() } else { faulty };
    Rest { claims, lost: lost.iter().filter_map(name).collect(), faults }
}

/// Where each claim begins, and its name.
fn starts(source: &str) -> Vec<(usize, &str)> {
    let mut at = 0;
    let lines = source.split_inclusive('\n').map(|line| {
        at += line.len();
        (at - line.len(), line)
    });
    let named = |(at, line): (usize, &'_ str)| -> Option<(usize, usize, usize)> {
        let text = line.trim_start();
        let rest = text.strip_prefix("claim").filter(|rest| rest.starts_with(char::is_whitespace))?.trim_start();
        let from = at + line.len() - rest.len();
        let length = rest.find(|c: char| c.is_whitespace() || c == '"').unwrap_or(rest.len());
        Some((at + line.len() - text.len(), from, from + length))
    };
    lines.filter_map(named).map(|(at, from, to)| (at, &source[from..to])).collect()
}

/// The text with spaces in the place of these claims.
fn blanked(source: &str, starts: &[(usize, &str)], claims: &BTreeSet<usize>) -> String {
    let mut text = source.to_owned();
    for claim in claims {
        let end = starts.get(claim + 1).map_or(source.len(), |next| next.0);
        let place = starts[*claim].0..end;
        let blank: String = source[place.clone()].bytes().map(|byte| if byte == b'\n' { '\n' } else { ' ' }).collect();
        text.replace_range(place, &blank);
    }
    text
}
