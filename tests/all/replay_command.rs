//! `carom replay` as a user meets it.

use crate::support::{carom, text};
use std::io::Write;
use std::process::Output;
use std::time::Instant;

const THREE: &str = r#"
title = "Three <equal> bodies"
restitution = "1/5"
[[body]]
mass = "1"
position = "0"
velocity = "1"
[[body]]
mass = "1"
position = "1"
[[body]]
mass = 1
position = 2
velocity = 0
"#;

fn replay(scene: &str, arguments: &[&str]) -> Output {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("scene.toml");
    std::fs::File::create(&path).and_then(|mut f| f.write_all(scene.as_bytes())).expect("the file is written");
    let path = path.display().to_string();
    carom(&[&["replay", &path], arguments].concat())
}

fn json(out: &Output) -> serde_json::Value {
    serde_json::from_slice(&out.stdout).unwrap_or_else(|e| panic!("{e}: {}{}", text(&out.stdout), text(&out.stderr)))
}

fn example(name: &str) -> String {
    format!("{}/examples/replay/{name}.toml", env!("CARGO_MANIFEST_DIR"))
}

#[test]
fn json_has_the_shape_of_the_contract() {
    let out = replay(THREE, &["--format", "json"]);
    assert_eq!(out.status.code(), Some(0));
    let value = json(&out);
    assert_eq!(value["status"], "complete");
    assert_eq!(value["count"], 3);
    assert_eq!(
        value["collisions"][1],
        serde_json::json!({"time": "8/3", "pair": [2, 3], "before": ["3/5", "0"], "after": ["6/25", "9/25"]})
    );
    assert_eq!(value["final"], serde_json::json!(["38/125", "42/125", "9/25"]));
    assert_eq!(value["energy"], serde_json::json!({"initial": "1/2", "final": "5233/31250", "lost": "5196/15625"}));
    assert_eq!(value["momentum"], "1");
}

#[test]
fn statuses_and_exit_codes() {
    for (name, arguments, status, code) in [
        ("three-equal", &[][..], "complete", 0),
        ("collapse", &[], "collapse", 0),
        ("collapse-critical", &[], "collapse", 0),
        ("ambiguous", &["--orders"], "ambiguous", 0),
        ("cradle", &[], "complete", 0),
        ("inelastic", &[], "complete", 0),
        ("collapse", &["--through-collapse"], "complete", 0),
        ("rods", &["--until", "20"], "complete", 0),
        ("rods", &["--max-events", "5"], "limit", 3),
        ("pi-thirty-one", &[], "complete", 0),
    ] {
        let path = example(name);
        let out = carom(&[&["replay", path.as_str(), "--format", "json"], arguments].concat());
        assert_eq!(json(&out)["status"], status, "{name}");
        assert_eq!(out.status.code(), Some(code), "{name}");
        let out = carom(&[&["replay", path.as_str()], arguments].concat());
        assert_eq!(out.status.code(), Some(code), "{name}");
        assert!(text(&out.stdout).contains(status), "{name}: {}", text(&out.stdout));
    }
    let value = json(&carom(&["replay", &example("collapse-critical"), "--format", "json"]));
    assert_eq!(value["collapse"]["time"], "4");
    assert_eq!(value["collapse"]["critical"], true);
    let value = json(&carom(&["replay", &example("ambiguous"), "--orders", "--format", "json"]));
    assert_eq!(value["ambiguous"]["outcomes"].as_array().map(Vec::len), Some(2));
    let value = json(&carom(&["replay", &example("pi-thirty-one"), "--format", "json", "--digits", "5"]));
    assert_eq!(value["count"], 31);
    assert_eq!(value["final"][1], "0.99886");
}

#[test]
fn every_form_is_whole_and_needs_nothing_from_elsewhere() {
    let csv = text(&replay(THREE, &["--format", "csv"]).stdout);
    let rows: Vec<&str> = csv.lines().collect();
    assert_eq!(rows.len(), 4);
    assert_eq!(rows[0].split(',').count(), rows[1].split(',').count());
    assert!(rows[1].starts_with("1,1,1,2,1,1,0,2/5,3/5,6/25"));
    let svg = text(&replay(THREE, &["--format", "svg"]).stdout);
    assert!(svg.starts_with("<svg") && svg.ends_with("</svg>\n"));
    assert!(svg.contains("Three &lt;equal&gt; bodies") && !svg.contains("<equal>") && !svg.contains("NaN"));
    // Time runs upward: the last corner of a worldline is above its first.
    let line = svg.lines().find(|l| l.contains("stroke-linejoin")).expect("a worldline");
    let path = line.split("d=\"M").nth(1).and_then(|p| p.split('"').next()).expect("a path");
    let height = |corner: &str| corner.split(' ').nth(1).and_then(|y| y.parse::<f64>().ok()).expect("a number");
    let corners: Vec<f64> = path.split('L').map(height).collect();
    assert!(corners.windows(2).all(|w| w[1] < w[0]), "{path}");
    let html = text(&replay(THREE, &["--format", "html"]).stdout);
    assert!(html.starts_with("<!DOCTYPE html>") && html.trim_end().ends_with("</html>"));
    let outside = html.replace("http://www.w3.org/2000/svg", "");
    assert!(!outside.contains("http:") && !outside.contains("https:") && !outside.contains("src="), "{outside}");
    assert!(!html.contains("<equal>") && !html.contains('@'));
    let exact = text(&replay(THREE, &["--exact"]).stdout);
    assert!(exact.contains("5233/31250"));
}

