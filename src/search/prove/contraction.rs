//! Limits of sequences whose step brings them nearer to the limit: Heron's u(k + 1) = (u(k) + a/u(k))/2, x(k + 1) = r·x(k)·(1 − x(k)),
//! u(k + 1) = sqrt(2 + u(k)), and families with |x(k + 1)| <= q·|x(k)|.
//!
//! Method (Banach's fixed point theorem): for the step f and the limit L, (f(x) − L)·A = (x − L)·B with the quotient B/A of polynomials or
//! roots. In a region that f does not leave, |B| <= q·A for some q < 1. So |u(k) − L| <= E·c^k with a c from q to 1, by induction, and both
//! bounds have the limit L. The region consists of bounds of x by numbers, by L and by the first members; of these the greatest set that
//! f keeps is found with doubles, which decide nothing, and so is q. Functions such as the cosine have no A and B: |f(x) − L| <= q·|x − L|
//! is shown on either side of L.
//!
//! Limits: [`STARTS`], [`PLACES`], [`TRIED`].

use super::facts::{minus, negated};
use super::induction::all;
use super::letters::{as_power, product, total, whole_power};
use super::limits::{holds, over, plus};
use super::slopes::put_in;
use super::sums::replace;
use super::trial_points::{Place, Turns, truth, value_here};
use super::{Fail, Prover, implies};
use crate::algebra::Polynomial;
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::kernel::key;
use crate::kernel::names::names_in;
use crate::kernel::order::Signs;
use crate::kernel::statement::{apply, compare, name, numeral, power, prop};
use crate::refute::literal::literal;
use malachite::Rational;
use malachite::rational::rational::arithmetic::traits::SimplestRationalInInterval;
use std::collections::BTreeSet;

/// The first members after which the region may begin.
const STARTS: u32 = 4;

/// The most values of the letters at which a plan is tried, and the members that are computed there.
const PLACES: usize = 16;
const MEMBERS: usize = 300;

/// The most factors q that are tried for one start.
const TRIED: usize = 3;

/// Numbers for q.
const FACTORS: [(i64, i64); 7] = [(1, 2), (2, 3), (3, 4), (4, 5), (9, 10), (19, 20), (99, 100)];

/// First members that are tried where none is given.
const FIRST: [f64; 6] = [0.3, 1.0, 2.5, 40.0, -0.7, -3.0];

/// What a double may be off.
const OFF: f64 = 1e-9;

/// A sequence u with u(k + 1) = f(u(k)).
struct Recurrence {
    u: String,
    /// u(0), where it is given.
    first: Option<Expr>,
    /// A name x, and f(x).
    x: String,
    step: Expr,
    /// The fact that says so, if it is none of the definition.
    fact: Option<Label>,
}

impl Recurrence {
    fn at(&self, x: &Expr) -> Result<Expr, Fail> {
        put_in(&self.step, &self.x, x)
    }
}

/// (f(x) − L)·A = (x − L)·B.
struct Divided {
    a: Expr,
    b: Expr,
}

/// The values of the letters, and members from 0 on.
struct Orbit {
    place: Place,
    limit: f64,
    members: Vec<f64>,
}

/// From which member on f keeps which region, as propositions about x, and the factors q that seem to do there.
struct Plan {
    start: u32,
    region: Vec<Prop>,
    factors: Vec<Expr>,
}

/// What a step shows of the next member: the equation that gives it, that the step stays in the region, and that it is nearer.
struct Stepped {
    equation: Option<Label>,
    region: Vec<Label>,
    nearer: Label,
}

/// Shows this of the member after k, of which facts say that it is in the region.
type Advance<'a> = dyn FnMut(&mut Prover, &Expr, &[Label]) -> Result<Stepped, Fail> + 'a;

