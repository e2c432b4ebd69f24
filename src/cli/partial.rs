//! A file that grows by whole lines and takes its place when it is complete.
//!
//! Contract: lines are written to `FILE.partial`, which is renamed to `FILE` at the end; until then `FILE` stays
//! as it was. A run that ends early leaves `FILE.partial` with whole lines, to which a later one can add. A
//! line that was cut off (by a crash, not by Ctrl-C) is dropped then.

use super::Exit;
use super::output::Output;
use std::fs::{File, OpenOptions};
use std::io::{self, BufRead, BufReader, BufWriter, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// A file in the making.
pub(super) struct Partial {
    target: PathBuf,
    path: PathBuf,
    file: BufWriter<File>,
}

/// The name under which a file grows.
pub(super) fn name(target: &Path) -> PathBuf {
    let mut name = target.as_os_str().to_owned();
    name.push(".partial");
    PathBuf::from(name)
}

fn cannot(path: &Path, e: &io::Error) -> Exit {
    Exit::usage(format!("error: cannot write {}: {e}", path.display()))
}

/// The longest line that is read back.
const MAX_LINE: u64 = 1 << 26;

/// Opens a file and locks it.
///
/// Between the one and the other, another run may have put the file in its place, or removed it. What is locked is then no
/// longer what the path names, and the work begins anew with what it names now.
fn locked(path: &Path, mut open: impl FnMut(&Path) -> io::Result<File>) -> Result<File, Exit> {
    loop {
        let file = open(path).map_err(|e| cannot(path, &e))?;
        if file.try_lock().is_err() {
            return Err(Exit::usage(format!("error: another run is writing {}", path.display())));
        }
        if is_at(&file, path) {
            return Ok(file);
        }
    }
}

/// Whether a path names an open file. Where files have no numbers, they cannot be moved while they are open.
fn is_at(file: &File, path: &Path) -> bool {
    #[cfg(unix)]
    {
        use std::os::unix::fs::MetadataExt;
        let number = |m: std::fs::Metadata| (m.dev(), m.ino());
        let (here, there) = (file.metadata().map(number), std::fs::metadata(path).map(number));
        matches!((here, there), (Ok(here), Ok(there)) if here == there)
    }
    #[cfg(not(unix))]
    {
        let _ = (file, path);
        true
    }
}

impl Partial {
    /// Opens the growing file, with what an earlier run left in it.
    pub(super) fn open(target: &Path) -> Result<Partial, Exit> {
        let path = name(target);
        let file =
            locked(&path, |path| OpenOptions::new().read(true).write(true).create(true).truncate(false).open(path))?;
        let file = BufWriter::with_capacity(1 << 16, file);
        Ok(Partial { target: target.to_path_buf(), path, file })
    }

    /// Refuses to begin anew over what an earlier run left, which may be the work of hours.
    ///
    /// # Errors
    /// The file is not empty.
    pub(super) fn refuse_rows(&self) -> Result<(), Exit> {
        let length = self.file.get_ref().metadata().map_err(|e| cannot(&self.path, &e))?.len();
        if length == 0 {
            return Ok(());
        }
        let path = self.path.display();
        Err(Exit::usage(format!(
            "error: {path} holds the rows of a run that was interrupted; continue it with --resume, or remove it to start again"
        )))
    }

    /// How many whole lines stand below the head; `fits` is asked of each, by its number from 0.
    ///
    /// # Errors
    /// It was begun with another head, or holds a line that does not fit: another table, another rounding, another
    /// version, or lines that were changed since.
    pub(super) fn lines(&mut self, head: &str, fits: impl Fn(u64, &[u8]) -> bool) -> Result<u64, Exit> {
        let Partial { path, file, .. } = self;
        let fail = |e: io::Error| Exit::usage(format!("error: cannot read {}: {e}", path.display()));
        let other = |what: String| {
            let path = path.display();
            let message = format!(
                "error: {path} was written with other settings{what}; to start again, remove it and leave out --resume"
            );
            Exit::usage(message)
        };
        let file = file.get_mut();
        file.seek(SeekFrom::Start(0)).map_err(fail)?;
        let mut reader = BufReader::with_capacity(1 << 16, file);
        let mut line = Vec::new();
        reader.by_ref().take(head.len() as u64).read_to_end(&mut line).map_err(fail)?;
        if line.len() < head.len() && head.as_bytes().starts_with(&line) {
            return Ok(0);
        }
        if line != head.as_bytes() {
            return Err(other(String::new()));
        }
        let mut lines = 0;
        loop {
            line.clear();
            reader.by_ref().take(MAX_LINE).read_until(b'\n', &mut line).map_err(fail)?;
            // What was cut off in the middle of a line is dropped.
            if !line.ends_with(b"\n") && (line.len() as u64) < MAX_LINE {
                return Ok(lines);
            }
            if !fits(lines, &line) {
                return Err(other(format!(
                    ", or changed: line {} below its head is not a row of this table",
                    lines + 1
                )));
            }
            lines += 1;
        }
    }

    /// Keeps the head and so many lines, and nothing if there are none, and goes on after them.
    pub(super) fn keep(&mut self, head: &str, lines: u64) -> Result<(), Exit> {
        let Partial { path, file, .. } = self;
        let fail = |e: io::Error| cannot(path, &e);
        let from = head.len() as u64;
        let file = file.get_mut();
        let end = if lines == 0 { 0 } else { from + length(file, from, lines).map_err(fail)? };
        file.set_len(end).map_err(fail)?;
        file.seek(SeekFrom::Start(end)).map_err(fail)?;
        Ok(())
    }

    /// Leaves the lines where they are, for a later run.
    pub(super) fn leave(mut self) -> Result<PathBuf, Exit> {
        self.file.flush().map_err(|e| cannot(&self.path, &e))?;
        Ok(self.path)
    }

    /// Puts the file in its place.
    pub(super) fn finish(mut self) -> Result<(), Exit> {
        self.file.flush().map_err(|e| cannot(&self.path, &e))?;
        if let Ok(old) = std::fs::metadata(&self.target) {
            self.file.get_ref().set_permissions(old.permissions()).map_err(|e| cannot(&self.path, &e))?;
        }
        std::fs::rename(&self.path, &self.target).map_err(|e| cannot(&self.target, &e))
    }
}

impl Write for Partial {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

/// The bytes of the first whole lines after an offset, so many at most.
fn length(file: &mut File, from: u64, lines: u64) -> io::Result<u64> {
    file.seek(SeekFrom::Start(from))?;
    let mut reader = BufReader::new(file);
    let mut total = 0;
    for _ in 0..lines {
        let read = reader.skip_until(b'\n')?;
        total += read as u64;
        if read == 0 {
            break;
        }
    }
    Ok(total)
}

/// Whether a path can grow beside itself: it is new, or a regular file.
pub(crate) fn can_grow(path: &Path) -> bool {
    std::fs::symlink_metadata(path).map_or(true, |m| m.is_file())
}

/// A file that grows, or one that is written as a whole.
pub(super) enum Target {
    /// Whole lines stay when the work ends early.
    Grows(Partial),
    /// Nothing stays when the work ends early.
    Whole(BufWriter<Output>),
}

impl Target {
    /// Puts the file in its place.
    pub(super) fn finish(self) -> Result<(), Exit> {
        match self {
            Target::Grows(partial) => partial.finish(),
            Target::Whole(output) => {
                let output = output.into_inner().map_err(|e| Exit::usage(format!("error: cannot write: {e}")))?;
                output.finish()
            }
        }
    }
}

impl Write for Target {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            Target::Grows(partial) => partial.write(bytes),
            Target::Whole(output) => output.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self {
            Target::Grows(partial) => partial.flush(),
            Target::Whole(output) => output.flush(),
        }
    }
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    #[test]
    fn what_another_run_puts_in_its_place_before_it_is_locked_is_left_alone() {
        let folder = tempfile::tempdir().expect("a folder");
        let (path, done) = (folder.path().join("t.csv.partial"), folder.path().join("t.csv"));
        std::fs::write(&path, "whole\n").expect("written");
        let mut opened = 0;
        let file = locked(&path, |path| {
            opened += 1;
            let file = OpenOptions::new().read(true).write(true).create(true).truncate(false).open(path);
            if opened == 1 {
                std::fs::rename(path, &done)?;
            }
            file
        });
        let file = file.map_err(|e| e.message).expect("the second one is locked");
        file.set_len(0).expect("it is open");
        assert_eq!((opened, std::fs::read_to_string(&done).expect("there").as_str()), (2, "whole\n"));
        assert!(is_at(&file, &path) && !is_at(&file, &done));
    }
}
