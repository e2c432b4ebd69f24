//! What a step knows: the signs and equations that the facts it cites give, and which of them it asked for.
//!
//! Contract: nothing is known but what the facts under `by` and the equations under `using` say, and what their expressions
//! need to have values.

use super::fraction::{Fraction, Poly};
use super::interval::{Intervals, bounded_atoms};
use super::order::Signs;
use super::term::Value;
use super::tree::{parts, single};
use super::{Checker, Reason, Refusal, rejected};
use crate::claim::definedness::{Need, needs};
use crate::claim::syntax::*;
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

/// What a step knows: the signs that its cited facts give, and the equations that it replaces by. It marks which of
/// them were asked for.
#[derive(Default)]
pub(super) struct Known {
    pub(super) signs: Vec<Sign>,
    /// The places among them of the signs of each polynomial, in order.
    pub(super) places: BTreeMap<Poly, Vec<usize>>,
    /// The places among them of those that bound an atom by others, in order.
    pub(super) bounds: BTreeMap<usize, Vec<usize>>,
    /// The intervals that these give to atoms.
    pub(super) intervals: RefCell<Intervals>,
    pub(super) equations: Rc<Vec<Equation>>,
    /// The ranges of the indices in scope.
    pub(super) ranges: Vec<Range>,
    /// Cited facts for all values of one variable, with their places under `by`.
    pub(super) for_all: Vec<(Binding, Prop, usize)>,
    /// The places under `by` that the answers so far rest on.
    pub(super) asked: RefCell<BTreeSet<usize>>,
    /// The places under `using` of the equations that were put in.
    pub(super) put_in: RefCell<BTreeSet<usize>>,
    /// The place under `by` of the fact that is taken in, if it is one of those.
    pub(super) source: Option<usize>,
    /// The facts under `by` in order, with how much was known before each was taken in.
    cited: Vec<(Rc<Prop>, Mark)>,
    /// How much the facts under `by` say in all.
    whole: Mark,
}

/// An equation whose left side is replaced by its right side while a step is read.
#[derive(Clone, Debug)]
pub(super) struct Equation {
    /// The atom that the left side comes to, and what it equals.
    pub(super) atom: Option<(usize, Fraction)>,
    /// The power or exponential that stands on the left, and what it equals.
    pub(super) power: Option<(Written, Fraction)>,
    /// The places of the equations that this comes from, its own among them.
    pub(super) rests_on: BTreeSet<usize>,
}

/// A power or exponential as it is written, its parts as fractions without any equation put in.
///
/// Where two of them have values and their parts are equal, so are they.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Written {
    /// b^E.
    Power(Fraction, Fraction),
    /// exp of a fraction.
    Exponential(Fraction),
}

/// The signs of a polynomial, with the places under `by` and under `using` of the facts that they are known from.
pub(super) struct Sign {
    pub(super) poly: Poly,
    pub(super) signs: Signs,
    pub(super) from: Rc<BTreeSet<usize>>,
    pub(super) put_in: Rc<BTreeSet<usize>>,
}

/// The whole numbers that an index takes: its atom, and the first and the last of them.
#[derive(Clone)]
pub(super) struct Range {
    pub(super) index: usize,
    pub(super) from: Poly,
    pub(super) to: Poly,
}

/// What a fact says.
pub(super) enum Lesson {
    /// The signs that a fraction may have, with the places of the equations that were put in to read it.
    Sign(Fraction, Signs, BTreeSet<usize>),
    /// Something for all values of one variable.
    ForAll(Box<Binding>, Prop),
}

/// How much a step knew at some point.
#[derive(Clone, Copy, Default)]
pub(super) struct Mark {
    signs: usize,
    ranges: usize,
    for_all: usize,
}

impl Known {
    /// The places under `by` and under `using` of what was asked for.
    pub(super) fn used(&self) -> (BTreeSet<usize>, BTreeSet<usize>) {
        (self.asked.borrow().clone(), self.put_in.borrow().clone())
    }

