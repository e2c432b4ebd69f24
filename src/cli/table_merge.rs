//! `carom table --merge`: the parts of one table, or of its certificate, put together.
//!
//! **Contract.** What is written is, byte for byte, what one run without `--shard` writes. It is written only where the
//! heads of all files describe the same table, every part of it is there once, and each file holds its own rows, each at
//! its place: the values of the axes are compared with those that belong there, a row has as many fields as the heading,
//! and a value. The order of the files does not matter. The certified digits themselves
//! are not computed again.

use super::Exit;
use super::load::cannot_read;
use super::output::Output;
use super::table_rows::{Form, Rows};
use crate::report::visible;
use crate::table::Plan;
use crate::table::shard::{Binding, Shard};
use serde_json::{Map, Value, json};
use std::fs::File;
use std::io::{self, BufRead, BufReader, BufWriter, Read, Write};
use std::path::{Path, PathBuf};

/// The name of a shard's fact about the whole table.
pub(super) const TABLE: &str = "table";
/// The name of a shard's fact about its own place.
pub(crate) const SHARD: &str = "shard";

/// The longest head that is read.
const MAX_HEAD: u64 = 64 << 20;

/// A certificate's head with what binds a shard to its table.
pub(crate) fn bind(head: &str, binding: &Binding) -> String {
    let mut object: Map<String, Value> = serde_json::from_str(head).unwrap_or_default();
    object.insert(SHARD.to_owned(), json!({ TABLE: binding.table, SHARD: binding.shard }));
    format!("{}\n", Value::Object(object))
}

/// A file with a part of a table.
struct Part<'a> {
    path: &'a Path,
    shard: Shard,
    plan: Plan,
    binding: Binding,
    /// The head without what binds it: that of the whole table.
    head: String,
    /// How long its own head is.
    length: u64,
    form: Form,
}

fn fault(path: &Path, what: &str) -> Exit {
    Exit::usage(format!("error: {}: {what}", path.display()))
}

/// Runs the command.
pub(super) fn run(files: &[PathBuf], output: Option<&Path>) -> Result<u8, Exit> {
    let mut parts = files.iter().map(|path| Part::open(path)).collect::<Result<Vec<_>, _>>()?;
    parts.sort_by_key(|part| part.shard.part());
    agree(&parts)?;
    match output {
        None => {
            let mut out = BufWriter::new(io::stdout().lock());
            match copy(&parts, &mut out) {
                Err(Stop::Write(e)) if e.kind() == io::ErrorKind::BrokenPipe => Ok(0),
                Err(Stop::Write(e)) => Err(Exit::usage(format!("error: cannot write the table: {e}"))),
                Err(Stop::Part(exit)) => Err(exit),
                Ok(()) => Ok(0),
            }
        }
        Some(path) => {
            let mut out = BufWriter::new(Output::file(path)?);
            let cannot = |e: io::Error| Exit::usage(format!("error: cannot write {}: {e}", path.display()));
            match copy(&parts, &mut out) {
                Ok(()) => out.into_inner().map_err(|e| cannot(e.into_error()))?.finish().map(|()| 0),
                Err(Stop::Write(e)) => Err(cannot(e)),
                Err(Stop::Part(exit)) => Err(exit),
            }
        }
    }
}

