//! A table of Markdown; small digits as subscripts.

use super::{Entry, Head};
use crate::report::markdown::escape;
use std::io::{self, Write};

pub(super) fn begin(head: &Head, out: &mut dyn Write) -> io::Result<()> {
    for (name, text) in &head.facts {
        writeln!(out, "- {name}: `{text}`")?;
    }
    let line = |cells: Vec<String>| format!("| {} |", cells.join(" | "));
    writeln!(out, "\n{}", line(head.columns.iter().map(|c| escape(&c.name)).collect()))?;
    writeln!(out, "{}", line(head.columns.iter().map(|c| if c.numeric { "--:" } else { ":--" }.to_owned()).collect()))
}

pub(super) fn row(row: &[Entry], out: &mut dyn Write) -> io::Result<()> {
    let cells: Vec<String> = row.iter().map(shown).collect();
    writeln!(out, "| {} |", cells.join(" | "))
}

fn shown(entry: &Entry) -> String {
    match entry.parts() {
        (kept, "", _) => escape(kept),
        (kept, small, "") => format!("{kept}<sub>{small}</sub>"),
        (kept, small, exponent) => format!("{kept}<sub>{small}</sub>e{exponent}"),
    }
}
