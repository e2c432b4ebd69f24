//! Numerical stress: sizes beyond doubles, thresholds missed by a hair or hit, many bodies.
//!
//! `docs/stability.md` shows the same cells beside the formulas as printed, in doubles.
#![allow(clippy::unwrap_used)] // a test stops where it fails

use carom::chain::best::{Best, best};
use carom::chain::fast;
use carom::chain::threshold::{Helps, helps, threshold};
use carom::chain::{Positive, Restitution, Restitutions, transfer};
use carom::number::decimal::{Decimal, Digits, Rounding};
use carom::number::interval::Interval;
use carom::number::rational::parse;
use carom::number::real::{Level, Real};
use malachite::base::num::arithmetic::traits::{Pow, UnsignedAbs};
use malachite::base::num::basic::traits::One;
use malachite::{Integer, Natural, Rational};
use std::str::FromStr;

#[path = "../../examples/stability.rs"]
#[allow(dead_code)]
mod page;

fn q(text: &str) -> Rational {
    parse(text).unwrap()
}

fn ratio(text: &str) -> Positive {
    Positive::new(q(text)).unwrap()
}

fn e(x: Rational) -> Restitution {
    Restitution::new(x).unwrap()
}

/// `1 − 10^-k`
fn near_one(k: i64) -> Rational {
    Rational::ONE - Rational::from(10).pow(-k)
}

const RATIOS: [&str; 12] = [
    "1e-300",
    "1e300",
    "1e-9999",
    "1e9999",
    "1",
    "10",
    "1e-3",
    "1.000000000000001",
    "0.999999999999999",
    "531441",
    "64",
    "4",
];

fn coefficients() -> Vec<Rational> {
    vec![q("0"), q("1"), q("1/2"), near_one(15), near_one(300), q("1e-300")]
}

/// A decimal in units of a place far below it: its value itself may have 10^17 digits.
fn in_units(x: &Decimal, exponent: i64) -> Integer {
    let digits = Integer::from_str(x.digits()).unwrap() * Integer::from(10).pow((x.exponent() - exponent) as u64);
    if x.is_negative() { -digits } else { digits }
}

/// Each digit that is printed at 20 digits is there at 60, where precision and route differ.
fn check_digits(x: &Real, what: &str) {
    let enclosed = |digits| Decimal::with_enclosure(x, Digits::Significant(digits), Rounding::Nearest).unwrap().0;
    let (short, long) = (enclosed(20), enclosed(60));
    let unit =
        [&long.decimal, &long.lower, &long.upper, &short.decimal].map(Decimal::exponent).into_iter().min().unwrap();
    let at = |d: &Decimal| in_units(d, unit);
    let gap = at(&short.decimal) - at(&long.decimal);
    let place = Integer::from(10).pow((short.decimal.exponent() - unit) as u64);
    assert!(
        gap.unsigned_abs() * Natural::from(2u32) <= place.unsigned_abs(),
        "{what}: {} {}",
        short.decimal,
        long.decimal
    );
    assert!(at(&short.lower) <= at(&long.lower) && at(&long.upper) <= at(&short.upper), "{what}");
    assert!(at(&long.lower) <= at(&long.upper), "{what}");
}

#[test]
fn eta_and_thresholds_over_all_sizes() {
    for r in RATIOS {
        for n in [1, 2, 5, 12, 100, 1023, 100_000, 1_000_000_000] {
            for c in coefficients() {
                let eta = transfer::optimal(&ratio(r), &Restitutions::Same(e(c.clone())), n).unwrap();
                check_digits(&eta, &format!("eta r={r} e={c} n={n}"));
                assert!(eta.enclosure(64).sign() != Some(std::cmp::Ordering::Less));
            }
            check_digits(&threshold(&ratio(r), n).unwrap(), &format!("L r={r} n={n}"));
        }
    }
}

#[test]
fn equality_is_recognised_wherever_it_holds() {
    let at = |r: &str, n: u64, c: Rational| helps(&e(c), &ratio(r), n).unwrap().0;
    assert_eq!(at("4", 1, q("4/5")), Helps::OnTheThreshold);
    assert_eq!(at("64", 2, q("44/81")), Helps::OnTheThreshold);
    for n in [1, 2, 3, 1000, 1_000_000_000] {
        assert_eq!(at("1", n, q("1")), Helps::OnTheThreshold);
        assert_eq!(at("1", n, near_one(300)), Helps::No);
    }
    // 3^12 = 531441: rational at n = 2 and n = 3, not at n = 5.
    for (n, rational) in [(2, true), (3, true), (5, false)] {
        let l = threshold(&ratio("531441"), n).unwrap();
        assert_eq!(l.as_rational().is_some(), rational);
        if let Some(exact) = l.as_rational() {
            assert_eq!(at("531441", n, exact.clone()), Helps::OnTheThreshold);
            assert_eq!(helps(&e(exact.clone()), &ratio("531441"), n).unwrap().1, Level::Exact);
        }
    }
}

