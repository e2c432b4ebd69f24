//! Sums over a range that begins at a natural variable, as sum(k = n + 1..2*n, 1/k), and sums up to a power, as sum(k = 1..2^n, 1/k).
//!
//! Method: such a sum is the difference of two that begin at a number, and the sum of as many members counted from 1: an induction on
//! the number m of members shows either for every m. The comparison of what stands for the sum is one that the other methods know:
//! equations mostly of the difference, by induction on n, and orders of members counted from 1, each by itself.
//! A sum S(b^n) up to a power of a number b grows by that over b^n + 1..b^(n + 1) from n to n + 1. If what the goal allows for is the
//! same for every n, or depends on b^n alone, then it is shown of m + 1..b·m for every number m >= 1, and the rest is induction on n.
//!
//! Limits: [`SUMS`].

use super::comparison::single;
use super::facts::{minus, negated};
use super::letters::{natural, product};
use super::limits::{holds, plus};
use super::slopes::put_in;
use super::sums::replace;
use super::values::over as over_index;
use super::{Fail, Prover, put};
use crate::algebra::Polynomial;
use crate::certificate::{Label, Term};
use crate::claim::syntax::*;
use crate::claim::walk::parts;
use crate::kernel::key;
use crate::kernel::statement::{compare, name, numeral, power, prop};
use crate::refute::literal::literal;

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
        let relation = single(goal)?.1;
        if self.inductions > 0 || self.splits > 0 {
            return Err(no());
        }
        let (mut sides, mut sums) = (Vec::new(), Vec::new());
        super::goals::sides_in(goal, &mut sides);
        sides.iter().for_each(|e| ranges(e, &self.naturals, &mut sums));
        if sums.is_empty() || sums.len() > SUMS {
            return Err(no());
        }
        let mut ways = vec![Way::Counted, Way::Difference(1), Way::Difference(0)];
        if relation == Relation::Equal {
            ways.rotate_left(1);
        }
        for way in ways {
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
        let shown = self.show(&other)?;
        equations.iter().for_each(|label| self.put_in(label));
        self.combination(goal.clone(), vec![Term { facts: vec![shown], factor: numeral(1) }])
    }

    /// What stands for a sum over a range, and the equation of the two.
    fn range_as(&mut self, s: &Expr, way: Way) -> Result<(Expr, Label), Fail> {
        let no = || Fail::No("a sum over a range");
        let ExprKind::SumOver(index, body) = &s.kind else { return Err(no()) };
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

    /// An order of a sum up to a power of a number, by what it grows by from one power to the next.
    pub(super) fn by_powers_at_an_end(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("a sum up to a power of a number");
        let (a, relation, b) = single(goal)?;
        if self.inductions > 0 || self.splits > 0 {
            return Err(no());
        }
        let difference = minus(a, b);
        for n in self.naturals.clone() {
            let mut ends = Vec::new();
            powers_at_an_end(&difference, &n, &mut ends);
            if let [(whole, base)] = ends.as_slice() {
                return self.on_its_own(|c| c.by_growing_powers(goal, relation, &difference, whole, base, &n));
            }
        }
        Err(no())
    }

    fn by_growing_powers(
        &mut self,
        goal: &Prop,
        relation: Relation,
        difference: &Expr,
        whole: &Expr,
        base: &Expr,
        n: &str,
    ) -> Result<Label, Fail> {
        let no = || Fail::No("a sum up to a power of a number");
        let ExprKind::SumOver(index, body) = &whole.kind else { return Err(no()) };
        let weak = match relation {
            Relation::Less => Relation::LessEqual,
            Relation::Greater => Relation::GreaterEqual,
            relation => relation,
        };
        let first = natural(&index.from).ok_or_else(no)?;
        let with = |value: u32| {
            let mut e = difference.clone();
            replace(&mut e, whole, &numeral(value));
            e
        };
        let rest = with(0);
        let times = self.letters.number(&minus(&with(1), &rest)).filter(|c| *c != 0).ok_or_else(no)?;
        // With m for b^n.
        let m = self.fresh("m");
        let (here, own) = (power(base, &name(n)), name(&m));
        let in_m = |e: &Expr| {
            let mut e = e.clone();
            replace(&mut e, &here, &own);
            (!holds(&e, n)).then_some(e)
        };
        let next = product(vec![base.clone(), own.clone()]);
        let end = in_m(&index.to).ok_or_else(no)?;
        let later_end = put_in(&end, &m, &next)?;
        let mut later = put_in(&rest, n, &plus(&name(n), numeral(1)))?;
        replace(&mut later, &put_in(&here, n, &plus(&name(n), numeral(1)))?, &next);
        let mut now = rest.clone();
        for e in [&mut now, &mut later] {
            replace(e, &here, &own);
        }
        let more = self.letters.quotient(&minus(&later, &now)).ok_or_else(no)?;
        let more = self.quotient_written(&more.0, &more.1).filter(|e| !holds(e, n)).ok_or_else(no)?;
        let sum_over = |from: Expr, to: &Expr| {
            let index = Index { from: Box::new(from), to: Box::new(to.clone()), ..index.clone() };
            over_index(true, index, body)
        };
        let start = self.letters.polynomial(&end).ok_or_else(no)?.add(&Polynomial::one());
        let range = sum_over(self.letters.written(&start), &later_end);
        let beside = |sums: Expr| {
            let grows = plus(&product(vec![literal(&times), sums]), more.clone());
            compare(grows, weak, numeral(0))
        };
        let apart = minus(&sum_over(numeral(first), &later_end), &sum_over(numeral(first), &end));
        let grows = beside(apart);
        let from_one = Constraint::Relation(Relation::GreaterEqual, numeral(1));
        let binding = Binding::of(Name::new(&m), true, vec![from_one]);
        let every = prop(PropKind::ForAll(vec![binding], Box::new(grows.clone())));
        let every = self.block(&every, |c, _| {
            let shown = c.show(&beside(range.clone()))?;
            let (_, same) = c.range_as(&range, Way::Difference(first))?;
            let term = |label: Label, factor: Expr| Term { facts: vec![label], factor };
            let terms = vec![term(shown, numeral(1)), term(same, negated(literal(&times)))];
            c.combination(grows.clone(), terms)
        })?;
        self.inductions += 1;
        let (k, least) = (self.fresh("k"), self.least(n));
        let of_k = put(goal, n, &name(&k))?;
        let all = self.induction_by(&k, least, &of_k, &mut |c, hypothesis, next| {
            let at = power(base, &name(&k));
            c.without_cases(&compare(at.clone(), Relation::GreaterEqual, numeral(1)))?;
            let here = c.instance(&every, &at)?;
            let terms = [hypothesis, here].map(|label| Term { facts: vec![label], factor: numeral(1) });
            c.combination(next.clone(), terms.to_vec())
        })?;
        self.inductions -= 1;
        let shown = self.instance(&all, &name(n))?;
        self.logic(&[&shown], goal)
    }
}

