//! Statements as text that reads back to the same tree, as Unicode and as LaTeX.
//!
//! Contract: [`expr`] and [`prop`] print with the fewest parentheses such that the parser rebuilds
//! the same tree; Unicode and LaTeX are for reading, and no two trees print alike there either.

mod name;

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

/// A claim's hypotheses and goal as their author wrote them, one on each line.
pub fn statement(claim: &Claim, style: Style) -> Vec<String> {
    lines(claim.written_items(), claim.written_goal(), style)
}

/// The same as the kernel reads them: abbreviations, angles, floors and limits are written out.
pub fn statement_as_read(claim: &Claim, style: Style) -> Vec<String> {
    lines(&claim.items, &claim.goal, style)
}

fn lines(items: &[Item], goal: &Prop, style: Style) -> Vec<String> {
    let mut out: Vec<String> = items.iter().map(|item| style.item(item)).collect();
    out.push(match style {
        Style::Latex => style.prop(goal),
        _ => format!("prove {}", style.prop(goal)),
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

/// Whether an expression is a large operator before its operand, which reaches over factors that follow.
pub fn reaches(e: &Expr) -> bool {
    matches!(
        e.kind,
        ExprKind::SumOver(..) | ExprKind::ProductOver(..) | ExprKind::IntegralOver(..) | ExprKind::Derivative(..)
    )
}

impl Style {
    /// Precedence as this style writes it: in LaTeX large operators bind like products, and a numeral with
    /// an exponent is not a single sign; √ in Unicode takes a power only in parentheses.
    fn level(self, e: &Expr) -> u8 {
        match (self, &e.kind) {
            (Style::Latex, _) if reaches(e) => 3,
            (Style::Latex, ExprKind::Number(text)) if text.contains(['e', 'E']) => 4,
            (Style::Unicode, ExprKind::Apply(name, _)) if name.text == "sqrt" => 4,
            _ => level(e),
        }
    }

    /// An expression.
    pub fn expr(self, e: &Expr) -> String {
        match &e.kind {
            // An upright e is the exponent's, not a name's.
            ExprKind::Number(text) if self == Style::Latex => text.replace(['e', 'E'], "\\mathrm{e}"),
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
            ExprKind::IntegralOver(x, body) if self == Style::Latex => {
                let (name, from, to) = (self.name(&x.name.text), self.expr(&x.from), self.expr(&x.to));
                format!("\\int_{{{from}}}^{{{to}}} {} \\,d{name}", self.at_least(body, 3))
            }
            ExprKind::IntegralOver(x, body) => self.over(x, body, "integral", "", "∫"),
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
        if self.level(e) >= least {
            return self.expr(e);
        }
        match self {
            Style::Latex => format!("\\left({}\\right)", self.expr(e)),
            _ => format!("({})", self.expr(e)),
        }
    }

    fn product(self, list: &[(Factor, Expr)]) -> String {
        if self == Style::Latex {
            return self.latex_product(list);
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

    /// Factors side by side, with a point before a digit, since 2 3 is not 23; what divides stands below all factors before it. A
    /// product among the factors is in braces, which do not print and keep it apart.
    fn latex_product(self, list: &[(Factor, Expr)]) -> String {
        let mut out = String::new();
        let mut only = list.first().map(|first| &first.1);
        for (place, (operator, e)) in list.iter().enumerate() {
            if *operator == Factor::Over {
                let above = match only {
                    Some(sum) if !matches!(sum.kind, ExprKind::Product(_)) => self.expr(sum),
                    _ => out,
                };
                out = format!("\\frac{{{above}}}{{{}}}", self.expr(e));
            } else {
                let text = match e.kind {
                    ExprKind::Product(_) => format!("{{{}}}", self.expr(e)),
                    _ => self.at_least(e, if reaches(e) { 4 } else { 3 }),
                };
                if place > 0 {
                    out.push_str(if text.starts_with(|c: char| c.is_ascii_digit()) { " \\cdot " } else { " \\, " });
                }
                out.push_str(&text);
            }
            if place > 0 {
                only = None;
            }
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
            (Style::Latex, "sech" | "transpose" | "trace" | "inverse") => {
                format!("\\operatorname{{{}}}\\left({list}\\right)", name.text)
            }
            (Style::Latex, "factorial") if arguments.len() == 1 => {
                arguments.iter().map(|of| format!("{}!", self.at_least(of, 5))).collect()
            }
            (Style::Latex, "binomial") if arguments.len() == 2 => {
                let parts: Vec<String> = arguments.iter().map(|part| format!("{{{}}}", self.expr(part))).collect();
                format!("\\binom{}", parts.concat())
            }
            (Style::Latex, "abs") => format!("\\left|{list}\\right|"),
            (Style::Latex, "floor") => format!("\\left\\lfloor {list}\\right\\rfloor"),
            (Style::Latex, "ceil") => format!("\\left\\lceil {list}\\right\\rceil"),
            (
                Style::Latex,
                "exp" | "ln" | "cosh" | "sinh" | "tanh" | "det" | "sin" | "cos" | "tan" | "arcsin" | "arccos"
                | "arctan" | "max" | "min",
            ) => {
                format!("\\{}\\left({list}\\right)", name.text)
            }
            (Style::Unicode, "sqrt") => match arguments {
                [one] if matches!(one.kind, ExprKind::Number(_) | ExprKind::Name(_)) => format!("√{list}"),
                _ => format!("√({list})"),
            },
            // Bars within bars are hard to read.
            (Style::Unicode, "abs") if !list.contains('|') => format!("|{list}|"),
            _ => self.member(&name.text, &list),
        }
    }

    /// A function with its arguments, or a member of a family. LaTeX has parentheses as well: `m(1)` is not
    /// the variable `m1`.
    fn member(self, name: &str, arguments: &str) -> String {
        match self {
            Style::Latex => format!("{}\\left({arguments}\\right)", self.name(name)),
            _ => format!("{}({arguments})", self.name(name)),
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
                // A chain of arrows in print would say more.
                let right = self.prop_at_least(b, if self == Style::Latex { 3 } else { 2 });
                format!("{} {} {right}", self.prop_at_least(a, 3), self.word("=>"))
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
            PropKind::Limit(l) => self.limit(&l.of, &l.variable, "", self.word("infinity"), self.expr(&l.value)),
            PropKind::WrittenLimit(l) => {
                let natural = if l.natural { "natural" } else { "" };
                let towards = match &l.towards {
                    Towards::Infinity => self.word("infinity"),
                    Towards::Point(point, None) => self.expr(point),
                    Towards::Point(point, Some(Sign::Plus)) => {
                        format!("{} {}", self.expr(point), self.word("from above"))
                    }
                    Towards::Point(point, Some(Sign::Minus)) => {
                        format!("{} {}", self.expr(point), self.word("from below"))
                    }
                };
                let value = match &l.value {
                    Tendency::Number(value) => self.expr(value),
                    Tendency::Infinite(Sign::Plus) => self.word("infinity"),
                    Tendency::Infinite(Sign::Minus) => format!("-{}", self.word("infinity")),
                    Tendency::Order { about, size } => {
                        let whole = [l.of.clone(), with_order(about.as_ref(), size)];
                        let whole =
                            Prop { kind: PropKind::Compare(whole.to_vec(), vec![Relation::Equal]), span: l.of.span };
                        let moving = self.moving(&l.variable, natural, towards);
                        return format!("{} {moving}", self.prop(&whole));
                    }
                };
                self.limit(&l.of, &l.variable, natural, towards, value)
            }
        }
    }

    fn limit(self, of: &Expr, variable: &Name, domain: &'static str, towards: String, value: String) -> String {
        let (limit, of, is) = (self.word("limit of"), self.expr(of), self.word("is"));
        format!("{limit} {of} {} {is} {value}", self.moving(variable, domain, towards))
    }

    /// `as x -> a`
    fn moving(self, variable: &Name, domain: &'static str, towards: String) -> String {
        let mut variable = self.name(&variable.text);
        if !domain.is_empty() {
            variable = format!("{variable} {}", self.word(domain));
        }
        format!("{} {variable} {} {towards}", self.word("as"), self.word("->"))
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
            .map(|(n, i)| match i {
                Some(i) => self.member(&n.text, &self.name(&i.text)),
                None => self.name(&n.text),
            })
            .collect();
        let mut out = names.join(", ");
        let range = b.constraints.iter().any(|c| matches!(c, Constraint::Range(..)));
        if b.natural && !range {
            out.push_str(&format!(" {}", self.word("natural")).replace("  ", " "));
        } else if b.constraints.is_empty() {
            out.push_str(&format!(" {}", self.word("real")).replace("  ", " "));
        }
        for (place, constraint) in b.constraints.iter().enumerate() {
            // Two conditions side by side would look like a chain.
            if place > 0 {
                out.push_str(&self.word(" and").replace("  ", " "));
            }
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
        if let Some(unit) = &b.unit {
            out.push_str(&match self {
                Style::Text => format!(" in {}", unit.text()),
                Style::Unicode => format!(" in {}", unit.printed()),
                Style::Latex => format!("\\text{{ in }}{}", unit.latex()),
            });
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
                    let next = self.member(&name.text, &format!("{k} + 1"));
                    format!("{} = {a}, \\quad {next} = {b}", self.member(&name.text, "0"))
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claim::parse::{parse, parse_expr, parse_prop};

    fn latex(text: &str) -> String {
        Style::Latex.expr(&parse_expr(text).expect("it parses"))
    }

    fn unicode(text: &str) -> String {
        Style::Unicode.expr(&parse_expr(text).expect("it parses"))
    }

    #[test]
    fn latex_shows_how_far_a_large_operator_reaches() {
        assert_eq!(latex("sum(i = 1..n, i^2)"), "\\sum_{i=1}^{n} i^{2}");
        assert_eq!(latex("sum(i = 1..n, i)^2"), "\\left(\\sum_{i=1}^{n} i\\right)^{2}");
        assert_eq!(latex("sum(i = 1..n, i*x)"), "\\sum_{i=1}^{n} i \\, x");
        assert_eq!(latex("product(i = 1..n, i)*x"), "\\left(\\prod_{i=1}^{n} i\\right) \\, x");
        assert_eq!(latex("(x*sum(i = 1..n, i))*y"), "{x \\, \\left(\\sum_{i=1}^{n} i\\right)} \\, y");
        assert_eq!(
            latex("derivative(x^2, x)^2"),
            "\\left(\\frac{\\partial}{\\partial x}\\left(x^{2}\\right)\\right)^{2}"
        );
        assert_eq!(latex("sum(i = 1..n, i + 1)"), "\\sum_{i=1}^{n} \\left(i + 1\\right)");
    }

    #[test]
    fn latex_keeps_factors_apart() {
        assert_eq!(latex("2*3*x"), "2 \\cdot 3 \\, x");
        assert_eq!(latex("a*b/c"), "\\frac{a \\, b}{c}");
        assert_eq!(latex("1e5^2"), "\\left(1\\mathrm{e}5\\right)^{2}");
        assert_ne!(latex("m1*m(1)"), latex("m1*m1"));
        assert_eq!(latex("x1_a"), "{x_{1}}_{a}");
    }

    #[test]
    fn a_root_takes_a_power_in_parentheses() {
        assert_eq!(unicode("sqrt(x)^2"), "(√x)^2");
        assert_eq!(unicode("sqrt(x^2)"), "√(x^2)");
        assert_eq!(unicode("sqrt(x)*y"), "√x·y");
        assert_eq!(unicode("abs(x - |y|)*2"), "abs(x − |y|)·2");
        assert_eq!(unicode("sqrt(sqrt(x))"), "√(√x)");
        assert_eq!(unicode("sqrt(m(k))"), "√(m(k))");
    }

    #[test]
    fn a_greek_letter_is_its_name() {
        let prop = parse_prop("μ1 + Δv > mu1*λ'").expect("it parses");
        assert_eq!(super::prop(&prop), "mu1 + Deltav > mu1*lambda'");
        assert_eq!(Style::Unicode.prop(&prop), "μ₁ + Deltav > μ₁·λ'");
    }

    #[test]
    fn an_index_is_printed_alike_with_and_without_an_underscore() {
        assert_eq!(unicode("m1*v_2^2"), "m₁·v₂^2");
        assert_eq!(unicode("v_mu + m1_2 + x_3"), "v_μ + m₁_2 + x₃");
    }

    #[test]
    fn names_that_look_like_something_else_are_refused() {
        let said = |names: &str| {
            let faults = parse(&format!("claim c \"t\"\ngiven {names} real\nprove 1 = 1")).err().unwrap_or_default();
            faults.iter().map(|f| f.message()).collect::<Vec<_>>().join("; ")
        };
        for (names, wanted) in [
            ("x₁2", "the name x₁2 mixes digits on the line with subscript digits"),
            ("é", "the name é contains the character 'é'"),
            ("Σ", "the name Σ contains the character 'Σ'"),
            ("x_", "the name x_ begins or ends with `_`, or has two in a row"),
            ("_x", "the name _x begins or ends with `_`, or has two in a row"),
            ("μ, mu", "the name mu is declared twice"),
            ("m1, m_1", "the names m1 and m_1 look the same in print"),
        ] {
            assert_eq!(said(names), wanted);
        }
        for names in ["x1, x_2, x', v_mu, mu1, λ2", "m1, m11, m_a1, m1_a"] {
            assert_eq!(said(names), "");
        }
    }
}
