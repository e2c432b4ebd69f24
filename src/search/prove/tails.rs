//! Sums below a number that they approach: sum(k = 1..n, 1/k^2) < 2, by the sharper statement that a multiple of 1/n is left,
//! which an induction shows.
//!
//! Method: of sum(i = a..n, t(i)) < c with t of degree −p in i, c − (c − S)/(n + 1 − s)^q is shown to be a bound from the least n = s
//! on, where S is the sum up to s, for q = p − 1 and less; then with t(n) itself for the power.

use super::coefficients::{polynomial, rational};
use super::comparison::single;
use super::facts::minus;
use super::letters::{natural, product, whole_power};
use super::limits::{holds, over};
use super::slopes::put_in;
use super::{Fail, Prover};
use crate::certificate::Label;
use crate::claim::syntax::*;
use crate::kernel::statement::{compare, name, numeral, sum};
use crate::refute::literal::literal;
use malachite::Rational;

/// The highest power that is left.
const POWER: i64 = 4;

impl Prover {
    /// A bound of a sum up to a natural number by a number free of it, from a bound that is reached later.
    pub(super) fn by_what_is_left(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let (a, relation, b) = single(goal)?;
        let no = || Fail::No("a sum below a number");
        if self.inductions > 0 {
            return Err(no());
        }
        let is_greater = relation.is_greater().ok_or_else(no)?;
        let (whole, bound) = if is_greater { (b, a) } else { (a, b) };
        let ExprKind::SumOver(index, body) = &whole.kind else { return Err(no()) };
        let ExprKind::Name(n) = &index.to.kind else { return Err(no()) };
        let (from, least) = (natural(&index.from).ok_or_else(no)?, self.least(n).unwrap_or(0));
        if !self.naturals.contains(n) || holds(bound, n) || holds(body, n) {
            return Err(no());
        }
        let mut first = Vec::new();
        for i in from..=least {
            first.push((Sign::Plus, put_in(body, &index.name.text, &numeral(i))?));
        }
        let first = if first.is_empty() { numeral(0) } else { sum(first) };
        let gap = rational(&minus(bound, &first)).filter(|gap| *gap > 0).ok_or_else(no)?;
        let next =
            sum(vec![(Sign::Plus, name(n)), (Sign::Plus, literal(&(Rational::from(1) - Rational::from(least))))]);
        let fall = degree(body, &index.name.text).map_or(0, |p| (-p - 1).clamp(0, POWER));
        let powers = (1..=fall).rev().map(|q| over(literal(&gap), whole_power(next.clone(), q)));
        let mut left: Vec<Expr> = powers.collect();
        let own = put_in(body, &index.name.text, &name(n))?;
        if let Some(last) = rational(&put_in(body, &index.name.text, &numeral(least))?).filter(|last| *last > 0) {
            left.push(product(vec![literal(&(&gap / last)), own]));
        }
        for left in left {
            let shown = self.attempt(|c| {
                let sharper = compare(whole.clone(), Relation::LessEqual, minus(bound, &left));
                c.show_by_induction_on(&sharper, n)?;
                c.quietly(goal)
            });
            if shown.is_ok() {
                return shown;
            }
        }
        Err(no())
    }
}

/// The degree of a quotient of polynomials in x, that of the divisor taken off.
fn degree(e: &Expr, x: &str) -> Option<i64> {
    if let Some(p) = polynomial(e, x) {
        return i64::try_from(p.len()).ok().map(|length| length - 1);
    }
    match &e.kind {
        ExprKind::Negate(a) => degree(a, x),
        ExprKind::Product(list) => list.iter().try_fold(0, |sum, (how, e)| {
            let own = degree(e, x)?;
            Some(if *how == Factor::Times { sum + own } else { sum - own })
        }),
        ExprKind::Power(base, k) => Some(degree(base, x)? * i64::from(natural(k)?)),
        ExprKind::Sum(list) => list.iter().map(|(_, e)| degree(e, x)).collect::<Option<Vec<_>>>()?.into_iter().max(),
        _ => None,
    }
}
