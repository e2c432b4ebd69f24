//! The kernel stands alone: it compiles with nothing but the syntax tree and the certificate as data.
#![allow(missing_docs, dead_code, unused_imports, unreachable_pub, clippy::unwrap_used)]

#[path = "../src/claim"]
mod claim {
    pub mod definedness;
    pub mod syntax;
}

#[path = "../src/certificate"]
mod certificate {
    mod step;
    pub use step::*;
}

#[path = "../src/kernel/mod.rs"]
mod kernel;

#[path = "../src/table_checker/mod.rs"]
mod table_checker;

use certificate::{Certificate, Rule, Show, Step};
use claim::syntax::*;

fn name(text: &str) -> Name {
    Name { text: text.to_string(), span: Span::default() }
}

fn variable(text: &str) -> Expr {
    Expr { kind: ExprKind::Name(text.to_string()), span: Span::default() }
}

fn compare(a: Expr, relation: Relation, b: Expr) -> Prop {
    Prop { kind: PropKind::Compare(vec![a, b], vec![relation]), span: Span::default() }
}

fn claim(goal: Prop) -> Claim {
    let binding = Binding {
        names: vec![(name("x"), None)],
        natural: false,
        constraints: Vec::new(),
        indices: None,
        span: Span::default(),
    };
    Claim {
        name: name("alone"),
        title: String::new(),
        paper: None,
        source: None,
        section: None,
        number: None,
        reading: None,
        prose: Vec::new(),
        notes: Vec::new(),
        using: Vec::new(),
        items: vec![Item::Given(vec![binding])],
        sample: Vec::new(),
        goal,
        proof: Proof::default(),
        expect: Expectation::default(),
    }
}

fn without_facts(goal: &Prop) -> Certificate {
    let rule = Rule::Combination { times: None, terms: Vec::new() };
    let show = Show { label: "1".to_string(), rule, prop: goal.clone(), by: Vec::new(), using: Vec::new() };
    Certificate {
        claim: "alone".to_string(),
        statement: String::new(),
        refutes: None,
        steps: vec![Step::Show(Box::new(show))],
    }
}

#[test]
fn the_kernel_alone_accepts_an_identity_and_rejects_what_is_none() {
    let right = compare(variable("x"), Relation::Equal, variable("x"));
    let wrong = compare(variable("x"), Relation::Greater, variable("x"));
    let accepted = kernel::check(&claim(right.clone()), &without_facts(&right), &[]);
    assert!(matches!(accepted, kernel::Verdict::Accepted(_)), "{accepted:?}");
    let rejected = kernel::check(&claim(wrong.clone()), &without_facts(&wrong), &[]);
    assert!(matches!(rejected, kernel::Verdict::Rejected { .. }), "{rejected:?}");
}

#[test]
fn the_kernel_imports_nothing_else() {
    let own = ["fraction", "known", "scope", "statement", "substitution", "term", "PropKind", "ExprKind"];
    imports_nothing_else("src/kernel", &own);
}

#[test]
fn the_checker_of_tables_imports_nothing_else() {
    imports_nothing_else(
        "src/table_checker",
        &["axes", "cell", "dyadic", "failure", "remarks", "rounding", "text", "value", "work"],
    );
}

fn imports_nothing_else(folder: &str, own: &[&str]) {
    let allowed = [
        "super",
        "crate::certificate",
        "crate::claim::definedness",
        "crate::claim::syntax",
        "num_bigint",
        "num_rational",
        "num_traits",
        "std",
    ];
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let mut lines = 0;
    let mut paths: Vec<_> = std::fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()).collect();
    while let Some(path) = paths.pop() {
        if path.is_dir() {
            paths.extend(std::fs::read_dir(path).unwrap().map(|e| e.unwrap().path()));
            continue;
        }
        let text = std::fs::read_to_string(&path).unwrap();
        lines += text.lines().count();
        // A unit test stops where it fails; unit tests end a file.
        let shipped = text.split("#[cfg(test)]\n#[allow(clippy::unwrap_used)]").next().unwrap_or_default();
        assert!(text[shipped.len()..].matches("\n}\n").count() <= 1, "{}: code below its tests", path.display());
        for line in text.lines().map(str::trim_start).filter_map(|l| l.strip_prefix("use ")) {
            let known = allowed
                .iter()
                .chain(own)
                .any(|a| line.starts_with(&format!("{a}::")) || line.starts_with(&format!("{a};")));
            assert!(known, "{}: use {line}", path.display());
        }
        for word in [
            "crate::prove",
            "crate::judge",
            "crate::refute",
            "crate::algebra",
            "crate::number",
            "malachite",
            "f64",
            "f32",
            "unsafe",
            ".unwrap()",
            ".expect(",
        ] {
            assert!(!shipped.contains(word), "{} mentions {word}", path.display());
        }
    }
    assert!(lines > 1000, "the folder was read");
    println!("{lines} lines");
}
