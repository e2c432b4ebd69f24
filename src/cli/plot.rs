//! `carom plot`

use super::eval::{described, scene_title};
use super::form::place;
use super::output::write_bytes;
use super::progress::Progress;
use super::table_contents::{grid, joined};
use super::{Exit, print, terminal};
use crate::chain::best::{Best, best};
use crate::chain::threshold::threshold;
use crate::chain::uncertain::Range;
use crate::chain::{ChainError, Positive, Restitution, Restitutions, transfer};
use crate::number::decimal::{Decimal, Digits, Rounding};
use crate::number::real::Real;
use crate::number::{NumberError, typed};
use crate::report::plot::axes::Chart;
use crate::report::plot::charts::{self, CURVES};
use crate::report::plot::look::Look;
use crate::report::plot::png::{self, PngError};
use crate::report::plot::shape::Page;
use crate::report::plot::unclear::Unclear;
use crate::report::plot::{pdf, svg};
use crate::report::worksheet::Units;
use crate::scene::read::Subject;
use crate::table::grid::Grid;
use crate::table::worksheet::Worksheet;
use clap::ValueEnum;
use malachite::Rational;
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::rounding_modes::RoundingMode;
use std::path::PathBuf;

/// The flags for the contents of a picture.
#[derive(clap::Args)]
pub(super) struct Contents {
    /// What to draw
    #[arg(value_enum)]
    picture: Picture,
    /// A scene file, for the picture of velocities
    scene: Option<PathBuf>,
    /// For eta-n: the mass ratio m1/m2 [default: 100]. For the other curves: the range FROM,TO [default: 1/1000,1000]
    #[arg(long, value_name = "R[,R]", allow_hyphen_values = true)]
    ratio: Vec<String>,
    /// Coefficient of restitution for eta-x [default: 0.9], or several for eta-n [default: 0.5,0.8,0.9,0.95,1]
    #[arg(short, long = "restitution", value_name = "GRID", allow_hyphen_values = true)]
    e: Vec<String>,
    /// Numbers of inserted bodies for eta-x [default: 0,1,2,5,10] and threshold [default: 1,2,3,5,10], or the greatest one
    /// for eta-n [default: twice the best one, at least 8]
    #[arg(short, long = "inserted", value_name = "GRID", allow_hyphen_values = true)]
    n: Vec<String>,
    /// The title [default: a description of the picture]
    #[arg(long, value_name = "TEXT")]
    title: Option<String>,
    /// The ends of the horizontal axis; curves are cut off beyond it. If it shows ratios, --ratio does the same
    #[arg(long, value_name = "FROM,TO", allow_hyphen_values = true)]
    xlim: Option<String>,
    /// The ends of the vertical axis; curves are cut off beyond it
    #[arg(long, value_name = "FROM,TO", allow_hyphen_values = true)]
    ylim: Option<String>,
    /// Mark a measured point, with or without uncertainties, as in "10.6 ± 0.1,0.74 ± 0.02"; may be repeated
    #[arg(long, value_name = "X,Y", allow_hyphen_values = true)]
    mark: Vec<String>,
    /// Mark every curve at this mass ratio (eta-n: number of bodies), and print its value in the legend
    #[arg(long, value_name = "X", allow_hyphen_values = true)]
    at: Option<String>,
    /// Draw without colours: curves differ in their dashes, areas in their brightness
    #[arg(long)]
    grey: bool,
}

/// The arguments.
#[derive(clap::Args)]
pub(super) struct Flags {
    #[command(flatten)]
    contents: Contents,
    /// The file to write: .svg, .png or .pdf; - writes SVG to standard output; may be repeated
    #[arg(short, long, value_name = "FILE", required = true)]
    output: Vec<PathBuf>,
    /// Pixels of a PNG for each point; a picture is 690 by 440 points, or larger for long labels
    #[arg(long, value_name = "S", default_value_t = 2.0, allow_hyphen_values = true)]
    scale: f32,
}

/// The pictures.
#[derive(Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Picture {
    /// eta against the mass ratio, for several n
    EtaX,
    /// eta against n, for several restitutions, with n* marked
    EtaN,
    /// L_n against the mass ratio, for several n
    Threshold,
    /// A map over restitution and mass ratio, coloured by n*
    Map,
    /// The velocities of a scene's bodies
    Velocities,
}

impl Picture {
    /// Its name on the command line.
    fn name(self) -> String {
        self.to_possible_value().map_or(String::new(), |value| value.get_name().to_owned())
    }
}

/// Where a file ends decides its form.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Form {
    Svg,
    Png,
    Pdf,
}

