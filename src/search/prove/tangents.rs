//! The inequality 1 + x <= exp(x), tried for the exponentials and logarithms in a goal.

use super::letters::product;
use super::{Fail, Prover};
use crate::certificate::{Label, Rule};
use crate::claim::syntax::*;
use crate::kernel::analysis::tangent;
use crate::kernel::order::Signs;
use crate::kernel::statement::{apply, compare, expr, name, numeral, prop, sum};
use crate::refute::literal::literal;
use malachite::Rational;
use std::rc::Rc;

/// Largest number of exponents at which the tangent is taken for one goal.
const TANGENTS: usize = 16;

impl Prover {
    /// Proves a comparison by tangents, and an equation by contradiction: its sides would differ.
    pub(crate) fn by_tangents(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let exponents = self.exponents(goal);
        if exponents.is_empty() {
            return Err(Fail::No("an exponential or a logarithm"));
        }
        let PropKind::Compare(_, relations) = &goal.kind else { return Err(Fail::No("a comparison is needed")) };
        if relations != &[Relation::Equal] {
            self.tangents(&exponents)?;
            return self.quietly(goal);
        }
        self.against_opposite(goal, |c, _| {
            c.tangents(&exponents)?;
            c.attempt(|c| c.absurd(0, goal, Some(goal))).or_else(|_| c.absurd(1, goal, Some(goal)))
        })
    }

    /// Adds the fact 1 + x <= exp(x) for each of these exponents x.
    fn tangents(&mut self, exponents: &[Expr]) -> Result<(), Fail> {
        let mut any = false;
        for x in exponents {
            any |= self.attempt(|c| c.tangent_at(x)).is_ok();
        }
        if any { Ok(()) } else { Err(Fail::No("a tangent")) }
    }

    /// The exponents at which the tangent may help: the exponents in the goal and the logarithms there, for an equation
    /// those in facts as well, their opposites, and sums of two of these.
    fn exponents(&mut self, goal: &Prop) -> Vec<Expr> {
        let mut sides = Vec::new();
        super::goals::sides_in(goal, &mut sides);
        if matches!(&goal.kind, PropKind::Compare(_, relations) if *relations == [Relation::Equal]) {
            let facts: Vec<Rc<Prop>> = self.checker.facts().map(|f| f.1.clone()).collect();
            facts.iter().for_each(|p| super::goals::sides_in(p, &mut sides));
        }
        let mut single: Vec<Expr> = Vec::new();
        for e in &sides {
            let Some(reading) = self.read(e, false) else { continue };
            for v in reading.factors.iter().flat_map(|f| f.poly.variables()) {
                let exponent = match self.letters.expr(v) {
                    Some(e @ Expr { kind: ExprKind::Apply(f, at), .. }) if at.len() == 1 => match f.text.as_str() {
                        "exp" => at[0].clone(),
                        "ln" => e.clone(),
                        _ => continue,
                    },
                    _ => continue,
                };
                if !single.contains(&exponent) {
                    single.push(exponent);
                }
            }
        }
        let times = |k: i64, e: &Expr| product(vec![literal(&Rational::from(k)), e.clone()]);
        let signed = |k: i64, e: &Expr| if k == 1 { e.clone() } else { times(k, e) };
        let mut out: Vec<Expr> = single.iter().flat_map(|e| [signed(1, e), signed(-1, e)]).collect();
        for (i, a) in single.iter().enumerate() {
            for b in &single[i + 1..] {
                for (j, k) in [(1, -1), (-1, 1), (1, 1), (-1, -1)] {
                    let terms = [signed(j, a), signed(k, b)].map(|e| (Sign::Plus, e));
                    out.push(expr(ExprKind::Sum(terms.to_vec())));
                }
            }
        }
        out.truncate(TANGENTS);
        out
    }

    /// x != 0 for a sum of logarithms, with little effort.
    fn differs_by_logarithms(&mut self, other: &Prop, x: &Expr) -> Result<(), Fail> {
        let splits = std::mem::replace(&mut self.splits, 9);
        let shown = self.of_logarithms(other, x, Relation::NotEqual, &numeral(0));
        self.splits = splits;
        shown.map(|_| ())
    }

    /// `1 + x <= exp(x)`, strict where x is seen to be other than 0.
    pub(crate) fn tangent_at(&mut self, x: &Expr) -> Result<Label, Fail> {
        self.define(x);
        let other = compare(x.clone(), Relation::NotEqual, numeral(0));
        let strict =
            self.signs_of(x).within(Signs::NOT_ZERO) || self.attempt(|c| c.differs_by_logarithms(&other, x)).is_ok();
        let shown = tangent(x, if strict { Relation::Less } else { Relation::LessEqual });
        if self.known(&shown).is_some() {
            return Err(Fail::No("a new tangent"));
        }
        let with = vec![(Name::new("x"), x.clone())];
        let label = self.emit(Rule::Tangent { with }, shown.clone())?;
        self.take_in(&label, &shown)?;
        Ok(label)
    }

    /// exp(a + b) = exp(a)·exp(b), from that for all b: as a fraction the sum a + b is not seen to be one.
    pub(super) fn exponential_of_a_sum(&mut self, a: &Expr, b: &Expr) -> Result<Label, Fail> {
        let y = self.fresh("y");
        let exp = |e: Expr| apply("exp", e);
        let both = exp(sum(vec![(Sign::Plus, a.clone()), (Sign::Plus, name(&y))]));
        let apart = product(vec![exp(a.clone()), exp(name(&y))]);
        let body = compare(both, Relation::Equal, apart);
        let binding = Binding::of(Name::new(&y), false, Vec::new());
        let every = prop(PropKind::ForAll(vec![binding], Box::new(body.clone())));
        let all = self.block(&every, |c, _| c.emit(Rule::Power, body.clone()))?;
        self.instance(&all, b)
    }

    /// The fact 1 + x <= exp(x), also where it is known.
    pub(super) fn tangent_fact(&mut self, x: &Expr) -> Result<Label, Fail> {
        let known = |c: &Prover| {
            let said = [Relation::Less, Relation::LessEqual].map(|r| tangent(x, r));
            said.iter().find_map(|p| c.known(p))
        };
        match known(self) {
            Some(label) => Ok(label),
            None => self.tangent_at(x),
        }
    }
}
