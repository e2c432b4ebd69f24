//! Tables re-checked: every row of a table's certificate, with nothing but the file and integers.
//!
//! Contract: [`Checker::finish`] returns [`AcceptedTable`] only if the file is the whole table that its head describes, and
//! every number printed in it is the value of the quantity at its place, rounded as the head says. Lines are given
//! one at a time; memory does not grow with their number.
//!
//! **What is shown of a row.** Each rule is a function below:
//! - `Axes::matches`: the row stands at the place of the grid that its number says. Rows follow one another from 0, and
//!   the head's axes say how many there are: none is left out, none is there twice.
//! - `exact_cell`, `enclosed_cell`: the value lies in the enclosure; the printed digits follow.
//! - `best_cell`: the number of bodies, by two comparisons. This rests on the claims `b-grow`, that `L_n` rises with `n`,
//!   and `b-grow-bounded`, that it stays below 1, which have certificates of their own; an acceptance says so.
//!
//! **What is assumed.** The formulas of [`value`], which the head repeats in words. That other numbers are irrational is
//! not assumed: what is not known exactly is enclosed, and an enclosure decides or a limit is reached.

pub mod dyadic;
mod failure;
pub mod root;
pub mod rounding;
pub mod text;
pub mod value;
pub mod work;

pub use failure::Failure;

use dyadic::{Interval, Toward};
use failure::{declined, rejected};
use num_bigint::BigUint;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use rounding::{Digits, Rounding, of_end, of_ratio};
use std::cmp::Ordering;
use std::collections::BTreeSet;
use text::{Head, Quantity, Row, Values};
use value::{Cell, Form};
use work::Work;

/// The longest fraction that a table shows beside a value, in characters.
const EXACT_LENGTH: usize = 60;
/// The most bits of a value of an axis.
const AXIS_BITS: u64 = 1 << 18;
/// Values of a list that the statement shows.
const SHOWN: usize = 12;

/// A table that was shown. Only the checker makes one.
#[derive(Clone, Debug)]
pub struct AcceptedTable {
    rows: u64,
    statement: String,
    rests_on: &'static [&'static str],
}

impl AcceptedTable {
    /// How many rows it has.
    pub fn rows(&self) -> u64 {
        self.rows
    }

    /// What was shown, as the kernel understood it.
    pub fn text(&self) -> &str {
        &self.statement
    }

    /// The claims that it rests on.
    pub fn rests_on(&self) -> &'static [&'static str] {
        self.rests_on
    }
}

/// An axis with its present value.
#[derive(Clone, Debug)]
struct Axis {
    name: String,
    values: Values,
    place: u64,
    value: BigRational,
    text: String,
}

impl Axis {
    /// Its values differ: a cell that is given twice could hide that another one is missing.
    fn new(name: String, values: Values) -> Result<Axis, Failure> {
        let differ = match &values {
            Values::List(list) => list.iter().collect::<BTreeSet<_>>().len() == list.len(),
            Values::Steps(_, step, _) => !step.is_zero(),
            Values::Factors(start, factor, _) => !start.is_zero() && factor.is_positive() && !factor.is_one(),
        };
        if !differ {
            return rejected(&format!("the axis {name} has a value twice"));
        }
        let first = match &values {
            Values::List(list) => list.first().cloned(),
            Values::Steps(start, _, count) | Values::Factors(start, _, count) => (*count > 0).then(|| start.clone()),
        };
        let Some(value) = first else { return rejected(&format!("the axis {name} has no values")) };
        let text = value.to_string();
        Ok(Axis { name, values, place: 0, value, text })
    }

    fn count(&self) -> u64 {
        match &self.values {
            Values::List(list) => u64::try_from(list.len()).unwrap_or(u64::MAX),
            Values::Steps(.., count) | Values::Factors(.., count) => *count,
        }
    }

