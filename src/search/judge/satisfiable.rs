//! Hypotheses that hold somewhere, and claims that fail somewhere, where no point with rational coordinates was found.
//!
//! Contract: a point of [`point`] is returned only where the kernel accepted that such values exist, or where the hypotheses
//! define families member by member ([`by_definition`]). That of [`counterexample`] is a proposal, of which a certificate is
//! still to be made.
//!
//! Method: `exists x …: hypotheses` is a claim that the search for proofs takes, with roots as witnesses. A family that the
//! hypotheses determine from its first member becomes a sequence, of which they are shown; one that they do not determine
//! becomes a constant.

use crate::algebra::Moment;
use crate::certificate::{Certificate, Rule, Step};
use crate::claim::definedness::number;
use crate::claim::print;
use crate::claim::syntax::*;
use crate::kernel::key;
use crate::kernel::names::{names_in, names_in_prop};
use crate::kernel::statement::{Statement, apply, compare, expr, name, numeral, prop, sum};
use crate::kernel::substitution::Substitution;
use crate::prove;
use crate::refute::catalogue::Limits;
use crate::refute::edges::zeros_of_divisors;
use crate::refute::literal::{is_zero, literal};
use crate::refute::outcome::Point;
use crate::refute::sample::example;
use std::collections::BTreeSet;

/// Of how many divisors a zero is sought.
const DIVISORS: usize = 4;

/// A point at which the hypotheses of a claim hold, its coordinates perhaps roots; `None` where none was shown to exist.
pub(super) fn point(claim: &Claim, limits: &Limits) -> Option<Point> {
    let statement = Statement::of(claim).ok()?;
    if statement.bindings.iter().flat_map(|b| &b.names).any(|n| n.1.is_some()) {
        return by_recurrence(claim, &statement, limits);
    }
    let Statement { bindings, sequences, assumptions, .. } = statement;
    if assumptions.is_empty() || !sequences.is_empty() {
        return None;
    }
    if bindings.is_empty() {
        // Hypotheses that mention no variable hold everywhere or nowhere.
        let truth = compare(numeral(0), Relation::Equal, numeral(0));
        let goal = prop(PropKind::And(assumptions.into_iter().chain([truth]).collect()));
        return prove::certificate(&alone(claim, Vec::new(), goal), &[], limits)
            .ok()
            .map(|_| Point { values: Vec::new() });
    }
    exists(claim, bindings, assumptions, limits)
}

/// A point with roots as coordinates at which the hypotheses hold and the goal, a comparison, fails or has no value, as far as
/// the search for proofs tells.
pub(super) fn counterexample(claim: &Claim, limits: &Limits) -> Option<Point> {
    let Statement { bindings, sequences, assumptions, goal, .. } = Statement::of(claim).ok()?;
    let (a, relation, b) = goal.single()?;
    let plain = bindings.iter().all(|b| !b.natural && b.names.iter().all(|n| n.1.is_none()));
    if bindings.is_empty() || !sequences.is_empty() || !plain {
        return None;
    }
    let zeros = match relation {
        Relation::Less | Relation::Greater | Relation::NotEqual if is_zero(b) => factors(a),
        Relation::Less | Relation::Greater | Relation::NotEqual if is_zero(a) => factors(b),
        Relation::Less | Relation::Greater | Relation::NotEqual => {
            vec![sum(vec![(Sign::Plus, a.clone()), (Sign::Minus, b.clone())])]
        }
        _ => Vec::new(),
    };
    let on_the_edge = zeros.into_iter().map(|e| compare(e, Relation::Equal, numeral(0)));
    let beyond = compare(a.clone(), relation.negated(), b.clone());
    let without_value = zeros_of_divisors(&goal).into_iter().take(DIVISORS);
    let begin = Moment::now();
    on_the_edge.chain([beyond]).chain(without_value).find_map(|fails| {
        let body: Vec<Prop> = assumptions.iter().cloned().chain([fails]).collect();
        let limits = Limits { time: limits.time.saturating_sub(begin.elapsed()), ..limits.clone() };
        exists(claim, bindings.clone(), body, &limits)
    })
}

