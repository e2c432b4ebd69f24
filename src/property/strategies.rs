//! Strategies for proptest: random exact inputs that shrink to simple ones.
//!
//! ```
//! use carom_property::strategies::{masses, restitution};
//! use proptest::prelude::*;
//!
//! proptest!(|(m in masses(), e in restitution())| {
//!     let (m1, m2) = (m[0].value(), m[1].value());
//!     let gain = e.plus_one() * m1 / (m1 + m2);
//!     prop_assert!(gain >= 0 && gain <= 2);
//! });
//! ```

use carom_physics::chain::uncertain::Range;
use carom_physics::chain::{Positive, Restitution};
use carom_physics::scene::{Chain, Coefficients, Inserted, Start};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Pow;
use malachite::base::num::basic::traits::One;
use proptest::collection::vec;
use proptest::prelude::*;

/// The largest numerator and denominator of a random number.
const SIZE: u32 = 60;
/// The most inserted bodies.
const BODIES: usize = 5;

/// `p/q` above zero.
fn positive() -> impl Strategy<Value = Positive> {
    (1..=SIZE, 1..=SIZE).prop_filter_map("above zero", |(p, q)| Positive::new(Rational::from_unsigneds(p, q)).ok())
}

/// The masses of a chain: two to seven of them.
pub fn masses() -> impl Strategy<Value = Vec<Positive>> {
    vec(positive(), 2..=BODIES + 2)
}

/// A coefficient of restitution from 0 to 1, the ends among them.
pub fn restitution() -> impl Strategy<Value = Restitution> {
    let inner = (0..=SIZE, 1..=SIZE).prop_map(|(p, q)| Rational::from_unsigneds(p.min(q), q));
    prop_oneof![8 => inner, 1 => Just(Rational::ONE)].prop_filter_map("from 0 to 1", |e| Restitution::new(e).ok())
}

/// The masses of a chain with neighbours up to `10^30` apart: what is lost in doubles.
pub fn extreme_masses() -> impl Strategy<Value = Vec<Positive>> {
    let step = (positive(), -30i64..=30).prop_map(|(m, k)| m.value() * Rational::from(10u32).pow(k));
    vec(step, 1..=BODIES + 1).prop_filter_map("above zero", |steps| {
        let mut mass = Rational::ONE;
        let list = std::iter::once(Rational::ONE).chain(steps.into_iter().map(|step| {
            mass *= step;
            mass.clone()
        }));
        list.map(|m| Positive::new(m).ok()).collect()
    })
}

fn assembled(first: Positive, last: Positive, inserted: Inserted, e: Restitution) -> Option<Chain> {
    let coefficients = Coefficients::Same(Range::point(e));
    Chain::new(Range::point(first), Range::point(last), inserted, coefficients, Start::unit()).ok()
}

/// A chain with given masses and a coefficient for each collision, or one for all.
pub fn chain() -> impl Strategy<Value = Chain> {
    chain_of(masses())
}

/// The same with neighbours up to `10^30` apart.
pub fn extreme_chain() -> impl Strategy<Value = Chain> {
    chain_of(extreme_masses())
}

fn chain_of(masses: impl Strategy<Value = Vec<Positive>>) -> impl Strategy<Value = Chain> {
    let coefficients = prop_oneof![vec(restitution(), 1), vec(restitution(), BODIES + 1)];
    (coefficients, masses).prop_filter_map("a chain", |(list, masses)| {
        let [first, inserted @ .., last] = masses.as_slice() else { return None };
        let list: Vec<_> = list.into_iter().map(Range::point).collect();
        let coefficients = match list.as_slice() {
            [one] => Coefficients::Same(one.clone()),
            list => Coefficients::Each(list[..=inserted.len()].to_vec()),
        };
        let inserted = Inserted::Given(inserted.iter().cloned().map(Range::point).collect());
        Chain::new(Range::point(first.clone()), Range::point(last.clone()), inserted, coefficients, Start::unit()).ok()
    })
}

