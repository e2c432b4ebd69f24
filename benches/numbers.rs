//! The numbers: eta, L_n and n* at every level. `cargo bench --bench numbers [-- FILTER]`
//!
//! Answers are checked outside of the timed parts.
#![allow(clippy::unwrap_used)] // a bench stops where its own input is wrong

use carom::chain::best::{Best, best};
use carom::chain::pass::Pass;
use carom::chain::threshold::{Helps, helps, threshold};
use carom::chain::uncertain::given::Given;
use carom::chain::uncertain::{Coefficients, Range};
use carom::chain::{Positive, Restitution, Restitutions, fast, transfer};
use carom::number::decimal::{Decimal, Digits, Rounding, bits_of_digits};
use carom::number::interval::Interval;
use carom::number::rational::parse;
use carom::table::grid::Grid;
use carom::table::shared::Factors;
use carom::table::{Plan, Printing, Quantity};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Pow;
use malachite::base::num::basic::traits::One;
use std::hint::black_box;
use std::time::Duration;

/// (25) as printed.
fn printed(e: f64, m1: f64, m2: f64, n: f64) -> f64 {
    let k = 1.0 / (n + 1.0);
    (1.0 + e).powf(2.0 * (n + 1.0)) * m1 * m2 / (m1.powf(k) + m2.powf(k)).powf(2.0 * (n + 1.0))
}

/// (25) in t = r^(1/N), uncertified.
fn t_form(e: f64, r: f64, collisions: u64) -> f64 {
    let t = r.powf(1.0 / collisions as f64);
    ((1.0 + e) * (1.0 + e) * t / ((1.0 + t) * (1.0 + t))).powf(collisions as f64)
}

/// Reproducible cells without a generator of their own: (e, r, N), N up to 13.
fn cells(count: u64) -> (Vec<f64>, Vec<f64>, Vec<u64>) {
    let mix = |k: u64, salt: u64| {
        let mut x = (k + salt).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        x ^= x >> 31;
        x.wrapping_mul(0xbf58_476d_1ce4_e5b9) >> 11
    };
    let unit = |k, salt| mix(k, salt) as f64 / (1u64 << 53) as f64;
    let e = (0..count).map(|k| unit(k, 1)).collect();
    let r = (0..count).map(|k| (unit(k, 99) * 12.0 - 6.0).exp2()).collect();
    let n = (0..count).map(|k| 2 + mix(k, 7777) % 12).collect();
    (e, r, n)
}

fn scattered(c: &mut Criterion) {
    let (e, r, n) = cells(10_000);
    let mut out = vec![(0.0, 0.0); e.len()];
    fast::etas(&e, &r, &n, &mut out);
    for (i, (lo, hi)) in out.iter().enumerate() {
        let formula = t_form(e[i], r[i], n[i]);
        assert!((hi - lo) <= lo * 2f64.powi(-50) && (formula - lo).abs() < lo * 1e-13);
    }
    let mut group = c.benchmark_group("eta/scattered-53bit");
    group.throughput(Throughput::Elements(e.len() as u64));
    group.bench_function("carom, certified", |b| b.iter(|| fast::etas(black_box(&e), black_box(&r), &n, &mut out)));
    let mut plain = vec![0.0; e.len()];
    group.bench_function("t-form, libm pow", |b| {
        b.iter(|| {
            for (i, out) in plain.iter_mut().enumerate() {
                *out = t_form(black_box(e[i]), black_box(r[i]), n[i]);
            }
        })
    });
    group.bench_function("printed (25), libm pow", |b| {
        b.iter(|| {
            for (i, out) in plain.iter_mut().enumerate() {
                *out = printed(black_box(e[i]), black_box(r[i]), 1.0, n[i] as f64 - 1.0);
            }
        })
    });
    group.finish();
}

