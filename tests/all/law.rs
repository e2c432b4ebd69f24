//! `carom test`: claims of the language at random exact points.

use crate::support::{carom, text};
use carom::property::law::{Assurance, Failure, Found, Outcome, Settings, law};
use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::{Config, TestRunner};

/// What becomes of a claim at so many points.
fn of(claim: &str, cases: u32, seed: u64) -> Outcome {
    let claim = law(claim).expect("it parses");
    claim.tried(&Settings { cases, seed, ..Settings::default() })
}

fn failure(claim: &str, seed: u64) -> Failure {
    match of(claim, 400, seed) {
        Outcome::Failed(failure) => failure,
        other => panic!("{claim}: {other:?}"),
    }
}

fn point(failure: &Failure) -> String {
    let values: Vec<String> =
        failure.witness.point.values.iter().map(|(name, value)| format!("{name} = {value}")).collect();
    values.join(", ")
}

#[test]
fn the_catalogue_holds_where_it_is_proved_and_fails_where_it_is_refuted() {
    let run = |arguments: &[&str]| {
        let out = carom(&[&["test", "--format", "json"], arguments].concat());
        let value: serde_json::Value = serde_json::from_slice(&out.stdout).expect("JSON");
        (out.status.code(), value)
    };
    let ids = |value: &serde_json::Value, word: &str| -> Vec<String> {
        let claims = value["claims"].as_array().expect("a list").iter().filter(|c| c["outcome"] == word);
        claims.map(|c| c["id"].as_str().expect("a name").to_owned()).collect()
    };
    let list: serde_json::Value = serde_json::from_slice(&carom(&["list", "--format", "json"]).stdout).expect("JSON");
    let expected = |word: &str| -> Vec<String> {
        let rows = list.as_array().expect("a list").iter().filter(|row| row["expected"] == word);
        rows.map(|row| row["id"].as_str().expect("a name").to_owned()).collect()
    };
    let refuted = expected("refuted");
    let (code, value) = run(&["--seed", "5", "--cases", "200", "--only", &refuted.join(",")]);
    assert_eq!((code, ids(&value, "counterexample")), (Some(0), refuted), "every refuted claim fails somewhere");
    // A few points of every other claim: none fails, and all but one are decided.
    let proved = expected("proved").join(",");
    let (code, value) = run(&["--seed", "6", "--cases", "12", "--only", &proved]);
    assert_eq!(ids(&value, "counterexample"), [""; 0]);
    assert_eq!(ids(&value, "untested"), ["u11"]);
    assert_eq!((code, value["unexpected"].as_u64()), (Some(3), Some(0)), "one that was asked for is not tried");
}

#[test]
fn a_failure_is_as_small_as_it_can_be_made() {
    for seed in 0..6 {
        let found = failure("given m1, m2 > 0;  e in [0, 1]\nprove (1 + e)*m1/(m1 + m2) <= 1", seed);
        assert_eq!(point(&found), "m1 = 2, m2 = 1, e = 1", "{seed}");
        assert_eq!((&*found.witness.broken[0].left, &*found.witness.broken[0].right), ("4/3", "1"));
    }
    // Velocities after a collision are computed from the two laws, not guessed.
    let laws = "given m1, m2, v > 0;  e in [0, 1];  w1, w2 real
        assume m1*v = m1*w1 + m2*w2
        assume w2 - w1 = e*v
        prove w2 < 3*v/2";
    let found = failure(laws, 1);
    let value = |name: &str| {
        let values = &found.witness.point.values;
        let text = &values.iter().find(|v| v.0 == name).expect(name).1;
        carom::number::rational::parse(text).expect("a number")
    };
    let (m1, m2, v, w1, w2) = (value("m1"), value("m2"), value("v"), value("w1"), value("w2"));
    assert_eq!(&m1 * &v, &m1 * &w1 + &m2 * &w2);
    assert_eq!(&w2 - &w1, value("e") * &v);
    assert!(&w2 + &w2 >= &v + &v + &v);
}

