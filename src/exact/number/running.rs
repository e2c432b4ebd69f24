//! Running quotients of long products, each in lowest terms.
//!
//! Contract: from `R_0 = above/below` each [`Step`] gives `R·kept/below`, which is written down, and `R·given/below`,
//! which is the next R. [`quotients`] gives all that are written down, and the last R.
//!
//! **Method.** No greatest common divisor of a long number is taken.
//!
//! - Small primes are divided out of every factor at the start, and counted. R has p to the power that the count says; a
//!   step multiplies or divides its long parts by the difference.
//! - What is left of a factor, its *rest*, rarely has a prime in common with another. All such primes divide one number,
//!   found once for all steps ([`super::product`]). The parts of R that consist of them are short, and they alone are
//!   compared with a step's rests.
//!
//! So the steps are known, in short numbers, before a long one is written. Numerators and denominators then follow side
//! by side.
//!
//! **Cost.** For each step two long numbers are multiplied and divided by short ones, and two more written down.

use super::fraction::Fraction;
use super::parallel::both;
use super::product::{Prime, product, shared};
use malachite::base::num::arithmetic::traits::{DivExact, DivExactAssign, Gcd, Pow};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::logic::traits::SignificantBits;
use malachite::{Natural, Rational};

/// Long numbers of fewer bits in all are not worth a thread (bench `peers`, J6).
const THREAD_BITS: u64 = 1_000_000;

/// The factors of one step; those of `below` and `given` are not zero.
#[derive(Clone, Debug)]
pub struct Step {
    /// By these R is divided, in what is written down and in the next R.
    pub below: Vec<Natural>,
    /// By this R is multiplied in what is written down.
    pub kept: Natural,
    /// By these R is multiplied in the next R.
    pub given: Vec<Natural>,
}

/// All that is written down, in the order of the steps, and then the last R; all in lowest terms.
#[must_use]
pub fn quotients(above: Natural, below: Natural, steps: &[Step]) -> Vec<Fraction> {
    let primes = Prime::small(steps.len() + 1);
    let first = (Split::of([&above], &primes), Split::of([&below], &primes));
    let split: Vec<[Split; 3]> = steps
        .iter()
        .map(|s| [Split::of(&s.below, &primes), Split::of([&s.kept], &primes), Split::of(&s.given, &primes)])
        .collect();
    let above = split.iter().flat_map(|[_, kept, given]| [&kept.rest, &given.rest]).chain([&first.0.rest]);
    let below = split.iter().map(|[below, ..]| &below.rest).chain([&first.1.rest]);
    let telling = |x: &&Natural| **x != Natural::ZERO && **x != Natural::ONE;
    let common = shared(above.filter(telling).cloned(), below.filter(telling).cloned());
    let mut state =
        State { primes: &primes, common, counts: vec![0; primes.len()], parts: [Natural::ONE, Natural::ONE] };
    // R starts at 1/1; the first quotient is a step that writes nothing down.
    let start = state.step(&[first.1, Split::nothing(), first.0]);
    let moves: Vec<[Moves; 2]> = split.iter().map(|step| state.step(step)).collect();
    let size: u64 = steps.iter().map(|s| s.given.iter().map(SignificantBits::significant_bits).sum::<u64>()).sum();
    let worth = size.saturating_mul(steps.len() as u64) >= THREAD_BITS;
    let side = |k: usize| follow(&start[k], moves.iter().map(|m| &m[k]));
    let (numerators, denominators) = both(worth, || side(0), || side(1));
    let written = numerators.into_iter().zip(denominators);
    written
        .map(|(n, d)| if n == Natural::ZERO { Fraction::from(Rational::ZERO) } else { Fraction::of_coprime(n, d) })
        .collect()
}

/// One side of all quotients.
fn follow<'a>(start: &Moves, moves: impl Iterator<Item = &'a Moves>) -> Vec<Natural> {
    let mut list = Vec::with_capacity(moves.size_hint().0 + 1);
    let mut long = start.next.applied(&Natural::ONE);
    for step in moves {
        list.push(step.written.applied(&long));
        long = step.next.applied(&long);
    }
    list.push(long);
    list
}

