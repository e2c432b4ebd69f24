//! Predict first, then compute, then compare.
//!
//! Contract: a box is ticked on the answer key only where exact numbers or enclosures decide it, for every value of measured
//! inputs; a question that they do not decide is not asked. A question about the end is answered by the velocities after all
//! collisions; where bodies meet again and nothing more is known, and where balls fall, the question names its moment instead.

use super::setting::{bodies, length};
use super::{Expected, Number, Part, Style, Subject, Units, number};
use crate::number::NumberError;
use crate::number::decimal::{Decimal, Rounding, bits_of_digits};
use crate::report::drop::rises_for_good;
use crate::scene::versions::shuffled;
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

/// So many questions of the stock are on a version.
const ASKED: usize = 3;
/// So many questions of the stock are on a sheet without versions, if they are decided: the first ones.
const USUAL: usize = 4;

/// All questions, each where the numbers of this sheet decide it.
fn stock(subject: &Subject<'_>, moment: &Moment) -> [Option<Question>; 11] {
    [
        fastest(subject, moment),
        backwards(subject, moment),
        lost(subject),
        rise(subject),
        way_of_first(subject, moment),
        slowest(subject, moment),
        most_energy(subject, moment),
        at_rest(subject, moment),
        faster_than_first(subject, moment),
        velocity_changes(subject),
        momentum_changes(subject),
    ]
}

/// Which questions of the stock each version asks: those that were asked longest ago, in the order that the seed gives. So two
/// neighbours have none in common where enough of them are decided.
pub(super) fn drawn(subjects: &[Subject<'_>], seed: u64) -> Vec<Vec<usize>> {
    let mut order: Vec<usize> = Vec::new();
    let mut one = |subject: &Subject<'_>| {
        let decided = stock(subject, &moment(subject)).map(|question| question.is_some());
        if order.is_empty() {
            order = shuffled(seed, decided.len());
        }
        let now: Vec<usize> = order.iter().copied().filter(|kind| decided[*kind]).take(ASKED).collect();
        order.retain(|kind| !now.contains(kind));
        order.extend(&now);
        now
    };
    subjects.iter().map(&mut one).collect()
}

/// What pupils guess before they compute.
pub(crate) fn predictions(subject: &Subject<'_>, filled: bool) -> Vec<Part> {
    let stock = stock(subject, &moment(subject));
    let asked: Vec<Question> = match subject.asked {
        None => stock.into_iter().take(USUAL).flatten().collect(),
        Some(kinds) => kinds.iter().filter_map(|kind| stock.get(*kind).cloned().flatten()).collect(),
    };
    if asked.is_empty() {
        return Vec::new();
    }
    let heading = if filled { "Predictions" } else { "Predict first" };
    let mut parts = vec![Part::Heading(heading.to_owned())];
    if !filled {
        parts.push(Part::Text("Tick your answers before you compute anything. Do not change them later.".to_owned()));
    }
    for (place, (ask, options)) in asked.into_iter().enumerate() {
        let right = options.iter().position(|option| option.1);
        let options = options.into_iter().map(|(text, right)| (text, right && filled)).collect();
        parts.push(Part::Choice { ask: format!("{}. {ask}", place + 1), options, right });
    }
    parts
}

type Question = (String, Vec<(String, bool)>);

/// The answer `right` among several.
fn choice<const N: usize>(ask: String, options: [&str; N], right: usize) -> Question {
    (ask, options.iter().enumerate().map(|(place, text)| ((*text).to_owned(), place == right)).collect())
}

/// The bounds of the absolute value of an entry.
fn size(v: &Entry) -> Option<(Rational, Rational)> {
    let (lo, hi) = v.bounds()?;
    Some(if lo >= 0u32 {
        (lo, hi)
    } else if hi <= 0u32 {
        (-hi, -lo)
    } else {
        (Rational::ZERO, (-lo).max(hi))
    })
}

/// Whether a size is greater than another one, by a hundredth at least, so that the rounded numbers show it.
fn visibly_greater(a: &(Rational, Rational), b: &(Rational, Rational)) -> bool {
    &b.1 * Rational::from_unsigneds(101u32, 100u32) < a.0
}

/// Which size is the greatest, or the least: `Some(None)` where all are equal, `None` where the numbers leave it open.
fn extreme(sizes: &[(Rational, Rational)], greatest: bool) -> Option<Option<usize>> {
    let beyond = |i: usize, j: usize| {
        let (great, small) = if greatest { (i, j) } else { (j, i) };
        visibly_greater(&sizes[great], &sizes[small])
    };
    let found = (0..sizes.len()).find(|i| (0..sizes.len()).all(|j| j == *i || beyond(*i, j)));
    let equal = sizes.iter().all(|size| size.0 == size.1 && *size == sizes[0]);
    if found.is_none() && !equal { None } else { Some(found) }
}

