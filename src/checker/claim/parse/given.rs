//! `given`: declarations, relations between variables, integers, and the variables of limits.

use super::super::walk;
use super::*;

impl Parser {
    /// `m1, m2 > 0; 0 < a < b; k integer`: a relation declares the names in it that are new, and is a hypothesis.
    pub(super) fn given(&mut self) -> Parsed<Vec<Item>> {
        let mut out = Vec::new();
        loop {
            if self.begins_relation()? {
                self.related(&mut out)?;
            } else {
                let binding = self.binding()?;
                if let Some(span) = self.whole.take() {
                    self.integers(binding, span, &mut out)?;
                } else {
                    self.declared.extend(binding.names.iter().map(|n| n.0.text.clone()));
                    declare(binding, &mut out);
                }
            }
            if !(self.sign(";") || self.sign(",")) || self.at_clause() {
                return Ok(out);
            }
        }
    }

    /// Whether a comparison of expressions begins here, and not the name that a domain belongs to.
    fn begins_relation(&mut self) -> Parsed<bool> {
        let plain = match (self.peek(), self.peek_at(1)) {
            // A keyword in the place of a name.
            (Kind::Word(name), _) if RESERVED.contains(&name.as_str()) => return Ok(false),
            (Kind::Word(name), Kind::Sign("(")) => {
                // `abs(k) > 0` with a new name k declares a family, as it does for every other name.
                let is_family = match (self.peek_at(2), self.peek_at(3)) {
                    (Kind::Word(index), Kind::Sign(")")) => !self.declared.contains(index),
                    _ => false,
                };
                let is_function = is_built_in(name);
                let is_written_out =
                    super::super::abbreviation::is_one(name) || super::super::trigonometry::is_function(name);
                let is_abbreviation = is_written_out && !is_family;
                return Ok(is_function || self.declared.contains(name) || is_abbreviation);
            }
            (Kind::Word(_), Kind::Raised(_) | Kind::Sign("+" | "-" | "*" | "/" | "^" | "!")) => return Ok(true),
            (Kind::Word(_), Kind::Sign("<" | "<=" | ">" | ">=" | "=" | "!=")) => self.at,
            (Kind::Word(_), _) => return Ok(false),
            _ => return Ok(true),
        };
        // `a > b > 0` is a chain; `a > 0` gives a its domain, or says more of it where it has one.
        let is_new = !matches!(self.peek(), Kind::Word(name) if self.declared.contains(name));
        match self.relations_from(plain).as_slice() {
            [_] => Ok(!is_new),
            list if list.iter().all(|r| matches!(r, Relation::Less | Relation::LessEqual)) => Ok(true),
            list if list.iter().all(|r| matches!(r, Relation::Greater | Relation::GreaterEqual)) => Ok(true),
            _ => {
                let span = self.span();
                Err(self.other("these comparison signs do not form a chain", Some(CHAIN), span))
            }
        }
    }

    /// The signs of comparison from a token on, up to the end of the declaration or to a word.
    fn relations_from(&self, at: usize) -> Vec<Relation> {
        let (mut out, mut level, mut is_complete) = (Vec::new(), 0usize, false);
        for token in &self.tokens[at..] {
            match &token.kind {
                Kind::Sign("(" | "[") => level += 1,
                Kind::Sign(")" | "]") => level = level.saturating_sub(1),
                Kind::Sign("," | ";") if level == 0 => break,
                Kind::Sign(sign) if level == 0 => out.extend(relation_of(sign)),
                Kind::Word(word) if token.first_on_line && CLAUSES.contains(&word.as_str()) => break,
                Kind::Word(word) if level == 0 && RESERVED.contains(&word.as_str()) => break,
                // No product is written so: the word begins something else.
                Kind::Word(_) if level == 0 && is_complete => break,
                Kind::End => break,
                _ => {}
            }
            is_complete =
                matches!(token.kind, Kind::Word(_) | Kind::Number(_) | Kind::Raised(_) | Kind::Sign(")" | "]"));
        }
        out
    }

