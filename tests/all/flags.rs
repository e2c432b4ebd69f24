//! One grammar of flags: places to write, forms by name, lists, standard input, and one clear error for each slip.

use crate::support::{carom, good, text, with_input};
use std::process::Command;

const CLAIM: &str = "claim c \"t\"\ngiven x > 0\nprove x/x = 1\n";
const SCENE: &str = "[chain]\nfirst = 10\nlast = 1\ninserted = 2\nrestitution = \"1/2\"\n";
const LINE: &str =
    "restitution = 1\n[[body]]\nmass = 1\nposition = 0\nvelocity = 1\n[[body]]\nmass = 1\nposition = 1\nvelocity = 0\n";

#[test]
fn every_command_that_prints_writes_to_a_file_in_the_form_of_its_name() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).display().to_string();
    let scene = path("scene.toml");
    let line = path("line.toml");
    std::fs::write(&scene, SCENE).expect("written");
    std::fs::write(&line, LINE).expect("written");
    let eval = ["eval", "--m1", "10", "--m2", "1", "-e", "1/2", "-n", "2"];
    let cases: [(&[&str], &str, &str); 21] = [
        (&["audit", "--only", "eq13"], "a.json", "{"),
        (&["audit", "--only", "eq13"], "a.xml", "<?xml"),
        (&["audit", "--only", "eq13"], "a.md", "#"),
        (&["audit", "--only", "eq13"], "a.txt", "2 One inserted body"),
        (&["explain", "eq13"], "e.tex", "\\documentclass"),
        (&["explain", "eq13"], "e.md", "#"),
        (&["print", "eq13"], "p.tex", "\\"),
        (&["print", "eq13"], "p.claim", "claim"),
        (&["list"], "l.json", "["),
        (&["list"], "l.txt", "1 Two bodies"),
        (&["check"], "c.txt", "accepted"),
        (&eval, "v.json", "{"),
        (&["table", "--ratio", "2", "-e", "1", "-n", "1"], "t.csv", "# formula"),
        (&["table", "--ratio", "2", "-e", "1", "-n", "1"], "t.JSON", "{"),
        (&["worksheet", &scene], "w.md", "#"),
        (&["replay", &line], "r.svg", "<svg"),
        (&["replay", &line], "r.html", "<!"),
        (&["replay", &line], "r.csv", "number,time"),
        (&["export", "coq", "eq13"], "x.v", "(*"),
        (&["completions", "bash"], "carom.bash", "_carom"),
        (&["plot", "eta-n"], "p.svg", "<svg"),
    ];
    for (arguments, name, sign) in cases {
        for flag in ["-o", "--output"] {
            let path = path(name);
            let _ = std::fs::remove_file(&path);
            let printed = good(&[arguments, &[flag, &path]].concat());
            assert_eq!(printed, "", "{arguments:?} {name}");
            let written = std::fs::read_to_string(&path).expect("written");
            let begin: String = written.chars().take(40).collect();
            assert!(begin.starts_with(sign) || name == "e.tex" || name == "p.tex", "{arguments:?} {name}: {begin}");
        }
        if name != "p.svg" {
            let (printed, to_dash) = (good(arguments), good(&[arguments, &["-o", "-"]].concat()));
            assert_eq!(printed, to_dash, "{arguments:?}: - is standard output");
        }
    }
    assert!(good(&["plot", "eta-n", "-o", "-"]).starts_with("<svg"));
    assert!(!std::path::Path::new("-").exists(), "no file is called -");
    // What is asked for in words wins over the name.
    let named = path("words.csv");
    good(&["table", "--ratio", "2", "-e", "1", "-n", "1", "--format", "json", "-o", &named]);
    assert!(std::fs::read_to_string(&named).expect("written").starts_with('{'));
}

