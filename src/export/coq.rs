//! Statements for Coq, over its real numbers and with Coquelicot's derivatives and limits.
//!
//! Contract: the text of [`Statement::full`] is a closed proposition over the words of
//! `proofs/coq/vocabulary.v` that says what the claim says: reals are `R`, naturals `nat` (with
//! `INR` where they stand among reals), families and sequences `nat -> R`, a `let` of the claim a
//! `let` of Coq. A power with a natural exponent is `pow`, any other `Rpower`, exp (y ln x), which is
//! the claim's power where the base is positive. Coq's functions are total; that divisors are not 0,
//! bases positive and so on is the second statement, [`Statement::defined`], with the same hypotheses.
//! A hypothesis that divides comes with its divisors' being other than 0, as the language has it.
//!
//! Refused, with the reason: families on a part of the naturals, matrices among functions' values,
//! bounds of a sum that are not natural by their form, determinants beyond two rows.

pub mod defined;
pub mod proof;
pub mod refuted;

use super::kinds::{Kind, Kinds, bind, is_matrix, is_natural, is_natural_name, of_claim};
use super::positive::Positive;
use super::values::{self, Collector, Condition, Guard};
use super::{Result, Unsupported, unsupported};
use crate::claim::definedness::{self, Exponent, Need};
use crate::claim::syntax::*;
use crate::number::rational;
use crate::refute::expand::{self, Substitution};
use crate::{certificate, kernel};
use malachite::base::num::basic::traits::One;
use std::collections::{BTreeMap, BTreeSet};

/// The longest line that is printed where there is a space to break at.
const WIDTH: usize = 110;

/// Words that a name of a claim must not take: Coq's own, and those that statements and proofs are made of.
const RESERVED: &[&str] = &[
    "as",
    "at",
    "cofix",
    "else",
    "end",
    "exists",
    "exists2",
    "fix",
    "for",
    "forall",
    "fun",
    "if",
    "in",
    "let",
    "match",
    "mod",
    "return",
    "Set",
    "Prop",
    "SProp",
    "Type",
    "then",
    "using",
    "where",
    "with",
    "by",
    "IF",
    "R",
    "nat",
    "INR",
    "Rpower",
    "sqrt",
    "cbrt",
    "exp",
    "ln",
    "cosh",
    "sinh",
    "tanh",
    "sech",
    "sum_over",
    "product_over",
    "matrix",
    "mat_scale",
    "mat_mul",
    "mat_add",
    "mat_transpose",
    "det2",
    "is_derive",
    "is_derive_n",
    "Derive",
    "Derive_n",
    "ex_derive",
    "ex_derive_n",
    "is_lim_seq",
    "is_lim",
    "p_infty",
    "_",
    // Words that proofs are made of.
    "EQ",
    "GE",
    "GT",
    "I",
    "IZR",
    "LE",
    "LT",
    "NE",
    "Rgt_not_eq",
    "Rmult",
    "S3",
    "SA",
    "SI",
    "SM",
    "SN",
    "SP",
    "SW",
    "both",
    "by_sign",
    "conj",
    "divided",
    "eq_refl",
    "eq_sym",
    "eq_trans",
    "f_equal",
    "holds",
    "holds_any",
    "named",
    "prodz",
    "stands",
];

/// A claim's statement for Coq.
#[derive(Clone, Debug)]
pub struct Statement {
    /// The claim's name as an identifier.
    pub name: String,
    /// The proposition; of a claim expected to be refuted, its negation.
    pub full: String,
    /// That every expression has a value under the hypotheses; `None` if that is plain.
    pub defined: Option<String>,
    /// How many variables and hypotheses come before what is claimed.
    pub premises: usize,
    /// SHA-256 of the claim's statement as the kernel of certificates reads it, in hexadecimal digits: one
    /// digest stands in the certificate, beside the Coq statement and in the table of claims.
    pub digest: String,
}

/// A claim's name as an identifier of Coq that is none of the words of statements.
pub fn identifier(name: &str) -> String {
    let word = spelled(name);
    if RESERVED.contains(&word.as_str()) { format!("{word}_") } else { word }
}

fn spelled(name: &str) -> String {
    name.chars()
        .map(|c| match c {
            c if c.is_ascii_alphanumeric() || c == '_' || c == '\'' => c.to_string(),
            '-' => "_".to_string(),
            c => format!("u{:x}_", u32::from(c)),
        })
        .collect()
}

