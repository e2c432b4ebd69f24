//! Drafts written as certificates: the last stage of the search.
//!
//! Contract: [`elaborate`] returns a certificate that the kernel accepted step by step, or says at which step of the
//! draft it got stuck. There is no search: each step of a draft becomes one step of the certificate, or two or three where
//! the kernel's rules are smaller. Each step cites the facts that the kernel needs for it. Steps that the goal does not
//! need are kept.

mod equations;
mod limit;
mod logic;
mod otherwise;

use crate::algebra::Moment;
use crate::certificate::{Certificate, Label, Rule, Show, Step, Term};
use crate::claim::syntax::*;
use crate::kernel::names::names_in_prop;
use crate::kernel::{Accepted, Checker, Reason, Refusal, key};
use crate::prove::brief::take;
use crate::prove::draft;
use equations::{Equation, Kind};
use std::collections::{BTreeSet, HashMap};

/// Where an elaboration got stuck.
#[derive(Clone, Debug)]
pub enum Stuck {
    /// The kernel rejects the step made from a step of the draft.
    Refused {
        /// Its label in the draft.
        step: Label,
        /// Its rule.
        rule: &'static str,
        /// What the kernel says.
        refusal: Box<Refusal>,
    },
    /// The draft is malformed: it cites an unknown fact, or a step has no proposition.
    Malformed(Label),
    /// The kernel rejects the statement.
    Statement(Refusal),
    /// The kernel rejects the end of the certificate.
    Unfinished(Refusal),
    /// The time limit was reached.
    Time,
}

/// A fact of the new certificate.
#[derive(Clone)]
struct Fact {
    label: Label,
    prop: Prop,
    key: String,
}

/// An open block, with what is forgotten at its end.
struct Block {
    label: Label,
    goal: Prop,
    facts: usize,
    equations: Vec<Equation>,
}

struct Elaborator {
    checker: Checker,
    steps: Vec<Step>,
    facts: Vec<Fact>,
    /// The labels by those of the draft.
    labels: HashMap<Label, Label>,
    /// Equations that are put in from where they were introduced on.
    equations: Vec<Equation>,
    blocks: Vec<Block>,
    counter: usize,
    /// The steps of the draft so far.
    past: Vec<draft::Step>,
    /// The places among them of those that opened a block that is open.
    opened: Vec<usize>,
    /// Names that are in use somewhere.
    names: BTreeSet<String>,
    deadline: Option<Moment>,
}

/// Writes the steps of a draft as a certificate; `cited` holds the accepted claims under `using`.
///
/// # Errors
/// Where it got stuck.
pub(crate) fn elaborate(
    claim: &Claim,
    draft: &[draft::Step],
    cited: &[&Accepted],
    deadline: Option<Moment>,
) -> Result<Certificate, Stuck> {
    let checker = Checker::new(claim, cited).map_err(Stuck::Statement)?;
    let mut names = checker.statement().names();
    for step in draft {
        step.prop.iter().for_each(|p| names_in_prop(p, &mut names));
    }
    let mut elaborator = Elaborator {
        facts: checker
            .facts()
            .map(|(label, prop)| Fact { label: label.to_string(), prop: (**prop).clone(), key: key::prop(prop) })
            .collect(),
        checker,
        steps: Vec::new(),
        labels: HashMap::new(),
        equations: Vec::new(),
        blocks: Vec::new(),
        counter: 0,
        past: Vec::new(),
        opened: Vec::new(),
        names,
        deadline,
    };
    elaborator.hypotheses(claim)?;
    for step in draft {
        elaborator.in_time()?;
        elaborator.step(step)?;
    }
    // The goal is what the last step shows.
    let goal = elaborator.checker.statement().goal.clone();
    if elaborator.facts.last().is_none_or(|f| f.key != key::prop(&goal)) {
        let from = elaborator.find(&goal).into_iter().collect();
        elaborator.emit("qed", Rule::Logic { from }, &goal)?;
    }
    let digest = crate::certificate::text::digest(&elaborator.checker.statement().text());
    elaborator.checker.finish().map_err(Stuck::Unfinished)?;
    Ok(Certificate { claim: claim.name.text.clone(), statement: digest, refutes: None, steps: elaborator.steps })
}