/// The error of a flag or a file, which it names.
fn failure(of: &str, error: &ChainError) -> Exit {
    let limit = matches!(error, ChainError::Number(NumberError::LimitReached { .. }));
    Exit { code: if limit { 3 } else { 2 }, message: format!("error: {of}: {error}") }
}

/// The error of a picture that cannot be drawn.
fn unclear(error: &Unclear) -> Exit {
    match error {
        Unclear::Chain(error) => failure("the picture", error),
        other => Exit::usage(format!("error: the picture: {other}")),
    }
}

/// The values of a grid, or of the default one.
fn values(flag: &str, given: Option<String>, default: &str) -> Result<Vec<Rational>, Exit> {
    let found = grid(flag, Some(given.as_deref().unwrap_or(default)))?;
    let Some(found) = found else { return Ok(Vec::new()) };
    if found.len() > CURVES as u64 {
        return Err(Exit::usage(format!(
            "error: {flag}: a picture has at most {CURVES} curves, {} are asked for",
            found.len()
        )));
    }
    Ok(all(&found))
}

/// Two values around a semicolon, or around the only comma that stands outside of brackets.
fn two(text: &str) -> Option<(&str, &str)> {
    if let Some(both) = text.split_once(';') {
        return Some(both);
    }
    let mut depth = 0_i32;
    let mut commas = text.char_indices().filter(|(_, c)| {
        depth += i32::from(*c == '[') - i32::from(*c == ']');
        *c == ',' && depth <= 0
    });
    let (at, _) = commas.next()?;
    commas.next().is_none().then(|| (&text[..at], &text[at + 1..]))
}

fn all(grid: &Grid) -> Vec<Rational> {
    (0..grid.len()).filter_map(|i| grid.value(i)).collect()
}

impl Contents {
    /// The ends of the range of ratios.
    fn range(&self) -> Result<(Positive, Positive), Exit> {
        let given = joined(&self.ratio).unwrap_or_else(|| "1/1000,1000".to_owned());
        // Two ends need a comma between them: a single one is no decimal comma.
        let text = if given.matches(',').count() == 1 { given.replace(',', ";") } else { given.clone() };
        let text = text.as_str();
        // A grid rejects repeated numbers, but its advice to leave one out would be wrong for a range.
        if let Some((from, to)) = text.split_once(';')
            && let (Ok(from), Ok(to)) = (typed::read(from), typed::read(to))
            && from == to
        {
            return Err(Exit::usage(format!(
                "error: --ratio {given}: the two ends are the same; write a range, as in 1/100,100"
            )));
        }
        let list = values("--ratio", Some(text.to_owned()), "")?;
        let ends: Result<Vec<Positive>, ChainError> = list.into_iter().map(Positive::new).collect();
        match ends.map_err(|e| failure("--ratio", &e))?.as_slice() {
            [from, to] if from < to => {
                let bound = Rational::from(10u32);
                let large =
                    |x: &Positive| *x.value() > malachite::base::num::arithmetic::traits::Pow::pow(&bound, 300i64);
                if large(to)
                    || large(&Positive::new(Rational::from(1u32)).map_err(|e| failure("--ratio", &e))?.over(from))
                {
                    return Err(Exit::usage("error: --ratio: give ratios between 1e-300 and 1e300"));
                }
                if to.value() / from.value() < Rational::from_signeds(1_000_001, 1_000_000) {
                    return Err(Exit::usage(
                        "error: --ratio: the two ends differ by less than a millionth; write a wider range",
                    ));
                }
                Ok((from.clone(), to.clone()))
            }
            _ => Err(Exit::usage("error: --ratio: give the two ends of the range, the smaller one first: 1/1000,1000")),
        }
    }

    fn numbers(&self, default: &str, least: u64) -> Result<Vec<u64>, Exit> {
        let list = values("-n", joined(&self.n), default)?;
        list.iter()
            .map(|n| u64::try_from(n).ok().filter(|n| *n >= least))
            .collect::<Option<_>>()
            .ok_or_else(|| Exit::usage(format!("error: -n: give whole numbers of bodies, at least {least}")))
    }

    fn restitutions(&self, default: &str) -> Result<Vec<Restitution>, Exit> {
        let list = values("-e", joined(&self.e), default)?;
        list.into_iter().map(Restitution::new).collect::<Result<_, _>>().map_err(|e| failure("-e", &e))
    }

