//! The library's front door: five functions from text to answers, re-exported at the root of the crate.
//!
//! Contract: each reads what the command of the same name reads, and answers the same. Everything else in the crate is how
//! they work; these functions and [`Error`] are what a program should build on.

use crate::chain::ChainError;
use crate::chain::replay::{LedgerFault, Options, Outcome};
use crate::claim::diagnostic::{Diagnostic, Fault};
use crate::claim::parse::parse;
use crate::claim::syntax::{Claim, Span};
use crate::judge::hand::AtHand;
use crate::judge::{self, Entry, Settings};
use crate::kernel::{Accepted, Verdict};
use crate::refute::catalogue::Catalogue;
use crate::scene::answer::{Answers, Value};
use crate::scene::quantity::Quantity;
use crate::scene::{read, replay as bodies};
use crate::table::{Plan, Row, TableError};
use crate::{certificate, kernel};

/// Why there is no answer.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum Error {
    /// A claim file or a scene cannot be read: what is wrong, where, and what to write instead.
    Unreadable(Vec<Diagnostic>),
    /// The text of a certificate cannot be read.
    Malformed(certificate::text::Malformed),
    /// The kernel rejects a certificate: the step, by label, and the reason.
    Rejected(String, String),
    /// A stated limit was reached, by name.
    Limit(String),
    /// No claim has this name.
    UnknownClaim(String),
    /// A quantity of a chain has no value.
    Chain(Quantity, ChainError),
    /// A row of a table has no value.
    Table(TableError),
    /// A replay broke a law of conservation: a fault of this program.
    Ledger(LedgerFault),
}

impl std::fmt::Display for Error {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Error::Unreadable(list) => {
                write!(f, "{}", list.iter().map(Diagnostic::message).collect::<Vec<_>>().join("; "))
            }
            Error::Malformed(malformed) => write!(f, "line {}: {}", malformed.line, malformed.fault),
            Error::Rejected(step, reason) if step.is_empty() => write!(f, "the certificate is rejected: {reason}"),
            Error::Rejected(step, reason) => write!(f, "the certificate is rejected at step {step}: {reason}"),
            Error::Limit(name) => write!(f, "limit reached: {name}"),
            Error::UnknownClaim(name) => write!(f, "no claim is called {name}"),
            Error::Chain(quantity, error) => write!(f, "{}: {error}", quantity.name()),
            Error::Table(error) => write!(f, "{error}"),
            Error::Ledger(fault) => match fault.collision {
                Some(collision) => write!(f, "{} is not kept in collision {collision}", fault.law),
                None => write!(f, "{} is not kept", fault.law),
            },
        }
    }
}

impl std::error::Error for Error {}

impl From<Vec<Diagnostic>> for Error {
    fn from(list: Vec<Diagnostic>) -> Error {
        if let Some(limit) = list.iter().find(|d| d.is_limit()) {
            return Error::Limit(limit.message());
        }
        Error::Unreadable(list)
    }
}

/// Judges every claim of a claim file, as `carom audit` does: the entries stand in the order of the file.
///
/// ```
/// let entries = carom::audit("claim half \"Half\"\ngiven x > 0\nprove x/(2*x) = 1/2\n").unwrap();
/// assert_eq!(entries[0].outcome.verdict.name(), "proved");
/// // The certificate that the kernel accepted, as text that `carom::check` reads.
/// assert!(entries[0].proof.as_ref().unwrap().certificate.starts_with("carom-certificate 2"));
///
/// let entries = carom::audit("claim more \"More\"\ngiven x > 0\nprove x^2 >= x\n").unwrap();
/// let point = &entries[0].outcome.witness.as_ref().unwrap().point;
/// assert_eq!(point.values.len(), 1);
/// assert!(carom::audit("claim half prove").is_err());
/// ```
///
/// # Errors
/// The text cannot be read, two claims have one name, a cited claim is missing, or hypotheses contradict each other.
pub fn audit(claims: &str) -> Result<Vec<Entry>, Error> {
    let catalogue = Catalogue::new(parse(claims)?)
        .map_err(|faults| Error::from(faults.into_iter().map(|(_, fault)| fault).collect::<Vec<_>>()))?;
    let names: Vec<String> = catalogue.claims().iter().map(|claim| claim.name.text.clone()).collect();
    let found = judge::judge(&catalogue, &names, &AtHand::default(), &Settings::default(), &|_| {});
    let entry = |(name, entry): (String, Result<Entry, _>)| {
        entry.map_err(|fault| match catalogue.get(&name) {
            Some(claim) => Error::from(vec![judge::diagnostic(claim, fault)]),
            None => Error::UnknownClaim(name),
        })
    };
    found.entries.into_iter().map(entry).collect()
}