/// Values for which all of this is shown to hold.
fn exists(claim: &Claim, bindings: Vec<Binding>, mut body: Vec<Prop>, limits: &Limits) -> Option<Point> {
    let body = match (body.len(), body.pop()) {
        (1, Some(only)) => only,
        (_, last) => prop(PropKind::And(body.into_iter().chain(last).collect())),
    };
    let goal = prop(PropKind::Exists(bindings, Box::new(body)));
    let certificate = prove::certificate(&alone(claim, Vec::new(), goal), &[], limits).ok()?.0;
    witness(&certificate)
}

/// A claim with these declarations and this goal, and nothing else.
fn alone(claim: &Claim, items: Vec<Item>, goal: Prop) -> Claim {
    Claim { using: Vec::new(), items, sample: Vec::new(), proof: Proof::default(), goal, ..claim.clone() }
}

/// The values of the last witness.
fn witness(certificate: &Certificate) -> Option<Point> {
    certificate.steps.iter().rev().filter_map(Step::show).find_map(|show| match &show.rule {
        Rule::Witness { with, .. } => {
            let values = with.iter().map(|(n, value)| (n.text.clone(), print::expr(value)));
            Some(Point { values: values.collect() })
        }
        _ => None,
    })
}

/// The factors of a product as it is written, without their exponents.
fn factors(e: &Expr) -> Vec<Expr> {
    match &e.kind {
        ExprKind::Product(list) => {
            list.iter().filter(|(factor, _)| *factor == Factor::Times).flat_map(|(_, e)| factors(e)).collect()
        }
        ExprKind::Power(base, exponent) if matches!(exponent.kind, ExprKind::Number(_)) => factors(base),
        ExprKind::Negate(a) => factors(a),
        _ => vec![e.clone()],
    }
}

/// A point for hypotheses about families u that say what u(k + 1) is, given u(k): with values for the other variables, each
/// family is a sequence, and the kernel accepts that the hypotheses hold of these.
fn by_recurrence(claim: &Claim, statement: &Statement, limits: &Limits) -> Option<Point> {
    let families = families_of(&statement.bindings)?;
    let speaks = |p: &Prop| {
        let mut names = BTreeSet::new();
        names_in_prop(p, &mut names);
        families.iter().any(|f| names.contains(f))
    };
    let (about, plain): (Vec<Prop>, Vec<Prop>) = statement.assumptions.iter().cloned().partition(speaks);
    if about.is_empty() || !statement.sequences.is_empty() {
        return None;
    }
    let others = |b: &Binding| b.names.iter().all(|n| n.1.is_none());
    let bindings: Vec<Binding> = statement.bindings.iter().filter(|b| others(b)).cloned().collect();
    let truth = compare(numeral(0), Relation::Equal, numeral(0));
    let body = prop(PropKind::And(plain.into_iter().chain([truth.clone(), truth]).collect()));
    let values = example(&bindings, &body, Moment::now().checked_add(limits.time))?;
    let mut map = Substitution::default();
    values.iter().for_each(|(n, value)| map.replace(n, &literal(value)));
    let about: Vec<Prop> = about.iter().map(|p| map.prop(p)).collect::<Result<_, _>>().ok()?;
    let mut items = Vec::new();
    let mut point: Vec<(String, String)> =
        values.iter().map(|(n, value)| (n.clone(), print::expr(&literal(value)))).collect();
    if let Some(first) = by_definition(&about, &families) {
        point.extend(first.into_iter().map(|(member, value)| (member, print::expr(&value))));
        return Some(Point { values: point });
    }
    for family in &families {
        let initial = about.iter().find_map(|p| value_of(p, family)).unwrap_or_else(|| numeral(1));
        let constant = || ("k".to_string(), apply(family, name("k")));
        let (index, step) = about.iter().find_map(|p| step_of(p, family)).unwrap_or_else(constant);
        point.push((format!("{family}(0)"), print::expr(&initial)));
        items.push(Item::Define {
            name: Name::new(family),
            initial,
            index: Name::new(&index),
            step,
            span: Span::default(),
        });
    }
    let goal = match about.as_slice() {
        [only] => only.clone(),
        _ => prop(PropKind::And(about)),
    };
    prove::certificate(&alone(claim, items, goal), &[], limits).ok()?;
    Some(Point { values: point })
}

