//! `carom referee`: its scenes, and what it finds in right and wrong results.

use crate::support::{text, with_input};
use carom::referee::judge::{Answer, Finding, Given, Law, Measure, judge};
use carom::referee::{Reference, scenes};
use malachite::Rational;
use std::path::Path;
use std::process::Command;

/// The right answer, from the reference.
fn right(reference: &Reference) -> Answer {
    let all = |list: &[carom::referee::Known]| list.iter().map(|k| Given::Number(k.lo.clone())).collect();
    let due = || reference.instants.iter().flatten();
    Answer {
        velocities: all(&reference.ends[0].velocities),
        positions: all(&reference.ends[0].positions),
        pairs: Some(due().map(|due| due.pair).collect()),
        times: due().map(|due| Given::Number(due.time.lo.clone())).collect(),
        count: reference.count,
    }
}

fn named<'a>(all: &'a [Reference], name: &str) -> &'a Reference {
    all.iter().find(|reference| reference.scene.name == name).expect(name)
}

#[test]
fn the_scenes_cover_what_simulators_get_wrong_and_obey_the_laws() {
    let all = scenes().expect("the file is sound");
    assert!(all.len() >= 100, "{}", all.len());
    for group in [
        "two bodies",
        "chains",
        "walls",
        "rods",
        "touching",
        "sticking",
        "collapse",
        "measured",
        "extreme",
        "simultaneous",
    ] {
        assert!(all.iter().filter(|r| r.scene.group == group).count() >= 7, "{group}");
    }
    for reference in &all {
        let scene = &reference.scene;
        assert_eq!(all.iter().filter(|other| other.scene.name == scene.name).count(), 1, "{}", scene.name);
        let momentum = |v: Vec<&Rational>| {
            scene.bodies.iter().zip(v).fold(Rational::from(0), |sum, (body, v)| sum + &body.mass * v)
        };
        let energy = |v: Vec<&Rational>| {
            scene.bodies.iter().zip(v).fold(Rational::from(0), |sum, (body, v)| sum + &body.mass * v * v)
        };
        let start: Vec<&Rational> = scene.bodies.iter().map(|body| &body.velocity).collect();
        let elastic =
            scene.restitution.iter().chain(scene.walls.iter().flatten().map(|w| &w.restitution)).all(|e| *e == 1);
        for end in &reference.ends {
            let exact: Option<Vec<&Rational>> = end.velocities.iter().map(|k| k.value.rational()).collect();
            let Some(exact) = exact else { continue };
            if scene.walls.iter().all(Option::is_none) {
                assert_eq!(momentum(exact.clone()), momentum(start.clone()), "{}", scene.name);
            }
            let (before, after) = (energy(start.clone()), energy(exact));
            assert!(after <= before && (!elastic || after == before), "{}", scene.name);
        }
    }
    let several = all.iter().filter(|r| r.ends.len() > 1).count();
    let endless = all.iter().filter(|r| r.count.is_none() && r.ends.len() == 1).count();
    assert!(several >= 3 && endless >= 10, "{several} {endless}");
    // By hand: equations (1) and (4) for equal masses and e = 1/2; Galperin's 31.
    let half = &named(&all, "two-equal-half").ends[0].velocities;
    assert_eq!((half[0].lo.to_string(), half[1].lo.to_string()), ("1/4".to_owned(), "3/4".to_owned()));
    assert_eq!(named(&all, "wall-pi-100").count, Some(31));
}

#[test]
fn right_answers_are_right_and_every_fault_is_found() {
    for reference in &scenes().expect("the file is sound") {
        let name = &reference.scene.name;
        let answer = right(reference);
        assert_eq!(judge(reference, Some(&answer), 30), [], "{name}");
        assert_eq!(judge(reference, None, 9), [Finding::NoAnswer]);
        // The fastest body, wrong in the eighth digit of its velocity.
        let speeds = reference.ends[0].velocities.iter().map(|k| k.lo.clone());
        let fastest = speeds.enumerate().max_by_key(|(_, v)| (v * v, v.clone())).expect("a body").0;
        let mut wrong = answer.clone();
        let off = &reference.ends[0].velocities[fastest].lo * Rational::from_signeds(1, 10_000_000);
        wrong.velocities[fastest] = Given::Number(&reference.ends[0].velocities[fastest].lo + off);
        let found = judge(reference, Some(&wrong), 9);
        let speed = &reference.ends[0].velocities[fastest].lo;
        let largest = reference.scene.bodies.iter().map(|b| &b.velocity).all(|v| v * v <= speed * speed);
        if largest {
            let digits: Vec<Option<u64>> = found
                .iter()
                .filter_map(|f| match f {
                    Finding::Number { what: Measure::Velocity, digit, .. } => Some(*digit),
                    _ => None,
                })
                .collect();
            assert!(matches!(digits.as_slice(), [Some(7 | 8)]), "{name}: {found:?}");
        }
        assert!(judge(reference, Some(&wrong), 5).is_empty(), "{name}");
        let mut strange = answer.clone();
        strange.velocities[0] = Given::Strange("nan".to_owned());
        assert!(!judge(reference, Some(&strange), 1).is_empty(), "{name}");
        let listed = answer.pairs.clone().expect("a list");
        if let Some((_, fewer)) = listed.split_last() {
            let fewer = Answer { pairs: Some(fewer.to_vec()), ..answer.clone() };
            assert!(matches!(judge(reference, Some(&fewer), 9).as_slice(), [Finding::Count { .. }]), "{name}");
        }
        if let Some(count) = reference.count {
            let more = Answer { count: Some(count + 1), ..answer.clone() };
            assert!(matches!(judge(reference, Some(&more), 9).as_slice(), [Finding::Count { .. }]), "{name}");
        }
    }
}