#[test]
fn bounds_that_depend_on_other_variables_and_natural_numbers_are_kept() {
    let Outcome::Held { points, open, late } = of(
        "given a > 0;  b in [a, 2*a];  n natural in 2..5;  mu(k) in (0, 1)
         prove b >= a and b^n <= 32*a^n and mu(n) < 1 and (n = 2 or n = 3 or n = 4 or n = 5)",
        300,
        3,
    ) else {
        panic!("it holds")
    };
    // The points that every search begins with come before the random ones.
    assert!(points >= 300 && open == 0 && !late, "{points} {open} {late}");
    // A natural number stays natural while the point is made smaller, and a member of a family stays in its domain.
    let found = failure("given n natural >= 1;  mu(k) >= 1\nprove mu(n) < 3 or n < 2", 2);
    let values = point(&found);
    assert!(values.starts_with("n = 2, mu(2) = 3"), "{values}");
}

#[test]
fn a_threshold_is_met_exactly() {
    // False at equality alone, which a continuous draw never meets.
    let strict = "given a, b, mu > 0;  e in [0, 1]
        let through = (1 + e)^4*a*b*mu^2/((a + mu)^2*(mu + b)^2)
        let direct = (1 + e)^2*a*b/(a + b)^2
        prove through > direct <=> e >= (a*b + mu^2)/(mu*(a + b))";
    let found = failure(strict, 0);
    assert_eq!(found.witness.broken[0].left, found.witness.broken[0].right, "{}", point(&found));
}

#[test]
fn irrational_sides_never_fail_by_noise() {
    // Equal in exact arithmetic, apart in every floating point format.
    for claim in [
        "given x, y > 0\nprove sqrt(x)*sqrt(y) = sqrt(x*y)",
        "given x > 0\nprove cbrt(x)^3 = x and (sqrt(x) + 1)*(sqrt(x) - 1) = x - 1",
        "given x > 1;  n natural\nprove (x + 1)^n >= x^n",
    ] {
        match of(claim, 200, 7) {
            Outcome::Held { points, .. } => assert!(points > 100, "{claim}: {points}"),
            other => panic!("{claim}: {other:?}"),
        }
    }
    // And a difference far below double precision is seen.
    let found = failure("given x > 0\nprove sqrt(x^2 + 1/10^60) <= x", 7);
    assert!(!found.witness.broken.is_empty());
}

#[test]
fn what_no_point_decides_is_not_called_held() {
    for (claim, sign) in [
        ("given x > 0\nprove exists y > 0: y*exp(y) = 2*x", "no comparison could be decided"),
        ("given x > 0;  y real\nassume y^2 = 2*x^2\nprove y > 0 or y <= 0", "no point was found"),
    ] {
        match of(claim, 50, 1) {
            Outcome::Untested(reason) => assert!(reason.contains(sign), "{claim}: {reason}"),
            other => panic!("{claim}: {other:?}"),
        }
    }
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("open.claim").display().to_string();
    std::fs::write(&path, "claim open \"t\"\ngiven x > 0\nprove exists y > 0: y*exp(y) = 2*x\n").expect("written");
    let out = carom(&["test", &path, "--seed", "1"]);
    assert_eq!(out.status.code(), Some(3), "{}", text(&out.stdout));
    assert!(text(&out.stdout).contains("1 could not be tried"), "{}", text(&out.stdout));
}

