//! Chains of comparisons, each right side the next left side, and comparisons of powers from those of their bases.

use super::comparison::single;
use super::{Fail, Prover};
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::kernel::key;
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, expr, numeral, power};

/// The longest chain.
const LINKS: usize = 5;

/// The most chains that are followed at once.
const CHAINS: usize = 200;

/// The most powers of facts that are tried for one goal.
const POWERS: usize = 12;

/// A step of a chain: from something that is at least as large.
struct Link {
    from: String,
    to: String,
    label: Label,
    /// Whether the fact says so from left to right.
    forward: bool,
}

impl Prover {
    /// Shows a comparison as the sum of a chain of facts.
    pub(super) fn by_chain(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let (a, relation, b) = single(goal)?;
        let up = relation.is_greater().ok_or(Fail::No("an order"))?;
        let (a, b) = (key::expr(a), key::expr(b));
        let (from, to) = if up { (a, b) } else { (b, a) };
        let mut links = Vec::new();
        for (label, fact) in self.checker.facts() {
            let Some((x, r, y)) = fact.single() else { continue };
            let (x, y) = (key::expr(x), key::expr(y));
            for (relations, forward) in [
                ([Relation::Greater, Relation::GreaterEqual, Relation::Equal], true),
                ([Relation::Less, Relation::LessEqual, Relation::Equal], false),
            ] {
                if relations.contains(&r) {
                    let (from, to) = if forward { (x.clone(), y.clone()) } else { (y.clone(), x.clone()) };
                    links.push(Link { from, to, label: label.to_string(), forward });
                }
            }
        }
        let mut chains: Vec<(&str, Vec<&Link>)> = vec![(&from, Vec::new())];
        let mut found = Vec::new();
        for _ in 0..LINKS {
            let mut longer = Vec::new();
            for (at, chain) in &chains {
                let new = |l: &&Link| l.from == *at && chain.iter().all(|c| c.label != l.label);
                for link in links.iter().filter(new) {
                    let next: Vec<&Link> = chain.iter().copied().chain([link]).collect();
                    if link.to == to && next.len() > 1 {
                        found.push(next);
                    } else {
                        longer.push((link.to.as_str(), next));
                    }
                }
            }
            longer.truncate(CHAINS);
            chains = longer;
        }
        for chain in found {
            let sign = |forward: bool| {
                let one = numeral(1);
                if forward == up { one } else { expr(ExprKind::Negate(Box::new(one))) }
            };
            let terms = chain.iter().map(|l| Term { facts: vec![l.label.clone()], factor: sign(l.forward) }).collect();
            if let Ok(label) = self.combination(goal.clone(), terms) {
                return Ok(label);
            }
        }
        Err(Fail::No("a chain"))
    }

    /// Shows a comparison of what powers with one exponent are in, from a fact about their bases.
    pub(super) fn by_powers(&mut self, goal: &Prop) -> Result<Label, Fail> {
        // Not within one another.
        if std::mem::replace(&mut self.within_powers, true) {
            return Err(Fail::No("powers"));
        }
        let shown = self.by_bases_of_facts(goal);
        self.within_powers = false;
        shown
    }

    fn by_bases_of_facts(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let wanted: &[Relation] = match single(goal)?.1 {
            Relation::NotEqual => &[Relation::NotEqual],
            Relation::Equal => return Err(Fail::No("an order of powers")),
            _ => &[Relation::Less, Relation::LessEqual, Relation::Greater, Relation::GreaterEqual],
        };
        let facts = self.facts();
        let mut left = POWERS;
        for (label, fact) in facts.iter().rev() {
            let Some((x, relation, y)) = fact.single() else { continue };
            if !wanted.contains(&relation) {
                continue;
            }
            for exponent in self.exponents_met(x) {
                if !self.signs_of(&exponent).within(Signs::POSITIVE) {
                    continue;
                }
                left = left.checked_sub(1).ok_or(Fail::No("few powers"))?;
                let shown = compare(power(x, &exponent), relation, power(y, &exponent));
                if self.known(&shown).is_some() {
                    continue;
                }
                let done = self.attempt(|c| {
                    let raised = c.emit(Rule::Monotone { from: label.clone() }, shown.clone())?;
                    c.take_in(&raised, &shown)?;
                    c.quietly(goal)
                });
                if done.is_ok() {
                    return done;
                }
            }
        }
        Err(Fail::No("a power of a fact"))
    }
}
