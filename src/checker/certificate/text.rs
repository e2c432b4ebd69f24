//! The text of certificates: one step to a line, its fields on indented lines below.
//!
//! Contract: what is written reads back to the same certificate; anything else in a file is an error that names its
//! line. A field that a rule does not read is such an error.

use super::{Certificate, Label, Refutes, Rule, Show, Step, Term, VERSION};
use crate::claim::diagnostic::Diagnostic;
use crate::claim::parse::{parse_expr, parse_prop};
use crate::claim::print;
use crate::claim::syntax::{Expr, Name, Prop};
use sha2::{Digest, Sha256};

/// The longest certificate, in bytes.
pub const FILE_LIMIT: usize = 8 << 20;
/// The longest line, in bytes.
pub const LINE_LIMIT: usize = 1 << 18;

/// What is wrong with a certificate's text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Malformed {
    /// The line, from 1.
    pub line: usize,
    /// What is wrong with it.
    pub fault: Fault,
}

/// What is wrong with a line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Fault {
    /// The file is longer than [`FILE_LIMIT`].
    FileLimit,
    /// The line is longer than [`LINE_LIMIT`].
    LineLimit,
    /// Another version of the format.
    Version(String),
    /// Something else was expected here.
    Expected(&'static str),
    /// A rule that does not exist.
    UnknownRule(String),
    /// A first line that does not say that this is a certificate.
    NotCertificate,
    /// A field that the rule does not read, or that is given twice.
    Field(&'static str),
    /// A field that the rule needs.
    Missing(&'static str),
    /// An expression or proposition that cannot be read, with the reader's words.
    Unreadable(String),
    /// An expression or proposition beyond a limit of the reader.
    ReaderLimit(String),
}

impl Fault {
    /// Whether it is a limit of this program, so that the certificate may be right.
    pub fn is_limit(&self) -> bool {
        matches!(self, Fault::FileLimit | Fault::LineLimit | Fault::ReaderLimit(_))
    }
}

impl std::fmt::Display for Fault {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Fault::FileLimit => write!(f, "limit reached: a certificate has at most {FILE_LIMIT} bytes"),
            Fault::LineLimit => write!(f, "limit reached: a line has at most {LINE_LIMIT} bytes"),
            Fault::Version(version) => write!(
                f,
                "this certificate has format {version}, but this program reads format {VERSION}; make it again with \
                 `carom audit --certificates DIR`"
            ),
            Fault::NotCertificate => {
                write!(f, "this is not a certificate: its first line must be `carom-certificate {VERSION}`")
            }
            Fault::Expected(what) => write!(f, "expected {what}"),
            Fault::UnknownRule(rule) => write!(f, "there is no rule called `{rule}`"),
            Fault::Field(field) => write!(f, "the field `{field}` does not belong to this rule, or is given twice"),
            Fault::Missing(field) => write!(f, "this rule needs the field `{field}`"),
            Fault::Unreadable(message) | Fault::ReaderLimit(message) => write!(f, "{message}"),
        }
    }
}

/// The digest of a statement's text, in hexadecimal digits.
pub fn digest(statement: &str) -> String {
    Sha256::digest(statement.as_bytes()).iter().map(|byte| format!("{byte:02x}")).collect()
}

/// The format that a certificate's text says it has, from its first line.
pub fn version_of(source: &str) -> Option<&str> {
    let version = source.lines().next()?.strip_prefix("carom-certificate ")?;
    Some(version.get(..20).unwrap_or(version))
}

/// The digest of the statement that a certificate's text says it shows, from its first lines.
pub fn statement_of(source: &str) -> Option<&str> {
    version_of(source)?;
    let mut lines = source.lines().skip(1);
    lines.next()?.strip_prefix("claim ")?;
    lines.next()?.strip_prefix("statement sha256 ")
}

/// The claim that a certificate's text says it refutes, from its first lines.
pub fn refuted_by(source: &str) -> Option<&str> {
    statement_of(source)?;
    let mut lines = source.lines().skip(1);
    let claim = lines.next()?.strip_prefix("claim ")?;
    (lines.nth(1)? == "refutes").then_some(claim)
}

