//! Refutations: what has to be shown so that a claim is false at a point, or has no value there.
//!
//! Contract: if the claim that [`of`] returns is shown, the one that it is made from is false. Nothing is decided here:
//! the kernel checks a certificate of the claim that is returned.

use super::analysis::at_the_point;
use super::names::names_in_prop;
use super::order::Signs;
use super::statement::{Sequence, Statement, compare, constraints, declares, domain, numeral, prop, sum};
use super::substitution::Substitution;
use super::tree::parts;
use super::{Reason, Refusal, rejected, well_formed};
use crate::certificate::Refutes;
use crate::claim::definedness::{Need, needs};
use crate::claim::syntax::*;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use std::collections::{BTreeSet, HashSet};

/// A claim as it is looked at where it is said to fail.
struct Parts {
    bindings: Vec<Binding>,
    /// What has to hold at the point.
    holds: Vec<Prop>,
    /// What has to fail there.
    fails: Prop,
}

/// The claim that another one fails at a point: the variables have the values of the point, their domains and all
/// hypotheses hold there, and the goal is false or has no value.
///
/// Sound: the returned claim supposes nothing but that variables have the values given, and that families have the members given
/// and all others in their domain, which holds a number. A variable has at most one value, which is of its kind: a number, or an
/// expression that `is_real`, where `pi` is the number if no name of the point's claim hides it. So there are values
/// that satisfy what it supposes. For these the domains and hypotheses of the claim are shown to hold, and its goal is
/// shown to be false. A goal `for all x …` fails if it fails for one x of the domain, and an extremum if its value, its
/// bound or its uniqueness fails, which is what it says by definition. A variable that grows in a limit is no place of the
/// point: beyond all bounds its domain, which is at most a lower bound, holds.
///
/// Where the certificate names an expression without value, `Parts::without_value` says why that is enough.
///
/// # Errors
/// The claim makes no sense to the kernel, or the point is none of it.
pub fn of(claim: &Claim, refutes: &Refutes) -> Result<Claim, Refusal> {
    well_formed::claim(claim)?;
    well_formed::refutes(refutes)?;
    let statement = Statement::of(claim)?;
    let point = &refutes.point;
    let mut parts = Parts { bindings: statement.bindings, holds: Vec::new(), fails: statement.goal };
    parts.peel()?;
    if let Some(e) = &refutes.undefined {
        parts.without_value(e, &statement.sequences)?;
    }
    let families: Vec<Binding> = parts.bindings.iter().filter_map(|b| only(b, true)).collect();
    let plain: Vec<Binding> = parts.bindings.iter().filter_map(|b| only(b, false)).collect();
    let is_pi = !declares(&parts.bindings, &statement.sequences, PI);
    let mut moving = BTreeSet::new();
    limit_variables(&parts.fails, &mut moving);
    let mut holds: Vec<Prop> = plain.iter().flat_map(domain).collect();
    let mut equations = Vec::new();
    let mut given = HashSet::new();
    for (place, value) in point {
        let natural = is_natural_place(place, value, &plain, &families, point)?;
        let plain = matches!(place.kind, ExprKind::Name(_));
        let is_number = match natural {
            true => is_natural(value),
            false => rational(value).is_some() || (plain && is_real(value, is_pi)),
        };
        if !is_number || !given.insert(place.clone()) {
            return Err(no_place(place));
        }
        equations.push(compare(place.clone(), Relation::Equal, value.clone()));
    }
    // The other members may be what one that is given is: the same bounds, which are numbers, hold for all of them.
    for family in families.iter().filter(|f| !f.constraints.is_empty()) {
        for (text, _) in &family.names {
            let is_member = |place: &Expr| matches!(&place.kind, ExprKind::Apply(f, _) if f == text);
            if !point.iter().any(|(place, _)| is_member(place)) {
                return rejected(Reason::PointFamily(text.text.clone()));
            }
        }
    }
    holds.extend(statement.assumptions);
    let holds = holds.into_iter().map(|p| says_how_it_grows(&p, &moving).map(|grows| (p, grows)));
    let mut holds: Vec<Prop> =
        holds.collect::<Result<Vec<_>, _>>()?.into_iter().filter(|h| !h.1).map(|h| h.0).collect();
    holds.extend(parts.holds);
    holds.push(denied(parts.fails));
    let free = plain.into_iter().map(|b| Binding { constraints: Vec::new(), ..b });
    let sequences = statement.sequences.into_iter().map(|u| Item::Define {
        name: Name::new(&u.name),
        initial: u.initial,
        index: Name::new(&u.index),
        step: u.step,
        span: Span::default(),
    });
    let supposed = equations.into_iter().map(|prop| Item::Assume { label: None, prop });
    let items = [Item::Given(free.chain(families).collect())].into_iter().chain(sequences).chain(supposed);
    Ok(Claim {
        items: items.collect(),
        goal: match (holds.len(), holds.pop()) {
            (1, Some(only)) => only,
            (_, last) => prop(PropKind::And(holds.into_iter().chain(last).collect())),
        },
        using: Vec::new(),
        proof: Proof::default(),
        expect: Expectation::Proved,
        ..claim.clone()
    })
}

