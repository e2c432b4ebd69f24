//! Any text: the kernel reads a numeral or says why not, and never takes much time or memory for it.
#![no_main]
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    let _ = carom::kernel::translate::numeral(text);
});
