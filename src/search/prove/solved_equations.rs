//! Roots of equations, as expressions in the other letters: the values that an `exists` with an equation needs.
//!
//! Method: the difference of an equation's sides is read as a polynomial and factored. A factor of degree 1 in a variable, a factor
//! a·x^k + b, and a factor of degree 2 in a power of x give values. Where there are more variables than equations, the partial
//! derivatives are equations too: a function that takes its greatest or least value inside a domain is stationary there.
//!
//! A value is only proposed here; that it solves the equations is shown by the kernel.

use super::letters::product;
use super::limits::over;
use super::{Fail, Prover, facts::minus};
use crate::algebra::Polynomial;
use crate::algebra::factor::{exact_root, factor};
use crate::certificate::Label;
use crate::claim::syntax::*;
use crate::kernel::statement::{apply, expr, name, numeral, prop};
use crate::kernel::substitution::Substitution;
use crate::refute::literal::literal;
use malachite::Rational;

/// The most points that are tried for one goal.
const MOST_POINTS: usize = 12;
/// The most terms of a polynomial that is factored.
const MOST_TERMS: usize = 200;

/// Values for names.
type Point = Vec<(String, Expr)>;

impl Prover {
    /// Proves an `exists` by roots of its equations.
    pub(super) fn by_solved_equations(
        &mut self,
        goal: &Prop,
        bindings: &[Binding],
        body: &Prop,
    ) -> Result<Label, Fail> {
        let points = self.solutions_of(bindings, body);
        let is_natural = |name: &str| bindings.iter().any(|b| b.natural && b.names.iter().any(|n| n.0.text == name));
        for point in points {
            let whole = point.iter().map(|(n, value)| {
                let whole = if is_natural(n) { self.whole_by_equations(value) } else { None };
                let value = whole.or_else(|| self.simplified(value))?;
                (!is_natural(n) || self.is_whole(&value)).then(|| (n.clone(), value))
            });
            let Some(point) = whole.collect::<Option<Point>>() else { continue };
            if let Ok(label) = self.attempt(|c| c.by_values(goal, bindings, body, point)) {
                return Ok(label);
            }
        }
        Err(Fail::No("a witness"))
    }

    /// Proves an `exists` of two natural numbers whose equations give their difference: its terms with positive coefficients, and
    /// the others.
    pub(super) fn by_solved_difference(
        &mut self,
        goal: &Prop,
        bindings: &[Binding],
        body: &Prop,
    ) -> Result<Label, Fail> {
        let no = || Fail::No("a difference");
        let names: Vec<&Name> = bindings.iter().filter(|b| b.natural).flat_map(|b| &b.names).map(|n| &n.0).collect();
        let [up, down] = names.as_slice() else { return Err(no()) };
        let mut map = Substitution::default();
        map.replace(&down.text, &numeral(0));
        let alone = map.prop(body).map_err(Fail::from)?;
        let points = self.solutions_of(&[Binding::of((*up).clone(), true, Vec::new())], &alone);
        let values = points.into_iter().flatten().map(|(_, value)| value);
        for value in values.collect::<Vec<_>>() {
            let Some(whole) = self.whole_by_equations(&value) else { continue };
            let Some(whole) = self.letters.polynomial(&self.in_naturals(&whole)) else { continue };
            let part = |sign: i32| {
                let terms = whole.terms().filter(|t| (*t.1 > 0) == (sign > 0));
                Polynomial::from_terms(terms.map(|(m, c)| (m.clone(), c * Rational::from(sign))))
            };
            let point = [(up, part(1)), (down, part(-1))].map(|(n, p)| (n.text.clone(), self.letters.written(&p)));
            if let Ok(label) = self.attempt(|c| c.by_values(goal, bindings, body, point.to_vec())) {
                return Ok(label);
            }
        }
        Err(no())
    }

    /// Points at which the equations of a conjunction may hold.
    fn solutions_of(&mut self, bindings: &[Binding], body: &Prop) -> Vec<Point> {
        let mut points = Vec::new();
        // The equations have values in the domain of the variables, so they are read in a block.
        let every = prop(PropKind::ForAll(bindings.to_vec(), Box::new(body.clone())));
        let _ = self.attempt(|c| {
            c.block(&every, |c, _| {
                points = c.roots_of(bindings, body);
                Err::<Label, Fail>(Fail::No("the values are all that was asked"))
            })
        });
        points.truncate(MOST_POINTS);
        points
    }

