//! Numbers and choices made simpler, one number at a time.

use super::search::{Choice, Members};
use malachite::base::num::arithmetic::traits::{Ceiling, DivisibleBy, Floor};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::logic::traits::SignificantBits;
use malachite::{Natural, Rational};

const TEN: Natural = Natural::const_from(10);

/// The most powers of ten that a number is rounded to.
const DIGITS: usize = 40;

/// How much there is to read in a number.
fn length(q: &Rational) -> u64 {
    let size = |n: &Natural| {
        // Zeros at its end are read at a glance.
        let (mut rest, mut zeros) = (n.clone(), 0);
        while rest > 9u32 && (&rest).divisible_by(&TEN) {
            rest /= TEN;
            zeros += 1;
        }
        rest.significant_bits() + 3 * zeros
    };
    let bits = size(q.numerator_ref()) + 2 * size(q.denominator_ref());
    4 * bits + 2 * u64::from(*q < 0) + u64::from(*q == 0)
}

/// Numbers that are shorter than this one, the shortest first.
fn shorter(q: &Rational) -> Vec<Rational> {
    let simple =
        [(1, 1), (2, 1), (1, 2), (0, 1), (3, 1), (4, 1), (1, 4), (1, 3), (3, 2), (3, 4), (9, 1), (8, 1), (9, 10)];
    let mut list: Vec<Rational> = simple.iter().map(|(p, q)| Rational::from_signeds(*p, *q)).collect();
    list.extend([-1, -2].map(Rational::from));
    let parts = [(1, 1), (1, 2), (3, 4)].map(|(p, d)| q * Rational::from_signeds(p, d));
    list.extend(parts.iter().flat_map(|part| [Rational::from(part.floor()), Rational::from(part.ceiling())]));
    list.extend(rounded(q));
    list.extend(convergents(q));
    list.retain(|other| length(other) < length(q));
    list.sort_by_cached_key(length);
    list.dedup();
    list
}

/// Powers of ten, and numbers of one or two digits before zeros, on the side of 0 and 1 on which a large or small number lies.
fn rounded(q: &Rational) -> Vec<Rational> {
    if *q < 0 {
        return rounded(&-q).into_iter().map(|rounded| -rounded).collect();
    }
    if *q != 0 && *q < 1 {
        return rounded(&(Rational::ONE / q)).into_iter().map(|rounded| Rational::ONE / rounded).collect();
    }
    let ten = Rational::from(10);
    let mut powers: Vec<Rational> = Vec::new();
    let mut power = ten.clone();
    while power <= *q && powers.len() < DIGITS {
        powers.push(power.clone());
        power *= &ten;
    }
    let places: Vec<Rational> = powers.iter().rev().take(2).cloned().collect();
    let near = places.iter().flat_map(|place| {
        let count = q / place;
        [(&count).floor(), count.ceiling()].map(|count| Rational::from(count) * place)
    });
    powers.iter().cloned().chain(near).collect()
}

/// The convergents of the continued fraction of a number.
fn convergents(q: &Rational) -> Vec<Rational> {
    let mut list = Vec::new();
    let (mut before, mut last) = ((Rational::ZERO, Rational::ONE), (Rational::ONE, Rational::ZERO));
    let mut rest = q.clone();
    for _ in 0..64 {
        let whole = Rational::from((&rest).floor());
        let next = (&whole * &last.0 + before.0, &whole * &last.1 + before.1);
        (before, last) = (last, next);
        if last.1 != 0 {
            list.push(&last.0 / &last.1);
        }
        rest -= whole;
        if rest == 0 {
            break;
        }
        rest = Rational::ONE / rest;
    }
    list
}

/// The choices in which one number, or the list of a family, is shorter.
pub(crate) fn simpler(choice: &Choice) -> Vec<Choice> {
    let mut out = Vec::new();
    for (place, value) in choice.scalars.iter().enumerate() {
        let others = choice.scalars.iter().filter(|other| length(other) < length(value)).cloned();
        for shorter in shorter(value).into_iter().chain(others) {
            let mut next = choice.clone();
            next.scalars[place] = shorter;
            out.push(next);
        }
    }
    for (place, members) in choice.families.iter().enumerate() {
        let mut with = |members: Members| {
            let mut next = choice.clone();
            next.families[place] = members;
            out.push(next);
        };
        match members {
            Members::Geometric(first, ratio) => {
                with(Members::InTurn(vec![first.clone()]));
                shorter(first).into_iter().for_each(|first| with(Members::Geometric(first, ratio.clone())));
                shorter(ratio).into_iter().filter(|r| *r > 0).for_each(|r| with(Members::Geometric(first.clone(), r)));
            }
            Members::InTurn(list) => {
                for shorter in 1..list.len() {
                    with(Members::InTurn(list[..shorter].to_vec()));
                }
                for (member, value) in list.iter().enumerate() {
                    for shorter in shorter(value) {
                        let mut list = list.clone();
                        list[member] = shorter;
                        with(Members::InTurn(list));
                    }
                }
            }
        }
    }
    out
}
