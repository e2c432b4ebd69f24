//! Any bytes: the reader returns a certificate or a fault; one that was read is written and read to the
//! same text, and the kernel answers for a small claim without a panic.
#![no_main]
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    let Ok(certificate) = carom::certificate::text::read(text) else { return };
    let written = carom::certificate::text::write(&certificate);
    let again = carom::certificate::text::read(&written).expect("what was written reads");
    assert_eq!(carom::certificate::text::write(&again), written);
    let claims = carom::claim::parse::parse("claim a \"a\"\ngiven x > 0\nprove x + 1/x >= 2\n").expect("a claim");
    for claim in &claims {
        let _ = carom::kernel::check(claim, &certificate, &[]);
    }
});