/// What a step does to a long number: it is divided, exactly, and then multiplied.
struct Move {
    divisors: Vec<Natural>,
    factor: Natural,
}

impl Move {
    fn applied(&self, x: &Natural) -> Natural {
        let Some((first, others)) = self.divisors.split_first() else { return x * &self.factor };
        let mut x = x.div_exact(first);
        for divisor in others {
            x.div_exact_assign(divisor);
        }
        x * &self.factor
    }
}

/// What a step does on one side: for what is written down, and for the next R.
struct Moves {
    written: Move,
    next: Move,
}

/// A product as powers of the small primes and the rest.
struct Split {
    /// The place of each prime and how often it goes in.
    powers: Vec<(usize, i64)>,
    rest: Natural,
}

impl Split {
    fn nothing() -> Split {
        Split { powers: Vec::new(), rest: Natural::ONE }
    }

    fn of<'a>(factors: impl IntoIterator<Item = &'a Natural>, primes: &[Prime]) -> Split {
        let mut split = Split::nothing();
        for factor in factors {
            if *factor == Natural::ZERO {
                return Split { powers: Vec::new(), rest: Natural::ZERO };
            }
            let rest = split.without(factor, primes);
            split.rest *= rest;
        }
        split.powers.sort_unstable();
        split
    }

    /// The factor without its small primes, which are noted.
    fn without(&mut self, factor: &Natural, primes: &[Prime]) -> Natural {
        let powers = &mut self.powers;
        if let Ok(word) = u64::try_from(factor) {
            return Natural::from(reduced(word, primes, powers, |p, x| p.divided_word(*x)));
        }
        if let Ok(pair) = u128::try_from(factor) {
            return Natural::from(reduced(pair, primes, powers, |p, x| p.divided(*x)));
        }
        reduced(factor.clone(), primes, powers, |p, x| {
            let p = Natural::from(p.value);
            (x % &p == Natural::ZERO).then(|| x.div_exact(p))
        })
    }
}

/// A number divided by every prime as often as it goes.
fn reduced<T>(
    mut x: T,
    primes: &[Prime],
    powers: &mut Vec<(usize, i64)>,
    divided: impl Fn(&Prime, &T) -> Option<T>,
) -> T {
    for (place, prime) in primes.iter().enumerate() {
        let mut times = 0;
        while let Some(rest) = divided(prime, &x) {
            x = rest;
            times += 1;
        }
        if times > 0 {
            powers.push((place, times));
        }
    }
    x
}

/// What is known of R: its powers of small primes, and the parts of its numerator and denominator that consist of primes
/// that rests may have in common.
struct State<'a> {
    primes: &'a [Prime],
    common: Natural,
    counts: Vec<i64>,
    parts: [Natural; 2],
}

