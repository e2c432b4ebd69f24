//! A view of the kernel's fractions for whoever explains a proof: the factors of an expression with their signs and the
//! facts that these come from.
//!
//! Contract: nothing here adds a fact or changes what a step means; a view is made from a state and forgotten.

use super::binder::bound_name;
use super::fraction::{Fraction, Poly};
use super::known::Known;
use super::order::Signs;
use super::statement::{apply, expr, name};
use super::term::Atom;
use super::{Checker, Refusal};
use crate::certificate::{Label, Show};
use crate::claim::syntax::{Expr, ExprKind, Factor, Index, Name, PI, Sign};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

/// c·∏ pᵢ^kᵢ, as the kernel reads an expression.
#[derive(Clone, Debug)]
pub struct View {
    /// The number c; with 0 there are no factors.
    pub number: BigRational,
    /// The factors that are no numbers.
    pub factors: Vec<Part>,
}

/// A factor pᵢ^kᵢ.
#[derive(Clone, Debug)]
pub struct Part {
    /// The polynomial pᵢ.
    pub of: Expr,
    /// The whole number kᵢ, not 0.
    pub power: i64,
    /// The signs that pᵢ may have.
    pub signs: Signs,
    /// The facts under `by` that these are known from.
    pub by: Vec<Label>,
}

impl Checker {
    /// An expression of a step as the kernel reads it there: with the equations that the step puts in, or without.
    ///
    /// # Errors
    /// The expression is no number, or a limit was reached.
    pub fn view(&mut self, e: &Expr, show: &Show, put_in: bool) -> Result<View, Refusal> {
        self.viewed(e, show, put_in, &|_| BigRational::one())
    }

    /// The same for readers: the coefficients of each factor are whole numbers without a common divisor, and no more of them
    /// are negative than positive.
    ///
    /// # Errors
    /// As [`Checker::view`].
    pub fn view_in_whole_numbers(&mut self, e: &Expr, show: &Show, put_in: bool) -> Result<View, Refusal> {
        self.viewed(e, show, put_in, &to_whole_numbers)
    }

    /// A view whose factors are multiplied by these numbers, its number divided by them.
    fn viewed(
        &mut self,
        e: &Expr,
        show: &Show,
        put_in: bool,
        scale: &dyn Fn(&Poly) -> BigRational,
    ) -> Result<View, Refusal> {
        let spent = self.work.clone();
        let result = self.viewed_within_limits(e, show, put_in, scale);
        self.work = spent;
        result
    }

    fn viewed_within_limits(
        &mut self,
        e: &Expr,
        show: &Show,
        put_in: bool,
        scale: &dyn Fn(&Poly) -> BigRational,
    ) -> Result<View, Refusal> {
        let known = self.known(&show.by, &show.using)?;
        let result = self.viewed_with(e, &known, &show.by, put_in, scale);
        self.memo.keep(known);
        result
    }

    fn viewed_with(
        &mut self,
        e: &Expr,
        known: &Known,
        by: &[Label],
        put_in: bool,
        scale: &dyn Fn(&Poly) -> BigRational,
    ) -> Result<View, Refusal> {
        let f = if put_in { self.fraction_with(e, known)? } else { self.fraction(e)? };
        let mut view = View { number: f.coefficient.clone(), factors: Vec::new() };
        for (poly, power) in &f.factors {
            let scale = scale(poly);
            for _ in 0..power.unsigned_abs() {
                if *power > 0 { view.number /= &scale } else { view.number *= &scale }
            }
            view.factors.push(self.part(poly, *power, &scale, known, by)?);
        }
        Ok(view)
    }

    fn part(
        &mut self,
        poly: &Poly,
        power: i64,
        scale: &BigRational,
        known: &Known,
        by: &[Label],
    ) -> Result<Part, Refusal> {
        known.forget_used();
        let signs = self.signs_of(&Fraction::of(poly), known)?.times(Signs::of_number(scale));
        let places = known.used().0;
        let labels = places.iter().filter_map(|place| by.get(*place).cloned()).collect();
        Ok(Part { of: self.scaled_expr(poly, scale), power, signs, by: labels })
    }

