//! `carom table --check`: compares somebody else's table with the certified values.

use super::output::Output;
use super::progress::Progress;
use super::{Exit, load, print};
use crate::number::decimal::Rounding;
use crate::report::comparison::{entries, head, summary};
use crate::report::table::{Entry, Form, LATEX_ROWS, Writer};
use crate::table::comparison::{Comparison, ComparisonError, Given, Tally};
use std::io::{BufReader, Write};
use std::path::Path;

/// Runs the check.
pub(super) fn run(
    path: &Path,
    given: &Given,
    rounding: Rounding,
    form: Form,
    output: Option<&Path>,
) -> Result<u8, Exit> {
    let shown = path.display();
    let failure =
        |e: ComparisonError| Exit { code: if e.is_limit() { 3 } else { 2 }, message: format!("error: {shown}: {e}") };
    let file = load::open(path).map_err(|e| Exit::usage(format!("error: cannot read {shown}: {e}")))?;
    let mut table = Comparison::open(BufReader::new(file), given).map_err(failure)?;
    let mut out: Vec<u8> = Vec::new();
    let mut writer = Writer::new(form, head(table.quantities(), rounding));
    let (mut tally, mut rows) = (Tally::default(), 0);
    let mut target = output.map(Output::file).transpose()?;
    let mut flush = |out: &mut Vec<u8>| -> Result<(), Exit> {
        match &mut target {
            Some(file) => {
                file.write_all(out).map_err(|e| Exit::usage(format!("error: cannot write the report: {e}")))?;
            }
            None => print(&String::from_utf8_lossy(out))?,
        }
        out.clear();
        Ok(())
    };
    let unwritten = |e: std::io::Error| Exit::usage(format!("error: cannot write: {e}"));
    writer.begin(&mut out).map_err(unwritten)?;
    let progress = output.is_some().then(|| Progress::alone("comparing"));
    while let Some(cells) = table.row(rounding).map_err(failure)? {
        if let Some(progress) = progress.as_ref().filter(|_| rows % 256 == 0) {
            progress.now(0, &format!("{rows} cells compared"));
        }
        for cell in &cells {
            tally.count(cell);
            let entries = entries(cell);
            // JSON writes control characters by their numbers itself.
            let entries = if form == Form::Json { entries } else { entries.into_iter().map(Entry::visible).collect() };
            writer.row(entries, &mut out).map_err(unwritten)?;
            rows += 1;
            if form == Form::Latex && rows > LATEX_ROWS {
                let message = format!("error: limit reached: rows of a table in LaTeX: {LATEX_ROWS} allowed");
                return Err(Exit { code: 3, message });
            }
        }
        if out.len() > 1 << 16 {
            flush(&mut out)?;
        }
    }
    drop(progress);
    writer.end(&mut out).map_err(unwritten)?;
    let summary = summary(&tally);
    if form == Form::Text {
        writeln!(out, "\n{summary}").map_err(unwritten)?;
    }
    flush(&mut out)?;
    if form != Form::Text || output.is_some() {
        // Machine-readable output must not end with a line of prose.
        let _ = writeln!(anstream::stderr(), "{summary}");
    }
    if tally.judged() == 0 {
        return Err(Exit::usage(format!("error: {shown}: there is no cell to check")));
    }
    if let Some(file) = target {
        file.finish()?;
    }
    Ok(u8::from(tally.right < tally.judged()))
}
