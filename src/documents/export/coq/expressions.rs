//! Expressions: real numbers, natural numbers, functions and matrices.

use super::super::kinds::{Kind, Kinds, is_matrix, is_natural, is_natural_name};
use super::super::{Result, Unsupported, unsupported};
use super::printer::*;
use crate::claim::definedness::{self, Exponent, TooLong};
use crate::claim::syntax::*;
use crate::number::rational;
use crate::refute::expand;
use malachite::base::num::basic::traits::One;
use std::collections::BTreeSet;

impl Printer {
    pub(super) fn real_at(&mut self, expr: &Expr, most: u8) -> Result<String> {
        Ok(at(self.real(expr)?, most))
    }

    /// A real expression.
    pub(super) fn real(&mut self, expr: &Expr) -> Result<Text> {
        if is_natural(expr, &self.kinds) && !matches!(expr.kind, ExprKind::Number(_) | ExprKind::Power(..)) {
            let inner = at(self.natural(expr)?, APPLICATION - 1);
            return Ok((format!("INR {inner}"), APPLICATION));
        }
        Ok(match &expr.kind {
            ExprKind::Number(text) => match rational::parse(text) {
                Ok(q) if *q.denominator_ref() == malachite::Natural::ONE => (q.to_string(), ATOM),
                Ok(q) => (q.to_string().replace('/', " / "), PRODUCT),
                Err(e) => return unsupported(expr.span, e.to_string()),
            },
            ExprKind::Name(name) => match self.kinds.get(name) {
                Some(Kind::Real) => (self.word(name), ATOM),
                Some(Kind::Matrix) => return unsupported(expr.span, "a matrix where a number is needed"),
                _ if name == "infinity" => return unsupported(expr.span, "infinity as a number"),
                _ => return unsupported(expr.span, format!("{name} as a number")),
            },
            ExprKind::Apply(function, arguments) => return self.apply(function, arguments, expr.span),
            ExprKind::Negate(a) => (format!("- {}", self.real_at(a, POWER)?), NEGATION),
            ExprKind::Sum(list) => {
                let mut out = String::new();
                for (i, (sign, summand)) in list.iter().enumerate() {
                    if i > 0 {
                        out.push_str(if *sign == Sign::Plus { " + " } else { " - " });
                    }
                    let text = self.real(summand)?;
                    let bare = i == 0 || text.1 != NEGATION;
                    out.push_str(&at(text, if bare { PRODUCT } else { ATOM }));
                }
                (out, SUM)
            }
            ExprKind::Product(list) => {
                let mut out = String::new();
                for (i, (operator, factor)) in list.iter().enumerate() {
                    if i > 0 {
                        out.push_str(if *operator == Factor::Times { " * " } else { " / " });
                    }
                    out.push_str(&self.real_at(factor, POWER)?);
                }
                (out, PRODUCT)
            }
            ExprKind::Power(base, exponent) => self.power(base, exponent, expr.span)?,
            ExprKind::SumOver(index, body) => self.over("sum_over", index, body)?,
            ExprKind::ProductOver(index, body) => self.over("product_over", index, body)?,
            ExprKind::Derivative(body, by) => {
                let (name, order) = same_variable(by, expr.span)?;
                let (function, x) = (self.function_of(body, name)?, self.word(&name.text));
                match order {
                    1 => (format!("Derive {function} {x}"), APPLICATION),
                    _ => (format!("Derive_n {function} {order} {x}"), APPLICATION),
                }
            }
            ExprKind::IntegralOver(..) => return unsupported(expr.span, "an integral"),
            ExprKind::Matrix(_) => return unsupported(expr.span, "a matrix where a number is needed"),
        })
    }

    /// A power by the kind of its exponent, definitions put in place: `pow` for a natural number, `sqrt` for 1/2,
    /// `Rpower` where the base is positive, by its form or because the claim has to say so.
    fn power(&mut self, base: &Expr, exponent: &Expr, span: Span) -> Result<Text> {
        let placed = self.in_place(exponent)?;
        let natural = |p: &mut Printer, e: &Expr| Ok(at(p.natural(e)?, ATOM));
        let kind = definedness::exponent(&placed, &|name| is_natural_name(name, &self.kinds))
            .map_err(|_| Unsupported::limit(TooLong::LIMIT, span))?;
        let (negative, size) = match (definedness::number(&placed), &placed.kind) {
            (Some((k, 1)), _) => (k < 0, k.unsigned_abs().to_string()),
            _ if is_natural(exponent, &self.kinds) => (false, natural(self, exponent)?),
            (_, ExprKind::Negate(inner)) if is_natural(inner, &self.kinds) => (true, natural(self, inner)?),
            _ if is_root(&placed) => {
                return Ok((format!("sqrt {}", self.real_at(base, ATOM)?), APPLICATION));
            }
            _ if !self.inside && kind != Exponent::Real && !self.is_positive(base)? => {
                let reason = match kind {
                    Exponent::Root => "a root, written as a power, of what may be 0",
                    _ => "a power of what may be 0 or negative, with an exponent that may be negative",
                };
                return unsupported(span, reason);
            }
            _ => {
                let (base, exponent) = (self.real_at(base, ATOM)?, self.real_at(exponent, ATOM)?);
                return Ok((format!("Rpower {base} {exponent}"), APPLICATION));
            }
        };
        let power = format!("{} ^ {size}", self.real_at(base, APPLICATION)?);
        Ok(if negative { (format!("/ {power}"), NEGATION) } else { (power, POWER) })
    }

