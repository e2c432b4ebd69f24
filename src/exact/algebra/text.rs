//! Polynomials as text, in the notation of the claim language.

use super::{Polynomial, Var};
use malachite::Rational;
use malachite::base::num::basic::traits::{One, Zero};

impl Polynomial {
    /// The polynomial as text, with the given names.
    #[must_use]
    pub fn display(&self, name: &dyn Fn(Var) -> String) -> String {
        if self.is_zero() {
            return "0".to_owned();
        }
        let mut text = String::new();
        for (index, (monomial, coefficient)) in self.terms.iter().enumerate() {
            let negative = *coefficient < Rational::ZERO;
            text.push_str(match (index, negative) {
                (0, false) => "",
                (0, true) => "-",
                (_, false) => " + ",
                (_, true) => " - ",
            });
            let size = if negative { -coefficient } else { coefficient.clone() };
            let product = monomial.text(name);
            if product.is_empty() {
                text.push_str(&size.to_string());
            } else if size == Rational::ONE {
                text.push_str(&product);
            } else {
                text.push_str(&format!("{size}*{product}"));
            }
        }
        text
    }
}

impl std::fmt::Display for Polynomial {
    /// The polynomial with the variables named `x0`, `x1`, ….
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.display(&|var| format!("x{var}")))
    }
}
