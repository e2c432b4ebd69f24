//! Propositions as text by which they are compared: bound names are numbered, so that two propositions that differ
//! only in bound names (and in places) have the same key, and no others do.
//!
//! Every compound operand stands in parentheses. A bound name is written `#k`, where k counts the binders around it. A free name
//! that no text can say stands in quotation marks, and so does a numeral: it looks like nothing else, whatever its characters.

use super::text::relation;
use super::well_formed::{is_name, is_numeral};
use crate::claim::syntax::*;

/// The key of a proposition.
pub fn prop(p: &Prop) -> String {
    let mut printer = Printer { out: String::new(), bound: Vec::new() };
    printer.prop(p);
    printer.out
}

/// The key of an expression.
pub fn expr(e: &Expr) -> String {
    let mut printer = Printer { out: String::new(), bound: Vec::new() };
    printer.expr(e);
    printer.out
}

struct Printer<'a> {
    out: String,
    /// The names that are bound here, outermost first.
    bound: Vec<&'a str>,
}

impl<'a> Printer<'a> {
    fn put(&mut self, text: &str) {
        self.out.push_str(text);
    }

    fn name(&mut self, name: &str) {
        match self.bound.iter().rposition(|b| *b == name) {
            Some(place) => self.out.push_str(&format!("#{place}")),
            None if is_name(name) => self.out.push_str(name),
            None => self.out.push_str(&format!("{name:?}")),
        }
    }

