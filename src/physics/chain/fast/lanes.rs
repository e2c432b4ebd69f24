//! Doubles side by side, and pairs of them: sums, products, quotients and powers in double-double.

use std::ops::{Add, Div, Mul, Sub};

/// A double of each of `N` cells, computed side by side: what one waits for fills the time of another, and some share an
/// instruction. `FUSED` where the processor multiplies and adds in one: otherwise that would be slow. Both give the same.
#[derive(Clone, Copy)]
pub(super) struct Lanes<const N: usize, const FUSED: bool>(pub(super) [f64; N]);

impl<const N: usize, const FUSED: bool> Lanes<N, FUSED> {
    #[inline(always)]
    pub(super) fn map(self, with: impl Fn(f64) -> f64) -> Self {
        Lanes(self.0.map(with))
    }

    #[inline(always)]
    pub(super) fn each(mut self, other: Self, with: impl Fn(f64, f64) -> f64) -> Self {
        for (a, b) in self.0.iter_mut().zip(other.0) {
            *a = with(*a, b);
        }
        self
    }

    /// `self = high + low` with 26 bits each (Veltkamp).
    #[inline(always)]
    fn split(self) -> (Self, Self) {
        let c = Lanes::from(134_217_729.0) * self;
        let high = c - (c - self);
        (high, self - high)
    }

    /// `self·b` exactly.
    #[inline(always)]
    pub(super) fn product(self, b: Self) -> Pair<N, FUSED> {
        let p = self * b;
        let low = if FUSED {
            Lanes(std::array::from_fn(|i| self.0[i].mul_add(b.0[i], -p.0[i])))
        } else {
            // Dekker.
            let ((ah, al), (bh, bl)) = (self.split(), b.split());
            ((ah * bh - p) + ah * bl + al * bh) + al * bl
        };
        Pair { high: p, low }
    }

    /// `self + b = s + error` for `|self| >= |b|` (Dekker).
    #[inline(always)]
    pub(super) fn fast_sum(self, b: Self) -> Pair<N, FUSED> {
        let s = self + b;
        Pair { high: s, low: b - (s - self) }
    }
}

impl<const N: usize, const FUSED: bool> From<f64> for Lanes<N, FUSED> {
    #[inline(always)]
    fn from(x: f64) -> Self {
        Lanes([x; N])
    }
}

impl<const N: usize, const FUSED: bool> Add for Lanes<N, FUSED> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.each(other, |a, b| a + b)
    }
}

impl<const N: usize, const FUSED: bool> Sub for Lanes<N, FUSED> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.each(other, |a, b| a - b)
    }
}

impl<const N: usize, const FUSED: bool> Mul for Lanes<N, FUSED> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.each(other, |a, b| a * b)
    }
}

impl<const N: usize, const FUSED: bool> Div for Lanes<N, FUSED> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        self.each(other, |a, b| a / b)
    }
}

/// `high + low`, not evaluated.
#[derive(Clone, Copy)]
pub(super) struct Pair<const N: usize, const FUSED: bool> {
    pub(super) high: Lanes<N, FUSED>,
    pub(super) low: Lanes<N, FUSED>,
}

impl<const N: usize, const FUSED: bool> Pair<N, FUSED> {
    #[inline(always)]
    pub(super) fn exact(x: Lanes<N, FUSED>) -> Self {
        Pair { high: x, low: Lanes::from(0.0) }
    }

    #[inline(always)]
    pub(super) fn square(self) -> Self {
        let p = self.high.product(self.high);
        p.high.fast_sum(p.low + Lanes::from(2.0) * (self.high * self.low))
    }

    #[inline(always)]
    pub(super) fn times(self, other: Self) -> Self {
        let p = self.high.product(other.high);
        p.high.fast_sum(p.low + (self.high * other.low + self.low * other.high))
    }

    #[inline(always)]
    pub(super) fn times_double(self, other: Lanes<N, FUSED>) -> Self {
        let p = self.high.product(other);
        p.high.fast_sum(p.low + self.low * other)
    }

    #[inline(always)]
    pub(super) fn over(self, other: Self) -> Self {
        let q = self.high / other.high;
        let p = q.product(other.high);
        // self.high − p.high is exact: the two agree to a few ulps.
        let rest = ((self.high - p.high) - p.low) + (self.low - q * other.low);
        q.fast_sum(rest / other.high)
    }

    /// Two powers with the same exponent, at least 1; side by side they keep the processor busy.
    #[inline(always)]
    pub(super) fn powers(a: Self, b: Self, exponent: u64) -> (Self, Self) {
        let (mut x, mut y) = (a, b);
        let mut mask = (1_u64 << exponent.ilog2()) >> 1;
        while mask != 0 {
            (x, y) = (x.square(), y.square());
            if exponent & mask != 0 {
                (x, y) = (x.times(a), y.times(b));
            }
            mask >>= 1;
        }
        (x, y)
    }
}