    /// Goes on to the next value, or back to the first: then the answer is true.
    fn advance(&mut self, work: &Work) -> Result<bool, Failure> {
        self.place += 1;
        let wraps = self.place >= self.count();
        if wraps {
            self.place = 0;
        }
        if let Values::Steps(_, by, _) | Values::Factors(_, by, _) = &self.values
            && !wraps
        {
            // The sum or product in lowest terms, and its digits.
            let size = |x: &BigRational| x.numer().bits().max(x.denom().bits());
            work.reduction(size(&self.value) + size(by))?;
        }
        let next = match &self.values {
            Values::List(list) => usize::try_from(self.place).ok().and_then(|place| list.get(place)).cloned(),
            Values::Steps(start, ..) | Values::Factors(start, ..) if wraps => Some(start.clone()),
            Values::Steps(_, step, _) => Some(&self.value + step),
            Values::Factors(_, factor, _) => Some(&self.value * factor),
        };
        let Some(next) = next else { return rejected("an axis has no such value") };
        if next.numer().bits() + next.denom().bits() > AXIS_BITS {
            return declined("bits of a value of an axis");
        }
        if next != self.value {
            self.text = next.to_string();
            self.value = next;
        }
        Ok(wraps)
    }

    fn described(&self) -> String {
        let values = match &self.values {
            Values::List(list) => {
                let shown: Vec<String> = list.iter().take(SHOWN).map(BigRational::to_string).collect();
                let rest = list.len().saturating_sub(SHOWN);
                shown.join(", ") + &if rest > 0 { format!(" and {rest} more") } else { String::new() }
            }
            Values::Steps(start, step, count) => format!("{count} from {start} by steps of {step}"),
            Values::Factors(start, factor, count) => format!("{count} from {start} by factors of {factor}"),
        };
        format!("{} = {values}\n", self.name)
    }
}

/// The axes of a table at the present row.
#[derive(Clone, Debug)]
struct Axes(Vec<Axis>);

impl Axes {
    fn named(&self, name: &str) -> Option<&Axis> {
        self.0.iter().find(|axis| axis.name == name)
    }

    /// The axes that the quantity depends on, in this order; their lengths' product is the number of rows.
    fn of(head: &Head) -> Result<Axes, Failure> {
        let names: &[&str] = match head.quantity {
            Quantity::Eta => &["ratio", "e", "n"],
            Quantity::Threshold => &["ratio", "n"],
            Quantity::BestN => &["ratio", "e"],
        };
        if !head.axes.iter().map(|(name, _)| name.as_str()).eq(names.iter().copied()) {
            return rejected(&format!("the axes of this quantity are {}", names.join(", ")));
        }
        let axes: Result<Vec<Axis>, Failure> =
            head.axes.iter().map(|(name, values)| Axis::new(name.clone(), values.clone())).collect();
        let axes = axes?;
        match axes.iter().try_fold(1u64, |rows, axis| rows.checked_mul(axis.count())) {
            Some(rows) if rows == head.rows => Ok(Axes(axes)),
            Some(rows) => rejected(&format!("the axes make {rows} rows, not {}", head.rows)),
            None => declined("rows of a table"),
        }
    }

    /// The row stands at the present place: its numbers are those of the axes there, in the same lowest terms, and it
    /// has no others.
    fn matches(&self, row: &Row<'_>) -> Result<(), Failure> {
        for (name, given) in [("ratio", Some(row.ratio)), ("e", row.e), ("n", row.n)] {
            let wanted = self.named(name).map(|axis| axis.text.as_str());
            if given != wanted {
                let (given, wanted) = (given.unwrap_or("nothing"), wanted.unwrap_or("nothing"));
                return rejected(&format!("{name} is {wanted} in this row, not {given}"));
            }
        }
        Ok(())
    }

    /// The mass ratio, above 0.
    fn ratio(&self) -> Result<BigRational, Failure> {
        match self.named("ratio") {
            Some(axis) if axis.value.is_positive() => Ok(axis.value.clone()),
            _ => rejected("a ratio of masses is above 0"),
        }
    }

    /// The restitution, from 0 to 1.
    fn restitution(&self) -> Result<BigRational, Failure> {
        match self.named("e") {
            Some(axis) if !axis.value.is_negative() && axis.value <= BigRational::one() => Ok(axis.value.clone()),
            _ => rejected("a restitution lies from 0 to 1"),
        }
    }

    /// The number of inserted bodies, at least so many.
    fn inserted(&self, least: u32) -> Result<BigUint, Failure> {
        let n = self.named("n").filter(|axis| axis.value.is_integer()).and_then(|axis| axis.value.numer().to_biguint());
        match n {
            Some(n) if n.bits() > value::COUNT_BITS => declined("bits of a number of bodies"),
            Some(n) if n >= BigUint::from(least) => Ok(n),
            _ => rejected(&format!("n is an integer from {least} on")),
        }
    }

