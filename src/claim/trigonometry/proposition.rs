//! Propositions about angles, written out: quantifiers and extrema over angles.

use super::{Writer, conjunction};
use crate::claim::circle::compared;
use crate::claim::matrix::at;
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
                    let help = "write `for all theta real; x > 0: f <= M`, and `f = M` at the place";
                    let message = "an extremum cannot be taken over angles and numbers together".to_string();
                    self.fault(message, help, span);
                }
            }
            PropKind::Limit(limit) => {
                self.expr(&mut limit.of);
                self.expr(&mut limit.value);
            }
        }
    }

    /// An extremum over angles, written out: no value is beyond the one at the place. With `only`, no other angles have it.
    fn extremum(&mut self, mut e: Extremum, span: Span) -> PropKind {
        let mut of_place = e.of.clone();
        walk::substitute(&mut of_place, &e.at.iter().map(|(name, value)| (name.text.as_str(), value)).collect());
        self.expr(&mut of_place);
        let conditions = self.bindings(&mut e.over, false);
        self.expr(&mut e.of);
        self.expr(&mut e.value);
        let mut same = Vec::new();
        for (name, value) in &e.at {
            let bounds = self.bounds.get(&name.text).cloned().unwrap_or_default();
            let Some(angle) = self.angle(value).filter(|a| a.of.is_empty() && bounds.hold(&a.turns)) else {
                let help = "use a multiple of pi within the bounds of the angle";
                self.fault("this cannot be the place of an extremum".to_string(), help, value.span);
                continue;
            };
            if e.unique && !bounds.are_less_than_a_turn() {
                let help = "give the angle bounds at most one turn apart, such as `theta in [0, 2*pi)`";
                self.fault("an extremum over all angles has more than one place".to_string(), help, span);
            }
            for (name, value) in self.cosine_and_sine(name, &angle, value.span) {
                same.push(compared(at(name.span, ExprKind::Name(name.text)), Relation::Equal, value));
            }
        }
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
