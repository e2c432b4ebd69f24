//! Equations among the hypotheses solved for variables, so that these are computed at a point and not guessed.
//!
//! Contract: none is needed. At a point every hypothesis is evaluated in the claim's own words, so what is solved wrongly
//! costs points and nothing else.
//!
//! An equation is read as a polynomial and factored. A factor that the other hypotheses keep from being 0 is dropped; each
//! that is left makes a way of its own to satisfy the equation. In it a variable of degree 1 is computed from the others, the
//! variable declared last first: from the laws of a collision the velocities after it are found, not the masses.

use super::literal::literal;
use super::reading::Reading;
use crate::algebra::positivity::{self, Constraint};
use crate::algebra::{Polynomial, factor};
use crate::claim::syntax::*;
use crate::claim::walk::names_in;
use crate::kernel::statement::{apply, compare, expr, numeral};
use crate::kernel::substitution::Substitution;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::CheckedSqrt;
use malachite::base::num::basic::traits::One;
use std::collections::BTreeSet;

/// The most variables that are computed.
const SOLVED: usize = 24;

/// The most terms of all equations that are read, one after the other.
const WORK: usize = 6_000;

/// The most ways to satisfy the equations.
const WAYS: usize = 4;

/// The most exponentials and logarithms that are inverted.
const INVERSIONS: usize = 4;

/// The most terms of a polynomial that is factored, or of which the sign is sought.
const TERMS: usize = 60;

/// The highest degree of a polynomial of which the sign is sought.
const DEGREE: u32 = 8;

/// Values for all variables but one, where an equation has no variable of degree 1.
const SMALL: [i32; 5] = [1, 2, 0, 3, -1];

/// Values of variables by other variables, in an order in which they can be computed. A variable whose value speaks of the
/// variable itself is chosen first, and what was chosen is the parameter.
pub(crate) type Way = Vec<(String, Expr)>;

/// Ways to satisfy the equations among the hypotheses by values of these variables, those that come last first; one empty
/// way where there is nothing to solve.
pub(crate) fn ways(reading: &mut Reading, hypotheses: &[Prop], variables: &[String]) -> Vec<Way> {
    let mut comparisons = Vec::new();
    hypotheses.iter().for_each(|p| flatten(p, &mut comparisons));
    let (equations, others) = comparisons.into_iter().partition(|c| c.1 == Relation::Equal);
    let mut solver = Solver { reading, variables, found: Vec::new(), work: WORK, inversions: INVERSIONS };
    solver.solve(equations, others, Vec::new());
    if solver.found.is_empty() {
        solver.found.push(Vec::new());
    }
    solver.found
}

/// Ways to satisfy an equation besides the hypotheses. Where no variable can be computed from the others, they are points:
/// rational values of one variable for small values of the others.
pub(super) fn on_an_edge(reading: &mut Reading, edge: Prop, hypotheses: &[Prop], variables: &[String]) -> Vec<Way> {
    let PropKind::Compare(sides, _) = &edge.kind else { return Vec::new() };
    let Some((p, _)) = reading.difference(&sides[0], &sides[1]) else { return Vec::new() };
    if p.is_constant() {
        return Vec::new();
    }
    let letters: Vec<(u32, Expr)> = p.variables().into_iter().map(|v| (v, reading.letter(v))).collect();
    let linear = letters.iter().any(|(v, e)| is_one_of(e, variables) && p.degree_in(*v) == 1);
    let both: Vec<Prop> = std::iter::once(edge).chain(hypotheses.iter().cloned()).collect();
    let mut found = ways(reading, &both, variables);
    if linear {
        return found;
    }
    if found.iter().all(Vec::is_empty) {
        found = at_small_values(&p, &letters, variables);
    }
    // What is nowhere negative is 0 where its derivatives are.
    let mut gradient = Vec::new();
    for (v, _) in letters.iter().filter(|(v, e)| p.degree_in(*v) > 1 && is_one_of(e, variables)) {
        gradient.push(compare(reading.words(&p.derivative(*v)), Relation::Equal, numeral(0)));
    }
    if !gradient.is_empty() {
        gradient.extend(hypotheses.iter().cloned());
        found.extend(ways(reading, &gradient, variables));
    }
    found
}

