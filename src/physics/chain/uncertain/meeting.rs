//! Whether bodies meet again after the pass, for all, some or no values of measured inputs.
//!
//! **Given masses, the others at rest.** Bodies `k − 1` and `k` meet again iff `(1 + m_k/m_(k−1))·(1 + m_k/m_(k+1))` is below
//! `(1 + e)(1 + f)/e`, `e` the coefficient of their collision and `f` that of the next one. *Proof.* They do iff
//! `(m_(k−1) − e·m_k)/(m_(k−1) + m_k)` exceeds `(1 + e)·m_(k−1)/(m_(k−1) + m_k)·(m_k − f·m_(k+1))/(m_k + m_(k+1))`; multiplied out and divided by
//! `m_(k−1)·m_(k+1)` this is `1 + (1 + e)·f > e·(p + q + p·q)`, `p` and `q` the two quotients; add `e`. ∎ So it becomes true as `m_k` or
//! `e` falls and as a neighbour or `f` grows; with `e = f`, `(1 + e)²/e` falls with `e`. For one pair the corners decide.
//!
//! All pairs together: a point where none meets is sought from below. If the masses must be at least `L` for that,
//! then body `k` needs at least the mass that its two neighbours at `L` ask for: `L` is raised until nothing changes (and
//! then a point just above it is tested exactly) or a mass leaves its range (and then some pair always meets).
//! Roots are guessed; the condition itself decides.
//!
//! **Optimal masses.** All pairs have `m_k/m_(k−1) = 1/x`, `m_k/m_(k+1) = x`: the left side is `2 + x + 1/x`, which grows with `|ln x|`.

use super::bound::{Side, shortened};
use super::{Coefficients, Positive, Range, Reals, ratios};
use crate::chain::optimum::Optimum;
use crate::chain::pass::Pass;
use crate::chain::recollision::{again, of_optimum, of_velocities};
use crate::chain::{ChainError, Restitution, Restitutions};
use crate::number::real::Level;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::PowerOf2;
use malachite::base::num::basic::traits::{One, Two, Zero};
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::rounding_modes::RoundingMode;
use std::cmp::Ordering;

/// Whether bodies meet again after the pass.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Meeting {
    /// For no values of the inputs.
    Never,
    /// For all of them.
    Always,
    /// For some, and for others not.
    Depends,
    /// Not settled: bounds do not tell, and no witnesses were found within [`ROUNDS`].
    Unsettled,
}

impl Meeting {
    /// Whether they do, for exact inputs.
    #[must_use]
    pub fn of(again: bool) -> Meeting {
        if again { Self::Always } else { Self::Never }
    }

    /// The answer in words.
    #[must_use]
    pub fn text(self) -> &'static str {
        match self {
            Self::Never => "no",
            Self::Always => "yes",
            Self::Depends => "depends",
            Self::Unsettled => "not settled",
        }
    }
}

/// How often all lower bounds are raised in the search for masses with which no bodies meet.
pub const ROUNDS: usize = 200;

/// An end of the range of a coefficient.
type End = fn(&Range<Restitution>) -> &Restitution;

/// The ends of the coefficients with even and with odd numbers at which bodies are tried that do not meet.
const PATTERNS: [[End; 2]; 4] =
    [[Range::hi, Range::hi], [Range::lo, Range::lo], [Range::hi, Range::lo], [Range::lo, Range::hi]];

/// Bits of the lower bounds.
const BITS: u64 = 96;

