//! Limits by asymptotic expansion: between two bounds that are sums of powers of the variable x, whose limits are seen by degrees.
//!
//! Method: `asymptotic_bounds` finds the bounds. In a block "for all k from some number on" each atom is shown to lie between
//! its bounds, the innermost first, and then the expression between its own. The statements about Taylor's polynomials are shown
//! outside, by the sign of a derivative or by powers.
//!
//! Limits: [`ORDERS`], [`ROOTS`] and those of `asymptotic_bounds`.

use super::alternating::Apart;
use super::asymptotic_bounds::{Bound, Piece, Plan, Reason, Small, Step, Tends, part, twice_size};
use super::asymptotic_form::{atoms, raised, total};
use super::facts::{minus, negated, power_of};
use super::letters::{product, whole_power};
use super::limits::over;
use super::taylor::{Function, Side, at_most};
use super::{Fail, Prover};
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::kernel::key;
use crate::kernel::order::Signs;
use crate::kernel::statement::{apply, compare, domain, numeral, prop, sum};
use crate::kernel::substitution::Substitution;
use crate::refute::literal::literal;
use malachite::Rational;
use malachite::base::num::basic::traits::One;

/// The degrees of Taylor's polynomials, in the order in which they are tried.
pub(super) const ORDERS: [u32; 5] = [1, 2, 3, 4, 5];

/// The j in ln(x) <= j·x^(1/j).
pub(super) const ROOTS: [u32; 2] = [2, 8];

/// The labels of the facts that say how an atom is bounded.
type Shown = Vec<(String, [Option<Label>; 2])>;

impl Prover {
    /// Shows a limit by bounds that are sums of powers of the variable.
    pub(super) fn by_expansion(&mut self, goal: &Prop, l: &Limit) -> Result<Label, Fail> {
        let no = || Fail::No("an asymptotic expansion");
        let x = &l.variable.text;
        let mut apart = self.apart_from_signs(&l.of, x)?;
        let form = self.written_by(&apart.of, x, &mut apart.equations).ok_or_else(no)?;
        let Apart { equations, facts, .. } = apart;
        let mut found = Vec::new();
        atoms(&form, x, &mut found).ok_or_else(no)?;
        if found.is_empty() && equations.is_empty() {
            return Err(no());
        }
        for degree in ORDERS {
            for root in ROOTS {
                let mut plan = self.plan(x, degree, root, &facts);
                let Some([Some(lower), Some(upper)]) = self.bounds_of(&form, &mut plan) else { continue };
                let from = self.beginnings(&plan);
                let done =
                    self.on_its_own(|c| c.between_bounds(goal, l, [&lower, &upper], &plan, (&form, &equations), &from));
                if done.is_ok() {
                    return done;
                }
                // Without ln(x) the other roots give the same plan.
                if !plan.has_logarithm() {
                    break;
                }
            }
        }
        Err(no())
    }

    /// A plan for bounds by these degrees, with nothing in it yet.
    pub(super) fn plan(&mut self, x: &str, degree: u32, root: u32, facts: &[Label]) -> Plan {
        let (pieces, lemmas, small) = Default::default();
        Plan { x: x.to_string(), degree, root, pieces, lemmas, small, facts: facts.to_vec() }
    }

