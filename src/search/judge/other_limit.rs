//! Limits that are another than a claim says, or none: the search for proofs finds what they are.
//!
//! Method: at a point of the parameters the value is read from bounds, and proved with the kernel. It is certainly another than
//! the claim's. A limit is one number; and where an expression tends to one, it does so along every way on which its variable
//! grows: a natural number along the even ones and the odd ones, a real number by steps of 2π. Of a bound |F| <= C·|G| from some number
//! on, for some C, the search shows that G/F tends to 0: so |F| exceeds every multiple of |G|. Of what is said to hold from some number on,
//! such as F > 0 where F is said to grow beyond all bounds, it shows that the opposite does.
//!
//! Limits: [`POINTS`], and the time.

use crate::algebra::Moment;
use crate::claim::print;
use crate::claim::syntax::*;
use crate::claim::walk::names_in;
use crate::kernel::statement::{compare, expr, name, numeral, prop};
use crate::kernel::substitution::Substitution;
use crate::prove;
use crate::refute::catalogue::Limits;
use crate::refute::evaluate::Assignment;
use crate::refute::expand::Statement;
use crate::refute::outcome::{Broken, Outcome, Point, Witness};
use std::cmp::Ordering;
use std::collections::BTreeSet;

/// The most points of the parameters.
const POINTS: usize = 2;

/// Two numbers, with ten and nine for the squares of what falls by a twentieth at least from the one to the other.
const NEAR_AND_FAR: [(u32, u32); 2] = [(64, 9), (4096, 10)];

/// A point at which a limit of the goal is another than it says, one of these or one without parameters.
pub(super) fn witness(claim: &Claim, points: &[Point], limits: &Limits) -> Option<Witness> {
    let (mut said, mut bounds) = (Vec::new(), Vec::new());
    limits_of(&claim.goal, &mut said);
    bounds_of(&claim.goal, &mut bounds);
    if said.is_empty() && bounds.is_empty() && opposites_of(&claim.goal).is_empty() {
        return None;
    }
    let statement = Statement::of(claim).ok().filter(|s| s.sequences.is_empty())?;
    let (mut said, mut bounds) = (Vec::new(), Vec::new());
    limits_of(&statement.goal, &mut said);
    bounds_of(&statement.goal, &mut bounds);
    let mut mentioned = BTreeSet::new();
    let props = statement.assumptions.iter().map(|a| &a.1).chain([&statement.goal]);
    props.for_each(|p| crate::kernel::names::names_in_prop(p, &mut mentioned));
    // An order declares its variable, of which nothing is said then.
    let plain = statement.bindings.iter().filter(|b| b.constraints.is_empty()).flat_map(|b| &b.names);
    let unsaid = plain.map(|n| n.0.text.as_str()).filter(|n| !mentioned.contains(*n));
    let moving: Vec<&str> = said.iter().map(|l| l.variable.text.as_str()).chain(unsaid).collect();
    let mut points: Vec<Point> = points.iter().map(|p| without(p, &moving)).collect();
    let mut names = statement.bindings.iter().flat_map(|b| &b.names);
    if names.all(|n| moving.contains(&n.0.text.as_str())) {
        points = vec![Point::default()];
    }
    points.dedup();
    let end = Moment::now().checked_add(limits.time);
    let is_pi = !statement.declares(PI);
    points.into_iter().take(POINTS).find_map(|point| {
        let other = said.iter().find_map(|l| other(claim, &statement, l, &point, (limits, end)));
        let broken = other.or_else(|| bounds.iter().find_map(|b| exceeded(claim, b, is_pi, &point, (limits, end))));
        let mut opposites = opposites_of(&statement.goal).into_iter();
        let broken = broken.or_else(|| opposites.find_map(|p| holds_at_last(claim, &p, &point, (limits, end))))?;
        Some(Witness { point, broken: vec![broken] })
    })
}

