//! One statement, one place: the numeric code against the text of `proofs/`, at exact points.
#![allow(clippy::unwrap_used)] // a test stops where it fails

use carom::chain::optimum::Optimum;
use carom::chain::pass::Pass;
use carom::chain::threshold::threshold;
use carom::chain::{Positive, Restitution, Restitutions, collision, transfer};
use carom::claim::embedded;
use carom::claim::syntax::{Expr, Prop, PropKind};
use carom::number::real::Real;
use carom::refute::evaluate::Assignment;
use carom::refute::expand::Statement;
use carom::refute::number::Number;
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

/// A claim of the catalogue, its definitions put in place.
fn statement(id: &str) -> Statement {
    let claims = embedded::claims(&[id.to_owned()]).unwrap().unwrap();
    let claim = claims.iter().find(|c| c.name.text == id).unwrap();
    Statement::of(claim).unwrap()
}

/// What it says.
fn goal(id: &str) -> Prop {
    statement(id).goal
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
        Number::Between(lo, hi, _) => (lo.clone(), hi.clone()),
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

/// The same on random chains, those at and near a threshold among them.
mod random {
    use super::*;
    use carom::chain::ChainError;
    use carom::chain::best::{Best, best};
    use carom::chain::recollision;
    use carom::chain::threshold::{Helps, helps};
    use carom::number::decimal::{Digits, Rounding};
    use carom::property::strategies::{chain, near_insertion, near_threshold, optimal_chain};
    use carom::scene::answer::{Answers, Value};
    use carom::scene::quantity::Quantity;
    use carom::scene::{Chain, Scene};
    use malachite::base::num::arithmetic::traits::Square;
    use proptest::prelude::*;
    use std::cmp::Ordering;
    use std::rc::Rc;

    /// A point of a claim: variables, and families with their members.
    fn point(values: &[(&str, &Rational)], families: &[(&str, Vec<Rational>)]) -> Assignment {
        let values = values.iter().map(|(name, value)| ((*name).to_owned(), (*value).clone())).collect();
        let families = families.iter().map(|(name, list)| ((*name).to_owned(), list.clone())).collect();
        Assignment { values, families, ..Assignment::default() }
    }

    fn exact(point: &Assignment, expr: &Expr) -> Rational {
        match point.number(expr).unwrap() {
            Number::Exact(value) => value,
            other => panic!("an exact value was expected: {other:?}"),
        }
    }

    fn masses(chain: &Chain) -> Vec<Rational> {
        chain.masses().unwrap().iter().map(|m| m.lo().value().clone()).collect()
    }

    fn coefficients(chain: &Chain) -> Vec<Rational> {
        let all = chain.restitutions().0;
        (0..=chain.count()).map(|i| all.at(i).unwrap().value().clone()).collect()
    }

    /// First and last mass, the one coefficient and the number of inserted bodies.
    fn ends(chain: &Chain) -> Result<(Positive, Positive, Restitution, u64), ChainError> {
        let e = chain.common_restitution("this test")?.lo().clone();
        Ok((chain.first().lo().clone(), chain.last().lo().clone(), e, chain.count()))
    }

    fn answer(order: Ordering) -> Helps {
        match order {
            Ordering::Greater => Helps::Yes,
            Ordering::Less => Helps::No,
            Ordering::Equal => Helps::OnTheThreshold,
        }
    }

    /// Whether a body helps, as two parts of a claim say: `with >= without` and `with = without`.
    fn stated(point: &Assignment, goal: &Prop) -> Helps {
        let truth = |i: usize| point.truth(&part(&part(goal, i), 0)).unwrap();
        match (truth(0), truth(1)) {
            (true, true) => Helps::OnTheThreshold,
            (true, false) => Helps::Yes,
            (false, _) => Helps::No,
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(160))]

        #[test]
        fn velocities_and_losses_balance_as_in_b_budget(chain in chain()) {
            let (mu, e, one) = (masses(&chain), coefficients(&chain), Rational::ONE);
            // Collisions are counted from 0 to n.
            let n = Rational::from(e.len() - 1);
            let Statement { goal, sequences, .. } = statement("b-budget");
            let sequences = Rc::new(sequences.into_iter().map(|u| (u.name.clone(), Rc::new(u))).collect());
            let point = point(&[("v1", &one), ("n", &n)], &[("mu", mu.clone()), ("e", e)]);
            let point = Assignment { sequences, ..point };
            let pass = Pass::from_rest(mu.iter().map(positive).collect(), chain.restitutions().0, Rational::ONE).unwrap();
            let after = pass.velocities_after().unwrap();
            let sum = |of: &dyn Fn(&Rational) -> Rational| {
                mu.iter().zip(&after).map(|(m, v)| m * of(v)).fold(Rational::ZERO, |a, b| a + b)
            };
            prop_assert_eq!(exact(&point, &sides(&part(&goal, 0))[0]), sum(&Clone::clone), "momentum");
            let lost = pass.losses().unwrap().into_iter().fold(Rational::ZERO, |a, b| a + b);
            let energy = sum(&|v| v.square() / Rational::from(2));
            prop_assert_eq!(exact(&point, &sides(&part(&goal, 1))[1]), energy + lost, "energy and losses");
            prop_assert!(point.truth(&goal) == Ok(true));
        }

        #[test]
        fn the_most_that_masses_hand_on_is_that_of_b_global(chain in chain()) {
            let (mu, e) = (masses(&chain), coefficients(&chain));
            let n = Rational::from(e.len() - 1);
            let most = transfer::optimal(&positive(&mu[0]).over(&positive(mu.last().unwrap())), &chain.restitutions().0, chain.count());
            let given = Pass::from_rest(mu.iter().map(positive).collect(), chain.restitutions().0, Rational::ONE).unwrap();
            let point = point(&[("n", &n)], &[("mu", mu), ("e", e)]);
            let text = sides(&goal("b-global"));
            let given = Real::rational(given.transfer().unwrap().into());
            check(&given, &point.number(&text[0]).unwrap(), "eta of the given masses");
            check(&most.unwrap(), &point.number(&text[1]).unwrap(), "the most");
        }

        #[test]
        fn the_nth_body_helps_from_the_threshold_of_eq19_on(chain in near_threshold()) {
            let (first, last, e, n) = ends(&chain).unwrap();
            let n = n.max(1);
            let at = [("m1", first.value().clone()), ("m2", last.value().clone()), ("n", Rational::from(n))];
            let bound = value(&sides(&part(&goal("eq19"), 1))[0], &at);
            let Number::Exact(bound) = bound else { panic!("roots of perfect powers are rational") };
            let found = helps(&e, &first.over(&last), n).unwrap().0;
            prop_assert_eq!(found, answer(e.value().cmp(&bound)), "{} against {}", e.value(), bound);
        }

        #[test]
        fn given_bodies_help_as_b_insert_and_b_insert_each_say(chain in near_insertion()) {
            prop_assume!(chain.count() > 0);
            let (mu, e) = (masses(&chain), coefficients(&chain));
            let want = vec![Quantity::Helps, Quantity::Threshold];
            let scene =
                Scene { want, digits: Digits::Significant(6), rounding: Rounding::Nearest, inputs: chain.clone().into() };
            let answers = Answers::new(&scene);
            let (Value::EachHelps(found), Value::List(thresholds)) =
                (answers.get(Quantity::Helps).unwrap().0, answers.get(Quantity::Threshold).unwrap().0)
            else {
                panic!("given masses have an answer for each inserted body")
            };
            let (one, each) = (goal("b-insert"), goal("b-insert-each"));
            for k in 1..=found.len() {
                let (a, m, b, p, q) = (&mu[k - 1], &mu[k], &mu[k + 1], &e[k - 1], &e[k]);
                // Without the body the collision has the coefficient before it or the one after it.
                let of = |d: &Rational| {
                    let values = [("a", a), ("b", b), ("mu", m), ("p", p), ("q", q), ("d", d)];
                    stated(&point(&values, &[]), &each)
                };
                prop_assert_eq!(found[k - 1], (of(p) == of(q)).then_some(of(p)), "body {}", k);
                let point = point(&[("a", a), ("b", b), ("mu", m), ("e", p)], &[]);
                let tau = exact(&point, &sides(&part(&part(&one, 0), 1))[1]);
                prop_assert_eq!(thresholds[k - 1].exact.as_ref(), Some(&tau), "body {}", k);
                if p == q {
                    prop_assert_eq!(found[k - 1], Some(stated(&point, &one)), "body {}", k);
                }
            }
        }

        #[test]
        fn bodies_meet_again_where_p_final_repaired_says(chain in prop_oneof![optimal_chain().boxed(), near_threshold().boxed()]) {
            let (first, last, e, n) = ends(&chain).unwrap();
            let optimum = Optimum::new(first, last, n, Restitutions::Same(e.clone())).unwrap();
            let step = optimum.step();
            let Some(x) = step.as_rational().filter(|_| n > 0) else { return Ok(()) };
            let (v1, i) = (Rational::ONE, Rational::ZERO);
            let point = point(&[("x", x), ("e", e.value()), ("v1", &v1), ("i", &i)], &[]);
            let apart = part(&part(&goal("p-final-repaired"), 0), 1);
            let found = recollision::of_optimum(&optimum).unwrap().0;
            prop_assert_eq!(point.truth(&apart), Ok(!found), "x = {}, e = {}", x, e.value());
        }

        #[test]
        fn the_best_number_is_the_last_with_a_threshold_of_b_best_below_e(chain in near_threshold()) {
            let (first, last, e, _) = ends(&chain).unwrap();
            let (Best::Finite { count, tie }, _) = best(&first.over(&last), &e).unwrap() else { return Ok(()) };
            let count = u64::try_from(&count).unwrap();
            let helped = part(&part(&goal("b-best"), 1), 1);
            let at = |n: u64| {
                let (n, m1, m2) = (Rational::from(n), first.value(), last.value());
                point(&[("m1", m1), ("m2", m2), ("e", e.value()), ("n", &n)], &[]).truth(&helped)
            };
            // Powers that are too large for exact points leave it open.
            prop_assert!(at(count + 1) != Ok(true), "{} bodies help", count + 1);
            prop_assert!(count == 0 || at(count) != Ok(false), "{} bodies do not help (tie: {})", count, tie);
            prop_assert!(count > 6 || at(count + 1).is_ok(), "nothing is decided");
        }
    }
}