impl State<'_> {
    /// What a step `[below, kept, given]` does to the numerator and to the denominator; R is then the next one.
    ///
    /// With R = N/D and a rest t below, `g = gcd(N, t)` leaves N/g and t/g without a common prime. A rest u above then
    /// loses `gcd(u, t/g)` and, with D, `h = gcd(D, u)`: what is left of `N·u/(D·t)` is in lowest terms.
    fn step(&mut self, [below, kept, given]: &[Split; 3]) -> [Moves; 2] {
        let parts = below.rest.clone();
        let from_above = self.gcd_with_part(0, &parts);
        let t = if from_above == Natural::ONE { parts } else { parts.div_exact(&from_above) };
        let (mut written, ..) = self.cancelled(&kept.rest, &t, &from_above);
        let (mut next, u, t) = self.cancelled(&given.rest, &t, &from_above);
        for (side, rest) in [u, t].iter().enumerate() {
            let (gone, part) = (next[side].divisors.first(), self.within_common(rest));
            let before = &self.parts[side];
            let left = gone.map_or_else(|| before.clone(), |gone| before.div_exact(gone));
            self.parts[side] = left * part;
        }
        self.primes_of(&kept.powers, &below.powers, &mut written);
        self.primes_of(&given.powers, &below.powers, &mut next);
        for (list, sign) in [(&given.powers, 1), (&below.powers, -1)] {
            for (place, times) in list {
                self.counts[*place] += sign * times;
            }
        }
        let ([a, b], [c, d]) = (written, next);
        [Moves { written: a, next: c }, Moves { written: b, next: d }]
    }

    /// The rests u above and t below without what they and D have in common, and what that does to both long numbers.
    fn cancelled(&self, u: &Natural, t: &Natural, from_above: &Natural) -> ([Move; 2], Natural, Natural) {
        let times = |x: Natural| Move { divisors: Vec::new(), factor: x };
        if *u == Natural::ZERO {
            return ([times(Natural::ZERO), times(Natural::ONE)], u.clone(), t.clone());
        }
        let (mut u, mut t) = (u.clone(), t.clone());
        let both = self.common_part(&u, &t);
        if both != Natural::ONE {
            u.div_exact_assign(&both);
            t.div_exact_assign(both);
        }
        let from_below = self.gcd_with_part(1, &u);
        if from_below != Natural::ONE {
            u.div_exact_assign(&from_below);
        }
        let divisors = |x: &Natural| if *x == Natural::ONE { Vec::new() } else { vec![x.clone()] };
        let moves = [
            Move { divisors: divisors(from_above), factor: u.clone() },
            Move { divisors: divisors(&from_below), factor: t.clone() },
        ];
        (moves, u, t)
    }

    /// `gcd(part, x)`, which is that of the whole numerator or denominator with x.
    fn gcd_with_part(&self, side: usize, x: &Natural) -> Natural {
        let part = &self.parts[side];
        if *part == Natural::ONE || *x == Natural::ONE { Natural::ONE } else { (part % x).gcd(x) }
    }

    /// `gcd(x, y)` of two rests.
    fn common_part(&self, x: &Natural, y: &Natural) -> Natural {
        if self.common == Natural::ONE || *x == Natural::ONE || *y == Natural::ONE {
            return Natural::ONE;
        }
        x.gcd(y)
    }

    /// The largest divisor of a rest that consists of primes which rests have in common.
    fn within_common(&self, x: &Natural) -> Natural {
        let (mut rest, mut all) = (x.clone(), Natural::ONE);
        while rest != Natural::ONE && self.common != Natural::ONE {
            let found = (&self.common % &rest).gcd(&rest);
            if found == Natural::ONE {
                break;
            }
            rest.div_exact_assign(&found);
            all *= found;
        }
        all
    }

    /// Adds the powers of small primes by which both sides change, from the counts before the step.
    fn primes_of(&self, above: &[(usize, i64)], below: &[(usize, i64)], moves: &mut [Move; 2]) {
        let (mut factors, mut divisors) =
            ([Packed::default(), Packed::default()], [Packed::default(), Packed::default()]);
        let mut all: Vec<(usize, i64)> = above.iter().copied().chain(below.iter().map(|(p, k)| (*p, -*k))).collect();
        all.sort_unstable();
        for same in all.chunk_by(|a, b| a.0 == b.0) {
            let Some((place, prime)) = same.first().and_then(|(p, _)| Some((*p, self.primes.get(*p)?))) else {
                continue;
            };
            let old = self.counts[place];
            let new = old + same.iter().map(|(_, times)| times).sum::<i64>();
            for side in 0..2 {
                let sign = if side == 0 { 1 } else { -1 };
                let change = (sign * new).max(0) - (sign * old).max(0);
                let list = if change > 0 { &mut factors[side] } else { &mut divisors[side] };
                list.multiply(prime.value, change.unsigned_abs());
            }
        }
        for (side, (factors, divisors)) in factors.into_iter().zip(divisors).enumerate() {
            let words = factors.words();
            moves[side].factor *= product(&words);
            moves[side].divisors.extend(divisors.words());
        }
    }
}

/// A product of powers in as few words as hold it.
#[derive(Default)]
struct Packed {
    full: Vec<Natural>,
    last: Option<u64>,
}

