//! The sign of a function of one variable on an interval, by the intervals in which it rises and falls.
//!
//! Method (the sign chart of a calculus course): values at many numbers show the sign, and where the function F rises and falls; they
//! prove nothing. Where F rises from p on, its sign is that at p, and F′ > 0 is shown by the same method. About a greatest or
//! least value a short interval from p to q is left out: if F′ >= −κ there, then F(x) >= F(p) − κ·(q − p), and F′ + κ has
//! its sign from the same method, too.
//!
//! Limits: [`DEPTH`] derivatives, [`RUNS`] intervals of one function, [`CHARTS`] charts of one claim.

use super::comparison::single;
use super::facts::{is_settled, minus};
use super::{Fail, Prover, implies};
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, name, numeral, sum};
use crate::refute::evaluate::Assignment;
use crate::refute::literal::literal;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::{Abs, Floor, Pow};

/// How often a derivative is charted.
const DEPTH: usize = 7;
/// The most intervals in which a function rises or falls.
const RUNS: usize = 6;
/// The most charts of one claim.
const CHARTS: usize = 80;
/// At how many numbers a function is evaluated first.
const VALUES: i64 = 48;
/// The most places within an interval where sine and cosine change their signs.
const MOST_CUTS: usize = 6;
/// How many quarters of a turn are looked at on either side of 0.
const QUADRANTS: i64 = 12;
/// How often the neighbourhood of a greatest or least value is made narrower.
const ROUNDS: usize = 12;

/// One end of an interval.
pub(super) struct End {
    pub(super) at: Expr,
    /// A number near it, on the inner side.
    pub(super) near: Rational,
    /// Whether it belongs to the interval.
    pub(super) closed: bool,
}

impl End {
    /// The bound that it is of an interval.
    pub(super) fn bounds(&self, relation: Relation) -> Constraint {
        Constraint::Relation(if self.closed { relation.loose() } else { relation }, self.at.clone())
    }
}

/// What a function does in an interval between two numbers, or from or to the end of its domain.
enum Run {
    Rises,
    Falls,
    /// It moves by less than this times the distance.
    Flat(Rational),
}

/// The intervals of a function in their order, and what lies between them.
struct Chart {
    runs: Vec<Run>,
    cuts: Vec<Expr>,
}

/// A function of one variable, its sign, and its domain.
struct Function<'a> {
    of: &'a Expr,
    x: &'a str,
    relation: Relation,
    ends: [Option<End>; 2],
}

impl Prover {
    /// A comparison of functions of one variable by the signs of the factors of its difference.
    pub(super) fn by_sign_chart(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let (a, _, b) = single(goal)?;
        if !super::slopes::has_function(a) && !super::slopes::has_function(b) {
            return Err(no());
        }
        let difference = minus(a, b);
        let [_] = self.reals_in(&difference).as_slice() else { return Err(no()) };
        let reading = self.read(&difference, true).ok_or_else(no)?;
        for factor in reading.factors.iter().filter(|f| !is_settled(f.signs) && f.power % 2 != 0) {
            let e = self.letters.written(&factor.poly);
            self.charted_sign(&e)?;
        }
        self.combination(goal.clone(), Vec::new()).or_else(|_| self.quietly(goal))
    }

