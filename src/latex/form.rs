//! A formula's tokens in one form for each way to type the same thing.
//!
//! Contract: only what prints alike is put in another form: `{a \over b}` as `\frac{a}{b}`, `\left\{` with an `array` as `cases`,
//! boxes and braces around a part that stands alone as that part, `\hspace` as `\quad`.

use super::binding::relation_of;
use super::document::{end_of, environment};
use super::expression::{NESTING_LIMIT, is_space};
use super::macros::group;
use super::refusal::{command, limit, refused};
use super::token::{Kind, Token};
use carom_diagnostic::{Diagnostic, Span};

/// Commands that change only the space around their argument.
pub(crate) const CLASSES: &[&str] =
    &["mathrel", "mathbin", "mathord", "mathopen", "mathclose", "mathinner", "ensuremath"];
/// Commands that draw around their argument.
const DRAWN: &[&str] = &["boxed", "underbrace", "overbrace", "underline"];
/// Whether an equation may stand in the braces behind this command.
pub(crate) fn shows_its_argument(token: &Token) -> bool {
    token.command().is_some_and(|name| CLASSES.contains(&name) || DRAWN.contains(&name) || name == "Aboxed")
}

/// A space of so many points parts two statements; a smaller one parts two factors.
const WIDE: f64 = 8.0;

/// The tokens in the form that is read.
///
/// # Errors
/// A box or a brace around what would be read as a group; two `\over` in one group; a limit of nesting.
pub(crate) fn one_form(tokens: &[Token]) -> Result<Vec<Token>, Diagnostic> {
    formed(&without_classes(tokens), 0)
}

/// The tokens without the commands that only space what is in their braces.
fn without_classes(tokens: &[Token]) -> Vec<Token> {
    let mut out: Vec<Token> = Vec::new();
    // For each brace that is open, whether it is left out.
    let mut open: Vec<bool> = Vec::new();
    let mut tokens = tokens.iter().peekable();
    while let Some(token) = tokens.next() {
        let is_class = token.command().is_some_and(|name| CLASSES.contains(&name));
        if is_class && tokens.next_if(|t| t.kind == Kind::Open).is_some() {
            open.push(true);
            continue;
        }
        match token.kind {
            Kind::Open => open.push(false),
            Kind::Close if open.pop() == Some(true) => continue,
            _ => {}
        }
        out.push(token.clone());
    }
    out
}

fn formed(tokens: &[Token], depth: usize) -> Result<Vec<Token>, Diagnostic> {
    if depth > NESTING_LIMIT {
        return Err(limit("levels of nesting", NESTING_LIMIT, tokens.first().map_or(Span::default(), |t| t.span)));
    }
    let mut out: Vec<Token> = Vec::new();
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        let sign = |kind: Kind| Token { kind, ..token.clone() };
        let name = token.command().unwrap_or_default();
        let argument = tokens.get(at + 1).filter(|t| t.kind == Kind::Open).and_then(|_| group(tokens, at + 1).ok());
        match (name, argument) {
            (_, Some(([], next))) if token.is_text() => {
                // Of words that are blank the space prints.
                if tokens[next - 1].span.start > tokens[at + 1].span.end {
                    out.push(sign(Kind::Command(" ".to_string())));
                }
                at = next;
            }
            (_, Some((inner, next))) if token.is_text() && is_punctuation(inner) => {
                out.extend(inner.iter().cloned());
                at = next;
            }
            (name, Some((inner, next))) if DRAWN.contains(&name) => {
                let next = label(tokens, next, token)?;
                if !stands_alone(&out, inner, &tokens[next..]) {
                    return Err(command(name, token.span));
                }
                out.extend(formed(inner, depth + 1)?);
                at = next;
            }
            ("left", _) => match brace_with_array(tokens, at) {
                Some((inner, next)) => {
                    named(&mut out, "begin", token);
                    out.extend(formed(inner, depth + 1)?);
                    named(&mut out, "end", token);
                    at = next;
                }
                None => {
                    out.push(token.clone());
                    at += 1;
                }
            },
            ("not", _) if tokens.get(at + 1).is_some_and(|t| t.is_char('=')) => {
                out.push(sign(Kind::Command("ne".to_string())));
                at += 2;
            }
            _ if token.kind == Kind::Open => match group(tokens, at) {
                Ok(([], next)) if prints_nothing(out.last(), tokens.get(next)) => at = next,
                Ok((inner, next)) => {
                    braces(&mut out, inner, [token, &tokens[next - 1]], depth)?;
                    at = next;
                }
                Err(_) => {
                    out.push(token.clone());
                    at += 1;
                }
            },
            _ => {
                out.push(token.clone());
                at += 1;
            }
        }
    }
    Ok(out)
}

