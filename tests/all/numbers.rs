//! Inclusion laws of the number levels: whatever an operation gives on elements lies in what it gives on sets.
#![allow(clippy::unwrap_used)] // a test stops where it fails

use carom::number::decimal::{Decimal, Digits, Rounding, outward};
use carom::number::double::Double;
use carom::number::interval::Interval;
use carom::number::radical::Field;
use carom::number::rational::exact_root;
use carom::number::real::Real;
use carom::number::root::{guess_ln, root};
use malachite::base::num::arithmetic::traits::{Abs, Pow, PowerOf2, Reciprocal};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::{Integer, Natural, Rational};
use proptest::prelude::*;
use std::cmp::Ordering;

/// A set and one of its elements.
#[derive(Clone, Debug)]
struct Member {
    set: Interval,
    element: Rational,
}

fn dyadic(mantissa: &Integer, exponent: i64) -> Rational {
    Rational::from(mantissa) * Rational::power_of_2(exponent)
}

fn integers() -> impl Strategy<Value = Integer> {
    let digits = prop::collection::vec(any::<u64>(), 0..5);
    prop_oneof![
        (-3i64..=3).prop_map(Integer::from),
        any::<i64>().prop_map(Integer::from),
        (0u64..200, any::<bool>(), -1i64..=1).prop_map(|(k, negative, off)| {
            let x = Integer::power_of_2(k) + Integer::from(off);
            if negative { -x } else { x }
        }),
        (digits, any::<bool>()).prop_map(|(limbs, negative)| {
            let x = limbs.into_iter().fold(Integer::ZERO, |x, limb| (x << 64u32) + Integer::from(limb));
            if negative { -x } else { x }
        }),
    ]
}

fn members() -> impl Strategy<Value = Member> {
    let radius = prop_oneof![Just(0u64), 1u64..4, any::<u32>().prop_map(u64::from), any::<u64>().prop_map(|x| x >> 1)];
    let exponent = prop_oneof![Just(0i64), -8i64..8, -400i64..400];
    (integers(), radius, exponent, -4i64..=4).prop_map(|(mid, radius, exponent, part)| {
        let centre = Interval::from_dyadic(mid.clone(), exponent);
        let set = centre.widened(&Interval::from_dyadic(Integer::from(radius), exponent));
        let reach = Rational::from(radius) * Rational::from_signeds(part, 4);
        let element = (Rational::from(mid) + reach) * Rational::power_of_2(exponent);
        Member { set, element }
    })
}

fn precisions() -> impl Strategy<Value = u64> {
    prop_oneof![1u64..8, 8u64..300]
}

fn positive_rationals() -> impl Strategy<Value = Rational> {
    let size = || prop_oneof![1u64..20, 1u64..1 << 40, any::<u64>().prop_map(|x| x | 1)];
    (size(), size(), -300i64..300).prop_map(|(p, q, k)| Rational::from_unsigneds(p, q) * Rational::power_of_2(k))
}

