//! Goals, split at their connectives.

use super::facts::opposite;
use super::letters::product;
use super::{Fail, Prover, implies};
use crate::certificate::{Label, Rule};
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, domain, name, numeral, prop};
use crate::kernel::substitution::Substitution;
use crate::refute::literal::literal;
use crate::refute::sample::example;
use malachite::Rational;
use std::collections::BTreeSet;

/// The numbers tried as N in statements of the kind "for all n >= N".
const FAR_ENOUGH: [i32; 4] = [1, 2, 10, 100];

/// The natural number at which an example is sought that may serve all.
const ELSEWHERE: u32 = 7;

impl Prover {
    /// Proves a goal and returns the label of the fact.
    pub(crate) fn show(&mut self, goal: &Prop) -> Result<Label, Fail> {
        self.tick()?;
        if let Some(label) = self.known(goal) {
            return Ok(label);
        }
        if self.splits < 8
            && let Some(Ok(label)) = self.by_existence(goal)
        {
            return Ok(label);
        }
        match &goal.kind {
            PropKind::Compare(sides, relations) if relations.len() == 1 => {
                if let Some(entries) = entries_of(sides, relations[0]) {
                    return self.attempt(|c| c.by_entries(goal, entries));
                }
                self.comparison_or_parts(goal)
            }
            PropKind::Compare(sides, relations) => {
                let pairs = sides.windows(2).zip(relations);
                let parts: Vec<Prop> = pairs.map(|(p, r)| compare(p[0].clone(), *r, p[1].clone())).collect();
                if self.inductions == 0
                    && self.splits == 0
                    && self.has_powers_of_both(sides)
                    && let Ok(label) = self.attempt(|c| c.show_all(goal, &parts))
                {
                    return Ok(label);
                }
                // Two bounds may need each other in the step of an induction.
                self.by_induction(goal).or_else(|_| self.show_all(goal, &parts))
            }
            PropKind::And(parts) => match self.attempt(|c| c.show_all(goal, parts)) {
                Ok(label) => Ok(label),
                // In the step of an induction they may need each other.
                Err(first) => self.by_induction(goal).map_err(|_| first),
            },
            PropKind::Or(parts) => self.show_or(goal, parts),
            PropKind::Not(inner) if matches!(inner.kind, PropKind::ForAll(..)) => {
                match self.attempt(|c| c.by_failing_instance(goal, inner)) {
                    Ok(label) => Ok(label),
                    Err(first) => self.attempt(|c| c.not_from_some_number_on(goal, inner)).map_err(|_| first),
                }
            }
            PropKind::Not(inner) if matches!(inner.kind, PropKind::Exists(..)) => self.by_no_example(goal, inner),
            PropKind::Not(inner) => {
                let p = opposite(inner).ok_or(Fail::No("a negation that is not followed"))?;
                let label = self.show(&p)?;
                self.logic(&[&label], goal)
            }
            PropKind::Implies(p, q) => {
                self.define_sides(p);
                self.block(goal, |c, _| {
                    c.solve_equations();
                    c.show(q)
                })
            }
            PropKind::Equivalent(parts) => {
                let mut from = Vec::new();
                for pair in parts.windows(2) {
                    for (p, q) in [(&pair[0], &pair[1]), (&pair[1], &pair[0])] {
                        from.push(self.show(&implies(p, q))?);
                    }
                }
                self.emit(Rule::Logic { from }, goal.clone())
            }
            PropKind::ForAll(_, body) => match self.attempt(|c| c.block(goal, |c, _| c.show(body))) {
                Ok(label) => Ok(label),
                Err(first) => self.all_by_induction(goal, 0).map_err(|_| first),
            },
            PropKind::Exists(bindings, body) => {
                let first = match self.attempt(|c| c.by_witness(goal, bindings, body)) {
                    Ok(label) => return Ok(label),
                    Err(fail) => fail,
                };
                if self.splits < 3
                    && let Ok(label) = self.by_disjunction(goal)
                {
                    return Ok(label);
                }
                // Of exponents and of the ends of sums induction mostly tells more.
                let is_bound =
                    self.naturals.iter().any(|n| super::induction::is_bound_within(together(bindings, body).1, n));
                if !is_bound && let Ok(label) = self.by_residues(goal) {
                    return Ok(label);
                }
                let shown = self.by_induction(goal);
                let shown = if is_bound { shown.or_else(|_| self.by_residues(goal)) } else { shown };
                shown.map_err(|_| first)
            }
            PropKind::Extremum(e) => self.extremum(goal, e),
            PropKind::Limit(l) => self.limit(goal, l),
            PropKind::WrittenLimit(_) => Err(Fail::No("a limit as it is written")),
        }
    }