/// A chain with bodies of optimal mass; for half of them the ratio of neighbours is rational.
pub fn optimal_chain() -> impl Strategy<Value = Chain> {
    let step = (1u32..=9, 1u32..=9).prop_map(|(p, q)| Rational::from_unsigneds(p, q));
    // What comes first shrinks first: then the masses are made simple for a simple restitution.
    let exact = (restitution(), 1..=BODIES as u64, step, positive()).prop_filter_map("a chain", |(e, n, x, last)| {
        let first = Positive::new(last.value() * x.pow(n + 1)).ok()?;
        assembled(first, last, Inserted::Optimal(n), e)
    });
    let any = (restitution(), 1..=BODIES as u64, positive(), positive())
        .prop_filter_map("a chain", |(e, n, first, last)| assembled(first, last, Inserted::Optimal(n), e));
    prop_oneof![exact, any]
}

/// A chain with `n` bodies of optimal mass whose restitution lies at `L_n`, exactly or nearly: the ratio is
/// `t^(n(n+1))`, so that `L_n = (1 + t^n)^(n+1)/(1 + t^(n+1))^n − 1` is rational.
pub fn near_threshold() -> impl Strategy<Value = Chain> {
    let step = (1u32..=6, 1u32..=6).prop_map(|(p, q)| Rational::from_unsigneds(p, q));
    let distance = prop_oneof![Just(0i64), (1i64..=30), (1i64..=30).prop_map(|k| -k)];
    (step, 1u64..=4, distance).prop_filter_map("from 0 to 1", |(t, n, distance)| {
        let one = || Rational::ONE;
        let exact = (one() + (&t).pow(n)).pow(n + 1) / (one() + (&t).pow(n + 1)).pow(n) - one();
        let tenth = Rational::from_unsigneds(1u32, 10u32);
        let e = match distance {
            0 => exact,
            k if k > 0 => exact + tenth.pow(k),
            k => exact - tenth.pow(-k),
        };
        let first = Positive::new(t.pow(n * (n + 1))).ok()?;
        assembled(first, Positive::new(one()).ok()?, Inserted::Optimal(n), Restitution::new(e).ok()?)
    })
}

/// A chain of given masses whose restitution lies at the threshold of one of its inserted bodies, exactly or nearly:
/// `τ = (a·b + μ²)/(μ·(a + b))`. For half of them the other collisions have coefficients of their own.
pub fn near_insertion() -> impl Strategy<Value = Chain> {
    let distance = prop_oneof![Just(0i64), (1i64..=30), (1i64..=30).prop_map(|k| -k)];
    let others = prop_oneof![Just(None), vec(restitution(), BODIES + 1).prop_map(Some)];
    (masses(), any::<prop::sample::Index>(), distance, others).prop_filter_map(
        "from 0 to 1",
        |(mut masses, place, distance, others)| {
            // A body helps for some restitution only if its mass lies between those of its neighbours.
            masses.sort();
            let k = place.index(masses.len().checked_sub(2).filter(|n| *n > 0)?);
            let [a, m, b] = masses.get(k..k + 3)? else { return None };
            let (a, m, b) = (a.value(), m.value(), b.value());
            let exact = (a * b + m * m) / (m * (a + b));
            let step = |k: i64| Rational::from_unsigneds(1u32, 10u32).pow(k);
            let e = match distance {
                0 => exact,
                k if k > 0 => exact + step(k),
                k => exact - step(-k),
            };
            let e = Range::point(Restitution::new(e).ok()?);
            let coefficients = match others {
                None => Coefficients::Same(e),
                Some(list) => {
                    let mut list: Vec<_> = list.into_iter().map(Range::point).take(masses.len() - 1).collect();
                    list.get_mut(k..k + 2)?.fill(e);
                    Coefficients::Each(list)
                }
            };
            let [first, inserted @ .., last] = masses.as_slice() else { return None };
            let inserted = Inserted::Given(inserted.iter().cloned().map(Range::point).collect());
            let (first, last) = (Range::point(first.clone()), Range::point(last.clone()));
            Chain::new(first, last, inserted, coefficients, Start::unit()).ok()
        },
    )
}