fn degrees() -> impl Strategy<Value = u64> {
    prop_oneof![1u64..13, 13u64..200]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, ..ProptestConfig::default() })]

    #[test]
    fn members_are_contained(a in members(), bits in precisions()) {
        prop_assert!(a.set.contains(&a.element));
        prop_assert!(a.set.round(bits).contains(&a.element));
        prop_assert!(a.set.round(bits).contains_interval(&a.set));
        let (lo, hi) = a.set.to_f64_ends();
        prop_assert!(lo == f64::NEG_INFINITY || Rational::try_from(lo).unwrap() <= a.element);
        prop_assert!(hi == f64::INFINITY || Rational::try_from(hi).unwrap() >= a.element);
        match a.set.sign() {
            Some(sign) => prop_assert_eq!(sign, a.element.partial_cmp(&Rational::ZERO).unwrap()),
            None => prop_assert!(!a.set.is_point()),
        }
        prop_assert!(a.set.is_whole() || a.element == 0 || (&a.element).abs() < Rational::power_of_2(a.set.top()));
    }

    #[test]
    fn sums_differences_products_quotients(a in members(), b in members(), bits in precisions()) {
        prop_assert!(a.set.add(&b.set, bits).contains(&(&a.element + &b.element)));
        prop_assert!(a.set.subtract(&b.set, bits).contains(&(&a.element - &b.element)));
        prop_assert!(a.set.multiply(&b.set, bits).contains(&(&a.element * &b.element)));
        prop_assert!(a.set.widened(&b.set).contains(&(&a.element + &b.element)));
        prop_assert!(a.set.widened(&b.set).contains(&(&a.element - &b.element)));
        let quotient = a.set.divide(&b.set, bits);
        prop_assert!(quotient.is_whole() || b.element != 0);
        if b.element != 0 {
            prop_assert!(quotient.contains(&(&a.element / &b.element)));
            prop_assert!(b.set.reciprocal(bits).contains(&(&b.element).reciprocal()));
        }
    }

    #[test]
    fn squares_powers_and_rational_factors(a in members(), x in integers(), y in positive_rationals(), k in 0u64..12, bits in precisions()) {
        prop_assert!(a.set.square(bits).contains(&(&a.element * &a.element)));
        prop_assert!(a.set.power(&Natural::from(k), bits).contains(&(&a.element).pow(k)));
        let factor = Rational::from(x) * y;
        prop_assert!(a.set.multiply_rational(&factor, bits).contains(&(&a.element * &factor)));
        prop_assert!(Interval::from_rational(&factor, bits).contains(&factor));
        let divisor = factor.to_numerator();
        let quotient = a.set.divide_by_natural(&divisor, bits);
        if divisor == 0 {
            prop_assert!(quotient.is_whole());
        } else {
            prop_assert!(quotient.contains(&(&a.element / Rational::from(divisor))));
        }
    }

    #[test]
    fn exact_operations_keep_points(a in integers(), b in integers(), k in -100i64..100) {
        let (x, y) = (Interval::from_dyadic(a.clone(), k), Interval::from_integer(b.clone()));
        prop_assert!(x.multiply(&y, 1000).is_point());
        prop_assert!(x.add(&y, 1000).is_point());
        prop_assert_eq!(x.add(&y, 1000).point(), Some(dyadic(&a, k) + Rational::from(b)));
    }

    #[test]
    fn accuracy_is_as_asked(x in positive_rationals(), y in positive_rationals(), bits in 8u64..300) {
        let set = |x: &Rational| Interval::from_rational(x, bits);
        let enough = |x: &Interval| x.accuracy().saturating_add(6) >= bits;
        prop_assert!(enough(&set(&x)));
        prop_assert!(enough(&set(&x).multiply(&set(&y), bits)));
        prop_assert!(enough(&set(&x).divide(&set(&y), bits)));
        prop_assert!(enough(&set(&x).reciprocal(bits)));
    }

    #[test]
    fn square_roots_square_back(a in members(), bits in precisions()) {
        match a.set.square_root(bits).ends() {
            Some((lo, hi)) => {
                let (lo, hi) = (lo.point().unwrap(), hi.point().unwrap());
                prop_assert!(a.element >= 0 && hi >= 0 && a.element <= (&hi).pow(2_u64));
                prop_assert!(lo <= 0 || lo.pow(2_u64) <= a.element);
            }
            None => prop_assert!(a.set.sign() != Some(Ordering::Greater)),
        }
    }

    #[test]
    fn square_roots_are_as_accurate_as_asked(r in positive_rationals(), k in 1u64..9, bits in 8u64..2000) {
        let y = root(&r, &Natural::power_of_2(k), bits);
        prop_assert!(y.accuracy().saturating_add(1) >= bits, "{bits} bits asked, {} found", y.accuracy());
        let whole = Rational::from_unsigneds(3_u8, 7).pow(2_u64);
        prop_assert!(root(&whole, &Natural::power_of_2(1), bits).contains(&Rational::from_unsigneds(3_u8, 7)));
    }

    #[test]
    fn roots_power_back(r in positive_rationals(), k in degrees(), bits in 8u64..400) {
        let y = root(&r, &Natural::from(k), bits);
        prop_assert!(y.accuracy().saturating_add(4) >= bits, "{bits} bits asked, {} found", y.accuracy());
        let (lo, hi) = y.ends().unwrap();
        prop_assert!(lo.point().unwrap().pow(k) <= r && r <= hi.point().unwrap().pow(k));
    }

    #[test]
    fn roots_of_perfect_powers_contain_the_base(x in 1u64..2000, y in 1u64..2000, k in 1u64..60, bits in 8u64..300) {
        let base = Rational::from_unsigneds(x, y);
        prop_assert!(root(&(&base).pow(k), &Natural::from(k), bits).contains(&base));
        prop_assert_eq!(exact_root(&(&base).pow(k), k), Some(base));
    }

    #[test]
    fn doubles_contain_what_they_stand_for(x in positive_rationals(), y in positive_rationals(), k in 1u64..40) {
        let (a, b) = (Double::from_rational(&x), Double::from_rational(&y));
        let check = |d: Double, exact: &Rational| {
            if let Some(set) = d.to_interval() {
                prop_assert!(set.contains(exact));
                let (lo, hi) = d.ends().unwrap();
                prop_assert!(Rational::try_from(lo).unwrap() <= *exact && *exact <= Rational::try_from(hi).unwrap());
                if let Some(sign) = d.sign() {
                    prop_assert_eq!(sign, exact.partial_cmp(&Rational::ZERO).unwrap());
                }
            }
            Ok(())
        };
        check(a, &x)?;
        check(a.plus(b), &(&x + &y))?;
        check(a.subtract(b), &(&x - &y))?;
        check(a.subtract(a), &Rational::ZERO)?;
        check(a.multiply(b), &(&x * &y))?;
        check(a.multiply(b.negated()), &-(&x * &y))?;
        check(a.divide(b), &(&x / &y))?;
        check(a.power(k), &(&x).pow(k))?;
        if let Some((lo, hi)) = a.root(k).ends() {
            prop_assert!(lo > 0.0);
            prop_assert!(Rational::try_from(lo).unwrap().pow(k) <= x && x <= Rational::try_from(hi).unwrap().pow(k));
        }
    }

    #[test]
    fn doubles_are_narrow_in_the_middle_of_the_range(p in 1u64..1 << 50, q in 1u64..1 << 50, k in 1u64..60) {
        let x = Rational::from_unsigneds(p, q);
        let y = Double::from_rational(&x).root(k).power(k);
        let accuracy = y.to_interval().unwrap().accuracy();
        prop_assert!(accuracy >= 90, "{accuracy}");
    }

    #[test]
    fn rationals_round_as_defined(p in integers(), q in positive_rationals(), digits in 1u64..30, places in 0u64..30) {
        let x = Rational::from(p) * q;
        for rounding in Rounding::ALL {
            for asked in [Digits::Significant(digits), Digits::Places(places)] {
                let found = Decimal::of_rational(&x, asked, rounding).unwrap();
                check_rounding(&x, &found, asked, rounding)?;
                let exactly = Interval::from_rational(&x, 2000);
                if let Some(other) = Decimal::of_interval(&exactly, asked, rounding) {
                    prop_assert_eq!(&found, &other);
                }
            }
        }
    }

    #[test]
    fn shared_roundings_hold_for_elements(a in members(), digits in 1u64..20, places in 0u64..20) {
        for rounding in Rounding::ALL {
            for asked in [Digits::Significant(digits), Digits::Places(places)] {
                if let Some(found) = Decimal::of_interval(&a.set, asked, rounding) {
                    prop_assert_eq!(found, Decimal::of_rational(&a.element, asked, rounding).unwrap());
                }
            }
        }
        if let Some((lo, hi)) = outward(&a.set, digits) {
            let read = |text: &str| carom::number::rational::parse(text).unwrap();
            prop_assert!(read(&lo) <= a.element && a.element <= read(&hi));
        }
    }

    /// Decimals from machine words are those from intervals, in every direction, and those of both ends.
    #[test]
    fn decimals_of_doubles_are_those_of_intervals(m in 1u64 << 52..1u64 << 53, exponent in 0i32..76, ulps in 0u64..40, digits in 1u64..17, places in 0u64..22) {
        let lo = m as f64 * 2f64.powi(-53 - exponent);
        let hi = f64::from_bits(lo.to_bits() + ulps);
        let set = Interval::between_f64(lo, hi);
        for end in [lo, hi] {
            prop_assert!(set.contains(&Rational::try_from(end).unwrap()));
        }
        for rounding in Rounding::ALL {
            for digits in [Digits::Significant(digits), Digits::Places(places)] {
                if let Some(found) = Decimal::of_doubles(lo, hi, digits, rounding) {
                    prop_assert_eq!(Decimal::of_interval(&set, digits, rounding), Some(found.clone()));
                    for end in [lo, hi] {
                        prop_assert_eq!(Decimal::of_rational(&Rational::try_from(end).unwrap(), digits, rounding).unwrap(), found.clone());
                    }
                }
            }
        }
        // Where words suffice and no tie is near, they do settle it.
        if exponent < 8 && ulps == 0 && digits < 10 {
            let exact = Rational::try_from(lo).unwrap();
            let long = Decimal::of_rational(&exact, Digits::Significant(digits + 5), Rounding::Nearest).unwrap();
            let tail = &long.digits()[digits as usize..];
            if !["00000", "50000", "99999", "49999"].contains(&tail) {
                prop_assert!(Decimal::of_doubles(lo, hi, Digits::Significant(digits), Rounding::Nearest).is_some());
            }
        }
    }

    #[test]
    fn guessed_logarithms_are_near(r in positive_rationals()) {
        let (p, q) = (r.numerator_ref().to_string(), r.denominator_ref().to_string());
        let size = |t: &str| t[..t.len().min(17)].parse::<f64>().unwrap().ln() + (t.len() - t.len().min(17)) as f64 * 10f64.ln();
        let (log, other) = (guess_ln(&r), size(&p) - size(&q));
        prop_assert!((log - other).abs() < 1e-9 * (1.0 + other.abs()));
    }
}

