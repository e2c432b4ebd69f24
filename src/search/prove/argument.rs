//! The claim's own argument, followed step by step.

use super::direct::argument::values_for;
use super::draft::Rule;
use super::{Certifier, Fail};
use crate::claim::syntax::*;
use crate::kernel::statement::{domain, prop};
use crate::kernel::substitution::Substitution;
use crate::kernel::text;

impl Certifier {
    /// Shows a goal with an argument.
    pub(super) fn follow(&mut self, goal: &Prop, proof: &Proof) -> Result<(), Fail> {
        let labels = self.labels.len();
        let values = self.values.clone();
        let result = self.follow_steps(goal, proof);
        self.labels.truncate(labels);
        self.values = values;
        result
    }

    fn follow_steps(&mut self, goal: &Prop, proof: &Proof) -> Result<(), Fail> {
        for (at, step) in proof.steps.iter().enumerate() {
            match step {
                Step::Have { label, prop, proof } => {
                    let fact = self.put(prop)?;
                    let taken = self.follow(&fact, proof);
                    taken.map_err(|e| e.within(&label.text))?;
                    if let Some(known) = self.label_of(&fact) {
                        self.suppose(&known, &fact)?;
                    }
                    self.labels.push((label.text.clone(), fact));
                }
                Step::Obtain { binding, label, prop, witness } => {
                    let value = self.values.expr(witness).map_err(Fail::from)?;
                    if let Some((variable, _)) = binding.names.first() {
                        self.values.replace(&variable.text, &value);
                    }
                    for fact in domain(binding).iter().chain([prop]) {
                        let fact = self.put(fact)?;
                        self.show(&fact)?;
                        if text::prop(&fact) == text::prop(&self.put(prop)?) {
                            self.labels.push((label.text.clone(), fact));
                        }
                    }
                }
                Step::Case { .. } => return self.cases(goal, proof.steps.get(at..).unwrap_or_default()),
            }
        }
        match &proof.close {
            None => self.show(goal),
            Some(method) => self.by_method(goal, method),
        }
    }

    pub(super) fn put(&self, p: &Prop) -> Result<Prop, Fail> {
        self.values.prop(p).map_err(Fail::from)
    }

    pub(super) fn put_expr(&self, e: &Expr) -> Result<Expr, Fail> {
        self.values.expr(e).map_err(Fail::from)
    }

    pub(super) fn cases(&mut self, goal: &Prop, steps: &[Step]) -> Result<(), Fail> {
        let mut list = Vec::new();
        for step in steps {
            let Step::Case { label, prop, proof } = step else { return Err(Fail::No("cases come last")) };
            list.push((label.text.clone(), self.put(prop)?, proof));
        }
        let all = prop(PropKind::Or(list.iter().map(|c| c.1.clone()).collect()));
        self.show(&all)?;
        let disjunction = self.label_of(&all).ok_or("the cases")?;
        for (label, case, proof) in list {
            let implication = prop(PropKind::Implies(Box::new(case.clone()), Box::new(goal.clone())));
            self.block(&implication, |c, block| {
                c.labels.push((label, case.clone()));
                c.suppose(&format!("{block}s"), &case)?;
                c.follow(goal, proof)
            })?;
        }
        self.take(Rule::Cases, &[disjunction], Some(goal.clone())).map(|_| ())
    }

