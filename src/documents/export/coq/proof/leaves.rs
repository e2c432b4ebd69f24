//! Leaves of an expression: the value of a name, function, power, sum or derivative, and the proof of it.

use super::arithmetic::equation_by;
use super::identity::{Side, Valued};
use super::*;

impl Writer<'_> {
    /// A leaf of an expression, with its value and the proof of it.
    pub(super) fn leaf(&mut self, e: &Expr, using: &[Label], given: &Given) -> Found<Valued> {
        if self.expands
            && let ExprKind::Apply(f, arguments) = &e.kind
            && f.text == "ln"
            && let Some(argument) = arguments.first()
        {
            let plain = self.checker.read(argument, &[])?;
            if let Some(logs) = self.logs(&plain, using, given)? {
                let text = self.expr(e)?;
                let inner = self.identity(&Side::Expr(argument.clone()), &logs.product, &[], given)?;
                let proof = format!("(ln_leaf _ _ {} {} {inner} eq_refl)", logs.list, logs.proof);
                return Ok(Valued { text, value: logs.sum, proof: Some(proof) });
            }
        }
        let f = self.checker.read(e, using)?;
        let (text, value) = (self.expr(e)?, self.fraction(&f)?);
        if text == value || text == format!("({value})") || format!("({text})") == value {
            return Ok(Valued { text, value: Side::Value(f), proof: None });
        }
        let statement = format!("{text} = {value}");
        if let Some(found) = self.shown.iter().find(|s| s.1 == statement) {
            return Ok(Valued { text, value: Side::Value(f), proof: Some(found.2.clone()) });
        }
        if self.busy.contains(&statement) {
            if using.is_empty() {
                return Err(Open::Untranslated(text, "a value that rests on itself"));
            }
            return self.leaf(e, &[], given);
        }
        self.divisors(&f, given)?;
        self.busy.push(statement.clone());
        let expands = std::mem::replace(&mut self.expands, false);
        let tactic = self.leaf_tactic(e, &f, using, given);
        self.expands = expands;
        self.busy.pop();
        let hypothesis = self.lemma("L", &statement, &tactic?);
        Ok(Valued { text, value: Side::Value(f), proof: Some(hypothesis) })
    }

    fn leaf_tactic(&mut self, e: &Expr, f: &Fraction, using: &[Label], given: &Given) -> Found<String> {
        if let Some((label, right)) = self.equation(e, using) {
            return self.by_equation(e, f, (&label, right), using, given);
        }
        let value = Side::Value(f.clone());
        let plain = self.checker.read(e, &[])?;
        if !using.is_empty()
            && plain != *f
            && let Some(found) = self.by_multiple(e, f, &plain, using, given)?
        {
            return Ok(found);
        }
        let natural = is_natural(e, &self.printer.kinds) && !matches!(e.kind, ExprKind::Power(..));
        let atomic = natural
            || matches!(&e.kind, ExprKind::SumOver(..) | ExprKind::ProductOver(..) | ExprKind::Name(_))
            || matches!(&e.kind, ExprKind::Apply(f, _) if self.printer.kinds.contains_key(&f.text));
        if atomic {
            if plain != *f {
                // First what it comes to by itself, then the equations.
                let first = self.leaf(e, &[], given)?;
                let second = self.identity(&Side::Plain(plain), &value, using, given)?;
                return Ok(match first.proof {
                    Some(first) => format!("exact (eq_trans {first} {second})"),
                    None => format!("exact {second}"),
                });
            }
            let tactic = match &e.kind {
                ExprKind::SumOver(..) | ExprKind::ProductOver(..) => "over",
                _ if natural => "clear; natural_value",
                _ => "f_equal; lia",
            };
            return Ok(tactic.to_string());
        }
        if let ExprKind::Apply(function, arguments) = &e.kind
            && let Some(x) = arguments.first()
            && let Some(found) = match function.text.as_str() {
                "det" => self.determinant(x, &value, using, given)?,
                function => self.hyperbolic(function, x, &value, using, given)?,
            }
        {
            return Ok(found);
        }
        if let ExprKind::Derivative(body, by) = &e.kind {
            return self.derivative_leaf(e, (body, by), &plain, f, using, given);
        }
        if let Some(tactic) = self.power_tactic(e, f, using, given)? {
            return Ok(tactic);
        }
        if let ExprKind::Power(base, exponent) = &e.kind
            && is_natural(exponent, &self.printer.kinds)
        {
            return self.whole_power(base, exponent, f, using, given);
        }
        let words = self.checker.fraction_words(f);
        if let (ExprKind::Apply(function, _), Some(proof)) = (&e.kind, self.by_squares(e, &words, given)?)
            && function.text == "sqrt"
        {
            return Ok(proof);
        }
        self.by_rules(e, using, given)
    }

    /// By a fact that says what the leaf is equal to.
    fn by_equation(
        &mut self,
        e: &Expr,
        f: &Fraction,
        (label, right): (&Label, Expr),
        using: &[Label],
        given: &Given,
    ) -> Found<String> {
        let value = Side::Value(f.clone());
        let before: Vec<Label> = using.iter().take_while(|l| *l != label).cloned().collect();
        let first = self.checker.read(&right, &before)?;
        // Its right side was read with the equations before it; those behind it are put into what came of that.
        let rest = if self.checker.read(&right, using)? == *f || first == *f {
            let using = if first == *f { &before } else { using };
            self.identity(&Side::Expr(right), &value, using, given)?
        } else {
            let one = self.identity(&Side::Expr(right), &Side::Value(first.clone()), &before, given)?;
            let two = self.identity(&Side::Plain(first), &value, using, given)?;
            format!("(eq_trans {one} {two})")
        };
        Ok(format!("exact (eq_trans {} {rest})", equation_by(e, &fact(label))))
    }

    /// By an equation whose left side comes to a multiple of the same.
    fn by_multiple(
        &mut self,
        e: &Expr,
        f: &Fraction,
        plain: &Fraction,
        using: &[Label],
        given: &Given,
    ) -> Found<Option<String>> {
        for label in using {
            let p = self.fact_prop(label)?;
            let (a, _, b) = self.sides(&p, "equation")?;
            let left = self.checker.read(a, &[])?;
            if left.is_zero() || left.factors != plain.factors {
                continue;
            }
            let ratio = &plain.coefficient / &left.coefficient;
            let mut right = self.checker.read(b, using)?;
            right.coefficient *= &ratio;
            if right == *f {
                let c = Side::Number(ratio);
                let before = c.clone().times(Side::Expr(a.clone()));
                let after = c.times(Side::Expr(b.clone()));
                let first = self.identity(&Side::Expr(e.clone()), &before, &[], given)?;
                let rest = self.identity(&after, &Side::Value(f.clone()), using, given)?;
                let h = fact(label);
                return Ok(Some(format!("exact (eq_trans {first} (eq_trans (f_equal (Rmult _) {h}) {rest}))")));
            }
        }
        Ok(None)
    }

    /// A hyperbolic function, by exponentials or by sinh and cosh.
    fn hyperbolic(
        &mut self,
        function: &str,
        x: &Expr,
        value: &Side,
        using: &[Label],
        given: &Given,
    ) -> Found<Option<String>> {
        let half = || Side::integer(2).inverse();
        let exp = |x: &Expr| Side::Expr(apply("exp", x));
        let x_minus = || expr(ExprKind::Negate(Box::new(x.clone())));
        let (unfolded, other) = match function {
            "cosh" => (None, exp(x).plus(exp(&x_minus())).times(half())),
            "sinh" => (None, exp(x).minus(exp(&x_minus())).times(half())),
            "sech" | "tanh" => {
                let cosh = self.checker.read(&apply("cosh", x), using)?;
                for poly in cosh.factors.keys() {
                    self.not_zero(poly, given)?;
                }
                let one = expr(ExprKind::Number("1".to_string()));
                let (unfolded, top) = if function == "sech" { ("sech_is", one) } else { ("tanh_is", apply("sinh", x)) };
                let quotient = vec![(Factor::Times, top), (Factor::Over, apply("cosh", x))];
                (Some(unfolded), Side::Expr(expr(ExprKind::Product(quotient))))
            }
            _ => return Ok(None),
        };
        let rest = self.identity(&other, value, using, given)?;
        Ok(Some(match unfolded {
            Some(unfolded) => format!("exact (eq_trans ({unfolded} _) {rest})"),
            None => format!("exact {rest}"),
        }))
    }

    /// A determinant of two rows, written out.
    fn determinant(&mut self, matrix: &Expr, value: &Side, using: &[Label], given: &Given) -> Found<Option<String>> {
        let rows = self.entries(matrix)?;
        let [[a, b], [c, d]] = rows.iter().map(Vec::as_slice).collect::<Vec<_>>()[..] else { return Ok(None) };
        let (ad, bc) = (a.clone().times(d.clone()), b.clone().times(c.clone()));
        Ok(Some(format!("exact {}", self.identity(&ad.minus(bc), value, using, given)?)))
    }
}

fn apply(function: &str, x: &Expr) -> Expr {
    let function = Name { text: function.to_string(), span: x.span };
    expr(ExprKind::Apply(function, vec![x.clone()]))
}
