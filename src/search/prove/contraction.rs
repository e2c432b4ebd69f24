//! Limits of sequences whose step brings them nearer to the limit: Heron's u(k + 1) = (u(k) + a/u(k))/2, x(k + 1) = r·x(k)·(1 − x(k)),
//! u(k + 1) = sqrt(2 + u(k)), and families with |x(k + 1)| <= q·|x(k)|.
//!
//! Method (Banach's fixed point theorem): for the step f and the limit L, (f(x) − L)·A = (x − L)·B with the quotient B/A of polynomials
//! or roots. In a region that f does not leave, |B| <= q·A for some q < 1. So |u(k) − L| <= E·c^k with a c from q to 1, by induction, and
//! both bounds have the limit L. Region and q are planned with doubles (`contraction_regions`), which decide nothing. Functions such as
//! the cosine have no A and B: |f(x) − L| <= q·|x − L| is shown on either side of L.
//!
//! Limits: [`STARTS`], [`TRIED`].

use super::contraction_regions::{Orbit, Plan};
use super::facts::{minus, negated};
use super::induction::all;
use super::letters::{as_power, product, total, whole_power};
use super::limits::{holds, over, plus};
use super::slopes::put_in;
use super::sums::replace;
use super::{Fail, Prover, implies};
use crate::algebra::Polynomial;
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::kernel::key;
use crate::kernel::names::names_in;
use crate::kernel::statement::{apply, compare, name, numeral, power, prop};
use crate::refute::literal::literal;
use malachite::Rational;
use std::collections::BTreeSet;

/// The first members after which the region may begin.
const STARTS: u32 = 4;

/// The most letters and numbers that are tried for the q of facts.
const TRIED: usize = 4;

/// Numbers for q.
pub(super) const FACTORS: [(i64, i64); 7] = [(1, 2), (2, 3), (3, 4), (4, 5), (9, 10), (19, 20), (99, 100)];

/// A sequence u with u(k + 1) = f(u(k)).
pub(super) struct Recurrence {
    pub(super) u: String,
    /// u(0), where it is given.
    pub(super) first: Option<Expr>,
    /// A name x, and f(x).
    pub(super) x: String,
    pub(super) step: Expr,
    /// The fact that says so, if it is none of the definition.
    fact: Option<Label>,
}

impl Recurrence {
    fn at(&self, x: &Expr) -> Result<Expr, Fail> {
        put_in(&self.step, &self.x, x)
    }
}

