//! Sums over a range that begins at a natural variable, as sum(k = n + 1..2*n, 1/k), and those whose members hold it added to the
//! index, as sum(k = 1..n, 1/(n + k)).
//!
//! Method: such a sum is the difference of two that begin at a number, and the sum of as many members counted from 1: an induction on
//! the number m of members shows either for every m. The comparison of what stands for the sum is one that other methods know:
//! equations mostly of the difference, by induction on n, and orders by the step of that difference, or else of members counted from 1,
//! each by itself.
//!
//! Limits: [`SUMS`].

use super::comparison::single;
use super::facts::minus;
use super::letters::natural;
use super::limits::{holds, plus};
use super::slopes::put_in;
use super::sums::{replace, sums_where};
use super::values::over as over_index;
use super::{Fail, Prover};
use crate::algebra::Polynomial;
use crate::certificate::{Label, Term};
use crate::claim::syntax::*;
use crate::kernel::statement::{compare, name, numeral, prop};
use crate::refute::literal::literal;
use malachite::Rational;

/// The most sums in a goal that begin at a variable.
const SUMS: usize = 2;

/// What stands for a sum over a range.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Way {
    /// The sum up to its end less that up to its start, both from this number on.
    Difference(u32),
    /// The sum of its members counted from 1.
    Counted,
}

impl Prover {
    /// A comparison with sums that begin at a natural variable.
    pub(super) fn by_ranges(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("a sum that begins at a variable");
        if self.inductions > 0 || self.splits > 0 {
            return Err(no());
        }
        let (mut sides, mut sums) = (Vec::new(), Vec::new());
        super::goals::sides_in(goal, &mut sides);
        let begins = |index: &Index| self.naturals.iter().any(|n| holds(&index.from, n));
        sides.iter().for_each(|e| sums_where(e, &begins, &mut sums));
        if !sums.is_empty() || single(goal)?.1 == Relation::Equal {
            self.moved_sums(&sides, &mut sums);
        }
        if sums.is_empty() || sums.len() > SUMS {
            return Err(no());
        }
        for way in [Way::Difference(1), Way::Difference(0), Way::Counted] {
            if let Ok(label) = self.on_its_own(|c| c.by_ranges_as(goal, &sums, way)) {
                return Ok(label);
            }
        }
        Err(no())
    }

    fn by_ranges_as(&mut self, goal: &Prop, sums: &[Expr], way: Way) -> Result<Label, Fail> {
        let (mut other, mut equations) = (goal.clone(), Vec::new());
        for s in sums {
            let (value, label) = self.range_as(s, way)?;
            if let PropKind::Compare(sides, _) = &mut other.kind {
                sides.iter_mut().for_each(|e| replace(e, s, &value));
            }
            equations.push(label);
        }
        let is_order = single(goal)?.1 != Relation::Equal;
        let shown = match way {
            // An order of sums that begin at a number has to be shown by a step, or else their members are compared.
            Way::Difference(_) if is_order => self.by_steps_of_sums(&other)?,
            _ => self.show(&other)?,
        };
        let mut terms = vec![Term { facts: vec![shown], factor: numeral(1) }];
        for (s, label) in sums.iter().zip(equations) {
            let factor = self.times_in(goal, s)?;
            terms.push(Term { facts: vec![label], factor });
        }
        self.combination(goal.clone(), terms)
    }

    /// What an expression is multiplied by in the difference of the sides of a comparison.
    pub(super) fn times_in(&mut self, goal: &Prop, s: &Expr) -> Result<Expr, Fail> {
        let (a, _, b) = single(goal)?;
        let with = |value: u32| {
            let mut e = minus(a, b);
            replace(&mut e, s, &numeral(value));
            e
        };
        let (above, below) = self.letters.quotient(&minus(&with(1), &with(0))).ok_or(Fail::No("a factor"))?;
        self.quotient_written(&above, &below).ok_or(Fail::No("a factor"))
    }

