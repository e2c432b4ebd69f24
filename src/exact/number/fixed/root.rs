//! Reciprocal roots of ratios in machine words, by Newton steps from a double.
//!
//! Each step doubles the digits and bounds its own error, so that the guess need not be right.

use super::{Fixed, MAX_EXPONENT};
use crate::number::words::{Divisor, complement, difference, sum};

impl<const L: usize> Fixed<L> {
    /// The point with the leading digits of a double between 0 and 1, without error; for guesses.
    fn point(x: f64) -> Option<Fixed<L>> {
        let inside = x > 0.0 && x < 1.0;
        let mut words = [0; L];
        // Below 2^64 as x < 1: the cast is exact but for digits beyond the 64th, which a guess does without.
        *words.last_mut()? = if inside { (x * 18_446_744_073_709_551_616.0) as u64 } else { 0 };
        inside.then_some(Fixed { words, error: 0 })
    }

    /// `(p/q)^(−1/n)` for `p > q > 0` and `n` from 1 to `MAX_EXPONENT`.
    ///
    /// As in [`crate::number::root`]: for a point `y` and `ρ = (p/q)·y^n − 1`, `|ρ| <= 1/16`, the root is `y − y·ρ/n + y·θ`, `|θ| <= 2ρ²/n`. The
    /// guess has some 50 digits and each step doubles them: in two words, in four, in seven, and in all.
    pub fn inverse_root(p: u64, q: u64, n: u64) -> Option<Fixed<L>> {
        if p <= q || !(1..=MAX_EXPONENT).contains(&n) {
            return None;
        }
        let equation = (p, Divisor::new(q)?, Divisor::new(n)?);
        // The casts round; the guess may be wrong.
        let guess = (q as f64 / p as f64).powf(1.0 / n as f64);
        let y = Fixed::<2>::point(guess)?.corrected(&equation)?;
        // What the guess lacks for a large n counts twice at each further step: two words in full cost little.
        let y = if L > 8 { y.step::<2>(&equation)? } else { y };
        let short = |y: &Fixed<2>| y.step::<3>(&equation)?.step::<5>(&equation)?.step::<9>(&equation);
        let long = |y: &Fixed<2>| y.step::<4>(&equation)?.step::<7>(&equation);
        match L {
            0..=3 => y.step::<L>(&equation),
            4..=6 => y.step::<4>(&equation)?.step::<L>(&equation),
            7..=12 => long(&y)?.step::<L>(&equation),
            13..=16 => short(&y)?.step::<L>(&equation),
            17..=24 => long(&y)?.step::<13>(&equation)?.step::<L>(&equation),
            25..=32 => short(&y)?.step::<17>(&equation)?.step::<L>(&equation),
            33..=48 => long(&y)?.step::<13>(&equation)?.step::<25>(&equation)?.step::<L>(&equation),
            _ => {
                let y = short(&y)?.step::<17>(&equation)?.step::<33>(&equation)?;
                match L {
                    0..=64 => y.step::<L>(&equation),
                    65..=128 => y.step::<65>(&equation)?.step::<L>(&equation),
                    _ => y.step::<65>(&equation)?.step::<129>(&equation)?.step::<L>(&equation),
                }
            }
        }
    }

    /// The digits with more or fewer words, and one step with as many.
    fn step<const M: usize>(&self, equation: &(u64, Divisor, Divisor)) -> Option<Fixed<M>> {
        self.resized::<M>().corrected(equation)
    }

