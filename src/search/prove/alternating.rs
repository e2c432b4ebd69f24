//! Powers of constants of any sign: q^n = t^n·c^n for a number c > 0 that is at least as large as q, and t = q/c from −1 to 1.
//!
//! Method: c is −q where q is negative, and (1 + q²)/2 where its sign is not known: that is at least |q|, and less than 1 where
//! q is between −1 and 1. The power of c is an exponential, and t^n lies between −1 and 1, as sine and cosine do. Both are shown
//! for every n by induction.
//!
//! A base that is a sum, as in (1 − p)^n, gets a name.
//!
//! Limits: [`BASES`], [`MULTIPLE`].

use super::facts::{minus, negated};
use super::letters::{natural, product, whole_power};
use super::limits::{holds, over, plus};
use super::{Fail, Prover};
use crate::certificate::{Label, Rule};
use crate::claim::syntax::*;
use crate::claim::walk::parts;
use crate::kernel::key;
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, name, numeral, power, prop};
use crate::refute::literal::literal;
use malachite::Rational;

/// The greatest multiple of the variable in an exponent.
const MULTIPLE: u32 = 6;

/// The most bases whose powers are taken apart.
const BASES: usize = 2;

/// An expression whose powers of what may be negative are taken apart.
pub(super) struct Apart {
    /// The expression.
    pub of: Expr,
    /// The equations by which it is the same, such as q^(n + 1) = t^n·c^n·q.
    pub equations: Vec<(Expr, Expr)>,
    /// That the powers of t lie between −1 and 1, and that q^n = t^n·c^n, for all n.
    pub facts: Vec<Label>,
}

impl Prover {
    /// Takes apart the powers of constants that may be negative and whose exponent is the natural variable x, or a number more.
    pub(super) fn apart_from_signs(&mut self, e: &Expr, x: &str) -> Result<Apart, Fail> {
        let mut apart = Apart { of: e.clone(), equations: Vec::new(), facts: Vec::new() };
        if !self.naturals.iter().any(|n| n == x) {
            return Ok(apart);
        }
        let mut powers = Vec::new();
        powers_to(e, x, &mut powers);
        let mut known: Vec<(Expr, Expr)> = Vec::new();
        for (base, exponent) in powers {
            let Some((multiple, more)) = self.steps_of(&exponent, x) else { continue };
            let base_of_x = whole_power(base.clone(), i64::from(multiple));
            let written = match known.iter().find(|(other, _)| key::expr(other) == key::expr(&base_of_x)) {
                Some((_, written)) => written.clone(),
                None if known.len() == BASES => continue,
                None => {
                    let Some(written) = self.written_apart(&base_of_x, x, &mut apart.facts)? else { continue };
                    known.push((base_of_x, written.clone()));
                    written
                }
            };
            let whole = power(&base, &exponent);
            let new = match more {
                0 => written,
                k => product(vec![written, whole_power(base.clone(), i64::from(k))]),
            };
            super::sums::replace(&mut apart.of, &whole, &new);
            apart.equations.push((whole, new));
        }
        Ok(apart)
    }

    /// An exponent c·x + d as the natural numbers c and d.
    fn steps_of(&mut self, exponent: &Expr, x: &str) -> Option<(u32, u32)> {
        (1..=MULTIPLE).find_map(|c| {
            let rest = minus(exponent, &product(vec![numeral(c), name(x)]));
            Some((c, natural(&self.simplified(&rest)?)?))
        })
    }

    /// The power of a base with the exponent x, taken apart: of one that is positive, if it is no name or number, by a name for it.
    fn written_apart(&mut self, base: &Expr, x: &str, facts: &mut Vec<Label>) -> Result<Option<Expr>, Fail> {
        if let Some(signs) = self.of_unknown_sign(base) {
            return self.by_size(base, signs, x, facts).map(Some);
        }
        if !matches!(base.kind, ExprKind::Sum(_)) || self.letters.number(base).is_some() {
            return Ok(None);
        }
        let c = self.with_a_name("c", base.clone())?;
        self.show(&compare(c.clone(), Relation::Greater, numeral(0)))?;
        for side in [Relation::Less, Relation::Greater] {
            if self.quietly(&compare(c.clone(), side, numeral(1))).is_ok() {
                break;
            }
        }
        let k = self.fresh("k");
        let same = compare(power(base, &name(&k)), Relation::Equal, power(&c, &name(&k)));
        let every = prop(PropKind::ForAll(vec![Binding::of(Name::new(&k), true, Vec::new())], Box::new(same)));
        facts.push(self.on_its_own(|c| c.show(&every))?);
        Ok(Some(power(&c, &name(x))))
    }

