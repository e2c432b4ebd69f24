//! Isolation of real roots, and the sign of a univariate polynomial on an interval.
//!
//! Contract: [`Univariate::real_roots`] lists every distinct real root in increasing order, rational
//! ones as numbers, irrational ones as disjoint open intervals with rational ends that hold exactly
//! one root each. [`Univariate::sign_on`] decides the sign on an interval, zeros included, and shows
//! points of both signs where there are such.
//!
//! ```
//! use carom_exact::algebra::roots::{Interval, RealRoot, SignOn};
//! use carom_exact::algebra::{Polynomial, Univariate};
//! let x = Polynomial::variable(0);
//! let f = Univariate::from_polynomial(&(&(&x * &x) - &Polynomial::integer(4)), 0).expect("one variable");
//! assert_eq!(f.real_roots(), [RealRoot::Exact((-2).into()), RealRoot::Exact(2.into())]);
//! assert!(matches!(f.sign_on(&Interval::whole()), SignOn::Mixed { .. }));
//! ```
//!
//! Why it is right: Sturm counts for the square-free part without its rational roots; a rational
//! point of bisection is never one of the roots that are left. Between two neighbouring roots a
//! polynomial keeps its sign (intermediate value theorem), so one point between them decides.

use super::Univariate;
use super::univariate::SturmSequence;
use malachite::Rational;
use malachite::base::num::basic::traits::{One, Zero};
use malachite::rational::rational::arithmetic::traits::SimplestRationalInInterval;
use std::cmp::Ordering;

/// A real root.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum RealRoot {
    /// A rational root.
    Exact(Rational),
    /// An irrational root: the only root of the polynomial in the open interval, whose ends are not
    /// roots.
    Between(Rational, Rational),
}

impl RealRoot {
    /// The number itself, or the lower end of its interval.
    #[must_use]
    pub fn lower(&self) -> &Rational {
        match self {
            Self::Exact(x) | Self::Between(x, _) => x,
        }
    }

    /// The number itself, or the upper end of its interval.
    #[must_use]
    pub fn upper(&self) -> &Rational {
        match self {
            Self::Exact(x) | Self::Between(_, x) => x,
        }
    }
}

/// One end of an interval.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum End {
    /// There is no end on this side.
    Infinite,
    /// An end that does not belong to the interval.
    Open(Rational),
    /// An end that belongs to the interval.
    Closed(Rational),
}

impl End {
    /// The number at this end.
    #[must_use]
    pub fn value(&self) -> Option<&Rational> {
        match self {
            Self::Infinite => None,
            Self::Open(x) | Self::Closed(x) => Some(x),
        }
    }

    /// The number at this end where it belongs to the interval.
    fn closed(&self) -> Option<&Rational> {
        match self {
            Self::Closed(x) => Some(x),
            _ => None,
        }
    }
}

/// An interval of the real line.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Interval {
    /// The lower end.
    pub lower: End,
    /// The upper end.
    pub upper: End,
}

impl Interval {
    /// The whole line.
    #[must_use]
    pub fn whole() -> Self {
        Self { lower: End::Infinite, upper: End::Infinite }
    }

    /// Whether no number lies in it.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        match (&self.lower, &self.upper) {
            (End::Infinite, _) | (_, End::Infinite) => false,
            (End::Closed(a), End::Closed(b)) => a > b,
            (lower, upper) => lower.value() >= upper.value(),
        }
    }

    /// Whether a number lies in it.
    #[must_use]
    pub fn contains(&self, x: &Rational) -> bool {
        let above = match &self.lower {
            End::Infinite => true,
            End::Open(a) => a < x,
            End::Closed(a) => a <= x,
        };
        let below = match &self.upper {
            End::Infinite => true,
            End::Open(b) => x < b,
            End::Closed(b) => x <= b,
        };
        above && below
    }

    /// The condition on a variable of the given name, as text.
    #[must_use]
    pub fn display(&self, name: &str) -> String {
        let lower = match &self.lower {
            End::Infinite => String::new(),
            End::Open(a) => format!("{a} < "),
            End::Closed(a) => format!("{a} <= "),
        };
        let upper = match &self.upper {
            End::Infinite => String::new(),
            End::Open(b) => format!(" < {b}"),
            End::Closed(b) => format!(" <= {b}"),
        };
        if lower.is_empty() && upper.is_empty() {
            return format!("all real {name}");
        }
        format!("{lower}{name}{upper}")
    }
}

