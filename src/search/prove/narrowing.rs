//! Whole numbers and comparisons that narrow their values: bounds consistency.
//!
//! Method (Apt, "Principles of Constraint Programming", 2003, chapter 6): a box gives each whole number a least and a greatest value.
//! A value beyond which no point of the box satisfies a comparison is a bound. Doubles only suggest it.
//!
//! Limits: [`ROUNDS`] rounds of narrowing, [`FAR`] as the size of a bound.

use super::facts::minus;
use super::letters::{Letters, natural};
use crate::algebra::Polynomial;
use crate::claim::syntax::*;
use crate::number::double::nearest;
use std::collections::{BTreeMap, BTreeSet};

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
struct Row {
    difference: Polynomial,
    relation: Relation,
}

/// What a letter of the rows stands for.
enum Letter {
    /// The whole number with this place.
    Whole(usize),
    /// n!; nothing is known of an n that is no polynomial in whole numbers.
    Factorial(Option<Polynomial>),
    /// A power, of such parts.
    Power(Option<Polynomial>, Option<Polynomial>),
    /// What nothing is known of.
    Open,
}

/// Whole numbers with what is known of them.
pub(super) struct Problem {
    /// Each number's name, and what it is in natural numbers.
    pub(super) wholes: Vec<(String, Expr)>,
    pub(super) facts: Vec<Prop>,
    rows: Vec<Row>,
    letters: Letters,
    meanings: BTreeMap<u32, Letter>,
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
    /// The comparisons among the facts, read once.
    pub(super) fn new(wholes: Vec<(String, Expr)>, facts: Vec<Prop>) -> Problem {
        let (mut letters, mut rows) = (Letters::default(), Vec::new());
        for fact in &facts {
            let PropKind::Compare(sides, relations) = &fact.kind else { continue };
            for (pair, relation) in sides.windows(2).zip(relations) {
                if let Some(difference) = letters.polynomial(&minus(&pair[0], &pair[1])) {
                    rows.push(Row { difference, relation: *relation });
                }
            }
        }
        let used: BTreeSet<u32> = rows.iter().flat_map(|row| row.difference.variables()).collect();
        let meanings = used.into_iter().map(|v| (v, meaning(&wholes, &mut letters, v))).collect();
        Problem { wholes, facts, rows, letters, meanings }
    }

    /// The values of a letter on a box, as far as its form tells.
    fn of_letter(&self, letter: u32, on: &[Values]) -> Values {
        let value = |v: u32| place(&self.wholes, &self.letters, v).map_or(ALL, |place| on[place]);
        let of = |p: &Option<Polynomial>| p.as_ref().map_or(ALL, |p| in_form(p, &value));
        match self.meanings.get(&letter) {
            Some(Letter::Whole(place)) => on[*place],
            Some(Letter::Factorial(n)) => {
                let factorial = |n: f64| (1..=(n.clamp(0.0, 200.0) as u32)).map(f64::from).product::<f64>();
                let (low, high) = of(n);
                (factorial(low), if high > 170.0 { f64::INFINITY } else { factorial(high) })
            }
            Some(Letter::Power(base, exponent)) => {
                let (base, exponent) = (of(base), of(exponent));
                if base.0 >= 1.0 { (base.0.powf(exponent.0.max(0.0)), base.1.powf(exponent.1)) } else { ALL }
            }
            Some(Letter::Open) | None => ALL,
        }
    }

    /// The letters that are no whole numbers, each with its values on a box.
    pub(super) fn others(&self, on: &[Values]) -> Vec<(Expr, Values)> {
        let others = self.meanings.iter().filter(|(_, m)| !matches!(m, Letter::Whole(_)));
        others.filter_map(|(v, _)| Some((self.letters.expr(*v)?.clone(), self.of_letter(*v, on)))).collect()
    }

    /// The values of a polynomial on a box: of its monomials, and by Horner's scheme in each of its letters.
    fn of_difference(&self, p: &Polynomial, on: &[Values]) -> Values {
        let known: Vec<(u32, Values)> = p.variables().into_iter().map(|v| (v, self.of_letter(v, on))).collect();
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

    /// The greatest or the least value that a row leaves to a number, where it lies within what is known.
    fn end(&self, row: &Row, on: &[Values], place: usize, at_most: bool) -> Option<f64> {
        let (low, high) = on[place];
        let ends = (low.max(-FAR), high.min(FAR));
        // The end that may move lies outside.
        let ((mut inside, mut outside), step) = if at_most { (ends, 1.0) } else { ((ends.1, ends.0), -1.0) };
        let is_excluded_from = |x: f64| self.is_excluded(row, on, place, if at_most { (x, high) } else { (low, x) });
        if !is_excluded_from(outside) {
            return None;
        }
        if is_excluded_from(inside) {
            return (step * inside > -FAR).then_some(inside - step);
        }
        while step * (outside - inside) > 1.0 {
            let middle = step * (step * (inside + outside) / 2.0).floor();
            if is_excluded_from(middle) { outside = middle } else { inside = middle }
        }
        Some(outside - step)
    }

    /// Narrows a box; the bounds in the order in which they follow from each other.
    pub(super) fn narrow(&self, on: &mut [Values]) -> Vec<Bound> {
        let mut found: Vec<Bound> = Vec::new();
        for _ in 0..ROUNDS {
            let before = found.len();
            for row in &self.rows {
                for place in 0..on.len() {
                    for at_most in [true, false] {
                        let Some(value) = self.end(row, on, place, at_most) else { continue };
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

/// The place of the whole number that a letter is.
fn place(wholes: &[(String, Expr)], letters: &Letters, letter: u32) -> Option<usize> {
    let ExprKind::Name(n) = &letters.expr(letter)?.kind else { return None };
    wholes.iter().position(|w| w.0 == *n)
}

fn meaning(wholes: &[(String, Expr)], letters: &mut Letters, letter: u32) -> Letter {
    if let Some(place) = place(wholes, letters, letter) {
        return Letter::Whole(place);
    }
    let Some(e) = letters.expr(letter).cloned() else { return Letter::Open };
    let mut read = |e: &Expr| {
        let p = letters.polynomial(e)?;
        p.variables().iter().all(|v| place(wholes, letters, *v).is_some()).then_some(p)
    };
    match (factorial_of(&e), &e.kind) {
        (Some(n), _) => Letter::Factorial(read(n)),
        (None, ExprKind::Power(base, exponent)) => Letter::Power(read(base), read(exponent)),
        _ => Letter::Open,
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
    fn left(fact: &str, mut on: Vec<Values>) -> Vec<Values> {
        let wholes = ["x", "y"].iter().map(|n| ((*n).to_string(), name(n))).collect();
        Problem::new(wholes, vec![crate::claim::parse::parse_prop(fact).unwrap()]).narrow(&mut on);
        on
    }

    #[test]
    fn bounds_hold_every_solution_and_little_else() {
        let naturals = vec![(0.0, f64::INFINITY); 2];
        assert_eq!(left("2^x*3^y = 1296", naturals.clone()), [(0.0, 10.0), (0.0, 6.0)]);
        // y^2 + 3·x^2·y^2 = 30·x^2 + 517 has the solutions x = ±2, y = ±7.
        let on = left("y^2 + 3*x^2*y^2 = 30*x^2 + 517", vec![ALL, (4.0, f64::INFINITY)]);
        assert!(on[1].0 <= 7.0 && (7.0..=40.0).contains(&on[1].1));
        assert!(left("x = y", naturals)[0].1.is_infinite());
    }
}
