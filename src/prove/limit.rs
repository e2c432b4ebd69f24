//! Limits at infinity: rational functions by their degrees, others by series.
//!
//! Contract: the variable grows through all values that its declaration allows; hypotheses about it
//! other than a constant lower bound are refused, so that what is shown holds for all large values.

use super::context::*;
use super::expand::{names_of_binding, names_of_prop};
use super::series::Tends;
use crate::algebra::form::{Atom, Exponent, Form};
use crate::claim::print;
use crate::claim::syntax::*;
use malachite::Rational;
use malachite::base::num::basic::traits::{One, Zero};

type Result<T> = std::result::Result<T, Failure>;

impl Engine {
    /// What the expression of a limit tends to.
    pub fn tends(&mut self, cx: &mut Context, limit: &Limit) -> Result<Option<Tends>> {
        self.unbounded(cx, &limit.variable)?;
        let mut conditions = Vec::new();
        let form = self.scalar(cx, &limit.of, &mut conditions)?;
        self.show_conditions(cx, conditions)?;
        if let Some(value) = self.rational_limit(cx, &form, &limit.variable.text)? {
            return Ok(Some(Tends::To(value)));
        }
        self.limit_by_series(cx, &form, &limit.variable.text)
    }

    /// Refuses hypotheses that keep the variable from growing.
    fn unbounded(&mut self, cx: &Context, variable: &Name) -> Result<()> {
        for fact in &cx.facts {
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
            if sequence.names().contains(&variable.text) {
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
