//! Certificates of refutations: a witness written down as steps that the kernel takes.
//!
//! Contract: [`certificate`] returns only what the kernel accepts as a refutation of the claim. Nothing here is trusted.
//!
//! Method: what has to be shown (`kernel::refutation`) is evaluated at the witness in one step. Where enclosures do not decide
//! it, each part is shown by itself: comparisons by evaluation, with derivatives carried out, or as claims of their own by
//! the search for proofs; the parts together by logic. Where nothing is false, an expression without value is looked for, the
//! innermost first.

use crate::algebra::Moment;
use crate::certificate::text::digest;
use crate::certificate::{Certificate, Label, Refutes, Rule, Show, Step, Term, needed};
use crate::claim::definedness::{Need, needs};
use crate::claim::parse::parse_expr;
use crate::claim::print;
use crate::claim::syntax::*;
use crate::claim::write_out::Words;
use crate::kernel::statement::{Statement, compare, name, numeral, prop};
use crate::kernel::substitution::Substitution;
use crate::kernel::{self, Checker, Reason, Refusal, check, key, refutation};
use crate::prove;
use crate::refute::catalogue::Limits;
use crate::refute::counterexample::broken;
use crate::refute::evaluate::Assignment;
use crate::refute::expand;
use crate::refute::outcome::{Broken, Outcome, Point, Verdict, Witness};

/// How many expressions are tried for one without value, each at several indices.
const TRIES: usize = 400;
/// The part of the time limit for a hypothesis about all members of a family.
const FOR_ALL: u32 = 20;
/// The first indices at which a member of a sum is tried.
const INDICES: u32 = 12;
/// Values for a member of a family that the witness does not name.
const MEMBERS: [&str; 6] = ["1", "2", "1/2", "0", "-1", "-1/2"];

/// A certificate that a claim is false at a point, or has no value there.
pub fn certificate(claim: &Claim, witness: &Point, limits: &Limits) -> Option<Certificate> {
    let deadline = Moment::now().checked_add(limits.time);
    let statement = Statement::of(claim).ok()?;
    let mut point = Vec::new();
    for (place, value) in &witness.values {
        point.push((parse_expr(place).ok()?, parse_expr(value).ok()?));
    }
    let grow = moving(&statement.goal);
    point.retain(|(place, _)| !matches!(&place.kind, ExprKind::Name(n) if grow.contains(n)));
    let point = completed(claim, &statement, point)?;
    let refuter = Refuter { claim, limits, deadline };
    refuter.falsified(&point).or_else(|| refuter.undefined(&statement.goal, &point))
}

/// The outcome of a claim that a certificate refutes.
pub fn outcome(undecided: Outcome, claim: &Claim, certificate: &Certificate) -> Outcome {
    let without_value = certificate.refutes.as_ref().is_some_and(|refutes| refutes.undefined.is_some());
    Outcome {
        verdict: Verdict::Refuted,
        method: if without_value { "definedness" } else { "search" }.to_string(),
        witness: Some(witness(claim, certificate)),
        reason: None,
        limit: None,
        ..undecided
    }
}

/// Whether the counterexample of a certificate has both sides of what is false at it.
pub fn shows_sides(claim: &Claim, certificate: &Certificate) -> bool {
    let is_defined = certificate.refutes.as_ref().is_some_and(|refutes| refutes.undefined.is_none());
    is_defined && witness(claim, certificate).broken.iter().all(|broken| !broken.right.is_empty())
}

/// The counterexample of a certificate that refutes a claim.
pub fn witness(claim: &Claim, certificate: &Certificate) -> Witness {
    let refutes = certificate.refutes.clone().unwrap_or_default();
    let values = refutes.point.iter().map(|(place, value)| (print::expr(place), print::expr(value))).collect();
    let single = |statement, left: &str| vec![Broken { statement, left: left.to_string(), right: String::new() }];
    let broken = match &refutes.undefined {
        Some(e) => single(format!("{} has no value", print::expr(&Words::of(claim).expr(e))), "no value"),
        None => {
            let sides = expand::Statement::of(claim).map_or_else(|_| Vec::new(), |s| broken(claim, &s, &refutes.point));
            if sides.is_empty() { single(print::prop(claim.written_goal()), "") } else { sides }
        }
    };
    Witness { point: Point { values }, broken }
}

