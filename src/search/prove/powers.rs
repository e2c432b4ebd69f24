//! For each base, generators: powers such that all other powers of the base are products of these with whole exponents.

use super::draft::Rule;
use super::lattice::{chosen, reduced, whole_coordinates};
use super::polynomials::{factored, from_algebra, to_algebra};
use super::write::{multiplied, negated, quotient};
use super::{Certifier, Fail};
use crate::algebra::Polynomial;
use crate::claim::syntax::*;
use crate::kernel::fraction::{Fraction, Poly, Work};
use crate::kernel::statement::{apply, compare, expr};
use crate::kernel::words::whole_power;
use crate::prove::draft::translate::Atom;

/// A generator: a power in which others are written.
#[derive(Clone, Debug)]
pub(super) struct Generator {
    base: Poly,
    exponent: Fraction,
    expr: Expr,
}

/// The most choices of exponents that are tried as generators.
const CHOICES: usize = 2000;

impl Certifier {
    /// Introduces every power in these expressions.
    pub(crate) fn prepare(&mut self, exprs: &[&Expr]) -> Result<(), Fail> {
        let mut list = Vec::new();
        exprs.iter().for_each(|e| powers_in(e, &mut list));
        list.retain(|e| !self.introduced.contains(&crate::kernel::text::expr(e)));
        if list.is_empty() {
            return Ok(());
        }
        for _ in 0..16 {
            let mut pending: Vec<(Expr, Fraction)> = Vec::new();
            for e in &list {
                let Ok(log) = self.checker.log(e) else { continue };
                if self.checker.exponential(&log).is_err() && !pending.iter().any(|p| p.0 == *e) {
                    let whole = match &e.kind {
                        ExprKind::Power(_, exponent) => {
                            self.checker.scalar(exponent).is_ok_and(|k| k.as_integer().is_some())
                        }
                        _ => false,
                    };
                    if !whole {
                        pending.push((e.clone(), log));
                    }
                }
            }
            if pending.is_empty() {
                for e in &list {
                    if let Ok(log) = self.checker.log(e)
                        && self.checker.exponential(&log).is_ok()
                    {
                        self.introduced.insert(crate::kernel::text::expr(e));
                    }
                }
                return Ok(());
            }
            self.introduce(&pending)?;
        }
        Ok(())
    }

    /// The logarithm as a sum over bases, each with its exponent.
    fn exponents(&mut self, log: &Fraction) -> Result<Vec<(Poly, Fraction)>, Fail> {
        let work = Work::default();
        let (top, bottom) = log.parts(&work).map_err(Fail::from)?;
        let mut out = Vec::new();
        let mut rest = top.clone();
        let atoms: std::collections::BTreeSet<usize> = top.atoms().collect();
        for atom in atoms {
            let Some(Atom::Logarithm(base)) = self.checker.atom(atom).cloned() else { continue };
            let parts = rest.coefficients(atom);
            if parts.keys().any(|k| *k > 1) {
                return Err(Fail::No("a power with a logarithm in its exponent"));
            }
            if let Some(coefficient) = parts.get(&1) {
                let exponent =
                    multiplied(&Fraction::of(coefficient), &Fraction::of(&bottom).power(-1).map_err(Fail::from)?)?;
                out.push((base, simplified(&exponent)?));
            }
            rest = parts.get(&0).cloned().unwrap_or_default();
        }
        if rest.terms().next().is_some() {
            let exponent = multiplied(&Fraction::of(&rest), &Fraction::of(&bottom).power(-1).map_err(Fail::from)?)?;
            out.push((natural_base(), simplified(&exponent)?));
        }
        Ok(out)
    }

