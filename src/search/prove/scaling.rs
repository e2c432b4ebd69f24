//! Units chosen so that parameters are 1: v^2·exp(−v^2/a^2) <= a^2·exp(−1) for all a > 0 is t^2·exp(−t^2) <= exp(−1) at t = v/a.
//!
//! Method (nondimensionalisation; E. Buckingham, "On physically similar systems", 1914): each variable x gets an exponent w(x) such
//! that both sides are multiplied by the same λ^D when each x is multiplied by λ^w(x). What is added or compared has one exponent, and
//! arguments of functions have exponent 0: these equations are linear. A positive variable p with w(p) = 1 is the unit. The goal then
//! is p^D times the goal with 1 for p and with x/p^w(x) for each x, and so is each hypothesis that agrees with the exponents.
//!
//! Numbers are units as well: w·(1 − w^2) <= 2/(3·√3) is 3·t − t^3 <= 2 at t = √3·w. There exponents count modulo the order of the
//! root.
//!
//! A hypothesis about quotients, x^2/a^2 + y^2/b^2 = 1, speaks of these: the goal is shown for x = a·t.
//!
//! Certificate: the goal without units for all values of its variables, an instance of it, and a combination with p^D.
//!
//! Limits: [`UNITS`], [`VARIABLES`], [`VARIABLES_OF_ROOTS`], [`ORDER`].

use super::coefficients::rational;
use super::comparison::single;
use super::facts::{negated, scaled};
use super::letters::{product, whole_power};
use super::limits::over;
use super::{Fail, Prover, implies};
use crate::algebra::{Monomial, Polynomial};
use crate::certificate::{Label, Rule, Term};
use crate::claim::substitution::Substitution;
use crate::claim::syntax::*;
use crate::kernel::names::names_in_prop;
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, name, numeral, power, prop};
use crate::refute::literal::{is_zero, literal};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Pow;
use malachite::base::num::basic::traits::{One, Zero};
use std::collections::{BTreeMap, BTreeSet};

/// The most units.
const UNITS: usize = 3;

/// The most variables with exponents.
const VARIABLES: usize = 8;

/// The highest order of a root that is a unit, and the largest denominator of an exponent.
const ORDER: u32 = 6;

/// The most variables of a polynomial with roots of numbers.
const VARIABLES_OF_ROOTS: usize = 4;

/// A linear form in the exponents of variables: the exponent of an expression.
type Exponent = BTreeMap<String, Rational>;

/// a + q·b.
fn plus(mut a: Exponent, b: &Exponent, q: &Rational) -> Exponent {
    for (x, c) in b {
        let sum = a.entry(x.clone()).or_insert(Rational::ZERO);
        *sum += c * q;
    }
    a.retain(|_, c| *c != 0);
    a
}

/// Exponents of variables, and the linear forms that are 0.
struct Scales<'a> {
    /// The variables that may have an exponent.
    names: &'a [String],
    vanish: Vec<Exponent>,
    /// How often a variable stands in a divisor.
    divides: BTreeMap<String, usize>,
    /// Whether there is more than polynomials and their quotients.
    is_transcendental: bool,
}

