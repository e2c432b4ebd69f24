//! Laws of the exact algebra, on random inputs.
use carom::algebra::factor::{exact_root, factor, square_free};
use carom::algebra::gcd::gcd;
use carom::algebra::roots::{End, Interval, RealRoot, SignOn};
use carom::algebra::{Monomial, Polynomial, Univariate};
use carom::number::rational::{self, NumeralError, parse};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Pow;
use proptest::prelude::*;
use proptest::test_runner::FileFailurePersistence;

/// So many cases, and failing ones kept beside this file.
fn cases(cases: u32) -> ProptestConfig {
    let kept = FileFailurePersistence::Direct("tests/all/algebra.proptest-regressions");
    ProptestConfig { cases, failure_persistence: Some(Box::new(kept)), ..ProptestConfig::default() }
}

/// Random polynomials in three variables with small coefficients.
fn polynomial() -> impl Strategy<Value = Polynomial> {
    let term = (0u32..3, 0u32..3, 0u32..3, -6i64..=6, 1i64..=3);
    prop::collection::vec(term, 0..5).prop_map(|terms| {
        Polynomial::from_terms(terms.into_iter().map(|(a, b, c, n, d)| {
            let monomial = Monomial::new(&[(0, a), (1, b), (2, c)]).expect("small degree");
            (monomial, Rational::from_signeds(n, d))
        }))
    })
}

/// Random small rationals.
fn rational() -> impl Strategy<Value = Rational> {
    (-9i64..=9, 1i64..=4).prop_map(|(n, d)| Rational::from_signeds(n, d))
}

proptest! {
    #![proptest_config(cases(64))]

    #[test]
    fn ring_laws(a in polynomial(), b in polynomial(), c in polynomial()) {
        prop_assert_eq!(a.add(&b), b.add(&a));
        prop_assert_eq!(a.mul(&b), b.mul(&a));
        prop_assert_eq!(a.mul(&b.add(&c)), a.mul(&b).add(&a.mul(&c)));
        prop_assert_eq!(a.mul(&b).mul(&c), a.mul(&b.mul(&c)));
        prop_assert!(a.sub(&a).is_zero());
        prop_assert_eq!(a.pow(3).expect("small power"), a.mul(&a).mul(&a));
    }

    #[test]
    fn exact_division_undoes_multiplication(a in polynomial(), b in polynomial()) {
        if b.is_zero() {
            prop_assert_eq!(a.exact_divide(&b), None);
        } else {
            prop_assert_eq!(a.mul(&b).exact_divide(&b), Some(a.clone()));
            if let Some(quotient) = a.exact_divide(&b) {
                prop_assert_eq!(quotient.mul(&b), a);
            }
        }
    }
}

/// The gcd, which small inputs never exhaust.
fn common(a: &Polynomial, b: &Polynomial) -> Polynomial {
    gcd(a, b).expect("small inputs")
}

proptest! {
    #![proptest_config(cases(64))]

    #[test]
    fn gcd_divides_and_leaves_coprime_cofactors(a in polynomial(), b in polynomial()) {
        let g = common(&a, &b);
        if g.is_zero() {
            prop_assert!(a.is_zero() && b.is_zero());
        } else {
            let left = a.exact_divide(&g).expect("the gcd divides");
            let right = b.exact_divide(&g).expect("the gcd divides");
            prop_assert!(common(&left, &right).is_one());
            prop_assert_eq!(g.primitive_part().1, g);
        }
    }

    #[test]
    fn gcd_takes_a_common_factor_out(p in polynomial(), a in polynomial(), b in polynomial()) {
        let expected = p.mul(&common(&a, &b)).primitive_part().1;
        prop_assert_eq!(common(&p.mul(&a), &p.mul(&b)), expected);
    }
}

