//! Pages of statements: definitions to be proved, and theorems with the places of their proofs.

use super::Statement;
use std::collections::BTreeMap;

/// The end of the generated part of `claims.v`; what follows is written by hand and kept.
pub const BY_HAND: &str = "(** * Beyond the claim files";

/// A file of definitions, `Definition NAME : Prop := …`, that proofs are written against.
pub fn definitions(statements: &[Statement]) -> String {
    let mut out = String::from(
        "(** What the claim files state, as propositions to be proved. Written by `carom export coq`:\n    \
         change the claim files, not this one. *)\n\nFrom Carom Require Import vocabulary.\n",
    );
    for statement in statements {
        out.push_str(&format!("\n(* statement sha256 {} *)", statement.digest));
        for (name, text) in statement.propositions() {
            out.push_str(&format!("\nDefinition {name} : Prop :=\n{text}.\n"));
        }
    }
    out
}

/// A file of theorems in full, each proved by the term of its name in the module that `proved` gives.
/// A statement without a proof is left out.
pub fn theorems(statements: &[Statement], proved: &BTreeMap<String, String>) -> String {
    let mut out = String::from(
        "(** Every claim in full, with the place of its proof. NAME is the claim of that name (its\n    \
         negation, where the claim is expected to be refuted); NAME_defined says that, under the same\n    \
         hypotheses, all its expressions have values. No other file is imported than [vocabulary], so\n    \
         that nothing of the proofs has a say in what the statements mean. The proofs are files that\n    \
         `carom export coq --proofs` makes from certificates.\n\n    \
         This part is written by `carom export coq --theorems`: change the claim files, not this one. *)\n\n",
    );
    let mut modules: Vec<&str> = proved.values().map(String::as_str).collect();
    modules.sort_unstable();
    modules.dedup();
    out.push_str("From Carom Require Import vocabulary.\n");
    for line in modules.chunks(8) {
        out.push_str(&format!("From Carom Require {}.\n", line.join(" ")));
    }
    for statement in statements.iter().filter(|s| proved.contains_key(&s.name)) {
        out.push_str(&format!("\n(* statement sha256 {} *)", statement.digest));
        for (name, text) in statement.propositions() {
            if let Some(module) = proved.get(&name) {
                out.push_str(&format!("\nTheorem {name} :\n{text}.\nProof. exact {module}.{name}. Qed.\n"));
            }
        }
    }
    out
}

/// The theorems that a file of [`theorems`] has, by name, each with the module of its proof.
pub fn proved_in(text: &str) -> BTreeMap<String, String> {
    let one = |line: &str| {
        let (module, name) = line.strip_prefix("Proof. exact ")?.strip_suffix(". Qed.")?.split_once('.')?;
        Some((name.to_string(), module.to_string()))
    };
    text.lines().filter_map(one).collect()
}
