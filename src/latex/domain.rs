//! The domains of names that a quantifier or an extremum binds: `\forall n > 0`, `\exists x \in [0, 1]`.
//!
//! Contract: a bound name without a kind of its own takes the kind that is declared for this name. Where more is declared of it
//! than the formula says, both readings are possible and it is refused; so is a letter such as n that nothing declares.

use super::expression::{Read, Reader};
use super::name::{Symbol, argument, words_of};
use super::refusal::{ambiguous, refused};
use super::scope::Role;
use super::token::words;
use carom_checker::claim::preamble::Preamble;
use carom_checker::claim::print::Style;
use carom_checker::claim::syntax::{Binding, Claim, Expr, ExprKind, Item};
use carom_diagnostic::{Diagnostic, Span};
use std::collections::BTreeMap;

/// Letters that often count.
const COUNTS: &[&str] = &["i", "j", "k", "n", "N"];

/// What is declared of a variable.
#[derive(Clone, Debug, Default)]
pub(crate) struct Domain {
    /// Whether it is a natural number.
    natural: bool,
    /// Whether it is an integer.
    whole: bool,
    /// Its constraints as the claim language writes them: `>= 1`.
    bounds: Vec<String>,
    /// Whether a hypothesis mentions it.
    supposed: bool,
}

/// The domains of the variables that a claim and its preamble declare.
pub(crate) fn domains(claim: &Claim, preamble: &Preamble) -> BTreeMap<String, Domain> {
    let mut out: BTreeMap<String, Domain> = BTreeMap::new();
    let items = || preamble.items.iter().chain(&claim.items);
    for item in items() {
        match item {
            Item::Given(list) => list.iter().for_each(|binding| {
                let domain = Domain { natural: binding.natural, bounds: bounds(binding), ..Domain::default() };
                let plain = binding.names.iter().filter(|name| name.1.is_none());
                out.extend(plain.map(|(name, _)| (name.text.clone(), domain.clone())));
            }),
            Item::Let { name, value, .. } if is_integer(&name.text, value) => {
                out.insert(name.text.clone(), Domain { whole: true, ..Domain::default() });
            }
            _ => {}
        }
    }
    for item in items() {
        let Item::Assume { prop, .. } = item else { continue };
        for word in words_of(&Style::Text.prop(prop)) {
            out.entry(word.to_string()).and_modify(|domain| domain.supposed = true);
        }
    }
    out
}

/// The constraints of a declaration, each as text: that of one variable of the same domain, taken apart.
fn bounds(binding: &Binding) -> Vec<String> {
    let alone = |constraint| Binding {
        constraints: vec![constraint],
        natural: false,
        indices: None,
        unit: None,
        ..binding.clone()
    };
    let text = |binding: &Binding| {
        let whole = Style::Text.binding(binding);
        let names = Style::Text.binding(&Binding { constraints: Vec::new(), ..binding.clone() });
        let names = names.strip_suffix(" real").unwrap_or(&names).len();
        whole[names..].trim().to_string()
    };
    binding.constraints.iter().map(|constraint| text(&alone(constraint.clone()))).collect()
}

/// Whether a definition is that of an integer, which the claim language writes as a difference.
fn is_integer(name: &str, value: &Expr) -> bool {
    let is = |e: &Expr, end: &str| matches!(&e.kind, ExprKind::Name(part) if *part == format!("{name}_{end}"));
    matches!(&value.kind, ExprKind::Sum(parts) if parts.len() == 2 && is(&parts[0].1, "up") && is(&parts[1].1, "down"))
}

/// Whether the bounds that a formula says of a name imply one that is declared.
fn implied(said: &[String], bound: &str, natural: bool) -> bool {
    // A number is at least this.
    let least = |text: &str| {
        let strict = text.strip_prefix("> ").and_then(|n| n.trim().parse::<i64>().ok()?.checked_mul(2)?.checked_add(1));
        let strict = strict.map(|twice| if natural { twice + 1 } else { twice });
        strict.or_else(|| text.strip_prefix(">= ").and_then(|n| n.trim().parse::<i64>().ok()?.checked_mul(2)))
    };
    let declared = least(bound);
    natural && declared.is_some_and(|twice| twice <= 0)
        || said.iter().any(|own| own == bound || (declared.is_some() && least(own) >= declared))
}

