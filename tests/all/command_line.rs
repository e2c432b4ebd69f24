//! The program as a user meets it.

use crate::support::{carom, for_nobody, text};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::time::Instant;

/// A file in a folder of its own.
fn file(folder: &tempfile::TempDir, name: &str, content: &[u8]) -> PathBuf {
    let path = folder.path().join(name);
    std::fs::File::create(&path).and_then(|mut f| f.write_all(content)).expect("the file is written");
    path
}

fn audit_of(content: &[u8]) -> Output {
    let folder = tempfile::tempdir().expect("a folder");
    let path = file(&folder, "a.claim", content);
    carom(&["audit", &path.display().to_string()])
}

#[test]
fn one_claim_in_json_has_the_shape_of_the_contract_and_costs_no_others() {
    let out = carom(&["audit", "--only", "eq13", "--format", "json"]);
    assert_eq!(out.status.code(), Some(0));
    let value: serde_json::Value = serde_json::from_slice(&out.stdout).expect("JSON");
    let claim = &value["claims"][0];
    assert_eq!(claim["id"], "eq13");
    assert_eq!(claim["number"], 13);
    assert_eq!(claim["verdict"], "proved");
    assert_eq!(claim["as_expected"], true);
    assert_eq!(claim["reading"], "restored");
    assert!(claim["assumptions"].is_array() && claim["witness"].is_null());
    assert_eq!(claim["certificate"].as_str().map(str::len), Some(64));
    assert_eq!(value["summary"]["judged"], 1);
    assert_eq!(value["summary"]["unexpected"], 0);
}

#[test]
fn a_refutation_carries_its_witness() {
    let out = carom(&["audit", "--only", "p-final", "--format", "json"]);
    let value: serde_json::Value = serde_json::from_slice(&out.stdout).expect("JSON");
    assert_eq!(value["claims"][0]["verdict"], "refuted");
    assert!(value["claims"][0]["witness"]["x"].is_string());
}

#[test]
fn exit_codes_tell_what_happened() {
    let header = "claim c \"t\"\ngiven x > 0\n";
    assert_eq!(audit_of(format!("{header}prove x/x = 1\n").as_bytes()).status.code(), Some(0));
    assert_eq!(audit_of(format!("{header}prove x > 1\n").as_bytes()).status.code(), Some(1));
    assert_eq!(audit_of(format!("{header}prove x > \n").as_bytes()).status.code(), Some(2));
    assert_eq!(
        audit_of(format!("{header}prove (x + 1)^(10^9) > 0 and (x + 2)^(10^9) - (x + 1)^(10^9) > 0\n").as_bytes())
            .status
            .code(),
        Some(3)
    );
    assert_eq!(carom(&["audit", "--only", "eq99"]).status.code(), Some(2));
    assert_eq!(carom(&["audit", "/no/such/file.claim"]).status.code(), Some(2));
    assert_eq!(carom(&["nonsense"]).status.code(), Some(2));
}

#[test]
fn a_name_that_matches_nothing_is_answered_with_the_nearest() {
    let out = carom(&["audit", "--only", "eq113"]);
    assert!(text(&out.stderr).contains("did you mean"), "{}", text(&out.stderr));
}

#[test]
fn hypotheses_that_cannot_hold_are_an_error() {
    let out = audit_of(b"claim c \"t\"\ngiven x > 0\nassume low: x < -1\nprove x = 7\n");
    assert_eq!(out.status.code(), Some(2));
    assert!(text(&out.stderr).contains("contradict each other"), "{}", text(&out.stderr));
}

#[test]
fn malformed_files_are_answered_within_a_second() {
    let folder = tempfile::tempdir().expect("a folder");
    let deep = format!("claim c \"t\"\ngiven x > 0\nprove {}x{} = x\n", "(".repeat(100_000), ")".repeat(100_000));
    let numeral = format!("claim c \"t\"\ngiven x > 0\nprove x = {}\n", "7".repeat(50_000));
    let circle = "claim a \"t\"\nusing b\ngiven x > 0\nprove x = x by b\nclaim b \"t\"\nusing a\ngiven x > 0\nprove x = x by a\n";
    let cases: [(&str, &[u8], i32); 6] = [
        ("empty.claim", b"", 2),
        ("cut.claim", b"claim c \"t\"\ngiven x >", 2),
        ("deep.claim", deep.as_bytes(), 3),
        ("numeral.claim", numeral.as_bytes(), 3),
        ("bytes.claim", b"claim c \"t\"\n\xff\xfe", 2),
        ("circle.claim", circle.as_bytes(), 2),
    ];
    for (name, content, code) in cases {
        let path = file(&folder, name, content);
        let started = Instant::now();
        let out = carom(&["audit", &path.display().to_string()]);
        assert_eq!(out.status.code(), Some(code), "{name}: {}", text(&out.stderr));
        assert!(started.elapsed().as_secs_f64() < 1.0, "{name} took {:?}", started.elapsed());
        assert!(text(&out.stderr).contains(name), "{name}: {}", text(&out.stderr));
        assert!(out.stdout.is_empty());
    }
    let power = file(&folder, "power.claim", b"claim c \"t\"\ngiven x > 0\nprove x^(10^9) > 0\n");
    let started = Instant::now();
    let out = carom(&["audit", &power.display().to_string()]);
    // The search sees it; the kernel does not follow so large a power, and says so.
    assert_eq!(out.status.code(), Some(3), "{}", text(&out.stdout));
    assert!(text(&out.stdout).contains("limit of the kernel"), "{}", text(&out.stdout));
    assert!(started.elapsed().as_secs_f64() < 1.0, "{:?}", started.elapsed());
}

