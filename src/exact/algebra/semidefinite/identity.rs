//! An identity target = Σ multiplier·(sum of squares) as linear equations for the entries of Gram matrices.

use super::super::{Monomial, Polynomial};
use super::ideal::Span;
use super::interior_point::{Condition, Entry};
use super::matrix::Matrix;
use crate::number::double::nearest;
use malachite::Rational;
use malachite::base::num::basic::traits::{One, Zero};
use std::collections::{BTreeMap, BTreeSet};

/// The most monomials of an identity.
const ROWS: usize = 450;

/// The most entries of all Gram matrices.
const PLACES: usize = 2_600;

/// The most terms of all products.
const TERMS: usize = 40_000;

/// The most operations of exact elimination.
const WORK: usize = 60_000;

/// A multiplier, and the polynomials whose squares and products it multiplies.
#[derive(Clone, Debug)]
pub(super) struct Block {
    /// Its place in the program.
    pub origin: usize,
    pub multiplier: Polynomial,
    pub roots: Vec<Polynomial>,
}

/// An entry of a Gram matrix: block, row, column, where the row is at most the column.
type Place = (usize, usize, usize);

/// A row: coefficients by column, and the right side.
#[derive(Clone, Debug)]
struct Row {
    entries: BTreeMap<usize, Rational>,
    value: Rational,
}

/// The equations, solved for some of the entries.
pub(super) struct Identity {
    pub blocks: Vec<Block>,
    places: Vec<Place>,
    /// Independent equations, each with the entry that it is solved for. An entry occurs in no equation before its own.
    rows: Vec<(Row, usize)>,
}

impl Identity {
    /// The equations for these blocks, less the squares that must be 0; `None` where there is no solution or a limit is reached.
    pub(super) fn new(target: &Polynomial, blocks: &[Block], span: &Span) -> Option<Self> {
        let (places, mut rows) = equations(&span.reduced(target), blocks, span)?;
        let mut zero: BTreeSet<(usize, usize)> = BTreeSet::new();
        let stays =
            |zero: &BTreeSet<(usize, usize)>, (i, a, b): &Place| !zero.contains(&(*i, *a)) && !zero.contains(&(*i, *b));
        loop {
            let more = squares_that_vanish(&places, &rows)?;
            if more.is_empty() {
                break;
            }
            zero.extend(more);
            rows.iter_mut().for_each(|row| row.entries.retain(|c, _| stays(&zero, &places[*c])));
        }
        // What stays moves up.
        let up = |i: usize, a: usize| a - zero.range((i, 0)..(i, a)).count();
        let left: Vec<usize> = (0..places.len()).filter(|c| stays(&zero, &places[*c])).collect();
        let moved: BTreeMap<usize, usize> = left.iter().enumerate().map(|(new, old)| (*old, new)).collect();
        for row in &mut rows {
            let entries = std::mem::take(&mut row.entries).into_iter();
            row.entries = entries.filter_map(|(c, q)| Some((*moved.get(&c)?, q))).collect();
        }
        let mut blocks = blocks.to_vec();
        for (i, block) in blocks.iter_mut().enumerate() {
            let roots = std::mem::take(&mut block.roots).into_iter().enumerate();
            block.roots = roots.filter(|(a, _)| !zero.contains(&(i, *a))).map(|r| r.1).collect();
        }
        let places = left.iter().map(|c| places[*c]).map(|(i, a, b)| (i, up(i, a), up(i, b))).collect();
        Some(Self { blocks, places, rows: solved(rows)? })
    }

    pub(super) fn sizes(&self) -> Vec<usize> {
        self.blocks.iter().map(|b| b.roots.len()).collect()
    }

    /// The equations in doubles.
    pub(super) fn conditions(&self) -> Vec<Condition> {
        let entry = |(column, c): (&usize, &Rational)| {
            let (block, row, column) = self.places[*column];
            // The entry off the diagonal stands for itself and its mirror image.
            let value = if row == column { nearest(c) } else { nearest(c) / 2.0 };
            Entry { block, row, column, value }
        };
        let of = |(row, _): &(Row, usize)| Condition {
            entries: row.entries.iter().map(entry).collect(),
            value: nearest(&row.value),
        };
        self.rows.iter().map(of).collect()
    }