    /// Notes that the answers rest on all the equations.
    pub(super) fn all_put_in(&self, count: usize) {
        self.put_in.borrow_mut().extend(0..count);
    }

    /// Begins anew to note what is asked for.
    pub(super) fn forget_used(&self) {
        self.asked.take();
        self.put_in.take();
    }

    /// How many of these facts, from the first on, it was told under `by`.
    pub(super) fn shared(&self, facts: &[Rc<Prop>]) -> usize {
        self.cited.iter().zip(facts).take_while(|(known, fact)| Rc::ptr_eq(&known.0, fact)).count()
    }

    /// How many facts it was told under `by`.
    pub(super) fn count(&self) -> usize {
        self.cited.len()
    }

    /// Goes back to what the first of the facts under `by` say.
    pub(super) fn only(&mut self, count: usize) {
        self.back_to(self.cited.get(count).map_or(self.whole, |cited| cited.1));
        self.cited.truncate(count);
        self.comes_from(None);
        self.forget_used();
    }

    /// The equations that are put in.
    pub(super) fn equations(&self) -> Rc<Vec<Equation>> {
        self.equations.clone()
    }

    /// Says that the equations at these places were put in.
    pub(super) fn mark_put_in(&self, places: BTreeSet<usize>) {
        self.put_in.borrow_mut().extend(places);
    }

    pub(super) fn add(&mut self, sign: Sign) {
        self.intervals.take();
        self.places.entry(sign.poly.clone()).or_default().push(self.signs.len());
        for atom in bounded_atoms(&sign.poly) {
            self.bounds.entry(atom).or_default().push(self.signs.len());
        }
        self.signs.push(sign);
    }

    /// Says that what is learned from here on comes from the fact at that place under `by`.
    pub(super) fn comes_from(&mut self, source: Option<usize>) {
        self.source = source;
    }

    /// How much is known, to go back to.
    pub(super) fn mark(&self) -> Mark {
        Mark { signs: self.signs.len(), ranges: self.ranges.len(), for_all: self.for_all.len() }
    }

    /// Forgets what was learned since.
    pub(super) fn back_to(&mut self, mark: Mark) {
        self.intervals.take();
        for sign in self.signs.drain(mark.signs..) {
            if let Some(places) = self.places.get_mut(&sign.poly) {
                places.pop();
            }
            for atom in bounded_atoms(&sign.poly) {
                self.bounds.entry(atom).or_default().pop();
            }
        }
        self.ranges.truncate(mark.ranges);
        self.for_all.truncate(mark.for_all);
    }

    /// Forgets the facts for all values that were learned since.
    pub(super) fn forget_for_all(&mut self, mark: Mark) {
        self.for_all.truncate(mark.for_all);
    }
}

impl Checker {
    /// What the facts under `by` say of signs, in order, with the equations under `using`.
    pub(super) fn known(&mut self, by: &[String], using: &[String]) -> Result<Known, Refusal> {
        self.memo.begin(&self.scope);
        let facts = using.iter().map(|label| self.fact(label)).collect::<Result<Vec<_>, _>>()?;
        let equations = match self.memo.equations(&facts) {
            Some(equations) => equations,
            None => {
                let equations = Rc::new(self.equations(&facts)?);
                self.memo.put_in(facts, &equations);
                equations
            }
        };
        let facts = by.iter().map(|label| self.fact(label)).collect::<Result<Vec<_>, _>>()?;
        let mut known = self.memo.told(&facts).unwrap_or_else(|| Known { equations, ..Known::default() });
        for (place, fact) in facts.iter().enumerate().skip(known.count()) {
            known.cited.push((fact.clone(), known.mark()));
            let lessons = match self.memo.lessons(fact) {
                Some(lessons) => lessons,
                None => {
                    let mut lessons = Vec::new();
                    self.read_fact(fact, &known, &mut lessons)?;
                    let lessons = Rc::new(lessons);
                    self.memo.keep_lessons(fact, &lessons);
                    lessons
                }
            };
            known.comes_from(Some(place));
            self.take_in(&lessons, &mut known)?;
        }
        known.whole = known.mark();
        known.comes_from(None);
        known.forget_used();
        Ok(known)
    }