#[test]
fn nothing_is_written_where_the_input_is_bad() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = file(&folder, "bad.claim", b"claim c \"t\"\nprove x\n");
    let output = folder.path().join("report.json");
    let out =
        carom(&["audit", &path.display().to_string(), "--format", "json", "--output", &output.display().to_string()]);
    assert_eq!(out.status.code(), Some(2));
    assert!(!output.exists());
}

#[test]
fn a_reader_that_goes_away_is_no_error() {
    let out = for_nobody(&["help", "language"]);
    assert_eq!(text(&out.stderr), "");
    assert_eq!(out.status.code(), Some(0));
}

#[test]
fn reports_have_no_colours_outside_a_terminal() {
    let out = carom(&["audit", "--only", "eq05"]);
    assert!(!text(&out.stdout).contains('\u{1b}'));
    assert!(text(&out.stdout).contains("proved"));
}

#[test]
fn a_long_statement_is_cut_short() {
    let sum = (1..60).map(|k| format!("x + {k}")).collect::<Vec<_>>().join(" + ");
    let out = audit_of(format!("claim long \"Long\"\ngiven x > 0\nprove {sum} > 58\n").as_bytes());
    assert_eq!(out.status.code(), Some(0), "{}", text(&out.stderr));
    assert!(text(&out.stdout).contains("+ x + 59 > 58\n"), "{}", text(&out.stdout));
}

#[test]
fn every_format_and_the_argument_of_a_claim_are_printed() {
    for (form, sign) in [("markdown", "| claim |"), ("junit", "<testsuite"), ("text", "all as expected")] {
        let out = carom(&["audit", "--only", "eq05", "eq06", "--format", form]);
        assert!(text(&out.stdout).contains(sign), "{form}: {}", text(&out.stdout));
    }
    let out = carom(&["explain", "b-grow"]);
    assert!(text(&out.stdout).contains("inequality between geometric and arithmetic mean"), "{}", text(&out.stdout));
    let out = carom(&["explain", "eq13", "--format", "latex"]);
    assert!(text(&out.stdout).contains("\\textit{Prove}"));
}

#[test]
fn fmt_rewrites_once_and_checks() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = file(&folder, "a.claim", b"claim c \"t\"\ngiven x>0   # a mass\nprove   x/x=1\n");
    let name = path.display().to_string();
    assert_eq!(carom(&["fmt", "--check", &name]).status.code(), Some(1));
    assert_eq!(carom(&["fmt", &name]).status.code(), Some(0));
    let formatted = std::fs::read_to_string(&path).expect("it is there");
    assert_eq!(formatted, "claim c \"t\"\ngiven x > 0  # a mass\nprove x/x = 1\n");
    assert_eq!(carom(&["fmt", "--check", &name]).status.code(), Some(0));
}

#[cfg(unix)]
#[test]
fn written_files_keep_their_mode_and_new_ones_get_what_the_mask_allows() {
    use std::os::unix::fs::PermissionsExt;
    let mode = |path: &std::path::Path| std::fs::metadata(path).expect("it is there").permissions().mode() & 0o777;
    let folder = tempfile::tempdir().expect("a folder");
    let path = file(&folder, "a.claim", b"claim c \"t\"\ngiven x>0\nprove x/x=1\n");
    for wanted in [0o640, 0o755, 0o600] {
        std::fs::write(&path, b"claim c \"t\"\ngiven x>0\nprove x/x=1\n").expect("written");
        std::fs::set_permissions(&path, std::fs::Permissions::from_mode(wanted)).expect("set");
        assert_eq!(carom(&["fmt", &path.display().to_string()]).status.code(), Some(0));
        assert_eq!(mode(&path), wanted);
    }
    // What a plain new file gets here says what the mask allows.
    let plain = mode(&file(&folder, "plain", b""));
    let new = folder.path().join("new.json");
    let out = carom(&["audit", "--only", "eq05", "--format", "json", "--output", &new.display().to_string()]);
    assert_eq!(out.status.code(), Some(0));
    assert_eq!(mode(&new), plain);
}

