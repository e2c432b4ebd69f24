//! Arguments: steps and methods.

use super::*;

impl Parser {
    /// `by METHOD`, `{ STEPS }` or nothing.
    pub(super) fn proof(&mut self) -> Parsed<Proof> {
        if self.word("by") {
            return Ok(Proof { steps: Vec::new(), close: Some(self.method()?) });
        }
        if self.sign("{") {
            return self.deeper(Self::block);
        }
        Ok(Proof::default())
    }

    fn block(&mut self) -> Parsed<Proof> {
        let mut proof = Proof::default();
        loop {
            if self.sign("}") {
                return Ok(proof);
            }
            let concluding = self.word("conclude");
            if self.word("by") {
                proof.close = Some(self.method()?);
                self.need_sign("}", "after the last step")?;
                return Ok(proof);
            }
            if concluding {
                return Err(self.expected("`by` and a method"));
            }
            let step = if self.word("have") {
                let (label, prop) = self.labelled()?;
                Step::Have { label, prop, proof: self.proof()? }
            } else if self.word("case") {
                let (label, prop) = self.labelled()?;
                Step::Case { label, prop, proof: self.proof()? }
            } else if self.word("obtain") {
                let bindings = self.bindings()?;
                self.need_word("with")?;
                let (label, prop) = self.labelled()?;
                self.need_word("by")?;
                let name = self.name("the name that is obtained")?;
                self.need_sign("=", "before its value")?;
                let witness = self.expr()?;
                let Some(binding) = bindings.into_iter().next() else { return Err(Reported) };
                if binding.names.len() != 1 || binding.names[0].0.text != name.text || binding.names[0].1.is_some() {
                    return Err(self.other("`obtain` names one variable, the same after `by`", None, name.span));
                }
                Step::Obtain { binding, label, prop, witness }
            } else {
                return Err(self.expected("`have`, `obtain`, `case`, `conclude by` or `}`"));
            };
            proof.steps.push(step);
        }
    }

    fn labelled(&mut self) -> Parsed<(Name, Prop)> {
        let label = self.name("a label")?;
        self.need_sign(":", "after the label")?;
        Ok((label, self.prop()?))
    }

    fn method(&mut self) -> Parsed<Method> {
        if self.word("product") {
            self.need_word("of")?;
            let mut list = Vec::new();
            loop {
                let fact = self.name("a fact")?;
                let exponent = if self.sign("^") { Some(self.exponent()?) } else { None };
                list.push((fact, exponent));
                if !self.sign(",") {
                    return Ok(Method::Product(list));
                }
            }
        }
        let name = self.name("a method or the name of a claim")?;
        Ok(match name.text.as_str() {
            "algebra" => {
                let mut facts = Vec::new();
                if self.word("from") {
                    loop {
                        facts.push(self.name("a fact")?);
                        if !self.sign(",") {
                            break;
                        }
                    }
                }
                Method::Algebra(facts)
            }
            "induction" => {
                self.need_word("on")?;
                let variable = self.name("a natural variable")?;
                let step = if self.sign("{") { self.deeper(Self::block)? } else { Proof::default() };
                Method::Induction(variable, Box::new(step))
            }
            "power" => {
                self.need_word("of")?;
                let fact = self.name("a fact")?;
                self.need_word("to")?;
                Method::Power { fact, exponent: self.expr()? }
            }
            "mean" => {
                self.need_word("of")?;
                let a = self.expr()?;
                self.need_sign(",", "between the two values")?;
                let b = self.expr()?;
                Method::Mean { a, b, weight: self.weight()? }
            }
            "hoelder" => {
                self.need_word("of")?;
                let first = self.pair()?;
                self.need_sign(",", "between the two pairs")?;
                let second = self.pair()?;
                Method::Hoelder { first, second, weight: self.weight()? }
            }
            "witness" => Method::Witness(self.assignments()?),
            "squeeze" => {
                self.need_word("between")?;
                let lower = self.expr()?;
                self.need_word("and")?;
                Method::Squeeze { lower, upper: self.expr()? }
            }
            _ => {
                let with = if self.word("with") { self.assignments()? } else { Vec::new() };
                Method::Instance { claim: name, with }
            }
        })
    }

    fn exponent(&mut self) -> Parsed<Expr> {
        if matches!(self.peek(), Kind::Sign("(")) {
            self.advance();
            let inner = self.expr()?;
            self.need_sign(")", "to close the exponent")?;
            return Ok(inner);
        }
        let start = self.span().start;
        match self.peek().clone() {
            Kind::Number(text) => {
                self.advance();
                Ok(Expr { kind: ExprKind::Number(text), span: self.since(start) })
            }
            _ => {
                let name = self.name("an exponent")?;
                Ok(Expr { kind: ExprKind::Name(name.text), span: name.span })
            }
        }
    }

    fn weight(&mut self) -> Parsed<Expr> {
        self.need_word("with")?;
        let word = self.name("`weight`")?;
        if word.text != "weight" {
            return Err(self.other("`weight` is needed here", None, word.span));
        }
        self.expr()
    }

    fn pair(&mut self) -> Parsed<(Expr, Expr)> {
        self.need_sign("(", "to open the pair")?;
        let a = self.expr()?;
        self.need_sign(",", "between the two values")?;
        let b = self.expr()?;
        self.need_sign(")", "to close the pair")?;
        Ok((a, b))
    }
}
