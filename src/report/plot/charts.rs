//! The pictures.

use super::axes::{Chart, Scale};
use super::shape::{Anchor, Colour, Page};
use crate::chain::best::{Best, best};
use crate::chain::recollision::WARNING;
use crate::chain::threshold::threshold;
use crate::chain::{ChainError, Positive, Restitution, Restitutions, transfer};
use crate::number::real::Real;
use crate::table::grid::decimal_or_fraction;
use crate::table::worksheet::Worksheet;
use malachite::Rational;
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::rounding_modes::RoundingMode;

/// Points of a curve.
const POINTS: u32 = 240;
/// Bits of an enclosure whose middle is drawn.
const BITS: u64 = 64;
/// The most curves of a picture: as many as there are colours.
pub const CURVES: usize = super::shape::PALETTE.len();

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
    (0..=POINTS).filter_map(|k| Positive::new(Rational::try_from(at(k)).ok()?).ok()).collect()
}

fn ends(from: &Positive, to: &Positive) -> (f64, f64) {
    (float(from.value()), float(to.value()))
}

fn bodies(n: u64) -> String {
    format!("n = {n}")
}

/// eta against the mass ratio, a curve for each number of inserted bodies.
///
/// # Errors
/// A limit.
pub fn eta_of_ratio(from: &Positive, to: &Positive, e: &Restitution, numbers: &[u64]) -> Result<Page, ChainError> {
    let title = format!("Energy handed on through n optimal bodies, e = {}", decimal_or_fraction(e.value()));
    let (low, high) = ends(from, to);
    let mut chart =
        Chart::new(&title, Scale::logarithmic(low, high, "mass ratio m_{1}/m_{2}"), Scale::even(0.0, 1.0, "η"), true);
    let all = Restitutions::Same(e.clone());
    for (place, n) in numbers.iter().enumerate() {
        let points: Result<Vec<_>, ChainError> =
            ratios(from, to).iter().map(|r| Ok((float(r.value()), drawn(&transfer::optimal(r, &all, *n)?)))).collect();
        chart.curve(place, &points?);
        chart.legend_curve(place, &bodies(*n));
    }
    Ok(chart.finish())
}

/// eta against the number of inserted bodies, a row of dots for each restitution, with the best one marked.
///
/// # Errors
/// A limit.
pub fn eta_of_number(ratio: &Positive, restitutions: &[Restitution], most: u64) -> Result<Page, ChainError> {
    let title = format!("The best number of inserted bodies, m_{{1}}/m_{{2}} = {}", decimal_or_fraction(ratio.value()));
    let mut chart = Chart::new(
        &title,
        Scale::whole(0.0, most.max(1) as f64, "number n of inserted bodies"),
        Scale::even(0.0, 1.0, "η"),
        true,
    );
    let step = (most / POINTS as u64).max(1);
    for (place, e) in restitutions.iter().enumerate() {
        let all = Restitutions::Same(e.clone());
        let share = |n: u64| Ok::<_, ChainError>((n as f64, drawn(&transfer::optimal(ratio, &all, n)?)));
        let points = (0..=most / step).map(|k| share(k * step)).collect::<Result<Vec<_>, _>>()?;
        chart.curve(place, &points);
        if most <= 40 {
            points.iter().for_each(|p| chart.dot(place, p.0, p.1, true, 2.2));
        }
        let mut label = format!("e = {}", decimal_or_fraction(e.value()));
        if let Best::Finite { count, .. } = best(ratio, e)?.0 {
            if let Some(n) = u64::try_from(&count).ok().filter(|n| *n <= most) {
                let (x, y) = share(n)?;
                chart.dot(place, x, y, false, 5.0);
            }
            label.push_str(&format!(", n* = {count}"));
        }
        chart.legend_curve(place, &label);
    }
    chart.legend_dot(4, false, "n* (best)");
    Ok(chart.finish())
}

