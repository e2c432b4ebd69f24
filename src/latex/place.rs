//! A text made from parts of another text, with the place of each part.
//!
//! Contract: [`Placed::place`] gives a range of the made text the smallest range of the source that holds the places of all its
//! parts.

use carom_diagnostic::Span;

/// A text whose parts know where they come from.
#[derive(Clone, Debug, Default)]
pub(crate) struct Placed {
    text: String,
    /// Where a part begins in the text, and its place in the source; in order.
    marks: Vec<(usize, Span)>,
}

impl Placed {
    /// A text with one place.
    pub(crate) fn new(text: &str, span: Span) -> Placed {
        let mut out = Placed::default();
        out.push(text, span);
        out
    }

    /// The text.
    pub(crate) fn text(&self) -> &str {
        &self.text
    }

    /// Adds a part.
    pub(crate) fn push(&mut self, text: &str, span: Span) {
        if !text.is_empty() {
            self.marks.push((self.text.len(), span));
            self.text.push_str(text);
        }
    }

    /// Adds all parts of another one.
    pub(crate) fn append(&mut self, other: &Placed) {
        let from = self.text.len();
        self.marks.extend(other.marks.iter().map(|(at, span)| (from + at, *span)));
        self.text.push_str(&other.text);
    }

    /// The same between two signs, whose place is that of the whole.
    pub(crate) fn between(&self, open: &str, close: &str) -> Placed {
        let mut out = Placed::new(open, self.span());
        out.append(self);
        out.push(close, self.span());
        out
    }

    /// The place of the whole.
    pub(crate) fn span(&self) -> Span {
        self.place(Span { start: 0, end: self.text.len() })
    }

    /// The place in the source of a range of the text.
    pub(crate) fn place(&self, span: Span) -> Span {
        let from = self.marks.partition_point(|mark| mark.0 <= span.start).saturating_sub(1);
        let to = self.marks.partition_point(|mark| mark.0 < span.end.max(span.start + 1));
        let parts = self.marks.get(from..to.max(from)).unwrap_or_default();
        let start = parts.iter().map(|mark| mark.1.start).min();
        let end = parts.iter().map(|mark| mark.1.end).max();
        match (start, end) {
            (Some(start), Some(end)) => Span { start, end },
            _ => self.marks.last().map_or(Span::default(), |mark| mark.1),
        }
    }
}
