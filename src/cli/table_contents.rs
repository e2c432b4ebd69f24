//! The flags for the contents of a table, shared by `carom table` and `carom report --table`.

use super::Exit;
use super::table::exit;
use crate::number::decimal::{Digits, Rounding};
use crate::number::rational;
use crate::number::typed::{self, Unclear};
use crate::table::grid::{Grid, GridError};
use crate::table::{Plan, Printing, Quantity};
use malachite::Rational;
use malachite::base::num::conversion::traits::IsInteger;

/// The flags for the contents of a table.
#[derive(clap::Args)]
pub(super) struct Contents {
    /// Mass ratios m1/m2: `1,2,10`, `1:10:0.5` (start:stop:step) or `1:1000:x10` (start:stop:xFACTOR)
    #[arg(long, value_name = "GRID", allow_hyphen_values = true)]
    pub ratio: Vec<String>,
    /// Coefficients of restitution, for eta and best-n
    #[arg(short, long = "restitution", value_name = "GRID", allow_hyphen_values = true)]
    pub e: Vec<String>,
    /// Numbers of inserted bodies, for eta and threshold
    #[arg(short, long = "inserted", value_name = "GRID", allow_hyphen_values = true)]
    pub n: Vec<String>,
    /// The quantity
    #[arg(long, value_enum, default_value = "eta")]
    want: Want,
    /// Significant digits
    #[arg(long, value_name = "D", default_value_t = 6, conflicts_with = "places")]
    digits: u64,
    /// Digits after the point, instead of significant ones
    #[arg(long, value_name = "P")]
    places: Option<u64>,
    /// The direction of rounding
    #[arg(long, value_enum, default_value = "nearest")]
    pub round: Round,
    /// Also print K more digits of each value, with a bound on what is cut off
    #[arg(long, value_name = "K", default_value_t = 0)]
    extra: u64,
}

impl Contents {
    /// The table that is asked for.
    ///
    /// # Errors
    /// A grid that is missing, cannot be read, or is out of its range.
    pub(super) fn plan(&self) -> Result<Plan, Exit> {
        let ratio = grid("--ratio", joined(&self.ratio).as_deref())?;
        let e = grid("-e", joined(&self.e).as_deref())?;
        let n = grid("-n", joined(&self.n).as_deref())?;
        let Some(ratio) = ratio else { return Err(Exit::usage("error: give mass ratios, such as --ratio 1,2,10")) };
        let quantity = match self.want {
            Want::Eta => Quantity::Eta,
            Want::Threshold => Quantity::Threshold,
            Want::BestN => Quantity::BestN,
        };
        let digits = self.places.map_or(Digits::Significant(self.digits), Digits::Places);
        let printing = Printing { digits, rounding: self.round.rounding(), extra: self.extra };
        Plan::new(quantity, ratio, e, n, printing).map_err(|e| exit(&e))
    }
}

/// The quantities.
#[derive(Clone, Copy, clap::ValueEnum)]
pub(super) enum Want {
    /// The share of the first body's kinetic energy that reaches the last body, equation (25)
    Eta,
    /// L_n: the least restitution with which the n-th inserted body helps, equation (19)
    Threshold,
    /// n*: the best number of inserted bodies
    BestN,
}

/// The directions of rounding.
#[derive(Clone, Copy, clap::ValueEnum)]
pub(super) enum Round {
    /// To the nearest, ties to the even digit
    #[value(alias = "nearest-even")]
    Nearest,
    /// Never below the value
    Up,
    /// Never above the value
    Down,
    /// Towards zero
    Zero,
    /// Away from zero
    Away,
}

impl Round {
    /// The rule of rounding.
    pub(super) fn rounding(self) -> Rounding {
        match self {
            Round::Nearest => Rounding::Nearest,
            Round::Up => Rounding::Up,
            Round::Down => Rounding::Down,
            Round::Zero => Rounding::Zero,
            Round::Away => Rounding::Away,
        }
    }
}

/// The values of a flag as one list: it may be repeated, or hold several values with commas.
pub(super) fn joined(values: &[String]) -> Option<String> {
    if values.is_empty() { None } else { Some(values.join(", ")) }
}

/// A grid of the command line.
pub(super) fn grid(flag: &str, text: Option<&str>) -> Result<Option<Grid>, Exit> {
    let fault = |text: &str, e: &GridError| {
        let shown: String = text.chars().take(SHOWN).collect();
        let rest = if shown.len() < text.len() { "…" } else { "" };
        Exit { code: if e.is_limit() { 3 } else { 2 }, message: format!("error: {flag} {shown}{rest}: {e}") }
    };
    let Some(text) = text else { return Ok(None) };
    let in_range = |x: &Rational| match flag {
        "-n" => x.is_integer() && *x >= 0,
        "-e" => *x >= 0 && *x <= 1,
        _ => *x > 0,
    };
    let fits = |part: &str| rational::parse(part).is_ok_and(|x| in_range(&x));
    let plain = typed::grid(text, fits).map_err(|Unclear(what)| Exit::usage(format!("error: {flag}: {what}")))?;
    Grid::parse(&plain).map(Some).map_err(|e| fault(text, &e))
}

/// Characters of a grid that an error repeats.
const SHOWN: usize = 200;
