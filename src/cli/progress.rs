//! Progress on a terminal, for work that takes longer than half a second.
//!
//! A thread of its own draws, so that one long step shows the time going by as well as many short
//! ones. Where standard error is no terminal, there is no thread and nothing is drawn.

use super::terminal::quiet;
use indicatif::{HumanDuration, ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};
use std::fmt::Write;
use std::io::IsTerminal;
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// How long to wait before progress is shown.
const QUIET: Duration = Duration::from_millis(500);
/// How often the bar is drawn.
const TICK: Duration = Duration::from_millis(100);

const NAMED: &str = "{bar:30} {pos}/{len} {elapsed} {wide_msg}";
const ALONE: &str = "{spinner} {elapsed} {wide_msg}";
const COUNTED: &str = "{bar:30} {human_pos}/{human_len} {rate}, {left}  {wide_msg}";

/// What the bar shows.
struct State {
    done: u64,
    what: String,
}

/// A bar that appears when the work turns out to be long, and goes when this is dropped.
pub(super) struct Progress {
    state: Arc<Mutex<State>>,
    thread: Option<(Sender<()>, JoinHandle<()>)>,
}

impl Progress {
    /// Begins to wait; `total` is how many steps there will be, each with a name.
    pub(super) fn start(total: u64) -> Progress {
        Progress::on(total, 0, NAMED, ProgressDrawTarget::stderr)
    }

    /// The same for many short steps, of which the rate and the time left are shown; some are done already.
    pub(super) fn rows(done: u64, total: u64) -> Progress {
        Progress::on(total, done, COUNTED, ProgressDrawTarget::stderr)
    }

    /// Work of which nobody knows how much is left: the time that has gone by is shown.
    pub(super) fn alone(what: &str) -> Progress {
        let progress = Progress::on(1, 0, ALONE, ProgressDrawTarget::stderr);
        progress.now(0, what);
        progress
    }

    fn on(total: u64, done: u64, template: &'static str, target: fn() -> ProgressDrawTarget) -> Progress {
        let terminal = std::io::stderr().is_terminal() && !quiet();
        Progress::draw_on(total, done, template, terminal.then(target))
    }

    fn draw_on(total: u64, from: u64, template: &'static str, target: Option<ProgressDrawTarget>) -> Progress {
        let state = Arc::new(Mutex::new(State { done: from, what: String::new() }));
        let begun = Instant::now();
        let shared = state.clone();
        let thread = target.map(|target| {
            let (sender, stop) = channel::<()>();
            let bar = move || {
                let style = ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar());
                // The rate is that of this run, from its beginning, not from when the bar appears.
                let rate = move |state: &ProgressState| {
                    state.pos().saturating_sub(from) as f64 / begun.elapsed().as_secs_f64().max(f64::MIN_POSITIVE)
                };
                let style = style.with_key("rate", move |state: &ProgressState, out: &mut dyn Write| {
                    // Writing to a text cannot fail.
                    let _ = write!(out, "{:.0}/s", rate(state));
                });
                let style = style.with_key("left", move |state: &ProgressState, out: &mut dyn Write| {
                    let left = total.saturating_sub(state.pos()) as f64 / rate(state);
                    // Before the first step is done nobody knows.
                    let _ = match Duration::try_from_secs_f64(left) {
                        Ok(left) => write!(out, "{} left", HumanDuration(left)),
                        Err(_) => write!(out, "no step done yet"),
                    };
                });
                ProgressBar::with_draw_target(Some(total), target).with_style(style).with_position(from)
            };
            (sender, std::thread::spawn(move || draw(bar, &shared, |wait| stop.recv_timeout(wait))))
        });
        Progress { state, thread }
    }

    /// Says how many steps are done and what the present one is.
    pub(super) fn now(&self, done: u64, what: &str) {
        if self.thread.is_some() {
            let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
            state.done = done;
            what.clone_into(&mut state.what);
        }
    }

    /// Takes the bar away.
    pub(super) fn finish(self) {}
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some((sender, thread)) = self.thread.take() {
            drop(sender);
            // If the drawing thread failed, only the display is lost.
            let _ = thread.join();
        }
    }
}

