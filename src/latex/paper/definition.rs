//! Definitions of a paper: `x := A`, `f(x) := A`, and `f(x) = A` where nothing else says what f is.

use super::{Assembly, Head, lines_of};
use crate::binding::relation_of;
use crate::clause::{Purpose, Said};
use crate::expression::{Read, Reader};
use crate::function::{FUNCTIONS, WORDS};
use crate::name::{Symbol, base, begin, mentions, scripts};
use crate::place::Placed;
use crate::refusal::{one_value, refused};
use crate::symbol::commas;
use crate::token::Token;
use crate::vector::no_vector;
use crate::whole::whole;
use carom_diagnostic::{Diagnostic, Span};
use std::collections::BTreeSet;

impl Assembly<'_> {
    /// Where the sign of a definition stands in a formula, and what is behind it: `:=`, in a formula that a comment calls a
    /// definition `=`, and the first sign in `f(x) = A` if nothing says what f is and x alone is what it depends on.
    pub(super) fn sign_of_definition(
        &mut self,
        tokens: &[Token],
        said: &Said,
        local: &[Placed],
    ) -> Result<Option<(usize, usize)>, Vec<Diagnostic>> {
        let written = (0..tokens.len()).find_map(|at| match &tokens[at] {
            token if token.is("coloneqq") => Some((at, at + 1)),
            token if token.is_char(':') => tokens.get(at + 1)?.is_char('=').then_some((at, at + 2)),
            _ => None,
        });
        if written.is_some() {
            return Ok(written);
        }
        if said.purpose == Purpose::Let {
            return Ok(on_its_level(tokens, |t| t.is_char('=') || t.is("equiv")).map(|at| (at, at + 1)));
        }
        let Some((symbol, parameters, sign)) = application(tokens).filter(|_| !said.is_claim) else { return Ok(None) };
        let value = &tokens[sign + 1..];
        let value = &value[..relation_at(value)];
        if !parameters.iter().all(|parameter| mentions(value, &parameter.key())) {
            return Ok(None);
        }
        let is_known = self.with_scope(said, local, |scope| {
            let whole = symbol.span;
            Reader { tokens, at: 0, depth: 0, whole, scope }.is_known(&symbol)
        })?;
        let key = symbol.key();
        if is_known || self.undefined.contains_key(&key) || self.names.has_values(Some(&key)) {
            return Ok(None);
        }
        if self.out.undeclared.contains_key(&format!("{key}(…)")) {
            let help = format!("write the formula of {key} before it is used, or := where it is a definition");
            return Err(vec![refused(
                format!("{key} is used before this, which may follow from that"),
                help,
                symbol.span,
            )]);
        }
        Ok(Some((sign, sign + 1)))
    }

    /// Reads `x := A` and takes it for all equations that follow; whether a relation follows behind A.
    pub(super) fn definition(
        &mut self,
        tokens: &[Token],
        sign: usize,
        behind: usize,
        said: &Said,
        head: &Head,
        local: &mut Vec<Placed>,
    ) -> Result<bool, Vec<Diagnostic>> {
        let (symbol, next) = self.defined_symbol(tokens, sign)?;
        let outcome = self.defined(tokens, sign, behind, (&symbol, next), said, local);
        if outcome.is_err() {
            let spelled = self.names.spelled(&symbol.key()).map(str::to_string);
            let is_known = self.with_scope(said, local, |scope| {
                Ok(spelled.as_ref().is_some_and(|name| scope.roles.contains_key(name)))
            });
            match is_known {
                Ok(false) => self.undefined.insert(symbol.key(), head.span),
                _ => Some(*self.broken.get_or_insert(head.span)),
            };
        }
        outcome
    }

    /// The name before the sign of a definition, and where it ends.
    fn defined_symbol(&mut self, tokens: &[Token], sign: usize) -> Result<(Symbol, usize), Vec<Diagnostic>> {
        let one = |fault: Diagnostic| vec![fault];
        let span = tokens.first().map_or(Span::default(), |t| t.span);
        // Only a name can be defined, so letters side by side are one.
        let run = tokens
            .iter()
            .enumerate()
            .take_while(|(i, t)| t.char().is_some_and(|c| c.is_ascii_alphabetic()) && (*i == 0 || !t.apart));
        let run: String = run.filter_map(|(_, t)| t.char()).collect();
        let mut found = if run.len() > 1 { Some((run.clone(), run.len())) } else { base(tokens, 0).map_err(one)? };
        // The change of a quantity is one name.
        if let Some(("\\Delta", at)) = found.as_ref().map(|(first, at)| (first.as_str(), *at))
            && let Some((second, next)) = base(tokens, at).map_err(one)?
        {
            found = Some((format!("\\Delta {second}"), next));
        }
        let Some((first, next)) = found.filter(|found| found.1 <= sign) else {
            return Err(one(no_name(span)));
        };
        scripts(tokens, first, span, next).map_err(one)
    }

    fn defined(
        &mut self,
        tokens: &[Token],
        sign: usize,
        behind: usize,
        (symbol, next): (&Symbol, usize),
        said: &Said,
        local: &mut Vec<Placed>,
    ) -> Result<bool, Vec<Diagnostic>> {
        let one = |fault: Diagnostic| vec![fault];
        let span = tokens.first().map_or(Span::default(), |t| t.span);
        let wrong = || one(no_name(span));
        let name = self.names.of(symbol).map_err(one)?;
        self.names.seen(&symbol.key());
        let mut parameters: Vec<Symbol> = Vec::new();
        if next < sign {
            parameters = self::parameters(&tokens[next..sign]).ok_or_else(wrong)?;
            if self.names.has_values(Some(&symbol.key())) {
                return Err(one(one_value(&symbol.key(), span)));
            }
        }
        let value = &tokens[behind..];
        let end = relation_at(value);
        let is_behind = |t: &Token| t.is_text() || t.is("quad") || matches!(t.char(), Some(',' | ';'));
        if let Some(at) = on_its_level(value, |token| is_behind(token) || relation_of(token).is_some())
            .filter(|at| is_behind(&value[*at]))
        {
            let help = "declare it before, `%carom given x > 0`; another equation is a formula of its own";
            return Err(one(refused("a condition behind a definition is not read", help, value[at].span)));
        }
        if end == value.len() {
            said.of_no_claim().map_err(one)?;
        }
        let (list, value) = self.with_scope(said, local, |scope| {
            let is_marked = crate::vector::is_marked(symbol) && !scope.names.is_renamed(&symbol.key());
            let list: Read<Vec<String>> = parameters.iter().map(|parameter| scope.bind(parameter)).collect();
            let read = whole(&value[..end], scope, |reader| reader.sum())?;
            if read.is_vector && !read.is_matrix && !is_marked {
                return Err(no_vector("a vector that is called by an unmarked name", span));
            }
            match scope.double_sign {
                Some(span) => {
                    let help = "define each of the two values by a name of its own";
                    Err(refused("one of two values in a definition", help, span))
                }
                None => Ok((list?, read)),
            }
        })?;
        let mut text = lines_of(local);
        let list = if list.is_empty() { String::new() } else { format!("({})", list.join(", ")) };
        text.push(&format!("let {name}{list} = "), span);
        text.append(&value.text);
        self.declare(&text)?;
        self.supposed = self.supposed.with(self.vectors);
        if !parameters.is_empty() {
            self.names.functions.insert(name);
        }
        local.clear();
        Ok(end < tokens.len() - behind)
    }
}