proptest! {
    #![proptest_config(cases(64))]

    #[test]
    fn factors_multiply_back_and_are_coprime(
        a in polynomial(), b in polynomial(), c in polynomial(), i in 0u32..3, j in 0u32..3,
    ) {
        let p = a.mul(&b.pow(i).expect("small")).mul(&c.pow(j).expect("small"));
        for factored in [square_free(&p).expect("small"), factor(&p).expect("small")] {
            prop_assert_eq!(&factored.product().expect("small"), &p);
            for (index, (f, exponent)) in factored.factors.iter().enumerate() {
                prop_assert!(*exponent > 0 && !f.is_constant());
                prop_assert_eq!(&f.primitive_part().1, f);
                for var in f.variables() {
                    prop_assert!(common(f, &f.derivative(var)).is_one());
                }
                for (other, _) in &factored.factors[index + 1..] {
                    prop_assert!(common(f, other).is_one());
                }
            }
        }
    }

    #[test]
    fn exact_roots_undo_powers(p in polynomial(), k in 1u32..5) {
        let power = p.pow(k).expect("small");
        let root = exact_root(&power, k).expect("small").expect("a power has a root");
        prop_assert!(root == p || (k % 2 == 0 && root == p.neg()));
    }

    #[test]
    fn substitution_commutes_with_evaluation(
        a in polynomial(), b in polynomial(),
        x in rational(), y in rational(), z in rational(),
    ) {
        let at = |v: u32| [x.clone(), y.clone(), z.clone()][v as usize].clone();
        let inner = b.evaluate(&at);
        let expected = a.evaluate(&|v| if v == 1 { inner.clone() } else { at(v) });
        let substituted = a.substitute(1, &b).expect("small");
        prop_assert_eq!(substituted.evaluate(&at), expected.clone());
        let all = a.substitute_all(&|v| (v == 1).then(|| b.clone())).expect("small");
        prop_assert_eq!(all, substituted);
        prop_assert_eq!(a.evaluate_at(1, &inner).evaluate(&at), expected);
    }

    #[test]
    fn derivatives_obey_the_product_rule_and_the_difference_quotient(a in polynomial(), b in polynomial()) {
        let left = a.mul(&b).derivative(2);
        prop_assert_eq!(left, a.derivative(2).mul(&b).add(&a.mul(&b.derivative(2))));
        // (a(z + h) − a(z))/h at h = 0, with h the variable 9.
        let shifted = Polynomial::variable(2).add(&Polynomial::variable(9));
        let difference = a.substitute(2, &shifted).expect("small").sub(&a);
        let quotient = difference.exact_divide(&Polynomial::variable(9)).expect("h divides");
        prop_assert_eq!(quotient.evaluate_at(9, &Rational::from(0)), a.derivative(2));
    }

    #[test]
    fn roots_of_known_linear_factors_are_found_and_counted(
        roots in prop::collection::vec(rational(), 1..6), quadratic in 1i64..6,
        lower in rational(), width in rational(),
    ) {
        let x = Polynomial::variable(0);
        let mut p = Polynomial::constant(Rational::from(-1));
        for root in &roots {
            p = p.mul(&x.sub(&Polynomial::constant(root.clone())));
        }
        // No real roots, then two that may be irrational.
        p = p.mul(&x.mul(&x).add(&Polynomial::integer(quadratic)));
        let mut known = roots.clone();
        known.sort();
        known.dedup();
        let f = Univariate::from_polynomial(&p, 0).expect("one variable");
        prop_assert_eq!(f.rational_roots(), known.clone());
        prop_assert_eq!(f.root_count(), known.len());
        prop_assert_eq!(f.real_roots(), known.iter().cloned().map(RealRoot::Exact).collect::<Vec<_>>());
        let upper = &lower + if width < 0 { -width } else { width };
        for (a, b) in [
            (End::Open(lower.clone()), End::Open(upper.clone())),
            (End::Closed(lower.clone()), End::Open(upper.clone())),
            (End::Open(lower.clone()), End::Closed(upper.clone())),
            (End::Closed(lower.clone()), End::Closed(upper.clone())),
            (End::Closed(lower.clone()), End::Infinite),
            (End::Infinite, End::Open(upper.clone())),
        ] {
            let interval = Interval { lower: a, upper: b };
            let inside = known.iter().filter(|r| interval.contains(r)).count();
            prop_assert_eq!(f.root_count_in(&interval), inside, "{:?}", interval);
            check_sign(&p, &f, &interval)?;
        }
        let q = p.mul(&x.mul(&x).sub(&Polynomial::integer(quadratic)));
        let g = Univariate::from_polynomial(&q, 0).expect("one variable");
        for interval in [
            Interval::whole(),
            Interval { lower: End::Closed(lower.clone()), upper: End::Open(upper.clone()) },
            Interval { lower: End::Open(lower), upper: End::Infinite },
        ] {
            check_sign(&q, &g, &interval)?;
        }
        let all = g.real_roots();
        for (index, root) in all.iter().enumerate() {
            match root {
                RealRoot::Exact(r) => prop_assert!(g.sign_at(r).is_eq()),
                RealRoot::Between(a, b) => {
                    prop_assert!(a < b && !g.sign_at(a).is_eq() && !g.sign_at(b).is_eq());
                    let open = Interval { lower: End::Open(a.clone()), upper: End::Open(b.clone()) };
                    prop_assert_eq!(g.root_count_in(&open), 1);
                }
            }
            if let Some(next) = all.get(index + 1) {
                prop_assert!(root.upper() <= next.lower());
            }
        }
        prop_assert_eq!(all.len(), g.root_count());
        let positive = all.iter().filter(|root| *root.upper() > 0).count();
        prop_assert!(positive <= g.sign_variations() && g.sign_variations() <= g.degree());
        check_sign(&p, &f, &Interval::whole())?;
    }

    #[test]
    fn numerals_denote_what_their_digits_say(n in -99_999i64..99_999, places in 0u32..5, e in -12i32..12) {
        let digits = format!("{:06}", n.unsigned_abs());
        let (whole, part) = digits.split_at(digits.len() - places as usize);
        let sign = if n < 0 { "-" } else { "" };
        let point = if places > 0 { "." } else { "" };
        let text = format!("{sign}{whole}{point}{part}e{e}");
        let ten = Rational::from(10).pow(i64::from(e) - i64::from(places));
        prop_assert_eq!(parse(&text), Ok(Rational::from(n) * ten));
        let over = format!("{n}/{}", 10u64.pow(places));
        prop_assert_eq!(parse(&over), Ok(Rational::from_signeds(n, 10i64.pow(places))));
    }
}