/// The certificate as text.
pub fn write(certificate: &Certificate) -> String {
    let mut out = format!(
        "carom-certificate {VERSION}\nclaim {}\nstatement sha256 {}\n",
        certificate.claim, certificate.statement
    );
    if let Some(refutes) = &certificate.refutes {
        out += "refutes\n";
        for (place, value) in &refutes.point {
            out += &format!("at {} = {}\n", print::expr(place), print::expr(value));
        }
        refutes.undefined.iter().for_each(|e| out += &format!("undefined {}\n", print::expr(e)));
    }
    let mut depth = 0usize;
    for step in &certificate.steps {
        let show = match step {
            Step::Show(show) => show,
            Step::End(conclusion) => {
                depth = depth.saturating_sub(1);
                out += &format!("{}end {conclusion}\n", " ".repeat(depth * 2));
                continue;
            }
        };
        let indent = " ".repeat(depth * 2);
        out +=
            &format!("{indent}{} {}{}: {}\n", show.label, show.rule.name(), from(&show.rule), print::prop(&show.prop));
        let mut field = |text: String| out += &format!("{indent}    | {text}\n");
        for (name, value) in show.rule.values() {
            field(format!("with {} = {}", name.text, print::expr(value)));
        }
        if let Rule::Combination { times, terms } = &show.rule {
            times.iter().for_each(|e| field(format!("times {}", print::expr(e))));
            for term in terms {
                let facts: String = term.facts.iter().map(|f| format!(" {f}")).collect();
                field(format!("term{facts}: {}", print::expr(&term.factor)));
            }
        }
        for (name, labels) in [("by", &show.by), ("using", &show.using)] {
            if !labels.is_empty() {
                field(format!("{name} {}", labels.join(" ")));
            }
        }
        if show.opens() {
            depth += 1;
        }
    }
    out + "qed\n"
}

/// The cited facts behind the name of a rule.
fn from(rule: &Rule) -> String {
    let list: Vec<&str> = rule.from().into_iter().map(String::as_str).collect();
    if list.is_empty() { String::new() } else { format!(" from {}", list.join(" ")) }
}

/// The fields of a step as they are read, before it is known which of them its rule has.
struct Draft {
    line: usize,
    label: Label,
    rule: String,
    prop: Prop,
    from: Vec<Label>,
    by: Vec<Label>,
    using: Vec<Label>,
    with: Vec<(Name, Expr)>,
    times: Option<Expr>,
    terms: Vec<Term>,
}

