//! The weighted mean inequality, tried for the powers in a goal.

use super::{Fail, Prover};
use crate::certificate::{Label, Rule};
use crate::claim::syntax::*;
use crate::kernel::analysis::weighted_mean;
use crate::kernel::statement::{compare, numeral, one_minus};

impl Prover {
    /// Notes a^(1 - p)*b^p <= (1 - p)*a + p*b for powers a^q and b^p in the goal with q = 1 - p, and for a power alone.
    pub fn means(&mut self, goal: &Prop) -> Result<Vec<Label>, Fail> {
        let mut powers = Vec::new();
        let mut sides = Vec::new();
        super::goals::sides_in(goal, &mut sides);
        sides.iter().for_each(|e| powers_in(e, &mut powers));
        let one = numeral(1);
        let mut out = Vec::new();
        for (b, p) in powers.clone() {
            // t^r for r >= 1 lies above its tangent: the mean of t^r and 1 with weight 1/r.
            let inverse = super::limits::over(one.clone(), p.clone());
            let whole = crate::kernel::statement::power(&b, &p);
            let mut tries = vec![(one.clone(), b.clone(), p.clone()), (one.clone(), whole, inverse)];
            for (a, q) in &powers {
                let gap = super::facts::minus(q, &one_minus(&p));
                if self.read(&gap, false).is_some_and(|r| r.number == 0) {
                    tries.push((a.clone(), b.clone(), p.clone()));
                }
            }
            for (a, b, p) in tries {
                out.extend(self.attempt(|c| c.mean(&a, &b, &p)));
            }
        }
        if out.is_empty() { Err(Fail::No("the mean inequality")) } else { Ok(out) }
    }

    fn mean(&mut self, a: &Expr, b: &Expr, p: &Expr) -> Result<Label, Fail> {
        for e in [a, b] {
            self.quietly(&compare(e.clone(), Relation::Greater, numeral(0)))?;
        }
        for e in [p.clone(), one_minus(p)] {
            self.quietly(&compare(e, Relation::GreaterEqual, numeral(0)))?;
        }
        let shown = weighted_mean(a, b, p, Relation::LessEqual);
        if let Some(label) = self.known(&shown) {
            return Ok(label);
        }
        let named = |text: &str, e: &Expr| (Name { text: text.to_string(), span: Span::default() }, e.clone());
        let with = vec![named("a", a), named("b", b), named("p", p)];
        let label = self.emit(Rule::Mean { with }, shown.clone())?;
        self.take_in(&label, &shown)?;
        Ok(label)
    }
}

/// The powers in an expression whose exponents are no whole numerals, with their bases and exponents.
fn powers_in(e: &Expr, out: &mut Vec<(Expr, Expr)>) {
    match &e.kind {
        ExprKind::Power(base, exponent) if super::letters::natural(exponent).is_none() => {
            let power = ((**base).clone(), (**exponent).clone());
            if !out.contains(&power) && out.len() < 4 {
                out.push(power);
            }
        }
        ExprKind::Power(base, _) => powers_in(base, out),
        ExprKind::Negate(a) => powers_in(a, out),
        ExprKind::Sum(list) => list.iter().for_each(|(_, e)| powers_in(e, out)),
        ExprKind::Product(list) => list.iter().for_each(|(_, e)| powers_in(e, out)),
        _ => {}
    }
}
