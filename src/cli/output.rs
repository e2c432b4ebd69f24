//! Where a command's text goes: standard output or a file, as a whole or not at all.
//!
//! Contract: a regular file is replaced in one step, by a file with the old permissions (a new one
//! gets what the process's mask allows), so that a reader sees the old text or the new one. A symbolic
//! link stays and its target is replaced. What is no regular file, such as `/dev/null` or a pipe, is
//! written in place.

use super::Exit;
use crate::report::visible_lines;
use std::fs::{File, Metadata, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// The most symbolic links that are followed from one name.
const LINKS: usize = 40;

/// An open place for output.
pub(super) enum Output {
    /// Written as it comes.
    InPlace(PathBuf, File),
    /// Written beside the target, which it replaces at the end.
    Whole(PathBuf, tempfile::NamedTempFile),
}

fn cannot(path: &Path, e: io::Error) -> Exit {
    Exit::usage(format!("error: cannot write {}: {e}", path.display()))
}

impl Output {
    /// Opens a file for writing; nothing of it changes before [`Output::finish`] unless it is no
    /// regular file.
    ///
    /// # Errors
    /// A folder, a file or folder without permission to write, symbolic links in a circle.
    pub(super) fn file(path: &Path) -> Result<Output, Exit> {
        let target = followed(path)?;
        let old = std::fs::metadata(&target).ok();
        if let Some(old) = &old {
            // Replacing asks no permission of the file itself; opening it does.
            let file = OpenOptions::new().write(true).open(&target).map_err(|e| cannot(path, e))?;
            if !old.is_file() {
                return Ok(Output::InPlace(path.to_path_buf(), file));
            }
        }
        let folder = target.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
        // The error of a temporary file would name it.
        std::fs::metadata(folder).map_err(|e| cannot(path, e))?;
        let file = beside(folder, old.as_ref()).map_err(|e| cannot(path, e))?;
        Ok(Output::Whole(target, file))
    }

    /// Puts the text in its place.
    pub(super) fn finish(self) -> Result<(), Exit> {
        match self {
            Output::InPlace(path, mut file) => file.flush().map_err(|e| cannot(&path, e)),
            Output::Whole(path, file) => match file.persist(&path) {
                Ok(_) => Ok(()),
                Err(e) => Err(cannot(&path, e.error)),
            },
        }
    }
}

impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            Output::InPlace(_, file) => file.write(bytes),
            Output::Whole(_, file) => file.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self {
            Output::InPlace(_, file) => file.flush(),
            Output::Whole(_, file) => file.flush(),
        }
    }
}

/// A new file in a folder, with the permissions of the one that it will replace.
fn beside(folder: &Path, old: Option<&Metadata>) -> io::Result<tempfile::NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let file = builder.tempfile_in(folder)?;
    if let Some(old) = old {
        file.as_file().set_permissions(old.permissions())?;
    }
    Ok(file)
}

/// The name at the end of a chain of symbolic links; it need not exist.
fn followed(path: &Path) -> Result<PathBuf, Exit> {
    let mut at = path.to_path_buf();
    for _ in 0..LINKS {
        match std::fs::read_link(&at) {
            Ok(to) if to.is_absolute() => at = to,
            Ok(to) => at = at.parent().unwrap_or(Path::new("")).join(to),
            Err(_) => return Ok(at),
        }
    }
    Err(Exit::usage(format!("error: cannot write {}: its symbolic links form a circle", path.display())))
}

/// The file that a path leads to, which need not exist: one name for all its paths.
///
/// # Errors
/// Symbolic links in a circle.
pub(super) fn place(path: &Path) -> Result<PathBuf, Exit> {
    let target = followed(path)?;
    let folder = target.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
    // A folder that is not there is an error when the file is opened.
    let folder = std::fs::canonicalize(folder).unwrap_or_else(|_| folder.to_path_buf());
    Ok(folder.join(target.file_name().unwrap_or_default()))
}

/// Writes a text to the place that a flag names; without one, and for `-`, to standard output.
///
/// # Errors
/// Whatever keeps the text from being written.
pub(crate) fn deliver(output: Option<&Path>, text: &str) -> Result<(), Exit> {
    match super::form::place(output) {
        Some(path) => write_file(path, &anstream::adapter::strip_str(text).to_string()),
        None => print(text),
    }
}

/// Writes a file as a whole.
pub(crate) fn write_file(path: &Path, text: &str) -> Result<(), Exit> {
    write_bytes(path, text.as_bytes())
}

/// Writes a file as a whole.
pub(crate) fn write_bytes(path: &Path, bytes: &[u8]) -> Result<(), Exit> {
    let mut output = Output::file(path)?;
    output.write_all(bytes).map_err(|e| cannot(path, e))?;
    output.finish()
}

/// A message for the terminal: what it quotes of a file cannot steer it. Where errors have colours, these stay: `ESC [`,
/// the numbers of a colour or of bold letters, `m`.
pub(super) fn message(text: &str, colours: bool) -> String {
    let mut pieces = text.split('\u{1b}');
    let mut out = visible_lines(pieces.next().unwrap_or("")).into_owned();
    for piece in pieces {
        match piece.split_once('m').filter(|(style, _)| colours && is_colour(style)) {
            Some((style, rest)) => out += &format!("\u{1b}{style}m{}", visible_lines(rest)),
            None => out += &visible_lines(&format!("\u{1b}{piece}")),
        }
    }
    out
}

/// Whether these are the signs between `ESC` and `m` of a style that hides nothing.
fn is_colour(style: &str) -> bool {
    let Some(codes) = style.strip_prefix('[') else { return false };
    codes.is_empty() || matches!(codes.parse(), Ok(0 | 1 | 31..=37 | 90..=97)) || codes.starts_with("38;5;")
}

/// Writes to standard output; colours are dropped where they are not wanted.
///
/// # Errors
/// Whatever keeps the text from being written, but for a reader that has gone away.
pub(super) fn print(text: &str) -> Result<(), Exit> {
    let mut out = anstream::stdout();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(e) if e.kind() != io::ErrorKind::BrokenPipe => {
            Err(Exit::usage(format!("error: cannot write to standard output: {e}")))
        }
        _ => Ok(()),
    }
}
