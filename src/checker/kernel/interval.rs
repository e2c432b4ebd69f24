//! Between which numbers a polynomial lies, from bounds that a step knows of its atoms.
//!
//! Contract: at every point that the facts allow, where the atoms of a polynomial have values, its value lies in the interval
//! that [`Checker::interval_of`] returns. Ends are p + q·π with rational p and q; an open end is not reached.

use super::enclosure::EXACT_BITS;
use super::fraction::Poly;
use super::known::{Known, Sign};
use super::order::Signs;
use super::poly::Monomial;
use super::sign::Found;
use super::term::Atom;
use super::{Checker, Refusal};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};

/// How many terms a polynomial may have that bounds its atoms.
const BOUND_TERMS: usize = 4;
/// How many terms a polynomial may have that is sought between the bounds of its atoms.
const ASKED_TERMS: usize = 8;
/// The most bits of a number in a polynomial that bounds atoms, or is sought between bounds.
const BOUND_BITS: u64 = 256;
/// How many bounds may rest on one another: x < y, y < z, z < 1.
const CHAIN: usize = 4;
/// Decimals that bound π: PI_DIGITS < π·10^20 < PI_DIGITS + 1.
const PI_DIGITS: u128 = 314_159_265_358_979_323_846;

/// An end of an interval: number + turns·π.
#[derive(Clone, Debug)]
struct End {
    number: BigRational,
    turns: BigRational,
    open: bool,
    /// The places among what is known of the signs that it rests on.
    from: BTreeSet<usize>,
}

/// The numbers at or between two ends; where there is none, all beyond as well.
#[derive(Clone, Debug, Default)]
pub(super) struct Interval {
    low: Option<End>,
    high: Option<End>,
}

/// The intervals of atoms that were found, by how many bounds might rest on one another.
pub(super) type Intervals = BTreeMap<(usize, usize), Interval>;

fn pi_decimal(up: bool) -> BigRational {
    let scale = BigInt::from(10).pow(20);
    BigRational::new(BigInt::from(PI_DIGITS + u128::from(up)), scale)
}

impl End {
    fn at(number: BigRational, open: bool) -> End {
        End { number, turns: BigRational::zero(), open, from: BTreeSet::new() }
    }

    /// A multiple of π.
    fn turns(numerator: i64, denominator: i64, open: bool) -> End {
        let turns = BigRational::new(numerator.into(), denominator.into());
        End { number: BigRational::zero(), turns, open, from: BTreeSet::new() }
    }

    /// Its order to 0, if decimals of π show it.
    fn sign(&self) -> Option<Ordering> {
        let zero = BigRational::zero();
        if self.turns.is_zero() {
            return Some(self.number.cmp(&zero));
        }
        let low = (&self.number + &self.turns * pi_decimal(false)).cmp(&zero);
        let high = (&self.number + &self.turns * pi_decimal(true)).cmp(&zero);
        (low == high).then_some(low)
    }

    fn scaled(&self, c: &BigRational) -> End {
        // Most ends are 0, and most factors 1 or -1: no common divisor is sought there.
        let times = |q: &BigRational| match () {
            () if q.is_zero() || c.is_one() => q.clone(),
            () if c.denom().is_one() && c.numer().magnitude().is_one() => -q,
            () => q * c,
        };
        End { number: times(&self.number), turns: times(&self.turns), open: self.open, from: self.from.clone() }
    }

    fn plus(&self, other: &End) -> End {
        let plus = |a: &BigRational, b: &BigRational| if a.is_zero() { b.clone() } else { a + b };
        End {
            number: plus(&self.number, &other.number),
            turns: plus(&self.turns, &other.turns),
            open: self.open || other.open,
            from: self.from.union(&other.from).copied().collect(),
        }
    }

    /// Its order to another, if it is shown.
    fn order(&self, other: &End) -> Option<Ordering> {
        self.plus(&other.scaled(&-BigRational::one())).sign()
    }

    /// A rational number beyond it, which is never reached.
    fn rational(&self, up: bool) -> End {
        if self.turns.is_zero() {
            return self.clone();
        }
        let pi = pi_decimal(up != self.turns.is_negative());
        End { number: &self.number + &self.turns * pi, turns: BigRational::zero(), open: true, from: self.from.clone() }
    }

    /// The product of two rational ends, unless it is too long. It is reached where both are, or one that is 0.
    fn times(&self, other: &End) -> Option<End> {
        let is_reached_zero = |e: &End| !e.open && e.number.is_zero();
        let open = (self.open || other.open) && !is_reached_zero(self) && !is_reached_zero(other);
        let number = &self.number * &other.number;
        let short = number.numer().bits().max(number.denom().bits()) <= EXACT_BITS;
        short.then(|| End::at(number, open))
    }

