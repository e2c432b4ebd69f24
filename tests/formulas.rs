//! One statement, one place: the numeric code against the text of `proofs/`, at exact points.
#![allow(clippy::unwrap_used)] // a test stops where it fails

use carom::chain::optimum::Optimum;
use carom::chain::pass::Pass;
use carom::chain::threshold::threshold;
use carom::chain::{Positive, Restitution, Restitutions, collision, transfer};
use carom::claim::embedded;
use carom::claim::syntax::{Expr, Prop, PropKind};
use carom::number::real::Real;
use carom::prove::evaluate::{Assignment, Number};
use carom::prove::expand::Statement;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Pow;
use malachite::base::num::basic::traits::{One, Zero};

fn q(p: i64, d: i64) -> Rational {
    Rational::from_signeds(p, d)
}

fn positive(x: &Rational) -> Positive {
    Positive::new(x.clone()).unwrap()
}

fn restitution(x: &Rational) -> Restitution {
    Restitution::new(x.clone()).unwrap()
}

/// The goal of a claim of the catalogue, its definitions put in place.
fn goal(id: &str) -> Prop {
    let claims = embedded::claims(&[id.to_owned()]).unwrap().unwrap();
    let claim = claims.iter().find(|c| c.name.text == id).unwrap();
    Statement::of(claim).unwrap().goal
}

/// The sides of the `part`-th comparison in a statement.
fn sides(prop: &Prop) -> Vec<Expr> {
    match &prop.kind {
        PropKind::Compare(sides, _) => sides.clone(),
        other => panic!("a comparison was expected: {other:?}"),
    }
}

fn part(prop: &Prop, i: usize) -> Prop {
    match &prop.kind {
        PropKind::And(parts) | PropKind::Equivalent(parts) => parts[i].clone(),
        other => panic!("several statements were expected: {other:?}"),
    }
}

fn value(expr: &Expr, at: &[(&str, Rational)]) -> Number {
    let values = at.iter().map(|(name, value)| ((*name).to_owned(), value.clone())).collect();
    Assignment { values, ..Assignment::default() }.number(expr).unwrap()
}

fn ends(text: &Number) -> (Rational, Rational) {
    match text {
        Number::Exact(x) => (x.clone(), x.clone()),
        Number::Between(lo, hi) => (lo.clone(), hi.clone()),
    }
}

/// The code's number and the text's: equal where both are exact, overlapping enclosures otherwise.
fn check(code: &Real, text: &Number, what: &str) {
    let (lo, hi) = ends(text);
    if let Some(exact) = code.as_rational() {
        assert!(lo <= *exact && *exact <= hi, "{what}: {exact} against {lo} .. {hi}");
        return;
    }
    assert!(lo < hi, "{what}: the text gives a rational");
    let (a, b) = code.enclosure(300).ends().unwrap();
    let (a, b) = (a.point().unwrap(), b.point().unwrap());
    assert!(a <= hi && lo <= b, "{what}: {a} .. {b} against {lo} .. {hi}");
    let narrow = q(1, 2).pow(120i64);
    assert!(&hi - &lo < &hi * narrow, "{what}: the text's value tells little");
}

fn points() -> Vec<(Rational, Rational, Rational, u64)> {
    let masses = [q(10, 1), q(64, 1), q(1, 4), q(7, 3), q(1, 1), q(729, 64)];
    let coefficients = [q(0, 1), q(9, 10), q(44, 81), q(1, 3), q(1, 1)];
    let mut points = Vec::new();
    for (i, m1) in masses.iter().enumerate() {
        for (k, e) in coefficients.iter().enumerate() {
            for n in 1..6u64 {
                points.push((m1.clone(), masses[(i + k + 1) % masses.len()].clone(), e.clone(), n));
            }
        }
    }
    points
}

#[test]
fn eta_is_equation_25() {
    let text = &sides(&goal("eq25"))[1];
    for (m1, m2, e, n) in points() {
        let at = [("m1", m1.clone()), ("m2", m2.clone()), ("e", e.clone()), ("n", Rational::from(n))];
        let code =
            transfer::optimal(&positive(&m1).over(&positive(&m2)), &Restitutions::Same(restitution(&e)), n).unwrap();
        check(&code, &value(text, &at), &format!("eta {m1} {m2} {e} {n}"));
    }
}