    fn list<T>(&mut self, items: &'a [T], between: &str, mut each: impl FnMut(&mut Self, &'a T)) {
        for (place, item) in items.iter().enumerate() {
            if place > 0 {
                self.put(between);
            }
            each(self, item);
        }
    }

    fn expr(&mut self, e: &'a Expr) {
        match &e.kind {
            ExprKind::Number(text) if is_numeral(text) => self.put(text),
            ExprKind::Number(text) => self.put(&format!("numeral {text:?}")),
            ExprKind::Name(text) => self.name(text),
            ExprKind::Apply(f, arguments) => {
                self.name(&f.text);
                self.put("(");
                self.list(arguments, ", ", Self::expr);
                self.put(")");
            }
            ExprKind::Negate(a) => {
                self.put("(-");
                self.expr(a);
                self.put(")");
            }
            ExprKind::Sum(terms) => {
                self.put("(");
                for (place, (sign, term)) in terms.iter().enumerate() {
                    match (place, sign) {
                        (0, Sign::Plus) => {}
                        (_, Sign::Plus) => self.put(" + "),
                        (_, Sign::Minus) => self.put(" - "),
                    }
                    self.expr(term);
                }
                self.put(")");
            }
            ExprKind::Product(factors) => {
                self.put("(");
                for (place, (factor, e)) in factors.iter().enumerate() {
                    match (place, factor) {
                        (0, Factor::Times) => {}
                        (_, Factor::Times) => self.put("*"),
                        (_, Factor::Over) => self.put("/"),
                    }
                    self.expr(e);
                }
                self.put(")");
            }
            ExprKind::Power(a, b) => {
                self.put("(");
                self.expr(a);
                self.put("^");
                self.expr(b);
                self.put(")");
            }
            ExprKind::SumOver(index, body)
            | ExprKind::ProductOver(index, body)
            | ExprKind::IntegralOver(index, body) => {
                self.put(match e.kind {
                    ExprKind::SumOver(..) => "sum(",
                    ExprKind::ProductOver(..) => "product(",
                    _ => "integral(",
                });
                self.expr(&index.from);
                self.put("..");
                self.expr(&index.to);
                self.put(", ");
                self.bound.push(&index.name.text);
                self.expr(body);
                self.bound.pop();
                self.put(")");
            }
            ExprKind::Derivative(body, by) => {
                self.put("derivative(");
                self.expr(body);
                for name in by {
                    self.put(", ");
                    self.name(&name.text);
                }
                self.put(")");
            }
            ExprKind::Matrix(rows) => {
                self.put("[");
                self.list(rows, "; ", |p, row| p.list(row, ", ", Self::expr));
                self.put("]");
            }
        }
    }

    fn prop(&mut self, p: &'a Prop) {
        self.put("(");
        match &p.kind {
            PropKind::Compare(sides, relations) => {
                let mut relations = relations.iter();
                for (place, side) in sides.iter().enumerate() {
                    if place > 0 {
                        self.put(" ");
                        self.put(relations.next().map_or("?", |r| relation(*r)));
                        self.put(" ");
                    }
                    self.expr(side);
                }
                // There is none left, unless no text can say this comparison.
                for r in relations {
                    self.put(" ");
                    self.put(relation(*r));
                }
            }
            PropKind::And(parts) => self.list(parts, " and ", Self::prop),
            PropKind::Or(parts) => self.list(parts, " or ", Self::prop),
            PropKind::Equivalent(parts) => self.list(parts, " <=> ", Self::prop),
            PropKind::Not(inner) => {
                self.put("not ");
                self.prop(inner);
            }
            PropKind::Implies(a, b) => {
                self.prop(a);
                self.put(" => ");
                self.prop(b);
            }
            PropKind::Exists(bindings, body) | PropKind::ForAll(bindings, body) => {
                self.put(if matches!(p.kind, PropKind::Exists(..)) { "exists " } else { "for all " });
                let outside = self.bound.len();
                self.bindings(bindings);
                self.put(": ");
                self.prop(body);
                self.bound.truncate(outside);
            }
            PropKind::Extremum(e) => {
                self.put(if e.maximum { "maximum " } else { "minimum " });
                self.put(if e.unique { "only at " } else { "at " });
                // The point and the value stand outside the scope of the bound names.
                for (_, value) in &e.at {
                    self.expr(value);
                    self.put(", ");
                }
                self.expr(&e.value);
                // The order of the point's values is that of its names, which are bound below.
                let outside = self.bound.len();
                self.put(" over ");
                self.bindings(&e.over);
                for (name, _) in &e.at {
                    self.put(" ");
                    self.name(&name.text);
                }
                self.put(" of ");
                self.expr(&e.of);
                self.bound.truncate(outside);
            }
            PropKind::Limit(l) => {
                self.put("limit ");
                self.expr(&l.value);
                // Which kind of variable moves is said by its declaration.
                self.put(" as ");
                self.name(&l.variable.text);
                self.put(" of ");
                self.expr(&l.of);
            }
            // No statement and no step of a certificate holds one.
            PropKind::WrittenLimit(_) => self.put("limit as written"),
        }
        self.put(")");
    }

    /// Bindings; their names are bound from here on, also in the constraints of later ones.
    fn bindings(&mut self, bindings: &'a [Binding]) {
        for (place, b) in bindings.iter().enumerate() {
            self.put(if place > 0 { "; " } else { "" });
            let outside = self.bound.len();
            for (name, index) in &b.names {
                self.bound.push(&name.text);
                self.put(if index.is_some() { "family " } else { "number " });
            }
            let inside = self.bound.len();
            self.bound.extend(b.names.iter().filter_map(|n| n.1.as_ref()).map(|index| index.text.as_str()));
            self.put(&format!("#{outside}{}", if b.natural { " natural" } else { " real" }));
            for constraint in &b.constraints {
                match constraint {
                    Constraint::Relation(r, e) => {
                        self.put(&format!(" {} ", relation(*r)));
                        self.expr(e);
                    }
                    Constraint::Interval { from, from_closed, to, to_closed } => {
                        self.put(if *from_closed { " in [" } else { " in (" });
                        self.expr(from);
                        self.put(", ");
                        self.expr(to);
                        self.put(if *to_closed { "]" } else { ")" });
                    }
                    Constraint::Range(a, b) => {
                        self.put(" in ");
                        self.expr(a);
                        self.put("..");
                        self.expr(b);
                    }
                }
            }
            if let Some((a, b)) = &b.indices {
                self.put(" for indices in ");
                self.expr(a);
                self.put("..");
                self.expr(b);
            }
            self.bound.truncate(inside);
        }
    }
}
