//! Somebody's table: comma-, semicolon- or tab-separated values with a heading.
//!
//! **Contract.** Comment lines that begin with `#` and blank lines are passed over. The first other line is the
//! heading; it must name what is needed in any order, and may name more. With semicolons, decimals may have
//! commas. Lines are read one at a time, of [`MAX_LINE`] bytes at most.

use super::Quantity;
use std::borrow::Cow;
use std::fmt;
use std::io::{self, BufRead, Read};

/// The longest line, in bytes.
pub(crate) const MAX_LINE: u64 = 1 << 20;

/// What a column holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Role {
    /// m1/m2.
    Ratio,
    /// The first mass.
    First,
    /// The last mass.
    Last,
    /// The restitution.
    E,
    /// The number of inserted bodies.
    N,
    /// A quantity to check.
    Value(Quantity),
}

/// Names of columns, in small letters.
const NAMES: &[(&str, Role)] = &[
    ("ratio", Role::Ratio),
    ("r", Role::Ratio),
    ("m1/m2", Role::Ratio),
    ("m1", Role::First),
    ("m2", Role::Last),
    ("e", Role::E),
    ("restitution", Role::E),
    ("n", Role::N),
    ("inserted", Role::N),
    ("eta", Role::Value(Quantity::Eta)),
    ("threshold", Role::Value(Quantity::Threshold)),
    ("l_n", Role::Value(Quantity::Threshold)),
    ("best-n", Role::Value(Quantity::BestN)),
    ("n*", Role::Value(Quantity::BestN)),
];

/// A number as tables write it, with the digit before the point that a numeral needs, and the plain sign of a fraction:
/// `.9` is 0.9, and `9⁄16`, as a table for a spreadsheet has it, is 9/16.
#[must_use]
pub(crate) fn completed(text: &str) -> Cow<'_, str> {
    if text.contains('\u{2044}') {
        return Cow::Owned(text.replace('\u{2044}', "/"));
    }
    let rest = text.strip_prefix(['-', '+']).unwrap_or(text);
    let (sign, rest) = text.split_at(text.len() - rest.len());
    if rest.starts_with('.') { Cow::Owned(format!("{sign}0{rest}")) } else { Cow::Borrowed(text) }
}

/// Why a file is no table.
#[derive(Debug)]
pub enum ForeignError {
    /// It cannot be read.
    Read(io::Error),
    /// A line is too long.
    Long {
        /// The line, from 1.
        line: u64,
    },
    /// A line is no UTF-8 text.
    NotText {
        /// The line, from 1.
        line: u64,
    },
    /// A quotation mark is not closed on its line.
    Open {
        /// The line, from 1.
        line: u64,
    },
    /// There is no heading.
    Empty,
    /// Two columns mean the same.
    Twice {
        /// The second one's name.
        name: String,
    },
    /// A row has fewer or more fields than the heading.
    Fields {
        /// The line, from 1.
        line: u64,
        /// How many there are.
        given: usize,
        /// How many there must be.
        needed: usize,
    },
}

impl fmt::Display for ForeignError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Read(error) => write!(f, "cannot read it: {error}"),
            Self::Long { line } => write!(f, "line {line}: limit reached: bytes of a line: {MAX_LINE} allowed"),
            Self::NotText { line } => write!(f, "line {line}: this is not UTF-8 text"),
            Self::Open { line } => write!(f, "line {line}: a quotation mark is not closed"),
            Self::Empty => write!(f, "the file has no heading; write for instance: ratio,e,n,eta"),
            Self::Twice { name } => write!(f, "two columns mean {name:?}; leave one of them out"),
            Self::Fields { line, given, needed } => {
                write!(f, "line {line}: {given} fields where the heading has {needed}")
            }
        }
    }
}

impl std::error::Error for ForeignError {}

impl ForeignError {
    /// Whether a stated limit is the reason.
    #[must_use]
    pub fn is_limit(&self) -> bool {
        matches!(self, Self::Long { .. })
    }
}

/// A table that is being read.
pub(crate) struct Foreign<R> {
    reader: R,
    line: u64,
    separator: char,
    /// The names in the heading.
    pub names: Vec<String>,
    /// The columns that mean something.
    pub roles: Vec<(usize, Role)>,
}

/// A row: its line and its fields, spaces around them removed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Fields {
    /// The line, from 1.
    pub line: u64,
    /// The fields.
    pub fields: Vec<String>,
}

