//! Clauses and claims.

use super::super::diagnostic::nearest;
use super::*;

impl Parser {
    pub(super) fn claims(&mut self) -> Vec<Claim> {
        let mut claims = Vec::new();
        while self.peek() != &Kind::End {
            if self.word("claim") {
                if let Some(claim) = self.claim() {
                    claims.push(claim);
                }
            } else {
                let help = match self.peek() {
                    Kind::Word(w) => nearest(w, CLAUSES.iter().copied()).map(|n| format!("did you mean `{n}`?")),
                    _ => None,
                };
                self.expected_with("`claim`", help);
                self.advance();
                while self.peek() != &Kind::End && !(self.at_clause() && self.is_word("claim")) {
                    self.advance();
                }
            }
        }
        claims
    }

    fn claim(&mut self) -> Option<Claim> {
        let before = self.faults.len();
        let name = self.name("the name of the claim").ok();
        self.printed.clear();
        let title = match self.peek() {
            Kind::Text(_) => self.text().unwrap_or_default(),
            _ => {
                self.expected("the title of the claim in quotation marks");
                String::new()
            }
        };
        let name = name.unwrap_or(Name { text: String::new(), span: self.span() });
        let empty = Prop { kind: PropKind::And(Vec::new()), span: name.span };
        let mut claim = Claim {
            name,
            title,
            source: None,
            section: None,
            number: None,
            reading: Reading::Restored,
            notes: Vec::new(),
            using: Vec::new(),
            items: Vec::new(),
            goal: empty,
            proof: Proof::default(),
            expect: Expectation::Proved,
        };
        let mut proved = false;
        loop {
            if self.peek() == &Kind::End || (self.at_clause() && self.is_word("claim")) {
                break;
            }
            if !self.at_clause() {
                let help = match self.peek() {
                    Kind::Word(w) => nearest(w, CLAUSES.iter().copied()).map(|n| format!("did you mean `{n}`?")),
                    _ => None,
                };
                self.expected_with("a clause such as `given`, `let`, `assume` or `prove`", help);
                self.skip();
                continue;
            }
            if self.clause(&mut claim, &mut proved).is_err() {
                self.skip();
            }
        }
        if !proved && self.faults.len() == before {
            let fault = Fault::Missing { claim: claim.name.text.clone(), clause: "prove" };
            self.faults.push(Diagnostic::new(fault, claim.name.span));
        }
        (self.faults.len() == before).then_some(claim)
    }

    /// Goes to the next clause.
    fn skip(&mut self) {
        loop {
            if self.at_clause() {
                return;
            }
            self.advance();
        }
    }

    fn clause(&mut self, claim: &mut Claim, proved: &mut bool) -> Parsed<()> {
        let token = self.advance();
        let Kind::Word(word) = &token.kind else { return Err(Reported) };
        match word.as_str() {
            "source" => claim.source = Some(self.text()?),
            "section" => claim.section = Some(self.text()?),
            "note" => claim.notes.push(self.text()?),
            "number" => match self.peek().clone() {
                Kind::Number(text) if text.parse::<u32>().is_ok() => {
                    self.advance();
                    claim.number = text.parse().ok();
                }
                _ => return Err(self.expected("an equation number")),
            },
            "reading" => {
                claim.reading = if self.word("restored") {
                    Reading::Restored
                } else if self.word("extracted") {
                    Reading::Extracted
                } else if self.word("beyond") {
                    Reading::Beyond
                } else {
                    return Err(self.expected("`restored`, `extracted` or `beyond`"));
                };
            }
            "expect" => {
                claim.expect = if self.word("proved") {
                    Expectation::Proved
                } else if self.word("refuted") {
                    Expectation::Refuted
                } else if self.word("undecided") {
                    Expectation::Undecided
                } else {
                    return Err(self.expected("`proved`, `refuted` or `undecided`"));
                };
            }
            "using" => loop {
                claim.using.push(self.name("the name of a claim")?);
                if !self.sign(",") {
                    break;
                }
            },
            "given" => claim.items.push(Item::Given(self.bindings()?)),
            "let" => {
                let name = self.name("a name to define")?;
                let mut parameters = Vec::new();
                if self.sign("(") {
                    loop {
                        parameters.push(self.name("a parameter")?);
                        if !self.sign(",") {
                            break;
                        }
                    }
                    self.need_sign(")", "after the parameters")?;
                }
                self.need_sign("=", "before the value")?;
                claim.items.push(Item::Let { name, parameters, value: self.expr()? });
            }
            "define" => claim.items.push(self.sequence()?),
            "assume" => {
                let labelled = matches!(self.peek(), Kind::Word(_)) && self.peek_at(1) == &Kind::Sign(":");
                let mut label = None;
                if labelled {
                    label = Some(self.name("a label")?);
                    self.advance();
                }
                claim.items.push(Item::Assume { label, prop: self.prop()? });
            }
            "prove" => {
                if *proved {
                    return Err(self.other("a claim has one `prove` clause", Some("write a second claim"), token.span));
                }
                *proved = true;
                claim.goal = self.prop()?;
                claim.proof = self.proof()?;
            }
            _ => return Err(Reported),
        }
        if !self.at_clause() {
            return Err(self.expected("the end of the clause"));
        }
        Ok(())
    }

    /// `define u by u(0) = A, u(k + 1) = B`
    fn sequence(&mut self) -> Parsed<Item> {
        let start = self.span().start;
        let name = self.name("a name to define")?;
        self.need_word("by")?;
        let shape = "`u(0) = …, u(k + 1) = …`";
        let same = |p: &mut Self| -> Parsed<()> {
            let again = p.name("the name of the sequence")?;
            if again.text == name.text {
                Ok(())
            } else {
                Err(p.other(&format!("a definition by recurrence reads {shape}"), None, again.span))
            }
        };
        same(self)?;
        self.need_sign("(", "after the name")?;
        if self.peek() != &Kind::Number("0".to_string()) {
            return Err(self.expected("`0`: a sequence begins at index 0"));
        }
        self.advance();
        self.need_sign(")", "after the index")?;
        self.need_sign("=", "before the first value")?;
        let initial = self.expr()?;
        self.need_sign(",", &format!("and the step, as in {shape}"))?;
        same(self)?;
        self.need_sign("(", "after the name")?;
        let index = self.name("the index name")?;
        self.need_sign("+", "1: the step defines the next member")?;
        if self.peek() != &Kind::Number("1".to_string()) {
            return Err(self.expected("`1`: the step defines the next member"));
        }
        self.advance();
        self.need_sign(")", "after the index")?;
        self.need_sign("=", "before the next value")?;
        let step = self.expr()?;
        Ok(Item::Define { name, initial, index, step, span: self.since(start) })
    }
}
