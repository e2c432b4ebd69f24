//! The dimensions of expressions.

use super::super::{print, trigonometry, walk};
use super::size::{Equated, Size, Unknowns};
use super::{DEPTH_LIMIT, Mismatch, STEPS_LIMIT, Stop};
use crate::claim::syntax::*;
use carom_unit::Exponent;
use std::collections::{BTreeMap, BTreeSet};

/// A dimension, or nothing where it is not looked at: matrices may have entries of several.
pub(super) type Found = Result<Option<Size>, Stop>;

/// What a name stands for.
#[derive(Clone)]
pub(super) enum Meaning<'c> {
    /// A variable, a family or a sequence; nothing for a matrix.
    Quantity(Option<Size>),
    /// A definition with parameters, looked at where it is used.
    Function(&'c [Name], &'c Expr),
}

/// The dimensions of a claim's names, and the equations between them.
#[derive(Default)]
pub(super) struct Checker<'c> {
    pub unknowns: Unknowns,
    pub names: BTreeMap<String, Meaning<'c>>,
    /// Names of numbers that definitions give: `let p = 1/2`.
    pub constants: BTreeMap<String, Exponent>,
    /// The names whose unit a declaration says.
    pub declared: BTreeSet<String>,
    /// Powers with an exponent that varies: where, of what, and their dimension. It is that of a number if the base is one.
    powers: Vec<(&'c Expr, Size, Size)>,
    steps: usize,
    depth: usize,
}

/// Functions of numbers, whose values are numbers.
const OF_NUMBERS: &[&str] = &[
    "exp",
    "ln",
    "cosh",
    "sinh",
    "tanh",
    "sech",
    "sin",
    "cos",
    "tan",
    "arcsin",
    "arccos",
    "arctan",
    "factorial",
    "binomial",
    "floor",
    "ceil",
];

impl<'c> Checker<'c> {
    /// Counts a step, one level deeper.
    fn deeper(&mut self, span: Span) -> Result<(), Stop> {
        self.steps += 1;
        self.depth += 1;
        if self.steps > STEPS_LIMIT {
            return Err(Stop::Limit("steps of the check of dimensions", STEPS_LIMIT, span));
        }
        if self.depth > DEPTH_LIMIT {
            return Err(Stop::Limit("levels of nesting in the check of dimensions", DEPTH_LIMIT, span));
        }
        Ok(())
    }

    /// The dimension of an expression.
    pub(super) fn of(&mut self, e: &'c Expr) -> Found {
        self.deeper(e.span)?;
        let out = match &e.kind {
            ExprKind::Number(text) => {
                let is_zero =
                    text.split(['e', 'E']).next().is_some_and(|digits| digits.chars().all(|c| "0.".contains(c)));
                Ok(Some(if is_zero { self.unknowns.fresh(None) } else { Size::number() }))
            }
            ExprKind::Name(name) => Ok(self.name(name)),
            ExprKind::Apply(name, arguments) => self.apply(e, name, arguments),
            ExprKind::Negate(a) => self.of(a),
            ExprKind::Sum(list) => self.sum(e, list),
            ExprKind::Product(list) => self.product(e.span, list),
            ExprKind::Power(base, exponent) => self.power(e, base, exponent),
            ExprKind::SumOver(index, body) => self.over(e, index, body, false),
            ExprKind::ProductOver(index, body) => self.over(e, index, body, true),
            ExprKind::IntegralOver(variable, body) => self.integral(e, variable, body),
            ExprKind::Derivative(body, by) => self.derivative(e.span, body, by),
            ExprKind::Matrix(rows) => {
                rows.iter().flatten().try_for_each(|entry| self.of(entry).map(drop)).map(|()| None)
            }
        };
        self.depth -= 1;
        out
    }

    /// The dimension of a name; one that nothing declares, such as `infinity`, gets any.
    fn name(&mut self, name: &str) -> Option<Size> {
        match self.names.get(name) {
            Some(Meaning::Quantity(size)) => size.clone(),
            Some(Meaning::Function(..)) => None,
            None if name == PI => Some(Size::number()),
            None => Some(self.unknowns.fresh(Some(name))),
        }
    }

    fn sum(&mut self, whole: &'c Expr, list: &'c [(Sign, Expr)]) -> Found {
        let mut first: Option<(&Expr, Size)> = None;
        let mut is_open = false;
        for (_, summand) in list {
            let Some(size) = self.of(summand)? else {
                is_open = true;
                continue;
            };
            match &first {
                Some((other, own)) => self.alike(whole, (other, own), (summand, &size))?,
                None => first = Some((summand, size)),
            }
        }
        Ok(first.map(|first| first.1).filter(|_| !is_open))
    }

