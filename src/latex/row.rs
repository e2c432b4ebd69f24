//! The equations of a displayed formula: which rows belong together.
//!
//! Contract: a row that begins with a sign of comparison goes on with the row before it, and so does one that begins with `+`. A
//! row that begins with a minus sign and compares something itself is refused unless a comment decides.

use super::binding::relation_of;
use super::comment::first_word;
use super::document::{Clause, Display, Row};
use super::expression::is_space;
use super::form::shows_its_argument;
use super::prepare::{after_text, printed};
use super::refusal::{ambiguous, refused};
use super::remark::without_remarks;
use super::token::{Kind, Token};
use carom_checker::claim::parse::is_keyword;
use carom_diagnostic::{Diagnostic, Span};

/// Signs of comparison that have no relation of the claim language, or another meaning in it.
const RELATIONS: &[&str] = &[
    "approx", "equiv", "propto", "sim", "simeq", "ll", "gg", "cong", "lesssim", "gtrsim", "in", "mapsto", "iff",
    "implies",
];

/// An equation: one row, or several that go on.
#[derive(Debug, Default)]
pub(crate) struct Joined {
    pub tokens: Vec<Token>,
    /// The same in rows and cells, as it is printed.
    pub rows: Vec<Vec<Vec<Token>>>,
    pub clauses: Vec<Clause>,
    pub label: Option<String>,
    pub number: Option<String>,
    pub span: Span,
    /// Why it may not be whole.
    pub fault: Option<Diagnostic>,
}

/// The equations of a displayed formula.
///
/// # Errors
/// Rows that may belong together or not.
pub(crate) fn equations(display: &Display, has_remarks: bool) -> Result<Vec<Joined>, Diagnostic> {
    let plain = display.environment.trim_end_matches('*');
    let mut out: Vec<Joined> = Vec::new();
    // Comments alone belong to the row that follows.
    let mut waiting: Vec<Clause> = Vec::new();
    for row in &display.rows {
        let is_remarked = has_remarks || row.clauses.iter().any(|clause| first_word(&clause.text) == "remark");
        let cells = if is_remarked { without_remarks(&row.cells) } else { row.cells.clone() };
        let row = &Row { cells, ..row.clone() };
        let filled = row.cells.iter().filter(|cell| cell.iter().any(|t| !is_space(t))).count();
        // Words in the cells behind the equation are its condition.
        let is_condition = |cell: &Vec<Token>| {
            let first = cell.iter().find(|t| !is_space(t) && !t.is("quad") && !t.is("qquad"));
            first.is_none_or(|t| t.is_text() || t.is("forall"))
        };
        let has_condition = row.cells.len() > 2 && row.cells[2..].iter().all(is_condition);
        // Columns of one equation, as those of a system are set.
        let is_one = row.cells.iter().flatten().filter(|t| is_relation(t)).count() == 1 && {
            let cells: Vec<&Vec<Token>> = row.cells.iter().filter(|cell| printed(cell).next().is_some()).collect();
            cells.windows(2).all(|pair| links(pair[0], pair[1]))
        };
        if plain != "eqnarray" && filled > 2 && !has_condition && !is_one {
            let help = "give each equation a row of its own";
            return Err(refused("more than one equation stands in this row", help, row.span));
        }
        let mut clauses = std::mem::take(&mut waiting);
        clauses.extend(row.clauses.iter().cloned());
        if filled == 0 {
            match out.last_mut() {
                Some(before) if !clauses.is_empty() && row.label.is_none() => before.clauses.append(&mut clauses),
                Some(before) if row.label.is_some() => before.label = row.label.clone(),
                _ => waiting = clauses,
            }
            continue;
        }
        let tokens = side_by_side(&row.cells);
        let decided = clauses.iter().find_map(|clause| match first_word(&clause.text) {
            "continues" => Some(true),
            "begins" => Some(false),
            _ => None,
        });
        let goes_on = match (decided, out.last()) {
            (_, None) => false,
            (Some(decided), _) => decided,
            (None, Some(before)) => plain == "multline" || continues(&row.cells, &tokens, before)?,
        };
        // A row without a sign of comparison is no equation: whether the one before ends with it is not known.
        if let Some(before) = out.last_mut().filter(|_| !goes_on && decided.is_none() && !compares(&tokens)) {
            let help = "write `%carom continues` or `%carom begins` in the row below";
            let message = "the row below compares nothing, and this equation may go on in it";
            before.fault = Some(refused(message, help, before.span));
        }
        let is_stray = !goes_on && decided.is_none() && !out.is_empty() && !compares(&tokens);
        match out.last_mut().filter(|_| goes_on) {
            Some(before) => {
                let is_behind = decided.is_none() && plain != "multline" && has_condition_behind(&before.tokens);
                if is_behind && opens_row(&tokens) {
                    let readings = ["the equation before the condition", "the condition"];
                    let write = ["put the condition behind the last row", "write `%carom continues`"];
                    return Err(ambiguous("what this row goes on with", readings, write, row.span));
                }
                // A row of `multline` may be one more equation.
                let goes = decided == Some(true) || links(&before.tokens, &tokens);
                if let Some(first) = tokens.first() {
                    before.tokens.push(space(if goes { "," } else { "quad" }, first));
                }
                before.tokens.extend(tokens);
                before.rows.push(row.cells.clone());
                before.clauses.extend(clauses);
                before.label = before.label.take().or_else(|| row.label.clone());
                before.span.end = row.span.end;
                before.number = match (before.number.take(), row.number.clone()) {
                    (Some(first), Some(last)) => {
                        Some(format!("{}-{last}", first.split('-').next().unwrap_or_default()))
                    }
                    (first, last) => first.or(last),
                };
            }
            None => out.push(Joined {
                tokens,
                rows: vec![row.cells.clone()],
                clauses,
                label: row.label.clone(),
                number: row.number.clone(),
                span: row.span,
                fault: row.fault.clone().or(is_stray.then(|| {
                    let help = "write `%carom continues` or `%carom begins`";
                    refused("this row compares nothing, and it may belong to the row above", help, row.span)
                })),
            }),
        }
    }
    if out.is_empty() {
        let help = "write a formula, or remove it";
        return Err(refused("this formula is empty", help, display.span));
    }
    Ok(out)
}

