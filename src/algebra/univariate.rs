//! Polynomials in one variable: Sturm sequences, roots and signs on intervals. Exact throughout.
//!
//! Sturm's theorem: for a square-free p the number of distinct real roots in (a, b] is V(a) − V(b),
//! V counting the sign changes in the sequence p, p′, −rem, … It is applied to the square-free part.

use malachite::Rational;
use malachite::base::num::basic::traits::{One, Zero};

/// Coefficients from the constant up, the last not 0.
pub type Dense = Vec<Rational>;

/// An end of an interval.
#[derive(Clone, Debug, PartialEq)]
pub enum End {
    /// −∞ on the left, +∞ on the right.
    Infinite,
    /// A point that belongs to the interval.
    Closed(Rational),
    /// A point that does not.
    Open(Rational),
}

/// p without leading zeros.
pub fn trimmed(mut p: Dense) -> Dense {
    while p.last().is_some_and(|c| *c == 0) {
        p.pop();
    }
    p
}

/// p(x).
pub fn value(p: &Dense, x: &Rational) -> Rational {
    p.iter().rev().fold(Rational::ZERO, |sum, c| sum * x + c)
}

/// p′.
pub fn derivative(p: &Dense) -> Dense {
    p.iter().enumerate().skip(1).map(|(k, c)| c * Rational::from(k)).collect()
}

/// The remainder of p by q ≠ 0.
pub fn remainder(p: &Dense, q: &Dense) -> Dense {
    let mut rest = p.clone();
    let Some(lead) = q.last() else { return rest };
    while rest.len() >= q.len() {
        let factor = rest.last().map_or(Rational::ZERO, |c| c / lead);
        let shift = rest.len() - q.len();
        for (i, c) in q.iter().enumerate() {
            rest[shift + i] -= c * &factor;
        }
        rest.pop();
        rest = trimmed(rest);
    }
    rest
}

fn quotient(p: &Dense, q: &Dense) -> Dense {
    let mut rest = p.clone();
    let mut out = vec![Rational::ZERO; (p.len() + 1).saturating_sub(q.len())];
    let Some(lead) = q.last() else { return out };
    while rest.len() >= q.len() {
        let factor = rest.last().map_or(Rational::ZERO, |c| c / lead);
        let shift = rest.len() - q.len();
        for (i, c) in q.iter().enumerate() {
            rest[shift + i] -= c * &factor;
        }
        out[shift] = factor;
        rest.pop();
        rest = trimmed(rest);
    }
    out
}

/// The greatest common divisor, monic.
pub fn gcd(p: &Dense, q: &Dense) -> Dense {
    let (mut a, mut b) = (p.clone(), q.clone());
    while !b.is_empty() {
        let r = monic(&remainder(&a, &b));
        a = b;
        b = r;
    }
    monic(&a)
}

fn monic(p: &Dense) -> Dense {
    match p.last() {
        Some(lead) => p.iter().map(|c| c / lead).collect(),
        None => Vec::new(),
    }
}

/// p with every root simple.
pub fn square_free_part(p: &Dense) -> Dense {
    let g = gcd(p, &derivative(p));
    if g.len() <= 1 { p.clone() } else { quotient(p, &g) }
}

/// The Sturm sequence of a square-free p.
pub fn sturm(p: &Dense) -> Vec<Dense> {
    let mut out = vec![p.clone(), trimmed(derivative(p))];
    while let [.., a, b] = out.as_slice() {
        if b.len() <= 1 {
            break;
        }
        let r: Dense = remainder(a, b);
        // A positive multiple keeps the signs and the numbers small.
        let scale = r.last().map_or(Rational::ONE, |c| if *c < 0 { -c } else { c.clone() });
        let next: Dense = r.iter().map(|c| -c / &scale).collect();
        if next.is_empty() {
            break;
        }
        out.push(next);
    }
    out
}

fn changes(signs: impl Iterator<Item = i8>) -> usize {
    let mut count = 0;
    let mut last = 0;
    for sign in signs.filter(|s| *s != 0) {
        if last != 0 && sign != last {
            count += 1;
        }
        last = sign;
    }
    count
}

fn sign(q: &Rational) -> i8 {
    if *q > 0 {
        1
    } else if *q < 0 {
        -1
    } else {
        0
    }
}

fn changes_at(sequence: &[Dense], x: Option<&Rational>, right: bool) -> usize {
    changes(sequence.iter().map(|p| match x {
        Some(x) => sign(&value(p, x)),
        None => {
            let lead = p.last().map_or(0, sign);
            if right || p.len() % 2 == 1 { lead } else { -lead }
        }
    }))
}

