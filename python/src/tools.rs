//! The rest of the program for Python: replays, worksheets, pictures, checks of tables, exports, certificates, laws.
//!
//! Contract: each function reads the text that the command of the same name reads, and answers with the text that the
//! command prints, or with one cell's judgement.

use crate::refusal::{Refusal, detached, detached_deep};
use carom::chain::replay::Options;
use carom::chain::uncertain::Range;
use carom::chain::{ChainError, Positive, Restitution};
use carom::claim::diagnostic::{self, Diagnostic, Span};
use carom::claim::parse::parse;
use carom::claim::syntax::Claim;
use carom::export::{coq, smt2};
use carom::number::NumberError;
use carom::number::decimal::{Decimal, Digits};
use carom::number::typed;
use carom::referee::Reference;
use carom::referee::judge::{MAX_DIGITS, judge as judge_scene};
use carom::referee::results::{self, ResultsError};
use carom::refute::goal::Seen;
use carom::refute::trial::{Trial, Untried};
use carom::report::plot::axes::Chart;
use carom::report::plot::charts::{eta_of_number, eta_of_ratio, map, thresholds, velocities};
use carom::report::plot::look::Look;
use carom::report::plot::unclear::Unclear;
use carom::report::plot::{pdf, svg};
use carom::report::referee;
use carom::report::replay as report;
use carom::report::worksheet::made::{MAX_VERSIONS, Wanted, sheets};
use carom::report::worksheet::{Style, Units, html, latex, pages, text};
use carom::scene::read::{self, ROUNDINGS, SceneFault};
use carom::scene::replay as bodies;
use carom::table::check::{Agreement, judge};
use carom::table::worksheet::Worksheet;
use carom::table::{Place, Quantity};
use malachite::Rational;
use malachite::base::num::conversion::traits::{FromStringBase, RoundingFrom};
use malachite::base::rounding_modes::RoundingMode;
use pyo3::prelude::*;

impl From<NumberError> for Refusal {
    fn from(error: NumberError) -> Refusal {
        Refusal::from(ChainError::Number(error))
    }
}

impl From<carom::Error> for Refusal {
    fn from(error: carom::Error) -> Refusal {
        match error {
            carom::Error::Limit(_) => Refusal::Limit(error.to_string()),
            other => Refusal::Input(other.to_string()),
        }
    }
}

/// A direction of rounding by its name.
pub fn rounding(name: &str) -> Result<carom::number::decimal::Rounding, Refusal> {
    let found = ROUNDINGS.iter().find(|(known, _)| *known == name).map(|(_, direction)| *direction);
    found.ok_or_else(|| Refusal::Input(format!("rounding: {name:?} is unknown; write nearest, up, down, zero or away")))
}

fn rational(name: &str, text: &str) -> Result<Rational, Refusal> {
    typed::read(text).map_err(|error| Refusal::at(name, error))
}

/// A fraction, from hexadecimal digits, as a decimal with so many significant digits.
#[pyfunction]
pub fn rounded(py: Python<'_>, parts: (String, String), digits: u64, direction: &str) -> Result<String, Refusal> {
    detached(py, || {
        let part = |text: &str| malachite::Integer::from_string_base(16, text);
        let parts = part(&parts.0).zip(part(&parts.1)).ok_or(Refusal::Failure)?;
        let number = Rational::from_integers(parts.0, parts.1);
        Ok(Decimal::of_rational(&number, Digits::Significant(digits), rounding(direction)?)?.to_string())
    })
}

/// A replay of a scene in one of its forms.
#[pyfunction]
#[allow(clippy::too_many_arguments)] // the flags of the command
pub fn replay(
    py: Python<'_>,
    scene: &str,
    form: &str,
    until: Option<String>,
    most: u64,
    list: usize,
    through_collapse: bool,
    orders: bool,
    digits: Option<u64>,
) -> Result<String, Refusal> {
    detached(py, || {
        let until = until.map(|until| rational("until", &until)).transpose()?;
        if until.as_ref().is_some_and(|time| *time < 0u32) {
            return Err(Refusal::Input("until must not be negative; the scene begins at time 0".to_owned()));
        }
        let options = Options {
            until,
            max_events: most,
            list,
            through_collapse,
            orders,
            digits: digits.unwrap_or(report::DEFAULT_DIGITS),
            ..Options::default()
        };
        let text = scene;
        let scene = bodies::read(text).map_err(|fault| unread(fault, text))?;
        let outcome = carom::replay(text, &options)?;
        let numbers = match (digits, form) {
            (Some(digits), _) => report::Numbers::Decimal(digits),
            (None, "json" | "csv") => report::Numbers::Exact,
            (None, _) => report::Numbers::Short(24, 12),
        };
        let made = report::Replay { title: scene.title.as_deref(), line: &scene.line, outcome: &outcome, numbers };
        match form {
            "text" => Ok(report::text::report(&made)),
            "json" => Ok(report::json::report(&made)),
            "csv" => Ok(report::csv::report(&made)),
            "svg" => Ok(report::svg::report(&made)),
            "html" => Ok(report::html::report(&made)),
            other => Err(unknown_form(other, "text, json, csv, svg or html")),
        }
    })
}

