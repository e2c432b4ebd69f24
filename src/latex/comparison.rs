//! Comparisons in a formula: chains, lists of names, ± and cases.

use super::binding::relation_of;
use super::expression::{Read, Reader, is_space};
use super::name::{base, scripts};
use super::piece::Piece;
use super::place::Placed;
use super::refusal::{ambiguous, command, refused, unit};
use super::statement::{CONDITIONS, Said, ended, joined};
use super::token::Token;
use carom_diagnostic::Span;

impl Reader<'_, '_, '_> {
    /// `a = b < c`, or `a, b > 0` for each name
    pub(crate) fn comparison(&mut self, span: Span) -> Read<Said> {
        let count = self.names_before_relation()?;
        if count < 2 {
            return self.signed(span);
        }
        let mut names = vec![self.symbol()?];
        while self.take_char(',') {
            names.push(self.symbol()?);
        }
        let from = self.at;
        let each = names.into_iter().map(|name| {
            self.at = from;
            self.compared(name, span)
        });
        Ok(joined(each.collect::<Read<Vec<Said>>>()?, " and ", 4, 5))
    }

    /// One comparison; where it holds ± it may say one of two things.
    fn signed(&mut self, span: Span) -> Read<Said> {
        let from = self.at;
        let outside = self.scope.double_sign.take();
        let read = |reader: &mut Self| {
            reader.at = from;
            let left = reader.sum()?;
            reader.compared(left, span)
        };
        let mut said = read(self)?;
        if self.scope.double_sign.is_some() {
            let is_other = |t: &Token| relation_of(t).is_some_and(|relation| relation != "=");
            if self.scope.decisions.both_signs == Some(false) && self.tokens[from..self.at].iter().any(is_other) {
                let help = "write the statement that is meant, such as x \\ne 1 \\text{ and } x \\ne -1";
                return Err(refused("one of two values in an inequality is not read", help, span));
            }
            self.scope.signed += 1;
            if self.scope.splits {
                self.scope.upper = false;
                let lower = read(self);
                self.scope.upper = true;
                said = joined(vec![said, lower?], " or ", 3, 4);
            }
        }
        self.scope.double_sign = self.scope.double_sign.or(outside);
        Ok(said)
    }

    /// How many names with commas between them stand here before `<`, `>`, `\ne` or `\in`.
    pub(crate) fn names_before_relation(&mut self) -> Read<usize> {
        let after_space = |at: usize| {
            let spaces = self.tokens.iter().skip(at).take_while(|t| is_space(t)).count();
            at + spaces
        };
        let (mut at, mut count) = (after_space(self.at), 0);
        while let Some((first, next)) = base(self.tokens, at)? {
            let (_, next) = scripts(self.tokens, first, Span::default(), next)?;
            let next = after_space(next);
            count += 1;
            match self.tokens.get(next) {
                Some(token) if token.is_char(',') => at = after_space(next + 1),
                Some(token) if token.is("in") || relation_of(token).is_some_and(|sign| sign != "=") => {
                    return Ok(count);
                }
                _ => break,
            }
        }
        Ok(0)
    }

    /// What is compared with `left`, which stands before the sign here.
    fn compared(&mut self, mut left: Piece, span: Span) -> Read<Said> {
        let mut text = left.text.clone();
        let mut also: Vec<Said> = Vec::new();
        let mut count = 0;
        while let Some(token) = self.peek() {
            let place = token.span;
            let is_approximate = token.is("approx");
            if (is_approximate || relation_of(token) == Some("="))
                && self.begins_printed(self.at + 1, is_approximate)?
            {
                self.at += 1;
                self.number_only(&left, "a printed number for a vector", place)?;
                also.push(self.printed(&left)?);
                let behind = self.span();
                if self.peek().is_some_and(super::expression::is_upright) {
                    return Err(unit(behind));
                }
                if self.begins_factor() || self.peek().is_some_and(|t| matches!(t.char(), Some('+' | '-' | '/' | '^')))
                {
                    let help = "write the bound that is meant, as in |x - y| \\le 0.01, or `%carom skip`";
                    return Err(refused("≈ is read only before a number that stands alone", help, behind));
                }
                // What stands behind is compared with the printed number, which is not meant.
                if self.peek().is_some_and(|t| relation_of(t).is_some() || t.is("approx")) {
                    let span = self.span();
                    let help = "end the chain with the printed number";
                    return Err(refused("a chain goes on behind a rounded or measured number", help, span));
                }
            } else if let Some(relation) = relation_of(token) {
                self.at += 1;
                if relation == "=" && self.peek().is_some_and(|t| t.is("begin")) && self.is_cases() {
                    if count > 0 {
                        let help = "write the cases as an equation of their own, f(x) = \\begin{cases} … \\end{cases}";
                        return Err(refused("cases at the end of a chain", help, place));
                    }
                    return self.cases(&left);
                }
                let right = self.sum()?;
                if relation != "=" {
                    self.number_only(&left, "an order of vectors", place)?;
                    self.number_only(&right, "an order of vectors", place)?;
                }
                self.alike(&[left.kind(), right.kind()], place);
                left = right;
                text.push(&format!(" {relation} "), place);
                text.append(&left.text);
                count += 1;
            } else if token.is("in") {
                self.at += 1;
                self.number_only(&left, "an interval of vectors", place)?;
                also.push(self.member(&left)?);
            } else if let Some(modulo) =
                self.tokens[self.at..].iter().find(|t| t.is("pmod") || t.is("bmod") || t.is("mod"))
                && token.is("equiv")
            {
                return Err(command(modulo.command().unwrap_or_default(), modulo.span));
            } else if token.is("equiv") {
                let readings = ["an identity", "a definition"];
                let write = ["write =", "write := or `%carom let`"];
                return Err(ambiguous("≡", readings, write, place));
            } else if token.is_char(':') && !self.tokens.get(self.at + 1).is_some_and(|t| t.is_char('=')) {
                let help = "write a quotient, \\frac{a}{b}";
                return Err(refused("a colon between two numbers is not read", help, place));
            } else if token.is_char(':') || token.is("coloneqq") || token.is("defeq") {
                return Err(refused(
                    "a definition within a statement",
                    "put `:=` behind the name that is defined, at the front",
                    place,
                ));
            } else {
                break;
            }
        }
        if count == 0 && also.is_empty() {
            if let Some(token) = self.peek()
                && ["propto", "sim", "simeq", "ll", "gg", "cong", "lesssim", "gtrsim", "to", "rightarrow", "mapsto"]
                    .iter()
                    .any(|name| token.is(name))
            {
                return Err(command(token.command().unwrap_or_default(), token.span));
            }
            let message = "this formula compares nothing";
            return Err(refused(
                message,
                "a statement has a sign such as = or \\le; pass the formula over by `%carom skip`",
                self.since(span),
            ));
        }
        let mut list = if count > 0 { vec![Said { text, level: 6 }] } else { Vec::new() };
        list.append(&mut also);
        Ok(joined(list, " and ", 4, 5))
    }

    pub(crate) fn is_cases(&mut self) -> bool {
        super::document::environment(self.tokens, self.at).is_some_and(|(name, _)| name == "cases" || name == "dcases")
    }

    /// `f = \begin{cases} a & x > 0 \\ b & \text{otherwise} \end{cases}`: each case is an implication, and one of them holds,
    /// since the right side has no value elsewhere.
    fn cases(&mut self, left: &Piece) -> Read<Said> {
        let start = self.span();
        (self.scope.has_logic, self.scope.has_choice) = (true, true);
        let (rows, next) = self.cases_here()?;
        let (mut list, mut before): (Vec<Said>, Vec<Said>) = (Vec::new(), Vec::new());
        let mut covers = false;
        for cells in rows {
            let [value, condition] = cells.as_slice() else {
                let help = "write each case as `value & condition`";
                return Err(refused("a case without its condition", help, start));
            };
            let value = self.sum_in(&ended(value))?;
            let (condition, is_rest) = self.condition(condition, &before, start)?;
            covers = covers || is_rest;
            let mut equation = left.text.clone();
            equation.push(" = ", start);
            equation.append(&value.text);
            let case = Said { text: condition.text.clone(), level: condition.level };
            list.push(joined(vec![case, Said { text: equation, level: 6 }], " => ", 2, 3));
            before.push(condition);
        }
        self.at = next;
        if !covers {
            list.push(joined(before, " or ", 3, 4));
        }
        Ok(joined(list, " and ", 4, 5))
    }

    /// The condition of a case, and whether it is that no other holds.
    fn condition(&mut self, tokens: &[Token], before: &[Said], start: Span) -> Read<(Said, bool)> {
        self.inside(&ended(tokens), |inside| {
            if inside.take_text(&["otherwise", "else"]) {
                let list: Vec<Said> =
                    before.iter().map(|said| Said { text: said.text.clone(), level: said.level }).collect();
                let mut text = Placed::new("not ", start);
                text.append(&joined(list, " or ", 3, 4).at_least(6));
                return Ok((Said { text, level: 5 }, true));
            }
            inside.take_text(CONDITIONS);
            Ok((inside.statement()?, false))
        })
    }
}
