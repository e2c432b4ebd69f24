//! Documents: what the search and the physics found, as text, JSON, Markdown, LaTeX, HTML and pictures, and in the languages
//! of Coq and of SMT solvers.

pub mod export;
pub mod report;

// The rooms of the crates above, under the names that they have there.
pub(crate) use carom_checker::{certificate, claim, kernel, table_checker};
pub(crate) use carom_exact::number;
pub(crate) use carom_physics::{chain, referee, scene, table};
pub(crate) use carom_search::{explain, judge, refute};
