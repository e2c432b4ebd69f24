//! Proofs for Coq from certificates: each step becomes an assertion with a proof by the lemma of its rule.
//!
//! Contract: the text of [`proof()`] is a file for Coq whose theorem is the statement of [`super::statement`]. Coq checks it:
//! a mistake here can only make a proof that Coq does not accept. What an expression comes to, and which signs the cited
//! facts give, the kernel says (`crate::kernel::words`).

use super::super::Unsupported;
use super::super::kinds::{self, Kind};
use super::printer::marked;
use super::*;
use crate::certificate::{Certificate, Label, Rule, Show, Step, Term};
use crate::claim::substitution::Obstacle;
use crate::kernel::fraction::{Fraction, Poly};
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, constraints, expr, name, sum};
use crate::kernel::words::{Form, Signed};
use crate::kernel::{Accepted, Checker, Refusal, key};
use num_rational::BigRational;
use num_traits::{One, Signed as _};
use std::rc::Rc;

mod arithmetic;
mod identity;
mod leaves;
mod limits;
mod logarithms;
mod matrices;
mod powers;
mod roots;
mod rules;
mod signs;
mod slopes;

/// A proof.
#[derive(Clone, Debug)]
pub struct Proof {
    /// The file for Coq.
    pub text: String,
    /// The claims whose files it imports.
    pub cites: BTreeSet<String>,
}

/// Why there is no proof for Coq.
#[derive(Clone, Debug)]
pub enum Open {
    /// Coq cannot say something.
    Unsupported(Unsupported),
    /// The kernel does not take a step.
    Refused(Refusal),
    /// A step that is not translated yet: its label and what is missing.
    Untranslated(Label, &'static str),
}

impl From<Unsupported> for Open {
    fn from(reason: Unsupported) -> Open {
        Open::Unsupported(reason)
    }
}

impl From<Obstacle> for Open {
    fn from(obstacle: Obstacle) -> Open {
        Refusal::from(obstacle).into()
    }
}

impl From<Refusal> for Open {
    fn from(refusal: Refusal) -> Open {
        Open::Refused(refusal)
    }
}

/// What may stay open.
pub type Found<T> = std::result::Result<T, Open>;

/// The steps of a certificate as a script for Coq, with the claims that it cites.
pub struct Script {
    /// What begins the proof, up to the fact that says the goal.
    pub text: String,
    /// The hypothesis that says it.
    pub shown: String,
    /// The claims whose files it needs.
    pub cites: BTreeSet<String>,
}

/// The file that proves a claim from its certificate; `cited` holds what was accepted of the claims under `using`, and
/// `claims` finds the claims themselves.
///
/// # Errors
/// Why there is none.
pub fn proof(
    claim: &Claim,
    certificate: &Certificate,
    cited: &[&Accepted],
    claims: &dyn Fn(&str) -> Option<Claim>,
) -> Found<Proof> {
    let stated = statement(claim)?;
    let script = script(claim, certificate, cited, claims)?;
    let mut text = imports(&script.cites);
    text += &format!(
        "\n(* statement sha256 {} *)\nTheorem {} :\n{}.\nProof.\n{}\n  finish {}.\nQed.\n",
        stated.digest, stated.name, stated.full, script.text, script.shown
    );
    Ok(Proof { text, cites: script.cites })
}

/// What a file begins with that needs the files of these claims.
pub fn imports(cites: &BTreeSet<String>) -> String {
    let mut text = String::from("From Carom Require Import vocabulary rules points.\n");
    cites.iter().for_each(|cited| text += &format!("From Carom Require {}.\n", identifier(cited)));
    text
}

/// The script that shows a claim's statement, or another one with the same declarations, hypotheses and goal.
///
/// # Errors
/// Why there is none.
pub fn script(
    claim: &Claim,
    certificate: &Certificate,
    cited: &[&Accepted],
    claims: &dyn Fn(&str) -> Option<Claim>,
) -> Found<Script> {
    let premises = statement(claim)?.premises;
    let checker = Checker::new(claim, cited)?;
    let mut printer = Printer { inside: true, ..Printer::of_claim(claim) };
    for name in checker.statement().names() {
        printer.word(&name);
    }
    let mut writer = Writer {
        checker,
        printer,
        claims,
        out: Vec::new(),
        depth: 1,
        counter: 0,
        shown: Vec::new(),
        blocks: Vec::new(),
        busy: Vec::new(),
        cites: BTreeSet::new(),
        shape: None,
        expands: false,
    };
    // What is claimed may itself begin with `forall`, which stays.
    writer.put(&format!("cbv beta zeta. do {premises} intro. apart_all."));
    writer.facts(0)?;
    for step in &certificate.steps {
        writer.step(step)?;
    }
    let last = writer.checker.facts().last().map(|f| f.0.to_string()).unwrap_or_default();
    Ok(Script { text: writer.out.join("\n"), shown: fact(&last), cites: writer.cites })
}

/// The name of the Coq hypothesis for a fact. It contains `__`, which no name of a claim does.
fn fact(label: &str) -> String {
    format!("H__{label}")
}

/// A set of signs in the library's words.
fn signs_word(signs: Signs) -> String {
    let named = [
        (Relation::Less, "LT"),
        (Relation::LessEqual, "LE"),
        (Relation::Equal, "EQ"),
        (Relation::NotEqual, "NE"),
        (Relation::GreaterEqual, "GE"),
        (Relation::Greater, "GT"),
    ];
    match named.iter().find(|(relation, _)| Signs::of(*relation) == signs) {
        Some((_, word)) => (*word).to_string(),
        None if signs.within(Signs::POSITIVE) && signs.within(Signs::ZERO) => "(S3 false false false)".to_string(),
        None => "(S3 true true true)".to_string(),
    }
}

fn lower(relation: Relation) -> &'static str {
    match relation {
        Relation::Less => "lt",
        Relation::LessEqual => "le",
        Relation::Equal => "eq",
        Relation::NotEqual => "ne",
        Relation::GreaterEqual => "ge",
        Relation::Greater => "gt",
    }
}