/// The number of distinct roots strictly between two ends (infinite where `None`).
pub fn roots_between(p: &Dense, left: Option<&Rational>, right: Option<&Rational>) -> usize {
    let mut p = square_free_part(p);
    // Roots at the ends are divided out.
    for end in [left, right].into_iter().flatten() {
        if value(&p, end) == 0 {
            p = quotient(&p, &vec![-end, Rational::ONE]);
        }
    }
    if p.len() <= 1 {
        return 0;
    }
    let sequence = sturm(&p);
    changes_at(&sequence, left, false).saturating_sub(changes_at(&sequence, right, true))
}

/// A point strictly inside an interval.
fn inside(left: Option<&Rational>, right: Option<&Rational>) -> Rational {
    match (left, right) {
        (Some(a), Some(b)) => (a + b) / Rational::from(2),
        (Some(a), None) => a + Rational::ONE,
        (None, Some(b)) => b - Rational::ONE,
        (None, None) => Rational::ZERO,
    }
}

/// Whether p ≥ 0 (p > 0 if `strict`) on the whole interval, decided exactly.
///
/// p > 0 on the open interval iff it has no root there and is positive at one inner point. p ≥ 0 iff
/// the part with odd multiplicities is: then p changes its sign nowhere.
pub fn is_positive(p: &Dense, left: &End, right: &End, strict: bool) -> bool {
    let p = trimmed(p.clone());
    if p.is_empty() {
        return !strict;
    }
    let bound = |end: &End| match end {
        End::Infinite => None,
        End::Closed(x) | End::Open(x) => Some(x.clone()),
    };
    let (a, b) = (bound(left), bound(right));
    for end in [left, right] {
        if let End::Closed(x) = end {
            let at = value(&p, x);
            if at < 0 || (strict && at == 0) {
                return false;
            }
        }
    }
    if let (Some(a), Some(b)) = (&a, &b)
        && a >= b
    {
        return true;
    }
    let odd = if strict { p.clone() } else { odd_part(&p) };
    if roots_between(&odd, a.as_ref(), b.as_ref()) > 0 {
        return false;
    }
    value(&odd, &inside(a.as_ref(), b.as_ref())) > 0
}

/// The product of the square-free parts with odd multiplicity, with p's sign.
fn odd_part(p: &Dense) -> Dense {
    let mut rest = p.clone();
    let mut out: Dense = vec![Rational::ONE];
    loop {
        // rest = r₁·r₂²·r₃³…: its square-free part s, and rest/s.
        let s = square_free_part(&rest);
        if s.len() <= 1 {
            break;
        }
        let once = quotient(&rest, &s);
        // Roots of multiplicity 1 in rest: in s but not in rest/s.
        let shared = gcd(&s, &once);
        let simple = quotient(&s, &shared);
        out = product(&out, &simple);
        if once.len() <= 1 {
            break;
        }
        // rest/(s·shared) has every multiplicity lowered by 2.
        rest = quotient(&once, &shared);
    }
    if p.last().map_or(0, sign) != out.last().map_or(0, sign) {
        out = out.iter().map(|c| -c).collect();
    }
    out
}

fn product(p: &Dense, q: &Dense) -> Dense {
    let mut out = vec![Rational::ZERO; (p.len() + q.len()).saturating_sub(1)];
    for (i, a) in p.iter().enumerate() {
        for (j, b) in q.iter().enumerate() {
            out[i + j] += a * b;
        }
    }
    out
}

/// Disjoint intervals (a, b] with one root each, every root in one; exact roots as a = b.
pub fn isolate(p: &Dense) -> Vec<(Rational, Rational)> {
    let p = square_free_part(&trimmed(p.clone()));
    if p.len() <= 1 {
        return Vec::new();
    }
    // Cauchy's bound.
    let lead = p.last().cloned().unwrap_or(Rational::ONE);
    let mut bound = Rational::ONE;
    for c in &p {
        let ratio = c / &lead;
        let size = if ratio < 0 { -ratio } else { ratio };
        if size >= bound {
            bound = size;
        }
    }
    bound += Rational::ONE;
    let sequence = sturm(&p);
    let count = |a: &Rational, b: &Rational| changes_at(&sequence, Some(a), false).saturating_sub(changes_at(&sequence, Some(b), true));
    let mut work = vec![(-&bound, bound)];
    let mut out = Vec::new();
    while let Some((a, b)) = work.pop() {
        match count(&a, &b) {
            0 => {}
            1 if value(&p, &b) == 0 => out.push((b.clone(), b)),
            1 => out.push((a, b)),
            _ => {
                let middle = (&a + &b) / Rational::from(2);
                work.push((middle.clone(), b));
                work.push((a, middle));
            }
        }
    }
    out.sort();
    out
}