#[test]
fn order_counts_where_bodies_are_shared_and_time_differs() {
    let all = scenes().expect("the file is sound");
    let swapped = |name: &str, a: usize, b: usize| {
        let reference = named(&all, name);
        let mut answer = right(reference);
        answer.pairs.as_mut().expect("a list").swap(a, b);
        judge(reference, Some(&answer), 9)
    };
    assert!(swapped("same-instant-two-pairs", 0, 1).is_empty(), "separate pairs at one instant commute");
    assert!(swapped("same-instant-three-pairs", 0, 2).is_empty());
    assert!(
        matches!(swapped("chain-equal-3-elastic", 0, 1).as_slice(), [Finding::Order { number: 1, given: 2, right }] if *right == [1])
    );
    // At one instant as well, where a body is shared: the cradle.
    assert!(matches!(swapped("cradle-1-of-5", 1, 2).as_slice(), [Finding::Order { number: 2, given: 3, .. }]));
}

#[test]
fn each_end_of_a_contact_that_is_left_open_is_right_and_no_other() {
    let all = scenes().expect("the file is sound");
    let reference = named(&all, "same-instant-mirror-heavy");
    assert_eq!(reference.ends.len(), 2);
    for end in &reference.ends {
        let velocities = end.velocities.iter().map(|k| Given::Number(k.lo.clone())).collect();
        let answer = Answer { velocities, ..Answer::default() };
        assert_eq!(judge(reference, Some(&answer), 30), []);
    }
    // The mean of both, which is what a simultaneous treatment gives.
    let velocities = [-1, 0, 1].map(|v| Given::Number(Rational::from(v))).to_vec();
    let answer = Answer { velocities, ..Answer::default() };
    assert!(!judge(reference, Some(&answer), 9).is_empty());
}

#[test]
fn a_balance_is_named_for_what_happened_to_it() {
    let all = scenes().expect("the file is sound");
    let laws = |velocities: [&str; 2]| -> Vec<(Law, bool)> {
        let list = velocities.map(|v| Given::Number(carom::number::rational::parse(v).expect(v))).to_vec();
        let found = judge(named(&all, "two-equal-half"), Some(&Answer { velocities: list, ..Answer::default() }), 9);
        let balance = |f: &Finding| match f {
            Finding::Balance { law, given, right } => Some((*law, given > right)),
            _ => None,
        };
        found.iter().filter_map(balance).collect()
    };
    // e applied to energy; e as damping of an elastic collision.
    assert_eq!(laws(["0.146446609406726", "0.853553390593274"]), [(Law::Energy, true)]);
    assert_eq!(laws(["0", "0.5"]), [(Law::Momentum, false), (Law::Energy, false)]);
    assert_eq!(laws(["1/4", "3/4"]), []);
}

