//! Whether expressions and propositions have values, from the facts that a step cites.
//!
//! Contract: [`Checker::defined`] returns only if the expression has a value at every point that the facts allow, by
//! the conditions of [`crate::claim::definedness`]; where that allows a base that may be 0, or differentiation at the
//! edge of what has a value, the kernel asks for more.

use super::fraction::Fraction;
use super::known::{Known, Range};
use super::order::Signs;
use super::statement::{constraints, domain, name};
use super::term::Atom;
use super::tree::parts;
use super::{Checker, Reason, Refusal, rejected};
use crate::claim::definedness::{Exponent, Need, exponent, from_one, is_whole, needs, numerals};
use crate::claim::syntax::*;
use std::collections::BTreeSet;

impl Checker {
    /// The names in scope that stand for natural numbers.
    pub(super) fn natural_names(&self) -> BTreeSet<String> {
        let families = self.statement.bindings.iter().filter(|b| b.natural);
        let families = families.flat_map(|b| b.names.iter().filter(|n| n.1.is_some()).map(|n| n.0.text.clone()));
        let mut names: BTreeSet<String> = families.collect();
        for variable in &self.scope {
            // The innermost declaration of a name counts.
            if variable.natural {
                names.insert(variable.name.clone())
            } else {
                names.remove(&variable.name)
            };
        }
        names
    }

    /// A value for a natural number is whole by its form: `x^k` with `k = n*x/x` would be another power, which needs a
    /// positive base.
    pub(super) fn whole_by_form(&mut self, e: &Expr) -> Result<(), Refusal> {
        let natural = self.natural_names();
        if is_whole(e, &|name| natural.contains(name)) { Ok(()) } else { rejected(Reason::NotWhole) }
    }

    pub(super) fn is(&mut self, e: &Expr, signs: Signs, known: &Known) -> Result<bool, Refusal> {
        Ok(self.signs_of_expr(e, known)?.within(signs))
    }

    pub(super) fn need(&mut self, e: &Expr, signs: Signs, known: &Known) -> Result<(), Refusal> {
        if self.is(e, signs, known)? {
            return Ok(());
        }
        rejected(Reason::NoValue { part: e.clone(), signs })
    }

    /// Whether an expression has a value that is a number. To read it shows that every name in it is declared: a name
    /// that is not could become that of something else later.
    pub(super) fn number_defined(&mut self, e: &Expr, known: &mut Known) -> Result<(), Refusal> {
        self.defined(e, known)?;
        self.fraction(e).map(|_| ())
    }

    /// Whether an expression has a value.
    pub(super) fn defined(&mut self, e: &Expr, known: &mut Known) -> Result<(), Refusal> {
        match &e.kind {
            ExprKind::SumOver(index, body) | ExprKind::ProductOver(index, body) => {
                for end in [&index.from, &index.to] {
                    self.defined(end, known)?;
                    self.whole_by_form(end)?;
                }
                let (from, to) = (self.fraction(&index.from)?, self.fraction(&index.to)?);
                let room = Fraction::sum(&[to.clone(), Fraction::integer(1), from.negated()], &self.work)?;
                // An index is a natural number.
                self.need(&index.from, Signs::NOT_NEGATIVE, known)?;
                if !self.signs_of(&room, known)?.within(Signs::NOT_NEGATIVE) {
                    return rejected(Reason::Range(e.clone()));
                }
                return self
                    .at_index(&index.name.text, &from, &to, known, |checker, known| checker.defined(body, known));
            }
            ExprKind::IntegralOver(variable, body) => {
                self.defined(&variable.from, known)?;
                self.defined(&variable.to, known)?;
                return self.between(variable, known, |checker, known| checker.defined(body, known));
            }
            ExprKind::Derivative(body, _) => self.defined(body, known)?,
            ExprKind::Apply(f, arguments) if self.is_member(&f.text) => {
                for argument in arguments {
                    self.defined(argument, known)?;
                    self.whole_by_form(argument)?;
                    self.need(argument, Signs::NOT_NEGATIVE, known)?;
                }
                if let (Some((from, to)), Some(argument)) =
                    (self.family(&f.text).and_then(|b| b.indices.clone()), arguments.first())
                {
                    let index = self.fraction(argument)?;
                    let (from, to) = (self.fraction(&from)?, self.fraction(&to)?);
                    for difference in [index.minus(&from, &self.work)?, to.minus(&index, &self.work)?] {
                        if !self.signs_of(&difference, known)?.within(Signs::NOT_NEGATIVE) {
                            return rejected(Reason::Range(e.clone()));
                        }
                    }
                }
            }
            _ => {
                for part in parts(e) {
                    self.defined(part, known)?;
                }
            }
        }
        let natural = self.natural_names();
        for need in needs(e, &|name| natural.contains(name))? {
            match need {
                Need::NotZero(e) => self.need(&e, Signs::NOT_ZERO, known)?,
                Need::Positive(e) => self.need(&e, Signs::POSITIVE, known)?,
                Need::NotNegative(e) => self.need(&e, Signs::NOT_NEGATIVE, known)?,
                Need::NotZeroOrNatural(base, exponent) => {
                    if !self.is(&exponent, Signs::NOT_NEGATIVE, known)? {
                        self.need(&base, Signs::NOT_ZERO, known)?;
                    }
                }
                // Seen above.
                Need::Range(..) => {}
                Need::Differentiable(body, by, _) => self.smooth(&body, &by.text, known)?,
            }
        }
        Ok(())
    }

