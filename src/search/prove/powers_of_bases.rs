//! Orders of powers of numbers and of their sums with one natural exponent: ((a + b)/2)^n <= (a^n + b^n)/2 for a, b >= 0.
//!
//! Method: induction on n. Its step knows that (a - b)·(a^n - b^n) >= 0, which the cases a >= b and a < b show.
//!
//! Limits: [`BASES`].

use super::facts::{minus, negated};
use super::letters::product;
use super::limits::holds;
use super::{Fail, Prover, implies, put};
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::claim::walk::parts;
use crate::kernel::key;
use crate::kernel::statement::{compare, name, numeral, power};

/// The most variables that are bases.
const BASES: usize = 3;

impl Prover {
    /// An order of powers with one exponent, of variables and of what holds them, by induction on the exponent.
    pub(super) fn by_powers_of_two_bases(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("powers of two bases");
        if self.inductions > 0 || self.splits > 0 {
            return Err(no());
        }
        let mut sides = Vec::new();
        super::goals::sides_in(goal, &mut sides);
        for n in self.naturals.clone().iter().rev() {
            let (mut bases, mut others) = (Vec::new(), Vec::new());
            sides.iter().for_each(|e| bases_of(e, n, &mut bases, &mut others));
            let is_mixed = |e: &Expr| bases.iter().filter(|b| super::sums::occurs(b, e)).count() > 1;
            if bases.len() < 2 || bases.len() > BASES || !others.iter().any(is_mixed) {
                continue;
            }
            let start = u32::from(self.least(n).is_none());
            let shown = self.attempt(|c| c.begun_later(goal, n, start, &mut |c| c.by_ordered_powers(goal, n, &bases)));
            if shown.is_ok() {
                return shown;
            }
        }
        Err(no())
    }

    /// The same from the least exponent on.
    fn by_ordered_powers(&mut self, goal: &Prop, n: &str, bases: &[Expr]) -> Result<Label, Fail> {
        let (k, least) = (self.fresh("k"), self.least(n));
        let body = put(goal, n, &name(&k))?;
        self.inductions += 1;
        let all = self.induction_by(&k, least, &body, &mut |c, _, next| {
            for (i, a) in bases.iter().enumerate() {
                for b in bases.iter().skip(i + 1) {
                    c.ordered_powers(a, b, &k)?;
                }
            }
            c.without_cases(next)
        })?;
        self.inductions -= 1;
        let shown = self.instance(&all, &name(n))?;
        self.logic(&[&shown], goal)
    }

    /// (a - b)·(a^k - b^k) >= 0, as a fact.
    fn ordered_powers(&mut self, a: &Expr, b: &Expr, k: &str) -> Result<Label, Fail> {
        let to_k = |e: &Expr| power(e, &name(k));
        let both = product(vec![minus(a, b), minus(&to_k(a), &to_k(b))]);
        let shown = compare(both, Relation::GreaterEqual, numeral(0));
        let (above, below) =
            (compare(a.clone(), Relation::GreaterEqual, b.clone()), compare(a.clone(), Relation::Less, b.clone()));
        let mut cases = Vec::new();
        for (case, is_above) in [(above, true), (below, false)] {
            let case = self.block(&implies(&case, &shown), |c, block| {
                let mut from = format!("{block}s");
                let (large, small) = if is_above { (a, b) } else { (b, a) };
                if !is_above {
                    let turned = Term { facts: vec![from], factor: negated(numeral(1)) };
                    from = c.combination(compare(b.clone(), Relation::GreaterEqual, a.clone()), vec![turned])?;
                }
                let powers = compare(to_k(large), Relation::GreaterEqual, to_k(small));
                let powers = c.emit(Rule::Monotone { from: from.clone() }, powers)?;
                c.combination(shown.clone(), vec![Term { facts: vec![from, powers], factor: numeral(1) }])
            })?;
            cases.push(case);
        }
        let label = self.emit(Rule::Logic { from: cases }, shown.clone())?;
        self.take_in(&label, &shown)?;
        Ok(label)
    }
}

/// The bases of powers whose exponents hold a name that the bases do not: variables, and others, each variable once.
fn bases_of(e: &Expr, n: &str, out: &mut Vec<Expr>, others: &mut Vec<Expr>) {
    if let ExprKind::Power(base, exponent) = &e.kind
        && holds(exponent, n)
        && !holds(base, n)
    {
        match &base.kind {
            ExprKind::Name(_) if !out.iter().any(|old| key::expr(old) == key::expr(base)) => out.push((**base).clone()),
            ExprKind::Name(_) => {}
            _ => others.push((**base).clone()),
        }
    }
    parts(e, &mut |part| bases_of(part, n, out, others));
}