/// The definition of each direction, and of the number of digits.
fn check_rounding(
    x: &Rational,
    found: &Decimal,
    asked: Digits,
    rounding: Rounding,
) -> std::result::Result<(), TestCaseError> {
    let value = found.value();
    let unit = Rational::from(10).pow(found.exponent());
    let gap = (x - &value).abs();
    let within = match rounding {
        Rounding::Nearest => &gap + &gap <= unit,
        Rounding::Up => value >= *x && gap < unit,
        Rounding::Down => value <= *x && gap < unit,
        Rounding::Zero => (&value).abs() <= (x).abs() && gap < unit,
        Rounding::Away => (&value).abs() >= (x).abs() && gap < unit,
    };
    prop_assert!(within, "{x} as {found} {rounding:?}");
    if rounding == Rounding::Nearest && &gap + &gap == unit {
        prop_assert!(found.digits().bytes().last().unwrap().is_multiple_of(2), "tie {x} as {found}");
    }
    match asked {
        Digits::Places(places) => prop_assert_eq!(found.exponent(), -(places as i64)),
        Digits::Significant(_) if *x == 0 => prop_assert_eq!(found.digits(), "0"),
        Digits::Significant(digits) => {
            prop_assert_eq!(found.digits().len() as u64, digits);
            prop_assert!(!found.digits().starts_with('0'));
            // The last digit stands at the place that the value itself, not the rounded one, asks for.
            let leading = Rational::from(10).pow(found.exponent() + digits as i64 - 1);
            let rounded_up = value.abs() == leading && (x).abs() < leading;
            prop_assert!(x.abs() >= leading || rounded_up);
        }
    }
    Ok(())
}

