//! Cases by the remainder of a natural number: n = c·m, or n = c·m + 1, …
//!
//! Certificate: that there is such an m for every n, by induction, with the rule `existence` in its step; then its instance at n.
//!
//! Limits: moduli from 2 to [`MODULUS`] that occur as numerals in the goal, [`MODULI`] of these for each of [`VARIABLES`] variables.

use super::integers::all_sides;
use super::{Fail, Prover, implies};
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::claim::walk;
use crate::kernel::statement::{compare, name, numeral, prop, sum};
use std::collections::BTreeSet;

/// The largest modulus.
const MODULUS: u32 = 12;

/// The most moduli for a variable.
const MODULI: usize = 3;

/// The most variables.
const VARIABLES: usize = 2;

/// c·m + r.
fn form(modulus: u32, m: &Expr, remainder: u32) -> Expr {
    let multiple = super::letters::product(vec![numeral(modulus), m.clone()]);
    if remainder == 0 { multiple } else { sum(vec![(Sign::Plus, multiple), (Sign::Plus, numeral(remainder))]) }
}

/// n = c·m or n = c·m + 1 or …
fn some_form(n: &Expr, modulus: u32, m: &Expr) -> Prop {
    let forms = (0..modulus).map(|r| compare(n.clone(), Relation::Equal, form(modulus, m, r)));
    prop(PropKind::Or(forms.collect()))
}

/// A natural variable without a domain.
fn natural(text: &str) -> Vec<Binding> {
    vec![Binding::of(Name::new(text), true, Vec::new())]
}

/// The numerals of an expression that may be moduli.
fn moduli(e: &Expr, out: &mut BTreeSet<u32>) {
    out.extend(super::letters::natural(e).filter(|c| (2..=MODULUS).contains(c)));
    walk::parts(e, &mut |part| moduli(part, out));
}

impl Prover {
    /// Whether a goal speaks of a floor, as the reader writes it.
    pub(super) fn has_a_floor(goal: &Prop) -> bool {
        let mut names = BTreeSet::new();
        crate::kernel::names::names_in_prop(goal, &mut names);
        names.iter().any(|n| n.starts_with("floor_"))
    }

    /// Proves a goal for each remainder of a natural variable by a numeral of the goal.
    pub(super) fn by_residues(&mut self, goal: &Prop) -> Result<Label, Fail> {
        if self.splits > 0 || self.inductions > 0 || self.in_residues {
            return Err(Fail::No("remainders"));
        }
        let (mut used, mut numerals, mut sides) = (BTreeSet::new(), BTreeSet::new(), Vec::new());
        crate::kernel::names::names_in_prop(goal, &mut used);
        all_sides(goal, &mut sides);
        sides.iter().for_each(|e| moduli(e, &mut numerals));
        let names: Vec<String> = self.naturals.iter().filter(|n| used.contains(*n)).take(VARIABLES).cloned().collect();
        // The largest first: n^3 - n = 6*k needs 6, and no other numeral of it does.
        for modulus in numerals.into_iter().rev().take(MODULI) {
            for n in &names {
                self.in_residues = true;
                let shown = self.attempt(|c| {
                    let every = c.remainders(modulus)?;
                    c.instance(&every, &name(n))?;
                    c.show(goal)
                });
                self.in_residues = false;
                if shown.is_ok() {
                    return shown;
                }
            }
        }
        Err(Fail::No("remainders"))
    }

    /// For every natural number n there is an m with n = c·m + r and r < c.
    fn remainders(&mut self, modulus: u32) -> Result<Label, Fail> {
        let (n, m) = (self.fresh("n"), self.fresh("m"));
        let body = prop(PropKind::Exists(natural(&m), Box::new(some_form(&name(&n), modulus, &name(&m)))));
        self.induction_by(&n, None, &body, &mut |c, hypothesis, next| {
            let quotient = c.fresh("m");
            let cases = some_form(&name(&n), modulus, &name(&quotient));
            let step = implies(&cases, next);
            let all = prop(PropKind::ForAll(natural(&quotient), Box::new(step.clone())));
            let all = c.block(&all, |c, _| {
                c.block(&step, |c, block| {
                    let mut from = vec![format!("{block}s")];
                    for remainder in 0..modulus {
                        let case = compare(name(&n), Relation::Equal, form(modulus, &name(&quotient), remainder));
                        from.push(c.block(&implies(&case, next), |c, block| {
                            c.next_remainder(&n, &quotient, (modulus, remainder), &format!("{block}s"), next)
                        })?);
                    }
                    c.emit(Rule::Logic { from }, next.clone())
                })
            })?;
            c.emit(Rule::Existence { some: hypothesis, all }, next.clone())
        })
    }

    /// n + 1 = c·m + (r + 1), or c·(m + 1), from n = c·m + r.
    fn next_remainder(
        &mut self,
        n: &str,
        quotient: &str,
        (modulus, remainder): (u32, u32),
        fact: &str,
        next: &Prop,
    ) -> Result<Label, Fail> {
        let PropKind::Exists(bindings, _) = &next.kind else { return Err(Fail::No("a quotient")) };
        let own = bindings.first().and_then(|b| b.names.first()).ok_or(Fail::No("a quotient"))?.0.clone();
        let above = |e: Expr| sum(vec![(Sign::Plus, e), (Sign::Plus, numeral(1))]);
        let last = remainder + 1 == modulus;
        let value = if last { above(name(quotient)) } else { name(quotient) };
        let number = above(name(n));
        let shown = form(modulus, &value, if last { 0 } else { remainder + 1 });
        let term = Term { facts: vec![fact.to_string()], factor: numeral(1) };
        let equation = self.combination(compare(number.clone(), Relation::Equal, shown), vec![term])?;
        let some = self.logic(&[&equation], &some_form(&number, modulus, &value))?;
        self.emit(Rule::Witness { with: vec![(own, value)], from: vec![some] }, next.clone())
    }
}