    /// A comparison: its new names are real numbers, and it is a hypothesis.
    fn related(&mut self, out: &mut Vec<Item>) -> Parsed<()> {
        let start = self.span().start;
        let prop = self.comparison()?;
        if !matches!(prop.kind, PropKind::Compare(..)) {
            let help = "suppose a limit with `assume`, behind the declarations";
            return Err(self.other("this declares no name", Some(help), self.since(start)));
        }
        let mut new: Vec<(Name, Option<Name>)> = Vec::new();
        walk::free_names(&prop, &mut |text, span| {
            let is_new = text != PI && !self.declared.contains(text);
            if is_new && new.iter().all(|n| n.0.text != text) {
                new.push((Name { text: text.to_string(), span }, None));
            }
        });
        self.declared.extend(new.iter().map(|n| n.0.text.clone()));
        let unit = if self.is_word("in") { Some(self.unit(false)?) } else { None };
        if new.is_empty() && unit.is_some() {
            let (span, help) = (self.since(start), "write it where the names are declared: `given a real in kg`");
            return Err(self.other("a unit stands behind a relation that declares no name", Some(help), span));
        }
        if !new.is_empty() {
            let span = self.since(start);
            declare(Binding { names: new, natural: false, constraints: Vec::new(), indices: None, unit, span }, out);
        }
        out.push(Item::Assume { label: None, prop });
        Ok(())
    }

    /// `k integer` is written out: k is the difference of two natural numbers, `k_up` and `k_down`, and what else is
    /// said of k is a hypothesis. Every integer is such a difference, so that the claim says the same.
    fn integers(&mut self, binding: Binding, span: Span, out: &mut Vec<Item>) -> Parsed<()> {
        let is_plain = !binding.natural && binding.indices.is_none() && binding.unit.is_none();
        if !is_plain || binding.names.iter().any(|n| n.1.is_some()) {
            let help = "write `k integer`, or with bounds `k integer >= -3 and <= 3`";
            return Err(self.other(
                "`integer` cannot be combined with a family, a range, a unit or `natural`",
                Some(help),
                span,
            ));
        }
        for (name, _) in &binding.names {
            let part = |end: &str| Name { text: format!("{}_{end}", name.text), span: name.span };
            let value = |name: &Name| Expr { kind: ExprKind::Name(name.text.clone()), span: name.span };
            let (up, down) = (part("up"), part("down"));
            let difference = ExprKind::Sum(vec![(Sign::Plus, value(&up)), (Sign::Minus, value(&down))]);
            self.declared.extend([&up, &down, name].map(|n| n.text.clone()));
            let names = vec![(up, None), (down, None)];
            declare(Binding::new(names, true, Vec::new(), binding.span), out);
            let difference = Expr { kind: difference, span: name.span };
            out.push(Item::Let { name: name.clone(), parameters: Vec::new(), value: difference });
            for constraint in &binding.constraints {
                let mut suppose = |relation: Relation, bound: &Expr| {
                    let kind = PropKind::Compare(vec![value(name), bound.clone()], vec![relation]);
                    out.push(Item::Assume { label: None, prop: Prop { kind, span: binding.span } });
                };
                match constraint {
                    Constraint::Relation(relation, bound) => suppose(*relation, bound),
                    Constraint::Interval { from, from_closed, to, to_closed } => {
                        suppose(if *from_closed { Relation::GreaterEqual } else { Relation::Greater }, from);
                        suppose(if *to_closed { Relation::LessEqual } else { Relation::Less }, to);
                    }
                    // A range makes a natural number, which was refused above.
                    Constraint::Range(..) => {}
                }
            }
        }
        Ok(())
    }

    /// The variable of a limit, perhaps with its domain: `n`, `n natural`, `x real`. Returns whether it is said to be natural,
    /// if a domain is said.
    pub(super) fn grows(&mut self, variable: &Name) -> Option<bool> {
        let natural = if self.word("natural") { Some(true) } else { self.word("real").then_some(false) };
        if self.growing.iter().all(|(name, _)| name != variable) {
            self.growing.push((variable.clone(), natural));
        }
        natural
    }

    /// Declares the variables of limits: those with a domain of their own, and as real numbers those that nothing else
    /// declares.
    pub(super) fn declare_what_grows(&mut self, claim: &mut Claim) {
        for (name, natural) in std::mem::take(&mut self.growing) {
            if natural.is_none() && self.declared.contains(&name.text) {
                continue;
            }
            let span = name.span;
            let names = vec![(name, None)];
            let natural = natural.unwrap_or(false);
            let binding = Binding { names, natural, constraints: Vec::new(), indices: None, unit: None, span };
            claim.items.insert(0, Item::Given(vec![binding]));
        }
    }
}

/// What to write instead of two conditions without `and`.
pub(super) const CHAIN: &str = "write `and` between two conditions, as in `x > 0 and != 1`; the signs of a chain \
                                such as `0 < a < b` point in one direction";

/// Adds a declaration to the `given` before it, if there is one.
fn declare(binding: Binding, out: &mut Vec<Item>) {
    match out.last_mut() {
        Some(Item::Given(list)) => list.push(binding),
        _ => out.push(Item::Given(vec![binding])),
    }
}
