//! The signs of fractions, from the facts that a step cites.
//!
//! Contract: at every point that the facts allow, a fraction whose expression has a value there has one of the signs
//! that [`Checker::signs_of`] returns. Nothing is known but what [`Known`] was told for this one step, and what an
//! atom's form says: naturals and roots are not negative, exponentials are positive.

use super::term::{Atom, Value};
use super::{Checker, Reason, Refusal, rejected};
use crate::claim::definedness::{Need, needs};
use crate::claim::syntax::*;
use crate::kernel::fraction::{Fraction, Poly};
use crate::kernel::order::Signs;
use crate::kernel::statement::{constraints, name};
use num_traits::Signed;
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

/// How deep signs of products over an index may nest.
const NESTING: usize = 20;

/// What a step knows: the signs that its cited facts give, and the equations that it replaces by. It marks which of
/// them were asked for.
#[derive(Default)]
pub(super) struct Known {
    signs: Vec<Sign>,
    equations: Rc<Vec<(usize, Fraction)>>,
    /// Cited facts for all values of one natural variable, with their places under `by`.
    pub(super) for_all: Vec<(Binding, Prop, usize)>,
    /// The places under `by` that the answers so far rest on.
    asked: RefCell<BTreeSet<usize>>,
    /// The places under `using` of the equations that were put in.
    put_in: RefCell<BTreeSet<usize>>,
    /// The place under `by` of the fact that is taken in, if it is one of those.
    source: Option<usize>,
}

/// The signs of a polynomial, with the places under `by` of the facts that it is known from.
struct Sign {
    poly: Poly,
    signs: Signs,
    from: Rc<BTreeSet<usize>>,
}

impl Known {
    /// The places under `by` and under `using` of what was asked for.
    pub(super) fn used(&self) -> (BTreeSet<usize>, BTreeSet<usize>) {
        (self.asked.borrow().clone(), self.put_in.borrow().clone())
    }

    /// The equations that are put in.
    pub(super) fn equations(&self) -> Rc<Vec<(usize, Fraction)>> {
        self.equations.clone()
    }

    /// Says that the equations at these places were put in.
    pub(super) fn mark_put_in(&self, places: BTreeSet<usize>) {
        self.put_in.borrow_mut().extend(places);
    }

    /// Says that what is learned from here on comes from the fact at that place under `by`.
    pub(super) fn comes_from(&mut self, source: Option<usize>) {
        self.source = source;
    }

    /// How much is known, to go back to.
    pub(super) fn len(&self) -> usize {
        self.signs.len()
    }

    /// Forgets what was learned since.
    pub(super) fn truncate(&mut self, len: usize) {
        self.signs.truncate(len);
    }
}

/// The signs of atoms found so far in one question.
type Found = BTreeMap<usize, Signs>;

impl Checker {
    /// What the facts under `by` say of signs, in order, with the equations under `using`.
    pub(super) fn known(&mut self, by: &[String], using: &[String]) -> Result<Known, Refusal> {
        let mut known = Known::default();
        for label in using {
            let fact = self.fact(label)?;
            let (atom, value) = self.atom_equation(&fact, &known)?;
            // Earlier values that hold the atom are written anew.
            let mut equations = Vec::new();
            for (earlier, old) in known.equations.iter() {
                equations.push((*earlier, self.replaced(old, atom, &value)?));
            }
            equations.push((atom, value));
            known.equations = Rc::new(equations);
        }
        for (place, label) in by.iter().enumerate() {
            let fact = self.fact(label)?;
            known.comes_from(Some(place));
            self.learn(&fact, &mut known)?;
        }
        known.comes_from(None);
        known.asked.take();
        Ok(known)
    }

    /// The atom on the left of an equation, and the right side; equations before it are put in.
    pub(super) fn atom_equation(&mut self, fact: &Prop, known: &Known) -> Result<(usize, Fraction), Refusal> {
        let (left, relation, right) = single(fact)?;
        if relation != Relation::Equal {
            return rejected(Reason::NotAnEquation);
        }
        let (left, right) = (self.fraction_with(left, known)?, self.fraction_with(right, known)?);
        let atom = match left.factors.iter().next() {
            Some((poly, 1)) if left.factors.len() == 1 => poly.single_atom(),
            _ => None,
        };
        // c·A = B says A = B/c.
        let inverse = Fraction::number(left.coefficient.clone());
        match atom {
            Some(atom) => Ok((atom, right.times(&inverse.power(-1)?, &self.work)?)),
            None => rejected(Reason::NotAnAtom),
        }
    }

