//! Numbers at a point: exact, or between two others.
//!
//! Contract: every operation contains what the exact operation gives on all numbers of its operands, or says that it has no
//! value or does not know one. Roots of numbers that are no perfect powers become intervals of relative width
//! 2^−[`PRECISION`].

use super::closed::Closed;
use super::turns::cosine_and_sine_of;
use crate::claim::syntax::*;
use crate::kernel::arc::{KnownAngle, known_angles};
use crate::number::decimal::{Decimal, Digits, Rounding};
use crate::number::{elementary, rational};
use malachite::base::num::arithmetic::traits::{FloorRoot, Pow};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::logic::traits::SignificantBits;
use malachite::{Integer, Rational};
use std::borrow::Cow;
use std::rc::Rc;

/// The largest exponent and index that is evaluated.
pub const LARGEST: i64 = 400;

/// The largest exponent of a power that is enclosed narrowly.
const LARGE: u64 = 100_000;

/// Bits kept of the ends of intervals.
pub const PRECISION: u64 = 192;

/// The most bits of an exact value.
const EXACT_BITS: u64 = 100_000;

/// A number known exactly or between two others.
#[derive(Clone, Debug, PartialEq)]
pub enum Number {
    /// Exactly this.
    Exact(Rational),
    /// Strictly or loosely between these; in closed form, where that is known.
    Between(Rational, Rational, Option<Rc<Closed>>),
}

/// Why there is no value.
#[derive(Clone, Debug, PartialEq)]
pub enum Missing {
    /// The expression has no value at this point; the text says where.
    Undefined(String),
    /// This module cannot compute it.
    Unknown,
}

pub(super) type Result<T> = std::result::Result<T, Missing>;

impl Number {
    /// Numbers between which it lies.
    pub(crate) fn ends(&self) -> (&Rational, &Rational) {
        match self {
            Number::Exact(q) => (q, q),
            Number::Between(a, b, _) => (a, b),
        }
    }

    /// Its closed form.
    pub(super) fn closed(&self) -> Option<Cow<'_, Closed>> {
        match self {
            Number::Exact(q) => Some(Cow::Owned(Closed::rational(q))),
            Number::Between(_, _, form) => form.as_deref().map(Cow::Borrowed),
        }
    }

    /// The number by numerals, roots of them and π, if that is its closed form.
    pub(super) fn written(&self) -> Option<Expr> {
        self.closed()?.written()
    }

    /// The same number with the closed form that operations on forms give.
    fn formed(self, form: Option<Closed>) -> Number {
        match (self, form) {
            (Number::Between(low, high, _), Some(form)) => match form.as_rational() {
                Some(q) => Number::Exact(q),
                None => Number::Between(low, high, Some(Rc::new(form))),
            },
            (number, _) => number,
        }
    }

    /// The sign of the difference to another number, if certain.
    pub fn order(&self, other: &Number) -> Option<std::cmp::Ordering> {
        let ((a, b), (c, d)) = (self.ends(), other.ends());
        if let (Number::Exact(a), Number::Exact(c)) = (self, other) {
            return Some(a.cmp(c));
        }
        if let (Number::Between(_, _, Some(x)), Number::Between(_, _, Some(y))) = (self, other)
            && x == y
        {
            return Some(std::cmp::Ordering::Equal);
        }
        if b < c {
            Some(std::cmp::Ordering::Less)
        } else if a > d {
            Some(std::cmp::Ordering::Greater)
        } else {
            None
        }
    }

    /// The number as p/q, or as a decimal with as many digits as are certain, 3 to 12 places, or between its ends.
    pub fn text(&self) -> String {
        let (low, high) = match self {
            Number::Exact(q) => return q.to_string(),
            Number::Between(low, high, _) => (low, high),
        };
        // Digits without one other than 0 do not even tell the sign.
        let cut = (3..=SHOWN).rev().find_map(|places| self.cut(Digits::Places(places)));
        if let Some(cut) = cut.filter(|cut| cut.contains(|c: char| ('1'..='9').contains(&c))) {
            return self.shown(&cut);
        }
        let end = |q: &Rational, rounding| {
            let found = Decimal::of_rational(q, Digits::Significant(3), rounding);
            found.map_or_else(|_| q.to_string(), |decimal| decimal.to_string())
        };
        format!("between {} and {}", end(low, Rounding::Down), end(high, Rounding::Up))
    }

    /// Its decimal, cut off rather than rounded, where all of these digits are certain.
    fn cut(&self, digits: Digits) -> Option<String> {
        let (low, high) = self.ends();
        let cut = |q| Decimal::of_rational(q, digits, Rounding::Zero).ok().map(|decimal| decimal.to_string());
        cut(low).filter(|text| cut(high).as_ref() == Some(text))
    }

    /// The number as p/q, or this decimal of it with the sign that more digits follow.
    fn shown(&self, cut: &str) -> String {
        match (self, cut.split_once('e')) {
            (Number::Exact(q), _) => q.to_string(),
            (_, None) => format!("{cut}..."),
            (_, Some((digits, exponent))) => format!("{digits}...e{exponent}"),
        }
    }
}

