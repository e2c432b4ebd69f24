//! Numbers in closed form: sums of rationals times powers of primes and of π, exponentials and logarithms.
//!
//! Contract: a form has the value of the number that it was made for, so two numbers with the same form are equal. An
//! enclosure could not show that. Numbers with different forms may still be equal. Numbers with long forms have none.

use super::literal::literal;
use crate::claim::syntax::*;
use crate::kernel::statement::{apply, expr, name};
use malachite::base::num::arithmetic::traits::{Abs, Floor, Pow};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::{Natural, Rational};
use std::collections::BTreeMap;

/// The most terms of a form.
const TERMS: usize = 12;

/// Prime factors up to this one are found.
const TRIAL: u64 = 1_000;

/// The largest whole exponent.
pub(crate) const LARGEST: i64 = 400;

/// What a form is made of.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Atom {
    /// A prime.
    Prime(u64),
    /// π.
    Pi,
    /// A positive number that is a sum.
    Base(Closed),
    /// The exponential of a product.
    Exp(Product),
    /// The logarithm of a prime, of π, or of a positive number that is a sum.
    Ln(Closed),
}

/// A product of powers; exponents of primes lie between 0 and 1.
type Product = BTreeMap<Atom, Rational>;

/// Σ c·∏ a^q, by the products; no c is 0.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Closed(BTreeMap<Product, Rational>);

impl Closed {
    /// A rational number.
    pub fn rational(q: &Rational) -> Closed {
        Closed::term(Product::new(), q.clone())
    }

    /// The rational number, if the form is one.
    pub fn as_rational(&self) -> Option<Rational> {
        match self.0.iter().next() {
            None => Some(Rational::ZERO),
            Some((product, c)) if product.is_empty() && self.0.len() == 1 => Some(c.clone()),
            _ => None,
        }
    }

    /// π.
    pub fn pi() -> Closed {
        Closed::term(Product::from([(Atom::Pi, Rational::ONE)]), Rational::ONE)
    }

    /// How many times π it is, if it is a rational multiple of that.
    pub fn turns(&self) -> Option<Rational> {
        match self.single() {
            None if self.0.is_empty() => Some(Rational::ZERO),
            Some((product, c)) if product.len() == 1 && product.get(&Atom::Pi) == Some(&Rational::ONE) => {
                Some(c.clone())
            }
            _ => None,
        }
    }

    /// The form as a sum of products of powers, as a point of a refutation may have it; `None` where a number is too long.
    pub fn written(&self) -> Option<Expr> {
        let mut sum = Vec::new();
        for (product, c) in &self.0 {
            let (mut below_root, mut factors) = (1u64, Vec::new());
            for (atom, q) in product {
                match atom {
                    Atom::Prime(p) if *q == Rational::from_unsigneds(1u64, 2) => {
                        below_root = below_root.checked_mul(*p)?
                    }
                    Atom::Prime(p) => {
                        let base = literal(&Rational::from(*p));
                        factors.push(expr(ExprKind::Power(Box::new(base), Box::new(literal(q)))));
                    }
                    Atom::Exp(product) => {
                        let argument = Closed::term(product.clone(), q.clone()).written()?;
                        factors.push(apply("exp", argument));
                    }
                    Atom::Pi | Atom::Base(_) | Atom::Ln(_) => {
                        let base = match atom {
                            Atom::Base(sum) => sum.written()?,
                            Atom::Ln(sum) => apply("ln", sum.written()?),
                            _ => name(PI),
                        };
                        factors.push(match *q == 1 {
                            true => base,
                            false => expr(ExprKind::Power(Box::new(base), Box::new(literal(q)))),
                        });
                    }
                }
            }
            if below_root != 1 {
                factors.push(apply("sqrt", literal(&Rational::from(below_root))));
            }
            sum.push((if *c < 0 { Sign::Minus } else { Sign::Plus }, multiple(c, factors)));
        }
        // What is added stands before what is subtracted.
        sum.sort_by_key(|(sign, _)| *sign == Sign::Minus);
        Some(match sum.len() {
            0 => literal(&Rational::ZERO),
            1 => match sum.remove(0) {
                (Sign::Plus, term) => term,
                (Sign::Minus, term) => expr(ExprKind::Negate(Box::new(term))),
            },
            _ if sum[0].0 == Sign::Minus => {
                sum.iter_mut().for_each(|(sign, _)| *sign = Sign::Plus);
                expr(ExprKind::Negate(Box::new(expr(ExprKind::Sum(sum)))))
            }
            _ => expr(ExprKind::Sum(sum)),
        })
    }