/// A question for one of the bodies, or for all alike.
fn one_body(ask: String, bodies: usize, found: Option<usize>, all: &str) -> Question {
    let mut options: Vec<(String, bool)> = (0..bodies).map(|i| (format!("body {}", i + 1), found == Some(i))).collect();
    options.push((all.to_owned(), found.is_none()));
    (ask, options)
}

/// The speeds of all bodies, where they are few enough to be listed and where the table tells how they move.
fn speeds(subject: &Subject<'_>, moment: &Moment) -> Option<Vec<(Rational, Rational)>> {
    if moment.velocities.len() > LISTED || may_stay_down(subject) {
        return None;
    }
    moment.velocities.iter().map(size).collect()
}

/// Which body is the fastest afterwards.
fn fastest(subject: &Subject<'_>, moment: &Moment) -> Option<Question> {
    let speeds = speeds(subject, moment)?;
    let found = extreme(&speeds, true)?;
    let ask = format!("Which body will be the fastest {}?", moment.words);
    Some(one_body(ask, speeds.len(), found, "all are equally fast"))
}

/// Which body is the slowest afterwards.
fn slowest(subject: &Subject<'_>, moment: &Moment) -> Option<Question> {
    let speeds = speeds(subject, moment)?;
    let found = extreme(&speeds, false)?;
    let ask = format!("Which body will be the slowest {}?", moment.words);
    Some(one_body(ask, speeds.len(), found, "all are equally fast"))
}

/// Which body has the most kinetic energy afterwards.
fn most_energy(subject: &Subject<'_>, moment: &Moment) -> Option<Question> {
    let speeds = speeds(subject, moment)?;
    let masses = bodies(subject.worksheet).map(|body| body.mass.bounds()).collect::<Option<Vec<_>>>()?;
    let twice =
        |((lo, hi), (least, most)): (&(Rational, Rational), &(Rational, Rational))| (least * lo * lo, most * hi * hi);
    let energies: Vec<(Rational, Rational)> = speeds.iter().zip(&masses).map(twice).collect();
    let found = extreme(&energies, true)?;
    let ask = format!("Which body will have the most kinetic energy {}?", moment.words);
    Some(one_body(ask, energies.len(), found, "all have equally much"))
}

/// Which way the first body moves afterwards.
fn way_of_first(subject: &Subject<'_>, moment: &Moment) -> Option<Question> {
    let way =
        moment.velocities.first()?.compared(&Entry::exact(&Rational::ZERO)).filter(|_| !may_stay_down(subject))?;
    let options = if subject.drop.is_some() {
        ["upwards", "downwards", "not at all"]
    } else {
        ["to the right", "to the left", "not at all"]
    };
    let right = match way {
        Ordering::Greater => 0,
        Ordering::Less => 1,
        Ordering::Equal => 2,
    };
    Some(choice(format!("Which way will body 1 move {}?", moment.words), options, right))
}

/// Whether a body is at rest afterwards.
fn at_rest(subject: &Subject<'_>, moment: &Moment) -> Option<Question> {
    let zero = Entry::exact(&Rational::ZERO);
    let known: Vec<Option<Ordering>> = moment.velocities.iter().map(|v| v.compared(&zero)).collect();
    let some = known.contains(&Some(Ordering::Equal));
    if may_stay_down(subject) || !some && known.contains(&None) {
        return None;
    }
    Some(choice(format!("Will any body be at rest {}?", moment.words), ["yes", "no"], usize::from(!some)))
}

/// Whether the last body becomes faster than the first one was.
fn faster_than_first(subject: &Subject<'_>, moment: &Moment) -> Option<Question> {
    if may_stay_down(subject) {
        return None;
    }
    let (first, last) = (size(&bodies(subject.worksheet).next()?.velocity.before)?, size(moment.velocities.last()?)?);
    let right = match extreme(&[last, first], true)? {
        Some(0) => 0,
        Some(_) => 1,
        None => 2,
    };
    let number = moment.velocities.len();
    let ask = format!("How fast will body {number} be {}, compared with body 1 at the start?", moment.words);
    Some(choice(ask, ["faster", "slower", "equally fast"], right))
}

/// Which body's velocity changes more in the first collision.
fn velocity_changes(subject: &Subject<'_>) -> Option<Question> {
    let [a, b] = &subject.worksheet.collisions.first().filter(|_| !may_stay_down(subject))?.bodies;
    let found = extreme(&[size(&a.velocity.change)?, size(&b.velocity.change)?], true)?;
    let ask = "Whose velocity will change more in collision 1?".to_owned();
    Some(one_body(ask, 2, found, "both change equally"))
}

