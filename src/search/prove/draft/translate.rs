//! Expressions as fractions in atoms, and what must hold for them to have a value.
//!
//! Contract: [`Draft::scalar`] returns a fraction that equals the expression at every point that the
//! facts allow, and only if the expression has a value at all of them: every divisor is shown not to
//! be 0, every base of a power that is not whole and every argument of a logarithm to be positive,
//! every index to be a natural number, every range not to end before it begins.

use super::matrix::{each, sizes};
use super::{Draft, Failure, Replaced, Variable, declined, rejected};
use crate::claim::definedness::{self, Exponent};
use crate::claim::syntax::*;
use crate::kernel::fraction::{Fraction, Poly};
use crate::kernel::order::Signs;
use crate::kernel::substitution::DEPTH_LIMIT;
use crate::kernel::{Refusal, numeral, text};
use num_rational::BigRational;
use num_traits::{One, Zero};

/// What a fraction is made of: a number that has a meaning of its own.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Atom {
    /// A variable.
    Variable(String),
    /// The index of a sum or product, by its depth: a natural number.
    Bound(usize),
    /// A member of a family or sequence.
    Member(String, Poly),
    /// A sum (true) or product over `Bound(depth)` from … to … of a body.
    Over(bool, usize, Poly, Poly, Fraction),
    /// ln of a polynomial that is positive wherever the atom is used.
    Logarithm(Poly),
    /// exp of a fraction.
    Exponential(Fraction),
}

/// The functions that the kernel knows.
pub(crate) const FUNCTIONS: [&str; 10] =
    ["det", "transpose", "sqrt", "cbrt", "exp", "ln", "cosh", "sinh", "sech", "tanh"];

/// A number, or a matrix of them.
pub(crate) enum Value {
    /// A number.
    Scalar(Fraction),
    /// Rows of equal length, at least one.
    Matrix(Vec<Vec<Fraction>>),
}

impl Draft {
    /// The number of an atom.
    pub(super) fn intern(&mut self, atom: Atom) -> usize {
        if let Some(place) = self.atom_index.get(&atom) {
            return *place;
        }
        self.atoms.push(atom.clone());
        self.atom_index.insert(atom, self.atoms.len() - 1);
        self.atoms.len() - 1
    }

    /// What an atom is.
    pub(crate) fn atom(&self, place: usize) -> Option<&Atom> {
        self.atoms.get(place)
    }

    /// The atom, or what it is replaced by.
    pub(crate) fn resolved(&self, place: usize) -> Fraction {
        let Some(replaced) = self.replaced.iter().rev().find(|r| r.atom == place) else {
            return Fraction::atom(place);
        };
        replaced.source.iter().for_each(|source| self.consult(*source));
        replaced.value.clone()
    }

    fn atom_value(&mut self, atom: Atom) -> Fraction {
        self.work.spend(self.replaced.len());
        let place = self.intern(atom);
        self.resolved(place)
    }

    /// An expression that is a number.
    pub(crate) fn scalar(&mut self, e: &Expr) -> Result<Fraction, Failure> {
        match self.value(e, DEPTH_LIMIT)? {
            Value::Scalar(fraction) => Ok(fraction),
            Value::Matrix(_) => rejected("a number is needed where a matrix stands"),
        }
    }

    fn scalar_in(&mut self, e: &Expr, depth: usize) -> Result<Fraction, Failure> {
        match self.value(e, depth)? {
            Value::Scalar(fraction) => Ok(fraction),
            Value::Matrix(_) => rejected("a number is needed where a matrix stands"),
        }
    }

    /// An expression.
    pub(crate) fn value(&mut self, e: &Expr, depth: usize) -> Result<Value, Failure> {
        let Some(depth) = depth.checked_sub(1) else { return declined("depth") };
        let value = self.value_of(e, depth)?;
        // Whatever was copied on the way is not much longer than what comes of it.
        self.work.count(match &value {
            Value::Scalar(f) => f.size(),
            Value::Matrix(rows) => rows.iter().flatten().map(Fraction::size).sum(),
        })?;
        Ok(value)
    }