    fn product(&mut self, span: Span, list: &'c [(Factor, Expr)]) -> Found {
        let mut out = Some(Size::number());
        for (operator, factor) in list {
            let power = if *operator == Factor::Times { Exponent::ONE } else { Exponent::whole(-1) };
            out = match (out, self.of(factor)?) {
                (Some(out), Some(size)) => Some(fits(out.times(&size, power), span)?),
                _ => None,
            };
        }
        Ok(out)
    }

    fn power(&mut self, whole: &'c Expr, base: &'c Expr, exponent: &'c Expr) -> Found {
        let base = self.of(base)?;
        let size = self.of(exponent)?;
        self.is_number(whole, exponent, size.as_ref(), "an exponent")?;
        match (base, self.constant(exponent)) {
            (None, _) => Ok(None),
            (Some(base), Some(power)) => fits(base.to(power), whole.span).map(Some),
            (Some(base), None) => Ok(Some(self.varying(whole, base))),
        }
    }

    /// A power of which only this is known: it is a number if its base is.
    fn varying(&mut self, whole: &'c Expr, base: Size) -> Size {
        if self.unknowns.resolved(&base).is_some_and(|base| base.is_number()) {
            return Size::number();
        }
        let out = self.unknowns.fresh(None);
        self.powers.push((whole, base, out.clone()));
        out
    }

    /// Powers whose base turned out to be a number are numbers.
    pub(super) fn settle(&mut self) -> Result<(), Stop> {
        loop {
            let is_settled =
                |(_, base, _): &(&Expr, Size, Size)| self.unknowns.resolved(base).is_some_and(|base| base.is_number());
            let Some(place) = self.powers.iter().position(is_settled) else { return Ok(()) };
            let (whole, _, size) = self.powers.remove(place);
            self.is_number(whole, whole, Some(&size), "a power of a number")?;
        }
    }

    fn over(&mut self, whole: &'c Expr, index: &'c Index, body: &'c Expr, multiplies: bool) -> Found {
        for bound in [&index.from, &index.to] {
            let size = self.of(bound)?;
            self.is_number(whole, bound, size.as_ref(), "an index")?;
        }
        let number = Meaning::Quantity(Some(Size::number()));
        let before = self.names.insert(index.name.text.clone(), number);
        let size = self.of(body);
        self.restore(&index.name.text, before);
        let Some(size) = size? else { return Ok(None) };
        if !multiplies {
            return Ok(Some(size));
        }
        let ends = self.constant(&index.from).and_then(Exponent::negated).zip(self.constant(&index.to));
        match ends.and_then(|(from, to)| to.plus(from)?.plus(Exponent::ONE)) {
            Some(count) => fits(size.to(count), whole.span).map(Some),
            None => Ok(Some(self.varying(whole, size))),
        }
    }

    /// The variable has the dimension of both ends; the integral has that of the integrand times it.
    fn integral(&mut self, whole: &'c Expr, variable: &'c Index, body: &'c Expr) -> Found {
        let (from, to) = (self.of(&variable.from)?, self.of(&variable.to)?);
        if let (Some(from), Some(to)) = (&from, &to) {
            self.alike(whole, (&variable.from, from), (&variable.to, to))?;
        }
        let run = from.or(to);
        let before = self.names.insert(variable.name.text.clone(), Meaning::Quantity(run.clone()));
        let size = self.of(body);
        self.restore(&variable.name.text, before);
        match (size?, run) {
            (Some(size), Some(run)) => fits(size.times(&run, Exponent::ONE), whole.span).map(Some),
            _ => Ok(None),
        }
    }

    /// Gives a name back the meaning that it had before.
    pub(super) fn restore(&mut self, name: &str, before: Option<Meaning<'c>>) {
        match before {
            Some(before) => self.names.insert(name.to_string(), before),
            None => self.names.remove(name),
        };
    }

    fn derivative(&mut self, span: Span, body: &'c Expr, by: &'c [Name]) -> Found {
        let mut out = self.of(body)?;
        for name in by {
            out = match (out, self.name(&name.text)) {
                (Some(out), Some(size)) => Some(fits(out.times(&size, Exponent::whole(-1)), span)?),
                _ => None,
            };
        }
        Ok(out)
    }