#[cfg(unix)]
#[test]
fn output_goes_through_links_and_into_devices() {
    let folder = tempfile::tempdir().expect("a folder");
    let target = file(&folder, "target.txt", b"old");
    let link = folder.path().join("link.txt");
    std::os::unix::fs::symlink("target.txt", &link).expect("a link");
    let dangling = folder.path().join("dangling.txt");
    std::os::unix::fs::symlink("made.txt", &dangling).expect("a link");
    for (name, end) in [(&link, &target), (&dangling, &folder.path().join("made.txt"))] {
        let out = carom(&["audit", "--only", "eq05", "--output", &name.display().to_string()]);
        assert_eq!(out.status.code(), Some(0), "{}", text(&out.stderr));
        assert!(std::fs::symlink_metadata(name).expect("there").file_type().is_symlink(), "the link stays");
        assert!(std::fs::read_to_string(end).expect("there").contains("1 proved"));
    }
    // A device stands for whatever is no regular file; replacing it would break the machine.
    let null = folder.path().join("null");
    std::os::unix::fs::symlink("/dev/null", &null).expect("a link");
    let out = carom(&["audit", "--only", "eq05", "--output", &null.display().to_string()]);
    assert_eq!(out.status.code(), Some(0), "{}", text(&out.stderr));
    let after = std::fs::metadata("/dev/null").expect("there");
    assert!(!after.is_file());
    for (from, to) in [("a", "b"), ("b", "a")] {
        std::os::unix::fs::symlink(to, folder.path().join(from)).expect("a link");
    }
    let out = carom(&["audit", "--only", "eq05", "--output", &folder.path().join("a").display().to_string()]);
    assert_eq!(out.status.code(), Some(2));
    assert!(text(&out.stderr).contains("circle"), "{}", text(&out.stderr));
    let out = carom(&["audit", "--only", "eq05", "--output", &folder.path().display().to_string()]);
    assert_eq!(out.status.code(), Some(2));
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_reported() {
    let folder = tempfile::tempdir().expect("a folder");
    let batch = file(&folder, "batch.csv", b"10,1,1/2,3\n").display().to_string();
    let broken = file(&folder, "broken.csv", b"10,1,1/2,3\n10,1\n").display().to_string();
    let long = file(&folder, "long.csv", "10,1,1/2,3\n".repeat(5_000).as_bytes()).display().to_string();
    for arguments in [["eval", "--batch", &batch], ["eval", "--batch", &long]] {
        let full = std::fs::OpenOptions::new().write(true).open("/dev/full").expect("it opens");
        let out = Command::new(env!("CARGO_BIN_EXE_carom")).args(arguments).stdout(full).output().expect("it runs");
        assert_eq!(out.status.code(), Some(2), "{arguments:?}");
        assert!(text(&out.stderr).contains("cannot write to standard output"), "{}", text(&out.stderr));
    }
    let out = carom(&["eval", "--batch", &broken]);
    assert_eq!(out.status.code(), Some(2));
    assert_eq!(text(&out.stdout).lines().count(), 3, "a row for each line, also for a bad one");
    for arguments in [&["audit", "--only", "eq05"][..], &["help", "language"], &["explain", "eq05"], &["help", "audit"]]
    {
        let full = std::fs::OpenOptions::new().write(true).open("/dev/full").expect("it opens");
        let out = Command::new(env!("CARGO_BIN_EXE_carom")).args(arguments).stdout(full).output().expect("it runs");
        assert_eq!(out.status.code(), Some(2), "{arguments:?}");
        assert!(text(&out.stderr).contains("cannot write to standard output"), "{}", text(&out.stderr));
    }
}

#[test]
fn the_version_names_no_time_and_at_most_a_commit() {
    let out = carom(&["--version"]);
    let said = text(&out.stdout);
    let rest = said.strip_prefix(&format!("carom {}", env!("CARGO_PKG_VERSION"))).expect("name and version").trim();
    let commit =
        rest.strip_prefix('(').and_then(|rest| rest.strip_suffix(')')).map(|inside| inside.replace(", changed", ""));
    assert!(
        rest.is_empty() || commit.is_some_and(|c| c.len() == 12 && c.bytes().all(|b| b.is_ascii_hexdigit())),
        "{said}"
    );
}

#[test]
fn help_on_a_subcommand_shows_how_the_program_is_called() {
    for name in ["audit", "explain", "fmt"] {
        let out = carom(&["help", name]);
        assert!(text(&out.stdout).contains(&format!("Usage: carom {name} ")), "{}", text(&out.stdout));
    }
}

#[cfg(target_os = "linux")]
#[test]
fn an_endless_file_is_read_no_further_than_the_limit() {
    for command in ["audit", "fmt"] {
        let started = Instant::now();
        let out = carom(&[command, "/dev/zero"]);
        assert_eq!(out.status.code(), Some(3));
        assert!(text(&out.stderr).contains("limit reached"), "{}", text(&out.stderr));
        assert!(started.elapsed().as_secs_f64() < 1.0);
    }
}

#[test]
fn a_name_used_in_two_files_is_shown_in_the_second_with_the_first_named() {
    let folder = tempfile::tempdir().expect("a folder");
    let first = file(&folder, "first.claim", b"# one\nclaim same \"t\"\ngiven x > 0\nprove x = x\n");
    let second = file(&folder, "second.claim", b"claim same \"u\"\ngiven x > 0\nprove x = x\n");
    let out = carom(&["audit", &first.display().to_string(), &second.display().to_string()]);
    assert_eq!(out.status.code(), Some(2));
    let said = text(&out.stderr);
    assert!(said.contains(&format!("--> {}:1:7", second.display())), "{said}");
    assert!(said.contains(&format!("{}:2:7", first.display())), "{said}");
}

#[cfg(unix)]
#[test]
fn a_file_reached_twice_is_read_once_and_links_in_a_circle_end() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = file(&folder, "a.claim", b"claim c \"t\"\ngiven x > 0\nprove x = x\n");
    std::os::unix::fs::symlink(".", folder.path().join("again")).expect("a link");
    std::os::unix::fs::symlink("a.claim", folder.path().join("b.claim")).expect("a link");
    let (whole, path) = (folder.path().display().to_string(), path.display().to_string());
    for arguments in [&["audit", &path, &path][..], &["audit", &whole, &path], &["audit", &path, &whole, &whole]] {
        let out = carom(arguments);
        assert_eq!(out.status.code(), Some(0), "{arguments:?}: {}", text(&out.stderr));
        assert!(text(&out.stdout).contains("1 claim: 1 proved"), "{}", text(&out.stdout));
    }
    for (from, to) in [("x.claim", "y.claim"), ("y.claim", "x.claim")] {
        std::os::unix::fs::symlink(to, folder.path().join(from)).expect("a link");
    }
    let out = carom(&["audit", &whole]);
    assert_eq!(out.status.code(), Some(2));
    assert!(text(&out.stderr).contains("cannot read"), "{}", text(&out.stderr));
}

