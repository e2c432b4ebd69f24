//! What an expression is made of: names, numerals, parentheses, absolute values.

use super::expression::{Read, Reader, is_space, top_level};
use super::name::{argument, begin};
use super::piece::Piece;
use super::place::Placed;
use super::refusal::{ambiguous, command, refused};
use super::token::{Kind, Token};

/// Signs of parentheses, and those that close them.
const PARENTHESES: &[(&str, &str)] =
    &[("(", ")"), ("[", "]"), ("\\{", "\\}"), ("\\lbrace", "\\rbrace"), ("\\lbrack", "\\rbrack")];

impl<'t> Reader<'t, '_, '_> {
    /// The tokens between parentheses that open here, and where to read on.
    pub(crate) fn parenthesis(&mut self) -> Read<Option<(&'t [Token], usize)>> {
        let Some(token) = self.peek() else { return Ok(None) };
        let text = token.text();
        let Some((open, close)) = PARENTHESES.iter().find(|pair| pair.0 == text) else { return Ok(None) };
        let mut level = 0usize;
        let mut braces = 0usize;
        for (place, token) in self.tokens.iter().enumerate().skip(self.at) {
            match &token.kind {
                Kind::Open => braces += 1,
                Kind::Close => match braces.checked_sub(1) {
                    Some(less) => braces = less,
                    None => break,
                },
                _ if braces > 0 => {}
                _ if token.text() == *open => level += 1,
                _ if token.text() == *close => {
                    level -= 1;
                    if level == 0 {
                        return Ok(Some((&self.tokens[self.at + 1..place], place + 1)));
                    }
                }
                _ => {}
            }
        }
        let help = format!("write `{close}` where it ends");
        Err(refused(format!("the parenthesis `{open}` is not closed"), help, token.span))
    }

    /// A number, a name, a function, a parenthesis.
    pub(crate) fn atom(&mut self) -> Read<Piece> {
        let start = self.span();
        let Some(token) = self.peek() else { return self.expected("an expression") };
        if let Some((inner, next)) = self.parenthesis()? {
            let open = token.text();
            if top_level(inner, ',') || top_level(inner, ';') {
                let help = "an interval belongs to a domain, `%carom given x in [0, 1]`; write a function as f(x, y) where f is declared";
                return Err(refused("a list in parentheses is not read", help, start));
            }
            let piece = self.sum_in(inner)?;
            self.at = next;
            if open != "(" && piece.level == 5 && piece.name.is_some() {
                let readings = ["a parenthesis", "a notation of the paper's own"];
                let write = ["write (…)", "write another name, or `%carom skip`"];
                return Err(ambiguous("a single name in brackets", readings, write, start));
            }
            return Ok(piece.closed());
        }
        match &token.kind {
            Kind::Char(c) if c.is_ascii_digit() => self.number(),
            Kind::Char('|') => self.absolute(),
            Kind::Open => self.braces(),
            Kind::Char(c) if c.is_alphabetic() => self.symbol(),
            Kind::Char('.') => {
                Err(refused("a number begins with its decimal point", "write a digit before it, as in 0.5", start))
            }
            Kind::Command(_) => self.command(),
            _ => self.expected("an expression"),
        }
    }

    /// `{…}`: its braces do not print, so what they hold must mean the same without them.
    fn braces(&mut self) -> Read<Piece> {
        let start = self.span();
        let (inner, next) = super::macros::group(self.tokens, self.at)?;
        let below = self.tokens.get(next).is_some_and(|t| t.is_char('_'));
        if below || (next == self.at + 3 && inner.first().and_then(Token::char).is_some_and(char::is_alphabetic)) {
            return self.symbol();
        }
        if inner.is_empty() && self.tokens.get(next).is_some_and(|t| matches!(t.char(), Some('^' | '_'))) {
            return self.left_index(next);
        }
        if inner.iter().any(|t| t.is("over") || t.is("atop") || t.is("choose")) {
            return Err(command("over", start));
        }
        let slashed = top_level(inner, '/');
        let piece = self.sum_in(inner)?;
        let before = self.tokens[..self.at].iter().rev().find(|t| !is_space(t));
        let after = self.tokens[next..].iter().find(|t| !is_space(t));
        let bears = after.is_some_and(|t| matches!(t.char(), Some('^' | '!'))) && piece.level < 5;
        let is_divisor = before.is_some_and(|t| t.is_char('/') || t.is("div")) && piece.level < 4;
        let is_numeral = piece.is_number && before.and_then(Token::char).is_some_and(char::is_alphanumeric);
        if piece.level < 3 || slashed || bears || is_divisor || is_numeral {
            let message = "these braces do not print, and what they hold would be read as a group";
            return Err(refused(message, "write parentheses that print, or leave the braces out", start));
        }
        self.at = next;
        Ok(piece.closed())
    }

