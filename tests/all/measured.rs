//! Measured inputs: no value of the box lies outside of the answer, and the ends of the answer are reached.
#![allow(clippy::unwrap_used)] // a test stops where it fails

use carom::chain::insertion::{self, Bounds};
use carom::chain::pass::Pass;
use carom::chain::threshold::Helps;
use carom::chain::uncertain::given::{Given, matrices};
use carom::chain::uncertain::meeting::{Meeting, of_given, of_optimal};
use carom::chain::uncertain::optimum::Measured;
use carom::chain::uncertain::{Coefficients, Range, Reals, cells};
use carom::chain::{ChainError, Positive, Restitution, Restitutions, collision, recollision};
use carom::number::plus_minus::plus_minus;
use carom::number::real::Real;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Pow;
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::rounding_modes::RoundingMode;
use proptest::prelude::*;

fn double(x: &Rational) -> f64 {
    f64::rounding_from(x, RoundingMode::Nearest).0
}

/// About the least and the greatest element.
fn ends(x: &Reals) -> (f64, f64) {
    let value = |x: &Real| x.as_rational().map_or_else(|| x.enclosure(80).guess_f64(), double);
    (value(&x.least), value(&x.greatest))
}

fn range(lo: (u64, u64), hi: (u64, u64)) -> Range<Rational> {
    Range::new(Rational::from_unsigneds(lo.0, lo.1), Rational::from_unsigneds(hi.0, hi.1)).unwrap()
}

/// Masses from 1 to 40, some wide, some narrow, some exact.
fn masses(bodies: std::ops::Range<usize>) -> impl Strategy<Value = Vec<Range<Positive>>> {
    let width = prop_oneof![Just(0u64), 1u64..5, 1u64..400];
    let mass = (10u64..400, width);
    let make = |(lo, width): (u64, u64)| range((lo, 10), (lo + width, 10)).map(Positive::new).unwrap();
    prop::collection::vec(mass.prop_map(make), bodies)
}

fn coefficient() -> impl Strategy<Value = Range<Restitution>> {
    let make = |(lo, width): (u64, u64)| range((lo, 20), ((lo + width).min(20), 20)).map(Restitution::new).unwrap();
    (0u64..=20, prop_oneof![Just(0u64), 1u64..3, 1u64..20]).prop_map(make)
}

fn coefficients(count: usize) -> impl Strategy<Value = Coefficients> {
    prop_oneof![
        coefficient().prop_map(Coefficients::Same),
        prop::collection::vec(coefficient(), count).prop_map(Coefficients::Each),
    ]
}

/// A box, and shares that make points of it: in eighths of each range.
fn boxes(bodies: std::ops::Range<usize>) -> impl Strategy<Value = (Vec<Range<Positive>>, Coefficients, Vec<u8>)> {
    masses(bodies).prop_flat_map(|m| {
        let count = m.len();
        (Just(m), coefficients(count - 1), prop::collection::vec(0u8..=8, 2 * count))
    })
}

fn part(lo: &Rational, hi: &Rational, share: u8) -> Rational {
    lo + (hi - lo) * Rational::from_unsigneds(share, 8u8)
}

/// An exact chain of the box.
fn point(masses: &[Range<Positive>], e: &Coefficients, shares: &[u8]) -> (Vec<Positive>, Vec<Restitution>) {
    let m = masses.iter().zip(shares).map(|(m, s)| Positive::new(part(m.lo().value(), m.hi().value(), *s)).unwrap());
    let count = masses.len() - 1;
    let own = |k: usize| if matches!(e, Coefficients::Same(_)) { 0 } else { k };
    let e = (0..count).map(|k| {
        let range = e.at(k).unwrap();
        Restitution::new(part(range.lo().value(), range.hi().value(), shares[masses.len() + own(k)])).unwrap()
    });
    (m.collect(), e.collect())
}

fn holds(x: &Reals, value: &Rational) -> bool {
    let (least, greatest) = (x.least.as_rational().unwrap(), x.greatest.as_rational().unwrap());
    least <= value && value <= greatest
}

/// All quantities of a chain from rest, in doubles: velocities, then losses.
fn plain(m: &[f64], e: &[f64]) -> Vec<f64> {
    let mut arriving = 1.0;
    let (mut velocities, mut losses) = (Vec::new(), Vec::new());
    for k in 0..m.len() - 1 {
        let sum = m[k] + m[k + 1];
        velocities.push(arriving * (m[k] - e[k] * m[k + 1]) / sum);
        losses.push(arriving * arriving * m[k] * m[k + 1] / sum * (1.0 - e[k] * e[k]) / 2.0);
        arriving *= (1.0 + e[k]) * m[k] / sum;
    }
    velocities.push(arriving);
    velocities.extend(losses);
    velocities
}

