//! Definitions with parameters that use sin, cos or tan, such as `let R(a) = [cos(a), …]`, put in where they are applied.

use super::{NODES_LIMIT, Writer};
use crate::claim::syntax::*;
use crate::claim::walk;
use std::collections::{BTreeMap, BTreeSet};

/// The deepest expression that a definition becomes.
const DEPTH_LIMIT: usize = 400;

impl Writer<'_> {
    /// Puts these definitions in, and removes them from the claim.
    pub(super) fn put_in_functions(&mut self, claim: &mut Claim) {
        for mut item in std::mem::take(&mut claim.items) {
            walk::of_item(&mut item, &mut |e| self.put_in(e));
            match item {
                Item::Let { name, parameters, value } if !parameters.is_empty() && self.has_function(&value) => {
                    self.functions.insert(name.text, (parameters, value));
                }
                item => claim.items.push(item),
            }
        }
        walk::expressions(claim, &mut |e| self.put_in(e));
    }

    /// Puts them in within one expression.
    fn put_in(&mut self, e: &mut Expr) {
        if !self.faults.is_empty() {
            return;
        }
        walk::parts_mut(e, &mut |part| self.put_in(part));
        let ExprKind::Apply(name, arguments) = &e.kind else { return };
        let Some((parameters, value)) = self.functions.get(&name.text) else { return };
        self.nodes += walk::nodes_in(value) * arguments.iter().map(walk::nodes_in).sum::<usize>();
        if self.nodes > NODES_LIMIT {
            return self.limit("nodes of angles written out", NODES_LIMIT, e.span);
        }
        let mut bound = BTreeSet::new();
        walk::indices(value, &mut bound);
        let mut inside = BTreeSet::new();
        arguments.iter().for_each(|a| walk::names_in(a, &mut inside));
        if let Some(index) = bound.intersection(&inside).next() {
            let message = format!("the definition of {} and its argument both use the name {index}", name.text);
            return self.fault(message, "rename the index in the definition", e.span);
        }
        let values: BTreeMap<&str, &Expr> = parameters.iter().map(|p| p.text.as_str()).zip(arguments).collect();
        let mut written = value.clone();
        walk::substitute(&mut written, &values);
        if walk::depth(&written) > DEPTH_LIMIT {
            return self.limit("levels of definitions put in", DEPTH_LIMIT, e.span);
        }
        e.kind = written.kind;
    }
}
