//! Where an expression has a value: prover, kernel, evaluator and both exports say the same as the list of conditions,
//! of random expressions at many points.
#![allow(clippy::unwrap_used)] // a test stops where it fails

use carom::certificate::{Certificate, Rule, Show, Step};
use carom::claim::definedness::{self, Exponent, Need, TooLong};
use carom::claim::parse::parse;
use carom::claim::syntax::*;
use carom::export::{self, values::Guard};
use carom::judge::outcome_of;
use carom::kernel;
use carom::refute::catalogue::{Catalogue, Limits};
use carom::refute::evaluate::Assignment;
use carom::refute::expand::parts;
use carom::refute::number::Missing;
use carom::refute::outcome::Verdict;
use malachite::Rational;
use std::time::Duration;

/// Random numbers, the same at each run.
struct Random(u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        usize::try_from((self.0 >> 33) % n as u64).unwrap()
    }

    fn of<'t>(&mut self, list: &[&'t str]) -> &'t str {
        list[self.below(list.len())]
    }

    /// An expression over x and y real and n natural.
    fn expression(&mut self, depth: usize) -> String {
        if depth == 0 {
            return self.of(&["x", "y", "n", "0", "1", "2", "(x - y)", "(n - 1)", "(x - 1)"]).to_string();
        }
        let a = self.expression(depth - 1);
        match self.below(9) {
            0 => format!("({a} {} {})", self.of(&["+", "-", "*", "/"]), self.expression(depth - 1)),
            1 => format!("({}({a}))", self.of(&["sqrt", "cbrt", "ln", "exp", "-"])),
            2 => format!(
                "{}(i{depth} = {}..{}, {a}^i{depth})",
                self.of(&["sum", "product"]),
                self.of(&["0", "1", "2", "-1"]),
                self.of(&["n", "3", "(n - 1)"])
            ),
            3 => format!("({a})/({})", self.expression(depth - 1)),
            _ => format!("({a})^{}", self.of(EXPONENTS)),
        }
    }
}

const EXPONENTS: &[&str] = &[
    "2",
    "3",
    "0",
    "(-1)",
    "(-2)",
    "(1/2)",
    "(-1/2)",
    "(4/2)",
    "0.5",
    "2.0",
    "1.5e1",
    "n",
    "(n + 1)",
    "(n - 1)",
    "(-n)",
    "(2*n)",
    "(n*n - 2)",
    "(n/n)",
    "(n - n)",
    "x",
    "(x/x)",
    "(x - x)",
    "sqrt(4)",
    "(1 - 1)",
    "(2 - 3)",
    "(n^2)",
    "(y + 1)",
    "(2*n/2)",
    "(2^3)",
    "(4^(1/2))",
    "(2^n)",
    "exp(0)",
    "(n - 3)",
    "(1/3 + 2/3)",
];

/// Declarations of x, y and n.
const DOMAINS: &[&str] = &["x, y real; n natural", "x, y > 0; n natural >= 1", "x >= 0; y real != 0; n natural"];

fn points(domain: &str) -> Vec<Assignment> {
    let values = [(-2, 1), (-1, 1), (0, 1), (1, 2), (1, 1), (2, 1)].map(|(a, b)| Rational::from_signeds(a, b));
    let mut out = Vec::new();
    for (place, x) in values.iter().enumerate() {
        for y in &values {
            let n = (place + out.len()) % 5;
            let allowed = match DOMAINS.iter().position(|d| *d == domain).unwrap() {
                0 => true,
                1 => *x > 0 && *y > 0 && n >= 1,
                _ => *x >= 0 && *y != 0,
            };
            let mut point = Assignment::default();
            point.values.insert("x".to_string(), x.clone());
            point.values.insert("y".to_string(), y.clone());
            point.values.insert("n".to_string(), Rational::from(n));
            std::rc::Rc::make_mut(&mut point.naturals).insert("n".to_string());
            if allowed {
                out.push(point);
            }
        }
    }
    out
}

/// Whether the evaluator finds a value, where it is certain.
fn evaluated(point: &Assignment, e: &Expr) -> Option<bool> {
    match point.number(e) {
        Ok(_) => Some(true),
        Err(Missing::Undefined(_)) => Some(false),
        Err(Missing::Unknown) => None,
    }
}

