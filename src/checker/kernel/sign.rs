//! The signs of fractions, from the facts that a step cites.
//!
//! Contract: at every point that the facts allow, a fraction whose expression has a value there has one of the signs
//! that [`Checker::signs_of`] returns. Nothing is known but what [`Known`] was told for this one step, and what an
//! atom's form says: naturals and roots are not negative, exponentials are positive.

use super::fraction::{Fraction, Poly};
use super::known::{Known, Range, Sign};
use super::order::Signs;
use super::term::Atom;
use super::tree::{conjuncts, single};
use super::{Checker, Refusal, key};
use crate::claim::syntax::*;
use num_rational::BigRational;
use num_traits::Signed;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

/// How deep signs of products over an index may nest.
pub(super) const NESTING: usize = 20;

/// How many sines and cosines, one in the argument of the other, are sought on arcs.
const NESTED_ARCS: usize = 3;

/// Up to which degree in an index a factor is read with the ends of the range put in.
const RANGE_DEGREE: u32 = 20;

/// One question: the signs of atoms found so far, and the ranges of the indices that what it reads may hold.
#[derive(Default)]
pub(super) struct Found {
    pub(super) signs: BTreeMap<usize, Signs>,
    pub(super) ranges: Vec<Range>,
    /// How many arguments of sines and cosines the question stands in.
    pub(super) arguments: usize,
    /// Whether nothing is sought between bounds, but in such arguments.
    pub(super) without_bounds: bool,
}

impl Found {
    pub(super) fn new(known: &Known) -> Found {
        Found { ranges: known.ranges.clone(), ..Found::default() }
    }
}

impl Checker {
    /// Notes what a sign of a fraction says of the one factor whose sign is open; as it stands, and with the equations.
    pub(super) fn learn_signs(&mut self, f: &Fraction, allowed: Signs, known: &mut Known) -> Result<(), Refusal> {
        self.note(f, allowed, &BTreeSet::new(), known)?;
        if known.equations.is_empty() {
            return Ok(());
        }
        let (replaced, places) = self.all_replaced(f, &known.equations())?;
        if replaced == *f { Ok(()) } else { self.note(&replaced, allowed, &places.into_iter().collect(), known) }
    }

    /// Sound: a fraction is the product of its factors. If it is not 0, no factor is; if all but one have one known
    /// sign other than 0, the last has a sign whose power, times theirs, is allowed.
    pub(super) fn note(
        &self,
        f: &Fraction,
        allowed: Signs,
        places: &BTreeSet<usize>,
        known: &mut Known,
    ) -> Result<(), Refusal> {
        let before = (known.asked.take(), known.put_in.take());
        let mut rest = Signs::of_number(&f.coefficient);
        let mut open = Vec::new();
        for (poly, k) in &f.factors {
            // What bounds show already is noted as well, but for signs of sines and cosines: Coq's theorems follow what is noted.
            let mut plain = Found { without_bounds: true, ..Found::new(known) };
            let signs = self.poly_signs(poly, known, NESTING, &mut plain)?.power(*k);
            let strict = signs.within(Signs::POSITIVE) || signs.within(Signs::of(Relation::Less));
            if strict { rest = rest.times(signs) } else { open.push((poly.clone(), *k)) }
        }
        // What the signs of the other factors rest on, this rests on as well.
        let (mut from, mut put_in) = (known.asked.replace(before.0), known.put_in.replace(before.1));
        from.extend(known.source);
        put_in.extend(places);
        let (from, put_in) = (Rc::new(from), Rc::new(put_in));
        let mut add = |poly: &Poly, signs| {
            known.add(Sign { poly: poly.clone(), signs, from: from.clone(), put_in: put_in.clone() });
        };
        if allowed.within(Signs::NOT_ZERO) {
            open.iter().for_each(|(poly, _)| add(poly, Signs::NOT_ZERO));
        }
        if let [(poly, k)] = open.as_slice()
            && rest.within(Signs::NOT_ZERO)
        {
            let possible = [Signs::of(Relation::Less), Signs::ZERO, Signs::POSITIVE];
            let signs = possible
                .into_iter()
                .filter(|s| !(*k < 0 && *s == Signs::ZERO) && s.power(*k).times(rest).within(allowed))
                .reduce(Signs::or);
            // No sign at all: the facts contradict each other, which is not said here.
            if let Some(signs) = signs {
                add(poly, signs);
                // p − c ≥ 0 says that p > 0, and p + c ≤ 0 that p < 0, for a number c > 0.
                let bound = poly.terms().find(|t| t.0.is_empty()).map(|t| t.1.clone());
                let beyond = match bound {
                    Some(c) if c.is_negative() && signs.within(Signs::NOT_NEGATIVE) => Some((c, Signs::POSITIVE)),
                    Some(c) if c.is_positive() && signs.within(Signs::of(Relation::LessEqual)) => {
                        Some((c, Signs::of(Relation::Less)))
                    }
                    _ => None,
                };
                if let Some((c, signs)) = beyond {
                    let moved = Fraction::sum(&[Fraction::of(poly), Fraction::number(-c)], &self.work)?;
                    // What is left has the leading coefficient 1; it may be a product.
                    if let (Some((rest, 1)), 1) = (moved.factors.iter().next(), moved.factors.len()) {
                        let signs = Signs::of_number(&moved.coefficient).times(signs);
                        add(rest, signs);
                    }
                }
            }
        }
        Ok(())
    }