    /// `{}^{n}C_k`, with its indices from `at` on: the binomial coefficient. Other names have no index at their left.
    fn left_index(&mut self, at: usize) -> Read<Piece> {
        let start = self.span();
        let help =
            "write a binomial coefficient as \\binom{n}{k}; give another name with an index at its left one of its own";
        let other = || refused("an index at the left of a name is not read", help, start);
        let (above, next) = argument(self.tokens, at + 1)?;
        let (symbol, end) = begin(self.tokens.get(next..).unwrap_or_default()).ok_or_else(other)?;
        let is_binomial = self.tokens[at].is_char('^') && symbol.base == "C" && symbol.primes == 0;
        let (true, Some(below), false) = (is_binomial, symbol.below.clone(), self.is_known(&symbol)?) else {
            return Err(other());
        };
        let outer = std::mem::replace(&mut self.scope.counts, true);
        let both = self.sum_in(above).and_then(|above| Ok((above, self.sum_in(&below)?)));
        self.scope.counts = outer;
        let (above, below) = both?;
        self.at = next + end;
        let mut text = above.text.between("binomial(", ", ");
        text.append(&below.text);
        text.push(")", start);
        Ok(Piece::new(text, 5))
    }

    /// A numeral, perhaps in degrees.
    pub(crate) fn number(&mut self) -> Read<Piece> {
        let mut piece = self.numeral()?;
        if let Some(next) = self.degrees() {
            self.at = next;
            let (text, span) = (format!("({}*pi/180)", piece.text.text()), piece.text.span());
            piece = Piece::new(Placed::new(&text, self.since(span)), 5);
        }
        Ok(piece)
    }

    /// A numeral; `1\mathrm{e}5` is one as well.
    pub(crate) fn numeral(&mut self) -> Read<Piece> {
        let start = self.span();
        let mut text = String::new();
        let digits = |reader: &mut Self, text: &mut String| {
            while let Some(c) = reader.tokens.get(reader.at).and_then(Token::char).filter(char::is_ascii_digit) {
                text.push(c);
                reader.at += 1;
            }
        };
        digits(self, &mut text);
        let digit_at =
            |reader: &Self, at: usize| reader.tokens.get(at).and_then(Token::char).is_some_and(|c| c.is_ascii_digit());
        if self.tokens.get(self.at).is_some_and(|t| t.is_char('.')) && digit_at(self, self.at + 1) {
            text.push('.');
            self.at += 1;
            digits(self, &mut text);
        }
        if self.tokens.get(self.at).is_some_and(|t| t.is_char(','))
            && digit_at(self, self.at + 1)
            && !self.tokens[self.at + 1].apart
        {
            let span = self.tokens[self.at].span;
            let readings = ["one number, with a decimal comma or separated thousands", "two numbers of a list"];
            let write = ["write it with a decimal point, 1.5, or without a comma, 1000", "write two equations"];
            return Err(ambiguous("a comma between digits", readings, write, span));
        }
        if self.tokens.get(self.at).is_some_and(|t| t.is("mathrm"))
            && let Ok((inner, mut next)) = argument(self.tokens, self.at + 1)
            && let [letter] = inner
            && letter.is_char('e')
        {
            let is_name = self.scope.decisions.e_is_base
                || self.scope.names.spelled("e").is_some_and(|name| self.scope.roles.contains_key(name));
            let negative = self.tokens.get(next).is_some_and(|t| t.is_char('-'));
            if negative && digit_at(self, next + 1) && (is_name || self.tokens[next].apart) {
                let readings = ["a numeral with its exponent", "a product with e"];
                let write = ["write \\times 10^{-3}", "write \\cdot \\mathrm{e}"];
                return Err(ambiguous("a number before \\mathrm{e}", readings, write, self.since(start)));
            }
            next += usize::from(negative);
            if digit_at(self, next) {
                text.push_str(if negative { "e-" } else { "e" });
                self.at = next;
                digits(self, &mut text);
            }
        }
        if self.tokens.get(self.at).is_some_and(|t| t.is_char('.'))
            && self.tokens.get(self.at + 1).is_some_and(|t| t.is_char('.'))
        {
            let help = "write the exact number, as \\frac{1}{3}, or \\approx 0.333";
            return Err(refused("a number that goes on with dots is not read", help, self.since(start)));
        }
        let mut piece = Piece::atom(&text, self.since(start));
        piece.is_number = true;
        Ok(piece)
    }

