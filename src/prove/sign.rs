//! The signs of forms: what follows at once from the signs of atoms, and what has to be searched.
//!
//! Contract: every set returned contains the sign of the form at every point that the context
//! allows and where the form is defined. A set of all signs means *not known*.
//!
//! Method: a form is a product, so its signs are the product of its atoms' signs. The sign of a sum
//! follows from the signs of its terms, from facts about the sum itself, or, when searched, from its
//! factors and from certificates of positivity under the context's constraints.

use super::comparison::Plain;
use super::context::*;
use super::translate::Condition;
use crate::algebra::form::{Atom, AtomId, Exponent, Form, Over};
use crate::algebra::{Polynomial, Var, diagonal, factor, positivity};
use crate::claim::syntax::{Constraint, Relation};
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::rounding_modes::RoundingMode;
use rustc_hash::FxHashMap as HashMap;

/// The highest degree of polynomials that are factored, divided or combined; above it only the sign that
/// shows at once counts.
pub const SEARCHED_DEGREE: u32 = 1_000;

type Result<T> = std::result::Result<T, Failure>;

impl Engine {
    /// The signs of a form that follow at once.
    pub fn signs(&mut self, cx: &mut Context, form: &Form) -> Result<Signs> {
        let mut signs = Signs::of_number(&form.coefficient);
        for (atom, exponent) in &form.powers {
            let base = self.atom_signs(cx, *atom)?;
            signs = signs.times(power_signs(base, exponent));
        }
        Ok(signs)
    }

    /// The signs of a form, each unknown atom searched.
    pub fn searched_form_signs(&mut self, cx: &mut Context, form: &Form) -> Result<Signs> {
        let mut signs = Signs::of_number(&form.coefficient);
        for (atom, exponent) in form.powers.clone() {
            let base = self.searched_signs(cx, atom)?;
            signs = signs.times(power_signs(base, &exponent));
        }
        Ok(signs)
    }

    /// The signs of an atom that follow at once.
    pub fn atom_signs(&mut self, cx: &mut Context, atom: AtomId) -> Result<Signs> {
        self.tick()?;
        if let Some((signs, sources)) = cx.memo.get(&atom) {
            self.used |= sources;
            return Ok(*signs);
        }
        let kind = self.ring.atom(atom);
        self.use_members(cx, atom)?;
        let before = std::mem::replace(&mut self.used, 0);
        let structural = match &*kind {
            Atom::Prime(_) | Atom::Euler => Signs::POSITIVE,
            Atom::Variable(_) | Atom::Member(..) if self.is_natural(cx, atom) => Signs::NOT_NEGATIVE,
            Atom::Variable(_) | Atom::Member(..) => Signs::ANY,
            // ln a has the sign of a − 1.
            Atom::Logarithm(inner) => {
                let shifted = self.ring.sub(&Form::atom(*inner), &Form::integer(1))?;
                if matches!(*self.ring.atom(*inner), Atom::Prime(_)) {
                    Signs::POSITIVE
                } else {
                    self.signs(cx, &shifted)?
                }
            }
            // Inside another sum with the same mark for its index, what is known of the index is not about this one.
            Atom::SumOver(over) | Atom::ProductOver(over) if self.is_bound(cx, over.index) => Signs::ANY,
            Atom::SumOver(over) => {
                let body = self.body_signs(cx, over)?;
                if body.within(Signs::NOT_NEGATIVE) { Signs::NOT_NEGATIVE } else { Signs::ANY }
            }
            Atom::ProductOver(over) => {
                let body = self.body_signs(cx, over)?;
                if body.within(Signs::POSITIVE) {
                    Signs::POSITIVE
                } else if body.within(Signs::NOT_NEGATIVE) {
                    Signs::NOT_NEGATIVE
                } else if body.within(Signs::NOT_ZERO) {
                    Signs::NOT_ZERO
                } else {
                    Signs::ANY
                }
            }
            Atom::Sum(poly) => {
                let mut signs = Signs::ZERO;
                for (monomial, c) in &poly.terms {
                    let term = Form { coefficient: c.clone(), powers: monomial.clone() };
                    signs = signs.plus(self.signs(cx, &term)?);
                    if signs == Signs::ANY {
                        break;
                    }
                }
                signs
            }
        };
        let mut sources = self.used;
        let mut signs = structural;
        if let Some((known, from)) = cx.signs.get(&atom)
            && !structural.within(*known)
        {
            signs = structural.and(*known);
            sources = if structural == Signs::ANY { *from } else { sources | from };
        }
        self.used = before | sources;
        if signs != Signs::ANY {
            cx.memo.insert(atom, (signs, sources));
        }
        Ok(signs)
    }