    fn between_bounds(
        &mut self,
        goal: &Prop,
        l: &Limit,
        bounds: [&Bound; 2],
        plan: &Plan,
        (form, equations): (&Expr, &[(Expr, Expr)]),
        from: &[Vec<Expr>],
    ) -> Result<Label, Fail> {
        let [(lower, below), (upper, above)] =
            [self.with_value(&bounds[0].value, l)?, self.with_value(&bounds[1].value, l)?];
        for bound in [&lower, &upper] {
            let same = Limit { of: bound.clone(), ..l.clone() };
            self.limit_by_degrees(&prop(PropKind::Limit(Box::new(same.clone()))), &same)?;
        }
        let lemmas = plan.lemmas.iter().map(|bound| self.taylor_bound(bound)).collect::<Result<Vec<_>, _>>()?;
        let mut sides = [(bounds[0], below, true), (bounds[1], above, false)].into_iter();
        let start = total(&from.concat());
        self.squeeze(goal, l, [&lower, &upper], &start, &mut |c, k, every, body| {
            let (bound, same_value, is_lower) = sides.next().ok_or(Fail::No("a third bound"))?;
            c.block(every, |c, _| {
                let mut at = Substitution::default();
                at.replace(&plan.x, k);
                let here = |e: &Expr| at.expr(e).map_err(Fail::from);
                for fact in &plan.facts {
                    let here = c.instance(fact, k)?;
                    c.put_in(&here);
                }
                let reach = c.reach(plan, from, k)?;
                let mut shown = Shown::new();
                for piece in &plan.pieces {
                    let labels = c.bounded(&at_place(piece, &at)?, &lemmas, &reach, &shown)?;
                    shown.push((key::expr(&here(&piece.atom)?), labels));
                }
                let (value, form) = (here(&bound.value)?, here(form)?);
                let steps = steps_at(&bound.steps, &at)?;
                let order = c.ordered(is_lower, &value, &form, &steps, &shown)?;
                for (a, b) in equations {
                    let equation = compare(here(a)?, Relation::Equal, here(b)?);
                    let label = c.emit(Rule::Power, equation.clone()).or_else(|_| c.without_cases(&equation))?;
                    c.put_in(&label);
                }
                let mut terms = vec![Term { facts: vec![order], factor: numeral(1) }];
                let sign = literal(&Rational::from(if is_lower { -1 } else { 1 }));
                terms.extend(same_value.map(|same| Term { facts: vec![same], factor: sign }));
                c.combination(body.clone(), terms).or_else(|_| c.without_cases(body))
            })
        })
    }

    /// What is small lies within ±1/2 from a sum of numbers on, none of which is negative: the labels of both facts for each.
    fn reach(&mut self, plan: &Plan, from: &[Vec<Expr>], k: &Expr) -> Result<Vec<[Label; 2]>, Fail> {
        let whole = self.known(&compare(k.clone(), Relation::GreaterEqual, total(&from.concat())));
        let whole = whole.ok_or(Fail::No("where the bounds begin"))?;
        let own = |e: Expr| Term { facts: Vec::new(), factor: negated(e) };
        let least = self.number_of(&from[0]).ok_or(Fail::No("a number"))?;
        let mut out: Vec<[Label; 2]> = Vec::new();
        let at_least = |c: &mut Prover, goal: Prop, part: usize, rest: Option<Rational>| {
            let others = from.iter().enumerate().filter(|(other, _)| *other != part).flat_map(|(_, list)| list);
            let others = others.map(|e| own(e.clone())).chain(rest.map(|q| own(literal(&q))));
            let first = Term { facts: vec![whole.clone()], factor: literal(&Rational::from(-1)) };
            c.combination(goal, std::iter::once(first).chain(others).collect())
        };
        let below = |e: Expr| compare(e, Relation::LessEqual, k.clone());
        let one = at_least(self, below(numeral(1)), 0, Some(&least - Rational::ONE))?;
        for small in &plan.small {
            let base = small.base();
            let power = whole_power(total(&base), i64::from(small.d));
            let beyond = match self.number_of(&base) {
                Some(number) => {
                    let rest = &least - power_of(&number, i64::from(small.d));
                    at_least(self, below(power.clone()), 0, Some(rest))?
                }
                None => {
                    let part = from.iter().position(|part| *part == base || *part == [power.clone()]);
                    at_least(self, below(power.clone()), part.ok_or(Fail::No("a part"))?, None)?
                }
            };
            out.push(self.within_half(small, beyond, &power, k, &one, plan)?);
        }
        Ok(out)
    }

