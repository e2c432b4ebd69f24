//! Faults of a claim's argument: unknown labels, cited claims and variables, and methods that do not fit the goal.
//!
//! Contract: an argument without a fault may still fail to prove the claim. An argument with a fault is an error in the
//! claim file, and no search begins.

use super::expand::{Statement, names_in};
use super::outcome::Diagnose;
use crate::claim::diagnostic::nearest;
use crate::claim::syntax::*;
use std::collections::BTreeSet;

type Result = std::result::Result<(), Diagnose>;

/// The first fault of the argument. `cited` holds the claims that it may cite and that were judged.
///
/// # Errors
/// The fault, at its place.
pub(crate) fn check(statement: &Statement, cited: &[&Claim]) -> Result {
    let labels = statement.assumptions.iter().filter_map(|(label, prop)| Some((label.clone()?, prop.clone())));
    let mut scope = Scope { statement, cited, labels: labels.collect() };
    goals(&statement.goal)?;
    scope.follow(&statement.goal, &statement.proof)
}

struct Scope<'a> {
    statement: &'a Statement,
    cited: &'a [&'a Claim],
    /// The facts that have labels here.
    labels: Vec<(String, Prop)>,
}

impl Scope<'_> {
    fn follow(&mut self, goal: &Prop, proof: &Proof) -> Result {
        let outside = self.labels.len();
        for step in &proof.steps {
            match step {
                Step::Have { label, prop, proof } => {
                    goals(prop)?;
                    self.follow(prop, proof)?;
                    self.labels.push((label.text.clone(), prop.clone()));
                }
                Step::Obtain { label, prop, .. } => self.labels.push((label.text.clone(), prop.clone())),
                Step::Case { label, prop, proof } => {
                    let before = self.labels.len();
                    self.labels.push((label.text.clone(), prop.clone()));
                    self.follow(goal, proof)?;
                    self.labels.truncate(before);
                }
            }
        }
        if let Some(method) = &proof.close {
            self.method(goal, method)?;
        }
        self.labels.truncate(outside);
        Ok(())
    }

    fn method(&mut self, goal: &Prop, method: &Method) -> Result {
        match method {
            Method::Algebra(facts) => facts.iter().try_for_each(|fact| self.fact(fact).map(|_| ())),
            Method::Power { fact, .. } => self.comparison(fact),
            Method::Product(list) => list.iter().try_for_each(|(fact, _)| self.comparison(fact)),
            Method::Induction(variable, steps) => {
                let natural = self.statement.bindings.iter().filter(|b| b.natural).flat_map(|b| &b.names);
                if !natural.into_iter().any(|(name, index)| name.text == variable.text && index.is_none()) {
                    return fault(variable.span, "induction needs a natural variable of the claim");
                }
                self.labels.push(("induction".to_string(), goal.clone()));
                let result = self.follow(goal, steps);
                self.labels.pop();
                result
            }
            Method::Instance { claim, with } => self.instance(claim, with),
            Method::Witness(values) => witness(goal, values),
            Method::Squeeze { .. } if !matches!(goal.kind, PropKind::Limit(_)) => {
                fault(goal.span, "`squeeze` proves limits only")
            }
            Method::Squeeze { .. } | Method::Mean { .. } | Method::Hoelder { .. } => Ok(()),
        }
    }

    fn labelled(&self, label: &str) -> Option<&Prop> {
        self.labels.iter().rev().find(|(known, _)| known == label).map(|(_, prop)| prop)
    }

    fn fact(&self, label: &Name) -> std::result::Result<&Prop, Diagnose> {
        self.labelled(&label.text).ok_or_else(|| {
            let near = nearest(&label.text, self.labels.iter().map(|l| l.0.as_str()));
            let message = format!("no fact is called {}", label.text);
            Diagnose { message, help: near.map(|n| format!("did you mean {n}?")), span: label.span }
        })
    }

    /// A fact that a method raises or multiplies.
    fn comparison(&self, label: &Name) -> Result {
        match &self.fact(label)?.kind {
            PropKind::Compare(_, relations) if relations.len() == 1 && relations[0] != Relation::NotEqual => Ok(()),
            _ => fault(label.span, "this method needs a comparison of two sides"),
        }
    }

    fn instance(&self, claim: &Name, with: &[(Name, Expr)]) -> Result {
        let bindings: Vec<&Binding> = match self.labelled(&claim.text) {
            Some(Prop { kind: PropKind::ForAll(bindings, _), .. }) => bindings.iter().collect(),
            Some(_) => Vec::new(),
            None if !self.statement.using.contains(&claim.text) => {
                let message = format!("{} is neither a method, nor a fact, nor a cited claim", claim.text);
                let help =
                    Some("to cite a claim, name it under `using`; `carom help language` lists the methods".to_string());
                return Err(Diagnose { message, help, span: claim.span });
            }
            None => match self.cited.iter().find(|c| c.name.text == claim.text) {
                Some(cited) => cited.items.iter().flat_map(declared).collect(),
                // The cited claim has a fault of its own.
                None => return Ok(()),
            },
        };
        let names: Vec<&(Name, Option<Name>)> = bindings.iter().flat_map(|b| &b.names).collect();
        for (place, (name, value)) in with.iter().enumerate() {
            if with.iter().take(place).any(|w| w.0.text == name.text) {
                return fault(name.span, "give one value for each variable");
            }
            match names.iter().find(|n| n.0.text == name.text) {
                None => {
                    let message = format!("{} has no variable {}", claim.text, name.text);
                    let help = nearest(&name.text, names.iter().map(|n| n.0.text.as_str()));
                    return Err(Diagnose { message, help, span: name.span });
                }
                Some((_, Some(_))) if !matches!(value.kind, ExprKind::Name(_)) => {
                    return fault(value.span, "a family is replaced by the name of a family");
                }
                Some(_) => {}
            }
        }
        Ok(())
    }
}