    /// Goes on to the next row: the last axis runs fastest.
    fn advance(&mut self, work: &Work) -> Result<(), Failure> {
        for axis in self.0.iter_mut().rev() {
            if !axis.advance(work)? {
                break;
            }
        }
        Ok(())
    }
}

/// Checks one table, line by line.
#[derive(Clone, Debug)]
pub struct Checker {
    head: Head,
    axes: Axes,
    next: u64,
    work: Work,
}

impl Checker {
    /// Begins with the head.
    ///
    /// What it says in words about the formula and the rounding has to be what the kernel says of the same; the remarks
    /// `further` and `program` say nothing that a row depends on.
    pub fn new(line: &str) -> Result<Checker, Failure> {
        let work = Work::default();
        work.read(line.len());
        let head = text::head(line, &work)?;
        let axes = Axes::of(&head)?;
        let wanted = remarks(&head)?;
        if head.remarks.iter().filter(|(name, _)| name == "further").count() > 1 {
            return rejected("the head has two remarks `further`");
        }
        let mut given = head.remarks.iter().filter(|(name, _)| name != "further");
        for (name, text) in &wanted {
            match given.next() {
                Some((found, said)) if found == name && said == text => {}
                _ => return rejected(&format!("the head does not say {name:?}: {text:?}")),
            }
        }
        if !given.map(|(name, _)| name.as_str()).eq(["program"]) {
            return rejected("the head ends with the program's name");
        }
        Ok(Checker { head, axes, next: 0, work })
    }

    /// The place of the next row in words.
    pub fn place(&self) -> String {
        let axes: Vec<String> = self.axes.0.iter().map(|axis| format!("{} {}", axis.name, axis.text)).collect();
        format!("row {}, {}", self.next, axes.join(", "))
    }

    /// Checks the next row.
    pub fn row(&mut self, line: &str) -> Result<(), Failure> {
        if self.next >= self.head.rows {
            return rejected(&format!("the table has {} rows, and here is another", self.head.rows));
        }
        self.work.read(line.len());
        let row = text::row(line)?;
        if row.row != self.next {
            return rejected(&format!("row {} stands where row {} belongs", row.row, self.next));
        }
        self.axes.matches(&row)?;
        let ratio = self.axes.ratio()?;
        match self.head.quantity {
            Quantity::BestN => best_cell(&row, ratio, &self.axes.restitution()?, &self.work)?,
            Quantity::Eta => {
                let cell = Cell::Eta(ratio, self.axes.restitution()?, self.axes.inserted(0)? + 1u32);
                self.real(&row, &cell)?;
            }
            Quantity::Threshold => self.real(&row, &Cell::Threshold(ratio, self.axes.inserted(1)?))?,
        }
        self.next += 1;
        self.axes.advance(&self.work)
    }

    fn real(&self, row: &Row<'_>, cell: &Cell) -> Result<(), Failure> {
        let (Some(digits), Some(rounding)) = (self.head.digits, self.head.rounding) else {
            return rejected("the head says neither digits nor rounding");
        };
        if row.tie.is_some() {
            return rejected("ties are of numbers of bodies");
        }
        let (Some(lower), Some(upper)) = (&row.lower, &row.upper) else { return rejected("the enclosure is missing") };
        let enclosure = Interval { lo: lower.clone(), hi: upper.clone() };
        if enclosure.lo.compare(&enclosure.hi)? == Ordering::Greater {
            return rejected("the enclosure is empty");
        }
        match cell.form(&self.work)? {
            Form::Exact(value) => exact_cell(row, &value, &enclosure, digits, rounding, &self.work),
            form => enclosed_cell(row, cell, matches!(form, Form::Long), &enclosure, digits, rounding, &self.work),
        }
    }

    /// The table, if all its rows were there.
    pub fn finish(self) -> Result<AcceptedTable, Failure> {
        if self.next != self.head.rows {
            return rejected(&format!("the file ends after {} of {} rows", self.next, self.head.rows));
        }
        let axes: String = self.axes.0.iter().map(Axis::described).collect();
        let rounding = rounding_in_words(&self.head)?.map(|words| words + "\n").unwrap_or_default();
        let statement = format!("{}\n{axes}{rounding}", formula(self.head.quantity).0);
        let rests_on: &[&str] = if self.head.quantity == Quantity::BestN { &["b-grow", "b-grow-bounded"] } else { &[] };
        Ok(AcceptedTable { rows: self.next, statement, rests_on })
    }
}