/// Whether the variable or member at a place of the point is a natural number.
///
/// # Errors
/// The place is no variable and no member of a family, or the member may not have this value.
fn is_natural_place(
    place: &Expr,
    value: &Expr,
    plain: &[Binding],
    families: &[Binding],
    point: &[(Expr, Expr)],
) -> Result<bool, Refusal> {
    Ok(match &place.kind {
        ExprKind::Name(text) => {
            let found = plain.iter().find(|b| b.names.iter().any(|n| n.0.text == *text));
            found.ok_or_else(|| no_place(place))?.natural
        }
        ExprKind::Apply(family, arguments) => {
            let found = families.iter().find(|b| b.names.iter().any(|n| n.0 == *family));
            let (Some(found), [index]) = (found, arguments.as_slice()) else { return Err(no_place(place)) };
            if !is_natural(index) {
                return Err(no_place(place));
            }
            // What is supposed of the family is not shown of the member: it has to be so.
            if !constraints(found, value).iter().all(is_true) {
                return Err(no_place(place));
            }
            // A member outside its range would be supposed to be there.
            let inside = found.indices.as_ref().is_none_or(|(from, to)| {
                match (whole(from, point), whole(index, point), whole(to, point)) {
                    (Some(from), Some(index), Some(to)) => from <= index && index <= to,
                    _ => false,
                }
            });
            if !inside {
                return Err(no_place(place));
            }
            found.natural
        }
        _ => return Err(no_place(place)),
    })
}

impl Parts {
    /// Lets the goal fail by having no value: an expression in it needs what does not hold at the point.
    ///
    /// Sound: the whole goal has a value only if the expression has, at the values of the indices and variables bound around
    /// it, which become places of the point with their ranges and domains to be shown, as are the premises before it. And
    /// the expression has a value only if its [`Need`]s hold, and a member only if there is one of this index.
    fn without_value(&mut self, e: &Expr, sequences: &[Sequence]) -> Result<(), Refusal> {
        let mut path = Path { part: e, bindings: Vec::new(), premises: Vec::new() };
        if !path.in_prop(&self.fails) || path.bindings.iter().flat_map(|b| &b.names).any(|n| n.1.is_some()) {
            return rejected(Reason::NoPart(e.clone()));
        }
        self.bindings.extend(path.bindings);
        self.holds.extend(path.premises);
        let natural: BTreeSet<&str> =
            self.bindings.iter().filter(|b| b.natural).flat_map(|b| &b.names).map(|n| n.0.text.as_str()).collect();
        let mut needed: Vec<Prop> = Vec::new();
        let zero = || numeral(0);
        for need in needs(e, &|name| natural.contains(name))? {
            needed.push(match need {
                Need::NotZero(e) => compare(e, Relation::NotEqual, zero()),
                Need::Positive(e) => compare(e, Relation::Greater, zero()),
                Need::NotNegative(e) => compare(e, Relation::GreaterEqual, zero()),
                Need::NotZeroOrNatural(base, e) => prop(PropKind::Or(vec![
                    compare(base, Relation::NotEqual, zero()),
                    compare(e, Relation::GreaterEqual, zero()),
                ])),
                Need::Range(from, to) => {
                    compare(from, Relation::LessEqual, sum(vec![(Sign::Plus, to), (Sign::Plus, numeral(1))]))
                }
                // More than that it has a value near the point.
                Need::Differentiable(..) => continue,
            });
        }
        if let ExprKind::Apply(f, arguments) = &e.kind
            && let [index] = arguments.as_slice()
        {
            let family = self.bindings.iter().find(|b| b.names.iter().any(|n| n.1.is_some() && n.0 == *f));
            if family.is_some() || sequences.iter().any(|u| u.name == f.text) {
                needed.push(compare(index.clone(), Relation::GreaterEqual, zero()));
            }
            if let Some((from, to)) = family.and_then(|b| b.indices.clone()) {
                needed.push(compare(from, Relation::LessEqual, index.clone()));
                needed.push(compare(index.clone(), Relation::LessEqual, to));
            }
        }
        self.fails = match (needed.len(), needed.pop()) {
            (1, Some(only)) => only,
            (_, Some(last)) => prop(PropKind::And(needed.into_iter().chain([last]).collect())),
            (_, None) => return rejected(Reason::NoPart(e.clone())),
        };
        Ok(())
    }