/// The tokens of cells in one row. Where no sign links two cells, what stands in them is apart.
pub(crate) fn side_by_side(cells: &[Vec<Token>]) -> Vec<Token> {
    let mut out: Vec<Token> = Vec::new();
    for cell in cells {
        if let Some(first) = printed(cell).next()
            && printed(&out).next().is_some()
            && !links(&out, cell)
        {
            out.push(space("quad", first));
        }
        out.extend_from_slice(cell);
    }
    out
}

fn space(name: &str, place: &Token) -> Token {
    Token { kind: Kind::Command(name.to_string()), ..place.clone() }
}

/// Whether a sign between two parts of a formula, or a parenthesis around it, makes them one.
fn links(before: &[Token], after: &[Token]) -> bool {
    let is_sign =
        |t: &Token| opens(t) || t.is("mp") || t.is("approx") || t.is("in") || t.is("coloneqq") || t.is_char(':');
    printed(before).last().is_some_and(is_sign) || printed(after).next().is_some_and(is_sign) || is_open(before)
}

/// Whether a token compares, in a way that is read or not.
fn is_relation(token: &Token) -> bool {
    relation_of(token).is_some() || token.command().is_some_and(|name| RELATIONS.contains(&name))
}

/// Whether a sign stands between two parts of a formula.
fn opens(token: &Token) -> bool {
    relation_of(token).is_some()
        || matches!(token.char(), Some('+' | '-' | '*' | '/'))
        || token.is("cdot")
        || token.is("times")
        || token.is("pm")
}

/// Whether a row goes on with the one before it.
fn continues(cells: &[Vec<Token>], tokens: &[Token], before: &Joined) -> Result<bool, Diagnostic> {
    let Some(first) = printed(tokens).next() else { return Ok(true) };
    // Words and signs between statements belong to both rows.
    if joins(first) || printed(&before.tokens).last().is_some_and(joins) || ends_with_words(&before.tokens) {
        return Ok(true);
    }
    if printed(&before.tokens).last().is_some_and(opens) || is_open(&before.tokens) {
        return Ok(true);
    }
    if relation_of(first).is_some() || first.is("approx") {
        return Ok(true);
    }
    let arrows =
        ["Rightarrow", "implies", "Longrightarrow", "Leftrightarrow", "iff", "Longleftrightarrow", "therefore"];
    if first.command().is_some_and(|name| arrows.contains(&name)) {
        let readings = ["the row before implies this row", "this row is a statement of its own"];
        let write = ["write `%carom continues`", "leave the arrow out"];
        return Err(ambiguous("an arrow at the beginning of a row", readings, write, first.span));
    }
    let is_sign = opens(first) || first.is("mp");
    if !is_sign {
        return Ok(false);
    }
    let at_left = cells.len() > 1 && cells.first().is_some_and(|cell| cell.iter().any(|t| !is_space(t)));
    match (first.is_char('-'), compares(tokens)) {
        (true, true) if at_left => Ok(false),
        (true, true) => {
            let readings = ["the end of the row before", "an equation of its own"];
            let write = ["write `%carom continues`", "write `%carom begins`"];
            Err(ambiguous("a row that begins with a minus sign", readings, write, first.span))
        }
        _ => Ok(true),
    }
}

