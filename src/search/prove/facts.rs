//! Facts as polynomials in letters.

use super::letters::{as_power, number, product, whole_power};
use super::products::{Kind, Known};
use super::{Fail, Prover};
use crate::algebra::Polynomial;
use crate::algebra::factor::factor;
use crate::certificate::{Label, Rule, Show, Term};
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, expr, numeral};
use crate::refute::literal::literal;
use malachite::Rational;
use malachite::base::num::basic::traits::{One, Zero};
use std::rc::Rc;

/// An expression as a number times powers of polynomials.
#[derive(Clone, Debug)]
pub(crate) struct Reading {
    /// The number; with 0 there are no factors.
    pub number: Rational,
    /// The powers.
    pub factors: Vec<Factored>,
}

/// A factor of a reading.
#[derive(Clone, Debug)]
pub(crate) struct Factored {
    /// The polynomial.
    pub poly: Polynomial,
    /// What it is raised to.
    pub power: i64,
    /// The signs that the polynomial may have, if they were asked for.
    pub signs: Signs,
}

/// Whether these signs are those of a number of one known sign other than 0.
pub(crate) fn is_settled(signs: Signs) -> bool {
    signs.within(Signs::POSITIVE) || signs.within(Signs::of(Relation::Less))
}

/// A fact times a factor, as a summand of a combination.
pub(super) fn scaled(fact: &Label, factor: Expr) -> Term {
    Term { facts: vec![fact.clone()], factor }
}

/// a − b.
pub(crate) fn minus(a: &Expr, b: &Expr) -> Expr {
    expr(ExprKind::Sum(vec![(Sign::Plus, a.clone()), (Sign::Minus, b.clone())]))
}

/// The most terms and the highest degree of polynomials that are factored, and of those in two variables.
const FACTOR: (usize, u32) = (80, 24);
const FACTOR_TWO: (usize, u32) = (500, 1100);

/// A number other than 0 to a whole power.
pub(super) fn power_of(base: &Rational, k: i64) -> Rational {
    let base = if k < 0 { Rational::ONE / base } else { base.clone() };
    (0..k.unsigned_abs()).fold(Rational::ONE, |all, _| all * &base)
}

impl Prover {
    /// An expression as the kernel reads it after substituting the equations; on request with the signs that the kernel sees.
    pub(crate) fn read(&mut self, e: &Expr, signs: bool) -> Option<Reading> {
        self.read_by(e, signs, &[])
    }

    /// Whether an expression is read as 0.
    pub(super) fn is_zero(&mut self, e: &Expr) -> bool {
        self.read(e, false).is_some_and(|r| r.number == 0)
    }

    /// Whether an expression is read as 1.
    pub(super) fn is_one(&mut self, e: &Expr) -> bool {
        self.read(e, false).is_some_and(|r| r.number == 1 && r.factors.is_empty())
    }

    fn read_by(&mut self, e: &Expr, signs: bool, without: &[Label]) -> Option<Reading> {
        let mut by = if signs { self.signs() } else { Vec::new() };
        by.retain(|label| !without.contains(label));
        let show = Show {
            label: "x".to_string(),
            rule: Rule::Name,
            prop: compare(e.clone(), Relation::Equal, e.clone()),
            by,
            using: self.equations.clone(),
        };
        let view = self.checker.view(e, &show, true).ok()?;
        let mut factors = Vec::new();
        for part in &view.factors {
            factors.push(Factored { poly: self.letters.polynomial(&part.of)?, power: part.power, signs: part.signs });
        }
        Some(Reading { number: number(&view.number)?, factors })
    }

    /// The reading with its polynomials as products of their factors, where these are found.
    pub(crate) fn split(&mut self, reading: Reading) -> Reading {
        self.split_where(reading, &|_| true)
    }

    /// The same, but a divisor stays whole, and so does what has a known sign: its factors may have none.
    pub(crate) fn split_open(&mut self, reading: Reading) -> Reading {
        self.split_where(reading, &|f| f.power > 0 && !is_settled(f.signs))
    }