    fn poly_expr(&self, poly: &Poly) -> Expr {
        self.scaled_expr(poly, &BigRational::one())
    }

    /// A polynomial times a number as an expression, what is added before what is subtracted.
    fn scaled_expr(&self, poly: &Poly, scale: &BigRational) -> Expr {
        let mut terms: Vec<(Sign, Expr)> = Vec::new();
        for (monomial, c) in poly.terms() {
            let c = c * scale;
            let sign = if c.is_negative() { Sign::Minus } else { Sign::Plus };
            let powers = monomial.iter().map(|(atom, k)| (self.atom_expr(*atom), i64::from(*k))).collect();
            terms.push((sign, quotient(&c.abs(), powers)));
        }
        if terms.is_empty() {
            return quotient(&BigRational::zero(), Vec::new());
        }
        terms.sort_by_key(|(sign, _)| *sign == Sign::Minus);
        if let [(sign, one)] = terms.as_slice() {
            return if *sign == Sign::Plus { one.clone() } else { expr(ExprKind::Negate(Box::new(one.clone()))) };
        }
        if let Some((sign @ Sign::Minus, first)) = terms.first_mut() {
            *sign = Sign::Plus;
            *first = expr(ExprKind::Negate(Box::new(first.clone())));
        }
        expr(ExprKind::Sum(terms))
    }

    fn fraction_expr(&self, f: &Fraction) -> Expr {
        let powers = f.factors.iter().map(|(poly, k)| (self.poly_expr(poly), *k)).collect();
        let size = quotient(&f.coefficient.abs(), powers);
        if f.coefficient.is_negative() { expr(ExprKind::Negate(Box::new(size))) } else { size }
    }

    fn atom_expr(&self, place: usize) -> Expr {
        match self.atoms.get(place) {
            None => name("?"),
            Some(Atom::Variable(text) | Atom::Growing(text)) => name(text),
            Some(Atom::Bound(own) | Atom::Real(own)) => name(&bound_name('i', *own)),
            Some(Atom::Integral(integral)) => {
                let variable = Index {
                    name: Name::new(bound_name('i', integral.own)),
                    from: Box::new(self.fraction_expr(&integral.from)),
                    to: Box::new(self.fraction_expr(&integral.to)),
                };
                expr(ExprKind::IntegralOver(variable, Box::new(self.fraction_expr(&integral.body))))
            }
            Some(Atom::Member(family, at)) => apply(family, self.poly_expr(at)),
            Some(Atom::Exponential(log)) => apply("exp", self.fraction_expr(log)),
            Some(Atom::Logarithm(inner)) => apply("ln", self.fraction_expr(inner)),
            Some(Atom::Pi) => name(PI),
            Some(Atom::Cosine(u)) => apply("cos", self.fraction_expr(u)),
            Some(Atom::Sine(u)) => apply("sin", self.fraction_expr(u)),
            Some(Atom::Arcsine(x)) => apply("arcsin", self.fraction_expr(x)),
            Some(Atom::Arctangent(x)) => apply("arctan", self.fraction_expr(x)),
            Some(Atom::Power(base, exponent)) => {
                let (base, exponent) = (self.fraction_expr(base), self.fraction_expr(exponent));
                expr(ExprKind::Power(Box::new(base), Box::new(exponent)))
            }
            Some(Atom::Over(over)) => {
                let range = Index {
                    name: Name::new(bound_name('i', over.own)),
                    from: Box::new(self.poly_expr(&over.from)),
                    to: Box::new(self.poly_expr(&over.to)),
                };
                let body = Box::new(self.fraction_expr(&over.body));
                expr(if over.sum { ExprKind::SumOver(range, body) } else { ExprKind::ProductOver(range, body) })
            }
        }
    }
}

