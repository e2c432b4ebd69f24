//! Quantifiers over linear comparisons of real numbers, eliminated by virtual substitution.
//!
//! Method (Loos and Weispfenning, "Applying linear quantifier elimination", 1993): `exists x: P` holds iff P holds at −∞, at a
//! bound of x from below that P allows, or right after one that it does not allow. A `for all` is the opposite of an `exists`.
//! Values of x come from the bounds (Ferrante and Rackoff, 1975): if P holds anywhere, it
//! holds at a bound, between two bounds, or 1 beyond one.
//!
//! Contract: nothing here is trusted. [`Formula`] has polynomials in letters; those that are eliminated occur linearly with a number
//! before them, and other letters and products of them stand for any real numbers.
//!
//! Limits: [`ATOMS`] in a formula and [`PROGRAMS`] linear programs; beyond them there is no answer.

use super::products::{Kind, Known, contradiction};
use crate::algebra::Polynomial;
use malachite::Rational;

/// The most atoms of a formula.
const ATOMS: usize = 3_000;

/// The most linear programs of one decision.
pub(super) const PROGRAMS: usize = 1_500;

/// What an atom says of its polynomial.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sense {
    /// It is 0.
    Zero,
    /// It is not 0.
    NotZero,
    /// It is positive.
    Positive,
    /// It is not negative.
    NotNegative,
}

/// A formula in which negations are carried out.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Formula {
    /// A comparison with 0.
    Atom(Polynomial, Sense),
    /// All of these; true without any.
    And(Vec<Formula>),
    /// One of these; false without any.
    Or(Vec<Formula>),
    /// Of conditions of which exactly one holds, what holds with it. Its opposite has the same conditions.
    Cases(Vec<(Formula, Formula)>),
    /// For some value of this letter.
    Exists(u32, Box<Formula>),
    /// For all values of this letter.
    All(u32, Box<Formula>),
}

use Formula::{All, And, Atom, Cases, Exists, Or};

/// A comparison with 0, true or false where it is one of numbers.
pub(super) fn atom(p: Polynomial, sense: Sense) -> Formula {
    let Some(c) = p.as_constant() else { return Atom(p, sense) };
    let holds = match sense {
        Sense::Zero => c == 0,
        Sense::NotZero => c != 0,
        Sense::Positive => c > 0,
        Sense::NotNegative => c >= 0,
    };
    if holds { And(Vec::new()) } else { Or(Vec::new()) }
}

/// The conjunction or disjunction of formulas, without parts that say nothing.
pub(super) fn joined(list: Vec<Formula>, all: bool) -> Formula {
    let mut out: Vec<Formula> = Vec::new();
    for f in list {
        let parts = match f {
            And(parts) if all => parts,
            Or(parts) if !all => parts,
            other => vec![other],
        };
        for f in parts {
            match &f {
                And(parts) | Or(parts) if parts.is_empty() => return f,
                _ if out.contains(&f) => {}
                _ => out.push(f),
            }
        }
    }
    match out.len() {
        1 => out.swap_remove(0),
        _ if all => And(out),
        _ => Or(out),
    }
}

/// All of these.
pub(super) fn and(list: Vec<Formula>) -> Formula {
    joined(list, true)
}

/// One of these.
pub(super) fn or(list: Vec<Formula>) -> Formula {
    joined(list, false)
}

/// Cases without those whose condition is false.
pub(super) fn cases(list: impl Iterator<Item = (Formula, Formula)>) -> Formula {
    let mut out: Vec<(Formula, Formula)> = Vec::new();
    for (condition, f) in list {
        match &condition {
            And(parts) if parts.is_empty() => return f,
            Or(parts) if parts.is_empty() => {}
            _ => out.push((condition, f)),
        }
    }
    if out.iter().all(|(_, f)| *f == out[0].1) && !out.is_empty() {
        return out.swap_remove(0).1;
    }
    Cases(out)
}

/// The cases as a disjunction.
fn spelled(list: &[(Formula, Formula)]) -> Formula {
    or(list.iter().map(|(condition, f)| and(vec![condition.clone(), f.clone()])).collect())
}

