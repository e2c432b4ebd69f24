//! Sums and products over an index.

use super::fraction::{Fraction, Poly};
use super::term::{Atom, Over};
use super::{Checker, Refusal};
use crate::claim::syntax::*;
use num_traits::{One, Signed};

impl Checker {
    /// A sum or product over an index. Finite sums are linear, finite products of factors are products: both are
    /// taken apart, and what does not hold the index is taken out.
    ///
    /// An empty sum is 0 and an empty product 1, also where what is taken out has no value: 0·c = 0 and c^0 = 1 have to
    /// hold. With a divisor in c they may not: `sum(i = 1..n, 1/n)` is not n·(1/n) for n = 0, nor
    /// `product(i = 1..n, x^(1/n))` = x^(n/n). So divisors are taken out only where the range is not empty by its form.
    pub(super) fn over(&mut self, sum: bool, index: &Index, body: &Expr, depth: usize) -> Result<Fraction, Refusal> {
        let (low, high) = (self.scalar_in(&index.from, depth)?, self.scalar_in(&index.to, depth)?);
        let (from, to) = (self.whole(&low)?, self.whole(&high)?);
        self.opened(|checker, own| {
            let read = |checker: &mut Checker| checker.scalar_in(body, depth);
            let body = checker.under(&index.name.text, Atom::Bound(own), read)?;
            checker.over_of(&Over { sum, own, from, to, body })
        })
    }

    /// The sum or product over an open index ([`super::binder`]).
    pub(super) fn over_of(&mut self, over: &Over) -> Result<Fraction, Refusal> {
        let (low, high) = (Fraction::of(&over.from), Fraction::of(&over.to));
        let room = Fraction::sum(&[high, Fraction::integer(1), low.negated()], &self.work)?;
        if over.sum { self.sum_over(over, &room) } else { self.product_over(over, &room) }
    }

    /// The sum or product of another body, as an atom.
    fn atom_over(&mut self, over: &Over, body: Fraction) -> Result<Fraction, Refusal> {
        let (own, body) = self.closed(over.own, &body, Atom::Bound)?;
        Ok(self.atom_fraction(Atom::Over(Over { own, body, ..over.clone() })))
    }

    fn sum_over(&mut self, over: &Over, room: &Fraction) -> Result<Fraction, Refusal> {
        let Over { own: bound, body, .. } = over;
        let bound = *bound;
        let filled = self.is_not_empty(room)?;
        let (outside, inside) = self.taken_out(body, bound, filled)?;
        if body.is_zero() {
            return Ok(Fraction::integer(0));
        }
        let held = |(_, k): &(&Poly, &i64)| **k < 0;
        let mut terms = Vec::new();
        // What stays inside only since it is a divisor stays with every term.
        let (mut divisors, mut top) = (Fraction::integer(1), inside.clone());
        for (poly, k) in inside.factors.iter().filter(held) {
            if self.is_free_of(&Fraction::of(poly), &Atom::Bound(bound))? {
                top.factors.remove(poly);
                divisors.factors.insert(poly.clone(), *k);
            }
        }
        match self.polynomial(&top)? {
            Some(poly) => {
                for (monomial, c) in poly.terms() {
                    let term = self.monomial(monomial)?.times(&Fraction::number(c.clone()), &self.work)?;
                    let (free, rest) = self.taken_out(&term, bound, filled)?;
                    let rest = rest.times(&divisors, &self.work)?;
                    let one = rest.as_integer() == Some(1);
                    let sum = if one { room.clone() } else { self.atom_over(over, rest)? };
                    terms.push(free.times(&sum, &self.work)?);
                }
            }
            None => terms.push(self.atom_over(over, inside)?),
        }
        Fraction::sum(&terms, &self.work)?.times(&outside, &self.work)
    }

    fn product_over(&mut self, over: &Over, room: &Fraction) -> Result<Fraction, Refusal> {
        let Over { own: bound, body, .. } = over;
        if body.is_zero() {
            return self.atom_over(over, body.clone());
        }
        // The number of members is natural; by its form only if no coefficient is negative.
        let counted = self.polynomial(room)?.is_some_and(|p| p.terms().all(|t| !t.1.is_negative()));
        let mut out = Fraction::integer(1);
        if !body.coefficient.is_one() {
            let constant = Fraction::number(body.coefficient.clone());
            let factor = if counted { self.power(&constant, room)? } else { self.atom_over(over, constant)? };
            out.multiply(&factor, &self.work)?;
        }
        for (poly, k) in &body.factors {
            let factor = Fraction::of(poly);
            let mut free = self.is_free_of(&factor, &Atom::Bound(*bound))?;
            if free && self.has_divided_exponents(poly) {
                free = self.is_not_empty(room)?;
            }
            let value = if free && counted { self.power(&factor, room)? } else { self.atom_over(over, factor)? };
            out.multiply(&value.power(*k)?, &self.work)?;
        }
        Ok(out)
    }

    /// Whether a range of so many members has one, by the form of their number: it is 1 and a sum of natural numbers.
    fn is_not_empty(&self, room: &Fraction) -> Result<bool, Refusal> {
        let rest = room.minus(&Fraction::integer(1), &self.work)?;
        Ok(self.is_whole(&rest)? && rest.expanded(&self.work)?.terms().all(|t| t.1.is_positive()))
    }

    /// Whether a power or exponential with a divisor in its exponent occurs in a factor.
    fn has_divided_exponents(&self, poly: &Poly) -> bool {
        poly.atoms().any(|place| match self.atoms.get(place) {
            Some(Atom::Power(_, exponent) | Atom::Exponential(exponent)) => exponent.factors.values().any(|k| *k < 0),
            _ => false,
        })
    }

    /// The factors that do not hold a bound index, and the others. What needs a divisor to have a value is among the
    /// others, unless the range is filled.
    fn taken_out(&mut self, f: &Fraction, bound: usize, filled: bool) -> Result<(Fraction, Fraction), Refusal> {
        let (mut outside, mut inside) = (Fraction::number(f.coefficient.clone()), Fraction::integer(1));
        for (poly, k) in &f.factors {
            let free = self.is_free_of(&Fraction::of(poly), &Atom::Bound(bound))?
                && (filled || (*k > 0 && !self.has_divided_exponents(poly)));
            let side = if free { &mut outside } else { &mut inside };
            side.factors.insert(poly.clone(), *k);
        }
        Ok((outside, inside))
    }

    /// Runs something where a name stands for a bound index or the variable of an integral.
    pub(super) fn under<T>(
        &mut self,
        name: &str,
        bound: Atom,
        run: impl FnOnce(&mut Checker) -> Result<T, Refusal>,
    ) -> Result<T, Refusal> {
        self.declare(name, matches!(bound, Atom::Bound(_)), bound)?;
        let result = run(self);
        self.scope.pop();
        result
    }
}
