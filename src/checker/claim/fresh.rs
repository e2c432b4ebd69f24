//! Names that the reader makes: for cosines and sines, floors, powers of matrices, what grows.
//!
//! Contract: one allocator serves a claim. It knows every name of the claim as its author wrote it, declared, bound or used, and
//! every name that it made before. So no name that is made stands for anything else, nor looks like another in print.

use super::preamble::declared;
use super::print::Style;
use super::syntax::*;
use super::walk;
use std::collections::BTreeSet;

/// The allocator of one claim.
#[derive(Clone)]
pub(super) struct Fresh {
    /// The taken names by their printed form.
    taken: BTreeSet<String>,
    /// The names that were made, and what each stands for.
    made: Vec<(String, Expr)>,
}

impl Fresh {
    /// The allocator for a claim that is not written out yet.
    pub(super) fn of(claim: &mut Claim) -> Fresh {
        let mut names = BTreeSet::new();
        walk::expressions(claim, &mut |e| walk::names_in(e, &mut names));
        names.extend(claim.items.iter().flat_map(declared).map(|n| n.text.clone()));
        walk::bound_names(claim, &mut |name| {
            names.insert(name.to_string());
        });
        walk::all_props(claim, &mut |p| match &p.kind {
            PropKind::Limit(l) => {
                names.insert(l.variable.text.clone());
            }
            PropKind::WrittenLimit(l) => {
                names.insert(l.variable.text.clone());
            }
            _ => {}
        });
        Fresh { taken: names.iter().map(|name| printed(name)).collect(), made: Vec::new() }
    }

    /// The first free name of `wish`, `wish_2`, `wish_3`, …
    pub(super) fn name(&mut self, wish: &str) -> String {
        self.first(std::iter::once(wish.to_string()).chain((2..).map(|k| format!("{wish}_{k}"))))
    }

    /// The first free one of these names.
    pub(super) fn first(&mut self, wishes: impl Iterator<Item = String>) -> String {
        let name = { wishes }.find(|name| self.is_free(name)).unwrap_or_default();
        self.take(&name);
        name
    }

    /// Whether nothing has this name.
    pub(super) fn is_free(&self, name: &str) -> bool {
        !self.taken.contains(&printed(name))
    }

    /// Takes a free name.
    pub(super) fn take(&mut self, name: &str) {
        self.taken.insert(printed(name));
    }

    /// Notes what a name that was made stands for.
    pub(super) fn means(&mut self, name: &str, meaning: Expr) {
        self.made.push((name.to_string(), meaning));
    }

    /// The names with their meanings.
    pub(super) fn made(self) -> Vec<(String, Expr)> {
        self.made
    }
}

fn printed(name: &str) -> String {
    Style::Latex.name(name)
}
