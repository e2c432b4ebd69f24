//! Limits: at infinity, at a point, from one side, and those that are infinite.
//!
//! A limit at infinity with a number as its value is a statement of the kernel's language; [`crate::claim::limit`] writes the
//! others out.

use super::*;

impl Parser {
    /// `of F as x -> a is L`, behind `limit`.
    pub(super) fn limit(&mut self) -> Parsed<Prop> {
        let start = self.span().start;
        self.need_word("of")?;
        let of = self.expr()?;
        self.need_word("as")?;
        let variable = self.name("the variable that moves")?;
        let is_declared = self.declared.contains(&variable.text);
        if variable.text == PI && !is_declared {
            self.faults.push(Diagnostic::new(Fault::Pi, variable.span));
            return Err(Reported);
        }
        let domain = self.span();
        let said = self.grows(&variable);
        let (has_domain, natural) = (said.is_some(), said == Some(true));
        self.need_sign("->", "between the variable and where it goes")?;
        let mut towards = Towards::Infinity;
        if !self.word("infinity") {
            if is_declared || has_domain {
                let message =
                    format!("{} is already declared, so it cannot be the variable of this limit", variable.text);
                let help = "use a new name: the limit itself declares its variable";
                let span = if has_domain { domain } else { variable.span };
                return Err(self.other(&message, Some(help), span));
            }
            let point = self.expr()?;
            towards = Towards::Point(point, self.side()?);
        }
        self.need_word("is")?;
        let minus =
            matches!(self.peek(), Kind::Sign("-" | "−")) && self.peek_at(1) == &Kind::Word("infinity".to_string());
        if minus {
            self.advance();
        }
        if self.word("infinity") {
            // What is greater than some number has the domain of the variable, which only the limit can say here.
            if is_declared {
                let message =
                    format!("{} is already declared, so it cannot be the variable of an infinite limit", variable.text);
                let help = "use a new name, declared by the limit: `as n natural -> infinity`";
                return Err(self.other(&message, Some(help), variable.span));
            }
            let value = Tendency::Infinite(if minus { Sign::Minus } else { Sign::Plus });
            let kind = PropKind::WrittenLimit(Box::new(WrittenLimit { of, variable, natural, towards, value }));
            return Ok(Prop { kind, span: self.since(start) });
        }
        let value = self.expr()?;
        let kind = match towards {
            Towards::Infinity => PropKind::Limit(Box::new(Limit { of, variable, value })),
            towards => {
                let value = Tendency::Number(value);
                PropKind::WrittenLimit(Box::new(WrittenLimit { of, variable, natural, towards, value }))
            }
        };
        Ok(Prop { kind, span: self.since(start) })
    }

    /// `from above` or `from below`, if it is said.
    fn side(&mut self) -> Parsed<Option<Sign>> {
        if !self.word("from") {
            return Ok(None);
        }
        if self.word("above") {
            return Ok(Some(Sign::Plus));
        }
        if self.word("below") { Ok(Some(Sign::Minus)) } else { Err(self.expected("`above` or `below`")) }
    }
}
