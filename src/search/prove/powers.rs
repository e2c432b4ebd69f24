//! Powers with one base are written by few of them: `x^(1/3)` and `sqrt(x)` by `x^(1/6)`, `x^((n + 1)/n)` by `x` and `x^(1/n)`.
//!
//! Method: the exponents of a base span a lattice over the whole numbers. A basis of it gives the powers by which all others are
//! written, as products with whole exponents. Where the basis of a variable has no 1, the variable is written so too: then nothing
//! but polynomials is left. Such a power gets a name, which is positive.
//!
//! Powers whose exponents are natural numbers by their form need none of this: the kernel multiplies them out.

use super::exponent_lattice::{Exponent, basis_of, common_step, vectors};
use super::lattice::whole_coordinates;
use super::letters::{product, whole_power};
use super::{Fail, Prover};
use crate::algebra::Polynomial;
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::kernel::key;
use crate::kernel::order::Signs;
use crate::kernel::statement::{apply, compare, expr, name, numeral};
use crate::refute::closed::primes;
use crate::refute::literal::literal;
use malachite::base::num::basic::traits::{One, Zero};
use malachite::{Integer, Rational};
use std::collections::BTreeSet;
use std::rc::Rc;

/// How often powers may be written anew because of powers within powers.
const ROUNDS: usize = 6;

/// A product of powers: positive bases with their exponents.
type Product = Vec<(Polynomial, Exponent)>;

/// A power by which others are written.
#[derive(Clone, Debug)]
struct Generator {
    base: Polynomial,
    exponent: Exponent,
    written: Expr,
}

/// The powers that are written by others so far.
#[derive(Clone, Debug, Default)]
pub(super) struct Powers {
    generators: Vec<Generator>,
    /// The powers that were met, as text.
    met: BTreeSet<String>,
    /// The names of roots by which variables are written.
    roots: BTreeSet<String>,
}

impl Prover {
    /// Writes the powers in these expressions by as few of them as possible.
    pub(super) fn write_powers(&mut self, exprs: &[&Expr]) {
        for round in 0..ROUNDS {
            let letters = self.letters_in(exprs);
            if round == 0 {
                self.write_exponentials(&letters);
            }
            let mut open = Vec::new();
            exprs.iter().for_each(|e| powers_in(e, &mut open));
            open.extend(letters.into_iter().filter(|e| super::letters::as_power(e).is_some()));
            let mut found: Vec<(Expr, Product)> = Vec::new();
            for e in open {
                let text = key::expr(&e);
                if self.powers.met.contains(&text) || self.is_multiplied_out(&e) || found.iter().any(|f| f.0 == e) {
                    continue;
                }
                match self.as_product(&e) {
                    Some(product) if !product.is_empty() => found.push((e, product)),
                    _ => {
                        Rc::make_mut(&mut self.powers).met.insert(text);
                    }
                }
            }
            if found.is_empty() {
                return;
            }
            // Powers within others first, and roots: exponents may hold them.
            let inside = |e: &Expr| {
                let mut list = Vec::new();
                powers_in(e, &mut list);
                list.pop();
                list
            };
            let open: Vec<Expr> = found.iter().map(|f| f.0.clone()).collect();
            found.retain(|f| !inside(&f.0).iter().any(|e| open.contains(e)));
            if found.iter().any(|f| f.1.iter().all(|p| p.1.is_number())) {
                found.retain(|f| f.1.iter().all(|p| p.1.is_number()));
            }
            let mut bases: Vec<(Polynomial, Vec<Exponent>)> = Vec::new();
            for (base, exponent) in found.iter().flat_map(|f| &f.1) {
                match bases.iter_mut().find(|b| b.0 == *base) {
                    Some((_, list)) if list.contains(exponent) => {}
                    Some((_, list)) => list.push(exponent.clone()),
                    None => bases.push((base.clone(), vec![exponent.clone()])),
                }
            }
            // A variable that is written otherwise changes what the powers are made of.
            if bases.iter().any(|(base, exponents)| self.generate(base, exponents)) {
                continue;
            }
            for (e, product) in found {
                Rc::make_mut(&mut self.powers).met.insert(key::expr(&e));
                self.write_power(&e, &product);
            }
        }
    }

    /// Puts generators in the place of a power.
    fn write_power(&mut self, e: &Expr, product: &Product) {
        let factors: Option<Vec<Expr>> = product.iter().map(|(b, q)| self.by_generators(b, q)).collect();
        let Some(factors) = factors else { return };
        let right = super::letters::product(factors);
        if key::expr(&right) == key::expr(e) {
            return;
        }
        let shown = compare(e.clone(), Relation::Equal, right);
        let mut done = self
            .plainly(Rule::Power, &shown)
            .or_else(|_| self.attempt(|c| c.by_equal_bases(e, &shown)))
            .or_else(|_| self.emit(Rule::Power, shown.clone()));
        if done.is_err() {
            self.define(e);
            done = self.emit(Rule::Power, shown);
        }
        if let Ok(label) = done {
            self.put_in(&label);
        }
    }