    /// −1/2 <= s and s <= 1/2 from B^d <= x and 1 <= x, for B = 1 + 2·Σ|c|.
    ///
    /// With y = x^(1/d) and h >= |c|: s − 1/2 is the sum of c·x^(−r) − h/y, and of (B − y)/(2·y) − 1/(2·y). For c = h the first is
    /// h·(x^(−r) − 1/y); for h = (1 + c²)/2 it is that less (c − 1)²/2·x^(−r).
    fn within_half(
        &mut self,
        small: &Small,
        beyond: Label,
        power: &Expr,
        k: &Expr,
        one: &Label,
        plan: &Plan,
    ) -> Result<[Label; 2], Fail> {
        let mut at = Substitution::default();
        at.replace(&plan.x, k);
        let value = at.expr(&small.value).map_err(Fail::from)?;
        let fact = |label: &Label, factor: Expr| Term { facts: vec![label.clone()], factor };
        let alone = |factor: Expr| Term { facts: Vec::new(), factor };
        let half = |e: Expr| product(vec![literal(&Rational::from_unsigneds(1u32, 2)), e]);
        let (mut y, mut above) = (k.clone(), beyond);
        if small.d > 1 {
            y = raised(k, &Rational::from_unsigneds(1, small.d));
            let whole = whole_power(y.clone(), i64::from(small.d));
            let same = self.emit(Rule::Power, compare(whole.clone(), Relation::Equal, k.clone()))?;
            let order = compare(power.clone(), Relation::LessEqual, whole);
            let terms = vec![fact(&above, numeral(1)), fact(&same, literal(&Rational::from(-1)))];
            let from = self.combination(order, terms)?;
            above =
                self.emit(Rule::Monotone { from }, compare(total(&small.base()), Relation::LessEqual, y.clone()))?;
        }
        let inverse = over(numeral(1), y.clone());
        // For each term: x^(−r), the fact that it is so written, and x^(−r) <= 1/y.
        let mut parts = Vec::new();
        for term in &small.terms {
            let falling = raised(k, &-term.r.clone());
            let written = at.expr(&term.power).map_err(Fail::from)?;
            let same = match self.is_zero(&minus(&written, &falling)) {
                true => None,
                false => Some(self.emit(Rule::Power, compare(written, Relation::Equal, falling.clone()))?),
            };
            let gap = term.r.clone() - Rational::from_unsigneds(1, small.d);
            let falls = if gap > 0 { Some(self.falls(k, &falling, &inverse, &gap, one)?) } else { None };
            parts.push((falling, same, falls));
        }
        let mut labels = Vec::new();
        for sign in [-1, 1] {
            let mut terms = vec![fact(&above, half(inverse.clone())), alone(negated(half(inverse.clone())))];
            for (term, (falling, same, falls)) in small.terms.iter().zip(&parts) {
                let c = if sign < 0 { negated(term.c.clone()) } else { term.c.clone() };
                let side = if sign < 0 { term.side.opposite() } else { term.side };
                terms.extend(same.iter().map(|same| fact(same, c.clone())));
                if side == Side::Below {
                    terms.push(alone(product(vec![c.clone(), falling.clone()])));
                    terms.push(alone(product(vec![c.clone(), inverse.clone()])));
                    continue;
                }
                if side == Side::Both {
                    let square = whole_power(minus(&c, &numeral(1)), 2);
                    terms.push(alone(negated(half(product(vec![square, falling.clone()])))));
                }
                for h in twice_size(side, &c) {
                    terms.extend(falls.iter().map(|falls| fact(falls, half(h.clone()))));
                }
            }
            let goal = at_most(sign < 0, &literal(&Rational::from_signeds(sign, 2)), &value);
            let label = self.combination(goal.clone(), terms)?;
            self.take_in(&label, &goal)?;
            labels.push(label);
        }
        <[Label; 2]>::try_from(labels).map_err(|_| Fail::No("two bounds"))
    }

    /// x^(−r) <= 1/y from 1 <= x: x^(−r)·(1 − x^gap) + (x^(−r)·x^gap − 1/y) for 1/y = x^(gap − r).
    fn falls(&mut self, x: &Expr, falling: &Expr, inverse: &Expr, gap: &Rational, one: &Label) -> Result<Label, Fail> {
        let rises = match *gap == 1 {
            true => one.clone(),
            false => {
                let rises = compare(raised(&numeral(1), gap), Relation::LessEqual, raised(x, gap));
                self.emit(Rule::Monotone { from: one.clone() }, rises)?
            }
        };
        let mut terms = vec![Term { facts: vec![rises], factor: falling.clone() }];
        let both = product(vec![falling.clone(), raised(x, gap)]);
        if !self.is_zero(&minus(&both, inverse)) {
            let same = self.emit(Rule::Power, compare(both, Relation::Equal, inverse.clone()))?;
            terms.push(Term { facts: vec![same], factor: numeral(1) });
        }
        self.combination(compare(falling.clone(), Relation::LessEqual, inverse.clone()), terms)
    }

