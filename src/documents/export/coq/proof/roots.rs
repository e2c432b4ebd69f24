//! Square roots, of what may be 0 as well: `sqrt` is 0 at 0, where `Rpower` is not.

use super::identity::Side;
use super::*;

impl Writer<'_> {
    /// Whether a power with this exponent is a square root.
    pub(super) fn is_root(&self, exponent: &Fraction) -> bool {
        is_root(&self.checker.fraction_words(exponent))
    }

    /// A root, logarithm or exponential whose value is the same function of an argument that is written otherwise.
    pub(super) fn same_function(&mut self, e: &Expr, x: &Expr, f: &Fraction, given: &Given) -> Found<Option<String>> {
        let text = self.expr(e)?;
        let Some(place) = single_atom(f) else { return Ok(None) };
        let (function, inside) = match self.checker.atom_form(place) {
            Form::Power(base, exponent, false) if self.is_root(&exponent) => ("sqrt", base),
            Form::Logarithm(inner) => ("ln", inner),
            Form::Exponential(inner) => ("exp", inner),
            _ => return Ok(None),
        };
        if !text.starts_with(&format!("({function} ")) || self.checker.read(x, &[])? != inside {
            return Ok(None);
        }
        let equal = self.identity(&Side::Expr(x.clone()), &Side::Value(inside), &[], given)?;
        Ok(Some(format!("exact (f_equal {function} {equal})")))
    }

    /// An equation between expressions with square roots: their squares are equal, and neither is negative.
    pub(super) fn by_squares(&mut self, a: &Expr, b: &Expr, given: &Given) -> Found<Option<String>> {
        let mut roots = Vec::new();
        for side in [a, b] {
            self.needs(side, given)?;
            self.roots_in(side, &mut roots)?;
        }
        if roots.is_empty() {
            return Ok(None);
        }
        let equations = roots.join(" ");
        let mut signs = Vec::new();
        for side in [a, b] {
            let f = self.checker.read(side, &[])?;
            if !self.checker.signs(&f, &given.signed)?.within(Signs::NOT_NEGATIVE) {
                return Ok(Some(format!("first [ring [{equations}] | (field [{equations}]; nz)]")));
            }
            let text = self.expr(side)?;
            signs.push(self.sign(&text, &Side::Expr(side.clone()), &[], &f, Signs::NOT_NEGATIVE, given)?);
        }
        Ok(Some(format!(
            "first [ring [{equations}] | (apply same_square; [exact (to_ge0 _ {}) | exact (to_ge0 _ {}) \
             | first [ring [{equations}] | (field [{equations}]; nz)]])]",
            signs.first().cloned().unwrap_or_default(),
            signs.get(1).cloned().unwrap_or_default()
        )))
    }

    /// Asserts of each square root in an expression what its square is; adds the hypotheses.
    fn roots_in(&mut self, e: &Expr, found: &mut Vec<String>) -> Found<()> {
        let base = match &e.kind {
            ExprKind::Power(base, exponent) if is_root(exponent) => Some(&**base),
            ExprKind::Apply(f, arguments) if f.text == "sqrt" => arguments.first(),
            _ => None,
        };
        if let Some(base) = base {
            let (root, base) = (self.expr(e)?, self.expr(base)?);
            let h = self.lemma("R", &format!("{root} ^ 2 = {base}"), "square_of_root");
            if !found.contains(&h) {
                found.push(h);
            }
        }
        let mut parts = Vec::new();
        crate::refute::expand::parts(e, &mut |part| parts.push(part.clone()));
        parts.iter().try_for_each(|part| self.roots_in(part, found))
    }
}

fn single_atom(f: &Fraction) -> Option<usize> {
    let mut factors = f.factors.iter();
    match (factors.next(), factors.next()) {
        (Some((poly, 1)), None) if f.coefficient.is_one() => poly.single_atom(),
        _ => None,
    }
}
