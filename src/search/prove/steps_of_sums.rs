//! Comparisons of a sum up to a natural variable with what grows by more or less than its members: sum(k = 1..n, sqrt(k)) >=
//! 2/3*n*sqrt(n), sum(k = 1..n, arctan(1/(1 + k + k^2))) = arctan(n + 1) - pi/4.
//!
//! Method: an induction on n whose step is what the next member is beside G(n + 1) - G(n), for the other side G. That comparison is
//! shown first and by itself, for every n from the least on: it holds no sum, so that all methods serve it. A strict order is one at the
//! start alone.
//!
//! Limits: [`MEMBERS`]; sums and their factors do not hold n. Steps that fail at one of [`TRIED`] are not tried.

use super::comparison::single;
use super::facts::minus;
use super::letters::{product, total};
use super::limits::{holds, plus};
use super::slopes::put_in;
use super::sums::{replace, sums_where};
use super::{Fail, Prover, put};
use crate::algebra::Polynomial;
use crate::certificate::{Label, Term};
use crate::claim::syntax::*;
use crate::claim::walk::parts;
use crate::kernel::key;
use crate::kernel::statement::{compare, name, numeral, prop};

/// The most members by which a sum grows.
const MEMBERS: i64 = 4;

/// Where a step is tried, counted from the least n.
const TRIED: [u32; 8] = [0, 1, 2, 3, 5, 10, 50, 1000];

impl Prover {
    /// A comparison with sums up to a natural variable, by its step.
    pub(super) fn by_steps_of_sums(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("a sum up to a natural variable");
        let (a, relation, b) = single(goal)?;
        if self.inductions > 0 || self.splits > 0 || relation == Relation::NotEqual {
            return Err(no());
        }
        for n in self.naturals.clone().iter().rev() {
            let mut sums = Vec::new();
            for side in [a, b] {
                sums_where(side, &|index| holds(&index.to, n), &mut sums);
            }
            if sums.is_empty() {
                continue;
            }
            let Some(step) = self.step_of_sums((a, relation, b), &sums, n) else { continue };
            if let Ok(label) = self.on_its_own(|c| c.by_step(goal, &step, n)) {
                return Ok(label);
            }
        }
        Err(no())
    }

    /// What the next members are beside what else changes, if it holds wherever it is tried.
    fn step_of_sums(&mut self, (a, relation, b): (&Expr, Relation, &Expr), sums: &[Expr], n: &str) -> Option<Prop> {
        let weak = match relation {
            Relation::Less => Relation::LessEqual,
            Relation::Greater => Relation::GreaterEqual,
            relation => relation,
        };
        let mut members = Vec::new();
        let difference = minus(a, b);
        let with = |value: &dyn Fn(&Expr) -> u32| {
            let mut e = difference.clone();
            sums.iter().for_each(|s| replace(&mut e, s, &numeral(value(s))));
            e
        };
        let rest = with(&|_| 0);
        // Beside a product that moves, the order of the step takes the goal itself.
        if moves(&rest, n) {
            return None;
        }
        for s in sums {
            let ExprKind::SumOver(index, body) = &s.kind else { return None };
            if holds(body, n) || holds(&index.from, n) {
                return None;
            }
            let slope = self.slope(&index.to, n).filter(|slope| (1..=MEMBERS).contains(slope))?;
            let own = key::expr(s);
            let one = with(&|other| u32::from(key::expr(other) == own));
            let times = self.letters.polynomial(&minus(&one, &rest)).map(|p| self.letters.written(&p))?;
            if holds(&times, n) || sums.iter().any(|s| super::sums::occurs(s, &times)) {
                return None;
            }
            let to = self.letters.polynomial(&index.to)?;
            for j in 1..=slope {
                let at = self.letters.written(&to.add(&Polynomial::integer(j)));
                let member = put_in(body, &index.name.text, &at).ok()?;
                members.push((Sign::Plus, product(vec![times.clone(), member])));
            }
        }
        let next = plus(&name(n), numeral(1));
        // What is less than the members: -(rest(n + 1) - rest(n)).
        let less = minus(&rest, &put_in(&rest, n, &next).ok()?);
        let less = match self.letters.polynomial(&less) {
            Some(p) => self.letters.written(&p),
            None => less,
        };
        let step = compare(total(members), weak, less);
        let least = self.least(n).unwrap_or(0);
        let fails = |j: &u32| {
            let mut place = vec![(n.to_string(), f64::from(least) + f64::from(*j))];
            super::trial_points::truth(&step, &mut place, &Default::default()) == Some(false)
        };
        (!TRIED.iter().any(fails)).then_some(step)
    }

    /// An induction with this step.
    fn by_step(&mut self, goal: &Prop, step: &Prop, n: &str) -> Result<Label, Fail> {
        let least = self.least(n);
        let k = self.fresh("k");
        let (body, step) = (put(goal, n, &name(&k))?, put(step, n, &name(&k))?);
        let bound = least.map(|least| Constraint::Relation(Relation::GreaterEqual, numeral(least)));
        let binding = Binding::of(Name::new(&k), true, bound.into_iter().collect());
        let every = prop(PropKind::ForAll(vec![binding], Box::new(step.clone())));
        let every = self.block(&every, |c, _| c.show(&step))?;
        self.inductions += 1;
        let all = self.induction_by(&k, least, &body, &mut |c, hypothesis, next| {
            let here = c.instance(&every, &name(&k))?;
            let mut sides = Vec::new();
            super::goals::sides_in(next, &mut sides);
            c.enrich(&sides.iter().collect::<Vec<_>>());
            let terms = [hypothesis, here].map(|label| Term { facts: vec![label], factor: numeral(1) });
            c.combination(next.clone(), terms.to_vec())
        })?;
        self.inductions -= 1;
        let shown = self.instance(&all, &name(n))?;
        self.logic(&[&shown], goal)
    }
}

/// Whether a sum or product whose range holds a variable is part of an expression.
fn moves(e: &Expr, n: &str) -> bool {
    let mut found = match &e.kind {
        ExprKind::SumOver(index, _) | ExprKind::ProductOver(index, _) => holds(&index.from, n) || holds(&index.to, n),
        _ => false,
    };
    parts(e, &mut |part| found |= moves(part, n));
    found
}
