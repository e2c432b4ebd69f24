//! The printer of statements and proofs: its names, declarations and conditions.

use super::super::Result;
use super::super::kinds::{Kind, Kinds, bind, is_matrix, of_claim};
use super::super::positive::Positive;
use super::super::values::{Condition, Guard};
use super::super::{Unsupported, unsupported};
use super::words::{RESERVED, spelled};
use crate::claim::definedness::Need;
use crate::claim::syntax::*;
use crate::kernel::substitution::Substitution;
use std::collections::{BTreeMap, BTreeSet};

// Levels of Coq's grammar: a text of a lower level stands where a higher one is allowed.
pub(super) const ATOM: u8 = 0;
pub(super) const APPLICATION: u8 = 10;
pub(super) const POWER: u8 = 30;
pub(super) const NEGATION: u8 = 35;
pub(super) const PRODUCT: u8 = 40;
pub(super) const SUM: u8 = 50;
pub(super) const COMPARISON: u8 = 70;
pub(super) const NOT: u8 = 75;
pub(super) const AND: u8 = 80;
pub(super) const OR: u8 = 85;
pub(super) const IFF: u8 = 95;
pub(super) const IMPLIES: u8 = 99;
pub(super) const BINDER: u8 = 200;

pub(super) type Text = (String, u8);

pub(super) fn at(text: Text, most: u8) -> String {
    if text.1 <= most { text.0 } else { format!("({})", text.0) }
}

pub(super) struct Printer {
    pub(super) kinds: Kinds,
    /// The identifier of each name of the claim.
    pub(super) words: BTreeMap<String, String>,
    pub(super) definitions: Substitution,
    pub(super) positive: Positive,
    /// Variables with restrictions other than lower bounds, as printed; limits by these cannot be stated.
    pub(super) tied: Vec<String>,
    /// Definitions whose powers are of another kind where they are used: they are put in place.
    pub(super) in_place_only: BTreeSet<String>,
    /// Whether it prints a proof's own text: comparisons are of reals, and what needs a positive base is not asked.
    pub(super) inside: bool,
}

impl Printer {
    /// With the names that a claim declares, outside of a proof.
    pub(super) fn of_claim(claim: &Claim) -> Printer {
        Printer {
            kinds: of_claim(claim),
            words: BTreeMap::new(),
            definitions: Substitution::default(),
            positive: Positive::of_claim(claim),
            tied: Vec::new(),
            in_place_only: BTreeSet::new(),
            inside: false,
        }
    }

    /// Whether a condition follows from the declarations by its form alone; a premise then says nothing.
    pub(super) fn plain(&self, condition: &Condition) -> bool {
        match &condition.need {
            Need::NotZero(e) | Need::Positive(e) | Need::NotNegative(e) | Need::NotZeroOrNatural(e, _) => {
                self.positive.holds(e, &self.kinds)
            }
            Need::Range(..) | Need::Differentiable(..) => false,
        }
    }

    /// Runs with more names in scope.
    pub(super) fn within<T>(
        &mut self,
        add: impl FnOnce(&mut Kinds),
        work: impl FnOnce(&mut Printer) -> Result<T>,
    ) -> Result<T> {
        let saved = self.kinds.clone();
        add(&mut self.kinds);
        let out = work(self);
        self.kinds = saved;
        out
    }

    /// Runs with the names of bindings in scope.
    pub(super) fn within_bindings<T>(
        &mut self,
        bindings: &[Binding],
        work: impl FnOnce(&mut Printer) -> Result<T>,
    ) -> Result<T> {
        let saved = self.positive.clone();
        self.positive.declare(bindings);
        let out = self.within(|kinds| bind(bindings, kinds), work);
        self.positive = saved;
        out
    }

    /// The identifier for a name: distinct for distinct names of the claim.
    pub(super) fn word(&mut self, name: &str) -> String {
        if let Some(word) = self.words.get(name) {
            return word.clone();
        }
        let mut word = spelled(name);
        while RESERVED.contains(&word.as_str()) || self.words.values().any(|w| *w == word) {
            word.push('_');
        }
        self.words.insert(name.to_string(), word.clone());
        word
    }

    pub(super) fn in_place(&mut self, expr: &Expr) -> Result<Expr> {
        self.definitions.expr(expr).map_err(|obstacle| Unsupported::not_put_in(obstacle, expr.span))
    }

