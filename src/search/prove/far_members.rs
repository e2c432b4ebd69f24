//! That members of a family beyond every bound exist: `exists k natural: k > a`, `exists k natural: r^k < a` for a > 0.
//!
//! Method: if all members F(k) are at least a > 0, the constant a lies between 0 and F(k), and if F(k) has the limit 0, so has a; the
//! rule `limit` says that it has not. Where F grows, this is said of 1/a and 1/F(k).

use super::limits::over;
use super::slopes::put_in;
use super::{Fail, Prover, implies};
use crate::certificate::{Label, Rule};
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, name, numeral, prop};

/// Members on one side of a bound.
struct Members {
    /// The natural number that a member belongs to.
    index: String,
    member: Expr,
    bound: Expr,
    /// Whether they are to be above the bound.
    above: bool,
    /// The order of a member and the bound that the goal denies.
    order: Relation,
}

impl Prover {
    /// Proves `exists` of one natural number by a limit.
    pub(super) fn by_far_members(&mut self, goal: &Prop, bindings: &[Binding], body: &Prop) -> Result<Label, Fail> {
        let members = members(bindings, body).ok_or(Fail::No("members beyond a bound"))?;
        if self.inductions > 0 || self.splits >= 8 {
            return Err(Fail::No("effort left"));
        }
        let sign = self.signs_of(&members.bound);
        if sign.within(Signs::POSITIVE) {
            return self.beyond_a_positive_bound(goal, &members);
        }
        if !members.above {
            return Err(Fail::No("a positive bound"));
        }
        let mut from = Vec::new();
        for relation in [Relation::LessEqual, Relation::Greater] {
            let case = compare(members.bound.clone(), relation, numeral(0));
            from.push(self.block(&implies(&case, goal), |c, _| match relation {
                Relation::Greater => c.beyond_a_positive_bound(goal, &members),
                _ => c.by_values(goal, bindings, body, vec![(members.index.clone(), numeral(1))]),
            })?);
        }
        self.emit(Rule::Logic { from }, goal.clone())
    }

    fn beyond_a_positive_bound(&mut self, goal: &Prop, members: &Members) -> Result<Label, Fail> {
        let denied = prop(PropKind::Not(Box::new(goal.clone())));
        let block = self.block(&implies(&denied, goal), |c, block| {
            let all = c.all_within(goal, members, &format!("{block}s"))?;
            let absurd = c.against_the_limit(members, &all)?;
            c.logic(&[&absurd], goal)
        })?;
        self.logic(&[&block], goal)
    }

    /// That all members are on the other side of the bound, since none is beyond it.
    fn all_within(&mut self, goal: &Prop, members: &Members, none: &str) -> Result<Label, Fail> {
        let PropKind::Exists(bindings, body) = &goal.kind else { return Err(Fail::No("what exists")) };
        let k = self.fresh("k");
        let here = put_in(&members.member, &members.index, &name(&k))?;
        let within = compare(here, members.order, members.bound.clone());
        let binding = Binding::of(Name::new(&k), true, Vec::new());
        self.block(&prop(PropKind::ForAll(vec![binding], Box::new(within.clone()))), |c, _| {
            let block = c.against_opposite(&within, |c, _| {
                let some = c.by_values(goal, bindings, body, vec![(members.index.clone(), name(&k))])?;
                c.logic(&[none, &some], &within)
            })?;
            Ok(block)
        })
    }

    /// A contradiction: the bound, or 1 over it, has the limit 0 and has not.
    fn against_the_limit(&mut self, members: &Members, all: &str) -> Result<Label, Fail> {
        let n = self.fresh("n");
        let member = put_in(&members.member, &members.index, &name(&n))?;
        let part = |e: Expr| if members.above { over(numeral(1), e) } else { e };
        let (of, upper) = (part(members.bound.clone()), part(member));
        let limit = Limit { of, variable: Name::new(&n), value: numeral(0) };
        let falls = prop(PropKind::Limit(Box::new(limit.clone())));
        let absurd = compare(numeral(0), Relation::Greater, numeral(0));
        let binding = Binding::of(Name::new(&n), true, Vec::new());
        let every = prop(PropKind::ForAll(vec![binding], Box::new(absurd.clone())));
        let all_absurd = self.block(&every, |c, _| {
            let bounds = [&numeral(0), &upper];
            let shown = c.squeeze(&falls, &limit, bounds, &numeral(1), &mut |c, k, every, body| {
                c.block(every, |c, _| {
                    c.instance(all, k)?;
                    c.show(body)
                })
            })?;
            let does_not = c.emit(Rule::Limit { with: Vec::new() }, prop(PropKind::Not(Box::new(falls.clone()))))?;
            c.logic(&[&shown, &does_not], &absurd)
        })?;
        self.instance(&all_absurd, &numeral(0))
    }
}

/// A comparison of a member, which the one bound natural number is in, with a bound free of it.
fn members(bindings: &[Binding], body: &Prop) -> Option<Members> {
    let [Binding { names, natural: true, constraints, .. }] = bindings else { return None };
    let ([(k, None)], true) = (names.as_slice(), constraints.is_empty()) else { return None };
    let (a, relation, b) = body.single()?;
    let holds = |e: &Expr| super::limits::holds(e, &k.text);
    let (member, bound, relation) = match (holds(a), holds(b)) {
        (true, false) => (a, b, relation),
        (false, true) => (b, a, relation.turned()),
        _ => return None,
    };
    Some(Members {
        index: k.text.clone(),
        member: member.clone(),
        bound: bound.clone(),
        above: relation.is_greater()?,
        order: relation.negated(),
    })
}