    /// The power of a rational end, unless it is too long.
    fn power(&self, k: u32) -> Option<End> {
        let bits = self.number.numer().bits().max(self.number.denom().bits());
        let short = bits.saturating_mul(u64::from(k)) <= EXACT_BITS;
        short.then(|| End::at(num_traits::pow(self.number.clone(), k as usize), self.open))
    }
}

/// The outer of two ends, upwards or downwards; where they are equal, the one that is reached.
fn outer(a: End, b: End, up: bool) -> Option<End> {
    match a.order(&b)? {
        Ordering::Equal => Some(if a.open { b } else { a }),
        order => Some(if (order == Ordering::Greater) == up { a } else { b }),
    }
}

impl Interval {
    fn around(low: BigRational, high: BigRational, open: bool) -> Interval {
        Interval { low: Some(End::at(low, open)), high: Some(End::at(high, open)) }
    }

    /// All that have these signs.
    fn of_signs(signs: Signs) -> Interval {
        let zero = |open| Some(End::at(BigRational::zero(), open));
        let low = signs.within(Signs::NOT_NEGATIVE).then(|| zero(signs.within(Signs::POSITIVE))).flatten();
        let negative = Signs::POSITIVE.turned();
        let high = signs.within(Signs::NOT_NEGATIVE.turned()).then(|| zero(signs.within(negative))).flatten();
        Interval { low, high }
    }

    /// The signs of its numbers, with the places that they rest on.
    fn signs(&self) -> (Signs, BTreeSet<usize>) {
        let (mut signs, mut from) = (Signs::ANY, BTreeSet::new());
        for (end, beyond) in [(&self.low, Signs::POSITIVE), (&self.high, Signs::POSITIVE.turned())] {
            let Some(end) = end else { continue };
            let Some(order) = end.sign() else { continue };
            let inwards = if beyond == Signs::POSITIVE { order } else { order.reverse() };
            let says = match inwards {
                Ordering::Greater => beyond,
                Ordering::Equal if end.open => beyond,
                Ordering::Equal => beyond.or(Signs::ZERO),
                Ordering::Less => continue,
            };
            signs = signs.and(says);
            from.extend(end.from.iter().copied());
        }
        (signs, from)
    }

    fn scaled(&self, c: &BigRational) -> Interval {
        let [low, high] = [&self.low, &self.high].map(|end| end.as_ref().map(|e| e.scaled(c)));
        if c.is_negative() { Interval { low: high, high: low } } else { Interval { low, high } }
    }

    fn negated(&self) -> Interval {
        self.scaled(&-BigRational::one())
    }

    fn plus(&self, other: &Interval) -> Interval {
        let sum = |a: &Option<End>, b: &Option<End>| Some(a.as_ref()?.plus(b.as_ref()?));
        Interval { low: sum(&self.low, &other.low), high: sum(&self.high, &other.high) }
    }

    /// A bound more: the inner of two ends.
    fn narrow(&mut self, end: End, up: bool) {
        let side = if up { &mut self.high } else { &mut self.low };
        let is_inner = |old: &End| match end.order(old) {
            Some(Ordering::Equal) => end.open && !old.open,
            Some(order) => (order == Ordering::Less) == up,
            None => false,
        };
        if side.as_ref().is_none_or(is_inner) {
            *side = Some(end);
        }
    }

    /// With rational ends further out.
    fn rational(&self) -> Interval {
        Interval {
            low: self.low.as_ref().map(|e| e.rational(false)),
            high: self.high.as_ref().map(|e| e.rational(true)),
        }
    }

    fn is_not_negative(&self) -> bool {
        self.low.as_ref().is_some_and(|e| e.sign().is_some_and(Ordering::is_ge))
    }

    fn is_not_positive(&self) -> bool {
        self.high.as_ref().is_some_and(|e| e.sign().is_some_and(Ordering::is_le))
    }

    /// The places that its ends rest on.
    fn places(&self) -> BTreeSet<usize> {
        [&self.low, &self.high].into_iter().flatten().flat_map(|end| end.from.iter().copied()).collect()
    }

    /// The same, where each end rests on all these places.
    fn resting_on(mut self, places: &BTreeSet<usize>) -> Interval {
        for end in [&mut self.low, &mut self.high].into_iter().flatten() {
            end.from.clone_from(places);
        }
        self
    }