/// The statement of a claim.
///
/// # Errors
/// The construct that cannot be said, with its place.
pub fn statement(claim: &Claim) -> Result<Statement> {
    let expanded = expand::Statement::of(claim).map_err(|limit| Unsupported::limit(limit.0, claim.name.span))?;
    let mut printer = Printer {
        kinds: of_claim(claim),
        words: BTreeMap::new(),
        definitions: Substitution::default(),
        positive: Positive::of_claim(claim),
        tied: Vec::new(),
        in_place_only: BTreeSet::new(),
        inside: false,
    };
    for (_, prop) in &expanded.assumptions {
        let text = printer.prop(prop)?.0;
        printer.tied.push(text);
    }
    for binding in &expanded.bindings {
        let from_below =
            |c: &Constraint| matches!(c, Constraint::Relation(Relation::Greater | Relation::GreaterEqual, _));
        if !binding.constraints.iter().all(from_below) {
            let text = printer.binders(binding)?;
            printer.tied.push(text);
        }
    }
    for item in &claim.items {
        if let Item::Let { name, parameters, value } = item {
            let value = printer.in_place(value)?;
            if printer.powers_depend_on(&name.text, parameters, &value) {
                printer.in_place_only.insert(name.text.clone());
            }
            let parameters = parameters.iter().map(|p| p.text.clone()).collect();
            printer.definitions.define(&name.text, parameters, value);
        }
    }
    let mut assumptions = expanded.assumptions.iter();
    let (mut full, mut bare, mut premises) = (Vec::new(), Vec::new(), 0);
    for item in &claim.items {
        match item {
            Item::Given(bindings) => {
                for binding in bindings {
                    full.push(printer.given(binding)?);
                }
            }
            Item::Let { name, .. } if printer.in_place_only.contains(&name.text) => {}
            Item::Let { name, parameters, value } => full.push(printer.definition(name, parameters, value)?),
            Item::Define { name, initial, index, step, .. } => {
                full.push(printer.sequence(&name.text, initial, &index.text, step)?);
            }
            Item::Assume { prop, .. } => {
                let mut divisors = Collector::new(&printer.kinds, &printer.positive);
                if let Some((_, prop)) = assumptions.next() {
                    divisors.prop(prop);
                }
                divisors.found.retain(|c| !printer.plain(c));
                for need in printer.conditions(&divisors.found)? {
                    full.push(format!("{need} ->"));
                }
                full.push(format!("{} ->", printer.prop_at(prop, 80)?));
            }
        }
    }
    for binding in &expanded.bindings {
        premises += binding.names.len() * (1 + binding.constraints.len());
        bare.push(printer.given(binding)?);
    }
    for sequence in &expanded.sequences {
        premises += 3;
        bare.push(printer.sequence(&sequence.name, &sequence.initial, &sequence.index, &sequence.step)?);
    }
    for (_, prop) in &expanded.assumptions {
        let mut divisors = Collector::new(&printer.kinds, &printer.positive);
        divisors.prop(prop);
        divisors.found.retain(|c| !printer.plain(c));
        for need in printer.conditions(&divisors.found)? {
            premises += 1;
            bare.push(format!("{need} ->"));
        }
        premises += 1;
        bare.push(format!("{} ->", printer.prop_at(prop, 80)?));
    }
    full.push(match &claim.goal.kind {
        PropKind::And(list) => printer.props(list, " /\\\n", AND)?,
        _ => printer.prop(&claim.goal)?.0,
    });
    let full = without_unused(full);
    let needs = values::of_statement(&expanded, &printer.kinds, &printer.positive);
    let needs = printer.conditions(&needs)?;
    let refuted = claim.expect == Expectation::Refuted;
    let defined = (!needs.is_empty() && !refuted).then(|| {
        bare.push(needs.join(" /\\\n"));
        laid_out(&bare)
    });
    let full = if refuted { format!("  ~ (\n{})", laid_out(&full)) } else { laid_out(&full) };
    let read = kernel::statement::Statement::of(claim).map_err(|_| Unsupported::limit("size", claim.name.span))?;
    let digest = certificate::text::digest(&read.text());
    Ok(Statement { name: identifier(&claim.name.text), full, defined, premises, digest })
}

/// Drops every `let` that nothing after it mentions: derivatives and limits have theirs put in place.
fn without_unused(lines: Vec<String>) -> Vec<String> {
    let mut out: Vec<String> = Vec::new();
    for line in lines.into_iter().rev() {
        let word = line.strip_prefix("let ").and_then(|rest| rest.split(' ').next());
        if word.is_none_or(|word| out.iter().any(|later| mentions(later, word))) || !line.ends_with(" in") {
            out.push(line);
        }
    }
    out.reverse();
    out
}

/// Whether a text holds an identifier.
fn mentions(text: &str, word: &str) -> bool {
    text.split(|c: char| !(c.is_alphanumeric() || c == '_' || c == '\'')).any(|w| w == word)
}

/// Lines indented by two; long ones are broken, after a connective or relation where there is one.
fn laid_out(lines: &[String]) -> String {
    const AFTER: &[&str] = &["->", "/\\", "\\/", "<->", "=", "<=", ">=", "<", ">", "<>", ":="];
    let mut out = Vec::new();
    for line in lines.iter().flat_map(|l| l.lines()) {
        let mut words: Vec<&str> = line.split_whitespace().collect();
        let mut indent = 2;
        loop {
            let (mut length, mut fits) = (indent, 0);
            for word in &words {
                length += word.chars().count() + 1;
                if fits > 0 && length > WIDTH + 1 {
                    break;
                }
                fits += 1;
            }
            let break_at = if fits == words.len() {
                fits
            } else {
                let last = |signs: &[&str]| {
                    (fits / 3..fits).rev().find(|i| words.get(*i).is_some_and(|w| signs.contains(w))).map(|i| i + 1)
                };
                last(AFTER).or_else(|| last(&["+", "-", "*", "/"])).unwrap_or(fits)
            };
            let rest = words.split_off(break_at);
            out.push(format!("{}{}", " ".repeat(indent), words.join(" ")));
            if rest.is_empty() {
                break;
            }
            (words, indent) = (rest, 6);
        }
    }
    out.join("\n")
}

