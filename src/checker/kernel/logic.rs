//! Rule `logic`: what follows from facts by the connectives and the order of the reals.
//!
//! Two expressions that are compared have one of three orders: less, equal, greater. Every other statement without a
//! connective (for all, exists, an extremum, a limit) is true or false. A state gives an order to each pair and a truth
//! value to each such statement. The goal follows if it is true, and has a value, in each state in which the facts are
//! true. All states are tried.
//!
//! **When a proposition has a value.** A comparison has one where its sides have. `P and Q`, `P or Q`, `not P`,
//! `P <=> Q` have one where their parts have. `P => Q` has one where P has, and where P is true also Q. In this sense
//! every fact has a value at every point that the hypotheses allow, so in each state the facts say which comparisons
//! have values there.

use super::known::Known;
use super::order::Signs;
use super::statement::compare;
use super::term::Value;
use super::{Checker, Reason, Refusal, key, rejected};
use crate::claim::syntax::*;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

/// The most states that one step may try.
const STATES_LIMIT: usize = 200_000;

/// What a proposition is made of: its connectives, and its parts by number.
enum Form {
    /// The pair of that number has one of these orders; the flag says that the pair is turned round.
    Order(usize, Signs),
    /// The statement of that number is true.
    Statement(usize),
    And(Vec<Form>),
    Or(Vec<Form>),
    Not(Box<Form>),
    Implies(Box<Form>, Box<Form>),
    Equivalent(Vec<Form>),
}

/// The parts met so far.
#[derive(Default)]
struct Parts {
    pairs: BTreeMap<(String, String), usize>,
    statements: BTreeMap<String, usize>,
    /// The order of pairs whose difference is a number.
    fixed: BTreeMap<usize, Signs>,
    /// A comparison or statement of each pair and statement, to ask whether it has a value.
    pair_props: Vec<Prop>,
    statement_props: Vec<Prop>,
    /// How many forms were made, which each state goes through.
    size: usize,
}

/// A state: the order of each pair, the truth of each statement.
struct State {
    orders: Vec<Signs>,
    truths: Vec<bool>,
}

/// Which pairs and statements have values.
struct Valued {
    pairs: BTreeSet<usize>,
    statements: BTreeSet<usize>,
}

impl Checker {
    /// Rule `logic`.
    ///
    /// Sound: at a point that the hypotheses allow, the facts are true and have values. Let the state be that of the
    /// point: pairs without a value there get any order, which changes the truth of no fact, since a fact that has a
    /// value does not depend on them. In this state the goal is true, and depends only on parts that have values.
    pub(super) fn logic(&mut self, goal: &Prop, from: &[String], known: &mut Known) -> Result<(), Refusal> {
        let facts: Vec<Rc<Prop>> = from.iter().map(|label| self.fact(label)).collect::<Result<_, _>>()?;
        let mut parts = Parts::default();
        let premises: Vec<Form> = facts.iter().map(|fact| self.form(fact, &mut parts)).collect::<Result<_, _>>()?;
        let conclusion = self.form(goal, &mut parts)?;
        let open = parts.pairs.len() - parts.fixed.len();
        let states = 3usize.checked_pow(u32::try_from(open).unwrap_or(u32::MAX));
        let states =
            states.and_then(|s| s.checked_mul(1usize.checked_shl(u32::try_from(parts.statements.len()).ok()?)?));
        match states {
            Some(states) if states <= STATES_LIMIT => self.work.count(states.saturating_mul(4 + parts.size))?,
            _ => return Err(Refusal::Limit("states of a step of logic")),
        }
        // What has a value in every state, by the facts under `by`.
        let mut always = Valued { pairs: BTreeSet::new(), statements: BTreeSet::new() };
        for (place, prop) in parts.pair_props.clone().iter().enumerate() {
            if self.has_value(prop, known)? {
                always.pairs.insert(place);
            }
        }
        for (place, prop) in parts.statement_props.clone().iter().enumerate() {
            if self.has_value(prop, known)? {
                always.statements.insert(place);
            }
        }
        let mut state = State {
            orders: (0..parts.pairs.len()).map(|p| parts.fixed.get(&p).copied().unwrap_or(Signs::ZERO)).collect(),
            truths: vec![false; parts.statements.len()],
        };
        let open: Vec<usize> = (0..parts.pairs.len()).filter(|p| !parts.fixed.contains_key(p)).collect();
        every_state(&mut state, &open, 0, &mut |state| {
            if premises.iter().any(|p| !p.holds(state)) {
                return Ok(());
            }
            if !conclusion.holds(state) {
                return rejected(Reason::DoesNotFollow);
            }
            let mut valued = Valued { pairs: always.pairs.clone(), statements: always.statements.clone() };
            premises.iter().for_each(|p| p.provides(state, &mut valued));
            if conclusion.has_value(state, &valued) { Ok(()) } else { rejected(Reason::NoValueInCase) }
        })
    }