/// The opposite of a formula.
pub(super) fn not(f: &Formula) -> Formula {
    match f {
        Atom(p, Sense::Zero) => Atom(p.clone(), Sense::NotZero),
        Atom(p, Sense::NotZero) => Atom(p.clone(), Sense::Zero),
        Atom(p, Sense::Positive) => Atom(p.neg(), Sense::NotNegative),
        Atom(p, Sense::NotNegative) => Atom(p.neg(), Sense::Positive),
        And(list) => or(list.iter().map(not).collect()),
        Or(list) => and(list.iter().map(not).collect()),
        Cases(list) => cases(list.iter().map(|(condition, f)| (condition.clone(), not(f)))),
        Exists(x, body) => All(*x, Box::new(not(body))),
        All(x, body) => Exists(*x, Box::new(not(body))),
    }
}

fn atoms<'f>(f: &'f Formula, out: &mut Vec<(&'f Polynomial, Sense)>) {
    match f {
        Atom(p, sense) => out.push((p, *sense)),
        And(list) | Or(list) => list.iter().for_each(|f| atoms(f, out)),
        Cases(list) => list.iter().for_each(|(condition, f)| [condition, f].into_iter().for_each(|f| atoms(f, out))),
        Exists(_, body) | All(_, body) => atoms(body, out),
    }
}

/// A formula with another in the place of each atom.
fn mapped(f: &Formula, of: &dyn Fn(&Polynomial, Sense) -> Formula) -> Formula {
    match f {
        Atom(p, sense) => of(p, *sense),
        And(list) => and(list.iter().map(|f| mapped(f, of)).collect()),
        Or(list) => or(list.iter().map(|f| mapped(f, of)).collect()),
        Cases(list) => cases(list.iter().map(|(condition, f)| (mapped(condition, of), mapped(f, of)))),
        Exists(x, body) => Exists(*x, Box::new(mapped(body, of))),
        All(x, body) => All(*x, Box::new(mapped(body, of))),
    }
}

/// c and the value s with p = c·(x − s), where x occurs linearly in p with a number before it; `None` without x.
///
/// # Errors
/// x occurs otherwise.
fn bound(p: &Polynomial, x: u32) -> Result<Option<(Rational, Polynomial)>, ()> {
    let parts = p.coefficients_in(x);
    match parts.as_slice() {
        [rest, slope] => {
            let c = slope.as_constant().ok_or(())?;
            let value = rest.scale(&(Rational::from(-1) / &c));
            Ok(Some((c, value)))
        }
        [] | [_] => Ok(None),
        _ => Err(()),
    }
}

/// A polynomial with a value for a letter that occurs linearly.
fn put(p: &Polynomial, x: u32, value: &Polynomial) -> Polynomial {
    match p.coefficients_in(x).as_slice() {
        [rest, slope] => rest.add(&slope.mul(value)),
        _ => p.clone(),
    }
}

/// A formula with a value for a letter.
pub(super) fn at(f: &Formula, x: u32, value: &Polynomial) -> Formula {
    mapped(f, &|p, sense| atom(put(p, x, value), sense))
}

/// Where an `exists` is tried.
enum Place {
    /// Beyond all numbers, in this direction.
    Beyond(i32),
    /// At a value.
    At(Polynomial),
    /// As near as one likes to a value, in this direction.
    Near(Polynomial, i32),
}

/// A formula at a place.
fn there(f: &Formula, x: u32, place: &Place) -> Formula {
    mapped(f, &|p, sense| {
        let Ok(Some((c, _))) = bound(p, x) else { return Atom(p.clone(), sense) };
        let (value, direction) = match place {
            Place::At(value) => return atom(put(p, x, value), sense),
            Place::Beyond(direction) => (None, *direction),
            Place::Near(value, direction) => (Some(value), *direction),
        };
        let up = (c > 0) == (direction > 0);
        match (sense, value) {
            (Sense::Zero, _) => Or(Vec::new()),
            (Sense::NotZero, _) => And(Vec::new()),
            (_, None) => {
                if up {
                    And(Vec::new())
                } else {
                    Or(Vec::new())
                }
            }
            (_, Some(value)) => atom(put(p, x, value), if up { Sense::NotNegative } else { Sense::Positive }),
        }
    })
}

