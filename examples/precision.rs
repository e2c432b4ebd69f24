//! Carom's side of benches/results/work-precision.svg: `cargo run --release --example precision -- SECONDS`.
//!
//! For each scene and number of digits an enclosure that is certified to have them, and the time that it takes; then the
//! printed formula in double precision. One JSON object a line: an enclosure as its ends, `[mantissa, exponent]` in
//! hexadecimal with a base of two, a double as its shortest decimal. Where one enclosure takes longer than SECONDS, more digits
//! are not tried. `benches/precision/run` starts this and the other tools, and measures what their answers miss by.
#![allow(clippy::unwrap_used)] // a benchmark stops where its own input is wrong

use carom::chain::threshold::threshold;
use carom::chain::{Positive, Restitution, Restitutions, transfer};
use carom::number::decimal::bits_of_digits;
use carom::number::interval::Interval;
use carom::number::rational::parse;
use carom::number::real::Real;
use malachite::Integer;
use std::hint::black_box;
use std::time::Instant;

const DIGITS: [u64; 7] = [15, 30, 100, 1_000, 10_000, 100_000, 1_000_000];

/// The least time of a call, and its value: other programs on the machine only make it longer.
fn measure<T>(mut call: impl FnMut() -> T) -> (f64, T) {
    let started = Instant::now();
    let value = black_box(call());
    let once = started.elapsed().as_secs_f64();
    let calls = (2e-4 / once.max(2e-8)).clamp(1.0, 10_000.0) as u32;
    let rounds = if once > 1.0 { 1 } else { (0.3 / (once * f64::from(calls))).clamp(3.0, 100.0) as u32 };
    let mut least = once;
    for _ in 0..rounds {
        let started = Instant::now();
        for _ in 0..calls {
            black_box(call());
        }
        least = least.min(started.elapsed().as_secs_f64() / f64::from(calls));
    }
    (least, value)
}

fn hexadecimal((mantissa, exponent): (Integer, i64)) -> String {
    format!("[\"{mantissa:x}\", {exponent}]")
}

fn scene(name: &str, limit: f64, number: &Real, printed: impl Fn() -> f64) {
    for digits in DIGITS {
        let bits = bits_of_digits(digits);
        let (seconds, found): (f64, Interval) = measure(|| number.with_accuracy(black_box(bits)).unwrap().0);
        let (lower, upper) = (hexadecimal(found.lower().unwrap()), hexadecimal(found.upper().unwrap()));
        println!(
            "{{\"scene\": \"{name}\", \"tool\": \"Carom\", \"digits\": {digits}, \"seconds\": {seconds:e}, \"lower\": {lower}, \"upper\": {upper}}}"
        );
        if seconds > limit {
            break;
        }
    }
    let (seconds, value) = measure(printed);
    println!(
        "{{\"scene\": \"{name}\", \"tool\": \"printed formula, double\", \"digits\": 15, \"seconds\": {seconds:e}, \"value\": \"{value:e}\"}}"
    );
}

/// (25) as it is printed, for masses r and 1.
fn eta_printed(r: f64, e: f64, n: f64) -> f64 {
    let count = n + 1.0;
    (1.0 + e).powf(2.0 * count) * r / (r.powf(1.0 / count) + 1f64.powf(1.0 / count)).powf(2.0 * count)
}

/// (19) as it is printed, for masses r and 1.
fn threshold_printed(r: f64, n: f64) -> f64 {
    let sum = |k: f64| (r.powf(1.0 / k) + 1f64.powf(1.0 / k)).powf(k);
    sum(n + 1.0) / sum(n) - 1.0
}

fn main() {
    let limit: f64 = std::env::args().nth(1).map_or(2.0, |text| text.parse().unwrap());
    let positive = |text: &str| Positive::new(parse(text).unwrap()).unwrap();
    let same = |text: &str| Restitutions::Same(Restitution::new(parse(text).unwrap()).unwrap());
    let eta = |r: &str, e: &str, n: u64| transfer::optimal(&positive(r), &same(e), n).unwrap();
    let l = |r: &str, n: u64| threshold(&positive(r), n).unwrap();
    let many = 1_000_000u64;
    scene("eta", limit, &eta("10", "9/10", 7), || eta_printed(black_box(10.0), black_box(0.9), 7.0));
    scene("L_7", limit, &l("10", 7), || threshold_printed(black_box(10.0), 7.0));
    scene("L_2, ratio 1e34", limit, &l("1e34", 2), || threshold_printed(black_box(1e34), 2.0));
    scene("eta, n = 1e6", limit, &eta("10", "0.9999999", many), || {
        eta_printed(black_box(10.0), black_box(0.999_999_9), 1e6)
    });
    scene("L_n, n = 1e6", limit, &l("10", many), || threshold_printed(black_box(10.0), 1e6));
    let text = std::env::args().nth(2).expect("usage: precision SECONDS E, with E near L_7 for r = 10");
    let (e, near) = (parse(&text).unwrap(), l("10", 7));
    let double: f64 = text.parse().unwrap();
    let margin =
        Real::enclosed(move |bits| Interval::from_rational(&e, bits + 4).subtract(&near.enclosure(bits + 4), bits + 4));
    scene("e - L_7, e near", limit, &margin, || black_box(double) - threshold_printed(black_box(10.0), 7.0));
}