    /// Takes quantifiers in front and extrema off the goal: their variables are places of the point as well.
    fn peel(&mut self) -> Result<(), Refusal> {
        loop {
            match self.fails.kind.clone() {
                PropKind::ForAll(bindings, body) => {
                    self.bindings.extend(bindings);
                    self.fails = *body;
                }
                PropKind::Extremum(e) => {
                    let mut there = Substitution::default();
                    e.at.iter().for_each(|(n, value)| there.replace(&n.text, value));
                    let relation = if e.maximum { Relation::LessEqual } else { Relation::GreaterEqual };
                    let mut list = vec![
                        compare(there.expr(&e.of)?, Relation::Equal, e.value.clone()),
                        compare(e.of.clone(), relation, e.value.clone()),
                    ];
                    if let (true, Some(point)) = (e.unique, at_the_point(&e)) {
                        let equal = compare(e.of.clone(), Relation::Equal, e.value.clone());
                        list.push(prop(PropKind::Implies(Box::new(equal), Box::new(point))));
                    }
                    self.bindings.extend(e.over);
                    self.fails = prop(PropKind::And(list));
                    return Ok(());
                }
                _ => return Ok(()),
            }
        }
    }
}

/// What has to hold so that the value of a whole needs that of a part.
struct Path<'a> {
    part: &'a Expr,
    /// The variables that are bound on the way.
    bindings: Vec<Binding>,
    /// The premises on the way.
    premises: Vec<Prop>,
}

impl Path<'_> {
    /// Whether the part stands in a proposition; then the way to it is noted. A goal has a value only if its parts have,
    /// but for those behind `=>`, where what stands before it is false, and those under `for all`, outside its domain.
    fn in_prop(&mut self, p: &Prop) -> bool {
        match &p.kind {
            PropKind::Compare(sides, _) => sides.iter().any(|e| self.in_expr(e)),
            PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => {
                list.iter().any(|p| self.in_prop(p))
            }
            PropKind::Not(p) => self.in_prop(p),
            PropKind::Implies(p, q) => {
                self.in_prop(p)
                    || self.within(|path| {
                        path.premises.push((**p).clone());
                        path.in_prop(q)
                    })
            }
            PropKind::ForAll(bindings, p) => self.within(|path| {
                path.bindings.extend(bindings.iter().cloned());
                path.in_prop(p)
            }),
            // A witness shows `exists` whatever other values do.
            PropKind::Exists(..) | PropKind::Extremum(_) | PropKind::Limit(_) | PropKind::WrittenLimit(_) => false,
        }
    }

    fn in_expr(&mut self, e: &Expr) -> bool {
        if e == self.part {
            return true;
        }
        match &e.kind {
            ExprKind::SumOver(index, body) | ExprKind::ProductOver(index, body) => {
                let range = Constraint::Range((*index.from).clone(), (*index.to).clone());
                self.in_expr(&index.from)
                    || self.in_expr(&index.to)
                    || self.within(|path| {
                        path.bindings.push(Binding::of(index.name.clone(), true, vec![range]));
                        path.in_expr(body)
                    })
            }
            // Which end of an integral is less is not known here, so what it binds is not looked at.
            ExprKind::IntegralOver(variable, _) => self.in_expr(&variable.from) || self.in_expr(&variable.to),
            _ => parts(e).into_iter().any(|part| self.in_expr(part)),
        }
    }

    /// Goes a way; what was noted on one that leads nowhere is forgotten.
    fn within(&mut self, go: impl FnOnce(&mut Self) -> bool) -> bool {
        let (bindings, premises) = (self.bindings.len(), self.premises.len());
        let found = go(self);
        if !found {
            self.bindings.truncate(bindings);
            self.premises.truncate(premises);
        }
        found
    }
}