/// The most places after the point of an enclosed number that is shown alone.
const SHOWN: u64 = 12;

/// Two numbers as texts, with enough digits to see which is greater where enclosures tell.
pub(super) fn sides(a: &Number, b: &Number) -> (String, String) {
    let more = [Digits::Places(SHOWN), Digits::Significant(12), Digits::Significant(25), Digits::Significant(50)];
    let told = more.into_iter().find_map(|digits| Some((a.cut(digits)?, b.cut(digits)?)).filter(|(x, y)| x != y));
    told.map_or_else(|| (a.text(), b.text()), |(x, y)| (a.shown(&x), b.shown(&y)))
}

fn rounded(q: &Rational, up: bool) -> Rational {
    let bits = q.numerator_ref().significant_bits().max(q.denominator_ref().significant_bits());
    if bits <= 2 * PRECISION {
        return q.clone();
    }
    // Scale so that the numerator has about PRECISION bits over a power of two.
    let shift = q.denominator_ref().significant_bits() + PRECISION;
    let shift =
        i64::try_from(shift).unwrap_or(i64::MAX) - i64::try_from(q.numerator_ref().significant_bits()).unwrap_or(0);
    let scale = Rational::from(2).pow(shift);
    let scaled = q * &scale;
    let whole = if up {
        malachite::base::num::arithmetic::traits::Ceiling::ceiling(scaled)
    } else {
        malachite::base::num::arithmetic::traits::Floor::floor(scaled)
    };
    Rational::from(whole) / scale
}

pub(super) fn between(a: Rational, b: Rational) -> Number {
    if a == b { Number::Exact(a) } else { Number::Between(rounded(&a, false), rounded(&b, true), None) }
}

/// The number, or an enclosure where it is too long.
pub(super) fn exact(q: Rational) -> Number {
    if q.significant_bits() > EXACT_BITS {
        Number::Between(rounded(&q, false), rounded(&q, true), None)
    } else {
        Number::Exact(q)
    }
}

/// The number, unless its ends are too long. Rounding cannot shorten very large and very small ends.
pub(super) fn of_some_size(x: Number) -> Result<Number> {
    let (low, high) = x.ends();
    if low.significant_bits().max(high.significant_bits()) > 2 * EXACT_BITS { Err(Missing::Unknown) } else { Ok(x) }
}

pub(super) fn add(x: &Number, y: &Number) -> Number {
    match (x, y) {
        (Number::Exact(a), Number::Exact(b)) => exact(a + b),
        _ => {
            let ((a, b), (c, d)) = (x.ends(), y.ends());
            let form = || x.closed()?.plus(&*y.closed()?);
            between(a + c, b + d).formed(form())
        }
    }
}

pub(super) fn negate(a: &Number) -> Number {
    match a {
        Number::Exact(a) => Number::Exact(-a),
        Number::Between(low, high, _) => {
            let form = || a.closed()?.times(&Closed::rational(&-Rational::ONE));
            Number::Between(-high, -low, None).formed(form())
        }
    }
}

pub(super) fn multiply(x: &Number, y: &Number) -> Number {
    match (x, y) {
        (Number::Exact(a), Number::Exact(b)) => exact(a * b),
        (Number::Exact(q), _) | (_, Number::Exact(q)) if *q == 0 => Number::Exact(Rational::ZERO),
        _ => {
            let ((a, b), (c, d)) = (x.ends(), y.ends());
            let products = [a * c, a * d, b * c, b * d];
            let least = products.iter().min().cloned().unwrap_or(Rational::ZERO);
            let most = products.iter().max().cloned().unwrap_or(Rational::ZERO);
            let form = || x.closed()?.times(&*y.closed()?);
            between(least, most).formed(form())
        }
    }
}