#[test]
fn thresholds_are_those_of_equation_19() {
    let text = &sides(&part(&goal("eq19"), 1))[0];
    for (m1, m2, _, n) in points() {
        let at = [("m1", m1.clone()), ("m2", m2.clone()), ("n", Rational::from(n))];
        let code = threshold(&positive(&m1).over(&positive(&m2)), n).unwrap();
        check(&code, &value(text, &at), &format!("L_n {m1} {m2} {n}"));
    }
}

#[test]
fn masses_step_as_in_equation_21() {
    let ratio = &sides(&part(&goal("eq21"), 0))[0];
    let step = &sides(&part(&goal("eq21"), 0))[1];
    for (m1, m2, e, n) in points() {
        let chain = Optimum::new(positive(&m1), positive(&m2), n, Restitutions::Same(restitution(&e))).unwrap();
        for i in 0..=n {
            let at = [("m1", m1.clone()), ("m2", m2.clone()), ("n", Rational::from(n)), ("i", Rational::from(i))];
            check(&chain.step(), &value(step, &at), "x");
            let (behind, front) = (chain.mass(i), chain.mass(i + 1));
            let quotient = match (behind.as_rational(), front.as_rational()) {
                (Some(a), Some(b)) => Real::rational(a / b),
                _ => Real::enclosed(move |bits| behind.enclosure(bits).divide(&front.enclosure(bits), bits)),
            };
            let (lo, hi) = ends(&value(ratio, &at));
            let (a, b) = quotient.enclosure(300).ends().unwrap();
            assert!(a.point().unwrap() <= hi && lo <= b.point().unwrap(), "{m1} {m2} {n} {i}");
        }
    }
}

#[test]
fn velocities_are_those_of_equations_22_to_24() {
    let inner = &sides(&goal("eq22"))[1];
    for (x, v1, e, n) in points() {
        // Masses of ratio x: the chain of the code has m1 = x^(n+1), m2 = 1.
        let m1 = (&x).pow(n + 1);
        let chain =
            Optimum::new(positive(&m1), positive(&Rational::ONE), n, Restitutions::Same(restitution(&e))).unwrap();
        for i in 0..=n {
            let at = [("x", x.clone()), ("e", e.clone()), ("v1", v1.clone()), ("i", Rational::from(i))];
            check(&chain.velocity(i, &v1), &value(inner, &at), "velocity");
        }
    }
    let last = goal("eq24");
    let text = match &last.kind {
        PropKind::Compare(sides, _) => sides.last().unwrap().clone(),
        _ => sides(&part(&last, 0)).last().unwrap().clone(),
    };
    for (x, v1, e, n) in points() {
        let m1 = (&x).pow(n + 1);
        let chain =
            Optimum::new(positive(&m1), positive(&Rational::ONE), n, Restitutions::Same(restitution(&e))).unwrap();
        let at = [("x", x), ("e", e), ("v1", v1.clone()), ("n", Rational::from(n)), ("m1", m1), ("m2", Rational::ONE)];
        check(&chain.velocity(n + 1, &v1), &value(&text, &at), "last velocity");
    }
}

#[test]
fn given_masses_follow_equation_13_and_one_collision_p_loss() {
    let text = &sides(&goal("eq13"))[1];
    let loss = &sides(&part(&goal("p-loss"), 0))[1];
    for (m1, m2, e1, n) in points() {
        let (mu, e2) = (Rational::from(n), q(1, n as i64));
        let at = [("m1", m1.clone()), ("m2", m2.clone()), ("mu", mu.clone()), ("e1", e1.clone()), ("e2", e2.clone())];
        let list = Restitutions::Each(vec![restitution(&e1), restitution(&e2)]);
        let pass = Pass::from_rest(vec![positive(&m1), positive(&mu), positive(&m2)], list, Rational::from(3)).unwrap();
        check(&Real::rational(pass.transfer().unwrap().into()), &value(text, &at), "eta");
        let at =
            [("m1", m1.clone()), ("m2", m2.clone()), ("e", e1.clone()), ("v1", Rational::from(3)), ("v2", -mu.clone())];
        let code = collision::loss(&positive(&m1), &positive(&m2), &restitution(&e1), &Rational::from(3), &-mu);
        check(&Real::rational(code), &value(loss, &at), "loss");
        assert!(Rational::ZERO < m1);
    }
}
