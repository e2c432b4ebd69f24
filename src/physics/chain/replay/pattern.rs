//! Collapse of four and more points: a repeating pattern of collisions that contracts.
//!
//! Let `c` hold the closing speeds of neighbouring pairs of the points involved and `β` the same differences of
//! intercepts: both are multiplied by one matrix `A` over one round of the pattern. Collision `i` of a round, of the
//! pair `p` after the prefix `W` of the round, is the next one exactly where
//! - the pair approaches, `(W c)_p > 0`, and
//! - all other gaps are positive when it meets: `ω_pq > 0` for `q ≠ p`, where `ω = Wβ ∧ Wc`, that is
//!   `ω_pq = β_p·c_q − β_q·c_p`. The gap of `q` at that time is `ω_pq/c_p`.
//!
//! Both are linear: the first in `c`, which `A` multiplies, the second in `ω = β ∧ c`, which `Λ²A` multiplies. So it
//! is enough to show that each of the two vectors stays in a cone on which its conditions hold:
//!
//! **Lemma.** For vectors `r`, `l` with `l·r > 0` and `δ > 0` let `K` be the cone of all
//! `x = z·(r + ρ)`, `z > 0`, `l·ρ = 0`, `|ρ_j| ≤ δ`. On `r + ρ` a row `f` takes values within
//! `f·r ± δ·Σ_j |f_j − (f·r/l·r)·l_j|`, since multiples of `l` do not change `f·ρ`. If by this bound the row
//! `g = l·B/(l·r)` is at least `γ > 0`, and each row `B_j − r_j·g` at most `δ·γ` in size, then `B` maps `K` into
//! itself, and multiplies `z` by a factor within the bounds of `g`. ∎
//!
//! `r` and `l` are guessed in doubles (powers of `B` and of its transpose), everything else is exact.
//!
//! **The sum of times.** The first meeting of a round is at `t = −β_p/c_p`; from one block of rounds to the next it
//! grows by `Σ_q B_pq·ω_pq/(c_p·(Bc)_p)`. If `ω` grows by at most `Γ` and `c` by at least `γ` a block, and
//! `Γ < γ²`, these terms are below a geometric series: the times converge, and its remainder encloses their limit.
//! That `c` grows by at most a factor below 1 makes all speeds tend to 0.
//!
//! Where the largest eigenvalue is double, or the limit is approached from the edge of a cone, this proves nothing:
//! then the run ends at a limit. For three points, [`super::collapse`] decides every case.

use super::Value;
use super::collapse::{Collapse, centre};
use super::line::Line;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::{Abs, Square};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::rounding_modes::RoundingMode;

/// The longest round of a pattern that is looked for.
const MAX_ROUND: usize = 24;

/// Patterns are looked for after so many collisions, again and again: a prime, so that every phase of a round comes.
pub(super) const ATTEMPT: usize = 97;

/// The most points of a pattern.
const MAX_POINTS: usize = 8;

/// The most rounds that are taken together as one block.
const MAX_BLOCK: u32 = 16;

type Row = Vec<Rational>;
type Matrix = Vec<Row>;

/// The shortest round that the last collisions repeat three times over, if any, and if it is one of four points or more.
pub(super) fn round(recent: &[usize]) -> Option<&[usize]> {
    let found = (2..=MAX_ROUND.min(recent.len() / 3)).find_map(|length| {
        let tail = &recent[recent.len() - 3 * length..];
        (0..2 * length).all(|i| tail[i] == tail[i + length]).then(|| &tail[2 * length..])
    });
    found.filter(|round| (3..MAX_POINTS).contains(&pairs(round)))
}

/// How many neighbouring pairs the points of a round make.
fn pairs(round: &[usize]) -> usize {
    round.iter().max().zip(round.iter().min()).map_or(0, |(last, first)| last + 1 - first)
}

