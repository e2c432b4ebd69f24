//! Clauses and claims.

use super::super::diagnostic::nearest;
use super::*;

impl Parser {
    pub(super) fn claims(&mut self) -> Vec<Claim> {
        self.file = true;
        self.printed = self.preamble.printed.clone();
        self.preamble();
        let (mut claims, mut prose) = (Vec::new(), Vec::new());
        while self.peek() != &Kind::End {
            if self.word("claim") {
                if let Some(claim) = self.claim(std::mem::take(&mut prose)) {
                    claims.push(claim);
                }
            } else if self.is_word("text") {
                if self.prose(&mut prose).is_err() {
                    self.skip();
                }
            } else {
                let help = self.clause_meant("a claim begins with: claim NAME \"Title\"");
                self.expected_with("`claim`", help);
                self.advance();
                while self.peek() != &Kind::End && !(self.at_clause() && self.is_word("claim")) {
                    self.advance();
                }
            }
        }
        claims
    }

    /// The clauses before the first claim, which all claims share.
    fn preamble(&mut self) {
        self.values = Values::of(&self.preamble.items);
        while self.at_clause() && PREAMBLE.iter().any(|word| self.is_word(word)) {
            self.preamble.is_said = true;
            if self.shared().is_err() {
                self.skip();
            }
        }
        self.preamble.printed = self.printed.clone();
        self.preamble.names.extend(std::mem::take(&mut self.declared));
        self.refused_before = self.refused.len();
    }

    fn shared(&mut self) -> Parsed<()> {
        let token = self.advance();
        let Kind::Word(word) = &token.kind else { return Err(Reported) };
        match word.as_str() {
            "paper" => self.preamble.paper = Some(self.text()?),
            "source" => self.preamble.source = Some(self.text()?),
            "section" => self.preamble.section = Some(self.text()?),
            "reading" => self.preamble.reading = Some(self.reading()?),
            _ => {
                let items = self.items(word)?;
                items.iter().for_each(|item| self.values.learn(item));
                self.preamble.items.extend(items);
            }
        }
        self.end_of_clause()
    }

    /// A paragraph for readers, printed above the claim that follows.
    fn prose(&mut self, into: &mut Vec<String>) -> Parsed<()> {
        let token = self.advance();
        into.push(self.text()?);
        self.end_of_clause()?;
        if self.is_word("claim") || self.is_word("text") {
            return Ok(());
        }
        Err(self.other(
            "a text must be followed by a claim",
            Some("write a remark on a claim as a `note` in it"),
            token.span,
        ))
    }

    /// What to write for the word here, which begins no clause: `known` where it is a clause's word in the wrong place.
    fn clause_meant(&self, known: &str) -> Option<String> {
        match self.peek() {
            Kind::Word(word) if begins_clause(word) => Some(known.to_owned()),
            Kind::Word(word) => nearest(word, CLAUSES.iter().copied()).map(|near| format!("did you mean `{near}`?")),
            _ => None,
        }
    }

    fn end_of_clause(&mut self) -> Parsed<()> {
        if self.at_clause() { Ok(()) } else { Err(self.expected(END_OF_CLAUSE)) }
    }

    fn claim(&mut self, prose: Vec<String>) -> Option<Claim> {
        let before = self.faults.len();
        let name = self.name("the name of the claim").ok();
        self.refused.truncate(self.refused_before);
        self.printed = self.preamble.printed.clone();
        self.declared = self.preamble.names.clone();
        self.values = Values::of(&self.preamble.items);
        self.growing.clear();
        self.bound.clear();
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
            paper: None,
            source: None,
            section: None,
            number: None,
            reading: None,
            prose,
            notes: Vec::new(),
            using: Vec::new(),
            items: Vec::new(),
            sample: Vec::new(),
            goal: empty,
            proof: Proof::default(),
            expect: Expectation::Proved,
            written: None,
            typeset: None,
        };
        let mut proved = false;
        loop {
            if self.peek() == &Kind::End || (self.at_clause() && (self.is_word("claim") || self.is_word("text"))) {
                break;
            }
            if !self.at_clause() {
                let help = self.clause_meant("begin each clause on a line of its own");
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
        self.declare_what_grows(&mut claim);
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
                Kind::Text(text) => {
                    self.advance();
                    claim.number = Some(text);
                }
                _ => return Err(self.expected("an equation number such as 13, 2.13, A.3 or 7a")),
            },
            "reading" => claim.reading = Some(self.reading()?),
            "sample" => claim.sample.extend(self.assignments()?),
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
            "given" | "let" | "define" | "assume" => {
                let items = self.items(word)?;
                items.iter().for_each(|item| self.values.learn(item));
                claim.items.extend(items);
            }
            "prove" => {
                if *proved {
                    return Err(self.other(
                        "a claim has only one `prove` clause",
                        Some("write a second claim"),
                        token.span,
                    ));
                }
                *proved = true;
                claim.goal = self.prop()?;
                claim.proof = self.proof()?;
            }
            _ => {
                let help = Some("write it in the preamble, before the first claim of the file");
                return Err(self.other(&format!("`{word}` is not a clause of a claim"), help, token.span));
            }
        }
        self.end_of_clause()
    }

    fn reading(&mut self) -> Parsed<Reading> {
        if self.word("as") {
            return match self.word("printed") {
                true => Ok(Reading::Printed),
                false => Err(self.expected("`printed`")),
            };
        }
        let words = [
            ("printed", Reading::Printed),
            ("restored", Reading::Restored),
            ("extracted", Reading::Extracted),
            ("beyond", Reading::Beyond),
        ];
        match words.into_iter().find(|(word, _)| self.word(word)) {
            Some((_, reading)) => Ok(reading),
            None => Err(self.expected("`as printed`, `restored`, `extracted` or `beyond`")),
        }
    }

    /// What a clause declares: `given`, `let`, `define` or `assume`.
    fn items(&mut self, word: &str) -> Parsed<Vec<Item>> {
        match word {
            "given" => self.given(),
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
                self.declared.insert(name.text.clone());
                Ok(vec![Item::Let { name, parameters, value: self.expr()? }])
            }
            "define" => self.sequences(),
            _ => {
                let labelled = matches!(self.peek(), Kind::Word(_)) && self.peek_at(1) == &Kind::Sign(":");
                let mut label = None;
                if labelled {
                    label = Some(self.name("a label")?);
                    self.advance();
                }
                Ok(vec![Item::Assume { label, prop: self.prop()? }])
            }
        }
    }
}