/// The same outcome without values for the variables that move in the limits of the goal: they say nothing of a limit.
pub(super) fn without_what_moves(claim: &Claim, mut outcome: Outcome) -> Outcome {
    let mut said = Vec::new();
    limits_of(&claim.goal, &mut said);
    let moving: Vec<&str> = said.iter().map(|l| l.variable.text.as_str()).collect();
    let fails_there = |p: &Prop| match &p.kind {
        PropKind::Limit(_) => false,
        _ => {
            let mut names = BTreeSet::new();
            crate::kernel::names::names_in_prop(p, &mut names);
            moving.iter().any(|n| names.contains(*n))
        }
    };
    let is_said_besides = match &claim.goal.kind {
        PropKind::And(list) => list.iter().any(fails_there),
        _ => fails_there(&claim.goal),
    };
    if let Some(witness) = outcome.witness.as_mut().filter(|_| !is_said_besides) {
        witness.point = without(&witness.point, &moving);
    }
    outcome
}

/// A point without the variables that move in the limits of a goal.
fn without(point: &Point, moving: &[&str]) -> Point {
    Point { values: point.values.iter().filter(|(n, _)| !moving.contains(&n.as_str())).cloned().collect() }
}

/// The limits that a goal says to hold.
fn limits_of(p: &Prop, out: &mut Vec<Limit>) {
    match &p.kind {
        PropKind::And(list) => list.iter().for_each(|p| limits_of(p, out)),
        PropKind::Limit(limit) => out.push((**limit).clone()),
        _ => {}
    }
}

/// What a limit is at a point, if that is another than it says.
fn other(
    claim: &Claim,
    statement: &Statement,
    l: &Limit,
    point: &Point,
    (limits, end): (&Limits, Option<Moment>),
) -> Option<Broken> {
    let at = values(point)?;
    let here = Limit { of: at.expr(&l.of).ok()?, value: at.expr(&l.value).ok()?, variable: l.variable.clone() };
    let x = &l.variable.text;
    let natural = statement.bindings.iter().find(|b| b.names.iter().any(|n| n.0.text == *x))?.natural;
    let alone = Assignment { is_pi: !statement.declares(PI), ..Assignment::default() };
    let said = alone.number(&here.value).ok()?;
    let mut taken = BTreeSet::from([x.clone()]);
    names_in(&here.of, &mut taken);
    let k = ["k", "m", "j", "p"].into_iter().find(|k| !taken.contains(*k))?;
    let mut ways = vec![None];
    ways.extend(ways_to_infinity(&here.of, x, k, natural, alone.is_pi).into_iter().map(Some));
    for way in ways {
        let left = end.map_or(limits.time, |end| end.after(Moment::now()));
        let limits = &Limits { time: left, ..limits.clone() };
        let mut own = here.clone();
        if let Some(way) = &way {
            let mut along = Substitution::default();
            along.replace(x, way);
            own.of = along.expr(&here.of).ok()?;
            own.variable = Name::new(k);
        }
        let mut own_claim = of_limit(claim, own.clone(), natural || way.is_some());
        let Some(value) = prove::value_of_limit(&own_claim, limits) else { continue };
        let Ok(found) = alone.number(&value) else { continue };
        match found.order(&said) {
            Some(Ordering::Less | Ordering::Greater) => {}
            // Where the whole has this limit, every way has it.
            Some(Ordering::Equal) if way.is_none() => return None,
            _ => continue,
        }
        own_claim.goal = prop(PropKind::Limit(Box::new(Limit { value: value.clone(), ..own })));
        if prove::certificate(&own_claim, &[], limits).is_ok() {
            let (value, said) = (print::expr(&value), print::expr(&here.value));
            let statement = match way {
                None => format!("the limit is {value}, not {said}"),
                Some(way) => format!("along {x} = {} the limit is {value}, not {said}", print::expr(&way)),
            };
            return Some(Broken { statement, left: value, right: String::new() });
        }
    }
    None
}

/// The values of a point, by the names of the variables.
fn values(point: &Point) -> Option<Substitution> {
    let mut at = Substitution::default();
    for (place, value) in &point.values {
        let place = crate::claim::parse::parse_expr(place).ok()?;
        let ExprKind::Name(n) = &place.kind else { return None };
        at.replace(n, &crate::claim::parse::parse_expr(value).ok()?);
    }
    Some(at)
}

