//! The text format of certificates: one step to a line, its hints on indented lines below.
//!
//! Contract: what is written reads back to the same certificate; anything else in a file is an error
//! that names its line. Expressions are those of the claim language.

use super::{Certificate, Rule, Step, Term, VERSION};
use crate::claim::diagnostic::Diagnostic;
use crate::claim::parse::{parse_expr, parse_prop};
use crate::claim::print;
use crate::claim::syntax::{Expr, Name, Prop};
use sha2::{Digest, Sha256};

/// The longest certificate, in bytes.
pub const FILE_LIMIT: usize = 4 << 20;
/// The longest line, in bytes.
pub const LINE_LIMIT: usize = 1 << 18;

/// What is wrong with a certificate's text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Malformed {
    /// The line, from 1.
    pub line: usize,
    /// What is wrong.
    pub message: String,
    /// Whether it is a limit of this program, and the certificate may be right.
    pub limit: bool,
}

/// What is wrong with a line.
struct Fault {
    message: String,
    limit: bool,
}

impl From<&str> for Fault {
    fn from(message: &str) -> Fault {
        Fault { message: message.to_string(), limit: false }
    }
}

impl From<String> for Fault {
    fn from(message: String) -> Fault {
        message.as_str().into()
    }
}

/// The digest of a statement's text, in hexadecimal digits.
pub fn digest(statement: &str) -> String {
    Sha256::digest(statement.as_bytes()).iter().map(|byte| format!("{byte:02x}")).collect()
}

/// The digest of the statement that a certificate's text says it shows, from its first lines.
pub fn statement_of(source: &str) -> Option<&str> {
    let mut lines = source.lines();
    lines.next()?.strip_prefix("carom-certificate ")?;
    lines.next()?.strip_prefix("claim ")?;
    lines.next()?.strip_prefix("statement sha256 ")
}

/// The certificate as text.
pub fn write(certificate: &Certificate) -> String {
    let mut out = format!(
        "carom-certificate {VERSION}\nclaim {}\nstatement sha256 {}\n",
        certificate.claim, certificate.statement
    );
    let mut depth = 0usize;
    for step in &certificate.steps {
        if step.rule == Rule::End {
            depth = depth.saturating_sub(1);
        }
        let indent = " ".repeat(depth * 2);
        let mut line = indent.clone();
        if !step.label.is_empty() {
            line += &format!("{} ", step.label);
        }
        line += step.rule.name();
        if !step.from.is_empty() {
            line += &format!(" from {}", step.from.join(" "));
        }
        if let Some(prop) = &step.prop {
            line += &format!(": {}", print::prop(prop));
        }
        out += &format!("{line}\n");
        for (name, value) in &step.with {
            out += &format!("{indent}    | with {} = {}\n", name.text, print::expr(value));
        }
        if let Some(times) = &step.times {
            out += &format!("{indent}    | times {}\n", print::expr(times));
        }
        for term in &step.terms {
            let facts: String = term.facts.iter().map(|f| format!(" {f}")).collect();
            out += &format!("{indent}    | term{facts}: {}\n", print::expr(&term.factor));
        }
        if matches!(step.rule, Rule::Suppose | Rule::Let) {
            depth += 1;
        }
    }
    out + "qed\n"
}

