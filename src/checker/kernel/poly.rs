//! Sparse polynomials over the rationals.
//!
//! Contract: a [`Poly`] holds no zero coefficient, and each monomial once, in increasing order. Atoms are numbers that
//! somebody else gives a meaning.
//!
//! Products of polynomials with few atoms and short coefficients are made in machine words ([`packed_product`]): a monomial is one
//! word with a field for each atom, a coefficient a whole number over one denominator. Every step of that is checked for
//! overflow, and what does not fit is multiplied term by term in numbers of any length.

use super::Refusal;
use super::fraction::{BITS_LIMIT, EXPONENT_LIMIT, TERMS_LIMIT, Work};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, ToPrimitive, Zero};
use std::collections::BTreeMap;
use std::sync::Arc;

/// The length of a number, in 64 bits.
pub(super) fn words(q: &BigRational) -> usize {
    usize::try_from(q.numer().bits().max(q.denom().bits()) / 64).unwrap_or(usize::MAX)
}

/// The product; between integers no common divisor is sought.
pub(super) fn product(a: &BigRational, b: &BigRational, work: &Work) -> Result<BigRational, Refusal> {
    let whole = a.is_integer() && b.is_integer();
    computed(if whole { BigRational::from_integer(a.numer() * b.numer()) } else { a * b }, work)
}

/// The sum; between integers no common divisor is sought.
fn plus(a: &BigRational, b: &BigRational, work: &Work) -> Result<BigRational, Refusal> {
    let whole = a.is_integer() && b.is_integer();
    computed(if whole { BigRational::from_integer(a.numer() + b.numer()) } else { a + b }, work)
}

/// A number that was computed: its length is limited, and four times its square counted, for common
/// divisors of long numbers take about so long.
fn computed(q: BigRational, work: &Work) -> Result<BigRational, Refusal> {
    work.count(words(&q).saturating_pow(2).saturating_mul(4))?;
    if q.numer().bits().max(q.denom().bits()) > BITS_LIMIT { Err(Refusal::Limit("digits")) } else { Ok(q) }
}

/// Atoms with positive exponents, in increasing order of the atoms.
pub type Monomial = Vec<(usize, u32)>;

/// The product of two monomials, atoms in increasing order.
fn monomial_product(m: &Monomial, n: &Monomial) -> Result<Monomial, Refusal> {
    let mut out = Monomial::with_capacity(m.len() + n.len());
    let (mut left, mut right) = (m.iter().copied().peekable(), n.iter().copied().peekable());
    loop {
        let power = match (left.peek().copied(), right.peek().copied()) {
            (None, None) => return Ok(out),
            (Some((a, _)), Some((b, _))) if a < b => left.next(),
            (Some(_), None) => left.next(),
            (Some((a, j)), Some((b, k))) if a == b => {
                left.next();
                right.next();
                Some((a, j.saturating_add(k)))
            }
            _ => right.next(),
        };
        let Some((atom, k)) = power else { return Ok(out) };
        if i64::from(k) > EXPONENT_LIMIT {
            return Err(Refusal::Limit("degree"));
        }
        out.push((atom, k));
    }
}

/// A polynomial. Copies share their terms.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Default)]
pub struct Poly(Arc<Vec<(Monomial, BigRational)>>);

impl Poly {
    /// A constant.
    pub fn constant(c: BigRational) -> Poly {
        Poly(Arc::new(if c.is_zero() { Vec::new() } else { vec![(Vec::new(), c)] }))
    }

    /// An atom.
    pub fn atom(atom: usize) -> Poly {
        Poly(Arc::new(vec![(vec![(atom, 1)], BigRational::one())]))
    }

    /// A number times powers of atoms, no atom twice.
    pub fn term(mut monomial: Monomial, c: BigRational) -> Poly {
        monomial.sort_unstable();
        Poly(Arc::new(if c.is_zero() { Vec::new() } else { vec![(monomial, c)] }))
    }

    /// The polynomial with these terms: no monomial twice, no coefficient 0.
    pub(super) fn of_different(terms: impl Iterator<Item = (Monomial, BigRational)>) -> Poly {
        let mut terms: Vec<(Monomial, BigRational)> = terms.collect();
        terms.sort_unstable_by(|a, b| a.0.cmp(&b.0));
        Poly(Arc::new(terms))
    }

