//! Ctrl-C during long work: the first one asks for an end at the next whole row, the second one ends at once.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// The exit code of a program that was interrupted.
pub const INTERRUPTED: u8 = 130;

/// Whether somebody has asked for an end.
#[derive(Clone)]
pub struct Interrupt(Arc<AtomicBool>);

impl Interrupt {
    /// Listens from now on. Where that cannot be had, Ctrl-C ends the program as it would without.
    pub fn listen() -> Interrupt {
        let asked = Arc::new(AtomicBool::new(false));
        let shared = asked.clone();
        let handler = move || {
            if shared.swap(true, Ordering::SeqCst) {
                std::process::exit(i32::from(INTERRUPTED));
            }
        };
        // A second handler in one process is refused; there is only this one.
        let _ = ctrlc::set_handler(handler);
        Interrupt(asked)
    }

    /// Whether an end is asked for.
    pub fn asked(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}
