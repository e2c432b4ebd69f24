//! What the last body of the paper's chains really gets: `cargo run --example final_velocities -- FOLDER`.
//!
//! Equations (22)–(25) describe one pass of collisions. Where e < x < 1/e neighbours meet again after it (P-final),
//! and from four bodies on the outcome depends on the gaps. Prints the tables of `docs/replay.md` and writes
//! `eta-against-gaps.svg` into the folder. Every number comes from an exact replay.

use carom::chain::replay::{Body, Line, Options, Outcome, Status, replay};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Pow;
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::rounding_modes::RoundingMode;
use std::fmt::Write;

fn q(n: i64, d: i64) -> Rational {
    Rational::from_signeds(n, d)
}

/// Masses x^N … x, 1 (equation 21), the first moving at 1, gaps as given, replayed.
fn chain(x: &Rational, e: &Rational, gaps: &[Rational]) -> Outcome {
    let links = gaps.len() as u64;
    let mut at = q(0, 1);
    let mut bodies = Vec::new();
    for i in 0..=links {
        let velocity = q(i64::from(i == 0), 1);
        bodies.push(Body { mass: x.pow(links - i), position: at.clone(), velocity, length: q(0, 1) });
        at += gaps.get(i as usize).cloned().unwrap_or(q(0, 1));
    }
    let line = Line::new(&bodies, &vec![e.clone(); gaps.len()], None, None).expect("a valid line");
    replay(&line, &Options { max_events: 100_000, ..Options::default() }).expect("the ledger balances")
}

/// Kinetic energy of the last body over that of the first at the start.
fn eta(outcome: &Outcome, x: &Rational, links: u64) -> Rational {
    let v = outcome.velocities.last().and_then(|v| v.rational()).expect("exact");
    v * v / x.pow(links)
}

/// Equation (25).
fn formula(x: &Rational, e: &Rational, links: u64) -> Rational {
    ((q(1, 1) + e) / (q(1, 1) + x)).pow(2 * links) * x.pow(links)
}

fn decimal(x: &Rational, places: usize) -> String {
    format!("{:.places$}", f64::rounding_from(x, RoundingMode::Nearest).0)
}

fn pairs(outcome: &Outcome) -> String {
    let all: Vec<String> = outcome.events.iter().map(|c| format!("{}{}", c.pair, c.pair + 1)).collect();
    if all.len() > 14 { format!("{} … ({} in all)", all[..12].join(" "), all.len()) } else { all.join(" ") }
}

fn witnesses() {
    println!("Equal gaps. Pairs in the order of their collisions; eta by (25), and what the last body really gets.\n");
    println!("| inserted | x | e | final after one pass? | pairs | eta by (25) | eta replayed | ratio |");
    println!("|---|---|---|---|---|---|---|---|");
    for (inserted, x, e) in [
        (1u64, q(2, 1), q(1, 2)),
        (1, q(3, 2), q(1, 2)),
        (1, q(1, 1), q(1, 2)),
        (1, q(1, 1), q(1, 10)),
        (2, q(3, 2), q(1, 2)),
        (2, q(1, 1), q(1, 2)),
        (3, q(1, 1), q(1, 2)),
        (3, q(3, 2), q(3, 5)),
        (3, q(1, 1), q(9, 10)),
    ] {
        let links = inserted + 1;
        let outcome = chain(&x, &e, &vec![q(1, 1); links as usize]);
        let once = x <= e || &x * &e >= q(1, 1);
        let (by, got) = (formula(&x, &e, links), eta(&outcome, &x, links));
        let end = match outcome.status {
            Status::Complete => "",
            Status::Collapse(_) => ", then a collapse",
            _ => ", then undecided",
        };
        println!(
            "| {inserted} | {x} | {e} | {} | {}{end} | {} | {} | {} |",
            if once { "yes" } else { "no" },
            pairs(&outcome),
            decimal(&by, 6),
            decimal(&got, 6),
            decimal(&(&got / &by), 4)
        );
        assert_eq!(once, got == by && outcome.count == links, "P-final");
    }
}

/// eta for every gap ratio g = (gap 3)/(gap 2) on a fine exact grid, as runs of one value.
fn against_gaps(x: &Rational, e: &Rational, second: i64, steps: i64) -> Vec<(Rational, Option<Rational>, String)> {
    let mut found = Vec::new();
    for k in 0..=steps {
        // From 1/16 to 16, evenly on a logarithmic scale but rational.
        let exponent = 8.0 * k as f64 / steps as f64 - 4.0;
        let g = q((exponent.exp2() * 65536.0).round() as i64, 65536);
        let outcome = chain(x, e, &[q(1, 1), q(second, 4), q(second, 4) * &g]);
        let value = match outcome.status {
            Status::Complete | Status::Collapse(_) => Some(eta(&outcome, x, 3)),
            _ => None,
        };
        found.push((g, value, pairs(&outcome)));
    }
    found
}

fn table_of_gaps(x: &Rational, e: &Rational, steps: &[(Rational, Option<Rational>, String)]) {
    println!(
        "\nFour bodies, x = {x}, e = {e}: eta by (25) is {}. Last gap over middle gap:\n",
        decimal(&formula(x, e, 3), 9)
    );
    println!("| last gap / middle gap | eta replayed | pairs |");
    println!("|---|---|---|");
    let mut i = 0;
    while i < steps.len() {
        let mut j = i;
        while j + 1 < steps.len() && steps[j + 1].2 == steps[i].2 {
            j += 1;
        }
        let value = steps[i].1.as_ref().map_or("ambiguous".to_string(), |v| decimal(v, 9));
        println!("| {} to {} | {value} | {} |", decimal(&steps[i].0, 4), decimal(&steps[j].0, 4), steps[i].2);
        i = j + 1;
    }
}

