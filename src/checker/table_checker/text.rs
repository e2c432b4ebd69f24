//! The lines of a table's certificate: one form, byte for byte, so that a line has one reading.
//!
//! Contract: a line that was read is the line that writing its parts again would give. There are no spaces, no escapes,
//! no other keys and no other order of keys.

use super::dyadic::Dyadic;
use super::failure::{Failure, declined, rejected};
use super::rounding::{DIGITS_LIMIT, Digits, Rounding};
use super::work::Work;
use num_bigint::{BigInt, BigUint};
use num_rational::BigRational;
use num_traits::Zero;

/// The longest line, in bytes.
pub const LINE_LIMIT: usize = 4 << 20;
/// The most digits of a number in a line.
const NUMBER_LIMIT: usize = 40_000;

/// The quantity of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Quantity {
    /// (25).
    Eta,
    /// `L_n`, (19).
    Threshold,
    /// The number of `n >= 1` with `L_n <= e`.
    BestN,
}

/// The values of an axis, as the head gives them.
#[derive(Clone, Debug)]
pub(crate) enum Values {
    /// One by one.
    List(Vec<BigRational>),
    /// So many from a start on, each by a step more than the last.
    Steps(BigRational, BigRational, u64),
    /// So many from a start on, each a factor times the last.
    Factors(BigRational, BigRational, u64),
}

/// What the head says.
#[derive(Clone, Debug)]
pub(crate) struct Head {
    /// The quantity.
    pub quantity: Quantity,
    /// Remarks for readers: names and texts.
    pub remarks: Vec<(String, String)>,
    /// The axes, by name, the last one running fastest.
    pub axes: Vec<(String, Values)>,
    /// How many digits are printed; none for numbers of bodies.
    pub digits: Option<Digits>,
    /// In which direction they are rounded.
    pub rounding: Option<Rounding>,
    /// How many rows follow.
    pub rows: u64,
}

/// What a row says.
#[derive(Clone, Debug)]
pub(crate) struct Row<'a> {
    /// Its place, from 0.
    pub row: u64,
    /// The mass ratio.
    pub ratio: &'a str,
    /// The restitution.
    pub e: Option<&'a str>,
    /// The number of inserted bodies.
    pub n: Option<&'a str>,
    /// The value as printed.
    pub printed: &'a str,
    /// The value as a fraction.
    pub exact: Option<&'a str>,
    /// At most the value.
    pub lower: Option<Dyadic>,
    /// At least the value.
    pub upper: Option<Dyadic>,
    /// Whether one body fewer does as well.
    pub tie: Option<bool>,
}

/// A place in a line.
struct Cursor<'a> {
    rest: &'a str,
}

type Read<T> = Result<T, Failure>;

impl<'a> Cursor<'a> {
    fn found(&mut self, word: &str) -> bool {
        self.rest.strip_prefix(word).map(|rest| self.rest = rest).is_some()
    }

    fn word(&mut self, word: &str) -> Read<()> {
        if self.found(word) { Ok(()) } else { rejected(&format!("expected {word}, found {}", self.near())) }
    }

    fn near(&self) -> String {
        self.rest.chars().take(24).collect()
    }

    /// A text in quotes, without escapes.
    fn text(&mut self) -> Read<&'a str> {
        self.word("\"")?;
        match self.rest.split_once('"') {
            Some((text, rest)) if !text.contains('\\') && !text.chars().any(char::is_control) => {
                self.rest = rest;
                Ok(text)
            }
            _ => rejected(&format!("expected a text without escapes and control characters at {}", self.near())),
        }
    }

    fn text_or_null(&mut self) -> Read<Option<&'a str>> {
        if self.found("null") { Ok(None) } else { self.text().map(Some) }
    }

    /// A natural number without leading zeros.
    fn natural(&mut self) -> Read<BigUint> {
        let end = self.rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(self.rest.len());
        let (digits, rest) = self.rest.split_at(end);
        let number = natural(digits)?;
        self.rest = rest;
        Ok(number)
    }

    fn count(&mut self) -> Read<u64> {
        u64::try_from(self.natural()?).or_else(|_| declined("rows of a table"))
    }

    fn dyadic_or_null(&mut self) -> Read<Option<Dyadic>> {
        if self.found("null") {
            return Ok(None);
        }
        self.word("{\"mantissa\":\"")?;
        let mantissa = self.natural()?;
        self.word("\",\"exponent\":")?;
        let negative = self.found("-");
        let size = i64::try_from(self.natural()?).or_else(|_| declined("exponents of dyadic numbers"))?;
        if negative && size == 0 {
            return rejected("write 0, not -0");
        }
        self.word("}")?;
        Ok(Some(Dyadic::new(mantissa, if negative { -size } else { size })))
    }

    fn end(&self) -> Read<()> {
        if self.rest.is_empty() {
            Ok(())
        } else {
            rejected(&format!("expected the end of the line, found {}", self.near()))
        }
    }
}

/// A natural number in digits, without leading zeros.
fn natural(digits: &str) -> Read<BigUint> {
    if digits.len() > NUMBER_LIMIT {
        return declined("digits of a number");
    }
    let plain = digits.bytes().all(|b| b.is_ascii_digit()) && (digits == "0" || !digits.starts_with('0'));
    match digits.parse::<BigUint>() {
        Ok(number) if plain => Ok(number),
        _ => rejected(&format!("{digits:?} is not a number in decimal digits")),
    }
}

