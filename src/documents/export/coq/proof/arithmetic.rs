//! The rules of arithmetic: combinations, monotone powers, the mean, sums and products.

use super::identity::Side;
use super::limits::of_no_sum;
use super::signs::{Environment, Tree, by_sign};
use super::*;
use crate::claim::matrix::Matrices;

/// The equation that a hypothesis says; that of a derivative says that there is one, too.
pub(super) fn equation_by(left: &Expr, hypothesis: &str) -> String {
    match left.kind {
        ExprKind::Derivative(..) => format!("(is_derive_unique _ _ _ {hypothesis})"),
        _ => hypothesis.to_string(),
    }
}

/// A power or root that rises with its base.
struct Raised {
    lemma: &'static str,
    base: Expr,
    natural: Option<Expr>,
    real: Option<Expr>,
    exponent: Option<String>,
    /// What the lemma asks of the base.
    least: Signs,
}

impl Writer<'_> {
    pub(super) fn combination(
        &mut self,
        goal: &Prop,
        times: Option<&Expr>,
        terms: &[Term],
        given: &Given,
    ) -> Found<String> {
        let (a, relation, b) = self.sides(goal, "combination")?;
        let to = lower(relation);
        if self.checker.is_matrix(a) {
            return self.same_entries(a, b, given);
        }
        if let (ExprKind::Derivative(body, by), Relation::Equal) = (&a.kind, relation) {
            if by.len() > 1 {
                return self.second_derivative(body, by, given);
            }
            of_no_sum(body, by)?;
            return self.first_derivative(goal, body, times, terms, given);
        }
        let text = format!("{} - {}", self.expr(a)?, self.expr(b)?);
        let wanted = Signs::of(relation);
        if terms.is_empty() && times.is_none() {
            let h = self.sign_of_difference(&text, (a, b), wanted, given)?;
            return Ok(format!("exact (to_{to} _ _ {h})"));
        }
        let mut env = Environment::default();
        let mut tree: Option<Tree> = None;
        for term in terms {
            let product = self.product(term, &mut env, given)?;
            tree = Some(match tree {
                None => product,
                Some(before) => before.plus(product),
            });
        }
        let tree = tree.unwrap_or(Tree::Number(BigRational::from_integer(0.into())));
        let (numbers, list, proof) = env.packed();
        let difference = Side::Expr(a.clone()).minus(Side::Expr(b.clone()));
        let right = env.side(&tree);
        let Some(times) = times else {
            let equal = self.identity(&difference, &right, &given.using, given)?;
            return Ok(format!("apply to_{to}; {}", by_sign(&env, &tree, wanted, &equal)));
        };
        let f = self.checker.read(times, &given.using)?;
        let signs = self.checker.signs(&f, &given.signed)?;
        let side = Side::Expr(times.clone());
        let times = self.expr(times)?;
        let h = self.sign(&times, &side, &given.using, &f, signs, given)?;
        let equal = self.identity(&side.times(difference), &right, &given.using, given)?;
        Ok(format!(
            "apply to_{to}; exact (divided {numbers} {list} {tree} {times} {} _ {} {proof} {h} {equal} eq_refl eq_refl)",
            signs_word(signs),
            signs_word(wanted)
        ))
    }

    /// An equation of matrices, entry by entry.
    fn same_entries(&mut self, a: &Expr, b: &Expr, given: &Given) -> Found<String> {
        let matrices = Matrices::default();
        let written: Vec<(Expr, Expr)> = match (matrices.entries(a).ok().flatten(), matrices.entries(b).ok().flatten())
        {
            (Some(a), Some(b)) => a.into_iter().flatten().zip(b.into_iter().flatten()).collect(),
            _ => Vec::new(),
        };
        let (left, right) = (self.entries(a)?, self.entries(b)?);
        let width = left.first().map_or(0, Vec::len);
        let mut rows = Vec::new();
        for (i, (x, y)) in left.iter().zip(&right).enumerate() {
            let mut row = "eq_refl".to_string();
            for (j, (x, y)) in x.iter().zip(y).enumerate().rev() {
                row = format!(
                    "(same_cons _ _ _ _ _ {} {row})",
                    self.same_entry((x, y), written.get(i * width + j), given)?
                );
            }
            rows.push(row);
        }
        let rows = rows
            .into_iter()
            .rev()
            .fold("eq_refl".to_string(), |rest, row| format!("(same_cons _ _ _ _ _ {row} {rest})"));
        Ok(format!("exact {rows}"))
    }

    /// An equation of two entries: an identity, or what facts say of the entries as they are `written`.
    fn same_entry(&mut self, (x, y): (&Side, &Side), written: Option<&(Expr, Expr)>, given: &Given) -> Found<String> {
        if let Some((a, b)) = written {
            let (p, q) = (self.checker.read(a, &given.using)?, self.checker.read(b, &given.using)?);
            if !self.checker.difference_of(&p, &q)?.is_zero() {
                let text = format!("{} - {}", self.expr(a)?, self.expr(b)?);
                let h = self.sign_of_difference(&text, (a, b), Signs::of(Relation::Equal), given)?;
                let before = self.identity(x, &Side::Expr(a.clone()), &[], given)?;
                let after = self.identity(&Side::Expr(b.clone()), y, &[], given)?;
                return Ok(format!("(eq_trans {before} (eq_trans (to_eq _ _ {h}) {after}))"));
            }
        }
        self.identity(x, y, &given.using, given)
    }

    /// What a derivative is: what it comes to by itself, then the equations, a sign or facts.
    fn first_derivative(
        &mut self,
        goal: &Prop,
        body: &Expr,
        times: Option<&Expr>,
        terms: &[Term],
        given: &Given,
    ) -> Found<String> {
        let (a, _, b) = self.sides(goal, "combination")?;
        let f = self.checker.read(body, &[])?;
        for poly in f.factors.keys() {
            self.not_zero(poly, given)?;
        }
        self.positive(&f, given)?;
        let (plain, value) = (self.checker.read(a, &[])?, self.checker.read(b, &[])?);
        if plain == value {
            return Ok("derive ltac:(idtac)".to_string());
        }
        let words = self.checker.fraction_words(&plain);
        let text = self.prop(&compare(a.clone(), Relation::Equal, words.clone()))?;
        let alone = self.lemma("L", &text, "derive ltac:(idtac)");
        let (x, y) = (self.checker.read(&words, &given.using)?, self.checker.read(b, &given.using)?);
        let equal = if x == y {
            self.identity(&Side::Expr(words), &Side::Expr(b.clone()), &given.using, given)?
        } else {
            // A sign or facts say that it is the other side.
            let equation = compare(words, Relation::Equal, b.clone());
            let (text, tactic) = (self.prop(&equation)?, self.combination(&equation, times, terms, given)?);
            self.lemma("E", &text, &tactic)
        };
        Ok(format!("exact (derive_is _ _ _ _ {alone} {equal})"))
    }

    /// The hypothesis that a difference has these signs, with the equations put in or as it is.
    fn sign_of_difference(
        &mut self,
        text: &str,
        (a, b): (&Expr, &Expr),
        wanted: Signs,
        given: &Given,
    ) -> Found<String> {
        let mut using = given.using.clone();
        let (x, y) = (self.checker.read(a, &using)?, self.checker.read(b, &using)?);
        let mut f = self.checker.difference_of(&x, &y)?;
        if !self.checker.signs(&f, &given.signed)?.within(wanted) {
            using.clear();
            f = self.plain_difference(a, b)?;
        }
        let side = Side::Expr(a.clone()).minus(Side::Expr(b.clone()));
        self.sign(text, &side, &using, &f, wanted, given)
    }

    /// A term of a combination: its factor times its facts.
    fn product(&mut self, term: &Term, env: &mut Environment, given: &Given) -> Found<Tree> {
        let mut f = self.checker.read(&term.factor, &given.using)?;
        let mut using = given.using.clone();
        let signs = self.checker.signs(&f, &given.signed)?;
        let plain = self.checker.read(&term.factor, &[])?;
        let other = self.checker.signs(&plain, &given.signed)?;
        if other != signs && other.within(signs) {
            (f, using) = (plain, Vec::new());
        }
        let signs = self.checker.signs(&f, &given.signed)?;
        let text = self.expr(&term.factor)?;
        let side = Side::Expr(term.factor.clone());
        let h = self.sign(&text, &side, &using, &f, signs, given)?;
        let mut product = env.get(text, side, signs, h);
        for label in &term.facts {
            let fact_prop = self.fact_prop(label)?;
            let (x, relation, y) = self.sides(&fact_prop, "combination")?;
            let text = format!("({} - {})", self.expr(x)?, self.expr(y)?);
            let h = match relation {
                Relation::Equal => format!("(of_eq _ _ {})", equation_by(x, &fact(label))),
                _ => format!("(of_{} _ _ {})", lower(relation), fact(label)),
            };
            let side = Side::Expr(x.clone()).minus(Side::Expr(y.clone()));
            product = product.times(env.get(text, side, Signs::of(relation), h));
        }
        Ok(product)
    }

    /// Asserts that an extremum's point lies in the domain and has the value, where signs show it.
    pub(super) fn point(&mut self, goal: &Prop, given: &Given) -> Found<()> {
        let PropKind::Extremum(extremum) = &goal.kind else { return Ok(()) };
        let at_point =
            |text: &str| extremum.at.iter().find(|p| p.0.text == text).map_or_else(|| name(text), |p| p.1.clone());
        for binding in &extremum.over {
            self.domain(binding, &at_point, given)?;
        }
        let mut values = crate::kernel::substitution::Substitution::default();
        extremum.at.iter().for_each(|(n, value)| values.replace(&n.text, value));
        let of = values.expr(&extremum.of)?;
        self.comparison(&compare(of, Relation::Equal, extremum.value.clone()), given)
    }

    pub(super) fn monotone(&mut self, goal: &Prop, from: &str, given: &Given) -> Found<String> {
        let p = self.fact_prop(from)?;
        for (low, high) in [(&p, goal), (goal, &p)] {
            let ((a, _, b), (x, _, y)) = (self.sides(low, "monotone")?, self.sides(high, "monotone")?);
            let (Some(left), Some(right)) = (self.raised(x)?, self.raised(y)?) else { continue };
            let same = key::expr(&left.base) == key::expr(a) && key::expr(&right.base) == key::expr(b);
            if !same || left.lemma != right.lemma || left.exponent != right.exponent {
                continue;
            }
            let mut words = Vec::new();
            if let Some(exponent) = &left.natural {
                words.push(format!("{}%nat ltac:(nposit)", at(self.printer.natural(exponent)?, ATOM)));
            }
            let mut asked = Vec::new();
            if let Some(exponent) = &left.real {
                asked.push((exponent.clone(), Signs::POSITIVE));
            }
            asked.extend([(left.base.clone(), left.least), (right.base.clone(), left.least)]);
            let mut hypotheses = Vec::new();
            for (e, signs) in asked {
                hypotheses.push(self.sign_of(&e, signs, given)?);
            }
            let (ha, hb) = (hypotheses.pop().unwrap_or_default(), hypotheses.pop().unwrap_or_default());
            words.extend(hypotheses.iter().map(|h| format!("_ {h}")));
            let lemma = format!("{} {}", left.lemma, words.join(" "));
            return Ok(format!("raised ({lemma} _ _ {hb} {ha}) ({lemma} _ _ {ha} {hb}) {}", fact(from)));
        }
        Err(Open::Untranslated("monotone".to_string(), "powers of other forms"))
    }

    /// A power or root with its base, its exponent and the lemma that it rises.
    fn raised(&mut self, e: &Expr) -> Found<Option<Raised>> {
        let (lemma, base, natural, real, least) = match &e.kind {
            ExprKind::Power(base, exponent) if is_natural(exponent, &self.printer.kinds) => {
                ("rise_pow", (**base).clone(), Some((**exponent).clone()), None, Signs::NOT_NEGATIVE)
            }
            ExprKind::Power(base, exponent) if is_root(exponent) => {
                ("rise_sqrt", (**base).clone(), None, None, Signs::NOT_NEGATIVE)
            }
            ExprKind::Power(base, exponent) => {
                ("rise_rpower", (**base).clone(), None, Some((**exponent).clone()), Signs::POSITIVE)
            }
            ExprKind::Apply(function, arguments) => match (function.text.as_str(), arguments.as_slice()) {
                ("sqrt", [base]) => ("rise_sqrt", base.clone(), None, None, Signs::NOT_NEGATIVE),
                ("cbrt", [base]) => ("rise_cbrt", base.clone(), None, None, Signs::POSITIVE),
                _ => return Ok(None),
            },
            _ => return Ok(None),
        };
        let exponent = natural.as_ref().or(real.as_ref()).map(key::expr);
        Ok(Some(Raised { lemma, base, natural, real, exponent, least }))
    }

    /// The hypothesis that an expression has these signs, with the equations put in or as it is.
    fn sign_of(&mut self, e: &Expr, signs: Signs, given: &Given) -> Found<String> {
        let mut using = given.using.clone();
        let mut f = self.checker.read(e, &using)?;
        if !self.checker.signs(&f, &given.signed)?.within(signs) {
            using.clear();
            f = self.checker.read(e, &using)?;
        }
        let text = self.expr(e)?;
        self.sign(&text, &Side::Expr(e.clone()), &using, &f, signs, given)
    }

    pub(super) fn unfold(&mut self, goal: &Prop) -> Found<String> {
        let (a, _, _) = self.sides(goal, "unfold")?;
        Ok(match &a.kind {
            ExprKind::SumOver(..) | ExprKind::ProductOver(..) => "split_off".to_string(),
            _ => {
                let ExprKind::Apply(_, arguments) = &a.kind else { return Ok("member ltac:(idtac)".to_string()) };
                let Some(index) = arguments.first() else { return Ok("member ltac:(idtac)".to_string()) };
                let index = self.checker.read(index, &[])?;
                let before = self.checker.difference_of(&index, &Fraction::integer(1))?;
                if before.coefficient.is_negative() {
                    return Ok("member ltac:(idtac)".to_string());
                }
                let before = self.checker.fraction_words(&before);
                let before = at(self.printer.natural(&before)?, ATOM);
                format!("first [member ltac:(idtac) | member_at {before}%nat]")
            }
        })
    }

    pub(super) fn mean(&mut self, goal: &Prop, with: &[(Name, Expr)], given: &Given) -> Found<String> {
        let (_, relation, _) = self.sides(goal, "mean")?;
        let value = |text: &str| with.iter().find(|w| w.0.text == text).map(|w| w.1.clone());
        let (Some(a), Some(b), Some(p)) = (value("a"), value("b"), value("p")) else {
            return Err(Open::Untranslated("mean".to_string(), "its values"));
        };
        let strict = relation == Relation::Less;
        let rest = sum(vec![(Sign::Plus, crate::kernel::statement::numeral(1)), (Sign::Minus, p.clone())]);
        let mut asked = vec![(a.clone(), Signs::POSITIVE), (b.clone(), Signs::POSITIVE)];
        let least = if strict { Signs::POSITIVE } else { Signs::NOT_NEGATIVE };
        asked.extend([(p.clone(), least), (rest, least)]);
        if strict {
            asked.push((sum(vec![(Sign::Plus, a.clone()), (Sign::Minus, b.clone())]), Signs::NOT_ZERO));
        }
        let mut hypotheses = Vec::new();
        for (e, signs) in asked {
            hypotheses.push(self.sign_of(&e, signs, given)?);
        }
        let (a, b, p) = (self.expr(&a)?, self.expr(&b)?, self.expr(&p)?);
        let lemma = if strict { "mean_strict_signs" } else { "mean_weak_signs" };
        Ok(format!("exact ({lemma} {a} {b} {p} {})", hypotheses.join(" ")))
    }

    pub(super) fn tangent(&mut self, goal: &Prop, with: &[(Name, Expr)], given: &Given) -> Found<String> {
        let (_, relation, _) = self.sides(goal, "tangent")?;
        let [(_, x)] = with else { return Err(Open::Untranslated("tangent".to_string(), "its value")) };
        let text = self.expr(x)?;
        if relation != Relation::Less {
            return Ok(format!("exact (tangent_weak {text})"));
        }
        let f = self.checker.read(x, &given.using)?;
        let sign = self.sign(&text, &Side::Expr(x.clone()), &given.using, &f, Signs::NOT_ZERO, given)?;
        Ok(format!("exact (tangent_strict {text} {sign})"))
    }

    /// A comparison of whole numbers with one between them, from the strict one.
    pub(super) fn integer(&mut self, goal: &Prop, from: &str, given: &Given) -> Found<String> {
        let strict = self.fact_prop(from)?;
        let ((x, less, y), (c, at_most, d)) = (self.sides(&strict, "integer")?, self.sides(goal, "integer")?);
        let (x, y) = if less == Relation::Less { (x, y) } else { (y, x) };
        let (below, above, turned) = match at_most {
            Relation::LessEqual => (c, d, ""),
            _ => (d, c, "Rle_ge _ _ "),
        };
        let (low, high) = (self.checker.read(x, &given.using)?, self.checker.read(y, &given.using)?);
        let difference = self.checker.difference_of(&high, &low)?;
        let value = Side::Value(difference.clone());
        let whole = self.fraction(&difference)?;
        let whole = self.lemma("N", &format!("whole {whole}"), "is_whole");
        let first = Side::Expr(y.clone()).minus(Side::Expr(x.clone()));
        let second = Side::Expr(above.clone()).minus(Side::Expr(below.clone()));
        let first = self.identity(&first, &value, &given.using, given)?;
        let second = self.identity(&second, &value.minus(Side::integer(1)), &given.using, given)?;
        Ok(format!("exact ({turned}(whole_step _ _ _ _ _ {whole} {} {first} {second}))", fact(from)))
    }

    /// What is true at a point, with the numbers put in that names stand for.
    pub(super) fn evaluate(&mut self, using: &[Label]) -> Found<String> {
        let equations: String = using.iter().map(|label| format!("rewrite ?{}; ", fact(label))).collect();
        Ok(format!("first [evaluated | ({equations}evaluated)]"))
    }

    pub(super) fn equation(&self, e: &Expr, using: &[Label]) -> Option<(Label, Expr)> {
        let wanted = key::expr(e);
        using.iter().find_map(|label| {
            let p = self.fact_prop(label).ok()?;
            let PropKind::Compare(sides, _) = &p.kind else { return None };
            let [a, b] = sides.as_slice() else { return None };
            (key::expr(a) == wanted).then(|| (label.clone(), b.clone()))
        })
    }
}
