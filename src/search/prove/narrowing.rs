//! Whole numbers and comparisons that narrow their values: bounds consistency.
//!
//! Method (Apt, "Principles of Constraint Programming", 2003, chapter 6): a box gives each whole number a least and a greatest value.
//! A value beyond which no point of the box satisfies a comparison is a bound. Doubles only suggest it.
//!
//! Limits: [`ROUNDS`] rounds of narrowing, [`FAR`] as the size of a bound.

use super::letters::{Letters, natural};
use crate::algebra::Polynomial;
use crate::claim::syntax::*;
use crate::number::double::nearest;

/// The most rounds of narrowing for one box.
const ROUNDS: usize = 8;

/// A bound that leaves more than this part of a number's values is not taken.
const LITTLE: f64 = 0.7;

/// Where a bound is sought: up to this size.
pub(super) const FAR: f64 = (1_u64 << 40) as f64;

/// Values from the first to the second; an end may be infinite.
pub(super) type Values = (f64, f64);

pub(super) const ALL: Values = (f64::NEG_INFINITY, f64::INFINITY);

/// A bound: at most, or at least, so much of the number with this place.
#[derive(Clone, Copy)]
pub(super) struct Bound {
    pub(super) place: usize,
    pub(super) at_most: bool,
    pub(super) value: f64,
}

/// A comparison of a difference with 0.
pub(super) struct Row {
    pub(super) difference: Polynomial,
    pub(super) relation: Relation,
}

/// Whole numbers with what is known of them.
pub(super) struct Problem {
    /// Each number's name, and what it is in natural numbers.
    pub(super) wholes: Vec<(String, Expr)>,
    pub(super) facts: Vec<Prop>,
    pub(super) rows: Vec<Row>,
    pub(super) letters: Letters,
}

fn times(a: Values, b: Values) -> Values {
    // 0·∞ is the value of no point: it is 0 at the end that is 0.
    let product = |x: f64, y: f64| if x == 0.0 || y == 0.0 { 0.0 } else { x * y };
    let ends = [product(a.0, b.0), product(a.0, b.1), product(a.1, b.0), product(a.1, b.1)];
    (ends.iter().copied().fold(f64::INFINITY, f64::min), ends.iter().copied().fold(f64::NEG_INFINITY, f64::max))
}

fn plus(a: Values, b: Values) -> Values {
    (a.0 + b.0, a.1 + b.1)
}

fn power(a: Values, k: u32) -> Values {
    let k = i32::try_from(k).unwrap_or(i32::MAX);
    let (low, high) = (a.0.powi(k), a.1.powi(k));
    match (k % 2 == 0, a.0 < 0.0, a.1 > 0.0) {
        (true, true, true) => (0.0, low.max(high)),
        (true, true, false) => (high, low),
        _ => (low, high),
    }
}

fn common(a: Values, b: Values) -> Values {
    (a.0.max(b.0), a.1.min(b.1))
}

/// Whether no value of a difference satisfies a comparison with 0.
fn excludes(relation: Relation, (low, high): Values) -> bool {
    match relation {
        Relation::Equal => low > 0.0 || high < 0.0,
        Relation::NotEqual => low == 0.0 && high == 0.0,
        Relation::Greater => high <= 0.0,
        Relation::GreaterEqual => high < 0.0,
        Relation::Less => low >= 0.0,
        Relation::LessEqual => low > 0.0,
    }
}

/// The number of points, 0 where there is none.
pub(super) fn points(of: &[Values]) -> f64 {
    of.iter().map(|(low, high)| (high - low + 1.0).max(0.0)).product()
}

/// The end of n! = product(i = 1..n, i).
fn factorial_of(e: &Expr) -> Option<&Expr> {
    let ExprKind::ProductOver(index, body) = &e.kind else { return None };
    let is_index = matches!(&body.kind, ExprKind::Name(n) if *n == index.name.text);
    (is_index && natural(&index.from) == Some(1)).then_some(&*index.to)
}

impl Problem {
    pub(super) fn place(&self, e: &Expr) -> Option<usize> {
        let ExprKind::Name(n) = &e.kind else { return None };
        self.wholes.iter().position(|w| w.0 == *n)
    }

    /// The values of an expression on a box, as far as its form tells.
    pub(super) fn of_letter(&self, e: &Expr, on: &[Values]) -> Values {
        if let Some(place) = self.place(e) {
            return on[place];
        }
        if let Some(to) = factorial_of(e) {
            let factorial = |n: f64| (1..=(n.clamp(0.0, 200.0) as u32)).map(f64::from).product::<f64>();
            let (low, high) = self.of_expr(to, on);
            return (factorial(low), if high > 170.0 { f64::INFINITY } else { factorial(high) });
        }
        match &e.kind {
            ExprKind::Power(base, exponent) => {
                let (base, exponent) = (self.of_expr(base, on), self.of_expr(exponent, on));
                if base.0 >= 1.0 { (base.0.powf(exponent.0.max(0.0)), base.1.powf(exponent.1)) } else { ALL }
            }
            _ => ALL,
        }
    }

    fn of_expr(&self, e: &Expr, on: &[Values]) -> Values {
        let mut letters = self.letters.clone();
        match letters.polynomial(e) {
            Some(p) if p.as_constant().is_some() => p.as_constant().map_or(ALL, |c| (nearest(&c), nearest(&c))),
            Some(p) if p.variables().iter().all(|v| letters.expr(*v).is_some_and(|l| self.place(l).is_some())) => {
                let value = |v: u32| letters.expr(v).and_then(|l| self.place(l)).map_or(ALL, |place| on[place]);
                in_form(&p, &value)
            }
            _ => ALL,
        }
    }

