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

use super::kinds::{Kinds, bind, of_claim};
use super::positive::Positive;
use super::values::{self, Collector, Condition, Guard};
use super::{Result, Unsupported, unsupported};
use crate::claim::definedness::{self, Need};
use crate::claim::print;
use crate::claim::syntax::*;
use crate::number::rational;
use crate::refute::expand;
use std::collections::BTreeMap;

/// The largest exponent that is written out as a product.
const MAX_POWER: u32 = 16;

/// A quotient: the numerator's text, and the denominator's factors with their powers.
#[derive(Clone, Debug)]
struct Quotient {
    above: String,
    below: BTreeMap<String, u32>,
}

/// A number or a matrix.
enum Value {
    Scalar(Quotient),
    Matrix(Vec<Vec<Quotient>>),
}

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
        values.prop(prop);
        let mut parts = writer.conditions(&values.found)?;
        parts.push(writer.prop(prop, false)?);
        writer.lines.extend(parts.into_iter().map(|part| format!("(assert {part})")));
    }
    let goal = writer.prop(&statement.goal, true)?;
    let needs = values::of_statement(&statement, &writer.kinds, &writer.positive);
    let mut parts = writer.conditions(&needs)?;
    parts.push(goal);
    let answer = if claim.expect == Expectation::Refuted { "sat" } else { "unsat" };
    let mut out = format!("; {} {}\n; {}\n", claim.name.text, claim.title, print::prop(&claim.goal).replace('\n', " "));
    out.push_str(&format!("(set-logic QF_NRA)\n(set-info :status {answer})\n"));
    for line in &writer.lines {
        out.push_str(line);
        out.push('\n');
    }
    out.push_str(&format!("(assert (not {}))\n(check-sat)\n", joined("and", parts)));
    Ok(out)
}

fn joined(sign: &str, mut parts: Vec<String>) -> String {
    match parts.len() {
        1 => parts.remove(0),
        _ => format!("({sign} {})", parts.join(" ")),
    }
}

fn times(factors: Vec<String>) -> String {
    let mut factors: Vec<String> = factors.into_iter().filter(|f| f != "1").collect();
    match factors.len() {
        0 => "1".to_string(),
        1 => factors.remove(0),
        _ => format!("(* {})", factors.join(" ")),
    }
}

/// A denominator written out, without what is in the other one.
fn factors(below: &BTreeMap<String, u32>, without: &BTreeMap<String, u32>) -> Vec<String> {
    let mut out = Vec::new();
    for (factor, power) in below {
        let there = without.get(factor).copied().unwrap_or(0);
        out.extend(std::iter::repeat_n(factor.clone(), power.saturating_sub(there) as usize));
    }
    out
}

impl Quotient {
    fn whole(above: impl Into<String>) -> Quotient {
        Quotient { above: above.into(), below: BTreeMap::new() }
    }

    fn by(self, other: &Quotient) -> Quotient {
        let mut below = self.below;
        for (factor, power) in &other.below {
            *below.entry(factor.clone()).or_default() += power;
        }
        Quotient { above: times(vec![self.above, other.above.clone()]), below }
    }

    fn negated(self) -> Quotient {
        Quotient { above: format!("(- {})", self.above), below: self.below }
    }

    fn total(parts: &[Quotient]) -> Quotient {
        let mut below: BTreeMap<String, u32> = BTreeMap::new();
        for part in parts {
            for (factor, power) in &part.below {
                let entry = below.entry(factor.clone()).or_default();
                *entry = (*entry).max(*power);
            }
        }
        let above: Vec<String> = parts
            .iter()
            .map(|part| {
                let mut list = vec![part.above.clone()];
                list.extend(factors(&below, &part.below));
                times(list)
            })
            .collect();
        Quotient { above: joined("+", above), below }
    }
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

    fn scalar(&mut self, e: &Expr) -> Result<Quotient> {
        match self.value(e)? {
            Value::Scalar(q) => Ok(q),
            Value::Matrix(_) => unsupported(e.span, "a matrix where a number is needed"),
        }
    }

