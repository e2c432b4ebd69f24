//! Sums over an index of a term that holds the end of the sum: sum(k = 0..n, binomial(n, k)) = 2^n, by creative telescoping.
//!
//! Method (D. Zeilberger, 1991): for the term F(n, k), `algebra::gosper::recurrence` finds w·F(n, k) + w′·F(n + 1, k) = G(n, k + 1) −
//! G(n, k) with G = R·F. Its sum over k up to m, w·S(n, m) + w′·S(n + 1, m) = G(n, m + 1) − G(n, first), is shown for all m <= n by
//! induction on m. At m = n it gives the step of an induction on n for what is said of the sum. Products whose factors hold n, such as
//! binomial coefficients, are moved from n + 1 to n by laws that an induction on their end shows. So these inductions also show
//! comparisons of products without a sum: binomial(2*n, n) <= 4^n.

use super::hypergeometric::{Factors, Law, moving};
use super::limits::{holds, over, plus};
use super::slopes::put_in;
use super::{Fail, Prover, implies};
use crate::algebra::Polynomial;
use crate::algebra::gcd::gcd;
use crate::algebra::gosper::recurrence;
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::claim::walk::{parts, parts_mut};
use crate::kernel::key;
use crate::kernel::statement::{compare, expr, name, numeral, prop, sum};
use crate::kernel::substitution::Substitution;
use crate::refute::literal::literal;
use malachite::Rational;

/// That a recurrence gives the next sum from 1, 2 or 3 on.
const LATER: [&str; 3] = ["a recurrence from 1 on", "a recurrence from 2 on", "a recurrence from 3 on"];

/// What is known of a sum at n and at n + 1.
struct Step {
    /// own·S(n) + next·S(n + 1) up to n, and what this comes to.
    fact: Label,
    own: Expr,
    next: Expr,
    sum: Expr,
}

impl Prover {
    /// By induction on a natural number n that the factors of a product hold, in the goal or in the term of a sum up to n.
    pub(super) fn by_moving_products(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("a product whose factors hold a natural number");
        if self.inductions > 0 || self.splits > 0 {
            return Err(no());
        }
        let mut sides = Vec::new();
        super::goals::sides_in(goal, &mut sides);
        let moves = |n: &&String| {
            let mut list = Vec::new();
            sides.iter().for_each(|e| moving(e, n, &mut list));
            !list.is_empty()
        };
        let mut variables: Vec<String> = self.naturals.iter().rev().filter(moves).cloned().collect();
        variables.sort_by_key(|n| !sides.iter().any(|e| ends_a_sum(e, n)));
        for n in &variables {
            let shown = match self.on_its_own(|c| c.by_moving_products_with(goal, n)) {
                // What the recurrence does not reach is computed.
                Err(Fail::No(text)) if LATER.contains(&text) => {
                    let start = (1..).zip(LATER).find(|(_, own)| *own == text).map_or(0, |(start, _)| start);
                    let run = &mut |c: &mut Prover| c.by_moving_products_with(goal, n);
                    self.on_its_own(|c| c.begun_later(goal, n, start, run))
                }
                other => other,
            };
            if shown.is_ok() {
                return shown;
            }
        }
        Err(no())
    }

    fn by_moving_products_with(&mut self, goal: &Prop, variable: &str) -> Result<Label, Fail> {
        let mut sides = Vec::new();
        super::goals::sides_in(&super::put(goal, variable, &numeral(self.least(variable).unwrap_or(0)))?, &mut sides);
        sides.iter_mut().for_each(opened);
        for other in self.naturals.clone() {
            sides.iter().try_for_each(|e| self.put_in_reversed(e, &other))?;
        }
        self.counted_from_zero(goal, variable, &mut |c, n, body| {
            c.induction_by(n, None, body, &mut |c, hypothesis, next| c.moved_on(body, hypothesis, next, n))
        })
    }

