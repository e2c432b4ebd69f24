//! What holds from some number on: `exists N …: for all k >= N: l < r`, by a limit and the rule `eventually`; also with a
//! number C to be found besides, `abs(f) <= C*g`.
//!
//! Method, for F = r − l: the limit of a side where the other one does not move; bounds of what is inside an absolute value;
//! the limit of F over its leading power of the variable (`asymptotic_bounds`); the limit of one side over the other. Each
//! limit gives a number from which on something simple holds. For N the sum of these numbers is taken, and C is greater than
//! the limit of f/g.

use super::asymptotic_form::raised;
use super::expansion_steps::Remainder;
use super::facts::{minus, negated, scaled};
use super::letters::{as_power, natural, product, whole_power};
use super::limits::{holds, over};
use super::slopes::put_in;
use super::{Fail, Prover, implies, put};
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::claim::walk::parts_mut;
use crate::kernel::key;
use crate::kernel::order::Signs;
use crate::kernel::statement::{apply, compare, domain, expr, name, numeral, prop, sum};
use crate::kernel::substitution::Substitution;
use crate::refute::literal::literal;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::{Abs, Ceiling};
use malachite::base::num::basic::traits::One;

/// From where on the values of an expression are asked for, if not from where the goal says.
const STARTS: [u32; 3] = [1, 4, 100];

/// A statement about all numbers from one on.
pub(crate) struct Eventual {
    /// The number from which on, as it is declared.
    pub start: Binding,
    /// A number that is to be found besides.
    pub factor: Option<Binding>,
    /// The number that grows.
    pub index: String,
    /// Whether it is natural.
    pub natural: bool,
    /// What holds of it.
    pub pairs: Vec<(Expr, Relation, Expr)>,
}

impl Eventual {
    /// Whether what is to be found has lower bounds only, and the factor is real.
    fn is_free(&self) -> bool {
        let below = |c: &Constraint| matches!(c, Constraint::Relation(Relation::Greater | Relation::GreaterEqual, _));
        let mut sought = [Some(&self.start), self.factor.as_ref()].into_iter().flatten();
        sought.all(|b| b.constraints.iter().all(below)) && !self.factor.as_ref().is_some_and(|b| b.natural)
    }

    /// Whether a multiple of a number is to be found that bounds something.
    fn is_within_a_number(&self) -> bool {
        self.factor.is_some()
            && matches!(self.pairs.as_slice(), [(l, _, r)] if !(holds(l, &self.index) && holds(r, &self.index)))
    }
}

/// What a limit says from some number on, and how it gives a comparison there.
struct Stage {
    /// What has the limit, as it stands in the goal.
    side: Expr,
    /// That it lies above or below what does not move.
    chain: Prop,
    /// The same with the variable that grows, and its limit.
    of: Expr,
    limit: Expr,
    how: How,
}

/// How a comparison follows.
enum How {
    /// It is this one.
    AtOnce,
    /// Times what is positive.
    Times(Expr),
    /// It follows from this comparison, in which absolute values are written without their signs, which follows in this way.
    Unsigned(Prop, Box<How>),
    /// |f| < C·|g|, for −C < f/g < C.
    Inside { f: Expr, g: Expr },
    /// The same, or f < C·g, for what is left of f/g near infinity.
    Left { left: Box<Remainder>, how: Box<How> },
}

impl Prover {
    /// Proves that something holds from some number on.
    pub(super) fn by_eventually(&mut self, goal: &Prop, bindings: &[Binding], body: &Prop) -> Result<Label, Fail> {
        let eventual = eventual(bindings, body).ok_or(Fail::No("what holds from some number on"))?;
        if self.splits >= 3 || self.inductions > 0 {
            return Err(Fail::No("effort left"));
        }
        if !eventual.is_free() {
            return Err(Fail::No("numbers that may be as great as need be"));
        }
        if eventual.is_within_a_number()
            && let Ok(label) = self.attempt(|c| c.bounded_by_itself(goal, bindings, body))
        {
            return Ok(label);
        }
        if eventual.natural
            && let Ok(label) = self.on_its_own(|c| c.eventually_in_closed_form(goal, bindings, body))
        {
            return Ok(label);
        }
        // What holds for all large real numbers holds for the natural ones.
        let mut shown = self.attempt(|c| c.as_x_grows(goal, &eventual, false));
        if shown.is_err() && eventual.natural {
            shown = self.attempt(|c| c.as_x_grows(goal, &eventual, true));
        }
        shown
    }