    /// A power whose base an equation gives: both sides of the equation to that power.
    fn by_equal_bases(&mut self, e: &Expr, shown: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("an equation of the base");
        let PropKind::Compare(sides, _) = &shown.kind else { return Err(no()) };
        let (base, exponent) = super::letters::as_power(e).ok_or_else(no)?;
        for label in self.equations.clone() {
            let Some(Prop { kind: PropKind::Compare(equal, _), .. }) = self.fact(&label) else { continue };
            let [left, right] = equal.as_slice() else { continue };
            if self
                .plainly(
                    Rule::Combination { times: None, terms: Vec::new() },
                    &compare(base.clone(), Relation::Equal, left.clone()),
                )
                .is_err()
            {
                continue;
            }
            let raised = |of: &Expr| crate::kernel::statement::power(of, &exponent);
            let both = compare(raised(left), Relation::Equal, raised(right));
            let both = self.plainly(Rule::Monotone { from: label }, &both)?;
            let written = compare(raised(right), Relation::Equal, sides[1].clone());
            let written = self.plainly(Rule::Power, &written)?;
            let term = |label: Label| Term { facts: vec![label], factor: numeral(1) };
            return self.plainly(Rule::Combination { times: None, terms: vec![term(both), term(written)] }, shown);
        }
        Err(no())
    }

    /// What was written by generators of before is written by those of now, since these are put in their places.
    fn write_generators_anew(&mut self, before: Vec<Generator>) {
        for g in before {
            if !self.powers.generators.iter().any(|new| new.base == g.base && new.exponent == g.exponent) {
                self.write_power(&g.written, &vec![(g.base, g.exponent)]);
            }
        }
    }

    /// Writes exponentials exp(c·x) with one x by one of them: exp(x) by exp(x/2).
    fn write_exponentials(&mut self, letters: &[Expr]) {
        let mut found: Vec<(Exponent, Rational, &Expr)> = Vec::new();
        for e in letters {
            let ExprKind::Apply(f, list) = &e.kind else { continue };
            let ([x], "exp") = (list.as_slice(), f.text.as_str()) else { continue };
            let Some(q) = self.exponent(x).filter(|q| !q.top.is_zero()) else { continue };
            let c = q.top.leading_coefficient();
            found.push((Exponent { top: q.top.scale(&(Rational::ONE / &c)), ..q }, c, e));
        }
        while let Some((unit, _, _)) = found.first().cloned() {
            let (own, rest): (Vec<_>, Vec<_>) = found.into_iter().partition(|f| f.0 == unit);
            found = rest;
            let step = own.iter().fold(Rational::ZERO, |g, f| common_step(&g, &f.1));
            for (_, c, e) in own.iter().filter(|f| f.1 != step) {
                let Some(k) = i64::try_from(&Integer::try_from(c / &step).unwrap_or(Integer::ZERO)).ok() else {
                    continue;
                };
                let small = Exponent { top: unit.top.scale(&step), ..unit.clone() };
                let right = whole_power(apply("exp", self.written_exponent(&small)), k);
                let shown = compare((*e).clone(), Relation::Equal, right);
                if Rc::make_mut(&mut self.powers).met.insert(key::expr(e))
                    && let Ok(label) = self.plainly(Rule::Power, &shown)
                {
                    self.put_in(&label);
                }
            }
        }
    }

    /// Whether the kernel multiplies a power out, since its exponent is a whole number by its form.
    fn is_multiplied_out(&self, e: &Expr) -> bool {
        let is_natural = |n: &str| self.naturals.iter().any(|m| m == n);
        matches!(&e.kind, ExprKind::Power(_, k) if crate::claim::definedness::is_whole(k, &is_natural))
    }

    /// A step without equations put in.
    pub(super) fn plainly(&mut self, rule: Rule, shown: &Prop) -> Result<Label, Fail> {
        let equations = std::mem::take(&mut self.equations);
        let label = self.emit(rule, shown.clone());
        self.equations = equations;
        label
    }

    /// A power as a product of powers of bases that are positive.
    fn as_product(&mut self, e: &Expr) -> Option<Product> {
        let (base, exponent) = super::letters::as_power(e)?;
        let exponent = self.exponent(&exponent)?;
        let mut out = Product::new();
        for (base, k) in self.bases(&base)? {
            let q = exponent.times(&k)?;
            match out.iter_mut().find(|p| p.0 == base) {
                Some(p) => p.1 = p.1.plus(&q)?,
                None => out.push((base, q)),
            }
        }
        out.retain(|p| !p.1.top.is_zero());
        // Roots of other things than variables are left to what is known of radicals.
        let is_root = out.iter().all(|p| p.1.is_number());
        let of_variables = out.iter().all(|p| self.is_variable(&p.0));
        (!is_root || of_variables).then_some(out)
    }

