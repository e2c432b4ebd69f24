//! Values in doubles at points where the hypotheses hold: what fails there is not tried.
//!
//! Method: the points of a grid of positive numbers, each moved along its ray from 0 to where a hypothesis is an equation; or points
//! drawn from a few numbers, as far as the facts hold there. A statement with quantifiers is tried at the values of its bound names
//! where its comparisons turn (`turning_values`), and between them.
//!
//! Doubles decide nothing here. A comparison that fails at one of the points is false, so that no proof of it is looked for.

use super::Prover;
use super::letters::{as_power, natural};
use super::products::Kind;
use crate::algebra::Polynomial;
use crate::claim::syntax::*;
use crate::kernel::names::{names_in, names_in_prop};
use crate::kernel::statement::domain;
use crate::number::double::nearest;
use malachite::Rational;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

/// The coordinates of the grid: near 0, near 1 and far.
const GRID: [f64; 6] = [0.001, 0.45, 0.9, 1.0, 1.1, 7.0];

/// What a difference may be off, in proportion.
const ROUNDING: f64 = 1e-9;

/// The numbers from which places are drawn, and the natural ones.
const POOL: [f64; 27] = [
    0.0, 0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 1.0, 1.2, 2.0, 3.7, 7.0, 20.0, 100.0, 1.0, 0.2, -0.01, -0.1, -0.3, -0.5, -0.8,
    -1.0, -1.3, -2.0, -5.0, -20.0, -100.0,
];
const WHOLES: [f64; 7] = [0.0, 1.0, 2.0, 3.0, 5.0, 10.0, 100.0];

/// The most names that are drawn, how often they are, and the most places that are kept.
const NAMES: usize = 6;
const DRAWS: usize = 1_000;
const PLACES: usize = 40;

/// Where between two values a bound name is tried, and the most values of one of several bound names.
const PARTS: [f64; 3] = [0.001, 0.5, 0.999];
const FEW: usize = 24;

/// A ray is searched between these powers of 2, and its zero is halved towards this often.
const FAR: i32 = 24;
const HALVINGS: usize = 60;

/// Points, each with a coordinate for every name.
pub(super) struct TrialPoints {
    names: Vec<String>,
    points: Vec<Vec<f64>>,
}

impl Prover {
    /// Points with positive coordinates at which the hypotheses about these variables hold; `at` is the scale of the grid.
    pub(super) fn trial_points(&mut self, variables: &[u32], at: &Rational) -> TrialPoints {
        let name_of = |v: &u32| match self.letters.expr(*v).map(|e| &e.kind) {
            Some(ExprKind::Name(name)) => Some(name.clone()),
            _ => None,
        };
        let Some(names) = variables.iter().map(name_of).collect::<Option<Vec<_>>>() else {
            return TrialPoints { names: Vec::new(), points: Vec::new() };
        };
        let mut known = self.all_known(&[]);
        known.retain(|k| k.poly.term_count() > 1 && k.poly.variables().iter().all(|v| variables.contains(v)));
        let value = |p: &Polynomial, point: &[f64]| -> (f64, f64) {
            let at = |v: &u32| variables.iter().position(|w| w == v).and_then(|i| point.get(i)).copied().unwrap_or(0.0);
            let power = |(v, k): &(u32, u32)| at(v).powi(i32::try_from(*k).unwrap_or(i32::MAX));
            let terms = p.terms().map(|(m, c)| nearest(c) * m.powers().iter().map(power).product::<f64>());
            terms.fold((0.0, 0.0), |(sum, size), t| (sum + t, size + t.abs()))
        };
        let holds = |point: &Vec<f64>| {
            known.iter().all(|k| {
                let (sum, size) = value(&k.poly, point);
                sum >= -ROUNDING * size && (k.kind != Kind::Zero || sum <= ROUNDING * size)
            })
        };
        let equations = known.iter().any(|k| k.kind == Kind::Zero);
        let mut points = Vec::new();
        for point in grid(names.len(), nearest(at)) {
            let ends = known.iter().filter(|k| !equations || k.kind == Kind::Zero);
            let ends = ends.filter_map(|k| end_of_ray(&point, &|p| value(&k.poly, p).0));
            let moved: Vec<Vec<f64>> = ends.collect();
            points.extend(moved.into_iter().chain((!equations).then_some(point)).filter(holds));
        }
        TrialPoints { names, points }
    }
}

