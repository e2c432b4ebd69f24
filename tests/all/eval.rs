//! `carom eval` as a user meets it.
#![allow(clippy::unwrap_used)] // a test stops where it fails

use crate::support::{carom, text, with_input};
use serde_json::Value;
use std::process::Output;

fn json(out: &Output) -> Value {
    assert_eq!(out.status.code(), Some(0), "{}", text(&out.stderr));
    serde_json::from_slice(&out.stdout).unwrap()
}

const SCENE: &str = r#"
want = ["eta", "threshold"]
digits = 12
[chain]
first = "10"
last = "1"
inserted = 7
restitution = "9/10"
speed = "1"
"#;

#[test]
fn flags_and_scene_give_the_same() {
    let by_flags = json(&carom(&[
        "eval",
        "--m1",
        "10",
        "--m2",
        "1",
        "-e",
        "9/10",
        "-n",
        "7",
        "--want",
        "eta,threshold",
        "--digits",
        "12",
        "--format",
        "json",
    ]));
    let by_scene = json(&with_input(&["eval", "-", "--format", "json"], SCENE));
    assert_eq!(by_flags, by_scene);
    assert_eq!(by_flags["eta"]["decimal"], "0.373137511774");
    assert_eq!(by_flags["eta"]["digits"], 12);
    assert!(by_flags["eta"]["exact"].is_null());
    assert_eq!(by_flags["eta"]["enclosure"][0], "0.373137511773738");
    assert_eq!(by_flags["eta"]["enclosure"][1], "0.373137511773739");
    assert!(by_flags["computed"].is_null());
}

#[test]
fn exact_results_stay_exact() {
    let out = json(&carom(&[
        "eval",
        "--m1",
        "64",
        "--m2",
        "1",
        "-e",
        "44/81",
        "-n",
        "2",
        "--want",
        "threshold,helps,best-n,masses,velocities,matrix,losses,recollides,eta",
        "--format",
        "json",
    ]));
    assert_eq!(out["threshold"]["exact"], "44/81");
    assert_eq!(out["helps"], "exactly on the threshold");
    assert_eq!(out["best-n"]["exact"], "2");
    assert_eq!(out["best-n"]["tie"], true);
    let masses: Vec<&str> = out["masses"].as_array().unwrap().iter().map(|m| m["exact"].as_str().unwrap()).collect();
    assert_eq!(masses, ["64", "16", "4", "1"]);
    assert_eq!(out["recollides"], false);
    assert_eq!(out["velocities"].as_array().unwrap().len(), 4);
    assert_eq!(out["losses"].as_array().unwrap().len(), 3);
    assert_eq!(out["matrix"][0][0][1]["exact"], "25/81");
}

#[test]
fn only_what_is_wanted_is_computed() {
    let explain = |want: &str| {
        json(&carom(&[
            "eval",
            "--m1",
            "10",
            "--m2",
            "1",
            "-e",
            "1/2",
            "-n",
            "7",
            "--want",
            want,
            "--format",
            "json",
            "--explain",
        ]))
    };
    let eta = explain("eta");
    assert_eq!(eta["computed"], serde_json::json!(["eta"]));
    let skipped = eta["skipped"].as_array().unwrap();
    assert!(skipped.contains(&"velocities".into()) && skipped.contains(&"masses".into()));
    assert_eq!(eta["level"], "double");
    let helps = explain("helps");
    assert_eq!(helps["computed"], serde_json::json!(["helps"]));
    assert_eq!(helps["levels"]["helps"], "double");
    assert_eq!(explain("velocities")["computed"], serde_json::json!(["pass", "velocities", "recollides"]));
}

#[test]
fn velocities_that_are_not_final_carry_a_warning() {
    let ask = |e: &str| {
        carom(&["eval", "--m1", "4", "--m2", "1", "-e", e, "-n", "1", "--want", "velocities", "--format", "json"])
    };
    assert!(text(&ask("1/4").stdout).contains("not final"));
    assert!(!text(&ask("1/2").stdout).contains("not final"));
    let plain = carom(&["eval", "--m1", "4", "--m2", "1", "-e", "1/4", "--masses", "2", "--want", "velocities"]);
    assert!(text(&plain.stdout).contains("not final"));
}