    /// The same where sums up to the number that grows have closed forms, which the same numbers then serve.
    fn eventually_in_closed_form(&mut self, goal: &Prop, bindings: &[Binding], body: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("a sum up to the number that grows");
        let PropKind::ForAll(over, inner) = &body.kind else { return Err(no()) };
        let [Binding { names, .. }] = over.as_slice() else { return Err(no()) };
        let ([(index, None)], PropKind::Compare(sides, relations)) = (names.as_slice(), &inner.kind) else {
            return Err(no());
        };
        let (mut plain, mut facts) = (Vec::new(), Vec::new());
        for side in sides {
            match self.with_closed_sums(side, &index.text) {
                Ok((value, own)) => {
                    plain.push(value);
                    facts.extend(own);
                }
                Err(_) => plain.push(side.clone()),
            }
        }
        if facts.is_empty() {
            return Err(no());
        }
        let plain = prop(PropKind::Compare(plain, relations.clone()));
        let plain = prop(PropKind::ForAll(over.clone(), Box::new(plain)));
        let some = prop(PropKind::Exists(bindings.to_vec(), Box::new(plain.clone())));
        let some = self.by_eventually(&some, bindings, &plain)?;
        // The names of the goal were in use.
        let (mut map, mut own, mut with) = (Substitution::default(), bindings.to_vec(), Vec::new());
        for (variable, _) in own.iter_mut().flat_map(|b| &mut b.names) {
            let fresh = self.fresh(&variable.text);
            map.replace(&variable.text, &name(&fresh));
            with.push((variable.clone(), name(&fresh)));
            variable.text = fresh;
        }
        let (plain, later) = (map.prop(&plain).map_err(Fail::from)?, map.prop(body).map_err(Fail::from)?);
        let PropKind::ForAll(_, inner) = &later.kind else { return Err(no()) };
        self.opened.push(some.clone());
        let shown = self.attempt(|c| {
            let then = implies(&plain, goal);
            let all = c.block(&prop(PropKind::ForAll(own.clone(), Box::new(then.clone()))), |c, _| {
                c.block(&then, |c, block| {
                    let mut from = Vec::new();
                    for fact in own.iter().flat_map(domain) {
                        from.push(c.show(&fact)?);
                    }
                    from.push(c.block(&later, |c, _| {
                        c.instance(&format!("{block}s"), &name(&index.text))?;
                        for fact in &facts {
                            let here = c.instance(fact, &name(&index.text))?;
                            c.put_in(&here);
                        }
                        c.quietly(inner)
                    })?);
                    c.emit(Rule::Witness { with, from }, goal.clone())
                })
            })?;
            c.emit(Rule::Existence { some: some.clone(), all }, goal.clone())
        });
        self.opened.pop();
        shown
    }

    /// A bound by a multiple with 1 for all that is to be found, where little effort shows it: |sin(x)| <= 1.
    fn bounded_by_itself(&mut self, goal: &Prop, bindings: &[Binding], body: &Prop) -> Result<Label, Fail> {
        let ones = bindings.iter().flat_map(|b| &b.names).map(|n| (n.0.text.clone(), numeral(1))).collect();
        let splits = std::mem::replace(&mut self.splits, 8);
        let shown = self.by_values(goal, bindings, body, ones);
        self.splits = splits;
        shown
    }

    /// The same by limits as a real or natural number grows.
    fn as_x_grows(&mut self, goal: &Prop, eventual: &Eventual, natural: bool) -> Result<Label, Fail> {
        let x = self.fresh("x");
        let binding = Binding::of(Name::new(&x), natural, Vec::new());
        let every = prop(PropKind::ForAll(vec![binding], Box::new(goal.clone())));
        let all = self.block(&every, |c, _| {
            c.far_numbers_are_positive()?;
            match &eventual.factor {
                None => c.beyond_some_number(goal, eventual, &x),
                Some(factor) => c.bounded_by_a_multiple(goal, eventual, factor, &x),
            }
        })?;
        self.instance(&all, &numeral(0))
    }

    /// `for all t >= 1: t > 0`, which is put in for what a statement binds.
    fn far_numbers_are_positive(&mut self) -> Result<Label, Fail> {
        let t = self.fresh("t");
        let positive = compare(name(&t), Relation::Greater, numeral(0));
        let from_one = Constraint::Relation(Relation::GreaterEqual, numeral(1));
        let binding = Binding::of(Name::new(&t), false, vec![from_one]);
        let every = prop(PropKind::ForAll(vec![binding], Box::new(positive.clone())));
        self.block(&every, |c, _| c.without_cases(&positive))
    }