impl TrialPoints {
    /// Whether one expression is less than another at one of the points.
    pub(super) fn deny(&self, greater: &Expr, less: &Expr) -> bool {
        self.points.iter().any(|point| {
            let (Some(x), Some(y)) = (self.value(greater, point), self.value(less, point)) else { return false };
            x - y < -ROUNDING * (x.abs() + y.abs())
        })
    }

    fn value(&self, e: &Expr, point: &[f64]) -> Option<f64> {
        let at = |name: &str| point.get(self.names.iter().position(|n| n == name)?).copied();
        value_at(e, &at)
    }
}

/// The value of an expression where names have these values; no number where it has none, `None` where it is not known how to
/// compute it.
fn value_at(e: &Expr, at: &dyn Fn(&str) -> Option<f64>) -> Option<f64> {
    let value = |e: &Expr| value_at(e, at);
    Some(match &e.kind {
        ExprKind::Number(text) => text.parse().ok()?,
        ExprKind::Name(name) => at(name).or_else(|| (name == PI).then_some(std::f64::consts::PI))?,
        ExprKind::Negate(a) => -value(a)?,
        ExprKind::Sum(list) => list.iter().try_fold(0.0, |sum, (sign, e)| {
            Some(if *sign == Sign::Plus { sum + value(e)? } else { sum - value(e)? })
        })?,
        ExprKind::Product(list) => list.iter().try_fold(1.0, |all, (factor, e)| {
            Some(if *factor == Factor::Times { all * value(e)? } else { all / value(e)? })
        })?,
        ExprKind::Apply(f, list) if !matches!(f.text.as_str(), "sqrt" | "cbrt") => {
            let [of] = list.as_slice() else { return None };
            let x = value(of)?;
            match f.text.as_str() {
                "exp" => x.exp(),
                "ln" => x.ln(),
                "cos" => x.cos(),
                "sin" => x.sin(),
                "arcsin" => x.asin(),
                "arccos" => x.acos(),
                "arctan" => x.atan(),
                "cosh" => x.cosh(),
                "sinh" => x.sinh(),
                "tanh" => x.tanh(),
                "sech" => 1.0 / x.cosh(),
                _ => return None,
            }
        }
        _ => {
            let (base, exponent) = as_power(e)?;
            match natural(&exponent) {
                Some(k) => value(&base)?.powi(i32::try_from(k).ok()?),
                None => value(&base)?.powf(value(&exponent)?),
            }
        }
    })
}

/// Values of names.
pub(super) type Place = Vec<(String, f64)>;

/// What is known of the names that a statement binds: the values where its comparisons turn.
pub(super) type Turns = BTreeMap<String, Vec<Expr>>;

/// The value of an expression at a place.
pub(super) fn value_here(e: &Expr, place: &Place) -> Option<f64> {
    // The innermost name comes last.
    value_at(e, &|name| place.iter().rev().find(|own| own.0 == name).map(|own| own.1))
}

/// Whether a statement holds at a place, as far as doubles tell; bound names are tried at the values where they turn.
pub(super) fn truth(p: &Prop, place: &mut Place, turns: &Turns) -> Option<bool> {
    match &p.kind {
        PropKind::Compare(sides, relations) => {
            let values = sides.iter().map(|e| value_here(e, place)).collect::<Option<Vec<f64>>>()?;
            values.iter().all(|x| x.is_finite()).then(|| {
                values.windows(2).zip(relations).all(|(pair, relation)| {
                    let (difference, size) = (pair[0] - pair[1], pair[0].abs() + pair[1].abs());
                    let off = ROUNDING * size;
                    match relation {
                        Relation::Equal => difference.abs() <= off,
                        Relation::NotEqual => difference.abs() > off,
                        Relation::Less => difference < -off,
                        Relation::LessEqual => difference <= off,
                        Relation::Greater => difference > off,
                        Relation::GreaterEqual => difference >= -off,
                    }
                })
            })
        }
        PropKind::And(list) => all_of(list.iter().map(|p| truth(p, place, turns))),
        PropKind::Or(list) => all_of(list.iter().map(|p| truth(p, place, turns).map(|t| !t))).map(|t| !t),
        PropKind::Not(p) => truth(p, place, turns).map(|t| !t),
        PropKind::Implies(p, q) => match truth(p, place, turns) {
            Some(false) => Some(true),
            premise => match truth(q, place, turns) {
                Some(true) => Some(true),
                conclusion => premise.and(conclusion),
            },
        },
        PropKind::Equivalent(list) => {
            let known = list.iter().map(|p| truth(p, place, turns)).collect::<Option<Vec<bool>>>()?;
            Some(known.windows(2).all(|pair| pair[0] == pair[1]))
        }
        PropKind::ForAll(bindings, body) => everywhere(bindings, body, true, place, turns),
        PropKind::Exists(bindings, body) => everywhere(bindings, body, false, place, turns).map(|none| !none),
        _ => None,
    }
}

