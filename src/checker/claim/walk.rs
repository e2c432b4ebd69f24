//! Walks through syntax trees: the parts of an expression, the expressions of a claim, free names.

use super::syntax::*;
use std::collections::BTreeSet;

/// Calls `visit` with every direct part of an expression.
pub fn parts<'a>(expr: &'a Expr, visit: &mut dyn FnMut(&'a Expr)) {
    use ExprKind::*;
    match &expr.kind {
        Number(_) | Name(_) => {}
        Apply(_, list) => list.iter().for_each(visit),
        Negate(a) | Derivative(a, _) => visit(a),
        Sum(list) => list.iter().for_each(|(_, e)| visit(e)),
        Product(list) => list.iter().for_each(|(_, e)| visit(e)),
        Power(a, b) => {
            visit(a);
            visit(b);
        }
        SumOver(index, body) | ProductOver(index, body) | IntegralOver(index, body) => {
            visit(&index.from);
            visit(&index.to);
            visit(body);
        }
        Matrix(rows) => rows.iter().flatten().for_each(visit),
    }
}

/// The same with parts that may be changed.
pub fn parts_mut(expr: &mut Expr, visit: &mut dyn FnMut(&mut Expr)) {
    use ExprKind::*;
    match &mut expr.kind {
        Number(_) | Name(_) => {}
        Apply(_, list) => list.iter_mut().for_each(visit),
        Negate(a) | Derivative(a, _) => visit(a),
        Sum(list) => list.iter_mut().for_each(|(_, e)| visit(e)),
        Product(list) => list.iter_mut().for_each(|(_, e)| visit(e)),
        Power(a, b) => {
            visit(a);
            visit(b);
        }
        SumOver(index, body) | ProductOver(index, body) | IntegralOver(index, body) => {
            visit(&mut index.from);
            visit(&mut index.to);
            visit(body);
        }
        Matrix(rows) => rows.iter_mut().flatten().for_each(visit),
    }
}

/// The names of variables that are free in a comparison, from left to right.
pub(crate) fn free_names(prop: &Prop, visit: &mut dyn FnMut(&str, Span)) {
    fn of<'a>(e: &'a Expr, bound: &mut Vec<&'a str>, visit: &mut dyn FnMut(&str, Span)) {
        match &e.kind {
            ExprKind::Name(name) if !bound.contains(&name.as_str()) => visit(name, e.span),
            ExprKind::SumOver(index, body)
            | ExprKind::ProductOver(index, body)
            | ExprKind::IntegralOver(index, body) => {
                of(&index.from, bound, visit);
                of(&index.to, bound, visit);
                bound.push(&index.name.text);
                of(body, bound, visit);
                bound.pop();
            }
            _ => parts(e, &mut |part| of(part, bound, visit)),
        }
    }
    if let PropKind::Compare(sides, _) = &prop.kind {
        sides.iter().for_each(|side| of(side, &mut Vec::new(), visit));
    }
}

/// Calls `visit` with every expression of a claim that is no part of another.
pub(crate) fn expressions(claim: &mut Claim, visit: &mut dyn FnMut(&mut Expr)) {
    claim.items.iter_mut().for_each(|item| of_item(item, visit));
    claim.sample.iter_mut().for_each(|(_, e)| visit(e));
    of_prop(&mut claim.goal, visit);
    of_proof(&mut claim.proof, visit);
}

/// The same of one declaration.
pub(crate) fn of_item(item: &mut Item, visit: &mut dyn FnMut(&mut Expr)) {
    match item {
        Item::Given(bindings) => bindings.iter_mut().for_each(|b| of_binding(b, visit)),
        Item::Let { value, .. } => visit(value),
        Item::Define { initial, step, .. } => {
            visit(initial);
            visit(step);
        }
        Item::Assume { prop, .. } => of_prop(prop, visit),
    }
}

/// The same of a binding.
pub(crate) fn of_binding(binding: &mut Binding, visit: &mut dyn FnMut(&mut Expr)) {
    for constraint in &mut binding.constraints {
        match constraint {
            Constraint::Relation(_, e) => visit(e),
            Constraint::Interval { from, to, .. } | Constraint::Range(from, to) => {
                visit(from);
                visit(to);
            }
        }
    }
    if let Some((from, to)) = &mut binding.indices {
        visit(from);
        visit(to);
    }
}