/// The stated sign holds at points all over the interval, and its witnesses are in it.
fn check_sign(p: &Polynomial, f: &Univariate, interval: &Interval) -> Result<(), TestCaseError> {
    let value = |x: &Rational| p.evaluate(&|_| x.clone());
    let sign = f.sign_on(interval);
    if let SignOn::Mixed { positive, negative } = &sign {
        prop_assert!(interval.contains(positive) && value(positive) > 0);
        prop_assert!(interval.contains(negative) && value(negative) < 0);
    }
    let zeros = f.root_count_in(interval);
    for i in -60i64..=60 {
        let x = Rational::from_signeds(i, 6);
        if interval.contains(&x) {
            let v = value(&x);
            let holds = match &sign {
                SignOn::Empty => false,
                SignOn::Zero => v == 0,
                SignOn::Positive => v > 0 && zeros == 0,
                SignOn::Negative => v < 0 && zeros == 0,
                SignOn::NonNegative => v >= 0 && zeros > 0,
                SignOn::NonPositive => v <= 0 && zeros > 0,
                SignOn::Mixed { .. } => true,
            };
            prop_assert!(holds, "{sign:?} at {x} on {interval:?} for {p}");
        }
    }
    Ok(())
}

#[test]
fn known_factorisations_are_found() {
    let name = |v: u32| ["a", "b", "c"][v as usize].to_owned();
    let (a, b, c) = (Polynomial::variable(0), Polynomial::variable(1), Polynomial::variable(2));
    let one = Polynomial::one();
    let cases = [
        (a.pow(4).expect("small").sub(&b.pow(4).expect("small")), 3),
        (a.pow(6).expect("small").sub(&Polynomial::integer(8)), 2),
        (a.mul(&a).sub(&Polynomial::integer(2)), 1),
        (a.add(&b).mul(&a.add(&b).add(&c)).mul(&c.add(&one)), 3),
        (a.mul(&b).mul(&a.mul(&b).sub(&one)), 3),
        (a.pow(3).expect("small").add(&b.pow(3).expect("small")), 2),
        (a.mul(&a).sub(&b.mul(&c).mul(&b).mul(&c)), 2),
    ];
    for (p, count) in cases {
        let found = factor(&p).expect("small");
        let shown: Vec<String> = found.factors.iter().map(|(f, _)| f.display(&name)).collect();
        assert_eq!(found.factors.len(), count, "{}: {shown:?}", p.display(&name));
    }
}

#[test]
fn measured_values_and_malformed_numerals_are_refused_with_their_place() {
    assert_eq!(parse("1.2(3)"), Err(NumeralError::Uncertainty { at: 3 }));
    assert_eq!(parse(""), Err(NumeralError::MissingDigits { at: 0 }));
    assert_eq!(parse("1."), Err(NumeralError::MissingDigits { at: 2 }));
    assert_eq!(parse(".5"), Err(NumeralError::Unexpected { at: 0, found: '.' }));
    assert_eq!(parse("1/0"), Err(NumeralError::ZeroDenominator { at: 2 }));
    assert_eq!(parse("1e10001"), Err(NumeralError::ExponentTooLarge { at: 2, allowed: 10_000 }));
    assert_eq!(parse("1e99999999999999999999999"), Err(NumeralError::ExponentTooLarge { at: 2, allowed: 10_000 }));
    assert_eq!(parse("1e0000000000000000000000000000000003"), Ok(Rational::from(1000)));
    assert_eq!(parse(&"7".repeat(10_001)), Err(NumeralError::TooManyDigits { allowed: 10_000, needed: 10_001 }));
    assert_eq!(parse("1.5/2"), Err(NumeralError::Unexpected { at: 3, found: '/' }));
    assert_eq!(parse("--1"), Err(NumeralError::Unexpected { at: 1, found: '-' }));
}

#[test]
fn exact_roots_of_numbers_are_exact_or_absent() {
    let r = |n, d| Rational::from_signeds(n, d);
    assert_eq!(rational::exact_root(&r(8, 27), 3), Some(r(2, 3)));
    assert_eq!(rational::exact_root(&r(2, 1), 2), None);
    assert_eq!(rational::exact_root(&r(-8, 1), 3), None);
    assert_eq!(rational::exact_root(&r(2, 1), u64::MAX), None);
    assert_eq!(rational::exact_root(&r(1, 1), u64::MAX), Some(r(1, 1)));
    assert_eq!(rational::exact_root(&r(5, 1), 0), None);
    for (k, base) in [(2u64, 3i64), (5, 7), (10, 2)] {
        let power = Rational::from(base).pow(k);
        assert_eq!(rational::exact_root(&power, k), Some(r(base, 1)));
        assert_eq!(rational::exact_root(&(power + r(1, 1)), k), None);
    }
}
