//! floor and ceil, expanded when a claim is read.
//!
//! Contract: after [`write_out`] no floor is left. `floor(x)` becomes an integer k, written out as the difference of two natural
//! numbers, with the hypothesis k ≤ x < k + 1; `ceil(x)` becomes `-floor(-x)`. The claim says the same, since there is exactly
//! one such k for every x. So that this holds, x speaks of the claim's own variables alone, and has a value everywhere: what
//! divides, or takes a root, is refused.

use super::diagnostic::{Diagnostic, Fault};
use super::fresh::Fresh;
use super::matrix::{apply, at, numeral};
use super::preamble::{bound_in, declared};
use super::syntax::*;
use super::total::Values;
use super::walk;
use std::collections::BTreeSet;

/// The functions that are written out here.
const WORDS: [&str; 3] = ["floor", "ceil", "ceiling"];

/// The most different floors of a claim.
const FLOORS_LIMIT: usize = 20;

/// Whether this is a function that is written out here; it takes one argument.
pub(crate) fn is_function(name: &str) -> bool {
    WORDS.contains(&name)
}

struct Writer<'a> {
    /// The words that the claim gives another meaning.
    own: BTreeSet<String>,
    fresh: &'a mut Fresh,
    /// The names bound by quantifiers, sums and definitions.
    bound: BTreeSet<String>,
    /// What the items so far tell of names.
    values: Values,
    /// The expanded floors, with their names.
    floors: Vec<(Expr, Name)>,
    /// Declarations to insert before the current item.
    open: Vec<Item>,
    faults: &'a mut Vec<Diagnostic>,
}

/// Writes out every floor of a claim.
pub(super) fn write_out(claim: &mut Claim, fresh: &mut Fresh, faults: &mut Vec<Diagnostic>) {
    let mut names = BTreeSet::new();
    walk::expressions(claim, &mut |e| walk::names_in(e, &mut names));
    if !WORDS.iter().any(|word| names.contains(*word)) {
        return;
    }
    let own: BTreeSet<String> = claim.items.iter().flat_map(declared).map(|n| n.text.clone()).collect();
    let bound = bound_in(claim);
    let mut writer =
        Writer { own, fresh, bound, values: Values::default(), floors: Vec::new(), open: Vec::new(), faults };
    for mut item in std::mem::take(&mut claim.items) {
        walk::of_item(&mut item, &mut |e| writer.expr(e));
        writer.values.learn(&item);
        claim.items.append(&mut writer.open);
        claim.items.push(item);
    }
    walk::expressions(claim, &mut |e| writer.expr(e));
    claim.items.append(&mut writer.open);
}

impl Writer<'_> {
    fn fault(&mut self, message: &str, help: &str, span: Span) {
        let fault = Fault::Other { message: message.to_string(), help: Some(help.to_string()) };
        self.faults.push(Diagnostic::new(fault, span));
    }

    fn expr(&mut self, e: &mut Expr) {
        walk::parts_mut(e, &mut |part| self.expr(part));
        let span = e.span;
        let ExprKind::Apply(word, arguments) = &mut e.kind else { return };
        if !is_function(&word.text) || self.own.contains(&word.text) || self.bound.contains(&word.text) {
            return;
        }
        let Some(of) = arguments.pop() else { return };
        let minus = |e: Expr| at(span, ExprKind::Negate(Box::new(e)));
        *e = match word.text.as_str() {
            "floor" => self.floor(of, span),
            _ => minus(self.floor(minus(of), span)),
        };
    }

    fn floor(&mut self, of: Expr, span: Span) -> Expr {
        let name = |name: &Name| at(span, ExprKind::Name(name.text.clone()));
        if let Some((_, known)) = self.floors.iter().find(|f| f.0 == of) {
            return name(known);
        }
        let mut inside = BTreeSet::new();
        walk::names_in(&of, &mut inside);
        if let Some(bound) = inside.intersection(&self.bound).next() {
            let help = "declare the floor as a variable: `k integer` and `k <= x < k + 1`";
            self.fault(&format!("this floor depends on the bound variable {bound}"), help, span);
            return of;
        }
        if !self.values.exist_for(&of) {
            let help = "say before it that the divisor is positive, as in `given b > 0`; or give the quotient or root a name: \
                        `given q real` with `assume q*m = a`, and write floor(q)";
            self.fault("the argument of a floor must have a value everywhere", help, span);
            return of;
        }
        if self.floors.len() >= FLOORS_LIMIT {
            self.faults.push(Diagnostic::new(Fault::Limit { name: "floors of a claim", allowed: FLOORS_LIMIT }, span));
            return of;
        }
        let mut fresh = |text: String| Name { text: self.fresh.name(&text), span };
        let floor = fresh(format!("floor_{}", self.floors.len() + 1));
        let (up, down) = (fresh(format!("{}_up", floor.text)), fresh(format!("{}_down", floor.text)));
        self.fresh.means(&floor.text, apply(span, "floor", of.clone()));
        let sum = |a: Expr, sign: Sign, b: Expr| at(span, ExprKind::Sum(vec![(Sign::Plus, a), (sign, b)]));
        let names = vec![(up.clone(), None), (down.clone(), None)];
        self.open.push(Item::Given(vec![Binding::new(names, true, Vec::new(), span)]));
        let value = sum(name(&up), Sign::Minus, name(&down));
        self.open.push(Item::Let { name: floor.clone(), parameters: Vec::new(), value });
        let sides = vec![name(&floor), of.clone(), sum(name(&floor), Sign::Plus, numeral(span, 1))];
        let kind = PropKind::Compare(sides, vec![Relation::LessEqual, Relation::Less]);
        self.open.push(Item::Assume { label: None, prop: Prop { kind, span } });
        let out = name(&floor);
        self.floors.push((of, floor));
        out
    }
}

#[cfg(test)]
mod tests {
    use crate::claim::parse::parse;
    use crate::claim::print::{Style, statement_as_read};

    #[test]
    fn a_floor_is_an_integer_next_below() {
        let claims = parse("claim c \"t\"\ngiven x real\nassume floor(x) > 2\nprove ceil(x/2) >= floor(x) - 3\n");
        let lines = statement_as_read(&claims.expect("it parses")[0], Style::Text);
        assert_eq!(
            lines,
            [
                "given x real",
                "given floor_1_up, floor_1_down natural",
                "let floor_1 = floor_1_up - floor_1_down",
                "assume floor_1 <= x < floor_1 + 1",
                "assume floor_1 > 2",
                "given floor_2_up, floor_2_down natural",
                "let floor_2 = floor_2_up - floor_2_down",
                "assume floor_2 <= -x/2 < floor_2 + 1",
                "prove -floor_2 >= floor_1 - 3",
            ]
        );
    }

    #[test]
    fn what_moves_or_may_have_no_value_is_refused() {
        let fault = |goal: &str| {
            let source = format!("claim c \"t\"\ngiven x real; n natural\nlet w = 1/x\nprove {goal}\n");
            parse(&source).expect_err("refused")[0].message()
        };
        assert_eq!(fault("sum(i = 0..n, floor(x*i)) = x"), "this floor depends on the bound variable i");
        assert_eq!(fault("for all t real: floor(t) <= t"), "this floor depends on the bound variable t");
        assert_eq!(fault("floor(1/x) = x"), "the argument of a floor must have a value everywhere");
        assert_eq!(fault("floor(sqrt(x)) = x"), "the argument of a floor must have a value everywhere");
        assert_eq!(fault("floor(w) = x"), "the argument of a floor must have a value everywhere");
    }
}
