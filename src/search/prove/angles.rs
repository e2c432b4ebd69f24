//! Equations and orders of angles, from their sines, cosines or tangents.
//!
//! Method: `P relation Q` holds for two angles on a stretch from (m − 1)·π/2 to (m + 1)·π/2 if it holds for the sines of P − m·π/2
//! and Q − m·π/2, for there the sine rises strictly; strictly inside, also if it holds for the tangents. What is to show for
//! the sines or tangents ([`Injection::core`]) is a comparison of polynomials in cosines and sines, and goes through the other methods. For
//! `x = a or x = b or …` the product of the differences is shown to be 0.
//!
//! Certificate: rule `arc` says that P − m·π/2 is the arcsin of its sine, and that arcsines are ordered as their arguments.

use super::arcs::quarter_turn;
use super::comparison::single;
use super::facts::{minus, negated};
use super::letters::{product, total};
use super::limits::over;
use super::{Fail, Prover, implies};
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::kernel::arc::as_arc;
use crate::kernel::names::names_in;
use crate::kernel::order::Signs;
use crate::kernel::statement::{apply, compare, numeral, prop};
use std::collections::BTreeSet;

/// The stretches that are tried, by their middles as multiples of π/2: all that a range within two turns around 0 meets.
const MIDDLES: [i64; 9] = [0, 1, -1, 2, -2, 3, -3, 4, -4];

/// The multiples of the angles that are compared: what is known of 2·x may tell nothing simple of the sine of x.
const MULTIPLES: [u32; 2] = [1, 2];

/// The most comparisons of sines or tangents that are tried for one goal with more than little effort.
const EFFORTS: usize = 4;

/// The most equations of a disjunction that are shown together.
const PARTS: usize = 6;

/// Two angles of which a multiple lies on a stretch where the sine rises, or strictly inside of one, where the tangent has values.
#[derive(Clone)]
struct Injection {
    /// Both angles as the goal has them.
    angles: [Expr; 2],
    relation: Relation,
    way: Way,
}

/// How two angles are compared.
#[derive(Clone, Copy, PartialEq)]
struct Way {
    by_tangent: bool,
    multiple: u32,
    middle: i64,
}

impl Way {
    /// The multiples of two angles less the middle of the stretch.
    fn moved(&self, angles: &[Expr; 2]) -> [Expr; 2] {
        angles.each_ref().map(|e| less_turns(&product(vec![numeral(self.multiple), e.clone()]), self.middle))
    }
}

impl Injection {
    /// What lies on the stretch around 0.
    fn moved(&self) -> [Expr; 2] {
        self.way.moved(&self.angles)
    }

    /// What is compared in the place of the angles: the sines, or the tangents times both cosines.
    fn core(&self) -> [Expr; 2] {
        let [p, q] = &self.moved();
        let sine = |e: &Expr| apply("sin", e.clone());
        let times = |a: &Expr, b: &Expr| product(vec![sine(a), apply("cos", b.clone())]);
        if self.way.by_tangent { [times(p, q), times(q, p)] } else { [sine(p), sine(q)] }
    }

    /// The comparison of the sines or tangents.
    fn shown_by(&self) -> Prop {
        let [p, q] = self.core();
        compare(p, self.relation, q)
    }
}

impl Prover {
    /// Shows a comparison of angles by that of their sines or tangents.
    pub(super) fn by_angles(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let (a, relation, b) = single(goal)?;
        let no = || Fail::No("a comparison of angles");
        if self.within_arcs || relation == Relation::NotEqual {
            return Err(no());
        }
        self.attempt(|c| {
            let found = c.injections(a, relation, b);
            let efforts = if c.splits >= 8 { 0 } else { EFFORTS };
            for one in &found {
                if let Ok(core) = c.within_an_arc(|c| c.quietly(&one.shown_by())) {
                    return c.ordered_by_core(goal, one, &core);
                }
            }
            for one in found.iter().take(efforts) {
                if let Ok(core) = c.within_an_arc(|c| c.with_half(|c| c.without_cases(&one.shown_by()))) {
                    return c.ordered_by_core(goal, one, &core);
                }
            }
            Err(no())
        })
    }

    /// Shows a part of an argument about angles, in which no other such argument begins.
    fn within_an_arc<T>(&mut self, run: impl FnOnce(&mut Self) -> Result<T, Fail>) -> Result<T, Fail> {
        self.within_arcs = true;
        let shown = self.attempt(run);
        self.within_arcs = false;
        shown
    }

    /// The variables that occur in cosines and sines met so far.
    pub(super) fn angles(&self) -> BTreeSet<String> {
        let mut names = BTreeSet::new();
        if !self.checker.statement().declares(PI) {
            for letter in self.letters.all() {
                if let ExprKind::Apply(f, at) = &letter.kind
                    && matches!(f.text.as_str(), "cos" | "sin")
                {
                    at.iter().for_each(|e| names_in(e, &mut names));
                }
            }
        }
        names.remove(PI);
        names.retain(|n| self.is_a_name(n));
        names
    }