/// The greatest value that a search coordinate by coordinate finds, from three points of the diagonal and the
/// three best corners: some corners are peaks of their own.
fn climb(sides: &[(f64, f64)], value: impl Fn(&[f64]) -> f64) -> f64 {
    let mut best = f64::NEG_INFINITY;
    let corner =
        |bits: u32| sides.iter().enumerate().map(|(i, s)| if bits >> i & 1 == 1 { s.1 } else { s.0 }).collect();
    let mut starts: Vec<Vec<f64>> = (0..1u32 << sides.len()).map(corner).collect();
    starts.sort_by(|p, q| value(q).total_cmp(&value(p)));
    starts.truncate(3);
    starts.extend([0.0, 0.5, 1.0].map(|start| sides.iter().map(|(lo, hi)| lo + (hi - lo) * start).collect()));
    for mut x in starts {
        for _ in 0..60 {
            let before = value(&x);
            for i in 0..x.len() {
                let (lo, hi) = sides[i];
                let mut at = |c: f64| {
                    x[i] = c;
                    value(&x)
                };
                let mut candidates = vec![lo, hi];
                let (mut a, mut b) = (lo, hi);
                for _ in 0..60 {
                    let (p, q) = (a + (b - a) * 0.382, a + (b - a) * 0.618);
                    if at(p) < at(q) { a = p } else { b = q }
                }
                candidates.push((a + b) / 2.0);
                let found = candidates.into_iter().max_by(|p, q| at(*p).total_cmp(&at(*q))).unwrap();
                x[i] = found;
            }
            if value(&x) - before <= 1e-13 * before.abs() {
                break;
            }
        }
        best = best.max(value(&x));
    }
    best
}

/// The sides of a box, masses first, then the coefficients or the one coefficient.
fn sides(masses: &[Range<Positive>], e: &Coefficients) -> Vec<(f64, f64)> {
    let mut sides: Vec<(f64, f64)> = masses.iter().map(|m| (double(m.lo().value()), double(m.hi().value()))).collect();
    let side = |e: &Range<Restitution>| (double(e.lo().value()), double(e.hi().value()));
    match e {
        Coefficients::Same(e) => sides.push(side(e)),
        Coefficients::Each(list) => sides.extend(list.iter().map(side)),
    }
    sides
}

