//! Definite integrals: `\int_a^b f(x) \, dx`.

use super::derivative::differential;
use super::expression::{Read, Reader};
use super::name::{argument, base, begin, scripts, words_of};
use super::piece::Piece;
use super::place::Placed;
use super::refusal::{ambiguous, refused};
use super::scope::Role;
use super::token::{Kind, Token};
use carom_diagnostic::Span;

impl Reader<'_, '_, '_> {
    /// The integral whose sign is next, with all that it reaches: up to its own `d x`.
    pub(crate) fn integral(&mut self, start: Span) -> Read<Piece> {
        let (below, above) = self.below_and_above()?;
        let (Some(below), Some(above)) = (below, above) else {
            let help = "write its ends, \\int_a^b, or state the antiderivative: \\frac{dF}{dx} = f";
            return Err(refused("this integral has no ends", help, start));
        };
        if below.iter().any(|t| t.is("infty")) {
            let help = "write its halves, each as a statement of its own: \\int_{0}^{\\infty} … \\, dx = …";
            return Err(refused("this integral begins at infinity", help, start));
        }
        let (from, to) = (self.sum_in(below)?, self.upper_end(above)?);
        let end = own_differential(&self.tokens[self.at..]).map(|place| self.at + place);
        if end.is_none()
            && let Some((tokens, next)) = in_numerator(&self.tokens[self.at..])
        {
            let behind = self.at + next;
            let here = std::mem::replace(&mut self.at, behind);
            if self.goes_on_as_product() {
                let readings = ["up to its fraction with the differential", "over all that follows"];
                let write = ["write parentheses around the integral", "write the differential behind the integrand"];
                return Err(ambiguous("how far this integral reaches", readings, write, self.since(start)));
            }
            self.at = here;
            let whole = self.inside(&tokens, |inner| inner.between((from, to), start))?;
            self.at = behind;
            return Ok(whole);
        }
        self.between((from, to), start)
    }

    /// The last value of an index or variable: a number, or infinity in an equation that says a limit.
    pub(crate) fn upper_end(&mut self, tokens: &[Token]) -> Read<Piece> {
        match tokens {
            [sign] if sign.is("infty") => Ok(Piece::atom("infinity", sign.span)),
            _ => self.sum_in(tokens),
        }
    }

    /// Whether a token stands in what is left of the product here.
    fn in_this_term(&self, wanted: &Kind) -> bool {
        let mut level = 0i64;
        for token in &self.tokens[self.at..] {
            level += token.nesting();
            let is_end = matches!(token.char(), Some('+' | '-' | ',')) || super::binding::relation_of(token).is_some();
            if level < 0 || level == 0 && is_end {
                return false;
            }
            if token.kind == *wanted {
                return true;
            }
        }
        false
    }

    /// The integrand here with its differential, between these ends.
    fn between(&mut self, (from, to): (Piece, Piece), start: Span) -> Read<Piece> {
        let Some(end) = own_differential(&self.tokens[self.at..]).map(|place| self.at + place) else {
            let help = "write it behind the integrand, as in \\int_a^b f(x) \\, dx";
            return Err(refused("the variable of this integral is not read", help, start));
        };
        let declared = self.scope.names.spelled("d").is_some_and(|name| self.scope.roles.contains_key(name));
        if declared && self.tokens[end].is_char('d') {
            let readings = ["the end of the integral", "a factor d"];
            let write = ["write \\mathrm{d}, or another name for the number", "give d another name"];
            return Err(ambiguous("a d within an integral", readings, write, self.tokens[end].span));
        }
        let behind = differential(self.tokens, end).unwrap_or(end + 1);
        let Some((first, next)) = base(self.tokens, behind)? else {
            return Err(refused("the variable of this integral is not read", "write d x", self.tokens[end].span));
        };
        let (variable, next) = scripts(self.tokens, first, self.tokens[behind].span, next)?;
        let integrand = &self.tokens[self.at..end];
        let here = std::mem::replace(&mut self.at, next);
        let first_kind = &self.tokens[behind].kind;
        if self.goes_on_as_product() && (integrand.is_empty() || self.in_this_term(first_kind)) {
            let readings = ["the integrand", "a factor behind the integral"];
            let write = ["write the differential behind the integrand", "write parentheses around the integral"];
            return Err(ambiguous("what stands behind the differential", readings, write, self.span()));
        }
        self.at = here;
        let name = self.scope.bind(&variable)?;
        let body = match integrand {
            [] => Ok(Piece::atom("1", start)),
            [sign] if sign.is_char('-') => Ok(Piece::new(Placed::new("-1", start), 2)),
            _ => self.sum_in(integrand),
        };
        self.scope.bound.pop();
        let body = body?;
        let words: Vec<&str> = words_of(body.text.text()).collect();
        let has_names = words.iter().any(|word| word.starts_with(|c: char| c.is_alphabetic()));
        if has_names && !words.contains(&name.as_str()) {
            let help =
                format!("write the integrand as a formula in {name}, or take what is constant out of the integral");
            return Err(refused(format!("the integrand does not mention {name}"), help, self.since(start)));
        }
        // A definition speaks of the declared variable of this name, not of the one that is integrated over.
        let is_definition = |word: &&str| matches!(self.scope.roles.get(*word), Some(Role::Definition | Role::Matrix));
        if self.scope.names.spelled(&variable.key()).is_some_and(|own| own != name)
            && let Some(word) = words.iter().find(|word| is_definition(word))
        {
            let help = "write the definition out, or define it as a function of the variable";
            return Err(refused(
                format!("{word} may depend on the variable of this integral"),
                help,
                self.since(start),
            ));
        }
        self.at = next;
        let mut text = Placed::new(&format!("integral({name} = "), start);
        text.append(&from.text);
        text.push("..", start);
        text.append(&to.text);
        text.push(", ", start);
        text.append(&body.text);
        text.push(")", start);
        Ok(Piece { is_vector: body.is_vector, ..Piece::new(text, 5) })
    }
}

