//! Signs: of polynomials by their terms and by facts, and the two rules that show comparisons.

use super::marks::Sources;
use super::step::Step;
use super::translate::{Atom, Value};
use super::{Draft, Failure, declined, rejected};
use crate::claim::syntax::*;
use crate::kernel::fraction::{Fraction, Poly};
use crate::kernel::order::Signs;
use crate::kernel::statement::{constraints, name};
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

/// How deep signs of products over an index may nest.
const NESTING: usize = 20;

/// A polynomial of known signs.
#[derive(Clone, Debug)]
pub(super) struct Note {
    poly: Rc<Poly>,
    signs: Signs,
    /// What says so.
    because: Rc<Sources>,
}

/// Signs with what they are known from.
#[derive(Clone)]
struct Seen {
    signs: Signs,
    because: Sources,
}

impl Seen {
    fn of(signs: Signs) -> Seen {
        Seen { signs, because: Sources::default() }
    }

    /// The signs in both, from no more than is needed: the first alone, else the second alone, else both.
    fn and(mut self, other: Seen) -> Seen {
        if other.signs.within(self.signs) && self.signs != other.signs {
            return other;
        }
        if !self.signs.within(other.signs) {
            self.because.extend(&other.because);
        }
        Seen { signs: self.signs.and(other.signs), because: self.because }
    }
}

/// The signs of atoms found so far in one question.
type Found = BTreeMap<usize, Seen>;

impl Draft {
    /// The signs of a fraction: the product of the signs of its factors.
    pub(crate) fn signs_of(&self, f: &Fraction) -> Result<Signs, Failure> {
        let seen = self.fraction_signs(f, NESTING, &mut BTreeMap::new())?;
        self.consult_all(&seen.because);
        Ok(seen.signs)
    }

    fn fraction_signs(&self, f: &Fraction, depth: usize, found: &mut Found) -> Result<Seen, Failure> {
        let mut out = Seen::of(Signs::of_number(&f.coefficient));
        for (poly, k) in &f.factors {
            let seen = self.poly_signs_in(poly, depth, found)?;
            out.signs = out.signs.times(seen.signs.power(*k));
            out.because.extend(&seen.because);
        }
        Ok(out)
    }

    /// The signs of a polynomial: those noted of it, and those of the sum of its terms.
    pub(crate) fn poly_signs(&self, poly: &Poly) -> Result<Signs, Failure> {
        let seen = self.poly_signs_in(poly, NESTING, &mut BTreeMap::new())?;
        self.consult_all(&seen.because);
        Ok(seen.signs)
    }

    fn noted(&self, poly: &Poly) -> Result<Seen, Failure> {
        self.work.count(self.signs.len() + poly.size())?;
        let mut kept: Vec<&Note> = Vec::new();
        let all = |notes: &[&Note]| notes.iter().fold(Signs::ANY, |all, note| all.and(note.signs));
        for note in self.signs.iter().filter(|note| *note.poly == *poly) {
            if !all(&kept).within(note.signs) {
                kept.push(note);
            }
        }
        let signs = all(&kept);
        // An earlier note may say less than a later one.
        for place in (0..kept.len()).rev() {
            let mut fewer = kept.clone();
            fewer.remove(place);
            if all(&fewer) == signs {
                kept = fewer;
            }
        }
        let mut seen = Seen::of(signs);
        kept.iter().for_each(|note| seen.because.extend(&note.because));
        Ok(seen)
    }

    fn poly_signs_in(&self, poly: &Poly, depth: usize, found: &mut Found) -> Result<Seen, Failure> {
        if let Some(atom) = poly.single_atom() {
            return self.atom_signs(atom, depth, found);
        }
        let mut sum = Seen::of(Signs::ZERO);
        for (monomial, c) in poly.terms() {
            let mut term = Signs::of_number(c);
            for (atom, k) in monomial {
                term = term.times(self.atom_signs(*atom, depth, found)?.signs.power(i64::from(*k)));
            }
            sum.signs = sum.signs.plus(term);
        }
        if sum.signs != Signs::ANY {
            for atom in poly.atoms().collect::<BTreeSet<_>>() {
                found.get(&atom).iter().for_each(|seen| sum.because.extend(&seen.because));
            }
        }
        Ok(sum.and(self.noted(poly)?))
    }

