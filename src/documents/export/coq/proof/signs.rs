//! The signs of numbers: trees of sums, products and powers over numbers whose signs are known, for the library's function
//! that computes signs.

use super::arithmetic::equation_by;
use super::identity::Side;
use super::*;

/// A tree of sums, products, powers and inverses; the entries are those of an [`Environment`].
#[derive(Clone, Debug)]
pub(super) enum Tree {
    Entry(usize),
    Number(BigRational),
    Times(Box<Tree>, Box<Tree>),
    Plus(Box<Tree>, Box<Tree>),
    Power(Box<Tree>, u64),
    Inverse(Box<Tree>),
    /// A polynomial, with its terms.
    Poly(Poly, Box<Tree>),
}

impl Tree {
    pub(super) fn times(self, other: Tree) -> Tree {
        Tree::Times(Box::new(self), Box::new(other))
    }

    pub(super) fn plus(self, other: Tree) -> Tree {
        Tree::Plus(Box::new(self), Box::new(other))
    }

    fn power(self, k: u64) -> Tree {
        if k == 1 { self } else { Tree::Power(Box::new(self), k) }
    }
}

/// In the library's words.
impl std::fmt::Display for Tree {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Tree::Entry(place) => write!(f, "(SA {place})"),
            Tree::Number(q) => write!(f, "(SN ({}) {})", q.numer(), q.denom()),
            Tree::Times(a, b) => write!(f, "(SM {a} {b})"),
            Tree::Plus(a, b) => write!(f, "(SP {a} {b})"),
            Tree::Power(a, k) => write!(f, "(SW {a} {k})"),
            Tree::Inverse(a) => write!(f, "(SI {a})"),
            Tree::Poly(_, a) => write!(f, "{a}"),
        }
    }
}

/// The numbers that a question of signs is about, each with its signs and the hypothesis that says so.
#[derive(Default)]
pub(super) struct Environment {
    items: Vec<(String, Signs, String, Side)>,
}

impl Environment {
    /// The entry for a number; a new one if there is none.
    pub(super) fn get(&mut self, text: String, side: Side, signs: Signs, hypothesis: String) -> Tree {
        let place = self.items.iter().position(|item| item.0 == text && item.1 == signs).unwrap_or_else(|| {
            self.items.push((text, signs, hypothesis, side));
            self.items.len() - 1
        });
        Tree::Entry(place)
    }

    /// The numbers, their signs, and the proof.
    pub(super) fn packed(&self) -> (String, String, String) {
        let list = |parts: Vec<String>| format!("[{}]", parts.join("; "));
        let proof = self.items.iter().rev().fold("I".to_string(), |rest, item| format!("(conj {} {rest})", item.2));
        (
            list(self.items.iter().map(|item| item.0.clone()).collect()),
            list(self.items.iter().map(|item| signs_word(item.1)).collect()),
            proof,
        )
    }

    /// The signs of a tree by those of its entries.
    fn signs(&self, tree: &Tree) -> Signs {
        match tree {
            Tree::Entry(place) => self.items.get(*place).map_or(Signs::ANY, |item| item.1),
            Tree::Number(q) => Signs::of_number(q),
            Tree::Times(a, b) => self.signs(a).times(self.signs(b)),
            Tree::Plus(a, b) => self.signs(a).plus(self.signs(b)),
            Tree::Power(a, k) => self.signs(a).power(i64::try_from(*k).unwrap_or(i64::MAX)),
            Tree::Inverse(a) | Tree::Poly(_, a) => self.signs(a),
        }
    }

    /// What a tree comes to.
    pub(super) fn side(&self, tree: &Tree) -> Side {
        match tree {
            Tree::Entry(place) => self.items.get(*place).map_or(Side::integer(0), |item| item.3.clone()),
            Tree::Number(q) => Side::Number(q.clone()),
            Tree::Times(a, b) => self.side(a).times(self.side(b)),
            Tree::Plus(a, b) => self.side(a).plus(self.side(b)),
            Tree::Power(a, k) => Side::Power(Box::new(self.side(a)), *k),
            Tree::Inverse(a) => self.side(a).inverse(),
            Tree::Poly(poly, _) => Side::Poly(poly.clone()),
        }
    }
}