/// `L_n` against the mass ratio, a curve for each number.
///
/// # Errors
/// A limit.
pub fn thresholds(from: &Positive, to: &Positive, numbers: &[u64]) -> Result<Page, ChainError> {
    let (low, high) = ends(from, to);
    let mut chart = Chart::new(
        "Least restitution with which the n-th body helps",
        Scale::logarithmic(low, high, "mass ratio m_{1}/m_{2}"),
        Scale::even(0.0, 1.0, "L_{n}"),
        true,
    );
    for (place, n) in numbers.iter().enumerate() {
        let points: Result<Vec<_>, ChainError> =
            ratios(from, to).iter().map(|r| Ok((float(r.value()), drawn(&threshold(r, *n)?)))).collect();
        chart.curve(place, &points?);
        chart.legend_curve(place, &bodies(*n));
    }
    Ok(chart.finish())
}

/// Areas of the map: `n* = 0`, `1`, … and the last one for all more.
const AREAS: u64 = 11;

/// The map of restitution and mass ratio, coloured by the best number of inserted bodies. Its borders are the
/// curves `e = L_n`.
///
/// # Errors
/// A limit.
pub fn map(from: &Positive, to: &Positive) -> Result<Page, ChainError> {
    let (low, high) = ends(from, to);
    let x = Scale::logarithmic(low, high, "mass ratio m_{1}/m_{2}");
    let mut chart = Chart::new("Best number n* of inserted bodies", x, Scale::even(0.0, 1.0, "restitution e"), false);
    let points = ratios(from, to);
    let at = |r: &Positive| float(r.value());
    let mut lower: Vec<(f64, f64)> = points.iter().map(|r| (at(r), 0.0)).collect();
    chart.legend_title("n*");
    for n in 0..AREAS {
        let last = n + 1 == AREAS;
        let upper = points.iter().map(|r| Ok((at(r), if last { 1.0 } else { drawn(&threshold(r, n + 1)?) })));
        let upper = upper.collect::<Result<Vec<_>, ChainError>>()?;
        // The next area covers what this one has too much: no gaps between neighbours.
        let mut area: Vec<(f64, f64)> = lower.clone();
        area.extend(points.iter().rev().map(|r| (at(r), 1.0)));
        let colour = viridis(n as f64 / (AREAS - 1) as f64);
        chart.area(&area, colour);
        if n > 0 {
            chart.border(&lower);
        }
        chart.legend_area(colour, &if last { format!("{n} or more") } else { n.to_string() });
        lower = upper;
    }
    Ok(chart.finish())
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

/// The velocities of a chain's bodies: as each one is about to strike the next, and after the pass.
#[must_use]
pub fn velocities(worksheet: &Worksheet, title: &str) -> Page {
    let mut arriving = Vec::new();
    let mut after = Vec::new();
    for (place, collision) in worksheet.collisions.iter().enumerate() {
        let number = (place + 1) as f64;
        arriving.push((number, drawn(&collision.bodies[0].velocity.before)));
        after.push((number, drawn(&collision.bodies[0].velocity.after)));
    }
    if let Some(last) = worksheet.collisions.last() {
        after.push((worksheet.collisions.len() as f64 + 1.0, drawn(&last.bodies[1].velocity.after)));
    }
    let all = || arriving.iter().chain(&after).map(|p: &(f64, f64)| p.1);
    let (low, high) = (all().fold(0.0, f64::min), all().fold(0.0, f64::max));
    // Room above for the note.
    let share = if worksheet.again { 0.16 } else { 0.08 };
    let margin = (high - low).max(f64::MIN_POSITIVE) * share;
    let bottom = if low < 0.0 { low - margin } else { 0.0 };
    let x = Scale::whole(0.5, after.len() as f64 + 0.5, "body");
    let mut chart = Chart::new(title, x, Scale::even(bottom, high + margin, "velocity"), true);
    for (place, points) in [&arriving, &after].into_iter().enumerate() {
        chart.curve(place, points);
        points.iter().for_each(|p| chart.dot(place, p.0, p.1, place == 1, 4.0));
    }
    chart.legend_dot(0, false, "before it strikes");
    chart.legend_dot(1, true, "after the pass");
    if worksheet.again {
        let at = chart.at(0.5, high + margin);
        chart.text((at.0 + 6.0, at.1 + 16.0), &format!("Note: {WARNING}."), Anchor::Start);
    }
    chart.finish()
}