    /// The signs of an atom, sought once in each question: an atom may stand in every term, and what it is
    /// made of in every term of that.
    fn atom_signs(&self, atom: usize, depth: usize, found: &mut Found) -> Result<Seen, Failure> {
        if let Some(seen) = found.get(&atom) {
            return Ok(seen.clone());
        }
        let seen = self.structural(atom, depth, found)?.and(self.noted(&Poly::atom(atom))?);
        found.insert(atom, seen.clone());
        Ok(seen)
    }

    /// What the kind of an atom says of its sign: naturals are not negative, exponentials positive, a
    /// logarithm has the sign of its argument less 1, a
    /// member of a family lies in its domain, and products (sums) of positive bodies are positive
    /// (not negative: a range may be empty).
    fn structural(&self, atom: usize, depth: usize, found: &mut Found) -> Result<Seen, Failure> {
        let Some(depth) = depth.checked_sub(1) else { return declined("nesting of products") };
        Ok(match self.atom(atom) {
            Some(Atom::Variable(name)) => match self.variable(name).filter(|v| v.natural) {
                Some(variable) => {
                    let because = variable.source.map_or_else(Sources::default, Sources::one);
                    Seen { signs: Signs::NOT_NEGATIVE, because }
                }
                None => Seen::of(Signs::ANY),
            },
            Some(Atom::Bound(_)) => Seen::of(Signs::NOT_NEGATIVE),
            Some(Atom::Exponential(_)) => Seen::of(Signs::POSITIVE),
            // ln p rises with p, and ln 1 = 0.
            Some(Atom::Logarithm(inner)) => {
                let one = Fraction::integer(-1);
                let shifted = Fraction::sum(&[Fraction::of(inner), one], &self.work)?;
                self.fraction_signs(&shifted, depth, found)?
            }
            Some(Atom::Member(name, _)) => self.family_signs(name),
            Some(Atom::Over(is_sum, _, _, _, body)) => {
                let body = self.fraction_signs(body, depth, found)?;
                let kinds = match is_sum {
                    true => vec![Signs::NOT_NEGATIVE],
                    false => vec![Signs::POSITIVE, Signs::NOT_NEGATIVE, Signs::NOT_ZERO],
                };
                match kinds.into_iter().find(|kind| body.signs.within(*kind)) {
                    Some(signs) => Seen { signs, ..body },
                    None => Seen::of(Signs::ANY),
                }
            }
            None => Seen::of(Signs::ANY),
        })
    }

    /// The signs that the domain of a family allows, from comparisons with numerals.
    fn family_signs(&self, family: &str) -> Seen {
        let Some(family_of) = self.family(family) else { return Seen::of(Signs::ANY) };
        let mut signs = if family_of.binding.natural { Signs::NOT_NEGATIVE } else { Signs::ANY };
        for prop in constraints(family_of.binding, &name(family)) {
            let PropKind::Compare(sides, relations) = &prop.kind else { continue };
            let (Some(Expr { kind: ExprKind::Number(bound), .. }), Some(relation)) = (sides.get(1), relations.first())
            else {
                continue;
            };
            let Ok(bound) = crate::kernel::numeral(bound) else { continue };
            // x relation b with b ≥ 0: x is the sum of x − b and b.
            signs = signs.and(Signs::of(*relation).plus(Signs::of_number(&bound)));
        }
        Seen { signs, because: Sources::one(family_of.source) }
    }

    /// The difference of the two sides of a single comparison.
    pub(crate) fn difference(&mut self, prop: &Prop) -> Result<(Fraction, Relation), Failure> {
        let PropKind::Compare(sides, relations) = &prop.kind else { return rejected("a comparison is needed") };
        let ([a, b], [relation]) = (sides.as_slice(), relations.as_slice()) else {
            return rejected("a single comparison is needed, not a chain");
        };
        let (a, b) = (self.scalar(a)?, self.scalar(b)?);
        Ok((a.minus(&b, &self.work)?, *relation))
    }

