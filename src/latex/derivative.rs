//! Derivatives: `\frac{d}{dx}`, `\frac{df}{dx}`, `\frac{\partial^2 f}{\partial x \partial y}`.

use super::expression::{Read, Reader};
use super::name::{argument, base, scripts, words_of};
use super::piece::{Piece, product};
use super::place::Placed;
use super::refusal::{ambiguous, one_value, refused};
use super::scope::Role;
use super::token::Token;
use carom_diagnostic::Span;

impl Reader<'_, '_, '_> {
    /// `\frac{d}{dx}(…)`, `\frac{\partial^2 f}{\partial x^2}`
    pub(crate) fn derivative(&mut self, start: Span) -> Read<Option<Piece>> {
        let (above, next) = argument(self.tokens, self.at + 1)?;
        let (below, next) = argument(self.tokens, next)?;
        let (Some(upper), Some(lower)) = (differential(above, 0), differential(below, 0)) else { return Ok(None) };
        if above.first().is_some_and(|t| t.is_char('d')) {
            let declared = self.scope.names.spelled("d").is_some_and(|name| self.scope.roles.contains_key(name));
            if declared {
                let readings = ["a derivative", "a quotient with the number d"];
                let write = ["write \\mathrm{d}, or another name for the number", "cancel d, or give it another name"];
                return Err(ambiguous("a fraction of two d", readings, write, start));
            }
        }
        let (mut order, mut at) = (1, upper);
        if above.get(at).is_some_and(|t| t.is_char('^')) {
            let (inner, next) = argument(above, at + 1)?;
            let [digit] = inner else {
                return Err(refused("the order of this derivative is not read", "write a digit", start));
            };
            order = digit.char().and_then(|c| c.to_digit(10)).unwrap_or(0);
            at = next;
        }
        let body = &above[at..];
        let mut by: Vec<String> = Vec::new();
        let mut at = lower;
        loop {
            let Some((first, next)) = base(below, at)? else {
                return Err(refused("the variable of this derivative is not read", "write \\frac{d}{d x}", start));
            };
            let (symbol, mut next) = scripts(below, first, below[at].span, next)?;
            let name = self.inside(&below[at..next], |inside| inside.symbol())?;
            self.number_only(&name, "a derivative by a vector", symbol.span)?;
            let Some(name) = name.name else {
                return Err(refused("a derivative is by a variable", "declare it: `%carom given x real`", symbol.span));
            };
            let mut times = 1;
            if below.get(next).is_some_and(|t| t.is_char('^')) {
                let (inner, after) = argument(below, next + 1)?;
                times = inner.first().and_then(Token::char).and_then(|c| c.to_digit(10)).unwrap_or(0);
                next = after;
            }
            by.extend((0..times).map(|_| name.clone()));
            match differential(below, next) {
                Some(after) => at = after,
                None if next == below.len() => break,
                None => {
                    return Err(refused("the variable of this derivative is not read", "write \\frac{d}{d x}", start));
                }
            }
        }
        if by.len() != order as usize || by.is_empty() {
            let help = "write the same order above and below, as in \\frac{d^2 f}{d x^2}";
            return Err(refused("the orders of this derivative differ", help, start));
        }
        if !body.is_empty() && self.tokens.get(next).is_some_and(|t| t.is_char('(')) {
            let readings = ["its value at a place", "a product"];
            let write = ["define the derivative, `%carom let g(x) = derivative(f(x), x)`", "write \\cdot"];
            return Err(ambiguous("a parenthesis behind a derivative", readings, write, start));
        }
        self.at = next;
        let outer = self.scope.value.take();
        let function = if body.is_empty() { None } else { self.function_alone(body)? };
        let of = match function {
            Some(function) if by.iter().all(|name| *name == by[0]) => {
                Piece::atom(&format!("{function}({})", by[0]), start)
            }
            Some(_) => {
                let help = "write the function with its arguments, as in f(x, y)";
                return Err(refused("a function of one number is differentiated by two", help, start));
            }
            None if body.is_empty() => self.differentiated(start)?,
            None => self.sum_in(body)?,
        };
        let mentioned = words_of(of.text.text()).collect::<Vec<_>>();
        let depends = |name: &&str| self.scope.roles.get(*name).is_some_and(|role| *role != Role::Variable);
        let is_constant = |by: &String| !mentioned.contains(&by.as_str()) && !mentioned.iter().any(depends);
        if of.name.is_none() && by.iter().any(is_constant) {
            let help = "define what depends on it by its formula, or declare the derivative as a name of its own";
            return Err(refused("what is differentiated does not mention the variable", help, self.since(start)));
        }
        // A definition may hold a value that changes with the variable.
        let is_definition = |name: &&str| matches!(self.scope.roles.get(*name), Some(Role::Definition | Role::Matrix));
        if self.scope.value.is_some() || (self.scope.names.has_values(None) && mentioned.iter().any(is_definition)) {
            return Err(one_value("a function with a named value", self.since(start)));
        }
        self.scope.value = outer;
        if let Some(name) = of.name.filter(|name| of.level == 5 && by.iter().any(|by| by != name)) {
            let help = format!("define it, `%carom let {name} = …` in that variable, or differentiate the expression");
            return Err(refused(format!("{name} is a variable, which depends on no other"), help, of.text.span()));
        }
        let mut text = Placed::new("derivative(", start);
        text.append(&of.text);
        text.push(&format!(", {})", by.join(", ")), start);
        Ok(Some(Piece { is_vector: of.is_vector, ..Piece::new(text, 5) }))
    }

    /// What stands behind `\frac{d}{dx}`: one factor that ends the product.
    fn differentiated(&mut self, start: Span) -> Read<Piece> {
        let of = match self.parenthesis()? {
            Some((inner, next)) => {
                let piece = self.sum_in(inner)?;
                self.at = next;
                piece
            }
            None => product(self.factor()?),
        };
        let follows = self.peek().is_some_and(|t| t.is_char('^') || t.is_char('/') || t.is("cdot") || t.is("times"));
        if follows || self.begins_factor() {
            let readings = ["over the next factor alone", "over all that follows"];
            let write =
                ["write parentheses around the derivative", "write \\frac{d}{dx}\\left(…\\right) around all of it"];
            return Err(ambiguous("how far this derivative reaches", readings, write, start));
        }
        Ok(of)
    }
}

/// Where to read on behind d or ∂.
pub(crate) fn differential(tokens: &[Token], at: usize) -> Option<usize> {
    let token = tokens.get(at)?;
    let is_name = tokens.get(at + 1).is_some_and(|t| t.is_char('_') || t.is_char('\''));
    if (token.is_char('d') && !is_name) || token.is("partial") {
        return Some(at + 1);
    }
    let (inner, next) = argument(tokens, at + 1).ok().filter(|_| token.is("mathrm"))?;
    matches!(inner, [d] if d.is_char('d')).then_some(next)
}