/// The point with a member of each family whose domain has bounds.
fn completed(claim: &Claim, statement: &Statement, mut point: Vec<(Expr, Expr)>) -> Option<Vec<(Expr, Expr)>> {
    for binding in statement.bindings.iter().filter(|b| !b.constraints.is_empty()) {
        for (family, _) in binding.names.iter().filter(|n| n.1.is_some()) {
            if point.iter().any(|(place, _)| matches!(&place.kind, ExprKind::Apply(f, _) if f == family)) {
                continue;
            }
            let first = binding.indices.as_ref().map_or(numeral(0), |range| range.0.clone());
            let place = Expr { kind: ExprKind::Apply(family.clone(), vec![first]), span: Span::default() };
            let fits = MEMBERS.iter().filter_map(|text| parse_expr(text).ok()).find_map(|value| {
                let mut tried = point.clone();
                tried.push((place.clone(), value));
                let refutes = Refutes { point: tried, undefined: None };
                // The only fault may be that of a family that comes later.
                match refutation::of(claim, &refutes) {
                    Err(Refusal::Rejected(Reason::Point(_)) | Refusal::Limit(_)) => None,
                    _ => Some(refutes.point),
                }
            });
            point = fits?;
        }
    }
    Some(point)
}

struct Refuter<'a> {
    claim: &'a Claim,
    limits: &'a Limits,
    deadline: Option<Moment>,
}

/// A refutation under way.
struct Attempt {
    refutes: Refutes,
    /// What is to be shown.
    claim: Claim,
    checker: Checker,
    /// The facts that give the point.
    given: Vec<Label>,
    /// Facts that signs are read from besides.
    read: Vec<Label>,
    steps: Vec<Step>,
    deadline: Option<Moment>,
}

