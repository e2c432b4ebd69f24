//! The lines of a statement.

use super::words::mentions;

/// The longest line that is printed where there is a space to break at.
const WIDTH: usize = 110;

/// Drops every `let` that nothing after it mentions: derivatives and limits have theirs put in place.
pub(super) fn without_unused(lines: Vec<String>) -> Vec<String> {
    let mut out: Vec<String> = Vec::new();
    for line in lines.into_iter().rev() {
        let word = line.strip_prefix("let ").and_then(|rest| rest.split(' ').next());
        if word.is_none_or(|word| out.iter().any(|later| mentions(later, word))) || !line.ends_with(" in") {
            out.push(line);
        }
    }
    out.reverse();
    out
}

/// Lines indented by two; long ones are broken, after a connective or relation where there is one.
pub(super) fn laid_out(lines: &[String]) -> String {
    const AFTER: &[&str] = &["->", "/\\", "\\/", "<->", "=", "<=", ">=", "<", ">", "<>", ":="];
    let mut out = Vec::new();
    for line in lines.iter().flat_map(|l| l.lines()) {
        let mut words: Vec<&str> = line.split_whitespace().collect();
        let mut indent = 2;
        loop {
            let (mut length, mut fits) = (indent, 0);
            for word in &words {
                length += word.chars().count() + 1;
                if fits > 0 && length > WIDTH + 1 {
                    break;
                }
                fits += 1;
            }
            let break_at = if fits == words.len() {
                fits
            } else {
                let last = |signs: &[&str]| {
                    (fits / 3..fits).rev().find(|i| words.get(*i).is_some_and(|w| signs.contains(w))).map(|i| i + 1)
                };
                last(AFTER).or_else(|| last(&["+", "-", "*", "/"])).unwrap_or(fits)
            };
            let rest = words.split_off(break_at);
            out.push(format!("{}{}", " ".repeat(indent), words.join(" ")));
            if rest.is_empty() {
                break;
            }
            (words, indent) = (rest, 6);
        }
    }
    out.join("\n")
}
