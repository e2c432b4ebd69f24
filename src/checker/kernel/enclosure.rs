//! Numbers that are known exactly, or to lie between two rational numbers.
//!
//! Contract: the result of an operation encloses the result for all numbers that its arguments enclose. What is rational
//! by the four operations, by whole powers and by exact roots stays exact, until it is longer than [`EXACT_BITS`]; other ends
//! are rounded outwards to [`PRECISION`] bits.
//!
//! Roots are whole roots of whole numbers. exp is its series at q/2^k, squared k times; ln is that of artanh. cos and sin are their
//! series at what is left of full turns, and π is Machin's sum. What is left of a series is bounded by a geometric one, or by its
//! next term.
//!
//! Series are summed in whole numbers of units of 2^-[`PLACES`]; every quotient is cut towards 0, which loses less than a unit. The
//! comment at each series bounds what that comes to.

use super::fraction::{BITS_LIMIT, Work};
use super::order::Signs;
use super::{Reason, Refusal, rejected};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

/// Bits that are kept of an end that is rounded.
pub(crate) const PRECISION: u64 = 256;
/// The most bits of an exact number.
pub(crate) const EXACT_BITS: u64 = 10_000;
/// The largest exponent of a number other than 0, 1 and -1.
pub(crate) const POWER_LIMIT: u32 = 1_000_000;
/// Binary places of the terms of a series.
const PLACES: u64 = 400;
/// The highest root that is taken as one; higher ones are taken by ln and exp.
pub(crate) const ROOT_LIMIT: u32 = 64;

/// A number between two others, which may be equal.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Enclosure {
    low: BigRational,
    high: BigRational,
}

fn length(q: &BigRational) -> u64 {
    q.numer().bits().max(q.denom().bits())
}

/// 2^k.
fn two_to(k: i64) -> BigRational {
    let size = BigInt::one() << k.unsigned_abs();
    if k < 0 { BigRational::new(BigInt::one(), size) } else { BigRational::from_integer(size) }
}

/// A number in units of 2^-PLACES, cut towards 0.
fn in_units(q: &BigRational) -> BigInt {
    (q.numer() << PLACES) / q.denom()
}

/// The product of two numbers in units, cut towards 0.
fn product_in_units(a: &BigInt, b: &BigInt) -> BigInt {
    // A shift would cut downwards.
    a * b / (BigInt::one() << PLACES)
}

/// The number that is not above q, or not below it, with [`PRECISION`] bits over a power of two.
fn rounded(q: &BigRational, up: bool) -> BigRational {
    let bits = |n: &BigInt| i64::try_from(n.bits()).unwrap_or(i64::MAX);
    let shift = i64::try_from(PRECISION).unwrap_or(0) - (bits(q.numer()) - bits(q.denom()));
    let scaled = q * two_to(shift);
    (if up { scaled.ceil() } else { scaled.floor() }) * two_to(-shift)
}

impl Enclosure {
    /// This number.
    pub(crate) fn exact(q: BigRational) -> Enclosure {
        Enclosure { low: q.clone(), high: q }
    }

    fn integer(k: i64) -> Enclosure {
        Enclosure::exact(BigRational::from_integer(BigInt::from(k)))
    }

    /// The ends in order, rounded where they are long. What is long is counted by its square.
    fn between(low: BigRational, high: BigRational, work: &Work) -> Result<Enclosure, Refusal> {
        let long = length(&low).max(length(&high));
        let words = usize::try_from(long / 64).unwrap_or(usize::MAX).saturating_add(1);
        work.count(words.saturating_mul(words).saturating_mul(4))?;
        if long > BITS_LIMIT {
            return Err(Refusal::Limit("digits"));
        }
        let short = long <= if low == high { EXACT_BITS } else { 2 * PRECISION };
        Ok(if short {
            Enclosure { low, high }
        } else {
            Enclosure { low: rounded(&low, false), high: rounded(&high, true) }
        })
    }

