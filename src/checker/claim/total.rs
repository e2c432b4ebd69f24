//! Expressions that, by their form, have a value wherever the hypotheses hold.
//!
//! What the reader writes as a hypothesis, a floor or a recurrence, says that its expressions have values, which a definition does
//! not say. It asks here first. An expression has a value by its form if the signs of its parts show it: it divides by what is not 0,
//! and takes roots of what is not negative and logarithms of what is positive. Declarations and hypotheses before it tell signs.

use super::definedness::number;
use super::preamble::applied;
use super::syntax::*;
use super::walk;
use std::collections::{BTreeMap, BTreeSet};

/// Functions with a value at every real number.
const EVERYWHERE: [&str; 11] = ["abs", "max", "min", "exp", "cos", "sin", "arctan", "cosh", "sinh", "sech", "tanh"];

/// Whether a constraint keeps a name above 0: `> 0`, `>= 1`, `in (0, 1]`, `in 1..n`.
fn is_above_zero(constraint: &Constraint) -> bool {
    let above = |bound: &Expr, included: bool| number(bound).is_some_and(|(top, _)| top > 0 || (top == 0 && !included));
    match constraint {
        Constraint::Relation(Relation::Greater, bound) => above(bound, false),
        Constraint::Relation(Relation::GreaterEqual, bound) => above(bound, true),
        Constraint::Relation(..) => false,
        Constraint::Interval { from, from_closed, .. } => above(from, *from_closed),
        Constraint::Range(from, _) => above(from, true),
    }
}

/// What the items of a claim, in their order, tell of the names that they declare.
#[derive(Default)]
pub(crate) struct Values {
    /// Names of what may have no value: families, definitions with parameters or with conditions of their own.
    partial: BTreeSet<String>,
    /// Variables that are declared positive, or that a hypothesis puts above a number or variable that is.
    positive: BTreeSet<String>,
    /// Variables that are natural numbers.
    natural: BTreeSet<String>,
    /// Families with a member at each natural number, and whether the members are positive, and natural numbers.
    families: BTreeMap<String, (bool, bool)>,
}

impl Values {
    /// What these items tell.
    pub(crate) fn of(items: &[Item]) -> Values {
        let mut out = Values::default();
        items.iter().for_each(|item| out.learn(item));
        out
    }

    /// Learns what an item says of the names that it declares.
    pub(crate) fn learn(&mut self, item: &Item) {
        self.partial.extend(applied(item).into_iter().map(|n| n.text.clone()));
        match item {
            Item::Let { name, value, .. } if !self.exist_for(value) => {
                self.partial.insert(name.text.clone());
            }
            Item::Given(bindings) => {
                for binding in bindings {
                    let is_positive = binding.constraints.iter().any(is_above_zero);
                    for (name, index) in &binding.names {
                        let text = name.text.clone();
                        if index.is_some() && binding.indices.is_none() {
                            self.families.insert(text, (is_positive, binding.natural));
                        } else if index.is_none() {
                            if binding.natural {
                                self.natural.insert(text.clone());
                            }
                            if is_positive {
                                self.positive.insert(text);
                            }
                        }
                    }
                }
            }
            Item::Assume { prop, .. } => self.suppose(prop),
            _ => {}
        }
    }

    /// Learns which variables a hypothesis puts above what is positive, or strictly above what is not negative.
    fn suppose(&mut self, prop: &Prop) {
        match &prop.kind {
            PropKind::And(list) => list.iter().for_each(|p| self.suppose(p)),
            PropKind::Compare(sides, relations) => {
                let pairs = sides.iter().zip(&sides[1..]).zip(relations);
                let mut above: Vec<(&Expr, &Expr, bool)> = pairs
                    .filter_map(|((a, b), relation)| match relation {
                        Relation::Less => Some((a, b, true)),
                        Relation::LessEqual => Some((a, b, false)),
                        Relation::Greater => Some((b, a, true)),
                        Relation::GreaterEqual => Some((b, a, false)),
                        Relation::Equal | Relation::NotEqual => None,
                    })
                    .collect();
                // A chain is read from its least member on.
                if relations.first().is_some_and(|r| matches!(r, Relation::Greater | Relation::GreaterEqual)) {
                    above.reverse();
                }
                for (low, high, is_strict) in above {
                    let form = self.form();
                    if let ExprKind::Name(name) = &high.kind
                        && (form.is_positive(low) || is_strict && form.is_not_negative(low))
                    {
                        self.positive.insert(name.clone());
                    }
                }
            }
            _ => {}
        }
    }

    fn form(&self) -> Form<'_> {
        Form { values: self, members: &[], index: Vec::new() }
    }

    /// Whether an expression has a value wherever the hypotheses hold.
    pub(crate) fn exist_for(&self, e: &Expr) -> bool {
        self.form().exists(e)
    }

    /// Whether the right side of a recurrence has a value by its form. `members` are the sequences that it defines, real numbers
    /// at every natural number; `index` and what sums in it bind are natural numbers.
    pub(crate) fn exist_in_recurrence(&self, e: &Expr, members: &[Name], index: Option<&Name>) -> bool {
        let index = index.into_iter().map(|name| name.text.as_str()).collect();
        Form { values: self, members, index }.exists(e)
    }
}

