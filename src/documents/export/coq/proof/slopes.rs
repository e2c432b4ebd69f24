//! Rule `slope`: the mean value theorem, and that functions have derivatives.

use super::identity::Side;
use super::*;
use crate::kernel::statement::numeral;

impl Writer<'_> {
    /// A comparison of two values of a function, from the sign of its derivative between them.
    pub(super) fn slope(
        &mut self,
        show: &Show,
        source: &str,
        with: &[(Name, Expr)],
        from: &[Label],
        given: &Given,
    ) -> Found<String> {
        let missing = |what: &'static str| Err(Open::Untranslated(show.label.clone(), what));
        let said = self.fact_prop(source)?;
        let PropKind::ForAll(bindings, body) = &said.kind else { return missing("slope: a statement for all values") };
        let (derivative, slope, _) = self.sides(body, "slope")?;
        let (_, relation, _) = self.sides(&show.prop, "slope")?;
        let value = |text: &str| with.iter().find(|w| w.0.text == text).map(|w| &w.1);
        let ([binding], ExprKind::Derivative(f, _), Some(a), Some(b)) =
            (bindings.as_slice(), &derivative.kind, value("a"), value("b"))
        else {
            return missing("slope: its values");
        };
        let Some((t, _)) = binding.names.first() else { return missing("slope: a variable") };
        let domain = self.checker.domain_of_slope(binding, derivative, [a, b], from, show)?;
        let mut hypotheses = Vec::new();
        for point in [a, b] {
            for p in constraints(&domain, point) {
                self.comparison(&p, given)?;
                let text = self.prop(&p)?;
                hypotheses.push(self.lemma("B", &text, "hyp"));
            }
        }
        let hypotheses = hypotheses.join(" ");
        let function = self.printer.within_bindings(bindings, |p| p.function_of(f, t))?;
        let there = self.differentiable(show, &domain, f, &function)?;
        let word = self.printer.word(&t.text);
        let (from, to) = (self.expr(a)?, self.expr(b)?);
        let closed = format!("{from} <= {word} <= {to} \\/ {to} <= {word} <= {from}");
        let smooth = self.lemma(
            "E",
            &format!("forall {word} : R, {closed} -> ex_derive {function} {word}"),
            &format!("clear - {there} {hypotheses}; intros; apply {there}; between"),
        );
        let signs = signs_word(Signs::of(slope));
        let open = closed.replace("<=", "<");
        let sign = self.lemma(
            "E",
            &format!("forall {word} : R, {open} -> holds {signs} (Derive {function} {word} - 0)"),
            &format!("clear - {smooth} {hypotheses} {}; slope_sign {} {smooth}", fact(source), fact(source)),
        );
        let run = sum(vec![(Sign::Plus, b.clone()), (Sign::Minus, a.clone())]);
        let mut using = given.using.clone();
        let mut length = self.checker.read(&run, &using)?;
        let wanted = Signs::of(relation);
        if !Signs::of(slope).times(self.checker.signs(&length, &given.signed)?).within(wanted) {
            using.clear();
            length = self.checker.read(&run, &using)?;
        }
        let way = self.checker.signs(&length, &given.signed)?;
        let way_text = format!("{to} - {from}");
        let run = match way == Signs::ANY {
            true => format!("(holds_any ({way_text}))"),
            false => {
                let side = Side::Expr(b.clone()).minus(Side::Expr(a.clone()));
                self.sign(&way_text, &side, &using, &length, way, given)?
            }
        };
        Ok(format!(
            "sloped (to_{} _ _ (slope {function} {from} {to} {signs} {} {} {smooth} {sign} {run} eq_refl))",
            lower(relation),
            signs_word(way),
            signs_word(wanted)
        ))
    }

    /// The hypothesis that a function of the variable of a binding has a derivative in its whole domain.
    fn differentiable(&mut self, show: &Show, domain: &Binding, f: &Expr, function: &str) -> Found<String> {
        let hypothesis = self.fresh("C");
        let for_all = self.printer.within_bindings(std::slice::from_ref(domain), |p| p.given(domain))?;
        let word = domain.names.first().map(|n| self.printer.word(&n.0.text)).unwrap_or_default();
        self.put(&format!("assert ({hypothesis} : {for_all} ex_derive {function} {word}). {{"));
        self.depth += 1;
        // The kernel's steps go on outside: what is read inside is forgotten.
        let outside = self.checker.clone();
        let zero = compare(numeral(0), Relation::Equal, numeral(0));
        let every = crate::kernel::statement::prop(PropKind::ForAll(vec![domain.clone()], Box::new(zero)));
        let mut block = show.clone();
        (block.label, block.rule, block.prop) = (format!("{}x", show.label), Rule::Let, every);
        let saved = (self.printer.kinds.clone(), self.printer.positive.clone());
        self.open(&block)?;
        let given = self.given(&block)?;
        self.needs(f, &given)?;
        self.put("differentiable.");
        self.checker = outside;
        self.depth -= 1;
        self.put("}");
        let depth = self.depth;
        self.shown.retain(|s| s.0 <= depth);
        (self.printer.kinds, self.printer.positive) = saved;
        Ok(hypothesis)
    }

    /// Asserts what an expression needs to have a value, and a derivative, part by part, where signs show it.
    pub(super) fn needs(&mut self, e: &Expr, given: &Given) -> Found<()> {
        let needs = definedness::needs(e, &|name| kinds::is_natural_name(name, &self.printer.kinds));
        for need in needs.map_err(Refusal::from)? {
            let (inner, signs) = match &need {
                Need::NotZero(inner) | Need::NotZeroOrNatural(inner, _) => (inner, vec![Signs::NOT_ZERO]),
                Need::Positive(inner) | Need::NotNegative(inner) => (inner, vec![Signs::POSITIVE, Signs::NOT_NEGATIVE]),
                Need::Range(..) | Need::Differentiable(..) => continue,
            };
            let f = self.checker.read(inner, &[])?;
            let known = self.checker.signs(&f, &given.signed)?;
            let Some(signs) = signs.into_iter().find(|s| known.within(*s)) else { continue };
            let text = self.expr(inner)?;
            let h = self.sign(&text, &Side::Expr(inner.clone()), &[], &f, signs, given)?;
            let (statement, lemma) = match signs {
                s if s == Signs::POSITIVE => (format!("0 < {text}"), "to_pos"),
                s if s == Signs::NOT_ZERO => (format!("{text} <> 0"), "to_nz"),
                _ => (format!("0 <= {text}"), "to_ge0"),
            };
            self.lemma("Y", &statement, &format!("exact ({lemma} _ {h})"));
        }
        if matches!(e.kind, ExprKind::SumOver(..) | ExprKind::ProductOver(..)) {
            return Ok(());
        }
        let mut parts = Vec::new();
        crate::refute::expand::parts(e, &mut |part| parts.push(part.clone()));
        parts.iter().try_for_each(|part| self.needs(part, given))
    }
}