    /// The number, if it is known exactly.
    pub(crate) fn number(&self) -> Option<&BigRational> {
        (self.low == self.high).then_some(&self.low)
    }

    /// The signs that it may have.
    pub(crate) fn signs(&self) -> Signs {
        let ends = Signs::of_number(&self.low).or(Signs::of_number(&self.high));
        if self.low.is_negative() && self.high.is_positive() { Signs::ANY } else { ends }
    }

    /// The opposite.
    pub(crate) fn negated(&self) -> Enclosure {
        Enclosure { low: -&self.high, high: -&self.low }
    }

    /// The sum.
    pub(crate) fn plus(&self, other: &Enclosure, work: &Work) -> Result<Enclosure, Refusal> {
        Enclosure::between(&self.low + &other.low, &self.high + &other.high, work)
    }

    /// The difference.
    pub(crate) fn minus(&self, other: &Enclosure, work: &Work) -> Result<Enclosure, Refusal> {
        self.plus(&other.negated(), work)
    }

    /// The product.
    pub(crate) fn times(&self, other: &Enclosure, work: &Work) -> Result<Enclosure, Refusal> {
        if let (Some(a), Some(b)) = (self.number(), other.number()) {
            let product = a * b;
            return Enclosure::between(product.clone(), product, work);
        }
        let ends =
            [(&self.low, &other.low), (&self.low, &other.high), (&self.high, &other.low), (&self.high, &other.high)];
        let products = ends.map(|(a, b)| a * b);
        let [first, rest @ ..] = &products;
        let low = rest.iter().fold(first, |a, b| a.min(b));
        let high = rest.iter().fold(first, |a, b| a.max(b));
        Enclosure::between(low.clone(), high.clone(), work)
    }

    /// The reciprocal of what is not 0.
    pub(crate) fn inverse(&self, work: &Work) -> Result<Enclosure, Refusal> {
        if !self.signs().within(Signs::NOT_ZERO) || self.low.is_negative() != self.high.is_negative() {
            return rejected(Reason::NotDecided);
        }
        Enclosure::between(self.high.recip(), self.low.recip(), work)
    }

    /// The k-th power; that to 0 is 1.
    pub(crate) fn power(&self, k: &BigInt, work: &Work) -> Result<Enclosure, Refusal> {
        if let Some(q) = self.number().filter(|q| q.is_integer() && q.numer().bits() <= 1) {
            // 0, 1 and -1, whatever the exponent.
            let kept = k.bit(0) || (q.is_zero() && !k.is_zero());
            return Ok(if kept { self.clone() } else { Enclosure::integer(1) });
        }
        let Some(k) = k.to_u32().filter(|k| *k <= POWER_LIMIT) else { return Err(Refusal::Limit("degree")) };
        let (low, high) = (power_of(&self.low, k, work)?, power_of(&self.high, k, work)?);
        if k % 2 == 1 || !self.low.is_negative() {
            return Enclosure::between(low.low, high.high, work);
        }
        let least = if self.high.is_positive() { BigRational::zero() } else { high.low };
        Enclosure::between(least, low.high.max(high.high), work)
    }

    /// The k-th root, k from 1 to [`ROOT_LIMIT`], of what is not negative.
    pub(crate) fn root(&self, k: u32, work: &Work) -> Result<Enclosure, Refusal> {
        if self.low.is_negative() || k == 0 || k > ROOT_LIMIT {
            return rejected(Reason::NotDecided);
        }
        let (low, high) = (root_of(&self.low, k, work)?, root_of(&self.high, k, work)?);
        Enclosure::between(low.low, high.high, work)
    }

    /// e to this power.
    pub(crate) fn exp(&self, work: &Work) -> Result<Enclosure, Refusal> {
        let low = exp_of(&self.low, work)?;
        let high = if self.number().is_some() { low.clone() } else { exp_of(&self.high, work)? };
        Enclosure::between(low.low, high.high, work)
    }