/// The certificate in a text.
///
/// # Errors
/// The first line that is not of the format.
pub fn read(source: &str) -> Result<Certificate, Malformed> {
    let at = |line: usize, fault: Fault| Malformed { line, fault };
    if source.len() > FILE_LIMIT {
        return Err(at(1, Fault::FileLimit));
    }
    let mut lines = source.lines().enumerate().map(|(place, text)| (place + 1, text));
    let mut header = |prefix: &'static str| match lines.next() {
        Some((place, text)) => {
            text.strip_prefix(prefix).map(str::to_string).ok_or_else(|| at(place, Fault::Expected(prefix)))
        }
        None => Err(at(1, Fault::Expected(prefix))),
    };
    let version = header("carom-certificate ").map_err(|_| at(1, Fault::NotCertificate))?;
    if version != VERSION.to_string() {
        return Err(at(1, Fault::Version(version.chars().take(20).collect())));
    }
    let claim = header("claim ")?;
    let statement = header("statement sha256 ")?;
    if statement.len() != 64 || !statement.bytes().all(|b| b.is_ascii_digit() || (b'a'..=b'f').contains(&b)) {
        return Err(at(3, Fault::Expected("64 hexadecimal digits")));
    }
    let (mut refutes, mut steps): (Option<Refutes>, Vec<Step>) = (None, Vec::new());
    let mut open: Option<Draft> = None;
    let mut closed = false;
    for (place, text) in lines {
        if closed {
            return Err(at(place, Fault::Expected("nothing after `qed`")));
        }
        if text.len() > LINE_LIMIT {
            return Err(at(place, Fault::LineLimit));
        }
        let text = text.trim_start_matches(' ');
        if let Some(field) = text.strip_prefix("| ") {
            let Some(draft) = open.as_mut() else { return Err(at(place, Fault::Expected("a step before its fields"))) };
            read_field(draft, field).map_err(|fault| at(place, fault))?;
            continue;
        }
        if let Some(draft) = open.take() {
            let line = draft.line;
            steps.push(Step::Show(Box::new(finished(draft).map_err(|fault| at(line, fault))?)));
        }
        // The refuted statement comes before the first step.
        if steps.is_empty() && open.is_none() && !text.contains(": ") {
            let read = |text| read_expr(text).map_err(|fault| at(place, fault));
            match (&mut refutes, text.strip_prefix("at "), text.strip_prefix("undefined ")) {
                (None, ..) if text == "refutes" => {
                    refutes = Some(Refutes::default());
                    continue;
                }
                (Some(Refutes { point, undefined: None }), Some(rest), _) => {
                    let (of, value) =
                        rest.split_once(" = ").ok_or(at(place, Fault::Expected("`at PLACE = NUMBER`")))?;
                    point.push((read(of)?, read(value)?));
                    continue;
                }
                (Some(Refutes { undefined: undefined @ None, .. }), _, Some(rest)) => {
                    *undefined = Some(read(rest)?);
                    continue;
                }
                _ => {}
            }
        }
        if text == "qed" {
            closed = true;
        } else if let Some(conclusion) = text.strip_prefix("end ") {
            steps.push(Step::End(label(conclusion).map_err(|fault| at(place, fault))?));
        } else {
            open = Some(read_step(place, text).map_err(|fault| at(place, fault))?);
        }
    }
    if closed {
        Ok(Certificate { claim, statement, refutes, steps })
    } else {
        Err(at(source.lines().count().max(1), Fault::Expected("`qed` at the end")))
    }
}

fn label(text: &str) -> Result<Label, Fault> {
    if text.is_empty() || !text.bytes().all(|b| b.is_ascii_alphanumeric()) {
        return Err(Fault::Expected("a label of letters and digits"));
    }
    Ok(text.to_string())
}

fn labels(text: &str) -> Result<Vec<Label>, Fault> {
    text.split(' ').map(label).collect()
}

fn read_step(line: usize, text: &str) -> Result<Draft, Fault> {
    let (head, prop) = text.split_once(": ").ok_or(Fault::Expected("`LABEL RULE: PROPOSITION`"))?;
    let mut words = head.split(' ');
    let name = label(words.next().unwrap_or_default())?;
    let rule = words.next().unwrap_or_default().to_string();
    let from = match words.next() {
        None => Vec::new(),
        // The name of a claim may hold `-`; it is looked up, never taken apart.
        Some("from") => words.map(str::to_string).collect(),
        Some(_) => return Err(Fault::Expected("`from` or `:` behind the rule")),
    };
    let prop = parse_prop(prop).map_err(|faults| unreadable(&faults))?;
    Ok(Draft {
        line,
        label: name,
        rule,
        prop,
        from,
        by: Vec::new(),
        using: Vec::new(),
        with: Vec::new(),
        times: None,
        terms: Vec::new(),
    })
}

fn read_field(draft: &mut Draft, field: &str) -> Result<(), Fault> {
    let (name, rest) =
        field.split_once([' ', ':']).ok_or(Fault::Expected("`by`, `using`, `with`, `times` or `term`"))?;
    match name {
        "by" if draft.by.is_empty() => draft.by = labels(rest)?,
        "by" => return Err(Fault::Field("by")),
        "using" if draft.using.is_empty() => draft.using = labels(rest)?,
        "using" => return Err(Fault::Field("using")),
        "with" => {
            let (name, value) = rest.split_once(" = ").ok_or(Fault::Expected("`with NAME = EXPRESSION`"))?;
            if name.is_empty() || !name.bytes().all(|b| b.is_ascii_alphanumeric() || b"_'".contains(&b)) {
                return Err(Fault::Expected("a name of letters, digits, `_` and `'`"));
            }
            draft.with.push((Name::new(name), read_expr(value)?));
        }
        "times" if draft.times.is_none() => draft.times = Some(read_expr(rest)?),
        "times" => return Err(Fault::Field("times")),
        "term" => {
            let text = field.strip_prefix("term").unwrap_or_default();
            let (facts, factor) = text.split_once(": ").ok_or(Fault::Expected("`term FACT …: EXPRESSION`"))?;
            let facts = facts.split(' ').filter(|f| !f.is_empty()).map(label).collect::<Result<_, _>>()?;
            draft.terms.push(Term { facts, factor: read_expr(factor)? });
        }
        _ => return Err(Fault::Expected("`by`, `using`, `with`, `times` or `term`")),
    }
    Ok(())
}

