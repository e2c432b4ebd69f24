//! The chain's numbers: laws, known values, and the statements of `proofs/` evaluated beside the code.
#![allow(clippy::unwrap_used)] // a test stops where it fails

use carom::chain::best::{Best, best};
use carom::chain::optimum::Optimum;
use carom::chain::pass::Pass;
use carom::chain::threshold::{Helps, compare, helps, threshold};
use carom::chain::{Positive, Restitution, Restitutions, collision, recollision, transfer};
use carom::number::decimal::{Decimal, Digits, Rounding};
use carom::number::interval::Interval;
use carom::number::rational::parse;
use carom::number::real::Real;
use carom::number::root::root;
use malachite::base::num::arithmetic::traits::{Pow, Reciprocal, Square};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::{Natural, Rational};
use proptest::prelude::*;
use std::cmp::Ordering;

fn q(text: &str) -> Rational {
    parse(text).unwrap()
}

fn mass(text: &str) -> Positive {
    Positive::new(q(text)).unwrap()
}

fn e(text: &str) -> Restitution {
    Restitution::new(q(text)).unwrap()
}

fn digits(x: &Real, count: u64) -> String {
    Decimal::of_real(x, Digits::Significant(count), Rounding::Nearest).unwrap().0.to_string()
}

fn positives() -> impl Strategy<Value = Rational> {
    prop_oneof![
        (1u64..30, 1u64..30).prop_map(|(p, q)| Rational::from_unsigneds(p, q)),
        (1u64..1 << 30, 1u64..1 << 30).prop_map(|(p, q)| Rational::from_unsigneds(p, q)),
        (1u64..9, -300i64..300).prop_map(|(p, k)| Rational::from(p) * Rational::from(10).pow(k)),
    ]
}

fn restitutions() -> impl Strategy<Value = Rational> {
    prop_oneof![
        Just(Rational::ZERO),
        Just(Rational::ONE),
        (0u64..=20).prop_map(|p| Rational::from_unsigneds(p, 20)),
        (0u64..=1 << 40).prop_map(|p| Rational::from_unsigneds(p, 1 << 40)),
        (1i64..300).prop_map(|k| Rational::ONE - Rational::from(10).pow(-k)),
    ]
}

