//! Properties of chains and of claims, on random exact inputs.
//!
//! [`law`] tries a claim of the language at random exact points that satisfy its hypotheses, as `carom test` does, and
//! gives a failing point as small as it can be made; [`strategies`] are proptest's, for tests of your own code; [`scene`]
//! writes a chain as a scene file.

pub mod law;
pub mod scene;
pub mod strategies;