    /// Proves the conditions under which the sides of comparisons have values.
    pub(super) fn define_sides(&mut self, p: &Prop) {
        let mut sides = Vec::new();
        sides_in(p, &mut sides);
        sides.iter().for_each(|e| self.define(e));
    }

    /// Proves `exists` by values: from elimination, small ones, from equations.
    pub(super) fn by_witness(&mut self, goal: &Prop, bindings: &[Binding], body: &Prop) -> Result<Label, Fail> {
        // For a bound by a multiple hardly anything else is left to try.
        let is_multiple = bindings.iter().map(|b| b.names.len()).sum::<usize>() > 1;
        let far = |c: &mut Prover| c.by_eventually(goal, bindings, body);
        if let Ok(label) = if is_multiple { self.attempt(far) } else { self.with_half(far) } {
            return Ok(label);
        }
        if let Ok(label) = self.by_elimination(goal, bindings, body) {
            return Ok(label);
        }
        if let Ok(label) = self.attempt(|c| c.by_natural_values(goal, bindings, body)) {
            return Ok(label);
        }
        if let Ok(label) = self.attempt(|c| c.by_far_members(goal, bindings, body)) {
            return Ok(label);
        }
        let (all, inner) = together(bindings, body);
        let mut point: Vec<(String, Expr)> = match self.example(&all, inner) {
            Some(point) => point,
            None if matches!(body.kind, PropKind::ForAll(..)) => {
                return self.by_turning_values(goal, bindings, body).or_else(|_| self.far_enough(goal, bindings, body));
            }
            None if let Ok(label) = self.by_example_of_a_unit(goal, bindings, body) => return Ok(label),
            None => match self.solved(&all, inner) {
                Some(point) => point,
                None => {
                    return self
                        .with_half(|c| c.by_equations(goal, bindings, body))
                        .or_else(|_| self.by_intermediate_value(goal, bindings, body))
                        .or_else(|_| self.with_solved_equations(|c| c.by_equations(goal, bindings, body)))
                        .or_else(|_| self.on_its_own(|c| c.by_a_far_number(goal, bindings, body)))
                        .or_else(|_| self.by_turning_values(goal, bindings, body));
                }
            },
        };
        point.retain(|(n, _)| bindings.iter().flat_map(|b| &b.names).any(|own| own.0.text == *n));
        self.by_values(goal, bindings, body, point)
    }

    /// Proves `exists` by values from its equations.
    pub(super) fn by_equations(&mut self, goal: &Prop, bindings: &[Binding], body: &Prop) -> Result<Label, Fail> {
        self.by_solved_equations(goal, bindings, body).or_else(|_| self.by_solved_difference(goal, bindings, body))
    }

    /// Numbers for the variables of an `exists` that make its body true, where facts give other variables as numbers.
    pub(super) fn example(&self, bindings: &[Binding], body: &Prop) -> Option<Vec<(String, Expr)>> {
        let mut map = Substitution::default();
        for (_, fact) in self.checker.facts() {
            if let Some((Expr { kind: ExprKind::Name(n), .. }, Relation::Equal, value)) = fact.single()
                && crate::claim::definedness::number(value).is_some()
            {
                map.replace(n, value);
            }
        }
        let said = map.prop(&prop(PropKind::Exists(bindings.to_vec(), Box::new(body.clone())))).ok()?;
        let PropKind::Exists(bindings, body) = &said.kind else { return None };
        let point = example(bindings, body, self.deadline)?;
        Some(point.into_iter().map(|(n, v)| (n, literal(&v))).collect())
    }

