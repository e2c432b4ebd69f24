//! Statements as text with every operand in parentheses: what the kernel understood, and the key by
//! which it compares. Two trees have the same text iff they differ in places at most.

use crate::claim::syntax::*;

fn list<T>(items: &[T], between: &str, text: impl Fn(&T) -> String) -> String {
    items.iter().map(text).collect::<Vec<_>>().join(between)
}

/// An expression; what is compound stands in parentheses.
pub fn expr(e: &Expr) -> String {
    match &e.kind {
        ExprKind::Number(text) | ExprKind::Name(text) => text.clone(),
        ExprKind::Apply(name, arguments) => format!("{}({})", name.text, list(arguments, ", ", expr)),
        ExprKind::Negate(a) => format!("(-{})", expr(a)),
        ExprKind::Sum(terms) => {
            let parts = terms.iter().enumerate().map(|(place, (sign, e))| match (place, sign) {
                (0, Sign::Plus) => expr(e),
                (_, Sign::Plus) => format!(" + {}", expr(e)),
                (_, Sign::Minus) => format!(" - {}", expr(e)),
            });
            format!("({})", parts.collect::<String>())
        }
        ExprKind::Product(factors) => {
            let parts = factors.iter().enumerate().map(|(place, (factor, e))| match (place, factor) {
                (0, Factor::Times) => expr(e),
                (_, Factor::Times) => format!("*{}", expr(e)),
                (_, Factor::Over) => format!("/{}", expr(e)),
            });
            format!("({})", parts.collect::<String>())
        }
        ExprKind::Power(a, b) => format!("({}^{})", expr(a), expr(b)),
        ExprKind::SumOver(i, body) => format!("sum({}, {})", index(i), expr(body)),
        ExprKind::ProductOver(i, body) => format!("product({}, {})", index(i), expr(body)),
        ExprKind::IntegralOver(x, body) => format!("integral({}, {})", index(x), expr(body)),
        ExprKind::Derivative(body, by) => {
            format!("derivative({}, {})", expr(body), list(by, ", ", |n| n.text.clone()))
        }
        ExprKind::Matrix(rows) => format!("[{}]", list(rows, "; ", |row| list(row, ", ", expr))),
    }
}

fn index(i: &Index) -> String {
    format!("{} = {}..{}", i.name.text, expr(&i.from), expr(&i.to))
}

/// A relation.
pub fn relation(r: Relation) -> &'static str {
    match r {
        Relation::Equal => "=",
        Relation::NotEqual => "!=",
        Relation::Less => "<",
        Relation::LessEqual => "<=",
        Relation::Greater => ">",
        Relation::GreaterEqual => ">=",
    }
}

/// A proposition; what is compound stands in parentheses.
pub fn prop(p: &Prop) -> String {
    match &p.kind {
        PropKind::Compare(sides, relations) => {
            let mut out = sides.first().map_or(String::new(), expr);
            for (r, side) in relations.iter().zip(sides.iter().skip(1)) {
                out.push_str(&format!(" {} {}", relation(*r), expr(side)));
            }
            format!("({out})")
        }
        PropKind::And(parts) => format!("({})", list(parts, " and ", prop)),
        PropKind::Or(parts) => format!("({})", list(parts, " or ", prop)),
        PropKind::Not(inner) => format!("(not {})", prop(inner)),
        PropKind::Implies(a, b) => format!("({} => {})", prop(a), prop(b)),
        PropKind::Equivalent(parts) => format!("({})", list(parts, " <=> ", prop)),
        PropKind::Exists(bindings, body) => format!("(exists {}: {})", list(bindings, "; ", binding), prop(body)),
        PropKind::ForAll(bindings, body) => format!("(for all {}: {})", list(bindings, "; ", binding), prop(body)),
        PropKind::Extremum(e) => format!(
            "({} of {} over {} {}at {} is {})",
            if e.maximum { "maximum" } else { "minimum" },
            expr(&e.of),
            list(&e.over, "; ", binding),
            if e.unique { "only " } else { "" },
            list(&e.at, ", ", |(n, v)| format!("{} = {}", n.text, expr(v))),
            expr(&e.value)
        ),
        // No statement and no step of a certificate holds one.
        PropKind::WrittenLimit(_) => "(limit as written)".to_string(),
        PropKind::Limit(l) => {
            format!("(limit of {} as {} -> infinity is {})", expr(&l.of), l.variable.text, expr(&l.value))
        }
    }
}

/// A binding.
pub fn binding(b: &Binding) -> String {
    let names = list(&b.names, ", ", |(name, index)| match index {
        Some(index) => format!("{}({})", name.text, index.text),
        None => name.text.clone(),
    });
    let mut out = format!("{names}{}", if b.natural { " natural" } else { " real" });
    for constraint in &b.constraints {
        out += &match constraint {
            Constraint::Relation(r, e) => format!(" {} {}", relation(*r), expr(e)),
            Constraint::Interval { from, from_closed, to, to_closed } => {
                let open = if *from_closed { '[' } else { '(' };
                let close = if *to_closed { ']' } else { ')' };
                format!(" in {open}{}, {}{close}", expr(from), expr(to))
            }
            Constraint::Range(a, b) => format!(" in {}..{}", expr(a), expr(b)),
        };
    }
    if let Some((a, b)) = &b.indices {
        out += &format!(" for indices in {}..{}", expr(a), expr(b));
    }
    out
}