impl<'a> Part<'a> {
    fn open(path: &'a Path) -> Result<Part<'a>, Exit> {
        // It is read twice, and opening a pipe waits for its writer.
        if !std::fs::metadata(path).map_err(|e| cannot_read(path, &e))?.is_file() {
            return Err(fault(path, "this is not a regular file"));
        }
        let mut reader = BufReader::new(File::open(path).map_err(|e| cannot_read(path, &e))?.take(MAX_HEAD));
        let mut line = || -> Result<String, Exit> {
            let mut line = String::new();
            reader.read_line(&mut line).map_err(|e| cannot_read(path, &e))?;
            Ok(line)
        };
        let (mut head, mut length) = (String::new(), 0);
        let (mut table, mut shard) = (None, None);
        let form = loop {
            let text = line()?;
            length += text.len() as u64;
            if text.starts_with('{') && head.is_empty() {
                (head, table, shard) = unbind(&text).ok_or_else(|| fault(path, NO_SHARD))?;
                break Form::Certificate;
            }
            let named = |name: &str| Some(text.strip_prefix(&format!("# {name}: "))?.strip_suffix('\n')?.to_owned());
            if let Some((name, slot, text)) = [(TABLE, &mut table), (SHARD, &mut shard)]
                .into_iter()
                .find_map(|(name, slot)| Some((name, slot, named(name)?)))
            {
                if slot.replace(text).is_some() {
                    return Err(fault(path, &format!("its head is damaged: two lines begin with `# {name}:`")));
                }
            } else {
                head.push_str(&text);
                if !text.starts_with('#') {
                    break Form::Csv;
                }
            }
        };
        let (Some(table), Some(shard)) = (table, shard) else { return Err(fault(path, NO_SHARD)) };
        let binding = Binding { table, shard };
        let (plan, shard) = binding.read().map_err(|what| fault(path, &format!("its head is damaged: {what}")))?;
        Ok(Part { path, shard, plan, binding, head, length, form })
    }

    /// Copies the rows, each of which must be the one that belongs there.
    fn copy(&self, out: &mut dyn Write) -> Result<(), Stop> {
        let failed = |e: io::Error| Stop::Part(cannot_read(self.path, &e));
        let mut reader = BufReader::with_capacity(1 << 16, File::open(self.path).map_err(failed)?);
        io::copy(&mut reader.by_ref().take(self.length), &mut io::sink()).map_err(failed)?;
        let rows = Rows::new(&self.plan, self.form, &self.head);
        let mut line = Vec::new();
        for row in self.shard.rows(self.plan.rows()) {
            line.clear();
            reader.read_until(b'\n', &mut line).map_err(failed)?;
            if !rows.has(row, &line) {
                let whole = line.ends_with(b"\n");
                let found = match (line.is_empty(), whole) {
                    (true, _) => "the file ends before this row".to_owned(),
                    (_, false) => "the file ends inside this row".to_owned(),
                    _ => format!("the line is {}", visible(String::from_utf8_lossy(&line).trim_end())),
                };
                let what = format!("row {} of the table, {}, is missing: {found}", row + 1, self.plan.in_words(row));
                return Err(Stop::Part(fault(self.path, &what)));
            }
            out.write_all(&line).map_err(Stop::Write)?;
        }
        line.clear();
        reader.read_until(b'\n', &mut line).map_err(failed)?;
        if line.is_empty() {
            return Ok(());
        }
        let what =
            format!("unexpected line after the last row: {}", visible(String::from_utf8_lossy(&line).trim_end()));
        Err(Stop::Part(fault(self.path, &what)))
    }
}

const NO_SHARD: &str = "this is not a part of a table; `carom table --shard I/N` writes parts";

/// The head of the whole certificate, and what binds this part of it.
fn unbind(text: &str) -> Option<(String, Option<String>, Option<String>)> {
    let mut object: Map<String, Value> = serde_json::from_str(text).ok()?;
    let binding = object.shift_remove(SHARD)?;
    let entry = |name: &str| binding.get(name)?.as_str().map(str::to_owned);
    Some((format!("{}\n", Value::Object(object)), entry(TABLE), entry(SHARD)))
}

/// All are parts of one table, and each part is there once.
fn agree(parts: &[Part<'_>]) -> Result<(), Exit> {
    let Some(first) = parts.first() else { return Err(Exit::usage("error: --merge needs files")) };
    let of = first.shard.of();
    for part in parts {
        let other =
            |what: &str| Exit::usage(format!("error: {} and {} are {what}", first.path.display(), part.path.display()));
        if part.form != first.form {
            return Err(other(&format!("{} and {}: merge them separately", first.form.name(), part.form.name())));
        }
        if part.binding.table != first.binding.table {
            let (a, b) = (&first.binding.table, &part.binding.table);
            return Err(other(&format!("parts of different tables\n  {a}\n  {b}")));
        }
        if part.head != first.head {
            return Err(other("parts of different tables: digits, rounding or version differ"));
        }
        if part.shard.of() != of {
            return Err(other(&format!("from different partitions: {} and {}", first.shard, part.shard)));
        }
    }
    for pair in parts.windows(2) {
        if let [a, b] = pair
            && a.shard == b.shard
        {
            let (here, there) = (a.path.display(), b.path.display());
            return Err(Exit::usage(format!("error: part {} is given twice: {here} and {there}", a.shard)));
        }
    }
    // Now the parts differ, and are sorted: the first gap is where the number is not the place.
    let gap = (1..).zip(parts).find(|(place, part)| part.shard.part() != *place).map(|(place, _)| place);
    match gap.or(((parts.len() as u64) < of).then_some(parts.len() as u64 + 1)) {
        Some(missing) => {
            Err(Exit::usage(format!("error: part {missing}/{of} is missing ({} of {of} are given)", parts.len())))
        }
        None => Ok(()),
    }
}

/// Why the work stopped.
enum Stop {
    Write(io::Error),
    Part(Exit),
}

fn copy(parts: &[Part<'_>], out: &mut dyn Write) -> Result<(), Stop> {
    let head = parts.first().map_or("", |part| part.head.as_str());
    out.write_all(head.as_bytes()).map_err(Stop::Write)?;
    for part in parts {
        part.copy(out)?;
    }
    out.flush().map_err(Stop::Write)
}