    /// A bound with the claim's form of the value that it tends to.
    fn with_value(&mut self, bound: &Expr, l: &Limit) -> Result<(Expr, Option<Label>), Fail> {
        let no = || Fail::No("a bound with this limit");
        let Tends::To(value) = self.tends(bound, &l.variable.text) else { return Err(no()) };
        if self.is_zero(&minus(&value, &l.value)) {
            return Ok((bound.clone(), None));
        }
        let value = self.simplified(&value).ok_or_else(no)?;
        let same = compare(value.clone(), Relation::Equal, l.value.clone());
        let label = self.known(&same).map_or_else(|| self.emit(Rule::Power, same.clone()), Ok)?;
        let other = sum(vec![(Sign::Plus, l.value.clone()), (Sign::Plus, bound.clone()), (Sign::Minus, value)]);
        Ok((other, Some(label)))
    }

    /// A statement for all y, with the effort of a claim of its own.
    pub(super) fn lemma(&mut self, p: &Prop) -> Result<Label, Fail> {
        let splits = std::mem::replace(&mut self.splits, 0);
        let shown = self.on_its_own(|c| c.show(p));
        self.splits = splits;
        shown
    }

    /// That a bound with these steps is at most the expression, or at least.
    fn ordered(
        &mut self,
        is_lower: bool,
        bound: &Expr,
        e: &Expr,
        steps: &[Step],
        shown: &Shown,
    ) -> Result<Label, Fail> {
        let goal = at_most(is_lower, bound, e);
        let mut terms = Vec::new();
        for step in steps {
            let labels = shown.iter().find(|s| s.0 == key::expr(&step.atom)).map(|s| &s.1);
            let Some(label) = labels.and_then(|labels| labels[step.side].clone()) else { continue };
            let same = is_lower == (step.side == 0);
            let factor = if same { step.factor.clone() } else { negated(step.factor.clone()) };
            let factor = self.simplified(&factor).unwrap_or(factor);
            if !self.signs_of(&factor).within(Signs::NOT_NEGATIVE) {
                let _ = self.without_cases(&compare(factor.clone(), Relation::GreaterEqual, numeral(0)));
            }
            terms.push(Term { facts: vec![label], factor });
        }
        if let Ok(label) = self.combination(goal.clone(), terms) {
            self.take_in(&label, &goal)?;
            return Ok(label);
        }
        self.without_cases(&goal)
    }

    /// Shows the bounds of an atom.
    fn bounded(
        &mut self,
        piece: &Piece,
        lemmas: &[Label],
        reach: &[[Label; 2]],
        shown: &Shown,
    ) -> Result<[Option<Label>; 2], Fail> {
        let mut labels = [None, None];
        // Of what falls the upper bound comes first: that its argument lies above a positive number is needed for both.
        for k in if piece.function.falls() { [1, 0] } else { [0, 1] } {
            let Some(bound) = &piece.bounds[k] else { continue };
            let goal = at_most(k == 0, bound, &piece.atom);
            let label = match &piece.reasons[k] {
                Some(Reason::Expansion { lemma, at, small }) => {
                    let lemma = lemmas.get(*lemma).ok_or(Fail::No("a lemma"))?;
                    let reach = reach.get(*small).ok_or(Fail::No("what is small"))?;
                    self.within_reach(lemma, &at.value, reach)?;
                    if piece.function.falls() {
                        self.positive_within_reach(&at.value, &reach[0])?;
                    }
                    self.by_lemma(&goal, piece, k == 0, lemma, at, shown)?
                }
                Some(Reason::Tangent { at, parts }) => {
                    self.by_tangent_of_a_part(&goal, piece, k == 0, at, *parts, shown)?
                }
                Some(Reason::Logarithm { parts }) => {
                    let part = Rational::from_signeds(if k == 0 { -1 } else { 1 }, i64::from(*parts));
                    self.tangent_fact(&product(vec![literal(&part), piece.atom.clone()]))?;
                    self.without_cases(&goal)?
                }
                None => self.without_cases(&goal)?,
            };
            self.take_in(&label, &goal)?;
            labels[k] = Some(label);
        }
        Ok(labels)
    }

