//! Products and determinants of matrices of fractions.

use super::{Draft, Failure, rejected};
use crate::kernel::fraction::Fraction;

impl Draft {
    pub(super) fn matrix_product(
        &mut self,
        a: &[Vec<Fraction>],
        b: &[Vec<Fraction>],
    ) -> Result<Vec<Vec<Fraction>>, Failure> {
        if sizes(a).1 != sizes(b).0 {
            return rejected("a product of matrices whose sizes do not fit");
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
    pub(super) fn determinant(&mut self, rows: &[Vec<Fraction>]) -> Result<Fraction, Failure> {
        let (height, width) = sizes(rows);
        if height != width || height > 5 {
            return rejected("det needs a square matrix with at most 5 rows");
        }
        let Some((first, below)) = rows.split_first() else { return Ok(Fraction::integer(1)) };
        let mut terms = Vec::new();
        for (j, entry) in first.iter().enumerate() {
            let minor: Vec<Vec<Fraction>> = below
                .iter()
                .map(|row| row.iter().enumerate().filter(|(k, _)| *k != j).map(|(_, f)| f.clone()).collect())
                .collect();
            let term = entry.times(&self.determinant(&minor)?, &self.work)?;
            terms.push(if j % 2 == 0 { term } else { term.negated() });
        }
        Ok(Fraction::sum(&terms, &self.work)?)
    }
}

/// How many rows and columns a matrix has.
pub(super) fn sizes(rows: &[Vec<Fraction>]) -> (usize, usize) {
    (rows.len(), rows.first().map_or(0, Vec::len))
}

/// The matrix with each entry changed.
pub(super) fn each(
    rows: &[Vec<Fraction>],
    change: &mut dyn FnMut(&Fraction) -> Result<Fraction, Failure>,
) -> Result<Vec<Vec<Fraction>>, Failure> {
    rows.iter().map(|row| row.iter().map(&mut *change).collect()).collect()
}
