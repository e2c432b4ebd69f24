//! Limits of powers whose base tends to 1, such as (1 + a/n)^n, between two exponentials.

use super::facts::minus;
use super::letters::{as_power, product};
use super::limits::{natural_binding, over};
use super::{Fail, Prover};
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::kernel::statement::{apply, compare, name, numeral, power, prop, sum};
use crate::kernel::substitution::Substitution;

/// A power base^exponent whose limit is exp(a).
struct Compound {
    base: Expr,
    exponent: Expr,
    a: Expr,
}

impl Compound {
    /// exponent·(1 − 1/base), which tends to a from below.
    fn below(&self) -> Expr {
        product(vec![self.exponent.clone(), minus(&numeral(1), &over(numeral(1), self.base.clone()))])
    }

    /// The lower bound exp(a)·(1 + below − a).
    fn lower(&self) -> Expr {
        let line = sum(vec![(Sign::Plus, numeral(1)), (Sign::Plus, minus(&self.below(), &self.a))]);
        product(vec![apply("exp", self.a.clone()), line])
    }

    fn at(&self, old: &str, new: &Expr) -> Result<Compound, Fail> {
        let mut map = Substitution::default();
        map.replace(old, new);
        let at = |e: &Expr| map.expr(e).map_err(Fail::from);
        Ok(Compound { base: at(&self.base)?, exponent: at(&self.exponent)?, a: self.a.clone() })
    }
}

impl Prover {
    /// Shows a limit base^n → exp(a) where n·(base − 1) = a.
    ///
    /// With u = base − 1: base <= exp(u), so base^n <= exp(n·u) = exp(a). With v = 1/base − 1: 1/base <= exp(v), so
    /// base^n >= exp(−n·v) = exp(a)·exp(−n·v − a) >= exp(a)·(1 − n·v − a), which is rational in n.
    pub(crate) fn by_compound(&mut self, goal: &Prop, l: &Limit) -> Result<Label, Fail> {
        let no = || Fail::No("a power with a base that tends to 1");
        let (base, exponent) = as_power(&l.of).ok_or_else(no)?;
        let a = match &l.value.kind {
            ExprKind::Apply(f, list) if f.text == "exp" => list.first().cloned().ok_or_else(no)?,
            _ => return Err(no()),
        };
        let compound = Compound { base, exponent, a };
        let k = self.fresh("k");
        let here = compound.at(&l.variable.text, &name(&k))?;
        let binding = self.growing_from(1, l, &k);
        let every = |p: Prop| prop(PropKind::ForAll(vec![binding.clone()], Box::new(p)));
        let whole = power(&here.base, &here.exponent);
        let above = compare(whole.clone(), Relation::LessEqual, l.value.clone());
        let below = compare(here.lower(), Relation::LessEqual, whole);
        let upper = self.block(&every(above.clone()), |c, _| c.below_exponential(&here, &above))?;
        let lower = self.block(&every(below.clone()), |c, _| c.above_exponential(&here, &below))?;
        self.between(goal, l, (&compound.lower(), &l.value), &[upper, lower], 1)
    }

    fn below_exponential(&mut self, p: &Compound, goal: &Prop) -> Result<Label, Fail> {
        let u = minus(&p.base, &numeral(1));
        let tangent = self.tangent_at(&u)?;
        let bound = apply("exp", u);
        let order = compare(p.base.clone(), Relation::LessEqual, bound.clone());
        let from = self.combination(order, vec![Term { facts: vec![tangent], factor: numeral(1) }])?;
        let raised = power(&bound, &p.exponent);
        let powers = compare(power(&p.base, &p.exponent), Relation::LessEqual, raised.clone());
        let powers = self.emit(Rule::Monotone { from }, powers)?;
        let same = self.emit(Rule::Power, compare(raised, Relation::Equal, apply("exp", p.a.clone())))?;
        let terms = [powers, same].map(|fact| Term { facts: vec![fact], factor: numeral(1) });
        self.combination(goal.clone(), terms.to_vec())
    }

    fn above_exponential(&mut self, p: &Compound, goal: &Prop) -> Result<Label, Fail> {
        let v = minus(&over(numeral(1), p.base.clone()), &numeral(1));
        let tangent = self.tangent_at(&v)?;
        let bound = apply("exp", Expr { kind: ExprKind::Negate(Box::new(v)), span: Span::default() });
        // base − exp(−v) = base·exp(−v)·(exp(v) − 1/base).
        let factor = product(vec![p.base.clone(), bound.clone()]);
        let order = compare(bound.clone(), Relation::LessEqual, p.base.clone());
        let from = self.combination(order, vec![Term { facts: vec![tangent], factor }])?;
        let raised = power(&bound, &p.exponent);
        let powers = compare(raised.clone(), Relation::LessEqual, power(&p.base, &p.exponent));
        let powers = self.emit(Rule::Monotone { from }, powers)?;
        let gap = minus(&p.below(), &p.a);
        let limit = apply("exp", p.a.clone());
        let whole = apply("exp", sum(vec![(Sign::Plus, p.a.clone()), (Sign::Plus, gap.clone())]));
        let same = self.emit(Rule::Power, compare(raised, Relation::Equal, whole))?;
        let split = self.exponential_of_a_sum(&p.a, &gap)?;
        let line = self.tangent_at(&gap)?;
        let minus_one = || Expr { kind: ExprKind::Negate(Box::new(numeral(1))), span: Span::default() };
        let terms = [(powers, numeral(1)), (same, minus_one()), (split, minus_one()), (line, limit)];
        self.combination(goal.clone(), terms.map(|(fact, factor)| Term { facts: vec![fact], factor }).to_vec())
    }

    /// exp(a + b) = exp(a)·exp(b), from that for all b: as a fraction the sum a + b is not seen to be one.
    fn exponential_of_a_sum(&mut self, a: &Expr, b: &Expr) -> Result<Label, Fail> {
        let y = self.fresh("y");
        let exp = |e: Expr| apply("exp", e);
        let both = exp(sum(vec![(Sign::Plus, a.clone()), (Sign::Plus, name(&y))]));
        let apart = product(vec![exp(a.clone()), exp(name(&y))]);
        let body = compare(both, Relation::Equal, apart);
        let binding = Binding { natural: false, ..natural_binding(&y) };
        let every = prop(PropKind::ForAll(vec![binding], Box::new(body.clone())));
        let all = self.block(&every, |c, _| c.emit(Rule::Power, body.clone()))?;
        self.instance(&all, b)
    }
}
