//! Bodies on a line, checked once.
//!
//! Contract: a [`Line`] holds at least one body, from left to right, with positive masses and lengths that
//! are not negative; bodies may touch at the start but not overlap; each neighbouring pair, a wall included,
//! has a restitution in [0, 1]. Nothing below the constructor checks this again.
//!
//! A rod of length `l` is a point after a change of coordinates: subtract from each position half its own
//! length and the lengths of all rods to the left. Velocities, times and masses stay what they are, and so
//! does every contact. A wall is a body at rest that no collision can move (the limit of a growing mass): the
//! transfer matrix of a collision exists for it too, so walls need no separate rules.

use super::near::{Course, Shares};
use malachite::Rational;
use malachite::base::num::basic::traits::{One, Two, Zero};
use std::fmt;

/// The most bodies on a line.
pub const MAX_BODIES: usize = 1_000_000;

/// A body: a point, or a rod whose position is its middle.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Body {
    /// Its mass, positive.
    pub mass: Rational,
    /// Its position at time 0.
    pub position: Rational,
    /// Its velocity at time 0.
    pub velocity: Rational,
    /// Its length, 0 for a point.
    pub length: Rational,
}

/// A wall: it stands still whatever hits it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Wall {
    /// Where it stands.
    pub position: Rational,
    /// The restitution of a body that hits it.
    pub restitution: Rational,
}

/// Why a line cannot be replayed. Bodies count from 1; body 0 is the left wall, the one after the last body
/// the right wall.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum LineError {
    /// There is no body.
    Empty,
    /// More than [`MAX_BODIES`].
    TooMany {
        /// How many there are.
        bodies: usize,
    },
    /// A mass that is not positive.
    Mass {
        /// The body.
        body: usize,
    },
    /// A negative length.
    Length {
        /// The body.
        body: usize,
    },
    /// A body that overlaps its left neighbour, or lies to the left of it.
    Order {
        /// The body on the right.
        body: usize,
        /// The least position that it could have.
        least: Rational,
    },
    /// A restitution outside [0, 1].
    Restitution {
        /// The body on the left of the pair.
        left: usize,
    },
    /// Not one restitution for each pair of neighbouring bodies.
    Pairs {
        /// How many were given.
        given: usize,
        /// How many pairs there are.
        needed: usize,
    },
}

impl fmt::Display for LineError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty => write!(f, "there is no body on the line"),
            Self::TooMany { bodies } => write!(f, "limit reached: {bodies} bodies, {MAX_BODIES} allowed"),
            Self::Mass { body } => write!(f, "the mass of body {body} is not positive"),
            Self::Length { body } => write!(f, "the length of body {body} is negative"),
            Self::Order { body, least } => {
                write!(f, "body {body} overlaps its left neighbour: its position must be at least {least}")
            }
            Self::Restitution { left } => {
                write!(f, "the restitution between {left} and {} is outside [0, 1]", left + 1)
            }
            Self::Pairs { given, needed } => {
                write!(f, "{given} restitutions for {needed} pairs of neighbouring bodies")
            }
        }
    }
}

impl std::error::Error for LineError {}

/// A point of the line as the replay sees it: a body after the change of coordinates, or a wall.
#[derive(Clone, Debug)]
pub(super) struct Point {
    /// `None` for a wall.
    pub mass: Option<Rational>,
    pub position: Rational,
    pub velocity: Rational,
    /// What was subtracted from the position of the body.
    pub offset: Rational,
    /// Position and velocity in doubles.
    pub near: Course,
}

/// What a collision of neighbours does: `v_l' = v_l − left·(v_l − v_r)`, `v_r' = v_r + right·(v_l − v_r)`.
///
/// Source: Ricardo & Lee 2015, (5)–(7), with `left = (1+e)·m_r/(m_l+m_r)` and `right = (1+e)·m_l/(m_l+m_r)`.
/// A wall on the left has `left = 0, right = 1 + e`, the limit of a growing mass.
#[derive(Clone, Debug)]
pub(super) struct Pair {
    pub restitution: Rational,
    pub left: Rational,
    pub right: Rational,
    /// The transfer matrix in doubles.
    pub near: Shares,
}

/// Bodies between optional walls, valid by construction.
#[derive(Clone, Debug)]
pub struct Line {
    pub(super) points: Vec<Point>,
    pub(super) pairs: Vec<Pair>,
    /// The number that the first point is shown with: 0 for a wall, 1 for a body.
    pub(super) first: usize,
    half_lengths: Vec<Rational>,
    bodies: usize,
}

