//! Expressions as fractions in atoms, by their form alone.
//!
//! Contract: wherever an expression has a value, its fraction has the same value. Nothing is known of signs here:
//! whether the expression has a value is asked in [`super::defined`]. So `x/x` is the fraction 1, and whoever states
//! `x/x = 1` has to show that x is not 0.
//!
//! Powers: b^E with a whole number E is multiplied out. With an exponent that is a sum of natural monomials with
//! positive whole coefficients, b^(E + F) = b^E·b^F, (b·c)^E = b^E·c^E and (b^E)^F = b^(E·F) hold for every b (0^0 = 1).
//! Any other exponent that is not whole by its form needs b > 0 (or b ≥ 0 under a root of numerals), and then
//! b^(E + F) = b^E·b^F holds as well. b^(−E) = 1/b^E holds wherever b^(−E) has a value, also for b = 0 and E = 0.
//! Other exponents that may be negative whole numbers stay whole: b may be 0 there.

use super::fraction::{Fraction, Monomial, Poly};
use super::sign::{Equation, Known, Written};
use super::statement::{DEPTH_LIMIT, NODES_LIMIT};
use super::{Checker, Reason, Refusal, rejected};
use crate::claim::syntax::*;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

/// What a fraction is made of: a number that has a meaning of its own.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Atom {
    /// A variable.
    Variable(String),
    /// The index of a sum or product, by its depth: a natural number.
    Bound(usize),
    /// A member of a family or sequence.
    Member(String, Poly),
    /// A sum or product over `Bound(depth)`.
    Over(Over),
    /// b^E where E is not a whole number.
    Power(Fraction, Fraction),
    /// exp of a fraction other than 0.
    Exponential(Fraction),
    /// ln of a fraction other than 1.
    Logarithm(Fraction),
}

/// A sum or product over an index.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Over {
    /// A sum, else a product.
    pub(super) sum: bool,
    /// Which bound index.
    pub(super) depth: usize,
    /// Its least value.
    pub(super) from: Poly,
    /// Its greatest value.
    pub(super) to: Poly,
    /// What is added or multiplied.
    pub(super) body: Fraction,
}