    /// Rational matrices near these that satisfy the equations: entries are rounded to multiples of 1/denominator, but for those
    /// that the equations give.
    pub(super) fn rounded(&self, grams: &[Matrix], denominator: i64) -> Option<Vec<Vec<Vec<Rational>>>> {
        let mut values: Vec<Rational> = Vec::with_capacity(self.places.len());
        for (block, row, column) in &self.places {
            #[allow(clippy::cast_precision_loss)] // denominators are small, or powers of two
            let scaled = (grams[*block].at(*row, *column) * denominator as f64).round();
            if scaled.is_nan() || scaled.abs() > 9e18 {
                return None;
            }
            #[allow(clippy::cast_possible_truncation)] // below 2^63
            values.push(Rational::from_signeds(scaled as i64, denominator));
        }
        for (row, own) in self.rows.iter().rev() {
            let mut left = row.value.clone();
            let mut coefficient = Rational::ONE;
            for (column, c) in &row.entries {
                if column == own { coefficient.clone_from(c) } else { left -= c * &values[*column] }
            }
            values[*own] = left / coefficient;
        }
        let mut out: Vec<Vec<Vec<Rational>>> =
            self.sizes().iter().map(|n| vec![vec![Rational::ZERO; *n]; *n]).collect();
        for ((block, row, column), value) in self.places.iter().zip(values) {
            out[*block][*column][*row].clone_from(&value);
            out[*block][*row][*column] = value;
        }
        Some(out)
    }
}

/// One equation for each monomial that occurs.
fn equations(target: &Polynomial, blocks: &[Block], span: &Span) -> Option<(Vec<Place>, Vec<Row>)> {
    let mut places = Vec::new();
    let mut rows: BTreeMap<Monomial, Row> = BTreeMap::new();
    for (m, c) in target.terms() {
        rows.insert(m.clone(), Row { entries: BTreeMap::new(), value: c.clone() });
    }
    let mut terms = 0;
    for (i, block) in blocks.iter().enumerate() {
        for (a, first) in block.roots.iter().enumerate() {
            let first = block.multiplier.try_mul(first).ok()?;
            for (b, second) in block.roots.iter().enumerate().skip(a) {
                let product = span.reduced(&first.try_mul(second).ok()?);
                terms += product.term_count();
                if terms > TERMS || places.len() >= PLACES {
                    return None;
                }
                for (m, c) in product.terms() {
                    let none = || Row { entries: BTreeMap::new(), value: Rational::ZERO };
                    let c = if a == b { c.clone() } else { c * Rational::from(2) };
                    rows.entry(m.clone()).or_insert_with(none).entries.insert(places.len(), c);
                }
                places.push((i, a, b));
            }
        }
    }
    (rows.len() <= ROWS).then(|| (places, rows.into_values().collect()))
}

/// The squares, by block and place, that an equation makes 0: it says that a sum of them with weights of one sign is 0. `None` where
/// an equation says that such a sum has the other sign.
fn squares_that_vanish(places: &[Place], rows: &[Row]) -> Option<BTreeSet<(usize, usize)>> {
    let mut out = BTreeSet::new();
    for row in rows {
        let square = |column: &usize| places.get(*column).filter(|p| p.1 == p.2);
        if !row.entries.keys().all(|c| square(c).is_some()) {
            continue;
        }
        let (up, down) = (row.entries.values().any(|c| *c > 0), row.entries.values().any(|c| *c < 0));
        let possible = (up && down) || row.value == 0 || (up && row.value > 0) || (down && row.value < 0);
        if !possible {
            return None;
        }
        if row.value == 0 && up != down {
            out.extend(row.entries.keys().filter_map(square).map(|p| (p.0, p.1)));
        }
    }
    Some(out)
}

/// Independent equations, each solved for an entry of its own; `None` where they contradict each other, or the work is too much.
fn solved(rows: Vec<Row>) -> Option<Vec<(Row, usize)>> {
    let mut uses: BTreeMap<usize, usize> = BTreeMap::new();
    rows.iter().flat_map(|r| r.entries.keys()).for_each(|c| *uses.entry(*c).or_default() += 1);
    // An entry that occurs once costs no elimination.
    let (mut out, mut rest) = (Vec::new(), Vec::new());
    for row in rows {
        match row.entries.keys().rev().find(|c| uses.get(c) == Some(&1)) {
            Some(own) => {
                let own = *own;
                out.push((row, own));
            }
            None => rest.push(row),
        }
    }
    let mut work = WORK;
    let mut last: Vec<(Row, usize)> = Vec::new();
    // Short rows first: they fill the others least.
    rest.sort_by_key(|r| r.entries.len());
    while !rest.is_empty() {
        let row = rest.remove(0);
        let Some(own) = row.entries.keys().min_by_key(|c| rest.iter().filter(|r| r.entries.contains_key(c)).count())
        else {
            if row.value != 0 {
                return None;
            }
            continue;
        };
        let own = *own;
        let pivot = row.entries.get(&own)?.clone();
        for other in &mut rest {
            let Some(c) = other.entries.get(&own) else { continue };
            let factor = c / &pivot;
            work = work.checked_sub(row.entries.len())?;
            for (column, c) in &row.entries {
                let entry = other.entries.entry(*column).or_default();
                *entry -= &factor * c;
                if *entry == 0 {
                    other.entries.remove(column);
                }
            }
            other.value -= &factor * &row.value;
        }
        last.push((row, own));
    }
    // The entry of each of these rows occurs in rows before it only.
    out.extend(last);
    Some(out)
}
