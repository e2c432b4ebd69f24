//! The form of a statement does not decide its verdict: as a goal, as a `have`, in a `case`, with hypotheses in another order,
//! and said with other connectives or nested quantifiers.

use crate::support::{at_least, sample};
use carom::claim::parse::parse;
use carom::claim::syntax::{Claim, Expectation, Name, Proof, Prop, Span, Step};
use carom::judge::outcome_of;
use carom::refute::catalogue::{Catalogue, Limits};
use std::fs;
use std::path::Path;
use std::time::Duration;

/// Every so many claims of the corpus are asked in all forms.
const EVERY: usize = 5;

/// The verdict, or why there is none.
fn verdict(claim: &Claim) -> Result<&'static str, String> {
    let limits = Limits { time: Duration::from_secs(9), steps: 40_000, ..Limits::default() };
    let catalogue = Catalogue::new(vec![claim.clone()]).map_err(|f| f[0].1.message().clone())?;
    outcome_of(&catalogue, &claim.name.text, &limits).map(|o| o.verdict.name()).map_err(|f| format!("{f:?}"))
}

fn label(text: &str) -> Name {
    Name { text: text.to_owned(), span: Span::default() }
}

/// The claim with its goal shown as a fact first.
fn as_have(claim: &Claim) -> Claim {
    let step = Step::Have { label: label("whole_goal"), prop: claim.goal.clone(), proof: Proof::default() };
    Claim { proof: Proof { steps: vec![step], close: None }, ..claim.clone() }
}

/// The claim in a single case, which always holds.
fn in_a_case(claim: &Claim) -> Claim {
    let case = |name: &str, prop: Prop| Step::Case { label: label(name), prop, proof: Proof::default() };
    let texts = [("lower_case", "0 < 1"), ("upper_case", "0 >= 1")];
    let steps = texts.map(|(name, text)| case(name, carom::claim::parse::parse_prop(text).unwrap()));
    Claim { proof: Proof { steps: steps.to_vec(), close: None }, ..claim.clone() }
}

/// The claim in this text with its lines of hypotheses in the opposite order; nothing if it has less than two.
fn reordered(text: &str) -> Option<Claim> {
    let is_assumed = |line: &&str| line.starts_with("assume ");
    let mut assumed: Vec<&str> = text.lines().filter(is_assumed).collect();
    let several = assumed.len() > 1;
    let lines: Option<Vec<&str>> = text.lines().map(|l| if is_assumed(&l) { assumed.pop() } else { Some(l) }).collect();
    // In another order a hypothesis may have no value by those before it.
    several.then(|| parse(&lines?.join("\n")).ok()?.pop())?
}

/// Claims of the corpus that are proved without an argument, each with its text.
fn claims() -> Vec<(String, Claim)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus");
    let decided = fs::read_to_string(folder.join("decided.txt")).unwrap();
    let mut paths: Vec<_> = fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()).collect();
    paths.retain(|p| p.extension().is_some_and(|e| e == "claim"));
    paths.sort();
    let files: String = paths.iter().map(|p| fs::read_to_string(p).unwrap()).collect();
    let texts = files.split("\nclaim ").skip(1).map(|t| format!("claim {t}"));
    let all = texts.map(|t| (t.clone(), parse(&t).unwrap().remove(0)));
    let is_listed = |c: &Claim| decided.lines().any(|l| l == format!("{}: proved", c.name.text));
    all.filter(|(_, c)| c.proof.is_empty() && c.expect == Expectation::Proved && is_listed(c)).step_by(EVERY).collect()
}

#[test]
fn a_goal_is_proved_as_a_fact_in_a_case_and_with_reordered_hypotheses_or_not_at_all() {
    let mut differing = Vec::new();
    let mut asked = 0;
    for (text, claim) in sample(claims()) {
        let mut forms = vec![("as a fact", as_have(&claim)), ("in a case", in_a_case(&claim))];
        forms.extend(reordered(&text).map(|c| ("reordered", c)));
        for (form, claim) in forms {
            asked += 1;
            let found = verdict(&claim);
            if found.as_deref() != Ok("proved") {
                differing.push(format!("{} {form}: {found:?}", claim.name.text));
            }
        }
    }
    assert!(asked > at_least(150), "only {asked} forms were asked");
    assert!(differing.is_empty(), "{differing:#?}");
}

#[test]
fn statements_that_say_the_same_have_one_verdict() {
    let pairs = [
        (
            "prove exists x real: exists y real: x + y = 3 and x - y = 1",
            "prove exists x, y real: x + y = 3 and x - y = 1",
        ),
        ("prove exists x real: exists y real: x*y = 6 and x + y = 5", "prove exists x, y real: x*y = 6 and x + y = 5"),
        (
            "given x, y real\nassume x > y\nassume y > 1\nprove not x < 1",
            "given x, y real\nprove not (x > y and y > 1 and x < 1)",
        ),
        (
            "given a, b > 0\nassume a*b >= 1\nassume a < 1\nprove not b < 1",
            "given a, b > 0\nprove not (a*b >= 1 and a < 1 and b < 1)",
        ),
        ("given x real\nassume 1000 + 2000 < x\nprove x > 2", "given x real\nassume 3000 < x\nprove x > 2"),
        ("given x real\nprove x > 1 => x > 0", "given x real\nassume x > 1\nprove x > 0"),
        ("given x real\nprove x <= 1 or x > 0", "given x real\nprove not (x > 1 and x <= 0)"),
    ];
    let mut differing = Vec::new();
    for text in pairs.iter().flat_map(|(first, second)| [first, second]) {
        let found = verdict(&parse(&format!("claim c \"c\"\n{text}\n")).unwrap()[0]);
        if found.as_deref() != Ok("proved") {
            differing.push(format!("{text}: {found:?}"));
        }
    }
    assert!(differing.is_empty(), "{differing:#?}");
}