fn of_sides(x: &[f64], bodies: usize) -> Vec<f64> {
    let e: Vec<f64> = if x.len() == bodies + 1 { vec![x[bodies]; bodies - 1] } else { x[bodies..].to_vec() };
    plain(&x[..bodies], &e)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// Random points of random boxes lie inside, in exact arithmetic.
    #[test]
    fn no_point_of_a_box_lies_outside((m, e, shares) in boxes(2..7)) {
        let given = Given::new(m.clone(), e.clone(), Rational::ONE, 60).unwrap();
        let (velocities, losses) = (given.velocities().unwrap(), given.losses().unwrap());
        let transfer = given.transfer().unwrap();
        let found = matrices(&m, &e).unwrap();
        for turn in 0..6 {
            let mut shares = shares.clone();
            let turn = turn % shares.len();
            shares.rotate_left(turn);
            let (masses, list) = point(&m, &e, &shares);
            let pass = Pass::from_rest(masses.clone(), Restitutions::Each(list.clone()), Rational::ONE).unwrap();
            for (i, (x, v)) in velocities.iter().zip(pass.velocities_after().unwrap()).enumerate() {
                prop_assert!(holds(x, &v), "velocity {} of {:?}: {} in {:?}", i, (&masses, &list), v, x);
            }
            for (x, v) in losses.iter().zip(pass.losses().unwrap()) {
                prop_assert!(holds(x, &v), "loss of {:?}: {} in {:?}", (&masses, &list), v, x);
            }
            prop_assert!(holds(&transfer, &pass.transfer().unwrap().into()));
            for ((x, pair), e) in found.iter().zip(masses.windows(2)).zip(&list) {
                let exact = collision::matrix(&pair[0], &pair[1], e);
                for (x, v) in x.iter().flatten().zip(exact.iter().flatten()) {
                    prop_assert!(holds(x, v));
                }
            }
        }
    }

    /// Whether a given body helps: no point of the box contradicts the answer, and both ends of the threshold are reached.
    #[test]
    fn whether_a_given_body_helps_is_right_all_over_the_box((m, e, shares) in boxes(3..4)) {
        let [a, mass, b] = m.as_slice() else { unreachable!() };
        let bounds = Bounds::of(a, mass, b);
        let answer = bounds.help(&e.around(0, 1).unwrap());
        let reals = bounds.reals().unwrap();
        let (least, greatest) = ends(&reals);
        let mut points: Vec<Vec<Positive>> = Vec::new();
        for turn in 0..6 {
            let mut shares = shares.clone();
            let turn = turn % shares.len();
            shares.rotate_left(turn);
            points.push(point(&m, &e, &shares).0);
        }
        for (a, b) in [(a.lo(), b.lo()), (a.lo(), b.hi()), (a.hi(), b.lo()), (a.hi(), b.hi())] {
            let best = Rational::try_from((double(a.value()) * double(b.value())).sqrt()).unwrap();
            let inside = Positive::new(best.clamp(mass.lo().value().clone(), mass.hi().value().clone())).unwrap();
            points.extend([mass.lo().clone(), mass.hi().clone(), inside].map(|m| vec![a.clone(), m, b.clone()]));
        }
        let (mut low, mut high) = (f64::INFINITY, 0.0f64);
        let mut seen = Vec::new();
        for x in points {
            let (a, m, b) = (x[0].value(), x[1].value(), x[2].value());
            let tau = insertion::exact(&x[0], &x[1], &x[2]);
            prop_assert!(tau <= *reals.greatest.as_rational().unwrap(), "{} of {:?}", tau, x);
            (low, high) = (low.min(double(&tau)), high.max(double(&tau)));
            // Coefficients of the two collisions, at all ends, and of the direct one.
            let range = |k: usize| e.at(k).unwrap();
            for (p, q) in [(range(0).lo(), range(1).lo()), (range(0).hi(), range(1).hi()), (range(0).lo(), range(1).hi()),
                (range(0).hi(), range(1).lo())] {
                if e.shared().is_some() && p != q {
                    continue;
                }
                for d in [p, q] {
                    let with = p.plus_one() * q.plus_one() * m * (a + b);
                    seen.push(match with.cmp(&(d.plus_one() * (a + m) * (m + b))) {
                        std::cmp::Ordering::Greater => Helps::Yes,
                        std::cmp::Ordering::Less => Helps::No,
                        std::cmp::Ordering::Equal => Helps::OnTheThreshold,
                    });
                }
            }
        }
        prop_assert!((low - least).abs() < 1e-12 && (high - greatest).abs() < 1e-12);
        let same = seen.iter().all(|x| *x == seen[0]).then_some(seen[0]);
        prop_assert_eq!(answer, same);
    }

    /// The ends are reached: a search in doubles comes to them.
    #[test]
    fn the_ends_of_given_masses_are_reached((m, e, _) in boxes(2..6)) {
        let given = Given::new(m.clone(), e.clone(), Rational::ONE, 60).unwrap();
        let all: Vec<Reals> = given.velocities().unwrap().into_iter().chain(given.losses().unwrap()).collect();
        let sides = sides(&m, &e);
        for (i, x) in all.iter().enumerate() {
            let (least, greatest) = ends(x);
            let top = climb(&sides, |x| of_sides(x, m.len())[i]);
            let bottom = -climb(&sides, |x| -of_sides(x, m.len())[i]);
            prop_assert!(bottom >= least - 1e-12 && top <= greatest + 1e-12, "{} {} in {} {}", bottom, top, least, greatest);
            // The one end that may exceed: pieces of a shared coefficient.
            let slack = if e.shared().is_some() && i < m.len() { 2e-2 * greatest.abs() } else { 1e-9 };
            prop_assert!(greatest - top <= slack + 1e-9, "quantity {} of {:?} {:?}: greatest {} found {}", i, m, e, greatest, top);
            prop_assert!(bottom - least <= 1e-9, "quantity {} of {:?} {:?}: least {} found {}", i, m, e, least, bottom);
        }
        // The least transfer is that of a vertex.
        let (least, greatest) = ends(&given.transfer().unwrap());
        let eta = |x: &[f64]| of_sides(x, m.len())[m.len() - 1].powi(2) * x[m.len() - 1] / x[0];
        prop_assert!((greatest - climb(&sides, eta)).abs() <= 1e-9);
        prop_assert!((least + climb(&sides, |x| -eta(x))).abs() <= 1e-6);
    }

    /// Optimal masses: a grid over the box lies inside and reaches the ends.
    #[test]
    fn optimal_masses_are_covered_and_reached(
        ends_of in prop::collection::vec((1u64..60, 0u64..30), 2),
        n in 1u64..5,
        e in (1usize..5).prop_flat_map(coefficients),
    ) {
        let m: Vec<Range<Positive>> = ends_of.iter().map(|(lo, w)| range((*lo, 4), (lo + w, 4)).map(Positive::new).unwrap()).collect();
        let e = match e {
            Coefficients::Each(list) => Coefficients::Each((0..=n as usize).map(|k| list[k % list.len()].clone()).collect()),
            same => same,
        };
        let chain = Measured::new(m[0].clone(), m[1].clone(), n, e.clone(), Rational::ONE, 80);
        let found: Vec<Reals> =
            (0..=n + 1).map(|i| chain.velocity(i).unwrap()).chain((1..=n + 1).map(|i| chain.loss(i).unwrap())).collect();
        let value = |x: &[f64]| {
            let step = (x[0] / x[1]).powf(1.0 / (n + 1) as f64);
            let masses: Vec<f64> = (0..=n + 1).map(|i| x[0] * step.powi(-(i as i32))).collect();
            let e: Vec<f64> = if x.len() == 3 { vec![x[2]; n as usize + 1] } else { x[2..].to_vec() };
            plain(&masses, &e)
        };
        let sides = sides(&m, &e);
        for (i, x) in found.iter().enumerate() {
            let (least, greatest) = ends(x);
            let (top, bottom) = (climb(&sides, |x| value(x)[i]), -climb(&sides, |x| -value(x)[i]));
            prop_assert!((greatest - top).abs() <= 1e-9, "quantity {} of {:?} {:?} {}: {} found {}", i, m, e, n, greatest, top);
            prop_assert!((bottom - least).abs() <= 1e-9, "quantity {} of {:?} {:?} {}: {} found {}", i, m, e, n, least, bottom);
        }
        for k in 0..=n {
            for (i, x) in chain.matrix(k).unwrap().iter().flatten().enumerate() {
                let at = |y: &[f64]| {
                    let step = (y[0] / y[1]).powf(1.0 / (n + 1) as f64);
                    let e = if y.len() == 3 { y[2] } else { y[2 + k as usize] };
                    [step - e, 1.0 + e, step * (1.0 + e), 1.0 - e * step][i] / (1.0 + step)
                };
                let (least, greatest) = ends(x);
                prop_assert!((greatest - climb(&sides, at)).abs() <= 1e-9 && (least + climb(&sides, |y| -at(y))).abs() <= 1e-9);
            }
        }
    }

    /// With other bodies in motion nothing lies outside, and the excess is a share of the input's own spread.
    #[test]
    fn moving_bodies_are_covered((m, e, shares) in boxes(2..5), slower in prop::collection::vec(0u64..3, 5)) {
        let before: Vec<Rational> = (0..m.len()).map(|k| if k == 0 { Rational::from(4) } else { -Rational::from(slower[k]) }).collect();
        let found = match cells::follow(&m, &e, &before) {
            Err(ChainError::MayNotCollide { .. }) => return Ok(()),
            found => found.unwrap(),
        };
        for turn in 0..6 {
            let mut shares = shares.clone();
            let turn = turn % shares.len();
            shares.rotate_left(turn);
            let (masses, list) = point(&m, &e, &shares);
            let pass = Pass::new(masses, Restitutions::Each(list), before.clone()).unwrap();
            for (x, v) in found.velocities.iter().zip(pass.velocities_after().unwrap()) {
                prop_assert!(holds(x, &v));
            }
            for (x, v) in found.losses.iter().zip(pass.losses().unwrap()) {
                prop_assert!(holds(x, &v));
            }
        }
        // Beside the tight bounds, where only the first body moves.
        let rest: Vec<Rational> = (0..m.len()).map(|k| if k == 0 { Rational::ONE } else { Rational::ZERO }).collect();
        let (cut, tight) = (cells::follow(&m, &e, &rest).unwrap().velocities, Given::new(m.clone(), e.clone(), Rational::ONE, 60).unwrap());
        let ratio = |m: &Range<Positive>| double(m.hi().value()) / double(m.lo().value());
        let spread: f64 = m.iter().map(|m| ratio(m) - 1.0).sum();
        let own = e.shared().map_or(0.0, |e| double(e.hi().value()) - double(e.lo().value()));
        let allowed = spread / cells::CELLS as f64 * 2.0 + own * m.len() as f64 / cells::PIECES as f64 * 2.0 + 1e-9;
        for (x, y) in cut.iter().zip(tight.velocities().unwrap()) {
            let ((low, high), (least, greatest)) = (ends(x), ends(&y));
            prop_assert!(low <= least + 1e-9 && least - low <= allowed * 3.0, "{} {} {}", low, least, allowed);
            prop_assert!(high >= greatest - 2e-2 * greatest.abs() - 1e-9 && high - greatest <= allowed * 3.0, "{} {} {}", high, greatest, allowed);
        }
    }

    /// Whether bodies meet again agrees with exact chains of the box, and "depends" has witnesses for three bodies.
    #[test]
    fn meetings_agree_with_points_of_the_box((m, e, shares) in boxes(2..6)) {
        let found = of_given(&m, &e);
        let mut seen = [false, false];
        let mut look = |shares: &[u8]| {
            let (masses, list) = point(&m, &e, shares);
            let pass = Pass::from_rest(masses, Restitutions::Each(list), Rational::ONE).unwrap();
            seen[usize::from(recollision::of_velocities(&pass.velocities_after().unwrap()))] = true;
        };
        for turn in 0..shares.len() {
            let mut shares = shares.clone();
            shares.rotate_left(turn);
            look(&shares);
        }
        if m.len() == 3 {
            for bits in 0..1u32 << 5 {
                let corner: Vec<u8> = (0..6).map(|i| if bits >> i & 1 == 1 { 8 } else { 0 }).collect();
                look(&corner);
            }
        }
        let agrees = match found {
            Meeting::Always => seen == [false, true],
            Meeting::Never => seen == [true, false],
            Meeting::Depends => m.len() != 3 || seen == [true, true],
            // At equality in doubles, or with independent coefficients in conflict.
            Meeting::Unsettled => m.len() > 3 || seen[1],
        };
        prop_assert!(agrees, "{:?} but seen {:?} for {:?} {:?}", found, seen, m, e);
    }

    /// The same for optimal masses.
    #[test]
    fn optimal_meetings_agree_with_corners(lo in (1u64..40, 1u64..40), width in (0u64..20, 0u64..20), n in 1u64..4, e in (1usize..4).prop_flat_map(coefficients)) {
        let mass = |lo: u64, w: u64| range((lo, 3), (lo + w, 3)).map(Positive::new).unwrap();
        let (first, last) = (mass(lo.0, width.0), mass(lo.1, width.1));
        let e = match e {
            Coefficients::Each(list) => Coefficients::Each((0..=n as usize).map(|k| list[k % list.len()].clone()).collect()),
            same => same,
        };
        let (found, _) = of_optimal(&first, &last, &e, n).unwrap();
        let mut seen = [false, false];
        // Bodies meet again where their masses are near one another: equal masses are looked at beside the corners.
        let common = first.lo().value().max(last.lo().value()).clone();
        let equal = common <= *first.hi().value() && common <= *last.hi().value();
        let choices = 1u64 << (n + 3);
        for bits in 0..choices * (1 + u64::from(equal)) {
            let bit = |i: u64| bits >> i & 1 == 1;
            let pick = |m: &Range<Positive>, high: bool| {
                if bits >= choices {
                    Positive::new(common.clone()).unwrap()
                } else if high {
                    m.hi().clone()
                } else {
                    m.lo().clone()
                }
            };
            let list = (0..=n).map(|k| {
                let range = e.at(k as usize).unwrap();
                let own = if matches!(e, Coefficients::Same(_)) { 0 } else { k };
                if bit(2 + own) { range.hi().clone() } else { range.lo().clone() }
            });
            let restitutions = Restitutions::Each(list.collect()).for_inserted(n).unwrap();
            let chain = carom::chain::optimum::Optimum::new(pick(&first, bit(0)), pick(&last, bit(1)), n, restitutions).unwrap();
            seen[usize::from(recollision::of_optimum(&chain).unwrap().0)] = true;
        }
        match found {
            Meeting::Always => prop_assert_eq!(seen, [false, true]),
            Meeting::Never => prop_assert_eq!(seen, [true, false]),
            _ => prop_assert!(seen[1]),
        }
    }
}