/// The declarations of a clause.
fn declared(item: &Item) -> &[Binding] {
    match item {
        Item::Given(bindings) => bindings,
        _ => &[],
    }
}

fn witness(goal: &Prop, values: &[(Name, Expr)]) -> Result {
    let PropKind::Exists(bindings, _) = &goal.kind else { return fault(goal.span, "a witness proves `exists` only") };
    let names: Vec<&(Name, Option<Name>)> = bindings.iter().flat_map(|b| &b.names).collect();
    for (place, (name, _)) in values.iter().enumerate() {
        let twice = values.iter().take(place).any(|v| v.0.text == name.text);
        if twice || !names.iter().any(|n| n.0.text == name.text) {
            return fault(name.span, "a witness gives each variable of `exists` one value");
        }
    }
    if names.iter().any(|n| !values.iter().any(|v| v.0.text == n.0.text)) {
        return fault(goal.span, "the witness leaves a variable without a value");
    }
    if names.iter().any(|n| n.1.is_some()) {
        return fault(goal.span, "a witness cannot name a family");
    }
    Ok(())
}

/// Rejects an extremum over natural numbers, and a limit whose value depends on its variable, anywhere in a proposition.
fn goals(prop: &Prop) -> Result {
    match &prop.kind {
        PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => list.iter().try_for_each(goals),
        PropKind::Not(p) | PropKind::ForAll(_, p) | PropKind::Exists(_, p) => goals(p),
        PropKind::Implies(p, q) => goals(p).and_then(|()| goals(q)),
        PropKind::Extremum(extremum) => match extremum.over.iter().find(|b| b.natural) {
            Some(binding) => fault(binding.span, "the variables of an extremum must be real"),
            None => Ok(()),
        },
        PropKind::Limit(limit) => {
            let mut names = BTreeSet::new();
            names_in(&limit.value, &mut names);
            match names.contains(&limit.variable.text) {
                true => fault(limit.variable.span, "the limit must not depend on the variable"),
                false => Ok(()),
            }
        }
        PropKind::WrittenLimit(limit) => fault(limit.variable.span, "this limit was not written out"),
        PropKind::Compare(..) => Ok(()),
    }
}

fn fault(span: Span, message: &str) -> Result {
    Err(Diagnose { message: message.to_string(), help: None, span })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claim::parse::parse;

    fn fault_of(text: &str) -> Option<Diagnose> {
        let claims = parse(&format!("claim c \"\"\n{text}\n")).unwrap_or_else(|f| panic!("{text}: {}", f[0].message()));
        check(&Statement::of(&claims[0]).expect("within limits"), &[]).err()
    }

    #[test]
    fn each_fault_of_an_argument_is_named() {
        for (text, said) in [
            ("given x > 0\nassume small: x < 1\nprove x < 2 by algebra from smal", "no fact is called smal"),
            ("given x > 0\nassume other: x != 1\nprove x^2 != 1 by power of other to 2", "a comparison of two sides"),
            ("given x > 0\nprove x + 1 > 1 by induction on x", "induction needs a natural variable"),
            ("given x > 0\nprove x > 0 by eq99 with x = 1", "eq99 is neither a method, nor a fact"),
            ("given x > 0\nprove x > 0 by witness y = 1", "a witness proves `exists` only"),
            ("given x > 0\nprove exists y > 0: y = x by witness z = x", "gives each variable of `exists` one value"),
            ("given x > 0\nprove x > 0 by squeeze between 0 and 1", "`squeeze` proves limits only"),
            ("given n natural\nprove limit of n/(n + 1) as n -> infinity is n", "must not depend on the variable"),
            (
                "given x real\nprove maximum of -n^2 over n natural at n = 0 is 0",
                "the variables of an extremum must be real",
            ),
            (
                "given x real\nassume every: for all t > 0: x < t\nprove x < 2 by every with s = 2",
                "every has no variable s",
            ),
            (
                "given x real\nassume every: for all t > 0: x < t\nprove x < 2 by every with t = 2, t = 3",
                "give one value for each variable",
            ),
        ] {
            let fault = fault_of(text).unwrap_or_else(|| panic!("no fault in {text}"));
            assert!(fault.message.contains(said), "{text}: {}", fault.message);
        }
    }

    #[test]
    fn an_argument_that_leads_nowhere_is_no_fault() {
        for text in [
            "given x > 0\nassume small: x < 1\nprove x < 1/2 by algebra from small",
            "given n natural\nprove n < 1 by induction on n { have h: n = 3 by algebra from induction }",
            "given x real\nassume every: for all t > 0: x < t\nprove x < 2 by every with t = 2",
        ] {
            assert_eq!(fault_of(text), None, "{text}");
        }
    }
}