    /// Proves `exists` beside one variable v by values where v is a number: real ones at 1 as multiples of v, as where all have one
    /// unit, natural ones as they are.
    fn by_example_of_a_unit(&mut self, goal: &Prop, bindings: &[Binding], body: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("a witness");
        let mut free = variables_of(goal);
        let (Some(v), None) = (free.pop_first(), free.pop_first()) else { return Err(no()) };
        if self.checker.statement().sequences.iter().any(|s| s.name == v) {
            return Err(no());
        }
        let natural = self.naturals.contains(&v);
        let (mut at_number, number) = (Substitution::default(), numeral(if natural { ELSEWHERE } else { 1 }));
        at_number.replace(&v, &number);
        let there = at_number.prop(goal).map_err(Fail::from)?;
        let PropKind::Exists(own, inner) = &there.kind else { return Err(no()) };
        let (all, inner) = together(own, inner);
        let mut point = self.example(&all, inner).or_else(|| self.solved(&all, inner)).ok_or_else(no)?;
        if !natural {
            point.iter_mut().for_each(|(_, value)| *value = product(vec![value.clone(), name(&v)]));
        }
        self.attempt(|c| c.by_values(goal, bindings, body, point))
    }

    /// Proves `exists` with these values.
    pub(super) fn by_values(
        &mut self,
        goal: &Prop,
        bindings: &[Binding],
        body: &Prop,
        point: Vec<(String, Expr)>,
    ) -> Result<Label, Fail> {
        let natural = |n: &str| bindings.iter().any(|b| b.natural && b.names.iter().any(|own| own.0.text == *n));
        for (_, value) in point.iter().filter(|p| natural(&p.0)) {
            // The step reads its sign.
            if self.signs_of(value).within(Signs::NOT_NEGATIVE) {
                continue;
            }
            let sign = compare(value.clone(), Relation::GreaterEqual, numeral(0));
            let label = self.show(&sign)?;
            // That of q*(36*q^2 - 1) is read where q is 0, and where it is not.
            if !self.signs_of(value).within(Signs::NOT_NEGATIVE)
                && let Some(factor) = self.open_factor(value)
            {
                let mut from = Vec::new();
                for relation in [Relation::Equal, Relation::NotEqual] {
                    let case = compare(factor.clone(), relation, numeral(0));
                    from.push(self.block(&implies(&case, goal), |c, _| {
                        c.logic(&[&label], &sign)?;
                        c.by_values(goal, bindings, body, point.clone())
                    })?);
                }
                return self.emit(Rule::Logic { from }, goal.clone());
            }
        }
        let (with, map) = at(point);
        let mut from = Vec::new();
        for fact in bindings.iter().flat_map(domain).chain([body.clone()]) {
            from.push(self.show(&map.prop(&fact).map_err(Fail::from)?)?);
        }
        self.emit(Rule::Witness { with, from }, goal.clone())
    }

    /// A factor of an expression that is not negative, and perhaps 0.
    fn open_factor(&mut self, e: &Expr) -> Option<Expr> {
        let reading = self.read(e, true)?;
        let mut open = reading.factors.iter().filter(|f| f.signs == Signs::NOT_NEGATIVE && !f.poly.is_constant());
        open.next().map(|f| self.letters.written(&f.poly))
    }

    /// Proves `exists N: for all n …`. Trying values of n cannot find such an N, so a few values of N are tried.
    fn far_enough(&mut self, goal: &Prop, bindings: &[Binding], body: &Prop) -> Result<Label, Fail> {
        let mut last = Err(Fail::No("a witness"));
        if let [Binding { names, .. }] = bindings
            && let [(name, None)] = names.as_slice()
        {
            for k in FAR_ENOUGH {
                let point = vec![(name.text.clone(), literal(&Rational::from(k)))];
                last = self.attempt(|c| c.by_values(goal, bindings, body, point));
                if last.is_ok() {
                    break;
                }
            }
        }
        last
    }

    /// Proves an equation of matrices by those of its entries.
    fn by_entries(&mut self, goal: &Prop, entries: Vec<Prop>) -> Result<Label, Fail> {
        if let Ok(label) = self.combination(goal.clone(), Vec::new()) {
            return Ok(label);
        }
        let all = match entries.as_slice() {
            [only] => self.show(only)?,
            _ => {
                // The entries of a power need each other, so the induction for all of them comes first.
                let together = prop(PropKind::And(entries.clone()));
                self.by_induction(&together).or_else(|_| self.show_all(&together, &entries))?
            }
        };
        for entry in &entries {
            let label = match self.known(entry) {
                Some(label) => label,
                None => self.logic(&[&all], entry)?,
            };
            self.put_in(&label);
        }
        self.combination(goal.clone(), Vec::new())
    }