// Levels of Coq's grammar: a text of a lower level stands where a higher one is allowed.
const ATOM: u8 = 0;
const APPLICATION: u8 = 10;
const POWER: u8 = 30;
const NEGATION: u8 = 35;
const PRODUCT: u8 = 40;
const SUM: u8 = 50;
const COMPARISON: u8 = 70;
const NOT: u8 = 75;
const AND: u8 = 80;
const OR: u8 = 85;
const IFF: u8 = 95;
const IMPLIES: u8 = 99;
const BINDER: u8 = 200;

type Text = (String, u8);

fn at(text: Text, most: u8) -> String {
    if text.1 <= most { text.0 } else { format!("({})", text.0) }
}

struct Printer {
    kinds: Kinds,
    /// The identifier of each name of the claim.
    words: BTreeMap<String, String>,
    definitions: Substitution,
    positive: Positive,
    /// What restricts variables otherwise than from below, as printed: no limit by these.
    tied: Vec<String>,
    /// Definitions whose powers are of another kind where they are used: they are put in place.
    in_place_only: BTreeSet<String>,
    /// Whether it prints a proof's own text: comparisons are of reals, and what needs a positive base is not asked.
    inside: bool,
}

impl Printer {
    /// Whether a condition follows from the declarations by its form alone; a premise then says nothing.
    fn plain(&self, condition: &Condition) -> bool {
        match &condition.need {
            Need::NotZero(e) | Need::Positive(e) | Need::NotNegative(e) | Need::NotZeroOrNatural(e, _) => {
                self.positive.holds(e, &self.kinds)
            }
            Need::Range(..) | Need::Differentiable(..) => false,
        }
    }

    /// Runs with more names in scope.
    fn within<T>(&mut self, add: impl FnOnce(&mut Kinds), work: impl FnOnce(&mut Printer) -> Result<T>) -> Result<T> {
        let saved = self.kinds.clone();
        add(&mut self.kinds);
        let out = work(self);
        self.kinds = saved;
        out
    }

    /// Runs with the names of bindings in scope.
    fn within_bindings<T>(&mut self, bindings: &[Binding], work: impl FnOnce(&mut Printer) -> Result<T>) -> Result<T> {
        let saved = self.positive.clone();
        self.positive.declare(bindings);
        let out = self.within(|kinds| bind(bindings, kinds), work);
        self.positive = saved;
        out
    }

