//! Quotients of polynomials, kept in factors.
//!
//! Contract: a [`Fraction`] is c·∏ pᵢ^kᵢ with polynomials that
//! are not constant, have leading coefficient 1 and, but for single atoms, no atom as a factor, and
//! whole exponents kᵢ ≠ 0; zero has no factors. Atoms are numbers that somebody else gives a meaning.
//! No common divisor is ever sought: two fractions are equal iff their difference, with the common
//! factors set aside and the rest multiplied out, has no terms.
//!
//! What is done and what is made is counted in [`Work`] where it happens, numbers by their length, so
//! that time and memory are bounded. What only copies, such as [`Fraction::power`], is counted by the
//! size of what it comes to, in `Checker::value`.

pub use super::poly::{Monomial, Poly};
use super::poly::{product, words};
use super::{Reason, Refusal, rejected};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use std::cell::Cell;
use std::collections::BTreeMap;
use std::rc::Rc;

/// The most work in the check of one certificate: about that many operations on short numbers, terms
/// written, and comparisons of names, signs and facts in searches.
pub const WORK_LIMIT: u64 = 20_000_000;
/// The most terms of a polynomial.
pub(crate) const TERMS_LIMIT: usize = 20_000;
/// The largest exponent of a factor or an atom.
pub(crate) const EXPONENT_LIMIT: i64 = 1_000;
/// The most bits of a numerator or denominator.
pub(crate) const BITS_LIMIT: u64 = 100_000;

/// How much work is done between two looks at whether it may go on.
const BETWEEN_LOOKS: u64 = 1_000;

/// Whether work may go on: for a search, whose time is limited. A certificate is checked without one.
#[derive(Clone)]
pub struct Watch(pub Rc<dyn Fn() -> bool>);

impl std::fmt::Debug for Watch {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Watch")
    }
}

/// Counts work. Cells, so that what only reads the state of a check counts as well.
#[derive(Clone, Debug, Default)]
pub struct Work {
    done: Cell<u64>,
    /// Asked from time to time.
    watch: Option<Watch>,
    /// The work after which it is asked again.
    next_look: Cell<u64>,
}

impl Work {
    /// Has somebody asked from time to time whether work may go on, or nobody.
    pub fn watched_by(&mut self, watch: Option<Watch>) {
        self.watch = watch;
        self.next_look.set(0);
    }

    /// Counts some work; whether it was too much, the next [`Work::count`] says.
    pub fn spend(&self, amount: usize) {
        self.done.set(self.done.get().saturating_add(u64::try_from(amount).unwrap_or(u64::MAX)));
    }

    /// How much was counted.
    pub fn done(&self) -> u64 {
        self.done.get()
    }

    /// Counts some work.
    pub fn count(&self, amount: usize) -> Result<(), Refusal> {
        self.spend(amount);
        if self.done.get() > WORK_LIMIT {
            return Err(Refusal::Limit("work"));
        }
        match &self.watch {
            Some(watch) if self.done.get() >= self.next_look.get() => {
                self.next_look.set(self.done.get().saturating_add(BETWEEN_LOOKS));
                if watch.0() { Ok(()) } else { Err(Refusal::Limit("time")) }
            }
            _ => Ok(()),
        }
    }
}

/// Divides by a number as often as it can: how often that is. By its square first, so that 2^100000
/// takes some twenty divisions.
fn divided_out(rest: &mut BigInt, divisor: &BigInt) -> i64 {
    if !(&*rest % divisor).is_zero() {
        return 0;
    }
    let twice = divided_out(rest, &(divisor * divisor));
    if !(&*rest % divisor).is_zero() {
        return 2 * twice;
    }
    *rest /= divisor;
    2 * twice + 1
}

/// A quotient of polynomials in factors.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Fraction {
    /// The rational factor.
    pub coefficient: BigRational,
    /// The other factors with their exponents.
    pub factors: BTreeMap<Poly, i64>,
}

impl Fraction {
    /// A number.
    pub fn number(coefficient: BigRational) -> Fraction {
        Fraction { coefficient, factors: BTreeMap::new() }
    }

    /// A whole number.
    pub fn integer(k: i64) -> Fraction {
        Fraction::number(BigRational::from_integer(BigInt::from(k)))
    }

    /// An atom.
    pub fn atom(atom: usize) -> Fraction {
        Fraction { coefficient: BigRational::one(), factors: BTreeMap::from([(Poly::atom(atom), 1)]) }
    }