    /// The sums from a number on whose members hold a natural variable added to the index, as 1/(n + k).
    fn moved_sums(&mut self, sides: &[Expr], out: &mut Vec<Expr>) {
        let mut sums = Vec::new();
        sides.iter().for_each(|e| sums_where(e, &|_| true, &mut sums));
        out.extend(sums.into_iter().filter(|s| self.moved_range(s).is_some()));
    }

    /// The variable that members hold added to the index, and the sum over a range that begins at it.
    fn moved_range(&mut self, s: &Expr) -> Option<(String, Expr)> {
        let ExprKind::SumOver(index, body) = &s.kind else { return None };
        let from = natural(&index.from)?;
        let k = index.name.text.as_str();
        let n = self.naturals.iter().find(|n| holds(body, n)).cloned()?;
        let (above, below) = self.quotient(&put_in(body, k, &minus(&name(k), &name(&n))).ok()?, k)?;
        let body = self.quotient_written(&above, &below).filter(|e| !holds(e, &n))?;
        let to = self.letters.polynomial(&plus(&index.to, name(&n)))?;
        let to = Box::new(self.letters.written(&to));
        let index = Index { from: Box::new(plus(&name(&n), numeral(from))), to, ..index.clone() };
        Some((n, over_index(true, index, &body)))
    }

    /// What stands for a sum over a range, and the equation of the two.
    fn range_as(&mut self, s: &Expr, way: Way) -> Result<(Expr, Label), Fail> {
        let no = || Fail::No("a sum over a range");
        let ExprKind::SumOver(index, body) = &s.kind else { return Err(no()) };
        if let Some((_, range)) = self.moved_range(s) {
            let (value, counted) = match way {
                Way::Counted => return Err(no()),
                Way::Difference(_) => (self.range_as(&range, way)?, self.range_as(&range, Way::Counted)?),
            };
            let terms = [(value.1, 1), (counted.1, -1)];
            let terms = terms.map(|(label, by)| Term { facts: vec![label], factor: literal(&Rational::from(by)) });
            let same = compare(s.clone(), Relation::Equal, value.0.clone());
            return Ok((value.0, self.combination(same, terms.to_vec())?));
        }
        let mut read = |e: &Expr| self.letters.polynomial(e);
        let (from, to) = (read(&index.from).ok_or_else(no)?, read(&index.to).ok_or_else(no)?);
        let m = self.fresh("m");
        let before = from.sub(&Polynomial::one());
        let count = self.letters.written(&to.sub(&before));
        let end = before.add(&Polynomial::variable(self.letters.of(&name(&m))));
        let (before, end) = (self.letters.written(&before), self.letters.written(&end));
        let k = index.name.text.as_str();
        let later = put_in(body, k, &plus(&before, name(k)))?;
        let ranging = |from: Expr, to: &Expr, body: &Expr| {
            let index = Index { from: Box::new(from), to: Box::new(to.clone()), ..index.clone() };
            over_index(true, index, body)
        };
        let value = |count: &Expr, end: &Expr| match way {
            Way::Counted => ranging(numeral(1), count, &later),
            Way::Difference(first) => {
                minus(&ranging(numeral(first), end, body), &ranging(numeral(first), &before, body))
            }
        };
        let same = compare(ranging((*index.from).clone(), &end, body), Relation::Equal, value(&name(&m), &end));
        let every = prop(PropKind::ForAll(vec![Binding::of(Name::new(&m), true, Vec::new())], Box::new(same)));
        let splits = std::mem::replace(&mut self.splits, 0);
        let every = self.all_by_induction(&every, 3);
        self.splits = splits;
        let here = self.instance(&every?, &count)?;
        let value = value(&count, &index.to);
        let same = compare(s.clone(), Relation::Equal, value.clone());
        let label = self.combination(same, vec![Term { facts: vec![here], factor: numeral(1) }])?;
        Ok((value, label))
    }
}
