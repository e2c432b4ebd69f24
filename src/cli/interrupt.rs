//! Ctrl-C during long work.
//!
//! Contract: from [`at_once`] on, Ctrl-C ends the program, and its exit code is [`INTERRUPTED`]. From
//! [`Interrupt::listen`] on, the first one asks for an end, which the work looks for at its next whole row or file, and
//! a second one ends at once. There is one state for the whole program: what is asked for is never forgotten.

use super::Exit;
use std::io::Write;
use std::sync::Once;
use std::sync::atomic::{AtomicU8, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError};
use std::time::Duration;

/// The exit code of a program that was interrupted.
pub(crate) const INTERRUPTED: u8 = 130;

/// How often Ctrl-C is looked for while nothing is heard.
const TICK: Duration = Duration::from_millis(50);

/// Ctrl-C ends the program.
const AT_ONCE: u8 = 0;
/// Ctrl-C asks for an end.
const LISTENING: u8 = 1;
/// It has been asked for.
const ASKED: u8 = 2;

static STATE: AtomicU8 = AtomicU8::new(AT_ONCE);

/// If no handler can be installed, Ctrl-C ends the program at once.
fn handle() {
    static HANDLED: Once = Once::new();
    HANDLED.call_once(|| {
        let _ = ctrlc::set_handler(|| {
            let exchanged = STATE.compare_exchange(LISTENING, ASKED, Ordering::SeqCst, Ordering::SeqCst);
            match exchanged {
                Ok(_) => return,
                Err(AT_ONCE) => eprintln!("interrupted: nothing is written"),
                Err(_) => {}
            }
            std::process::exit(i32::from(INTERRUPTED));
        });
    });
}

/// The exit after Ctrl-C; `what` describes what was written.
pub(super) fn interrupted(what: &str) -> Exit {
    Exit { code: INTERRUPTED, message: format!("interrupted: {what}") }
}

/// Ctrl-C ends the program from now on.
///
/// # Errors
/// An end has been asked for.
pub(crate) fn at_once() -> Result<(), Exit> {
    handle();
    match STATE.swap(AT_ONCE, Ordering::SeqCst) {
        ASKED => Err(interrupted("nothing is written")),
        _ => Ok(()),
    }
}

/// What somebody who waits for the workers hears.
pub(super) enum Heard<T> {
    /// A result.
    News(T),
    /// All workers have ended.
    End,
    /// Ctrl-C was pressed, and all results until then have been heard.
    Interrupted,
}

/// Work that looks at whether somebody has asked for an end.
#[derive(Clone, Copy)]
pub(super) struct Interrupt(());

impl Interrupt {
    /// Listens from now on.
    pub(crate) fn listen() -> Interrupt {
        handle();
        let _ = STATE.compare_exchange(AT_ONCE, LISTENING, Ordering::SeqCst, Ordering::SeqCst);
        Interrupt(())
    }

    /// Whether an end is asked for.
    pub(super) fn asked(self) -> bool {
        STATE.load(Ordering::SeqCst) == ASKED
    }

    /// Waits for the next result of the workers, for their end or for Ctrl-C.
    pub(super) fn next<T>(self, receiver: &Receiver<T>) -> Heard<T> {
        loop {
            if let Ok(news) = receiver.try_recv() {
                return Heard::News(news);
            }
            if self.asked() {
                return Heard::Interrupted;
            }
            match receiver.recv_timeout(TICK) {
                Ok(news) => return Heard::News(news),
                Err(RecvTimeoutError::Disconnected) => return Heard::End,
                Err(RecvTimeoutError::Timeout) => {}
            }
        }
    }

    /// Ends the program while its workers still work; `message` says what was written.
    pub(super) fn end(self, message: &str) -> ! {
        let _ = writeln!(anstream::stderr(), "{message}");
        std::process::exit(i32::from(INTERRUPTED));
    }
}
