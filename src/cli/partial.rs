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
pub struct Partial {
    target: PathBuf,
    path: PathBuf,
    file: BufWriter<File>,
}

/// The name under which a file grows.
pub fn name(target: &Path) -> PathBuf {
    let mut name = target.as_os_str().to_owned();
    name.push(".partial");
    PathBuf::from(name)
}

fn cannot(path: &Path, e: &io::Error) -> Exit {
    Exit::usage(format!("error: cannot write {}: {e}", path.display()))
}

impl Partial {
    /// Begins anew, with nothing.
    pub fn begin(target: &Path) -> Result<Partial, Exit> {
        Partial::open(target, |_| Ok(0))
    }

    /// Goes on after so many lines below the head.
    pub fn resume(target: &Path, head: &str, lines: u64) -> Result<Partial, Exit> {
        let from = head.len() as u64;
        Partial::open(target, |file| Ok(from + length(file, from, lines)?))
    }

    /// Opens the growing file and cuts it after as many bytes as are kept.
    fn open(target: &Path, kept: impl FnOnce(&mut File) -> io::Result<u64>) -> Result<Partial, Exit> {
        let path = name(target);
        let fail = |e: io::Error| cannot(&path, &e);
        let mut file =
            OpenOptions::new().read(true).write(true).create(true).truncate(false).open(&path).map_err(fail)?;
        if file.try_lock().is_err() {
            return Err(Exit::usage(format!("error: another run is writing {}", path.display())));
        }
        let end = kept(&mut file).map_err(fail)?;
        file.set_len(end).map_err(fail)?;
        file.seek(SeekFrom::Start(end)).map_err(fail)?;
        let file = BufWriter::with_capacity(1 << 16, file);
        Ok(Partial { target: target.to_path_buf(), path, file })
    }

    /// Leaves the lines where they are, for a later run.
    pub fn leave(mut self) -> Result<PathBuf, Exit> {
        self.file.flush().map_err(|e| cannot(&self.path, &e))?;
        Ok(self.path)
    }

    /// Puts the file in its place.
    pub fn finish(mut self) -> Result<(), Exit> {
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

/// How many whole lines stand below the head in what an earlier run left; `None` where there is nothing.
///
/// # Errors
/// It was begun with another head: another table, another rounding, another version.
pub fn lines(target: &Path, head: &str) -> Result<Option<u64>, Exit> {
    let path = name(target);
    let fail = |e: io::Error| Exit::usage(format!("error: cannot read {}: {e}", path.display()));
    let file = match File::open(&path) {
        Ok(file) => file,
        Err(e) if e.kind() == io::ErrorKind::NotFound => return Ok(None),
        Err(e) => return Err(fail(e)),
    };
    let mut reader = BufReader::new(file);
    let mut begun = Vec::new();
    reader.by_ref().take(head.len() as u64).read_to_end(&mut begun).map_err(fail)?;
    if begun.len() < head.len() && head.as_bytes().starts_with(&begun) {
        return Ok(None);
    }
    if begun != head.as_bytes() {
        let message = format!(
            "error: {} was begun with other settings; remove it, or leave out --resume to begin anew",
            path.display()
        );
        return Err(Exit::usage(message));
    }
    let mut lines = 0;
    loop {
        let buffer = reader.fill_buf().map_err(fail)?;
        if buffer.is_empty() {
            return Ok(Some(lines));
        }
        lines += buffer.iter().filter(|b| **b == b'\n').count() as u64;
        let length = buffer.len();
        reader.consume(length);
    }
}

/// Whether a path can grow beside itself: it is new, or a regular file.
pub fn can_grow(path: &Path) -> bool {
    std::fs::symlink_metadata(path).map_or(true, |m| m.is_file())
}

/// A file that grows, or one that is written as a whole.
pub enum Target {
    /// Whole lines stay when the work ends early.
    Grows(Partial),
    /// Nothing stays when the work ends early.
    Whole(BufWriter<Output>),
}

impl Target {
    /// Puts the file in its place.
    pub fn finish(self) -> Result<(), Exit> {
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