/// Bodies of optimal mass.
///
/// # Errors
/// As [`of_optimum`].
pub fn of_optimal(
    first: &Range<Positive>,
    last: &Range<Positive>,
    coefficients: &Coefficients,
    n: u64,
) -> Result<(Meeting, Level), ChainError> {
    let (near, far) = ratios(first, last);
    let unit = first.lo().over(first.lo());
    let chain = |r: &Positive, e: Restitutions| Optimum::new(r.clone(), unit.clone(), n, e);
    let list = match coefficients {
        Coefficients::Same(e) => {
            let at = |r: &Positive, e: &Restitution| of_optimum(&chain(r, Restitutions::Same(e.clone()))?);
            let ((likeliest, level), (least, other)) = (at(&near, e.lo())?, at(&far, e.hi())?);
            let found = if likeliest == least { Meeting::of(least) } else { Meeting::Depends };
            return Ok((found, level.max(other)));
        }
        Coefficients::Each(list) => list,
    };
    let any = |r: &Positive, pick: fn(&Range<Restitution>, &Range<Restitution>) -> (Restitution, Restitution)| {
        let x = chain(r, Restitutions::Same(Restitution::new(Rational::ONE)?))?.step();
        let mut level = Level::Double;
        for pair in list.windows(2) {
            let [e, next] = pair else { continue };
            let (e, next) = pick(e, next);
            let (found, other) = again(&x, &e, &next)?;
            level = level.max(other);
            if found {
                return Ok((true, level));
            }
        }
        Ok::<_, ChainError>((false, level))
    };
    let (possible, level) = any(&near, |e, next| (e.lo().clone(), next.hi().clone()))?;
    if !possible {
        return Ok((Meeting::Never, level));
    }
    let (certain, other) = any(&far, |e, next| (e.hi().clone(), next.lo().clone()))?;
    let level = level.max(other);
    if certain {
        return Ok((Meeting::Always, level));
    }
    for ends in PATTERNS {
        let each = Restitutions::Each(list.iter().enumerate().map(|(k, e)| ends[k % 2](e).clone()).collect());
        if !of_optimum(&chain(&far, each.for_inserted(n)?)?)?.0 {
            return Ok((Meeting::Depends, level));
        }
    }
    Ok((Meeting::Unsettled, level))
}

/// Whether two bodies meet again, the others at rest before: masses `a`, `m` and that of the body in front of both, `b`; `e` the
/// coefficient of their collision and `f` that of the next one.
#[must_use]
pub fn meet(a: &Rational, m: &Rational, b: &Rational, e: &Rational, f: &Rational) -> bool {
    e * (a + m) * (b + m) < (e + Rational::ONE) * (f + Rational::ONE) * a * b
}

/// Bodies of given masses, the first one moving and the others at rest.
#[must_use]
pub fn of_given(masses: &[Range<Positive>], coefficients: &Coefficients) -> Meeting {
    let shared = coefficients.shared().is_some();
    let at = |k: usize, end: End| coefficients.at(k).map(|e| end(e).value());
    let triples = || masses.windows(3).zip(1_usize..);
    let possible = triples().any(|(masses, k)| {
        let ([a, m, b], Some(e)) = (masses, at(k - 1, Range::lo)) else { return false };
        let f = if shared { Some(e) } else { at(k, Range::hi) };
        f.is_some_and(|f| meet(a.hi().value(), m.lo().value(), b.hi().value(), e, f))
    });
    if !possible {
        return Meeting::Never;
    }
    // The coefficients with which a pair is least likely to meet; for all pairs at once where they are shared.
    let least = |k: usize| {
        let e = at(k - 1, Range::hi)?;
        Some((e, if shared { e } else { at(k, Range::lo)? }))
    };
    let mut lows: Vec<Rational> = masses.iter().map(|m| m.lo().value().clone()).collect();
    for _ in 0..ROUNDS {
        let mut changed = false;
        for (k, range) in masses.iter().enumerate().take(masses.len().saturating_sub(1)).skip(1) {
            let (Some((e, f)), [a, m, b]) = (least(k), &lows[k - 1..=k + 1]) else { continue };
            let Some(raised) = needed(a, b, e, f).filter(|raised| raised > m && meet(a, raised, b, e, f)) else {
                // No mass that is found helps; with this one they may meet for all.
                if meet(a, range.hi().value(), b, e, f) {
                    return Meeting::Always;
                }
                continue;
            };
            if raised > *range.hi().value() {
                return Meeting::Always;
            }
            changed |= raised > m * (Rational::ONE + Rational::power_of_2(-20_i64));
            lows[k] = raised;
        }
        if !changed {
            break;
        }
    }
    let slack = Rational::ONE + Rational::power_of_2(-16_i64);
    let raised = |low: &Rational, range: &Range<Positive>| {
        if low == range.lo().value() { low.clone() } else { (low * &slack).min(range.hi().value().clone()) }
    };
    let point: Vec<Rational> = lows.iter().zip(masses).map(|(low, range)| raised(low, range)).collect();
    let apart = |ends: &[End; 2]| {
        point.windows(3).zip(1_usize..).all(|(masses, k)| {
            let (e, f) = (at(k - 1, ends[(k - 1) % 2]), at(k, ends[k % 2]));
            match (masses, e, f) {
                ([a, m, b], Some(e), Some(f)) => !meet(a, m, b, e, f),
                _ => true,
            }
        })
    };
    // A shared coefficient takes the patterns with one end.
    let patterns = PATTERNS.iter().take(if shared { 2 } else { PATTERNS.len() });
    if patterns.into_iter().any(apart) { Meeting::Depends } else { Meeting::Unsettled }
}