/// A value that is known exactly. The enclosure holds it, as fractions compare; the printed number is its rounding, and the
/// fraction beside it is the value, or too long to stand there.
fn exact_cell(
    row: &Row<'_>,
    value: &BigRational,
    enclosure: &Interval,
    digits: Digits,
    rounding: Rounding,
    work: &Work,
) -> Result<(), Failure> {
    for end in [&enclosure.lo, &enclosure.hi] {
        work.product(end.parts().0.bits(), value.denom().bits())?;
    }
    if enclosure.lo.compare_ratio(value)? == Ordering::Greater || enclosure.hi.compare_ratio(value)? == Ordering::Less {
        return rejected("the value does not lie in the enclosure");
    }
    // A digit holds fewer than four bits.
    let short = value.numer().bits() + value.denom().bits() <= 4 * 60;
    let exact = Some(value.to_string()).filter(|text| short && text.len() <= EXACT_LENGTH);
    if row.exact != exact.as_deref() {
        let wanted = exact.as_deref().unwrap_or("not shown");
        return rejected(&format!("the exact value is {wanted}, not {}", row.exact.unwrap_or("missing")));
    }
    same(row, &of_ratio(value, digits, rounding, work)?)
}

/// A value that is enclosed. The checker's own enclosure is narrowed until it lies inside that of the file, which then
/// holds the value, or beside it. Rounding is monotone: if both ends of the file's enclosure round to what is printed, so
/// does the value. A rational value too long to be multiplied out may stand where rounding jumps, as no irrational one
/// does; then the checker's own enclosure may settle the digits.
fn enclosed_cell(
    row: &Row<'_>,
    cell: &Cell,
    long: bool,
    enclosure: &Interval,
    digits: Digits,
    rounding: Rounding,
    work: &Work,
) -> Result<(), Failure> {
    if row.exact.is_some() {
        return rejected("the value is no short fraction");
    }
    let mut bits = first_bits(cell, enclosure)?;
    let own = loop {
        if let Some(own) = cell.enclosed(bits, work)? {
            if own.hi.compare(&enclosure.lo)? == Ordering::Less || own.lo.compare(&enclosure.hi)? == Ordering::Greater {
                return rejected("the value does not lie in the enclosure");
            }
            if own.lo.compare(&enclosure.lo)? != Ordering::Less && own.hi.compare(&enclosure.hi)? != Ordering::Greater {
                break own;
            }
        }
        bits *= 2;
    };
    let ends = |of: &Interval| -> Result<(String, String), Failure> {
        let end = |x, toward| of_end(x, digits, rounding, toward, work);
        Ok((end(&of.lo, Toward::Down)?, end(&of.hi, Toward::Up)?))
    };
    let (mut lower, mut upper) = ends(enclosure)?;
    if lower != upper && long {
        (lower, upper) = ends(&own)?;
        if lower != upper {
            return declined("digits of a long fraction");
        }
    }
    if lower != upper {
        return rejected(&format!("the digits do not follow from the enclosure: {lower} or {upper}"));
    }
    same(row, &lower)
}

/// About the bits that the checker's enclosure needs to fit into the file's.
fn first_bits(cell: &Cell, enclosure: &Interval) -> Result<u64, Failure> {
    let Interval { lo, hi } = enclosure;
    // Where the leading bits stand apart, the width is about the upper end.
    let width = if lo.is_zero() || hi.top().saturating_sub(lo.top()) > 1 { None } else { hi.minus(lo)? };
    let bits = match (cell, width.filter(|width| !width.is_zero())) {
        (_, None) => 64,
        (Cell::Eta(..), Some(width)) => hi.top().saturating_sub(width.top()),
        // L_n is computed beside 1.
        (Cell::Threshold(..), Some(width)) => width.top().saturating_neg(),
    };
    Ok(u64::try_from(bits).unwrap_or(0).max(32) + 12)
}

/// What is printed is what it should be, to the letter.
fn same(row: &Row<'_>, wanted: &str) -> Result<(), Failure> {
    if row.printed == wanted { Ok(()) } else { rejected(&format!("{} is printed, {wanted} is right", row.printed)) }
}

