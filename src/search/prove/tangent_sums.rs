//! Concave and convex functions by their tangents at the place of an extremum: a·ln(x) + (1 − a)·ln(m − x) is greatest at x = a·m.
//!
//! Method: each logarithm, exponential and power with a variable in it lies on one side of its tangent at the place,
//! ln(u) <= ln(v) + (u − v)/v, exp(u) >= exp(v)·(1 + u − v) and u^q <= v^q + q·v^(q − 1)·(u − v) for 0 <= q <= 1, where v is u at the
//! place. With the coefficients that the functions have in the difference of the sides, all but these lines cancels, and so do the lines
//! where the difference is stationary (S. Boyd, L. Vandenberghe, "Convex Optimization", 2004, 3.1.3).
//!
//! The place is that of the extremum whose bound is shown, or one where the difference is stationary.
//!
//! Certificate: the rules `tangent` and `mean`, and one combination.
//!
//! Limits: [`PLACES`], [`FUNCTIONS_AT_ONCE`].

use super::comparison::single;
use super::facts::{minus, negated, scaled};
use super::letters::{as_power, product};
use super::limits::holds;
use super::slopes::has_function;
use super::{Fail, Prover};
use crate::certificate::{Label, Term};
use crate::claim::syntax::*;
use crate::kernel::statement::{apply, numeral, power};
use crate::kernel::substitution::Substitution;

/// The most places that are tried.
const PLACES: usize = 3;

/// The most functions that are replaced by tangents.
const FUNCTIONS_AT_ONCE: usize = 6;

impl Prover {
    /// Shows an order by the tangents of its functions at a place.
    pub(super) fn by_tangent_sums(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("a place where tangents may touch");
        let (a, _, b) = single(goal)?;
        if !has_function(a) && !has_function(b) {
            return Err(no());
        }
        let difference = minus(a, b);
        let mut places: Vec<Vec<(String, Expr)>> = Vec::new();
        let here = self.extremal_place.clone();
        places.extend((!here.is_empty() && here.iter().any(|(x, _)| holds(&difference, x))).then_some(here));
        if places.is_empty() && self.slopes_open == 0 {
            for x in self.reals_in(&difference) {
                let mut points = Vec::new();
                let _ = self.attempt(|c| {
                    points = c.stationary_points(&difference, &x);
                    Err::<(), _>(Fail::No("points alone"))
                });
                places.extend(points.into_iter().map(|p| vec![(x.clone(), p)]));
            }
        }
        let mut last = Err(no());
        for place in places.into_iter().take(PLACES) {
            last = self.attempt(|c| c.by_tangents_at(goal, &place));
            if last.is_ok() {
                break;
            }
        }
        last
    }

    fn by_tangents_at(&mut self, goal: &Prop, place: &[(String, Expr)]) -> Result<Label, Fail> {
        let mut at = Substitution::default();
        place.iter().for_each(|(x, value)| at.replace(x, value));
        let open = self.open_factors(goal, 0)?;
        let moves = |e: &Expr| place.iter().any(|(x, _)| holds(e, x));
        let mut functions = Vec::new();
        for v in open.poly.variables() {
            let Some(e) = self.letters.expr(v).cloned() else { continue };
            if moves(&e) && has_function(&e) {
                let [_, slope] =
                    open.poly.coefficients_in(v).try_into().map_err(|_| Fail::No("a function by itself"))?;
                functions.push((e, self.letters.written(&slope)));
            }
        }
        if functions.is_empty() || functions.len() > FUNCTIONS_AT_ONCE {
            return Err(Fail::No("functions that move"));
        }
        let mut terms: Vec<Term> = Vec::new();
        for (e, coefficient) in functions {
            let coefficient = product([coefficient].into_iter().chain(open.rest.iter().cloned()).collect());
            let (label, factor) = self.tangent_of(&e, &at)?;
            terms.push(scaled(&label, product(vec![coefficient, factor])));
        }
        if let Ok(label) = self.attempt(|c| c.combination(goal.clone(), terms.clone())) {
            return Ok(label);
        }
        // ln(a·m) is ln(a) + ln(m).
        self.split_logarithms(goal);
        self.combination(goal.clone(), terms)
    }

    /// The tangent of a function at a place as a fact; the function is the left side of it, times what is returned with it.
    fn tangent_of(&mut self, e: &Expr, at: &Substitution) -> Result<(Label, Expr), Fail> {
        let there = |e: &Expr| at.expr(e).map_err(Fail::from);
        if let Some((base, exponent)) = as_power(e) {
            let v = there(&base)?;
            let (label, _) = self.this_mean(&v, &base, &exponent)?;
            return Ok((label, power(&v, &minus(&exponent, &numeral(1)))));
        }
        match &e.kind {
            ExprKind::Apply(f, list) => match (f.text.as_str(), list.as_slice()) {
                ("ln", [u]) => {
                    let v = there(u)?;
                    Ok((self.tangent_fact(&minus(e, &apply("ln", v)))?, numeral(1)))
                }
                ("exp", [u]) => {
                    let v = there(u)?;
                    let label = self.tangent_fact(&minus(u, &v))?;
                    Ok((label, negated(apply("exp", v))))
                }
                _ => Err(Fail::No("a function with a tangent")),
            },
            _ => Err(Fail::No("a function with a tangent")),
        }
    }
}