/// Whether a real number can be this rational: equal if it is exact, enclosed at 200 bits otherwise.
fn agrees(x: &Real, value: &Rational) -> bool {
    match x.as_rational() {
        Some(exact) => exact == value,
        None => x.enclosure(200).contains(value),
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, ..ProptestConfig::default() })]

    #[test]
    fn eta_is_symmetric_and_bounded(r in positives(), c in restitutions(), n in 0u64..40) {
        let c = Restitutions::Same(Restitution::new(c).unwrap());
        let here = transfer::optimal(&Positive::new(r.clone()).unwrap(), &c, n).unwrap();
        let mirror = transfer::optimal(&Positive::new(r.reciprocal()).unwrap(), &c, n).unwrap();
        prop_assert_eq!(digits(&here, 25), digits(&mirror, 25));
        let top = Real::enclosed(move |bits| here.enclosure(bits));
        prop_assert!(top.enclosure(128).to_f64_ends().0 <= 1.0);
    }

    /// The definition: masses of constant ratio, an ordinary pass along them.
    #[test]
    fn perfect_powers_agree_with_the_pass(p in 1u64..9, d in 1u64..9, c in restitutions(), n in 0u64..6, m1 in positives(), speed in positives()) {
        let x = Rational::from_unsigneds(p, d);
        let masses: Vec<Positive> =
            (0..=n + 1).map(|i| Positive::new(&m1 / (&x).pow(i)).unwrap()).collect();
        let common = Restitution::new(c.clone()).unwrap();
        let same = Restitutions::Same(common.clone());
        let pass = Pass::from_rest(masses.clone(), same.clone(), speed.clone()).unwrap();
        let r = masses[0].over(&masses[n as usize + 1]);
        let eta = transfer::optimal(&r, &same, n).unwrap();
        prop_assert_eq!(eta.as_rational(), Some(&pass.transfer().unwrap().into()));
        let optimum = Optimum::new(masses[0].clone(), masses[n as usize + 1].clone(), n, same).unwrap();
        let velocities = pass.velocities_after().unwrap();
        prop_assert_eq!(&pass.velocities_from_rest().unwrap(), &velocities);
        for i in 0..=n + 1 {
            prop_assert!(optimum.mass(i).as_rational() == Some(masses[i as usize].value()));
            prop_assert!(optimum.velocity(i, &speed).as_rational() == Some(&velocities[i as usize]));
        }
        let losses = pass.losses().unwrap();
        for i in 1..=n + 1 {
            prop_assert!(optimum.loss(i, &speed).as_rational() == Some(&losses[i as usize - 1]));
            let matrix = optimum.matrix(i - 1).unwrap();
            let plain = collision::matrix(&masses[i as usize - 1], &masses[i as usize], &common);
            for (a, b) in matrix.iter().flatten().zip(plain.iter().flatten()) {
                prop_assert_eq!(a.as_rational(), Some(b));
            }
        }
        prop_assert_eq!(pass.last_velocity().unwrap(), velocities.last().unwrap().clone());
        prop_assert_eq!(recollision::of_optimum(&optimum).unwrap().0, recollision::of_velocities(&velocities));
        prop_assert_eq!(recollision::of_velocities(&velocities), n > 0 && x > c && &x * &c < 1);
    }

    #[test]
    fn unequal_coefficients_agree_with_the_pass(p in 1u64..9, d in 1u64..9, c in prop::collection::vec(restitutions(), 1..6)) {
        let x = Rational::from_unsigneds(p, d);
        let n = c.len() as u64 - 1;
        let masses: Vec<Positive> = (0..=n + 1).map(|i| Positive::new(x.clone().reciprocal().pow(i)).unwrap()).collect();
        let list = Restitutions::Each(c.into_iter().map(|e| Restitution::new(e).unwrap()).collect());
        let pass = Pass::from_rest(masses.clone(), list.clone(), Rational::ONE).unwrap();
        let (first, last) = (masses[0].clone(), masses[n as usize + 1].clone());
        let eta = transfer::optimal(&first.over(&last), &list, n).unwrap();
        prop_assert_eq!(eta.as_rational(), Some(&pass.transfer().unwrap().into()));
        let optimum = Optimum::new(first, last, n, list).unwrap();
        let velocities = pass.velocities_after().unwrap();
        prop_assert_eq!(&pass.velocities_from_rest().unwrap(), &velocities);
        for (i, v) in velocities.iter().enumerate() {
            let found = optimum.velocity(i as u64, &Rational::ONE);
            prop_assert_eq!(found.as_rational(), Some(v));
        }
        prop_assert_eq!(recollision::of_optimum(&optimum).unwrap().0, recollision::of_velocities(&velocities));
    }

    /// Irrational roots: numbers that the formulas tie together agree in every digit.
    #[test]
    fn irrational_chains_keep_their_identities(r in positives(), m1 in positives(), c in restitutions(), n in 1u64..9) {
        let common = Restitution::new(c.clone()).unwrap();
        let (first, r) = (Positive::new(m1).unwrap(), Positive::new(r).unwrap());
        let last = Positive::new(first.value() / r.value()).unwrap();
        let optimum = Optimum::new(first.clone(), last.clone(), n, Restitutions::Same(common)).unwrap();
        let velocity: Vec<Real> = (0..=n + 1).map(|i| optimum.velocity(i, &Rational::ONE)).collect();
        let mass: Vec<Real> = (0..=n + 1).map(|i| optimum.mass(i)).collect();
        let bits = 1200;
        // B-budget: momentum, and kinetic energy with all losses.
        let mut momentum = Interval::from_integer(0);
        let mut energy = momentum.clone();
        for (m, v) in mass.iter().zip(&velocity) {
            let (m, v) = (m.enclosure(bits), v.enclosure(bits));
            momentum = momentum.add(&m.multiply(&v, bits), bits);
            energy = energy.add(&m.multiply(&v.square(bits), bits).shifted(-1), bits);
        }
        for i in 1..=n + 1 {
            energy = energy.add(&optimum.loss(i, &Rational::ONE).enclosure(bits), bits);
        }
        prop_assert!(momentum.contains(first.value()));
        prop_assert!(energy.contains(&(first.value() / Rational::from(2))));
        prop_assert!(momentum.accuracy() > 900 && energy.accuracy() > 900);
        // The last body carries eta of the energy.
        let eta = transfer::optimal(&r, optimum.restitutions(), n).unwrap();
        let carried = velocity[n as usize + 1].enclosure(bits).square(bits).divide(&optimum.step().enclosure(bits).power(&Natural::from(n + 1), bits), bits);
        let gap = carried.subtract(&eta.enclosure(bits), bits);
        prop_assert!(gap.contains(&Rational::ZERO));
    }

    #[test]
    fn signs_agree_with_enclosures_and_with_gain(r in positives(), c in restitutions(), n in 1u64..14) {
        let common = Restitution::new(c.clone()).unwrap();
        let r = Positive::new(r).unwrap();
        let (answer, _) = helps(&common, &r, n).unwrap();
        let l = threshold(&r, n).unwrap();
        let below = l.enclosure(3000).subtract(&Interval::from_rational(&c, 3000), 3000);
        match (answer, below.sign()) {
            (Helps::Yes, sign) => prop_assert_eq!(sign, Some(Ordering::Less)),
            (Helps::No, sign) => prop_assert_eq!(sign, Some(Ordering::Greater)),
            (Helps::OnTheThreshold, _) => prop_assert_eq!(l.as_rational(), Some(&c)),
        }
        // eq 19 read as a comparison of two transfers.
        let same = Restitutions::Same(common);
        let with = transfer::optimal(&r, &same, n).unwrap().enclosure(3000);
        let without = transfer::optimal(&r, &same, n - 1).unwrap().enclosure(3000);
        let gain = with.subtract(&without, 3000).sign();
        match answer {
            Helps::Yes => prop_assert_eq!(gain, Some(Ordering::Greater)),
            Helps::No => prop_assert_eq!(gain, Some(Ordering::Less)),
            Helps::OnTheThreshold => prop_assert!(gain.is_none() || gain == Some(Ordering::Equal)),
        }
    }

    #[test]
    fn best_number_is_bracketed(r in positives(), c in restitutions()) {
        let (r, c) = (Positive::new(r).unwrap(), Restitution::new(c).unwrap());
        match best(&r, &c).unwrap().0 {
            Best::Finite { count, tie } => {
                let next = &count + Natural::ONE;
                prop_assert_eq!(compare(&c, &r, &next).unwrap().0, Ordering::Less);
                if count > 0u32 {
                    let here = compare(&c, &r, &count).unwrap().0;
                    prop_assert_eq!(here, if tie { Ordering::Equal } else { Ordering::Greater });
                }
            }
            Best::Infinite => prop_assert!(*c.value() == 1 && *r.value() != 1),
            Best::Any => prop_assert!(*c.value() == 1 && *r.value() == 1),
        }
    }

    /// Equality and its neighbours at every distance, for perfect powers.
    #[test]
    fn thresholds_are_told_from_their_neighbours(p in 2u64..40, d in 1u64..40, n in 1u64..8, k in 1i64..400) {
        prop_assume!(p != d);
        let t = Rational::from_unsigneds(p, d);
        let r = Positive::new(t.pow(n * (n + 1))).unwrap();
        let l = threshold(&r, n).unwrap().as_rational().cloned().unwrap();
        let at = |c: Rational| helps(&Restitution::new(c).unwrap(), &r, n).unwrap().0;
        prop_assert_eq!(at(l.clone()), Helps::OnTheThreshold);
        let step = Rational::from(10).pow(-k);
        if &l + &step <= 1 {
            prop_assert_eq!(at(&l + &step), Helps::Yes);
        }
        if l >= step {
            prop_assert_eq!(at(&l - &step), Helps::No);
        }
        let (found, _) = best(&r, &Restitution::new(l).unwrap()).unwrap();
        prop_assert_eq!(found, Best::Finite { count: Natural::from(n), tie: true });
    }

    /// An irrational threshold cut off after k digits is told from the cut on both sides.
    #[test]
    fn cut_thresholds_are_told_apart(r in 2u64..1000, n in 1u64..8, k in 1u64..300) {
        let r = Positive::new(Rational::from(r)).unwrap();
        let l = threshold(&r, n).unwrap();
        prop_assume!(l.as_rational().is_none());
        let side = |rounding| Decimal::of_real(&l, Digits::Places(k), rounding).unwrap().0.value();
        let at = |c: Rational| helps(&Restitution::new(c).unwrap(), &r, n).unwrap().0;
        prop_assert_eq!(at(side(Rounding::Down)), Helps::No);
        prop_assert_eq!(at(side(Rounding::Up)), Helps::Yes);
    }

    #[test]
    fn one_collision_keeps_its_laws(a in positives(), b in positives(), c in restitutions(), v in positives()) {
        let (m1, m2) = (Positive::new(a.clone()).unwrap(), Positive::new(b.clone()).unwrap());
        let common = Restitution::new(c.clone()).unwrap();
        let (w1, w2) = collision::velocities_after(&m1, &m2, &common, &v, &Rational::ZERO);
        prop_assert_eq!(&a * &w1 + &b * &w2, &a * &v);
        prop_assert_eq!(collision::restitution(&v, &Rational::ZERO, &w1, &w2), Some(c.clone()));
        let [[p, _], [r, _]] = collision::matrix(&m1, &m2, &common);
        prop_assert_eq!((&w1, &w2), (&(p * &v), &(r * &v)));
        let energy = |m: &Positive, v: &Rational| collision::kinetic_energy(m, v);
        let lost = energy(&m1, &v) - energy(&m1, &w1) - energy(&m2, &w2);
        prop_assert_eq!(&lost, &collision::loss(&m1, &m2, &common, &v, &Rational::ZERO));
        let share = energy(&m2, &w2) / energy(&m1, &v);
        prop_assert_eq!(&share, &collision::transfer(&m1, &m2, &common));
        prop_assert_eq!(share, (w2 / v).square() * b / a);
    }
}

