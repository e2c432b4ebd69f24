//! The numbers of what sums, products and integrals bind: indices and places.
//!
//! While a body is read, what it binds is *open*: its number is [`OPEN`] and that of the binders around it, so what is known of it
//! is known of nothing else. In an atom it is *closed*: its number is 1 and the greatest number bound in the body. So an atom is the
//! same wherever it stands, and nothing in the body has its number, for whatever else is free there is open: a body is opened again
//! before something is put into it.

use super::fraction::Fraction;
use super::term::Atom;
use super::{Checker, Refusal};

/// The least number of what is open: greater than the depth of every expression.
const OPEN: usize = 1 << 20;

impl Checker {
    /// Runs something with the number of what one more binder binds.
    pub(super) fn opened<T>(
        &mut self,
        run: impl FnOnce(&mut Checker, usize) -> Result<T, Refusal>,
    ) -> Result<T, Refusal> {
        self.binders += 1;
        let result = run(self, OPEN + self.binders);
        self.binders -= 1;
        result
    }

    /// The number that an atom binds in a body, and the body with it in the place of the open one.
    pub(super) fn closed(
        &mut self,
        own: usize,
        body: &Fraction,
        bound: fn(usize) -> Atom,
    ) -> Result<(usize, Fraction), Refusal> {
        let height = 1 + body.atoms().filter_map(|place| self.heights.get(place)).max().unwrap_or(&0);
        Ok((height, self.renamed(body, bound(own), bound(height))?))
    }

    /// A body with one bound atom in the place of another.
    pub(super) fn renamed(&mut self, body: &Fraction, old: Atom, new: Atom) -> Result<Fraction, Refusal> {
        let (old, new) = (self.intern(old), self.intern(new));
        self.replaced(body, old, &Fraction::atom(new))
    }

    /// The greatest number bound in an atom, at any depth.
    pub(super) fn height_of(&self, atom: &Atom) -> usize {
        let own = match atom {
            Atom::Over(over) => over.own,
            Atom::Integral(integral) => integral.own,
            _ => 0,
        };
        atom.parts().into_iter().filter_map(|place| self.heights.get(place).copied()).fold(own, usize::max)
    }
}

/// The name of what is bound, in print.
pub(super) fn bound_name(letter: char, own: usize) -> String {
    match own.checked_sub(OPEN) {
        Some(around) => format!("{letter}_{around}"),
        None => format!("{letter}{own}"),
    }
}
