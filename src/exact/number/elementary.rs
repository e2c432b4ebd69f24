//! Exponential and logarithm of rationals, enclosed between rationals.
//!
//! Contract: the true value lies in the closed interval returned, whose relative width is about
//! 2^−[`PRECISION`]; `None` where the result would be too large or too small to write down
//! (|x| > [`LARGEST`] for the exponential).
//!
//! Method: the argument is made small by halving (exponential) or by taking out powers of two
//! (logarithm), the series is summed with a bound on its rest, and every intermediate end is rounded
//! outward to a short dyadic. They serve the search for counterexamples only; where speed matters the
//! crate uses roots and powers.

use malachite::base::num::arithmetic::traits::{Ceiling, Floor, Pow};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::conversion::traits::ExactFrom;
use malachite::base::num::logic::traits::SignificantBits;
use malachite::{Integer, Natural, Rational};
use std::sync::OnceLock;

/// Bits kept of the ends of intervals.
pub const PRECISION: u64 = 224;

/// The largest size of an argument of the exponential.
pub const LARGEST: i64 = 2_000;

/// Two rationals with the value between them.
pub type Enclosure = (Rational, Rational);

/// q rounded to [`PRECISION`] significant bits, up or down.
fn rounded(q: &Rational, up: bool) -> Rational {
    if *q == 0 {
        return Rational::ZERO;
    }
    let bits = |n: u64| i64::try_from(n).unwrap_or(i64::MAX / 4);
    let size = bits(q.numerator_ref().significant_bits()) - bits(q.denominator_ref().significant_bits());
    let scale = Rational::from(2).pow(bits(PRECISION) - size);
    let scaled = q * &scale;
    let whole: Integer = if up { scaled.ceiling() } else { scaled.floor() };
    Rational::from(whole) / scale
}

fn outward((low, high): Enclosure) -> Enclosure {
    (rounded(&low, false), rounded(&high, true))
}

/// e^x for a rational x.
fn exp_of(x: &Rational) -> Option<Enclosure> {
    if *x == 0 {
        return Some((Rational::ONE, Rational::ONE));
    }
    if *x > LARGEST || *x < -LARGEST {
        return None;
    }
    // |x| ≤ 2^11, so 19 halvings bring it below 2^−8.
    const HALVINGS: u64 = 19;
    const TERMS: i64 = 25;
    let small = x / Rational::from(2).pow(HALVINGS);
    let (y_low, y_high) = (rounded(&small, false), rounded(&small, true));
    // With |y| ≤ 2^−8 the series after TERMS terms has a rest of at most 2·|y|^TERMS/TERMS!, below
    // 2^−282; the sum is between 1/2 and 2. Rounding y outward keeps e^y between the two sums.
    let rest = Rational::ONE / Rational::from(2).pow(282u64);
    let sum = |y: &Rational, up: bool| {
        // Horner's rule; each step rounds the partial sum, which is then multiplied by |y|/k < 1.
        let slack = Rational::ONE / Rational::from(2).pow(PRECISION + 2);
        let mut sum = Rational::ONE;
        for k in (1..TERMS).rev() {
            sum = rounded(&(Rational::ONE + sum * y / Rational::from(k)), up);
        }
        // A partial sum rounded the wrong way for negative y costs at most 2·2^−224·2^−8 here.
        if up { sum + &rest + slack } else { sum - &rest - slack }
    };
    let mut ends = outward((sum(&y_low, false), sum(&y_high, true)));
    for _ in 0..HALVINGS {
        ends = outward(((&ends.0).pow(2u64), (&ends.1).pow(2u64)));
    }
    Some(ends)
}

/// 2·artanh(z) for 0 ≤ z ≤ 1/3: 2·z times the sum of z^(2j)/(2j+1), which lies between 1 and 2.
fn twice_artanh(z: &Rational) -> Enclosure {
    // The rest after TERMS terms is at most z^(2·TERMS)/((2·TERMS + 1)·(1 − z²)) < 9^−TERMS/100 < 2^−260.
    const TERMS: u32 = 80;
    /// The sum is taken in whole multiples of 2^−SCALE, every part rounded the same way.
    const SCALE: u64 = 288;
    let one_sided = |up: bool| {
        let z = rounded(z, up);
        let fixed = |q: Rational| {
            let scaled = q << SCALE;
            Natural::exact_from(if up { scaled.ceiling() } else { scaled.floor() })
        };
        let carry = (Natural::ONE << SCALE) - Natural::ONE;
        let square = fixed(&z * &z);
        let (mut power, mut sum) = (Natural::ONE << SCALE, Natural::ZERO);
        for j in 0..TERMS {
            let odd = Natural::from(2 * j + 1);
            sum += if up { (&power + &odd - Natural::ONE) / odd } else { &power / odd };
            power *= &square;
            if up {
                power += &carry;
            }
            power >>= SCALE;
        }
        if up {
            sum += Natural::ONE << (SCALE - 260);
        }
        rounded(&(z * (Rational::from(sum) >> (SCALE - 1))), up)
    };
    (one_sided(false), one_sided(true))
}

