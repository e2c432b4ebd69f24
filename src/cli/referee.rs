//! `carom referee`: somebody's simulator beside exact collisions.

use super::form::form;
use super::{Exit, ValueFormat, deliver, load};
use crate::claim::diagnostic::nearest;
use crate::number::rational::{NumeralError, parse};
use crate::referee::judge::{Answer, Given, MAX_DIGITS, judge};
use crate::referee::{Reference, Scene, reference, settings};
use crate::report::referee as report;
use crate::table::foreign::{Foreign, ForeignError, completed};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// The most bytes of a file of results.
const MAX_BYTES: usize = 64 << 20;

/// The arguments.
#[derive(clap::Args)]
pub struct Flags {
    /// The results as CSV, - for standard input: columns `scene` and `velocities`; and, where your simulator knows them,
    /// `positions`, `collisions` (1-2 2-3 …, 0 is the left wall), `times` and `count`. Numbers in a field stand apart by
    /// spaces
    #[arg(required_unless_present_any = ["scenes", "answers"])]
    results: Option<PathBuf>,
    /// Write the scenes as JSON: masses, positions, velocities and restitutions, with what is right at the end
    #[arg(long, conflicts_with_all = ["results", "answers", "format"])]
    scenes: bool,
    /// Write the right answers as the CSV that the referee reads
    #[arg(long, conflicts_with_all = ["results", "format"])]
    answers: bool,
    /// Only these scenes, or all of these groups
    #[arg(long, value_name = "NAME", num_args = 1.., value_delimiter = ',')]
    only: Vec<String>,
    /// A number is right if it differs by less than so many digits of the scene's largest
    #[arg(long, value_name = "D", default_value_t = 9, value_parser = clap::value_parser!(u64).range(1..=MAX_DIGITS))]
    digits: u64,
    /// The form of the judgement [default: by the ending of --output (.json), else text]
    #[arg(long, value_enum)]
    format: Option<ValueFormat>,
    /// Write to a file, - for standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// Runs the command: 0 where every scene is right, 1 where one is wrong or missing.
pub fn run(flags: &Flags) -> Result<u8, Exit> {
    // A fault of the program's own file, which the tests exclude.
    let broken = |fault: String| Exit { code: 101, message: format!("{fault}; please report this") };
    let all = settings().map_err(broken)?;
    let chosen: Vec<Scene> = chosen(&all, &flags.only)?.into_iter().cloned().collect();
    let references = chosen.into_iter().map(reference).collect::<Result<Vec<Reference>, _>>().map_err(broken)?;
    let listed: Vec<&Reference> = references.iter().collect();
    let output = flags.output.as_deref();
    let path = match &flags.results {
        Some(path) => path,
        None => {
            let text = if flags.scenes { report::scenes(&listed) } else { report::answers(&listed) };
            return deliver(output, &text).map(|()| 0);
        }
    };
    let results = read(path, &all)?;
    let judge = |reference| (reference, judge(reference, results.get(&reference.scene.name), flags.digits));
    let judged: Vec<_> = references.iter().map(judge).collect();
    let text = match form(flags.format, output)? {
        ValueFormat::Text => report::text(&judged, flags.digits),
        ValueFormat::Json => report::json(&judged, flags.digits),
    };
    deliver(output, &text)?;
    Ok(u8::from(judged.iter().any(|(_, findings)| !findings.is_empty())))
}

fn chosen<'a>(all: &'a [Scene], only: &[String]) -> Result<Vec<&'a Scene>, Exit> {
    let fits = |scene: &Scene, name: &String| scene.name == *name || scene.group == *name;
    for name in only {
        if !all.iter().any(|scene| fits(scene, name)) {
            let known = all.iter().flat_map(|scene| [scene.name.as_str(), scene.group.as_str()]);
            return Err(Exit::usage(format!("error: --only: {}", unknown(name, known))));
        }
    }
    Ok(all.iter().filter(|scene| only.is_empty() || only.iter().any(|name| fits(scene, name))).collect())
}

fn unknown<'a>(name: &str, known: impl Iterator<Item = &'a str>) -> String {
    match nearest(name, known) {
        Some(near) => format!("no scene is called {name}; did you mean {near}?"),
        None => format!("no scene is called {name}; `carom referee --scenes` writes all of them"),
    }
}

/// A field with its column's name.
struct Field<'a> {
    path: &'a Path,
    line: u64,
    column: usize,
    name: &'a str,
    text: &'a str,
}

