//! Rule `slope`: the mean value theorem.

use super::known::Known;
use super::names::names_in;
use super::order::Signs;
use super::statement::{compare, domain, sum};
use super::substitution::Substitution;
use super::tree::single;
use super::{Checker, Reason, Refusal, key, rejected};
use crate::claim::syntax::*;
use std::collections::BTreeSet;

/// What an acceptance says where it rests on rule `slope`.
pub(crate) const MEAN_VALUE: &str = "the mean value theorem";

impl Checker {
    /// Rule `slope`: `F(b) relation F(a)` from a fact `for all t …: derivative(F, t) R 0`. The values a and b are given.
    ///
    /// Its domain is an interval I: one real variable, whose bounds are `<`, `<=`, `>`, `>=` and do not mention it. Shown
    /// is that a and b lie in I, and that F and its derivative have a value for every t in I; or the same of I where bounds
    /// from…to have their ends, or where each bound is `<=` or `>=`. The signs of R times those of b − a are among those of
    /// the relation.
    ///
    /// Sound: t is a new name, so nothing else depends on it, and I is convex because its bounds are numbers that do not
    /// move with t. F is made of functions that are differentiable in t wherever the derivative has a value, so F is
    /// continuous from a to b and differentiable between. If a = b the difference is 0, as is b − a. Otherwise
    /// F(b) − F(a) = F′(ξ)·(b − a) with ξ strictly between a and b: there the strict bounds of I hold as well, so that
    /// the fact gives the sign of F′(ξ). Nothing is captured when a and b are put in.
    pub(super) fn slope(
        &mut self,
        goal: &Prop,
        source: &str,
        with: &[(Name, Expr)],
        from: &[String],
        known: &mut Known,
    ) -> Result<(), Refusal> {
        let fact = self.fact(source)?;
        let PropKind::ForAll(bindings, body) = &fact.kind else { return rejected(Reason::NotForAll) };
        let [binding] = bindings.as_slice() else { return rejected(Reason::NotForAll) };
        let [(variable, None)] = binding.names.as_slice() else { return rejected(Reason::NotForAll) };
        let (derivative, slope, zero) = single(body)?;
        let f = match (&derivative.kind, &zero.kind) {
            (ExprKind::Derivative(f, by), ExprKind::Number(number)) if number == "0" => match by.as_slice() {
                [only] if only.text == variable.text => f,
                _ => return rejected(Reason::NotADerivative),
            },
            _ => return rejected(Reason::NotADerivative),
        };
        if binding.natural || !binding.constraints.iter().all(|c| is_bound(c, &variable.text)) {
            return rejected(Reason::NotAnInterval);
        }
        let find = |name: &str| with.iter().find(|w| w.0.text == name).map(|w| &w.1);
        let (Some(a), Some(b), 2) = (find("a"), find("b"), with.len()) else {
            return rejected(Reason::ValueForNoVariable);
        };
        let at = |value: &Expr, e: &Expr| -> Result<Expr, Refusal> {
            let mut map = Substitution::default();
            map.replace(&variable.text, value);
            Ok(map.expr(e)?)
        };
        let (_, relation, _) = single(goal)?;
        let says = compare(at(b, f)?, relation, at(a, f)?);
        if key::prop(goal) != key::prop(&says) {
            return rejected(Reason::ItSays(says));
        }
        self.number_defined(a, known)?;
        self.number_defined(b, known)?;
        self.slope_domain(binding, derivative, [a, b], from, known)?;
        self.prop_defined(goal, known)?;
        let run = sum(vec![(Sign::Plus, b.clone()), (Sign::Minus, a.clone())]);
        let signs = Signs::of(slope).times(self.signs_of_expr(&run, known)?);
        if !signs.within(Signs::of(relation)) {
            return rejected(Reason::Signs);
        }
        self.rests_on.insert(MEAN_VALUE.to_string());
        Ok(())
    }

    /// The domain in which both points lie and the derivative has a value: the binding as it is, else with the ends of its
    /// intervals, else with all its ends.
    pub(super) fn slope_domain(
        &mut self,
        binding: &Binding,
        derivative: &Expr,
        points: [&Expr; 2],
        from: &[String],
        known: &mut Known,
    ) -> Result<Binding, Refusal> {
        for domain in [binding.clone(), with_its_ends(binding, false)] {
            match self.slopes_on(&domain, derivative, points, from, known) {
                Err(Refusal::Rejected(_)) => {}
                other => return other.map(|()| domain),
            }
        }
        let closed = with_its_ends(binding, true);
        self.slopes_on(&closed, derivative, points, from, known)?;
        Ok(closed)
    }

    /// Whether both points lie in the domain of a binding of one variable, and the derivative has a value everywhere in it.
    fn slopes_on(
        &mut self,
        binding: &Binding,
        derivative: &Expr,
        points: [&Expr; 2],
        from: &[String],
        known: &mut Known,
    ) -> Result<(), Refusal> {
        for (variable, _) in &binding.names {
            for point in points {
                let mut map = Substitution::default();
                map.replace(&variable.text, point);
                for needed in domain(binding) {
                    self.holds(&map.prop(&needed)?, from, known)?;
                }
            }
        }
        self.within(std::slice::from_ref(binding), known, |checker, known| checker.number_defined(derivative, known))
    }
}

/// Whether a constraint bounds the variable by a number that does not depend on it.
pub(super) fn is_bound(constraint: &Constraint, variable: &str) -> bool {
    let mut names = BTreeSet::new();
    match constraint {
        Constraint::Relation(Relation::Equal | Relation::NotEqual, _) | Constraint::Range(..) => return false,
        Constraint::Relation(_, bound) => names_in(bound, &mut names),
        Constraint::Interval { from, to, .. } => {
            names_in(from, &mut names);
            names_in(to, &mut names);
        }
    }
    !names.contains(variable)
}

/// The binding with the ends of its intervals, and, if all are meant, with `<=` for each `<` and `>=` for each `>`.
fn with_its_ends(binding: &Binding, all: bool) -> Binding {
    let mut out = binding.clone();
    for constraint in &mut out.constraints {
        match constraint {
            Constraint::Relation(relation @ Relation::Less, _) if all => *relation = Relation::LessEqual,
            Constraint::Relation(relation @ Relation::Greater, _) if all => *relation = Relation::GreaterEqual,
            Constraint::Interval { from_closed, to_closed, .. } => (*from_closed, *to_closed) = (true, true),
            Constraint::Relation(..) | Constraint::Range(..) => {}
        }
    }
    out
}
