//! `carom plot`

use super::eval::{load_scene, scene_title};
use super::output::write_bytes;
use super::{Exit, table_contents::grid};
use crate::chain::best::{Best, best};
use crate::chain::{ChainError, Positive, Restitution};
use crate::number::{NumberError, rational};
use crate::report::plot::charts::{self, CURVES};
use crate::report::plot::png::{self, PngError};
use crate::report::plot::shape::Page;
use crate::report::plot::svg;
use crate::report::plot::unclear::Unclear;
use crate::table::grid::Grid;
use crate::table::worksheet::Worksheet;
use malachite::Rational;
use std::path::PathBuf;

/// The arguments that say what is drawn.
#[derive(clap::Args)]
pub struct Contents {
    /// What to draw
    #[arg(value_enum)]
    picture: Picture,
    /// A scene file, for the picture of velocities
    scene: Option<PathBuf>,
    /// The mass ratio m1/m2 (eta-n), or the range of ratios FROM,TO (the others)
    #[arg(long, value_name = "R[,R]", allow_hyphen_values = true)]
    ratio: Option<String>,
    /// The restitution (eta-x), or several (eta-n)
    #[arg(short, long = "restitution", value_name = "GRID", allow_hyphen_values = true)]
    e: Option<String>,
    /// The numbers of inserted bodies (eta-x, threshold), or the greatest one (eta-n)
    #[arg(short, long = "inserted", value_name = "GRID", allow_hyphen_values = true)]
    n: Option<String>,
}

/// The arguments.
#[derive(clap::Args)]
pub struct Flags {
    #[command(flatten)]
    contents: Contents,
    /// The file to write: .svg or .png
    #[arg(short, long, value_name = "FILE", required = true)]
    output: Vec<PathBuf>,
    /// Pixels of a PNG for each point of the page, which has 690 by 440 points, and more for long labels
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
    /// The map of restitution and mass ratio, coloured by n*
    Map,
    /// The velocities of a scene's bodies
    Velocities,
}

/// Where a file ends decides its form.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Form {
    Svg,
    Png,
}

/// The error of a flag or a file, which it names.
fn failure(of: &str, error: &ChainError) -> Exit {
    let limit = matches!(error, ChainError::Number(NumberError::LimitReached { .. }));
    Exit { code: if limit { 3 } else { 2 }, message: format!("error: {of}: {error}") }
}

/// The error of a picture that cannot show what is asked for.
fn unclear(error: &Unclear) -> Exit {
    match error {
        Unclear::Chain(error) => failure("the picture", error),
        other => Exit::usage(format!("error: the picture: {other}")),
    }
}

/// The values of a grid, or of the default one.
fn values(flag: &str, given: Option<&str>, default: &str) -> Result<Vec<Rational>, Exit> {
    let found = grid(flag, Some(given.unwrap_or(default)))?;
    let Some(found) = found else { return Ok(Vec::new()) };
    if found.len() > CURVES as u64 {
        return Err(Exit::usage(format!(
            "error: {flag}: a picture has at most {CURVES} curves, {} are asked for",
            found.len()
        )));
    }
    Ok(all(&found))
}

fn all(grid: &Grid) -> Vec<Rational> {
    (0..grid.len()).filter_map(|i| grid.value(i)).collect()
}

