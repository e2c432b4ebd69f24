//! Expressions and propositions at exact points.
//!
//! Contract: a value is exact, or an interval that contains it; a truth value is given only when it is
//! certain. *Undefined* means that the expression has no value at the point; *unknown* that intervals
//! do not decide. Neither is ever taken for false.
//!
//! Roots of numbers that are no perfect powers become intervals of relative width 2^−[`PRECISION`].

use super::closed::Closed;
use super::expand::Sequence;
use crate::claim::definedness::{self, Exponent};
use crate::claim::syntax::*;
use crate::number::{elementary, rational};
use malachite::base::num::arithmetic::traits::{FloorRoot, Pow};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::conversion::traits::IsInteger;
use malachite::base::num::logic::traits::SignificantBits;
use malachite::{Integer, Rational};
use rustc_hash::{FxHashMap as HashMap, FxHashSet as HashSet};
use std::borrow::Cow;
use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
use std::rc::Rc;

/// Bits kept of the ends of intervals.
pub const PRECISION: u64 = 192;

/// The largest exponent and index that is evaluated.
pub const LARGEST: i64 = 400;

/// How many expressions are evaluated at one point.
pub const STEPS: u32 = 100_000;

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
    /// There is none at this point; the text says where.
    Undefined(String),
    /// It is not found by these means.
    Unknown,
}

type Result<T> = std::result::Result<T, Missing>;

/// A point: values of variables and of members of families.
#[derive(Clone, Debug)]
pub struct Assignment {
    /// Variables.
    pub values: HashMap<String, Rational>,
    /// Bound indices: they hide variables in what they bind, but not in the definitions of sequences and ranges.
    pub indices: HashMap<String, Rational>,
    /// Variables and families that are natural numbers by their declaration.
    pub naturals: Rc<HashSet<String>>,
    /// Families: the values that members take in turn.
    pub families: HashMap<String, Vec<Rational>>,
    /// Families that are geometric: the ratio of a member to the one before it; the first of the
    /// family's values is member 0.
    pub ratios: HashMap<String, Rational>,
    /// Pairs of expressions, as printed, that are known to be equal wherever both have values.
    pub identities: Rc<HashSet<(String, String)>>,
    /// Sequences.
    pub sequences: BTreeMap<String, Sequence>,
    /// Index ranges of families: first and last.
    pub ranges: HashMap<String, (Expr, Expr)>,
    /// The members that were looked up.
    pub seen: RefCell<BTreeMap<(String, i64), Rational>>,
    /// How many expressions may still be evaluated, here and in copies of the point.
    pub steps: Rc<Cell<u32>>,
}

impl Default for Assignment {
    fn default() -> Assignment {
        Assignment {
            values: HashMap::default(),
            indices: HashMap::default(),
            naturals: Rc::default(),
            families: HashMap::default(),
            ratios: HashMap::default(),
            identities: Rc::default(),
            sequences: BTreeMap::new(),
            ranges: HashMap::default(),
            seen: RefCell::default(),
            steps: Rc::new(Cell::new(STEPS)),
        }
    }
}

/// A scalar or a matrix of numbers.
enum Value {
    Scalar(Number),
    Matrix(Vec<Vec<Number>>),
}

impl Number {
    fn ends(&self) -> (&Rational, &Rational) {
        match self {
            Number::Exact(q) => (q, q),
            Number::Between(a, b, _) => (a, b),
        }
    }

    /// Its closed form.
    fn closed(&self) -> Option<Cow<'_, Closed>> {
        match self {
            Number::Exact(q) => Some(Cow::Owned(Closed::rational(q))),
            Number::Between(_, _, form) => form.as_deref().map(Cow::Borrowed),
        }
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

    /// p/q, or a decimal enough to tell the number from its neighbours.
    pub fn text(&self) -> String {
        match self {
            Number::Exact(q) => q.to_string(),
            Number::Between(a, b, _) => {
                let middle = (a + b) / Rational::from(2);
                let value = f64_text(&middle);
                format!("{value}...")
            }
        }
    }
}

