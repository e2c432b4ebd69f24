//! Abbreviations, expanded when a claim is read.
//!
//! Contract: after [`write_out`] no abbreviation is left in a claim, so that search, kernel, evaluator and exports see
//! the words of [`FUNCTIONS`] only; the digest of a certificate covers the written form. A name that the claim declares
//! is no abbreviation there.
//!
//! | written | stands for | has a value where |
//! |---|---|---|
//! | `\|x\|`, `abs(x)` | `sqrt(x^2)` | x has one |
//! | `max(a, b)` | `(a + b + sqrt((a - b)^2))/2` | a and b have one |
//! | `min(a, b)` | `(a + b - sqrt((a - b)^2))/2` | a and b have one |
//! | `n!`, `factorial(n)` | `product(i = 1..n, i)` | n is a natural number |
//! | `binomial(n, k)` | `product(i = 1..k, (n + 1 - i)/i)` | k is a natural number |
//! | `trace(M)` | the sum of the diagonal | its entries have one |
//! | `inverse(M)` | cofactors over `det(M)` | det(M) ≠ 0 |
//! | `M^3`, `M^0`, `M^-2` | `M*M*M`, the unit matrix, `inverse(M)*inverse(M)` | as these |
//! | `M^n` | members of families, see `matrix_power` | n is a natural number |
//!
//! A matrix is one whose entries are written: `[a, b; c, d]`, a `let` of one, or sums and products of such.

use super::definedness::number;
use super::diagnostic::{Diagnostic, Fault};
use super::fresh::Fresh;
use super::matrix::{Matrices, Unfit, apply, at, numeral};
use super::matrix_power::Powers;
use super::preamble::{bound_in, declared};
use super::syntax::*;
use super::total::Values;
use super::walk;
use std::collections::BTreeSet;

/// The abbreviations with the least and the largest number of their arguments.
const ABBREVIATIONS: &[(&str, usize, usize)] = &[
    ("abs", 1, 1),
    ("max", 2, 8),
    ("min", 2, 8),
    ("factorial", 1, 1),
    ("binomial", 2, 2),
    ("trace", 1, 1),
    ("inverse", 1, 1),
];

/// The most nodes that the abbreviations of one claim may write.
pub(crate) const NODES_LIMIT: usize = 100_000;

/// The deepest expression that is written.
const DEPTH_LIMIT: usize = 400;

/// The largest exponent of a matrix.
const POWER_LIMIT: i128 = 100;

/// How many arguments the abbreviation of this name takes: the least and the largest number.
pub(crate) fn arguments(name: &str) -> Option<(usize, usize)> {
    ABBREVIATIONS.iter().find(|a| a.0 == name).map(|a| (a.1, a.2))
}

/// The names of all abbreviations.
pub(crate) fn names() -> impl Iterator<Item = &'static str> {
    ABBREVIATIONS.iter().map(|a| a.0)
}

/// Whether there is an abbreviation of this name.
pub(crate) fn is_one(name: &str) -> bool {
    arguments(name).is_some()
}

/// Writes out every abbreviation of a claim.
pub(super) fn write_out(claim: &mut Claim, fresh: &mut Fresh, faults: &mut Vec<Diagnostic>) {
    let mut names = BTreeSet::new();
    walk::expressions(claim, &mut |e| walk::names_in(e, &mut names));
    let mut own: BTreeSet<String> = claim.items.iter().flat_map(declared).map(|n| n.text.clone()).collect();
    walk::bound_names(claim, &mut |name| {
        own.insert(name.to_string());
    });
    names.extend(own.iter().cloned());
    let bound = bound_in(claim);
    let powers = Powers { bound, values: Values::default(), known: Vec::new(), open: Vec::new() };
    let mut writer = Writer { names, own, fresh, matrices: Matrices::default(), powers, nodes: 0, full: false, faults };
    let mut items = Vec::new();
    for mut item in std::mem::take(&mut claim.items) {
        walk::of_item(&mut item, &mut |e| writer.top(e));
        if let Item::Let { name, parameters, value } = &item
            && parameters.is_empty()
        {
            // One that is too large is refused where its entries are needed.
            if let Some(rows) = writer.matrices.entries(value).transpose() {
                writer.matrices.0.insert(name.text.clone(), rows);
            }
        }
        writer.powers.values.learn(&item);
        items.append(&mut writer.powers.open);
        items.push(item);
    }
    walk::expressions(claim, &mut |e| writer.top(e));
    items.append(&mut writer.powers.open);
    sampled(claim, &items);
    claim.items = items;
}

