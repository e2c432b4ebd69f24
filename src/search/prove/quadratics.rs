//! Quadratics in one letter whose roots are irrational: their sign, and the place of the letter.
//!
//! Method: K = a·v² + b·v + c is a·(v − r)·(v − s) for the roots m ∓ q·w, where w is the square root of a whole number d. To the
//! kernel w is a letter with w² = d, so K = a·(v − r)·(v − s) + a·q²·(w² − d). The sign of K follows from where v lies to r and
//! to s. Where the sign of K is known, v − s is K over a·(v − r).

use super::comparison::single;
use super::facts::minus;
use super::letters::{product, whole_power};
use super::limits::over;
use super::products::Kind;
use super::squares::{Open, own_relation};
use super::values::root_of;
use super::{Fail, Prover};
use crate::algebra::Polynomial;
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use crate::kernel::statement::{apply, compare, sum};
use crate::refute::literal::literal;
use malachite::Rational;
use std::rc::Rc;

/// a·v² + b·v + c with the roots m ∓ q·w.
struct Quadratic {
    /// The polynomial.
    written: Expr,
    /// a.
    lead: Rational,
    /// v.
    letter: Expr,
    /// w² = d.
    square: Prop,
    /// q².
    scale: Rational,
    least: Expr,
    greatest: Expr,
}

impl Prover {
    /// A comparison of a quadratic with 0, or of a letter with a root of a quadratic of which the sign is known.
    pub(crate) fn by_quadratic(&mut self, goal: &Prop) -> Result<Label, Fail> {
        if single(goal)?.1 == Relation::Equal {
            return self.root_that_is_left(goal);
        }
        self.attempt(|c| c.sign_of_a_quadratic(goal)).or_else(|_| self.side_of_a_root(goal))
    }

    /// The sign of L·v² + M·v + N for a positive polynomial L: it is ((2·L·v + M)² + (4·L·N − M²))/(4·L).
    pub(super) fn by_completed_square(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("a square to complete");
        let open = self.open_factors(goal, 0)?;
        let PropKind::Compare(_, relations) = &goal.kind else { return Err(no()) };
        let strict = matches!(relations[0], Relation::Greater | Relation::Less);
        let target = if open.flip { open.poly.neg() } else { open.poly };
        for v in target.variables() {
            let [constant, linear, lead] = &target.coefficients_in(v)[..] else { continue };
            let written = self.letters.written(lead);
            if lead.is_constant() || !self.signs_of(&written).within(Signs::POSITIVE) {
                continue;
            }
            let four = Rational::from(4);
            let Ok(product_of_ends) = lead.try_mul(constant) else { continue };
            let Ok(square) = linear.pow(2) else { continue };
            let gap = product_of_ends.scale(&four).sub(&square);
            let root = lead.scale(&Rational::from(2)).mul(&Polynomial::variable(v)).add(linear);
            let mut rest = open.rest.clone();
            let quarter = Rational::from(if open.flip { -1 } else { 1 }) / &four;
            rest.extend([literal(&quarter), whole_power(written, -1)]);
            let with = |e: Expr| product(std::iter::once(e).chain(rest.iter().cloned()).collect());
            let squared = with(whole_power(self.letters.written(&root), 2));
            let mut terms = vec![Term { facts: Vec::new(), factor: squared }];
            if !gap.is_zero() {
                let relation = if strict { Relation::Greater } else { Relation::GreaterEqual };
                let shown = compare(self.letters.written(&gap), relation, crate::kernel::statement::numeral(0));
                let Ok(label) = self.quietly(&shown) else { continue };
                terms.push(Term { facts: vec![label], factor: with(crate::kernel::statement::numeral(1)) });
            }
            if let Ok(label) = self.combination(goal.clone(), terms) {
                return Ok(label);
            }
        }
        Err(no())
    }

    fn sign_of_a_quadratic(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let (a, relation, b) = single(goal)?;
        let no = || Fail::No("a quadratic with irrational roots");
        let reading = self.read(&minus(a, b), true).ok_or_else(no)?;
        let reading = self.split(reading);
        let open = Open::of(self, &reading).ok_or_else(no)?;
        let own = own_relation(open.signs, relation).ok_or_else(no)?;
        let quadratic = self.quadratic(&open.poly).ok_or_else(no)?;
        let (below, above) = match own {
            Relation::Greater | Relation::Less => (Relation::Less, Relation::Greater),
            _ => (Relation::LessEqual, Relation::GreaterEqual),
        };
        let outside = matches!(own, Relation::Greater | Relation::GreaterEqual) == (quadratic.lead > 0);
        for (to_least, to_greatest) in if outside { vec![(below, below), (above, above)] } else { vec![(above, below)] }
        {
            let sides = [(&quadratic.least, to_least), (&quadratic.greatest, to_greatest)];
            let shown = self.attempt(|c| {
                let mut facts = Vec::new();
                for (root, relation) in sides {
                    facts.push(c.quietly(&compare(quadratic.letter.clone(), relation, root.clone()))?);
                }
                let square = c.square_of_the_root(&quadratic)?;
                let times = |q: &Rational| product(open.rest.iter().cloned().chain([literal(q)]).collect());
                let terms = vec![
                    Term { facts, factor: times(&quadratic.lead) },
                    Term { facts: vec![square], factor: times(&(&quadratic.lead * &quadratic.scale)) },
                ];
                c.combination(goal.clone(), terms)
            });
            if shown.is_ok() {
                return shown;
            }
        }
        Err(no())
    }

