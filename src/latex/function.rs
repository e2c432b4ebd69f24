//! Commands in a formula: functions, roots, matrices, sums and products.

use super::document::{cells, end_of, environment};
use super::expression::{Read, Reader, is_space, is_upright};
use super::macros::{group, option};
use super::name::{argument, base, canonical, is_letter, scripts};
use super::piece::{Piece, product};
use super::place::Placed;
use super::refusal::{ambiguous, command, refused};
use super::symbol::commas;
use super::token::{Kind, Token};
use carom_diagnostic::Span;

/// Functions with one argument, by their commands and as upright words.
pub(crate) const FUNCTIONS: &[&str] = &[
    "sin", "cos", "tan", "cot", "sec", "csc", "arcsin", "arccos", "arctan", "exp", "ln", "log", "sinh", "cosh", "tanh",
    "coth", "sech", "det",
];
/// Functions that are quotients of others: numerator, which is 1 where none is named, and denominator.
const QUOTIENTS: &[(&str, Option<&str>, &str)] =
    &[("cot", Some("cos"), "sin"), ("sec", None, "cos"), ("csc", None, "sin"), ("coth", Some("cosh"), "sinh")];
/// Functions that LaTeX has no command for.
pub(crate) const WORDS: &[&str] =
    &["sech", "transpose", "trace", "inverse", "abs", "floor", "ceil", "cbrt", "sqrt", "binomial", "factorial"];

/// Commands that close what another one opened.
const CLOSING: &[&str] = &["rvert", "rVert", "rfloor", "rceil"];

/// What stands below and above a large sign.
type BelowAndAbove<'t> = (Option<&'t [Token]>, Option<&'t [Token]>);

impl<'t> Reader<'t, '_, '_> {
    /// An atom that begins with a command.
    pub(crate) fn command(&mut self) -> Read<Piece> {
        let start = self.span();
        let Some(token) = self.peek() else { return self.expected("an expression") };
        let name = token.command().unwrap_or_default();
        if FUNCTIONS.contains(&name) {
            self.at += 1;
            return self.function(name, start);
        }
        if is_upright(token) {
            let (inner, next) = argument(self.tokens, self.at + 1)?;
            let word = canonical(inner);
            if FUNCTIONS.contains(&word.as_str()) || WORDS.contains(&word.as_str()) {
                self.at = next;
                return self.function(&word, start);
            }
            return self.symbol();
        }
        match name {
            "sqrt" => {
                self.at += 1;
                let order = option(self.tokens, self.at);
                if let Some((_, next)) = order {
                    self.at = next;
                }
                if self.is_next_char('(') {
                    let help = "write \\sqrt{…}: without braces the root is over the parenthesis alone";
                    return Err(refused("\\sqrt has no argument in braces", help, start));
                }
                let (inner, next) = argument(self.tokens, self.at)?;
                let of = self.sum_in(inner)?;
                self.number_only(&of, "a root of a vector", start)?;
                self.at = next;
                match order.map(|(order, _)| order) {
                    None => Ok(of.within("sqrt")),
                    Some([three]) if three.is_char('3') => Ok(of.within("cbrt")),
                    Some(order) => {
                        let order = self.sum_in(order)?;
                        let mut exponent = Placed::new("1/", start);
                        exponent.append(&order.at_least(4));
                        Ok(of.to(&Piece::new(exponent, 3)).closed())
                    }
                }
            }
            "binom" | "dbinom" | "tbinom" => {
                let (above, next) = argument(self.tokens, self.at + 1)?;
                let (below, next) = argument(self.tokens, next)?;
                let mut text = self.sum_in(above)?.text.between("binomial(", ", ");
                text.append(&self.sum_in(below)?.text);
                self.at = next;
                text.push(")", start);
                Ok(Piece::new(text, 5))
            }
            "max" | "min" => self.listed(name, start),
            "lvert" => self.fenced("lvert", "rvert", "abs"),
            "lfloor" => self.fenced("lfloor", "rfloor", "floor"),
            "lceil" => self.fenced("lceil", "rceil", "ceil"),
            "begin" => self.matrix(start),
            "infty" => {
                let help = "a limit says where its variable goes: \\lim_{n \\to \\infty} … = …";
                Err(refused("infinity is no number", help, start))
            }
            "partial" => {
                Err(refused("this \\partial belongs to no derivative", "write \\frac{\\partial f}{\\partial x}", start))
            }
            _ if is_letter(name) || base(self.tokens, self.at)?.is_some() => self.symbol(),
            _ => Err(command(name, start)),
        }
    }