#[test]
fn faults_that_are_not_shown_are_counted() {
    let content = format!("claim c \"t\"\ngiven x > 0\n{}prove x = x\n", "assume x = = 1\n".repeat(33));
    let out = audit_of(content.as_bytes());
    assert_eq!(out.status.code(), Some(2));
    assert!(text(&out.stderr).contains("13 more faults"), "{}", text(&out.stderr));
}

#[test]
fn each_section_has_one_heading_in_the_order_of_the_catalogue() {
    let sections = ["b", "a", "b", "a", "c"];
    let content: String = sections
        .iter()
        .enumerate()
        .map(|(i, s)| format!("claim c{i} \"t\"\nsection \"part {s}\"\ngiven x > 0\nprove x = x\n\n"))
        .collect();
    let folder = tempfile::tempdir().expect("a folder");
    let path = file(&folder, "a.claim", content.as_bytes()).display().to_string();
    for format in ["text", "markdown"] {
        let shown = text(&carom(&["audit", &path, "--format", format]).stdout);
        let places: Vec<usize> = ["part b", "c0", "c2", "part a", "c1", "c3", "part c", "c4"]
            .iter()
            .map(|w| shown.find(w).expect(w))
            .collect();
        assert!(places.is_sorted(), "{shown}");
        for section in ["part a", "part b", "part c"] {
            assert_eq!(shown.matches(section).count(), 1, "{shown}");
        }
        assert!(shown.contains("5 claims"), "{shown}");
    }
}

#[test]
fn each_pair_of_sides_is_said_to_be_of_which_comparison() {
    let out = audit_of(b"claim c \"t\"\ngiven x, y > 0\nprove x > y + 1 and y > x + 1\n");
    let shown = text(&out.stdout);
    for line in shown.lines().filter(|l| l.contains("left side")) {
        assert!(line.contains("x > y + 1: ") || line.contains("y > x + 1: "), "{shown}");
    }
    assert_eq!(shown.matches("left side").count(), 2, "{shown}");
}

#[test]
fn a_path_after_only_is_explained() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = file(&folder, "a.claim", b"claim c \"t\"\ngiven x > 0\nprove x = x\n").display().to_string();
    let out = carom(&["audit", "--only", "eq13", &path]);
    assert_eq!(out.status.code(), Some(2));
    assert!(text(&out.stderr).contains("paths before --only"), "{}", text(&out.stderr));
}