/// What to say of a form that a function does not write.
pub fn unknown_form(form: &str, known: &str) -> Refusal {
    Refusal::Input(format!("form: {form:?} is unknown; write {known}"))
}

/// What is wrong with a scene of bodies, at its place.
fn unread(fault: bodies::SceneError, text: &str) -> Refusal {
    let bodies::SceneError { message, help, span } = fault;
    let span = Span { start: span.start, end: span.end };
    Refusal::Input(Diagnostic::new(diagnostic::Fault::Other { message, help }, span).render("scene", text, false))
}

fn scene_fault(fault: SceneFault, text: &str) -> Refusal {
    let said = fault.diagnostic.render("scene", text, false);
    if fault.limit { Refusal::Limit(said) } else { Refusal::Input(said) }
}

fn described(scene: &str) -> Result<(carom::scene::About, read::Subject), Refusal> {
    read::described(scene).map_err(|fault| scene_fault(fault, scene))
}

/// Worksheets, their keys, or both, as bytes: text is UTF-8.
#[pyfunction]
#[allow(clippy::too_many_arguments)] // the flags of the command
pub fn worksheet(
    py: Python<'_>,
    scene: &str,
    form: &str,
    which: &str,
    title: Option<String>,
    standard: Option<String>,
    digits: (bool, u64),
    exact: bool,
    letter: bool,
    versions: (u64, u64),
) -> Result<Vec<u8>, Refusal> {
    detached(py, || {
        let (about, subject) = described(scene)?;
        let title = title.or_else(|| about.title.clone()).unwrap_or_else(|| "Collisions".to_owned());
        if !["blank", "key", "both"].contains(&which) {
            return Err(Refusal::Input(format!("sheet: {which:?} is unknown; write blank, key or both")));
        }
        let count = u8::try_from(versions.0).ok().filter(|count| *count <= MAX_VERSIONS).ok_or_else(|| {
            Refusal::Limit(format!("limit reached: versions: {MAX_VERSIONS} allowed, {} asked for", versions.0))
        })?;
        let digits = if digits.0 { Digits::Places(digits.1) } else { Digits::Significant(digits.1.max(1)) };
        let wanted = Wanted {
            title: &title,
            standard: standard.as_deref(),
            blank: which != "key",
            key: which != "blank",
            versions: count,
            seed: versions.1,
            style: Style { digits, exact },
        };
        let sheets = sheets(&about, &subject, &wanted)?;
        let joined = |one: fn(&_) -> String| sheets.iter().map(one).collect::<Vec<_>>().join("\n\n");
        Ok(match form {
            "text" => joined(text::text).into_bytes(),
            "markdown" => joined(text::markdown).into_bytes(),
            "latex" => latex::document(&sheets, letter).into_bytes(),
            "html" => html::page(&sheets, letter).into_bytes(),
            "pdf" => pdf::render(&pages::pages(&sheets, letter)),
            other => return Err(unknown_form(other, "text, markdown, latex, html or pdf")),
        })
    })
}

/// How a picture looks: title, ends of the two axes, own points, without colours.
type Looks = (Option<String>, Option<(String, String)>, Option<(String, String)>, Vec<(String, String)>, bool);

fn look((title, across, upright, points, _): &Looks) -> Result<Look, Refusal> {
    let ends = |name: &str, ends: &Option<(String, String)>| {
        let Some((from, to)) = ends else { return Ok(None) };
        let float = |text: &str| Ok::<_, Refusal>(f64::rounding_from(&rational(name, text)?, RoundingMode::Nearest).0);
        let ends = (float(from)?, float(to)?);
        if ends.0 >= ends.1 {
            return Err(Refusal::Input(format!("{name}: write the smaller number first")));
        }
        Ok(Some(ends))
    };
    let range = |text: &String| Range::read(text).map_err(|error| Refusal::at("mark", error));
    Ok(Look {
        title: title.clone(),
        across: ends("xlim", across)?,
        upright: ends("ylim", upright)?,
        points: points.iter().map(|(x, y)| Ok::<_, Refusal>((range(x)?, range(y)?))).collect::<Result<_, _>>()?,
    })
}

