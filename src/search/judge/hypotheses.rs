//! Which hypotheses a proof needs, and which rule carries it, read off the certificate that the kernel accepted.

use crate::certificate::{Certificate, Label, Rule, Show, Step, needed};
use crate::claim::print;
use crate::claim::syntax::{Claim, Item, Prop, PropKind, Relation};
use crate::claim::write_out::in_words;
use crate::kernel::statement::{constraints, name};
use crate::kernel::{Accepted, domains, text};
use std::collections::BTreeSet;

/// The hypotheses that are needed, and those that are stated and not needed.
///
/// The facts `h1`, `h2`, … are in the order of the kernel: the domains of each declaration, its families last, then
/// the hypotheses.
pub(super) fn used(claim: &Claim, certificate: &Certificate, shown: &Accepted) -> (Vec<String>, Vec<String>) {
    let statement = shown.statement();
    let cited = needed(certificate).facts;
    // If the certificate has no steps, the goal is a hypothesis that no step cites.
    let goal = text::prop(&statement.goal);
    let is_goal = |prop: &Prop| certificate.steps.is_empty() && text::prop(prop) == goal;
    let (mut used, mut unused) = (Vec::new(), Vec::new());
    let mut place = 0;
    let mut say = |text: String, always: bool| {
        place += 1;
        let label = format!("h{place}");
        let is_used = always || cited.contains(&label) || shown.assumed().contains(&label);
        if is_used { used.push(text) } else { unused.push(text) }
    };
    for binding in &statement.bindings {
        for (variable, _) in binding.names.iter().filter(|n| n.1.is_none()) {
            for domain in constraints(binding, &name(&variable.text)) {
                say(print::prop(&in_words(claim, &domain)), is_goal(&domain));
            }
        }
        for family in binding.names.iter().filter(|n| n.1.is_some()) {
            let mut single = binding.clone();
            single.names = vec![family.clone()];
            if !single.constraints.is_empty() {
                // That members are natural numbers is used without a citation.
                say(print::Style::Text.binding(&single), binding.natural);
            }
        }
    }
    let labels = claim.items.iter().filter_map(|item| match item {
        Item::Assume { label, .. } => Some(label),
        _ => None,
    });
    for (label, prop) in labels.zip(&statement.assumptions) {
        let label = label.as_ref().map_or(String::new(), |l| format!("{}: ", l.text));
        say(format!("{label}{}", print::prop(&in_words(claim, prop))), is_goal(prop));
    }
    (used, unused)
}

/// Something that a step is or is not.
type Is<'a> = dyn Fn(&Show) -> bool + 'a;

/// The rule that carries a proof, the most telling of those used.
pub(super) fn method(certificate: &Certificate, shown: &Accepted) -> &'static str {
    let steps: Vec<&Show> = certificate.steps.iter().filter_map(Step::show).collect();
    let any = |is: &dyn Fn(&Show) -> bool| steps.iter().any(|step| is(step));
    let families = families(shown);
    let order: [(&Is, &str); 13] = [
        (&|s| matches!(s.rule, Rule::Limit { .. } | Rule::Squeeze { .. } | Rule::Eventually { .. }), "limit"),
        (&|s| matches!(s.rule, Rule::Extremum { .. }), "extremum"),
        (&|s| matches!(s.rule, Rule::Induction { .. }), "induction"),
        (&|s| matches!(s.rule, Rule::Mean { .. }), "mean inequality"),
        (&|s| matches!(s.rule, Rule::Tangent { .. }), "tangent"),
        (&|s| matches!(s.rule, Rule::Slope { .. }), "derivative"),
        (&|s| matches!(s.rule, Rule::Arc), "inverse functions"),
        (&|s| matches!(s.rule, Rule::Circle { .. }), "unit circle"),
        (&|s| matches!(s.rule, Rule::Intermediate { .. }), "intermediate value"),
        (&|s| matches!(s.rule, Rule::Witness { .. }), "witness"),
        (&|s| is_logic(s) && matches!(s.prop.kind, PropKind::Equivalent(_)), "equivalence"),
        // A member of a family lies in its domain: nothing else is put in.
        (&|s| matches!(&s.rule, Rule::Instance { source, .. } if !families.contains(source)), "instance"),
        (&|s| matches!(s.rule, Rule::Monotone { .. }), "power"),
    ];
    if let Some((_, method)) = order.iter().find(|(is, _)| any(is)) {
        return method;
    }
    let shown_by = |label: &Label| steps.iter().find(|step| step.label == *label);
    let is_case = |s: &Show| match &s.rule {
        Rule::Logic { from } => from.iter().filter_map(shown_by).any(|fact| matches!(fact.prop.kind, PropKind::Or(_))),
        _ => false,
    };
    // What a power, a name or a definition lets be written otherwise is not eliminated.
    let is_definition =
        |label: &Label| shown_by(label).is_some_and(|s| matches!(s.rule, Rule::Power | Rule::Unfold | Rule::Name));
    let is_equation = |s: &Show| match &s.prop.kind {
        PropKind::Compare(_, relations) => relations.iter().all(|r| *r == Relation::Equal),
        _ => true,
    };
    if any(&is_case) {
        "cases"
    } else if any(&|s| s.using.iter().any(|label| !is_definition(label))) {
        "elimination"
    } else if !any(&|s| matches!(s.rule, Rule::Combination { .. })) {
        "logic"
    } else if steps.last().is_some_and(|s| is_equation(s)) {
        "identity"
    } else {
        "sign"
    }
}

fn is_logic(step: &Show) -> bool {
    matches!(step.rule, Rule::Logic { .. })
}

/// The labels of the facts that say in which domain the members of families lie.
fn families(shown: &Accepted) -> BTreeSet<Label> {
    let mut place = 0;
    let mut out = BTreeSet::new();
    for binding in &shown.statement().bindings {
        for domain in domains(binding) {
            place += 1;
            if matches!(domain.kind, PropKind::ForAll(..)) {
                out.insert(format!("h{place}"));
            }
        }
    }
    out
}