#[test]
fn measured_inputs_cover_the_box() {
    let out = json(&carom(&[
        "eval",
        "--m1",
        "57.1 ± 0.1",
        "--m2",
        "[2, 3]",
        "-e",
        "[0.84, 0.90]",
        "-n",
        "1",
        "--want",
        "eta,threshold,helps,best-n,masses,recollides",
        "--format",
        "json",
    ]));
    assert!(out["eta"]["exact"].is_null() && out["eta"]["decimal"].is_null());
    assert_eq!(out["helps"], "yes");
    assert_eq!(out["masses"][2]["enclosure"][1], "3.00000000000000000");
    let depends = carom(&["eval", "--m1", "64", "--m2", "1", "-e", "44/81 ± 0.001", "-n", "2", "--want", "helps"]);
    assert!(text(&depends.stdout).contains("depends"));
    let given = json(&carom(&[
        "eval", "--m1", "[9, 11]", "--m2", "1", "-e", "1/2", "--masses", "[2, 4]", "--want", "eta", "--format", "json",
    ]));
    assert!(given["eta"]["enclosure"][0].is_string());
}

#[test]
fn measured_velocities_losses_and_matrices_are_answered() {
    let ask = |more: &[&str]| {
        let flags = ["--want", "velocities,losses,matrix,recollides", "--format", "json", "--digits", "5"];
        json(&carom(&[&["eval"], more, &flags].concat()))
    };
    let given = ask(&["--m1", "[9, 11]", "--m2", "1", "-e", "1/2", "--masses", "[2, 4]"]);
    // (m0 − m1/2)/(m0 + m1): 7/13 at 9 and 4, 10/13 at 11 and 2.
    assert_eq!(given["velocities"][0]["enclosure"][0], "0.53846153");
    assert_eq!(given["velocities"][0]["enclosure"][1], "0.76923077");
    assert_eq!(given["matrix"][1][1][1]["enclosure"][1], "0");
    assert_eq!(given["recollides"], "depends");
    assert!(text(given["warnings"][0].as_str().unwrap().as_bytes()).contains("may meet again"));
    let optimal = ask(&["--m1", "[9, 11]", "--m2", "1", "-e", "[0.84, 0.9]", "-n", "3"]);
    assert_eq!((optimal["velocities"].as_array().unwrap().len(), optimal["losses"].as_array().unwrap().len()), (5, 4));
    assert_eq!(optimal["recollides"], false);
    let each = ask(&["--m1", "10", "--m2", "1", "-e", "[0.84, 0.9],[0.5, 0.6]", "-n", "1"]);
    assert_eq!(each["matrix"].as_array().unwrap().len(), 2);
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("moving.toml");
    let scene = "want = [\"velocities\", \"losses\"]\n[chain]\nfirst = \"[3, 4]\"\ninserted = [2]\nlast = 1\nrestitution = \"1/2\"\nvelocities = ";
    std::fs::write(&path, format!("{scene}[2, -1, 0]\n")).unwrap();
    let moving = carom(&["eval", path.to_str().unwrap()]);
    assert!(moving.status.success() && text(&moving.stdout).contains("losses[2]"), "{}", text(&moving.stderr));
    std::fs::write(&path, format!("{scene}[2, 0, 3]\n")).unwrap();
    let missed = carom(&["eval", path.to_str().unwrap()]);
    assert_eq!(missed.status.code(), Some(2));
    assert!(text(&missed.stderr).contains("collision 2"), "{}", text(&missed.stderr));
}

const BETWEEN: [&str; 6] = ["eval", "--m1", "10", "--m2", "1", "-e"];

/// The words that answer whether each body helps.
fn words(out: &Value) -> Vec<&str> {
    out["helps"].as_array().unwrap().iter().map(|word| word.as_str().unwrap()).collect()
}