/// `p` or `p/q` in lowest terms, perhaps negative.
fn ratio(text: &str, work: &Work) -> Read<BigRational> {
    let (negative, size) = text.strip_prefix('-').map_or((false, text), |size| (true, size));
    let (above, below) = size.split_once('/').unwrap_or((size, "1"));
    let (above, below) = (natural(above)?, natural(below)?);
    if below.is_zero() {
        return rejected("a denominator is 0");
    }
    work.reduction(above.bits().max(below.bits()))?;
    let number = BigRational::new(BigInt::from(above), BigInt::from(below));
    let number = if negative { -number } else { number };
    if number.to_string() == text { Ok(number) } else { rejected(&format!("{text} is not in lowest terms")) }
}

fn values(at: &mut Cursor<'_>, work: &Work) -> Read<Values> {
    if at.found("{\"list\":[") {
        let mut list = vec![ratio(at.text()?, work)?];
        while at.found(",") {
            list.push(ratio(at.text()?, work)?);
        }
        at.word("]}")?;
        return Ok(Values::List(list));
    }
    at.word("{\"start\":")?;
    let start = ratio(at.text()?, work)?;
    at.word(",\"")?;
    let steps = at.found("step\":");
    if !steps {
        at.word("factor\":")?;
    }
    let by = ratio(at.text()?, work)?;
    at.word(",\"count\":")?;
    let count = at.count()?;
    at.word("}")?;
    Ok(if steps { Values::Steps(start, by, count) } else { Values::Factors(start, by, count) })
}

/// Reads the first line.
pub(crate) fn head(line: &str, work: &Work) -> Read<Head> {
    let mut at = Cursor { rest: line };
    at.word("{\"certificate\":\"table\",\"want\":")?;
    let quantity = match at.text()? {
        "eta" => Quantity::Eta,
        "threshold" => Quantity::Threshold,
        "best-n" => Quantity::BestN,
        other => return rejected(&format!("unknown quantity {other}")),
    };
    at.word(",\"head\":{")?;
    let mut remarks = Vec::new();
    while !at.found("}") {
        if !remarks.is_empty() {
            at.word(",")?;
        }
        let name = at.text()?.to_string();
        at.word(":")?;
        remarks.push((name, at.text()?.to_string()));
    }
    at.word(",\"version\":1,\"axes\":{")?;
    let mut axes = Vec::new();
    while !at.found("}") {
        if !axes.is_empty() {
            at.word(",")?;
        }
        let name = at.text()?.to_string();
        at.word(":")?;
        axes.push((name, values(&mut at, work)?));
    }
    at.word(",\"digits\":")?;
    let digits = digits(&mut at)?;
    at.word(",\"rounding\":")?;
    let rounding = match at.text_or_null()? {
        None => None,
        Some("nearest-even") => Some(Rounding::NearestEven),
        Some("up") => Some(Rounding::Up),
        Some("down") => Some(Rounding::Down),
        Some("zero") => Some(Rounding::Zero),
        Some("away") => Some(Rounding::Away),
        Some(other) => return rejected(&format!("unknown rounding {other}")),
    };
    at.word(",\"rows\":")?;
    let rows = at.count()?;
    at.word("}")?;
    at.end()?;
    Ok(Head { quantity, remarks, axes, digits, rounding, rows })
}

fn digits(at: &mut Cursor<'_>) -> Read<Option<Digits>> {
    if at.found("null") {
        return Ok(None);
    }
    let significant = at.found("{\"significant\":");
    if !significant {
        at.word("{\"places\":")?;
    }
    let count = at.count()?;
    at.word("}")?;
    if count > DIGITS_LIMIT {
        return declined("digits of a table");
    }
    match (significant, count) {
        (true, 0) => rejected("a number has at least one significant digit"),
        (true, _) => Ok(Some(Digits::Significant(count))),
        (false, _) => Ok(Some(Digits::Places(count))),
    }
}

/// Reads a row.
pub(crate) fn row(line: &str) -> Read<Row<'_>> {
    let mut at = Cursor { rest: line };
    at.word("{\"row\":")?;
    let row = at.count()?;
    at.word(",\"ratio\":")?;
    let ratio = at.text()?;
    at.word(",\"e\":")?;
    let e = at.text_or_null()?;
    at.word(",\"n\":")?;
    let n = at.text_or_null()?;
    at.word(",\"printed\":")?;
    let printed = at.text()?;
    at.word(",\"exact\":")?;
    let exact = at.text_or_null()?;
    at.word(",\"lower\":")?;
    let lower = at.dyadic_or_null()?;
    at.word(",\"upper\":")?;
    let upper = at.dyadic_or_null()?;
    at.word(",\"tie\":")?;
    let tie = match () {
        () if at.found("null") => None,
        () if at.found("true") => Some(true),
        () => at.word("false").map(|()| Some(false))?,
    };
    at.word("}")?;
    at.end()?;
    Ok(Row { row, ratio, e, n, printed, exact, lower, upper, tie })
}