#[test]
fn hairs_beside_the_threshold_are_seen() {
    for (r, n) in
        [("4", 1), ("64", 2), ("531441", 3), ("10", 7), ("1e300", 4), ("1e-9999", 2), ("1.000000000000001", 3)]
    {
        let l = threshold(&ratio(r), n).unwrap();
        for k in [30u64, 300, 3000] {
            let hair = Rational::from(10).pow(-(k as i64));
            let centre = match l.as_rational() {
                Some(exact) => exact.clone(),
                None => Decimal::of_real(&l, Digits::Places(k + 5), Rounding::Nearest).unwrap().0.value(),
            };
            if &centre + &hair <= 1 {
                assert_eq!(helps(&e(&centre + &hair), &ratio(r), n).unwrap().0, Helps::Yes, "{r} {n} {k}");
            }
            if centre >= hair {
                assert_eq!(helps(&e(&centre - &hair), &ratio(r), n).unwrap().0, Helps::No, "{r} {n} {k}");
            }
        }
    }
}

#[test]
fn close_calls_only_are_dear() {
    assert_eq!(helps(&e(q("9/10")), &ratio("10"), 7).unwrap().1, Level::Double);
    let l = threshold(&ratio("10"), 7).unwrap();
    let near = Decimal::of_real(&l, Digits::Places(100), Rounding::Down).unwrap().0.value();
    assert!(matches!(helps(&e(near), &ratio("10"), 7).unwrap().1, Level::Interval(bits) if bits <= 1024));
}

#[test]
fn best_numbers_of_any_size() {
    let count = |r: &str, c: Rational| match best(&ratio(r), &e(c)).unwrap().0 {
        Best::Finite { count, .. } => count,
        other => panic!("{other:?}"),
    };
    assert_eq!(count("1e10", q("0.9999999999999999")), Natural::from(1_151_292_545u64));
    assert_eq!(count("1", near_one(15)), Natural::from(0u32));
    assert_eq!(count("10", q("0")), Natural::from(0u32));
    assert!(count("10", near_one(300)) > Natural::from(10u32).pow(149));
    assert!(matches!(best(&ratio("10"), &e(q("1"))).unwrap().0, Best::Infinite));
    // Beyond the stated size there is an error, not a guess.
    assert!(best(&ratio("10"), &e(near_one(3000))).is_err());
}

#[test]
fn doubles_enclose_what_intervals_say() {
    let hairs = [1.0, 1.0 - f64::EPSILON / 2.0, 0.0, 5e-324, 0.1, 0.5, 0.9, 0.999_999_999_999_999];
    let sizes = [
        1.0,
        10.0,
        0.1,
        1.0 + f64::EPSILON,
        1.0 - f64::EPSILON / 2.0,
        1e-300,
        1e300,
        5e-324,
        f64::MAX,
        1e100,
        3.0,
        64.0,
        1e-120,
    ];
    for c in hairs {
        for r in sizes {
            for n in [1u64, 2, 3, 8, 13, 64, 257, 1000, 65_536, 65_537, 1_000_000_007] {
                let (lo, hi) = fast::eta(c, r, n);
                let exact = |x: f64| Rational::try_from(x).unwrap();
                let same = Restitutions::Same(e(exact(c)));
                let eta = transfer::optimal(&Positive::new(exact(r)).unwrap(), &same, n - 1).unwrap();
                let (least, most) = eta.enclosure(200).to_f64_ends();
                assert!(lo <= least && most <= hi, "e={c} r={r} N={n}: {lo} {hi} against {least} {most}");
                assert!(hi - lo <= lo * 2f64.powi(-50) || lo < 1e-280, "e={c} r={r} N={n}: {lo} {hi}");
            }
        }
    }
    for (c, r, n) in [
        (f64::NAN, 1.0, 1),
        (0.5, f64::NAN, 1),
        (1.5, 2.0, 3),
        (0.5, -1.0, 2),
        (0.5, 0.0, 2),
        (0.5, 1.0, 0),
        (0.5, f64::INFINITY, 2),
    ] {
        assert!(fast::eta(c, r, n).0.is_nan());
    }
}

#[test]
fn what_is_found_exactly_is_rounded_as_such() {
    let directions = [Rounding::Nearest, Rounding::Up, Rounding::Away, Rounding::Zero, Rounding::Down];
    // 1, though the powers that it is made of are far too long to be written down.
    let one = transfer::optimal(&ratio("1"), &Restitutions::Same(e(q("1"))), 1_000_000_000).unwrap();
    // Points whose digits end: 0.125 lies halfway between two decimals of two digits.
    let point = |m: i32, k: i64| Real::enclosed(move |_| Interval::from_dyadic(m.into(), -k));
    for (x, digits, expected) in [
        (one, 5, ["1.0000"; 5]),
        (point(1, 3), 3, ["0.125"; 5]),
        (point(1, 3), 2, ["0.12", "0.13", "0.13", "0.12", "0.12"]),
        (point(-3, 3), 2, ["-0.38", "-0.37", "-0.38", "-0.37", "-0.38"]),
    ] {
        for (rounding, expected) in directions.into_iter().zip(expected) {
            let (found, _) = Decimal::with_enclosure(&x, Digits::Significant(digits), rounding).unwrap();
            assert_eq!(found.decimal.to_string(), expected, "{rounding:?}");
            assert_eq!(found.lower, found.upper);
        }
    }
}

