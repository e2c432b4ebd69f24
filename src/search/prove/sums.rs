//! Sums up to a variable in closed form, by an antidifference of what is summed (`algebra::gosper`). What is summed may hold the
//! variable, as in sum(k = 1..n, k/n): it is then a constant beside an end of its own.

use super::hypergeometric::times;
use super::letters::{natural, total};
use super::limits::holds;
use super::{Fail, Prover};
use crate::algebra::Polynomial;
use crate::algebra::gcd::gcd;
use crate::algebra::gosper::antidifference;
use crate::certificate::Label;
use crate::claim::syntax::*;
use crate::claim::walk::{parts, parts_mut};
use crate::kernel::key;
use crate::kernel::statement::{compare, expr, name, numeral, prop, sum};
use crate::kernel::substitution::Substitution;

/// The largest exponent of a polynomial in the index.
const DEGREE: u32 = 12;

impl Prover {
    /// An expression with closed forms in the place of the sums up to a variable, and the facts that these are equal for
    /// every value of it, shown by induction.
    ///
    /// # Errors
    /// No sum has a closed form that was found.
    pub(crate) fn with_closed_sums(&mut self, e: &Expr, variable: &str) -> Result<(Expr, Vec<Label>), Fail> {
        let mut sums = Vec::new();
        sums_to(e, variable, &mut sums);
        let (mut closed, mut facts) = (e.clone(), Vec::new());
        for s in sums {
            if let Ok((value, fact)) = self.attempt(|c| c.in_closed_form(&s, variable)) {
                replace(&mut closed, &s, &value);
                facts.push(fact);
            }
        }
        if facts.is_empty() { Err(Fail::No("a sum in closed form")) } else { Ok((closed, facts)) }
    }

    /// A comparison with the closed forms of its sums up to natural numbers put in.
    pub(crate) fn by_sums(&mut self, goal: &Prop) -> Result<Label, Fail> {
        if self.inductions > 0 {
            return Err(Fail::No("a comparison outside an induction"));
        }
        let mut sides = Vec::new();
        super::goals::sides_in(goal, &mut sides);
        let whole = sum(sides.into_iter().map(|e| (Sign::Plus, e)).collect());
        let mut any = false;
        for variable in self.naturals.clone() {
            let Ok((_, facts)) = self.with_closed_sums(&whole, &variable) else { continue };
            for fact in facts {
                let here = self.instance(&fact, &name(&variable))?;
                self.put_in(&here);
                any = true;
            }
        }
        if any { self.quietly(goal) } else { Err(Fail::No("a sum in closed form")) }
    }

    /// What a sum comes to, and the fact that it does so for every value of the variable that it ends at.
    fn in_closed_form(&mut self, s: &Expr, variable: &str) -> Result<(Expr, Label), Fail> {
        let ExprKind::SumOver(index, body) = &s.kind else { return Err(Fail::No("a sum")) };
        let is_early = natural(&index.from).is_some_and(|from| from <= 1);
        if is_early && matches!(index.to.kind, ExprKind::Name(_)) && !holds(body, variable) {
            let value = self.closed_sum(s, variable).ok_or(Fail::No("a closed form"))?;
            let fact = self.is_closed_form(s, &value, variable)?;
            return Ok((value, fact));
        }
        self.with_another_end(index, body, variable)
    }

