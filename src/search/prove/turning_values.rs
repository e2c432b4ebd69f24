//! Values of bound real names at which the comparisons of a statement turn: witnesses of `exists`, and instances of facts `for all`
//! where these say most.
//!
//! Method: the difference of the sides of each comparison is a quotient of polynomials in letters. Its zeros, where it is 1 or −1, and
//! where it is stationary are values of a name, and so are the ends of its domain and bounds of the least and greatest zero (Cauchy).
//! A name that is bound within is put in at its own such values first: for `for all x: abs(x - a) < d => …` at a + d and a − d. Halves,
//! doubles and the like of these values come last. A value is tried in doubles wherever the facts hold, before any step is taken.
//!
//! Limits: [`NAMES`] bound names, [`DIFFERENCES`], [`VALUES`] of a name that is bound within, [`KEPT`] points.

use super::facts::minus;
use super::letters::{as_power, product, whole_power};
use super::limits::{holds, over, plus};
use super::solved_equations::factors_with;
use super::sums::replace;
use super::trial_points::{Place, Turns, truth, value_here};
use super::{Fail, Prover, implies, under_root};
use crate::algebra::Polynomial;
use crate::certificate::{Label, Rule};
use crate::claim::syntax::*;
use crate::claim::walk::parts_mut;
use crate::kernel::key;
use crate::kernel::names::{free_names, names_in};
use crate::kernel::order::Signs;
use crate::kernel::statement::{apply, compare, domain, expr, name, numeral, prop};
use crate::kernel::substitution::Substitution;
use crate::refute::literal::literal;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Abs;
use std::collections::BTreeSet;

/// The most names of a statement for which values are proposed.
const NAMES: usize = 3;
/// The most comparisons that are solved.
const DIFFERENCES: usize = 40;
/// The most values of a name that is bound within.
const VALUES: usize = 10;
/// The most values of a name to which others are added.
const SIMPLE: usize = 48;
/// The most points that are proposed, and that are tried by proofs.
const PROPOSED: usize = 1_200;
const KEPT: usize = 4;
/// How far beyond a value whole numbers are tried.
const BEYOND: [f64; 3] = [1.0, 2.0, 20.0];
/// The most signs of coefficients that are distinguished within one another.
const CASES: usize = 2;
/// How deep functions are inverted.
const DEPTH: usize = 3;
/// The most terms of a numerator.
const TERMS: usize = 60;

/// Values for names.
type Point = Vec<(String, Expr)>;

impl Prover {
    /// Proves `exists` by values at which comparisons turn.
    pub(super) fn by_turning_values(&mut self, goal: &Prop, bindings: &[Binding], body: &Prop) -> Result<Label, Fail> {
        let found = self.points_that_do(bindings, body).ok_or(Fail::No("values where comparisons turn"))?;
        let whole = bindings.iter().any(|b| b.natural);
        for point in found.alone {
            let shown = self.with_half_of_the_time(|c| {
                c.on_its_own(|c| match (whole, point.as_slice()) {
                    (true, [(_, value)]) => c.by_a_whole_number_beyond(goal, bindings, body, value),
                    _ => c.by_values(goal, bindings, body, point),
                })
            });
            if shown.is_ok() {
                return shown;
            }
        }
        if let [first, second] = found.together.as_slice()
            && let Ok(label) = self.attempt(|c| c.by_one_of_two(goal, bindings, body, [first, second]))
        {
            return Ok(label);
        }
        self.attempt(|c| c.by_what_solves(goal, bindings, body))
    }

    /// Proves that something solves equations and has a property for all values besides, from the existence of a solution.
    fn by_what_solves(&mut self, goal: &Prop, bindings: &[Binding], body: &Prop) -> Result<Label, Fail> {
        let mut parts = Vec::new();
        super::solutions::conjuncts(body, &mut parts);
        let (mut solved, others): (Vec<Prop>, Vec<Prop>) = parts.into_iter().partition(|p| p.single().is_some());
        let alone = match (solved.len(), solved.pop()) {
            (1, Some(only)) if !others.is_empty() && others.iter().all(is_of_comparisons) => only,
            _ => return Err(Fail::No("an equation and what else is said")),
        };
        let some = prop(PropKind::Exists(bindings.to_vec(), Box::new(alone.clone())));
        let some = self.by_witness(&some, bindings, &alone)?;
        let (mut renamed, mut map, mut point) = (bindings.to_vec(), Substitution::default(), Vec::new());
        for own in renamed.iter_mut().flat_map(|b| &mut b.names) {
            let fresh = self.fresh(&own.0.text);
            map.replace(&own.0.text, &name(&fresh));
            point.push((own.0.text.clone(), name(&fresh)));
            own.0.text = fresh;
        }
        let then = implies(&map.prop(&alone).map_err(Fail::from)?, goal);
        let all = self.block(&prop(PropKind::ForAll(renamed, Box::new(then.clone()))), |c, _| {
            c.block(&then, |c, _| c.by_values(goal, bindings, body, point))
        })?;
        self.emit(Rule::Existence { some, all }, goal.clone())
    }