impl Line {
    /// Checks bodies from left to right, one restitution for each neighbouring pair, and the walls.
    ///
    /// ```
    /// use carom_physics::chain::replay::{Body, Line};
    /// use malachite::Rational;
    /// let body = |x: i32, v: i32| Body {
    ///     mass: Rational::from(1),
    ///     position: Rational::from(x),
    ///     velocity: Rational::from(v),
    ///     length: Rational::from(0),
    /// };
    /// assert!(Line::new(&[body(0, 1), body(1, 0)], &[Rational::from(1)], None, None).is_ok());
    /// assert!(Line::new(&[body(2, 1), body(1, 0)], &[Rational::from(1)], None, None).is_err());
    /// ```
    ///
    /// # Errors
    /// [`LineError`] names the first fault from the left.
    pub fn new(
        bodies: &[Body],
        restitution: &[Rational],
        left: Option<&Wall>,
        right: Option<&Wall>,
    ) -> Result<Line, LineError> {
        if bodies.is_empty() {
            return Err(LineError::Empty);
        }
        if bodies.len() > MAX_BODIES {
            return Err(LineError::TooMany { bodies: bodies.len() });
        }
        if restitution.len() + 1 != bodies.len() {
            return Err(LineError::Pairs { given: restitution.len(), needed: bodies.len() - 1 });
        }
        let first = usize::from(left.is_none());
        let mut points: Vec<Point> = Vec::with_capacity(bodies.len() + 2);
        let mut lengths = Rational::ZERO;
        points.extend(left.map(|wall| standing(wall, Rational::ZERO)));
        let mut half_lengths = Vec::with_capacity(bodies.len());
        for (i, body) in bodies.iter().enumerate() {
            if body.mass <= Rational::ZERO {
                return Err(LineError::Mass { body: i + 1 });
            }
            if body.length < Rational::ZERO {
                return Err(LineError::Length { body: i + 1 });
            }
            let half = &body.length / Rational::TWO;
            let offset = &lengths + &half;
            let position = &body.position - &offset;
            if let Some(before) = points.last()
                && position < before.position
            {
                return Err(LineError::Order { body: i + 1, least: &before.position + offset });
            }
            lengths += &body.length;
            half_lengths.push(half);
            points.push(point(Some(body.mass.clone()), position, body.velocity.clone(), offset));
        }
        if let Some(wall) = right {
            let wall = standing(wall, lengths.clone());
            if let Some(before) = points.last()
                && wall.position < before.position
            {
                return Err(LineError::Order { body: bodies.len() + 1, least: &before.position + lengths });
            }
            points.push(wall);
        }
        let walls = |w: Option<&Wall>| w.map(|w| w.restitution.clone());
        let all = walls(left).into_iter().chain(restitution.iter().cloned()).chain(walls(right));
        let mut pairs = Vec::with_capacity(points.len());
        for (p, e) in all.enumerate() {
            if e < Rational::ZERO || e > Rational::ONE {
                return Err(LineError::Restitution { left: p + first });
            }
            pairs.push(pair(points[p].mass.as_ref(), points[p + 1].mass.as_ref(), e));
        }
        Ok(Line { points, pairs, first, half_lengths, bodies: bodies.len() })
    }

    /// The number of bodies, walls not counted.
    #[must_use]
    pub fn bodies(&self) -> usize {
        self.bodies
    }

    /// Whether there is a wall on the left.
    #[must_use]
    pub(crate) fn has_left_wall(&self) -> bool {
        self.first == 0
    }

    /// Whether there is a wall on the right.
    #[must_use]
    pub(crate) fn has_right_wall(&self) -> bool {
        self.points.len() + self.first - 1 > self.bodies
    }

    /// Where the walls stand.
    #[must_use]
    pub fn walls(&self) -> (Option<Rational>, Option<Rational>) {
        let place = |p: Option<&Point>| p.filter(|p| p.mass.is_none()).map(|p| &p.position + &p.offset);
        (place(self.points.first()), place(self.points.last()))
    }

    /// The body's mass; bodies count from 1.
    #[must_use]
    pub fn mass(&self, body: usize) -> Option<&Rational> {
        self.points.get(body.checked_sub(self.first)?)?.mass.as_ref()
    }

    /// Half the body's length; bodies count from 1.
    #[must_use]
    pub fn half_length(&self, body: usize) -> Option<&Rational> {
        self.half_lengths.get(body.checked_sub(1)?)
    }

    /// Position and velocity of a body at time 0; bodies count from 1.
    #[must_use]
    pub fn start(&self, body: usize) -> Option<(Rational, Rational)> {
        let point = self.points.get(body.checked_sub(self.first)?)?;
        point.mass.as_ref()?;
        Some((&point.position + &point.offset, point.velocity.clone()))
    }

    /// What to add to the coordinate of a contact of the pair to get its place on the line.
    pub(super) fn contact_offset(&self, pair: usize) -> Rational {
        let left = &self.points[pair];
        match (pair + self.first).checked_sub(1).and_then(|i| self.half_lengths.get(i)) {
            Some(half) => &left.offset + half,
            None => left.offset.clone(),
        }
    }

    /// The energy lost in a collision of the pair, over the square of its closing speed.
    pub(super) fn loss_factor(&self, pair: usize) -> Rational {
        let e = &self.pairs[pair].restitution;
        let mass = match (&self.points[pair].mass, &self.points[pair + 1].mass) {
            (Some(l), Some(r)) => l * r / (l + r),
            (Some(m), None) | (None, Some(m)) => m.clone(),
            (None, None) => Rational::ZERO,
        };
        mass * (Rational::ONE - e * e) / Rational::TWO
    }

    /// The points that are bodies.
    pub(super) fn body_points(&self) -> std::ops::Range<usize> {
        let from = 1 - self.first;
        from..from + self.bodies
    }
}

fn standing(wall: &Wall, offset: Rational) -> Point {
    point(None, &wall.position - &offset, Rational::ZERO, offset)
}

fn point(mass: Option<Rational>, position: Rational, velocity: Rational, offset: Rational) -> Point {
    Point { near: Course::of(&position, &velocity), mass, position, velocity, offset }
}

fn pair(left: Option<&Rational>, right: Option<&Rational>, e: Rational) -> Pair {
    let both = Rational::ONE + &e;
    let (to_left, to_right) = match (left, right) {
        (Some(l), Some(r)) => {
            let share = &both / (l + r);
            (&share * r, share * l)
        }
        (None, _) => (Rational::ZERO, both),
        (Some(_), None) => (both, Rational::ZERO),
    };
    Pair { near: Shares::of(&to_left, &to_right), restitution: e, left: to_left, right: to_right }
}
