//! Nothing false is ever proved: statements of the catalogue are changed one place at a time.
//!
//! A changed statement may still be true (a weaker bound, a sign of a square); then it may be
//! proved. What must not happen is that one is proved which is false at some exact point. The points
//! come from the evaluator, which shares only the syntax tree with the prover.

use crate::support::whole;
use carom::claim::embedded;
use carom::claim::syntax::*;
use carom::judge::hand::AtHand;
use carom::judge::{Settings, one_of};
use carom::refute::catalogue::{Catalogue, Limits};
use carom::refute::counterexample;
use carom::refute::expand::Statement;
use carom::refute::outcome::Verdict;

/// Changes the n-th place of a statement that can be changed; false when there is no n-th place.
struct Mutation {
    left: usize,
    kind: usize,
    done: bool,
}

impl Mutation {
    fn here(&mut self) -> bool {
        if self.done {
            return false;
        }
        if self.left == 0 {
            self.done = true;
            return true;
        }
        self.left -= 1;
        false
    }

    fn expr(&mut self, e: &mut Expr) {
        match &mut e.kind {
            ExprKind::Number(text) => {
                if self.here()
                    && let Ok(n) = text.parse::<u32>()
                {
                    *text = (n + 1).to_string();
                }
            }
            ExprKind::Name(_) => {}
            ExprKind::Apply(_, list) => list.iter_mut().for_each(|a| self.expr(a)),
            ExprKind::Negate(a) => self.expr(a),
            ExprKind::Sum(list) => {
                for (i, (sign, summand)) in list.iter_mut().enumerate() {
                    if i > 0 && self.here() {
                        *sign = if *sign == Sign::Plus { Sign::Minus } else { Sign::Plus };
                    }
                    self.expr(summand);
                }
            }
            ExprKind::Product(list) => {
                for (i, (operator, factor)) in list.iter_mut().enumerate() {
                    if i > 0 && self.kind == 1 && self.here() {
                        *operator = if *operator == Factor::Times { Factor::Over } else { Factor::Times };
                    }
                    self.expr(factor);
                }
            }
            ExprKind::Power(a, b) => {
                self.expr(a);
                self.expr(b);
            }
            ExprKind::SumOver(index, body)
            | ExprKind::ProductOver(index, body)
            | ExprKind::IntegralOver(index, body) => {
                self.expr(&mut index.to);
                self.expr(body);
            }
            ExprKind::Derivative(body, _) => self.expr(body),
            ExprKind::Matrix(rows) => rows.iter_mut().flatten().for_each(|x| self.expr(x)),
        }
    }

    fn prop(&mut self, p: &mut Prop) {
        match &mut p.kind {
            PropKind::Compare(sides, relations) => {
                for relation in relations.iter_mut() {
                    if self.here() {
                        *relation = match relation {
                            Relation::Equal => Relation::Less,
                            Relation::NotEqual => Relation::Equal,
                            Relation::Less => Relation::Greater,
                            Relation::LessEqual => Relation::Greater,
                            Relation::Greater => Relation::LessEqual,
                            Relation::GreaterEqual => Relation::Less,
                        };
                    }
                }
                sides.iter_mut().for_each(|e| self.expr(e));
            }
            PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => {
                list.iter_mut().for_each(|q| self.prop(q))
            }
            PropKind::Not(q) => self.prop(q),
            PropKind::Implies(a, b) => {
                self.prop(a);
                self.prop(b);
            }
            PropKind::Exists(_, body) | PropKind::ForAll(_, body) => self.prop(body),
            PropKind::Extremum(x) => {
                self.expr(&mut x.of);
                self.expr(&mut x.value);
                x.at.iter_mut().for_each(|(_, e)| self.expr(e));
            }
            PropKind::Limit(l) => {
                self.expr(&mut l.of);
                self.expr(&mut l.value);
            }
            PropKind::WrittenLimit(l) => l.parts_mut().for_each(|e| self.expr(e)),
        }
    }
}

/// The mutants of a claim: a place of the goal, of a definition or of a hypothesis changed, or a
/// hypothesis dropped.
fn mutants(claim: &Claim) -> Vec<Claim> {
    let mut out = Vec::new();
    for kind in 0..2 {
        for place in 0.. {
            let mut changed = claim.clone();
            let mut mutation = Mutation { left: place, kind, done: false };
            mutation.prop(&mut changed.goal);
            for item in &mut changed.items {
                match item {
                    Item::Let { value, .. } => mutation.expr(value),
                    Item::Assume { prop, .. } => mutation.prop(prop),
                    _ => {}
                }
            }
            if !mutation.done {
                break;
            }
            out.push(changed);
        }
    }
    for place in 0..claim.items.len() {
        if matches!(claim.items[place], Item::Assume { .. }) {
            let mut changed = claim.clone();
            changed.items.remove(place);
            out.push(changed);
        }
    }
    out
}

