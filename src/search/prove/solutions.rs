//! Values that satisfy equations: rational numbers and roots of these, for an `exists` whose variables they determine.
//!
//! A candidate is only proposed here; that it solves the equations is shown by the kernel.

use super::Prover;
use super::facts::minus;
use super::letters::{Letters, product};
use super::products::Kind;
use crate::algebra::{Polynomial, factor};
use crate::certificate::Rule;
use crate::claim::syntax::*;
use crate::kernel::statement::{apply, expr, name, numeral};
use crate::kernel::substitution::Substitution;
use crate::refute::literal::literal;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::CheckedSqrt;
use malachite::base::num::basic::traits::Zero;
use malachite::base::num::conversion::traits::IsInteger;
use std::collections::BTreeMap;

/// How many times free variables are given other values.
pub(crate) const ROUNDS: usize = 24;

/// Values for names.
type Point = Vec<(String, Expr)>;

/// What free variables are given, in this order from some place on.
fn seed(place: usize) -> Rational {
    const SEEDS: [(i64, i64); 11] =
        [(1, 1), (2, 1), (1, 2), (3, 1), (5, 1), (1, 3), (4, 1), (12, 1), (-1, 1), (1, 10), (0, 1)];
    let (n, d) = SEEDS[place % SEEDS.len()];
    Rational::from_signeds(n, d)
}

impl Prover {
    /// A value in other letters that is whole by its form, as 2·q for n/2 where n = 4·q: a multiple of an expression that is known to
    /// be 0 is taken from it while coefficients are left that are not whole.
    pub(super) fn whole_by_equations(&mut self, value: &Expr) -> Option<Expr> {
        self.define(value);
        let value = self.simplified(value)?;
        let mut poly = self.letters.polynomial(&value)?;
        let known = self.all_known(std::slice::from_ref(&poly));
        let zeros: Vec<&Polynomial> = known.iter().filter(|k| k.kind == Kind::Zero).map(|k| &k.poly).collect();
        for _ in 0..2 * zeros.len() + 2 {
            if broken(&poly) == (0, 0) {
                let letters = poly.variables();
                return (self.whole_letters(letters.iter().copied()).len() == letters.len())
                    .then(|| self.letters.written(&poly));
            }
            poly = zeros.iter().find_map(|zero| self.with_less_broken(&poly, zero))?;
        }
        None
    }

    /// The polynomial less a multiple of one that is 0, or with a variable put in, where fewer coefficients are not whole.
    fn with_less_broken(&self, poly: &Polynomial, zero: &Polynomial) -> Option<Polynomial> {
        let multiple = poly.terms().filter(|t| !t.1.is_integer()).find_map(|(monomial, c)| {
            let own = zero.coefficient(monomial);
            let less = (own != 0).then(|| poly.sub(&zero.scale(&(c / own))))?;
            (broken(&less) < broken(poly)).then_some(less)
        });
        multiple.or_else(|| {
            let is_integral = |p: &Polynomial| broken(p) == (0, 0);
            let v = poly.variables().into_iter().find(|v| {
                let some = poly.coefficients_in(*v).iter().skip(1).any(|c| !is_integral(c));
                some && zero.degree_in(*v) == 1
            })?;
            let [rest, slope] = zero.coefficients_in(v).try_into().ok()?;
            let value = rest.scale(&(Rational::from(-1) / slope.as_constant()?));
            is_integral(&value).then(|| poly.substitute(v, &value).ok())?
        })
    }

    /// A point that satisfies a conjunction with equations, as far as arithmetic tells; the equations are not checked.
    pub(crate) fn solved(&mut self, bindings: &[Binding], body: &Prop) -> Option<Point> {
        let names: Vec<String> = bindings
            .iter()
            .filter(|b| !b.natural)
            .flat_map(|b| &b.names)
            .filter(|n| n.1.is_none())
            .map(|n| n.0.text.clone())
            .collect();
        if names.len() != bindings.iter().map(|b| b.names.len()).sum::<usize>() {
            return None;
        }
        let mut facts: Vec<Prop> = bindings.iter().flat_map(crate::kernel::statement::domain).collect();
        conjuncts(body, &mut facts);
        let (equations, others): (Vec<Prop>, Vec<Prop>) =
            facts.into_iter().partition(|p| matches!(&p.kind, PropKind::Compare(_, r) if *r == [Relation::Equal]));
        let system = System::new(&names, &equations)?;
        (0..ROUNDS).find_map(|round| {
            let point = system.point(round)?;
            let mut map = Substitution::default();
            point.iter().for_each(|(n, value)| map.replace(n, value));
            let holds = |c: &mut Prover, p: &Prop| {
                map.prop(p).is_ok_and(|at| c.attempt(|c| c.emit(Rule::Evaluate, at)).is_ok())
            };
            others.iter().all(|p| holds(self, p)).then_some(point)
        })
    }
}