#[test]
fn standard_input_is_read_wherever_a_file_is() {
    for (arguments, input, sign) in [
        (&["audit", "-"][..], CLAIM, "1 proved"),
        (&["fmt", "-"], "claim c \"t\"\ngiven x>0\nprove x/x=1\n", CLAIM),
        (&["print", "-"], CLAIM, "prove x/x = 1"),
        (&["list", "-"], CLAIM, "  c  "),
        (&["explain", "c", "-"], CLAIM, "c"),
        (&["export", "coq", "c", "--from", "-"], CLAIM, "Definition c"),
        (&["eval", "-"], SCENE, "eta"),
        (&["worksheet", "-"], SCENE, "scene"),
        (&["plot", "velocities", "-", "-o", "-"], SCENE, "<svg"),
        (&["replay", "-"], LINE, "1"),
        (&["eval", "--batch", "-"], "10,1,1/2,3\n", "0.0721975914630917"),
        (&["table", "--check", "-"], "ratio,e,n,eta\n2,1,1,0.9420\n", "1 right"),
    ] {
        let out = with_input(arguments, input);
        assert_eq!(out.status.code(), Some(0), "{arguments:?}: {}{}", text(&out.stderr), text(&out.stdout));
        assert!(text(&out.stdout).contains(sign), "{arguments:?}: {}", text(&out.stdout));
    }
    let out = with_input(&["fmt", "--check", "-"], "claim c \"t\"\ngiven x>0\nprove x/x=1\n");
    assert_eq!(out.status.code(), Some(1));
}

#[cfg(target_os = "linux")]
#[test]
fn claims_are_read_from_a_pipe_by_its_name() {
    let out = with_input(&["audit", "/dev/fd/0"], CLAIM);
    assert_eq!(out.status.code(), Some(0), "{}", text(&out.stderr));
}