impl Prover {
    /// Shows that the members of a sequence tend to a fixed point of its step.
    pub(super) fn by_contraction(&mut self, goal: &Prop, l: &Limit) -> Result<Label, Fail> {
        let no = || Fail::No("a recurrence that brings its members nearer to the limit");
        let ExprKind::Apply(u, at) = &l.of.kind else { return Err(no()) };
        let is_member = !is_built_in(&u.text) && matches!(at.as_slice(), [Expr { kind: ExprKind::Name(n), .. }] if *n == l.variable.text);
        if !is_member || self.inductions > 0 || holds(&l.value, &l.variable.text) {
            return Err(no());
        }
        let Some(r) = self.recurrence(&u.text) else { return self.by_shrinking_facts(goal, l, &u.text) };
        let divided = self.step_divided(&r, &l.value);
        let orbits = self.orbits(&r, &l.value).ok_or_else(no)?;
        for start in 0..STARTS {
            let Some(plan) = self.plan_of_contraction(&r, &l.value, start, &orbits, divided.as_ref()) else { continue };
            for q in &plan.factors {
                let shown = self.on_its_own(|c| c.contracted(goal, l, &r, &plan, (q, divided.as_ref())));
                if shown.is_ok() {
                    return shown;
                }
            }
        }
        // On which side of the limit the members begin.
        let begins = r.first.clone().unwrap_or_else(|| apply(&r.u, numeral(0)));
        let below = |o: &Orbit| o.members.first().is_some_and(|x| *x < o.limit);
        if orbits.iter().all(below) || !orbits.iter().any(below) {
            return Err(no());
        }
        let mut from = Vec::new();
        for relation in [Relation::LessEqual, Relation::Greater] {
            let case = implies(&compare(begins.clone(), relation, l.value.clone()), goal);
            from.push(self.block(&case, |c, _| c.by_contraction(goal, l))?);
        }
        self.emit(Rule::Logic { from }, goal.clone())
    }

    /// The recurrence of a sequence or family, by its definition or by a fact for all natural numbers.
    fn recurrence(&mut self, u: &str) -> Option<Recurrence> {
        let x = self.fresh("x");
        let in_x = |step: &Expr, k: &str| {
            let mut step = step.clone();
            replace(&mut step, &apply(u, name(k)), &name(&x));
            (!holds(&step, k) && !holds(&step, u)).then_some(step)
        };
        if let Some(s) = self.checker.statement().sequences.iter().find(|s| s.name == u) {
            let step = in_x(&s.step, &s.index)?;
            return Some(Recurrence { u: u.to_string(), first: Some(s.initial.clone()), x, step, fact: None });
        }
        let is_at = |e: &Expr, at: &Expr| key::expr(e) == key::expr(&apply(u, at.clone()));
        let facts = self.facts();
        let (fact, step) = facts.iter().find_map(|(label, fact)| {
            let PropKind::ForAll(bindings, body) = &fact.kind else { return None };
            let [Binding { names, natural: true, constraints, .. }] = bindings.as_slice() else { return None };
            let ([(k, None)], true) = (names.as_slice(), constraints.is_empty()) else { return None };
            let (left, Relation::Equal, right) = body.single()? else { return None };
            let step = is_at(left, &plus(&name(&k.text), numeral(1))).then(|| in_x(right, &k.text))??;
            Some((label.clone(), step))
        })?;
        let first = facts.iter().find_map(|(_, fact)| match fact.single()? {
            (a, Relation::Equal, b) if is_at(a, &numeral(0)) => Some(b.clone()),
            _ => None,
        });
        Some(Recurrence { u: u.to_string(), first, x, step, fact: Some(fact) })
    }