/// A claim that says a limit alone.
fn of_limit(claim: &Claim, limit: Limit, natural: bool) -> Claim {
    let variable = Item::Given(vec![Binding::of(limit.variable.clone(), natural, Vec::new())]);
    alone(claim, vec![variable], prop(PropKind::Limit(Box::new(limit))))
}

/// A claim that says this alone.
fn alone(claim: &Claim, items: Vec<Item>, goal: Prop) -> Claim {
    Claim {
        items,
        goal,
        using: Vec::new(),
        sample: Vec::new(),
        proof: Proof::default(),
        written: None,
        ..claim.clone()
    }
}

/// `exists C, N: for all x >= N: abs(F) <= C*G`, as F, G, and x with whether it is natural.
struct Bound {
    of: Expr,
    by: Expr,
    variable: String,
    natural: bool,
}

/// The bounds by some multiple that a goal says to hold from some number on.
fn bounds_of(p: &Prop, out: &mut Vec<Bound>) {
    match &p.kind {
        PropKind::And(list) => list.iter().for_each(|p| bounds_of(p, out)),
        PropKind::Exists(bindings, body) => out.extend(bound(bindings, body)),
        _ => {}
    }
}

fn bound(bindings: &[Binding], body: &Prop) -> Option<Bound> {
    let (bindings, body) = prove::together(bindings, body);
    let eventual = prove::eventual(&bindings, body)?;
    let [(left, Relation::LessEqual | Relation::Less, right)] = eventual.pairs.as_slice() else { return None };
    // Other expressions than an absolute value may be far below.
    prove::under_root(left)?;
    // A multiple of G by a name that is found, which nothing else mentions.
    let found = [eventual.factor.as_ref(), Some(&eventual.start)].into_iter().flatten().flat_map(|b| &b.names);
    let found: Vec<&str> = found.map(|n| n.0.text.as_str()).collect();
    let is_found = |e: &Expr| matches!(&e.kind, ExprKind::Name(n) if found.contains(&n.as_str()));
    let ExprKind::Product(factors) = &right.kind else { return None };
    let place = factors.iter().position(|(how, e)| *how == Factor::Times && is_found(e))?;
    let mut rest = factors.clone();
    rest[place].1 = numeral(1);
    let by = expr(ExprKind::Product(rest));
    let mut free = BTreeSet::new();
    [left, &by].into_iter().for_each(|e| names_in(e, &mut free));
    let is_free = found.iter().all(|n| !free.contains(*n));
    is_free.then(|| Bound { of: left.clone(), by, variable: eventual.index.clone(), natural: eventual.natural })
}

/// That an expression exceeds every multiple of another at a point of the parameters.
fn exceeded(
    claim: &Claim,
    bound: &Bound,
    is_pi: bool,
    point: &Point,
    (limits, end): (&Limits, Option<Moment>),
) -> Option<Broken> {
    let at = values(point)?;
    let (of, by) = (at.expr(&bound.of).ok()?, at.expr(&bound.by).ok()?);
    let mut taken = BTreeSet::new();
    [&of, &by].into_iter().for_each(|e| names_in(e, &mut taken));
    if taken.iter().any(|n| *n != bound.variable && n != PI && !is_built_in(n)) {
        return None;
    }
    // |G/F| tends to 0 where G/F does.
    let [of, by] = [of, by].map(|e| prove::inside(&e).unwrap_or(e));
    let quotient = expr(ExprKind::Product(vec![(Factor::Times, by), (Factor::Over, of)]));
    if !falls(&quotient, &bound.variable, is_pi) {
        return None;
    }
    let limit = Limit { of: quotient, variable: Name::new(&bound.variable), value: numeral(0) };
    let left = end.map_or(limits.time, |end| end.after(Moment::now()));
    let own_claim = of_limit(claim, limit, bound.natural);
    prove::certificate(&own_claim, &[], &Limits { time: left, ..limits.clone() }).ok()?;
    let statement = "the difference exceeds every multiple of the order".to_string();
    Some(Broken { statement, left: String::new(), right: String::new() })
}

