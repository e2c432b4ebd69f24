//! Propositions, from equivalences down to comparisons, and the bindings of quantifiers.

use super::*;

impl Parser {
    pub(super) fn prop(&mut self) -> Parsed<Prop> {
        self.deeper(Self::equivalence)
    }

    fn equivalence(&mut self) -> Parsed<Prop> {
        let start = self.span().start;
        let mut list = vec![self.implication()?];
        while self.sign("<=>") {
            list.push(self.implication()?);
        }
        Ok(self.joined(list, start, PropKind::Equivalent))
    }

    fn joined(&self, mut list: Vec<Prop>, start: usize, kind: fn(Vec<Prop>) -> PropKind) -> Prop {
        if list.len() == 1
            && let Some(only) = list.pop()
        {
            return only;
        }
        Prop { kind: kind(list), span: self.since(start) }
    }

    fn implication(&mut self) -> Parsed<Prop> {
        let start = self.span().start;
        let left = self.disjunction()?;
        if self.sign("=>") {
            let right = self.deeper(Self::implication)?;
            let kind = PropKind::Implies(Box::new(left), Box::new(right));
            return Ok(Prop { kind, span: self.since(start) });
        }
        Ok(left)
    }

    fn disjunction(&mut self) -> Parsed<Prop> {
        let start = self.span().start;
        let mut list = vec![self.conjunction()?];
        while self.word("or") {
            list.push(self.conjunction()?);
        }
        Ok(self.joined(list, start, PropKind::Or))
    }

    fn conjunction(&mut self) -> Parsed<Prop> {
        let start = self.span().start;
        let mut list = vec![self.negation()?];
        while self.word("and") {
            list.push(self.negation()?);
        }
        Ok(self.joined(list, start, PropKind::And))
    }

    fn negation(&mut self) -> Parsed<Prop> {
        let start = self.span().start;
        if self.word("not") {
            let inner = self.deeper(Self::negation)?;
            return Ok(Prop { kind: PropKind::Not(Box::new(inner)), span: self.since(start) });
        }
        self.atomic()
    }

    fn atomic(&mut self) -> Parsed<Prop> {
        let start = self.span().start;
        if self.word("exists") {
            let bindings = self.bindings()?;
            self.need_sign(":", "before what is said to hold")?;
            let body = Box::new(self.prop()?);
            return Ok(Prop { kind: PropKind::Exists(bindings, body), span: self.since(start) });
        }
        if self.word("for") {
            if !self.word("all") && !self.word("each") {
                return Err(self.expected("`all` or `each`"));
            }
            let bindings = self.bindings()?;
            self.need_sign(":", "before what is said to hold")?;
            let body = Box::new(self.prop()?);
            return Ok(Prop { kind: PropKind::ForAll(bindings, body), span: self.since(start) });
        }
        if self.is_word("maximum") || self.is_word("minimum") {
            return self.extremum();
        }
        if self.word("limit") {
            return self.limit();
        }
        if matches!(self.peek(), Kind::Sign("(")) && self.parenthesis_holds_prop() {
            self.advance();
            let inner = self.prop()?;
            self.need_sign(")", "to close the parenthesis")?;
            return Ok(inner);
        }
        self.comparison()
    }

    /// Whether the parenthesis here, or one of those with which it begins, holds a relation or a word of logic at its own
    /// level.
    fn parenthesis_holds_prop(&self) -> bool {
        let tokens = &self.tokens[self.at..];
        let first = tokens.iter().take_while(|token| matches!(token.kind, Kind::Sign("("))).count();
        // The number of open ones among the leading parentheses; others are nested inside them.
        let (mut level, mut open) = (first, first);
        for token in &tokens[first..] {
            match &token.kind {
                Kind::Sign("(" | "[" | "{") => level += 1,
                Kind::Sign(")" | "]" | "}") => {
                    level -= 1;
                    open = open.min(level);
                    if level == 0 {
                        return false;
                    }
                }
                Kind::Word(w)
                    if level == open
                        && matches!(
                            w.as_str(),
                            "and" | "or" | "not" | "exists" | "for" | "limit" | "maximum" | "minimum"
                        ) =>
                {
                    return true;
                }
                Kind::Sign("<" | "<=" | ">" | ">=" | "=" | "==" | "!=" | "=>" | "<=>") if level == open => return true,
                Kind::End => return false,
                _ => {}
            }
        }
        false
    }

