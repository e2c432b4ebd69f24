//! A certificate followed with the kernel: which facts each step rests on, and how the kernel reads its expressions.

use crate::certificate::{Certificate, Label, Rule, Show, Step};
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use crate::kernel::statement::{expr, numeral};
use crate::kernel::view::View;
use crate::kernel::{Accepted, Checker, Refusal, Used};
use std::collections::{BTreeMap, BTreeSet};

/// A step with the kernel's answers about it.
pub(super) struct Seen {
    /// The step.
    pub show: Show,
    /// The facts and equations that it rests on.
    pub used: Used,
    /// Of a comparison without summands: the difference of its sides.
    pub difference: Option<View>,
    /// The common value of both sides, for an equation proved by expanding.
    pub common: Option<View>,
    /// The summands of a combination that cite no fact.
    pub terms: Vec<Option<View>>,
    /// Of a comparison without summands: the products that show the signs of comparisons that it rests on.
    pub products: Vec<(Label, View)>,
    /// Of a comparison without summands: the differences of the comparisons that it rests on.
    pub known: Vec<(Label, View)>,
}

/// A step, or a block with its steps.
pub(super) enum Node {
    /// The step at this place.
    Step(usize),
    /// A block, opened by the step at this place, with the label of its conclusion.
    Block(usize, Vec<Node>, Label),
}

/// A certificate that was followed.
pub(super) struct Followed {
    /// The steps in order.
    pub seen: Vec<Seen>,
    /// How they nest.
    pub nodes: Vec<Node>,
    /// The proposition of each fact.
    pub facts: BTreeMap<Label, Prop>,
    /// The facts that a rule is applied to, or that are put in or multiplied.
    pub cited: BTreeSet<Label>,
}

/// Follows a certificate.
///
/// # Errors
/// The kernel does not take a step.
pub(super) fn follow(claim: &Claim, certificate: &Certificate, cited: &[&Accepted]) -> Result<Followed, Refusal> {
    let mut checker = Checker::new(claim, cited)?;
    let (mut seen, mut facts) = (Vec::<Seen>::new(), BTreeMap::<Label, Prop>::new());
    let mut open: Vec<(usize, Vec<Node>)> = Vec::new();
    let mut nodes = Vec::new();
    let mut directly = BTreeSet::new();
    facts.extend(checker.facts().map(|(label, prop)| (label.to_string(), (**prop).clone())));
    for step in &certificate.steps {
        match step {
            Step::Show(show) => {
                let used = checker.used(show)?;
                let (difference, terms) = views(&mut checker, show);
                let agrees = difference.as_ref().is_some_and(|d| d.factors.is_empty()) && terms.is_empty();
                let common = show.prop.single().filter(|_| agrees);
                let common = common.and_then(|(a, _, _)| checker.view_in_whole_numbers(a, show, true).ok());
                let known = if terms.is_empty() { known(&mut checker, show, &used, &facts) } else { Vec::new() };
                let products = products(&mut checker, show, &used, &seen);
                checker.step(step)?;
                if let Rule::Combination { terms, .. } = &show.rule {
                    directly.extend(terms.iter().flat_map(|t| t.facts.clone()));
                }
                directly.extend(show.rule.from().into_iter().cloned());
                directly.extend(used.using.iter().cloned());
                seen.push(Seen { show: (**show).clone(), used, difference, common, terms, known, products });
                if show.opens() {
                    open.push((seen.len() - 1, std::mem::take(&mut nodes)));
                } else {
                    nodes.push(Node::Step(seen.len() - 1));
                }
            }
            Step::End(conclusion) => {
                checker.step(step)?;
                directly.insert(conclusion.clone());
                if let Some((place, outer)) = open.pop() {
                    let inner = std::mem::replace(&mut nodes, outer);
                    nodes.push(Node::Block(place, inner, conclusion.clone()));
                }
            }
        }
        for (label, prop) in checker.facts() {
            facts.entry(label.to_string()).or_insert_with(|| (**prop).clone());
        }
    }
    checker.finish()?;
    Ok(Followed { seen, nodes, facts, cited: directly })
}

/// The expressions of a combination as the kernel reads them.
fn views(checker: &mut Checker, show: &Show) -> (Option<View>, Vec<Option<View>>) {
    let (Rule::Combination { terms, .. }, Some((a, relation, b))) = (&show.rule, show.prop.single()) else {
        return (None, Vec::new());
    };
    let difference = read(checker, &difference(a, b), show, Signs::of(relation));
    let alone = terms
        .iter()
        .map(|t| if t.facts.is_empty() { checker.view_in_whole_numbers(&t.factor, show, true).ok() } else { None });
    (difference, alone.collect())
}

/// A step that also reads signs from the facts of an earlier one.
fn with_signs(show: &Show, earlier: &Show) -> Show {
    let mut both = show.clone();
    both.by.extend(earlier.by.iter().filter(|label| !show.by.contains(label)).cloned());
    both
}

/// The products that show comparisons that a step rests on, as the kernel reads them in this step.
fn products(checker: &mut Checker, show: &Show, used: &Used, seen: &[Seen]) -> Vec<(Label, View)> {
    let mut out = Vec::new();
    for earlier in seen.iter().filter(|earlier| used.by.contains(&earlier.show.label)) {
        let Rule::Combination { terms, .. } = &earlier.show.rule else { continue };
        if let [term] = terms.as_slice()
            && term.facts.is_empty()
            && let Ok(view) = checker.view_in_whole_numbers(&term.factor, &with_signs(show, &earlier.show), true)
        {
            out.push((earlier.show.label.clone(), view));
        }
    }
    out
}

/// The differences of the comparisons that a combination rests on, as the kernel reads them there.
fn known(checker: &mut Checker, show: &Show, used: &Used, facts: &BTreeMap<Label, Prop>) -> Vec<(Label, View)> {
    if !matches!(show.rule, Rule::Combination { .. }) {
        return Vec::new();
    }
    let compared = used.by.iter().filter_map(|label| Some((label, facts.get(label)?.single()?)));
    compared
        .flat_map(|(label, (a, _, b))| {
            let e = difference(a, b);
            [true, false].map(|put_in| Some((label.clone(), checker.view_in_whole_numbers(&e, show, put_in).ok()?)))
        })
        .flatten()
        .collect()
}

/// An expression as the kernel reads it, with or without substituted equations, whichever has the proved signs.
fn read(checker: &mut Checker, e: &Expr, show: &Show, shown: Signs) -> Option<View> {
    let with = checker.view_in_whole_numbers(e, show, true).ok()?;
    if with.signs().within(shown) {
        return Some(with);
    }
    let plain = checker.view_in_whole_numbers(e, show, false).ok().filter(|plain| plain.signs().within(shown));
    Some(plain.unwrap_or(with))
}

/// a − b, or a where b is 0.
pub(super) fn difference(a: &Expr, b: &Expr) -> Expr {
    if *b == numeral(0) {
        return a.clone();
    }
    match &a.kind {
        ExprKind::Sum(terms) if !matches!(b.kind, ExprKind::Sum(_)) => {
            let mut terms = terms.clone();
            terms.push((Sign::Minus, b.clone()));
            expr(ExprKind::Sum(terms))
        }
        _ => expr(ExprKind::Sum(vec![(Sign::Plus, a.clone()), (Sign::Minus, b.clone())])),
    }
}
