//! Energy and momentum, booked collision by collision.
//!
//! Contract: [`Ledger::book`] checks one collision exactly: two bodies keep their momentum, and the kinetic
//! energy that is lost is `m_l·m_r·(1−e²)·(v_l−v_r)²/(2(m_l+m_r))` (Ricardo & Lee 2015, P-loss); at a wall it is
//! `m·(1−e²)·v²/2`. A collision that breaks either is a fault of this program, [`LedgerFault`]. At the end the
//! sums are held against the states before and after.
//!
//! Cost: sums are kept in a binary counter, so that adding `k` numbers whose sizes grow costs
//! `O(log k)` additions of full size and the memory of `log k` numbers.

use super::line::{Line, Pair, Point};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Square;
use malachite::base::num::basic::traits::{One, Two, Zero};

/// A collision broke a law of conservation: a fault of this program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LedgerFault {
    /// The law.
    pub law: &'static str,
    /// The collision, from 1; `None` for the balance at the end.
    pub collision: Option<u64>,
}

/// A sum as a binary counter: part `i` holds the sum of `2^i` numbers.
#[derive(Clone, Debug, Default)]
pub(super) struct Sum {
    parts: Vec<Option<Rational>>,
}

impl Sum {
    pub(super) fn add(&mut self, mut x: Rational) {
        if x == Rational::ZERO {
            return;
        }
        for part in &mut self.parts {
            match part.take() {
                None => {
                    *part = Some(x);
                    return;
                }
                Some(y) => x += y,
            }
        }
        self.parts.push(Some(x));
    }

    pub(super) fn total(&self) -> Rational {
        self.parts.iter().flatten().fold(Rational::ZERO, |a, b| a + b)
    }
}

/// Losses of energy and what the walls gave.
#[derive(Clone, Debug, Default)]
pub(super) struct Ledger {
    lost: Sum,
    impulse: Sum,
}

impl Ledger {
    /// Checks a collision and books it; returns the energy that it cost.
    pub(crate) fn book(
        &mut self,
        sides: (&Point, &Point),
        pair: &Pair,
        before: (&Rational, &Rational),
        after: (&Rational, &Rational),
        number: u64,
    ) -> Result<Rational, LedgerFault> {
        let fault = |law| LedgerFault { law, collision: Some(number) };
        let speed = before.0 - before.1;
        let rest = Rational::ONE - (&pair.restitution).square();
        let (mut gained, mut given) = (Rational::ZERO, Rational::ZERO);
        for (side, v, w) in [(sides.0, before.0, after.0), (sides.1, before.1, after.1)] {
            match &side.mass {
                Some(m) => {
                    gained += m * (w.square() - v.square());
                    given += m * (w - v);
                }
                None if v != w => return Err(fault("a wall stands still")),
                None => {}
            }
        }
        let expected = match (&sides.0.mass, &sides.1.mass) {
            (Some(l), Some(r)) => {
                if given != Rational::ZERO {
                    return Err(fault("momentum"));
                }
                l * r / (l + r)
            }
            (Some(m), None) | (None, Some(m)) => {
                self.impulse.add(given);
                m.clone()
            }
            (None, None) => Rational::ZERO,
        };
        if gained != -(&expected * &rest * speed.square()) {
            return Err(fault("energy"));
        }
        let lost = -gained / Rational::TWO;
        self.lost.add(lost.clone());
        Ok(lost)
    }

    /// Checks that points that came together kept their momentum, unless a wall is among them, and gained no energy;
    /// returns the energy that it cost.
    pub(crate) fn book_joined(
        &mut self,
        points: &[Point],
        before: &[Rational],
        after: &Rational,
        number: u64,
    ) -> Result<Rational, LedgerFault> {
        let fault = |law| LedgerFault { law, collision: Some(number) };
        let (mut lost, mut given, mut wall) = (Rational::ZERO, Rational::ZERO, false);
        for (point, v) in points.iter().zip(before) {
            match &point.mass {
                Some(m) => {
                    lost += m * (v.square() - after.square());
                    given += m * (after - v);
                }
                None => wall = true,
            }
        }
        if wall && *after != Rational::ZERO {
            return Err(fault("a wall stands still"));
        }
        if !wall && given != Rational::ZERO {
            return Err(fault("momentum"));
        }
        if lost < Rational::ZERO {
            return Err(fault("energy"));
        }
        self.impulse.add(given);
        let lost = lost / Rational::TWO;
        self.lost.add(lost.clone());
        Ok(lost)
    }

    /// Holds the sums of all collisions against the states: energy before = energy after + lost, momentum after =
    /// momentum before + what the walls gave.
    pub(super) fn balance(&self, line: &Line, v: &[Rational]) -> Result<(), LedgerFault> {
        let start: Vec<Rational> = line.points.iter().map(|p| p.velocity.clone()).collect();
        if energy(line, &start) != energy(line, v) + self.lost.total() {
            return Err(LedgerFault { law: "energy", collision: None });
        }
        if momentum(line, &start) + self.impulse.total() != momentum(line, v) {
            return Err(LedgerFault { law: "momentum", collision: None });
        }
        Ok(())
    }
}

/// The kinetic energy of all bodies.
pub(super) fn energy(line: &Line, v: &[Rational]) -> Rational {
    let mut sum = Sum::default();
    for (point, v) in line.points.iter().zip(v) {
        if let Some(m) = &point.mass {
            sum.add(m * v.square());
        }
    }
    sum.total() / Rational::TWO
}

/// The momentum of all bodies.
pub(super) fn momentum(line: &Line, v: &[Rational]) -> Rational {
    let mut sum = Sum::default();
    for (point, v) in line.points.iter().zip(v) {
        if let Some(m) = &point.mass {
            sum.add(m * v);
        }
    }
    sum.total()
}
