//! `carom report`

use super::interrupt::{Interrupt, at_once, interrupted};
use super::{Exit, audit, figures, latex, terminal, theorems, write_bytes};
use crate::judge::Settings;
use crate::refute::outcome::DIMENSIONS;
use crate::report::handout::{Handout, evidence};
use std::path::{Path, PathBuf};

/// The arguments.
#[derive(clap::Args)]
pub(super) struct Flags {
    /// Claim files and folders [default: the built-in catalogue]
    paths: Vec<PathBuf>,
    /// The folder to write
    #[arg(short, long = "output", value_name = "DIR", visible_alias = "out")]
    out: PathBuf,
    /// The title
    #[arg(long)]
    title: Option<String>,
    /// Add a table: the flags of `carom table` in quotation marks, as in --table '--ratio 1,2,10 -e 0.9 -n 1:3:1'
    #[arg(long, value_name = "FLAGS", allow_hyphen_values = true)]
    table: Vec<String>,
    /// Add a picture: the arguments of `carom plot` in quotation marks, as in --plot 'eta-n --ratio 100'
    #[arg(long, value_name = "ARGUMENTS")]
    plot: Vec<String>,
    /// Translate each certificate into a Coq proof, run Coq on it if Coq is installed, and print beside each verdict
    /// whether Coq accepts the proof. The built-in catalogue takes minutes
    #[arg(long)]
    coq: bool,
    /// Also make report.pdf; this needs pdflatex or lualatex
    #[arg(long)]
    pdf: bool,
    #[command(flatten)]
    limits: super::LimitFlags,
}

/// Runs the command. It judges and computes everything first, so that nothing is written if that fails. The PDF comes last,
/// because LaTeX may not be installed. Ctrl-C ends the program at once while it computes, and after the last file while it
/// writes.
pub(super) fn run(flags: &Flags) -> Result<u8, Exit> {
    at_once()?;
    let (handout, faults) = made(flags)?;
    let files = handout.files();
    let interrupt = Interrupt::listen();
    for (path, bytes) in &files {
        let path = flags.out.join(path);
        if let Some(folder) = path.parent() {
            let made = std::fs::create_dir_all(folder);
            made.map_err(|e| Exit::usage(format!("error: cannot make the folder {}: {e}", folder.display())))?;
        }
        write_bytes(&path, bytes)?;
    }
    strangers(&flags.out, &files);
    let mut list = "index.html, report.md, report.tex".to_string();
    if interrupt.asked() {
        return Err(interrupted(if flags.pdf { latex::BUT_THE_PDF } else { "everything is written" }));
    }
    if flags.pdf {
        let needed: Vec<&(String, Vec<u8>)> =
            files.iter().filter(|f| f.0 == "report.tex" || f.0.ends_with(".png")).collect();
        write_bytes(&flags.out.join("report.pdf"), &latex::pdf(&needed, interrupt)?)?;
        list.push_str(", report.pdf");
    }
    super::print(&format!(
        "{}: {list} and {} in {}\n{}\n",
        handout.audit.count(),
        crate::report::counted(files.len() - 3, "file") + " that they link to",
        flags.out.display(),
        handout.vouched().join(" ")
    ))?;
    match faults.as_slice() {
        [] => Ok(audit::code(&handout.audit)),
        faults => Err(Exit::usage(faults.join("\n"))),
    }
}

/// The report, and what could not be judged.
fn made(flags: &Flags) -> Result<(Handout, Vec<String>), Exit> {
    let catalogue = flags.paths.is_empty();
    // The flags of tables and pictures are read before the claims are judged, so that an error in them costs no time.
    let defaults = |list: &[&str]| if catalogue { list.iter().map(ToString::to_string).collect() } else { Vec::new() };
    let tables: Vec<String> = [defaults(&figures::TABLES), flags.table.clone()].concat();
    let tables = tables.iter().map(|words| figures::table(words)).collect::<Result<_, _>>()?;
    // Computing a table handles Ctrl-C in its own way.
    at_once()?;
    let plots: Vec<String> = [defaults(&figures::PLOTS), flags.plot.clone()].concat();
    let plots = plots.iter().enumerate().map(|(place, words)| figures::plot(place, words)).collect::<Result<_, _>>()?;
    let settings = Settings { limits: flags.limits.limits(), argument: true, ..Settings::default() };
    let (audit, faults) = audit::all(&flags.paths, &settings)?;
    let proofs = theorems::of_audit(&audit, &settings.limits);
    let ran = match (&proofs, flags.coq) {
        (Ok(made), true) => theorems::ran(&audit, made)?,
        (Err(reason), true) => return Err(Exit::usage(format!("error: {reason}"))),
        _ => None,
    };
    let coq_ran = ran.is_some();
    let mut evidence = ran.unwrap_or_else(|| evidence::gather(&audit, proofs.as_ref().map_err(String::as_str)));
    // Where dimensions differ, neither the kernel nor Coq was asked.
    for entry in audit.entries.iter().filter(|entry| entry.outcome.method == DIMENSIONS) {
        evidence.remove(&entry.claim.name.text);
    }
    let coq = proofs.ok().filter(|made| made.theorems() > 0).map(|made| made.contents()).unwrap_or_default();
    let paper = audit.entries.iter().find_map(|e| e.claim.paper.as_deref());
    let title = flags.title.clone().unwrap_or_else(|| match (catalogue, paper) {
        (true, _) => {
            "Audit of Ricardo & Lee, Maximizing kinetic energy transfer in one-dimensional many-body collisions"
                .to_string()
        }
        (false, Some(paper)) => format!("Audit of {paper}"),
        (false, None) => "Audit".to_string(),
    });
    Ok((Handout { audit, title, evidence, coq, coq_ran, catalogue, tables, plots }, faults))
}

/// Notes files that an earlier report left in the folder, because `carom check` would read its certificates too.
fn strangers(out: &Path, files: &[(String, Vec<u8>)]) {
    let mut strange = Vec::new();
    for (folder, end) in [("certificates", ".cert"), ("tables", ""), ("plots", "")] {
        let Ok(entries) = std::fs::read_dir(out.join(folder)) else { continue };
        let names = entries.filter_map(|e| e.ok()?.file_name().into_string().ok());
        let names = names.filter(|name| name.ends_with(end)).map(|name| format!("{folder}/{name}"));
        strange.extend(names.filter(|name| files.iter().all(|file| file.0 != *name)));
    }
    strange.sort();
    if !strange.is_empty() {
        let (out, strange) = (out.display(), strange.join(", "));
        terminal::note(&format!("note: {out} contains files that do not belong to this report: {strange}"));
    }
}
