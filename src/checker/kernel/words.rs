//! What the kernel reads in expressions, for those who write a proof down elsewhere: fractions in words, and the signs
//! that a step reads from the facts that it cites.
//!
//! Nothing here justifies a step.

use super::binder::bound_name;
use super::fraction::{Fraction, Poly};
use super::known::Known;
use super::order::Signs;
use super::sign::{Found, NESTING};
use super::slope::with_ends;
use super::statement::{apply, expr, name};
use super::term::Atom;
use super::{Checker, Refusal};
use crate::certificate::{Label, Show};
use crate::claim::syntax::*;
use num_rational::BigRational;
use num_traits::{One, Signed as _, Zero};

/// What a fact says of the sign of one factor.
pub struct Note {
    /// The fact, by label, and the place of the comparison among its parts.
    pub fact: Label,
    /// The comparison.
    pub prop: Prop,
    /// The difference of its sides.
    pub difference: Fraction,
    /// The factor.
    pub factor: Poly,
    /// Its signs.
    pub signs: Signs,
}

/// What a step knows, with where it comes from.
pub struct Signed {
    known: Known,
    /// The notes, in the order in which they are taken.
    pub notes: Vec<Note>,
}

/// The kind of an atom, as far as its sign depends on it.
pub enum Form {
    /// A natural number.
    Natural,
    /// A power: base, exponent, whether the exponent is whole.
    Power(Fraction, Fraction, bool),
    /// An exponential.
    Exponential(Fraction),
    /// A logarithm.
    Logarithm(Fraction),
    /// A member of a family or sequence; whether the definition of a sequence gives its sign.
    Member(bool),
    /// A sum, or a product.
    Over(bool),
    /// A variable.
    Variable,
}

impl Checker {
    /// An expression with the equations put in.
    ///
    /// # Errors
    /// It cannot be read.
    pub fn read(&mut self, e: &Expr, using: &[Label]) -> Result<Fraction, Refusal> {
        let known = self.known(&[], using)?;
        self.fraction_with(e, &known)
    }

    /// Whether an expression is a matrix.
    pub fn is_matrix(&mut self, e: &Expr) -> bool {
        self.memo.begin(&self.scope);
        matches!(self.value(e), Ok(super::term::Value::Matrix(_)))
    }

    /// The difference of two fractions.
    ///
    /// # Errors
    /// It is too large.
    pub fn difference_of(&self, a: &Fraction, b: &Fraction) -> Result<Fraction, Refusal> {
        a.minus(b, &self.work)
    }

    /// The signs that the facts under `by` give, with the equations put in.
    ///
    /// # Errors
    /// A fact cannot be read.
    pub fn signed(&mut self, by: &[Label], using: &[Label]) -> Result<Signed, Refusal> {
        let mut signed = Signed { known: self.known(&[], using)?, notes: Vec::new() };
        for label in by {
            let fact = self.fact(label)?;
            self.take_note(label, &fact, &mut signed)?;
        }
        Ok(signed)
    }

    fn take_note(&mut self, label: &str, fact: &Prop, signed: &mut Signed) -> Result<(), Refusal> {
        match &fact.kind {
            PropKind::And(list) => list.iter().try_for_each(|p| self.take_note(label, p, signed)),
            PropKind::Compare(sides, relations) => {
                for (pair, relation) in sides.windows(2).zip(relations) {
                    let [a, b] = pair else { continue };
                    if self.is_matrix(a) {
                        continue;
                    }
                    let prop = crate::kernel::statement::compare(a.clone(), *relation, b.clone());
                    let plain = self.fraction(a)?.minus(&self.fraction(b)?, &self.work)?;
                    let replaced =
                        self.put_into(a, &signed.known)?.0.minus(&self.put_into(b, &signed.known)?.0, &self.work)?;
                    let both = if plain == replaced { vec![replaced] } else { vec![plain, replaced] };
                    for difference in both {
                        let before = signed.known.signs.len();
                        self.note(&difference, Signs::of(*relation), &Default::default(), &mut signed.known)?;
                        for sign in signed.known.signs.iter().skip(before) {
                            signed.notes.push(Note {
                                fact: label.to_string(),
                                prop: prop.clone(),
                                difference: difference.clone(),
                                factor: sign.poly.clone(),
                                signs: sign.signs,
                            });
                        }
                    }
                }
                Ok(())
            }
            PropKind::ForAll(..) => self.learn(fact, &mut signed.known),
            _ => Ok(()),
        }
    }

