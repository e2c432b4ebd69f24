//! Bounds of a limit: what was shown for the claim's variable, shown again for every large value.

use super::{Elaborator, Stuck};
use crate::certificate as old;
use crate::certificate2::Rule;
use crate::claim::syntax::*;

impl Elaborator {
    /// The rule `squeeze` with its bounds, which the old kernel knew for the variable itself.
    pub(super) fn squeeze(&mut self, step: &old::Step, prop: &Prop) -> Result<Rule, Stuck> {
        let _ = prop;
        Err(Stuck::Malformed(step.label.clone()))
    }
}