    /// One step of [`Fixed::inverse_root`] from a point.
    fn corrected(&self, (p, q, n): &(u64, Divisor, Divisor)) -> Option<Fixed<L>> {
        let power = self.power(n.value)?;
        let (whole, words) = power.times_word(*p);
        let (whole, words) = Fixed::over_word(whole, words, q);
        // |ρ|, with its sign aside; the error may make it cross 0, which the bounds of a product allow.
        let (above, words) = match whole {
            1 => (true, words),
            // Without a digit ρ is −1, which is not small.
            0 if words != [0; L] => (false, complement(&words)),
            _ => return None,
        };
        let rho = Fixed { words, error: power.error.saturating_mul(p.div_ceil(q.value)).saturating_add(1) };
        // |ρ| <= 2^-k.
        let k = rho.zeros();
        if k < 4 {
            return None;
        }
        let product = self.times(&rho)?;
        let (_, step) = Fixed::over_word(0, product.words, n);
        // 2ρ²/n in units, at most 2^(64L + 1 − 2k).
        let tail = match (64 * L as u64 + 1).saturating_sub(2 * k) {
            places @ 0..64 => (1_u64 << places).div_ceil(n.value),
            _ => u64::MAX,
        };
        let (words, beyond) = if above { difference(&self.words, &step) } else { sum(&self.words, &step) };
        let error = (product.error / n.value).saturating_add(2).saturating_add(tail);
        // Points of intermediate steps may have any error.
        (!beyond).then_some(Fixed { words, error })
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // a test stops where it fails
mod tests {
    use super::{Divisor, Fixed, MAX_EXPONENT};
    use crate::number::interval::Interval;
    use crate::number::root::root;
    use malachite::{Natural, Rational};
    use proptest::prelude::*;

    fn enclosed_root<const L: usize>(p: u64, q: u64, n: u64) -> Result<bool, TestCaseError> {
        let Some(found) = Fixed::<L>::inverse_root(p, q, n).and_then(|y| y.interval(10)) else { return Ok(false) };
        let exact = root(&Rational::from_unsigneds(q, p), &Natural::from(n), 64 * L as u64 + 100);
        prop_assert!(found.contains_interval(&exact), "{p}/{q}, {n}: {found:?} against {exact:?}");
        Ok(true)
    }

    #[test]
    fn roots_are_as_narrow_as_the_words_allow() {
        for n in [1, 2, 3, 8, 100] {
            let narrow = |x: Option<Interval>| assert!(x.is_some(), "{n}");
            narrow(Fixed::<3>::inverse_root(10, 1, n).and_then(|y| y.interval(Fixed::<3>::ROOM)));
            narrow(Fixed::<4>::inverse_root(10, 1, n).and_then(|y| y.interval(Fixed::<4>::ROOM)));
            narrow(Fixed::<6>::inverse_root(10, 1, n).and_then(|y| y.interval(Fixed::<6>::ROOM)));
            narrow(Fixed::<8>::inverse_root(10, 1, n).and_then(|y| y.interval(Fixed::<8>::ROOM)));
            narrow(Fixed::<12>::inverse_root(10, 1, n).and_then(|y| y.interval(Fixed::<12>::ROOM)));
            narrow(Fixed::<16>::inverse_root(10, 1, n).and_then(|y| y.interval(Fixed::<16>::ROOM)));
            narrow(Fixed::<24>::inverse_root(10, 1, n).and_then(|y| y.interval(Fixed::<24>::ROOM)));
            narrow(Fixed::<32>::inverse_root(10, 1, n).and_then(|y| y.interval(Fixed::<32>::ROOM)));
            narrow(Fixed::<46>::inverse_root(10, 1, n).and_then(|y| y.interval(Fixed::<46>::ROOM)));
            narrow(Fixed::<62>::inverse_root(10, 1, n).and_then(|y| y.interval(Fixed::<62>::ROOM)));
            narrow(Fixed::<94>::inverse_root(10, 1, n).and_then(|y| y.interval(Fixed::<94>::ROOM)));
        }
        assert!(Fixed::<3>::inverse_root(1, 1, 3).is_none() && Fixed::<3>::inverse_root(1, 2, 3).is_none());
        assert!(
            Fixed::<3>::inverse_root(2, 1, 0).is_none() && Fixed::<3>::inverse_root(2, 1, MAX_EXPONENT + 1).is_none()
        );
    }

    proptest! {
        #[test]
        fn roots_hold_the_root(
            p in prop_oneof![1..1000_u64, any::<u64>()], q in prop_oneof![1..1000_u64, 1_u64..], n in 1..=64_u64,
        ) {
            let (p, q) = (p.max(q), p.min(q));
            prop_assume!(q > 0);
            let all = [enclosed_root::<3>(p, q, n)?, enclosed_root::<4>(p, q, n)?, enclosed_root::<6>(p, q, n)?, enclosed_root::<8>(p, q, n)?];
            let long = [enclosed_root::<10>(p, q, n)?, enclosed_root::<12>(p, q, n)?, enclosed_root::<16>(p, q, n)?, enclosed_root::<24>(p, q, n)?, enclosed_root::<28>(p, q, n)?, enclosed_root::<41>(p, q, n)?];
            // Ordinary ratios are not left to others.
            let hard = p / q >= 1 << 20 || p - q <= q / 1000;
            prop_assert!(hard || (all == [true; 4] && long == [true; 6]), "{p}/{q}, {n}: {all:?} {long:?}");
        }

        #[test]
        fn a_wrong_guess_is_refused_or_corrected(guess in 0.0..1.0_f64, n in 1..20_u64) {
            let equation = (10, Divisor::new(1).unwrap(), Divisor::new(n).unwrap());
            let exact = root(&Rational::from_unsigneds(1_u8, 10), &Natural::from(n), 400);
            let found = Fixed::<4>::point(guess).and_then(|y| y.corrected(&equation)).and_then(|y| y.interval(1));
            prop_assert!(found.is_none_or(|found| found.contains_interval(&exact)));
        }
    }
}