/// ln 2.
fn ln_of_two() -> &'static Enclosure {
    static FOUND: OnceLock<Enclosure> = OnceLock::new();
    FOUND.get_or_init(|| twice_artanh(&Rational::from_signeds(1, 3)))
}

/// ln x for a rational x > 0.
fn ln_of(x: &Rational) -> Option<Enclosure> {
    if *x <= 0 {
        return None;
    }
    if *x == 1 {
        return Some((Rational::ZERO, Rational::ZERO));
    }
    let bits = |n: u64| i64::try_from(n).ok();
    // x = m·2^k with m in (1/2, 2); then ln m = ±2·artanh(|m − 1|/(m + 1)), whose argument is below 1/3.
    let k = bits(x.numerator_ref().significant_bits())? - bits(x.denominator_ref().significant_bits())?;
    let m = x / Rational::from(2).pow(k);
    let (size, negative) = if m < 1 { (Rational::ONE - &m, true) } else { (&m - Rational::ONE, false) };
    let (low, high) = twice_artanh(&(size / (m + Rational::ONE)));
    let (low, high) = if negative { (-high, -low) } else { (low, high) };
    let two = ln_of_two();
    let times = Rational::from(k);
    let (a, b) = if k < 0 { (&two.1, &two.0) } else { (&two.0, &two.1) };
    Some(outward((low + a * &times, high + b * times)))
}

/// e^x for x between two rationals.
#[must_use]
pub fn exp(low: &Rational, high: &Rational) -> Option<Enclosure> {
    let (least, most) = exp_of(low)?;
    Some((least, if low == high { most } else { exp_of(high)?.1 }))
}

/// ln x for x between two positive rationals; `None` where the lower is not positive.
#[must_use]
pub fn ln(low: &Rational, high: &Rational) -> Option<Enclosure> {
    let (least, most) = ln_of(low)?;
    Some((least, if low == high { most } else { ln_of(high)?.1 }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn q(text: &str) -> Rational {
        crate::number::rational::parse(text).expect("a rational")
    }

    fn contains((low, high): &Enclosure, digits: &str) {
        // The decimal expansion cut after its last digit: the value lies within one unit of it.
        let (cut, places) = (q(digits), digits.len() - digits.find('.').map_or(0, |p| p + 1));
        let unit = Rational::ONE / Rational::from(10).pow(places as u64);
        assert!(*low <= &cut + &unit && *high >= cut, "{digits}");
        assert!(high - low < unit, "{digits}: too wide");
    }

    #[test]
    fn known_values_lie_inside() {
        contains(&exp(&q("1"), &q("1")).expect("e"), "2.7182818284590452353602874713526624977572470936999");
        contains(&exp(&q("-5/2"), &q("-5/2")).expect("e"), "0.0820849986238987951695286744671598078378041210");
        contains(&exp(&q("100"), &q("100")).expect("e"), "26881171418161354484126255515800135873611118.77374192");
        contains(&ln(&q("2"), &q("2")).expect("ln"), "0.6931471805599453094172321214581765680755001343602552");
        contains(&ln(&q("10"), &q("10")).expect("ln"), "2.3025850929940456840179914546843642076011014886287729");
        contains(&ln(&q("1e300"), &q("1e300")).expect("ln"), "690.77552789821370520539743640530926228033044658863189");
        assert!(ln(&q("0"), &q("1")).is_none() && exp(&q("0"), &q("1000000")).is_none());
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        #[test]
        fn exponential_and_logarithm_undo_each_other(n in -40_000i64..40_000, d in 1i64..2_000) {
            let x = Rational::from_signeds(n, d);
            let Some((low, high)) = exp(&x, &x) else {
                prop_assert!(!(-LARGEST..=LARGEST).contains(&x), "{x} is within the limit");
                return Ok(());
            };
            prop_assert!(low <= high && low > 0);
            let back = ln(&low, &high).expect("positive");
            prop_assert!(back.0 <= x && x <= back.1);
            prop_assert!(&back.1 - &back.0 < Rational::ONE / Rational::from(2).pow(150u64));
        }

        #[test]
        fn the_exponential_of_a_sum_is_the_product(a in -900i64..900, b in -900i64..900, d in 1i64..50) {
            let (x, y) = (Rational::from_signeds(a, d), Rational::from_signeds(b, d));
            let sum = exp(&(&x + &y), &(&x + &y)).expect("moderate");
            let (p, r) = (exp(&x, &x).expect("moderate"), exp(&y, &y).expect("moderate"));
            prop_assert!(&p.0 * &r.0 <= sum.1 && sum.0 <= &p.1 * &r.1);
        }
    }
}