#[test]
fn given_masses_are_asked_about_themselves() {
    let ask = |e: &str, masses: &str| {
        let flags = [e, "--masses", masses, "--want", "threshold,helps", "--format", "json"];
        carom(&[&BETWEEN[..], &flags].concat())
    };
    // eta is 4.6e-10 with these bodies, and 0.298 without them.
    let bad = json(&ask("9/10", "1000,0.001"));
    assert_eq!(words(&bad), ["no", "no"]);
    assert_eq!(bad["threshold"][0]["exact"], "100000001/1000100");
    assert_eq!(bad["threshold"][1]["exact"], "999001/1000");
    // (10·1 + 4)/(2·11) = 7/11.
    let one = |e: &str| json(&ask(e, "2"));
    assert_eq!(one("7/11")["threshold"][0]["exact"], "7/11");
    assert_eq!(words(&one("7/11")), ["exactly on the threshold"]);
    assert_eq!(words(&one("0.6363636364")), ["yes"]);
    assert_eq!(words(&one("0.6363636363")), ["no"]);
    // Two coefficients: both are compared, because the direct collision has none of its own.
    assert_eq!(words(&one("0.7,0.8")), ["yes"]);
    assert_eq!(words(&one("0.5,0.6")), ["no"]);
    assert_eq!(words(&one("0.5,0.8")), ["depends"]);
    assert_eq!(words(&one("7/11,7/11")), ["exactly on the threshold"]);
    // Measured: from 7/11 to 1 for a mass from 1 to 2; √10 is the best mass.
    let measured = json(&ask("[0.9, 0.95]", "[1, 2]"));
    assert_eq!(
        measured["threshold"][0]["enclosure"],
        serde_json::json!(["0.636363636363636363", "1.00000000000000000"])
    );
    assert_eq!(words(&measured), ["depends"]);
    let around = json(&ask("[0.57, 0.5749]", "[2, 5]"));
    assert_eq!(around["threshold"][0]["enclosure"][0], "0.574959574576068969");
    assert_eq!(words(&around), ["no"]);
    assert_eq!(words(&json(&ask("[0.57, 0.575]", "[2, 5]"))), ["depends"]);
    assert_eq!(words(&json(&ask("[0.7, 0.8]", "[2, 5]"))), ["yes"]);
    let plain = carom(&[&BETWEEN[..], &["9/10", "--masses", "5;2", "--want", "threshold,helps"]].concat());
    let shown = text(&plain.stdout);
    assert!(shown.contains("threshold[1]") && shown.contains("helps[2]"), "{shown}");
    let best = carom(&[&BETWEEN[..], &["9/10", "--masses", "5;2", "--want", "best-n"]].concat());
    assert_eq!((best.status.code(), best.stdout.len()), (Some(2), 0));
    assert!(text(&best.stderr).contains("best-n: this needs inserted bodies of optimal mass"));
    let scene =
        "want = [\"helps\"]\n[chain]\nfirst = 3\nlast = 1\ninserted = [2]\nrestitution = 1\nvelocities = [2, 1, 0]\n";
    let moving = with_input(&["eval", "-"], scene);
    assert_eq!(moving.status.code(), Some(2));
    assert!(text(&moving.stderr).contains("helps: the first body must move forward"), "{}", text(&moving.stderr));
}

