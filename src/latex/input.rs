//! A paper's text: in Markdown, or in several files, since `\input` and `\include` are followed as LaTeX follows them.
//!
//! Contract: the text of a file stands where the command that names it stood, and every place is one in its own file. A file
//! that is not read leaves the command where it is, with the reason: what it holds may be a hypothesis.
//! Limits: [`DEPTH_LIMIT`], [`INPUTS_LIMIT`], and [`FILE_LIMIT`] for all of them together.

use super::markdown::latex_of;
use super::refusal::refused;
use super::token::{FILE_LIMIT, Kind, Token, tokens};
use carom_diagnostic::{Diagnostic, Fault, Source, Span};
use std::io::Read;
use std::path::{Path, PathBuf};

/// How deep files may stand in one another.
pub const DEPTH_LIMIT: usize = 16;
/// How often a paper may call for a file.
pub const INPUTS_LIMIT: usize = 1000;

/// A paper's whole text.
#[derive(Debug)]
pub struct Manuscript {
    /// The text, and the files from which it comes.
    pub source: Source,
    /// Where that is Markdown: the LaTeX in it, at the same places.
    latex: Option<String>,
    /// Why a command in it was not followed, each at its place in the text.
    pub(crate) unread: Vec<Diagnostic>,
}

impl Manuscript {
    /// A text in LaTeX that is no file; it calls for none.
    #[must_use]
    pub fn alone(text: &str) -> Manuscript {
        Manuscript { source: Source::new("text".to_string(), text.to_string()), latex: None, unread: Vec::new() }
    }

    /// The LaTeX, at the places of the source.
    pub(crate) fn latex(&self) -> &str {
        self.latex.as_deref().unwrap_or(self.source.text())
    }
}

/// Endings of the names of papers in LaTeX.
const LATEX: [&str; 2] = ["tex", "ltx"];
/// Endings of the names of papers in Markdown.
const MARKDOWN: [&str; 2] = ["md", "markdown"];

/// Whether a path is that of a paper.
#[must_use]
pub fn is_paper(path: &Path) -> bool {
    path.extension().is_some_and(|end| LATEX.iter().chain(&MARKDOWN).any(|known| end == *known))
}

/// The text of a paper at `path`; in LaTeX with the files that it calls for, which lie beside it or in folders there.
#[must_use]
pub fn manuscript(path: &Path, text: String) -> Manuscript {
    if path.extension().is_some_and(|end| MARKDOWN.iter().any(|known| end == *known)) {
        let latex = Some(latex_of(&text));
        return Manuscript { source: Source::new(path.display().to_string(), text), latex, unread: Vec::new() };
    }
    let beside = path.parent().map(Path::to_path_buf).unwrap_or_default();
    let folder = whole_path(if beside.as_os_str().is_empty() { Path::new(".") } else { &beside });
    let source = Source::open(path.display().to_string(), text.clone());
    let mut joiner = Joiner { beside, folder, source, unread: Vec::new(), inputs: 0, open: vec![whole_path(path)] };
    joiner.add(0, &text);
    Manuscript { source: joiner.source, latex: None, unread: joiner.unread }
}

struct Joiner {
    /// The paper's folder, as it was given.
    beside: PathBuf,
    /// The same, by which it is known again.
    folder: PathBuf,
    source: Source,
    unread: Vec<Diagnostic>,
    inputs: usize,
    /// The files that are being read, each inside the one before.
    open: Vec<PathBuf>,
}

impl Joiner {
    /// Adds a file of this number and text to the text.
    fn add(&mut self, file: usize, text: &str) {
        // A text with a fault of its own is added as it is; the reader reports the fault.
        let list = if calls(text) { tokens(text).unwrap_or_default() } else { Vec::new() };
        let mut done = 0;
        let mut text_end = text.len();
        for at in 0..list.len() {
            // What stands behind is not read.
            if list[at].is("endinput") {
                text_end = list[at].span.start;
                break;
            }
            let Some((name, end)) = called(&list, at, text) else { continue };
            let start = list[at].span.start;
            self.source.put(file, done, start);
            done = end;
            match self.read(&name) {
                Ok((path, inner)) => {
                    self.open.push(whole_path(&path));
                    let number = self.source.file(path.display().to_string(), inner.clone());
                    self.add(number, &inner);
                    self.open.pop();
                }
                Err(why) => {
                    let here = self.source.text().len();
                    self.unread.push(why.at(&name, Span { start: here, end: here + end - start }));
                    self.source.put(file, start, end);
                }
            }
        }
        self.source.put(file, done, text_end.max(done));
    }

