//! The hypothesis that a refuted claim lacks.
//!
//! Contract: a [`Repair`] holds a claim whose certificate the kernel accepted: that the refuted goal holds exactly where a
//! hypothesis H does, or that it holds where H does. In the latter case H can hold together with the other hypotheses.
//!
//! Method: the difference of the sides of a comparison in the goal is taken apart into factors. Those whose signs are not
//! known give candidates for H, with what the goal needs for its value, bounds on one variable, and the order of two.
//! What says the same as a comparison of the goal is left out. Each is tried at points first, then proved: equivalences before implications, and weaker hypotheses before stronger ones.

use super::Entry;
use crate::algebra::Moment;
use crate::algebra::Polynomial;
use crate::algebra::factor::factor;
use crate::certificate::{Certificate, Rule, Show};
use crate::claim::definedness::{Need, needs};
use crate::claim::parse::{parse, parse_expr};
use crate::claim::print::{Style, statement};
use crate::claim::syntax::*;
use crate::kernel::names::names_in_prop;
use crate::kernel::order::Signs;
use crate::kernel::statement::{Statement, compare, numeral, prop};
use crate::kernel::substitution::Substitution;
use crate::kernel::{Checker, key};
use crate::prove;
use crate::refute::case::Case;
use crate::refute::catalogue::Limits;
use crate::refute::expand;
use crate::refute::outcome::{DIMENSIONS, Verdict};
use crate::refute::reading::Reading;
use crate::refute::{counterexample::falsified, sample::example};
use std::collections::BTreeSet;
use std::time::Duration;

/// How long a candidate is tried at points.
const AT_POINTS: Duration = Duration::from_millis(250);
/// Which part of the time one proof may take.
const ONE_PROOF: u32 = 6;
/// How many factors without a known sign are put together.
const FACTORS: usize = 3;
/// How many signs of differences in a goal's sides are tried.
const DIFFERENCES: usize = 4;
/// The greatest first natural number that is tried.
const NATURALS: u32 = 6;

/// A hypothesis under which a refuted goal holds.
pub struct Repair {
    /// The hypothesis H.
    pub hypothesis: Prop,
    /// Whether the goal was shown to hold nowhere else.
    pub exact: bool,
    /// What was shown: `goal <=> H`, or the goal with H among the hypotheses.
    pub claim: Claim,
    /// The certificate that the kernel accepted.
    pub certificate: Certificate,
}

/// Why there is no repair.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoRepair {
    /// The claim is not refuted.
    NotRefuted(Verdict),
    /// Its dimensions differ, which no hypothesis changes.
    Dimensions,
    /// None of so many candidates was shown to be enough.
    NoneOf(usize),
}

/// The weakest hypothesis, among those that are tried, with which a refuted claim is proved.
///
/// # Errors
/// There is none among them, or the claim is not refuted.
pub fn repair(entry: &Entry, limits: &Limits) -> Result<Repair, NoRepair> {
    if entry.outcome.verdict != Verdict::Refuted {
        return Err(NoRepair::NotRefuted(entry.outcome.verdict));
    }
    if entry.outcome.method == DIMENSIONS {
        return Err(NoRepair::Dimensions);
    }
    let claim = &entry.claim;
    let Ok(statement) = Statement::of(claim) else { return Err(NoRepair::NoneOf(0)) };
    let witness: Vec<(String, String)> = entry.outcome.witness.as_ref().map_or(Vec::new(), |w| w.point.values.clone());
    let search = Search {
        claim,
        witness,
        limits: Limits { time: limits.time / ONE_PROOF, ..limits.clone() },
        deadline: Moment::now().checked_add(limits.time),
    };
    let (exact, enough) = candidates(claim, &statement);
    let tried = exact.len() + enough.len();
    let found = exact.into_iter().find_map(|h| search.equivalent(&h));
    found.or_else(|| enough.into_iter().find_map(|h| search.enough(&h))).ok_or(NoRepair::NoneOf(tried))
}

