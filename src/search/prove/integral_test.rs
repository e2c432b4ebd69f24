//! Sums between integrals: sum(k = a..b, t(k)) against F(b) − F(a − 1) and F(b + 1) − F(a), for an antiderivative F of t, as in
//! sum(k = 1..n, 1/(n + k)) <= ln(2*n) − ln(n).
//!
//! Method (the integral test of Maclaurin and Cauchy; K. Knopp, "Theory and Application of Infinite Series", 1951, section 176): a
//! falling t(k) lies between F(k + 1) − F(k) and F(k) − F(k − 1), a rising one the other way round. Both are tried, and both again from
//! the second member on, for F may have no value before the first.
//!
//! Certificate: that the bound holds to every end m, by induction on m, in which what else the members hold is a constant; its
//! instance at the end. Neither the antiderivative nor the order of the members is assumed.
//!
//! Limits: one sum in a comparison; from a number.

use super::antiderivatives::antiderivative;
use super::comparison::single;
use super::facts::{minus, opposite};
use super::letters::natural;
use super::limits::plus;
use super::slopes::put_in;
use super::sums::replace;
use super::{Fail, Prover, put};
use crate::certificate::{Label, Rule};
use crate::claim::syntax::*;
use crate::claim::walk::{parts, parts_mut};
use crate::kernel::key;
use crate::kernel::statement::{compare, expr, name, numeral, prop};

impl Prover {
    /// A comparison with a sum, by a bound of the sum that is a difference of antiderivatives.
    pub(super) fn by_integral_test(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("a sum between integrals");
        let (a, relation, b) = single(goal)?;
        let is_greater = relation.is_greater().ok_or_else(no)?;
        if self.inductions > 0 {
            return Err(no());
        }
        let (small, large) = if is_greater { (b, a) } else { (a, b) };
        let difference = minus(small, large);
        let whole = only_sum(&difference).ok_or_else(no)?;
        let is_above = grows_with(&difference, &whole).ok_or_else(no)?;
        let strict = matches!(relation, Relation::Less | Relation::Greater);
        for bound in self.bounds_by_integrals(&whole, is_above) {
            let shown = self.attempt(|c| {
                c.bounded_sum(&whole, &bound, is_above, strict)?;
                let at_end = at_the_end(&whole, &bound)?;
                let [a, b] = [a, b].map(|side| with(side, &whole, &at_end));
                let left = match relation {
                    Relation::Less if bound.is_strict => Relation::LessEqual,
                    Relation::Greater if bound.is_strict => Relation::GreaterEqual,
                    relation => relation,
                };
                c.without_cases(&compare(a, left, b))?;
                c.quietly(goal)
            });
            if shown.is_ok() {
                return shown;
            }
        }
        Err(no())
    }

    /// Bounds of an expression that holds one sum, below and above it, and that they hold for every natural number from 1 on in the
    /// place of a variable.
    pub(super) fn between_integrals(&mut self, e: &Expr, variable: &str) -> Result<([Expr; 2], Vec<Label>), Fail> {
        let no = || Fail::No("a sum between integrals");
        let whole = only_sum(e).ok_or_else(no)?;
        if grows_with(e, &whole) != Some(true) {
            return Err(no());
        }
        let n = self.fresh("n");
        let here = |e: &Expr| put_in(e, variable, &name(&n));
        let from_one = Constraint::Relation(Relation::GreaterEqual, numeral(1));
        let binding = Binding::of(Name::new(&n), true, vec![from_one]);
        let (mut values, mut facts) = (Vec::new(), Vec::new());
        for is_above in [false, true] {
            let relation = if is_above { Relation::LessEqual } else { Relation::GreaterEqual };
            let mut shown = None;
            for bound in self.bounds_by_integrals(&whole, is_above) {
                let value = at_the_end(&whole, &bound)?;
                let goal = compare(here(&whole)?, relation, here(&value)?);
                let every = prop(PropKind::ForAll(vec![binding.clone()], Box::new(goal.clone())));
                let bound = Bound { value: here(&bound.value)?, ..bound };
                let whole = here(&whole)?;
                let fact = self.attempt(|c| {
                    c.block(&every, |c, _| {
                        let label = c.bounded_sum(&whole, &bound, is_above, false)?;
                        c.logic(&[&label], &goal)
                    })
                });
                if let Ok(fact) = fact {
                    shown = Some((value, fact));
                    break;
                }
            }
            let (value, fact) = shown.ok_or_else(no)?;
            values.push(with(e, &whole, &value));
            facts.push(fact);
        }
        let both = values.try_into().map_err(|_| no())?;
        Ok((both, facts))
    }