    /// The ways to see a comparison by sines or tangents: solved for each of its angles, on each stretch that both sides lie on.
    fn injections(&mut self, a: &Expr, relation: Relation, b: &Expr) -> Vec<Injection> {
        let mut out = Vec::new();
        let angles = self.angles();
        if angles.is_empty() {
            return out;
        }
        let difference = minus(a, b);
        let letters = self.letters_in(&[&difference]);
        if !letters.iter().all(may_be_an_angle) || !self.speaks_of_turns(&letters) {
            return out;
        }
        for angle in letters.iter().filter(|e| matches!(&e.kind, ExprKind::Name(n) if angles.contains(n.as_str()))) {
            let Some((turned, other)) = self.solved_for(&difference, angle) else { continue };
            let relation = if turned { relation.turned() } else { relation };
            let sides = [angle.clone(), other];
            // What the kernel sees of the lengths mostly suffices.
            let mut ways = self.ways(&sides, false);
            if ways.is_empty() {
                ways = self.ways(&sides, true);
            }
            out.extend(ways.into_iter().map(|way| Injection { angles: sides.clone(), relation, way }));
        }
        // A tangent is best seen by tangents.
        let has_tangent = letters.iter().any(|e| matches!(as_arc(e), Some(("arctan", _))));
        out.sort_by_key(|one| (one.way.by_tangent != has_tangent, one.way.multiple));
        for one in &out {
            let of_functions = one.moved().map(|e| [apply("cos", e.clone()), apply("sin", e)]);
            self.enrich(&of_functions.iter().flatten().collect::<Vec<_>>());
        }
        out
    }

    /// Whether π or an arc stands beside variables, or a fact bounds one of them by π: no other comparison is worth the lengths.
    pub(super) fn speaks_of_turns(&self, letters: &[Expr]) -> bool {
        let names: Vec<&String> = letters
            .iter()
            .filter_map(|e| match &e.kind {
                ExprKind::Name(n) => Some(n),
                _ => None,
            })
            .collect();
        names.len() < letters.len()
            || names.iter().any(|n| *n == PI)
            || self.checker.facts().any(|(_, fact)| {
                let mut said = BTreeSet::new();
                if let PropKind::Compare(sides, _) = &fact.kind {
                    sides.iter().for_each(|e| names_in(e, &mut said));
                }
                said.contains(PI) && names.iter().any(|n| said.contains(*n))
            })
    }

    /// The ways in which two angles can be compared; on request with linear programs for the lengths.
    fn ways(&mut self, sides: &[Expr; 2], by_programs: bool) -> Vec<Way> {
        let mut ways = Vec::new();
        for (multiple, middle) in MULTIPLES.into_iter().flat_map(|k| MIDDLES.map(|m| (k, m))) {
            let way = Way { by_tangent: false, multiple, middle };
            let moved = way.moved(sides);
            if moved.iter().all(|e| self.lies_on_an_arc(e, Relation::GreaterEqual, by_programs)) {
                ways.push(way);
                if moved.iter().all(|e| self.lies_on_an_arc(e, Relation::Greater, by_programs)) {
                    ways.push(Way { by_tangent: true, ..way });
                }
            }
        }
        ways
    }

    /// Whether an angle lies between −π/2 and π/2, or strictly between.
    fn lies_on_an_arc(&mut self, e: &Expr, relation: Relation, by_programs: bool) -> bool {
        let lengths = [minus(&quarter_turn(1), e), minus(e, &quarter_turn(-1))];
        match by_programs {
            true => self.are_lengths(&lengths, relation),
            false => lengths.iter().all(|length| self.signs_of(length).within(Signs::of(relation))),
        }
    }

    /// The comparison of two angles from that of their sines or tangents.
    fn ordered_by_core(&mut self, goal: &Prop, one: &Injection, core: &str) -> Result<Label, Fail> {
        let no = || Fail::No("a comparison of angles");
        let known = self.fact(core).ok_or_else(no)?;
        self.take_in(core, &known)?;
        let f = if one.way.by_tangent { "arctan" } else { "arcsin" };
        let [p, q] = &one.moved();
        let turned_back = [p, q].map(|e| {
            let sine = apply("sin", e.clone());
            if one.way.by_tangent { over(sine, apply("cos", e.clone())) } else { sine }
        });
        if one.way.by_tangent {
            let shown = compare(turned_back[0].clone(), one.relation, turned_back[1].clone());
            let factor = over(numeral(1), product([p, q].map(|e| apply("cos", e.clone())).to_vec()));
            self.combination(shown, vec![Term { facts: vec![core.to_string()], factor }])?;
        }
        let [first, second] = turned_back.map(|e| apply(f, e));
        let mut terms = Vec::new();
        for (arc, angle, weight) in [(&first, p, negated(numeral(1))), (&second, q, numeral(1))] {
            let label = self.emit(Rule::Arc, compare(arc.clone(), Relation::Equal, angle.clone()))?;
            terms.push(Term { facts: vec![label], factor: weight });
        }
        let ordered = self.emit(Rule::Arc, compare(first, one.relation, second))?;
        terms.push(Term { facts: vec![ordered], factor: numeral(1) });
        let part = over(numeral(1), numeral(one.way.multiple));
        terms.iter_mut().for_each(|term| term.factor = product(vec![part.clone(), term.factor.clone()]));
        let [p, q] = &one.angles;
        let shown = compare(p.clone(), one.relation, q.clone());
        let label = self.combination(shown.clone(), terms)?;
        if crate::kernel::key::prop(&shown) == crate::kernel::key::prop(goal) {
            return Ok(label);
        }
        self.take_in(&label, &shown)?;
        self.combination(goal.clone(), Vec::new())
    }