    // Declarations.

    pub(super) fn all_given(&mut self, bindings: &[Binding]) -> Result<String> {
        let mut out = String::new();
        for binding in bindings {
            out.push_str(&self.given(binding)?);
            out.push(' ');
        }
        Ok(out)
    }

    pub(super) fn given(&mut self, binding: &Binding) -> Result<String> {
        let mut out = format!("forall {},", self.binders(binding)?);
        for hypothesis in self.hypotheses(binding)? {
            out.push_str(&format!(" {hypothesis} ->"));
        }
        Ok(out)
    }

    /// `(m1 m2 : R)`.
    pub(super) fn binders(&mut self, binding: &Binding) -> Result<String> {
        if binding.indices.is_some() {
            return unsupported(binding.span, "a family on a part of the natural numbers");
        }
        let family = binding.names.iter().any(|n| n.1.is_some());
        let names: Vec<String> = binding.names.iter().map(|n| self.word(&n.0.text)).collect();
        let kind = match (family, binding.natural) {
            (true, false) => "nat -> R",
            (true, true) => return unsupported(binding.span, "a family of natural numbers"),
            (false, true) => "nat",
            (false, false) => "R",
        };
        if family && binding.names.iter().any(|n| n.1.is_none()) {
            return unsupported(binding.span, "families and plain names in one binding");
        }
        Ok(format!("({} : {kind})", names.join(" ")))
    }

    /// The constraints of a binding, each as a hypothesis.
    pub(super) fn hypotheses(&mut self, binding: &Binding) -> Result<Vec<String>> {
        let mut out = Vec::new();
        for (name, index) in &binding.names {
            for constraint in &binding.constraints {
                let span = name.span;
                match index {
                    None => {
                        let subject = Expr { kind: ExprKind::Name(name.text.clone()), span };
                        out.push(self.constraint(&subject, binding.natural, constraint)?);
                    }
                    Some(index) => {
                        let argument = Expr { kind: ExprKind::Name(index.text.clone()), span: index.span };
                        let subject = Expr { kind: ExprKind::Apply(name.clone(), vec![argument]), span };
                        let k = self.word(&index.text);
                        let natural = |kinds: &mut Kinds| {
                            kinds.insert(index.text.clone(), Kind::Natural);
                        };
                        let text = self.within(natural, |p| p.constraint(&subject, false, constraint))?;
                        out.push(format!("(forall {k} : nat, {text})"));
                    }
                }
            }
        }
        Ok(out)
    }

    pub(super) fn constraint(&mut self, subject: &Expr, natural: bool, constraint: &Constraint) -> Result<String> {
        match constraint {
            Constraint::Relation(relation, e) => self.comparison(subject, *relation, e).map(|t| t.0),
            Constraint::Interval { from, from_closed, to, to_closed } => {
                let sign = |closed: bool| if closed { "<=" } else { "<" };
                let (a, x, b) = (self.real_at(from, SUM)?, self.real_at(subject, SUM)?, self.real_at(to, SUM)?);
                if natural {
                    return unsupported(subject.span, "an interval of reals for a natural number");
                }
                Ok(format!("{a} {} {x} {} {b}", sign(*from_closed), sign(*to_closed)))
            }
            Constraint::Range(from, to) if self.inside => {
                let (a, x, b) = (self.real_at(from, SUM)?, self.real_at(subject, SUM)?, self.real_at(to, SUM)?);
                Ok(format!("{a} <= {x} <= {b}"))
            }
            Constraint::Range(from, to) => {
                let (a, x, b) = (self.natural(from)?, self.natural(subject)?, self.natural(to)?);
                Ok(format!("({} <= {} <= {})%nat", at(a, SUM), at(x, SUM), at(b, SUM)))
            }
        }
    }