/// A formula without quantifiers that says the same.
pub(super) fn eliminated(f: &Formula) -> Option<Formula> {
    let out = match f {
        Atom(..) => f.clone(),
        And(list) => and(list.iter().map(eliminated).collect::<Option<_>>()?),
        Or(list) => or(list.iter().map(eliminated).collect::<Option<_>>()?),
        // Conditions have no quantifiers.
        Cases(list) => {
            let inner = list.iter().map(|(condition, f)| Some((condition.clone(), eliminated(f)?)));
            cases(inner.collect::<Option<Vec<_>>>()?.into_iter())
        }
        All(x, body) => not(&eliminated(&Exists(*x, Box::new(not(body))))?),
        Exists(x, body) => {
            let body = eliminated(body)?;
            match body {
                // Some part of a disjunction holds somewhere.
                Or(list) => or(list.iter().map(|f| somewhere(f, *x)).collect::<Option<_>>()?),
                body => somewhere(&body, *x)?,
            }
        }
    };
    let mut all = Vec::new();
    atoms(&out, &mut all);
    (all.len() <= ATOMS).then_some(out)
}

/// That a formula without quantifiers holds for some value of x.
fn somewhere(f: &Formula, x: u32) -> Option<Formula> {
    let mut all = Vec::new();
    atoms(f, &mut all);
    let mut both: [Vec<Place>; 2] = [vec![Place::Beyond(-1)], vec![Place::Beyond(1)]];
    let mut seen: Vec<(Polynomial, Sense, bool)> = Vec::new();
    for (p, sense) in all {
        let Some((c, value)) = bound(p, x).ok()? else { continue };
        let lower = c > 0;
        if seen.contains(&(value.clone(), sense, lower)) {
            continue;
        }
        seen.push((value.clone(), sense, lower));
        for (side, places) in both.iter_mut().enumerate() {
            let direction = if side == 0 { 1 } else { -1 };
            match sense {
                Sense::Zero => places.push(Place::At(value.clone())),
                Sense::NotZero => places.push(Place::Near(value.clone(), direction)),
                Sense::NotNegative if lower == (side == 0) => places.push(Place::At(value.clone())),
                Sense::Positive if lower == (side == 0) => places.push(Place::Near(value.clone(), direction)),
                _ => {}
            }
        }
    }
    let [below, above] = both;
    let places = if below.len() <= above.len() { below } else { above };
    Some(or(places.iter().map(|place| there(f, x, place)).collect()))
}

/// Values of x at one of which a formula holds if it holds anywhere: simple ones first.
pub(super) fn candidates(f: &Formula, x: u32) -> Vec<Polynomial> {
    let mut all = Vec::new();
    atoms(f, &mut all);
    let mut bounds: Vec<Polynomial> = Vec::new();
    for (p, _) in all {
        if let Ok(Some((_, value))) = bound(p, x)
            && !bounds.contains(&value)
        {
            bounds.push(value);
        }
    }
    bounds.sort_by_key(Polynomial::term_count);
    let mut out = bounds.clone();
    out.push(Polynomial::zero());
    for k in [1, -1] {
        out.extend(bounds.iter().map(|b| b.add(&Polynomial::integer(k))));
    }
    for (i, a) in bounds.iter().enumerate() {
        out.extend(bounds.iter().skip(i + 1).map(|b| a.add(b).scale(&Rational::from_signeds(1, 2))));
    }
    let mut unique: Vec<Polynomial> = Vec::new();
    out.retain(|p| {
        !unique.contains(p) && {
            unique.push(p.clone());
            true
        }
    });
    out
}