    /// The signs of a factor.
    ///
    /// # Errors
    /// It is too large.
    pub fn factor_signs(&self, factor: &Poly, signed: &Signed) -> Result<Signs, Refusal> {
        self.poly_signs(factor, &signed.known, NESTING, &mut Found::new(&signed.known))
    }

    /// The signs of a fraction.
    ///
    /// # Errors
    /// It is too large.
    pub fn signs(&self, f: &Fraction, signed: &Signed) -> Result<Signs, Refusal> {
        self.signs_as_read(f, &signed.known)
    }

    /// The domain in which rule `slope` finds both points and a function that has a value: the binding as it is, or with ends.
    ///
    /// # Errors
    /// There is none.
    pub fn domain_of_slope(
        &mut self,
        binding: &Binding,
        derivative: &Expr,
        points: [&Expr; 2],
        from: &[Label],
        show: &Show,
    ) -> Result<Binding, Refusal> {
        let mut known = self.known(&show.by, &show.using)?;
        Ok(with_ends(binding, self.slope_domain(binding, derivative, points, from, &mut known)?))
    }

    /// What an atom is.
    pub fn atom_form(&self, place: usize) -> Form {
        if self.is_natural_atom(place) {
            return Form::Natural;
        }
        match self.atoms.get(place) {
            Some(Atom::Power(base, exponent)) => {
                Form::Power(base.clone(), exponent.clone(), self.is_whole(exponent).unwrap_or(false))
            }
            Some(Atom::Exponential(inner)) => Form::Exponential(inner.clone()),
            Some(Atom::Logarithm(inner)) => Form::Logarithm(inner.clone()),
            Some(Atom::Member(name, _)) => {
                Form::Member(self.signs_of_members.get(name).is_some_and(|signs| *signs != Signs::ANY))
            }
            Some(Atom::Over(over)) => Form::Over(over.sum),
            _ => Form::Variable,
        }
    }

    /// The product of two fractions.
    ///
    /// # Errors
    /// It is too large.
    pub fn product_of(&self, a: &Fraction, b: &Fraction) -> Result<Fraction, Refusal> {
        a.times(b, &self.work)
    }

    /// The numerator and denominator of a fraction.
    ///
    /// # Errors
    /// They are too large.
    pub fn parts_of(&self, f: &Fraction) -> Result<(Poly, Poly), Refusal> {
        f.parts(&self.work)
    }

    /// A fraction without divisors as one polynomial.
    ///
    /// # Errors
    /// It is too large, or has a divisor.
    pub fn expanded(&self, f: &Fraction) -> Result<Poly, Refusal> {
        f.expanded(&self.work)
    }

    /// The number of a fraction as powers of primes.
    ///
    /// # Errors
    /// It is too large.
    pub fn primes(&self, f: &Fraction) -> Result<Vec<(num_bigint::BigInt, i64)>, Refusal> {
        f.prime_powers(&self.work)
    }

    /// A fraction in words, in its factors.
    pub fn fraction_words(&self, f: &Fraction) -> Expr {
        let (mut top, mut bottom) = (Vec::new(), Vec::new());
        for (poly, k) in &f.factors {
            let power = whole_power(self.poly_words(poly), k.unsigned_abs());
            if *k > 0 { top.push(power) } else { bottom.push(power) }
        }
        quotient(&f.coefficient, top, bottom)
    }

