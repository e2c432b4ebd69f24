//! Expressions, from sums down to atoms.

use super::*;

impl Parser {
    pub(super) fn expr(&mut self) -> Parsed<Expr> {
        self.deeper(Self::sum)
    }

    fn sum(&mut self) -> Parsed<Expr> {
        let start = self.span().start;
        let first = self.signed()?;
        let mut list = vec![(Sign::Plus, first)];
        loop {
            let sign = match self.peek() {
                Kind::Sign("+") => Sign::Plus,
                Kind::Sign("-") => Sign::Minus,
                _ => break,
            };
            self.advance();
            let summand = self.product()?;
            list.push((sign, summand));
        }
        Ok(self.collapsed(list, start, ExprKind::Sum))
    }

    fn collapsed<T>(&self, mut list: Vec<(T, Expr)>, start: usize, kind: fn(Vec<(T, Expr)>) -> ExprKind) -> Expr {
        if list.len() == 1
            && let Some((_, only)) = list.pop()
        {
            return only;
        }
        Expr { kind: kind(list), span: self.since(start) }
    }

    /// A product that may begin with minus signs: −x·y is −(x·y).
    fn signed(&mut self) -> Parsed<Expr> {
        let start = self.span().start;
        if self.sign("-") {
            let inner = self.deeper(Self::signed)?;
            return Ok(Expr { kind: ExprKind::Negate(Box::new(inner)), span: self.since(start) });
        }
        self.product()
    }

    fn product(&mut self) -> Parsed<Expr> {
        let start = self.span().start;
        let first = self.power()?;
        let mut list = vec![(Factor::Times, first)];
        loop {
            let operator = match self.peek() {
                Kind::Sign("*") => Factor::Times,
                Kind::Sign("/") => Factor::Over,
                _ => break,
            };
            self.advance();
            let factor =
                if matches!(self.peek(), Kind::Sign("-")) { self.deeper(Self::signed_power)? } else { self.power()? };
            list.push((operator, factor));
        }
        Ok(self.collapsed(list, start, ExprKind::Product))
    }

    fn signed_power(&mut self) -> Parsed<Expr> {
        let start = self.span().start;
        if self.sign("-") {
            let inner = self.deeper(Self::signed_power)?;
            return Ok(Expr { kind: ExprKind::Negate(Box::new(inner)), span: self.since(start) });
        }
        self.power()
    }

    fn power(&mut self) -> Parsed<Expr> {
        let start = self.span().start;
        let base = self.with_factorial()?;
        if let Kind::Raised(power) = self.peek().clone() {
            return self.raised(base, &power, start);
        }
        if self.sign("^") {
            let exponent = self.deeper(Self::signed_power)?;
            let kind = ExprKind::Power(Box::new(base), Box::new(exponent));
            return Ok(Expr { kind, span: self.since(start) });
        }
        Ok(base)
    }

    /// A power above the line, `x²`. What follows it at once is refused: x²^3 and x²! are read in two ways.
    fn raised(&mut self, base: Expr, power: &str, start: usize) -> Parsed<Expr> {
        let span = self.advance().span;
        let number = |digits: &str| Expr { kind: ExprKind::Number(digits.to_string()), span };
        let exponent = match power.strip_prefix('-') {
            Some(digits) => Expr { kind: ExprKind::Negate(Box::new(number(digits))), span },
            None => number(power),
        };
        if self.at_power() {
            let help = "write parentheses, as in (x^2)^3, or one exponent, as in x^(2^3)";
            let span = self.span();
            return Err(self.other("a raised exponent is followed by another exponent", Some(help), span));
        }
        let kind = ExprKind::Power(Box::new(base), Box::new(exponent));
        Ok(Expr { kind, span: self.since(start) })
    }

    /// Whether a power or a factorial follows.
    fn at_power(&self) -> bool {
        matches!(self.peek(), Kind::Sign("^" | "!") | Kind::Raised(_))
    }

    /// An atom, perhaps with its factorial: `n!`.
    fn with_factorial(&mut self) -> Parsed<Expr> {
        let start = self.span().start;
        let mut out = self.atom()?;
        let mut signs = 0;
        while matches!(self.peek(), Kind::Sign("!")) {
            let sign = self.advance().span;
            signs += 1;
            if signs > 1 {
                return Err(self.other("there is no n!!", Some("write (n!)! or a product"), sign));
            }
            let name = Name { text: "factorial".to_string(), span: sign };
            out = Expr { kind: ExprKind::Apply(name, vec![out]), span: self.since(start) };
        }
        Ok(out)
    }

