//! Rule `slope`: the mean value theorem, also for an integral.

use super::known::Known;
use super::names::names_in;
use super::order::Signs;
use super::statement::{compare, domain, expr, sum};
use super::substitution::Substitution;
use super::tree::single;
use super::{Checker, Reason, Refusal, key, rejected};
use crate::claim::syntax::*;
use std::collections::BTreeSet;

/// What an acceptance says where it rests on rule `slope`.
pub(crate) const MEAN_VALUE: &str = "the mean value theorem";

/// Which ends a domain has that is an interval.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Ends {
    /// Those that its author gave it.
    Own,
    /// Both where it is written as an interval.
    OfIntervals,
    /// All: `<=` for each `<`, `>=` for each `>`.
    All,
    /// None: `<` for each `<=`, `>` for each `>=`.
    None,
}

impl Checker {
    /// Rule `slope`: from a fact `for all x …: derivative(F, x) R f`, where the values a and b are given,
    /// - `F(b) relation F(a)` if f is the numeral 0;
    /// - `F(b) - F(a) relation integral(x = a..b, f)`.
    ///
    /// The domain of the fact is an interval I: one real variable, whose bounds are `<`, `<=`, `>`, `>=` and do not mention it. Let D
    /// be I, or I where bounds from…to have their ends, or I where each bound is `<=` or `>=`. Shown is that a and b lie in D, that F
    /// and the integrand f have values for every x in D, and the derivative for every x in I. The signs of R times those of b − a
    /// are among those of the relation.
    ///
    /// Sound: x is a new name, so nothing else depends on it, and D is convex because its bounds are numbers that do not
    /// move with x. F is made of functions that are continuous where they have values, so it is continuous from a to b; it is
    /// differentiable between, since there the strict bounds of I hold as well. G(x) = F(x), or F(x) less the integral of f from a to
    /// x, has the derivative F′(x) or F′(x) − f(x), whose sign the fact gives. If a = b the difference is 0, as is b − a. Otherwise
    /// G(b) − G(a) = G′(ξ)·(b − a) with ξ strictly between a and b. Nothing is captured when a and b are put in.
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
        let (derivative, slope, integrand) = single(body)?;
        let f = match &derivative.kind {
            ExprKind::Derivative(f, by) if by.len() == 1 && by.iter().all(|n| n.text == variable.text) => f,
            _ => return rejected(Reason::NotADerivative),
        };
        on_an_interval(binding, variable)?;
        let [a, b] = two_points(with)?;
        let at = |value: &Expr| -> Result<Expr, Refusal> {
            let mut map = Substitution::default();
            map.replace(&variable.text, value);
            Ok(map.expr(f)?)
        };
        let (_, relation, right) = single(goal)?;
        let (at_a, at_b) = (at(a)?, at(b)?);
        let values = compare(at_b.clone(), relation, at_a.clone());
        let has_values = integrand.kind == ExprKind::Number("0".to_string());
        if !has_values || key::prop(goal) != key::prop(&values) {
            if !matches!(right.kind, ExprKind::IntegralOver(..)) {
                return rejected(if has_values { Reason::ItSays(values) } else { Reason::NotADerivative });
            }
            let range = Index { name: variable.clone(), from: Box::new(a.clone()), to: Box::new(b.clone()) };
            let integral = expr(ExprKind::IntegralOver(range, Box::new(integrand.clone())));
            let says = compare(sum(vec![(Sign::Plus, at_b), (Sign::Minus, at_a)]), relation, integral);
            if key::prop(goal) != key::prop(&says) {
                return rejected(Reason::ItSays(says));
            }
        }
        self.number_defined(a, known)?;
        self.number_defined(b, known)?;
        let domain = with_ends(binding, self.slope_domain(binding, f, [a, b], from, known)?);
        self.within(std::slice::from_ref(binding), known, |checker, known| checker.number_defined(derivative, known))?;
        self.within(&[domain], known, |checker, known| checker.number_defined(integrand, known))?;
        self.prop_defined(goal, known)?;
        let run = sum(vec![(Sign::Plus, b.clone()), (Sign::Minus, a.clone())]);
        let signs = Signs::of(slope).times(self.signs_of_expr(&run, known)?);
        if !signs.within(Signs::of(relation)) {
            return rejected(Reason::Signs);
        }
        self.rests_on.insert(MEAN_VALUE.to_string());
        Ok(())
    }

    /// The ends with which both points lie in the domain and F has a value there: its own, else those of its intervals,
    /// else all.
    pub(super) fn slope_domain(
        &mut self,
        binding: &Binding,
        f: &Expr,
        points: [&Expr; 2],
        from: &[String],
        known: &mut Known,
    ) -> Result<Ends, Refusal> {
        for ends in [Ends::Own, Ends::OfIntervals] {
            match self.slopes_on(&with_ends(binding, ends), f, points, from, known) {
                Err(Refusal::Rejected(_)) => {}
                other => return other.map(|()| ends),
            }
        }
        self.slopes_on(&with_ends(binding, Ends::All), f, points, from, known)?;
        Ok(Ends::All)
    }

    /// Whether both points lie in the domain of a binding of one variable, and F has a value everywhere in it.
    fn slopes_on(
        &mut self,
        binding: &Binding,
        f: &Expr,
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
        self.within(std::slice::from_ref(binding), known, |checker, known| checker.number_defined(f, known))
    }
}

/// Whether the domain of a variable is an interval of real numbers, whose bounds do not move with it.
///
/// # Errors
/// It is not.
pub(super) fn on_an_interval(binding: &Binding, variable: &Name) -> Result<(), Refusal> {
    match !binding.natural && binding.constraints.iter().all(|c| is_bound(c, &variable.text)) {
        true => Ok(()),
        false => rejected(Reason::NotAnInterval),
    }
}

/// The values of a and b, the only ones that are given.
///
/// # Errors
/// Others are given.
pub(super) fn two_points(with: &[(Name, Expr)]) -> Result<[&Expr; 2], Refusal> {
    let find = |name: &str| with.iter().find(|w| w.0.text == name).map(|w| &w.1);
    match (find("a"), find("b"), with.len()) {
        (Some(a), Some(b), 2) => Ok([a, b]),
        _ => rejected(Reason::ValueForNoVariable),
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

/// The binding with these ends of its domain.
pub(super) fn with_ends(binding: &Binding, ends: Ends) -> Binding {
    let mut out = binding.clone();
    for constraint in &mut out.constraints {
        match (ends, constraint) {
            (Ends::All, Constraint::Relation(relation, _)) => *relation = relation.loose(),
            (Ends::None, Constraint::Relation(relation, _)) => *relation = relation.strict(),
            (Ends::All | Ends::OfIntervals, Constraint::Interval { from_closed, to_closed, .. }) => {
                (*from_closed, *to_closed) = (true, true);
            }
            (Ends::None, Constraint::Interval { from_closed, to_closed, .. }) => {
                (*from_closed, *to_closed) = (false, false);
            }
            (Ends::Own, _) | (Ends::OfIntervals, Constraint::Relation(..)) | (_, Constraint::Range(..)) => {}
        }
    }
    out
}
