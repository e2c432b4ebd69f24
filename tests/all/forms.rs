//! The kernel's reading of expressions against the evaluator, which shares only the syntax tree with it:
//! an expression and what it is read as have the same values. Limits at a point have one value.

use carom::claim::parse::{parse, parse_prop};
use carom::claim::print;
use carom::claim::syntax::*;
use carom::judge::outcome_of;
use carom::refute::catalogue::{Catalogue, Limits};
use carom::refute::evaluate::Assignment;
use carom::refute::expand::Statement;
use carom::refute::outcome::Verdict;
use carom::refute::reading::Reading;
use malachite::Rational;
use proptest::prelude::*;
use proptest::test_runner::{FileFailurePersistence, TestRunner};
use std::cmp::Ordering;

fn cases(cases: u32) -> ProptestConfig {
    let kept = FileFailurePersistence::Direct("tests/all/forms.proptest-regressions");
    ProptestConfig { cases, failure_persistence: Some(Box::new(kept)), ..ProptestConfig::default() }
}

/// Expressions in x, y > 0 and a natural n >= 1, most of them with values.
fn expressions() -> impl Strategy<Value = String> {
    let leaf =
        prop::sample::select(vec!["1", "2", "3/4", "x", "y", "n", "x + y", "x*y", "n + 1"]).prop_map(str::to_owned);
    leaf.prop_recursive(4, 24, 3, |inner| {
        let exponent = prop::sample::select(vec![
            "2",
            "3",
            "(-1)",
            "(1/2)",
            "(1/3)",
            "(2/3)",
            "n",
            "(n + 1)",
            "(1/n)",
            "(1/(n + 1))",
            "(n/(n + 1))",
        ]);
        prop_oneof![
            (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("({a}) + ({b})")),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("({a}) - ({b})")),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("({a})*({b})")),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("({a})/({b})")),
            (inner.clone(), exponent).prop_map(|(a, k)| format!("({a})^{k}")),
            inner.clone().prop_map(|a| format!("exp(ln({a}))")),
            inner.clone().prop_map(|a| format!("product(i = 1..n + 1, {a})")),
            inner.prop_map(|a| format!("sum(i = 1..3, i*({a}))")),
        ]
    })
}

fn expression(text: &str) -> Expr {
    match parse_prop(&format!("0 = {text}")) {
        Ok(Prop { kind: PropKind::Compare(mut sides, _), .. }) => sides.remove(1),
        other => panic!("{text}: {other:?}"),
    }
}

/// A reading that knows x, y > 0 and n natural >= 1.
fn reading() -> Reading {
    let source = "claim domains \"t\"\ngiven x, y > 0;  n natural >= 1\nprove x = x\n";
    let claims = parse(source).expect("it parses");
    let statement = Statement::of(&claims[0]).expect("within limits");
    Reading::of(&statement, &statement.bindings).expect("it is read")
}

/// Points (x, y, n).
const POINTS: [(i64, i64, i64, i64, i64); 4] = [(2, 1, 3, 1, 1), (1, 3, 5, 7, 2), (64, 1, 1, 64, 3), (9, 4, 9, 4, 5)];

fn point((a, b, c, d, n): (i64, i64, i64, i64, i64)) -> Assignment {
    let mut at = Assignment::default();
    at.values.insert("x".to_string(), Rational::from_signeds(a, b));
    at.values.insert("y".to_string(), Rational::from_signeds(c, d));
    at.values.insert("n".to_string(), Rational::from(n));
    at
}

#[test]
fn a_form_has_the_values_of_its_expression() {
    let compared = std::cell::Cell::new(0);
    let law = |text: String| {
        let e = expression(&text);
        let Some(f) = reading().plain(&e) else { return Ok(()) };
        let shown = print::expr(&f);
        for at in POINTS.map(point) {
            if let (Ok(a), Ok(b)) = (at.number(&e), at.number(&f)) {
                compared.set(compared.get() + 1);
                prop_assert!(
                    !matches!(a.order(&b), Some(Ordering::Less | Ordering::Greater)),
                    "{text} is {} but {shown} is {} at {:?}",
                    a.text(),
                    b.text(),
                    at.values
                );
            }
        }
        Ok(())
    };
    TestRunner::new(cases(400)).run(&expressions(), law).unwrap_or_else(|e| panic!("{e}"));
    assert!(compared.get() >= 400, "only {} values were compared", compared.get());
}