#[test]
fn only_what_is_needed_is_asked_for() {
    let ask = |more: &[&str]| carom(&[&["eval", "--m1", "64", "--m2", "1"], more].concat());
    let answered: [(&[&str], &str); 4] = [
        (&["-n", "2", "--want", "threshold"], "44/81"),
        (&["-e", "44/81", "--want", "best-n"], "best-n         2"),
        (&["-n", "2", "--want", "masses"], "= 16"),
        (&["--masses", "8", "--want", "masses,threshold"], "threshold[1]"),
    ];
    for (more, word) in answered {
        let out = ask(more);
        assert_eq!(out.status.code(), Some(0), "{more:?}: {}", text(&out.stderr));
        assert!(text(&out.stdout).contains(word), "{more:?}: {}", text(&out.stdout));
    }
    for quantity in carom::scene::quantity::Quantity::names() {
        let needs_e = !["threshold", "masses"].contains(&quantity);
        let out = ask(&["-n", "2", "--want", quantity]);
        assert_eq!(out.status.code(), Some(if needs_e { 2 } else { 0 }), "{quantity}: {}", text(&out.stderr));
        assert_eq!(text(&out.stderr).contains(&format!("{quantity} needs -e")), needs_e, "{}", text(&out.stderr));
        let needs_n = quantity != "best-n";
        let out = ask(&["-e", "1/2", "--want", quantity]);
        assert_eq!(out.status.code(), Some(if needs_n { 2 } else { 0 }), "{quantity}: {}", text(&out.stderr));
        assert_eq!(text(&out.stderr).contains(&format!("{quantity} needs -n")), needs_n, "{}", text(&out.stderr));
    }
    // The first that needs it is named.
    let message = text(&ask(&["-n", "2", "--want", "threshold,losses,eta"]).stderr);
    assert!(message.contains("losses needs -e"), "{message}");
    let scene = "want = [\"threshold\"]\n[chain]\nfirst = 64\nlast = 1\ninserted = 2\n";
    assert!(text(&with_input(&["eval", "-"], scene).stdout).contains("44/81"));
    let lacking = with_input(&["eval", "-", "--want", "threshold,eta"], scene);
    assert_eq!(lacking.status.code(), Some(2));
    let message = text(&lacking.stderr);
    assert!(message.contains("eta needs restitution") && message.contains("-:2:1"), "{message}");
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("part.toml");
    std::fs::write(&path, scene).unwrap();
    let sheet = carom(&["worksheet", path.to_str().unwrap()]);
    assert_eq!(sheet.status.code(), Some(2));
    assert!(text(&sheet.stderr).contains("a worksheet needs the coefficient"), "{}", text(&sheet.stderr));
    // A sheet from standard input has a title, too.
    let whole = scene.replace("inserted = 2", "inserted = 2\nrestitution = 1");
    let sheet = text(&with_input(&["worksheet", "-"], &whole).stdout);
    assert!(sheet.starts_with("scene: worksheet"), "{sheet}");
    let batch = |want: &str, lines: &str| with_input(&["eval", "--batch", "-", "--want", want, "--digits", "6"], lines);
    let out = text(&batch("threshold", "m1,m2,e,n\n64,1,,2\n").stdout);
    assert!(out.contains("64,1,,2,0.543210,"), "{out}");
    assert!(text(&batch("best-n", "64,1,44/81,\n").stdout).contains("64,1,44/81,,2,true"));
    let out = batch("threshold,eta", "64,1,1/2,2\n64,1,,2\n");
    assert_eq!(out.status.code(), Some(2));
    assert!(text(&out.stderr).contains("-:2: eta needs e"), "{}", text(&out.stderr));
}

#[test]
fn rounding_follows_the_flag() {
    let eta = |mode: &str| {
        let out = carom(&["eval", "--m1", "1", "--m2", "1", "-e", "0.5", "-n", "0", "--round", mode, "--places", "3"]);
        text(&out.stdout).split_whitespace().nth(1).unwrap().to_owned()
    };
    // eta = 9/16 = 0.5625: a tie at three places.
    assert_eq!(eta("nearest"), "0.562");
    assert_eq!(eta("up"), "0.563");
    assert_eq!(eta("down"), "0.562");
    assert_eq!(eta("zero"), "0.562");
    assert_eq!(eta("away"), "0.563");
}

