//! `carom worksheet`

use super::eval::{described, scene_title};
use super::form::{self, form, place};
use super::output::write_bytes;
use super::{Exit, deliver};
use crate::chain::ChainError;
use crate::number::NumberError;
use crate::number::decimal::Digits;
use crate::report::worksheet::{Sheet, Style, Subject, html, latex, sheet, text};
use crate::scene::drop::Drop;
use crate::scene::read::Subject as Scene;
use crate::scene::{About, versions};
use crate::table::worksheet::Worksheet;
use std::path::PathBuf;

/// The standard that a sheet names where none is given.
const STANDARD: &str =
    "NGSS HS-PS2-2, the total momentum of a system of objects is conserved when there is no net force on the system";
/// The most versions: a letter each.
const LETTERS: u8 = 26;

/// The arguments.
#[derive(clap::Args)]
pub struct Flags {
    /// A scene file (see `carom help scene`), - for standard input; its `want` is not used
    scene: PathBuf,
    /// Which sheets
    #[arg(long, value_enum, default_value = "both")]
    sheet: Which,
    /// Make so many versions with other simple masses: A, B, C and so on
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(1..=i64::from(LETTERS)))]
    versions: Option<u8>,
    /// The seed of the versions: the same seed gives the same masses
    #[arg(long, value_name = "SEED", default_value_t = 1, requires = "versions")]
    seed: u64,
    /// The title; without it that of the scene, or the file's name
    #[arg(long, value_name = "TEXT")]
    title: Option<String>,
    /// Name the standard that the sheet serves; without a text NGSS HS-PS2-2
    #[arg(long, value_name = "TEXT", num_args = 0..=1, default_missing_value = STANDARD)]
    standard: Option<String>,
    /// Significant digits
    #[arg(long, value_name = "D", default_value_t = 4, conflicts_with = "places")]
    digits: u64,
    /// Digits after the point, instead of significant ones
    #[arg(long, value_name = "P")]
    places: Option<u64>,
    /// Write short fractions as p/q where a value is rational
    #[arg(long)]
    exact: bool,
    /// The form [default: by the ending of --output (.pdf, .html, .tex, .md), else text]
    #[arg(long, value_enum)]
    format: Option<Form>,
    /// The paper of LaTeX, HTML and PDF
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
    #[cfg(feature = "plot")]
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
        #[cfg(feature = "plot")]
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

/// What one version is of.
struct Version {
    worksheet: Worksheet,
    drop: Option<Drop>,
    letter: Option<(char, u64)>,
}

/// Runs the command.
pub fn run(flags: &Flags) -> Result<u8, Exit> {
    let form = form(flags.format, flags.output.as_deref())?;
    let fail = |error: ChainError| {
        let limit = matches!(error, ChainError::Number(NumberError::LimitReached { .. }));
        Exit { code: if limit { 3 } else { 2 }, message: format!("error: {}: {error}", flags.scene.display()) }
    };
    if flags.places.is_none() && flags.digits == 0 {
        return Err(Exit::usage("error: --digits 0: give at least one significant digit"));
    }
    let (about, scene) = described(&flags.scene)?;
    let versions = versions(&scene, flags).map_err(fail)?;
    let digits = flags.places.map_or(Digits::Significant(flags.digits), Digits::Places);
    let style = Style { digits, exact: flags.exact };
    let title = flags.title.clone().or_else(|| about.title.clone()).unwrap_or_else(|| scene_title(&flags.scene));
    let mut sheets = Vec::new();
    // All that pupils get comes first.
    for (which, filled) in [(Which::Blank, false), (Which::Key, true)] {
        if flags.sheet == which || flags.sheet == Which::Both {
            for version in &versions {
                sheets.push(made(version, &about, &title, flags, style, filled).map_err(|e| fail(e.into()))?);
            }
        }
    }
    written(&sheets, form, flags)
}

/// The scene itself, or the versions of it that are asked for.
fn versions(scene: &Scene, flags: &Flags) -> Result<Vec<Version>, ChainError> {
    let letters = ('A'..='Z').map(|letter| Some((letter, flags.seed)));
    let count = usize::from(flags.versions.unwrap_or(0));
    let of_drop = |drop: &Drop, letter| {
        Ok::<_, ChainError>(Version { worksheet: Worksheet::of_drop(drop)?, drop: Some(drop.clone()), letter })
    };
    match scene {
        Scene::Drop(drop, _) if count == 0 => Ok(vec![of_drop(drop, None)?]),
        Scene::Drop(drop, _) => {
            let made = versions::of_drop(drop, flags.seed, count)?;
            made.iter().zip(letters).map(|(drop, letter)| of_drop(drop, letter)).collect()
        }
        Scene::Chain(scene) => {
            let chain = scene.inputs.whole("a worksheet")?;
            let made = if count == 0 { vec![chain.clone()] } else { versions::of_chain(chain, flags.seed, count)? };
            let letters = letters.map(|letter| letter.filter(|_| count > 0));
            let one = |(chain, letter)| Ok(Version { worksheet: Worksheet::of(chain)?, drop: None, letter });
            made.iter().zip(letters).map(one).collect()
        }
    }
}

fn made(
    version: &Version,
    about: &About,
    title: &str,
    flags: &Flags,
    style: Style,
    filled: bool,
) -> Result<Sheet, NumberError> {
    let Version { worksheet, drop, letter } = version;
    let (drop, standard) = (drop.as_ref(), flags.standard.as_deref());
    sheet(&Subject { worksheet, about, drop, title, version: *letter, standard }, style, filled)
}

fn written(sheets: &[Sheet], form: Form, flags: &Flags) -> Result<u8, Exit> {
    let letter = flags.paper == Paper::Letter;
    let joined = |one: fn(&Sheet) -> String| sheets.iter().map(one).collect::<Vec<_>>().join("\n\n");
    let text = match form {
        Form::Text => joined(text::text),
        Form::Markdown => joined(text::markdown),
        Form::Latex => latex::document(sheets, letter),
        Form::Html => html::page(sheets, letter),
        #[cfg(feature = "plot")]
        Form::Pdf => {
            let pages = crate::report::worksheet::pages::pages(sheets, letter);
            let bytes = crate::report::plot::pdf::render(&pages);
            let Some(path) = place(flags.output.as_deref()) else {
                return Err(Exit::usage("error: --format pdf: give a file, as in -o sheet.pdf"));
            };
            return write_bytes(path, &bytes).map(|()| 0);
        }
    };
    deliver(flags.output.as_deref(), &text)?;
    Ok(0)
}
