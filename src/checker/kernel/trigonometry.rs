//! sin and cos of any real number, and π.
//!
//! Contract: as in `term`, a fraction has the value of its expression wherever that has one. To add two numbers u and v is
//! to multiply cos u + i·sin u by cos v + i·sin v; a term p·v with a whole number p ≤ [`MULTIPLE_LIMIT`] is v, p times. What is left
//! are the atoms cos v and sin v, v with a numerator 1 and positive first coefficient, or what [`super::arc`] knows of an arc v.
//! cos² + sin² = 1 is not used in reading.
//! A multiple of π/120 has its values in square roots (`claim::circle`), and a whole multiple n·π has cos = (−1)^n, sin = 0;
//! 2·n·π has cos = 1.

use super::fraction::Fraction;
use super::known::Known;
use super::order::Signs;
use super::power::numerator_apart;
use super::statement::{apply, compare, expr, name, numeral, power, product, sum};
use super::term::Atom;
use super::tree::single;
use super::{Checker, Reason, Refusal, key, rejected};
use crate::claim::circle::Point;
use crate::claim::syntax::*;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed};

/// The largest multiple of an argument that is written by the cosine and sine of the argument.
pub const MULTIPLE_LIMIT: u64 = 24;

/// `cos(u)^2 + sin(u)^2 = 1`.
pub fn unit_circle(u: &Expr) -> Prop {
    let square = |f: &str| (Sign::Plus, power(&apply(f, u.clone()), &numeral(2)));
    compare(sum(vec![square("cos"), square("sin")]), Relation::Equal, numeral(1))
}

/// `f(u) <= 1` and `f(u) >= -1` for f = cos and f = sin.
pub fn within_one(u: &Expr) -> [Prop; 4] {
    let least = expr(ExprKind::Negate(Box::new(numeral(1))));
    let above = |f: &str| compare(apply(f, u.clone()), Relation::LessEqual, numeral(1));
    let below = |f: &str| compare(apply(f, u.clone()), Relation::GreaterEqual, least.clone());
    [above("cos"), below("cos"), above("sin"), below("sin")]
}

/// `u*cos(u) relation sin(u)`.
pub fn below_the_tangent(u: &Expr, relation: Relation) -> Prop {
    compare(product(vec![u.clone(), apply("cos", u.clone())]), relation, apply("sin", u.clone()))
}

/// `sin(u) relation u`.
pub fn below_the_argument(u: &Expr, relation: Relation) -> Prop {
    compare(apply("sin", u.clone()), relation, u.clone())
}

impl Checker {
    /// cos u and sin u.
    pub(super) fn cosine_and_sine(&mut self, u: &Fraction) -> Result<(Fraction, Fraction), Refusal> {
        let mut out = (Fraction::integer(1), Fraction::integer(0));
        for part in self.summands(u)? {
            let next = self.of_one_term(&part)?;
            out = self.turned(&out, &next)?;
        }
        Ok(out)
    }

    /// (cos, sin) of u + v from those of u and v.
    fn turned(&self, u: &(Fraction, Fraction), v: &(Fraction, Fraction)) -> Result<(Fraction, Fraction), Refusal> {
        let times = |a: &Fraction, b: &Fraction| a.times(b, &self.work);
        let cosine = times(&u.0, &v.0)?.minus(&times(&u.1, &v.1)?, &self.work)?;
        Ok((cosine, Fraction::sum(&[times(&u.1, &v.0)?, times(&u.0, &v.1)?], &self.work)?))
    }

    /// (cos, sin) of k·u from those of u.
    fn multiple(&self, u: &(Fraction, Fraction), k: u64) -> Result<(Fraction, Fraction), Refusal> {
        let mut out = (Fraction::integer(1), Fraction::integer(0));
        for _ in 0..k {
            out = self.turned(&out, u)?;
        }
        Ok(out)
    }