type Curve = (String, f64, Vec<(f64, f64)>);

/// eta over eta of (25), against the ratio of gaps on a logarithmic scale.
fn picture(curves: &[Curve]) -> String {
    let (left, top, width, height) = (80.0, 60.0, 640.0, 400.0);
    let all = curves.iter().flat_map(|c| c.2.iter().map(|p| p.1));
    let (lo, hi) = all.fold((1.0f64, 1.0f64), |(lo, hi), y| (lo.min(y), hi.max(y)));
    // Room below for the names of curves that end on (25).
    let (lo, hi) = (lo - 0.2 * (hi - lo), hi + 0.05 * (hi - lo));
    let across = |g: f64| left + (g.log2() + 4.0) / 8.0 * width;
    let down = |y: f64| top + height - (y - lo) / (hi - lo) * height;
    let mut out = String::from(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 900 540\" width=\"900\" height=\"540\" font-family=\"Helvetica, Arial, sans-serif\" font-size=\"14\">\n<rect width=\"900\" height=\"540\" fill=\"#fff\"/>\n<text x=\"80\" y=\"30\" font-size=\"17\">What the last of four bodies really gets, over what (25) says</text>\n",
    );
    for k in -4i32..=4 {
        let x = across(f64::from(k).exp2());
        let text = if k < 0 { format!("1/{}", 1 << -k) } else { format!("{}", 1 << k) };
        let _ = writeln!(
            out,
            "<path d=\"M{x:.1} {top}V{}\" stroke=\"#eee\"/><text x=\"{x:.1}\" y=\"{}\" text-anchor=\"middle\">{text}</text>",
            top + height,
            top + height + 22.0
        );
    }
    let step = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5].into_iter().find(|s| (hi - lo) / s < 9.0).unwrap_or(1.0);
    let mut y = (lo / step).ceil() * step;
    while y <= hi {
        let _ = writeln!(
            out,
            "<path d=\"M{left} {0:.1}H{1}\" stroke=\"#eee\"/><text x=\"{2}\" y=\"{3:.1}\" text-anchor=\"end\">{y:.2}</text>",
            down(y),
            left + width,
            left - 8.0,
            down(y) + 5.0
        );
        y += step;
    }
    let _ = writeln!(
        out,
        "<path d=\"M{left} {0:.1}H{1}\" stroke=\"#111\" stroke-dasharray=\"6 4\"/>",
        down(1.0),
        left + width
    );
    let mut labels = vec![(down(1.0), "#111", "(25)".to_string())];
    let colours = ["#0072b2", "#d55e00", "#009e73", "#cc79a7"];
    for (i, (name, _, points)) in curves.iter().enumerate() {
        let mut path = String::new();
        for (k, (g, y)) in points.iter().enumerate() {
            // Steps: between two grid points the value jumps somewhere.
            let jump = k > 0 && points[k - 1].1 != *y;
            let _ = write!(path, "{}{:.2} {:.2}", if k == 0 || jump { "M" } else { "L" }, across(*g), down(*y));
        }
        let last = points.last().map_or(1.0, |p| p.1);
        let _ = writeln!(out, "<path d=\"{path}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2.6\"/>", colours[i % 4]);
        labels.push((down(last), colours[i % 4], name.clone()));
    }
    // From the top down, none over another.
    labels.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut free = f64::NEG_INFINITY;
    for (y, colour, name) in labels {
        let at = y.max(free);
        free = at + 18.0;
        let _ =
            writeln!(out, "<text x=\"{}\" y=\"{:.1}\" fill=\"{colour}\">{name}</text>", left + width + 8.0, at + 5.0);
    }
    let _ =
        writeln!(out, "<path d=\"M{left} {top}V{0}H{1}\" fill=\"none\" stroke=\"#333\"/>", top + height, left + width);
    let _ = writeln!(
        out,
        "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">last gap / middle gap</text>",
        left + width / 2.0,
        top + height + 50.0
    );
    out.push_str("</svg>\n");
    out
}

fn main() {
    let folder = std::env::args().nth(1).unwrap_or_else(|| ".".to_string());
    witnesses();
    let mut curves: Vec<Curve> = Vec::new();
    for (x, e) in [(q(1, 1), q(1, 5)), (q(1, 1), q(1, 4)), (q(1, 1), q(3, 10)), (q(3, 2), q(1, 4))] {
        let steps = against_gaps(&x, &e, 4, 400);
        table_of_gaps(&x, &e, &steps);
        let by = formula(&x, &e, 3);
        let near = |v: &Rational| f64::rounding_from(v, RoundingMode::Nearest).0;
        let points = steps.iter().filter_map(|(g, v, _)| Some((near(g), near(&(v.as_ref()? / &by))))).collect();
        curves.push((format!("x = {x}, e = {e}"), near(&by), points));
    }
    let path = std::path::Path::new(&folder).join("eta-against-gaps.svg");
    match std::fs::write(&path, picture(&curves)) {
        Ok(()) => println!("\nwritten: {}", path.display()),
        Err(e) => eprintln!("cannot write {}: {e}", path.display()),
    }
}