    fn introduce(&mut self, pending: &[(Expr, Fraction)]) -> Result<(), Fail> {
        let mut decomposed = Vec::new();
        let mut wanted: Vec<(Poly, Vec<Fraction>)> = Vec::new();
        for (_, log) in pending {
            let parts = self.exponents(log)?;
            for (base, exponent) in &parts {
                match wanted.iter_mut().find(|w| w.0 == *base) {
                    Some(w) if !w.1.contains(exponent) => w.1.push(exponent.clone()),
                    Some(_) => {}
                    None => wanted.push((base.clone(), vec![exponent.clone()])),
                }
            }
            decomposed.push(parts);
        }
        for (base, exponents) in &wanted {
            if self.generate(base, exponents)? {
                // Powers are written otherwise now, and so are the bases that hold them.
                return Ok(());
            }
        }
        for ((e, _), parts) in pending.iter().zip(&decomposed) {
            let mut factors = Vec::new();
            for (base, exponent) in parts {
                factors.extend(self.written(base, exponent)?);
            }
            // Already introduced as a generator.
            let log = self.checker.log(e).map_err(Fail::from)?;
            if self.checker.exponential(&log).is_ok() {
                continue;
            }
            let value = product_of(&factors);
            self.take(Rule::Power, &[], Some(compare(e.clone(), Relation::Equal, value)))?;
            self.entries.push((e.clone(), parts.clone()));
        }
        Ok(())
    }

    /// Extends the generators of a base until they suffice for these exponents. Returns whether generators were replaced
    /// by finer ones.
    fn generate(&mut self, base: &Poly, exponents: &[Fraction]) -> Result<bool, Fail> {
        if exponents.iter().all(|e| self.written(base, e).is_ok()) {
            return Ok(false);
        }
        let is_atom = base.single_atom().is_some();
        let one = Fraction::integer(1);
        // The base itself counts: it occurs by itself; the number e does not.
        let natural = *base == natural_base();
        let mut all = if natural { Vec::new() } else { vec![one.clone()] };
        all.extend(self.generators.iter().filter(|g| g.base == *base).map(|g| g.exponent.clone()));
        all.extend(exponents.iter().cloned());
        all.dedup();
        let number = base.atoms().next().is_none();
        let basis = match choose(&all, is_atom || natural)? {
            // A number stays as it is written: it cannot be a power of something else.
            Some(basis) if natural || !number || basis.contains(&one) => basis,
            _ => {
                // Without the base itself, where it is a sum.
                choose(all.get(1..).unwrap_or_default(), true)?.ok_or("no generators for these exponents")?
            }
        };
        let base_expr = self.poly_expr(base).map_err(|e| e.within("base"))?;
        let mut fresh = Vec::new();
        for exponent in &basis {
            if *exponent == one && !natural {
                continue;
            }
            if self.generators.iter().any(|g| g.base == *base && g.exponent == *exponent) {
                continue;
            }
            let exponent_expr = self.fraction_expr(exponent)?;
            let power = if natural {
                apply("exp", exponent_expr)
            } else {
                expr(ExprKind::Power(Box::new(base_expr.clone()), Box::new(exponent_expr)))
            };
            self.take(Rule::Power, &[], Some(compare(power.clone(), Relation::Equal, power.clone())))?;
            let value = self.checker.scalar(&power).map_err(Fail::from)?;
            let atom = value.factors.keys().next().and_then(Poly::single_atom).ok_or("no atom")?;
            self.exponentials.push((atom, power.clone()));
            fresh.push(Generator { base: base.clone(), exponent: exponent.clone(), expr: power });
        }
        let dropped: Vec<Generator> =
            self.generators.iter().filter(|g| g.base == *base && !basis.contains(&g.exponent)).cloned().collect();
        self.generators.retain(|g| g.base != *base || basis.contains(&g.exponent));
        self.generators.extend(fresh);
        if is_atom && !basis.contains(&one) {
            let factors = self.written(base, &one)?;
            let prop = compare(base_expr, Relation::Equal, product_of(&factors));
            let label = self.take(Rule::Logarithm, &[], Some(prop))?;
            self.take(Rule::Replace, &[label], None)?;
            self.introduced.clear();
            // Facts about the variable are noted again, in the new generators.
            if let Some(Atom::Variable(variable)) = base.single_atom().and_then(|a| self.checker.atom(a)).cloned() {
                self.note_again(&variable);
            }
        }
        if !dropped.is_empty() {
            // Powers written in replaced generators are written in the new ones.
            self.introduced.clear();
            for old in &dropped {
                self.exponentials.retain(|x| x.1 != old.expr);
                let factors = self.written(base, &old.exponent).map_err(|e| e.within("powers"))?;
                self.take(Rule::Power, &[], Some(compare(old.expr.clone(), Relation::Equal, product_of(&factors))))?;
            }
            for (e, parts) in self.entries.clone() {
                if !parts.iter().any(|p| p.0 == *base) {
                    continue;
                }
                let mut factors = Vec::new();
                for (base, exponent) in &parts {
                    let Ok(list) = self.written(base, exponent) else { continue };
                    factors.extend(list);
                }
                let _ = self.take(Rule::Power, &[], Some(compare(e, Relation::Equal, product_of(&factors))));
            }
        }
        Ok(!dropped.is_empty() || (is_atom && !basis.contains(&one)))
    }

