//! Aligned columns: numbers to the right, words to the left.

use super::{Entry, Head};
use crate::report::push_padded;
use std::borrow::Cow;
use std::io::{self, Write};

pub(super) fn begin(head: &Head, out: &mut dyn Write) -> io::Result<()> {
    for (name, text) in &head.facts {
        writeln!(out, "{name}: {text}")?;
    }
    writeln!(out)
}

/// Small digits stand after a bar.
fn shown(entry: &Entry) -> Cow<'_, str> {
    if !matches!(entry, Entry::Small(..)) {
        return Cow::Borrowed(entry.plain());
    }
    let (kept, small, exponent) = entry.parts();
    let bar = if small.is_empty() { "" } else { "|" };
    let e = if exponent.is_empty() { "" } else { "e" };
    Cow::Owned(format!("{kept}{bar}{small}{e}{exponent}"))
}

pub(crate) fn widths(head: &Head, rows: &[Vec<Entry>]) -> Vec<usize> {
    let width = |(place, column): (usize, &super::Column)| {
        let entries = rows.iter().filter_map(|row| Some(shown(row.get(place)?).chars().count()));
        entries.max().unwrap_or(0).max(column.name.chars().count())
    };
    head.columns.iter().enumerate().map(width).collect()
}

pub(super) fn heading(head: &Head, widths: &[usize], out: &mut dyn Write) -> io::Result<()> {
    let names: Vec<Entry> = head.columns.iter().map(|c| Entry::Plain(c.name.clone())).collect();
    row(head, &names, widths, out)?;
    let rules: Vec<String> = widths.iter().map(|w| "-".repeat(*w)).collect();
    writeln!(out, "{}", rules.join("  "))
}

pub(super) fn row(head: &Head, row: &[Entry], widths: &[usize], out: &mut dyn Write) -> io::Result<()> {
    let mut line = String::with_capacity(widths.iter().sum::<usize>() + 2 * widths.len());
    for (place, ((entry, column), width)) in row.iter().zip(&head.columns).zip(widths).enumerate() {
        if place > 0 {
            line.push_str("  ");
        }
        push_padded(&mut line, &shown(entry), *width, column.numeric);
    }
    line.truncate(line.trim_end().len());
    line.push('\n');
    out.write_all(line.as_bytes())
}