/// What stands before the sign of a definition is no name.
fn no_name(span: Span) -> Diagnostic {
    let help =
        "define a name, as in \\eta := …, or a function, as in f(x) := …; or write `%carom let` with its definition";
    refused("what stands before this sign is no name", help, span)
}

/// The name and the parameters in `f(x, y) =`, which begins these tokens, and where its sign stands. Names of known functions
/// and of derivatives, such as `\dot{x}` and f', are no names for a new function.
fn application(tokens: &[Token]) -> Option<(Symbol, Vec<Symbol>, usize)> {
    const OTHERS: [&str; 7] = ["\\Delta", "\\delta", "\\pi", "\\mathcal{O}", "O", "e", "d"];
    let (symbol, open) = begin(tokens)?;
    let base = symbol.base.as_str();
    let is_known = OTHERS.contains(&base) || FUNCTIONS.contains(&base) || WORDS.contains(&base);
    if is_known || base.starts_with("\\dot{") || base.starts_with("\\ddot{") || symbol.primes > 0 {
        return None;
    }
    let close = open + tokens.get(open..)?.iter().position(|t| t.is_char(')'))?;
    tokens.get(close + 1).filter(|t| t.is_char('='))?;
    Some((symbol, parameters(&tokens[open..=close])?, close + 1))
}

/// The parameters in `(x, y)`.
fn parameters(tokens: &[Token]) -> Option<Vec<Symbol>> {
    let [open, list @ .., close] = tokens else { return None };
    (open.is_char('(') && close.is_char(')')).then_some(())?;
    let alone = |part: &[Token]| begin(part).filter(|found| found.1 == part.len()).map(|found| found.0);
    let parameters: Vec<Symbol> = commas(list).into_iter().map(alone).collect::<Option<_>>()?;
    let keys: BTreeSet<String> = parameters.iter().map(Symbol::key).collect();
    (keys.len() == parameters.len()).then_some(parameters)
}

/// Where the first sign of comparison stands outside of parentheses.
fn relation_at(tokens: &[Token]) -> usize {
    on_its_level(tokens, |token| relation_of(token).is_some()).unwrap_or(tokens.len())
}

/// Where the first such token stands outside of parentheses.
fn on_its_level(tokens: &[Token], is: impl Fn(&Token) -> bool) -> Option<usize> {
    let mut level = 0i64;
    tokens.iter().position(|token| {
        level += match token.text().as_str() {
            "{" | "(" | "[" | "\\{" | "\\begin" => 1,
            "}" | ")" | "]" | "\\}" | "\\end" => -1,
            _ => 0,
        };
        level == 0 && is(token)
    })
}