    /// The exponents of the generators of a variable, and the differences of two of them.
    pub(crate) fn exponents_of(&self, variable: &Fraction) -> Vec<Expr> {
        let bases: Vec<&Poly> = variable.factors.keys().collect();
        let logs: Vec<&Generator> = self
            .generators
            .iter()
            .filter(|g| {
                bases.contains(&&g.base)
                    || bases.iter().any(|b| {
                        b.single_atom().is_some_and(|a| self.exponentials.iter().any(|x| x.0 == a && x.1 == g.expr))
                    })
            })
            .collect();
        let mut out = Vec::new();
        for g in &logs {
            out.extend(self.fraction_expr(&g.exponent));
        }
        for g in &logs {
            for h in &logs {
                if g.base == h.base && g.exponent != h.exponent {
                    let difference = g.exponent.minus(&h.exponent, &Work::default());
                    out.extend(
                        difference
                            .map_err(Fail::from)
                            .and_then(|d| simplified(&d))
                            .and_then(|d| self.fraction_expr(&d)),
                    );
                }
            }
        }
        out
    }

    /// base^exponent in the generators: expressions with whole exponents.
    fn written(&self, base: &Poly, exponent: &Fraction) -> Result<Vec<(Expr, i64)>, Fail> {
        let mut list: Vec<(Fraction, Expr)> =
            self.generators.iter().filter(|g| g.base == *base).map(|g| (g.exponent.clone(), g.expr.clone())).collect();
        let replaced = base.single_atom().is_some_and(|a| self.checker.resolved(a) != Fraction::atom(a));
        if !replaced && *base != natural_base() {
            list.push((Fraction::integer(1), self.poly_expr(base)?));
        }
        let basis: Vec<Fraction> = list.iter().map(|l| l.0.clone()).collect();
        let mut both = basis.clone();
        both.push(exponent.clone());
        let mut vectors = vectors(&both)?;
        let target = vectors.pop().unwrap_or_default();
        // The base itself may be superfluous: the others are tried alone.
        for count in [vectors.len(), vectors.len().saturating_sub(usize::from(!replaced))] {
            if let Some(k) = whole_coordinates(vectors.get(..count).unwrap_or_default(), &target) {
                return Ok(k.into_iter().zip(&list).filter(|(k, _)| *k != 0).map(|(k, l)| (l.1.clone(), k)).collect());
            }
        }
        Err(Fail::No("a power that the generators do not give"))
    }
}

/// Stands for the base e of exponentials: no polynomial that is positive has no terms.
fn natural_base() -> Poly {
    Poly::default()
}

fn product_of(factors: &[(Expr, i64)]) -> Expr {
    let side = |positive: bool| {
        factors
            .iter()
            .filter(|f| (f.1 > 0) == positive)
            .map(|(e, k)| whole_power(e.clone(), k.unsigned_abs()))
            .collect::<Vec<_>>()
    };
    quotient(side(true), side(false))
}

