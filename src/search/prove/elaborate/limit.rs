//! Limits: the draft has facts about the claim's own variable; a certificate needs them for every large value of a new one.
//!
//! Contract: [`Elaborator::for_every`] proves a proposition for all values of a new variable. It repeats the steps of the
//! draft with the old variable renamed, and leaves out steps that fail. The kernel decides whether the others suffice.

use super::{Elaborator, Fact, Stuck};
use crate::certificate::{Label, Rule, Show};
use crate::claim::syntax::*;
use crate::kernel::names::{names_in, names_in_prop};
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, name, numeral, prop};
use crate::kernel::substitution::Substitution;
use crate::kernel::{Reason, Refusal, key};
use crate::prove::draft;
use std::collections::{BTreeSet, HashMap};

/// Largest number of parts of an expression whose signs are proved before its limit is given up.
const PARTS: usize = 20;

/// A variable under another name.
struct Renaming<'a> {
    from: &'a str,
    to: Expr,
    map: Substitution,
    /// The labels before anything was renamed.
    labels: HashMap<Label, Label>,
}

impl Elaborator {
    /// Rule `limit`. If it fails, the limit of an expression that equals this one for every large value, with its powers
    /// written in generators.
    pub(super) fn limit(&mut self, step: &draft::Step, goal: &Prop) -> Result<Label, Stuck> {
        let PropKind::Limit(limit) = &goal.kind else { return Err(Stuck::Malformed(step.label.clone())) };
        let stuck = match self.limit_by_degrees(&step.label, limit) {
            Err(stuck) => stuck,
            shown => return shown,
        };
        let other = self.powers_written(&limit.of);
        if key::expr(&other) == key::expr(&limit.of) {
            return Err(stuck);
        }
        let shown = self.limit_by_degrees(&step.label, &Limit { of: other.clone(), ..(**limit).clone() })?;
        let limits = [shown.clone(), shown];
        self.between(&step.label, goal, limit, [other.clone(), other], limits)
    }

    /// Rule `limit`. First proves the signs, for every large value, of those parts of the expression that need it.
    fn limit_by_degrees(&mut self, step: &str, limit: &Limit) -> Result<Label, Stuck> {
        let goal = &prop(PropKind::Limit(Box::new(limit.clone())));
        let least = self.least(&limit.variable.text);
        let rule = Rule::Limit {
            with: least.into_iter().map(|e| (Name { text: "from".to_string(), span: Span::default() }, e)).collect(),
        };
        for _ in 0..PARTS {
            let refusal = match self.emit(step, rule.clone(), goal) {
                Err(Stuck::Refused { refusal, step, rule }) => match *refusal {
                    Refusal::Rejected(Reason::NoValue { part, signs }) => (part, signs),
                    other => return Err(Stuck::Refused { refusal: Box::new(other), step, rule }),
                },
                other => return other,
            };
            let (part, signs) = refusal;
            let relations = match signs {
                Signs::NOT_ZERO => vec![Relation::Greater, Relation::Less, Relation::NotEqual],
                Signs::POSITIVE => vec![Relation::Greater],
                _ => vec![Relation::GreaterEqual],
            };
            let of_part = |relation| compare(part.clone(), relation, numeral(0));
            let found = relations.into_iter().map(of_part).find(|p| self.has_sign(p));
            let Some(found) = found else { break };
            self.for_every(step, &limit.variable.text, &found)?;
        }
        self.emit(step, rule, goal)
    }

    /// Rule `squeeze`. Both bounds are proved for all values first.
    pub(super) fn squeeze(&mut self, step: &draft::Step, goal: &Prop) -> Result<Label, Stuck> {
        let missing = || Stuck::Malformed(step.label.clone());
        let PropKind::Limit(limit) = &goal.kind else { return Err(missing()) };
        let bound = |word: &str| step.with.iter().find(|w| w.0.text == word).map(|w| w.1.clone()).ok_or_else(missing);
        let (lower, upper) = (bound("lower")?, bound("upper")?);
        let limit_of = |e: &Expr| prop(PropKind::Limit(Box::new(Limit { of: e.clone(), ..(**limit).clone() })));
        let limits = [self.find(&limit_of(&lower)), self.find(&limit_of(&upper))];
        let [Some(lower_limit), Some(upper_limit)] = limits else { return Err(missing()) };
        self.between(&step.label, goal, limit, [lower, upper], [lower_limit, upper_limit])
    }

