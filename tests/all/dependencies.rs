//! The policy for dependencies, checked without a network: where they come from and under which licence.
//!
//! Every package that a build on this machine uses must come from crates.io and allow its use under a
//! licence of the list; the LGPL is accepted for malachite alone, whose terms the README explains.

use std::collections::BTreeMap;
use std::process::Command;

/// Licences that ask for no more than attribution.
const ALLOWED: &[&str] = &[
    "MIT",
    "Apache-2.0",
    "BSD-2-Clause",
    "BSD-3-Clause",
    "ISC",
    "Zlib",
    "BSL-1.0",
    "Unlicense",
    "Unicode-3.0",
    "CC0-1.0",
];

/// The tokens of an SPDX expression; the old sign `/` means OR.
fn tokens(expression: &str) -> Vec<String> {
    let spaced = expression.replace('(', " ( ").replace(')', " ) ").replace('/', " OR ");
    spaced.split_whitespace().map(str::to_string).collect()
}

/// Whether an SPDX expression can be met by allowed licences; an expression that cannot be read is not.
fn allowed(expression: &str, accepted: &[&str]) -> bool {
    let tokens = tokens(expression);
    let mut at = 0;
    let result = either(&tokens, &mut at, accepted);
    result && at == tokens.len()
}

fn either(tokens: &[String], at: &mut usize, accepted: &[&str]) -> bool {
    let mut result = both(tokens, at, accepted);
    while tokens.get(*at).is_some_and(|t| t == "OR") {
        *at += 1;
        result |= both(tokens, at, accepted);
    }
    result
}

fn both(tokens: &[String], at: &mut usize, accepted: &[&str]) -> bool {
    let mut result = single(tokens, at, accepted);
    while tokens.get(*at).is_some_and(|t| t == "AND") {
        *at += 1;
        result &= single(tokens, at, accepted);
    }
    result
}

fn single(tokens: &[String], at: &mut usize, accepted: &[&str]) -> bool {
    let Some(token) = tokens.get(*at) else { return false };
    *at += 1;
    if token == "(" {
        let result = either(tokens, at, accepted);
        let closed = tokens.get(*at).is_some_and(|t| t == ")");
        *at += 1;
        return result && closed;
    }
    if tokens.get(*at).is_some_and(|t| t == "WITH") {
        // An exception takes away a duty; it adds none.
        *at += 2;
    }
    accepted.contains(&token.as_str())
}

#[test]
fn licence_expressions_are_read_as_spdx_means_them() {
    for expression in ["MIT", "MIT OR GPL-3.0-only", "GPL-3.0-only/MIT", "(GPL-3.0-only OR MIT) AND Zlib"] {
        assert!(allowed(expression, ALLOWED), "{expression}");
    }
    assert!(allowed("Apache-2.0 WITH LLVM-exception", ALLOWED));
    for expression in ["", "GPL-3.0-only", "MIT AND GPL-3.0-only", "LGPL-3.0-only", "(MIT", "MIT)", "MIT MIT", "OR MIT"]
    {
        assert!(!allowed(expression, ALLOWED), "{expression}");
    }
}

#[test]
fn every_dependency_is_from_crates_io_under_an_accepted_licence() {
    // The packages that a build on this machine uses are here; those for other platforms, Python and the browser may not be.
    let out = Command::new(env!("CARGO"))
        .args(["tree", "--locked", "--offline", "--prefix", "none", "--format", "{p}\t{l}\t"])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .expect("cargo is there");
    assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stderr));
    let list = String::from_utf8(out.stdout).expect("UTF-8");
    let own = format!("({}", env!("CARGO_MANIFEST_DIR"));
    let packages: BTreeMap<&str, &str> = list
        .lines()
        .filter_map(|line| line.split_once('\t'))
        .map(|(package, rest)| (package.trim_end_matches(" (proc-macro)"), rest.split('\t').next().unwrap_or_default()))
        .filter(|(package, _)| !package.contains(&own))
        .collect();
    assert!(packages.len() > 20, "the list of packages is read");
    let mut wrong = Vec::new();
    for (package, licence) in packages {
        let mut accepted = ALLOWED.to_vec();
        if package.starts_with("malachite ") || package.starts_with("malachite-") {
            accepted.push("LGPL-3.0-only");
        }
        if !allowed(licence, &accepted) {
            wrong.push(format!("{package}: licence {licence:?}"));
        }
        // A package of crates.io is shown by name and version alone, any other with its place.
        if package.contains('(') {
            wrong.push(format!("{package}: not from crates.io"));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn no_file_of_tests_is_left_out_of_the_one_binary() {
    let all = include_str!("main.rs");
    for entry in std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/all")).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        if let Some(module) = name.strip_suffix(".rs").filter(|module| *module != "main") {
            assert!(all.contains(&format!("\nmod {module};")), "tests/all/{name} is not in tests/all/main.rs");
        }
    }
}