/// A fraction with common factors of numerator and denominator cancelled where these are factors of
/// the denominator as it stands.
pub(crate) fn simplified(f: &Fraction) -> Result<Fraction, Fail> {
    let work = Work::default();
    let (top, bottom) = f.parts(&work).map_err(Fail::from)?;
    let (mut top, mut bottom) = (to_algebra(&top)?, to_algebra(&bottom)?);
    let common = crate::algebra::gcd::gcd(&top, &bottom).map_err(|_| "a limit in a greatest common divisor")?;
    if !common.is_constant() {
        top = top.exact_divide(&common).unwrap_or(top);
        bottom = bottom.exact_divide(&common).unwrap_or(bottom);
    }
    let (top, bottom) = (factored(&top)?, factored(&bottom)?);
    multiplied(&top, &bottom.power(-1).map_err(Fail::from)?)
}

/// The product of all factors by which some of these are divided, each as often as it is there.
fn common_denominator(list: &[Fraction]) -> Fraction {
    let mut common = Fraction::integer(1);
    for f in list {
        for (poly, k) in &f.factors {
            let entry = common.factors.entry(poly.clone()).or_insert(0);
            *entry = (*entry).max(-*k);
        }
    }
    common.factors.retain(|_, k| *k > 0);
    common
}

/// The exponents over a common denominator.
fn vectors(list: &[Fraction]) -> Result<Vec<Polynomial>, Fail> {
    let common = common_denominator(list);
    let work = Work::default();
    list.iter().map(|f| to_algebra(&multiplied(f, &common)?.expanded(&work).map_err(Fail::from)?)).collect()
}

/// Exponents that generate all with whole coordinates: some of them if possible, else by reduction of
/// the lattice. With `free` the first may be left out.
fn choose(all: &[Fraction], free: bool) -> Result<Option<Vec<Fraction>>, Fail> {
    let list = vectors(all)?;
    if let Some(places) = chosen(&list, CHOICES, &|_| true) {
        return Ok(Some(places.iter().map(|p| all[*p].clone()).collect()));
    }
    if !free {
        return Ok(None);
    }
    let inverse = common_denominator(all).power(-1).map_err(Fail::from)?;
    let exponent = |p: &Polynomial| simplified(&multiplied(&from_algebra(p)?, &inverse)?);
    reduced(&list).iter().map(exponent).collect::<Result<_, _>>().map(Some)
}

/// The powers, roots and exponentials in an expression, innermost first; those under a bound index
/// are left out.
fn powers_in(e: &Expr, out: &mut Vec<Expr>) {
    match &e.kind {
        ExprKind::Number(_) | ExprKind::Name(_) => {}
        ExprKind::Apply(f, arguments) => {
            arguments.iter().for_each(|a| powers_in(a, out));
            match (f.text.as_str(), arguments.first()) {
                ("sqrt" | "cbrt" | "exp", _) => out.push(e.clone()),
                ("cosh" | "sinh" | "tanh" | "sech", Some(x)) => {
                    for x in [x.clone(), negated(x.clone())] {
                        out.push(apply("exp", x));
                    }
                }
                _ => {}
            }
        }
        ExprKind::Negate(a) => powers_in(a, out),
        ExprKind::Sum(list) => list.iter().for_each(|(_, e)| powers_in(e, out)),
        ExprKind::Product(list) => list.iter().for_each(|(_, e)| powers_in(e, out)),
        ExprKind::Power(a, b) => {
            powers_in(a, out);
            powers_in(b, out);
            if !matches!(&b.kind, ExprKind::Number(text) if text.bytes().all(|b| b.is_ascii_digit())) {
                out.push(e.clone());
            }
        }
        ExprKind::SumOver(index, _) | ExprKind::ProductOver(index, _) => {
            powers_in(&index.from, out);
            powers_in(&index.to, out);
        }
        ExprKind::Derivative(body, _) => powers_in(body, out),
        ExprKind::Matrix(rows) => rows.iter().flatten().for_each(|e| powers_in(e, out)),
    }
}
