//! Somebody's table: comma-, semicolon- or tab-separated values with a heading, as R, pandas, Excel and LibreOffice write them.
//!
//! **Contract.** The first record of `records` is the heading; it must name what is needed in any order, and may name
//! more. A table of one column, or one with semicolons, may have decimal commas. Columns without a name (the numbers that R and
//! pandas give their rows) and empty fields beyond the heading mean nothing.

use super::Quantity;
use super::records::{MAX_RECORD, Records};
use crate::chain::uncertain::Range;
use std::fmt;
use std::io::{self, BufRead};

/// What a column holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
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
    /// The file is UTF-16 text.
    Wide,
    /// A quotation mark is not closed.
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
        match self.line() {
            Some(line) => write!(f, "line {line}: {}", self.reason()),
            None => write!(f, "{}", self.reason()),
        }
    }
}

impl std::error::Error for ForeignError {}

impl ForeignError {
    /// The line, from 1, where one is at fault.
    #[must_use]
    pub fn line(&self) -> Option<u64> {
        match self {
            Self::Long { line } | Self::NotText { line } | Self::Open { line } | Self::Fields { line, .. } => {
                Some(*line)
            }
            Self::Read(_) | Self::Wide | Self::Empty | Self::Twice { .. } => None,
        }
    }

    /// What is wrong, without the line.
    #[must_use]
    pub fn reason(&self) -> String {
        match self {
            Self::Read(error) => format!("cannot read it: {error}"),
            Self::Long { .. } => format!("limit reached: bytes of a line: {MAX_RECORD} allowed"),
            Self::NotText { .. } => "this is not UTF-8 text".to_owned(),
            Self::Wide => "this is UTF-16 text; save it as \"CSV UTF-8\"".to_owned(),
            Self::Open { .. } => "a quotation mark is not closed".to_owned(),
            Self::Empty => "the file has no heading; write for instance: ratio,e,n,eta".to_owned(),
            Self::Twice { name } => format!("two columns mean {name:?}; leave one of them out"),
            Self::Fields { given, needed, .. } => format!("{given} fields where the heading has {needed}"),
        }
    }

    /// Whether a stated limit is the reason.
    #[must_use]
    pub fn is_limit(&self) -> bool {
        matches!(self, Self::Long { .. })
    }
}

/// A table that is being read.
pub struct Foreign<R> {
    records: Records<R>,
    /// The names in the heading.
    pub names: Vec<String>,
    /// The columns that mean something.
    pub roles: Vec<(usize, Role)>,
    /// Whether the names are those of a heading.
    pub is_named: bool,
    /// The first row of a table without a heading.
    first: Option<Fields>,
}

/// A row: its line and its fields, spaces around them removed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fields {
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
    pub fn open(reader: R) -> Result<Foreign<R>, ForeignError> {
        let mut records = Records::new(reader);
        let Some(heading) = records.next()? else { return Err(ForeignError::Empty) };
        Foreign::named(records, heading.fields, None)
    }

    /// Reads the heading, or, where the first record has a number, takes it for a row of columns with these names.
    /// An empty file is a table without rows.
    ///
    /// # Errors
    /// [`ForeignError`].
    pub fn open_or(reader: R, names: &[&str]) -> Result<Foreign<R>, ForeignError> {
        let mut records = Records::new(reader);
        let usual = || names.iter().map(|name| (*name).to_owned()).collect();
        match records.next()? {
            None => Foreign::named(records, usual(), None),
            Some(row) if row.fields.iter().any(|field| Range::read(field).is_ok()) => {
                Foreign::named(records, usual(), Some(row))
            }
            Some(heading) => Foreign::named(records, heading.fields, None),
        }
    }

    fn named(records: Records<R>, names: Vec<String>, first: Option<Fields>) -> Result<Foreign<R>, ForeignError> {
        let mut roles: Vec<(usize, Role)> = Vec::new();
        for (place, name) in names.iter().enumerate() {
            let key = name.to_lowercase();
            let Some((_, role)) = NAMES.iter().find(|n| n.0 == key) else { continue };
            if roles.iter().any(|r| r.1 == *role) {
                return Err(ForeignError::Twice { name: name.clone() });
            }
            roles.push((place, *role));
        }
        let is_named = first.is_none();
        Ok(Foreign { records, names, roles, is_named, first })
    }

    /// The place of the column of a role.
    pub fn column(&self, role: Role) -> Option<usize> {
        self.roles.iter().find(|r| r.1 == role).map(|r| r.0)
    }

    /// The next row. After an error of a line other than a limit, the rows after it can be read.
    ///
    /// # Errors
    /// [`ForeignError`].
    pub fn row(&mut self) -> Result<Option<Fields>, ForeignError> {
        let next = match self.first.take() {
            Some(first) => Some(first),
            None => self.records.next()?,
        };
        let Some(Fields { line, mut fields }) = next else { return Ok(None) };
        let (given, needed) = (fields.len(), self.names.len());
        while fields.len() > needed && fields.last().is_some_and(String::is_empty) {
            fields.pop();
        }
        if fields.len() != needed {
            return Err(ForeignError::Fields { line, given, needed });
        }
        if self.records.has_decimal_commas() {
            // A range keeps its own commas.
            fields.iter_mut().filter(|f| !f.starts_with('[')).for_each(|f| *f = f.replace(',', "."));
        }
        Ok(Some(Fields { line, fields }))
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
            "ratio, \"e\"\n10, \"0.9\"\n",
            "sep=;\r\nratio;e\r\n10;0,9\r\n",
            "ratio,e\r\n10,0.9,\r\n",
            "ratio,e\r10,0.9\r",
        ] {
            assert_eq!(rows(text).expect(text), plain, "{text:?}");
        }
        assert_eq!(rows("a,b\n\"x, \"\"y\"\"\",1\n").expect("it reads")[0][0], "x, \"y\"");
        assert_eq!(rows("height\n1,20\n0,86\n").expect("it reads"), [["1.20"], ["0.86"]]);
        // A field of several lines, and the lines after it.
        let mut table = Foreign::open("a,b\n\"x\ny\",1\n2,3\n".as_bytes()).expect("it opens");
        let lines: Vec<u64> = std::iter::from_fn(|| table.row().expect("a row")).map(|row| row.line).collect();
        assert_eq!(lines, [2, 4]);
    }

    #[test]
    fn broken_tables_say_where() {
        let said = |text: &str| rows(text).expect_err(text).to_string();
        assert!(said("").contains("no heading"));
        assert!(said("ratio,e\n1\n").contains("line 2: 1 fields"));
        assert!(said("ratio,r\n1,1\n").contains("two columns"));
        assert!(said("ratio,e\n\"1,2\n").contains("line 2: a quotation mark"));
        assert!(said(&format!("ratio\n\"{}", "1\n".repeat(1 << 20))).contains("line 2: a quotation mark"));
        let wide: Vec<u8> = "\u{feff}ratio,e\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
        assert!(matches!(Foreign::open(&wide[..]), Err(ForeignError::Wide)));
        assert!(said(&format!("ratio\n{}", "1".repeat(1 << 21))).contains("limit reached"));
        assert!(Foreign::open(&b"ratio\xff\n"[..]).is_err());
        // An endless line is not read to its end.
        assert!(Foreign::open(io::BufReader::new(io::repeat(b'1'))).is_err());
    }
}
