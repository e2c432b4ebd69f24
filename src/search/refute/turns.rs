//! Angles at multiples of π, where sines and cosines are exact: there equations of angles hold, and chance finds none of these.
//!
//! Contract: a cosine and sine are exact. What is taken for an angle costs points and nothing else: at a point
//! every hypothesis is evaluated in the claim's own words.

use super::evaluate::Assignment;
use super::number::Number;
use super::reading::Reading;
use super::search::Search;
use super::solve::{Way, ways};
use crate::claim::circle::Point;
use crate::claim::syntax::*;
use crate::claim::walk::parts;
use crate::kernel::statement::{apply, name, numeral, product};
use malachite::Rational;
use num_rational::BigRational;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

/// The most terms of a sum that are looked at.
const TERMS: usize = 32;

/// The cosine and sine of so many times π, where that is a multiple of π/120: their value in square roots.
pub(super) fn cosine_and_sine_of(turns: &Rational) -> Option<(Number, Number)> {
    let whole = |k: &malachite::Natural| k.to_string().parse().ok();
    let size = BigRational::new(whole(turns.numerator_ref())?, whole(turns.denominator_ref())?);
    let point = Point::of_turns(&if *turns < 0 { -size } else { size })?;
    let here = Assignment::default();
    let value = |e: Expr| here.number(&e).ok();
    Some((value(point.cosine(Span::default()))?, value(point.sine(Span::default()))?))
}

/// For what is chosen as a multiple of π, how the variables are computed from how many times π it is.
pub(super) type Angles = BTreeMap<String, Way>;

/// The variables that are angles: one of each summand under a sine or cosine, unless π or another angle stands in it, and what is added
/// to an angle alone or compared with one. Two variables on the unit circle are the cosine and sine of an angle.
/// None where `pi` is no number.
pub(super) fn angles(search: &Search, goal: &Prop) -> Angles {
    let mut found = Finding { real: search.real().into_iter().collect(), found: BTreeSet::new() };
    if !search.base.is_pi {
        return Angles::new();
    }
    let mut said = Vec::new();
    search.hypotheses.iter().chain([goal]).for_each(|p| comparisons(p, &mut said));
    said.iter().flat_map(|(sides, _)| sides.iter()).for_each(|e| found.under(e));
    let mut before = 0;
    while found.found.len() > before {
        before = found.found.len();
        said.iter().for_each(|(sides, _)| found.beside(sides.iter()));
        for (name, value) in search.ways().flatten() {
            found.beside([&self::name(name), value].into_iter());
        }
    }
    let alone = found.found.iter().map(|x| (x.clone(), vec![(x.clone(), turned(x))]));
    let mut out: Angles = alone.collect();
    for (x, y) in said.iter().filter_map(|(sides, relations)| on_the_circle(sides, relations)) {
        let computed = |name: &String| out.values().flatten().any(|(computed, _)| computed == name);
        if found.real.contains(&x) && found.real.contains(&y) && !computed(&x) && !computed(&y) {
            let way = vec![(x, apply("cos", turned(&y))), (y.clone(), apply("sin", turned(&y)))];
            out.insert(y, way);
        }
    }
    out
}

/// So many times π as this variable says.
fn turned(x: &str) -> Expr {
    product(vec![name(x), name(PI)])
}

/// The variables x and y of `x^2 + y^2 = 1`.
fn on_the_circle(sides: &[Expr], relations: &[Relation]) -> Option<(String, String)> {
    let ([Expr { kind: ExprKind::Sum(list), .. }, one], [Relation::Equal]) = (sides, relations) else { return None };
    let square = |(sign, e): &(Sign, Expr)| match &e.kind {
        ExprKind::Power(base, k) if *sign == Sign::Plus && **k == numeral(2) => match &base.kind {
            ExprKind::Name(name) => Some(name.clone()),
            _ => None,
        },
        _ => None,
    };
    match list.as_slice() {
        [x, y] if *one == numeral(1) => Some((square(x)?, square(y)?)).filter(|(x, y)| x != y),
        _ => None,
    }
}