#[test]
fn many_cells_get_what_each_gets_alone() {
    let hairs = [1.0, 0.0, 5e-324, 0.3, 0.9, f64::NAN, 1.5, -0.1];
    let sizes = [1.0, 10.0, 0.1, 1.0 + f64::EPSILON, 1e300, 1e100, 64.0, 1e-120, 0.0, -1.0, f64::NAN, f64::INFINITY];
    let counts = [0_u64, 1, 2, 3, 8, 13, 64, 128, 129, 1000, u64::MAX];
    let mut cells = Vec::new();
    for n in counts {
        for r in sizes {
            for c in hairs {
                cells.push((c, r, n));
            }
        }
    }
    // Steps that have no factor in common with the number of cells mix them; several rounds fill more than a block.
    let count = cells.len();
    let mixed: Vec<(f64, f64, u64)> = (0..4 * count).map(|i| cells[i * 7919 % count]).collect();
    let e: Vec<f64> = mixed.iter().map(|c| c.0).collect();
    let r: Vec<f64> = mixed.iter().map(|c| c.1).collect();
    let n: Vec<u64> = mixed.iter().map(|c| c.2).collect();
    let mut out = vec![(0.0, 0.0); mixed.len()];
    fast::etas(&e, &r, &n, &mut out);
    let mut numbers = 0;
    for ((c, r, n), (lo, hi)) in mixed.into_iter().zip(out) {
        let alone = fast::eta(c, r, n);
        assert_eq!((lo.to_bits(), hi.to_bits()), (alone.0.to_bits(), alone.1.to_bits()), "e={c} r={r} N={n}");
        numbers += usize::from(lo <= hi);
    }
    assert!(numbers > count, "{numbers}");
    let mut few = [(7.0, 7.0); 3];
    fast::etas(&e, &r[..2], &n, &mut few);
    assert_eq!(few[2], (7.0, 7.0));
}

#[test]
fn grids_enclose_every_cell() {
    let coefficients = [0.0, 0.3, 0.9, 1.0];
    let ratios = [1e-300, 0.01, 1.0, 10.0, 1e200, 1e308];
    for n in [1, 2, 8, 500, 3000] {
        let (a, b) = (fast::Factors::of_restitutions(&coefficients, n), fast::Factors::of_ratios(&ratios, n));
        let mut lower = vec![0.0; coefficients.len() * ratios.len()];
        let mut upper = lower.clone();
        fast::grid(&a, &b, &mut lower, &mut upper);
        for (i, c) in coefficients.iter().enumerate() {
            for (j, r) in ratios.iter().enumerate() {
                let exact = |x: f64| Rational::try_from(x).unwrap();
                let eta =
                    transfer::optimal(&Positive::new(exact(*r)).unwrap(), &Restitutions::Same(e(exact(*c))), n - 1)
                        .unwrap();
                let (least, most) = eta.enclosure(200).to_f64_ends();
                let (lo, hi) = (lower[i * ratios.len() + j], upper[i * ratios.len() + j]);
                assert!(lo <= least && most <= hi, "e={c} r={r} N={n}: {lo} {hi} against {least} {most}");
                assert!(hi - lo <= lo * 2f64.powi(-48) || lo < 1e-280);
            }
        }
    }
}

#[test]
fn limits_are_stated_and_errors() {
    let huge = carom::chain::MAX_INSERTED + 1;
    let same = Restitutions::Same(e(q("1/2")));
    assert!(transfer::optimal(&ratio("2"), &same, huge).is_err());
    assert!(threshold(&ratio("2"), huge).is_err());
    assert!(threshold(&ratio("2"), 0).is_err());
    let eta = transfer::optimal(&ratio("2"), &same, 3).unwrap();
    assert!(Decimal::of_real(&eta, Digits::Significant(100_000_000), Rounding::Nearest).is_err());
    assert!(Decimal::of_real(&eta, Digits::Significant(0), Rounding::Nearest).is_err());
    let largest = transfer::optimal(&ratio("2"), &same, carom::chain::MAX_INSERTED).unwrap();
    check_digits(&largest, "eta of the longest chain");
    assert!(Interval::whole().sign().is_none());
}

/// The page's last column, and its rows, are those of the code; the doubles depend on the libm.
#[test]
fn the_stability_page_is_up_to_date() {
    let columns = |page: &str| -> Vec<(String, String)> {
        let cells = |line: &str| line.split(" | ").map(str::to_owned).collect::<Vec<_>>();
        page.lines()
            .filter(|line| line.starts_with("| "))
            .map(|line| (cells(line)[..4].join(" "), cells(line).pop().unwrap()))
            .collect()
    };
    let committed = include_str!("../../docs/stability.md");
    assert_eq!(columns(committed), columns(&page::page()));
}