    /// A quotient's reciprocal; the divisor's sign is noted if it is plain.
    fn inverse(&mut self, e: &Expr, q: Quotient) -> Quotient {
        let above = times(factors(&q.below, &BTreeMap::new()));
        if q.above == "1" {
            return Quotient::whole(above);
        }
        if self.positive.holds(e, &self.kinds) && !self.plain.contains(&q.above) {
            self.plain.push(q.above.clone());
        }
        Quotient { above, below: BTreeMap::from([(q.above, 1)]) }
    }

    fn value(&mut self, e: &Expr) -> Result<Value> {
        Ok(Value::Scalar(match &e.kind {
            ExprKind::Number(text) => match rational::parse(text) {
                Ok(q) => {
                    let text = q.to_string();
                    Quotient::whole(match text.split_once('/') {
                        Some((a, b)) => format!("(/ {a} {b})"),
                        None => text,
                    })
                }
                Err(fault) => return unsupported(e.span, fault.to_string()),
            },
            ExprKind::Name(name) if name == "infinity" => return unsupported(e.span, "infinity as a number"),
            ExprKind::Name(name) => Quotient::whole(Self::symbol(name)),
            ExprKind::Negate(a) => match self.value(a)? {
                Value::Scalar(q) => q.negated(),
                Value::Matrix(rows) => {
                    let negated = |row: Vec<Quotient>| row.into_iter().map(Quotient::negated).collect();
                    return Ok(Value::Matrix(rows.into_iter().map(negated).collect()));
                }
            },
            ExprKind::Sum(list) => {
                let mut parts = Vec::new();
                for (sign, summand) in list {
                    let negate = *sign == Sign::Minus;
                    parts.push(match self.value(summand)? {
                        Value::Scalar(q) => vec![vec![if negate { q.negated() } else { q }]],
                        Value::Matrix(rows) => rows
                            .into_iter()
                            .map(|r| r.into_iter().map(|q| if negate { q.negated() } else { q }).collect())
                            .collect(),
                    });
                }
                let shape = |m: &Vec<Vec<Quotient>>| (m.len(), m.first().map_or(0, Vec::len));
                let Some((rows, columns)) = parts.first().map(shape) else {
                    return unsupported(e.span, "an empty sum");
                };
                if parts.iter().any(|p| shape(p) != (rows, columns)) {
                    return unsupported(e.span, "a sum of different sizes");
                }
                let entry = |i: usize, j: usize| {
                    let list: Vec<Quotient> =
                        parts.iter().filter_map(|p| p.get(i).and_then(|r| r.get(j)).cloned()).collect();
                    Quotient::total(&list)
                };
                let total: Vec<Vec<Quotient>> =
                    (0..rows).map(|i| (0..columns).map(|j| entry(i, j)).collect()).collect();
                return Ok(unless_single(total, list.iter().all(|(_, e)| !super::kinds::is_matrix(e, &self.kinds))));
            }
            ExprKind::Product(list) => {
                let mut out = Value::Scalar(Quotient::whole("1"));
                for (operator, factor) in list {
                    let value = match (operator, self.value(factor)?) {
                        (Factor::Times, value) => value,
                        (Factor::Over, Value::Scalar(q)) => Value::Scalar(self.inverse(factor, q)),
                        (Factor::Over, Value::Matrix(_)) => return unsupported(factor.span, "division by a matrix"),
                    };
                    out = product(out, value, factor.span)?;
                }
                return Ok(out);
            }
            ExprKind::Power(base, exponent) => {
                let whole = definedness::number(exponent).filter(|q| q.1 == 1).map(|q| (q.0 < 0, q.0.unsigned_abs()));
                let small = |(negative, k)| Some((negative, u32::try_from(k).ok().filter(|k| *k <= MAX_POWER)?));
                let Some((negative, power)) = whole.and_then(small) else {
                    return unsupported(e.span, "a power whose exponent is no small whole number");
                };
                let mut q = self.scalar(base)?;
                if negative {
                    q = self.inverse(base, q);
                }
                let below = q.below.into_iter().map(|(f, p)| (f, p * power)).filter(|p| p.1 > 0).collect();
                Quotient { above: times(vec![q.above; power as usize]), below }
            }
            ExprKind::Apply(f, arguments) => match (f.text.as_str(), arguments.as_slice()) {
                ("sqrt", [a]) => self.root(2, a)?,
                ("cbrt", [a]) => self.root(3, a)?,
                ("det", [a]) => match self.value(a)? {
                    Value::Matrix(rows) => match rows.as_slice() {
                        [first, second] => match (first.as_slice(), second.as_slice()) {
                            ([a, b], [c, d]) => Quotient::total(&[a.clone().by(d), b.clone().by(c).negated()]),
                            _ => return unsupported(e.span, "a determinant beyond two rows"),
                        },
                        _ => return unsupported(e.span, "a determinant beyond two rows"),
                    },
                    Value::Scalar(_) => return unsupported(e.span, "the determinant of a number"),
                },
                _ => return unsupported(f.span, format!("{} as a function", f.text)),
            },
            ExprKind::SumOver(..) | ExprKind::ProductOver(..) => {
                return unsupported(e.span, "a sum or product over an index");
            }
            ExprKind::Derivative(..) => return unsupported(e.span, "a derivative"),
            ExprKind::Matrix(rows) => {
                let rows = rows.iter().map(|r| r.iter().map(|e| self.scalar(e)).collect()).collect::<Result<_>>()?;
                return Ok(Value::Matrix(rows));
            }
        }))
    }

