//! Goals about an angle that is bounded by multiples of π: quarter turn by quarter turn.
//!
//! Method: on each quarter of the range the signs of sine and cosine are known, and both rise or fall. There the goal is shown
//! by the angles (`angles`), or the facts contradict each other.

use super::angles::may_be_an_angle;
use super::arcs::quarter_turn;
use super::facts::{minus, opposite, scaled};
use super::{Fail, Prover, implies};
use crate::certificate::{Label, Rule};
use crate::claim::syntax::*;
use crate::kernel::statement::{apply, compare, expr, name, numeral, sum};
use malachite::base::num::arithmetic::traits::{Ceiling, Floor};

/// The longest range that is cut, in quarters of a turn: two turns.
const QUARTERS: i64 = 8;

impl Prover {
    /// Shows a comparison or a disjunction of equations of angles, at once or in each quarter of a turn.
    pub(super) fn by_quarters(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("an angle in a range");
        if self.within_arcs || self.splits >= 8 {
            return Err(no());
        }
        // The sides are defined already; the facts about them are added only where angles are compared.
        let mut names = std::collections::BTreeSet::new();
        crate::kernel::names::names_in_prop(goal, &mut names);
        let angles: Vec<String> = self.angles().into_iter().filter(|n| names.contains(n)).collect();
        if angles.is_empty() {
            return Err(no());
        }
        let mut sides = Vec::new();
        super::goals::sides_in(goal, &mut sides);
        self.enrich(&sides.iter().collect::<Vec<_>>());
        let letters = self.letters_in(&sides.iter().collect::<Vec<_>>());
        if !letters.iter().all(may_be_an_angle) || !self.speaks_of_turns(&letters) {
            return Err(no());
        }
        if let PropKind::Or(parts) = &goal.kind
            && let Ok(label) = self.attempt(|c| c.one_of_angles(goal, parts))
        {
            return Ok(label);
        }
        for angle in angles {
            let Some((from, to)) = self.quarters(&angle) else { continue };
            if (2..=QUARTERS).contains(&(to - from)) {
                let angle = name(&angle);
                return self.attempt(|c| {
                    c.splits += 1;
                    let label = c.in_quarters(goal, &angle, from, to)?;
                    c.splits -= 1;
                    Ok(label)
                });
            }
        }
        Err(no())
    }

    /// The range of an angle in quarters of a turn, by its bounds among the facts.
    fn quarters(&mut self, angle: &str) -> Option<(i64, i64)> {
        let (mut from, mut to) = (None, None);
        let quarter = quarter_turn(1);
        for place in self.places(angle) {
            let parts = expr(ExprKind::Product(vec![(Factor::Times, place.clone()), (Factor::Over, quarter.clone())]));
            let Some(turns) = self.read(&parts, false).filter(|r| r.factors.is_empty()) else { continue };
            let (below, above) = (whole(&turns.number.clone().floor())?, whole(&turns.number.ceiling())?);
            if from.is_none_or(|k| k < below) && self.is_beside(angle, below, Relation::GreaterEqual) {
                from = Some(below);
            }
            if to.is_none_or(|k| k > above) && self.is_beside(angle, above, Relation::LessEqual) {
                to = Some(above);
            }
        }
        Some((from?, to?))
    }

    fn is_beside(&mut self, angle: &str, quarters: i64, relation: Relation) -> bool {
        let (angle, place) = (name(angle), quarter_turn(quarters));
        let length = if relation == Relation::LessEqual { minus(&place, &angle) } else { minus(&angle, &place) };
        self.are_lengths(&[length], Relation::GreaterEqual)
    }

    /// The goal on a range of an angle: on its first quarter, and on the rest.
    fn in_quarters(&mut self, goal: &Prop, angle: &Expr, from: i64, to: i64) -> Result<Label, Fail> {
        if to - from <= 1 {
            return self.in_quarter(goal, angle, from);
        }
        let first = compare(angle.clone(), Relation::LessEqual, quarter_turn(from + 1));
        let rest = opposite(&first).ok_or(Fail::No("an opposite"))?;
        let below = self.block(&implies(&first, goal), |c, _| c.in_quarter(goal, angle, from))?;
        let above = self.block(&implies(&rest, goal), |c, _| c.in_quarters(goal, angle, from + 1, to))?;
        self.logic(&[&below, &above], goal)
    }

    /// The goal on a quarter of a turn.
    fn in_quarter(&mut self, goal: &Prop, angle: &Expr, from: i64) -> Result<Label, Fail> {
        for f in ["cos", "sin"] {
            let e = apply(f, angle.clone());
            let orders = [Relation::Greater, Relation::Less, Relation::GreaterEqual, Relation::LessEqual];
            // Said of cosine and sine as they are, for an equation put in may stand for them.
            let seen = orders.into_iter().any(|r| {
                let sign = compare(e.clone(), r, numeral(0));
                self.known(&sign).is_some() || self.combination(sign, Vec::new()).is_ok()
            });
            if !seen {
                let _ = orders.into_iter().any(|r| {
                    let sign = compare(e.clone(), r, numeral(0));
                    self.attempt(|c| c.sign_beyond_half_a_turn(&sign, angle, from)).is_ok()
                });
            }
        }
        if let Ok(label) = self.attempt(|c| c.absurd(0, goal, None)) {
            return Ok(label);
        }
        let shown = match &goal.kind {
            PropKind::Or(parts) => self.attempt(|c| c.one_of_angles(goal, parts)),
            _ => self.attempt(|c| c.by_linear_facts(goal)).or_else(|_| self.by_angles(goal)),
        };
        shown.or_else(|_| self.refuted(goal))
    }

    /// The sign of a cosine or sine where the kernel does not know it by the argument: by a name for the argument less quarter turns.
    /// Its block ends with the name.
    fn sign_beyond_half_a_turn(&mut self, sign: &Prop, angle: &Expr, from: i64) -> Result<(), Fail> {
        let beside = compare(angle.clone(), Relation::GreaterEqual, quarter_turn(from));
        let known = self.by_linear_facts(&beside)?;
        let block = self.block(&implies(&beside, sign), |c, _| {
            let rest = name(&c.fresh("r"));
            let less = minus(angle, &quarter_turn(from));
            let named = c.emit(Rule::Name, compare(less, Relation::Equal, rest.clone()))?;
            let whole = sum(vec![(Sign::Plus, rest), (Sign::Plus, quarter_turn(from))]);
            let equation = compare(angle.clone(), Relation::Equal, whole);
            let equation = c.combination(equation, vec![scaled(&named, numeral(1))])?;
            let equations = std::mem::replace(&mut c.equations, vec![equation]);
            let shown = c.combination(sign.clone(), Vec::new());
            c.equations = equations;
            shown
        })?;
        let label = self.logic(&[&block, &known], sign)?;
        self.take_in(&label, sign)
    }
}

/// A whole number of few digits.
fn whole(k: &malachite::Integer) -> Option<i64> {
    i64::try_from(k).ok().filter(|k| k.abs() <= QUARTERS)
}