    /// A polynomial: its number, its atoms and what is left become factors.
    pub fn of(poly: &Poly) -> Fraction {
        let mut common: BTreeMap<usize, u32> = BTreeMap::new();
        for (place, (monomial, _)) in poly.terms().enumerate() {
            let powers: BTreeMap<usize, u32> = monomial.iter().copied().collect();
            if place == 0 {
                common = powers;
            } else {
                common.retain(|atom, k| {
                    *k = (*k).min(powers.get(atom).copied().unwrap_or(0));
                    *k > 0
                });
            }
        }
        // Different monomials stay different where what they share is taken from all; which of them is the last may change.
        let lower = |monomial: &Monomial| -> Monomial {
            let powers = monomial.iter().map(|(atom, k)| (*atom, k - common.get(atom).copied().unwrap_or(0)));
            powers.filter(|p| p.1 > 0).collect()
        };
        let rest = match common.is_empty() {
            true => poly.clone(),
            false => Poly::of_different(poly.terms().map(|(monomial, c)| (lower(monomial), c.clone()))),
        };
        let Some((_, lead)) = rest.terms().next_back() else { return Fraction::integer(0) };
        let mut out = Fraction::number(lead.clone());
        let rest = match lead.is_one() {
            true => rest,
            false => Poly::of_different(rest.terms().map(|(monomial, c)| (monomial.clone(), c / lead))),
        };
        for (atom, k) in common {
            out.factors.insert(Poly::atom(atom), i64::from(k));
        }
        if rest.atoms().next().is_some() {
            // Two terms and no atom in common: it is none of the factors so far.
            out.factors.insert(rest, 1);
        }
        out
    }

    /// Multiplies by a power of a factor. An exponent that reached a bound of its type would be another one, odd where
    /// it is even: it is held far below.
    fn put(&mut self, poly: &Poly, k: i64) -> Result<(), Refusal> {
        match self.factors.remove(poly).unwrap_or(0).checked_add(k) {
            Some(0) => Ok(()),
            Some(sum) if (-EXPONENT_LIMIT..=EXPONENT_LIMIT).contains(&sum) => {
                self.factors.insert(poly.clone(), sum);
                Ok(())
            }
            _ => Err(Refusal::Limit("degree")),
        }
    }

    /// Whether it is 0.
    pub fn is_zero(&self) -> bool {
        self.coefficient.is_zero()
    }

    /// The number, if it is one.
    pub fn as_number(&self) -> Option<&BigRational> {
        if self.factors.is_empty() { Some(&self.coefficient) } else { None }
    }

    /// The whole number of moderate size, if it is one.
    pub fn as_integer(&self) -> Option<i64> {
        let number = self.as_number()?;
        if number.is_integer() { i64::try_from(number.numer()).ok() } else { None }
    }

    /// Every atom that occurs.
    pub fn atoms(&self) -> impl Iterator<Item = usize> {
        self.factors.keys().flat_map(Poly::atoms)
    }

    /// How much it holds: words of its number, and the sizes of its factors.
    pub fn size(&self) -> usize {
        1 + words(&self.coefficient) + self.factors.keys().map(Poly::size).sum::<usize>()
    }

    /// Multiplies it in place.
    pub fn multiply(&mut self, other: &Fraction, work: &Work) -> Result<(), Refusal> {
        work.count(other.size())?;
        if self.is_zero() || other.is_zero() {
            *self = Fraction::integer(0);
            return Ok(());
        }
        self.coefficient = product(&self.coefficient, &other.coefficient, work)?;
        for (poly, k) in &other.factors {
            self.put(poly, *k)?;
        }
        Ok(())
    }

    /// The product.
    pub fn times(&self, other: &Fraction, work: &Work) -> Result<Fraction, Refusal> {
        work.count(self.size())?;
        let mut out = self.clone();
        out.multiply(other, work)?;
        Ok(out)
    }

    /// The whole power; 0 has positive powers only, and the power 0.
    pub fn power(&self, k: i64) -> Result<Fraction, Refusal> {
        if k == 0 {
            return Ok(Fraction::integer(1));
        }
        if self.is_zero() {
            return if k > 0 { Ok(Fraction::integer(0)) } else { rejected(Reason::DivisionByZero) };
        }
        let bits = self.coefficient.numer().bits().max(self.coefficient.denom().bits());
        let Ok(small) = i32::try_from(k) else { return Err(Refusal::Limit("degree")) };
        if bits.saturating_mul(k.unsigned_abs()) > BITS_LIMIT {
            return Err(Refusal::Limit("digits"));
        }
        let mut out = Fraction::number(self.coefficient.pow(small));
        for (poly, j) in &self.factors {
            match j.checked_mul(k) {
                Some(j) if j.abs() <= EXPONENT_LIMIT => out.factors.insert(poly.clone(), j),
                _ => return Err(Refusal::Limit("degree")),
            };
        }
        Ok(out)
    }

