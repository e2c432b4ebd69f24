//! Numbers as decimals, rounded in one of five directions and written as tables write them.
//!
//! Contract: rounding is monotone. If the decimals of a lower and of an upper bound are the same text, that is the
//! decimal of every number between them. Numbers are not negative.

use super::dyadic::{Dyadic, Toward};
use super::failure::{Failure, declined, rejected};
use super::work::Work;
use num_bigint::BigUint;
use num_rational::BigRational;
use num_traits::{One, Zero};
use std::cmp::Ordering;

/// The most digits of a printed number.
pub(crate) const DIGITS_LIMIT: u64 = 10_000;
/// Powers of ten up to this one are exact.
const EXACT_POWER: u64 = 5_000;
/// The most powers of ten by which a rational is scaled.
const SCALE_LIMIT: u64 = 1 << 20;

/// How many digits are printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Digits {
    /// So many significant ones.
    Significant(u64),
    /// So many after the point.
    Places(u64),
}

/// The direction of rounding.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Rounding {
    /// To the nearest, ties to the even digit.
    NearestEven,
    /// Never below the value.
    Up,
    /// Never above the value.
    Down,
    /// Towards zero.
    Zero,
    /// Away from zero.
    Away,
}

/// `above/below` as an integer. With remainder 0 every direction gives the quotient.
fn integer(above: &BigUint, below: &BigUint, rounding: Rounding) -> BigUint {
    let quotient = above / below;
    let rest = above - &quotient * below;
    let next = match rounding {
        Rounding::Down | Rounding::Zero => false,
        Rounding::Up | Rounding::Away => !rest.is_zero(),
        Rounding::NearestEven => match (&rest << 1u32).cmp(below) {
            Ordering::Less => false,
            Ordering::Greater => true,
            Ordering::Equal => quotient.bit(0),
        },
    };
    if next { quotient + 1u32 } else { quotient }
}

fn power_of_ten(places: u64, work: &Work) -> Result<BigUint, Failure> {
    // Fewer than four bits for each place; the squares before the last one take less than that one.
    work.product(4 * places, 4 * places)?;
    Ok(BigUint::from(10u32).pow(u32::try_from(places).unwrap_or(u32::MAX)))
}

/// The decimal of a number of which `scaled(p)` is `10^p` times, as a fraction; `top` is about its binary logarithm.
///
/// For significant digits the place of the first one is found by trial: it is right iff the scaled number, cut to an
/// integer, has as many digits as are asked for.
fn decimal(
    scaled: impl Fn(i64) -> Result<(BigUint, BigUint), Failure>,
    top: i64,
    digits: Digits,
    rounding: Rounding,
    work: &Work,
) -> Result<String, Failure> {
    // The quotient, and its digits.
    let divided = |above: &BigUint, below: &BigUint| {
        let bits = above.bits().saturating_sub(below.bits());
        work.quotient(bits, below.bits())?;
        work.quotient(bits, bits)
    };
    let wanted = match digits {
        Digits::Places(places) => {
            let places = i64::try_from(places).unwrap_or(i64::MAX);
            let (above, below) = scaled(places)?;
            divided(&above, &below)?;
            return written(integer(&above, &below, rounding).to_string(), -places, true);
        }
        Digits::Significant(wanted) => i64::try_from(wanted).unwrap_or(i64::MAX),
    };
    // log10(2) to 18 digits: off by a few places at most.
    let guess = i128::from(top) * 301_029_995_663_981_195 / 1_000_000_000_000_000_000;
    let mut leading = i64::try_from(guess).unwrap_or(0);
    for _ in 0..12 {
        let places = wanted - 1 - leading;
        let (above, below) = scaled(places)?;
        divided(&above, &below)?;
        let whole = integer(&above, &below, Rounding::Down);
        let length = if whole.is_zero() { 0 } else { i64::try_from(whole.to_string().len()).unwrap_or(i64::MAX) };
        if length == wanted {
            let mut text = integer(&above, &below, rounding).to_string();
            // Rounded up to the next power of ten: one digit more, and it is a zero.
            let carried = i64::try_from(text.len()).unwrap_or(i64::MAX) > wanted;
            if carried {
                text.pop();
            }
            return written(text, i64::from(carried) - places, false);
        }
        leading += (length - wanted).clamp(-64, 64);
    }
    declined("attempts at the first digit")
}