/// Points at which a polynomial of these letters is 0.
fn at_small_values(p: &Polynomial, letters: &[(u32, Expr)], variables: &[String]) -> Vec<Way> {
    if p.term_count() > TERMS || letters.iter().any(|(_, e)| !is_one_of(e, variables)) {
        return Vec::new();
    }
    let mut out: Vec<Way> = Vec::new();
    for ((v, e), turn) in letters.iter().rev().flat_map(|letter| (0..SMALL.len()).map(move |turn| (letter, turn))) {
        let value = |other: u32| match letters.iter().position(|l| l.0 == other) {
            Some(place) if other != *v => Some(Rational::from(SMALL[(turn + place * turn) % SMALL.len()])),
            _ => None,
        };
        let Ok(factors) = factor::factor(&p.evaluate_some(&value)) else { continue };
        let others = letters.iter().filter_map(|(other, name)| Some((name, value(*other)?)));
        let others: Vec<(&Expr, Rational)> = others.collect();
        for root in factors.factors.iter().filter(|f| f.0.degree() == 1).map(|f| &f.0) {
            let root = -root.constant_term() / root.leading_coefficient();
            let all = others.iter().cloned().chain([(e, root)]);
            let named = all.filter_map(|(e, value)| match &e.kind {
                ExprKind::Name(name) => Some((name.clone(), literal(&value))),
                _ => None,
            });
            out.push(named.collect());
            if out.len() >= WAYS {
                return out;
            }
        }
    }
    out
}

fn is_one_of(e: &Expr, variables: &[String]) -> bool {
    matches!(&e.kind, ExprKind::Name(name) if variables.contains(name))
}

/// A comparison of two sides.
type Comparison = (Expr, Relation, Expr);

fn flatten(p: &Prop, out: &mut Vec<Comparison>) {
    match &p.kind {
        PropKind::And(list) => list.iter().for_each(|p| flatten(p, out)),
        PropKind::Compare(sides, relations) => {
            for (pair, relation) in sides.windows(2).zip(relations) {
                match (&pair[0].kind, &pair[1].kind) {
                    (ExprKind::Matrix(a), ExprKind::Matrix(b)) => {
                        let entries = a.iter().flatten().zip(b.iter().flatten());
                        out.extend(entries.map(|(a, b)| (a.clone(), *relation, b.clone())));
                    }
                    _ => out.push((pair[0].clone(), *relation, pair[1].clone())),
                }
            }
        }
        _ => {}
    }
}

/// A variable with its value by an equation c·x + d = 0.
struct Solution {
    name: String,
    value: Expr,
    /// c and d, where c may be 0: then the equation says that d is 0 as well.
    vanishing: Option<[Polynomial; 2]>,
}

struct Solver<'a> {
    reading: &'a mut Reading,
    variables: &'a [String],
    found: Vec<Way>,
    /// The terms that may still be read.
    work: usize,
    /// How often an exponential or logarithm may still be inverted.
    inversions: usize,
}