    /// Takes in what a fact says of signs: of the difference of its sides, and of whatever its expressions need to have
    /// values, for a fact has them.
    pub(super) fn learn(&mut self, fact: &Prop, known: &mut Known) -> Result<(), Refusal> {
        match &fact.kind {
            PropKind::Compare(sides, relations) => {
                for side in sides {
                    self.learn_needs(side, known)?;
                }
                for (pair, relation) in sides.windows(2).zip(relations) {
                    let [a, b] = pair else { continue };
                    if let (Value::Scalar(x), Value::Scalar(y)) = (self.value(a)?, self.value(b)?) {
                        let difference = x.minus(&y, &self.work)?;
                        self.note(&difference, Signs::of(*relation), known)?;
                        if !known.equations.is_empty() {
                            let (x, y) = (self.fraction_with(a, known)?, self.fraction_with(b, known)?);
                            let replaced = x.minus(&y, &self.work)?;
                            if replaced != difference {
                                self.note(&replaced, Signs::of(*relation), known)?;
                            }
                        }
                    }
                }
                Ok(())
            }
            PropKind::And(list) => list.iter().try_for_each(|p| self.learn(p, known)),
            PropKind::ForAll(bindings, body) => match bindings.as_slice() {
                [binding] if binding.natural && binding.names.len() == 1 => {
                    let place = known.source.unwrap_or_default();
                    known.for_all.push((binding.clone(), (**body).clone(), place));
                    Ok(())
                }
                _ => Ok(()),
            },
            _ => Ok(()),
        }
    }

    /// What an expression that has a value needed for that, innermost first; not under bound names.
    fn learn_needs(&mut self, e: &Expr, known: &mut Known) -> Result<(), Refusal> {
        if !matches!(e.kind, ExprKind::SumOver(..) | ExprKind::ProductOver(..) | ExprKind::Derivative(..)) {
            for part in super::parts(e) {
                self.learn_needs(part, known)?;
            }
        }
        let natural = self.natural_names();
        for need in needs(e, &|name| natural.contains(name)) {
            let (part, signs) = match need {
                Need::NotZero(e) => (e, Signs::NOT_ZERO),
                Need::Positive(e) => (e, Signs::POSITIVE),
                Need::NotNegative(e) => (e, Signs::NOT_NEGATIVE),
                Need::NotZeroOrNatural(..) | Need::Range(..) | Need::Differentiable(..) => continue,
            };
            let f = self.fraction(&part)?;
            self.learn_signs(&f, signs, known)?;
        }
        Ok(())
    }

    /// Notes what a sign of a fraction says of the one factor whose sign is open; as it stands, and with the equations.
    pub(super) fn learn_signs(&mut self, f: &Fraction, allowed: Signs, known: &mut Known) -> Result<(), Refusal> {
        self.note(f, allowed, known)?;
        if known.equations.is_empty() {
            return Ok(());
        }
        let replaced = self.with_equations(f, known)?;
        if replaced == *f { Ok(()) } else { self.note(&replaced, allowed, known) }
    }

