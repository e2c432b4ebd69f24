//! Exported statements: the committed Coq files are those of the claims, and every one is proved.

use crate::support::{carom, text};
use carom::certificate::text::{digest, read, refuted_by};
use carom::claim::embedded;
use carom::claim::parse::parse;
use carom::claim::syntax::{Claim, Expectation};
use carom::export::coq::{self, BY_HAND, Statement};
use carom::export::smt2;
use carom::kernel::{self, Accepted, Verdict};
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::OnceLock;

fn catalogue() -> Vec<Claim> {
    embedded::claims(&[]).expect("the catalogue parses").expect("all claims")
}

fn statements() -> (Vec<Statement>, Vec<(String, String)>) {
    let (mut said, mut refused) = (Vec::new(), Vec::new());
    for claim in catalogue() {
        match coq::statement(&claim) {
            Ok(statement) => said.push(statement),
            Err(refusal) => refused.push((claim.name.text, refusal.reason)),
        }
    }
    (said, refused)
}

/// The theorems of the page, by name, each with the file of its proof.
fn proved() -> BTreeMap<String, String> {
    let page = committed("proofs/coq/claims.v");
    coq::proved_in(page.split(BY_HAND).next().expect("a part before the mark"))
}

fn committed(path: &str) -> String {
    std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(path)).expect("the file is there")
}

#[test]
fn the_page_of_theorems_is_what_the_certificates_prove() {
    let claims = committed("proofs/coq/claims.v");
    let generated = claims.split(BY_HAND).next().expect("a part before the mark");
    assert!(claims.contains(BY_HAND), "claims.v has lost its part by hand");
    let (code, page, said) = run(&["export", "coq", "--theorems"]);
    assert_eq!(code, Some(0), "{said}");
    assert!(generated.trim_end() == page.trim_end(), "claims.v: run proofs/coq/regenerate");
}

#[test]
fn every_claim_but_the_one_that_coq_cannot_say_is_proved_there() {
    let (said, refused) = statements();
    let reason = "a family on a part of the natural numbers".to_string();
    assert_eq!(refused, [("eq20-extracted".to_string(), reason)]);
    let proved = proved();
    let page = committed("proofs/coq/claims.v");
    for statement in &said {
        for (name, full) in statement.propositions() {
            assert_eq!(proved.get(&name), Some(&statement.name), "{name} has no proof");
            assert!(page.contains(&format!("\nTheorem {name} :\n{full}.\nProof. exact ")), "{name} says another thing");
        }
    }
    assert_eq!(proved.len(), said.iter().map(|s| s.propositions().len()).sum::<usize>(), "a proof of no statement");
}

/// The proofs that are made from certificates rest on a library that a reader can go through.
#[test]
fn the_library_that_proofs_rest_on_stays_short() {
    let lines = |name: &str| committed(&format!("proofs/coq/{name}.v")).lines().count();
    let library: usize = ["vocabulary", "rules", "bounds", "points", "values"].into_iter().map(lines).sum();
    assert!(library <= 1378, "{library} lines");
    let files: Vec<&str> = embedded::coq_files().iter().map(|f| f.path).collect();
    assert_eq!(files, ["bounds", "claims", "further", "points", "rules", "values", "vocabulary"]);
}

#[test]
fn no_proof_is_left_open() {
    for file in embedded::coq_files() {
        for word in ["Admitted", "admit.", "Axiom ", "Parameter ", "Conjecture ", "give_up"] {
            assert!(!file.text.contains(word), "{}.v holds {word}", file.path);
        }
    }
}

/// The digest of what the kernel reads of a claim.
fn digest_of(claim: &Claim) -> String {
    digest(&kernel::statement::Statement::of(claim).expect("a statement").text())
}

