//! Carom's engine for Python: plain functions and a few classes, from texts to texts, tuples and doubles.
//!
//! Contract: the package `carom` around this module gives them their Python faces. Bad input is `ValueError` with the
//! program's message, a stated limit is `LimitReached`. All work is done without Python's lock. No input makes a
//! function panic; should one do so all the same, `RuntimeError` says it.

mod bounces;
mod chain;
mod claims;
mod number;
mod refusal;
mod rows;
mod table;
mod tools;

use pyo3::prelude::*;

/// The engine.
#[pymodule]
mod _engine {
    use super::{Bound, PyModule, PyModuleMethods, PyResult};

    #[pymodule_export]
    use super::bounces::restitution;
    #[pymodule_export]
    use super::chain::{Chain, eta};
    #[pymodule_export]
    use super::claims::{audit, audit_paper, audit_report, catalogue, language, repair};
    #[pymodule_export]
    use super::number::Found;
    #[pymodule_export]
    use super::refusal::LimitReached;
    #[pymodule_export]
    use super::rows::Rows;
    #[pymodule_export]
    use super::table::{Plan, table_text};
    #[pymodule_export]
    use super::tools::{
        check, export, format_claims, judge_simulator, judged, law_point, plot, plot_velocities, referee_file, replay,
        rounded, scene_schema, worksheet,
    };

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}
