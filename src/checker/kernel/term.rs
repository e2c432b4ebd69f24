//! Expressions as fractions in atoms, by their form alone.
//!
//! Contract: wherever an expression has a value, its fraction has the same value. Nothing is known of signs here:
//! whether the expression has a value is asked in [`super::defined`]. So `x/x` is the fraction 1, and whoever states
//! `x/x = 1` has to show that x is not 0.
//! Matrices, powers, sums over an index, derivatives and replacements have files of their own.

use super::fraction::{Fraction, Poly};
use super::integral::Integral;
use super::known::{Equation, Known, Written};
use super::matrix::{each, sizes};
use super::substitution::{DEPTH_LIMIT, NODES_LIMIT};
use super::{Checker, Reason, Refusal, rejected};
use crate::claim::syntax::*;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Zero;
use std::collections::BTreeSet;
use std::rc::Rc;

/// What a fraction is made of: a number that has a meaning of its own.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Atom {
    /// A variable.
    Variable(String),
    /// The variable of a limit inside it: another one than outside.
    Growing(String),
    /// The index of a sum or product: a natural number ([`super::binder`]).
    Bound(usize),
    /// The variable of an integral: a real number.
    Real(usize),
    /// A member of a family or sequence.
    Member(String, Poly),
    /// A sum or product over `Bound(own)`.
    Over(Over),
    /// An integral over `Real(own)`.
    Integral(Integral),
    /// b^E where E is not a whole number.
    Power(Fraction, Fraction),
    /// exp of a fraction other than 0.
    Exponential(Fraction),
    /// ln of a fraction other than 1.
    Logarithm(Fraction),
    /// π.
    Pi,
    /// cos of a fraction.
    Cosine(Fraction),
    /// sin of a fraction.
    Sine(Fraction),
    /// arcsin of a fraction with positive coefficient.
    Arcsine(Fraction),
    /// arctan of a fraction with positive coefficient.
    Arctangent(Fraction),
}

impl Atom {
    /// The atoms that it is made of.
    pub(super) fn parts(&self) -> Vec<usize> {
        match self {
            Atom::Variable(_) | Atom::Growing(_) | Atom::Bound(_) | Atom::Real(_) | Atom::Pi => Vec::new(),
            Atom::Member(_, index) => index.atoms().collect(),
            Atom::Over(over) => over.from.atoms().chain(over.to.atoms()).chain(over.body.atoms()).collect(),
            Atom::Integral(i) => i.from.atoms().chain(i.to.atoms()).chain(i.body.atoms()).collect(),
            Atom::Power(base, exponent) => base.atoms().chain(exponent.atoms()).collect(),
            Atom::Exponential(inner)
            | Atom::Logarithm(inner)
            | Atom::Cosine(inner)
            | Atom::Sine(inner)
            | Atom::Arcsine(inner)
            | Atom::Arctangent(inner) => inner.atoms().collect(),
        }
    }
}

/// A sum or product over an index.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Over {
    /// A sum, else a product.
    pub(super) sum: bool,
    /// The number of its index.
    pub(super) own: usize,
    /// Its least value.
    pub(super) from: Poly,
    /// Its greatest value.
    pub(super) to: Poly,
    /// What is added or multiplied.
    pub(super) body: Fraction,
}

/// A number, or a matrix of them.
pub(super) enum Value {
    /// A number.
    Scalar(Fraction),
    /// Rows of equal length, at least one.
    Matrix(Vec<Vec<Fraction>>),
}

impl Checker {
    /// The number of an atom.
    pub(super) fn intern(&mut self, atom: Atom) -> usize {
        if let Some(place) = self.atom_index.get(&atom) {
            return *place;
        }
        let place = self.atoms.len();
        let mut occur: Vec<usize> = Vec::new();
        for inner in atom.parts() {
            occur.extend(self.occurring.get(inner).into_iter().flatten());
        }
        occur.push(place);
        occur.sort_unstable();
        occur.dedup();
        self.work.spend(occur.len());
        self.occurring.push(occur);
        self.heights.push(self.height_of(&atom));
        self.atoms.push(atom.clone());
        self.atom_index.insert(atom, place);
        place
    }