    fn by_method(&mut self, goal: &Prop, method: &Method) -> Result<(), Fail> {
        match method {
            Method::Algebra(_) => self.show(goal),
            Method::Witness(values) => {
                let values =
                    values.iter().map(|(n, e)| Ok((n.clone(), self.put_expr(e)?))).collect::<Result<Vec<_>, Fail>>()?;
                self.witness(goal, &values)
            }
            Method::Induction(variable, steps) => self.induction(goal, variable, steps),
            Method::Instance { claim, with } => {
                let with =
                    with.iter().map(|(n, e)| Ok((n.clone(), self.put_expr(e)?))).collect::<Result<Vec<_>, Fail>>()?;
                self.instance(&claim.text, with)?;
                self.show(goal)
            }
            Method::Power { fact, exponent } => {
                let exponent = self.put_expr(exponent)?;
                self.power_of(&fact.text, &exponent)?;
                self.show(goal)
            }
            Method::Product(list) => self.product(goal, list),
            Method::Mean { a, b, weight } => {
                let (a, b, p) = (self.put_expr(a)?, self.put_expr(b)?, self.put_expr(weight)?);
                self.mean(&a, &b, &p)?;
                self.show(goal)
            }
            Method::Hoelder { first, second, weight } => {
                let p = self.put_expr(weight)?;
                let pairs = [&first.0, &first.1, &second.0, &second.1].map(|e| self.put_expr(e));
                let [a, b, c, d] = pairs;
                self.hoelder(goal, [a?, b?, c?, d?], &p)
            }
            Method::Squeeze { lower, upper } => {
                let (lower, upper) = (self.put_expr(lower)?, self.put_expr(upper)?);
                self.squeeze(goal, lower, upper)
            }
        }
    }

    pub(super) fn labelled(&self, label: &str) -> Result<Prop, Fail> {
        let found = self.labels.iter().rev().find(|l| l.0 == label);
        found.map(|l| l.1.clone()).ok_or_else(|| Fail::NoFact(label.to_string()))
    }

    pub(super) fn witness(&mut self, goal: &Prop, values: &[(Name, Expr)]) -> Result<(), Fail> {
        let PropKind::Exists(bindings, body) = &goal.kind else {
            return Err(Fail::No("a witness proves `exists` only"));
        };
        let mut map = Substitution::default();
        values.iter().for_each(|(n, e)| map.replace(&n.text, e));
        for fact in bindings.iter().flat_map(domain).chain([(**body).clone()]) {
            let fact = map.prop(&fact).map_err(Fail::from)?;
            self.show(&fact)?;
        }
        self.prepare(&values.iter().map(|v| &v.1).collect::<Vec<_>>())?;
        self.with(Rule::Witness, &[], Some(goal.clone()), values.to_vec()).map(|_| ())
    }

    /// An instance of a cited claim or of a fact, made known with its parts.
    pub(super) fn instance(&mut self, source: &str, with: Vec<(Name, Expr)>) -> Result<(), Fail> {
        if let Ok(fact) = self.labelled(source) {
            let PropKind::ForAll(bindings, body) = &fact.kind else { return Ok(()) };
            let label = self.label_of(&fact).ok_or("a fact")?;
            let mut map = Substitution::default();
            with.iter().for_each(|(n, e)| map.replace(&n.text, e));
            for fact in bindings.iter().flat_map(domain) {
                let fact = map.prop(&fact).map_err(Fail::from)?;
                self.show(&fact)?;
            }
            let shown = map.prop(body).map_err(Fail::from)?;
            let label = self.with(Rule::Instance, &[label], Some(shown.clone()), with)?;
            return self.suppose(&label, &shown);
        }
        let cited = self.checker.cited_statement(source).ok_or_else(|| Fail::NoProofOf(source.to_string()))?;
        let (with, map) = values_for(&cited, with, &|e| self.put_expr(e))?;
        self.prepare(&with.iter().map(|v| &v.1).collect::<Vec<_>>())?;
        self.define(&with.iter().map(|v| &v.1).collect::<Vec<_>>())?;
        for fact in cited.bindings.iter().flat_map(domain).chain(cited.assumptions.iter().cloned()) {
            let fact = map.prop(&fact).map_err(Fail::from)?;
            self.show(&fact).map_err(|e| e.within(source))?;
        }
        let shown = map.prop(&cited.goal).map_err(Fail::from)?;
        let label = self.with(Rule::Instance, &[source.to_string()], Some(shown.clone()), with)?;
        self.suppose(&label, &shown)
    }
}
