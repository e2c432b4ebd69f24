//! Rule `logic`: what follows from facts by the connectives and the order of the reals.
//!
//! Two expressions that are compared have one of three orders: less, equal, greater. Every other statement without a
//! connective (for all, exists, an extremum, a limit) is true or false. A state gives an order to each pair and a truth
//! value to each such statement. The goal follows if it is true, and has a value, in each state in which the facts are
//! true. Parts get their orders and truth values one after the other; where these alone make a fact false, or the goal true with a
//! value, all states that begin with them are left out.
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

/// The most states, begun ones included, that one step may try.
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

/// A state, which may be only begun: the orders that each pair may have, and the truth of each statement if it has been chosen.
struct State {
    orders: Vec<Signs>,
    truths: Vec<Option<bool>>,
}

/// A part that a state chooses for.
#[derive(Clone, Copy)]
enum Part {
    Pair(usize),
    Statement(usize),
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
            orders: (0..parts.pairs.len()).map(|p| parts.fixed.get(&p).copied().unwrap_or(Signs::ANY)).collect(),
            truths: vec![None; parts.statements.len()],
        };
        // Those of short facts first, since they leave the fewest states.
        let mut shortest: Vec<&Form> = premises.iter().collect();
        shortest.sort_by_key(|premise| premise.size());
        let mut open = Vec::new();
        shortest.into_iter().chain([&conclusion]).for_each(|form| form.open_parts(&state, &mut open));
        let (work, each) = (&self.work, parts.size.saturating_add(4));
        let mut tried = 0usize;
        every_state(&mut state, &open, &mut |state, is_whole| {
            tried += 1;
            if tried > STATES_LIMIT {
                return Err(Refusal::Limit("states of a step of logic"));
            }
            work.count(each)?;
            if premises.iter().any(|p| p.truth(state) == Some(false)) {
                return Ok(false);
            }
            // Where the goal is true and has a value whatever else is chosen, nothing is left to try.
            if conclusion.holds(state) && conclusion.has_value(state, &always) {
                return Ok(false);
            }
            if !is_whole {
                return Ok(true);
            }
            if !conclusion.holds(state) {
                return rejected(Reason::DoesNotFollow);
            }
            let mut valued = Valued { pairs: always.pairs.clone(), statements: always.statements.clone() };
            premises.iter().for_each(|p| p.provides(state, &mut valued));
            if conclusion.has_value(state, &valued) { Ok(true) } else { rejected(Reason::NoValueInCase) }
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

/// Runs something in every state that chooses for these parts, and in those that it begins with; the flag says which are whole.
/// Where it answers no, no state that begins so is tried.
fn every_state(
    state: &mut State,
    open: &[Part],
    run: &mut dyn FnMut(&State, bool) -> Result<bool, Refusal>,
) -> Result<(), Refusal> {
    if !run(state, open.is_empty())? {
        return Ok(());
    }
    let Some((part, later)) = open.split_first() else { return Ok(()) };
    match *part {
        Part::Pair(pair) => {
            for order in [Signs::of(Relation::Less), Signs::ZERO, Signs::POSITIVE, Signs::ANY] {
                if let Some(slot) = state.orders.get_mut(pair) {
                    *slot = order;
                }
                if order != Signs::ANY {
                    every_state(state, later, run)?;
                }
            }
        }
        Part::Statement(place) => {
            for truth in [Some(false), Some(true), None] {
                if let Some(slot) = state.truths.get_mut(place) {
                    *slot = truth;
                }
                if truth.is_some() {
                    every_state(state, later, run)?;
                }
            }
        }
    }
    Ok(())
}

impl Form {
    /// How many forms it is made of.
    fn size(&self) -> usize {
        match self {
            Form::Order(..) | Form::Statement(_) => 1,
            Form::And(list) | Form::Or(list) | Form::Equivalent(list) => 1 + list.iter().map(Form::size).sum::<usize>(),
            Form::Not(inner) => 1 + inner.size(),
            Form::Implies(a, b) => 1 + a.size() + b.size(),
        }
    }

    /// Adds its parts that are neither fixed nor listed.
    fn open_parts(&self, state: &State, list: &mut Vec<Part>) {
        match self {
            Form::Order(pair, _) => {
                let is_open = state.orders.get(*pair) == Some(&Signs::ANY);
                if is_open && !list.iter().any(|part| matches!(part, Part::Pair(p) if p == pair)) {
                    list.push(Part::Pair(*pair));
                }
            }
            Form::Statement(place) => {
                if !list.iter().any(|part| matches!(part, Part::Statement(s) if s == place)) {
                    list.push(Part::Statement(*place));
                }
            }
            Form::And(forms) | Form::Or(forms) | Form::Equivalent(forms) => {
                forms.iter().for_each(|form| form.open_parts(state, list));
            }
            Form::Not(inner) => inner.open_parts(state, list),
            Form::Implies(a, b) => [a, b].into_iter().for_each(|form| form.open_parts(state, list)),
        }
    }

    /// Whether it is true; `None` where the state has not chosen for enough of its parts to tell. In a whole state it is never
    /// `None`, and what a state tells all states tell that begin with it.
    fn truth(&self, state: &State) -> Option<bool> {
        match self {
            Form::Order(pair, signs) => {
                let possible = state.orders.get(*pair)?;
                if possible.within(*signs) { Some(true) } else { possible.within(signs.others()).then_some(false) }
            }
            Form::Statement(place) => *state.truths.get(*place)?,
            Form::And(list) => all_of(list.iter().map(|p| p.truth(state))),
            Form::Or(list) => all_of(list.iter().map(|p| p.truth(state).map(|t| !t))).map(|none| !none),
            Form::Not(inner) => inner.truth(state).map(|t| !t),
            Form::Implies(a, b) => {
                all_of([a.truth(state), b.truth(state).map(|t| !t)].into_iter()).map(|broken| !broken)
            }
            Form::Equivalent(list) => {
                let truths = list.iter().map(|p| p.truth(state)).collect::<Option<Vec<bool>>>()?;
                Some(truths.windows(2).all(|pair| matches!(pair, [a, b] if a == b)))
            }
        }
    }

    /// Whether it is true, in a whole state or in all that begin with this one.
    fn holds(&self, state: &State) -> bool {
        self.truth(state) == Some(true)
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
            Form::Implies(a, b) => {
                a.has_value(state, valued) && (a.truth(state) == Some(false) || b.has_value(state, valued))
            }
        }
    }
}

/// Whether all are true; `None` where none is false and one is open.
fn all_of(mut truths: impl Iterator<Item = Option<bool>>) -> Option<bool> {
    truths
        .try_fold(Some(true), |all, truth| match truth {
            Some(false) => Err(()),
            Some(true) => Ok(all),
            None => Ok(None),
        })
        .unwrap_or(Some(false))
}