    /// A and B for a step that is a quotient of polynomials, or a root of one. B is what x − L leaves of N − L^m·D, by Horner's scheme.
    fn step_divided(&mut self, r: &Recurrence, limit: &Expr) -> Option<Divided> {
        let root = as_power(&r.step).and_then(|(base, e)| Some((base, self.letters.number(&e)?)));
        let root = root.filter(|(_, e)| *e > 0 && *e < 1 && *e.numerator_ref() == 1u32);
        let (base, m) = match root {
            Some((base, e)) => (base, i64::try_from(e.denominator_ref()).ok()?),
            None => (r.step.clone(), 1),
        };
        let (above, below) = self.letters.quotient(&base)?;
        let (above, below) = (self.by_degrees(&above, &r.x)?, self.by_degrees(&below, &r.x)?);
        let degree = above.keys().chain(below.keys()).max()?.clone();
        let degree = u32::try_from(&degree).ok().filter(|d| (1..=8).contains(d))?;
        if above.keys().chain(below.keys()).any(|d| u32::try_from(d).is_err()) {
            return None;
        }
        let coefficient = |of: &std::collections::BTreeMap<Rational, Polynomial>, i: u32| {
            of.get(&Rational::from(i)).map(|p| self.letters.written(p))
        };
        let (mut b, mut last) = (Vec::new(), numeral(0));
        let mut d = Vec::new();
        for i in (0..=degree).rev() {
            let (n, own) = (coefficient(&above, i), coefficient(&below, i));
            let x = whole_power(name(&r.x), i64::from(i));
            d.extend(own.clone().map(|own| (Sign::Plus, product(vec![own, x]))));
            if i == 0 {
                break;
            }
            let mut terms = vec![(Sign::Plus, product(vec![limit.clone(), last.clone()]))];
            terms.extend(n.map(|n| (Sign::Plus, n)));
            terms.extend(own.map(|own| (Sign::Minus, product(vec![whole_power(limit.clone(), m), own]))));
            last = total(terms);
            b.push((Sign::Plus, product(vec![last.clone(), whole_power(name(&r.x), i64::from(i) - 1)])));
        }
        let parts = (0..m).map(|i| product(vec![whole_power(r.step.clone(), i), whole_power(limit.clone(), m - 1 - i)]));
        let a = product(vec![total(d), total(parts.map(|e| (Sign::Plus, e)).collect())]);
        Some(Divided { a, b: total(b) })
    }

    /// Members at values of the letters, if they tend to the limit wherever this is tried.
    fn orbits(&mut self, r: &Recurrence, limit: &Expr) -> Option<Vec<Orbit>> {
        let mut names = BTreeSet::new();
        [Some(&r.step), Some(limit), r.first.as_ref()].into_iter().flatten().for_each(|e| names_in(e, &mut names));
        names.remove(&r.x);
        let mut places = self.sampled(&names);
        // A number that an equation alone gives, as D = cos(D), is where the members tend.
        let unknown = match &limit.kind {
            ExprKind::Name(n) if places.is_empty() && names.remove(n) => Some(n.clone()),
            _ => None,
        };
        if unknown.is_some() {
            places = self.sampled(&names);
        }
        let zero = apply(&r.u, numeral(0));
        let sign = self.signs_of(&zero);
        let known: Vec<Prop> = self.facts().iter().filter_map(|(_, fact)| about(fact, &zero, &r.x)).collect();
        let mut out = Vec::new();
        for place in places.into_iter().take(PLACES) {
            let first = match &r.first {
                Some(e) => vec![value_here(e, &place)?],
                None => FIRST.to_vec(),
            };
            for x in first {
                let mut here = place.clone();
                here.push((r.x.clone(), x));
                let fits = r.first.is_some() || !(sign.within(Signs::NOT_NEGATIVE) && x < 0.0);
                if !fits || known.iter().any(|p| truth(p, &mut here, &Turns::new()) == Some(false)) {
                    continue;
                }
                let mut members = vec![x];
                for _ in 0..MEMBERS {
                    let next = self.stepped(r, &place, *members.last()?)?;
                    members.push(next);
                }
                let last = *members.last()?;
                let mut place = place.clone();
                place.extend(unknown.iter().map(|n| (n.clone(), last)));
                let limit = value_here(limit, &place)?;
                let far = members.iter().map(|x| (x - limit).abs()).fold(0.0, f64::max);
                if !((last - limit).abs() <= far / 2.0 + OFF) {
                    return None;
                }
                out.push(Orbit { place, limit, members });
            }
        }
        (!out.is_empty()).then_some(out)
    }

    fn stepped(&self, r: &Recurrence, place: &Place, x: f64) -> Option<f64> {
        let mut here = place.clone();
        here.push((r.x.clone(), x));
        value_here(&r.step, &here)
    }