    fn split_where(&mut self, mut reading: Reading, may: &dyn Fn(&Factored) -> bool) -> Reading {
        let mut factors = Vec::new();
        for f in reading.factors {
            let (terms, degree) = if f.poly.variables().len() <= 2 { FACTOR_TWO } else { FACTOR };
            let small = may(&f) && f.poly.term_count() <= terms && f.poly.degree() <= degree;
            match small.then(|| factor(&f.poly)) {
                Some(Ok(found)) if found.factors.len() > 1 || found.factors.iter().any(|f| f.1 > 1) => {
                    reading.number *= power_of(&found.unit, f.power);
                    for (poly, k) in found.factors {
                        let signs = self.signs_of(&self.letters.written(&poly));
                        factors.push(Factored { poly, power: f.power * i64::from(k), signs });
                    }
                }
                _ => factors.push(f),
            }
        }
        Reading { number: reading.number, factors }
    }

    /// The signs that an expression may have, as far as the kernel sees.
    pub(crate) fn signs_of(&mut self, e: &Expr) -> Signs {
        let Some(reading) = self.read(e, true) else { return Signs::ANY };
        reading.factors.iter().fold(sign_of(&reading.number), |s, f| s.times(f.signs.power(f.power)))
    }

    /// A fact as a polynomial that is 0, positive or not negative: without the factors whose signs are seen.
    pub(crate) fn known_of(&mut self, label: &str, fact: &Prop) -> Option<Known> {
        self.known_by(label, fact, false)
    }

    /// The same, with the only factor above the line whether its sign is seen or not: it may be seen by this very fact.
    fn known_by(&mut self, label: &str, fact: &Prop, is_said: bool) -> Option<Known> {
        let (a, relation, b) = fact.single()?;
        let (kind, up) = match relation {
            Relation::Equal => (Kind::Zero, true),
            Relation::Greater => (Kind::Strict, true),
            Relation::GreaterEqual => (Kind::Weak, true),
            Relation::Less => (Kind::Strict, false),
            Relation::LessEqual => (Kind::Weak, false),
            Relation::NotEqual => return None,
        };
        let at = (label.to_string(), self.equations.clone());
        let reading = match self.readings.get(&at) {
            Some(reading) => reading.clone(),
            None => {
                let reading = self.read(&minus(a, b), false).map(|r| self.split_open(r));
                self.readings.insert(at, reading.clone());
                reading
            }
        }?;
        if reading.number == Rational::ZERO {
            // 0 < 0 is a contradiction; 0 = 0 says nothing.
            let factors = vec![literal(&Rational::from(if up { 1 } else { -1 }))];
            let absurd = Known { poly: Polynomial::zero(), kind, facts: vec![label.to_string()], factors, order: 1 };
            return (kind == Kind::Strict).then_some(absurd);
        }
        let mut poly = Polynomial::one();
        let mut rest = vec![literal(&(Rational::ONE / &reading.number))];
        let mut positive = (reading.number > 0) == up;
        let mut above = reading.factors.iter().filter(|f| f.power > 0);
        let single = matches!((above.next(), above.next()), (Some(Factored { power: 1, .. }), None));
        let stays = single && (is_said || reading.factors.len() == 1);
        for f in &reading.factors {
            let signs = if stays && f.power > 0 { Signs::ANY } else { self.signs_of(&self.letters.written(&f.poly)) };
            let signs = signs.power(f.power);
            if is_settled(signs) || (kind == Kind::Zero && signs.within(Signs::NOT_ZERO)) {
                positive ^= !signs.within(Signs::POSITIVE);
                rest.push(whole_power(self.letters.written(&f.poly), -f.power));
            } else if f.power > 0 {
                poly = poly.try_mul(&f.poly.pow(u32::try_from(f.power).ok()?).ok()?).ok()?;
            } else {
                return None;
            }
        }
        if poly.term_count() > 60 {
            return None;
        }
        let poly = if positive { poly } else { poly.neg() };
        // poly = ± rest·(a − b)
        let factor = product(rest);
        let factor = if positive { factor } else { negated(factor) };
        Some(Known { poly, kind, facts: vec![label.to_string()], factors: vec![factor], order: 1 })
    }