/// The first members of families, with values for them, if the hypotheses define all families and say nothing else of them.
///
/// Each is `u(c) = v` for a numeral c, v without families, or `for all k natural: u(k + d) = R`, one for each family, where
/// c < d. R is made of numbers, k and members v(k + j), j < d, by sums, products and whole powers, so it has a value whenever
/// these have; it may divide by a number other than 0. Then the hypotheses hold of some families: with what is not given among u(0) … u(d − 1) set to 1, recursion on
/// the index defines every member by members of lower index.
fn by_definition(about: &[Prop], families: &[String]) -> Option<Vec<(String, Expr)>> {
    let mut orders: Vec<(&String, u32)> = Vec::new();
    let mut first: Vec<(String, u32, Expr)> = Vec::new();
    for p in about {
        let PropKind::ForAll(bindings, body) = &p.kind else {
            let (family, at, value) = equation(p).into_iter().find_map(|(a, b)| {
                let (family, at) = member(a, families, None)?;
                is_polynomial(b, &[], None).then(|| (family, at, b.clone()))
            })?;
            first.push((family, at, value));
            continue;
        };
        let [Binding { names, natural: true, constraints, .. }] = bindings.as_slice() else { return None };
        let ([(index, None)], true) = (names.as_slice(), constraints.is_empty()) else { return None };
        let (family, order) = equation(body).into_iter().find_map(|(a, b)| {
            let (family, order) = member(a, families, Some(&index.text))?;
            is_polynomial(b, families, Some((&index.text, order))).then_some((family, order))
        })?;
        orders.push((families.iter().find(|f| **f == family)?, order));
    }
    let once = families.iter().all(|f| orders.iter().filter(|(g, _)| *g == f).count() == 1);
    let mut values = Vec::new();
    for (family, order) in orders {
        for at in 0..order {
            let mut given = first.iter().filter(|(f, c, _)| f == family && *c == at);
            let value = given.next().map_or_else(|| numeral(1), |(_, _, value)| value.clone());
            given.next().is_none().then(|| values.push((format!("{family}({at})"), value)))?;
        }
        first.iter().all(|(f, c, _)| f != family || *c < order).then_some(())?;
    }
    once.then_some(values)
}

/// Both readings of an equation: what is defined, and by what.
fn equation(p: &Prop) -> Vec<(&Expr, &Expr)> {
    match &p.kind {
        PropKind::Compare(sides, relations) if *relations == [Relation::Equal] => {
            vec![(&sides[0], &sides[1]), (&sides[1], &sides[0])]
        }
        _ => Vec::new(),
    }
}

/// A member u(c), or u(k + c) for an index k, of one of the families: which, and c.
fn member(e: &Expr, families: &[String], index: Option<&str>) -> Option<(String, u32)> {
    let ExprKind::Apply(f, list) = &e.kind else { return None };
    let ([at], true) = (list.as_slice(), families.contains(&f.text)) else { return None };
    let number = |e: &Expr| match &e.kind {
        ExprKind::Number(text) => text.parse::<u32>().ok().filter(|c| *c <= 8),
        _ => None,
    };
    let is_index = |e: &Expr| matches!((&e.kind, index), (ExprKind::Name(n), Some(k)) if n == k);
    let shift = match (&at.kind, index) {
        (_, None) => number(at)?,
        (_, Some(_)) if is_index(at) => 0,
        (ExprKind::Sum(list), Some(_)) => match list.as_slice() {
            [(Sign::Plus, k), (Sign::Plus, c)] if is_index(k) => number(c)?,
            _ => return None,
        },
        _ => return None,
    };
    Some((f.text.clone(), shift))
}