    /// Proves `exists` of a natural number by one that is greater than a value.
    fn by_a_whole_number_beyond(
        &mut self,
        goal: &Prop,
        bindings: &[Binding],
        body: &Prop,
        value: &Expr,
    ) -> Result<Label, Fail> {
        let own = bindings.iter().flat_map(|b| &b.names).next().ok_or(Fail::No("a name"))?.0.text.clone();
        let k = self.fresh("k");
        let beyond = compare(name(&k), Relation::Greater, value.clone());
        let over_naturals = vec![Binding::of(Name::new(&k), true, Vec::new())];
        let some = prop(PropKind::Exists(over_naturals.clone(), Box::new(beyond.clone())));
        let some = self.by_far_members(&some, &over_naturals, &beyond)?;
        let then = implies(&beyond, goal);
        let all = self.block(&prop(PropKind::ForAll(over_naturals, Box::new(then.clone()))), |c, _| {
            c.block(&then, |c, _| c.by_values(goal, bindings, body, vec![(own, name(&k))]))
        })?;
        self.emit(Rule::Existence { some, all }, goal.clone())
    }

    /// Proves `exists` by one point where that has the property, and by another one elsewhere.
    fn by_one_of_two(
        &mut self,
        goal: &Prop,
        bindings: &[Binding],
        body: &Prop,
        points: [&Point; 2],
    ) -> Result<Label, Fail> {
        let mut parts: Vec<Prop> = bindings.iter().flat_map(domain).collect();
        super::solutions::conjuncts(body, &mut parts);
        let (_, map) = super::goals::at(points[0].clone());
        let parts = parts.iter().map(|p| map.prop(p)).collect::<Result<Vec<Prop>, _>>().map_err(Fail::from)?;
        let is_open = |c: &mut Prover, p: &Prop| c.quietly(p).is_err();
        let mut open: Vec<Prop> = parts.into_iter().filter(|p| is_open(self, p)).collect();
        let (Some(case), true) = (open.pop(), open.is_empty()) else { return Err(Fail::No("one condition")) };
        let other = super::facts::opposite(&case).ok_or(Fail::No("an opposite"))?;
        let mut from = Vec::new();
        for (case, point) in [(case, points[0]), (other, points[1])] {
            from.push(self.block(&implies(&case, goal), |c, _| c.by_values(goal, bindings, body, point.clone()))?);
        }
        self.emit(Rule::Logic { from }, goal.clone())
    }

    /// Proves a comparison by an instance of a fact `for all` that its opposite contradicts, at values where comparisons turn.
    pub(super) fn by_turning_instance(&mut self, goal: &Prop, label: &str, every: &Prop) -> Result<Label, Fail> {
        self.against_opposite(goal, |c, _| c.refuted_by_instances(goal, label, every))
    }

    /// Shows any goal by instances of a fact `for all` that the other facts contradict; `every` is what the fact says, perhaps with
    /// equations put in.
    pub(super) fn refuted_by_instances(&mut self, goal: &Prop, label: &str, every: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("an instance that fails");
        let PropKind::ForAll(bindings, body) = &every.kind else { return Err(no()) };
        let denied = prop(PropKind::Not(body.clone()));
        let found = self.points_that_do(bindings, &denied).ok_or_else(no)?;
        let sets = found.alone.into_iter().map(|point| vec![point]).chain([found.together]);
        for points in sets.filter(|points| !points.is_empty()) {
            let shown = self.on_its_own(|c| {
                let mut shown = Vec::new();
                for point in &points {
                    shown.push(c.instance_at(label, point.clone())?);
                }
                c.refuted(goal).or_else(|fail| {
                    let ([shown], [point]) = (shown.as_slice(), points.as_slice()) else { return Err(fail) };
                    // What contradicts the instance may need a method of its own.
                    let there = super::goals::at(point.clone()).1.prop(body).map_err(Fail::from)?;
                    let denied = c.show(&super::facts::opposite(&there).ok_or(fail)?)?;
                    c.logic(&[shown, &denied], goal)
                })
            });
            if shown.is_ok() {
                return shown;
            }
        }
        self.in_signs_of_a_coefficient(goal, label, bindings, body)
    }