    /// Points at which the equations of a conjunction may hold, in the block of its variables.
    fn roots_of(&mut self, bindings: &[Binding], body: &Prop) -> Vec<Point> {
        let names = bindings.iter().flat_map(|b| &b.names);
        let Some(names) = names.map(|n| n.1.is_none().then(|| n.0.text.clone())).collect::<Option<Vec<_>>>() else {
            return Vec::new();
        };
        let unknown: Vec<u32> = names.iter().map(|n| self.letters.of(&name(n))).collect();
        let mut parts = Vec::new();
        super::solutions::conjuncts(body, &mut parts);
        let (mut polys, mut differences) = (Vec::new(), Vec::new());
        for part in &parts {
            if let Some((a, Relation::Equal, b)) = part.single() {
                let difference = minus(a, b);
                self.define(&difference);
                let Some(reading) = self.read(&difference, false) else { return Vec::new() };
                let above = reading.factors.iter().filter(|f| f.power > 0).map(|f| &f.poly);
                polys.extend(above.cloned().reduce(|a, b| a.try_mul(&b).unwrap_or(a)));
                differences.push(difference);
            }
        }
        let mut out = Vec::new();
        if self.are_polynomials_in(&polys, &unknown) {
            if unknown.len() > polys.len() {
                let slopes = polys.iter().flat_map(|p| unknown.iter().map(|v| p.derivative(*v)));
                polys = slopes.filter(|p| !p.is_zero()).collect();
            }
            self.eliminate_in(&polys, &unknown, &mut Vec::new(), &mut out);
        }
        let named = |values: Vec<(u32, Expr)>| {
            let value = |v| values.iter().find(|x| x.0 == v).map(|x| x.1.clone());
            names.iter().zip(&unknown).map(|(n, v)| Some((n.clone(), value(*v)?))).collect()
        };
        let mut out: Vec<Point> = out.into_iter().filter_map(named).collect();
        // A value with radicals or exponentials that is the greatest or the least: the derivative has none of it.
        if let ([x], [difference]) = (names.as_slice(), differences.as_slice()) {
            out.extend(self.stationary_points(difference, x).into_iter().map(|value| vec![(x.clone(), value)]));
        }
        out
    }

    /// Where an expression is stationary in a variable, as far as the factors of its derivative are polynomials in it.
    pub(super) fn stationary_points(&mut self, e: &Expr, x: &str) -> Vec<Expr> {
        let derivative = expr(ExprKind::Derivative(Box::new(e.clone()), vec![Name::new(x)]));
        self.define(&derivative);
        let Some(reading) = self.read(&derivative, false) else { return Vec::new() };
        let v = self.letters.of(&name(x));
        let mut out = Vec::new();
        for f in reading.factors.iter().filter(|f| f.power > 0) {
            let parts = self.without_logarithms(&f.poly, v).unwrap_or_else(|| factors_with(&f.poly, &[v]));
            for part in parts {
                if self.are_polynomials_in(std::slice::from_ref(&part), &[v]) {
                    let values = self.values_in(&part, v, &[v]).unwrap_or_default();
                    out.extend(values.iter().map(|(a, b)| over(self.letters.written(a), self.letters.written(b))));
                }
            }
        }
        out
    }

    /// Where c·(ln(u) + … − ln(w) − …) + k is 0, so is u·… − exp(−k/c)·w·…: the factors of this that hold a letter.
    fn without_logarithms(&mut self, p: &Polynomial, v: u32) -> Option<Vec<Polynomial>> {
        let mut size: Option<Rational> = None;
        let mut sides = [Vec::new(), Vec::new()];
        for (monomial, c) in p.terms().filter(|t| !t.0.is_one()) {
            let [(letter, 1)] = monomial.powers() else { return None };
            let ExprKind::Apply(f, list) = &self.letters.expr(*letter)?.kind else { return None };
            let positive = if *c < 0 { -c } else { c.clone() };
            if f.text != "ln" || size.get_or_insert_with(|| positive.clone()) != &positive {
                return None;
            }
            sides[usize::from(*c < 0)].extend(list.first().cloned());
        }
        let power = -p.constant_term() / size?;
        let [above, mut below] = sides;
        if power != 0 {
            below.push(apply("exp", literal(&power)));
        }
        let equation = minus(&product(above), &product(below));
        self.define(&equation);
        let reading = self.read(&equation, false)?;
        Some(reading.factors.iter().filter(|f| f.power > 0).flat_map(|f| factors_with(&f.poly, &[v])).collect())
    }

