//! Statements in SMT-LIB 2, in the logic QF_NRA: polynomials over the reals without quantifiers.
//!
//! Contract: the script asserts the hypotheses and the negation of *every expression has a value, and
//! the goal holds*. It is unsatisfiable exactly if the claim holds. Square and cube roots are new
//! variables with their powers asserted; denominators are cleared, since solvers do badly with
//! quotients: a comparison is multiplied by the denominators, or by their squares where the sign is
//! not plain, and their being other than 0 is among what is asserted. What is universal in the goal
//! (a bound variable, the points that an extremum is compared with) is a new variable: its negation
//! exists.
//!
//! Refused, with the reason: natural variables, families, sequences, sums and products over an index,
//! powers but those with small natural exponents, functions beyond roots, derivatives, limits,
//! `exists` in a goal and what is universal in a hypothesis.

mod quotient;
mod term;

use super::kinds::{Kinds, bind, of_claim};
use super::positive::Positive;
use super::values::{self, Collector, Condition, Guard};
use super::{Result, Unsupported, unsupported};
use crate::claim::definedness::Need;
use crate::claim::print;
use crate::claim::syntax::*;
use crate::kernel::substitution::Substitution;
use crate::refute::expand;
use quotient::joined;
use std::collections::BTreeMap;

/// The script of a claim, with the answer that is expected.
///
/// # Errors
/// The construct that does not fit the logic, with its place.
pub fn script(claim: &Claim) -> Result<String> {
    let statement = expand::Statement::of(claim).map_err(|limit| Unsupported::limit(limit.0, claim.name.span))?;
    if !statement.sequences.is_empty() {
        return unsupported(claim.name.span, "a sequence");
    }
    let mut writer = Writer {
        kinds: of_claim(claim),
        positive: Positive::of_claim(claim),
        plain: Vec::new(),
        lines: Vec::new(),
        roots: BTreeMap::new(),
        fresh: 0,
    };
    for binding in &statement.bindings {
        let constraints = writer.declare(binding)?;
        writer.lines.extend(constraints.into_iter().map(|c| format!("(assert {c})")));
    }
    for (_, prop) in &statement.assumptions {
        let mut values = Collector::new(&writer.kinds, &writer.positive);
        values.prop(prop)?;
        let mut parts = writer.conditions(&values.found)?;
        parts.push(writer.prop(prop, false)?);
        writer.lines.extend(parts.into_iter().map(|part| format!("(assert {part})")));
    }
    let goal = writer.prop(&statement.goal, true)?;
    let needs = values::of_statement(&statement, &writer.kinds, &writer.positive)?;
    let mut parts = writer.conditions(&needs)?;
    parts.push(goal);
    let answer = if claim.expect == Expectation::Refuted { "sat" } else { "unsat" };
    let mut out =
        format!("; {} {}\n; {}\n", claim.name.text, claim.title, print::prop(claim.written_goal()).replace('\n', " "));
    out.push_str(&format!("(set-logic QF_NRA)\n(set-info :status {answer})\n"));
    for line in &writer.lines {
        out.push_str(line);
        out.push('\n');
    }
    out.push_str(&format!("(assert (not {}))\n(check-sat)\n", joined("and", parts)));
    Ok(out)
}

struct Writer {
    kinds: Kinds,
    positive: Positive,
    /// Denominators that are positive by their form.
    plain: Vec<String>,
    lines: Vec<String>,
    /// The variable of each root: by degree and text of what stands under it.
    roots: BTreeMap<(u32, String, String), String>,
    fresh: usize,
}

impl Writer {
    fn symbol(name: &str) -> String {
        format!("|{name}|")
    }

    /// Declares a binding's names; its constraints.
    fn declare(&mut self, binding: &Binding) -> Result<Vec<String>> {
        if binding.natural {
            return unsupported(binding.span, "a natural variable");
        }
        let mut out = Vec::new();
        for (name, index) in &binding.names {
            if index.is_some() {
                return unsupported(name.span, "a family");
            }
            let line = format!("(declare-const {} Real)", Self::symbol(&name.text));
            if self.lines.contains(&line) {
                return unsupported(name.span, "two bound variables of one name");
            }
            self.lines.push(line);
            let subject = Expr { kind: ExprKind::Name(name.text.clone()), span: name.span };
            out.extend(self.domain(&subject, binding)?);
        }
        Ok(out)
    }

    fn domain(&mut self, subject: &Expr, binding: &Binding) -> Result<Vec<String>> {
        let mut out = Vec::new();
        for constraint in &binding.constraints {
            match constraint {
                Constraint::Relation(relation, e) => out.push(self.compare(subject, *relation, e)?),
                Constraint::Interval { from, from_closed, to, to_closed } => {
                    let low = if *from_closed { Relation::LessEqual } else { Relation::Less };
                    let high = if *to_closed { Relation::LessEqual } else { Relation::Less };
                    out.push(self.compare(from, low, subject)?);
                    out.push(self.compare(subject, high, to)?);
                }
                Constraint::Range(..) => return unsupported(binding.span, "a natural variable"),
            }
        }
        Ok(out)
    }