    /// The same for a sum that holds the variable besides as its end, or begins later: first to any end, while the variable stands for
    /// a constant.
    fn with_another_end(&mut self, index: &Index, body: &Expr, variable: &str) -> Result<(Expr, Label), Fail> {
        let (end, k) = (self.fresh("m"), self.fresh("k"));
        let to_end = Index { to: Box::new(name(&end)), ..index.clone() };
        let other = expr(ExprKind::SumOver(to_end, Box::new(body.clone())));
        let value = self.closed_sum(&other, &end).ok_or(Fail::No("a closed form"))?;
        let put = |e: &Expr, old: &str, new: &Expr| super::slopes::put_in(e, old, new);
        let here = name(&k);
        let whole = expr(ExprKind::SumOver(index.clone(), Box::new(body.clone())));
        let own_end = put(&index.to, variable, &here)?;
        let own_value = put(&value, &end, &index.to)?;
        let goal = compare(put(&whole, variable, &here)?, Relation::Equal, put(&own_value, variable, &here)?);
        let (other, value) = (put(&other, variable, &here)?, put(&value, variable, &here)?);
        // A divisor may need the variable to be other than 0. The kernel takes it out of a sum from a to m + a, and of none that may be
        // empty.
        let has_divisor = divides(body, variable);
        let (first, least) = match natural(&index.from) {
            Some(from) => {
                let first = if has_divisor { from } else { from.saturating_sub(1) };
                (numeral(first), (first > 0).then(|| numeral(first)))
            }
            None => ((*index.from).clone(), Some((*index.from).clone())),
        };
        let least = least.filter(|_| has_divisor || matches!(index.to.kind, ExprKind::Name(_)));
        let later = sum(vec![(Sign::Plus, name(&end)), (Sign::Plus, first.clone())]);
        let (other, value) = (put(&other, &end, &later)?, put(&value, &end, &later)?);
        let own_end = super::facts::minus(&own_end, &first);
        let bound = least.map(|least| Constraint::Relation(Relation::GreaterEqual, least));
        let binding = Binding::of(Name::new(&k), true, bound.into_iter().collect());
        let every = prop(PropKind::ForAll(vec![binding], Box::new(goal.clone())));
        let splits = std::mem::replace(&mut self.splits, 9);
        let shown = self.on_its_own(|c| {
            c.block(&every, |c, _| {
                let to_any_end = c.is_closed_form(&other, &value, &end)?;
                let label = c.instance(&to_any_end, &own_end)?;
                c.logic(&[&label], &goal).or_else(|_| c.quietly(&goal))
            })
        });
        self.splits = splits;
        Ok((own_value, shown?))
    }

    /// Shows that a sum has this value for every value of the variable.
    pub(super) fn is_closed_form(&mut self, s: &Expr, value: &Expr, variable: &str) -> Result<Label, Fail> {
        let k = self.fresh("k");
        let at = |e: &Expr| super::slopes::put_in(e, variable, &name(&k));
        let body = compare(at(s)?, Relation::Equal, at(value)?);
        let every = prop(PropKind::ForAll(vec![Binding::of(Name::new(&k), true, Vec::new())], Box::new(body)));
        let splits = std::mem::replace(&mut self.splits, 0);
        let shown = self.all_by_induction(&every, 3);
        self.splits = splits;
        shown
    }

    /// What a sum to a variable n comes to, as a whole or term by term.
    pub(super) fn closed_sum(&mut self, s: &Expr, variable: &str) -> Option<Expr> {
        let ExprKind::SumOver(index, body) = &s.kind else { return None };
        let from = &*index.from;
        if holds(from, variable) {
            return None;
        }
        if let Some(value) = self.telescoped(&index.name.text, body, from, variable) {
            return Some(value);
        }
        let ExprKind::Sum(list) = &body.kind else { return None };
        let parts = list.iter().map(|(sign, e)| Some((*sign, self.telescoped(&index.name.text, e, from, variable)?)));
        parts.collect::<Option<Vec<_>>>().map(total)
    }

    /// Σ t(i) for i = from … n, as T(n + 1) − T(from) for an antidifference T of t; where it begins at 0, from 1 on, and t(0).
    fn telescoped(&mut self, index: &str, body: &Expr, from: &Expr, variable: &str) -> Option<Expr> {
        let i = self.letters.of(&name(index));
        let (plain, rest) = self.parted(body, index)?;
        let (above, below) = self.ratio(body, index)?;
        let (top, bottom) = times(&antidifference(&above, &below, i)?, &plain)?;
        let common = gcd(&top, &bottom).ok()?;
        let (top, bottom) = (top.exact_divide(&common)?, bottom.exact_divide(&common)?);
        let mut whole = vec![(Factor::Times, self.letters.written(&top))];
        whole.extend(rest);
        if !bottom.is_one() {
            whole.push((Factor::Over, self.letters.written(&bottom)));
        }
        let whole = match whole.as_slice() {
            [(_, one)] => one.clone(),
            _ => expr(ExprKind::Product(whole)),
        };
        let at = |e: &Expr, place: &Expr| {
            let mut map = Substitution::default();
            map.replace(index, place);
            map.expr(e).ok()
        };
        let after = sum(vec![(Sign::Plus, name(variable)), (Sign::Plus, numeral(1))]);
        let begins_at_0 = natural(from) == Some(0);
        let first = if begins_at_0 { numeral(1) } else { from.clone() };
        let mut parts = vec![(Sign::Plus, at(&whole, &after)?), (Sign::Minus, at(&whole, &first)?)];
        if begins_at_0 {
            parts.push((Sign::Plus, at(body, &numeral(0))?));
        }
        Some(sum(parts))
    }