    /// The path and the text, which ends with a line, of the file that a command names: the name with `.tex`, else the name
    /// as it is.
    fn read(&mut self, name: &str) -> Result<(PathBuf, String), Unread> {
        self.inputs += 1;
        if self.open.len() > DEPTH_LIMIT {
            return Err(Unread::Limit("files that stand in one another", DEPTH_LIMIT));
        }
        if self.inputs > INPUTS_LIMIT {
            return Err(Unread::Limit("commands that call for a file", INPUTS_LIMIT));
        }
        let paths = [format!("{name}.tex"), name.to_string()].map(|name| self.beside.join(name));
        let path = paths.into_iter().find(|path| path.exists()).ok_or(Unread::Missing)?;
        // A paper from elsewhere must not show what else lies on this machine.
        if !whole_path(&path).starts_with(&self.folder) {
            return Err(Unread::Other("it lies outside of the paper's folder".to_string()));
        }
        if self.open.contains(&whole_path(&path)) {
            return Err(Unread::Other("it would stand in itself".to_string()));
        }
        // A pipe or a device could be read for ever.
        if !path.is_file() {
            return Err(Unread::Other("it is no file of text".to_string()));
        }
        let room = FILE_LIMIT.saturating_sub(self.source.text().len());
        let mut bytes = Vec::new();
        let read = std::fs::File::open(&path).and_then(|file| file.take(room as u64 + 1).read_to_end(&mut bytes));
        read.map_err(|fault| Unread::Other(fault.to_string()))?;
        if bytes.len() >= room {
            return Err(Unread::Limit("bytes in a paper with the files that it calls for", FILE_LIMIT));
        }
        let mut text = String::from_utf8(bytes).map_err(|_| Unread::Other("it is not UTF-8 text".to_string()))?;
        if !text.ends_with('\n') {
            text.push('\n');
        }
        Ok((path, text))
    }
}

/// A path by which a file is known again.
fn whole_path(path: &Path) -> PathBuf {
    std::fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf())
}

/// Why a file was not read.
enum Unread {
    Limit(&'static str, usize),
    Missing,
    Other(String),
}

impl Unread {
    fn at(self, name: &str, span: Span) -> Diagnostic {
        let (message, help) = match self {
            Unread::Limit(name, allowed) => return Diagnostic::new(Fault::Limit { name, allowed }, span),
            Unread::Missing => (
                format!("there is no file {name}.tex or {name} beside the paper"),
                "put it there, or remove the command if the file says nothing that equations need",
            ),
            Unread::Other(why) => (
                format!("{name} was not read: {why}"),
                "put what equations need of it into a file beside the paper, or here",
            ),
        };
        refused(message, help, span)
    }
}

/// Whether a text may call for files.
fn calls(text: &str) -> bool {
    ["\\input", "\\include", "\\endinput"].iter().any(|command| text.contains(command))
}

/// The file that a command at this token calls for, and where the command ends in the text.
fn called(list: &[Token], at: usize, text: &str) -> Option<(String, usize)> {
    let is_input = list[at].is("input");
    if !is_input && !list[at].is("include") {
        return None;
    }
    let open = list.get(at + 1)?;
    if open.kind == Kind::Open {
        let close = list[at + 1..].iter().find(|token| token.kind == Kind::Close)?;
        let name = text.get(open.span.end..close.span.start)?.trim();
        return (!name.is_empty() && !name.contains('\\')).then(|| (name.to_string(), close.span.end));
    }
    // The older form, without braces, ends with a space.
    let rest = text.get(open.span.start..).filter(|_| is_input && open.apart)?;
    let name: String = rest.chars().take_while(|c| !c.is_whitespace() && !"\\{}%".contains(*c)).collect();
    (!name.is_empty()).then(|| (name.clone(), open.span.start + name.len()))
}
