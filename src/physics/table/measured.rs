//! Worksheets of measured inputs: all values of each entry over the box of masses, coefficients and approach.
//!
//! **Contract.** Nothing outside of an entry is a value of it. The ends of a body's entries are attained up to a part of
//! `1/`[`EXCESS`] of their width where [`CUTS`] are enough, and exactly where its mass is exact and no measured coefficient is common
//! to several collisions. The energy of both bodies after their collision may be enclosed more widely.
//!
//! **Method.** Let a body of mass `m` arrive with `w` and keep the share `g = (m − e·b)/(m + b)` after it strikes the mass `b`.
//! For one `m` (and one `e`, where all collisions share it) `w` and `g` are independent, and both are known ([`Given`]). Each entry
//! is one expression in them, a change too: `m·w·(g − 1)`, never after minus before. Its range over `w` and `g` is exact for one
//! `m`; a range of `m` is cut where the entry is still enclosed too widely.

use super::worksheet::{BITS, Body, Change, Collision, Entry, MEASURED, Worksheet};
use crate::chain::uncertain::given::Given;
use crate::chain::uncertain::{Coefficients, Range, Reals};
use crate::chain::{ChainError, Positive, Restitution};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Square;
use malachite::base::num::basic::traits::{One, Two, Zero};
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::rounding_modes::RoundingMode;

/// So often the ranges of a chain of two bodies are cut at most; of more bodies the less often, for each cut costs more.
const CUTS: usize = 256;
/// The ranges of more bodies are not cut, so that a sheet of hundreds does not take many times as long.
const MANY: usize = 64;
/// An end that exceeds attained values by less than such a part of their width is not narrowed.
const EXCESS: f64 = 4096.0;

type Numbers = Range<Rational>;

/// From the frame in which the first body alone moves, with velocity 1, to the one that is shown: `v·speed + shift`.
pub(super) struct Frame {
    pub(super) speed: Numbers,
    pub(super) shift: Rational,
}

impl Frame {
    fn shown(&self, v: &Numbers) -> Numbers {
        v.times(&self.speed).plus(&Range::point(self.shift.clone()))
    }
}

/// The pass of bodies of which some mass, coefficient or the approach may be measured.
pub(super) fn worksheet(
    masses: &[Range<Positive>],
    coefficients: &Coefficients,
    frame: &Frame,
) -> Result<Worksheet, ChainError> {
    if *frame.speed.lo() <= Rational::ZERO {
        return Err(ChainError::NotAtRest);
    }
    let whole = Given::new(masses.to_vec(), coefficients.clone(), Rational::ONE, BITS)?;
    let after = whole.velocities()?.into_iter().map(ends).collect::<Result<Vec<_>, _>>()?;
    let losses = whole.losses()?.into_iter().map(ends).collect::<Result<Vec<_>, _>>()?;
    let square = frame.speed.times(&frame.speed);
    let pass = Pass { masses, coefficients, frame };
    let mut collisions = Vec::new();
    for (i, (loss, left)) in losses.iter().zip(&after).enumerate() {
        let Some(e) = coefficients.at(i) else { continue };
        let mut striker = pass.entries(i, Some(&masses[i + 1]))?;
        striker[1] = frame.shown(left);
        let struck = pass.entries(i + 1, None)?;
        let both = |place: usize| striker[place].plus(&struck[place]);
        let lost = loss.times(&square).scaled(&-Rational::ONE);
        let (before, after) = (both(6), both(7).meet(&both(6).plus(&lost)));
        let energy =
            if lost.single() == Some(&Rational::ZERO) { [before.clone(), before, lost] } else { [before, after, lost] };
        let momentum = [both(3), both(3), Range::point(Rational::ZERO)];
        let body = |place: usize, found: &[Numbers]| Body {
            number: place as u64 + 1,
            mass: Entry::range(plain(&masses[place], Positive::value)),
            velocity: change(&found[..3]),
            momentum: change(&found[3..6]),
            energy: change(&found[6..]),
        };
        collisions.push(Collision {
            e: Entry::range(plain(e, Restitution::value)),
            bodies: [body(i, &striker), body(i + 1, &struck)],
            momentum: change(&momentum),
            energy: change(&energy),
        });
    }
    // The last two have just struck each other and part.
    let pairs = || after[..masses.len() - 1].windows(2);
    let never = pairs().all(|pair| pair[0].hi() <= pair[1].lo());
    let always = pairs().any(|pair| pair[0].lo() > pair[1].hi());
    Ok(Worksheet { collisions, again: if never { Some(false) } else { always.then_some(true) }, later: None })
}