    /// A quotient of polynomials in the index, with letters that do not depend on it.
    pub(super) fn quotient(&mut self, e: &Expr, index: &str) -> Option<Quotient> {
        let times = |a: &Polynomial, b: &Polynomial| a.try_mul(b).ok();
        Some(match &e.kind {
            ExprKind::Negate(a) => {
                let (above, below) = self.quotient(a, index)?;
                (above.neg(), below)
            }
            ExprKind::Sum(list) => {
                let mut all = (Polynomial::zero(), Polynomial::one());
                for (sign, e) in list {
                    let (above, below) = self.quotient(e, index)?;
                    let above = times(&if *sign == Sign::Plus { above } else { above.neg() }, &all.1)?;
                    all = (times(&all.0, &below)?.add(&above), times(&all.1, &below)?);
                }
                all
            }
            ExprKind::Product(list) => {
                let mut all = (Polynomial::one(), Polynomial::one());
                for (f, e) in list {
                    let (above, below) = self.quotient(e, index)?;
                    let (above, below) = if *f == Factor::Over { (below, above) } else { (above, below) };
                    all = (times(&all.0, &above)?, times(&all.1, &below)?);
                }
                all
            }
            ExprKind::Power(base, exponent) if natural(exponent).is_some_and(|k| k <= DEGREE) => {
                let (above, below) = self.quotient(base, index)?;
                let k = natural(exponent)?;
                (above.pow(k).ok()?, below.pow(k).ok()?)
            }
            kind if !matches!(kind, ExprKind::Name(_)) && holds(e, index) => return None,
            _ => (self.letters.polynomial(e)?, Polynomial::one()),
        })
    }
}

/// A polynomial over another.
pub(super) type Quotient = (Polynomial, Polynomial);

/// Whether an expression divides by what holds a variable.
fn divides(e: &Expr, variable: &str) -> bool {
    let mut found = match &e.kind {
        ExprKind::Product(list) => list.iter().any(|(how, e)| *how == Factor::Over && holds(e, variable)),
        _ => false,
    };
    parts(e, &mut |part| found |= divides(part, variable));
    found
}

/// The sums up to a variable, or up to a number more or less.
fn sums_to(e: &Expr, variable: &str, out: &mut Vec<Expr>) {
    let is_end = |e: &Expr| match &e.kind {
        ExprKind::Name(n) => n == variable,
        ExprKind::Sum(_) => holds(e, variable),
        _ => false,
    };
    if let ExprKind::SumOver(index, _) = &e.kind
        && is_end(&index.to)
    {
        if !out.iter().any(|s| key::expr(s) == key::expr(e)) {
            out.push(e.clone());
        }
        return;
    }
    parts(e, &mut |part| sums_to(part, variable, out));
}

/// Whether an expression occurs in another.
pub(super) fn occurs(part: &Expr, e: &Expr) -> bool {
    fn within(key: &str, e: &Expr) -> bool {
        let mut found = key::expr(e) == key;
        parts(e, &mut |part| found |= within(key, part));
        found
    }
    within(&key::expr(part), e)
}

/// Puts a value in the place of an expression.
pub(super) fn replace(e: &mut Expr, old: &Expr, value: &Expr) {
    if key::expr(e) == key::expr(old) {
        *e = value.clone();
    } else {
        parts_mut(e, &mut |part| replace(part, old, value));
    }
}

/// The outermost sums over an index that fits, each once.
pub(super) fn sums_where(e: &Expr, fits: &dyn Fn(&Index) -> bool, out: &mut Vec<Expr>) {
    match &e.kind {
        ExprKind::SumOver(index, _) => {
            if fits(index) && !out.iter().any(|s| key::expr(s) == key::expr(e)) {
                out.push(e.clone());
            }
        }
        ExprKind::ProductOver(..) | ExprKind::IntegralOver(..) | ExprKind::Derivative(..) => {}
        _ => parts(e, &mut |part| sums_where(part, fits, out)),
    }
}