    /// A polynomial in words.
    pub fn poly_words(&self, poly: &Poly) -> Expr {
        let mut terms = Vec::new();
        for (monomial, c) in poly.terms() {
            let top = monomial.iter().map(|(a, k)| whole_power(self.atom_words(*a), u64::from(*k))).collect();
            terms.push((Sign::Plus, quotient(c, top, Vec::new())));
        }
        match (terms.len(), terms.pop()) {
            (0, _) | (_, None) => numeral(&BigRational::zero()),
            (1, Some((_, single))) => single,
            (_, Some(last)) => {
                terms.push(last);
                expr(ExprKind::Sum(terms))
            }
        }
    }

    /// An atom in words.
    pub fn atom_words(&self, place: usize) -> Expr {
        match self.atoms.get(place) {
            Some(Atom::Variable(text) | Atom::Growing(text)) => name(text),
            Some(Atom::Bound(own) | Atom::Real(own)) => name(&bound_name('j', *own)),
            Some(Atom::Integral(integral)) => {
                let variable = Index {
                    name: Name::new(bound_name('j', integral.own)),
                    from: Box::new(self.fraction_words(&integral.from)),
                    to: Box::new(self.fraction_words(&integral.to)),
                };
                expr(ExprKind::IntegralOver(variable, Box::new(self.fraction_words(&integral.body))))
            }
            Some(Atom::Member(family, index)) => apply(family, self.poly_words(index)),
            Some(Atom::Logarithm(inner)) => apply("ln", self.fraction_words(inner)),
            Some(Atom::Exponential(inner)) => apply("exp", self.fraction_words(inner)),
            Some(Atom::Pi) => name(PI),
            Some(Atom::Cosine(u)) => apply("cos", self.fraction_words(u)),
            Some(Atom::Sine(u)) => apply("sin", self.fraction_words(u)),
            Some(Atom::Arcsine(x)) => apply("arcsin", self.fraction_words(x)),
            Some(Atom::Arctangent(x)) => apply("arctan", self.fraction_words(x)),
            Some(Atom::Power(base, exponent)) => {
                expr(ExprKind::Power(Box::new(self.fraction_words(base)), Box::new(self.fraction_words(exponent))))
            }
            Some(Atom::Over(over)) => {
                let index = Index {
                    name: Name::new(bound_name('j', over.own)),
                    from: Box::new(self.poly_words(&over.from)),
                    to: Box::new(self.poly_words(&over.to)),
                };
                let body = Box::new(self.fraction_words(&over.body));
                expr(if over.sum { ExprKind::SumOver(index, body) } else { ExprKind::ProductOver(index, body) })
            }
            None => numeral(&BigRational::zero()),
        }
    }
}

fn numeral(q: &BigRational) -> Expr {
    let whole = |n: &num_bigint::BigInt| expr(ExprKind::Number(n.to_string()));
    let size = q.abs();
    let value = if size.denom().is_one() {
        whole(size.numer())
    } else {
        expr(ExprKind::Product(vec![(Factor::Times, whole(size.numer())), (Factor::Over, whole(size.denom()))]))
    };
    if q.is_negative() { expr(ExprKind::Negate(Box::new(value))) } else { value }
}

/// b^k with k ≥ 1.
pub fn whole_power(base: Expr, k: u64) -> Expr {
    if k == 1 { base } else { expr(ExprKind::Power(Box::new(base), Box::new(expr(ExprKind::Number(k.to_string()))))) }
}

/// c times the product of the first list, over each of the second.
pub fn quotient(c: &BigRational, mut top: Vec<Expr>, bottom: Vec<Expr>) -> Expr {
    if top.is_empty() || !c.is_one() {
        top.insert(0, numeral(c));
    }
    let mut list: Vec<(Factor, Expr)> = top.into_iter().map(|e| (Factor::Times, e)).collect();
    list.extend(bottom.into_iter().map(|e| (Factor::Over, e)));
    match (list.len(), list.pop()) {
        (1, Some((_, single))) => single,
        (_, Some(last)) => {
            list.push(last);
            expr(ExprKind::Product(list))
        }
        (_, None) => numeral(&BigRational::one()),
    }
}