    /// The atom, or what equals it by the equations of the step that is read.
    pub(super) fn atom_fraction(&mut self, atom: Atom) -> Fraction {
        let place = self.intern(atom);
        let equals = |equation: &Equation| equation.atom.as_ref().filter(|a| a.0 == place).map(|a| a.1.clone());
        self.put_in_by(&equals).unwrap_or_else(|| Fraction::atom(place))
    }

    /// What the first equation gives for which there is something.
    fn put_in_by(&mut self, equals: &dyn Fn(&Equation) -> Option<Fraction>) -> Option<Fraction> {
        let (value, equation) = self.put_in.iter().find_map(|equation| Some((equals(equation)?, equation)))?;
        self.were_put_in.extend(&equation.rests_on);
        Some(value)
    }

    /// The power or exponential that an expression is, if its exponent is not a numeral like 2.
    pub(super) fn written(&mut self, e: &Expr) -> Result<Option<Written>, Refusal> {
        self.written_in(e, DEPTH_LIMIT)
    }

    fn written_in(&mut self, e: &Expr, depth: usize) -> Result<Option<Written>, Refusal> {
        let power = |base: Fraction, exponent: Fraction| {
            exponent.as_integer().is_none().then_some(Written::Power(base, exponent))
        };
        Ok(match &e.kind {
            ExprKind::Power(base, exponent) => power(self.scalar_in(base, depth)?, self.scalar_in(exponent, depth)?),
            ExprKind::Apply(function, arguments) => match (function.text.as_str(), arguments.as_slice()) {
                ("sqrt", [x]) => power(self.scalar_in(x, depth)?, Fraction::integer(2).power(-1)?),
                ("cbrt", [x]) => power(self.scalar_in(x, depth)?, Fraction::integer(3).power(-1)?),
                ("exp", [x]) => Some(Written::Exponential(self.scalar_in(x, depth)?)),
                _ => None,
            },
            _ => None,
        })
    }

    /// What an expression equals by an equation whose left side is this power or exponential.
    fn put_in_for(&mut self, e: &Expr, depth: usize) -> Result<Option<Fraction>, Refusal> {
        if !self.put_in.iter().any(|equation| equation.power.is_some()) {
            return Ok(None);
        }
        let equations = std::mem::take(&mut self.put_in);
        let written = self.written_in(e, depth);
        self.put_in = equations;
        Ok(match written? {
            Some(written) => self.put_in_written(&written),
            None => None,
        })
    }

    pub(super) fn put_in_written(&mut self, written: &Written) -> Option<Fraction> {
        self.put_in_by(&|equation| equation.power.as_ref().filter(|p| p.0 == *written).map(|p| p.1.clone()))
    }

    /// Runs something that reads expressions with the equations of a step put in: what equals something else by them
    /// is written so from the start, which keeps common factors apart.
    fn with_put_in<T>(
        &mut self,
        known: &Known,
        run: impl FnOnce(&mut Checker) -> Result<T, Refusal>,
    ) -> Result<T, Refusal> {
        self.put_in = known.equations();
        let result = run(self);
        self.put_in = Rc::new(Vec::new());
        known.mark_put_in(std::mem::take(&mut self.were_put_in));
        result
    }

    /// An expression that is a number, with the equations put in, and the places of those that were.
    pub(super) fn put_into(&mut self, e: &Expr, known: &Known) -> Result<(Fraction, BTreeSet<usize>), Refusal> {
        self.put_in = known.equations();
        let result = self.fraction(e);
        self.put_in = Rc::new(Vec::new());
        let places = std::mem::take(&mut self.were_put_in);
        Ok((result?, places))
    }

