//! Rule `intermediate`: the intermediate value theorem.

use super::known::Known;
use super::slope::{Ends, on_an_interval, two_points, with_ends};
use super::statement::{compare, expr, sum};
use super::substitution::Substitution;
use super::tree::single;
use super::{Checker, Reason, Refusal, key, rejected};
use crate::claim::syntax::*;

/// What an acceptance says where it rests on rule `intermediate`.
const INTERMEDIATE_VALUE: &str = "the intermediate value theorem";

impl Checker {
    /// Rule `intermediate`: `exists x …: F = G`, where the values a and b are given and the first two facts are `F(a) R G(a)` with
    /// `<`, `<=` or `=`, and `F(b) S G(b)` with `>`, `>=` or `=`.
    ///
    /// The domain of x is an interval I: one real variable, whose bounds are `<`, `<=`, `>`, `>=` and do not mention it. Let D be I,
    /// or I where intervals have their ends, or I where each bound is `<=` or `>=`. Shown is that a and b lie in D, that F and G
    /// have values for every x in D, and the derivative of F − G for every x that satisfies the bounds of I made strict. If D is not I,
    /// the two facts are strict.
    ///
    /// Sound: D is convex, because its bounds are numbers that do not move with x. F − G has a derivative inside, so it is made
    /// of functions that are continuous where they have values; so it is continuous on D, and vanishes at some c from a to b.
    /// If D is I, that is the x. Otherwise F − G does not vanish at a and b, so c lies strictly between them, and satisfies
    /// strict bounds, too.
    pub(super) fn intermediate(
        &mut self,
        goal: &Prop,
        with: &[(Name, Expr)],
        from: &[String],
        known: &mut Known,
    ) -> Result<(), Refusal> {
        let PropKind::Exists(bindings, body) = &goal.kind else { return rejected(Reason::NotExists) };
        let [binding] = bindings.as_slice() else { return rejected(Reason::NotAnInterval) };
        let [(variable, None)] = binding.names.as_slice() else { return rejected(Reason::NotAnInterval) };
        on_an_interval(binding, variable)?;
        let (left, relation, right) = single(body)?;
        if relation != Relation::Equal {
            return rejected(Reason::NotAnEquation);
        }
        let [a, b] = two_points(with)?;
        let [below, above, from @ ..] = from else { return rejected(Reason::SignsAtEnds) };
        let below = self.at_the_end(below, body, (variable, a), Relation::Less)?;
        let above = self.at_the_end(above, body, (variable, b), Relation::Greater)?;
        self.number_defined(a, known)?;
        self.number_defined(b, known)?;
        let difference = sum(vec![(Sign::Plus, left.clone()), (Sign::Minus, right.clone())]);
        let ends = self.slope_domain(binding, &difference, [a, b], from, known)?;
        if ends != Ends::Own && !(below && above) {
            return rejected(Reason::SignsAtEnds);
        }
        let derivative = expr(ExprKind::Derivative(Box::new(difference), vec![variable.clone()]));
        let inside = with_ends(binding, Ends::None);
        self.within(&[inside], known, |checker, known| checker.number_defined(&derivative, known))?;
        self.prop_defined(goal, known)?;
        self.rests_on.insert(INTERMEDIATE_VALUE.to_string());
        Ok(())
    }

    /// Whether a fact says strictly on which side an equation fails at a value of its variable.
    ///
    /// # Errors
    /// The fact is not the equation there with the strict relation, the loose one or `=`.
    fn at_the_end(
        &self,
        fact: &str,
        equation: &Prop,
        (variable, value): (&Name, &Expr),
        strict: Relation,
    ) -> Result<bool, Refusal> {
        let fact = key::prop(&*self.fact(fact)?);
        let mut map = Substitution::default();
        map.replace(&variable.text, value);
        let at_value = map.prop(equation)?;
        let (left, _, right) = single(&at_value)?;
        let says = |relation| key::prop(&compare(left.clone(), relation, right.clone())) == fact;
        match says(strict) {
            true => Ok(true),
            false if says(strict.loose()) || says(Relation::Equal) => Ok(false),
            false => rejected(Reason::SignsAtEnds),
        }
    }
}