impl Reader<'_, '_, '_> {
    /// What is added to the bounds that the formula says of a bound name, to say its domain.
    pub(crate) fn kind_of_bound(&mut self, symbol: &Symbol, name: &str, said: &[String]) -> Read<String> {
        let key = symbol.key();
        let span = symbol.span;
        if let Some(role) = self.scope.roles.get(name).filter(|role| **role != Role::Variable) {
            let is_whole = self.scope.domains.get(name).is_some_and(|domain| domain.whole);
            let message = match (is_whole, role) {
                (true, _) => format!("{key} is declared as an integer, which no quantifier takes"),
                (false, _) => format!("{key} is defined, and is bound here as a name of its own"),
            };
            return Err(refused(message, format!("{}, or use another letter", by_comment(name, "real")), span));
        }
        let Some(domain) = self.scope.domains.get(name).cloned() else {
            if COUNTS.contains(&symbol.base.as_str()) && !said.is_empty() {
                let readings = ["a natural number", "a real number"];
                let write = [format!("write `%carom given {key} natural`"), format!("write `%carom given {key} real`")];
                let write = write.each_ref().map(String::as_str);
                return Err(ambiguous(&format!("{key}, which nothing declares,"), readings, write, span));
            }
            return if said.is_empty() { Err(no_domain(&key, span)) } else { Ok(String::new()) };
        };
        let kind = if domain.natural { "natural" } else { "real" };
        let whole = domain.bounds.join(" and ");
        let missing = domain.bounds.iter().any(|bound| !implied(said, bound, domain.natural));
        // Without a bound of its own the name is the declared one.
        if domain.supposed || (missing && !said.is_empty()) {
            let declared = if missing { format!("{kind} {whole}") } else { format!("{kind}, with its hypotheses") };
            let readings =
                [format!("the values that are declared, {declared}"), format!("all {kind} numbers with this bound")];
            let write = [by_comment(name, &format!("{kind} {whole}")), by_comment(name, kind)];
            let (readings, write) = (readings.each_ref().map(String::as_str), write.each_ref().map(String::as_str));
            return Err(ambiguous(&format!("the domain of {key}"), readings, write, span));
        }
        Ok(match (said.is_empty(), domain.natural) {
            (true, _) => format!(" {kind} {whole}").trim_end().to_string(),
            (false, true) => " natural".to_string(),
            (false, false) => String::new(),
        })
    }

    /// The same behind `\in \mathbb{N}`: whether 0 is one of them is declared.
    pub(crate) fn declared_as_natural(&mut self, symbol: &Symbol, name: &str, said: &[String]) -> Read<String> {
        if self.scope.domains.get(name).is_some_and(|domain| domain.natural) {
            return self.kind_of_bound(symbol, name, said);
        }
        let key = symbol.key();
        let readings = ["the numbers 0, 1, 2, …", "the numbers 1, 2, …"];
        let write =
            [format!("declare `%carom given {key} natural`"), format!("declare `%carom given {key} natural >= 1`")];
        Err(ambiguous("\\mathbb{N}", readings, write.each_ref().map(String::as_str), symbol.span))
    }

    /// `\mathbb{R}`, `\mathbb{N}_0` or `\mathbb{N}` behind `\in`, if it stands here: the kind, or nothing where it is to be declared.
    pub(crate) fn number_set(&mut self) -> Read<Option<Option<&'static str>>> {
        let span = self.span();
        if !self.peek().is_some_and(|t| t.is("mathbb") || t.is("mathbf")) {
            return Ok(None);
        }
        let (inner, next) = argument(self.tokens, self.at + 1)?;
        let set = words(inner);
        let has_zero = self.tokens.get(next).is_some_and(|t| t.is_char('_'));
        let below = if has_zero { Some(argument(self.tokens, next + 1)?) } else { None };
        let said = (set.as_str(), below.map(|(inner, _)| words(inner)));
        let kind = match (said.0, said.1.as_deref()) {
            ("R", None) => Some("real"),
            ("N", Some("0")) => Some("natural"),
            ("N", None) => None,
            _ => {
                let help = "write an interval, or say it in a comment: `%carom prove for all n natural: …`";
                return Err(refused("this set is not read", help, span));
            }
        };
        self.at = below.map_or(next, |(_, next)| next);
        Ok(Some(kind))
    }
}

/// A bound name without any domain.
pub(crate) fn no_domain(key: &str, span: Span) -> Diagnostic {
    let help =
        format!("write `> 0`, `\\in [0, 1]` or `\\text{{real}}` behind it, or declare it: `%carom given {key} real`");
    refused(format!("nothing says which values {key} takes"), help, span)
}

/// The comment that decides the domain of a bound name.
fn by_comment(name: &str, domain: &str) -> String {
    format!("say the statement in a comment, `%carom prove for all {name} {}: …`", domain.trim_end())
}
