//! The pictures.

use super::axes::Chart;
use super::scale::{Scale, Spread, from_zero, shares};
use super::shape::Colour;
use super::unclear::{NUMBER, Unclear};
use crate::chain::best::{Best, best};
use crate::chain::recollision::{MAY_WARN, WARNING};
use crate::chain::threshold::threshold;
use crate::chain::{ChainError, Positive, Restitution, Restitutions, transfer};
use crate::number::real::Real;
use crate::table::grid::decimal_or_fraction;
use crate::table::worksheet::{Entry, Worksheet};
use malachite::Rational;
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::rounding_modes::RoundingMode;

/// Points of a curve.
const POINTS: u32 = 240;
/// Bits of an enclosure whose middle is drawn.
const BITS: u64 = 64;
/// Places after the point that a number of a title may have.
const MOST_PLACES: i64 = 400;
/// What is not farther from 0 is not drawn.
const TINY: f64 = 1e-290;
/// The most curves of a picture: as many as there are colours.
pub const CURVES: usize = super::shape::PALETTE.len();

/// A curve through pairs of values.
type Curve = Vec<(f64, f64)>;

/// The middle of a narrow enclosure, to be drawn.
fn drawn(x: &Real) -> f64 {
    x.enclosure(BITS).guess_f64()
}

fn float(x: &Rational) -> f64 {
    f64::rounding_from(x, RoundingMode::Nearest).0
}

/// Ratios in equal steps of their logarithm from one to another; they are exact, wherever they fall.
fn ratios(from: &Positive, to: &Positive) -> Vec<Positive> {
    let (low, high) = (float(from.value()).ln(), float(to.value()).ln());
    let at = |k: u32| (low + (high - low) * f64::from(k) / f64::from(POINTS)).exp();
    let between = (1..POINTS).filter_map(|k| Positive::new(Rational::try_from(at(k)).ok()?).ok());
    std::iter::once(from.clone()).chain(between).chain(std::iter::once(to.clone())).collect()
}

fn bodies(n: u64) -> String {
    format!("n = {n}")
}

/// A number for a title or legend; a long one whose digits are mostly zeros as a multiple of a power of ten.
fn number(name: &'static str, value: &Rational) -> Result<String, Unclear> {
    let text = decimal_or_fraction(value);
    let characters = text.len();
    if characters <= NUMBER {
        return Ok(text);
    }
    let (mut scaled, mut exponent) = (value.clone(), 0i64);
    while *scaled.denominator_ref() != 1u32 && exponent > -MOST_PLACES {
        scaled *= Rational::from(10u32);
        exponent -= 1;
    }
    let whole = scaled.to_string();
    let digits = whole.trim_end_matches('0');
    exponent += whole.len() as i64 - digits.len() as i64;
    if digits.len() > NUMBER / 2 || *scaled.denominator_ref() != 1u32 {
        return Err(Unclear::Long { name, characters });
    }
    let factor = if digits == "1" { String::new() } else { format!("{digits}·") };
    Ok(format!("{factor}10^{{{}}}", exponent.to_string().replace('-', "−")))
}

/// A picture with a curve for each number, against the mass ratio.
fn of_ratio(
    title: &str,
    quantity: &str,
    (from, to): (&Positive, &Positive),
    numbers: &[u64],
    value: impl Fn(&Positive, u64) -> Result<Real, ChainError>,
) -> Result<Chart, Unclear> {
    let points = ratios(from, to);
    let curve = |n: &u64| points.iter().map(|r| Ok((float(r.value()), drawn(&value(r, *n)?)))).collect();
    let curves = numbers.iter().map(curve).collect::<Result<Vec<Curve>, ChainError>>()?;
    let mut chart = Chart::new(title, across(from, to), told_apart(&curves, quantity)?, true);
    for (place, (n, points)) in numbers.iter().zip(&curves).enumerate() {
        chart.curve(place, points);
        chart.legend_curve(place, &bodies(*n));
    }
    Ok(chart)
}

/// The scale of mass ratios.
fn across(from: &Positive, to: &Positive) -> Scale {
    Scale::logarithmic(float(from.value()), float(to.value()), "mass ratio m_{1}/m_{2}")
}

/// The scale on which curves of shares are told apart.
fn told_apart(curves: &[Curve], quantity: &str) -> Result<Scale, Unclear> {
    let values = || curves.iter().flatten().map(|p| p.1);
    if values().all(|value| value < TINY) {
        return Err(Unclear::Tiny);
    }
    if curves.len() > 1 && Spread::of(values()) == Spread::Flat {
        return Err(Unclear::Same);
    }
    let (from, to) = shares(curves);
    Ok(Scale::even(from, to, quantity))
}