    /// Shows the sign of a function of one variable.
    pub(super) fn charted_sign(&mut self, e: &Expr) -> Result<Label, Fail> {
        let [x] = self.reals_in(e).try_into().map_err(|_| no())?;
        if super::absolute::has_absolute(e)
            || has_moving_exponent(e)
            || self.slopes_open >= DEPTH
            || self.charts >= CHARTS
        {
            return Err(no());
        }
        self.charts += 1;
        if let Some((factor, quotient)) = self.with_plain_function(e) {
            return self.by_factor(e, &factor, &quotient);
        }
        let ends = self.ends_of(&name(&x));
        let points = points(&ends);
        let values: Vec<(Rational, Rational)> =
            points.into_iter().filter_map(|p| Some((p.clone(), value(e, &x, &p)?))).collect();
        let (up, down) = (values.iter().any(|v| v.1 > 0), values.iter().any(|v| v.1 < 0));
        if up == down || values.len() < 8 {
            return Err(no());
        }
        let relation = if up { Relation::Greater } else { Relation::Less };
        let mut function = Function { of: e, x: &x, relation, ends };
        let mut chart = function.chart(&values, &[]);
        let touches = chart.is_none();
        if touches {
            chart = function.chart(&values, &self.exact_places(e, &x));
        }
        let is_zero = |end: &End| end.closed && function.may_be_zero(&end.at);
        if touches || values.iter().any(|v| v.1 == 0) || function.ends.iter().flatten().any(is_zero) {
            function.relation = relation.loose();
        }
        let goal = compare(e.clone(), function.relation, numeral(0));
        if let Ok(label) = self.quietly(&goal) {
            return Ok(label);
        }
        let (splits, slopes) = (std::mem::replace(&mut self.splits, 9), self.slopes);
        let shown = match self.quadrants(e, &x, &function.ends).first() {
            Some(cut) => self.attempt(|c| {
                let mut cases = Vec::new();
                for side in [Relation::LessEqual, Relation::Greater] {
                    let case = implies(&compare(name(&x), side, cut.clone()), &goal);
                    cases.push(c.block(&case, |c, _| c.charted_sign(e).and_then(|label| c.logic(&[&label], &goal)))?);
                }
                c.emit(Rule::Logic { from: cases }, goal.clone())
            }),
            None => {
                let chart = chart.filter(|chart| function.begins_and_ends_with_a_value(chart)).ok_or_else(no)?;
                self.attempt(|c| c.in_runs(&goal, &function, &chart, 0, chart.runs.len()))
            }
        };
        (self.splits, self.slopes) = (splits, slopes);
        shown
    }

    /// The sign of an expression from that of its quotient by a factor of known sign.
    fn by_factor(&mut self, e: &Expr, factor: &Expr, quotient: &Expr) -> Result<Label, Fail> {
        let shown = self.charted_sign(quotient)?;
        let Some(PropKind::Compare(_, relations)) = self.fact(&shown).map(|fact| fact.kind) else { return Err(no()) };
        let is_positive = self.signs_of(factor).within(Signs::POSITIVE);
        let relation = if is_positive { relations[0] } else { relations[0].turned() };
        let terms = vec![Term { facts: vec![shown], factor: factor.clone() }];
        self.combination(compare(e.clone(), relation, numeral(0)), terms)
    }

    /// An expression as a factor of known sign and a quotient with a simpler derivative: `A*ln(u) + B` as A and `ln(u) + B/A`, where A
    /// moves, or `c*exp(u) + B` as exp(u) and `c + B/exp(u)`, where c does not.
    fn with_plain_function(&mut self, e: &Expr) -> Option<(Expr, Expr)> {
        let reading = self.read(e, false)?;
        let [factor] = reading.factors.as_slice() else { return None };
        let p = factor.poly.scale(&reading.number);
        for (function, is_logarithm) in [("ln", true), ("exp", false)] {
            let is_it = |letter: &u32| matches!(self.letters.expr(*letter).map(|e| &e.kind), Some(ExprKind::Apply(f, _)) if f.text == function);
            let letters: Vec<u32> = p.variables().into_iter().filter(is_it).collect();
            if letters.len() != 1 && is_logarithm {
                continue;
            }
            for letter in letters {
                let coefficients = p.coefficients_in(letter);
                let ([rest, slope], 1) = (coefficients.as_slice(), factor.power) else { continue };
                if slope.is_constant() == is_logarithm || rest.is_constant() {
                    continue;
                }
                let value = self.letters.expr(letter)?.clone();
                let [slope, rest] = [slope, rest].map(|p| self.letters.written(p));
                let (plain, divisor) = if is_logarithm { (value, slope) } else { (slope, value) };
                if is_settled(self.signs_of(&divisor)) {
                    let rest = super::limits::over(rest, divisor.clone());
                    return Some((divisor, sum(vec![(Sign::Plus, plain), (Sign::Plus, rest)])));
                }
            }
        }
        None
    }

