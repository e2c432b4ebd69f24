//! Limits: at infinity, at a point, from one side, and those that are infinite; orders `f = p + O(g) as x -> a`.
//!
//! A limit at infinity with a number as its value is a statement of the kernel's language; [`crate::claim::limit`] writes the
//! others out.

use super::*;
use crate::claim::walk;

impl Parser {
    /// `of F as x -> a is L`, behind `limit`.
    pub(super) fn limit(&mut self) -> Parsed<Prop> {
        let start = self.span().start;
        self.need_word("of")?;
        let of = self.expr()?;
        self.need_word("as")?;
        let (variable, natural, towards) = self.moving()?;
        let is_declared = self.declared.contains(&variable.text);
        self.need_word("is")?;
        let minus =
            matches!(self.peek(), Kind::Sign("-" | "−")) && self.peek_at(1) == &Kind::Word(INFINITY.to_string());
        if minus {
            self.advance();
        }
        if self.word(INFINITY) {
            // What is greater than some number has the domain of the variable, which only the limit can say here.
            if is_declared {
                let message =
                    format!("{} is already declared, so it cannot be the variable of an infinite limit", variable.text);
                let help = "use a new name, declared by the limit: `as n natural -> infinity`";
                return Err(self.other(&message, Some(help), variable.span));
            }
            let value = Tendency::Infinite(if minus { Sign::Minus } else { Sign::Plus });
            let kind = PropKind::WrittenLimit(Box::new(WrittenLimit { of, variable, natural, towards, value }));
            return Ok(Prop { kind, span: self.since(start) });
        }
        let value = self.expr()?;
        let kind = match towards {
            Towards::Infinity => PropKind::Limit(Box::new(Limit { of, variable, value })),
            towards => {
                let value = Tendency::Number(value);
                PropKind::WrittenLimit(Box::new(WrittenLimit { of, variable, natural, towards, value }))
            }
        };
        Ok(Prop { kind, span: self.since(start) })
    }

    /// `x -> a`, `n natural -> infinity`, behind `as`: the variable, whether it is said to be natural, and where it goes.
    fn moving(&mut self) -> Parsed<(Name, bool, Towards)> {
        let variable = self.name("the variable that moves")?;
        let is_declared = self.declared.contains(&variable.text);
        if variable.text == PI && !is_declared {
            self.faults.push(Diagnostic::new(Fault::Pi, variable.span));
            return Err(Reported);
        }
        let domain = self.span();
        let said = self.grows(&variable);
        let (has_domain, natural) = (said.is_some(), said == Some(true));
        self.need_sign("->", "between the variable and where it goes")?;
        if self.word(INFINITY) {
            return Ok((variable, natural, Towards::Infinity));
        }
        if is_declared || has_domain {
            let message = format!("{} is already declared, so it cannot be the variable of this limit", variable.text);
            let help = "use a new name: the limit itself declares its variable";
            let span = if has_domain { domain } else { variable.span };
            return Err(self.other(&message, Some(help), span));
        }
        let point = self.expr()?;
        Ok((variable, natural, Towards::Point(point, self.side()?)))
    }

    /// `as x -> a` behind `F = P + O(G)`, where the claim does not declare O; nothing behind another comparison.
    pub(super) fn order(&mut self, sides: &[Expr], relations: &[Relation], start: usize) -> Parsed<Option<Prop>> {
        if !self.is_word("as") || self.declared.contains(ORDER) || !sides.iter().any(has_order) {
            return Ok(None);
        }
        let wrong = "O(…) is the last summand on the right of one equation";
        let ([of, right], [Relation::Equal]) = (sides, relations) else { return Err(self.no_order(wrong)) };
        let Some((about, size)) = order_of(right) else { return Err(self.no_order(wrong)) };
        if [Some(of), about.as_ref(), Some(&size)].into_iter().flatten().any(has_order) {
            return Err(self.no_order(wrong));
        }
        self.need_word("as")?;
        let (variable, natural, towards) = self.moving()?;
        let value = Tendency::Order { about, size };
        let limit = WrittenLimit { of: of.clone(), variable, natural, towards, value };
        Ok(Some(Prop { kind: PropKind::WrittenLimit(Box::new(limit)), span: self.since(start) }))
    }