impl<R: BufRead> Foreign<R> {
    /// Reads the heading.
    ///
    /// # Errors
    /// [`ForeignError`].
    pub(crate) fn open(reader: R) -> Result<Foreign<R>, ForeignError> {
        let mut table = Foreign { reader, line: 0, separator: ',', names: Vec::new(), roles: Vec::new() };
        let Some(heading) = table.next_line()? else { return Err(ForeignError::Empty) };
        let heading = heading.trim_start_matches('\u{feff}').to_owned();
        table.separator = [';', '\t'].into_iter().find(|c| heading.contains(*c)).unwrap_or(',');
        let names = table.split(&heading)?;
        for (place, name) in names.iter().enumerate() {
            let key = name.to_lowercase();
            let Some((_, role)) = NAMES.iter().find(|n| n.0 == key) else { continue };
            if table.roles.iter().any(|r| r.1 == *role) {
                return Err(ForeignError::Twice { name: name.clone() });
            }
            table.roles.push((place, *role));
        }
        table.names = names;
        Ok(table)
    }

    /// The place of the column of a role.
    pub(crate) fn column(&self, role: Role) -> Option<usize> {
        self.roles.iter().find(|r| r.1 == role).map(|r| r.0)
    }

    /// The next row.
    ///
    /// # Errors
    /// [`ForeignError`].
    pub(crate) fn row(&mut self) -> Result<Option<Fields>, ForeignError> {
        let Some(text) = self.next_line()? else { return Ok(None) };
        let mut fields = self.split(&text)?;
        let needed = self.names.len();
        if fields.len() != needed {
            return Err(ForeignError::Fields { line: self.line, given: fields.len(), needed });
        }
        if self.separator == ';' {
            fields.iter_mut().for_each(|f| *f = f.replace(',', "."));
        }
        Ok(Some(Fields { line: self.line, fields }))
    }

    /// The next line that is neither blank nor a comment, without its end.
    fn next_line(&mut self) -> Result<Option<String>, ForeignError> {
        loop {
            let mut bytes = Vec::new();
            let limited = &mut self.reader.by_ref().take(MAX_LINE + 1);
            if limited.read_until(b'\n', &mut bytes).map_err(ForeignError::Read)? == 0 {
                return Ok(None);
            }
            self.line += 1;
            let line = self.line;
            if bytes.len() as u64 > MAX_LINE {
                return Err(ForeignError::Long { line });
            }
            let text = String::from_utf8(bytes).map_err(|_| ForeignError::NotText { line })?;
            if !(text.trim().is_empty() || text.starts_with('#')) {
                return Ok(Some(text.trim_end_matches(['\n', '\r']).to_owned()));
            }
        }
    }

    fn split(&self, text: &str) -> Result<Vec<String>, ForeignError> {
        let (mut fields, mut field, mut inside) = (Vec::new(), String::new(), false);
        let mut rest = text.chars().peekable();
        while let Some(c) = rest.next() {
            match c {
                '"' if inside && rest.peek() == Some(&'"') => {
                    rest.next();
                    field.push('"');
                }
                '"' => inside = !inside,
                c if c == self.separator && !inside => fields.push(std::mem::take(&mut field).trim().to_owned()),
                c => field.push(c),
            }
        }
        if inside {
            return Err(ForeignError::Open { line: self.line });
        }
        fields.push(field.trim().to_owned());
        Ok(fields)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows(text: &str) -> Result<Vec<Vec<String>>, ForeignError> {
        let mut table = Foreign::open(text.as_bytes())?;
        let mut out = Vec::new();
        while let Some(row) = table.row()? {
            out.push(row.fields);
        }
        Ok(out)
    }

    #[test]
    fn separators_quotation_marks_and_decimal_commas_are_understood() {
        let plain = vec![vec!["10".to_owned(), "0.9".to_owned()]];
        for text in [
            "ratio,e\n10,0.9\n",
            "# a comment\n\nratio,e\r\n10,0.9\r\n\n",
            "ratio;e\n10;0,9",
            "ratio\te\n10\t0.9",
            "\u{feff}\"ratio\",\"e\"\n\"10\", 0.9 \n",
        ] {
            assert_eq!(rows(text).expect(text), plain, "{text:?}");
        }
        assert_eq!(rows("a,b\n\"x, \"\"y\"\"\",1\n").expect("it reads")[0][0], "x, \"y\"");
    }

    #[test]
    fn broken_tables_say_where() {
        let said = |text: &str| rows(text).expect_err(text).to_string();
        assert!(said("").contains("no heading"));
        assert!(said("ratio,e\n1\n").contains("line 2: 1 fields"));
        assert!(said("ratio,r\n1,1\n").contains("two columns"));
        assert!(said("ratio,e\n\"1,2\n").contains("line 2: a quotation mark"));
        assert!(said(&format!("ratio\n{}", "1".repeat(1 << 21))).contains("limit reached"));
        assert!(Foreign::open(&b"ratio\xff\n"[..]).is_err());
        // An endless line is not read to its end.
        assert!(Foreign::open(io::BufReader::new(io::repeat(b'1'))).is_err());
    }
}
