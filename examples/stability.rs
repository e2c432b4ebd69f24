//! Where the formulas as printed fail in doubles, beside the certified values.
//!
//! `cargo run --release --example stability > docs/stability.md` writes the page.

use carom::chain::threshold::threshold;
use carom::chain::{Positive, Restitution, Restitutions, transfer};
use carom::number::decimal::{Decimal, Digits, Rounding};
use carom::number::interval::Interval;
use carom::number::rational::parse;
use carom::number::real::Real;
use malachite::Rational;
use malachite::base::num::basic::traits::One;
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::rounding_modes::RoundingMode;

/// A scene: masses, restitution as `1 − 10^-k` or a numeral, inserted bodies.
struct Scene {
    m1: &'static str,
    m2: &'static str,
    e: &'static str,
    n: u64,
}

const fn scene(m1: &'static str, m2: &'static str, e: &'static str, n: u64) -> Scene {
    Scene { m1, m2, e, n }
}

const TRANSFERS: [Scene; 9] = [
    scene("10", "1", "0.9", 7),
    scene("10", "1", "0.9", 600),
    scene("10", "1", "1", 1023),
    scene("10", "1", "1-1e-9", 1_000_000_000),
    scene("1e200", "1e-200", "1", 3),
    scene("1e-200", "1e-200", "1", 1),
    scene("1e-320", "1e-322", "1/2", 2),
    scene("1e400", "1", "1", 9),
    scene("1.000000000000001", "1", "1-1e-300", 1000),
];

const THRESHOLDS: [Scene; 9] = [
    scene("64", "1", "", 2),
    scene("10", "1", "", 7),
    scene("1e20", "1", "", 1),
    scene("1e34", "1", "", 1),
    scene("1e120", "1", "", 3),
    scene("10", "1", "", 2000),
    scene("10", "1", "", 1_000_000),
    scene("1e300", "1e-300", "", 5),
    scene("1e-9999", "1", "", 12),
];

const SHORTFALLS: [Scene; 5] = [
    scene("10", "1", "", 1000),
    scene("1.0001", "1", "", 3),
    scene("1.000000000000001", "1", "", 2),
    scene("2", "1", "", 500_000),
    scene("10", "1", "", 1_000_000_000),
];

fn numeral(text: &str) -> Rational {
    match text.strip_prefix("1-") {
        Some(rest) => Rational::ONE - parse(rest).expect("a numeral of this file"),
        None => parse(text).expect("a numeral of this file"),
    }
}

fn double(text: &str) -> f64 {
    f64::rounding_from(&numeral(text), RoundingMode::Nearest).0
}

fn ratio(s: &Scene) -> Positive {
    Positive::new(numeral(s.m1) / numeral(s.m2)).expect("positive masses")
}

/// (25) as printed.
fn printed_transfer(s: &Scene) -> f64 {
    let (m1, m2, e, n) = (double(s.m1), double(s.m2), double(s.e), s.n as f64);
    let root = 1.0 / (n + 1.0);
    let power = 2.0 * (n + 1.0);
    (1.0 + e).powf(power) * m1 * m2 / (m1.powf(root) + m2.powf(root)).powf(power)
}

/// (19) as printed.
fn printed_threshold(s: &Scene) -> f64 {
    let (m1, m2, n) = (double(s.m1), double(s.m2), s.n as f64);
    let sum = |k: f64| (m1.powf(1.0 / k) + m2.powf(1.0 / k)).powf(k);
    sum(n + 1.0) / sum(n) - 1.0
}

/// How many leading digits of a double are right.
fn right_digits(found: f64, truth: &Real) -> String {
    if !found.is_finite() {
        return "none".to_owned();
    }
    let (truth, _) = truth.with_accuracy(200).expect("within the limits");
    let gap = Interval::from_f64(found).subtract(&truth, 200).divide(&truth, 60);
    let (lo, hi) = gap.to_f64_ends();
    let error = lo.abs().max(hi.abs());
    if error >= 0.5 { "none".to_owned() } else { format!("{}", (-error.log10()).floor().clamp(0.0, 16.0)) }
}

fn row(s: &Scene, found: f64, truth: &Real) -> String {
    let certified = Decimal::of_real(truth, Digits::Significant(20), Rounding::Nearest).expect("within the limits").0;
    let e = if s.e.is_empty() { "–" } else { s.e };
    let shown = if found.is_finite() { format!("{found:.16e}") } else { found.to_string() };
    format!("| {} | {} | {e} | {} | {shown} | {} | {certified} |\n", s.m1, s.m2, s.n, right_digits(found, truth))
}

/// The page.
pub(crate) fn page() -> String {
    let head =
        "| m1 | m2 | e | n | as printed, in f64 | digits right | Carom, 20 digits |\n|---|---|---|---|---|---|---|\n";
    let mut out = String::from(
        "# Stability\n\nThe formulas of the paper, typed into double precision as they are printed, beside certified values. η (eta) is the\nshare of the energy that reaches the last body; L_n is the least restitution with which the n-th inserted body raises\nit. `cargo run --release --example stability` prints this page. `tests/all/stability.rs` compares the last column, and\ntests thousands of scenes of these kinds.\n\n",
    );
    out.push_str("## eta, equation (25)\n\n");
    out.push_str(head);
    for s in &TRANSFERS {
        let e = Restitutions::Same(Restitution::new(numeral(s.e)).expect("a coefficient"));
        let truth = transfer::optimal(&ratio(s), &e, s.n).expect("within the limits");
        out.push_str(&row(s, printed_transfer(s), &truth));
    }
    out.push_str("\n## L_n, equation (19)\n\n");
    out.push_str(head);
    for s in &THRESHOLDS {
        let truth = threshold(&ratio(s), s.n).expect("within the limits");
        out.push_str(&row(s, printed_threshold(s), &truth));
    }
    out.push_str("\n## 1 − L_n, which decides for e near 1\n\n");
    out.push_str(head);
    for s in &SHORTFALLS {
        let l = threshold(&ratio(s), s.n).expect("within the limits");
        let truth = match l.as_rational() {
            Some(exact) => Real::rational(Rational::ONE - exact),
            None => Real::enclosed(move |bits| {
                // As many bits more as 1 and L_n have in common.
                let bits = bits + 2 * 64 + 128;
                Interval::from_integer(1).subtract(&l.enclosure(bits), bits)
            }),
        };
        out.push_str(&row(s, 1.0 - printed_threshold(s), &truth));
    }
    out.push_str(
        "\n## What goes wrong\n\n- With N = n + 1, `(m1^(1/N) + m2^(1/N))^N` is at least `2^N` times a mass. For N > 1023 it overflows, and so does the\n  result. Carom works with `t/(1+t)²`, where `t = (m1/m2)^(1/N)`, and with halves `((1+t)/2)^N`. No power of these leaves\n  the range of the masses' ratio. Exponents are 64-bit integers.\n- Products of masses over- and underflow, although eta depends only on their ratio.\n- `L_n` and `1 − L_n` are differences of nearly equal numbers if the masses are far apart, or n is large.\n  Carom raises the precision until the enclosure is narrow enough for the digits.\n- A double cannot represent `1 − 10^-300`, and cannot decide whether e equals `L_n`. With m1 = 64, m2 = 1, n = 2 and\n  e = 44/81 they are equal, and `carom eval` prints that.\n",
    );
    out.push_str("- More than 10^18 inserted bodies are refused (exit code 3).\n");
    out
}

fn main() {
    print!("{}", page());
}