/// Whether an empty group between these two is no argument, and bears no index or exponent.
fn prints_nothing(before: Option<&Token>, after: Option<&Token>) -> bool {
    let takes = before.is_some_and(|t| match &t.kind {
        Kind::Command(name) => !(is_space(t) || name.ends_with("quad") || super::name::is_letter(name)),
        kind => matches!(kind, Kind::Close | Kind::Char('_' | '^' | ']')),
    });
    let bears = after.is_some_and(|t| matches!(t.char(), Some('_' | '^' | '\'')));
    !takes && !bears
}

/// The command that sets what is in its braces as the older one sets the rest of a group.
fn font(token: Option<&Token>) -> Option<&'static str> {
    let fonts = [("rm", "mathrm"), ("it", "mathit"), ("bf", "mathbf"), ("sf", "mathsf"), ("cal", "mathcal")];
    fonts.iter().find(|(old, _)| token.is_some_and(|t| t.is(old))).map(|(_, new)| *new)
}

/// `\begin{cases}` or `\end{cases}`, where a sign stands for it.
fn named(out: &mut Vec<Token>, word: &str, place: &Token) {
    let sign = |kind: Kind| Token { kind, ..place.clone() };
    out.extend([sign(Kind::Command(word.to_string())), sign(Kind::Open)]);
    out.extend("cases".chars().map(|c| Token { apart: false, ..sign(Kind::Char(c)) }));
    out.push(sign(Kind::Close));
}

/// A group, with `\over` and `\choose` as commands that come first.
fn braces(out: &mut Vec<Token>, inner: &[Token], [open, close]: [&Token; 2], depth: usize) -> Result<(), Diagnostic> {
    let mut level = 0i64;
    let mut signs = Vec::new();
    for (place, token) in inner.iter().enumerate() {
        level += i64::from(token.kind == Kind::Open) - i64::from(token.kind == Kind::Close);
        if level == 0 && (token.is("over") || token.is("choose")) {
            signs.push(place);
        }
    }
    let [place] = signs.as_slice() else {
        if let Some(second) = signs.get(1) {
            return Err(refused("two fractions in one group", "put braces around each", inner[*second].span));
        }
        let mut inner = inner;
        if let Some(new) = font(inner.first()) {
            // As an argument the group stays one.
            let before = out.iter().rev().find(|t| !is_space(t));
            let is_argument = before.is_some_and(|t| match &t.kind {
                Kind::Command(name) => !super::name::is_letter(name),
                kind => matches!(kind, Kind::Char('_' | '^')),
            });
            if is_argument {
                out.push(open.clone());
            }
            out.push(Token { kind: Kind::Command(new.to_string()), ..open.clone() });
            inner = &inner[1..];
            out.push(open.clone());
            out.extend(formed(inner, depth + 1)?);
            out.extend(std::iter::repeat_n(close.clone(), if is_argument { 2 } else { 1 }));
            return Ok(());
        }
        out.push(open.clone());
        out.extend(formed(inner, depth + 1)?);
        out.push(close.clone());
        return Ok(());
    };
    // The braces of an argument stay; others would hide a mixed number such as 2 {1 \over 3}.
    let stays = out
        .iter()
        .rev()
        .find(|t| !is_space(t))
        .is_some_and(|before| matches!(before.kind, Kind::Command(_) | Kind::Close | Kind::Char('_' | '^' | ']')));
    if stays {
        out.push(open.clone());
    }
    let word = if inner[*place].is("over") { "frac" } else { "binom" };
    out.push(Token { kind: Kind::Command(word.to_string()), ..inner[*place].clone() });
    for part in [&inner[..*place], &inner[place + 1..]] {
        out.push(open.clone());
        out.extend(formed(part, depth + 1)?);
        out.push(close.clone());
    }
    if stays {
        out.push(close.clone());
    }
    Ok(())
}