/// The collapse of the points that the round touches, if it repeats for ever from here and in a finite time.
pub(super) fn of_round(line: &Line, b: &[Rational], v: &[Rational], round: &[usize]) -> Option<Collapse> {
    let d = pairs(round);
    let first = *round.iter().min()?;
    let last = first + d;
    let closing = |x: &[Rational]| (first..last).map(|p| &x[p] - &x[p + 1]).collect::<Row>();
    let (beta, c) = (closing(b), closing(v));
    let pairs = planes(d);
    let wedge: Row = pairs.iter().map(|(i, j)| &beta[*i] * &c[*j] - &beta[*j] * &c[*i]).collect();

    // Conditions of one round, as rows on c and on ω.
    let mut prefix = identity(d);
    let (mut on_speeds, mut on_gaps): (Matrix, Matrix) = (Vec::new(), Vec::new());
    for p in round {
        let p = p - first;
        on_speeds.push(prefix[p].clone());
        for q in (0..d).filter(|q| *q != p) {
            on_gaps.push(plane_row(&prefix[p], &prefix[q], &pairs));
        }
        prefix = product(&collision(line, first, d, p), &prefix);
    }
    let second: Matrix = pairs.iter().map(|(i, j)| plane_row(&prefix[*i], &prefix[*j], &pairs)).collect();

    let mut block = 1;
    let (mut a, mut a2) = (prefix, second);
    while block <= MAX_BLOCK {
        let found = certify_attraction(&a, &c, &on_speeds).zip(certify_attraction(&a2, &wedge, &on_gaps));
        if let Some((speeds, gaps)) = found
            && let Some((lo, hi)) = limit(&a, (&beta, &c), (&speeds, &gaps), &pairs, round[0] - first)
        {
            let centre = centre(line, b, v, first..=last);
            let offset = &centre.0 + &line.points[first + 1].offset;
            let (x, y) = (&lo * &centre.1 + &offset, &hi * &centre.1 + offset);
            return Some(Collapse {
                bodies: (first + line.first, last + line.first),
                pattern: round.iter().map(|p| p + line.first).collect(),
                time: Value::Within(lo, hi),
                position: if x <= y { Value::Within(x, y) } else { Value::Within(y, x) },
                velocity: centre.1.clone(),
                factor: Value::Within(speeds.least, speeds.most),
                rounds: block,
                trace: None,
                critical: false,
                centre,
            });
        }
        // Two blocks as one: the conditions of the second, seen from before the first.
        on_speeds = [on_speeds.clone(), on_speeds.iter().map(|f| row_times(f, &a)).collect()].concat();
        on_gaps = [on_gaps.clone(), on_gaps.iter().map(|f| row_times(f, &a2)).collect()].concat();
        a = product(&a, &a);
        a2 = product(&a2, &a2);
        block *= 2;
    }
    None
}

/// A cone that a matrix maps into itself.
struct Attraction {
    r: Row,
    l: Row,
    delta: Rational,
    /// The coordinate `z` of the starting vector.
    z: Rational,
    /// Bounds of the factor of `z`.
    least: Rational,
    most: Rational,
}

impl Attraction {
    /// The bounds of a row on `r + ρ`.
    fn bounds(&self, f: &Row) -> (Rational, Rational) {
        let middle = dot(f, &self.r);
        let share = &middle / dot(&self.l, &self.r);
        let spread: Rational =
            f.iter().zip(&self.l).fold(Rational::ZERO, |sum, (f, l)| sum + (f - &share * l).abs()) * &self.delta;
        (&middle - &spread, middle + spread)
    }
}

