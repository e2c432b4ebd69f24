//! Definite integrals.
//!
//! An integrand has a value for every number between the ends ([`Checker::between`]). It is made of functions that are continuous
//! wherever they have values, since what jumps, the index of a member or of a sum, is whole by its form and so free of the variable.
//! So it is continuous on a closed interval, and the integral exists. Of another integral in it whose ends a(x) and b(x) depend
//! on the variable the same holds: it is that of g(x, a + t·(b − a))·(b − a) for t from 0 to 1, which is continuous in x and t.

use super::fraction::Fraction;
use super::known::Known;
use super::order::Signs;
use super::term::Atom;
use super::{Checker, Reason, Refusal, rejected};
use crate::claim::syntax::*;

/// A definite integral over `Real(own)`.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Integral {
    /// The number of its variable.
    pub(super) own: usize,
    /// Where it begins.
    pub(super) from: Fraction,
    /// Where it ends.
    pub(super) to: Fraction,
    /// What is integrated.
    pub(super) body: Fraction,
}

impl Checker {
    /// An integral as an atom.
    pub(super) fn integral(&mut self, variable: &Index, body: &Expr, depth: usize) -> Result<Fraction, Refusal> {
        let (from, to) = (self.scalar_in(&variable.from, depth)?, self.scalar_in(&variable.to, depth)?);
        self.opened(|checker, own| {
            let read = |checker: &mut Checker| checker.scalar_in(body, depth);
            let body = checker.under(&variable.name.text, Atom::Real(own), read)?;
            checker.integral_of(own, from, to, &body)
        })
    }

    /// The integral over an open place ([`super::binder`]).
    pub(super) fn integral_of(
        &mut self,
        own: usize,
        from: Fraction,
        to: Fraction,
        body: &Fraction,
    ) -> Result<Fraction, Refusal> {
        let (own, body) = self.closed(own, body, Atom::Real)?;
        Ok(self.atom_fraction(Atom::Integral(Integral { own, from, to, body })))
    }

    /// Runs something where the variable of an integral lies between the ends. Where the facts do not tell which end is less, it
    /// may be any number that has a sign which both ends have.
    pub(super) fn between(
        &mut self,
        variable: &Index,
        known: &mut Known,
        run: impl FnOnce(&mut Checker, &mut Known) -> Result<(), Refusal>,
    ) -> Result<(), Refusal> {
        let interval = |from: &Expr, to: &Expr| {
            vec![Constraint::Interval { from: from.clone(), from_closed: true, to: to.clone(), to_closed: true }]
        };
        let run_length = self.fraction(&variable.to)?.minus(&self.fraction(&variable.from)?, &self.work)?;
        let signs = self.signs_of(&run_length, known)?;
        let mut bounds = match (signs.within(Signs::NOT_NEGATIVE), signs.within(Signs::of(Relation::LessEqual))) {
            (true, _) => interval(&variable.from, &variable.to),
            (_, true) => interval(&variable.to, &variable.from),
            _ => Vec::new(),
        };
        // A number between two has a sign that both have: the kernel adds no bounds up, so it is said of the variable as well.
        let ends = self.signs_of_expr(&variable.from, known)?.or(self.signs_of_expr(&variable.to, known)?);
        let sides = [Relation::Greater, Relation::GreaterEqual, Relation::Less, Relation::LessEqual];
        if let Some(side) = sides.into_iter().find(|side| ends.within(Signs::of(*side))) {
            bounds.push(Constraint::Relation(side, super::statement::numeral(0)));
        }
        self.within(&[Binding::of(variable.name.clone(), false, bounds)], known, run)
    }

    /// Whether an integral can be differentiated by a variable that the integrand is free of: its ends can, and the integrand has a
    /// value and is continuous also near the closed interval, since it can be differentiated everywhere in it.
    pub(super) fn smooth_integral(
        &mut self,
        variable: &Index,
        body: &Expr,
        by: &str,
        known: &mut Known,
    ) -> Result<(), Refusal> {
        let mut names = std::collections::BTreeSet::new();
        super::names::names_in(body, &mut names);
        if names.contains(by) {
            return rejected(Reason::DerivativeOfMember);
        }
        self.smooth(&variable.from, by, known)?;
        self.smooth(&variable.to, by, known)?;
        self.between(variable, known, |checker, known| checker.smooth(body, &variable.name.text, known))
    }

    /// The derivative of an integral whose integrand f is free of the variable: f(b)·b′ − f(a)·a′.
    pub(super) fn integral_derivative(
        &mut self,
        integral: &Integral,
        variable: &Atom,
        by: &str,
        depth: usize,
    ) -> Result<Fraction, Refusal> {
        let Integral { own, from, to, body } = integral;
        if !self.is_free_of(body, variable)? {
            return rejected(Reason::DerivativeOfMember);
        }
        let moved = self.intern(Atom::Real(*own));
        let mut terms = Vec::new();
        for (end, sign) in [(to, 1), (from, -1)] {
            let slope = self.derivative(end, by, depth)?;
            if !slope.is_zero() {
                let there = self.replaced(body, moved, end)?;
                terms.push(there.times(&slope, &self.work)?.times(&Fraction::integer(sign), &self.work)?);
            }
        }
        Fraction::sum(&terms, &self.work)
    }
}