#[test]
fn bad_input_says_what_where_and_what_would_be_right() {
    let cases: [(&str, i32, &[&str]); 15] = [
        ("want = [\"eta\"]\n", 2, &["[chain]"]),
        ("wnat = []\n[chain]\n", 2, &["unknown key wnat", "want", ":1:1"]),
        ("[chain]\nfirst = 0.1\nlast = 1\nrestitution = 1\n", 2, &["not exact", "\"0.1\"", ":2:9"]),
        ("[chain]\nfirst = 1\nlast = 1\nrestitution = \"3/2\"\n", 2, &["0 to 1", ":4:15"]),
        ("[chain]\nfirst = 0\nlast = 1\nrestitution = 1\n", 2, &["above 0"]),
        ("[chain]\nfirst = \"1.2(x)\"\nlast = 1\nrestitution = 1\n", 2, &["uncertainty", "57.1(1)"]),
        ("[chain]\nfirst = \"[2, 1]\"\nlast = 1\nrestitution = 1\n", 2, &["lower end"]),
        ("[chain]\nfirst = \"1e99999\"\nlast = 1\nrestitution = 1\n", 3, &["10000"]),
        ("[chain]\nfirst = 2\nlast = 1\nrestitution = [1, 1]\n", 2, &["1 coefficients"]),
        ("want = [\"eat\"]\n[chain]\nfirst = 2\nlast = 1\nrestitution = 1\n", 2, &["eta"]),
        ("digits = 100000000\n[chain]\nfirst = 2\nlast = 1\nrestitution = 1\n", 3, &["limit reached"]),
        ("[chain]\nfirst = 2\nlast = 1\ninserted = 1000000000000000000000000000000\nrestitution = 1\n", 2, &["-:"]),
        ("[chain\n", 2, &["TOML"]),
        ("want = []\n[chain]\nfirst = 2\nlast = 1\nrestitution = 1\n", 2, &["-:1:8", "give at least one of eta"]),
        ("digits = 0\n[chain]\nfirst = 2\nlast = 1\nrestitution = 1\n", 2, &["-:1:10", "digits must be at least 1"]),
    ];
    for (scene, code, words) in cases {
        let out = with_input(&["eval", "-"], scene);
        let message = text(&out.stderr);
        let allowed = [Some(code), Some(3)];
        assert!(allowed.contains(&out.status.code()), "{scene}: {:?} {message}", out.status.code());
        assert!(
            out.status.code() == Some(code) || scene.contains("1000000000000000000000000000000"),
            "{scene}: {message}"
        );
        for word in words {
            assert!(message.contains(word), "{scene}: {message}");
        }
        assert!(out.stdout.is_empty(), "{scene}");
    }
}

#[test]
fn flags_are_checked_as_well() {
    let cases: [(&[&str], i32, &str); 13] = [
        (&["--m2", "1", "-e", "1", "-n", "1"], 2, "--m1 is missing"),
        (&["--m1", "-3", "--m2", "1", "-e", "1", "-n", "1"], 2, "above 0"),
        (&["--m1", "1", "--m2", "1", "-e", "1", "-n", "x"], 2, "natural number"),
        (&["--m1", "1", "--m2", "1", "-e", "1", "-n", "0", "--want", "threshold"], 2, "n >= 1"),
        (&["--m1", "1", "--m2", "1", "-e", "1", "-n", "99999999999999999999999999"], 3, "limit reached"),
        (&["--m1", "2", "--m2", "1", "-e", "1,1/2", "-n", "1", "--want", "helps"], 2, "the same coefficient"),
        (&["--m1", "2", "--m2", "1", "-e", "1", "-n", "2000000", "--want", "masses"], 3, "listed bodies"),
        (&["--m1", "2", "--m2", "1", "-e", "1", "-n", "1", "--digits", "100000000"], 3, "limit reached"),
        (&["--m1", "2", "--m2", "1", "-e", "1", "-n", "1", "--digits", "0"], 2, "--digits 0"),
        (&["--m1", "2", "--m2", "1", "-e", "1", "-n", "1", "--want", ""], 2, "--want: give at least one of eta"),
        (
            &["--m1", "2", "--m2", "1", "-e", "1", "-n", "1", "--want", "velocities", "--speed", "-3"],
            2,
            "velocities: the first body must move forward",
        ),
        (&["--batch", "/dev/null", "--format", "json"], 2, "--format json"),
        (&["--batch", "/dev/null", "--explain"], 2, "--explain"),
    ];
    for (flags, code, word) in cases {
        let arguments: Vec<&str> = std::iter::once("eval").chain(flags.iter().copied()).collect();
        let out = carom(&arguments);
        let message = text(&out.stderr);
        assert_eq!(out.status.code(), Some(code), "{flags:?}: {message}");
        assert!(message.contains(word), "{flags:?}: {message}");
    }
}