impl Elaborator {
    /// Matches the draft's hypotheses with the kernel's by their text; the draft has no facts about families.
    fn hypotheses(&mut self, claim: &Claim) -> Result<(), Stuck> {
        let statement = crate::kernel::statement::Statement::of(claim).map_err(Stuck::Statement)?;
        let domains = statement.bindings.iter().flat_map(crate::kernel::statement::domain);
        let mut taken = std::collections::BTreeSet::new();
        for (place, prop) in domains.chain(statement.assumptions.iter().cloned()).enumerate() {
            let wanted = key::prop(&prop);
            let found = self.facts.iter().find(|f| f.key == wanted && !taken.contains(&f.label));
            let Some(found) = found else { return Err(Stuck::Malformed(format!("h{}", place + 1))) };
            taken.insert(found.label.clone());
            self.labels.insert(format!("h{}", place + 1), found.label.clone());
        }
        Ok(())
    }

    fn in_time(&self) -> Result<(), Stuck> {
        if self.deadline.is_some_and(|deadline| Moment::now() > deadline) { Err(Stuck::Time) } else { Ok(()) }
    }

    fn label(&self, old: &str) -> Result<Label, Stuck> {
        self.labels.get(old).cloned().ok_or_else(|| Stuck::Malformed(old.to_string()))
    }

    /// A fact that says this.
    fn find(&self, prop: &Prop) -> Option<Label> {
        let wanted = key::prop(prop);
        self.facts.iter().rev().find(|f| f.key == wanted).map(|f| f.label.clone())
    }

    fn prop_of(&self, label: &str) -> Option<Prop> {
        self.facts.iter().rev().find(|f| f.label == label).map(|f| f.prop.clone())
    }

    /// The facts whose signs a step may use.
    fn signs(&self) -> Vec<Label> {
        let speaks = |p: &Prop| matches!(p.kind, PropKind::Compare(..) | PropKind::And(_) | PropKind::ForAll(..));
        self.facts.iter().filter(|f| speaks(&f.prop)).map(|f| f.label.clone()).collect()
    }

    /// Adds a step that the kernel accepts; returns its label.
    fn emit(&mut self, old: &str, rule: Rule, prop: &Prop) -> Result<Label, Stuck> {
        self.in_time()?;
        let label = (self.counter + 1).to_string();
        let refused = |refusal| Stuck::Refused { step: old.to_string(), rule: rule.name(), refusal: Box::new(refusal) };
        let by = self.signs();
        let mut first = None;
        let mut found = None;
        for using in self.lists(&rule) {
            let show = Show { label: label.clone(), rule: rule.clone(), prop: prop.clone(), by: by.clone(), using };
            match take(&mut self.checker, show) {
                Ok(step) => {
                    found = Some(step);
                    break;
                }
                Err(refusal) => first = first.or(Some(refusal)),
            }
        }
        let Some(step) = found else {
            return Err(refused(first.unwrap_or(Refusal::Rejected(Reason::Signs))));
        };
        self.counter += 1;
        if matches!(&step, Step::Show(show) if show.opens()) {
            self.blocks.push(Block {
                label: label.clone(),
                goal: prop.clone(),
                facts: self.facts.len(),
                equations: self.equations.clone(),
            });
        }
        self.take_in();
        self.steps.push(step);
        Ok(label)
    }

    /// Adds the kernel's new facts to the list.
    fn take_in(&mut self) {
        let new = self.checker.facts().skip(self.facts.len());
        let new: Vec<Fact> =
            new.map(|(label, p)| Fact { label: label.to_string(), prop: (**p).clone(), key: key::prop(p) }).collect();
        self.facts.extend(new);
    }

