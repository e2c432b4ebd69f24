//! The rules about comparisons: combinations, powers, sums and products, whole numbers.

use super::fraction::{Fraction, Poly};
use super::known::Known;
use super::names::names_in_prop;
use super::order::Signs;
use super::statement::{compare, constraints, expr, name, numeral, product, sum};
use super::substitution::Substitution;
use super::term::{Atom, Value};
use super::tree::single;
use super::{Checker, Reason, Refusal, key, rejected};
use crate::certificate::Term;
use crate::claim::syntax::*;
use num_rational::BigRational;
use num_traits::Signed;
use std::collections::BTreeMap;

/// A place where a base stands.
struct Place {
    /// What it is raised to, all in all.
    exponent: Fraction,
    /// Whether it is raised to whole numbers only, one after the other.
    whole: bool,
}

/// The bases of two products of powers.
#[derive(Default)]
struct Powers {
    /// Where each base stands, on the left and on the right side.
    bases: BTreeMap<Poly, [Vec<Place>; 2]>,
    /// The exponents of exp.
    logs: [Vec<Fraction>; 2],
    /// Whether a side is the opposite of the product.
    negative: [bool; 2],
}

impl Checker {
    /// The difference of the sides of a single comparison with the equations put in, and its relation.
    fn difference(&mut self, p: &Prop, known: &Known) -> Result<(Fraction, Relation), Refusal> {
        let (a, relation, b) = single(p)?;
        let (a, b) = (self.fraction_with(a, known)?, self.fraction_with(b, known)?);
        Ok((a.minus(&b, &self.work)?, relation))
    }

    /// Rule `combination`: `a relation b` from D·(a − b) = Σ Eⱼ·∏ (xⱼ − yⱼ) over facts `xⱼ relation yⱼ`. Without
    /// summands the sign of a − b itself is read from its factors. Matrices are equal where their entries are.
    ///
    /// Sound: a, b, D, the Eⱼ and the facts have values. The identity holds between fractions, hence between values;
    /// the equations put in are facts. The right side has the signs of the sum of products; dividing by D, whose sign is
    /// known and not 0, gives those of a − b.
    pub(super) fn combination(
        &mut self,
        goal: &Prop,
        times: Option<&Expr>,
        terms: &[Term],
        known: &mut Known,
    ) -> Result<(), Refusal> {
        self.prop_defined(goal, known)?;
        let (a, relation, b) = single(goal)?;
        if let (Value::Matrix(x), Value::Matrix(y)) = (self.value_with(a, known)?, self.value_with(b, known)?) {
            // They have one size, for the comparison has a value.
            let mut pairs = x.iter().flatten().zip(y.iter().flatten());
            let equal = |checker: &mut Checker, p: &Fraction, q: &Fraction| -> Result<bool, Refusal> {
                let difference = p.minus(q, &checker.work)?;
                Ok(checker.signs_as_read(&difference, known)?.within(Signs::ZERO))
            };
            let plain = relation == Relation::Equal && terms.is_empty() && times.is_none();
            return match pairs.try_fold(plain, |all, (p, q)| Ok::<_, Refusal>(all && equal(self, p, q)?))? {
                true => Ok(()),
                false => rejected(Reason::Signs),
            };
        }
        let (difference, relation) = self.difference(goal, known)?;
        if terms.is_empty() && times.is_none() {
            let plain = self.fraction(a)?.minus(&self.fraction(b)?, &self.work)?;
            let signs = self.signs_as_read(&difference, known)?.and(self.signs_as_read(&plain, known)?);
            return if signs.within(Signs::of(relation)) { Ok(()) } else { rejected(Reason::Signs) };
        }
        let times = match times {
            Some(e) => {
                self.defined(e, known)?;
                self.fraction_with(e, known)?
            }
            None => Fraction::integer(1),
        };
        let mut signs = Signs::ZERO;
        let mut summands = vec![times.times(&difference, &self.work)?.negated()];
        for term in terms {
            self.defined(&term.factor, known)?;
            let plain = self.fraction(&term.factor)?;
            let mut summand = self.fraction_with(&term.factor, known)?;
            let mut sign = self.signs_as_read(&plain, known)?.and(self.signs_as_read(&summand, known)?);
            for label in &term.facts {
                let fact = self.fact(label)?;
                let (value, relation) = self.difference(&fact, known)?;
                summand.multiply(&value, &self.work)?;
                sign = sign.times(Signs::of(relation));
            }
            signs = signs.plus(sign);
            summands.push(summand);
        }
        if !Fraction::sum(&summands, &self.work)?.is_zero() {
            return rejected(Reason::NoIdentity);
        }
        let divisor = self.signs_as_read(&times, known)?;
        if !divisor.within(Signs::NOT_ZERO) {
            return rejected(Reason::MultiplierMayBeZero);
        }
        if signs.times(divisor).within(Signs::of(relation)) { Ok(()) } else { rejected(Reason::Signs) }
    }

