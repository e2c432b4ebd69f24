//! Sets of signs, and how they multiply, add and turn round.

use crate::claim::syntax::Relation;
use num_rational::BigRational;
use num_traits::{Signed, Zero};

/// A set of possible signs: negative 1, zero 2, positive 4.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Signs(u8);

impl Signs {
    /// Only zero.
    pub const ZERO: Signs = Signs(2);
    /// Only positive.
    pub const POSITIVE: Signs = Signs(4);
    /// Not negative.
    pub const NOT_NEGATIVE: Signs = Signs(6);
    /// Not zero.
    pub const NOT_ZERO: Signs = Signs(5);
    /// Nothing known.
    pub const ANY: Signs = Signs(7);

    /// The signs of a − b that `a relation b` allows.
    pub fn of(relation: Relation) -> Signs {
        match relation {
            Relation::Equal => Signs(2),
            Relation::NotEqual => Signs(5),
            Relation::Less => Signs(1),
            Relation::LessEqual => Signs(3),
            Relation::Greater => Signs(4),
            Relation::GreaterEqual => Signs(6),
        }
    }

    /// The sign of a number.
    pub fn of_number(q: &BigRational) -> Signs {
        if q.is_zero() {
            Signs(2)
        } else if q.is_negative() {
            Signs(1)
        } else {
            Signs(4)
        }
    }

    /// The narrowest relation to 0 that says of a number no less than these signs, if any does.
    pub fn relation(self) -> Option<Relation> {
        [
            Relation::Equal,
            Relation::Greater,
            Relation::Less,
            Relation::GreaterEqual,
            Relation::LessEqual,
            Relation::NotEqual,
        ]
        .into_iter()
        .find(|relation| self.within(Signs::of(*relation)))
    }

    /// Whether every sign here is in the other set.
    pub fn within(self, other: Signs) -> bool {
        self.0 & !other.0 == 0
    }

    /// Whether only one is possible.
    pub fn is_single(self) -> bool {
        self.0.count_ones() <= 1
    }

    /// The signs in both.
    pub fn and(self, other: Signs) -> Signs {
        Signs(self.0 & other.0)
    }

    /// The signs in either.
    pub fn or(self, other: Signs) -> Signs {
        Signs(self.0 | other.0)
    }

    /// The signs that are not here.
    pub fn others(self) -> Signs {
        Signs(7 & !self.0)
    }

    /// The signs of the opposite.
    pub fn turned(self) -> Signs {
        Signs((self.0 & 1) << 2 | self.0 & 2 | (self.0 & 4) >> 2)
    }

    fn has(self, sign: i8) -> bool {
        self.0 & (1 << (sign + 1)) != 0
    }

    fn pairs(self, other: Signs, mut result: impl FnMut(i8, i8) -> u8) -> Signs {
        let mut out = 0;
        for a in [-1i8, 0, 1] {
            for b in [-1i8, 0, 1] {
                if self.has(a) && other.has(b) {
                    out |= result(a, b);
                }
            }
        }
        Signs(out)
    }

    /// The signs of products.
    pub fn times(self, other: Signs) -> Signs {
        self.pairs(other, |a, b| 1 << (a * b + 1))
    }

    /// The signs of sums.
    pub fn plus(self, other: Signs) -> Signs {
        self.pairs(other, |a, b| if a * b < 0 { 7 } else { 1 << ((a + b).signum() + 1) })
    }

    /// The signs of a whole power that has a value.
    pub fn power(self, k: i64) -> Signs {
        let signs = match k {
            0 => Signs(4),
            _ if k % 2 == 0 => Signs((self.0 & 2) | if self.0 & 5 != 0 { 4 } else { 0 }),
            _ => self,
        };
        if k < 0 { signs.and(Signs::NOT_ZERO) } else { signs }
    }
}