    /// Facts as equations, each with those before it put in; earlier values that hold its atom are written anew.
    fn equations(&mut self, facts: &[Rc<Prop>]) -> Result<Vec<Equation>, Refusal> {
        // Those of the first facts do not depend on those behind.
        let mut equations: Vec<Equation> = self.memo.first_equations(facts);
        for (place, fact) in facts.iter().enumerate().skip(equations.len()) {
            let known = Known { equations: Rc::new(equations.clone()), ..Known::default() };
            let mut new = self.equation(fact, &known)?;
            new.rests_on.insert(place);
            if let Some((atom, value)) = &new.atom {
                for old in &mut equations {
                    let values = [old.atom.as_mut().map(|a| &mut a.1), old.power.as_mut().map(|p| &mut p.1)];
                    for earlier in values.into_iter().flatten() {
                        let replaced = self.replaced(earlier, *atom, value)?;
                        if replaced != *earlier {
                            *earlier = replaced;
                            old.rests_on.extend(new.rests_on.iter().copied());
                        }
                    }
                }
            }
            equations.push(new);
        }
        Ok(equations)
    }

    /// A fact as an equation that can be put in: its left side is an atom, a power or an exponential. Equations before
    /// it are put in.
    pub(super) fn equation(&mut self, fact: &Prop, known: &Known) -> Result<Equation, Refusal> {
        let (left, relation, right) = single(fact)?;
        if relation != Relation::Equal {
            return rejected(Reason::NotAnEquation);
        }
        let written = self.written(left)?;
        let (left, right) = (self.fraction_with(left, known)?, self.fraction_with(right, known)?);
        let atom = match left.factors.iter().next() {
            Some((poly, 1)) if left.factors.len() == 1 => poly.single_atom(),
            _ => None,
        };
        if atom.is_none() && written.is_none() {
            return rejected(Reason::NotAnAtom);
        }
        // c·A = B says A = B/c.
        let inverse = Fraction::number(left.coefficient.clone());
        let atom = match atom {
            Some(atom) => Some((atom, right.times(&inverse.power(-1)?, &self.work)?)),
            None => None,
        };
        let rests_on = known.put_in.take();
        Ok(Equation { atom, power: written.map(|written| (written, right)), rests_on })
    }

    /// Takes in what a fact says.
    pub(super) fn learn(&mut self, fact: &Prop, known: &mut Known) -> Result<(), Refusal> {
        let mut lessons = Vec::new();
        self.read_fact(fact, known, &mut lessons)?;
        self.take_in(&lessons, known)
    }

    fn take_in(&mut self, lessons: &[Lesson], known: &mut Known) -> Result<(), Refusal> {
        for lesson in lessons {
            match lesson {
                Lesson::Sign(f, signs, places) => self.note(f, *signs, places, known)?,
                Lesson::ForAll(binding, body) => {
                    let place = known.source.unwrap_or_default();
                    known.for_all.push(((**binding).clone(), body.clone(), place));
                }
            }
        }
        Ok(())
    }