impl Packed {
    fn multiply(&mut self, prime: u64, times: u64) {
        // A power that alone fills a word is kept as it is.
        let power = u32::try_from(times).ok().and_then(|times| prime.checked_pow(times));
        match (power, self.last) {
            (Some(1), _) => {}
            (Some(power), None) => self.last = Some(power),
            (Some(power), Some(last)) => match last.checked_mul(power) {
                Some(both) => self.last = Some(both),
                None => {
                    self.full.push(Natural::from(last));
                    self.last = Some(power);
                }
            },
            (None, _) => self.full.push(Natural::from(prime).pow(times)),
        }
    }

    fn words(mut self) -> Vec<Natural> {
        self.full.extend(self.last.map(Natural::from));
        self.full
    }
}

#[cfg(test)]
mod tests {
    use super::{Step, quotients};
    use malachite::base::num::basic::traits::{One, Zero};
    use malachite::{Natural, Rational};
    use proptest::prelude::*;

    /// The definition, in malachite's rationals.
    fn plain(above: &Natural, below: &Natural, steps: &[Step]) -> Vec<Rational> {
        let over = |list: &[Natural]| Rational::from(list.iter().fold(Natural::ONE, |all, f| all * f));
        let mut r = Rational::from_naturals_ref(above, below);
        let mut list = Vec::new();
        for step in steps {
            list.push(&r * Rational::from(&step.kept) / over(&step.below));
            r = &r * over(&step.given) / over(&step.below);
        }
        list.push(r);
        list
    }

    fn check(above: &Natural, below: &Natural, steps: &[Step]) -> Result<(), TestCaseError> {
        let found = quotients(above.clone(), below.clone(), steps);
        let expected = plain(above, below, steps);
        prop_assert_eq!(found.len(), expected.len());
        for (x, y) in found.iter().zip(&expected) {
            prop_assert_eq!(x.numerator(), y.numerator_ref());
            prop_assert_eq!(x.denominator(), y.denominator_ref());
        }
        Ok(())
    }

    /// Factors that share small primes, large primes and their powers, of one word, two and more.
    fn factor() -> impl Strategy<Value = Natural> {
        let prime = || prop::sample::select(vec![1_u64, 1, 2, 3, 12, 1031, 1033, 65_537, 2_147_483_647]);
        (prime(), prime(), prime(), prime(), prop::bool::weighted(0.1)).prop_map(|(p, q, r, s, long)| {
            let all = Natural::from(p) * Natural::from(q) * Natural::from(r) * Natural::from(s);
            if long { &all * &all * Natural::from(u64::MAX) } else { all }
        })
    }

    fn step() -> impl Strategy<Value = Step> {
        let kept = prop_oneof![9 => factor(), 1 => Just(Natural::ZERO)];
        (prop::collection::vec(factor(), 1..3), kept, prop::collection::vec(factor(), 1..4))
            .prop_map(|(below, kept, given)| Step { below, kept, given })
    }

    proptest! {
        #[test]
        fn running_quotients_are_those_of_rationals_in_lowest_terms(
            above in factor(),
            below in factor(),
            steps in prop::collection::vec(step(), 0..60),
        ) {
            check(&above, &below, &steps)?;
        }

        #[test]
        fn random_words_make_the_same_quotients(words in prop::collection::vec(any::<[u64; 5]>(), 1..80)) {
            let steps: Vec<Step> = words
                .iter()
                .map(|w| {
                    let [a, b, c, d, e] = w.map(|w| Natural::from(w >> 24 | 1));
                    Step { below: vec![&a * &d + &b * &c, e.clone()], kept: &b * &c, given: vec![a, d, e + b] }
                })
                .collect();
            check(&Natural::from(7u32), &Natural::ONE, &steps)?;
        }
    }

    #[test]
    fn two_threads_make_the_same_quotients() -> Result<(), TestCaseError> {
        // 500 steps of words from a linear congruence: 50,000 bits at the end, with many small primes.
        let mut state = 1_u64;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            Natural::from((state >> 32) | 1)
        };
        let steps: Vec<Step> = (0..500)
            .map(|_| Step {
                below: vec![next() * next(), next()],
                kept: next() * next(),
                given: vec![next(), next(), next()],
            })
            .collect();
        check(&Natural::ONE, &Natural::from(3u32), &steps)
    }
}