impl Scales<'_> {
    fn of_names(names: &[String]) -> Scales<'_> {
        Scales { names, vanish: Vec::new(), divides: BTreeMap::new(), is_transcendental: false }
    }

    /// The exponent of an expression; `None` where it may have none.
    fn of(&mut self, e: &Expr) -> Option<Exponent> {
        Some(match &e.kind {
            ExprKind::Number(_) => Exponent::new(),
            ExprKind::Name(x) if self.names.contains(x) => Exponent::from([(x.clone(), Rational::ONE)]),
            ExprKind::Name(_) => Exponent::new(),
            ExprKind::Negate(a) => self.of(a)?,
            ExprKind::Sum(list) => {
                let terms: Vec<&Expr> = list.iter().map(|term| &term.1).filter(|e| !is_zero(e)).collect();
                self.same(&terms)?
            }
            ExprKind::Product(list) => {
                let mut whole = Exponent::new();
                for (operator, factor) in list {
                    let own = self.of(factor)?;
                    if *operator == Factor::Over {
                        own.keys().for_each(|x| *self.divides.entry(x.clone()).or_default() += 1);
                    }
                    let sign = Rational::from(if *operator == Factor::Times { 1 } else { -1 });
                    whole = plus(whole, &own, &sign);
                }
                whole
            }
            ExprKind::Power(base, exponent) => {
                let own = self.of(base)?;
                let Some(q) = rational(exponent) else {
                    let exponent = self.of(exponent)?;
                    self.is_transcendental = true;
                    self.vanish.extend([own, exponent]);
                    return Some(Exponent::new());
                };
                self.is_transcendental |= *q.denominator_ref() != 1u32;
                plus(Exponent::new(), &own, &q)
            }
            ExprKind::Apply(f, list) => {
                let [inside] = list.as_slice() else { return None };
                let own = self.of(inside)?;
                self.is_transcendental = true;
                match f.text.as_str() {
                    "sqrt" => plus(Exponent::new(), &own, &Rational::from_signeds(1, 2)),
                    "cbrt" => plus(Exponent::new(), &own, &Rational::from_signeds(1, 3)),
                    "det" | "transpose" => return None,
                    other if is_built_in(other) => {
                        self.vanish.push(own);
                        Exponent::new()
                    }
                    _ => return None,
                }
            }
            _ => return None,
        })
    }

    /// The exponent that these expressions share.
    fn same(&mut self, list: &[&Expr]) -> Option<Exponent> {
        let mut all = list.iter().map(|e| self.of(e)).collect::<Option<Vec<_>>>()?.into_iter();
        let first = all.next().unwrap_or_default();
        self.vanish.extend(all.map(|other| plus(other, &first, &Rational::from(-1))));
        Some(first)
    }

    /// The exponent that the sides of a comparison share.
    fn sides(&mut self, a: &Expr, b: &Expr) -> Option<Exponent> {
        let sides: Vec<&Expr> = [a, b].into_iter().filter(|e| !is_zero(e)).collect();
        self.same(&sides)
    }
}

/// The exponents of all variables in these units: of each, that of each unit.
fn in_units(vanish: &[Exponent], order: &[String], positive: &[String]) -> BTreeMap<String, Exponent> {
    // Gauss and Jordan: each row determines its first variable in the order.
    let mut rows: Vec<(String, Exponent)> = Vec::new();
    for form in vanish {
        let mut form = form.clone();
        for (x, row) in &rows {
            if let Some(c) = form.get(x).cloned() {
                form = plus(form, row, &-c);
            }
        }
        let Some(x) = order.iter().find(|x| form.contains_key(*x)) else { continue };
        let lead = form[x].clone();
        let row = plus(Exponent::new(), &form, &(Rational::ONE / lead));
        for (_, other) in &mut rows {
            if let Some(c) = other.get(x).cloned() {
                *other = plus(std::mem::take(other), &row, &-c);
            }
        }
        rows.push((x.clone(), row));
    }
    let determined = |x: &String| rows.iter().find(|row| row.0 == *x);
    let units: Vec<&String> = order.iter().filter(|x| determined(x).is_none() && positive.contains(x)).collect();
    let exponents = |x: &String| -> Exponent {
        match determined(x) {
            Some((_, row)) => units.iter().filter_map(|u| Some(((*u).clone(), -row.get(*u)?.clone()))).collect(),
            None if units.contains(&x) => Exponent::from([(x.clone(), Rational::ONE)]),
            None => Exponent::new(),
        }
    };
    order.iter().map(|x| (x.clone(), exponents(x))).collect()
}

/// The exponent of a form in the units.
fn put_in(form: &Exponent, exponents: &BTreeMap<String, Exponent>) -> Exponent {
    form.iter().fold(Exponent::new(), |sum, (x, c)| exponents.get(x).map_or(sum.clone(), |e| plus(sum, e, c)))
}

/// The product of the units with these exponents.
fn written(exponent: &Exponent) -> Expr {
    let factors = exponent.iter().map(|(unit, q)| match i64::try_from(q.numerator_ref()) {
        Ok(k) if *q.denominator_ref() == 1u32 => whole_power(name(unit), if *q < 0 { -k } else { k }),
        _ => power(&name(unit), &literal(q)),
    });
    product(factors.collect())
}

/// New variables for multiples of the old ones: the goal is `multiple` times `body`, and these terms.
struct Rescaled {
    /// The new names, each with its value.
    point: Vec<(String, Expr)>,
    premises: Vec<Prop>,
    body: Prop,
    multiple: Expr,
    terms: Vec<Term>,
}

