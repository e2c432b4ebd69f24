//! Roots of a + b·√c, with numbers a, b and c, as sums of simpler roots.
//!
//! Method: if a² − b²·c = D² then √(a + b·√c) = √((a + D)/2) ± √((a − D)/2), since the square of the right side is
//! a ± √(a² − D²) (Borodin, Fagin, Hopcroft, Tompa, "Decreasing the nesting depth of expressions involving square roots", Journal
//! of Symbolic Computation 1, 1985). A root of degree d in the field itself is p + q·√c: p and q are the half sum and, over √c, the half
//! difference of the real roots of a ± b·√c. They are guessed in floating point, with a denominator up to [`DENOMINATOR`].
//!
//! Certificate: the value is not negative, its power of degree d is a + b·√c, and the rules for powers.

use super::asymptotic_form::total;
use super::letters::{product, whole_power};
use super::radicals::Named;
use super::solutions::times;
use super::{Fail, Prover};
use crate::algebra::Polynomial;
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::kernel::statement::{apply, compare, expr, numeral};
use crate::number::double::nearest;
use crate::refute::literal::literal;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::CheckedSqrt;

/// The largest denominator of what is guessed.
const DENOMINATOR: i32 = 12;

/// a + b·√c.
struct Surd {
    a: Rational,
    b: Rational,
    c: Rational,
}

impl Surd {
    /// Of a polynomial in one letter that is the square root of a number.
    fn of(prover: &mut Prover, p: &Polynomial) -> Option<Surd> {
        let [v] = p.variables().try_into().ok()?;
        let [a, b] = p.coefficients_in(v).try_into().ok()?;
        let root = prover.letters.expr(v).cloned()?;
        let ExprKind::Power(base, _) = &root.kind else { return None };
        let c = prover.read(base, false).filter(|r| r.factors.is_empty() && prover.degree(&root) == Some(2))?.number;
        (c > 0).then_some(Surd { a: a.as_constant()?, b: b.as_constant()?, c })
    }

    /// What its root of this degree may be: a value, and the product of its roots where there are two.
    fn root(&self, d: i64) -> Option<(Expr, Option<Prop>)> {
        self.within(d).map(|value| (value, None)).or_else(|| self.of_two_roots(d))
    }

    /// A root of the form p + q·√c.
    fn within(&self, d: i64) -> Option<Expr> {
        let (a, b, c) = (nearest(&self.a), nearest(&self.b), nearest(&self.c).sqrt());
        let degree = f64::from(i32::try_from(d).ok()?);
        let real = |x: f64| if x < 0.0 && d % 2 == 1 { -(-x).powf(1.0 / degree) } else { x.powf(1.0 / degree) };
        let (first, second) = (real(a + b * c), real(a - b * c));
        let rational = |x: f64| {
            (1..=DENOMINATOR).find_map(|k| {
                let top = (x * f64::from(k)).round();
                let is_near = top.abs() < 1e6 && (x * f64::from(k) - top).abs() < 1e-9 * top.abs().max(1.0);
                #[allow(clippy::cast_possible_truncation)] // its size was looked at
                is_near.then(|| Rational::from_signeds(top as i32, k))
            })
        };
        let signs = if d % 2 == 0 { vec![1.0, -1.0] } else { vec![1.0] };
        signs.into_iter().find_map(|sign| {
            let other = sign * second;
            let (p, q) = (rational((first + other) / 2.0)?, rational((first - other) / (2.0 * c))?);
            // The power, multiplied out over √c.
            let (mut x, mut y) = (Rational::from(1), Rational::from(0));
            for _ in 0..d {
                (x, y) = (&x * &p + &y * &q * &self.c, &x * &q + &y * &p);
            }
            if x != self.a || y != self.b {
                return None;
            }
            Some(total(&[literal(&p), times(q, root_of(&self.c)?)]))
        })
    }

