//! Macros of a document: `\newcommand`, `\renewcommand`, `\providecommand`, `\def` and `\DeclareMathOperator`.
//!
//! Contract: [`Macros::expand`] replaces macros until none is left. What a macro expands to stands where the macro does.
//! Limits: [`DEPTH_LIMIT`] for macros within macros, which a macro that calls itself reaches, [`USES_LIMIT`], and the number of
//! tokens.

use super::refusal::{expected, limit, refused};
use super::token::{Kind, TOKENS_LIMIT, Token};
use carom_diagnostic::{Diagnostic, Span};
use std::collections::BTreeMap;

/// The deepest nesting of macros.
pub(crate) const DEPTH_LIMIT: usize = 100;
/// The most macros that an equation uses, those within macros counted each time.
pub(crate) const USES_LIMIT: usize = 100_000;

/// A macro: the number of its arguments, the default of the first one, and its body.
#[derive(Clone, Debug)]
struct Macro {
    arguments: usize,
    default: Option<Vec<Token>>,
    body: Vec<Token>,
    /// Whether it begins or ends a displayed formula or an environment.
    is_structure: bool,
}

/// The macros that are defined so far.
#[derive(Default)]
pub(crate) struct Macros {
    list: BTreeMap<String, Macro>,
    /// For each group that is open: what the macros that it defines were before.
    groups: Vec<Vec<(String, Option<Macro>)>>,
}

/// Whether a command defines a macro.
pub(crate) fn defines(command: &str) -> bool {
    const DEFINING: [&str; 13] = [
        "newcommand",
        "renewcommand",
        "providecommand",
        "DeclareRobustCommand",
        "def",
        "gdef",
        "let",
        "DeclareMathOperator",
        "newenvironment",
        "renewenvironment",
        "NewDocumentCommand",
        "RenewDocumentCommand",
        "DeclareDocumentCommand",
    ];
    DEFINING.contains(&command)
}

impl Macros {
    /// Reads the definition behind the command at `at`, and returns where it ends.
    ///
    /// # Errors
    /// A definition that is not read.
    pub(crate) fn define(&mut self, tokens: &[Token], at: usize) -> Result<usize, Diagnostic> {
        let (command, span) = (tokens[at].command().unwrap_or_default(), tokens[at].span);
        let mut next = at + 1;
        next += usize::from(tokens.get(next).is_some_and(|t| t.is_char('*')));
        if command.ends_with("environment") {
            let help = "use the environments of amsmath, whose equations are read";
            return Err(refused("an environment of the document's own is not read", help, span));
        }
        if command.ends_with("DocumentCommand") {
            let help = "define macros as \\newcommand{\\name}[1]{…}";
            return Err(refused(format!("\\{command} is not read"), help, span));
        }
        let (name, mut next) = match tokens.get(next) {
            Some(Token { kind: Kind::Open, .. }) => {
                let (inner, end) = group(tokens, next)?;
                (inner.first().and_then(Token::command), end)
            }
            Some(token) => (token.command(), next + 1),
            None => (None, next),
        };
        let Some(name) = name.map(str::to_string) else {
            return Err(expected("the name of a macro", "something else", span));
        };
        if command == "let" {
            next += usize::from(tokens.get(next).is_some_and(|t| t.is_char('=')));
            let Some(meaning) = tokens.get(next) else {
                return Err(expected("the meaning of a macro", "the end of the document", span));
            };
            let known = meaning.command().and_then(|meaning| self.list.get(meaning)).cloned();
            let is_structure = self.is_structure(meaning);
            let plain = || Macro { arguments: 0, default: None, body: vec![meaning.clone()], is_structure };
            self.insert(command, name, known.unwrap_or_else(plain));
            return Ok(next + 1);
        }
        let (mut arguments, mut default) = (0, None);
        if command.ends_with("def") {
            while tokens.get(next).is_some_and(|t| t.is_char('#')) {
                arguments += 1;
                next += 2;
            }
        } else if let Some((inner, end)) = option(tokens, next) {
            arguments = inner.first().and_then(Token::char).and_then(|c| c.to_digit(10)).map_or(0, |n| n as usize);
            next = end;
            if let Some((inner, end)) = option(tokens, next) {
                default = Some(inner.to_vec());
                next = end;
            }
        }
        if !tokens.get(next).is_some_and(|t| t.kind == Kind::Open) {
            let help = "define macros as \\newcommand{\\name}[1]{…}";
            return Err(refused(format!("the definition of \\{name} is not read"), help, span));
        }
        let (body, end) = group(tokens, next)?;
        let mut body = body.to_vec();
        if command == "DeclareMathOperator" {
            let sign = |kind: Kind| Token { kind, span, apart: false };
            body.splice(0..0, [sign(Kind::Command("operatorname".to_string())), sign(Kind::Open)]);
            body.push(sign(Kind::Close));
        }
        if command != "providecommand" || !self.list.contains_key(&name) {
            let is_structure = body.iter().any(|t| self.is_structure(t));
            self.insert(command, name, Macro { arguments, default, body, is_structure });
        }
        Ok(end)
    }

