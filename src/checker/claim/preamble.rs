//! The preamble: declarations that the claims of a file, or of a folder, share.
//!
//! A file may begin with clauses before its first claim; the file [`FILE`] of a folder says them for all claim files
//! beside it. Contract: a claim takes from the preamble the declarations of its free names and every hypothesis about such
//! a name, and in turn the declarations that these mention. What is left out mentions other variables only. A name of the
//! preamble has one meaning in all claims: none may declare it again.

use super::check;
use super::diagnostic::{Diagnostic, Fault};
use super::syntax::*;
use super::walk;
use std::collections::{BTreeMap, BTreeSet};

/// The file whose preamble holds for all claim files of its folder.
pub const FILE: &str = "paper.claim";

/// The shared clauses.
#[derive(Clone, Debug, Default)]
pub struct Preamble {
    /// `paper "…"`: the title.
    pub paper: Option<String>,
    /// `source "…"`, for claims that have none of their own.
    pub source: Option<String>,
    /// `section "…"`, for claims that have none of their own.
    pub section: Option<String>,
    /// `reading …`, for claims that say none.
    pub reading: Option<Reading>,
    /// Declarations and hypotheses in order.
    pub items: Vec<Item>,
    /// The names that it declares.
    pub names: BTreeSet<String>,
    /// Its names, by their printed form.
    pub printed: BTreeMap<String, String>,
    /// Whether the file has a clause before its first claim.
    pub is_said: bool,
}

/// A declaration or hypothesis, with the names that it declares and those that it mentions.
struct Shared<'a> {
    item: &'a Item,
    declares: BTreeSet<&'a str>,
    speaks_of: BTreeSet<String>,
}

impl Preamble {
    /// Inserts the needed items of the preamble before a claim's own declarations.
    pub(crate) fn put_before(&self, claim: &mut Claim, faults: &mut Vec<Diagnostic>) {
        let or = |own: &mut Option<String>, shared: &Option<String>| {
            if own.is_none() {
                own.clone_from(shared);
            }
        };
        or(&mut claim.paper, &self.paper);
        or(&mut claim.source, &self.source);
        or(&mut claim.section, &self.section);
        claim.reading = claim.reading.or(self.reading);
        for name in claim.items.iter().flat_map(declared).filter(|n| self.names.contains(&n.text)) {
            let message = format!("the preamble already declares {}", name.text);
            let help = Some("give it another name here, or take it out of the preamble".to_string());
            faults.push(Diagnostic::new(Fault::Other { message, help }, name.span));
        }
        let list = self.shared();
        let mut wanted: BTreeSet<String> = check::undeclared(claim);
        let mut labels = BTreeSet::new();
        walk::cited_facts(&claim.proof, &mut |label| {
            labels.insert(label.to_string());
        });
        let mut taken = vec![false; list.len()];
        // Each round takes one more declaration or hypothesis.
        while let Some(place) = (0..list.len()).find(|place| !taken[*place] && list[*place].is_wanted(&wanted, &labels))
        {
            taken[place] = true;
            wanted.extend(list[place].speaks_of.iter().cloned());
        }
        let items = list.iter().zip(taken).filter(|(_, taken)| *taken);
        let mut items: Vec<Item> = items.map(|(shared, _)| shared.only(&wanted)).collect();
        items.append(&mut claim.items);
        claim.items = items;
    }
}

impl Preamble {
    /// The items. A hypothesis mentions all names that occur in the definitions it uses.
    fn shared(&self) -> Vec<Shared<'_>> {
        let mut list: Vec<Shared> = self.items.iter().map(Shared::of).collect();
        for place in 0..list.len() {
            let mut speaks_of = list[place].speaks_of.clone();
            // A definition mentions earlier names only, so one pass from the end follows them all.
            for before in list[..place].iter().rev() {
                let is_definition = matches!(before.item, Item::Let { .. } | Item::Define { .. });
                if is_definition && before.declares.iter().any(|name| speaks_of.contains(*name)) {
                    speaks_of.extend(before.speaks_of.iter().cloned());
                }
            }
            list[place].speaks_of = speaks_of;
        }
        list
    }
}

impl<'a> Shared<'a> {
    fn of(item: &'a Item) -> Shared<'a> {
        let declares: BTreeSet<&str> = declared(item).into_iter().map(|n| n.text.as_str()).collect();
        Shared { item, declares, speaks_of: check::names_of(item) }
    }

    fn is_wanted(&self, wanted: &BTreeSet<String>, labels: &BTreeSet<String>) -> bool {
        match self.item {
            Item::Assume { label, .. } => {
                let cited = label.as_ref().is_some_and(|label| labels.contains(&label.text));
                cited || self.speaks_of.is_empty() || self.speaks_of.iter().any(|name| wanted.contains(name))
            }
            _ => self.declares.iter().any(|name| wanted.contains(*name)),
        }
    }

    /// The item; of a `given` the names that are wanted.
    fn only(&self, wanted: &BTreeSet<String>) -> Item {
        let Item::Given(bindings) = self.item else { return self.item.clone() };
        let some = bindings.iter().filter_map(|binding| {
            let names: Vec<_> = binding.names.iter().filter(|n| wanted.contains(&n.0.text)).cloned().collect();
            (!names.is_empty()).then(|| Binding { names, ..binding.clone() })
        });
        Item::Given(some.collect())
    }
}

/// The names that an item declares.
pub(crate) fn declared(item: &Item) -> Vec<&Name> {
    match item {
        Item::Given(bindings) => bindings.iter().flat_map(|b| b.names.iter().map(|n| &n.0)).collect(),
        Item::Let { name, .. } | Item::Define { name, .. } => vec![name],
        Item::Assume { .. } => Vec::new(),
    }
}

/// The names that stand for several values in one claim, and are not declared for the whole of it: indices, what quantifiers
/// and extrema bind, parameters of definitions.
pub(crate) fn bound_in(claim: &mut Claim) -> BTreeSet<String> {
    let own: BTreeSet<String> = claim.items.iter().flat_map(declared).map(|n| n.text.clone()).collect();
    let mut bound = BTreeSet::new();
    walk::expressions(claim, &mut |e| walk::indices(e, &mut bound));
    walk::bound_names(claim, &mut |name| {
        // The names under `given` are bound for the whole claim.
        if !own.contains(name) {
            bound.insert(name.to_string());
        }
    });
    bound
}

/// The names among these that take an argument: definitions with parameters, families and sequences.
pub(crate) fn applied(item: &Item) -> Vec<&Name> {
    match item {
        Item::Given(bindings) => {
            bindings.iter().flat_map(|b| &b.names).filter(|n| n.1.is_some()).map(|n| &n.0).collect()
        }
        Item::Let { name, parameters, .. } if !parameters.is_empty() => vec![name],
        Item::Define { name, .. } => vec![name],
        Item::Let { .. } | Item::Assume { .. } => Vec::new(),
    }
}
