//! Orders of polynomials that squares of roots leave: by the signs of what is written, by those of factors, by differences and sums of
//! squares.
//!
//! Method: a sum whose summands have one sign has it too, before it is multiplied out. A product has the sign of its factors: where a
//! square is a factor, it is enough for a strict order that its base is not 0. A point of a circle, c² + s² = 1, has coordinates
//! between −1 and 1, which bound what is linear in them.

use super::comparison::single;
use super::facts::{is_settled, minus};
use super::letters::{product, summands_of, whole_power};
use super::products::Kind;
use super::{Fail, Prover};
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, expr, name, numeral};
use crate::refute::literal::literal;
use malachite::Rational;

impl Prover {
    /// Shows an order of polynomials, the cheapest way first.
    pub(super) fn by_signs_of_parts(&mut self, goal: &Prop) -> Result<Label, Fail> {
        self.attempt(|c| c.by_written_summands(goal))
            .or_else(|_| self.attempt(|c| c.by_signs_of_factors(goal)))
            .or_else(|_| self.with_half(|c| c.without_roots(goal)))
    }

    /// Shows an order by the signs of the summands as they are written.
    pub(super) fn by_written_summands(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let PropKind::Compare(sides, relations) = &goal.kind else { return Err(Fail::No("an order")) };
        let ([a, b], true) = (sides.as_slice(), relations[0].is_greater().is_some()) else {
            return Err(Fail::No("an order"));
        };
        let mut summands = Vec::new();
        summands_of(a, Sign::Plus, &mut summands);
        summands_of(b, Sign::Minus, &mut summands);
        let signed = |(sign, e)| if sign == Sign::Plus { e } else { expr(ExprKind::Negate(Box::new(e))) };
        let terms = summands.into_iter().map(|s| Term { facts: Vec::new(), factor: signed(s) }).collect();
        self.emit(Rule::Combination { times: None, terms }, goal.clone())
    }

    /// Shows an order from the signs of the factors of its difference.
    pub(super) fn by_signs_of_factors(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("factors");
        let Some((a, relation, b)) = goal.single() else { return Err(no()) };
        let strict = match relation {
            Relation::Less | Relation::Greater => true,
            Relation::LessEqual | Relation::GreaterEqual => false,
            _ => return Err(no()),
        };
        let reading = self.read(&minus(a, b), true).ok_or_else(no)?;
        let split = self.split_open(reading);
        // The sign of a factor alone is the goal itself.
        let is_split = split.factors.len() > 1 || split.factors.iter().any(|f| f.power > 1);
        let mut factors = vec![literal(&split.number)];
        for f in &split.factors {
            let e = self.letters.written(&f.poly);
            if f.power % 2 != 0 && !is_settled(f.signs) {
                let signs = if is_split { self.sign_in_full(&e) } else { f.signs };
                let is_shown = is_settled(signs) || f.power < 0 && self.is_divisor_settled(&e, signs);
                if !is_shown {
                    return Err(no());
                }
            } else if strict && !f.signs.within(Signs::NOT_ZERO) {
                self.nonzero(&e);
                let _ = self.attempt(|c| c.other_than_zero(&e));
            }
            factors.push(whole_power(e, f.power));
        }
        self.emit(
            Rule::Combination { times: None, terms: vec![Term { facts: Vec::new(), factor: product(factors) }] },
            goal.clone(),
        )
    }

    /// Shows that an expression is not 0, since a fact denies what follows if it is.
    fn other_than_zero(&mut self, e: &Expr) -> Result<Label, Fail> {
        let goal = compare(e.clone(), Relation::NotEqual, numeral(0));
        if self.signs_of(e).within(Signs::NOT_ZERO) {
            return self.combination(goal, Vec::new());
        }
        self.against_opposite(&goal, |c, _| c.by_denial(&goal, |c, equation| c.by_products(equation, 1)))
    }

    /// Whether a divisor, of which only these signs are seen, is shown to be positive, or negative where it is nowhere positive.
    fn is_divisor_settled(&mut self, e: &Expr, signs: Signs) -> bool {
        let negative = signs.within(Signs::of(Relation::LessEqual));
        let strict = if negative { Relation::Less } else { Relation::Greater };
        self.without_cases(&compare(e.clone(), strict, numeral(0))).is_ok()
    }