    /// Runs something where a name is a natural number of a range, as the index of a sum.
    pub(super) fn at_index(
        &mut self,
        name: &str,
        from: &Fraction,
        to: &Fraction,
        known: &mut Known,
        run: impl FnOnce(&mut Checker, &mut Known) -> Result<(), Refusal>,
    ) -> Result<(), Refusal> {
        let before = known.mark();
        let result = self.opened(|checker, own| {
            checker.under(name, Atom::Bound(own), |checker| {
                let index = checker.intern(Atom::Bound(own));
                known.ranges.push(Range { index, from: checker.whole(from)?, to: checker.whole(to)? });
                let place = Fraction::atom(index);
                for difference in [place.minus(from, &checker.work)?, to.minus(&place, &checker.work)?] {
                    checker.learn_signs(&difference, Signs::NOT_NEGATIVE, known)?;
                }
                checker.learn_for_all(true, &Atom::Bound(own), known)?;
                run(checker, known)
            })
        });
        known.back_to(before);
        result
    }

    /// Whether an expression that has a value can be differentiated by a variable, however often: bases of powers
    /// that are no numerals are not 0, roots are of positive numbers and arcs of what is less than 1 from 0, so that the same holds nearby.
    pub(super) fn smooth(&mut self, e: &Expr, by: &str, known: &mut Known) -> Result<(), Refusal> {
        let natural = self.natural_names();
        let is_natural = |name: &str| natural.contains(name);
        match &e.kind {
            ExprKind::Power(base, power) => match exponent(power, &is_natural)? {
                Exponent::Whole if numerals(power).is_ok_and(|known| known.is_some()) => {}
                Exponent::Whole => self.need(base, Signs::NOT_ZERO, known)?,
                Exponent::Root | Exponent::Real => self.need(base, Signs::POSITIVE, known)?,
            },
            ExprKind::Apply(f, arguments) if matches!(f.text.as_str(), "sqrt" | "cbrt") => {
                for argument in arguments {
                    self.need(argument, Signs::POSITIVE, known)?;
                }
            }
            ExprKind::Apply(f, arguments) if matches!(f.text.as_str(), "arcsin" | "arccos") => {
                for distance in arguments.iter().flat_map(from_one) {
                    self.need(&distance, Signs::POSITIVE, known)?;
                }
            }
            ExprKind::SumOver(index, _) | ExprKind::ProductOver(index, _) if index.name.text == by => {
                return rejected(Reason::NotAReal(by.to_string()));
            }
            // A sum whose members can be differentiated, also those that are 0 by reading: its ends are whole. A product may not
            // mention the variable.
            ExprKind::SumOver(index, body) | ExprKind::ProductOver(index, body) => {
                let mut names = BTreeSet::new();
                super::names::names_in(e, &mut names);
                if !names.contains(by) {
                    return Ok(());
                }
                if matches!(e.kind, ExprKind::ProductOver(..)) {
                    return rejected(Reason::DerivativeOfMember);
                }
                let (from, to) = (self.fraction(&index.from)?, self.fraction(&index.to)?);
                return self
                    .at_index(&index.name.text, &from, &to, known, |checker, known| checker.smooth(body, by, known));
            }
            ExprKind::IntegralOver(variable, body) => return self.smooth_integral(variable, body, by, known),
            _ => {}
        }
        for part in parts(e) {
            self.smooth(part, by, known)?;
        }
        Ok(())
    }

    /// Puts a variable into the cited facts for all values of one variable of its kind whose domain it satisfies: a natural index, or
    /// a real variable that is bound.
    pub(super) fn learn_for_all(&mut self, natural: bool, index: &Atom, known: &mut Known) -> Result<(), Refusal> {
        for (binding, body, place) in known.for_all.clone() {
            let Some((variable, None)) = binding.names.first().filter(|_| binding.natural == natural) else { continue };
            self.scope.push(super::Variable { name: variable.text.clone(), natural, atom: index.clone() });
            known.comes_from(Some(place));
            let result = self.learn_at(&binding, &variable.text, &body, known);
            known.comes_from(None);
            self.scope.pop();
            result?;
        }
        Ok(())
    }