    /// A function's argument and power.
    fn function(&mut self, name: &str, start: Span) -> Read<Piece> {
        let base = if name == "log" { Some(self.base_of_logarithm(start)?) } else { None };
        let name = if name == "log" { "ln" } else { name };
        let mut power = None;
        if self.take_char('^') {
            let (inner, next) = argument(self.tokens, self.at)?;
            if inner.first().is_some_and(|t| t.is_char('-')) {
                let readings = ["the inverse function", "one over the function"];
                let inverse = match name {
                    "sin" | "cos" | "tan" => format!("write \\arc{name}"),
                    _ => format!("declare a name for it and assume its value, `%carom assume {name}(u) = x`"),
                };
                let write = [inverse, format!("write \\frac{{1}}{{\\{name} x}}")];
                let write = write.each_ref().map(String::as_str);
                return Err(ambiguous(&format!("\\{name}^{{-1}}"), readings, write, self.since(start)));
            }
            power = Some(self.sum_in(inner)?);
            self.at = next;
        }
        if name == "ln" && self.is_next_char('_') {
            return Err(command("log", start));
        }
        let value = if let Some((inner, next)) = self.parenthesis()? {
            let text = self.call("", inner, start)?;
            self.at = next;
            if power.is_some() && self.is_next_char('^') {
                return self.expected("one exponent");
            }
            applied(name, &text)
        } else {
            let of = self.bare_argument(name)?;
            self.number_only(&of, "a function of a vector", start)?;
            self.reach(name, start)?;
            applied(name, &of.within("").text)
        };
        let value = match base.flatten() {
            Some(base) => product(vec![(false, value), (true, base.within("ln"))]).closed(),
            None => value,
        };
        Ok(match power {
            Some(power) => value.to(&power),
            None => value,
        })
    }

    /// What the logarithm to another base is divided by, behind `\log`; nothing for the natural one.
    fn base_of_logarithm(&mut self, start: Span) -> Read<Option<Piece>> {
        if self.take_char('_') {
            let (inner, next) = argument(self.tokens, self.at)?;
            let base = self.sum_in(inner)?;
            self.at = next;
            return Ok(Some(base));
        }
        match self.scope.decisions.log_is_natural {
            Some(true) => Ok(None),
            Some(false) => Ok(Some(Piece::atom("10", start))),
            None => {
                let readings = ["the natural logarithm", "the logarithm to base 10"];
                let write = ["write `%carom log is natural`, or \\ln", "write `%carom log is decimal`, or \\log_{10}"];
                Err(ambiguous("\\log", readings, write, start))
            }
        }
    }

    /// An argument without parentheses: a name, a numeral, a numeral and a name, a root, a fraction.
    fn bare_argument(&mut self, name: &str) -> Read<Piece> {
        let span = self.span();
        if self.peek().is_some_and(|t| t.kind == Kind::Open) {
            let (inner, next) = group(self.tokens, self.at)?;
            let piece = self.inside(inner, |inside| {
                let piece = inside.bare_argument("")?;
                match inside.peek() {
                    None => Ok(piece),
                    Some(_) => {
                        Err(refused("these braces do not print", format!("write \\{name}(…) with parentheses"), span))
                    }
                }
            })?;
            self.at = next;
            return Ok(piece);
        }
        if let Some(inner) = self.peek().and_then(Token::command).filter(|c| FUNCTIONS.contains(c)) {
            // With parentheses of its own the inner function says where it ends.
            let here = self.at;
            self.at += 1;
            let is_closed = self.parenthesis()?.is_some();
            if is_closed {
                return self.function(inner, span);
            }
            self.at = here;
            return Err(refused("a function of a function without parentheses", format!("write \\{name}(…)"), span));
        }
        if self.peek().is_some_and(|t| ["frac", "dfrac", "tfrac"].iter().any(|f| t.is(f))) {
            let (above, next) = argument(self.tokens, self.at + 1)?;
            let (below, next) = argument(self.tokens, next)?;
            let (above, below) = (self.sum_in(above)?, self.sum_in(below)?);
            self.number_only(&below, "a quotient by a vector", span)?;
            let mut text = above.at_least(3);
            text.push("/", span);
            text.append(&below.at_least(5));
            self.at = next;
            return Ok(Piece { is_vector: above.is_vector, ..Piece::new(text, 3) });
        }
        let first = self.atom()?;
        let is_name = |t: &Token| t.char().is_some_and(char::is_alphabetic) || t.command().is_some_and(is_letter);
        if first.is_number && self.peek().is_some_and(is_name) {
            let second = self.atom()?;
            return Ok(product(vec![(false, first), (false, second)]));
        }
        Ok(first)
    }

