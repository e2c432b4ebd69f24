//! Statements of a formula: comparisons, words of logic, quantifiers, limits, extrema.
//!
//! Contract: as for expressions, what may be read in two ways is refused with both readings.

use super::binding::relation_of;
use super::expression::{Read, Reader, is_space};
use super::name::{argument, base, scripts};
use super::piece::Piece;
use super::place::Placed;
use super::refusal::{ambiguous, command, refused, unit, unread_words};
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
const CONDITIONS: &[&str] =
    &["if", "for", "when", "whenever", "where", "with", "provided", "provided that", "as long as"];
/// Words that say for which values of a name a statement is true.
const FOR_ALL: &[&str] = &["for all", "for each", "for every", "for any"];

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
        self.scope.has_logic |= list.len() > 1;
        Ok(joined(list, " <=> ", 1, 2))
    }

    fn implication(&mut self) -> Read<Said> {
        const ARROWS: &[&str] = &["Rightarrow", "implies", "Longrightarrow"];
        let left = self.disjunction()?;
        if self.take_command(ARROWS) {
            self.scope.has_logic = true;
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
            self.scope.has_logic = true;
            let condition = self.disjunction()?;
            return Ok(joined(vec![condition, left], " => ", 2, 3));
        }
        if self.begins_for_all() {
            self.scope.has_logic = true;
            let span = self.span();
            match self.text_here() {
                Some((_, next)) => self.at = next,
                None => self.at += 1,
            }
            let outside = self.scope.bound.len();
            let bindings = self.bindings();
            self.scope.bound.truncate(outside);
            let mut text = Placed::new("for all ", span);
            text.append(&bindings?);
            text.push(": ", span);
            text.append(&left.text);
            return Ok(Said { text, level: 1 });
        }
        Ok(left)
    }

    /// Whether `\forall` or words for it stand here.
    fn begins_for_all(&mut self) -> bool {
        let word = self.text_here();
        word.is_some_and(|(said, _)| FOR_ALL.contains(&said.as_str())) || self.peek().is_some_and(|t| t.is("forall"))
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
            if by_comma && (self.text_here().is_some() || self.begins_for_all()) {
                break;
            }
            if by_comma && self.lists_values() {
                let help = "declare the name, `%carom given n natural`, and say the rest as a condition, n \\ge 1";
                return Err(refused("a list of values with dots is not read", help, span));
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
                    return Err(ambiguous("a comma or a space between two relations", readings, write, span));
                }
            }
        }
        let said = joined(list, " and ", 4, 5);
        if conditions.is_empty() {
            return Ok(said);
        }
        self.scope.has_logic = true;
        let condition = joined(conditions, " and ", 4, 5);
        let text = joined(vec![condition, said], " => ", 2, 3).text.between("(", ")");
        Ok(Said { text, level: 6 })
    }

    /// Whether what follows is a list such as n = 1, 2, \dots
    fn lists_values(&mut self) -> bool {
        self.peek();
        let rest = self.tokens.get(self.at..).unwrap_or_default();
        let parts = super::symbol::commas(rest);
        let is_dots = |part: &&[Token]| {
            let mut signs = part.iter().filter(|t| !is_space(t));
            signs.next().is_some_and(|t| ["dots", "ldots", "cdots", "dotsc"].iter().any(|name| t.is(name)))
                && signs.next().is_none()
        };
        parts.iter().any(is_dots) && parts.first().is_some_and(|first| first.iter().any(|t| t.is_char('=')))
    }

    /// Whether a sign of comparison follows before the next comma, or a statement in parentheses.
    fn holds_relation(&mut self) -> bool {
        if self.parenthesis().ok().flatten().is_some_and(|(inner, _)| is_statement(inner)) {
            return true;
        }
        let mut level = 0i64;
        for token in &self.tokens[self.at..] {
            match &token.kind {
                Kind::Open | Kind::Char('(' | '[') => level += 1,
                Kind::Close | Kind::Char(')' | ']') => level -= 1,
                Kind::Char(',' | ';') if level == 0 => return self.begins_list(),
                _ if level == 0 && (relation_of(token).is_some() || token.is("in") || token.is("approx")) => {
                    return true;
                }
                _ => {}
            }
        }
        false
    }

    /// Whether a list of names with a relation behind it begins here.
    fn begins_list(&mut self) -> bool {
        self.names_before_relation().is_ok_and(|count| count > 1)
    }

    fn negation(&mut self) -> Read<Said> {
        let span = self.span();
        if self.take_command(&["neg", "lnot"]) || self.take_text(&["not"]) {
            self.scope.has_logic = true;
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
        if self.begins_for_all() {
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
            return Err(unread_words(&said, span));
        }
        if let Some((inner, next)) = self.parenthesis()?
            && is_statement(inner)
        {
            let said = self.inside(inner, |inside| inside.statement())?;
            self.at = next;
            return Ok(Said { text: said.text.between("(", ")"), level: 6 });
        }
        if self.peek().is_some_and(|t| t.is("begin")) && self.is_cases() {
            return self.system();
        }
        self.comparison(span)
    }

    /// `\begin{cases} a = b \\ c = d \end{cases}` alone: all of these statements.
    fn system(&mut self) -> Read<Said> {
        let (rows, next) = self.cases_here()?;
        let list: Read<Vec<Said>> =
            rows.iter().map(|row| self.inside(&ended(&row.concat()), |inside| inside.statement())).collect();
        self.at = next;
        Ok(joined(list?, " and ", 4, 5))
    }

    /// The rows of the cases that begin here, each with its cells, and where to read on.
    fn cases_here(&mut self) -> Read<(Vec<Vec<Vec<Token>>>, usize)> {
        let Some((_, inside)) = super::document::environment(self.tokens, self.at) else {
            return self.expected("cases");
        };
        let Some(end) = super::document::end_of(self.tokens, inside) else { return self.expected("\\end{cases}") };
        let next = super::document::environment(self.tokens, end).map_or(end + 1, |found| found.1);
        let rows = super::function::rows(&self.tokens[inside..end]);
        let filled = rows.iter().filter(|row| !row.iter().all(is_space));
        Ok((filled.map(|row| super::document::cells(row)).collect(), next))
    }

    fn quantified(&mut self, word: &str, span: Span) -> Read<Said> {
        self.scope.has_logic = true;
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

    /// `a = b < c`, or `a, b > 0` for each name
    fn comparison(&mut self, span: Span) -> Read<Said> {
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
    fn names_before_relation(&mut self) -> Read<usize> {
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
                left = self.sum()?;
                text.push(&format!(" {relation} "), place);
                text.append(&left.text);
                count += 1;
            } else if token.is("in") {
                self.at += 1;
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

    fn is_cases(&mut self) -> bool {
        super::document::environment(self.tokens, self.at).is_some_and(|(name, _)| name == "cases" || name == "dcases")
    }

    /// `f = \begin{cases} a & x > 0 \\ b & \text{otherwise} \end{cases}`: each case is an implication.
    fn cases(&mut self, left: &Piece) -> Read<Said> {
        let start = self.span();
        self.scope.has_logic = true;
        let (rows, next) = self.cases_here()?;
        let (mut list, mut before): (Vec<Said>, Vec<Said>) = (Vec::new(), Vec::new());
        for cells in rows {
            let [value, condition] = cells.as_slice() else {
                let help = "write each case as `value & condition`";
                return Err(refused("a case without its condition", help, start));
            };
            let value = self.sum_in(&ended(value))?;
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
        self.inside(&ended(tokens), |inside| {
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

/// Tokens without the punctuation and the space at their end.
fn ended(tokens: &[Token]) -> Vec<Token> {
    let ends = |t: &Token| matches!(t.char(), Some(',' | '.' | ';')) || is_space(t) || t.is("quad");
    let length = tokens.iter().rposition(|t| !ends(t)).map_or(0, |last| last + 1);
    tokens[..length].to_vec()
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