    /// The picture.
    ///
    /// # Errors
    /// Flags that have no place in it, values out of their range, a limit.
    pub(super) fn draw(&self) -> Result<Page, Exit> {
        let refuse = |given: bool, flag: &str| {
            if given {
                Err(Exit::usage(format!("error: `plot {}` does not take {flag}", self.picture.name())))
            } else {
                Ok(())
            }
        };
        refuse(self.scene.is_some() && self.picture != Picture::Velocities, "a scene file")?;
        refuse(!self.e.is_empty() && !matches!(self.picture, Picture::EtaX | Picture::EtaN), "-e")?;
        refuse(!self.n.is_empty() && matches!(self.picture, Picture::Map | Picture::Velocities), "-n")?;
        refuse(!self.ratio.is_empty() && self.picture == Picture::Velocities, "--ratio")?;
        let chart = match self.picture {
            Picture::EtaX => {
                let (from, to) = self.range()?;
                let list = self.restitutions("0.9")?;
                let [e] = list.as_slice() else { return Err(Exit::usage("error: -e: give one restitution")) };
                charts::eta_of_ratio(&from, &to, e, &self.numbers("0,1,2,5,10", 0)?)
            }
            Picture::EtaN => self.eta_of_number()?,
            Picture::Threshold => {
                let (from, to) = self.range()?;
                charts::thresholds(&from, &to, &self.numbers("1,2,3,5,10", 1)?)
            }
            Picture::Map => {
                let (from, to) = self.range()?;
                charts::map(&from, &to)
            }
            Picture::Velocities => {
                let Some(path) = &self.scene else { return Err(Exit::usage("error: give a scene file")) };
                let (about, subject) = described(path)?;
                let worksheet = match &subject {
                    Subject::Chain(scene) => scene.inputs.whole("this picture").and_then(Worksheet::of),
                    Subject::Drop(drop, _) => Worksheet::of_drop(drop),
                };
                let worksheet = worksheet.map_err(|e| failure(&path.display().to_string(), &e))?;
                let unit = Units::of(&about, matches!(subject, Subject::Drop(..))).velocity;
                let title = about.title.unwrap_or_else(|| format!("Velocities: {}", scene_title(path)));
                charts::velocities(&worksheet, &title, unit.as_deref())
            }
        };
        let mut chart = chart.map_err(|e| unclear(&e))?;
        if let Some(at) = &self.at {
            self.mark_curves(at, &mut chart)?;
        }
        let page = self.look()?.apply(chart).and_then(Chart::finish).map_err(|e| unclear(&e))?;
        Ok(if self.grey { page.grey() } else { page })
    }

    /// Title, limits and own points.
    fn look(&self) -> Result<Look, Exit> {
        let ends = |flag: &str, text: &Option<String>| {
            let Some(text) = text else { return Ok(None) };
            let wrong = || Exit::usage(format!("error: {flag} {text}: write two numbers, as in 0,0.5"));
            let (from, to) = two(text).ok_or_else(wrong)?;
            let number = |text: &str| typed::read(text).map_err(|_| wrong());
            let float = |x: Rational| f64::rounding_from(&x, RoundingMode::Nearest).0;
            let ends = (float(number(from)?), float(number(to)?));
            if ends.0 >= ends.1 {
                return Err(Exit::usage(format!("error: {flag} {text}: write the smaller number first")));
            }
            Ok(Some(ends))
        };
        let point = |text: &String| {
            let wrong = |e: &dyn std::fmt::Display| Exit::usage(format!("error: --mark {text}: {e}"));
            let (x, y) = two(text).ok_or_else(|| wrong(&"write X,Y, as in 10.6,0.74"))?;
            let read = |part: &str| Range::read(part).map_err(|e| wrong(&e));
            Ok((read(x)?, read(y)?))
        };
        Ok(Look {
            title: self.title.clone(),
            across: ends("--xlim", &self.xlim)?,
            upright: ends("--ylim", &self.ylim)?,
            points: self.mark.iter().map(point).collect::<Result<_, _>>()?,
        })
    }