impl Refuter<'_> {
    fn is_late(&self) -> bool {
        self.deadline.is_some_and(|deadline| Moment::now() > deadline)
    }

    fn attempt(&self, refutes: Refutes) -> Option<Attempt> {
        let claim = refutation::of(self.claim, &refutes).ok()?;
        let mut checker = Checker::refuting(self.claim, &refutes).ok()?;
        checker.watched_by(prove::until(self.deadline));
        let labels: Vec<Label> = checker.facts().map(|(label, _)| label.to_string()).collect();
        let given = labels.get(labels.len().checked_sub(refutes.point.len())?..)?.to_vec();
        Some(Attempt { refutes, claim, checker, given, read: Vec::new(), steps: Vec::new(), deadline: self.deadline })
    }

    /// The goal is false at the point.
    fn falsified(&self, point: &[(Expr, Expr)]) -> Option<Certificate> {
        let mut attempt = self.attempt(Refutes { point: point.to_vec(), undefined: None })?;
        let goal = attempt.goal()?;
        self.shown(&mut attempt, &goal)?;
        attempt.finished(self.claim)
    }

    /// Shows the goal at once, or part by part.
    fn shown(&self, attempt: &mut Attempt, goal: &Prop) -> Option<Label> {
        if let Some(label) = attempt.evaluate(goal) {
            return Some(label);
        }
        let PropKind::And(parts) = &goal.kind else { return self.part(attempt, goal) };
        let shown: Option<Vec<Label>> = parts.iter().map(|part| self.part(attempt, part)).collect();
        attempt.logic(goal, shown?)
    }

    /// Shows a part of the goal: at once, or from its comparisons and limits.
    fn part(&self, attempt: &mut Attempt, part: &Prop) -> Option<Label> {
        if let Some(label) = attempt.evaluate(part) {
            return Some(label);
        }
        if let PropKind::ForAll(..) | PropKind::Exists(..) = &part.kind {
            // Mostly a few members do not tell of all.
            let families = self.claim.items.iter().any(|item| match item {
                Item::Given(bindings) => bindings.iter().flat_map(|b| &b.names).any(|n| n.1.is_some()),
                _ => false,
            });
            return self.searched(attempt, part, if families { FOR_ALL } else { 1 });
        }
        let mut atoms = Vec::new();
        atoms_of(part, &mut atoms);
        let mut shown = Vec::new();
        for atom in atoms {
            // Behind a premise that is false a part may have no value.
            shown.extend(self.atom(attempt, &atom, part));
        }
        if let Some(label) = shown.iter().find(|label| attempt.shows(label, part)) {
            return Some(label.clone());
        }
        attempt.logic(part, shown)
    }

    /// Shows a comparison, limit or quantified part that stands in this part of the goal, or that it is false.
    fn atom(&self, attempt: &mut Attempt, atom: &Prop, part: &Prop) -> Option<Label> {
        let denied = match &atom.kind {
            PropKind::Compare(..) => {
                let (a, relation, b) = atom.single()?;
                compare(a.clone(), relation.negated(), b.clone())
            }
            _ => prop(PropKind::Not(Box::new(atom.clone()))),
        };
        // A search for what the part does not ask for has no end but its limit.
        let sides = match &part.kind {
            _ if matches!(atom.kind, PropKind::Exists(..) | PropKind::ForAll(..)) => match attempt.truth(atom) {
                Some(true) => vec![atom],
                Some(false) => vec![&denied],
                None if matches!(atom.kind, PropKind::Exists(..)) => vec![&denied],
                None => return None,
            },
            PropKind::Compare(..) | PropKind::Limit(_) => vec![atom],
            PropKind::Not(p) if matches!(p.kind, PropKind::Compare(..) | PropKind::Limit(_)) => vec![&denied],
            _ => vec![&denied, atom],
        };
        let by_rule = |attempt: &mut Attempt, p: &Prop| match &atom.kind {
            PropKind::Limit(_) => attempt.step(Rule::Limit { with: Vec::new() }, p, true, false).or_else(|| {
                let from = Name::new("from");
                attempt.step(Rule::Limit { with: vec![(from, numeral(1))] }, p, true, false)
            }),
            _ => attempt.compared(p).or_else(|| attempt.with_derivatives(p)),
        };
        sides
            .iter()
            .find_map(|p| by_rule(attempt, p))
            .or_else(|| sides.iter().find_map(|p| self.with_integrals(attempt, p)))
            .or_else(|| sides.iter().find_map(|p| self.searched(attempt, p, 1)))
    }

    /// Shows a comparison by evaluating it with the values of its integrals, each of which the search for proofs shows.
    fn with_integrals(&self, attempt: &mut Attempt, p: &Prop) -> Option<Label> {
        let PropKind::Compare(sides, relations) = &p.kind else { return None };
        let mut integrals = Vec::new();
        exprs_of(p, &mut Vec::new(), &mut integrals);
        integrals.retain(|(e, bound)| bound.is_empty() && matches!(e.kind, ExprKind::IntegralOver(..)));
        if integrals.is_empty() {
            return None;
        }
        let sides = sides.iter().map(prove::with_values_of_integrals).collect();
        let plain = prop(PropKind::Compare(sides, relations.clone()));
        let fact = attempt.evaluate(&plain)?;
        let mut values = Vec::new();
        for (integral, _) in integrals {
            let value = prove::with_values_of_integrals(&integral);
            let value = compare(integral, Relation::Equal, value);
            let label = self.searched(attempt, &value, 4)?;
            values.push(label);
        }
        // The values stand for the integrals as they are written, before the point is put in.
        let given = std::mem::replace(&mut attempt.given, values);
        let terms = vec![Term { facts: vec![fact], factor: numeral(1) }];
        let shown = attempt.step(Rule::Combination { times: None, terms }, p, true, true);
        attempt.given = given;
        shown
    }

    /// Shows a proposition by the search for proofs, as a claim of its own.
    /// It takes this part of the time limit at most.
    fn searched(&self, attempt: &mut Attempt, p: &Prop, part: u32) -> Option<Label> {
        if self.is_late() {
            return None;
        }
        let mut own = Claim { goal: p.clone(), ..attempt.claim.clone() };
        // Names that steps before it gave are taken.
        for show in attempt.steps.iter().filter_map(Step::show).filter(|show| matches!(show.rule, Rule::Name)) {
            if let PropKind::Compare(sides, _) = &show.prop.kind
                && let Some(Expr { kind: ExprKind::Name(given), .. }) = sides.last()
            {
                own.items.push(Item::Given(vec![Binding::of(Name::new(given), false, Vec::new())]));
            }
        }
        let limits = Limits { time: self.limits.time / part, ..self.limits.clone() };
        let (found, _) = prove::certificate(&own, &[], &limits).ok()?;
        // Its labels are new here.
        let run = attempt.steps.len();
        let fresh = |label: &str| if label.starts_with('h') { label.to_string() } else { format!("r{run}x{label}") };
        let mut last = None;
        for step in found.steps {
            let step = match step {
                Step::End(label) => Step::End(fresh(&label)),
                Step::Show(mut show) => {
                    show.relabel(&mut |label| fresh(label));
                    show.label = fresh(&show.label);
                    last = Some(show.label.clone());
                    Step::Show(show)
                }
            };
            attempt.checker.step(&step).ok()?;
            attempt.steps.push(step);
        }
        last.filter(|label| attempt.shows(label, p)).or_else(|| attempt.known(p))
    }

    /// An expression of the goal has no value at the point.
    fn undefined(&self, goal: &Prop, point: &[(Expr, Expr)]) -> Option<Certificate> {
        let (mut candidates, mut bound) = (Vec::new(), Vec::new());
        exprs_of(goal, &mut bound, &mut candidates);
        for (e, bound) in candidates.into_iter().take(TRIES) {
            for indices in choices(&bound) {
                if self.is_late() {
                    return None;
                }
                let places = indices.into_iter().map(|(n, k)| (name(&n), numeral(k)));
                let point = point.iter().cloned().chain(places).collect();
                let Some(mut attempt) = self.attempt(Refutes { point, undefined: Some(e.clone()) }) else { continue };
                let Some(goal) = attempt.goal() else { continue };
                if attempt.evaluated(&goal).or_else(|| attempt.multiplied_out(&goal)).is_some()
                    && let Some(found) = attempt.finished(self.claim)
                {
                    return Some(found);
                }
            }
        }
        None
    }
}

