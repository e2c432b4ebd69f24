//! `carom check` as a user meets it.
#![allow(clippy::unwrap_used)]

use crate::support::carom;
use carom::certificate::text::refuted_by;
use carom::claim::embedded;
use std::path::Path;
use std::process::Output;

fn out(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).unwrap()
}

fn err(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

fn text(path: &Path) -> &str {
    path.to_str().unwrap()
}

#[test]
fn the_certificates_that_come_with_the_program_are_accepted_one_by_one() {
    let all = embedded::certificates();
    let output = carom(&["check", "--quiet"]);
    let printed = out(&output);
    assert_eq!(output.status.code(), Some(0), "{printed}");
    for (name, text) in &all {
        let word = if refuted_by(text).is_some() { "refuted" } else { "accepted" };
        assert!(printed.lines().any(|l| l.split_whitespace().take(2).eq([word, name])), "{name}: {printed}");
    }
    assert!(printed.ends_with(&format!("{0} of {0} certificates accepted\n", all.len())), "{printed}");
}

#[test]
fn a_proof_that_the_kernel_does_not_check_is_no_proof() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("mine.claim");
    // No method finds this limit: the first claim has no certificate, the second one has.
    let first = "claim root \"t\"\nprove limit of sum(k = 1..n, 1/k^2) as n natural -> infinity is pi^2/6\n";
    let second = "claim halves \"t\"\ngiven x > 0\nprove x/2 + x/2 = x\n";
    std::fs::write(&file, format!("{first}\n{second}")).unwrap();
    let plain = carom(&["audit", text(&file)]);
    let printed = out(&plain);
    assert_eq!(plain.status.code(), Some(1), "{printed}");
    assert!(printed.contains("undecided       root") && printed.contains("proved          halves"), "{printed}");
    assert!(printed.contains("could not prove: limit of"), "{printed}");
    for debug in ["Rejected(", "Declined(", "Some("] {
        assert!(!printed.contains(debug), "{printed}");
    }
    // The flag that once asked for this is accepted, and changes nothing.
    let checked = carom(&["audit", "--checked", text(&file)]);
    assert_eq!((out(&checked), checked.status.code()), (printed, Some(1)));
    let json = out(&carom(&["audit", "--format", "json", text(&file)]));
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    let (root, halves) = (&json["claims"][0], &json["claims"][1]);
    assert!(root["certificate"].is_null());
    assert_eq!(halves["certificate"].as_str().unwrap().len(), 64);
}

/// Roots are no polynomials: the explanation says what the numerator is.
#[test]
fn a_limit_of_roots_is_not_explained_by_polynomials() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("mine.claim");
    for (f, said) in [("sqrt(x)/(1 + sqrt(x))", "sums of powers of"), ("x/(1 + x)", "polynomials in")] {
        std::fs::write(&file, format!("claim a \"t\"\nprove limit of {f} as x -> infinity is 1\n")).unwrap();
        let printed = out(&carom(&["explain", "a", text(&file)])).replace("\n    ", " ");
        assert!(printed.contains(said), "{printed}");
    }
}

/// A limit that stands in the way of the certificate ends with exit code 3 as one of the search does, and is named.
#[test]
fn a_limit_is_named_with_its_flag_and_has_its_exit_code() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("mine.claim");
    std::fs::write(&file, "claim a \"t\"\ngiven x, y > 0\nprove x^5 + y^5 >= x^3*y^2 + x^2*y^3\n").unwrap();
    for (flag, value, name) in [("--max-steps", "1", "steps"), ("--time", "0", "time")] {
        let output = carom(&["audit", text(&file), flag, value]);
        assert_eq!(output.status.code(), Some(3), "{}", out(&output));
        let said = format!("limit reached: {name} ({flag} raises it)");
        assert!(out(&output).contains(&said), "{}", out(&output));
    }
}