    /// Rule `power`: `A = B` between products of powers, or between sums of logarithms.
    ///
    /// Sound: both sides have values. Logarithms: ln(x·y) = ln x + ln y, ln(x^E) = E·ln x for x, y > 0. Powers: let p be
    /// a factor, raised to E₁, E₂, … on the left and to F₁, … on the right, with Σ E = Σ F.
    /// - p > 0: p^E = exp(E·ln p), so both sides have the same power of p. For p ≤ 0, p^k = (−1)^k·(−p)^k, and −p is
    ///   taken as the factor.
    /// - p ≠ 0 and p is raised to whole numbers only: the same by counting factors. (sqrt(p^2) is no such power.)
    /// - p is raised to natural numbers only: the same, also for p = 0, where b^0 = 1.
    /// - p ≥ 0 and all exponents positive, some on each side: the first if p > 0; if p = 0 both sides are 0.
    pub(super) fn power_rule(&mut self, goal: &Prop, known: &mut Known) -> Result<(), Refusal> {
        self.prop_defined(goal, known)?;
        let (a, relation, b) = single(goal)?;
        if relation != Relation::Equal {
            return rejected(Reason::NotAnEquation);
        }
        let (a, b) = (self.fraction_with(a, known)?, self.fraction_with(b, known)?);
        let difference = a.minus(&b, &self.work)?;
        if self.expanded_logarithms(&difference, known)?.is_zero() {
            return Ok(());
        }
        let mut powers = Powers::default();
        let once = Place { exponent: Fraction::integer(1), whole: true };
        for (side, f) in [&a, &b].into_iter().enumerate() {
            if f.is_zero() {
                return rejected(Reason::Powers);
            }
            powers.negative[side] = self.collect(f, &once, side, &mut powers, known, 0)?;
        }
        if powers.negative[0] != powers.negative[1] {
            return rejected(Reason::Powers);
        }
        // What is left of positive bases and of exp: a sum of logarithms that has to vanish.
        let mut logs = Vec::new();
        for (base, [left, right]) in powers.bases {
            let all: Vec<Fraction> = left
                .iter()
                .map(|place| place.exponent.clone())
                .chain(right.iter().map(|place| place.exponent.negated()))
                .collect();
            let balance = Fraction::sum(&all, &self.work)?;
            let f = Fraction::of(&base);
            let signs = self.signs_of(&f, known)?;
            if signs.within(Signs::POSITIVE) {
                let log = Fraction::atom(self.intern(Atom::Logarithm(f)));
                logs.push(balance.times(&log, &self.work)?);
                continue;
            }
            if !balance.is_zero() {
                return rejected(Reason::Powers);
            }
            let (mut whole, mut positive, mut natural) = (true, true, true);
            for place in left.iter().chain(&right) {
                let sign = self.signs_of(&place.exponent, known)?;
                whole &= place.whole;
                positive &= sign.within(Signs::POSITIVE);
                natural &= sign.within(Signs::NOT_NEGATIVE);
            }
            let both = !left.is_empty() && !right.is_empty();
            let right_so = (whole && (natural || signs.within(Signs::NOT_ZERO)))
                || (positive && both && signs.within(Signs::NOT_NEGATIVE));
            if !right_so {
                return rejected(Reason::Powers);
            }
        }
        let [left, right] = powers.logs;
        logs.extend(left);
        logs.extend(right.iter().map(Fraction::negated));
        let sum = Fraction::sum(&logs, &self.work)?;
        if self.expanded_logarithms(&sum, known)?.is_zero() { Ok(()) } else { rejected(Reason::Powers) }
    }

