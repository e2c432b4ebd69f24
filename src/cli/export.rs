//! `carom export`

use super::audit::load;
use super::{Exit, Language, print};
use crate::claim::embedded;
use crate::claim::syntax::Claim;
use crate::export::{Unsupported, coq, smt2};
use std::collections::BTreeMap;
use std::path::PathBuf;

/// Runs the command.
///
/// Without names, what cannot be said is left out and counted on standard error; a named claim that
/// cannot be said is a stated limit.
pub fn run(language: Language, ids: &[String], from: &[PathBuf], theorems: bool, list: bool) -> Result<u8, Exit> {
    let loaded = load(from, ids)?;
    let wanted = |claim: &&Claim| ids.is_empty() || ids.contains(&claim.name.text);
    let claims: Vec<&Claim> = loaded.catalogue.claims().iter().filter(wanted).collect();
    let mut refusals: Vec<(&Claim, Unsupported)> = Vec::new();
    let text = match language {
        Language::Coq => {
            let statements = said(&claims, &mut refusals, coq::statement);
            let proved: BTreeMap<String, String> =
                embedded::coq_files().iter().flat_map(|f| coq::proofs_in(f.path, f.text)).collect();
            if theorems { coq::theorems(&statements, &proved) } else { coq::definitions(&statements) }
        }
        Language::Smt2 => {
            let scripts = said(&claims, &mut refusals, smt2::script);
            scripts.join("\n")
        }
    };
    if list {
        let mut out = String::new();
        for claim in &claims {
            let name = &claim.name.text;
            match refusals.iter().find(|(c, _)| c.name.text == *name) {
                Some((_, refusal)) => out.push_str(&format!("{name}: no, {}\n", refusal.reason)),
                None => out.push_str(&format!("{name}: yes\n")),
            }
        }
        print(&out)?;
        return Ok(0);
    }
    let lines: Vec<String> =
        refusals.iter().map(|(c, r)| format!("{} cannot be exported: {}", c.name.text, r.reason)).collect();
    if !ids.is_empty() && !lines.is_empty() {
        return Err(Exit { code: 3, message: format!("limit reached: {}", lines.join("\n")) });
    }
    print(&text)?;
    if !lines.is_empty() {
        eprintln!("left out: {} of {} claims; `carom export --list` gives the reasons", lines.len(), claims.len());
    }
    Ok(0)
}

/// What the claims are in another language; those that cannot be said go to the refusals.
fn said<'a, T>(
    claims: &[&'a Claim],
    refusals: &mut Vec<(&'a Claim, Unsupported)>,
    say: impl Fn(&Claim) -> Result<T, Unsupported>,
) -> Vec<T> {
    let mut out = Vec::new();
    for claim in claims {
        match say(claim) {
            Ok(text) => out.push(text),
            Err(reason) => refusals.push((*claim, reason)),
        }
    }
    out
}