    /// `S = L` or `L = S` for a sum, product or integral S from a to infinity: what it is up to a new N tends to L. N is real in an
    /// integral; else it is natural, and S goes up to N + a where a is not 0 or 1, so that the range is one for every N.
    pub(super) fn without_end(&mut self, sides: &[Expr], relations: &[Relation], start: usize) -> Parsed<Option<Prop>> {
        let Some(end) = sides.iter().find_map(infinite_end) else { return Ok(None) };
        let parts = match (sides, relations) {
            ([a, b], [Relation::Equal]) => {
                up_to_infinity(a).map(|own| (own, b)).or_else(|| Some((up_to_infinity(b)?, a)))
            }
            _ => None,
        };
        let alone = |(index, body, value): &(&Index, &Expr, &Expr)| {
            [&*index.from, *body, *value].into_iter().all(|e| infinite_end(e).is_none())
        };
        let Some((index, body, value)) = parts.map(|((i, b), value)| (i, b, value)).filter(alone) else {
            return Err(self.other("this goes on to infinity", Some(WITHOUT_END), end));
        };
        let whole = if std::ptr::eq(value, &sides[0]) { &sides[1] } else { &sides[0] };
        let natural = !matches!(whole.kind, ExprKind::IntegralOver(..));
        let variable = Name { text: self.unused(if natural { "N" } else { "X" }), span: end };
        let name = Expr { kind: ExprKind::Name(variable.text.clone()), span: end };
        let to = match &index.from.kind {
            ExprKind::Number(text) if matches!(text.as_str(), "0" | "1") => name,
            _ if !natural => name,
            _ => Expr { kind: ExprKind::Sum(vec![(Sign::Plus, name), (Sign::Plus, (*index.from).clone())]), span: end },
        };
        let (index, body) = (Index { to: Box::new(to), ..index.clone() }, Box::new(body.clone()));
        let kind = match whole.kind {
            ExprKind::SumOver(..) => ExprKind::SumOver(index, body),
            ExprKind::ProductOver(..) => ExprKind::ProductOver(index, body),
            _ => ExprKind::IntegralOver(index, body),
        };
        if self.growing.iter().all(|(name, _)| name.text != variable.text) {
            self.growing.push((variable.clone(), Some(natural)));
        }
        let of = Expr { kind, span: whole.span };
        let limit = Limit { of, variable, value: value.clone() };
        Ok(Some(Prop { kind: PropKind::Limit(Box::new(limit)), span: self.since(start) }))
    }

    /// The letter, or the first of the letter with 1, 2, … that is no word of this claim.
    fn unused(&self, letter: &str) -> String {
        let begins = |token: &Token| token.first_on_line && token.kind == Kind::Word("claim".to_string());
        let from = self.tokens[..self.at].iter().rposition(begins).unwrap_or(0);
        let rest = &self.tokens[from..];
        let claim = &rest[..rest.iter().skip(1).position(begins).map_or(rest.len(), |next| next + 1)];
        let is_free = |name: &String| {
            !self.declared.contains(name) && !claim.iter().any(|t| matches!(&t.kind, Kind::Word(word) if word == name))
        };
        let numbered = (1..).map(|k| format!("{letter}{k}"));
        std::iter::once(letter.to_string()).chain(numbered).find(is_free).unwrap_or_default()
    }

    fn no_order(&mut self, message: &str) -> Reported {
        let span = self.span();
        self.other(message, Some("write for example `f(x) = 1 + x + O(x^2) as x -> 0`"), span)
    }

    /// `from above` or `from below`, if it is said.
    fn side(&mut self) -> Parsed<Option<Sign>> {
        if !self.word("from") {
            return Ok(None);
        }
        if self.word("above") {
            return Ok(Some(Sign::Plus));
        }
        if self.word("below") { Ok(Some(Sign::Minus)) } else { Err(self.expected("`above` or `below`")) }
    }
}

/// What an infinite sum may stand in.
const WITHOUT_END: &str = "write it alone on one side of an equation, `sum(k = 0..infinity, f) = L`, or its limit: \
                           `limit of sum(k = 0..n, f) as n natural -> infinity is L`";

/// The index and body of a sum, product or integral up to infinity.
fn up_to_infinity(e: &Expr) -> Option<(&Index, &Expr)> {
    let (ExprKind::SumOver(index, body) | ExprKind::ProductOver(index, body) | ExprKind::IntegralOver(index, body)) =
        &e.kind
    else {
        return None;
    };
    matches!(&index.to.kind, ExprKind::Name(end) if end == INFINITY).then_some((index, &**body))
}

/// Where an expression goes on to infinity.
fn infinite_end(e: &Expr) -> Option<Span> {
    let mut found = up_to_infinity(e).map(|(index, _)| index.to.span);
    walk::parts(e, &mut |part| found = found.or_else(|| infinite_end(part)));
    found
}

/// Whether `O(…)` occurs in an expression.
fn has_order(e: &Expr) -> bool {
    let mut found = matches!(&e.kind, ExprKind::Apply(f, _) if f.text == ORDER);
    walk::parts(e, &mut |part| found = found || has_order(part));
    found
}

/// P and G of `P + O(G)`, or of `O(G)` without P. `P - O(G)` says the same.
fn order_of(e: &Expr) -> Option<(Option<Expr>, Expr)> {
    let size = |e: &Expr| match &e.kind {
        ExprKind::Apply(f, list) if f.text == ORDER && list.len() == 1 => list.first().cloned(),
        _ => None,
    };
    let ExprKind::Sum(terms) = &e.kind else { return size(e).map(|size| (None, size)) };
    let (last, rest) = terms.split_last()?;
    let size = size(&last.1)?;
    let about = match rest {
        [(Sign::Plus, only)] => only.clone(),
        _ => Expr { kind: ExprKind::Sum(rest.to_vec()), span: e.span },
    };
    Some((Some(about), size))
}