/// A cone that holds `x`, that `b` maps into itself, and on which all conditions are positive.
fn certify_attraction(b: &Matrix, x: &Row, conditions: &Matrix) -> Option<Attraction> {
    let near: Vec<Vec<f64>> = b.iter().map(|row| row.iter().map(double).collect()).collect();
    let start: Vec<f64> = x.iter().map(double).collect();
    let r = guess_direction(&near, &start)?;
    let transposed: Vec<Vec<f64>> = (0..near.len()).map(|j| near.iter().map(|row| row[j]).collect()).collect();
    let l = guess_direction(&transposed, &r)?;
    let exact = |v: Vec<f64>| v.into_iter().map(|x| Rational::try_from(x).ok()).collect::<Option<Row>>();
    let (r, mut l) = (exact(r)?, exact(l)?);
    let mut length = dot(&l, &r);
    if length == Rational::ZERO {
        return None;
    }
    if length < Rational::ZERO {
        l.iter_mut().for_each(|x| *x = -&*x);
        length = -length;
    }
    let z = dot(&l, x) / &length;
    if z <= Rational::ZERO {
        return None;
    }
    let away = x.iter().zip(&r).map(|(x, r)| (x / &z - r).abs()).max()?;
    let mut delta = Rational::ONE;
    let half = Rational::from_signeds(1, 2);
    while &delta * &half >= away && delta > Rational::ONE >> 40u32 {
        delta *= &half;
    }
    if delta < away || delta == Rational::ONE {
        return None;
    }
    let mut cone = Attraction { r, l, delta, z, least: Rational::ZERO, most: Rational::ZERO };
    let g: Row = row_times(&cone.l, b).iter().map(|x| x / &length).collect();
    (cone.least, cone.most) = cone.bounds(&g);
    let room = &cone.delta * &cone.least;
    let inside = cone.least > Rational::ZERO
        && b.iter().zip(&cone.r).all(|(row, r)| {
            let h: Row = row.iter().zip(&g).map(|(b, g)| b - r * g).collect();
            let (lo, hi) = cone.bounds(&h);
            -lo <= room && hi <= room
        });
    (inside && conditions.iter().all(|f| cone.bounds(f).0 > Rational::ZERO)).then_some(cone)
}

/// Where powers of a matrix turn a vector to, largest component 1 in size; a guess.
fn guess_direction(a: &[Vec<f64>], start: &[f64]) -> Option<Vec<f64>> {
    let mut x = start.to_vec();
    for _ in 0..400 {
        let y: Vec<f64> = a.iter().map(|row| row.iter().zip(&x).map(|(a, x)| a * x).sum()).collect();
        let size = y.iter().fold(0.0f64, |m, y| m.max(y.abs()));
        if !(size > 0.0 && size.is_finite()) {
            return None;
        }
        x = y.iter().map(|y| y / size).collect();
    }
    // As positive as the start, so that multiples of it are.
    let along: f64 = x.iter().zip(start).map(|(x, s)| x * s).sum();
    Some(if along < 0.0 { x.iter().map(|x| -x).collect() } else { x })
}

/// Bounds of the time to which the first meetings of the blocks converge.
fn limit(
    b: &Matrix,
    (beta, c): (&Row, &Row),
    (speeds, gaps): (&Attraction, &Attraction),
    pairs: &[(usize, usize)],
    p: usize,
) -> Option<(Rational, Rational)> {
    let ratio = &gaps.most / (&speeds.least).square();
    if ratio >= Rational::ONE || speeds.most >= Rational::ONE {
        return None;
    }
    // Σ_q B_pq·ω_pq as a row on ω.
    let row = |(i, j): &(usize, usize)| match (*i == p, *j == p) {
        (true, _) => b[p][*j].clone(),
        (_, true) => -&b[p][*i],
        _ => Rational::ZERO,
    };
    let step: Row = pairs.iter().map(row).collect();
    let most = gaps.bounds(&step).1 * &gaps.z;
    let unit: Row = (0..c.len()).map(|q| Rational::from(u8::from(q == p))).collect();
    let least = speeds.bounds(&unit).0 * speeds.bounds(&b[p]).0 * (&speeds.z).square();
    if least <= Rational::ZERO {
        return None;
    }
    let mut rest = most / least / (Rational::ONE - &ratio);
    // More blocks make the remainder small.
    let (mut beta, mut c) = (beta.clone(), c.clone());
    let enough = Rational::ONE >> 100u32;
    for _ in 0..60 {
        if rest < enough {
            break;
        }
        beta = times_column(b, &beta);
        c = times_column(b, &c);
        rest *= &ratio;
    }
    let now = -&beta[p] / &c[p];
    Some((outward(&now, RoundingMode::Floor), outward(&(now + rest), RoundingMode::Ceiling)))
}