    /// Notes what a fact `a relation b` says of the sign of the one factor of a − b that is open.
    ///
    /// With `granted` its divisors are noted to be other than 0 first: a fact has values on both sides.
    pub(super) fn note_comparison(&mut self, prop: &Prop, granted: bool) -> Result<(), Failure> {
        if granted {
            for divisor in divisors(prop) {
                let f = self.scalar(&divisor)?;
                self.note_signs(&f, Signs::NOT_ZERO)?;
            }
        }
        let (difference, relation) = self.difference(prop)?;
        self.note_signs(&difference, Signs::of(relation))
    }

    fn note_signs(&mut self, f: &Fraction, allowed: Signs) -> Result<(), Failure> {
        let mut rest = Signs::of_number(&f.coefficient);
        let mut open = Vec::new();
        for (poly, k) in &f.factors {
            let seen = self.poly_signs_in(poly, NESTING, &mut BTreeMap::new())?;
            let signs = seen.signs.power(*k);
            let strict = signs.within(Signs::POSITIVE) || signs.within(Signs::of(Relation::Less));
            if strict {
                rest = rest.times(signs);
                self.consult_all(&seen.because);
            } else {
                open.push((Rc::new(poly.clone()), *k));
            }
        }
        // What the translation and the signs of the other factors needed, and what is noted here.
        let mut because = self.used.borrow().clone();
        because.add(self.now);
        let because = Rc::new(because);
        let note = |poly: &Rc<Poly>, signs| Note { poly: poly.clone(), signs, because: because.clone() };
        if allowed.within(Signs::NOT_ZERO) {
            // A product that is not 0 has no factor that is.
            self.signs.extend(open.iter().map(|(poly, _)| note(poly, Signs::NOT_ZERO)));
        }
        if let [(poly, k)] = open.as_slice()
            && rest.within(Signs::NOT_ZERO)
        {
            // The factor's sign is one whose power, times the rest, is allowed.
            let signs = [Signs::of(Relation::Less), Signs::ZERO, Signs::POSITIVE]
                .into_iter()
                .filter(|s| !(*k < 0 && *s == Signs::ZERO) && s.power(*k).times(rest).within(allowed))
                .reduce(Signs::or);
            // No sign at all: the facts contradict each other, which is not said here.
            self.signs.extend(signs.map(|signs| note(poly, signs)));
        }
        Ok(())
    }

    /// Rule `note`. From a fact, nothing new: its sign is written down for later steps, with the atoms
    /// as they are now, and that its divisors are not 0.
    ///
    /// Sound: a − b is the product of its factors; if all but one have one known sign other than 0,
    /// then `a relation b` says which signs the last can have. Every expression in a fact has a value (a
    /// hypothesis of the claim is understood to say so of itself), so its divisors are not 0.
    pub(super) fn note(&mut self, step: &Step) -> Result<(), Failure> {
        let fact = self.cited_fact(step)?;
        match &fact.kind {
            PropKind::Compare(sides, relations) => {
                for (pair, relation) in sides.windows(2).zip(relations) {
                    let single = Prop { kind: PropKind::Compare(pair.to_vec(), vec![*relation]), span: fact.span };
                    self.note_comparison(&single, true)?;
                }
                Ok(())
            }
            _ => rejected("a comparison is needed"),
        }
    }