impl Field<'_> {
    /// A fault of this field, with its line and column.
    fn fault(&self, what: Exit) -> Exit {
        let Field { path, line, column, name, .. } = self;
        let message = format!("error: {}:{line}: column {} ({name}): {}", path.display(), column + 1, what.message);
        Exit { message, ..what }
    }

    fn wrong(&self, what: &str) -> Exit {
        self.fault(Exit::usage(what))
    }

    /// The parts of the field, each read.
    fn list<T>(&self, read: impl Fn(&str) -> Result<T, Exit>) -> Result<Vec<T>, Exit> {
        self.text.split_whitespace().map(|part| read(part).map_err(|e| self.fault(e))).collect()
    }

    fn numbers(&self, needed: Option<usize>) -> Result<Vec<Given>, Exit> {
        let list = self.list(number)?;
        match needed.filter(|needed| !list.is_empty() && list.len() != *needed) {
            Some(needed) => Err(self.wrong(&format!("{} numbers where the scene has {needed} bodies", list.len()))),
            None => Ok(list),
        }
    }
}

fn number(text: &str) -> Result<Given, Exit> {
    use NumeralError::{ExponentTooLarge, TooManyDigits};
    let bare = text.trim_start_matches(['-', '+']).to_ascii_lowercase();
    if ["nan", "inf", "infinity"].contains(&bare.as_str()) {
        return Ok(Given::Strange(text.to_owned()));
    }
    parse(&completed(text)).map(Given::Number).map_err(|e| Exit {
        code: if matches!(e, TooManyDigits { .. } | ExponentTooLarge { .. }) { 3 } else { 2 },
        message: format!("{text:?}: {e}"),
    })
}

/// A pair `1-2` of neighbours, by its left point.
fn pair(text: &str, bodies: usize) -> Result<usize, Exit> {
    let place = |part: &str| part.parse::<usize>().ok();
    let pair = text.split_once(['-', '–']).and_then(|(a, b)| place(a).zip(place(b)));
    let Some((a, b)) = pair else {
        return Err(Exit::usage(format!("{text:?} is no pair; write for instance 1-2")));
    };
    if a.abs_diff(b) != 1 || a.max(b) > bodies + 1 {
        return Err(Exit::usage(format!(
            "{text:?}: neighbours collide: 0-1 at the left wall to {bodies}-{} at the right",
            bodies + 1
        )));
    }
    Ok(a.min(b))
}

/// The results of each scene.
fn read(path: &Path, scenes: &[Scene]) -> Result<BTreeMap<String, Answer>, Exit> {
    let shown = path.display();
    let bytes = load::bounded(path, MAX_BYTES).map_err(|e| load::cannot_read(path, &e))?;
    if bytes.len() > MAX_BYTES {
        return Err(Exit { code: 3, message: format!("error: {shown}: limit reached: {MAX_BYTES} bytes in a file") });
    }
    let fault = |e: ForeignError| {
        let code = if e.is_limit() { 3 } else { 2 };
        let said = match &e {
            ForeignError::Empty => "the file has no heading; write for instance: scene,velocities".to_owned(),
            other => other.to_string(),
        };
        Exit { code, message: format!("error: {shown}: {said}") }
    };
    let mut table = Foreign::open(bytes.as_slice()).map_err(fault)?;
    let column = |wanted: &str| table.names.iter().position(|name| name.eq_ignore_ascii_case(wanted));
    let (Some(name), Some(velocities)) = (column("scene"), column("velocities")) else {
        let names = table.names.join(", ");
        return Err(Exit::usage(format!(
            "error: {shown}: the columns scene and velocities are needed; there are {names}"
        )));
    };
    let further = ["positions", "collisions", "times", "count"].map(column);
    let names = table.names.clone();
    let mut found = BTreeMap::new();
    while let Some(row) = table.row().map_err(fault)? {
        let field = |place: usize| Field {
            path,
            line: row.line,
            column: place,
            name: &names[place],
            text: row.fields.get(place).map_or("", String::as_str),
        };
        let head = field(name);
        let scene = scenes.iter().find(|scene| scene.name == head.text);
        let known = || scenes.iter().map(|scene| scene.name.as_str());
        let scene = scene.ok_or_else(|| head.wrong(&unknown(head.text, known())))?;
        let answer = answer(&field, velocities, further, scene.bodies.len())?;
        if found.insert(scene.name.clone(), answer).is_some() {
            return Err(head.wrong(&format!("{} has a result already", scene.name)));
        }
    }
    Ok(found)
}

fn answer<'a>(
    field: &dyn Fn(usize) -> Field<'a>,
    velocities: usize,
    [positions, collisions, times, count]: [Option<usize>; 4],
    bodies: usize,
) -> Result<Answer, Exit> {
    let numbers = |place: Option<usize>, needed| place.map_or(Ok(Vec::new()), |place| field(place).numbers(needed));
    let pairs = collisions.map(field).map(|field| field.list(|text| pair(text, bodies))).transpose()?;
    let count = count
        .map(field)
        .filter(|field| !field.text.is_empty())
        .map(|field| field.text.parse().map_err(|_| field.wrong(&format!("{:?} is no whole number", field.text))));
    Ok(Answer {
        velocities: field(velocities).numbers(Some(bodies))?,
        positions: numbers(positions, Some(bodies))?,
        pairs,
        times: numbers(times, None)?,
        count: count.transpose()?,
    })
}