    /// The signs of a constant that is not known to be positive.
    fn of_unknown_sign(&mut self, base: &Expr) -> Option<Signs> {
        if self.signs_of(base).within(Signs::POSITIVE) {
            return None;
        }
        let signs = self.sign_of_constant(base).unwrap_or_else(|| self.signs_of(base));
        (!signs.within(Signs::POSITIVE)).then_some(signs)
    }

    /// t^x·c^x for the power of a base, and what is known of it for all values of x.
    fn by_size(&mut self, base: &Expr, signs: Signs, x: &str, facts: &mut Vec<Label>) -> Result<Expr, Fail> {
        let (t, c) = if signs.within(Signs::of(Relation::Less)) {
            let size = negated(base.clone());
            let size = self.simplified(&size).unwrap_or(size);
            let c = if self.letters.number(&size).is_some() { size } else { self.with_a_name("c", size)? };
            self.show(&compare(c.clone(), Relation::Greater, numeral(0)))?;
            // Where it is not, the limit is decided without.
            let _ = self.quietly(&compare(c.clone(), Relation::Less, numeral(1)));
            (literal(&Rational::from(-1)), c)
        } else {
            let mean = over(plus(&numeral(1), whole_power(base.clone(), 2)), numeral(2));
            let c = self.with_a_name("c", mean)?;
            self.show(&compare(c.clone(), Relation::Greater, numeral(0)))?;
            // Where it is not, the limit is decided without.
            let _ = self.quietly(&compare(c.clone(), Relation::Less, numeral(1)));
            let t = self.with_a_name("t", over(base.clone(), c.clone()))?;
            self.show(&compare(numeral(1), Relation::GreaterEqual, t.clone()))?;
            self.show(&compare(literal(&Rational::from(-1)), Relation::LessEqual, t.clone()))?;
            (t, c)
        };
        let is_unit = self.is_one(&c);
        let written = |n: &str| {
            let turn = power(&t, &name(n));
            if is_unit { turn } else { product(vec![turn, power(&c, &name(n))]) }
        };
        let k = self.fresh("k");
        let within = PropKind::Compare(
            vec![literal(&Rational::from(-1)), power(&t, &name(&k)), numeral(1)],
            vec![Relation::LessEqual; 2],
        );
        let same = compare(power(base, &name(&k)), Relation::Equal, written(&k));
        for body in [prop(within), same] {
            let every = PropKind::ForAll(vec![Binding::of(Name::new(&k), true, Vec::new())], Box::new(body));
            let splits = std::mem::replace(&mut self.splits, 0);
            let shown = self.on_its_own(|c| c.show(&prop(every)));
            self.splits = splits;
            facts.push(shown?);
        }
        Ok(written(x))
    }

    /// A name for an expression.
    fn with_a_name(&mut self, stem: &str, e: Expr) -> Result<Expr, Fail> {
        let new = name(&self.fresh(stem));
        let named = compare(e, Relation::Equal, new.clone());
        let label = self.emit(Rule::Name, named.clone())?;
        self.take_in(&label, &named)?;
        Ok(new)
    }
}

/// The powers of constants to what holds a variable, as base and exponent.
pub(super) fn powers_to(e: &Expr, x: &str, out: &mut Vec<(Expr, Expr)>) {
    parts(e, &mut |part| powers_to(part, x, out));
    if let ExprKind::Power(base, exponent) = &e.kind
        && holds(exponent, x)
        && !holds(base, x)
    {
        out.push(((**base).clone(), (**exponent).clone()));
    }
}
