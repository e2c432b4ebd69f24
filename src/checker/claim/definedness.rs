//! When an expression has a value: the one list of conditions, made from how the expression is written.
//!
//! Contract: a node of an expression has a value at a point if and only if its parts have values there and every
//! [`Need`] of [`needs`] holds. Prover, kernel, evaluator and both exports use this module. None of them simplifies an
//! exponent first, so that all give the same answer.
//!
//! An exponent of numerals alone is computed exactly. Where its numbers become longer than [`BITS_LIMIT`] and its form does not
//! tell its kind, the answer is [`TooLong`]: never that the power has no value.
//!
//! A power b^E by its exponent, see [`Exponent`]:
//!
//! | exponent | examples | b^E has a value where |
//! |---|---|---|
//! | numerals alone, whole | `3`, `-2`, `4/2` | E ≥ 0, or b ≠ 0 |
//! | numerals alone, not whole, positive | `1/2`, `0.3` | b ≥ 0 (0^E = 0) |
//! | numerals alone, not whole, negative | `-1/2` | b > 0 |
//! | whole by its form | `n`, `2*n + 1`, `k - 1`, `-n` | E ≥ 0, or b ≠ 0 |
//! | any other | `p`, `1/n`, `n/n`, `sqrt(4)` | b > 0 |
//!
//! b^0 is 1 wherever it has a value: 0^0 = 1 for a whole exponent.

use super::syntax::*;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};
use std::cmp::Ordering;

/// An exponent, by its form.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Exponent {
    /// A whole number wherever it has a value.
    Whole,
    /// A positive number that is not whole, written with numerals alone.
    Root,
    /// Any other: the base has to be positive.
    Real,
}

/// A condition under which a node of an expression has a value, if its parts have values.
#[derive(Clone, Debug)]
pub enum Need {
    /// A divisor, or the base of a power to a negative number.
    NotZero(Expr),
    /// The base of a power whose exponent is not whole, or under a logarithm.
    Positive(Expr),
    /// Under a root.
    NotNegative(Expr),
    /// The base and exponent of a power whose exponent is whole and may be negative: the base is not 0, or the exponent
    /// is at least 0.
    NotZeroOrNatural(Expr, Expr),
    /// The ends of a range: it may be empty, but does not end earlier than that: from ≤ to + 1.
    Range(Expr, Expr),
    /// The expression has so many derivatives by the variable, at it.
    Differentiable(Expr, Name, usize),
}

/// A number as a fraction in lowest terms, the denominator positive.
type Number = (i128, i128);

/// The most bits of a numerator or denominator that is computed for an exponent of numerals alone.
pub const BITS_LIMIT: u64 = 1_024;
/// The most bits of all numbers together that are computed for one such exponent.
const BITS_IN_ALL: u64 = 16 * BITS_LIMIT;

/// An exponent of numerals alone exceeds [`BITS_LIMIT`], so that its kind is not known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooLong;

impl TooLong {
    /// The name of the limit.
    pub const LIMIT: &str = "digits of an exponent";
}

/// A number that is written with numerals alone, by what its power needs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Numerals {
    /// Whether it is a whole number.
    pub is_whole: bool,
    /// How it compares with 0.
    pub sign: Ordering,
}

/// Which kind an exponent is. `whole` says of a name whether it stands for whole numbers: a natural variable, an index
/// of a sum, product or sequence, or a natural family.
///
/// # Errors
/// The exponent is of numerals alone, too long, and not whole by its form.
pub fn exponent(e: &Expr, whole: &dyn Fn(&str) -> bool) -> Result<Exponent, TooLong> {
    Ok(match numerals(e) {
        Ok(Some(Numerals { is_whole: true, .. })) => Exponent::Whole,
        Ok(Some(Numerals { sign: Ordering::Greater, .. })) => Exponent::Root,
        Ok(Some(_)) => Exponent::Real,
        Ok(None) | Err(TooLong) if is_whole(e, whole) => Exponent::Whole,
        Ok(None) => Exponent::Real,
        Err(TooLong) => return Err(TooLong),
    })
}