/// Long decimals, made by halves, are those of exact division, in all directions and beside points where rounding jumps.
#[test]
fn long_decimals_are_those_of_exact_rationals() {
    let seventh = Rational::from_unsigneds(1u32, 7u32);
    let ten = |k: i64| Rational::from(10).pow(k);
    let values = [
        seventh.clone(),
        -&seventh * ten(-5),
        &seventh * ten(40),
        Rational::from_unsigneds(1u32, 3u32) - ten(-2_100),
        Rational::from_unsigneds(1u32, 2u32) + ten(-2_500) * &seventh,
        Rational::ONE - ten(-2_300) * &seventh,
        ten(-30) + ten(-2_032) * &seventh,
    ];
    for x in values {
        for digits in [Digits::Significant(2_000), Digits::Significant(3_001), Digits::Places(2_500)] {
            for rounding in Rounding::ALL {
                let near = Interval::from_rational(&x, 12_000);
                let exact = Decimal::of_rational(&x, digits, rounding).unwrap();
                assert_eq!(Decimal::of_interval(&near, digits, rounding), Some(exact), "{digits:?} {rounding:?}");
            }
        }
    }
}

#[test]
fn ties_are_recognised_exactly() {
    let round = |text: &str, rounding| {
        let x = carom::number::rational::parse(text).unwrap();
        Decimal::of_rational(&x, Digits::Places(1), rounding).unwrap().to_string()
    };
    assert_eq!(round("0.25", Rounding::Nearest), "0.2");
    assert_eq!(round("0.35", Rounding::Nearest), "0.4");
    assert_eq!(round("-0.25", Rounding::Nearest), "-0.2");
    assert_eq!(round("-0.25", Rounding::Down), "-0.3");
    assert_eq!(round("-0.25", Rounding::Up), "-0.2");
    assert_eq!(round("-0.21", Rounding::Away), "-0.3");
    assert_eq!(round("-0.01", Rounding::Nearest), "0.0");
}

