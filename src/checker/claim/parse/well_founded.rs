//! Whether the members of sequences are defined by those before them.
//!
//! Contract: a step `u(k + s) = B` may use a member at `k + c` with c < s, one that a sum or product over an index reaches below that,
//! and a first value. It may use a member of another sequence at `k + s` if no circle of such uses begins there. Everything else is
//! refused: `V(k + 2) = V(k + 2) + 1` defines nothing.

use super::super::walk;
use super::define::Equation;
use super::*;

/// A member that an equation defines: its name, and its place from the index of the step on, or from 0.
type Level<'e> = (&'e str, i64);

/// An index as `k`, or not, plus a number, less indices of sums and products.
#[derive(Default)]
struct Place {
    steps: i64,
    number: i64,
    /// Names that are added, each as often as it stands there; negative where it is taken away.
    others: Vec<(String, Sign)>,
}

/// A fault of the first equation that is defined by itself, or by what comes after it.
pub(super) fn fault(equations: &[Equation]) -> Option<Diagnostic> {
    let mut uses: Vec<(Level<'_>, Vec<Level<'_>>)> = Vec::new();
    for equation in equations {
        let mut found = Vec::new();
        let mut bound = Vec::new();
        if let Err(span) = members(&equation.value, equation, equations, &mut bound, &mut found) {
            return Some(refused(equation, span));
        }
        uses.push(((&equation.name.text, equation.last()), found));
    }
    // What is used at the same place must be defined without a way back.
    for (place, equation) in equations.iter().enumerate() {
        let mut open: Vec<Level<'_>> = uses[place].1.clone();
        let mut seen = BTreeSet::new();
        while let Some(level) = open.pop() {
            if level == uses[place].0 {
                return Some(refused(equation, equation.span));
            }
            if seen.insert(level) {
                let of_level = |(at, _): &&(Level<'_>, Vec<Level<'_>>)| *at == level;
                let kind = |other: &Equation| other.index.is_some() == equation.index.is_some();
                let same = uses.iter().zip(equations).filter(|(_, other)| kind(other)).map(|(used, _)| used);
                open.extend(same.filter(of_level).flat_map(|(_, used)| used.iter().copied()));
            }
        }
    }
    None
}

fn refused(equation: &Equation, span: Span) -> Diagnostic {
    let name = &equation.name.text;
    let message = format!("{name} is not defined by the members before it");
    let last = equation.last();
    let help = match &equation.index {
        Some(index) => {
            format!("the step to {name}({0} + {last}) may use members up to {0} + {1}", index.text, last - 1)
        }
        None => format!("write the first values of {name} without members that come later"),
    };
    Diagnostic::new(Fault::Other { message, help: Some(help) }, span)
}

/// The members at the same place as the one that is defined. The place of one that is not known to come before is an error.
fn members<'e>(
    e: &'e Expr,
    equation: &Equation,
    equations: &'e [Equation],
    bound: &mut Vec<&'e Index>,
    found: &mut Vec<Level<'e>>,
) -> Result<(), Span> {
    match &e.kind {
        ExprKind::SumOver(index, body) | ExprKind::ProductOver(index, body) | ExprKind::IntegralOver(index, body) => {
            members(&index.from, equation, equations, bound, found)?;
            members(&index.to, equation, equations, bound, found)?;
            bound.push(index);
            members(body, equation, equations, bound, found)?;
            bound.pop();
            return Ok(());
        }
        ExprKind::Apply(name, arguments) => {
            let of = equations.iter().find(|other| other.name == *name && other.index.is_some());
            if let (Some(of), [argument]) = (of, arguments.as_slice())
                && let Some(level) = same_place(argument, equation, of, bound).ok_or(e.span)?
            {
                found.push((&of.name.text, level));
            }
        }
        _ => {}
    }
    let mut result = Ok(());
    walk::parts(e, &mut |part| {
        if result.is_ok() {
            result = members(part, equation, equations, bound, found);
        }
    });
    result
}

/// `Some(None)` for a member that comes before, `Some(level)` for one at the same place, `None` for any other.
fn same_place(argument: &Expr, equation: &Equation, of: &Equation, bound: &[&Index]) -> Option<Option<i64>> {
    let mut place = Place::default();
    add(argument, Sign::Plus, equation, &mut place)?;
    // An index that is added is at most the end of its range; one that is taken away is at least 0.
    for (name, sign) in std::mem::take(&mut place.others) {
        let index = bound.iter().rev().find(|index| index.name.text == name)?;
        match sign {
            Sign::Plus => add(&index.to, Sign::Plus, equation, &mut place)?,
            Sign::Minus if matches!(index.from.kind, ExprKind::Number(_)) => {}
            Sign::Minus => return None,
        }
    }
    if !place.others.is_empty() {
        return None;
    }
    let (is_step, last) = (equation.index.is_some(), equation.last());
    match (place.steps, place.number) {
        // A first value.
        (0, number) if number < of.last() && (is_step || number < last) => Some(None),
        (0, number) if number < of.last() && number == last => Some(Some(number)),
        (1, number) if number < last => Some(None),
        (1, number) if number == last => Some(Some(number)),
        _ => None,
    }
}

/// Adds an expression to a place; `None` where it is no sum of names and numbers.
fn add(e: &Expr, sign: Sign, equation: &Equation, place: &mut Place) -> Option<()> {
    let times = if sign == Sign::Plus { 1 } else { -1 };
    match &e.kind {
        ExprKind::Number(text) => place.number = place.number.checked_add(times * text.parse::<i64>().ok()?)?,
        ExprKind::Name(name) if equation.index.as_ref().is_some_and(|index| index.text == *name) => {
            place.steps += times
        }
        ExprKind::Name(name) => place.others.push((name.clone(), sign)),
        ExprKind::Sum(list) => {
            for (own, part) in list {
                let sign = if *own == sign { Sign::Plus } else { Sign::Minus };
                add(part, sign, equation, place)?;
            }
        }
        _ => return None,
    }
    Some(())
}
