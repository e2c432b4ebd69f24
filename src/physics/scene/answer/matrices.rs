//! Answers for the matrix of each collision.

use super::{Answers, Number, Prepared, Value, limit_listed};
use crate::chain::uncertain::{Coefficients, Reals, given};
use crate::chain::{ChainError, Restitutions, collision};
use crate::number::real::{Level, Real};
use crate::scene::Inserted;

impl Answers<'_> {
    pub(super) fn matrices(&self) -> Result<(Value, Level), ChainError> {
        let Some((_, _, restitutions)) = self.exact() else { return self.measured_matrices() };
        let mut dearest = Level::Double;
        let mut matrices = Vec::new();
        let mut push = |entries: [[Real; 2]; 2]| -> Result<(), ChainError> {
            let mut ready = |x: &Real| -> Result<Number, ChainError> {
                let (number, level) = self.number(x)?;
                dearest = dearest.max(level);
                Ok(number)
            };
            let [[a, b], [c, d]] = entries;
            matrices.push([[ready(&a)?, ready(&b)?], [ready(&c)?, ready(&d)?]]);
            Ok(())
        };
        match self.prepared()? {
            Prepared::Optimal(optimum) => {
                if let Restitutions::Each(_) = restitutions {
                    limit_listed(optimum)?;
                }
                // With equal coefficients the same matrix serves every collision.
                let count = match &restitutions {
                    Restitutions::Same(_) => 1,
                    Restitutions::Each(list) => list.len() as u64,
                };
                for i in 0..count {
                    if let Some(matrix) = optimum.matrix(i) {
                        push(matrix)?;
                    }
                }
            }
            Prepared::Given(pass) => {
                for (i, pair) in pass.masses().windows(2).enumerate() {
                    if let ([m1, m2], Some(e)) = (pair, restitutions.at(i as u64)) {
                        push(collision::matrix(m1, m2, e).map(|row| row.map(Real::rational)))?;
                    }
                }
            }
            Prepared::Measured => return self.measured_matrices(),
        }
        Ok((Value::Matrices(matrices), dearest))
    }

    fn measured_matrices(&self) -> Result<(Value, Level), ChainError> {
        let chain = self.chain()?;
        let matrices = match (chain.inserted(), chain.coefficients()) {
            (Inserted::Given(_), coefficients) => given::matrices(&chain.masses().unwrap_or_default(), coefficients)?,
            (Inserted::Optimal(n), coefficients) => {
                let found = self.measured(*n)?;
                // With one coefficient the same matrix serves every collision.
                let count = if let Coefficients::Each(_) = coefficients { *n + 1 } else { 1 };
                (0..count).map(|i| found.matrix(i)).collect::<Result<_, _>>()?
            }
        };
        let mut dearest = Level::Double;
        let mut ready = |x: &Reals| -> Result<Number, ChainError> {
            let (number, level) = self.between(x)?;
            dearest = dearest.max(level);
            Ok(number)
        };
        let list = matrices
            .iter()
            .map(|[[a, b], [c, d]]| Ok([[ready(a)?, ready(b)?], [ready(c)?, ready(d)?]]))
            .collect::<Result<_, ChainError>>()?;
        Ok((Value::Matrices(list), dearest))
    }
}
