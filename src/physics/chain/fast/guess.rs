//! Guesses of roots by a short logarithm and exponential, which all machines compute alike.

use super::SORTED;
use super::lanes::Lanes;

/// `2^52`: doubles from here to its double are whole, and end with their bits.
const WHOLE: f64 = f64::from_bits((1023 + 52) << 52);

impl<const N: usize, const FUSED: bool> Lanes<N, FUSED> {
    /// `self^(1/collisions)`, nearly, for positive doubles that are not subnormal.
    #[inline(always)]
    pub(super) fn guessed_root(self, collisions: u64) -> Self {
        match collisions {
            1 => self,
            2..=SORTED => (self.guessed_log2() * Lanes::from(1.0 / collisions as f64)).guessed_exp2(),
            // Here ρ = N·(the relative error) leaves less room.
            _ => self.map(|r| r.powf(1.0 / collisions as f64)),
        }
    }

    /// The logarithm to base 2 within `2^-41`, as `r = 2^k·m`, `m` between `√½` and `√2`, and
    /// `ln m = 2·(s + s³/3 + s⁵/5 + …)`, `s = (m − 1)/(m + 1)`, where `s² < 0.03`.
    #[inline(always)]
    fn guessed_log2(self) -> Self {
        const fn term(j: u32) -> f64 {
            2.0 / ((2 * j + 1) as f64 * std::f64::consts::LN_2)
        }
        let low = std::f64::consts::FRAC_1_SQRT_2.to_bits();
        let scaled = self.0.map(|r| r.to_bits().wrapping_sub(low).wrapping_add(1023 << 52));
        let k = Lanes(scaled.map(|bits| f64::from_bits(bits >> 52 | WHOLE.to_bits()) - (WHOLE + 1023.0)));
        let m = Lanes(scaled.map(|bits| f64::from_bits((bits & ((1 << 52) - 1)) + low)));
        let s = (m - Lanes::from(1.0)) / (m + Lanes::from(1.0));
        let q = s * s;
        k + s
            * (q.cubic(const { [term(0), term(1), term(2), term(3)] })
                + (q * q) * (q * q) * q.cubic(const { [term(4), term(5), term(6), term(7)] }))
    }

    /// 2 to the power of this within a factor of `1 ± 2^-46`, for exponents that a double has: `2^(k + f) = 2^k·e^(f·ln 2)`
    /// with `|f| <= 1/2`, and the first twelve terms of the series of `e^z`, `|z| < 0.35`.
    #[inline(always)]
    fn guessed_exp2(self) -> Self {
        const fn term(j: u32) -> f64 {
            if j == 0 { 1.0 } else { term(j - 1) * std::f64::consts::LN_2 / j as f64 }
        }
        // The sum's last bits are the nearest whole number.
        let shifted = self + Lanes::from(1.5 * WHOLE);
        let f = self - (shifted - Lanes::from(1.5 * WHOLE));
        let fourth = (f * f) * (f * f);
        let power = f.cubic(const { [term(0), term(1), term(2), term(3)] })
            + fourth
                * (f.cubic(const { [term(4), term(5), term(6), term(7)] })
                    + fourth * f.cubic(const { [term(8), term(9), term(10), term(11)] }));
        Lanes(std::array::from_fn(|i| f64::from_bits(power.0[i].to_bits().wrapping_add(shifted.0[i].to_bits() << 52))))
    }

    /// `a + b·x + c·x² + d·x³`.
    #[inline(always)]
    fn cubic(self, [a, b, c, d]: [f64; 4]) -> Self {
        (Lanes::from(a) + Lanes::from(b) * self) + (self * self) * (Lanes::from(c) + Lanes::from(d) * self)
    }
}

#[cfg(test)]
mod tests {
    use super::Lanes;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn guesses_are_near(power in -1000.0..1000.0_f64, small in -1.0..1.0_f64) {
            let of = |x: f64| Lanes::<1, false>([x]);
            for power in [power, small, small * 1e-9] {
                let r = power.exp2();
                prop_assert!((of(r).guessed_log2().0[0] - r.log2()).abs() <= 2f64.powi(-41));
                prop_assert!((of(power).guessed_exp2().0[0] / r - 1.0).abs() <= 2f64.powi(-46));
            }
        }
    }
}
