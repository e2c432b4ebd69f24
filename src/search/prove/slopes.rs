//! Comparisons by the sign of a derivative: F(x) and F(y), or a difference that is known at a point.

use super::comparison::single;
use super::facts::{is_settled, minus};
use super::letters::whole_power;
use super::sign_charts::End;
use super::{Fail, Prover, implies};
use crate::algebra::Moment;
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::kernel::names::names_in;
use crate::kernel::order::Signs;
use crate::kernel::statement::{apply, compare, expr, name, numeral, prop};
use crate::kernel::substitution::Substitution;
use malachite::Rational;
use std::collections::BTreeSet;

/// How often the sign of a derivative is shown by that of the next.
const DEPTH: usize = 4;

/// How many comparisons of a claim, or of each part of an extremum, are tried at stationary points, each place with the effort of a
/// claim of its own.
pub(super) const STATIONARY: usize = 1;

/// How many comparisons of one claim are tried so.
const SLOPES: usize = 40;

impl Prover {
    /// A comparison a relation b by the mean value theorem.
    pub(crate) fn by_slope(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let (a, relation, b) = single(goal)?;
        if self.slopes_open >= DEPTH {
            return Err(Fail::No("a sign"));
        }
        if let Ok(label) = self.by_equal_values(goal) {
            return Ok(label);
        }
        if matches!(relation, Relation::Equal | Relation::NotEqual) {
            return Err(Fail::No("a sign"));
        }
        if !has_function(a) && !has_function(b) {
            return Err(Fail::No("an exponential, a logarithm or a root"));
        }
        let difference = minus(a, b);
        let reals = self.reals_in(&difference);
        for x in &reals {
            let mut places = self.places(x);
            // Where two variables are equal: a difference of values of one function.
            for y in reals.iter().filter(|y| *y != x).map(|y| name(y)) {
                if !places.contains(&y) && self.read(&put_in(&difference, x, &y)?, true).is_some_and(|r| r.number == 0)
                {
                    places.push(y);
                }
            }
            for p in places {
                let done = self.attempt(|c| c.beside_a_place(goal, &difference, x, relation, &p, false));
                if done.is_ok() {
                    return done;
                }
            }
        }
        self.beside_stationary_points(goal, &difference, relation)
    }

    /// A comparison of two values of one function.
    pub(super) fn by_common_function(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let (a, relation, b) = single(goal)?;
        let no = || Fail::No("two values of one function");
        if relation.is_greater().is_none() || !has_function(a) {
            return Err(no());
        }
        let (f, x, y) = self.common_function(a, b).ok_or_else(no)?;
        self.attempt(|c| {
            let t = c.fresh("t");
            let f = put_in(&f, PLACE, &name(&t))?;
            c.values_in_order(goal, &f, &t, &x, relation, &y)
        })
    }

    /// A difference a − b relation 0 from its value where it is stationary in a variable.
    fn beside_stationary_points(&mut self, goal: &Prop, difference: &Expr, relation: Relation) -> Result<Label, Fail> {
        if self.slopes_open > 0 || self.stationary == 0 {
            return Err(Fail::No("a slope outside of slopes"));
        }
        self.stationary -= 1;
        // Roots of a variable are squared elsewhere: their derivatives are no simpler.
        let reals = self.reals_in(difference);
        for x in reals.into_iter().filter(|x| !has_root_of(difference, x)) {
            let mut points = Vec::new();
            let _ = self.attempt(|c| {
                points = c.stationary_points(difference, &x);
                Err::<(), _>(Fail::No("points alone"))
            });
            for p in points {
                let done = self.on_its_own(|c| c.beside_a_place(goal, difference, &x, relation, &p, true));
                if done.is_ok() {
                    return done;
                }
            }
        }
        Err(Fail::No("a stationary point"))
    }

    /// The real variables that occur, in the order of their names.
    pub(super) fn reals_in(&self, e: &Expr) -> Vec<String> {
        let mut names = BTreeSet::new();
        names_in(e, &mut names);
        let families: BTreeSet<&str> = (self.checker.statement().bindings.iter())
            .flat_map(|b| &b.names)
            .filter(|n| n.1.is_some())
            .map(|n| n.0.text.as_str())
            .collect();
        let sequences: BTreeSet<&str> = self.checker.statement().sequences.iter().map(|s| s.name.as_str()).collect();
        names
            .into_iter()
            .filter(|n| self.is_a_name(n))
            .filter(|n| !families.contains(n.as_str()) && !sequences.contains(n.as_str()))
            .filter(|n| !self.naturals.contains(n))
            .take(3)
            .collect()
    }