    /// The same in the cases of the sign of the first coefficient of unknown sign, that of the highest power of a variable.
    fn in_signs_of_a_coefficient(
        &mut self,
        goal: &Prop,
        label: &str,
        bindings: &[Binding],
        body: &Prop,
    ) -> Result<Label, Fail> {
        let no = || Fail::No("a coefficient of unknown sign");
        if self.splits >= CASES {
            return Err(no());
        }
        let (mut differences, mut within) = (Vec::new(), Vec::new());
        differences_in(body, &mut differences, &mut within);
        let names: Vec<&Name> = bindings.iter().flat_map(|b| &b.names).map(|n| &n.0).collect();
        let mut coefficient = None;
        for (difference, own) in differences.iter().flat_map(|d| names.iter().map(move |n| (d, &n.text))) {
            let Some((above, v)) = self.numerator_in(difference, own) else { continue };
            let Some(first) = above.coefficients_in(v).pop().filter(|_| above.degree_in(v) > 1) else { continue };
            let e = self.letters.written(&first);
            let is_free = names.iter().all(|n| !holds(&e, &n.text));
            if is_free && self.signs_of(&e) == Signs::ANY {
                coefficient = Some(e);
                break;
            }
        }
        let coefficient = coefficient.ok_or_else(no)?;
        let mut from = Vec::new();
        for relation in [Relation::Greater, Relation::Equal, Relation::Less] {
            let case = compare(coefficient.clone(), relation, numeral(0));
            self.splits += 1;
            let shown = self.block(&implies(&case, goal), |c, block| {
                c.put_in(&format!("{block}s"));
                let Some(every) = c.fact(label) else { return Err(no()) };
                let every = match (&coefficient.kind, relation) {
                    (ExprKind::Name(own), Relation::Equal) => super::put(&every, own, &numeral(0))?,
                    _ => every,
                };
                c.refuted_by_instances(goal, label, &every)
            });
            self.splits -= 1;
            from.push(shown?);
        }
        // Exactly one of them holds.
        let apart = compare(coefficient.clone(), Relation::NotEqual, numeral(0));
        from.push(self.block(&implies(&apart, goal), |c, block| {
            let sides = [Relation::Greater, Relation::Less].map(|r| compare(coefficient.clone(), r, numeral(0)));
            let either = c.logic(&[&format!("{block}s")], &prop(PropKind::Or(sides.to_vec())))?;
            c.logic(&[&either, &from[0], &from[2]], goal)
        })?);
        self.emit(Rule::Logic { from }, goal.clone())
    }

