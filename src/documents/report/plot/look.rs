//! How a picture looks beyond what it shows: title, limits, own points.

use super::axes::Chart;
use super::unclear::Unclear;
use crate::chain::uncertain::Range;
use malachite::Rational;
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::rounding_modes::RoundingMode;

/// What a reader asks of a picture; nothing by default.
#[derive(Clone, Debug, Default)]
pub struct Look {
    /// The title in place of the picture's own.
    pub title: Option<String>,
    /// The ends of the horizontal axis.
    pub across: Option<(f64, f64)>,
    /// The ends of the vertical axis.
    pub upright: Option<(f64, f64)>,
    /// Own measurements, as a point or with its uncertainties.
    pub points: Vec<(Range<Rational>, Range<Rational>)>,
}

impl Look {
    /// The picture as it is asked for. What lies beyond its limits is cut off.
    ///
    /// # Errors
    /// [`Unclear`]: an own point outside of the picture, limits at which a logarithmic axis has no place.
    pub fn apply(&self, mut chart: Chart) -> Result<Chart, Unclear> {
        if let Some(title) = &self.title {
            chart.rename(title);
        }
        if let Some(ends) = self.across {
            chart.cut_across(ends)?;
        }
        if let Some(ends) = self.upright {
            chart.cut_upright(ends)?;
        }
        for (x, y) in &self.points {
            chart.measured(ends(x), ends(y))?;
        }
        if !self.points.is_empty() {
            chart.legend_own("measured");
        }
        Ok(chart)
    }
}

fn ends(range: &Range<Rational>) -> (f64, f64) {
    let float = |x: &Rational| f64::rounding_from(x, RoundingMode::Nearest).0;
    (float(range.lo()), float(range.hi()))
}
