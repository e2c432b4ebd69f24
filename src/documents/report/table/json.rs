//! One object: the head, then the rows, each on a line. Numbers are strings, so that no digit is lost.

use super::{Entry, Head};
use serde_json::{Map, Value};
use std::io::{self, Write};

pub(super) fn begin(head: &Head, out: &mut dyn Write) -> io::Result<()> {
    write!(out, "{{\"head\":{{")?;
    for (place, (name, text)) in head.facts.iter().enumerate() {
        write!(out, "{}{}:{}", if place == 0 { "" } else { "," }, Value::from(*name), Value::from(text.as_str()))?;
    }
    write!(out, "}},\n\"rows\":[")
}

pub(super) fn row(head: &Head, row: &[Entry], first: bool, out: &mut dyn Write) -> io::Result<()> {
    let value = |entry: &Entry| match entry {
        Entry::Empty => Value::Null,
        entry => Value::from(entry.plain()),
    };
    let object: Map<String, Value> =
        head.columns.iter().zip(row).map(|(column, entry)| (column.name.clone(), value(entry))).collect();
    write!(out, "{}\n{}", if first { "" } else { "," }, Value::Object(object))
}

pub(super) fn end(rows: u64, out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "{}],\n\"count\":{rows}}}", if rows == 0 { "" } else { "\n" })
}
