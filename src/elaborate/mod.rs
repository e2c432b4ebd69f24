//! Certificates of format 1 written as certificates of format 2.
//!
//! Contract: [`elaborate`] returns a certificate that the kernel of format 2 accepted step by step, or says at which
//! step of the old one it got stuck. Nothing is searched: each old step becomes one new step (two or three where a
//! rule was split) with the facts that it rests on written out. The kernel says which those are.

use crate::certificate as old;
use crate::certificate2::{Certificate, Label, Rule, Show, Step, Term};
use crate::claim::syntax::*;
use crate::kernel2::{Accepted, Checker, Reason, Refusal, key};
use std::collections::HashMap;

/// Where an elaboration got stuck.
#[derive(Clone, Debug)]
pub enum Stuck {
    /// The kernel refuses the step that an old step became.
    Refused {
        /// The old step's label.
        step: Label,
        /// Its rule.
        rule: &'static str,
        /// What the kernel says.
        refusal: Box<Refusal>,
    },
    /// The old certificate is not well formed: a fact that is not there, a step without its proposition.
    Malformed(Label),
    /// A limit between two others, whose bounds are not carried over yet.
    Squeeze(Label),
    /// The kernel refuses the statement.
    Statement(Refusal),
    /// The kernel refuses the end.
    Unfinished(Refusal),
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
    equations: Vec<Label>,
}

struct Elaborator {
    checker: Checker,
    steps: Vec<Step>,
    facts: Vec<Fact>,
    /// The new labels of old facts.
    labels: HashMap<Label, Label>,
    /// Equations that are put in from where they were introduced on.
    equations: Vec<Label>,
    blocks: Vec<Block>,
    counter: usize,
}

/// The certificate of format 2 for an old one; `cited` holds what was accepted of the claims under `using`.
///
/// # Errors
/// Where it got stuck.
pub fn elaborate(
    claim: &Claim,
    certificate: &old::Certificate,
    cited: &[&Accepted],
) -> Result<(Certificate, Accepted), Stuck> {
    let checker = Checker::new(claim, cited).map_err(Stuck::Statement)?;
    let mut elaborator = Elaborator {
        facts: checker
            .facts()
            .map(|(label, prop)| Fact { label: label.to_string(), prop: prop.clone(), key: key::prop(prop) })
            .collect(),
        checker,
        steps: Vec::new(),
        labels: HashMap::new(),
        equations: Vec::new(),
        blocks: Vec::new(),
        counter: 0,
    };
    elaborator.hypotheses(claim)?;
    for step in &certificate.steps {
        elaborator.step(step)?;
    }
    // The goal is what the last step shows.
    let goal = elaborator.checker.statement().goal.clone();
    if elaborator.facts.last().is_none_or(|f| f.key != key::prop(&goal)) {
        let from = elaborator.find(&goal).into_iter().collect();
        elaborator.emit("qed", Rule::Logic { from }, &goal)?;
    }
    let digest = crate::certificate::text::digest(&elaborator.checker.statement().text());
    let certificate = Certificate { claim: claim.name.text.clone(), statement: digest, steps: elaborator.steps };
    let accepted = elaborator.checker.finish().map_err(Stuck::Unfinished)?;
    Ok((certificate, accepted))
}

