//! The rows of a table, computed on all cores and written in their order.
//!
//! The first rows are computed alone: a short table is done before a thread has started. Then each core takes the next
//! piece, of about [`PIECE`] of work, and this thread writes the pieces in order. What is written does not depend on the
//! number of cores, also where the work is interrupted or a row cannot be computed.

use super::interrupt::Interrupt;
use super::progress::Progress;
use super::table::certificate_head;
use crate::chain::best::Best;
use crate::number::interval::Interval;
use crate::report::table::{Entry, Writer, entries};
use crate::table::shared::Factors;
use crate::table::{Found, Plan, Row, TableError, Value};
use malachite::Integer;
use serde_json::json;
use std::io::{self, Write};
use std::ops::Range;
use std::sync::mpsc::{Sender, channel};
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// So long one core works alone, and about so long on each piece: much longer than it takes to hand one on.
const PIECE: Duration = Duration::from_millis(4);

/// The most rows of a piece, and pieces for each core that wait to be written: this bounds the memory.
const PIECE_ROWS: u64 = 1 << 13;
const WAITING: u64 = 4;

/// How the work ended.
pub(super) enum End {
    Complete,
    /// After so many rows.
    Interrupted(u64),
}

/// Why the work stopped.
pub(super) enum Stop {
    Write(io::Error),
    Table(TableError),
}

impl From<io::Error> for Stop {
    fn from(error: io::Error) -> Stop {
        Stop::Write(error)
    }
}

impl From<TableError> for Stop {
    fn from(error: TableError) -> Stop {
        Stop::Table(error)
    }
}

/// Where the rows go.
struct Out<'a> {
    writer: Writer,
    table: &'a mut dyn Write,
    certificate: Option<&'a mut dyn Write>,
}

impl Out<'_> {
    fn row(&mut self, (row, proof): (Vec<Entry>, Option<String>)) -> io::Result<()> {
        if let (Some(certificate), Some(proof)) = (&mut self.certificate, proof) {
            certificate.write_all(proof.as_bytes())?;
        }
        self.writer.row(row, self.table)
    }

    /// The rows of a piece.
    fn piece(&mut self, piece: Piece, written: u64) -> io::Result<()> {
        if let Some(certificate) = &mut self.certificate {
            certificate.write_all(piece.proofs.as_bytes())?;
        }
        self.table.write_all(&piece.text)?;
        if !piece.text.is_empty() {
            self.writer.resume(written);
        }
        piece.held.into_iter().try_for_each(|row| self.writer.row(row, self.table))
    }
}

/// Computes and writes a table's rows from one of them on.
pub(super) fn write<'a>(
    plan: &Plan,
    writer: Writer,
    from: u64,
    table: &'a mut dyn Write,
    certificate: Option<&'a mut dyn Write>,
) -> Result<End, Stop> {
    let rows = plan.rows();
    let mut out = Out { writer, table, certificate };
    if from == 0 {
        out.writer.begin(out.table)?;
        if let Some(certificate) = &mut out.certificate {
            certificate.write_all(certificate_head(plan).as_bytes())?;
        }
    }
    out.writer.resume(from);
    let interrupt = Interrupt::listen();
    let progress = Progress::rows(from, rows);
    let mut maker = Maker { plan, factors: Factors::new(plan), proofs: out.certificate.is_some() };
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let begun = Instant::now();
    for row in from..rows {
        if cores > 1 && begun.elapsed() > PIECE {
            let size = ((row - from) / 2).max(1);
            let desk = Desk::new(plan, row, size, out.certificate.is_some(), cores as u64);
            if let Some(end) = desk.run(&mut out, &progress, interrupt)? {
                return Ok(end);
            }
            break;
        }
        if interrupt.asked() {
            return Ok(End::Interrupted(row));
        }
        progress.now(row, "");
        out.row(maker.row(row)?)?;
    }
    out.writer.end(out.table)?;
    out.table.flush()?;
    Ok(End::Complete)
}

/// Computes rows.
struct Maker<'a> {
    plan: &'a Plan,
    factors: Factors<'a>,
    proofs: bool,
}