    /// That a comparison does not hold from some number on, because the opposite one does.
    pub(super) fn not_from_some_number_on(&mut self, goal: &Prop, every: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("the opposite from some number on");
        let PropKind::ForAll(over, body) = &every.kind else { return Err(no()) };
        let ([Binding { names, constraints, natural, .. }], Some((a, relation, b))) = (over.as_slice(), body.single())
        else {
            return Err(no());
        };
        let ([(index, None)], [Constraint::Relation(Relation::Greater | Relation::GreaterEqual, least)]) =
            (names.as_slice(), constraints.as_slice())
        else {
            return Err(no());
        };
        if self.splits >= 3 || self.inductions > 0 {
            return Err(no());
        }
        let (start, own) = (self.fresh("N"), self.fresh("k"));
        let opposite = compare(a.clone(), relation.negated(), b.clone());
        let opposite = put(&opposite, &index.text, &name(&own))?;
        let from_start = Constraint::Relation(Relation::GreaterEqual, name(&start));
        let far =
            prop(PropKind::ForAll(vec![Binding::of(Name::new(&own), *natural, vec![from_start])], Box::new(opposite)));
        let beyond = [(Relation::Greater, numeral(0)), (Relation::Greater, least.clone())];
        let beyond = beyond.map(|(relation, bound)| Constraint::Relation(relation, bound));
        let starts = vec![Binding::of(Name::new(&start), *natural, beyond.to_vec())];
        let some = prop(PropKind::Exists(starts.clone(), Box::new(far.clone())));
        let some = self.by_eventually(&some, &starts, &far)?;
        self.opened.push(some.clone());
        let absurd = compare(numeral(0), Relation::Greater, numeral(0));
        let shown = self.attempt(|c| {
            let block = c.block(&implies(every, &absurd), |c, supposed| {
                let then = implies(&far, &absurd);
                let all = c.block(&prop(PropKind::ForAll(starts, Box::new(then.clone()))), |c, _| {
                    c.block(&then, |c, block| {
                        let here = [supposed, block].map(|b| c.instance(&format!("{b}s"), &name(&start)));
                        let [Ok(one), Ok(other)] = here else { return Err(no()) };
                        c.logic(&[&one, &other], &absurd)
                    })
                })?;
                c.emit(Rule::Existence { some: some.clone(), all }, absurd.clone())
            })?;
            c.logic(&[&block], goal)
        });
        self.opened.pop();
        shown
    }

    /// Shows that some number has a property, because all have it from some number on.
    pub(super) fn by_a_far_number(&mut self, goal: &Prop, bindings: &[Binding], body: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("a property of all great numbers");
        let [Binding { names, constraints, natural, indices: None, .. }] = bindings else { return Err(no()) };
        let ([(variable, None)], Some(_)) = (names.as_slice(), body.single()) else { return Err(no()) };
        let is_lower =
            |c: &Constraint| matches!(c, Constraint::Relation(Relation::Greater | Relation::GreaterEqual, _));
        if self.splits >= 3 || self.inductions > 0 || !constraints.iter().all(is_lower) {
            return Err(no());
        }
        let (start, own) = (self.fresh("N"), self.fresh("k"));
        let from_start = Constraint::Relation(Relation::Greater, name(&start));
        let here = put(body, &variable.text, &name(&own))?;
        let far =
            prop(PropKind::ForAll(vec![Binding::of(Name::new(&own), *natural, vec![from_start])], Box::new(here)));
        let mut beyond = vec![Constraint::Relation(Relation::Greater, numeral(0))];
        beyond.extend(constraints.iter().cloned());
        let starts = vec![Binding::of(Name::new(&start), *natural, beyond)];
        let some = prop(PropKind::Exists(starts.clone(), Box::new(far.clone())));
        let some = self.by_eventually(&some, &starts, &far)?;
        self.opened.push(some.clone());
        let shown = self.attempt(|c| {
            let then = implies(&far, goal);
            let all = c.block(&prop(PropKind::ForAll(starts, Box::new(then.clone()))), |c, _| {
                c.block(&then, |c, block| {
                    let next = sum(vec![(Sign::Plus, name(&start)), (Sign::Plus, numeral(1))]);
                    c.instance(&format!("{block}s"), &next)?;
                    c.by_values(goal, bindings, body, vec![(variable.text.clone(), next)])
                })
            })?;
            c.emit(Rule::Existence { some: some.clone(), all }, goal.clone())
        });
        self.opened.pop();
        shown
    }

    fn beyond_some_number(&mut self, goal: &Prop, eventual: &Eventual, x: &str) -> Result<Label, Fail> {
        let mut stages = Vec::new();
        for (l, relation, r) in &eventual.pairs {
            stages.push(self.stage(l, *relation, r, &eventual.index, x).ok_or(Fail::No("a leading term"))?);
        }
        if let [only @ Stage { how: How::AtOnce, .. }] = stages.as_slice() {
            let limit = self.limit_of(only, x)?;
            if let Ok(label) = self.emit(Rule::Eventually { from: limit }, goal.clone()) {
                return Ok(label);
            }
        }
        self.with_numbers(goal, eventual, &stages, x, &[])
    }

