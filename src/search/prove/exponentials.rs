//! Limits of what holds an exponential whose exponent depends on the variable that grows, between what its tangents give.

use super::facts::minus;
use super::letters::product;
use super::limits::{holds, over};
use super::sums::replace;
use super::{Fail, Prover};
use crate::certificate::{Label, Term};
use crate::claim::syntax::*;
use crate::kernel::statement::{apply, compare, expr, name, numeral, prop, sum};
use crate::kernel::substitution::Substitution;

/// With how little effort bounds are compared: at once or not at all, since half of the pairs are in the wrong order.
const QUIET: usize = 8;

/// y = exp(u).
struct Exponential {
    y: Expr,
    u: Expr,
}

impl Exponential {
    /// 1 + u, at most y.
    fn line(&self) -> Expr {
        sum(vec![(Sign::Plus, numeral(1)), (Sign::Plus, self.u.clone())])
    }

    /// 1 − u.
    fn divisor(&self) -> Expr {
        minus(&numeral(1), &self.u)
    }

    /// 1/(1 − u), at least y where u < 1.
    fn hyperbola(&self) -> Expr {
        over(numeral(1), self.divisor())
    }

    /// With another value of the variable.
    fn at(&self, variable: &str, value: &Expr) -> Result<Exponential, Fail> {
        let mut map = Substitution::default();
        map.replace(variable, value);
        let at = |e: &Expr| map.expr(e).map_err(Fail::from);
        Ok(Exponential { y: at(&self.y)?, u: at(&self.u)? })
    }

    /// F with something else for y.
    fn put(&self, f: &Expr, value: &Expr) -> Expr {
        let mut f = f.clone();
        replace(&mut f, &self.y, value);
        f
    }
}

/// The first exponential, or power of what is constant, whose exponent holds the variable.
fn exponential_in(e: &Expr, variable: &str) -> Option<Exponential> {
    match &e.kind {
        ExprKind::Apply(f, list) if f.text == "exp" && list.len() == 1 && holds(&list[0], variable) => {
            Some(Exponential { y: e.clone(), u: list[0].clone() })
        }
        ExprKind::Power(base, exponent) if !holds(base, variable) && holds(exponent, variable) => {
            let u = product(vec![(**exponent).clone(), apply("ln", (**base).clone())]);
            Some(Exponential { y: e.clone(), u })
        }
        ExprKind::Negate(a) => exponential_in(a, variable),
        ExprKind::Power(a, b) => exponential_in(a, variable).or_else(|| exponential_in(b, variable)),
        ExprKind::Sum(list) => list.iter().find_map(|(_, e)| exponential_in(e, variable)),
        ExprKind::Product(list) => list.iter().find_map(|(_, e)| exponential_in(e, variable)),
        ExprKind::Apply(_, list) => list.iter().find_map(|e| exponential_in(e, variable)),
        _ => None,
    }
}

impl Prover {
    /// Shows a limit of F(y) for the exponential y = exp(u) in F: 1 + u <= y since the exponential lies above its tangent, and
    /// y <= 1/(1 − u) where u < 1, since exp(−u) lies above it too.
    pub(crate) fn by_exponential(&mut self, goal: &Prop, l: &Limit) -> Result<Label, Fail> {
        let no = || Fail::No("an exponential with the variable that grows in its exponent");
        let whole = exponential_in(&l.of, &l.variable.text).ok_or_else(no)?;
        // With several the bounds lie too far apart.
        if exponential_in(&whole.put(&l.of, &numeral(1)), &l.variable.text).is_some() {
            return Err(no());
        }
        let k = self.fresh("k");
        let here = whole.at(&l.variable.text, &name(&k))?;
        // From 4 on the exponent is often below 1.
        for least in [4, 1] {
            let binding = self.growing_from(least, l, &k);
            let every = |p: &Prop| prop(PropKind::ForAll(vec![binding.clone()], Box::new(p.clone())));
            let above = compare(here.line(), Relation::LessEqual, here.y.clone());
            let below = compare(here.y.clone(), Relation::LessEqual, here.hyperbola());
            let Ok(fact) = self.attempt(|c| c.block(&every(&above), |c, _| c.above_line(&here, &above))) else {
                continue;
            };
            let mut facts = vec![fact];
            let mut bounds = vec![l.value.clone(), whole.put(&l.of, &whole.line())];
            let less = compare(here.divisor(), Relation::Greater, numeral(0));
            let hyperbola = self.attempt(|c| {
                let less = c.block(&every(&less), |c, _| c.without_cases(&less))?;
                Ok([less.clone(), c.block(&every(&below), |c, _| c.below_hyperbola(&here, &below))?])
            });
            if let Ok(shown) = hyperbola {
                facts.extend(shown);
                bounds.push(whole.put(&l.of, &whole.hyperbola()));
            }
            for (i, a) in bounds.iter().enumerate().rev() {
                for b in &bounds[..i] {
                    for pair in [(a, b), (b, a)] {
                        if let Ok(label) = self.attempt(|c| c.between_by(goal, l, pair, &facts, least, QUIET)) {
                            return Ok(label);
                        }
                    }
                }
            }
        }
        Err(no())
    }

    /// Shows a comparison with known inequalities, but without cases.
    pub(super) fn without_cases(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let splits = std::mem::replace(&mut self.splits, 3);
        let shown = self.show(goal);
        self.splits = splits;
        shown
    }

    /// 1 + u <= y.
    fn above_line(&mut self, here: &Exponential, goal: &Prop) -> Result<Label, Fail> {
        let tangent = self.tangent_at(&here.u)?;
        self.combination(goal.clone(), vec![Term { facts: vec![tangent], factor: numeral(1) }])
    }

    /// y <= 1/(1 − u): the difference is y/(1 − u)·(exp(−u) − (1 − u)).
    fn below_hyperbola(&mut self, here: &Exponential, goal: &Prop) -> Result<Label, Fail> {
        self.quietly(&compare(here.divisor(), Relation::Greater, numeral(0)))?;
        let tangent = self.tangent_at(&expr(ExprKind::Negate(Box::new(here.u.clone()))))?;
        let factor = over(here.y.clone(), here.divisor());
        self.combination(goal.clone(), vec![Term { facts: vec![tangent], factor }])
    }
}