    /// A limit between two others of which the limits are facts.
    fn between(
        &mut self,
        step: &str,
        goal: &Prop,
        limit: &Limit,
        [lower, upper]: [Expr; 2],
        [lower_limit, upper_limit]: [Label; 2],
    ) -> Result<Label, Stuck> {
        let below = compare(lower, Relation::LessEqual, limit.of.clone());
        let above = compare(limit.of.clone(), Relation::LessEqual, upper);
        let lower = self.for_every(step, &limit.variable.text, &below)?;
        let upper = self.for_every(step, &limit.variable.text, &above)?;
        self.emit(step, Rule::Squeeze { from: vec![lower, upper, lower_limit, upper_limit] }, goal)
    }

    /// Whether a comparison follows from the signs of all facts.
    fn has_sign(&mut self, p: &Prop) -> bool {
        let show = Show {
            label: "x".to_string(),
            rule: Rule::Combination { times: None, terms: Vec::new() },
            prop: p.clone(),
            by: self.signs(),
            using: self.using(),
        };
        self.checker.used(&show).is_ok()
    }

    /// Shows `for all k: P` with a new name k in the place of a variable that grows, from the greatest numeral on that
    /// is known to be a lower bound.
    fn for_every(&mut self, step: &str, variable: &str, body: &Prop) -> Result<Label, Stuck> {
        let malformed = |_| Stuck::Malformed(step.to_string());
        let to = name(&self.fresh_name(variable));
        let mut map = Substitution::default();
        map.replace(variable, &to);
        let body = map.prop(body).map_err(malformed)?;
        let (ExprKind::Name(new), bindings) = (&to.kind, &self.checker.statement().bindings) else {
            return Err(Stuck::Malformed(step.to_string()));
        };
        let natural = bindings.iter().any(|b| b.natural && b.names.iter().any(|n| n.0.text == variable));
        let binding = Binding {
            names: vec![(Name { text: new.clone(), span: Span::default() }, None)],
            natural,
            constraints: self
                .least(variable)
                .map(|e| Constraint::Relation(Relation::GreaterEqual, e))
                .into_iter()
                .collect(),
            indices: None,
            span: Span::default(),
        };
        let goal = prop(PropKind::ForAll(vec![binding], Box::new(body.clone())));
        if let Some(label) = self.find(&goal) {
            return Ok(label);
        }
        let renaming = Renaming { from: variable, to, map, labels: self.labels.clone() };
        let label = self.emit(step, Rule::Let, &goal)?;
        self.again(&renaming);
        if self.find(&body).is_none() {
            self.emit(step, Rule::Combination { times: None, terms: Vec::new() }, &body)?;
        }
        self.end()?;
        self.labels = renaming.labels;
        Ok(label)
    }

    /// The hypotheses and the steps of the draft that mention a variable, with the variable renamed.
    fn again(&mut self, renaming: &Renaming) {
        for (old, label) in &renaming.labels {
            let Some(hypothesis) = old.starts_with('h').then(|| self.prop_of(label)).flatten() else { continue };
            if !super::mentions(&hypothesis, renaming.from) {
                continue;
            }
            let shown = renaming.map.prop(&hypothesis).ok().and_then(|p| match self.find(&p) {
                Some(label) => Some(label),
                None => self.emit(old, Rule::Combination { times: None, terms: Vec::new() }, &p).ok(),
            });
            match shown {
                Some(label) => self.labels.insert(old.clone(), label),
                None => self.labels.remove(old),
            };
        }
        let (past, opened) = (std::mem::take(&mut self.past), std::mem::take(&mut self.opened));
        let mut place = 0;
        while let Some(first) = past.get(place) {
            // What is supposed in a block that is open holds here as well.
            if opened.contains(&place) {
                place += 1;
                continue;
            }
            let group = place..place + block_length(&past, place);
            let steps: Vec<&draft::Step> = past.get(group.clone()).unwrap_or_default().iter().collect();
            place = group.end.max(place + 1);
            if steps.iter().any(|step| self.speaks(step, renaming)) && self.all_again(&steps, renaming).is_err() {
                self.labels.remove(&first.label);
            }
        }
        self.past = past;
        self.opened = opened;
    }

