//! Versions of a scene with other simple masses, for pupils who sit side by side.
//!
//! **Contract.** A version has as many bodies as its scene, the same restitutions and the same start; where the scene has
//! equal neighbours so has the version, and where one is heavier it stays so. Each mass is one of `SIMPLE` times a power
//! of ten, from half to twice the scene's one. Up to three bodies of optimal mass get ends whose ratio is a power, so that all
//! masses are rational. The same seed gives the same versions, on every machine.

use super::drop::Drop;
use super::{Chain, Inserted};
use crate::chain::uncertain::Range;
use crate::chain::{ChainError, Positive};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Pow;
use malachite::base::num::basic::traits::{One, Two};

/// The masses that are chosen from, times powers of ten, in tenths.
const SIMPLE: [u32; 10] = [10, 12, 15, 20, 25, 30, 40, 50, 60, 80];
/// Steps between neighbours of optimal mass.
const STEPS: [u32; 3] = [2, 3, 4];
/// The most bodies of optimal mass for which steps are chosen: later ones would be far too heavy.
const MAX_STEPS: u64 = 3;
/// So often new masses are drawn until they are in order and differ from earlier ones.
const TRIES: usize = 300;

/// Random numbers: SplitMix64.
struct Dice(u64);

impl Dice {
    fn below(&mut self, count: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        // Far from even counts: so many choices are few.
        usize::try_from((z ^ (z >> 31)) % count.max(1) as u64).unwrap_or(0)
    }
}

/// The numbers below `count` in the order that a seed gives them.
#[must_use]
pub fn shuffled(seed: u64, count: usize) -> Vec<usize> {
    let mut dice = Dice(seed);
    let mut order: Vec<usize> = (0..count).collect();
    for left in (2..=count).rev() {
        order.swap(left - 1, dice.below(left));
    }
    order
}

/// So many versions of a chain.
///
/// # Errors
/// Those of [`Chain::new`].
pub fn of_chain(chain: &Chain, seed: u64, count: usize) -> Result<Vec<Chain>, ChainError> {
    let old: Vec<Rational> = match chain.masses() {
        Some(masses) => masses.iter().map(middle).collect(),
        None => vec![middle(chain.first()), middle(chain.last())],
    };
    let optimal = matches!(chain.inserted(), Inserted::Optimal(n) if *n <= MAX_STEPS);
    let collisions = chain.count() + 1;
    let made = drawn(&old, seed, count, |dice, old| {
        let mut masses = simple(dice, old);
        if let (true, [first, last]) = (optimal, masses.as_mut_slice()) {
            let step = Rational::from(STEPS[dice.below(STEPS.len())]).pow(collisions);
            let (light, heavy) = if old[0] < old[1] { (first, last) } else { (last, first) };
            *heavy = if old[0] == old[1] { light.clone() } else { &*light * step };
        }
        masses
    });
    let build = |masses: Vec<Rational>| {
        let mut masses =
            masses.into_iter().map(|m| Positive::new(m).map(Range::point)).collect::<Result<Vec<_>, _>>()?;
        let last = masses.pop().unwrap_or_else(|| chain.last().clone());
        let mut rest = masses.into_iter();
        let first = rest.next().unwrap_or_else(|| chain.first().clone());
        let inserted = match chain.inserted() {
            Inserted::Optimal(n) => Inserted::Optimal(*n),
            Inserted::Given(_) => Inserted::Given(rest.collect()),
        };
        Chain::new(first, last, inserted, chain.coefficients().clone(), chain.start().clone())
    };
    made.into_iter().map(build).collect()
}

/// So many versions of balls that are dropped.
///
/// # Errors
/// Those of [`Drop::new`].
pub fn of_drop(drop: &Drop, seed: u64, count: usize) -> Result<Vec<Drop>, ChainError> {
    let old: Vec<Rational> = drop.masses().iter().map(middle).collect();
    let build = |masses: Vec<Rational>| {
        let masses = masses.into_iter().map(|m| Positive::new(m).map(Range::point)).collect::<Result<_, _>>()?;
        Drop::new(masses, drop.coefficients().clone(), drop.floor().clone(), drop.height().cloned())
    };
    drawn(&old, seed, count, simple).into_iter().map(build).collect()
}

