//! Members of sequences inside any comparison, in closed form: for u(0) = c and u(k + 1) = a·u(k) + b, with a and b without k, u(k) is
//! (c − b/(1 − a))·a^k + b/(1 − a), or c + k·b where a is 1. For s(k + 1) = s(k) + b(k), where b(k) holds members of sequences defined
//! before it, s(k) is the sum of their closed forms.
//!
//! Method: the closed form is shown for all k by induction, and put in for each member of the goal; sums and products over an index are
//! equal where their members are. What is left says nothing of the sequence, and is shown as any other goal.
//!
//! Limits: [`SEQUENCES`].

use super::facts::minus;
use super::letters::{product, summands_of, total};
use super::limits::{holds, over, plus};
use super::slopes::put_in;
use super::{Fail, Prover};
use crate::certificate::{Label, Rule};
use crate::claim::syntax::*;
use crate::claim::walk::{parts, parts_mut};
use crate::kernel::key;
use crate::kernel::statement::{Sequence, apply, compare, expr, name, numeral, power, prop};

/// The most sequences whose closed forms are put in for one goal.
const SEQUENCES: usize = 4;

/// What a sequence is for every index.
struct Closed {
    sequence: String,
    /// A name for the index, and the value in it.
    index: String,
    value: Expr,
    /// The fact that it is so.
    every: Label,
}

impl Prover {
    /// Shows a comparison with closed forms in the place of members of sequences.
    pub(super) fn by_members_in_closed_form(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("members with a closed form");
        let PropKind::Compare(sides, relations) = &goal.kind else { return Err(no()) };
        let sequences = self.checker.statement().sequences.clone();
        if sequences.is_empty() || self.inductions > 0 || self.splits > 2 {
            return Err(no());
        }
        // Of one member alone an induction shows what it is, where its step holds no others.
        let looks_aside = |u: &Sequence| sequences.iter().any(|w| w.name != u.name && holds_member(&u.step, &w.name));
        let is_alone = |u: &Sequence| !looks_aside(u) && sides.iter().any(|e| is_member(e, &u.name));
        if *relations == [Relation::Equal] && sequences.iter().any(is_alone) {
            return Err(no());
        }
        let mut occurring: Vec<&Sequence> = Vec::new();
        for u in sequences.iter().rev() {
            let steps = occurring.iter().map(|later| &later.step);
            if sides.iter().chain(steps).any(|e| holds_member(e, &u.name)) {
                occurring.push(u);
            }
        }
        if occurring.is_empty() || occurring.len() > SEQUENCES {
            return Err(no());
        }
        let mut all = Vec::new();
        for u in occurring.into_iter().rev() {
            let closed = self.closed_form(u, &all)?;
            all.push(closed);
        }
        let (mut changed, mut labels) = (goal.clone(), Vec::new());
        if let PropKind::Compare(sides, _) = &mut changed.kind {
            for e in sides {
                self.with_closed_members(e, &all, &mut labels)?;
            }
        }
        let shown = self.on_its_own(|c| c.show(&changed))?;
        labels.iter().for_each(|label| self.put_in(label));
        self.combination(goal.clone(), vec![super::facts::scaled(&shown, numeral(1))])
    }

    /// The closed form of a sequence, shown by induction; those of the sequences that its step holds are put in.
    fn closed_form(&mut self, u: &Sequence, before: &[Closed]) -> Result<Closed, Fail> {
        let no = || Fail::No("a linear recurrence");
        let k = self.fresh("k");
        let own = apply(&u.name, name(&k));
        let (mut own_step, mut used) = (u.step.clone(), Vec::new());
        in_closed_form(&mut own_step, before, &mut used)?;
        if used.is_empty() {
            let value = self.member_at(u, &name(&k)).ok_or_else(no)?;
            let every = self.is_closed_form(&own, &value, &k)?;
            return Ok(Closed { sequence: u.name.clone(), index: k, value, every });
        }
        let alone = Sequence { step: own_step, ..u.clone() };
        let value = self.member_at(&alone, &name(&k)).or_else(|| self.summed(&alone, &k)).ok_or_else(no)?;
        self.inductions += 1;
        let every = self.induction_by(&k, None, &compare(own, Relation::Equal, value.clone()), &mut |c, _, next| {
            for (every, at) in &used {
                let here = c.instance(every, &put_in(at, &u.index, &name(&k))?)?;
                c.put_in(&here);
            }
            c.without_cases(next)
        })?;
        self.inductions -= 1;
        Ok(Closed { sequence: u.name.clone(), index: k, value, every })
    }