/// Bounds of given masses, which are rational.
fn ends(found: Reals) -> Result<Numbers, ChainError> {
    match (found.least.as_rational(), found.greatest.as_rational()) {
        (Some(lo), Some(hi)) => Range::new(lo.clone(), hi.clone()).map_err(|_| ChainError::NotAtRest),
        _ => Err(ChainError::Measured { quantity: MEASURED }),
    }
}

fn plain<T: Clone + PartialOrd>(range: &Range<T>, value: impl Fn(&T) -> &Rational) -> Numbers {
    let (lo, hi) = (value(range.lo()).clone(), value(range.hi()).clone());
    Range::new(lo.clone(), hi).unwrap_or_else(|_| Range::point(lo))
}

/// Before, after, and the change.
fn change(found: &[Numbers]) -> Change {
    let [before, after, change] = [0, 1, 2].map(|place| Entry::range(found[place].clone()));
    Change { before, after, change }
}

struct Pass<'a> {
    masses: &'a [Range<Positive>],
    coefficients: &'a Coefficients,
    frame: &'a Frame,
}

impl Pass<'_> {
    /// Velocity, momentum and energy of body `k` before a collision, after it and their changes: of the one with the mass in
    /// front that it strikes, or of the one in which it is struck.
    fn entries(&self, k: usize, front: Option<&Range<Positive>>) -> Result<Vec<Numbers>, ChainError> {
        let mut whole = vec![plain(&self.masses[k], Positive::value)];
        // A common coefficient acts on the arrival and on what is kept.
        let own = self.coefficients.at(k).filter(|_| front.is_some()).map(|e| plain(e, Restitution::value));
        let is_cut = k > 0 && self.coefficients.shared().is_some();
        whole.extend(own.clone().filter(|_| is_cut));
        let of = |piece: &[Numbers]| {
            let m = &piece[0];
            let e = piece.get(1);
            let w = self.arrival(k, m, e)?.times(&self.frame.speed);
            let kept = front.zip(e.or(own.as_ref())).map(|(front, e)| {
                let kept = |m: &Rational, b: &Positive, e: &Rational| (m - e * b.value()) / (m + b.value());
                Range::new(kept(m.lo(), front.hi(), e.hi()), kept(m.hi(), front.lo(), e.lo()))
            });
            let kept = kept.transpose().map_err(|_| ChainError::NotAtRest)?;
            Ok(values(m, &w, kept.as_ref(), &self.frame.shift))
        };
        let is_point = whole.iter().all(|range| range.single().is_some());
        over(whole, of, if is_point || self.masses.len() > MANY { 0 } else { 2 * CUTS / self.masses.len() })
    }

    /// The velocity with which body `k` of this mass arrives, or leaves when it is struck, where the first body moves with 1.
    fn arrival(&self, k: usize, m: &Numbers, e: Option<&Numbers>) -> Result<Numbers, ChainError> {
        if k == 0 {
            return Ok(Range::point(Rational::ONE));
        }
        let mut masses = self.masses[..k].to_vec();
        masses.push(m.clone().map(Positive::new)?);
        let coefficients = match (self.coefficients, e) {
            (Coefficients::Each(list), _) => Coefficients::Each(list.iter().take(k).cloned().collect()),
            (_, Some(e)) => Coefficients::Same(e.clone().map(Restitution::new)?),
            (same, None) => same.clone(),
        };
        ends(Given::new(masses, coefficients, Rational::ONE, BITS)?.last_velocity()?)
    }
}

/// The entries of a body of mass `m` that arrives with `w` and keeps the share `kept`, or leaves with `w` where it is struck.
fn values(m: &Numbers, w: &Numbers, kept: Option<&Numbers>, shift: &Rational) -> Vec<Numbers> {
    let moved = |v: &Numbers| v.plus(&Range::point(shift.clone()));
    let rest = Range::point(Rational::ZERO);
    let (before, after, change, squares) = match kept {
        None => (moved(&rest), moved(w), w.clone(), moved(w).square().plus(&Range::point(-shift.square()))),
        Some(g) => {
            let change = w.times(&g.plus(&Range::point(-Rational::ONE)));
            (moved(w), moved(&w.times(g)), change, difference(w, g, shift))
        }
    };
    let energy = |square: &Numbers| m.times(square).scaled(&(Rational::ONE / Rational::TWO));
    let momenta = [m.times(&before), m.times(&after), m.times(&change)];
    let energies = [energy(&before.square()), energy(&after.square()), energy(&squares)];
    [before, after, change].into_iter().chain(momenta).chain(energies).collect()
}