/// A sample's value of an `integer` k is one of its two parts, the other being 0.
fn sampled(claim: &mut Claim, items: &[Item]) {
    let difference = |name: &Name| {
        items.iter().find_map(|item| match item {
            Item::Let { name: own, value: Expr { kind: ExprKind::Sum(list), .. }, .. } if own == name => {
                match list.as_slice() {
                    [
                        (Sign::Plus, Expr { kind: ExprKind::Name(up), .. }),
                        (Sign::Minus, Expr { kind: ExprKind::Name(down), .. }),
                    ] => Some((up.clone(), down.clone())),
                    _ => None,
                }
            }
            _ => None,
        })
    };
    for (name, value) in std::mem::take(&mut claim.sample) {
        let Some((up, down)) = difference(&name) else {
            claim.sample.push((name, value));
            continue;
        };
        let span = name.span;
        let (more, less) = match value.kind {
            ExprKind::Negate(size) => (numeral(span, 0), *size),
            _ => (value, numeral(span, 0)),
        };
        claim.sample.push((Name { text: up, span }, more));
        claim.sample.push((Name { text: down, span }, less));
    }
}

/// Writes out abbreviations, item by item.
pub(super) struct Writer<'a> {
    /// Every name that occurs in the claim.
    pub(super) names: BTreeSet<String>,
    /// Those that it declares.
    own: BTreeSet<String>,
    pub(super) fresh: &'a mut Fresh,
    pub(super) matrices: Matrices,
    pub(super) powers: Powers,
    nodes: usize,
    full: bool,
    faults: &'a mut Vec<Diagnostic>,
}