/// The certificate in a text.
///
/// # Errors
/// The first line that is not of the format.
pub fn read(source: &str) -> Result<Certificate, Malformed> {
    let at = |line: usize, fault: Fault| Malformed { line, message: fault.message, limit: fault.limit };
    let fault = |line: usize, message: &str| at(line, message.into());
    let too_long = |line: usize, what: &str| Malformed { line, message: format!("limit reached: {what}"), limit: true };
    if source.len() > FILE_LIMIT {
        return Err(too_long(1, "a certificate has at most 4 MiB"));
    }
    let mut lines = source.lines().enumerate().map(|(place, text)| (place + 1, text));
    let mut header = |prefix: &str| match lines.next() {
        Some((place, text)) => {
            text.strip_prefix(prefix).map(str::to_string).ok_or_else(|| fault(place, &format!("expected `{prefix}…`")))
        }
        None => Err(fault(1, &format!("the text ends where `{prefix}…` is expected"))),
    };
    let version = header("carom-certificate ")?;
    if version != VERSION.to_string() {
        return Err(fault(1, &format!("this program reads version {VERSION} of the format")));
    }
    let claim = header("claim ")?;
    let statement = header("statement sha256 ")?;
    if statement.len() != 64 || !statement.bytes().all(|b| b.is_ascii_digit() || (b'a'..=b'f').contains(&b)) {
        return Err(fault(3, "a digest has 64 hexadecimal digits"));
    }
    let mut steps: Vec<Step> = Vec::new();
    let mut closed = false;
    for (place, text) in lines {
        if closed {
            return Err(fault(place, "nothing may follow `qed`"));
        }
        if text.len() > LINE_LIMIT {
            return Err(too_long(place, "a line has at most 256 KiB"));
        }
        let text = text.trim_start_matches(' ');
        if text == "qed" {
            closed = true;
        } else if let Some(hint) = text.strip_prefix("| ") {
            let Some(step) = steps.last_mut() else { return Err(fault(place, "a hint before the first step")) };
            read_hint(step, hint).map_err(|fault| at(place, fault))?;
        } else {
            steps.push(read_step(text).map_err(|fault| at(place, fault))?);
        }
    }
    if !closed {
        return Err(fault(source.lines().count(), "the text ends without `qed`"));
    }
    Ok(Certificate { claim, statement, steps })
}

fn read_step(text: &str) -> Result<Step, Fault> {
    let (head, prop) = match text.split_once(": ") {
        Some((head, prop)) => (head, Some(read_prop(prop)?)),
        None => (text, None),
    };
    let mut words = head.split(' ');
    let first = words.next().unwrap_or_default();
    let (label, rule) = if first == Rule::End.name() { ("", first) } else { (first, words.next().unwrap_or_default()) };
    let Some(rule) = Rule::ALL.iter().find(|r| r.name() == rule) else {
        return Err(format!("there is no rule called `{rule}`").into());
    };
    if !label.bytes().all(|b| b.is_ascii_alphanumeric()) || (label.is_empty() && *rule != Rule::End) {
        return Err("a label holds letters and digits".into());
    }
    let mut from = Vec::new();
    match words.next() {
        None => {}
        Some("from") => from.extend(words.map(str::to_string)),
        Some(other) => return Err(format!("expected `from` or `:` and found `{other}`").into()),
    }
    Ok(Step { label: label.to_string(), rule: *rule, from, prop, with: Vec::new(), times: None, terms: Vec::new() })
}

fn read_hint(step: &mut Step, hint: &str) -> Result<(), Fault> {
    if let Some(rest) = hint.strip_prefix("with ") {
        let (name, value) = rest.split_once(" = ").ok_or("expected `with NAME = EXPRESSION`")?;
        if name.is_empty() || !name.bytes().all(|b| b.is_ascii_alphanumeric() || b"_'".contains(&b)) {
            return Err("a name holds letters, digits, `_` and `'`".into());
        }
        step.with.push((Name { text: name.to_string(), span: Default::default() }, read_expr(value)?));
    } else if let Some(rest) = hint.strip_prefix("times ") {
        if step.times.is_some() {
            return Err("a step has one multiplier".into());
        }
        step.times = Some(read_expr(rest)?);
    } else if let Some(rest) = hint.strip_prefix("term") {
        let (facts, factor) = rest.split_once(": ").ok_or("expected `term FACT…: EXPRESSION`")?;
        let facts = facts.split(' ').filter(|f| !f.is_empty()).map(str::to_string).collect();
        step.terms.push(Term { facts, factor: read_expr(factor)? });
    } else {
        return Err("a hint begins with `with`, `times` or `term`".into());
    }
    Ok(())
}

fn read_prop(text: &str) -> Result<Prop, Fault> {
    parse_prop(text).map_err(|faults| first(&faults, "not a proposition"))
}

fn read_expr(text: &str) -> Result<Expr, Fault> {
    parse_expr(text).map_err(|faults| first(&faults, "not an expression"))
}

fn first(faults: &[Diagnostic], otherwise: &str) -> Fault {
    faults.first().map_or(otherwise.into(), |f| Fault { message: f.message(), limit: f.is_limit() })
}