/// The claims whose certificates the kernel accepts; whether they rest on the mean inequality.
fn accepted() -> BTreeMap<String, bool> {
    let deep = std::thread::Builder::new().stack_size(256 << 20);
    let run = || {
        let proofs = embedded::certificates().into_iter().filter(|(_, text)| refuted_by(text).is_none());
        let texts: BTreeMap<String, &str> = proofs.collect();
        let mut accepted: BTreeMap<String, Accepted> = BTreeMap::new();
        let mut waiting: Vec<Claim> = catalogue().into_iter().filter(|c| texts.contains_key(&c.name.text)).collect();
        while let Some(place) = waiting
            .iter()
            .position(|c| c.using.iter().all(|n| accepted.contains_key(&n.text) || !texts.contains_key(&n.text)))
        {
            let claim = waiting.remove(place);
            let cited: Vec<&Accepted> = claim.using.iter().filter_map(|n| accepted.get(&n.text)).collect();
            let certificate = read(texts[&claim.name.text]).expect("a certificate");
            assert_eq!(certificate.statement, digest_of(&claim), "{}", claim.name.text);
            if let Verdict::Accepted(shown) = kernel::check(&claim, &certificate, &cited) {
                accepted.insert(claim.name.text.clone(), *shown);
            }
        }
        accepted
            .iter()
            .map(|(name, shown)| (name.clone(), shown.rests_on().contains(kernel::analysis::LEMMA)))
            .collect()
    };
    deep.spawn(run).expect("a thread").join().expect("the kernel answers")
}

#[test]
fn certificates_coq_statements_and_the_table_are_bound_by_digest() {
    let (page, table) = (committed("proofs/coq/claims.v"), table());
    for claim in catalogue() {
        let (name, digest) = (&claim.name.text, digest_of(&claim));
        if coq::statement(&claim).is_ok() {
            let beside = format!("(* statement sha256 {digest} *)\nTheorem {} :", coq::identifier(name));
            assert!(page.contains(&beside), "{name}");
        }
        assert!(table.lines().any(|l| l.starts_with(&format!("| {name} |")) && l.contains(&digest[..12])), "{name}");
    }
}

/// The table, made once.
fn table() -> &'static str {
    static TABLE: OnceLock<String> = OnceLock::new();
    TABLE.get_or_init(written)
}

/// The table of docs/claims.md; the catalogue's test holds the prover's verdicts to the expected ones.
fn written() -> String {
    let mut out = String::from(
        "# The claims, by whom they are checked\n\n\
         `CAROM_WRITE=1 cargo test --test all export` writes this page. *prover*: the verdict of `carom audit`. *kernel*:\n\
         `carom check` accepts the certificate in `proofs/certificates`; *mean*: the proof rests on the weighted mean\n\
         inequality. *Coq*: the theorem of `proofs/coq/claims.v`, which states it in full; for a refuted claim, Coq proves\n\
         the negation. *SMT*: whether the claim fits QF_NRA, so that `proofs/smt/compare.py` can ask Z3 and cvc5.\n\
         *statement*: the first digits of the SHA-256 of the statement that the kernel reads. The certificate and the file\n\
         of the Coq statement have the whole.\n\n\
         The Coq proofs are generated. `carom export coq --proofs --output DIR` makes them from certificates, also for your\n\
         own claims, in a folder with a script `check` that has Coq verify them. `proofs/coq/check` does so for this\n\
         catalogue. Coq alone decides whether they are right.\n\n\
         | claim | title | prover | kernel | Coq | SMT | statement |\n|---|---|---|---|---|---|---|\n",
    );
    let accepted = accepted();
    let proved = proved();
    for claim in catalogue() {
        let verdict = match claim.expect {
            Expectation::Proved => "proved",
            Expectation::Refuted => "refuted",
            Expectation::Undecided => "undecided",
        };
        let coq = match (proved.get(&coq::identifier(&claim.name.text)), coq::statement(&claim)) {
            (Some(_), _) => format!("{verdict}, `{}`", coq::identifier(&claim.name.text)),
            (None, Err(refusal)) => format!("– ({})", refusal.reason),
            (None, Ok(_)) => "–".to_string(),
        };
        let smt = if smt2::script(&claim).is_ok() { "yes" } else { "–" };
        let kernel = match accepted.get(&claim.name.text) {
            Some(true) => "accepted, mean",
            Some(false) => "accepted",
            None => "–",
        };
        let (name, title, digest) = (&claim.name.text, &claim.title, digest_of(&claim));
        out.push_str(&format!(
            "| {name} | {title} | {verdict} | {kernel} | {coq} | {smt} | {} |\n",
            digest.get(..12).expect("64 digits")
        ));
    }
    out
}