    /// Points that have a property wherever the facts hold, as far as doubles tell: those that do alone, or else two that do together.
    fn points_that_do(&mut self, bindings: &[Binding], body: &Prop) -> Option<Found> {
        let names: Vec<String> = bindings.iter().flat_map(|b| &b.names).map(|n| n.0.text.clone()).collect();
        let is_plain = |b: &Binding| b.indices.is_none() && b.names.iter().all(|n| n.1.is_none());
        if names.is_empty() || names.len() > NAMES || !bindings.iter().all(is_plain) {
            return None;
        }
        // Of a natural number values are proposed that it exceeds.
        let whole = bindings.iter().any(|b| b.natural);
        let reals: Vec<Binding> = bindings.iter().map(|b| Binding { natural: false, ..b.clone() }).collect();
        if whole && names.len() > 1 {
            return None;
        }
        let mut about = BTreeSet::new();
        free_names(&prop(PropKind::Exists(bindings.to_vec(), Box::new(body.clone()))), &mut about);
        let places = self.sampled(&about);
        if places.is_empty() {
            return None;
        }
        let mut turns = Turns::new();
        let points = self.proposed(&reals, body, &names, &mut turns);
        let mut parts: Vec<Prop> = bindings.iter().flat_map(domain).collect();
        parts.push(body.clone());
        let property = prop(PropKind::And(parts));
        let turns_of_all = turns;
        let mut out = Found::default();
        let mut partly: Vec<(Vec<bool>, Point)> = Vec::new();
        for point in points {
            if self.is_late() {
                return None;
            }
            let (_, map) = super::goals::at(point.clone());
            let Ok(there) = map.prop(&property) else { continue };
            let turns = turns_of_all
                .iter()
                .map(|(n, list)| (n.clone(), list.iter().filter_map(|e| map.expr(e).ok()).collect()));
            let turns: Turns = turns.collect();
            let does_at = |place: &Place| match point.as_slice() {
                [(own, value)] if whole => does_beyond(&property, own, value, place, &turns_of_all),
                _ => truth(&there, &mut place.clone(), &turns) == Some(true),
            };
            let mut does = places.iter().map(does_at);
            if !out.alone.is_empty() || names.len() > 1 {
                if does.all(|d| d) {
                    out.alone.push(point);
                }
            } else {
                let does: Vec<bool> = does.collect();
                if does.iter().all(|d| *d) {
                    out.alone.push(point);
                } else if does.contains(&true) {
                    partly.push((does, point));
                }
            }
            if out.alone.len() == KEPT {
                break;
            }
        }
        if out.alone.is_empty() {
            let both = |a: &[bool], b: &[bool]| a.iter().zip(b).all(|(a, b)| *a || *b);
            let pair = partly.iter().enumerate().find_map(|(k, (does, point))| {
                let (_, other) = partly.iter().skip(k + 1).find(|(other, _)| both(does, other))?;
                Some(vec![point.clone(), other.clone()])
            });
            out.together = pair.unwrap_or_default();
        }
        Some(out)
    }

    /// Points for the names of a statement, simple ones first. What is found of names that are bound within it is added to `turns`.
    fn proposed(&mut self, bindings: &[Binding], body: &Prop, names: &[String], turns: &mut Turns) -> Vec<Point> {
        let mut points: Vec<Point> = Vec::new();
        // What is found of a name may depend on the names before it, which are declared in a block.
        let every = prop(PropKind::ForAll(bindings.to_vec(), Box::new(body.clone())));
        let _ = self.attempt(|c| {
            c.block(&every, |c, _| {
                for (place, own) in names.iter().enumerate() {
                    let mut others: Vec<Point> = Vec::new();
                    let rest: Vec<&String> = names.iter().filter(|n| *n != own).collect();
                    if rest.is_empty() {
                        others.push(Vec::new());
                    } else {
                        for k in [1, 0] {
                            others.push(rest.iter().map(|n| ((*n).clone(), numeral(k))).collect());
                        }
                    }
                    if let ([other], 0) = (rest.as_slice(), place) {
                        let (values, _) = c.values_where_it_turns(bindings, body, other, turns);
                        let between = values.windows(2).map(|pair| halved(&plus(&pair[0], pair[1].clone())));
                        let all: Vec<Expr> = values.iter().cloned().chain(between.collect::<Vec<_>>()).collect();
                        others.extend(all.into_iter().filter(|e| holds(e, own)).map(|e| vec![((*other).clone(), e)]));
                    }
                    for other in others {
                        if c.is_late() {
                            break;
                        }
                        let (_, map) = super::goals::at(other.clone());
                        let Ok(there) = map.prop(body) else { continue };
                        for value in c.values_for(bindings, &there, own, turns) {
                            let mut alone = Substitution::default();
                            alone.replace(own, &value);
                            let rest = other.iter().map(|(n, e)| Some((n.clone(), alone.expr(e).ok()?)));
                            let Some(mut point) = rest.collect::<Option<Point>>() else { continue };
                            point.push((own.clone(), value));
                            points.push(point);
                        }
                    }
                }
                Err::<Label, Fail>(Fail::No("the points are all that was asked"))
            })
        });
        let mut seen = BTreeSet::new();
        points.retain(|point| {
            let mut keys: Vec<String> = point.iter().map(|(n, e)| format!("{n} {}", key::expr(e))).collect();
            keys.sort();
            seen.insert(keys)
        });
        // Under a quantifier absolute values are easier to treat than squares.
        let function = if within_a_quantifier(body) { 1 } else { 12 };
        points.sort_by_key(|point| point.iter().map(|(_, e)| weight(e, function)).sum::<usize>());
        points.truncate(PROPOSED);
        points
    }