impl Solver<'_> {
    /// `solved` holds the variables in the order in which they were solved for: each value speaks of those that come later.
    fn solve(&mut self, equations: Vec<Comparison>, others: Vec<Comparison>, solved: Way) {
        if self.found.len() >= WAYS {
            return;
        }
        if equations.iter().any(|(a, _, b)| self.read(a, b).is_some_and(|p| p.is_constant() && !p.is_zero())) {
            return;
        }
        if solved.len() < SOLVED {
            for (place, (a, _, b)) in equations.iter().enumerate() {
                let Some(p) = self.read(a, b) else { continue };
                let open = self.open_factors(&p, &others);
                let solutions: Vec<_> = open.iter().filter_map(|f| self.solution(f, &others, &solved)).collect();
                if solutions.is_empty() {
                    continue;
                }
                let mut degenerate = Vec::new();
                for Solution { name, value, vanishing } in solutions {
                    degenerate.extend(vanishing);
                    let mut put = Substitution::default();
                    put.replace(&name, &value);
                    let rest = equations.iter().enumerate().filter(|(other, _)| *other != place).map(|(_, c)| c);
                    let rest = rest.filter_map(|c| replaced(&put, c)).collect();
                    let others = others.iter().filter_map(|c| replaced(&put, c)).collect();
                    let solved = solved.iter().cloned().chain([(name, value)]).collect();
                    self.solve(rest, others, solved);
                }
                for both in degenerate {
                    let mut rest = equations.clone();
                    rest.splice(place..=place, both.map(|p| (self.reading.words(&p), Relation::Equal, numeral(0))));
                    self.solve(rest, others.clone(), solved.clone());
                }
                return;
            }
            for (place, (a, _, b)) in equations.iter().enumerate() {
                let Some(inverted) = self.read(a, b).and_then(|p| self.inverted(&p)) else { continue };
                let mut equations = equations.clone();
                equations[place] = inverted;
                return self.solve(equations, others, solved);
            }
            for (place, (a, _, b)) in equations.iter().enumerate() {
                let Some(values) = self.on_a_circle(a, b, &solved) else { continue };
                let mut put = Substitution::default();
                values.iter().for_each(|(name, value)| put.replace(name, value));
                let rest = equations.iter().enumerate().filter(|(other, _)| *other != place).map(|(_, c)| c);
                let rest = rest.filter_map(|c| replaced(&put, c)).collect();
                let others = others.iter().filter_map(|c| replaced(&put, c)).collect();
                self.solve(rest, others, solved.iter().cloned().chain(values).collect());
                break;
            }
        }
        if self.found.len() < WAYS {
            self.found.push(solved.into_iter().rev().collect());
        }
    }

    /// The difference of two sides as a polynomial over what is not 0, while there is work left.
    fn read(&mut self, a: &Expr, b: &Expr) -> Option<Polynomial> {
        if self.work == 0 {
            return None;
        }
        let (p, _) = self.reading.difference(a, b)?;
        self.work = self.work.saturating_sub(p.term_count());
        Some(p)
    }

    /// An equation c·exp(a) + d = 0 as a = ln(−d/c), and one of a logarithm by the exponential.
    fn inverted(&mut self, p: &Polynomial) -> Option<Comparison> {
        self.inversions = self.inversions.checked_sub(1)?;
        let letters: Vec<(u32, Expr)> = p.variables().into_iter().map(|v| (v, self.reading.letter(v))).collect();
        letters.into_iter().filter(|(letter, _)| p.degree_in(*letter) == 1).find_map(|(letter, e)| {
            let ExprKind::Apply(f, arguments) = &e.kind else { return None };
            let [a] = arguments.as_slice() else { return None };
            let inverse = if f.text == "exp" { "ln" } else { "exp" };
            let mut names = BTreeSet::new();
            names_in(a, &mut names);
            if !["exp", "ln"].contains(&f.text.as_str()) || !self.variables.iter().any(|name| names.contains(name)) {
                return None;
            }
            let [rest, coefficient] = p.coefficients_in(letter).try_into().ok()?;
            Some((a.clone(), Relation::Equal, apply(inverse, self.root_of(&coefficient, &rest))))
        })
    }

    /// The value −d/c that c·x + d = 0 gives x.
    fn root_of(&self, c: &Polynomial, d: &Polynomial) -> Expr {
        let (above, below) = (self.reading.words(&d.neg()), self.reading.words(c));
        expr(ExprKind::Product(vec![(Factor::Times, above), (Factor::Over, below)]))
    }

    /// Points of a circle x² + y² = r², by what was chosen for y as the tangent t of half their angle:
    /// x = r·(1 − t²)/(1 + t²), y = 2·r·t/(1 + t²). x is computed first.
    fn on_a_circle(&mut self, a: &Expr, b: &Expr, solved: &Way) -> Option<Way> {
        let (p, below) = self.reading.difference(a, b)?;
        below.as_constant()?;
        let letters: [u32; 2] = p.variables().try_into().ok()?;
        let square = |v: u32| Polynomial::variable(v).mul(&Polynomial::variable(v));
        let squares = square(letters[0]).add(&square(letters[1]));
        let scale = Rational::ONE / p.leading_coefficient();
        let rest = squares.sub(&p.scale(&scale)).as_constant()?;
        // There is no root of a negative number, and malachite would break off.
        let radius = if rest < 0 { None } else { rest.checked_sqrt() }?;
        let names = letters.map(|v| match self.reading.letter(v).kind {
            ExprKind::Name(name) if self.variables.contains(&name) && solved.iter().all(|s| s.0 != name) => Some(name),
            _ => None,
        });
        let [Some(x), Some(y)] = names else { return None };
        let parsed = |text: String| crate::claim::parse::parse_expr(&text).ok();
        Some(vec![
            (y.clone(), parsed(format!("{radius}*2*{y}/(1 + {y}^2)"))?),
            (x, parsed(format!("{radius}*(1 - {y}^2)/(1 + {y}^2)"))?),
        ])
    }

    /// The factors of a polynomial that may be 0.
    fn open_factors(&mut self, p: &Polynomial, others: &[Comparison]) -> Vec<Polynomial> {
        if p.is_constant() || p.term_count() > TERMS {
            return if p.is_constant() { Vec::new() } else { vec![p.clone()] };
        }
        let Ok(factors) = factor::factor(p) else { return vec![p.clone()] };
        let all: Vec<Polynomial> = factors.factors.into_iter().map(|f| f.0).collect();
        if let [single] = all.as_slice() {
            return vec![single.clone()];
        }
        all.into_iter().filter(|f| !self.is_never_zero(f, others)).collect()
    }

    /// A variable of degree 1 with its value: first one whose coefficient is not 0 by the other hypotheses.
    fn solution(&mut self, p: &Polynomial, others: &[Comparison], solved: &Way) -> Option<Solution> {
        let letters: Vec<(u32, Expr)> = p.variables().into_iter().map(|v| (v, self.reading.letter(v))).collect();
        let mut second = None;
        for name in self.variables.iter().rev().filter(|name| solved.iter().all(|s| s.0 != **name)) {
            let is_it = |e: &Expr| matches!(&e.kind, ExprKind::Name(n) if n == name);
            let Some((letter, _)) = letters.iter().find(|l| is_it(&l.1)) else { continue };
            let mut elsewhere = BTreeSet::new();
            letters.iter().filter(|l| l.0 != *letter).for_each(|l| names_in(&l.1, &mut elsewhere));
            if p.degree_in(*letter) != 1 || elsewhere.contains(name) {
                continue;
            }
            let [rest, coefficient] = p.coefficients_in(*letter).try_into().ok()?;
            let value = self.root_of(&coefficient, &rest);
            if self.is_never_zero(&coefficient, others) {
                return Some(Solution { name: name.clone(), value, vanishing: None });
            }
            second = second.or(Some(Solution { name: name.clone(), value, vanishing: Some([coefficient, rest]) }));
        }
        second
    }

    /// Whether other hypotheses keep a polynomial from being 0.
    fn is_never_zero(&mut self, p: &Polynomial, others: &[Comparison]) -> bool {
        if let Some(c) = p.as_constant() {
            return c != 0;
        }
        let mut constraints = Vec::new();
        for (a, relation, b) in others {
            let (a, b) = match relation {
                Relation::Less | Relation::LessEqual => (b, a),
                _ => (a, b),
            };
            let Some((poly, below)) = self.reading.difference(a, b) else { continue };
            if *relation == Relation::NotEqual {
                // A multiple of p that is not 0.
                if poly.exact_divide(p).is_some() {
                    return true;
                }
                continue;
            }
            if below.as_constant().is_none_or(|c| c <= 0) {
                continue;
            }
            let strict = matches!(relation, Relation::Less | Relation::Greater);
            if strict && poly.exact_divide(p).is_some_and(|q| q.is_constant()) {
                return true;
            }
            constraints.push(Constraint { poly, strict });
        }
        if p.term_count() > TERMS || p.degree() > DEGREE {
            return false;
        }
        let known: BTreeSet<u32> = p.variables().into_iter().collect();
        constraints.retain(|c| c.poly.variables().iter().all(|v| known.contains(v)));
        let limits = positivity::Limits { extra_degree: 0, ..positivity::Limits::default() };
        let positive = |p: &Polynomial| positivity::certify(p, &constraints, &[], true, &limits).is_some();
        positive(p) || positive(&p.neg())
    }
}