#[test]
fn a_certificate_is_printed_with_its_statement_and_what_it_rests_on() {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in embedded::certificates() {
        std::fs::write(folder.path().join(format!("{name}.cert")), text).unwrap();
    }
    // The certificates of what it cites are found beside it.
    let output = carom(&["check", text(&folder.path().join("b-global.cert"))]);
    let printed = out(&output);
    assert_eq!(output.status.code(), Some(0), "{printed}");
    assert!(
        printed.starts_with("accepted  b-global  (rests on lemma-chain, lemma-tangent, the weighted mean"),
        "{printed}"
    );
    assert!(printed.contains("\n    prove "), "{printed}");
    assert!(printed.ends_with("1 of 1 certificates accepted\n"), "{printed}");
}

#[test]
fn a_damaged_certificate_is_rejected_with_its_first_bad_step() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("eq13.cert");
    let (_, good) = embedded::certificates().into_iter().find(|c| c.0 == "eq13").unwrap();
    for (from, to, code, said) in [
        ("(1 + e1)^2*(1 + e2)^2*m1", "(1 + e1)^2*(1 + e2)*m1", 1, "rejected  eq13"),
        ("sha256 0", "sha256 1", 1, "the digest belongs to another statement"),
        ("claim eq13", "claim eq14", 1, "rejected  eq14"),
        ("claim eq13", "claim nobody", 1, "there is no claim of this name"),
        ("\nqed", "", 2, "qed"),
        ("1 combination", "1 guess", 2, "eq13.cert:4: there is no rule called `guess`"),
        ("carom-certificate 2", "carom-certificate 1", 2, "eq13.cert:1: this certificate has format 1"),
    ] {
        let damaged = good.replacen(from, to, 1);
        assert_ne!(damaged, good, "{from}");
        std::fs::write(&path, damaged).unwrap();
        let output = carom(&["check", "--quiet", text(&path)]);
        let all = out(&output) + &err(&output);
        assert_eq!(output.status.code(), Some(code), "{to}: {all}");
        assert!(all.contains(said), "{to}: {all}");
    }
}

#[test]
fn certificates_of_ones_own_claims_are_written_and_checked() {
    let folder = tempfile::tempdir().unwrap();
    let claims = folder.path().join("mine.claim");
    std::fs::write(&claims, "claim half \"Half\"\ngiven x > 0\nprove x/(2*x) = 1/2 and x + 1/x >= 2\n").unwrap();
    let certificates = folder.path().join("certificates");
    let output = carom(&["audit", text(&claims), "--certificates", text(&certificates)]);
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    assert!(err(&output).contains("1 certificate in "), "{}", err(&output));
    let sha256 = |output: &std::process::Output| {
        let json: serde_json::Value = serde_json::from_str(&out(output)).unwrap();
        json["claims"][0]["certificate"].as_str().unwrap().to_string()
    };
    // It lies beside the claim now, and decides: steps that nobody would search are accepted as well.
    let cert = certificates.join("half.cert");
    let written = std::fs::read_to_string(&cert).unwrap();
    let first = |step: &str| written.replacen("\n1 ", &format!("\n99 combination: {step}\n1 "), 1);
    let longer = first("x + 5 = 5 + x");
    std::fs::write(&cert, &longer).unwrap();
    let json = carom(&["audit", text(&claims), "--format", "json"]);
    assert_eq!(sha256(&json), carom::certificate::text::digest(&longer));
    // One that is wrong costs a search; so does --anew.
    let anew = carom(&["audit", text(&claims), "--format", "json", "--anew"]);
    assert_eq!(sha256(&anew), carom::certificate::text::digest(&written));
    std::fs::write(&cert, first("x + 5 = 6 + x")).unwrap();
    let again = carom(&["audit", text(&claims), "--format", "json"]);
    assert_eq!(sha256(&again), carom::certificate::text::digest(&written));
    std::fs::write(&cert, &written).unwrap();
    let output = carom(&["check", text(&certificates), "--claims", text(&claims)]);
    assert_eq!(output.status.code(), Some(0), "{}{}", out(&output), err(&output));
    // One of format 1 is no longer read: neither as it is, nor where it lies beside the claim; a new one replaces it.
    std::fs::write(&cert, written.replacen("carom-certificate 2", "carom-certificate 1", 1)).unwrap();
    for arguments in [["check", text(&cert)], ["audit", text(&claims)]] {
        let output = carom(&arguments);
        assert_eq!(output.status.code(), Some(2), "{}", out(&output));
        for part in ["half.cert:1: this certificate has format 1", "reads format 2", "`carom audit --certificates DIR`"]
        {
            assert!(err(&output).contains(part), "{}", err(&output));
        }
    }
    let output = carom(&["audit", text(&claims), "--certificates", text(&certificates)]);
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    assert_eq!(std::fs::read_to_string(&cert).unwrap(), written);
    // Beside the catalogue it is of no claim.
    assert_eq!(carom(&["check", text(&certificates)]).status.code(), Some(1));
}