/// A chart as SVG.
fn drawn(chart: Result<Chart, Unclear>, looks: &Looks) -> Result<String, Refusal> {
    let look = look(looks)?;
    let page = chart.and_then(|chart| look.apply(chart)).and_then(Chart::finish);
    let page = page.map_err(|e| Refusal::Input(e.to_string()))?;
    Ok(svg::render(&if looks.4 { page.grey() } else { page }))
}

/// A picture as SVG: of ratios from and to, restitutions, numbers of bodies.
#[pyfunction]
pub fn plot(
    py: Python<'_>,
    picture: &str,
    ratio: Vec<String>,
    e: Vec<String>,
    n: Vec<u64>,
    looks: Looks,
) -> Result<String, Refusal> {
    detached(py, || {
        let mass = |text: &String| Ok::<_, Refusal>(Positive::new(rational("ratio", text)?)?);
        let ratios = ratio.iter().map(mass).collect::<Result<Vec<_>, _>>()?;
        let coefficient = |text: &String| Ok::<_, Refusal>(Restitution::new(rational("e", text)?)?);
        let all = e.iter().map(coefficient).collect::<Result<Vec<_>, _>>()?;
        let needs = |what: &str| Refusal::Input(format!("the picture {picture} needs {what}"));
        let chart = match (picture, ratios.as_slice(), all.as_slice()) {
            ("eta-n", [ratio], [_, ..]) => {
                let most = n.first().copied().ok_or_else(|| needs("n, the most bodies"))?;
                eta_of_number(ratio, &all, most)
            }
            ("eta-x", [from, to], [e]) if !n.is_empty() => eta_of_ratio(from, to, e, &n),
            ("threshold", [from, to], []) if !n.is_empty() => thresholds(from, to, &n),
            ("map", [from, to], []) => map(from, to),
            ("eta-n", ..) => return Err(needs("one ratio, one e or more, and n, the most bodies")),
            ("eta-x", ..) => return Err(needs("two ratios, one e, and numbers n of bodies")),
            ("threshold", ..) => return Err(needs("two ratios, no e, and numbers n of bodies")),
            ("map", ..) => return Err(needs("two ratios, and no e")),
            _ => return Err(Refusal::Input(format!("no picture is called {picture:?}: eta-n, eta-x, threshold, map"))),
        };
        drawn(chart, &looks)
    })
}

/// A picture of the velocities of a scene, as SVG.
#[pyfunction]
pub fn plot_velocities(py: Python<'_>, scene: &str, looks: Looks) -> Result<String, Refusal> {
    detached(py, || {
        let (about, subject) = described(scene)?;
        let title = about.title.clone().unwrap_or_else(|| "Velocities".to_owned());
        let table = match &subject {
            read::Subject::Drop(drop, _) => Worksheet::of_drop(drop)?,
            read::Subject::Chain(scene) => Worksheet::of(scene.inputs.whole("a picture of velocities")?)?,
        };
        let unit = Units::of(&about, matches!(subject, read::Subject::Drop(..))).velocity;
        drawn(velocities(&table, &title, unit.as_deref()), &looks)
    })
}

/// The schema of scene files, for editors.
#[pyfunction]
pub fn scene_schema() -> &'static str {
    read::SCHEMA
}

/// The referee's scenes as JSON, or their right answers as CSV.
#[pyfunction]
pub fn referee_file(py: Python<'_>, answers: bool) -> Result<String, Refusal> {
    detached(py, || {
        let references = references()?;
        let listed: Vec<&Reference> = references.iter().collect();
        Ok(if answers { referee::answers(&listed) } else { referee::scenes(&listed) })
    })
}

/// A fault of the program's own scenes, which its tests exclude, is a failure.
fn references() -> Result<Vec<Reference>, Refusal> {
    carom::referee::scenes().map_err(|_| Refusal::Failure)
}

/// Somebody's results beside the exact ones: the judgement as JSON and in words.
#[pyfunction]
pub fn judge_simulator(py: Python<'_>, results: &str, digits: u64) -> Result<(String, String), Refusal> {
    detached(py, || {
        if !(1..=MAX_DIGITS).contains(&digits) {
            return Err(Refusal::Input(format!("digits: write a number from 1 to {MAX_DIGITS}, not {digits}")));
        }
        let references = references()?;
        let scenes: Vec<_> = references.iter().map(|reference| reference.scene.clone()).collect();
        let results = results::read(results.as_bytes(), &scenes).map_err(|error| {
            let line =
                if let ResultsError::Field { line, .. } = &error { format!("line {line}: ") } else { String::new() };
            let said = format!("{line}{error}");
            if error.is_limit() { Refusal::Limit(said) } else { Refusal::Input(said) }
        })?;
        let one = |reference| (reference, judge_scene(reference, results.get(&reference.scene.name), digits));
        let judged: Vec<_> = references.iter().map(one).collect();
        Ok((referee::json(&judged, digits), referee::text(&judged, digits)))
    })
}

