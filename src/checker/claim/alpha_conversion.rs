//! Alpha conversion: a parameter or an index of a declaration that has the name of something declared beside it.
//!
//! `given n natural` and `let S(n) = sum(k = 1..n, k)`: in the definition n is its parameter, as in every textbook. Such a parameter
//! gets a name of its own before names are looked up, so that a name has one meaning at a place everywhere behind this file.
//! A definition says the same with any name for its parameter, and so does a recurrence with any name for its index. What is
//! no renaming is left as it is, and the check of names reports it: a parameter that the body binds again, or applies.

use super::preamble::declared;
use super::print::Style;
use super::syntax::*;
use super::walk;
use std::collections::BTreeSet;

/// Gives the parameters and indices of these declarations names that no name of them has.
pub(super) fn convert(items: &mut [Item]) {
    let outside: BTreeSet<String> = items.iter().flat_map(declared).map(|name| name.text.clone()).collect();
    let mut taken: BTreeSet<String> = outside.iter().map(|name| Style::Latex.name(name)).collect();
    for item in items {
        let mut inside = BTreeSet::new();
        walk::of_item(item, &mut |e| walk::names_in(e, &mut inside));
        taken.extend(inside.iter().map(|name| Style::Latex.name(name)));
        let (bound, body): (&mut [Name], &mut Expr) = match item {
            Item::Let { parameters, value, .. } => (parameters, value),
            Item::Define { index, step, .. } => (std::slice::from_mut(index), step),
            Item::Given(_) | Item::Assume { .. } => continue,
        };
        for name in bound {
            if outside.contains(&name.text) && name.text != PI && is_free(&name.text, body) {
                let fresh =
                    (2..).map(|k| format!("{}_{k}", name.text)).find(|new| taken.insert(Style::Latex.name(new)));
                let fresh = fresh.unwrap_or_default();
                rename(&name.text, &fresh, body);
                name.text = fresh;
            }
        }
    }
}

/// Whether a name stands in an expression for a number alone: nothing in it binds the name or applies it.
fn is_free(name: &str, e: &Expr) -> bool {
    let here = match &e.kind {
        ExprKind::Apply(function, _) => function.text != name,
        ExprKind::SumOver(index, _) | ExprKind::ProductOver(index, _) | ExprKind::IntegralOver(index, _) => {
            index.name.text != name
        }
        _ => true,
    };
    let mut all = here;
    walk::parts(e, &mut |part| all = all && is_free(name, part));
    all
}

/// Writes another name for one that nothing in the expression binds.
fn rename(name: &str, new: &str, e: &mut Expr) {
    match &mut e.kind {
        ExprKind::Name(text) if text == name => *text = new.to_string(),
        ExprKind::Derivative(_, by) => {
            by.iter_mut().filter(|variable| variable.text == name).for_each(|variable| variable.text = new.to_string());
        }
        _ => {}
    }
    walk::parts_mut(e, &mut |part| rename(name, new, part));
}
