//! Comparisons of two products with roots, neither of which is negative, by their powers: x²·sqrt(a² − x²) <= 2·a³/(3·sqrt(3)) by
//! x⁴·(a² − x²) <= 4·a⁶/27.
//!
//! Method: for P, Q >= 0 that are not both 0, P − Q has the sign of P^k − Q^k = (P − Q)·(P^(k − 1) + P^(k − 2)·Q + … + Q^(k − 1)). The k is
//! the least number for which both powers are free of roots.
//!
//! Certificate: the powers without roots, their comparison, and a combination with that sum as its multiplier.

use super::comparison::single;
use super::facts::minus;
use super::letters::{product, total, whole_power};
use super::squares::{Open, own_relation};
use super::{Fail, Prover};
use crate::algebra::Monomial;
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use crate::kernel::statement::compare;
use crate::refute::literal::literal;
use malachite::Rational;

/// The largest k.
const POWER: i64 = 6;

/// A product of letters, one of the two sides.
struct Side {
    /// As it is written.
    own: Expr,
    /// Its power without roots.
    power: Expr,
}

impl Prover {
    /// Shows a comparison of two products with roots from that of their powers.
    pub(super) fn by_powers_of_sides(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let (a, relation, b) = single(goal)?;
        let no = || Fail::No("two products with roots");
        let reading = self.read(&minus(a, b), true).ok_or_else(no)?;
        let open = Open::of(self, &reading).ok_or_else(no)?;
        let own = own_relation(open.signs, relation).ok_or_else(no)?;
        let terms: Vec<(Monomial, Rational)> = open.poly.terms().map(|(m, c)| (m.clone(), c.clone())).collect();
        let [first, second] = terms.as_slice() else { return Err(no()) };
        let (above, below, own) = match (first.1 > 0, second.1 > 0) {
            (true, false) => (first, second, own),
            (false, true) => (second, first, own),
            _ => return Err(no()),
        };
        let k = [above, below].into_iter().flat_map(|t| t.0.powers()).try_fold(1, |k, (letter, power)| {
            let e = self.letters.expr(*letter).cloned()?;
            let degree = self.degree(&e).unwrap_or(1);
            // The least multiple of k for which degree divides power·k.
            (1..=POWER).map(|m| m * k).find(|k| i64::from(*power) * k % degree == 0).filter(|k| *k <= POWER)
        });
        let k = k.filter(|k| *k > 1).ok_or_else(no)?;
        let above = self.product_and_power(&above.0, &above.1, k).ok_or_else(no)?;
        let below = self.product_and_power(&below.0, &-below.1.clone(), k).ok_or_else(no)?;
        let labels = [&above, &below].map(|side| {
            let shown = compare(whole_power(side.own.clone(), k), Relation::Equal, side.power.clone());
            self.plainly(Rule::Power, &shown).or_else(|_| self.quietly(&shown))
        });
        let [one, two] = labels;
        let (one, two) = (one?, two?);
        let powers = self.without_roots(&compare(above.power.clone(), own, below.power.clone()))?;
        let sum = (0..k).map(|j| {
            let parts = [(&above, k - 1 - j), (&below, j)].into_iter().filter(|p| p.1 > 0);
            (Sign::Plus, product(parts.map(|(side, k)| whole_power(side.own.clone(), k)).collect()))
        });
        let sum = total(sum.collect());
        let term = |label: Label, factor: i64| Term { facts: vec![label], factor: literal(&Rational::from(factor)) };
        let terms = vec![term(powers, 1), term(one, 1), term(two, -1)];
        let shown = compare(above.own, own, below.own);
        let shown = self.emit(Rule::Combination { times: Some(sum), terms }, shown)?;
        self.combination(goal.clone(), vec![Term { facts: vec![shown], factor: product(open.rest) }])
    }

    /// A product of letters with a positive number before it, if it is not negative.
    fn product_and_power(&mut self, monomial: &Monomial, number: &Rational, k: i64) -> Option<Side> {
        let (mut own, mut power) = (Vec::new(), Vec::new());
        if *number != 1 || monomial.is_one() {
            own.push(literal(number));
            power.push(literal(&super::facts::power_of(number, k)));
        }
        for (letter, exponent) in monomial.powers() {
            let e = self.letters.expr(*letter).cloned()?;
            let exponent = i64::from(*exponent);
            own.push(whole_power(e.clone(), exponent));
            power.push(match (self.degree(&e), &e.kind) {
                (Some(degree), ExprKind::Power(base, _)) => whole_power((**base).clone(), exponent * k / degree),
                _ => whole_power(e, exponent * k),
            });
        }
        let side = Side { own: product(own), power: product(power) };
        self.signs_of(&side.own).within(Signs::NOT_NEGATIVE).then_some(side)
    }
}
