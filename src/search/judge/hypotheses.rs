//! Which hypotheses a proof needs, and which rule carries it, read off the certificate that the kernel accepted.

use crate::certificate::{Certificate, Label, Rule, Show, Step, needed};
use crate::claim::definedness::{Need, needs};
use crate::claim::syntax::{Claim, Expr, Item, Name, Prop, PropKind, Relation};
use crate::claim::write_out::in_words;
use crate::claim::{print, walk};
use crate::kernel::names::{names_in, names_in_prop};
use crate::kernel::statement::{constraints, name};
use crate::kernel::{Accepted, domains, text};
use std::collections::BTreeSet;

/// The hypotheses that are needed, and those that are stated and not needed. What the reader added to say what its own names
/// mean, such as `cos(x)^2 + sin(x)^2 = 1`, is not stated.
///
/// The facts `h1`, `h2`, … are in the order of the kernel: the domains of each declaration, its families last, then
/// the hypotheses.
pub(super) fn used(claim: &Claim, certificate: &Certificate, shown: &Accepted) -> (Vec<String>, Vec<String>) {
    let statement = shown.statement();
    let cited = needed(certificate).facts;
    // If the certificate has no steps, the goal is a hypothesis that no step cites.
    let goal = text::prop(&statement.goal);
    let is_goal = |prop: &Prop| certificate.steps.is_empty() && text::prop(prop) == goal;
    let relied_on = relied_on(claim, shown);
    let holds_a_name = |prop: &Prop| {
        let mut names = BTreeSet::new();
        names_in_prop(prop, &mut names);
        !names.is_disjoint(&relied_on)
    };
    let (mut used, mut unused) = (Vec::new(), Vec::new());
    let mut place = 0;
    let mut say = |text: String, always: bool, is_stated: bool| {
        place += 1;
        let label = format!("h{place}");
        let is_used = always || cited.contains(&label) || shown.assumed().contains(&label);
        match (is_used, is_stated) {
            (true, _) => used.push(text),
            (false, true) => unused.push(text),
            (false, false) => {}
        }
    };
    for binding in &statement.bindings {
        for (variable, _) in binding.names.iter().filter(|n| n.1.is_none()) {
            for domain in constraints(binding, &name(&variable.text)) {
                say(print::prop(&in_words(claim, &domain)), is_goal(&domain) || holds_a_name(&domain), true);
            }
        }
        for family in binding.names.iter().filter(|n| n.1.is_some()) {
            let mut single = binding.clone();
            single.names = vec![family.clone()];
            if !single.constraints.is_empty() {
                // That members are natural numbers is used without a citation.
                let always = binding.natural || relied_on.contains(&family.0.text);
                say(print::Style::Text.binding(&single), always, true);
            }
        }
    }
    for ((label, read), prop) in assumed(&claim.items).zip(&statement.assumptions) {
        let label = label.as_ref().map_or(String::new(), |l| format!("{}: ", l.text));
        say(
            format!("{label}{}", print::prop(&in_words(claim, prop))),
            is_goal(prop) || holds_a_name(prop),
            is_stated(claim, read),
        );
    }
    (used, unused)
}

/// The names in the conditions under which that has a value which the reader wrote as a hypothesis: b of `floor(a/b)`, and what
/// a member of a recurrence is divided by. Such a hypothesis says itself that b is not 0, so that a proof need not cite `b >= 1`. But the
/// author's floor has a value for that reason alone.
fn relied_on(claim: &Claim, shown: &Accepted) -> BTreeSet<String> {
    let statement = shown.statement();
    let natural: BTreeSet<&str> = statement
        .bindings
        .iter()
        .filter(|binding| binding.natural)
        .flat_map(|binding| binding.names.iter().map(|n| n.0.text.as_str()))
        .collect();
    let mut out = BTreeSet::new();
    for ((_, read), prop) in assumed(&claim.items).zip(&statement.assumptions) {
        let (said, is_family) = match &prop.kind {
            PropKind::ForAll(_, body) => (body.as_ref(), true),
            _ => (prop, false),
        };
        if let PropKind::Compare(sides, _) = &said.kind
            && (is_family || !is_stated(claim, read))
        {
            sides.iter().for_each(|side| in_conditions(side, &natural, &mut out));
        }
    }
    out
}

/// The names in the conditions of an expression and of its parts.
fn in_conditions(e: &Expr, natural: &BTreeSet<&str>, out: &mut BTreeSet<String>) {
    for need in needs(e, &|name| natural.contains(name)).unwrap_or_default() {
        match &need {
            Need::NotZero(a) | Need::Positive(a) | Need::NotNegative(a) | Need::Differentiable(a, ..) => {
                names_in(a, out)
            }
            Need::NotZeroOrNatural(a, b) | Need::Range(a, b) => {
                names_in(a, out);
                names_in(b, out);
            }
        }
    }
    walk::parts(e, &mut |part| in_conditions(part, natural, out));
}

/// The hypotheses among declarations, with their labels.
fn assumed(items: &[Item]) -> impl Iterator<Item = (&Option<Name>, &Prop)> {
    items.iter().filter_map(|item| match item {
        Item::Assume { label, prop } => Some((label, prop)),
        _ => None,
    })
}

/// Whether the author of a claim states a hypothesis: it stands in the text, or says of an angle in which range it lies.
fn is_stated(claim: &Claim, prop: &Prop) -> bool {
    let stands = assumed(claim.written_items()).any(|(_, written)| written.span == prop.span);
    let is_equation = match &prop.kind {
        PropKind::Compare(_, relations) => relations.iter().all(|relation| *relation == Relation::Equal),
        _ => false,
    };
    let mut names = BTreeSet::new();
    names_in_prop(prop, &mut names);
    stands || !is_equation && names.iter().all(|name| claim.meaning_of(name).is_some())
}

/// Something that a step is or is not.
type Is<'a> = dyn Fn(&Show) -> bool + 'a;

/// The rule that carries a proof, the most telling of those used.
pub(super) fn method(certificate: &Certificate, shown: &Accepted) -> &'static str {
    let steps: Vec<&Show> = certificate.steps.iter().filter_map(Step::show).collect();
    let any = |is: &dyn Fn(&Show) -> bool| steps.iter().any(|step| is(step));
    let families = families(shown);
    let order: [(&Is, &str); 13] = [
        (
            &|s| {
                matches!(
                    s.rule,
                    Rule::Limit { .. } | Rule::Squeeze { .. } | Rule::Along { .. } | Rule::Eventually { .. }
                )
            },
            "limit",
        ),
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