    /// The natural logarithm of what is positive.
    pub(crate) fn ln(&self, work: &Work) -> Result<Enclosure, Refusal> {
        if !self.low.is_positive() {
            return rejected(Reason::NotDecided);
        }
        let low = ln_of(&self.low, work)?;
        let high = if self.number().is_some() { low.clone() } else { ln_of(&self.high, work)? };
        Enclosure::between(low.low, high.high, work)
    }

    /// π = 16·arctan(1/5) − 4·arctan(1/239).
    pub(crate) fn pi(work: &Work) -> Result<Enclosure, Refusal> {
        let part = |times: i64, k: i64| arctan_of_inverse(k, work)?.times(&Enclosure::integer(times), work);
        part(16, 5)?.plus(&part(-4, 239)?, work)
    }

    /// π/2.
    pub(crate) fn quarter_turn(work: &Work) -> Result<Enclosure, Refusal> {
        Enclosure::pi(work)?.times(&Enclosure::exact(two_to(-1)), work)
    }

    /// The cosine and the sine. Both change by at most as much as their argument does.
    pub(crate) fn cosine_and_sine(&self, work: &Work) -> Result<(Enclosure, Enclosure), Refusal> {
        let (cosine, sine) = cosine_and_sine_of(&self.low, work)?;
        let width = &self.high - &self.low;
        let wider = |x: Enclosure| Enclosure::between(&x.low - &width, &x.high + &width, work);
        Ok((wider(cosine)?, wider(sine)?))
    }

    /// The number between −π/2 and π/2 with this tangent. It rises.
    pub(crate) fn arctan(&self, work: &Work) -> Result<Enclosure, Refusal> {
        let low = arctan_of(&self.low, work)?;
        let high = if self.number().is_some() { low.clone() } else { arctan_of(&self.high, work)? };
        Enclosure::between(low.low, high.high, work)
    }

    /// The number from −π/2 to π/2 with this sine, which lies between −1 and 1. It rises.
    pub(crate) fn arcsin(&self, work: &Work) -> Result<Enclosure, Refusal> {
        let low = arcsin_of(&self.low, work)?;
        let high = if self.number().is_some() { low.clone() } else { arcsin_of(&self.high, work)? };
        Enclosure::between(low.low, high.high, work)
    }

    /// All numbers that differ from one in units by 2^k units at most, and by as much more as an argument is wide on which the
    /// number depends with a slope from -1 to 1.
    fn around(units: BigInt, k: u64, width: &BigRational, work: &Work) -> Result<Enclosure, Refusal> {
        let unit = BigInt::one() << PLACES;
        let (middle, error) =
            (BigRational::new(units, unit.clone()), BigRational::new(BigInt::one() << k, unit) + width);
        Enclosure::between(&middle - &error, middle + error, work)
    }
}

/// q^k.
fn power_of(q: &BigRational, mut k: u32, work: &Work) -> Result<Enclosure, Refusal> {
    let (mut out, mut square) = (Enclosure::integer(1), Enclosure::exact(q.clone()));
    while k > 0 {
        if k % 2 == 1 {
            out = out.times(&square, work)?;
        }
        k /= 2;
        if k > 0 {
            square = square.times(&square, work)?;
        }
    }
    Ok(out)
}

/// The k-th root of q ≥ 0: exact where numerator and denominator are k-th powers, else r/2^s and (r + 1)/2^s, r being
/// the whole root of the whole part of q·2^(s·k).
fn root_of(q: &BigRational, k: u32, work: &Work) -> Result<Enclosure, Refusal> {
    let (top, bottom) = (q.numer().nth_root(k), q.denom().nth_root(k));
    if top.pow(k) == *q.numer() && bottom.pow(k) == *q.denom() {
        return Ok(Enclosure::exact(BigRational::new(top, bottom)));
    }
    let spare = q.denom().bits().saturating_sub(q.numer().bits()) / u64::from(k);
    let bits = PRECISION.saturating_add(spare).saturating_add(1);
    let long = bits.saturating_mul(u64::from(k));
    if long > BITS_LIMIT {
        return Err(Refusal::Limit("digits"));
    }
    let words = usize::try_from(long / 64).unwrap_or(usize::MAX);
    work.count(words.saturating_mul(words).saturating_mul(8))?;
    let root = (q * BigRational::from_integer(BigInt::one() << long)).to_integer().nth_root(k);
    let below = BigInt::one() << bits;
    let low = BigRational::new(root.clone(), below.clone());
    Enclosure::between(low, BigRational::new(root + 1, below), work)
}