#[test]
fn reports_for_machines_say_what_could_not_be_judged() {
    let folder = tempfile::tempdir().expect("a folder");
    let content =
        b"claim good \"t\"\ngiven x > 0\nprove x = x\nclaim bad \"t\"\ngiven x > 0\nassume low: x < -1\nprove x = 7\n";
    let path = file(&folder, "a.claim", content).display().to_string();
    for (format, sign) in [
        ("junit", "<error message=\"error: the hypotheses of bad contradict each other"),
        ("markdown", "## Errors\n\nbad\n"),
        ("text", "1 claim: 1 proved, 0 refuted, 0 undecided; 1 error"),
        ("json", "\"claim\": \"bad\""),
    ] {
        let out = carom(&["audit", &path, "--format", format]);
        assert_eq!(out.status.code(), Some(2));
        assert!(text(&out.stdout).contains(sign), "{}", text(&out.stdout));
        assert!(text(&out.stderr).contains("contradict each other"));
        if format == "json" {
            let value: serde_json::Value = serde_json::from_slice(&out.stdout).expect("JSON");
            assert_eq!((&value["claims"][0]["id"], &value["summary"]["errors"]), (&"good".into(), &1.into()));
        }
    }
    let broken = file(&folder, "b.claim", b"claim c \"t\"\nprove\n").display().to_string();
    let report = folder.path().join("report.xml");
    let out = carom(&["audit", &broken, "--format", "junit", "--output", &report.display().to_string()]);
    assert_eq!(out.status.code(), Some(2));
    let report = std::fs::read_to_string(report).expect("it is written");
    assert!(report.contains("errors=\"1\"") && report.contains("b.claim"), "{report}");
}

#[test]
fn every_form_of_an_argument_says_why_where_and_how_deep() {
    for (form, signs) in [
        ("latex", ["(8) it follows that\\par}", "x = 1, v1 = 1, e = 1/2", "limit reached"]),
        ("markdown", ["\n    From (8) it follows", "x = 1, v1 = 1, e = 1/2", "limit reached"]),
        ("text", ["\n      From (8) it follows", "x = 1, v1 = 1, e = 1/2", "limit reached"]),
    ] {
        let out = carom(&["explain", "b-grow", "--format", form]);
        assert!(text(&out.stdout).contains(signs[0]), "{}", text(&out.stdout));
        let out = carom(&["explain", "p-final", "--format", form]);
        assert!(text(&out.stdout).contains(signs[1]), "{}", text(&out.stdout));
        let folder = tempfile::tempdir().expect("a folder");
        let content = b"claim big \"t\"\ngiven x > 0\nprove (x + 2)^(10^9) - (x + 1)^(10^9) > 0\n";
        let path = file(&folder, "a.claim", content).display().to_string();
        let out = carom(&["explain", "big", &path, "--format", form]);
        assert!(text(&out.stdout).contains(signs[2]), "{}", text(&out.stdout));
    }
}

#[test]
fn printed_claims_read_back_and_have_three_forms() {
    let folder = tempfile::tempdir().expect("a folder");
    let all = carom(&["print"]);
    assert_eq!(all.status.code(), Some(0));
    let copy = file(&folder, "copy.claim", &all.stdout).display().to_string();
    let again = carom(&["print", &copy]);
    assert_eq!(text(&again.stdout), text(&all.stdout), "what is printed is claim language: {}", text(&again.stderr));
    assert!(text(&all.stdout).matches("\nprove ").count() > 80);
    let out = carom(&["print", "eq13", "u3", "--format", "unicode"]);
    assert!(text(&out.stdout).contains("e₁"), "{}", text(&out.stdout));
    let out = carom(&["print", "eq13", "--format", "latex"]);
    assert!(text(&out.stdout).contains("\\frac"), "{}", text(&out.stdout));
    assert_eq!(carom(&["print", "eq99"]).status.code(), Some(2));
    assert_eq!(carom(&["print", "/no/such.claim"]).status.code(), Some(2));
}

#[test]
fn a_reader_of_a_report_may_go_away() {
    for format in ["text", "json", "markdown", "junit"] {
        let out = for_nobody(&["audit", "--only", "eq05", "--format", format]);
        assert_eq!((text(&out.stderr), out.status.code()), (String::new(), Some(0)), "{format}");
    }
}

#[test]
fn colours_come_when_forced_and_go_with_no_color() {
    let run = |variables: &[(&str, &str)]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_carom"));
        command.args(["audit", "--only", "eq05"]).env_remove("NO_COLOR").env_remove("CLICOLOR_FORCE");
        command.envs(variables.iter().copied());
        text(&command.output().expect("it runs").stdout).contains('\u{1b}')
    };
    assert!(run(&[("CLICOLOR_FORCE", "1")]), "the control: there are colours to drop");
    assert!(!run(&[]));
    assert!(!run(&[("NO_COLOR", "1")]));
}

/// On a terminal, which `script` provides.
#[cfg(target_os = "linux")]
#[test]
fn a_terminal_gets_colours_unless_no_color_is_set() {
    let run = |no_color: &str| {
        let command = format!("{} audit --only eq05", env!("CARGO_BIN_EXE_carom"));
        let out = Command::new("script")
            .args(["-qec", &command, "/dev/null"])
            .env("NO_COLOR", no_color)
            .env("TERM", "xterm")
            .env_remove("CLICOLOR_FORCE")
            .stdin(Stdio::null())
            .output()
            .expect("`script` of util-linux is there");
        text(&out.stdout)
    };
    assert!(run("").contains('\u{1b}'), "the control");
    let plain = run("1");
    assert!(plain.contains("proved") && !plain.contains('\u{1b}'), "{plain:?}");
}

