//! Marks of a check: what is known after going back to one, and what a step is told of facts that others cited.

use carom::certificate::{Rule, Show, Step};
use carom::claim::parse::parse;
use carom::kernel::Checker;

/// A checker of a claim, whose statements below are read from its own hypotheses.
fn checker(text: &str) -> Option<Checker> {
    let claims = parse(&format!("claim trial \"A trial\"\n{text}\n")).ok()?;
    Checker::new(claims.first()?, &[]).ok()
}

/// A proposition over x.
fn says(text: &str) -> Option<carom::claim::syntax::Prop> {
    let claims = parse(&format!("claim trial \"A trial\"\ngiven x real\nprove {text}\n")).ok()?;
    Some(Checker::new(claims.first()?, &[]).ok()?.statement().goal.clone())
}

fn show(label: &str, rule: Rule, text: &str, by: &[&str]) -> Option<Step> {
    let by = by.iter().map(|l| (*l).to_string()).collect();
    let show = Show { label: label.to_string(), rule, prop: says(text)?, by, using: Vec::new() };
    Some(Step::Show(Box::new(show)))
}

fn plain() -> Rule {
    Rule::Combination { times: None, terms: Vec::new() }
}

fn facts(checker: &Checker) -> Vec<&str> {
    checker.facts().map(|f| f.0).collect()
}

#[test]
fn what_a_block_supposes_is_not_known_when_it_was_left() -> Result<(), Box<dyn std::error::Error>> {
    let mut checker = checker("given x real\nprove x^2 >= 0").ok_or("a claim")?;
    let before = checker.mark();
    let open = show("1", Rule::Suppose, "x > 1 => x > 0", &[]).ok_or("a step")?;
    checker.step(&open).map_err(|r| format!("{r:?}"))?;
    let inside = checker.mark();
    checker.step(&show("2", plain(), "x > 0", &["1s"]).ok_or("a step")?).map_err(|r| format!("{r:?}"))?;
    checker.step(&Step::End("2".to_string())).map_err(|r| format!("{r:?}"))?;
    // The block of this mark is closed: its supposition must not come back.
    checker.back_to(&inside);
    assert_eq!(facts(&checker), ["1"]);
    assert!(checker.step(&show("3", plain(), "x > 0", &["1"]).ok_or("a step")?).is_err());
    checker.back_to(&before);
    assert!(facts(&checker).is_empty());
    // Left while it is open.
    checker.step(&open).map_err(|r| format!("{r:?}"))?;
    checker.back_to(&before);
    assert!(facts(&checker).is_empty());
    assert!(checker.step(&Step::End("1s".to_string())).is_err(), "no block is open");
    Ok(())
}

#[test]
fn a_fact_that_was_cited_before_is_not_known_to_a_step_that_does_not_cite_it() -> Result<(), Box<dyn std::error::Error>>
{
    let hypotheses: Vec<String> = (6..=16).map(|k| format!("assume x != {k}")).collect();
    let text = format!("given x real\n{}\nassume x > 5\nprove x > 0", hypotheses.join("\n"));
    let mut checker = checker(&text).ok_or("a claim")?;
    let labels: Vec<String> = (1..=12).map(|k| format!("h{k}")).collect();
    let labels: Vec<&str> = labels.iter().map(String::as_str).collect();
    assert!(checker.step(&show("1", plain(), "x - 5 > 0", &labels).ok_or("a step")?).is_ok());
    let (first, last) = (&labels[..11], &labels[1..]);
    for (by, text) in [(first, "x - 5 > 0"), (last, "x - 6 != 0")] {
        let step = show("2", plain(), text, by).ok_or("a step")?;
        assert!(checker.step(&step).is_err(), "{text} by {by:?}");
    }
    assert!(checker.step(&show("2", plain(), "x - 6 != 0", first).ok_or("a step")?).is_ok());
    assert!(checker.step(&show("3", plain(), "x - 5 > 0", last).ok_or("a step")?).is_ok());
    Ok(())
}
