//! Comparisons: by signs, by linear programs over products of facts, from other relations.

use super::facts::{is_settled, minus, sign_of};
use super::letters::{natural, product, whole_power};
use super::products::{Kind, Known, combination, contradiction};
use super::{Fail, Prover};
use crate::algebra::Polynomial;
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, numeral};
use crate::refute::literal::literal;
use malachite::Rational;
use malachite::base::num::basic::traits::One;
use std::collections::BTreeSet;

/// The difference of a comparison's sides as poly·rest.
pub(super) struct OpenFactors {
    /// The product of the factors whose signs are open.
    pub(super) poly: Polynomial,
    /// The number of the rest.
    pub(super) number: Rational,
    /// The factors of the rest, whose sign is known: the number and the others.
    pub(super) rest: Vec<Expr>,
    /// Whether the goal says that the polynomial is negative, or not positive.
    pub(super) flip: bool,
}

/// The sides of a single comparison and their relation.
pub(super) fn single(goal: &Prop) -> Result<(&Expr, Relation, &Expr), Fail> {
    goal.single().ok_or(Fail::No("a single comparison is needed"))
}

impl Prover {
    /// a ≠ b from a > b or a < b.
    pub(super) fn by_strict_order(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let (a, _, b) = single(goal)?;
        let stronger = [Relation::Greater, Relation::Less].map(|side| compare(a.clone(), side, b.clone()));
        let shown = self.quietly(&stronger[0]).or_else(|_| self.quietly(&stronger[1]))?;
        self.logic(&[&shown], goal)
    }

    /// Any comparison from an equation that is denied and holds.
    pub(super) fn by_denied_equation(&mut self, goal: &Prop) -> Result<Label, Fail> {
        self.by_denial(goal, |c, equation| {
            let shown = c.combination(equation.clone(), Vec::new());
            shown.or_else(|_| c.with_solved_equations(|c| c.combination(equation.clone(), Vec::new())))
        })
    }

    /// A comparison from inequalities between weighted means of the powers in it.
    pub(super) fn by_means(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let names = self.names.clone();
        let shown = self.attempt(|c| {
            c.means(goal)?;
            c.quietly(goal)
        });
        if shown.is_err() {
            // No step is left that holds one of its names.
            self.names = names;
        }
        shown
    }

    /// Runs a part of the search within inductions only, or outside of them.
    pub(super) fn within_inductions(
        &mut self,
        within: bool,
        run: impl FnOnce(&mut Self) -> Result<Label, Fail>,
    ) -> Result<Label, Fail> {
        if (self.inductions > 0) == within { run(self) } else { Err(Fail::No("an induction")) }
    }

    /// The parts of a comparison's difference whose signs are open, as text.
    pub(super) fn open_parts(&mut self, goal: &Prop) -> Vec<String> {
        let Ok((a, _, b)) = single(goal) else { return Vec::new() };
        let difference = minus(a, b);
        let Some(reading) = self.read(&difference, true) else { return Vec::new() };
        let open = reading.factors.iter().filter(|f| !is_settled(f.signs));
        open.map(|f| crate::claim::print::expr(&self.letters.written(&f.poly))).collect()
    }

    /// a < b from a <= b and a != b: 2*sqrt(x*y) < x + y for x != y, since the square of the difference of the roots is 0 at x = y alone.
    pub(super) fn by_weak_order(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let (a, relation, b) = single(goal)?;
        let weak = match relation {
            Relation::Less => Relation::LessEqual,
            Relation::Greater => Relation::GreaterEqual,
            _ => return Err(Fail::No("a strict order")),
        };
        // Only a denied equation tells the two apart.
        let is_denied = |p: &Prop| matches!(&p.kind, PropKind::Compare(_, r) if r.contains(&Relation::NotEqual));
        if !self.checker.facts().any(|(_, p)| is_denied(p)) {
            return Err(Fail::No("a denied equation"));
        }
        let order = self.show(&compare(a.clone(), weak, b.clone()))?;
        let apart = self.show(&compare(a.clone(), Relation::NotEqual, b.clone()))?;
        self.logic(&[&order, &apart], goal).or_else(|_| self.combination(goal.clone(), Vec::new()))
    }