proptest! {
    #![proptest_config(cases(400))]

    #[test]
    fn derivatives_lie_between_difference_quotients_of_convex_powers(
        a in 1i64..6, b in 1i64..4, c in 1i64..6, k in 2i64..5,
    ) {
        // f is a sum of convex functions of x > 0: its derivative lies between the quotients to
        // either side.
        let f = |x: &str| format!("({x})^({}) + {c}*({x})^(-{b}) + exp({x}/{k})", Rational::from_signeds(a + k, a));
        let e = expression(&format!("derivative({}, x)", f("x")));
        let derivative = print::expr(&reading().plain(&e).expect("a derivative"));
        let at = point((c, b, 1, 1, 1));
        let h = "1/1000";
        let claims = [
            format!("({} - ({}))/({h}) < {derivative}", f("x"), f(&format!("x - {h}"))),
            format!("({} - ({}))/({h}) > {derivative}", f(&format!("x + {h}")), f("x")),
        ];
        for claim in claims {
            let prop = parse_prop(&claim).expect("it parses");
            prop_assert_eq!(at.truth(&prop), Ok(true), "{}", claim);
        }
    }
}

/// Limits with one right value, which is not refuted; any other is.
#[test]
fn limits_have_one_value() {
    let right = [
        ("(1 + 1/n)^n", "exp(1)"),
        ("(1 + x/n)^n", "exp(x)"),
        ("n*(x^(1/n) - 1)", "ln(x)"),
        ("((x^(1/n) + y^(1/n))/2)^n", "sqrt(x*y)"),
        ("((2*x^(1/n) + y^(1/n))/3)^n", "(x^2*y)^(1/3)"),
        ("n^3/2^n", "0"),
        ("(n^2 + x)/(2*n^2 - 1)", "1/2"),
        ("n*(ln(n + x) - ln(n))", "x"),
        ("(x/(1 + x))^n", "0"),
    ];
    for (of, value) in right {
        for (value, is_right) in [(value.to_string(), true), (format!("{value} + 1/1000"), false)] {
            let source = format!(
                "claim l \"t\"\ngiven x, y > 0;  n natural >= 1\nprove limit of {of} as n -> infinity is {value}\n"
            );
            let catalogue = Catalogue::new(parse(&source).expect("it parses")).expect("one claim");
            let outcome = outcome_of(&catalogue, "l", &Limits::default()).expect("no fault");
            let refuted = outcome.verdict == Verdict::Refuted;
            assert_eq!(refuted, !is_right, "limit of {of} is {value}: {:?}", outcome.reason);
        }
    }
}

/// The bounds on e rise at each n by a polynomial certificate alone: a power of x − y times positive
/// coefficients.
#[test]
fn each_bound_is_above_the_one_before() {
    for n in [1, 2, 3, 4, 5, 24] {
        for (relation, verdict) in [(">=", Verdict::Proved), (">", Verdict::Refuted)] {
            if n > 5 && relation == ">=" {
                continue;
            }
            let source = format!(
                "claim rise \"t\"\ngiven m1, m2 > 0\nlet S(k) = m1^(1/k) + m2^(1/k)\nlet L(k) = S(k + 1)^(k + 1)/S(k)^k - 1\n\
                 prove L({n} + 1) {relation} L({n})\n"
            );
            let catalogue = Catalogue::new(parse(&source).expect("it parses")).expect("one claim");
            let outcome = outcome_of(&catalogue, "rise", &Limits::default()).expect("no fault");
            assert_eq!(outcome.verdict, verdict, "n = {n}: {:?}", outcome.reason);
        }
    }
}
