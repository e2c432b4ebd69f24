//! Propositions as formulas of linear comparisons, for elimination.
//!
//! Method: an absolute value is read in two cases, the sign of what is inside being the condition of each. What is no sum or
//! product by a number is a letter; no name that is bound may occur within it, so that bound names occur linearly or not at all.
//!
//! Limits: [`PIECES`].

use super::elimination::Formula::{All, Exists};
use super::elimination::{Formula, Sense, and, atom, cases, joined};
use super::letters::Letters;
use crate::algebra::Polynomial;
use crate::claim::syntax::*;
use crate::kernel::statement::{domain, name};
use malachite::Rational;
use std::collections::BTreeSet;

/// The most cases of absolute values in one side.
const PIECES: usize = 16;

/// Reads propositions as formulas.
#[derive(Default)]
pub(super) struct Reader {
    /// The letters, each with what it stands for.
    pub(super) letters: Letters,
    /// Names that are bound where the reader is.
    bound: BTreeSet<String>,
}

/// A side of a comparison: what holds in a case, and the side in this case.
type Piece = (Vec<Formula>, Polynomial);

impl Reader {
    /// A proposition, or its opposite. `None` where it is not linear in its bound names, or binds a natural number.
    pub(super) fn read(&mut self, p: &Prop, positive: bool) -> Option<Formula> {
        Some(match &p.kind {
            PropKind::Compare(sides, relations) => {
                let mut list = Vec::new();
                for (pair, relation) in sides.windows(2).zip(relations) {
                    list.push(self.comparison(
                        &pair[0],
                        if positive { *relation } else { relation.negated() },
                        &pair[1],
                    )?);
                }
                joined(list, positive)
            }
            PropKind::And(list) => joined(self.all(list, positive)?, positive),
            PropKind::Or(list) => joined(self.all(list, positive)?, !positive),
            PropKind::Not(inner) => self.read(inner, !positive)?,
            PropKind::Implies(a, b) => joined(vec![self.read(a, !positive)?, self.read(b, positive)?], !positive),
            PropKind::Equivalent(list) => {
                let mut parts = Vec::new();
                for pair in list.windows(2) {
                    for (a, b) in [(&pair[0], &pair[1]), (&pair[1], &pair[0])] {
                        parts.push(joined(vec![self.read(a, !positive)?, self.read(b, positive)?], !positive));
                    }
                }
                joined(parts, positive)
            }
            PropKind::Exists(bindings, body) => self.quantified(bindings, body, positive, positive)?,
            PropKind::ForAll(bindings, body) => self.quantified(bindings, body, !positive, positive)?,
            _ => return None,
        })
    }

    fn all(&mut self, list: &[Prop], positive: bool) -> Option<Vec<Formula>> {
        list.iter().map(|p| self.read(p, positive)).collect()
    }

    /// `exists`, where `some`, or else `for all`: of the body, or of its opposite.
    fn quantified(&mut self, bindings: &[Binding], body: &Prop, some: bool, positive: bool) -> Option<Formula> {
        let names: Vec<String> = bindings.iter().flat_map(|b| &b.names).map(|n| n.0.text.clone()).collect();
        if bindings.iter().any(|b| b.natural || b.names.iter().any(|n| n.1.is_some())) {
            return None;
        }
        let before = self.bound.clone();
        self.bound.extend(names.iter().cloned());
        // In `for all` the domain is a premise.
        let mut parts = Vec::new();
        for fact in bindings.iter().flat_map(domain) {
            parts.push(self.read(&fact, some)?);
        }
        parts.push(self.read(body, positive)?);
        self.bound = before;
        let inner = joined(parts, some);
        Some(names.into_iter().rev().fold(inner, |inner, n| {
            let x = self.letters.of(&name(&n));
            if some { Exists(x, Box::new(inner)) } else { All(x, Box::new(inner)) }
        }))
    }

    fn comparison(&mut self, a: &Expr, relation: Relation, b: &Expr) -> Option<Formula> {
        let (left, right) = (self.pieces(a)?, self.pieces(b)?);
        let mut list = Vec::new();
        for (first, p) in &left {
            for (second, q) in &right {
                let d = p.sub(q);
                let shown = match relation {
                    Relation::Equal => atom(d, Sense::Zero),
                    Relation::NotEqual => atom(d, Sense::NotZero),
                    Relation::Greater => atom(d, Sense::Positive),
                    Relation::GreaterEqual => atom(d, Sense::NotNegative),
                    Relation::Less => atom(d.neg(), Sense::Positive),
                    Relation::LessEqual => atom(d.neg(), Sense::NotNegative),
                };
                list.push((and(first.iter().chain(second).cloned().collect()), shown));
            }
        }
        Some(cases(list.into_iter()))
    }

    /// An expression in the cases of its absolute values.
    fn pieces(&mut self, e: &Expr) -> Option<Vec<Piece>> {
        let out = match &e.kind {
            ExprKind::Negate(a) => self.pieces(a)?.into_iter().map(|(c, p)| (c, p.neg())).collect(),
            ExprKind::Sum(list) => {
                let mut out: Vec<Piece> = vec![(Vec::new(), Polynomial::zero())];
                for (sign, e) in list {
                    let more = self.pieces(e)?;
                    out = combined(&out, &more, &|p, q| Some(if *sign == Sign::Plus { p.add(q) } else { p.sub(q) }))?;
                }
                out
            }
            ExprKind::Product(list) => {
                let mut out: Vec<Piece> = vec![(Vec::new(), Polynomial::one())];
                for (factor, e) in list {
                    let more = self.pieces(e)?;
                    out = combined(&out, &more, &|p, q| match factor {
                        Factor::Times => p.try_mul(q).ok(),
                        Factor::Over => q.as_constant().filter(|c| *c != 0).map(|c| p.scale(&(Rational::from(1) / c))),
                    })?;
                }
                out
            }
            ExprKind::Apply(f, list) if f.text == "sqrt" && list.len() == 1 => match &list[0].kind {
                ExprKind::Power(base, exponent) if matches!(&exponent.kind, ExprKind::Number(k) if k == "2") => {
                    let mut out = Vec::new();
                    for (conditions, p) in self.pieces(base)? {
                        for (condition, value) in [
                            (atom(p.clone(), Sense::NotNegative), p.clone()),
                            (atom(p.neg(), Sense::Positive), p.neg()),
                        ] {
                            let mut list = conditions.clone();
                            list.push(condition);
                            out.push((list, value));
                        }
                    }
                    out
                }
                _ => self.other(e)?,
            },
            ExprKind::Number(_) | ExprKind::Name(_) => vec![(Vec::new(), self.letters.polynomial(e)?)],
            _ => self.other(e)?,
        };
        (out.len() <= PIECES).then_some(out)
    }

    /// An expression that is a letter or a power of letters; none of the bound names may occur within it.
    fn other(&mut self, e: &Expr) -> Option<Vec<Piece>> {
        let mut names = BTreeSet::new();
        crate::kernel::names::names_in(e, &mut names);
        if names.iter().any(|n| self.bound.contains(n)) {
            return None;
        }
        Some(vec![(Vec::new(), self.letters.polynomial(e)?)])
    }
}

fn combined(
    left: &[Piece],
    right: &[Piece],
    of: &dyn Fn(&Polynomial, &Polynomial) -> Option<Polynomial>,
) -> Option<Vec<Piece>> {
    let mut out = Vec::new();
    for (first, p) in left {
        for (second, q) in right {
            let both: Vec<Formula> = first.iter().chain(second).cloned().collect();
            out.push((both, of(p, q)?));
        }
    }
    (out.len() <= PIECES).then_some(out)
}