    /// A comparison that the kernel sees, once its letters are known.
    pub(super) fn at_once(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let (a, relation, b) = single(goal)?;
        self.define(a);
        self.define(b);
        if let Ok(label) = self.combination(goal.clone(), Vec::new()) {
            return Ok(label);
        }
        self.enrich(&[a, b]);
        self.note_squares(a);
        self.note_squares(b);
        if self.instantiate(&[a, b]) {
            self.enrich(&[a, b]);
        }
        match self.combination(goal.clone(), Vec::new()) {
            Err(fail) if fail.limit().is_none() => {}
            other => return other,
        }
        if relation != Relation::Equal {
            return Err(Fail::No("an equation"));
        }
        self.plainly(Rule::Power, goal).or_else(|_| self.emit(Rule::Power, goal.clone()))
    }

    /// Runs a part of the search with variables written by others, if there is an equation that was not used so yet.
    pub(super) fn with_solved_equations<T>(
        &mut self,
        run: impl FnOnce(&mut Self) -> Result<T, Fail>,
    ) -> Result<T, Fail> {
        self.attempt(|c| {
            let before = c.equations.len();
            c.solve_equations();
            if c.equations.len() == before { Err(Fail::No("an equation to solve")) } else { run(c) }
        })
    }

    /// An equation from its two inequalities.
    pub(super) fn by_both_orders(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let (a, _, b) = single(goal)?;
        let splits = self.splits;
        let halves = [Relation::LessEqual, Relation::GreaterEqual].map(|r| compare(a.clone(), r, b.clone()));
        let both = self.attempt(|c| {
            c.splits = 8;
            let x = c.show(&halves[0])?;
            let y = c.show(&halves[1])?;
            c.logic(&[&x, &y], goal)
        });
        if both.is_ok() {
            self.splits = splits;
        }
        both
    }

    /// Proves a comparison of quotients with exponentials, logarithms or roots, multiplied by its divisors.
    pub(super) fn without_divisors(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let (a, relation, b) = single(goal)?;
        let no = || Fail::No("a divisor of known sign");
        if self.splits > 0 || self.inductions > 0 || self.slopes_open > 0 {
            return Err(no());
        }
        let reading = self.read(&minus(a, b), true).ok_or_else(no)?;
        let divides = reading.factors.iter().any(|f| f.power < 0);
        let open = super::squares::Open::of(self, &reading).filter(|_| divides).ok_or_else(no)?;
        let own = super::squares::own_relation(open.signs, relation).ok_or_else(no)?;
        let whole = self.letters.written(&open.poly);
        if !super::slopes::has_function(&whole) {
            return Err(no());
        }
        let shown = self.without_cases(&compare(whole, own, numeral(0)))?;
        self.combination(goal.clone(), vec![Term { facts: vec![shown], factor: product(open.rest) }])
    }

    /// Proves a comparison that contains roots.
    pub(super) fn by_roots(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let (a, relation, b) = single(goal)?;
        if relation == Relation::NotEqual || self.roots_in(&minus(a, b)).is_empty() {
            return Err(Fail::No("a root"));
        }
        let splits = std::mem::replace(&mut self.splits, 8);
        let shown = self.attempt(|c| c.by_squares(goal)).or_else(|_| self.attempt(|c| c.by_radicals(goal)));
        self.splits = splits;
        shown.or_else(|_| self.attempt(|c| c.by_powers_of_sides(goal))).or_else(|_| self.by_roots_in_full(goal))
    }

    /// Whether nothing in a proposition depends on a variable: arithmetic decides it.
    pub(super) fn speaks_of_numbers(&self, p: &Prop) -> bool {
        let mut names = BTreeSet::new();
        crate::kernel::names::names_in_prop(p, &mut names);
        self.name_no_variable(&names)
    }