    /// All known signs, of facts and of letters, as polynomials.
    pub(crate) fn all_known(&mut self, extra: &[Polynomial]) -> Vec<Known> {
        let list: Vec<(Label, Rc<Prop>)> = self
            .checker
            .facts()
            .filter(|(_, p)| matches!(p.kind, PropKind::Compare(..)))
            .map(|(l, p)| (l.to_string(), p.clone()))
            .collect();
        let mut out: Vec<Known> = Vec::new();
        let mut late = Vec::new();
        for (label, fact) in list.iter().rev() {
            let Some(known) = self.known_of(label, fact) else { continue };
            // A fact about numbers helps only where it is false.
            let holds = |c: Rational| match known.kind {
                Kind::Zero => c == 0,
                Kind::Strict => c > 0,
                Kind::Weak => c >= 0,
            };
            if known.poly.as_constant().is_some_and(holds) {
                late.push((label, fact));
                continue;
            }
            note(known, &mut out);
        }
        let mut letters: Vec<u32> = out.iter().flat_map(|k| k.poly.variables()).collect();
        letters.extend(extra.iter().flat_map(Polynomial::variables));
        letters.sort_unstable();
        letters.dedup();
        for &v in &letters {
            let Some(e) = self.letters.expr(v).cloned() else { continue };
            let signs = self.signs_of(&e);
            let poly = Polynomial::variable(v);
            let kind = if signs.within(Signs::POSITIVE) {
                Kind::Strict
            } else if signs.within(Signs::NOT_NEGATIVE) {
                Kind::Weak
            } else {
                continue;
            };
            if !out.iter().any(|k| k.poly == poly && (k.kind == kind || kind == Kind::Weak)) {
                out.retain(|k| k.poly != poly);
                out.push(Known { poly, kind, facts: Vec::new(), factors: vec![e], order: 0 });
            }
        }
        // Last, for only few columns are taken: what is below a divisor, such as k*n + k + 1 in (k*n + k + 1)/(n + 1) > 0.
        for (label, fact) in late {
            let known = self.known_by(label, fact, true).filter(|known| !known.poly.is_constant());
            let is_near = |known: &Known| known.poly.variables().iter().all(|v| letters.binary_search(v).is_ok());
            if let Some(known) = known.filter(is_near) {
                note(known, &mut out);
            }
        }
        out
    }

    /// Uses a fact: adds its parts and its immediate consequences.
    pub(crate) fn take_in(&mut self, label: &str, fact: &Prop) -> Result<(), Fail> {
        match &fact.kind {
            PropKind::Compare(sides, relations) if relations.len() == 1 => {
                let sides = sides.clone();
                self.enrich(&sides.iter().collect::<Vec<_>>());
                sides.iter().for_each(|e| self.note_squares(e));
                self.consequences(label, fact);
            }
            PropKind::Compare(sides, relations) => {
                for (pair, relation) in sides.windows(2).zip(relations) {
                    let part = compare(pair[0].clone(), *relation, pair[1].clone());
                    self.take_part(label, &part)?;
                }
            }
            PropKind::And(list) => {
                for part in list {
                    self.take_part(label, part)?;
                }
            }
            PropKind::Not(inner) => {
                if let Some(part) = opposite(inner) {
                    self.take_part(label, &part)?;
                }
            }
            _ => {}
        }
        Ok(())
    }

    fn take_part(&mut self, label: &str, part: &Prop) -> Result<(), Fail> {
        if self.known(part).is_none()
            && let Ok(new) = self.logic(&[label], part)
        {
            self.take_in(&new, part)?;
        }
        Ok(())
    }

    /// Of a product that is 0, in which all factors but one are not 0: that this one is.
    fn only_factor_is_zero(&mut self, label: &str, a: &Expr, b: &Expr) {
        let Some(reading) = self.read(&minus(a, b), true) else { return };
        let whole = reading.factors.len() == 1;
        let reading = self.split_open(reading);
        let mut open = reading.factors.iter().filter(|f| !f.signs.within(Signs::NOT_ZERO));
        let (Some(f), None) = (open.next(), open.next()) else { return };
        if whole && reading.factors.len() == 1 && f.power == 1 {
            return;
        }
        let zero = compare(self.letters.written(&f.poly), Relation::Equal, numeral(0));
        if self.known(&zero).is_some() {
            return;
        }
        let shown = self.attempt(|c| {
            if let Ok(label) = c.combination(zero.clone(), Vec::new()) {
                return Ok(label);
            }
            // The kernel sees it of the product as it is written.
            let mut factors = vec![literal(&reading.number)];
            factors.extend(reading.factors.iter().map(|f| whole_power(c.letters.written(&f.poly), f.power)));
            let written = compare(product(factors), Relation::Equal, numeral(0));
            let term = Term { facts: vec![label.to_string()], factor: numeral(1) };
            c.combination(written, vec![term])?;
            c.combination(zero.clone(), Vec::new())
        });
        if let Ok(label) = shown {
            let _ = self.take_in(&label, &zero);
        }
    }