#[test]
fn the_table_in_the_docs_is_current() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/claims.md");
    let table = table();
    if std::env::var_os("CAROM_WRITE").is_some() {
        std::fs::create_dir_all(path.parent().expect("a folder")).expect("the folder is made");
        std::fs::write(&path, table).expect("the file is written");
    }
    assert!(
        std::fs::read_to_string(&path).unwrap_or_default() == table,
        "run CAROM_WRITE=1 cargo test --test all export"
    );
}

fn one(text: &str) -> Claim {
    parse(text).expect("the claim parses").remove(0)
}

fn full(body: &str) -> String {
    let text = coq::statement(&one(&format!("claim c \"t\"\n{body}\n"))).expect("it can be said").full;
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

fn refusal(body: &str) -> String {
    coq::statement(&one(&format!("claim c \"t\"\n{body}\n"))).expect_err("it cannot be said").reason
}

#[test]
fn powers_are_those_of_the_claim() {
    assert_eq!(
        full("given x > 0; n natural\nprove x^n*x^(2*n) = x^(3*n)"),
        "forall (x : R), x > 0 -> forall (n : nat), x ^ n * x ^ (2 * n) = x ^ (3 * n)"
    );
    // A difference of naturals is no natural by its form: the truncated one of nat must not appear.
    assert_eq!(
        full("given x > 0; n natural\nprove x^(n - 1) = x^n/x"),
        "forall (x : R), x > 0 -> forall (n : nat), Rpower x (INR n - 1) = x ^ n / x"
    );
    assert_eq!(
        full("given x > 0\nprove x^(-2) = 1/x^2 and -x^2 = -(x^2)"),
        "forall (x : R), x > 0 -> / x ^ 2 = 1 / x ^ 2 /\\ - x ^ 2 = - x ^ 2"
    );
    assert_eq!(
        full("given x, y > 0\nprove x/(y/x) = x*x/y and x - (y - x) = 2*x - y and 0.5*x^0.5 = sqrt(x)/2"),
        "forall (x y : R), x > 0 -> y > 0 -> x / (y / x) = x * x / y /\\ x - (y - x) = 2 * x - y /\\ \
         (1 / 2) * sqrt x = sqrt x / 2"
    );
}

#[test]
fn a_power_is_read_by_the_form_of_its_exponent_with_definitions_put_in_place() {
    let named = full("given x real\nlet k = 2\nlet p(t) = x^t\nprove x^k = p(2) and x^(4/2) = x^2.0");
    assert_eq!(named, "forall (x : R), x ^ 2 = x ^ 2 /\\ x ^ 2 = x ^ 2");
    let negative = "given x real != 0; n natural\nprove x^(-n)*x^n = 1 and x^(1 - 3) = 1/x^2";
    assert!(full(negative).ends_with("(/ x ^ n) * x ^ n = 1 /\\ / x ^ 2 = 1 / x ^ 2"), "{}", full(negative));
    let statement = coq::statement(&one(&format!("claim c \"t\"\n{negative}\n"))).expect("said");
    let defined = statement.defined.expect("there are conditions");
    let defined = defined.split_whitespace().collect::<Vec<_>>().join(" ");
    for condition in ["(x <> 0 \\/ 0 <= - INR n)", "/\\ x <> 0"] {
        assert!(defined.contains(condition), "{defined}");
    }
    // A divisor x^n is not 0 for n = 0, whatever x is.
    let divided = coq::statement(&one("claim c \"t\"\ngiven x real; n natural\nprove 1/x^n = 1/x^n\n")).expect("said");
    assert!(divided.defined.expect("a divisor").contains("x ^ n <> 0"));
    // `Rpower 0 (1 / 2)` is 1, `sqrt 0` is 0.
    for body in ["x^(1/3) = x", "cbrt(x)^3 = x", "x^0.3 >= 0"] {
        assert!(refusal(&format!("given x >= 0\nprove {body}")).contains("of what may be 0"), "{body}");
    }
    assert_eq!(full("given x >= 0\nprove x^(1/2) = sqrt(x)"), "forall (x : R), x >= 0 -> sqrt x = sqrt x");
    assert!(refusal("given x real; n natural >= 1\nprove x^(n - 1)*x = x^n").contains("may be negative"));
    assert!(full("given x real\nprove for all t > 0: t^(1/3) = cbrt(t)").contains("Rpower t (1 / 3)"));
}

#[test]
fn a_range_that_may_end_before_it_begins_is_a_condition() {
    let defined = |body: &str| coq::statement(&one(&format!("claim c \"t\"\n{body}\n"))).expect("said").defined;
    let needed = defined("given f(k) > 0; n natural\nprove sum(i = 5..n, f(i)) >= 0").expect("there is a condition");
    assert!(needed.contains("(5 <= n + 1)%nat"), "{needed}");
    assert_eq!(
        defined("given f(k) > 0; n natural\nprove sum(i = 1..n, f(i)) >= 0 and sum(i = n..n + 2, f(i)) > 0"),
        None
    );
}

#[test]
fn names_do_not_capture_words_of_coq() {
    assert_eq!((coq::identifier("nat"), coq::identifier("eq10-roots")), ("nat_".into(), "eq10_roots".into()));
    let text = full("given R, fun, Rpower, exists', INR > 0\nprove R*fun*Rpower*INR = INR*Rpower*fun*R");
    assert!(text.starts_with("forall (R_ fun_ Rpower_ exists' INR_ : R)"), "{text}");
}

#[test]
fn definitions_that_depend_on_the_variable_go_into_derivatives_and_limits() {
    let text = full("given x, a > 0\nlet y = a*x\nprove derivative(y^2, x) = 2*a*y");
    assert!(text.ends_with("is_derive (fun x : R => (a * x) ^ 2) x (2 * a * y)"), "{text}");
    let text = full("given n natural >= 1; a > 0\nlet y = a/n\nprove limit of y as n -> infinity is 0");
    assert!(text.ends_with("is_lim_seq (fun n : nat => a / INR n) 0"), "{text}");
    let text = full("given x, y > 0\nprove derivative(x^2*y, x) > 0");
    assert!(text.ends_with("Derive (fun x : R => x ^ 2 * y) x > 0"), "{text}");
}

#[test]
fn a_hypothesis_that_divides_says_that_its_divisor_is_not_0() {
    let text = full("given x, y real\nassume q: x/y = 1\nprove x = y");
    assert_eq!(text, "forall (x y : R), y <> 0 -> x / y = 1 -> x = y");
    let statement = coq::statement(&one("claim c \"t\"\ngiven x, y > 0\nprove sqrt(x)/y = x^(1/2)/y\n")).expect("said");
    let defined = statement.defined.expect("there are conditions");
    for condition in ["y <> 0", "0 <= x", "x > 0"] {
        assert!(defined.contains(condition), "{defined}");
    }
}

#[test]
fn what_coq_would_read_otherwise_is_refused() {
    assert_eq!(
        refusal("given f(k) > 0; n natural\nprove sum(i = 0..n - 1, f(i)) >= 0"),
        "an expression that is not natural by its form"
    );
    assert_eq!(
        refusal("given f(k) > 0; n natural >= 1\nprove f(n - 1) > 0"),
        "an index that is not natural by its form"
    );
    assert_eq!(refusal("given f(k) > 0 for k in 1..3\nprove f(1) > 0"), "a family on a part of the natural numbers");
    assert_eq!(
        refusal("given n natural >= 1\nassume small: n <= 3\nprove limit of 1/n as n -> infinity is 0"),
        "a limit by a variable that a hypothesis restricts"
    );
    assert_eq!(
        refusal("given x in [0, 1]\nprove limit of 1/(1 + x) as x -> infinity is 0"),
        "a limit by a variable that a hypothesis restricts"
    );
    assert_eq!(refusal("given x, y > 0\nprove derivative(x*y, x, y) = 1"), "a derivative by several variables");
}

#[test]
fn smt_scripts_are_well_formed_and_say_the_hypotheses() {
    let mut count = 0;
    for claim in catalogue() {
        let Ok(script) = smt2::script(&claim) else { continue };
        count += 1;
        let open = script.lines().filter(|l| !l.starts_with(';')).flat_map(str::chars);
        let depth = open.fold(0i64, |d, c| d + i64::from(c == '(') - i64::from(c == ')'));
        assert_eq!(depth, 0, "{}", claim.name.text);
        assert!(script.ends_with("(check-sat)\n"), "{}", claim.name.text);
    }
    assert!(count >= 44, "{count} claims fit QF_NRA");
    let script =
        smt2::script(&one("claim c \"t\"\ngiven x > 0; y real\nassume q: x/y > 1\nprove x > y\n")).expect("fits");
    for line in [
        "(assert (> |x| 0))",
        "(assert (not (= |y| 0)))",
        "(assert (> (* |x| |y|) (* |y| |y|)))",
        "(assert (not (> |x| |y|)))",
    ] {
        assert!(script.contains(line), "{line} is missing in\n{script}");
    }
}

/// What a run of the program gives: exit code, standard output, standard error.
fn run(arguments: &[&str]) -> (Option<i32>, String, String) {
    let out = carom(arguments);
    (out.status.code(), text(&out.stdout), text(&out.stderr))
}

#[test]
fn a_named_claim_that_cannot_be_said_is_an_error_and_no_limit() {
    let (code, out, said) = run(&["export", "coq", "eq20-extracted"]);
    assert_eq!((code, out.as_str()), (Some(2), ""), "{said}");
    assert!(said.starts_with("error: eq20-extracted cannot be exported to coq: a family on a part"), "{said}");
    let (code, _, said) = run(&["export", "smt2", "b-grow"]);
    assert_eq!(code, Some(2));
    assert!(said.contains("to smt2: a natural variable; `carom export coq b-grow` can say it"), "{said}");
    assert_eq!(run(&["export", "coq", "no-such-claim"]).0, Some(2));
    assert_eq!(run(&["export", "prolog"]).0, Some(2));
    let (code, out, _) = run(&["export", "coq", "eq13"]);
    assert_eq!(code, Some(0));
    assert!(out.contains("Definition eq13 : Prop :="));
}

#[test]
fn the_list_that_an_export_recommends_is_there() {
    let (_, _, said) = run(&["export", "smt2"]);
    let command = said.split('`').nth(1).expect("a command");
    let words: Vec<&str> = command.split(' ').skip(1).collect();
    assert_eq!(words, ["export", "smt2", "--list"], "{said}");
    let (code, out, said) = run(&words);
    assert_eq!(code, Some(0), "{said}");
    assert!(out.contains("eq22: no, a sequence") && out.contains("\neq13: yes\n"), "{out}");
    let (code, out, said) = run(&["export", "--list"]);
    assert_eq!(code, Some(0), "{said}");
    assert!(out.contains("coq eq22: yes\nsmt2 eq22: no, a sequence"), "{out}");
    assert_eq!(run(&["export"]).0, Some(2));
}

#[test]
fn several_scripts_are_one_script() {
    let (_, out, _) = run(&["export", "smt2", "eq13", "eq15", "eq02"]);
    let scripts: Vec<&str> = out.split("\n(reset)\n").collect();
    assert_eq!(scripts.len(), 3, "{out}");
    for script in scripts {
        assert_eq!((script.matches("(set-logic").count(), script.matches("(check-sat)").count()), (1, 1), "{script}");
    }
    let (_, all, _) = run(&["export", "smt2"]);
    assert_eq!(all.matches("(reset)").count() + 1, all.matches("(set-logic").count());
}

#[test]
fn theorems_are_those_that_are_proved() {
    let folder = tempfile::tempdir().expect("a folder");
    let own = folder.path().join("own.claim");
    let path = own.to_str().expect("a name");
    // The page of a user's claims has the theorems of these, and none that has no proof.
    std::fs::write(&own, "claim eq13 \"t\"\ngiven x > 0\nprove x + x = 2*x\n\nclaim open \"t\"\ngiven f(k) > 0 for k in 1..3\nprove f(1) > 0\n").expect("written");
    let (code, out, said) = run(&["export", "coq", "--theorems", "--from", path]);
    assert_eq!(code, Some(0), "{said}");
    assert!(out.contains("x + x = 2 * x.\nProof. exact eq13.eq13. Qed.") && !out.contains("Theorem open"), "{out}");
    let (code, out, said) = run(&["export", "coq", "--theorems", "open", "--from", path]);
    assert_eq!((code, out.as_str()), (Some(2), ""), "{said}");
    assert!(said.contains("none of these claims has a proof"), "{said}");
    let (code, _, said) = run(&["export", "smt2", "--theorems"]);
    assert_eq!(code, Some(2));
    assert!(said.contains("carom export coq --theorems"), "{said}");
    let (code, _, said) = run(&["export", "coq", "--from", path, "mine"]);
    assert_eq!(code, Some(2));
    assert!(said.contains(&format!("`carom export coq mine --from {path}`")), "{said}");
}
