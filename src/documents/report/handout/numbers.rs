//! The certified tables of a report, and its pictures.

use crate::report::table::{Entry, Head};
use crate::table::Quantity;
use crate::table_checker::Checker;
use crate::table_checker::Failure;

/// The most rows of a table in a report: it is read by people.
pub const ROWS: u64 = 1_000;

/// A table.
pub struct Table {
    /// The command that makes it.
    pub command: String,
    /// What it holds.
    pub quantity: Quantity,
    /// What stands above it.
    pub head: Head,
    /// Its rows.
    pub rows: Vec<Vec<Entry>>,
    /// The same as comma-separated values.
    pub csv: String,
    /// Its certificate: an enclosure or exact value for every cell.
    pub certificate: String,
}

impl Table {
    /// A caption: the quantity in words.
    #[must_use]
    pub fn title(&self) -> &'static str {
        match self.quantity {
            Quantity::Eta => "Share η of the energy handed on through n inserted bodies of optimal mass",
            Quantity::Threshold => "Least restitution L_n with which the n-th inserted body helps",
            Quantity::BestN => "Best number n* of inserted bodies",
        }
    }

    /// The claims of the catalogue that the formula is of.
    #[must_use]
    pub fn claims(&self) -> &'static [&'static str] {
        match self.quantity {
            Quantity::Eta => &["eq25"],
            Quantity::Threshold => &["eq19"],
            Quantity::BestN => &["eq19", "b-best"],
        }
    }

    /// A fact of its head.
    #[must_use]
    pub(crate) fn fact(&self, name: &str) -> &str {
        self.head.facts.iter().find(|f| f.0 == name).map_or("", |f| f.1.as_str())
    }

    /// Has the kernel check the certificate: the claims that the table then rests on.
    ///
    /// # Errors
    /// Why the kernel did not accept it.
    pub(crate) fn checked(&self) -> Result<&'static [&'static str], String> {
        let why = |failure: Failure| match failure {
            Failure::Rejected(reason) => reason,
            Failure::Declined(limit) => format!("limit reached: {limit}"),
        };
        let mut lines = self.certificate.lines();
        let mut checker = Checker::new(lines.next().unwrap_or_default()).map_err(why)?;
        for line in lines {
            checker.row(line).map_err(why)?;
        }
        Ok(checker.finish().map_err(why)?.rests_on())
    }
}

/// A picture.
pub struct Plot {
    /// The command that makes it.
    pub command: String,
    /// Its caption: the quantity in words.
    pub title: String,
    /// A description for readers who cannot see the picture.
    pub description: String,
    /// The claims of the catalogue that the drawn formulas are of.
    pub claims: &'static [&'static str],
    /// As SVG inside a page; its identifiers begin with [`Plot::prefix`].
    pub inline: String,
    /// As an SVG file.
    pub svg: String,
    /// As a PNG file.
    pub png: Vec<u8>,
}

impl Plot {
    /// The prefix of the identifiers of the picture with this number. It contains a point, which no claim's name does.
    #[must_use]
    pub fn prefix(place: usize) -> String {
        format!("plot.{}.", place + 1)
    }
}

/// The note on tables and pictures.
pub(crate) const WHAT_IS_CERTAIN: &str = "The tables are certified: every digit printed is right, and a certificate lies beside \
                                   each. In the pictures the points of a curve are computed to 64 bits and then drawn; \
                                   what lies between two points is drawn, not certified.";
