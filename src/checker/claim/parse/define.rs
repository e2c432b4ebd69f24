//! `define`: sequences by recurrence.
//!
//! `define u by u(0) = A, u(k + 1) = B`, where B has k and u(k), is a declaration of the language. A recurrence of a higher order,
//! or of several sequences at once, is written out as families of real numbers with the equations as hypotheses.

use super::*;

/// One equation of a definition.
pub(super) struct Equation {
    pub(super) name: Name,
    /// The index that stands for every natural number; none for a first value.
    pub(super) index: Option<Name>,
    /// How much is added to it, or the index of the first value.
    shift: usize,
    pub(super) value: Expr,
    pub(super) span: Span,
}

/// The highest order of a recurrence.
const ORDER_LIMIT: usize = 20;

impl Parser {
    /// `u by u(0) = A, u(k + 1) = B`, `V, u by V(0) = …, u(0) = …, V(k + 1) = …, u(k + 1) = …`
    pub(super) fn sequences(&mut self) -> Parsed<Vec<Item>> {
        let start = self.span().start;
        let mut names = vec![self.name("a name to define")?];
        while self.sign(",") {
            names.push(self.name("a name to define")?);
        }
        if !self.word("by") {
            let help = "write the names, then their equations: `define u by u(0) = 1, u(k + 1) = u(k)/2`";
            return Err(self.expected_with("`by`", Some(help.to_string())));
        }
        let mut equations = vec![self.recurrence(&names)?];
        while self.sign(",") {
            equations.push(self.recurrence(&names)?);
        }
        self.declared.extend(names.iter().map(|n| n.text.clone()));
        let span = self.since(start);
        let mut order = 0;
        for name in &names {
            let own = |e: &&Equation| e.name == *name;
            let steps: Vec<&Equation> = equations.iter().filter(own).filter(|e| e.index.is_some()).collect();
            let mut first: Vec<usize> =
                equations.iter().filter(own).filter(|e| e.index.is_none()).map(|e| e.shift).collect();
            first.sort_unstable();
            let [step] = steps.as_slice() else {
                let message = format!("{} needs one step, such as {0}(k + 1) = …", name.text);
                return Err(self.other(&message, None, name.span));
            };
            if first != (0..step.shift).collect::<Vec<_>>() {
                let wanted: Vec<String> = (0..step.shift).map(|k| format!("{}({k})", name.text)).collect();
                let message = format!(
                    "the step to {}({} + {}) needs {}",
                    name.text,
                    step.index_name(),
                    step.shift,
                    wanted.join(", ")
                );
                let help = "give each of these once, and no other; a sequence that begins at 1 is `u(0) = a` with u(k) for its member k + 1";
                return Err(self.other(&message, Some(help), step.span));
            }
            order = order.max(step.shift);
        }
        if let Some(fault) = well_founded::fault(&equations) {
            self.faults.push(fault);
            return Err(Reported);
        }
        if names.len() == 1 && order == 1 {
            equations.sort_by_key(|e| e.index.is_some());
            let both: Option<[Equation; 2]> = equations.try_into().ok();
            return Ok(both
                .into_iter()
                .filter_map(|[first, step]| {
                    Some(Item::Define {
                        name: step.name,
                        initial: first.value,
                        index: step.index?,
                        step: step.value,
                        span,
                    })
                })
                .collect());
        }
        for equation in &equations {
            if !self.values.exist_in_recurrence(&equation.value, &names, equation.index.as_ref()) {
                self.faults.push(no_value(equation));
                return Err(Reported);
            }
        }
        let families = names.iter().map(|name| {
            let index = Name { text: "k".to_string(), span: name.span };
            (name.clone(), Some(equations.iter().find_map(|e| e.index.clone()).unwrap_or(index)))
        });
        let binding = Binding::new(families.collect(), false, Vec::new(), span);
        let mut out = vec![Item::Given(vec![binding])];
        out.extend(equations.into_iter().map(|e| Item::Assume { label: None, prop: e.written() }));
        Ok(out)
    }

    /// `u(0) = A`, `u(k + 2) = B`
    fn recurrence(&mut self, names: &[Name]) -> Parsed<Equation> {
        let start = self.span().start;
        let name = self.name("the name of the sequence")?;
        if !names.contains(&name) {
            let message = "a definition by recurrence reads `u(0) = …, u(k + 1) = …`";
            return Err(self.other(message, None, name.span));
        }
        self.need_sign("(", "after the name")?;
        let mut index = None;
        if !matches!(self.peek(), Kind::Number(_)) {
            index = Some(self.name("the index name")?);
            if !self.sign("+") {
                let help = "write the step for the next member: `u(k + 1) = 2*u(k)`".to_string();
                return Err(self.expected_with("`+` and how far on the next member is", Some(help)));
            }
        }
        let shift = match self.peek() {
            Kind::Number(text) => text.parse::<usize>().ok(),
            _ => None,
        };
        let Some(shift) = shift.filter(|k| *k <= ORDER_LIMIT && (index.is_none() || *k > 0)) else {
            return Err(self.expected("a whole number: the step defines a member by those before it"));
        };
        self.advance();
        self.need_sign(")", "after the index")?;
        self.need_sign("=", "before the value")?;
        let value = self.expr()?;
        Ok(Equation { name, index, shift, value, span: self.since(start) })
    }
}