/// `digits·10^exponent` as tables write it: plainly for places, and for significant digits from 10^-6 to 10^20.
fn written(digits: String, exponent: i64, plain: bool) -> Result<String, Failure> {
    let length = i64::try_from(digits.len()).unwrap_or(i64::MAX);
    let leading = length - 1 + exponent;
    if !(plain || exponent <= 0 && (-6..=20).contains(&leading)) {
        let (first, rest) = digits.split_at(1);
        let point = if rest.is_empty() { "" } else { "." };
        return Ok(format!("{first}{point}{rest}e{leading}"));
    }
    // Plain numbers have no positive exponent: places are not negative.
    let after = usize::try_from(-exponent).unwrap_or(usize::MAX);
    if after == 0 {
        Ok(digits)
    } else if after < digits.len() {
        let (whole, part) = digits.split_at(digits.len() - after);
        Ok(format!("{whole}.{part}"))
    } else {
        Ok(format!("0.{}{digits}", "0".repeat(after - digits.len())))
    }
}

/// The decimal of a rational, exactly.
pub(crate) fn of_ratio(x: &BigRational, digits: Digits, rounding: Rounding, work: &Work) -> Result<String, Failure> {
    let (above, below) = (x.numer().magnitude(), x.denom().magnitude());
    let scaled = |places: i64| {
        if places.unsigned_abs() > SCALE_LIMIT {
            return declined("powers of ten of an exact value");
        }
        let power = power_of_ten(places.unsigned_abs(), work)?;
        work.product(power.bits(), if places >= 0 { above.bits() } else { below.bits() })?;
        Ok(if places >= 0 { (above * power, below.clone()) } else { (above.clone(), below * power) })
    };
    let top = |x: &BigUint| i64::try_from(x.bits()).unwrap_or(i64::MAX);
    decimal(scaled, top(above) - top(below), digits, rounding, work)
}

/// The decimal of a number that bounds `x`: from below for [`Toward::Down`], from above for [`Toward::Up`].
///
/// It is `x` itself where the power of ten that it is scaled by is exact; else that power is rounded, and so is the number,
/// in the direction asked for. So the decimals of a lower and an upper end that agree are those of what lies between.
pub(crate) fn of_end(
    x: &Dyadic,
    digits: Digits,
    rounding: Rounding,
    toward: Toward,
    work: &Work,
) -> Result<String, Failure> {
    if x.is_zero() && matches!(digits, Digits::Significant(_)) {
        return rejected("an enclosure that reaches 0 has no significant digits");
    }
    let scaled = |places: i64| {
        let size = places.unsigned_abs();
        let (mantissa, _) = x.parts();
        let wide = if size <= EXACT_POWER { u64::MAX } else { mantissa.bits() + 64 };
        if places < 0 && size > EXACT_POWER {
            return declined("powers of ten of an enclosure");
        }
        // 10^p is 5^p·2^p.
        let five = Dyadic::new(BigUint::from(5u32), 0);
        let power = if size == 0 { Dyadic::one() } else { five.power(&size.into(), wide, toward, work)? };
        let (times, below) = if places < 0 { (Dyadic::one(), power) } else { (power, Dyadic::one()) };
        work.product(mantissa.bits(), times.parts().0.bits())?;
        let (above, exponent) = x.times(&times, u64::MAX, toward)?.scaled(places)?.into_parts();
        let below = below.into_parts().0;
        fraction(above, exponent, below)
    };
    decimal(scaled, x.top(), digits, rounding, work)
}

/// `above·2^exponent/below` as a fraction.
///
/// What is below 1/4 stands as 1/4: as an integer both are the same in every direction, and neither has a leading digit.
fn fraction(above: BigUint, exponent: i64, below: BigUint) -> Result<(BigUint, BigUint), Failure> {
    let places = exponent.unsigned_abs();
    if exponent >= 0 {
        if places > 8 * DIGITS_LIMIT {
            return declined("digits of an enclosure");
        }
        return Ok((above << places, below));
    }
    if above.is_zero() {
        return Ok((above, below));
    }
    if places > above.bits() + 2 {
        return Ok((BigUint::one(), BigUint::from(4u32)));
    }
    Ok((above, below << places))
}