impl Maker<'_> {
    /// A row's entries and its line in the certificate.
    fn row(&mut self, row: u64) -> Result<(Vec<Entry>, Option<String>), TableError> {
        let found = self.factors.value(row)?;
        let best = match &found {
            Found::Open(Value::Count(best)) => Some(best.clone()),
            _ => None,
        };
        let (line, enclosure) = self.plan.labelled(row, self.factors.labels(row), found)?;
        let proof = self.proofs.then(|| proof(self.plan, row, &line, best.as_ref(), enclosure.as_ref()) + "\n");
        Ok((entries(self.plan, line), proof))
    }
}

/// A piece of the table, or what there is of it.
struct Piece {
    /// Its number.
    number: u64,
    /// Its rows as they are written, or, where no writer was settled, to be written.
    text: Vec<u8>,
    held: Vec<Vec<Entry>>,
    proofs: String,
    /// How many rows.
    rows: u64,
    /// Why it is not whole.
    cut: Option<Cut>,
}

enum Cut {
    Interrupted,
    Failed(TableError),
}

/// The next piece of work.
struct Next {
    row: u64,
    number: u64,
    /// The rows of the next piece.
    size: u64,
    /// How many pieces are written.
    written: u64,
    stop: bool,
    writer: Option<Writer>,
}

/// Hands the pieces of a table out.
struct Desk<'a> {
    plan: &'a Plan,
    /// The row at which the next piece begins, and that after the last.
    rows: Range<u64>,
    proofs: bool,
    cores: u64,
    next: Mutex<Next>,
    free: Condvar,
}