/// The sums that begin at one of these names, each once and none in another.
fn ranges(e: &Expr, names: &[String], out: &mut Vec<Expr>) {
    match &e.kind {
        ExprKind::SumOver(index, _) => {
            let begins = names.iter().any(|n| holds(&index.from, n));
            if begins && !out.iter().any(|s| key::expr(s) == key::expr(e)) {
                out.push(e.clone());
            }
        }
        ExprKind::ProductOver(..) | ExprKind::IntegralOver(..) | ExprKind::Derivative(..) => {}
        _ => parts(e, &mut |part| ranges(part, names, out)),
    }
}

/// The sums up to what holds a power of a number to this name, each once with the number; their members do not hold the name.
fn powers_at_an_end(e: &Expr, n: &str, out: &mut Vec<(Expr, Expr)>) {
    fn base_in(e: &Expr, n: &str) -> Option<Expr> {
        if let ExprKind::Power(base, exponent) = &e.kind
            && natural(base).is_some_and(|b| b >= 2)
            && matches!(&exponent.kind, ExprKind::Name(own) if own == n)
        {
            return Some((**base).clone());
        }
        let mut found = None;
        parts(e, &mut |part| found = found.take().or_else(|| base_in(part, n)));
        found
    }
    if let ExprKind::SumOver(index, body) = &e.kind {
        if let Some(base) = base_in(&index.to, n).filter(|_| !holds(body, n) && !holds(&index.from, n))
            && !out.iter().any(|(s, _)| key::expr(s) == key::expr(e))
        {
            out.push((e.clone(), base));
        }
        return;
    }
    parts(e, &mut |part| powers_at_an_end(part, n, out));
}