/// The step with the fields of its rule; a field that is not one of it is an error.
fn finished(draft: Draft) -> Result<Show, Fault> {
    let Draft { label, rule, prop, from, by, using, with, times, terms, .. } = draft;
    let has_with = matches!(
        rule.as_str(),
        "instance" | "witness" | "mean" | "tangent" | "circle" | "slope" | "intermediate" | "limit"
    );
    let has_from = matches!(
        rule.as_str(),
        "logic"
            | "instance"
            | "induction"
            | "existence"
            | "witness"
            | "extremum"
            | "monotone"
            | "termwise"
            | "slope"
            | "intermediate"
            | "squeeze"
            | "along"
            | "eventually"
            | "integer"
    );
    let combination = rule == "combination";
    for (field, present) in [
        ("with", !has_with && !with.is_empty()),
        ("from", !has_from && !from.is_empty()),
        ("times", !combination && times.is_some()),
        ("term", !combination && !terms.is_empty()),
    ] {
        if present {
            return Err(Fault::Field(field));
        }
    }
    let mut given = from.into_iter();
    let one = |given: &mut std::vec::IntoIter<Label>| given.next().ok_or(Fault::Missing("from"));
    let rule = match rule.as_str() {
        "suppose" => Rule::Suppose,
        "let" => Rule::Let,
        "logic" => Rule::Logic { from: given.by_ref().collect() },
        "instance" => Rule::Instance { source: one(&mut given)?, with, from: given.by_ref().collect() },
        "induction" => Rule::Induction { base: one(&mut given)?, advance: one(&mut given)? },
        "existence" => Rule::Existence { some: one(&mut given)?, all: one(&mut given)? },
        "witness" => Rule::Witness { with, from: given.by_ref().collect() },
        "extremum" => Rule::Extremum { from: given.by_ref().collect() },
        "combination" => Rule::Combination { times, terms },
        "name" => Rule::Name,
        "evaluate" => Rule::Evaluate,
        "power" => Rule::Power,
        "monotone" => Rule::Monotone { from: one(&mut given)? },
        "unfold" => Rule::Unfold,
        "termwise" => Rule::Termwise { from: one(&mut given)? },
        "mean" => Rule::Mean { with },
        "tangent" => Rule::Tangent { with },
        "circle" => Rule::Circle { with },
        "arc" => Rule::Arc,
        "slope" => Rule::Slope { source: one(&mut given)?, with, from: given.by_ref().collect() },
        "intermediate" => Rule::Intermediate { with, from: given.by_ref().collect() },
        "limit" => Rule::Limit { with },
        "squeeze" => Rule::Squeeze { from: given.by_ref().collect() },
        "along" => Rule::Along { from: one(&mut given)? },
        "eventually" => Rule::Eventually { from: one(&mut given)? },
        "integer" => Rule::Integer { from: one(&mut given)? },
        _ => return Err(Fault::UnknownRule(rule)),
    };
    if given.next().is_some() {
        return Err(Fault::Field("from"));
    }
    Ok(Show { label, rule, prop, by, using })
}

fn read_expr(text: &str) -> Result<Expr, Fault> {
    parse_expr(text).map_err(|faults| unreadable(&faults))
}

fn unreadable(faults: &[Diagnostic]) -> Fault {
    match faults.first() {
        Some(fault) if fault.is_limit() => Fault::ReaderLimit(fault.message()),
        Some(fault) => Fault::Unreadable(fault.message()),
        None => Fault::Expected("a proposition or expression"),
    }
}