/// The series in double-double and the intervals agree on the sign of e − L_n, next to the threshold, and the logarithm
/// that it rests on is enclosed.
#[test]
fn large_numbers_of_bodies_are_settled_in_doubles() {
    for (r, e) in
        [("10", "0.9999999999999999"), ("1/7", "0.99999999999"), ("1.0000001", "0.9999999999999999999999999999")]
    {
        let (r, e) = (mass(r), self::e(e));
        let Best::Finite { count, tie: false } = best(&r, &e).unwrap().0 else { panic!("{r:?}") };
        for (n, wanted) in [(count.clone(), Ordering::Greater), (&count + Natural::ONE, Ordering::Less)] {
            let (order, level) = compare(&e, &r, &n).unwrap();
            assert_eq!((order, level), (wanted, carom::number::real::Level::Double), "{n}");
            // By intervals: 1 − L_n against 1 − e.
            let l = threshold(&r, u64::try_from(&n).unwrap()).unwrap().enclosure(300);
            let gap = Interval::from_rational(e.value(), 300).subtract(&l, 300);
            assert_eq!(gap.sign(), Some(wanted), "{n}");
        }
    }
    for x in ["2", "10", "1e300", "1e-300", "4/3", "2/3", "1.0000000000000000000000001", "0.99999", "7/5"] {
        let (lo, hi) = carom::number::elementary::ln(&q(x), &q(x)).unwrap();
        let found = carom::number::double::Double::ln(&q(x)).to_interval().unwrap();
        assert!(found.accuracy() > 88, "{x}");
        let ends = found.ends().unwrap();
        assert!(ends.0.point().unwrap() <= lo && hi <= ends.1.point().unwrap(), "{x}");
    }
}