    /// Shows that an angle has one of several values, or that one of several equations of angles holds: the differences of the
    /// sines or tangents have the product 0.
    pub(super) fn one_of_angles(&mut self, goal: &Prop, parts: &[Prop]) -> Result<Label, Fail> {
        let no = || Fail::No("equations of angles");
        if parts.len() > PARTS {
            return Err(no());
        }
        let mut found = Vec::new();
        for part in parts {
            let (a, b) = as_equation(part).ok_or_else(no)?;
            let ways = if self.differ(a, b) { Vec::new() } else { self.injections(a, Relation::Equal, b) };
            // An equation of angles that lie on no common stretch holds at most elsewhere.
            if !ways.is_empty() {
                found.push((part.clone(), ways));
            }
        }
        if let [(part, _)] = found.as_slice() {
            let label = self.by_angles(part)?;
            return self.logic(&[&label], goal);
        }
        let mut ways: Vec<Way> = Vec::new();
        for one in found.iter().flat_map(|f| &f.1) {
            if !ways.contains(&one.way) {
                ways.push(one.way);
            }
        }
        // A part that this way does not fit is seen in a way of its own.
        let chosen_by = |way: &Way| -> Vec<(Prop, Injection)> {
            let fits = |f: &(Prop, Vec<Injection>)| {
                let one = f.1.iter().find(|one| one.way == *way).or_else(|| f.1.first())?;
                Some((f.0.clone(), one.clone()))
            };
            found.iter().filter_map(fits).collect()
        };
        for (way, quiet) in ways.iter().map(|w| (w, true)).chain(ways.iter().take(EFFORTS).map(|w| (w, false))) {
            let chosen = chosen_by(way);
            let factors = chosen.iter().map(|f| f.1.core()).map(|[a, b]| minus(&a, &b)).collect();
            let zero = compare(product(factors), Relation::Equal, numeral(0));
            let shown =
                self.within_an_arc(|c| if quiet { c.quietly(&zero) } else { c.with_half(|c| c.without_cases(&zero)) });
            if let Ok(label) = shown {
                return self.one_of_factors(goal, &label, &chosen);
            }
        }
        Err(no())
    }

    /// Whether two angles are seen to differ.
    fn differ(&mut self, a: &Expr, b: &Expr) -> bool {
        [minus(a, b), minus(b, a)].into_iter().any(|length| self.are_lengths(&[length], Relation::Greater))
    }

    /// One of several equations of angles, from the product of the differences of what they are seen by.
    fn one_of_factors(&mut self, goal: &Prop, zero: &str, parts: &[(Prop, Injection)]) -> Result<Label, Fail> {
        let any = prop(PropKind::Or(parts.iter().map(|p| p.1.shown_by()).collect()));
        let PropKind::Compare(sides, _) = self.fact(zero).ok_or(Fail::No("a product"))?.kind else {
            return Err(Fail::No("a product"));
        };
        let not_zero = compare(sides[0].clone(), Relation::NotEqual, numeral(0));
        let mut from = vec![self.against_opposite(&any, |c, _| {
            // The product may stand for 0 by the equations put in.
            let equations = std::mem::take(&mut c.equations);
            let shown = c.combination(not_zero, Vec::new());
            c.equations = equations;
            c.logic(&[&shown?, zero], &any)
        })?];
        for (part, one) in parts {
            from.push(self.block(&implies(&one.shown_by(), part), |c, block| {
                c.ordered_by_core(part, one, &format!("{block}s"))
            })?);
        }
        self.emit(Rule::Logic { from }, goal.clone())
    }
}

/// Whether a letter may be part of an angle: a variable, π, or an arc. In `sin(x) < x` no angles are compared.
pub(super) fn may_be_an_angle(letter: &Expr) -> bool {
    matches!(letter.kind, ExprKind::Name(_)) || as_arc(letter).is_some()
}

/// An angle less a multiple of π/2.
fn less_turns(e: &Expr, times: i64) -> Expr {
    if times == 0 { e.clone() } else { total(vec![(Sign::Plus, e.clone()), (Sign::Plus, quarter_turn(-times))]) }
}

/// The sides of an equation.
fn as_equation(p: &Prop) -> Option<(&Expr, &Expr)> {
    p.single().filter(|(_, relation, _)| *relation == Relation::Equal).map(|(a, _, b)| (a, b))
}
