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
    for (i, entry) in row.iter().enumerate() {
        if i > 0 {
            out.write_all(b",")?;
        }
        let text = entry.plain();
        if text.contains(SPECIAL) {
            out.write_all(quoted(text).as_bytes())?;
        } else {
            out.write_all(text.as_bytes())?;
        }
    }
    out.write_all(b"\n")
}

/// What makes quotation marks necessary.
const SPECIAL: [char; 4] = [',', '"', '\n', '\r'];

/// A field, between quotation marks where it needs them.
fn quoted(text: &str) -> String {
    if text.contains(SPECIAL) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text.to_owned() }
}
