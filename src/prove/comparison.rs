//! Comparisons brought to the signs of few sums, and from there to ordinary polynomials.
//!
//! Contract: [`Engine::difference`] has the same sign as a − b; [`Engine::reduced`] is equivalent to
//! the comparison it comes from, wherever the context holds. Two comparisons with the same reduced
//! form are therefore equivalent.
//!
//! Where both sides are positive their quotient ρ is a product of powers, and a > b iff ρ > 1 iff
//! ρ^k > 1 for any k > 0: common exponents are divided out before the sides are expanded.

use super::context::*;
use super::sign::power_signs;
use crate::algebra::form::{Atom, AtomId, Exponent, Form, Poly};
use crate::algebra::positivity::Constraint;
use crate::algebra::{Monomial, Polynomial};
use crate::claim::syntax::Relation;
use crate::number::rational::exact_root;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::{Gcd, Lcm, Pow};
use malachite::base::num::basic::traits::{One, Zero};
use std::collections::BTreeMap;

type Result<T> = std::result::Result<T, Failure>;

/// A comparison after reduction.
#[derive(Clone, Debug, PartialEq)]
pub enum Reduced {
    /// It holds, or fails, wherever the context does.
    Decided(bool),
    /// It depends on these atoms.
    Open(Literal),
}

/// The relation read from right to left.
pub fn mirrored(relation: Relation) -> Relation {
    match relation {
        Relation::Less => Relation::Greater,
        Relation::LessEqual => Relation::GreaterEqual,
        Relation::Greater => Relation::Less,
        Relation::GreaterEqual => Relation::LessEqual,
        same => same,
    }
}

/// The relation that holds exactly where this one fails.
pub fn negated(relation: Relation) -> Relation {
    match relation {
        Relation::Less => Relation::GreaterEqual,
        Relation::LessEqual => Relation::Greater,
        Relation::Greater => Relation::LessEqual,
        Relation::GreaterEqual => Relation::Less,
        Relation::Equal => Relation::NotEqual,
        Relation::NotEqual => Relation::Equal,
    }
}

impl Engine {
    /// A form with the same sign as a − b.
    pub fn difference(&mut self, cx: &mut Context, a: &Form, b: &Form) -> Result<Form> {
        if a == b {
            return Ok(Form::integer(0));
        }
        if !a.is_zero()
            && !b.is_zero()
            && self.signs(cx, a)? == Signs::POSITIVE
            && self.signs(cx, b)? == Signs::POSITIVE
        {
            let quotient = self.ring.div(a, b)?;
            let root = self.root_of_quotient(cx, quotient)?;
            let (mut up, mut down) = (Form::number(root.coefficient.clone()), Form::integer(1));
            for (atom, exponent) in root.powers {
                let negative = exponent.order_sign().is_lt();
                let exponent = if negative { self.ring.exponent_negated(&exponent) } else { exponent };
                let power = Form { coefficient: Rational::ONE, powers: vec![(atom, exponent)] };
                let side = if negative { &mut down } else { &mut up };
                *side = self.ring.mul(side, &power)?;
            }
            // ρ = up/down is compared with 1: up with down, or the other way round where both are negative.
            let signs = self.signs(cx, &down)?;
            if signs.within(Signs::POSITIVE) {
                return Ok(self.ring.sub(&up, &down)?);
            }
            if signs.within(Signs::NEGATIVE) {
                return Ok(self.ring.sub(&down, &up)?);
            }
        }
        Ok(self.ring.sub(a, b)?)
    }

