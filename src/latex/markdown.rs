//! A Markdown file as LaTeX: its displayed formulas and its comments, at the same places.
//!
//! Contract: the result has as many bytes as the source, and each formula and comment stands where it stands there. Formulas
//! are `$$ … $$`, environments such as `\begin{align}`, and code blocks with the word `math`, in block quotes and lists as well; a comment is `<!-- carom … -->`. A
//! comment of several lines is one line, whose parts [`NEXT_LINE`] separates. Other code and other comments are passed over.
//! Formulas in running text are kept on lines with `<!-- carom inline`.

use super::document::DISPLAYS;
use super::token::NEXT_LINE;
use std::collections::BTreeMap;

/// The LaTeX in a Markdown file; everything else is spaces.
#[must_use]
pub fn latex_of(source: &str) -> String {
    let out = source.bytes().map(|b| if b == b'\n' { b'\n' } else { b' ' }).collect();
    let mut page = Page {
        source,
        out,
        inside: Inside::Text,
        lists: Vec::new(),
        is_blank: true,
        paragraph: 0,
        last: BTreeMap::new(),
        quotes: 0,
    };
    let mut at = 0;
    for line in source.split_inclusive('\n') {
        page.line(at, line);
        at += line.len();
    }
    // Only whole parts of the source were copied, so this is text.
    String::from_utf8(page.out).unwrap_or_default()
}

/// What a line begins in.
#[derive(Clone, Copy)]
enum Inside<'s> {
    Text,
    Formula,
    /// An environment of displayed formulas, up to its `\end{…}`.
    Environment(&'s str),
    /// A comment, and the byte at which its clause begins, if it is one.
    Comment(Option<usize>),
    /// Code up to a fence of this sign and length, and whether it is a formula.
    Fence(&'s str, bool),
    /// Code in running text, up to a byte of the source.
    Code(usize),
}

struct Page<'s> {
    source: &'s str,
    out: Vec<u8>,
    inside: Inside<'s>,
    /// Where the text of each list begins that is open.
    lists: Vec<usize>,
    /// Whether the line before was blank, or code by its indent.
    is_blank: bool,
    /// Where the paragraph ends in which code was looked for.
    paragraph: usize,
    /// Where the last signs of code of each number stand in it.
    last: BTreeMap<usize, usize>,
    /// The signs of quotation before the text in which a formula, a comment or a block of code began.
    quotes: usize,
}

impl<'s> Page<'s> {
    fn keep(&mut self, from: usize, text: &str) {
        if let Some(place) = self.out.get_mut(from..from + text.len()) {
            place.copy_from_slice(text.as_bytes());
        }
    }

    /// Reads a line that begins at a byte of the source.
    fn line(&mut self, start: usize, line: &'s str) {
        let most = if matches!(self.inside, Inside::Text) { usize::MAX } else { self.quotes };
        let (quotes, quoted) = quotation(line, most);
        if quotes < self.quotes && matches!(self.inside, Inside::Fence(..)) {
            self.inside = Inside::Text;
        }
        self.is_blank |= quotes > self.quotes;
        self.quotes = quotes;
        let (start, line) = (start + quoted, &line[quoted..]);
        let trimmed = line.trim();
        let indent = columns(line);
        if let Inside::Fence(mark, is_math) = self.inside {
            if trimmed.starts_with(mark) && trimmed.trim_start_matches(&mark[..1]).is_empty() {
                (self.inside, self.is_blank) = (Inside::Text, true);
                if is_math {
                    self.keep(start + line.len() - line.trim_start().len(), "$$");
                }
            } else if is_math {
                self.keep(start, line);
            }
            return;
        }
        if matches!(self.inside, Inside::Text) {
            if trimmed.is_empty() {
                self.is_blank = true;
                return;
            }
            let before = self.is_blank;
            while before && self.lists.last().is_some_and(|text| indent < *text) {
                self.lists.pop();
            }
            let base = self.lists.last().copied().unwrap_or(0);
            // Code by its indent follows a blank line, and code.
            if before && indent >= base + 4 {
                return;
            }
            self.is_blank = trimmed.starts_with('#') || (trimmed.starts_with("<!--") && trimmed.ends_with("-->"));
            if let Some(text) = item(trimmed) {
                self.lists.retain(|outer| *outer <= indent);
                self.lists.push(indent + text);
            }
            let mark = trimmed.len() - trimmed.trim_start_matches(['`', '~']).len();
            let is_fence = mark >= 3 && trimmed[..mark].chars().all(|c| trimmed.starts_with(c));
            if is_fence && !(trimmed.starts_with('`') && trimmed[mark..].contains('`')) {
                let is_math = trimmed[mark..].trim() == "math";
                self.inside = Inside::Fence(&trimmed[..mark], is_math);
                if is_math {
                    self.keep(start + line.len() - line.trim_start().len(), "$$");
                }
                return;
            }
            // What LaTeX would read as a comment is none here, but it is meant as one.
            if trimmed.starts_with("%carom") {
                return self.keep(start, line);
            }
        }
        self.text(start, line);
    }

