//! A formula as the paper prints it, for a report that shows it beside what was read.
//!
//! Contract: the text holds only commands of [`COMMANDS`], letters of the claim language, and signs of mathematics, so that a report may
//! give it to LaTeX or to a browser: it can neither read a file nor define a macro. A formula with anything else has no such text.

use super::name::{ACCENTS, UPRIGHT, is_letter};
use super::prepare::{LOOKS, OPERATORS, SPACES};
use super::token::{Kind, Token};

/// The longest text in bytes.
const LENGTH: usize = 20_000;

/// Commands of formulas that are read, besides letters, accents, spaces and relations.
const COMMANDS: &[&str] = &[
    "frac", "dfrac", "tfrac", "cfrac", "sqrt", "binom", "dbinom", "tbinom", "sum", "prod", "int", "lim", "max", "min",
    "exp", "ln", "sin", "cos", "tan", "arcsin", "arccos", "arctan", "sinh", "cosh", "tanh", "det", "partial", "prime",
    "infty", "left", "right", "lvert", "rvert", "lfloor", "rfloor", "lceil", "rceil", "lbrace", "rbrace", "{", "}",
    "quad", "qquad", "lt", "gt", "forall", "exists", "neg", "lnot", "begin", "end", "ast", "div", "top", "intercal",
    "mathrm", "dots", "cdots", "ldots", "colon", "\\",
];
/// Environments within a formula.
const ENVIRONMENTS: &[&str] = &["cases", "dcases", "matrix", "pmatrix", "bmatrix", "vmatrix", "aligned", "split"];

/// The rows of an equation, each with its cells, for mathematics mode.
pub(crate) fn typeset(rows: &[Vec<Vec<Token>>]) -> Option<String> {
    let mut lines = Vec::new();
    for row in rows {
        let cells = row.iter().map(|cell| text(cell)).collect::<Option<Vec<String>>>()?;
        lines.push(cells.join(" & "));
    }
    let out = match lines.as_slice() {
        [only] => only.replace(" & ", " "),
        several => format!("\\begin{{aligned}} {} \\end{{aligned}}", several.join(" \\\\ ")),
    };
    (out.len() <= LENGTH && !out.trim().is_empty()).then_some(out)
}

fn text(tokens: &[Token]) -> Option<String> {
    let mut out = String::new();
    for (place, token) in tokens.iter().enumerate() {
        if token.apart && !out.ends_with(' ') {
            out.push(' ');
        }
        match &token.kind {
            Kind::Open => out.push('{'),
            Kind::Close => out.push('}'),
            Kind::Char('~') => out.push_str("\\ "),
            Kind::Char(c) if c.is_ascii_alphanumeric() || "+-*/=<>()[]|!'.,;:_^& ?".contains(*c) => out.push(*c),
            Kind::Command(name) if name == "begin" || name == "end" => {
                let (named, _) = super::document::environment(tokens, place)?;
                if !ENVIRONMENTS.contains(&named.as_str()) {
                    return None;
                }
                out.push_str(&format!("\\{name}"));
            }
            // These two need packages that a report does not load.
            Kind::Command(name) if name == "coloneqq" => out.push_str(":="),
            Kind::Command(name) if name == "bm" => out.push_str("\\boldsymbol "),
            Kind::Command(name) if is_known(name) => {
                out.push_str(&format!("\\{name}"));
                if name.ends_with(|c: char| c.is_ascii_alphabetic()) {
                    out.push(' ');
                }
            }
            Kind::Char(_) | Kind::Command(_) | Kind::Dollar(_) | Kind::Comment(_) => return None,
        }
    }
    Some(out.trim().to_string())
}

fn is_known(name: &str) -> bool {
    [COMMANDS, ACCENTS, UPRIGHT, SPACES, LOOKS, OPERATORS].iter().any(|list| list.contains(&name)) || is_letter(name)
}