    fn show_all(&mut self, goal: &Prop, parts: &[Prop]) -> Result<Label, Fail> {
        // Outside of cases and inductions each part may cost what a claim may.
        let whole = self.splits == 0 && self.inductions == 0;
        let mut show = |p| if whole { self.on_its_own(|c| c.show(p)) } else { self.show(p) };
        // The part that remains is named.
        let from = parts.iter().map(|p| show(p).map_err(|fail| fail.of_goal(p))).collect::<Result<Vec<_>, _>>()?;
        self.emit(Rule::Logic { from }, goal.clone())
    }

    fn show_or(&mut self, goal: &Prop, parts: &[Prop]) -> Result<Label, Fail> {
        self.define_sides(goal);
        if let Ok(label) = self.logic(&[], goal) {
            return Ok(label);
        }
        if let Ok(label) = self.by_quarters(goal) {
            return Ok(label);
        }
        if self.splits < 8
            && let Ok(label) = self.attempt(|c| c.by_opposite(goal)).or_else(|_| self.by_boxes(goal))
        {
            return Ok(label);
        }
        for part in parts {
            if let Ok(label) = self.quietly(part) {
                return self.logic(&[&label], goal);
            }
        }
        if Self::has_a_floor(goal)
            && let Ok(label) = self.by_residues(goal)
        {
            return Ok(label);
        }
        // Suppose that one part is false and prove the others: that of the first or of the last, those that become equations first.
        let (first, last) = (0, parts.len().saturating_sub(1));
        let mut shown = Err(Fail::No("an empty disjunction"));
        let becomes_equation = |k: &usize| matches!(parts.get(*k).map(|p| &p.kind), Some(PropKind::Compare(_, r)) if *r == [Relation::NotEqual]);
        let mut places = [first, last];
        places.sort_by_key(|k| !becomes_equation(k));
        for place in places {
            let Some(denied) = parts.get(place) else { break };
            let mut rest: Vec<Prop> = parts.iter().enumerate().filter(|p| p.0 != place).map(|p| p.1.clone()).collect();
            let rest = match (rest.len(), rest.pop()) {
                (1, Some(only)) => only,
                (_, other) => prop(PropKind::Or(rest.into_iter().chain(other).collect())),
            };
            let other = opposite(denied).ok_or(Fail::No("an opposite"))?;
            // What one way cost is not taken from the other.
            let done = self.on_its_own(|c| {
                let block = c.block(&implies(&other, &rest), |c, _| c.show(&rest))?;
                c.logic(&[&block], goal)
            });
            match done {
                Ok(label) => return Ok(label),
                Err(fail) if place == first => shown = Err(fail),
                Err(_) => {}
            }
        }
        shown
    }

    /// A shorter form of an expression.
    pub(super) fn simplified(&mut self, e: &Expr) -> Option<Expr> {
        self.define(e);
        let reading = self.read(e, false)?;
        let mut factors = Vec::new();
        if reading.factors.is_empty() || reading.number != 1 {
            factors.push(literal(&reading.number));
        }
        for f in &reading.factors {
            factors.push(super::letters::whole_power(self.letters.written(&f.poly), f.power));
        }
        Some(product(factors))
    }

    /// Runs something in a block in which a name is bound; no step of it is kept.
    pub(super) fn where_it_is_bound(&mut self, binding: Binding, run: impl FnOnce(&mut Self)) {
        let own = name(&binding.names[0].0.text);
        let itself = compare(own.clone(), Relation::Equal, own);
        let every = prop(PropKind::ForAll(vec![binding], Box::new(itself)));
        let _ = self.attempt(|c| {
            c.block(&every, |c, _| {
                run(c);
                Err(Fail::No("nothing to show"))
            })
        });
    }

    /// An instance of a `for all` fact with one variable.
    pub(crate) fn instance(&mut self, source: &str, value: &Expr) -> Result<Label, Fail> {
        let (label, shown, is_new) = self.instance_alone(source, value)?;
        if is_new {
            self.take_in(&label, &shown)?;
        }
        Ok(label)
    }