pub(super) fn invert(a: &Number, text: impl Fn() -> String) -> Result<Number> {
    let (low, high) = a.ends();
    match a {
        Number::Exact(q) if *q == 0 => Err(Missing::Undefined(format!("division by {} = 0", text()))),
        Number::Exact(q) => Ok(Number::Exact(Rational::ONE / q)),
        _ if *low > 0 || *high < 0 => {
            // Forms of sums are raised where they are positive.
            let one = Closed::rational(&-Rational::ONE);
            let form = || match *low > 0 {
                true => a.closed()?.power(&-Rational::ONE),
                false => a.closed()?.times(&one)?.power(&-Rational::ONE)?.times(&one),
            };
            Ok(between(Rational::ONE / high, Rational::ONE / low).formed(form()))
        }
        _ => Err(Missing::Unknown),
    }
}

pub(super) fn whole_power(a: &Number, k: u64) -> Result<Number> {
    let (low, high) = a.ends();
    let bits = low.significant_bits().max(high.significant_bits());
    if bits.saturating_mul(k) > 60_000 {
        return Err(Missing::Unknown);
    }
    Ok(match a {
        Number::Exact(q) => Number::Exact(q.pow(k)),
        Number::Between(low, high, _) if *low >= 0 => {
            let form = || a.closed()?.power(&Rational::from(k));
            between(low.pow(k), high.pow(k)).formed(form())
        }
        _ => {
            let mut out = Number::Exact(Rational::ONE);
            for _ in 0..k {
                out = multiply(&out, a);
            }
            out
        }
    })
}

/// The k-th root of a non-negative number.
pub(super) fn root(a: &Number, k: u64) -> Number {
    if let Number::Exact(q) = a
        && let Some(root) = rational::exact_root(q, k)
    {
        return Number::Exact(root);
    }
    let (low, high) = a.ends();
    // floor(2^P·root) from an integer root of floor(2^(kP)·q); P grows for small q.
    let lower = |q: &Rational, plus: bool| -> Rational {
        if *q <= 0 {
            return Rational::ZERO;
        }
        let small = q.denominator_ref().significant_bits().saturating_sub(q.numerator_ref().significant_bits());
        let precision = PRECISION + small / k + 1;
        let scaled = q * Rational::from(2).pow(precision * k);
        let whole = malachite::base::num::arithmetic::traits::Floor::floor(scaled);
        let mut r = Integer::floor_root(whole, k);
        if plus {
            r += Integer::ONE;
        }
        Rational::from(r) / Rational::from(2).pow(precision)
    };
    let form = || a.closed()?.power(&Rational::from_unsigneds(1, k));
    between(lower(low, false), lower(high, true)).formed(if *low > 0 { form() } else { None })
}

/// a^p, or a^−p, for p > [`LARGEST`], where a rough enclosure is to be had: the exact value may have
/// billions of digits.
pub(super) fn large_power(a: &Number, p: i64, negative: bool, text: impl Fn() -> String) -> Result<Number> {
    let (low, high) = a.ends();
    let one = Rational::ONE;
    match a {
        Number::Exact(q) if *q == 0 => {
            if negative {
                invert(a, text)
            } else {
                Ok(a.clone())
            }
        }
        Number::Exact(q) if *q == 1 => Ok(a.clone()),
        Number::Exact(q) if *q == -1 => Ok(Number::Exact(if p % 2 == 0 { one } else { -one })),
        // h^p = exp(p·ln h) for h > 0.
        _ if *low > 0 && p.unsigned_abs() <= LARGE => {
            let p = Number::Exact(Rational::from(if negative { -p.abs() } else { p.abs() }));
            exponential(&multiply(&p, &logarithm(a, text)?))
        }
        // 0 < h < 1: 0 < h^p ≤ h^400 for p ≥ 400.
        _ if *low > 0 && *high < 1 && !negative => {
            Ok(Number::Between(Rational::ZERO, rounded(&high.pow(LARGEST), true), None))
        }
        _ if *low > 1 && negative => {
            Ok(Number::Between(Rational::ZERO, rounded(&(one / low).pow(LARGEST), true), None))
        }
        _ => Err(Missing::Unknown),
    }
}

/// e^a.
pub(super) fn exponential(a: &Number) -> Result<Number> {
    let (low, high) = a.ends();
    let (low, high) = elementary::exp(low, high).ok_or(Missing::Unknown)?;
    Ok(between(low, high).formed(a.closed().and_then(|a| a.exp())))
}

