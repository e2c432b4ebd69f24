//! Predict first, then compute, then compare.
//!
//! Contract: a box is ticked on the answer key only where exact numbers or enclosures decide it, for every value of measured
//! inputs; a question that they do not decide is not asked. A question about the end is answered by the velocities after all
//! collisions; where bodies meet again and nothing more is known, and where balls fall, the question names its moment instead.

use super::setting::length;
use super::{Part, Style, Subject, Units, number};
use crate::number::NumberError;
use crate::number::decimal::{Decimal, Rounding, bits_of_digits};
use crate::report::drop::rises_for_good;
use crate::table::later::Later;
use crate::table::worksheet::{Entry, Worksheet};
use malachite::Rational;
use malachite::base::num::basic::traits::{One, Two, Zero};
use std::cmp::Ordering;

/// More bodies than these are not listed.
const LISTED: usize = 8;
/// More later collisions than these are counted only.
const NAMED: usize = 20;

/// When a question is about: the end, or a moment before bodies meet again.
struct Moment {
    velocities: Vec<Entry>,
    /// `after the last collision`, where there is one.
    words: String,
}

fn moment(subject: &Subject<'_>) -> Moment {
    let sheet = subject.worksheet;
    let pass = || sheet.velocities().into_iter().cloned().collect();
    match sheet.last_velocities() {
        _ if subject.drop.is_some() => {
            Moment { velocities: pass(), words: "right after the highest ball has been struck".to_owned() }
        }
        Some(velocities) => {
            let endless = sheet.later.as_ref().is_some_and(|later| later.pairs.is_none());
            let words = match sheet.collisions.len() {
                _ if endless => "in the end",
                1 => "after the collision",
                _ => "after the last collision",
            };
            Moment { velocities, words: words.to_owned() }
        }
        None => {
            let words = format!("right after collision {}", sheet.collisions.len());
            Moment { velocities: pass(), words }
        }
    }
}