    fn term(product: Product, c: Rational) -> Closed {
        Closed(if c == 0 { BTreeMap::new() } else { BTreeMap::from([(product, c)]) })
    }

    fn short(self) -> Option<Closed> {
        (self.0.len() <= TERMS).then_some(self)
    }

    fn single(&self) -> Option<(&Product, &Rational)> {
        self.0.iter().next().filter(|_| self.0.len() == 1)
    }

    /// The sum.
    pub fn plus(&self, other: &Closed) -> Option<Closed> {
        let mut out = self.0.clone();
        for (product, c) in &other.0 {
            *out.entry(product.clone()).or_insert(Rational::ZERO) += c;
        }
        out.retain(|_, c| *c != 0);
        Closed(out).short()
    }

    /// The product.
    pub fn times(&self, other: &Closed) -> Option<Closed> {
        let mut out = Closed::default();
        for (a, c) in &self.0 {
            for (b, d) in &other.0 {
                let mut product = a.clone();
                for (atom, q) in b {
                    *product.entry(atom.clone()).or_insert(Rational::ZERO) += q;
                }
                out = out.plus(&reduced(product, c * d)?)?;
            }
        }
        Some(out)
    }

    /// The first term of a sum, where that is positive by its form, and the sum divided by it: so a sum has one form as a base.
    fn by_first_term(&self) -> Option<(Closed, Closed)> {
        let (product, c) = self.0.iter().next().filter(|(_, c)| **c > 0)?;
        let is_positive = product.keys().all(|atom| !matches!(atom, Atom::Ln(_)));
        let first = Closed::term(if is_positive { product.clone() } else { Product::new() }, c.clone());
        let rest = self.times(&first.power(&-Rational::ONE)?)?;
        Some((first, rest))
    }

    /// a^q, for a > 0, or for a product a and a whole q.
    pub fn power(&self, q: &Rational) -> Option<Closed> {
        let whole = i64::try_from(q).ok().filter(|k| k.abs() <= LARGEST);
        if let (Some(k @ 0..=8), None) = (whole, self.single()) {
            return (0..k).try_fold(Closed::rational(&Rational::ONE), |power, _| power.times(self));
        }
        let Some((product, c)) = self.single() else {
            let (first, rest) = self.by_first_term()?;
            let base = Closed::term(Product::from([(Atom::Base(rest), q.clone())]), Rational::ONE);
            return first.power(q)?.times(&base);
        };
        // A logarithm may be negative.
        if whole.is_none() && product.keys().any(|atom| matches!(atom, Atom::Ln(_))) {
            return None;
        }
        let powers = product.iter().map(|(atom, k)| (atom.clone(), k * q)).collect();
        let coefficient = match whole {
            Some(k) => Closed::rational(&c.pow(k)),
            None if *c > 0 => {
                let primes = primes(c)?.into_iter().map(|(p, k)| (Atom::Prime(p), Rational::from(k) * q)).collect();
                reduced(primes, Rational::ONE)?
            }
            None => return None,
        };
        coefficient.times(&reduced(powers, Rational::ONE)?)
    }

    /// e^a.
    pub fn exp(&self) -> Option<Closed> {
        let mut out = Closed::rational(&Rational::ONE);
        for (product, c) in &self.0 {
            let factor = match product.iter().next() {
                // exp(c·ln a) = a^c.
                Some((Atom::Ln(a), k)) if product.len() == 1 && *k == 1 => a.power(c)?,
                _ => Closed::term(Product::from([(Atom::Exp(product.clone()), c.clone())]), Rational::ONE),
            };
            out = out.times(&factor)?;
        }
        Some(out)
    }