#[test]
fn the_line_that_is_printed_gives_the_same_again() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("mine is odd.claim").display().to_string();
    let claims = "claim sound \"holds\"\ngiven a, b real\nprove a^2 + b^2 >= 2*a*b\n\n\
        claim wrong \"fails\"\ngiven a, b real\nprove a^2 + b^2 > 2*a*b\n";
    std::fs::write(&path, claims).expect("written");
    let out = carom(&["test", &path, "--seed", "9", "--cases", "50"]);
    let shown = text(&out.stdout);
    assert_eq!(out.status.code(), Some(1), "{shown}");
    assert!(shown.contains("fails at a = 1, b = 1") && shown.contains("2 claims: 1 not as expected"), "{shown}");
    assert!(shown.contains("not as expected: its file expects the claim to hold"), "{shown}");
    let again = shown.lines().find_map(|l| l.trim().strip_prefix("to repeat: ")).expect("a line");
    assert_eq!(again, format!("carom test '{path}' --only wrong --seed 9 --cases 50"));
    let repeated = carom(&["test", &path, "--only", "wrong", "--seed", "9", "--cases", "50"]);
    let part = |text: &str| text.split("counterexample").nth(1).map(|t| t.split("to repeat").next().map(str::to_owned));
    assert_eq!(part(&shown), part(&text(&repeated.stdout)), "alone or with others");
    // A counterexample that is saved is a claim of its own, which the audit refutes.
    let save = folder.path().display().to_string();
    carom(&["test", &path, "--seed", "9", "--save", &save]);
    let saved = folder.path().join("counterexample-wrong.claim").display().to_string();
    let out = carom(&["audit", &saved]);
    assert_eq!(out.status.code(), Some(0), "{}{}", text(&out.stdout), text(&out.stderr));
    assert!(text(&out.stdout).contains("fails at a = 1, b = 1"), "{}", text(&out.stdout));
}

#[test]
fn nothing_holds_that_an_audit_refutes() {
    // The first two fail at roots alone, which no random point is; the third for what its quantities are.
    for (claim, sign) in [
        ("given x real\nprove x^2 != 2", "x = sqrt(2)"),
        ("given x > 0\nassume x^2 = 2\nprove x^3 < 2", "x = sqrt(2)"),
        ("given m > 0 in kg; v > 0 in m/s\nprove m + v = v + m", ""),
    ] {
        let found = failure(claim, 1);
        assert_eq!((&*point(&found), found.found), (sign, Found::ByAudit), "{claim}");
        let Assurance::Tried(Outcome::Failed(found)) = law(claim).expect("it parses").assured(&Settings::default())
        else {
            panic!("{claim}");
        };
        assert_eq!(found.found, Found::ByAudit, "{claim}");
    }
}

#[test]
fn a_saved_counterexample_is_read_again_and_tried_first() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.claim").display().to_string();
    let save = folder.path().join("saved").display().to_string();
    let run = |seed: &str| text(&carom(&["test", &path, "--save", &save, "--seed", seed]).stdout);
    for (claim, sign) in [
        ("given x > 0\nprove x < 1000", "assume x = 1000"),
        ("given theta real\nprove cos(theta)*tan(theta)/cos(theta) = tan(theta)", "assume cos(theta) = 0"),
        ("given theta in [0, pi]\nprove cos(theta/2) > 3/4", "assume cos(theta/2) = 0"),
        ("given x > 0\nprove floor(x) < 5", "assume x = 5"),
        ("given mu(k) > 0; n natural >= 2\nprove sum(i = 1..n, mu(i)) < 7", "assume mu(1) = "),
        ("given k integer\nprove k^2 != 4", "assume k_up = "),
    ] {
        std::fs::write(&path, format!("claim a \"t\"\n{claim}\n")).expect("written");
        let first = run("1");
        assert!(first.contains("found at point"), "{claim}: {first}");
        let file = folder.path().join("saved/counterexample-a.claim");
        let saved = std::fs::read_to_string(&file).expect("it is saved");
        assert!(saved.contains(sign), "{claim}: {saved}");
        let again = run("2");
        assert!(again.contains("found again where an earlier run had saved it"), "{claim}: {again}");
        assert_eq!(std::fs::read_to_string(&file).expect("it stays"), saved, "{claim}");
        // A mended claim holds there; what is saved stays.
        let mended = claim.split("prove ").next().expect("hypotheses");
        std::fs::write(&path, format!("claim a \"t\"\n{mended}prove 1 < 2\n")).expect("written");
        assert!(!run("3").contains("counterexample"), "{claim}");
        std::fs::remove_file(&file).expect("it stays");
    }
}

