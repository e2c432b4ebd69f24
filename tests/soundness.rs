//! Nothing false is ever proved: statements of the catalogue are changed one place at a time.
//!
//! A changed statement may still be true (a weaker bound, a sign of a square); then it may be
//! proved. What must not happen is that one is proved which is false at some exact point. The points
//! come from the evaluator, which shares only the syntax tree with the prover.

use carom::claim::embedded;
use carom::claim::syntax::*;
use carom::prove::catalogue::{Catalogue, Limits};
use carom::prove::expand::Statement;
use carom::prove::outcome::Verdict;
use carom::prove::refute;

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
            ExprKind::SumOver(index, body) | ExprKind::ProductOver(index, body) => {
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

#[test]
fn no_changed_statement_that_is_false_somewhere_is_proved() {
    // The evaluator recurses over trees; so does the prover.
    let worker = std::thread::Builder::new().stack_size(64 << 20).spawn(run).expect("a thread starts");
    worker.join().expect("no mutant makes the prover fail");
}

fn run() {
    let all = embedded::claims(&[]).expect("the catalogue parses").expect("all claims");
    // The catalogue has more places than a test run has time: every claim gives its share.
    let share = if std::env::var_os("CAROM_ALL_MUTANTS").is_some() { usize::MAX } else { 18 };
    let (mut total, mut refuted, mut proved, mut undecided, mut wrong) = (0, 0, 0, 0, Vec::new());
    let mut open = Vec::new();
    for claim in all.iter().filter(|c| c.expect == Expectation::Proved) {
        let list = mutants(claim);
        let step = (list.len() / share).max(1);
        for (place, mutant) in list.into_iter().enumerate().filter(|(i, _)| i % step == 0) {
            let mut claims: Vec<Claim> = all.iter().filter(|c| c.name.text != claim.name.text).cloned().collect();
            // What cites the changed claim is left out.
            let name = claim.name.text.clone();
            let mut gone = vec![name.clone()];
            loop {
                let before = gone.len();
                for c in &claims {
                    if c.using.iter().any(|u| gone.contains(&u.text)) && !gone.contains(&c.name.text) {
                        gone.push(c.name.text.clone());
                    }
                }
                if gone.len() == before {
                    break;
                }
            }
            claims.retain(|c| !gone.contains(&c.name.text));
            claims.push(mutant.clone());
            let mut catalogue = Catalogue::new(claims).expect("names and citations are in order");
            let limits = Limits { steps: 30_000, time: std::time::Duration::from_secs(2), ..Limits::default() };
            total += 1;
            match catalogue.audit(&name, &limits) {
                Err(_) => refuted += 1,
                Ok(outcome) => match outcome.verdict {
                    Verdict::Refuted => refuted += 1,
                    Verdict::Undecided => {
                        undecided += 1;
                        open.push(format!(
                            "{name}#{place}: {} [{}]",
                            carom::claim::print::prop(&mutant.goal),
                            outcome.reason.unwrap_or_default()
                        ));
                    }
                    Verdict::Proved => {
                        proved += 1;
                        let statement = Statement::of(&mutant).expect("within limits");
                        if let Some(witness) = refute::falsified(&statement, None) {
                            wrong.push(format!(
                                "{name}#{place}: {:?} at {:?}",
                                carom::claim::print::prop(&mutant.goal),
                                witness.point
                            ));
                        }
                    }
                },
            }
        }
    }
    println!("{total} mutants: {refuted} refuted, {proved} still true and proved, {undecided} undecided");
    println!("undecided:\n  {}", open.join("\n  "));
    assert!(wrong.is_empty(), "proved although false:\n{}", wrong.join("\n"));
    assert!(total >= 1_000, "only {total} mutants");
    assert!(refuted * 100 >= total * 84, "too few refuted: {refuted} of {total}");
}