    /// u(0) + b(0) + … + b(k − 1) in closed form, where the step adds b.
    fn summed(&mut self, u: &Sequence, k: &str) -> Option<Expr> {
        let mut terms = Vec::new();
        summands_of(&u.step, Sign::Plus, &mut terms);
        let own = key::expr(&apply(&u.name, name(&u.index)));
        let place = terms.iter().position(|(sign, e)| *sign == Sign::Plus && key::expr(e) == own)?;
        terms.remove(place);
        let added = total(terms);
        if holds_member(&added, &u.name) {
            return None;
        }
        let last = put_in(&added, &u.index, &name(k)).ok()?;
        let index = Index { name: Name::new(&u.index), from: Box::new(numeral(0)), to: Box::new(name(k)) };
        let to_last = self.closed_sum(&super::values::over(true, index, &added), k)?;
        Some(minus(&plus(&u.initial, to_last), &last))
    }

    /// What the member of a linear recurrence with this index is.
    pub(super) fn member_at(&mut self, u: &Sequence, at: &Expr) -> Option<Expr> {
        let (a, b) = linear(&u.step, u)?;
        let first = u.initial.clone();
        let times = |e: Expr| product(vec![e, power(&a, at)]);
        let Some(b) = b else { return Some(times(first)) };
        if self.is_one(&a) {
            return Some(plus(&first, product(vec![b, at.clone()])));
        }
        let rest = minus(&numeral(1), &a);
        self.nonzero(&rest);
        let fixed = over(b, rest);
        Some(plus(&times(minus(&first, &fixed)), fixed))
    }

    /// Puts closed forms in an expression, and adds the facts that say what they stand for.
    fn with_closed_members(&mut self, e: &mut Expr, all: &[Closed], labels: &mut Vec<Label>) -> Result<(), Fail> {
        if let Some((every, at)) = put_closed_form(e, all)? {
            labels.push(self.instance(every, &at)?);
            return Ok(());
        }
        if !all.iter().any(|closed| holds_member(e, &closed.sequence)) {
            return Ok(());
        }
        match &e.kind {
            ExprKind::SumOver(index, body) | ExprKind::ProductOver(index, body) => {
                let is_sum = matches!(e.kind, ExprKind::SumOver(..));
                let k = self.fresh("k");
                let own = put_in(body, &index.name.text, &name(&k))?;
                let (mut closed, mut used) = (own.clone(), Vec::new());
                in_closed_form(&mut closed, all, &mut used)?;
                let binding = Binding::of(Name::new(&k), true, Vec::new());
                let equal = |closed: &Expr| compare(own.clone(), Relation::Equal, closed.clone());
                let every = prop(PropKind::ForAll(vec![binding], Box::new(equal(&closed))));
                let from = self.block(&every, |c, _| {
                    let labels: Result<Vec<Label>, Fail> =
                        used.iter().map(|(every, at)| c.instance(every, at)).collect();
                    labels?.iter().for_each(|label| c.put_in(label));
                    c.combination(equal(&closed), Vec::new())
                })?;
                let closed = put_in(&closed, &k, &name(&index.name.text))?;
                let whole = super::values::over(is_sum, index.clone(), &closed);
                let label = self.emit(Rule::Termwise { from }, compare(e.clone(), Relation::Equal, whole.clone()))?;
                labels.push(label);
                *e = whole;
                Ok(())
            }
            ExprKind::IntegralOver(..) | ExprKind::Derivative(..) => Err(Fail::No("a member outside of integrals")),
            _ => {
                let mut done = Ok(());
                parts_mut(e, &mut |part| {
                    if done.is_ok() {
                        done = self.with_closed_members(part, all, labels);
                    }
                });
                done
            }
        }
    }
}

/// Puts its closed form in the place of a member, and returns the fact that says so with the member's index.
fn put_closed_form<'a>(e: &mut Expr, all: &'a [Closed]) -> Result<Option<(&'a Label, Expr)>, Fail> {
    let Some(closed) = all.iter().find(|closed| is_member(e, &closed.sequence)) else { return Ok(None) };
    let ExprKind::Apply(_, at) = &e.kind else { return Ok(None) };
    let [at] = at.as_slice() else { return Ok(None) };
    let at = at.clone();
    *e = put_in(&closed.value, &closed.index, &at)?;
    Ok(Some((&closed.every, at)))
}