    /// The next statement from this one.
    fn moved_on(&mut self, body: &Prop, hypothesis: Label, next: &Prop, n: &str) -> Result<Label, Fail> {
        let mut sides = Vec::new();
        super::goals::sides_in(body, &mut sides);
        let (mut sums, mut plain) = (Vec::new(), Vec::new());
        for e in &sides {
            taken_apart(e, n, self, &mut sums, &mut plain);
        }
        let here = Substitution::default();
        for e in &plain {
            for law in self.laws(e, n)? {
                self.put_in_law(&law, &here)?;
            }
        }
        let steps = sums.iter().map(|(index, term)| self.step_of(index, term, n)).collect::<Result<Vec<_>, _>>()?;
        if let ([step], PropKind::Compare(sides, relations)) = (steps.as_slice(), &body.kind)
            && relations.as_slice() == [Relation::Equal]
        {
            // own·S(n) + next·S(n + 1) is known, and S(n) is what the hypothesis says.
            let is_left = key::expr(&sides[0]) == key::expr(&step.sum);
            let part = over(numeral(1), step.next.clone());
            let part = if is_left { part } else { super::facts::negated(part) };
            let rest = super::facts::negated(over(step.own.clone(), step.next.clone()));
            let rest = self.simplified(&rest).unwrap_or(rest);
            let shown = self.without_cases(&compare(step.next.clone(), Relation::NotEqual, numeral(0)));
            if let Err(fail) = shown {
                // It may be 0 at the first numbers alone.
                let last = (0..).zip(LATER).filter(|(j, _)| self.vanishes_at(&step.next, n, *j)).last();
                return Err(last.map_or(fail, |(_, text)| Fail::No(text)));
            }
            let terms = vec![
                Term { facts: vec![step.fact.clone()], factor: part },
                Term { facts: vec![hypothesis], factor: rest },
            ];
            return self.unfolding(next, terms);
        }
        let splits = std::mem::replace(&mut self.splits, 3);
        let shown = self.quietly(next).or_else(|_| self.show(next));
        self.splits = splits;
        shown
    }

    /// Whether an expression is 0 where a variable has this value.
    fn vanishes_at(&mut self, e: &Expr, n: &str, value: u32) -> bool {
        put_in(e, n, &numeral(value)).ok().and_then(|e| self.letters.polynomial(&e)).is_some_and(|p| p.is_zero())
    }

    /// The recurrence of a sum up to n, its laws put in.
    fn step_of(&mut self, index: &Index, term: &Expr, n: &str) -> Result<Step, Fail> {
        let no = || Fail::No("a recurrence for a sum");
        let (k, m) = (index.name.text.as_str(), self.fresh("m"));
        let from = super::letters::natural(&index.from).ok_or_else(no)?;
        let step = self.ratio(term, k).ok_or_else(no)?;
        let next = self.ratio(term, n).ok_or_else(no)?;
        let letter = self.letters.of(&name(k));
        let found = recurrence(&step, &next, letter).ok_or_else(no)?;
        let (own, next) = (self.letters.written(&found.own), self.letters.written(&found.next));
        // G(n, m + 1) = R(m + 1)·F(n, m + 1) is a multiple of F(n, m).
        let moved = |p: &Polynomial, k: &Polynomial| p.substitute(letter, k).ok();
        let after = Polynomial::variable(letter).add(&Polynomial::one());
        let (top, bottom) = &found.certificate;
        let above = moved(top, &after).and_then(|p| p.try_mul(&step.0).ok()).ok_or_else(no)?;
        let below = moved(bottom, &after).and_then(|p| p.try_mul(&step.1).ok()).ok_or_else(no)?;
        let (plain, mut rest) = self.parted(term, k).ok_or_else(no)?;
        rest.insert(0, (Factor::Times, numeral(1)));
        let rest = if rest.len() > 1 { expr(ExprKind::Product(rest)) } else { numeral(1) };
        let (last_above, last_below) = super::hypergeometric::times(&(above, below), &plain).ok_or_else(no)?;
        let last = self.quotient_written(&last_above, &last_below).ok_or_else(no)?;
        let last = put_in(&super::letters::product(vec![last, rest.clone()]), k, &name(&m))?;
        let first = Polynomial::integer(i64::from(from));
        let (top, bottom) = super::hypergeometric::times(&found.certificate, &plain).ok_or_else(no)?;
        let common = gcd(&top, &bottom).map_err(|_| no())?;
        let in_first = |p: &Polynomial| moved(&p.exact_divide(&common)?, &first);
        let (above, below) = (in_first(&top).ok_or_else(no)?, in_first(&bottom).ok_or_else(no)?);
        let first = match (above.is_zero(), below.is_zero()) {
            (_, true) => return Err(no()),
            (true, _) => numeral(0),
            _ => {
                let first = self.quotient_written(&above, &below).ok_or_else(no)?;
                super::letters::product(vec![first, put_in(&rest, k, &index.from)?])
            }
        };
        let later = put_in(term, n, &plus(&name(n), numeral(1)))?;
        let up_to = |to: &Expr, body: &Expr| {
            let index = Index { to: Box::new(to.clone()), ..index.clone() };
            expr(ExprKind::SumOver(index, Box::new(body.clone())))
        };
        let by = |a: &Expr, b: Expr| super::letters::product(vec![a.clone(), b]);
        let to_m = name(&m);
        let left = plus(&by(&own, up_to(&to_m, term)), by(&next, up_to(&to_m, &later)));
        let comes_to = compare(left, Relation::Equal, super::facts::minus(&last, &first));
        let end = (*index.to).clone();
        let within = compare(to_m, Relation::LessEqual, end.clone());
        let laws: Vec<Law> = self.laws(term, n)?.into_iter().chain(self.laws(term, k)?).collect();
        let body = implies(&within, &comes_to);
        let least = (from > 0).then_some(from);
        self.inductions += 1;
        let every = self.induction_by(&m, least, &body, &mut |c, hypothesis, next| {
            c.block(next, |c, _| {
                let PropKind::Implies(_, goal) = &next.kind else { return Err(no()) };
                let within = c.without_cases(&within)?;
                let own = c.logic(&[&hypothesis, &within], &comes_to)?;
                let mut at = Substitution::default();
                at.replace(k, &name(&m));
                laws.iter().try_for_each(|law| c.put_in_law(law, &at))?;
                c.put_in_powers(term, k, &m)?;
                c.unfolding(goal, vec![Term { facts: vec![own], factor: numeral(1) }])
            })
        })?;
        self.inductions -= 1;
        let here = self.instance(&every, &end)?;
        let at_n = super::put(&comes_to, &m, &end)?;
        let fact = self.logic(&[&here], &at_n).or_else(|_| {
            let own = self.without_cases(&super::put(&within, &m, &end)?)?;
            self.logic(&[&here, &own], &at_n)
        })?;
        let mut at = Substitution::default();
        at.replace(k, &end);
        laws.iter().try_for_each(|law| self.put_in_law(law, &at))?;
        self.put_in_reversed(&put_in(term, k, &end)?, n)?;
        Ok(Step { fact, own, next, sum: up_to(&end, term) })
    }