/// What pupils guess before they compute.
pub(crate) fn predictions(subject: &Subject<'_>, filled: bool) -> Vec<Part> {
    let moment = moment(subject);
    let asked = [fastest(subject, &moment), backwards(subject, &moment), lost(subject), rise(subject)];
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
fn fastest(subject: &Subject<'_>, moment: &Moment) -> Option<Question> {
    let velocities = &moment.velocities;
    if velocities.len() > LISTED || may_stay_down(subject) {
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
    let sizes = velocities.iter().map(size).collect::<Option<Vec<_>>>()?;
    // By a hundredth, so that the rounded numbers show it.
    let visible = Rational::from_unsigneds(101u32, 100u32);
    let top = (0..sizes.len()).find(|i| {
        let others = sizes.iter().enumerate().filter(|(j, _)| j != i);
        others.map(|(_, other)| other).all(|other| &other.1 * &visible < sizes[*i].0)
    });
    let equal = sizes.iter().all(|size| size.0 == size.1 && *size == sizes[0]);
    if top.is_none() && !equal {
        return None;
    }
    let mut options: Vec<(String, bool)> =
        (0..sizes.len()).map(|i| (format!("body {}", i + 1), top == Some(i))).collect();
    options.push(("all are equally fast".to_owned(), equal));
    Some((format!("Which body will be the fastest {}?", moment.words), options))
}

/// Whether a body moves backwards.
fn backwards(subject: &Subject<'_>, moment: &Moment) -> Option<Question> {
    let zero = Entry::exact(&Rational::ZERO);
    let some = moment.velocities.iter().any(|v| v.compared(&zero) == Some(Ordering::Less));
    // What may be zero or above is as good as known.
    let lowest = moment.velocities.iter().map(Entry::bounds).collect::<Option<Vec<_>>>()?;
    let none = lowest.iter().all(|(lo, _)| *lo >= 0u32);
    if !some && !none || may_stay_down(subject) {
        return None;
    }
    let way = if subject.drop.is_some() { "downwards" } else { "backwards" };
    let ask = format!("Will any body move {way} {}?", moment.words);
    Some((ask, vec![("yes".to_owned(), some), ("no".to_owned(), none)]))
}

/// Whether the lowest ball may lie on the floor when it is struck: there it does not move as the table says.
fn may_stay_down(subject: &Subject<'_>) -> bool {
    subject.drop.is_some_and(|drop| *drop.floor().lo().value() == 0u32)
}

/// Which collisions the sheet computes: of balls that fall, there are more with the floor.
fn which(subject: &Subject<'_>) -> String {
    match (subject.drop, subject.worksheet.again, subject.worksheet.collisions.len()) {
        (None, Some(false), 1) => "the collision".to_owned(),
        (None, Some(false), _) => "all collisions together".to_owned(),
        (.., 1) => "collision 1".to_owned(),
        (.., count) => format!("collisions 1 to {count} together"),
    }
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
    let which = which(subject);
    let ask = format!("How much of the kinetic energy will {which} turn into heat, sound and deformation?");
    let options = options.into_iter().zip(right).map(|(text, right)| (text.to_owned(), right)).collect();
    Some((ask, options))
}

/// To how many times the height the highest ball rises.
fn rise(subject: &Subject<'_>) -> Option<Question> {
    let rise = subject.drop.filter(|drop| rises_for_good(drop))?.rise().ok()?;
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

/// How it ends, where bodies meet again: the question and the answer.
fn end(later: &Later, collisions: usize, units: &Units, style: Style) -> Option<(String, String)> {
    let velocities = later.velocities.iter().map(|v| number(&Entry::exact(v), style).ok());
    let velocities = velocities.collect::<Option<Vec<String>>>()?.join(", ");
    let unit = units.velocity.as_deref().map_or(String::new(), |unit| format!(" {unit}"));
    let ask = if later.pairs.is_some() { "Which ones, in which order?" } else { "How often?" };
    let ask = format!("Bodies meet again after collision {collisions}. {ask} How fast is each of them in the end?");
    let then = match &later.pairs {
        Some(pairs) if pairs.len() <= NAMED => {
            let pairs: Vec<String> = pairs.iter().map(|pair| format!("{pair}–{}", pair + 1)).collect();
            format!("Then these collide: {}.", pairs.join(", "))
        }
        Some(pairs) => format!("There are {} more collisions.", pairs.len()),
        None => "There are infinitely many more collisions, in a finite time.".to_owned(),
    };
    Some((ask, format!("{then} In the end the velocities are {velocities}{unit}: no body catches up with another.")))
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
    let last = subject.worksheet.collisions.len();
    let ask = format!(
        "Add the momenta of all bodies before the first collision, and again after collision {last}. What do you find?"
    );
    let answer =
        with(&momentum, &units.momentum).map(|p| format!("{p} both times: the total momentum does not change."));
    let mut asked: Vec<(String, String)> = answer.map(|answer| (ask, answer)).into_iter().collect();
    if let Some((before, change)) = energies(subject.worksheet) {
        let answer = match change.bounds() {
            Some((lo, hi)) if lo == 0u32 && hi == 0u32 => {
                Some(format!("None: {} elastic.", if rest.is_empty() { "it is" } else { "each of them is" }))
            }
            _ => {
                let (lost, before) = (with(&change.negated(), &units.energy), with(&before, &units.energy));
                lost.zip(before).map(|(lost, before)| format!("{lost} of {before}."))
            }
        };
        let which = which(subject);
        let ask = format!("How much kinetic energy is turned into other forms by {which}?");
        asked.extend(answer.map(|answer| (ask, answer)));
    }
    // Where another ball hits it again, its rise after one pass is not how high it rises.
    if let Some(drop) = subject.drop.filter(|drop| rises_for_good(drop))
        && let Ok(rise) = drop.rise()
    {
        let height = match drop.rises_to() {
            Ok(Some(to)) => format!(", which is {}", length(subject.about, to.lo(), to.hi(), style.digits)?),
            _ => String::new(),
        };
        let answer = format!("To {} times the height of its fall{height}.", number(&Entry::range(rise), style)?);
        asked.push(("How high does the highest ball rise? A ball of speed v rises to the height that it fell from; the height grows with the square of the speed.".to_owned(), answer));
    }
    asked.extend(subject.worksheet.later.as_ref().and_then(|later| end(later, last, units, style)));
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