/// Whether all of these are true: one that is false decides, whatever the others are.
fn all_of(truths: impl Iterator<Item = Option<bool>>) -> Option<bool> {
    let mut all = Some(true);
    for truth in truths {
        match truth {
            Some(false) => return Some(false),
            Some(true) => {}
            None => all = None,
        }
    }
    all
}

/// Whether a body is as `wanted` wherever bound names are tried.
fn everywhere(bindings: &[Binding], body: &Prop, wanted: bool, place: &mut Place, turns: &Turns) -> Option<bool> {
    let names: Vec<(&str, bool)> =
        bindings.iter().flat_map(|b| b.names.iter().map(|n| (n.0.text.as_str(), b.natural))).collect();
    let domains: Vec<Prop> = bindings.iter().flat_map(domain).collect();
    let most = if names.len() == 1 { usize::MAX } else { FEW };
    let mut known = Some(true);
    at_all(&names, most, place, turns, &mut |place| {
        if all_of(domains.iter().map(|p| truth(p, place, turns))) != Some(true) {
            return true;
        }
        match truth(body, place, turns) {
            Some(holds) if holds == wanted => true,
            Some(_) => {
                known = Some(false);
                false
            }
            None => {
                known = None;
                true
            }
        }
    });
    known
}

/// Visits the places at which bound names are tried, until one is enough.
fn at_all(
    names: &[(&str, bool)],
    most: usize,
    place: &mut Place,
    turns: &Turns,
    visit: &mut dyn FnMut(&mut Place) -> bool,
) -> bool {
    let Some(((name, natural), rest)) = names.split_first() else { return visit(place) };
    let values = turns.get(*name).map_or(&[][..], Vec::as_slice);
    let mut values: Vec<f64> = values.iter().filter_map(|e| value_here(e, place)).filter(|x| x.is_finite()).collect();
    for x in tried(&mut values, *natural).into_iter().take(most) {
        place.push(((*name).to_string(), x));
        let goes_on = at_all(rest, most, place, turns, visit);
        place.pop();
        if !goes_on {
            return false;
        }
    }
    true
}

/// These values, and values near them, between them and beyond them.
fn tried(values: &mut Vec<f64>, natural: bool) -> Vec<f64> {
    if natural {
        let near = values.iter().flat_map(|x| [x.floor(), x.ceil(), x.ceil() + 1.0]);
        return near.chain(WHOLES).filter(|x| *x >= 0.0).collect();
    }
    values.extend([0.0, 1.0, -1.0]);
    values.sort_by(f64::total_cmp);
    values.dedup();
    let between = values.windows(2).flat_map(|pair| PARTS.map(|part| pair[0] + (pair[1] - pair[0]) * part));
    let ends = values.first().into_iter().flat_map(|x| [x - 1.0, x - 100.0]);
    let ends = ends.chain(values.last().into_iter().flat_map(|x| [x + 1.0, x + 100.0]));
    values.iter().copied().chain(between).chain(ends).collect()
}