impl Writer<'_> {
    /// Writes out an expression that is no part of another.
    fn top(&mut self, e: &mut Expr) {
        let before = self.nodes;
        self.expr(e);
        if self.nodes > before && walk::depth(e) > DEPTH_LIMIT {
            self.limit("levels of abbreviations written out", DEPTH_LIMIT, e.span);
        }
    }

    pub(super) fn limit(&mut self, name: &'static str, allowed: usize, span: Span) {
        if !self.full {
            self.full = true;
            self.faults.push(Diagnostic::new(Fault::Limit { name, allowed }, span));
        }
    }

    /// Whether there is room for so many nodes more.
    pub(super) fn room(&mut self, more: usize, span: Span) -> bool {
        self.nodes = self.nodes.saturating_add(more);
        if self.nodes > NODES_LIMIT {
            self.limit("nodes of abbreviations written out", NODES_LIMIT, span);
        }
        !self.full
    }

    fn expr(&mut self, e: &mut Expr) {
        if self.full {
            return;
        }
        walk::parts_mut(e, &mut |part| self.expr(part));
        let span = e.span;
        match &mut e.kind {
            ExprKind::Apply(name, arguments) if is_one(&name.text) && !self.own.contains(&name.text) => {
                let (name, arguments) = (name.text.clone(), std::mem::take(arguments));
                let size: usize = arguments.iter().map(walk::nodes_in).sum();
                if self.room(4 * size + 20, span)
                    && let Some(kind) = self.written(&name, arguments, span)
                {
                    e.kind = kind;
                }
            }
            ExprKind::Power(base, exponent) => {
                match self.matrices.entries(base) {
                    Ok(Some(_)) => {}
                    Ok(None) => return,
                    Err(unfit) => return self.unfit("a power", unfit, span),
                }
                let exponent = match number(exponent) {
                    Some((k, 1)) if (-POWER_LIMIT..=POWER_LIMIT).contains(&k) => k as i64,
                    Some(_) => {
                        let message = "a numeral as the exponent of a matrix is a whole number from -100 to 100";
                        return self.fault(message, "use a natural variable: M^n", span);
                    }
                    None => {
                        let (base, exponent) = (base.as_ref().clone(), exponent.as_ref().clone());
                        if let Some(kind) = self.variable_power(&base, &exponent, span) {
                            e.kind = kind;
                        }
                        return;
                    }
                };
                let size = walk::nodes_in(base).saturating_mul(exponent.unsigned_abs() as usize + 1);
                if self.room(size.saturating_mul(6), span) {
                    match self.matrices.power(base, exponent) {
                        Ok(kind) => e.kind = kind,
                        Err(unfit) => self.unfit("a power", unfit, span),
                    }
                }
            }
            _ => {}
        }
    }

    fn written(&mut self, name: &str, mut arguments: Vec<Expr>, span: Span) -> Option<ExprKind> {
        match name {
            "abs" => Some(size(arguments.pop()?, span).kind),
            "max" | "min" => {
                let sign = if name == "max" { Sign::Plus } else { Sign::Minus };
                let mut list = arguments.into_iter();
                let mut out = list.next()?;
                for other in list {
                    if !self.room(2 * (walk::nodes_in(&out) + walk::nodes_in(&other)) + 10, span) {
                        return None;
                    }
                    out = extreme(out, other, sign, span);
                }
                Some(out.kind)
            }
            "factorial" => {
                let to = arguments.pop()?;
                let index = self.index(&[], span);
                let body = at(span, ExprKind::Name(index.text.clone()));
                let index = Index { name: index, from: Box::new(numeral(span, 1)), to: Box::new(to) };
                Some(ExprKind::ProductOver(index, Box::new(body)))
            }
            "binomial" => {
                let (k, n) = (arguments.pop()?, arguments.pop()?);
                let index = self.index(&[&n, &k], span);
                let i = at(span, ExprKind::Name(index.text.clone()));
                // No factor speaks of k, so that binomial(n, k + 1) is binomial(n, k) times one factor.
                let one = numeral(span, 1);
                let top = ExprKind::Sum(vec![(Sign::Plus, n), (Sign::Plus, one), (Sign::Minus, i.clone())]);
                let body = ExprKind::Product(vec![(Factor::Times, at(span, top)), (Factor::Over, i)]);
                let index = Index { name: index, from: Box::new(numeral(span, 1)), to: Box::new(k) };
                Some(ExprKind::ProductOver(index, Box::new(at(span, body))))
            }
            _ => {
                let matrix = arguments.pop()?;
                let inverse = name == "inverse";
                let kind = if inverse { self.matrices.inverse(&matrix) } else { self.matrices.trace(&matrix) };
                match kind {
                    Ok(kind) => {
                        let size = walk::nodes_in(&at(span, kind.clone()));
                        self.room(size, span).then_some(kind)
                    }
                    Err(unfit) => {
                        self.unfit(if inverse { "an inverse" } else { "a trace" }, unfit, span);
                        None
                    }
                }
            }
        }
    }

    /// A fresh name for a bound index: it occurs nowhere in the claim, nor bound in these parts.
    pub(super) fn index(&self, parts: &[&Expr], span: Span) -> Name {
        let mut inside = BTreeSet::new();
        parts.iter().for_each(|part| walk::names_in(part, &mut inside));
        let is_free = |name: &String| !self.names.contains(name) && !inside.contains(name);
        let letters = ["i", "j", "k", "l"].map(str::to_string);
        let text = letters.into_iter().chain((1..).map(|k| format!("i{k}"))).find(is_free).unwrap_or_default();
        Name { text, span }
    }

    pub(super) fn unfit(&mut self, what: &str, unfit: Unfit, span: Span) {
        match unfit {
            Unfit::TooLarge => self.limit("nodes of abbreviations written out", NODES_LIMIT, span),
            Unfit::NotSquare => self.fault(&format!("{what} needs a square matrix"), "", span),
            Unfit::NotWritten => self.fault(
                &format!("{what} needs a matrix whose entries are written out"),
                "write the matrix as [a, b; c, d], or name it: `let M = [a, b; c, d]`",
                span,
            ),
        }
    }

    pub(super) fn fault(&mut self, message: &str, help: &str, span: Span) {
        let help = (!help.is_empty()).then(|| help.to_string());
        self.faults.push(Diagnostic::new(Fault::Other { message: message.to_string(), help }, span));
    }
}

/// `sqrt(a^2)`
fn size(a: Expr, span: Span) -> Expr {
    let square = ExprKind::Power(Box::new(a), Box::new(numeral(span, 2)));
    apply(span, "sqrt", at(span, square))
}

/// `(a + b ± sqrt((a - b)^2))/2`
fn extreme(a: Expr, b: Expr, sign: Sign, span: Span) -> Expr {
    let difference = at(span, ExprKind::Sum(vec![(Sign::Plus, a.clone()), (Sign::Minus, b.clone())]));
    let sum = ExprKind::Sum(vec![(Sign::Plus, a), (Sign::Plus, b), (sign, size(difference, span))]);
    at(span, ExprKind::Product(vec![(Factor::Times, at(span, sum)), (Factor::Over, numeral(span, 2))]))
}