    /// An order of a variable and a number, or their equality, from an equation in the variable that fails on the other side.
    pub(super) fn by_failing_equation(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let (a, relation, b) = single(goal)?;
        let is_place =
            |x: &Expr, c: &Expr| matches!(x.kind, ExprKind::Name(_)) && enclosed(x).is_none() && enclosed(c).is_some();
        if self.slopes_open > 0 || !(is_place(a, b) || is_place(b, a)) {
            return Err(no());
        }
        if relation == Relation::Equal {
            let halves = [Relation::LessEqual, Relation::GreaterEqual].map(|half| compare(a.clone(), half, b.clone()));
            let mut from = Vec::new();
            for half in halves {
                from.push(self.by_failing_equation(&half)?);
            }
            return self.emit(Rule::Logic { from }, goal.clone());
        }
        let x = if enclosed(a).is_none() { a } else { b };
        for (label, fact) in self.facts() {
            let Some((l, Relation::Equal, r)) = fact.single() else { continue };
            let difference = minus(l, r);
            let alone = self.reals_in(&difference);
            if !matches!(&x.kind, ExprKind::Name(n) if alone == [n.clone()])
                || !super::slopes::has_function(&difference)
            {
                continue;
            }
            let done = self.attempt(|c| {
                c.against_opposite(goal, |c, _| {
                    let sign = c.charted_sign(&difference)?;
                    let Some(PropKind::Compare(_, said)) = c.fact(&sign).map(|fact| fact.kind) else {
                        return Err(no());
                    };
                    let strict = compare(l.clone(), said[0].strict(), r.clone());
                    let strict = c.combination(strict, vec![Term { facts: vec![sign], factor: numeral(1) }])?;
                    c.logic(&[&strict, &label], goal)
                })
            });
            if done.is_ok() {
                return done;
            }
        }
        Err(no())
    }

    /// Where a function may be 0 without a change of its sign: multiples of π/12, and where its derivative is an equation that is
    /// solved.
    fn exact_places(&mut self, e: &Expr, x: &str) -> Vec<(Rational, Expr)> {
        let mut places: Vec<Expr> = Vec::new();
        let _ = self.attempt(|c| {
            places = c.stationary_points(e, x);
            Err::<(), _>(no())
        });
        let mut arguments = Vec::new();
        turning_arguments(e, &mut arguments);
        if !arguments.is_empty() {
            let turn = |k| super::letters::product(vec![literal(&Rational::from_signeds(k, 12)), name(PI)]);
            places.extend((-24..=24).map(turn));
        }
        places.into_iter().filter_map(|place| Some((enclosed(&place)?.0, place))).collect()
    }

    /// The exact places where a function of one variable is not seen to differ from 0.
    pub(super) fn exact_zeros(&mut self, e: &Expr, x: &str) -> Vec<Expr> {
        if !super::slopes::has_function(e) {
            return Vec::new();
        }
        let is_zero = |place: &Expr| enclosed_at(e, x, place).is_some_and(|(low, high)| low <= 0 && high >= 0);
        self.exact_places(e, x).into_iter().map(|p| p.1).filter(is_zero).collect()
    }