#[test]
fn batches_answer_line_by_line() {
    let input = "m1,m2,e,n\n# a comment\n10,1,9/10,7\n64,1,44/81,2\n";
    let out = with_input(&["eval", "--batch", "-", "--want", "eta,helps,best-n", "--digits", "6"], input);
    assert_eq!(out.status.code(), Some(0));
    let lines: Vec<String> = text(&out.stdout).lines().map(str::to_owned).collect();
    assert_eq!(lines[0], "m1,m2,e,n,eta,eta_lower,eta_upper,helps,best-n,tie");
    assert_eq!(lines[1], "10,1,9/10,7,0.373138,0.373137511,0.373137512,no,3,false");
    assert!(lines[2].ends_with("exactly on the threshold,2,true"));
    let wrong = with_input(&["eval", "--batch", "-"], "1,1,1,1\n1,1,2,1\n");
    assert_eq!(wrong.status.code(), Some(2));
    assert!(text(&wrong.stderr).contains("-:2: e:"), "{}", text(&wrong.stderr));
    // One row for each line, in its place; what is wrong costs no other line its answer.
    let mixed = "m1,m2,e,n\n10,1,9/10,7\n10,1,9/10,7,5\n10,0,1,1\n\n1,1,1,1\n";
    let out = with_input(&["eval", "--batch", "-", "--want", "eta,helps", "--digits", "6"], mixed);
    let rows: Vec<String> = text(&out.stdout).lines().map(str::to_owned).collect();
    assert_eq!(
        rows[1..],
        [
            "10,1,9/10,7,0.373138,0.373137511,0.373137512,no",
            ",,,,,,,",
            "10,0,1,1,,,,",
            "1,1,1,1,1.00000,1.00000000,1.00000000,exactly on the threshold",
        ]
    );
    let said = text(&out.stderr);
    assert_eq!((out.status.code(), said.lines().count()), (Some(2), 2), "{said}");
    assert!(said.contains("-:3: 5 fields where the heading has 4") && said.contains("-:4: m2:"), "{said}");
    let many = with_input(&["eval", "--batch", "-"], &"x,1,1,1\n".repeat(50));
    assert_eq!((text(&many.stdout).lines().count(), text(&many.stderr).lines().count()), (51, 21));
    assert!(text(&many.stderr).ends_with("30 more lines have no answer\n"), "{}", text(&many.stderr));
    // A limit alone is a limit.
    let limit = with_input(&["eval", "--batch", "-"], "1,1,1,1e40\n1,1,1,1\n");
    assert_eq!((limit.status.code(), text(&limit.stdout).lines().count()), (Some(3), 3), "{}", text(&limit.stderr));
    let folder = tempfile::tempdir().unwrap();
    let target = folder.path().join("out.csv");
    let out = with_input(&["eval", "--batch", "-", "-o", target.to_str().unwrap()], "1,1,1,1\nx,1,1,1\n");
    assert_eq!((out.status.code(), std::fs::read_to_string(&target).unwrap().lines().count()), (Some(2), 3));
    // A byte order mark, comments before the heading, and blank lines change nothing.
    for before in
        ["\u{feff}", "\u{feff}m1,m2,e,n\n", "# a comment\n\nm1, m2, e, n\n", "\u{feff}# a comment\nm1,m2,e,n\n"]
    {
        let out = with_input(&["eval", "--batch", "-", "--digits", "6"], &format!("{before}10,1,9/10,7\n"));
        assert_eq!(out.status.code(), Some(0), "{before:?}: {}", text(&out.stderr));
        assert_eq!(
            text(&out.stdout).lines().nth(1),
            Some("10,1,9/10,7,0.373138,0.373137511,0.373137512"),
            "{before:?}"
        );
    }
    let folder = carom(&["eval", "--batch", env!("CARGO_MANIFEST_DIR")]);
    assert_eq!((folder.status.code(), folder.stdout.len()), (Some(2), 0));
    let twice = with_input(&["eval", "--batch", "-"], "m1,m2,e,n\nm1,m2,e,n\n");
    assert_eq!(twice.status.code(), Some(2));
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("bytes.csv");
    std::fs::write(&path, b"1,1,1,1\n1,1,\xff,1\n").unwrap();
    let bytes = carom(&["eval", "--batch", path.to_str().unwrap()]);
    assert_eq!((bytes.status.code(), text(&bytes.stdout).lines().count()), (Some(2), 3));
    assert!(text(&bytes.stderr).contains("bytes.csv:2: this is not UTF-8 text"), "{}", text(&bytes.stderr));
}