    /// Conditions as formulas; bound variables are those that the goal has introduced.
    fn conditions(&mut self, found: &[Condition]) -> Result<Vec<String>> {
        let mut out: Vec<String> = Vec::new();
        for condition in found {
            let mut guards = Vec::new();
            for guard in &condition.guards {
                let Guard::Bindings(bindings) = guard else {
                    return unsupported(Span::default(), "a sum or product over an index");
                };
                for binding in bindings {
                    for (name, _) in &binding.names {
                        let subject = Expr { kind: ExprKind::Name(name.text.clone()), span: name.span };
                        guards.extend(self.domain(&subject, binding)?);
                    }
                }
            }
            let zero = Expr { kind: ExprKind::Number("0".to_string()), span: Span::default() };
            let (e, relation) = match &condition.need {
                Need::NotZero(e) => (e, Relation::NotEqual),
                Need::Positive(e) => (e, Relation::Greater),
                Need::NotNegative(e) => (e, Relation::GreaterEqual),
                Need::NotZeroOrNatural(e, _) => return unsupported(e.span, "a power whose exponent is no numeral"),
                Need::Range(e, _) => return unsupported(e.span, "a sum or product over an index"),
                Need::Differentiable(e, ..) => return unsupported(e.span, "a derivative"),
            };
            if guards.is_empty() && self.positive.holds(e, &self.kinds) {
                continue;
            }
            let text = self.compare(e, relation, &zero)?;
            let text = if guards.is_empty() { text } else { format!("(=> {} {text})", joined("and", guards)) };
            if !out.contains(&text) {
                out.push(text);
            }
        }
        Ok(out)
    }

    /// A formula; `free` says that a universal quantifier here may become a new variable.
    fn prop(&mut self, prop: &Prop, free: bool) -> Result<String> {
        let each = |w: &mut Writer, list: &[Prop], free: bool| -> Result<Vec<String>> {
            list.iter().map(|p| w.prop(p, free)).collect()
        };
        Ok(match &prop.kind {
            PropKind::Compare(sides, relations) => {
                let mut parts = Vec::new();
                for (pair, relation) in sides.windows(2).zip(relations) {
                    if let [a, b] = pair {
                        parts.push(self.compare(a, *relation, b)?);
                    }
                }
                joined("and", parts)
            }
            PropKind::And(list) => joined("and", each(self, list, free)?),
            PropKind::Or(list) => joined("or", each(self, list, free)?),
            PropKind::Not(p) => format!("(not {})", self.prop(p, false)?),
            PropKind::Implies(p, q) => format!("(=> {} {})", self.prop(p, false)?, self.prop(q, free)?),
            PropKind::Equivalent(list) => format!("(= {})", each(self, list, false)?.join(" ")),
            PropKind::Exists(..) => return unsupported(prop.span, "exists"),
            PropKind::ForAll(bindings, body) => {
                if !free {
                    return unsupported(prop.span, "for all, but as the goal");
                }
                bind(bindings, &mut self.kinds);
                let mut domain = Vec::new();
                for binding in bindings {
                    domain.extend(self.declare(binding)?);
                }
                self.positive.declare(bindings);
                let body = self.prop(body, true)?;
                if domain.is_empty() { body } else { format!("(=> {} {body})", joined("and", domain)) }
            }
            PropKind::Extremum(extremum) => {
                if !free {
                    return unsupported(prop.span, "an extremum, but as the goal");
                }
                self.extremum(extremum)?
            }
            PropKind::Limit(_) | PropKind::WrittenLimit(_) => return unsupported(prop.span, "a limit"),
        })
    }

    fn extremum(&mut self, extremum: &Extremum) -> Result<String> {
        bind(&extremum.over, &mut self.kinds);
        let mut domain = Vec::new();
        for binding in &extremum.over {
            domain.extend(self.declare(binding)?);
        }
        let mut at = Substitution::default();
        let mut parts = Vec::new();
        let mut same = Vec::new();
        for (name, value) in &extremum.at {
            at.replace(&name.text, value);
            let subject = Expr { kind: ExprKind::Name(name.text.clone()), span: name.span };
            same.push(self.compare(&subject, Relation::Equal, value)?);
            for binding in extremum.over.iter().filter(|b| b.names.iter().any(|n| n.0.text == name.text)) {
                parts.extend(self.domain(value, binding)?);
            }
        }
        let there = at.expr(&extremum.of).map_err(|obstacle| Unsupported::not_put_in(obstacle, extremum.of.span))?;
        parts.push(self.compare(&there, Relation::Equal, &extremum.value)?);
        // In the domain the bound variables have the signs that it gives them.
        self.positive.declare(&extremum.over);
        let relation = if extremum.maximum { Relation::LessEqual } else { Relation::GreaterEqual };
        let mut all = vec![self.compare(&extremum.of, relation, &extremum.value)?];
        if extremum.unique {
            let equal = self.compare(&extremum.of, Relation::Equal, &extremum.value)?;
            all.push(format!("(=> {equal} {})", joined("and", same)));
        }
        let all = joined("and", all);
        parts.push(if domain.is_empty() { all } else { format!("(=> {} {all})", joined("and", domain)) });
        Ok(joined("and", parts))
    }
}