    /// The signs of an expression, after a search for them.
    pub(super) fn sign_in_full(&mut self, e: &Expr) -> Signs {
        let signs = self.signs_of(e);
        if is_settled(signs) {
            return signs;
        }
        let orders = [Relation::Greater, Relation::Less, Relation::GreaterEqual, Relation::LessEqual];
        let zero = numeral(0);
        for quick in [true, false] {
            for order in orders.into_iter().filter(|order| !signs.and(Signs::of(*order)).within(Signs::ZERO)) {
                let sign = compare(e.clone(), order, zero.clone());
                let shown = match quick {
                    true => self.quietly(&sign),
                    false => self.compared_in_full(&sign),
                };
                if shown.is_ok() {
                    return self.signs_of(e);
                }
            }
        }
        signs
    }

    /// Adds the facts that the coordinates of points on circles lie between −1 and 1, strictly where the other one is not 0.
    pub(super) fn bound_points_of_circles(&mut self) {
        for (label, fact) in self.facts() {
            let Some((x, y)) = point_of_circle(&fact) else { continue };
            for (x, y) in [(&x, &y), (&y, &x)] {
                for sign in [Sign::Plus, Sign::Minus] {
                    let (x, y) = (name(x), name(y));
                    let relation = match self.signs_of(&y).within(Signs::NOT_ZERO) {
                        true => Relation::Greater,
                        false => Relation::GreaterEqual,
                    };
                    // 2·(1 ± x) = (1 ± x)² + y² where x² + y² = 1.
                    let sum = expr(ExprKind::Sum(vec![(Sign::Plus, numeral(1)), (sign, x)]));
                    let half = literal(&(Rational::from(1) / Rational::from(2)));
                    let square = |e: &Expr| product(vec![half.clone(), whole_power(e.clone(), 2)]);
                    let minus = expr(ExprKind::Negate(Box::new(half.clone())));
                    let terms = vec![
                        Term { facts: Vec::new(), factor: square(&sum) },
                        Term { facts: Vec::new(), factor: square(&y) },
                        Term { facts: vec![label.clone()], factor: minus },
                    ];
                    let _ = self.combination(compare(sum, relation, numeral(0)), terms);
                }
            }
        }
    }

    /// Shows an order by the bounds of the coordinates of points on circles that it holds.
    pub(super) fn by_points_of_circles(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let (a, _, b) = single(goal)?;
        let is_met = |text: &str| super::limits::holds(a, text) || super::limits::holds(b, text);
        let points: Vec<(String, String)> = self.facts().iter().filter_map(|(_, fact)| point_of_circle(fact)).collect();
        if !points.iter().any(|(x, y)| is_met(x) || is_met(y)) {
            return Err(Fail::No("a coordinate of a point on a circle"));
        }
        self.bound_points_of_circles();
        self.without_cases(goal)
    }

    /// The equation by which a name squared is written by another one, the coordinates of a point on a circle; of two coordinates one.
    pub(super) fn square_on_circle(&mut self, e: &Expr) -> Option<(Label, Prop)> {
        let ExprKind::Name(text) = &e.kind else { return None };
        let mut facts = self.facts().into_iter();
        let (label, fact) = facts.find(|(_, fact)| point_of_circle(fact).is_some_and(|p| p.0 == *text))?;
        let fact = (*fact).clone();
        self.known_of(&label, &fact).filter(|k| k.kind == Kind::Zero).map(|_| (label, fact))
    }
}

/// The two names of an equation x^2 + y^2 = 1.
fn point_of_circle(p: &Prop) -> Option<(String, String)> {
    let Some((Expr { kind: ExprKind::Sum(list), .. }, Relation::Equal, one)) = p.single() else {
        return None;
    };
    let [(Sign::Plus, x), (Sign::Plus, y)] = list.as_slice() else { return None };
    let base = |e: &Expr| match &e.kind {
        ExprKind::Power(base, k) if super::letters::natural(k) == Some(2) => match &base.kind {
            ExprKind::Name(name) => Some(name.clone()),
            _ => None,
        },
        _ => None,
    };
    Some((base(x)?, base(y)?)).filter(|_| super::letters::natural(one) == Some(1))
}