    /// ln a, for a > 0.
    pub fn ln(&self) -> Option<Closed> {
        let ln = |a: Closed, k: Rational| Closed::term(Product::from([(Atom::Ln(a), Rational::ONE)]), k);
        let Some((product, c)) = self.single() else {
            let (first, rest) = self.by_first_term()?;
            return first.ln()?.plus(&ln(rest, Rational::ONE));
        };
        let mut out = Closed::default();
        for (p, k) in primes(c)? {
            out = out.plus(&ln(Closed::rational(&Rational::from(p)), Rational::from(k)))?;
        }
        for (atom, k) in product {
            let part = match atom {
                Atom::Prime(p) => ln(Closed::rational(&Rational::from(*p)), k.clone()),
                Atom::Pi => ln(Closed::pi(), k.clone()),
                Atom::Base(a) => ln(a.clone(), k.clone()),
                Atom::Exp(log) => Closed::term(log.clone(), k.clone()),
                Atom::Ln(_) => return None,
            };
            out = out.plus(&part)?;
        }
        Some(out)
    }
}

/// |c| times these factors: `2*pi/3`.
fn multiple(c: &Rational, factors: Vec<Expr>) -> Expr {
    if factors.is_empty() {
        return literal(&c.abs());
    }
    let (top, bottom) = (c.numerator_ref(), c.denominator_ref());
    let whole = |k: &Natural| expr(ExprKind::Number(k.to_string()));
    let first = (*top != 1u32).then(|| whole(top));
    let mut list: Vec<(Factor, Expr)> = first.into_iter().chain(factors).map(|e| (Factor::Times, e)).collect();
    list.extend((*bottom != 1u32).then(|| (Factor::Over, whole(bottom))));
    match list.len() {
        1 => list.remove(0).1,
        _ => expr(ExprKind::Product(list)),
    }
}

/// c·∏ a^q with the whole parts of powers of primes in c, and first powers of sums multiplied out.
fn reduced(mut product: Product, mut c: Rational) -> Option<Closed> {
    let mut sums = Vec::new();
    for (atom, q) in &mut product {
        match atom {
            Atom::Prime(p) => {
                let whole = Rational::from((&*q).floor());
                let k = i64::try_from(&whole).ok().filter(|k| k.abs() <= LARGEST)?;
                c *= Rational::from(*p).pow(k);
                *q -= whole;
            }
            Atom::Base(sum) if *q == 1 => {
                sums.push(sum.clone());
                *q = Rational::ZERO;
            }
            _ => {}
        }
    }
    product.retain(|_, q| *q != 0);
    sums.iter().try_fold(Closed::term(product, c), |out, sum| out.times(sum))
}