struct Search<'a> {
    claim: &'a Claim,
    witness: Vec<(String, String)>,
    limits: Limits,
    deadline: Option<Moment>,
}

impl Search<'_> {
    fn is_late(&self) -> bool {
        self.deadline.is_some_and(|deadline| Moment::now() > deadline)
    }

    /// Whether a hypothesis is true at the witness, so that it cannot be what is missing.
    fn holds_at_the_witness(&self, h: &Prop) -> bool {
        let mut map = Substitution::default();
        for (place, value) in &self.witness {
            if let Ok(value) = parse_expr(value) {
                map.replace(place, &value);
            }
        }
        map.prop(h).is_ok_and(|at| example(&[], &at, None).is_some())
    }

    /// The claim with another goal and no argument.
    fn with_goal(&self, goal: Prop) -> Claim {
        let name = Name { text: format!("{}-repaired", self.claim.name.text), span: self.claim.name.span };
        let mut notes = self.claim.notes.clone();
        notes.push(format!("A hypothesis is missing in {}.", self.claim.name.text));
        Claim {
            name,
            notes,
            goal,
            using: Vec::new(),
            sample: Vec::new(),
            proof: Proof::default(),
            expect: Expectation::Proved,
            typeset: None,
            ..self.claim.clone()
        }
    }

    /// The certificate of a claim that no point refutes.
    fn proved(&self, claim: &Claim) -> Option<Certificate> {
        if self.is_late() {
            return None;
        }
        let statement = expand::Statement::of(claim).ok()?;
        if falsified(&statement, Some(AT_POINTS)).is_some() {
            return None;
        }
        prove::certificate(claim, &[], &self.limits).ok().map(|found| found.0)
    }

    /// The goal holds exactly where H does.
    fn equivalent(&self, h: &Prop) -> Option<Repair> {
        if self.holds_at_the_witness(h) {
            return None;
        }
        let claim = self.with_goal(prop(PropKind::Equivalent(vec![self.claim.goal.clone(), h.clone()])));
        let certificate = self.proved(&claim)?;
        self.as_written(claim, certificate, h, true)
    }

    /// The goal holds where H does, which is somewhere.
    fn enough(&self, h: &Prop) -> Option<Repair> {
        if self.holds_at_the_witness(h) {
            return None;
        }
        let mut claim = self.with_goal(self.claim.goal.clone());
        claim.items.push(Item::Assume { label: None, prop: h.clone() });
        let certificate = self.proved(&claim)?;
        let somewhere = Case::new(&claim, &self.limits).is_ok_and(|case| !case.has_no_point());
        if somewhere { self.as_written(claim, certificate, h, false) } else { None }
    }

    /// The repair in the words of the claim's author. Where the reader wrote something out, what it makes of these words is
    /// proved instead.
    fn as_written(&self, claim: Claim, certificate: Certificate, h: &Prop, exact: bool) -> Option<Repair> {
        let Some(written) = &self.claim.written else {
            return Some(Repair { hypothesis: h.clone(), exact, claim, certificate });
        };
        let mut hypothesis = h.clone();
        // What a name stands for may have names that were made before it.
        for (name, meaning) in written.made.iter().rev() {
            let mut map = Substitution::default();
            map.replace(name, meaning);
            hypothesis = map.prop(&hypothesis).ok()?;
        }
        let mut plain = Claim { items: written.items.clone(), goal: written.goal.clone(), written: None, ..claim };
        match exact {
            true => plain.goal = prop(PropKind::Equivalent(vec![plain.goal, hypothesis.clone()])),
            false => plain.items.push(Item::Assume { label: None, prop: hypothesis.clone() }),
        }
        let text = format!("claim {} \"\"\n{}\n", plain.name.text, statement(&plain, Style::Text).join("\n"));
        let read = parse(&text).ok()?.pop()?;
        let claim = Claim { items: read.items, goal: read.goal, written: read.written, ..plain };
        let certificate = self.proved(&claim)?;
        Some(Repair { hypothesis, exact, claim, certificate })
    }
}