#[test]
fn a_batch_reads_measured_cells_as_flags_do_and_needs_a_row() {
    let rows = "57.1±0.1,40(1),0.9,2\n57.1 ± 1 %,40,0.9±0.01,1\n\"[57, 58]\",40,0.9,1\n64 ± 1,1,0.9,2\n";
    for heading in ["m1,m2,e,n\n", ""] {
        let flags = ["eval", "--batch", "-", "--want", "eta,helps,best-n", "--digits", "6"];
        let out = with_input(&flags, &format!("{heading}{rows}"));
        assert_eq!(out.status.code(), Some(0), "{}", text(&out.stderr));
        let rows = text(&out.stdout);
        let one = carom(&["eval", "--m1", "57.1±0.1", "--m2", "40(1)", "-e", "0.9", "-n", "2", "--digits", "6"]);
        for end in ["0.726167145", "0.728475269"] {
            assert!(rows.lines().nth(1).unwrap().contains(end) && text(&one.stdout).contains(end), "{rows}");
        }
        assert!(rows.lines().nth(1).unwrap().ends_with(",no,0,false"), "{rows}");
        assert!(rows.lines().nth(4).unwrap().ends_with("yes,5,false"), "{rows}");
    }
    for input in ["", "m1,m2,e,n\n", "# nothing\n"] {
        let out = with_input(&["eval", "--batch", "-"], input);
        assert_eq!(out.status.code(), Some(2), "{input}");
        assert!(text(&out.stderr).contains("there is no row to answer"), "{}", text(&out.stderr));
    }
}