    /// Whether no other letter holds the name of an unknown.
    fn are_polynomials_in(&self, polys: &[Polynomial], unknown: &[u32]) -> bool {
        let is_apart = |e: &Expr| {
            unknown.iter().all(|v| match self.letters.expr(*v).map(|own| &own.kind) {
                Some(ExprKind::Name(own)) => !super::limits::holds(e, own),
                _ => true,
            })
        };
        let others = polys.iter().flat_map(Polynomial::variables).filter(|v| !unknown.contains(v));
        others.filter_map(|v| self.letters.expr(v)).all(is_apart)
    }

    /// Adds the solutions of equations for all the unknown; `found` holds those that are eliminated, in others.
    fn eliminate_in(
        &mut self,
        polys: &[Polynomial],
        unknown: &[u32],
        found: &mut Vec<(u32, Expr)>,
        out: &mut Vec<Vec<(u32, Expr)>>,
    ) {
        if out.len() >= MOST_POINTS {
            return;
        }
        if unknown.is_empty() {
            out.push(self.put_back(found));
            return;
        }
        let lists: Vec<Vec<Polynomial>> = polys.iter().map(|p| factors_with(p, unknown)).collect();
        let Some(place) = (0..lists.len()).filter(|k| !lists[*k].is_empty()).min_by_key(|k| cost(&lists[*k], unknown))
        else {
            return;
        };
        let rest: Vec<&Polynomial> = polys.iter().enumerate().filter(|p| p.0 != place).map(|p| p.1).collect();
        for f in &lists[place] {
            let Some((v, values)) = unknown.iter().find_map(|v| Some((*v, self.values_in(f, *v, unknown)?))) else {
                continue;
            };
            let others: Vec<u32> = unknown.iter().copied().filter(|u| *u != v).collect();
            for (above, below) in values {
                let Some(rest) = rest.iter().map(|p| put_in(p, v, &above, &below)).collect::<Option<Vec<_>>>() else {
                    continue;
                };
                let value = over(self.letters.written(&above), self.letters.written(&below));
                found.push((v, value));
                self.eliminate_in(&rest, &others, found, out);
                found.pop();
            }
        }
    }

    /// The values with those that were found later put in, from the last back.
    fn put_back(&self, found: &[(u32, Expr)]) -> Vec<(u32, Expr)> {
        let mut map = Substitution::default();
        let mut out = Vec::new();
        for (v, value) in found.iter().rev() {
            let value = map.expr(value).unwrap_or_else(|_| value.clone());
            if let Some(Expr { kind: ExprKind::Name(n), .. }) = self.letters.expr(*v) {
                map.replace(n, &value);
            }
            out.push((*v, value));
        }
        out
    }

    /// The roots of a polynomial in one variable, as quotients of polynomials in letters; `None` where it has another form.
    pub(super) fn values_in(
        &mut self,
        f: &Polynomial,
        v: u32,
        unknown: &[u32],
    ) -> Option<Vec<(Polynomial, Polynomial)>> {
        let parts = f.coefficients_in(v);
        if let [constant, slope] = parts.as_slice() {
            return Some(vec![(constant.neg(), slope.clone())]);
        }
        if parts.len() < 3 || unknown.iter().any(|u| *u != v && f.contains(*u)) {
            return None;
        }
        let places: Vec<usize> = (0..parts.len()).filter(|k| !parts[*k].is_zero()).collect();
        match places.as_slice() {
            [0, k] => {
                let k = u32::try_from(*k).ok()?;
                let mut out = Vec::new();
                for sign in [1, -1] {
                    // For an odd k the root of the opposite has the opposite sign.
                    let below =
                        if k % 2 == 1 && sign < 0 { parts[k as usize].clone() } else { parts[k as usize].neg() };
                    let root = self.root_of_quotient(&parts[0], &below, k);
                    out.push((root.scale(&Rational::from(sign)), Polynomial::one()));
                }
                Some(out)
            }
            [0, half, whole] if 2 * half == *whole => {
                let (c, b, a) = (&parts[0], &parts[*half], &parts[*whole]);
                let inside = b.try_mul(b).ok()?.sub(&a.try_mul(c).ok()?.scale(&Rational::from(4)));
                let root = self.root_of_quotient(&inside, &Polynomial::one(), 2);
                let twice = a.scale(&Rational::from(2));
                let mut out = Vec::new();
                for sign in [1, -1] {
                    let above = root.scale(&Rational::from(sign)).sub(b);
                    if *half == 1 {
                        out.push((above, twice.clone()));
                        continue;
                    }
                    let root = self.root_of_quotient(&above, &twice, u32::try_from(*half).ok()?);
                    out.extend([1, -1].map(|sign| (root.scale(&Rational::from(sign)), Polynomial::one())));
                }
                Some(out)
            }
            _ => None,
        }
    }