    /// The factors of a fraction, with −p for each factor p ≤ 0 that is not known to be 0, and whether the fraction is the opposite of the product of
    /// these and its number's absolute value.
    fn turned_factors(&mut self, f: &Fraction, known: &Known) -> Result<(Vec<(Poly, i64)>, bool), Refusal> {
        let mut negative = f.coefficient.is_negative();
        let mut factors = Vec::new();
        for (poly, k) in &f.factors {
            // A power is taken apart as it stands.
            let power = poly.single_atom().is_some_and(|a| matches!(self.atoms.get(a), Some(Atom::Power(..))));
            let signs = self.signs_of(&Fraction::of(poly), known)?;
            let turned = !power && signs.within(Signs::of(Relation::LessEqual)) && signs != Signs::of(Relation::Equal);
            negative ^= turned && k % 2 != 0;
            let minus = || poly.times(&Poly::constant(BigRational::from_integer((-1).into())), &self.work);
            factors.push((if turned { minus()? } else { poly.clone() }, *k));
        }
        Ok((factors, negative))
    }

    /// The bases and exponents of a product of powers to a power; whether the product is the opposite of theirs.
    fn collect(
        &mut self,
        f: &Fraction,
        to: &Place,
        side: usize,
        powers: &mut Powers,
        known: &Known,
        depth: usize,
    ) -> Result<bool, Refusal> {
        if depth > 20 {
            return Err(Refusal::Limit("nesting of powers"));
        }
        let (factors, negative) = self.turned_factors(f, known)?;
        let whole = to.whole;
        for (prime, k) in f.prime_powers(&self.work)? {
            let base = Poly::constant(BigRational::from_integer(prime));
            let exponent = to.exponent.times(&Fraction::integer(k), &self.work)?;
            powers.bases.entry(base).or_default()[side].push(Place { exponent, whole });
        }
        for (poly, k) in factors {
            let exponent = to.exponent.times(&Fraction::integer(k), &self.work)?;
            match poly.single_atom().and_then(|place| self.atoms.get(place)).cloned() {
                Some(Atom::Power(base, inner)) => {
                    let exponent = exponent.times(&inner, &self.work)?;
                    let to = Place { exponent, whole: whole && self.is_whole(&inner)? };
                    if self.collect(&base, &to, side, powers, known, depth + 1)? {
                        return rejected(Reason::Powers);
                    }
                }
                Some(Atom::Exponential(log)) => powers.logs[side].push(exponent.times(&log, &self.work)?),
                _ => powers.bases.entry(poly).or_default()[side].push(Place { exponent, whole }),
            }
        }
        Ok(negative)
    }

    /// A fraction in which ln of products of positive factors is a sum.
    fn expanded_logarithms(&mut self, f: &Fraction, known: &Known) -> Result<Fraction, Refusal> {
        let mut equations = Vec::new();
        let atoms: std::collections::BTreeSet<usize> = f.atoms().collect();
        for place in atoms {
            if let Some(Atom::Logarithm(x)) = self.atoms.get(place).cloned() {
                let value = self.logarithm_of(&x, known, 0)?;
                equations.push((place, value));
            }
        }
        // ln p of a factor p stands for itself: nothing is replaced twice.
        let mut out = f.clone();
        for (place, value) in equations {
            if value != Fraction::atom(place) {
                out = self.replaced(&out, place, &value)?;
            }
        }
        Ok(out)
    }