/// Claim files in the one style.
#[pyfunction]
pub fn format_claims(py: Python<'_>, text: &str) -> Result<String, Refusal> {
    detached_deep(py, || carom::claim::format::format(text).map_err(|faults| shown(&faults, text)))
}

/// A written number beside the certified one: whether it is right, what is said of it, the certified number.
#[pyfunction]
pub fn judged(
    py: Python<'_>,
    written: &str,
    quantity: &str,
    ratio: &str,
    e: Option<String>,
    n: Option<u64>,
    direction: &str,
) -> Result<(bool, String, String), Refusal> {
    detached(py, || {
        let wanted = Quantity::ALL.into_iter().find(|known| known.name() == quantity);
        let quantity = wanted
            .ok_or_else(|| Refusal::Input(format!("no column is called {quantity:?}: eta, threshold or best-n")))?;
        let e = e.map(|e| Ok::<_, Refusal>(Restitution::new(rational("e", &e)?)?)).transpose()?;
        let place = Place { ratio: Positive::new(rational("ratio", ratio)?)?, e, n };
        let found = judge(written, quantity, &place, rounding(direction)?)?;
        Ok((found.agreement == Agreement::Right, found.text(), found.certified))
    })
}

fn shown(faults: &[Diagnostic], text: &str) -> Refusal {
    Refusal::Input(faults.iter().map(|f| f.render("text", text, false)).collect::<Vec<_>>().join("\n"))
}

fn claims(text: &str) -> Result<Vec<Claim>, Refusal> {
    parse(text).map_err(|faults| shown(&faults, text))
}

/// The statements of claims for Coq, or as a script for SMT solvers.
#[pyfunction]
pub fn export(py: Python<'_>, text: &str, language: &str) -> Result<String, Refusal> {
    detached_deep(py, || {
        let refused = |claim: &Claim, why: &str| {
            Refusal::Input(format!("{} cannot be exported to {language}: {why}", claim.name.text))
        };
        let all = claims(text)?;
        match language {
            "coq" => {
                let one = |claim| coq::statement(claim).map_err(|e| refused(claim, &e.reason.to_string()));
                Ok(coq::definitions(&all.iter().map(one).collect::<Result<Vec<_>, _>>()?))
            }
            "smt2" => {
                let one = |claim| smt2::script(claim).map_err(|e| refused(claim, &e.reason.to_string()));
                Ok(all.iter().map(one).collect::<Result<Vec<_>, _>>()?.join("\n(reset)\n"))
            }
            other => Err(Refusal::Input(format!("language: {other:?} is unknown; write coq or smt2"))),
        }
    })
}

/// Has the kernel check a certificate: the statement that it accepted.
#[pyfunction]
pub fn check(py: Python<'_>, text: &str, certificate: &str) -> Result<String, Refusal> {
    detached_deep(py, || Ok(carom::check(text, certificate)?.text().to_string()))
}

/// A point of a law: names with values, and whether the goal holds there, where that is decided.
type Drawn = (Vec<(String, String)>, Option<bool>);

/// A point of a law where all its hypotheses hold, made from random numbers; `None` where they give none.
#[pyfunction]
pub fn law_point(py: Python<'_>, text: &str, random: Vec<u64>) -> Result<Option<Drawn>, Refusal> {
    detached_deep(py, || {
        let mut found = claims(text)?;
        let claim = found
            .pop()
            .filter(|_| found.is_empty())
            .ok_or_else(|| Refusal::Input("a law is one claim; give one".to_owned()))?;
        let mut trial = Trial::new(&claim).map_err(|why| match why {
            Untried::Fault(fault) => {
                Refusal::Input(carom::judge::diagnostic(&claim, fault).render("text", text, false))
            }
            Untried::Limit(name) => Refusal::Limit(format!("limit reached: {name}")),
            Untried::Moves => Refusal::Input("a point says nothing of a derivative or limit that is tied".to_owned()),
        })?;
        let mut random = random.into_iter();
        let mut below = |bound: u64| random.next().unwrap_or(0) % bound.max(1);
        let Some(choice) = trial.once(&mut below) else { return Ok(None) };
        let Some((seen, point)) = trial.at(&choice) else { return Ok(None) };
        let holds = match seen {
            Seen::Holds => Some(true),
            Seen::Fails(_) => Some(false),
            Seen::Open => None,
        };
        Ok(Some((trial.named(&point).values, holds)))
    })
}
