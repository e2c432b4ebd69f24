//! `carom report`

use super::{Exit, audit, write_file};
use crate::prove::catalogue::Limits;
use crate::report::{document, markdown, page};
use std::path::{Path, PathBuf};

/// Runs the command: judges everything first, so that nothing is written where that fails.
pub fn run(paths: &[PathBuf], out: &Path, title: Option<&str>, limits: &Limits) -> Result<u8, Exit> {
    let audit = audit::all(paths, limits)?;
    let title = title.unwrap_or(match paths {
        [] => "Audit of Ricardo & Lee, Maximizing kinetic energy transfer in one-dimensional many-body collisions",
        _ => "Audit",
    });
    std::fs::create_dir_all(out)
        .map_err(|e| Exit::usage(format!("error: cannot make the folder {}: {e}", out.display())))?;
    write_file(&out.join("index.html"), &page::page(&audit, title))?;
    write_file(&out.join("report.md"), &markdown::report(&audit))?;
    write_file(&out.join("report.tex"), &document::document(&audit, title))?;
    super::print(&format!("{}: index.html, report.md, report.tex in {}\n", audit.count(), out.display()))?;
    Ok(audit::code(&audit))
}