/// The conditions of a node; those of its parts are theirs.
///
/// # Errors
/// The node is a power whose exponent has no [`exponent`] that is known.
pub fn needs(e: &Expr, whole: &dyn Fn(&str) -> bool) -> Result<Vec<Need>, TooLong> {
    Ok(match &e.kind {
        ExprKind::Product(list) => list
            .iter()
            .filter(|(operator, _)| *operator == Factor::Over)
            .map(|(_, divisor)| Need::NotZero(divisor.clone()))
            .collect(),
        ExprKind::Power(base, e) => {
            let base = (**base).clone();
            match (exponent(e, whole)?, numerals(e)) {
                (Exponent::Root, _) => vec![Need::NotNegative(base)],
                (Exponent::Real, _) => vec![Need::Positive(base)],
                (Exponent::Whole, Ok(Some(Numerals { sign: Ordering::Less, .. }))) => vec![Need::NotZero(base)],
                (Exponent::Whole, Ok(Some(_))) => Vec::new(),
                (Exponent::Whole, _) => vec![Need::NotZeroOrNatural(base, (**e).clone())],
            }
        }
        ExprKind::Apply(f, arguments) => match (f.text.as_str(), arguments.first()) {
            ("sqrt" | "cbrt", Some(a)) => vec![Need::NotNegative(a.clone())],
            ("ln", Some(a)) => vec![Need::Positive(a.clone())],
            ("arcsin" | "arccos", Some(a)) => from_one(a).map(Need::NotNegative).to_vec(),
            _ => Vec::new(),
        },
        ExprKind::SumOver(index, _) | ExprKind::ProductOver(index, _) => {
            vec![Need::Range((*index.from).clone(), (*index.to).clone())]
        }
        ExprKind::Derivative(body, by) => match by.first() {
            Some(name) => vec![Need::Differentiable((**body).clone(), name.clone(), by.len())],
            None => Vec::new(),
        },
        ExprKind::Number(_)
        | ExprKind::Name(_)
        | ExprKind::Negate(_)
        | ExprKind::Sum(_)
        | ExprKind::Matrix(_)
        | ExprKind::IntegralOver(..) => Vec::new(),
    })
}

/// 1 − a and 1 + a: how far a sine is from 1 and −1.
pub(crate) fn from_one(a: &Expr) -> [Expr; 2] {
    let one = || Expr { kind: ExprKind::Number("1".to_string()), span: a.span };
    [Sign::Minus, Sign::Plus]
        .map(|sign| Expr { kind: ExprKind::Sum(vec![(Sign::Plus, one()), (sign, a.clone())]), span: a.span })
}

/// Whether an expression is a whole number by its form: made of whole numbers, natural variables, indices and members
/// of natural families by adding, subtracting and multiplying, and by powers to a natural numeral.
pub fn is_whole(e: &Expr, whole: &dyn Fn(&str) -> bool) -> bool {
    if let Ok(Some(known)) = numerals(e) {
        return known.is_whole;
    }
    match &e.kind {
        ExprKind::Name(name) => whole(name),
        ExprKind::Apply(f, _) => whole(&f.text),
        ExprKind::Negate(a) => is_whole(a, whole),
        ExprKind::Sum(list) => list.iter().all(|(_, a)| is_whole(a, whole)),
        ExprKind::Product(list) => list.iter().all(|(f, a)| *f == Factor::Times && is_whole(a, whole)),
        ExprKind::Power(a, b) => is_whole(a, whole) && is_natural_numeral(b),
        _ => false,
    }
}

/// Whether it is, and no minus sign stands in it: at least 0 by its form. `natural` then speaks of names that stand for
/// no negative number.
pub(crate) fn is_natural(e: &Expr, natural: &dyn Fn(&str) -> bool) -> bool {
    if let Ok(Some(known)) = numerals(e) {
        return known.is_whole && known.sign != Ordering::Less;
    }
    match &e.kind {
        ExprKind::Sum(list) => list.iter().all(|(s, a)| *s == Sign::Plus && is_natural(a, natural)),
        ExprKind::Product(list) => list.iter().all(|(f, a)| *f == Factor::Times && is_natural(a, natural)),
        ExprKind::Power(a, b) => is_natural(a, natural) && is_natural_numeral(b),
        ExprKind::Name(_) | ExprKind::Apply(..) => is_whole(e, natural),
        _ => false,
    }
}

/// Whether an expression of numerals alone is a natural number.
fn is_natural_numeral(e: &Expr) -> bool {
    numerals(e).is_ok_and(|known| known.is_some_and(|known| known.is_whole && known.sign != Ordering::Less))
}