fn replaced(put: &Substitution, (a, relation, b): &Comparison) -> Option<Comparison> {
    let PropKind::Compare(sides, _) = put.prop(&compare(a.clone(), *relation, b.clone())).ok()?.kind else {
        return None;
    };
    let [a, b] = sides.try_into().ok()?;
    Some((a, *relation, b))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claim::parse::parse;
    use crate::claim::print;
    use crate::refute::expand::Statement;

    fn solved(text: &str) -> Vec<String> {
        let claims = parse(&format!("claim c \"\"\n{text}\nprove 0 = 0\n")).expect("it parses");
        let statement = Statement::of(&claims[0]).expect("within limits");
        let mut reading = Reading::of(&statement, &statement.bindings).expect("it is read");
        let mut hypotheses: Vec<Prop> = statement.assumptions.iter().map(|a| a.1.clone()).collect();
        hypotheses.extend(statement.bindings.iter().flat_map(crate::kernel::statement::domain));
        let names = statement.bindings.iter().flat_map(|b| &b.names).map(|n| n.0.text.clone());
        let names: Vec<String> = names.collect();
        let written = |way: &Way| way.iter().map(|(n, e)| format!("{n} = {}", print::expr(e))).collect::<Vec<_>>();
        ways(&mut reading, &hypotheses, &names).iter().map(|way| written(way).join("; ")).collect()
    }

    #[test]
    fn each_factor_that_may_vanish_is_a_way_of_its_own() {
        assert_eq!(solved("given x, y real\nassume x*y = 0").len(), 2);
        assert_eq!(solved("given x > 0; y real\nassume x*y = 0").len(), 1);
        assert_eq!(solved("given x, y real\nassume x != y\nassume x^2 = y^2").len(), 1);
        assert_eq!(solved("given x, y real\nassume x^3 + y^2 = 1"), [""]);
    }

    #[test]
    fn points_of_a_circle_are_rational_for_rational_parameters() {
        let way = "x = 5/2*(1 - y^2)/(1 + y^2); y = 5/2*2*y/(1 + y^2)";
        assert_eq!(solved("given x, y real\nassume 4*x^2 + 4*y^2 = 25"), [way, ""]);
        assert_eq!(solved("given x, y real\nassume x^2 + y^2 = 2"), [""]);
        assert_eq!(solved("given x, y real\nassume x^2 + 2*y^2 = 1"), [""]);
    }

    #[test]
    fn a_collision_is_solved_for_the_velocities_after_it() {
        let ways = solved(
            "given m1, m2 > 0; u1, u2, v1, v2 real\nassume m1*u1 + m2*u2 = m1*v1 + m2*v2\n\
             assume m1*u1^2 + m2*u2^2 = m1*v1^2 + m2*v2^2\nassume v1 != u1",
        );
        assert_eq!(ways.len(), 1, "{ways:?}");
        let names: Vec<&str> = ways[0].split("; ").filter_map(|way| way.split(" = ").next()).collect();
        assert_eq!(names, ["v1", "v2"]);
    }
}