    /// What a fact says of signs: of the difference of its sides, and of whatever its expressions need to have values,
    /// for a fact has them; as they stand and with the equations put in.
    fn read_fact(&mut self, fact: &Prop, known: &Known, out: &mut Vec<Lesson>) -> Result<(), Refusal> {
        match &fact.kind {
            PropKind::Compare(sides, relations) => {
                for side in sides {
                    self.read_needs(side, known, out)?;
                }
                for (pair, relation) in sides.windows(2).zip(relations) {
                    let [a, b] = pair else { continue };
                    if let (Value::Scalar(x), Value::Scalar(y)) = (self.value(a)?, self.value(b)?) {
                        let difference = x.minus(&y, &self.work)?;
                        let signs = Signs::of(*relation);
                        let touched = [self.is_touched(a, &x, known)?, self.is_touched(b, &y, known)?];
                        if touched.contains(&true) {
                            let (x, mut places) =
                                if touched[0] { self.put_into(a, known)? } else { (x, BTreeSet::new()) };
                            let (y, others) = if touched[1] { self.put_into(b, known)? } else { (y, BTreeSet::new()) };
                            places.extend(others);
                            let replaced = x.minus(&y, &self.work)?;
                            if replaced != difference {
                                out.push(Lesson::Sign(difference, signs, BTreeSet::new()));
                                out.push(Lesson::Sign(replaced, signs, places));
                                continue;
                            }
                        }
                        out.push(Lesson::Sign(difference, signs, BTreeSet::new()));
                    }
                }
                Ok(())
            }
            PropKind::And(list) => list.iter().try_for_each(|p| self.read_fact(p, known, out)),
            PropKind::ForAll(bindings, body) => {
                if let [binding] = bindings.as_slice()
                    && binding.names.len() == 1
                {
                    out.push(Lesson::ForAll(Box::new(binding.clone()), (**body).clone()));
                }
                Ok(())
            }
            _ => Ok(()),
        }
    }

    /// Whether an equation may have something to put into an expression, which comes to this fraction without any: one of its atoms
    /// occurs there, or the expression has a power, which an equation may give as it is written.
    fn is_touched(&mut self, e: &Expr, plain: &Fraction, known: &Known) -> Result<bool, Refusal> {
        let mut powers = false;
        for equation in known.equations.iter() {
            powers |= equation.power.is_some();
            if let Some((atom, _)) = &equation.atom
                && self.occurs(*atom, plain)?
            {
                return Ok(true);
            }
        }
        Ok(powers && self.has_power(e))
    }

    /// Whether an expression has a function, or a power whose exponent is no numeral.
    fn has_power(&self, e: &Expr) -> bool {
        match &e.kind {
            ExprKind::Apply(f, _) if !self.is_member(&f.text) => true,
            ExprKind::Power(base, exponent) => !matches!(exponent.kind, ExprKind::Number(_)) || self.has_power(base),
            _ => parts(e).into_iter().any(|part| self.has_power(part)),
        }
    }

    /// What an expression that has a value needed for that, innermost first; not under bound names.
    fn read_needs(&mut self, e: &Expr, known: &Known, out: &mut Vec<Lesson>) -> Result<(), Refusal> {
        if !matches!(
            e.kind,
            ExprKind::SumOver(..) | ExprKind::ProductOver(..) | ExprKind::IntegralOver(..) | ExprKind::Derivative(..)
        ) {
            for part in parts(e) {
                self.read_needs(part, known, out)?;
            }
        }
        let natural = self.natural_names();
        for need in needs(e, &|name| natural.contains(name))? {
            let (part, signs) = match need {
                Need::NotZero(e) => (e, Signs::NOT_ZERO),
                Need::Positive(e) => (e, Signs::POSITIVE),
                Need::NotNegative(e) => (e, Signs::NOT_NEGATIVE),
                Need::NotZeroOrNatural(..) | Need::Range(..) | Need::Differentiable(..) => continue,
            };
            let plain = self.fraction(&part)?;
            out.push(Lesson::Sign(plain.clone(), signs, BTreeSet::new()));
            if self.is_touched(&part, &plain, known)? {
                let (replaced, places) = self.put_into(&part, known)?;
                if replaced != plain {
                    out.push(Lesson::Sign(replaced, signs, places));
                }
            }
        }
        Ok(())
    }
}
