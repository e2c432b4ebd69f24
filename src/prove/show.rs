//! Forms as text, close to the claim language.

use crate::algebra::form::{Atom, Exponent, Form, Poly, Ring};
use malachite::base::num::logic::traits::SignificantBits;
use std::cell::Cell;

/// How many atoms of a form are written.
const ATOMS: usize = 5_000;

/// Numbers of more bits are not written.
const NUMBER_BITS: u64 = 100_000;

/// What stands for the rest of a form that is too long: no claim can be read from it.
const REST: &str = "…";

/// The text of a form; of a very long one a part, in which `…` stands for what is left out.
pub fn form(ring: &Ring, form: &Form) -> String {
    text(ring, form, &Cell::new(ATOMS))
}

fn text(ring: &Ring, form: &Form, room: &Cell<usize>) -> String {
    if form.coefficient.significant_bits() > NUMBER_BITS {
        return REST.to_string();
    }
    let (mut above, mut below) = (Vec::new(), Vec::new());
    for (atom, exponent) in &form.powers {
        let negative = exponent.order_sign().is_lt();
        let exponent = match exponent {
            Exponent::Number(q) if negative => Exponent::Number(-q),
            Exponent::Symbolic(e) if negative => Exponent::of(e.negated()),
            same => same.clone(),
        };
        let base = self::atom(ring, *atom, room);
        let text = match exponent {
            Exponent::Number(q) if q == 1 => base,
            Exponent::Number(q) if malachite::base::num::conversion::traits::IsInteger::is_integer(&q) => {
                format!("{base}^{q}")
            }
            Exponent::Number(q) => format!("{base}^({q})"),
            Exponent::Symbolic(e) => {
                let text = self::text(ring, &e, room);
                if text.chars().all(|c| c.is_alphanumeric()) {
                    format!("{base}^{text}")
                } else {
                    format!("{base}^({text})")
                }
            }
        };
        if negative { below.push(text) } else { above.push(text) }
    }
    let size = if form.coefficient < 0 { -&form.coefficient } else { form.coefficient.clone() };
    let (top, bottom) = (size.numerator_ref().to_string(), size.denominator_ref().to_string());
    if top != "1" || above.is_empty() {
        above.insert(0, top);
    }
    if bottom != "1" {
        below.insert(0, bottom);
    }
    let sign = if form.coefficient < 0 { "-" } else { "" };
    let above = above.join("*");
    match below.len() {
        0 => format!("{sign}{above}"),
        1 => format!("{sign}{above}/{}", below[0]),
        _ => format!("{sign}{above}/({})", below.join("*")),
    }
}

fn atom(ring: &Ring, id: u32, room: &Cell<usize>) -> String {
    match room.get().checked_sub(1) {
        Some(left) => room.set(left),
        None => return REST.to_string(),
    }
    match &*ring.atom(id) {
        Atom::Variable(name) => name.clone(),
        Atom::Member(name, index) => format!("{name}({})", text(ring, index, room)),
        Atom::Prime(p) => p.to_string(),
        Atom::Sum(poly) => format!("({})", sum(ring, poly, room)),
        Atom::Euler => "exp(1)".to_string(),
        Atom::Logarithm(inner) => match &*ring.atom(*inner) {
            Atom::Sum(poly) => format!("ln({})", sum(ring, poly, room)),
            _ => format!("ln({})", atom(ring, *inner, room)),
        },
        Atom::SumOver(over) | Atom::ProductOver(over) => {
            let word = if matches!(&*ring.atom(id), Atom::SumOver(_)) { "sum" } else { "product" };
            let bound = atom(ring, over.index, room);
            format!(
                "{word}({bound} = {}..{}, {})",
                text(ring, &over.from, room),
                text(ring, &over.to, room),
                text(ring, &over.body, room)
            )
        }
    }
}

fn sum(ring: &Ring, poly: &Poly, room: &Cell<usize>) -> String {
    let mut out = String::new();
    for (i, (monomial, c)) in poly.terms.iter().enumerate() {
        let term = Form { coefficient: c.clone(), powers: monomial.clone() };
        let text = text(ring, &term, room);
        match (i, text.strip_prefix('-')) {
            (0, _) => out.push_str(&text),
            (_, Some(rest)) => {
                out.push_str(" - ");
                out.push_str(rest);
            }
            (_, None) => {
                out.push_str(" + ");
                out.push_str(&text);
            }
        }
    }
    out
}
