//! Claims on all cores, each after those that it cites.

use super::Judged;
use crate::claim::syntax::Claim;
use std::collections::{BTreeMap, VecDeque};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};

/// Expressions nest up to a limit; this stack holds the deepest with room to spare.
const STACK: usize = 64 << 20;

/// What the threads share.
struct Shared<'c> {
    /// Claims that nobody has begun, in order.
    waiting: VecDeque<&'c Claim>,
    /// Those that are done.
    done: BTreeMap<String, Arc<Judged>>,
    /// Whether a thread failed: then nothing more is begun.
    failed: bool,
}

/// Does the work for each claim, when it is done for those that it cites; `order` holds cited claims first.
pub(crate) fn each_after_what_it_cites(
    order: &[Claim],
    now: &(dyn Fn(usize, &str) + Sync),
    work: &(dyn Fn(&Claim, &[&Judged]) -> Judged + Sync),
) -> BTreeMap<String, Judged> {
    let shared = Shared { waiting: order.iter().collect(), done: BTreeMap::new(), failed: false };
    let (shared, changed) = (Mutex::new(shared), Condvar::new());
    let threads = match cfg!(target_arch = "wasm32") {
        true => 1,
        false => std::thread::available_parallelism().map_or(1, usize::from).min(order.len()),
    };
    let run = || {
        let mut failing = Failing { shared: &shared, changed: &changed, armed: true };
        one_thread(&shared, &changed, now, work);
        failing.armed = false;
    };
    std::thread::scope(|scope| {
        // This thread works as well; where the system gives no other, it does all.
        for _ in 1..threads {
            let _ = std::thread::Builder::new().stack_size(STACK).spawn_scoped(scope, run);
        }
        run();
    });
    let done = shared.into_inner().unwrap_or_else(PoisonError::into_inner).done;
    done.into_iter().filter_map(|(name, judged)| Some((name, Arc::into_inner(judged)?))).collect()
}

/// Wakes the others where a thread ends before its work does, so that none waits for it.
struct Failing<'s, 'c> {
    shared: &'s Mutex<Shared<'c>>,
    changed: &'s Condvar,
    armed: bool,
}

impl Drop for Failing<'_, '_> {
    fn drop(&mut self) {
        if self.armed {
            locked(self.shared).failed = true;
            self.changed.notify_all();
        }
    }
}

fn locked<'s, 'c>(shared: &'s Mutex<Shared<'c>>) -> MutexGuard<'s, Shared<'c>> {
    shared.lock().unwrap_or_else(PoisonError::into_inner)
}

fn one_thread(
    shared: &Mutex<Shared<'_>>,
    changed: &Condvar,
    now: &(dyn Fn(usize, &str) + Sync),
    work: &(dyn Fn(&Claim, &[&Judged]) -> Judged + Sync),
) {
    loop {
        let mut state = locked(shared);
        let (claim, cited) = loop {
            if state.failed || state.waiting.is_empty() {
                return;
            }
            // A claim that is cited and was not asked for is in the list as well, so every citation is met.
            let ready = |claim: &&Claim| claim.using.iter().all(|n| state.done.contains_key(&n.text));
            if let Some(place) = state.waiting.iter().position(ready) {
                let Some(claim) = state.waiting.remove(place) else { return };
                let cited: Vec<Arc<Judged>> =
                    claim.using.iter().filter_map(|n| state.done.get(&n.text).cloned()).collect();
                now(state.done.len(), &claim.name.text);
                break (claim, cited);
            }
            state = changed.wait(state).unwrap_or_else(PoisonError::into_inner);
        };
        drop(state);
        let judged = work(claim, &cited.iter().map(Arc::as_ref).collect::<Vec<_>>());
        drop(cited);
        locked(shared).done.insert(claim.name.text.clone(), Arc::new(judged));
        changed.notify_all();
    }
}