/// Calls `visit` with a proposition and with each of its parts, the inner ones first.
pub(crate) fn props(prop: &mut Prop, visit: &mut dyn FnMut(&mut Prop)) {
    use PropKind::*;
    match &mut prop.kind {
        Compare(..) | Extremum(_) | Limit(_) | WrittenLimit(_) => {}
        And(list) | Or(list) | Equivalent(list) => list.iter_mut().for_each(|p| props(p, visit)),
        Not(p) | Exists(_, p) | ForAll(_, p) => props(p, visit),
        Implies(p, q) => {
            props(p, visit);
            props(q, visit);
        }
    }
    visit(prop);
}

/// The same for every proposition of an argument.
pub(crate) fn props_of_proof(proof: &mut Proof, visit: &mut dyn FnMut(&mut Prop)) {
    for step in &mut proof.steps {
        match step {
            Step::Have { prop, proof, .. } | Step::Case { prop, proof, .. } => {
                props(prop, visit);
                props_of_proof(proof, visit);
            }
            Step::Obtain { prop, .. } => props(prop, visit),
        }
    }
    if let Some(Method::Induction(_, step)) = &mut proof.close {
        props_of_proof(step, visit);
    }
}

/// The same for every proposition of a claim.
pub(crate) fn all_props(claim: &mut Claim, visit: &mut dyn FnMut(&mut Prop)) {
    for item in &mut claim.items {
        if let Item::Assume { prop, .. } = item {
            props(prop, visit);
        }
    }
    props(&mut claim.goal, visit);
    props_of_proof(&mut claim.proof, visit);
}

fn of_prop(prop: &mut Prop, visit: &mut dyn FnMut(&mut Expr)) {
    use PropKind::*;
    match &mut prop.kind {
        Compare(sides, _) => sides.iter_mut().for_each(visit),
        And(list) | Or(list) | Equivalent(list) => list.iter_mut().for_each(|p| of_prop(p, visit)),
        Not(p) => of_prop(p, visit),
        Implies(p, q) => {
            of_prop(p, visit);
            of_prop(q, visit);
        }
        Exists(bindings, body) | ForAll(bindings, body) => {
            bindings.iter_mut().for_each(|b| of_binding(b, visit));
            of_prop(body, visit);
        }
        Extremum(e) => {
            e.over.iter_mut().for_each(|b| of_binding(b, visit));
            visit(&mut e.of);
            e.at.iter_mut().for_each(|(_, at)| visit(at));
            visit(&mut e.value);
        }
        Limit(l) => {
            visit(&mut l.of);
            visit(&mut l.value);
        }
        WrittenLimit(l) => l.parts_mut().for_each(visit),
    }
}

fn of_proof(proof: &mut Proof, visit: &mut dyn FnMut(&mut Expr)) {
    for step in &mut proof.steps {
        match step {
            Step::Have { prop, proof, .. } | Step::Case { prop, proof, .. } => {
                of_prop(prop, visit);
                of_proof(proof, visit);
            }
            Step::Obtain { binding, prop, witness, .. } => {
                of_binding(binding, visit);
                of_prop(prop, visit);
                visit(witness);
            }
        }
    }
    match &mut proof.close {
        Some(Method::Induction(_, step)) => of_proof(step, visit),
        Some(method) => of_method(method, visit),
        None => {}
    }
}

/// The same for the arguments of a method, but not for the steps of an induction.
pub(crate) fn of_method(method: &mut Method, visit: &mut dyn FnMut(&mut Expr)) {
    match method {
        Method::Power { exponent, .. } => visit(exponent),
        Method::Product(list) => list.iter_mut().filter_map(|f| f.1.as_mut()).for_each(visit),
        Method::Mean { a, b, weight } => [a, b, weight].into_iter().for_each(visit),
        Method::Hoelder { first, second, weight } => {
            [&mut first.0, &mut first.1, &mut second.0, &mut second.1, weight].into_iter().for_each(visit);
        }
        Method::Instance { with, .. } | Method::Witness(with) => with.iter_mut().for_each(|(_, e)| visit(e)),
        Method::Squeeze { lower, upper } => {
            visit(lower);
            visit(upper);
        }
        Method::Algebra(_) | Method::Induction(..) => {}
    }
}