    /// Where a difference may be known: the bounds of the variable in facts, then 0 and 1.
    pub(super) fn places(&self, x: &str) -> Vec<Expr> {
        let mut out: Vec<Expr> = Vec::new();
        for (_, fact) in self.checker.facts() {
            let Some((l, relation, r)) = fact.single() else { continue };
            if matches!(relation, Relation::Equal) {
                continue;
            }
            for (here, there) in [(l, r), (r, l)] {
                if matches!(&here.kind, ExprKind::Name(n) if n == x) && is_short(there, x) && !out.contains(there) {
                    out.push(there.clone());
                }
            }
        }
        for k in [0, 1] {
            if !out.contains(&numeral(k)) {
                out.push(numeral(k));
            }
        }
        out.truncate(4);
        out
    }

    /// The function of which both sides are values: F with a place for its argument, and the two arguments.
    fn common_function(&self, a: &Expr, b: &Expr) -> Option<(Expr, Expr, Expr)> {
        let mut pair = None;
        let f = common(a, b, &mut pair)?;
        let (x, y) = pair?;
        // A place at the top would make every comparison one of values of the identity.
        (!matches!(f.kind, ExprKind::Name(_))).then_some((f, x, y))
    }

    /// F(x) relation F(y) from the order of x and y.
    fn values_in_order(
        &mut self,
        goal: &Prop,
        f: &Expr,
        t: &str,
        x: &Expr,
        relation: Relation,
        y: &Expr,
    ) -> Result<Label, Fail> {
        let strict = matches!(relation, Relation::Less | Relation::Greater);
        for (order, below) in [(Relation::Less, true), (Relation::Greater, false)] {
            let wanted = if strict { order } else { order.loose() };
            if self.quietly(&compare(x.clone(), wanted, y.clone())).is_ok() {
                let (low, high) = if below { (x, y) } else { (y, x) };
                // b = x, a = y: the sign of b − a is negative where x is below.
                let slope = if below { relation.turned() } else { relation };
                let slope = if strict { slope } else { slope.loose() };
                return self.rises(goal, f, t, [low, high], slope, [y, x]);
            }
        }
        Err(Fail::No("the order of two arguments"))
    }

    /// A difference F(x) relation 0 from F at a place p; with cases where the order of x and p is open. Where it is said so, F(p) may be
    /// 0 by a fact only, as for exp(−a²/a²) − exp(−1).
    pub(super) fn beside_a_place(
        &mut self,
        goal: &Prop,
        difference: &Expr,
        x: &str,
        relation: Relation,
        p: &Expr,
        by_fact: bool,
    ) -> Result<Label, Fail> {
        let (variable, t) = (name(x), self.fresh("t"));
        let (f, t) = (&put_in(difference, x, &name(&t))?, t.as_str());
        let there = put_in(f, t, p)?;
        self.define(&there);
        let reading = self.read(&there, true).ok_or(Fail::No("a value at the place"))?;
        let at_place = compare(there.clone(), relation, numeral(0));
        let zero = match by_fact && reading.number != 0 {
            false => None,
            true => self.quietly(&compare(there.clone(), Relation::Equal, numeral(0))).ok(),
        };
        let is_zero = reading.number == 0 || zero.is_some();
        if !is_zero {
            self.quietly(&at_place)?;
        }
        let strict = matches!(relation, Relation::Less | Relation::Greater) && is_zero;
        let side = |c: &mut Prover, order: Relation, goal: &Prop| -> Result<Label, Fail> {
            let (low, high, slope) = match order {
                Relation::Greater => (p, &variable, relation),
                _ => (&variable, p, relation.turned()),
            };
            let slope = if strict { slope } else { slope.loose() };
            let shown =
                compare(put_in(f, t, &variable)?, if strict { relation } else { relation.loose() }, there.clone());
            let label = c.rises(&shown, f, t, [low, high], slope, [p, &variable])?;
            let mut terms = vec![Term { facts: vec![label], factor: numeral(1) }];
            terms.extend(zero.iter().map(|zero| Term { facts: vec![zero.clone()], factor: numeral(1) }));
            if !is_zero {
                terms.push(Term { facts: Vec::new(), factor: there.clone() });
            }
            c.combination(goal.clone(), terms)
        };
        for order in [Relation::Greater, Relation::Less] {
            let wanted = if strict { order } else { order.loose() };
            if self.quietly(&compare(variable.clone(), wanted, p.clone())).is_ok() {
                return side(self, order, goal);
            }
        }
        if self.splits > 2 {
            return Err(Fail::No("the order of two arguments"));
        }
        let mut from = Vec::new();
        for order in [Relation::Greater, Relation::Less] {
            let case = implies(&compare(variable.clone(), order, p.clone()), goal);
            from.push(self.block(&case, |c, _| side(c, order, goal))?);
        }
        let case = implies(&compare(variable.clone(), Relation::Equal, p.clone()), goal);
        from.push(self.block(&case, |c, _| {
            c.solve_equations();
            c.quietly(goal)
        })?);
        self.emit(Rule::Logic { from }, goal.clone())
    }