    /// ρ^k for a k > 0 that makes the exponents of ρ small; ρ > 0.
    fn root_of_quotient(&mut self, cx: &mut Context, mut quotient: Form) -> Result<Form> {
        // A symbolic exponent that all the others are rational multiples of, if it is positive.
        let symbolic = quotient.powers.iter().find_map(|(_, e)| match e {
            Exponent::Symbolic(form) => Some((**form).clone()),
            Exponent::Number(_) => None,
        });
        if let Some(mut candidate) = symbolic
            && quotient.coefficient == 1
        {
            candidate.coefficient = Rational::ONE;
            let mut fine = self.signs(cx, &candidate)? == Signs::POSITIVE;
            let mut powers = Vec::new();
            for (atom, exponent) in &quotient.powers {
                let ratio = self.ring.div(&exponent.form(), &candidate)?;
                match ratio.as_number() {
                    Some(q) => powers.push((*atom, Exponent::Number(q.clone()))),
                    None => fine = false,
                }
            }
            if fine {
                quotient.powers = powers;
            }
        }
        let mut top = malachite::Natural::ZERO;
        let mut bottom = malachite::Natural::ONE;
        for (_, exponent) in &quotient.powers {
            let c = match exponent {
                Exponent::Number(q) => q.clone(),
                Exponent::Symbolic(form) => form.coefficient.clone(),
            };
            top = top.gcd(c.numerator_ref().clone());
            bottom = bottom.lcm(c.denominator_ref().clone());
        }
        if top == 0 || (top == 1 && bottom == 1) {
            return Ok(quotient);
        }
        let (Ok(mut p), Ok(q)) = (u64::try_from(&top), u64::try_from(&bottom)) else { return Ok(quotient) };
        if q > 64 {
            return Ok(quotient);
        }
        // An even root of a^p is a^(p/2) only for a > 0; an odd root, and any power of ρ > 0, keeps the order to 1.
        let mut positive = true;
        for (atom, exponent) in &quotient.powers {
            let plain = exponent.number().is_some();
            positive &= !plain || p % 2 == 1 || self.atom_signs(cx, *atom)?.within(Signs::POSITIVE);
        }
        while p % 2 == 0 && !positive {
            p /= 2;
        }
        let raised = (&quotient.coefficient).pow(q);
        let (coefficient, p) = match exact_root(&raised, p) {
            Some(root) => (root, p),
            None => (raised, 1),
        };
        let factor = Exponent::Number(Rational::from(q) / Rational::from(p));
        let mut powers = Vec::new();
        for (atom, exponent) in &quotient.powers {
            powers.push((*atom, self.ring.exponent_product(exponent, &factor)?));
        }
        Ok(Form { coefficient, powers })
    }

    /// The comparison of a form with zero, reduced to atoms whose sign is open.
    pub fn reduced(&mut self, cx: &mut Context, form: &Form, relation: Relation) -> Result<Reduced> {
        self.reduced_to(cx, form, relation, true)
    }

    /// As [`Engine::reduced`]; with `roots` a difference of two positive monomials is brought to the
    /// smallest exponents.
    fn reduced_to(&mut self, cx: &mut Context, form: &Form, relation: Relation, roots: bool) -> Result<Reduced> {
        let all = self.signs(cx, form)?;
        if let Some(truth) = truth_of(all, relation) {
            return Ok(Reduced::Decided(truth));
        }
        let equality = matches!(relation, Relation::Equal | Relation::NotEqual);
        let mut relation = relation;
        if form.coefficient < 0 {
            relation = mirrored(relation);
        }
        let mut atoms = Vec::new();
        for (atom, exponent) in form.powers.clone() {
            let signs = self.atom_signs(cx, atom)?;
            let power = power_signs(signs, &exponent);
            if power.within(Signs::POSITIVE) || (equality && power.within(Signs::NOT_ZERO)) {
                continue;
            }
            if power.within(Signs::NEGATIVE) {
                relation = mirrored(relation);
                continue;
            }
            let even = exponent.is_even();
            if even && exponent.order_sign().is_lt() {
                continue;
            }
            atoms.push((atom, even && !equality));
        }
        if roots
            && let [(atom, false)] = atoms.as_slice()
            && let Some(poly) = self.ring.sum(*atom)
            && let [(m, c), (k, d)] = poly.terms.as_slice()
            && *c > 0
            && *d < 0
        {
            // A difference of two positive monomials, brought to the smallest exponents.
            let a = Form { coefficient: c.clone(), powers: m.clone() };
            let b = Form { coefficient: -d, powers: k.clone() };
            let (a_signs, b_signs) = (self.signs(cx, &a)?, self.signs(cx, &b)?);
            if a_signs == Signs::POSITIVE && b_signs == Signs::POSITIVE {
                let small = self.difference(cx, &a, &b)?;
                // The same sum again, perhaps with another coefficient, is as small as it gets.
                if small.powers != Form::atom(*atom).powers {
                    return self.reduced(cx, &small, relation);
                }
            }
        }
        if atoms.is_empty() {
            // Every factor was positive: only the coefficient's sign was left.
            return Ok(match truth_of(Signs::POSITIVE, relation) {
                Some(truth) => Reduced::Decided(truth),
                None => Reduced::Decided(false),
            });
        }
        Ok(Reduced::Open(Literal { relation, atoms }))
    }

