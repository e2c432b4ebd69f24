//! `carom restitution`: the coefficient of restitution from heights or times that a class has measured.

use super::form::form;
use super::{Exit, ValueFormat, deliver, load};
use crate::chain::bounces::Estimate;
use crate::report::bounces;
use crate::table::bounces::{MeasurementError, Measurements};
use std::path::PathBuf;

/// The most bytes of a file of measurements.
const MAX_BYTES: usize = 16 << 20;

/// The arguments.
#[derive(clap::Args)]
pub(super) struct Flags {
    /// A CSV file, - for standard input. Either one column `height` or `time` with successive bounces of a ball, and
    /// perhaps a column `run` that numbers the balls or tries; or two columns `drop` and `bounce`, one bounce a row
    file: PathBuf,
    /// The uncertainty of readings that the file gives without one: 0.01, or 2 %
    #[arg(long, value_name = "U")]
    within: Option<String>,
    /// Significant digits of the bounds
    #[arg(long, value_name = "D", default_value_t = 4, value_parser = clap::value_parser!(u64).range(1..=10_000))]
    digits: u64,
    /// The form of the answer [default: by the ending of --output (.json), else text]
    #[arg(long, value_enum)]
    format: Option<ValueFormat>,
    /// Write the answer to a file, - for standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// Runs the command: 0 for measurements that one coefficient explains, 1 for those that none does.
pub(super) fn run(flags: &Flags) -> Result<u8, Exit> {
    let found = read(flags)?;
    let estimate = found.estimate().map_err(|e| failure(flags, &e))?;
    let shown = match form(flags.format, flags.output.as_deref())? {
        ValueFormat::Text => bounces::text(&found, &estimate, flags.digits),
        ValueFormat::Json => bounces::json(&found, &estimate, flags.digits),
    };
    let shown = shown.map_err(|e| Exit { code: 3, message: format!("error: --digits: {e}") })?;
    deliver(flags.output.as_deref(), &shown)?;
    Ok(u8::from(matches!(estimate, Estimate::Contradiction(..))))
}

fn read(flags: &Flags) -> Result<Measurements, Exit> {
    let path = &flags.file;
    let bytes = load::bounded(path, MAX_BYTES).map_err(|e| load::cannot_read(path, &e))?;
    if bytes.len() > MAX_BYTES {
        let message = format!("error: {}: limit reached: {MAX_BYTES} bytes in a file", path.display());
        return Err(Exit { code: 3, message });
    }
    Measurements::read(&bytes, flags.within.as_deref()).map_err(|e| failure(flags, &e))
}

fn failure(flags: &Flags, error: &MeasurementError) -> Exit {
    let message = match error {
        MeasurementError::Within { .. } => format!("error: --{error}"),
        MeasurementError::Reading { line, .. } => format!("error: {}:{line}: {error}", flags.file.display()),
        _ => format!("error: {}: {error}", flags.file.display()),
    };
    Exit { code: if error.is_limit() { 3 } else { 2 }, message }
}