    /// Refuses what follows an argument without parentheses and might belong to it.
    fn reach(&mut self, name: &str, start: Span) -> Read<()> {
        let Some(token) = self.peek() else { return Ok(()) };
        let is_function = token.command().is_some_and(|c| FUNCTIONS.contains(&c)) || is_upright(token);
        let follows = self.begins_factor() && !is_function;
        if !(follows || token.is_char('^') || token.is_char('/') || token.is_char('!')) {
            return Ok(());
        }
        let next = token.text();
        let readings =
            [format!("the function of all, \\{name}(x{next}…)"), format!("a factor behind it, \\{name}(x){next}…")];
        let write = [format!("write \\{name}(…) around all of it"), format!("write \\{name}(x) with parentheses")];
        let (readings, write) = (readings.each_ref().map(String::as_str), write.each_ref().map(String::as_str));
        let span = Span { start: start.start, end: token.span.end };
        Err(ambiguous(&format!("what follows \\{name} without parentheses"), readings, write, span))
    }

    /// `\max(a, b)`, `\max\{a, b\}`
    fn listed(&mut self, name: &str, start: Span) -> Read<Piece> {
        self.at += 1;
        let Some((inner, next)) = self.parenthesis()? else {
            let help = format!(
                "write \\{name}(a, b), or a statement: \\text{{maximum of }} f \\text{{ over }} x > 0 \\text{{ at }} x = a \\text{{ is }} b"
            );
            return Err(refused(format!("\\{name} has no list of numbers"), help, start));
        };
        let text = self.call(name, inner, start)?;
        self.at = next;
        Ok(Piece::new(text, 5))
    }

    /// `name(a, b)` in the claim language, from what stands in the parentheses.
    fn call(&mut self, name: &str, inner: &'t [Token], start: Span) -> Read<Placed> {
        let mut text = Placed::new(&format!("{name}("), start);
        for (place, part) in commas(inner).into_iter().enumerate() {
            if place > 0 {
                text.push(", ", start);
            }
            let part = self.sum_in(part)?;
            self.number_only(&part, "a function of a vector", start)?;
            text.append(&part.text);
        }
        text.push(")", start);
        Ok(text)
    }

    /// What stands between two commands that open and close.
    fn fenced(&mut self, open: &str, close: &str, function: &str) -> Read<Piece> {
        let start = self.span();
        let mut level = 0usize;
        let end = self.tokens.iter().enumerate().skip(self.at).find(|(_, t)| {
            level += usize::from(t.is(open));
            level -= usize::from(t.is(close) && level > 0);
            t.is(close) && level == 0
        });
        let Some((end, _)) = end else {
            return Err(refused(format!("\\{open} is not closed"), format!("write \\{close} where it ends"), start));
        };
        let body = &self.tokens[self.at + 1..end];
        let inner = match function {
            "abs" => self.in_bars(|reader| reader.sum_in(body))?,
            _ => self.sum_in(body)?,
        };
        self.number_only(&inner, "a function of a vector", start)?;
        self.at = end + 1;
        Ok(inner.within(function))
    }