/// Where the greatest value lies inside of a range, it is met to many digits.
#[test]
fn an_inner_maximum_is_met_to_forty_digits() {
    // m0 = 8, m2 = 2, the middle mass from 1 to 10: the last velocity is greatest at m1 = 4.
    let exact = |text: u64| Range::point(Positive::new(Rational::from(text)).unwrap());
    let wide = range((1, 1), (10, 1)).map(Positive::new).unwrap();
    let one = Coefficients::Same(Range::point(Restitution::new(Rational::ONE).unwrap()));
    let given = Given::new(vec![exact(8), wide.clone(), exact(2)], one.clone(), Rational::ONE, 150).unwrap();
    let last = given.velocities().unwrap().pop().unwrap();
    assert_eq!(last.greatest.as_rational(), Some(&Rational::from_unsigneds(16u32, 9u32)));
    // Irrational: m2 = 1, at m1 = sqrt 8; the velocity is 4·8/(8 + 2·sqrt 8 + 1).
    let given = Given::new(vec![exact(8), wide, exact(1)], one, Rational::ONE, 150).unwrap();
    let last = given.velocities().unwrap().pop().unwrap();
    let found = last.greatest.as_rational().unwrap();
    let root = carom::number::root::root(&Rational::from(8), &2u32.into(), 300).middle(290).point().unwrap();
    let value = Rational::from(32) / (Rational::from(9) + Rational::from(2) * root);
    let gap = double(&(found - value));
    assert!(gap.abs() < 1e-45, "{gap}");
}

