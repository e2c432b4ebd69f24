//! `carom worksheet`

use super::eval::{load_scene, scene_title};
use super::output::write_file;
use super::{Exit, print};
use crate::chain::ChainError;
use crate::number::NumberError;
use crate::number::decimal::Digits;
use crate::report::worksheet::{Form, Style, sheet};
use crate::table::worksheet::Worksheet;
use std::path::PathBuf;

/// The arguments.
#[derive(clap::Args)]
pub struct Flags {
    /// A scene file (see `carom help scene`); its chain is used, not its wants
    scene: PathBuf,
    /// Which sheets
    #[arg(long, value_enum, default_value = "both")]
    sheet: Which,
    /// Significant digits
    #[arg(long, value_name = "D", default_value_t = 4, conflicts_with = "places")]
    digits: u64,
    /// Digits after the point, instead of significant ones
    #[arg(long, value_name = "P")]
    places: Option<u64>,
    /// Write short fractions as p/q where a value is rational
    #[arg(long)]
    exact: bool,
    /// The form
    #[arg(long, value_enum, default_value = "text")]
    format: Form,
    /// Write to a file
    #[arg(long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// The sheets.
#[derive(Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Which {
    /// To be filled in
    Blank,
    /// The answers
    Key,
    /// One after the other
    Both,
}

/// Runs the command.
pub fn run(flags: &Flags) -> Result<u8, Exit> {
    let scene = load_scene(&flags.scene)?;
    let fail = |error: ChainError| {
        let limit = matches!(error, ChainError::Number(NumberError::LimitReached { .. }));
        Exit { code: if limit { 3 } else { 2 }, message: format!("error: {}: {error}", flags.scene.display()) }
    };
    let worksheet = scene.inputs.whole("a worksheet").and_then(Worksheet::of).map_err(fail)?;
    if flags.places.is_none() && flags.digits == 0 {
        return Err(Exit::usage("error: --digits 0: give at least one significant digit"));
    }
    let digits = flags.places.map_or(Digits::Significant(flags.digits), Digits::Places);
    let style = Style { form: flags.format, digits, exact: flags.exact };
    let title = scene_title(&flags.scene);
    let mut text = String::new();
    for (which, filled) in [(Which::Blank, false), (Which::Key, true)] {
        if flags.sheet == which || flags.sheet == Which::Both {
            if !text.is_empty() {
                // Pupils do not get the key.
                text.push_str(if flags.format == Form::Latex { "\\newpage\n" } else { "\n" });
            }
            text.push_str(&sheet(&worksheet, &title, style, filled).map_err(|e| fail(e.into()))?);
        }
    }
    match &flags.output {
        Some(path) => write_file(path, &text)?,
        None => print(&text)?,
    }
    Ok(0)
}