    /// A bound by an expansion: T(v) <= f(v) <= f(u) for v <= u.
    fn by_lemma(
        &mut self,
        goal: &Prop,
        piece: &Piece,
        is_lower: bool,
        lemma: &Label,
        at: &Bound,
        shown: &Shown,
    ) -> Result<Label, Fail> {
        // Before a negative factor the function's other bound is needed.
        let is_lower_inside = is_lower != piece.turns;
        let factor = if piece.turns { negated(piece.factor()) } else { piece.factor() };
        let mut terms = vec![Term { facts: vec![self.instance(lemma, &at.value)?], factor: factor.clone() }];
        if !self.is_zero(&minus(&at.value, &piece.inside)) {
            let v_is_lower = is_lower_inside != piece.function.falls();
            let order = self.ordered(v_is_lower, &at.value, &piece.inside, &at.steps, shown)?;
            let (p, q) = if v_is_lower { (&at.value, &piece.inside) } else { (&piece.inside, &at.value) };
            terms.push(Term { facts: vec![self.in_order(&piece.function, p, q, order)?], factor });
        }
        if let Some(split) = piece.split() {
            let same = self.emit(Rule::Power, compare(piece.atom.clone(), Relation::Equal, split));
            let sign = literal(&Rational::from(if is_lower { -1 } else { 1 }));
            terms.extend(same.ok().map(|same| Term { facts: vec![same], factor: sign }));
        }
        self.combination(goal.clone(), terms)
    }

    /// Shows that a value near the centre lies in the domain of a fact for all values of one variable.
    pub(super) fn within_reach(&mut self, fact: &Label, value: &Expr, reach: &[Label; 2]) -> Result<(), Fail> {
        let Some(Prop { kind: PropKind::ForAll(bindings, _), .. }) = self.fact(fact) else { return Ok(()) };
        for binding in &bindings {
            let mut at = Substitution::default();
            binding.names.iter().for_each(|n| at.replace(&n.0.text, value));
            for p in domain(binding) {
                let p = at.prop(&p).map_err(Fail::from)?;
                let by = |c: &mut Prover, label: &Label, sign: i64| {
                    c.combination(
                        p.clone(),
                        vec![Term { facts: vec![label.clone()], factor: literal(&Rational::from(sign)) }],
                    )
                };
                if by(self, &reach[0], -1).is_err() && by(self, &reach[1], 1).is_err() {
                    self.without_cases(&p)?;
                }
            }
        }
        Ok(())
    }

    /// What is at least 1 − 1/2 is positive.
    fn positive_within_reach(&mut self, value: &Expr, reach: &Label) -> Result<(), Fail> {
        let goal = compare(value.clone(), Relation::Greater, numeral(0));
        let half = literal(&Rational::from_unsigneds(1u32, 2));
        let terms =
            vec![Term { facts: vec![reach.clone()], factor: numeral(1) }, Term { facts: Vec::new(), factor: half }];
        if let Ok(label) = self.combination(goal.clone(), terms) {
            self.take_in(&label, &goal)?;
        }
        Ok(())
    }

    /// The values of a function at p <= q in order.
    ///
    /// exp(q) − exp(p) = exp(p)·(exp(q − p) − 1), and exp lies above its tangent; ln(q) − ln(p) >= 1 − p/q for the same reason.
    fn in_order(&mut self, function: &Function, p: &Expr, q: &Expr, from: Label) -> Result<Label, Fail> {
        let (first, last) = if function.falls() { (q, p) } else { (p, q) };
        let values = compare(function.at(first), Relation::LessEqual, function.at(last));
        let (gap, place, factor) = match function {
            Function::Exponential => (minus(q, p), apply("exp", p.clone()), apply("exp", p.clone())),
            Function::Logarithm => (minus(&function.at(p), &function.at(q)), numeral(1), over(numeral(1), q.clone())),
            Function::Arcsine | Function::Arctangent => return self.emit(Rule::Arc, values),
            Function::Root(a) if *a > 0 => return self.emit(Rule::Monotone { from }, values),
            // 1/q − 1/p = (p − q)/(p·q).
            Function::Root(a) if *a == -1 => {
                let positive = |e: &Expr| compare(e.clone(), Relation::Greater, numeral(0));
                if let Ok(first) = self.without_cases(&positive(p)) {
                    let terms = [&from, &first].map(|fact| Term { facts: vec![fact.clone()], factor: numeral(1) });
                    if let Ok(label) = self.combination(positive(q), terms.to_vec()) {
                        self.take_in(&label, &positive(q))?;
                    }
                }
                let factor = over(numeral(1), product(vec![p.clone(), q.clone()]));
                return self
                    .combination(values.clone(), vec![Term { facts: vec![from], factor }])
                    .or_else(|_| self.without_cases(&values));
            }
            Function::Sine | Function::Cosine | Function::Turning(_) | Function::Root(_) => {
                return self.without_cases(&values);
            }
        };
        let line = self.tangent_fact(&gap)?;
        let term = |fact: &Label, factor: &Expr| Term { facts: vec![fact.clone()], factor: factor.clone() };
        let mut terms = vec![term(&line, &place), term(&from, &factor)];
        if let Ok(label) = self.combination(values.clone(), terms.clone()) {
            return Ok(label);
        }
        let split = self.exponential_of_a_sum(p, &gap)?;
        terms.push(term(&split, &literal(&Rational::from(-1))));
        self.combination(values, terms)
    }