/// All values of `(w·g + s)² − (w + s)²` for `w > 0` and `−1 < g < 1`, exactly. In `g` it is convex, with its least value
/// where `w·g = −s`; in `w` it is concave, with its greatest where `w·(g + 1) = −s`.
fn difference(w: &Numbers, g: &Numbers, s: &Rational) -> Numbers {
    let at = |w: &Rational, g: &Rational| (w * g + s).square() - (w + s).square();
    let within = |x: Rational, range: &Numbers| x.clamp(range.lo().clone(), range.hi().clone());
    let [a, b] = [w.lo(), w.hi()].map(|w| at(w, &within(-s / w, g)));
    let [c, d] = [g.lo(), g.hi()].map(|g| at(&within(-s / (g + Rational::ONE), w), g));
    let lo = a.min(b);
    Range::new(lo.clone(), c.max(d)).unwrap_or_else(|_| Range::point(lo))
}

/// A part of the ranges that are cut, its entries, and these in doubles, which only choose what is cut.
type Piece = (Vec<Numbers>, Vec<Numbers>, Vec<(f64, f64)>);

/// All values of entries over ranges, from enclosures over parts of them.
fn over(
    whole: Vec<Numbers>,
    of: impl Fn(&[Numbers]) -> Result<Vec<Numbers>, ChainError>,
    cuts: usize,
) -> Result<Vec<Numbers>, ChainError> {
    let near = |found: &[Numbers]| -> Vec<(f64, f64)> {
        let double = |x: &Rational| f64::rounding_from(x, RoundingMode::Nearest).0;
        found.iter().map(|range| (double(range.lo()), double(range.hi()))).collect()
    };
    let piece = |part: Vec<Numbers>| {
        let found = of(&part)?;
        let close = near(&found);
        Ok::<Piece, ChainError>((part, found, close))
    };
    let point = |x: &Rational| Range::point(x.clone());
    let corners = combined(&whole, &|range| vec![point(range.lo()), point(range.hi())]);
    // What is attained, as far as doubles tell.
    let mut inner: Vec<(f64, f64)> = Vec::new();
    let mut pieces = vec![piece(whole)?];
    let mut seen = corners;
    for _ in 0..cuts {
        for found in seen.iter().filter_map(|point| of(point).ok()) {
            let close = near(&found);
            inner = match inner.is_empty() {
                true => close,
                false => inner.iter().zip(&close).map(|(a, b)| (a.0.min(b.0), a.1.max(b.1))).collect(),
            };
        }
        let excess = |piece: &Piece| {
            let beyond = |(found, inner): (&(f64, f64), &(f64, f64))| match (inner.0 - found.0).max(found.1 - inner.1) {
                far if far > 0.0 => far / (inner.1 - inner.0),
                _ => 0.0,
            };
            piece.2.iter().zip(&inner).map(beyond).fold(0.0, f64::max)
        };
        let worst = (0..pieces.len()).max_by(|i, j| excess(&pieces[*i]).total_cmp(&excess(&pieces[*j])));
        let Some(worst) = worst.filter(|worst| excess(&pieces[*worst]) * EXCESS > 1.0) else { break };
        let middle = |range: &Numbers| (range.lo() + range.hi()) / Rational::TWO;
        let halves = combined(&pieces[worst].0, &|range| match range.single() {
            Some(_) => vec![range.clone()],
            None => [(range.lo().clone(), middle(range)), (middle(range), range.hi().clone())]
                .into_iter()
                .filter_map(|(lo, hi)| Range::new(lo, hi).ok())
                .collect(),
        });
        seen = vec![pieces[worst].0.iter().map(|range| point(&middle(range))).collect()];
        // Where a part is beyond a limit, the whole of it stands.
        let Ok(halves) = halves.into_iter().map(piece).collect::<Result<Vec<_>, _>>() else { break };
        pieces.swap_remove(worst);
        pieces.extend(halves);
    }
    let all = pieces.into_iter().map(|piece| piece.1);
    let joined = all.reduce(|a, b| a.iter().zip(&b).map(|(a, b)| a.hull(b)).collect());
    joined.ok_or(ChainError::NotAtRest)
}