/// Which body's momentum changes more in the first collision: it is never one of them.
fn momentum_changes(subject: &Subject<'_>) -> Option<Question> {
    let change = &subject.worksheet.collisions.first().filter(|_| !may_stay_down(subject))?.momentum.change;
    let conserved = change.compared(&Entry::exact(&Rational::ZERO)) == Some(Ordering::Equal);
    let ask = "Whose momentum will change more in collision 1?".to_owned();
    conserved.then(|| one_body(ask, 2, None, "both change equally"))
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

/// A question after the computation.
struct Asked {
    ask: String,
    answer: String,
    numbers: Vec<Number>,
}

/// A number that a question asks for, and its text on the key.
fn asked_for(name: &str, unit: Option<&str>, entry: &Entry, printed: &str, style: Style) -> Number {
    let label = unit.map_or_else(|| name.to_owned(), |unit| format!("{name} ({unit})"));
    Number { label, expected: Expected::of(entry, printed, style.digits) }
}

/// How it ends, where bodies meet again: the question and the answer.
fn end(later: &Later, collisions: usize, units: &Units, style: Style) -> Option<Asked> {
    let entries: Vec<Entry> = later.velocities.iter().map(Entry::exact).collect();
    let velocities = entries.iter().map(|v| number(v, style).ok()).collect::<Option<Vec<String>>>()?;
    let one = |(place, (entry, printed)): (usize, (&Entry, &String))| {
        asked_for(&format!("body {}", place + 1), units.velocity.as_deref(), entry, printed, style)
    };
    let numbers = entries.iter().zip(&velocities).enumerate().map(one).collect();
    let velocities = velocities.join(", ");
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
    let answer = format!("{then} In the end the velocities are {velocities}{unit}: no body catches up with another.");
    Some(Asked { ask, answer, numbers })
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
    let with = |printed: &str, unit: &Option<String>| match unit {
        Some(unit) => format!("{printed} {unit}"),
        None => printed.to_owned(),
    };
    let momentum = rest.iter().fold(first.momentum.before.clone(), |sum, c| sum.plus(&c.bodies[1].momentum.before));
    let last = subject.worksheet.collisions.len();
    let mut asked: Vec<Asked> = Vec::new();
    if let Some(printed) = sum(&momentum, style) {
        let ask = format!(
            "Add the momenta of all bodies before the first collision, and again after collision {last}. What do you find?"
        );
        let numbers = ["before", "after"]
            .map(|when| asked_for(&format!("momentum {when}"), units.momentum.as_deref(), &momentum, &printed, style));
        let answer = format!("{} both times: the total momentum does not change.", with(&printed, &units.momentum));
        asked.push(Asked { ask, answer, numbers: numbers.to_vec() });
    }
    if let Some((before, change)) = energies(subject.worksheet) {
        let ask = format!("How much kinetic energy is turned into other forms by {}?", which(subject));
        let unit = units.energy.as_deref();
        let lost = change.negated();
        if change.bounds().is_some_and(|(lo, hi)| lo == 0u32 && hi == 0u32) {
            let answer = format!("None: {} elastic.", if rest.is_empty() { "it is" } else { "each of them is" });
            asked.push(Asked { ask, answer, numbers: vec![asked_for("energy", unit, &lost, "0", style)] });
        } else if let Some((printed, all)) = sum(&lost, style).zip(sum(&before, style)) {
            let answer = format!("{} of {}.", with(&printed, &units.energy), with(&all, &units.energy));
            asked.push(Asked { ask, answer, numbers: vec![asked_for("energy", unit, &lost, &printed, style)] });
        }
    }
    // Where another ball hits it again, its rise after one pass is not how high it rises.
    if let Some(drop) = subject.drop.filter(|drop| rises_for_good(drop))
        && let Ok(rise) = drop.rise()
    {
        let height = match drop.rises_to() {
            Ok(Some(to)) => format!(", which is {}", length(subject.about, to.lo(), to.hi(), style.digits)?),
            _ => String::new(),
        };
        let rise = Entry::range(rise);
        let printed = number(&rise, style)?;
        let answer = format!("To {printed} times the height of its fall{height}.");
        let ask = "How high does the highest ball rise? A ball of speed v rises to the height that it fell from; the height grows with the square of the speed.".to_owned();
        asked.push(Asked {
            ask,
            answer,
            numbers: vec![asked_for("times the height of its fall", None, &rise, &printed, style)],
        });
    }
    asked.extend(subject.worksheet.later.as_ref().and_then(|later| end(later, last, units, style)));
    let mut parts = vec![Part::Heading("Compare".to_owned())];
    for (place, Asked { ask, answer, numbers }) in asked.into_iter().enumerate() {
        let (ask, answer) = (format!("{}. {ask}", place + 1), filled.then_some(answer));
        parts.push(Part::Open { ask, answer, numbers, lines: 1 });
    }
    if !filled {
        let ask = "Which of your predictions were right? Explain one that was not.".to_owned();
        let ask = format!("{}. {ask}", parts.len());
        parts.push(Part::Open { ask, answer: None, numbers: Vec::new(), lines: 3 });
    }
    Ok(parts)
}