#[test]
fn exponents_far_outside_of_doubles_are_ordinary() {
    let third = Interval::from_rational(&Rational::from_signeds(1, 3), 128);
    let huge = third.power(&Natural::from(1_000_000_000_000_000u64), 128);
    assert!(huge.accuracy() >= 60);
    assert_eq!(huge.to_f64_ends(), (0.0, f64::from_bits(1)));
    let decimal = Decimal::of_interval(&huge, Digits::Significant(5), Rounding::Nearest).unwrap();
    // 10^15·log10(3) = 477121254719662.437…, and 10^(1 − 0.437…) = 2.733…
    assert!(decimal.to_string().ends_with("e-477121254719663"), "{decimal}");
    let square = huge.power(&Natural::from(1_000_000u64), 64);
    assert!(square.is_whole(), "an exponent beyond the limit claims nothing");
}

#[test]
fn reals_settle_and_count_their_attempts() {
    let two = Rational::from(2);
    let x = Real::enclosed(move |bits| root(&two, &Natural::from(2u32), bits));
    assert_eq!(x.attempts(), 0);
    let (decimal, _) = Decimal::of_real(&x, Digits::Significant(30), Rounding::Nearest).unwrap();
    assert_eq!(decimal.to_string(), "1.41421356237309504880168872421");
    assert_eq!(x.attempts(), 1);
    let third = Real::rational(Rational::from_signeds(1, 3));
    let (extra, _) = Decimal::with_extra(&third, Digits::Significant(3), 4).unwrap();
    assert_eq!(
        (extra.kept.to_string().as_str(), extra.further.as_str(), extra.bound.as_str()),
        ("0.333", "3333", "1e-7")
    );
    let short = Real::rational(Rational::from_signeds(1, 4));
    let (extra, _) = Decimal::with_extra(&short, Digits::Places(1), 3).unwrap();
    assert_eq!((extra.kept.to_string().as_str(), extra.further.as_str(), extra.bound.as_str()), ("0.2", "500", "0"));
    assert_eq!(Real::rational(Rational::ONE).sign().unwrap().0, std::cmp::Ordering::Greater);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1000, ..ProptestConfig::default() })]

    #[test]
    fn one_conversion_gives_the_same_decimals(r in positive_rationals(), k in 2u64..9, digits in 1u64..25, negative: bool) {
        prop_assume!(exact_root(&r, k).is_none());
        let power = r.clone();
        let x = Real::enclosed(move |bits| {
            let y = root(&power, &Natural::from(k), bits);
            if negative { y.negated() } else { y }
        });
        for rounding in Rounding::ALL {
            for asked in [Digits::Significant(digits), Digits::Places(digits - 1)] {
                let (found, _) = Decimal::with_enclosure(&x, asked, rounding).unwrap();
                prop_assert_eq!(&found.decimal, &Decimal::of_real(&x, asked, rounding).unwrap().0);
                let longer = asked.plus(3);
                prop_assert_eq!(found.lower.value(), Decimal::of_real(&x, longer, Rounding::Down).unwrap().0.value());
                prop_assert_eq!(found.upper.value(), Decimal::of_real(&x, longer, Rounding::Up).unwrap().0.value());
            }
        }
    }
}