    /// The greatest region of bounds that the step does not leave, and factors for it.
    fn plan_of_contraction(
        &mut self,
        r: &Recurrence,
        limit: &Expr,
        start: u32,
        orbits: &[Orbit],
        divided: Option<&Divided>,
    ) -> Option<Plan> {
        let x = name(&r.x);
        let from = usize::try_from(start).ok()?;
        let members = [apply(&r.u, numeral(start)), apply(&r.u, numeral(start + 1))];
        let mut ends = vec![numeral(0), numeral(1), limit.clone()];
        ends.extend(members.iter().cloned());
        ends.extend(self.numbers_around(r, start, orbits));
        use Relation::{Greater, GreaterEqual, LessEqual};
        let bound = |relation: Relation| ends.iter().map(move |e| (relation, e.clone()));
        let mut region: Vec<(Relation, Expr)> =
            std::iter::once((Greater, numeral(0))).chain(bound(GreaterEqual)).chain(bound(LessEqual)).collect();
        // The members that are bounds are numbers at each place.
        let own: Vec<Place> = orbits
            .iter()
            .map(|o| {
                let mut place = o.place.clone();
                place.extend((0..2).filter_map(|i| Some((key::expr(&members[i]), *o.members.get(from + i)?))));
                place
            })
            .collect();
        let value = |e: &Expr, place: &Place| match members.iter().find(|m| key::expr(m) == key::expr(e)) {
            Some(m) => place.iter().find(|own| own.0 == key::expr(m)).map(|own| own.1),
            None => value_here(e, place),
        };
        let fits = |(relation, e): &(Relation, Expr), x: f64, place: &Place| {
            let Some(e) = value(e, place) else { return false };
            let off = OFF * (x.abs() + e.abs());
            match relation {
                Greater => x > e,
                GreaterEqual => x >= e - off,
                _ => x <= e + off,
            }
        };
        region.retain(|p| orbits.iter().zip(&own).all(|(o, place)| o.members[from..].iter().all(|x| fits(p, *x, place))));
        let (points, ratios) = loop {
            let mut points = Vec::new();
            let mut ratios = Vec::new();
            for (o, place) in orbits.iter().zip(&own) {
                let ends = |up: bool| {
                    let of = region.iter().filter(move |p| (p.0 == LessEqual) == up);
                    of.filter_map(|p| value(&p.1, place)).collect::<Vec<f64>>()
                };
                let low = ends(false).into_iter().fold(f64::NEG_INFINITY, f64::max);
                let high = ends(true).into_iter().fold(f64::INFINITY, f64::min);
                let mut most = 0f64;
                for x in grid(low, high).into_iter().filter(|x| region.iter().all(|p| fits(p, *x, place))) {
                    let next = self.stepped(r, &o.place, x)?;
                    points.push((next, place));
                    if (x - o.limit).abs() > 1e-5 * (1.0 + o.limit.abs()) {
                        most = most.max(((next - o.limit) / (x - o.limit)).abs());
                    }
                }
                ratios.push(most);
            }
            let before = region.len();
            region.retain(|p| points.iter().all(|(x, place)| fits(p, *x, place)));
            if region.len() == before {
                break (points.len(), ratios);
            }
        };
        if points == 0 || ratios.iter().any(|q| !(*q < 1.0)) {
            return None;
        }
        let region = region.into_iter().map(|(relation, e)| compare(x.clone(), relation, e)).collect();
        // Numbers, where the ratios do not depend on the letters; else what B/A is at the limit or at the first member.
        let numbers = FACTORS.iter().map(|(n, d)| literal(&Rational::from_signeds(*n, *d)));
        let mut expressions = Vec::new();
        if let Some(Divided { a, b }) = divided {
            for at in [limit, &members[0]] {
                let quotient = over(put_in(b, &r.x, at).ok()?, put_in(a, &r.x, at).ok()?);
                expressions.extend(self.simplified(&quotient));
            }
        }
        let numbers: Vec<Expr> = numbers.collect();
        let (least, most) = (ratios.iter().copied().fold(1.0, f64::min), ratios.iter().copied().fold(0.0, f64::max));
        let mut factors = if most - least > 0.05 { [expressions, numbers] } else { [numbers, expressions] }.concat();
        factors.retain(|q| {
            own.iter().zip(&ratios).all(|(place, ratio)| {
                let mut q = q.clone();
                members.iter().for_each(|m| replace(&mut q, m, &name(&key::expr(m))));
                value_here(&q, place).is_some_and(|q| q.abs() >= ratio - OFF && q.abs() < 1.0)
            })
        });
        factors.truncate(TRIED);
        Some(Plan { start, region, factors })
    }