#[test]
fn foreign_text_cannot_steer_a_terminal() {
    let steering = "red \u{1b}[31m, up \u{1b}[1A, bell \u{7}, back \u{8}, turned \u{202e}, C1 \u{9b}2J";
    let shown = "red \\u{1b}[31m, up \\u{1b}[1A, bell \\u{7}, back \\u{8}, turned \\u{202e}, C1 \\u{9b}2J";
    let folder = tempfile::tempdir().expect("a folder");
    let claim =
        format!("claim c \"{steering}\"\nnote \"{steering}\"\nsection \"{steering}\"\ngiven x > 0\nprove x = x\n");
    let claim = file(&folder, "a.claim", claim.as_bytes()).display().to_string();
    let scene = "title = \"a \\u001b[31m b\"\n[[body]]\nmass = 1\nposition = 0\n";
    let scene = file(&folder, "a.toml", scene.as_bytes()).display().to_string();
    for (arguments, sign) in
        [(&["audit", &claim][..], shown), (&["explain", "c", &claim], shown), (&["replay", &scene], "a \\u{1b}[31m b")]
    {
        let out = carom(arguments);
        let said = text(&out.stdout) + &text(&out.stderr);
        assert!(!said.contains(['\u{1b}', '\u{7}', '\u{8}', '\u{202e}', '\u{9b}']), "{arguments:?}: {said:?}");
        assert!(said.contains(sign), "{arguments:?}: {said}");
    }
    // With colours the program's own escapes stay.
    let out = Command::new(env!("CARGO_BIN_EXE_carom"))
        .args(["audit", &claim])
        .env_remove("NO_COLOR")
        .env("CLICOLOR_FORCE", "1")
        .output()
        .expect("it runs");
    assert!(!text(&out.stdout).contains("[1A") || text(&out.stdout).contains("\\u{1b}[1A"), "{}", text(&out.stdout));
}

#[test]
fn scenes_of_another_command_are_told_which_one_reads_them() {
    let folder = tempfile::tempdir().expect("a folder");
    let bodies = file(&folder, "bodies.toml", b"[[body]]\nmass = 1\nposition = 0\n").display().to_string();
    let chain = file(&folder, "chain.toml", b"[chain]\nfirst = 2\nlast = 1\nrestitution = 1\n").display().to_string();
    for (command, scene, sign) in [
        ("eval", &bodies, "`carom replay`"),
        ("worksheet", &bodies, "`carom replay`"),
        ("replay", &chain, "`carom eval`"),
    ] {
        let out = carom(&[command, scene]);
        assert_eq!(out.status.code(), Some(2));
        assert!(text(&out.stderr).contains(sign), "{command}: {}", text(&out.stderr));
    }
}

#[test]
fn a_number_of_bits_agrees_with_its_noun() {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = b"restitution = 1\n[[body]]\nmass = 1\nposition = 0\nvelocity = 1\n[[body]]\nmass = 1\nposition = 1\n";
    let scene = file(&folder, "a.toml", scene).display().to_string();
    let out = carom(&["replay", &scene]);
    assert!(text(&out.stdout).contains("exact number: 1 bit\n"), "{}", text(&out.stdout));
}

#[test]
fn a_broken_file_does_not_silence_the_others() {
    let folder = tempfile::tempdir().expect("a folder");
    file(&folder, "a.claim", b"claim good \"t\"\ngiven x > 0\nprove x > 0\n");
    file(&folder, "b.claim", b"claim bad \"t\"\nprove x = = 1\n");
    file(&folder, "c.claim", b"claim user \"t\"\nusing bad\ngiven x > 0\nprove x > 0 by bad\n");
    file(&folder, "d.claim", b"claim lost \"t\"\nusing nothing\ngiven x > 0\nprove x > 0\n");
    let path = folder.path().display().to_string();
    let out = carom(&["audit", &path]);
    let (said, warned) = (text(&out.stdout), text(&out.stderr));
    assert_eq!(out.status.code(), Some(2), "{warned}");
    assert!(said.contains("1 claim: 1 proved") && said.contains("3 errors"), "{said}");
    for message in ["b.claim:2:11", "bad, which user cites, could not be read", "no claim is called nothing"] {
        assert!(warned.contains(message), "{message}: {warned}");
    }
    assert_eq!(carom(&["list", &path]).status.code(), Some(2), "other commands take the whole folder or nothing");
}