#[test]
fn radical_fields_have_the_minimal_degree() {
    let degree = |r: i64, k| Field::of_root(&Rational::from(r), k).unwrap().0.degree();
    assert_eq!(degree(64, 6), 1);
    assert_eq!(degree(64, 4), 2);
    assert_eq!(degree(64, 5), 5);
    assert_eq!(degree(1, 12), 1);
    assert_eq!(degree(531_441, 30), 5);
    assert_eq!(degree(12, 4), 4);
    assert!(Field::of_root(&Rational::from(-2), 3).is_err() && Field::of_root(&Rational::from(2), 0).is_err());
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, ..ProptestConfig::default() })]

    #[test]
    fn radical_elements_are_what_their_enclosures_say(p in 1u64..40, q in 1u64..6, k in 1u64..9, a in -4i64..5, b in 1i64..5, m in 0u64..6) {
        let r = Rational::from_unsigneds(p, q);
        let (field, t) = Field::of_root(&r, k).unwrap();
        prop_assert_eq!(field.power(&t, k), field.rational(r.clone()));
        // (a + b·t)^m by squarings and one factor at a time.
        let sum = field.add(&field.rational(Rational::from(a)), &field.monomial(Rational::from(b), 1));
        let power = field.power(&sum, m);
        let slow = (0..m).fold(field.rational(Rational::ONE), |x, _| field.multiply(&x, &sum));
        prop_assert!(field.subtract(&power, &slow).is_zero());
        let value = root(&r, &Natural::from(k), 300).multiply_rational(&Rational::from(b), 300);
        let value = value.add(&Interval::from_rational(&Rational::from(a), 300), 300).power(&Natural::from(m), 300);
        prop_assert!(value.subtract(&field.real(&power).enclosure(300), 300).contains(&Rational::ZERO));
        match value.sign() {
            Some(sign) => prop_assert_eq!(field.sign(&power).unwrap().0, sign),
            None => prop_assert!(power.is_zero()),
        }
    }

    /// The sign of e − L_n by expansion in the field: an independent route to the chain's answer.
    #[test]
    fn thresholds_agree_with_the_radical_field(base in 2u64..30, power in 1u64..13, n in 1u64..5, e in 0u64..=81) {
        let r = Rational::from(base).pow(power);
        let (field, t) = Field::of_root(&r, n * (n + 1)).unwrap();
        let one = field.rational(Rational::ONE);
        let sum = |k| field.add(&one, &field.power(&t, k));
        let e = Rational::from_unsigneds(e, 81);
        let left = field.multiply(&field.rational(&e + Rational::ONE), &field.power(&sum(n + 1), n));
        let gap = field.subtract(&left, &field.power(&sum(n), n + 1));
        let ratio = carom::chain::Positive::new(r).unwrap();
        let restitution = carom::chain::Restitution::new(e).unwrap();
        let (order, _) = carom::chain::threshold::compare(&restitution, &ratio, &Natural::from(n)).unwrap();
        prop_assert_eq!(field.sign(&gap).unwrap().0, order);
    }
}