/// The primes of a positive rational with their exponents, where they are found.
pub(crate) fn primes(q: &Rational) -> Option<Vec<(u64, i64)>> {
    if *q <= 0 {
        return None;
    }
    let mut out = Vec::new();
    for (part, side) in [(q.numerator_ref(), 1), (q.denominator_ref(), -1)] {
        let mut rest = u64::try_from(part).ok()?;
        for p in 2..=TRIAL {
            let mut k = 0;
            while rest % p == 0 {
                rest /= p;
                k += side;
            }
            if k != 0 {
                out.push((p, k));
            }
        }
        if rest >= TRIAL * TRIAL {
            return None;
        }
        if rest > 1 {
            out.push((rest, side));
        }
    }
    Some(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_products_of_their_primes() {
        let of = |n: i64, d: i64| primes(&Rational::from_signeds(n, d));
        assert_eq!(of(12, 7), Some(vec![(2, 2), (3, 1), (7, -1)]));
        assert_eq!(of(1, 1), Some(Vec::new()));
        assert_eq!(of(-2, 1), None);
    }

    fn number(p: i64, q: i64) -> Closed {
        Closed::rational(&Rational::from_signeds(p, q))
    }

    fn root(a: &Closed, k: i64) -> Closed {
        a.power(&Rational::from_signeds(1, k)).expect("a root")
    }

    #[test]
    fn equal_numbers_have_one_form() {
        let (two, three, six) = (number(2, 1), number(3, 1), number(6, 1));
        assert_eq!(root(&two, 2).times(&root(&three, 2)), Some(root(&six, 2)));
        assert_eq!(root(&number(8, 9), 2), root(&two, 2).times(&number(2, 3)).expect("short"));
        assert_eq!(root(&number(5, 7), 3).power(&Rational::from(3)), Some(number(5, 7)));
        let log = number(4, 1).ln().expect("a logarithm");
        assert_eq!(log, two.ln().expect("a logarithm").times(&two).expect("short"));
        assert_eq!(log.times(&number(1, 2)).expect("short").exp(), Some(two.clone()));
        let e = number(1, 1).exp().expect("e");
        assert_eq!(e.power(&Rational::from_signeds(2, 3)).expect("a power").ln(), Some(number(2, 3)));
        let sum = number(1, 1).plus(&root(&two, 2)).expect("short");
        assert_eq!(root(&sum, 2).power(&Rational::from(2)), Some(sum.clone()));
        assert_eq!(sum.power(&Rational::from(-1)).and_then(|inverse| inverse.power(&Rational::from(-1))), Some(sum));
    }

    #[test]
    fn multiples_of_pi_are_told_apart() {
        let turns = |p: i64, q: i64| Closed::pi().times(&number(p, q)).expect("short");
        assert_eq!(turns(-1, 3).turns(), Some(Rational::from_signeds(-1, 3)));
        assert_eq!(number(0, 1).turns(), Some(Rational::ZERO));
        assert_eq!(turns(1, 3).plus(&number(2, 1)).and_then(|sum| sum.turns()), None);
        assert_eq!(turns(1, 3).times(&turns(1, 3)).and_then(|square| square.turns()), None);
        assert_eq!(root(&Closed::pi(), 2).power(&Rational::from(2)), Some(Closed::pi()));
        assert_eq!(root(&Closed::pi(), 2).ln(), Closed::pi().ln().and_then(|log| log.times(&number(1, 2))));
        assert_ne!(turns(1, 3), turns(1, 2));
    }

    #[test]
    fn forms_are_written_as_a_reader_writes_them() {
        let turns = |p: i64, q: i64| Closed::pi().times(&number(p, q)).expect("short");
        let said = |form: &Closed| form.written().map(|e| crate::claim::print::expr(&e));
        let said_of = |a: Closed, b: Closed| said(&a.plus(&b).expect("short")).expect("written");
        let none = || number(0, 1);
        assert_eq!(said_of(turns(1, 1), none()), "pi");
        assert_eq!(said_of(turns(-1, 2), none()), "-pi/2");
        assert_eq!(said_of(turns(2, 3), none()), "2*pi/3");
        assert_eq!(said_of(turns(-1, 1), number(1, 2)), "1/2 - pi");
        assert_eq!(said_of(turns(-1, 1), number(-1, 2)), "-(1/2 + pi)");
        let half_root = root(&number(6, 1), 2).times(&number(-1, 2)).expect("short");
        assert_eq!(said_of(half_root, number(-1, 2).plus(&turns(1, 1)).expect("short")), "pi - 1/2 - sqrt(6)/2");
        assert_eq!(said_of(root(&number(2, 1), 3), none()), "2^(1/3)");
        assert_eq!(said_of(number(-1, 2).exp().expect("e"), none()), "exp(-1/2)");
        assert_eq!(said_of(number(6, 1).ln().expect("ln"), none()), "ln(2) + ln(3)");
        assert_eq!(said_of(turns(1, 1).times(&turns(1, 1)).expect("short"), none()), "pi^2");
        // A sum has one form as a base: (e + 1/e)^-1 is e/(1 + e^2).
        let [e, rest] = [number(1, 1), number(-1, 1)].map(|k| k.exp().expect("e"));
        let base = e.plus(&rest).and_then(|sum| sum.power(&Rational::from(-1))).expect("short");
        let other = number(2, 1).exp().and_then(|square| square.plus(&number(1, 1))).expect("short");
        assert_eq!(Some(base), other.power(&Rational::from(-1)).and_then(|inverse| inverse.times(&e)));
    }

    #[test]
    fn other_numbers_have_other_forms() {
        assert_ne!(root(&number(2, 1), 2), root(&number(2, 1), 3));
        assert_ne!(number(2, 1).ln(), number(3, 1).ln());
        assert_eq!(number(-2, 1).power(&Rational::from_signeds(1, 3)), None);
        assert_eq!(number(-2, 1).ln(), None);
        // ln(√2 − 1) is negative, and the root of its square is not it.
        let small = root(&number(2, 1), 2).plus(&number(-1, 1)).expect("short");
        let square = small.ln().and_then(|log| log.times(&log));
        assert_eq!(square.and_then(|square| square.power(&Rational::from_signeds(1, 2))), None);
    }
}