    /// The terms, in increasing order of the monomials.
    pub fn terms(&self) -> impl DoubleEndedIterator<Item = (&Monomial, &BigRational)> {
        self.0.iter().map(|(monomial, c)| (monomial, c))
    }

    /// The atom, if the polynomial is a single one.
    pub fn single_atom(&self) -> Option<usize> {
        match self.0.as_slice() {
            [(monomial, c)] if c.is_one() => match monomial.as_slice() {
                [(atom, 1)] => Some(*atom),
                _ => None,
            },
            _ => None,
        }
    }

    /// Every atom that occurs.
    pub fn atoms(&self) -> impl Iterator<Item = usize> {
        self.0.iter().flat_map(|term| &term.0).map(|power| power.0)
    }

    /// How much it holds: terms, atoms in them, words of their numbers.
    pub fn size(&self) -> usize {
        self.0.iter().map(|(monomial, c)| 1 + monomial.len() + words(c)).sum()
    }

    /// The sum of terms in any order.
    fn collected(
        terms: impl Iterator<Item = Result<(Monomial, BigRational), Refusal>>,
        work: &Work,
    ) -> Result<Poly, Refusal> {
        let mut all: BTreeMap<Monomial, BigRational> = BTreeMap::new();
        for term in terms {
            let (monomial, c) = term?;
            match all.get_mut(&monomial) {
                Some(sum) => *sum = plus(sum, &c, work)?,
                None => drop(all.insert(monomial, c)),
            }
            if all.len() > TERMS_LIMIT {
                return Err(Refusal::Limit("terms"));
            }
        }
        Ok(Poly(Arc::new(all.into_iter().filter(|(_, c)| !c.is_zero()).collect())))
    }

    /// The sum.
    pub fn sum(list: &[Poly], work: &Work) -> Result<Poly, Refusal> {
        match list {
            [only] => Ok(only.clone()),
            _ => {
                work.count(list.iter().map(|p| p.0.len()).sum())?;
                Poly::collected(list.iter().flat_map(|p| p.0.iter()).map(|term| Ok(term.clone())), work)
            }
        }
    }

    /// The product.
    pub fn times(&self, other: &Poly, work: &Work) -> Result<Poly, Refusal> {
        let letters = |p: &Poly| p.0.iter().map(|t| t.0.len()).sum::<usize>();
        let (rows, columns) = (self.0.len(), other.0.len());
        // One for each pair of terms, and one for each atom in them.
        let pairs = rows.saturating_mul(columns).saturating_add(rows.saturating_mul(letters(other)));
        work.count(pairs.saturating_add(columns.saturating_mul(letters(self))))?;
        if (2..=PACKED_PAIRS).contains(&rows.saturating_mul(columns))
            && let Some(product) = packed_product(self, other)
        {
            return if product.0.len() > TERMS_LIMIT { Err(Refusal::Limit("terms")) } else { Ok(product) };
        }
        let pairs = self.0.iter().flat_map(|(m, c)| other.0.iter().map(move |(n, d)| (m, c, n, d)));
        Poly::collected(pairs.map(|(m, c, n, d)| Ok((monomial_product(m, n)?, product(c, d, work)?))), work)
    }

    /// The polynomial with another in the place of an atom that it holds; none if its degree in the atom is above a limit.
    pub(super) fn with(&self, atom: usize, value: &Poly, degree: u32, work: &Work) -> Result<Option<Poly>, Refusal> {
        let mut terms = Vec::new();
        for (monomial, c) in self.terms() {
            let k = monomial.iter().find(|p| p.0 == atom).map_or(0, |p| p.1);
            if k > degree {
                return Ok(None);
            }
            let others = monomial.iter().filter(|p| p.0 != atom).copied().collect();
            let mut term = Poly::term(others, c.clone());
            for _ in 0..k {
                term = term.times(value, work)?;
            }
            terms.push(term);
        }
        Poly::sum(&terms, work).map(Some)
    }

    /// The partial derivative.
    pub fn derivative(&self, atom: usize) -> Poly {
        let lowered = self.0.iter().filter_map(|(monomial, c)| {
            let (_, k) = monomial.iter().find(|p| p.0 == atom)?;
            let lower = monomial.iter().map(|p| if p.0 == atom { (p.0, p.1 - 1) } else { *p });
            Some((lower.filter(|p| p.1 > 0).collect(), c * BigRational::from_integer(BigInt::from(*k))))
        });
        // Different monomials stay different.
        Poly::of_different(lowered)
    }