    /// A square root as the sum or the difference of two.
    fn of_two_roots(&self, d: i64) -> Option<(Expr, Option<Prop>)> {
        if d != 2 || self.a <= 0 {
            return None;
        }
        let square = &self.a * &self.a - &self.b * &self.b * &self.c;
        // There is no root of a negative number, and malachite would break off.
        let difference = if square < 0 { None } else { square.checked_sqrt() }?;
        let half = |q: Rational| q / Rational::from(2);
        let [large, small] = [half(&self.a + &difference), half(&self.a - &difference)];
        let sign = Rational::from(if self.b < 0 { -1 } else { 1 });
        if small <= 0 {
            return None;
        }
        // √large·√small = |b|/2·√c.
        let roots = [root_of(&large)?, root_of(&small)?];
        let size = half(&self.b * &sign);
        let both = compare(product(roots.to_vec()), Relation::Equal, times(size, root_of(&self.c)?));
        let [large, small] = roots;
        Some((total(&[large, times(sign, small)]), Some(both)))
    }
}

/// √q, as a number times the root of a whole number.
fn root_of(q: &Rational) -> Option<Expr> {
    let (outside, inside) = root_of_a_whole_number(q)?;
    Some(if inside == 1 { literal(&outside) } else { times(outside, apply("sqrt", literal(&inside))) })
}

/// The square root of a positive number as q·sqrt(d) with a whole number d, from which the squares of small numbers are taken out.
fn root_of_a_whole_number(square: &Rational) -> Option<(Rational, Rational)> {
    let (n, m) = (i64::try_from(square.numerator_ref()).ok()?, i64::try_from(square.denominator_ref()).ok()?);
    let (mut d, mut outside) = (n.checked_mul(m)?, 1i64);
    for k in (2..1000i64).rev() {
        while d % (k * k) == 0 {
            d /= k * k;
            outside *= k;
        }
    }
    Some((Rational::from_signeds(outside, m), Rational::from(d)))
}

impl Prover {
    /// Puts in a sum of simpler roots for a root. What gets a name for that is added to these.
    pub(super) fn denest(&mut self, root: &Expr, named: &mut Vec<Named>) -> Result<(), Fail> {
        let no = || Fail::No("a nested root");
        let d = self.degree(root).ok_or_else(no)?;
        let ExprKind::Power(base, exponent) = &root.kind else { return Err(no()) };
        let poly = self.letters.polynomial(base).ok_or_else(no)?;
        let (value, both) = Surd::of(self, &poly).and_then(|s| s.root(d)).ok_or_else(no)?;
        self.define(&value);
        if let Some(both) = both {
            self.emit(Rule::Power, both)?;
        }
        self.show(&compare(value.clone(), Relation::GreaterEqual, numeral(0)))?;
        let inside = whole_power(value.clone(), d);
        let shown = compare((**base).clone(), Relation::Equal, inside.clone());
        let from = self.combination(shown.clone(), Vec::new()).or_else(|_| self.show(&shown))?;
        let same = expr(ExprKind::Power(Box::new(inside), exponent.clone()));
        let one = self.emit(Rule::Monotone { from }, compare(root.clone(), Relation::Equal, same.clone()))?;
        let term = |label: Label| Term { facts: vec![label], factor: numeral(1) };
        let mut terms = vec![term(one)];
        match self.emit(Rule::Power, compare(same.clone(), Relation::Equal, value.clone())) {
            Ok(two) => terms.push(term(two)),
            // Where the kernel writes the value with a minus sign before it, what is squared gets a name.
            Err(_) => {
                self.split_root(&same, named)?;
                named.iter().for_each(|n| self.put_in(&n.value));
            }
        }
        let label = self.combination(compare(root.clone(), Relation::Equal, value), terms)?;
        self.put_in(&label);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn root(a: i32, b: i32, c: i32, d: i64) -> Option<String> {
        let [a, b, c] = [a, b, c].map(Rational::from);
        Surd { a, b, c }.root(d).map(|e| crate::claim::print::expr(&e.0))
    }

    #[test]
    fn roots_are_found_in_the_field_or_as_two_roots() {
        assert_eq!(root(3, 2, 2, 2).as_deref(), Some("1 + sqrt(2)"));
        assert_eq!(root(2, 1, 5, 3).as_deref(), Some("1/2 + (1/2)*sqrt(5)"));
        assert_eq!(root(17, 12, 2, 4).as_deref(), Some("1 + sqrt(2)"));
        assert_eq!(root(5, -2, 6, 2).as_deref(), Some("sqrt(3) + (-1)*sqrt(2)"));
        assert_eq!(root(1, 1, 2, 2), None);
    }
}