    /// The same, of which nothing else is concluded: its label, what it says, and whether it is a new fact.
    pub(super) fn instance_alone(&mut self, source: &str, value: &Expr) -> Result<(Label, Prop, bool), Fail> {
        let variable = match self.fact(source).map(|fact| fact.kind) {
            Some(PropKind::ForAll(bindings, _)) => match bindings.as_slice() {
                [Binding { names, .. }] if matches!(names.as_slice(), [(_, None)]) => names[0].0.text.clone(),
                _ => return Err(Fail::No("one variable")),
            },
            _ => return Err(Fail::No("a fact for all values")),
        };
        self.instantiated(source, vec![(variable, value.clone())])
    }

    /// An instance of a fact `for all` at a point, taken in also where it was known.
    pub(super) fn instance_at(&mut self, source: &str, point: Vec<(String, Expr)>) -> Result<Label, Fail> {
        let (label, shown, _) = self.instantiated(source, point)?;
        self.take_in(&label, &shown)?;
        Ok(label)
    }

    /// An instance of a fact `for all`: its label, what it says, and whether it is a new fact.
    fn instantiated(&mut self, source: &str, point: Vec<(String, Expr)>) -> Result<(Label, Prop, bool), Fail> {
        let Some(Prop { kind: PropKind::ForAll(bindings, body), .. }) = self.fact(source) else {
            return Err(Fail::No("a fact for all values"));
        };
        let (with, map) = at(point);
        let mut from = Vec::new();
        for fact in bindings.iter().flat_map(domain) {
            let goal = map.prop(&fact).map_err(Fail::from)?;
            let known = self.known(&goal).map_or_else(|| self.attempt(|c| c.by_linear_facts(&goal)), Ok);
            from.push(known.or_else(|_| self.quietly(&goal))?);
        }
        let shown = map.prop(&body).map_err(Fail::from)?;
        if let Some(label) = self.known(&shown) {
            return Ok((label, shown, false));
        }
        let label = self.emit(Rule::Instance { source: source.to_string(), with, from }, shown.clone())?;
        Ok((label, shown, true))
    }
}

/// A point as a step says it, and as a substitution.
pub(super) fn at(point: Vec<(String, Expr)>) -> (Vec<(Name, Expr)>, Substitution) {
    let mut map = Substitution::default();
    point.iter().for_each(|(name, value)| map.replace(name, value));
    let with = point.into_iter().map(|(text, value)| (Name::new(text), value));
    (with.collect(), map)
}

/// The bindings of `exists` and of each `exists` directly in it, and what stands behind them.
pub(crate) fn together<'p>(bindings: &[Binding], body: &'p Prop) -> (Vec<Binding>, &'p Prop) {
    let (mut all, mut inner) = (bindings.to_vec(), body);
    while let PropKind::Exists(more, body) = &inner.kind {
        all.extend(more.iter().cloned());
        inner = body;
    }
    (all, inner)
}

/// The free names of a proposition, but those of the language.
pub(super) fn variables_of(p: &Prop) -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    crate::kernel::names::free_names(p, &mut names);
    names.retain(|n| n != PI && !is_built_in(n));
    names
}

/// The sides of every comparison in a proposition, but for those under quantifiers.
pub(crate) fn sides_in(p: &Prop, out: &mut Vec<Expr>) {
    match &p.kind {
        PropKind::Compare(sides, _) => out.extend(sides.iter().cloned()),
        PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => {
            list.iter().for_each(|p| sides_in(p, out));
        }
        PropKind::Not(inner) => sides_in(inner, out),
        PropKind::Implies(a, b) => {
            sides_in(a, out);
            sides_in(b, out);
        }
        _ => {}
    }
}

/// The equations of the entries of two matrices that are written out.
fn entries_of(sides: &[Expr], relation: Relation) -> Option<Vec<Prop>> {
    let [a, b] = sides else { return None };
    let matrices = crate::claim::matrix::Matrices::default();
    let (a, b) = (matrices.entries(a).ok()??, matrices.entries(b).ok()??);
    let same = a.len() == b.len() && a.iter().zip(&b).all(|(a, b)| a.len() == b.len());
    let pairs = a.into_iter().flatten().zip(b.into_iter().flatten());
    let entries: Vec<Prop> = pairs.map(|(a, b)| compare(a, Relation::Equal, b)).collect();
    (relation == Relation::Equal && same && !entries.is_empty()).then_some(entries)
}