    fn apply(&mut self, whole: &'c Expr, name: &'c Name, arguments: &'c [Expr]) -> Found {
        match self.names.get(&name.text).cloned() {
            Some(Meaning::Function(parameters, body)) => return self.call(parameters, body, arguments),
            Some(Meaning::Quantity(size)) => {
                for argument in arguments {
                    let index = self.of(argument)?;
                    self.is_number(whole, argument, index.as_ref(), "an index")?;
                }
                return Ok(size);
            }
            None => {}
        }
        let word = name.text.as_str();
        let mut sizes = Vec::new();
        for argument in arguments {
            sizes.push(self.of(argument)?);
        }
        if OF_NUMBERS.contains(&word) || trigonometry::is_function(word) {
            for (argument, size) in arguments.iter().zip(&sizes) {
                self.is_number(whole, argument, size.as_ref(), &format!("the argument of {word}"))?;
            }
            return Ok(Some(Size::number()));
        }
        let first = sizes.first().cloned().flatten();
        let power = |above: i128, below: i128| Exponent::new(above, below).unwrap_or(Exponent::ONE);
        match (word, first) {
            ("sqrt", Some(size)) => fits(size.to(power(1, 2)), whole.span).map(Some),
            ("cbrt", Some(size)) => fits(size.to(power(1, 3)), whole.span).map(Some),
            ("abs", size) => Ok(size),
            ("max" | "min", Some(size)) => {
                for (argument, other) in arguments.iter().zip(&sizes).skip(1) {
                    if let (Some(left), Some(other)) = (arguments.first(), other) {
                        self.alike(whole, (left, &size), (argument, other))?;
                    }
                }
                Ok(Some(size))
            }
            _ => Ok(None),
        }
    }

    /// A definition where it is used.
    fn call(&mut self, parameters: &'c [Name], body: &'c Expr, arguments: &'c [Expr]) -> Found {
        let mut values = Vec::new();
        for argument in arguments {
            values.push(Meaning::Quantity(self.of(argument)?));
        }
        let mut before = Vec::new();
        for (parameter, value) in parameters.iter().zip(values) {
            before.push((&parameter.text, self.names.insert(parameter.text.clone(), value)));
        }
        let out = self.of(body);
        before.into_iter().for_each(|(name, meaning)| self.restore(name, meaning));
        out
    }

    /// The number that an expression of numerals alone is.
    pub(super) fn constant(&self, e: &Expr) -> Option<Exponent> {
        match &e.kind {
            ExprKind::Number(text) => {
                let (whole, tail) = text.split_once('.').unwrap_or((text, ""));
                let below = 10i128.checked_pow(u32::try_from(tail.len()).ok()?)?;
                Exponent::new(format!("{whole}{tail}").parse().ok()?, below)
            }
            ExprKind::Name(name) => self.constants.get(name).copied(),
            ExprKind::Negate(a) => self.constant(a)?.negated(),
            ExprKind::Sum(list) => list.iter().try_fold(Exponent::ZERO, |sum, (sign, e)| {
                let value = self.constant(e)?;
                sum.plus(if *sign == Sign::Plus { value } else { value.negated()? })
            }),
            ExprKind::Product(list) => list.iter().try_fold(Exponent::ONE, |product, (operator, e)| {
                let value = self.constant(e)?;
                if *operator == Factor::Times { product.times(value) } else { product.over(value) }
            }),
            _ => None,
        }
    }

    /// Two parts of a sum or a comparison have one dimension.
    pub(super) fn alike(&mut self, whole: &Expr, left: (&Expr, &Size), right: (&Expr, &Size)) -> Result<(), Stop> {
        self.equal(&print::expr(whole), whole.span, left, (&print::expr(right.0), right.1))
    }

    /// A part is a number.
    pub(super) fn is_number(&mut self, whole: &Expr, part: &Expr, size: Option<&Size>, role: &str) -> Result<(), Stop> {
        let Some(size) = size else { return Ok(()) };
        self.equal(&print::expr(whole), whole.span, (part, size), (role, &Size::number()))
    }

    pub(super) fn equal(
        &mut self,
        subterm: &str,
        span: Span,
        left: (&Expr, &Size),
        right: (&str, &Size),
    ) -> Result<(), Stop> {
        match self.unknowns.equate(left.1, right.1) {
            Equated::Holds => Ok(()),
            Equated::TooLong => Err(too_long(span)),
            Equated::Fails => {
                let mut names = BTreeSet::new();
                walk::names_in(left.0, &mut names);
                let inferred = names.iter().filter(|name| !self.declared.contains(*name)).filter_map(|name| match self
                    .names
                    .get(name)?
                {
                    Meaning::Quantity(Some(size)) => Some((name.clone(), self.unknowns.printed(size))),
                    _ => None,
                });
                Err(Stop::Differ(Box::new(Mismatch {
                    subterm: subterm.to_string(),
                    span,
                    left: print::expr(left.0),
                    left_dimension: self.unknowns.printed(left.1),
                    right: right.0.to_string(),
                    right_dimension: self.unknowns.printed(right.1),
                    inferred: inferred.filter(|(_, dimension)| dimension != "1").collect(),
                })))
            }
        }
    }
}

/// An exponent within 64 bits.
fn fits(size: Option<Size>, span: Span) -> Result<Size, Stop> {
    size.ok_or_else(|| too_long(span))
}

fn too_long(span: Span) -> Stop {
    Stop::Limit("bits of the exponents of a dimension", 64, span)
}