/// cos a and sin a; those of a multiple of π/120 in closed form.
pub(super) fn cosine_and_sine(a: &Number) -> Result<(Number, Number)> {
    if let Some(turns) = a.closed().and_then(|form| form.turns())
        && let Some(known) = cosine_and_sine_of(&turns)
    {
        return Ok(known);
    }
    let (low, high) = a.ends();
    let (cosine, sine) = elementary::cos_sin(low, high).ok_or(Missing::Unknown)?;
    Ok((between(cosine.0, cosine.1), between(sine.0, sine.1)))
}

/// π.
pub(super) fn pi() -> Number {
    let (low, high) = elementary::pi().clone();
    between(low, high).formed(Some(Closed::pi()))
}

/// ln a.
pub(super) fn logarithm(a: &Number, text: impl Fn() -> String) -> Result<Number> {
    let (low, high) = a.ends();
    if *high <= 0 {
        return Err(Missing::Undefined(format!("{} takes the logarithm of a number that is not positive", text())));
    }
    let (low, high) = elementary::ln(low, high).ok_or(Missing::Unknown)?;
    let form = if *a.ends().0 > 0 { a.closed().and_then(|a| a.ln()) } else { None };
    Ok(between(low, high).formed(form))
}

/// arcsin, arccos or arctan of a; that of a known angle in closed form.
pub(super) fn arc(name: &str, a: &Number, text: impl Fn() -> String) -> Result<Number> {
    let quarter = || multiply(&Number::Exact(Rational::from_signeds(1, 2)), &pi());
    let (low, high) = a.ends();
    if name != "arctan" && (*low > 1 || *high < -1) {
        return Err(Missing::Undefined(format!("{} is the arc of a number that is not between -1 and 1", text())));
    }
    if name == "arccos" {
        return Ok(add(&quarter(), &negate(&arc("arcsin", a, text)?)));
    }
    if *low == 0 && *high == 0 {
        return Ok(Number::Exact(Rational::ZERO));
    }
    let square = multiply(a, a);
    let is_it = |(top, bottom, _): &&KnownAngle| {
        holds(&square, Relation::Equal, &Number::Exact(Rational::from_signeds(*top, *bottom))) == Some(true)
    };
    if let Some((_, _, k)) = known_angles(name).iter().find(is_it).filter(|_| *low > 0 || *high < 0) {
        return Ok(multiply(&Number::Exact(Rational::from_signeds(if *low > 0 { 1 } else { -1 }, *k)), &pi()));
    }
    if name == "arctan" {
        let (low, high) = elementary::arctan(low, high);
        return Ok(between(low, high));
    }
    if *low <= -1 || *high >= 1 {
        return Err(Missing::Unknown);
    }
    // The arcsin of s is the arctan of s/√(1 − s²).
    let tangent = |s: &Rational| {
        let rest = Number::Exact(Rational::ONE - s * s);
        Ok(multiply(&Number::Exact(s.clone()), &invert(&root(&rest, 2), String::new)?))
    };
    let (least, most) = (tangent(low)?, tangent(high)?);
    let (low, high) =
        (elementary::arctan(least.ends().0, least.ends().1), elementary::arctan(most.ends().0, most.ends().1));
    Ok(between(low.0, high.1))
}

/// cosh, sinh, tanh or sech of a.
pub(super) fn hyperbolic(name: &str, a: &Number) -> Result<Number> {
    let (up, down) = (exponential(a)?, exponential(&negate(a))?);
    let half = Number::Exact(Rational::from_signeds(1, 2));
    let cosh = multiply(&half, &add(&up, &down));
    let sinh = multiply(&half, &add(&up, &negate(&down)));
    let inverse = |n: &Number| invert(n, String::new);
    match name {
        "cosh" => Ok(cosh),
        "sinh" => Ok(sinh),
        "sech" => inverse(&cosh),
        _ => Ok(multiply(&sinh, &inverse(&cosh)?)),
    }
}

/// Whether a comparison certainly holds or certainly fails.
pub(super) fn holds(a: &Number, relation: Relation, b: &Number) -> Option<bool> {
    use std::cmp::Ordering::*;
    let ((low, high), (least, most)) = (a.ends(), b.ends());
    if let Some(order) = a.order(b) {
        return Some(match relation {
            Relation::Equal => order == Equal,
            Relation::NotEqual => order != Equal,
            Relation::Less => order == Less,
            Relation::LessEqual => order != Greater,
            Relation::Greater => order == Greater,
            Relation::GreaterEqual => order != Less,
        });
    }
    match relation {
        Relation::LessEqual if high <= least => Some(true),
        Relation::GreaterEqual if low >= most => Some(true),
        Relation::Less if low >= most => Some(false),
        Relation::Greater if high <= least => Some(false),
        _ => None,
    }
}
