//! Statements as MathML, which browsers typeset without scripts or fonts of ours.
//!
//! Contract: the result is a `<math>` element whose text is escaped; parentheses stand where precedence needs
//! them, fractions and roots group by themselves.

use super::markup::escape;
use crate::claim::print::{Style, level, prop_level, reaches};
use crate::claim::syntax::*;
use pulldown_latex::config::DisplayMode;
use pulldown_latex::{Parser, ParserError, RenderConfig, Storage, push_mathml};

/// A proposition on a line of its own.
pub fn statement(p: &Prop) -> String {
    math(&prop(p))
}

/// An expression on a line of its own.
pub fn expression(e: &Expr) -> String {
    math(&expr(e))
}

/// A proposition within a sentence.
pub fn within(p: &Prop) -> String {
    format!("<math>{}</math>", prop(p))
}

/// An expression within a sentence.
pub fn expression_within(e: &Expr) -> String {
    format!("<math>{}</math>", expr(e))
}

/// A hypothesis or definition.
pub fn item(item: &Item) -> String {
    math(&match item {
        Item::Given(bindings) => self::bindings(bindings),
        Item::Let { name, parameters, value } => {
            let head = if parameters.is_empty() {
                identifier(&name.text)
            } else {
                let list: Vec<String> = parameters.iter().map(|p| identifier(&p.text)).collect();
                row(&[identifier(&name.text), fenced(&list.join(&operator(",")))])
            };
            row(&[head, operator("="), expr(value)])
        }
        Item::Define { name, initial, index, step, .. } => {
            let member = |at: String| format!("<msub>{}{at}</msub>", identifier(&name.text));
            let next = row(&[identifier(&index.text), operator("+"), number("1")]);
            row(&[
                member(number("0")),
                operator("="),
                expr(initial),
                operator(","),
                member(next),
                operator("="),
                expr(step),
            ])
        }
        Item::Assume { prop: p, .. } => prop(p),
    })
}

fn math(inner: &str) -> String {
    format!("<math display=\"block\">{inner}</math>")
}

fn row(parts: &[String]) -> String {
    format!("<mrow>{}</mrow>", parts.concat())
}

fn operator(sign: &str) -> String {
    format!("<mo>{}</mo>", escape(sign))
}

fn number(text: &str) -> String {
    format!("<mn>{}</mn>", escape(text))
}

fn word(text: &str) -> String {
    format!("<mtext>&#160;{}&#160;</mtext>", escape(text))
}

fn fenced(inner: &str) -> String {
    format!("<mrow><mo>(</mo>{inner}<mo>)</mo></mrow>")
}

/// A name: Greek letters by their signs, digits and what follows `_` as an index.
fn identifier(name: &str) -> String {
    if let Some((head, tail)) = name.split_once('_') {
        // One index, however many parts it has: an index of an index is too small to read.
        let parts: Vec<String> = tail.split('_').map(identifier).collect();
        let index = match parts.as_slice() {
            [only] => only.clone(),
            _ => format!("<mrow>{}</mrow>", parts.join("<mtext>&#160;</mtext>")),
        };
        return format!("<msub>{}{index}</msub>", identifier(head));
    }
    let letters = name.trim_end_matches(|c: char| c.is_ascii_digit());
    let digits = &name[letters.len()..];
    let sign = escape(&Style::Unicode.name(letters));
    match digits {
        _ if letters.is_empty() => number(name),
        "" => format!("<mi>{sign}</mi>"),
        _ => format!("<msub><mi>{sign}</mi>{}</msub>", number(digits)),
    }
}

fn at_least(e: &Expr, least: u8) -> String {
    // A fraction groups by itself.
    let fraction = matches!(&e.kind, ExprKind::Product(list) if list.iter().any(|f| f.0 == Factor::Over));
    // A large operator would reach over the factors behind it.
    let level = if reaches(e) { 3 } else { level(e) };
    if level >= least || fraction && least <= 4 { expr(e) } else { fenced(&expr(e)) }
}

