//! Statements of a formula: comparisons, words of logic, quantifiers, limits, extrema.
//!
//! Contract: as for expressions, what may be read in two ways is refused with both readings.

use super::binding::relation_of;
use super::expression::{Read, Reader, is_space};
use super::name::argument;
use super::piece::Piece;
use super::place::Placed;
use super::refusal::{ambiguous, command, refused};
use super::token::{Kind, Token, words};
use carom_diagnostic::Span;

/// A statement with its precedence: equivalence 1, implication 2, or 3, and 4, not 5, atom 6.
pub(crate) struct Said {
    pub text: Placed,
    pub level: u8,
}

impl Said {
    pub(crate) fn at_least(&self, least: u8) -> Placed {
        if self.level >= least { self.text.clone() } else { self.text.between("(", ")") }
    }
}

/// Words behind which a condition stands.
const CONDITIONS: &[&str] = &["if", "for", "when", "whenever", "provided", "provided that", "as long as"];

impl Reader<'_, '_, '_> {
    /// The words of `\text{…}` here, and where to read on.
    pub(crate) fn text_here(&mut self) -> Option<(String, usize)> {
        let is_text = |t: &Token| ["text", "mbox", "textrm", "textnormal", "textit"].iter().any(|name| t.is(name));
        self.peek().filter(|t| is_text(t))?;
        let (inner, next) = argument(self.tokens, self.at + 1).ok()?;
        let said = words(inner).to_lowercase();
        Some((said.trim_matches([' ', ',', '.', ';']).split_whitespace().collect::<Vec<_>>().join(" "), next))
    }

    /// Takes one of these words.
    pub(crate) fn take_text(&mut self, wanted: &[&str]) -> bool {
        match self.text_here() {
            Some((said, next)) if wanted.contains(&said.as_str()) => {
                self.at = next;
                true
            }
            _ => false,
        }
    }

    pub(crate) fn take_command(&mut self, wanted: &[&str]) -> bool {
        let found = self.peek().and_then(Token::command).is_some_and(|name| wanted.contains(&name));
        self.at += usize::from(found);
        found
    }

    /// A statement.
    pub(crate) fn statement(&mut self) -> Read<Said> {
        let mut list = vec![self.implication()?];
        while self.take_command(&["Leftrightarrow", "iff", "Longleftrightarrow"])
            || self.take_text(&["if and only if", "iff", "exactly if", "precisely if"])
        {
            list.push(self.implication()?);
        }
        Ok(joined(list, " <=> ", 1, 2))
    }

    fn implication(&mut self) -> Read<Said> {
        const ARROWS: &[&str] = &["Rightarrow", "implies", "Longrightarrow"];
        let left = self.disjunction()?;
        if self.take_command(ARROWS) {
            let right = self.disjunction()?;
            let span = self.span();
            if self.take_command(ARROWS) {
                let readings = ["a chain, A ⇒ B and B ⇒ C", "one implication, A ⇒ (B ⇒ C)"];
                let write = ["write two equations", "write the parentheses"];
                return Err(ambiguous("two arrows in a row", readings, write, span));
            }
            return Ok(joined(vec![left, right], " => ", 2, 3));
        }
        if self.take_text(CONDITIONS) {
            let condition = self.disjunction()?;
            return Ok(joined(vec![condition, left], " => ", 2, 3));
        }
        Ok(left)
    }

    fn disjunction(&mut self) -> Read<Said> {
        let mut list = vec![self.conjunction()?];
        while self.take_command(&["lor", "vee"]) || self.take_text(&["or"]) {
            list.push(self.conjunction()?);
        }
        Ok(joined(list, " or ", 3, 4))
    }

    fn conjunction(&mut self) -> Read<Said> {
        let mut list = vec![self.negation()?];
        let mut conditions: Vec<Said> = Vec::new();
        loop {
            let span = self.span();
            let by_word = self.take_command(&["land", "wedge"]) || self.take_text(&["and"]);
            let by_comma = !by_word
                && (self.is_next_char(',') || self.is_next_char(';') || self.peek().is_some_and(|t| t.is("quad")));
            if !by_word && !by_comma {
                break;
            }
            while by_comma && (self.take_char(',') || self.take_char(';') || self.take_command(&["quad"])) {}
            // A comma before a word: the word says what it means.
            if self.take_text(&["and"]) {
                list.push(self.negation()?);
                continue;
            }
            if by_comma && self.text_here().is_some() {
                break;
            }
            if by_comma && !self.holds_relation() {
                let help =
                    "write each statement as an equation of its own; a range of an index is a sum's or a declaration's";
                return Err(refused("what follows this comma is no statement", help, span));
            }
            let next = self.negation()?;
            match (by_comma, self.scope.decisions.comma_is_and) {
                (false, _) | (true, Some(true)) => list.push(next),
                (true, Some(false)) => conditions.push(next),
                (true, None) => {
                    let readings = ["two statements, A and B", "a statement and its condition, A if B"];
                    let write = ["write `%carom comma and`, or \\text{and}", "write `%carom comma if`, or \\text{if}"];
                    return Err(ambiguous("a comma between two relations", readings, write, span));
                }
            }
        }
        let said = joined(list, " and ", 4, 5);
        if conditions.is_empty() {
            return Ok(said);
        }
        let condition = joined(conditions, " and ", 4, 5);
        let text = joined(vec![condition, said], " => ", 2, 3).text.between("(", ")");
        Ok(Said { text, level: 6 })
    }

    /// Whether a sign of comparison follows before the next comma.
    fn holds_relation(&mut self) -> bool {
        let mut level = 0i64;
        for token in &self.tokens[self.at..] {
            match &token.kind {
                Kind::Open | Kind::Char('(' | '[') => level += 1,
                Kind::Close | Kind::Char(')' | ']') => level -= 1,
                Kind::Char(',' | ';') if level == 0 => return false,
                _ if level == 0 && (relation_of(token).is_some() || token.is("in") || token.is("approx")) => {
                    return true;
                }
                _ => {}
            }
        }
        false
    }

    fn negation(&mut self) -> Read<Said> {
        let span = self.span();
        if self.take_command(&["neg", "lnot"]) || self.take_text(&["not"]) {
            let inner = self.negation()?;
            let mut text = Placed::new("not ", span);
            text.append(&inner.at_least(5));
            return Ok(Said { text, level: 5 });
        }
        self.atomic()
    }

    fn atomic(&mut self) -> Read<Said> {
        let span = self.span();
        let word = self.text_here();
        let is = |words: &[&str]| word.as_ref().is_some_and(|(said, _)| words.contains(&said.as_str()));
        if is(&["for all", "for each", "for every"]) || self.peek().is_some_and(|t| t.is("forall")) {
            return self.quantified("for all ", span);
        }
        if is(&["exists", "there is", "there exists"]) || self.peek().is_some_and(|t| t.is("exists")) {
            return self.quantified("exists ", span);
        }
        if is(&["maximum of", "minimum of", "the maximum of", "the minimum of"]) {
            return self.extremum(span);
        }
        if is(&["limit of", "the limit of"]) {
            return self.written_limit(span);
        }
        if self.peek().is_some_and(|t| t.is("lim")) {
            return self.limit(span);
        }
        if let Some((said, _)) = word {
            let help = "words that are read: and, or, not, if, if and only if, for all, exists, maximum of, limit of";
            return Err(refused(format!("the words “{said}” are not read here"), help, span));
        }
        if let Some((inner, next)) = self.parenthesis()?
            && is_statement(inner)
        {
            let said = self.inside(inner, |inside| inside.statement())?;
            self.at = next;
            return Ok(Said { text: said.text.between("(", ")"), level: 6 });
        }
        self.comparison(span)
    }

    fn quantified(&mut self, word: &str, span: Span) -> Read<Said> {
        match self.text_here() {
            Some((_, next)) => self.at = next,
            None => self.at += 1,
        }
        let outside = self.scope.bound.len();
        let bindings = self.bindings()?;
        if !(self.take_char(':') || self.take_char(',') || self.take_command(&["colon", "quad", ":"])) {
            return self.expected("`:` before what is said to hold");
        }
        let body = self.statement();
        self.scope.bound.truncate(outside);
        let mut text = Placed::new(word, span);
        text.append(&bindings);
        text.push(": ", span);
        text.append(&body?.text);
        Ok(Said { text, level: 1 })
    }

    /// `maximum of F over x > 0 only at x = A is M`
    fn extremum(&mut self, span: Span) -> Read<Said> {
        let Some((said, next)) = self.text_here() else { return self.expected("an extremum") };
        // The function comes before the words that bind its variables.
        let over = self.find_text(next, "over");
        let Some(over) = over else { return self.expected("\\text{over} and the variables") };
        let outside = self.scope.bound.len();
        let body = &self.tokens[next..over];
        self.at = over;
        self.take_text(&["over"]);
        let bindings = self.bindings()?;
        let of = self.sum_in(body)?;
        let mut text = Placed::new(if said.contains("maximum") { "maximum of " } else { "minimum of " }, span);
        text.append(&of.text);
        text.push(" over ", span);
        text.append(&bindings);
        let only = self.take_text(&["only at"]);
        if only || self.take_text(&["at"]) {
            text.push(if only { " only at " } else { " at " }, span);
            loop {
                let name = self.symbol()?;
                if !self.take_char('=') {
                    return self.expected("`=` and the place of the extremum");
                }
                text.append(&name.text);
                text.push(" = ", span);
                text.append(&self.sum()?.text);
                if !self.take_char(',') {
                    break;
                }
                text.push(", ", span);
            }
        }
        if !self.take_text(&["is"]) {
            return self.expected("\\text{is} and the value");
        }
        self.scope.bound.truncate(outside);
        text.push(" is ", span);
        text.append(&self.sum()?.text);
        Ok(Said { text, level: 6 })
    }

    /// Where `\text{word}` stands from `at` on, outside of braces.
    pub(crate) fn find_text(&self, at: usize, word: &str) -> Option<usize> {
        let mut level = 0i64;
        for (place, token) in self.tokens.iter().enumerate().skip(at) {
            level += i64::from(token.kind == Kind::Open) - i64::from(token.kind == Kind::Close);
            if level == 0 && (token.is("text") || token.is("textrm") || token.is("mbox")) {
                let (inner, _) = argument(self.tokens, place + 1).ok()?;
                if words(inner) == word {
                    return Some(place);
                }
            }
        }
        None
    }

    /// `a = b < c`
    fn comparison(&mut self, span: Span) -> Read<Said> {
        let mut text = Placed::default();
        let mut left = self.sum()?;
        text.append(&left.text);
        let mut also: Vec<Said> = Vec::new();
        let mut count = 0;
        while let Some(token) = self.peek() {
            let place = token.span;
            let is_approximate = token.is("approx");
            if (is_approximate || relation_of(token) == Some("="))
                && self.begins_printed(self.at + 1, is_approximate)?
            {
                self.at += 1;
                also.push(self.printed(&left)?);
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
                left = self.sum()?;
                text.push(&format!(" {relation} "), place);
                text.append(&left.text);
                count += 1;
            } else if token.is("in") {
                self.at += 1;
                also.push(self.member(&left)?);
            } else if token.is("equiv") {
                let readings = ["an identity", "a definition"];
                let write = ["write =", "write := or `%carom let`"];
                return Err(ambiguous("≡", readings, write, place));
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

    fn is_cases(&mut self) -> bool {
        super::document::environment(self.tokens, self.at).is_some_and(|(name, _)| name == "cases" || name == "dcases")
    }

    /// `f = \begin{cases} a & x > 0 \\ b & \text{otherwise} \end{cases}`: each case is an implication.
    fn cases(&mut self, left: &Piece) -> Read<Said> {
        let start = self.span();
        let Some((_, inside)) = super::document::environment(self.tokens, self.at) else {
            return self.expected("cases");
        };
        let Some(end) = super::document::end_of(self.tokens, inside) else { return self.expected("\\end{cases}") };
        let next = super::document::environment(self.tokens, end).map_or(end + 1, |found| found.1);
        let (mut list, mut before): (Vec<Said>, Vec<Said>) = (Vec::new(), Vec::new());
        for row in super::function::rows(&self.tokens[inside..end]) {
            let cells = super::document::cells(&row);
            if row.iter().all(is_space) {
                continue;
            }
            let [value, condition] = cells.as_slice() else {
                let help = "write each case as `value & condition`";
                return Err(refused("a case without its condition", help, start));
            };
            let trimmed: Vec<Token> = {
                let mut value = value.clone();
                while value.last().is_some_and(|t| t.is_char(',') || is_space(t)) {
                    value.pop();
                }
                value
            };
            let value = self.sum_in(&trimmed)?;
            let condition = self.condition(condition, &before, start)?;
            let mut equation = left.text.clone();
            equation.push(" = ", start);
            equation.append(&value.text);
            let case = Said { text: condition.text.clone(), level: condition.level };
            list.push(joined(vec![case, Said { text: equation, level: 6 }], " => ", 2, 3));
            before.push(condition);
        }
        self.at = next;
        Ok(joined(list, " and ", 4, 5))
    }

    fn condition(&mut self, tokens: &[Token], before: &[Said], start: Span) -> Read<Said> {
        let mut tokens = tokens.to_vec();
        while tokens.last().is_some_and(|t| matches!(t.char(), Some(',' | '.' | ';'))) {
            tokens.pop();
        }
        self.inside(&tokens, |inside| {
            if inside.take_text(&["otherwise", "else"]) {
                let list: Vec<Said> =
                    before.iter().map(|said| Said { text: said.text.clone(), level: said.level }).collect();
                let mut text = Placed::new("not ", start);
                text.append(&joined(list, " or ", 3, 4).at_least(6));
                return Ok(Said { text, level: 5 });
            }
            inside.take_text(CONDITIONS);
            inside.statement()
        })
    }
}

/// Whether tokens in parentheses hold a statement: on their own level, or in a parenthesis with which they begin.
fn is_statement(tokens: &[Token]) -> bool {
    let mut level = 0i64;
    for token in tokens {
        match &token.kind {
            Kind::Open | Kind::Char('(' | '[') => level += 1,
            Kind::Close | Kind::Char(')' | ']') => level -= 1,
            _ if level == 0 && (relation_of(token).is_some() || token.is("text") || token.is("in")) => return true,
            _ => {}
        }
    }
    let leads = |t: &Token| t.is("Rightarrow") || t.is("Leftrightarrow") || t.is("iff") || t.is("land") || t.is("lor");
    tokens.first().is_some_and(|t| t.is_char('(')) && tokens.iter().any(leads)
}

/// Statements with a word between them.
pub(crate) fn joined(mut list: Vec<Said>, word: &str, level: u8, least: u8) -> Said {
    if list.len() == 1
        && let Some(only) = list.pop()
    {
        return only;
    }
    let mut text = Placed::default();
    for (place, said) in list.iter().enumerate() {
        if place > 0 {
            text.push(word, said.text.span());
        }
        text.append(&said.at_least(least));
    }
    Said { text, level }
}