    /// Shows the goal where the numbers exist from which on the stages hold; the other values of the goal are given.
    fn with_numbers(
        &mut self,
        goal: &Prop,
        eventual: &Eventual,
        stages: &[Stage],
        x: &str,
        values: &[(String, Expr)],
    ) -> Result<Label, Fail> {
        let mut found = Vec::new();
        for stage in stages {
            let limit = self.limit_of(stage, x)?;
            found.push(self.some_number(stage, eventual, &limit, x)?);
        }
        let opened = self.opened.len();
        self.opened.extend(found.iter().cloned());
        let shown = self.attempt(|c| c.opened_numbers(goal, eventual, stages, &found, &mut Vec::new(), values));
        self.opened.truncate(opened);
        shown
    }

    /// The limit of a stage, and that it lies on the right side of what it is compared with.
    fn limit_of(&mut self, stage: &Stage, x: &str) -> Result<Label, Fail> {
        let limit = Limit { of: stage.of.clone(), variable: Name::new(x), value: stage.limit.clone() };
        let label = self.show(&prop(PropKind::Limit(Box::new(limit))))?;
        if let PropKind::Compare(sides, relations) = &stage.chain.kind {
            let side = key::expr(&stage.side);
            for (pair, relation) in sides.windows(2).zip(relations) {
                // The other side does not move.
                let strict = relation.strict();
                let sides: Vec<Expr> =
                    pair.iter().map(|e| if key::expr(e) == side { stage.limit.clone() } else { e.clone() }).collect();
                let order = compare(sides[0].clone(), strict, sides[1].clone());
                if !self.signs_of(&minus(&sides[0], &sides[1])).within(Signs::of(strict)) {
                    self.show(&order)?;
                }
            }
        }
        Ok(label)
    }

    /// `exists M …: for all k >= M` what the stage says.
    fn some_number(&mut self, stage: &Stage, eventual: &Eventual, limit: &Label, x: &str) -> Result<Label, Fail> {
        let natural = self.naturals.iter().any(|n| n == x);
        let mut last = Err(Fail::No("where the values begin"));
        for least in STARTS {
            let (start, index) = (self.fresh("N"), self.fresh("k"));
            let mut constraints = eventual.start.constraints.clone();
            // That it is positive is read at once for what is not less than it.
            constraints.push(Constraint::Relation(Relation::Greater, numeral(0)));
            constraints.push(Constraint::Relation(Relation::GreaterEqual, numeral(least)));
            let chain = put(&stage.chain, &eventual.index, &name(&index))?;
            let from_there = Constraint::Relation(Relation::GreaterEqual, name(&start));
            let every = Binding::of(Name::new(&index), natural, vec![from_there]);
            let every = prop(PropKind::ForAll(vec![every], Box::new(chain)));
            let some = Binding::of(Name::new(&start), eventual.start.natural, constraints);
            let some = prop(PropKind::Exists(vec![some], Box::new(every)));
            last = self.emit(Rule::Eventually { from: limit.clone() }, some);
            if last.is_ok() {
                break;
            }
        }
        last
    }

    /// Gives names to the numbers that exist, one after the other.
    fn opened_numbers(
        &mut self,
        goal: &Prop,
        eventual: &Eventual,
        stages: &[Stage],
        found: &[Label],
        open: &mut Vec<(String, Label)>,
        values: &[(String, Expr)],
    ) -> Result<Label, Fail> {
        let Some(some) = found.get(open.len()) else { return self.at_the_sum(goal, eventual, stages, open, values) };
        let Some(Prop { kind: PropKind::Exists(bindings, every), .. }) = self.fact(some) else {
            return Err(Fail::No("what exists"));
        };
        let start = bindings.first().and_then(|b| b.names.first()).map(|n| n.0.text.clone()).unwrap_or_default();
        let then = implies(&every, goal);
        let all = self.block(&prop(PropKind::ForAll(bindings.clone(), Box::new(then.clone()))), |c, _| {
            c.block(&then, |c, block| {
                open.push((start.clone(), format!("{block}s")));
                c.opened_numbers(goal, eventual, stages, found, open, values)
            })
        })?;
        self.emit(Rule::Existence { some: some.clone(), all }, goal.clone())
    }