    /// Whether a step mentions the variable, or cites a step that does.
    fn speaks(&self, step: &draft::Step, renaming: &Renaming) -> bool {
        let mut names = BTreeSet::new();
        step.prop.iter().for_each(|p| names_in_prop(p, &mut names));
        let values = step.with.iter().map(|w| &w.1).chain(&step.times).chain(step.terms.iter().map(|t| &t.factor));
        values.for_each(|e| names_in(e, &mut names));
        names.contains(renaming.from)
            || step
                .from
                .iter()
                .chain(step.terms.iter().flat_map(|t| &t.facts))
                .any(|old| self.labels.get(old) != renaming.labels.get(old))
    }

    /// Repeats a step, or a whole block; leaves no trace if it fails.
    fn all_again(&mut self, steps: &[&draft::Step], renaming: &Renaming) -> Result<(), Stuck> {
        let renamed: Vec<draft::Step> = steps.iter().map(|s| self.renamed(s, renaming)).collect::<Result<_, _>>()?;
        let checker = self.checker.clone();
        let (labels, equations) = (self.labels.clone(), self.equations.clone());
        let (count, facts, blocks) = (self.steps.len(), self.facts.len(), self.blocks.len());
        let result = renamed.iter().try_for_each(|step| self.step(step));
        if result.is_err() {
            self.checker = checker;
            (self.labels, self.equations) = (labels, equations);
            self.steps.truncate(count);
            self.facts.truncate(facts);
            self.blocks.truncate(blocks);
        }
        self.past.clear();
        self.opened.clear();
        result
    }

    /// A step of the draft about the variable under its new name.
    fn renamed(&self, step: &draft::Step, renaming: &Renaming) -> Result<draft::Step, Stuck> {
        let malformed = |_| Stuck::Malformed(step.label.clone());
        let map = &renaming.map;
        let mut out = step.clone();
        out.prop = step.prop.as_ref().map(|p| map.prop(p)).transpose().map_err(malformed)?;
        out.times = step.times.as_ref().map(|e| map.expr(e)).transpose().map_err(malformed)?;
        for (_, value) in &mut out.with {
            *value = map.expr(value).map_err(malformed)?;
        }
        for term in &mut out.terms {
            term.factor = map.expr(&term.factor).map_err(malformed)?;
        }
        // A cited claim's variable without a value has its own name.
        let cited = step.from.first().filter(|_| step.rule == draft::Rule::Instance);
        if let Some(cited) = cited.and_then(|name| self.checker.cited_statement(name)) {
            let names =
                cited.bindings.iter().flat_map(|b| &b.names).filter(|n| n.1.is_none() && n.0.text == renaming.from);
            for (own, _) in names {
                if !step.with.iter().any(|w| w.0 == *own) {
                    out.with.push((own.clone(), renaming.to.clone()));
                }
            }
        }
        Ok(out)
    }

    /// The numeral from which a variable ranges.
    fn least(&self, variable: &str) -> Option<Expr> {
        let bounds = self.facts.iter().filter_map(|fact: &Fact| match &fact.prop.kind {
            PropKind::Compare(sides, relations) => match (sides.as_slice(), relations.as_slice()) {
                (
                    [Expr { kind: ExprKind::Name(n), .. }, bound @ Expr { kind: ExprKind::Number(text), .. }],
                    [Relation::Greater | Relation::GreaterEqual],
                ) if *n == variable => Some((text.clone(), bound.clone(), relations[0])),
                _ => None,
            },
            _ => None,
        });
        let greatest = bounds.max_by(|a, b| {
            let value = |text: &str| text.parse::<f64>().unwrap_or(0.0);
            value(&a.0).total_cmp(&value(&b.0))
        });
        let (text, bound, relation) = greatest?;
        // A strict bound starts the range at the next whole number.
        Some(match (relation, text.parse::<u64>()) {
            (Relation::Greater, Ok(k)) => crate::kernel::statement::expr(ExprKind::Number((k + 1).to_string())),
            _ => bound,
        })
    }
}

/// How many steps there are from one to the end of the block that it opens; 1 if it opens none.
fn block_length(steps: &[draft::Step], place: usize) -> usize {
    let mut depth = 0_usize;
    for (length, step) in steps.iter().skip(place).enumerate() {
        match step.rule {
            draft::Rule::Suppose | draft::Rule::Let => depth += 1,
            draft::Rule::End => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth == 0 {
            return length + 1;
        }
    }
    1
}