    /// The identifier for a name: distinct for distinct names of the claim.
    fn word(&mut self, name: &str) -> String {
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

    fn in_place(&mut self, expr: &Expr) -> Result<Expr> {
        let limit = |l: crate::refute::expand::Limit| Unsupported::limit(l.0, expr.span);
        self.definitions.expr(expr).map_err(limit)
    }

    // Declarations.

    fn all_given(&mut self, bindings: &[Binding]) -> Result<String> {
        let mut out = String::new();
        for binding in bindings {
            out.push_str(&self.given(binding)?);
            out.push(' ');
        }
        Ok(out)
    }

    fn given(&mut self, binding: &Binding) -> Result<String> {
        let mut out = format!("forall {},", self.binders(binding)?);
        for hypothesis in self.hypotheses(binding)? {
            out.push_str(&format!(" {hypothesis} ->"));
        }
        Ok(out)
    }

    /// `(m1 m2 : R)`.
    fn binders(&mut self, binding: &Binding) -> Result<String> {
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
    fn hypotheses(&mut self, binding: &Binding) -> Result<Vec<String>> {
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

    fn constraint(&mut self, subject: &Expr, natural: bool, constraint: &Constraint) -> Result<String> {
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

    fn definition(&mut self, name: &Name, parameters: &[Name], value: &Expr) -> Result<String> {
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

    fn sequence(&mut self, name: &str, initial: &Expr, index: &str, step: &Expr) -> Result<String> {
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
    fn conditions(&mut self, found: &[Condition]) -> Result<Vec<String>> {
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

    // Expressions.

    fn real_at(&mut self, expr: &Expr, most: u8) -> Result<String> {
        Ok(at(self.real(expr)?, most))
    }

    /// A real expression.
    fn real(&mut self, expr: &Expr) -> Result<Text> {
        if is_natural(expr, &self.kinds) && !matches!(expr.kind, ExprKind::Number(_) | ExprKind::Power(..)) {
            let inner = at(self.natural(expr)?, APPLICATION - 1);
            return Ok((format!("INR {inner}"), APPLICATION));
        }
        Ok(match &expr.kind {
            ExprKind::Number(text) => match rational::parse(text) {
                Ok(q) if *q.denominator_ref() == malachite::Natural::ONE => (q.to_string(), ATOM),
                Ok(q) => (q.to_string().replace('/', " / "), PRODUCT),
                Err(e) => return unsupported(expr.span, e.to_string()),
            },
            ExprKind::Name(name) => match self.kinds.get(name) {
                Some(Kind::Real) => (self.word(name), ATOM),
                Some(Kind::Matrix) => return unsupported(expr.span, "a matrix where a number is needed"),
                _ if name == "infinity" => return unsupported(expr.span, "infinity as a number"),
                _ => return unsupported(expr.span, format!("{name} as a number")),
            },
            ExprKind::Apply(function, arguments) => return self.apply(function, arguments, expr.span),
            ExprKind::Negate(a) => (format!("- {}", self.real_at(a, POWER)?), NEGATION),
            ExprKind::Sum(list) => {
                let mut out = String::new();
                for (i, (sign, summand)) in list.iter().enumerate() {
                    if i > 0 {
                        out.push_str(if *sign == Sign::Plus { " + " } else { " - " });
                    }
                    let text = self.real(summand)?;
                    let bare = i == 0 || text.1 != NEGATION;
                    out.push_str(&at(text, if bare { PRODUCT } else { ATOM }));
                }
                (out, SUM)
            }
            ExprKind::Product(list) => {
                let mut out = String::new();
                for (i, (operator, factor)) in list.iter().enumerate() {
                    if i > 0 {
                        out.push_str(if *operator == Factor::Times { " * " } else { " / " });
                    }
                    out.push_str(&self.real_at(factor, POWER)?);
                }
                (out, PRODUCT)
            }
            ExprKind::Power(base, exponent) => self.power(base, exponent, expr.span)?,
            ExprKind::SumOver(index, body) => self.over("sum_over", index, body)?,
            ExprKind::ProductOver(index, body) => self.over("product_over", index, body)?,
            ExprKind::Derivative(body, by) => {
                let (name, order) = same_variable(by, expr.span)?;
                let (function, x) = (self.function_of(body, name)?, self.word(&name.text));
                match order {
                    1 => (format!("Derive {function} {x}"), APPLICATION),
                    _ => (format!("Derive_n {function} {order} {x}"), APPLICATION),
                }
            }
            ExprKind::Matrix(_) => return unsupported(expr.span, "a matrix where a number is needed"),
        })
    }

    /// A power by the kind of its exponent, definitions put in place: `pow` for a natural number, `Rpower` where the base
    /// is positive, by its form or because the claim has to say so.
    fn power(&mut self, base: &Expr, exponent: &Expr, span: Span) -> Result<Text> {
        let placed = self.in_place(exponent)?;
        let natural = |p: &mut Printer, e: &Expr| Ok(at(p.natural(e)?, ATOM));
        let kind = definedness::exponent(&placed, &|name| is_natural_name(name, &self.kinds));
        let (negative, size) = match (definedness::number(&placed), &placed.kind) {
            (Some((k, 1)), _) => (k < 0, k.unsigned_abs().to_string()),
            _ if is_natural(exponent, &self.kinds) => (false, natural(self, exponent)?),
            (_, ExprKind::Negate(inner)) if is_natural(inner, &self.kinds) => (true, natural(self, inner)?),
            _ if !self.inside && kind != Exponent::Real && !self.is_positive(base)? => {
                let reason = match kind {
                    Exponent::Root => "a root, written as a power, of what may be 0",
                    _ => "a power of what may be 0 or negative, with an exponent that may be negative",
                };
                return unsupported(span, reason);
            }
            _ => {
                let (base, exponent) = (self.real_at(base, ATOM)?, self.real_at(exponent, ATOM)?);
                return Ok((format!("Rpower {base} {exponent}"), APPLICATION));
            }
        };
        let power = format!("{} ^ {size}", self.real_at(base, APPLICATION)?);
        Ok(if negative { (format!("/ {power}"), NEGATION) } else { (power, POWER) })
    }

    /// Whether an expression is positive by its form, definitions put in place.
    fn is_positive(&mut self, e: &Expr) -> Result<bool> {
        let placed = self.in_place(e)?;
        Ok(self.positive.holds(&placed, &self.kinds))
    }

    /// Whether a power or cube root in the value of a definition has a parameter in it and may be of another kind where
    /// the definition is used: the value has no definitions in it.
    fn powers_depend_on(&self, name: &str, parameters: &[Name], value: &Expr) -> bool {
        let Some(Kind::Function(natural)) = self.kinds.get(name) else { return false };
        let mut kinds = self.kinds.clone();
        for (parameter, natural) in parameters.iter().zip(natural) {
            kinds.insert(parameter.text.clone(), if *natural { Kind::Natural } else { Kind::Real });
        }
        let whole = |e: &Expr| {
            let inner = if let ExprKind::Negate(inner) = &e.kind { inner } else { e };
            matches!(definedness::number(e), Some((_, 1))) || is_natural(inner, &kinds)
        };
        let mut open = vec![value];
        while let Some(e) = open.pop() {
            let base = match &e.kind {
                ExprKind::Power(base, exponent) if !whole(exponent) => Some(&**base),
                ExprKind::Apply(f, arguments) if f.text == "cbrt" => arguments.first(),
                _ => None,
            };
            let mut names = BTreeSet::new();
            expand::names_in(e, &mut names);
            if base.is_some_and(|base| !self.positive.holds(base, &kinds))
                && parameters.iter().any(|p| names.contains(&p.text))
            {
                return true;
            }
            expand::parts(e, &mut |part| open.push(part));
        }
        false
    }

    fn apply(&mut self, function: &Name, arguments: &[Expr], span: Span) -> Result<Text> {
        let name = function.text.as_str();
        if self.in_place_only.contains(name) {
            let call = Expr { kind: ExprKind::Apply(function.clone(), arguments.to_vec()), span };
            let placed = self.in_place(&call)?;
            return self.real(&placed);
        }
        if FUNCTIONS.iter().any(|f| f.0 == name) {
            let [argument] = arguments else { return unsupported(span, format!("{name} of several arguments")) };
            return Ok(match name {
                "det" => (format!("det2 {}", at(self.matrix(argument)?, ATOM)), APPLICATION),
                "transpose" => return unsupported(span, "a matrix where a number is needed"),
                "cbrt" if !self.inside && !self.is_positive(argument)? => {
                    return unsupported(span, "the cube root of what may be 0");
                }
                _ => (format!("{name} {}", self.real_at(argument, ATOM)?), APPLICATION),
            });
        }
        let Some(Kind::Function(natural)) = self.kinds.get(name).cloned() else {
            return unsupported(span, format!("{name} as a function"));
        };
        let mut out = self.word(name);
        for (argument, natural) in arguments.iter().zip(natural) {
            out.push(' ');
            out.push_str(&if natural {
                if !is_natural(argument, &self.kinds) {
                    return unsupported(argument.span, "an index that is not natural by its form");
                }
                marked(self.natural(argument)?)
            } else {
                self.real_at(argument, ATOM)?
            });
        }
        Ok((out, APPLICATION))
    }

    /// A natural expression, for the scope of `nat`.
    fn natural(&mut self, expr: &Expr) -> Result<Text> {
        if !is_natural(expr, &self.kinds) {
            return unsupported(expr.span, "an expression that is not natural by its form");
        }
        let listed = |p: &mut Printer, list: Vec<&Expr>, sign: &str, most: u8| -> Result<String> {
            let parts: Vec<String> = list.into_iter().map(|e| Ok(at(p.natural(e)?, most))).collect::<Result<_>>()?;
            Ok(parts.join(sign))
        };
        Ok(match &expr.kind {
            ExprKind::Number(text) => (text.clone(), ATOM),
            ExprKind::Name(name) => (self.word(name), ATOM),
            ExprKind::Sum(list) => (listed(self, list.iter().map(|p| &p.1).collect(), " + ", PRODUCT)?, SUM),
            ExprKind::Product(list) => (listed(self, list.iter().map(|p| &p.1).collect(), " * ", POWER)?, PRODUCT),
            ExprKind::Power(a, b) => (listed(self, vec![a, b], " ^ ", APPLICATION)?, POWER),
            _ => return unsupported(expr.span, "an expression that is not natural by its form"),
        })
    }

    /// The bounds of an index, for the scope of `nat`.
    fn range(&mut self, index: &Index) -> Result<(String, String)> {
        Ok((at(self.natural(&index.from)?, SUM), at(self.natural(&index.to)?, SUM)))
    }

    fn over(&mut self, word: &str, index: &Index, body: &Expr) -> Result<Text> {
        let (from, to) = (at(self.natural(&index.from)?, ATOM), at(self.natural(&index.to)?, ATOM));
        let k = self.word(&index.name.text);
        let natural = |kinds: &mut Kinds| {
            kinds.insert(index.name.text.clone(), Kind::Natural);
        };
        let body = self.within(natural, |p| p.real(body))?.0;
        Ok((format!("{word} {from} {to} (fun {k} : nat => {body})"), APPLICATION))
    }

    /// `(fun x : R => …)`: the definitions are put in place, as they may depend on the variable.
    fn function_of(&mut self, body: &Expr, variable: &Name) -> Result<String> {
        if self.kinds.get(&variable.text) != Some(&Kind::Real) {
            return unsupported(variable.span, "a derivative by what is no real variable");
        }
        let body = self.in_place(body)?;
        let body = self.real(&body)?.0;
        Ok(format!("(fun {} : R => {body})", self.word(&variable.text)))
    }

    fn matrix(&mut self, expr: &Expr) -> Result<Text> {
        Ok(match &expr.kind {
            ExprKind::Matrix(rows) => {
                let mut lines = Vec::new();
                for row in rows {
                    let row: Vec<String> = row.iter().map(|e| Ok(self.real(e)?.0)).collect::<Result<_>>()?;
                    lines.push(format!("[{}]", row.join("; ")));
                }
                (format!("[{}]", lines.join("; ")), ATOM)
            }
            ExprKind::Name(name) if self.kinds.get(name) == Some(&Kind::Matrix) => (self.word(name), ATOM),
            ExprKind::Negate(a) => (format!("mat_scale (- 1) {}", at(self.matrix(a)?, ATOM)), APPLICATION),
            ExprKind::Sum(list) => {
                let mut out: Option<Text> = None;
                for (sign, summand) in list {
                    if !is_matrix(summand, &self.kinds) {
                        return unsupported(summand.span, "a number added to a matrix");
                    }
                    let mut text = at(self.matrix(summand)?, ATOM);
                    if *sign == Sign::Minus {
                        text = format!("(mat_scale (- 1) {text})");
                    }
                    out = Some(match out {
                        None => (text, ATOM),
                        Some(before) => (format!("mat_add {} {text}", at(before, ATOM)), APPLICATION),
                    });
                }
                out.unwrap_or_default()
            }
            ExprKind::Product(list) => {
                // Numbers commute with matrices: their product first, then the matrices in order.
                let (mut numbers, mut product) = (Vec::new(), None::<Text>);
                for (operator, factor) in list {
                    if !is_matrix(factor, &self.kinds) {
                        numbers.push((*operator, factor.clone()));
                        continue;
                    }
                    if *operator == Factor::Over {
                        return unsupported(factor.span, "division by a matrix");
                    }
                    let text = at(self.matrix(factor)?, ATOM);
                    product = Some(match product {
                        None => (text, ATOM),
                        Some(before) => (format!("mat_mul {} {text}", at(before, ATOM)), APPLICATION),
                    });
                }
                let product = product.unwrap_or_default();
                if numbers.is_empty() {
                    return Ok(product);
                }
                if numbers.first().is_some_and(|n| n.0 == Factor::Over) {
                    let one = Expr { kind: ExprKind::Number("1".to_string()), span: expr.span };
                    numbers.insert(0, (Factor::Times, one));
                }
                let scalar = match numbers.as_slice() {
                    [(Factor::Times, one)] => self.real_at(one, ATOM)?,
                    _ => self.real_at(&Expr { kind: ExprKind::Product(numbers), span: expr.span }, ATOM)?,
                };
                (format!("mat_scale {scalar} {}", at(product, ATOM)), APPLICATION)
            }
            ExprKind::Apply(f, _) => return unsupported(f.span, format!("{} of a matrix", f.text)),
            _ => return unsupported(expr.span, "a number where a matrix is needed"),
        })
    }

    // Propositions.

    fn comparison(&mut self, a: &Expr, relation: Relation, b: &Expr) -> Result<Text> {
        let sign = match relation {
            Relation::Equal => "=",
            Relation::NotEqual => "<>",
            Relation::Less => "<",
            Relation::LessEqual => "<=",
            Relation::Greater => ">",
            Relation::GreaterEqual => ">=",
        };
        if let (ExprKind::Derivative(..), Relation::NotEqual, true) = (&a.kind, relation, self.inside) {
            // The contrary of the equation, so that the rules of logic see the one in the other.
            let (equal, _) = self.comparison(a, Relation::Equal, b)?;
            return Ok((format!("~ ({equal})"), NOT));
        }
        if let (ExprKind::Derivative(body, by), Relation::Equal) = (&a.kind, relation) {
            let (name, order) = same_variable(by, a.span)?;
            let (function, x, value) = (self.function_of(body, name)?, self.word(&name.text), self.real_at(b, ATOM)?);
            let text = match order {
                1 => format!("is_derive {function} {x} {value}"),
                _ => format!("is_derive_n {function} {order} {x} {value}"),
            };
            return Ok((text, APPLICATION));
        }
        if is_matrix(a, &self.kinds) || is_matrix(b, &self.kinds) {
            let (a, b) = (self.matrix(a)?, self.matrix(b)?);
            return match relation {
                Relation::Equal | Relation::NotEqual => {
                    Ok((format!("{} {sign} {}", at(a, APPLICATION), at(b, APPLICATION)), COMPARISON))
                }
                _ => unsupported(Span::default(), "an order of matrices"),
            };
        }
        let symbolic = |e: &Expr| !matches!(e.kind, ExprKind::Number(_));
        if !self.inside && is_natural(a, &self.kinds) && is_natural(b, &self.kinds) && (symbolic(a) || symbolic(b)) {
            let (a, b) = (at(self.natural(a)?, SUM), at(self.natural(b)?, SUM));
            return Ok((format!("({a} {sign} {b})%nat"), ATOM));
        }
        Ok((format!("{} {sign} {}", self.real_at(a, SUM)?, self.real_at(b, SUM)?), COMPARISON))
    }

    fn prop_at(&mut self, prop: &Prop, most: u8) -> Result<String> {
        Ok(at(self.prop(prop)?, most))
    }

    fn props(&mut self, list: &[Prop], sign: &str, least: u8) -> Result<String> {
        let parts: Vec<String> = list.iter().map(|p| self.prop_at(p, least - 1)).collect::<Result<_>>()?;
        Ok(parts.join(sign))
    }

    fn prop(&mut self, prop: &Prop) -> Result<Text> {
        Ok(match &prop.kind {
            PropKind::Compare(sides, relations) => {
                let mut parts = Vec::new();
                for (pair, relation) in sides.windows(2).zip(relations) {
                    if let [a, b] = pair {
                        parts.push(self.comparison(a, *relation, b)?);
                    }
                }
                match <[Text; 1]>::try_from(parts) {
                    Ok([one]) => one,
                    Err(parts) => (parts.into_iter().map(|t| at(t, AND - 1)).collect::<Vec<_>>().join(" /\\ "), AND),
                }
            }
            PropKind::And(list) => (self.props(list, " /\\ ", AND)?, AND),
            PropKind::Or(list) => (self.props(list, " \\/ ", OR)?, OR),
            PropKind::Not(p) => (format!("~ {}", self.prop_at(p, APPLICATION)?), NOT),
            PropKind::Implies(p, q) => (format!("{} -> {}", self.prop_at(p, AND)?, self.prop_at(q, AND)?), IMPLIES),
            PropKind::Equivalent(list) => {
                let mut pairs = Vec::new();
                for pair in list.windows(2) {
                    if let [p, q] = pair {
                        pairs.push(format!("{} <-> {}", self.prop_at(p, OR)?, self.prop_at(q, OR)?));
                    }
                }
                match pairs.as_slice() {
                    [one] => (one.clone(), IFF),
                    _ => (pairs.iter().map(|p| format!("({p})")).collect::<Vec<_>>().join(" /\\ "), AND),
                }
            }
            PropKind::Exists(bindings, body) => self.within_bindings(bindings, |p| {
                let mut out = String::new();
                for binding in bindings {
                    out.push_str(&format!("exists {}, ", p.binders(binding)?));
                    for hypothesis in p.hypotheses(binding)? {
                        out.push_str(&format!("{hypothesis} /\\ "));
                    }
                }
                // That the body has a value is part of what exists.
                let placed = p.definitions.prop(body).map_err(|l| Unsupported::limit(l.0, body.span))?;
                let mut values = Collector::new(&p.kinds, &p.positive);
                values.prop(&placed);
                for need in p.conditions(&values.found)? {
                    out.push_str(&format!("{need} /\\ "));
                }
                out.push_str(&p.prop_at(body, AND)?);
                Ok((out, BINDER))
            })?,
            PropKind::ForAll(bindings, body) => self.within_bindings(bindings, |p| {
                let mut out = p.all_given(bindings)?;
                out.push_str(&p.prop_at(body, IMPLIES)?);
                Ok((out, BINDER))
            })?,
            PropKind::Extremum(extremum) => self.extremum(extremum)?,
            PropKind::Limit(limit) => self.limit(limit)?,
        })
    }

    /// The point lies in the domain and has the value; nothing in the domain has a larger one (for a
    /// maximum); with `only`, no other point has it.
    fn extremum(&mut self, extremum: &Extremum) -> Result<Text> {
        let names: Vec<&Name> = extremum.over.iter().flat_map(|b| b.names.iter().map(|n| &n.0)).collect();
        let mut point = Vec::new();
        for name in &names {
            match extremum.at.iter().find(|(n, _)| n.text == name.text) {
                Some((_, value)) => point.push(value),
                None => return unsupported(name.span, "an extremum without its point"),
            }
        }
        let f = self.word(&self.free_name("f"));
        let mut parts = Vec::new();
        let (mut binders, mut words) = (Vec::new(), Vec::new());
        for binding in &extremum.over {
            if binding.natural {
                return unsupported(binding.span, "an extremum over natural numbers");
            }
            binders.push(self.binders(binding)?);
            words.extend(binding.names.iter().map(|n| self.word(&n.0.text)));
            for (name, _) in &binding.names {
                if let Some((_, value)) = extremum.at.iter().find(|(n, _)| n.text == name.text) {
                    for constraint in &binding.constraints {
                        parts.push(self.constraint(value, false, constraint)?);
                    }
                }
            }
        }
        let arguments: Vec<String> = point.iter().map(|e| self.real_at(e, ATOM)).collect::<Result<_>>()?;
        let value = self.real_at(&extremum.value, SUM)?;
        parts.push(format!("{f} {} = {value}", arguments.join(" ")));
        let sign = if extremum.maximum { "<=" } else { ">=" };
        let (of, domain) = self.within_bindings(&extremum.over, |p| {
            let mut domain = String::new();
            for binding in &extremum.over {
                domain.push_str(&format!("{} ", p.given(binding)?));
            }
            Ok((p.real(&extremum.of)?.0, domain))
        })?;
        let here = format!("{f} {}", words.join(" "));
        let mut all = format!("{here} {sign} {value}");
        if extremum.unique {
            let same: Vec<String> = words
                .iter()
                .zip(&point)
                .map(|(w, e)| Ok(format!("{w} = {}", self.real_at(e, SUM)?)))
                .collect::<Result<_>>()?;
            all = format!("{all} /\\ ({here} = {value} -> {})", same.join(" /\\ "));
        }
        parts.push(format!("({domain}{all})"));
        Ok((format!("let {f} := fun {} => {of} in\n{}", binders.join(" "), parts.join(" /\\\n")), BINDER))
    }

    /// A name that the claim does not use.
    fn free_name(&self, wish: &str) -> String {
        let mut name = wish.to_string();
        while self.kinds.contains_key(&name) || self.words.contains_key(&name) {
            name.push('_');
        }
        name
    }

    fn limit(&mut self, limit: &Limit) -> Result<Text> {
        let of = self.in_place(&limit.of)?;
        let value = self.real_at(&limit.value, ATOM)?;
        let x = self.word(&limit.variable.text);
        if !self.inside && self.tied.iter().any(|text| mentions(text, &x)) {
            return unsupported(limit.variable.span, "a limit by a variable that a hypothesis restricts");
        }
        match self.kinds.get(&limit.variable.text) {
            Some(Kind::Natural) => {
                Ok((format!("is_lim_seq (fun {x} : nat => {}) {value}", self.real(&of)?.0), APPLICATION))
            }
            Some(Kind::Real) => {
                Ok((format!("is_lim (fun {x} : R => {}) p_infty {value}", self.real(&of)?.0), APPLICATION))
            }
            _ => unsupported(limit.variable.span, "a limit by what is no variable"),
        }
    }
}

/// `n` or `(n + 1)%nat`.
fn marked(text: Text) -> String {
    if text.1 == ATOM && !text.0.starts_with(|c: char| c.is_ascii_digit()) {
        text.0
    } else if text.1 == ATOM {
        format!("{}%nat", text.0)
    } else {
        format!("({})%nat", text.0)
    }
}

fn same_variable(by: &[Name], span: Span) -> Result<(&Name, usize)> {
    match by.first() {
        Some(first) if by.iter().all(|n| n.text == first.text) => Ok((first, by.len())),
        _ => unsupported(span, "a derivative by several variables"),
    }
}

/// The end of the generated part of `claims.v`; what follows is written by hand and kept.
pub const BY_HAND: &str = "(** * Beyond the claim files";

/// A file of definitions, `Definition NAME : Prop := …`, that proofs are written against.
pub fn definitions(statements: &[Statement]) -> String {
    let mut out = String::from(
        "(** What the claim files state, as propositions to be proved. Written by `carom export coq`:\n    \
         change the claim files, not this one. *)\n\nFrom Carom Require Import vocabulary.\n",
    );
    for statement in statements {
        out.push_str(&format!("\n(* statement sha256 {} *)", statement.digest));
        for (name, text) in statement.propositions() {
            out.push_str(&format!("\nDefinition {name} : Prop :=\n{text}.\n"));
        }
    }
    out
}

/// A file of theorems in full, each proved by the term of its name in the module that `proved` gives.
/// A statement without a proof is left out.
pub fn theorems(statements: &[Statement], proved: &BTreeMap<String, String>) -> String {
    let mut out = String::from(
        "(** Every claim in full, with the place of its proof. NAME is the claim of that name (its\n    \
         negation, where the claim is expected to be refuted); NAME_defined says that, under the same\n    \
         hypotheses, all its expressions have values. No other file is imported than [vocabulary], so\n    \
         that nothing of the proofs has a say in what the statements mean. The proofs are files that\n    \
         `carom export coq --proofs` makes from certificates.\n\n    \
         This part is written by `carom export coq --theorems`: change the claim files, not this one. *)\n\n",
    );
    let mut modules: Vec<&str> = proved.values().map(String::as_str).collect();
    modules.sort_unstable();
    modules.dedup();
    out.push_str("From Carom Require Import vocabulary.\n");
    for line in modules.chunks(8) {
        out.push_str(&format!("From Carom Require {}.\n", line.join(" ")));
    }
    for statement in statements.iter().filter(|s| proved.contains_key(&s.name)) {
        out.push_str(&format!("\n(* statement sha256 {} *)", statement.digest));
        for (name, text) in statement.propositions() {
            if let Some(module) = proved.get(&name) {
                out.push_str(&format!("\nTheorem {name} :\n{text}.\nProof. exact {module}.{name}. Qed.\n"));
            }
        }
    }
    out
}

impl Statement {
    /// The statement and, if there is one, that its expressions have values, each with its name.
    pub fn propositions(&self) -> Vec<(String, &str)> {
        let defined = self.defined.as_ref().map(|text| (format!("{}_defined", self.name), text.as_str()));
        std::iter::once((self.name.clone(), self.full.as_str())).chain(defined).collect()
    }
}

/// The theorems that a file of [`theorems`] has, by name, each with the module of its proof.
pub fn proved_in(text: &str) -> BTreeMap<String, String> {
    let one = |line: &str| {
        let (module, name) = line.strip_prefix("Proof. exact ")?.strip_suffix(". Qed.")?.split_once('.')?;
        Some((name.to_string(), module.to_string()))
    };
    text.lines().filter_map(one).collect()
}