    fn insert(&mut self, command: &str, name: String, defined: Macro) {
        // `\gdef` alone reaches beyond its group.
        if command == "gdef" {
            self.groups.iter_mut().for_each(|group| group.retain(|before| before.0 != name));
        } else if let Some(group) = self.groups.last_mut() {
            group.push((name.clone(), self.list.get(&name).cloned()));
        }
        self.list.insert(name, defined);
    }

    /// Takes note of what begins or ends a group: a macro that is defined in it ends with it.
    pub(crate) fn passes(&mut self, token: &Token) {
        match &token.kind {
            Kind::Open => self.groups.push(Vec::new()),
            Kind::Command(name) if name == "begingroup" || name == "bgroup" || name == "begin" => {
                self.groups.push(Vec::new());
            }
            Kind::Close => self.close(),
            Kind::Command(name) if name == "endgroup" || name == "egroup" || name == "end" => self.close(),
            _ => {}
        }
    }

    fn close(&mut self) {
        for (name, before) in self.groups.pop().into_iter().flatten().rev() {
            match before {
                Some(before) => self.list.insert(name, before),
                None => self.list.remove(&name),
            };
        }
    }

    /// The macro that this one is another name of, which then takes what stands behind it.
    fn meant<'m>(&'m self, known: &'m Macro) -> &'m Macro {
        let mut meant = known;
        for _ in 0..DEPTH_LIMIT {
            let (0, [alone]) = (meant.arguments, meant.body.as_slice()) else { break };
            let Some(next) = alone.command().and_then(|name| self.list.get(name)) else { break };
            meant = next;
        }
        meant
    }

    /// Whether a token begins or ends a displayed formula or an environment.
    fn is_structure(&self, token: &Token) -> bool {
        let known = |name: &str| self.list.get(name).is_some_and(|known| known.is_structure);
        token.kind == Kind::Dollar(2)
            || token.command().is_some_and(|name| ["begin", "end", "[", "]"].contains(&name) || known(name))
    }

    /// What the macro at `at` stands for, if that begins or ends a formula, and where to read on.
    pub(crate) fn structure(&self, tokens: &[Token], at: usize) -> Option<(Vec<Token>, usize)> {
        let token = tokens.get(at)?;
        let known = self.list.get(token.command()?).filter(|known| known.is_structure)?;
        let (_, next) = arguments(known, tokens, at).ok()?;
        Some((self.expand(&tokens[at..next]).ok()?, next))
    }

    /// The tokens without macros.
    ///
    /// # Errors
    /// An argument is missing, or a limit is reached.
    pub(crate) fn expand(&self, tokens: &[Token]) -> Result<Vec<Token>, Diagnostic> {
        if tokens.iter().all(|t| t.command().is_none_or(|name| !self.list.contains_key(name))) {
            return Ok(tokens.to_vec());
        }
        let mut out = Vec::new();
        self.expand_into(tokens, None, (None, 0), &mut 0, &mut out)?;
        Ok(out)
    }

    fn expand_into(
        &self,
        tokens: &[Token],
        place: Option<Span>,
        (behind, depth): (Option<&Token>, usize),
        uses: &mut usize,
        out: &mut Vec<Token>,
    ) -> Result<(), Diagnostic> {
        let mut at = 0;
        while let Some(token) = tokens.get(at) {
            let span = place.unwrap_or(token.span);
            let Some(known) = token.command().and_then(|name| self.list.get(name)) else {
                if out.len() >= TOKENS_LIMIT {
                    return Err(limit("tokens after macros are expanded", TOKENS_LIMIT, span));
                }
                out.push(Token { span, ..token.clone() });
                at += 1;
                continue;
            };
            if depth >= DEPTH_LIMIT {
                return Err(limit("levels of macros", DEPTH_LIMIT, span));
            }
            *uses += 1;
            if *uses > USES_LIMIT {
                return Err(limit("uses of macros in an equation", USES_LIMIT, span));
            }
            let known = self.meant(known);
            let (arguments, next) = arguments(known, tokens, at).map_err(|fault| Diagnostic { span, ..fault })?;
            at = next;
            let follows = tokens.get(at).or(behind);
            if known.default.is_some()
                && at == tokens.len()
                && arguments.len() == 1
                && behind.is_some_and(|t| t.is_char('['))
            {
                let help = "write its argument within the definition, \\newcommand{\\q}[1]{\\p[#1]}";
                return Err(refused(format!("{} may take what stands behind another macro", token.text()), help, span));
            }
            let end = tokens[at - 1].span.end.max(token.span.end);
            let span = place.unwrap_or(Span { start: token.span.start, end });
            let mut body = filled(&known.body, &arguments, token.apart, span)?;
            // As an argument without braces it is one, whatever it stands for.
            if body.len() > 1 && takes_an_argument(out) {
                let brace = |kind: Kind| Token { kind, span, apart: false };
                body.insert(0, brace(Kind::Open));
                body.push(brace(Kind::Close));
            }
            self.expand_into(&body, Some(span), (follows, depth + 1), uses, out)?;
        }
        Ok(())
    }
}