#[test]
fn bodies_that_come_together_are_shown_in_every_form_and_move_on() {
    let scene = example("inelastic");
    let value = json(&carom(&["replay", &scene, "--format", "json"]));
    assert_eq!((value["status"].as_str(), value["count"].as_u64()), (Some("complete"), Some(1)));
    assert_eq!(value["joins"], 2);
    assert_eq!(
        value["joined"][1],
        serde_json::json!({"after": 1, "time": "6", "position": "3", "bodies": [1, 4], "before": ["1/3", "-1"],
            "velocity": "-1/5", "lost": "16/15", "cause": "inelastic"})
    );
    assert_eq!(value["final"], serde_json::json!(["-1/5", "-1/5", "-1/5", "-1/5"]));
    let shown = text(&carom(&["replay", &scene]).stdout);
    assert!(shown.contains("complete: 1 collision, and 2 times infinitely many more"), "{shown}");
    assert!(shown.contains("∞    6     1 to 4") && shown.contains("∞: infinitely many collisions."), "{shown}");
    let csv = text(&carom(&["replay", &scene, "--format", "csv"]).stdout);
    assert!(csv.contains("\n,6,1,4,3,1/3,-1,-1/5,-1/5,16/15\n"), "{csv}");
    let svg = text(&carom(&["replay", &scene, "--format", "svg"]).stdout);
    assert_eq!(svg.matches("r=\"9\"").count(), 2, "{svg}");
    assert!(svg.contains("2 times infinitely many more"));
    let html = text(&carom(&["replay", &scene, "--format", "html"]).stdout);
    assert!(html.contains("<td>∞</td><td>6</td><td>1 to 4</td>") && html.contains("∞: infinitely many"), "{html}");
}

#[test]
fn a_replay_goes_through_a_collapse_where_asked() {
    let scene = example("collapse");
    let value = json(&carom(&["replay", &scene, "--format", "json"]));
    assert_eq!((value["status"].as_str(), value["joins"].as_u64()), (Some("collapse"), Some(0)));
    let ended = text(&carom(&["replay", &scene]).stdout);
    assert!(ended.contains("--through-collapse"), "{ended}");
    let value = json(&carom(&["replay", &scene, "--through-collapse", "--format", "json"]));
    assert_eq!((value["status"].as_str(), value["joins"].as_u64()), (Some("complete"), Some(1)));
    assert_eq!(value["joined"][0]["cause"], "collapse");
    assert_eq!(value["joined"][0]["collapse"]["time"], value["time"]);
    let shown = text(&carom(&["replay", &scene, "--through-collapse"]).stdout);
    assert!(shown.contains("the replay continues from there"), "{shown}");
}

#[test]
fn a_number_is_not_said_to_be_near_itself() {
    // An irrational time whose exact form is too long for a table.
    let scene = THREE.replace("\"1/5\"", "\"0.0612345\"");
    for arguments in [&[][..], &["--digits", "12"], &["--digits", "5"], &["--exact"]] {
        let shown = text(&replay(&scene, arguments).stdout);
        let line = shown.lines().find(|l| l.contains("before the time")).expect("a collapse");
        let time = line.split("before the time ").nth(1).expect("a time");
        assert_eq!(time.contains('≈'), arguments == ["--exact"], "{line}");
        assert_eq!(time.contains("sqrt"), arguments == ["--exact"], "{line}");
    }
}

#[test]
fn an_ambiguous_page_shows_what_is_open_instead_of_an_empty_table() {
    let html = text(&carom(&["replay", &example("ambiguous"), "--orders", "--format", "html"]).stdout);
    assert!(html.contains("mechanics does not determine their order"), "{html}");
    assert!(html.contains("velocities "), "the orders are listed");
    assert!(html.contains("<div class=\"table\" hidden>"), "{html}");
}

#[test]
fn equal_bodies_between_elastic_walls_are_replayed() {
    let scene = "restitution = \"1/2\"\n[[body]]\nmass = 2\nposition = 0\n[[body]]\nmass = 2\nposition = 1\nvelocity = 1\n\
        [wall]\nleft = -1\nright = 3\nrestitution = 1\n";
    let out = replay(scene, &["--max-events", "1000"]);
    assert_eq!(out.status.code(), Some(3), "{}", text(&out.stderr));
}

#[test]
fn a_listing_that_is_cut_says_so() {
    let out = replay(THREE, &["--format", "json", "--list", "1"]);
    let value = json(&out);
    assert_eq!((value["count"].as_u64(), value["listed"].as_u64()), (Some(3), Some(1)));
    assert_eq!(value["collisions"].as_array().map(Vec::len), Some(1));
    assert!(text(&replay(THREE, &["--list", "1"]).stdout).contains("2 more"));
}