    /// Takes in what a fact for all values says where its variable is the index, if the index lies in its domain. A fact
    /// for all values within it is left out: it would be read later, where the variable is something else.
    fn learn_at(&mut self, binding: &Binding, variable: &str, body: &Prop, known: &mut Known) -> Result<(), Refusal> {
        for fact in constraints(binding, &name(variable)) {
            let (a, relation, b) = super::tree::single(&fact)?;
            let difference = self.fraction(a)?.minus(&self.fraction(b)?, &self.work)?;
            if !self.signs_of(&difference, known)?.within(Signs::of(relation)) {
                return Ok(());
            }
        }
        let before = known.mark();
        let result = self.learn(body, known);
        known.forget_for_all(before);
        result
    }

    /// Whether every expression of a proposition has a value; what stands behind `=>` may suppose what stands before
    /// it, and what stands under a quantifier the domain.
    pub(super) fn prop_defined(&mut self, p: &Prop, known: &mut Known) -> Result<(), Refusal> {
        match &p.kind {
            PropKind::Compare(sides, relations) => {
                let mut sizes = BTreeSet::new();
                for e in sides {
                    self.defined(e, known)?;
                    sizes.insert(match self.value(e)? {
                        super::term::Value::Scalar(_) => Vec::new(),
                        super::term::Value::Matrix(rows) => rows.iter().map(Vec::len).collect(),
                    });
                }
                // Matrices are compared with matrices of their size, and have no order.
                let ordered = relations.iter().any(|r| !matches!(r, Relation::Equal | Relation::NotEqual));
                if sizes.len() != 1 || (ordered && !sizes.contains(&Vec::new())) {
                    return rejected(Reason::MatrixSizes);
                }
                Ok(())
            }
            PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => {
                list.iter().try_for_each(|p| self.prop_defined(p, known))
            }
            PropKind::Not(inner) => self.prop_defined(inner, known),
            PropKind::Implies(a, b) => {
                self.prop_defined(a, known)?;
                let before = known.mark();
                let result = self.learn(a, known).and_then(|()| self.prop_defined(b, known));
                known.back_to(before);
                result
            }
            PropKind::Exists(bindings, body) | PropKind::ForAll(bindings, body) => {
                self.within(bindings, known, |checker, known| checker.prop_defined(body, known))
            }
            PropKind::Extremum(e) => {
                for value in e.at.iter().map(|a| &a.1).chain([&e.value]) {
                    self.number_defined(value, known)?;
                }
                self.within(&e.over, known, |checker, known| checker.number_defined(&e.of, known))
            }
            PropKind::Limit(_) | PropKind::WrittenLimit(_) => rejected(Reason::LimitSupposed),
        }
    }

    /// Whether every expression of a proposition has a value by what is known; a limit is passed on. What was tried
    /// leaves no trace.
    pub(super) fn has_value(&mut self, p: &Prop, known: &mut Known) -> Result<bool, Refusal> {
        let (scope, binders, before) = (self.scope.len(), self.binders, known.mark());
        let result = self.prop_defined(p, known);
        self.scope.truncate(scope);
        self.binders = binders;
        known.back_to(before);
        match result {
            Ok(()) => Ok(true),
            Err(Refusal::Rejected(_)) => Ok(false),
            Err(limit) => Err(limit),
        }
    }

    /// Runs something where the names of bindings are declared and their domains known, and what cited facts say for all numbers of
    /// such a domain.
    pub(super) fn within<T>(
        &mut self,
        bindings: &[Binding],
        known: &mut Known,
        run: impl FnOnce(&mut Checker, &mut Known) -> Result<T, Refusal>,
    ) -> Result<T, Refusal> {
        let (scope, before) = (self.scope.len(), known.mark());
        let enter = |checker: &mut Checker, known: &mut Known| {
            for binding in bindings {
                if binding.names.iter().any(|n| n.1.is_some()) {
                    return rejected(Reason::FamilyInBlock);
                }
                checker.declare_binding(binding)?;
                for fact in domain(binding) {
                    let (a, _, b) = super::tree::single(&fact)?;
                    checker.defined(a, known)?;
                    checker.defined(b, known)?;
                    checker.learn(&fact, known)?;
                }
                if let ([(name, _)], false) = (binding.names.as_slice(), binding.natural) {
                    checker.learn_for_all(false, &Atom::Variable(name.text.clone()), known)?;
                }
            }
            Ok(())
        };
        let result = enter(self, known).and_then(|()| run(self, known));
        self.scope.truncate(scope);
        known.back_to(before);
        result
    }
}
