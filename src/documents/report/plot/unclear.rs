//! Why a picture cannot show what was asked.

use crate::chain::ChainError;
use std::fmt;

/// The most characters of a number in a title or legend.
pub(crate) const NUMBER: usize = 40;

/// Why there is no picture.
#[derive(Clone, Debug, PartialEq)]
pub enum Unclear {
    /// The chain has no such values, or a limit was reached.
    Chain(ChainError),
    /// All values are so close to 0 that nothing would be seen.
    Tiny,
    /// All curves are one.
    Same,
    /// A value is too large to be drawn.
    Outside,
    /// Limits that an axis cannot have.
    Limits,
    /// An own point lies outside of the picture.
    Beyond,
    /// Fewer than two numbers fit to an axis.
    Axis(String),
    /// A number is too long for a title or legend.
    Long {
        /// What it is of.
        name: &'static str,
        /// How many characters it takes.
        characters: usize,
    },
}

impl From<ChainError> for Unclear {
    fn from(error: ChainError) -> Unclear {
        Unclear::Chain(error)
    }
}

impl fmt::Display for Unclear {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Chain(error) => error.fmt(f),
            Self::Tiny => {
                write!(
                    f,
                    "every value is below 1e-290, so the picture would be empty; print the values with `carom table` or `carom eval`"
                )
            }
            Self::Same => write!(
                f,
                "the curves cannot be told apart: all values agree to 12 digits; draw one curve or a wider range, or print the values with `carom table`"
            ),
            Self::Outside => {
                write!(f, "a value is beyond 1e300 and cannot be drawn; print the values with `carom eval`")
            }
            Self::Limits => {
                write!(f, "write the smaller end of an axis first, as in 0.1,1; a logarithmic axis begins above 0")
            }
            Self::Beyond => write!(f, "a point of --mark lies outside of the picture; widen --xlim, --ylim or --ratio"),
            Self::Axis(label) => write!(f, "fewer than two numbers fit at the axis {label}; draw a wider range"),
            Self::Long { name, characters } => {
                write!(
                    f,
                    "{name} takes {characters} characters, and a picture has room for {NUMBER}; write a shorter number"
                )
            }
        }
    }
}

impl std::error::Error for Unclear {}
