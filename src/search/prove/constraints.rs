//! Constraints: what facts and atoms say of the sign of polynomials, for a certificate of positivity.

use super::polynomials::to_algebra;
use super::write::multiplied;
use super::{Certifier, Fail};
use crate::algebra::Polynomial;
use crate::algebra::positivity::Constraint;
use crate::claim::syntax::*;
use crate::kernel::fraction::{Fraction, Poly, Work};
use crate::kernel::order::Signs;
use num_rational::BigRational;
use std::collections::BTreeSet;

/// A polynomial that a fact or an atom says is not negative.
pub(super) struct Known {
    pub(super) constraint: Constraint,
    /// The fact, if it comes from one.
    pub(super) label: Option<String>,
    /// The constraint is this times the difference of the fact's sides, or this itself.
    pub(super) factor: Fraction,
}

impl Certifier {
    /// What is known of signs around a polynomial, as constraints.
    pub(super) fn known(&mut self, poly: &Poly) -> Result<Vec<Known>, Fail> {
        let mut near: BTreeSet<usize> = poly.atoms().collect();
        let facts = self.differences();
        let mut chosen: Vec<(Fraction, Known)> = Vec::new();
        let mut more = BTreeSet::new();
        for pass in 0..2 {
            for (label, difference, relation) in &facts {
                let (open, rest) = self.open_part(difference)?;
                if open.factors.values().any(|k| *k < 0) || open.factors.is_empty() {
                    continue;
                }
                let Ok(expanded) = open.expanded(&Work::default()) else { continue };
                if expanded.terms().count() > 60 {
                    continue;
                }
                let inside = expanded.atoms().all(|a| near.contains(&a));
                if !inside {
                    if pass == 0 && expanded.atoms().any(|a| near.contains(&a)) {
                        more.extend(expanded.atoms());
                    }
                    continue;
                }
                let signs = self.checker.signs_of(&rest).map_err(Fail::from)?;
                let positive = signs.within(Signs::POSITIVE);
                if !positive && !signs.within(Signs::of(Relation::Less)) {
                    continue;
                }
                for (up, strict) in directions(*relation) {
                    // ±open = (x − y)/|rest|, up to the direction.
                    let same = up == positive;
                    let base = to_algebra(&expanded)?;
                    let constraint = Constraint { poly: if same { base } else { base.neg() }, strict };
                    let inverse = rest.power(-1).map_err(Fail::from)?;
                    let factor = if same { inverse } else { inverse.negated() };
                    if chosen.iter().any(|c| c.1.constraint == constraint) {
                        continue;
                    }
                    chosen.push((open.clone(), Known { constraint, label: Some(label.clone()), factor }));
                }
            }
            if pass == 0 {
                if chosen.len() >= 6 || near.len() + more.len() > 14 {
                    break;
                }
                near.extend(more.iter().copied());
            }
        }
        chosen.truncate(14);
        let mut out: Vec<Known> = chosen.into_iter().map(|c| c.1).collect();
        self.add_signs_of_atoms(poly, &mut out)?;
        Ok(out)
    }

    /// The single comparisons among the facts, newest first, as the difference of their sides.
    fn differences(&mut self) -> Vec<(String, Fraction, Relation)> {
        let mut facts = Vec::new();
        let list = self.facts();
        for (label, prop) in list.iter().rev() {
            if !matches!(&prop.kind, PropKind::Compare(_, r) if r.len() == 1 && r.first() != Some(&Relation::NotEqual))
            {
                continue;
            }
            let Ok((difference, relation)) = self.checker.difference(prop) else { continue };
            if difference.is_zero() {
                continue;
            }
            facts.push((label.clone(), difference, relation));
        }
        facts
    }

    /// A difference as the product of its factors whose sign is open, or known from this fact only, and of the rest.
    fn open_part(&mut self, difference: &Fraction) -> Result<(Fraction, Fraction), Fail> {
        let mut open = Fraction::integer(1);
        let mut rest = Fraction::number(difference.coefficient.clone());
        for (p, k) in &difference.factors {
            let signs = self.checker.poly_signs(p).map_err(Fail::from)?.power(*k);
            // What the fact itself says is not what is known without it.
            let settled = signs.within(Signs::POSITIVE) || signs.within(Signs::of(Relation::Less));
            let open_terms = p.terms().any(|t| *t.1 < BigRational::from_integer(0.into()))
                || p.atoms()
                    .any(|a| !self.checker.poly_signs(&Poly::atom(a)).is_ok_and(|s| s.within(Signs::NOT_NEGATIVE)));
            let keep = !settled || (*k == 1 && p.single_atom().is_none() && open_terms);
            let one = Fraction::of(p).power(*k).map_err(Fail::from)?;
            if keep { open = multiplied(&open, &one)? } else { rest = multiplied(&rest, &one)? }
        }
        Ok((open, rest))
    }

    /// Adds what is known of the signs of the atoms of a polynomial and of its constraints.
    fn add_signs_of_atoms(&mut self, poly: &Poly, out: &mut Vec<Known>) -> Result<(), Fail> {
        let used: BTreeSet<usize> =
            poly.atoms().chain(out.iter().flat_map(|k| k.constraint.poly.variables()).map(|v| v as usize)).collect();
        for atom in used {
            let signs = self.checker.poly_signs(&Poly::atom(atom)).map_err(Fail::from)?;
            let base = Polynomial::variable(u32::try_from(atom).map_err(|_| "too many atoms")?);
            if signs.within(Signs::NOT_NEGATIVE) {
                let strict = signs.within(Signs::POSITIVE);
                let constraint = Constraint { poly: base, strict };
                if !out.iter().any(|k| k.constraint.poly == constraint.poly && (k.constraint.strict || !strict)) {
                    out.push(Known { constraint, label: None, factor: Fraction::atom(atom) });
                }
            }
        }
        Ok(())
    }
}

/// The directions in which a fact bounds a polynomial: whether from below, and strictly.
fn directions(relation: Relation) -> Vec<(bool, bool)> {
    match relation {
        Relation::Greater => vec![(true, true)],
        Relation::GreaterEqual => vec![(true, false)],
        Relation::Less => vec![(false, true)],
        Relation::LessEqual => vec![(false, false)],
        _ => vec![(true, false), (false, false)],
    }
}
