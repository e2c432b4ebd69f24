//! Any bytes: the parser returns claims or faults, and a claim that was read prints as one that reads
//! to the same statement.
#![no_main]
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    if let Ok(claims) = carom::claim::parse::parse_bytes(bytes) {
        for claim in &claims {
            let goal = carom::claim::print::prop(&claim.goal);
            let again = carom::claim::parse::parse_prop(&goal).expect("what was printed reads");
            assert_eq!(carom::kernel::text::prop(&again), carom::kernel::text::prop(&claim.goal));
        }
    }
});