    /// Whether an expression is positive by its form, definitions put in place.
    fn is_positive(&mut self, e: &Expr) -> Result<bool> {
        let placed = self.in_place(e)?;
        Ok(self.positive.holds(&placed, &self.kinds))
    }

    /// Whether a power or cube root in the value of a definition has a parameter in it and may be of another kind where
    /// the definition is used: the value has no definitions in it.
    pub(super) fn powers_depend_on(&self, name: &str, parameters: &[Name], value: &Expr) -> bool {
        let Some(Kind::Function(natural)) = self.kinds.get(name) else { return false };
        let mut kinds = self.kinds.clone();
        for (parameter, natural) in parameters.iter().zip(natural) {
            kinds.insert(parameter.text.clone(), if *natural { Kind::Natural } else { Kind::Real });
        }
        let whole = |e: &Expr| {
            let inner = if let ExprKind::Negate(inner) = &e.kind { inner } else { e };
            definedness::numerals(e).is_ok_and(|known| known.is_some_and(|known| known.is_whole))
                || is_natural(inner, &kinds)
        };
        let mut open = vec![value];
        while let Some(e) = open.pop() {
            let base = match &e.kind {
                ExprKind::Power(base, exponent) if !whole(exponent) => Some(&**base),
                ExprKind::Apply(f, arguments) if f.text == "cbrt" => arguments.first(),
                _ => None,
            };
            let mut names = BTreeSet::new();
            expand::names_in(e, &mut names);
            if base.is_some_and(|base| !self.positive.holds(base, &kinds))
                && parameters.iter().any(|p| names.contains(&p.text))
            {
                return true;
            }
            expand::parts(e, &mut |part| open.push(part));
        }
        false
    }

    fn apply(&mut self, function: &Name, arguments: &[Expr], span: Span) -> Result<Text> {
        let name = function.text.as_str();
        if self.in_place_only.contains(name) {
            let call = Expr { kind: ExprKind::Apply(function.clone(), arguments.to_vec()), span };
            let placed = self.in_place(&call)?;
            return self.real(&placed);
        }
        if is_built_in(name) {
            let [argument] = arguments else { return unsupported(span, format!("{name} of several arguments")) };
            return Ok(match name {
                "det" => (format!("det2 {}", at(self.matrix(argument)?, ATOM)), APPLICATION),
                "cos" | "sin" => return unsupported(span, "sin and cos of what is no angle"),
                "arcsin" | "arccos" | "arctan" => return unsupported(span, "arcsin, arccos and arctan"),
                "transpose" => return unsupported(span, "a matrix where a number is needed"),
                "cbrt" if !self.inside && !self.is_positive(argument)? => {
                    return unsupported(span, "the cube root of what may be 0");
                }
                _ => (format!("{name} {}", self.real_at(argument, ATOM)?), APPLICATION),
            });
        }
        let Some(Kind::Function(natural)) = self.kinds.get(name).cloned() else {
            return unsupported(span, format!("{name} as a function"));
        };
        let mut out = self.word(name);
        for (argument, natural) in arguments.iter().zip(natural) {
            out.push(' ');
            out.push_str(&if natural {
                if !is_natural(argument, &self.kinds) {
                    return unsupported(argument.span, "an index that is not natural by its form");
                }
                marked(self.natural(argument)?)
            } else {
                self.real_at(argument, ATOM)?
            });
        }
        Ok((out, APPLICATION))
    }

    /// A natural expression, for the scope of `nat`.
    pub(super) fn natural(&mut self, expr: &Expr) -> Result<Text> {
        if !is_natural(expr, &self.kinds) {
            return unsupported(expr.span, "an expression that is not natural by its form");
        }
        let listed = |p: &mut Printer, list: Vec<&Expr>, sign: &str, most: u8| -> Result<String> {
            let parts: Vec<String> = list.into_iter().map(|e| Ok(at(p.natural(e)?, most))).collect::<Result<_>>()?;
            Ok(parts.join(sign))
        };
        Ok(match &expr.kind {
            ExprKind::Number(text) => (text.clone(), ATOM),
            ExprKind::Name(name) => (self.word(name), ATOM),
            ExprKind::Sum(list) => (listed(self, list.iter().map(|p| &p.1).collect(), " + ", PRODUCT)?, SUM),
            ExprKind::Product(list) => (listed(self, list.iter().map(|p| &p.1).collect(), " * ", POWER)?, PRODUCT),
            ExprKind::Power(a, b) => (listed(self, vec![a, b], " ^ ", APPLICATION)?, POWER),
            _ => return unsupported(expr.span, "an expression that is not natural by its form"),
        })
    }