    /// The coefficients by powers of a number, of which these atoms are the powers with these exponents.
    pub fn coefficients(&self, exponents: &BTreeMap<usize, BigRational>) -> BTreeMap<BigRational, Poly> {
        let mut out: BTreeMap<BigRational, BTreeMap<Monomial, BigRational>> = BTreeMap::new();
        for (monomial, c) in self.0.iter() {
            let own = |(atom, k): &(usize, u32)| exponents.get(atom).map(|e| e * BigInt::from(*k));
            let degree: BigRational = monomial.iter().filter_map(own).sum();
            let rest: Monomial = monomial.iter().copied().filter(|p| !exponents.contains_key(&p.0)).collect();
            *out.entry(degree).or_default().entry(rest).or_insert_with(BigRational::zero) += c;
        }
        let poly = |terms: BTreeMap<Monomial, BigRational>| {
            Poly(Arc::new(terms.into_iter().filter(|t| !t.1.is_zero()).collect()))
        };
        out.into_iter().map(|(k, terms)| (k, poly(terms))).filter(|(_, p)| !p.0.is_empty()).collect()
    }
}

/// Up to how many pairs of terms a product is made in machine words.
const PACKED_PAIRS: usize = 1 << 18;

/// Monomials as words: a field of some bits for the exponent of each atom.
struct Layout {
    /// The atoms of both factors, in increasing order.
    atoms: Vec<usize>,
    /// The bits of a field.
    width: u32,
}

impl Layout {
    /// A layout in which no exponent of the product of two polynomials reaches the next field; `None` where there are too
    /// many atoms or too great exponents for that.
    fn of(a: &Poly, b: &Poly) -> Option<Layout> {
        let mut atoms: Vec<usize> = a.atoms().chain(b.atoms()).collect();
        atoms.sort_unstable();
        atoms.dedup();
        let width = 128 / u32::try_from(atoms.len().max(2)).ok()?;
        let greatest = |p: &Poly| p.0.iter().flat_map(|t| &t.0).map(|p| i64::from(p.1)).max().unwrap_or(0);
        let sum = greatest(a) + greatest(b);
        let fits = width >= i64::BITS - sum.leading_zeros() && sum <= EXPONENT_LIMIT;
        fits.then_some(Layout { atoms, width })
    }

    /// The polynomial as Σ c·m / denominator.
    fn pack(&self, p: &Poly) -> Option<(i64, Vec<(u128, i64)>)> {
        let mut denominator = 1i64;
        for (_, c) in p.0.iter() {
            let d = c.denom().to_i64()?;
            let common = gcd(denominator.unsigned_abs().into(), d.unsigned_abs().into());
            denominator = (denominator / i64::try_from(common).ok()?).checked_mul(d)?;
        }
        let mut terms = Vec::with_capacity(p.0.len());
        for (monomial, c) in p.0.iter() {
            let mut word = 0u128;
            for (atom, k) in monomial {
                let place = u32::try_from(self.atoms.binary_search(atom).ok()?).ok()?;
                word |= u128::from(*k) << (place * self.width);
            }
            terms.push((word, c.numer().to_i64()?.checked_mul(denominator / c.denom().to_i64()?)?));
        }
        Some((denominator, terms))
    }

    fn unpack(&self, word: u128) -> Monomial {
        let mask = (1u128 << self.width) - 1;
        let fields = (0u32..).zip(&self.atoms).map(|(place, atom)| (*atom, word >> (place * self.width) & mask));
        fields.filter(|f| f.1 > 0).map(|(atom, k)| (atom, u32::try_from(k).unwrap_or(u32::MAX))).collect()
    }
}

/// The greatest common divisor of two numbers that are not both 0.
fn gcd(mut a: u128, mut b: u128) -> u128 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}