/// The sign of a polynomial on an interval; each variant is exact, none leaves room.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SignOn {
    /// The interval is empty.
    Empty,
    /// Zero everywhere.
    Zero,
    /// Greater than zero everywhere.
    Positive,
    /// Less than zero everywhere.
    Negative,
    /// At least zero, and zero somewhere, and positive somewhere.
    NonNegative,
    /// At most zero, and zero somewhere, and negative somewhere.
    NonPositive,
    /// Both signs occur.
    Mixed {
        /// A point of the interval where it is positive.
        positive: Rational,
        /// A point of the interval where it is negative.
        negative: Rational,
    },
}

impl Univariate {
    /// The number of distinct real roots.
    #[must_use]
    pub fn root_count(&self) -> usize {
        if self.is_zero() { 0 } else { self.sturm_sequence().count() }
    }

    /// The number of distinct roots in an interval; none of the zero polynomial.
    #[must_use]
    pub fn root_count_in(&self, interval: &Interval) -> usize {
        if self.is_zero() || interval.is_empty() {
            return 0;
        }
        let f = self.square_free_part();
        let sturm = f.sturm_sequence();
        // Sturm counts in (a, b]; the ends are put right by looking at them.
        let mut count = sturm.count_between(interval.lower.value(), interval.upper.value());
        if let Some(a) = interval.lower.closed() {
            count += usize::from(f.sign_at(a) == Ordering::Equal);
        }
        if let End::Open(b) = &interval.upper {
            count -= usize::from(f.sign_at(b) == Ordering::Equal);
        }
        count
    }

    /// All distinct real roots, increasing; none of the zero polynomial.
    #[must_use]
    pub fn real_roots(&self) -> Vec<RealRoot> {
        Isolation::of(self).roots
    }

    /// The sign on an interval.
    #[must_use]
    pub fn sign_on(&self, interval: &Interval) -> SignOn {
        if interval.is_empty() {
            return SignOn::Empty;
        }
        if self.is_zero() {
            return SignOn::Zero;
        }
        if let (End::Closed(a), End::Closed(b)) = (&interval.lower, &interval.upper)
            && a == b
        {
            return match self.sign_at(a) {
                Ordering::Greater => SignOn::Positive,
                Ordering::Equal => SignOn::Zero,
                Ordering::Less => SignOn::Negative,
            };
        }
        if let Some(sign) = self.sign_by_coefficients(interval) {
            return sign;
        }
        let mut isolation = Isolation::of(self);
        isolation.restrict(interval);
        let at_end = [interval.lower.closed(), interval.upper.closed()]
            .into_iter()
            .flatten()
            .any(|x| self.sign_at(x) == Ordering::Equal);
        let touches = at_end || !isolation.roots.is_empty();
        let points = isolation.points_between(interval);
        let with = |sign| points.iter().find(|x| self.sign_at(x) == sign).cloned();
        match (with(Ordering::Greater), with(Ordering::Less)) {
            (Some(positive), Some(negative)) => SignOn::Mixed { positive, negative },
            (Some(_), None) if touches => SignOn::NonNegative,
            (Some(_), None) => SignOn::Positive,
            (None, Some(_)) if touches => SignOn::NonPositive,
            (None, Some(_)) => SignOn::Negative,
            // A non-zero polynomial is not zero between its roots.
            (None, None) => SignOn::Zero,
        }
    }

