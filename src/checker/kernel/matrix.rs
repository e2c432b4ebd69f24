//! Matrices of fractions.

use super::fraction::Fraction;
use super::{Checker, Reason, Refusal, rejected};

impl Checker {
    pub(super) fn matrix_product(
        &mut self,
        a: &[Vec<Fraction>],
        b: &[Vec<Fraction>],
    ) -> Result<Vec<Vec<Fraction>>, Refusal> {
        if sizes(a).1 != sizes(b).0 {
            return rejected(Reason::MatrixSizes);
        }
        let mut out = Vec::new();
        for row in a {
            let mut entries = Vec::new();
            for j in 0..sizes(b).1 {
                let pairs = row.iter().zip(b).filter_map(|(x, other)| other.get(j).map(|y| (x, y)));
                let terms = pairs.map(|(x, y)| x.times(y, &self.work)).collect::<Result<Vec<_>, _>>()?;
                entries.push(Fraction::sum(&terms, &self.work)?);
            }
            out.push(entries);
        }
        Ok(out)
    }

    /// det by the first row; only small matrices are written in claims.
    pub(super) fn determinant(&mut self, rows: &[Vec<Fraction>]) -> Result<Fraction, Refusal> {
        let (height, width) = sizes(rows);
        if height != width || height > 5 {
            return rejected(Reason::MatrixSizes);
        }
        let Some((first, below)) = rows.split_first() else { return Ok(Fraction::integer(1)) };
        let mut terms = Vec::new();
        for (j, entry) in first.iter().enumerate() {
            let without = |row: &Vec<Fraction>| {
                row.iter().enumerate().filter(|(k, _)| *k != j).map(|(_, f)| f.clone()).collect::<Vec<_>>()
            };
            let minor: Vec<Vec<Fraction>> = below.iter().map(without).collect();
            let term = entry.times(&self.determinant(&minor)?, &self.work)?;
            terms.push(if j % 2 == 0 { term } else { term.negated() });
        }
        Fraction::sum(&terms, &self.work)
    }
}

pub(super) fn sizes(rows: &[Vec<Fraction>]) -> (usize, usize) {
    (rows.len(), rows.first().map_or(0, Vec::len))
}

pub(super) fn each(
    rows: &[Vec<Fraction>],
    change: &mut dyn FnMut(&Fraction) -> Result<Fraction, Refusal>,
) -> Result<Vec<Vec<Fraction>>, Refusal> {
    rows.iter().map(|row| row.iter().map(&mut *change).collect()).collect()
}