    /// F(b) relation F(a), as the goal says, from the sign of the derivative between low and high.
    pub(super) fn rises(
        &mut self,
        goal: &Prop,
        f: &Expr,
        t: &str,
        [low, high]: [&Expr; 2],
        slope: Relation,
        [a, b]: [&Expr; 2],
    ) -> Result<Label, Fail> {
        self.slopes += 1;
        if self.slopes > SLOPES || self.deadline.is_some_and(|d| Moment::now() > d) {
            return Err(Fail::Limit("slopes"));
        }
        // The kernel adds no bounds up: numbers beyond the ends are said of t as well.
        let ends = [(low, high, Relation::Greater), (high, low, Relation::Less)];
        let said = ends.map(|(end, _, relation)| self.end_of(end, relation));
        let plain = [0, 1].map(|k| said[k].as_ref().map(|end| end.bounds(ends[k].2)));
        // What t lies between is its own bound strictly, even if it is a value of a bound.
        let closed = said.iter().zip(&ends).filter_map(|(end, (_, _, relation))| {
            let end = end.as_ref().filter(|end| end.closed)?;
            Some(compare(name(t), *relation, end.at.clone()))
        });
        let closed: Vec<Prop> = closed.collect();
        let more = [0, 1].map(|k| {
            plain[k].clone().or_else(|| {
                let number = self.number_beyond(ends[k].0, ends[k].1, ends[k].2)?;
                Some(Constraint::Relation(ends[k].2, number))
            })
        });
        let count = |bounds: &[Option<Constraint>; 2]| bounds.iter().flatten().count();
        let walls: Vec<Constraint> =
            self.walls(f, t).iter().filter_map(|wall| self.beyond_wall(wall, low, high)).collect();
        let mut bounds = vec![plain];
        bounds.extend(Some(more).filter(|more| count(more) != count(&bounds[0])));
        let mut shown = Err(Fail::No("a slope"));
        for bounds in bounds {
            let relations = bounds.into_iter().flatten().chain(walls.iter().cloned());
            let between =
                Constraint::Interval { from: low.clone(), from_closed: false, to: high.clone(), to_closed: false };
            let binding = Binding::of(Name::new(t), false, std::iter::once(between).chain(relations).collect());
            shown = self.attempt(|c| c.rises_on(goal, f, binding, &closed, slope, [a, b]));
            if shown.is_ok() {
                break;
            }
        }
        shown
    }

    /// Numbers that a variable may not pass, since an argument of a root or logarithm or a divisor is 0 there.
    fn walls(&mut self, e: &Expr, t: &str) -> BTreeSet<Rational> {
        let mut arguments = Vec::new();
        arguments_in(e, &mut arguments);
        let t = self.letters.of(&name(t));
        let mut walls = BTreeSet::new();
        for argument in arguments {
            let Some(p) = self.letters.polynomial(argument).filter(|p| p.variables() == [t]) else { continue };
            let factors = crate::algebra::factor::factor(&p).map(|f| f.factors).unwrap_or_default();
            for (p, _) in factors {
                if let [constant, slope] = p.coefficients_in(t).as_slice() {
                    walls.insert(-constant.constant_term() / slope.constant_term());
                }
            }
        }
        walls
    }