fn grid(c: &mut Criterion) {
    let e: Vec<f64> = (0..1000).map(|i| f64::from(i) / 999.0).collect();
    let r: Vec<f64> = (0..1000).map(|i| 1.0 + f64::from(i)).collect();
    let (mut lower, mut upper) = (vec![0.0; 1_000_000], vec![0.0; 1_000_000]);
    let mut group = c.benchmark_group("eta/grid-1000000");
    group.throughput(Throughput::Elements(1_000_000)).sample_size(20);
    group.bench_function("carom, certified", |b| {
        b.iter(|| {
            let (a, f) = (fast::Factors::of_restitutions(&e, 8), fast::Factors::of_ratios(&r, 8));
            fast::grid(&a, &f, &mut lower, &mut upper);
        })
    });
    group.bench_function("t-form, libm pow", |b| {
        b.iter(|| {
            for (row, e) in lower.chunks_exact_mut(1000).zip(&e) {
                for (cell, r) in row.iter_mut().zip(&r) {
                    *cell = t_form(*e, black_box(*r), 8);
                }
            }
        })
    });
    group.finish();
}

fn q(text: &str) -> Rational {
    parse(text).unwrap()
}

fn signs(c: &mut Criterion) {
    let mut group = c.benchmark_group("sign of e - L_n");
    for n in [1u64, 2, 3, 5, 12] {
        let r = Positive::new(Rational::from(2).pow(n * (n + 1))).unwrap();
        let l = threshold(&r, n).unwrap().as_rational().cloned().unwrap();
        let equal = Restitution::new(l.clone()).unwrap();
        assert_eq!(helps(&equal, &r, n).unwrap().0, Helps::OnTheThreshold);
        group.bench_function(format!("equality/n={n}"), |b| b.iter(|| helps(black_box(&equal), black_box(&r), n)));
        let near = Restitution::new(l + q("1e-30")).unwrap();
        assert_eq!(helps(&near, &r, n).unwrap().0, Helps::Yes);
        group.bench_function(format!("1e-30 above, rational/n={n}"), |b| {
            b.iter(|| helps(black_box(&near), black_box(&r), n))
        });
        let r = Positive::new(Rational::from(10)).unwrap();
        let cut = Decimal::of_real(&threshold(&r, n).unwrap(), Digits::Places(30), Rounding::Down).unwrap().0.value();
        let cut = Restitution::new(cut).unwrap();
        assert_eq!(helps(&cut, &r, n).unwrap().0, Helps::No);
        group.bench_function(format!("1e-30 below, irrational/n={n}"), |b| {
            b.iter(|| helps(black_box(&cut), black_box(&r), n))
        });
        let far = Restitution::new(q("1/10")).unwrap();
        group.bench_function(format!("far/n={n}"), |b| b.iter(|| helps(black_box(&far), black_box(&r), n)));
    }
    group.finish();
}

fn best_numbers(c: &mut Criterion) {
    let mut group = c.benchmark_group("best-n");
    for (name, r, e) in [("3", "10", "0.9"), ("1e9", "1e10", "0.9999999999999999"), ("1e100", "1e10", "1e-200")] {
        let r = Positive::new(q(r)).unwrap();
        let e = if e.contains("e-") { Rational::from(1) - q(e) } else { q(e) };
        let e = Restitution::new(e).unwrap();
        assert!(matches!(best(&r, &e).unwrap().0, Best::Finite { .. }));
        group.bench_function(name, |b| b.iter(|| best(black_box(&r), black_box(&e))));
    }
    group.finish();
}

fn digits(c: &mut Criterion) {
    let r = Positive::new(Rational::from(10)).unwrap();
    let e = Restitutions::Same(Restitution::new(q("9/10")).unwrap());
    let eta = transfer::optimal(&r, &e, 7).unwrap();
    let l = threshold(&r, 7).unwrap();
    let mut group = c.benchmark_group("digits");
    for count in [100u64, 1_000, 10_000, 100_000, 1_000_000] {
        group.sample_size(10).measurement_time(Duration::from_secs(if count > 10_000 { 5 } else { 2 }));
        let bits = bits_of_digits(count);
        group.bench_function(format!("eta enclosure/{count}"), |b| b.iter(|| eta.enclosure(black_box(bits))));
        group.bench_function(format!("L_7 enclosure/{count}"), |b| b.iter(|| l.enclosure(black_box(bits))));
        group.bench_function(format!("eta decimal/{count}"), |b| {
            b.iter(|| Decimal::of_real(&eta, Digits::Significant(black_box(count)), Rounding::Nearest))
        });
    }
    group.finish();
}