impl Attempt {
    fn goal(&self) -> Option<Prop> {
        Some(self.checker.statement().goal.clone())
    }

    /// Takes a step with a new label, reading signs from the point and putting it in if so asked.
    fn step(&mut self, rule: Rule, p: &Prop, by: bool, using: bool) -> Option<Label> {
        let label = format!("{}", self.steps.len() + 1);
        let signs = self.given.iter().chain(&self.read).filter(|_| by).cloned().collect();
        let put_in = self.given.iter().filter(|_| using).cloned().collect();
        let mut show = Show { label: label.clone(), rule, prop: p.clone(), by: signs, using: put_in };
        // What a step does not use is not cited.
        if let Ok(used) = self.checker.used(&show) {
            (show.by, show.using) = (used.by, used.using);
        }
        let step = Step::Show(Box::new(show));
        self.checker.step(&step).ok()?;
        self.steps.push(step);
        Some(label)
    }

    fn evaluate(&mut self, p: &Prop) -> Option<Label> {
        self.step(Rule::Evaluate, p, false, true)
    }

    /// Shows a conjunction by evaluating it at once, or its parts with derivatives carried out.
    fn evaluated(&mut self, p: &Prop) -> Option<Label> {
        let whole = self.evaluate(p);
        if whole.is_some() || !differentiates(p) {
            return whole;
        }
        let PropKind::And(list) = &p.kind else { return self.with_derivatives(p) };
        let shown = list.iter().map(|part| self.evaluate(part).or_else(|| self.with_derivatives(part)));
        let shown = shown.collect::<Option<Vec<Label>>>()?;
        self.logic(p, shown)
    }

    /// Shows that comparisons fail which hold at the point by exact values alone: cos(pi/2) is 0.
    fn multiplied_out(&mut self, p: &Prop) -> Option<Label> {
        let mut atoms = Vec::new();
        atoms_of(p, &mut atoms);
        let mut shown = Vec::new();
        for atom in atoms {
            let Some((a, relation, b)) = atom.single() else { continue };
            let denied = compare(a.clone(), relation.negated(), b.clone());
            let either = [denied, atom.clone()];
            shown.extend(either.iter().find_map(|p| self.compared(p)));
        }
        self.logic(p, shown)
    }

