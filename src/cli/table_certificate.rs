//! `carom check` for certificates of tables: read line by line, in memory that does not grow with the table.

use super::progress::Progress;
use super::{Exit, load};
use crate::certificate::text::FILE_LIMIT;
use crate::report::visible_lines;
use crate::table_checker::Failure;
use crate::table_checker::text::LINE_LIMIT;
use crate::table_checker::{AcceptedTable, Checker};
use std::fs::File;
use std::io::{BufRead, BufReader, Read};
use std::path::{Path, PathBuf};

/// How the certificate of a table begins; no other certificate does.
const BEGIN: &[u8] = b"{";

/// The certificate of a table: a file, or an opened pipe with the bytes read from it so far.
pub(super) struct Table {
    path: PathBuf,
    opened: Option<Box<dyn Read>>,
}

/// Something else: a path, or the text of a pipe.
pub(super) enum Other {
    /// A file or folder.
    Path(PathBuf),
    /// A pipe's name and what it holds, up to one byte more than a certificate may have.
    Text(PathBuf, Vec<u8>),
}

/// Separates certificates of tables from other files. Standard input is `-`; a pipe is opened only once.
pub(crate) fn told_apart(paths: &[PathBuf]) -> Result<(Vec<Table>, Vec<Other>), Exit> {
    let mut tables = Vec::new();
    let mut others = Vec::new();
    for path in paths {
        let input = load::is_standard_input(path);
        let kind = if input { None } else { std::fs::metadata(path).ok() };
        let mut opened: Box<dyn Read> = match &kind {
            kind if input || kind.as_ref().is_some_and(|kind| !kind.is_dir()) => {
                load::open(path).map_err(|e| unread(path, &e))?
            }
            _ => {
                others.push(Other::Path(path.clone()));
                continue;
            }
        };
        let mut start = Vec::new();
        opened.by_ref().take(BEGIN.len() as u64).read_to_end(&mut start).map_err(|e| unread(path, &e))?;
        let is_table = start == BEGIN;
        let mut opened = std::io::Cursor::new(start).chain(opened);
        match kind.is_some_and(|kind| kind.is_file()) {
            // Files are opened again one by one, however many there are.
            true if is_table => tables.push(Table { path: path.clone(), opened: None }),
            true => others.push(Other::Path(path.clone())),
            false if is_table => tables.push(Table { path: path.clone(), opened: Some(Box::new(opened)) }),
            false => {
                let mut bytes = Vec::new();
                opened.by_ref().take(FILE_LIMIT as u64 + 1).read_to_end(&mut bytes).map_err(|e| unread(path, &e))?;
                others.push(Other::Text(path.clone(), bytes));
            }
        }
    }
    Ok((tables, others))
}

fn unread(path: &Path, error: &std::io::Error) -> Exit {
    Exit::usage(format!("error: cannot read {}: {error}", path.display()))
}

/// Why a table was not accepted, and where.
struct Stopped {
    place: String,
    failure: Failure,
}

/// Checks tables one after another, and says each as soon as it is checked: 1 if one is rejected, else 3 if a limit was
/// reached.
pub(super) fn run(tables: Vec<Table>, quiet: bool, say: &mut dyn FnMut(&str) -> Result<(), Exit>) -> Result<u8, Exit> {
    let mut code = 0;
    for Table { path, opened } in tables {
        let name = path.display();
        let text = match check(&path, opened)? {
            Ok(table) => {
                let rests_on = match table.rests_on() {
                    [] => String::new(),
                    claims => format!("  (rests on {})", claims.join(", ")),
                };
                let rows = if table.rows() == 1 { "row" } else { "rows" };
                let mut text = format!("accepted  {name}: {} {rows}{rests_on}\n", table.rows());
                if !quiet {
                    text.extend(table.text().lines().map(|line| format!("    {line}\n")));
                }
                text
            }
            Err(Stopped { place, failure: Failure::Rejected(reason) }) => {
                code = 1;
                format!("rejected  {name}: {place}: {reason}\n")
            }
            Err(Stopped { place, failure: Failure::Declined(limit) }) => {
                code = if code == 1 { 1 } else { 3 };
                format!("declined  {name}: {place}: limit reached: {limit}\n")
            }
        };
        // A reason quotes the file.
        say(&visible_lines(&text))?;
    }
    Ok(code)
}

/// The next line without its end; `None` at the end of the file.
fn line<'a>(
    file: &mut impl BufRead,
    path: &Path,
    bytes: &'a mut Vec<u8>,
) -> Result<Option<Result<&'a str, Failure>>, Exit> {
    bytes.clear();
    let limit = LINE_LIMIT as u64 + 1;
    file.by_ref().take(limit).read_until(b'\n', bytes).map_err(|e| unread(path, &e))?;
    if bytes.is_empty() {
        return Ok(None);
    }
    let rejected = |reason: &str| Err(Failure::Rejected(reason.to_owned()));
    Ok(Some(match bytes.split_last() {
        Some((b'\n', line)) => std::str::from_utf8(line).or_else(|_| rejected("the line is not UTF-8 text")),
        _ if bytes.len() > LINE_LIMIT => Err(Failure::Declined("bytes of a line")),
        _ => rejected("the line has no end: the file was cut off"),
    }))
}

fn check(path: &Path, opened: Option<Box<dyn Read>>) -> Result<Result<AcceptedTable, Stopped>, Exit> {
    let opened = match opened {
        Some(opened) => opened,
        None => Box::new(File::open(path).map_err(|e| unread(path, &e))?),
    };
    let mut file = BufReader::with_capacity(1 << 16, opened);
    let mut bytes = Vec::new();
    let stopped = |place: &str, failure| Ok(Err(Stopped { place: place.to_owned(), failure }));
    let head = match line(&mut file, path, &mut bytes)? {
        None => return stopped("head", Failure::Rejected("the file is empty".to_owned())),
        Some(head) => head.and_then(Checker::new),
    };
    let mut checker = match head {
        Ok(checker) => checker,
        Err(failure) => return stopped("head", failure),
    };
    let (progress, mut rows) = (Progress::alone("checking"), 0u64);
    while let Some(row) = line(&mut file, path, &mut bytes)? {
        rows += 1;
        if rows % 1024 == 0 {
            progress.now(0, &format!("{}: {rows} rows", path.display()));
        }
        if let Err(failure) = row.and_then(|row| checker.row(row)) {
            return stopped(&checker.place(), failure);
        }
    }
    Ok(checker.finish().map_err(|failure| Stopped { place: "end".to_owned(), failure }))
}