    /// Values of a name: where its statement turns, and what lies beside, between and beyond.
    fn values_for(&mut self, bindings: &[Binding], body: &Prop, own: &str, turns: &mut Turns) -> Vec<Expr> {
        let ends = ends_of(bindings, own);
        let (mut values, differences) = self.values_where_it_turns(bindings, body, own, turns);
        for difference in &differences {
            values.extend(self.where_it_is_stationary(difference, own));
            for k in [1, -1] {
                values.extend(self.zeros_in(&minus(difference, &literal(&Rational::from(k))), own, DEPTH));
            }
            values.extend(self.bounds_of_zeros(difference, own));
            for end in &ends {
                let mut map = Substitution::default();
                map.replace(own, &plus(end, name(own)));
                let moved = map.expr(difference).map(|moved| self.bounds_of_zeros(&moved, own)).unwrap_or_default();
                values.extend(
                    moved
                        .iter()
                        .map(|value| self.simplified(&plus(end, value.clone())).unwrap_or(plus(end, value.clone()))),
                );
            }
        }
        let mut free = BTreeSet::new();
        differences.iter().for_each(|d| names_in(d, &mut free));
        let is_declared = |n: &&String| *n != own && self.is_a_name(n) && !turns.contains_key(*n);
        values.extend(free.iter().filter(is_declared).map(|n| name(n)));
        unique(&mut values);
        values.sort_by_key(|e| weight(e, 1));
        values.truncate(SIMPLE);
        let mut more: Vec<Expr> = Vec::new();
        for value in &values {
            more.extend([halved(value), product(vec![numeral(2), value.clone()])]);
            more.extend([plus(value, numeral(1)), minus(value, &numeral(1))]);
            more.push(over(value.clone(), plus(&numeral(1), value.clone())));
            more.extend(ends.iter().filter(|end| *end != value).map(|end| halved(&plus(value, end.clone()))));
        }
        values.extend(more);
        values.extend([0, 1, -1, 2, -2].map(|k| literal(&Rational::from(k))));
        values.push(literal(&Rational::from_unsigneds(1u32, 2)));
        unique(&mut values);
        values
    }

    /// The values of a name at which comparisons turn, and the differences in it, with names that are bound within put in.
    fn values_where_it_turns(
        &mut self,
        bindings: &[Binding],
        body: &Prop,
        own: &str,
        turns: &mut Turns,
    ) -> (Vec<Expr>, Vec<Expr>) {
        let (mut differences, mut within) = (Vec::new(), Vec::new());
        bindings.iter().flat_map(domain).for_each(|p| differences_in(&p, &mut differences, &mut within));
        differences_in(body, &mut differences, &mut within);
        differences.truncate(DIFFERENCES);
        differences.iter_mut().for_each(without_known_roots);
        for inner in within.iter().rev() {
            let (with, mut rest): (Vec<Expr>, Vec<Expr>) = differences.into_iter().partition(|d| holds(d, inner));
            let mut values = Vec::new();
            for difference in &with {
                values.extend(self.zeros_in(difference, inner, DEPTH));
                values.extend(self.stationary(difference, inner));
            }
            values.retain(|value| !holds(value, inner));
            unique(&mut values);
            values.sort_by_key(|e| weight(e, 1));
            values.truncate(VALUES);
            if values.is_empty() {
                values.push(numeral(0));
            }
            for value in &values {
                let mut map = Substitution::default();
                map.replace(inner, value);
                rest.extend(with.iter().filter_map(|d| map.expr(d).ok()));
            }
            unique(&mut rest);
            rest.truncate(DIFFERENCES);
            turns.entry(inner.clone()).or_default().extend(values);
            differences = rest;
        }
        differences.retain(|d| holds(d, own));
        let mut values = Vec::new();
        for difference in &differences {
            values.extend(self.zeros_in(difference, own, DEPTH));
        }
        unique(&mut values);
        (values, differences)
    }