    /// The signs of an atom, with a search where they do not follow at once.
    pub fn searched_signs(&mut self, cx: &mut Context, atom: AtomId) -> Result<Signs> {
        let signs = self.atom_signs(cx, atom)?;
        let decided = [Signs::POSITIVE, Signs::NEGATIVE, Signs::ZERO].iter().any(|s| signs.within(*s));
        if decided {
            return Ok(signs);
        }
        if self.ring.sum(atom).is_none() || !cx.searched.insert(atom) {
            return Ok(signs);
        }
        let before = std::mem::replace(&mut self.used, 0);
        let found = self.search(cx, atom, signs)?;
        let sources = self.used;
        self.used |= before;
        if found != signs {
            cx.memo.insert(atom, (found, sources));
        }
        Ok(found)
    }

    fn search(&mut self, cx: &mut Context, atom: AtomId, known: Signs) -> Result<Signs> {
        self.tick()?;
        let mut signs = known;
        // Division by sums whose sign is known.
        for (divisor, _) in cx.signs.clone() {
            if divisor == atom {
                continue;
            }
            let (Some(p), Some(q)) = (self.ring.sum(atom), self.ring.sum(divisor)) else { continue };
            if q.terms.len() > p.terms.len() * 2 {
                continue;
            }
            if let Some(quotient) = self.ring.atom_quotient(atom, divisor)? {
                let form = self.ring.mul(&quotient, &Form::atom(divisor))?;
                signs = signs.and(self.signs(cx, &form)?);
            }
        }
        if decided(signs) {
            return Ok(signs);
        }
        let problem = Plain::of(self, cx, &[atom])?;
        let Some(goal) = problem.goals.first().cloned() else { return Ok(signs) };
        let seen = problem.on_the_diagonal(self, &goal)?;
        signs = signs.and(seen);
        // What vanishes on the diagonal, and has one sign beside it, has no more to show.
        if seen != Signs::ANY || goal.degree() > SEARCHED_DEGREE {
            self.used |= problem.sources;
            return Ok(signs);
        }
        // Factors, each judged by its own terms.
        if goal.term_count() <= 200
            && let Ok(factors) = factor::factor(&goal)
            && (factors.factors.len() > 1 || factors.factors.iter().any(|f| f.1 > 1))
        {
            let mut product = Signs::of_number(&factors.unit);
            for (factor, multiplicity) in &factors.factors {
                let mut each = problem.signs_by_terms(factor);
                if !decided(each) {
                    each = each.and(problem.searched(self, factor)?);
                }
                product = product.times(power_signs(each, &Exponent::integer(i64::from(*multiplicity))));
            }
            signs = signs.and(product);
            if decided(signs) {
                self.used |= problem.sources;
                return Ok(signs);
            }
        }
        let found = signs.and(problem.searched(self, &goal)?);
        if found != signs {
            self.used |= problem.sources;
        }
        Ok(found)
    }

    /// Shows that an expression has a value.
    pub fn show_conditions(&mut self, cx: &mut Context, conditions: Vec<Condition>) -> Result<()> {
        for condition in conditions {
            let signs = self.searched_form_signs(cx, &condition.form)?;
            if !signs.within(Signs::of(condition.relation)) {
                let what = match condition.relation {
                    Relation::NotEqual => format!("cannot show that {} is not 0", condition.text),
                    _ => format!("cannot show that {} has a value", condition.text),
                };
                return Err(Failure::Undefined(what));
            }
        }
        Ok(())
    }

    /// Uses the domain of every member of a family that the atom mentions.
    fn use_members(&mut self, cx: &mut Context, atom: AtomId) -> Result<()> {
        match &*self.ring.atom(atom) {
            Atom::Member(name, index) => {
                let (name, index) = (name.clone(), index.clone());
                self.use_member(cx, atom, &name, &index)
            }
            Atom::Sum(poly) => {
                let atoms: Vec<AtomId> = poly.terms.iter().flat_map(|t| t.0.iter().map(|p| p.0)).collect();
                for inner in atoms {
                    self.use_members(cx, inner)?;
                }
                Ok(())
            }
            // The members in the body of a sum or product are those of its range: they are looked at there.
            _ => Ok(()),
        }
    }

