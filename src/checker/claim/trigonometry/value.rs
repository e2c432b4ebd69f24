//! Values of angles in samples, witnesses and instances, and the arguments that give them.

use super::Writer;
use crate::claim::angle::Angle;
use crate::claim::syntax::*;
use crate::claim::walk;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

impl Writer<'_> {
    /// The value of an angle as the values of its cosine and its sine.
    pub(super) fn cosine_and_sine(&mut self, name: &Name, angle: &Angle, span: Span) -> Vec<(Name, Expr)> {
        // A cited claim names its angles by itself; where it names them otherwise the instance is not accepted.
        let (over, cos, sin) = match self.angles.get(&name.text) {
            Some(variable) => (variable.over, variable.cos.clone(), variable.sin.clone()),
            None => (1, format!("cos_{}", name.text), format!("sin_{}", name.text)),
        };
        let part = BigRational::new(BigInt::one(), over.into());
        let angle = Angle {
            turns: &angle.turns * &part,
            of: angle.of.iter().map(|(name, k)| (name.clone(), k * &part)).collect(),
        };
        let value = |text: String| Name { text, span: name.span };
        let point = self.point(&angle);
        point.map_or(Vec::new(), |p| vec![(value(cos), p.cosine(span)), (value(sin), p.sine(span))])
    }

    /// Writes out values of variables: an angle gets one for its cosine and one for its sine.
    ///
    /// The values for a cited claim (`are_cited`) are for variables of that claim, which are not known here. There a variable is
    /// taken for an angle if its value is one.
    pub(super) fn values(&mut self, values: &mut Vec<(Name, Expr)>, are_cited: bool) {
        for (name, mut value) in std::mem::take(values) {
            let angle = self.angle(&value).filter(|angle| {
                let is_named = self.angles.contains_key(&name.text);
                is_named
                    || are_cited && (!angle.turns.is_zero() || angle.of.keys().any(|of| self.angles.contains_key(of)))
            });
            match angle {
                Some(angle) => values.extend(self.cosine_and_sine(&name, &angle, value.span)),
                None if self.angles.contains_key(&name.text) => self.give_up(),
                None => {
                    self.expr(&mut value);
                    values.push((name, value));
                }
            }
        }
    }

    pub(super) fn proof(&mut self, proof: &mut Proof) {
        for step in &mut proof.steps {
            match step {
                Step::Have { prop, proof, .. } | Step::Case { prop, proof, .. } => {
                    self.prop(prop);
                    self.proof(proof);
                }
                Step::Obtain { binding, prop, witness, .. } => {
                    walk::of_binding(binding, &mut |e| self.expr(e));
                    self.prop(prop);
                    self.expr(witness);
                }
            }
        }
        match &mut proof.close {
            Some(Method::Induction(_, step)) => self.proof(step),
            Some(Method::Instance { with, .. }) => self.values(with, true),
            Some(Method::Witness(with)) => self.values(with, false),
            Some(method) => walk::of_method(method, &mut |e| self.expr(e)),
            None => {}
        }
    }
}
