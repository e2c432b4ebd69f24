//! Comparisons: hints that let the kernel see the sign of a difference.

use super::draft::Rule;
use super::polynomials::{factored, from_algebra, to_algebra};
use super::write::multiplied;
use super::{Certifier, Fail};
use crate::algebra::Polynomial;
use crate::algebra::positivity::{self, Constraint};
use crate::certificate::Term;
use crate::claim::syntax::*;
use crate::kernel::fraction::{Fraction, Poly};
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, numeral};
use num_rational::BigRational;
use std::collections::BTreeSet;
use std::str::FromStr;

impl Certifier {
    /// Shows a single comparison by signs.
    pub fn comparison(&mut self, a: &Expr, relation: Relation, b: &Expr) -> Result<(), Fail> {
        let prop = compare(a.clone(), relation, b.clone());
        self.prepare(&[a, b])?;
        self.unfold_all(&[a, b])?;
        if self.take(Rule::Sign, &[], Some(prop.clone())).is_ok() {
            return Ok(());
        }
        let (difference, _) = match self.checker.difference(&prop) {
            Ok(found) => found,
            Err(crate::prove::draft::Failure::Rejected(reason)) => {
                // Whether it has a value may depend on a sign that must be proved first.
                self.define(&[a, b])?;
                if self.take(Rule::Sign, &[], Some(prop.clone())).is_ok() {
                    return Ok(());
                }
                self.checker.difference(&prop).map_err(|_| Fail::Value(reason))?
            }
            Err(failure) => return Err(failure.into()),
        };
        let open: Vec<Poly> = difference
            .factors
            .iter()
            .filter(|(p, k)| {
                let signs = self.checker.poly_signs(p).unwrap_or(Signs::ANY).power(**k);
                !(signs.within(Signs::POSITIVE) || signs.within(Signs::of(Relation::Less)))
            })
            .map(|f| f.0.clone())
            .collect();
        for poly in &open {
            // The search may have found finer powers, in which this polynomial is no longer written.
            let _ = self.settle(poly, 3);
            if self.take(Rule::Sign, &[], Some(prop.clone())).is_ok() {
                return Ok(());
            }
        }
        if relation == Relation::Equal && self.by_equations(&prop, &difference).is_ok() {
            return Ok(());
        }
        Err(Fail::NotShown(crate::claim::print::prop(&prop)))
    }

    /// Proves the conditions under which these expressions have values: on divisors, bases and arguments of logarithms.
    pub fn define(&mut self, exprs: &[&Expr]) -> Result<(), Fail> {
        let mut list = Vec::new();
        exprs.iter().for_each(|e| needs(e, &mut list));
        for (e, relation) in list {
            let Ok(f) = self.checker.scalar(&e) else { continue };
            if self.checker.signs_of(&f).is_ok_and(|s| s.within(Signs::of(relation))) {
                continue;
            }
            let wanted = compare(e.clone(), relation, numeral(0));
            if self.checker.knows(&wanted) {
                continue;
            }
            let _ = self.attempt(|c| c.comparison(&e, relation, &numeral(0)));
            if relation == Relation::Greater {
                // A power needs the sign of each factor.
                for poly in f.factors.keys() {
                    let _ = self.settle(poly, 2);
                }
            }
        }
        self.prepare(exprs)
    }

    /// Finds the sign of a polynomial and notes it in the draft.
    pub fn settle(&mut self, poly: &Poly, depth: usize) -> Result<(), Fail> {
        let known = self.checker.poly_signs(poly).map_err(Fail::from)?;
        if known.within(Signs::POSITIVE) || known.within(Signs::of(Relation::Less)) || known.within(Signs::ZERO) {
            return Ok(());
        }
        let p = to_algebra(poly)?;
        if p.term_count() <= 300 && depth > 0 {
            let split = factored(&p)?;
            if split.factors.len() > 1 || split.factors.values().any(|k| *k > 1) {
                for part in split.factors.keys().cloned().collect::<Vec<_>>() {
                    self.settle(&part, depth - 1)?;
                }
                let signs = self.checker.signs_of(&split).map_err(Fail::from)?;
                if let Some(relation) = signs.relation() {
                    let prop = compare(self.poly_expr(poly)?, relation, numeral(0));
                    let factor = self.fraction_expr(&split)?;
                    self.combination(prop, None, vec![Term { facts: Vec::new(), factor }])?;
                }
                return Ok(());
            }
        }
        self.search(poly, &p)
    }

    /// The sign of a polynomial sought although one is known: facts may contradict each other.
    pub(crate) fn search_again(&mut self, poly: &Poly) -> Result<(), Fail> {
        let p = to_algebra(poly)?;
        self.search(poly, &p)
    }

