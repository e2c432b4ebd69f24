//! Predict first, then compute, then compare.
//!
//! Contract: a box is ticked on the answer key only where exact numbers or enclosures decide it, for every value of measured
//! inputs; a question that they do not decide is not asked.

use super::setting::length;
use super::{Part, Style, Subject, Units, number};
use crate::number::NumberError;
use crate::number::decimal::{Decimal, Rounding, bits_of_digits};
use crate::table::worksheet::{Entry, Worksheet};
use malachite::Rational;
use malachite::base::num::basic::traits::{One, Two, Zero};
use std::cmp::Ordering;

/// More bodies than these are not listed.
const LISTED: usize = 8;

/// What pupils guess before they compute.
pub(crate) fn predictions(subject: &Subject<'_>, filled: bool) -> Vec<Part> {
    let asked = [fastest(subject.worksheet), backwards(subject), lost(subject), rise(subject)];
    let asked: Vec<(String, Vec<(String, bool)>)> = asked.into_iter().flatten().collect();
    if asked.is_empty() {
        return Vec::new();
    }
    let heading = if filled { "Predictions" } else { "Predict first" };
    let mut parts = vec![Part::Heading(heading.to_owned())];
    if !filled {
        parts.push(Part::Text("Tick your answers before you compute anything. Do not change them later.".to_owned()));
    }
    for (place, (ask, options)) in asked.into_iter().enumerate() {
        let options = options.into_iter().map(|(text, right)| (text, right && filled)).collect();
        parts.push(Part::Choice { ask: format!("{}. {ask}", place + 1), options });
    }
    parts
}

type Question = (String, Vec<(String, bool)>);

/// Which body is the fastest afterwards.
fn fastest(worksheet: &Worksheet) -> Option<Question> {
    let velocities = worksheet.velocities();
    if velocities.len() > LISTED {
        return None;
    }
    let size = |v: &Entry| {
        let (lo, hi) = v.bounds()?;
        let (a, b) = if lo >= 0u32 {
            (lo, hi)
        } else if hi <= 0u32 {
            (-hi, -lo)
        } else {
            (Rational::ZERO, (-lo).max(hi))
        };
        Some((a, b))
    };
    let sizes = velocities.iter().map(|v| size(v)).collect::<Option<Vec<_>>>()?;
    let top = (0..sizes.len()).find(|i| {
        let others = sizes.iter().enumerate().filter(|(j, _)| j != i);
        others.map(|(_, other)| other).all(|other| other.1 < sizes[*i].0)
    });
    let equal = sizes.iter().all(|size| size.0 == size.1 && *size == sizes[0]);
    if top.is_none() && !equal {
        return None;
    }
    let mut options: Vec<(String, bool)> =
        (0..sizes.len()).map(|i| (format!("body {}", i + 1), top == Some(i))).collect();
    options.push(("all are equally fast".to_owned(), equal));
    Some(("Which body will be the fastest after the last collision?".to_owned(), options))
}

/// Whether a body moves backwards.
fn backwards(subject: &Subject<'_>) -> Option<Question> {
    let zero = Entry::exact(&Rational::ZERO);
    let signs: Vec<Option<Ordering>> = subject.worksheet.velocities().iter().map(|v| v.compared(&zero)).collect();
    let some = signs.contains(&Some(Ordering::Less));
    // What may be zero or above is as good as known.
    let lowest = subject.worksheet.velocities().iter().map(|v| v.bounds()).collect::<Option<Vec<_>>>()?;
    let none = lowest.iter().all(|(lo, _)| *lo >= 0u32);
    if !some && !none {
        return None;
    }
    let way = if subject.drop.is_some() { "downwards" } else { "backwards" };
    let ask = format!("Will any body move {way} after its last collision?");
    Some((ask, vec![("yes".to_owned(), some), ("no".to_owned(), none)]))
}

/// The kinetic energy before the first collision, and what all collisions lose.
fn energies(worksheet: &Worksheet) -> Option<(Entry, Entry)> {
    let (first, rest) = worksheet.collisions.split_first()?;
    let before = rest.iter().fold(first.energy.before.clone(), |sum, c| sum.plus(&c.bodies[1].energy.before));
    let change = rest.iter().fold(first.energy.change.clone(), |sum, c| sum.plus(&c.energy.change));
    Some((before, change))
}

