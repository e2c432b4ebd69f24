//! The angles of a claim: which variables they are, their bounds, and the equations between them.

use super::{Variable, Writer, part_of};
use crate::claim::angle::{Angle, Linear, linear};
use crate::claim::circle::MULTIPLE_LIMIT;
use crate::claim::matrix::apply;
use crate::claim::syntax::*;
use crate::claim::walk;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};
use std::collections::BTreeMap;

impl Writer<'_> {
    /// Notes which variables are angles, which definitions are linear in angles, and the bounds and equations in the hypotheses.
    pub(super) fn find_angles(&mut self, claim: &mut Claim) {
        for item in &claim.items {
            if let Item::Let { name, parameters, value } = item
                && parameters.is_empty()
                && let Some(value) = linear(value, &self.definitions, self.is_pi)
            {
                self.definitions.insert(name.text.clone(), value);
            }
        }
        walk::expressions(claim, &mut |e| self.find(e));
        self.find_by_bounds(&claim.items);
        // An equation makes its variables angles, and so may make another hypothesis one about angles. The bounds are read when all
        // angles are known, wherever they stand.
        let mut known = None;
        while known.replace(self.angles.len()) != Some(self.angles.len()) {
            self.hypotheses(claim, &mut |writer, a, relation, b| {
                if relation == Relation::Equal
                    && let Some(difference) = writer.difference(a, b)
                {
                    writer.note(&difference, a.span);
                }
            });
        }
        self.hypotheses(claim, &mut |writer, a, relation, b| writer.bound(a, relation, b));
    }

    /// Calls `visit` with the two sides of every comparison in the hypotheses about angles.
    fn hypotheses(&mut self, claim: &Claim, visit: &mut dyn FnMut(&mut Self, &Expr, Relation, &Expr)) {
        for item in &claim.items {
            if let Item::Assume { prop, .. } = item
                && let PropKind::Compare(sides, relations) = &prop.kind
                && self.is_about_angles(sides)
            {
                for (pair, relation) in sides.windows(2).zip(relations) {
                    visit(self, &pair[0], *relation, &pair[1]);
                }
            }
        }
    }

    /// Notes the angles inside sin, cos and tan.
    fn find(&mut self, e: &Expr) {
        let Some((_, argument)) = self.function(e) else {
            return walk::parts(e, &mut |part| self.find(part));
        };
        let Some(angle) = self.angle(argument) else {
            return self.give_up();
        };
        self.note(&angle, argument.span);
    }

    /// Notes the variables of an angle, with the denominators of their coefficients.
    fn note(&mut self, angle: &Angle, span: Span) {
        for (name, k) in &angle.of {
            let known = self.angles.get(name).map_or(1, |v| v.over);
            let Some(over) = common_multiple(known, k.denom()) else {
                return self.give_up();
            };
            let new = Variable { over, span, is_declared: false, cos: String::new(), sin: String::new() };
            self.angles.entry(name.clone()).or_insert(new).over = over;
        }
    }

    /// Notes the variables that are declared with bounds in π.
    fn find_by_bounds(&mut self, items: &[Item]) {
        let speaks_of_pi = |e: &Expr| self.angle(e).is_some_and(|a| !a.turns.is_zero());
        let is_angle = |binding: &&Binding| {
            binding.constraints.iter().any(|c| match c {
                Constraint::Relation(_, e) => speaks_of_pi(e),
                Constraint::Interval { from, to, .. } | Constraint::Range(from, to) => {
                    speaks_of_pi(from) || speaks_of_pi(to)
                }
            })
        };
        let bindings = items.iter().filter_map(|item| if let Item::Given(list) = item { Some(list) } else { None });
        let names: Vec<Name> =
            bindings.flatten().filter(is_angle).flat_map(|b| b.names.iter().map(|n| n.0.clone())).collect();
        for name in names {
            let of = BTreeMap::from([(name.text.clone(), BigRational::one())]);
            self.note(&Angle { turns: BigRational::zero(), of }, name.span);
        }
    }

    /// The angle that an expression is, if it is one.
    pub(super) fn angle(&self, e: &Expr) -> Option<Angle> {
        linear(e, &self.definitions, self.is_pi)?.as_angle().cloned()
    }

    /// Whether an angle occurs in these expressions outside sin, cos and tan.
    pub(super) fn is_about_angles(&self, sides: &[Expr]) -> bool {
        sides.iter().any(|e| self.shows_an_angle(e))
    }

    fn shows_an_angle(&self, e: &Expr) -> bool {
        if self.function(e).is_some() {
            return false;
        }
        let mut found = matches!(&e.kind, ExprKind::Name(name) if self.is_angle(name));
        walk::parts(e, &mut |part| found = found || self.shows_an_angle(part));
        found
    }

    /// Whether a name is an angle: a variable of [`Writer::angles`], or a definition in terms of such or of π.
    pub(super) fn is_angle(&self, name: &str) -> bool {
        self.angles.contains_key(name)
            || self
                .definitions
                .get(name)
                .and_then(Linear::as_angle)
                .is_some_and(|angle| !angle.turns.is_zero() || angle.of.keys().any(|of| self.angles.contains_key(of)))
    }

    /// Notes a comparison in a hypothesis: an equation between angles, or a bound of one angle.
    fn bound(&mut self, a: &Expr, relation: Relation, b: &Expr) {
        let span = Span { start: a.span.start, end: b.span.end };
        let Some(difference) = self.difference(a, b) else { return self.give_up() };
        let mut left = difference.of.iter();
        match (relation, left.next(), left.next()) {
            (Relation::Equal, ..) => {
                self.note(&difference, span);
                self.equations.push(difference);
            }
            (_, Some((name, k)), None) => {
                let turns = -&difference.turns / k;
                let relation = if k.is_negative() { relation.turned() } else { relation };
                if !self.bounds.entry(name.clone()).or_default().narrow(relation, turns) {
                    self.give_up();
                }
            }
            _ => self.give_up(),
        }
    }

    /// A derivative by an angle is that of a function.
    pub(super) fn find_derivatives(&mut self, claim: &mut Claim) {
        walk::expressions(claim, &mut |e| self.find_derivatives_in(e));
    }

    fn find_derivatives_in(&mut self, e: &Expr) {
        let is_used = match &e.kind {
            ExprKind::Derivative(_, by) => by.iter().any(|n| self.angles.contains_key(&n.text)),
            ExprKind::IntegralOver(x, _) => self.angles.contains_key(&x.name.text),
            _ => false,
        };
        if is_used {
            self.give_up();
        }
        walk::parts(e, &mut |part| self.find_derivatives_in(part));
    }

    /// The difference of two angles.
    pub(super) fn difference(&self, a: &Expr, b: &Expr) -> Option<Angle> {
        let (mut out, b) = (self.angle(a)?, self.angle(b)?);
        out.turns -= &b.turns;
        for (name, k) in &b.of {
            *out.of.entry(name.clone()).or_insert_with(BigRational::zero) -= k;
        }
        out.of.retain(|_, k| !k.is_zero());
        Some(out)
    }

    /// Names the cosine and the sine of every angle. All parts of the angles are known.
    pub(super) fn name_cosines_and_sines(&mut self) {
        for (angle, variable) in &mut self.angles {
            let part = part_of(angle, variable.over);
            let mut name = |function: &str| {
                let name = self.fresh.name(&format!("{function}_{}", part.0));
                self.fresh.means(&name, apply(variable.span, function, part.1.clone()));
                name
            };
            (variable.cos, variable.sin) = (name("cos"), name("sin"));
        }
    }
}

/// The least common multiple of two denominators, if it is at most [`MULTIPLE_LIMIT`].
fn common_multiple(a: u32, b: &BigInt) -> Option<u32> {
    let b = b.to_u32().filter(|b| i64::from(*b) <= MULTIPLE_LIMIT)?;
    (1..=MULTIPLE_LIMIT as u32).find(|k| k % a == 0 && k % b == 0)
}