    /// An expression that is a number, with the equations put in.
    pub(super) fn fraction_with(&mut self, e: &Expr, known: &Known) -> Result<Fraction, Refusal> {
        self.with_put_in(known, |checker| checker.fraction(e))
    }

    /// An expression, with the equations put in.
    pub(super) fn value_with(&mut self, e: &Expr, known: &Known) -> Result<Value, Refusal> {
        self.with_put_in(known, |checker| checker.value(e))
    }

    /// An expression that is a number.
    pub(super) fn fraction(&mut self, e: &Expr) -> Result<Fraction, Refusal> {
        self.scalar_in(e, DEPTH_LIMIT)
    }

    pub(super) fn scalar_in(&mut self, e: &Expr, depth: usize) -> Result<Fraction, Refusal> {
        match self.value_in(e, depth)? {
            Value::Scalar(fraction) => Ok(fraction),
            Value::Matrix(_) => rejected(Reason::MatrixForNumber),
        }
    }

    /// An expression.
    pub(super) fn value(&mut self, e: &Expr) -> Result<Value, Refusal> {
        self.value_in(e, DEPTH_LIMIT)
    }

    fn value_in(&mut self, e: &Expr, depth: usize) -> Result<Value, Refusal> {
        let Some(depth) = depth.checked_sub(1) else { return Err(Refusal::Limit("depth")) };
        if matches!(e.kind, ExprKind::Number(_) | ExprKind::Name(_)) {
            return self.value_of(e, depth);
        }
        let (binders, scope) = (self.binders, self.scope.len());
        if binders == 0
            && let Some((value, places)) = self.memo.entries(scope, &self.put_in).and_then(|m| m.get(e))
        {
            self.were_put_in.extend(places.iter());
            self.work.count(value.size())?;
            return Ok(Value::Scalar(value.clone()));
        }
        let before = std::mem::take(&mut self.were_put_in);
        let value = self.value_of(e, depth);
        let places = std::mem::replace(&mut self.were_put_in, before);
        self.were_put_in.extend(&places);
        let value = value?;
        if let (0, Value::Scalar(f)) = (binders, &value)
            && let Some(entries) = self.memo.entries(scope, &self.put_in)
        {
            entries.insert(e.clone(), (f.clone(), Rc::new(places)));
        }
        // Whatever was copied on the way is not much longer than what comes of it.
        self.work.count(match &value {
            Value::Scalar(f) => f.size(),
            Value::Matrix(rows) => rows.iter().flatten().map(Fraction::size).sum(),
        })?;
        Ok(value)
    }

    fn value_of(&mut self, e: &Expr, depth: usize) -> Result<Value, Refusal> {
        if let Some(value) = self.put_in_for(e, depth)? {
            return Ok(Value::Scalar(value));
        }
        let fraction = match &e.kind {
            ExprKind::Number(text) => {
                let number = numeral(text)?;
                let bits = number.numer().bits().max(number.denom().bits());
                // Powers of 10 take about as long as they have digits.
                self.work.count(usize::try_from(bits).unwrap_or(usize::MAX))?;
                Fraction::number(number)
            }
            ExprKind::Name(name) => match self.scope.iter().rev().find(|v| v.name == *name) {
                Some(variable) => {
                    let atom = variable.atom.clone();
                    self.atom_fraction(atom)
                }
                None if name == PI && !self.is_declared(PI) => self.atom_fraction(Atom::Pi),
                None => return rejected(Reason::Undeclared(name.clone())),
            },
            ExprKind::Apply(function, arguments) => return self.apply_function(function, arguments, depth),
            ExprKind::Negate(a) => match self.value_in(a, depth)? {
                Value::Scalar(f) => f.negated(),
                Value::Matrix(rows) => return Ok(Value::Matrix(each(&rows, &mut |f| Ok(f.negated()))?)),
            },
            ExprKind::Sum(list) => return self.sum(list, depth),
            ExprKind::Product(list) => return self.product(list, depth),
            ExprKind::Power(base, exponent) => {
                let b = self.scalar_in(base, depth)?;
                let e = self.exponent_in(exponent, depth)?;
                self.power(&b, &e)?
            }
            ExprKind::SumOver(index, body) => self.over(true, index, body, depth)?,
            ExprKind::ProductOver(index, body) => self.over(false, index, body, depth)?,
            ExprKind::IntegralOver(variable, body) => self.integral(variable, body, depth)?,
            ExprKind::Derivative(body, by) => {
                // An equation holds at the point, not around it: it is put in when the derivative is taken.
                let put_in = std::mem::take(&mut self.put_in);
                let mut f = self.scalar_in(body, depth)?;
                for name in by {
                    f = self.derivative(&f, &name.text, depth)?;
                }
                let (f, places) = self.all_replaced(&f, &put_in)?;
                self.were_put_in.extend(places);
                self.put_in = put_in;
                f
            }
            ExprKind::Matrix(rows) => {
                let mut out = Vec::new();
                for row in rows {
                    out.push(row.iter().map(|e| self.scalar_in(e, depth)).collect::<Result<Vec<_>, _>>()?);
                }
                return Ok(Value::Matrix(out));
            }
        };
        Ok(Value::Scalar(fraction))
    }