    /// Adds immediate consequences of a comparison of whole numbers or of powers.
    fn consequences(&mut self, label: &str, fact: &Prop) {
        let Some((a, relation, b)) = fact.single() else { return };
        let plus_one = |e: &Expr| match &e.kind {
            ExprKind::Number(text) if text.len() < 9 => numeral(text.parse::<u32>().unwrap_or(0) + 1),
            _ => expr(ExprKind::Sum(vec![(Sign::Plus, e.clone()), (Sign::Plus, numeral(1))])),
        };
        if relation == Relation::Equal {
            self.only_factor_is_zero(label, a, b);
        }
        let whole =
            |c: &Prover, e: &Expr| crate::claim::definedness::is_whole(e, &|n| c.naturals.iter().any(|m| m == n));
        if whole(self, a)
            && whole(self, b)
            && matches!(relation, Relation::NotEqual | Relation::LessEqual | Relation::GreaterEqual)
        {
            // With what else is known it may be strict.
            let signs = self.signs_of(&minus(a, b));
            for relation in [Relation::Greater, Relation::Less] {
                let strict = compare(a.clone(), relation, b.clone());
                if signs.within(Signs::of(relation))
                    && self.known(&strict).is_none()
                    && let Ok(label) = self.combination(strict.clone(), Vec::new())
                {
                    self.consequences(&label, &strict);
                }
            }
        }
        if whole(self, a) && whole(self, b) {
            let next = match relation {
                Relation::Greater => Some(compare(a.clone(), Relation::GreaterEqual, plus_one(b))),
                Relation::Less => Some(compare(b.clone(), Relation::GreaterEqual, plus_one(a))),
                _ => None,
            };
            if let Some(next) = next
                && self.known(&next).is_none()
            {
                let _ = self.emit(Rule::Integer { from: label.to_string() }, next);
            }
        }
        if let (Some((x, p)), Some((y, q))) = (as_power(a), as_power(b))
            && p == q
        {
            let next = compare(x, relation, y);
            if self.known(&next).is_none() {
                let _ = self.emit(Rule::Monotone { from: label.to_string() }, next);
            }
        }
    }
}

/// Notes what is known, unless the same or more is known already.
fn note(known: Known, out: &mut Vec<Known>) {
    let same = |k: &Known| k.poly == known.poly && (k.kind == known.kind || known.kind == Kind::Weak);
    if !out.iter().any(same) {
        out.retain(|k| !(k.poly == known.poly && k.kind == Kind::Weak));
        out.push(known);
    }
}

/// The sign of a number.
pub(crate) fn sign_of(q: &Rational) -> Signs {
    if *q == Rational::ZERO {
        Signs::ZERO
    } else if *q > 0 {
        Signs::POSITIVE
    } else {
        Signs::of(Relation::Less)
    }
}

/// The opposite of an expression.
pub(super) fn negated(e: Expr) -> Expr {
    match e.kind {
        ExprKind::Negate(inner) => *inner,
        _ => expr(ExprKind::Negate(Box::new(e))),
    }
}

/// The negation of a proposition.
pub(crate) fn opposite(p: &Prop) -> Option<Prop> {
    use crate::kernel::statement::prop;
    Some(match &p.kind {
        PropKind::Compare(..) => {
            let (a, relation, b) = p.single()?;
            compare(a.clone(), relation.negated(), b.clone())
        }
        PropKind::And(list) => prop(PropKind::Or(list.iter().map(opposite).collect::<Option<_>>()?)),
        PropKind::Or(list) => prop(PropKind::And(list.iter().map(opposite).collect::<Option<_>>()?)),
        PropKind::Not(inner) => (**inner).clone(),
        PropKind::Implies(a, b) => prop(PropKind::And(vec![(**a).clone(), opposite(b)?])),
        _ => return None,
    })
}
