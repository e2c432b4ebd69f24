//! Which hypotheses a proof needs, and which rule carries it, read off what the kernel accepted.

use crate::certificate::{Certificate, Rule, Step};
use crate::claim::print;
use crate::claim::syntax::{Claim, Item, PropKind, Relation};
use crate::kernel::Accepted;
use crate::kernel::marks::Source;
use crate::kernel::statement::{constraints, name};

/// The hypotheses that are needed, and those that are stated and not needed.
pub fn used(claim: &Claim, shown: &Accepted) -> (Vec<String>, Vec<String>) {
    let statement = shown.statement();
    let (mut used, mut unused) = (Vec::new(), Vec::new());
    let mut say = |text: String, source: Source| {
        if shown.needed().contains(&source) { used.push(text) } else { unused.push(text) }
    };
    let mut place = 0;
    for (at, binding) in statement.bindings.iter().enumerate() {
        for (variable, _) in binding.names.iter().filter(|n| n.1.is_none()) {
            for domain in constraints(binding, &name(&variable.text)) {
                say(print::prop(&domain), Source::Hypothesis(place));
                place += 1;
            }
        }
        for family in binding.names.iter().filter(|n| n.1.is_some()) {
            let mut single = binding.clone();
            single.names = vec![family.clone()];
            if !single.constraints.is_empty() {
                say(print::Style::Text.binding(&single), Source::Binding(at));
            }
        }
    }
    let labels = claim.items.iter().filter_map(|item| match item {
        Item::Assume { label, .. } => Some(label),
        _ => None,
    });
    for (label, prop) in labels.zip(&statement.assumptions) {
        let label = label.as_ref().map_or(String::new(), |l| format!("{}: ", l.text));
        say(format!("{label}{}", print::prop(prop)), Source::Hypothesis(place));
        place += 1;
    }
    (used, unused)
}

/// The rule that carries a proof, the most telling of those used.
pub fn method(certificate: &Certificate) -> &'static str {
    const ORDER: &[(&[Rule], &str)] = &[
        (&[Rule::Limit, Rule::Squeeze], "limit"),
        (&[Rule::Extremum], "extremum"),
        (&[Rule::Induction], "induction"),
        (&[Rule::Mean], "mean inequality"),
        (&[Rule::Witness], "witness"),
        (&[Rule::Equivalent], "equivalence"),
        (&[Rule::Instance], "instance"),
        (&[Rule::Monotone], "power"),
        (&[Rule::Cases], "cases"),
    ];
    // What a logarithm or a definition lets be written otherwise is not eliminated.
    let of = |label: &String| certificate.steps.iter().find(|step| step.label == *label).map(|step| step.rule);
    let eliminates = |step: &Step| {
        let written = step.from.first().and_then(of);
        step.rule == Rule::Replace && !matches!(written, Some(Rule::Logarithm | Rule::Unfold))
    };
    let has = |rules: &[Rule]| certificate.steps.iter().any(|step| rules.contains(&step.rule));
    let equations = |step: &Step| match step.prop.as_ref().map(|p| &p.kind) {
        Some(PropKind::Compare(_, relations)) => relations.iter().all(|r| *r == Relation::Equal),
        _ => true,
    };
    match ORDER.iter().find(|(rules, _)| has(rules)) {
        Some((_, method)) => method,
        None if certificate.steps.iter().any(eliminates) => "elimination",
        None if !has(&[Rule::Sign, Rule::Combination]) => "logic",
        None if certificate.steps.last().is_some_and(equations) => "identity",
        None => "sign",
    }
}