    /// The numerator of an expression, and the only letter of it that holds a name: with sqrt(x) in it, x is the square of that.
    fn numerator_in(&mut self, e: &Expr, own: &str) -> Option<(Polynomial, u32)> {
        let (above, _) = self.letters.quotient(e)?;
        if above.term_count() > TERMS {
            return None;
        }
        let with = |c: &Prover, p: &Polynomial| -> Vec<u32> {
            let holds = |v: &u32| c.letters.expr(*v).is_some_and(|e| holds(e, own));
            p.variables().into_iter().filter(holds).collect()
        };
        let plain = self.letters.of(&name(own));
        match with(self, &above).as_slice() {
            [only] => Some((above, *only)),
            [a, b] if *a == plain || *b == plain => {
                let root = if *a == plain { *b } else { *a };
                let (base, exponent) = as_power(self.letters.expr(root)?)?;
                let degree = Rational::from(1) / self.letters.number(&exponent).filter(|q| *q > 0)?;
                let degree = u32::try_from(&degree).ok().filter(|_| base == name(own))?;
                let power = Polynomial::variable(root).pow(degree).ok()?;
                Some((above.substitute(plain, &power).ok()?, root))
            }
            _ => None,
        }
    }

    /// The values of a name at which a letter that holds it has this value.
    fn where_letter_is(&mut self, letter: u32, value: Expr, own: &str, depth: usize) -> Vec<Expr> {
        match self.letters.expr(letter).cloned() {
            Some(Expr { kind: ExprKind::Name(_), .. }) => vec![value],
            Some(letter) if depth > 0 => match inverse(&letter, value) {
                Some((inside, value)) if inside == name(own) => vec![value],
                Some((inside, value)) => self.zeros_in(&minus(&inside, &value), own, depth - 1),
                None => Vec::new(),
            },
            _ => Vec::new(),
        }
    }

    /// Where an expression is 0, as far as one letter holds the name: functions are inverted, and absolute values have both signs.
    fn zeros_in(&mut self, e: &Expr, own: &str, depth: usize) -> Vec<Expr> {
        let mut out = Vec::new();
        for plain in without_absolute_values(e, own) {
            let Some((above, v)) = self.numerator_in(&plain, own) else { continue };
            for factor in factors_with(&above, &[v]) {
                for (above, below) in self.values_in(&factor, v, &[v]).unwrap_or_default() {
                    if let Some(value) = self.quotient_written(&above, &below) {
                        out.extend(self.where_letter_is(v, value, own, depth));
                    }
                }
            }
        }
        out
    }

    /// Where a quotient of polynomials in a name is stationary.
    fn stationary(&mut self, e: &Expr, own: &str) -> Vec<Expr> {
        let mut out = Vec::new();
        for plain in without_absolute_values(e, own) {
            let Some((above, below)) = self.letters.quotient(&plain) else { continue };
            let v = self.letters.of(&name(own));
            let both = [&above, &below].into_iter().flat_map(Polynomial::variables);
            let is_rational = both.filter(|w| *w != v).all(|w| !self.letters.expr(w).is_some_and(|e| holds(e, own)));
            if !is_rational || above.term_count() + below.term_count() > TERMS {
                continue;
            }
            let slope = (above.derivative(v).try_mul(&below).ok())
                .and_then(|first| Some(first.sub(&above.try_mul(&below.derivative(v)).ok()?)));
            for factor in slope.iter().flat_map(|slope| factors_with(slope, &[v])) {
                let values = self.values_in(&factor, v, &[v]).unwrap_or_default();
                out.extend(values.iter().filter_map(|(a, b)| self.quotient_written(a, b)));
            }
        }
        out
    }

    /// The same of an expression in a name that is declared, with functions of it.
    fn where_it_is_stationary(&mut self, e: &Expr, own: &str) -> Vec<Expr> {
        let mut out = self.stationary(e, own);
        if out.is_empty() && super::slopes::has_function(e) {
            for plain in without_absolute_values(e, own) {
                out.extend(self.stationary_points(&plain, own));
            }
        }
        out
    }