    fn relation(&mut self) -> Option<Relation> {
        let Kind::Sign(sign) = self.peek() else { return None };
        let relation = relation_of(sign)?;
        self.advance();
        Some(relation)
    }

    pub(super) fn comparison(&mut self) -> Parsed<Prop> {
        let start = self.span().start;
        let mut sides = vec![self.expr()?];
        let mut relations = Vec::new();
        while let Some(relation) = self.relation() {
            relations.push(relation);
            sides.push(self.expr()?);
        }
        if relations.is_empty() {
            return Err(self.expected("a comparison sign such as = or >="));
        }
        if let Some(order) = self.order(&sides, &relations, start)? {
            return Ok(order);
        }
        if let Some(limit) = self.without_end(&sides, &relations, start)? {
            return Ok(limit);
        }
        Ok(Prop { kind: PropKind::Compare(sides, relations), span: self.since(start) })
    }

    fn extremum(&mut self) -> Parsed<Prop> {
        let start = self.span().start;
        let maximum = self.is_word("maximum");
        self.advance();
        self.need_word("of")?;
        let of = self.expr()?;
        self.need_word("over")?;
        let over = self.bindings()?;
        let unique = self.word("only");
        if !unique && self.word("is") {
            return self.extremum_somewhere(maximum, of, over, start);
        }
        self.need_word("at")?;
        let at = self.assignments()?;
        self.need_word("is")?;
        let value = self.expr()?;
        let kind = PropKind::Extremum(Box::new(Extremum { maximum, unique, of, over, at, value }));
        Ok(Prop { kind, span: self.since(start) })
    }

    /// `maximum of F over x in D is M` says that M is a bound of F over D, and a value of F there.
    fn extremum_somewhere(&mut self, maximum: bool, of: Expr, over: Vec<Binding>, start: usize) -> Parsed<Prop> {
        let value = self.expr()?;
        let span = self.since(start);
        let says = |relation: Relation| {
            Box::new(Prop { kind: PropKind::Compare(vec![of.clone(), value.clone()], vec![relation]), span })
        };
        let bound = if maximum { Relation::LessEqual } else { Relation::GreaterEqual };
        let parts = [PropKind::ForAll(over.clone(), says(bound)), PropKind::Exists(over, says(Relation::Equal))];
        Ok(Prop { kind: PropKind::And(parts.map(|kind| Prop { kind, span }).to_vec()), span })
    }

    /// `x = A, y = B`
    pub(super) fn assignments(&mut self) -> Parsed<Vec<(Name, Expr)>> {
        let mut list = Vec::new();
        loop {
            let name = self.name("a name")?;
            self.need_sign("=", "after the name")?;
            list.push((name, self.expr()?));
            if !self.sign(",") {
                return Ok(list);
            }
        }
    }

    /// `m1, m2 > 0; e in [0, 1], n natural`: a comma between names belongs to one domain, one behind a domain begins the next.
    pub(super) fn bindings(&mut self) -> Parsed<Vec<Binding>> {
        let mut list = Vec::new();
        loop {
            list.push(self.binding()?);
            if let Some(span) = self.whole.take() {
                let help = "write a difference of natural numbers: `for all i, j natural` and i - j";
                return Err(self.other("an `integer` is declared under `given` only", Some(help), span));
            }
            if let Some(Binding { unit: Some(_), span, .. }) = list.last() {
                let (span, help) = (*span, "leave it out: it follows from the equations");
                return Err(self.other("a unit is declared under `given` only", Some(help), span));
            }
            if !(self.sign(";") || self.sign(",")) || self.at_clause() {
                return Ok(list);
            }
        }
    }