/// The variables that grow in the limits of a proposition.
fn limit_variables(p: &Prop, out: &mut BTreeSet<String>) {
    match &p.kind {
        PropKind::Limit(limit) => {
            out.insert(limit.variable.text.clone());
        }
        PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => {
            list.iter().for_each(|p| limit_variables(p, out));
        }
        PropKind::Not(p) | PropKind::Exists(_, p) | PropKind::ForAll(_, p) => limit_variables(p, out),
        PropKind::Implies(p, q) => [p, q].into_iter().for_each(|p| limit_variables(p, out)),
        PropKind::Compare(..) | PropKind::Extremum(_) | PropKind::WrittenLimit(_) => {}
    }
}

/// Whether a domain or hypothesis is a lower bound by a numeral of a variable that grows. It may say nothing else of one.
fn says_how_it_grows(p: &Prop, moving: &BTreeSet<String>) -> Result<bool, Refusal> {
    let mut names = BTreeSet::new();
    names_in_prop(p, &mut names);
    let Some(variable) = names.intersection(moving).next() else { return Ok(false) };
    if let Some((left, Relation::Greater | Relation::GreaterEqual, right)) = p.single()
        && left.kind == ExprKind::Name(variable.clone())
        && matches!(right.kind, ExprKind::Number(_))
    {
        return Ok(true);
    }
    rejected(Reason::Tied(variable.clone()))
}

/// The binding with its families only, or with its plain names only.
fn only(binding: &Binding, families: bool) -> Option<Binding> {
    let names: Vec<_> = binding.names.iter().filter(|n| n.1.is_some() == families).cloned().collect();
    (!names.is_empty()).then(|| Binding { names, ..binding.clone() })
}

fn no_place(place: &Expr) -> Refusal {
    Refusal::Rejected(Reason::Point(place.clone()))
}

/// Whether an expression is a numeral of digits without leading zeros.
fn is_natural(e: &Expr) -> bool {
    matches!(&e.kind, ExprKind::Number(text)
        if text.bytes().all(|b| b.is_ascii_digit()) && (text == "0" || !text.starts_with('0')))
}

/// The whole number that a sum of numerals and of variables of the point is.
fn whole(e: &Expr, point: &[(Expr, Expr)]) -> Option<BigInt> {
    match &e.kind {
        ExprKind::Number(text) if is_natural(e) => text.parse().ok(),
        ExprKind::Name(_) => point.iter().find(|p| p.0 == *e && is_natural(&p.1)).and_then(|p| whole(&p.1, &[])),
        ExprKind::Sum(list) => list.iter().try_fold(BigInt::from(0), |sum, (sign, part)| {
            let part = whole(part, point)?;
            Some(if *sign == Sign::Plus { sum + part } else { sum - part })
        }),
        _ => None,
    }
}