    /// A matrix, or the determinant that `vmatrix` prints.
    fn matrix(&mut self, start: Span) -> Read<Piece> {
        let Some((name, inside)) = environment(self.tokens, self.at) else { return self.expected("an environment") };
        if !["matrix", "pmatrix", "bmatrix", "smallmatrix", "vmatrix", "psmallmatrix"].contains(&name.as_str()) {
            let help = match name.as_str() {
                "cases" => "cases stand alone on the right side of one equation",
                _ => "write a matrix as pmatrix",
            };
            return Err(refused(format!("the environment {name} is not read here"), help, start));
        }
        let Some(end) = end_of(self.tokens, inside) else {
            return Err(refused(format!("\\begin{{{name}}} is not closed"), "close it", start));
        };
        let next = environment(self.tokens, end).map_or(end + 1, |found| found.1);
        let mut text = Placed::new("[", start);
        let body = &self.tokens[inside..end];
        let rows = rows(body);
        for (place, row) in rows.iter().filter(|row| !row.is_empty()).enumerate() {
            if place > 0 {
                text.push("; ", start);
            }
            for (place, cell) in cells(row).iter().enumerate() {
                if place > 0 {
                    text.push(", ", start);
                }
                let entry = self.sum_in(cell)?;
                self.number_only(&entry, "a matrix of vectors", start)?;
                text.append(&entry.text);
            }
        }
        self.at = next;
        text.push("]", start);
        let piece = Piece::new(text, 5);
        Ok(if name == "vmatrix" { piece.within("det") } else { Piece { is_matrix: true, ..piece } })
    }

    /// A sum, a product, an integral or a derivative, with all that it reaches.
    pub(crate) fn operator(&mut self) -> Read<Option<Piece>> {
        let start = self.span();
        let Some(token) = self.peek() else { return Ok(None) };
        match token.command() {
            Some("sum") => self.over("sum", start).map(Some),
            Some("prod") => self.over("product", start).map(Some),
            Some("int") => self.integral(start).map(Some),
            Some("frac" | "dfrac" | "tfrac") => self.derivative(start),
            Some("lim") => {
                let help = "write the limit as a statement of its own: \\lim_{n \\to \\infty} (…) = …";
                Err(refused("a limit within an expression is not read", help, start))
            }
            _ => Ok(None),
        }
    }

    /// Reads a large sign, with what stands below and above it.
    pub(crate) fn below_and_above(&mut self) -> Read<BelowAndAbove<'t>> {
        self.at += 1;
        let (mut below, mut above) = (None, None);
        for _ in 0..2 {
            let sign = self.peek().and_then(Token::char);
            if sign == Some('_') || sign == Some('^') {
                let (inner, next) = argument(self.tokens, self.at + 1)?;
                if sign == Some('_') {
                    below = Some(inner)
                } else {
                    above = Some(inner)
                }
                self.at = next;
            }
        }
        Ok((below, above))
    }

    fn over(&mut self, word: &str, start: Span) -> Read<Piece> {
        let (below, above) = self.below_and_above()?;
        let range =
            "write the range of the index, \\sum_{i=1}^{n}; where it is a name, `%carom name \\sum F_x as F_net`";
        let (Some(below), Some(above)) = (below, above) else {
            return Err(refused(format!("this {word} has no range"), range, start));
        };
        let equals = below.iter().position(|t| t.is_char('='));
        let name = base(below, 0)?.map(|(first, next)| scripts(below, first, start, next)).transpose()?;
        let (Some((index, end)), Some(equals)) = (name, equals) else {
            return Err(refused(format!("the index of this {word} is not read"), range, start));
        };
        if end != equals {
            return Err(refused(format!("the index of this {word} is not read"), range, start));
        }
        let outer = std::mem::replace(&mut self.scope.counts, true);
        let ends = self.sum_in(&below[equals + 1..]).and_then(|from| Ok((from, self.upper_end(above)?)));
        self.scope.counts = outer;
        let (from, to) = ends?;
        let name = self.scope.bind(&index)?;
        let from_here = self.at;
        let body = self.term();
        self.scope.bound.pop();
        let body = body?;
        if word != "sum" {
            self.number_only(&body, "a product of vectors", start)?;
            if has_constant_end(&self.tokens[from_here..self.at], &below[0].kind) {
                let readings = ["to the last factor with its index", "over all factors that follow"];
                let write = ["write parentheses around the product", "write parentheses around what it reaches over"];
                return Err(ambiguous("how far this product reaches", readings, write, start));
            }
        }
        let rest = &self.tokens[self.at..];
        let goes_on = rest.first().is_some_and(|t| t.is_char('+') || t.is_char('-'));
        let is_relation = |t: &&Token| matches!(t.char(), Some('=' | '<' | '>')) || t.is("le") || t.is("ge");
        let first = &below[0].kind;
        if goes_on && rest.iter().take_while(|t| !is_relation(t)).any(|t| t.kind == *first) {
            let readings = ["to the sign + or -", "over all that follows"];
            let write = ["use another letter for the index behind it", "write parentheses around what it reaches over"];
            return Err(ambiguous(&format!("how far this {word} reaches"), readings, write, start));
        }
        let mut text = Placed::new(&format!("{word}({name} = "), start);
        text.append(&from.text);
        text.push("..", start);
        text.append(&to.text);
        text.push(", ", start);
        text.append(&body.text);
        text.push(")", start);
        Ok(Piece { is_vector: body.is_vector, ..Piece::new(text, 5) })
    }
}