    /// Adds what `form relation 0` says to the context.
    pub fn narrow_form(&mut self, cx: &mut Context, form: &Form, relation: Relation, sources: Sources) -> Result<()> {
        // As it stands, too: certificates work with these exponents, not with the smallest.
        if let Reduced::Open(literal) = self.reduced_to(cx, form, relation, false)? {
            self.narrow(cx, &literal, sources);
            if let [(atom, false)] = literal.atoms.as_slice() {
                self.propagate(cx, *atom, sources)?;
            }
        }
        match self.reduced(cx, form, relation)? {
            Reduced::Decided(true) => {}
            Reduced::Decided(false) => cx.contradiction = Some(sources | self.used),
            Reduced::Open(literal) => {
                self.narrow(cx, &literal, sources);
                if let [(atom, false)] = literal.atoms.as_slice() {
                    self.propagate(cx, *atom, sources)?;
                }
            }
        }
        Ok(())
    }

    /// From the sign of a sum to the signs of its linear terms: t = P − (P − t), so n − 1 ≥ 0 gives
    /// n > 0 and w > 1 gives w > 0.
    fn propagate(&mut self, cx: &mut Context, atom: AtomId, sources: Sources) -> Result<()> {
        let (Some(poly), Some((whole, _))) = (self.ring.sum(atom), cx.signs.get(&atom).copied()) else { return Ok(()) };
        if poly.terms.len() > 4 {
            return Ok(());
        }
        for (place, (monomial, c)) in poly.terms.iter().enumerate() {
            let [(inner, exponent)] = monomial.as_slice() else { continue };
            if exponent.as_integer() != Some(1) {
                continue;
            }
            let mut signs = whole;
            let before = std::mem::replace(&mut self.used, sources);
            for (other, (m, d)) in poly.terms.iter().enumerate() {
                if other != place {
                    let term = Form { coefficient: -d, powers: m.clone() };
                    signs = signs.plus(self.signs(cx, &term)?);
                }
            }
            let from = self.used;
            self.used = before;
            if signs != Signs::ANY {
                let signs = signs.times(Signs::of_number(c));
                let relation = [
                    Relation::Equal,
                    Relation::Greater,
                    Relation::Less,
                    Relation::NotEqual,
                    Relation::GreaterEqual,
                    Relation::LessEqual,
                ]
                .into_iter()
                .find(|r| signs.within(Signs::of(*r)));
                if let Some(relation) = relation {
                    self.narrow(cx, &Literal { relation, atoms: vec![(*inner, false)] }, from);
                }
            }
        }
        Ok(())
    }

    fn narrow(&mut self, cx: &mut Context, literal: &Literal, sources: Sources) {
        let allowed = Signs::of(literal.relation);
        let set = |cx: &mut Context, atom: AtomId, signs: Signs| {
            let entry = cx.signs.entry(atom).or_insert((Signs::ANY, 0));
            let both = entry.0.and(signs);
            if both != entry.0 {
                *entry = (both, entry.1 | sources);
                cx.memo.clear();
                cx.searched.clear();
            }
            if both.is_empty() {
                cx.contradiction = Some(entry.1);
            }
        };
        match literal.atoms.as_slice() {
            [(atom, false)] => set(cx, *atom, allowed),
            [(atom, true)] => match literal.relation {
                Relation::Greater | Relation::NotEqual => set(cx, *atom, Signs::NOT_ZERO),
                Relation::LessEqual | Relation::Equal => set(cx, *atom, Signs::ZERO),
                Relation::Less => set(cx, *atom, Signs::ZERO.and(Signs::NOT_ZERO)),
                Relation::GreaterEqual => {}
            },
            several if literal.relation == Relation::NotEqual => {
                for (atom, _) in several {
                    set(cx, *atom, Signs::NOT_ZERO);
                }
            }
            _ => {
                let entry = (literal.clone(), sources);
                if !cx.constraints.contains(&entry) {
                    cx.constraints.push(entry);
                    cx.searched.clear();
                }
            }
        }
    }
}