    /// The signs of an expression, as it stands and with the equations put in.
    pub(super) fn signs_of_expr(&mut self, e: &Expr, known: &Known) -> Result<Signs, Refusal> {
        let plain = self.fraction(e)?;
        let signs = self.signs_as_read(&plain, known)?;
        if known.equations.is_empty() {
            return Ok(signs);
        }
        let replaced = self.fraction_with(e, known)?;
        Ok(signs.and(self.signs_as_read(&replaced, known)?))
    }

    /// The signs of a fraction, with the equations put in.
    pub(super) fn signs_of(&mut self, f: &Fraction, known: &Known) -> Result<Signs, Refusal> {
        let plain = self.signs_as_read(f, known)?;
        if known.equations.is_empty() {
            return Ok(plain);
        }
        let replaced = self.with_equations(f, known)?;
        Ok(plain.and(self.signs_as_read(&replaced, known)?))
    }

    /// A fraction with the equations put in.
    pub(super) fn with_equations(&mut self, f: &Fraction, known: &Known) -> Result<Fraction, Refusal> {
        let (out, places) = self.all_replaced(f, &known.equations())?;
        known.mark_put_in(places.into_iter().collect());
        Ok(out)
    }

    /// The signs of a fraction as it is.
    pub(super) fn signs_as_read(&self, f: &Fraction, known: &Known) -> Result<Signs, Refusal> {
        self.fraction_signs(f, known, NESTING, &mut Found::new(known))
    }

    fn fraction_signs(&self, f: &Fraction, known: &Known, depth: usize, found: &mut Found) -> Result<Signs, Refusal> {
        let mut signs = Signs::of_number(&f.coefficient);
        for (poly, k) in &f.factors {
            signs = signs.times(self.poly_signs(poly, known, depth, found)?.power(*k));
        }
        Ok(signs)
    }

    pub(super) fn noted(&self, poly: &Poly, known: &Known) -> Result<Signs, Refusal> {
        self.work.count(1 + poly.size())?;
        let mut all = Signs::ANY;
        let places = known.places.get(poly).into_iter().flatten();
        for sign in places.filter_map(|place| known.signs.get(*place)) {
            // Only what says something new is asked for.
            if !all.within(sign.signs) {
                all = all.and(sign.signs);
                known.asked.borrow_mut().extend(sign.from.iter().copied());
                known.put_in.borrow_mut().extend(sign.put_in.iter().copied());
            }
        }
        Ok(all)
    }

    /// The signs of a polynomial: those noted of it, and those of the sum of its terms, also with the ranges of indices
    /// put in.
    ///
    /// Sound: an index i of a range a..b is a + j and b - k for natural numbers j and k. The atom of i stands for them in
    /// what is read then, and of it nothing is known but that it is natural.
    pub(super) fn poly_signs(
        &self,
        poly: &Poly,
        known: &Known,
        depth: usize,
        found: &mut Found,
    ) -> Result<Signs, Refusal> {
        let mut signs = match poly.single_atom() {
            Some(atom) => self.atom_signs(atom, known, depth, found)?,
            None => match self.sum_signs(poly, known, depth, found)? {
                // What follows from the terms alone need not be asked for.
                sum if sum.is_single() => sum,
                sum => self.narrowed(sum.and(self.noted(poly, known)?), poly, known, found)?,
            },
        };
        for place in 0..found.ranges.len() {
            let Some(Range { index, from, to }) = found.ranges.get(place).cloned() else { continue };
            let inside = |atom: usize| self.occurring.get(atom).is_some_and(|all| all.binary_search(&index).is_ok());
            let alone = poly.atoms().any(|a| a == index) && !poly.atoms().any(|a| a != index && inside(a));
            if signs.is_single() || !alone {
                continue;
            }
            let one = |c: i64| Poly::term(vec![(index, 1)], BigRational::from_integer(c.into()));
            for value in [Poly::sum(&[from, one(1)], &self.work)?, Poly::sum(&[to, one(-1)], &self.work)?] {
                let Some(read) = poly.with(index, &value, RANGE_DEGREE, &self.work)? else { continue };
                let of_index = found.signs.insert(index, Signs::NOT_NEGATIVE);
                let sum = self.sum_signs(&read, known, depth, found);
                let read = sum.and_then(|sum| self.narrowed(sum, &read, known, found));
                match of_index {
                    Some(before) => found.signs.insert(index, before),
                    None => found.signs.remove(&index),
                };
                signs = signs.and(read?);
            }
        }
        Ok(signs)
    }

