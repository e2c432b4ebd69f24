//! Goals about members that divide by what grows: 2/(3·2^n − 2) and (c^(2^n) + 1)/(c^(2^n) − 1) have a value only since 3·2^n > 2 and c^(2^n) > 1.
//!
//! Method: where the sign of a divisor is not seen, it is shown for all indices by an induction of its own, before the goal. The step of the
//! induction for the goal then knows it of both indices. What holds no index is shown as any comparison is: 1 + (E/M)·(1 - cos(theta)) > 0
//! takes a bound of the cosine.
//!
//! Limits: [`DIVISORS`].

use super::induction::is_bound_within;
use super::{Fail, Prover, put};
use crate::certificate::Label;
use crate::claim::syntax::*;
use crate::kernel::key;
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, name, numeral, prop};

/// The most divisors of a goal.
const DIVISORS: usize = 3;

impl Prover {
    /// Shows a comparison after the signs of its divisors.
    pub(super) fn by_signs_of_divisors(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("a divisor without a sign");
        if self.inductions > 0 || self.splits > 0 || !self.signs_for_all.is_empty() {
            return Err(no());
        }
        let (mut sides, mut divisors) = (Vec::new(), Vec::new());
        super::goals::sides_in(goal, &mut sides);
        sides.iter().for_each(|e| divisors_in(e, &mut divisors));
        let (mut labels, mut count) = (Vec::new(), 0);
        // The innermost first: outer ones have a value by these.
        for d in divisors.into_iter().rev() {
            let [positive, negative] = [Relation::Greater, Relation::Less].map(|r| compare(d.clone(), r, numeral(0)));
            let n = self.naturals.iter().rev().find(|n| is_bound_within(&positive, n)).cloned();
            if self.signs_of(&d).within(Signs::NOT_ZERO) {
                continue;
            }
            match n {
                Some(n) => labels.push(self.sign_for_all(&d, &n)?),
                None => {
                    let shown = self.on_its_own(|c| c.without_cases(&positive));
                    shown.or_else(|_| self.on_its_own(|c| c.without_cases(&negative)))?;
                }
            }
            count += 1;
            if count > DIVISORS {
                return Err(no());
            }
        }
        if count == 0 {
            return Err(no());
        }
        self.signs_for_all = labels;
        let shown = self.attempt(|c| c.comparison(goal)).or_else(|_| self.by_induction(goal));
        self.signs_for_all.clear();
        shown
    }

    /// Shows that an expression is positive for all values of a natural variable, or negative for all.
    fn sign_for_all(&mut self, e: &Expr, n: &str) -> Result<Label, Fail> {
        let k = self.fresh("k");
        let bound = self.least(n).map(|k| Constraint::Relation(Relation::GreaterEqual, numeral(k)));
        let binding = Binding::of(Name::new(&k), true, bound.into_iter().collect());
        let mut shown = Err(Fail::No("a sign"));
        for relation in [Relation::Greater, Relation::Less] {
            let body = put(&compare(e.clone(), relation, numeral(0)), n, &name(&k))?;
            let every = prop(PropKind::ForAll(vec![binding.clone()], Box::new(body)));
            shown = self.on_its_own(|c| c.all_by_induction(&every, 3));
            // An induction that succeeds leaves the number of cases as it was in its base.
            self.splits = 0;
            if shown.is_ok() {
                break;
            }
        }
        let every = shown?;
        self.instance(&every, &name(n))?;
        Ok(every)
    }

    /// Takes in the signs that were shown for all values of a natural variable, at a value and at the next.
    pub(super) fn take_signs_at(&mut self, variable: &str) {
        for every in self.signs_for_all.clone() {
            for at in [name(variable), super::limits::plus(&name(variable), numeral(1))] {
                let _ = self.attempt(|c| c.instance(&every, &at));
            }
        }
    }
}

/// What an expression divides by outside of sums, products, integrals and derivatives, each once.
fn divisors_in(e: &Expr, out: &mut Vec<Expr>) {
    match &e.kind {
        ExprKind::SumOver(..) | ExprKind::ProductOver(..) | ExprKind::IntegralOver(..) | ExprKind::Derivative(..) => {
            return;
        }
        ExprKind::Product(list) => {
            for (_, d) in list.iter().filter(|(how, _)| *how == Factor::Over) {
                if !out.iter().any(|known| key::expr(known) == key::expr(d)) {
                    out.push(d.clone());
                }
            }
        }
        _ => {}
    }
    crate::claim::walk::parts(e, &mut |part| divisors_in(part, out));
}