    /// Shows a comparison by its enclosures, by exact values, or by those of its powers.
    fn compared(&mut self, p: &Prop) -> Option<Label> {
        self.evaluate(p)
            .or_else(|| self.step(Rule::Combination { times: None, terms: Vec::new() }, p, true, true))
            .or_else(|| self.step(Rule::Power, p, true, true))
    }

    fn logic(&mut self, p: &Prop, from: Vec<Label>) -> Option<Label> {
        self.step(Rule::Logic { from }, p, true, true)
    }

    /// The truth of a quantified part at the point, if the evaluator knows it.
    fn truth(&self, p: &Prop) -> Option<bool> {
        let alone = Assignment { is_pi: !self.checker.statement().declares(PI), ..Assignment::default() };
        // What is quantified is searched for values, which ends with the time that is left.
        let mut here = Assignment { until: self.deadline, ..alone.clone() };
        for (place, value) in &self.refutes.point {
            if let (ExprKind::Name(n), Ok(number)) = (&place.kind, alone.number(value)) {
                here.give(n, number);
            }
        }
        here.truth(p).ok()
    }

    fn shows(&self, label: &str, p: &Prop) -> bool {
        self.checker.facts().any(|(known, fact)| known == label && key::prop(fact) == key::prop(p))
    }

    fn known(&self, p: &Prop) -> Option<Label> {
        let wanted = key::prop(p);
        self.checker.facts().find(|(_, fact)| key::prop(fact) == wanted).map(|(label, _)| label.to_string())
    }

    /// Shows a comparison of which derivatives are carried out: that one by evaluation, this one as the same.
    fn with_derivatives(&mut self, p: &Prop) -> Option<Label> {
        let PropKind::Compare(sides, relations) = &p.kind else { return None };
        let show =
            Show { label: String::new(), rule: Rule::Evaluate, prop: p.clone(), by: Vec::new(), using: Vec::new() };
        let sides: Option<Vec<Expr>> =
            sides.iter().map(|e| Some(self.checker.view(e, &show, false).ok()?.expr())).collect();
        let plain = prop(PropKind::Compare(sides?, relations.clone()));
        let fact = self.evaluate(&plain)?;
        self.values_of_parts(p);
        let terms = vec![Term { facts: vec![fact], factor: numeral(1) }];
        let rule = Rule::Combination { times: None, terms };
        self.step(rule.clone(), p, true, true).or_else(|| self.step(rule, p, true, false))
    }

    /// Shows what the parts of a comparison need for their values, so that it can be cited.
    fn values_of_parts(&mut self, p: &Prop) {
        let (mut list, mut bound) = (Vec::new(), Vec::new());
        exprs_of(p, &mut bound, &mut list);
        for (e, _) in list.into_iter().take(TRIES).filter(|(_, bound)| bound.is_empty()) {
            for need in needs(&e, &|_| false).into_iter().flatten() {
                let shown = match need {
                    Need::NotZero(e) => compare(e, Relation::NotEqual, numeral(0)),
                    Need::Positive(e) | Need::NotNegative(e) => compare(e, Relation::Greater, numeral(0)),
                    Need::NotZeroOrNatural(..) | Need::Range(..) | Need::Differentiable(..) => continue,
                };
                if self.known(&shown).is_none()
                    && let Some(label) = self.evaluate(&shown)
                {
                    self.read.push(label);
                }
            }
        }
    }

    /// The certificate, if the kernel accepts it from nothing.
    fn finished(self, claim: &Claim) -> Option<Certificate> {
        let mut certificate = Certificate {
            claim: claim.name.text.clone(),
            statement: digest(&self.checker.statement().text()),
            refutes: Some(self.refutes),
            steps: self.steps,
        };
        let kept = needed(&certificate).steps;
        let mut place = 0..;
        certificate.steps.retain(|_| place.next().is_some_and(|place| kept.contains(&place)));
        matches!(check(claim, &certificate, &[]), kernel::Verdict::Refuted).then_some(certificate)
    }
}