    /// The signs of the sum of a polynomial's terms.
    fn sum_signs(&self, poly: &Poly, known: &Known, depth: usize, found: &mut Found) -> Result<Signs, Refusal> {
        let mut sum = Signs::ZERO;
        for (monomial, c) in poly.terms() {
            let mut term = Signs::of_number(c);
            for (atom, k) in monomial {
                term = term.times(self.atom_signs(*atom, known, depth, found)?.power(i64::from(*k)));
            }
            sum = sum.plus(term);
        }
        Ok(sum)
    }

    /// The signs of an atom, sought once in each question: an atom may stand in every term.
    fn atom_signs(&self, atom: usize, known: &Known, depth: usize, found: &mut Found) -> Result<Signs, Refusal> {
        if let Some(signs) = found.signs.get(&atom) {
            return Ok(*signs);
        }
        let poly = Poly::atom(atom);
        let signs = self.noted(&poly, known)?.and(self.structural(atom, known, depth, found)?);
        let signs = self.narrowed(signs, &poly, known, found)?;
        found.signs.insert(atom, signs);
        Ok(signs)
    }

    /// What the form of an atom says of its sign. Atoms that have no value at a point have no sign there.
    fn structural(&self, atom: usize, known: &Known, depth: usize, found: &mut Found) -> Result<Signs, Refusal> {
        let Some(depth) = depth.checked_sub(1) else { return Err(Refusal::Limit("nesting of products")) };
        if self.is_natural_atom(atom) {
            return Ok(Signs::NOT_NEGATIVE);
        }
        Ok(match self.atoms.get(atom) {
            Some(Atom::Exponential(_) | Atom::Pi) => Signs::POSITIVE,
            Some(Atom::Power(base, exponent)) => {
                let base = self.fraction_signs(base, known, depth, found)?;
                match self.is_whole(exponent)? {
                    // A power that is not whole has a value for bases that are not negative only, and for 0 only if
                    // its exponent is a numeral.
                    false if base.within(Signs::NOT_ZERO) || exponent.as_number().is_none() => Signs::POSITIVE,
                    false => Signs::NOT_NEGATIVE,
                    true => [Signs::POSITIVE, Signs::NOT_NEGATIVE, Signs::NOT_ZERO]
                        .into_iter()
                        .find(|kind| base.within(*kind))
                        .unwrap_or(Signs::ANY),
                }
            }
            // ln x rises with x, and ln 1 = 0.
            Some(Atom::Logarithm(inner)) => {
                let shifted = Fraction::sum(&[inner.clone(), Fraction::integer(-1)], &self.work)?;
                self.fraction_signs(&shifted, known, depth, found)?
            }
            // Both rise with x, and are 0 at 0.
            Some(Atom::Arcsine(x) | Atom::Arctangent(x)) => self.fraction_signs(x, known, depth, found)?,
            Some(Atom::Cosine(u)) => self.arc_signs(u, [(-1, 1), (1, 3)], known, depth, found)?,
            Some(Atom::Sine(u)) => self.arc_signs(u, [(0, 2), (-2, 0)], known, depth, found)?,
            Some(Atom::Member(name, _)) => self.member_signs(name, known)?,
            Some(Atom::Over(over)) => {
                let Some(index) = self.atom_index.get(&Atom::Bound(over.own)).copied() else {
                    return Ok(Signs::ANY);
                };
                let mut ranges = found.ranges.clone();
                ranges.push(Range { index, from: over.from.clone(), to: over.to.clone() });
                let mut inside = Found { signs: BTreeMap::new(), ranges, ..*found };
                let body = self.fraction_signs(&over.body, known, depth, &mut inside)?;
                let members = Fraction::of(&over.to).minus(&Fraction::of(&over.from), &self.work)?;
                if over.sum
                    && (body.within(Signs::POSITIVE) || body.within(Signs::of(Relation::Less)))
                    && self.fraction_signs(&members, known, depth, found)?.within(Signs::NOT_NEGATIVE)
                {
                    return Ok(body);
                }
                // A range may be empty: an empty sum is 0, an empty product 1.
                let kinds = if over.sum {
                    vec![Signs::NOT_NEGATIVE, Signs::of(Relation::LessEqual)]
                } else {
                    vec![Signs::POSITIVE, Signs::NOT_NEGATIVE, Signs::NOT_ZERO]
                };
                kinds.into_iter().find(|kind| body.within(*kind)).unwrap_or(Signs::ANY)
            }
            _ => Signs::ANY,
        })
    }