#[test]
fn a_claim_may_cite_the_built_in_catalogue() {
    let folder = tempfile::tempdir().expect("a folder");
    let claim = b"claim mine \"t\"\nusing lemma-tangent\ngiven x > 0\nprove x > 0\n";
    let path = file(&folder, "mine.claim", claim).display().to_string();
    let certificates = folder.path().join("certificates").display().to_string();
    let out = carom(&["audit", &path, "--certificates", &certificates]);
    assert_eq!(out.status.code(), Some(0), "{}", text(&out.stderr));
    assert!(
        text(&out.stdout).contains("1 claim: 1 proved"),
        "the lemma is not one of the claims: {}",
        text(&out.stdout)
    );
    let out = carom(&["check", &certificates, "--claims", &path]);
    assert!(text(&out.stdout).contains("1 of 1 certificates accepted"), "{}", text(&out.stdout));
}

#[test]
fn a_new_paper_is_audited_and_reported_as_it_is_written() {
    let folder = tempfile::tempdir().expect("a folder");
    let dir = folder.path().join("paper").display().to_string();
    assert_eq!(carom(&["new", &dir, "--title", "Two bodies"]).status.code(), Some(0));
    let out = carom(&["audit", &dir]);
    assert_eq!(out.status.code(), Some(0), "{}", text(&out.stderr));
    assert!(text(&out.stdout).contains("(1.1) half"), "{}", text(&out.stdout));
    assert_eq!(carom(&["fmt", &dir, "--check"]).status.code(), Some(0), "the skeleton is in the one style");
    let report = folder.path().join("report").display().to_string();
    assert_eq!(carom(&["report", &dir, "--out", &report]).status.code(), Some(0));
    let page = std::fs::read_to_string(format!("{report}/index.html")).expect("written");
    assert!(page.contains("<h1>Audit of Two bodies</h1>") && page.contains("One file may hold many claims"), "{page}");
    assert!(!page.contains("Findings"), "there is none");
    assert_eq!(carom(&["new", &dir]).status.code(), Some(2), "a folder that is in use stays as it is");
}

#[test]
fn the_preamble_of_a_folder_holds_for_each_of_its_files() {
    let folder = tempfile::tempdir().expect("a folder");
    let shared = file(&folder, "paper.claim", b"paper \"P\"\ngiven x > 0;  n natural\n");
    let path = file(&folder, "a.claim", b"claim a \"t\"\nprove x^n > 0\n").display().to_string();
    assert_eq!(carom(&["audit", &path]).status.code(), Some(0), "a file by itself means the same as in its folder");
    assert_eq!(carom(&["audit", &folder.path().display().to_string()]).status.code(), Some(0));
    std::fs::write(&shared, "given x >\n").expect("written");
    let out = carom(&["audit", &path]);
    assert_eq!(out.status.code(), Some(2));
    assert!(text(&out.stderr).contains("paper.claim:2:1"), "{}", text(&out.stderr));
}

#[test]
fn a_sample_of_the_author_is_checked_exactly() {
    let of = |sample: &str| {
        let claim = format!("claim c \"t\"\ngiven E, p, m > 0\nassume E^2 = p^2 + m^2\n{sample}prove E^2 > p^2\n");
        text(&audit_of(claim.as_bytes()).stdout)
    };
    assert!(of("sample E = 61, p = 11, m = 60\n").contains("1 proved"), "{}", of("sample E = 61, p = 11, m = 60\n"));
    // A wrong point is no point: another one is sought, as without it.
    assert_eq!(of("sample E = 61, p = 12, m = 60\n").contains("1 proved"), of("").contains("1 proved"));
}

#[test]
fn a_fault_of_one_claim_leaves_the_others_of_its_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let content = b"given x > 0\n\nclaim first \"t\"\nprove x/x = 1\n\nclaim torn \"t\"\nprove x = = 2\n\n\
        claim lost \"t\"\nprove y = 1\n\nclaim cites \"t\"\nusing torn\nprove x + 1 > x\n\nclaim last \"t\"\nprove x + 1 = x\n";
    let path = file(&folder, "a.claim", content).display().to_string();
    for command in ["audit", "test"] {
        let out = carom(&[command, &path]);
        let (shown, said) = (text(&out.stdout), text(&out.stderr));
        assert_eq!(out.status.code(), Some(2), "{command}: {said}");
        assert!(shown.contains("  first  ") && shown.contains("  last  "), "{command}: {shown}");
        assert!(!shown.contains("  torn  ") && !shown.contains("  lost  "), "{command}: {shown}");
        for sign in ["a.claim:7", "a.claim:10", "torn, which cites cites, could not be read"] {
            assert!(said.contains(sign), "{command}: {sign}: {said}");
        }
    }
    // A fault of the preamble is one of all claims.
    let path = file(&folder, "b.claim", b"given x >\n\nclaim first \"t\"\nprove x/x = 1\n").display().to_string();
    let out = carom(&["audit", &path]);
    assert_eq!((out.status.code(), text(&out.stdout)), (Some(2), String::new()));
}