/// What became of the mutants of some claims.
#[derive(Default)]
struct Tally {
    total: usize,
    refuted: usize,
    proved: usize,
    open: Vec<String>,
    wrong: Vec<String>,
}

#[test]
fn no_changed_statement_that_is_false_somewhere_is_proved() {
    let all = embedded::claims(&[]).expect("the catalogue parses").expect("all claims");
    // The catalogue has more places than a test run has time: every claim gives its share.
    let share = match std::env::var("CAROM_MUTANTS") {
        Ok(share) => share.parse().expect("CAROM_MUTANTS is a number"),
        Err(_) if whole() => 2,
        Err(_) => 1,
    };
    let hand = AtHand::of(embedded::certificates());
    let next = std::sync::atomic::AtomicUsize::new(0);
    let proved: Vec<&Claim> = all.iter().filter(|c| c.expect == Expectation::Proved).collect();
    let work = || {
        let mut tally = Tally::default();
        while let Some(claim) = proved.get(next.fetch_add(1, std::sync::atomic::Ordering::Relaxed)) {
            judge_mutants(claim, &all, &hand, share, &mut tally);
        }
        tally
    };
    let tallies: Vec<Tally> = std::thread::scope(|scope| {
        let cores = std::thread::available_parallelism().map_or(1, usize::from);
        // The evaluator recurses over trees, and so does the search.
        let worker = |_| std::thread::Builder::new().stack_size(64 << 20).spawn_scoped(scope, work).expect("a thread");
        let workers: Vec<_> = (0..cores).map(worker).collect();
        workers.into_iter().map(|worker| worker.join().expect("no mutant makes the search fail")).collect()
    });
    let sum = |count: &dyn Fn(&Tally) -> usize| tallies.iter().map(count).sum::<usize>();
    let (total, refuted) = (sum(&|t| t.total), sum(&|t| t.refuted));
    let open: Vec<&String> = tallies.iter().flat_map(|t| &t.open).collect();
    let wrong: Vec<&String> = tallies.iter().flat_map(|t| &t.wrong).collect();
    let (proved, undecided) = (sum(&|t| t.proved), open.len());
    println!("{open:#?}");
    println!("{total} mutants: {refuted} refuted, {proved} still true and proved, {undecided} undecided");
    assert!(wrong.is_empty(), "proved although false:\n{wrong:#?}");
    assert!(total >= 50 * share.min(10), "only {total} mutants");
    assert!(refuted * 100 >= total * 84, "too few refuted: {refuted} of {total}");
}

/// Judges about `share` mutants of one claim.
fn judge_mutants(claim: &Claim, all: &[Claim], hand: &AtHand, share: usize, tally: &mut Tally) {
    let name = claim.name.text.clone();
    let list = mutants(claim);
    let step = (list.len() / share).max(1);
    // What cites the changed claim is left out.
    let mut gone = vec![name.clone()];
    while let Some(more) =
        all.iter().find(|c| c.using.iter().any(|u| gone.contains(&u.text)) && !gone.contains(&c.name.text))
    {
        gone.push(more.name.text.clone());
    }
    let rest: Vec<Claim> = all.iter().filter(|c| !gone.contains(&c.name.text)).cloned().collect();
    let limits = Limits { steps: 30_000, time: std::time::Duration::from_secs(1), ..Limits::default() };
    let settings = Settings { limits, ..Settings::default() };
    for (place, mutant) in list.into_iter().enumerate().filter(|(i, _)| i % step == 0) {
        let catalogue = Catalogue::new(rest.iter().cloned().chain([mutant.clone()]).collect());
        let catalogue = catalogue.expect("names and citations are in order");
        tally.total += 1;
        let said = || format!("{name}#{place}: {}", carom::claim::print::prop(&mutant.goal));
        match one_of(&catalogue, &name, hand, &settings).map(|entry| entry.outcome) {
            Err(_) => tally.refuted += 1,
            Ok(outcome) => match outcome.verdict {
                Verdict::Refuted => tally.refuted += 1,
                Verdict::Undecided => {
                    tally.open.push(format!("{} [{}]", said(), outcome.reason.unwrap_or_default()));
                }
                Verdict::Proved => {
                    tally.proved += 1;
                    let statement = Statement::of(&mutant).expect("within limits");
                    if let Some(witness) = counterexample::falsified(&statement, None) {
                        tally.wrong.push(format!("{} at {:?}", said(), witness.point));
                    }
                }
            },
        }
    }
}