/// eta and `L_n` by their formulas, in intervals.
fn plain_eta(r: &str, c: &str, n: u64, bits: u64) -> Interval {
    let t = root(&q(r), &Natural::from(n + 1), bits);
    let sum = t.add(&Interval::from_integer(1), bits);
    let base = t.multiply_rational(&e(c).plus_one().square(), bits).divide(&sum.square(bits), bits);
    base.power(&Natural::from(n + 1), bits)
}

fn plain_threshold(r: &str, n: u64, bits: u64) -> Interval {
    let one = Interval::from_integer(1);
    let power = |k: u64| root(&q(r), &Natural::from(k), bits).add(&one, bits).power(&Natural::from(k), bits);
    power(n + 1).divide(&power(n), bits).subtract(&one, bits)
}

/// Whatever way is taken, in so many machine words, with the last step merged or not, by square roots or by Newton steps:
/// eta and `L_n` at many bits are those by the plain formulas. The bits are those at which the way changes, and others.
#[test]
fn eta_and_thresholds_at_many_bits_agree_with_the_plain_formulas() {
    let words = [3, 4, 6, 8, 10, 12, 14, 16, 20, 24, 28, 32, 40, 46, 54, 62, 70, 80, 94, 110, 126];
    let ends = words.iter().flat_map(|words| [64 * words - 41_u64, 64 * words - 40, 64 * words - 39]);
    let bits: Vec<u64> = ends.chain([333, 1_000, 1_530, 2_222, 5_000, 12_345, 20_000, 32_001, 120_000]).collect();
    for (r, c, n) in [
        ("10", "9/10", 7),
        ("1/3", "1", 1),
        ("1e-40", "1/7", 4),
        ("1e200", "0.999", 30),
        ("1.0000001", "4/5", 100),
        ("4294967295/2", "0.123456789123456789", 2),
        ("7", "0", 15),
        ("18446744073709551615/18446744073709551614", "1/2", 3),
        ("355/113", "3/4", 1000),
    ] {
        let eta = transfer::optimal(&mass(r), &Restitutions::Same(e(c)), n).unwrap();
        let l = threshold(&mass(r), n).unwrap();
        for &bits in &bits {
            let work = bits + 100;
            for (found, plain) in
                [(eta.enclosure(bits), plain_eta(r, c, n, work)), (l.enclosure(bits), plain_threshold(r, n, work + 90))]
            {
                assert!(found.accuracy() + 40 >= bits, "{r} {n} {bits} {}", found.accuracy());
                assert!(found.subtract(&plain, work).contains(&Rational::ZERO), "{r} {n} {bits}");
            }
        }
    }
}