/// Candidates for what holds exactly where the goal does, and for what is enough, the weaker ones first.
fn candidates(claim: &Claim, statement: &Statement) -> (Vec<Prop>, Vec<Prop>) {
    let (mut exact, mut enough) = (Vec::new(), Vec::new());
    let mut atoms = Vec::new();
    comparisons(&statement.goal, &mut atoms);
    for (a, relation, b) in &atoms {
        let (e, f) = by_factors(claim, statement, a, *relation, b).unwrap_or_default();
        exact.extend(e);
        enough.extend(f);
        for side in [a, b] {
            needed(side, &mut enough);
        }
        let mut own = Vec::new();
        [a, b].into_iter().for_each(|side| differences(side, &mut own));
        enough.extend(own.into_iter().take(DIFFERENCES));
    }
    let own: Vec<Prop> = exact.iter().rev().cloned().collect();
    enough.extend(own);
    let mut names = BTreeSet::new();
    names_in_prop(&statement.goal, &mut names);
    bounds(statement, &names, &mut enough);
    let mut reading = expand::Statement::of(claim).ok().and_then(|s| Reading::of(&s, &statement.bindings));
    let mut form = |a: &Expr, b: &Expr| {
        let (above, below) = reading.as_mut()?.difference(a, b)?;
        let above = above.primitive_part().1;
        Some((if above.leading_coefficient() < 0 { above.neg() } else { above }, below.is_constant()))
    };
    // The sign of a quotient's numerator is no such comparison.
    let goals: Vec<Polynomial> = atoms.iter().filter_map(|(a, _, b)| form(a, b)).filter(|f| f.1).map(|f| f.0).collect();
    for list in [&mut exact, &mut enough] {
        let mut seen = BTreeSet::new();
        list.retain(|p| {
            // A comparison of the goal in other words says nothing of what is missing.
            let mut parts = Vec::new();
            comparisons(p, &mut parts);
            let restated = parts.iter().any(|(a, _, b)| form(a, b).is_some_and(|f| goals.contains(&f.0)));
            !restated && seen.insert(key::prop(p))
        });
    }
    (exact, enough)
}

/// The comparisons of a goal that speak of its variables, and of no bound ones.
fn comparisons(p: &Prop, out: &mut Vec<(Expr, Relation, Expr)>) {
    match &p.kind {
        PropKind::Compare(sides, relations) => {
            for (pair, relation) in sides.windows(2).zip(relations) {
                if let [a, b] = pair {
                    out.push((a.clone(), *relation, b.clone()));
                }
            }
        }
        PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => {
            list.iter().for_each(|p| comparisons(p, out));
        }
        PropKind::Implies(_, q) => comparisons(q, out),
        _ => {}
    }
}

/// What an expression and its parts need for their values.
fn needed(e: &Expr, out: &mut Vec<Prop>) {
    for need in needs(e, &|_| false).into_iter().flatten() {
        match need {
            Need::NotZero(e) => out.push(compare(e, Relation::NotEqual, numeral(0))),
            Need::Positive(e) => out.push(compare(e, Relation::Greater, numeral(0))),
            Need::NotNegative(e) => out.push(compare(e, Relation::GreaterEqual, numeral(0))),
            Need::NotZeroOrNatural(e, _) => out.push(compare(e, Relation::NotEqual, numeral(0))),
            Need::Range(..) | Need::Differentiable(..) => {}
        }
    }
    if !matches!(e.kind, ExprKind::SumOver(..) | ExprKind::ProductOver(..) | ExprKind::IntegralOver(..)) {
        expand::parts(e, &mut |part| needed(part, out));
    }
}

/// The two signs of each difference in an expression.
fn differences(e: &Expr, out: &mut Vec<Prop>) {
    if let ExprKind::Sum(terms) = &e.kind
        && terms.iter().any(|term| term.0 != terms[0].0)
    {
        out.extend([Relation::GreaterEqual, Relation::LessEqual].map(|relation| side(e, relation)));
    }
    if !matches!(e.kind, ExprKind::SumOver(..) | ExprKind::ProductOver(..) | ExprKind::IntegralOver(..)) {
        expand::parts(e, &mut |part| differences(part, out));
    }
}

