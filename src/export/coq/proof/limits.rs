//! The rules of limits and of second derivatives.

use super::*;

impl Writer<'_> {
    /// The limit of a quotient of polynomials in the variable, by what it is in the inverse of the variable.
    pub(super) fn limit(&mut self, goal: &Prop, with: &[(Name, Expr)]) -> Found<String> {
        let PropKind::Limit(limit) = &goal.kind else {
            return Err(Open::Untranslated("limit".to_string(), "a goal"));
        };
        let x = limit.variable.text.clone();
        let f = self.checker.read(&limit.of, &[])?;
        let (top, bottom) = self.checker.parts_of(&f)?;
        let place = self.checker.read(&name(&x), &[])?.atoms().next().unwrap_or(usize::MAX);
        let (top, bottom) = (top.coefficients(place), bottom.coefficients(place));
        let degree = bottom.keys().next_back().copied().unwrap_or(0);
        let mut sides = Vec::new();
        for list in [&top, &bottom] {
            let mut terms = vec!["0".to_string()];
            for (k, c) in list {
                let c = self.poly(c)?;
                terms.push(format!("{c} * y__0 ^ {}", degree.saturating_sub(*k)));
            }
            sides.push(format!("(fun y__0 : R => {})", terms.join(" + ")));
        }
        let natural = is_natural(&name(&x), &self.printer.kinds);
        let lemma = if natural { "lim_seq_inv" } else { "lim_inv" };
        let from = match with.iter().find(|w| w.0.text == "from") {
            Some((_, e)) => self.expr(e)?,
            None => "0".to_string(),
        };
        Ok(format!("limit_by ({lemma} _ {} _ {from})", sides.join(" ")))
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

    /// A second derivative, by the first one.
    pub(super) fn second_derivative(&mut self, body: &Expr, by: &[Name], given: &Given) -> Found<String> {
        let [x, _] = by else {
            return Err(Open::Untranslated("combination".to_string(), "a derivative of higher order"));
        };
        let first = expr(ExprKind::Derivative(Box::new(body.clone()), vec![x.clone()]));
        let first = self.checker.read(&first, &[])?;
        self.positive(&first, given)?;
        self.divisors(&first, given)?;
        let (word, first) = (self.printer.word(&x.text), self.fraction(&first)?);
        Ok(format!(
            "apply (second_derivative _ (fun {word} : R => {first}) _ 0); \
             [let y := fresh in let h := fresh in intros y h; apply is_derive_unique; clear - H__h1 H__h2 h; derive ltac:(idtac) \
             | lra | derive ltac:(idtac)]"
        ))
    }
}