    fn form(&mut self, p: &Prop, parts: &mut Parts) -> Result<Form, Refusal> {
        let all = |checker: &mut Checker, list: &[Prop], parts: &mut Parts| -> Result<Vec<Form>, Refusal> {
            list.iter().map(|p| checker.form(p, parts)).collect()
        };
        parts.size += 1;
        self.work.count(1)?;
        Ok(match &p.kind {
            PropKind::Compare(sides, relations) => {
                let mut list = Vec::new();
                for (pair, relation) in sides.windows(2).zip(relations) {
                    if let [a, b] = pair {
                        list.push(self.order(a, *relation, b, parts)?);
                    }
                }
                match (list.len(), list.pop()) {
                    (1, Some(only)) => only,
                    (_, last) => {
                        list.extend(last);
                        Form::And(list)
                    }
                }
            }
            PropKind::And(list) => Form::And(all(self, list, parts)?),
            PropKind::Or(list) => Form::Or(all(self, list, parts)?),
            PropKind::Not(inner) => Form::Not(Box::new(self.form(inner, parts)?)),
            PropKind::Implies(a, b) => Form::Implies(Box::new(self.form(a, parts)?), Box::new(self.form(b, parts)?)),
            PropKind::Equivalent(list) => Form::Equivalent(all(self, list, parts)?),
            PropKind::Exists(..)
            | PropKind::ForAll(..)
            | PropKind::Extremum(_)
            | PropKind::Limit(_)
            | PropKind::WrittenLimit(_) => {
                let next = parts.statements.len();
                let place = *parts.statements.entry(key::prop(p)).or_insert(next);
                if place == next {
                    parts.statement_props.push(p.clone());
                }
                Form::Statement(place)
            }
        })
    }

    /// The pair a, b in one of its two orders.
    fn order(&mut self, a: &Expr, relation: Relation, b: &Expr, parts: &mut Parts) -> Result<Form, Refusal> {
        let (left, right) = (key::expr(a), key::expr(b));
        parts.size += 1;
        self.work.count(left.len() + right.len())?;
        let turned = left > right;
        let signs = if turned { Signs::of(relation).turned() } else { Signs::of(relation) };
        let pair = if turned { (right, left) } else { (left, right) };
        let next = parts.pairs.len();
        let place = *parts.pairs.entry(pair).or_insert(next);
        let here = compare(a.clone(), relation, b.clone());
        if place < next
            && !matches!(relation, Relation::Equal | Relation::NotEqual)
            && let Some(asked) = parts.pair_props.get_mut(place)
        {
            // Matrices may be equal; an order of them has no value.
            *asked = here;
        } else if place == next {
            parts.pair_props.push(here);
            if let (Value::Scalar(x), Value::Scalar(y)) = (self.value(a)?, self.value(b)?)
                && let Some(number) = x.minus(&y, &self.work)?.as_number()
            {
                let signs = Signs::of_number(number);
                parts.fixed.insert(place, if turned { signs.turned() } else { signs });
            }
        }
        Ok(Form::Order(place, signs))
    }
}

/// Runs something in every state of these pairs, from a place on, and of all statements.
fn every_state(
    state: &mut State,
    pairs: &[usize],
    place: usize,
    run: &mut dyn FnMut(&State) -> Result<(), Refusal>,
) -> Result<(), Refusal> {
    if let Some(pair) = pairs.get(place) {
        for order in [Signs::of(Relation::Less), Signs::ZERO, Signs::POSITIVE] {
            if let Some(slot) = state.orders.get_mut(*pair) {
                *slot = order;
            }
            every_state(state, pairs, place + 1, run)?;
        }
        return Ok(());
    }
    let statement = place - pairs.len();
    if statement < state.truths.len() {
        for truth in [false, true] {
            if let Some(slot) = state.truths.get_mut(statement) {
                *slot = truth;
            }
            every_state(state, pairs, place + 1, run)?;
        }
        return Ok(());
    }
    run(state)
}

impl Form {
    fn holds(&self, state: &State) -> bool {
        match self {
            Form::Order(pair, signs) => state.orders.get(*pair).is_some_and(|order| order.within(*signs)),
            Form::Statement(place) => state.truths.get(*place).copied().unwrap_or(false),
            Form::And(list) => list.iter().all(|p| p.holds(state)),
            Form::Or(list) => list.iter().any(|p| p.holds(state)),
            Form::Not(inner) => !inner.holds(state),
            Form::Implies(a, b) => !a.holds(state) || b.holds(state),
            Form::Equivalent(list) => list.windows(2).all(|p| matches!(p, [a, b] if a.holds(state) == b.holds(state))),
        }
    }

    /// Adds what has a value where this proposition has one.
    fn provides(&self, state: &State, valued: &mut Valued) {
        match self {
            Form::Order(pair, _) => {
                valued.pairs.insert(*pair);
            }
            Form::Statement(place) => {
                valued.statements.insert(*place);
            }
            Form::And(list) | Form::Or(list) | Form::Equivalent(list) => {
                list.iter().for_each(|p| p.provides(state, valued));
            }
            Form::Not(inner) => inner.provides(state, valued),
            Form::Implies(a, b) => {
                a.provides(state, valued);
                if a.holds(state) {
                    b.provides(state, valued);
                }
            }
        }
    }

    /// Whether this proposition has a value where these parts have.
    fn has_value(&self, state: &State, valued: &Valued) -> bool {
        match self {
            Form::Order(pair, _) => valued.pairs.contains(pair),
            Form::Statement(place) => valued.statements.contains(place),
            Form::And(list) | Form::Or(list) | Form::Equivalent(list) => {
                list.iter().all(|p| p.has_value(state, valued))
            }
            Form::Not(inner) => inner.has_value(state, valued),
            Form::Implies(a, b) => a.has_value(state, valued) && (!a.holds(state) || b.has_value(state, valued)),
        }
    }
}