/// Counts the work of a series of so many terms, each a product and a quotient.
fn count_series(terms: usize, work: &Work) -> Result<(), Refusal> {
    let words = usize::try_from(PLACES / 64).unwrap_or(usize::MAX).saturating_add(1);
    work.count(words.saturating_mul(words).saturating_mul(8).saturating_mul(terms))
}

/// e^q: Σ tⁿ/n! for t = q/2^k, |t| ≤ 1/2, squared k times. The terms behind the 60th come to less than 2^-330, for
/// 61! > 2^277.
///
/// Units: t is off by less than one. If tⁿ⁻¹/(n − 1)! is off by E, the next term is off by less than (E/2 + 2)/n + 1: by 3
/// for n = 1, and by less than 3 ever after. So 60 terms are off by less than 2^8, and with what is left by less than 2^71.
fn exp_of(q: &BigRational, work: &Work) -> Result<Enclosure, Refusal> {
    if q.is_zero() {
        return Ok(Enclosure::integer(1));
    }
    let halvings = q.to_integer().bits() + 1;
    if halvings > 18 {
        return Err(Refusal::Limit("digits"));
    }
    count_series(60, work)?;
    let t = in_units(&(q * two_to(-i64::try_from(halvings).unwrap_or(0))));
    let mut term = BigInt::one() << PLACES;
    let mut sum = term.clone();
    for n in 1..=60 {
        term = product_in_units(&term, &t) / n;
        sum += &term;
    }
    let mut out = Enclosure::around(sum, 71, &BigRational::zero(), work)?;
    for _ in 0..halvings {
        out = out.times(&out, work)?;
    }
    Ok(out)
}

/// ln q for q = m·2^e, 1/2 < m < 2: ln m + e·ln 2 with ln m = 2·artanh((m − 1)/(m + 1)) and ln 2 = 2·artanh(1/3).
fn ln_of(q: &BigRational, work: &Work) -> Result<Enclosure, Refusal> {
    let bits = |n: &BigInt| i64::try_from(n.bits()).unwrap_or(0);
    let e = bits(q.numer()) - bits(q.denom());
    let m = q * two_to(-e);
    let z = (&m - BigRational::one()) / (&m + BigRational::one());
    let mut out = artanh(&z, work)?;
    if e != 0 {
        let third = BigRational::new(BigInt::one(), BigInt::from(3));
        out = out.plus(&artanh(&third, work)?.times(&Enclosure::integer(e), work)?, work)?;
    }
    out.times(&Enclosure::integer(2), work)
}

/// Σ ±z^(2j + 1)/(2j + 1), so many terms of it, for z in units and the factor ±z² from one power to the next.
///
/// Units, for |z| ≤ 1/3: z is off by less than one, so z² by less than 2. If a power is off by 2 at most, the next one is off by less
/// than 2/9 + 2/3 + 1 < 2, and its quotient by less than 3. So 100 terms are off by less than 2^9.
fn odd_powers(z: BigInt, square: &BigInt, terms: u32, work: &Work) -> Result<BigInt, Refusal> {
    count_series(usize::try_from(terms).unwrap_or(usize::MAX), work)?;
    let (mut power, mut sum) = (z, BigInt::zero());
    for j in 0..terms {
        sum += &power / (2 * j + 1);
        power = product_in_units(&power, square);
    }
    Ok(sum)
}

