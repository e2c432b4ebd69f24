//! Parts of an expression as text of the claim language, with their precedence.

use super::place::Placed;
use carom_diagnostic::Span;

/// Precedence, as in the claim language's printer: sum 1, negation 2, product 3, power 4, atom 5.
pub(crate) type Level = u8;

/// A part of an expression.
#[derive(Clone, Debug)]
pub(crate) struct Piece {
    /// Its text.
    pub text: Placed,
    /// Its precedence.
    pub level: Level,
    /// Of a product without parentheses: its factors, each with whether it divides.
    pub factors: Vec<(bool, Piece)>,
    /// Whether it is a numeral.
    pub is_number: bool,
    /// The name alone that it is.
    pub name: Option<String>,
    /// Whether it is a name that is marked as a vector.
    pub is_vector: bool,
    /// Whether it is a matrix.
    pub is_matrix: bool,
}

impl Piece {
    /// A part of this precedence.
    pub(crate) fn new(text: Placed, level: Level) -> Piece {
        let factors = Vec::new();
        Piece { text, level, factors, is_number: false, name: None, is_vector: false, is_matrix: false }
    }

    /// Whether it is a vector, and whether it is 0 or a matrix, which stands beside vectors.
    pub(crate) fn kind(&self) -> (bool, bool) {
        (self.is_vector, self.text.text() == "0" || self.is_matrix)
    }

    /// A single sign or name.
    pub(crate) fn atom(text: &str, span: Span) -> Piece {
        Piece::new(Placed::new(text, span), 5)
    }

    /// Its text, in parentheses if it binds less than `least`.
    pub(crate) fn at_least(&self, least: Level) -> Placed {
        if self.level >= least { self.text.clone() } else { self.text.between("(", ")") }
    }

    /// In parentheses unless it is an atom; no longer a product that a fraction may take apart.
    pub(crate) fn closed(self) -> Piece {
        let text = self.at_least(5);
        Piece { factors: Vec::new(), level: 5, text, ..self }
    }

    /// `function(self)`
    pub(crate) fn within(&self, function: &str) -> Piece {
        Piece::new(self.text.between(&format!("{function}("), ")"), 5)
    }

    /// `self^exponent`
    pub(crate) fn to(&self, exponent: &Piece) -> Piece {
        let mut text = self.at_least(5);
        text.push("^", exponent.text.span());
        text.append(&exponent.at_least(5));
        Piece { is_matrix: self.is_matrix, ..Piece::new(text, 4) }
    }

    /// The factors that a numerator contributes.
    pub(crate) fn into_factors(mut self) -> Vec<(bool, Piece)> {
        if self.factors.is_empty() { vec![(false, self)] } else { std::mem::take(&mut self.factors) }
    }
}

/// A product of factors, each with whether it divides; the first does not.
pub(crate) fn product(mut factors: Vec<(bool, Piece)>) -> Piece {
    if factors.len() == 1
        && let Some((_, only)) = factors.pop()
    {
        return only;
    }
    let mut text = Placed::default();
    for (place, (divides, factor)) in factors.iter().enumerate() {
        if place > 0 {
            text.push(if *divides { "/" } else { "*" }, factor.text.span());
        }
        text.append(&factor.at_least(4));
    }
    let is_vector = factors.iter().any(|(_, factor)| factor.is_vector);
    let is_matrix = factors.iter().any(|(_, factor)| factor.is_matrix);
    Piece { factors, is_vector, is_matrix, ..Piece::new(text, 3) }
}