    /// The sign on a part of `x ≥ 0` where all coefficients have one sign (Descartes).
    fn sign_by_coefficients(&self, interval: &Interval) -> Option<SignOn> {
        let lower = interval.lower.value()?;
        if *lower < Rational::ZERO || self.sign_variations() > 0 {
            return None;
        }
        let touches = interval.contains(&Rational::ZERO) && self.sign_at(&Rational::ZERO).is_eq();
        Some(match (self.sign_at_infinity(), touches) {
            (Ordering::Less, true) => SignOn::NonPositive,
            (Ordering::Less, false) => SignOn::Negative,
            (_, true) => SignOn::NonNegative,
            (_, false) => SignOn::Positive,
        })
    }
}

/// The roots of a polynomial with what is needed to refine them.
struct Isolation {
    roots: Vec<RealRoot>,
    /// The square-free part without the rational roots.
    irrational: Univariate,
}

impl Isolation {
    fn of(f: &Univariate) -> Self {
        if f.is_zero() {
            return Self { roots: Vec::new(), irrational: Univariate::default() };
        }
        let mut irrational = f.square_free_part();
        let rational = irrational.rational_roots();
        for root in &rational {
            irrational = irrational.without_root(root);
        }
        let mut roots = Vec::new();
        if irrational.degree() > 0 {
            let sturm = irrational.sturm_sequence();
            let bound = irrational.root_bound();
            bisect(&sturm, -&bound, bound, &mut roots);
        }
        let mut isolation = Self { roots, irrational };
        for root in &rational {
            isolation.exclude(root);
        }
        isolation.roots.extend(rational.into_iter().map(RealRoot::Exact));
        isolation.roots.sort_by(|a, b| a.lower().cmp(b.lower()).then(a.upper().cmp(b.upper())));
        isolation
    }

    /// Shrinks the irrational roots' intervals until the closed intervals do not hold `x`.
    fn exclude(&mut self, x: &Rational) {
        for root in &mut self.roots {
            if let RealRoot::Between(lower, upper) = root {
                let below = self.irrational.sign_at(lower);
                while &*lower <= x && x <= &*upper {
                    let middle = (&*lower + &*upper) >> 1u32;
                    if self.irrational.sign_at(&middle) == below {
                        *lower = middle;
                    } else {
                        *upper = middle;
                    }
                }
            }
        }
    }

    /// Keeps the roots strictly between the ends of an interval.
    fn restrict(&mut self, interval: &Interval) {
        for end in [&interval.lower, &interval.upper] {
            if let Some(x) = end.value() {
                self.exclude(x);
            }
        }
        self.roots.retain(|root| {
            interval.lower.value().is_none_or(|a| a < root.lower())
                && interval.upper.value().is_none_or(|b| root.upper() < b)
        });
    }

    /// One point before, between and after all roots, inside an interval that holds them all.
    fn points_between(&self, interval: &Interval) -> Vec<Rational> {
        let mut points = Vec::with_capacity(self.roots.len() + 1);
        let mut before = interval.lower.value();
        for root in &self.roots {
            points.push(point_between(before, Some(root.lower())));
            before = Some(root.upper());
        }
        points.push(point_between(before, interval.upper.value()));
        points
    }
}

/// A simple number strictly between two others, or the number itself where they are equal.
fn point_between(a: Option<&Rational>, b: Option<&Rational>) -> Rational {
    match (a, b) {
        (None, None) => Rational::ZERO,
        (Some(a), None) => a + Rational::ONE,
        (None, Some(b)) => b - Rational::ONE,
        (Some(a), Some(b)) if a < b => Rational::simplest_rational_in_open_interval(a, b),
        (Some(a), Some(_)) => a.clone(),
    }
}

/// Collects the isolating intervals inside `(a, b)`, whose ends are not roots, in increasing order.
fn bisect(sturm: &SturmSequence, a: Rational, b: Rational, roots: &mut Vec<RealRoot>) {
    let mut stack = vec![(a, b)];
    while let Some((a, b)) = stack.pop() {
        match sturm.count_between(Some(&a), Some(&b)) {
            0 => {}
            1 => roots.push(RealRoot::Between(a, b)),
            _ => {
                let middle = (&a + &b) >> 1u32;
                stack.push((middle.clone(), b));
                stack.push((a, middle));
            }
        }
    }
}