    /// A new variable for a root: its power times the denominator is the numerator.
    fn root(&mut self, degree: u32, under: &Expr) -> Result<Quotient> {
        let q = self.scalar(under)?;
        let below = times(factors(&q.below, &BTreeMap::new()));
        let key = (degree, q.above.clone(), below.clone());
        if let Some(root) = self.roots.get(&key) {
            return Ok(Quotient::whole(root.clone()));
        }
        self.fresh += 1;
        let root = Self::symbol(&format!("root {}", self.fresh));
        self.lines.push(format!("(declare-const {root} Real)"));
        let sign = if self.positive.holds(under, &self.kinds) { ">" } else { ">=" };
        // Below 0 the expression has no value, which is said apart; the root is then not restricted.
        let mut power = vec![root.clone(); degree as usize];
        power.push(below);
        let equation = format!("(and ({sign} {root} 0) (= {} {}))", times(power), q.above);
        let zero = Expr { kind: ExprKind::Number("0".to_string()), span: under.span };
        let has_value = self.compare(under, Relation::GreaterEqual, &zero)?;
        self.lines.push(match sign {
            ">" => format!("(assert {equation})"),
            _ => format!("(assert (=> {has_value} {equation}))"),
        });
        self.roots.insert(key, root.clone());
        Ok(Quotient::whole(root))
    }

    fn compare(&mut self, a: &Expr, relation: Relation, b: &Expr) -> Result<String> {
        let (a, b) = match (self.value(a)?, self.value(b)?) {
            (Value::Scalar(a), Value::Scalar(b)) => (a, b),
            (Value::Matrix(a), Value::Matrix(b)) if relation == Relation::Equal => {
                let same = a.len() == b.len() && a.iter().zip(&b).all(|(a, b)| a.len() == b.len());
                if !same {
                    return unsupported(Span::default(), "an equation of different sizes");
                }
                let parts = a.iter().flatten().zip(b.iter().flatten());
                return Ok(joined("and", parts.map(|(a, b)| self.cleared(a, relation, b)).collect()));
            }
            _ => return unsupported(a.span, "a relation of matrices"),
        };
        Ok(self.cleared(&a, relation, &b))
    }