/// Sets the constant NEWTON_DIVISION_BITS of the intervals.
fn division(c: &mut Criterion) {
    let mut group = c.benchmark_group("division");
    group.sample_size(20).measurement_time(Duration::from_secs(1));
    for bits in [2_000u64, 5_000, 10_000, 20_000, 50_000, 100_000] {
        let third = |p: i64| Interval::from_rational(&Rational::from_signeds(p, 3), bits);
        let (x, y) = (third(1).multiply(&third(7), bits), third(5).multiply(&third(11), bits));
        group.bench_function(format!("divide/{bits}"), |b| b.iter(|| x.divide(black_box(&y), bits)));
        group.bench_function(format!("by reciprocal/{bits}"), |b| {
            b.iter(|| x.multiply(&black_box(&y).reciprocal(bits), bits))
        });
    }
    group.finish();
}

/// Rows of a table, as `carom table` makes them.
fn table_rows(c: &mut Criterion) {
    let grid = |text: &str| Grid::parse(text).unwrap();
    let printing = Printing { digits: Digits::Significant(6), rounding: Rounding::Nearest, extra: 0 };
    let axes = (grid("1.5:100:0.5"), Some(grid("0:1:0.01")), Some(grid("7")));
    let plan = Plan::new(Quantity::Eta, axes.0, axes.1, axes.2, printing).unwrap();
    let mut group = c.benchmark_group("table");
    group.throughput(Throughput::Elements(plan.rows())).sample_size(10);
    group.bench_function("rows, 6 digits", |b| {
        b.iter(|| {
            let mut factors = Factors::new(&plan);
            for row in 0..plan.rows() {
                let found = factors.value(row).unwrap();
                black_box(plan.labelled(row, factors.labels(row), found).unwrap());
            }
        })
    });
    group.finish();
}

/// Enclosures over a box of measured masses.
fn measured(c: &mut Criterion) {
    let mut group = c.benchmark_group("measured");
    group.sample_size(10);
    for bodies in [5u64, 50, 200] {
        let mass = |k: u64| {
            let lo = Rational::from(1_000 - k + (k * 7_919) % 13);
            let hi = &lo + Rational::ONE;
            Range::new(Positive::new(lo).unwrap(), Positive::new(hi).unwrap()).unwrap()
        };
        let masses: Vec<_> = (0..bodies).map(mass).collect();
        let e = Coefficients::Same(Range::point(Restitution::new(q("9/10")).unwrap()));
        group.bench_function(format!("velocities/{bodies}"), |b| {
            b.iter(|| Given::new(masses.clone(), e.clone(), Rational::ONE, 80).unwrap().velocities())
        });
    }
    group.finish();
}

fn long_chains(c: &mut Criterion) {
    let mut group = c.benchmark_group("last velocity");
    group.sample_size(10);
    for bodies in [100u64, 1_000, 10_000] {
        let mix = |k: u64| (k.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 33) + 1;
        let masses: Vec<Positive> = (0..bodies)
            .map(|k| Positive::new(Rational::from_unsigneds(mix(k), mix(k + 1 + bodies))).unwrap())
            .collect();
        let e = (1..bodies).map(|k| {
            let (a, b) = (mix(3 * k), mix(5 * k));
            Restitution::new(Rational::from_unsigneds(a.min(b), a.max(b))).unwrap()
        });
        let pass = Pass::from_rest(masses, Restitutions::Each(e.collect()), Rational::from(1)).unwrap();
        group.bench_function(format!("{bodies}"), |b| b.iter(|| pass.last_velocity()));
        if bodies == 1_000 {
            group.bench_function(format!("of all/{bodies}"), |b| b.iter(|| pass.velocities_from_rest()));
        }
    }
    group.finish();
}

criterion_group! {
    name = benches;
    config = Criterion::default().warm_up_time(Duration::from_millis(500)).measurement_time(Duration::from_secs(2)).without_plots();
    targets = scattered, grid, signs, best_numbers, digits, division, long_chains, table_rows, measured
}
criterion_main!(benches);