impl View {
    /// The product with c^k·∏ pᵢ^(kᵢ·k) of another, equal factors put together.
    #[must_use]
    pub fn times(mut self, other: &View, k: i64) -> View {
        for _ in 0..k.unsigned_abs() {
            if k > 0 { self.number *= &other.number } else { self.number /= &other.number }
        }
        for part in &other.factors {
            match self.factors.iter_mut().find(|p| p.of == part.of) {
                Some(own) => own.power += part.power * k,
                None => self.factors.push(Part { power: part.power * k, ..part.clone() }),
            }
        }
        self.factors.retain(|part| part.power != 0);
        self
    }

    /// The signs that the product may have.
    #[must_use]
    pub fn signs(&self) -> Signs {
        let number = Signs::of_number(&self.number);
        self.factors.iter().fold(number, |signs, part| signs.times(part.signs.power(part.power)))
    }

    /// The whole product as an expression.
    pub fn expr(&self) -> Expr {
        let powers = self.factors.iter().map(|part| (part.of.clone(), part.power)).collect();
        let size = quotient(&self.number.abs(), powers);
        if self.number.is_negative() { expr(ExprKind::Negate(Box::new(size))) } else { size }
    }
}

/// c·∏ pᵢ^kᵢ with c ≥ 0, as one quotient.
fn quotient(number: &BigRational, powers: Vec<(Expr, i64)>) -> Expr {
    let digits = |n: &num_bigint::BigInt| expr(ExprKind::Number(n.to_string()));
    let (mut above, mut below) = (Vec::new(), Vec::new());
    if !number.numer().is_one() {
        above.push(digits(number.numer()));
    }
    if !number.denom().is_one() {
        below.push(digits(number.denom()));
    }
    for (base, k) in powers {
        let size = k.unsigned_abs();
        let power = |base: Expr| match size {
            1 => base,
            _ => expr(ExprKind::Power(Box::new(base), Box::new(expr(ExprKind::Number(size.to_string()))))),
        };
        if k < 0 { below.push(power(base)) } else { above.push(power(base)) }
    }
    if above.is_empty() {
        above.push(digits(number.numer()));
    }
    let mut list: Vec<(Factor, Expr)> = above.into_iter().map(|e| (Factor::Times, e)).collect();
    let divisor = match below.len() {
        0 | 1 => below.pop(),
        _ => Some(expr(ExprKind::Product(below.into_iter().map(|e| (Factor::Times, e)).collect()))),
    };
    list.extend(divisor.map(|e| (Factor::Over, e)));
    match list.as_slice() {
        [(_, one)] => one.clone(),
        _ => expr(ExprKind::Product(list)),
    }
}

/// What makes the coefficients of a polynomial whole numbers without a common divisor, of which at least as many are positive
/// as negative.
fn to_whole_numbers(poly: &Poly) -> BigRational {
    // With p/q = a/b in lowest terms, the least common multiple of a and b is a·q, and their greatest common divisor a/p.
    let multiple = |a: BigInt, b: &BigInt| &a * BigRational::new(a.clone(), b.clone()).denom();
    let divisor = |a: BigInt, b: &BigInt| &a / BigRational::new(a.clone(), b.clone()).numer();
    let below = poly.terms().fold(BigInt::one(), |l, (_, c)| multiple(l, c.denom()));
    let above = poly.terms().fold(None, |g, (_, c)| {
        let c = (c * &below).to_integer();
        Some(g.map_or_else(|| c.abs(), |g| divisor(g, &c).abs()))
    });
    let negative = poly.terms().filter(|(_, c)| c.is_negative()).count();
    let sign = if 2 * negative > poly.terms().count() { -BigInt::one() } else { BigInt::one() };
    BigRational::new(sign * below, above.unwrap_or_else(BigInt::one))
}