/// Σ z^(2j + 1)/(2j + 1) for |z| ≤ 1/3. The terms behind the 100th come to less than 3^-201·9/8 < 2^-318, which is 2^82 units.
fn artanh(z: &BigRational, work: &Work) -> Result<Enclosure, Refusal> {
    let z = in_units(z);
    let square = product_in_units(&z, &z);
    Enclosure::around(odd_powers(z, &square, 100, work)?, 83, &BigRational::zero(), work)
}

/// arctan(1/k) = Σ (−1)^j/((2j + 1)·k^(2j + 1)) for k ≥ 5. The terms alternate and get smaller: what is left after the 75th is less
/// than 5^-151 < 2^-350, which is 2^50 units.
fn arctan_of_inverse(k: i64, work: &Work) -> Result<Enclosure, Refusal> {
    let z = in_units(&BigRational::new(BigInt::one(), BigInt::from(k)));
    let square = -product_in_units(&z, &z);
    Enclosure::around(odd_powers(z, &square, 75, work)?, 51, &BigRational::zero(), work)
}

/// arctan q: that of −q is opposite, and that of q > 1 is π/2 less that of 1/q. For 0 < q ≤ 1, it is twice that of
/// q/(1 + √(1 + q²)), which is taken three times; then t ≤ tan(π/32) < 1/10. The terms of Σ (−1)^j·t^(2j + 1)/(2j + 1) alternate
/// and get smaller: what is left behind the 50th is less than 10^-101 < 2^-335, which is 2^65 units. The series is that of the lower
/// end of t; the slope of arctan is 1 at most.
fn arctan_of(q: &BigRational, work: &Work) -> Result<Enclosure, Refusal> {
    let one = Enclosure::integer(1);
    if q.is_zero() {
        return Ok(Enclosure::integer(0));
    }
    if q.is_negative() {
        return Ok(arctan_of(&-q, work)?.negated());
    }
    if *q > BigRational::one() {
        return Enclosure::quarter_turn(work)?.minus(&arctan_of(&q.recip(), work)?, work);
    }
    let mut t = Enclosure::between(q.clone(), q.clone(), work)?;
    for _ in 0..3 {
        let root = one.plus(&t.times(&t, work)?, work)?.root(2, work)?;
        t = t.times(&one.plus(&root, work)?.inverse(work)?, work)?;
    }
    let z = in_units(&t.low);
    let square = -product_in_units(&z, &z);
    let sum = Enclosure::around(odd_powers(z, &square, 50, work)?, 66, &(&t.high - &t.low), work)?;
    sum.times(&Enclosure::integer(8), work)
}

/// arcsin q for −1 ≤ q ≤ 1: the number whose tangent is q/√(1 − q²), or a quarter turn.
fn arcsin_of(q: &BigRational, work: &Work) -> Result<Enclosure, Refusal> {
    let rest = BigRational::one() - q * q;
    if rest.is_negative() {
        return rejected(Reason::NotDecided);
    }
    if rest.is_zero() {
        return Enclosure::quarter_turn(work)?.times(&Enclosure::exact(q.clone()), work);
    }
    let root = root_of(&rest, 2, work)?;
    Enclosure::exact(q.clone()).times(&root.inverse(work)?, work)?.arctan(work)
}