/// A few digits, cut off rather than rounded.
fn f64_text(q: &Rational) -> String {
    let scale = Rational::from(10).pow(12i64);
    let (negative, size) = if *q < 0 { (true, -q) } else { (false, q.clone()) };
    let digits = malachite::base::num::arithmetic::traits::Floor::floor(size * scale).to_string();
    let padded = format!("{digits:0>13}");
    let (whole, part) = padded.split_at(padded.len() - 12);
    format!("{}{whole}.{part}", if negative { "-" } else { "" })
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

fn between(a: Rational, b: Rational) -> Number {
    if a == b { Number::Exact(a) } else { Number::Between(rounded(&a, false), rounded(&b, true), None) }
}

/// The number, or an enclosure where it is too long.
fn exact(q: Rational) -> Number {
    if q.significant_bits() > EXACT_BITS {
        Number::Between(rounded(&q, false), rounded(&q, true), None)
    } else {
        Number::Exact(q)
    }
}

/// The number, unless its ends are too long, which rounding does not mend for the very large and the very small.
fn of_some_size(x: Number) -> Result<Number> {
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

fn whole_power(a: &Number, k: u64) -> Result<Number> {
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
fn root(a: &Number, k: u64) -> Number {
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
fn large_power(a: &Number, p: i64, negative: bool, text: impl Fn() -> String) -> Result<Number> {
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

/// cosh, sinh, tanh or sech of a.
fn hyperbolic(name: &str, a: &Number) -> Result<Number> {
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

impl Assignment {
    /// The value of a scalar expression.
    pub fn number(&self, e: &Expr) -> Result<Number> {
        match self.value(e)? {
            Value::Scalar(number) => Ok(number),
            Value::Matrix(_) => Err(Missing::Unknown),
        }
    }

    fn value(&self, e: &Expr) -> Result<Value> {
        use ExprKind::*;
        match self.steps.get().checked_sub(1) {
            Some(left) => self.steps.set(left),
            None => return Err(Missing::Unknown),
        }
        Ok(Value::Scalar(match &e.kind {
            Number(text) => self::Number::Exact(rational::parse(text).map_err(|_| Missing::Unknown)?),
            Name(name) => {
                let value = self.indices.get(name).or_else(|| self.values.get(name));
                self::Number::Exact(value.cloned().ok_or(Missing::Unknown)?)
            }
            Negate(a) => match self.value(a)? {
                Value::Scalar(a) => negate(&a),
                Value::Matrix(rows) => {
                    return Ok(Value::Matrix(rows.iter().map(|r| r.iter().map(negate).collect()).collect()));
                }
            },
            Sum(list) => {
                let mut sum: Option<Value> = None;
                for (sign, summand) in list {
                    let flip = |n: self::Number| if *sign == Sign::Plus { n } else { negate(&n) };
                    let value = match self.value(summand)? {
                        Value::Scalar(n) => Value::Scalar(flip(n)),
                        Value::Matrix(rows) => {
                            Value::Matrix(rows.into_iter().map(|r| r.into_iter().map(flip).collect()).collect())
                        }
                    };
                    sum = Some(match (sum, value) {
                        (None, value) => value,
                        (Some(Value::Scalar(a)), Value::Scalar(b)) => Value::Scalar(of_some_size(add(&a, &b))?),
                        (Some(Value::Matrix(a)), Value::Matrix(b)) if !same_size(&a, &b) => {
                            return Err(Missing::Unknown);
                        }
                        (Some(Value::Matrix(a)), Value::Matrix(b)) => Value::Matrix(
                            a.iter().zip(&b).map(|(r, s)| r.iter().zip(s).map(|(x, y)| add(x, y)).collect()).collect(),
                        ),
                        _ => return Err(Missing::Unknown),
                    });
                }
                return sum.ok_or(Missing::Unknown);
            }
            Product(list) => {
                let mut product = Value::Scalar(self::Number::Exact(Rational::ONE));
                for (operator, factor) in list {
                    let value = self.value(factor)?;
                    product = match (product, value) {
                        (Value::Scalar(a), Value::Scalar(b)) => {
                            let b = if *operator == Factor::Over {
                                invert(&b, || crate::claim::print::expr(factor))?
                            } else {
                                b
                            };
                            Value::Scalar(of_some_size(multiply(&a, &b))?)
                        }
                        (Value::Matrix(m), Value::Scalar(b)) | (Value::Scalar(b), Value::Matrix(m)) => {
                            let b = if *operator == Factor::Over {
                                invert(&b, || crate::claim::print::expr(factor))?
                            } else {
                                b
                            };
                            Value::Matrix(m.iter().map(|r| r.iter().map(|x| multiply(x, &b)).collect()).collect())
                        }
                        (Value::Matrix(a), Value::Matrix(b)) => {
                            if a[0].len() != b.len() {
                                return Err(Missing::Unknown);
                            }
                            let cell = |row: &Vec<self::Number>, j: usize| {
                                row.iter().zip(&b).fold(self::Number::Exact(Rational::ZERO), |sum, (x, r)| {
                                    add(&sum, &multiply(x, &r[j]))
                                })
                            };
                            Value::Matrix(a.iter().map(|row| (0..b[0].len()).map(|j| cell(row, j)).collect()).collect())
                        }
                    };
                }
                return Ok(product);
            }
            Power(a, b) => {
                let kind = definedness::exponent(b, &|name| self.is_natural_name(name));
                self.power(&self.number(a)?, &self.number(b)?, kind, e)?
            }
            Apply(name, arguments) => return self.apply(name, arguments, e),
            SumOver(index, body) | ProductOver(index, body) => {
                let is_sum = matches!(&e.kind, SumOver(..));
                let (from, to) = (self.whole(&index.from)?, self.whole(&index.to)?);
                let Some(length) = to.checked_sub(from) else { return Err(Missing::Unknown) };
                if length < -1 {
                    return Err(Missing::Undefined(format!("the range of {} ends before it begins", index.name.text)));
                }
                if length > LARGEST {
                    return Err(Missing::Unknown);
                }
                let mut total = self::Number::Exact(if is_sum { Rational::ZERO } else { Rational::ONE });
                for k in from..=to {
                    let mut inner = self.clone();
                    inner.indices.insert(index.name.text.clone(), Rational::from(k));
                    let value = inner.number(body)?;
                    self.seen.borrow_mut().extend(inner.seen.into_inner());
                    total = of_some_size(if is_sum { add(&total, &value) } else { multiply(&total, &value) })?;
                }
                total
            }
            // A derivative has no value where what is differentiated has none.
            Derivative(body, _) => return self.value(body).and(Err(Missing::Unknown)),
            Matrix(rows) => {
                let rows: Result<Vec<Vec<self::Number>>> =
                    rows.iter().map(|r| r.iter().map(|x| self.number(x)).collect()).collect();
                return Ok(Value::Matrix(rows?));
            }
        }))
    }

    fn whole(&self, e: &Expr) -> Result<i64> {
        match self.number(e)? {
            Number::Exact(q) => i64::try_from(&q).map_err(|_| match (&q).is_integer() {
                true => Missing::Unknown,
                false => Missing::Undefined(format!("{} is no whole number", crate::claim::print::expr(e))),
            }),
            Number::Between(..) => Err(Missing::Unknown),
        }
    }

    pub(super) fn power(&self, a: &Number, b: &Number, kind: Exponent, e: &Expr) -> Result<Number> {
        let text = || crate::claim::print::expr(e);
        let (low, high) = a.ends();
        let missing = match kind {
            Exponent::Whole => false,
            Exponent::Root => *high < 0,
            Exponent::Real => *high <= 0,
        };
        if missing {
            let wanted = if kind == Exponent::Root { "at least 0" } else { "above 0" };
            return Err(Missing::Undefined(format!("{} has a value only where the base is {wanted}", text())));
        }
        if kind != Exponent::Whole && (*low < 0 || kind == Exponent::Real && *low == 0) {
            return Err(Missing::Unknown);
        }
        let Number::Exact(q) = b else {
            // a^b = exp(b·ln a) for a > 0.
            if *a.ends().0 <= 0 {
                return Err(Missing::Unknown);
            }
            return exponential(&multiply(b, &logarithm(a, text)?));
        };
        let (Ok(p), Ok(k)) =
            (i64::try_from(&Integer::from(q.numerator_ref())), i64::try_from(&Integer::from(q.denominator_ref())))
        else {
            return Err(Missing::Unknown);
        };
        if k == 1 && p.unsigned_abs() > LARGEST.unsigned_abs() {
            return large_power(a, p, *q < 0, text);
        }
        if p.unsigned_abs() > LARGEST.unsigned_abs() || k > LARGEST {
            return Err(Missing::Unknown);
        }
        let base = if k == 1 { a.clone() } else { root(a, k.unsigned_abs()) };
        let power = whole_power(&base, p.unsigned_abs())?;
        if *q < 0 { invert(&power, text) } else { Ok(power) }
    }

    /// Whether a name stands for natural numbers: a variable, an index, or a family of them.
    fn is_natural_name(&self, name: &str) -> bool {
        self.indices.contains_key(name) || self.naturals.contains(name)
    }

    fn apply(&self, name: &Name, arguments: &[Expr], e: &Expr) -> Result<Value> {
        let text = name.text.as_str();
        if matches!(text, "det" | "transpose") {
            let Some(Value::Matrix(m)) = arguments.first().map(|a| self.value(a)).transpose()? else {
                return Err(Missing::Unknown);
            };
            if text == "transpose" {
                return Ok(Value::Matrix((0..m[0].len()).map(|j| m.iter().map(|r| r[j].clone()).collect()).collect()));
            }
            return match m.as_slice() {
                [a, b] if a.len() == 2 => {
                    let down = multiply(&a[0], &b[1]);
                    let up = multiply(&a[1], &b[0]);
                    Ok(Value::Scalar(add(&down, &negate(&up))))
                }
                _ => Err(Missing::Unknown),
            };
        }
        let argument = arguments.first().ok_or(Missing::Unknown)?;
        let half = |k: i64| Number::Exact(Rational::from_signeds(1, k));
        Ok(Value::Scalar(match text {
            "sqrt" => self.power(&self.number(argument)?, &half(2), Exponent::Root, e)?,
            "cbrt" => self.power(&self.number(argument)?, &half(3), Exponent::Root, e)?,
            "exp" => exponential(&self.number(argument)?)?,
            "ln" => logarithm(&self.number(argument)?, || crate::claim::print::expr(e))?,
            "cosh" | "sinh" | "tanh" | "sech" => hyperbolic(text, &self.number(argument)?)?,
            _ => {
                let index = self.whole(argument)?;
                if index < 0 {
                    return Err(Missing::Undefined(format!("{} has no member {index}", name.text)));
                }
                if let Some((from, to)) = self.ranges.get(text)
                    && let point = self.without_indices()
                    && !(point.whole(from)? <= index && index <= point.whole(to)?)
                {
                    return Err(Missing::Undefined(format!("{text}({index}) lies outside the range of {text}")));
                }
                if index > LARGEST {
                    return Err(Missing::Unknown);
                }
                if let (Some(list), Some(ratio)) = (self.families.get(text), self.ratios.get(text)) {
                    let value = list.first().ok_or(Missing::Unknown)? * ratio.pow(index);
                    self.seen.borrow_mut().insert((name.text.clone(), index), value.clone());
                    Number::Exact(value)
                } else if let Some(list) = self.families.get(text) {
                    let place = usize::try_from(index).unwrap_or(0) % list.len().max(1);
                    let value = list.get(place).cloned().ok_or(Missing::Unknown)?;
                    self.seen.borrow_mut().insert((name.text.clone(), index), value.clone());
                    Number::Exact(value)
                } else if let Some(sequence) = self.sequences.get(text).cloned() {
                    self.member(&sequence, index)?
                } else {
                    return Err(Missing::Unknown);
                }
            }
        }))
    }

    /// The point as definitions see it: the claim's variables alone.
    fn without_indices(&self) -> Assignment {
        Assignment { indices: HashMap::default(), ..self.clone() }
    }

    /// u(k), each member evaluated once: the step may mention the member before it, which is bound
    /// as a value of its own.
    fn member(&self, sequence: &Sequence, index: i64) -> Result<Number> {
        if !sequence.steps_once() {
            return Err(Missing::Unknown);
        }
        let outer = self.without_indices();
        let mut value = outer.number(&sequence.initial)?;
        self.seen.borrow_mut().extend(outer.seen.take());
        for k in 0..index {
            let Number::Exact(known) = &value else { return Err(Missing::Unknown) };
            let mut inner = outer.clone();
            inner.indices.insert(sequence.index.clone(), Rational::from(k));
            inner.sequences.remove(&sequence.name);
            inner.families.insert(sequence.name.clone(), vec![known.clone()]);
            value = inner.number(&sequence.step)?;
            let seen = inner.seen.into_inner();
            self.seen.borrow_mut().extend(seen.into_iter().filter(|s| s.0.0 != sequence.name));
        }
        Ok(value)
    }

    /// Whether a side of some comparison certainly has no value.
    pub fn undefined(&self, prop: &Prop) -> bool {
        match &prop.kind {
            PropKind::Compare(sides, _) => sides.iter().any(|e| matches!(self.value(e), Err(Missing::Undefined(_)))),
            PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => {
                list.iter().any(|p| self.undefined(p))
            }
            PropKind::Not(p) => self.undefined(p),
            PropKind::Implies(p, q) => self.undefined(p) || self.undefined(q),
            _ => false,
        }
    }

    /// The truth of a proposition, if certain. Quantifiers and extrema are not decided here.
    pub fn truth(&self, prop: &Prop) -> Result<bool> {
        match &prop.kind {
            PropKind::Compare(sides, relations) => {
                let values: Vec<Value> = sides.iter().map(|e| self.value(e)).collect::<Result<_>>()?;
                let mut unknown = false;
                for (place, (pair, relation)) in values.windows(2).zip(relations).enumerate() {
                    match (&pair[0], &pair[1]) {
                        (Value::Scalar(_), Value::Scalar(_)) if self.identical(&sides[place], &sides[place + 1]) => {
                            if !matches!(relation, Relation::Equal | Relation::LessEqual | Relation::GreaterEqual) {
                                return Ok(false);
                            }
                        }
                        (Value::Scalar(a), Value::Scalar(b)) => match holds(a, *relation, b) {
                            Some(false) => return Ok(false),
                            Some(true) => {}
                            None => unknown = true,
                        },
                        (Value::Matrix(a), Value::Matrix(b)) => {
                            let sizes = |m: &Vec<Vec<Number>>| m.iter().map(Vec::len).collect::<Vec<_>>();
                            if sizes(a) != sizes(b) || !matches!(relation, Relation::Equal | Relation::NotEqual) {
                                return Err(Missing::Unknown);
                            }
                            let entries = a.iter().flatten().zip(b.iter().flatten());
                            let same: Vec<Option<bool>> = entries.map(|(x, y)| holds(x, Relation::Equal, y)).collect();
                            // Equal where all entries are, different where one is.
                            let equal = match () {
                                () if same.contains(&Some(false)) => Some(false),
                                () if same.contains(&None) => None,
                                () => Some(true),
                            };
                            match equal.map(|equal| equal == (*relation == Relation::Equal)) {
                                Some(false) => return Ok(false),
                                Some(true) => {}
                                None => unknown = true,
                            }
                        }
                        _ => return Err(Missing::Unknown),
                    }
                }
                if unknown { Err(Missing::Unknown) } else { Ok(true) }
            }
            PropKind::And(list) => {
                let mut unknown = None;
                for part in list {
                    match self.truth(part) {
                        Ok(false) => return Ok(false),
                        Ok(true) => {}
                        Err(missing) => unknown = Some(missing),
                    }
                }
                unknown.map_or(Ok(true), Err)
            }
            PropKind::Or(list) => {
                let (mut unknown, mut holds) = (None, false);
                for part in list {
                    match self.truth(part) {
                        Ok(truth) => holds |= truth,
                        // Whether a part without a value spoils the others is a matter of taste: nothing rests on it.
                        Err(missing) => unknown = Some(missing),
                    }
                }
                match unknown {
                    Some(Missing::Undefined(_)) if holds => Err(Missing::Unknown),
                    Some(missing) if !holds => Err(missing),
                    _ => Ok(holds),
                }
            }
            PropKind::Not(inner) => Ok(!self.truth(inner)?),
            PropKind::Implies(p, q) => {
                if self.truth(p)? {
                    self.truth(q)
                } else {
                    Ok(true)
                }
            }
            PropKind::Equivalent(list) => {
                let first = list.first().map_or(Ok(true), |p| self.truth(p))?;
                for part in &list[1..] {
                    if self.truth(part)? != first {
                        return Ok(false);
                    }
                }
                Ok(true)
            }
            PropKind::ForAll(bindings, body) => self.for_all_indices(bindings, body),
            _ => Err(Missing::Unknown),
        }
    }

    fn identical(&self, a: &Expr, b: &Expr) -> bool {
        !self.identities.is_empty()
            && self.identities.contains(&(crate::claim::print::expr(a), crate::claim::print::expr(b)))
    }

    /// `for all k natural: P` where every family is constant and k stands in indices only: then P does
    /// not depend on k, and one value decides.
    fn for_all_indices(&self, bindings: &[Binding], body: &Prop) -> Result<bool> {
        let [Binding { names, natural: true, constraints, indices: None, .. }] = bindings else {
            return Err(Missing::Unknown);
        };
        let constant = self.families.values().all(|list| list.iter().all(|q| *q == list[0]));
        let [(name, None)] = names.as_slice() else { return Err(Missing::Unknown) };
        // A member out of its range has no value.
        if !constraints.is_empty() || !self.ranges.is_empty() {
            return Err(Missing::Unknown);
        }
        if !self.ratios.is_empty() {
            return self.for_all_powers(body, &name.text);
        }
        if !constant || !self.only_index(body, &name.text) {
            return Err(Missing::Unknown);
        }
        let mut inner = self.clone();
        inner.indices.insert(name.text.clone(), Rational::ZERO);
        inner.truth(body)
    }

    /// `for all k natural: A = B` where families are geometric and both sides are products of powers
    /// of members with indices k + c: then A = a·ρ^k and B = b·σ^k, equal for all k if for 0 and 1.
    fn for_all_powers(&self, body: &Prop, name: &str) -> Result<bool> {
        fn monomial(point: &Assignment, e: &Expr, index: &str) -> bool {
            match &e.kind {
                ExprKind::Name(n) => n != index,
                ExprKind::Number(_) => true,
                ExprKind::Apply(f, list) => point.ratios.contains_key(&f.text) && list.iter().all(shifted),
                ExprKind::Product(list) => list.iter().all(|(_, a)| monomial(point, a, index)),
                ExprKind::Power(a, b) => monomial(point, a, index) && matches!(b.kind, ExprKind::Number(_)),
                _ => false,
            }
        }
        let PropKind::Compare(sides, relations) = &body.kind else { return Err(Missing::Unknown) };
        let fine = relations.iter().all(|r| *r == Relation::Equal) && sides.iter().all(|e| monomial(self, e, name));
        for k in [0, 1] {
            let mut inner = self.clone();
            inner.indices.insert(name.to_string(), Rational::from(k));
            if !inner.truth(body)? {
                return Ok(false);
            }
        }
        if fine { Ok(true) } else { Err(Missing::Unknown) }
    }

    fn only_index(&self, prop: &Prop, name: &str) -> bool {
        fn inside(point: &Assignment, e: &Expr, name: &str) -> bool {
            match &e.kind {
                ExprKind::Name(n) => n != name,
                ExprKind::Apply(f, list) if point.families.contains_key(&f.text) => list.iter().all(shifted),
                _ => {
                    let mut fine = true;
                    super::expand::parts(e, &mut |part| fine &= inside(point, part, name));
                    fine
                }
            }
        }
        match &prop.kind {
            PropKind::Compare(sides, _) => sides.iter().all(|e| inside(self, e, name)),
            PropKind::And(list) | PropKind::Or(list) => list.iter().all(|p| self.only_index(p, name)),
            _ => false,
        }
    }

    /// The comparisons that fail in a false proposition, with both sides.
    pub fn broken(&self, prop: &Prop, into: &mut Vec<super::outcome::Broken>) {
        match &prop.kind {
            PropKind::Compare(sides, relations) => {
                for (pair, relation) in sides.windows(2).zip(relations) {
                    let single = Prop { kind: PropKind::Compare(pair.to_vec(), vec![*relation]), span: prop.span };
                    if let (Ok(a), Ok(b)) = (self.number(&pair[0]), self.number(&pair[1])) {
                        into.push(super::outcome::Broken {
                            statement: crate::claim::print::prop(&single),
                            left: a.text(),
                            right: b.text(),
                        });
                    }
                }
            }
            PropKind::And(list) => {
                for part in list.iter().filter(|p| self.truth(p) == Ok(false)) {
                    self.broken(part, into);
                }
            }
            PropKind::Or(list) | PropKind::Equivalent(list) => list.iter().for_each(|p| self.broken(p, into)),
            PropKind::Not(p) => self.broken(p, into),
            PropKind::Implies(p, q) => {
                self.broken(p, into);
                self.broken(q, into);
            }
            _ => {}
        }
    }
}

/// Whether two matrices have as many rows and columns.
fn same_size(a: &[Vec<Number>], b: &[Vec<Number>]) -> bool {
    a.iter().map(Vec::len).eq(b.iter().map(Vec::len))
}

/// Whether an index is a natural number for all natural values of what stands in it, if it is for one.
fn shifted(e: &Expr) -> bool {
    match &e.kind {
        ExprKind::Name(_) | ExprKind::Number(_) => true,
        ExprKind::Sum(list) => list.iter().all(|(sign, a)| *sign == Sign::Plus && shifted(a)),
        _ => false,
    }
}

/// Whether a comparison certainly holds or certainly fails.
fn holds(a: &Number, relation: Relation, b: &Number) -> Option<bool> {
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
