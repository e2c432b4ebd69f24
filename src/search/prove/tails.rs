//! Sums below a number that they approach: sum(k = 1..n, 1/k^2) < 2, by the sharper statement that a multiple of 1/n is left,
//! which an induction shows.
//!
//! Method: of sum(i = a..n, t(i)) < c with t of degree −p in i, c − (c − S)·(s + h)^q/(n + h)^q is shown to be a bound from n = s on, where
//! S is the sum up to s, for q = p − 1 and less and h = 1 − s, 1/2 and 0; then with t(n) itself for the power. The least n and the next
//! ones are tried for s; what is before s is computed.

use super::coefficients::{polynomial, rational};
use super::comparison::single;
use super::facts::{minus, power_of};
use super::letters::{natural, product, whole_power};
use super::limits::{holds, over, plus};
use super::slopes::put_in;
use super::{Fail, Prover};
use crate::certificate::Label;
use crate::claim::syntax::*;
use crate::kernel::statement::{compare, name};
use crate::refute::literal::literal;
use malachite::Rational;

/// The highest power that is left.
const POWER: i64 = 4;

/// The greatest least n.
const FIRST: u32 = 100;

/// How much later than at the least n a bound may hold.
const LATER: u32 = 2;

/// Where the step of a bound is tried, counted from its start.
const TRIED: [u32; 5] = [0, 1, 2, 5, 20];

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
        if !self.naturals.contains(n) || holds(bound, n) || holds(body, n) || least > FIRST {
            return Err(no());
        }
        let k = index.name.text.as_str();
        let own = put_in(body, k, &name(n))?;
        let fall = degree(body, k).map_or(0, |p| (-p - 1).clamp(0, POWER));
        let half = Rational::from(1) / Rational::from(2);
        for start in least..=least + LATER {
            // What is left where the sum ends at the start.
            let Some(first) = sum_between(body, k, from, start) else { continue };
            let Some(gap) = computed(bound, &[]).map(|bound| bound - first).filter(|gap| *gap > 0) else {
                continue;
            };
            let mut left: Vec<Expr> = Vec::new();
            for q in (1..=fall).rev() {
                for apart in [Rational::from(1) - Rational::from(start), half.clone(), Rational::from(0)] {
                    let next = Rational::from(start) + &apart;
                    let size = &gap * power_of(&next, q);
                    let base = if apart == 0 { name(n) } else { plus(&name(n), literal(&apart)) };
                    if size > 0 {
                        left.push(over(literal(&size), whole_power(base, q)));
                    }
                }
            }
            if let Some(last) = computed(&own, &[(n.clone(), start)]).filter(|last| *last > 0) {
                left.push(product(vec![literal(&(&gap / last)), own.clone()]));
            }
            for left in left {
                // The next member takes no more than what then is left less.
                let holds_at = |m: u32| {
                    let of = |e: &Expr, m: u32| computed(e, &[(n.clone(), m)]);
                    let (here, next, member) = (of(&left, m), of(&left, m + 1), of(&own, m + 1));
                    here.zip(next).zip(member).is_none_or(|((here, next), member)| member <= here - next)
                };
                if !TRIED.iter().all(|j| holds_at(start + j)) {
                    continue;
                }
                let sharper = compare(whole.clone(), Relation::LessEqual, minus(bound, &left));
                let shown = self.attempt(|c| {
                    c.begun_later(goal, n, start - least, &mut |c| {
                        c.attempt(|c| c.by_steps_of_sums(&sharper)).or_else(|_| c.show_by_induction_on(&sharper, n))?;
                        c.quietly(goal)
                    })
                });
                if shown.is_ok() {
                    return shown;
                }
            }
        }
        Err(no())
    }
}

/// The sum of the members from one number to another.
fn sum_between(body: &Expr, k: &str, from: u32, to: u32) -> Option<Rational> {
    (from..=to).try_fold(Rational::from(0), |sum, i| Some(sum + computed(body, &[(k.to_string(), i)])?))
}

/// The value of an expression that operations with numbers give, where names have these values.
fn computed(e: &Expr, at: &[(String, u32)]) -> Option<Rational> {
    let value = |e: &Expr| computed(e, at);
    Some(match &e.kind {
        ExprKind::Name(n) => Rational::from(at.iter().rev().find(|own| own.0 == *n)?.1),
        ExprKind::Negate(a) => -value(a)?,
        ExprKind::Sum(list) => list.iter().try_fold(Rational::from(0), |sum, (sign, e)| {
            Some(if *sign == Sign::Plus { sum + value(e)? } else { sum - value(e)? })
        })?,
        ExprKind::Product(list) => list.iter().try_fold(Rational::from(1), |all, (how, e)| {
            let own = value(e)?;
            match how {
                Factor::Times => Some(all * own),
                Factor::Over => (own != 0).then(|| all / own),
            }
        })?,
        ExprKind::Power(base, exponent) => {
            let k = i64::try_from(&value(exponent)?).ok().filter(|k| (0..=64).contains(k))?;
            power_of(&value(base)?, k)
        }
        ExprKind::ProductOver(index, body) => {
            let end = |e: &Expr| u32::try_from(&value(e)?).ok().filter(|k| *k <= 64);
            let (from, to) = (end(&index.from)?, end(&index.to)?);
            (from..=to).try_fold(Rational::from(1), |all, i| {
                let mut inner = at.to_vec();
                inner.push((index.name.text.clone(), i));
                Some(all * computed(body, &inner)?)
            })?
        }
        _ => rational(e)?,
    })
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
