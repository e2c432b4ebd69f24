//! Powers, roots, exponentials and logarithms: each is a product of powers of positive factors, and the sum of their
//! logarithms says what it comes to.

use super::identity::{Side, words_hold_ln};
use super::*;
use crate::kernel::statement::power;

impl Writer<'_> {
    /// An identity in which logarithms are written as sums.
    fn expanded(&mut self, left: &Side, right: &Side, using: &[Label], given: &Given) -> Found<String> {
        self.expands = true;
        let proof = self.identity(left, right, using, given);
        self.expands = false;
        proof
    }

    /// A power with a whole exponent of what may be 0 or negative: factor by factor.
    pub(super) fn whole_power(
        &mut self,
        base: &Expr,
        exponent: &Expr,
        f: &Fraction,
        using: &[Label],
        given: &Given,
    ) -> Found<String> {
        let plain = self.checker.read(base, &[])?;
        let n = at(self.printer.natural(exponent)?, ATOM);
        let mut items: Vec<(String, Side, Side, i64)> = Vec::new();
        if plain.coefficient.is_negative() {
            let minus = Fraction::integer(-1);
            items.push(("(-1)".to_string(), Side::integer(-1), self.factor_power(&minus, "(-1)", exponent, given)?, 1));
        }
        for (prime, k) in self.checker.primes(&plain)? {
            let number = Fraction::number(BigRational::from_integer(prime.clone()));
            let power = self.factor_power(&number, &prime.to_string(), exponent, given)?;
            items.push((prime.to_string(), Side::Number(number.coefficient), power, k));
        }
        for (poly, k) in &plain.factors {
            let text = self.poly(poly)?;
            let power = self.factor_power(
                &Fraction { coefficient: BigRational::one(), factors: [(poly.clone(), 1)].into() },
                &text,
                exponent,
                given,
            )?;
            items.push((text, Side::Poly(poly.clone()), power, *k));
        }
        let (mut list, mut product, mut powers) = (Vec::new(), Side::integer(1), Side::integer(1));
        for (text, side, power, k) in items.into_iter().rev() {
            list.push(format!("({text}, ({k})%Z, 0)"));
            let raised = |side: Side| {
                let side = Side::Power(Box::new(side), k.unsigned_abs());
                if k < 0 { side.inverse() } else { side }
            };
            product = raised(side).times(product);
            powers = raised(power).times(powers);
        }
        list.reverse();
        let first = self.identity(&Side::Expr(base.clone()), &product, &[], given)?;
        let second = if self.checker.read(&power(base, exponent), &[])? == *f {
            self.identity(&powers, &Side::Value(f.clone()), &[], given)?
        } else {
            let value = self.checker.read(&power(base, exponent), &[])?;
            let before = self.identity(&powers, &Side::Value(value.clone()), &[], given)?;
            let after = self.identity(&Side::Plain(value), &Side::Value(f.clone()), using, given)?;
            format!("(eq_trans {before} {after})")
        };
        Ok(format!("exact (eq_trans (pow_of_prod _ {n} [{}] {first}) {second})", list.join("; ")))
    }

    /// A factor to a whole power, with its value.
    fn factor_power(&mut self, factor: &Fraction, text: &str, exponent: &Expr, given: &Given) -> Found<Side> {
        let words = power(&self.checker.fraction_words(factor), exponent);
        let value = self.checker.read(&words, &[])?;
        let n = at(self.printer.natural(exponent)?, ATOM);
        let value_text = self.fraction(&value)?;
        let statement = format!("{text} ^ {n} = {value_text}");
        let logs = match (self.logs(factor, &[], given)?, self.logs(&value, &[], given)?) {
            (Some(left), Some(right)) => Some((left, right)),
            _ => None,
        };
        let tactic = match logs {
            Some((left, right)) => {
                let side = match factor.factors.keys().next() {
                    Some(poly) => Side::Poly(poly.clone()),
                    None => Side::Number(factor.coefficient.clone()),
                };
                let first = self.identity(&side, &left.product, &[], given)?;
                let second = self.identity(&Side::Value(value.clone()), &right.product, &[], given)?;
                let sum = self.expanded(&Side::Expr(exponent.clone()).times(left.sum), &right.sum, &[], given)?;
                format!(
                    "exact (pow_leaf _ _ _ {} {} {} {} {first} {second} {sum})",
                    left.list, right.list, left.proof, right.proof
                )
            }
            None => {
                let plain = self.checker.read(exponent, &[])?;
                let poly = self.checker.expanded(&plain)?;
                let mut terms = Vec::new();
                for (monomial, c) in poly.terms() {
                    let mut one = Poly::constant(BigRational::one());
                    for (atom, k) in monomial {
                        for _ in 0..*k {
                            one = self
                                .checker
                                .expanded(&self.checker.product_of(&Fraction::of(&one), &Fraction::atom(*atom))?)?;
                        }
                    }
                    let words = self.checker.poly_words(&one);
                    let words = at(self.printer.natural(&words)?, ATOM);
                    terms.push(if monomial.is_empty() { c.to_string() } else { format!("{words} * {c}") });
                }
                format!("clear; nat_power ({n})%nat ({})%nat", terms.join(" + "))
            }
        };
        let h = self.lemma("W", &statement, &tactic);
        Ok(Side::Known(format!("({text} ^ {n})"), value, h))
    }

    /// A power, root, exponential or logarithm by logarithms, where the factors are positive.
    pub(super) fn power_tactic(
        &mut self,
        e: &Expr,
        f: &Fraction,
        using: &[Label],
        given: &Given,
    ) -> Found<Option<String>> {
        let value = Side::Value(f.clone());
        let (lemma, base, times): (&str, Expr, Side) = match &e.kind {
            ExprKind::Power(base, exponent) => {
                let whole = is_natural(exponent, &self.printer.kinds);
                let opposite = match &exponent.kind {
                    ExprKind::Negate(inner) if !whole && is_natural(inner, &self.printer.kinds) => Some(inner),
                    _ => None,
                };
                match (whole, opposite) {
                    (true, _) => ("pow_leaf", (**base).clone(), Side::Expr((**exponent).clone())),
                    (_, Some(inner)) => ("inv_pow_leaf", (**base).clone(), Side::Expr((**inner).clone())),
                    _ if is_root(exponent) => ("sqrt_leaf", (**base).clone(), Side::integer(2).inverse()),
                    _ => ("rpower_leaf", (**base).clone(), Side::Expr((**exponent).clone())),
                }
            }
            ExprKind::Apply(function, arguments) => {
                let Some(x) = arguments.first().cloned() else { return Ok(None) };
                if ["exp", "ln"].contains(&function.text.as_str())
                    && let Some(found) = self.same_function(e, &x, f, given)?
                {
                    return Ok(Some(found));
                }
                match function.text.as_str() {
                    "sqrt" => ("sqrt_leaf", x, Side::integer(2).inverse()),
                    "cbrt" => ("cbrt_leaf", x, Side::integer(1).times(Side::integer(3).inverse())),
                    "exp" => {
                        let Some(right) = self.logs(f, using, given)? else { return Ok(None) };
                        let product = self.identity(&value, &right.product, &[], given)?;
                        let sum = self.expanded(&Side::Expr(x), &right.sum, using, given)?;
                        return Ok(Some(format!(
                            "exact (exp_leaf _ _ {} {} {product} {sum})",
                            right.list, right.proof
                        )));
                    }
                    "ln" => {
                        let plain = self.checker.read(&x, &[])?;
                        let Some(left) = self.logs(&plain, using, given)? else { return Ok(None) };
                        let product = self.identity(&Side::Expr(x), &left.product, &[], given)?;
                        let sum = self.expanded(&left.sum, &Side::Plain(f.clone()), using, given)?;
                        return Ok(Some(format!("exact (ln_leaf _ _ {} {} {product} {sum})", left.list, left.proof)));
                    }
                    _ => return Ok(None),
                }
            }
            _ => return Ok(None),
        };
        if lemma == "sqrt_leaf"
            && let Some(found) = self.same_function(e, &base, f, given)?
        {
            return Ok(Some(found));
        }
        let plain = self.checker.read(&base, &[])?;
        let Some(left) = self.logs(&plain, using, given)? else { return Ok(None) };
        let Some(right) = self.logs(f, using, given)? else { return Ok(None) };
        let first = self.identity(&Side::Expr(base), &left.product, &[], given)?;
        let second = self.identity(&value, &right.product, &[], given)?;
        let times = if lemma == "inv_pow_leaf" { Side::integer(-1).times(times) } else { times };
        let sum = self.expanded(&times.times(left.sum), &right.sum, using, given)?;
        Ok(Some(
            format!(
                "exact ({lemma} _ _ _ {} {} {} {} {first} {second} {sum})",
                left.list, right.list, left.proof, right.proof
            )
            .replace("(sqrt_leaf _ _ _", "(sqrt_leaf _ _")
            .replace("(cbrt_leaf _ _ _", "(cbrt_leaf _ _"),
        ))
    }

    /// An equation between products of powers.
    pub(super) fn power_rule(&mut self, goal: &Prop, given: &Given) -> Found<String> {
        let (a, _, b) = self.sides(goal, "power")?;
        let using = given.using.clone();
        let (left, right) = (Side::Expr(a.clone()), Side::Expr(b.clone()));
        let (x, y) = (self.checker.read(a, &using)?, self.checker.read(b, &using)?);
        if x == y || self.checker.difference_of(&x, &y)?.is_zero() {
            return Ok(format!("exact {}", self.identity(&left, &right, &using, given)?));
        }
        if let (Some(l), Some(r)) = (self.logs(&x, &using, given)?, self.logs(&y, &using, given)?) {
            let first = self.identity(&left, &l.product, &using, given)?;
            let second = self.identity(&right, &r.product, &using, given)?;
            let sum = self.expanded(&l.sum, &r.sum, &using, given)?;
            return Ok(format!(
                "exact (same_logs _ _ {} {} {} {} {first} {second} {sum})",
                l.list, r.list, l.proof, r.proof
            ));
        }
        if let Some(proof) = self.common_factors(a, b, &x, &y, given)? {
            return Ok(proof);
        }
        if words_hold_ln(a) || words_hold_ln(b) {
            let proof = self.expanded(&left, &right, &using, given);
            return Ok(format!("exact {}", proof?));
        }
        if let Some(proof) = self.by_squares(a, b, given)? {
            return Ok(proof);
        }
        self.by_rules(a, &using, given).and_then(|_| self.by_rules(b, &using, given))
    }

    /// An equation between products with the same factors that may be 0 or negative, and powers of positive ones.
    fn common_factors(
        &mut self,
        a: &Expr,
        b: &Expr,
        x: &Fraction,
        y: &Fraction,
        given: &Given,
    ) -> Found<Option<String>> {
        let one = || Fraction::integer(1);
        let (mut common, mut left, mut right) = (one(), one(), one());
        left.coefficient = x.coefficient.abs();
        right.coefficient = y.coefficient.abs();
        if x.coefficient.is_negative() != y.coefficient.is_negative() {
            return Ok(None);
        }
        if x.coefficient.is_negative() {
            common = Fraction::integer(-1);
        }
        for (f, rest) in [(x, &mut left), (y, &mut right)] {
            for (poly, k) in &f.factors {
                if self.positive_fact(poly, given)?.is_some() {
                    rest.factors.insert(poly.clone(), *k);
                } else if x.factors.get(poly) == y.factors.get(poly) {
                    common.factors.insert(poly.clone(), *k);
                } else {
                    return Ok(None);
                }
            }
        }
        let using = given.using.clone();
        let (Some(l), Some(r)) = (self.logs(&left, &using, given)?, self.logs(&right, &using, given)?) else {
            return Ok(None);
        };
        let u = self.fraction(&common)?;
        let common = Side::Value(common);
        let first = self.identity(&Side::Expr(a.clone()), &common.clone().times(l.product), &using, given)?;
        let second = self.identity(&Side::Expr(b.clone()), &common.times(r.product), &using, given)?;
        let sum = self.expanded(&l.sum, &r.sum, &using, given)?;
        Ok(Some(format!(
            "exact (same_times _ _ {u} (prodz {}) (prodz {}) {first} (same_logs _ _ {} {} {} {} eq_refl eq_refl {sum}) {second})",
            l.list, r.list, l.list, r.list, l.proof, r.proof
        )))
    }

    /// By the rules for powers, for what may be 0 or negative.
    pub(super) fn by_rules(&mut self, e: &Expr, using: &[Label], given: &Given) -> Found<String> {
        let mut parts = Vec::new();
        crate::refute::expand::parts(e, &mut |part| parts.push(part.clone()));
        for part in &parts {
            let f = self.checker.read(part, using)?;
            self.positive(&f, given)?;
        }
        let equations: String = using.iter().map(|label| format!("rewrite ?{}; ", fact(label))).collect();
        Ok(format!("first [pw ltac:(idtac) | ({equations}pw ltac:(idtac))]"))
    }
}