    /// The signs of the sine or cosine of u, if u lies on an arc of one sign: from and to are multiples of π/2.
    ///
    /// Sound: it is 0 at both, positive between the first two and negative between the others. What this rests on is marked only if it
    /// says something, so what is found on the way is not kept.
    fn arc_signs(
        &self,
        u: &Fraction,
        arcs: [(i64, i64); 2],
        known: &Known,
        depth: usize,
        found: &Found,
    ) -> Result<Signs, Refusal> {
        let pi = self.atom_index.get(&Atom::Pi).filter(|_| found.arguments < NESTED_ARCS);
        let Some(pi) = pi.copied() else { return Ok(Signs::ANY) };
        let before = (known.asked.take(), known.put_in.take());
        let mut signs = Signs::ANY;
        for ((from, to), beyond) in arcs.into_iter().zip([Signs::POSITIVE, Signs::POSITIVE.turned()]) {
            let mut inside = Found { ranges: found.ranges.clone(), arguments: found.arguments + 1, ..Found::default() };
            let mut lengths = Signs::POSITIVE;
            for (end, towards) in [(from, 1), (to, -1)] {
                let end = Fraction::number(BigRational::new(end.into(), 2.into()));
                let length = u.minus(&Fraction::atom(pi).times(&end, &self.work)?, &self.work)?;
                let length = length.times(&Fraction::integer(towards), &self.work)?;
                lengths = lengths.or(self.fraction_signs(&length, known, depth, &mut inside)?);
                if !lengths.within(Signs::NOT_NEGATIVE) {
                    break;
                }
            }
            if lengths.within(Signs::NOT_NEGATIVE) {
                signs = if lengths.within(Signs::POSITIVE) { beyond } else { beyond.or(Signs::ZERO) };
                break;
            }
            known.forget_used();
        }
        known.asked.borrow_mut().extend(before.0);
        known.put_in.borrow_mut().extend(before.1);
        Ok(signs)
    }

    /// The signs that the definition gives to every member of a sequence, and cited facts `for all k natural: f(k) relation
    /// numeral` to every member of a family or sequence. Such a fact may be for the indices of the family's declaration:
    /// other members do not exist.
    fn member_signs(&self, member: &str, known: &Known) -> Result<Signs, Refusal> {
        let indices = self.family(member).and_then(|b| b.indices.as_ref());
        let mut signs = self.signs_of_members.get(member).copied().unwrap_or(Signs::ANY);
        for (binding, body, place) in &known.for_all {
            let for_every_index = match (binding.constraints.as_slice(), indices) {
                ([], _) => true,
                ([Constraint::Range(a, b)], Some((from, to))) => {
                    key::expr(a) == key::expr(from) && key::expr(b) == key::expr(to)
                }
                _ => false,
            };
            let Some((index, None)) = binding.names.first().filter(|_| binding.natural && for_every_index) else {
                continue;
            };
            for part in conjuncts(body) {
                let Ok((Expr { kind: ExprKind::Apply(f, arguments), .. }, relation, bound)) = single(part) else {
                    continue;
                };
                let of_index =
                    matches!(arguments.as_slice(), [Expr { kind: ExprKind::Name(n), .. }] if *n == index.text);
                let ExprKind::Number(bound) = &bound.kind else { continue };
                if f.text == member && of_index {
                    let bound = super::term::numeral(bound)?;
                    // x relation b with b ≥ 0: x is the sum of x − b and b.
                    let given = Signs::of(relation).plus(Signs::of_number(&bound));
                    if !signs.within(given) {
                        signs = signs.and(given);
                        known.asked.borrow_mut().insert(*place);
                    }
                }
            }
        }
        Ok(signs)
    }
}
