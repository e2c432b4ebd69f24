//! Trees that a text can say.
//!
//! Contract: the kernel takes a claim, and a step, only if some text of the language reads as its trees. A comparison then has one
//! more side than relations, a name looks like no numeral and no other part of a key, and the same for whatever else a rule
//! supposes of the form of a tree. In a claim every name is declared where it is used, and declared or bound once: a quantifier,
//! a sum or a definition that takes a name which has a meaning there is refused. So is a quantifier of a step. The index of a
//! sum in a step may hide a name, since a `let` that is put in place brings its index along.
//!
//! Depth and size are bounded, so that recursion over what was looked at is safe.

use super::substitution::Room;
use super::{Reason, Refusal, rejected};
use crate::certificate::{Refutes, Rule, Show};
use crate::claim::syntax::*;
use std::collections::BTreeSet;

/// The longest numeral in characters, and its largest decimal exponent.
const NUMERAL_LIMIT: usize = 10_000;
/// The longest name in characters.
const NAME_LIMIT: usize = 100;

/// The words of the language, which are no names; sorted.
const WORDS: [&str; 43] = [
    "all",
    "and",
    "as",
    "assume",
    "at",
    "by",
    "case",
    "claim",
    "conclude",
    "define",
    "derivative",
    "each",
    "exists",
    "expect",
    "for",
    "given",
    "have",
    "in",
    "infinity",
    "integral",
    "is",
    "let",
    "limit",
    "maximum",
    "minimum",
    "natural",
    "not",
    "note",
    "number",
    "obtain",
    "of",
    "only",
    "or",
    "over",
    "product",
    "prove",
    "reading",
    "real",
    "section",
    "source",
    "sum",
    "using",
    "with",
];

/// A tree that no text says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// A comparison without one more side than relations.
    Comparison,
    /// A sum or product of fewer than two parts, or whose first part is subtracted or divided by.
    Parts,
    /// `and`, `or` or `<=>` of fewer than two parts.
    Connective,
    /// A matrix without entries, or with rows of different lengths.
    Matrix,
    /// A function without arguments.
    Arguments,
    /// A derivative by nothing.
    Derivative,
    /// A quantifier or declaration without names.
    Binding,
    /// A range `a..b` of what is not natural.
    Range,
    /// An extremum whose point does not give each of its variables one value.
    Extremum,
    /// A limit at a point, or an infinite one: the reader writes it out.
    WrittenLimit,
    /// A label that is not made of letters and digits.
    Label,
}

/// Whether a text reads as a name.
pub(super) fn is_name(text: &str) -> bool {
    is_spelled(text, false) && text.len() <= NAME_LIMIT && WORDS.binary_search(&text).is_err()
}

/// Whether a text reads as a numeral: digits, perhaps with a point and digits, perhaps with a decimal exponent.
pub(super) fn is_numeral(text: &str) -> bool {
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let (whole, part) = mantissa.split_once('.').unwrap_or((mantissa, "0"));
    digits(whole) && digits(part) && digits(exponent.strip_prefix(['+', '-']).unwrap_or(exponent))
}

/// A letter, then letters and digits with single `_` between them, and `'` at the end; perhaps also with dashes.
fn is_spelled(text: &str, dashes: bool) -> bool {
    let is_part = |b: u8| b.is_ascii_alphanumeric() || b == b'_' || b == b'\'' || (dashes && b == b'-');
    text.starts_with(|c: char| c.is_ascii_alphabetic())
        && text.bytes().all(is_part)
        && text.split('_').all(|part| !part.is_empty())
        && text.split('-').skip(1).all(|rest| rest.starts_with(|c: char| c.is_ascii_alphanumeric()))
        && !text.trim_end_matches('\'').contains('\'')
}