    /// The same of an expression.
    pub(super) fn is_of_numbers(&self, e: &Expr) -> bool {
        let mut names = BTreeSet::new();
        crate::kernel::names::names_in(e, &mut names);
        self.name_no_variable(&names)
    }

    fn name_no_variable(&self, names: &BTreeSet<String>) -> bool {
        let sequences = &self.checker.statement().sequences;
        names.iter().all(|n| !self.is_a_name(n) || sequences.iter().any(|s| s.name == *n))
    }

    /// Records the bases of even powers as they are written, because multiplying out hides what was squared.
    pub(crate) fn note_squares(&mut self, e: &Expr) {
        match &e.kind {
            ExprKind::Negate(a) => self.note_squares(a),
            ExprKind::Sum(list) => list.iter().for_each(|(_, e)| self.note_squares(e)),
            ExprKind::Product(list) => list.iter().for_each(|(_, e)| self.note_squares(e)),
            ExprKind::Power(base, exponent) => {
                self.note_squares(base);
                if natural(exponent).is_some_and(|k| k % 2 == 0)
                    && matches!(base.kind, ExprKind::Sum(_))
                    && let Some(reading) = self.read(base, false)
                {
                    for f in reading.factors {
                        if !self.squares_written.contains(&f.poly) && self.squares_written.len() < 12 {
                            self.squares_written.push(f.poly);
                        }
                    }
                }
            }
            _ => {}
        }
    }

    pub(super) fn terms(columns: &[Known], weights: &[(usize, Rational)], times: &[Expr], negative: bool) -> Vec<Term> {
        let term = |(place, weight): &(usize, Rational)| {
            let column = columns.get(*place)?;
            let weight = if negative { -weight } else { weight.clone() };
            let mut factors = Vec::new();
            let plain = column.factors.len() + times.len() > 0;
            if weight != Rational::ONE || !plain {
                factors.push(literal(&weight));
            }
            factors.extend(times.iter().chain(&column.factors).filter(|e| !is_one(e)).cloned());
            Some(Term { facts: column.facts.clone(), factor: product(factors) })
        };
        weights.iter().filter_map(term).collect()
    }

    /// The factors of a comparison's difference whose signs are open, multiplied; where `level` is more than 0, of its polynomials
    /// written as products.
    pub(super) fn open_factors(&mut self, goal: &Prop, level: usize) -> Result<OpenFactors, Fail> {
        let PropKind::Compare(sides, relations) = &goal.kind else { return Err(Fail::No("a comparison is needed")) };
        let (a, b, relation) = (&sides[0], &sides[1], relations[0]);
        let mut reading = self.read(&minus(a, b), true).ok_or(Fail::No("a difference"))?;
        if level > 0 {
            reading = self.split_open(reading);
        }
        // a − b = rest·poly, where the sign of rest is known.
        let mut poly = Polynomial::one();
        let mut signs = sign_of(&reading.number);
        let mut rest = vec![literal(&reading.number)];
        let weak = matches!(relation, Relation::GreaterEqual | Relation::LessEqual);
        for f in &reading.factors {
            let e = self.letters.written(&f.poly);
            let own = f.signs.power(f.power);
            let settled = match relation {
                Relation::Equal => f.power < 0 || f.signs.within(Signs::NOT_ZERO),
                Relation::NotEqual => f.signs.within(Signs::NOT_ZERO),
                _ => is_settled(own) || (weak && own.within(Signs::NOT_NEGATIVE)),
            };
            if settled {
                signs = signs.times(own);
                rest.push(whole_power(e, f.power));
            } else if f.power > 0 {
                let power = u32::try_from(f.power).map_err(|_| Fail::No("an exponent"))?;
                poly = poly
                    .try_mul(&f.poly.pow(power).map_err(|_| Fail::No("a power"))?)
                    .map_err(|_| Fail::No("a product"))?;
            } else {
                // p^-k = p·p^(-k-1), where one of the exponents is even.
                poly = poly.try_mul(&f.poly).map_err(|_| Fail::No("a product"))?;
                rest.push(whole_power(e, f.power - 1));
            }
        }
        let up = relation == Relation::Equal || relation.is_greater().ok_or(Fail::No("a sign"))?;
        let flip = relation != Relation::Equal && signs.within(Signs::NOT_NEGATIVE) != up;
        Ok(OpenFactors { poly, number: reading.number, rest, flip })
    }

