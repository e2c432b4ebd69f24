//! Pictures as SVG, PNG and PDF.
//!
//! `shape` holds what is drawn, [`svg`], `png` and [`pdf`] write it, `letters` sets text in the outlines of one
//! font so that both look the same everywhere, `scale` chooses ticks, [`axes`] lays out a page with a frame, scales and
//! a legend, and [`charts`] has a function for each picture, which [`look`] changes as a reader asks. What cannot be shown is [`unclear`].
//!
//! A picture is drawn from enclosures, but a point of a curve is a point of a curve: what must be certain is in
//! tables. Colours are those of Okabe and Ito, which colour-blind readers tell apart; curves differ in their
//! dashes as well, for print without colours.

pub mod axes;
pub mod charts;
pub mod letters;
pub mod look;
pub mod pdf;
pub mod png;
pub(crate) mod scale;
pub mod shape;
pub mod svg;
pub mod unclear;