impl Elaborator {
    /// The old kernel had no facts about families among the hypotheses; all others are found by what they say.
    fn hypotheses(&mut self, claim: &Claim) -> Result<(), Stuck> {
        let statement =
            crate::kernel::statement::Statement::of(claim).map_err(|failure| Stuck::Statement(failure.into()))?;
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

    /// The step with no more citations than it needs.
    fn trimmed(&mut self, show: Show) -> Result<Show, Refusal> {
        let used = self.checker.used(&show)?;
        let shorter = Show { by: used.by, using: used.using, ..show.clone() };
        match self.checker.used(&shorter) {
            Ok(used) => {
                let shortest = Show { by: used.by, using: used.using, ..shorter.clone() };
                Ok(if self.checker.used(&shortest).is_ok() { shortest } else { shorter })
            }
            Err(_) => Ok(show),
        }
    }

    /// Adds a step that the kernel accepts; returns its label.
    fn emit(&mut self, old: &str, rule: Rule, prop: &Prop) -> Result<Label, Stuck> {
        let name = rule.name();
        let label = (self.counter + 1).to_string();
        let show =
            Show { label: label.clone(), rule, prop: prop.clone(), by: self.signs(), using: self.equations.clone() };
        let refused = |refusal| Stuck::Refused { step: old.to_string(), rule: name, refusal: Box::new(refusal) };
        let show = self.trimmed(show).map_err(refused)?;
        let opens = matches!(show.rule, Rule::Suppose | Rule::Let);
        let step = Step::Show(Box::new(show));
        self.checker.step(&step).map_err(refused)?;
        self.counter += 1;
        if opens {
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

    /// Takes over the facts that the kernel has and this list does not.
    fn take_in(&mut self) {
        let new = self.checker.facts().skip(self.facts.len());
        let new: Vec<Fact> =
            new.map(|(label, p)| Fact { label: label.to_string(), prop: p.clone(), key: key::prop(p) }).collect();
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

    /// One old step.
    fn step(&mut self, step: &old::Step) -> Result<(), Stuck> {
        if step.rule == old::Rule::End {
            return self.end();
        }
        let cited = step.from.first().map(String::as_str).unwrap_or_default();
        match step.rule {
            // What a fact says of signs is read wherever the fact is cited.
            old::Rule::Note => return Ok(()),
            old::Rule::Replace => {
                let label = self.label(cited)?;
                self.put_in(label);
                return Ok(());
            }
            _ => {}
        }
        let prop = step.prop.as_ref().ok_or_else(|| Stuck::Malformed(step.label.clone()))?;
        let rule = match step.rule {
            old::Rule::Power => {
                // A power that is an atom of its own needs no introduction.
                if let PropKind::Compare(sides, _) = &prop.kind
                    && let [a, b] = sides.as_slice()
                    && key::expr(a) == key::expr(b)
                {
                    return Ok(());
                }
                Rule::Power
            }
            old::Rule::Logarithm => Rule::Power,
            old::Rule::Unfold => Rule::Unfold,
            old::Rule::Sign => Rule::Combination { times: None, terms: Vec::new() },
            old::Rule::Combination => {
                let terms = step.terms.iter().map(|term| {
                    let facts = term.facts.iter().map(|f| self.label(f)).collect::<Result<Vec<_>, _>>()?;
                    Ok(Term { facts, factor: term.factor.clone() })
                });
                Rule::Combination { times: step.times.clone(), terms: terms.collect::<Result<_, Stuck>>()? }
            }
            old::Rule::Suppose => Rule::Suppose,
            old::Rule::Let => Rule::Let,
            old::Rule::All
            | old::Rule::Part
            | old::Rule::Either
            | old::Rule::Excluded
            | old::Rule::Cases
            | old::Rule::Apply
            | old::Rule::Equivalent
            | old::Rule::Negation => Rule::Logic { from: self.premises(step, prop)? },
            old::Rule::Absurd => self.absurd(step)?,
            old::Rule::Member => self.member(step, prop)?,
            old::Rule::Instance => {
                let source = self.labels.get(cited).cloned().unwrap_or_else(|| cited.to_string());
                Rule::Instance { source, with: step.with.clone(), from: self.domain_facts() }
            }
            old::Rule::Induction => self.induction(step, prop)?,
            old::Rule::Witness => Rule::Witness { with: step.with.clone(), from: self.domain_facts() },
            old::Rule::Extremum => Rule::Extremum { from: self.domain_facts() },
            old::Rule::Monotone => Rule::Monotone { from: self.label(cited)? },
            old::Rule::Mean => Rule::Mean { with: step.with.clone() },
            old::Rule::Limit => Rule::Limit { with: self.least(prop) },
            // Its bounds speak of the claim's variable; here they would have to hold for every large value.
            old::Rule::Squeeze => return Err(Stuck::Squeeze(step.label.clone())),
            old::Rule::Note | old::Rule::Replace | old::Rule::End => return Ok(()),
        };
        let rule = self.short(rule, prop);
        let label = self.emit(&step.label, rule, prop)?;
        self.labels.insert(step.label.clone(), label.clone());
        match step.rule {
            old::Rule::Suppose => {
                self.labels.insert(format!("{}s", step.label), format!("{label}s"));
            }
            old::Rule::Let => {
                for place in 1..=self.facts.len() {
                    self.labels.insert(format!("{}d{place}", step.label), format!("{label}d{place}"));
                }
            }
            // From here on the old kernel wrote the power as the other side.
            old::Rule::Power => self.put_in(label),
            _ => {}
        }
        Ok(())
    }

    /// Puts an equation in from here on. A variable that is replaced again is replaced by its last value.
    fn put_in(&mut self, label: Label) {
        let left = |p: Option<Prop>| match p.map(|p| p.kind) {
            Some(PropKind::Compare(sides, _)) => sides.first().map(key::expr),
            _ => None,
        };
        let Some(prop) = self.prop_of(&label) else { return };
        let same = left(Some(prop.clone()));
        let before = self.equations.clone();
        self.equations
            .retain(|e| left(self.facts.iter().rev().find(|f| f.label == *e).map(|f| f.prop.clone())) != same);
        if self.checker.can_be_put_in(&prop, &self.equations) {
            self.equations.push(label);
        } else {
            self.equations = before;
        }
    }

    /// All facts, for rules whose premises are found by what they say; [`Elaborator::short`] leaves those it needs.
    fn domain_facts(&self) -> Vec<Label> {
        self.facts.iter().map(|f| f.label.clone()).collect()
    }

    /// The rule without the facts under `from` that it does not need, tried one half after the other.
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
        let (by, using) = (self.signs(), self.equations.clone());
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

    /// The facts that a step of logic of the old kernel looked up.
    fn premises(&self, step: &old::Step, goal: &Prop) -> Result<Vec<Label>, Stuck> {
        let missing = || Stuck::Malformed(step.label.clone());
        let cited: Vec<Label> = step.from.iter().map(|f| self.label(f)).collect::<Result<_, _>>()?;
        let implies = |p: &Prop, q: &Prop| Prop {
            kind: PropKind::Implies(Box::new(p.clone()), Box::new(q.clone())),
            span: Span::default(),
        };
        let needed: Vec<Prop> = match step.rule {
            old::Rule::All => parts(goal),
            old::Rule::Either => match &goal.kind {
                PropKind::Or(list) => list.iter().find(|p| self.find(p).is_some()).cloned().into_iter().collect(),
                _ => return Err(missing()),
            },
            old::Rule::Cases => match cited.first().and_then(|label| self.prop_of(label)).map(|p| p.kind) {
                Some(PropKind::Or(list)) => list.iter().map(|case| implies(case, goal)).collect(),
                _ => return Err(missing()),
            },
            old::Rule::Apply => match cited.first().and_then(|label| self.prop_of(label)).map(|p| p.kind) {
                Some(PropKind::Implies(p, _)) => vec![*p],
                Some(PropKind::Equivalent(list)) => {
                    list.into_iter().find(|p| self.find(p).is_some()).into_iter().collect()
                }
                _ => return Err(missing()),
            },
            old::Rule::Equivalent => match &goal.kind {
                PropKind::Equivalent(list) => list
                    .windows(2)
                    .flat_map(|pair| match pair {
                        [p, q] => vec![implies(p, q), implies(q, p)],
                        _ => Vec::new(),
                    })
                    .collect(),
                _ => return Err(missing()),
            },
            _ => Vec::new(),
        };
        let mut from = cited;
        for prop in needed {
            from.push(self.find(&prop).ok_or_else(missing)?);
        }
        Ok(from)
    }

    /// The comparison of numbers that a fact comes to, which is false.
    fn absurd(&mut self, step: &old::Step) -> Result<Rule, Stuck> {
        let missing = || Stuck::Malformed(step.label.clone());
        let label = self.label(step.from.first().map(String::as_str).unwrap_or_default())?;
        let fact = self.prop_of(&label).ok_or_else(missing)?;
        let PropKind::Compare(_, relations) = &fact.kind else { return Err(missing()) };
        let using = self.equations.clone();
        let Ok(Some(number)) = self.checker.constant(&fact, &using) else { return Err(missing()) };
        use crate::kernel::statement::{compare, expr, numeral};
        let digits = |n: num_bigint::BigInt| expr(ExprKind::Number(n.to_string()));
        let size = num_traits::Signed::abs(&number);
        let mut value = digits(size.numer().clone());
        if !size.is_integer() {
            value = expr(ExprKind::Product(vec![(Factor::Times, value), (Factor::Over, digits(size.denom().clone()))]));
        }
        if num_traits::Signed::is_negative(&number) {
            value = expr(ExprKind::Negate(Box::new(value)));
        }
        let false_one = compare(value, relations[0], numeral(0));
        let terms = vec![Term { facts: vec![label], factor: numeral(1) }];
        let shown = self.emit(&step.label, Rule::Combination { times: None, terms }, &false_one)?;
        Ok(Rule::Logic { from: vec![shown] })
    }

    /// A member's domain is an instance of what the declaration says of the family.
    fn member(&mut self, step: &old::Step, prop: &Prop) -> Result<Rule, Stuck> {
        let missing = || Stuck::Malformed(step.label.clone());
        let PropKind::Compare(sides, _) = &prop.kind else { return Err(missing()) };
        let Some(ExprKind::Apply(family, arguments)) = sides.first().map(|e| &e.kind) else { return Err(missing()) };
        let [argument] = arguments.as_slice() else { return Err(missing()) };
        for fact in self.facts.clone() {
            let PropKind::ForAll(bindings, body) = &fact.prop.kind else { continue };
            let [binding] = bindings.as_slice() else { continue };
            let ([(index, None)], true) = (binding.names.as_slice(), fact.label.starts_with('h')) else { continue };
            if !mentions(body, &family.text) {
                continue;
            }
            let with = vec![(index.clone(), argument.clone())];
            let source = fact.label.clone();
            let mut map = crate::kernel::statement::Substitution::default();
            map.replace(&index.text, argument);
            let Ok(whole) = map.prop(body) else { continue };
            if key::prop(&whole) == key::prop(prop) {
                return Ok(Rule::Instance { source, with, from: self.domain_facts() });
            }
            // One of several constraints: all of them first.
            let rule = Rule::Instance { source, with, from: self.domain_facts() };
            let rule = self.short(rule, &whole);
            let all = self.emit(&step.label, rule, &whole)?;
            return Ok(Rule::Logic { from: vec![all] });
        }
        Err(missing())
    }

    fn induction(&mut self, step: &old::Step, prop: &Prop) -> Result<Rule, Stuck> {
        let missing = || Stuck::Malformed(step.label.clone());
        let PropKind::ForAll(bindings, body) = &prop.kind else { return Err(missing()) };
        let [binding] = bindings.as_slice() else { return Err(missing()) };
        let [(variable, None)] = binding.names.as_slice() else { return Err(missing()) };
        use crate::kernel::statement::{Substitution, expr, name, numeral};
        let first = match binding.constraints.as_slice() {
            [Constraint::Relation(_, bound)] => bound.clone(),
            _ => numeral(0),
        };
        let next = expr(ExprKind::Sum(vec![(Sign::Plus, name(&variable.text)), (Sign::Plus, numeral(1))]));
        let at = |value: &Expr| {
            let mut map = Substitution::default();
            map.replace(&variable.text, value);
            map.prop(body).map_err(|_| missing())
        };
        let advance = Prop { kind: PropKind::Implies(body.clone(), Box::new(at(&next)?)), span: prop.span };
        let advance = Prop { kind: PropKind::ForAll(bindings.clone(), Box::new(advance)), span: prop.span };
        Ok(Rule::Induction {
            base: self.find(&at(&first)?).ok_or_else(missing)?,
            advance: self.find(&advance).ok_or_else(missing)?,
        })
    }

    /// From which numeral on the variable of a limit is known to range.
    fn least(&self, prop: &Prop) -> Vec<(Name, Expr)> {
        let PropKind::Limit(limit) = &prop.kind else { return Vec::new() };
        let bounds = self.facts.iter().filter_map(|fact| match &fact.prop.kind {
            PropKind::Compare(sides, relations) => match (sides.as_slice(), relations.as_slice()) {
                (
                    [Expr { kind: ExprKind::Name(n), .. }, bound @ Expr { kind: ExprKind::Number(text), .. }],
                    [Relation::Greater | Relation::GreaterEqual],
                ) if *n == limit.variable.text => Some((text.clone(), bound.clone(), relations[0])),
                _ => None,
            },
            _ => None,
        });
        let greatest = bounds.max_by(|a, b| {
            let value = |text: &str| text.parse::<f64>().unwrap_or(0.0);
            value(&a.0).total_cmp(&value(&b.0))
        });
        let Some((text, bound, relation)) = greatest else { return Vec::new() };
        // From the next whole number on, where the bound itself is left out.
        let value = match (relation, text.parse::<u64>()) {
            (Relation::Greater, Ok(k)) => crate::kernel::statement::expr(ExprKind::Number((k + 1).to_string())),
            _ => bound,
        };
        vec![(Name { text: "from".to_string(), span: Span::default() }, value)]
    }
}

/// The parts of a conjunction or chain.
fn parts(p: &Prop) -> Vec<Prop> {
    match &p.kind {
        PropKind::And(list) => list.clone(),
        PropKind::Compare(sides, relations) => sides
            .windows(2)
            .zip(relations)
            .map(|(pair, r)| Prop { kind: PropKind::Compare(pair.to_vec(), vec![*r]), span: p.span })
            .collect(),
        _ => Vec::new(),
    }
}

fn mentions(p: &Prop, name: &str) -> bool {
    let mut names = std::collections::BTreeSet::new();
    crate::kernel::statement::names_in_prop(p, &mut names);
    names.contains(name)
}