    /// ln c·∏ pᵢ^kᵢ = Σ ln qⱼ + Σ kᵢ·ln |pᵢ| over the primes of c, where the sign of every pᵢ is known; else ln x as it stands.
    fn logarithm_of(&mut self, x: &Fraction, known: &Known, depth: usize) -> Result<Fraction, Refusal> {
        if depth > 20 {
            return Err(Refusal::Limit("nesting of powers"));
        }
        let (factors, mut negative) = self.turned_factors(x, known)?;
        for (poly, _) in &factors {
            negative |= !self.signs_of(&Fraction::of(poly), known)?.within(Signs::POSITIVE);
        }
        if negative {
            return Ok(Fraction::atom(self.intern(Atom::Logarithm(x.clone()))));
        }
        let mut terms = Vec::new();
        for (prime, k) in x.prime_powers(&self.work)? {
            let prime = Fraction::number(BigRational::from_integer(prime));
            let log = Fraction::atom(self.intern(Atom::Logarithm(prime)));
            terms.push(log.times(&Fraction::integer(k), &self.work)?);
        }
        for (poly, k) in factors {
            let log = match poly.single_atom().and_then(|place| self.atoms.get(place)).cloned() {
                Some(Atom::Exponential(log)) => log,
                Some(Atom::Power(base, exponent)) => {
                    self.logarithm_of(&base, known, depth + 1)?.times(&exponent, &self.work)?
                }
                _ => Fraction::atom(self.intern(Atom::Logarithm(Fraction::of(&poly)))),
            };
            terms.push(log.times(&Fraction::integer(k), &self.work)?);
        }
        Fraction::sum(&terms, &self.work)
    }

    /// Rule `monotone`: `A^E relation B^E` from `A relation B`, or the other way round, for A, B ≥ 0 and E > 0.
    ///
    /// Sound: x ↦ x^E rises strictly on the x ≥ 0 at which it has a value, so it keeps every relation, and so does its
    /// inverse.
    pub(super) fn monotone(&mut self, goal: &Prop, from: &str, known: &mut Known) -> Result<(), Refusal> {
        self.prop_defined(goal, known)?;
        let fact = self.fact(from)?;
        let (goal, fact) = (single(goal)?, single(&fact)?);
        let raised = |low: (&Expr, Relation, &Expr), high: (&Expr, Relation, &Expr)| {
            let (a, exponent) = as_power(high.0)?;
            let (b, other) = as_power(high.2)?;
            let same = low.1 == high.1
                && key::expr(&exponent) == key::expr(&other)
                && key::expr(&a) == key::expr(low.0)
                && key::expr(&b) == key::expr(low.2);
            same.then_some(exponent)
        };
        let (exponent, low) = match (raised(fact, goal), raised(goal, fact)) {
            (Some(exponent), _) => (exponent, fact),
            (None, Some(exponent)) => (exponent, goal),
            (None, None) => return rejected(Reason::NotPowers),
        };
        for (e, signs) in [(low.0, Signs::NOT_NEGATIVE), (low.2, Signs::NOT_NEGATIVE), (&exponent, Signs::POSITIVE)] {
            if !self.signs_of_expr(e, known)?.within(signs) {
                return rejected(Reason::NoValue { part: e.clone(), signs });
            }
        }
        Ok(())
    }