/// The best number of inserted bodies: how many `n >= 1` have `L_n <= e`. `L_n` rises with `n` (claim b-grow), so `n*` of
/// them have iff `L_(n*) <= e < L_(n*+1)`. One body fewer does as well iff `e = L_(n*)`.
///
/// With `e = 1` there is nothing to compare: `L_n <= 1` for all `n` (claim b-grow-bounded), so that infinitely many are
/// counted; for equal masses `L_n = 1 = e`, so that no number is better than another.
fn best_cell(row: &Row<'_>, ratio: BigRational, e: &BigRational, work: &Work) -> Result<(), Failure> {
    if row.lower.is_some() || row.upper.is_some() {
        return rejected("a number of bodies has no enclosure");
    }
    let (printed, exact, tie) = if e.is_one() {
        (if ratio.is_one() { "any" } else { "infinite" }, None, false)
    } else {
        // Before the digits are read, which takes time: a number of so many bits has a third as many digits at most.
        if row.printed.len() as u64 > value::COUNT_BITS / 3 {
            return declined("bits of a number of bodies");
        }
        let Some(count) = row.printed.parse::<BigUint>().ok().filter(|count| count.to_string() == row.printed) else {
            return rejected("the best number is a number in digits");
        };
        if count.bits() > value::COUNT_BITS {
            return declined("bits of a number of bodies");
        }
        let (before, after) = (count.clone(), &count + 1u32);
        let at =
            if count.is_zero() { Ordering::Less } else { Cell::Threshold(ratio.clone(), before).compare(e, work)? };
        if at == Ordering::Greater {
            return rejected(&format!("L_{count} is greater than e: the best number is smaller"));
        }
        if Cell::Threshold(ratio, after).compare(e, work)? != Ordering::Greater {
            return rejected(&format!("L_{} is not greater than e: the best number is greater", &count + 1u32));
        }
        (row.printed, Some(row.printed), at == Ordering::Equal)
    };
    if row.exact != exact {
        return rejected("the exact value is the number, where there is one");
    }
    if row.tie != Some(tie) {
        return rejected(if tie { "one body fewer does as well: a tie" } else { "there is no tie" });
    }
    same(row, printed)
}

/// The formula of a quantity with its number.
fn formula(quantity: Quantity) -> (&'static str, &'static str) {
    match quantity {
        Quantity::Eta => ("eta = (1 + e)^(2(n + 1)) r/(1 + r^(1/(n + 1)))^(2(n + 1)), r = m1/m2 = ratio", "(25)"),
        Quantity::Threshold => ("L_n = (1 + r^(1/(n + 1)))^(n + 1)/(1 + r^(1/n))^n - 1, r = m1/m2 = ratio", "(19)"),
        Quantity::BestN => ("n* = number of n >= 1 with L_n <= e, r = m1/m2 = ratio", "claim b-best, from (19)"),
    }
}

/// Digits and rounding in words; none for numbers of bodies.
fn rounding_in_words(head: &Head) -> Result<Option<String>, Failure> {
    let (digits, rounding) = match (head.quantity, head.digits, head.rounding) {
        (Quantity::BestN, None, None) => return Ok(None),
        (Quantity::Eta | Quantity::Threshold, Some(digits), Some(rounding)) => (digits, rounding),
        _ => return rejected("digits and a rounding belong to eta and L_n, and to them only"),
    };
    let count = match digits {
        Digits::Significant(1) => "1 significant digit".to_string(),
        Digits::Significant(count) => format!("{count} significant digits"),
        Digits::Places(1) => "1 place after the point".to_string(),
        Digits::Places(count) => format!("{count} places after the point"),
    };
    let rule = match rounding {
        Rounding::NearestEven => "to nearest, ties to even",
        Rounding::Up => "up",
        Rounding::Down => "down",
        Rounding::Zero => "towards zero",
        Rounding::Away => "away from zero",
    };
    Ok(Some(format!("{count}, {rule}")))
}

/// What the head has to say in words.
fn remarks(head: &Head) -> Result<Vec<(&'static str, String)>, Failure> {
    let (formula, number) = formula(head.quantity);
    let equation = format!("{number} of Ricardo & Lee 2015, inserted bodies of optimal mass");
    let mut list = vec![("formula", formula.to_string()), ("equation", equation)];
    if let Some(words) = rounding_in_words(head)? {
        list.push(("rounding", format!("{words}; every digit is certified")));
        list.push(("exact", format!("p/q where the value is rational, up to {EXACT_LENGTH} characters")));
    }
    Ok(list)
}