/// Whether the size of an expression falls between two numbers. What tends to 0 does so, if they are far enough apart and it falls as a
/// power or a logarithm; where an expression has no value there, it is not known.
fn falls(e: &Expr, x: &str, is_pi: bool) -> bool {
    let alone = Assignment { is_pi, ..Assignment::default() };
    let square = |(at, times): (u32, u32)| {
        let mut far = Substitution::default();
        far.replace(x, &numeral(at));
        let value = far.expr(e).ok()?;
        let factors = [numeral(times), value.clone(), value].map(|e| (Factor::Times, e));
        alone.number(&expr(ExprKind::Product(factors.to_vec()))).ok()
    };
    let [Some(near), Some(far)] = NEAR_AND_FAR.map(square) else { return true };
    far.order(&near) != Some(Ordering::Greater)
}

/// For each comparison that a goal says to hold from some number on, the same with the opposite comparison: both cannot hold.
fn opposites_of(p: &Prop) -> Vec<Prop> {
    let opposite = |p: &Prop| {
        let PropKind::Exists(bindings, body) = &p.kind else { return None };
        let eventual = prove::eventual(bindings, body).filter(|e| e.factor.is_none())?;
        let ([(l, relation, r)], PropKind::ForAll(later, inner)) = (eventual.pairs.as_slice(), &body.kind) else {
            return None;
        };
        inner.single()?;
        let denied = compare(l.clone(), relation.negated(), r.clone());
        let every = prop(PropKind::ForAll(later.clone(), Box::new(denied)));
        Some(prop(PropKind::Exists(bindings.clone(), Box::new(every))))
    };
    match &p.kind {
        PropKind::And(list) => list.iter().flat_map(opposites_of).collect(),
        _ => opposite(p).into_iter().collect(),
    }
}

/// That a statement holds at a point of the parameters whose opposite is claimed.
fn holds_at_last(claim: &Claim, p: &Prop, point: &Point, (limits, end): (&Limits, Option<Moment>)) -> Option<Broken> {
    let goal = values(point)?.prop(p).ok()?;
    let mut free = BTreeSet::new();
    crate::kernel::names::free_names(&goal, &mut free);
    if free.iter().any(|n| *n != PI && !is_built_in(n)) {
        return None;
    }
    let PropKind::Exists(_, every) = &goal.kind else { return None };
    let PropKind::ForAll(_, inner) = &every.kind else { return None };
    let statement = format!("from some number on {}", print::prop(inner));
    let left = end.map_or(limits.time, |end| end.after(Moment::now()));
    prove::certificate(&alone(claim, Vec::new(), goal), &[], &Limits { time: left, ..limits.clone() }).ok()?;
    Some(Broken { statement, left: String::new(), right: String::new() })
}

/// Ways on which a variable x grows, written by a natural number k: on each of them what turns may stand still.
fn ways_to_infinity(of: &Expr, x: &str, k: &str, natural: bool, is_pi: bool) -> Vec<Expr> {
    let times = |c: Expr| expr(ExprKind::Product(vec![(Factor::Times, c), (Factor::Times, name(k))]));
    let plus = |a: Expr, b: Expr| expr(ExprKind::Sum(vec![(Sign::Plus, a), (Sign::Plus, b)]));
    let twice = times(numeral(2));
    if natural {
        return vec![twice.clone(), plus(twice, numeral(1))];
    }
    if !is_pi || !prove::turns(of, x) {
        return Vec::new();
    }
    let turn =
        expr(ExprKind::Product(vec![(Factor::Times, numeral(2)), (Factor::Times, name(PI)), (Factor::Times, name(k))]));
    let half = expr(ExprKind::Product(vec![(Factor::Times, name(PI)), (Factor::Over, numeral(2))]));
    vec![turn.clone(), plus(turn.clone(), half), plus(turn, name(PI))]
}