    /// An exponent. Where the equations would make another number of a whole one by its form, they are not put in: the
    /// base of a whole power may be negative, that of another may not.
    fn exponent_in(&mut self, e: &Expr, depth: usize) -> Result<Fraction, Refusal> {
        let replaced = self.scalar_in(e, depth)?;
        if self.put_in.is_empty() || self.is_whole(&replaced)? {
            return Ok(replaced);
        }
        let put_in = std::mem::take(&mut self.put_in);
        let plain = self.scalar_in(e, depth);
        self.put_in = put_in;
        let plain = plain?;
        Ok(if self.is_whole(&plain)? { plain } else { replaced })
    }

    fn sum(&mut self, list: &[(Sign, Expr)], depth: usize) -> Result<Value, Refusal> {
        let mut scalars = Vec::new();
        let mut matrices = Vec::new();
        for (sign, e) in list {
            match (sign, self.value_in(e, depth)?) {
                (Sign::Plus, Value::Scalar(f)) => scalars.push(f),
                (Sign::Minus, Value::Scalar(f)) => scalars.push(f.negated()),
                (Sign::Plus, Value::Matrix(rows)) => matrices.push(rows),
                (Sign::Minus, Value::Matrix(rows)) => matrices.push(each(&rows, &mut |f| Ok(f.negated()))?),
            }
        }
        let Some(first) = matrices.first() else {
            return Ok(Value::Scalar(Fraction::sum(&scalars, &self.work)?));
        };
        if !scalars.is_empty() || matrices.iter().any(|m| sizes(m) != sizes(first)) {
            return rejected(Reason::MatrixSizes);
        }
        let mut out = Vec::new();
        for (i, row) in first.iter().enumerate() {
            let mut sums = Vec::new();
            for j in 0..row.len() {
                let entries: Vec<Fraction> =
                    matrices.iter().filter_map(|m| m.get(i).and_then(|r| r.get(j)).cloned()).collect();
                sums.push(Fraction::sum(&entries, &self.work)?);
            }
            out.push(sums);
        }
        Ok(Value::Matrix(out))
    }

    fn product(&mut self, list: &[(Factor, Expr)], depth: usize) -> Result<Value, Refusal> {
        let mut out = Value::Scalar(Fraction::integer(1));
        for (factor, e) in list {
            let next = match (factor, self.value_in(e, depth)?) {
                (Factor::Times, value) => value,
                (Factor::Over, Value::Scalar(divisor)) => Value::Scalar(divisor.power(-1)?),
                (Factor::Over, Value::Matrix(_)) => return rejected(Reason::MatrixForNumber),
            };
            out = match (out, next) {
                (Value::Scalar(mut a), Value::Scalar(b)) => {
                    a.multiply(&b, &self.work)?;
                    Value::Scalar(a)
                }
                (Value::Scalar(a), Value::Matrix(rows)) | (Value::Matrix(rows), Value::Scalar(a)) => {
                    Value::Matrix(each(&rows, &mut |f| f.times(&a, &self.work))?)
                }
                (Value::Matrix(a), Value::Matrix(b)) => Value::Matrix(self.matrix_product(&a, &b)?),
            };
        }
        Ok(out)
    }