/// Every printed digit is the one that the plain formula gives, in every rounding direction.
#[test]
fn printed_digits_are_those_of_the_plain_formulas() {
    for (r, c, n) in [("10", "9/10", 7), ("2/7", "0.123", 4), ("1000", "1", 23)] {
        let eta = transfer::optimal(&mass(r), &Restitutions::Same(e(c)), n).unwrap();
        let l = threshold(&mass(r), n).unwrap();
        let plain = [
            Real::enclosed(move |bits| plain_eta(r, c, n, bits + 60)),
            Real::enclosed(move |bits| plain_threshold(r, n, bits + 60)),
        ];
        for count in [100, 149, 150, 200, 300, 458, 600, 1_000, 1_066, 1_999, 3_000, 6_000] {
            for rounding in [Rounding::Nearest, Rounding::Down, Rounding::Up] {
                for (found, plain) in [&eta, &l].into_iter().zip(&plain) {
                    let print =
                        |x: &Real| Decimal::of_real(x, Digits::Significant(count), rounding).unwrap().0.to_string();
                    assert_eq!(print(found), print(plain), "{r} {n} {count}");
                }
            }
        }
    }
}

#[test]
fn known_values() {
    // python-flint: arb, 50 digits.
    let eta = transfer::optimal(&mass("10"), &Restitutions::Same(e("9/10")), 7).unwrap();
    assert_eq!(digits(&eta, 45), "0.373137511773738574621222278873225152313358581");
    assert_eq!(threshold(&mass("64"), 2).unwrap().as_rational(), Some(&q("44/81")));
    assert_eq!(digits(&threshold(&mass("64"), 3).unwrap(), 40), "0.7185870119269027481097727051447860932561");
    assert_eq!(best(&mass("64"), &e("44/81")).unwrap().0, Best::Finite { count: Natural::from(2u32), tie: true });
    assert_eq!(best(&mass("10"), &e("9/10")).unwrap().0, Best::Finite { count: Natural::from(3u32), tie: false });
}