/// Whether an expression is made of numbers, the index and members below an index by sums, products and whole powers.
fn is_polynomial(e: &Expr, families: &[String], index: Option<(&str, u32)>) -> bool {
    let inner = |e: &Expr| is_polynomial(e, families, index);
    match &e.kind {
        ExprKind::Number(_) => true,
        ExprKind::Name(n) => index.is_some_and(|(k, _)| k == n),
        ExprKind::Apply(..) => {
            index.is_some_and(|(k, order)| member(e, families, Some(k)).is_some_and(|(_, shift)| shift < order))
        }
        ExprKind::Negate(a) => inner(a),
        ExprKind::Sum(list) => list.iter().all(|(_, e)| inner(e)),
        ExprKind::Product(list) => list.iter().all(|(factor, e)| match factor {
            Factor::Times => inner(e),
            Factor::Over => number(e).is_some_and(|(top, _)| top != 0),
        }),
        ExprKind::Power(a, b) => {
            inner(a) && matches!(&b.kind, ExprKind::Number(k) if k.parse::<u32>().is_ok_and(|k| k > 0))
        }
        _ => false,
    }
}

/// The families, if each is one of real numbers without bounds, for every natural number.
fn families_of(bindings: &[Binding]) -> Option<Vec<String>> {
    let mut out = Vec::new();
    for b in bindings.iter().filter(|b| b.names.iter().any(|n| n.1.is_some())) {
        if b.natural || !b.constraints.is_empty() || b.indices.is_some() || b.names.iter().any(|n| n.1.is_none()) {
            return None;
        }
        out.extend(b.names.iter().map(|n| n.0.text.clone()));
    }
    Some(out)
}

fn is_member(e: &Expr, family: &str, index: &Expr) -> bool {
    matches!(&e.kind, ExprKind::Apply(f, list)
        if f.text == family && matches!(list.as_slice(), [at] if key::expr(at) == key::expr(index)))
}

/// c, where a proposition says u(0) = c.
fn value_of(p: &Prop, family: &str) -> Option<Expr> {
    match p.single() {
        Some((a, Relation::Equal, b)) if is_member(a, family, &numeral(0)) => Some(b.clone()),
        Some((a, Relation::Equal, b)) if is_member(b, family, &numeral(0)) => Some(a.clone()),
        _ => None,
    }
}

/// k and R, where a proposition says `for all k natural: c*u(k + 1) = c*R`, with what stands beside u(k + 1) on the other
/// side as a divisor.
fn step_of(p: &Prop, family: &str) -> Option<(String, Expr)> {
    let PropKind::ForAll(bindings, body) = &p.kind else { return None };
    let [binding] = bindings.as_slice() else { return None };
    let [(index, None)] = binding.names.as_slice() else { return None };
    if !binding.natural || !binding.constraints.is_empty() {
        return None;
    }
    let k = name(&index.text);
    let next = sum(vec![(Sign::Plus, k), (Sign::Plus, numeral(1))]);
    let Some((a, Relation::Equal, b)) = body.single() else { return None };
    let mentions = |e: &Expr| {
        let mut names = BTreeSet::new();
        names_in(e, &mut names);
        names.contains(family)
    };
    let solved = [(a, b), (b, a)].into_iter().find_map(|(this, other)| {
        if is_member(this, family, &next) {
            return Some(other.clone());
        }
        let ExprKind::Product(list) = &this.kind else { return None };
        let place = list.iter().position(|(f, e)| *f == Factor::Times && is_member(e, family, &next))?;
        let mut quotient = vec![(Factor::Times, other.clone())];
        for (_, (factor, e)) in list.iter().enumerate().filter(|(at, _)| *at != place) {
            let turned = if *factor == Factor::Times { Factor::Over } else { Factor::Times };
            quotient.push((turned, e.clone()));
        }
        let beside = quotient.iter().skip(1).all(|(_, e)| !mentions(e));
        beside.then(|| expr(ExprKind::Product(quotient)))
    });
    Some((index.text.clone(), solved?))
}