impl Contents {
    /// The ends of the range of ratios.
    fn range(&self) -> Result<(Positive, Positive), Exit> {
        let text = self.ratio.as_deref().unwrap_or("1/1000,1000");
        // A grid has no number twice, but here neither of them is to be left out.
        if let Some((from, to)) = text.split_once(',')
            && let (Ok(from), Ok(to)) = (rational::parse(from.trim()), rational::parse(to.trim()))
            && from == to
        {
            return Err(Exit::usage(format!(
                "error: --ratio {text}: the two ends are the same; write a range, as in 1/100,100"
            )));
        }
        let list = values("--ratio", Some(text), "")?;
        let ends: Result<Vec<Positive>, ChainError> = list.into_iter().map(Positive::new).collect();
        match ends.map_err(|e| failure("--ratio", &e))?.as_slice() {
            [from, to] if from < to => {
                let bound = Rational::from(10u32);
                let large =
                    |x: &Positive| *x.value() > malachite::base::num::arithmetic::traits::Pow::pow(&bound, 300i64);
                if large(to)
                    || large(&Positive::new(Rational::from(1u32)).map_err(|e| failure("--ratio", &e))?.over(from))
                {
                    return Err(Exit::usage("error: --ratio: a picture reaches from 1e-300 to 1e300 at most"));
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
        let list = values("-n", self.n.as_deref(), default)?;
        list.iter()
            .map(|n| u64::try_from(n).ok().filter(|n| *n >= least))
            .collect::<Option<_>>()
            .ok_or_else(|| Exit::usage(format!("error: -n counts bodies: whole numbers from {least} on")))
    }

    fn restitutions(&self, default: &str) -> Result<Vec<Restitution>, Exit> {
        let list = values("-e", self.e.as_deref(), default)?;
        list.into_iter().map(Restitution::new).collect::<Result<_, _>>().map_err(|e| failure("-e", &e))
    }

    /// The picture.
    ///
    /// # Errors
    /// Flags that have no place in it, values out of their range, a limit.
    pub fn draw(&self) -> Result<Page, Exit> {
        let refuse = |given: bool, flag: &str| {
            if given { Err(Exit::usage(format!("error: {flag} has no place in this picture"))) } else { Ok(()) }
        };
        refuse(self.scene.is_some() && self.picture != Picture::Velocities, "a scene")?;
        refuse(self.e.is_some() && !matches!(self.picture, Picture::EtaX | Picture::EtaN), "-e")?;
        refuse(self.n.is_some() && matches!(self.picture, Picture::Map | Picture::Velocities), "-n")?;
        refuse(self.ratio.is_some() && self.picture == Picture::Velocities, "--ratio")?;
        let page = match self.picture {
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
                let scene = load_scene(path)?;
                let chain = scene.inputs.whole("this picture");
                let worksheet = chain.and_then(Worksheet::of).map_err(|e| failure(&path.display().to_string(), &e))?;
                charts::velocities(&worksheet, &format!("Velocities: {}", scene_title(path)))
            }
        };
        page.map_err(|e| unclear(&e))
    }

    /// The claims of the catalogue that the drawn formulas are of.
    pub fn claims(&self) -> &'static [&'static str] {
        match self.picture {
            Picture::EtaX => &["eq25"],
            Picture::EtaN => &["eq25", "b-best"],
            Picture::Threshold => &["eq19"],
            Picture::Map => &["eq19", "b-best"],
            Picture::Velocities => &["eq05", "eq06"],
        }
    }

    fn eta_of_number(&self) -> Result<Result<Page, Unclear>, Exit> {
        let ratio = values("--ratio", self.ratio.as_deref(), "100")?;
        let [ratio] = ratio.as_slice() else { return Err(Exit::usage("error: --ratio: give one mass ratio")) };
        let ratio = Positive::new(ratio.clone()).map_err(|e| failure("--ratio", &e))?;
        let list = self.restitutions("0.5,0.8,0.9,0.95,1")?;
        let most = match self.n {
            Some(_) => match self.numbers("", 1)?.as_slice() {
                [most] => *most,
                _ => return Err(Exit::usage("error: -n: give the greatest number to draw")),
            },
            None => {
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
pub fn run(flags: &Flags) -> Result<u8, Exit> {
    let mut files = Vec::new();
    for path in &flags.output {
        let end = path.extension().map(|e| e.to_ascii_lowercase());
        let form = match end.as_ref().and_then(|e| e.to_str()) {
            Some("svg") => Form::Svg,
            Some("png") => Form::Png,
            _ => {
                let message = format!("error: {}: the file's name must end in .svg or .png", path.display());
                return Err(Exit::usage(message));
            }
        };
        files.push((path, form));
    }
    let page = flags.contents.draw()?;
    let mut bytes = Vec::new();
    for (_, form) in &files {
        bytes.push(match form {
            Form::Svg => svg::render(&page).into_bytes(),
            Form::Png => {
                let code = |e: &PngError| if let PngError::Small { .. } = e { 2 } else { 3 };
                png::render(&page, flags.scale)
                    .map_err(|e| Exit { code: code(&e), message: format!("error: --scale: {e}") })?
            }
        });
    }
    for ((path, _), bytes) in files.iter().zip(&bytes) {
        write_bytes(path, bytes)?;
    }
    Ok(0)
}