/// (f(x) − L)·A = (x − L)·B.
pub(super) struct Divided {
    pub(super) a: Expr,
    pub(super) b: Expr,
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
        let is_member = !is_built_in(&u.text)
            && matches!(at.as_slice(), [Expr { kind: ExprKind::Name(n), .. }] if *n == l.variable.text);
        if !is_member || self.inductions > 0 || holds(&l.value, &l.variable.text) {
            return Err(no());
        }
        let Some(r) = self.recurrence(&u.text) else { return self.by_shrinking_facts(goal, l, &u.text) };
        let divided = self.step_divided(&r, &l.value);
        let orbits = self.orbits(&r, &l.value).ok_or_else(no)?;
        for start in 0..STARTS {
            for plan in self.plans_of_contraction(&r, &l.value, start, &orbits, divided.as_ref()).unwrap_or_default() {
                let shown = self.on_its_own(|c| c.contracted(goal, l, &r, &plan, divided.as_ref()));
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
        let parts =
            (0..m).map(|i| product(vec![whole_power(r.step.clone(), i), whole_power(limit.clone(), m - 1 - i)]));
        let a = product(vec![total(d), total(parts.map(|e| (Sign::Plus, e)).collect())]);
        Some(Divided { a, b: total(b) })
    }

    /// The limit by a plan.
    fn contracted(
        &mut self,
        goal: &Prop,
        l: &Limit,
        r: &Recurrence,
        plan: &Plan,
        divided: Option<&Divided>,
    ) -> Result<Label, Fail> {
        let q = &plan.factor;
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
        let equation =
            compare(product(vec![e.clone(), a.clone()]), Relation::Equal, product(vec![d.clone(), b.clone()]));
        let equation = self.show(&equation)?;
        let most = product(vec![q.clone(), a.clone()]);
        let above = self.show(&compare(most.clone(), Relation::GreaterEqual, b.clone()))?;
        let below = self.show(&compare(negated(most), Relation::LessEqual, b.clone()))?;
        let sum = plus(&product(vec![e, a.clone()]), product(vec![d.clone(), b]));
        let terms = vec![
            Term { facts: vec![equation], factor: sum },
            Term { facts: vec![below, above], factor: whole_power(d, 2) },
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
                c.combination(
                    goal.clone(),
                    vec![Term { facts: vec![below, above], factor: literal(&Rational::from(-1)) }],
                )
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
        let term =
            |facts: &[&Label], factor: Expr| Term { facts: facts.iter().map(|l| (*l).clone()).collect(), factor };
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
        let part = over(numeral(1), at_start.clone());
        let at_least_zero = compare(square(d.clone()), Relation::GreaterEqual, numeral(0));
        let even = self.combination(at_least_zero, vec![term(&[], square(d.clone()))])?;
        let terms = vec![term(&[&named], minus_one()), term(&[&even], part.clone()), term(&[], part)];
        self.combination(positive, terms)?;
        let k = self.fresh("k");
        let width = |k: &Expr| product(vec![power(&c, k), e.clone()]);
        let near = |k: &Expr, at: &Expr| {
            compare(square(minus(&apply(u, at.clone()), &l.value)), Relation::LessEqual, square(width(k)))
        };
        let mut body = region.iter().map(|p| super::put(p, x, &apply(u, name(&k)))).collect::<Result<Vec<_>, _>>()?;
        body.push(near(&name(&k), &name(&k)));
        let sum = plus(&product(vec![at_start.clone(), e.clone()]), more.clone());
        let terms = vec![
            term(&[&named], product(vec![at_start, sum])),
            term(&[], minus_one()),
            term(&[&even], minus_one()),
            term(&[&even, &even], minus_one()),
        ];
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
        let term =
            |facts: &[&Label], factor: Expr| Term { facts: facts.iter().map(|l| (*l).clone()).collect(), factor };
        let minus_one = || literal(&Rational::from(-1));
        let within = compare(square.clone(), Less, numeral(1));
        let within = self.combination(within, vec![term(&[&low, &high], minus_one())])?;
        let c = name(&self.fresh("c"));
        let mean = over(plus(&numeral(1), square.clone()), numeral(2));
        let named = self.emit(Rule::Name, compare(mean.clone(), Equal, c.clone()))?;
        let half = || over(numeral(1), numeral(2));
        let even = self.combination(
            compare(square.clone(), Relation::GreaterEqual, numeral(0)),
            vec![term(&[], square.clone())],
        )?;
        let terms = vec![term(&[&named], minus_one()), term(&[&even], half()), term(&[], half())];
        self.combination(compare(c.clone(), Greater, numeral(0)), terms)?;
        let terms = vec![term(&[&named], minus_one()), term(&[&within], over(numeral(1), numeral(2)))];
        self.combination(compare(c.clone(), Less, numeral(1)), terms)?;
        let rest = whole_power(minus(&numeral(1), &square), 2);
        let even = compare(rest.clone(), Relation::GreaterEqual, numeral(0));
        let even = self.combination(even, vec![term(&[], rest)])?;
        let quarter = literal(&Rational::from_signeds(-1, 4));
        let terms = vec![term(&[&named], plus(&mean, c.clone())), term(&[&even], quarter)];
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
                    for fact in &facts {
                        let here = c.instance(fact, &name(&k))?;
                        if let Ok(label) = c.by_squares_of_sides(&here, &nearer) {
                            return Ok(label);
                        }
                    }
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

    /// a² <= b² from a <= b, where a + b is not negative by signs.
    fn by_squares_of_sides(&mut self, fact: &str, goal: &Prop) -> Result<Label, Fail> {
        let fact_here = self.fact(fact).ok_or(Fail::No("a fact"))?;
        let (a, relation, b) = super::comparison::single(&fact_here)?;
        let sum = plus(a, b.clone());
        self.enrich(&[a, b]);
        let factor = if relation.is_greater() == Some(true) { negated(sum) } else { sum };
        self.combination(goal.clone(), vec![Term { facts: vec![fact.to_string()], factor }])
    }
}