    fn atom(&mut self) -> Parsed<Expr> {
        let start = self.span().start;
        match self.peek().clone() {
            Kind::Number(text) => {
                self.advance();
                Ok(Expr { kind: ExprKind::Number(text), span: self.since(start) })
            }
            Kind::Sign("(") => {
                self.advance();
                let inner = self.expr()?;
                self.need_sign(")", "to close the parenthesis")?;
                Ok(inner)
            }
            Kind::Sign("|") => {
                self.advance();
                let inner = self.expr()?;
                self.need_sign("|", "to close the absolute value")?;
                let name = Name { text: "abs".to_string(), span: self.since(start) };
                Ok(Expr { kind: ExprKind::Apply(name, vec![inner]), span: self.since(start) })
            }
            Kind::Sign("√") => {
                let span = self.advance().span;
                let of = self.deeper(Self::atom)?;
                if self.at_power() {
                    let help = "write parentheses, as in √(x^2) or (√x)^2";
                    let span = self.span();
                    return Err(self.other("it is not clear how far the root reaches", Some(help), span));
                }
                let name = Name { text: "sqrt".to_string(), span };
                Ok(Expr { kind: ExprKind::Apply(name, vec![of]), span: self.since(start) })
            }
            Kind::Sign("[") => self.deeper(Self::matrix),
            Kind::Word(word) if matches!(word.as_str(), "sum" | "product" | "integral") => {
                self.advance();
                self.need_sign("(", &format!("after {word}"))?;
                let name = self.name("an index name")?;
                if !self.sign("=") {
                    let form = if word == "integral" { "x = a..b, f" } else { "k = 1..n, f" };
                    let help = format!("write the variable and its range first: {word}({form})");
                    return Err(self.expected_with("`=` and a range such as 1..n", Some(help)));
                }
                let from = Box::new(self.expr()?);
                self.need_sign("..", "between the first and the last value")?;
                let end = self.span();
                let to = match self.word(INFINITY) {
                    true => Box::new(Expr { kind: ExprKind::Name(INFINITY.to_string()), span: end }),
                    false => Box::new(self.expr()?),
                };
                self.need_sign(",", "before what is summed, multiplied or integrated")?;
                let body = Box::new(self.expr()?);
                self.need_sign(")", &format!("to close the {word}"))?;
                let index = Index { name, from, to };
                let kind = match word.as_str() {
                    "sum" => ExprKind::SumOver(index, body),
                    "product" => ExprKind::ProductOver(index, body),
                    _ => ExprKind::IntegralOver(index, body),
                };
                Ok(Expr { kind, span: self.since(start) })
            }
            Kind::Word(word) if word == "derivative" => {
                self.advance();
                self.need_sign("(", "after derivative")?;
                let body = Box::new(self.expr()?);
                let mut by = Vec::new();
                while self.sign(",") {
                    by.push(self.name("a variable to differentiate by")?);
                }
                if by.is_empty() {
                    return Err(self.expected("`,` and the variable to differentiate by"));
                }
                self.need_sign(")", "to close the derivative")?;
                Ok(Expr { kind: ExprKind::Derivative(body, by), span: self.since(start) })
            }
            Kind::Word(word) if !RESERVED.contains(&word.as_str()) => {
                let name = self.name("a name")?;
                if !self.sign("(") {
                    return Ok(Expr { kind: ExprKind::Name(word), span: self.since(start) });
                }
                let mut arguments = vec![self.expr()?];
                while self.sign(",") {
                    arguments.push(self.expr()?);
                }
                self.need_sign(")", "to close the arguments")?;
                Ok(Expr { kind: ExprKind::Apply(name, arguments), span: self.since(start) })
            }
            _ => Err(self.expected("an expression")),
        }
    }

    fn matrix(&mut self) -> Parsed<Expr> {
        let start = self.span().start;
        self.need_sign("[", "to open the matrix")?;
        let mut rows = vec![vec![self.expr()?]];
        loop {
            if self.sign(",") {
                let entry = self.expr()?;
                if let Some(row) = rows.last_mut() {
                    row.push(entry);
                }
            } else if self.sign(";") {
                let entry = self.expr()?;
                rows.push(vec![entry]);
            } else {
                break;
            }
        }
        self.need_sign("]", "to close the matrix")?;
        let span = self.since(start);
        if rows.iter().any(|r| r.len() != rows[0].len()) {
            return Err(self.other("the rows of this matrix differ in length", None, span));
        }
        Ok(Expr { kind: ExprKind::Matrix(rows), span })
    }
}
