//! Statements as text that reads back to the same tree, as Unicode and as LaTeX.
//!
//! Contract: [`expr`] and [`prop`] print with the fewest parentheses such that the parser rebuilds
//! the same tree; Unicode and LaTeX are for reading.

use super::syntax::*;

/// How to write.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Style {
    /// The claim language itself.
    Text,
    /// With signs such as ≤ and ·.
    Unicode,
    /// For mathematics mode.
    Latex,
}

/// An expression in the claim language.
pub fn expr(e: &Expr) -> String {
    Style::Text.expr(e)
}

/// A proposition in the claim language.
pub fn prop(p: &Prop) -> String {
    Style::Text.prop(p)
}

/// A claim's hypotheses and goal, one on each line.
pub fn statement(claim: &Claim, style: Style) -> Vec<String> {
    let mut out: Vec<String> = claim.items.iter().map(|item| style.item(item)).collect();
    out.push(match style {
        Style::Latex => style.prop(&claim.goal),
        _ => format!("prove {}", style.prop(&claim.goal)),
    });
    out
}

/// Precedence of expressions: sum 1, signed product 2, product 3, power 4, atom 5.
pub fn level(e: &Expr) -> u8 {
    match &e.kind {
        ExprKind::Sum(_) => 1,
        ExprKind::Negate(_) => 2,
        ExprKind::Product(_) => 3,
        ExprKind::Power(..) => 4,
        _ => 5,
    }
}

/// Precedence of propositions: equivalence 1, implication 2, or 3, and 4, not 5, atom 6. Quantifiers
/// reach as far to the right as they can, so they bind like an equivalence.
pub fn prop_level(p: &Prop) -> u8 {
    match &p.kind {
        PropKind::Equivalent(_) | PropKind::Exists(..) | PropKind::ForAll(..) => 1,
        PropKind::Implies(..) => 2,
        PropKind::Or(_) => 3,
        PropKind::And(_) => 4,
        PropKind::Not(_) => 5,
        _ => 6,
    }
}

impl Style {
    /// An expression.
    pub fn expr(self, e: &Expr) -> String {
        match &e.kind {
            ExprKind::Number(text) => text.clone(),
            ExprKind::Name(name) => self.name(name),
            ExprKind::Apply(name, arguments) => self.apply(name, arguments),
            ExprKind::Negate(a) => format!("-{}", self.at_least(a, 2)),
            ExprKind::Sum(list) => {
                let mut out = String::new();
                for (i, (sign, summand)) in list.iter().enumerate() {
                    if i > 0 {
                        out.push_str(match (self, sign) {
                            (_, Sign::Plus) => " + ",
                            (Style::Unicode, Sign::Minus) => " − ",
                            (_, Sign::Minus) => " - ",
                        });
                    }
                    out.push_str(&self.at_least(summand, if i == 0 { 2 } else { 3 }));
                }
                out
            }
            ExprKind::Product(list) => self.product(list),
            ExprKind::Power(base, exponent) => match self {
                Style::Latex => format!("{}^{{{}}}", self.at_least(base, 5), self.expr(exponent)),
                _ => {
                    // The exponent may be a power or a negated power or atom without parentheses.
                    let free = matches!(&exponent.kind, ExprKind::Negate(a) if level(a) >= 4) || level(exponent) >= 4;
                    let exponent = if free { self.expr(exponent) } else { format!("({})", self.expr(exponent)) };
                    format!("{}^{exponent}", self.at_least(base, 5))
                }
            },
            ExprKind::SumOver(index, body) => self.over(index, body, "sum", "\\sum", "Σ"),
            ExprKind::ProductOver(index, body) => self.over(index, body, "product", "\\prod", "Π"),
            ExprKind::Derivative(body, by) => match self {
                Style::Latex => {
                    let order = by.len();
                    let up = if order == 1 { String::new() } else { format!("^{order}") };
                    let down: Vec<String> = by.iter().map(|n| format!("\\partial {}", self.name(&n.text))).collect();
                    format!("\\frac{{\\partial{up}}}{{{}}}\\left({}\\right)", down.join(" "), self.expr(body))
                }
                _ => {
                    let by: Vec<String> = by.iter().map(|n| self.name(&n.text)).collect();
                    format!("derivative({}, {})", self.expr(body), by.join(", "))
                }
            },
            ExprKind::Matrix(rows) => {
                let (cell, row) = if self == Style::Latex { (" & ", " \\\\ ") } else { (", ", "; ") };
                let rows: Vec<String> =
                    rows.iter().map(|r| r.iter().map(|e| self.expr(e)).collect::<Vec<_>>().join(cell)).collect();
                let inner = rows.join(row);
                if self == Style::Latex {
                    format!("\\begin{{pmatrix}} {inner} \\end{{pmatrix}}")
                } else {
                    format!("[{inner}]")
                }
            }
        }
    }