    fn value_of(&mut self, e: &Expr, depth: usize) -> Result<Value, Failure> {
        let fraction = match &e.kind {
            ExprKind::Number(text) => {
                let number = numeral(text)?;
                // Powers of 10 take about as long as they have digits.
                self.work
                    .count(usize::try_from(number.numer().bits().max(number.denom().bits())).unwrap_or(usize::MAX))?;
                Fraction::number(number)
            }
            ExprKind::Name(name) => {
                if self.variable(name).is_none() {
                    return rejected(&format!("{name} is not declared here"));
                }
                self.atom_value(Atom::Variable(name.clone()))
            }
            ExprKind::Apply(function, arguments) => return self.apply_function(function, arguments, depth),
            ExprKind::Negate(a) => match self.value(a, depth)? {
                Value::Scalar(f) => f.negated(),
                Value::Matrix(rows) => return Ok(Value::Matrix(each(&rows, &mut |f| Ok(f.negated()))?)),
            },
            ExprKind::Sum(list) => return self.sum(list, depth),
            ExprKind::Product(list) => return self.product(list, depth),
            ExprKind::Power(base, exponent) => {
                let b = self.scalar_in(base, depth)?;
                let e = self.scalar_in(exponent, depth)?;
                let kind =
                    definedness::exponent(exponent, &|name| self.is_natural_name(name)).map_err(Refusal::from)?;
                self.raised(&b, &e, kind)?
            }
            ExprKind::SumOver(index, body) => self.over(true, index, body, depth)?,
            ExprKind::ProductOver(index, body) => self.over(false, index, body, depth)?,
            ExprKind::Derivative(body, by) => {
                let mut f = self.scalar_in(body, depth)?;
                for name in by {
                    f = self.derivative(&f, &name.text, depth)?;
                }
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

    fn sum(&mut self, list: &[(Sign, Expr)], depth: usize) -> Result<Value, Failure> {
        let mut values = Vec::new();
        for (sign, e) in list {
            values.push(match (sign, self.value(e, depth)?) {
                (Sign::Plus, value) => value,
                (Sign::Minus, Value::Scalar(f)) => Value::Scalar(f.negated()),
                (Sign::Minus, Value::Matrix(rows)) => Value::Matrix(each(&rows, &mut |f| Ok(f.negated()))?),
            });
        }
        let mut scalars = Vec::new();
        let mut matrices = Vec::new();
        for value in values {
            match value {
                Value::Scalar(f) => scalars.push(f),
                Value::Matrix(rows) => matrices.push(rows),
            }
        }
        let Some(first) = matrices.first() else {
            return Ok(Value::Scalar(Fraction::sum(&scalars, &self.work)?));
        };
        if !scalars.is_empty() || matrices.iter().any(|m| sizes(m) != sizes(first)) {
            return rejected("a sum of matrices of different sizes");
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

    fn product(&mut self, list: &[(Factor, Expr)], depth: usize) -> Result<Value, Failure> {
        let mut out = Value::Scalar(Fraction::integer(1));
        for (factor, e) in list {
            let next = match (factor, self.value(e, depth)?) {
                (Factor::Times, value) => value,
                (Factor::Over, Value::Scalar(divisor)) => {
                    self.not_zero(&divisor, e)?;
                    Value::Scalar(divisor.power(-1)?)
                }
                (Factor::Over, Value::Matrix(_)) => return rejected("a division by a matrix"),
            };
            out = match (out, next) {
                (Value::Scalar(mut a), Value::Scalar(b)) => {
                    a.multiply(&b, &self.work)?;
                    Value::Scalar(a)
                }
                (Value::Scalar(a), Value::Matrix(rows)) | (Value::Matrix(rows), Value::Scalar(a)) => {
                    Value::Matrix(each(&rows, &mut |f| Ok(f.times(&a, &self.work)?))?)
                }
                (Value::Matrix(a), Value::Matrix(b)) => Value::Matrix(self.matrix_product(&a, &b)?),
            };
        }
        Ok(out)
    }

    fn apply_function(&mut self, function: &Name, arguments: &[Expr], depth: usize) -> Result<Value, Failure> {
        let [argument] = arguments else { return rejected("a function of one argument is given several") };
        let name = function.text.as_str();
        if !self.is_family(name) && matches!(name, "det" | "transpose") {
            let Value::Matrix(rows) = self.value(argument, depth)? else {
                return rejected(&format!("{name} needs a matrix"));
            };
            if name == "det" {
                return Ok(Value::Scalar(self.determinant(&rows)?));
            }
            let columns = (0..sizes(&rows).1).map(|j| rows.iter().filter_map(|r| r.get(j).cloned()).collect());
            return Ok(Value::Matrix(columns.collect()));
        }
        let x = self.scalar_in(argument, depth)?;
        if self.is_family(name) {
            return Ok(Value::Scalar(self.member_value(name, &x)?));
        }
        let two = Fraction::integer(2);
        // cosh x = (e^x + e^-x)/2, sinh x = (e^x - e^-x)/2; cosh x > 0 because both summands are.
        let half_sum = |checker: &mut Draft, plus: bool| -> Result<Fraction, Failure> {
            let (a, b) = (checker.exponential(&x)?, checker.exponential(&x.negated())?);
            let sum = Fraction::sum(&[a, if plus { b } else { b.negated() }], &checker.work)?;
            Ok(sum.times(&two.power(-1)?, &checker.work)?)
        };
        Ok(Value::Scalar(match name {
            "sqrt" => self.raised(&x, &two.power(-1)?, Exponent::Root)?,
            "cbrt" => self.raised(&x, &Fraction::integer(3).power(-1)?, Exponent::Root)?,
            "exp" => self.exponential(&x)?,
            "ln" => self.logarithm_of(&x)?,
            "cosh" => half_sum(self, true)?,
            "sinh" => half_sum(self, false)?,
            "sech" => half_sum(self, true)?.power(-1)?,
            "tanh" => half_sum(self, false)?.times(&half_sum(self, true)?.power(-1)?, &self.work)?,
            _ => return rejected(&format!("{name} is not a function that the kernel knows")),
        }))
    }

    /// A member of a family or sequence, whose index is a natural number.
    fn member_value(&mut self, name: &str, index: &Fraction) -> Result<Fraction, Failure> {
        let index = self.natural(index)?;
        if let Some(family) = self.family(name)
            && family.binding.indices.is_some()
        {
            return rejected(&format!("{name} has members for some indices only, which the kernel does not follow"));
        }
        Ok(self.atom_value(Atom::Member(name.to_string(), index)))
    }

    /// Whether a name stands for natural numbers: a variable, an index, or a family of them.
    pub(super) fn is_natural_name(&self, name: &str) -> bool {
        let variable = self.variable(name).filter(|v| v.natural).map(|v| v.source);
        let family = self.family(name).filter(|f| f.binding.natural).map(|f| Some(f.source));
        let declared = variable.or(family);
        declared.flatten().iter().for_each(|source| self.consult(*source));
        declared.is_some()
    }

    /// Whether an expression is a natural number, and whole by its form: put for a natural variable, it leaves every
    /// power a power of the same kind.
    pub(super) fn natural_by_form(&mut self, e: &Expr) -> Result<Poly, Failure> {
        let value = self.scalar(e)?;
        if !definedness::is_whole(e, &|name| self.is_natural_name(name)) {
            return rejected(&format!("{} is not whole by its form", text::expr(e)));
        }
        self.natural(&value)
    }

    /// Whether a fraction is a natural number: a polynomial with whole coefficients in natural
    /// variables, which is not negative.
    pub(super) fn natural(&mut self, index: &Fraction) -> Result<Poly, Failure> {
        let poly = self.whole(index)?;
        if !self.signs_of(index)?.within(Signs::NOT_NEGATIVE) {
            return rejected("an index that is not shown to be at least 0");
        }
        Ok(poly)
    }

    /// A polynomial with whole coefficients in natural variables has whole values.
    pub(super) fn whole(&mut self, index: &Fraction) -> Result<Poly, Failure> {
        let poly = index.expanded(&self.work)?;
        let natural = |atom: usize| match self.atoms.get(atom) {
            Some(Atom::Variable(name)) => match self.variable(name).filter(|v| v.natural) {
                Some(variable) => {
                    variable.source.iter().for_each(|source| self.consult(*source));
                    true
                }
                None => false,
            },
            Some(Atom::Bound(_)) => true,
            _ => false,
        };
        if poly.terms().all(|(_, c)| c.is_integer()) && poly.atoms().all(natural) {
            Ok(poly)
        } else {
            rejected("an index that is not shown to be a whole number")
        }
    }

    /// A sum or product over an index. A product is split into the products of the body's factors: this
    /// is right because the range is finite and the factors' exponents are whole numbers.
    fn over(&mut self, is_sum: bool, index: &Index, body: &Expr, depth: usize) -> Result<Fraction, Failure> {
        let from = self.scalar_in(&index.from, depth)?;
        let to = self.scalar_in(&index.to, depth)?;
        let (low, high) = (self.natural(&from)?, self.whole(&to)?);
        let room = Fraction::sum(&[to, Fraction::integer(1), from.negated()], &self.work)?;
        if !self.signs_of(&room)?.within(Signs::NOT_NEGATIVE) {
            return rejected("a range that may end before it begins");
        }
        self.binders += 1;
        let bound = self.binders;
        let body = self.under(&index.name.text, Atom::Bound(bound), body, depth);
        self.binders -= 1;
        let body = body?;
        if is_sum {
            if body.is_zero() {
                return Ok(body);
            }
            return Ok(self.atom_value(Atom::Over(true, bound, low, high, body)));
        }
        let mut out = Fraction::integer(1);
        if !body.coefficient.is_one() {
            let constant = Fraction::number(body.coefficient.clone());
            out = self.atom_value(Atom::Over(false, bound, low.clone(), high.clone(), constant));
        }
        for (poly, k) in &body.factors {
            let factor = Fraction::of(poly);
            let value = self.atom_value(Atom::Over(false, bound, low.clone(), high.clone(), factor));
            out.multiply(&value.power(*k)?, &self.work)?;
        }
        Ok(out)
    }

    /// Checks that the step of a sequence has a value for every index and every previous member.
    pub(super) fn step_has_a_value(&mut self, index: &str, step: &Expr) -> Result<(), Failure> {
        self.binders += 1;
        let result = self.under(index, Atom::Bound(self.binders), step, DEPTH_LIMIT);
        self.binders -= 1;
        result.map(|_| ())
    }

    /// An expression in which a name stands for an atom.
    fn under(&mut self, name: &str, atom: Atom, body: &Expr, depth: usize) -> Result<Fraction, Failure> {
        if self.is_declared(name) {
            return rejected(&format!("the bound name {name} is in use"));
        }
        let value = self.intern(atom);
        let variable = self.intern(Atom::Variable(name.to_string()));
        self.variables.push(Variable { name: name.to_string(), natural: true, source: None });
        self.replaced.push(Replaced { atom: variable, value: Fraction::atom(value), source: None });
        let result = self.scalar_in(body, depth);
        self.replaced.pop();
        self.variables.pop();
        result
    }

    /// A power: whole exponents by multiplication, others as exp(E·ln b) with b > 0. What the base has to be is decided
    /// by the form of the exponent, [`definedness`]: of the others nothing is asked but what the reader of a claim sees.
    fn raised(&mut self, base: &Fraction, exponent: &Fraction, kind: Exponent) -> Result<Fraction, Failure> {
        if let Some(k) = exponent.as_integer() {
            let signs = self.signs_of(base)?;
            if kind != Exponent::Whole && !signs.within(Signs::POSITIVE) {
                return rejected(
                    "a power of what is not shown to be positive, whose exponent is not whole by its form",
                );
            }
            if k < 0 && !signs.within(Signs::NOT_ZERO) {
                return rejected("a negative power of what may be 0");
            }
            return Ok(base.power(k)?);
        }
        let log = self.logarithm_of(base)?;
        self.exponential(&exponent.times(&log, &self.work)?)
    }

    /// ln c·∏ pᵢ^kᵢ = ln c + Σ kᵢ·ln pᵢ, if every pᵢ is shown to be positive; ln exp L = L.
    pub(super) fn logarithm_of(&mut self, x: &Fraction) -> Result<Fraction, Failure> {
        if x.coefficient <= BigRational::zero() {
            return rejected("a logarithm or power of what is not shown to be positive");
        }
        let mut terms = Vec::new();
        for (prime, k) in x.prime_powers(&self.work)? {
            let atom = self.intern(Atom::Logarithm(Poly::constant(BigRational::from_integer(prime))));
            terms.push(Fraction::atom(atom).times(&Fraction::integer(k), &self.work)?);
        }
        for (poly, k) in &x.factors {
            if !self.poly_signs(poly)?.within(Signs::POSITIVE) {
                return rejected("a logarithm or power of what is not shown to be positive");
            }
            let inner = match poly.single_atom().and_then(|place| self.atoms.get(place)) {
                Some(Atom::Exponential(inner)) => inner.clone(),
                _ => {
                    let place = self.intern(Atom::Logarithm(poly.clone()));
                    self.resolved(place)
                }
            };
            terms.push(inner.times(&Fraction::integer(*k), &self.work)?);
        }
        Ok(Fraction::sum(&terms, &self.work)?)
    }

    /// exp of a fraction: 1 at 0, else as a step of rule `power` has said.
    pub(crate) fn exponential(&mut self, log: &Fraction) -> Result<Fraction, Failure> {
        if log.is_zero() {
            return Ok(Fraction::integer(1));
        }
        self.work.count(self.powers.len())?;
        if let Some(power) = self.powers.iter().rev().find(|p| p.log == *log) {
            self.consult(power.source);
            return Ok(power.value.clone());
        }
        // The same exponent may stand in other factors.
        for power in self.powers.iter().rev() {
            if power.log.minus(log, &self.work)?.is_zero() {
                self.consult(power.source);
                return Ok(power.value.clone());
            }
        }
        rejected("a power that no step of rule `power` has introduced")
    }

    fn not_zero(&mut self, divisor: &Fraction, e: &Expr) -> Result<(), Failure> {
        if self.signs_of(divisor)?.within(Signs::NOT_ZERO) {
            return Ok(());
        }
        rejected(&format!("the divisor {} is not shown to be other than 0", text::expr(e)))
    }
}