/// The truth of `s relation 0` where s has one of these signs.
pub fn truth_of(signs: Signs, relation: Relation) -> Option<bool> {
    let allowed = Signs::of(relation);
    if signs.within(allowed) {
        Some(true)
    } else if signs.and(allowed).is_empty() {
        Some(false)
    } else {
        None
    }
}

/// A product of sums (the flag: squared) with its relation to zero and the facts behind it.
type KnownProduct = (Vec<(Poly, bool)>, Relation, Sources);

/// Sums as ordinary polynomials in generators, each a power of an atom.
#[derive(Clone, Debug)]
pub struct Plain {
    /// The goals; each has the sign of the atom it stands for.
    pub goals: Vec<Polynomial>,
    /// The generators and what the context says of them and of sums in them.
    pub constraints: Vec<Constraint>,
    /// The signs of the generators.
    pub signs: Vec<Signs>,
    /// Equations: polynomials that vanish.
    pub equations: Vec<Polynomial>,
    /// What each generator is: an atom, the symbolic part of its exponent, and the unit.
    pub generators: Vec<(AtomId, Form, Rational)>,
    /// The facts behind the constraints.
    pub sources: Sources,
}

impl Plain {
    /// The problem of the signs of these atoms.
    pub fn of(engine: &mut Engine, cx: &mut Context, goals: &[AtomId]) -> Result<Plain> {
        let polys: Vec<Poly> = goals.iter().map(|a| sum_or_atom(engine, *a)).collect();
        let mut near: Vec<AtomId> = polys.iter().flat_map(atoms_of).collect();
        near.sort_unstable();
        near.dedup();
        // Facts about sums, those in the goal's own atoms first.
        let mut facts: Vec<KnownProduct> = Vec::new();
        let mut known: Vec<(Literal, Sources)> = Vec::new();
        let mut signed: Vec<(AtomId, (Signs, Sources))> = cx.signs.iter().map(|(a, s)| (*a, *s)).collect();
        signed.sort_by_key(|s| s.0);
        for (atom, (signs, sources)) in signed {
            if engine.ring.sum(atom).is_none() || goals.contains(&atom) && signs == Signs::ANY {
                continue;
            }
            let relation =
                [Relation::Equal, Relation::Greater, Relation::Less, Relation::GreaterEqual, Relation::LessEqual]
                    .into_iter()
                    .find(|r| signs.within(Signs::of(*r)));
            if let Some(relation) = relation {
                known.push((Literal { relation, atoms: vec![(atom, false)] }, sources));
            }
        }
        known.extend(cx.constraints.iter().cloned());
        for pass in 0..2 {
            let mut more = Vec::new();
            for (literal, sources) in &known {
                let factors: Vec<(Poly, bool)> =
                    literal.atoms.iter().map(|(a, even)| (sum_or_atom(engine, *a), *even)).collect();
                let inside = factors.iter().flat_map(|f| atoms_of(&f.0)).all(|a| near.contains(&a));
                let touching = factors.iter().flat_map(|f| atoms_of(&f.0)).any(|a| near.contains(&a));
                let fact = (factors, literal.relation, *sources);
                if facts.iter().any(|f| f.0 == fact.0 && f.1 == fact.1) {
                    continue;
                }
                if inside {
                    facts.push(fact);
                } else if pass == 0 && touching {
                    more.extend(fact.0.iter().flat_map(|f| atoms_of(&f.0)));
                }
            }
            if pass == 0 && facts.len() < 6 {
                more.sort_unstable();
                more.dedup();
                if near.len() + more.len() <= 12 {
                    near.extend(more);
                    near.sort_unstable();
                    near.dedup();
                }
            }
        }
        facts.truncate(14);
        let mut plain = Plain {
            goals: Vec::new(),
            constraints: Vec::new(),
            signs: Vec::new(),
            equations: Vec::new(),
            generators: Vec::new(),
            sources: 0,
        };
        let everything: Vec<&Poly> = polys.iter().chain(facts.iter().flat_map(|f| f.0.iter().map(|p| &p.0))).collect();
        let table = plain.exponents(engine, cx, &everything)?;
        let mut list = table.into_iter();
        for _ in &polys {
            plain.goals.push(list.next().unwrap_or_else(Polynomial::zero));
        }
        for (i, signs) in plain.signs.clone().into_iter().enumerate() {
            let variable = Polynomial::variable(u32::try_from(i).unwrap_or(u32::MAX));
            if signs.within(Signs::NOT_NEGATIVE) {
                plain.constraints.push(Constraint { poly: variable, strict: signs == Signs::POSITIVE });
            } else if signs.within(Signs::of(Relation::LessEqual)) {
                plain.constraints.push(Constraint { poly: variable.neg(), strict: signs == Signs::NEGATIVE });
            }
            if let Some((_, sources)) = plain.generators.get(i).and_then(|g| cx.signs.get(&g.0)) {
                plain.sources |= sources;
            }
        }
        for (factors, relation, sources) in facts {
            let mut product = Polynomial::one();
            for (_, even) in &factors {
                let poly = list.next().unwrap_or_else(Polynomial::zero);
                product = product.try_mul(&poly)?;
                if *even {
                    product = product.try_mul(&poly)?;
                }
            }
            plain.sources |= sources;
            match relation {
                Relation::Equal => {
                    plain.constraints.push(Constraint { poly: product.clone(), strict: false });
                    plain.constraints.push(Constraint { poly: product.neg(), strict: false });
                    plain.equations.push(product);
                }
                Relation::Greater | Relation::GreaterEqual => {
                    plain.constraints.push(Constraint { poly: product, strict: relation == Relation::Greater });
                }
                Relation::Less | Relation::LessEqual => {
                    plain.constraints.push(Constraint { poly: product.neg(), strict: relation == Relation::Less });
                }
                Relation::NotEqual => {}
            }
        }
        Ok(plain)
    }