    /// The goal with the sum of the numbers from which on the stages hold.
    fn at_the_sum(
        &mut self,
        goal: &Prop,
        eventual: &Eventual,
        stages: &[Stage],
        open: &[(String, Label)],
        values: &[(String, Expr)],
    ) -> Result<Label, Fail> {
        let PropKind::Exists(bindings, body) = &goal.kind else { return Err(Fail::No("what exists")) };
        let numbers: Vec<Expr> = open.iter().map(|(number, _)| name(number)).collect();
        let value = super::asymptotic_form::total(&numbers);
        let mut map = Substitution::default();
        let mut with = Vec::new();
        let own = eventual.start.names.first().map(|n| n.0.text.clone()).unwrap_or_default();
        for (own, value) in values.iter().cloned().chain([(own, value)]) {
            map.replace(&own, &value);
            with.push((Name::new(own), value));
        }
        let mut from = Vec::new();
        for fact in bindings.iter().flat_map(domain) {
            from.push(self.show(&map.prop(&fact).map_err(Fail::from)?)?);
        }
        let every = map.prop(body).map_err(Fail::from)?;
        let PropKind::ForAll(_, inner) = &every.kind else { return Err(Fail::No("all numbers from one on")) };
        from.push(self.block(&every, |c, _| match &inner.kind {
            PropKind::Implies(_, then) => c.block(inner, |c, _| c.there(then, eventual, stages, open)),
            _ => c.there(inner, eventual, stages, open),
        })?);
        self.emit(Rule::Witness { with, from }, goal.clone())
    }

    /// What is claimed of a number from which on the stages hold.
    fn there(
        &mut self,
        claimed: &Prop,
        eventual: &Eventual,
        stages: &[Stage],
        open: &[(String, Label)],
    ) -> Result<Label, Fail> {
        let k = name(&eventual.index);
        let here = open.iter().map(|(_, every)| self.instance(every, &k)).collect::<Result<Vec<_>, _>>()?;
        let PropKind::Compare(sides, relations) = &claimed.kind else { return Err(Fail::No("a comparison")) };
        let mut from = Vec::new();
        for (((pair, relation), stage), fact) in sides.windows(2).zip(relations).zip(stages).zip(&here) {
            let single = compare(pair[0].clone(), *relation, pair[1].clone());
            from.push(self.attempt(|c| c.follows(&single, &stage.how, fact)).or_else(|_| self.show(&single))?);
        }
        match from.as_slice() {
            [only] => Ok(only.clone()),
            _ => self.emit(Rule::Logic { from }, claimed.clone()),
        }
    }

    /// A comparison from what a stage says at a number.
    fn follows(&mut self, goal: &Prop, how: &How, fact: &Label) -> Result<Label, Fail> {
        let Some((l, _, r)) = goal.single() else { return Err(Fail::No("a comparison")) };
        match how {
            How::AtOnce => self.logic(&[fact], goal),
            How::Times(factor) => {
                let combined = |c: &mut Prover, sign: i64| {
                    let factor = product(vec![literal(&Rational::from(sign)), factor.clone()]);
                    c.combination(goal.clone(), vec![Term { facts: vec![fact.clone()], factor }])
                };
                combined(self, 1).or_else(|_| combined(self, -1)).or_else(|_| self.without_cases(goal))
            }
            How::Unsigned(unsigned, how) => {
                let label = self.follows(unsigned, how, fact)?;
                self.take_in(&label, unsigned)?;
                self.show(goal)
            }
            How::Inside { f, g } => self.absolute_within(goal, [l, r], [f, g], fact),
            How::Left { left, how } => self.follows_from_what_is_left(goal, left, how, fact),
        }
    }

    /// The same where 1/k, for the index k, is as small as a bound of what is left asks for.
    fn follows_from_what_is_left(
        &mut self,
        goal: &Prop,
        left: &Remainder,
        how: &How,
        fact: &Label,
    ) -> Result<Label, Fail> {
        let no = || Fail::No("a large number");
        let Some(Prop { kind: PropKind::Compare(sides, _), .. }) = self.fact(fact) else { return Err(no()) };
        let ExprKind::Product(list) = &sides[0].kind else { return Err(no()) };
        let k = list.last().map(|f| f.1.clone()).ok_or_else(no)?;
        let (_, [below, above]) = self.remainder_at(left, &k, &scaled(fact, numeral(1)))?;
        let How::Inside { f, g } = how else { return self.follows(goal, how, &above) };
        let value = if natural(g) == Some(1) { f.clone() } else { over(f.clone(), g.clone()) };
        let (low, high) = (negated(left.bound.clone()), left.bound.clone());
        let mut from = Vec::new();
        for (a, b, fact) in [(&low, &value, below), (&value, &high, above)] {
            let order = compare(a.clone(), Relation::Less, b.clone());
            from.push(self.combination(order, vec![scaled(&fact, numeral(1))])?);
        }
        let inside = PropKind::Compare(vec![low, value, high], vec![Relation::Less; 2]);
        let inside = self.emit(Rule::Logic { from }, prop(inside))?;
        self.follows(goal, how, &inside)
    }