impl Prover {
    /// Shows a comparison with parameters, or with roots of numbers, by that in which they are 1.
    pub(super) fn by_scaling(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let rescaled = self.with_units(goal).or_else(|| self.without_roots_of_numbers(goal));
        let rescaled = rescaled.or_else(|| self.with_quotients(goal)).ok_or(Fail::No("a variable that is a unit"))?;
        let Rescaled { point, premises, body, multiple, mut terms } = rescaled;
        let premise = match premises.as_slice() {
            [] => None,
            [only] => Some(only.clone()),
            _ => Some(prop(PropKind::And(premises))),
        };
        let every = premise.map_or(body.clone(), |premise| implies(&premise, &body));
        let bindings = point.iter().map(|(own, _)| Binding::of(Name::new(own), false, Vec::new())).collect();
        let every = prop(PropKind::ForAll(bindings, Box::new(every)));
        let label = self.show(&every)?;
        let instance = self.instance_at(&label, point)?;
        let from = match self.fact(&instance).map(|fact| fact.kind) {
            Some(PropKind::Implies(premise, body)) => {
                let premise = self.quietly(&premise)?;
                self.logic(&[&instance, &premise], &body)?
            }
            _ => instance,
        };
        terms.push(scaled(&from, multiple));
        self.combination(goal.clone(), terms)
    }

    /// The goal and its hypotheses with 1 for parameters.
    fn with_units(&mut self, goal: &Prop) -> Option<Rescaled> {
        let (a, _, b) = single(goal).ok()?;
        let mut order = self.real_names(goal);
        let may = order.clone();
        let mut scales = Scales::of_names(&may);
        let sides = scales.sides(a, b)?;
        if !scales.is_transcendental || order.len() > VARIABLES {
            return None;
        }
        let positive: Vec<String> =
            order.iter().filter(|x| self.signs_of(&name(x)).within(Signs::POSITIVE)).cloned().collect();
        // The last ones become units: those that mostly stand in divisors.
        order.sort_by_key(|x| (positive.contains(x), scales.divides.get(x).copied().unwrap_or_default()));
        let exponents = in_units(&scales.vanish, &order, &positive);
        let is_unit = |x: &String| exponents.get(x).is_some_and(|e| e.len() == 1 && e.get(x) == Some(&Rational::ONE));
        let (units, others): (Vec<&String>, Vec<&String>) = order.iter().partition(|x| is_unit(x));
        let fits = |q: &Rational| *q.denominator_ref() <= ORDER;
        if units.is_empty() || units.len() > UNITS || !exponents.values().flat_map(BTreeMap::values).all(fits) {
            return None;
        }
        let (mut map, mut point) = (Substitution::default(), Vec::new());
        units.iter().for_each(|unit| map.replace(unit, &numeral(1)));
        for x in others {
            let exponent = exponents.get(x).filter(|e| !e.is_empty());
            if let Some(exponent) = exponent {
                let own = self.fresh("t");
                map.replace(x, &name(&own));
                point.push((own, x.clone(), over(name(x), written(exponent))));
            }
        }
        let agrees = |fact: &Prop| {
            let mut scales = Scales::of_names(&may);
            let sides = fact.single().and_then(|(a, _, b)| scales.sides(a, b));
            sides.is_some() && scales.vanish.iter().all(|form| put_in(form, &exponents).is_empty())
        };
        let premises = self.stated_of(&point, &agrees).iter().map(|fact| map.prop(fact).ok()).collect::<Option<_>>()?;
        let body = map.prop(goal).ok()?;
        let point = point.into_iter().map(|(own, _, value)| (own, value)).collect();
        Some(Rescaled { point, premises, body, multiple: written(&put_in(&sides, &exponents)), terms: Vec::new() })
    }

