//! The order of collisions, kept as runs of two pairs in turn with their length.
//!
//! Velocities and intercepts are products of transfer matrices; a run is one power. They are evaluated when asked for,
//! with as many bits as the digits need, or exactly.

use super::enclosure::Number;
use super::exact::Run;
use super::line::{Line, Pair};
use malachite::Rational;
use malachite::base::num::basic::traits::One;

/// Two pairs that collide in turn, `count` collisions in all, `first` first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Turns {
    first: u32,
    second: u32,
    count: u64,
}

/// The order of collisions: 16 bytes for each break of a pattern.
#[derive(Clone, Debug, Default)]
pub(super) struct History {
    turns: Vec<Turns>,
}

impl History {
    pub(super) fn push(&mut self, pair: usize) {
        let pair = pair as u32;
        if let Some(turns) = self.turns.last_mut() {
            if turns.count == 1 && turns.first.abs_diff(pair) == 1 {
                *turns = Turns { second: pair, count: 2, ..*turns };
                return;
            }
            let next = if turns.count % 2 == 0 { turns.first } else { turns.second };
            if turns.count > 1 && next == pair {
                turns.count += 1;
                return;
            }
        }
        self.turns.push(Turns { first: pair, second: pair, count: 1 });
    }

    /// The number of entries.
    pub(super) fn entries(&self) -> usize {
        self.turns.len()
    }

    /// The last pair.
    pub(super) fn last(&self) -> Option<usize> {
        let turns = self.turns.last()?;
        Some(if turns.count % 2 == 0 { turns.second } else { turns.first } as usize)
    }

    /// The last pair, and the history before it.
    fn split_last(&self) -> Option<(usize, History)> {
        let last = self.last()?;
        let mut before = self.clone();
        let turns = before.turns.last_mut()?;
        turns.count -= 1;
        if turns.count == 0 {
            before.turns.pop();
        }
        Some((last, before))
    }

    /// Applies all collisions to numbers that change as velocities do.
    fn apply<N: Number>(&self, line: &Line, state: &mut [N], bits: u64) {
        for turns in &self.turns {
            let (first, second) = (turns.first as usize, turns.second as usize);
            if turns.count < 8 {
                for i in 0..turns.count {
                    collide(line, state, if i % 2 == 0 { first } else { second }, bits);
                }
                continue;
            }
            let low = first.min(second);
            let step = |pair| -> Matrix<N> { transfer(line, low, pair, bits) };
            let round = product(&step(second), &step(first), bits);
            let mut all = power(round, turns.count / 2, bits);
            if turns.count % 2 == 1 {
                all = product(&step(first), &all, bits);
            }
            let old: Vec<N> = state[low..low + 3].to_vec();
            for (i, row) in all.iter().enumerate() {
                let terms: Vec<N> = row.iter().zip(&old).map(|(m, x)| m.times(x, bits)).collect();
                state[low + i] = terms[0].plus(&terms[1], bits).plus(&terms[2], bits);
            }
        }
    }
}

/// A transfer matrix on three neighbouring points.
type Matrix<N> = [[N; 3]; 3];

fn transfer<N: Number>(line: &Line, low: usize, pair: usize, bits: u64) -> Matrix<N> {
    let unit = |i: usize, j: usize| N::of(&Rational::from(u8::from(i == j)), bits);
    let rows = Rows::of(&line.pairs[pair], bits);
    let mut m: Matrix<N> = std::array::from_fn(|i| std::array::from_fn(|j| unit(i, j)));
    let i = pair - low;
    (m[i][i], m[i][i + 1]) = rows.left;
    (m[i + 1][i + 1], m[i + 1][i]) = rows.right;
    m
}

fn product<N: Number>(a: &Matrix<N>, b: &Matrix<N>, bits: u64) -> Matrix<N> {
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let first = a[i][0].times(&b[0][j], bits).plus(&a[i][1].times(&b[1][j], bits), bits);
            first.plus(&a[i][2].times(&b[2][j], bits), bits)
        })
    })
}

/// A power, at least the first, by repeated squaring.
fn power<N: Number>(mut base: Matrix<N>, mut exponent: u64, bits: u64) -> Matrix<N> {
    let mut result: Option<Matrix<N>> = None;
    loop {
        if exponent % 2 == 1 {
            result = Some(match result {
                None => base.clone(),
                Some(r) => product(&r, &base, bits),
            });
        }
        exponent /= 2;
        if exponent == 0 {
            return result.unwrap_or(base);
        }
        base = product(&base, &base, bits);
    }
}

fn collide<N: Number>(line: &Line, state: &mut [N], p: usize, bits: u64) {
    let rows = Rows::of(&line.pairs[p], bits);
    let (left, right) = rows.apply(&state[p], &state[p + 1], bits);
    (state[p], state[p + 1]) = (left, right);
}

/// The transfer matrix of a pair.
///
/// A row is applied as `(1 − share)·own + share·other`, not as `own + share·(other − own)`: with enclosures the
/// latter counts `own` twice, and a light body bounced between heavy ones would lose a bit at every collision.
#[derive(Clone)]
pub(super) struct Rows<N> {
    left: (N, N),
    right: (N, N),
}

impl<N: Number> Rows<N> {
    pub(super) fn of(pair: &Pair, bits: u64) -> Rows<N> {
        let row = |share: &Rational| (N::of(&(Rational::ONE - share), bits), N::of(share, bits));
        Rows { left: row(&pair.left), right: row(&pair.right) }
    }

    pub(super) fn apply(&self, left: &N, right: &N, bits: u64) -> (N, N) {
        let row = |(own, share): &(N, N), x: &N, y: &N| own.times(x, bits).plus(&share.times(y, bits), bits);
        (row(&self.left, left, right), row(&self.right, right, left))
    }
}

/// Intercepts and velocities after a history, and the time of its last collision as gap and speed.
pub(super) struct Evaluated<N> {
    pub b: Vec<N>,
    pub v: Vec<N>,
    pub last: Option<(N, N)>,
}

/// Evaluates a history from where an exact run stopped.
pub(super) fn evaluate<N: Number>(run: &Run, history: &History, bits: u64) -> Evaluated<N> {
    let mut b: Vec<N> = run.b.iter().map(|x| N::of(x, bits)).collect();
    let mut v: Vec<N> = run.v.iter().map(|x| N::of(x, bits)).collect();
    let mut last = None;
    if let Some((p, before)) = history.split_last() {
        before.apply(run.line, &mut b, bits);
        before.apply(run.line, &mut v, bits);
        last = Some((b[p + 1].minus(&b[p], bits), v[p].minus(&v[p + 1], bits)));
        collide(run.line, &mut b, p, bits);
        collide(run.line, &mut v, p, bits);
    }
    Evaluated { b, v, last }
}