    /// On which side of a wall an interval lies, if facts say so.
    fn beyond_wall(&mut self, wall: &Rational, low: &Expr, high: &Expr) -> Option<Constraint> {
        let near = |c: &mut Prover, end: &Expr, relation| {
            let number = c.letters.number(end);
            number.or_else(|| c.end_of(end, relation).map(|end| end.near))
        };
        let relation = if near(self, low, Relation::Greater).is_some_and(|low| low >= *wall) {
            Relation::Greater
        } else if near(self, high, Relation::Less).is_some_and(|high| high <= *wall) {
            Relation::Less
        } else {
            return None;
        };
        Some(Constraint::Relation(relation, crate::refute::literal::literal(wall)))
    }

    /// The same for an interval of the variable, and what follows of it from its ends.
    fn rises_on(
        &mut self,
        goal: &Prop,
        f: &Expr,
        binding: Binding,
        within: &[Prop],
        slope: Relation,
        [a, b]: [&Expr; 2],
    ) -> Result<Label, Fail> {
        let t: Vec<Name> = binding.names.iter().map(|n| n.0.clone()).collect();
        // Both points have to lie within what is said beside the interval.
        for constraint in &binding.constraints {
            let Constraint::Relation(relation, bound) = constraint else { continue };
            for point in [a, b] {
                let within = [*relation, relation.loose()].map(|r| compare(point.clone(), r, bound.clone()));
                let _ = within.iter().any(|within| self.attempt(|c| c.by_linear_facts(within)).is_ok());
            }
        }
        let derivative = expr(ExprKind::Derivative(Box::new(f.clone()), t));
        let body = compare(derivative.clone(), slope, numeral(0));
        let every = prop(PropKind::ForAll(vec![binding], Box::new(body.clone())));
        self.define(f);
        let (splits, open) = (self.splits, self.slopes_open);
        self.slopes_open += 1;
        let source = self.block(&every, |c, _| {
            within.iter().for_each(|bound| _ = c.attempt(|c| c.by_linear_facts(bound)));
            c.sign_of_derivative(&body, &derivative)
        });
        (self.splits, self.slopes_open) = (splits, open);
        let source = source?;
        let with = vec![(Name::new("a"), a.clone()), (Name::new("b"), b.clone())];
        let from = Vec::new();
        let label = self.emit(Rule::Slope { source, with, from }, goal.clone())?;
        self.take_in(&label, goal)?;
        Ok(label)
    }

    /// A number beyond the lower or upper end of an interval, where no fact names one: that of the other end, where this is a number;
    /// or 0, where the sign of the end is known.
    fn number_beyond(&mut self, end: &Expr, other: &Expr, relation: Relation) -> Option<Expr> {
        if let Some(c) = self.letters.number(end) {
            let far = self.end_of(other, relation)?;
            return (if relation == Relation::Greater { far.near < c } else { far.near > c }).then_some(far.at);
        }
        self.signs_of(end).within(Signs::of(relation)).then(|| numeral(0))
    }

    /// The number nearest to an expression that a fact says to lie below (`>`) or above (`<`) it.
    fn end_of(&mut self, e: &Expr, relation: Relation) -> Option<End> {
        let [low, high] = self.ends_of(e);
        let end = if relation == Relation::Greater { low } else { high };
        end.filter(|_| self.letters.number(e).is_none())
    }

    /// Shows f(a) = f(b) for f = sin and f = cos where it speaks of a or b: 1/2 is the sine of pi/6. Where it speaks of both, the order of
    /// f(a) and f(b) that the goal suggests.
    fn values_of_functions(&mut self, goal: &Prop, a: &Expr, b: &Expr) {
        let PropKind::Compare(_, relations) = &goal.kind else { return };
        for (f, relation) in [("sin", relations[0]), ("cos", relations[0].turned())] {
            let (x, y) = (apply(f, a.clone()), apply(f, b.clone()));
            let known = [&x, &y].map(|e| self.letters.knows(e));
            if known == [false; 2] {
                continue;
            }
            let same = compare(x.clone(), Relation::Equal, y.clone());
            let same = self.attempt(|c| c.combination(same, Vec::new()));
            if same.is_err() && known == [true; 2] && self.slopes_open == 0 && self.splits < 3 {
                let order = compare(x, relation, y);
                let _ = self.attempt(|c| c.without_cases(&order));
            }
        }
    }

