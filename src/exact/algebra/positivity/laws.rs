//! Laws of the certificates: what ought to be proved is, and nothing false is.

use super::{Certificate, Constraint, Limits, Summand, certify};
use crate::algebra::{Monomial, Polynomial};
use malachite::Rational;
use proptest::prelude::*;

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

/// The constraints, strict or not.
fn conditions(polys: &[Polynomial], strict: bool) -> Vec<Constraint> {
    polys.iter().map(|poly| Constraint { poly: poly.clone(), strict }).collect()
}

#[test]
fn positivity_that_ought_to_be_proved_is_proved() {
    let (a, b, c) = (Polynomial::variable(0), Polynomial::variable(1), Polynomial::variable(2));
    let int = Polynomial::integer;
    let one = int(1);
    let square = |p: &Polynomial| p.mul(p);
    let cases: Vec<(&str, Polynomial, Vec<Polynomial>)> = vec![
        ("constant", int(3), vec![]),
        ("no real root", square(&a).sub(&a.scale(&Rational::from(2))).add(&int(2)), vec![]),
        ("shifted bounds", a.mul(&b).sub(&a).sub(&b).add(&one), vec![a.sub(&one), b.sub(&one)]),
        ("upper bound", int(8).sub(&square(&a)), vec![int(2).sub(&a), a.add(&one)]),
        ("box", one.sub(&a.mul(&b)), vec![a.clone(), b.clone(), one.sub(&a), one.sub(&b)]),
        ("transitivity", a.sub(&b), vec![a.sub(&c), c.sub(&b)]),
        ("squares are monotone", square(&a).sub(&square(&b)), vec![a.sub(&b), b.clone()]),
        ("square of a difference", square(&a).add(&square(&b)).sub(&a.mul(&b)), vec![a.clone(), b.clone()]),
        (
            "Bernstein in one variable, bound in the other",
            c.add(&one).sub(&a.mul(&a).scale(&Rational::from_signeds(1, 2))),
            vec![a.clone(), one.sub(&a), c.clone()],
        ),
        (
            "a chain of masses",
            a.mul(&b).add(&b.mul(&c)).sub(&square(&b)).sub(&c.mul(&b)),
            vec![a.sub(&b), b.sub(&c), c.clone()],
        ),
        ("nonlinear constraint", a.mul(&b), vec![a.mul(&b).sub(&square(&c)), c.clone()]),
    ];
    for (title, p, polys) in cases {
        let constraints = conditions(&polys, true);
        let found = certify(&p, &constraints, &[], true, &Limits::default());
        let certificate = found.unwrap_or_else(|| panic!("{title}: {p} > 0 was not proved"));
        assert!(certificate.is_strict() && certificate.verify(&p, &constraints), "{title}");
        assert!(!certificate.verify(&p.sub(&int(100)), &constraints), "{title}: wrong polynomial");
        let weak = conditions(&polys, false);
        let found = certify(&p, &weak, &[], false, &Limits::default());
        assert!(found.is_some_and(|c| c.verify(&p, &weak)), "{title}: {p} >= 0 was not proved");
        println!("{title}: {}", certificate.explain(&|v| format!("x{v}"), &constraints));
    }
    // Needs the square of a polynomial that only the caller can know.
    let hint = a.mul(&b).sub(&c).sub(&one);
    let p = square(&hint);
    assert_eq!(certify(&p, &[], &[], false, &Limits::default()), None);
    assert!(certify(&p, &[], &[hint], false, &Limits::default()).is_some());
}

#[test]
fn strictness_is_not_claimed_where_zero_is_reached() {
    let x = Polynomial::variable(0);
    let y = Polynomial::variable(1);
    let p = x.mul(&x).add(&y);
    let both = [x.clone(), y.clone()];
    assert!(certify(&p, &conditions(&both, true), &[], true, &Limits::default()).is_some());
    assert_eq!(certify(&p, &conditions(&both, false), &[], true, &Limits::default()), None);
    let square = x.mul(&x);
    assert_eq!(certify(&square, &[], &[], true, &Limits::default()), None);
    assert!(certify(&square, &[], &[], false, &Limits::default()).is_some());
    let forged = Certificate::Combination {
        summands: vec![Summand { weight: Rational::from(1), constraints: vec![], squares: vec![x.clone()] }],
        strict: true,
    };
    assert!(!forged.verify(&square, &[]));
    let unknown = Certificate::Combination {
        summands: vec![Summand { weight: Rational::from(1), constraints: vec![(7, 1)], squares: vec![] }],
        strict: false,
    };
    assert!(!unknown.verify(&x, &conditions(&both, false)));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn nothing_false_is_certified(
        p in polynomial(), linear in prop::collection::vec((-2i64..=2, -2i64..=2, -2i64..=2, -3i64..=3), 0..4),
        strict in any::<bool>(), want in any::<bool>(),
    ) {
        let polys: Vec<Polynomial> = linear.iter().map(|&(a, b, c, d)| {
            [a, b, c].iter().zip(0u32..).fold(Polynomial::integer(d), |sum, (k, v)| {
                sum.add(&Polynomial::variable(v).scale(&Rational::from(*k)))
            })
        }).collect();
        let constraints = conditions(&polys, strict);
        if let Some(certificate) = certify(&p, &constraints, &[], want, &Limits::default()) {
            prop_assert!(certificate.verify(&p, &constraints));
            prop_assert!(certificate.is_strict() || !want);
            for index in 0..7i64.pow(3) {
                let point = [index % 7 - 3, index / 7 % 7 - 3, index / 49 - 3];
                let at = |v: u32| Rational::from(point[v as usize]);
                let inside = polys.iter().all(|g| {
                    let value = g.evaluate(&at);
                    value > 0 || value == 0 && !strict
                });
                if inside {
                    let value = p.evaluate(&at);
                    prop_assert!(value > 0 || value == 0 && !certificate.is_strict(), "{p} at {point:?}");
                }
            }
        }
    }

    #[test]
    fn combinations_of_products_are_found_again(
        weights in prop::collection::vec(1i64..9, 3..7), picks in prop::collection::vec((0usize..5, 0usize..5), 7),
    ) {
        let (x, y) = (Polynomial::variable(0), Polynomial::variable(1));
        let one = Polynomial::one();
        let polys = [x.clone(), y.clone(), one.sub(&x), x.sub(&y), Polynomial::integer(3).sub(&x).sub(&y)];
        let constraints = conditions(&polys, true);
        let mut p = Polynomial::zero();
        for (weight, (i, j)) in weights.iter().zip(&picks) {
            p = p.add(&polys[*i].mul(&polys[*j]).scale(&Rational::from(*weight)));
        }
        let limits = Limits { extra_degree: 2 - p.degree().min(2), ..Limits::default() };
        let found = certify(&p, &constraints, &[], true, &limits);
        prop_assert!(found.is_some_and(|c| c.verify(&p, &constraints)), "{p}");
    }
}
