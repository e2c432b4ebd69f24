//! Values in doubles at points where the hypotheses hold: what fails there is not tried.
//!
//! Method: the points of a grid of positive numbers, each moved along its ray from 0 to where a hypothesis is an equation.
//!
//! Doubles decide nothing here. A comparison that fails at one of the points is false, so that no proof of it is looked for.

use super::Prover;
use super::letters::{as_power, natural};
use super::products::Kind;
use crate::algebra::Polynomial;
use crate::claim::syntax::*;
use crate::number::double::nearest;
use malachite::Rational;

/// The coordinates of the grid: near 0, near 1 and far.
const GRID: [f64; 6] = [0.001, 0.45, 0.9, 1.0, 1.1, 7.0];

/// What a difference may be off, in proportion.
const ROUNDING: f64 = 1e-9;

/// A ray is searched between these powers of 2, and its zero is halved towards this often.
const FAR: i32 = 24;
const HALVINGS: usize = 60;

/// Points, each with a coordinate for every name.
pub(super) struct TrialPoints {
    names: Vec<String>,
    points: Vec<Vec<f64>>,
}

impl Prover {
    /// Points with positive coordinates at which the hypotheses about these variables hold; `at` is the scale of the grid.
    pub(super) fn trial_points(&mut self, variables: &[u32], at: &Rational) -> TrialPoints {
        let name_of = |v: &u32| match self.letters.expr(*v).map(|e| &e.kind) {
            Some(ExprKind::Name(name)) => Some(name.clone()),
            _ => None,
        };
        let Some(names) = variables.iter().map(name_of).collect::<Option<Vec<_>>>() else {
            return TrialPoints { names: Vec::new(), points: Vec::new() };
        };
        let mut known = self.all_known(&[]);
        known.retain(|k| k.poly.term_count() > 1 && k.poly.variables().iter().all(|v| variables.contains(v)));
        let value = |p: &Polynomial, point: &[f64]| -> (f64, f64) {
            let at = |v: &u32| variables.iter().position(|w| w == v).and_then(|i| point.get(i)).copied().unwrap_or(0.0);
            let power = |(v, k): &(u32, u32)| at(v).powi(i32::try_from(*k).unwrap_or(i32::MAX));
            let terms = p.terms().map(|(m, c)| nearest(c) * m.powers().iter().map(power).product::<f64>());
            terms.fold((0.0, 0.0), |(sum, size), t| (sum + t, size + t.abs()))
        };
        let holds = |point: &Vec<f64>| {
            known.iter().all(|k| {
                let (sum, size) = value(&k.poly, point);
                sum >= -ROUNDING * size && (k.kind != Kind::Zero || sum <= ROUNDING * size)
            })
        };
        let equations = known.iter().any(|k| k.kind == Kind::Zero);
        let mut points = Vec::new();
        for point in grid(names.len(), nearest(at)) {
            let ends = known.iter().filter(|k| !equations || k.kind == Kind::Zero);
            let ends = ends.filter_map(|k| end_of_ray(&point, &|p| value(&k.poly, p).0));
            let moved: Vec<Vec<f64>> = ends.collect();
            points.extend(moved.into_iter().chain((!equations).then_some(point)).filter(holds));
        }
        TrialPoints { names, points }
    }
}

impl TrialPoints {
    /// Whether one expression is less than another at one of the points.
    pub(super) fn deny(&self, greater: &Expr, less: &Expr) -> bool {
        self.points.iter().any(|point| {
            let (Some(x), Some(y)) = (self.value(greater, point), self.value(less, point)) else { return false };
            x - y < -ROUNDING * (x.abs() + y.abs())
        })
    }

    fn value(&self, e: &Expr, point: &[f64]) -> Option<f64> {
        let value = |e: &Expr| self.value(e, point);
        Some(match &e.kind {
            ExprKind::Number(text) => text.parse().ok()?,
            ExprKind::Name(name) => *point.get(self.names.iter().position(|n| n == name)?)?,
            ExprKind::Negate(a) => -value(a)?,
            ExprKind::Sum(list) => list.iter().try_fold(0.0, |sum, (sign, e)| {
                Some(if *sign == Sign::Plus { sum + value(e)? } else { sum - value(e)? })
            })?,
            ExprKind::Product(list) => list.iter().try_fold(1.0, |all, (factor, e)| {
                Some(if *factor == Factor::Times { all * value(e)? } else { all / value(e)? })
            })?,
            _ => {
                let (base, exponent) = as_power(e)?;
                match natural(&exponent) {
                    Some(k) => value(&base)?.powi(i32::try_from(k).ok()?),
                    None => value(&base)?.powf(value(&exponent)?),
                }
            }
        })
    }
}

/// The points of the grid.
fn grid(count: usize, scale: f64) -> Vec<Vec<f64>> {
    let longer = |p: &Vec<f64>| GRID.map(|x| p.iter().copied().chain([x * scale]).collect::<Vec<f64>>());
    (0..count).fold(vec![Vec::new()], |points, _| points.iter().flat_map(longer).collect())
}

/// The point on the ray of another at which a function is 0.
fn end_of_ray(point: &[f64], f: &dyn Fn(&[f64]) -> f64) -> Option<Vec<f64>> {
    let moved = |t: f64| point.iter().map(|x| x * t).collect::<Vec<f64>>();
    let sign = |t: f64| f(&moved(t)) > 0.0;
    let k = (-FAR..FAR).find(|k| sign(2f64.powi(*k)) != sign(2f64.powi(k + 1)))?;
    let (mut low, mut high) = (2f64.powi(k), 2f64.powi(k + 1));
    for _ in 0..HALVINGS {
        let middle = (low + high) / 2.0;
        if sign(middle) == sign(low) { low = middle } else { high = middle }
    }
    Some(moved(low))
}