/// The product in machine words, if it fits.
fn packed_product(a: &Poly, b: &Poly) -> Option<Poly> {
    let layout = Layout::of(a, b)?;
    let ((d, left), (e, right)) = (layout.pack(a)?, layout.pack(b)?);
    let denominator = i128::from(d) * i128::from(e);
    let mut pairs: Vec<(u128, i128)> = Vec::with_capacity(left.len() * right.len());
    for (m, c) in &left {
        // No field overflows, so the sum of two words is the word of the product.
        pairs.extend(right.iter().map(|(n, f)| (m + n, i128::from(*c) * i128::from(*f))));
    }
    pairs.sort_unstable_by_key(|pair| pair.0);
    let mut terms: Vec<(u128, i128)> = Vec::with_capacity(pairs.len());
    for (word, c) in pairs {
        match terms.last_mut() {
            Some((last, sum)) if *last == word => *sum = sum.checked_add(c)?,
            _ => terms.push((word, c)),
        }
    }
    let mut kept = Vec::with_capacity(terms.len());
    for (word, c) in terms.into_iter().filter(|t| t.1 != 0) {
        let common = i128::try_from(gcd(c.unsigned_abs(), denominator.unsigned_abs())).ok()?;
        let c = BigRational::new_raw(BigInt::from(c / common), BigInt::from(denominator / common));
        kept.push((layout.unpack(word), c));
    }
    Some(Poly::of_different(kept.into_iter()))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // a test stops where it fails
mod tests {
    use super::*;

    /// The product, term by term.
    fn plain(a: &Poly, b: &Poly) -> Poly {
        let work = Work::default();
        let pairs = a.0.iter().flat_map(|(m, c)| b.0.iter().map(move |(n, d)| (monomial_product(m, n), c * d)));
        Poly::collected(pairs.map(|(m, c)| Ok((m?, c))), &work).unwrap()
    }

    /// Whole numbers that look random.
    fn next(state: &mut u64) -> u64 {
        *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        *state >> 33
    }

    fn random(state: &mut u64, atoms: u64, exponents: u64, size: u32) -> Poly {
        let work = Work::default();
        let terms = (0..1 + next(state) % 7).map(|_| {
            let monomial: BTreeMap<usize, u32> = (0..next(state) % 4)
                .map(|_| ((next(state) % atoms) as usize * 3, 1 + (next(state) % exponents) as u32))
                .collect();
            let sign = if next(state).is_multiple_of(2) { 1 } else { -1 };
            let number = |state: &mut u64| BigInt::from(1 + next(state) % 9).pow(1 + (next(state) as u32) % size);
            let c = BigRational::new(number(state) * sign, number(state));
            Ok((monomial.into_iter().collect(), c))
        });
        Poly::collected(terms.collect::<Vec<_>>().into_iter(), &work).unwrap()
    }

    #[test]
    fn a_product_in_machine_words_is_the_product_term_by_term() {
        let mut state = 7;
        let (mut packed, mut long) = (0, 0);
        for _ in 0..4_000 {
            let (atoms, exponents) = (1 + next(&mut state) % 20, 1 + next(&mut state) % 500);
            let size = 1 + (next(&mut state) as u32) % 30;
            let (a, b) = (random(&mut state, atoms, exponents, size), random(&mut state, atoms, exponents, size));
            match packed_product(&a, &b) {
                Some(product) => {
                    assert_eq!(product, plain(&a, &b), "{a:?} times {b:?}");
                    packed += 1;
                }
                None => long += 1,
            }
        }
        assert!(packed > 500 && long > 500, "{packed} packed, {long} long");
    }

    #[test]
    fn numbers_and_exponents_that_do_not_fit_are_not_packed() {
        let atom = |k: u32, c: BigInt| Poly(Arc::new(vec![(vec![(0, k)], BigRational::from_integer(c))]));
        let x = atom(1, BigInt::one());
        assert!(packed_product(&x, &atom(1, BigInt::from(i64::MAX) + 1)).is_none());
        assert!(packed_product(&x, &atom(1, BigInt::from(i64::MIN))).is_some());
        assert!(packed_product(&x, &atom(u32::try_from(EXPONENT_LIMIT).unwrap(), BigInt::one())).is_none());
        // 2^62·x + 2^62·x … of many pairs adds up beyond 128 bits only after fallback.
        let many =
            Poly::of_different((0..40).map(|k| (vec![(0, k + 1)], BigRational::from_integer(BigInt::from(i64::MAX)))));
        assert!(packed_product(&many, &many).is_none());
        assert_eq!(many.times(&many, &Work::default()).unwrap(), plain(&many, &many));
    }
}
