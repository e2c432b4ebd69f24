//! Laws of the exact algebra, on random inputs.
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
        prop_assert_eq!(a.pow(3).unwrap(), a.mul(&a).mul(&a));
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