#[test]
fn junit_names_the_point_the_sides_the_file_and_the_line() {
    let folder = tempfile::tempdir().expect("a folder");
    let content = b"claim good \"t\"\ngiven x > 0\nprove x = x\n\nclaim wrong \"t\"\ngiven x > 0\nprove x + 1 = 3*x\n";
    let path = file(&folder, "a.claim", content).display().to_string();
    let saved = folder.path().join("new/saved");
    let save = saved.display().to_string();
    for (arguments, verdict) in
        [(&["audit", &path][..], "refuted"), (&["test", &path, "--seed", "1", "--save", &save], "counterexample")]
    {
        let out = carom(&[arguments, &["--format", "junit"]].concat());
        let report = text(&out.stdout);
        assert_eq!(out.status.code(), Some(1), "{report}{}", text(&out.stderr));
        let failure = report.split("<failure").nth(1).expect("a failure");
        for sign in [verdict, "fails at x = ", "left side ", "right side "] {
            assert!(failure.contains(sign), "{sign}: {report}");
        }
        assert!(report.contains("failures=\"1\"") && report.contains("tests=\"2\""), "{report}");
        let case = report.split("<testcase ").find(|case| case.starts_with("name=\"wrong t\"")).expect("a case");
        let head = case.split('>').next().expect("its attributes");
        assert!(head.contains("line=\"5\"") && head.contains("a.claim\""), "{head}");
    }
    assert!(saved.join("counterexample-wrong.claim").is_file(), "the folder is made");
}

/// Claims that are judged at once, then many that take their whole time.
#[cfg(unix)]
fn quick_and_slow() -> String {
    let quick = (0..6).map(|k| format!("claim quick{k} \"t\"\ngiven x > 0\nprove x + {k} >= x\n"));
    let slow = (0..12).map(|k| {
        format!("claim slow{k} \"t\"\ngiven x, y, z real\nprove (x^2 + y^4 + z^6 + {k} + 1)^30 != x*y*z + 10^40\n")
    });
    quick.chain(slow).collect()
}

/// What a program prints that is interrupted after some seconds.
#[cfg(unix)]
fn interrupted_after(seconds: u64, runs: &[Vec<&str>]) -> Vec<Output> {
    let begin = |arguments: &Vec<&str>| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_carom"));
        command.args(arguments).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("it starts")
    };
    let begun: Vec<std::process::Child> = runs.iter().map(begin).collect();
    std::thread::sleep(std::time::Duration::from_secs(seconds));
    let end = |child: std::process::Child| {
        let kill = Command::new("kill").args(["-INT", &child.id().to_string()]).status();
        assert!(kill.expect("kill is there").success());
        child.wait_with_output().expect("it ends")
    };
    begun.into_iter().map(end).collect()
}

#[cfg(unix)]
#[test]
fn ctrl_c_leaves_the_verdicts_that_were_found() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = file(&folder, "a.claim", quick_and_slow().as_bytes()).display().to_string();
    let formats = ["text", "json", "junit"];
    let run = |format| vec!["audit", &path, "--format", format, "--time", "600", "--max-steps", "100000000"];
    for (format, out) in formats.iter().zip(interrupted_after(20, &formats.map(run))) {
        let (shown, said) = (text(&out.stdout), text(&out.stderr));
        assert_eq!(out.status.code(), Some(130), "{format}: {said}");
        assert!(shown.contains("quick0") && !shown.contains("slow11"), "{format}: {shown}");
        assert!(said.contains("interrupted: ") && said.contains("of 18 claims are judged"), "{format}: {said}");
        assert_eq!(shown.contains("<error"), *format == "junit", "a run that was cut short is no success: {shown}");
    }
}

#[cfg(unix)]
#[test]
fn ctrl_c_leaves_the_claims_that_were_tried_and_their_counterexamples() {
    let folder = tempfile::tempdir().expect("a folder");
    let wrong = "claim wrong \"t\"\ngiven x > 0\nprove x >= 1\n".to_owned();
    let path = file(&folder, "a.claim", (wrong + &quick_and_slow()).as_bytes()).display().to_string();
    let saved = folder.path().join("saved").display().to_string();
    let formats = ["text", "json", "junit"];
    let run = |format| vec!["test", &path, "--format", format, "--time", "600", "--cases", "20", "--save", &saved];
    for (format, out) in formats.iter().zip(interrupted_after(20, &formats.map(run))) {
        let (shown, said) = (text(&out.stdout), text(&out.stderr));
        assert_eq!(out.status.code(), Some(130), "{format}: {said}");
        assert!(shown.contains("quick0") && shown.contains("wrong"), "{format}: {shown}");
        assert!(!shown.contains("slow11"), "a claim that was not tried: {format}: {shown}");
        assert!(said.contains("interrupted: ") && said.contains("of 19 claims are tried"), "{format}: {said}");
        assert_eq!(shown.contains("<error"), *format == "junit", "a run that was cut short is no success: {shown}");
        assert!(Path::new(&saved).join("counterexample-wrong.claim").is_file(), "{format}: {said}");
    }
}
