//! A real number that is computed only as far as a question needs.
//!
//! **Contract.** A [`Real`] is an exact rational, or a number that its maker knows to be *irrational* (or a
//! rational too long to write down, which is then no short decimal), with a function that encloses it at any
//! precision. That knowledge is what makes every question end: a rational is compared exactly, and an
//! irrational number is neither zero nor a decimal nor half-way between two decimals, so enclosures that
//! shrink to it settle its sign and each of its digits. The theorem that tells the two apart stands in
//! `src/physics/chain`.
//!
//! **Method.** [`Real::settle`] is the only refinement loop of the crate: double-double first, then intervals
//! of ever more bits up to [`MAX_BITS`] (beyond it an error, never a best effort).

use super::NumberError;
use super::fraction::Fraction;
use super::interval::Interval;
use malachite::base::num::arithmetic::traits::Sign;
use malachite::{Integer, Rational};
use std::cmp::Ordering;
use std::fmt;
use std::sync::LazyLock;
use std::sync::atomic::{AtomicU32, Ordering as Memory};

/// The most bits of an enclosure: about forty million decimal digits.
pub const MAX_BITS: u64 = 1 << 27;

/// The first precision above double-double.
pub const FIRST_BITS: u64 = 128;

/// Questions that need more relative accuracy than this skip double-double.
const DOUBLE_BITS: u64 = 90;

/// The level of arithmetic at which a question was settled.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Level {
    /// Double-double.
    Double,
    /// Intervals of so many bits.
    Interval(u64),
    /// Exact arithmetic.
    Exact,
}

impl fmt::Display for Level {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Double => write!(f, "double"),
            Self::Interval(bits) => write!(f, "interval:{bits}"),
            Self::Exact => write!(f, "exact"),
        }
    }
}

type Enclose = Box<dyn Fn(u64) -> Interval + Send + Sync>;
/// A closed form as text, made when somebody asks for it.
type Radical = LazyLock<String, Box<dyn FnOnce() -> String + Send>>;
type Quick = Box<dyn Fn() -> Option<Interval> + Send + Sync>;

/// What is known about the number.
enum Form {
    Rational(Rational),
    Enclosed { quick: Option<Quick>, enclose: Enclose },
}

/// A real number, exact or enclosed at any precision.
pub struct Real {
    form: Form,
    radical: Option<Radical>,
    attempts: AtomicU32,
}

impl fmt::Debug for Real {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (&self.form, &self.radical) {
            (Form::Rational(x), _) => write!(f, "Real({x})"),
            (_, Some(text)) => write!(f, "Real({})", text.as_str()),
            _ => write!(f, "Real(enclosed)"),
        }
    }
}

impl Real {
    /// A rational number.
    #[must_use]
    pub fn rational(x: Rational) -> Real {
        Real { form: Form::Rational(x), radical: None, attempts: AtomicU32::new(0) }
    }

    /// A fraction: a rational where it has at most `written` bits or is a decimal, otherwise enclosed by its leading digits,
    /// which spares malachite's greatest common divisor.
    #[must_use]
    pub fn fraction(x: Fraction, written: u64) -> Real {
        if x.bits() <= written || x.is_decimal() {
            return Real::rational(x.into());
        }
        let (numerator, denominator) = x.into_parts();
        let denominator = Integer::from(denominator);
        Real::enclosed(move |bits| {
            let leading = |x: &Integer| Interval::from_integer(x.clone()).round(bits + 8);
            leading(&numerator).divide(&leading(&denominator), bits + 2)
        })
    }

    /// A number known to be irrational, or too long a rational to be a short decimal: `enclose(bits)` contains
    /// it with about that many bits of relative accuracy, and shrinks to it as the bits grow.
    #[must_use]
    pub fn enclosed(enclose: impl Fn(u64) -> Interval + Send + Sync + 'static) -> Real {
        Real {
            form: Form::Enclosed { quick: None, enclose: Box::new(enclose) },
            radical: None,
            attempts: AtomicU32::new(0),
        }
    }

    /// Adds an enclosure from double-double arithmetic, which is tried first.
    #[must_use]
    pub fn with_quick(mut self, found: impl Fn() -> Option<Interval> + Send + Sync + 'static) -> Real {
        if let Form::Enclosed { quick, .. } = &mut self.form {
            *quick = Some(Box::new(found));
        }
        self
    }