/// What an expression of numerals alone comes to; nothing where anything else stands in it, or where it has no value or a power
/// whose exponent is not whole.
///
/// # Errors
/// A number in it is too long to be computed.
pub fn numerals(e: &Expr) -> Result<Option<Numerals>, TooLong> {
    if let Some((top, below)) = number(e) {
        return Ok(Some(Numerals { is_whole: below == 1, sign: top.cmp(&0) }));
    }
    if let ExprKind::Number(text) = &e.kind {
        return Ok(Some(Numeral::of(text).kind()));
    }
    if !is_of_numerals(e) {
        return Ok(None);
    }
    let mut left = BITS_IN_ALL;
    Ok(exact(e, &mut left)?
        .map(|value| Numerals { is_whole: value.is_integer(), sign: value.numer().cmp(&BigInt::zero()) }))
}

/// The value of an expression of numerals alone, where it and every number on the way are short. For what may be missed: that
/// there is none says nothing of the expression.
pub fn number(e: &Expr) -> Option<Number> {
    match &e.kind {
        ExprKind::Number(text) => Numeral::of(text).short(),
        ExprKind::Negate(a) => number(a).and_then(|(a, b)| Some((a.checked_neg()?, b))),
        ExprKind::Sum(list) => list.iter().try_fold((0i128, 1i128), |(a, b), (sign, e)| {
            let (c, d) = number(e)?;
            let c = if *sign == Sign::Plus { c } else { c.checked_neg()? };
            reduced(a.checked_mul(d)?.checked_add(c.checked_mul(b)?)?, b.checked_mul(d)?)
        }),
        ExprKind::Product(list) => list.iter().try_fold((1i128, 1i128), |(a, b), (operator, e)| {
            let (c, d) = number(e)?;
            let (c, d) = if *operator == Factor::Times { (c, d) } else { (d, c) };
            reduced(a.checked_mul(c)?, b.checked_mul(d)?)
        }),
        ExprKind::Power(base, e) => {
            let ((a, b), (k, 1)) = (number(base)?, number(e)?) else { return None };
            let size = u32::try_from(k.unsigned_abs()).ok()?;
            let (a, b) = (a.checked_pow(size)?, b.checked_pow(size)?);
            if k < 0 { reduced(b, a) } else { reduced(a, b) }
        }
        _ => None,
    }
}

/// Whether an expression is made of numerals by + − * / and powers.
fn is_of_numerals(e: &Expr) -> bool {
    match &e.kind {
        ExprKind::Number(_) => true,
        ExprKind::Negate(a) => is_of_numerals(a),
        ExprKind::Sum(list) => list.iter().all(|(_, a)| is_of_numerals(a)),
        ExprKind::Product(list) => list.iter().all(|(_, a)| is_of_numerals(a)),
        ExprKind::Power(a, b) => is_of_numerals(a) && is_of_numerals(b),
        _ => false,
    }
}

/// The same of numbers of any length, with so many bits left for all of them.
fn exact(e: &Expr, left: &mut u64) -> Result<Option<BigRational>, TooLong> {
    let value = match &e.kind {
        ExprKind::Number(text) => Numeral::of(text).exact()?,
        ExprKind::Negate(a) => match exact(a, left)? {
            Some(a) => -a,
            None => return Ok(None),
        },
        ExprKind::Sum(list) => {
            let mut sum = BigRational::zero();
            for (sign, part) in list {
                let Some(part) = exact(part, left)? else { return Ok(None) };
                sum = spent(if *sign == Sign::Plus { sum + part } else { sum - part }, left)?;
            }
            sum
        }
        ExprKind::Product(list) => {
            let mut product = BigRational::one();
            for (operator, part) in list {
                let part = match (exact(part, left)?, operator) {
                    (Some(part), Factor::Times) => part,
                    (Some(part), Factor::Over) if !part.is_zero() => part.recip(),
                    _ => return Ok(None),
                };
                product = spent(product * part, left)?;
            }
            product
        }
        ExprKind::Power(base, e) => match (exact(base, left)?, exact(e, left)?) {
            (Some(base), Some(e)) if e.is_integer() => match power(base, e.numer())? {
                Some(power) => power,
                None => return Ok(None),
            },
            _ => return Ok(None),
        },
        _ => return Ok(None),
    };
    spent(value, left).map(Some)
}