/// Calls `visit` with every name that quantifiers, extrema and `obtain` bind, and with the parameters and indices of
/// definitions and families.
pub(crate) fn bound_names(claim: &Claim, visit: &mut dyn FnMut(&str)) {
    fn of_bindings(bindings: &[Binding], visit: &mut dyn FnMut(&str)) {
        for (name, index) in bindings.iter().flat_map(|b| &b.names) {
            visit(&name.text);
            index.iter().for_each(|n| visit(&n.text));
        }
    }
    fn of_prop(prop: &Prop, visit: &mut dyn FnMut(&str)) {
        use PropKind::*;
        match &prop.kind {
            Compare(..) | Limit(_) | WrittenLimit(_) => {}
            And(list) | Or(list) | Equivalent(list) => list.iter().for_each(|p| of_prop(p, visit)),
            Not(p) => of_prop(p, visit),
            Implies(p, q) => {
                of_prop(p, visit);
                of_prop(q, visit);
            }
            Exists(bindings, body) | ForAll(bindings, body) => {
                of_bindings(bindings, visit);
                of_prop(body, visit);
            }
            Extremum(e) => of_bindings(&e.over, visit),
        }
    }
    fn of_proof(proof: &Proof, visit: &mut dyn FnMut(&str)) {
        for step in &proof.steps {
            match step {
                Step::Have { prop, proof, .. } | Step::Case { prop, proof, .. } => {
                    of_prop(prop, visit);
                    of_proof(proof, visit);
                }
                Step::Obtain { binding, prop, .. } => {
                    of_bindings(std::slice::from_ref(binding), visit);
                    of_prop(prop, visit);
                }
            }
        }
        if let Some(Method::Induction(_, step)) = &proof.close {
            of_proof(step, visit);
        }
    }
    for item in &claim.items {
        match item {
            Item::Given(bindings) => of_bindings(bindings, visit),
            Item::Let { parameters, .. } => parameters.iter().for_each(|n| visit(&n.text)),
            Item::Define { index, .. } => visit(&index.text),
            Item::Assume { prop, .. } => of_prop(prop, visit),
        }
    }
    of_prop(&claim.goal, visit);
    of_proof(&claim.proof, visit);
}

/// The labels of facts that an argument cites.
pub(crate) fn cited_facts(proof: &Proof, visit: &mut dyn FnMut(&str)) {
    for step in &proof.steps {
        if let Step::Have { proof, .. } | Step::Case { proof, .. } = step {
            cited_facts(proof, visit);
        }
    }
    match &proof.close {
        Some(Method::Algebra(facts)) => facts.iter().for_each(|f| visit(&f.text)),
        Some(Method::Power { fact, .. }) => visit(&fact.text),
        Some(Method::Product(list)) => list.iter().for_each(|f| visit(&f.0.text)),
        Some(Method::Instance { claim, .. }) => visit(&claim.text),
        Some(Method::Induction(_, step)) => cited_facts(step, visit),
        Some(Method::Mean { .. } | Method::Hoelder { .. } | Method::Witness(_) | Method::Squeeze { .. }) | None => {}
    }
}

/// All names that occur in an expression, bound ones and function names included.
pub fn names_in(expr: &Expr, into: &mut BTreeSet<String>) {
    match &expr.kind {
        ExprKind::Name(name) => {
            into.insert(name.clone());
        }
        ExprKind::Apply(name, _) => {
            into.insert(name.text.clone());
        }
        ExprKind::Derivative(_, by) => into.extend(by.iter().map(|n| n.text.clone())),
        ExprKind::SumOver(index, _) | ExprKind::ProductOver(index, _) | ExprKind::IntegralOver(index, _) => {
            into.insert(index.name.text.clone());
        }
        _ => {}
    }
    parts(expr, &mut |part| names_in(part, into));
}

/// The number of an expression's nodes.
pub fn nodes_in(expr: &Expr) -> usize {
    let mut count = 1;
    parts(expr, &mut |part| count += nodes_in(part));
    count
}

/// How deep an expression nests.
pub(crate) fn depth(expr: &Expr) -> usize {
    let mut deepest = 0;
    parts(expr, &mut |part| deepest = deepest.max(depth(part)));
    deepest + 1
}

/// The names that sums, products and integrals bind in an expression.
pub fn indices(e: &Expr, into: &mut BTreeSet<String>) {
    if let ExprKind::SumOver(index, _) | ExprKind::ProductOver(index, _) | ExprKind::IntegralOver(index, _) = &e.kind {
        into.insert(index.name.text.clone());
    }
    parts(e, &mut |part| indices(part, into));
}