    /// Rule `sign`: `a relation b`, if the signs of the factors of a − b leave no others; for matrices
    /// equality, entry by entry.
    ///
    /// Sound: both sides are translated, so they have values; a − b equals c·∏ pᵢ^kᵢ; every pᵢ has one
    /// of the signs noted of it, and one that the signs of its terms allow; the sign of a product is
    /// the product of signs. Matrices are equal iff their entries are.
    pub(super) fn sign(&mut self, step: &Step) -> Result<(), Failure> {
        let prop = Self::shown(step)?;
        if let PropKind::Compare(sides, relations) = &prop.kind
            && let ([a, b], [Relation::Equal]) = (sides.as_slice(), relations.as_slice())
            && let Value::Matrix(x) = self.value(a, crate::kernel::substitution::DEPTH_LIMIT)?
        {
            let Value::Matrix(y) = self.value(b, crate::kernel::substitution::DEPTH_LIMIT)? else {
                return rejected("a matrix is compared with a number");
            };
            if x.len() != y.len() || x.iter().zip(&y).any(|(r, s)| r.len() != s.len()) {
                return rejected("the sizes of these matrices differ");
            }
            for (p, q) in x.iter().flatten().zip(y.iter().flatten()) {
                let difference = p.minus(q, &self.work)?;
                if !self.signs_of(&difference)?.within(Signs::ZERO) {
                    return rejected("two entries are not shown to be equal");
                }
            }
            return self.know(&step.label, prop.clone());
        }
        let (difference, relation) = self.difference(prop)?;
        let signs = self.signs_of(&difference)?;
        if !signs.within(Signs::of(relation)) {
            return rejected("the signs of the factors of the difference do not show this");
        }
        self.know(&step.label, prop.clone())
    }

    /// Rule `combination`: `a relation b` from D·(a − b) = Σ Eⱼ·∏ (xⱼ − yⱼ) over facts `xⱼ relation yⱼ`.
    ///
    /// Sound: D, the Eⱼ and the facts have values and known signs, so the right side has the signs of
    /// the sum of products; the identity is verified in the atoms; dividing by D, whose sign is known
    /// and not 0, gives those of a − b.
    pub(super) fn combination(&mut self, step: &Step) -> Result<(), Failure> {
        let prop = Self::shown(step)?;
        let (difference, relation) = self.difference(prop)?;
        let times = match &step.times {
            Some(e) => self.scalar(e)?,
            None => Fraction::integer(1),
        };
        let mut signs = Signs::ZERO;
        let mut terms = vec![times.times(&difference, &self.work)?.negated()];
        for term in &step.terms {
            let mut product = self.scalar(&term.factor)?;
            let mut sign = self.signs_of(&product)?;
            for label in &term.facts {
                let fact = self.fact(label)?;
                let (value, relation) = self.difference(&fact)?;
                product.multiply(&value, &self.work)?;
                sign = sign.times(Signs::of(relation));
            }
            signs = signs.plus(sign);
            terms.push(product);
        }
        if !Fraction::sum(&terms, &self.work)?.is_zero() {
            return rejected("the combination is not the difference of the two sides");
        }
        let divisor = self.signs_of(&times)?;
        if !divisor.within(Signs::NOT_ZERO) {
            return rejected("the multiplier may be 0");
        }
        if !signs.times(divisor).within(Signs::of(relation)) {
            return rejected("the signs of the summands do not show this");
        }
        self.know(&step.label, prop.clone())
    }
}

/// The divisors in a comparison, innermost first, but for those under a bound name.
fn divisors(prop: &Prop) -> Vec<Expr> {
    let mut out = Vec::new();
    if let PropKind::Compare(sides, _) = &prop.kind {
        sides.iter().for_each(|e| divisors_in(e, &mut out));
    }
    out
}

fn divisors_in(e: &Expr, out: &mut Vec<Expr>) {
    match &e.kind {
        ExprKind::Number(_) | ExprKind::Name(_) => {}
        ExprKind::SumOver(..) | ExprKind::ProductOver(..) | ExprKind::Derivative(..) => {}
        ExprKind::Apply(_, list) => list.iter().for_each(|e| divisors_in(e, out)),
        ExprKind::Negate(a) => divisors_in(a, out),
        ExprKind::Sum(list) => list.iter().for_each(|(_, e)| divisors_in(e, out)),
        ExprKind::Product(list) => {
            for (factor, e) in list {
                divisors_in(e, out);
                if *factor == Factor::Over {
                    out.push(e.clone());
                }
            }
        }
        ExprKind::Power(a, b) => {
            divisors_in(a, out);
            divisors_in(b, out);
        }
        ExprKind::Matrix(rows) => rows.iter().flatten().for_each(|e| divisors_in(e, out)),
    }
}