    /// Where sine and cosine change their signs between the ends of an interval, from the middle one on; nothing where that is often.
    fn quadrants(&mut self, e: &Expr, x: &str, ends: &[Option<End>; 2]) -> Vec<Expr> {
        let [Some(low), Some(high)] = ends else { return Vec::new() };
        let mut arguments = Vec::new();
        turning_arguments(e, &mut arguments);
        let letter = self.letters.of(&name(x));
        let mut cuts: Vec<(Rational, Expr)> = Vec::new();
        for argument in arguments {
            let Some(p) = self.letters.polynomial(argument).filter(|p| p.variables() == [letter]) else { continue };
            // Only a linear argument is cut.
            let Ok([constant, slope]) = <[_; 2]>::try_from(p.coefficients_in(letter)) else { continue };
            let (constant, slope) = (constant.constant_term(), slope.constant_term());
            for k in -QUADRANTS..=QUADRANTS {
                let turn = super::letters::product(vec![literal(&(Rational::from_signeds(k, 2) / &slope)), name(PI)]);
                let cut = minus(&turn, &literal(&(&constant / &slope)));
                let cut = if constant == 0 { turn } else { cut };
                match enclosed(&cut) {
                    Some((a, b)) if a > low.near && b < high.near && cuts.iter().all(|c| c.1 != cut) => {
                        cuts.push((a, cut))
                    }
                    _ => {}
                }
            }
        }
        cuts.sort_by(|a, b| a.0.cmp(&b.0));
        if cuts.len() > MOST_CUTS {
            return Vec::new();
        }
        let middle = cuts.len() / 2;
        cuts.rotate_left(middle);
        cuts.into_iter().map(|cut| cut.1).collect()
    }

    /// The ends of the interval in which facts say that an expression lies: numbers, and what is made of numbers and π.
    pub(super) fn ends_of(&self, e: &Expr) -> [Option<End>; 2] {
        let mut ends: [Option<End>; 2] = [None, None];
        for (_, fact) in self.checker.facts() {
            let Some((a, said, b)) = fact.single() else { continue };
            for (this, other, said) in [(a, b, said), (b, a, said.turned())] {
                let is_lower = match said.is_greater() {
                    Some(is_lower) if this == e => is_lower,
                    _ => continue,
                };
                let Some((low, high)) = enclosed(other) else { continue };
                let near = if is_lower { high } else { low };
                let end = &mut ends[usize::from(!is_lower)];
                let is_tighter = |old: &End| match near.partial_cmp(&old.near) {
                    Some(std::cmp::Ordering::Equal) => said.strict() == said,
                    order => (order == Some(std::cmp::Ordering::Greater)) == is_lower,
                };
                if end.as_ref().is_none_or(is_tighter) {
                    *end = Some(End { at: other.clone(), near, closed: said.strict() != said });
                }
            }
        }
        ends
    }

    /// The goal in these intervals of a chart, in cases that they cover.
    fn in_runs(&mut self, goal: &Prop, f: &Function, chart: &Chart, from: usize, to: usize) -> Result<Label, Fail> {
        if to - from == 1 {
            return self.in_run(goal, f, chart, from);
        }
        let middle = from.midpoint(to);
        let cut = chart.cuts[middle - 1].clone();
        let mut cases = Vec::new();
        for (side, from, to) in [(Relation::LessEqual, from, middle), (Relation::Greater, middle, to)] {
            let case = implies(&compare(name(f.x), side, cut.clone()), goal);
            cases.push(self.block(&case, |c, _| c.in_runs(goal, f, chart, from, to))?);
        }
        self.emit(Rule::Logic { from: cases }, goal.clone())
    }

    fn in_run(&mut self, goal: &Prop, f: &Function, chart: &Chart, place: usize) -> Result<Label, Fail> {
        let own = |end: usize| f.ends[end].as_ref().map(|end| end.at.clone());
        let low = place.checked_sub(1).map_or_else(|| own(0), |k| chart.cuts.get(k).cloned());
        let high = chart.cuts.get(place).map_or_else(|| own(1), |cut| Some(cut.clone()));
        let rises = matches!(chart.runs[place], Run::Rises) == (f.relation.is_greater() == Some(true));
        match (&chart.runs[place], low, high) {
            (Run::Flat(most), Some(low), Some(high)) => self.nearly_flat(goal, f, most, &low, &high),
            (Run::Flat(_), ..) => Err(no()),
            (_, low, high) => {
                let place = if rises { low } else { high }.ok_or_else(no)?;
                self.beside_a_place(goal, f.of, f.x, f.relation, &place, false)
            }
        }
    }