    pub(super) fn binding(&mut self) -> Parsed<Binding> {
        let start = self.span().start;
        let mut names = Vec::new();
        loop {
            let name = self.name("a name to declare")?;
            let mut index = None;
            if self.sign("(") {
                index = Some(self.name("the name of the index")?);
                self.need_sign(")", "after the index")?;
            }
            names.push((name, index));
            if !self.sign(",") {
                break;
            }
        }
        let (mut natural, mut unit) = (false, None);
        let mut constraints = Vec::new();
        let mut any = false;
        loop {
            // `a > b > 0` reads as a chain, which says more than two conditions on a.
            let mut beside = any && matches!(constraints.last(), Some(Constraint::Relation(..)));
            if any && self.word("and") {
                beside = false;
            }
            if self.word("real") {
                // The default; the word only helps the reader.
            } else if self.word("natural") {
                natural = true;
            } else if self.is_word("integer") {
                self.whole = Some(self.advance().span);
            } else if let Some(relation) = self.relation() {
                if self.file && beside {
                    let span = self.span();
                    return Err(self.other("two conditions need `and` between them", Some(given::CHAIN), span));
                }
                constraints.push(Constraint::Relation(relation, self.expr()?));
            } else if self.is_word("in") && self.begins_unit(any) {
                unit = Some(self.unit(natural)?);
                any = true;
                break;
            } else if self.word("in") {
                constraints.push(self.interval(&mut natural)?);
            } else {
                break;
            }
            any = true;
        }
        if !any {
            return Err(self.expected(super::DOMAIN));
        }
        let mut indices = None;
        if self.word("for") {
            let index = self.name("the index")?;
            if names.iter().all(|name| name.1.as_ref().is_none_or(|own| own.text != index.text)) {
                let help = Some("a range is for the index of a family: `mu(k) > 0 for k in 1..n`");
                let message = format!("{} is not the index of a family declared here", index.text);
                return Err(self.other(&message, help, index.span));
            }
            self.need_word("in")?;
            let from = self.expr()?;
            self.need_sign("..", "between the first and the last index")?;
            indices = Some((from, self.expr()?));
        }
        Ok(Binding { names, natural, constraints, indices, unit, span: self.since(start) })
    }

    fn interval(&mut self, natural: &mut bool) -> Parsed<Constraint> {
        // A parenthesis may open an interval or a range's first expression; a bracket an interval.
        let closed = matches!(self.peek(), Kind::Sign("["));
        if closed || matches!(self.peek(), Kind::Sign("(")) {
            let saved = self.at;
            let faults = self.faults.len();
            self.advance();
            if let Ok(from) = self.expr()
                && self.sign(",")
            {
                let to = self.expr()?;
                let to_closed = match self.peek() {
                    Kind::Sign("]") => true,
                    Kind::Sign(")") => false,
                    _ => return Err(self.expected("`]` or `)` to close the interval")),
                };
                self.advance();
                return Ok(Constraint::Interval { from, from_closed: closed, to, to_closed });
            }
            if closed {
                if self.faults.len() == faults {
                    return Err(self.expected("`,` between the ends of the interval"));
                }
                return Err(Reported);
            }
            self.faults.truncate(faults);
            self.at = saved;
        }
        let from = self.expr()?;
        if let ExprKind::Name(set) = &from.kind
            && ["R", "Q", "Z", "N"].contains(&set.as_str())
            && !matches!(self.peek(), Kind::Sign(".."))
        {
            return Err(self.other(&format!("the set {set} is no domain here"), foreign("ℝ"), from.span));
        }
        self.need_sign("..", "between the first and the last value")?;
        let to = self.expr()?;
        *natural = true;
        Ok(Constraint::Range(from, to))
    }
}

/// The relation that a sign stands for.
pub(super) fn relation_of(sign: &str) -> Option<Relation> {
    Some(match sign {
        "=" => Relation::Equal,
        "!=" => Relation::NotEqual,
        "<" => Relation::Less,
        "<=" => Relation::LessEqual,
        ">" => Relation::Greater,
        ">=" => Relation::GreaterEqual,
        _ => return None,
    })
}
