//! A table for LaTeX with the packages booktabs, longtable and siunitx (version 3).
//!
//! The numbers are final: siunitx only aligns them, and its own rounding is switched off. `table-format`
//! is computed from the entries, so that no column is wider than it needs to be.

use super::{Entry, Head};
use crate::report::latex::escape;
use std::io::{self, Write};

/// The most rows of a table that stands on one page.
pub(crate) const PAGE: usize = 40;

pub(crate) fn begin(head: &Head, out: &mut dyn Write) -> io::Result<()> {
    for (name, text) in &head.facts {
        writeln!(out, "% {name}: {text}")?;
    }
    writeln!(out, "% \\usepackage{{booktabs,longtable,siunitx}}")
}

pub(crate) fn rows(head: &Head, rows: &[Vec<Entry>], out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "\\begingroup\n\\sisetup{{round-mode = none, round-pad = false}}")?;
    if !head.latex.is_empty() {
        writeln!(out, "% ${}$", head.latex)?;
    }
    // A table that is longer than a page goes on with its heading on the next one.
    let long = rows.len() > PAGE;
    let environment = if long { "longtable" } else { "tabular" };
    write!(out, "\\begin{{{environment}}}{{@{{}}")?;
    let mut aligned = Vec::new();
    for (place, column) in head.columns.iter().enumerate() {
        let entries = || rows.iter().filter_map(|row| row.get(place));
        let format = if column.numeric && entries().all(|e| !matches!(e, Entry::Small(..))) {
            Format::of(entries().filter_map(|e| numeral(e.plain())))
        } else {
            None
        };
        match &format {
            Some(format) => write!(out, " S[table-format={}]", format.text())?,
            None => write!(out, " {}", if column.numeric { "r" } else { "l" })?,
        }
        aligned.push(format.is_some());
    }
    writeln!(out, " @{{}}}}\n\\toprule")?;
    let headings: Vec<String> = head.columns.iter().map(|c| format!("{{{}}}", c.latex)).collect();
    writeln!(out, "{} \\\\\n\\midrule", headings.join(" & "))?;
    if long {
        writeln!(out, "\\endhead\n\\bottomrule\n\\endfoot")?;
    }
    for row in rows {
        let cells: Vec<String> = row.iter().zip(&aligned).map(|(entry, aligned)| cell(entry, *aligned)).collect();
        writeln!(out, "{} \\\\", cells.join(" & "))?;
    }
    writeln!(out, "{}\\end{{{environment}}}\n\\endgroup", if long { "" } else { "\\bottomrule\n" })
}

/// An entry; in a column that siunitx aligns, what is no decimal stands in braces.
fn cell(entry: &Entry, aligned: bool) -> String {
    let text = entry.plain();
    if let (kept, small, exponent) = entry.parts()
        && !small.is_empty()
    {
        let power = if exponent.is_empty() { String::new() } else { format!("$\\,\\cdot 10^{{{exponent}}}$") };
        return format!("{kept}{{\\scriptsize {small}}}{power}");
    }
    match (numeral(text), aligned) {
        (Some(_), true) => text.to_owned(),
        (Some((whole, fraction, "")), false) => {
            format!("{whole}{}{fraction}", if fraction.is_empty() { "" } else { "." })
        }
        (Some(_), false) => power_of_ten(text),
        (None, _) if text.is_empty() => String::new(),
        (None, true) => format!("{{{}}}", words(text)),
        (None, false) => words(text),
    }
}

/// `1.2e-3` as a product.
fn power_of_ten(text: &str) -> String {
    match text.split_once('e') {
        Some((mantissa, exponent)) => format!("${mantissa} \\cdot 10^{{{exponent}}}$"),
        None => text.to_owned(),
    }
}

/// A fraction, a sign for what is infinite, or words.
fn words(text: &str) -> String {
    match text.split_once('/') {
        Some((p, q)) if [p, q].iter().all(|t| t.bytes().all(|b| b.is_ascii_digit())) => format!("${p}/{q}$"),
        _ if text == "infinite" => "$\\infty$".to_owned(),
        _ => escape(text),
    }
}

/// Whole part, fraction and exponent of a decimal.
fn numeral(text: &str) -> Option<(&str, &str, &str)> {
    let (mantissa, exponent) = text.split_once('e').unwrap_or((text, ""));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = |t: &str| t.bytes().all(|b| b.is_ascii_digit());
    let unsigned = |t: &'static str, s: &str| s.strip_prefix(t).unwrap_or(s).to_owned();
    let whole_digits = unsigned("-", whole);
    let exponent_digits = unsigned("-", exponent);
    (!whole_digits.is_empty() && digits(&whole_digits) && digits(fraction) && digits(&exponent_digits))
        .then_some((whole, fraction, exponent))
}

/// How many digits the entries of a column have, at most.
#[derive(Default)]
struct Format {
    negative: bool,
    whole: usize,
    fraction: usize,
    exponent: usize,
    negative_exponent: bool,
}

impl Format {
    /// `None` for a column without a decimal.
    fn of<'a>(numerals: impl Iterator<Item = (&'a str, &'a str, &'a str)>) -> Option<Format> {
        let mut found: Option<Format> = None;
        for (whole, fraction, exponent) in numerals {
            let format = found.get_or_insert_default();
            format.negative |= whole.starts_with('-');
            format.whole = format.whole.max(whole.trim_start_matches('-').len());
            format.fraction = format.fraction.max(fraction.len());
            format.negative_exponent |= exponent.starts_with('-');
            format.exponent = format.exponent.max(exponent.trim_start_matches('-').len());
        }
        found
    }

    fn text(&self) -> String {
        let sign = |negative: bool| if negative { "-" } else { "" };
        let mut out = format!("{}{}.{}", sign(self.negative), self.whole, self.fraction);
        if self.exponent > 0 {
            out.push_str(&format!("e{}{}", sign(self.negative_exponent), self.exponent));
        }
        out
    }
}