    /// The goal from the value at the lower end of a short interval, and how much the function may fall from there.
    fn nearly_flat(
        &mut self,
        goal: &Prop,
        f: &Function,
        most: &Rational,
        low: &Expr,
        high: &Expr,
    ) -> Result<Label, Fail> {
        let is_positive = f.relation.is_greater() == Some(true);
        let toward = if is_positive { most.clone() } else { -most };
        let steepest = literal(&toward);
        let run = |to: &Expr| super::letters::product(vec![steepest.clone(), minus(to, low)]);
        let there = super::slopes::put_in(f.of, f.x, low)?;
        let x = name(f.x);
        let risen = sum(vec![(Sign::Plus, f.of.clone()), (Sign::Plus, run(&x)), (Sign::Minus, there.clone())]);
        let above = compare(risen.clone(), f.relation.loose(), numeral(0));
        let above = self.beside_a_place(&above, &risen, f.x, f.relation.loose(), low, false)?;
        let left = compare(minus(&there, &run(high)), f.relation, numeral(0));
        let left = self.combination(left.clone(), Vec::new()).or_else(|_| self.emit(Rule::Evaluate, left))?;
        let bound = self.known(&compare(x, Relation::LessEqual, high.clone())).ok_or_else(no)?;
        let term = |fact: Label, factor: Expr| Term { facts: vec![fact], factor };
        let terms = vec![term(above, numeral(1)), term(left, numeral(1)), term(bound, literal(&-toward))];
        self.combination(goal.clone(), terms)
    }
}

impl Function<'_> {
    /// Where the function rises and falls, as its values tell; nothing where it does so too often.
    fn chart(&self, values: &[(Rational, Rational)], exact: &[(Rational, Expr)]) -> Option<Chart> {
        let mut chart = Chart { runs: Vec::new(), cuts: Vec::new() };
        let mut place = 0;
        while place + 1 < values.len() {
            let rises = values[place + 1].1 >= values[place].1;
            let end = (place..values.len() - 1).take_while(|k| (values[k + 1].1 >= values[*k].1) == rises).last()? + 1;
            chart.runs.push(if rises { Run::Rises } else { Run::Falls });
            if end + 1 < values.len() {
                let (low, high) = (&values[end - 1].0, &values[end + 1].0);
                let zero = exact.iter().find(|(near, place)| near > low && near < high && self.may_be_zero(place));
                if values[end].1 == 0 {
                    chart.cuts.push(literal(&values[end].0));
                } else if let Some((_, place)) = zero {
                    chart.cuts.push(place.clone());
                } else {
                    let (low, high, most) = self.about(rises, low.clone(), high.clone())?;
                    chart.runs.push(Run::Flat(most));
                    chart.cuts.extend([low, high].map(|cut| literal(&cut)));
                }
            }
            if chart.runs.len() > 2 * RUNS {
                return None;
            }
            place = end;
        }
        Some(chart)
    }

    /// Whether the function has values at those ends of its domain from which its sign is to follow.
    fn begins_and_ends_with_a_value(&self, chart: &Chart) -> bool {
        let is_positive = self.relation.is_greater() == Some(true);
        let from_below = |run: &Run| matches!(run, Run::Rises) == is_positive;
        let has_value =
            |end: &Option<End>| end.as_ref().is_some_and(|end| enclosed_at(self.of, self.x, &end.at).is_some());
        let first = chart.runs.first().is_some_and(|run| !from_below(run) || has_value(&self.ends[0]));
        first && chart.runs.last().is_some_and(|run| from_below(run) || has_value(&self.ends[1]))
    }

    /// Whether the function is not seen to differ from 0 at a place.
    fn may_be_zero(&self, place: &Expr) -> bool {
        enclosed_at(self.of, self.x, place).is_none_or(|(low, high)| low <= 0 && high >= 0)
    }

    /// A short interval about a greatest or least value, and a bound of the slope there.
    fn about(
        &self,
        is_greatest: bool,
        mut low: Rational,
        mut high: Rational,
    ) -> Option<(Rational, Rational, Rational)> {
        let is_positive = self.relation.is_greater()?;
        for _ in 0..ROUNDS {
            let step = (&high - &low) / Rational::from(8);
            let points: Vec<Rational> = (0..=8).map(|k| &low + &step * Rational::from(k)).collect();
            let values: Vec<Rational> = points.iter().map(|p| value(self.of, self.x, p)).collect::<Option<_>>()?;
            let steepest = values.windows(2).map(|v| (&v[1] - &v[0]).abs() / &step).max()?;
            let most = power_of_two_above(&(steepest * Rational::from(2)));
            let size = if is_positive { values[0].clone() } else { -&values[0] };
            if size > &most * (&high - &low) * Rational::from(2) {
                return Some((low, high, most));
            }
            let best = if is_greatest { values.iter().max()? } else { values.iter().min()? };
            let place = values.iter().position(|v| v == best)?.clamp(1, 7);
            (low, high) = (points[place - 1].clone(), points[place + 1].clone());
        }
        None
    }
}