    /// The values of a polynomial on a box: of its monomials, and by Horner's scheme in each of its letters.
    fn of_difference(&self, p: &Polynomial, on: &[Values]) -> Values {
        let known: Vec<(u32, Values)> = p
            .variables()
            .into_iter()
            .map(|v| (v, self.letters.expr(v).map_or(ALL, |e| self.of_letter(e, on))))
            .collect();
        let value = |v: u32| known.iter().find(|k| k.0 == v).map_or(ALL, |k| k.1);
        let by_horner = |(v, x): &(u32, Values)| {
            let coefficients = p.coefficients_in(*v);
            coefficients.iter().rev().fold((0.0, 0.0), |sum, c| plus(times(sum, *x), in_form(c, &value)))
        };
        let forms = known.iter().map(by_horner).chain([in_form(p, &value)]);
        // An end that is no number is no bound.
        let read = |(a, b): Values| (if a.is_nan() { ALL.0 } else { a }, if b.is_nan() { ALL.1 } else { b });
        forms.map(read).fold(ALL, common)
    }

    fn is_excluded(&self, row: &Row, on: &[Values], place: usize, values: Values) -> bool {
        let mut part = on.to_vec();
        part[place] = values;
        excludes(row.relation, self.of_difference(&row.difference, &part))
    }

    /// The greatest value that a row leaves to a number, where it is less than the one that is known.
    fn greatest(&self, row: &Row, on: &[Values], place: usize) -> Option<f64> {
        let (low, high) = on[place];
        let (mut inside, mut outside) = (low.max(-FAR), high.min(FAR));
        if !self.is_excluded(row, on, place, (outside, high)) {
            return None;
        }
        if self.is_excluded(row, on, place, (inside, high)) {
            return (low > -FAR).then_some(inside - 1.0);
        }
        while outside - inside > 1.0 {
            let middle = ((inside + outside) / 2.0).floor();
            if self.is_excluded(row, on, place, (middle, high)) { outside = middle } else { inside = middle }
        }
        Some(outside - 1.0)
    }

    /// The same for the least value.
    fn least(&self, row: &Row, on: &[Values], place: usize) -> Option<f64> {
        let (low, high) = on[place];
        let (mut outside, mut inside) = (low.max(-FAR), high.min(FAR));
        if !self.is_excluded(row, on, place, (low, outside)) {
            return None;
        }
        if self.is_excluded(row, on, place, (low, inside)) {
            return (high < FAR).then_some(inside + 1.0);
        }
        while inside - outside > 1.0 {
            let middle = ((inside + outside) / 2.0).ceil();
            if self.is_excluded(row, on, place, (low, middle)) { outside = middle } else { inside = middle }
        }
        Some(outside + 1.0)
    }

    /// Narrows a box; the bounds in the order in which they follow from each other.
    pub(super) fn narrow(&self, on: &mut [Values]) -> Vec<Bound> {
        let mut found: Vec<Bound> = Vec::new();
        for _ in 0..ROUNDS {
            let before = found.len();
            for row in &self.rows {
                for place in 0..on.len() {
                    for at_most in [true, false] {
                        let new = if at_most { self.greatest(row, on, place) } else { self.least(row, on, place) };
                        let Some(value) = new else { continue };
                        let old = on[place];
                        let new = if at_most { (old.0, value) } else { (value, old.1) };
                        // What narrows little is not worth a proof.
                        if (new.1 - new.0) + 1.0 > LITTLE * (old.1 - old.0 + 1.0) {
                            continue;
                        }
                        on[place] = new;
                        found.push(Bound { place, at_most, value });
                        if on[place].0 > on[place].1 {
                            return found;
                        }
                    }
                }
            }
            if found.len() == before {
                break;
            }
        }
        found
    }
}

/// The values of a sum of monomials.
fn in_form(p: &Polynomial, value: &dyn Fn(u32) -> Values) -> Values {
    p.terms().fold((0.0, 0.0), |sum, (monomial, c)| {
        let c = nearest(c);
        let powers = monomial.powers().iter().map(|(v, k)| power(value(*v), *k));
        plus(sum, powers.fold((c, c), times))
    })
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // a test stops where it fails
mod tests {
    use super::*;
    use crate::kernel::statement::name;

    /// The box that is left of these values of x and y.
    fn left(rows: &[(&str, Relation)], mut on: Vec<Values>) -> Vec<Values> {
        let mut letters = Letters::default();
        let wholes: Vec<_> = ["x", "y"].iter().map(|n| ((*n).to_string(), name(n))).collect();
        let rows = rows.iter().map(|(text, relation)| {
            let difference = letters.polynomial(&crate::claim::parse::parse_expr(text).unwrap()).unwrap();
            Row { difference, relation: *relation }
        });
        let rows = rows.collect();
        Problem { wholes, facts: Vec::new(), rows, letters }.narrow(&mut on);
        on
    }

    #[test]
    fn bounds_hold_every_solution_and_little_else() {
        let naturals = vec![(0.0, f64::INFINITY); 2];
        assert_eq!(left(&[("2^x*3^y - 1296", Relation::Equal)], naturals.clone()), [(0.0, 10.0), (0.0, 6.0)]);
        // y^2 + 3·x^2·y^2 = 30·x^2 + 517 has the solutions x = ±2, y = ±7.
        let on = left(&[("y^2 + 3*x^2*y^2 - 30*x^2 - 517", Relation::Equal)], vec![ALL, (4.0, f64::INFINITY)]);
        assert!(on[1].0 <= 7.0 && (7.0..=40.0).contains(&on[1].1));
        assert!(left(&[("x - y", Relation::Equal)], naturals)[0].1.is_infinite());
    }
}