    /// Sound: a fraction is the product of its factors. If it is not 0, no factor is; if all but one have one known
    /// sign other than 0, the last has a sign whose power, times theirs, is allowed.
    fn note(&self, f: &Fraction, allowed: Signs, known: &mut Known) -> Result<(), Refusal> {
        let before = known.asked.take();
        let mut rest = Signs::of_number(&f.coefficient);
        let mut open = Vec::new();
        for (poly, k) in &f.factors {
            let signs = self.poly_signs(poly, known, NESTING, &mut Found::new())?.power(*k);
            let strict = signs.within(Signs::POSITIVE) || signs.within(Signs::of(Relation::Less));
            if strict { rest = rest.times(signs) } else { open.push((poly.clone(), *k)) }
        }
        // What the signs of the other factors rest on, this rests on as well.
        let mut from = known.asked.replace(before);
        from.extend(known.source);
        let from = Rc::new(from);
        let mut add = |poly: &Poly, signs| known.signs.push(Sign { poly: poly.clone(), signs, from: from.clone() });
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

    /// The signs of a fraction, with the equations put in.
    pub(super) fn signs_of(&mut self, f: &Fraction, known: &Known) -> Result<Signs, Refusal> {
        let plain = self.fraction_signs(f, known, NESTING, &mut Found::new())?;
        if known.equations.is_empty() {
            return Ok(plain);
        }
        let replaced = self.with_equations(f, known)?;
        Ok(plain.and(self.fraction_signs(&replaced, known, NESTING, &mut Found::new())?))
    }

    /// A fraction with the equations put in.
    pub(super) fn with_equations(&mut self, f: &Fraction, known: &Known) -> Result<Fraction, Refusal> {
        let mut out = f.clone();
        for (place, (atom, value)) in known.equations().iter().enumerate() {
            let new = self.replaced(&out, *atom, value)?;
            if new != out {
                known.put_in.borrow_mut().insert(place);
                out = new;
            }
        }
        Ok(out)
    }

    fn fraction_signs(&self, f: &Fraction, known: &Known, depth: usize, found: &mut Found) -> Result<Signs, Refusal> {
        let mut signs = Signs::of_number(&f.coefficient);
        for (poly, k) in &f.factors {
            signs = signs.times(self.poly_signs(poly, known, depth, found)?.power(*k));
        }
        Ok(signs)
    }

    fn noted(&self, poly: &Poly, known: &Known) -> Result<Signs, Refusal> {
        self.work.count(known.signs.len() + poly.size())?;
        let mut all = Signs::ANY;
        for sign in known.signs.iter().filter(|s| s.poly == *poly) {
            // Only what says something new is asked for.
            if !all.within(sign.signs) {
                all = all.and(sign.signs);
                known.asked.borrow_mut().extend(sign.from.iter().copied());
            }
        }
        Ok(all)
    }

    /// The signs of a polynomial: those noted of it, and those of the sum of its terms.
    fn poly_signs(&self, poly: &Poly, known: &Known, depth: usize, found: &mut Found) -> Result<Signs, Refusal> {
        if let Some(atom) = poly.single_atom() {
            return self.atom_signs(atom, known, depth, found);
        }
        let mut sum = Signs::ZERO;
        for (monomial, c) in poly.terms() {
            let mut term = Signs::of_number(c);
            for (atom, k) in monomial {
                term = term.times(self.atom_signs(*atom, known, depth, found)?.power(i64::from(*k)));
            }
            sum = sum.plus(term);
        }
        // What follows from the terms alone need not be asked for.
        let strict = sum.within(Signs::POSITIVE) || sum.within(Signs::of(Relation::Less)) || sum.within(Signs::ZERO);
        if strict { Ok(sum) } else { Ok(sum.and(self.noted(poly, known)?)) }
    }

    /// The signs of an atom, sought once in each question: an atom may stand in every term.
    fn atom_signs(&self, atom: usize, known: &Known, depth: usize, found: &mut Found) -> Result<Signs, Refusal> {
        if let Some(signs) = found.get(&atom) {
            return Ok(*signs);
        }
        let signs = self.noted(&Poly::atom(atom), known)?.and(self.structural(atom, known, depth, found)?);
        found.insert(atom, signs);
        Ok(signs)
    }

    /// What the form of an atom says of its sign. Atoms that have no value at a point have no sign there.
    fn structural(&self, atom: usize, known: &Known, depth: usize, found: &mut Found) -> Result<Signs, Refusal> {
        let Some(depth) = depth.checked_sub(1) else { return Err(Refusal::Limit("nesting of products")) };
        if self.is_natural_atom(atom) {
            return Ok(Signs::NOT_NEGATIVE);
        }
        Ok(match self.atoms.get(atom) {
            Some(Atom::Exponential(_)) => Signs::POSITIVE,
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
            Some(Atom::Member(name, _)) => self.family_signs(name)?,
            Some(Atom::Over(over)) => {
                let body = self.fraction_signs(&over.body, known, depth, found)?;
                // A range may be empty: an empty sum is 0, an empty product 1.
                let kinds = if over.sum {
                    vec![Signs::NOT_NEGATIVE]
                } else {
                    vec![Signs::POSITIVE, Signs::NOT_NEGATIVE, Signs::NOT_ZERO]
                };
                kinds.into_iter().find(|kind| body.within(*kind)).unwrap_or(Signs::ANY)
            }
            _ => Signs::ANY,
        })
    }

    /// The signs that the domain of a family allows, from comparisons with numerals.
    fn family_signs(&self, family: &str) -> Result<Signs, Refusal> {
        let Some(binding) = self.family(family) else { return Ok(Signs::ANY) };
        let mut signs = if binding.natural { Signs::NOT_NEGATIVE } else { Signs::ANY };
        for prop in constraints(binding, &name(family)) {
            let PropKind::Compare(sides, relations) = &prop.kind else { continue };
            let (Some(Expr { kind: ExprKind::Number(bound), .. }), Some(relation)) = (sides.get(1), relations.first())
            else {
                continue;
            };
            let bound = super::term::numeral(bound)?;
            // x relation b with b ≥ 0: x is the sum of x − b and b.
            signs = signs.and(Signs::of(*relation).plus(Signs::of_number(&bound)));
        }
        Ok(signs)
    }
}

/// The sides and the relation of a single comparison.
pub(super) fn single(prop: &Prop) -> Result<(&Expr, Relation, &Expr), Refusal> {
    if let PropKind::Compare(sides, relations) = &prop.kind
        && let ([a, b], [relation]) = (sides.as_slice(), relations.as_slice())
    {
        return Ok((a, *relation, b));
    }
    rejected(Reason::NotSingle)
}
