//! Logarithms of fractions: the list of their positive factors, each with its exponent and its logarithm.

use super::identity::Side;
use super::*;

/// A product of powers of positive factors: the list of factors, exponents and logarithms, the proof that these are the
/// logarithms, the product and the sum of the logarithms.
pub(super) struct Logs {
    pub(super) list: String,
    pub(super) proof: String,
    pub(super) product: Side,
    pub(super) sum: Side,
}

impl Writer<'_> {
    /// A fraction as a product of powers of positive factors, if its factors are shown to be positive.
    pub(super) fn logs(&mut self, f: &Fraction, using: &[Label], given: &Given) -> Found<Option<Logs>> {
        if !f.coefficient.is_positive() {
            return Ok(None);
        }
        let mut items: Vec<(String, i64, Side, String, Side)> = Vec::new();
        for (prime, k) in self.checker.primes(f)? {
            let q = BigRational::from_integer(prime.clone());
            let proof = format!("(prime_log {prime} ltac:(lra))");
            items.push((prime.to_string(), k, Side::Number(q), proof, Side::Whole(format!("(ln {prime})"))));
        }
        for (poly, k) in &f.factors {
            let Some((proof, sum)) = self.log_of(poly, using, given)? else { return Ok(None) };
            items.push((self.poly(poly)?, *k, Side::Poly(poly.clone()), proof, sum));
        }
        let (mut list, mut proof) = (Vec::new(), "I".to_string());
        let (mut product, mut sum) = (Side::integer(1), Side::integer(0));
        for (text, k, factor, log, q) in items.into_iter().rev() {
            let q_text = self.full(&q)?;
            list.push(format!("({text}, ({k})%Z, {q_text})"));
            proof = format!("(conj {log} {proof})");
            let power = Side::Power(Box::new(factor), k.unsigned_abs());
            product = if k < 0 { power.inverse() } else { power }.times(product);
            sum = Side::integer(k).times(q).plus(sum);
        }
        list.reverse();
        Ok(Some(Logs { list: format!("[{}]", list.join("; ")), proof, product, sum }))
    }

    /// The text of a side outside an identity.
    fn full(&mut self, side: &Side) -> Found<String> {
        self.side(side)
    }

    /// The logarithm of a positive factor, and the proof that the factor is positive and has it.
    fn log_of(&mut self, poly: &Poly, using: &[Label], given: &Given) -> Found<Option<(String, Side)>> {
        let Some(positive) = self.positive_fact(poly, given)? else { return Ok(None) };
        let text = self.poly(poly)?;
        let opaque = Side::Whole(format!("(ln {text})"));
        let closed = (format!("(conj {positive} eq_refl)"), opaque);
        if self.busy.contains(&format!("ln {text}")) {
            return Ok(Some(closed));
        }
        self.busy.push(format!("ln {text}"));
        let found = self.log_shown(poly, &text, &positive, using, given);
        self.busy.pop();
        Ok(Some(found?.unwrap_or(closed)))
    }

    fn log_shown(
        &mut self,
        poly: &Poly,
        text: &str,
        positive: &str,
        using: &[Label],
        given: &Given,
    ) -> Found<Option<(String, Side)>> {
        let Some(place) = poly.single_atom() else { return self.log_forth(poly, text, positive, using, given) };
        let (statement, tactic, side) = match self.checker.atom_form(place) {
            Form::Power(base, exponent, whole) => {
                let (sum, inner) = match self.logs(&base, using, given)? {
                    Some(logs) => {
                        let product = self.identity(&Side::Value(base.clone()), &logs.product, &[], given)?;
                        (logs.sum, format!("(ln_leaf _ _ {} {} {product} eq_refl)", logs.list, logs.proof))
                    }
                    // A base that is positive, and its factors are not.
                    None if self.checker.signs(&base, &given.signed)?.within(Signs::POSITIVE) => {
                        (Side::Whole(format!("(ln {})", self.fraction(&base)?)), "eq_refl".to_string())
                    }
                    None => return Ok(None),
                };
                let root = !whole && self.is_root(&exponent);
                let (lemma, times) = if whole {
                    let words = self.checker.fraction_words(&exponent);
                    ("ln_of_pow _", Side::Expr(words))
                } else {
                    (if root { "ln_of_root" } else { "ln_of_rpower _" }, Side::Plain(exponent))
                };
                let side = times.times(sum);
                let positive_base =
                    if whole || root { format!("{} ", self.positive_value(&base, given)?) } else { String::new() };
                (self.full(&side)?, format!("exact ({lemma} _ _ {positive_base}{inner})"), side)
            }
            Form::Exponential(inner) => {
                let side = Side::Plain(inner);
                (self.full(&side)?, "apply ln_exp".to_string(), side)
            }
            _ => {
                let ExprKind::Name(r) = self.checker.atom_words(place).kind else { return Ok(None) };
                let forth = self.log_forth(poly, text, positive, using, given)?;
                if forth.is_some() {
                    return Ok(forth);
                }
                let Some((label, left)) = self.named_by(&r, using)? else { return Ok(None) };
                let plain = self.checker.read(&left, &[])?;
                if self.leads_back(&plain, &r, using)? {
                    return Ok(None);
                }
                let Some(logs) = self.logs(&plain, using, given)? else { return Ok(None) };
                let product = self.identity(&Side::Expr(left), &logs.product, &[], given)?;
                let side = logs.sum;
                let h = fact(&label);
                let tactic = format!(
                    "exact (ln_leaf _ _ {} {} (eq_trans (eq_sym {h}) {product}) eq_refl)",
                    logs.list, logs.proof
                );
                (self.full(&side)?, tactic, side)
            }
        };
        let h = self.lemma("Q", &format!("ln {text} = {statement}"), &tactic);
        Ok(Some((format!("(conj {positive} {h})"), side)))
    }

    /// The logarithm of what a factor comes to with the equations, if these change it to something else.
    fn log_forth(
        &mut self,
        poly: &Poly,
        text: &str,
        positive: &str,
        using: &[Label],
        given: &Given,
    ) -> Found<Option<(String, Side)>> {
        let words = self.checker.poly_words(poly);
        let value = self.checker.read(&words, using)?;
        if value == Fraction::of(poly) {
            return Ok(None);
        }
        if let ExprKind::Name(x) = &words.kind {
            let mut names = BTreeSet::new();
            crate::refute::expand::names_in(&self.checker.fraction_words(&value), &mut names);
            if names.contains(x) {
                return Ok(None);
            }
        }
        let Some(logs) = self.logs(&value, using, given)? else { return Ok(None) };
        let first = self.identity(&Side::Poly(poly.clone()), &Side::Expr(words.clone()), &[], given)?;
        let second = self.identity(&Side::Expr(words), &logs.product, using, given)?;
        let statement = self.full(&logs.sum)?;
        let tactic = format!("exact (ln_leaf _ _ {} {} (eq_trans {first} {second}) eq_refl)", logs.list, logs.proof);
        let h = self.lemma("Q", &format!("ln {text} = {statement}"), &tactic);
        Ok(Some((format!("(conj {positive} {h})"), logs.sum)))
    }

    /// The equation by which a variable is the name of a power.
    pub(super) fn named_by(&self, r: &str, using: &[Label]) -> Found<Option<(Label, Expr)>> {
        for label in using {
            let p = self.fact_prop(label)?;
            let (a, _, b) = self.sides(&p, "equation")?;
            if matches!(&b.kind, ExprKind::Name(n) if n == r) && !matches!(a.kind, ExprKind::Name(_)) {
                return Ok(Some((label.clone(), a.clone())));
            }
        }
        Ok(None)
    }

    /// Whether the names in a fraction come to something with this name, with the equations put in.
    fn leads_back(&mut self, f: &Fraction, r: &str, using: &[Label]) -> Found<bool> {
        let mut names = BTreeSet::new();
        crate::refute::expand::names_in(&self.checker.fraction_words(f), &mut names);
        for n in names {
            if self.printer.kinds.get(&n) != Some(&Kind::Real) {
                continue;
            }
            let value = self.checker.read(&name(&n), using)?;
            let mut inner = BTreeSet::new();
            crate::refute::expand::names_in(&self.checker.fraction_words(&value), &mut inner);
            if inner.contains(r) {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// A proof that a fraction is positive, by its factors.
    pub(super) fn positive_value(&mut self, f: &Fraction, given: &Given) -> Found<String> {
        let h = {
            let text = self.fraction(f)?;
            self.sign(&text, &Side::Value(f.clone()), &[], f, Signs::POSITIVE, given)?
        };
        Ok(format!("(to_pos _ {h})"))
    }
}