/// A little less than the mass with which a body no longer meets the one behind it; may be wrong.
fn needed(a: &Rational, b: &Rational, e: &Rational, f: &Rational) -> Option<Rational> {
    if *e == Rational::ZERO {
        return None;
    }
    let double = |x: Rational| f64::rounding_from(&x, RoundingMode::Nearest).0;
    // (1 + y)(1 + y·a/b) = right, y = m/a.
    let (quotient, right) = (double(a / b), double((e + Rational::ONE) * (f + Rational::ONE) / e));
    let sum = 1.0 + quotient;
    let y = 2.0 * (right - 1.0) / (sum + (sum * sum + 4.0 * quotient * (right - 1.0)).sqrt());
    let y = Rational::try_from(y * (1.0 - 1e-9)).ok()?;
    Some(shortened(a * y, Side::Below, BITS))
}

/// Bodies of given masses of which others than the first move, from the bounds of their velocities; exact inputs at
/// three places of the box serve as witnesses.
///
/// # Errors
/// As [`Pass::velocities_after`].
pub(crate) fn of_moving(
    masses: &[Range<Positive>],
    coefficients: &Coefficients,
    before: &[Rational],
    velocities: &[Reals],
) -> Result<Meeting, ChainError> {
    let order = |behind: &Reals, front: &Reals| match (behind.greatest.as_rational(), front.least.as_rational()) {
        (Some(most), Some(least)) => most.cmp(least),
        _ => Ordering::Greater,
    };
    let pairs = || velocities.windows(2);
    if pairs().all(|pair| matches!(pair, [behind, front] if order(behind, front) != Ordering::Greater)) {
        return Ok(Meeting::Never);
    }
    let surely = |behind: &Reals, front: &Reals| match (behind.least.as_rational(), front.greatest.as_rational()) {
        (Some(least), Some(most)) => least > most,
        _ => false,
    };
    if pairs().any(|pair| matches!(pair, [behind, front] if surely(behind, front))) {
        return Ok(Meeting::Always);
    }
    let part = |range: (&Rational, &Rational), share: u32| {
        range.0 + (range.1 - range.0) * Rational::from(share) / Rational::TWO
    };
    let mut seen = [false, false];
    for share in [0_u32, 1, 2] {
        let masses = masses.iter().map(|m| Positive::new(part((m.lo().value(), m.hi().value()), share)));
        let e = (0..velocities.len().saturating_sub(1)).filter_map(|k| coefficients.at(k));
        let e = e.map(|e| Restitution::new(part((e.lo().value(), e.hi().value()), share)));
        let restitutions = Restitutions::Each(e.collect::<Result<_, _>>()?);
        let pass = Pass::new(masses.collect::<Result<_, _>>()?, restitutions, before.to_vec())?;
        seen[usize::from(of_velocities(&pass.velocities_after()?))] = true;
    }
    Ok(match seen {
        [true, true] => Meeting::Depends,
        _ => Meeting::Unsettled,
    })
}
