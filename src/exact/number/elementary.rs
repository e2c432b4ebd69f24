//! Exponential, logarithm, cosine and sine of rationals, and π, enclosed between rationals.
//!
//! Contract: the true value lies in the closed interval returned, whose relative width is about
//! 2^−[`PRECISION`]; `None` where the result would be too large or too small to write down
//! (|x| > [`LARGEST`] for the exponential, cosine and sine).
//!
//! Method: the argument is made small by halving (exponential) or by taking out powers of two
//! (logarithm) or full turns (cosine and sine), the series is summed with a bound on its rest, and every intermediate end is rounded
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

/// Fixed point: whole multiples of 2^−SCALE.
const SCALE: u64 = 288;

/// π = 16·arctan(1/5) − 4·arctan(1/239).
#[must_use]
pub fn pi() -> &'static Enclosure {
    static FOUND: OnceLock<Enclosure> = OnceLock::new();
    FOUND.get_or_init(|| {
        // Σ (−1)^j/((2j + 1)·k^(2j + 1)): the terms behind the 70th come to less than 5^−141 < 2^−320, and each of 70 is rounded
        // down by at most one unit of 2^−SCALE.
        let arctan = |k: i64| {
            let mut sum = Integer::ZERO;
            for j in 0..70u64 {
                let below = Integer::from(k).pow(2 * j + 1) * Integer::from(2 * j + 1);
                let term = (Integer::ONE << SCALE) / below;
                if j % 2 == 0 { sum += term } else { sum -= term }
            }
            sum
        };
        let sum = arctan(5) * Integer::from(16) - arctan(239) * Integer::from(4);
        let slack = Integer::from(20 * 72);
        outward((Rational::from(&sum - &slack) >> SCALE, Rational::from(sum + slack) >> SCALE))
    })
}

/// arctan x for x between two rationals. It rises.
#[must_use]
pub fn arctan(low: &Rational, high: &Rational) -> Enclosure {
    let (least, most) = arctan_of(low);
    (least, if low == high { most } else { arctan_of(high).1 })
}

/// arctan x: π/2 less arctan(1/x) for x > 1, and arctan(1/2) + arctan((2·x − 1)/(x + 2)) for 0 ≤ x ≤ 1, whose last argument lies between −1/2
/// and 1/3.
fn arctan_of(x: &Rational) -> Enclosure {
    static HALF: OnceLock<Enclosure> = OnceLock::new();
    if *x < 0 {
        let (low, high) = arctan_of(&-x);
        return (-high, -low);
    }
    if *x > 1 {
        let (low, high) = arctan_of(&(Rational::ONE / x));
        let quarter = |pi: &Rational| pi / Rational::from(2);
        return outward((quarter(&pi().0) - high, quarter(&pi().1) - low));
    }
    if *x == 0 {
        return (Rational::ZERO, Rational::ZERO);
    }
    let half = HALF.get_or_init(|| small_arctan(&Rational::from_signeds(1, 2)));
    let two = Rational::from(2);
    let rest = small_arctan(&((x * &two - Rational::ONE) / (x + two)));
    outward((&half.0 + rest.0, &half.1 + rest.1))
}

/// arctan y for |y| ≤ 1/2: Σ (−1)^j·y^(2j + 1)/(2j + 1) in whole multiples of 2^−SCALE.
///
/// What is left behind the 125th term is below 2^−251/251 < 2^−258. y is off by one unit, so y² by two at most, and y^(2j + 1) by at most four,
/// since each step divides an error by four or more and adds two; each of 125 terms is rounded by one unit more. That is less than
/// 2^10 units, and all together less than 2^31 of them.
fn small_arctan(y: &Rational) -> Enclosure {
    let mut power = (y << SCALE).floor();
    let square = (&power * &power) >> SCALE;
    let mut sum = Integer::ZERO;
    for j in 0..125u64 {
        let term = &power / Integer::from(2 * j + 1);
        if j % 2 == 0 {
            sum += term
        } else {
            sum -= term
        }
        power = (power * &square) >> SCALE;
    }
    let slack = Integer::ONE << 31u64;
    outward((Rational::from(&sum - &slack) >> SCALE, Rational::from(sum + slack) >> SCALE))
}