    /// Whether an index is known to lie in the range of a family, and not to be negative.
    pub fn in_range(&mut self, cx: &mut Context, family: &Family, index: &Form) -> Result<bool> {
        if !self.not_negative(cx, index)? {
            return Ok(false);
        }
        let Some((from, to)) = &family.binding.indices else { return Ok(true) };
        let mut outer = cx.clone();
        outer.indices.clear();
        let (from, to) =
            (self.scalar(&mut outer, from, &mut Vec::new())?, self.scalar(&mut outer, to, &mut Vec::new())?);
        for difference in [self.ring.sub(index, &from)?, self.ring.sub(&to, index)?] {
            if !self.not_negative(cx, &difference)? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Whether a form is known not to be negative.
    pub fn not_negative(&mut self, cx: &mut Context, form: &Form) -> Result<bool> {
        Ok(self.signs(cx, form)?.within(Signs::NOT_NEGATIVE)
            || self.searched_form_signs(cx, form)?.within(Signs::NOT_NEGATIVE))
    }

    /// The signs of the body of a sum or product, with its index in its range; nothing that is found there stays.
    fn body_signs(&mut self, cx: &Context, over: &Over) -> Result<Signs> {
        let mut inner = cx.clone();
        if let Atom::Variable(name) = &*self.ring.atom(over.index) {
            inner.variables.push((name.clone(), true));
        }
        let index = Form::atom(over.index);
        for difference in [self.ring.sub(&index, &over.from)?, self.ring.sub(&over.to, &index)?] {
            self.narrow_form(&mut inner, &difference, Relation::GreaterEqual, 0)?;
        }
        self.signs(&mut inner, &over.body)
    }

    /// Whether an index is that of a sum or product around this place.
    fn is_bound(&self, cx: &Context, index: AtomId) -> bool {
        matches!(&*self.ring.atom(index), Atom::Variable(name) if cx.variables.iter().any(|v| v.0 == *name))
    }

    fn use_member(&mut self, cx: &mut Context, atom: AtomId, name: &str, index: &Form) -> Result<()> {
        if !cx.members.insert(atom) {
            return Ok(());
        }
        let Some(family) = cx.families.get(name).cloned() else { return Ok(()) };
        if !self.in_range(cx, &family, index)? {
            cx.members.remove(&atom);
            return Ok(());
        }
        // The names of a declaration are those of the claim, not of a sum around its use.
        let own = HashMap::from_iter([(family.index.clone(), index.clone())]);
        let saved = std::mem::replace(&mut cx.indices, own);
        let result = self.use_domain(cx, atom, &family);
        cx.indices = saved;
        result
    }

    /// Takes in what the declaration of a family says of a member; its index stands in `cx.indices`.
    fn use_domain(&mut self, cx: &mut Context, atom: AtomId, family: &Family) -> Result<()> {
        let mut bounds = Vec::new();
        for constraint in &family.binding.constraints {
            match constraint {
                Constraint::Relation(relation, e) => bounds.push((*relation, e.clone())),
                Constraint::Interval { from, from_closed, to, to_closed } => {
                    bounds.push((if *from_closed { Relation::GreaterEqual } else { Relation::Greater }, from.clone()));
                    bounds.push((if *to_closed { Relation::LessEqual } else { Relation::Less }, to.clone()));
                }
                Constraint::Range(from, to) => {
                    bounds.push((Relation::GreaterEqual, from.clone()));
                    bounds.push((Relation::LessEqual, to.clone()));
                }
            }
        }
        for (relation, bound) in bounds {
            let value = self.scalar(cx, &bound, &mut Vec::new())?;
            let difference = self.ring.sub(&Form::atom(atom), &value)?;
            self.narrow_form(cx, &difference, relation, family.source)?;
        }
        Ok(())
    }
}

/// Whether one sign is left.
pub fn decided(signs: Signs) -> bool {
    [Signs::POSITIVE, Signs::NEGATIVE, Signs::ZERO].iter().any(|s| signs.within(*s))
}

/// The signs of a power, where it is defined.
pub fn power_signs(base: Signs, exponent: &Exponent) -> Signs {
    let negative = exponent.order_sign().is_lt();
    let signs = match exponent {
        _ if exponent.is_even() => base.squared(),
        _ if exponent.is_integer() => base,
        // Other powers exist only for non-negative bases; symbolic ones only for positive bases.
        Exponent::Number(_) => base.and(Signs::NOT_NEGATIVE),
        Exponent::Symbolic(_) => Signs::POSITIVE,
    };
    if negative { signs.and(Signs::NOT_ZERO) } else { signs }
}

impl Plain {
    /// The sign of a polynomial from the signs of its terms.
    pub fn signs_by_terms(&self, poly: &Polynomial) -> Signs {
        let mut signs = Signs::ZERO;
        for (monomial, c) in poly.terms() {
            let mut term = Signs::of_number(c);
            for &(variable, k) in monomial.powers() {
                let base = self.signs.get(variable as usize).copied().unwrap_or(Signs::ANY);
                term = term.times(power_signs(base, &Exponent::integer(i64::from(k))));
            }
            signs = signs.plus(term);
        }
        signs
    }

    /// The sign of a homogeneous polynomial in two positive variables that vanishes where they are
    /// equal.
    fn on_the_diagonal(&self, engine: &mut Engine, poly: &Polynomial) -> Result<Signs> {
        let Some(found) = diagonal::diagonal(poly) else { return Ok(Signs::ANY) };
        let sign_of = |v: Var| self.signs.get(v as usize).copied().unwrap_or(Signs::ANY);
        if sign_of(found.x) != Signs::POSITIVE || found.y.is_some_and(|y| sign_of(y) != Signs::POSITIVE) {
            return Ok(Signs::ANY);
        }
        let other = found.y.map_or_else(Polynomial::one, Polynomial::variable);
        let difference = Polynomial::variable(found.x).sub(&other);
        let mut factor = self.signs_by_terms(&difference);
        if !decided(factor) {
            factor = factor.and(self.searched(engine, &difference)?);
        }
        let power = power_signs(factor, &Exponent::integer(i64::from(found.multiplicity)));
        Ok(power.times(if found.positive { Signs::POSITIVE } else { Signs::NEGATIVE }))
    }

    /// Whether the polynomial is seen to be positive, and negative, at sampled points where the
    /// constraints hold with room to spare. In floating point: a hint which search to skip.
    fn guess_signs(&self, poly: &Polynomial) -> (bool, bool) {
        type Terms = Vec<(Vec<(usize, i32)>, f64)>;
        let terms = |p: &Polynomial| -> Terms {
            p.terms()
                .map(|(m, c)| {
                    let powers =
                        m.powers().iter().map(|&(v, k)| (v as usize, i32::try_from(k).unwrap_or(i32::MAX))).collect();
                    (powers, f64::rounding_from(c, RoundingMode::Nearest).0)
                })
                .collect()
        };
        // The value and the sum of the terms' sizes.
        let value = |terms: &Terms, point: &[f64]| -> (f64, f64) {
            terms.iter().fold((0.0, 0.0), |(sum, size), (powers, c)| {
                let term = powers.iter().fold(*c, |t, &(v, k)| t * point[v].powi(k));
                (sum + term, size + term.abs())
            })
        };
        let constraints: Vec<Terms> = self.constraints.iter().map(|c| terms(&c.poly)).collect();
        let goal = terms(poly);
        let (mut positive, mut negative) = (false, false);
        let mut state = 0x9E37_79B9_7F4A_7C15_u64;
        for _ in 0..160 {
            let point: Vec<f64> = self
                .signs
                .iter()
                .map(|signs| {
                    state ^= state << 13;
                    state ^= state >> 7;
                    state ^= state << 17;
                    const VALUES: [f64; 8] = [0.1, 0.4, 0.8, 0.97, 1.05, 1.3, 2.5, 8.0];
                    let size = VALUES[(state >> 40) as usize % 8] * (1.0 + ((state >> 20) % 97) as f64 / 1000.0);
                    let flip = signs.within(Signs::NEGATIVE) || (*signs == Signs::ANY && state & 1 == 1);
                    if flip { -size } else { size }
                })
                .collect();
            let clear = |(sum, size): (f64, f64)| if sum.abs() > size * 1e-9 { sum.signum() } else { 0.0 };
            if constraints.iter().any(|c| clear(value(c, &point)) <= 0.0) {
                continue;
            }
            match clear(value(&goal, &point)) {
                s if s > 0.0 => positive = true,
                s if s < 0.0 => negative = true,
                _ => {}
            }
            if positive && negative {
                break;
            }
        }
        (positive, negative)
    }

    /// The sign of a polynomial from certificates under the constraints.
    pub fn searched(&self, engine: &mut Engine, poly: &Polynomial) -> Result<Signs> {
        engine.tick()?;
        let limits = positivity::Limits::default();
        let mut signs = Signs::ANY;
        // Sampled points say which searches are in vain; they decide nothing.
        let seen = self.guess_signs(poly);
        if seen == (true, true) {
            return Ok(signs);
        }
        for (p, strict, weak) in [
            (poly.clone(), Signs::POSITIVE, Signs::NOT_NEGATIVE),
            (poly.neg(), Signs::NEGATIVE, Signs::of(Relation::LessEqual)),
        ] {
            let in_vain = if strict == Signs::POSITIVE { seen.1 } else { seen.0 };
            if in_vain {
                continue;
            }
            // The same polynomial comes up in many branches of an argument.
            let key = (p, self.constraints.clone());
            let found = match engine.certified.get(&key) {
                Some(found) => *found,
                None => {
                    // The weak statement first: where it finds no certificate the strict one finds none.
                    let certify = |strict| positivity::certify(&key.0, &key.1, &[], strict, &limits).is_some();
                    let found = if !certify(false) {
                        Signs::ANY
                    } else if certify(true) {
                        Signs::POSITIVE
                    } else {
                        Signs::NOT_NEGATIVE
                    };
                    *engine.certified.entry(key).or_insert(found)
                }
            };
            if found != Signs::ANY {
                signs = signs.and(if found == Signs::POSITIVE { strict } else { weak });
            }
            if found == Signs::POSITIVE {
                break;
            }
        }
        Ok(signs)
    }
}