/// Candidates from the factors of a − b whose signs are not known: exact ones, and those that are enough.
fn by_factors(
    claim: &Claim,
    statement: &Statement,
    a: &Expr,
    relation: Relation,
    b: &Expr,
) -> Option<(Vec<Prop>, Vec<Prop>)> {
    let difference = crate::kernel::statement::sum(vec![(Sign::Plus, a.clone()), (Sign::Minus, b.clone())]);
    let (positive, open) = open_factors(claim, statement, &difference)?;
    if open.is_empty() || open.len() > FACTORS {
        return None;
    }
    let zero = |relation: Relation| open.iter().map(|f| side(f, relation)).collect::<Vec<Prop>>();
    let (up, strict) = match relation {
        Relation::Equal => {
            let list = zero(Relation::Equal);
            let all = joined(&list, PropKind::Or);
            return Some((list.into_iter().chain([all]).collect(), Vec::new()));
        }
        Relation::NotEqual => return Some((vec![joined(&zero(Relation::NotEqual), PropKind::And)], Vec::new())),
        Relation::Greater | Relation::GreaterEqual => (positive, relation == Relation::Greater),
        Relation::Less | Relation::LessEqual => (!positive, relation == Relation::Less),
    };
    Some(by_signs(&open, up, strict))
}

/// The factors of an expression whose signs are not known, and whether all the others together are positive.
fn open_factors(claim: &Claim, statement: &Statement, difference: &Expr) -> Option<(bool, Vec<Expr>)> {
    let mut checker = Checker::new(claim, &[]).ok()?;
    let by = checker.facts().map(|(label, _)| label.to_string()).collect();
    let show = Show {
        label: String::new(),
        rule: Rule::Name,
        prop: compare(difference.clone(), Relation::Equal, difference.clone()),
        by,
        using: Vec::new(),
    };
    let expanded = expand::Statement::of(claim).ok()?;
    let mut reading = Reading::of(&expanded, &statement.bindings)?;
    let view = checker.view(difference, &show, false).ok()?;
    let mut positive = view.number > num_rational::BigRational::from_integer(0.into());
    let mut open: Vec<Expr> = Vec::new();
    for part in view.factors {
        let signs = part.signs.power(part.power);
        if signs.within(Signs::NOT_NEGATIVE) {
            continue;
        }
        if signs.turned().within(Signs::NOT_NEGATIVE) {
            positive = !positive;
            continue;
        }
        let split = reading.difference(&part.of, &numeral(0)).and_then(|p| factor(&p.0).ok());
        let Some(split) = split else {
            open.push(part.of);
            continue;
        };
        positive ^= split.unit < 0;
        for (poly, _) in split.factors.iter().filter(|f| f.1 % 2 == 1) {
            let words = reading.words(poly);
            let whole = checker.view(&words, &show, false).ok()?;
            positive ^= whole.number < num_rational::BigRational::from_integer(0.into());
            for part in whole.factors {
                let signs = part.signs.power(part.power);
                if signs.turned().within(Signs::NOT_NEGATIVE) && !signs.within(Signs::NOT_NEGATIVE) {
                    positive = !positive;
                } else if !signs.within(Signs::NOT_NEGATIVE) {
                    open.push(part.of);
                }
            }
        }
    }
    Some((positive, open))
}