    /// Whether a fraction of two numerals begins here.
    pub(crate) fn is_numeric_fraction(&mut self) -> bool {
        if !self.peek().is_some_and(|t| ["frac", "tfrac", "dfrac"].iter().any(|name| t.is(name))) {
            return false;
        }
        let is_number = |tokens: &[Token]| tokens.iter().all(|t| t.char().is_some_and(|c| c.is_ascii_digit()));
        let Ok((above, next)) = argument(self.tokens, self.at + 1) else { return false };
        argument(self.tokens, next).is_ok_and(|(below, _)| is_number(above) && is_number(below))
    }

    /// Where to read on behind the sign of degrees, if it stands here.
    pub(crate) fn degrees(&self) -> Option<usize> {
        let token = self.tokens.get(self.at)?;
        if token.is("degree") || token.is_char('°') {
            return Some(self.at + 1);
        }
        let (inner, next) = argument(self.tokens, self.at + 1).ok().filter(|_| token.is_char('^'))?;
        matches!(inner, [sign] if sign.is("circ") || sign.is("degree")).then_some(next)
    }

    /// `|x|`
    fn absolute(&mut self) -> Read<Piece> {
        let start = self.span();
        let bars: Vec<usize> = bars(self.tokens, self.at);
        let [_, second, rest @ ..] = bars.as_slice() else {
            return Err(refused("this bar is not closed", "write |x| or \\lvert x \\rvert", start));
        };
        if let Some(third) = rest.first() {
            // With an operand between the second bar and the third, the bars may be nested.
            let between = &self.tokens[second + 1..*third];
            let separated = |t: &Token| {
                matches!(t.char(), Some('=' | '<' | '>' | ','))
                    || ["le", "ge", "leq", "geq", "ne", "neq", "text"].iter().any(|n| t.is(n))
            };
            // Within bars stands no expression that begins with an exponent or ends with a sign.
            let sign = |t: &Token, signs: &[char]| {
                t.char().is_some_and(|c| signs.contains(&c)) || t.is("cdot") || t.is("times") || t.is("div")
            };
            let printed: Vec<&Token> = between.iter().filter(|t| !is_space(t)).collect();
            let alone = printed.first().is_none_or(|t| sign(t, &['^', '_', '!', '+', '-', '/', '*']))
                || printed.last().is_none_or(|t| sign(t, &['^', '_', '+', '-', '/', '*']));
            if !alone && !between.iter().any(separated) {
                let readings = ["bars side by side, |a| b |c|", "bars one within the other, | a |b| c |"];
                let write =
                    ["write \\lvert a \\rvert b \\lvert c \\rvert", "write \\lvert a \\lvert b \\rvert c \\rvert"];
                return Err(ambiguous("these bars", readings, write, start));
            }
        }
        let body = &self.tokens[self.at + 1..*second];
        let inner = self.in_bars(|reader| reader.sum_in(body))?;
        self.at = second + 1;
        Ok(inner.within("abs"))
    }
}

/// The places of the bars on the level of the one at `at`, from there on.
pub(crate) fn bars(tokens: &[Token], at: usize) -> Vec<usize> {
    let mut out = Vec::new();
    let mut level = 0usize;
    for (place, token) in tokens.iter().enumerate().skip(at) {
        match &token.kind {
            Kind::Open | Kind::Char('(' | '[') => level += 1,
            Kind::Close | Kind::Char(')' | ']') => match level.checked_sub(1) {
                Some(less) => level = less,
                None => break,
            },
            Kind::Char('|') if level == 0 => out.push(place),
            _ => {}
        }
    }
    out
}