    /// The opposite.
    pub fn negated(&self) -> Fraction {
        Fraction { coefficient: -self.coefficient.clone(), factors: self.factors.clone() }
    }

    /// The sum: what all summands share is set aside, the rest multiplied out.
    pub fn sum(list: &[Fraction], work: &Work) -> Result<Fraction, Refusal> {
        let list: Vec<&Fraction> = list.iter().filter(|f| !f.is_zero()).collect();
        let Some(first) = list.first() else { return Ok(Fraction::integer(0)) };
        if list.len() == 1 {
            return Ok((*first).clone());
        }
        // Of each factor: in how many summands it stands, and its least exponent there; elsewhere it is 0.
        let mut least: BTreeMap<&Poly, (usize, i64)> = BTreeMap::new();
        for (poly, k) in list.iter().flat_map(|f| &f.factors) {
            let (count, least) = least.entry(poly).or_insert((0, *k));
            (*count, *least) = (*count + 1, (*k).min(*least));
        }
        let mut common = Fraction::integer(1);
        for (poly, (count, k)) in least {
            let k = if count < list.len() { k.min(0) } else { k };
            if k != 0 {
                common.factors.insert(poly.clone(), k);
            }
        }
        let inverse = common.power(-1)?;
        let rests = list.iter().map(|f| f.times(&inverse, work)?.expanded(work)).collect::<Result<Vec<_>, _>>()?;
        Fraction::of(&Poly::sum(&rests, work)?).times(&common, work)
    }

    /// The difference.
    pub fn minus(&self, other: &Fraction, work: &Work) -> Result<Fraction, Refusal> {
        Fraction::sum(&[self.clone(), other.negated()], work)
    }

    /// The polynomial; a fraction with denominators is none.
    pub fn expanded(&self, work: &Work) -> Result<Poly, Refusal> {
        // The atoms make one monomial; what has several terms is multiplied out.
        let mut monomial = Monomial::new();
        let mut others = Vec::new();
        for (poly, k) in &self.factors {
            if *k < 0 || *k > EXPONENT_LIMIT {
                return rejected(Reason::NotAPolynomial);
            }
            match (poly.single_atom(), u32::try_from(*k)) {
                (Some(atom), Ok(k)) if k > 0 => monomial.push((atom, k)),
                _ => others.push((poly, *k)),
            }
        }
        work.count(monomial.len())?;
        let mut out = Poly::term(monomial, self.coefficient.clone());
        for (poly, k) in others {
            for _ in 0..k {
                out = out.times(poly, work)?;
            }
        }
        Ok(out)
    }

    /// Numerator and denominator, multiplied out.
    pub fn parts(&self, work: &Work) -> Result<(Poly, Poly), Refusal> {
        let mut top = Fraction::number(self.coefficient.clone());
        let mut bottom = Fraction::integer(1);
        for (poly, k) in &self.factors {
            let (side, k) = if *k > 0 { (&mut top, *k) } else { (&mut bottom, k.saturating_neg()) };
            side.factors.insert(poly.clone(), k);
        }
        Ok((top.expanded(work)?, bottom.expanded(work)?))
    }

    /// The number's logarithm as whole multiples of those of primes: (prime, multiplicity). What has no
    /// small prime factor is kept whole: any splitting into factors is right.
    pub fn prime_powers(&self, work: &Work) -> Result<Vec<(BigInt, i64)>, Refusal> {
        let mut out = Vec::new();
        for (number, sign) in [(self.coefficient.numer(), 1), (self.coefficient.denom(), -1)] {
            let mut rest = number.abs();
            for prime in 2u32..1000 {
                if rest.is_one() || rest.is_zero() {
                    break;
                }
                work.count(1 + words(&self.coefficient))?;
                let prime = BigInt::from(prime);
                match divided_out(&mut rest, &prime) {
                    0 => {}
                    k => out.push((prime, sign * k)),
                }
            }
            if !rest.is_one() && !rest.is_zero() {
                out.push((rest, sign));
            }
        }
        Ok(out)
    }
}