fn compare(a: &Expr, relation: Relation, b: &Expr) -> Prop {
    Prop { kind: PropKind::Compare(vec![a.clone(), b.clone()], vec![relation]), span: Span::default() }
}

/// Whether a need holds, where that is certain; what is compared has a value.
fn holds(point: &Assignment, need: &Need) -> Option<bool> {
    let number = |text: &str| Expr { kind: ExprKind::Number(text.to_string()), span: Span::default() };
    let zero = number("0");
    let truth = |prop: Prop| match point.truth(&prop) {
        Ok(truth) => Some(truth),
        Err(Missing::Undefined(_)) => Some(false),
        Err(Missing::Unknown) => None,
    };
    match need {
        Need::NotZero(e) => truth(compare(e, Relation::NotEqual, &zero)),
        Need::Positive(e) => truth(compare(e, Relation::Greater, &zero)),
        Need::NotNegative(e) => truth(compare(e, Relation::GreaterEqual, &zero)),
        Need::NotZeroOrNatural(base, e) => {
            let parts =
                [truth(compare(base, Relation::NotEqual, &zero)), truth(compare(e, Relation::GreaterEqual, &zero))];
            if parts.contains(&Some(true)) { Some(true) } else { parts[0].and(parts[1]) }
        }
        Need::Range(from, to) => {
            let next = vec![(Sign::Plus, to.clone()), (Sign::Plus, number("1"))];
            truth(compare(from, Relation::LessEqual, &Expr { kind: ExprKind::Sum(next), span: from.span }))
        }
        Need::Differentiable(..) => None,
    }
}

/// Whether the conditions of an expression and of all its parts hold, where that is certain.
fn listed(point: &Assignment, e: &Expr) -> Option<bool> {
    let natural = |name: &str| point.naturals.contains(name) || point.indices.contains_key(name);
    let mut sure = true;
    let mut note = |answer: Option<bool>| {
        sure &= answer.is_some();
        answer != Some(false)
    };
    if let ExprKind::SumOver(index, body) | ExprKind::ProductOver(index, body) = &e.kind {
        for end in [&index.from, &index.to] {
            if !note(listed(point, end)) {
                return Some(false);
            }
        }
        let need = definedness::needs(e, &natural).unwrap();
        if !need.iter().all(|need| note(holds(point, need))) {
            return Some(false);
        }
        let end = |e: &Expr| match point.number(e) {
            Ok(carom::refute::number::Number::Exact(q)) => i64::try_from(&q).ok(),
            _ => None,
        };
        for k in end(&index.from)?..=end(&index.to)? {
            let mut inner = point.clone();
            inner.indices.insert(index.name.text.clone(), Rational::from(k));
            if !note(listed(&inner, body)) {
                return Some(false);
            }
        }
        return sure.then_some(true);
    }
    let mut inside = true;
    parts(e, &mut |part| inside &= note(listed(point, part)));
    if !inside || !definedness::needs(e, &natural).unwrap().iter().all(|need| note(holds(point, need))) {
        return Some(false);
    }
    sure.then_some(true)
}

/// Whether the conditions that the exports write hold, where that is certain.
fn exported(point: &Assignment, conditions: &[export::values::Condition]) -> Option<bool> {
    let mut sure = true;
    for condition in conditions {
        let mut points = vec![point.clone()];
        for guard in &condition.guards {
            let Guard::Index(index) = guard else { return None };
            let mut inner = Vec::new();
            for point in points {
                let end = |e: &Expr| match point.number(e) {
                    Ok(carom::refute::number::Number::Exact(q)) => i64::try_from(&q).ok(),
                    _ => None,
                };
                // Where the ends have no value the range's own condition fails, or that of its ends.
                let (Some(from), Some(to)) = (end(&index.from), end(&index.to)) else { continue };
                for k in from..=to {
                    let mut at = point.clone();
                    at.indices.insert(index.name.text.clone(), Rational::from(k));
                    inner.push(at);
                }
            }
            points = inner;
        }
        for point in points {
            match holds(&point, &condition.need) {
                Some(true) => {}
                Some(false) => return Some(false),
                None => sure = false,
            }
        }
    }
    sure.then_some(true)
}

