//! Propositions about angles, written out: quantifiers and extrema over angles.

use super::{Writer, conjunction};
use crate::claim::circle::compared;
use crate::claim::matrix::at;
use crate::claim::substitution::Substitution;
use crate::claim::syntax::*;
use crate::claim::walk;

impl Writer<'_> {
    pub(super) fn prop(&mut self, p: &mut Prop) {
        let span = p.span;
        match &mut p.kind {
            PropKind::Compare(sides, _) => sides.iter_mut().for_each(|e| self.expr(e)),
            PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => {
                list.iter_mut().for_each(|p| self.prop(p));
            }
            PropKind::Not(p) => self.prop(p),
            PropKind::Implies(a, b) => {
                self.prop(a);
                self.prop(b);
            }
            PropKind::Exists(bindings, body) => {
                let mut conditions = self.bindings(bindings, false);
                self.prop(body);
                if !conditions.is_empty() {
                    conditions.push((**body).clone());
                    body.kind = PropKind::And(conditions);
                }
            }
            PropKind::ForAll(bindings, body) => {
                let conditions = self.bindings(bindings, false);
                self.prop(body);
                if let Some(conditions) = conjunction(conditions, span) {
                    body.kind = PropKind::Implies(Box::new(conditions), Box::new((**body).clone()));
                }
            }
            PropKind::Extremum(extremum) => {
                let mut names =
                    extremum.over.iter().flat_map(|b| &b.names).map(|n| self.angles.contains_key(&n.0.text));
                if !names.clone().any(|is_angle| is_angle) {
                    extremum.over.iter_mut().for_each(|b| walk::of_binding(b, &mut |e| self.expr(e)));
                    let at = extremum.at.iter_mut().map(|(_, e)| e);
                    [&mut extremum.of, &mut extremum.value].into_iter().chain(at).for_each(|e| self.expr(e));
                } else if names.all(|is_angle| is_angle) {
                    let written = self.extremum((**extremum).clone(), span);
                    p.kind = written;
                } else {
                    self.give_up();
                }
            }
            PropKind::Limit(limit) => {
                self.does_not_move(&limit.variable);
                self.expr(&mut limit.of);
                self.expr(&mut limit.value);
            }
            PropKind::WrittenLimit(limit) => {
                self.does_not_move(&limit.variable);
                limit.parts_mut().for_each(|e| self.expr(e));
            }
        }
    }

    /// No angle is the variable of a limit: its cosine and sine do not tend to anything by themselves.
    fn does_not_move(&mut self, variable: &Name) {
        if self.is_angle(&variable.text) {
            self.give_up();
        }
    }

    /// An extremum over angles, written out: no value is beyond the one at the place. With `only`, no other angles have it.
    fn extremum(&mut self, mut e: Extremum, span: Span) -> PropKind {
        let conditions = self.bindings(&mut e.over, false);
        self.expr(&mut e.of);
        self.expr(&mut e.value);
        // The function is a function of the cosines and sines; at the place these have their values there.
        let (mut same, mut place) = (Vec::new(), Substitution::default());
        for (name, value) in &e.at {
            let bounds = self.bounds.get(&name.text).cloned().unwrap_or_default();
            let Some(angle) = self.angle(value).filter(|a| a.of.is_empty() && bounds.hold(&a.turns)) else {
                self.give_up();
                continue;
            };
            if e.unique && !bounds.are_less_than_a_turn() {
                self.give_up();
            }
            for (name, value) in self.cosine_and_sine(name, &angle, value.span) {
                place.replace(&name.text, &value);
                same.push(compared(at(name.span, ExprKind::Name(name.text)), Relation::Equal, value));
            }
        }
        // A definition without parameters is outside the extremum and does not speak of its variables.
        let of_place = match place.expr(&e.of) {
            Ok(of_place) => of_place,
            Err(_) => {
                self.give_up();
                e.of.clone()
            }
        };
        let relation = if e.maximum { Relation::LessEqual } else { Relation::GreaterEqual };
        // One `for all` holds every part: the place lies within the bounds, so there are such angles.
        let mut said = vec![
            compared(e.of.clone(), relation, e.value.clone()),
            compared(of_place, Relation::Equal, e.value.clone()),
        ];
        if e.unique
            && let Some(only) = conjunction(same, span)
        {
            let there = compared(e.of, Relation::Equal, e.value);
            said.push(Prop { kind: PropKind::Implies(Box::new(there), Box::new(only)), span });
        }
        let mut body = Prop { kind: PropKind::And(said), span };
        if let Some(conditions) = conjunction(conditions, span) {
            body.kind = PropKind::Implies(Box::new(conditions), Box::new(body.clone()));
        }
        PropKind::ForAll(e.over, Box::new(body))
    }
}