/// How many coefficients are not whole, without that of 1 and with it: it may become whole when the others are.
fn broken(p: &Polynomial) -> (usize, usize) {
    let open = || p.terms().filter(|t| !t.1.is_integer());
    (open().filter(|t| !t.0.is_one()).count(), open().count())
}

/// The parts of a conjunction.
pub(super) fn conjuncts(p: &Prop, out: &mut Vec<Prop>) {
    match &p.kind {
        PropKind::And(list) => list.iter().for_each(|p| conjuncts(p, out)),
        _ => out.push(p.clone()),
    }
}

/// Polynomial equations, those that are linear in a variable solved for it.
struct System {
    letters: Letters,
    names: Vec<(String, u32)>,
    /// Variables with what they are, in others.
    solved: Vec<(u32, Polynomial)>,
    equations: Vec<Polynomial>,
}

impl System {
    /// The equations in these variables and no others; `None` without one.
    fn new(names: &[String], equations: &[Prop]) -> Option<System> {
        let mut letters = Letters::default();
        let names: Vec<(String, u32)> = names.iter().map(|n| (n.clone(), letters.of(&name(n)))).collect();
        let mut polys = Vec::new();
        for p in equations {
            let PropKind::Compare(sides, _) = &p.kind else { return None };
            let poly = letters.polynomial(&minus(&sides[0], &sides[1]))?;
            if poly.variables().iter().any(|v| names.iter().all(|n| n.1 != *v)) {
                return None;
            }
            polys.push(poly);
        }
        let mut system = System { letters, names, solved: Vec::new(), equations: polys };
        while system.eliminate() {}
        (!system.equations.is_empty() || !system.solved.is_empty()).then_some(system)
    }

    /// Solves one equation for a variable in which it is linear with a number before it; whether there was one.
    fn eliminate(&mut self) -> bool {
        let found = self.equations.iter().enumerate().find_map(|(place, p)| {
            let v = p.variables().into_iter().rev().find(|v| {
                let parts = p.coefficients_in(*v);
                parts.len() == 2 && parts[1].is_constant()
            })?;
            Some((place, v))
        });
        let Some((place, v)) = found else { return false };
        let parts = self.equations.remove(place).coefficients_in(v);
        let Some(slope) = parts[1].as_constant() else { return false };
        let value = parts[0].scale(&(Rational::from(-1) / slope));
        for p in self.equations.iter_mut().chain(self.solved.iter_mut().map(|s| &mut s.1)) {
            *p = put(p, v, &value);
        }
        self.equations.retain(|p| !p.is_zero());
        self.solved.push((v, value));
        true
    }

    /// Values for all variables, free ones by the number of the round.
    fn point(&self, round: usize) -> Option<Point> {
        let mut equations = self.equations.clone();
        let mut values: BTreeMap<u32, Expr> = BTreeMap::new();
        let mut count = round;
        let give = |equations: &mut Vec<Polynomial>, values: &mut BTreeMap<u32, Expr>, v: u32, q: Rational| {
            let constant = Polynomial::constant(q.clone());
            equations.iter_mut().for_each(|p| *p = put(p, v, &constant));
            values.insert(v, literal(&q));
        };
        while let Some(place) = (0..equations.len()).min_by_key(|i| equations[*i].variables().len()) {
            let variables = equations[place].variables();
            match variables.as_slice() {
                [] if equations[place].is_zero() => {
                    equations.remove(place);
                }
                [] => return None,
                [v] => {
                    let roots = roots(&equations.remove(place), *v);
                    match roots.into_iter().cycle().nth(round % (ROUNDS / 2))? {
                        Root::Rational(q) => give(&mut equations, &mut values, *v, q),
                        Root::Radical(e) if equations.iter().all(|p| !p.contains(*v)) => {
                            values.insert(*v, e);
                        }
                        Root::Radical(_) => return None,
                    }
                }
                // The first and the last in turn: where one is free, the other may have one value.
                [first, .., last] => {
                    let v = if round < ROUNDS / 2 { first } else { last };
                    give(&mut equations, &mut values, *v, seed(count));
                    count += 1;
                }
            }
        }
        let dependent = |v: u32| self.solved.iter().any(|s| s.0 == v);
        for (_, v) in &self.names {
            if !dependent(*v) && !values.contains_key(v) {
                values.insert(*v, literal(&seed(count)));
                count += 1;
            }
        }
        let mut map = Substitution::default();
        for (n, v) in &self.names {
            if let Some(e) = values.get(v) {
                map.replace(n, e);
            }
        }
        for (v, p) in &self.solved {
            values.insert(*v, map.expr(&self.letters.written(p)).ok()?);
        }
        self.names.iter().map(|(n, v)| Some((n.clone(), values.get(v)?.clone()))).collect()
    }
}