#[test]
fn rational_and_irrational_results_are_told_apart() {
    for n in 1..8u64 {
        for base in 2..6u64 {
            for k in 1..60u64 {
                let r = Positive::new(Rational::from(base).pow(k)).unwrap();
                let l = threshold(&r, n).unwrap();
                // Perfect powers of 2, 3 and 5; 4 is one of 2.
                let power = if base == 4 { 2 * k } else { k };
                assert_eq!(l.as_rational().is_some(), power.is_multiple_of(n * (n + 1)), "{base}^{k}, n = {n}");
                if let Some(exact) = l.as_rational() {
                    assert!(agrees(&l, exact));
                }
            }
        }
    }
}

/// What a scene answers takes another way through the numbers than the pass does, for each start.
#[test]
fn velocities_of_a_scene_are_those_of_the_pass() {
    use carom::chain::uncertain::Range;
    use carom::scene::answer::{Answers, Value};
    use carom::scene::quantity::Quantity;
    use carom::scene::{Coefficients, Inputs, Inserted, Scene, Start};
    let point = |text: &str| Range::point(mass(text));
    for speed in ["1", "7/3", "1/1000000007"] {
        for masses in [&["3", "1", "9/7"][..], &["1", "100", "5", "1/3", "2", "2"], &["6", "4", "10", "15"]] {
            for c in ["0", "1/2", "9/10", "1"] {
                let (first, rest) = masses.split_first().expect("bodies");
                let (last, inner) = rest.split_last().expect("bodies");
                let inserted = Inserted::Given(inner.iter().map(|m| point(m)).collect());
                let coefficients = Coefficients::Same(Range::point(e(c)));
                let start = Start::Speed(q(speed));
                let inputs = Inputs::new(point(first), point(last), Some(inserted), Some(coefficients), start);
                let scene = Scene {
                    want: vec![Quantity::Velocities],
                    digits: Digits::Significant(20),
                    rounding: Rounding::Nearest,
                    inputs: inputs.expect("a chain"),
                };
                let answers = Answers::new(&scene);
                let Ok((Value::List(found), _)) = answers.get(Quantity::Velocities) else { panic!("no list") };
                let all = masses.iter().map(|m| mass(m)).collect();
                let pass = Pass::from_rest(all, Restitutions::Same(e(c)), q(speed)).expect("a pass");
                let exact: Vec<_> = found.iter().map(|v| v.exact.clone().expect("rational")).collect();
                assert_eq!(exact, pass.velocities_after().expect("a pass"), "{masses:?}, e = {c}, speed {speed}");
            }
        }
    }
}