    /// A comparison of a letter with a root, from the sign of the quadratic, which the kernel sees, and the side of the other root.
    fn side_of_a_root(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let facts: Vec<Rc<Prop>> = self.checker.facts().map(|(_, p)| p.clone()).collect();
        for fact in facts {
            let Some((a, _, b)) = fact.single() else { continue };
            let Some(reading) = self.read(&minus(a, b), false).map(|r| self.split(r)) else { continue };
            for f in reading.factors.iter().filter(|f| f.power % 2 != 0) {
                let Some(quadratic) = self.quadratic(&f.poly) else { continue };
                for (other, side) in [
                    (&quadratic.greatest, Relation::Less),
                    (&quadratic.least, Relation::Greater),
                    (&quadratic.greatest, Relation::Greater),
                    (&quadratic.least, Relation::Less),
                ] {
                    let shown = self.attempt(|c| {
                        c.quietly(&compare(quadratic.letter.clone(), side, other.clone()))?;
                        let whole = Term { facts: Vec::new(), factor: quadratic.written.clone() };
                        c.by_the_other_root(goal, &quadratic, other, whole)
                    });
                    if shown.is_ok() {
                        return shown;
                    }
                }
            }
        }
        Err(Fail::No("a quadratic with a known sign"))
    }

    /// An equation of a letter with a root of a quadratic that is 0, where the letter is not the other root.
    fn root_that_is_left(&mut self, goal: &Prop) -> Result<Label, Fail> {
        for known in self.all_known(&[]).into_iter().filter(|k| k.kind == Kind::Zero) {
            let Some(quadratic) = self.quadratic(&known.poly) else { continue };
            for other in [&quadratic.least, &quadratic.greatest] {
                let shown = self.attempt(|c| {
                    c.quietly(&compare(quadratic.letter.clone(), Relation::NotEqual, other.clone()))?;
                    let whole = Term { facts: known.facts.clone(), factor: product(known.factors.clone()) };
                    c.by_the_other_root(goal, &quadratic, other, whole)
                });
                if shown.is_ok() {
                    return shown;
                }
            }
        }
        Err(Fail::No("a quadratic that is 0"))
    }

    /// v − s = K/(a·(v − r)) − q²·(w² − d)/(v − r), or the opposite, for the other root r.
    fn by_the_other_root(
        &mut self,
        goal: &Prop,
        quadratic: &Quadratic,
        other: &Expr,
        whole: Term,
    ) -> Result<Label, Fail> {
        let square = self.square_of_the_root(quadratic)?;
        let gap = minus(&quadratic.letter, other);
        let mut last = Err(Fail::No("a side"));
        for sign in [1, -1] {
            let lead = Rational::from(sign) * &quadratic.lead;
            let scale = Rational::from(-sign) * &quadratic.scale;
            let terms = vec![
                Term {
                    factor: over(whole.factor.clone(), product(vec![literal(&lead), gap.clone()])),
                    ..whole.clone()
                },
                Term { facts: vec![square.clone()], factor: over(literal(&scale), gap.clone()) },
            ];
            last = self.combination(goal.clone(), terms);
            if last.is_ok() {
                break;
            }
        }
        last
    }

    fn square_of_the_root(&mut self, quadratic: &Quadratic) -> Result<Label, Fail> {
        match self.known(&quadratic.square) {
            Some(label) => Ok(label),
            None => self.emit(Rule::Power, quadratic.square.clone()),
        }
    }

    fn quadratic(&self, poly: &Polynomial) -> Option<Quadratic> {
        let [v] = poly.variables()[..] else { return None };
        let list = poly.coefficients_in(v);
        let [c, b, a] = list.as_slice() else { return None };
        let (c, b, a) = (c.as_constant()?, b.as_constant()?, a.as_constant()?);
        // ((r − s)/2)²
        let apart = (&b * &b - Rational::from(4) * &a * c) / (Rational::from(4) * &a * &a);
        let (_, false) = root_of(&apart, 2)? else { return None };
        let (q, d) = root_of_a_whole_number(&apart)?;
        let root = apply("sqrt", literal(&d));
        let middle = literal(&(-b / (Rational::from(2) * &a)));
        let half = product(vec![literal(&q), root.clone()]);
        let at = |sign: Sign| sum(vec![(Sign::Plus, middle.clone()), (sign, half.clone())]);
        Some(Quadratic {
            written: self.letters.written(poly),
            lead: a,
            letter: self.letters.expr(v)?.clone(),
            square: compare(whole_power(root, 2), Relation::Equal, literal(&d)),
            scale: &q * &q,
            least: at(Sign::Minus),
            greatest: at(Sign::Plus),
        })
    }
}

/// The square root of a positive number as q·sqrt(d) with a whole number d, from which the squares of small numbers are taken out.
pub(super) fn root_of_a_whole_number(square: &Rational) -> Option<(Rational, Rational)> {
    let (n, m) = (i64::try_from(square.numerator_ref()).ok()?, i64::try_from(square.denominator_ref()).ok()?);
    let (mut d, mut outside) = (n.checked_mul(m)?, 1i64);
    for k in (2..1000i64).rev() {
        while d % (k * k) == 0 {
            d /= k * k;
            outside *= k;
        }
    }
    Some((Rational::from_signeds(outside, m), Rational::from(d)))
}
