//! Comma-separated values; what stands above the heading are comment lines that begin with `#`.
//!
//! For a spreadsheet there are no comment lines, and a byte order mark says that the text is UTF-8. A fraction has the sign
//! U+2044, `9⁄16`: with `/` a spreadsheet takes it for a date. A foreign text that could be taken for a formula or a date
//! has an apostrophe before it.

use super::{Entry, Head};
use std::borrow::Cow;
use std::io::{self, Write};

/// What separates fields and decimals, and whether it is for a spreadsheet.
#[derive(Clone, Copy)]
pub(super) enum Dialect {
    /// For programs, and for people who read comments.
    Plain,
    /// For a spreadsheet that writes 0.5.
    Spreadsheet,
    /// For a spreadsheet that writes 0,5: fields are separated by semicolons.
    Comma,
}

impl Dialect {
    fn separator(self) -> u8 {
        if matches!(self, Self::Comma) { b';' } else { b',' }
    }

    /// A field as it is written.
    fn field(self, text: &str) -> Cow<'_, str> {
        let text = if matches!(self, Self::Plain) { Cow::Borrowed(text) } else { self.cell(text) };
        quoted(text, self.separator())
    }

    /// A text that a spreadsheet takes for nothing else.
    fn cell(self, text: &str) -> Cow<'_, str> {
        let comma = |text: &str| if matches!(self, Self::Comma) { text.replace('.', ",") } else { text.to_owned() };
        if is_decimal(text) {
            return comma(text).into();
        }
        if text.split_once('/').is_some_and(|(above, below)| is_whole(above) && is_digits(below)) {
            return text.replace('/', "\u{2044}").into();
        }
        // The heading of a column of a cross table.
        if let Some((name, label)) = text.split_once(" = ") {
            return format!("{name} = {}", comma(label)).into();
        }
        if text.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '=' | '+' | '-' | '@' | '\t')) {
            return format!("'{text}").into();
        }
        text.into()
    }
}

/// A field of CSV, in quotation marks where they are necessary.
#[must_use]
pub fn quoted(text: Cow<'_, str>, separator: u8) -> Cow<'_, str> {
    let is_special = |c: char| c == char::from(separator) || matches!(c, '"' | '\n' | '\r');
    if text.contains(is_special) { format!("\"{}\"", text.replace('"', "\"\"")).into() } else { text }
}

fn is_digits(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit())
}

fn is_whole(text: &str) -> bool {
    is_digits(text.strip_prefix(['-', '+']).unwrap_or(text))
}

/// Whether a text is a decimal, perhaps with a power of ten.
fn is_decimal(text: &str) -> bool {
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let (whole, places) = mantissa.split_once('.').unwrap_or((mantissa, "0"));
    is_whole(whole) && is_digits(places) && is_whole(exponent)
}

pub(super) fn head(head: &Head, dialect: Dialect) -> String {
    let mut out = String::new();
    if let Dialect::Plain = dialect {
        for (name, text) in &head.facts {
            out.push_str(&format!("# {name}: {text}\n"));
        }
    } else {
        out.push('\u{feff}');
    }
    for (place, column) in head.columns.iter().enumerate() {
        out.extend((place > 0).then(|| char::from(dialect.separator())));
        out.push_str(&dialect.field(&column.name));
    }
    out.push('\n');
    out
}

pub(super) fn row(row: &[Entry], dialect: Dialect, out: &mut dyn Write) -> io::Result<()> {
    for (place, entry) in row.iter().enumerate() {
        if place > 0 {
            out.write_all(&[dialect.separator()])?;
        }
        out.write_all(dialect.field(entry.plain()).as_bytes())?;
    }
    out.write_all(b"\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_cell_is_taken_for_a_date_or_a_formula() {
        for (text, written, comma) in [
            ("9/16", "9\u{2044}16", "9\u{2044}16"),
            ("-1/2", "-1\u{2044}2", "-1\u{2044}2"),
            ("0.25", "0.25", "0,25"),
            ("-2.5e-3", "-2.5e-3", "-2,5e-3"),
            ("12", "12", "12"),
            ("infinite", "infinite", "infinite"),
            ("3-4", "'3-4", "'3-4"),
            ("1.2.3", "'1.2.3", "'1.2.3"),
            ("=HYPERLINK(\"x\")", "\"'=HYPERLINK(\"\"x\"\")\"", "\"'=HYPERLINK(\"\"x\"\")\""),
            ("@SUM(1)", "'@SUM(1)", "'@SUM(1)"),
            ("a, b; c", "\"a, b; c\"", "\"a, b; c\""),
            ("e = 0.5", "e = 0.5", "e = 0,5"),
            ("", "", ""),
        ] {
            assert_eq!(Dialect::Spreadsheet.field(text), written);
            assert_eq!(Dialect::Comma.field(text), comma);
        }
        assert_eq!(Dialect::Plain.field("9/16"), "9/16");
    }
}