    /// A comparison x relation y from facts about F(x) and F(y), where F rises or falls strictly.
    pub(crate) fn by_equal_values(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let (a, relation, b) = single(goal)?;
        if relation == Relation::Equal {
            return self.attempt(|c| {
                let mut from = Vec::new();
                for half in [Relation::LessEqual, Relation::GreaterEqual] {
                    from.push(c.by_equal_values(&compare(a.clone(), half, b.clone()))?);
                }
                c.emit(Rule::Logic { from }, goal.clone())
            });
        }
        self.values_of_functions(goal, a, b);
        let facts = self.facts();
        for (label, fact) in facts {
            let Some((l, said, r)) = fact.single() else { continue };
            // What denies a strict fact need not be strict.
            let is_strict = matches!(said, Relation::Less | Relation::Greater);
            let Some((f, x, y)) = self.common_function(l, r).filter(|_| has_function(l)) else { continue };
            if !((x == *a && y == *b) || (x == *b && y == *a)) {
                continue;
            }
            for order in [Relation::Less, Relation::Greater] {
                let order = if is_strict { order.loose() } else { order };
                let done = self.attempt(|c| {
                    c.against_opposite(goal, |c, _| {
                        let t = c.fresh("t");
                        let f = put_in(&f, PLACE, &name(&t))?;
                        let shown = compare(l.clone(), order, r.clone());
                        let strict = c.values_in_order(&shown, &f, &t, &x, order, &y)?;
                        c.logic(&[&strict, &label], goal)
                    })
                });
                if done.is_ok() {
                    return done;
                }
            }
        }
        Err(Fail::No("values of one function"))
    }

    /// The sign of a derivative: factor by factor, each by little effort or by the sign of its own derivative.
    fn sign_of_derivative(&mut self, body: &Prop, derivative: &Expr) -> Result<Label, Fail> {
        self.define(derivative);
        if let Ok(label) = self.combination(body.clone(), Vec::new()) {
            return Ok(label);
        }
        let reading = self.read(derivative, true).ok_or(Fail::No("a derivative"))?;
        for f in reading.factors.iter().filter(|f| !is_settled(f.signs)) {
            let e = self.letters.written(&f.poly);
            self.enrich(&[&e]);
            if !is_settled(self.signs_of(&e)) && f.power % 2 != 0 {
                self.settle(&e)?;
            }
        }
        let mut written = vec![crate::refute::literal::literal(&reading.number)];
        written.extend(reading.factors.iter().map(|f| whole_power(self.letters.written(&f.poly), f.power)));
        if let Ok(label) = self.combination(body.clone(), Vec::new()) {
            return Ok(label);
        }
        self.quietly(body)
    }

    /// A fact that says the sign of an expression, if one of them can be shown.
    fn settle(&mut self, e: &Expr) -> Result<Label, Fail> {
        if let Ok(label) = self.attempt(|c| c.charted_sign(e)) {
            return Ok(label);
        }
        let zero = numeral(0);
        let signs = self.signs_of(e);
        let candidates = [Relation::Greater, Relation::Less, Relation::GreaterEqual, Relation::LessEqual];
        let open: Vec<Prop> = candidates
            .into_iter()
            .filter(|r| !signs.and(Signs::of(*r)).within(Signs::ZERO))
            .map(|r| compare(e.clone(), r, zero.clone()))
            .collect();
        for p in &open {
            if let Ok(label) = self.quietly(p) {
                return Ok(label);
            }
        }
        for p in &open {
            let splits = std::mem::replace(&mut self.splits, 9);
            let shown = self.attempt(|c| c.by_tangents(p)).or_else(|_| self.attempt(|c| c.by_slope(p)));
            self.splits = splits;
            if let Ok(label) = shown {
                return Ok(label);
            }
        }
        Err(Fail::No("the sign of a factor"))
    }
}

/// The name that marks the argument in a function that two expressions share. No variable is called so.
const PLACE: &str = "?";