/// The claim that an expression is itself.
fn claim(domain: &str, e: &str) -> Claim {
    parse(&format!("claim c \"t\"\ngiven {domain}\nprove {e} = {e}\n")).unwrap().remove(0)
}

fn accepted(claim: &Claim) -> bool {
    let statement = kernel::statement::Statement::of(claim).unwrap();
    let domains: usize = statement.bindings.iter().map(|b| kernel::domains(b).len()).sum();
    let by = (1..=domains).map(|k| format!("h{k}")).collect();
    let rule = Rule::Combination { times: None, terms: Vec::new() };
    let show = Show { label: "1".to_string(), rule, prop: claim.goal.clone(), by, using: Vec::new() };
    let certificate = Certificate {
        claim: "c".to_string(),
        statement: String::new(),
        refutes: None,
        steps: vec![Step::Show(Box::new(show))],
    };
    matches!(kernel::check(claim, &certificate, &[]), kernel::Verdict::Accepted(_))
}

#[test]
fn all_readers_agree_where_an_expression_has_a_value() {
    let mut random = Random(7);
    let limits = Limits { steps: 2_000, time: Duration::from_millis(500), ..Limits::default() };
    let (mut values, mut none, mut proved, mut refuted, mut checked) = (0, 0, 0, 0, 0);
    for round in 0..600 {
        let domain = DOMAINS[round % DOMAINS.len()];
        let text = random.expression(1 + round % 3);
        let claim = claim(domain, &text);
        let PropKind::Compare(sides, _) = &claim.goal.kind else { panic!("{text}") };
        let e = &sides[0];
        let conditions = export::conditions(&claim).unwrap();
        let outcome = outcome_of(&Catalogue::new(vec![claim.clone()]).unwrap(), "c", &limits);
        let verdict = outcome.map_or(Verdict::Undecided, |o| o.verdict);
        let by_kernel = accepted(&claim);
        let mut somewhere_none = false;
        let mut everywhere_sure = true;
        for point in points(domain) {
            let at = || format!("{text} at {:?}", point.values);
            let list = listed(&point, e);
            let (Some(list), found) = (list, evaluated(&point, e)) else {
                everywhere_sure = false;
                continue;
            };
            assert!(found.is_none_or(|found| found == list), "evaluator: {found:?}, list: {list}: {}", at());
            let written = exported(&point, &conditions);
            assert!(written.is_none_or(|written| written == list), "exports: {written:?}, list: {list}: {}", at());
            assert!(list || verdict != Verdict::Proved, "proved without a value: {}", at());
            assert!(list || !by_kernel, "accepted without a value: {}", at());
            somewhere_none |= !list;
            if list { values += 1 } else { none += 1 }
        }
        // An expression is itself wherever it has a value.
        let fine = verdict != Verdict::Refuted || somewhere_none || !everywhere_sure || domain.contains("natural");
        assert!(fine, "refuted, but it has a value at every point tried: {text}");
        proved += usize::from(verdict == Verdict::Proved);
        refuted += usize::from(verdict == Verdict::Refuted);
        checked += usize::from(by_kernel);
    }
    println!("values {values}, none {none}, proved {proved}, refuted {refuted}, accepted {checked}");
    assert!(values > 1_000 && none > 1_000 && proved > 40 && refuted > 40 && checked > 20);
}