    fn of_one_term(&mut self, part: &Fraction) -> Result<(Fraction, Fraction), Refusal> {
        let pi = Fraction::atom(self.intern(Atom::Pi));
        let turns = part.times(&pi.power(-1)?, &self.work)?;
        let mut part = part.clone();
        if let Some(t) = turns.as_number() {
            if let Some(point) = Point::of_turns(t) {
                let span = Span::default();
                return Ok((self.fraction(&point.cosine(span))?, self.fraction(&point.sine(span))?));
            }
            // A full turn changes nothing: what is left lies between −π and π.
            let two = BigRational::from_integer(BigInt::from(2));
            let rest = t - ((t + BigRational::one()) / &two).floor() * &two;
            part = pi.times(&Fraction::number(rest), &self.work)?;
        } else if self.is_whole(&turns.times(&Fraction::integer(2).power(-1)?, &self.work)?)? {
            return Ok((Fraction::integer(1), Fraction::integer(0)));
        } else if self.is_whole(&turns)? {
            return Ok((self.power(&Fraction::integer(-1), &turns)?, Fraction::integer(0)));
        }
        let (top, rest) = numerator_apart(&part);
        let (times, rest) = if top.unsigned_abs() <= MULTIPLE_LIMIT { (top, rest) } else { (1, part) };
        let turned = (times < 0) != rest.coefficient.is_negative();
        let rest = if rest.coefficient.is_negative() { rest.negated() } else { rest };
        let one = match self.of_an_arc(&rest)? {
            Some(known) => known,
            None => (self.atom_fraction(Atom::Cosine(rest.clone())), self.atom_fraction(Atom::Sine(rest))),
        };
        let (cosine, sine) = self.multiple(&one, times.unsigned_abs())?;
        Ok((cosine, if turned { sine.negated() } else { sine }))
    }

    /// Rule `circle`: for the number u,
    /// - `cos(u)^2 + sin(u)^2 = 1`, and each of the two at least −1 and at most 1;
    /// - `sin(u) <= u` where u ≥ 0, and `u*cos(u) <= sin(u)` where 0 ≤ u ≤ π; with `<` where these bounds are strict;
    /// - `cos(v) = F` or `sin(v) = F` for v = k·u, F being what it is by the cosine and sine of u.
    ///
    /// Sound: (cos u, sin u) lies on the unit circle. u − sin u is 0 at 0, and rises strictly, for its
    /// derivative 1 − cos u is 0 at multiples of 2π and positive elsewhere. sin u − u·cos u is 0 at 0, and its derivative u·sin u is
    /// positive on (0, π). The last is the k-th power of cos u + i·sin u.
    pub(super) fn circle(&mut self, goal: &Prop, with: &[(Name, Expr)], known: &mut Known) -> Result<(), Refusal> {
        self.prop_defined(goal, known)?;
        let [(word, u)] = with else { return rejected(Reason::ValueForNoVariable) };
        if word.text != "u" {
            return rejected(Reason::ValueForNoVariable);
        }
        self.number_defined(u, known)?;
        let shown = key::prop(goal);
        if std::iter::once(unit_circle(u)).chain(within_one(u)).any(|says| key::prop(&says) == shown) {
            return Ok(());
        }
        for (order, sign) in [(Relation::Less, Relation::Greater), (Relation::LessEqual, Relation::GreaterEqual)] {
            if key::prop(&below_the_argument(u, order)) == shown {
                return self.are_lengths(std::slice::from_ref(u), sign, known);
            }
            // π, not a variable of that name.
            if !self.is_declared(PI) && key::prop(&below_the_tangent(u, order)) == shown {
                let rest = sum(vec![(Sign::Plus, name(PI)), (Sign::Minus, u.clone())]);
                return self.are_lengths(&[u.clone(), rest], sign, known);
            }
        }
        let (left, relation, right) = single(goal)?;
        let ExprKind::Apply(f, arguments) = &left.kind else { return rejected(Reason::ItSays(unit_circle(u))) };
        let ([v], Relation::Equal, "cos" | "sin") = (arguments.as_slice(), relation, f.text.as_str()) else {
            return rejected(Reason::ItSays(unit_circle(u)));
        };
        let (of, whole, said) = (self.fraction(u)?, self.fraction(v)?, self.fraction(right)?);
        let times = whole.times(&of.power(-1)?, &self.work)?;
        let Some(k) = times.as_integer().and_then(|k| u64::try_from(k).ok()).filter(|k| *k <= MULTIPLE_LIMIT) else {
            return rejected(Reason::ItSays(unit_circle(u)));
        };
        let one = self.cosine_and_sine(&of)?;
        let (cosine, sine) = self.multiple(&one, k)?;
        let value = if f.text == "cos" { cosine } else { sine };
        if value.minus(&said, &self.work)?.is_zero() { Ok(()) } else { rejected(Reason::NoIdentity) }
    }

    /// Refuses lengths that are not seen to be positive, or not negative.
    fn are_lengths(&mut self, lengths: &[Expr], relation: Relation, known: &Known) -> Result<(), Refusal> {
        for length in lengths {
            if !self.signs_of_expr(length, known)?.within(Signs::of(relation)) {
                return rejected(Reason::Needs(compare(length.clone(), relation, numeral(0))));
            }
        }
        Ok(())
    }
}