/// How much of the kinetic energy is lost.
fn lost(subject: &Subject<'_>) -> Option<Question> {
    let (before, change) = energies(subject.worksheet)?;
    let ((least, most), (lo, hi)) = (before.bounds()?, change.bounds()?);
    if least <= 0u32 {
        return None;
    }
    let quarter = Rational::ONE / Rational::from(4u32);
    let half = Rational::ONE / Rational::TWO;
    // The share lies between these.
    let (low, high) = (-hi / &most, -lo / &least);
    let right = [high == 0u32, low > 0u32 && high < quarter, low >= quarter && high <= half, low > half];
    if !right.contains(&true) {
        return None;
    }
    let options = ["none", "less than a quarter", "from a quarter to half", "more than half"];
    let ask = "How much of the kinetic energy will all collisions together turn into heat, sound and deformation?";
    let options = options.into_iter().zip(right).map(|(text, right)| (text.to_owned(), right)).collect();
    Some((ask.to_owned(), options))
}

/// To how many times the height the highest ball rises.
fn rise(subject: &Subject<'_>) -> Option<Question> {
    let rise = subject.drop?.rise().ok()?;
    let bounds = [0u32, 1, 2, 4].map(Rational::from);
    let [_, one, two, four] = &bounds;
    let (lo, hi) = (rise.lo(), rise.hi());
    let right = [hi <= one, lo > one && hi <= two, lo > two && hi <= four, lo > four];
    if !right.contains(&true) {
        return None;
    }
    let options = ["no higher than it was dropped", "up to twice as high", "two to four times as high", "higher still"];
    let options = options.into_iter().zip(right).map(|(text, right)| (text.to_owned(), right)).collect();
    Some(("How high will the highest ball rise?".to_owned(), options))
}

/// A sum of entries; `None` where one narrow enclosure does not settle the digits of an irrational one, which may be a tie.
fn sum(entry: &Entry, style: Style) -> Option<String> {
    match entry {
        Entry::Number(x) if x.as_rational().is_none() => {
            let enclosure = x.enclosure(bits_of_digits(style.digits.count()) + 128);
            Some(Decimal::of_interval(&enclosure, style.digits, Rounding::Nearest)?.to_string())
        }
        entry => number(entry, style).ok(),
    }
}

/// The questions after the computation: sums, and a comparison with the predictions.
pub(super) fn comparison(
    subject: &Subject<'_>,
    units: &Units,
    style: Style,
    filled: bool,
) -> Result<Vec<Part>, NumberError> {
    let Some((first, rest)) = subject.worksheet.collisions.split_first() else { return Ok(Vec::new()) };
    let with = |entry: &Entry, unit: &Option<String>| -> Option<String> {
        let unit = unit.as_deref().map_or(String::new(), |unit| format!(" {unit}"));
        Some(format!("{}{unit}", sum(entry, style)?))
    };
    let momentum = rest.iter().fold(first.momentum.before.clone(), |sum, c| sum.plus(&c.bodies[1].momentum.before));
    let ask =
        "Add the momenta of all bodies before the first collision, and again after the last one. What do you find?";
    let answer =
        with(&momentum, &units.momentum).map(|p| format!("{p} both times: the total momentum does not change."));
    let mut asked: Vec<(&str, String)> = answer.map(|answer| (ask, answer)).into_iter().collect();
    if let Some((before, change)) = energies(subject.worksheet) {
        let answer = match change.bounds() {
            Some((lo, hi)) if lo == 0u32 && hi == 0u32 => Some("None: every collision is elastic.".to_owned()),
            _ => {
                let (lost, before) = (with(&change.negated(), &units.energy), with(&before, &units.energy));
                lost.zip(before).map(|(lost, before)| format!("{lost} of {before}."))
            }
        };
        let ask = "How much kinetic energy do all collisions together turn into other forms?";
        asked.extend(answer.map(|answer| (ask, answer)));
    }
    if let Some(drop) = subject.drop
        && let Ok(rise) = drop.rise()
    {
        let height = match drop.rises_to() {
            Ok(Some(to)) => format!(", which is {}", length(subject.about, to.lo(), to.hi(), style.digits)?),
            _ => String::new(),
        };
        let answer = format!("To {} times the height of its fall{height}.", number(&Entry::range(rise), style)?);
        asked.push(("How high does the highest ball rise? A ball of speed v rises to the height that it fell from; the height grows with the square of the speed.", answer));
    }
    let mut parts = vec![Part::Heading("Compare".to_owned())];
    for (place, (ask, answer)) in asked.into_iter().enumerate() {
        parts.push(Part::Open { ask: format!("{}. {ask}", place + 1), answer: filled.then_some(answer), lines: 1 });
    }
    if !filled {
        let ask = "Which of your predictions were right? Explain one that was not.".to_owned();
        parts.push(Part::Open { ask: format!("{}. {ask}", parts.len()), answer: None, lines: 3 });
    }
    Ok(parts)
}