fn expr(e: &Expr) -> String {
    match &e.kind {
        ExprKind::Number(text) => number(text),
        ExprKind::Name(name) => identifier(name),
        ExprKind::Apply(name, arguments) => apply(name, arguments),
        ExprKind::Negate(a) => row(&[operator("−"), at_least(a, 2)]),
        ExprKind::Sum(list) => {
            let mut parts = Vec::new();
            for (i, (sign, summand)) in list.iter().enumerate() {
                if i > 0 {
                    parts.push(operator(if *sign == Sign::Plus { "+" } else { "−" }));
                }
                parts.push(at_least(summand, if i == 0 { 2 } else { 3 }));
            }
            row(&parts)
        }
        ExprKind::Product(list) => {
            let side = |wanted: Factor| -> Vec<&Expr> { list.iter().filter(|p| p.0 == wanted).map(|p| &p.1).collect() };
            let joined = |list: &[&Expr]| match list {
                [one] => expr(one),
                _ => row(&[list.iter().map(|e| at_least(e, 4)).collect::<Vec<_>>().join(&operator("·"))]),
            };
            let (above, below) = (side(Factor::Times), side(Factor::Over));
            if below.is_empty() {
                joined(&above)
            } else {
                format!("<mfrac>{}{}</mfrac>", joined(&above), joined(&below))
            }
        }
        ExprKind::Power(base, exponent) => {
            let base = match &base.kind {
                // An indexed name takes its power beside the index.
                ExprKind::Number(_) | ExprKind::Name(_) => expr(base),
                _ => fenced(&expr(base)),
            };
            format!("<msup>{base}{}</msup>", raised(exponent))
        }
        ExprKind::SumOver(index, body) => over("∑", index, body),
        ExprKind::ProductOver(index, body) => over("∏", index, body),
        ExprKind::IntegralOver(x, body) => row(&[
            format!("<msubsup>{}{}{}</msubsup>", operator("∫"), expr(&x.from), expr(&x.to)),
            at_least(body, 3),
            operator("d"),
            identifier(&x.name.text),
        ]),
        ExprKind::Derivative(body, by) => {
            let up = match by.len() {
                1 => operator("∂"),
                order => format!("<msup>{}{}</msup>", operator("∂"), number(&order.to_string())),
            };
            let down: Vec<String> = by.iter().map(|n| row(&[operator("∂"), identifier(&n.text)])).collect();
            row(&[format!("<mfrac>{up}{}</mfrac>", row(&down)), fenced(&expr(body))])
        }
        ExprKind::Matrix(rows) => {
            let cells = |r: &Vec<Expr>| r.iter().map(|e| format!("<mtd>{}</mtd>", expr(e))).collect::<String>();
            let rows: String = rows.iter().map(|r| format!("<mtr>{}</mtr>", cells(r))).collect();
            fenced(&format!("<mtable>{rows}</mtable>"))
        }
    }
}

/// An exponent. A quotient is written on one line, because a fraction would push the lines apart.
fn raised(e: &Expr) -> String {
    match &e.kind {
        ExprKind::Product(list) => match list.as_slice() {
            [(Factor::Times, above), (Factor::Over, below)] => {
                row(&[at_least(above, 4), operator("/"), at_least(below, 4)])
            }
            _ => expr(e),
        },
        _ => expr(e),
    }
}

fn over(sign: &str, index: &Index, body: &Expr) -> String {
    let below = row(&[identifier(&index.name.text), operator("="), expr(&index.from)]);
    let large = format!("<munderover>{}{below}{}</munderover>", operator(sign), expr(&index.to));
    row(&[large, at_least(body, 3)])
}

fn apply(name: &Name, arguments: &[Expr]) -> String {
    let list: Vec<String> = arguments.iter().map(expr).collect();
    let list = list.join(&operator(","));
    match name.text.as_str() {
        "sqrt" => format!("<msqrt>{list}</msqrt>"),
        "abs" => format!("<mrow><mo>|</mo>{list}<mo>|</mo></mrow>"),
        "cbrt" => format!("<mroot>{}{}</mroot>", row(&[list]), number("3")),
        "exp" | "ln" | "arcsin" | "arccos" | "arctan" | "cosh" | "sinh" | "tanh" | "sech" | "det" | "transpose" => {
            row(&[format!("<mi>{}</mi>", escape(&name.text)), fenced(&list)])
        }
        _ => row(&[identifier(&name.text), fenced(&list)]),
    }
}

fn prop_at_least(p: &Prop, least: u8) -> String {
    if prop_level(p) >= least { prop(p) } else { fenced(&prop(p)) }
}

