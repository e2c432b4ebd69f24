//! Names in a formula: which declared name a letter with its index and primes is.

use super::expression::{Read, Reader, is_space, is_upright, top_level};
use super::index::is_shifted;
use super::name::{Symbol, argument, base, canonical, scripts};
use super::outcome::Wanted;
use super::piece::Piece;
use super::place::Placed;
use super::refusal::{ambiguous, no_family, refused, undeclared, unit};
use super::scope::{Missing, Role};
use super::token::{Kind, Token};
use super::vector::is_zero;
use carom_checker::claim::syntax::Unit;
use carom_diagnostic::Span;

/// What a name of the formula is.
enum Meaning {
    /// A number or a matrix, by its spelling, and what it is.
    Number(String, Role),
    /// A function, a family or a sequence.
    Function(String),
    /// A member of a family: what stands below is the index.
    Member(String),
    /// What a comment says that it stands for.
    Said(String),
}

/// Functions that are often written without a backslash.
const WORDS: &[&str] = &[
    "sin", "cos", "tan", "arcsin", "arccos", "arctan", "exp", "ln", "log", "sqrt", "sinh", "cosh", "tanh", "max",
    "min", "det",
];

impl Reader<'_, '_, '_> {
    /// What a name is, if a comment or a sum around it declares it.
    fn meaning(&self, symbol: &Symbol) -> Read<Option<Meaning>> {
        let key = symbol.key();
        let scope = &self.scope;
        let known =
            |key: &str| scope.names.spelled(key).and_then(|name| Some((name.to_string(), *scope.roles.get(name)?)));
        let whole = if let Some((_, name)) = scope.bound.iter().rev().find(|bound| bound.0 == key) {
            Some(Meaning::Number(name.clone(), Role::Variable))
        } else if let Some(said) = scope.names.meaning(&key) {
            Some(Meaning::Said(said.to_string()))
        } else {
            known(&key).map(|(name, role)| match role {
                Role::Applied(_) => Meaning::Function(name),
                role => Meaning::Number(name, role),
            })
        };
        let family = symbol.below.as_ref().and_then(|_| known(&symbol.upper_key()));
        let family = family.filter(|(name, _)| !scope.names.functions.contains(name));
        match (whole, family) {
            (Some(Meaning::Number(name, _)), Some((family, Role::Applied(_)))) => {
                let readings = [format!("the number {name}"), format!("a member of the family {family}")];
                let write = [format!("give the family another name than {family}"), format!("do not declare {name}")];
                let (readings, write) = (readings.each_ref().map(String::as_str), write.each_ref().map(String::as_str));
                Err(ambiguous(&key, readings, write, symbol.span))
            }
            (Some(whole), _) => Ok(Some(whole)),
            (None, Some((family, Role::Applied(1)))) => Ok(Some(Meaning::Member(family))),
            (None, _) => Ok(None),
        }
    }

    /// A name, with its arguments if it is a function.
    pub(crate) fn symbol(&mut self) -> Read<Piece> {
        let start = self.span();
        let (symbol, next) = self.whole_symbol()?;
        let symbol = self.with_sign(symbol)?;
        if let Some(value) = self.named_value(&symbol, next)? {
            return Ok(value);
        }
        if is_zero(&symbol) {
            self.at = next;
            return Ok(self.marked(Piece::atom("0", symbol.span), &symbol));
        }
        self.no_differential(&symbol, next)?;
        let meaning = self.meaning(&symbol)?;
        if !matches!(meaning, Some(Meaning::Member(_)))
            && let Some(index) = self.bound_below(&symbol)?
        {
            let is_said = matches!(&meaning, Some(Meaning::Said(said)) if self.is_said_with(said, &index));
            if !is_said {
                return Err(self.depends_on(&symbol, &index, meaning.is_some()));
            }
        }
        let Some(meaning) = meaning else { return self.unknown(&symbol, next) };
        self.scope.names.seen(&symbol.key());
        let at = self.at;
        self.at = next;
        match meaning {
            Meaning::Number(name, role) => {
                if !self.scope.names.factors.contains(&name) {
                    self.no_application(&symbol)?;
                }
                self.no_unit(&symbol, at)?;
                self.ends_product(&symbol)?;
                let mut piece = Piece::atom(&name, symbol.span);
                piece.name = (role == Role::Variable).then_some(name);
                piece.is_matrix = role == Role::Matrix;
                Ok(self.marked(piece, &symbol))
            }
            Meaning::Said(said) => Ok(Piece::new(Placed::new(&format!("({said})"), symbol.span), 5)),
            Meaning::Function(name) => {
                let value = self.application(&symbol, &name, start)?;
                Ok(self.marked(value, &symbol))
            }
            Meaning::Member(name) => {
                let below = symbol.below.clone().unwrap_or_default();
                let is_letter =
                    |t: &Token| t.char().is_some_and(char::is_alphanumeric) || matches!(t.kind, Kind::Command(_));
                if below.len() > 1 && below.iter().all(is_letter) {
                    let key = symbol.key();
                    let readings = ["one index", "two indices, or a product as the index"];
                    let write = [
                        format!("write `%carom name {key} as {name}(12)` with that index"),
                        format!("write `%carom name {key} as …` with a name of its own"),
                    ];
                    let write = write.each_ref().map(String::as_str);
                    return Err(ambiguous(&key, readings, write, symbol.span));
                }
                let outer = std::mem::replace(&mut self.scope.counts, true);
                let index = self.sum_in(&below);
                self.scope.counts = outer;
                let index = index?;
                self.no_application(&symbol)?;
                let mut text = Placed::new(&name, symbol.span);
                text.append(&index.text.between("(", ")"));
                self.scope.names.members.insert(symbol.key(), text.text().to_string());
                Ok(self.marked(Piece::new(text, 5), &symbol))
            }
        }
    }

    /// The name with the sign that is read for ± below it: it stands for two names, and both statements are meant.
    fn with_sign(&mut self, mut symbol: Symbol) -> Read<Symbol> {
        for token in symbol.below.iter_mut().flatten().filter(|t| t.is("pm") || t.is("mp")) {
            if !*self.scope.decisions.both_signs.get_or_insert(true) {
                let message = "a name with ± below it stands for two, and one of two values is said";
                return Err(refused(message, "write `%carom pm and`, or two formulas", symbol.span));
            }
            self.scope.double_sign = Some(symbol.span);
            token.kind = Kind::Char(if token.is("pm") == self.scope.upper { '+' } else { '-' });
        }
        Ok(symbol)
    }

    /// `v(t)`, where a comment gives this value a name: the function is known at that place alone.
    fn named_value(&mut self, symbol: &Symbol, next: usize) -> Read<Option<Piece>> {
        if !self.tokens.get(next).is_some_and(|t| t.is_char('(')) {
            return Ok(None);
        }
        let here = std::mem::replace(&mut self.at, next);
        let parenthesis = self.parenthesis();
        self.at = here;
        let Some((inner, after)) = parenthesis? else { return Ok(None) };
        let key = format!("{}({})", symbol.key(), canonical(inner));
        let Some(name) = self.scope.names.spelled(&key).map(str::to_string) else { return Ok(None) };
        if !self.scope.roles.contains_key(&name) {
            return Err(undeclared(&name, false, symbol.span));
        }
        if self.is_known(symbol)? {
            let readings = [format!("the value {name}"), format!("what the declared {} says", symbol.key())];
            let write = ["give the declared one another name", "leave out the comment that names the value"];
            return Err(ambiguous(&key, readings.each_ref().map(String::as_str), write, symbol.span));
        }
        self.scope.values_at(inner, &key, symbol.span)?;
        self.scope.names.seen(&key);
        self.at = after;
        Ok(Some(Piece::atom(&name, self.since(symbol.span))))
    }

    /// Whether a name is known here.
    pub(crate) fn is_known(&self, symbol: &Symbol) -> Read<bool> {
        Ok(self.meaning(symbol)?.is_some())
    }

    /// The name that begins here, of one letter or of several, whatever is declared.
    fn whole_symbol(&mut self) -> Read<(Symbol, usize)> {
        let start = self.span();
        let at = self.at;
        let Some(token) = self.tokens.get(at) else { return self.expected("a name") };
        if token.kind == Kind::Open {
            let (inner, next) = super::macros::group(self.tokens, at)?;
            if let Some((first, after)) = base(inner, 0)? {
                let (symbol, after) = scripts(inner, first, inner[0].span, after)?;
                if after == inner.len() {
                    let key = symbol.key();
                    let plain = symbol.below.is_none();
                    let base = if plain { symbol.base } else { format!("{{{key}}}") };
                    let (outer, next) = scripts(self.tokens, base, start, next)?;
                    let primes = outer.primes + if plain { symbol.primes } else { 0 };
                    return Ok((Symbol { primes, ..outer }, next));
                }
            }
            return Err(refused("an index below a group", "put the index behind a single letter", start));
        }
        let length = self.tokens[at..]
            .iter()
            .enumerate()
            .take_while(|(i, t)| t.char().is_some_and(|c| c.is_ascii_alphabetic()) && (*i == 0 || !t.apart))
            .count();
        if length > 1 {
            let run: String = self.tokens[at..at + length].iter().filter_map(Token::char).collect();
            let whole = scripts(self.tokens, run.clone(), start, at + length)?;
            if self.meaning(&whole.0)?.is_some() {
                let mut letters = true;
                for place in at..at + length {
                    let end = if place + 1 == at + length { self.tokens.len() } else { place + 1 };
                    let letter = self.tokens[place].text();
                    let (one, _) = scripts(&self.tokens[..end], letter, self.tokens[place].span, place + 1)?;
                    letters = letters && self.meaning(&one)?.is_some();
                }
                if letters {
                    let readings = ["one name", "a product of letters"];
                    let write =
                        [format!("write \\mathrm{{{run}}}"), "write spaces or \\cdot between the letters".to_string()];
                    let write = write.each_ref().map(String::as_str);
                    return Err(ambiguous(&run, readings, write, whole.0.span));
                }
                return Ok(whole);
            }
            if let Some(word) = WORDS.iter().find(|word| run.starts_with(**word)) {
                let first = token.text();
                if self.meaning(&scripts(&self.tokens[..at + 1], first, start, at + 1)?.0)?.is_none() {
                    let message = format!("{word} without a backslash prints as a product of letters");
                    return Err(refused(message, format!("write \\{word}"), whole.0.span));
                }
            }
        }
        let Some((first, next)) = base(self.tokens, at)? else { return self.expected("a name") };
        if first == "\\Delta"
            && let Some((second, after)) = base(self.tokens, next)?
        {
            let two = scripts(self.tokens, format!("\\Delta {second}"), start, after)?;
            if self.meaning(&two.0)?.is_some() {
                let (one, _) = scripts(&self.tokens[..next], first.clone(), start, next)?;
                if self.meaning(&one)?.is_some() {
                    let readings = ["one name", "a product with \\Delta"];
                    let write = ["do not declare Delta", "write \\Delta \\cdot x"];
                    return Err(ambiguous(&two.0.key(), readings, write, two.0.span));
                }
                return Ok(two);
            }
        }
        scripts(self.tokens, first, start, next)
    }

    /// The function of one number that these tokens are, if they are nothing else.
    pub(crate) fn function_alone(&self, tokens: &[Token]) -> Read<Option<String>> {
        let Some((first, next)) = base(tokens, 0)? else { return Ok(None) };
        let (symbol, next) = scripts(tokens, first, tokens[0].span, next)?;
        if next < tokens.len() {
            return Ok(None);
        }
        Ok(match self.meaning(&symbol)? {
            Some(Meaning::Function(name)) if self.scope.roles.get(&name) == Some(&Role::Applied(1)) => Some(name),
            _ => None,
        })
    }

    /// `f'(x)`, a derivative where f is a function of one number and f' is no name of its own.
    fn primed(&mut self, symbol: &Symbol, next: usize) -> Read<Option<Piece>> {
        let plain = Symbol { primes: 0, ..symbol.clone() };
        let name = match self.meaning(&plain)? {
            Some(Meaning::Function(name)) if symbol.primes > 0 => name,
            _ => return Ok(None),
        };
        let is_applied = self.tokens.get(next).is_some_and(|t| t.is_char('('));
        if !is_applied || self.scope.roles.get(&name) != Some(&Role::Applied(1)) {
            return Ok(None);
        }
        self.at = next;
        let Some((inner, after)) = self.parenthesis()? else { return Ok(None) };
        let Some(variable) = self.sum_in(inner)?.name else {
            let key = symbol.key();
            let help = format!("write the derivative at a variable, {key}(x), and its value as a definition of yours");
            return Err(refused(format!("{key} is read only of a variable"), help, symbol.span));
        };
        self.at = after;
        self.scope.names.seen(&plain.key());
        let by = vec![variable.as_str(); symbol.primes].join(", ");
        Ok(Some(Piece::atom(&format!("derivative({name}({variable}), {by})"), symbol.span)))
    }

    /// What an undeclared name is: π, the base of exponentials, a derivative, or a fault.
    fn unknown(&mut self, symbol: &Symbol, next: usize) -> Read<Piece> {
        let key = symbol.key();
        if let Some(derivative) = self.primed(symbol, next)? {
            return Ok(derivative);
        }
        if key == "\\pi" {
            self.at = next;
            return Ok(Piece::atom("pi", symbol.span));
        }
        if key == "e" {
            let is_upright = self.tokens[self.at].command().is_some();
            if !is_upright && !self.scope.decisions.e_is_base {
                let readings = ["the base of exponentials", "a number of its own, such as a restitution"];
                let write = ["write `%carom e is base`, or \\exp", "declare it: `%carom given e in [0, 1]`"];
                return Err(ambiguous("e", readings, write, symbol.span));
            }
            self.at = next;
            if !self.take_char('^') {
                return Ok(Piece::atom("exp(1)", symbol.span));
            }
            let (inner, after) = super::name::argument(self.tokens, self.at)?;
            let exponent = self.sum_in(inner)?;
            self.at = after;
            return Ok(exponent.within("exp"));
        }
        if self.is_behind_number(self.at) && is_upright(&self.tokens[self.at]) {
            return Err(unit(symbol.span));
        }
        if key == "\\delta" && base(self.tokens, next)?.is_some() {
            let readings = ["a small change of what follows", "a product with the number \\delta"];
            let write =
                ["give the change a name, `%carom name \\delta x as dx`", "declare it, `%carom given \\delta real`"];
            return Err(ambiguous("\\delta before a name", readings, write, symbol.span));
        }
        let wanted = match self.tokens.get(next).is_some_and(|t| t.is_char('(')) {
            true => Wanted::Function,
            false if self.scope.counts => Wanted::Natural,
            false => Wanted::Number,
        };
        let mut missing = Missing { symbol: symbol.clone(), wanted };
        if wanted != Wanted::Function && symbol.below.as_deref().is_some_and(is_shifted) {
            missing = Missing::family(symbol);
        }
        // The change of a quantity is one name.
        if key == "\\Delta"
            && let Some((second, after)) = base(self.tokens, next)?
        {
            missing.symbol = scripts(self.tokens, format!("{key} {second}"), symbol.span, after)?.0;
        }
        let fault = match missing.wanted {
            Wanted::Family => no_family(&symbol.key(), &missing.symbol.key(), symbol.span),
            wanted => undeclared(&missing.symbol.key(), wanted == Wanted::Function, symbol.span),
        };
        self.scope.missing = Some(missing);
        Err(fault)
    }

    /// The arguments of a function.
    fn application(&mut self, symbol: &Symbol, name: &str, start: Span) -> Read<Piece> {
        let key = symbol.key();
        let Some((inner, next)) = self.parenthesis()?.filter(|_| self.peek().is_some_and(|t| t.is_char('('))) else {
            let span = self.since(start);
            if self.is_next_char('^') {
                let readings = ["a power of its value", "the function applied twice, or its inverse"];
                let write = [format!("write {key}(x)^{{2}}"), format!("write {key}({key}(x))")];
                let write = write.each_ref().map(String::as_str);
                return Err(ambiguous(&format!("the exponent of {key}"), readings, write, span));
            }
            let help = format!("write {key}(x); a comment declares {key} with an argument");
            return Err(refused(format!("{key} has no argument here"), help, span));
        };
        let mut text = Placed::new(&format!("{name}("), symbol.span);
        for (place, argument) in commas(inner).into_iter().enumerate() {
            if place > 0 {
                text.push(", ", symbol.span);
            }
            let argument = self.sum_in(argument)?;
            self.number_only(&argument, "a function of a vector", symbol.span)?;
            text.append(&argument.text);
        }
        self.at = next;
        text.push(")", symbol.span);
        Ok(Piece::new(text, 5))
    }

    /// Refuses a d directly before a name: a differential belongs to an integral or a derivative.
    fn no_differential(&self, symbol: &Symbol, next: usize) -> Read<()> {
        let mut at = next;
        while self.tokens.get(at).is_some_and(|t| t.is("!") || t.kind == Kind::Open) {
            at += 1;
        }
        if symbol.key() != "d" || self.scope.decisions.d_is_number || base(self.tokens, at)?.is_none() {
            return Ok(());
        }
        let readings = ["a differential", "a product with the number d"];
        let write =
            ["write the derivative or the integral, or `%carom skip`", "write `%carom d is number`, or d \\cdot x"];
        Err(ambiguous("a d before a name", readings, write, symbol.span))
    }

    /// Whether what stands before a place ends a number, or a group that may.
    fn is_behind_number(&self, at: usize) -> bool {
        let before = self.tokens[..at].iter().rev().find(|t| !is_space(t));
        before.is_some_and(|t| t.kind == Kind::Close || t.char().is_some_and(|c| c.is_ascii_digit() || c == ')'))
    }

    /// Refuses an upright name behind a number that is a unit's as well: `5\,\mathrm{m}`.
    fn no_unit(&self, symbol: &Symbol, at: usize) -> Read<()> {
        let is_set_upright = is_upright(&self.tokens[at])
            || (self.tokens[at].kind == Kind::Open && self.tokens.get(at + 1).is_some_and(is_upright));
        if !is_set_upright || !self.is_behind_number(at) || Unit::read(&symbol.base).is_err() {
            return Ok(());
        }
        let key = symbol.key();
        let readings = [format!("the unit {key}"), format!("a product with the number {key}")];
        let write =
            ["declare the unit with the name, `%carom given x > 0 in m`, and write the number alone", "write \\cdot"];
        Err(ambiguous("an upright name behind a number", readings.each_ref().map(String::as_str), write, symbol.span))
    }

    /// Refuses a parenthesis behind a number that looks like an argument: `v(t)`.
    fn no_application(&mut self, symbol: &Symbol) -> Read<()> {
        let behind =
            self.tokens.get(self.at).filter(|t| t.is_char('^')).and_then(|_| argument(self.tokens, self.at + 1).ok());
        let (is_inverse, at) = behind.map_or((false, self.at), |(inner, next)| {
            (matches!(inner, [sign, one] if sign.is_char('-') && one.is_char('1')), next)
        });
        let mut at = at;
        // A space parts a factor from a parenthesis, but `\!` takes space away.
        while self.tokens.get(at).is_some_and(|t| t.is("!")) {
            at += 1;
        }
        // Braces do not print.
        at += usize::from(self.tokens.get(at).is_some_and(|t| t.kind == Kind::Open));
        if !self.tokens.get(at).is_some_and(|t| matches!(t.char(), Some('(' | '[')) || t.is("{") || t.is("lbrace")) {
            return Ok(());
        }
        let here = std::mem::replace(&mut self.at, at);
        let parenthesis = self.parenthesis();
        self.at = here;
        let Some((inner, _)) = parenthesis? else { return Ok(()) };
        // Nobody puts a single term into parentheses to multiply by it.
        let rest =
            inner.strip_prefix(&inner[..usize::from(inner.first().is_some_and(|t| t.is_char('-')))]).unwrap_or(inner);
        let is_single = !top_level(rest, '+') && !top_level(rest, '-');
        let is_change = symbol.base == "\\Delta" || symbol.base == "\\delta";
        if is_single || is_change || is_inverse || top_level(inner, ',') {
            let key = symbol.key();
            let readings = ["a product", "the value of a function"];
            let write = [
                format!("write `%carom product {key}`, or {key} \\cdot (…)"),
                format!(
                    "declare the function, `%carom let {key}(x) = …`, or name its value, `%carom name {key}(x) as x1`"
                ),
            ];
            let write = write.each_ref().map(String::as_str);
            return Err(ambiguous(&format!("{key} before a parenthesis"), readings, write, symbol.span));
        }
        Ok(())
    }
}

/// The parts of a list.
pub(crate) fn commas(tokens: &[Token]) -> Vec<&[Token]> {
    let mut out = Vec::new();
    let (mut level, mut from) = (0i64, 0);
    for (place, token) in tokens.iter().enumerate() {
        match &token.kind {
            Kind::Open | Kind::Char('(' | '[') => level += 1,
            Kind::Close | Kind::Char(')' | ']') => level -= 1,
            Kind::Char(',') if level == 0 => {
                out.push(&tokens[from..place]);
                from = place + 1;
            }
            _ => {}
        }
    }
    out.push(&tokens[from..]);
    out
}
