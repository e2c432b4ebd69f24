//! The program as a user meets it.

use std::io::Write;
use std::path::PathBuf;
use std::process::{Command, Output, Stdio};
use std::time::Instant;

fn carom(arguments: &[&str]) -> Output {
    let started = Instant::now();
    let out = Command::new(env!("CARGO_BIN_EXE_carom")).args(arguments).output().expect("the program starts");
    eprintln!("{arguments:?}: {:?}", started.elapsed());
    out
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

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
    assert!(claim["assumptions"].is_array() && claim["witness"].is_null() && claim["certificate"].is_null());
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
    assert!(text(&out.stderr).contains("cannot all hold"), "{}", text(&out.stderr));
}

#[test]
fn malformed_files_are_answered_within_a_second() {
    let folder = tempfile::tempdir().expect("a folder");
    let deep = format!("claim c \"t\"\ngiven x > 0\nprove {}x{} = x\n", "(".repeat(100_000), ")".repeat(100_000));
    let numeral = format!("claim c \"t\"\ngiven x > 0\nprove x = {}\n", "7".repeat(50_000));
    let circle = "claim a \"t\"\nusing b\ngiven x > 0\nprove x = x by b\nclaim b \"t\"\nusing a\ngiven x > 0\nprove x = x by a\n";
    let cases: [(&str, &[u8]); 6] = [
        ("empty.claim", b""),
        ("cut.claim", b"claim c \"t\"\ngiven x >"),
        ("deep.claim", deep.as_bytes()),
        ("numeral.claim", numeral.as_bytes()),
        ("bytes.claim", b"claim c \"t\"\n\xff\xfe"),
        ("circle.claim", circle.as_bytes()),
    ];
    for (name, content) in cases {
        let path = file(&folder, name, content);
        let started = Instant::now();
        let out = carom(&["audit", &path.display().to_string()]);
        assert_eq!(out.status.code(), Some(2), "{name}: {}", text(&out.stderr));
        assert!(started.elapsed().as_secs_f64() < 1.0, "{name} took {:?}", started.elapsed());
        assert!(text(&out.stderr).contains(name), "{name}: {}", text(&out.stderr));
        assert!(out.stdout.is_empty());
    }
    let power = file(&folder, "power.claim", b"claim c \"t\"\ngiven x > 0\nprove x^(10^9) > 0\n");
    let out = carom(&["audit", &power.display().to_string()]);
    assert_eq!(out.status.code(), Some(0), "{}", text(&out.stdout));
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
    let mut child = Command::new(env!("CARGO_BIN_EXE_carom"))
        .args(["help", "language"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    drop(child.stdout.take());
    let out = child.wait_with_output().expect("it ends");
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
fn every_format_and_the_argument_of_a_claim_are_printed() {
    for (form, sign) in [("markdown", "| claim |"), ("junit", "<testsuite"), ("text", "all as expected")] {
        let out = carom(&["audit", "--only", "eq05", "eq06", "--format", form]);
        assert!(text(&out.stdout).contains(sign), "{form}: {}", text(&out.stdout));
    }
    let out = carom(&["explain", "b-grow"]);
    assert!(text(&out.stdout).contains("[mean inequality]"), "{}", text(&out.stdout));
    let out = carom(&["explain", "eq13", "--format", "latex"]);
    assert!(text(&out.stdout).contains("\\begin{gather*}"));
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
    for arguments in [&["audit", "--only", "eq05"][..], &["help", "language"], &["explain", "eq05"], &["help", "audit"]] {
        let full = std::fs::OpenOptions::new().write(true).open("/dev/full").expect("it opens");
        let out = Command::new(env!("CARGO_BIN_EXE_carom")).args(arguments).stdout(full).output().expect("it runs");
        assert_eq!(out.status.code(), Some(2), "{arguments:?}");
        assert!(text(&out.stderr).contains("cannot write to standard output"), "{}", text(&out.stderr));
    }
}

#[test]
fn help_on_a_subcommand_shows_how_the_program_is_called() {
    for name in ["audit", "explain", "fmt"] {
        let out = carom(&["help", name]);
        assert!(text(&out.stdout).contains(&format!("Usage: carom {name} ")), "{}", text(&out.stdout));
    }
}