    /// A <= B from −C < f/g < C, where A = |f| and B = C·|g|: f² is at most (C·g)², and so are the roots.
    fn absolute_within(
        &mut self,
        goal: &Prop,
        sides: [&Expr; 2],
        [f, g]: [&Expr; 2],
        fact: &Label,
    ) -> Result<Label, Fail> {
        let no = || Fail::No("an absolute value");
        let PropKind::Compare(_, relations) = &goal.kind else { return Err(no()) };
        let relation = relations.first().ok_or_else(no)?;
        let turned = relation.is_greater().ok_or_else(no)?;
        let ([small, great], relation) =
            if turned { ([sides[1], sides[0]], relation.turned()) } else { (sides, *relation) };
        let Some(Prop { kind: PropKind::Compare(bounds, _), .. }) = self.fact(fact) else { return Err(no()) };
        let [low, quotient, high] = bounds.as_slice() else { return Err(no()) };
        let below = self.logic(&[fact], &compare(low.clone(), Relation::Less, quotient.clone()))?;
        let above = self.logic(&[fact], &compare(quotient.clone(), Relation::Less, high.clone()))?;
        let times = product(vec![high.clone(), g.clone()]);
        let squares = [whole_power(f.clone(), 2), whole_power(times, 2)];
        let factor = negated(whole_power(g.clone(), 2));
        let order = compare(squares[0].clone(), relation, squares[1].clone());
        let from = self.combination(order, vec![Term { facts: vec![below, above], factor }])?;
        let roots = squares.map(|square| apply("sqrt", square));
        let order = compare(roots[0].clone(), relation, roots[1].clone());
        let order = self.emit(Rule::Monotone { from }, order)?;
        let sign = |k: i64| literal(&Rational::from(if turned { -k } else { k }));
        let mut terms = vec![Term { facts: vec![order], factor: sign(1) }];
        for (root, side, k) in [(&roots[0], small, -1), (&roots[1], great, 1)] {
            if key::expr(root) != key::expr(side) {
                let same = compare(root.clone(), Relation::Equal, side.clone());
                let same = self.emit(Rule::Power, same.clone()).or_else(|_| self.show(&same))?;
                terms.push(Term { facts: vec![same], factor: sign(k) });
            }
        }
        self.combination(goal.clone(), terms).or_else(|_| self.without_cases(goal))
    }

    /// What a limit says about a comparison of two expressions of the index.
    fn stage(&mut self, l: &Expr, relation: Relation, r: &Expr, index: &str, x: &str) -> Option<Stage> {
        if relation == Relation::Equal {
            return None;
        }
        let moving = [holds(l, index), holds(r, index)];
        let whole = compare(l.clone(), relation, r.clone());
        let at = |e: &Expr| put_in(e, index, &name(x)).ok();
        // One side against a number.
        if moving[0] != moving[1] {
            let (side, bound) = if moving[0] { (l, r) } else { (r, l) };
            let of = at(side)?;
            let relation = if moving[0] { relation } else { relation.turned() };
            if let Some(limit) = self.finite_limit(&of, x)
                && self.is_apart(&limit, relation, bound)
            {
                return Some(Stage { side: side.clone(), chain: whole, limit, of, how: How::AtOnce });
            }
        }
        if let Some(stage) = self.stage_inside(l, relation, r, index, x) {
            return Some(stage);
        }
        let difference = minus(l, r);
        if let Some(lead) = self.leading_limit(&at(&difference)?, x)
            && self.is_apart(&lead.c, relation, &numeral(0))
        {
            let scale = |of: &Expr| raised(of, &-lead.exponent.clone());
            let of = if lead.exponent == 0 { difference } else { product(vec![difference, scale(&name(index))]) };
            let chain = compare(of.clone(), relation.strict(), numeral(0));
            let how = How::Times(raised(&name(index), &lead.exponent));
            return Some(Stage { chain, limit: lead.c, of: at(&of)?, side: of, how });
        }
        // One side over the other, which is positive.
        for (top, bottom, relation) in [(l, r, relation), (r, l, relation.turned())] {
            let of = over(top.clone(), bottom.clone());
            let moved = at(&of)?;
            if let Some(limit) = self.finite_limit(&moved, x)
                && self.is_apart(&limit, relation, &numeral(1))
            {
                let chain = compare(of.clone(), relation.strict(), numeral(1));
                return Some(Stage { side: of, chain, limit, of: moved, how: How::Times(bottom.clone()) });
            }
        }
        let unsigned = [l, r].map(|e| self.unsigned(e, index, x));
        let [Some(a), Some(b)] = unsigned else { return None };
        if key::expr(&a) == key::expr(l) && key::expr(&b) == key::expr(r) {
            return None;
        }
        let stage = self.stage(&a, relation, &b, index, x)?;
        let how = How::Unsigned(compare(a, relation, b), Box::new(stage.how));
        Some(Stage { how, ..stage })
    }