fn prop(p: &Prop) -> String {
    let listed = |list: &[Prop], between: String, least: u8| {
        list.iter().map(|q| prop_at_least(q, least)).collect::<Vec<_>>().join(&between)
    };
    match &p.kind {
        PropKind::Compare(sides, relations) => {
            let mut parts = vec![sides.first().map(expr).unwrap_or_default()];
            for (relation, side) in relations.iter().zip(sides.iter().skip(1)) {
                parts.push(operator(Style::Unicode.relation(*relation)));
                parts.push(expr(side));
            }
            row(&parts)
        }
        PropKind::And(list) => listed(list, word("and"), 5),
        PropKind::Or(list) => listed(list, word("or"), 4),
        PropKind::Not(q) => row(&[word("not"), prop_at_least(q, 5)]),
        PropKind::Implies(a, b) => row(&[prop_at_least(a, 3), operator("⇒"), prop_at_least(b, 2)]),
        PropKind::Equivalent(list) => listed(list, operator("⇔"), 2),
        PropKind::Exists(bindings, body) => row(&[operator("∃"), self::bindings(bindings), operator(":"), prop(body)]),
        PropKind::ForAll(bindings, body) => row(&[operator("∀"), self::bindings(bindings), operator(":"), prop(body)]),
        PropKind::Extremum(x) => {
            let over = row(&[bindings(&x.over)]);
            let large = format!("<munder><mi>{}</mi>{over}</munder>", if x.maximum { "max" } else { "min" });
            let at: Vec<String> =
                x.at.iter().map(|(n, e)| row(&[identifier(&n.text), operator("="), expr(e)])).collect();
            let only = word(if x.unique { "only at" } else { "at" });
            row(&[large, at_least(&x.of, 3), operator("="), expr(&x.value), only, at.join(&operator(","))])
        }
        PropKind::Limit(l) => limit(&l.of, &l.variable, operator("∞"), expr(&l.value)),
        PropKind::WrittenLimit(l) => {
            let towards = match &l.towards {
                Towards::Infinity => operator("∞"),
                Towards::Point(point, None) => expr(point),
                Towards::Point(point, Some(side)) => {
                    let sign = operator(if *side == Sign::Plus { "+" } else { "−" });
                    format!("<msup>{}{sign}</msup>", row(&[expr(point)]))
                }
            };
            let value = match &l.value {
                Tendency::Number(value) => expr(value),
                Tendency::Infinite(Sign::Plus) => operator("∞"),
                Tendency::Infinite(Sign::Minus) => row(&[operator("−"), operator("∞")]),
                Tendency::Order { about, size } => {
                    let right = at_least(&with_order(about.as_ref(), size), 3);
                    let to = [word("as"), identifier(&l.variable.text), operator("→"), towards];
                    return row(&[at_least(&l.of, 3), operator("="), right, to.concat()]);
                }
            };
            limit(&l.of, &l.variable, towards, value)
        }
    }
}

fn limit(of: &Expr, variable: &Name, towards: String, value: String) -> String {
    let to = row(&[identifier(&variable.text), operator("→"), towards]);
    row(&[format!("<munder><mi>lim</mi>{to}</munder>"), at_least(of, 3), operator("="), value])
}

fn bindings(list: &[Binding]) -> String {
    list.iter().map(binding).collect::<Vec<_>>().join(&operator(";"))
}

fn binding(b: &Binding) -> String {
    let names: Vec<String> = b
        .names
        .iter()
        .map(|(n, i)| match i {
            Some(i) => row(&[identifier(&n.text), fenced(&identifier(&i.text))]),
            None => identifier(&n.text),
        })
        .collect();
    let mut parts = vec![names.join(&operator(","))];
    let range = b.constraints.iter().any(|c| matches!(c, Constraint::Range(..)));
    if b.natural && !range {
        parts.push(row(&[operator("∈"), "<mi>ℕ</mi>".to_string()]));
    } else if b.constraints.is_empty() {
        parts.push(row(&[operator("∈"), "<mi>ℝ</mi>".to_string()]));
    }
    for constraint in &b.constraints {
        parts.push(match constraint {
            Constraint::Relation(r, e) => row(&[operator(Style::Unicode.relation(*r)), expr(e)]),
            Constraint::Interval { from, from_closed, to, to_closed } => row(&[
                operator("∈"),
                operator(if *from_closed { "[" } else { "(" }),
                expr(from),
                operator(","),
                expr(to),
                operator(if *to_closed { "]" } else { ")" }),
            ]),
            Constraint::Range(a, b) => row(&[operator("∈"), expr(a), operator("…"), expr(b)]),
        });
    }
    if let (Some((a, to)), Some((_, Some(index)))) = (&b.indices, b.names.first()) {
        parts.push(word("for"));
        parts.push(row(&[identifier(&index.text), operator("∈"), expr(a), operator("…"), expr(to)]));
    }
    if let Some(unit) = &b.unit {
        parts.push(word("in"));
        parts.push(format!("<mtext>{}</mtext>", escape(&unit.printed())));
    }
    row(&parts)
}