/// The functions that the kernel knows.
pub(super) const FUNCTIONS: [&str; 10] =
    ["det", "transpose", "sqrt", "cbrt", "exp", "ln", "cosh", "sinh", "sech", "tanh"];

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
        self.atoms.push(atom.clone());
        self.atom_index.insert(atom, self.atoms.len() - 1);
        self.atoms.len() - 1
    }

    /// The atom, or what equals it by the equations of the step that is read.
    fn atom_fraction(&mut self, atom: Atom) -> Fraction {
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

    fn put_in_written(&mut self, written: &Written) -> Option<Fraction> {
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

    fn scalar_in(&mut self, e: &Expr, depth: usize) -> Result<Fraction, Refusal> {
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

    fn matrix_product(&mut self, a: &[Vec<Fraction>], b: &[Vec<Fraction>]) -> Result<Vec<Vec<Fraction>>, Refusal> {
        if sizes(a).1 != sizes(b).0 {
            return rejected(Reason::MatrixSizes);
        }
        let mut out = Vec::new();
        for row in a {
            let mut entries = Vec::new();
            for j in 0..sizes(b).1 {
                let pairs = row.iter().zip(b).filter_map(|(x, other)| other.get(j).map(|y| (x, y)));
                let terms = pairs.map(|(x, y)| x.times(y, &self.work)).collect::<Result<Vec<_>, _>>()?;
                entries.push(Fraction::sum(&terms, &self.work)?);
            }
            out.push(entries);
        }
        Ok(out)
    }

    /// det by the first row; only small matrices are written in claims.
    fn determinant(&mut self, rows: &[Vec<Fraction>]) -> Result<Fraction, Refusal> {
        let (height, width) = sizes(rows);
        if height != width || height > 5 {
            return rejected(Reason::MatrixSizes);
        }
        let Some((first, below)) = rows.split_first() else { return Ok(Fraction::integer(1)) };
        let mut terms = Vec::new();
        for (j, entry) in first.iter().enumerate() {
            let without = |row: &Vec<Fraction>| {
                row.iter().enumerate().filter(|(k, _)| *k != j).map(|(_, f)| f.clone()).collect::<Vec<_>>()
            };
            let minor: Vec<Vec<Fraction>> = below.iter().map(without).collect();
            let term = entry.times(&self.determinant(&minor)?, &self.work)?;
            terms.push(if j % 2 == 0 { term } else { term.negated() });
        }
        Fraction::sum(&terms, &self.work)
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
            "cosh" | "sinh" | "sech" | "tanh" => self.hyperbolic(name, argument, &x, depth)?,
            _ => return rejected(Reason::Undeclared(name.to_string())),
        }))
    }

    /// cosh x = (e^x + e^−x)/2, sinh x = (e^x − e^−x)/2, sech and tanh by them; equations for exp(x) and exp(−x) are
    /// put in.
    fn hyperbolic(&mut self, name: &str, argument: &Expr, x: &Fraction, depth: usize) -> Result<Fraction, Refusal> {
        let equations = std::mem::take(&mut self.put_in);
        let plain = self.scalar_in(argument, depth);
        self.put_in = equations;
        let plain = plain?;
        let mut powers = Vec::new();
        for (plain, x) in [(plain.clone(), x.clone()), (plain.negated(), x.negated())] {
            powers.push(match self.put_in_written(&Written::Exponential(plain)) {
                Some(value) => value,
                None => self.exponential(&x)?,
            });
        }
        let half = Fraction::integer(2).power(-1)?;
        let sum = Fraction::sum(&powers, &self.work)?.times(&half, &self.work)?;
        if let Some(last) = powers.last_mut() {
            *last = last.negated();
        }
        let difference = Fraction::sum(&powers, &self.work)?.times(&half, &self.work)?;
        Ok(match name {
            "cosh" => sum,
            "sinh" => difference,
            "sech" => sum.power(-1)?,
            _ => difference.times(&sum.power(-1)?, &self.work)?,
        })
    }

    /// Whether an atom is a natural number by what it is.
    pub(super) fn is_natural_atom(&self, place: usize) -> bool {
        match self.atoms.get(place) {
            Some(Atom::Bound(_)) => true,
            Some(atom @ Atom::Variable(_)) => self.scope.iter().any(|v| v.atom == *atom && v.natural),
            Some(Atom::Member(name, _)) => self.family(name).is_some_and(|f| f.natural),
            _ => false,
        }
    }

    /// A polynomial with whole coefficients in natural atoms: a whole number, which may be negative.
    pub(super) fn whole(&mut self, f: &Fraction) -> Result<Poly, Refusal> {
        match f.expanded(&self.work) {
            Ok(poly) if poly.terms().all(|t| t.1.is_integer()) && poly.atoms().all(|a| self.is_natural_atom(a)) => {
                Ok(poly)
            }
            Ok(_) | Err(Refusal::Rejected(_)) => rejected(Reason::NotWhole),
            Err(limit) => Err(limit),
        }
    }

    fn monomial(&self, monomial: &Monomial) -> Result<Fraction, Refusal> {
        let mut out = Fraction::integer(1);
        for (atom, k) in monomial {
            out.multiply(&Fraction::atom(*atom).power(i64::from(*k))?, &self.work)?;
        }
        Ok(out)
    }

    /// The polynomial, if there are no divisors.
    fn polynomial(&self, f: &Fraction) -> Result<Option<Poly>, Refusal> {
        if f.factors.values().any(|k| *k < 0) { Ok(None) } else { Ok(Some(f.expanded(&self.work)?)) }
    }

    /// b^E.
    pub(super) fn power(&mut self, base: &Fraction, exponent: &Fraction) -> Result<Fraction, Refusal> {
        if let Some(k) = exponent.as_integer() {
            return base.power(k);
        }
        if base.as_integer() == Some(1) {
            return Ok(Fraction::integer(1));
        }
        let Some(poly) = self.polynomial(exponent)? else {
            return self.real_power(base, exponent);
        };
        let natural = |checker: &Checker, m: &Monomial| m.iter().all(|(atom, _)| checker.is_natural_atom(*atom));
        if poly.terms().all(|(m, c)| c.is_integer() && natural(self, m)) {
            return if poly.terms().all(|(_, c)| c.is_positive()) {
                self.natural_power(base, exponent, &poly)
            } else if poly.terms().all(|(_, c)| c.is_negative()) {
                Ok(self.power(base, &exponent.negated())?.power(-1)?)
            } else {
                // A whole number that may be negative.
                Ok(self.atom_fraction(Atom::Power(base.clone(), exponent.clone())))
            };
        }
        let mut out = Fraction::integer(1);
        for (monomial, c) in poly.terms() {
            let part = self.monomial(monomial)?.times(&Fraction::number(c.clone()), &self.work)?;
            let whole = c.is_integer() && natural(self, monomial);
            let factor = if whole { self.power(base, &part)? } else { self.real_power(base, &part)? };
            out.multiply(&factor, &self.work)?;
        }
        Ok(out)
    }

    /// Whether an exponent is a whole number by its form.
    pub(super) fn is_whole(&self, exponent: &Fraction) -> Result<bool, Refusal> {
        Ok(match self.polynomial(exponent)? {
            Some(poly) => poly.terms().all(|t| t.1.is_integer()) && poly.atoms().all(|a| self.is_natural_atom(a)),
            None => false,
        })
    }

    /// b^E where E is not a whole number, so that b > 0, or b ≥ 0 and E is a positive numeral.
    ///
    /// If b is itself c^F with F not whole, or exp F, both are positive or c = 0 under positive numerals:
    /// (c^F)^E = c^(F·E). And b^(p·F/q) = (b^(F/q))^p.
    fn real_power(&mut self, base: &Fraction, exponent: &Fraction) -> Result<Fraction, Refusal> {
        if let (true, Some((poly, k)), 1) = (base.coefficient.is_one(), base.factors.iter().next(), base.factors.len())
        {
            let all = exponent.times(&Fraction::integer(*k), &self.work)?;
            match poly.single_atom().and_then(|place| self.atoms.get(place)).cloned() {
                Some(Atom::Power(inner, e)) if !self.is_whole(&e)? => {
                    let product = e.times(&all, &self.work)?;
                    return self.power(&inner, &product);
                }
                Some(Atom::Exponential(log)) => {
                    let product = log.times(&all, &self.work)?;
                    return self.exponential(&product);
                }
                _ => {}
            }
        }
        let (top, rest) = numerator_apart(exponent);
        let atom = Atom::Power(base.clone(), rest);
        self.atom_fraction(atom).power(top)
    }

    /// b^E for a sum E of natural monomials, by the factors of b. Factors that are exponentials or powers with a
    /// symbolic exponent that is not whole are positive, so that (c^F)^E = c^(F·E).
    fn natural_power(&mut self, base: &Fraction, exponent: &Fraction, poly: &Poly) -> Result<Fraction, Refusal> {
        let mut monomials = Vec::new();
        for (monomial, c) in poly.terms() {
            let Ok(k) = i64::try_from(c.numer()) else { return Err(Refusal::Limit("digits")) };
            monomials.push((self.monomial(monomial)?, k));
        }
        let plain = |checker: &mut Checker, factor: &Fraction| -> Result<Fraction, Refusal> {
            let mut out = Fraction::integer(1);
            for (monomial, k) in &monomials {
                let power = match monomial.as_integer() {
                    Some(_) => factor.power(*k)?,
                    None => checker.atom_fraction(Atom::Power(factor.clone(), monomial.clone())).power(*k)?,
                };
                out.multiply(&power, &checker.work)?;
            }
            Ok(out)
        };
        if base.is_zero() {
            return plain(self, base);
        }
        let mut out = Fraction::integer(1);
        if base.coefficient.is_negative() {
            out = plain(self, &Fraction::integer(-1))?;
        }
        for (prime, k) in base.prime_powers(&self.work)? {
            let prime = Fraction::number(BigRational::from_integer(prime));
            out.multiply(&plain(self, &prime)?.power(k)?, &self.work)?;
        }
        for (poly, k) in &base.factors {
            let factor = match poly.single_atom().and_then(|place| self.atoms.get(place)).cloned() {
                Some(Atom::Exponential(log)) => {
                    let product = log.times(exponent, &self.work)?;
                    self.exponential(&product)?
                }
                Some(Atom::Power(inner, e)) if e.as_number().is_none() && !self.is_whole(&e)? => {
                    let product = e.times(exponent, &self.work)?;
                    self.power(&inner, &product)?
                }
                Some(Atom::Power(inner, e)) if self.is_whole(&e)? => {
                    // Natural exponents multiply: (c^F)^m = c^(F·m) for each monomial m.
                    let mut out = Fraction::integer(1);
                    for (monomial, k) in &monomials {
                        let atom = Atom::Power(inner.clone(), e.times(monomial, &self.work)?);
                        out.multiply(&self.atom_fraction(atom).power(*k)?, &self.work)?;
                    }
                    out
                }
                _ => plain(self, &Fraction::of(poly))?,
            };
            out.multiply(&factor.power(*k)?, &self.work)?;
        }
        Ok(out)
    }

    /// exp of a fraction: exp(E + F) = exp E·exp F, exp(p·F/q) = exp(F/q)^p,
    /// exp(E·ln x) = x^E, for x > 0 where ln x has a value.
    pub(super) fn exponential(&mut self, log: &Fraction) -> Result<Fraction, Refusal> {
        if log.is_zero() {
            return Ok(Fraction::integer(1));
        }
        let mut out = Fraction::integer(1);
        let parts = match self.polynomial(log)? {
            Some(poly) => {
                let mut parts = Vec::new();
                for (monomial, c) in poly.terms() {
                    parts.push(self.monomial(monomial)?.times(&Fraction::number(c.clone()), &self.work)?);
                }
                parts
            }
            None => vec![log.clone()],
        };
        for part in parts {
            let mut logs = part.factors.iter().filter_map(|(poly, k)| {
                match poly.single_atom().and_then(|place| self.atoms.get(place)) {
                    Some(Atom::Logarithm(x)) if *k == 1 => Some((poly.clone(), x.clone())),
                    _ => None,
                }
            });
            let value = match (logs.next(), logs.next()) {
                (Some((poly, x)), None) => {
                    let mut exponent = part.clone();
                    exponent.factors.remove(&poly);
                    self.power(&x, &exponent)?
                }
                _ => {
                    let (top, rest) = numerator_apart(&part);
                    self.atom_fraction(Atom::Exponential(rest)).power(top)?
                }
            };
            out.multiply(&value, &self.work)?;
        }
        Ok(out)
    }

    /// ln of a fraction; ln exp E = E, and ln b^E = E·ln b where E is not whole, so that b > 0.
    fn logarithm(&mut self, x: &Fraction) -> Result<Fraction, Refusal> {
        if x.as_integer() == Some(1) {
            return Ok(Fraction::integer(0));
        }
        if let (true, Some((poly, k)), 1) = (x.coefficient.is_one(), x.factors.iter().next(), x.factors.len()) {
            let k = Fraction::integer(*k);
            match poly.single_atom().and_then(|place| self.atoms.get(place)).cloned() {
                Some(Atom::Exponential(log)) => return log.times(&k, &self.work),
                Some(Atom::Power(base, e)) if !self.is_whole(&e)? => {
                    let log = self.logarithm(&base)?;
                    return log.times(&e, &self.work)?.times(&k, &self.work);
                }
                _ => {}
            }
        }
        Ok(self.atom_fraction(Atom::Logarithm(x.clone())))
    }

    /// A sum or product over an index. Finite sums are linear, finite products of factors are products: both are
    /// taken apart, and what does not hold the index is taken out.
    ///
    /// An empty sum is 0 and an empty product 1, also where what is taken out has no value: 0·c = 0 and c^0 = 1 have to
    /// hold. With a divisor in c they may not: `sum(i = 1..n, 1/n)` is not n·(1/n) for n = 0, nor
    /// `product(i = 1..n, x^(1/n))` = x^(n/n). So divisors are taken out only where the range is not empty by its form.
    fn over(&mut self, sum: bool, index: &Index, body: &Expr, depth: usize) -> Result<Fraction, Refusal> {
        let (low, high) = (self.scalar_in(&index.from, depth)?, self.scalar_in(&index.to, depth)?);
        let (from, to) = (self.whole(&low)?, self.whole(&high)?);
        self.binders += 1;
        let depth_of_index = self.binders;
        let body = self.under(&index.name.text, depth_of_index, |checker| checker.scalar_in(body, depth));
        self.binders -= 1;
        self.over_of(&Over { sum, depth: depth_of_index, from, to, body: body? })
    }

    fn over_of(&mut self, over: &Over) -> Result<Fraction, Refusal> {
        let (low, high) = (Fraction::of(&over.from), Fraction::of(&over.to));
        let room = Fraction::sum(&[high, Fraction::integer(1), low.negated()], &self.work)?;
        let with = |body: Fraction| Atom::Over(Over { body, ..over.clone() });
        if over.sum {
            self.sum_over(&over.body, over.depth, &room, &with)
        } else {
            self.product_over(&over.body, over.depth, &room, &with)
        }
    }

    fn sum_over(
        &mut self,
        body: &Fraction,
        bound: usize,
        room: &Fraction,
        over: &dyn Fn(Fraction) -> Atom,
    ) -> Result<Fraction, Refusal> {
        let filled = self.is_not_empty(room)?;
        let (outside, inside) = self.taken_out(body, bound, filled)?;
        if body.is_zero() {
            return Ok(Fraction::integer(0));
        }
        let held = |(_, k): &(&Poly, &i64)| **k < 0;
        let mut terms = Vec::new();
        // What stays inside only since it is a divisor stays with every term.
        let (mut divisors, mut top) = (Fraction::integer(1), inside.clone());
        for (poly, k) in inside.factors.iter().filter(held) {
            if self.is_free_of(&Fraction::of(poly), &Atom::Bound(bound))? {
                top.factors.remove(poly);
                divisors.factors.insert(poly.clone(), *k);
            }
        }
        match self.polynomial(&top)? {
            Some(poly) => {
                for (monomial, c) in poly.terms() {
                    let term = self.monomial(monomial)?.times(&Fraction::number(c.clone()), &self.work)?;
                    let (free, rest) = self.taken_out(&term, bound, filled)?;
                    let rest = rest.times(&divisors, &self.work)?;
                    let one = rest.as_integer() == Some(1);
                    let sum = if one { room.clone() } else { self.atom_fraction(over(rest)) };
                    terms.push(free.times(&sum, &self.work)?);
                }
            }
            None => terms.push(self.atom_fraction(over(inside))),
        }
        Fraction::sum(&terms, &self.work)?.times(&outside, &self.work)
    }

    fn product_over(
        &mut self,
        body: &Fraction,
        bound: usize,
        room: &Fraction,
        over: &dyn Fn(Fraction) -> Atom,
    ) -> Result<Fraction, Refusal> {
        if body.is_zero() {
            return Ok(self.atom_fraction(over(body.clone())));
        }
        // The number of members is natural; by its form only if no coefficient is negative.
        let counted = self.polynomial(room)?.is_some_and(|p| p.terms().all(|t| !t.1.is_negative()));
        let mut out = Fraction::integer(1);
        if !body.coefficient.is_one() {
            let constant = Fraction::number(body.coefficient.clone());
            let factor = if counted { self.power(&constant, room)? } else { self.atom_fraction(over(constant)) };
            out.multiply(&factor, &self.work)?;
        }
        for (poly, k) in &body.factors {
            let factor = Fraction::of(poly);
            let mut free = self.is_free_of(&factor, &Atom::Bound(bound))?;
            if free && self.has_divided_exponents(poly) {
                free = self.is_not_empty(room)?;
            }
            let value = if free && counted { self.power(&factor, room)? } else { self.atom_fraction(over(factor)) };
            out.multiply(&value.power(*k)?, &self.work)?;
        }
        Ok(out)
    }

    /// Whether a range of so many members has one, by the form of their number: it is 1 and a sum of natural numbers.
    fn is_not_empty(&self, room: &Fraction) -> Result<bool, Refusal> {
        let rest = room.minus(&Fraction::integer(1), &self.work)?;
        Ok(self.is_whole(&rest)? && rest.expanded(&self.work)?.terms().all(|t| t.1.is_positive()))
    }

    /// Whether a power or exponential with a divisor in its exponent occurs in a factor.
    fn has_divided_exponents(&self, poly: &Poly) -> bool {
        poly.atoms().any(|place| match self.atoms.get(place) {
            Some(Atom::Power(_, exponent) | Atom::Exponential(exponent)) => exponent.factors.values().any(|k| *k < 0),
            _ => false,
        })
    }

    /// The factors that do not hold a bound index, and the others. What needs a divisor to have a value is among the
    /// others, unless the range is filled.
    fn taken_out(&mut self, f: &Fraction, bound: usize, filled: bool) -> Result<(Fraction, Fraction), Refusal> {
        let (mut outside, mut inside) = (Fraction::number(f.coefficient.clone()), Fraction::integer(1));
        for (poly, k) in &f.factors {
            let free = self.is_free_of(&Fraction::of(poly), &Atom::Bound(bound))?
                && (filled || (*k > 0 && !self.has_divided_exponents(poly)));
            let side = if free { &mut outside } else { &mut inside };
            side.factors.insert(poly.clone(), *k);
        }
        Ok((outside, inside))
    }

    /// Runs something where a name stands for a bound index.
    pub(super) fn under<T>(
        &mut self,
        name: &str,
        bound: usize,
        run: impl FnOnce(&mut Checker) -> Result<T, Refusal>,
    ) -> Result<T, Refusal> {
        self.declare(name, true, Atom::Bound(bound))?;
        let result = run(self);
        self.scope.pop();
        result
    }

    /// Whether a fraction is free of an atom, at any depth.
    pub(super) fn is_free_of(&self, f: &Fraction, atom: &Atom) -> Result<bool, Refusal> {
        Ok(!self.holds_atom(f, &|found| found == atom)?)
    }

    /// Whether an atom of a kind occurs in a fraction, at any depth.
    pub(super) fn holds_atom(&self, f: &Fraction, kind: &dyn Fn(&Atom) -> bool) -> Result<bool, Refusal> {
        self.holds_atom_where(f, kind, &|_| true)
    }

    /// Whether a bound index occurs in a fraction, elsewhere than in a sum or product over this very index.
    pub(super) fn holds_free_index(&self, f: &Fraction, depth: usize) -> Result<bool, Refusal> {
        self.holds_atom_where(f, &|atom| *atom == Atom::Bound(depth), &|over| over.depth != depth)
    }

    /// Whether an atom of a kind occurs in a fraction, at any depth but in the bodies of sums and products that are not
    /// entered. Each atom is looked at once.
    fn holds_atom_where(
        &self,
        f: &Fraction,
        kind: &dyn Fn(&Atom) -> bool,
        enter: &dyn Fn(&Over) -> bool,
    ) -> Result<bool, Refusal> {
        let mut open: Vec<usize> = f.atoms().collect();
        let mut seen = BTreeSet::new();
        while let Some(place) = open.pop() {
            if !seen.insert(place) {
                continue;
            }
            let before = open.len();
            let Some(atom) = self.atoms.get(place) else { continue };
            if kind(atom) {
                return Ok(true);
            }
            match atom {
                Atom::Variable(_) | Atom::Bound(_) => {}
                Atom::Member(_, inner) => open.extend(inner.atoms()),
                Atom::Over(over) => {
                    open.extend(over.from.atoms().chain(over.to.atoms()));
                    if enter(over) {
                        open.extend(over.body.atoms());
                    }
                }
                Atom::Power(a, b) => open.extend(a.atoms().chain(b.atoms())),
                Atom::Exponential(inner) | Atom::Logarithm(inner) => open.extend(inner.atoms()),
            }
            self.work.count(1 + open.len() - before)?;
        }
        Ok(false)
    }

    /// The derivative of c·∏ pᵢ^kᵢ by a variable: f·Σ kᵢ·pᵢ′/pᵢ.
    ///
    /// That the expression has a value at the point and around it is asked in [`super::defined`].
    fn derivative(&mut self, f: &Fraction, by: &str, depth: usize) -> Result<Fraction, Refusal> {
        let Some(depth) = depth.checked_sub(1) else { return Err(Refusal::Limit("depth")) };
        let innermost = self.scope.iter().rev().find(|v| v.name == *by);
        let Some(variable) = innermost.filter(|v| !v.natural).map(|v| v.atom.clone()) else {
            return rejected(Reason::NotAReal(by.to_string()));
        };
        // A member of a sequence may depend on anything that the claim declares.
        if self.holds_atom(f, &|atom| matches!(atom, Atom::Member(name, _) if self.is_sequence(name)))? {
            return rejected(Reason::DerivativeOfMember);
        }
        let mut terms = Vec::new();
        for (poly, k) in &f.factors {
            let mut slope = Vec::new();
            let atoms: BTreeSet<usize> = poly.atoms().collect();
            for atom in atoms {
                let inner = self.atom_derivative(atom, &variable, by, depth)?;
                if !inner.is_zero() {
                    slope.push(Fraction::of(&poly.derivative(atom)).times(&inner, &self.work)?);
                }
            }
            let slope = Fraction::sum(&slope, &self.work)?;
            if slope.is_zero() {
                continue;
            }
            let mut term = slope.times(&Fraction::of(poly).power(-1)?, &self.work)?;
            term.multiply(&Fraction::integer(*k), &self.work)?;
            term.multiply(f, &self.work)?;
            terms.push(term);
        }
        Fraction::sum(&terms, &self.work)
    }

    fn atom_derivative(&mut self, place: usize, variable: &Atom, by: &str, depth: usize) -> Result<Fraction, Refusal> {
        if self.is_free_of(&Fraction::atom(place), variable)? {
            return Ok(Fraction::integer(0));
        }
        match self.atoms.get(place).cloned() {
            Some(Atom::Variable(_)) => Ok(Fraction::integer(1)),
            Some(Atom::Logarithm(inner)) => {
                Ok(self.derivative(&inner, by, depth)?.times(&inner.power(-1)?, &self.work)?)
            }
            Some(Atom::Exponential(inner)) => {
                Ok(self.derivative(&inner, by, depth)?.times(&Fraction::atom(place), &self.work)?)
            }
            Some(Atom::Power(base, exponent)) if self.is_free_of(&exponent, variable)? => {
                // (b^E)′ = E·b′/b·b^E.
                let mut out = self.derivative(&base, by, depth)?.times(&base.power(-1)?, &self.work)?;
                out.multiply(&exponent, &self.work)?;
                out.multiply(&Fraction::atom(place), &self.work)?;
                Ok(out)
            }
            Some(Atom::Power(base, exponent)) => {
                // b^E = exp(E·ln b), so (b^E)′ = (E′·ln b + E·b′/b)·b^E.
                let log = self.logarithm(&base)?;
                let first = self.derivative(&exponent, by, depth)?.times(&log, &self.work)?;
                let mut second = self.derivative(&base, by, depth)?.times(&base.power(-1)?, &self.work)?;
                second.multiply(&exponent, &self.work)?;
                Ok(Fraction::sum(&[first, second], &self.work)?.times(&Fraction::atom(place), &self.work)?)
            }
            _ => rejected(Reason::DerivativeOfMember),
        }
    }

    /// A fraction with an atom replaced by what equals it, also inside other atoms: they are functions of what they
    /// are made of. Only the atoms of the value stay as they are, so that x = (x^(1/2))^2 can be put in.
    pub(super) fn replaced(&mut self, f: &Fraction, atom: usize, value: &Fraction) -> Result<Fraction, Refusal> {
        let mut done: BTreeMap<usize, Fraction> = value.atoms().map(|place| (place, Fraction::atom(place))).collect();
        done.remove(&atom);
        self.replaced_in(f, atom, value, &mut done, DEPTH_LIMIT)
    }

    /// A fraction with the atoms of equations replaced one after the other, and the places of those that occur.
    pub(super) fn all_replaced(
        &mut self,
        f: &Fraction,
        equations: &[Equation],
    ) -> Result<(Fraction, Vec<usize>), Refusal> {
        let (mut out, mut places) = (f.clone(), Vec::new());
        for equation in equations {
            let Some((atom, value)) = &equation.atom else { continue };
            let new = self.replaced(&out, *atom, value)?;
            if new != out {
                places.extend(&equation.rests_on);
                out = new;
            }
        }
        Ok((out, places))
    }

    fn replaced_in(
        &mut self,
        f: &Fraction,
        atom: usize,
        value: &Fraction,
        done: &mut BTreeMap<usize, Fraction>,
        depth: usize,
    ) -> Result<Fraction, Refusal> {
        let Some(depth) = depth.checked_sub(1) else { return Err(Refusal::Limit("depth")) };
        let atoms: BTreeSet<usize> = f.atoms().collect();
        let mut changed = Vec::new();
        for place in atoms {
            if !done.contains_key(&place) {
                let new = self.replaced_atom(place, atom, value, done, depth)?;
                done.insert(place, new);
            }
            if let Some(new) = done.get(&place).filter(|new| **new != Fraction::atom(place)) {
                changed.push((place, new.clone()));
            }
        }
        if changed.is_empty() {
            return Ok(f.clone());
        }
        let mut out = Fraction::number(f.coefficient.clone());
        for (poly, k) in &f.factors {
            let factor = if poly.atoms().any(|a| changed.iter().any(|c| c.0 == a)) {
                let mut terms = Vec::new();
                for (monomial, c) in poly.terms() {
                    let mut term = Fraction::number(c.clone());
                    for (place, power) in monomial {
                        let new = changed.iter().find(|c| c.0 == *place);
                        let base = new.map_or_else(|| Fraction::atom(*place), |c| c.1.clone());
                        term.multiply(&base.power(i64::from(*power))?, &self.work)?;
                    }
                    terms.push(term);
                }
                Fraction::sum(&terms, &self.work)?
            } else {
                Fraction::of(poly)
            };
            out.multiply(&factor.power(*k)?, &self.work)?;
        }
        Ok(out)
    }

    fn replaced_atom(
        &mut self,
        place: usize,
        atom: usize,
        value: &Fraction,
        done: &mut BTreeMap<usize, Fraction>,
        depth: usize,
    ) -> Result<Fraction, Refusal> {
        if place == atom {
            return Ok(value.clone());
        }
        let plain = Fraction::atom(place);
        let Some(found) = self.atoms.get(place).cloned() else { return Ok(plain) };
        let Some(target) = self.atoms.get(atom).cloned() else { return Ok(plain) };
        if self.is_free_of(&plain, &target)? {
            return Ok(plain);
        }
        let mut inner = |checker: &mut Checker, f: &Fraction| checker.replaced_in(f, atom, value, done, depth);
        match found {
            Atom::Variable(_) | Atom::Bound(_) => Ok(plain),
            Atom::Member(name, index) => {
                let index = inner(self, &Fraction::of(&index))?;
                let index = self.whole(&index)?;
                Ok(self.atom_fraction(Atom::Member(name, index)))
            }
            Atom::Power(base, exponent) => {
                let (base, new) = (inner(self, &base)?, inner(self, &exponent)?);
                // As in `exponent_in`: a whole power stays one.
                let whole = self.is_whole(&exponent)? && !self.is_whole(&new)?;
                self.power(&base, if whole { &exponent } else { &new })
            }
            Atom::Exponential(log) => {
                let log = inner(self, &log)?;
                self.exponential(&log)
            }
            Atom::Logarithm(x) => {
                let x = inner(self, &x)?;
                self.logarithm(&x)
            }
            Atom::Over(over) => {
                let (from, to) = (inner(self, &Fraction::of(&over.from))?, inner(self, &Fraction::of(&over.to))?);
                let (from, to) = (self.whole(&from)?, self.whole(&to)?);
                let body = inner(self, &over.body)?;
                self.over_of(&Over { from, to, body, ..over })
            }
        }
    }
}

/// p and F/q of p·F/q, p and q positive or negative whole numbers without common divisor; p = 1 where it is too long.
fn numerator_apart(f: &Fraction) -> (i64, Fraction) {
    match i64::try_from(f.coefficient.numer()) {
        Ok(top) if top != 0 => {
            let mut rest = f.clone();
            rest.coefficient /= BigRational::from_integer(BigInt::from(top));
            (top, rest)
        }
        _ => (1, f.clone()),
    }
}

fn sizes(rows: &[Vec<Fraction>]) -> (usize, usize) {
    (rows.len(), rows.first().map_or(0, Vec::len))
}

fn each(
    rows: &[Vec<Fraction>],
    change: &mut dyn FnMut(&Fraction) -> Result<Fraction, Refusal>,
) -> Result<Vec<Vec<Fraction>>, Refusal> {
    rows.iter().map(|row| row.iter().map(&mut *change).collect()).collect()
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