    /// An expression with X or −X for each root of X², as the leading term of X says.
    fn unsigned(&mut self, e: &Expr, index: &str, x: &str) -> Option<Expr> {
        if let Some(part) = under_root(e).filter(|part| holds(part, index)) {
            let moved = put_in(&part, index, &name(x)).ok()?;
            let lead = self.leading_limit(&moved, x)?;
            return match self.sign_of_constant(&lead.c)? {
                signs if signs.within(Signs::POSITIVE) => Some(part),
                signs if signs.within(Signs::of(Relation::Less)) => Some(negated(part)),
                _ => None,
            };
        }
        let (mut out, mut found) = (e.clone(), Some(()));
        parts_mut(&mut out, &mut |part| match self.unsigned(part, index, x) {
            Some(new) => *part = new,
            None => found = None,
        });
        found.map(|()| out)
    }

    /// |f| < |g| by the limit of f, or of f/g where g moves, too.
    fn stage_inside(&mut self, l: &Expr, relation: Relation, r: &Expr, index: &str, x: &str) -> Option<Stage> {
        let (small, great) = if relation.is_greater()? { (r, l) } else { (l, r) };
        let (f, g) = match (inside(small), inside(great)) {
            (None, None) => return None,
            (f, g) => (f.unwrap_or(small.clone()), g.unwrap_or(great.clone())),
        };
        let moves = holds(&g, index);
        let (of, bound) = if moves { (over(f.clone(), g.clone()), numeral(1)) } else { (f.clone(), g.clone()) };
        let moved = put_in(&of, index, &name(x)).ok()?;
        let limit = self.finite_limit(&moved, x)?;
        let within = self.is_apart(&limit, Relation::Less, &bound)
            && self.is_apart(&limit, Relation::Greater, &negated(bound.clone()));
        let chain = vec![negated(bound.clone()), of.clone(), bound];
        let chain = prop(PropKind::Compare(chain, vec![Relation::Less; 2]));
        let how = How::Inside { f, g: if moves { g } else { numeral(1) } };
        within.then_some(Stage { side: of, chain, limit, of: moved, how })
    }

    /// Proves that something is at most C times something else, for a C to be found.
    fn bounded_by_a_multiple(
        &mut self,
        goal: &Prop,
        eventual: &Eventual,
        factor: &Binding,
        x: &str,
    ) -> Result<Label, Fail> {
        let no = || Fail::No("a bound by a multiple");
        let [(l, relation, r)] = eventual.pairs.as_slice() else { return Err(no()) };
        let own = factor.names.first().map(|n| n.0.text.clone()).ok_or_else(no)?;
        let is_greater = relation.is_greater().ok_or_else(no)?;
        let (small, great) = if is_greater { (r, l) } else { (l, r) };
        if holds(small, &own) || !holds(great, &own) {
            return Err(no());
        }
        let multiple = put_in(great, &own, &numeral(1))?;
        let (f, is_absolute) = match inside(small) {
            Some(f) => (f, true),
            None => (small.clone(), false),
        };
        let g = without_one(&inside(&multiple).unwrap_or(multiple));
        let of = if natural(&g) == Some(1) { f.clone() } else { over(f.clone(), g.clone()) };
        let moved = put_in(&of, &eventual.index, &name(x))?;
        let how = if is_absolute { How::Inside { f: f.clone(), g: g.clone() } } else { How::Times(g.clone()) };
        if let Ok(label) = self.on_its_own(|c| c.by_what_is_left_of(goal, eventual, (&own, how), &moved, x)) {
            return Ok(label);
        }
        let limit = self.told_limit(&moved, x).ok_or_else(no)?;
        // Greater than the size of the limit.
        let bound = match self.letters.number(&limit) {
            Some(q) => literal(&Rational::from(Ceiling::ceiling(q.abs() + Rational::ONE))),
            None => sum(vec![(Sign::Plus, numeral(1)), (Sign::Plus, whole_power(limit.clone(), 2))]),
        };
        for (relation, bound) in [(Relation::Less, bound.clone()), (Relation::Greater, negated(bound.clone()))] {
            if !self.is_apart(&limit, relation, &bound) {
                return Err(no());
            }
        }
        let (chain, how) = match is_absolute {
            true => (
                prop(PropKind::Compare(
                    vec![negated(bound.clone()), of.clone(), bound.clone()],
                    vec![Relation::Less; 2],
                )),
                How::Inside { f, g },
            ),
            false => (compare(of.clone(), Relation::Less, bound.clone()), How::Times(g)),
        };
        let stage = Stage { side: of, chain, limit, of: moved, how };
        self.with_numbers(goal, eventual, &[stage], x, &[(own, bound)])
    }

