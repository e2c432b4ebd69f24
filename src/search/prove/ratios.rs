//! Sequences whose members fall at least by half from some place on, such as 2^n/n!: they lie between 0 and c·(1/2)^n.
//!
//! Method: the place and c are found by evaluation, and the bound is shown by induction.
//!
//! Limits: [`MEMBERS`].

use super::letters::{natural, product};
use super::{Fail, Prover};
use crate::certificate::Label;
use crate::claim::syntax::*;
use crate::kernel::statement::{name, numeral, power};
use crate::refute::evaluate::Assignment;
use crate::refute::literal::literal;
use crate::refute::number::Number;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::{Ceiling, Pow};
use malachite::base::num::basic::traits::Zero;

/// How many members are looked at.
const MEMBERS: u64 = 24;

impl Prover {
    /// Shows that members tend to 0 because each is at most half of the one before.
    pub(super) fn by_ratios(&mut self, goal: &Prop, l: &Limit) -> Result<Label, Fail> {
        let no = || Fail::No("members that fall by half");
        let x = &l.variable.text;
        if natural(&l.value) != Some(0) || !self.naturals.iter().any(|n| n == x) {
            return Err(no());
        }
        let member = |n: u64| {
            let mut at = Assignment::default();
            at.give(x, Number::Exact(Rational::from(n)));
            match at.number(&l.of) {
                Ok(Number::Exact(q)) => Some(q),
                _ => None,
            }
        };
        let members: Vec<Rational> = (1..=MEMBERS).map(member).collect::<Option<_>>().ok_or_else(no)?;
        let falls = |pair: &[Rational]| pair[1] > Rational::ZERO && &pair[1] * Rational::from(2) <= pair[0];
        let rises = members.windows(2).rposition(|pair| !falls(pair)).map_or(0, |place| place + 1);
        // Some that fall have to be seen.
        if rises + 4 > members.len() {
            return Err(no());
        }
        let least = u32::try_from(rises + 1).map_err(|_| no())?;
        let c = &members[rises] * Rational::from(2).pow(u64::from(least));
        let c = literal(&Rational::from(Ceiling::ceiling(c)));
        let half = literal(&Rational::from_unsigneds(1u32, 2));
        let upper = product(vec![c, power(&half, &name(x))]);
        self.between_by(goal, l, (&numeral(0), &upper), &[], least, 0)
    }
}