    /// The product of two intervals with rational ends. Each end rests on all of theirs, for all were looked at.
    fn times(&self, other: &Interval) -> Interval {
        let places = self.places().union(&other.places()).copied().collect();
        self.product(other).resting_on(&places)
    }

    /// The product: what is bilinear on a rectangle is least and greatest at corners.
    fn product(&self, other: &Interval) -> Interval {
        if let ([Some(a), Some(b)], [Some(c), Some(d)]) = ([&self.low, &self.high], [&other.low, &other.high]) {
            let corners = || [(a, c), (a, d), (b, c), (b, d)].into_iter().map(|(x, y)| x.times(y));
            let extreme = |up| corners().reduce(|x, y| outer(x?, y?, up)).flatten();
            return Interval { low: extreme(false), high: extreme(true) };
        }
        let corner = |a: &Option<End>, b: &Option<End>| a.as_ref()?.times(b.as_ref()?);
        match [self, other].map(|i| (i.is_not_negative(), i.is_not_positive())) {
            [(true, _), (true, _)] => {
                Interval { low: corner(&self.low, &other.low), high: corner(&self.high, &other.high) }
            }
            [(false, true), _] => self.negated().product(other).negated(),
            [(true, _), (false, true)] => self.product(&other.negated()).negated(),
            _ => Interval::default(),
        }
    }

    /// The power of an interval with rational ends.
    fn power(&self, k: u32) -> Interval {
        let raised = |end: &Option<End>| end.as_ref()?.power(k);
        let [low, high] = [&self.low, &self.high].map(raised);
        // An odd power rises; an even one does where no number is negative, and falls where none is positive.
        let power = match () {
            () if k == 1 => return self.clone(),
            () if k % 2 == 1 || self.is_not_negative() => Interval { low, high },
            () if self.is_not_positive() => Interval { low: high, high: low },
            () => {
                let high = if let (Some(a), Some(b)) = (low, high) { outer(a, b, true) } else { None };
                Interval { low: Some(End::at(BigRational::zero(), false)), high }
            }
        };
        power.resting_on(&self.places())
    }
}

/// Whether a polynomial has at most so many terms, and short numbers.
fn is_short(poly: &Poly, terms: usize) -> bool {
    poly.terms().count() <= terms && poly.terms().all(|(_, c)| c.numer().bits().max(c.denom().bits()) <= BOUND_BITS)
}

/// The atoms that a polynomial is linear in, outside of all its other terms, if it may bound them.
pub(super) fn bounded_atoms(poly: &Poly) -> Vec<usize> {
    if poly.terms().nth(1).is_none() || !is_short(poly, BOUND_TERMS) {
        return Vec::new();
    }
    let alone = |m: &Monomial| if let [(atom, 1)] = m.as_slice() { Some(*atom) } else { None };
    let times = |atom: usize| poly.terms().filter(|t| t.0.iter().any(|(a, _)| *a == atom)).count();
    poly.terms().filter_map(|t| alone(t.0)).filter(|atom| times(*atom) == 1).collect()
}

impl Checker {
    /// These signs, and where they are more than one, those that the polynomial may have between the bounds of its atoms. It is
    /// asked only about polynomials in one atom, about sines, cosines, arcs and π, and in their arguments: the theorems in Coq have no
    /// intervals yet.
    pub(super) fn narrowed(&self, signs: Signs, poly: &Poly, known: &Known, found: &Found) -> Result<Signs, Refusal> {
        let turns = |atom: usize| {
            use Atom::*;
            matches!(self.atoms.get(atom), Some(Cosine(_) | Sine(_) | Arcsine(_) | Arctangent(_) | Pi))
        };
        let of_one = || poly.terms().nth(1).is_some() && poly.atoms().collect::<BTreeSet<_>>().len() == 1;
        let is_asked = || found.arguments > 0 || of_one() || poly.atoms().any(turns);
        if signs.is_single() || found.without_bounds || !is_short(poly, ASKED_TERMS) || !is_asked() {
            return Ok(signs);
        }
        let (inside, from) = self.interval_of(poly.terms(), known, CHAIN, found)?.signs();
        // What says nothing new is not asked for.
        if !signs.within(inside) {
            for sign in from.into_iter().filter_map(|place| known.signs.get(place)) {
                known.asked.borrow_mut().extend(sign.from.iter().copied());
                known.put_in.borrow_mut().extend(sign.put_in.iter().copied());
            }
        }
        Ok(signs.and(inside))
    }