    /// Shows that the sum to every end has a bound, and that its own end is one.
    fn bounded_sum(&mut self, whole: &Expr, bound: &Bound, is_above: bool, strict: bool) -> Result<Label, Fail> {
        let no = || Fail::No("a bound of a sum");
        let ExprKind::SumOver(index, body) = &whole.kind else { return Err(no()) };
        let m = self.fresh("m");
        let index_to = Index { to: Box::new(name(&m)), ..index.clone() };
        let to_any_end = expr(ExprKind::SumOver(index_to, body.clone()));
        let relation = match (is_above, strict && bound.is_strict) {
            (true, true) => Relation::Less,
            (true, false) => Relation::LessEqual,
            (false, true) => Relation::Greater,
            (false, false) => Relation::GreaterEqual,
        };
        let goal = compare(to_any_end, relation, put_in(&bound.value, &bound.end, &name(&m))?);
        let first = put(&goal, &m, &index.from)?;
        if self.speaks_of_numbers(&first)
            && let Some(denied) = opposite(&first)
            && self.attempt(|c| c.emit(Rule::Evaluate, denied)).is_ok()
        {
            return Err(no());
        }
        let least = (bound.from > 0).then(|| Constraint::Relation(Relation::GreaterEqual, numeral(bound.from)));
        let binding = Binding::of(Name::new(&m), true, least.into_iter().collect());
        let every = prop(PropKind::ForAll(vec![binding], Box::new(goal)));
        let splits = std::mem::replace(&mut self.splits, 0);
        let shown = self.all_by_induction(&every, 3);
        self.splits = splits;
        self.instance(&shown?, &index.to)
    }

    /// The bounds of a sum that antiderivatives propose.
    fn bounds_by_integrals(&mut self, whole: &Expr, is_above: bool) -> Vec<Bound> {
        let ExprKind::SumOver(index, body) = &whole.kind else { return Vec::new() };
        let k = index.name.text.as_str();
        let (Some(from), Some(big_f)) = (natural(&index.from), antiderivative(body, k)) else { return Vec::new() };
        let between =
            |low: Expr, high: Expr| Some(minus(&put_in(&big_f, k, &high).ok()?, &put_in(&big_f, k, &low).ok()?));
        let end = self.fresh("m");
        let here = name(&end);
        let later = plus(&here, numeral(1));
        let first = || put_in(body, k, &index.from).ok();
        let before = from.checked_sub(1);
        let behind = before.and_then(|before| between(numeral(before), here.clone()));
        let ahead = between(numeral(from), later.clone());
        let behind = [behind, first().zip(between(numeral(from), here)).map(|(first, rest)| plus(&first, rest))];
        let ahead = [ahead, first().zip(between(numeral(from + 1), later)).map(|(first, rest)| plus(&first, rest))];
        let both = if is_above { [behind, ahead] } else { [ahead, behind] };
        let mut bounds = Vec::new();
        for [whole, from_second] in both {
            for (value, is_strict) in [(whole, true), (from_second, false)] {
                let Some(mut value) = value else { continue };
                self.tidy(&mut value);
                bounds.push(Bound { end: end.clone(), value, from, is_strict });
            }
        }
        bounds
    }

    /// Leaves out divisors that are 1, and adds up the numbers in arguments.
    fn tidy(&mut self, e: &mut Expr) {
        parts_mut(e, &mut |part| self.tidy(part));
        match &mut e.kind {
            ExprKind::Product(list) => match list.as_slice() {
                [(Factor::Times, only), (Factor::Over, one)] if natural(one) == Some(1) => *e = only.clone(),
                _ => {}
            },
            ExprKind::Apply(_, arguments) => {
                for argument in arguments.iter_mut() {
                    if let (ExprKind::Sum(_), Some(p)) = (&argument.kind, self.letters.polynomial(argument)) {
                        *argument = self.letters.written(&p);
                    }
                }
            }
            _ => {}
        }
    }
}

/// A bound of a sum to its end, which is named, from this end on.
struct Bound {
    end: String,
    value: Expr,
    from: u32,
    /// Whether it is less than the first member there, or greater, and not the same.
    is_strict: bool,
}

/// What a bound is at the sum's own end.
fn at_the_end(whole: &Expr, bound: &Bound) -> Result<Expr, Fail> {
    let ExprKind::SumOver(index, _) = &whole.kind else { return Err(Fail::No("a sum")) };
    put_in(&bound.value, &bound.end, &index.to)
}

/// An expression with a value in the place of a part.
fn with(e: &Expr, part: &Expr, value: &Expr) -> Expr {
    let mut e = e.clone();
    replace(&mut e, part, value);
    e
}

/// The only sum over an index in an expression.
fn only_sum(e: &Expr) -> Option<Expr> {
    let mut found = Vec::new();
    sums_in(e, &mut found);
    if found.len() > 1 { None } else { found.pop() }
}

/// Whether an expression grows with a part of it, or falls, if the factors beside it are positive; nothing where it occurs twice.
fn grows_with(e: &Expr, part: &Expr) -> Option<bool> {
    if key::expr(e) == key::expr(part) {
        return Some(true);
    }
    let holds_it = |e: &Expr| super::sums::occurs(part, e);
    match &e.kind {
        ExprKind::Negate(a) => grows_with(a, part).map(|grows| !grows),
        ExprKind::Sum(list) => {
            let mut with = list.iter().filter(|(_, e)| holds_it(e));
            let ((sign, e), None) = (with.next()?, with.next()) else { return None };
            grows_with(e, part).map(|grows| grows == (*sign == Sign::Plus))
        }
        ExprKind::Product(list) => {
            let mut with = list.iter().filter(|(_, e)| holds_it(e));
            let ((Factor::Times, e), None) = (with.next()?, with.next()) else { return None };
            grows_with(e, part)
        }
        _ => None,
    }
}

/// The sums in an expression, each once, none of which holds another.
fn sums_in(e: &Expr, out: &mut Vec<Expr>) {
    if matches!(e.kind, ExprKind::SumOver(..)) {
        if !out.iter().any(|s| super::sums::occurs(s, e)) {
            out.push(e.clone());
        }
    } else {
        parts(e, &mut |part| sums_in(part, out));
    }
}
