//! `carom worksheet`

use super::eval::{described, scene_title};
use super::form::{self, form};
use super::{Exit, deliver, terminal};
use crate::chain::ChainError;
use crate::number::NumberError;
use crate::number::decimal::Digits;
use crate::report::worksheet::made::{MAX_VERSIONS, STANDARD, Wanted, sheets};
use crate::report::worksheet::{Sheet, Style, html, latex, text};
use std::path::PathBuf;

/// The arguments.
#[derive(clap::Args)]
pub(super) struct Flags {
    /// A scene file (see `carom help scene`), - for standard input; its `want` is not used
    scene: PathBuf,
    /// Which sheets to write
    #[arg(long, value_enum, default_value = "both")]
    sheet: Which,
    /// Make N versions (A, B, C, …) of the sheet, each with other simple masses
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(1..=i64::from(MAX_VERSIONS)))]
    versions: Option<u8>,
    /// Seed of the random masses of --versions; the same seed gives the same masses
    #[arg(long, value_name = "SEED", default_value_t = 1, requires = "versions")]
    seed: u64,
    /// The title [default: the title in the scene file, else the file's name]
    #[arg(long, value_name = "TEXT")]
    title: Option<String>,
    /// Print the educational standard that the sheet serves [default without TEXT: NGSS HS-PS2-2]
    #[arg(long, value_name = "TEXT", num_args = 0..=1, default_missing_value = STANDARD)]
    standard: Option<String>,
    /// Significant digits
    #[arg(long, value_name = "D", default_value_t = 4, conflicts_with = "places")]
    digits: u64,
    /// Digits after the point, instead of significant ones
    #[arg(long, value_name = "P")]
    places: Option<u64>,
    /// Write rational values as short fractions p/q
    #[arg(long)]
    exact: bool,
    /// The form [default: by the ending of --output (.pdf, .html, .tex, .md), else text]
    #[arg(long, value_enum)]
    format: Option<Form>,
    /// The paper size of LaTeX, HTML and PDF
    #[arg(long, value_enum, default_value = "a4")]
    paper: Paper,
    /// Write to a file, - for standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// The forms.
#[derive(Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Form {
    /// For a terminal
    Text,
    /// Tables of Markdown
    Markdown,
    /// A document for pdflatex or lualatex
    Latex,
    /// A form to fill in on a screen, or to print
    Html,
    /// Pages to print; needs no LaTeX
    Pdf,
}

impl form::Form for Form {
    const DEFAULT: Self = Self::Text;
    const ENDINGS: &'static [(&'static str, Self)] = &[
        ("md", Self::Markdown),
        ("markdown", Self::Markdown),
        ("tex", Self::Latex),
        ("html", Self::Html),
        ("htm", Self::Html),
        ("pdf", Self::Pdf),
    ];
}

/// The paper.
#[derive(Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Paper {
    A4,
    Letter,
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
pub(super) fn run(flags: &Flags) -> Result<u8, Exit> {
    let form = form(flags.format, flags.output.as_deref())?;
    let fail = |error: ChainError| {
        let limit = matches!(error, ChainError::Number(NumberError::LimitReached { .. }));
        Exit { code: if limit { 3 } else { 2 }, message: format!("error: {}: {error}", flags.scene.display()) }
    };
    if flags.places.is_none() && flags.digits == 0 {
        return Err(Exit::usage("error: --digits 0: give at least one significant digit"));
    }
    let (about, scene) = described(&flags.scene)?;
    let digits = flags.places.map_or(Digits::Significant(flags.digits), Digits::Places);
    let title = flags.title.clone().or_else(|| about.title.clone()).unwrap_or_else(|| scene_title(&flags.scene));
    let wanted = Wanted {
        title: &title,
        standard: flags.standard.as_deref(),
        blank: flags.sheet != Which::Key,
        key: flags.sheet != Which::Blank,
        versions: flags.versions.unwrap_or(0),
        seed: flags.seed,
        style: Style { digits, exact: flags.exact },
    };
    written(&sheets(&about, &scene, &wanted).map_err(fail)?, form, flags)
}

fn written(sheets: &[Sheet], form: Form, flags: &Flags) -> Result<u8, Exit> {
    let letter = flags.paper == Paper::Letter;
    let joined = |one: fn(&Sheet) -> String| sheets.iter().map(one).collect::<Vec<_>>().join("\n\n");
    let text = match form {
        Form::Text => joined(text::text),
        Form::Markdown => joined(text::markdown),
        Form::Latex => latex::document(sheets, letter),
        Form::Html => html::page(sheets, letter),
        Form::Pdf => {
            let pages = crate::report::worksheet::pages::pages(sheets, letter);
            terminal::note_boxes("the PDF", &pages);
            let bytes = crate::report::plot::pdf::render(&pages);
            let Some(path) = form::place(flags.output.as_deref()) else {
                return Err(Exit::usage("error: --format pdf: give a file, as in -o sheet.pdf"));
            };
            return super::output::write_bytes(path, &bytes).map(|()| 0);
        }
    };
    deliver(flags.output.as_deref(), &text)?;
    Ok(0)
}