/// Equal ranges in a list are not one coefficient: what is said of all must hold for unequal ones, too.
#[test]
fn equal_ranges_in_a_list_are_independent() {
    let e = range((4, 5), (9, 10)).map(Restitution::new).unwrap();
    let mass = |m: u64| Range::point(Positive::new(Rational::from(m)).unwrap());
    // Equal masses: the pair meets iff (1 + 1)(1 + 1) < (1 + e)(1 + f)/e; always with e = f, and not with e = 9/10, f = 4/5.
    let same = Coefficients::Same(e.clone());
    let each = Coefficients::Each(vec![e.clone(), e]);
    assert_eq!(of_optimal(&mass(1), &mass(1), &same, 1).unwrap().0, Meeting::Always);
    assert_eq!(of_optimal(&mass(1), &mass(1), &each, 1).unwrap().0, Meeting::Depends);
    let masses = vec![mass(1), mass(1), mass(1)];
    assert_eq!((of_given(&masses, &same), of_given(&masses, &each)), (Meeting::Always, Meeting::Depends));
}

/// A long chain of measured masses.
#[test]
fn long_measured_chains_are_answered() {
    let mass = |k: u64| {
        let lo = 1000 - k + (k * 7919) % 13;
        range((lo * 1000, 1000), (lo * 1000 + 999, 1000)).map(Positive::new).unwrap()
    };
    let masses: Vec<_> = (0..250).map(mass).collect();
    let e = Coefficients::Same(Range::point(Restitution::new(Rational::from_unsigneds(9u32, 10u32)).unwrap()));
    let given = Given::new(masses.clone(), e.clone(), Rational::ONE, 60).unwrap();
    let velocities = given.velocities().unwrap();
    let shares = vec![3u8; 500];
    let (m, list) = point(&masses, &e, &shares);
    let exact = Pass::from_rest(m, Restitutions::Each(list), Rational::ONE).unwrap().velocities_after().unwrap();
    assert!(velocities.iter().zip(&exact).all(|(x, v)| holds(x, v)));
}

proptest! {
    #[test]
    fn the_printed_range_holds_the_range_and_is_at_most_twice_as_wide(
        a in -100_000i64..100_000, width in 1i64..100_000, below in 1u64..100_000, shift in -30i64..30,
    ) {
        let scale = Rational::from(10u32).pow(shift) / Rational::from(below);
        let (lo, hi) = (Rational::from(a) * &scale, Rational::from(a + width) * &scale);
        let shown = plus_minus(&lo, &hi).expect("a range");
        let read = Range::read(&shown).expect("what is printed is read");
        prop_assert!(*read.lo() <= lo && hi <= *read.hi(), "{shown} does not hold {lo} to {hi}");
        prop_assert!(read.hi() - read.lo() <= (hi - lo) * Rational::from(2), "{shown} is too wide");
    }
}