/// The number that p, -p, p/q or -p/q is, with digits p and q, where q is not 0.
fn rational(e: &Expr) -> Option<BigRational> {
    let whole = |e: &Expr| whole(e, &[]).filter(|_| is_natural(e));
    match &e.kind {
        ExprKind::Negate(size) if !matches!(size.kind, ExprKind::Negate(_)) => Some(-rational(size)?),
        ExprKind::Product(factors) => match factors.as_slice() {
            [(Factor::Times, p), (Factor::Over, q)] if *q != numeral(0) => Some(BigRational::new(whole(p)?, whole(q)?)),
            _ => None,
        },
        _ => whole(e).map(BigRational::from_integer),
    }
}

/// Whether an expression has a value by its form. It is made of numbers, and of π where `pi` is that number, by sums, products and
/// exponentials. Divisors, bases of powers, and what stands under roots and logarithms [`is_positive`].
///
/// Sound: numbers and π are real numbers, and sums, products, exponentials and arctangents of real numbers are. So are quotients by positive
/// numbers and by numbers other than 0, and powers, roots and logarithms of positive numbers.
fn is_real(e: &Expr, is_pi: bool) -> bool {
    if rational(e).is_some() {
        return true;
    }
    match &e.kind {
        ExprKind::Name(name) => is_pi && name == PI,
        ExprKind::Negate(a) => is_real(a, is_pi),
        ExprKind::Sum(list) => list.iter().all(|(_, part)| is_real(part, is_pi)),
        ExprKind::Product(list) => list.iter().all(|(factor, part)| match factor {
            Factor::Times => is_real(part, is_pi),
            Factor::Over => rational(part).is_some_and(|q| !q.is_zero()) || is_positive(part, is_pi),
        }),
        ExprKind::Apply(f, list) => match (f.text.as_str(), list.as_slice()) {
            ("sqrt", [a]) => rational(a).is_some_and(|q| !q.is_negative()) || is_positive(a, is_pi),
            ("exp" | "arctan", [a]) => is_real(a, is_pi),
            ("ln", [a]) => is_positive(a, is_pi),
            _ => false,
        },
        ExprKind::Power(base, exponent) => is_positive(base, is_pi) && rational(exponent).is_some(),
        _ => false,
    }
}

/// Whether an expression is positive by its form: a positive number, π, an exponential, the logarithm of a number above 1, or a sum,
/// product, quotient, power, root or arctangent of these.
///
/// Sound: each of these is, and [`is_real`] of it.
fn is_positive(e: &Expr, is_pi: bool) -> bool {
    if let Some(q) = rational(e) {
        return q.is_positive();
    }
    match &e.kind {
        ExprKind::Name(name) => is_pi && name == PI,
        ExprKind::Sum(list) => list.iter().all(|(sign, part)| *sign == Sign::Plus && is_positive(part, is_pi)),
        ExprKind::Product(list) => list.iter().all(|(_, part)| is_positive(part, is_pi)),
        ExprKind::Apply(f, list) => match (f.text.as_str(), list.as_slice()) {
            ("sqrt" | "arctan", [a]) => is_positive(a, is_pi),
            ("exp", [a]) => is_real(a, is_pi),
            ("ln", [a]) => rational(a).is_some_and(|q| q > BigRational::one()),
            _ => false,
        },
        ExprKind::Power(base, exponent) => is_positive(base, is_pi) && rational(exponent).is_some(),
        _ => false,
    }
}

/// What is shown of a statement that fails: of `exists x …: P`, that P fails for all x.
///
/// Sound: then no x of the domain has the property.
fn denied(p: Prop) -> Prop {
    match p.kind {
        PropKind::Exists(bindings, body) if bindings.iter().all(|b| b.names.iter().all(|n| n.1.is_none())) => {
            prop(PropKind::ForAll(bindings, Box::new(prop(PropKind::Not(body)))))
        }
        _ => prop(PropKind::Not(Box::new(p))),
    }
}

/// Whether a comparison of two numbers is true.
fn is_true(p: &Prop) -> bool {
    let Some((a, relation, b)) = p.single() else { return false };
    match (rational(a), rational(b)) {
        (Some(a), Some(b)) => Signs::of_number(&(a - b)).within(Signs::of(relation)),
        _ => false,
    }
}