/// The differences of bounds of x: their signs decide which value is taken.
pub(super) fn orders(f: &Formula, x: u32) -> Vec<Polynomial> {
    let mut all = Vec::new();
    atoms(f, &mut all);
    let mut out: Vec<Polynomial> = Vec::new();
    let mut bounds: Vec<Polynomial> = Vec::new();
    for (p, _) in all {
        match bound(p, x) {
            Ok(Some((_, value))) if !bounds.contains(&value) => bounds.push(value),
            Ok(None) if !out.contains(p) && !out.contains(&p.neg()) => out.push(p.clone()),
            _ => {}
        }
    }
    for (i, a) in bounds.iter().enumerate() {
        for b in bounds.iter().skip(i + 1) {
            let d = a.sub(b);
            if !d.is_constant() && !out.contains(&d) && !out.contains(&d.neg()) {
                out.push(d);
            }
        }
    }
    out
}

/// Whether a formula without quantifiers holds for some values of its letters, each product of letters being a letter of its own.
/// `None` where the linear programs that are left do not suffice.
pub(super) fn satisfiable(f: &Formula, programs: &mut usize) -> Option<bool> {
    search(vec![Known::one()], vec![f.clone()], programs)
}

fn search(mut known: Vec<Known>, mut open: Vec<Formula>, programs: &mut usize) -> Option<bool> {
    let mut choices: Vec<Vec<Formula>> = Vec::new();
    while let Some(f) = open.pop() {
        match f {
            And(list) => open.extend(list),
            Or(list) => choices.push(list),
            Cases(list) => open.push(spelled(&list)),
            Atom(p, Sense::NotZero) => {
                choices.push(vec![Atom(p.neg(), Sense::Positive), Atom(p, Sense::Positive)]);
            }
            Atom(poly, sense) => {
                let kind = match sense {
                    Sense::Zero => Kind::Zero,
                    Sense::Positive => Kind::Strict,
                    _ => Kind::Weak,
                };
                known.push(Known { poly, kind, facts: Vec::new(), factors: Vec::new(), order: 1 });
            }
            Exists(..) | All(..) => return None,
        }
    }
    *programs = programs.checked_sub(1)?;
    if known.len() > 1 && contradiction(&known).is_some() {
        return Some(false);
    }
    let Some(place) = (0..choices.len()).min_by_key(|k| choices[*k].len()) else { return Some(true) };
    let chosen = choices.swap_remove(place);
    let rest: Vec<Formula> = choices.into_iter().map(Or).collect();
    for f in chosen {
        let mut open = rest.clone();
        open.push(f);
        if search(known.clone(), open, programs)? {
            return Some(true);
        }
    }
    Some(false)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // a test stops where it fails
mod tests {
    use super::super::formulas::Reader;
    use super::*;

    fn read(text: &str) -> Formula {
        let claims = crate::claim::parse::parse(&format!("claim t \"t\"\nprove {text}\n")).unwrap();
        Reader::default().read(&claims[0].goal, true).unwrap()
    }

    fn is_true(text: &str) -> bool {
        let f = eliminated(&read(text)).unwrap();
        satisfiable(&f, &mut PROGRAMS.clone()).unwrap()
    }

    #[test]
    fn alternating_quantifiers_are_decided() {
        for text in [
            "for all x real: exists y real: y > x",
            "exists x real: for all y < 2: 2*(y - x) <= 0",
            "for all x, y real: x < y => (exists z real: x < z < y)",
            "for all x real: exists y, z real: y + z = x and y - z > 1",
            "for all x real: (for all y > 0: x <= y) => x <= 0",
            "for all x real: exists y real: y != x and y <= x",
        ] {
            assert!(is_true(text), "{text}");
        }
        for text in [
            "exists x real: for all y real: y <= x",
            "for all x, y real: exists z real: x < z < y",
            "exists x real: x > 1 and x < 1",
            "for all x real: (for all y > 0: x <= y) => x < 0",
            "exists x real: for all y real: y != x",
        ] {
            assert!(!is_true(text), "{text}");
        }
    }

    #[test]
    fn values_that_are_proposed_hold_where_any_does() {
        let Exists(x, body) = read("exists x real: 3*x > 1 and 2*x < 1 and x != 5/12") else { panic!("exists") };
        let holds = |value: &Polynomial| at(&body, x, value) == And(Vec::new());
        assert!(candidates(&body, x).iter().any(holds));
    }
}
