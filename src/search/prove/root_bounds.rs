//! Inequalities with roots, by bounds that are rational functions: each root lies between a weighted arithmetic and a weighted
//! harmonic mean of its base and a power of any positive Y.
//!
//! Method: for p = m/q between 0 and 1, the inequality between weighted means (Hardy, Littlewood, Pólya, "Inequalities", 1934,
//! theorem 9) says that q·X·Y^m/((q − m)·X + m·Y^q) <= X^p <= (m·X + (q − m)·Y^q)/(q·Y^(q − m)), with equality at X = Y^q. Y is a form
//! that has the value of the root where all variables are equal: there most inequalities of this kind are equations.
//!
//! Certificate: the bounds, the inequality between them without roots, and a combination of both.
//!
//! Limits: [`VARIABLES`] positive variables, [`TERMS`] terms with a root, [`CHOICES`] choices of Y for each side.

use super::comparison::single;
use super::letters::{as_power, product, total, whole_power};
use super::limits::over;
use super::{Fail, Prover};
use crate::algebra::{Polynomial, Univariate};
use crate::certificate::{Label, Term};
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, expr, name, numeral, sum};
use crate::refute::literal::literal;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::CheckedRoot;
use malachite::base::num::basic::traits::{One, Zero};

/// The most variables, the most terms that hold a root, and the most choices of Y on each side.
const VARIABLES: usize = 4;
const TERMS: usize = 8;
const CHOICES: usize = 4;

/// A root X^(m/q) and the forms that its Y may be.
struct Root {
    base: Expr,
    m: u32,
    q: u32,
    forms: Vec<Expr>,
}

/// A term of the difference that should not be negative: a product without roots, and powers of roots by 1 or −1.
struct Part {
    negative: bool,
    written: Expr,
    plain: Vec<(Factor, Expr)>,
    roots: Vec<(Factor, Root)>,
}

impl Prover {
    /// Shows an inequality with roots of positive variables.
    pub(super) fn by_root_bounds(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let (a, relation, b) = single(goal)?;
        let no = || Fail::No("roots of positive variables");
        let is_greater = relation.is_greater().ok_or_else(no)?;
        // The bounds themselves are shown with less effort.
        if self.splits >= 3 || self.roots_in(&super::facts::minus(a, b)).is_empty() {
            return Err(no());
        }
        let mut names = std::collections::BTreeSet::new();
        crate::kernel::names::names_in_prop(goal, &mut names);
        names.retain(|n| self.is_a_name(n));
        let names: Vec<Expr> = names.iter().map(|n| name(n)).collect();
        let positive = names.iter().all(|e| self.signs_of(e).within(Signs::POSITIVE));
        if !positive || !(1..=VARIABLES).contains(&names.len()) {
            return Err(no());
        }
        let variables: Vec<u32> = names.iter().map(|e| self.letters.of(e)).collect();
        let equal_at = self.where_all_are_equal(&variables);
        let mut parts = Vec::new();
        for (e, negative) in [(a, !is_greater), (b, is_greater)] {
            self.parts_with_roots(e, negative, &variables, &equal_at, &mut parts).ok_or_else(no)?;
        }
        let rooted = parts.iter().filter(|p| !p.roots.is_empty()).count();
        if rooted == 0 || rooted > TERMS {
            return Err(no());
        }
        // The difference of the greater side and the other.
        let order = if is_greater { relation } else { relation.turned() };
        let term = |fact: Label, negative: bool| Term {
            facts: vec![fact],
            factor: literal(&Rational::from(if negative == is_greater { -1 } else { 1 })),
        };
        let choices = |negative: bool| {
            let roots = parts.iter().filter(|p| p.negative == negative).flat_map(|p| &p.roots);
            roots.map(|r| r.1.forms.len()).max().unwrap_or(1).min(CHOICES)
        };
        for above in 0..choices(false) {
            for below in 0..choices(true) {
                let bounded: Vec<Expr> =
                    parts.iter().map(|p| p.bounded(if p.negative { below } else { above })).collect();
                let signed = |e: &Expr, p: &Part| (if p.negative { Sign::Minus } else { Sign::Plus }, e.clone());
                let total = total(bounded.iter().zip(&parts).map(|(e, p)| signed(e, p)).collect());
                let without = compare(total, order, numeral(0));
                let shown = self.attempt(|c| {
                    let mut terms = vec![term(c.without_roots(&without)?, false)];
                    for (part, bound) in parts.iter().zip(&bounded).filter(|(p, _)| !p.roots.is_empty()) {
                        let order = if part.negative { Relation::LessEqual } else { Relation::GreaterEqual };
                        let fact = c.without_cases(&compare(part.written.clone(), order, bound.clone()))?;
                        terms.push(term(fact, part.negative));
                    }
                    c.combination(goal.clone(), terms)
                });
                if shown.is_ok() {
                    return shown;
                }
            }
        }
        Err(no())
    }

    /// An inequality of rational functions in positive variables. No equation is put in: those of roots would bring these back.
    pub(super) fn without_roots(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let equations = std::mem::take(&mut self.equations);
        let shown = self
            .attempt(|c| c.without_cases(goal))
            .or_else(|_| self.attempt(|c| c.by_differences(goal, 1..=3)))
            .or_else(|_| self.attempt(|c| c.by_sums_of_squares(goal)));
        self.equations = equations;
        shown
    }