    /// Reads the text of a line.
    fn text(&mut self, start: usize, line: &'s str) {
        let mut at = 0;
        let has_inline = line.contains("carom inline");
        while at < line.len() {
            let rest = &line[at..];
            match self.inside {
                Inside::Formula => {
                    let end = rest.find("$$").map(|end| end + 2);
                    self.keep(start + at, &rest[..end.unwrap_or(rest.len())]);
                    at = end.map_or(line.len(), |end| at + end);
                    self.inside = if end.is_some() { Inside::Text } else { Inside::Formula };
                }
                Inside::Environment(name) => {
                    let end = end_of(rest, name);
                    self.keep(start + at, &rest[..end.unwrap_or(rest.len())]);
                    at = end.map_or(line.len(), |end| at + end);
                    self.inside = if end.is_some() { Inside::Text } else { Inside::Environment(name) };
                }
                Inside::Comment(clause) => {
                    let end = rest.find("-->");
                    if let Some(from) = clause.filter(|from| *from < start + line.len()) {
                        let said = rest[..end.unwrap_or(rest.len())].trim_end();
                        if let Some(before) = self.source[..start].rfind('\n').filter(|before| from < *before) {
                            self.keep(before, NEXT_LINE);
                        }
                        let skipped = from.saturating_sub(start + at).min(said.len());
                        self.keep(start + at + skipped, &said[skipped..]);
                        // The comment ends here; what follows it on the line is text.
                        end.into_iter().for_each(|end| self.keep(start + at + end, "\n"));
                    }
                    at = end.map_or(line.len(), |end| at + end + 3);
                    self.inside = if end.is_some() { Inside::Text } else { Inside::Comment(clause) };
                }
                Inside::Code(end) => {
                    at = end.saturating_sub(start).clamp(at, line.len());
                    if start + at >= end {
                        self.inside = Inside::Text;
                    }
                }
                Inside::Text | Inside::Fence(..) => {
                    let Some(place) = rest.find(['$', '<', '`', '\\']) else { return };
                    at += place;
                    if let Some(name) = begun(&line[at..]) {
                        self.inside = Inside::Environment(name);
                        continue;
                    }
                    let signs = ["$$", "<!--", "`", if has_inline { "$" } else { "$$" }];
                    let mark = signs.into_iter().find(|mark| line[at..].starts_with(mark));
                    at += mark.map_or(1, |mark| self.mark(start + at, &line[at..], mark));
                }
            }
        }
    }