    /// The same by an expansion of the quotient, in which no power grows.
    fn by_what_is_left_of(
        &mut self,
        goal: &Prop,
        eventual: &Eventual,
        (own, how): (&str, How),
        quotient: &Expr,
        x: &str,
    ) -> Result<Label, Fail> {
        let plan = self.expansion(quotient, x, 0).ok_or(Fail::No("an expansion"))?;
        if plan.nodes.last().is_none_or(|root| !root.terms.is_empty()) {
            return Err(Fail::No("what is bounded"));
        }
        let left = self.remainder_of(&plan, 0)?;
        let (end, bound) = (over(numeral(1), left.start.clone()), left.bound.clone());
        let near = |k: &str| over(numeral(1), name(k));
        let side = near(&eventual.index);
        let stage = Stage {
            chain: compare(side.clone(), Relation::Less, end),
            side,
            of: near(x),
            limit: numeral(0),
            how: How::Left { left: Box::new(left), how: Box::new(how) },
        };
        self.with_numbers(goal, eventual, &[stage], x, &[(own.to_string(), bound)])
    }

    /// Whether the order of a limit and what it is compared with is strict, and can be shown.
    fn is_apart(&mut self, limit: &Expr, relation: Relation, bound: &Expr) -> bool {
        let strict = relation.strict();
        if self.signs_of(&minus(limit, bound)).within(Signs::of(strict)) {
            return true;
        }
        self.quietly(&compare(limit.clone(), strict, bound.clone())).is_ok()
    }
}

/// An expression without its absolute values, which are roots of squares: where it is one, or a product of them and others.
pub(crate) fn inside(e: &Expr) -> Option<Expr> {
    if let ExprKind::Product(list) = &e.kind {
        let parts: Vec<Option<Expr>> = list.iter().map(|(_, e)| inside(e)).collect();
        if parts.iter().all(Option::is_none) {
            return None;
        }
        let parts = parts.into_iter().zip(list).map(|(part, (factor, e))| (*factor, part.unwrap_or_else(|| e.clone())));
        return Some(expr(ExprKind::Product(parts.collect())));
    }
    under_root(e)
}

/// X for the root of X².
pub(crate) fn under_root(e: &Expr) -> Option<Expr> {
    let (square, half) = as_power(e)?;
    let (inside, two) = as_power(&square)?;
    let is_root = matches!(&e.kind, ExprKind::Apply(f, _) if f.text == "sqrt")
        || key::expr(&half) == key::expr(&literal(&Rational::from_unsigneds(1u32, 2)));
    (is_root && natural(&two) == Some(2)).then_some(inside)
}

/// A product without factors 1.
fn without_one(e: &Expr) -> Expr {
    let ExprKind::Product(list) = &e.kind else { return e.clone() };
    let rest: Vec<_> = list.iter().filter(|(f, e)| *f == Factor::Over || natural(e) != Some(1)).cloned().collect();
    match rest.as_slice() {
        [] => numeral(1),
        [(Factor::Times, only)] => only.clone(),
        [(Factor::Times, _), ..] => expr(ExprKind::Product(rest)),
        _ => e.clone(),
    }
}

/// A statement as one about all numbers from one on.
pub(crate) fn eventual(bindings: &[Binding], body: &Prop) -> Option<Eventual> {
    let PropKind::ForAll(over, inner) = &body.kind else { return None };
    let [Binding { names, natural, constraints, indices: None, .. }] = over.as_slice() else { return None };
    let [(index, None)] = names.as_slice() else { return None };
    let lower = |c: &Constraint| match c {
        Constraint::Relation(Relation::Greater | Relation::GreaterEqual, Expr { kind: ExprKind::Name(n), .. }) => {
            Some(n.clone())
        }
        _ => None,
    };
    let (start, chain) = match (constraints.as_slice(), &inner.kind) {
        ([only], _) => (lower(only)?, inner),
        ([], PropKind::Implies(from, then)) => {
            let (k, Relation::Greater | Relation::GreaterEqual, n) = from.single()? else { return None };
            match (&k.kind, &n.kind) {
                (ExprKind::Name(k), ExprKind::Name(n)) if *k == index.text => (n.clone(), then),
                _ => return None,
            }
        }
        _ => return None,
    };
    let PropKind::Compare(sides, relations) = &chain.kind else { return None };
    let pairs = sides.windows(2).zip(relations).map(|(p, r)| (p[0].clone(), *r, p[1].clone())).collect();
    let mut own: Vec<Binding> = Vec::new();
    for binding in bindings {
        for (variable, index) in &binding.names {
            if index.is_some() {
                return None;
            }
            own.push(Binding::of(variable.clone(), binding.natural, binding.constraints.clone()));
        }
    }
    let place = own.iter().position(|b| b.names.iter().any(|n| n.0.text == start))?;
    let start = own.remove(place);
    if own.len() > 1 {
        return None;
    }
    Some(Eventual { start, factor: own.pop(), index: index.text.clone(), natural: *natural, pairs })
}
