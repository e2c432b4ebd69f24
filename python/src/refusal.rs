//! Why there is no answer, and how Python is told.

use carom::chain::ChainError;
use carom::number::NumberError;
use pyo3::exceptions::{PyException, PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc;
use std::time::Duration;

pyo3::create_exception!(
    carom,
    LimitReached,
    PyException,
    "A stated limit was reached: the input is right, and the answer is more than the program undertakes."
);

/// Why there is no answer.
pub enum Refusal {
    /// The input is wrong.
    Input(String),
    /// A stated limit.
    Limit(String),
    /// The program is wrong.
    Failure,
}

impl Refusal {
    /// What is wrong with a named argument.
    pub fn at(name: &str, error: impl std::fmt::Display) -> Refusal {
        Refusal::Input(format!("{name}: {error}"))
    }
}

impl From<ChainError> for Refusal {
    fn from(error: ChainError) -> Refusal {
        let text = error.to_string();
        if matches!(error, ChainError::Number(NumberError::LimitReached { .. })) {
            Refusal::Limit(text)
        } else {
            Refusal::Input(text)
        }
    }
}

impl From<Refusal> for PyErr {
    fn from(refusal: Refusal) -> PyErr {
        match refusal {
            Refusal::Input(text) => PyValueError::new_err(text),
            Refusal::Limit(text) => LimitReached::new_err(text),
            Refusal::Failure => PyRuntimeError::new_err("the program failed; please report this"),
        }
    }
}

/// Works without Python's lock.
pub fn detached<T: Send>(py: Python<'_>, work: impl FnOnce() -> Result<T, Refusal> + Send) -> Result<T, Refusal> {
    py.detach(|| catch_unwind(AssertUnwindSafe(work)).unwrap_or(Err(Refusal::Failure)))
}

/// How often a long work looks whether somebody pressed Ctrl-C.
const LOOK: Duration = Duration::from_millis(50);

/// Works without Python's lock on a thread of its own, so that Ctrl-C ends the call at once. The thread ends by itself.
pub fn interruptible<T: Send + 'static>(
    py: Python<'_>,
    work: impl FnOnce() -> Result<T, Refusal> + Send + 'static,
) -> PyResult<T> {
    let (send, mut receive) = mpsc::channel();
    std::thread::spawn(move || send.send(catch_unwind(AssertUnwindSafe(work)).unwrap_or(Err(Refusal::Failure))));
    loop {
        let receive = &mut receive;
        match py.detach(move || receive.recv_timeout(LOOK)) {
            Ok(found) => return Ok(found?),
            Err(mpsc::RecvTimeoutError::Timeout) => py.check_signals()?,
            Err(mpsc::RecvTimeoutError::Disconnected) => return Err(Refusal::Failure.into()),
        }
    }
}

/// Works without Python's lock on a stack that holds the deepest expressions, as the command line has it.
pub fn detached_deep<T: Send>(py: Python<'_>, work: impl FnOnce() -> Result<T, Refusal> + Send) -> Result<T, Refusal> {
    py.detach(|| {
        std::thread::scope(|scope| {
            let worker = std::thread::Builder::new().stack_size(64 << 20).spawn_scoped(scope, work);
            worker.ok().and_then(|worker| worker.join().ok()).unwrap_or(Err(Refusal::Failure))
        })
    })
}
