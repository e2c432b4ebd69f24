//! Definitions with parameters that use sin, cos or tan, such as `let R(a) = [cos(a), …]`, put in where they are applied.

use super::{NODES_LIMIT, Writer};
use crate::claim::substitution::Substitution;
use crate::claim::syntax::*;
use crate::claim::walk;

impl Writer<'_> {
    /// Puts these definitions in, and removes them from the claim.
    pub(super) fn put_in_functions(&mut self, claim: &mut Claim) {
        let mut functions = Substitution::default();
        let mut are_some = false;
        for mut item in std::mem::take(&mut claim.items) {
            if are_some {
                walk::of_item(&mut item, &mut |e| self.put_in(e, &functions));
            }
            match item {
                Item::Let { name, parameters, value } if !parameters.is_empty() && self.has_function(&value) => {
                    functions.define(&name.text, parameters.into_iter().map(|p| p.text).collect(), value);
                    are_some = true;
                }
                item => claim.items.push(item),
            }
        }
        if are_some {
            walk::expressions(claim, &mut |e| self.put_in(e, &functions));
        }
    }

    /// Puts them in within one expression.
    fn put_in(&mut self, e: &mut Expr, functions: &Substitution) {
        if !self.is_possible {
            return;
        }
        match functions.expr(e) {
            Ok(written) => *e = written,
            Err(_) => return self.give_up(),
        }
        self.nodes += walk::nodes_in(e);
        if self.nodes > NODES_LIMIT {
            self.give_up();
        }
    }
}