/// The body of the array in `\left\{ \begin{array}{ll} … \end{array} \right.` at `at`, and where to read on.
fn brace_with_array(tokens: &[Token], at: usize) -> Option<(&[Token], usize)> {
    let skip = |mut at: usize| {
        while tokens.get(at).is_some_and(is_space) {
            at += 1;
        }
        at
    };
    let begin = skip(at + 2);
    let opens = tokens.get(at + 1)?.is("{") || tokens.get(at + 1)?.is("lbrace");
    if !opens || !tokens.get(begin)?.is("begin") {
        return None;
    }
    let (name, mut inside) = environment(tokens, begin)?;
    match name.as_str() {
        "array" => inside = group(tokens, inside).ok()?.1,
        "aligned" | "matrix" | "gathered" => {}
        _ => return None,
    }
    let end = end_of(tokens, inside)?;
    let right = skip(environment(tokens, end)?.1);
    let closes = tokens.get(right)?.is("right") && tokens.get(right + 1)?.is_char('.');
    closes.then(|| (&tokens[inside..end], right + 2))
}

/// Where to read on behind the words at a brace; what else a brace says is not passed over.
fn label(tokens: &[Token], at: usize, brace: &Token) -> Result<usize, Diagnostic> {
    let below = tokens.get(at).is_some_and(|t| t.is_char('_')) && brace.is("underbrace");
    let above = tokens.get(at).is_some_and(|t| t.is_char('^')) && brace.is("overbrace");
    if !below && !above {
        return Ok(at);
    }
    let (inner, next) = super::name::argument(tokens, at + 1)?;
    match inner.first().is_some_and(Token::is_text) {
        true => Ok(next),
        false => Err(command("underbrace", brace.span)),
    }
}

/// Whether a part means the same without what is drawn around it: a product, or a whole side or term.
fn stands_alone(before: &[Token], inner: &[Token], after: &[Token]) -> bool {
    let mut level = 0i64;
    let signs = inner.iter().filter(|t| {
        level += match t.text().as_str() {
            "{" | "(" | "[" | "\\{" => 1,
            "}" | ")" | "]" | "\\}" => -1,
            _ => 0,
        };
        level == 0 && (relation_of(t).is_some() || matches!(t.char(), Some('+' | '-')) || t.is("pm") || t.is("mp"))
    });
    let signs: Vec<&Token> = signs.collect();
    let (compares, is_sum) = (signs.iter().any(|t| relation_of(t).is_some()), !signs.is_empty());
    let before = before.iter().rev().find(|t| !is_space(t));
    let after = after.iter().find(|t| !is_space(t));
    let ends =
        |t: &Token| matches!(t.char(), Some(',' | '.' | ';' | '&')) || t.command().is_some_and(|n| n.ends_with("quad"));
    let side = |t: Option<&Token>| t.is_none_or(|t| ends(t) || (!compares && relation_of(t).is_some()));
    let term = |t: Option<&Token>, signs: &[char]| t.is_some_and(|t| t.char().is_some_and(|c| signs.contains(&c)));
    match (compares, is_sum) {
        (true, _) => side(before) && side(after),
        (false, true) => (side(before) || term(before, &['+'])) && (side(after) || term(after, &['+', '-'])),
        (false, false) => (side(before) || term(before, &['+', '-'])) && (side(after) || term(after, &['+', '-'])),
    }
}

/// Whether these words are signs of punctuation alone.
fn is_punctuation(inner: &[Token]) -> bool {
    inner.iter().all(|t| matches!(t.char(), Some('.' | ',' | ';')) || is_space(t))
}

/// A length in points, about; one that is not known is wide.
pub(crate) fn width(said: &str) -> f64 {
    const UNITS: &[(&str, f64)] =
        &[("em", 10.0), ("ex", 4.3), ("cm", 28.5), ("mm", 2.85), ("in", 72.3), ("pt", 1.0), ("mu", 0.56), ("bp", 1.0)];
    let said = said.replace(' ', "");
    let found = UNITS.iter().find_map(|(unit, points)| {
        let number = said.strip_suffix(unit)?.parse::<f64>().ok()?;
        Some(number * points)
    });
    found.unwrap_or(WIDE)
}