/// A function of an argument, whose text has its parentheses.
fn applied(name: &str, argument: &Placed) -> Piece {
    let of = |function: &str| {
        let mut text = Placed::new(function, argument.span());
        text.append(argument);
        Piece::new(text, 5)
    };
    match QUOTIENTS.iter().find(|quotient| quotient.0 == name) {
        Some((_, above, below)) => {
            let above = above.map_or_else(|| Piece::atom("1", argument.span()), of);
            product(vec![(false, above), (true, of(below))]).closed()
        }
        None => of(name),
    }
}

/// The rows of a matrix.
pub(crate) fn rows(body: &[Token]) -> Vec<Vec<Token>> {
    let mut out = vec![Vec::new()];
    let mut level = 0usize;
    let mut at = 0;
    while let Some(token) = body.get(at) {
        at += 1;
        level += usize::from(token.kind == Kind::Open || token.is("begin"));
        level = level.saturating_sub(usize::from(token.kind == Kind::Close || token.is("end")));
        if level == 0 && (token.is("\\") || token.is("newline") || token.is("cr")) {
            out.push(Vec::new());
            // The space behind a row is no part of the next one.
            at += usize::from(body.get(at).is_some_and(|t| t.is_char('*') && !t.apart));
            at = option(body, at).filter(|_| !body[at].apart).map_or(at, |found| found.1);
        } else if let Some(row) = out.last_mut() {
            row.push(token.clone());
        }
    }
    out
}

/// Whether factors without the index stand behind the last one with it, or a sum or product with an index of the same name
/// stands among them: over how many of them a product reaches changes its value.
fn has_constant_end(tokens: &[Token], index: &Kind) -> bool {
    let is_operator = |t: &Token| ["sum", "prod"].iter().any(|name| t.is(name));
    let binds_again =
        |(place, t): (usize, &Token)| is_operator(t) && tokens[place..].iter().take(4).any(|t| t.kind == *index);
    if tokens.iter().enumerate().any(binds_again) {
        return true;
    }
    let Some(last) = tokens.iter().rposition(|t| t.kind == *index) else { return false };
    let mut level = 0i64;
    // Outside of all that was open at the index.
    let mut lowest = 0i64;
    let mut at = last + 1;
    for (place, token) in tokens.iter().enumerate().skip(last + 1) {
        level += token.nesting();
        if level < lowest {
            lowest = level;
            at = place + 1;
        }
    }
    // Exponents, indices, the other part of a fraction and signs behind a factor belong to it.
    loop {
        match tokens.get(at).map(|t| &t.kind) {
            Some(kind @ (Kind::Open | Kind::Char('^' | '_'))) => {
                match argument(tokens, at + usize::from(*kind != Kind::Open)) {
                    Ok((_, next)) => at = next,
                    Err(_) => return false,
                }
            }
            Some(Kind::Char('!' | '\'' | '|')) => at += 1,
            Some(Kind::Command(name)) if CLOSING.contains(&name.as_str()) || tokens.get(at).is_some_and(is_space) => {
                at += 1;
            }
            rest => return rest.is_some(),
        }
    }
}