#[test]
fn what_is_no_certificate_is_one_clear_error() {
    let folder = tempfile::tempdir().unwrap();
    let output = carom(&["check", text(folder.path())]);
    assert_eq!(output.status.code(), Some(2));
    assert!(err(&output).contains("no .cert files"), "{}", err(&output));
    let path = folder.path().join("x.cert");
    std::fs::write(&path, [0xff, 0xfe]).unwrap();
    let output = carom(&["check", text(&path)]);
    assert_eq!(output.status.code(), Some(2));
    assert!(err(&output).contains("not UTF-8"), "{}", err(&output));
    assert_eq!(carom(&["check", text(&folder.path().join("absent.cert"))]).status.code(), Some(2));
}

#[test]
fn a_file_beside_it_that_is_not_cited_is_not_read() {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in embedded::certificates() {
        std::fs::write(folder.path().join(format!("{name}.cert")), text).unwrap();
    }
    std::fs::write(folder.path().join("eq13.cert"), "no certificate").unwrap();
    let path = folder.path().join("b-global.cert");
    let output = carom(&["check", "--quiet", text(&path)]);
    assert_eq!(output.status.code(), Some(0), "{}", out(&output) + &err(&output));
    // One that is cited is.
    std::fs::write(folder.path().join("lemma-chain.cert"), "no certificate").unwrap();
    let output = carom(&["check", "--quiet", text(&path)]);
    assert_eq!(output.status.code(), Some(2), "{}", out(&output) + &err(&output));
    assert!(err(&output).contains("lemma-chain.cert:1"), "{}", err(&output));
}

#[test]
fn limits_are_told_from_faults() {
    let folder = tempfile::tempdir().unwrap();
    let (claim, certificate) = (folder.path().join("deep.claim"), folder.path().join("deep.cert"));
    let deep = format!("{}x{} > 0", "(".repeat(300), ")".repeat(300));
    let head = format!("carom-certificate 2\nclaim deep\nstatement sha256 {}\n", "0".repeat(64));
    let run = |goal: &str, step: &str| {
        std::fs::write(&claim, format!("claim deep \"t\"\ngiven x > 0\nprove {goal}\n")).unwrap();
        std::fs::write(&certificate, format!("{head}1 combination: {step}\nqed\n")).unwrap();
        let output = carom(&["check", text(&certificate), "--claims", text(&claim)]);
        (output.status.code(), out(&output) + &err(&output))
    };
    for (goal, step, code, said) in [
        ("x > 0", deep.as_str(), 3, "limit reached: at most 200 levels of nesting"),
        (&deep, "x > 0", 3, "limit reached: at most 200 levels of nesting"),
        ("x > 0", "x >", 2, "expected"),
        ("x >", "x > 0", 2, "expected"),
        ("((2^1000)^1000)^1000 > 0", "((2^1000)^1000)^1000 > 0", 3, "limit reached: digits"),
    ] {
        let (found, all) = run(goal, step);
        assert_eq!(found, Some(code), "{all}");
        assert!(all.contains(said), "{all}");
    }
    for command in ["audit", "fmt", "print"] {
        std::fs::write(&claim, format!("claim deep \"t\"\ngiven x > 0\nprove {deep}\n")).unwrap();
        let output = carom(&[command, text(&claim)]);
        assert_eq!(output.status.code(), Some(3), "{command}: {}", err(&output));
    }
}