/// What is known of the names in an expression, within the equations of a recurrence or elsewhere.
struct Form<'a> {
    values: &'a Values,
    members: &'a [Name],
    /// Names that are natural numbers here.
    index: Vec<&'a str>,
}

impl<'a> Form<'a> {
    fn exists(&self, e: &'a Expr) -> bool {
        let own = match &e.kind {
            ExprKind::Number(_) | ExprKind::Negate(_) | ExprKind::Sum(_) => true,
            ExprKind::Name(name) => self.is_natural(e) || !self.values.partial.contains(name),
            ExprKind::Product(list) => list.iter().all(|(factor, a)| *factor == Factor::Times || self.is_not_zero(a)),
            ExprKind::Power(base, exponent) => match number(exponent) {
                Some((top, 1)) => top >= 0 || self.is_not_zero(base),
                Some((top, _)) if top > 0 => self.is_not_negative(base),
                _ => self.is_positive(base) || self.is_natural(exponent),
            },
            ExprKind::Apply(f, arguments) => match f.text.as_str() {
                "sqrt" | "cbrt" => arguments.iter().all(|a| self.is_not_negative(a)),
                "ln" => arguments.iter().all(|a| self.is_positive(a)),
                word if EVERYWHERE.contains(&word) => !self.values.partial.contains(word),
                word if self.members.iter().any(|u| u.text == word) => true,
                word => self.values.families.contains_key(word) && arguments.iter().all(|a| self.is_natural(a)),
            },
            ExprKind::SumOver(over, body) | ExprKind::ProductOver(over, body) => {
                let begins = number(&over.from).is_some_and(|(top, below)| below == 1 && (0..=1).contains(&top));
                let mut index = self.index.clone();
                index.push(&over.name.text);
                let inside = Form { index, ..*self };
                return begins && self.is_natural(&over.to) && inside.exists(body);
            }
            ExprKind::IntegralOver(..) | ExprKind::Derivative(..) | ExprKind::Matrix(_) => false,
        };
        let mut all = own;
        walk::parts(e, &mut |part| all = all && self.exists(part));
        all
    }

    fn is_not_zero(&self, e: &Expr) -> bool {
        match &e.kind {
            ExprKind::Number(_) => number(e).is_some_and(|(top, _)| top != 0),
            ExprKind::Negate(a) => self.is_not_zero(a),
            ExprKind::Product(list) => list.iter().all(|(_, a)| self.is_not_zero(a)),
            ExprKind::Power(base, _) => self.is_not_zero(base),
            _ => self.is_positive(e),
        }
    }

    fn is_positive(&self, e: &Expr) -> bool {
        match &e.kind {
            ExprKind::Number(_) => number(e).is_some_and(|(top, _)| top > 0),
            ExprKind::Name(name) => self.values.positive.contains(name),
            ExprKind::Sum(list) => {
                list.iter().all(|(sign, a)| *sign == Sign::Plus && self.is_not_negative(a))
                    && list.iter().any(|(_, a)| self.is_positive(a))
            }
            ExprKind::Product(list) => list.iter().all(|(_, a)| self.is_positive(a)),
            ExprKind::Power(base, _) => self.is_positive(base),
            ExprKind::Apply(f, arguments) => match f.text.as_str() {
                "exp" | "cosh" | "sech" => true,
                "sqrt" | "cbrt" | "arctan" => arguments.iter().all(|a| self.is_positive(a)),
                word => self.values.families.get(word).is_some_and(|known| known.0),
            },
            _ => false,
        }
    }

    fn is_not_negative(&self, e: &Expr) -> bool {
        match &e.kind {
            ExprKind::Number(_) => number(e).is_some_and(|(top, _)| top >= 0),
            ExprKind::Sum(list) => list.iter().all(|(sign, a)| *sign == Sign::Plus && self.is_not_negative(a)),
            ExprKind::Product(list) => list.iter().all(|(_, a)| self.is_not_negative(a)),
            ExprKind::Power(base, exponent) => {
                let is_square = number(exponent).is_some_and(|(top, below)| below == 1 && top % 2 == 0);
                is_square || self.is_not_negative(base)
            }
            ExprKind::Apply(f, _) if f.text == "abs" || f.text == "sqrt" => true,
            _ => self.is_natural(e) || self.is_positive(e),
        }
    }

    /// Whether an expression is a natural number by its form.
    fn is_natural(&self, e: &Expr) -> bool {
        match &e.kind {
            ExprKind::Number(_) => number(e).is_some_and(|(top, below)| below == 1 && top >= 0),
            ExprKind::Name(name) => self.index.contains(&name.as_str()) || self.values.natural.contains(name),
            ExprKind::Sum(list) => list.iter().all(|(sign, a)| *sign == Sign::Plus && self.is_natural(a)),
            ExprKind::Product(list) => list.iter().all(|(factor, a)| *factor == Factor::Times && self.is_natural(a)),
            ExprKind::Power(base, exponent) => self.is_natural(base) && self.is_natural(exponent),
            ExprKind::Apply(f, _) => self.values.families.get(&f.text).is_some_and(|known| known.1),
            _ => false,
        }
    }
}