fn draw(
    bar: impl FnOnce() -> ProgressBar,
    state: &Mutex<State>,
    wait: impl Fn(Duration) -> Result<(), RecvTimeoutError>,
) {
    if wait(QUIET) != Err(RecvTimeoutError::Timeout) {
        return;
    }
    let bar = bar();
    loop {
        {
            let state = state.lock().unwrap_or_else(PoisonError::into_inner);
            bar.set_position(state.done);
            bar.set_message(state.what.clone());
        }
        bar.tick();
        if wait(TICK) != Err(RecvTimeoutError::Timeout) {
            break;
        }
    }
    bar.finish_and_clear();
}

#[cfg(test)]
mod tests {
    use super::*;
    use indicatif::TermLike;

    /// A terminal that counts what is written to it.
    #[derive(Debug, Clone, Default)]
    struct Recorder(Arc<Mutex<String>>);

    impl TermLike for Recorder {
        fn width(&self) -> u16 {
            80
        }
        fn move_cursor_up(&self, _: usize) -> std::io::Result<()> {
            Ok(())
        }
        fn move_cursor_down(&self, _: usize) -> std::io::Result<()> {
            Ok(())
        }
        fn move_cursor_right(&self, _: usize) -> std::io::Result<()> {
            Ok(())
        }
        fn move_cursor_left(&self, _: usize) -> std::io::Result<()> {
            Ok(())
        }
        fn write_line(&self, text: &str) -> std::io::Result<()> {
            self.write_str(text)
        }
        fn write_str(&self, text: &str) -> std::io::Result<()> {
            self.0.lock().expect("not poisoned").push_str(text);
            Ok(())
        }
        fn clear_line(&self) -> std::io::Result<()> {
            Ok(())
        }
        fn flush(&self) -> std::io::Result<()> {
            Ok(())
        }
    }

    #[test]
    fn one_slow_step_shows_a_bar_after_half_a_second_and_a_fast_one_shows_none() {
        let terminal = Recorder::default();
        let target = || Some(ProgressDrawTarget::term_like_with_hz(Box::new(terminal.clone()), 50));
        let progress = Progress::draw_on(1, 0, NAMED, target());
        progress.now(0, "fast");
        progress.finish();
        assert_eq!(*terminal.0.lock().expect("not poisoned"), "");
        let progress = Progress::draw_on(1, 0, NAMED, target());
        progress.now(0, "slow-claim");
        std::thread::sleep(Duration::from_millis(250));
        assert_eq!(*terminal.0.lock().expect("not poisoned"), "", "too early");
        std::thread::sleep(Duration::from_millis(1000));
        let shown = terminal.0.lock().expect("not poisoned").clone();
        assert!(shown.contains("0/1") && shown.contains("slow-claim"), "{shown:?}");
        assert!(
            shown.contains("00:00:01") || shown.contains("0s") || shown.contains("1s"),
            "the time goes by: {shown:?}"
        );
        progress.finish();
    }

    #[test]
    fn the_first_rate_is_that_of_the_work_and_not_of_the_bar() {
        let terminal = Recorder::default();
        let target = || Some(ProgressDrawTarget::term_like_with_hz(Box::new(terminal.clone()), 50));
        // 2,000 of 10,000 are old; 1,000 more take more than half a second.
        let progress = Progress::draw_on(10_000, 2_000, COUNTED, target());
        progress.now(3_000, "");
        std::thread::sleep(Duration::from_millis(900));
        progress.finish();
        let shown = terminal.0.lock().expect("not poisoned").clone();
        let rates = shown.split("/s").filter_map(|part| part.rsplit(' ').next()?.parse::<u64>().ok());
        let rates: Vec<u64> = rates.collect();
        assert!(!rates.is_empty() && rates.iter().all(|rate| (500..=2_000).contains(rate)), "{rates:?}: {shown:?}");
    }
}