/// Adds the paths on which angles are multiples of π: where equations can be read, ways to satisfy them by other variables than
/// sines and cosines, and these paths with the angles that are free there.
pub(super) fn follow(
    search: &mut Search,
    paths: Range<usize>,
    angles: &Angles,
    reading: Option<&mut Reading>,
) -> Range<usize> {
    if angles.is_empty() {
        return search.follow(&[]);
    }
    let mut out = Vec::new();
    let on_circles: Vec<&String> = angles.values().filter(|way| way.len() > 1).flatten().map(|(x, _)| x).collect();
    if !on_circles.is_empty() {
        let mut others = search.real();
        others.retain(|x| !on_circles.contains(&x));
        let more = reading.map_or_else(|| vec![Way::new()], |reading| ways(reading, &search.hypotheses, &others));
        out.extend(more.into_iter().map(|way| angles.values().flatten().cloned().chain(way).collect::<Way>()));
    }
    for way in search.ways().take(paths.end).skip(paths.start) {
        let is_free = |turns: &Way| turns.iter().all(|(x, _)| way.iter().all(|(computed, _)| computed != x));
        out.push(angles.values().filter(|turns| is_free(turns)).flatten().chain(way).cloned().collect());
    }
    search.follow(&out)
}

struct Finding {
    real: BTreeSet<String>,
    found: BTreeSet<String>,
}

impl Finding {
    /// Chooses an angle of each summand under a sine or cosine in an expression: the variable that stands last.
    fn under(&mut self, e: &Expr) {
        if let ExprKind::Apply(f, list) = &e.kind
            && matches!(f.text.as_str(), "cos" | "sin")
        {
            for summand in list.iter().filter_map(summands).flatten() {
                if summand.iter().all(|n| n != PI && !self.found.contains(n)) {
                    let last = summand.into_iter().rev().find(|n| self.real.contains(n));
                    self.found.extend(last);
                }
            }
        }
        parts(e, &mut |part| self.under(part));
    }

    /// Takes variables that stand alone in sums for angles where one of them is.
    fn beside<'e>(&mut self, sides: impl Iterator<Item = &'e Expr>) {
        let all: Vec<Vec<String>> = sides.filter_map(summands).flatten().collect();
        let alone: Vec<&String> = all.iter().filter(|s| s.len() == 1).flatten().collect();
        if alone.iter().any(|n| self.found.contains(*n)) {
            let real = alone.into_iter().filter(|n| self.real.contains(*n));
            self.found.extend(real.cloned().collect::<Vec<_>>());
        }
    }
}

/// The names in the numerators of the summands of an expression, products of sums multiplied out; `None` of too many.
fn summands(e: &Expr) -> Option<Vec<Vec<String>>> {
    Some(match &e.kind {
        ExprKind::Name(name) => vec![vec![name.clone()]],
        ExprKind::Negate(a) => summands(a)?,
        ExprKind::Sum(list) => list.iter().map(|(_, part)| summands(part)).collect::<Option<Vec<_>>>()?.concat(),
        ExprKind::Product(list) => {
            let mut out = vec![Vec::new()];
            for (_, factor) in list.iter().filter(|(factor, _)| *factor == Factor::Times) {
                let more = summands(factor)?;
                if out.len() * more.len() > TERMS {
                    return None;
                }
                out = out.iter().flat_map(|a| more.iter().map(move |b| [a.as_slice(), b].concat())).collect();
            }
            out
        }
        _ => vec![Vec::new()],
    })
    .filter(|list| list.len() <= TERMS)
}

