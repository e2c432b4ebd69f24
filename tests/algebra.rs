//! Laws of the exact algebra, on random inputs.
use carom::algebra::gcd::gcd;
use carom::algebra::{Monomial, Polynomial};
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

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

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
    #![proptest_config(ProptestConfig::with_cases(64))]

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