    /// Marks each curve at one place, with its certified value in the legend.
    fn mark_curves(&self, at: &str, chart: &mut Chart) -> Result<(), Exit> {
        let wrong = |e: &dyn std::fmt::Display| Exit::usage(format!("error: --at {at}: {e}"));
        let x = typed::read(at).map_err(|e| wrong(&e))?;
        let shown = |value: &Real| Decimal::of_real(value, Digits::Significant(6), Rounding::Nearest);
        let values: Vec<Result<Real, ChainError>> = match self.picture {
            Picture::EtaX => {
                let ratio = Positive::new(x.clone()).map_err(|e| wrong(&e))?;
                let e = Restitutions::Same(self.restitutions("0.9")?.remove(0));
                self.numbers("0,1,2,5,10", 0)?.iter().map(|n| transfer::optimal(&ratio, &e, *n)).collect()
            }
            Picture::Threshold => {
                let ratio = Positive::new(x.clone()).map_err(|e| wrong(&e))?;
                self.numbers("1,2,3,5,10", 1)?.iter().map(|n| Ok(threshold(&ratio, *n)?)).collect()
            }
            Picture::EtaN => {
                let n = u64::try_from(&x).map_err(|_| wrong(&"write a number of bodies"))?;
                let ratio = values("--ratio", joined(&self.ratio), "100")?.remove(0);
                let ratio = Positive::new(ratio).map_err(|e| wrong(&e))?;
                let list = self.restitutions("0.5,0.8,0.9,0.95,1")?;
                list.into_iter().map(|e| transfer::optimal(&ratio, &Restitutions::Same(e), n)).collect()
            }
            Picture::Map | Picture::Velocities => {
                return Err(wrong(&"this picture has no curves to mark; --mark X,Y marks a point of your own"));
            }
        };
        chart.legend_title(&format!("at {at}:"));
        let across = f64::rounding_from(&x, RoundingMode::Nearest).0;
        for (place, value) in values.into_iter().enumerate() {
            let value = value.map_err(|e| failure("--at", &e))?;
            let (decimal, _) = shown(&value).map_err(|e| failure("--at", &e.into()))?;
            let height = f64::rounding_from(&decimal.value(), RoundingMode::Nearest).0;
            chart.dot(place, across, height, true, 4.0);
            let text = chart.label(place).map_or(decimal.to_string(), |label| format!("{label}: {decimal}"));
            chart.legend_dot(place, true, &text);
        }
        Ok(())
    }

    /// The claims of the catalogue that the drawn formulas are of.
    pub(super) fn claims(&self) -> &'static [&'static str] {
        match self.picture {
            Picture::EtaX => &["eq25"],
            Picture::EtaN => &["eq25", "b-best"],
            Picture::Threshold => &["eq19"],
            Picture::Map => &["eq19", "b-best"],
            Picture::Velocities => &["eq05", "eq06"],
        }
    }

    fn eta_of_number(&self) -> Result<Result<Chart, Unclear>, Exit> {
        let ratio = values("--ratio", joined(&self.ratio), "100")?;
        let [ratio] = ratio.as_slice() else { return Err(Exit::usage("error: --ratio: give one mass ratio")) };
        let ratio = Positive::new(ratio.clone()).map_err(|e| failure("--ratio", &e))?;
        let list = self.restitutions("0.5,0.8,0.9,0.95,1")?;
        let most = match self.n.is_empty() {
            false => match self.numbers("", 1)?.as_slice() {
                [most] => *most,
                _ => return Err(Exit::usage("error: -n: give the greatest number to draw")),
            },
            true => {
                // Twice as far as the best one.
                let mut most = 8;
                for e in &list {
                    if let Best::Finite { count, .. } = best(&ratio, e).map_err(|e| failure("-e", &e))?.0 {
                        most = most.max(u64::try_from(&count).unwrap_or(u64::MAX / 4).saturating_mul(2));
                    }
                }
                most
            }
        };
        Ok(charts::eta_of_number(&ratio, &list, most))
    }
}

/// Runs the command: the picture is drawn once and written to each file.
pub(super) fn run(flags: &Flags) -> Result<u8, Exit> {
    let mut files = Vec::new();
    for path in &flags.output {
        let end = path.extension().map(|e| e.to_ascii_lowercase());
        let form = match end.as_ref().and_then(|e| e.to_str()) {
            _ if place(Some(path)).is_none() => Form::Svg,
            Some("svg") => Form::Svg,
            Some("png") => Form::Png,
            Some("pdf") => Form::Pdf,
            _ => {
                let message = format!("error: {}: the file's name must end in .svg, .png or .pdf", path.display());
                return Err(Exit::usage(message));
            }
        };
        files.push((path, form));
    }
    let progress = Progress::alone("drawing");
    let page = flags.contents.draw()?;
    terminal::note_boxes("the picture", std::slice::from_ref(&page));
    let mut bytes = Vec::new();
    for (_, form) in &files {
        bytes.push(match form {
            Form::Svg => svg::render(&page).into_bytes(),
            Form::Pdf => pdf::render(std::slice::from_ref(&page)),
            Form::Png => {
                let code = |e: &PngError| if let PngError::Small { .. } = e { 2 } else { 3 };
                png::render(&page, flags.scale)
                    .map_err(|e| Exit { code: code(&e), message: format!("error: --scale: {e}") })?
            }
        });
    }
    progress.finish();
    for ((path, _), bytes) in files.iter().zip(&bytes) {
        match place(Some(path)) {
            Some(path) => write_bytes(path, bytes)?,
            None => print(&String::from_utf8_lossy(bytes))?,
        }
    }
    Ok(0)
}