    /// A certificate of positivity under the facts, as a combination.
    fn search(&mut self, poly: &Poly, p: &Polynomial) -> Result<(), Fail> {
        self.tick()?;
        let known = self.known(poly)?;
        let constraints: Vec<Constraint> = known.iter().map(|k| k.constraint.clone()).collect();
        let seen = guess_signs(p, &constraints);
        for (p, positive, in_vain) in [(p.clone(), true, seen.1), (p.neg(), false, seen.0)] {
            if in_vain {
                continue;
            }
            let limits = positivity::Limits::default();
            let weak = positivity::certify(&p, &constraints, &[], false, &limits);
            let Some(weak) = weak else { continue };
            let strict = positivity::certify(&p, &constraints, &[], true, &limits);
            for (found, is_strict) in [(strict, true), (Some(weak), false)] {
                let Some(positivity::Certificate::Combination { summands, .. }) = found else { continue };
                let relation = match (positive, is_strict) {
                    (true, true) => Relation::Greater,
                    (true, false) => Relation::GreaterEqual,
                    (false, true) => Relation::Less,
                    (false, false) => Relation::LessEqual,
                };
                let mut terms = Vec::new();
                for summand in &summands {
                    let weight = BigRational::from_str(&summand.weight.to_string()).map_err(|_| "a weight")?;
                    let mut factor = Fraction::number(if positive { weight } else { -weight });
                    let mut facts = Vec::new();
                    for (place, exponent) in &summand.constraints {
                        let k = known.get(*place).ok_or("a constraint")?;
                        factor = multiplied(&factor, &k.factor.power(i64::from(*exponent)).map_err(Fail::from)?)?;
                        if let Some(label) = &k.label {
                            facts.extend(std::iter::repeat_n(label.clone(), *exponent as usize));
                        }
                    }
                    for square in &summand.squares {
                        factor = multiplied(&factor, &from_algebra(square)?.power(2).map_err(Fail::from)?)?;
                    }
                    terms.push(Term { facts, factor: self.fraction_expr(&factor)? });
                }
                let prop = compare(self.poly_expr(poly)?, relation, numeral(0));
                if self.combination(prop, None, terms).is_ok() {
                    return Ok(());
                }
            }
        }
        Ok(())
    }
}

/// The conditions under which an expression has a value, innermost first.
fn needs(e: &Expr, out: &mut Vec<(Expr, Relation)>) {
    match &e.kind {
        ExprKind::Number(_) | ExprKind::Name(_) => {}
        ExprKind::Apply(f, list) => {
            list.iter().for_each(|e| needs(e, out));
            if let ("sqrt" | "cbrt" | "ln", Some(x)) = (f.text.as_str(), list.first()) {
                out.push((x.clone(), Relation::Greater));
            }
        }
        ExprKind::Negate(a) => needs(a, out),
        ExprKind::Sum(list) => list.iter().for_each(|(_, e)| needs(e, out)),
        ExprKind::Product(list) => {
            for (factor, e) in list {
                needs(e, out);
                if *factor == Factor::Over {
                    out.push((e.clone(), Relation::NotEqual));
                }
            }
        }
        ExprKind::Power(a, b) => {
            needs(a, out);
            needs(b, out);
            if !matches!(&b.kind, ExprKind::Number(text) if text.bytes().all(|b| b.is_ascii_digit())) {
                out.push((
                    (**a).clone(),
                    if matches!(b.kind, ExprKind::Negate(_)) { Relation::NotEqual } else { Relation::Greater },
                ));
            }
        }
        ExprKind::SumOver(index, _) | ExprKind::ProductOver(index, _) => {
            needs(&index.from, out);
            needs(&index.to, out);
        }
        ExprKind::Derivative(body, _) => needs(body, out),
        ExprKind::Matrix(rows) => rows.iter().flatten().for_each(|e| needs(e, out)),
    }
}

/// Whether the polynomial takes positive values, and negative values, at sampled points that satisfy the constraints
/// strictly. It works in floating point and is only a hint which searches are futile.
fn guess_signs(p: &Polynomial, constraints: &[Constraint]) -> (bool, bool) {
    use malachite::base::num::conversion::traits::RoundingFrom;
    use malachite::base::rounding_modes::RoundingMode;
    type Terms = Vec<(Vec<(u32, i32)>, f64)>;
    let terms = |p: &Polynomial| -> Terms {
        p.terms()
            .map(|(m, c)| {
                let powers = m.powers().iter().map(|&(v, k)| (v, i32::try_from(k).unwrap_or(i32::MAX))).collect();
                (powers, f64::rounding_from(c, RoundingMode::Nearest).0)
            })
            .collect()
    };
    let variables: BTreeSet<u32> =
        p.variables().into_iter().chain(constraints.iter().flat_map(|c| c.poly.variables())).collect();
    let order: Vec<u32> = variables.into_iter().collect();
    let value = |terms: &Terms, point: &[f64]| -> f64 {
        let (sum, size) = terms.iter().fold((0.0, 0.0), |(sum, size), (powers, c)| {
            let term = powers
                .iter()
                .fold(*c, |t, &(v, k)| t * order.binary_search(&v).map_or(1.0, |place| point[place]).powi(k));
            (sum + term, size + f64::abs(term))
        });
        if f64::abs(sum) > size * 1e-9 { sum } else { 0.0 }
    };
    let limits: Vec<Terms> = constraints.iter().filter(|c| !c.poly.is_zero()).map(|c| terms(&c.poly)).collect();
    let goal = terms(p);
    let (mut positive, mut negative) = (false, false);
    let mut state = 0x9E37_79B9_7F4A_7C15_u64;
    for _ in 0..400 {
        let point: Vec<f64> = order
            .iter()
            .map(|_| {
                state ^= state << 13;
                state ^= state >> 7;
                state ^= state << 17;
                const VALUES: [f64; 8] = [0.1, 0.4, 0.8, 0.97, 1.05, 1.3, 2.5, 8.0];
                let size = VALUES[(state >> 40) as usize % 8] * (1.0 + ((state >> 20) % 97) as f64 / 1000.0);
                if state & 7 == 1 { -size } else { size }
            })
            .collect();
        if limits.iter().any(|c| value(c, &point) <= 0.0) {
            continue;
        }
        let v = value(&goal, &point);
        positive |= v > 0.0;
        negative |= v < 0.0;
    }
    (positive, negative)
}
