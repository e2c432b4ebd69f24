//! Records of a file of separated values, one at a time.
//!
//! **Contract.** Comment lines that begin with `#` and blank lines between records are passed over. The separator is that of the
//! first record, outside of quotation marks: a semicolon, else a tab, else a comma; Excel's line `sep=;` names it. Lines end with
//! `\n`, `\r\n` or `\r`. A field in quotation marks may hold separators, ends of lines and doubled quotation marks. A record
//! has [`MAX_RECORD`] bytes at most, and no more is held in memory. Each record knows its line.

use super::foreign::{Fields, ForeignError};
use std::io::{BufRead, ErrorKind};

/// The longest record, in bytes.
pub(super) const MAX_RECORD: u64 = 1 << 20;
/// The marks of UTF-16 text.
const WIDE: [&[u8]; 2] = [&[0xff, 0xfe], &[0xfe, 0xff]];

/// The records of a reader.
pub(super) struct Records<R> {
    reader: R,
    /// The lines that are read.
    line: u64,
    separator: u8,
    parser: csv_core::Reader,
    /// The first record has been seen.
    is_open: bool,
    /// The first record has one field.
    is_list: bool,
}

impl<R: BufRead> Records<R> {
    pub(super) fn new(reader: R) -> Records<R> {
        let (parser, separator) = (csv_core::Reader::new(), b',');
        Records { reader, line: 0, separator, parser, is_open: false, is_list: false }
    }

    /// Whether a comma in a field can only be a decimal one.
    pub(super) fn has_decimal_commas(&self) -> bool {
        self.separator == b';' || self.is_list
    }

    /// The next record, spaces around its fields removed.
    ///
    /// # Errors
    /// [`ForeignError`]; after one of a line other than a limit, the records after it can be read.
    pub(super) fn next(&mut self) -> Result<Option<Fields>, ForeignError> {
        let mut bytes = Vec::new();
        loop {
            bytes.clear();
            if !self.line(&mut bytes)? {
                return Ok(None);
            }
            if !self.is_open {
                if WIDE.iter().any(|mark| bytes.starts_with(mark)) {
                    return Err(ForeignError::Wide);
                }
                if let Some(rest) = bytes.strip_prefix("\u{feff}".as_bytes()) {
                    bytes = rest.to_vec();
                }
            }
            let text = bytes.trim_ascii();
            if text.is_empty() || text.starts_with(b"#") {
                continue;
            }
            if self.is_open {
                break;
            }
            let named = text.strip_prefix(b"sep=");
            self.separator = match named {
                Some([separator]) => *separator,
                _ => separator(text),
            };
            self.parser = csv_core::ReaderBuilder::new().delimiter(self.separator).build();
            if named.is_some() {
                bytes.clear();
                if !self.line(&mut bytes)? {
                    return Ok(None);
                }
            }
            break;
        }
        let record = self.record(bytes)?;
        if !self.is_open {
            self.is_open = true;
            self.is_list = record.fields.len() == 1;
            if self.is_list {
                self.parser = csv_core::ReaderBuilder::new().delimiter(b'\t').build();
            }
        }
        Ok(Some(record))
    }

    /// The record that begins with a line: further lines are read while a quotation mark is open.
    fn record(&mut self, mut bytes: Vec<u8>) -> Result<Fields, ForeignError> {
        use csv_core::ReadFieldResult::{End, Field, InputEmpty, OutputFull};
        let line = self.line;
        self.parser.reset();
        let (mut fields, mut part, mut from) = (vec![Vec::new()], [0; 1024], 0);
        loop {
            let (result, read, written) = self.parser.read_field(&bytes[from..], &mut part);
            from += read;
            if let Some(field) = fields.last_mut() {
                field.extend_from_slice(&part[..written]);
            }
            match result {
                OutputFull => {}
                Field { record_end: false } => fields.push(Vec::new()),
                Field { record_end: true } | End => break,
                // Every line has an end, so that a quotation mark is open.
                InputEmpty => match self.line(&mut bytes) {
                    Ok(true) => {}
                    Ok(false) | Err(ForeignError::Long { .. }) => return Err(ForeignError::Open { line }),
                    Err(error) => return Err(error),
                },
            }
        }
        let fields = fields.into_iter().map(|field| text(field, line)).collect::<Result<_, _>>()?;
        Ok(Fields { line, fields })
    }

    /// Appends the next line, with an end; whether there is one.
    fn line(&mut self, bytes: &mut Vec<u8>) -> Result<bool, ForeignError> {
        self.line += 1;
        let before = bytes.len();
        loop {
            let buffer = match self.reader.fill_buf() {
                Err(error) if error.kind() == ErrorKind::Interrupted => continue,
                buffer => buffer.map_err(ForeignError::Read)?,
            };
            if buffer.is_empty() {
                if bytes.len() > before {
                    bytes.push(b'\n');
                }
                break;
            }
            let end = buffer.iter().position(|byte| matches!(byte, b'\n' | b'\r'));
            let length = end.map_or(buffer.len(), |end| end + 1);
            bytes.extend_from_slice(&buffer[..length]);
            self.reader.consume(length);
            if bytes.len() as u64 > MAX_RECORD {
                return Err(ForeignError::Long { line: self.line });
            }
            if end.is_some() {
                if bytes.last() == Some(&b'\r') {
                    self.take_newline(bytes)?;
                }
                break;
            }
        }
        Ok(bytes.len() > before)
    }

    /// Takes the `\n` of `\r\n`.
    fn take_newline(&mut self, bytes: &mut Vec<u8>) -> Result<(), ForeignError> {
        let next = loop {
            match self.reader.fill_buf() {
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                buffer => break buffer.map_err(ForeignError::Read)?.first().copied(),
            }
        };
        if next == Some(b'\n') {
            self.reader.consume(1);
            bytes.push(b'\n');
        }
        Ok(())
    }
}

/// A field, without the spaces around it, and without quotation marks that stand behind such a space.
fn text(field: Vec<u8>, line: u64) -> Result<String, ForeignError> {
    let text = String::from_utf8(field).map_err(|_| ForeignError::NotText { line })?;
    let text = text.trim();
    let inside = text.strip_prefix('"').and_then(|rest| rest.strip_suffix('"'));
    Ok(inside.map_or(text, str::trim).to_owned())
}

/// What separates the fields of a line.
fn separator(line: &[u8]) -> u8 {
    let mut is_quoted = false;
    let outside: Vec<u8> = line
        .iter()
        .copied()
        .filter(|byte| {
            is_quoted ^= *byte == b'"';
            !is_quoted
        })
        .collect();
    let has = |wanted: u8| outside.contains(&wanted);
    [b';', b'\t'].into_iter().find(|separator| has(*separator)).unwrap_or(b',')
}