    /// Whether a polynomial is a variable of the claim that is no natural number, or a root by which one is written. Names that other
    /// methods give are left alone.
    fn is_variable(&self, p: &Polynomial) -> bool {
        let Some(ExprKind::Name(n)) = self.single_letter(p).map(|e| e.kind) else { return false };
        self.is_a_name(&n)
            && !self.naturals.contains(&n)
            && (self.own_names.contains(&n) || self.powers.roots.contains(&n))
    }

    /// An expression as a product of powers of polynomials that are positive, and of prime numbers.
    fn bases(&mut self, e: &Expr) -> Option<Product> {
        let reading = self.read(e, true)?;
        let mut out = Product::new();
        for (p, k) in primes(&reading.number)? {
            out.push((Polynomial::constant(Rational::from(p)), Exponent::number(Rational::from(k))));
        }
        for f in &reading.factors {
            if !f.signs.within(Signs::POSITIVE) {
                return None;
            }
            let k = Exponent::number(Rational::from(f.power));
            // A power within a power: exponents multiply.
            let inner = self.single_letter(&f.poly).filter(|e| super::letters::as_power(e).is_some());
            match inner.and_then(|e| self.as_product(&e)) {
                Some(product) => {
                    for (base, q) in product {
                        out.push((base, q.times(&k)?));
                    }
                }
                None => out.push((f.poly.clone(), k)),
            }
        }
        Some(out)
    }

    /// What a polynomial that is a letter stands for.
    fn single_letter(&self, p: &Polynomial) -> Option<Expr> {
        let [v] = p.variables()[..] else { return None };
        (*p == Polynomial::variable(v)).then(|| self.letters.expr(v).cloned()).flatten()
    }

    fn exponent(&mut self, e: &Expr) -> Option<Exponent> {
        let reading = self.read(e, false)?;
        let (mut top, mut bottom) = (Polynomial::constant(reading.number), Polynomial::one());
        for f in &reading.factors {
            let power = f.poly.pow(u32::try_from(f.power.unsigned_abs()).ok()?).ok()?;
            let side = if f.power > 0 { &mut top } else { &mut bottom };
            *side = side.try_mul(&power).ok()?;
        }
        Exponent::new(top, bottom)
    }

    fn written_exponent(&self, q: &Exponent) -> Expr {
        let top = self.letters.written(&q.top);
        if q.bottom.is_one() { top } else { super::limits::over(top, self.letters.written(&q.bottom)) }
    }

    /// Chooses the powers by which those of a base are written. Returns whether the base itself is written by one of them.
    fn generate(&mut self, base: &Polynomial, exponents: &[Exponent]) -> bool {
        if exponents.iter().all(|q| self.coordinates_of(base, q).is_some()) {
            return false;
        }
        let may_be_replaced = self.is_variable(base) && self.powers.is_free(base);
        let mut all = vec![Exponent::one()];
        all.extend(self.powers.generators.iter().filter(|g| g.base == *base).map(|g| g.exponent.clone()));
        all.extend(exponents.iter().cloned().map(Exponent::upright));
        // A variable is written by one root; where it takes more powers, it stays.
        let free = if may_be_replaced { basis_of(&all, true).filter(|basis| basis.len() == 1) } else { None };
        let Some(basis) = free.or_else(|| basis_of(&all, false)) else { return false };
        let replaces = !basis.contains(&Exponent::one());
        let text = self.letters.written(base);
        let mut new = Vec::new();
        for exponent in basis.into_iter().filter(|q| *q != Exponent::one()) {
            let power = expr(ExprKind::Power(Box::new(text.clone()), Box::new(self.written_exponent(&exponent))));
            Rc::make_mut(&mut self.powers).met.insert(key::expr(&power));
            new.push(Generator { base: base.clone(), exponent, written: power });
        }
        if !replaces || !may_be_replaced {
            let powers = Rc::make_mut(&mut self.powers);
            let (before, others) = powers.generators.drain(..).partition(|g| g.base == *base);
            powers.generators = others;
            powers.generators.extend(new);
            self.write_generators_anew(before);
            return false;
        }
        let before = self.powers.clone();
        let [only] = new.as_slice() else { return false };
        let power = only.written.clone();
        Rc::make_mut(&mut self.powers).generators.extend(new);
        let done = self.attempt(|c| {
            let root = c.named_power(&power)?;
            let right = c.by_generators(base, &Exponent::one()).ok_or(Fail::No("a power of a root"))?;
            let label = c.plainly(Rule::Power, &compare(text.clone(), Relation::Equal, right))?;
            c.put_in(&label);
            c.put_in(&root);
            Ok(())
        });
        if done.is_err() {
            self.powers = before;
        }
        done.is_ok()
    }