fn middle(mass: &Range<Positive>) -> Rational {
    super::middle(mass.lo().value(), mass.hi().value())
}

/// Lists of masses, each drawn until its order is that of the old one and it is new.
fn drawn(
    old: &[Rational],
    seed: u64,
    count: usize,
    draw: impl Fn(&mut Dice, &[Rational]) -> Vec<Rational>,
) -> Vec<Vec<Rational>> {
    let mut dice = Dice(seed);
    let order = |list: &[Rational]| list.windows(2).map(|pair| pair[0].cmp(&pair[1])).collect::<Vec<_>>();
    let wanted = order(old);
    let mut made: Vec<Vec<Rational>> = Vec::new();
    for _ in 0..count {
        // In order they must be; new they are where there are enough.
        let mut ordered = old.to_vec();
        for _ in 0..TRIES {
            let masses = draw(&mut dice, old);
            if order(&masses) == wanted {
                ordered = masses;
                if !made.contains(&ordered) && ordered != old {
                    break;
                }
            }
        }
        made.push(ordered);
    }
    made
}

/// Simple masses near the old ones; equal neighbours stay equal.
fn simple(dice: &mut Dice, old: &[Rational]) -> Vec<Rational> {
    let mut masses: Vec<Rational> = Vec::new();
    for (place, mass) in old.iter().enumerate() {
        match (place.checked_sub(1).map(|before| &old[before]), masses.last()) {
            (Some(before), Some(last)) if before == mass => masses.push(last.clone()),
            _ => {
                let near = near(mass);
                masses.push(near.get(dice.below(near.len())).unwrap_or(mass).clone());
            }
        }
    }
    masses
}

/// The simple masses from half to twice a mass.
fn near(mass: &Rational) -> Vec<Rational> {
    let (ten, mut scale) = (Rational::from(10u32), Rational::ONE);
    while &scale * &ten <= *mass {
        scale *= &ten;
    }
    while scale > *mass {
        scale /= &ten;
    }
    let decades = [&scale / &ten, scale.clone(), &scale * &ten];
    let all = decades.iter().flat_map(|scale| SIMPLE.map(|s| Rational::from(s) * scale / &ten));
    all.filter(|m| m * Rational::TWO >= *mass && *m <= mass * Rational::TWO).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::read::scene;

    fn masses(text: &str, seed: u64, count: usize) -> Vec<Vec<Rational>> {
        let found = scene(text).expect("it reads");
        let chain = found.inputs.chain().expect("a chain");
        let made = of_chain(chain, seed, count).expect("versions");
        let list = |chain: &Chain| chain.masses().unwrap_or_else(|| vec![chain.first().clone(), chain.last().clone()]);
        made.iter().map(|chain| list(chain).iter().map(|m| m.lo().value().clone()).collect()).collect()
    }

    #[test]
    fn versions_differ_and_keep_the_order_of_masses() {
        let text = "[chain]\nfirst = \"620\"\ninserted = [\"57.7\", \"57.7\"]\nlast = \"2.7\"\nrestitution = \"0.8\"\n";
        for seed in 0..50 {
            let made = masses(text, seed, 3);
            assert!(made[0] != made[1] && made[1] != made[2] && made[0] != made[2], "seed {seed}");
            for list in &made {
                assert!(list[0] > list[1] && list[1] == list[2] && list[2] > list[3], "seed {seed}: {list:?}");
                assert!(list.iter().all(|m| m.to_string().len() <= 5), "seed {seed}: {list:?} are simple");
            }
            assert_eq!(made, masses(text, seed, 3), "the seed decides");
        }
        assert_ne!(masses(text, 1, 3), masses(text, 2, 3));
    }

    #[test]
    fn optimal_masses_of_a_version_are_rational() {
        let text = "[chain]\nfirst = \"7\"\ninserted = 2\nlast = \"1\"\nrestitution = \"0.9\"\n";
        for list in masses(text, 5, 20) {
            let root = crate::number::rational::exact_root(&(&list[0] / &list[1]), 3);
            assert!(root.is_some_and(|root| root > 1), "{list:?}");
        }
    }
}