    /// The k-th root of a quotient: the powers that can leave the root, times a letter for what is left.
    fn root_of_quotient(&mut self, above: &Polynomial, below: &Polynomial, k: u32) -> Polynomial {
        if below.is_one()
            && let Ok(Some(root)) = exact_root(above, k)
        {
            return root;
        }
        let (outside, above) = without_powers(above, k);
        let inside = match (self.letters.written(&above), below.is_one()) {
            (above, true) => above,
            (above, false) => over(above, self.letters.written(below)),
        };
        let inside = self.simplified(&inside).unwrap_or(inside);
        let root = match k {
            1 => inside,
            2 => apply("sqrt", inside),
            3 => apply("cbrt", inside),
            _ => expr(ExprKind::Power(Box::new(inside), Box::new(literal(&Rational::from_unsigneds(1, k))))),
        };
        outside.mul(&Polynomial::variable(self.letters.of(&root)))
    }
}

/// The factors of a polynomial that hold an unknown; a long one is its own factor.
pub(super) fn factors_with(p: &Polynomial, unknown: &[u32]) -> Vec<Polynomial> {
    let all = if p.term_count() > MOST_TERMS { None } else { factor(p).ok() };
    let all = all.map_or_else(|| vec![p.clone()], |f| f.factors.into_iter().map(|f| f.0).collect());
    all.into_iter().filter(|f| unknown.iter().any(|v| f.contains(*v))).collect()
}

/// A polynomial as m^k·p, with m a product of letters.
fn without_powers(p: &Polynomial, k: u32) -> (Polynomial, Polynomial) {
    let (mut outside, mut inside) = (Polynomial::one(), p.clone());
    for v in p.variables() {
        let parts = p.coefficients_in(v);
        let least = parts.iter().position(|c| !c.is_zero()).unwrap_or(0);
        let times = least as u32 / k;
        if times > 0
            && let (Ok(power), Ok(out)) = (Polynomial::variable(v).pow(times * k), Polynomial::variable(v).pow(times))
            && let Some(rest) = inside.exact_divide(&power)
        {
            (outside, inside) = (outside.mul(&out), rest);
        }
    }
    (outside, inside)
}

/// How hard the factors of an equation are to solve: those with one unknown first, then those of degree 1.
fn cost(factors: &[Polynomial], unknown: &[u32]) -> (usize, u32, usize) {
    let names = |f: &Polynomial| unknown.iter().filter(|v| f.contains(**v)).count();
    let degree = |f: &Polynomial| unknown.iter().map(|v| f.degree_in(*v)).filter(|d| *d > 0).min().unwrap_or(0);
    let most = factors.iter().map(names).max().unwrap_or(0);
    let degree = factors.iter().map(degree).max().unwrap_or(0);
    (if degree == 1 { 1 } else { most + 1 }, degree, factors.len())
}

/// A polynomial times a power of `below`, with above/below for a variable.
fn put_in(p: &Polynomial, v: u32, above: &Polynomial, below: &Polynomial) -> Option<Polynomial> {
    let parts = p.coefficients_in(v);
    let degree = u32::try_from(parts.len()).ok()?.saturating_sub(1);
    let mut all = Polynomial::zero();
    for (k, c) in (0..).zip(&parts) {
        let power = above.pow(k).ok()?.try_mul(&below.pow(degree - k).ok()?).ok()?;
        all = all.add(&c.try_mul(&power).ok()?);
    }
    Some(all)
}