impl Writer<'_> {
    /// The domains, hypotheses and suppositions, and what is compared with 0: a cited fact may need them to have a value.
    fn in_scope(&self) -> Vec<Label> {
        let zero = |e: &Expr| matches!(&e.kind, ExprKind::Number(text) if text == "0");
        let simple = |p: &Prop| matches!(&p.kind, PropKind::Compare(sides, _) if sides.iter().any(zero));
        let opened = |label: &str| label.starts_with('h') || label.ends_with('s') || label.contains('d');
        let facts = self.checker.facts().filter(|(label, p)| opened(label) || simple(p));
        facts.map(|(label, _)| label.to_string()).collect()
    }

    pub(super) fn given(&mut self, show: &Show) -> Found<Given> {
        let mut by = self.in_scope();
        by.retain(|label| !show.by.contains(label));
        by.extend(show.by.iter().cloned());
        Ok(Given { signed: Rc::new(self.checker.signed(&by, &show.using)?), using: show.using.clone() })
    }

    /// The number of an atom among those of a question, with its signs.
    fn atom_item(&mut self, place: usize, given: &Given, env: &mut Environment, limit: usize) -> Found<Tree> {
        let text = self.atom(place)?;
        let wanted = self.checker.factor_signs(&Poly::atom(place), &given.signed)?;
        let mut known: Option<(Signs, String)> = None;
        let structural = match self.checker.atom_form(place) {
            Form::Natural => Some((Signs::NOT_NEGATIVE, "apply of_nat".to_string())),
            Form::Exponential(_) => Some((Signs::POSITIVE, "apply exp_is_positive".to_string())),
            Form::Power(base, exponent, false) if self.is_root(&exponent) => {
                Some(match self.checker.signs(&base, &given.signed)?.within(Signs::POSITIVE) {
                    true => {
                        let h = self.positive_value(&base, given)?;
                        (Signs::POSITIVE, format!("apply of_pos, sqrt_lt_R0; exact {h}"))
                    }
                    false => (Signs::NOT_NEGATIVE, "apply of_root".to_string()),
                })
            }
            Form::Power(_, _, false) => Some((Signs::POSITIVE, "apply rpower_is_positive".to_string())),
            Form::Power(base, _, true) if self.checker.signs(&base, &given.signed)?.within(Signs::POSITIVE) => {
                let tactic = self.positive(&base, given)?;
                Some((Signs::POSITIVE, format!("{tactic}apply power_is_positive; pos")))
            }
            Form::Power(base, _, true) if base.as_integer().is_some_and(|k| k != 0) => {
                Some((Signs::NOT_ZERO, "apply of_nz, pow_nonzero; lra".to_string()))
            }
            Form::Logarithm(inner) if wanted != Signs::ANY => {
                let tactic = self.positive(&inner, given)?;
                let shifted = self.checker.difference_of(&inner, &Fraction::integer(1))?;
                let plain = inner.clone();
                let inner = self.fraction(&inner)?;
                let side = Side::Value(plain).minus(Side::integer(1));
                let h = self.sign(&format!("{inner} - 1"), &side, &[], &shifted, wanted, given)?;
                Some((wanted, format!("{tactic}apply ln_sign; [pos | exact {h}]")))
            }
            Form::Member(true) if wanted != Signs::ANY => {
                return Err(Open::Untranslated(text, "the sign that a definition gives to the members of a sequence"));
            }
            Form::Member(false) if wanted != Signs::ANY => Some((wanted, format!("family {text}"))),
            Form::Over(false) if wanted.within(Signs::POSITIVE) => Some((wanted, "over_positive".to_string())),
            Form::Over(true) if wanted.within(Signs::NOT_NEGATIVE) => {
                Some((Signs::NOT_NEGATIVE, "over_not_negative".to_string()))
            }
            Form::Over(true) if wanted != Signs::ANY => {
                return Err(Open::Untranslated(text, "the sign of a sum that is not positive"));
            }
            _ => None,
        };
        let mut noted: Vec<usize> = (0..given.signed.notes.len().min(limit))
            .filter(|n| given.signed.notes.get(*n).is_some_and(|note| note.factor == Poly::atom(place)))
            .collect();
        // Facts about this alone come first: others say it by way of their other factors, which may rest on it.
        noted.sort_by_key(|n| given.signed.notes.get(*n).map(|note| note.difference.factors.len()));
        for n in noted {
            let Some(note) = given.signed.notes.get(n) else { continue };
            let signs = note.signs;
            if known.as_ref().is_some_and(|k| k.0.within(signs)) || known.as_ref().is_some_and(|k| k.0.within(wanted)) {
                continue;
            }
            let Some(h) = self.note(n, given)? else { continue };
            known = Some(match known {
                None => (signs, h),
                Some((old, other)) => (old.and(signs), format!("(both _ _ _ {other} {h})")),
            });
        }
        if known.as_ref().is_none_or(|k| !k.0.within(wanted))
            && let Some((signs, tactic)) = structural
        {
            let h = self.lemma("G", &format!("holds {} {text}", signs_word(signs)), &tactic);
            known = Some(match known {
                None => (signs, h),
                Some((old, other)) => (old.and(signs), format!("(both _ _ _ {other} {h})")),
            });
        }
        let (signs, h) = known.unwrap_or((Signs::ANY, format!("(holds_any {text})")));
        Ok(env.get(text, Side::Value(Fraction::atom(place)), signs, h))
    }

    /// The tree of a polynomial for the question of its signs; `hole` is entry 0.
    fn poly_tree(
        &mut self,
        poly: &Poly,
        given: &Given,
        env: &mut Environment,
        hole: Option<&Poly>,
        limit: usize,
    ) -> Found<Tree> {
        if hole == Some(poly) {
            return Ok(Tree::Entry(0));
        }
        if let Some(place) = poly.single_atom() {
            return self.atom_item(place, given, env, limit);
        }
        let mut termwise = Signs::ZERO;
        for (monomial, c) in poly.terms() {
            let mut term = Signs::of_number(c);
            for (place, k) in monomial {
                let atom = self.checker.factor_signs(&Poly::atom(*place), &given.signed)?;
                term = term.times(atom.power(i64::from(*k)));
            }
            termwise = termwise.plus(term);
        }
        let all = self.checker.factor_signs(poly, &given.signed)?;
        if all != termwise {
            let mut known: Option<(Signs, String)> = None;
            for n in 0..given.signed.notes.len().min(limit) {
                let Some(note) = given.signed.notes.get(n) else { continue };
                let signs = note.signs;
                if note.factor != *poly || known.as_ref().is_some_and(|k| k.0.within(signs)) {
                    continue;
                }
                let Some(h) = self.note(n, given)? else { continue };
                known = Some(match known {
                    None => (signs, h),
                    Some((old, other)) => (old.and(signs), format!("(both _ _ _ {other} {h})")),
                });
            }
            if let Some((signs, h)) = known {
                let text = self.poly(poly)?;
                if !signs.within(all) {
                    let mut inner = Environment::default();
                    let tree = self.term_tree(poly, given, &mut inner, limit)?;
                    let equal = self.identity(&Side::Poly(poly.clone()), &inner.side(&tree), &[], given)?;
                    let tactic = by_sign(&inner, &tree, termwise, &equal);
                    let other = self.lemma("U", &format!("holds {} {text}", signs_word(termwise)), &tactic);
                    let h = format!("(both _ _ _ {h} {other})");
                    let both = self.lemma("U", &format!("holds {} {text}", signs_word(all)), &format!("exact {h}"));
                    return Ok(env.get(text, Side::Poly(poly.clone()), all, both));
                }
                let h = self.lemma("U", &format!("holds {} {text}", signs_word(signs)), &format!("exact {h}"));
                return Ok(env.get(text, Side::Poly(poly.clone()), signs, h));
            }
            // The bounds of its atoms say so: Coq finds it by linear arithmetic from what stands in the context.
            if !termwise.within(all) {
                let text = self.poly(poly)?;
                let h = self.lemma("U", &format!("holds {} {text}", signs_word(all)), "from");
                return Ok(env.get(text, Side::Poly(poly.clone()), all, h));
            }
        }
        Ok(Tree::Poly(poly.clone(), Box::new(self.term_tree(poly, given, env, limit)?)))
    }

    fn term_tree(&mut self, poly: &Poly, given: &Given, env: &mut Environment, limit: usize) -> Found<Tree> {
        let mut out: Option<Tree> = None;
        for (monomial, c) in poly.terms() {
            let mut term = (monomial.is_empty() || !c.is_one()).then(|| Tree::Number(c.clone()));
            for (place, k) in monomial {
                let item = self.atom_item(*place, given, env, limit)?.power(u64::from(*k));
                term = Some(match term {
                    None => item,
                    Some(before) => before.times(item),
                });
            }
            let Some(term) = term else { continue };
            out = Some(match out {
                None => term,
                Some(before) => before.plus(term),
            });
        }
        Ok(out.unwrap_or(Tree::Number(BigRational::from_integer(0.into()))))
    }

    /// The tree of a fraction for the question of its signs; `hole` is entry 0.
    fn tree(
        &mut self,
        f: &Fraction,
        given: &Given,
        env: &mut Environment,
        hole: Option<&Poly>,
        limit: usize,
    ) -> Found<Tree> {
        let mut out = (f.factors.is_empty() || !f.coefficient.is_one()).then(|| Tree::Number(f.coefficient.clone()));
        for (poly, k) in &f.factors {
            let mut part = self.poly_tree(poly, given, env, hole, limit)?;
            if *k < 0 && !env.signs(&part).within(Signs::NOT_ZERO) && hole != Some(poly) {
                // What is known of it here does not say so: that it is not 0 was shown.
                let text = self.poly(poly)?;
                let shown = self.shown.iter().find(|s| s.1 == format!("{text} <> 0")).map(|s| s.2.clone());
                if let Some(h) = shown {
                    part = env.get(text, Side::Poly(poly.clone()), Signs::NOT_ZERO, format!("(of_nz _ {h})"));
                }
            }
            let mut part = part.power(k.unsigned_abs());
            if *k < 0 {
                part = Tree::Inverse(Box::new(part));
            }
            out = Some(match out {
                None => part,
                Some(before) => before.times(part),
            });
        }
        Ok(out.unwrap_or(Tree::Number(BigRational::one())))
    }

    /// The hypothesis for a note: a fact's difference has the signs of its relation, and so has the one factor that is
    /// open.
    fn note(&mut self, n: usize, given: &Given) -> Found<Option<String>> {
        let Some(note) = given.signed.notes.get(n) else { return Ok(None) };
        let text = self.poly(&note.factor)?;
        let statement = format!("holds {} {text}", signs_word(note.signs));
        if self.busy.contains(&statement) {
            return Ok(None);
        }
        self.busy.push(statement);
        let result = self.note_shown(n, given);
        self.busy.pop();
        result.map(Some)
    }

    fn note_shown(&mut self, n: usize, given: &Given) -> Found<String> {
        let Some(note) = given.signed.notes.get(n) else {
            return Err(Open::Untranslated(n.to_string(), "a note that is not there"));
        };
        let text = self.poly(&note.factor)?;
        let statement = format!("holds {} {text}", signs_word(note.signs));
        if let Some(found) = self.shown.iter().find(|s| s.1 == statement) {
            return Ok(found.2.clone());
        }
        let (label, prop, f, factor) =
            (note.fact.clone(), note.prop.clone(), note.difference.clone(), note.factor.clone());
        let h = self.part(&label, &prop)?;
        let Some((a, relation, b)) = prop.single() else {
            return Err(Open::Untranslated(label, "a note of no comparison"));
        };
        let mut env =
            Environment { items: vec![(text.clone(), Signs::ANY, String::new(), Side::Poly(factor.clone()))] };
        if f.factors.contains_key(&factor) {
            let tree = self.tree(&f, given, &mut env, Some(&factor), n)?;
            let right = env.side(&tree);
            env.items.remove(0);
            let (numbers, signs, proof) = env.packed();
            let plain = self.plain_difference(a, b)? == f;
            let using = if plain { Vec::new() } else { given.using.clone() };
            let left = Side::Expr(a.clone()).minus(Side::Expr(b.clone()));
            let equal = self.identity(&left, &right, &using, given)?;
            let h = if relation == Relation::Equal { equation_by(a, &h) } else { h };
            let (a, b) = (self.expr(a)?, self.expr(b)?);
            let tactic = format!(
                "exact (note_sign _ {numbers} {signs} {tree} ({a} - {b}) {} {} {proof} {equal} (of_{} _ _ {h}) eq_refl)",
                signs_word(Signs::of(relation)),
                signs_word(note.signs),
                lower(relation),
            );
            return Ok(self.lemma("K", &statement, &tactic));
        }
        // p − c ≥ 0 with c > 0: p > 0.
        let using = if self.plain_difference(a, b)? == f { Vec::new() } else { given.using.clone() };
        let left = Side::Expr(a.clone()).minus(Side::Expr(b.clone()));
        let equal = self.identity(&left, &Side::Value(f), &using, given)?;
        let equal =
            if equal == "eq_refl" { String::new() } else { format!("assert (y__ := {equal}); cbv beta in y__; ") };
        let Some(note) = given.signed.notes.get(n) else { return Err(Open::Untranslated(label, "a note")) };
        let tactic = match note.signs {
            s if s == Signs::POSITIVE => format!("apply of_pos; assert (z__ := {h}); {equal}lra"),
            _ => format!("assert (z__ := {h}); {equal}from"),
        };
        Ok(self.lemma("K", &statement, &tactic))
    }

    pub(super) fn plain_difference(&mut self, a: &Expr, b: &Expr) -> Found<Fraction> {
        let (a, b) = (self.checker.read(a, &[])?, self.checker.read(b, &[])?);
        Ok(self.checker.difference_of(&a, &b)?)
    }

    /// The hypothesis that a number, which comes to a fraction, has these signs.
    pub(super) fn sign(
        &mut self,
        text: &str,
        side: &Side,
        using: &[Label],
        f: &Fraction,
        signs: Signs,
        given: &Given,
    ) -> Found<String> {
        let statement = format!("holds {} ({text})", signs_word(signs));
        if let Some(found) = self.shown.iter().find(|s| s.1 == statement) {
            return Ok(found.2.clone());
        }
        self.divisors(f, given)?;
        let mut env = Environment::default();
        let tree = self.tree(f, given, &mut env, None, usize::MAX)?;
        let equal = self.identity(side, &env.side(&tree), using, given)?;
        Ok(self.lemma("S", &statement, &by_sign(&env, &tree, signs, &equal)))
    }

    /// Asserts that the divisors of a fraction are not 0.
    pub(super) fn divisors(&mut self, f: &Fraction, given: &Given) -> Found<()> {
        for (poly, k) in &f.factors {
            if *k < 0 {
                self.not_zero(poly, given)?;
            }
        }
        Ok(())
    }

    /// The hypothesis that a factor is not 0, if signs show it.
    pub(super) fn not_zero(&mut self, poly: &Poly, given: &Given) -> Found<Option<String>> {
        self.compared(poly, Signs::NOT_ZERO, "Z", "to_nz", given)
    }

    /// The hypothesis that a factor is positive, if signs show it.
    pub(super) fn positive_fact(&mut self, poly: &Poly, given: &Given) -> Found<Option<String>> {
        self.compared(poly, Signs::POSITIVE, "P", "to_pos", given)
    }

    fn compared(
        &mut self,
        poly: &Poly,
        signs: Signs,
        letter: &str,
        lemma: &str,
        given: &Given,
    ) -> Found<Option<String>> {
        let text = self.poly(poly)?;
        let statement = if signs == Signs::POSITIVE { format!("0 < {text}") } else { format!("{text} <> 0") };
        if let Some(found) = self.shown.iter().find(|s| s.1 == statement) {
            return Ok(Some(found.2.clone()));
        }
        if self.busy.contains(&statement) {
            return Ok(None);
        }
        if !self.checker.factor_signs(poly, &given.signed)?.within(signs) {
            // The name of a positive power.
            let Some(ExprKind::Name(r)) = poly.single_atom().map(|place| self.checker.atom_words(place).kind) else {
                return Ok(None);
            };
            let Some((label, left)) = self.named_by(&r, &given.using)? else { return Ok(None) };
            let exponential = matches!(&left.kind, ExprKind::Apply(f, _) if f.text == "exp");
            let shown = match &left.kind {
                ExprKind::Power(base, exponent) if is_root(exponent) => {
                    let f = self.checker.read(base, &[])?;
                    if !self.checker.signs(&f, &given.signed)?.within(Signs::POSITIVE) {
                        return Ok(None);
                    }
                    let (text, side) = (self.expr(base)?, Side::Expr((**base).clone()));
                    let h = self.sign(&text, &side, &[], &f, Signs::POSITIVE, given)?;
                    format!("apply sqrt_lt_R0; exact (to_pos _ {h})")
                }
                ExprKind::Power(..) if !self.expr(&left)?.contains(" ^ ") => "apply exp_pos".to_string(),
                _ if exponential => "apply exp_pos".to_string(),
                _ => return Ok(None),
            };
            let positive = self.lemma("P", &format!("0 < {text}"), &format!("rewrite <- {}; {shown}", fact(&label)));
            return Ok(Some(match signs == Signs::POSITIVE {
                true => positive,
                false => self.lemma(letter, &statement, &format!("exact (Rgt_not_eq _ _ {positive})")),
            }));
        }
        self.busy.push(statement.clone());
        let h = self.sign(&text, &Side::Poly(poly.clone()), &[], &Fraction::of(poly), signs, given);
        self.busy.pop();
        let h = h?;
        Ok(Some(self.lemma(letter, &statement, &format!("exact ({lemma} _ {h})"))))
    }

    /// Asserts that the factors of a fraction are positive; returns a tactic that comes before `pos`.
    pub(super) fn positive(&mut self, f: &Fraction, given: &Given) -> Found<String> {
        for poly in f.factors.keys() {
            self.positive_fact(poly, given)?;
        }
        Ok(String::new())
    }
}

/// The proof that a number has the signs of a tree.
pub(super) fn by_sign(env: &Environment, tree: &Tree, signs: Signs, equal: &str) -> String {
    let (numbers, list, proof) = env.packed();
    format!("exact (by_sign {numbers} {list} {tree} {} _ {proof} {equal} eq_refl)", signs_word(signs))
}
