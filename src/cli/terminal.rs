//! The flags of all commands: colours, and whether progress and notes are printed.

use super::output::message;
use crate::report::plot::letters::boxes;
use crate::report::plot::shape::Page;
use clap::ValueEnum;
use std::io::Write;
use std::sync::atomic::{AtomicBool, Ordering};

static QUIET: AtomicBool = AtomicBool::new(false);

/// When colours are shown.
#[derive(Clone, Copy, ValueEnum)]
pub(super) enum Color {
    /// On a terminal, unless NO_COLOR is set
    Auto,
    /// Also in files and pipes
    Always,
    /// Nowhere
    Never,
}

/// Flags of all commands.
#[derive(clap::Args)]
pub(super) struct Flags {
    /// When to use colours
    #[arg(long, global = true, value_enum, default_value = "auto", value_name = "WHEN", help_heading = "Everywhere")]
    color: Color,
    /// Print no progress and no notes. `audit` and `test` print only unexpected results, `check` prints no statements
    #[arg(short, long, global = true, help_heading = "Everywhere")]
    quiet: bool,
}

impl Flags {
    /// Applies the flags to everything printed from now on.
    pub(super) fn apply(&self) {
        match self.color {
            Color::Auto => anstream::ColorChoice::Auto,
            Color::Always => anstream::ColorChoice::AlwaysAnsi,
            Color::Never => anstream::ColorChoice::Never,
        }
        .write_global();
        QUIET.store(self.quiet, Ordering::Relaxed);
    }
}

/// Whether `--quiet` was given.
pub(super) fn quiet() -> bool {
    QUIET.load(Ordering::Relaxed)
}

/// Whether messages have colours.
pub(super) fn colour() -> bool {
    anstream::AutoStream::choice(&std::io::stderr()) != anstream::ColorChoice::Never
}

/// Prints a note on standard error, unless `--quiet` was given.
pub(super) fn note(text: &str) {
    if !quiet() {
        // A note that cannot be printed is not an error.
        let _ = writeln!(anstream::stderr(), "{}", message(text, colour()));
    }
}

/// The most characters that a note names.
const NAMED: usize = 8;

/// Notes which characters of a picture or sheet are drawn as empty boxes.
pub(super) fn note_boxes(what: &str, pages: &[Page]) {
    let boxes = boxes(pages);
    if boxes.is_empty() {
        return;
    }
    let named: Vec<String> = boxes.iter().take(NAMED).map(char::to_string).collect();
    let more = if boxes.len() > NAMED { " and others" } else { "" };
    note(&format!("note: {what} shows {}{more} as empty boxes: its font, DejaVu Sans, lacks them", named.join(" ")));
}

/// The columns of the terminal that output goes to, if it is one.
pub(super) fn width() -> Option<usize> {
    terminal_size::terminal_size_of(std::io::stdout()).map(|(columns, _)| usize::from(columns.0))
}