#[test]
fn columns_of_a_batch_go_by_their_names() {
    let ask = |table: &str| with_input(&["eval", "--batch", "-", "--digits", "6"], table);
    let answered = ask("m1,m2,e,n\n10,1,9/10,7\n1,2,1/2,3\n");
    for table in [
        "e,m1,m2,n\n9/10,10,1,7\n1/2,1,2,3\n",
        // R: write.csv, with and without the numbers of the rows.
        "\"\",\"n\",\"m1\",\"m2\",\"e\"\n\"1\",7,10,1,\"9/10\"\n\"2\",3,1,2,\"1/2\"\n",
        "\"m1\",\"m2\",\"e\",\"n\"\n10,1,\"9/10\",7\n1,2,\"1/2\",3\n",
        // pandas: to_csv.
        ",m2,m1,e,n\n0,1,10,9/10,7\n1,2,1,1/2,3\n",
        // Excel with a decimal comma, a byte order mark, an empty column; and its line for other programs.
        "\u{feff}M1;M2;E;N;\r\n10;1;9/10;7;\r\n1;2;1/2;3;\r\n",
        "sep=;\r\nm1;m2;e;n\r\n10;1;9/10;7\r\n1;2;1/2;3\r\n",
        // LibreOffice, all fields quoted; tabs; a class's own order and names.
        "\"m1\"\t\"m2\"\t\"e\"\t\"n\"\n\"10\"\t\"1\"\t\"9/10\"\t\"7\"\n\"1\"\t\"2\"\t\"1/2\"\t\"3\"\n",
        "# measured today\ninserted, restitution, m2, m1\n7, 9/10, 1, 10\n3, 1/2, 2, 1\n",
    ] {
        let out = ask(table);
        assert_eq!((text(&out.stdout), text(&out.stderr)), (text(&answered.stdout), String::new()), "{table}");
    }
    let comma = ask("m1;m2;e;n\n10;1;0,9;7\n");
    assert!(text(&comma.stdout).contains("\n10,1,0.9,7,0.373138,"), "{}", text(&comma.stdout));
    // Nothing is computed from a table that is not understood.
    for (table, says) in [
        ("e,m1,m2\n0.9,10,1\n", "no column n, which eta needs"),
        ("m1,e,n\n0.9,10,1\n", "no column m2, which eta needs"),
        ("m1,m2,e,n,eta\n10,1,9/10,7,0.3\n", "column \"eta\": the columns are m1, m2, e and n"),
        ("m1,m_2,e,n\n10,1,9/10,7\n", "column \"m_2\": the columns are m1, m2, e and n; did you mean m2?"),
        ("m1,m2,e,n,m1\n10,1,9/10,7,10\n", "two columns mean \"m1\""),
        ("e,m1,m2,n,restitution\n1,10,1,7,1\n", "two columns mean \"restitution\""),
    ] {
        let out = ask(table);
        assert_eq!((out.status.code(), text(&out.stdout)), (Some(2), String::new()), "{table}");
        assert!(text(&out.stderr).contains(says), "{table}: {}", text(&out.stderr));
    }
    // A column that nothing needs may be missing.
    let out = with_input(&["eval", "--batch", "-", "--want", "best-n"], "e,m2,m1\n9/10,1,10\n");
    assert!(text(&out.stdout).contains("\n10,1,9/10,,3,false"), "{}", text(&out.stdout));
    // Fields that are no numbers stay one field.
    let out = ask("m1,m2,e,n\n\"1,x\",1,9/10,7\n");
    assert!(text(&out.stdout).ends_with("\n\"1,x\",1,9/10,7,,,\n"), "{}", text(&out.stdout));
}

#[test]
fn the_scene_page_holds_the_schema() {
    let out = carom(&["help", "scene"]);
    let page = text(&out.stdout);
    let schema: Value = serde_json::from_str(&page[page.find("{\n").unwrap()..]).unwrap();
    let known: Vec<&String> = schema["properties"]["chain"]["properties"].as_object().unwrap().keys().collect();
    assert_eq!(known, ["first", "last", "inserted", "restitution", "speed", "velocities"]);
}

#[test]
fn many_digits_are_printed_in_full() {
    let ask = |flags: &[&str]| {
        let out = carom(&[&["eval", "--m1", "10", "--m2", "1", "-e", "9/10", "-n", "7"], flags].concat());
        assert_eq!(out.status.code(), Some(0), "{}", text(&out.stderr));
        text(&out.stdout).split_whitespace().nth(1).unwrap().to_owned()
    };
    let long = ask(&["--digits", "100000"]);
    assert_eq!(long.len(), 100_002);
    assert!(long.starts_with("0.37313751177373857462122227887322515231335858138925"));
    // To nearest: within a unit of the last place of the longer one.
    assert_eq!(long[..69_000], ask(&["--digits", "70000"])[..69_000]);
    assert_eq!(ask(&["--places", "100000"]), long);
    let tiny = carom(&["eval", "--m1", "1", "--m2", "1", "-e", "0", "-n", "200000", "--places", "70000"]);
    assert!(text(&tiny.stdout).split_whitespace().nth(1).unwrap().bytes().skip(2).all(|b| b == b'0'));
}