    /// Rule `unfold`: `u(0) = …` and `u(t) = …` in terms of u(t − 1) of a sequence; a sum or product over `a..b` equal to
    /// one over `a..b − 1` and its last member, or one over `a + 1..b` and its first, or, where b = a − 1, to 0 or 1.
    ///
    /// Sound: by definition. Both sides have values, so the ranges are ranges.
    pub(super) fn unfold(&mut self, goal: &Prop, known: &mut Known) -> Result<(), Refusal> {
        self.prop_defined(goal, known)?;
        let (left, relation, right) = single(goal)?;
        if relation != Relation::Equal {
            return rejected(Reason::NotAnEquation);
        }
        let value = self.fraction(right)?;
        let statement = self.statement.clone();
        let minus_one = |e: &Expr| sum(vec![(Sign::Plus, e.clone()), (Sign::Minus, numeral(1))]);
        let mut candidates = Vec::new();
        match &left.kind {
            ExprKind::Apply(function, arguments) => {
                let (Some(u), [index]) =
                    (statement.sequences.iter().find(|s| s.name == function.text), arguments.as_slice())
                else {
                    return rejected(Reason::NothingToUnfold);
                };
                if self.fraction(index)?.is_zero() {
                    candidates.push(u.initial.clone());
                } else {
                    // t − 1 is a natural number, so t is one that is not 0.
                    let before = minus_one(index);
                    if !self.signs_of_expr(&before, known)?.within(Signs::NOT_NEGATIVE) {
                        return rejected(Reason::NoValue { part: before, signs: Signs::NOT_NEGATIVE });
                    }
                    let mut map = Substitution::default();
                    map.replace(&u.index, &before);
                    candidates.push(map.expr(&u.step)?);
                }
            }
            ExprKind::SumOver(index, body) | ExprKind::ProductOver(index, body) => {
                let is_sum = matches!(left.kind, ExprKind::SumOver(..));
                let room = [self.fraction(&index.to)?, Fraction::integer(1), self.fraction(&index.from)?.negated()];
                let room = Fraction::sum(&room, &self.work)?;
                if room.is_zero() {
                    candidates.push(numeral(u32::from(!is_sum)));
                } else {
                    // There is a member: the range has a length of at least 1.
                    let shorter = room.minus(&Fraction::integer(1), &self.work)?;
                    if !self.signs_of(&shorter, known)?.within(Signs::NOT_NEGATIVE) {
                        return rejected(Reason::Range(left.clone()));
                    }
                    let over = |index: Index| {
                        let body = body.clone();
                        expr(if is_sum { ExprKind::SumOver(index, body) } else { ExprKind::ProductOver(index, body) })
                    };
                    let plus_one = sum(vec![(Sign::Plus, (*index.from).clone()), (Sign::Plus, numeral(1))]);
                    for (rest, at) in [
                        (Index { to: Box::new(minus_one(&index.to)), ..index.clone() }, &index.to),
                        (Index { from: Box::new(plus_one), ..index.clone() }, &index.from),
                    ] {
                        let mut map = Substitution::default();
                        map.replace(&index.name.text, at);
                        let (rest, one) = (over(rest), map.expr(body)?);
                        candidates.push(if is_sum {
                            sum(vec![(Sign::Plus, rest), (Sign::Plus, one)])
                        } else {
                            product(vec![rest, one])
                        });
                    }
                }
            }
            _ => return rejected(Reason::NothingToUnfold),
        }
        for candidate in candidates {
            let f = self.fraction(&candidate)?;
            if f.minus(&value, &self.work)?.is_zero() {
                return Ok(());
            }
        }
        rejected(Reason::NotByDefinition)
    }