    pub(super) fn definition(&mut self, name: &Name, parameters: &[Name], value: &Expr) -> Result<String> {
        let kind = self.kinds.get(&name.text).cloned().unwrap_or(Kind::Real);
        let word = self.word(&name.text);
        Ok(match kind {
            Kind::Real => format!("let {word} := {} in", self.real(value)?.0),
            Kind::Natural => format!("let {word} := {} in", marked(self.natural(value)?)),
            Kind::Matrix => format!("let {word} := {} in", self.matrix(value)?.0),
            Kind::Function(natural) => {
                if is_matrix(value, &self.kinds) {
                    return unsupported(value.span, "a function with matrices for values");
                }
                let mut binders = Vec::new();
                for (parameter, natural) in parameters.iter().zip(&natural) {
                    let kind = if *natural { "nat" } else { "R" };
                    binders.push(format!("({} : {kind})", self.word(&parameter.text)));
                }
                let add = |kinds: &mut Kinds| {
                    for (parameter, natural) in parameters.iter().zip(&natural) {
                        kinds.insert(parameter.text.clone(), if *natural { Kind::Natural } else { Kind::Real });
                    }
                };
                let value = self.within(add, |p| p.real(value))?.0;
                format!("let {word} := fun {} => {value} in", binders.join(" "))
            }
        })
    }

    pub(super) fn sequence(&mut self, name: &str, initial: &Expr, index: &str, step: &Expr) -> Result<String> {
        let (u, k) = (self.word(name), self.word(index));
        let initial = self.real(initial)?.0;
        let natural = |kinds: &mut Kinds| {
            kinds.insert(index.to_string(), Kind::Natural);
        };
        let step = self.within(natural, |p| p.real(step))?.0;
        Ok(format!(
            "forall {u} : nat -> R, {u} 0%nat = {initial} ->\n(forall {k} : nat, {u} ({k} + 1)%nat = {step}) ->"
        ))
    }

    /// Conditions as propositions, each once.
    pub(super) fn conditions(&mut self, found: &[Condition]) -> Result<Vec<String>> {
        let mut out: Vec<String> = Vec::new();
        for condition in found {
            let text = self.condition(&condition.guards, &condition.need)?;
            if !out.contains(&text) {
                out.push(text);
            }
        }
        Ok(out)
    }

    fn condition(&mut self, guards: &[Guard], need: &Need) -> Result<String> {
        let Some((first, rest)) = guards.split_first() else {
            return Ok(match need {
                Need::NotZero(e) => format!("{} <> 0", self.real_at(e, SUM)?),
                Need::Positive(e) => format!("{} > 0", self.real_at(e, SUM)?),
                Need::NotNegative(e) => format!("0 <= {}", self.real_at(e, SUM)?),
                Need::NotZeroOrNatural(base, exponent) => {
                    format!("({} <> 0 \\/ 0 <= {})", self.real_at(base, SUM)?, self.real_at(exponent, SUM)?)
                }
                Need::Range(from, to) => {
                    format!("({} <= {} + 1)%nat", at(self.natural(from)?, SUM), at(self.natural(to)?, SUM))
                }
                Need::Differentiable(e, by, order) => {
                    let (function, x) = (self.function_of(e, by)?, self.word(&by.text));
                    match order {
                        1 => format!("ex_derive {function} {x}"),
                        _ => format!("ex_derive_n {function} {order} {x}"),
                    }
                }
            });
        };
        let natural = |name: &str| {
            let name = name.to_string();
            move |kinds: &mut Kinds| {
                kinds.insert(name, Kind::Natural);
            }
        };
        match first {
            Guard::Natural(name) => {
                let k = self.word(&name.text);
                let body = self.within(natural(&name.text), |p| p.condition(rest, need))?;
                Ok(format!("(forall {k} : nat, {body})"))
            }
            Guard::Index(index) => {
                let range = self.range(index)?;
                let k = self.word(&index.name.text);
                let body = self.within(natural(&index.name.text), |p| p.condition(rest, need))?;
                Ok(format!("(forall {k} : nat, ({} <= {k} <= {})%nat -> {body})", range.0, range.1))
            }
            Guard::Bindings(bindings) => self.within_bindings(bindings, |p| {
                let given = p.all_given(bindings)?;
                Ok(format!("({given}{})", p.condition(rest, need)?))
            }),
        }
    }
}

/// `n` or `(n + 1)%nat`.
pub(super) fn marked(text: Text) -> String {
    if text.1 == ATOM && !text.0.starts_with(|c: char| c.is_ascii_digit()) {
        text.0
    } else if text.1 == ATOM {
        format!("{}%nat", text.0)
    } else {
        format!("({})%nat", text.0)
    }
}