/// The arguments of sines and cosines.
fn turning_arguments<'a>(e: &'a Expr, into: &mut Vec<&'a Expr>) {
    if let ExprKind::Apply(f, list) = &e.kind
        && (f.text == "sin" || f.text == "cos")
    {
        into.extend(list);
    }
    crate::claim::walk::parts(e, &mut |part| turning_arguments(part, into));
}

/// Whether an exponent is no number: such powers are compared by their logarithms.
fn has_moving_exponent(e: &Expr) -> bool {
    let mut found = matches!(&e.kind, ExprKind::Power(_, exponent) if enclosed(exponent).is_none());
    crate::claim::walk::parts(e, &mut |part| found = found || has_moving_exponent(part));
    found
}

fn no() -> Fail {
    Fail::No("the sign chart of a function of one variable")
}

/// The value of an expression at a number, nearly; nothing where its sign is not certain.
fn value(e: &Expr, x: &str, at: &Rational) -> Option<Rational> {
    let (low, high) = enclosed_at(e, x, &literal(at))?;
    let is_certain = low > 0 || high < 0 || low == high;
    is_certain.then(|| (low + high) / Rational::from(2))
}

/// Numbers between which an expression of one variable lies at a place of it.
fn enclosed_at(e: &Expr, x: &str, place: &Expr) -> Option<(Rational, Rational)> {
    enclosed(&super::slopes::put_in(e, x, place).ok()?)
}

/// Numbers between which an expression lies that is made of numbers and π.
pub(super) fn enclosed(e: &Expr) -> Option<(Rational, Rational)> {
    let at = Assignment { is_pi: true, ..Assignment::default() };
    let value = at.number(e).ok()?;
    let (low, high) = value.ends();
    Some((low.clone(), high.clone()))
}

/// Numbers in an interval: evenly between two ends, and ever farther from one where the other is missing.
fn points(ends: &[Option<End>; 2]) -> Vec<Rational> {
    let far = |sign: i64, from: &Rational| {
        let steps = (-6..7).flat_map(|k| [4, 5, 6, 7].map(|m| Rational::from(m) * Rational::from(2).pow(k as i64 - 2)));
        steps.map(|s| from + s * Rational::from(sign)).collect::<Vec<_>>()
    };
    match ends {
        [Some(low), Some(high)] => {
            let step = (&high.near - &low.near) / Rational::from(VALUES);
            let unit = power_of_two_above(&(&step / Rational::from(16)));
            let inside = |k: i64| Rational::from(((&low.near + &step * Rational::from(k)) / &unit).floor()) * &unit;
            (1..VALUES).map(inside).filter(|p| *p > low.near && *p < high.near).collect()
        }
        [Some(low), None] => far(1, &low.near),
        [None, Some(high)] => far(-1, &high.near).into_iter().rev().collect(),
        [None, None] => {
            let zero = Rational::from(0);
            far(-1, &zero).into_iter().rev().chain([zero.clone()]).chain(far(1, &zero)).collect()
        }
    }
}

/// The least power of two that is not less than a positive number.
fn power_of_two_above(q: &Rational) -> Rational {
    let mut power = Rational::from(1);
    let two = Rational::from(2);
    while power < *q {
        power *= &two;
    }
    while *q > 0 && &power / &two >= *q {
        power /= &two;
    }
    power
}