/// Has the kernel check a certificate against the claim of its name, as `carom check` does. The claim must cite no other.
///
/// The answer says which statement was shown, as the kernel understood it ([`Accepted::text`]).
///
/// ```
/// let text = "claim half \"Half\"\ngiven x > 0\nprove x/(2*x) = 1/2\n";
/// let certificate = carom::audit(text).unwrap()[0].proof.clone().unwrap().certificate;
/// assert!(carom::check(text, &certificate).unwrap().text().contains("(1/2)"));
/// // The same steps show nothing else.
/// assert!(carom::check(&text.replace("1/2\n", "1/3\n"), &certificate).is_err());
/// ```
///
/// # Errors
/// A text cannot be read, no claim has the certificate's name, or the kernel rejects the certificate.
pub fn check(claims: &str, certificate: &str) -> Result<Accepted, Error> {
    let claims = parse(claims)?;
    let certificate = certificate::text::read(certificate).map_err(Error::Malformed)?;
    let of_the_name = |claim: &&Claim| claim.name.text == certificate.claim;
    let claim = claims.iter().find(of_the_name).ok_or_else(|| Error::UnknownClaim(certificate.claim.clone()))?;
    match kernel::check(claim, &certificate, &[]) {
        Verdict::Accepted(shown) => Ok(*shown),
        Verdict::Refuted => Err(Error::Rejected(String::new(), "it shows that the claim is false".to_string())),
        Verdict::Rejected { step, reason, .. } => Err(Error::Rejected(step, reason.to_string())),
        Verdict::Declined { limit } => Err(Error::Limit(limit.to_string())),
    }
}

/// Answers the questions of a scene file about a chain, as `carom eval` does: quantities in the order of `want`, no others.
///
/// ```
/// use carom::scene::answer::Value;
/// let scene = "want = [\"eta\"]\n[chain]\nfirst = 64\nlast = 1\ninserted = 2\nrestitution = \"44/81\"\n";
/// let answers = carom::eval(scene).unwrap();
/// let Value::Number(eta) = &answers[0].1 else { unreachable!() };
/// assert_eq!(eta.exact.as_ref().unwrap().to_string(), "15625000000/282429536481");
/// assert_eq!(eta.decimal.as_deref(), Some("0.0553235337730023"));
/// ```
///
/// # Errors
/// The scene cannot be read, or a quantity has no value.
pub fn eval(scene: &str) -> Result<Vec<(Quantity, Value)>, Error> {
    let scene = read::scene(scene).map_err(|fault| match fault.limit {
        true => Error::Limit(fault.diagnostic.message()),
        false => Error::Unreadable(vec![fault.diagnostic]),
    })?;
    let mut answers = Answers::new(&scene);
    for quantity in &scene.want {
        answers.get(*quantity).map_err(|error| Error::Chain(*quantity, error))?;
    }
    Ok(scene.want.iter().filter_map(|quantity| Some((*quantity, answers.take(*quantity)?))).collect())
}

/// The rows of a table, one at a time, as `carom table` prints them.
///
/// ```
/// use carom::number::decimal::{Digits, Rounding};
/// use carom::table::{Plan, Printing, Quantity, grid::Grid};
/// let printing = Printing { digits: Digits::Places(4), rounding: Rounding::Nearest, extra: 0 };
/// let grid = |text| Grid::parse(text).unwrap();
/// let plan = Plan::new(Quantity::Eta, grid("1,100"), Some(grid("0.9")), Some(grid("1:2:1")), printing).unwrap();
/// let values: Vec<String> = carom::table(&plan).map(|row| row.unwrap().value).collect();
/// assert_eq!(values, ["0.8145", "0.7351", "0.0890", "0.1459"]);
/// ```
///
/// An item is an error where a stated limit was reached.
pub fn table(plan: &Plan) -> impl Iterator<Item = Result<Row, Error>> + '_ {
    let mut factors = crate::table::shared::Factors::new(plan);
    (0..plan.rows()).map(move |row| {
        let found = factors.value(row).map_err(Error::Table)?;
        plan.row(row, found).map(|(row, _)| row).map_err(Error::Table)
    })
}

/// Replays a scene of bodies on a line, collision by collision, as `carom replay` does.
///
/// ```
/// let scene = "restitution = 1\n[[body]]\nmass = 1\nposition = 0\nvelocity = 1\n[[body]]\nmass = 1\nposition = 1\n";
/// let outcome = carom::replay(scene, &Default::default()).unwrap();
/// assert_eq!(outcome.count, 1);
/// assert_eq!(outcome.velocities[1].rational().unwrap().to_string(), "1");
/// ```
///
/// # Errors
/// The scene cannot be read.
pub fn replay(scene: &str, options: &Options) -> Result<Outcome, Error> {
    let scene = bodies::read(scene).map_err(|e| {
        let span = Span { start: e.span.start, end: e.span.end };
        Error::Unreadable(vec![Diagnostic::new(Fault::Other { message: e.message, help: e.help }, span)])
    })?;
    crate::chain::replay::replay(&scene.line, options).map_err(Error::Ledger)
}