    /// Where a sum of terms lies.
    fn interval_of<'a>(
        &self,
        terms: impl Iterator<Item = (&'a Monomial, &'a BigRational)>,
        known: &Known,
        chain: usize,
        found: &Found,
    ) -> Result<Interval, Refusal> {
        let mut sum = Interval::around(BigRational::zero(), BigRational::zero(), false);
        for (monomial, c) in terms {
            self.work.count(1 + monomial.len())?;
            let mut term: Option<Interval> = None;
            let single = matches!(monomial.as_slice(), [(_, 1)]);
            for (atom, k) in monomial {
                let of_atom = self.atom_interval(*atom, known, chain, found)?;
                // What is no product keeps its multiples of π.
                let factor = if single { of_atom } else { of_atom.rational().power(*k) };
                term = Some(term.map_or_else(|| factor.clone(), |term| term.times(&factor)));
            }
            let one = || Interval::around(BigRational::one(), BigRational::one(), false);
            let term = term.unwrap_or_else(one);
            sum = sum.plus(&term.scaled(c));
            if sum.low.is_none() && sum.high.is_none() {
                break;
            }
        }
        Ok(sum)
    }

    /// Where an atom lies: by its form, and by each known sign of c·x + r, which bounds x by the interval of r.
    fn atom_interval(&self, atom: usize, known: &Known, chain: usize, found: &Found) -> Result<Interval, Refusal> {
        if found.ranges.iter().any(|r| r.index == atom) {
            // It stands for a number of a range, of which only this is known, and only in what is asked for.
            let signs = found.signs.get(&atom).filter(|_| chain == CHAIN);
            return Ok(signs.map_or_else(Interval::default, |signs| Interval::of_signs(*signs)));
        }
        if let Some(interval) = known.intervals.borrow().get(&(atom, chain)) {
            return Ok(interval.clone());
        }
        let one = BigRational::one;
        let mut out = match self.atoms.get(atom) {
            Some(Atom::Cosine(_) | Atom::Sine(_)) => Interval::around(-one(), one(), false),
            Some(Atom::Pi) => {
                return Ok(Interval { low: Some(End::turns(1, 1, false)), high: Some(End::turns(1, 1, false)) });
            }
            Some(arc @ (Atom::Arcsine(_) | Atom::Arctangent(_))) => {
                let open = matches!(arc, Atom::Arctangent(_));
                Interval { low: Some(End::turns(-1, 2, open)), high: Some(End::turns(1, 2, open)) }
            }
            Some(Atom::Exponential(_)) => Interval::of_signs(Signs::POSITIVE),
            _ if self.is_natural_atom(atom) => Interval::of_signs(Signs::NOT_NEGATIVE),
            _ => Interval::default(),
        };
        let Some(rest) = chain.checked_sub(1) else { return Ok(out) };
        let of_atom = Poly::atom(atom);
        let places = known.bounds.get(&atom).into_iter().chain(known.places.get(&of_atom)).flatten();
        for place in places.copied() {
            // An equation is put in, it bounds nothing.
            let is_equation = |sign: &Sign| sign.signs == Signs::ZERO && sign.poly.terms().nth(1).is_some();
            let Some(sign) = known.signs.get(place).filter(|sign| !is_equation(sign)) else { continue };
            let is_atom = |m: &Monomial| matches!(m.as_slice(), [(a, 1)] if *a == atom);
            let Some((_, factor)) = sign.poly.terms().find(|t| is_atom(t.0)) else { continue };
            let r = self.interval_of(sign.poly.terms().filter(|t| !is_atom(t.0)), known, rest, found)?;
            // x = (s − r)/c, where the signs of s are known.
            let x = Interval::of_signs(sign.signs).plus(&r.negated()).scaled(&factor.recip());
            for (end, up) in [(x.low, false), (x.high, true)] {
                if let Some(mut end) = end {
                    end.from.insert(place);
                    out.narrow(end, up);
                }
            }
        }
        known.intervals.borrow_mut().insert((atom, chain), out.clone());
        Ok(out)
    }
}

#[cfg(test)]
mod tests {
    use super::super::enclosure::Enclosure;
    use super::super::fraction::Work;
    use super::{Signs, pi_decimal};

    #[test]
    fn pi_lies_outside_of_its_decimals() -> Result<(), super::Refusal> {
        let work = Work::default();
        for (up, beyond) in [(false, Signs::POSITIVE), (true, Signs::POSITIVE.turned())] {
            let difference = Enclosure::pi(&work)?.minus(&Enclosure::exact(pi_decimal(up)), &work)?;
            assert_eq!(difference.signs(), beyond);
        }
        Ok(())
    }
}
