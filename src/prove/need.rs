//! Which hypotheses a proof does without.
//!
//! Contract: without all the hypotheses that [`not_needed`] returns, taken away at once, the statement was shown again.
//! What the search remembers of the facts that it used is only where it begins: a fact may have had a say unnoticed.

use super::context::{Context, Engine, source};
use super::expand::Statement;
use crate::claim::print;
use crate::claim::syntax::*;
use std::collections::BTreeSet;

/// A hypothesis that a claim states.
#[derive(Clone, Debug)]
pub struct Hypothesis {
    /// As a report shows it.
    pub text: String,
    /// Where it stands.
    place: Place,
    /// The first of the facts that it became, and how many they are.
    facts: (usize, usize),
}

/// Where a hypothesis stands in its statement.
#[derive(Clone, Debug)]
enum Place {
    /// What the domain of a family says of its members.
    Family(String),
    /// One of the comparisons that the domain of a variable says.
    Domain(String, usize),
    /// An assumption.
    Assumption(usize),
}

/// The hypotheses of a statement in the order in which the prover takes them as facts.
pub fn hypotheses(statement: &Statement) -> Vec<Hypothesis> {
    let mut out: Vec<Hypothesis> = Vec::new();
    let mut push = |text: String, place: Place, count: usize| {
        let first = out.last().map_or(0, |last| last.facts.0 + last.facts.1);
        out.push(Hypothesis { text, place, facts: (first, count) });
    };
    for binding in &statement.bindings {
        for (name, _) in binding.names.iter().filter(|n| n.1.is_some()) {
            let mut single = binding.clone();
            single.names.retain(|n| n.0.text == name.text);
            push(print::Style::Text.binding(&single), Place::Family(name.text.clone()), 1);
        }
    }
    for binding in &statement.bindings {
        for (name, index) in binding.names.iter().filter(|n| n.1.is_none()) {
            let single = Binding { names: vec![(name.clone(), index.clone())], ..binding.clone() };
            for (place, prop) in super::assume::domain(&single).iter().enumerate() {
                push(print::prop(prop), Place::Domain(name.text.clone(), place), 1);
            }
        }
    }
    for (place, (label, prop)) in statement.assumptions.iter().enumerate() {
        let text = match label {
            Some(label) => format!("{label}: {}", print::prop(prop)),
            None => print::prop(prop),
        };
        push(text, Place::Assumption(place), facts(prop));
    }
    out
}

/// How many facts a proposition becomes: itself, and the parts of a conjunction.
fn facts(prop: &Prop) -> usize {
    match &prop.kind {
        PropKind::And(list) => 1 + list.iter().map(facts).sum::<usize>(),
        _ => 1,
    }
}

/// The statement without some of its hypotheses.
pub fn without(statement: &Statement, dropped: &[&Hypothesis]) -> Statement {
    let mut out = statement.clone();
    out.bindings.clear();
    for binding in &statement.bindings {
        for (name, index) in &binding.names {
            let mut single = Binding { names: vec![(name.clone(), index.clone())], ..binding.clone() };
            // An interval or range is two comparisons, of which one may stay.
            single.constraints = binding.constraints.iter().flat_map(comparisons).collect();
            let mut place = 0;
            single.constraints.retain(|_| {
                place += 1;
                !dropped.iter().any(|h| match &h.place {
                    Place::Family(family) => index.is_some() && *family == name.text,
                    Place::Domain(variable, at) => index.is_none() && *variable == name.text && *at == place - 1,
                    Place::Assumption(_) => false,
                })
            });
            out.bindings.push(single);
        }
    }
    let mut place = 0;
    out.assumptions.retain(|_| {
        place += 1;
        !dropped.iter().any(|h| matches!(h.place, Place::Assumption(at) if at == place - 1))
    });
    out
}

/// A constraint as comparisons, in the order in which a domain says them.
fn comparisons(constraint: &Constraint) -> Vec<Constraint> {
    let (least, greatest) = (Relation::GreaterEqual, Relation::LessEqual);
    match constraint {
        Constraint::Relation(..) => vec![constraint.clone()],
        Constraint::Interval { from, from_closed, to, to_closed } => vec![
            Constraint::Relation(if *from_closed { least } else { Relation::Greater }, from.clone()),
            Constraint::Relation(if *to_closed { greatest } else { Relation::Less }, to.clone()),
        ],
        Constraint::Range(from, to) => {
            vec![Constraint::Relation(least, from.clone()), Constraint::Relation(greatest, to.clone())]
        }
    }
}

/// The hypotheses, by place in the list, without which all together the statement is shown again. `attempt` makes an
/// engine with as much room as the proof took, and a little more; where that is short a hypothesis counts as needed.
pub fn not_needed<'c>(
    done: &Engine,
    statement: &Statement,
    hypotheses: &[Hypothesis],
    attempt: &dyn Fn() -> Engine<'c>,
) -> BTreeSet<usize> {
    let shown = |dropped: &BTreeSet<usize>| {
        let list: Vec<&Hypothesis> = dropped.iter().filter_map(|place| hypotheses.get(*place)).collect();
        let rest = without(statement, &list);
        let (mut engine, mut cx) = (attempt(), Context::default());
        super::catalogue::take_hypotheses(&mut engine, &mut cx, &rest).is_ok()
            && super::catalogue::show(&mut engine, &cx, &rest).is_ok()
    };
    let consulted = |h: &Hypothesis| (h.facts.0..h.facts.0 + h.facts.1).any(|fact| done.used & source(fact) != 0);
    let (open, silent): (Vec<usize>, Vec<usize>) =
        (0..hypotheses.len()).partition(|place| consulted(&hypotheses[*place]));
    let mut dropped: BTreeSet<usize> = silent.iter().copied().collect();
    let mut next = Vec::new();
    if !dropped.is_empty() && !shown(&dropped) {
        dropped.clear();
        next.extend(silent);
    }
    // An assumption that was looked at may be idle all the same; the domain of a variable counts as used then.
    next.extend(open.into_iter().filter(|place| matches!(hypotheses[*place].place, Place::Assumption(_))));
    for place in next {
        dropped.insert(place);
        if !shown(&dropped) {
            dropped.remove(&place);
        }
    }
    dropped
}
