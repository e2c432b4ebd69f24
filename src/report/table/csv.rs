//! Comma-separated values; what stands above the heading are comment lines that begin with `#`.

use super::{Entry, Head};
use std::io::{self, Write};

pub fn head(head: &Head) -> String {
    let mut out = String::new();
    for (name, text) in &head.facts {
        out.push_str(&format!("# {name}: {text}\n"));
    }
    let names: Vec<String> = head.columns.iter().map(|c| quoted(&c.name)).collect();
    out.push_str(&names.join(","));
    out.push('\n');
    out
}

pub fn row(row: &[Entry], out: &mut dyn Write) -> io::Result<()> {
    let mut line: String = row.iter().map(|e| quoted(e.plain())).collect::<Vec<_>>().join(",");
    line.push('\n');
    out.write_all(line.as_bytes())
}

/// A field, between quotation marks where it needs them.
fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text.to_owned() }
}