/// A number as the library's trees of signs have it.
fn number_text(q: &BigRational) -> String {
    let top = if q.is_negative() { format!("({})", q.numer()) } else { q.numer().to_string() };
    if q.denom().is_one() { top } else { format!("({top} / {})", q.denom()) }
}

struct Writer<'a> {
    checker: Checker,
    printer: Printer,
    claims: &'a dyn Fn(&str) -> Option<Claim>,
    out: Vec<String>,
    depth: usize,
    counter: usize,
    /// The asserted statements, with depth and name.
    shown: Vec<(usize, String, String)>,
    /// The values of names, and which are positive, outside the open blocks.
    blocks: Vec<(kinds::Kinds, Positive)>,
    /// The statement being proved, which its own proof must not use.
    busy: Vec<String>,
    cites: BTreeSet<String>,
    /// The variables of the identity that is being written.
    shape: Option<identity::Shape>,
    /// Whether logarithms are written as sums.
    expands: bool,
}

/// The facts from which a step reads signs, and the equations that it substitutes.
struct Given {
    signed: Rc<Signed>,
    using: Vec<Label>,
}

impl Writer<'_> {
    fn put(&mut self, line: &str) {
        self.out.push(format!("{}{line}", "  ".repeat(self.depth)));
    }

    fn fresh(&mut self, letter: &str) -> String {
        self.counter += 1;
        format!("{letter}__{}", self.counter)
    }

    /// Asserts something once; returns the hypothesis.
    fn lemma(&mut self, letter: &str, statement: &str, tactic: &str) -> String {
        if let Some(found) = self.shown.iter().find(|s| s.1 == statement) {
            return found.2.clone();
        }
        let hypothesis = self.fresh(letter);
        self.put(&format!("assert ({hypothesis} : {statement}). {{ {tactic}. }}"));
        self.shown.push((self.depth, statement.to_string(), hypothesis.clone()));
        hypothesis
    }

    // Text.

    fn expr(&mut self, e: &Expr) -> Found<String> {
        Ok(self.printer.real_at(e, ATOM)?)
    }

    fn prop(&mut self, p: &Prop) -> Found<String> {
        Ok(self.printer.prop_at(p, ATOM)?)
    }

    fn atom(&mut self, place: usize) -> Found<String> {
        if let Some(mut shape) = self.shape.take() {
            let text = self.atom(place);
            let text = text.map(|text| shape.atom(text));
            self.shape = Some(shape);
            return text;
        }
        Ok(match self.checker.atom_form(place) {
            Form::Power(base, exponent, true) => {
                let natural = self.checker.fraction_words(&exponent);
                let natural = at(self.printer.natural(&natural)?, ATOM);
                format!("({} ^ {natural})", self.fraction(&base)?)
            }
            Form::Power(base, exponent, false) if self.is_root(&exponent) => {
                format!("(sqrt {})", self.fraction(&base)?)
            }
            Form::Power(base, exponent, false) => {
                format!("(Rpower {} {})", self.fraction(&base)?, self.fraction(&exponent)?)
            }
            Form::Exponential(inner) => format!("(exp {})", self.fraction(&inner)?),
            Form::Logarithm(inner) => format!("(ln {})", self.fraction(&inner)?),
            _ => {
                let words = self.checker.atom_words(place);
                self.expr(&words)?
            }
        })
    }

    fn poly(&mut self, poly: &Poly) -> Found<String> {
        let mut terms = Vec::new();
        for (monomial, c) in poly.terms() {
            let mut parts = Vec::new();
            if monomial.is_empty() || !c.is_one() {
                parts.push(number_text(c));
            }
            for (place, k) in monomial {
                let atom = self.atom(*place)?;
                parts.push(if *k == 1 { atom } else { format!("{atom} ^ {k}") });
            }
            terms.push(parts.join(" * "));
        }
        Ok(match terms.as_slice() {
            [] => "0".to_string(),
            [one] if poly.single_atom().is_some() => one.clone(),
            _ => format!("({})", terms.join(" + ")),
        })
    }

    fn fraction(&mut self, f: &Fraction) -> Found<String> {
        let (mut top, mut bottom) = (Vec::new(), String::new());
        for (poly, k) in &f.factors {
            let text = match self.shape.as_ref().and_then(|shape| shape.factor(poly)) {
                Some(name) => name,
                None => self.poly(poly)?,
            };
            let size = k.unsigned_abs();
            let text = if size == 1 { text } else { format!("{text} ^ {size}") };
            if *k > 0 { top.push(text) } else { bottom += &format!(" / {text}") }
        }
        if top.is_empty() || !f.coefficient.is_one() {
            top.insert(0, number_text(&f.coefficient));
        }
        if top.len() == 1 && bottom.is_empty() && !top.iter().any(|t| t.contains(" ^ ")) {
            return Ok(top.remove(0));
        }
        Ok(format!("({}{bottom})", top.join(" * ")))
    }

    // Facts and signs.

    /// Asserts the facts from a place on: the domains and hypotheses.
    fn facts(&mut self, from: usize) -> Found<()> {
        let facts: Vec<(String, Prop)> =
            self.checker.facts().skip(from).map(|(label, p)| (label.to_string(), (**p).clone())).collect();
        for (label, p) in facts {
            let text = self.prop(&p)?;
            self.put(&format!("assert ({} : {text}) by hyp.", fact(&label)));
        }
        Ok(())
    }

    fn fact_prop(&self, label: &str) -> Found<Prop> {
        let found = self.checker.fact_of(label);
        found
            .map(|fact| (**fact).clone())
            .ok_or_else(|| Open::Untranslated(label.to_string(), "a fact that is not there"))
    }

    /// The hypothesis that says a comparison that is a fact or a part of one.
    fn part(&mut self, label: &str, prop: &Prop) -> Found<String> {
        let whole = self.fact_prop(label)?;
        if key::prop(&whole) == key::prop(prop) {
            return Ok(fact(label));
        }
        let text = self.prop(prop)?;
        Ok(self.lemma("F", &text, &format!("part {}", fact(label))))
    }

    // Steps.

    fn step(&mut self, step: &Step) -> Found<()> {
        let show = match step {
            Step::Show(show) => show,
            Step::End(conclusion) => {
                self.put(&format!("exact {}.", fact(conclusion)));
                self.checker.step(step)?;
                self.depth -= 1;
                self.put("}");
                let depth = self.depth;
                self.shown.retain(|s| s.0 <= depth);
                if let Some(outside) = self.blocks.pop() {
                    (self.printer.kinds, self.printer.positive) = outside;
                }
                return Ok(());
            }
        };
        let (label, goal) = (show.label.as_str(), &show.prop);
        if show.opens() {
            let text = self.prop(goal)?;
            self.put(&format!("assert ({} : {text}). {{", fact(label)));
            self.depth += 1;
            self.blocks.push((self.printer.kinds.clone(), self.printer.positive.clone()));
            self.open(show)?;
            return Ok(());
        }
        let given = self.given(show)?;
        let tactic = match &show.rule {
            Rule::Suppose | Rule::Let => String::new(),
            Rule::Logic { from } => self.logic(goal, from)?,
            Rule::Instance { source, with, from } => self.instance(show, source, with, from, &given)?,
            Rule::Induction { base, advance } => self.induction(goal, base, advance)?,
            Rule::Existence { some, all } => format!("existence {} {}", fact(some), fact(all)),
            Rule::Witness { with, .. } => self.witness(goal, with)?,
            Rule::Extremum { from } => {
                self.point(goal, &given)?;
                let all: Vec<String> = from.iter().map(|f| format!("assert (z__{f} := {}); ", fact(f))).collect();
                format!("{}finish I", all.join(""))
            }
            Rule::Combination { times, terms } => self.combination(goal, times.as_ref(), terms, &given)?,
            Rule::Name => {
                self.name(show)?;
                self.checker.step(step)?;
                return Ok(());
            }
            Rule::Power => self.power_rule(goal, &given)?,
            Rule::Monotone { from } => self.monotone(goal, from, &given)?,
            Rule::Unfold => self.unfold(goal)?,
            Rule::Mean { with } => self.mean(goal, with, &given)?,
            Rule::Tangent { with } => self.tangent(goal, with, &given)?,
            Rule::Arc => return Err(Open::Untranslated(show.label.clone(), "arc")),
            Rule::Circle { .. } => return Err(Open::Untranslated(show.label.clone(), "circle")),
            Rule::Intermediate { .. } => return Err(Open::Untranslated(show.label.clone(), "intermediate")),
            Rule::Slope { source, with, from } => self.slope(show, source, with, from, &given)?,
            Rule::Termwise { from } => format!("termwise {}", fact(from)),
            Rule::Limit { with, .. } => self.limit(goal, with, &given)?,
            Rule::Squeeze { from } => self.squeeze(goal, from)?,
            Rule::Along { from } => self.along(goal, from)?,
            Rule::Eventually { .. } => return Err(Open::Untranslated(show.label.clone(), "eventually")),
            Rule::Evaluate => self.evaluate(&show.using)?,
            Rule::Integer { from } => self.integer(goal, from, &given)?,
        };
        let text = self.prop(goal)?;
        self.put(&format!("assert ({} : {text}). {{ {tactic}. }}", fact(label)));
        self.checker.step(step)?;
        Ok(())
    }

    /// The tactic that gives the witnesses of an `exists`.
    fn witness(&mut self, goal: &Prop, with: &[(Name, Expr)]) -> Found<String> {
        let mut out = String::new();
        if let PropKind::Exists(bindings, _) = &goal.kind {
            for (n, natural) in bindings.iter().flat_map(|b| b.names.iter().map(|n| (&n.0, b.natural))) {
                if let Some((_, value)) = with.iter().find(|w| w.0.text == n.text) {
                    let value = if natural { marked(self.printer.natural(value)?) } else { self.expr(value)? };
                    out += &format!("exists {value}; repeat (split; [first [hyp | nz] |]); ");
                }
            }
        }
        Ok(format!("{out}hyp"))
    }

    /// A new name for a value.
    fn name(&mut self, show: &Show) -> Found<()> {
        let untranslated = || Open::Untranslated(show.label.clone(), "name");
        let PropKind::Compare(sides, _) = &show.prop.kind else { return Err(untranslated()) };
        let [value, new] = sides.as_slice() else { return Err(untranslated()) };
        let ExprKind::Name(text) = &new.kind else { return Err(untranslated()) };
        let value = self.expr(value)?;
        self.printer.kinds.insert(text.clone(), Kind::Real);
        let word = self.printer.word(text);
        self.put(&format!("destruct (named {value}) as [{word} {}].", fact(&show.label)));
        Ok(())
    }

    /// Opens the block of a step: its variables, with the facts of their domains, or what it supposes.
    fn open(&mut self, show: &Show) -> Found<()> {
        let before = self.checker.facts().count();
        self.checker.step(&Step::Show(Box::new(show.clone())))?;
        let PropKind::ForAll(bindings, _) = &show.prop.kind else {
            self.put(&format!("intro {}.", fact(&format!("{}s", show.label))));
            return Ok(());
        };
        bind(bindings, &mut self.printer.kinds);
        self.printer.positive.declare(bindings);
        for binding in bindings {
            let names: Vec<String> = binding.names.iter().map(|n| self.printer.word(&n.0.text)).collect();
            self.put(&format!("intros {}.", names.join(" ")));
            for _ in 0..binding.names.len() * binding.constraints.len() {
                let h = self.fresh("D");
                self.put(&format!("intro {h}."));
            }
        }
        self.facts(before)
    }

    fn sides<'p>(&self, p: &'p Prop, rule: &'static str) -> Found<(&'p Expr, Relation, &'p Expr)> {
        p.single().ok_or_else(|| Open::Untranslated(rule.to_string(), "no single comparison"))
    }
}