/// The comparisons, each of two sides, the limits and the quantified parts of a proposition.
fn atoms_of(p: &Prop, out: &mut Vec<Prop>) {
    let mut add = |p: Prop| {
        if !out.iter().any(|q| key::prop(q) == key::prop(&p)) {
            out.push(p);
        }
    };
    match &p.kind {
        PropKind::Compare(sides, relations) => {
            for (pair, relation) in sides.windows(2).zip(relations) {
                if let [a, b] = pair {
                    add(compare(a.clone(), *relation, b.clone()));
                }
            }
        }
        PropKind::Limit(_) | PropKind::Exists(..) | PropKind::ForAll(..) => add(p.clone()),
        PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => {
            list.iter().for_each(|p| atoms_of(p, out));
        }
        PropKind::Not(p) => atoms_of(p, out),
        PropKind::Implies(p, q) => [p, q].into_iter().for_each(|p| atoms_of(p, out)),
        PropKind::Extremum(_) | PropKind::WrittenLimit(_) => {}
    }
}

/// The variables that grow in the limits of a goal.
fn moving(p: &Prop) -> Vec<String> {
    let mut atoms = Vec::new();
    let mut inner = p;
    while let PropKind::ForAll(_, body) = &inner.kind {
        inner = body;
    }
    atoms_of(inner, &mut atoms);
    let names = atoms.into_iter().filter_map(|p| match p.kind {
        PropKind::Limit(limit) => Some(limit.variable.text),
        _ => None,
    });
    names.collect()
}

/// The indices bound around an expression.
type Bound = Vec<String>;

/// The expressions of a proposition with the indices bound around each, parts first.
fn exprs_of(p: &Prop, bound: &mut Bound, out: &mut Vec<(Expr, Bound)>) {
    match &p.kind {
        PropKind::Compare(sides, _) => sides.iter().for_each(|e| parts_of(e, bound, out)),
        PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => {
            list.iter().for_each(|p| exprs_of(p, bound, out));
        }
        PropKind::Not(p) | PropKind::ForAll(_, p) => exprs_of(p, bound, out),
        PropKind::Implies(p, q) => [p, q].into_iter().for_each(|p| exprs_of(p, bound, out)),
        PropKind::Extremum(e) => {
            [&e.of, &e.value].into_iter().chain(e.at.iter().map(|a| &a.1)).for_each(|e| parts_of(e, bound, out));
            // Its value at the point, too.
            let mut there = Substitution::default();
            e.at.iter().for_each(|(n, value)| there.replace(&n.text, value));
            there.expr(&e.of).iter().for_each(|e| parts_of(e, bound, out));
        }
        PropKind::Exists(..) | PropKind::Limit(_) | PropKind::WrittenLimit(_) => {}
    }
}

fn parts_of(e: &Expr, bound: &mut Bound, out: &mut Vec<(Expr, Bound)>) {
    match &e.kind {
        ExprKind::Number(_) | ExprKind::Name(_) => return,
        ExprKind::SumOver(index, body) | ExprKind::ProductOver(index, body) | ExprKind::IntegralOver(index, body) => {
            [&index.from, &index.to].into_iter().for_each(|e| parts_of(e, bound, out));
            bound.push(index.name.text.clone());
            parts_of(body, bound, out);
            bound.pop();
        }
        _ => crate::refute::expand::parts(e, &mut |part| parts_of(part, bound, out)),
    }
    out.push((e.clone(), bound.clone()));
}

/// Whether a derivative stands in a proposition.
fn differentiates(p: &Prop) -> bool {
    let (mut list, mut bound) = (Vec::new(), Vec::new());
    exprs_of(p, &mut bound, &mut list);
    list.iter().any(|(e, _)| matches!(e.kind, ExprKind::Derivative(..)))
}

/// Values for indices, small ones first.
fn choices(bound: &Bound) -> Vec<Vec<(String, u32)>> {
    let mut out: Vec<Vec<(String, u32)>> = vec![Vec::new()];
    for name in bound {
        let most = if bound.len() > 2 { 3 } else { INDICES };
        out = (0..most)
            .flat_map(|k| out.iter().map(move |chosen| chosen.iter().cloned().chain([(name.clone(), k)]).collect()))
            .collect();
    }
    out
}