    /// Reads what begins with a sign at a byte of the source, and returns the length that is read.
    fn mark(&mut self, at: usize, rest: &'s str, mark: &str) -> usize {
        match mark {
            "$$" => {
                self.keep(at, "$$");
                self.inside = Inside::Formula;
                2
            }
            "$" => {
                let end = rest[1..].find('$').map_or(1, |end| end + 2);
                self.keep(at, &rest[..end]);
                end
            }
            "`" => {
                let length = rest.len() - rest.trim_start_matches('`').len();
                // Looked for once, or many signs would take for ever.
                if at >= self.paragraph {
                    let lines = self.source[at..].split_inclusive('\n');
                    let is_blank = |line: &str| line.trim_matches(['>', ' ', '\t', '\r', '\n']).is_empty();
                    self.paragraph = at + lines.take_while(|line| !is_blank(line)).map(str::len).sum::<usize>();
                    self.last = runs(self.source, at, self.paragraph).collect();
                }
                // Code ends with as many signs as it begins with, or it is none.
                if self.last.get(&length).is_some_and(|last| *last > at) {
                    let found = runs(self.source, at + length, self.paragraph).find(|run| run.0 == length);
                    self.inside = found.map_or(Inside::Text, |(length, at)| Inside::Code(at + length));
                }
                length
            }
            _ => {
                let said =
                    self.source[at + mark.len()..].trim_start_matches(|c: char| c.is_whitespace() || "-%".contains(c));
                let word = self.source.len() - said.len();
                let is_clause = said.starts_with("carom");
                if is_clause {
                    self.keep(word - 1, "%carom");
                }
                self.inside = Inside::Comment(is_clause.then_some(word + "carom".len()));
                mark.len()
            }
        }
    }
}

/// The environment of displayed formulas that `\begin{…}` begins here.
fn begun(text: &str) -> Option<&str> {
    let rest = text.strip_prefix("\\begin{")?;
    let name = &rest[..rest.find('}')?];
    let plain = name.strip_suffix('*').unwrap_or(name);
    (plain != "math" && DISPLAYS.contains(&plain)).then_some(name)
}

/// Where the `\end{…}` of an environment ends.
fn end_of(text: &str, name: &str) -> Option<usize> {
    let mut from = 0;
    while let Some(at) = text[from..].find("\\end{") {
        from += at + "\\end{".len();
        if text[from..].strip_prefix(name).is_some_and(|rest| rest.starts_with('}')) {
            return Some(from + name.len() + 1);
        }
    }
    None
}

/// The signs of code in a part of a text that stand side by side: how many, and where they begin.
fn runs(text: &str, from: usize, to: usize) -> impl Iterator<Item = (usize, usize)> {
    let mut at = from;
    std::iter::from_fn(move || {
        let begin = at + text[at..to].find('`')?;
        at = begin + text[begin..to].bytes().take_while(|b| *b == b'`').count();
        Some((at - begin, begin))
    })
}

/// How many signs of quotation, `most` of them, begin a line, and the bytes that they take.
fn quotation(line: &str, most: usize) -> (usize, usize) {
    let (mut count, mut at) = (0, 0);
    while count < most {
        let rest = line[at..].trim_start_matches(' ');
        let indent = line.len() - at - rest.len();
        if indent > 3 || !rest.starts_with('>') {
            break;
        }
        at += indent + 1;
        at += usize::from(line[at..].starts_with(' '));
        count += 1;
    }
    (count, at)
}

/// The columns before the text of a line.
fn columns(line: &str) -> usize {
    let blank = line.chars().take_while(|c| *c == ' ' || *c == '\t');
    blank.fold(0, |column, c| if c == '\t' { column / 4 * 4 + 4 } else { column + 1 })
}

/// How far behind its sign the text of a list begins, if the line is an item.
fn item(trimmed: &str) -> Option<usize> {
    let digits = trimmed.len() - trimmed.trim_start_matches(|c: char| c.is_ascii_digit()).len();
    let rest = &trimmed[digits..];
    let is_sign = if digits > 0 { rest.starts_with(['.', ')']) } else { rest.starts_with(['-', '*', '+']) };
    let spaces = rest.get(1..).filter(|_| is_sign).map(|rest| rest.len() - rest.trim_start_matches(' ').len())?;
    (spaces > 0 || rest.len() == 1).then_some(digits + 1 + if (1..5).contains(&spaces) { spaces } else { 1 })
}