    fn at_least(self, e: &Expr, least: u8) -> String {
        if level(e) >= least {
            return self.expr(e);
        }
        match self {
            Style::Latex => format!("\\left({}\\right)", self.expr(e)),
            _ => format!("({})", self.expr(e)),
        }
    }

    fn product(self, list: &[(Factor, Expr)]) -> String {
        if self == Style::Latex {
            let side =
                |operator: Factor| -> Vec<&Expr> { list.iter().filter(|p| p.0 == operator).map(|p| &p.1).collect() };
            let (above, below) = (side(Factor::Times), side(Factor::Over));
            let joined = |list: &[&Expr]| match list {
                [one] => self.expr(one),
                _ => list
                    .iter()
                    .enumerate()
                    .map(|(i, e)| self.at_least(e, if i == 0 { 2 } else { 3 }))
                    .collect::<Vec<_>>()
                    .join(" "),
            };
            if below.is_empty() {
                return list.iter().map(|(_, e)| self.at_least(e, 3)).collect::<Vec<_>>().join(" \\, ");
            }
            return format!("\\frac{{{}}}{{{}}}", joined(&above), joined(&below));
        }
        let mut out = String::new();
        for (i, (operator, factor)) in list.iter().enumerate() {
            if i > 0 {
                out.push_str(match (self, operator) {
                    (Style::Unicode, Factor::Times) => "·",
                    (_, Factor::Times) => "*",
                    (_, Factor::Over) => "/",
                });
            }
            // A product inside a product keeps its parentheses: the tree is flat only where written so.
            let negated = i > 0 && matches!(&factor.kind, ExprKind::Negate(a) if level(a) >= 4);
            out.push_str(&if negated { self.expr(factor) } else { self.at_least(factor, 4) });
        }
        out
    }

    fn over(self, index: &Index, body: &Expr, word: &str, latex: &str, sign: &str) -> String {
        let (name, from, to) = (self.name(&index.name.text), self.expr(&index.from), self.expr(&index.to));
        match self {
            Style::Text => format!("{word}({name} = {from}..{to}, {})", self.expr(body)),
            Style::Unicode => format!("{sign}({name} = {from}…{to}, {})", self.expr(body)),
            Style::Latex => format!("{latex}_{{{name}={from}}}^{{{to}}} {}", self.at_least(body, 3)),
        }
    }

    fn apply(self, name: &Name, arguments: &[Expr]) -> String {
        let list: Vec<String> = arguments.iter().map(|a| self.expr(a)).collect();
        let list = list.join(", ");
        match (self, name.text.as_str()) {
            (Style::Latex, "sqrt") => format!("\\sqrt{{{list}}}"),
            (Style::Latex, "cbrt") => format!("\\sqrt[3]{{{list}}}"),
            (Style::Latex, "sech" | "transpose") => format!("\\operatorname{{{}}}\\left({list}\\right)", name.text),
            (Style::Latex, "exp" | "ln" | "cosh" | "sinh" | "tanh" | "det") => {
                format!("\\{}\\left({list}\\right)", name.text)
            }
            (Style::Latex, _) if arguments.len() == 1 => format!("{}_{{{list}}}", self.name(&name.text)),
            (Style::Unicode, "sqrt") => match arguments {
                [one] if level(one) >= 5 => format!("√{list}"),
                _ => format!("√({list})"),
            },
            (Style::Latex, _) => format!("{}\\left({list}\\right)", self.name(&name.text)),
            _ => format!("{}({list})", self.name(&name.text)),
        }
    }

    /// A name: `mu`, `v_mu`, `m1`.
    pub fn name(self, name: &str) -> String {
        if self == Style::Text {
            return name.to_string();
        }
        if let Some((head, tail)) = name.split_once('_') {
            return match self {
                Style::Latex => format!("{}_{{{}}}", self.name(head), self.name(tail)),
                _ => format!("{}_{}", self.name(head), self.name(tail)),
            };
        }
        let letters = name.trim_end_matches(|c: char| c.is_ascii_digit());
        let digits = &name[letters.len()..];
        let primes = letters.trim_end_matches('\'');
        let marks = &letters[primes.len()..];
        let head = match (greek(primes), self) {
            (Some((latex, _)), Style::Latex) => latex.to_string(),
            (Some((_, sign)), _) => sign.to_string(),
            _ => primes.to_string(),
        };
        match self {
            Style::Latex if digits.is_empty() => format!("{head}{marks}"),
            Style::Latex => format!("{head}{marks}_{{{digits}}}"),
            _ => {
                let low: String =
                    digits.chars().filter_map(|c| c.to_digit(10).and_then(|d| char::from_u32(0x2080 + d))).collect();
                format!("{head}{marks}{low}")
            }
        }
    }