/// Whether a token stands between two statements.
fn joins(token: &Token) -> bool {
    const SIGNS: [&str; 8] = ["land", "lor", "wedge", "vee", "forall", "impliedby", "Leftarrow", "Longleftarrow"];
    token.is_text() || token.is_char(':') || token.command().is_some_and(|name| SIGNS.contains(&name))
}

/// Whether the last thing in a row is words in braces, as in `x > 0 \\text{ or}`.
fn ends_with_words(tokens: &[Token]) -> bool {
    let end = tokens.iter().rposition(|token| !is_space(token)).map_or(0, |last| last + 1);
    after_text(&tokens[..end])
}

/// Whether words or a comma part a condition or another statement from an equation.
fn has_condition_behind(tokens: &[Token]) -> bool {
    let mut level = 0i64;
    tokens.iter().any(|token| {
        level += token.nesting();
        level == 0 && (token.is_text() || token.is_char(',') || token.is_char(';'))
    })
}

/// Whether a row begins with a sign that goes on with an expression.
fn opens_row(tokens: &[Token]) -> bool {
    printed(tokens).next().is_some_and(|first| opens(first) || first.is("mp") || is_relation(first))
}

/// Whether a sign of comparison stands outside of parentheses; a box around an equation is none.
fn compares(tokens: &[Token]) -> bool {
    // For each brace or parenthesis that is open, whether an equation may stand in it.
    let mut open: Vec<bool> = Vec::new();
    let mut before: Option<&Token> = None;
    for token in tokens {
        match token.kind {
            Kind::Open => open.push(before.is_some_and(shows_its_argument)),
            Kind::Char('(') => open.push(false),
            Kind::Close | Kind::Char(')') => drop(open.pop()),
            _ if open.iter().all(|shows| *shows) && (is_relation(token) || token.is("to")) => return true,
            _ => {}
        }
        before = Some(token);
    }
    false
}

/// Whether a parenthesis is open at the end.
fn is_open(tokens: &[Token]) -> bool {
    tokens.iter().fold(0i64, |level, t| match t.kind {
        Kind::Char('(' | '[') => level + 1,
        Kind::Char(')' | ']') => level - 1,
        _ => level,
    }) > 0
}

/// The name of a claim: its label without `eq:`, else its number, else its line, in a file of another name with that.
pub(crate) fn claim_name(label: Option<&str>, number: Option<&str>, stem: Option<&str>, line: usize) -> String {
    let clean = |text: &str| {
        let parts = text.split(|c: char| !c.is_ascii_alphanumeric()).filter(|part| !part.is_empty());
        parts.collect::<Vec<_>>().join("-")
    };
    let label = label.map(|label| {
        let (kind, rest) = label.split_once(':').unwrap_or(("", label));
        clean(if ["eq", "eqn", "equation"].contains(&kind) { rest } else { label })
    });
    let name = match (label.filter(|label| !label.is_empty()), number) {
        (Some(label), _) => label,
        (None, Some(number)) => format!("eq-{}", clean(&number.replace('\'', "-prime"))),
        (None, None) => match stem.map(clean).filter(|stem| !stem.is_empty()) {
            Some(stem) => format!("{stem}-line-{line}"),
            None => format!("line-{line}"),
        },
    };
    let is_name = name.starts_with(|c: char| c.is_ascii_alphabetic()) && !is_keyword(&name);
    let name = if is_name { name } else { format!("eq-{name}") };
    name.chars().take(80).collect::<String>().trim_end_matches('-').to_string()
}
