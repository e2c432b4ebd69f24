//! When an expression has a value: the one list of conditions, made from how the expression is written.
//!
//! Contract: a node of an expression has a value at a point if and only if its parts have values there and every
//! [`Need`] of [`needs`] holds. Prover, kernel, evaluator and both exports use this module. None of them simplifies an
//! exponent first, so that all give the same answer.
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

/// The largest exponent of a power of numerals that is computed.
pub const LARGEST: i128 = 1_000;

/// Which kind an exponent is. `whole` says of a name whether it stands for whole numbers: a natural variable, an index
/// of a sum, product or sequence, or a natural family.
pub fn exponent(e: &Expr, whole: &dyn Fn(&str) -> bool) -> Exponent {
    match number(e) {
        Some((_, 1)) => Exponent::Whole,
        Some((top, _)) if top > 0 => Exponent::Root,
        Some(_) => Exponent::Real,
        None if is_whole(e, whole) => Exponent::Whole,
        None => Exponent::Real,
    }
}

/// The conditions of a node; those of its parts are theirs.
pub fn needs(e: &Expr, whole: &dyn Fn(&str) -> bool) -> Vec<Need> {
    match &e.kind {
        ExprKind::Product(list) => list
            .iter()
            .filter(|(operator, _)| *operator == Factor::Over)
            .map(|(_, divisor)| Need::NotZero(divisor.clone()))
            .collect(),
        ExprKind::Power(base, e) => {
            let base = (**base).clone();
            match (exponent(e, whole), number(e)) {
                (Exponent::Root, _) => vec![Need::NotNegative(base)],
                (Exponent::Real, _) => vec![Need::Positive(base)],
                (Exponent::Whole, Some((top, _))) if top < 0 => vec![Need::NotZero(base)],
                (Exponent::Whole, Some(_)) => Vec::new(),
                (Exponent::Whole, None) => vec![Need::NotZeroOrNatural(base, (**e).clone())],
            }
        }
        ExprKind::Apply(f, arguments) => match (f.text.as_str(), arguments.first()) {
            ("sqrt" | "cbrt", Some(a)) => vec![Need::NotNegative(a.clone())],
            ("ln", Some(a)) => vec![Need::Positive(a.clone())],
            _ => Vec::new(),
        },
        ExprKind::SumOver(index, _) | ExprKind::ProductOver(index, _) => {
            vec![Need::Range((*index.from).clone(), (*index.to).clone())]
        }
        ExprKind::Derivative(body, by) => match by.first() {
            Some(name) => vec![Need::Differentiable((**body).clone(), name.clone(), by.len())],
            None => Vec::new(),
        },
        ExprKind::Number(_) | ExprKind::Name(_) | ExprKind::Negate(_) | ExprKind::Sum(_) | ExprKind::Matrix(_) => {
            Vec::new()
        }
    }
}

/// Whether an expression is a whole number by its form: made of whole numbers, natural variables, indices and members
/// of natural families by adding, subtracting and multiplying, and by powers to a natural numeral.
pub fn is_whole(e: &Expr, whole: &dyn Fn(&str) -> bool) -> bool {
    if let Some((_, below)) = number(e) {
        return below == 1;
    }
    match &e.kind {
        // A numeral too long to be computed here.
        ExprKind::Number(text) => text.bytes().all(|b| b.is_ascii_digit()),
        ExprKind::Name(name) => whole(name),
        ExprKind::Apply(f, _) => whole(&f.text),
        ExprKind::Negate(a) => is_whole(a, whole),
        ExprKind::Sum(list) => list.iter().all(|(_, a)| is_whole(a, whole)),
        ExprKind::Product(list) => list.iter().all(|(f, a)| *f == Factor::Times && is_whole(a, whole)),
        ExprKind::Power(a, b) => is_whole(a, whole) && matches!(number(b), Some((0.., 1))),
        _ => false,
    }
}

/// Whether it is, and no minus sign stands in it: at least 0 by its form. `natural` then speaks of names that stand for
/// no negative number.
pub(crate) fn is_natural(e: &Expr, natural: &dyn Fn(&str) -> bool) -> bool {
    if let Some(value) = number(e) {
        return matches!(value, (0.., 1));
    }
    match &e.kind {
        ExprKind::Sum(list) => list.iter().all(|(s, a)| *s == Sign::Plus && is_natural(a, natural)),
        ExprKind::Product(list) => list.iter().all(|(f, a)| *f == Factor::Times && is_natural(a, natural)),
        ExprKind::Power(a, b) => is_natural(a, natural) && matches!(number(b), Some((0.., 1))),
        ExprKind::Number(_) | ExprKind::Name(_) | ExprKind::Apply(..) => is_whole(e, natural),
        _ => false,
    }
}

/// The value of an expression of numerals alone, where it is short enough.
pub fn number(e: &Expr) -> Option<Number> {
    match &e.kind {
        ExprKind::Number(text) => numeral(text),
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
            let size = u32::try_from(k.checked_abs().filter(|k| *k <= LARGEST)?).ok()?;
            let (a, b) = (a.checked_pow(size)?, b.checked_pow(size)?);
            if k < 0 { reduced(b, a) } else { reduced(a, b) }
        }
        _ => None,
    }
}

/// A numeral as written: digits, perhaps with a point and a decimal exponent.
fn numeral(text: &str) -> Option<Number> {
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let (whole, part) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits: i128 = format!("{whole}{part}").parse().ok()?;
    let exponent = exponent.parse::<i32>().ok()?.checked_sub(i32::try_from(part.len()).ok()?)?;
    let power = 10i128.checked_pow(exponent.unsigned_abs())?;
    if exponent < 0 { reduced(digits, power) } else { reduced(digits.checked_mul(power)?, 1) }
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