    /// A polynomial goal and its hypotheses in multiples of the variables in which the root of a number is a factor of all terms.
    fn without_roots_of_numbers(&mut self, goal: &Prop) -> Option<Rescaled> {
        let (_, relation, _) = single(goal).ok()?;
        let open = self.open_factors(goal, 0).ok()?;
        let target = if open.flip { open.poly.neg() } else { open.poly };
        let (mut names, mut roots) = (Vec::new(), Vec::new());
        for v in target.variables() {
            match &self.letters.expr(v)?.kind {
                ExprKind::Name(x) => names.push((v, x.clone())),
                ExprKind::Power(base, exponent) => {
                    let order = rational(exponent).filter(|q| *q.numerator_ref() == 1u32)?;
                    let order = u32::try_from(order.denominator_ref()).ok().filter(|order| *order <= ORDER)?;
                    roots.push((v, order, rational(base).filter(|number| *number > 0)?));
                }
                _ => return None,
            }
        }
        let several = target.term_count() > 1 && names.len() <= VARIABLES_OF_ROOTS;
        let (root, order, number) = roots.into_iter().next().filter(|_| several)?;
        // x = t·s^w(x), so that every term has the same power of s modulo its order.
        let residue = |w: &[u32]| {
            let of = |m: &Monomial| {
                let moved: u32 = names.iter().zip(w).map(|((x, _), w)| m.exponent(*x) * w).sum();
                m.exponent(root) + moved
            };
            let mut all = target.terms().map(|(m, _)| of(m) % order);
            let first = all.next()?;
            all.all(|k| k == first).then_some(first)
        };
        let choices = order.checked_pow(u32::try_from(names.len()).ok()?)?;
        let digits = |k: u32| -> Vec<u32> { (0..names.len()).map(|i| k / order.pow(i as u32) % order).collect() };
        let (w, common) = (1..choices).map(digits).find_map(|w| Some((residue(&w)?, w))).map(|(c, w)| (w, c))?;
        let s = self.letters.expr(root)?.clone();
        let (mut new, mut back) = (Polynomial::zero(), Polynomial::zero());
        for (m, c) in target.terms() {
            let moved: u32 = names.iter().zip(&w).map(|((x, _), w)| m.exponent(*x) * w).sum();
            let whole = (m.exponent(root) + moved - common) / order;
            let (others, _) = m.without(root);
            let here = Polynomial::term(others.clone(), c * (&number).pow(u64::from(whole)));
            // x·s^(order − w)/number is t.
            let (mut roots, mut divisors) = (common, 0);
            for ((x, _), w) in names.iter().zip(&w).filter(|(_, w)| **w > 0) {
                roots += (order - w) * m.exponent(*x);
                divisors += m.exponent(*x);
            }
            let s = Polynomial::variable(root).pow(roots).ok()?;
            back = back.add(&here.try_mul(&s).ok()?.scale(&(Rational::ONE / (&number).pow(u64::from(divisors)))));
            new = new.add(&here);
        }
        // What is left is a multiple of s^order − number.
        let vanishes = Polynomial::variable(root).pow(order).ok()?.sub(&Polynomial::constant(number.clone()));
        let left = target.sub(&back).exact_divide(&vanishes)?;
        let (mut map, mut point) = (Substitution::default(), Vec::new());
        for ((_, x), w) in names.iter().zip(&w).filter(|(_, w)| **w > 0) {
            let own = self.fresh("t");
            map.replace(x, &product(vec![name(&own), whole_power(s.clone(), i64::from(*w))]));
            let back = product(vec![name(x), whole_power(s.clone(), i64::from(order - w))]);
            point.push((own, x.clone(), over(back, literal(&number))));
        }
        let premises = self.stated_of(&point, &|_| true);
        // The sign of a variable is that of its multiple.
        let own_sign = |fact: &Prop| match fact.single() {
            Some((Expr { kind: ExprKind::Name(x), .. }, relation, zero)) if is_zero(zero) => {
                let (own, ..) = point.iter().find(|(_, old, _)| old == x)?;
                Some(compare(name(own), relation, numeral(0)))
            }
            _ => None,
        };
        let premises = premises.iter().map(|fact| own_sign(fact).or_else(|| map.prop(fact).ok()));
        let premises = premises.collect::<Option<Vec<_>>>()?;
        let strict = matches!(relation, Relation::Greater | Relation::Less);
        let order_of_body = if strict { Relation::Greater } else { Relation::GreaterEqual };
        let mut body = self.letters.written(&new);
        for (own, x, _) in &point {
            super::sums::replace(&mut body, &name(x), &name(own));
        }
        let raised = compare(whole_power(s.clone(), i64::from(order)), Relation::Equal, literal(&number));
        let raised = self.plainly(Rule::Power, &raised).ok()?;
        let sign = if open.flip { negated(numeral(1)) } else { numeral(1) };
        let times = |e: Expr| product([sign.clone(), e].into_iter().chain(open.rest.iter().cloned()).collect());
        Some(Rescaled {
            point: point.into_iter().map(|(own, _, value)| (own, value)).collect(),
            premises,
            body: compare(body, order_of_body, numeral(0)),
            multiple: times(whole_power(s, i64::from(common))),
            terms: vec![scaled(&raised, times(self.letters.written(&left)))],
        })
    }