impl Prover {
    /// Places at which the facts without quantifiers hold, as far as they speak of what these names depend on.
    pub(super) fn sampled(&self, about: &BTreeSet<String>) -> Vec<Place> {
        let mut facts: Vec<(Rc<Prop>, BTreeSet<String>)> = Vec::new();
        for (_, fact) in self.checker.facts() {
            let mut names = BTreeSet::new();
            names_in_prop(fact, &mut names);
            names.retain(|n| self.is_a_name(n));
            let ones = names.iter().map(|n| (n.clone(), 1.0)).collect();
            if is_computed(fact, &ones) {
                facts.push((fact.clone(), names));
            }
        }
        let mut names: BTreeSet<String> = about.iter().filter(|n| self.is_a_name(n)).cloned().collect();
        loop {
            let before = names.len();
            for (_, more) in &facts {
                if !more.is_disjoint(&names) {
                    names.extend(more.iter().cloned());
                }
            }
            if names.len() == before {
                break;
            }
        }
        facts.retain(|f| f.1.is_subset(&names));
        let (drawn, computed) = computed_last(&facts, names);
        if drawn.len() > NAMES {
            return Vec::new();
        }
        let mut seed = 1u64;
        let mut out: Vec<Place> = Vec::new();
        for _ in 0..if drawn.is_empty() { 1 } else { DRAWS } {
            let mut place: Place = Vec::new();
            for name in &drawn {
                seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                let pool: &[f64] = if self.naturals.contains(name) { &WHOLES } else { &POOL };
                let k = usize::try_from(seed >> 33).unwrap_or(0) % pool.len();
                place.push((name.clone(), pool[k]));
            }
            for (name, value) in &computed {
                place.push((name.clone(), value_here(value, &place).unwrap_or(f64::NAN)));
            }
            let holds = all_of(facts.iter().map(|f| truth(&f.0, &mut place, &Turns::new()))) == Some(true);
            if holds && !out.contains(&place) {
                out.push(place);
            }
            if out.len() == PLACES {
                break;
            }
        }
        out
    }
}

/// Whether it is known how to compute all sides of a statement without quantifiers.
fn is_computed(p: &Prop, ones: &Place) -> bool {
    match &p.kind {
        PropKind::Compare(sides, _) => sides.iter().all(|e| value_here(e, ones).is_some()),
        PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => {
            list.iter().all(|p| is_computed(p, ones))
        }
        PropKind::Not(p) => is_computed(p, ones),
        PropKind::Implies(p, q) => is_computed(p, ones) && is_computed(q, ones),
        _ => false,
    }
}

/// The names that are drawn, and those that equations give by others, in the order in which they are computed.
fn computed_last(
    facts: &[(Rc<Prop>, BTreeSet<String>)],
    names: BTreeSet<String>,
) -> (Vec<String>, Vec<(String, Expr)>) {
    let (mut open, mut computed) = (names, Vec::<(String, Expr)>::new());
    for (fact, _) in facts {
        let Some((a, Relation::Equal, b)) = fact.single() else { continue };
        for (own, value) in [(a, b), (b, a)] {
            let ExprKind::Name(own) = &own.kind else { continue };
            let mut used = BTreeSet::new();
            names_in(value, &mut used);
            let depends = |n: &String| n == own || computed.iter().any(|c| c.0 == *n);
            if open.contains(own)
                && !used.iter().any(depends)
                && !computed.iter().any(|c| super::limits::holds(&c.1, own))
            {
                open.remove(own);
                computed.push((own.clone(), value.clone()));
                break;
            }
        }
    }
    (open.into_iter().collect(), computed)
}

/// The points of the grid.
fn grid(count: usize, scale: f64) -> Vec<Vec<f64>> {
    let longer = |p: &Vec<f64>| GRID.map(|x| p.iter().copied().chain([x * scale]).collect::<Vec<f64>>());
    (0..count).fold(vec![Vec::new()], |points, _| points.iter().flat_map(longer).collect())
}

/// The point on the ray of another at which a function is 0.
fn end_of_ray(point: &[f64], f: &dyn Fn(&[f64]) -> f64) -> Option<Vec<f64>> {
    let moved = |t: f64| point.iter().map(|x| x * t).collect::<Vec<f64>>();
    let sign = |t: f64| f(&moved(t)) > 0.0;
    let k = (-FAR..FAR).find(|k| sign(2f64.powi(*k)) != sign(2f64.powi(k + 1)))?;
    let (mut low, mut high) = (2f64.powi(k), 2f64.powi(k + 1));
    for _ in 0..HALVINGS {
        let middle = (low + high) / 2.0;
        if sign(middle) == sign(low) { low = middle } else { high = middle }
    }
    Some(moved(low))
}