/// Whether the command that ends these tokens, perhaps with its first argument, takes what follows as an argument.
fn takes_an_argument(before: &[Token]) -> bool {
    const ONE: [&str; 12] =
        ["sqrt", "bar", "overline", "tilde", "hat", "vec", "dot", "ddot", "mathrm", "mathbf", "boldsymbol", "text"];
    const TWO: [&str; 8] = ["frac", "dfrac", "tfrac", "cfrac", "binom", "dbinom", "tbinom", "nicefrac"];
    let is =
        |token: Option<&Token>, list: &[&str]| token.and_then(Token::command).is_some_and(|name| list.contains(&name));
    let Some(last) = before.last() else { return false };
    if is(Some(last), &ONE) || is(Some(last), &TWO) {
        return true;
    }
    if last.kind != Kind::Close {
        return last.kind != Kind::Open && before.len() > 1 && is(before.get(before.len() - 2), &TWO);
    }
    let mut level = 0usize;
    let open = before.iter().rposition(|token| {
        level += usize::from(token.kind == Kind::Close);
        level = level.saturating_sub(usize::from(token.kind == Kind::Open));
        level == 0
    });
    open.and_then(|open| open.checked_sub(1)).is_some_and(|at| is(before.get(at), &TWO))
}

/// The arguments of the macro that stands at `at`, and where to read on.
fn arguments(known: &Macro, tokens: &[Token], at: usize) -> Result<(Vec<Vec<Token>>, usize), Diagnostic> {
    let (token, mut at) = (&tokens[at], at + 1);
    let mut out: Vec<Vec<Token>> = Vec::new();
    for number in 0..known.arguments {
        if number == 0
            && let Some(default) = &known.default
        {
            match option(tokens, at) {
                Some((inner, next)) => {
                    out.push(inner.to_vec());
                    at = next;
                }
                None => out.push(default.clone()),
            }
        } else if tokens.get(at).is_some_and(|t| t.kind == Kind::Open) {
            let (inner, next) = group(tokens, at)?;
            out.push(inner.to_vec());
            at = next;
        } else if let Some(one) = tokens.get(at) {
            out.push(vec![one.clone()]);
            at += 1;
        } else {
            return Err(expected(&format!("an argument of {}", token.text()), "the end of the formula", token.span));
        }
    }
    Ok((out, at))
}

/// The body of a macro with its arguments in place.
fn filled(body: &[Token], arguments: &[Vec<Token>], apart: bool, span: Span) -> Result<Vec<Token>, Diagnostic> {
    let mut out: Vec<Token> = Vec::new();
    let mut at = 0;
    while let Some(token) = body.get(at) {
        let number = body.get(at + 1).and_then(Token::char).and_then(|c| c.to_digit(10));
        match (token.is_char('#'), number) {
            (true, Some(number)) => {
                out.extend(arguments.get((number as usize).wrapping_sub(1)).into_iter().flatten().cloned());
                at += 2;
            }
            _ => {
                out.push(token.clone());
                at += 1;
            }
        }
        if out.len() > TOKENS_LIMIT {
            return Err(limit("tokens after macros are expanded", TOKENS_LIMIT, span));
        }
    }
    if let Some(first) = out.first_mut() {
        first.apart = apart;
    }
    Ok(out)
}

/// The tokens in the braces that open at `at`, and where to read on.
///
/// # Errors
/// The brace is not closed.
pub(crate) fn group(tokens: &[Token], at: usize) -> Result<(&[Token], usize), Diagnostic> {
    let mut level = 0usize;
    for (place, token) in tokens.iter().enumerate().skip(at) {
        match token.kind {
            Kind::Open => level += 1,
            Kind::Close => {
                level = level.saturating_sub(1);
                if level == 0 {
                    return Ok((&tokens[at + 1..place], place + 1));
                }
            }
            _ => {}
        }
    }
    let span = tokens.get(at).map_or(Span::default(), |t| t.span);
    Err(refused("this brace is not closed", "write `}` where its group ends", span))
}

/// The tokens in the brackets that open at `at`, if they do, and where to read on.
pub(crate) fn option(tokens: &[Token], at: usize) -> Option<(&[Token], usize)> {
    if !tokens.get(at)?.is_char('[') {
        return None;
    }
    let mut level = 0usize;
    for (place, token) in tokens.iter().enumerate().skip(at) {
        match token.kind {
            Kind::Open => level += 1,
            Kind::Close => level = level.checked_sub(1)?,
            Kind::Char(']') if level == 0 => return Some((&tokens[at + 1..place], place + 1)),
            _ => {}
        }
    }
    None
}