impl<'a> Desk<'a> {
    fn new(plan: &'a Plan, row: u64, size: u64, proofs: bool, cores: u64) -> Desk<'a> {
        let size = size.min(PIECE_ROWS);
        let next = Next { row, number: 0, size, written: 0, stop: false, writer: None };
        Desk { plan, rows: row..plan.rows(), proofs, cores, next: Mutex::new(next), free: Condvar::new() }
    }

    fn next(&self) -> MutexGuard<'_, Next> {
        self.next.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Has all pieces computed and writes them; `None` when all are written.
    fn run(&self, out: &mut Out<'_>, progress: &Progress, interrupt: Interrupt) -> Result<Option<End>, Stop> {
        self.next().writer = out.writer.settled();
        std::thread::scope(|scope| {
            let (sender, pieces) = channel();
            let started = (0..self.cores)
                .filter_map(|_| {
                    let sender = sender.clone();
                    std::thread::Builder::new().spawn_scoped(scope, move || self.work(&sender, interrupt)).ok()
                })
                .count();
            if started == 0 {
                // The system gives no thread.
                return self.alone(out, progress, interrupt);
            }
            drop(sender);
            let mut waiting = std::collections::BTreeMap::new();
            let mut written = self.rows.start;
            let ended = pieces.into_iter().find_map(|piece: Piece| {
                waiting.insert(piece.number, piece);
                while let Some(piece) = waiting.first_entry().filter(|entry| *entry.key() == self.next().written) {
                    if let Some(end) = self.put(piece.remove(), &mut written, out, progress) {
                        return Some(end);
                    }
                }
                None
            });
            self.next().stop = true;
            self.free.notify_all();
            ended.unwrap_or(Ok(None))
        })
    }

    /// Writes a piece. If the work ends here, returns how it ended.
    fn put(
        &self,
        mut piece: Piece,
        written: &mut u64,
        out: &mut Out<'_>,
        progress: &Progress,
    ) -> Option<Result<Option<End>, Stop>> {
        *written += piece.rows;
        let cut = piece.cut.take();
        if let Err(error) = out.piece(piece, *written) {
            return Some(Err(error.into()));
        }
        progress.now(*written, "");
        let mut next = self.next();
        next.written += 1;
        if next.writer.is_none() {
            next.writer = out.writer.settled();
        }
        drop(next);
        self.free.notify_all();
        match cut? {
            Cut::Interrupted => Some(Ok(Some(End::Interrupted(*written)))),
            Cut::Failed(error) => Some(Err(error.into())),
        }
    }

    /// All pieces one after the other.
    fn alone(&self, out: &mut Out<'_>, progress: &Progress, interrupt: Interrupt) -> Result<Option<End>, Stop> {
        let mut maker = Maker { plan: self.plan, factors: Factors::new(self.plan), proofs: self.proofs };
        let mut written = self.rows.start;
        while let Some((number, rows, writer)) = self.take() {
            let piece = self.piece(&mut maker, number, rows, writer, interrupt);
            if let Some(end) = self.put(piece, &mut written, out, progress) {
                return end;
            }
        }
        Ok(None)
    }

    /// The next piece, when there is room for it: its number, its rows and who writes them.
    fn take(&self) -> Option<(u64, Range<u64>, Option<Writer>)> {
        let mut next = self.next();
        while !next.stop && next.number >= next.written + self.cores * WAITING {
            next = self.free.wait(next).unwrap_or_else(PoisonError::into_inner);
        }
        if next.stop || next.row >= self.rows.end {
            return None;
        }
        // The last pieces are shorter, so that all cores end at the same time.
        let left = self.rows.end - next.row;
        let rows = next.row..next.row + next.size.min(left.div_ceil(self.cores));
        let number = next.number;
        (next.row, next.number) = (rows.end, number + 1);
        Some((number, rows, next.writer.clone()))
    }

    /// Computes pieces until there is none left.
    fn work(&self, sender: &Sender<Piece>, interrupt: Interrupt) {
        let _leaving = Leaving(self);
        let mut maker = Maker { plan: self.plan, factors: Factors::new(self.plan), proofs: self.proofs };
        while let Some((number, rows, writer)) = self.take() {
            let (begun, count) = (Instant::now(), rows.end - rows.start);
            let piece = self.piece(&mut maker, number, rows, writer, interrupt);
            let whole = piece.cut.is_none();
            // As many rows as take about as long as a piece should; at most twice as many as the last time.
            let fitting = PIECE.as_secs_f64() / begun.elapsed().as_secs_f64().max(1e-9) * count as f64;
            self.next().size = (fitting as u64).clamp(1, PIECE_ROWS.min(2 * count));
            if sender.send(piece).is_err() || !whole {
                return;
            }
        }
    }

    fn piece(
        &self,
        maker: &mut Maker<'_>,
        number: u64,
        rows: Range<u64>,
        writer: Option<Writer>,
        interrupt: Interrupt,
    ) -> Piece {
        let mut piece = Piece { number, text: Vec::new(), held: Vec::new(), proofs: String::new(), rows: 0, cut: None };
        let mut writer = writer.map(|mut writer| {
            writer.resume(rows.start);
            writer
        });
        for row in rows {
            if interrupt.asked() {
                piece.cut = Some(Cut::Interrupted);
                break;
            }
            let (entries, proof) = match maker.row(row) {
                Ok(made) => made,
                Err(error) => {
                    piece.cut = Some(Cut::Failed(error));
                    break;
                }
            };
            piece.proofs.extend(proof);
            match &mut writer {
                // Writing to memory does not fail.
                Some(writer) => {
                    let _ = writer.row(entries, &mut piece.text);
                }
                None => piece.held.push(entries),
            }
            piece.rows += 1;
        }
        piece
    }
}

/// Stops the other threads if one fails, since its piece will never be written.
struct Leaving<'a>(&'a Desk<'a>);

impl Drop for Leaving<'_> {
    fn drop(&mut self) {
        if std::thread::panicking() {
            self.0.next().stop = true;
            self.0.free.notify_all();
        }
    }
}

/// A row with all that is needed to check it: exact inputs, what is printed, and an enclosure, or the exact
/// value, of which every element is printed so.
fn proof(plan: &Plan, row: u64, line: &Row, best: Option<&Best>, enclosure: Option<&Interval>) -> String {
    let place = plan.place(row);
    let end = |end: Option<(Integer, i64)>| {
        end.map(|(mantissa, exponent)| json!({ "mantissa": mantissa.to_string(), "exponent": exponent }))
    };
    let value = json!({
        "row": row,
        "ratio": place.as_ref().map(|p| p.ratio.value().to_string()),
        "e": place.as_ref().and_then(|p| p.e.as_ref()).map(|e| e.value().to_string()),
        "n": place.as_ref().and_then(|p| p.n).map(|n| n.to_string()),
        "printed": line.value,
        "exact": line.exact,
        "lower": enclosure.and_then(|x| end(x.lower())),
        "upper": enclosure.and_then(|x| end(x.upper())),
        "tie": best.map(|b| matches!(b, Best::Finite { tie: true, .. })),
    });
    value.to_string()
}
