//! Identities between numbers as lemmas without premises but those that they need: the powers, roots and other parts
//! of an expression become variables, each with its value, and so do the divisors.
//!
//! A divisor comes to a product of powers of factors that are not 0, so that no side condition of `field` is left open.

use super::*;
use crate::claim::definedness::Numerals;
use std::cmp::Ordering;

/// A side of an identity.
#[derive(Clone, Debug)]
pub(super) enum Side {
    /// An expression, with the equations put in.
    Expr(Expr),
    /// An unchanged fraction.
    Value(Fraction),
    /// A fraction into which the equations are put.
    Plain(Fraction),
    /// An unchanged polynomial.
    Poly(Poly),
    /// A number.
    Number(BigRational),
    /// An unchanged number.
    Whole(String),
    /// A number with its value and the proof that it has it.
    Known(String, Fraction, String),
    Times(Box<Side>, Box<Side>),
    Plus(Box<Side>, Box<Side>),
    Minus(Box<Side>, Box<Side>),
    Power(Box<Side>, u64),
    Inverse(Box<Side>),
}

impl Side {
    pub(super) fn times(self, other: Side) -> Side {
        Side::Times(Box::new(self), Box::new(other))
    }

    pub(super) fn plus(self, other: Side) -> Side {
        Side::Plus(Box::new(self), Box::new(other))
    }

    pub(super) fn minus(self, other: Side) -> Side {
        Side::Minus(Box::new(self), Box::new(other))
    }

    pub(super) fn inverse(self) -> Side {
        Side::Inverse(Box::new(self))
    }

    pub(super) fn integer(k: i64) -> Side {
        Side::Number(BigRational::from_integer(k.into()))
    }
}

/// A part that an identity takes for a variable: its text, its value and the proof that it has this value.
struct Leaf {
    text: String,
    value: Side,
    proof: String,
}

/// The variables of the identity that is being written.
#[derive(Default)]
pub(super) struct Shape {
    pub(super) atoms: Vec<String>,
    pub(super) factors: Vec<(Poly, String)>,
    leaves: Vec<Leaf>,
    not_zero: Vec<(String, String)>,
}

impl Shape {
    pub(super) fn atom(&mut self, text: String) -> String {
        let place = self.atoms.iter().position(|a| *a == text).unwrap_or_else(|| {
            self.atoms.push(text);
            self.atoms.len() - 1
        });
        format!("a__{place}")
    }

    pub(super) fn factor(&self, poly: &Poly) -> Option<String> {
        self.factors.iter().position(|f| f.0 == *poly).map(|place| format!("p__{place}"))
    }
}