    /// Chooses the generators and writes the sums in them, each up to a positive monomial.
    fn exponents(&mut self, engine: &mut Engine, cx: &mut Context, polys: &[&Poly]) -> Result<Vec<Polynomial>> {
        type Row = Vec<(usize, Rational)>;
        let mut index: BTreeMap<(AtomId, String), usize> = BTreeMap::new();
        let mut keys: Vec<(AtomId, Form)> = Vec::new();
        let mut rows: Vec<Vec<(Row, Rational)>> = Vec::new();
        // The exponents of an atom over their common denominator, so that sums of them agree.
        let mut denominators: BTreeMap<AtomId, Form> = BTreeMap::new();
        for (atom, exponent) in polys.iter().flat_map(|p| p.terms.iter().flat_map(|t| t.0.iter())) {
            let Exponent::Symbolic(form) = exponent else { continue };
            for (inner, e) in &form.powers {
                let Some(k) = e.as_integer().filter(|k| *k < 0) else { continue };
                let common = denominators.entry(*atom).or_insert_with(|| Form::integer(1));
                let have = crate::algebra::form::exponent_in(&common.powers, *inner).as_integer().unwrap_or(0);
                if have < -k {
                    let more =
                        Form { coefficient: Rational::ONE, powers: vec![(*inner, Exponent::integer(-k - have))] };
                    *common = engine.ring.mul(common, &more)?;
                }
            }
        }
        for poly in polys {
            let mut out = Vec::new();
            for (monomial, c) in &poly.terms {
                let mut row: Row = Vec::new();
                for (atom, exponent) in monomial {
                    let mut numerator = exponent.form();
                    let denominator = denominators.get(atom).cloned();
                    if let Some(denominator) = &denominator {
                        numerator = engine.ring.mul(&numerator, denominator)?;
                    }
                    for summand in engine.ring.summands(&numerator)? {
                        let summand = match &denominator {
                            Some(denominator) => engine.ring.div(&summand, denominator)?,
                            None => summand,
                        };
                        let key = Form { coefficient: Rational::ONE, powers: summand.powers.clone() };
                        let name = format!("{:?}", key.powers);
                        let next = keys.len();
                        let place = *index.entry((*atom, name)).or_insert(next);
                        if place == next {
                            keys.push((*atom, key));
                        }
                        row.push((place, summand.coefficient.clone()));
                    }
                }
                out.push((row, c.clone()));
            }
            rows.push(out);
        }
        let mut units: Vec<(malachite::Natural, malachite::Natural)> =
            vec![(malachite::Natural::ZERO, malachite::Natural::ONE); keys.len()];
        for (row, _) in rows.iter().flatten() {
            for (place, e) in row {
                let unit = &mut units[*place];
                unit.0 = (&unit.0).gcd(e.numerator_ref());
                unit.1 = (&unit.1).lcm(e.denominator_ref());
            }
        }
        for ((atom, key), (top, bottom)) in keys.into_iter().zip(units) {
            let mut unit = Rational::from_naturals(top, bottom);
            let base = engine.atom_signs(cx, atom)?;
            // A whole exponent of an atom of any sign keeps the unit 1: the sign of squares is not
            // lost, and nothing is gained by a larger one.
            if key.powers.is_empty() && unit > 1 {
                unit = Rational::ONE;
            }
            let signs = if key.powers.is_empty() {
                power_signs(base, &Exponent::Number(unit.clone()))
            } else {
                Signs::POSITIVE
            };
            self.signs.push(signs);
            self.generators.push((atom, key, unit));
        }
        let mut out = Vec::new();
        for row in rows {
            let mut table: Vec<(Vec<i64>, Rational)> = Vec::new();
            let mut least = vec![0i64; self.generators.len()];
            for (exponents, c) in row {
                let mut list = vec![0i64; self.generators.len()];
                for (place, e) in exponents {
                    let k = e / &self.generators[place].2;
                    list[place] += i64::try_from(&k).map_err(|_| Failure::Limit("degree"))?;
                }
                for (a, b) in least.iter_mut().zip(&list) {
                    *a = (*a).min(*b);
                }
                table.push((list, c));
            }
            for (place, low) in least.iter().enumerate() {
                if *low < 0 && !self.signs[place].within(Signs::POSITIVE) {
                    return Err(Failure::NotShown("a sign with a negative power".to_string()));
                }
            }
            let mut terms = Vec::new();
            for (list, c) in table {
                let mut powers = Vec::new();
                for (place, (k, low)) in list.iter().zip(&least).enumerate() {
                    let variable = u32::try_from(place).map_err(|_| Failure::Limit("terms"))?;
                    let exponent = u32::try_from(k - low).map_err(|_| Failure::Limit("degree"))?;
                    if exponent > 0 {
                        powers.push((variable, exponent));
                    }
                }
                terms.push((Monomial::new(&powers)?, c));
            }
            out.push(Polynomial::from_terms(terms));
        }
        Ok(out)
    }

    /// A polynomial in the generators as a form.
    pub fn form_of(&self, engine: &mut Engine, poly: &Polynomial) -> Result<Form> {
        let mut sum = Vec::new();
        for (monomial, c) in poly.terms() {
            let mut term = Form::number(c.clone());
            for &(v, k) in monomial.powers() {
                let (atom, key, unit) = self.generators[v as usize].clone();
                let mut exponent = key;
                exponent.coefficient = unit * Rational::from(k);
                let power = engine.ring.power(&Form::atom(atom), &Exponent::of(exponent))?;
                term = engine.ring.mul(&term, &power)?;
            }
            sum.push(term);
        }
        Ok(engine.ring.add(&sum)?)
    }
}

/// The sum under an atom, or the atom itself as a sum of one term.
pub fn sum_or_atom(engine: &Engine, atom: AtomId) -> Poly {
    match &*engine.ring.atom(atom) {
        Atom::Sum(poly) => (**poly).clone(),
        _ => Poly { terms: vec![(vec![(atom, Exponent::integer(1))], Rational::ONE)] },
    }
}

fn atoms_of(poly: &Poly) -> Vec<AtomId> {
    poly.terms.iter().flat_map(|t| t.0.iter().map(|p| p.0)).collect()
}
