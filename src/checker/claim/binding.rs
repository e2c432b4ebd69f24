//! Declarations of variables and families: `e in [0, 1]`, `n natural >= 1`, `mu(k) > 0`.

use super::syntax::{Expr, Name, Relation, Span};
use carom_unit::Unit;

/// `m1, m2 > 0`, `e in [0, 1]`, `n natural >= 1`, `mu(k) > 0 for k in 0..n + 1`.
#[derive(Clone, Debug)]
pub struct Binding {
    /// The names with, for a family, its index name: `mu(k)`.
    pub names: Vec<(Name, Option<Name>)>,
    /// Whether the values are naturals (0, 1, 2, …) or reals.
    pub natural: bool,
    /// Constraints on each name; all of them apply.
    pub constraints: Vec<Constraint>,
    /// The indices for which a family is defined; `None` means every natural number.
    pub indices: Option<(Expr, Expr)>,
    /// `in kg`: the unit in which the values are measured. It is no part of the mathematical statement.
    pub unit: Option<Unit>,
    /// Where it stands.
    pub span: Span,
}

impl Binding {
    /// A declaration without a range of indices and without a unit.
    #[must_use]
    pub fn new(names: Vec<(Name, Option<Name>)>, natural: bool, constraints: Vec<Constraint>, span: Span) -> Binding {
        Binding { names, natural, constraints, indices: None, unit: None, span }
    }

    /// That of one variable, where its name stands.
    #[must_use]
    pub fn of(name: Name, natural: bool, constraints: Vec<Constraint>) -> Binding {
        let span = name.span;
        Binding::new(vec![(name, None)], natural, constraints, span)
    }
}

/// A constraint of a binding.
#[derive(Clone, Debug)]
pub enum Constraint {
    /// `> 0`, `>= 1`, `!= 0`, `<= b`
    Relation(Relation, Expr),
    /// `in [a, b]`, `in (a, b]`; the flags say whether the end belongs to it.
    Interval {
        /// Left end.
        from: Expr,
        /// Whether the left end is included.
        from_closed: bool,
        /// Right end.
        to: Expr,
        /// Whether the right end is included.
        to_closed: bool,
    },
    /// `in a..b`: naturals from a to b.
    Range(Expr, Expr),
}