/// A polynomial with another in the place of a variable.
fn put(p: &Polynomial, v: u32, value: &Polynomial) -> Polynomial {
    if !p.contains(v) {
        return p.clone();
    }
    p.coefficients_in(v).iter().rev().fold(Polynomial::zero(), |sum, c| sum.mul(value).add(c))
}

/// q·e; e where q is 1.
pub(super) fn times(q: Rational, e: Expr) -> Expr {
    if q == 1 { e } else { product(vec![literal(&q), e]) }
}

/// The real roots of a polynomial in a variable, as far as its factors have degree 1 or 2 or are c·x^k + d.
fn roots(p: &Polynomial, v: u32) -> Vec<Root> {
    let parts = |p: &Polynomial| p.coefficients_in(v).iter().map(Polynomial::as_constant).collect::<Option<Vec<_>>>();
    // What has degree 1 or 2 needs no factors.
    let factors = match (p.degree_in(v) > 2).then(|| factor::factor(p)) {
        Some(Ok(all)) => all.factors.into_iter().map(|f| f.0).collect(),
        _ => vec![p.clone()],
    };
    let both = |f: &Polynomial| parts(f).map(|c| [false, true].map(|lesser| root(&c, lesser))).into_iter().flatten();
    factors.iter().flat_map(both).flatten().collect()
}

#[derive(Clone)]
enum Root {
    Rational(Rational),
    Radical(Expr),
}

/// A real root of a polynomial of degree 1 or 2, or of c·x^k + d: the lesser one where `lesser`.
fn root(c: &[Rational], lesser: bool) -> Option<Root> {
    let one = Rational::from(1);
    let fraction = |a: Expr, b: Expr| expr(ExprKind::Product(vec![(Factor::Times, a), (Factor::Over, b)]));
    match c {
        [a, b] => Some(Root::Rational(-a / b)),
        [a, b, c] => {
            let square = b * b - Rational::from(4) * a * c;
            if square < 0 {
                return None;
            }
            let sign = Rational::from(if lesser == (*c > 0) { -1 } else { 1 });
            let below = Rational::from(2) * c;
            if let Some(exact) = (&square).checked_sqrt() {
                return Some(Root::Rational((sign * exact - b) / below));
            }
            // −b/(2c) ± sqrt(b² − 4ac)/(2c)
            // Without factors 4 under the root, and without a factor 1.
            let (four, mut square, mut factor) = (Rational::from(4), square, sign / &below);
            while (&square / &four).is_integer() {
                square /= &four;
                factor *= Rational::from(2);
            }
            let radical = apply("sqrt", literal(&square));
            let term = times(factor, radical);
            Some(Root::Radical(if *b == Rational::ZERO {
                term
            } else {
                expr(ExprKind::Sum(vec![(Sign::Plus, literal(&(-b / below))), (Sign::Plus, term)]))
            }))
        }
        [first, middle @ .., last] if middle.iter().all(|q| *q == Rational::ZERO) => {
            let k = u32::try_from(c.len() - 1).ok()?;
            let power = -first / last;
            let even = k % 2 == 0;
            if power == Rational::ZERO {
                return Some(Root::Rational(power));
            }
            if even && power < 0 {
                return None;
            }
            let negative = power < 0 || (even && lesser);
            let size = if power < 0 { -power } else { power };
            let exponent = fraction(numeral(1), numeral(k));
            let radical = expr(ExprKind::Power(Box::new(literal(&size)), Box::new(exponent)));
            let sign = if negative { Rational::from(-1) } else { one };
            Some(Root::Radical(times(sign, radical)))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_roots_of_x_squared_minus_x_minus_1_are_written_in_full() {
        let c = [-1, -1, 1].map(Rational::from);
        let text = |lesser| match root(&c, lesser) {
            Some(Root::Radical(e)) => crate::claim::print::expr(&e),
            _ => String::new(),
        };
        assert_eq!(text(false), "1/2 + (1/2)*sqrt(5)");
        assert_eq!(text(true), "1/2 + (-1/2)*sqrt(5)");
        assert!(root(&[1, 0, 1].map(Rational::from), false).is_none());
    }

    #[test]
    fn a_variable_that_occurs_linearly_is_eliminated_before_a_quadratic_is_solved() {
        let claim = "claim t \"t\"\nprove exists x, y real: x + y = 5 and x*y = 1\n";
        let claims = crate::claim::parse::parse(claim).expect("a claim");
        let PropKind::Exists(_, body) = &claims[0].goal.kind else { panic!("exists") };
        let mut facts = Vec::new();
        conjuncts(body, &mut facts);
        let system = System::new(&["x".to_string(), "y".to_string()], &facts).expect("equations");
        let point = system.point(0).expect("a point");
        let shown: Vec<String> = point.iter().map(|(n, e)| format!("{n} = {}", crate::claim::print::expr(e))).collect();
        assert_eq!(shown, ["x = 5/2 + (1/2)*sqrt(21)", "y = 5 - (5/2 + (1/2)*sqrt(21))"]);
    }
}