    /// Proves the goal as a sum of products of facts.
    pub(crate) fn by_products(&mut self, goal: &Prop, level: usize) -> Result<Label, Fail> {
        let PropKind::Compare(_, relations) = &goal.kind else { return Err(Fail::No("a comparison is needed")) };
        let relation = relations[0];
        let OpenFactors { poly, rest, flip, .. } = self.open_factors(goal, level)?;
        if poly.term_count() > 120 {
            return Err(Fail::No("a small polynomial"));
        }
        let target = if flip { poly.neg() } else { poly.clone() };
        let mut columns = self.columns(std::slice::from_ref(&poly), level);
        if relation == Relation::Equal {
            columns.retain(|k| k.kind == Kind::Zero);
            if let Ok(label) = self.by_cofactors(goal, &poly, &columns, &rest) {
                return Ok(label);
            }
        }
        let strict = matches!(relation, Relation::Greater | Relation::Less);
        self.spend(&columns)?;
        let weights = combination(&target, &columns, strict).ok_or(Fail::No("a combination"))?;
        let terms = Self::terms(&columns, &weights, &rest, flip);
        self.combination(goal.clone(), terms)
    }

    /// Proves a linear goal by the signs of its factors, or as a sum of linear facts: one small linear program.
    pub(super) fn by_linear_facts(&mut self, goal: &Prop) -> Result<Label, Fail> {
        if let Ok(label) = self.combination(goal.clone(), Vec::new()) {
            return Ok(label);
        }
        let PropKind::Compare(_, relations) = &goal.kind else { return Err(Fail::No("a comparison is needed")) };
        let strict = matches!(relations[0], Relation::Greater | Relation::Less);
        let OpenFactors { poly, rest, flip, .. } = self.open_factors(goal, 0)?;
        let target = if flip { poly.neg() } else { poly.clone() };
        let mut columns = self.all_known(std::slice::from_ref(&poly));
        columns.push(Known::one());
        columns.retain(|k| k.poly.degree() <= 1);
        let weights = combination(&target, &columns, strict).ok_or(Fail::No("a combination"))?;
        self.combination(goal.clone(), Self::terms(&columns, &weights, &rest, flip))
    }

    /// A contradiction among the facts and the opposite of the goal.
    pub(crate) fn by_contradiction(&mut self, goal: &Prop, level: usize) -> Result<Label, Fail> {
        self.against_opposite(goal, |c, _| {
            if level > 0 {
                c.solve_equations();
            }
            c.absurd(level, goal, Some(goal))
        })
    }

    /// Proves any goal from facts that contradict each other.
    pub(crate) fn absurd(&mut self, level: usize, goal: &Prop, about: Option<&Prop>) -> Result<Label, Fail> {
        let mut wanted = Vec::new();
        if let Some(Prop { kind: PropKind::Compare(sides, _), .. }) = about
            && let Some(reading) = self.read(&minus(&sides[0], &sides[1]), false)
        {
            let parts = reading.factors.iter().filter(|f| f.power > 0 && f.poly.term_count() < 40);
            wanted = parts.map(|f| f.poly.clone()).collect();
        }
        let columns = self.columns(&wanted, level);
        self.spend(&columns)?;
        let weights = contradiction(&columns).ok_or(Fail::No("a contradiction"))?;
        let terms = Self::terms(&columns, &weights, &[], false);
        let shown = self.combination(compare(numeral(0), Relation::Greater, numeral(0)), terms)?;
        self.logic(&[&shown], goal)
    }
}

fn is_one(e: &Expr) -> bool {
    matches!(&e.kind, ExprKind::Number(text) if text == "1")
}