/// Puts closed forms in the place of members that stand in no sum, product, integral or derivative, and notes those that it used.
fn in_closed_form<'a>(e: &mut Expr, all: &'a [Closed], used: &mut Vec<(&'a Label, Expr)>) -> Result<(), Fail> {
    if let Some(one) = put_closed_form(e, all)? {
        used.push(one);
        return Ok(());
    }
    match &e.kind {
        ExprKind::SumOver(..) | ExprKind::ProductOver(..) | ExprKind::IntegralOver(..) | ExprKind::Derivative(..)
            if all.iter().any(|closed| holds_member(e, &closed.sequence)) =>
        {
            Err(Fail::No("a member under one index"))
        }
        _ => {
            let mut done = Ok(());
            parts_mut(e, &mut |part| {
                if done.is_ok() {
                    done = in_closed_form(part, all, used);
                }
            });
            done
        }
    }
}

fn is_member(e: &Expr, sequence: &str) -> bool {
    matches!(&e.kind, ExprKind::Apply(f, at) if f.text == sequence && at.len() == 1)
}

fn holds_member(e: &Expr, sequence: &str) -> bool {
    let mut found = is_member(e, sequence);
    parts(e, &mut |part| found |= holds_member(part, sequence));
    found
}

/// A step as a·u(k) + b, with no b where there is none: a and b hold neither the index nor a member.
fn linear(e: &Expr, u: &Sequence) -> Option<(Expr, Option<Expr>)> {
    let own = key::expr(&apply(&u.name, name(&u.index)));
    let is_own = |e: &Expr| key::expr(e) == own;
    let is_constant = |e: &Expr| !holds(e, &u.index) && !holds_member(e, &u.name);
    match &e.kind {
        _ if is_own(e) => Some((numeral(1), None)),
        ExprKind::Negate(inner) => {
            let (a, b) = linear(inner, u)?;
            let negated = super::facts::negated;
            Some((negated(a), b.map(negated)))
        }
        ExprKind::Sum(list) => {
            let (mut of_member, mut rest) = (Vec::new(), Vec::new());
            for (sign, e) in list {
                if is_constant(e) {
                    rest.push((*sign, e.clone()));
                    continue;
                }
                let (a, b) = linear(e, u)?;
                of_member.push((*sign, a));
                rest.extend(b.map(|b| (*sign, b)));
            }
            let all = |terms: Vec<(Sign, Expr)>| (!terms.is_empty()).then(|| total(terms));
            Some((all(of_member)?, all(rest)))
        }
        ExprKind::Product(list) => {
            let mut moving = list.iter().filter(|(_, e)| !is_constant(e));
            let (Some((Factor::Times, inner)), None) = (moving.next(), moving.next()) else { return None };
            let (a, b) = linear(inner, u)?;
            let times = |e: Expr| {
                let others: Vec<(Factor, Expr)> = list.iter().filter(|(_, e)| is_constant(e)).cloned().collect();
                match others.as_slice() {
                    [(Factor::Times, only)] if e == numeral(1) => only.clone(),
                    [(Factor::Times, _), ..] if e == numeral(1) => expr(ExprKind::Product(others)),
                    _ => expr(ExprKind::Product([(Factor::Times, e)].into_iter().chain(others).collect())),
                }
            };
            Some((times(a), b.map(times)))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_step_is_read_as_a_factor_and_a_summand_where_neither_moves() {
        let read = |step: &str| {
            let text = format!(
                "claim t \"t\"\ngiven b, c > 0; n natural\ndefine u by u(0) = 1, u(k + 1) = {step}\nprove u(n) = u(n)\n"
            );
            let claims = crate::claim::parse::parse(&text).expect("a claim");
            let checker = crate::kernel::Checker::new(&claims[0], &[]).expect("a statement");
            let said = |e: &Expr| crate::claim::print::expr(e);
            let (a, rest) = linear(&checker.statement().sequences[0].step, &checker.statement().sequences[0])?;
            Some((said(&a), rest.as_ref().map_or_else(String::new, said)))
        };
        let parts = |a: &str, b: &str| Some((a.to_string(), b.to_string()));
        assert_eq!(read("2*u(k) + 3"), parts("2", "3"));
        assert_eq!(read("u(k)/3"), parts("1/3", ""));
        assert_eq!(read("(b*u(k) + c)/(b + c)"), parts("b/(b + c)", "c/(b + c)"));
        assert_eq!(read("b - (u(k) - c)"), parts("-1", "b - (-c)"));
        for step in ["k*u(k)", "u(k)*u(k)", "1/u(k)", "u(k) + k", "u(k)^2", "b"] {
            assert_eq!(read(step), None, "{step}");
        }
    }
}