    fn end(&mut self) -> Result<(), Stuck> {
        let Some(block) = self.blocks.pop() else { return Err(Stuck::Malformed("end".to_string())) };
        let (PropKind::Implies(_, q) | PropKind::ForAll(_, q)) = &block.goal.kind else {
            return Err(Stuck::Malformed(block.label));
        };
        let refused = |refusal| Stuck::Refused { step: block.label.clone(), rule: "end", refusal: Box::new(refusal) };
        let Some(conclusion) = self.find(q) else {
            return Err(refused(Refusal::Rejected(Reason::OtherConclusion(String::new()))));
        };
        let step = Step::End(conclusion);
        self.checker.step(&step).map_err(refused)?;
        self.facts.truncate(block.facts);
        self.equations = block.equations;
        self.take_in();
        self.steps.push(step);
        Ok(())
    }

    /// One step of the draft.
    fn step(&mut self, step: &draft::Step) -> Result<(), Stuck> {
        self.new_steps(step)?;
        match step.rule {
            draft::Rule::Suppose | draft::Rule::Let => self.opened.push(self.past.len()),
            draft::Rule::End => drop(self.opened.pop()),
            _ => {}
        }
        self.past.push(step.clone());
        Ok(())
    }

    /// What a step of the draft becomes.
    fn new_steps(&mut self, step: &draft::Step) -> Result<(), Stuck> {
        if step.rule == draft::Rule::End {
            return self.end();
        }
        let cited = step.from.first().map(String::as_str).unwrap_or_default();
        match step.rule {
            // The kernel reads the sign of a fact wherever the fact is cited, so this needs no step.
            draft::Rule::Note => return Ok(()),
            draft::Rule::Replace => {
                let label = self.label(cited)?;
                self.put_in(label, Kind::Replaced);
                return Ok(());
            }
            _ => {}
        }
        let prop = step.prop.as_ref().ok_or_else(|| Stuck::Malformed(step.label.clone()))?;
        if let PropKind::Compare(sides, _) = &prop.kind
            && step.rule == draft::Rule::Power
            && let [a, b] = sides.as_slice()
            && key::expr(a) == key::expr(b)
        {
            // A power that others are written by.
            return self.named(&step.label, a);
        }
        if matches!(step.rule, draft::Rule::Limit | draft::Rule::Squeeze) {
            let label =
                if step.rule == draft::Rule::Limit { self.limit(step, prop) } else { self.squeeze(step, prop) }?;
            self.labels.insert(step.label.clone(), label);
            return Ok(());
        }
        let Some(rule) = self.rule(step, prop)? else { return Ok(()) };
        let rule = self.short(rule, prop);
        let label = match self.emit(&step.label, rule.clone(), prop) {
            Err(stuck) => self.otherwise(step, rule, prop).ok_or(stuck)?,
            Ok(label) => label,
        };
        self.labels.insert(step.label.clone(), label.clone());
        match step.rule {
            draft::Rule::Suppose => {
                self.labels.insert(format!("{}s", step.label), format!("{label}s"));
            }
            draft::Rule::Let => {
                for place in 1..=self.facts.len() {
                    self.labels.insert(format!("{}d{place}", step.label), format!("{label}d{place}"));
                }
            }
            // From here on the draft wrote the power as the other side.
            draft::Rule::Power => self.put_in(label, Kind::Written),
            _ => {}
        }
        Ok(())
    }