    /// Rule `termwise`: `sum(i = a..b, F) relation sum(i = a..b, G)` for =, <= and >=, and an equation between
    /// products, from `for all i …: F relation G` whose domain holds a..b.
    ///
    /// Sound: the sums have the same range, and the comparison holds for every member.
    pub(super) fn termwise(&mut self, goal: &Prop, from: &str, known: &mut Known) -> Result<(), Refusal> {
        self.prop_defined(goal, known)?;
        let fact = self.fact(from)?;
        let PropKind::ForAll(bindings, _) = &fact.kind else { return rejected(Reason::NotForAll) };
        let [binding] = bindings.as_slice() else { return rejected(Reason::NotForAll) };
        let [(variable, None)] = binding.names.as_slice() else { return rejected(Reason::NotForAll) };
        let (left, relation, right) = single(goal)?;
        let ((i, f), (j, g)) = match (&left.kind, &right.kind) {
            (ExprKind::SumOver(i, f), ExprKind::SumOver(j, g))
                if matches!(relation, Relation::Equal | Relation::LessEqual | Relation::GreaterEqual) =>
            {
                ((i, f), (j, g))
            }
            (ExprKind::ProductOver(i, f), ExprKind::ProductOver(j, g)) if relation == Relation::Equal => {
                ((i, f), (j, g))
            }
            _ => return rejected(Reason::NotTermwise),
        };
        for (a, b) in [(&i.from, &j.from), (&i.to, &j.to)] {
            if !self.fraction(a)?.minus(&self.fraction(b)?, &self.work)?.is_zero() {
                return rejected(Reason::NotTermwise);
            }
        }
        let renamed = |index: &Index, e: &Expr| super::tree::renamed(e, &index.name.text, &variable.text);
        let expected = compare(renamed(i, f)?, relation, renamed(j, g)?);
        let expected = Prop { kind: PropKind::ForAll(bindings.clone(), Box::new(expected)), span: fact.span };
        if key::prop(&expected) != key::prop(&fact) {
            return rejected(Reason::Needs(expected));
        }
        // Every index of the range lies in the domain of the fact.
        let (low, high) = (self.fraction(&i.from)?, self.fraction(&i.to)?);
        self.at_index(&variable.text, &low, &high, known, |checker, known| {
            for fact in constraints(binding, &name(&variable.text)) {
                let (difference, relation) = checker.difference(&fact, known)?;
                if !checker.signs_of(&difference, known)?.within(Signs::of(relation)) {
                    return rejected(Reason::NotTermwise);
                }
            }
            Ok(())
        })
    }

    /// Rule `name`: `E = r`, where r is a name that is not in use; from here on it stands for that number, to the end of
    /// the block.
    ///
    /// Sound: E has a value at every point, and nothing else is known of r: the claim does not mention it, nor does a
    /// block that is open, so that nothing that mentions it outlives it.
    pub(super) fn name(&mut self, goal: &Prop, known: &mut Known) -> Result<(), Refusal> {
        let (value, relation, new) = single(goal)?;
        let (Relation::Equal, ExprKind::Name(new)) = (relation, &new.kind) else {
            return rejected(Reason::NotAName);
        };
        self.number_defined(value, known)?;
        let mut names = self.statement.names();
        self.blocks.iter().for_each(|block| names_in_prop(&block.goal, &mut names));
        if names.contains(new) {
            return rejected(Reason::NameInUse(new.clone()));
        }
        self.declare(new, false, Atom::Variable(new.clone()))
    }

    /// Rule `integer`: `A >= B + 1` from `A > B` (or `A + 1 <= B` from `A < B`) for whole numbers.
    ///
    /// Sound: the difference is a whole number by its form, and positive.
    pub(super) fn integer(&mut self, goal: &Prop, from: &str, known: &mut Known) -> Result<(), Refusal> {
        self.prop_defined(goal, known)?;
        let fact = self.fact(from)?;
        let (fact, greater) = self.difference(&fact, known)?;
        let positive = match greater {
            Relation::Greater => fact,
            Relation::Less => fact.negated(),
            _ => return rejected(Reason::NotStrict),
        };
        let (goal, relation) = self.difference(goal, known)?;
        let claimed = match relation {
            Relation::GreaterEqual => goal,
            Relation::LessEqual => goal.negated(),
            _ => return rejected(Reason::NotStrict),
        };
        self.whole(&positive)?;
        let less_one = positive.minus(&Fraction::integer(1), &self.work)?;
        if less_one.minus(&claimed, &self.work)?.is_zero() { Ok(()) } else { rejected(Reason::NoIdentity) }
    }
}

/// The base and exponent of a power or root.
fn as_power(e: &Expr) -> Option<(Expr, Expr)> {
    let part = |k: u32| expr(ExprKind::Product(vec![(Factor::Times, numeral(1)), (Factor::Over, numeral(k))]));
    match &e.kind {
        ExprKind::Power(base, exponent) => Some(((**base).clone(), (**exponent).clone())),
        ExprKind::Apply(f, arguments) => match (f.text.as_str(), arguments.as_slice()) {
            ("sqrt", [x]) => Some((x.clone(), part(2))),
            ("cbrt", [x]) => Some((x.clone(), part(3))),
            _ => None,
        },
        _ => None,
    }
}
