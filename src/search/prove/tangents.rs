//! The inequality 1 + x <= exp(x), tried for the exponentials and logarithms in a goal.

use super::coefficients::rational;
use super::comparison::single;
use super::letters::{product, total, whole_power};
use super::{Fail, Prover};
use crate::algebra::Monomial;
use crate::certificate::{Label, Rule, Term};
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

    /// The step of an induction about logarithms: the goal is the hypothesis, and ln(v) − ln(u) between 1 − u/v and v/u − 1, with
    /// ln(v) in the goal and ln(u) in the hypothesis.
    pub(super) fn by_tangent_of_a_step(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("logarithms in the step of an induction");
        if self.inductions == 0 {
            return Err(no());
        }
        let PropKind::Compare(_, relations) = &goal.kind else { return Err(no()) };
        let sign: i64 = match relations.as_slice() {
            [relation] => relation.is_greater().map(|greater| if greater { -1 } else { 1 }).ok_or_else(no)?,
            _ => return Err(no()),
        };
        let mut own = Vec::new();
        logarithms_of(goal, &mut own);
        let mut tried = 0;
        for (label, fact) in self.facts().iter().rev() {
            let mut known = Vec::new();
            logarithms_of(fact, &mut known);
            if !matches!(fact.kind, PropKind::Compare(..)) || known.is_empty() {
                continue;
            }
            let pairs = own.iter().flat_map(|v| known.iter().filter(move |u| *u != v).map(move |u| (v, u)));
            for (v, u) in pairs {
                for x in [super::facts::minus(v, u), super::facts::minus(u, v)] {
                    tried += 1;
                    let shown = self.attempt(|c| {
                        let tangent = c.tangent_fact(&x)?;
                        let factors =
                            [(1, 1), (1, 2), (2, 1)].map(|(n, d)| literal(&Rational::from_signeds(sign * n, d)));
                        let with = |factor: Expr| {
                            let own = Term { facts: vec![label.clone()], factor: numeral(1) };
                            vec![own, Term { facts: vec![tangent.clone()], factor }]
                        };
                        let found = factors.into_iter().find_map(|f| c.combination(goal.clone(), with(f)).ok());
                        found.ok_or_else(no)
                    });
                    if shown.is_ok() || tried >= TANGENTS {
                        return shown;
                    }
                }
            }
        }
        Err(no())
    }

    /// Proves a comparison of sums p·ln(u) with positive weights p, by tangents of the logarithms times their weights:
    /// p·(1 − ln(u) − c) <= p/(u·exp(c)), where c is 0 or a logarithm without a weight.
    pub(super) fn by_weighted_tangents(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let (a, _, b) = single(goal)?;
        let no = || Fail::No("logarithms with weights");
        let whole = self.letters.polynomial(&super::facts::minus(a, b)).ok_or_else(no)?;
        let (mut weighted, mut beside) = (Vec::new(), vec![None]);
        for (m, _) in whole.terms() {
            let is_log = |v: u32| self.letters.expr(v).is_some_and(super::logarithms::is_logarithm);
            let (logs, others): (Vec<_>, Vec<_>) = m.powers().iter().partition(|(v, _)| is_log(*v));
            let [(v, 1)] = logs.as_slice() else { continue };
            let log = self.letters.expr(*v).cloned().ok_or_else(no)?;
            if others.is_empty() {
                beside.extend([Some((Sign::Minus, log.clone())), Some((Sign::Plus, log))]);
                continue;
            }
            let weight =
                others.iter().filter_map(|(v, k)| Some(whole_power(self.letters.expr(*v)?.clone(), i64::from(*k))));
            weighted.push((product(weight.collect()), log));
        }
        if weighted.is_empty() || weighted.len() * beside.len() > TANGENTS {
            return Err(no());
        }
        for (weight, log) in weighted {
            if !self.signs_of(&weight).within(Signs::NOT_NEGATIVE) {
                continue;
            }
            for more in &beside {
                let terms = [(Sign::Minus, log.clone())].into_iter().chain(more.clone()).collect();
                let _ = self.attempt(|c| c.weighted_tangent(&weight, &total(terms)));
            }
        }
        self.quietly(goal).or_else(|_| self.with_solved_equations(|c| c.quietly(goal)))
    }

    /// p·(1 + x) <= p·exp(x).
    fn weighted_tangent(&mut self, weight: &Expr, x: &Expr) -> Result<(), Fail> {
        let tangent = self.tangent_fact(x)?;
        let one_and = sum(vec![(Sign::Plus, numeral(1)), (Sign::Plus, x.clone())]);
        let sides = [one_and, apply("exp", x.clone())].map(|e| product(vec![weight.clone(), e]));
        let [low, high] = sides;
        let shown = compare(low, Relation::LessEqual, high);
        let terms = vec![Term { facts: vec![tangent], factor: weight.clone() }];
        let label = self.combination(shown.clone(), terms)?;
        self.take_in(&label, &shown)
    }

    /// Adds the fact 1 + x <= exp(x) for each of these exponents x.
    fn tangents(&mut self, exponents: &[Expr]) -> Result<(), Fail> {
        let mut any = false;
        for x in exponents {
            any |= self.attempt(|c| c.tangent_at(x)).is_ok();
        }
        if any { Ok(()) } else { Err(Fail::No("a tangent")) }
    }

    /// The exponents at which the tangent may help: the exponents in the goal and the logarithms there, for an equation and in the
    /// step of an induction those in facts as well, their opposites, and sums of two of these.
    fn exponents(&mut self, goal: &Prop) -> Vec<Expr> {
        let mut sides = Vec::new();
        super::goals::sides_in(goal, &mut sides);
        let is_equation = matches!(&goal.kind, PropKind::Compare(_, relations) if *relations == [Relation::Equal]);
        if is_equation || self.inductions > 0 {
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
        let mut out: Vec<Expr> = self.exponents_between_terms(goal);
        let mut more: Vec<Expr> = single.iter().flat_map(|e| [signed(1, e), signed(-1, e)]).collect();
        for (i, a) in single.iter().enumerate() {
            for b in &single[i + 1..] {
                for (j, k) in [(1, -1), (-1, 1), (1, 1), (-1, -1)] {
                    let terms = [signed(j, a), signed(k, b)].map(|e| (Sign::Plus, e));
                    more.push(expr(ExprKind::Sum(terms.to_vec())));
                }
            }
        }
        out.extend(more);
        out.truncate(TANGENTS);
        out
    }

    /// Of the two terms of a comparison, the exponent by which the exponentials of one exceed those of the other, and its opposite:
    /// 2·x^2 − 1 for exp(x^2)^2 and 2·x^2·exp(1). Where all powers are single ones it is a difference of exponents. Of more terms,
    /// one with exponentials and others with a common factor: a − 1 − ln(x) for exp(a − 1) and a·x − x·ln(x).
    fn exponents_between_terms(&mut self, goal: &Prop) -> Vec<Expr> {
        let Ok(open) = self.open_factors(goal, 0) else { return Vec::new() };
        let terms: Vec<Monomial> = open.poly.terms().map(|t| t.0.clone()).collect();
        let scaled = |k: i64, e: Expr| (Sign::Plus, product(vec![literal(&Rational::from(k)), e]));
        let (mut exponents, mut is_single) = (Vec::new(), true);
        for m in &terms {
            let mut own = Vec::new();
            for (v, k) in m.powers() {
                if let Some(Expr { kind: ExprKind::Apply(f, at), .. }) = self.letters.expr(*v)
                    && let ("exp", [exponent]) = (f.text.as_str(), at.as_slice())
                {
                    is_single &= *k == 1;
                    own.push((i64::from(*k), exponent.clone()));
                }
            }
            exponents.push(own);
        }
        let of = |list: &[(i64, Expr)], sign: i64| list.iter().map(|(k, e)| scaled(sign * k, e.clone())).collect();
        if let [first, second] = exponents.as_slice() {
            let between = |sign: i64| {
                let list: Vec<(Sign, Expr)> = of(first, sign);
                total(list.into_iter().chain(of(second, -sign)).collect())
            };
            return if is_single { Vec::new() } else { vec![between(1), between(-1)] };
        }
        let moves = |k: &usize| exponents[*k].iter().any(|(_, e)| rational(e).is_none());
        let with: Vec<usize> = (0..terms.len()).filter(moves).collect();
        let [place] = with.as_slice() else { return Vec::new() };
        let others = terms.iter().enumerate().filter(|(k, _)| k != place).map(|(_, m)| m.clone());
        let common = others.reduce(|a, b| a.gcd(&b)).unwrap_or_else(Monomial::one);
        let mut list: Vec<(Sign, Expr)> = of(&exponents[*place], 1);
        for (v, k) in common.powers() {
            let Some(e) = self.letters.expr(*v).cloned() else { return Vec::new() };
            list.push(match &e.kind {
                ExprKind::Apply(f, at) if f.text == "exp" => scaled(-i64::from(*k), at[0].clone()),
                _ => scaled(-i64::from(*k), apply("ln", e)),
            });
        }
        if common.is_one() { Vec::new() } else { vec![total(list)] }
    }

    /// x != 0 for a sum of logarithms, with little effort.
    fn differs_by_logarithms(&mut self, other: &Prop) -> Result<(), Fail> {
        let splits = std::mem::replace(&mut self.splits, 9);
        let shown = self.of_logarithms(other);
        self.splits = splits;
        shown.map(|_| ())
    }

    /// `1 + x <= exp(x)`, strict where x is seen to be other than 0.
    pub(crate) fn tangent_at(&mut self, x: &Expr) -> Result<Label, Fail> {
        self.define(x);
        let other = compare(x.clone(), Relation::NotEqual, numeral(0));
        let strict =
            self.signs_of(x).within(Signs::NOT_ZERO) || self.attempt(|c| c.differs_by_logarithms(&other)).is_ok();
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

/// The logarithms in a comparison.
fn logarithms_of(p: &Prop, out: &mut Vec<Expr>) {
    if let PropKind::Compare(sides, _) = &p.kind {
        sides.iter().for_each(|e| super::logarithms::logarithms_in(e, out));
    }
}