    /// The kernel's rule for a step of the draft; none for steps that become no step or several.
    fn rule(&mut self, step: &draft::Step, prop: &Prop) -> Result<Option<Rule>, Stuck> {
        let cited = step.from.first().map(String::as_str).unwrap_or_default();
        Ok(Some(match step.rule {
            draft::Rule::Power | draft::Rule::Logarithm => Rule::Power,
            draft::Rule::Unfold => Rule::Unfold,
            draft::Rule::Sign => Rule::Combination { times: None, terms: Vec::new() },
            draft::Rule::Combination => {
                let terms = step.terms.iter().map(|term| {
                    let facts = term.facts.iter().map(|f| self.label(f)).collect::<Result<Vec<_>, _>>()?;
                    Ok(Term { facts, factor: term.factor.clone() })
                });
                Rule::Combination { times: step.times.clone(), terms: terms.collect::<Result<_, Stuck>>()? }
            }
            draft::Rule::Suppose => Rule::Suppose,
            draft::Rule::Let => Rule::Let,
            draft::Rule::All
            | draft::Rule::Part
            | draft::Rule::Either
            | draft::Rule::Excluded
            | draft::Rule::Cases
            | draft::Rule::Apply
            | draft::Rule::Equivalent
            | draft::Rule::Negation => Rule::Logic { from: self.premises(step, prop)? },
            draft::Rule::Absurd => self.absurd(step)?,
            draft::Rule::Instance => {
                let source = self.labels.get(cited).cloned().unwrap_or_else(|| cited.to_string());
                Rule::Instance { source, with: step.with.clone(), from: self.domain_facts() }
            }
            draft::Rule::Induction => self.induction(step, prop)?,
            draft::Rule::Witness => Rule::Witness { with: step.with.clone(), from: self.domain_facts() },
            draft::Rule::Extremum => Rule::Extremum { from: self.domain_facts() },
            draft::Rule::Monotone => Rule::Monotone { from: self.label(cited)? },
            draft::Rule::Mean => Rule::Mean { with: step.with.clone() },
            draft::Rule::Limit | draft::Rule::Squeeze | draft::Rule::Note | draft::Rule::Replace | draft::Rule::End => {
                return Ok(None);
            }
        }))
    }

    /// A name that is not in use anywhere: the stem and a number.
    fn fresh_name(&mut self, stem: &str) -> String {
        let fresh = (1..).map(|k| format!("{stem}{k}")).find(|n| !self.names.contains(n)).unwrap_or_default();
        self.names.insert(fresh.clone());
        fresh
    }

    /// All facts, for rules whose premises are found by what they say; [`Elaborator::short`] leaves those it needs.
    fn domain_facts(&self) -> Vec<Label> {
        self.facts.iter().map(|f| f.label.clone()).collect()
    }

    /// The rule without unneeded facts under `from`; it tries to drop one half after the other.
    fn short(&mut self, rule: Rule, prop: &Prop) -> Rule {
        let all = match &rule {
            Rule::Instance { from, .. } | Rule::Witness { from, .. } | Rule::Extremum { from } => from.clone(),
            _ => return rule,
        };
        let with_from = |from: Vec<Label>| match &rule {
            Rule::Instance { source, with, .. } => Rule::Instance { source: source.clone(), with: with.clone(), from },
            Rule::Witness { with, .. } => Rule::Witness { with: with.clone(), from },
            _ => Rule::Extremum { from },
        };
        let (by, using) = (self.signs(), self.using());
        let mut holds = |from: Vec<Label>| {
            let show = Show {
                label: "x".to_string(),
                rule: with_from(from),
                prop: prop.clone(),
                by: by.clone(),
                using: using.clone(),
            };
            self.checker.used(&show).is_ok()
        };
        let mut kept = all;
        let mut size = kept.len().div_ceil(2);
        while size > 0 {
            let mut start = 0;
            while start < kept.len() {
                let mut fewer = kept.clone();
                fewer.drain(start..(start + size).min(kept.len()));
                if holds(fewer.clone()) { kept = fewer } else { start += size }
            }
            size /= 2;
        }
        with_from(kept)
    }
}

fn is_equation(p: &Prop) -> bool {
    matches!(&p.kind, PropKind::Compare(_, relations) if *relations == [Relation::Equal])
}

fn mentions(p: &Prop, name: &str) -> bool {
    let mut names = std::collections::BTreeSet::new();
    crate::kernel::names::names_in_prop(p, &mut names);
    names.contains(name)
}