    /// The value of all variables where they are equal, by an equation between them, or 1.
    fn where_all_are_equal(&mut self, variables: &[u32]) -> Rational {
        let known = self.all_known(&[]);
        let zeros = known.iter().filter(|k| k.kind == super::products::Kind::Zero).map(|k| &k.poly);
        let about = zeros.filter(|p| !p.is_constant() && p.variables().iter().all(|v| variables.contains(v)));
        let mut places = about.filter_map(|p| {
            let one = p.substitute_all(&|_| Some(Polynomial::variable(0))).ok()?;
            Univariate::from_polynomial(&one, 0)?.rational_roots().into_iter().find(|t| *t > 0)
        });
        places.next().unwrap_or(Rational::ONE)
    }

    /// The terms of a sum, with their roots; none if a root stands elsewhere.
    fn parts_with_roots(
        &mut self,
        e: &Expr,
        negative: bool,
        variables: &[u32],
        at: &Rational,
        out: &mut Vec<Part>,
    ) -> Option<()> {
        match &e.kind {
            ExprKind::Negate(a) => return self.parts_with_roots(a, !negative, variables, at, out),
            ExprKind::Sum(list) => {
                return list.iter().try_for_each(|(sign, e)| {
                    self.parts_with_roots(e, negative != (*sign == Sign::Minus), variables, at, out)
                });
            }
            _ => {}
        }
        let mut part = Part { negative, written: e.clone(), plain: Vec::new(), roots: Vec::new() };
        let single = [(Factor::Times, e.clone())];
        let factors = if let ExprKind::Product(list) = &e.kind { list.as_slice() } else { &single };
        for (factor, e) in factors {
            match self.root(e, variables, at) {
                Some(root) => part.roots.push((*factor, root)),
                None if self.roots_in(e).is_empty() && self.signs_of(e).within(Signs::NOT_NEGATIVE) => {
                    part.plain.push((*factor, e.clone()));
                }
                None => return None,
            }
        }
        out.push(part);
        Some(())
    }

    /// A root of what is rational in the variables, with the forms of its degree that equal it where all variables do.
    fn root(&mut self, e: &Expr, variables: &[u32], at: &Rational) -> Option<Root> {
        let (base, exponent) = as_power(e)?;
        let p = self.letters.number(&exponent).filter(|p| *p > 0 && *p < 1)?;
        let (m, q) = (u32::try_from(p.numerator_ref()).ok()?, u32::try_from(p.denominator_ref()).ok()?);
        let reading = self.read(&base, true)?;
        let is_plain = |p: &Polynomial| p.variables().iter().all(|v| variables.contains(v));
        if q > 4 || reading.number <= 0 || !reading.factors.iter().all(|f| is_plain(&f.poly)) {
            return None;
        }
        // X = top/bottom^q, so that its root is that of top, over bottom.
        let (mut top, mut bottom) = (Polynomial::constant(reading.number.clone()), Polynomial::one());
        let mut wholes = Vec::new();
        for f in &reading.factors {
            let k = u32::try_from(f.power.unsigned_abs()).ok()?;
            let (above, below) = if f.power > 0 { (k, 0) } else { (k.div_ceil(q) * q - k, k.div_ceil(q)) };
            top = top.try_mul(&f.poly.pow(above).ok()?).ok()?;
            bottom = bottom.try_mul(&f.poly.pow(below).ok()?).ok()?;
            wholes.push(f.poly.clone());
        }
        let value = |p: &Polynomial| p.evaluate(&|_| at.clone());
        let root = Some(value(&top)).filter(|v| *v > 0)?.checked_root(u64::from(q))?;
        let degree = top.degree() / q;
        let all = variables.iter().fold(Polynomial::zero(), |s, v| s.add(&Polynomial::variable(*v)));
        let mut forms = vec![all.pow(degree).ok()?];
        if degree == 2 && variables.len() > 1 {
            let squares = variables.iter().map(|v| Polynomial::variable(*v).pow(2).ok()).collect::<Option<Vec<_>>>()?;
            let squares = squares.iter().fold(Polynomial::zero(), |s, p| s.add(p));
            forms.push(forms.first()?.sub(&squares));
            forms.push(squares);
        }
        forms.extend(wholes.into_iter().filter(|p| p.degree() == degree && degree > 0));
        let written = |form: &Polynomial| {
            let scaled = form.scale(&(&root / value(form)));
            let below = self.letters.written(&bottom);
            let e = self.letters.written(&scaled);
            if bottom.is_one() { e } else { over(e, below) }
        };
        let forms = forms.iter().filter(|f| value(f) > Rational::ZERO).map(written).collect();
        Some(Root { base, m, q, forms })
    }
}

impl Part {
    /// What lies below the term, or above where it is subtracted, with one choice of Y.
    fn bounded(&self, choice: usize) -> Expr {
        if let [(Factor::Times, root)] = self.roots.as_slice()
            && self.plain.is_empty()
        {
            return root.bound(choice, self.negative);
        }
        if self.roots.is_empty() {
            return self.written.clone();
        }
        let mut factors = self.plain.clone();
        for (factor, root) in &self.roots {
            let up = self.negative == (*factor == Factor::Times);
            factors.push((*factor, root.bound(choice, up)));
        }
        expr(ExprKind::Product(factors))
    }
}

impl Root {
    /// The bound from above or from below.
    fn bound(&self, choice: usize, up: bool) -> Expr {
        let (m, q) = (self.m, self.q);
        let Some(y) = self.forms.get(choice).or(self.forms.first()) else { return self.base.clone() };
        let times = |k: u32, e: Expr| product(vec![numeral(k), e]);
        let y_to = |k: u32| whole_power(y.clone(), i64::from(k));
        let mean =
            |k: u32, j: u32| sum(vec![(Sign::Plus, times(k, self.base.clone())), (Sign::Plus, times(j, y_to(q)))]);
        if up {
            over(mean(m, q - m), times(q, y_to(q - m)))
        } else {
            over(product(vec![numeral(q), self.base.clone(), y_to(m)]), mean(q - m, m))
        }
    }
}