/// cos x and sin x for x between two rationals: those of the first, as much wider as these are apart.
#[must_use]
pub fn cos_sin(low: &Rational, high: &Rational) -> Option<(Enclosure, Enclosure)> {
    if *low > LARGEST || *low < -LARGEST {
        return None;
    }
    if *low == 0 && *high == 0 {
        return Some(((Rational::ONE, Rational::ONE), (Rational::ZERO, Rational::ZERO)));
    }
    // t = x − k·2π lies between −3.2 and 3.2, and its enclosure is |k|·2^−220 wide at most.
    let turn = (&pi().0 * Rational::from(2), &pi().1 * Rational::from(2));
    let turns = (low / &turn.0 + Rational::from_signeds(1, 2)).floor();
    let k = Rational::from(&turns);
    let (near, far) = if k < 0 { (&turn.0, &turn.1) } else { (&turn.1, &turn.0) };
    let (t, most) = (low - near * &k, low - far * &k);
    let width = most - &t + (high - low);
    // Terms tⁿ/n! rounded down to multiples of 2^−SCALE. An error of e units in one is at most 4·e/(n + 1) in the next, where it
    // grows by 12 units at most, since a term is below 11 and t is off by one unit. All errors together are below 2^21
    // units, and what is left behind the 99th term is below 3.2^100/100! < 2^−340.
    let scaled = (t << SCALE).floor();
    let mut term = Integer::ONE << SCALE;
    let mut sums = [Integer::ZERO, Integer::ZERO];
    for n in 0..100u64 {
        let sum = &mut sums[(n % 2) as usize];
        if n % 4 < 2 {
            *sum += &term
        } else {
            *sum -= &term
        }
        term = ((term * &scaled) >> SCALE) / Integer::from(n + 1);
    }
    let wider = |sum: &Integer| {
        let middle = Rational::from(sum) >> SCALE;
        let slack = &width + (Rational::ONE >> 256u64);
        outward(((&middle - &slack).max(-Rational::ONE), (middle + slack).min(Rational::ONE)))
    };
    Some((wider(&sums[0]), wider(&sums[1])))
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
        contains(pi(), "3.1415926535897932384626433832795028841971693993751058");
        let (cos, sin) = cos_sin(&q("1"), &q("1")).expect("small");
        contains(&cos, "0.5403023058681397174009366074429766037323104206179");
        contains(&sin, "0.8414709848078965066525023216302989996225630607983");
        let (cos, sin) = cos_sin(&q("1000"), &q("1000")).expect("moderate");
        contains(&cos, "0.562379076290702991078249226605395968755811821738196");
        contains(&sin, "0.826879540532002560255887429109218141212724967847788");
        contains(&arctan(&q("1/10"), &q("1/10")), "0.0996686524911620273784461198780205902432783225043146");
        contains(&arctan(&q("1"), &q("1")), "0.78539816339744830961566084581987572104929234984377");
        contains(&arctan(&q("1000"), &q("1000")), "1.569796327128229752564797882004830898086963");
        let (low, high) = arctan(&q("-3"), &q("-3"));
        contains(&(-high, -low), "1.249045772398254425829917077281090123077829404129");
        assert!(cos_sin(&q("1e9"), &q("1e9")).is_none());
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
        fn the_tangent_of_an_arc_is_its_argument(n in -90_000i64..90_000, d in 1i64..3_000) {
            let x = Rational::from_signeds(n, d);
            let (low, high) = arctan(&x, &x);
            prop_assert!(low <= high && &high - &low < Rational::ONE / Rational::from(2).pow(200u64));
            let (cosine, sine) = cos_sin(&low, &high).expect("small");
            // sin θ = x·cos θ, and the cosine is not negative.
            let ends = [&x * &cosine.0, &x * &cosine.1];
            let (least, most) = if x < 0 { (&ends[1], &ends[0]) } else { (&ends[0], &ends[1]) };
            prop_assert!(cosine.1 > 0 && sine.0 <= *most && sine.1 >= *least);
        }

        #[test]
        fn the_exponential_of_a_sum_is_the_product(a in -900i64..900, b in -900i64..900, d in 1i64..50) {
            let (x, y) = (Rational::from_signeds(a, d), Rational::from_signeds(b, d));
            let sum = exp(&(&x + &y), &(&x + &y)).expect("moderate");
            let (p, r) = (exp(&x, &x).expect("moderate"), exp(&y, &y).expect("moderate"));
            prop_assert!(&p.0 * &r.0 <= sum.1 && sum.0 <= &p.1 * &r.1);
        }

        #[test]
        fn cosines_and_sines_of_sums_follow_the_addition_formulas(a in -9_000i64..9_000, b in -9_000i64..9_000, d in 1i64..50) {
            let (x, y) = (Rational::from_signeds(a, d * 10), Rational::from_signeds(b, d * 10));
            let of = |x: &Rational| cos_sin(x, x).expect("moderate");
            let mid = |e: &Enclosure| (&e.0 + &e.1) / Rational::from(2);
            let ((c, s), (k, t), sum) = (of(&x), of(&y), of(&(&x + &y)));
            let cosine = mid(&c) * mid(&k) - mid(&s) * mid(&t);
            let near = Rational::ONE >> 190u64;
            prop_assert!(&sum.0.0 - &near <= cosine && cosine <= &sum.0.1 + &near);
            prop_assert!(&sum.0.1 - &sum.0.0 < near && &sum.1.1 - &sum.1.0 < near);
        }
    }
}