    /// The sign of a relation.
    pub fn relation(self, relation: Relation) -> &'static str {
        match (self, relation) {
            (_, Relation::Equal) => "=",
            (_, Relation::Less) => "<",
            (_, Relation::Greater) => ">",
            (Style::Text, Relation::NotEqual) => "!=",
            (Style::Text, Relation::LessEqual) => "<=",
            (Style::Text, Relation::GreaterEqual) => ">=",
            (Style::Unicode, Relation::NotEqual) => "≠",
            (Style::Unicode, Relation::LessEqual) => "≤",
            (Style::Unicode, Relation::GreaterEqual) => "≥",
            (Style::Latex, Relation::NotEqual) => "\\ne",
            (Style::Latex, Relation::LessEqual) => "\\le",
            (Style::Latex, Relation::GreaterEqual) => "\\ge",
        }
    }

    fn word(self, text: &'static str) -> String {
        match (self, text) {
            (Style::Latex, "=>") => "\\Rightarrow".to_string(),
            (Style::Latex, "<=>") => "\\Leftrightarrow".to_string(),
            (Style::Latex, "->") => "\\to".to_string(),
            (Style::Latex, "infinity") => "\\infty".to_string(),
            (Style::Latex, word) => format!("\\text{{ {word} }}"),
            (Style::Unicode, "=>") => "⇒".to_string(),
            (Style::Unicode, "<=>") => "⇔".to_string(),
            (Style::Unicode, "->") => "→".to_string(),
            (Style::Unicode, "infinity") => "∞".to_string(),
            (_, word) => word.to_string(),
        }
    }

    /// A proposition.
    pub fn prop(self, p: &Prop) -> String {
        let listed = |list: &[Prop], word: &'static str, least: u8| {
            let parts: Vec<String> = list.iter().map(|q| self.prop_at_least(q, least)).collect();
            parts.join(&format!(" {} ", self.word(word)))
        };
        match &p.kind {
            PropKind::Compare(sides, relations) => {
                let mut out = sides.first().map(|e| self.expr(e)).unwrap_or_default();
                for (relation, side) in relations.iter().zip(sides.iter().skip(1)) {
                    out.push_str(&format!(" {} {}", self.relation(*relation), self.expr(side)));
                }
                out
            }
            PropKind::And(list) => listed(list, "and", 5),
            PropKind::Or(list) => listed(list, "or", 4),
            PropKind::Not(q) => format!("{} {}", self.word("not"), self.prop_at_least(q, 5)),
            PropKind::Implies(a, b) => {
                format!("{} {} {}", self.prop_at_least(a, 3), self.word("=>"), self.prop_at_least(b, 2))
            }
            PropKind::Equivalent(list) => listed(list, "<=>", 2),
            PropKind::Exists(bindings, body) => {
                format!("{} {}: {}", self.word("exists"), self.bindings(bindings), self.prop(body))
            }
            PropKind::ForAll(bindings, body) => {
                format!("{} {}: {}", self.word("for all"), self.bindings(bindings), self.prop(body))
            }
            PropKind::Extremum(x) => {
                let word = if x.maximum { "maximum of" } else { "minimum of" };
                let at: Vec<String> =
                    x.at.iter().map(|(n, e)| format!("{} = {}", self.name(&n.text), self.expr(e))).collect();
                let only = if x.unique { "only at" } else { "at" };
                format!(
                    "{} {} {} {} {} {} {} {}",
                    self.word(word),
                    self.expr(&x.of),
                    self.word("over"),
                    self.bindings(&x.over),
                    self.word(only),
                    at.join(", "),
                    self.word("is"),
                    self.expr(&x.value)
                )
            }
            PropKind::Limit(l) => format!(
                "{} {} {} {} {} {} {} {}",
                self.word("limit of"),
                self.expr(&l.of),
                self.word("as"),
                self.name(&l.variable.text),
                self.word("->"),
                self.word("infinity"),
                self.word("is"),
                self.expr(&l.value)
            ),
        }
    }

    fn prop_at_least(self, p: &Prop, least: u8) -> String {
        if prop_level(p) >= least { self.prop(p) } else { format!("({})", self.prop(p)) }
    }

    /// Bindings, separated by `;`.
    pub fn bindings(self, bindings: &[Binding]) -> String {
        bindings.iter().map(|b| self.binding(b)).collect::<Vec<_>>().join("; ")
    }

    /// One binding.
    pub fn binding(self, b: &Binding) -> String {
        let names: Vec<String> = b
            .names
            .iter()
            .map(|(n, i)| match (i, self) {
                (Some(i), Style::Latex) => format!("{}_{{{}}}", self.name(&n.text), self.name(&i.text)),
                (Some(i), _) => format!("{}({})", self.name(&n.text), self.name(&i.text)),
                (None, _) => self.name(&n.text),
            })
            .collect();
        let mut out = names.join(", ");
        let range = b.constraints.iter().any(|c| matches!(c, Constraint::Range(..)));
        if b.natural && !range {
            out.push_str(&format!(" {}", self.word("natural")).replace("  ", " "));
        } else if b.constraints.is_empty() {
            out.push_str(&format!(" {}", self.word("real")).replace("  ", " "));
        }
        for constraint in &b.constraints {
            out.push(' ');
            out.push_str(&match constraint {
                Constraint::Relation(r, e) => format!("{} {}", self.relation(*r), self.expr(e)),
                Constraint::Interval { from, from_closed, to, to_closed } => format!(
                    "{} {}{}, {}{}",
                    if self == Style::Latex {
                        "\\in"
                    } else if self == Style::Unicode {
                        "∈"
                    } else {
                        "in"
                    },
                    if *from_closed { "[" } else { "(" },
                    self.expr(from),
                    self.expr(to),
                    if *to_closed { "]" } else { ")" }
                ),
                Constraint::Range(a, b) => match self {
                    Style::Text => format!("in {}..{}", self.expr(a), self.expr(b)),
                    Style::Unicode => format!("∈ {}…{}", self.expr(a), self.expr(b)),
                    Style::Latex => format!("\\in \\{{{}, \\dots, {}\\}}", self.expr(a), self.expr(b)),
                },
            });
        }
        if let (Some((a, to)), Some((_, Some(index)))) = (&b.indices, b.names.first()) {
            out.push_str(&format!(" for {} in {}..{}", index.text, self.expr(a), self.expr(to)));
        }
        out
    }

    /// A declaration.
    pub fn item(self, item: &Item) -> String {
        let latex = self == Style::Latex;
        match item {
            Item::Given(bindings) if latex => self.bindings(bindings),
            Item::Given(bindings) => format!("given {}", self.bindings(bindings)),
            Item::Let { name, parameters, value } => {
                let parameters: Vec<String> = parameters.iter().map(|p| self.name(&p.text)).collect();
                let head = if parameters.is_empty() {
                    self.name(&name.text)
                } else {
                    format!("{}({})", self.name(&name.text), parameters.join(", "))
                };
                format!("{}{head} = {}", if latex { "" } else { "let " }, self.expr(value))
            }
            Item::Define { name, initial, index, step, .. } => {
                let (u, k) = (self.name(&name.text), self.name(&index.text));
                let (a, b) = (self.expr(initial), self.expr(step));
                if latex {
                    format!("{u}_{{0}} = {a}, \\quad {u}_{{{k}+1}} = {b}")
                } else {
                    format!("define {u} by {u}(0) = {a}, {u}({k} + 1) = {b}")
                }
            }
            Item::Assume { label, prop } => match (label, latex) {
                (Some(label), false) => format!("assume {}: {}", label.text, self.prop(prop)),
                (None, false) => format!("assume {}", self.prop(prop)),
                (_, true) => self.prop(prop),
            },
        }
    }
}

fn greek(name: &str) -> Option<(&'static str, &'static str)> {
    const GREEK: &[(&str, &str, &str)] = &[
        ("mu", "\\mu", "μ"),
        ("eta", "\\eta", "η"),
        ("nu", "\\nu", "ν"),
        ("kappa", "\\kappa", "κ"),
        ("lambda", "\\lambda", "λ"),
        ("theta", "\\theta", "θ"),
        ("psi", "\\psi", "ψ"),
        ("rho", "\\rho", "ρ"),
        ("alpha", "\\alpha", "α"),
        ("beta", "\\beta", "β"),
    ];
    GREEK.iter().find(|g| g.0 == name || g.2 == name).map(|g| (g.1, g.2))
}
