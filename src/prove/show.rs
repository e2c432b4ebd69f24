//! Forms as text, close to the claim language.

use crate::algebra::form::{Atom, Exponent, Form, Poly, Ring};

/// The text of a form.
pub fn form(ring: &Ring, form: &Form) -> String {
    let (mut above, mut below) = (Vec::new(), Vec::new());
    for (atom, exponent) in &form.powers {
        let negative = exponent.order_sign().is_lt();
        let exponent = match exponent {
            Exponent::Number(q) if negative => Exponent::Number(-q),
            Exponent::Symbolic(e) if negative => Exponent::of(e.negated()),
            same => same.clone(),
        };
        let base = self::atom(ring, *atom);
        let text = match exponent {
            Exponent::Number(q) if q == 1 => base,
            Exponent::Number(q) if malachite::base::num::conversion::traits::IsInteger::is_integer(&q) => {
                format!("{base}^{q}")
            }
            Exponent::Number(q) => format!("{base}^({q})"),
            Exponent::Symbolic(e) => {
                let text = self::form(ring, &e);
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

fn atom(ring: &Ring, id: u32) -> String {
    match &*ring.atom(id) {
        Atom::Variable(name) => name.clone(),
        Atom::Member(name, index) => format!("{name}({})", form(ring, index)),
        Atom::Prime(p) => p.to_string(),
        Atom::Sum(poly) => format!("({})", sum(ring, poly)),
        Atom::Euler => "exp(1)".to_string(),
        Atom::Logarithm(inner) => format!("ln({})", atom(ring, *inner).trim_start_matches('(').trim_end_matches(')')),
        Atom::SumOver(over) | Atom::ProductOver(over) => {
            let word = if matches!(&*ring.atom(id), Atom::SumOver(_)) { "sum" } else { "product" };
            let bound = atom(ring, over.index);
            format!(
                "{word}({bound} = {}..{}, {})",
                form(ring, &over.from),
                form(ring, &over.to),
                form(ring, &over.body)
            )
        }
    }
}

fn sum(ring: &Ring, poly: &Poly) -> String {
    let mut out = String::new();
    for (i, (monomial, c)) in poly.terms.iter().enumerate() {
        let term = Form { coefficient: c.clone(), powers: monomial.clone() };
        let text = form(ring, &term);
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