    /// Puts in b^(e - k) = b·b^(e - (k + 1)), for the powers in a term whose exponent falls with the index, at its value.
    fn put_in_powers(&mut self, term: &Expr, k: &str, at: &str) -> Result<(), Fail> {
        let mut powers = Vec::new();
        super::hypergeometric::powers(term, k, &mut powers);
        for (base, exponent) in powers {
            let Some(slope) = self.slope(&exponent, k).filter(|slope| *slope < 0) else { continue };
            let power = |to: &Expr| {
                Ok::<_, Fail>(expr(ExprKind::Power(Box::new(base.clone()), Box::new(put_in(&exponent, k, to)?))))
            };
            let (here, later) = (power(&name(at))?, power(&plus(&name(at), numeral(1)))?);
            let own = super::letters::product(vec![super::letters::whole_power(base.clone(), -slope), later]);
            let label = self.emit(Rule::Power, compare(here, Relation::Equal, own))?;
            self.put_in(&label);
        }
        Ok(())
    }

    /// A combination of facts where the last members of sums and products are taken out.
    fn unfolding(&mut self, goal: &Prop, terms: Vec<Term>) -> Result<Label, Fail> {
        let mut sides = Vec::new();
        super::goals::sides_in(goal, &mut sides);
        for label in terms.iter().flat_map(|term| &term.facts) {
            self.fact(label).iter().for_each(|fact| super::goals::sides_in(fact, &mut sides));
        }
        self.enrich(&sides.iter().collect::<Vec<_>>());
        self.combination(goal.clone(), terms)
    }

    /// A quotient of polynomials in lowest terms; none over 0.
    pub(super) fn quotient_written(&self, above: &Polynomial, below: &Polynomial) -> Option<Expr> {
        if below.is_zero() {
            return None;
        }
        let common = gcd(above, below).ok()?;
        let (above, below) = (above.exact_divide(&common)?, below.exact_divide(&common)?);
        let (number, below) = below.primitive_part();
        let above = self.letters.written(&above.scale(&(Rational::from(1) / number)));
        Some(if below.is_one() { above } else { over(above, self.letters.written(&below)) })
    }

    /// Puts in the products up to n that are others read from their end: the factors of product(i = 1..n, n + 1 - i) are those of n!.
    fn put_in_reversed(&mut self, e: &Expr, n: &str) -> Result<(), Fail> {
        let mut list = Vec::new();
        moving(e, n, &mut list);
        for factors in list {
            let Factors { index, at } = &factors;
            let i = index.name.text.as_str();
            if !ends_after(&index.to, n, self) {
                continue;
            }
            let back = sum(vec![
                (Sign::Plus, (*index.to).clone()),
                (Sign::Plus, (*index.from).clone()),
                (Sign::Minus, name(i)),
            ]);
            let Some(back) = self.letters.polynomial(&put_in(at, i, &back)?) else { continue };
            let back = self.letters.written(&back);
            if !holds(&back, n) {
                let every = self.reversed(&factors, &back, n)?;
                let scaled = self.scaled(&every, &factors, &back, n)?;
                let here = self.instance(&scaled, &name(n))?;
                self.put_in(&here);
            }
        }
        Ok(())
    }