/// Candidates that give the product of these factors a sign: exact ones, and those that are enough.
fn by_signs(open: &[Expr], up: bool, strict: bool) -> (Vec<Prop>, Vec<Prop>) {
    let signed = |f: &Expr, above: bool| {
        side(
            f,
            match (above, strict) {
                (true, true) => Relation::Greater,
                (true, false) => Relation::GreaterEqual,
                (false, true) => Relation::Less,
                (false, false) => Relation::LessEqual,
            },
        )
    };
    // Every choice of signs whose product is the one that is wanted.
    let choices = (0..1u32 << open.len()).filter(|bits| (bits.count_ones() % 2 == 0) == up);
    let cases: Vec<Prop> = choices
        .map(|bits| {
            let parts: Vec<Prop> = open.iter().enumerate().map(|(k, f)| signed(f, bits & (1 << k) == 0)).collect();
            joined(&parts, PropKind::And)
        })
        .collect();
    let single: Vec<Prop> = open.iter().flat_map(|f| [signed(f, true), signed(f, false)]).collect();
    let mut exact = Vec::new();
    if open.len() > 1 {
        exact.extend(single.clone());
        for (i, x) in single.iter().enumerate() {
            for y in single.iter().skip(i + 1).filter(|_| open.len() == 2) {
                exact.push(joined(&[x.clone(), y.clone()], PropKind::Or));
            }
        }
    }
    exact.extend(cases.clone());
    exact.push(joined(&cases, PropKind::Or));
    (exact, cases)
}

/// `P or Q …`, `P and Q …`; the one where there is one only.
fn joined(list: &[Prop], kind: impl Fn(Vec<Prop>) -> PropKind) -> Prop {
    match list {
        [only] => only.clone(),
        _ => prop(kind(list.to_vec())),
    }
}

/// `f relation 0`, what is subtracted on the other side.
fn side(f: &Expr, relation: Relation) -> Prop {
    let ExprKind::Sum(terms) = &f.kind else { return compare(f.clone(), relation, numeral(0)) };
    let half = |wanted: Sign| {
        let list: Vec<(Sign, Expr)> =
            terms.iter().filter(|t| t.0 == wanted).map(|t| (Sign::Plus, t.1.clone())).collect();
        match list.as_slice() {
            [] => numeral(0),
            [(_, only)] => only.clone(),
            _ => crate::kernel::statement::sum(list),
        }
    };
    let (mut left, mut right, mut relation) = (half(Sign::Plus), half(Sign::Minus), relation);
    // A number stands on the right.
    if matches!(left.kind, ExprKind::Number(_)) && !matches!(right.kind, ExprKind::Number(_)) {
        (left, right, relation) = (right, left, relation.turned());
    }
    compare(left, relation, right)
}

/// Bounds on one variable, the order of two, and a least natural number.
fn bounds(statement: &Statement, names: &BTreeSet<String>, out: &mut Vec<Prop>) {
    let plain = statement.bindings.iter().flat_map(|b| b.names.iter().map(|n| (b.natural, n)));
    let plain: Vec<(bool, Expr)> = plain
        .filter(|(_, n)| n.1.is_none() && names.contains(&n.0.text))
        .map(|(natural, n)| (natural, crate::kernel::statement::name(&n.0.text)))
        .collect();
    for (natural, x) in &plain {
        if *natural {
            out.extend((1..=NATURALS).map(|k| compare(x.clone(), Relation::GreaterEqual, numeral(k))));
            out.extend((0..3).rev().map(|k| compare(x.clone(), Relation::LessEqual, numeral(k))));
            continue;
        }
        for k in [0, 1] {
            use Relation::*;
            for relation in [NotEqual, GreaterEqual, LessEqual, Greater, Less] {
                out.push(compare(x.clone(), relation, numeral(k)));
            }
        }
    }
    for (i, (_, x)) in plain.iter().enumerate() {
        for (_, y) in plain.iter().skip(i + 1) {
            use Relation::*;
            for relation in [NotEqual, GreaterEqual, LessEqual, Greater, Less] {
                out.push(compare(x.clone(), relation, y.clone()));
            }
        }
    }
    for (i, (natural, x)) in plain.iter().enumerate() {
        for (_, y) in plain.iter().skip(i + 1).filter(|y| !natural && !y.0) {
            for relation in [Relation::GreaterEqual, Relation::Greater] {
                let parts = [compare(x.clone(), relation, numeral(0)), compare(y.clone(), relation, numeral(0))];
                out.push(prop(PropKind::And(parts.to_vec())));
            }
        }
    }
}
