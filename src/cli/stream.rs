//! Claims judged in the order of the report, each told as soon as those before it are known.
//!
//! Contract: Ctrl-C is obeyed at once: what has been told by then is the answer. A second one ends the program.

use super::audit::Loaded;
use super::interrupt::{Heard, Interrupt};
use super::progress::Progress;
use crate::claim::syntax::Claim;
use crate::judge::{Entry, Judgement, News, Settings, judge};
use crate::refute::outcome::Fault;
use std::collections::BTreeMap;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::channel;

/// A claim's result.
pub(super) type Told<'a> = dyn FnMut(&str, &Result<Entry, Fault>) + 'a;

/// What was judged, in the order of the claims. After Ctrl-C, `leave` gets what is there and says what was written, and the
/// program ends.
pub(super) fn judged(
    loaded: &Loaded,
    only: &[String],
    settings: &Settings,
    tell: &mut Told<'_>,
    leave: &dyn Fn(Judgement) -> String,
) -> Judgement {
    let wanted: Vec<&Claim> =
        loaded.claims().iter().filter(|c| only.is_empty() || only.contains(&c.name.text)).collect();
    let shown = by_section(&wanted);
    let names: Vec<String> = shown.iter().map(|claim| claim.name.text.clone()).collect();
    let progress = Progress::start(wanted.len() as u64);
    let interrupt = Interrupt::listen();
    let (mut found, mut told, begun) = (BTreeMap::new(), 0, AtomicUsize::new(0));
    let in_order = |mut found: BTreeMap<String, Result<Entry, Fault>>, judged| {
        let entries = wanted.iter().filter_map(|claim| found.remove_entry(&claim.name.text)).collect();
        Judgement { entries, judged }
    };
    let (sender, receiver) = channel::<(String, Result<Entry, Fault>)>();
    let judged = std::thread::scope(|scope| {
        let (names, progress, begun) = (&names, &progress, &begun);
        let run = move || {
            let hear = |news: News<'_>| match news {
                News::Begun(done, name) => {
                    begun.store(done, Ordering::Relaxed);
                    progress.now(done as u64, name);
                }
                // Nobody listens any more once Ctrl-C was obeyed.
                News::Judged(name, result) => drop(sender.send((name.to_owned(), result.clone()))),
            };
            judge(&loaded.catalogue, names, loaded.hand(), settings, &hear).judged
        };
        // Where the system gives no thread, nothing is judged, which the caller sees.
        let worker = std::thread::Builder::new().stack_size(super::STACK).spawn_scoped(scope, run);
        loop {
            match interrupt.next(&receiver) {
                Heard::News((name, result)) => {
                    found.insert(name, result);
                    while let Some(claim) = shown.get(told)
                        && let Some(result) = found.get(&claim.name.text)
                    {
                        tell(&claim.name.text, result);
                        told += 1;
                    }
                }
                Heard::End => break,
                Heard::Interrupted => {
                    let left = leave(in_order(std::mem::take(&mut found), begun.load(Ordering::Relaxed)));
                    interrupt.end(&left);
                }
            }
        }
        match worker.map(|worker| worker.join()) {
            Ok(Ok(judged)) => judged,
            Ok(Err(panic)) => std::panic::resume_unwind(panic),
            Err(_) => 0,
        }
    });
    progress.finish();
    in_order(found, judged)
}

/// The claims in the order of the report: the sections as they first appear.
fn by_section<'c>(claims: &[&'c Claim]) -> Vec<&'c Claim> {
    let mut sections: Vec<(Option<&str>, Vec<&Claim>)> = Vec::new();
    for claim in claims {
        let section = claim.section.as_deref();
        match sections.iter_mut().find(|known| known.0 == section) {
            Some(known) => known.1.push(claim),
            None => sections.push((section, vec![claim])),
        }
    }
    sections.into_iter().flat_map(|section| section.1).collect()
}