/// Checks a claim as it is written, before its definitions are put in place.
pub(super) fn claim(claim: &Claim) -> Result<(), Refusal> {
    let mut walk = Walk::new(true, &|_| false);
    for name in claim.using.iter().chain([&claim.name]) {
        walk.spelled(&name.text, true)?;
    }
    for item in &claim.items {
        walk.room = Room::new();
        match item {
            Item::Given(bindings) => {
                walk.bindings(bindings, Walk::declare)?;
            }
            Item::Let { name, parameters, value } => {
                let outside = walk.bound.len();
                parameters.iter().try_for_each(|parameter| walk.bind(&parameter.text))?;
                walk.expr(value)?;
                walk.leave(outside);
                walk.declare(&name.text)?;
            }
            Item::Define { name, initial, index, step, .. } => {
                walk.expr(initial)?;
                walk.declare(&name.text)?;
                let outside = walk.bound.len();
                walk.bind(&index.text)?;
                walk.expr(step)?;
                walk.leave(outside);
            }
            Item::Assume { prop, .. } => walk.prop(prop)?,
        }
    }
    walk.room = Room::new();
    walk.prop(&claim.goal)
}

/// Checks what a certificate says of the point at which a claim is false.
pub(super) fn refutes(refutes: &Refutes) -> Result<(), Refusal> {
    let sides = refutes.point.iter().flat_map(|(place, value)| [place, value]);
    sides.chain(&refutes.undefined).try_for_each(expr)
}

/// Checks a step, but for its label. `taken` says of a name whether no quantifier may bind it.
pub(super) fn step(show: &Show, taken: &dyn Fn(&str) -> bool) -> Result<(), Refusal> {
    Walk::new(false, taken).prop(&show.prop)?;
    for (name, value) in show.rule.values() {
        Walk::new(false, taken).spelled(&name.text, false)?;
        expr(value)?;
    }
    if let Rule::Combination { times, terms } = &show.rule {
        times.iter().chain(terms.iter().map(|term| &term.factor)).try_for_each(expr)?;
    }
    Ok(())
}

/// Checks the label of a step.
pub(super) fn label(text: &str) -> Result<(), Refusal> {
    let is_one = !text.is_empty() && text.bytes().all(|b| b.is_ascii_alphanumeric());
    if is_one { Ok(()) } else { malformed(Shape::Label) }
}

/// Checks a proposition by itself.
pub(super) fn prop(p: &Prop) -> Result<(), Refusal> {
    Walk::new(false, &|_| false).prop(p)
}

/// Checks an expression by itself.
pub(super) fn expr(e: &Expr) -> Result<(), Refusal> {
    Walk::new(false, &|_| false).expr(e)
}

fn malformed<T>(shape: Shape) -> Result<T, Refusal> {
    rejected(Reason::Malformed(shape))
}

struct Walk<'a> {
    room: Room,
    /// Whether it is a claim: then names are declared before they are used, and an index takes a new one.
    is_claim: bool,
    /// Whether `pi` was used as the number π.
    uses_pi: bool,
    /// The names outside that no quantifier may bind.
    taken: &'a dyn Fn(&str) -> bool,
    /// The names that are declared or bound here, in this order.
    bound: Vec<&'a str>,
    /// The same, to be looked up.
    known: BTreeSet<&'a str>,
}

