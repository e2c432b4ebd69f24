//! Limits at infinity: rational functions by their degrees, others by series or between two of those.
//!
//! Contract: the variable grows through all values that its declaration allows; hypotheses about it
//! other than a constant lower bound are refused, so that what is shown holds for all large values.

use super::argument::not_shown;
use super::context::*;
use super::expand::{names_in, names_of_binding, names_of_prop};
use super::method::{compare, sequence_names};
use super::series::Tends;
use crate::algebra::form::{Atom, Exponent, Form};
use crate::claim::print;
use crate::claim::syntax::*;
use malachite::Rational;
use malachite::base::num::basic::traits::{One, Zero};
use std::collections::BTreeSet;

type Result<T> = std::result::Result<T, Failure>;

impl Engine<'_> {
    /// Shows a limit that the degrees or a series give.
    pub fn limit(&mut self, cx: &mut Context, limit: &Limit, goal: &Prop) -> Result<()> {
        let mut conditions = Vec::new();
        let value = self.scalar(cx, &limit.value, &mut conditions)?;
        self.show_conditions(cx, conditions)?;
        if !self.free_of(&value, &limit.variable.text) {
            return Err(super::translate::fault(limit.variable.span, "the limit must not depend on the variable"));
        }
        let Some((Tends::To(found), how)) = self.tends(cx, limit)? else { return Err(not_shown(goal)) };
        if self.ring.sub(&found, &value)?.is_zero() {
            self.line("limit", format!("{}: by {how} {}", print::prop(goal), limit.variable.text));
            return Ok(());
        }
        Err(not_shown(goal))
    }

    /// What the expression of a limit tends to, and by which method.
    pub fn tends(&mut self, cx: &mut Context, limit: &Limit) -> Result<Option<(Tends, &'static str)>> {
        self.unbounded(cx, &limit.variable)?;
        let mut conditions = Vec::new();
        let form = self.scalar(cx, &limit.of, &mut conditions)?;
        self.show_conditions(cx, conditions)?;
        self.nothing_obtained(cx, limit, &form)?;
        if let Some(value) = self.rational_limit(cx, &form, &limit.variable.text)? {
            return Ok(Some((Tends::To(value), "the degrees in")));
        }
        let found = self.limit_by_series(cx, &form, &limit.variable.text)?;
        Ok(found.map(|tends| (tends, "the series in 1 over")))
    }

    /// Refuses a limit of what was obtained: that may depend on the variable.
    fn nothing_obtained(&mut self, cx: &Context, limit: &Limit, form: &Form) -> Result<()> {
        let mut names = BTreeSet::new();
        names_in(&limit.of, &mut names);
        for name in &cx.obtained {
            if *name == limit.variable.text || names.contains(name) || !self.free_of(form, name) {
                return Err(Failure::NotShown(format!("a limit with {name}, which was obtained")));
            }
        }
        Ok(())
    }

    /// Shows a limit between two expressions that have it.
    pub fn squeeze(&mut self, cx: &mut Context, goal: &Prop, lower: &Expr, upper: &Expr) -> Result<()> {
        let PropKind::Limit(limit) = &goal.kind else {
            return Err(super::translate::fault(goal.span, "`squeeze` is for limits"));
        };
        let form = self.valued(cx, &limit.of)?;
        self.nothing_obtained(cx, limit, &form)?;
        for bound in [lower, upper] {
            let inner = Limit { of: bound.clone(), variable: limit.variable.clone(), value: limit.value.clone() };
            let prop = Prop { kind: PropKind::Limit(Box::new(inner.clone())), span: goal.span };
            self.limit(cx, &inner, &prop)?;
        }
        for prop in [
            compare(lower.clone(), Relation::LessEqual, limit.of.clone()),
            compare(limit.of.clone(), Relation::LessEqual, upper.clone()),
        ] {
            self.line("limit", format!("for all {}: {}", limit.variable.text, print::prop(&prop)));
            self.deeper(|engine| engine.show_goal(&mut cx.clone(), &prop))?;
        }
        Ok(())
    }

    /// Refuses hypotheses that keep the variable from growing.
    fn unbounded(&mut self, cx: &Context, variable: &Name) -> Result<()> {
        for fact in cx.facts.iter().chain(&cx.aside).filter(|f| f.origin != Origin::Derived) {
            if !lets_grow(&fact.prop, &variable.text) {
                let text = format!(
                    "{} must be free to grow, but a hypothesis says {}",
                    variable.text,
                    print::prop(&fact.prop)
                );
                return Err(Failure::NotShown(text));
            }
        }
        // Facts about families and the definitions of sequences are not among the facts.
        for family in cx.families.values() {
            if names_of_binding(&family.binding).contains(&variable.text) {
                return Err(Failure::NotShown(format!(
                    "{} must be free to grow: a family depends on it",
                    variable.text
                )));
            }
        }
        for sequence in cx.sequences.values() {
            if sequence_names(sequence).contains(&variable.text) {
                let text = format!("the limit for {}: the sequence {} depends on it", variable.text, sequence.name);
                return Err(Failure::NotShown(text));
            }
        }
        // An equation may have determined it, or another variable by it.
        let atom = self.ring.intern(Atom::Variable(variable.text.clone()));
        let tied = cx.environment.values().any(|(value, _)| self.ring.mentions(value, &|a| a == atom));
        if tied || cx.environment.contains_key(&variable.text) {
            return Err(Failure::NotShown(format!("{} is determined by the hypotheses", variable.text)));
        }
        Ok(())
    }

    /// The limit of c·∏ aᵢ^kᵢ where every aᵢ that depends on the variable is it, or a sum of powers
    /// of it, to a number as exponent: by comparison of degrees. `None` where it is not finite or
    /// not of this kind.
    fn rational_limit(&mut self, cx: &mut Context, form: &Form, name: &str) -> Result<Option<Form>> {
        let variable = self.ring.intern(Atom::Variable(name.to_string()));
        let mut degree = Rational::ZERO;
        let mut value = Form::number(form.coefficient.clone());
        for (atom, exponent) in &form.powers {
            let factor = Form { coefficient: Rational::ONE, powers: vec![(*atom, exponent.clone())] };
            if !self.ring.mentions(&factor, &|a| a == variable) {
                value = self.ring.mul(&value, &factor)?;
                continue;
            }
            let Exponent::Number(e) = exponent else { return Ok(None) };
            if *atom == variable {
                degree += e;
                continue;
            }
            let Some(poly) = self.ring.sum(*atom) else { return Ok(None) };
            let mut top: Option<Rational> = None;
            let mut lead = Vec::new();
            for (monomial, c) in &poly.terms {
                let mut rest = Form { coefficient: c.clone(), powers: monomial.clone() };
                let mut d = Rational::ZERO;
                if let Ok(place) = monomial.binary_search_by_key(&variable, |p| p.0) {
                    let Exponent::Number(k) = &monomial[place].1 else { return Ok(None) };
                    d = k.clone();
                    rest.powers.remove(place);
                }
                if self.ring.mentions(&rest, &|a| a == variable) {
                    return Ok(None);
                }
                match &top {
                    Some(t) if d < *t => {}
                    Some(t) if d == *t => lead.push(rest),
                    _ => {
                        top = Some(d);
                        lead = vec![rest];
                    }
                }
            }
            let lead = self.ring.add(&lead)?;
            if !self.searched_form_signs(cx, &lead)?.within(Signs::NOT_ZERO) {
                return Ok(None);
            }
            degree += e * top.unwrap_or(Rational::ZERO);
            let power = self.raise(cx, &lead, &exponent.form(), "a leading coefficient", &mut Vec::new())?;
            value = self.ring.mul(&value, &power)?;
        }
        Ok(if form.is_zero() || degree < 0 {
            Some(Form::integer(0))
        } else if degree == 0 {
            Some(value)
        } else {
            None
        })
    }
}

/// Whether a hypothesis says nothing of a variable, or only that it is above a number.
pub fn lets_grow(prop: &Prop, variable: &str) -> bool {
    if !names_of_prop(prop).contains(variable) {
        return true;
    }
    let PropKind::Compare(sides, relations) = &prop.kind else { return false };
    sides.len() == 2
        && matches!(relations[0], Relation::Greater | Relation::GreaterEqual)
        && matches!(&sides[0].kind, ExprKind::Name(n) if *n == variable)
        && matches!(&sides[1].kind, ExprKind::Number(_))
}