    /// Gives a power a name, and shows that it is positive. Returns the label of `power = name`.
    fn named_power(&mut self, power: &Expr) -> Result<Label, Fail> {
        let fresh = self.fresh("r");
        let new = name(&fresh);
        Rc::make_mut(&mut self.powers).roots.insert(fresh);
        let label = self.plainly(Rule::Name, &compare(power.clone(), Relation::Equal, new.clone()))?;
        let term = |facts: Vec<Label>, factor: Expr| Term { facts, factor };
        let terms = vec![term(vec![label.clone()], literal(&Rational::from(-1))), term(Vec::new(), power.clone())];
        let positive = compare(new, Relation::Greater, numeral(0));
        self.plainly(Rule::Combination { times: None, terms }, &positive)?;
        Ok(label)
    }

    /// The generators of a base with the whole exponents that give a power of it, with the base itself among them if it has to be.
    fn coordinates_of(&self, base: &Polynomial, q: &Exponent) -> Option<Vec<(Expr, i64)>> {
        let own = self.powers.generators.iter().filter(|g| g.base == *base);
        let mut list: Vec<(Exponent, Expr)> = vec![(Exponent::one(), self.letters.written(base))];
        list.extend(own.map(|g| (g.exponent.clone(), g.written.clone())));
        // A base that is written by its only generator counts as that power.
        for skip in [0, 1] {
            let list = list.get(skip..).unwrap_or_default();
            let mut exponents: Vec<Exponent> = list.iter().map(|l| l.0.clone()).collect();
            exponents.push(q.clone());
            let mut vectors = vectors(&exponents)?;
            let target = vectors.pop()?;
            if let Some(k) = whole_coordinates(&vectors, &target) {
                return Some(list.iter().map(|l| l.1.clone()).zip(k).collect());
            }
        }
        None
    }

    /// The exponents with which powers of an expression occur, and the differences of two of them.
    pub(super) fn exponents_met(&mut self, e: &Expr) -> Vec<Expr> {
        let Some(reading) = self.read(e, false) else { return Vec::new() };
        let bases: Vec<&Polynomial> = reading.factors.iter().map(|f| &f.poly).collect();
        let own: Vec<&Generator> = self.powers.generators.iter().filter(|g| bases.contains(&&g.base)).collect();
        let mut out: Vec<Expr> = own.iter().map(|g| self.written_exponent(&g.exponent)).collect();
        for g in &own {
            for h in own.iter().filter(|h| h.base == g.base && h.exponent != g.exponent) {
                let opposite = Exponent { top: h.exponent.top.neg(), ..h.exponent.clone() };
                out.extend(g.exponent.plus(&opposite).map(|q| self.written_exponent(&q)));
            }
        }
        out
    }

    /// A power of a base as a product of its generators.
    fn by_generators(&self, base: &Polynomial, q: &Exponent) -> Option<Expr> {
        let list = self.coordinates_of(base, q)?;
        Some(product(list.into_iter().filter(|(_, k)| *k != 0).map(|(e, k)| whole_power(e, k)).collect()))
    }
}

impl Powers {
    /// Whether a base has no generators.
    fn is_free(&self, base: &Polynomial) -> bool {
        self.generators.iter().all(|g| g.base != *base)
    }
}

/// The powers in an expression whose exponents are no numerals, innermost first; those under a bound index are left out.
fn powers_in(e: &Expr, out: &mut Vec<Expr>) {
    let mut each = |list: &mut dyn Iterator<Item = &Expr>| list.for_each(|e| powers_in(e, out));
    match &e.kind {
        ExprKind::Number(_) | ExprKind::Name(_) => {}
        ExprKind::Apply(f, list) => {
            each(&mut list.iter());
            if matches!(f.text.as_str(), "sqrt" | "cbrt") {
                out.push(e.clone());
            }
        }
        ExprKind::Negate(a) => powers_in(a, out),
        ExprKind::Sum(list) => each(&mut list.iter().map(|t| &t.1)),
        ExprKind::Product(list) => each(&mut list.iter().map(|t| &t.1)),
        ExprKind::Power(a, b) => {
            each(&mut [&**a, &**b].into_iter());
            if !matches!(b.kind, ExprKind::Number(_)) {
                out.push(e.clone());
            }
        }
        ExprKind::SumOver(index, _) | ExprKind::ProductOver(index, _) | ExprKind::IntegralOver(index, _) => {
            each(&mut [&*index.from, &*index.to].into_iter());
        }
        ExprKind::Derivative(body, _) => powers_in(body, out),
        ExprKind::Matrix(rows) => each(&mut rows.iter().flatten()),
    }
}