    /// Adds the closed form, for readers: it is written where it is asked for.
    #[must_use]
    pub fn with_radical(mut self, text: impl FnOnce() -> String + Send + 'static) -> Real {
        self.radical = Some(LazyLock::new(Box::new(text)));
        self
    }

    /// The number, where it is a rational that is short enough to be written down.
    #[must_use]
    pub fn as_rational(&self) -> Option<&Rational> {
        match &self.form {
            Form::Rational(x) => Some(x),
            Form::Enclosed { .. } => None,
        }
    }

    /// The closed form where there is no rational and one is known.
    #[must_use]
    pub fn radical(&self) -> Option<&str> {
        self.radical.as_ref().filter(|_| self.as_rational().is_none()).map(|text| text.as_str())
    }

    /// How many enclosures were computed so far.
    #[must_use]
    pub fn attempts(&self) -> u32 {
        self.attempts.load(Memory::Relaxed)
    }

    /// An enclosure with about the given relative accuracy in bits, by intervals.
    #[must_use]
    pub fn enclosure(&self, bits: u64) -> Interval {
        match &self.form {
            Form::Rational(x) => Interval::from_rational(x, bits + 2),
            Form::Enclosed { enclose, .. } => {
                self.attempts.fetch_add(1, Memory::Relaxed);
                enclose(bits)
            }
        }
    }

    /// Asks ever narrower enclosures until one answers; `bits` says from which accuracy an answer is likely.
    ///
    /// A rational is asked as well, from its enclosures: a question about its exact value goes to
    /// [`Real::as_rational`] first.
    ///
    /// # Errors
    /// [`NumberError::LimitReached`] where [`MAX_BITS`] do not settle it.
    pub fn settle<T>(&self, bits: u64, mut ask: impl FnMut(&Interval) -> Option<T>) -> Result<(T, Level), NumberError> {
        if bits <= DOUBLE_BITS
            && let Form::Enclosed { quick: Some(quick), .. } = &self.form
        {
            self.attempts.fetch_add(1, Memory::Relaxed);
            if let Some(answer) = quick().as_ref().and_then(&mut ask) {
                return Ok((answer, Level::Double));
            }
        }
        let mut bits = bits.max(FIRST_BITS);
        while bits <= MAX_BITS {
            if let Some(answer) = ask(&self.enclosure(bits)) {
                return Ok((answer, Level::Interval(bits)));
            }
            bits = bits.saturating_mul(2);
        }
        Err(NumberError::LimitReached { limit: "bits of an enclosure", allowed: MAX_BITS, needed: bits.to_string() })
    }

    /// The sign, exactly.
    ///
    /// # Errors
    /// [`NumberError::LimitReached`].
    pub fn sign(&self) -> Result<(Ordering, Level), NumberError> {
        match &self.form {
            Form::Rational(x) => Ok((x.sign(), Level::Exact)),
            Form::Enclosed { .. } => self.settle(0, Interval::sign),
        }
    }

    /// The greatest double not above the number and the least one not below it, infinite where need be: the same
    /// where the number is a double.
    ///
    /// # Errors
    /// [`NumberError::LimitReached`].
    pub fn neighbours(&self) -> Result<(f64, f64), NumberError> {
        // Ends that round outwards to the same double are that double; it lies between two others otherwise.
        let narrow = |x: &Interval| Some(x.to_f64_ends()).filter(|(lo, hi)| lo.next_up() >= *hi);
        match &self.form {
            // Its enclosure is exact where it is a double: 53 bits, and shifts.
            Form::Rational(_) => {
                narrow(&self.enclosure(FIRST_BITS)).map_or_else(|| self.settle(FIRST_BITS, narrow).map(|x| x.0), Ok)
            }
            Form::Enclosed { .. } => self.settle(FIRST_BITS / 2, narrow).map(|x| x.0),
        }
    }

    /// An enclosure of at least the given relative accuracy in bits.
    ///
    /// # Errors
    /// [`NumberError::LimitReached`].
    pub fn with_accuracy(&self, bits: u64) -> Result<(Interval, Level), NumberError> {
        if let Form::Rational(x) = &self.form {
            return Ok((Interval::from_rational(x, bits + 2), Level::Exact));
        }
        self.settle(bits, |x| (x.accuracy() >= bits).then(|| x.clone()))
    }
}
