//! The clock of limits in seconds: the time that this thread has worked.
//!
//! Contract: two moments compare only on the thread that took them. A claim is decided on one thread, so a machine that is
//! busy with other work decides the same claims as a quiet one; it only takes longer. Where the system does not say how long
//! a thread has worked, it is the time since the first question.

use std::time::Duration;

/// How long this thread had worked at some moment.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Moment(Duration);

impl Moment {
    /// This moment.
    pub fn now() -> Moment {
        Moment(worked())
    }

    /// How much later it is than another moment; nothing if it is earlier.
    pub fn after(self, earlier: Moment) -> Duration {
        self.0.saturating_sub(earlier.0)
    }

    /// The moment after so much more work; `None` where that is beyond all numbers.
    pub fn checked_add(self, time: Duration) -> Option<Moment> {
        self.0.checked_add(time).map(Moment)
    }

    /// How long the thread has worked since.
    pub fn elapsed(self) -> Duration {
        worked().saturating_sub(self.0)
    }
}

#[cfg(unix)]
fn worked() -> Duration {
    let time = rustix::time::clock_gettime(rustix::time::ClockId::ThreadCPUTime);
    let seconds = u64::try_from(time.tv_sec).unwrap_or(0);
    Duration::new(seconds, u32::try_from(time.tv_nsec).unwrap_or(0))
}

#[cfg(not(unix))]
fn worked() -> Duration {
    #[cfg(not(all(target_family = "wasm", target_os = "unknown")))]
    use std::time::Instant;
    // A browser has a clock, but not behind the standard library's type.
    #[cfg(all(target_family = "wasm", target_os = "unknown"))]
    use web_time::Instant;
    static FIRST: std::sync::OnceLock<Instant> = std::sync::OnceLock::new();
    FIRST.get_or_init(Instant::now).elapsed()
}

#[cfg(all(test, unix))]
#[allow(clippy::unwrap_used)] // a test stops where it fails
mod tests {
    use super::*;

    #[test]
    fn time_in_which_the_thread_sleeps_does_not_count() {
        let begin = Moment::now();
        std::thread::sleep(Duration::from_millis(200));
        assert!(begin.elapsed() < Duration::from_millis(100));
        while begin.elapsed() < Duration::from_millis(5) {}
        assert!(begin.checked_add(Duration::from_millis(5)).unwrap() < Moment::now());
    }
}