    /// exp(u) >= (a/j)^j for a <= u, or exp(u) <= (−b/j)^(−j) for u <= b: exp(±u/j) lies above its tangent.
    fn by_tangent_of_a_part(
        &mut self,
        goal: &Prop,
        piece: &Piece,
        is_lower: bool,
        at: &Bound,
        j: u32,
        shown: &Shown,
    ) -> Result<Label, Fail> {
        let (u, sign) = (&piece.inside, if is_lower { 1 } else { -1 });
        // b − exp(t) = (1 + t − exp(t)) + (b − t) − 1.
        let one = |e: i64| literal(&Rational::from(e));
        let mut terms = vec![
            Term { facts: vec![self.tangent_fact(&part(u, sign, j))?], factor: one(1) },
            Term { facts: Vec::new(), factor: one(-1) },
        ];
        if !self.is_zero(&minus(&at.value, u)) {
            let order = self.ordered(is_lower, &at.value, u, &at.steps, shown)?;
            terms.push(Term { facts: vec![order], factor: literal(&Rational::from_unsigneds(1, j)) });
        }
        let (base, whole) = (part(&at.value, sign, j), apply("exp", part(u, sign, j)));
        self.without_cases(&compare(base.clone(), Relation::Greater, numeral(0)))?;
        let from = self.combination(compare(base.clone(), Relation::LessEqual, whole.clone()), terms)?;
        let to_j = |e: &Expr| whole_power(e.clone(), i64::from(j));
        let powers = compare(to_j(&base), Relation::LessEqual, to_j(&whole));
        let fact = match j {
            1 => from,
            _ => self.emit(Rule::Monotone { from }, powers)?,
        };
        let end = if is_lower { u.clone() } else { negated(u.clone()) };
        let same = self.emit(Rule::Power, compare(to_j(&whole), Relation::Equal, apply("exp", end)))?;
        // exp(u) − 1/b^j = exp(u)/b^j·(b^j − exp(−u)).
        let factor = if is_lower { numeral(1) } else { over(piece.atom.clone(), to_j(&base)) };
        let terms = [fact, same].map(|fact| Term { facts: vec![fact], factor: factor.clone() });
        self.combination(goal.clone(), terms.to_vec())
    }
}

/// The steps of a bound with a value for x.
fn steps_at(steps: &[Step], at: &Substitution) -> Result<Vec<Step>, Fail> {
    let here = |e: &Expr| at.expr(e).map_err(Fail::from);
    steps.iter().map(|s| Ok(Step { atom: here(&s.atom)?, factor: here(&s.factor)?, side: s.side })).collect()
}

/// A piece with a value for x.
fn at_place(piece: &Piece, at: &Substitution) -> Result<Piece, Fail> {
    let here = |e: &Expr| at.expr(e).map_err(Fail::from);
    let mut out = piece.clone();
    for e in [&mut out.atom, &mut out.inside].into_iter().chain(&mut out.scale).chain(out.bounds.iter_mut().flatten()) {
        *e = here(e)?;
    }
    for reason in out.reasons.iter_mut().flatten() {
        if let Reason::Expansion { at: bound, .. } | Reason::Tangent { at: bound, .. } = reason {
            *bound = Bound { value: here(&bound.value)?, steps: steps_at(&bound.steps, at)? };
        }
    }
    Ok(out)
}
