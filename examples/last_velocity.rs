//! The exact velocity of the last body of a long random chain, timed: `cargo run --release --example last_velocity [BODIES…]`
//!
//! Masses and coefficients of restitution are quotients of 32-bit numbers from a generator that any other program can
//! repeat: `x <- x·6364136223846793005 + 1442695040888963407 mod 2^64`, from 1, of which the upper 32 bits are taken, with the
//! lowest of them set. Each mass takes two numbers (`p/q`), each coefficient two (the lesser over the greater). Prints the
//! bodies, the seconds, the bits of numerator and denominator, and both modulo 2^61 − 1. With `all` as the first argument the
//! velocities of all bodies are found, and those of the last one are shown.
#![allow(clippy::unwrap_used)] // an example stops where its own input is wrong

use carom::chain::pass::Pass;
use carom::chain::{Positive, Restitution, Restitutions};
use malachite::base::num::basic::traits::One;
use malachite::base::num::logic::traits::SignificantBits;
use malachite::{Natural, Rational};
use std::time::Instant;

/// The generator.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        self.0 >> 32 | 1
    }
}

fn chain(bodies: usize) -> Pass {
    let mut numbers = Numbers(1);
    let mut masses = Vec::with_capacity(bodies);
    let mut restitutions = Vec::with_capacity(bodies);
    for body in 0..bodies {
        let (p, q) = (numbers.next(), numbers.next());
        masses.push(Positive::new(Rational::from_unsigneds(p, q)).unwrap());
        if body + 1 < bodies {
            let (a, b) = (numbers.next(), numbers.next());
            restitutions.push(Restitution::new(Rational::from_unsigneds(a.min(b), a.max(b))).unwrap());
        }
    }
    Pass::from_rest(masses, Restitutions::Each(restitutions), Rational::ONE).unwrap()
}

fn main() {
    let mut arguments: Vec<String> = std::env::args().skip(1).collect();
    let all = arguments.first().is_some_and(|first| first == "all");
    if all {
        arguments.remove(0);
    }
    if arguments.is_empty() {
        arguments = ["100", "1000", "10000", "100000"].map(str::to_owned).to_vec();
    }
    let modulus = Natural::from((1u64 << 61) - 1);
    for bodies in arguments {
        let pass = chain(bodies.parse().unwrap());
        let started = Instant::now();
        let last =
            if all { pass.velocities_from_rest().unwrap().pop().unwrap() } else { pass.last_velocity().unwrap() };
        let spent = started.elapsed().as_secs_f64();
        let (above, below) = (last.numerator(), last.denominator());
        let (p, q) = (above % &modulus, below % &modulus);
        println!("{bodies} {spent:.6} {} {} {p} {q}", above.significant_bits(), below.significant_bits());
    }
}
