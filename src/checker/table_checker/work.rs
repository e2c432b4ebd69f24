//! How much the check of one table may cost.
//!
//! Contract: the work that is counted is bounded by a constant and a multiple of the bytes read, so that no file is
//! checked for longer than its length explains. Every operation on numbers that may be long is counted before it is
//! done, by the lengths of its operands; what is linear in the line is not counted.

use super::failure::{Failure, declined};
use std::cell::Cell;

/// The work that any table may cost, in products of two words of 64 bits.
pub(crate) const WORK_LIMIT: u64 = 4_000_000_000;
/// The further work for each byte of the file.
const WORK_PER_BYTE: u64 = 2_000;
/// Products of longer numbers, in words, are cheaper than the product of their lengths.
const SHORT: u64 = 32;
/// What a common divisor costs, in squares of the length: each bit takes a subtraction and a shift.
const DIVISOR: u64 = 128;

/// Counts work. A cell, so that what only reads the state of a check counts as well.
#[derive(Clone, Debug, Default)]
pub(crate) struct Work {
    spent: Cell<u64>,
    read: Cell<u64>,
}

/// The length of a number in words.
fn words(bits: u64) -> u64 {
    bits / 64 + 1
}

impl Work {
    /// So many bytes were read.
    pub(crate) fn read(&self, bytes: usize) {
        self.read.set(self.read.get().saturating_add(u64::try_from(bytes).unwrap_or(u64::MAX)));
    }

    /// Counts an amount.
    fn count(&self, amount: u64) -> Result<(), Failure> {
        self.spent.set(self.spent.get().saturating_add(amount));
        let allowed = WORK_LIMIT.saturating_add(WORK_PER_BYTE.saturating_mul(self.read.get()));
        if self.spent.get() > allowed { declined("work for the whole table") } else { Ok(()) }
    }

    /// A product of numbers of so many bits: three products of half the length instead of four, down to `SHORT`.
    pub(crate) fn product(&self, a: u64, b: u64) -> Result<(), Failure> {
        let (short, long) = (words(a.min(b)), words(a.max(b)));
        let halvings = (short / SHORT).checked_ilog2().unwrap_or(0);
        let square = short.saturating_mul(short).saturating_mul(3u64.saturating_pow(halvings)) >> (2 * halvings);
        self.count((square / short).saturating_mul(long).max(1))
    }

    /// A quotient of so many bits by a divisor of so many, or the digits of a number: by the school's method.
    pub(crate) fn quotient(&self, quotient: u64, divisor: u64) -> Result<(), Failure> {
        self.count(words(quotient).saturating_mul(words(divisor)))
    }

    /// The lowest terms of a fraction whose numerator and denominator have so many bits.
    pub(crate) fn reduction(&self, bits: u64) -> Result<(), Failure> {
        self.count(words(bits).saturating_mul(words(bits)).saturating_mul(DIVISOR))
    }
}
