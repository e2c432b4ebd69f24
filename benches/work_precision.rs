//! Run time against relative error, as CSV on standard output; `benches/work_precision.py` draws it.
//!
//! `cargo bench --bench work_precision > docs/work-precision.csv`
//!
//! The error of a certified method is the relative width that it states; that of an uncertified one is
//! what it misses by, measured against an enclosure of 400 bits (the worst of ten cells).
#![allow(clippy::unwrap_used)] // a bench stops where its own input is wrong

use carom::chain::best::best;
use carom::chain::threshold::threshold;
use carom::chain::{Positive, Restitution, Restitutions, fast, transfer};
use carom::number::interval::Interval;
use carom::number::rational::parse;
use carom::number::real::Real;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Pow;
use std::hint::black_box;
use std::time::{Duration, Instant};

const COLLISIONS: u64 = 8;

/// The median time of one call.
fn time<T>(mut call: impl FnMut() -> T) -> f64 {
    let started = Instant::now();
    black_box(call());
    let once = started.elapsed().max(Duration::from_nanos(20));
    let calls = (Duration::from_millis(5).as_nanos() / once.as_nanos()).clamp(1, 100_000) as u32;
    let mut rounds: Vec<f64> = (0..if calls > 1 { 21 } else { 5 })
        .map(|_| {
            let started = Instant::now();
            for _ in 0..calls {
                black_box(call());
            }
            started.elapsed().as_secs_f64() / f64::from(calls)
        })
        .collect();
    rounds.sort_by(f64::total_cmp);
    rounds[rounds.len() / 2]
}

fn row(quantity: &str, method: &str, bits: &str, log2_error: f64, seconds: f64) {
    println!("{quantity},{method},{bits},{log2_error:.1},{seconds:.3e}");
}

/// log2 of the relative width.
fn width(x: &Interval) -> f64 {
    -(x.accuracy() as f64)
}

fn exact(x: f64) -> Rational {
    Rational::try_from(x).unwrap()
}

/// log2 of the largest relative error of a formula over cells.
fn worst(formula: impl Fn(f64, f64) -> f64, reference: impl Fn(f64, f64) -> Real) -> f64 {
    let mut worst = f64::NEG_INFINITY;
    for (e, r) in cells() {
        let truth = reference(e, r).enclosure(400);
        let gap = Interval::from_f64(formula(e, r)).subtract(&truth, 200).divide(&truth, 60);
        let (lo, hi) = gap.to_f64_ends();
        worst = worst.max(lo.abs().max(hi.abs()).log2());
    }
    worst
}

fn cells() -> Vec<(f64, f64)> {
    (0..10).map(|k| (0.5 + f64::from(k) * 0.049, 10f64.powf(1.0 + f64::from(k) / 7.0))).collect()
}

fn eta_at(e: f64, r: f64) -> Real {
    let e = Restitutions::Same(Restitution::new(exact(e)).unwrap());
    transfer::optimal(&Positive::new(exact(r)).unwrap(), &e, COLLISIONS - 1).unwrap()
}

fn printed(e: f64, r: f64) -> f64 {
    let k = 1.0 / COLLISIONS as f64;
    (1.0 + e).powf(2.0 * COLLISIONS as f64) * r / (r.powf(k) + 1f64.powf(k)).powf(2.0 * COLLISIONS as f64)
}

fn t_form(e: f64, r: f64) -> f64 {
    let t = r.powf(1.0 / COLLISIONS as f64);
    ((1.0 + e) * (1.0 + e) * t / ((1.0 + t) * (1.0 + t))).powi(COLLISIONS as i32)
}

fn threshold_printed(r: f64) -> f64 {
    let (a, b) = (1.0 / COLLISIONS as f64, 1.0 / (COLLISIONS as f64 - 1.0));
    (r.powf(a) + 1.0).powi(COLLISIONS as i32) / (r.powf(b) + 1.0).powi(COLLISIONS as i32 - 1) - 1.0
}

fn main() {
    println!("quantity,method,bits,log2_relative_error,seconds");
    let (e, r) = (0.9, 10.0);
    row("eta", "printed formula in f64", "53", worst(printed, eta_at), time(|| printed(black_box(e), black_box(r))));
    row("eta", "t-form in f64", "53", worst(t_form, eta_at), time(|| t_form(black_box(e), black_box(r))));
    let (lo, hi) = fast::eta(e, r, COLLISIONS);
    let seconds = time(|| fast::eta(black_box(e), black_box(r), COLLISIONS));
    row("eta", "doubles certified", "106", ((hi - lo) / lo).log2(), seconds);
    let ratio = Positive::new(parse("10").unwrap()).unwrap();
    let c = Restitution::new(parse("9/10").unwrap()).unwrap();
    let eta = transfer::optimal(&ratio, &Restitutions::Same(c.clone()), COLLISIONS - 1).unwrap();
    let l = threshold(&ratio, COLLISIONS - 1).unwrap();
    let at = |r: f64| threshold(&Positive::new(exact(r)).unwrap(), COLLISIONS - 1).unwrap();
    let seconds = time(|| threshold_printed(black_box(r)));
    row("L_n", "printed formula in f64", "53", worst(|_, r| threshold_printed(r), |_, r| at(r)), seconds);
    for bits in [64u64, 128, 256, 1_000, 3_000, 10_000, 30_000, 100_000, 300_000, 1_000_000] {
        let label = bits.to_string();
        row("eta", "intervals", &label, width(&eta.enclosure(bits)), time(|| eta.enclosure(black_box(bits))));
        row("L_n", "intervals", &label, width(&l.enclosure(bits)), time(|| l.enclosure(black_box(bits))));
    }
    // Exact: 2^56 is a perfect eighth and 56th power.
    let power = Positive::new(Rational::from(2).pow(56u64)).unwrap();
    let same = Restitutions::Same(c);
    let seconds = time(|| transfer::optimal(black_box(&power), &same, COLLISIONS - 1));
    row("eta", "exact", "exact", f64::NEG_INFINITY, seconds);
    row("L_n", "exact", "exact", f64::NEG_INFINITY, time(|| threshold(black_box(&power), COLLISIONS - 1)));
    for k in [1i32, 2, 4, 8, 16, 32, 64, 128] {
        let near = Restitution::new(Rational::from(1) - Rational::from(10).pow(-i64::from(k))).unwrap();
        let seconds = time(|| best(black_box(&ratio), black_box(&near)));
        row("n*", "certified", &format!("1-1e-{k}"), f64::NEG_INFINITY, seconds);
    }
}
