//! Two long computations side by side.

/// Operands of fewer bits than this are not worth a thread (bench `numbers`, group `digits`).
pub const MIN_BITS: u64 = 100_000;

/// Both results; on two threads where that is `worth` it, as for operands of [`MIN_BITS`] bits, and the system gives a
/// thread.
pub fn both<A: Send, B: Send>(worth: bool, one: impl Fn() -> A + Sync, other: impl FnOnce() -> B) -> (A, B) {
    if !worth {
        return (one(), other());
    }
    std::thread::scope(|scope| {
        let started = std::thread::Builder::new().spawn_scoped(scope, &one);
        let second = other();
        // Where there is no thread, or it failed, the work is done here.
        let first = started.ok().and_then(|thread| thread.join().ok());
        (first.unwrap_or_else(&one), second)
    })
}