/// cos q and sin q: the real and the imaginary part of Σ (i·t)^n/n! for t = q − 2·k·π, |t| < 4. What is left of either behind the 119th
/// term is at most 2·4^120/120! < 2^-399, 2 units. The series is that of the lower end of t; the slopes are 1 at most.
///
/// Units: t is off by less than one, and |t|^n/n! is at most 11. If a term is off by E, the next one is off by less than
/// (4·E + 12)/n + 1. That is at most 13, 33, 49 and 53 for n from 1 to 4, and less than 53 ever after. So 60 terms are off by less
/// than 2^12, and with what is left by less than 2^13.
fn cosine_and_sine_of(q: &BigRational, work: &Work) -> Result<(Enclosure, Enclosure), Refusal> {
    if q.is_zero() {
        return Ok((Enclosure::integer(1), Enclosure::integer(0)));
    }
    if q.to_integer().bits() > 18 {
        return Err(Refusal::Limit("digits"));
    }
    let mut t = Enclosure::exact(q.clone());
    if q.abs() >= BigRational::from_integer(BigInt::from(4)) {
        let turn = Enclosure::pi(work)?.times(&Enclosure::integer(2), work)?;
        // Rounded to the nearest, so that what is left is about π at most.
        let turns = (q / &turn.low).round();
        t = t.minus(&turn.times(&Enclosure::exact(turns), work)?, work)?;
    }
    let four = BigRational::from_integer(BigInt::from(4));
    if t.low <= -&four || t.high >= four {
        return rejected(Reason::NotDecided);
    }
    count_series(120, work)?;
    let (units, width) = (in_units(&t.low), &t.high - &t.low);
    let mut term = BigInt::one() << PLACES;
    let mut sums = [BigInt::zero(), BigInt::zero()];
    for n in 0..120usize {
        if let Some(sum) = sums.get_mut(n % 2) {
            *sum += if n % 4 < 2 { term.clone() } else { -&term };
        }
        term = product_in_units(&term, &units) / (n + 1);
    }
    let [cosine, sine] = sums;
    Ok((Enclosure::around(cosine, 13, &width, work)?, Enclosure::around(sine, 13, &width, work)?))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 10^70 times the value, cut downwards, by mpmath with 120 digits.
    const VALUES: &[(&str, i64, i64, &str)] = &[
        ("exp", 1, 1, "27182818284590452353602874713526624977572470936999595749669676277240766"),
        ("exp", -1, 3, "7165313105737892504256040969253796674531120598214791571408702071273040"),
        ("exp", 7, 2, "331154519586923137506532493503886162924717282264779409888609484065998278"),
        ("exp", -29, 4, "7101743888425490635846003705775444086763023873618958855644522887464"),
        ("exp", 1, 1000000, "10000010000005000001666667083333416666680555557539682787698440255734678"),
        ("exp", 355, 113, "231406988058881969140231082311284030953685372836326813317861323150536831"),
        ("ln", 2, 1, "6931471805599453094172321214581765680755001343602552541206800094933936"),
        ("ln", 1, 3, "-10986122886681096913952452369225257046474905578227494517346943336374943"),
        ("ln", 7, 5, "3364722366212129305045934102169920901114833753133434665467422584634008"),
        ("ln", 1000001, 1000000, "9999995000003333330833335333331666668095236845239206348206350115"),
        ("ln", 1, 1000000, "-138155105579642741041079487281061852456066089317726378561999674058054357"),
        ("ln", 123456789, 1000, "117236464871858809811399589839101115869103773751340830470851062421894996"),
        ("sin", 1, 1, "8414709848078965066525023216302989996225630607983710656727517099919104"),
        ("sin", -22, 7, "12644889303773534003603504756459324917739113911976033925169697392722"),
        ("sin", 39, 10, "-6877661591839738180908881253786895610344727976112544652581995987612325"),
        ("sin", 4, 1, "-7568024953079282513726390945118290941359128873364725714854167734013105"),
        ("sin", 1000, 1, "8268795405320025602558874291092181412127249678477883209081232758194928"),
        ("sin", 1, 1000000, "9999999999998333333333333416666666666664682539682539710097001763"),
        ("cos", 1, 1, "5403023058681397174009366074429766037323104206179222276700972553811003"),
        ("cos", -22, 7, "-9999992005335529032683357396565749515758288206610964906755434814480029"),
        ("cos", 39, 10, "-7259323042001401293723304846143505840213310046130800783799622298047630"),
        ("cos", 4, 1, "-6536436208636119146391681830977503814241335966462182470070102838527377"),
        ("cos", 1000, 1, "5623790762907029910782492266053959687558118217381969177028251858457336"),
        ("cos", 1, 1000000, "9999999999995000000000000416666666666652777777777778025793650793648037"),
        ("arctan", 1, 1, "7853981633974483096156608458198757210492923498437764552437361480769541"),
        ("arctan", -1, 7, "-1418970546041639228128516171025530830077817587284640723781300293634417"),
        ("arctan", 5, 1, "13734007669450158608612719264449611486509995958997008089697833559128742"),
        ("arctan", 239, 1, "15666122507928218953667834766804659893575366343799209596604526832667264"),
        ("arctan", 1, 1000000, "9999999999996666666666668666666666665238095238096349206349205440"),
        ("arctan", 999, 1000, "7848979133141150013031697743878289438351876122582719422804750355893054"),
        ("arcsin", 1, 2, "5235987755982988730771072305465838140328615665625176368291574320513027"),
        ("arcsin", -1, 3, "-3398369094541219370963925133917640663882446903324580714319239624899159"),
        ("arcsin", 999, 1000, "15260712396261631879816254589682003721944041429253947276568345901727461"),
        ("arcsin", 1, 1000000, "10000000000001666666666667416666666667113095238095541914682539906"),
        ("arcsin", -99999, 100000, "-15663241871131086920589820253348987598385669812196372185533014596596063"),
        ("arcsin", 3, 5, "6435011087932843868028092287173226380415105911153123828656061187135124"),
    ];

    #[test]
    fn enclosures_hold_the_values_and_are_narrow() -> Result<(), Box<dyn std::error::Error>> {
        let work = Work::default();
        let scale = BigRational::from_integer(BigInt::from(10).pow(70));
        for (function, n, d, digits) in VALUES {
            let at = Enclosure::exact(BigRational::new(BigInt::from(*n), BigInt::from(*d)));
            let found = match *function {
                "exp" => at.exp(&work),
                "ln" => at.ln(&work),
                "sin" => at.cosine_and_sine(&work).map(|both| both.1),
                "cos" => at.cosine_and_sine(&work).map(|both| both.0),
                "arctan" => at.arctan(&work),
                _ => at.arcsin(&work),
            }
            .map_err(|refusal| format!("{function}({n}/{d}): {refusal:?}"))?;
            let digits = BigRational::from_integer(digits.parse()?);
            let one = BigRational::one();
            assert!(&found.low * &scale < &digits + &one && digits <= &found.high * &scale, "{function}({n}/{d})");
            let size = found.high.abs().max(two_to(-20));
            assert!(&found.high - &found.low < size * two_to(-225), "{function}({n}/{d}) is wide");
        }
        Ok(())
    }

    #[test]
    fn wide_arguments_lose_no_value() -> Result<(), Box<dyn std::error::Error>> {
        let whole = |k: i64| BigRational::from_integer(BigInt::from(k));
        // Of 64 places in a wide argument the values lie within those of the whole.
        for (from, to) in [(-3, -2), (-1, 1), (0, 1), (3, 5), (30, 31)] {
            let work = Work::default();
            let wide = Enclosure { low: whole(from), high: whole(to) };
            let refusal = |refusal: Refusal| format!("{refusal:?}");
            let (cosine, sine) = wide.cosine_and_sine(&work).map_err(refusal)?;
            let arctan = wide.arctan(&work).map_err(refusal)?;
            let exp = wide.exp(&work).map_err(refusal)?;
            for k in 0..=64 {
                let place = whole(from) + BigRational::new(BigInt::from((to - from) * k), BigInt::from(64));
                let (here, work) = (Enclosure::exact(place), Work::default());
                let (c, s) = here.cosine_and_sine(&work).map_err(refusal)?;
                let pairs = [(&cosine, c), (&sine, s), (&arctan, here.arctan(&work).map_err(refusal)?)];
                for (whole, part) in pairs.into_iter().chain([(&exp, here.exp(&work).map_err(refusal)?)]) {
                    assert!(whole.low <= part.high && part.low <= whole.high);
                }
            }
        }
        Ok(())
    }
}
