//! The paper's claims as properties of chains, on random exact inputs.
//!
//! [`strategies`] are proptest's, for tests of your own code; [`claims`] hold the code of this crate to the
//! statements of the catalogue; [`check`] runs one of them and gives a failing chain as small as it can be made;
//! [`scene`] writes a chain as a scene file.
//!
//! A property that held is not proved: `carom audit` proves. It shows that the code which computes and the
//! statement which is proved agree.

pub mod claims;
pub mod scene;
pub mod strategies;

use crate::scene::Chain;
use claims::Property;
use proptest::test_runner::{Config, RngAlgorithm, TestCaseError, TestError, TestRng, TestRunner};

/// The most steps of making a failing chain smaller.
const SHRINKING: u32 = 20_000;

/// What became of a property.
#[derive(Clone, Debug, PartialEq)]
pub enum Outcome {
    /// It held in every case.
    Held,
    /// It failed; the smallest chain found for which it does, and what is wrong there.
    Failed {
        /// The chain.
        chain: Box<Chain>,
        /// What is wrong.
        reason: String,
    },
    /// The run could not go on.
    Stopped(String),
}

/// Runs a property on so many chains. The same seed gives the same chains, whatever else is run.
#[must_use]
pub fn check(property: &Property, cases: u32, seed: u64) -> Outcome {
    let config = Config { cases, max_shrink_iters: SHRINKING, failure_persistence: None, ..Config::default() };
    let mut runner = TestRunner::new_with_rng(config, generator(property.id, seed));
    let result = runner.run(&property.strategy(), |chain| (property.test)(&chain).map_err(TestCaseError::fail));
    match result {
        Ok(()) => Outcome::Held,
        Err(TestError::Fail(reason, chain)) => {
            Outcome::Failed { chain: Box::new(chain), reason: reason.message().to_owned() }
        }
        Err(TestError::Abort(reason)) => Outcome::Stopped(reason.message().to_owned()),
    }
}

/// Random numbers of their own for each property.
fn generator(id: &str, seed: u64) -> TestRng {
    // FNV-1a: any mixing will do, as long as it never changes.
    let mix = |start: u64| id.bytes().fold(start, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3));
    let words = [seed, mix(0xcbf2_9ce4_8422_2325), mix(seed), seed.rotate_left(32)];
    let mut bytes = [0; 32];
    for (place, byte) in words.iter().flat_map(|word| word.to_le_bytes()).enumerate() {
        bytes[place] = byte;
    }
    TestRng::from_seed(RngAlgorithm::ChaCha, &bytes)
}
