//! A difference that is concave between two places, and not negative at both.
//!
//! Method (Jordan's inequality is the textbook's case): let F(p), F(q) >= 0 and F″ <= 0 between p and q, and p <= x <= q. Where
//! F′(x) >= 0, F′ is not negative before x, so that F rises from p to x. Where F′(x) < 0, it is negative behind x, and F falls
//! from x to q.

use super::facts::minus;
use super::slopes::{has_function, put_in};
use super::{Fail, Prover, implies};
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::kernel::statement::{compare, expr, name, numeral, prop};

/// What is known of one side of x.
struct Side<'a> {
    /// The place at which F is known.
    place: &'a Expr,
    /// Whether it lies before x.
    is_before: bool,
    /// The sign of F there.
    known: Label,
    /// Whether F is positive there.
    is_positive: bool,
}

impl Prover {
    /// A comparison a relation b by concavity in one variable.
    pub(super) fn by_concavity(&mut self, goal: &Prop, a: &Expr, relation: Relation, b: &Expr) -> Result<Label, Fail> {
        let no = || Fail::No("a function that is concave between two places");
        if self.splits > 2 || self.slopes_open > 0 || !(has_function(a) || has_function(b)) {
            return Err(no());
        }
        let difference = if relation.is_greater().ok_or_else(no)? { minus(a, b) } else { minus(b, a) };
        let strict = matches!(relation, Relation::Greater | Relation::Less);
        for x in self.reals_in(&difference) {
            let places = self.places(&x);
            for p in &places {
                for q in places.iter().filter(|q| *q != p) {
                    let done = self.attempt(|c| c.concave_between(goal, &difference, &x, [p, q], strict));
                    if done.is_ok() {
                        return done;
                    }
                }
            }
        }
        Err(no())
    }

    fn concave_between(
        &mut self,
        goal: &Prop,
        difference: &Expr,
        x: &str,
        [p, q]: [&Expr; 2],
        strict: bool,
    ) -> Result<Label, Fail> {
        let no = || Fail::No("a sign at a place");
        let variable = name(x);
        let t = self.fresh("t");
        let f = put_in(difference, x, &name(&t))?;
        let mut sides = Vec::new();
        for (place, is_before) in [(p, true), (q, false)] {
            let value = put_in(&f, &t, place)?;
            let at = |relation: Relation| compare(value.clone(), relation, numeral(0));
            let positive = self.by_arithmetic(&at(Relation::Greater));
            let (known, is_positive) = match positive {
                Ok(label) => (label, true),
                Err(_) => (self.by_arithmetic(&at(Relation::GreaterEqual))?, false),
            };
            let order = match (is_before, strict && !is_positive) {
                (true, true) => Relation::Greater,
                (true, false) => Relation::GreaterEqual,
                (false, true) => Relation::Less,
                (false, false) => Relation::LessEqual,
            };
            self.by_linear_facts(&compare(variable.clone(), order, place.clone())).map_err(|_| no())?;
            sides.push(Side { place, is_before, known, is_positive });
        }
        let here = self.simplified(&derivative(difference, x)).ok_or_else(no)?;
        let slope = put_in(&here, x, &name(&t))?;
        let mut from = Vec::new();
        for (side, sign) in sides.iter().zip([Relation::GreaterEqual, Relation::Less]) {
            let case = compare(here.clone(), sign, numeral(0));
            from.push(self.block(&implies(&case, goal), |c, _| {
                let case = c.known(&case).ok_or_else(no)?;
                c.by_one_side(goal, (&f, &slope, &t), &variable, side, strict && !side.is_positive, &case)
            })?);
        }
        self.emit(Rule::Logic { from }, goal.clone())
    }

    /// A sign of numbers, or of what is read as one.
    fn by_arithmetic(&mut self, goal: &Prop) -> Result<Label, Fail> {
        self.combination(goal.clone(), Vec::new()).or_else(|_| self.emit(Rule::Evaluate, goal.clone()))
    }

    /// The goal from the value of F at a place: F rises or falls from there to x, since its derivative has one sign between.
    fn by_one_side(
        &mut self,
        goal: &Prop,
        (f, slope, t): (&Expr, &Expr, &str),
        x: &Expr,
        side: &Side,
        strict: bool,
        case: &Label,
    ) -> Result<Label, Fail> {
        let (low, high) = if side.is_before { (side.place, x) } else { (x, side.place) };
        let between =
            Constraint::Interval { from: low.clone(), from_closed: false, to: high.clone(), to_closed: false };
        let (up, down) = (Relation::GreaterEqual, Relation::LessEqual);
        let with = |relation: Relation| if strict { relation.strict() } else { relation };
        let sign = with(if side.is_before { up } else { down });
        let body = compare(derivative(f, t), sign, numeral(0));
        let binding = Binding::of(Name::new(t), false, vec![between]);
        let every = prop(PropKind::ForAll(vec![binding], Box::new(body.clone())));
        let (splits, open) = (self.splits, self.slopes_open);
        self.slopes_open += 1;
        let source = self.block(&every, |c, _| {
            // F′(t) lies beyond F′(x), for F′ falls.
            let (there, here) = (name(t), x);
            let s = c.fresh("s");
            let of_s = put_in(slope, t, &name(&s))?;
            let said = compare(slope.clone(), sign, put_in(slope, t, here)?);
            let ends = if side.is_before { [&there, here] } else { [here, &there] };
            let order = c.rises(&said, &of_s, &s, ends, with(down), [here, &there])?;
            let terms = [&order, case].map(|fact| Term { facts: vec![fact.clone()], factor: numeral(1) });
            c.combination(body.clone(), terms.to_vec())
        });
        (self.splits, self.slopes_open) = (splits, open);
        let with_values = vec![(Name::new("a"), side.place.clone()), (Name::new("b"), x.clone())];
        let shown = compare(put_in(f, t, x)?, with(up), put_in(f, t, side.place)?);
        let rule = Rule::Slope { source: source?, with: with_values, from: Vec::new() };
        let label = self.emit(rule, shown)?;
        let terms = [&label, &side.known].map(|fact| Term { facts: vec![fact.clone()], factor: numeral(1) });
        self.combination(goal.clone(), terms.to_vec())
    }
}

fn derivative(f: &Expr, by: &str) -> Expr {
    expr(ExprKind::Derivative(Box::new(f.clone()), vec![Name::new(by)]))
}