/// All lists with one of the parts of each range.
fn combined(ranges: &[Numbers], parts: &dyn Fn(&Numbers) -> Vec<Numbers>) -> Vec<Vec<Numbers>> {
    ranges.iter().fold(vec![Vec::new()], |lists, range| {
        let with = |list: &Vec<Numbers>, part: Numbers| list.iter().cloned().chain([part]).collect();
        lists.iter().flat_map(|list| parts(range).into_iter().map(move |part| with(list, part))).collect()
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::drop::Drop;

    struct Random(u64);

    impl Random {
        fn below(&mut self, count: u64) -> u64 {
            self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (self.0 >> 33) % count
        }

        fn between<T>(&mut self, lo: u64, hi: u64, new: fn(Rational) -> Result<T, ChainError>) -> Range<T>
        where
            T: Clone + PartialOrd,
        {
            let mut part = || Rational::from_unsigneds((hi - lo) * self.below(9), 16u64);
            let from = Rational::from(lo) + part();
            let to = &from + part();
            Range::new(from, to).expect("a range").map(new).expect("in its domain")
        }

        /// Mostly an end.
        fn within<T>(
            &mut self,
            range: &Range<T>,
            value: fn(&T) -> &Rational,
            new: fn(Rational) -> Result<T, ChainError>,
        ) -> Range<T>
        where
            T: Clone + PartialOrd,
        {
            let (lo, hi) = (value(range.lo()), value(range.hi()));
            let share = Rational::from_unsigneds([0, 0, 0, 0, 1, 2, 2, 2, 2][self.below(9) as usize], 2u64);
            Range::point(new(lo + (hi - lo) * share).expect("in its domain"))
        }
    }

    fn bounds(sheet: &Worksheet) -> Vec<(Rational, Rational)> {
        let changes = sheet.collisions.iter().flat_map(|c| {
            let bodies = c.bodies.iter().flat_map(|b| [&b.velocity, &b.momentum, &b.energy]);
            bodies.chain([&c.momentum, &c.energy])
        });
        changes.flat_map(|c| [&c.before, &c.after, &c.change]).map(|entry| entry.bounds().expect("finite")).collect()
    }

    #[test]
    fn an_entry_of_a_measured_sheet_lacks_a_value_or_is_wide() {
        let mut random = Random(7);
        for case in 0..60 {
            let count = 2 + case % 3;
            let masses: Vec<_> = (0..count).map(|_| random.between(1, 9, Positive::new)).collect();
            let list: Vec<_> = (1..count).map(|_| random.between(0, 1, Restitution::new)).collect();
            let floor = random.between(0, 1, Restitution::new);
            let shared = case % 2 == 1;
            let of = |list: Vec<Range<Restitution>>| {
                if shared { Coefficients::Same(list[0].clone()) } else { Coefficients::Each(list) }
            };
            let sheet = |masses, list: Vec<Range<Restitution>>, floor| {
                Worksheet::of_drop(&Drop::new(masses, of(list), floor, None).expect("a drop")).expect("a sheet")
            };
            let found = bounds(&sheet(masses.clone(), list.clone(), floor.clone()));
            let mut seen: Option<Vec<(Rational, Rational)>> = None;
            for _ in 0..if count == 2 { 300 } else { 60 } {
                let point = bounds(&sheet(
                    masses.iter().map(|m| random.within(m, Positive::value, Positive::new)).collect(),
                    list.iter().map(|e| random.within(e, Restitution::value, Restitution::new)).collect(),
                    random.within(&floor, Restitution::value, Restitution::new),
                ));
                for (place, (at, all)) in point.iter().zip(&found).enumerate() {
                    assert!(all.0 <= at.0 && at.1 <= all.1, "case {case}, entry {place}: {at:?} outside of {all:?}");
                }
                let hull = |seen: Vec<(Rational, Rational)>| {
                    seen.into_iter().zip(&point).map(|(a, b)| (a.0.min(b.0.clone()), a.1.max(b.1.clone()))).collect()
                };
                seen = Some(seen.map_or(point.clone(), hull));
            }
            // The change of each momentum rises or falls with each input of one collision: corners attain its ends.
            for place in [5, 14].into_iter().filter(|_| count == 2) {
                let (all, seen) = (&found[place], &seen.as_ref().expect("points")[place]);
                let wide = (&all.1 - &all.0) * Rational::from(1000);
                assert!(wide <= (&seen.1 - &seen.0) * Rational::from(1010), "case {case}: {all:?} around {seen:?}");
            }
        }
    }
}
