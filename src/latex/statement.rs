//! Statements of a formula: comparisons, words of logic, quantifiers, limits, extrema.
//!
//! Contract: as for expressions, what may be read in two ways is refused with both readings.

use super::binding::relation_of;
use super::expression::{Read, Reader, is_space};
use super::name::argument;
use super::place::Placed;
use super::refusal::{ambiguous, one_value, refused, unread_words};
use super::row::side_by_side;
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

/// What words for all say behind a statement.
struct ForAll {
    bindings: Placed,
    /// Where the words stand, and where they end with what they bind.
    from: usize,
    to: usize,
    /// The number of names.
    names: usize,
}

/// Words behind which a condition stands.
pub(crate) const CONDITIONS: &[&str] =
    &["if", "for", "when", "whenever", "where", "with", "provided", "provided that", "as long as"];
/// Words between two statements of which each implies the other.
const EQUIVALENT: &[&str] = &["if and only if", "iff", "exactly if", "precisely if"];
/// Words that say for which values of a name a statement is true.
const FOR_ALL: &[&str] = &["for all", "for each", "for every", "for any"];
/// Words before a name of which one value is meant.
const EXISTENCE: &[&str] = &["exists", "there is", "there exists"];

impl Reader<'_, '_, '_> {
    /// The words of `\text{…}` here, and where to read on.
    pub(crate) fn text_here(&mut self) -> Option<(String, usize)> {
        self.peek().filter(|t| t.is_text() || t.is("textit"))?;
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
        let mut list = Vec::new();
        loop {
            let begins = self.begins_quantifier();
            let span = self.span();
            let said = self.implication()?;
            // What stands behind it, a condition or words for all, may be meant for it or for the whole.
            list.push((said.level == 2 || (said.level == 1 && !begins), span, said));
            if !self.take_command(&["Leftrightarrow", "iff", "Longleftrightarrow"]) && !self.take_text(EQUIVALENT) {
                break;
            }
        }
        if list.len() > 1 {
            self.scope.has_logic = true;
            if let Some((_, span, _)) = list.iter().find(|(is_open, ..)| *is_open) {
                let readings = ["a side of the equivalence alone", "a chain, or a condition of the whole"];
                let write =
                    ["write parentheses around the side", "write two equations, or parentheses around the whole"];
                return Err(ambiguous("an implication or a condition beside an equivalence", readings, write, *span));
            }
        }
        Ok(joined(list.into_iter().map(|(.., said)| said).collect(), " <=> ", 1, 2))
    }

    fn begins_quantifier(&mut self) -> bool {
        let word = self.text_here();
        let is_existence = |said: &str| EXISTENCE.contains(&said);
        self.begins_for_all()
            || word.is_some_and(|(said, _)| is_existence(&said))
            || self.peek().is_some_and(|t| t.is("exists"))
    }

    fn implication(&mut self) -> Read<Said> {
        const ARROWS: &[&str] = &["Rightarrow", "implies", "Longrightarrow"];
        let for_all = self.bound_behind()?;
        let outside = self.scope.bound.len() - for_all.as_ref().map_or(0, |found| found.names);
        let left = self.disjunction();
        self.scope.bound.truncate(outside);
        let left = left?;
        if let Some(ForAll { bindings, from, to, .. }) = for_all {
            let span = self.span();
            if self.at != from {
                return self.expected("the end of the statement before the words for all");
            }
            if let Some(value) = self.scope.value {
                return Err(one_value("a function with a named value", value));
            }
            self.at = to;
            return Ok(under("for all ", &bindings, &left, span));
        }
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
        Ok(left)
    }

    /// The names that words behind the statement here bind, `a_n > 0 \text{ for all } n`: they are bound in the statement as well.
    fn bound_behind(&mut self) -> Read<Option<ForAll>> {
        let here = self.at;
        if self.begins_for_all() {
            return Ok(None);
        }
        let Some(from) = self.place_of_for_all() else { return Ok(None) };
        if let Some(exists) = self.tokens[here..from].iter().find(|t| t.is("exists")) {
            let readings = ["a value for each", "one value for all"];
            let write = ["begin with \\forall", "write parentheses around the statement behind \\exists"];
            return Err(ambiguous("\\exists before words for all", readings, write, exists.span));
        }
        let outside = self.scope.bound.len();
        self.at = from;
        let bindings = self.quantified_names();
        let to = std::mem::replace(&mut self.at, here);
        match bindings {
            Ok(bindings) => Ok(Some(ForAll { bindings, from, to, names: self.scope.bound.len() - outside })),
            Err(fault) => {
                self.scope.bound.truncate(outside);
                Err(fault)
            }
        }
    }

    /// Where the words for all stand behind the statement here, on its level.
    fn place_of_for_all(&mut self) -> Option<usize> {
        const ENDS: [&str; 6] =
            ["Rightarrow", "implies", "Longrightarrow", "Leftrightarrow", "iff", "Longleftrightarrow"];
        let here = self.at;
        let mut level = 0i64;
        let found = (here..self.tokens.len()).find(|place| {
            let token = &self.tokens[*place];
            level += token.nesting();
            self.at = *place;
            let ends = || token.command().is_some_and(|name| ENDS.contains(&name));
            let is_text = token.is_text();
            level == 0 && !is_space(token) && (ends() || (is_text && self.ends_statement()) || self.begins_for_all())
        });
        let found = found.filter(|place| {
            self.at = *place;
            self.begins_for_all()
        });
        self.at = here;
        let joins =
            |t: &Token| ["land", "wedge", "neg", "lnot", "colon"].iter().any(|name| t.is(name)) || t.is_char(':');
        let before = found.map(|place| &self.tokens[here..place]).unwrap_or_default();
        let last = before.iter().rposition(|t| !is_space(t) && !t.is("quad"))?;
        (!joins(&before[last]) && !super::prepare::after_text(&before[..=last])).then_some(found?)
    }

    /// Whether words here part a statement from its condition, or from one that is equivalent.
    fn ends_statement(&mut self) -> bool {
        self.text_here().is_some_and(|(said, _)| CONDITIONS.contains(&&*said) || EQUIVALENT.contains(&&*said))
    }

    /// Whether `\forall` or words for it stand here.
    fn begins_for_all(&mut self) -> bool {
        let word = self.text_here();
        word.is_some_and(|(said, _)| FOR_ALL.contains(&said.as_str())) || self.peek().is_some_and(|t| t.is("forall"))
    }

    fn disjunction(&mut self) -> Read<Said> {
        let from = self.at;
        let mut list = vec![self.conjunction()?];
        while self.take_command(&["lor", "vee"]) || self.take_text(&["or"]) {
            let read = &self.tokens[from..self.at];
            if read.iter().any(|t| t.is("quad")) || super::expression::top_level(read, ',') {
                let help = "put parentheses around what belongs together, or write two formulas";
                return Err(refused("a comma or a wide space before `or`", help, self.since(self.tokens[from].span)));
            }
            self.scope.has_choice = true;
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
            let sign = if self.peek().is_some_and(|t| t.is("quad")) { "wide space" } else { "comma" };
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
                return Err(refused(format!("what follows this {sign} is no statement"), help, span));
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
            (self.scope.has_logic, self.scope.has_choice) = (true, true);
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
        if self.begins_quantifier() {
            self.scope.has_choice = true;
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
        let begins = |row: &Vec<Vec<Token>>| {
            let first = row.iter().flat_map(|cell| super::prepare::printed(cell)).next();
            first.filter(|t| matches!(t.char(), Some('+' | '-')) || t.is("pm") || t.is("mp")).map(|t| t.span)
        };
        if let Some(span) = rows.iter().skip(1).find_map(begins) {
            let help = "end the row before with the sign, or write the equation the other way round";
            return Err(refused("a row of a system that begins with a sign", help, span));
        }
        let list: Read<Vec<Said>> =
            rows.iter().map(|row| self.inside(&ended(&side_by_side(row)), |inside| inside.statement())).collect();
        self.at = next;
        Ok(joined(list?, " and ", 4, 5))
    }

    /// The rows of the cases that begin here, each with its cells, and where to read on.
    pub(crate) fn cases_here(&mut self) -> Read<(Vec<Vec<Vec<Token>>>, usize)> {
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
        let outside = self.scope.bound.len();
        let bindings = self.quantified_names()?;
        if !(self.take_char(':') || self.take_char(',') || self.take_command(&["colon", "quad", ":"])) {
            return self.expected("`:` before what is said to hold");
        }
        let body = self.statement();
        self.scope.bound.truncate(outside);
        Ok(under(word, &bindings, &body?, span))
    }

    /// The names behind the words or the sign of a quantifier, which stand here.
    fn quantified_names(&mut self) -> Read<Placed> {
        self.scope.has_logic = true;
        self.at = self.text_here().map_or(self.at + 1, |(_, next)| next);
        self.bindings()
    }

    /// `maximum of F over x > 0 only at x = A is M`
    fn extremum(&mut self, span: Span) -> Read<Said> {
        let Some((said, next)) = self.text_here() else { return self.expected("an extremum") };
        // The function comes before the words that bind its variables.
        let over = self.find_text(next, "over");
        let Some(over) = over else { return self.expected("\\text{over} and the variables") };
        let outside = self.scope.bound.len();
        let body = &self.tokens[next..over];
        self.scope.has_choice = true;
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
}

/// Tokens without the punctuation and the space at their end.
pub(crate) fn ended(tokens: &[Token]) -> Vec<Token> {
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

/// A statement under a quantifier.
fn under(word: &str, bindings: &Placed, body: &Said, span: Span) -> Said {
    let mut text = Placed::new(word, span);
    text.append(bindings);
    text.push(": ", span);
    text.append(&body.text);
    Said { text, level: 1 }
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