#[test]
fn the_careful_simulator_passes_and_the_mistaken_one_does_not() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("scenes.json").display().to_string();
    assert_eq!(with_input(&["referee", "--scenes", "-o", &file], "").status.code(), Some(0));
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/referee");
    let simulated = |program: &str, mistake: &[&str]| {
        let path = examples.join(program);
        let out = Command::new("python3").arg(path).arg(&file).args(mistake).output().expect("Python runs");
        assert!(out.status.success(), "{}", text(&out.stderr));
        text(&out.stdout)
    };
    let judged = |results: &str| {
        let out = with_input(&["referee", "-", "--format", "json"], results);
        let value: serde_json::Value = serde_json::from_slice(&out.stdout).expect("JSON");
        (out.status.code(), value)
    };
    let (code, value) = judged(&simulated("careful.py", &[]));
    assert_eq!((code, &value["wrong"], &value["missing"]), (Some(0), &0.into(), &0.into()), "{value}");
    let kinds = |value: &serde_json::Value, scene: &str| -> Vec<String> {
        let entry = value["scenes"].as_array().expect("a list").iter().find(|s| s["scene"] == scene).expect(scene);
        let findings = entry["findings"].as_array().expect("a list").iter();
        findings.map(|f| f["kind"].as_str().expect("a word").to_owned()).collect()
    };
    let (code, energy) = judged(&simulated("mistaken.py", &[]));
    assert_eq!(code, Some(1));
    assert_eq!(kinds(&energy, "two-equal-half"), ["velocity", "velocity", "energy"]);
    assert_eq!(kinds(&energy, "two-equal-elastic"), [""; 0], "with e = 1 the mistake does not show");
    assert!(kinds(&energy, "chain-all-moving").contains(&"order".to_owned()));
    assert!(!kinds(&energy, "cradle-inelastic").is_empty(), "contacts of three");
    let (_, damping) = judged(&simulated("mistaken.py", &["damping"]));
    assert_eq!(kinds(&damping, "two-equal-half"), ["velocity", "velocity", "momentum", "energy"]);
}

#[test]
fn the_answers_it_writes_are_those_it_accepts() {
    let answers = text(&with_input(&["referee", "--answers"], "").stdout);
    let out = with_input(&["referee", "-", "--digits", "18"], &answers);
    assert_eq!(out.status.code(), Some(0), "{}", text(&out.stdout));
    // One group of them, as a simulator without walls would have it.
    let out = with_input(&["referee", "-", "--only", "two bodies", "--only", "chains"], &answers);
    assert!(text(&out.stdout).contains("40 scenes, to 9 digits: 40 right"), "{}", text(&out.stdout));
    let first: Vec<&str> = answers.lines().take(3).collect();
    let out = with_input(&["referee", "-"], &first.join("\n"));
    assert_eq!(out.status.code(), Some(1));
    assert!(text(&out.stdout).contains("2 right, 0 wrong, 115 without a result"), "{}", text(&out.stdout));
}

#[test]
fn bad_results_are_errors_with_line_and_column() {
    for (results, sign) in [
        ("", "no heading; write for instance: scene,velocities"),
        ("name,velocities\n", "the columns scene and velocities are required; the columns are name, velocities"),
        (
            "scene,velocities\ntwo-equal-halb,1 2\n",
            "-:2: column 1 (scene): no scene is called two-equal-halb; did you mean two-equal-half?",
        ),
        (
            "scene,velocities\ntwo-equal-half,1\n",
            "-:2: column 2 (velocities): expected 2 numbers, one for each body, found 1",
        ),
        ("scene,velocities\ntwo-equal-half,1 x\n", "-:2: column 2 (velocities): \"x\""),
        ("scene,velocities\ntwo-equal-half,\"1, 2\"\n", "-:2: column 2 (velocities): \"1,\""),
        ("scene,velocities,count\ntwo-equal-half,1 2,1.5\n", "-:2: column 3 (count): \"1.5\" is not a whole number"),
        ("scene,velocities,collisions\ntwo-equal-half,1 2,12\n", "-:2: column 3 (collisions): \"12\" is not a pair"),
        ("scene,velocities,collisions\ntwo-equal-half,1 2,1-3\n", "neighbours collide"),
        ("scene,velocities\ntwo-stop,0 1\n\ntwo-stop,0 1\n", "-:4: column 1 (scene): two-stop already has a result"),
        ("scene,velocities\ntwo-stop\n", "line 2: 1 fields where the heading has 2"),
    ] {
        let out = with_input(&["referee", "-"], results);
        let said = text(&out.stderr);
        assert_eq!(out.status.code(), Some(2), "{results:?}: {said}");
        assert!(said.starts_with("error: ") && said.contains(sign) && out.stdout.is_empty(), "{results:?}: {said}");
    }
    let out = with_input(&["referee", "-"], "scene,velocities\ntwo-stop,0 1e99999\n");
    assert_eq!(out.status.code(), Some(3), "{}", text(&out.stderr));
    for (arguments, sign) in [
        (vec!["referee"], "<RESULTS>"),
        (vec!["referee", "/nonexistent.csv"], "cannot read"),
        (vec!["referee", "-", "--digits", "31"], "31 is not in 1..=30"),
        (vec!["referee", "--scenes", "--only", "chain"], "did you mean chains?"),
    ] {
        let out = with_input(&arguments, "");
        assert_eq!(out.status.code(), Some(2), "{arguments:?}");
        assert!(text(&out.stderr).contains(sign), "{}", text(&out.stderr));
    }
}
