//! `carom export coq --proofs`: the folder, and what its script says of good and bad files.

use crate::support::{carom, text};
use std::path::Path;
use std::process::Command;

fn read(folder: &Path, name: &str) -> String {
    std::fs::read_to_string(folder.join(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
}

const OWN: &str = "claim sure \"t\"\ngiven x > 0\nprove x/x = 1\n\n\
                   claim rests \"t\"\ngiven y > 0\nusing sure\nprove (y + 1)/(y + 1) = 1 by sure with x = y + 1\n\n\
                   claim wrong \"t\"\ngiven x > 0\nprove x^2 >= x\n\n\
                   claim unknown \"t\"\ngiven x, y > 0\nprove x^y + y^x > 1\n";

#[test]
fn every_file_proves_what_the_export_states_and_stands_after_those_that_it_needs() {
    let folder = tempfile::tempdir().expect("a folder");
    let source = folder.path().join("own.claim");
    std::fs::write(&source, OWN).expect("a file");
    let out = folder.path().join("out");
    let (source, place) = (source.display().to_string(), out.display().to_string());
    let made = carom(&["export", "coq", "--proofs", "--output", &place, "--from", &source]);
    assert_eq!(made.status.code(), Some(0), "{}", text(&made.stderr));
    let stated = text(&carom(&["export", "coq", "--from", &source]).stdout);
    assert_eq!(read(&out, "statements.v"), stated);
    // Each theorem is the definition of its name, letter by letter.
    for (file, name) in [("sure", "sure"), ("sure", "sure_defined"), ("rests", "rests"), ("rests", "rests_defined")] {
        let definition = stated.split_once(&format!("Definition {name} : Prop :=\n")).expect("a definition").1;
        let body = definition.split_once(".\n").expect("its end").0;
        assert!(read(&out, &format!("{file}.v")).contains(&format!("Theorem {name} :\n{body}.\nProof.\n")), "{name}");
    }
    let wrong = read(&out, "wrong.v");
    assert!(wrong.contains("Theorem wrong_refuted :\n  ~ (") && !wrong.contains("Theorem wrong :"), "{wrong}");
    assert!(read(&out, "theorems.txt").contains("wrong wrong_refuted (~ statements.wrong)"));
    let order = read(&out, "order.txt");
    let place_of = |name: &str| order.lines().position(|l| l.split(' ').next() == Some(name)).expect(name);
    assert!(place_of("sure") < place_of("rests"), "{order}");
    let unknown = read(&out, "unknown.v");
    assert!(
        unknown.contains("(* No proof: undecided") && unknown.contains("Definition unknown : Prop :="),
        "{unknown}"
    );
    assert!(text(&made.stderr).contains("no proof of unknown: undecided"), "{}", text(&made.stderr));
    for name in ["vocabulary.v", "rules.v", "values.v", "README.md", "check"] {
        assert!(!read(&out, name).is_empty());
        assert!(!name.ends_with(".v") || read(&out, "_CoqProject").lines().any(|l| l == name), "{name}");
    }
}

#[test]
fn a_folder_that_is_not_empty_an_unknown_name_and_another_language_are_one_error_each() {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("mine"), "kept").expect("a file");
    let full = folder.path().display().to_string();
    let new = folder.path().join("new").display().to_string();
    let cases: [(&[&str], &str); 6] = [
        (&["coq", "--proofs", "--output", &full], "is not empty: --proofs needs a new folder, or an empty one"),
        (&["coq", "--proofs", "--output", &new, "eq1"], "no claim is called eq1; did you mean"),
        (&["coq", "--proofs"], "--output"),
        (&["coq", "--proofs", "--output", "-"], "--proofs writes a folder"),
        (&["smt2", "--proofs", "--output", &new], "--proofs are for Coq"),
        (&["coq", "--proofs", "--theorems", "--output", &new], "cannot be used with"),
    ];
    for (arguments, said) in cases {
        let out = carom(&[&["export"], arguments].concat());
        assert_eq!(out.status.code(), Some(2), "{arguments:?}");
        let stderr = text(&out.stderr);
        assert!(stderr.contains(said) && stderr.matches("error:").count() == 1, "{arguments:?}: {stderr}");
    }
    assert_eq!(read(folder.path(), "mine"), "kept");
    assert!(!Path::new(&new).exists());
}

#[test]
fn two_claims_that_would_be_one_file_are_an_error() {
    let folder = tempfile::tempdir().expect("a folder");
    let clash = |a: &str, b: &str| {
        let source = folder.path().join("own.claim");
        let claim = |name: &str| format!("claim {name} \"t\"\ngiven x > 0\nprove x > 0\n\n");
        std::fs::write(&source, claim(a) + &claim(b)).expect("a file");
        let out = folder.path().join("out").display().to_string();
        let out = carom(&["export", "coq", "--proofs", "--output", &out, "--from", &source.display().to_string()]);
        (out.status.code(), text(&out.stderr))
    };
    for (a, b) in [("a-b", "a_b"), ("rules", "c"), ("statements", "c"), ("A", "a")] {
        let (code, said) = clash(a, b);
        assert!(code == Some(2) && said.contains("would both be"), "{a}, {b}: {said}");
    }
}

/// Coq is run where it is installed: on a good file, and on files that prove something else, or rest on an axiom.
#[test]
fn the_script_accepts_what_is_proved_and_nothing_else() {
    if Command::new("coqc").arg("--version").output().is_err() {
        eprintln!("Coq is not installed: not run");
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let source = folder.path().join("own.claim");
    std::fs::write(&source, &OWN[..OWN.find("claim wrong").expect("a claim")]).expect("a file");
    let out = folder.path().join("out");
    let place = out.display().to_string();
    let made = carom(&["export", "coq", "--proofs", "--output", &place, "--from", &source.display().to_string()]);
    assert_eq!(made.status.code(), Some(0), "{}", text(&made.stderr));
    // A library of one line stands for the one that is slow to compile: what is tried here is the script.
    std::fs::write(out.join("library.txt"), "vocabulary\nstatements\n").expect("a file");
    let file = |name: &str, body: &str| {
        let text = format!("From Carom Require Import vocabulary.\n{body}");
        std::fs::write(out.join(format!("{name}.v")), text).expect("a file");
    };
    let stated = read(&out, "statements.v");
    let body = |name: &str| {
        let definition = stated.split_once(&format!("Definition {name} : Prop :=\n")).expect("a definition").1;
        definition.split_once(".\n").expect("its end").0.to_string()
    };
    let good = format!(
        "Theorem sure :\n{}.\nProof. intros. field. now apply Rgt_not_eq. Qed.\n\
         Theorem sure_defined :\n{}.\nProof. intros. now apply Rgt_not_eq. Qed.\n",
        body("sure"),
        body("sure_defined")
    );
    std::fs::write(out.join("order.txt"), "sure\nrests sure\n").expect("a file");
    std::fs::write(out.join("theorems.txt"), "sure sure statements.sure\nsure sure_defined statements.sure_defined\n")
        .expect("a file");
    let check = |names: &[&str]| {
        let done = Command::new("bash").arg(out.join("check")).args(names).output().expect("bash");
        (done.status.code(), text(&done.stdout) + &text(&done.stderr))
    };
    file("sure", &good);
    let (code, said) = check(&["sure"]);
    assert!(code == Some(0) && said.contains("accepted   sure"), "{said}");
    assert!(
        said.contains("theorem    sure_defined\naxioms of these theorems:") && said.contains("theorems accepted 2"),
        "{said}"
    );
    // Another statement under the same name.
    file("sure", &good.replace("x / x = 1", "x / x <= 1").replace("field.", "right. field."));
    let (code, said) = check(&["sure"]);
    assert!(code == Some(1) && said.contains("does not say what statements.v says"), "{said}");
    // A proof left open.
    file("sure", &good.replacen("intros. field. now apply Rgt_not_eq. Qed.", "Admitted.", 1));
    let (code, said) = check(&["sure"]);
    assert!(code == Some(1) && said.contains("error: sure rests on what is not allowed"), "{said}");
    // A proof that does not go through, and a file that needs it.
    file("sure", &good.replacen("field.", "ring.", 1));
    file("rests", "From Carom Require sure.\n");
    let (code, said) = check(&[]);
    assert!(
        code == Some(1) && said.contains("failed     sure:") && said.contains("not tried  rests: it needs sure"),
        "{said}"
    );
    assert!(said.contains("files accepted 0, failed 1, timed out 0, not tried 1"), "{said}");
    assert_eq!(check(&["other"]).0, Some(2));
}
