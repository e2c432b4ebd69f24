//! The law `numeral` of tests/all/bytes/laws.rs, for any bytes.
#![no_main]
#[path = "../../tests/all/bytes/laws.rs"]
#[allow(dead_code)]
mod laws;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| laws::numeral(bytes));