/// The fault of an equation whose right side may have no value: as a hypothesis it would say more than a definition does.
fn no_value(equation: &Equation) -> Diagnostic {
    let name = &equation.name.text;
    let message = format!("a member of {name} may have no value by this definition");
    let help = format!(
        "a divisor must be positive by its form; or declare the sequence, `given {name}(k) real`, and assume its equations and \
         that the divisors are not 0"
    );
    Diagnostic::new(Fault::Other { message, help: Some(help) }, equation.value.span)
}

impl Equation {
    /// How much is added to the index, or the index of the first value; at most [`ORDER_LIMIT`].
    pub(super) fn last(&self) -> i64 {
        i64::try_from(self.shift).unwrap_or(i64::MAX)
    }

    fn index_name(&self) -> &str {
        self.index.as_ref().map_or("k", |index| &index.text)
    }

    /// The equation as a hypothesis.
    fn written(self) -> Prop {
        let span = self.span;
        let at = |kind: ExprKind| Expr { kind, span };
        let shift = at(ExprKind::Number(self.shift.to_string()));
        let member = |index: Expr| at(ExprKind::Apply(self.name.clone(), vec![index]));
        let says =
            |left: Expr| Prop { kind: PropKind::Compare(vec![left, self.value.clone()], vec![Relation::Equal]), span };
        match &self.index {
            None => says(member(shift)),
            Some(index) => {
                let k = at(ExprKind::Name(index.text.clone()));
                let body = says(member(at(ExprKind::Sum(vec![(Sign::Plus, k), (Sign::Plus, shift)]))));
                let binding = Binding::new(vec![(index.clone(), None)], true, Vec::new(), span);
                Prop { kind: PropKind::ForAll(vec![binding], Box::new(body)), span }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::claim::parse::parse;

    #[test]
    fn a_recurrence_without_a_value_becomes_a_hypothesis() {
        let read = |given: &str, step: &str| {
            let text =
                format!("claim c \"t\"\n{given}\ndefine u by u(0) = 1, u(1) = 2, u(k + 2) = {step}\nprove u(0) = 1\n");
            parse(&text).map_err(|faults| faults[0].message())
        };
        for (given, step) in [
            ("given M, m > 0", "(M - m)/(M + m)*u(k) + u(k + 1)^2/3"),
            ("given x real; c(k) > 0", "u(k)/(x^2 + 1) + x/c(k + 1) - u(k)/(-2)"),
            ("given n natural", "u(k)/(k + 1) + sqrt(k*n) + ln(2*k + 3) + 2^k + u(k + 1)/(k + 1)^2"),
            ("given theta real", "2*cos(theta)*u(k + 1) - exp(u(k))/cosh(u(k)) + abs(u(k))"),
            ("given q natural", "sum(i = 0..k, u(i))/(q^2 + 1/2)"),
        ] {
            assert!(read(given, step).is_ok(), "{given}; {step}: {:?}", read(given, step));
        }
        for (given, step) in [
            ("given x real", "1/u(k)"),
            ("given x real", "u(k)/x"),
            ("given x > 0", "u(k)/(x - 1)"),
            ("given x > 0", "u(k)/k"),
            ("given x > 0", "sqrt(u(k))"),
            ("given x real", "ln(x^2)"),
            ("given x real", "u(k)^(-1)"),
            ("given x real", "u(k)^x"),
            ("given x real; c(k) real", "u(k)/c(k)"),
            ("given n natural; c(k) > 0 for k in 0..n", "c(k)"),
            ("given x real\nlet f(t) = 1/t", "f(u(k))"),
            ("given x real", "sum(i = 2..k, u(i))"),
        ] {
            let found = read(given, step);
            assert!(
                found.as_ref().is_err_and(|message| message.contains("may have no value")),
                "{given}; {step}: {found:?}"
            );
        }
        // One sequence by the member before is a declaration, which the kernel asks for its values.
        assert!(parse("claim c \"t\"\ndefine u by u(0) = 1, u(k + 1) = 1/u(k)\nprove u(0) = 1\n").is_ok());
    }
}
