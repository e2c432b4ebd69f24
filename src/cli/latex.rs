//! A LaTeX document made into PDF by an installed LaTeX.
//!
//! Contract: the document is compiled in a folder of its own, which is removed afterwards, by a program that may start
//! no other and reads and writes only there. No time and no path enters the PDF.

use super::interrupt::{Interrupt, interrupted};
use super::progress::Progress;
use super::{Exit, output::write_bytes};
use std::fs::File;
use std::io::{ErrorKind, Read};
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::time::{Duration, Instant};

/// Programs that compile the document, the first that is found.
const PROGRAMS: [&str; 2] = ["pdflatex", "lualatex"];
/// The most passes: the table of contents moves pages, which changes the table.
const PASSES: u64 = 4;
/// How long one pass may take.
const TIME: Duration = Duration::from_secs(300);
/// What is left behind where the work on the PDF ends early.
pub(crate) const BUT_THE_PDF: &str = "everything but report.pdf is written";
/// The most bytes of its protocol that are looked at for an error.
const PROTOCOL: u64 = 16 << 20;

/// The PDF of `report.tex`, given with the pictures that it shows: paths in the folder and what the files hold.
///
/// # Errors
/// No LaTeX on this machine, packages that it lacks, a limit of time, Ctrl-C.
pub(super) fn pdf(files: &[&(String, Vec<u8>)], interrupt: Interrupt) -> Result<Vec<u8>, Exit> {
    let folder = tempfile::tempdir().map_err(|e| Exit::usage(format!("error: cannot make a temporary folder: {e}")))?;
    for (path, bytes) in files {
        let path = folder.path().join(path);
        if let Some(parent) = path.parent() {
            let made = std::fs::create_dir_all(parent);
            made.map_err(|e| Exit::usage(format!("error: cannot make the folder {}: {e}", parent.display())))?;
        }
        write_bytes(&path, bytes)?;
    }
    let Some(program) = PROGRAMS.into_iter().find(|p| is_installed(p, folder.path())) else {
        return Err(Exit::usage(
            "error: --pdf needs pdflatex or lualatex, and neither is on the PATH; install one (Debian and Ubuntu: \
             apt install texlive-latex-recommended); everything else was written: you can print index.html, or compile report.tex \
             elsewhere",
        ));
    };
    let mut before = None;
    let progress = Progress::start(PASSES);
    for number in 0..PASSES {
        progress.now(number, &format!("{program} makes report.pdf; at most {PASSES} passes"));
        pass(program, folder.path(), interrupt)?;
        let after = std::fs::read(folder.path().join("report.aux")).unwrap_or_default();
        if before.as_ref() == Some(&after) {
            break;
        }
        before = Some(after);
    }
    let pdf = folder.path().join("report.pdf");
    std::fs::read(&pdf).map_err(|e| Exit::usage(format!("error: {program} made no report.pdf: {e}")))
}

/// Whether the program starts.
fn is_installed(program: &str, folder: &Path) -> bool {
    let mut command = Command::new(program);
    command.arg("--version").current_dir(folder).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command.status().is_ok_and(|status| status.success())
}

/// Compiles once.
fn pass(program: &str, folder: &Path, interrupt: Interrupt) -> Result<(), Exit> {
    let mut command = Command::new(program);
    command
        .args(["-no-shell-escape", "-interaction=nonstopmode", "-halt-on-error", "-file-line-error", "report.tex"])
        .current_dir(folder)
        // Nothing outside the folder and the installation is opened.
        .envs([("openin_any", "p"), ("openout_any", "p")])
        // The PDF holds the time otherwise.
        .envs([("SOURCE_DATE_EPOCH", "0"), ("FORCE_SOURCE_DATE", "1")])
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null());
    let cannot = |e: std::io::Error| Exit::usage(format!("error: cannot run {program}: {e}"));
    let status = ended(command.spawn().map_err(cannot)?, program, interrupt)?;
    if status.success() {
        return Ok(());
    }
    // Ctrl-C on a terminal reaches LaTeX as well, which then fails.
    if interrupt.asked() {
        return Err(interrupted(BUT_THE_PDF));
    }
    if status.code().is_none() {
        return Err(Exit::usage(format!("error: {program} was stopped from outside ({status}); {BUT_THE_PDF}")));
    }
    let mut protocol = Vec::new();
    let _ = File::open(folder.join("report.log")).and_then(|f| f.take(PROTOCOL).read_to_end(&mut protocol));
    let protocol = String::from_utf8_lossy(&protocol);
    let fault = protocol.lines().find(|l| l.starts_with('!') || l.starts_with("./report.tex:"));
    Err(Exit::usage(format!(
        "error: {program} cannot compile report.tex: {}\n  the packages amsmath, booktabs, hyperref and longtable are needed \
         (Debian and Ubuntu: apt install texlive-latex-recommended); everything else was written",
        fault.unwrap_or("it printed no reason")
    )))
}

/// How the program ended, which Ctrl-C and too much time end.
fn ended(mut child: Child, program: &str, interrupt: Interrupt) -> Result<ExitStatus, Exit> {
    let begun = Instant::now();
    let reason = loop {
        match child.try_wait() {
            Ok(Some(status)) => return Ok(status),
            Err(e) if e.kind() != ErrorKind::Interrupted => {
                return Err(Exit::usage(format!("error: cannot run {program}: {e}")));
            }
            _ if interrupt.asked() => break interrupted(BUT_THE_PDF),
            _ if begun.elapsed() < TIME => std::thread::sleep(Duration::from_millis(20)),
            _ => {
                let message =
                    format!("error: limit reached: {} seconds for {program}; report.tex was written", TIME.as_secs());
                break Exit { code: 3, message };
            }
        }
    };
    // It is of no use any more, whether or not it can be stopped.
    let _ = child.kill().and_then(|()| child.wait());
    Err(reason)
}
