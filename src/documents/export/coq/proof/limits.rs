//! The rules of limits and of second derivatives.

use super::identity::Side;
use super::*;
use crate::claim::free_names::names_in;
use crate::claim::walk::parts;
use num_traits::Zero;
use std::collections::BTreeSet;

impl Writer<'_> {
    /// The limit of a quotient of polynomials in the variable, by what it is in the inverse of the variable.
    pub(super) fn limit(&mut self, goal: &Prop, with: &[(Name, Expr)], given: &Given) -> Found<String> {
        let PropKind::Limit(limit) = &goal.kind else {
            return Err(Open::Untranslated("limit".to_string(), "a goal"));
        };
        let x = limit.variable.text.clone();
        let f = self.checker.read(&limit.of, &[])?;
        let (top, bottom) = self.checker.parts_of(&f)?;
        let place = self.checker.read(&name(&x), &[])?.atoms().next().unwrap_or(usize::MAX);
        let exponents = self.checker.exponents_of(place);
        let (top, bottom) = (top.coefficients(&exponents), bottom.coefficients(&exponents));
        let Some((degree, lead)) = bottom.iter().next_back() else {
            return Err(Open::Untranslated("limit".to_string(), "a divisor"));
        };
        let text = self.poly(lead)?;
        let of = Fraction::of(lead);
        if !self.checker.signs(&of, &given.signed)?.within(Signs::NOT_ZERO) {
            return Err(Open::Untranslated("limit".to_string(), "a leading coefficient other than 0"));
        }
        let lead = self.sign(&text, &Side::Poly(lead.clone()), &[], &of, Signs::NOT_ZERO, given)?;
        let mut sides = Vec::new();
        for list in [&top, &bottom] {
            let mut terms = vec!["0".to_string()];
            for (k, c) in list {
                let c = self.poly(c)?;
                let power = degree - k;
                if !power.is_integer() {
                    return Err(Open::Untranslated("limit".to_string(), "roots of the variable"));
                }
                terms.push(if power.is_zero() { c } else { format!("{c} * y__0 ^ {power}") });
            }
            sides.push(format!("(fun y__0 : R => {})", terms.join(" + ")));
        }
        let natural = is_natural(&name(&x), &self.printer.kinds);
        let lemma = if natural { "lim_seq_inv" } else { "lim_inv" };
        let from = match with.iter().find(|w| w.0.text == "from") {
            Some((_, e)) => self.expr(e)?,
            None => "0".to_string(),
        };
        Ok(format!("limit_by {lemma} {} {from} (to_nz _ {lead})", sides.join(" ")))
    }

    /// A limit between two others.
    pub(super) fn squeeze(&mut self, goal: &Prop, from: &[Label]) -> Found<String> {
        let PropKind::Limit(limit) = &goal.kind else {
            return Err(Open::Untranslated("squeeze".to_string(), "a goal"));
        };
        let natural = is_natural(&name(&limit.variable.text), &self.printer.kinds);
        let lemma = if natural { "squeeze_seq" } else { "squeeze_lim" };
        let [l, u, a, b] = from else {
            return Err(Open::Untranslated("squeeze".to_string(), "its four facts"));
        };
        let mut bound = "0".to_string();
        if let PropKind::ForAll(bindings, _) = &self.fact_prop(l)?.kind
            && let Some(Constraint::Relation(_, e)) = bindings.first().and_then(|b| b.constraints.first())
        {
            bound = self.expr(e)?;
        }
        let [lower, upper, a, b] = [l, u, a, b].map(|label| fact(label));
        Ok(format!(
            "refine ({lemma} _ _ _ _ {bound} _ {a} {b}); let k := fresh in let h := fresh in intros k h; \
             split; [first [apply {lower} | apply Rge_le; apply {lower}]; lra | first [apply {upper} | apply Rge_le; apply {upper}]; lra]"
        ))
    }

    /// A limit from that with an exponential in the place of the variable.
    pub(super) fn along(&mut self, goal: &Prop, from: &Label) -> Found<String> {
        let PropKind::Limit(limit) = &goal.kind else {
            return Err(Open::Untranslated("along".to_string(), "a goal"));
        };
        let natural = is_natural(&name(&limit.variable.text), &self.printer.kinds);
        let lemma = if natural { "along_seq" } else { "along_lim" };
        Ok(format!("refine ({lemma} _ _ _); exact {}", fact(from)))
    }

    /// A derivative that stands in an expression: what it comes to by itself, then the equations.
    pub(super) fn derivative_leaf(
        &mut self,
        e: &Expr,
        (body, by): (&Expr, &[Name]),
        plain: &Fraction,
        f: &Fraction,
        using: &[Label],
        given: &Given,
    ) -> Found<String> {
        if plain != f {
            let first = self.leaf(e, &[], given)?;
            let second = self.identity(&Side::Plain(plain.clone()), &Side::Value(f.clone()), using, given)?;
            return Ok(match first.proof {
                Some(first) => format!("exact (eq_trans {first} {second})"),
                None => format!("exact {second}"),
            });
        }
        if by.len() > 1 {
            let label = "a derivative".to_string();
            return Err(Open::Untranslated(label, "one of higher order inside an expression"));
        }
        of_no_sum(body, by)?;
        self.needs(body, given)?;
        let inside = self.checker.read(body, &[])?;
        self.divisors(&inside, given)?;
        self.positive(&inside, given)?;
        Ok("apply is_derive_unique; derive ltac:(idtac)".to_string())
    }

    /// A second derivative, by the first one.
    pub(super) fn second_derivative(&mut self, body: &Expr, by: &[Name], given: &Given) -> Found<String> {
        let [x, _] = by else {
            return Err(Open::Untranslated("combination".to_string(), "a derivative of higher order"));
        };
        of_no_sum(body, by)?;
        let first = expr(ExprKind::Derivative(Box::new(body.clone()), vec![x.clone()]));
        let first = self.checker.read(&first, &[])?;
        self.positive(&first, given)?;
        self.divisors(&first, given)?;
        let f = self.checker.read(&name(&x.text), &[])?;
        let positive = self.checker.signs(&f, &given.signed)?.within(Signs::POSITIVE);
        let (word, first) = (self.printer.word(&x.text), self.fraction(&first)?);
        // Where the variable is positive, its first derivative is there for positive numbers only.
        Ok(match positive {
            true => format!(
                "apply (second_derivative _ (fun {word} : R => {first}) _ 0); \
                 [let y := fresh in let h := fresh in intros y h; apply is_derive_unique; derive ltac:(idtac) \
                 | lra | derive ltac:(idtac)]"
            ),
            false => format!(
                "apply (second_derivative_all _ (fun {word} : R => {first})); \
                 [let y := fresh in intro y; apply is_derive_unique; derive ltac:(idtac) | derive ltac:(idtac)]"
            ),
        })
    }
}

/// Refuses a sum over an index that holds a variable by which it is differentiated: the library has no rule for it.
pub(super) fn of_no_sum(body: &Expr, by: &[Name]) -> Found<()> {
    let mut names = BTreeSet::new();
    names_in(body, &mut names);
    if matches!(body.kind, ExprKind::SumOver(..)) && by.iter().any(|x| names.contains(&x.text)) {
        return Err(Open::Untranslated("combination".to_string(), "the derivative of a sum over an index"));
    }
    let mut found = Ok(());
    parts(body, &mut |part| {
        if found.is_ok() {
            found = of_no_sum(part, by);
        }
    });
    found
}