    /// What is less than every positive zero of a quotient of polynomials, what is greater than every zero, and the opposites
    /// (Cauchy's bounds). Coefficients of unknown sign are bounded by their absolute values, or by 1 more than their squares.
    fn bounds_of_zeros(&mut self, e: &Expr, own: &str) -> Vec<Expr> {
        let mut out = Vec::new();
        for plain in without_absolute_values(e, own) {
            let Some((above, v)) = self.numerator_in(&plain, own) else { continue };
            let parts: Vec<Polynomial> = above.coefficients_in(v).into_iter().filter(|c| !c.is_zero()).collect();
            let [first, .., last] = parts.as_slice() else { continue };
            for by_squares in [false, true] {
                let sizes: Vec<(Polynomial, bool)> =
                    parts.iter().map(|c| self.size_of_coefficient(c, by_squares)).collect();
                let all = sizes.iter().fold(Polynomial::zero(), |sum, size| sum.add(&size.0));
                let known =
                    |c: &Polynomial| parts.iter().position(|p| p == c).and_then(|k| sizes.get(k)).filter(|s| s.1);
                let mut bounds = Vec::new();
                bounds.extend(known(first).map(|least| (least.0.clone(), all.clone())));
                bounds.extend(known(last).map(|most| (all.clone(), most.0.clone())));
                for (above, below) in bounds {
                    for above in [above.neg(), above] {
                        if let Some(value) = self.quotient_written(&above, &below) {
                            out.extend(self.where_letter_is(v, value, own, DEPTH));
                        }
                    }
                }
                // With all signs known both are the same.
                if sizes.iter().all(|size| size.1) {
                    break;
                }
            }
        }
        out
    }

    /// What is at least as large as a coefficient, and whether its sign is known, so that it is its absolute value.
    fn size_of_coefficient(&mut self, c: &Polynomial, by_squares: bool) -> (Polynomial, bool) {
        if let Some(number) = c.as_constant() {
            return (Polynomial::constant(number.abs()), true);
        }
        let e = self.letters.written(c);
        match self.signs_of(&e) {
            signs if signs.within(Signs::NOT_NEGATIVE) => (c.clone(), true),
            signs if signs.within(Signs::of(Relation::LessEqual)) => (c.neg(), true),
            _ if by_squares => (c.pow(2).map_or_else(|_| c.clone(), |square| square.add(&Polynomial::one())), false),
            _ => {
                let number = match c.terms().next() {
                    Some((_, number)) if c.term_count() == 1 => number.abs(),
                    _ => Rational::from(1),
                };
                let inside = self.letters.written(&c.scale(&(Rational::from(1) / &number)));
                let inside = if let ExprKind::Negate(inside) = inside.kind { *inside } else { inside };
                let size = self.letters.of(&apply("sqrt", whole_power(inside, 2)));
                (Polynomial::variable(size).scale(&number), false)
            }
        }
    }
}

/// Points that have a property.
#[derive(Default)]
struct Found {
    /// Each of these has it wherever the facts hold.
    alone: Vec<Point>,
    /// One of these has it.
    together: Vec<Point>,
}

/// Whether whole numbers greater than a value have a property at a place.
fn does_beyond(property: &Prop, own: &str, value: &Expr, place: &Place, turns: &Turns) -> bool {
    let Some(least) = value_here(value, place).filter(|x| x.is_finite()) else { return false };
    BEYOND.iter().all(|k| {
        let mut place = place.clone();
        place.push((own.to_string(), least.floor().max(-1.0) + k));
        truth(property, &mut place, turns) == Some(true)
    })
}

/// How much is written in an expression; a function counts as much as is said, and an absolute value as little as a name where that
/// is little.
fn weight(e: &Expr, function: usize) -> usize {
    if let Some(inside) = under_root(e).filter(|_| function == 1) {
        return weight(&inside, function);
    }
    let mut all = match &e.kind {
        ExprKind::Apply(..) => function,
        ExprKind::Power(_, exponent) if !matches!(exponent.kind, ExprKind::Number(_)) => function,
        _ => 1,
    };
    crate::claim::walk::parts(e, &mut |part| all += weight(part, function));
    all
}

/// Whether a statement is made of comparisons, and of no limit: what is obtained for one number need not stay as that grows.
fn is_of_comparisons(p: &Prop) -> bool {
    match &p.kind {
        PropKind::Compare(..) => true,
        PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => list.iter().all(is_of_comparisons),
        PropKind::Not(p) | PropKind::ForAll(_, p) | PropKind::Exists(_, p) => is_of_comparisons(p),
        PropKind::Implies(p, q) => is_of_comparisons(p) && is_of_comparisons(q),
        _ => false,
    }
}