#[test]
fn bad_claims_and_names_are_errors() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("bad.claim").display().to_string();
    for (claim, sign) in [
        ("given x > 0\nassume x < -1\nprove x = 7\n", "contradict each other"),
        ("given x > 0\nprove y = 7\n", "nothing declares the name y"),
    ] {
        std::fs::write(&path, format!("claim c \"t\"\n{claim}")).expect("written");
        let out = carom(&["test", &path]);
        assert_eq!(out.status.code(), Some(2), "{}", text(&out.stdout));
        assert!(text(&out.stderr).contains(sign) && out.stdout.is_empty(), "{}", text(&out.stderr));
    }
    let out = carom(&["test", "--only", "eq17x"]);
    assert_eq!(out.status.code(), Some(2));
    assert!(text(&out.stderr).contains("did you mean"), "{}", text(&out.stderr));
}

#[test]
fn a_law_draws_points_that_satisfy_it_and_shrinks_them() {
    let claim =
        law("given a > 0;  b in [a, 2*a];  n natural in 1..4;  mu(k) in (0, 1)\nprove b*mu(n) < 7").expect("it parses");
    let mut runner = TestRunner::new(Config { cases: 200, failure_persistence: None, ..Config::default() });
    let kept = runner.run(&claim, |at| {
        let mu = at.get(&format!("mu({})", at["n"])).expect("the member that the goal speaks of").clone();
        assert!(at["a"] > 0 && at["b"] >= at["a"] && at["b"] <= &at["a"] + &at["a"] && mu > 0 && mu < 1, "{at:?}");
        assert_eq!(claim.holds(&at), Some(&at["b"] * mu < 7), "{at:?}");
        Ok(())
    });
    assert_eq!(kept, Ok(()));
    // The smallest point at which a test of one's own fails, whatever was drawn first.
    let free = law("given a > 0;  e in [0, 1]\nprove a > 0").expect("it parses");
    let mut tree = free.new_tree(&mut runner).expect("a point");
    while tree.current()["a"] <= 1 {
        tree = free.new_tree(&mut runner).expect("a point");
    }
    let mut more = tree.simplify();
    while more {
        more = if tree.current()["a"] >= 1 { tree.simplify() } else { tree.complicate() };
    }
    let at = tree.current();
    assert!(at["a"] == 1 && at["e"] == 0, "{at:?}");
    // A whole claim is read as well.
    assert!(law("claim mine \"Mine\"\ngiven x > 0\nprove x > 0\n").is_ok());
}

#[test]
fn what_is_proved_is_not_tried() {
    let known = |text: &str| law(text).expect("it parses").assured(&Settings::default());
    assert!(matches!(known("given a, b real\nprove a^2 + b^2 >= 2*a*b"), Assurance::Proved(sha) if sha.len() == 64));
    assert!(matches!(known("given a, b real\nprove a^2 + b^2 > 2*a*b"), Assurance::Tried(Outcome::Failed(_))));
}

#[test]
fn extreme_masses_are_far_apart() {
    use carom::property::strategies::extreme_masses;
    let mut runner = TestRunner::new(Config { cases: 64, failure_persistence: None, ..Config::default() });
    let mut widest = malachite::Rational::from(0);
    runner
        .run(&extreme_masses().prop_map(|list| list.iter().map(|m| m.value().clone()).collect::<Vec<_>>()), |masses| {
            let ratio = masses.iter().max().expect("one") / masses.iter().min().expect("one");
            assert!(masses.len() >= 2 && ratio >= 1);
            Ok(())
        })
        .expect("it holds");
    for _ in 0..64 {
        let masses = extreme_masses().new_tree(&mut runner).expect("masses").current();
        widest = widest.max(masses[1].value().clone());
    }
    assert!(widest > 1_000_000_000, "{widest}");
}
