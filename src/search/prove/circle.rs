//! Facts about cosines, sines and π: the unit circle, signs between the zeros, multiples of one argument.

use super::letters::product;
use super::{Fail, Prover};
use crate::algebra::Polynomial;
use crate::certificate::{Label, Rule};
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use crate::kernel::statement::{apply, compare, expr, name, numeral, sum};
use crate::kernel::trigonometry::{MULTIPLE_LIMIT, below_the_argument, below_the_tangent, unit_circle, within_one};
use crate::refute::literal::literal;
use malachite::Rational;
use malachite::base::num::conversion::traits::IsInteger;

/// Bounds of π, within 10^-6.
const PI_BOUNDS: [(Relation, &str); 2] = [(Relation::Greater, "3.141592"), (Relation::Less, "3.141593")];

impl Prover {
    /// Bounds of π.
    pub(super) fn learn_pi(&mut self) -> Result<(), Fail> {
        for (relation, text) in PI_BOUNDS {
            let bound = expr(ExprKind::Number(text.to_string()));
            self.new_fact(Rule::Evaluate, compare(name(PI), relation, bound))?;
        }
        Ok(())
    }

    /// Of cos u or sin u: the unit circle, the signs of both, and both by those of a part of u. Returns whether an equation was
    /// substituted.
    pub(super) fn learn_circle(&mut self, u: &Expr) -> Result<bool, Fail> {
        self.enrich(&[u]);
        let with = |u: &Expr| Rule::Circle { with: vec![(Name::new("u"), u.clone())] };
        self.new_fact(with(u), unit_circle(u))?;
        for bound in within_one(u) {
            self.new_fact(with(u), bound)?;
        }
        // The kernel sees the signs of sin u and cos u once it knows that u lies on an arc between two of their zeros.
        let half = product(vec![literal(&Rational::from_signeds(1, 2)), name(PI)]);
        for (from, to) in [(0, 2), (-2, 0), (-1, 1), (1, 3)] {
            let end = |k: i64| product(vec![literal(&Rational::from(k)), half.clone()]);
            let length = |a: &Expr, b: &Expr| sum(vec![(Sign::Plus, a.clone()), (Sign::Minus, b.clone())]);
            let lengths = [length(u, &end(from)), length(&end(to), u)];
            let _ = self.are_lengths(&lengths, Relation::Greater) || self.are_lengths(&lengths, Relation::GreaterEqual);
        }
        let opposite = product(vec![literal(&Rational::from(-1)), u.clone()]);
        for place in [u, &opposite] {
            for (sign, order) in [(Relation::Greater, Relation::Less), (Relation::GreaterEqual, Relation::LessEqual)] {
                let shown = below_the_argument(place, order);
                if self.signs_of(place).within(Signs::of(sign)) && self.new_fact(with(place), shown).is_ok() {
                    let _ = self.new_fact(with(place), below_the_tangent(place, order));
                    break;
                }
            }
        }
        self.by_a_common_part(u)
    }

    /// Adds a fact, unless it is known.
    pub(super) fn new_fact(&mut self, rule: Rule, shown: Prop) -> Result<(), Fail> {
        if self.known(&shown).is_none() {
            let label = self.emit(rule, shown.clone())?;
            self.take_in(&label, &shown)?;
        }
        Ok(())
    }

    /// Whether lengths are positive, or not negative: seen at once, or a sum of linear facts.
    pub(super) fn are_lengths(&mut self, lengths: &[Expr], relation: Relation) -> bool {
        let signs = Signs::of(relation);
        self.enrich(&lengths.iter().collect::<Vec<_>>());
        lengths.iter().all(|length| {
            self.signs_of(length).within(signs)
                || self.by_linear_facts(&compare(length.clone(), relation, numeral(0))).is_ok()
        })
    }

    /// Where another argument is a rational multiple of this one: the cosine and sine of the longer by those of the shorter, or of
    /// both by those of a common part.
    fn by_a_common_part(&mut self, u: &Expr) -> Result<bool, Fail> {
        let mut any = false;
        for other in self.letters.all() {
            let ExprKind::Apply(f, at) = &other.kind else { continue };
            let ("cos" | "sin", [v]) = (f.text.as_str(), at.as_slice()) else { continue };
            let ratio = expr(ExprKind::Product(vec![(Factor::Times, v.clone()), (Factor::Over, u.clone())]));
            let Some(ratio) = self.read(&ratio, false).filter(|r| r.factors.is_empty()).map(|r| r.number) else {
                continue;
            };
            if ratio <= 0 || ratio == 1 {
                continue;
            }
            let (p, q) = (Rational::from(ratio.numerator_ref()), Rational::from(ratio.denominator_ref()));
            let part = if q == 1 { u.clone() } else { product(vec![literal(&(Rational::from(1) / &q)), u.clone()]) };
            for (whole, k) in [(v, p), (u, q)] {
                any |= self.attempt(|c| c.multiple_of(&part, whole, &k)).is_ok();
            }
        }
        Ok(any)
    }

    /// cos v and sin v by those of u, v = k·u.
    fn multiple_of(&mut self, u: &Expr, v: &Expr, k: &Rational) -> Result<Label, Fail> {
        let no = || Fail::No("a small multiple of an argument");
        let times =
            u64::try_from(k).ok().filter(|k| k.is_integer() && (2..=MULTIPLE_LIMIT / 2).contains(k)).ok_or_else(no)?;
        let (c, s) = (apply("cos", u.clone()), apply("sin", u.clone()));
        let (c, s) = (Polynomial::variable(self.letters.of(&c)), Polynomial::variable(self.letters.of(&s)));
        let (mut cosine, mut sine) = (Polynomial::one(), Polynomial::zero());
        for _ in 0..times {
            let of = |a: &Polynomial, b: &Polynomial| a.try_mul(b).map_err(|_| no());
            (cosine, sine) = (of(&cosine, &c)?.sub(&of(&sine, &s)?), of(&sine, &c)?.add(&of(&cosine, &s)?));
        }
        let mut last = Err(no());
        for (f, value) in [("cos", cosine), ("sin", sine)] {
            let shown = compare(apply(f, v.clone()), Relation::Equal, self.letters.written(&value));
            if self.known(&shown).is_some() {
                return Err(no());
            }
            let label = self.emit(Rule::Circle { with: vec![(Name::new("u"), u.clone())] }, shown)?;
            self.put_in(&label);
            last = Ok(label);
        }
        last
    }
}

/// The cosine and the sine of the sum of two angles, by those of each, as polynomials.
pub(super) fn of_a_sum([x, y]: &[Polynomial; 2], [c, s]: &[Polynomial; 2]) -> Option<[Polynomial; 2]> {
    Some([x.try_mul(c).ok()?.sub(&y.try_mul(s).ok()?), y.try_mul(c).ok()?.add(&x.try_mul(s).ok()?)])
}
