//! `carom repair`: the hypothesis that a refuted claim lacks.

use super::audit::load_for;
use super::{Exit, PrintFormat, statements, write_file};
use crate::certificate::text::write;
use crate::claim::print;
use crate::judge::repair::{NoRepair, Repair, repair};
use crate::judge::{Entry, Settings};
use crate::refute::catalogue::Limits;
use crate::report::counted;
use std::path::{Path, PathBuf};

/// The text that the command prints, and its exit code: 1 if no repair is found.
pub(super) fn run(id: &str, paths: &[PathBuf], folder: Option<&Path>, limits: &Limits) -> Result<(String, u8), Exit> {
    let only = [id.to_string()];
    let loaded = load_for(paths, id)?.with_certificates(false)?;
    let settings = Settings { limits: limits.clone(), ..Settings::default() };
    let Some((_, found)) = loaded.judge(&only, &settings).entries.pop() else {
        return Err(Exit::usage(format!("error: no claim is called {id}")));
    };
    let entry = found.map_err(|fault| loaded.failure(id, fault))?;
    match repair(&entry, limits) {
        Ok(repair) => {
            if let Some(folder) = folder {
                let cannot = |e: std::io::Error| Exit::usage(format!("error: cannot make {}: {e}", folder.display()));
                std::fs::create_dir_all(folder).map_err(cannot)?;
                let path = folder.join(format!("{}.cert", repair.claim.name.text));
                write_file(&path, &write(&repair.certificate))?;
            }
            Ok((words(&entry, &repair), 0))
        }
        Err(NoRepair::NotRefuted(verdict)) => {
            let tried = match entry.outcome.points + entry.outcome.open {
                0 => String::new(),
                points => format!(", and no counterexample was found at {}", counted(points, "point")),
            };
            Ok((format!("{id} is {}{tried}; only a refuted claim can be repaired\n", verdict.name()), 1))
        }
        Err(NoRepair::Dimensions) => {
            let reason = entry.outcome.reason.unwrap_or_default();
            Ok((
                format!("{id} is refuted: {reason}\nNo hypothesis changes that; correct the equation or the units\n"),
                1,
            ))
        }
        Err(NoRepair::NoneOf(tried)) => Ok((
            format!(
                "{id} is refuted, and none of the {tried} hypotheses tried makes it provable; add a hypothesis and audit it again\n"
            ),
            1,
        )),
    }
}

/// A repair as text: the hypothesis, what was proved, and the claim in the claim language.
fn words(entry: &Entry, repair: &Repair) -> String {
    let name = &entry.claim.name.text;
    let hypothesis = print::prop(&repair.hypothesis);
    let holds = if repair.exact { "holds exactly where" } else { "holds where" };
    let mut out = format!("{name} {holds} {hypothesis}\n");
    if let Some(witness) = entry.outcome.witness.as_ref().filter(|w| !w.point.values.is_empty()) {
        let at = witness.point.in_words(&entry.claim);
        out += &format!("without this hypothesis it fails at {}\n", at.join(", "));
    }
    out += "proved: the kernel accepted a certificate of this claim\n\n";
    out + &statements::one(&repair.claim, PrintFormat::Text)
}