    /// The comparison, multiplied by the denominators.
    fn cleared(&self, a: &Quotient, relation: Relation, b: &Quotient) -> String {
        let (mut left, mut right) = (vec![a.above.clone()], vec![b.above.clone()]);
        let (more_left, more_right) = (factors(&b.below, &a.below), factors(&a.below, &b.below));
        if !matches!(relation, Relation::Equal | Relation::NotEqual) {
            // Whatever multiplies must be positive: what is not plainly so comes in squares.
            let mut common = a.below.clone();
            for (factor, power) in &b.below {
                let entry = common.entry(factor.clone()).or_default();
                *entry = (*entry).max(*power);
            }
            for (factor, power) in common {
                if power % 2 == 1 && !self.plain.contains(&factor) {
                    left.push(factor.clone());
                    right.push(factor);
                }
            }
        }
        left.extend(more_left);
        right.extend(more_right);
        let (left, right) = (times(left), times(right));
        match relation {
            Relation::Equal => format!("(= {left} {right})"),
            Relation::NotEqual => format!("(not (= {left} {right}))"),
            Relation::Less => format!("(< {left} {right})"),
            Relation::LessEqual => format!("(<= {left} {right})"),
            Relation::Greater => format!("(> {left} {right})"),
            Relation::GreaterEqual => format!("(>= {left} {right})"),
        }
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
            PropKind::Limit(_) => return unsupported(prop.span, "a limit"),
        })
    }

    fn extremum(&mut self, extremum: &Extremum) -> Result<String> {
        bind(&extremum.over, &mut self.kinds);
        let mut domain = Vec::new();
        for binding in &extremum.over {
            domain.extend(self.declare(binding)?);
        }
        let mut at = expand::Substitution::default();
        let mut parts = Vec::new();
        let mut same = Vec::new();
        for (name, value) in &extremum.at {
            at.replace(&name.text, value.clone());
            let subject = Expr { kind: ExprKind::Name(name.text.clone()), span: name.span };
            same.push(self.compare(&subject, Relation::Equal, value)?);
            for binding in extremum.over.iter().filter(|b| b.names.iter().any(|n| n.0.text == name.text)) {
                parts.extend(self.domain(value, binding)?);
            }
        }
        let there = at.expr(&extremum.of).map_err(|limit| Unsupported::limit(limit.0, extremum.of.span))?;
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

/// A number again, where no matrix was in the sum.
fn unless_single(mut rows: Vec<Vec<Quotient>>, number: bool) -> Value {
    match (number, rows.first().and_then(|r| r.first()).cloned()) {
        (true, Some(only)) if rows.len() == 1 => Value::Scalar(only),
        _ => Value::Matrix(std::mem::take(&mut rows)),
    }
}

fn product(a: Value, b: Value, span: Span) -> Result<Value> {
    let scaled = |rows: Vec<Vec<Quotient>>, by: &Quotient| {
        Value::Matrix(rows.into_iter().map(|r| r.into_iter().map(|q| by.clone().by(&q)).collect()).collect())
    };
    Ok(match (a, b) {
        (Value::Scalar(a), Value::Scalar(b)) => Value::Scalar(a.by(&b)),
        (Value::Scalar(a), Value::Matrix(b)) => scaled(b, &a),
        (Value::Matrix(a), Value::Scalar(b)) => scaled(a, &b),
        (Value::Matrix(a), Value::Matrix(b)) => {
            let columns = b.first().map_or(0, Vec::len);
            if a.iter().any(|row| row.len() != b.len()) {
                return unsupported(span, "a product of matrices whose sizes do not match");
            }
            let entry = |row: &Vec<Quotient>, j: usize| {
                let list: Vec<Quotient> =
                    row.iter().zip(&b).filter_map(|(x, y)| Some(x.clone().by(y.get(j)?))).collect();
                Quotient::total(&list)
            };
            Value::Matrix(a.iter().map(|row| (0..columns).map(|j| entry(row, j)).collect()).collect())
        }
    })
}