    /// Numbers around the members from a start on, and around where the step leads from between them: one orbit alone has such.
    fn numbers_around(&mut self, r: &Recurrence, start: u32, orbits: &[Orbit]) -> Vec<Expr> {
        let [o] = orbits else { return Vec::new() };
        let later = o.members.iter().skip(usize::try_from(start).unwrap_or(0));
        let (mut low, mut high) = later.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(*x), b.max(*x)));
        for _ in 0..MEMBERS {
            for x in grid(low, high) {
                let Some(next) = self.stepped(r, &o.place, x).filter(|x| x.is_finite()) else { return Vec::new() };
                (low, high) = (low.min(next), high.max(next));
            }
        }
        let off = (high - low) / 50.0;
        let simple = |a: f64, b: f64| {
            let (a, b) = (Rational::try_from(a).ok()?, Rational::try_from(b).ok()?);
            (a < b).then(|| literal(&Rational::simplest_rational_in_open_interval(&a, &b)))
        };
        [simple(low - off, low), simple(high, high + off)].into_iter().flatten().collect()
    }

    /// The limit by a plan.
    fn contracted(
        &mut self,
        goal: &Prop,
        l: &Limit,
        r: &Recurrence,
        plan: &Plan,
        (q, divided): (&Expr, Option<&Divided>),
    ) -> Result<Label, Fail> {
        let (x, limit) = (name(&r.x), &l.value);
        let square = |e: Expr| whole_power(e, 2);
        let at_step = plan.region.iter().map(|p| super::put(p, &r.x, &r.step)).collect::<Result<Vec<_>, _>>()?;
        let nearer = compare(
            square(minus(&r.step, limit)),
            Relation::LessEqual,
            product(vec![square(q.clone()), square(minus(&x, limit))]),
        );
        let keeps = all(at_step.iter().cloned().chain([nearer.clone()]).collect());
        let lemma = match plan.region.as_slice() {
            [] => keeps.clone(),
            region => implies(&all(region.to_vec()), &keeps),
        };
        let real = Binding::of(Name::new(&r.x), false, Vec::new());
        let every = prop(PropKind::ForAll(vec![real], Box::new(lemma.clone())));
        let before = std::mem::replace(&mut self.splits, 2);
        let every = self.block(&every, |c, _| {
            let shown = |c: &mut Prover| {
                c.define(&r.step);
                let mut from = at_step.iter().map(|p| c.show(p)).collect::<Result<Vec<_>, _>>()?;
                from.push(match divided {
                    Some(divided) => c.nearer_by_quotient(&nearer, (&x, r, limit), q, divided)?,
                    None => c.nearer_on_each_side(&nearer, (&x, r, limit), q)?,
                });
                c.emit(Rule::Logic { from }, keeps.clone())
            };
            if plan.region.is_empty() { shown(c) } else { c.block(&lemma, |c, _| shown(c)) }
        })?;
        self.splits = before;
        let no = || Fail::No("a member");
        self.falls_to(goal, l, (&r.u, plan.start, q), (&r.x, &plan.region), &mut |c, k, parts| {
            let here = apply(&r.u, k.clone());
            let step = r.at(&here)?;
            let equation = compare(apply(&r.u, plus(k, numeral(1))), Relation::Equal, step);
            let equation = match &r.fact {
                Some(fact) => c.instance(fact, k)?,
                None => c.show(&equation)?,
            };
            let mut from = vec![c.instance_alone(&every, &here)?.0];
            from.extend(parts.iter().cloned());
            let mut keeps_here = Vec::new();
            for p in at_step.iter().chain([&nearer]) {
                let p = super::put(p, &r.x, &here)?;
                keeps_here.push(c.emit(Rule::Logic { from: from.clone() }, p)?);
            }
            let nearer = keeps_here.pop().ok_or_else(no)?;
            Ok(Stepped { equation: Some(equation), region: keeps_here, nearer })
        })
    }

    /// (f(x) − L)² <= q²·(x − L)², from −q·A <= B <= q·A.
    fn nearer_by_quotient(
        &mut self,
        goal: &Prop,
        (x, r, limit): (&Expr, &Recurrence, &Expr),
        q: &Expr,
        Divided { a, b }: &Divided,
    ) -> Result<Label, Fail> {
        let (e, d) = (minus(&r.step, limit), minus(x, limit));
        let sign = |c: &mut Prover, relation| c.attempt(|c| c.show(&compare(a.clone(), relation, numeral(0))));
        let (a, b) = match sign(self, Relation::Greater) {
            Ok(_) => (a.clone(), b.clone()),
            Err(_) => {
                sign(self, Relation::Less)?;
                (negated(a.clone()), negated(b.clone()))
            }
        };
        let equation = compare(product(vec![e.clone(), a.clone()]), Relation::Equal, product(vec![d.clone(), b.clone()]));
        let equation = self.show(&equation)?;
        let most = product(vec![q.clone(), a.clone()]);
        let above = self.show(&compare(b.clone(), Relation::LessEqual, most.clone()))?;
        let below = self.show(&compare(negated(most), Relation::LessEqual, b.clone()))?;
        let sum = plus(&product(vec![e, a.clone()]), product(vec![d.clone(), b]));
        let terms = vec![
            Term { facts: vec![equation], factor: sum },
            Term { facts: vec![below, above], factor: negated(whole_power(d, 2)) },
        ];
        self.emit(Rule::Combination { times: Some(whole_power(a, 2)), terms }, goal.clone())
    }

    /// The same for any step, from −q·|x − L| <= f(x) − L <= q·|x − L| for x on each side of L.
    fn nearer_on_each_side(
        &mut self,
        goal: &Prop,
        (x, r, limit): (&Expr, &Recurrence, &Expr),
        q: &Expr,
    ) -> Result<Label, Fail> {
        let e = minus(&r.step, limit);
        let mut from = Vec::new();
        for relation in [Relation::GreaterEqual, Relation::LessEqual] {
            let side = implies(&compare(x.clone(), relation, limit.clone()), goal);
            let d = if relation == Relation::LessEqual { minus(limit, x) } else { minus(x, limit) };
            let most = product(vec![q.clone(), d]);
            from.push(self.block(&side, |c, _| {
                let above = c.show(&compare(e.clone(), Relation::LessEqual, most.clone()))?;
                let below = c.show(&compare(negated(most.clone()), Relation::LessEqual, e.clone()))?;
                c.combination(goal.clone(), vec![Term { facts: vec![below, above], factor: literal(&Rational::from(-1)) }])
            })?);
        }
        self.emit(Rule::Logic { from }, goal.clone())
    }

    /// The limit of members in a region, where each is nearer by the factor q than the one before: by induction (u(k) − L)² <= (c^k)²·E²,
    /// and a squeeze.
    fn falls_to(
        &mut self,
        goal: &Prop,
        l: &Limit,
        (u, start, q): (&str, u32, &Expr),
        (x, region): (&str, &[Prop]),
        advance: &mut Advance<'_>,
    ) -> Result<Label, Fail> {
        let square = |e: Expr| whole_power(e, 2);
        let term = |facts: &[&Label], factor: Expr| Term { facts: facts.iter().map(|l| (*l).clone()).collect(), factor };
        let minus_one = || literal(&Rational::from(-1));
        let (c, no_less) = self.factor_within_one(q)?;
        let first = apply(u, numeral(start));
        self.define(&first);
        // E·c^start = 1 + (u(start) − L)², which is at least |u(start) − L|.
        let d = minus(&first, &l.value);
        let more = plus(&numeral(1), square(d.clone()));
        let at_start = whole_power(c.clone(), i64::from(start));
        let e = name(&self.fresh("e"));
        let own = over(more.clone(), at_start.clone());
        let named = self.emit(Rule::Name, compare(own.clone(), Relation::Equal, e.clone()))?;
        let positive = compare(e.clone(), Relation::Greater, numeral(0));
        self.combination(positive, vec![term(&[&named], minus_one()), term(&[], own)])?;
        let k = self.fresh("k");
        let width = |k: &Expr| product(vec![power(&c, k), e.clone()]);
        let near = |k: &Expr, at: &Expr| {
            compare(square(minus(&apply(u, at.clone()), &l.value)), Relation::LessEqual, square(width(k)))
        };
        let mut body = region.iter().map(|p| super::put(p, x, &apply(u, name(&k)))).collect::<Result<Vec<_>, _>>()?;
        body.push(near(&name(&k), &name(&k)));
        let sum = plus(&product(vec![at_start.clone(), e.clone()]), more.clone());
        let rest = plus(&more, whole_power(d, 4));
        let terms = vec![term(&[&named], product(vec![at_start, sum])), term(&[], negated(rest))];
        self.combination(near(&numeral(start), &numeral(start)), terms)?;
        self.inductions += 1;
        let base = Some(start).filter(|k| *k > 0);
        let every = self.induction_by(&k, base, &all(body.clone()), &mut |p, hypothesis, next| {
            let k = name(&k);
            let mut parts = Vec::new();
            for part in &body {
                parts.push(p.logic(&[&hypothesis], part)?);
            }
            let near_here = parts.pop().ok_or(Fail::No("a hypothesis"))?;
            let step = advance(p, &k, &parts)?;
            step.equation.iter().for_each(|label| p.put_in(label));
            let after = match &next.kind {
                PropKind::And(after) => after.clone(),
                _ => vec![next.clone()],
            };
            let mut from = Vec::new();
            for (kept, part) in step.region.iter().zip(&after) {
                from.push(p.combination(part.clone(), vec![term(&[kept], numeral(1))])?);
            }
            let d = square(minus(&apply(u, k.clone()), &l.value));
            let mut terms = vec![term(&[&step.nearer], numeral(1)), term(&[&near_here], square(c.clone()))];
            terms.extend(no_less.iter().map(|label| term(&[label], d.clone())));
            from.push(p.combination(after.last().unwrap_or(next).clone(), terms)?);
            p.emit(Rule::Logic { from }, next.clone())
        })?;
        self.inductions -= 1;
        let width_here = width(&name(&l.variable.text));
        let (lower, upper) = (minus(&l.value, &width_here), plus(&l.value, width_here));
        self.squeeze(goal, l, [&lower, &upper], &numeral(start), &mut |p, k, every_bound, bound| {
            p.block(every_bound, |p, _| {
                let here = p.instance(&every, k)?;
                p.logic(&[&here], &near(k, k))?;
                p.show(bound)
            })
        })
    }

    /// A number c from |q| to 1, and the fact q² <= c² where it is another one: q, or the mean of 1 and q².
    fn factor_within_one(&mut self, q: &Expr) -> Result<(Expr, Option<Label>), Fail> {
        if self.letters.number(q).is_some() {
            return Ok((q.clone(), None));
        }
        use Relation::{Equal, Greater, Less, LessEqual};
        let from = [compare(literal(&Rational::from(-1)), Less, q.clone()), compare(q.clone(), Less, numeral(1))];
        let [low, high] = [self.show(&from[0])?, self.show(&from[1])?];
        let square = whole_power(q.clone(), 2);
        let term = |facts: &[&Label], factor: Expr| Term { facts: facts.iter().map(|l| (*l).clone()).collect(), factor };
        let minus_one = || literal(&Rational::from(-1));
        let within = compare(square.clone(), Less, numeral(1));
        let within = self.combination(within, vec![term(&[&low, &high], minus_one())])?;
        let c = name(&self.fresh("c"));
        let mean = over(plus(&numeral(1), square.clone()), numeral(2));
        let named = self.emit(Rule::Name, compare(mean.clone(), Equal, c.clone()))?;
        let terms = vec![term(&[&named], minus_one()), term(&[], mean.clone())];
        self.combination(compare(c.clone(), Greater, numeral(0)), terms)?;
        let terms = vec![term(&[&named], minus_one()), term(&[&within], over(numeral(1), numeral(2)))];
        self.combination(compare(c.clone(), Less, numeral(1)), terms)?;
        let rest = over(whole_power(minus(&numeral(1), &square), 2), numeral(4));
        let terms = vec![term(&[&named], plus(&mean, c.clone())), term(&[], negated(rest))];
        let no_less = self.combination(compare(square, LessEqual, whole_power(c.clone(), 2)), terms)?;
        Ok((c, Some(no_less)))
    }

    /// The limit of a family of which facts for all natural numbers say how much nearer each member is: |x(k + 1)| <= q·|x(k)|.
    fn by_shrinking_facts(&mut self, goal: &Prop, l: &Limit, u: &str) -> Result<Label, Fail> {
        let no = || Fail::No("facts that bring members nearer");
        let mut sides = Vec::new();
        let mut facts = Vec::new();
        for (label, fact) in self.facts() {
            let PropKind::ForAll(bindings, body) = &fact.kind else { continue };
            let [Binding { names, natural: true, .. }] = bindings.as_slice() else { continue };
            let next = names.first().map(|k| apply(u, plus(&name(&k.0.text), numeral(1))));
            let mut own = Vec::new();
            super::goals::sides_in(body, &mut own);
            if next.is_some_and(|next| own.iter().any(|e| super::sums::occurs(&next, e))) {
                facts.push(label);
                sides.extend(own);
            }
        }
        let mut names = BTreeSet::new();
        sides.iter().for_each(|e| names_in(e, &mut names));
        names.retain(|n| n != u && self.is_a_name(n) && !holds(&l.value, n));
        let letters = names.iter().map(|n| name(n)).filter(|q| !self.is_whole(q));
        let numbers = FACTORS.iter().map(|(n, d)| literal(&Rational::from_signeds(*n, *d)));
        let factors: Vec<Expr> = letters.chain(numbers).take(if facts.is_empty() { 0 } else { TRIED }).collect();
        for q in factors {
            let shown = self.on_its_own(|c| {
                let k = c.fresh("k");
                let d = |at: &Expr| whole_power(minus(&apply(u, at.clone()), &l.value), 2);
                let (here, next) = (d(&name(&k)), d(&plus(&name(&k), numeral(1))));
                let nearer = compare(next, Relation::LessEqual, product(vec![whole_power(q.clone(), 2), here]));
                let binding = Binding::of(Name::new(&k), true, Vec::new());
                let every = prop(PropKind::ForAll(vec![binding], Box::new(nearer.clone())));
                let before = std::mem::replace(&mut c.splits, 2);
                let every = c.block(&every, |c, _| {
                    facts.iter().try_for_each(|fact| c.instance(fact, &name(&k)).map(|_| ()))?;
                    c.show(&nearer)
                })?;
                c.splits = before;
                c.falls_to(goal, l, (u, 0, &q), ("", &[]), &mut |c, k, _| {
                    let nearer = c.instance_alone(&every, k)?.0;
                    Ok(Stepped { equation: None, region: Vec::new(), nearer })
                })
            });
            if shown.is_ok() {
                return shown;
            }
        }
        Err(no())
    }
}

/// What a fact says of one member, with x in its place.
fn about(fact: &Prop, member: &Expr, x: &str) -> Option<Prop> {
    let PropKind::Compare(sides, relations) = &fact.kind else { return None };
    let mut sides = sides.clone();
    sides.iter_mut().for_each(|e| replace(e, member, &name(x)));
    Some(prop(PropKind::Compare(sides, relations.clone()))).filter(|p| key::prop(p) != key::prop(fact))
}

/// Numbers between two ends, which may be infinite: these, and numbers near them and far from them.
fn grid(low: f64, high: f64) -> Vec<f64> {
    let parts = (1..24).map(|i| f64::from(i) / 24.0).chain([0.0, 1e-6, 1e-3, 1.0 - 1e-3, 1.0 - 1e-6, 1.0]);
    let far = (-6..=6).map(|i| 10f64.powi(i)).flat_map(|x| [x, 2.0 * x, 5.0 * x]).chain([0.0]);
    match (low.is_finite(), high.is_finite()) {
        (true, true) => parts.map(|t| low + (high - low) * t).collect(),
        (true, false) => far.map(|x| low + x).collect(),
        (false, true) => far.map(|x| high - x).collect(),
        (false, false) => far.flat_map(|x| [x, -x]).collect(),
    }
}