/// What two expressions have in common, with a place where they differ; they differ in one pair only.
fn common(a: &Expr, b: &Expr, pair: &mut Option<(Expr, Expr)>) -> Option<Expr> {
    use ExprKind::*;
    if a == b {
        return Some(a.clone());
    }
    let list = |x: &[Expr], y: &[Expr], pair: &mut Option<(Expr, Expr)>| -> Option<Vec<Expr>> {
        x.iter().zip(y).map(|(x, y)| common(x, y, pair)).collect()
    };
    let before = pair.clone();
    let inner = match (&a.kind, &b.kind) {
        (Apply(f, x), Apply(g, y)) if f.text == g.text && x.len() == y.len() => {
            list(x, y, pair).map(|arguments| Apply(f.clone(), arguments))
        }
        (Negate(x), Negate(y)) => common(x, y, pair).map(|e| Negate(Box::new(e))),
        (Sum(x), Sum(y)) if x.len() == y.len() && x.iter().zip(y).all(|(x, y)| x.0 == y.0) => {
            let parts: Option<Vec<_>> = x.iter().zip(y).map(|(x, y)| Some((x.0, common(&x.1, &y.1, pair)?))).collect();
            parts.map(Sum)
        }
        (Product(x), Product(y)) if x.len() == y.len() && x.iter().zip(y).all(|(x, y)| x.0 == y.0) => {
            let parts: Option<Vec<_>> = x.iter().zip(y).map(|(x, y)| Some((x.0, common(&x.1, &y.1, pair)?))).collect();
            parts.map(Product)
        }
        (Power(x, p), Power(y, q)) => match common(x, y, pair) {
            Some(base) => common(p, q, pair).map(|exponent| Power(Box::new(base), Box::new(exponent))),
            None => None,
        },
        _ => None,
    };
    if let Some(kind) = inner {
        return Some(Expr { kind, span: Span::default() });
    }
    *pair = before;
    match pair {
        None => *pair = Some((a.clone(), b.clone())),
        Some((x, y)) if x == a && y == b => {}
        Some(_) => return None,
    }
    Some(name(PLACE))
}

/// The arguments of roots and logarithms, and the divisors.
fn arguments_in<'a>(e: &'a Expr, into: &mut Vec<&'a Expr>) {
    match &e.kind {
        ExprKind::Apply(f, list) if f.text == "ln" || f.text == "sqrt" => into.extend(list),
        ExprKind::Power(base, exponent) if super::letters::natural(exponent).is_none() => into.push(base),
        ExprKind::Product(list) => into.extend(list.iter().filter(|p| p.0 == Factor::Over).map(|p| &p.1)),
        _ => {}
    }
    crate::claim::walk::parts(e, &mut |part| arguments_in(part, into));
}

/// Whether a function other than the four operations and whole powers occurs.
pub(super) fn has_function(e: &Expr) -> bool {
    use ExprKind::*;
    match &e.kind {
        Number(_) | Name(_) => false,
        Apply(..) => true,
        Negate(a) => has_function(a),
        Sum(list) => list.iter().any(|(_, e)| has_function(e)),
        Product(list) => list.iter().any(|(_, e)| has_function(e)),
        Power(a, b) => !matches!(b.kind, Number(_)) || has_function(a),
        SumOver(..) | ProductOver(..) | IntegralOver(..) | Derivative(..) | Matrix(_) => false,
    }
}

/// Whether a root of something stands in an expression that holds a name.
fn has_root_of(e: &Expr, x: &str) -> bool {
    if let Some((base, exponent)) = super::letters::as_power(e)
        && super::letters::natural(&exponent).is_none()
        && super::limits::holds(&base, x)
    {
        return true;
    }
    let mut found = false;
    crate::claim::walk::parts(e, &mut |part| found |= has_root_of(part, x));
    found
}

pub(super) fn put_in(e: &Expr, old: &str, value: &Expr) -> Result<Expr, Fail> {
    let mut map = Substitution::default();
    map.replace(old, value);
    map.expr(e).map_err(Fail::from)
}

/// A short expression without this name.
fn is_short(e: &Expr, x: &str) -> bool {
    let mut names = BTreeSet::new();
    names_in(e, &mut names);
    !names.contains(x) && crate::kernel::key::expr(e).len() < 40
}