impl<'a> Walk<'a> {
    fn new(is_claim: bool, taken: &'a dyn Fn(&str) -> bool) -> Walk<'a> {
        Walk { room: Room::new(), is_claim, uses_pi: false, taken, bound: Vec::new(), known: BTreeSet::new() }
    }

    /// Takes a name that begins here. No such name hides π.
    fn bind(&mut self, name: &'a str) -> Result<(), Refusal> {
        if name == PI {
            return rejected(Reason::NoName(name.to_string()));
        }
        self.declare(name)
    }

    /// Takes a name that the claim declares; `pi` if it was not used as a number before.
    fn declare(&mut self, name: &'a str) -> Result<(), Refusal> {
        self.spelled(name, false)?;
        if name == PI && self.uses_pi {
            return rejected(Reason::NameInUse(name.to_string()));
        }
        if is_built_in(name) {
            return rejected(Reason::NoName(name.to_string()));
        }
        if (self.taken)(name) || !self.known.insert(name) {
            return rejected(Reason::NameInUse(name.to_string()));
        }
        self.bound.push(name);
        Ok(())
    }

    /// Ends a scope: only the first `outside` names stay.
    fn leave(&mut self, outside: usize) {
        for name in self.bound.drain(outside..) {
            self.known.remove(name);
        }
    }

    fn spelled(&self, text: &str, dashes: bool) -> Result<(), Refusal> {
        if text.len() > NAME_LIMIT {
            return Err(Refusal::Limit("characters in a name"));
        }
        if is_spelled(text, dashes) && WORDS.binary_search(&text).is_err() {
            return Ok(());
        }
        rejected(Reason::NoName(text.to_string()))
    }

    /// A name that is used.
    fn used(&mut self, text: &str) -> Result<(), Refusal> {
        self.spelled(text, false)?;
        if text == PI && !self.known.contains(text) {
            self.uses_pi = true;
            return Ok(());
        }
        if self.is_claim && !self.known.contains(text) {
            return rejected(Reason::Undeclared(text.to_string()));
        }
        Ok(())
    }

    fn exprs<'e: 'a>(&mut self, list: impl IntoIterator<Item = &'e Expr>) -> Result<(), Refusal> {
        list.into_iter().try_for_each(|e| self.expr(e))
    }

    fn expr(&mut self, e: &'a Expr) -> Result<(), Refusal> {
        self.room.enter()?;
        match &e.kind {
            ExprKind::Number(text) => numeral(text)?,
            ExprKind::Name(text) => self.used(text)?,
            ExprKind::Apply(function, arguments) => {
                match (is_built_in(&function.text), arguments.len()) {
                    (_, 0) => return malformed(Shape::Arguments),
                    (true, 1) => {}
                    (true, _) => return rejected(Reason::Arguments(function.text.clone())),
                    (false, _) => self.used(&function.text)?,
                }
                self.exprs(arguments)?;
            }
            ExprKind::Negate(a) => self.expr(a)?,
            ExprKind::Sum(list) => {
                if list.len() < 2 || list.first().is_some_and(|part| part.0 == Sign::Minus) {
                    return malformed(Shape::Parts);
                }
                self.exprs(list.iter().map(|part| &part.1))?;
            }
            ExprKind::Product(list) => {
                if list.len() < 2 || list.first().is_some_and(|part| part.0 == Factor::Over) {
                    return malformed(Shape::Parts);
                }
                self.exprs(list.iter().map(|part| &part.1))?;
            }
            ExprKind::Power(a, b) => self.exprs([&**a, b])?,
            ExprKind::SumOver(index, body)
            | ExprKind::ProductOver(index, body)
            | ExprKind::IntegralOver(index, body) => {
                self.exprs([&*index.from, &index.to])?;
                let outside = self.bound.len();
                match self.is_claim {
                    true => self.bind(&index.name.text)?,
                    false if index.name.text == PI => return rejected(Reason::NoName(index.name.text.clone())),
                    false => self.spelled(&index.name.text, false)?,
                }
                self.expr(body)?;
                self.leave(outside);
            }
            ExprKind::Derivative(body, by) => {
                if by.is_empty() {
                    return malformed(Shape::Derivative);
                }
                by.iter().try_for_each(|name| self.used(&name.text))?;
                self.expr(body)?;
            }
            ExprKind::Matrix(rows) => {
                let width = rows.first().map_or(0, Vec::len);
                if width == 0 || rows.iter().any(|row| row.len() != width) {
                    return malformed(Shape::Matrix);
                }
                self.exprs(rows.iter().flatten())?;
            }
        }
        self.room.leave();
        Ok(())
    }

    fn props(&mut self, list: &'a [Prop]) -> Result<(), Refusal> {
        if list.len() < 2 {
            return malformed(Shape::Connective);
        }
        list.iter().try_for_each(|p| self.prop(p))
    }

    fn prop(&mut self, p: &'a Prop) -> Result<(), Refusal> {
        self.room.enter()?;
        match &p.kind {
            PropKind::Compare(sides, relations) => {
                if relations.is_empty() || sides.len() != relations.len() + 1 {
                    return malformed(Shape::Comparison);
                }
                self.exprs(sides)?;
            }
            PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => self.props(list)?,
            PropKind::Not(inner) => self.prop(inner)?,
            PropKind::Implies(a, b) => [a, b].into_iter().try_for_each(|p| self.prop(p))?,
            PropKind::Exists(bindings, body) | PropKind::ForAll(bindings, body) => {
                let outside = self.bound.len();
                self.quantified(bindings)?;
                self.prop(body)?;
                self.leave(outside);
            }
            PropKind::Extremum(extremum) => self.extremum(extremum)?,
            PropKind::WrittenLimit(_) => return malformed(Shape::WrittenLimit),
            PropKind::Limit(limit) => {
                self.used(&limit.variable.text)?;
                self.exprs([&limit.of, &limit.value])?;
            }
        }
        self.room.leave();
        Ok(())
    }

    /// The point and the value stand outside the scope of the variables.
    fn extremum(&mut self, extremum: &'a Extremum) -> Result<(), Refusal> {
        self.exprs(extremum.at.iter().map(|at| &at.1).chain([&extremum.value]))?;
        let outside = self.bound.len();
        self.quantified(&extremum.over)?;
        self.expr(&extremum.of)?;
        let at: BTreeSet<&str> = extremum.at.iter().map(|at| at.0.text.as_str()).collect();
        let over: BTreeSet<&str> = self.bound.iter().skip(outside).copied().collect();
        if at.len() != extremum.at.len() || at != over {
            return malformed(Shape::Extremum);
        }
        self.leave(outside);
        Ok(())
    }

    fn quantified(&mut self, bindings: &'a [Binding]) -> Result<(), Refusal> {
        if bindings.is_empty() { malformed(Shape::Binding) } else { self.bindings(bindings, Walk::bind) }
    }

    /// Declares names one after the other, each in this way; those of a binding do not stand in its own bounds.
    fn bindings(
        &mut self,
        bindings: &'a [Binding],
        declare: fn(&mut Self, &'a str) -> Result<(), Refusal>,
    ) -> Result<(), Refusal> {
        for binding in bindings {
            if binding.names.is_empty() {
                return malformed(Shape::Binding);
            }
            // A bound of a family may mention its own index, and no other.
            let indices: BTreeSet<Option<&'a str>> =
                binding.names.iter().map(|name| name.1.as_ref().map(|index| index.text.as_str())).collect();
            for index in indices {
                let outside = self.bound.len();
                index.iter().try_for_each(|index| self.bind(index))?;
                self.constraints(binding)?;
                self.leave(outside);
            }
            if let Some((from, to)) = &binding.indices {
                self.exprs([from, to])?;
            }
            binding.names.iter().try_for_each(|name| declare(self, &name.0.text))?;
        }
        Ok(())
    }

    fn constraints(&mut self, binding: &'a Binding) -> Result<(), Refusal> {
        for constraint in &binding.constraints {
            match constraint {
                Constraint::Relation(_, bound) => self.expr(bound)?,
                Constraint::Interval { from, to, .. } => self.exprs([from, to])?,
                Constraint::Range(..) if !binding.natural => return malformed(Shape::Range),
                Constraint::Range(from, to) => self.exprs([from, to])?,
            }
        }
        Ok(())
    }
}

/// A numeral within the reader's limits.
fn numeral(text: &str) -> Result<(), Refusal> {
    if !is_numeral(text) {
        return rejected(Reason::Numeral(text.chars().take(20).collect()));
    }
    let exponent = text.split_once(['e', 'E']).map_or("0", |part| part.1).trim_start_matches(['+', '-']);
    if text.len() > NUMERAL_LIMIT || exponent.parse::<usize>().map_or(true, |size| size > NUMERAL_LIMIT) {
        return Err(Refusal::Limit("digits of a numeral"));
    }
    Ok(())
}