/// eta against the mass ratio, a curve for each number of inserted bodies.
///
/// # Errors
/// [`Unclear`].
pub fn eta_of_ratio(from: &Positive, to: &Positive, e: &Restitution, numbers: &[u64]) -> Result<Chart, Unclear> {
    let title = format!("Energy handed on through n optimal bodies, e = {}", number("e", e.value())?);
    let all = Restitutions::Same(e.clone());
    of_ratio(&title, "η", (from, to), numbers, |ratio, n| transfer::optimal(ratio, &all, n))
}

/// The numbers from 0 to the greatest one at which eta is drawn: in even steps, and closer at the beginning, where it
/// changes.
fn counts(most: u64) -> Vec<u64> {
    let step = (most / u64::from(POINTS)).max(1);
    let mut list: Vec<u64> = (0..=most / step).map(|k| k * step).collect();
    let mut next = 1u64;
    while next < most {
        list.push(next);
        next = (next + 1).max(next.saturating_add(next / 12));
    }
    list.push(most);
    list
}

/// eta against the number of inserted bodies, a row of dots for each restitution, with the best one marked.
///
/// # Errors
/// [`Unclear`].
pub fn eta_of_number(ratio: &Positive, restitutions: &[Restitution], most: u64) -> Result<Chart, Unclear> {
    let most = most.max(1);
    let title = format!("The best number of inserted bodies, m_{{1}}/m_{{2}} = {}", number("m1/m2", ratio.value())?);
    let mut curves: Vec<Curve> = Vec::new();
    let mut labels = Vec::new();
    for e in restitutions {
        let all = Restitutions::Same(e.clone());
        let mut label = format!("e = {}", number("e", e.value())?);
        let mut found = None;
        if let Best::Finite { count, .. } = best(ratio, e)?.0 {
            found = u64::try_from(&count).ok().filter(|n| *n <= most);
            label.push_str(&format!(", n* = {count}"));
        }
        let mut counts = counts(most);
        counts.extend(found);
        counts.sort_unstable();
        counts.dedup();
        let share = |n: &u64| Ok((*n as f64, drawn(&transfer::optimal(ratio, &all, *n)?)));
        curves.push(counts.iter().map(share).collect::<Result<_, ChainError>>()?);
        labels.push((label, found));
    }
    let x = Scale::whole(0.0, most as f64, "number n of inserted bodies");
    let mut chart = Chart::new(&title, x, told_apart(&curves, "η")?, true);
    for (place, (points, (label, found))) in curves.iter().zip(&labels).enumerate() {
        chart.curve(place, points);
        if most <= 40 {
            points.iter().for_each(|p| chart.dot(place, p.0, p.1, true, 2.2));
        }
        if let Some((x, y)) = found.and_then(|n| points.iter().find(|p| p.0 == n as f64)) {
            chart.dot(place, *x, *y, false, 5.0);
        }
        chart.legend_curve(place, label);
    }
    if labels.iter().any(|(_, found)| found.is_some()) {
        chart.legend_dot(4, false, "n* (best)");
    }
    Ok(chart)
}

/// `L_n` against the mass ratio, a curve for each number.
///
/// # Errors
/// [`Unclear`].
pub fn thresholds(from: &Positive, to: &Positive, numbers: &[u64]) -> Result<Chart, Unclear> {
    of_ratio("Least restitution with which the n-th body helps", "L_{n}", (from, to), numbers, |ratio, n| {
        Ok(threshold(ratio, n)?)
    })
}

/// Areas of the map: `n* = 0`, `1`, … and the last one for all more.
const AREAS: u64 = 11;
/// Borders that all lie so close to an end of the restitutions cannot be seen there: their neighbourhood is drawn.
const CROWDED: f64 = 0.1;

/// The map of restitution and mass ratio, coloured by the best number of inserted bodies. Its borders are the
/// curves `e = L_n`.
///
/// # Errors
/// [`Unclear`].
pub fn map(from: &Positive, to: &Positive) -> Result<Chart, Unclear> {
    let points = ratios(from, to);
    let at = |r: &Positive| float(r.value());
    let border = |n: u64| points.iter().map(|r| Ok((at(r), drawn(&threshold(r, n)?)))).collect();
    let borders = (1..AREAS).map(border).collect::<Result<Vec<Curve>, ChainError>>()?;
    let (bottom, top) = match Spread::of(borders.iter().flatten().map(|p| p.1)) {
        Spread::Over(lo, hi) if hi < CROWDED || lo > 1.0 - CROWDED => shares(&borders),
        _ => (0.0, 1.0),
    };
    let (bottom, top) = (bottom.max(0.0), top.min(1.0));
    let y = Scale::even(bottom, top, "restitution e");
    let mut chart = Chart::new("Best number n* of inserted bodies", across(from, to), y, false);
    let level = |e: f64| points.iter().map(|r| (at(r), e)).collect::<Curve>();
    chart.legend_title("n*");
    for n in 0..AREAS {
        let lower = n.checked_sub(1).and_then(|k| borders.get(k as usize)).cloned().unwrap_or_else(|| level(bottom));
        // The next area covers what this one has too much: no gaps between neighbours.
        let mut area = lower.clone();
        area.extend(level(top).into_iter().rev());
        let colour = viridis(n as f64 / (AREAS - 1) as f64);
        chart.area(&area, colour);
        if n > 0 {
            chart.border(&lower);
        }
        chart.legend_area(colour, &if n + 1 == AREAS { format!("{n} or more") } else { n.to_string() });
    }
    Ok(chart)
}