#[test]
fn faults_of_a_scene_are_shown_where_they_are() {
    let with = |line: &str| THREE.replace("mass = 1\n", line);
    for (scene, sign) in [
        (with("mass = 0.1\n"), "mass = \"0.1\""),
        (with("mas = \"1\"\n"), "did you mean mass?"),
        (with("mass = \"0\"\n"), "not positive"),
        (with("mass = \"-1\"\n"), "not positive"),
        (with("mass = \"1.2(3)\"\n"), "uncertainty"),
        (with("mass = \"1/0\"\n"), "denominator at character 3 is zero"),
        (with("mass = \"1e99999\"\n"), "too large"),
        (with("mass = true\n"), "boolean"),
        (with(""), "mass is missing"),
        (with("mass = nan\n"), "which is not exact"),
        (THREE.replace("position = 2", "position = \"1/2\""), "overlaps"),
        (THREE.replace("\"1/5\"", "\"6/5\""), "must lie from 0 to 1, not 6/5"),
        ("restitution = 2\n[[body]]\nmass = 1\nposition = 0\n".to_string(), "must lie from 0 to 1, not 2"),
        (THREE.replace("\"1/5\"", "[\"1\"]"), "1 restitutions for 2 pairs"),
        (THREE.replace("restitution = \"1/5\"", ""), "restitution is missing"),
        (format!("{THREE}[wall]\nleft = \"1\"\nrestitution = 1\n"), "overlaps"),
        (format!("{THREE}[wall]\nrestitution = 1\n"), "has no position"),
        (format!("{THREE}[wall]\nleft = -1\n"), "restitution of the wall is missing"),
        (format!("{THREE}[wal]\nleft = -1\n"), "did you mean wall?"),
        (format!("{THREE}[wall]\nleft = -1\nrestitution = 2\n"), "must lie from 0 to 1, not 2"),
        ("title = \"nothing\"\n".to_string(), "no body"),
        (String::new(), "no body"),
        ("body = 3\n".to_string(), "list of tables"),
        ("[[body]\nmass = 1\n".to_string(), "scene.toml"),
        (format!("x = {}{}", "[".repeat(100_000), "]".repeat(100_000)), "scene.toml"),
    ] {
        let started = Instant::now();
        let out = replay(&scene, &[]);
        let message = text(&out.stderr);
        let head: String = scene.chars().take(300).collect();
        assert_eq!(out.status.code(), Some(2), "{head}: {message}");
        assert!(message.contains(sign), "{head}: {message}");
        assert!(message.contains("scene.toml:"), "{head}: {message}");
        assert!(out.stdout.is_empty());
        assert!(started.elapsed().as_secs_f64() < 10.0, "{head}");
    }
}

#[test]
fn bad_usage_is_refused() {
    for arguments in [
        &["--until", "soon"][..],
        &["--until", "1/0"],
        &["--until", "-5"],
        &["--digits", "0"],
        &["--max-events", "-1"],
        &["--format", "pdf"],
        &["--exact", "--digits", "3"],
    ] {
        assert_eq!(replay(THREE, arguments).status.code(), Some(2), "{arguments:?}");
    }
    assert_eq!(carom(&["replay", "/no/such/scene.toml"]).status.code(), Some(2));
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("bytes.toml");
    std::fs::write(&path, b"title = \"\xff\"").expect("written");
    let out = carom(&["replay", &path.display().to_string()]);
    assert_eq!(out.status.code(), Some(2));
    assert!(text(&out.stderr).contains("UTF-8"));
    let missing = folder.path().join("no/such/folder.svg");
    let out = replay(THREE, &["--output", &missing.display().to_string()]);
    assert_eq!(out.status.code(), Some(2));
}

#[test]
fn extreme_numbers_are_exact_or_stopped_by_a_limit() {
    let scene = r#"
restitution = "1"
[[body]]
mass = "1e-9000"
position = "0"
velocity = "1e9000"
[[body]]
mass = "1e9000"
position = "1e-9000"
"#;
    let out = replay(scene, &["--format", "json"]);
    assert_eq!(out.status.code(), Some(0), "{}", text(&out.stderr));
    assert_eq!(json(&out)["count"], 1);
    for format in ["text", "svg", "html", "csv"] {
        let out = replay(scene, &["--format", format]);
        assert_eq!(out.status.code(), Some(0), "{format}");
        assert!(!text(&out.stdout).contains("NaN"), "{format}");
    }
    let out = replay(THREE, &["--max-events", "0"]);
    assert_eq!(out.status.code(), Some(3));
    let out = replay(THREE, &["--until", "0"]);
    assert!(text(&out.stdout).contains("complete: 0 collisions"));
}

#[test]
fn numbers_of_any_length_are_aligned() {
    let out = replay(THREE, &["--digits", "70000"]);
    assert_eq!(out.status.code(), Some(0), "{}", text(&out.stderr));
    assert!(text(&out.stdout).lines().any(|l| l.len() > 70_000));
}
