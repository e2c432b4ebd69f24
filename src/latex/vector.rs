//! Names that are marked as vectors, `\vec{v}` and `\mathbf{v}`, which are read as numbers, one component for all.
//!
//! Contract: an equation with such names is read where each component says the same: sums, multiples by numbers, `=`. Products,
//! powers, quotients, functions, other comparisons, `or`, `not` and `exists` are refused. The length of one name, |v|, is a
//! number of its own: it is read where no vector stands outside of such bars, in the formula or in what is supposed. A name that
//! a comment gives, `%carom name \vec{v} as v`, is a number and no vector.

use super::expression::{Read, Reader};
use super::name::{Names, Symbol};
use super::piece::Piece;
use super::refusal::refused;
use carom_diagnostic::{Diagnostic, Span};

/// Marks of names that are vectors.
const VECTORS: &[&str] = &["\\vec{", "\\mathbf{", "\\boldsymbol{", "\\bm{"];

/// Where vectors were read.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Vectors {
    /// Outside of bars.
    pub bare: Option<Span>,
    /// As a length.
    pub lengths: Option<Span>,
    /// Beside numbers.
    pub mixed: Option<Span>,
}

impl Vectors {
    /// With what was read elsewhere.
    pub(crate) fn with(self, other: Vectors) -> Vectors {
        Vectors { bare: self.bare.or(other.bare), lengths: self.lengths.or(other.lengths), mixed: None }
    }

    /// Whether what is supposed makes no number of a vector, which others would read as one.
    ///
    /// # Errors
    /// A vector beside a number, unless comments name vectors as numbers.
    pub(crate) fn supposed(self, names: &Names) -> Result<(), Diagnostic> {
        let is_named = names.renamed.iter().any(|key| VECTORS.iter().any(|mark| key.contains(mark)));
        match self.mixed.filter(|_| !is_named) {
            Some(span) => Err(no_vector("a vector beside a number in what is supposed", span)),
            None => Ok(()),
        }
    }

    /// Whether each component says the same.
    ///
    /// # Errors
    /// Lengths beside vectors, or words of logic.
    pub(crate) fn allowed(self, supposed: Vectors, has_choice: bool) -> Result<(), Diagnostic> {
        let all = self.with(supposed);
        match (self.bare, all.bare, all.lengths, self.lengths.or(self.bare)) {
            (_, Some(_), Some(_), Some(span)) => Err(no_vector("the length of a vector beside vectors", span)),
            (Some(span), ..) if has_choice => Err(no_vector("`or`, `not` or `exists` with vectors", span)),
            _ => Ok(()),
        }
    }
}

/// What is not the same in each component.
pub(crate) fn no_vector(what: &str, span: Span) -> Diagnostic {
    let help = "write components or lengths, as in v w \\cos \\theta; for a motion along a line \
                `%carom name \\vec{v} as v` makes each such name a number";
    refused(format!("{what} is not read"), help, span)
}

/// Whether a name has the mark of a vector.
pub(crate) fn is_marked(symbol: &Symbol) -> bool {
    VECTORS.iter().any(|mark| symbol.base.contains(mark))
}

/// Whether a name is the vector 0.
pub(crate) fn is_zero(symbol: &Symbol) -> bool {
    symbol.below.is_none() && symbol.primes == 0 && VECTORS.iter().any(|mark| symbol.base == format!("{mark}0}}"))
}

impl Reader<'_, '_, '_> {
    /// The piece of a name, which is a vector where it is marked as one.
    pub(crate) fn marked(&mut self, piece: Piece, symbol: &Symbol) -> Piece {
        let is_vector = is_marked(symbol) && !self.scope.names.is_renamed(&symbol.key());
        if is_vector && !piece.is_matrix && !self.scope.within_bars {
            self.scope.vectors.bare.get_or_insert(symbol.span);
        }
        Piece { is_vector, ..piece }
    }

    /// Refuses a vector where only a number has a meaning.
    pub(crate) fn number_only(&self, piece: &Piece, what: &str, span: Span) -> Read<()> {
        match piece.is_vector && !piece.is_matrix {
            true => Err(no_vector(what, span)),
            false => Ok(()),
        }
    }

    /// Takes note of a vector beside a number other than 0, in a sum or a comparison.
    pub(crate) fn alike(&mut self, parts: &[(bool, bool)], span: Span) {
        let has_number = parts.iter().any(|(is_vector, is_zero)| !is_vector && !is_zero);
        if has_number && parts.iter().any(|(is_vector, _)| *is_vector) {
            self.scope.vectors.mixed.get_or_insert(span);
        }
    }

    /// Refuses a product of two vectors, and a quotient by one.
    pub(crate) fn linear(&self, factors: &[(bool, Piece)], span: Span) -> Read<()> {
        if let Some((_, by)) = factors.iter().find(|(divides, factor)| *divides && factor.is_vector) {
            return Err(no_vector("a quotient by a vector", by.text.span()));
        }
        match factors.iter().filter(|(_, factor)| factor.is_vector).count() {
            0 | 1 => Ok(()),
            _ => Err(no_vector("a product of vectors", span)),
        }
    }

    /// What stands in bars: of a vector its length, of one name alone.
    pub(crate) fn in_bars(&mut self, read: impl FnOnce(&mut Self) -> Read<Piece>) -> Read<Piece> {
        let outer = std::mem::replace(&mut self.scope.within_bars, true);
        let inner = read(self);
        self.scope.within_bars = outer;
        let inner = inner?;
        if inner.is_vector {
            let span = inner.text.span();
            if inner.level < 5 || inner.text.text().contains(['+', '-', '*', '/']) {
                return Err(no_vector("the length of a sum or a multiple of vectors", span));
            }
            self.scope.vectors.lengths.get_or_insert(span);
        }
        Ok(Piece { is_vector: false, ..inner })
    }
}
