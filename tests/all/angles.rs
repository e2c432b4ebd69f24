//! Angles are written out rightly: what a claim says of sin, cos and tan has the value of what it stands for.

#![allow(clippy::unwrap_used)] // a test stops where it fails

use carom::claim::parse::parse;
use carom::claim::syntax::*;
use proptest::prelude::*;
use std::collections::BTreeMap;

/// A number that an expression has in floating point; sin, cos, tan and π are themselves.
fn value(e: &Expr, at: &BTreeMap<String, f64>) -> f64 {
    let of = |e: &Expr| value(e, at);
    match &e.kind {
        ExprKind::Number(text) => text.parse().unwrap(),
        ExprKind::Name(name) => at[name],
        ExprKind::Negate(a) => -of(a),
        ExprKind::Sum(list) => list.iter().map(|(s, a)| if *s == Sign::Plus { of(a) } else { -of(a) }).sum(),
        ExprKind::Product(list) => {
            list.iter().fold(1.0, |out, (f, a)| if *f == Factor::Times { out * of(a) } else { out / of(a) })
        }
        ExprKind::Power(base, exponent) => of(base).powf(of(exponent)),
        ExprKind::Apply(f, list) => match f.text.as_str() {
            "sqrt" => of(&list[0]).sqrt(),
            other => panic!("{other} is left"),
        },
        _ => panic!("no number"),
    }
}

/// The left side of the goal of a claim about x, y and what else is declared.
fn written(declared: &str, left: &str) -> Expr {
    let claims = parse(&format!("claim c \"t\"\ngiven {declared}\nprove {left} = 0\n"));
    let claims = claims.unwrap_or_else(|faults| panic!("{left}: {} ({:?})", faults[0].message(), faults[0].help()));
    match &claims[0].goal.kind {
        PropKind::Compare(sides, _) => sides[0].clone(),
        _ => panic!("an equation"),
    }
}

/// Cosines and sines of x and y, and of the parts of them that may be named.
fn point(x: f64, y: f64) -> BTreeMap<String, f64> {
    let mut out = BTreeMap::new();
    for (name, angle) in [("x", x), ("y", y)] {
        out.insert(format!("cos_{name}"), angle.cos());
        out.insert(format!("sin_{name}"), angle.sin());
        for over in 2..=24 {
            out.insert(format!("cos_{name}_over_{over}"), (angle / f64::from(over)).cos());
            out.insert(format!("sin_{name}_over_{over}"), (angle / f64::from(over)).sin());
        }
    }
    out
}

fn close(found: f64, expected: f64) -> bool {
    (found - expected).abs() <= 1e-7 * (1.0 + expected.abs())
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_sum_of_angles_has_the_cosine_sine_and_tangent_of_that_sum(
        (a, b) in (-6i32..=6, -6i32..=6), over in 1i32..=4, turns in -130i32..=130, x in -7.0..7.0f64, y in -7.0..7.0f64,
    ) {
        let angle = f64::from(a) * x / f64::from(over) + f64::from(b) * y - std::f64::consts::PI * f64::from(turns) / 120.0;
        let text = format!("{a}*x/{over} + y*({b}) - ({turns})*pi/120");
        let at = point(x, y);
        for (word, expected) in [("cos", angle.cos()), ("sin", angle.sin()), ("tan", angle.tan())] {
            let found = value(&written("x, y real", &format!("{word}({text})")), &at);
            prop_assert!(expected.abs() > 1e4 || close(found, expected), "{word}({text}) at {x}, {y}: {found}, not {expected}");
        }
    }
}