#[test]
fn lists_have_commas_or_repeated_flags() {
    let both = |a: &[&str], b: &[&str]| {
        let (a, b) = (good(a), good(b));
        assert_eq!(a, b);
        a
    };
    both(&["audit", "--only", "eq13,eq14"], &["audit", "--only", "eq13", "--only", "eq14"]);
    both(&["audit", "--only", "eq13,eq14"], &["audit", "--only", "eq13", "eq14"]);
    let chain = ["eval", "--m1", "10", "--m2", "1"];
    let of = |more: &[&'static str]| [&chain[..], more].concat();
    both(
        &of(&["-e", "1,1/2", "--masses", "5", "--want", "eta,masses"]),
        &of(&["-e", "1", "-e", "1/2", "--masses", "5", "--want", "eta", "--want", "masses"]),
    );
    both(
        &["table", "--ratio", "2;3", "-e", "1,1/2", "-n", "1,2"],
        &["table", "--ratio", "2", "--ratio", "3", "-e", "1", "-e", "1/2", "-n", "1", "-n", "2"],
    );
    both(&["plot", "eta-n", "-e", "0.5,0.9", "-o", "-"], &["plot", "eta-n", "-e", "0.5", "-e", "0.9", "-o", "-"]);
    both(&of(&["-e", "1", "-n", "1e3"]), &of(&["-e", "1", "--inserted", "1000"]));
    both(&of(&["-e", "1/3", "-n", "1", "--round", "nearest-even"]), &of(&["-e", "1/3", "-n", "1"]));
}

#[test]
fn bodies_are_a_table_counted_from_one_and_named_as_in_the_paper() {
    let shown =
        good(&["eval", "--m1", "64", "--m2", "1", "-e", "44/81", "-n", "2", "--want", "masses,velocities,losses"]);
    let rows: Vec<Vec<&str>> = shown.lines().map(|l| l.split_whitespace().collect()).collect();
    assert_eq!(rows[0], ["body", "mass", "velocity"]);
    assert_eq!(rows[1], ["1", "m₁", "64.0000000000000", "=", "64", "0.691358024691358", "=", "56/81"]);
    assert_eq!(rows[2][..2], ["2", "μ₁"]);
    assert_eq!(rows[4], ["4", "m₂", "1.00000000000000", "=", "1", "1.88167642315892", "=", "1000000/531441"]);
    assert!(rows[5][0] == "losses[1]" && !shown.contains("[0]"), "{shown}");
}

#[test]
fn quiet_says_what_is_not_as_expected_and_colours_can_be_asked_for() {
    let out = with_input(&["audit", "-", "--quiet"], &format!("{CLAIM}claim d \"u\"\ngiven x > 0\nprove x > 1\n"));
    assert_eq!(out.status.code(), Some(1));
    let shown = text(&out.stdout);
    assert!(!shown.contains(" c  t") && shown.contains("d  u") && shown.contains("1 not as expected"), "{shown}");
    assert_eq!(good(&["audit", "--only", "eq13", "-q"]).lines().count(), 1);
    let out = carom(&["export", "smt2", "-q"]);
    assert_eq!(text(&out.stderr), "", "no note on what was left out");
    assert!(good(&["--color", "always", "audit", "--only", "eq13"]).contains("\u{1b}["));
    assert!(!good(&["audit", "--only", "eq13", "--color", "never"]).contains("\u{1b}["));
}

#[test]
fn the_system_knows_the_claims_the_quantities_and_the_pages() {
    for shell in ["bash", "zsh", "fish"] {
        let script = good(&["completions", shell]);
        for word in ["p-final-repaired", "last-velocity", "language"] {
            assert!(script.contains(word), "{shell} does not know {word}");
        }
    }
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("man");
    good(&["man", "-o", &path.display().to_string()]);
    let pages = std::fs::read_dir(&path).expect("made").count();
    assert!(pages > 15 && path.join("carom-audit.1").is_file(), "{pages}");
    assert!(good(&["man", "eval"]).contains("\\-\\-digits") && good(&["man"]).contains("Exit codes"));
    let list = good(&["list"]);
    assert!(list.contains("eq13") && list.contains("(expected: refuted)"), "{list}");
    let rows: serde_json::Value = serde_json::from_str(&good(&["list", "--format", "json"])).expect("JSON");
    assert!(rows.as_array().expect("a list").iter().any(|row| row["id"] == "p-final" && row["expected"] == "refuted"));
}

#[test]
fn the_help_names_defaults_and_is_as_wide_as_the_terminal() {
    for (topic, defaults) in [
        ("eval", &["[default: 15]", "[default: eta]", "[default: nearest]", "[default: optimal]"][..]),
        ("plot", &["[default: 1/1000,1000]", "[default: 0.9]", "[default: 100]"]),
        ("table", &["[default: 6]", "[default: nearest]"]),
        ("test", &["[default: 256]"]),
    ] {
        let help = good(&["help", topic]).split_whitespace().collect::<Vec<_>>().join(" ");
        for default in defaults {
            assert!(help.contains(default), "{topic} {default}: {help}");
        }
    }
    let narrow = Command::new(env!("CARGO_BIN_EXE_carom")).args(["help", "eval"]).env("COLUMNS", "60").output();
    let narrow = text(&narrow.expect("it starts").stdout);
    let width = narrow.lines().map(|line| line.chars().count()).max();
    assert!(width <= Some(62), "{width:?}: {narrow}");
    let whole = good(&["help"]);
    assert!(whole.contains("130  interrupted"), "{whole}");
}

/// Each slip is answered by one error, which says what is wrong, and exit code 2; nothing is printed.
#[test]
fn bad_input_gets_one_clear_error() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).display().to_string();
    let claim = path("mine.claim");
    std::fs::write(&claim, CLAIM).expect("written");
    let chain = |more: &[&'static str]| [&["eval", "--m1", "5", "--m2", "1"], more].concat();
    let of_table = |more: &[&'static str]| [&["table", "--ratio", "2"], more].concat();
    let svg = path("a.svg");
    let nowhere = path("no/such/folder/t.txt");
    let cases: Vec<(Vec<&str>, &str)> = vec![
        (vec!["eval", "--m1", "1,000", "--m2", "1", "-e", "1", "-n", "1"], "two readings: write 1000 or 1.000"),
        (vec!["eval", "--m1", "5 kg", "--m2", "1", "-e", "1", "-n", "1"], "without a unit"),
        (vec!["eval", "--m1", "NaN", "--m2", "1", "-e", "1", "-n", "1"], "expected a number, found 'N'"),
        (vec!["eval", "--m1", "1/0", "--m2", "1", "-e", "1", "-n", "1"], "the denominator at character 3 is zero"),
        (chain(&["-e", "1", "-n", "1.5"]), "-n: expected a natural number, found \"1.5\""),
        (chain(&["-e", "1", "-n", "-1"]), "-n: expected a natural number, found \"-1\""),
        (chain(&["-e", "1", "-n", "1", "--want", "etaa"]), "did you mean \"eta\"?"),
        (chain(&["-e", "1", "-n", "1", "--round", "sideways"]), "invalid value 'sideways'"),
        (chain(&["-e", "2", "-n", "1"]), "-e: a coefficient of restitution"),
        (vec!["audit", "--only", "eq13,eq114"], "no claim is called eq114; did you mean"),
        (vec!["audit", "--only", "eq13", "-o", &svg], "this command writes no .svg file"),
        (vec!["list", "-o", &svg], "use .json or .txt"),
        (vec!["check", "-o", "t.docx"], "writes no .docx file; use .txt"),
        (vec!["eval", "--batch", "-", "-o", "t.docx"], "use .csv or .txt"),
        (vec!["repair", "eq13", "-o", "t.docx"], "use .claim or .txt"),
        (vec!["read", "t.tex", "-o", "t.docx"], "use .claim or .txt"),
        (vec!["export", "coq", "eq13", "-o", "t.docx"], "use .v, .smt2 or .txt"),
        (vec!["worksheet", "s.toml", "-o", "t.docx"], "use .md, .markdown, .tex, .html, .htm, .pdf or .txt"),
        (vec!["audit", "--only", "eq13", "-o", &nowhere], "cannot write"),
        (vec!["audit", "--color", "green"], "invalid value 'green'"),
        (vec!["audit", "/no/such.claim"], "cannot read /no/such.claim"),
        (vec!["audit", "eq13"], "for the claim eq13 of the built-in catalogue write --only eq13"),
        (vec!["list", "/no/such.claim"], "cannot read /no/such.claim"),
        (vec!["man", "etaa"], "there is no help topic called etaa"),
        (vec!["help", "exlain"], "did you mean explain?"),
        (vec!["fmt", "-", &claim], "- reads standard input"),
        (of_table(&["-e", "1", "-n", "1", "-o", "t.csv", "--format", "xls"]), "invalid value 'xls'"),
        (of_table(&["-e", "1", "--ratio", "2", "-n", "1"]), "2 is given twice"),
        (vec!["explain", "eq113"], "no claim is called eq113; did you mean"),
        (vec!["completions", "tcsh"], "invalid value 'tcsh'"),
        (vec!["test", "--cases", "0"], "--cases"),
    ];
    for (arguments, sign) in cases {
        let out = with_input(&arguments, "");
        let said = text(&out.stderr);
        assert_eq!(out.status.code(), Some(2), "{arguments:?}: {said}");
        assert!(said.contains(sign), "{arguments:?}: {said}");
        assert_eq!(said.matches("error: ").count(), 1, "{arguments:?}: {said}");
        assert!(out.stdout.is_empty(), "{arguments:?}: {}", text(&out.stdout));
    }
    assert_eq!(std::fs::read_dir(folder.path()).expect("there").count(), 1, "nothing is left behind");
}

#[test]
fn a_number_means_the_same_in_every_flag_and_file() {
    let chain = |m1: &str, e: &str| good(&["eval", "--m1", m1, "--m2", "1", "-e", e, "-n", "2"]);
    let right = chain("1000", "0.9");
    for e in ["0,9", ".9", "90 %", "9/10", "9\u{2044}10", "9·10^-1"] {
        assert_eq!(chain("1000", e), right, "{e}");
    }
    for m1 in ["1 000", "10^3", "1e3", "1\u{202f}000", "2000/2"] {
        assert_eq!(chain(m1, "0.9"), right, "{m1}");
    }
    let measured = good(&["eval", "--m1", "57.1 ± 0.571", "--m2", "1", "-e", "0.9", "-n", "2"]);
    for m1 in ["57.1 ± 1 %", "57,1 ± 1 %", "[56.529, 57.671]", "[56,5290; 57,6710]"] {
        assert_eq!(good(&["eval", "--m1", m1, "--m2", "1", "-e", "0.9", "-n", "2"]), measured, "{m1}");
    }
    // Lists and axes.
    let list = |e: &str| good(&["eval", "--m1", "10", "--m2", "1", "-e", e, "--masses", "5"]);
    assert_eq!(list("0,9; 0,8"), list("0.9,0.8"));
    assert_eq!(list("90 %; 80 %"), list("0.9,0.8"));
    let axis =
        |e: &str| good(&["table", "--ratio", "10", "-e", e, "-n", "1", "--format", "csv"]).replace("0.90", "0.9");
    assert_eq!(axis("0,9"), axis("0.9"));
    assert_eq!(axis("90 %"), axis("0.9"));
    // Files.
    let eta = |e: &str| {
        let scene = format!("[chain]\nfirst = \"10\"\nlast = 1\ninserted = 2\nrestitution = \"{e}\"\n");
        text(&with_input(&["eval", "-"], &scene).stdout)
    };
    assert_eq!(eta("0,9"), eta("9/10"));
    assert_eq!(eta("90 %"), eta("9/10"));
    let line = |v: &str| {
        let scene = format!(
            "restitution = 1\n[[body]]\nmass = 1\nposition = 0\nvelocity = \"{v}\"\n[[body]]\nmass = 2\nposition = 1\n"
        );
        text(&with_input(&["replay", "-", "--until", "2,5"], &scene).stdout)
    };
    assert_eq!(line("0,5"), line("1/2"));
    let heights = |table: &str| text(&with_input(&["restitution", "-", "--within", "1 %"], table).stdout);
    assert!(heights("height\n1,20\n0,86\n").contains("consistent"));
    assert_eq!(heights("height\n1,20\n0,86\n").replace(',', "."), heights("height\n1.20\n0.86\n").replace(',', "."));
    let checked = with_input(&["table", "--check", "-"], "ratio;e;n;eta\n2;100 %;1;94,20 %\n");
    assert!(text(&checked.stdout).contains("1 right"), "{}", text(&checked.stdout));
    // Two readings are asked about.
    for arguments in [
        &["eval", "--m1", "1,000", "--m2", "1", "-e", "1", "-n", "1"][..],
        &["eval", "--m1", "10", "--m2", "1", "-e", "1", "--masses", "5,2"],
        &["table", "--ratio", "1,5", "-e", "1", "-n", "1"],
        &["table", "--ratio", "10", "-e", "0,1", "-n", "1"],
        &["replay", "-", "--until", "1,000"],
    ] {
        let out = with_input(arguments, "");
        assert_eq!(out.status.code(), Some(2), "{arguments:?}");
        assert!(text(&out.stderr).contains("two readings"), "{arguments:?}: {}", text(&out.stderr));
    }
}

#[test]
fn readings_without_an_uncertainty_are_asked_for_one() {
    let table = "height\n1.20\n0.86\n0.50\n";
    let out = with_input(&["restitution", "-"], table);
    assert_eq!(out.status.code(), Some(1));
    assert!(text(&out.stdout).contains("give one with --within"), "{}", text(&out.stdout));
    let out = with_input(&["restitution", "-", "--within", "0.001"], table);
    assert!(text(&out.stdout).contains("an uncertainty is too small"), "{}", text(&out.stdout));
}
