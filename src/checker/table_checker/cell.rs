//! The rules for one cell: its value lies in the enclosure, and the printed digits follow.

use super::dyadic::{Interval, Toward};
use super::failure::{Failure, declined, rejected};
use super::rounding::{Digits, Rounding, of_end, of_ratio};
use super::text::Row;
use super::value::{self, Cell};
use super::work::Work;
use num_bigint::BigUint;
use num_rational::BigRational;
use num_traits::{One, Zero};
use std::cmp::Ordering;

/// The longest fraction that a table shows beside a value, in characters.
pub(super) const EXACT_LENGTH: usize = 60;

/// A value that is known exactly. The enclosure holds it, as fractions compare; the printed number is its rounding, and the
/// fraction beside it is the value, or too long to stand there.
pub(super) fn exact_cell(
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
pub(super) fn enclosed_cell(
    row: &Row<'_>,
    cell: &Cell,
    long: bool,
    enclosure: &Interval,
    digits: Digits,
    rounding: Rounding,
    work: &Work,
) -> Result<(), Failure> {
    if row.exact.is_some() {
        return rejected("the exact value is not a short fraction");
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
        return rejected(&format!("the enclosure does not determine the digits: {lower} or {upper}"));
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
    if row.printed == wanted {
        Ok(())
    } else {
        rejected(&format!("the file has {}, the right value is {wanted}", row.printed))
    }
}

/// The best number of inserted bodies: how many `n >= 1` have `L_n <= e`. `L_n` rises with `n` (claim b-grow), so `n*` of
/// them have iff `L_(n*) <= e < L_(n*+1)`. One body fewer does as well iff `e = L_(n*)`.
///
/// With `e = 1` there is nothing to compare: `L_n <= 1` for all `n` (claim b-grow-bounded), so that infinitely many are
/// counted; for equal masses `L_n = 1 = e`, so that no number is better than another.
pub(super) fn best_cell(row: &Row<'_>, ratio: BigRational, e: &BigRational, work: &Work) -> Result<(), Failure> {
    if row.lower.is_some() || row.upper.is_some() {
        return rejected("a number of bodies must not have an enclosure");
    }
    let (printed, exact, tie) = if e.is_one() {
        (if ratio.is_one() { "any" } else { "infinite" }, None, false)
    } else {
        // Before the digits are read, which takes time: a number of so many bits has a third as many digits at most.
        if row.printed.len() as u64 > value::COUNT_BITS / 3 {
            return declined("bits of a number of bodies");
        }
        let Some(count) = row.printed.parse::<BigUint>().ok().filter(|count| count.to_string() == row.printed) else {
            return rejected("the best number must be in decimal digits");
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
        return rejected("the exact value must be the number itself");
    }
    if row.tie != Some(tie) {
        return rejected(if tie { "this is a tie: one body fewer does as well" } else { "this is not a tie" });
    }
    same(row, printed)
}
