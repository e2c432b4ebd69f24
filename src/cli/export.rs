//! `carom export`

use super::audit::load;
use super::{Exit, Language, terminal};
use crate::claim::syntax::Claim;
use crate::export::{Unsupported, coq, smt2};
use std::path::PathBuf;

/// Between two scripts for one solver: it forgets the first one, with its logic and its names.
const RESET: &str = "\n(reset)\n";

impl Language {
    /// Its name on the command line.
    pub(super) fn name(self) -> &'static str {
        match self {
            Language::Coq => "coq",
            Language::Smt2 => "smt2",
        }
    }

    /// The other one.
    fn other(self) -> Language {
        match self {
            Language::Coq => Language::Smt2,
            Language::Smt2 => Language::Coq,
        }
    }

    /// Why the language cannot state a claim.
    fn refusal(self, claim: &Claim) -> Option<Unsupported> {
        match self {
            Language::Coq => coq::statement(claim).err(),
            Language::Smt2 => smt2::script(claim).err(),
        }
    }
}

/// The text that the command prints.
///
/// Without names, what cannot be said is left out and counted on standard error; a named claim that cannot be said is an
/// error, or a stated limit.
pub(super) fn run(language: Option<Language>, ids: &[String], from: &[PathBuf], listed: bool) -> Result<String, Exit> {
    names_after_from(ids, from)?;
    let loaded = load(from, ids)?;
    let wanted = |claim: &&Claim| ids.is_empty() || ids.contains(&claim.name.text);
    let claims: Vec<&Claim> = loaded.claims().iter().filter(wanted).collect();
    let language = match language {
        Some(language) if listed => return Ok(list(&claims, &[language])),
        Some(language) => language,
        None => return Ok(list(&claims, &[Language::Coq, Language::Smt2])),
    };
    let mut refusals: Vec<(&Claim, Unsupported)> = Vec::new();
    let text = match language {
        Language::Coq => coq::definitions(&said(&claims, &mut refusals, coq::statement)),
        Language::Smt2 => said(&claims, &mut refusals, smt2::script).join(RESET),
    };
    if !ids.is_empty() && !refusals.is_empty() {
        return Err(refused(language, &refusals));
    }
    if !refusals.is_empty() {
        let (out, all, name) = (refusals.len(), claims.len(), language.name());
        terminal::note(&format!("left out: {out} of {all} claims; `carom export {name} --list` gives the reasons"));
    }
    Ok(text)
}

/// Every word after --from is taken for a path, a name as well.
pub(crate) fn names_after_from(ids: &[String], from: &[PathBuf]) -> Result<(), Exit> {
    let [first, .., last] = from else { return Ok(()) };
    let is_name = |path: &PathBuf| {
        path.to_str().is_some_and(|p| p.bytes().all(|b| b.is_ascii_alphanumeric() || b"-_'".contains(&b)))
    };
    if !ids.is_empty() || !is_name(last) || last.exists() {
        return Ok(());
    }
    let (name, file) = (last.display(), first.display());
    Err(Exit::usage(format!(
        "error: cannot read {name}: there is no such file; if it is the name of a claim, write it before --from, as in \
         `carom export coq {name} --from {file}`"
    )))
}

/// For each claim, whether these languages can state it, or why not.
fn list(claims: &[&Claim], languages: &[Language]) -> String {
    let mut out = String::new();
    for claim in claims {
        for language in languages {
            let label = if languages.len() > 1 { format!("{} ", language.name()) } else { String::new() };
            let answer = match language.refusal(claim) {
                Some(refusal) => format!("no, {}", refusal.reason),
                None => "yes".to_owned(),
            };
            out += &format!("{label}{}: {answer}\n", claim.name.text);
        }
    }
    out
}

/// The error for named claims that the language cannot state.
fn refused(language: Language, refusals: &[(&Claim, Unsupported)]) -> Exit {
    let mut lines = Vec::new();
    for (claim, refusal) in refusals {
        let (name, other) = (&claim.name.text, language.other());
        let mut line = format!("error: {name} cannot be exported to {}: {}", language.name(), refusal.reason);
        if other.refusal(claim).is_none() {
            line += &format!("; `carom export {} {name}` can say it", other.name());
        }
        lines.push(line);
    }
    Exit::faults(&lines, refusals.iter().all(|(_, refusal)| refusal.limit))
}

/// The claims in another language; those that it cannot state go to the refusals.
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