/// Whether a quantifier stands in a statement.
fn within_a_quantifier(p: &Prop) -> bool {
    match &p.kind {
        PropKind::ForAll(..) | PropKind::Exists(..) => true,
        PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => list.iter().any(within_a_quantifier),
        PropKind::Not(p) => within_a_quantifier(p),
        PropKind::Implies(p, q) => within_a_quantifier(p) || within_a_quantifier(q),
        _ => false,
    }
}

fn halved(e: &Expr) -> Expr {
    over(e.clone(), numeral(2))
}

/// Leaves each expression once.
fn unique(list: &mut Vec<Expr>) {
    let mut seen = BTreeSet::new();
    list.retain(|e| seen.insert(key::expr(e)));
}

/// The ends of the domain of a name.
fn ends_of(bindings: &[Binding], own: &str) -> Vec<Expr> {
    let with = bindings.iter().filter(|b| b.names.iter().any(|n| n.0.text == own));
    let ends = with.flat_map(|b| &b.constraints).flat_map(|c| match c {
        Constraint::Relation(_, end) => vec![end.clone()],
        Constraint::Interval { from, to, .. } | Constraint::Range(from, to) => vec![from.clone(), to.clone()],
    });
    ends.collect()
}

/// The differences of all sides that a statement compares, and the names that it binds, outer ones first.
fn differences_in(p: &Prop, out: &mut Vec<Expr>, within: &mut Vec<String>) {
    match &p.kind {
        PropKind::Compare(sides, _) => out.extend(sides.windows(2).map(|pair| minus(&pair[0], &pair[1]))),
        PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => {
            list.iter().for_each(|p| differences_in(p, out, within));
        }
        PropKind::Not(p) => differences_in(p, out, within),
        PropKind::Implies(p, q) => [p, q].into_iter().for_each(|p| differences_in(p, out, within)),
        PropKind::ForAll(bindings, body) | PropKind::Exists(bindings, body) => {
            within.extend(bindings.iter().flat_map(|b| &b.names).map(|n| n.0.text.clone()));
            bindings.iter().flat_map(domain).for_each(|p| differences_in(&p, out, within));
            differences_in(body, out, within);
        }
        _ => {}
    }
}

/// An expression with u and −u for an absolute value of u that holds a name, and u alone: where that is 0 it turns.
fn without_absolute_values(e: &Expr, own: &str) -> Vec<Expr> {
    let Some(inside) = first_absolute_value(e, own) else { return vec![e.clone()] };
    let absolute = apply("sqrt", whole_power(inside.clone(), 2));
    let mut out = vec![inside.clone()];
    for value in [inside.clone(), super::facts::negated(inside)] {
        let mut plain = e.clone();
        replace(&mut plain, &absolute, &value);
        if key::expr(&plain) == key::expr(e) {
            return vec![e.clone()];
        }
        out.extend(without_absolute_values(&plain, own));
    }
    out
}

fn first_absolute_value(e: &Expr, own: &str) -> Option<Expr> {
    if !holds(e, own) {
        return None;
    }
    if let Some(inside) = under_root(e) {
        return Some(inside);
    }
    let mut found = None;
    crate::claim::walk::parts(e, &mut |part| {
        if found.is_none() {
            found = first_absolute_value(part, own);
        }
    });
    found
}

/// Writes the roots of 0 and 1 as these numbers.
fn without_known_roots(e: &mut Expr) {
    parts_mut(e, &mut without_known_roots);
    if let ExprKind::Apply(f, list) = &e.kind
        && let ("sqrt" | "cbrt", [Expr { kind: ExprKind::Number(k), .. }]) = (f.text.as_str(), list.as_slice())
        && (k == "0" || k == "1")
    {
        *e = list[0].clone();
    }
}

/// The argument of a function, and what it is where the function has a value.
fn inverse(letter: &Expr, value: Expr) -> Option<(Expr, Expr)> {
    if let ExprKind::Apply(f, list) = &letter.kind
        && let [of] = list.as_slice()
    {
        let inverse = match f.text.as_str() {
            "sqrt" => Some(whole_power(value.clone(), 2)),
            "cbrt" => Some(whole_power(value.clone(), 3)),
            "exp" => Some(apply("ln", value.clone())),
            "ln" => Some(apply("exp", value.clone())),
            _ => None,
        };
        return inverse.map(|value| (of.clone(), value));
    }
    let (base, exponent) = as_power(letter)?;
    let power = expr(ExprKind::Power(Box::new(value), Box::new(over(numeral(1), exponent))));
    Some((base, power))
}