    fn apply_function(&mut self, function: &Name, arguments: &[Expr], depth: usize) -> Result<Value, Refusal> {
        let [argument] = arguments else { return rejected(Reason::Arguments(function.text.clone())) };
        let name = function.text.as_str();
        if self.is_member(name) {
            let x = self.scalar_in(argument, depth)?;
            let index = self.whole(&x)?;
            return Ok(Value::Scalar(self.atom_fraction(Atom::Member(name.to_string(), index))));
        }
        if matches!(name, "det" | "transpose") {
            let Value::Matrix(rows) = self.value_in(argument, depth)? else {
                return rejected(Reason::NumberForMatrix);
            };
            if name == "det" {
                return Ok(Value::Scalar(self.determinant(&rows)?));
            }
            let columns = (0..sizes(&rows).1).map(|j| rows.iter().filter_map(|r| r.get(j).cloned()).collect());
            return Ok(Value::Matrix(columns.collect()));
        }
        let x = self.scalar_in(argument, depth)?;
        let part = |k: i64| Fraction::integer(k).power(-1);
        Ok(Value::Scalar(match name {
            "sqrt" => self.power(&x, &part(2)?)?,
            "cbrt" => self.power(&x, &part(3)?)?,
            "exp" => self.exponential(&x)?,
            "ln" => self.logarithm(&x)?,
            "cos" => self.cosine_and_sine(&x)?.0,
            "sin" => self.cosine_and_sine(&x)?.1,
            "arcsin" | "arccos" | "arctan" => self.arc(name, &x)?,
            "cosh" | "sinh" | "sech" | "tanh" => self.hyperbolic(name, argument, &x, depth)?,
            _ => return rejected(Reason::Undeclared(name.to_string())),
        }))
    }

    /// Whether an atom is a natural number by what it is.
    pub(super) fn is_natural_atom(&self, place: usize) -> bool {
        match self.atoms.get(place) {
            Some(Atom::Bound(_)) => true,
            Some(atom @ (Atom::Variable(_) | Atom::Growing(_))) => {
                self.scope.iter().any(|v| v.atom == *atom && v.natural)
            }
            Some(Atom::Member(name, _)) => self.family(name).is_some_and(|f| f.natural),
            _ => false,
        }
    }
}

/// A numeral as written: digits, perhaps with a point and a decimal exponent.
pub fn numeral(text: &str) -> Result<BigRational, Refusal> {
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse::<i32>().ok()),
        None => (text, Some(0)),
    };
    let (whole, part) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = format!("{whole}{part}");
    let unreadable = || Refusal::Rejected(Reason::Numeral(text.chars().take(20).collect()));
    let exponent = exponent.and_then(|e| e.checked_sub(i32::try_from(part.len()).ok()?)).ok_or_else(unreadable)?;
    if digits.len() > 10_000 || exponent.unsigned_abs() > 20_000 || digits.len() > NODES_LIMIT {
        return Err(Refusal::Limit("digits of a numeral"));
    }
    if digits.is_empty() || !digits.bytes().all(|b| b.is_ascii_digit()) {
        return Err(unreadable());
    }
    let number = digits.parse::<BigInt>().map_err(|_| unreadable())?;
    if number.is_zero() {
        return Ok(BigRational::zero());
    }
    let power = BigInt::from(10).pow(exponent.unsigned_abs());
    // The denominator is a power of 10, never 0.
    Ok(if exponent < 0 { BigRational::new(number, power) } else { BigRational::from_integer(number * power) })
}
