//! Signs of exponentials, and of sums of logarithms as the logarithm of a product.

use super::comparison::single;
use super::exponents::{logarithm_of_number, signed};
use super::letters::{product, total, whole_power};
use super::{Fail, Prover};
use crate::certificate::{Label, Rule};
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use crate::kernel::statement::{apply, compare, expr, name, numeral};
use crate::refute::literal::literal;
use malachite::Rational;

impl Prover {
    /// Whether an exponential is below or above 1, by the sign of its exponent.
    pub(crate) fn exponential(&mut self, e: &Expr, exponent: &Expr) -> Result<(), Fail> {
        let signs = self.signs_of(exponent);
        let relation = [Relation::Greater, Relation::Less, Relation::GreaterEqual, Relation::LessEqual]
            .into_iter()
            .find(|r| signs.within(Signs::of(*r)))
            .ok_or(Fail::No("the sign of an exponent"))?;
        let goal = compare(e.clone(), relation, numeral(1));
        self.attempt(|c| c.by_logarithm(&goal, e, exponent)).map(|_| ())
    }

    /// exp(x) > 1 from x > 0: otherwise x = ln(exp(x)) would be at most 0.
    fn by_logarithm(&mut self, goal: &Prop, e: &Expr, exponent: &Expr) -> Result<Label, Fail> {
        self.against_opposite(goal, |c, other| {
            let r = name(&c.fresh("r"));
            let named = c.emit(Rule::Name, compare(e.clone(), Relation::Equal, r.clone()))?;
            let turned = compare(r.clone(), Relation::Equal, e.clone());
            let turned = c.logic(&[&named], &turned)?;
            let PropKind::Compare(_, relations) = &other.kind else { return Err(Fail::No("a comparison")) };
            let equations = std::mem::take(&mut c.equations);
            c.equations.push(named);
            let bound = c.combination(compare(r.clone(), relations[0], numeral(1)), Vec::new());
            c.equations = vec![turned];
            let log = apply("ln", r);
            let same = c.combination(compare(log.clone(), Relation::Equal, exponent.clone()), Vec::new());
            c.equations = equations;
            bound?;
            let same = same?;
            let low = c.combination(compare(log, relations[0], numeral(0)), Vec::new())?;
            let terms = [(same, -1), (low, 1)]
                .map(|(label, k)| crate::certificate::Term { facts: vec![label], factor: literal(&Rational::from(k)) });
            let wrong = c.combination(compare(exponent.clone(), relations[0], numeral(0)), terms.to_vec())?;
            c.logic(&[&wrong], goal).or_else(|_| c.absurd(0, goal, None))
        })
    }

    /// Puts in ln(a/b) = ln(a) − ln(b), and likewise for other products of positive factors, for the logarithms in a goal and in the
    /// facts. Returns whether there is one.
    pub(super) fn split_logarithms(&mut self, goal: &Prop) -> bool {
        let mut sides = Vec::new();
        super::goals::sides_in(goal, &mut sides);
        self.facts().iter().for_each(|(_, fact)| super::goals::sides_in(fact, &mut sides));
        let mut logs = Vec::new();
        sides.iter().for_each(|e| logarithms_in(e, &mut logs));
        let mut any = false;
        for log in logs {
            any |= self.attempt(|c| c.split_logarithm(&log)).is_ok();
        }
        any
    }

    fn split_logarithm(&mut self, log: &Expr) -> Result<(), Fail> {
        let no = || Fail::No("a logarithm of a product");
        let ExprKind::Apply(_, at) = &log.kind else { return Err(no()) };
        let [u] = at.as_slice() else { return Err(no()) };
        let mut reading = self.read(u, true).ok_or_else(no)?;
        // -(a - 1)·m is (1 - a)·m.
        let negative = |f: &&mut super::facts::Factored| f.power % 2 != 0 && f.signs.within(Signs::of(Relation::Less));
        if reading.number < 0
            && let Some(factor) = reading.factors.iter_mut().find(negative)
        {
            factor.poly = factor.poly.neg();
            reading.number = -reading.number;
        }
        let plain = reading.factors.len() == 1 && reading.factors[0].power == 1 && reading.number == 1;
        if plain || reading.factors.is_empty() || reading.number <= 0 {
            return Err(no());
        }
        let multiple = |e: &Expr, k: i64| {
            let part = apply("ln", e.clone());
            let size = product(vec![literal(&Rational::from(k.abs())), part]);
            (if k < 0 { Sign::Minus } else { Sign::Plus }, size)
        };
        let mut terms = Vec::new();
        for f in &reading.factors {
            terms.push(multiple(&self.letters.written(&f.poly), f.power));
        }
        for (part, k) in [(reading.number.numerator_ref(), 1), (reading.number.denominator_ref(), -1)] {
            terms.extend(signed(logarithm_of_number(part), k));
        }
        let equation = compare(log.clone(), Relation::Equal, total(terms));
        if self.known(&equation).is_some() {
            return Err(no());
        }
        let label = self.emit(Rule::Power, equation)?;
        self.put_in(&label);
        Ok(())
    }

