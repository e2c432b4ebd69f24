//! Pictures as SVG and PNG.
//!
//! [`shape`] holds what is drawn, [`svg`] and [`png`] write it, [`letters`] sets text in the outlines of one
//! font so that both look the same everywhere, [`scale`] chooses ticks, [`axes`] lays out a page with a frame, scales and
//! a legend, and [`charts`] has a function for each picture. What cannot be shown is [`unclear`].
//!
//! A picture is drawn from enclosures, but a point of a curve is a point of a curve: what must be certain is in
//! tables. Colours are those of Okabe and Ito, which colour-blind readers tell apart; curves differ in their
//! dashes as well, for print without colours.

pub mod axes;
pub mod charts;
pub mod letters;
#[cfg(feature = "plot")]
pub mod png;
pub mod scale;
pub mod shape;
pub mod svg;
pub mod unclear;