    /// That a product up to n is one whose factors do not hold n, for all n.
    fn reversed(&mut self, factors: &Factors, back: &Expr, n: &str) -> Result<Label, Fail> {
        let j = self.fresh("j");
        let at_j = |e: &Expr| put_in(e, n, &name(&j));
        let index = Index { to: Box::new(at_j(&factors.index.to)?), ..factors.index.clone() };
        let own = Factors { index: index.clone(), at: at_j(&factors.at)? };
        let from_end = Factors { index: index.clone(), at: back.clone() };
        let body = compare(own.product(), Relation::Equal, from_end.product());
        let next = put_in(back, &index.name.text, &plus(&index.to, numeral(1)))?;
        self.inductions += 1;
        let every = self.induction_by(&j, None, &body, &mut |c, hypothesis, goal| {
            let before = std::mem::replace(&mut c.inductions, 1);
            for law in c.laws(&own.product(), &j)? {
                c.put_in_law(&law, &Substitution::default())?;
            }
            c.inductions = before;
            c.unfolding(goal, vec![Term { facts: vec![hypothesis], factor: next.clone() }])
        })?;
        self.inductions -= 1;
        Ok(every)
    }

    /// The statement for all n that a product is another of as many factors, both scaled as the kernel writes the first at n.
    fn scaled(&mut self, every: &str, factors: &Factors, other: &Expr, n: &str) -> Result<Label, Fail> {
        let no = || Fail::No("a scale of factors");
        let written = self.as_written(factors, n, 0)?;
        let i = self.letters.of(&name(&factors.index.name.text));
        let mut slope = |e: &Expr| self.letters.polynomial(e)?.derivative(i).as_constant();
        let own = slope(&factors.at).filter(|q| *q != 0).ok_or_else(no)?;
        let scale = slope(&written.at).ok_or_else(no)? / own;
        let other = Factors { at: super::letters::product(vec![literal(&scale), other.clone()]), ..factors.clone() };
        let j = self.fresh("j");
        let goal = super::put(&compare(written.product(), Relation::Equal, other.product()), n, &name(&j))?;
        let all = prop(PropKind::ForAll(vec![Binding::of(Name::new(&j), true, Vec::new())], Box::new(goal.clone())));
        let Index { from, to, .. } = &factors.index;
        let count = put_in(&super::facts::minus(&plus(to, numeral(1)), from), n, &name(&j))?;
        let factor = expr(ExprKind::Power(Box::new(literal(&scale)), Box::new(count)));
        self.block(&all, |c, _| {
            let same = c.instance(every, &name(&j))?;
            c.combination(goal.clone(), vec![Term { facts: vec![same], factor }])
        })
    }
}

/// Puts in the only member of sums that have one.
fn opened(e: &mut Expr) {
    if let ExprKind::SumOver(index, body) = &e.kind
        && key::expr(&index.from) == key::expr(&index.to)
        && let Ok(only) = put_in(body, &index.name.text, &index.from)
    {
        *e = only;
    }
    parts_mut(e, &mut opened);
}

/// Whether the end of a sum holds n.
fn ends_a_sum(e: &Expr, n: &str) -> bool {
    let mut found = matches!(&e.kind, ExprKind::SumOver(index, _) if holds(&index.to, n));
    parts(e, &mut |part| found |= ends_a_sum(part, n));
    found
}

/// Whether an expression is n and a natural number.
fn ends_after(e: &Expr, n: &str, prover: &mut Prover) -> bool {
    let own = prover.letters.of(&name(n));
    let rest = prover.letters.polynomial(e).map(|p| p.sub(&Polynomial::variable(own)));
    rest.and_then(|rest| rest.as_constant()).is_some_and(|c| c >= 0)
}

/// The sums up to n, or a number more, whose term holds n, each once, and the products beside them.
fn taken_apart(e: &Expr, n: &str, prover: &mut Prover, sums: &mut Vec<(Index, Expr)>, plain: &mut Vec<Expr>) {
    match &e.kind {
        ExprKind::SumOver(index, term) if holds(term, n) && ends_after(&index.to, n, prover) => {
            if !sums.iter().any(|(_, old)| key::expr(old) == key::expr(term)) {
                sums.push((index.clone(), (**term).clone()));
            }
        }
        ExprKind::ProductOver(..) => plain.push(e.clone()),
        _ => parts(e, &mut |part| taken_apart(part, n, prover, sums, plain)),
    }
}
