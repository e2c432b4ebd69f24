//! A text that was read, and the files that its stretches come from.

use crate::{Diagnostic, Span};

/// The text of a file, in which other files may stand in the place of the commands that name them.
#[derive(Clone, Debug)]
pub struct Source {
    text: String,
    /// Paths and texts of the files, the first of which holds the others.
    files: Vec<(String, String)>,
    /// In the order of the text; the first begins at 0.
    stretches: Vec<Stretch>,
}

/// A part of the text, up to the next one.
#[derive(Clone, Copy, Debug)]
struct Stretch {
    /// Its first byte in the text.
    start: usize,
    /// The number of its file.
    file: usize,
    /// Its first byte there.
    offset: usize,
}

impl Source {
    /// The text of one file.
    #[must_use]
    pub fn new(path: String, text: String) -> Source {
        let stretches = vec![Stretch { start: 0, file: 0, offset: 0 }];
        Source { files: vec![(path, text.clone())], text, stretches }
    }

    /// A file into which others will be put: its text is still empty.
    #[must_use]
    pub fn open(path: String, text: String) -> Source {
        Source { text: String::new(), files: vec![(path, text)], stretches: Vec::new() }
    }

    /// Adds a file, and returns its number. Its text is put where it stands by [`Source::put`].
    pub fn file(&mut self, path: String, text: String) -> usize {
        self.files.push((path, text));
        self.files.len() - 1
    }

    /// Adds the bytes `from..to` of a file to the text; what is no such range of it adds nothing.
    pub fn put(&mut self, file: usize, from: usize, to: usize) {
        let Some(part) = self.files.get(file).and_then(|known| known.1.get(from..to)) else { return };
        if !part.is_empty() || self.stretches.is_empty() {
            self.stretches.push(Stretch { start: self.text.len(), file, offset: from });
            self.text.push_str(part);
        }
    }

    /// The path of the file that holds the others.
    #[must_use]
    pub fn path(&self) -> &str {
        self.files.first().map_or("", |file| &file.0)
    }

    /// The whole text.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The path and the text of the file in which a range of the text begins, and its range there, which ends with its
    /// stretch.
    fn found(&self, span: Span) -> (&str, &str, Span) {
        let next = self.stretches.partition_point(|stretch| stretch.start <= span.start);
        let known = self.stretches.get(next.saturating_sub(1));
        let Some((stretch, (path, text))) = known.and_then(|s| Some((s, self.files.get(s.file)?))) else {
            return ("", &self.text, span);
        };
        let until = self.stretches.get(next).map_or(usize::MAX, |stretch| stretch.start);
        let there = |at: usize| at - stretch.start + stretch.offset;
        (path, text, Span { start: there(span.start), end: there(span.end.min(until).max(span.start)) })
    }

    /// The file, the line and the column at which a range of the text begins.
    #[must_use]
    pub fn place(&self, span: Span) -> (&str, usize, usize) {
        let (path, text, span) = self.found(span);
        let (line, column) = crate::place(span, text);
        (path, line, column)
    }

    /// The line at which a range of the text begins, in words, with its file unless that is the one that holds the others.
    #[must_use]
    pub fn line(&self, span: Span) -> String {
        match self.place(span) {
            (path, line, _) if path == self.path() => format!("line {line}"),
            (path, line, _) => format!("{path} line {line}"),
        }
    }

    /// The full message of a fault in the text, at its place in its file.
    #[must_use]
    pub fn render(&self, fault: &Diagnostic, colour: bool) -> String {
        let (path, text, span) = self.found(fault.span);
        Diagnostic { span, ..fault.clone() }.render(path, text, colour)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn joined() -> Source {
        let mut out = Source::open("a.tex".into(), "one\n\\input{b}\ntwo\n".into());
        out.put(0, 0, 4);
        let inner = out.file("b.tex".into(), "inner\nlast\n".into());
        out.put(inner, 0, 11);
        out.put(0, 13, 18);
        out
    }

    #[test]
    fn places_are_those_of_the_files() {
        let source = joined();
        assert_eq!(source.text(), "one\ninner\nlast\n\ntwo\n");
        let place = |word: &str| {
            let start = source.text().find(word).expect("the word");
            source.place(Span { start, end: start + 1 })
        };
        assert_eq!(place("one"), ("a.tex", 1, 1));
        assert_eq!(place("inner"), ("b.tex", 1, 1));
        assert_eq!(place("last"), ("b.tex", 2, 1));
        assert_eq!(place("two"), ("a.tex", 3, 1));
    }

    #[test]
    fn a_range_ends_with_its_file() {
        let source = joined();
        let (path, text, span) = source.found(Span { start: 11, end: 19 });
        assert_eq!((path, &text[span.start..span.end]), ("b.tex", "ast\n"));
    }
}