/// The integrand of `\int_0^u \frac{dv}{g + k v^2}` with its differential behind it, and where its fraction ends: the first
/// fraction outside of all braces, if the numerator ends with the differential.
fn in_numerator(tokens: &[Token]) -> Option<(Vec<Token>, usize)> {
    let mut level = 0i64;
    let at = tokens.iter().position(|token| {
        level += token.nesting();
        level == 0 && ["frac", "dfrac", "tfrac"].iter().any(|name| token.is(name))
    })?;
    let ends =
        |t: &Token| super::binding::relation_of(t).is_some() || matches!(t.char(), Some('+' | ',')) || t.is("int");
    if tokens[..at].iter().any(ends) || tokens.get(at + 1)?.kind != Kind::Open {
        return None;
    }
    let (above, next) = argument(tokens, at + 1).ok()?;
    let (_, end) = argument(tokens, next).ok()?;
    let d = own_differential(above)?;
    let behind = differential(above, d)?;
    let (_, last) = begin(&above[behind..])?;
    if behind + last != above.len() {
        return None;
    }
    let one = Token { kind: Kind::Char('1'), ..above[d].clone() };
    let rest = if d == 0 { vec![one] } else { above[..d].to_vec() };
    let parts = [&tokens[..at + 2], &rest, &tokens[next - 1..end], &above[d..]];
    Some((parts.concat(), end))
}

/// Where the differential of the integral stands, outside of all braces and parentheses; those within have their own.
fn own_differential(tokens: &[Token]) -> Option<usize> {
    let (mut level, mut open) = (0i64, 1);
    for (place, token) in tokens.iter().enumerate() {
        match &token.kind {
            Kind::Open | Kind::Char('(' | '[') => level += 1,
            Kind::Close | Kind::Char(')' | ']') => level -= 1,
            _ if level != 0 => {}
            _ if token.is("int") => open += 1,
            _ if !token.is("partial") && differential(tokens, place).is_some() => {
                open -= 1;
                if open == 0 {
                    return Some(place);
                }
            }
            _ => {}
        }
    }
    None
}