/// To 160 binary places, in the direction given.
fn outward(x: &Rational, direction: RoundingMode) -> Rational {
    let (n, _) = malachite::Integer::rounding_from(x << 160u32, direction);
    Rational::from(n) >> 160u32
}

fn double(x: &Rational) -> f64 {
    f64::rounding_from(x, RoundingMode::Nearest).0
}

/// What a collision of pair `p` of the `d` pairs from `first` on does to closing speeds.
fn collision(line: &Line, first: usize, d: usize, p: usize) -> Matrix {
    let pair = &line.pairs[first + p];
    let mut m = identity(d);
    m[p][p] = -&pair.restitution;
    if p > 0 {
        m[p - 1][p] = pair.left.clone();
    }
    if p + 1 < d {
        m[p + 1][p] = pair.right.clone();
    }
    m
}

/// The coordinate planes of `d` dimensions, in order.
fn planes(d: usize) -> Vec<(usize, usize)> {
    (0..d).flat_map(|i| (i + 1..d).map(move |j| (i, j))).collect()
}

/// The row of `Λ²` that belongs to two rows.
fn plane_row(x: &Row, y: &Row, pairs: &[(usize, usize)]) -> Row {
    pairs.iter().map(|(i, j)| &x[*i] * &y[*j] - &x[*j] * &y[*i]).collect()
}

fn identity(d: usize) -> Matrix {
    (0..d).map(|i| (0..d).map(|j| Rational::from(u8::from(i == j))).collect()).collect()
}

fn dot(x: &Row, y: &Row) -> Rational {
    x.iter().zip(y).fold(Rational::ZERO, |sum, (x, y)| sum + x * y)
}

fn row_times(f: &Row, m: &Matrix) -> Row {
    (0..m.len()).map(|j| f.iter().zip(m).fold(Rational::ZERO, |sum, (f, row)| sum + f * &row[j])).collect()
}

fn times_column(m: &Matrix, x: &Row) -> Row {
    m.iter().map(|row| dot(row, x)).collect()
}

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    a.iter().map(|row| row_times(row, b)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_round_is_found_only_where_it_repeats() {
        assert_eq!(round(&[9, 1, 2, 3, 1, 2, 3, 1, 2, 3]), Some(&[1, 2, 3][..]));
        assert_eq!(round(&[9, 1, 2, 1, 2, 1, 2]), None);
        assert_eq!(round(&[1, 2, 3, 2, 1, 2, 3, 2, 1, 2, 3, 2]), Some(&[1, 2, 3, 2][..]));
        assert_eq!(round(&[1, 2, 1, 2, 1, 3]), None);
    }

    #[test]
    fn rotations_and_wrong_directions_are_not_attractions() {
        let m = |rows: [[i64; 2]; 2]| -> Matrix {
            rows.iter().map(|r| r.iter().map(|x| Rational::from_signeds(*x, 10)).collect()).collect()
        };
        let x = |a: i64, b: i64| vec![Rational::from(a), Rational::from(b)];
        let none: Matrix = Vec::new();
        assert!(certify_attraction(&m([[5, 1], [1, 2]]), &x(3, 1), &none).is_some());
        assert!(certify_attraction(&m([[0, -5], [5, 0]]), &x(1, 1), &none).is_none());
        // A double eigenvalue: no cone around its direction is mapped into itself with room to spare.
        assert!(certify_attraction(&m([[5, 1], [0, 5]]), &x(1, 1), &none).is_none());
        // A condition that fails in the limit.
        assert!(certify_attraction(&m([[5, 1], [1, 2]]), &x(3, 1), &vec![x(-1, 0)]).is_none());
    }
}