    /// Orders two numbers by a fact about their logarithms: the opposite order would contradict that fact.
    pub(crate) fn by_order_of_logarithms(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let (a, _, b) = single(goal)?;
        let no = || Fail::No("logarithms in order");
        let log = |e: &Expr| apply("ln", e.clone());
        let known: Vec<String> = self.checker.facts().map(|(_, p)| crate::kernel::text::prop(p)).collect();
        let (x, y) = (log(a), log(b));
        let occurs = |e: &Expr| known.iter().any(|text| text.contains(&crate::kernel::text::expr(e)));
        if !(occurs(&x) && occurs(&y)) {
            return Err(no());
        }
        self.against_opposite(goal, |c, other| {
            let PropKind::Compare(_, relations) = &other.kind else { return Err(no()) };
            let order = compare(x.clone(), relations[0], y.clone());
            c.of_logarithms(&order)?;
            c.absurd(0, goal, Some(&order))
        })
    }

    /// A comparison of sums of logarithms and a number c: their difference is the logarithm of a product with exp(c).
    pub(crate) fn of_logarithms(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let (a, relation, b) = single(goal)?;
        let no = || Fail::No("a sum of logarithms");
        let reading = self.read(&super::facts::minus(a, b), true).ok_or_else(no)?;
        let mut rest = vec![literal(&reading.number)];
        let mut sum = None;
        for f in &reading.factors {
            let e = self.letters.written(&f.poly);
            let logs = f.poly.variables().into_iter().any(|v| self.letters.expr(v).is_some_and(is_logarithm));
            match (logs, f.power) {
                (true, 1) if sum.is_none() => sum = Some(f.poly.clone()),
                (false, _) if super::facts::is_settled(f.signs) => rest.push(whole_power(e, f.power)),
                _ => return Err(no()),
            }
        }
        let sum = sum.ok_or_else(no)?;
        let denominators =
            sum.terms().map(|(_, c)| Rational::from(c.denominator_ref())).fold(Rational::from(1), |a, b| a * b);
        let scaled = sum.scale(&denominators);
        let mut factors = Vec::new();
        for (m, c) in scaled.terms() {
            if m.powers().is_empty() {
                factors.push(apply("exp", literal(c)));
                continue;
            }
            let [(v, 1)] = m.powers() else { return Err(no()) };
            let argument = match self.letters.expr(*v).map(|e| &e.kind) {
                Some(ExprKind::Apply(f, list)) if f.text == "ln" => list.first().cloned().ok_or_else(no)?,
                _ => return Err(no()),
            };
            let k = i64::try_from(c.numerator_ref()).map_err(|_| no())?;
            factors.push(whole_power(argument, if *c < 0 { -k } else { k }));
        }
        let whole = product(factors);
        let log = expr(ExprKind::Apply(Name::new("ln"), vec![whole.clone()]));
        self.define(&log);
        let written = self.letters.written(&scaled);
        let same = self.emit(Rule::Power, compare(written, Relation::Equal, log.clone()))?;
        // a − b = number·rest·sum.
        let signs = rest.iter().fold(Signs::POSITIVE, |s, e| s.times(self.signs_of(e)));
        let wanted = [
            Relation::Greater,
            Relation::GreaterEqual,
            Relation::Less,
            Relation::LessEqual,
            Relation::Equal,
            Relation::NotEqual,
        ]
        .into_iter()
        .find(|r| signs.times(Signs::of(*r)) == Signs::of(relation))
        .ok_or_else(no)?;
        self.show(&compare(whole, wanted, numeral(1)))?;
        let low = self.combination(compare(log, wanted, numeral(0)), Vec::new())?;
        rest.push(literal(&(Rational::from(1) / denominators)));
        let factor = product(rest);
        let terms = [same, low].map(|label| crate::certificate::Term { facts: vec![label], factor: factor.clone() });
        self.combination(goal.clone(), terms.to_vec())
    }
}

pub(super) fn is_logarithm(e: &Expr) -> bool {
    matches!(&e.kind, ExprKind::Apply(f, _) if f.text == "ln")
}

/// Adds the logarithms in an expression, each once.
pub(super) fn logarithms_in(e: &Expr, out: &mut Vec<Expr>) {
    if is_logarithm(e) && !out.contains(e) {
        out.push(e.clone());
    }
    crate::claim::walk::parts(e, &mut |part| logarithms_in(part, out));
}
