//! Expressions of a formula: sums, products, powers.
//!
//! Contract: an expression is read as what it says in print, or refused. Where print leaves two readings the refusal shows both.
//! Limit: [`NESTING_LIMIT`].

use super::atom::bars;
use super::name::{UPRIGHT, argument, canonical};
use super::piece::{Piece, product};
use super::place::Placed;
use super::prepare::SPACES;
use super::refusal::{ambiguous, expected, limit, refused};
use super::scope::Scope;
use super::token::{Kind, Token, words};
use super::vector::no_vector;
use carom_diagnostic::{Diagnostic, Span};

/// The deepest nesting of parentheses, fractions and scripts in a formula.
pub(crate) const NESTING_LIMIT: usize = 100;

pub(crate) type Read<T> = Result<T, Diagnostic>;

/// Reads tokens one after the other.
pub(crate) struct Reader<'t, 's, 'n> {
    pub tokens: &'t [Token],
    pub at: usize,
    pub depth: usize,
    /// Where the whole stands, for a fault at its end.
    pub whole: Span,
    pub scope: &'s mut Scope<'n>,
}

impl<'t> Reader<'t, '_, '_> {
    pub(crate) fn peek(&mut self) -> Option<&'t Token> {
        while self.tokens.get(self.at).is_some_and(is_space) {
            self.at += 1;
        }
        self.tokens.get(self.at)
    }

    pub(crate) fn span(&mut self) -> Span {
        let end = self.whole.end;
        self.peek().map_or(Span { start: end, end }, |token| token.span)
    }

    /// The place from a byte to the end of what was read.
    pub(crate) fn since(&self, start: Span) -> Span {
        let last = self.at.checked_sub(1).and_then(|i| self.tokens.get(i)).map_or(start.end, |t| t.span.end);
        Span { start: start.start, end: last.max(start.end) }
    }

    pub(crate) fn is_next_char(&mut self, sign: char) -> bool {
        self.peek().is_some_and(|t| t.is_char(sign))
    }

    pub(crate) fn take_char(&mut self, sign: char) -> bool {
        let found = self.is_next_char(sign);
        self.at += usize::from(found);
        found
    }

    pub(crate) fn expected<T>(&mut self, what: &str) -> Read<T> {
        let span = self.span();
        let found = self.peek().map_or("the end of the formula".to_string(), |t| format!("`{}`", t.text()));
        Err(expected(what, &found, span))
    }

    /// Reads other tokens with the same knowledge, to their end.
    pub(crate) fn inside<T>(
        &mut self,
        tokens: &[Token],
        read: impl FnOnce(&mut Reader<'_, '_, '_>) -> Read<T>,
    ) -> Read<T> {
        let whole = match (tokens.first(), tokens.last()) {
            (Some(first), Some(last)) => Span { start: first.span.start, end: last.span.end.max(first.span.end) },
            _ => self.whole,
        };
        if self.depth >= NESTING_LIMIT {
            return Err(limit("levels of nesting", NESTING_LIMIT, whole));
        }
        let mut inner = Reader { tokens, at: 0, depth: self.depth + 1, whole, scope: self.scope };
        let out = read(&mut inner)?;
        match inner.peek() {
            None => Ok(out),
            Some(_) => inner.expected("the end of this part, or an operator"),
        }
    }

    /// A sum in tokens of its own.
    pub(crate) fn sum_in(&mut self, tokens: &[Token]) -> Read<Piece> {
        self.inside(tokens, |inner| inner.sum())
    }

    /// `a + b - c`
    pub(crate) fn sum(&mut self) -> Read<Piece> {
        let mut text = Placed::default();
        let mut count = 0;
        let mut only = None;
        let start = self.span();
        let mut kinds: Vec<(bool, bool)> = Vec::new();
        let (mut before_is_number, mut is_vector, mut is_matrix) = (false, false, false);
        loop {
            let span = self.span();
            let sign = self.sign(before_is_number)?;
            if count > 0 && sign.is_none() {
                break;
            }
            if count == 0 && sign == Some('+') && self.scope.double_sign.is_none_or(|s| s != span) {
                return Err(refused("a sum begins with a plus sign", "leave the sign out", span));
            }
            if self.peek().is_some_and(|t| t.is_char('+') || t.is_char('-')) {
                let span = self.span();
                return Err(refused("two signs follow each other", "write parentheses, as in a - (-b)", span));
            }
            let term = self.term()?;
            before_is_number = term.is_number;
            is_vector = is_vector || term.is_vector;
            kinds.push(term.kind());
            is_matrix = is_matrix || term.is_matrix;
            match sign {
                Some('-') if count == 0 => text.push("-", span),
                Some(sign) if count > 0 => text.push(&format!(" {sign} "), span),
                _ => {}
            }
            text.append(&term.at_least(if count == 0 && sign != Some('-') { 2 } else { 3 }));
            count += 1;
            only = Some((sign, term));
        }
        let whole = self.since(start);
        self.alike(&kinds, whole);
        match only {
            Some((Some('-'), _)) if count == 1 => Ok(Piece { is_vector, is_matrix, ..Piece::new(text, 2) }),
            Some((_, term)) if count == 1 => Ok(term),
            _ => Ok(Piece { is_vector, is_matrix, ..Piece::new(text, 1) }),
        }
    }

    /// The sign of a term, if one stands here.
    fn sign(&mut self, before_is_number: bool) -> Read<Option<char>> {
        let Some(token) = self.peek() else { return Ok(None) };
        let upper = match (token.char(), token.command()) {
            (Some(sign @ ('+' | '-')), _) => {
                self.at += 1;
                return Ok(Some(sign));
            }
            (_, Some("pm")) => true,
            (_, Some("mp")) => false,
            _ => return Ok(None),
        };
        self.at += 1;
        let next_is_number = self.peek().and_then(Token::char).is_some_and(|c| c.is_ascii_digit());
        if before_is_number && next_is_number && self.scope.decisions.is_measured != Some(false) {
            if self.scope.decisions.is_measured.is_some() {
                let help = "write it alone behind = or \\approx; `%carom pm or` says that two values are meant";
                return Err(refused("a measured value with its uncertainty is not read here", help, token.span));
            }
            return Err(super::measured::two_readings(true, token.span));
        }
        self.scope.double_sign = Some(token.span);
        Ok(Some(if upper == self.scope.upper { '+' } else { '-' }))
    }

    /// A product: factors side by side, or with signs between them.
    pub(crate) fn term(&mut self) -> Read<Piece> {
        let start = self.span();
        let mut factors: Vec<(bool, Piece)> = Vec::new();
        // Where a slash was, and its divisor.
        let mut slash: Option<Span> = None;
        while let Some(token) = self.peek() {
            let span = token.span;
            let mut divides = false;
            let is_first = factors.is_empty();
            let mut is_explicit = false;
            if token.is("cdot") || token.is("times") || token.is_char('*') || token.is("ast") {
                is_explicit = true;
            } else if token.is_char('/') || token.is("div") {
                (is_explicit, divides) = (true, true);
            }
            if is_explicit {
                if is_first {
                    return self.expected("a factor");
                }
                self.at += 1;
                if self.peek().is_none() || self.is_next_char('-') {
                    return self.expected("a factor; write a negative one in parentheses");
                }
            } else if !is_first && !self.begins_factor() {
                break;
            }
            if slash.is_some() {
                let what = "what follows a quotient with `/`";
                let readings = ["a factor behind the quotient, (a/b)c", "a factor of the divisor, a/(bc)"];
                let write = ["write \\frac{a}{b} c", "write a/(bc) or \\frac{a}{bc}"];
                return Err(ambiguous(what, readings, write, Span { start: start.start, end: span.end }));
            }
            let digits = self.peek().and_then(Token::char).is_some_and(|c| c.is_ascii_digit());
            let is_said = factors
                .last()
                .and_then(|(_, before)| before.name.as_ref())
                .is_some_and(|n| self.scope.names.factors.contains(n));
            if !is_explicit && digits && !is_first && !is_said {
                let help = "write a product with \\cdot, a power x^{2}, or an index x_{2}; for a product behind the number n \
                            `%carom product n`";
                return Err(refused("a number stands behind a factor", help, span));
            }
            if !is_explicit
                && let Some((_, before)) = factors.last()
                && before.is_number
                && self.is_numeric_fraction()
            {
                let readings = ["a mixed number, two and a third", "a product, two times a third"];
                let write = ["write a sum, 2 + \\frac{1}{3}", "write 2 \\cdot \\frac{1}{3}"];
                return Err(ambiguous("a number before a fraction of numbers", readings, write, span));
            }
            if token.is("times") && factors.last().is_some_and(|(_, before)| before.is_vector) {
                return Err(no_vector("a product of vectors", span));
            }
            if let Some((false, before)) = factors.last().filter(|_| !is_explicit) {
                self.no_unit_in_letters(before)?;
            }
            if !is_explicit
                && factors.last().is_some_and(|(_, before)| before.is_number)
                && self.scope.decisions.is_measured != Some(false)
                && let Some((inner, next)) = self.parenthesis()?
                && inner.iter().all(|t| t.char().is_some_and(|c| c.is_ascii_digit()))
                && !self.is_factor(next)
            {
                return Err(super::measured::two_readings(false, span));
            }
            if !is_explicit
                && factors.last().is_some_and(|(_, before)| !before.is_number)
                && let Some((inner, next)) = self.parenthesis()?
                && inner.iter().all(|t| t.is_char('.') || t.char().is_some_and(|c| c.is_ascii_digit()))
                && self.tokens[next..].iter().all(is_space)
            {
                let readings = ["the number of this formula", "a factor"];
                let write = ["write \\tag{…}", "write \\cdot before the number"];
                return Err(ambiguous("a number in parentheses at the end", readings, write, span));
            }
            if let Some(operator) = self.operator()? {
                // A large operator reaches to the end of the product.
                factors.push((divides, operator));
                continue;
            }
            if divides {
                slash = Some(span);
            }
            let mut list = self.factor()?.into_iter();
            if let Some((_, first)) = list.next() {
                let rest: Vec<(bool, Piece)> = list.collect();
                match divides && !rest.is_empty() {
                    true => factors.push((true, product([(false, first)].into_iter().chain(rest).collect()).closed())),
                    false => {
                        factors.push((divides, first));
                        factors.extend(rest);
                    }
                }
            }
        }
        self.linear(&factors, self.since(start))?;
        if factors.is_empty() { self.expected("an expression") } else { Ok(product(factors)) }
    }

    /// Whether a factor or a sign of a product or quotient stands here.
    pub(crate) fn goes_on_as_product(&mut self) -> bool {
        self.begins_factor() || self.peek().is_some_and(|t| t.is("cdot") || t.is("times") || t.is_char('/'))
    }

    /// Whether a factor begins here without a sign before it.
    pub(crate) fn begins_factor(&mut self) -> bool {
        let Some(token) = self.peek() else { return false };
        match &token.kind {
            // Of bars that pair up the first one opens.
            Kind::Char('|') => bars(self.tokens, self.at).len().is_multiple_of(2),
            Kind::Char(c) => c.is_alphanumeric() || matches!(c, '(' | '['),
            Kind::Open => true,
            Kind::Command(name) => !matches!(
                name.as_str(),
                "le" | "leq"
                    | "leqslant"
                    | "ge"
                    | "geq"
                    | "geqslant"
                    | "ne"
                    | "neq"
                    | "lt"
                    | "gt"
                    | "approx"
                    | "equiv"
                    | "coloneqq"
                    | "in"
                    | "to"
                    | "rightarrow"
                    | "pm"
                    | "mp"
                    | "Rightarrow"
                    | "implies"
                    | "Longrightarrow"
                    | "Leftrightarrow"
                    | "iff"
                    | "Longleftrightarrow"
                    | "land"
                    | "wedge"
                    | "lor"
                    | "vee"
                    | "text"
                    | "mbox"
                    | "textrm"
                    | "textnormal"
                    | "quad"
                    | "rvert"
                    | "rfloor"
                    | "rceil"
                    | "rbrace"
                    | "rbrack"
                    | "}"
                    | "end"
                    | "propto"
                    | "sim"
                    | "simeq"
                    | "ll"
                    | "gg"
                    | "neg"
                    | "lnot"
                    | "forall"
                    | "exists"
                    | "cong"
                    | "defeq"
                    | "lesssim"
                    | "gtrsim"
                    | "mapsto"
                    | "because"
                    | "therefore"
                    | "notin"
                    | "subset"
                    | "colon"
            ),
            _ => false,
        }
    }

    /// A factor with its power; a fraction contributes several.
    pub(crate) fn factor(&mut self) -> Read<Vec<(bool, Piece)>> {
        let start = self.span();
        let Some(token) = self.peek() else { return self.expected("a factor") };
        if let Some("frac" | "dfrac" | "tfrac" | "cfrac" | "nicefrac" | "sfrac") = token.command() {
            self.at += 1;
            let (above, next) = self.fraction_part(self.at)?;
            let (below, next) = self.fraction_part(next)?;
            self.at = next;
            let above = self.sum_in(above)?;
            let below = self.sum_in(below)?;
            let mut list = above.into_factors();
            if list.len() == 1 && list[0].1.level < 4 {
                list = list.into_iter().map(|(d, piece)| (d, piece.closed())).collect();
            }
            list.push((true, if below.level < 4 { below.closed() } else { below }));
            self.linear(&list, self.since(start))?;
            return match self.peek().is_some_and(|t| t.is_char('^') || t.is_char('!')) {
                true => {
                    let base = product(list).closed();
                    Ok(vec![(false, self.raised(base, start)?)])
                }
                false => Ok(list),
            };
        }
        let base = self.atom()?;
        Ok(vec![(false, self.raised(base, start)?)])
    }

    /// An argument of a fraction; without braces a single digit, letter or command.
    fn fraction_part(&mut self, at: usize) -> Read<(&'t [Token], usize)> {
        argument(self.tokens, at)
    }

    /// What is above and behind an atom: a factorial, a power.
    pub(crate) fn raised(&mut self, base: Piece, start: Span) -> Read<Piece> {
        let mut out = base;
        if self.is_next_char('!') {
            self.at += 1;
            let span = self.since(start);
            self.number_only(&out, "a factorial of a vector", span)?;
            let mut text = out.at_least(5);
            text.push("!", span);
            out = Piece::new(text, 5);
            if self.is_next_char('!') {
                let span = self.span();
                return Err(refused("there is no n!!", "write (n!)! or a product", span));
            }
        }
        if self.is_next_char('\'') {
            let span = self.span();
            let help = "declare a name with its prime, `%carom given v' real`; write a derivative as \\frac{d}{dx}";
            return Err(refused("this prime belongs to no name", help, span));
        }
        if self.is_next_char('_') {
            let span = self.span();
            let is_behind = self.at > 0 && matches!(self.tokens[self.at - 1].char(), Some(']' | '|'));
            let help = match is_behind {
                true => "write the two values of the antiderivative, F(b) - F(a)",
                false => "put the index behind a letter",
            };
            return Err(refused("this index belongs to no name", help, span));
        }
        if self.is_next_char('^') {
            self.at += 1;
            out = self.exponent(out)?;
            if self.is_next_char('^') {
                let span = self.span();
                return Err(refused("a power of a power", "write braces, as in (x^{a})^{b} or x^{a^{b}}", span));
            }
        }
        Ok(out)
    }

    /// The exponent behind `^`.
    fn exponent(&mut self, base: Piece) -> Read<Piece> {
        let span = self.span();
        let Some(token) = self.peek() else { return self.expected("an exponent") };
        let (inner, next) = argument(self.tokens, self.at)?;
        let said = words(inner);
        let key = canonical(inner);
        let is_transpose = match inner {
            [sign] if sign.is("top") || sign.is("intercal") => true,
            // Behind a matrix; behind a number it is a power. A slanted t may be a time.
            _ if key == "t" => {
                base.is_matrix && (inner.first().is_some_and(is_upright) || base.text.text().starts_with('['))
            }
            _ => base.is_matrix && key == "T",
        };
        let is_declared = self.scope.names.spelled(&key).is_some_and(|name| self.scope.roles.contains_key(name));
        if is_transpose && is_declared && !inner.first().is_some_and(is_upright) {
            let readings = ["the transposed matrix", "a power of the matrix"];
            let write = ["write ^{\\mathrm{T}} or ^\\top", "give the number another name"];
            return Err(ambiguous(&format!("{key} above a matrix"), readings, write, span));
        }
        if is_transpose {
            self.at = next;
            return Ok(Piece { is_matrix: true, ..base.within("transpose") });
        }
        let is_mark = said.is_empty()
            || ["*", "\\dagger", "\\circ", "\\ast", "+", "-", "\\star", "\\degree"].contains(&said.as_str());
        if is_mark {
            let help = "give the name another one: `%carom name x^* as y` is not read; write y in the formula";
            return Err(refused(format!("the upper sign {said} is not read"), help, span));
        }
        let is_pair = |open, close| {
            inner.first().is_some_and(|t| t.is_char(open)) && inner.last().is_some_and(|t| t.is_char(close))
        };
        if is_pair('[', ']') || (is_pair('(', ')') && closes_at_end(inner)) {
            let readings = ["a power", "an upper index or the order of a derivative"];
            let write = ["leave the parentheses out", "write another name"];
            return Err(ambiguous("an exponent in parentheses or brackets", readings, write, span));
        }
        let digit = |t: &Token| t.char().is_some_and(|c| c.is_ascii_digit());
        if token.kind != Kind::Open && digit(token) && self.tokens.get(next).is_some_and(|t| digit(t) && !t.apart) {
            let message = "an exponent of two digits without braces prints as a power of one digit and a factor";
            return Err(refused(message, "write the braces, as in x^{12}", span));
        }
        let outer = std::mem::replace(&mut self.scope.is_exponent, true);
        let exponent = self.sum_in(inner);
        self.scope.is_exponent = outer;
        let exponent = exponent?;
        self.number_only(&base, "a power of a vector", span)?;
        self.number_only(&exponent, "a vector as an exponent", span)?;
        self.at = next;
        Ok(base.to(&exponent))
    }
}