/// The colours of the map `viridis`: even steps of lightness, from dark to light, also without colours.
fn viridis(share: f64) -> Colour {
    const STOPS: [(f64, f64, f64); 6] = [
        (68.0, 1.0, 84.0),
        (65.0, 68.0, 135.0),
        (42.0, 120.0, 142.0),
        (34.0, 168.0, 132.0),
        (122.0, 209.0, 81.0),
        (253.0, 231.0, 37.0),
    ];
    let place = share.clamp(0.0, 1.0) * (STOPS.len() - 1) as f64;
    let below = (place as usize).min(STOPS.len() - 2);
    let part = place - below as f64;
    let mix = |a: f64, b: f64| (a + (b - a) * part).round() as u8;
    let (a, b) = (STOPS[below], STOPS[below + 1]);
    Colour(mix(a.0, b.0), mix(a.1, b.1), mix(a.2, b.2))
}

/// The velocities of a chain's bodies: as each one is about to strike the next, and after the pass. Bars show what measured
/// inputs leave open. The axis names the unit, if there is one.
///
/// # Errors
/// [`Unclear`].
pub fn velocities(worksheet: &Worksheet, title: &str, unit: Option<&str>) -> Result<Chart, Unclear> {
    let collisions = &worksheet.collisions;
    let arriving: Vec<Bar> =
        collisions.iter().zip(1u32..).map(|(c, i)| Bar::of(i, &c.bodies[0].velocity.before)).collect();
    let after: Vec<Bar> = worksheet.velocities().into_iter().zip(1u32..).map(|(v, i)| Bar::of(i, v)).collect();
    let all = arriving.iter().chain(&after).flat_map(|bar| [bar.lo, bar.hi]);
    if all.clone().any(|v| v.is_nan() || v.abs() > 1e300) {
        return Err(Unclear::Outside);
    }
    let moves = arriving.iter().any(|bar| bar.middle() != 0.0);
    if moves && all.clone().all(|v| v.abs() < TINY) {
        return Err(Unclear::Tiny);
    }
    let (bottom, top) = from_zero(all, 0.08);
    let x = Scale::whole(0.5, after.len() as f64 + 0.5, "body");
    let axis = unit.map_or("velocity".to_owned(), |unit| format!("velocity ({unit})"));
    let mut chart = Chart::new(title, x, Scale::even(bottom, top, &axis), true);
    // Side by side where bars would cover one another.
    let measured = arriving.iter().chain(&after).any(|bar| bar.lo < bar.hi);
    for (place, bars) in [&arriving, &after].into_iter().enumerate() {
        let aside = if measured { [-0.08, 0.08][place] } else { 0.0 };
        for bar in bars {
            if bar.lo < bar.hi {
                chart.bar(place, bar.at + aside, (bar.lo, bar.hi));
            }
            chart.dot(place, bar.at + aside, bar.middle(), place == 1, 4.0);
        }
    }
    chart.legend_dot(0, false, "before it strikes");
    chart.legend_dot(1, true, "after the pass");
    match worksheet.again {
        Some(false) => {}
        Some(true) => chart.note(&format!("Note: {WARNING}.")),
        None => chart.note(&format!("Note: {MAY_WARN}.")),
    }
    Ok(chart)
}

/// A velocity of a body, or the range of it.
struct Bar {
    at: f64,
    lo: f64,
    hi: f64,
}

impl Bar {
    fn of(body: u32, entry: &Entry) -> Bar {
        let (lo, hi) = match entry {
            Entry::Number(x) => (drawn(x), drawn(x)),
            Entry::Between(range) => (float(range.lo()), float(range.hi())),
        };
        Bar { at: f64::from(body), lo, hi }
    }

    fn middle(&self) -> f64 {
        f64::midpoint(self.lo, self.hi)
    }
}