    /// The goal and its hypotheses with names for quotients of variables that hypotheses speak of.
    fn with_quotients(&mut self, goal: &Prop) -> Option<Rescaled> {
        let real = self.real_names(goal);
        let mut quotients: Vec<(String, String)> = Vec::new();
        for (label, fact) in self.facts() {
            if !is_shown(&label) && fact.single().is_some() {
                let mut sides = Vec::new();
                super::goals::sides_in(&fact, &mut sides);
                sides.iter().for_each(|e| quotients_in(e, &mut quotients));
            }
        }
        let (mut map, mut point) = (Substitution::default(), Vec::new());
        for (x, a) in quotients.iter().filter(|(x, _)| real.contains(x)) {
            let is_apart = quotients.iter().all(|(y, b)| b != x && (y != x || b == a));
            if is_apart && self.signs_of(&name(a)).within(Signs::NOT_ZERO) && point.len() < VARIABLES_OF_ROOTS {
                let own = self.fresh("t");
                map.replace(x, &product(vec![name(a), name(&own)]));
                point.push((own, x.clone(), over(name(x), name(a))));
            }
        }
        if point.is_empty() {
            return None;
        }
        let premises =
            self.stated_of(&point, &|_| true).iter().map(|fact| map.prop(fact).ok()).collect::<Option<_>>()?;
        let body = map.prop(goal).ok()?;
        let point = point.into_iter().map(|(own, _, value)| (own, value)).collect();
        Some(Rescaled { point, premises, body, multiple: numeral(1), terms: Vec::new() })
    }

    /// The real variables of a proposition.
    fn real_names(&self, p: &Prop) -> Vec<String> {
        let mut names = BTreeSet::new();
        names_in_prop(p, &mut names);
        names.retain(|x| self.is_a_name(x) && !self.is_whole(&name(x)));
        names.into_iter().collect()
    }

    /// What the claim states about variables that get new names, as single comparisons that these agree with.
    fn stated_of(&self, point: &[(String, String, Expr)], agrees: &dyn Fn(&Prop) -> bool) -> Vec<Prop> {
        let facts = self.facts().into_iter().filter(|(label, fact)| !is_shown(label) && fact.single().is_some());
        let moves = |fact: &Prop| {
            let mut names = BTreeSet::new();
            names_in_prop(fact, &mut names);
            point.iter().any(|(_, x, _)| names.contains(x))
        };
        facts.map(|(_, fact)| (*fact).clone()).filter(|fact| moves(fact) && agrees(fact)).collect()
    }
}

/// Whether a fact was shown by a step, and not stated.
fn is_shown(label: &str) -> bool {
    label.bytes().all(|b| b.is_ascii_digit())
}

/// The quotients x/a, or x^k/a^k, of two names in an expression, each once.
fn quotients_in(e: &Expr, out: &mut Vec<(String, String)>) {
    if let ExprKind::Product(list) = &e.kind {
        let named = |e: &Expr| match &e.kind {
            ExprKind::Name(x) => Some((x.clone(), Rational::ONE)),
            ExprKind::Power(base, exponent) => match &base.kind {
                ExprKind::Name(x) => Some((x.clone(), rational(exponent)?)),
                _ => None,
            },
            _ => None,
        };
        let of = |operator: Factor| list.iter().filter(move |f| f.0 == operator).filter_map(move |f| named(&f.1));
        for (x, k) in of(Factor::Times) {
            if let Some((a, _)) = of(Factor::Over).find(|(a, own)| *own == k && *a != x)
                && !out.contains(&(x.clone(), a.clone()))
            {
                out.push((x, a));
            }
        }
    }
    crate::claim::walk::parts(e, &mut |part| quotients_in(part, out));
}