/// Whether a token only spaces.
pub(crate) fn is_space(token: &Token) -> bool {
    token.command().is_some_and(|name| SPACES.contains(&name))
}

/// Whether a sign stands outside of all parentheses and braces.
pub(crate) fn top_level(tokens: &[Token], sign: char) -> bool {
    let mut level = 0i64;
    for token in tokens {
        match &token.kind {
            Kind::Open | Kind::Char('(' | '[') => level += 1,
            Kind::Close | Kind::Char(')' | ']') => level -= 1,
            Kind::Char(c) if *c == sign && level == 0 => return true,
            Kind::Command(name) if name == "{" || name == "begin" => level += 1,
            Kind::Command(name) if name == "}" || name == "end" => level -= 1,
            _ => {}
        }
    }
    false
}

/// Whether the parenthesis that begins these tokens closes at their end.
fn closes_at_end(tokens: &[Token]) -> bool {
    let mut level = 0i64;
    for (place, token) in tokens.iter().enumerate() {
        level += match token.char() {
            Some('(') => 1,
            Some(')') => -1,
            _ => 0,
        };
        if level == 0 {
            return place + 1 == tokens.len();
        }
    }
    false
}

/// Whether a command sets a word upright.
pub(crate) fn is_upright(token: &Token) -> bool {
    token.command().is_some_and(|name| UPRIGHT.contains(&name) && name != "text" && name != "mbox")
}