/// A paper's own LaTeX; nothing if a part of it is not known.
pub fn typeset(latex: &str) -> Option<String> {
    let storage = Storage::new();
    let events = Parser::new(latex, &storage).collect::<Result<Vec<_>, _>>().ok()?;
    let mut out = String::new();
    let config = RenderConfig { display_mode: DisplayMode::Block, ..RenderConfig::default() };
    push_mathml(&mut out, events.into_iter().map(Ok::<_, ParserError>), config).ok()?;
    // The crate escapes texts, and leaves these two signs as they are.
    Some(out.replace("<mo><</mo>", "<mo>&lt;</mo>").replace("<mo>></mo>", "<mo>&gt;</mo>"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claim::parse::parse_prop;

    #[test]
    fn a_paper_brings_markup_into_the_page() {
        let said = typeset(r"a < b \text{ if <script>} c > d").unwrap_or_default();
        assert!(
            said.contains("<mo>&lt;</mo>") && said.contains("<mo>&gt;</mo>") && !said.contains("<script>"),
            "{said}"
        );
        assert_eq!(typeset(r"\unknown x"), None);
        assert!(
            typeset(r"\begin{aligned} a &= b \\ &= c \end{aligned}")
                .is_some_and(|said| said.matches("<mtr>").count() == 2)
        );
    }

    fn shown(text: &str) -> String {
        statement(&parse_prop(text).expect("it parses"))
    }

    #[test]
    fn fractions_roots_and_powers_have_their_elements() {
        let text = shown("(m1 + m2)^2/sqrt(mu) >= eta_2 - 1");
        for part in ["<mfrac>", "<msqrt><mi>μ</mi></msqrt>", "<msup><mrow><mo>(</mo>", "<mo>≥</mo>", "<mi>η</mi>"] {
            assert!(text.contains(part), "{part} in {text}");
        }
        assert!(shown("|a - b| = 1").contains("<mrow><mo>|</mo><mrow><mi>a</mi>"), "{}", shown("|a - b| = 1"));
        assert!(!shown("a*(b/c) = 1").contains("<mo>(</mo><mfrac>"));
        assert!(shown("a*(b + c) = 1").contains("<mo>(</mo>"));
        assert!(shown("a^(1/(n + 1)) = 1").contains("<mn>1</mn><mo>/</mo><mrow><mo>(</mo>"));
    }

    #[test]
    fn an_index_has_an_index_of_its_own() {
        let text = shown("cos_theta_over_2 = m_1");
        let index = "<mrow><mi>θ</mi><mtext>&#160;</mtext><mi>over</mi><mtext>&#160;</mtext><mn>2</mn></mrow>";
        assert!(text.contains(&format!("<msub><mi>cos</mi>{index}</msub>")), "{text}");
        assert!(text.contains("<msub><mi>m</mi><mn>1</mn></msub>"), "{text}");
    }

    #[test]
    fn a_large_operator_reaches_no_further_than_it_should() {
        for text in ["product(i = 1..n, i)*x = 1", "derivative(x^2, x)*x = 1", "x*sum(i = 1..n, i) = 1"] {
            assert!(shown(text).contains("<mo>(</mo><mrow><m"), "{text}: {}", shown(text));
        }
        assert!(shown("sum(i = 1..n, i)^2 = 1").contains("<msup><mrow><mo>(</mo><mrow><munderover>"));
        assert!(!shown("sum(i = 1..n, i*x) = 1").contains("<mo>(</mo>"));
    }

    #[test]
    fn nothing_in_a_name_or_number_is_markup() {
        assert_eq!(escape("<b>&\"'"), "&lt;b&gt;&amp;&quot;&#39;");
        assert!(shown("1 < 2").contains("<mo>&lt;</mo>"));
    }
}