/// Counts the bits of a number.
fn spent(value: BigRational, left: &mut u64) -> Result<BigRational, TooLong> {
    let bits = value.numer().bits().max(value.denom().bits());
    *left = left.checked_sub(bits).filter(|_| bits <= BITS_LIMIT).ok_or(TooLong)?;
    Ok(value)
}

/// A whole power; nothing for 0 to a negative one.
fn power(base: BigRational, k: &BigInt) -> Result<Option<BigRational>, TooLong> {
    if k.is_negative() && base.is_zero() {
        return Ok(None);
    }
    let bits = base.numer().bits().max(base.denom().bits());
    if bits <= 1 {
        // 0, 1 and -1, whatever the exponent.
        let is_kept = k.bit(0) || (base.is_zero() && !k.is_zero());
        return Ok(Some(if is_kept { base } else { BigRational::one() }));
    }
    // A number of n bits is at least 2^(n − 1).
    let k =
        k.to_i32().filter(|k| (bits - 1).saturating_mul(u64::from(k.unsigned_abs())) < BITS_LIMIT).ok_or(TooLong)?;
    Ok(Some(base.pow(k)))
}

/// A numeral as written: digits without zeros at either end, and the power of 10 that they are multiplied by.
struct Numeral<'a> {
    whole: &'a str,
    part: &'a str,
    exponent: i64,
}

impl<'a> Numeral<'a> {
    /// The reader has seen to it that it is digits, perhaps with a point and a decimal exponent.
    fn of(text: &'a str) -> Numeral<'a> {
        let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
        let (whole, part) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let part = part.trim_end_matches('0');
        let shorter = if part.is_empty() { whole.trim_end_matches('0') } else { whole };
        // What is out of range is as far from every limit as the bound of the type.
        let exponent = exponent.parse().unwrap_or(if exponent.starts_with('-') { -i64::MAX } else { i64::MAX });
        let length = |text: &str| i64::try_from(text.len()).unwrap_or(i64::MAX);
        let exponent = exponent.saturating_add(length(whole) - length(shorter)).saturating_sub(length(part));
        Numeral { whole: shorter.trim_start_matches('0'), part, exponent }
    }

    fn is_zero(&self) -> bool {
        self.whole.is_empty() && self.part.bytes().all(|b| b == b'0')
    }

    fn kind(&self) -> Numerals {
        let sign = if self.is_zero() { Ordering::Equal } else { Ordering::Greater };
        Numerals { is_whole: self.is_zero() || self.exponent >= 0, sign }
    }

    fn short(&self) -> Option<Number> {
        if self.is_zero() {
            return Some((0, 1));
        }
        let digits = self.whole.bytes().chain(self.part.bytes()).try_fold(0i128, |value, digit| {
            value.checked_mul(10)?.checked_add(i128::from(digit.checked_sub(b'0').filter(|d| *d < 10)?))
        })?;
        let power = 10i128.checked_pow(u32::try_from(self.exponent.unsigned_abs()).ok()?)?;
        if self.exponent < 0 { reduced(digits, power) } else { reduced(digits.checked_mul(power)?, 1) }
    }

    fn exact(&self) -> Result<BigRational, TooLong> {
        if self.is_zero() {
            return Ok(BigRational::zero());
        }
        // 10 has more than 3 bits: whatever is longer than this, is too long.
        let most = BITS_LIMIT / 3;
        let power =
            u32::try_from(self.exponent.unsigned_abs()).ok().filter(|k| u64::from(*k) <= most).ok_or(TooLong)?;
        let digits = format!("{}{}", self.whole, self.part);
        if u64::try_from(digits.len()).unwrap_or(u64::MAX) > most {
            return Err(TooLong);
        }
        let digits: BigInt = digits.parse().map_err(|_| TooLong)?;
        let power = BigInt::from(10).pow(power);
        // The denominator is a power of 10, never 0.
        Ok(if self.exponent < 0 { BigRational::new(digits, power) } else { BigRational::from_integer(digits * power) })
    }
}

/// The fraction in lowest terms; `None` if the denominator is 0.
fn reduced(a: i128, b: i128) -> Option<Number> {
    let (mut x, mut y) = (a.checked_abs()?, b.checked_abs()?);
    while y != 0 {
        (x, y) = (y, x % y);
    }
    match b {
        0 => None,
        1.. => Some((a / x, b / x)),
        _ => Some((-(a / x), -(b / x))),
    }
}