/// The comparisons in a proposition.
fn comparisons<'p>(p: &'p Prop, out: &mut Vec<(&'p [Expr], &'p [Relation])>) {
    match &p.kind {
        PropKind::Compare(sides, relations) => out.push((sides, relations)),
        PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => {
            list.iter().for_each(|p| comparisons(p, out));
        }
        PropKind::Not(p) | PropKind::Exists(_, p) | PropKind::ForAll(_, p) => comparisons(p, out),
        PropKind::Implies(p, q) => [p, q].into_iter().for_each(|p| comparisons(p, out)),
        PropKind::Extremum(_) | PropKind::Limit(_) | PropKind::WrittenLimit(_) => {}
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // a test stops where it fails
mod tests {
    use super::*;
    use crate::claim::parse::{parse, parse_expr};
    use crate::claim::print;
    use crate::refute::counterexample::falsified;
    use crate::refute::expand::Statement;
    use std::time::Duration;

    fn statement(text: &str) -> Statement {
        Statement::of(&parse(&format!("claim c \"\"\n{text}\n")).unwrap()[0]).unwrap()
    }

    fn found(text: &str) -> Vec<String> {
        let statement = statement(text);
        let search = Search::new(&statement.bindings, Some(&statement));
        let said = |(name, e): &(String, Expr)| format!("{name} = {}", print::expr(e));
        angles(&search, &statement.goal).values().flatten().map(said).collect()
    }

    #[test]
    fn cosines_and_sines_are_exact_at_multiples_of_pi() {
        let here = Assignment { is_pi: true, ..Assignment::default() };
        let said = |text: &str| here.number(&parse_expr(text).unwrap()).unwrap().written().map(|e| print::expr(&e));
        for (text, value) in [
            ("cos(pi)", "-1"),
            ("sin(-5*pi/6)", "-1/2"),
            ("cos(7*pi/2)", "0"),
            ("sin(pi/3) - cos(pi/6)", "0"),
            ("sin(pi/12)", "sqrt(6)/4 - sqrt(2)/4"),
            ("cos(100*pi/3)", "-1/2"),
        ] {
            assert_eq!(said(text).as_deref(), Some(value), "{text}");
        }
        // Enclosed alone: it is no multiple of π/120, or no multiple of π.
        for text in ["cos(pi/7)", "cos(pi^2)", "sin(1)", "sin(1 + pi)", "cos(sqrt(2)*pi)"] {
            assert_eq!(said(text), None, "{text}");
        }
        let unknown = Assignment::default().number(&parse_expr("cos(pi)").unwrap());
        assert!(unknown.is_err(), "a claim that declares pi");
    }

    #[test]
    fn one_variable_of_each_summand_is_an_angle() {
        let none: [&str; 0] = [];
        assert_eq!(found("given t, w real\nprove cos(w*t/2) = 1"), ["t = t*pi"]);
        assert_eq!(found("given a, b, c real\nassume a + b + c = 3*pi\nprove sin(a^2) > 0"), none);
        assert_eq!(
            found("given a, b, c real\nassume a + b + c = 3*pi\nassume sin(b)^3 > a^2\nprove a > 0"),
            ["a = a*pi", "b = b*pi", "c = c*pi"]
        );
        assert_eq!(found("given x, l > 0; n natural\nprove sin(n*pi*x/l) <= 1"), none);
        assert_eq!(found("given pi, x > 0\nprove sin(x) <= 1/2"), none);
        assert_eq!(found("given x, y real\nassume x^2 + y^2 = 1\nprove x = 1"), ["x = cos(y*pi)", "y = sin(y*pi)"]);
        assert_eq!(found("given x, y real\nassume x^2 + y^2 = 2\nprove x = 1"), none);
    }

    #[test]
    fn counterexamples_are_multiples_of_pi() {
        let point = |text: &str| {
            let witness = falsified(&statement(text), Some(Duration::from_secs(20)))?;
            Some(witness.point.values.iter().map(|(n, v)| format!("{n} = {v}")).collect::<Vec<_>>().join(", "))
        };
        for (text, found) in [
            ("given x real\nassume sin(x) = 0\nprove x = 0", Some("x = pi")),
            ("given x in [0, pi]\nassume sin(x) = 1/2\nprove x = pi/6", Some("x = 5*pi/6")),
            ("given a real\nassume 3*a = pi\nprove cos(a) = -1/2", Some("a = pi/3")),
            ("given a real\nassume 3*a = pi\nprove cos(a) = 1/2", None),
            ("given x in (0, pi)\nassume sin(x) = 1\nprove x = pi/2", None),
        ] {
            assert_eq!(point(text).as_deref(), found, "{text}");
        }
    }
}