    /// The bounds of an index, for the scope of `nat`.
    pub(super) fn range(&mut self, index: &Index) -> Result<(String, String)> {
        Ok((at(self.natural(&index.from)?, SUM), at(self.natural(&index.to)?, SUM)))
    }

    fn over(&mut self, word: &str, index: &Index, body: &Expr) -> Result<Text> {
        let (from, to) = (at(self.natural(&index.from)?, ATOM), at(self.natural(&index.to)?, ATOM));
        let k = self.word(&index.name.text);
        let natural = |kinds: &mut Kinds| {
            kinds.insert(index.name.text.clone(), Kind::Natural);
        };
        let body = self.within(natural, |p| p.real(body))?.0;
        Ok((format!("{word} {from} {to} (fun {k} : nat => {body})"), APPLICATION))
    }

    /// `(fun x : R => …)`: the definitions are put in place, as they may depend on the variable.
    pub(super) fn function_of(&mut self, body: &Expr, variable: &Name) -> Result<String> {
        if self.kinds.get(&variable.text) != Some(&Kind::Real) {
            return unsupported(variable.span, "a derivative by what is no real variable");
        }
        let body = self.in_place(body)?;
        let body = self.real(&body)?.0;
        Ok(format!("(fun {} : R => {body})", self.word(&variable.text)))
    }

    pub(super) fn matrix(&mut self, expr: &Expr) -> Result<Text> {
        Ok(match &expr.kind {
            ExprKind::Matrix(rows) => {
                let mut lines = Vec::new();
                for row in rows {
                    let row: Vec<String> = row.iter().map(|e| Ok(self.real(e)?.0)).collect::<Result<_>>()?;
                    lines.push(format!("[{}]", row.join("; ")));
                }
                (format!("[{}]", lines.join("; ")), ATOM)
            }
            ExprKind::Name(name) if self.kinds.get(name) == Some(&Kind::Matrix) => (self.word(name), ATOM),
            ExprKind::Negate(a) => (format!("mat_scale (- 1) {}", at(self.matrix(a)?, ATOM)), APPLICATION),
            ExprKind::Sum(list) => {
                let mut out: Option<Text> = None;
                for (sign, summand) in list {
                    if !is_matrix(summand, &self.kinds) {
                        return unsupported(summand.span, "a number added to a matrix");
                    }
                    let mut text = at(self.matrix(summand)?, ATOM);
                    if *sign == Sign::Minus {
                        text = format!("(mat_scale (- 1) {text})");
                    }
                    out = Some(match out {
                        None => (text, ATOM),
                        Some(before) => (format!("mat_add {} {text}", at(before, ATOM)), APPLICATION),
                    });
                }
                out.unwrap_or_default()
            }
            ExprKind::Product(list) => {
                // Numbers commute with matrices: their product first, then the matrices in order.
                let (mut numbers, mut product) = (Vec::new(), None::<Text>);
                for (operator, factor) in list {
                    if !is_matrix(factor, &self.kinds) {
                        numbers.push((*operator, factor.clone()));
                        continue;
                    }
                    if *operator == Factor::Over {
                        return unsupported(factor.span, "division by a matrix");
                    }
                    let text = at(self.matrix(factor)?, ATOM);
                    product = Some(match product {
                        None => (text, ATOM),
                        Some(before) => (format!("mat_mul {} {text}", at(before, ATOM)), APPLICATION),
                    });
                }
                let product = product.unwrap_or_default();
                if numbers.is_empty() {
                    return Ok(product);
                }
                if numbers.first().is_some_and(|n| n.0 == Factor::Over) {
                    let one = Expr { kind: ExprKind::Number("1".to_string()), span: expr.span };
                    numbers.insert(0, (Factor::Times, one));
                }
                let scalar = match numbers.as_slice() {
                    [(Factor::Times, one)] => self.real_at(one, ATOM)?,
                    _ => self.real_at(&Expr { kind: ExprKind::Product(numbers), span: expr.span }, ATOM)?,
                };
                (format!("mat_scale {scalar} {}", at(product, ATOM)), APPLICATION)
            }
            ExprKind::Apply(f, _) => return unsupported(f.span, format!("{} of a matrix", f.text)),
            _ => return unsupported(expr.span, "a number where a matrix is needed"),
        })
    }
}

pub(super) fn same_variable(by: &[Name], span: Span) -> Result<(&Name, usize)> {
    match by.first() {
        Some(first) if by.iter().all(|n| n.text == first.text) => Ok((first, by.len())),
        _ => unsupported(span, "a derivative by several variables"),
    }
}

/// Whether a power with this exponent is a square root: `Rpower` is none where the base is 0.
pub(super) fn is_root(exponent: &Expr) -> bool {
    definedness::number(exponent) == Some((1, 2))
}