impl Writer<'_> {
    /// A proof that two sides are equal.
    pub(super) fn identity(&mut self, left: &Side, right: &Side, using: &[Label], given: &Given) -> Found<String> {
        let mut shape = Shape::default();
        let left = self.short(left, using, given, &mut shape)?;
        let right = self.short(right, using, given, &mut shape)?;
        let outer = self.shape.replace(shape);
        let text = self.identity_text(&left, &right);
        let shape = std::mem::replace(&mut self.shape, outer).unwrap_or_default();
        let (left, right, values, factors, not_zero) = text?;
        if bare(&left) == bare(&right) {
            return Ok("eq_refl".to_string());
        }
        let mut names: Vec<String> = (0..shape.atoms.len()).map(|i| format!("a__{i}")).collect();
        names.extend((0..shape.factors.len()).map(|i| format!("p__{i}")));
        names.extend((0..shape.leaves.len()).map(|i| format!("x__{i}")));
        let mut premises = String::new();
        values.iter().enumerate().for_each(|(i, value)| premises += &format!("x__{i} = {value} -> "));
        factors.iter().enumerate().for_each(|(i, value)| premises += &format!("stands p__{i} {value} -> "));
        not_zero.iter().for_each(|name| premises += &format!("{name} <> 0 -> "));
        let names = if names.is_empty() { String::new() } else { format!("forall {} : R, ", names.join(" ")) };
        let lemma = self.lemma("I", &format!("{names}{premises}{left} = {right}"), "clear; identity");
        let mut words = vec![lemma];
        words.extend(shape.atoms.iter().cloned());
        words.extend(shape.factors.iter().map(|f| f.1.clone()));
        words.extend(shape.leaves.iter().map(|leaf| leaf.text.clone()));
        words.extend(shape.leaves.iter().map(|leaf| leaf.proof.clone()));
        words.extend(shape.factors.iter().map(|_| "eq_refl".to_string()));
        words.extend(shape.not_zero.iter().map(|n| n.1.clone()));
        Ok(format!("({})", words.join(" ")))
    }

    #[allow(clippy::type_complexity)]
    fn identity_text(
        &mut self,
        left: &Side,
        right: &Side,
    ) -> Found<(String, String, Vec<String>, Vec<String>, Vec<String>)> {
        let (left, right) = (self.side(left)?, self.side(right)?);
        let count = self.shape.as_ref().map_or(0, |s| s.leaves.len());
        let mut values = Vec::new();
        for i in 0..count {
            let value = self.shape.as_ref().and_then(|s| s.leaves.get(i)).map(|leaf| leaf.value.clone());
            if let Some(value) = value {
                values.push(self.side(&value)?);
            }
        }
        let polys: Vec<Poly> =
            self.shape.as_ref().map_or(Vec::new(), |s| s.factors.iter().map(|f| f.0.clone()).collect());
        let mut factors = Vec::new();
        for poly in &polys {
            factors.push(self.poly(poly)?);
        }
        let nonzero: Vec<String> =
            self.shape.as_ref().map_or(Vec::new(), |s| s.not_zero.iter().map(|n| n.0.clone()).collect());
        Ok((left, right, values, factors, nonzero))
    }

    /// The text of a side in the variables of the identity that is being written.
    pub(super) fn side(&mut self, side: &Side) -> Found<String> {
        Ok(match side {
            Side::Expr(e) => format!("({})", self.expr(e)?),
            Side::Value(f) | Side::Plain(f) => self.fraction(f)?,
            Side::Poly(poly) => match self.shape.as_ref().and_then(|shape| shape.factor(poly)) {
                Some(name) => name,
                None => self.poly(poly)?,
            },
            Side::Number(q) if q.denom().is_one() => format!("(IZR ({}))", q.numer()),
            Side::Number(q) => format!("(IZR ({}) / IZR {})", q.numer(), q.denom()),
            Side::Whole(text) | Side::Known(text, ..) => text.clone(),
            Side::Times(a, b) => format!("({} * {})", self.side(a)?, self.side(b)?),
            Side::Plus(a, b) => format!("({} + {})", self.side(a)?, self.side(b)?),
            Side::Minus(a, b) => format!("({} - {})", self.side(a)?, self.side(b)?),
            Side::Power(a, k) => format!("({} ^ {k})", self.side(a)?),
            Side::Inverse(a) => format!("(/ {})", self.side(a)?),
        })
    }

    /// A side with its leaves and divisors as variables.
    fn short(&mut self, side: &Side, using: &[Label], given: &Given, shape: &mut Shape) -> Found<Side> {
        let mut two = |a: &Side, b: &Side, writer: &mut Self| -> Found<(Side, Side)> {
            Ok((writer.short(a, using, given, shape)?, writer.short(b, using, given, shape)?))
        };
        Ok(match side {
            Side::Times(a, b) => {
                let (a, b) = two(a, b, self)?;
                a.times(b)
            }
            Side::Plus(a, b) => {
                let (a, b) = two(a, b, self)?;
                a.plus(b)
            }
            Side::Minus(a, b) => {
                let (a, b) = two(a, b, self)?;
                a.minus(b)
            }
            Side::Power(a, k) => Side::Power(Box::new(self.short(a, using, given, shape)?), *k),
            Side::Inverse(a) => {
                let base = if let Side::Power(inner, _) = &**a { inner } else { a };
                match &**base {
                    Side::Value(f) | Side::Plain(f) => {
                        for poly in f.factors.keys() {
                            self.divisor(poly, given, shape)?;
                        }
                    }
                    Side::Poly(poly) => self.divisor(poly, given, shape)?,
                    Side::Known(_, value, _) => {
                        for poly in value.factors.keys() {
                            self.divisor(poly, given, shape)?;
                        }
                    }
                    _ => {}
                }
                self.short(a, using, given, shape)?.inverse()
            }
            Side::Expr(e) => Side::Expr(self.short_expr(e, using, given, shape)?),
            Side::Value(f) => {
                self.value_divisors(f, given, shape)?;
                side.clone()
            }
            Side::Plain(f) => {
                let words = self.checker.fraction_words(f);
                let text = self.fraction(f)?;
                let (value, proof) = self.anew(f, &words, using, given)?;
                self.leaf_name(text, value, proof, given, shape)?
            }
            Side::Known(text, value, proof) => {
                self.leaf_name(text.clone(), Side::Value(value.clone()), proof.clone(), given, shape)?
            }
            Side::Poly(_) | Side::Number(_) | Side::Whole(_) => match side {
                Side::Whole(text) => Side::Whole(shape.atom(text.clone())),
                _ => side.clone(),
            },
        })
    }

    /// The value of a fraction into which the equations are put, and the proof that it has it.
    fn anew(&mut self, f: &Fraction, words: &Expr, using: &[Label], given: &Given) -> Found<(Side, String)> {
        let text = self.fraction(f)?;
        let inside = self.expr(words)?;
        let changed = self.expands && words_hold_ln(words);
        if !changed && self.checker.read(words, using)? == *f {
            return Ok((Side::Value(f.clone()), format!("(eq_refl {text})")));
        }
        let key = format!("{text} = {inside}");
        if self.busy.contains(&key) {
            return Ok((Side::Value(f.clone()), format!("(eq_refl {text})")));
        }
        self.busy.push(key);
        let result = self.anew_shown(f, words, using, given, changed);
        self.busy.pop();
        result
    }

    fn anew_shown(
        &mut self,
        f: &Fraction,
        words: &Expr,
        using: &[Label],
        given: &Given,
        changed: bool,
    ) -> Found<(Side, String)> {
        let text = self.fraction(f)?;
        let expands = std::mem::replace(&mut self.expands, false);
        let first = self.identity(&Side::Value(f.clone()), &Side::Expr(words.clone()), &[], given);
        self.expands = expands;
        let first = first?;
        if changed {
            let inside = self.expr(words)?;
            let name = self.lemma("V", &format!("{text} = {inside}"), &format!("exact {first}"));
            return Ok((Side::Expr(words.clone()), name));
        }
        let value = self.checker.read(words, using)?;
        let second = self.identity(&Side::Expr(words.clone()), &Side::Value(value.clone()), using, given)?;
        let value_text = self.fraction(&value)?;
        let name = self.lemma("V", &format!("{text} = {value_text}"), &format!("exact (eq_trans {first} {second})"));
        Ok((Side::Value(value), name))
    }

    fn leaf_name(&mut self, text: String, value: Side, proof: String, given: &Given, shape: &mut Shape) -> Found<Side> {
        if let Some(place) = shape.leaves.iter().position(|leaf| leaf.text == text) {
            return Ok(Side::Whole(format!("x__{place}")));
        }
        let value = match value {
            Side::Value(f) => {
                self.value_divisors(&f, given, shape)?;
                Side::Value(f)
            }
            other => self.short(&other, &[], given, shape)?,
        };
        shape.leaves.push(Leaf { text, value, proof });
        Ok(Side::Whole(format!("x__{}", shape.leaves.len() - 1)))
    }

    fn value_divisors(&mut self, f: &Fraction, given: &Given, shape: &mut Shape) -> Found<()> {
        for (poly, k) in &f.factors {
            if *k < 0 {
                self.divisor(poly, given, shape)?;
            }
        }
        Ok(())
    }

    /// Takes a factor of a divisor for a variable that is not 0.
    fn divisor(&mut self, poly: &Poly, given: &Given, shape: &mut Shape) -> Found<()> {
        let Some(h) = self.not_zero(poly, given)? else { return Ok(()) };
        let text = self.poly(poly)?;
        let name = match poly.single_atom() {
            Some(_) => shape.atom(text),
            None => match shape.factor(poly) {
                Some(name) => name,
                None => {
                    shape.factors.push((poly.clone(), text));
                    format!("p__{}", shape.factors.len() - 1)
                }
            },
        };
        if !shape.not_zero.iter().any(|n| n.0 == name) {
            shape.not_zero.push((name, h));
        }
        Ok(())
    }

    /// Whether an expression is a variable of an identity: a name, a power, a root, a member, a sum and so on.
    pub(super) fn is_leaf(&self, e: &Expr) -> bool {
        let natural =
            is_natural(e, &self.printer.kinds) && !matches!(e.kind, ExprKind::Number(_) | ExprKind::Power(..));
        natural
            || match &e.kind {
                ExprKind::Name(_) | ExprKind::SumOver(..) | ExprKind::ProductOver(..) | ExprKind::Derivative(..) => {
                    true
                }
                ExprKind::Apply(..) => true,
                ExprKind::Power(_, exponent) => {
                    !definedness::numerals(exponent).is_ok_and(|known| known.is_some_and(|known| known.is_whole))
                }
                _ => false,
            }
    }

    fn placeholder(&mut self, text: &str) -> Expr {
        self.printer.words.insert(text.to_string(), text.to_string());
        self.printer.kinds.insert(text.to_string(), Kind::Real);
        name(text)
    }

    /// An expression in which leaves and divisors are variables.
    fn short_expr(&mut self, e: &Expr, using: &[Label], given: &Given, shape: &mut Shape) -> Found<Expr> {
        if self.is_leaf(e) {
            let leaf = self.leaf(e, using, given)?;
            return self.short_leaf(leaf, given, shape);
        }
        let kind = match &e.kind {
            ExprKind::Product(list) => {
                let mut out = Vec::new();
                for (operator, part) in list {
                    let part = match operator {
                        Factor::Over => self.short_divisor(part, using, given, shape)?,
                        Factor::Times => self.short_expr(part, using, given, shape)?,
                    };
                    out.push((*operator, part));
                }
                ExprKind::Product(out)
            }
            ExprKind::Sum(list) => {
                let mut out = Vec::new();
                for (sign, part) in list {
                    out.push((*sign, self.short_expr(part, using, given, shape)?));
                }
                ExprKind::Sum(out)
            }
            ExprKind::Negate(inner) => ExprKind::Negate(Box::new(self.short_expr(inner, using, given, shape)?)),
            ExprKind::Power(base, exponent) => {
                let base = match definedness::numerals(exponent) {
                    Ok(Some(Numerals { sign: Ordering::Less, .. })) => self.short_divisor(base, using, given, shape)?,
                    _ => self.short_expr(base, using, given, shape)?,
                };
                ExprKind::Power(Box::new(base), exponent.clone())
            }
            other => other.clone(),
        };
        Ok(Expr { kind, span: e.span })
    }

    fn short_leaf(&mut self, leaf: Valued, given: &Given, shape: &mut Shape) -> Found<Expr> {
        let Valued { text, value, proof } = leaf;
        let name = match (&value, proof) {
            (Side::Value(f), None) => match f.factors.keys().next().and_then(Poly::single_atom) {
                Some(place) => {
                    let text = self.atom(place)?;
                    shape.atom(text)
                }
                None => shape.atom(text),
            },
            (_, None) => shape.atom(text),
            (_, Some(proof)) => match self.leaf_name(text, value, proof, given, shape)? {
                Side::Whole(name) => name,
                _ => return Err(Open::Untranslated("identity".to_string(), "a leaf")),
            },
        };
        Ok(self.placeholder(&name))
    }

    /// A divisor as a variable whose value is a product of factors that are not 0.
    fn short_divisor(&mut self, e: &Expr, using: &[Label], given: &Given, shape: &mut Shape) -> Found<Expr> {
        let f = self.checker.read(e, using)?;
        for poly in f.factors.keys() {
            self.divisor(poly, given, shape)?;
        }
        if matches!(e.kind, ExprKind::Number(_)) || (self.is_leaf(e) && !self.expands) {
            return self.short_expr(e, using, given, shape);
        }
        let text = self.expr(e)?;
        if let Some(place) = shape.leaves.iter().position(|leaf| leaf.text == text) {
            return Ok(self.placeholder(&format!("x__{place}")));
        }
        let value = self.fraction(&f)?;
        let expands = std::mem::replace(&mut self.expands, false);
        let proof = self.identity(&Side::Expr(e.clone()), &Side::Value(f.clone()), using, given);
        self.expands = expands;
        let proof = proof?;
        let name = match bare(&text) == bare(&value) {
            true => proof,
            false => self.lemma("D", &format!("{text} = {value}"), &format!("exact {proof}")),
        };
        let leaf = self.leaf_name(text, Side::Value(f), name, given, shape)?;
        match leaf {
            Side::Whole(name) => Ok(self.placeholder(&name)),
            _ => Err(Open::Untranslated("identity".to_string(), "a divisor")),
        }
    }
}

/// A part of an expression with its value; no proof where it is the value itself.
pub(super) struct Valued {
    pub(super) text: String,
    pub(super) value: Side,
    pub(super) proof: Option<String>,
}

/// A text without parentheses around it.
fn bare(text: &str) -> &str {
    let Some(inner) = text.strip_prefix('(').and_then(|t| t.strip_suffix(')')) else { return text };
    let mut depth = 0;
    for c in inner.chars() {
        match c {
            '(' => depth += 1,
            ')' => depth -= 1,
            _ => {}
        }
        if depth < 0 {
            return text;
        }
    }
    bare(inner)
}

pub(super) fn words_hold_ln(e: &Expr) -> bool {
    let mut found = matches!(&e.kind, ExprKind::Apply(f, _) if f.text == "ln");
    crate::refute::expand::parts(e, &mut |part| found = found || words_hold_ln(part));
    found
}