#[test]
fn the_kinds_of_exponents_are_those_of_the_manual() {
    let kind = |text: &str| {
        let claim = claim("x real; n natural", &format!("2^({text})"));
        let PropKind::Compare(sides, _) = &claim.goal.kind else { panic!("{text}") };
        let ExprKind::Power(_, e) = &sides[0].kind else { panic!("{text}") };
        definedness::exponent(e, &|name| name == "n")
    };
    let wrong = |texts: &[&str], expected: Result<Exponent, TooLong>| -> Vec<String> {
        texts.iter().filter(|text| kind(text) != expected).map(|text| format!("{text}: {:?}", kind(text))).collect()
    };
    let whole = [
        "3",
        "-2",
        "4/2",
        "2.0",
        "25e-1*2",
        "2^3",
        "n",
        "2*n + 1",
        "n - 1",
        "-n",
        "n^2",
        "1 - n*(n - 3)",
        // Beyond 128 bits.
        "1e39",
        "-1e39",
        "100e-2",
        "2.00000000000000000000000000000000000000",
        "2*10^38/10^38",
        "1e39/1e38",
        "7^100/7^99",
        "10^300 - 1/2 + 0.5",
        "1^1e39",
        "(-1)^1e39",
        // Too long to be computed, and whole by its form.
        "1e2000",
        "2^1e9",
        "2^1e9 + n",
        "0*2^1e9 - 3",
    ];
    assert!(wrong(&whole, Ok(Exponent::Whole)).is_empty(), "{:?}", wrong(&whole, Ok(Exponent::Whole)));
    let roots =
        ["1/2", "0.3", "2 - 1/3", "4^(-1)", "1e-39", "0.33333333333333333333333333333333333333333", "7^99/7^100"];
    assert!(wrong(&roots, Ok(Exponent::Root)).is_empty(), "{:?}", wrong(&roots, Ok(Exponent::Root)));
    let others = [
        "-1/2",
        "-1e-39",
        "x",
        "1/n",
        "n/n",
        "2*n/2",
        "sqrt(4)",
        "x/x",
        "2^n",
        "4^(1/2)",
        "exp(0)",
        "1/(1 - 1)",
        "1e39/(1e39 - 1e39)",
        "0^(-1e39)",
        "2^1e9*x",
        "x/2^1e9",
    ];
    assert!(wrong(&others, Ok(Exponent::Real)).is_empty(), "{:?}", wrong(&others, Ok(Exponent::Real)));
    let long = ["2*1e2000/1e2000", "3^1000/3^999", "2^1e9/2^1e9", "1/2^1e9", "2^(-1e9)"];
    assert!(wrong(&long, Err(TooLong)).is_empty(), "{:?}", wrong(&long, Err(TooLong)));
}

/// An exponent that is too long leaves a claim undecided: it is no reason for a counterexample, nor for a proof.
#[test]
fn a_power_with_an_exponent_that_is_too_long_has_no_value() {
    for (domain, e) in
        [("x real", "x^(2*1e2000/1e2000)"), ("x < 0", "x^(3^1000/3^999)"), ("x > 0", "1/x^(3^1000/3^999)")]
    {
        let claim = claim(domain, e);
        let outcome = outcome_of(&Catalogue::new(vec![claim.clone()]).unwrap(), "c", &Limits::default()).unwrap();
        assert_eq!(outcome.verdict, Verdict::Undecided, "{e}");
        assert!(export::conditions(&claim).is_err_and(|fault| fault.limit), "{e}");
        let rule = Rule::Combination { times: None, terms: Vec::new() };
        let by = vec!["h1".to_string(); usize::from(domain != "x real")];
        let show = Show { label: "1".to_string(), rule, prop: claim.goal.clone(), by, using: Vec::new() };
        let mut checker = kernel::Checker::new(&claim, &[]).unwrap();
        let refusal = checker.step(&Step::Show(Box::new(show)));
        assert!(matches!(refusal, Err(kernel::Refusal::Limit("digits of an exponent"))), "{e}: {refusal:?}");
    }
}

/// What once was refuted is proved where the numbers are within the limit.
#[test]
fn an_exponent_beyond_128_bits_is_not_computed() {
    for goal in ["(-1)^1e39 = 1", "(-1)^(1e39 + 1) = -1", "(-1)^(-1e39) = 1", "0^1e39 = 0", "x^(2*10^38/10^38) >= 0"] {
        let claims = parse(&format!("claim c \"t\"\ngiven x real\nprove {goal}\n")).unwrap();
        let outcome = outcome_of(&Catalogue::new(claims).unwrap(), "c", &Limits::default()).unwrap();
        assert_eq!(outcome.verdict, Verdict::Proved, "{goal}");
    }
}
