//! From expressions to forms, with the conditions under which the expression has a value.
//!
//! Contract: [`Engine::translate`] returns a form equal to the expression at every point that the
//! context allows and where all the returned [`Condition`]s hold. Powers with fractional or
//! symbolic exponents are distributed over products only where every factor is known to be positive
//! (or non-negative, under a positive number as exponent); elsewhere translation fails.

use super::context::*;
use super::expand::Sequence;
use crate::algebra::form::{Atom, Exponent, Form, Over, factor_number};
use crate::claim::definedness;
use crate::claim::syntax::*;
use crate::number::rational;
use malachite::Rational;
use malachite::base::num::basic::traits::{One, Zero};
use std::rc::Rc;

/// What must hold for an expression to have a value.
#[derive(Clone, Debug, PartialEq)]
pub struct Condition {
    /// This form …
    pub form: Form,
    /// … stands in this relation to zero.
    pub relation: Relation,
    /// The expression concerned, as text.
    pub text: String,
}

/// A scalar or a matrix.
#[derive(Clone, Debug)]
pub enum Value {
    /// A number.
    Scalar(Form),
    /// Rows of equal length.
    Matrix(Vec<Vec<Form>>),
}

/// The largest constant range of a sum or product that is written out.
const WRITTEN_OUT: i64 = 64;

type Result<T> = std::result::Result<T, Failure>;

impl Engine {
    /// The form of a scalar expression.
    pub fn scalar(&mut self, cx: &mut Context, expr: &Expr, conditions: &mut Vec<Condition>) -> Result<Form> {
        match self.translate(cx, expr, conditions)? {
            Value::Scalar(form) => Ok(form),
            Value::Matrix(_) => Err(fault(expr.span, "a matrix stands where a number is needed")),
        }
    }

    /// The value of an expression.
    pub fn translate(&mut self, cx: &mut Context, expr: &Expr, conditions: &mut Vec<Condition>) -> Result<Value> {
        self.tick()?;
        use ExprKind::*;
        Ok(Value::Scalar(match &expr.kind {
            Number(text) => match rational::parse(text) {
                Ok(q) => Form::number(q),
                Err(_) => return Err(fault(expr.span, "this numeral cannot be read")),
            },
            Name(name) => self.name(cx, name),
            Apply(function, arguments) => return self.apply(cx, function, arguments, conditions),
            Negate(a) => match self.translate(cx, a, conditions)? {
                Value::Scalar(form) => form.negated(),
                Value::Matrix(rows) => {
                    return Ok(Value::Matrix(rows.iter().map(|r| r.iter().map(Form::negated).collect()).collect()));
                }
            },
            Sum(list) => {
                let mut scalars = Vec::new();
                let mut matrix: Option<Vec<Vec<Vec<Form>>>> = None;
                for (sign, summand) in list {
                    match self.translate(cx, summand, conditions)? {
                        Value::Scalar(form) => {
                            scalars.push(if *sign == Sign::Plus { form } else { form.negated() });
                        }
                        Value::Matrix(rows) => {
                            let rows = rows
                                .into_iter()
                                .map(|r| {
                                    r.into_iter()
                                        .map(|f| vec![if *sign == Sign::Plus { f } else { f.negated() }])
                                        .collect::<Vec<_>>()
                                })
                                .collect::<Vec<_>>();
                            match &mut matrix {
                                None => matrix = Some(rows),
                                Some(sum) => {
                                    if sum.len() != rows.len() || sum[0].len() != rows[0].len() {
                                        return Err(fault(summand.span, "the sizes of these matrices differ"));
                                    }
                                    for (a, b) in sum.iter_mut().flatten().zip(rows.into_iter().flatten()) {
                                        a.extend(b);
                                    }
                                }
                            }
                        }
                    }
                }
                match matrix {
                    None => self.ring.add(&scalars)?,
                    Some(_) if !scalars.is_empty() => {
                        return Err(fault(expr.span, "a number cannot be added to a matrix"));
                    }
                    Some(sum) => {
                        let mut rows = Vec::new();
                        for row in sum {
                            rows.push(row.iter().map(|e| self.ring.add(e)).collect::<std::result::Result<_, _>>()?);
                        }
                        return Ok(Value::Matrix(rows));
                    }
                }
            }
            Product(list) => {
                let mut product = Value::Scalar(Form::integer(1));
                for (operator, factor) in list {
                    let value = self.translate(cx, factor, conditions)?;
                    product = match (operator, product, value) {
                        (Factor::Over, product, Value::Scalar(f)) => {
                            conditions.push(Condition {
                                form: f.clone(),
                                relation: Relation::NotEqual,
                                text: text_of(factor),
                            });
                            if f.is_zero() {
                                return Err(Failure::Undefined(format!("{} is 0", text_of(factor))));
                            }
                            let inverse = self.ring.inverse(&f)?;
                            self.scaled(product, &inverse)?
                        }
                        (Factor::Over, _, Value::Matrix(_)) => {
                            return Err(fault(factor.span, "division by a matrix is not defined"));
                        }
                        (Factor::Times, p, Value::Scalar(f)) => self.scaled(p, &f)?,
                        (Factor::Times, Value::Scalar(f), m) => self.scaled(m, &f)?,
                        (Factor::Times, Value::Matrix(a), Value::Matrix(b)) => {
                            if a[0].len() != b.len() {
                                return Err(fault(factor.span, "the sizes of these matrices do not match"));
                            }
                            let mut rows = Vec::new();
                            for row in &a {
                                let mut out = Vec::new();
                                for j in 0..b[0].len() {
                                    let mut sum = Vec::new();
                                    for (x, y) in row.iter().zip(&b) {
                                        sum.push(self.ring.mul(x, &y[j])?);
                                    }
                                    out.push(self.ring.add(&sum)?);
                                }
                                rows.push(out);
                            }
                            Value::Matrix(rows)
                        }
                    };
                }
                return Ok(product);
            }
            Power(base, exponent) => {
                let b = self.scalar(cx, base, conditions)?;
                let e = self.scalar(cx, exponent, conditions)?;
                let kind = definedness::exponent(exponent, &|name| is_natural_name(cx, name));
                self.power_valued(cx, &b, &e, kind, &text_of(expr), conditions)?
            }
            SumOver(index, body) => self.over(cx, index, body, true, conditions)?,
            ProductOver(index, body) => self.over(cx, index, body, false, conditions)?,
            Derivative(body, by) => {
                let mut inner = cx.clone();
                inner.differentiated = true;
                let mut form = self.scalar(&mut inner, body, conditions)?;
                // What a sequence is made of may depend on the variable.
                let member =
                    |a| matches!(&*self.ring.atom(a), Atom::Member(name, _) if cx.sequences.contains_key(name));
                if self.ring.mentions(&form, &member) {
                    return Err(Failure::NotShown("the derivative of a sequence".to_string()));
                }
                for name in by {
                    if cx.variables.iter().any(|(v, natural)| *v == name.text && *natural) {
                        return Err(Failure::NotShown(format!("the derivative by {}, a natural number", name.text)));
                    }
                    let atom = self.ring.intern(Atom::Variable(name.text.clone()));
                    let eliminated: Vec<Form> = cx.environment.values().map(|v| v.0.clone()).collect();
                    let clash = cx.environment.contains_key(&name.text)
                        || cx.indices.contains_key(&name.text)
                        || eliminated.iter().any(|f| self.ring.mentions(f, &|a| a == atom))
                        || tied(cx, &name.text);
                    if clash {
                        return Err(Failure::NotShown(format!(
                            "the derivative by {}, which a hypothesis ties to other variables",
                            name.text
                        )));
                    }
                    form = match self.ring.derivative(&form, atom)? {
                        Some(form) => form,
                        None => return Err(Failure::NotShown(format!("the derivative by {}", name.text))),
                    };
                }
                form
            }
            Matrix(rows) => {
                let mut out = Vec::new();
                for row in rows {
                    out.push(row.iter().map(|e| self.scalar(cx, e, conditions)).collect::<Result<_>>()?);
                }
                return Ok(Value::Matrix(out));
            }
        }))
    }

    fn scaled(&mut self, value: Value, by: &Form) -> Result<Value> {
        Ok(match value {
            Value::Scalar(form) => Value::Scalar(self.ring.mul(&form, by)?),
            Value::Matrix(rows) => {
                let mut out = Vec::new();
                for row in rows {
                    let row: std::result::Result<_, _> = row.iter().map(|f| self.ring.mul(f, by)).collect();
                    out.push(row?);
                }
                Value::Matrix(out)
            }
        })
    }

    fn name(&mut self, cx: &mut Context, name: &str) -> Form {
        if let Some(form) = cx.indices.get(name) {
            return form.clone();
        }
        if let Some((form, sources)) = cx.environment.get(name) {
            self.used |= sources;
            return form.clone();
        }
        self.ring.variable(name)
    }

    fn apply(
        &mut self,
        cx: &mut Context,
        function: &Name,
        arguments: &[Expr],
        conditions: &mut Vec<Condition>,
    ) -> Result<Value> {
        let name = function.text.as_str();
        if matches!(name, "det" | "transpose") && arguments.len() == 1 {
            let Value::Matrix(rows) = self.translate(cx, &arguments[0], conditions)? else {
                return Err(fault(arguments[0].span, "a matrix is needed here"));
            };
            return Ok(if name == "det" {
                if rows.len() != rows[0].len() || rows.len() > 6 {
                    return Err(fault(arguments[0].span, "a square matrix of at most 6 rows is needed here"));
                }
                Value::Scalar(self.determinant(&rows)?)
            } else {
                Value::Matrix((0..rows[0].len()).map(|j| rows.iter().map(|r| r[j].clone()).collect()).collect())
            });
        }
        let mut values = Vec::new();
        for argument in arguments {
            values.push(self.scalar(cx, argument, conditions)?);
        }
        let Some(value) = values.first().cloned() else {
            return Err(fault(function.span, "an argument is needed here"));
        };
        let text = format!("{name}({})", arguments.iter().map(text_of).collect::<Vec<_>>().join(", "));
        let half = Form::number(Rational::from_signeds(1, 2));
        Ok(Value::Scalar(match name {
            "sqrt" => self.raise(cx, &value, &half, &text, conditions)?,
            "cbrt" => self.raise(cx, &value, &Form::number(Rational::from_signeds(1, 3)), &text, conditions)?,
            "exp" => self.exponential(&value)?,
            "ln" => self.logarithm(cx, &value, &text, conditions)?,
            "cosh" | "sinh" | "tanh" | "sech" => {
                let up = self.exponential(&value)?;
                let down = self.ring.inverse(&up)?;
                let cosh = self.ring.add(&[up.clone(), down.clone()])?;
                let cosh = self.ring.mul(&cosh, &half)?;
                let sinh = self.ring.sub(&up, &down)?;
                let sinh = self.ring.mul(&sinh, &half)?;
                match name {
                    "cosh" => cosh,
                    "sinh" => sinh,
                    "tanh" => self.ring.div(&sinh, &cosh)?,
                    _ => self.ring.inverse(&cosh)?,
                }
            }
            _ => return Ok(Value::Scalar(self.member(cx, function, value, &text, conditions)?)),
        }))
    }

    fn determinant(&mut self, rows: &[Vec<Form>]) -> Result<Form> {
        if rows.len() == 1 {
            return Ok(rows[0][0].clone());
        }
        let mut sum = Vec::new();
        for (j, entry) in rows[0].iter().enumerate() {
            let minor: Vec<Vec<Form>> = rows[1..]
                .iter()
                .map(|r| r.iter().enumerate().filter(|(k, _)| *k != j).map(|(_, f)| f.clone()).collect())
                .collect();
            let minor = self.determinant(&minor)?;
            let term = self.ring.mul(entry, &minor)?;
            sum.push(if j % 2 == 0 { term } else { term.negated() });
        }
        Ok(self.ring.add(&sum)?)
    }

    /// A member of a family, or of a sequence: u(S + c) with a whole c > 0 unfolds to u(S).
    fn member(
        &mut self,
        cx: &mut Context,
        function: &Name,
        index: Form,
        text: &str,
        conditions: &mut Vec<Condition>,
    ) -> Result<Form> {
        let name = function.text.clone();
        if let Some(family) = cx.families.get(&name).cloned() {
            conditions.push(Condition {
                form: index.clone(),
                relation: Relation::GreaterEqual,
                text: format!("the index of {text}"),
            });
            if let Some((from, to)) = &family.binding.indices {
                // The names of a declaration are those of the claim, not of a sum around its use.
                let mut outer = cx.clone();
                outer.indices.clear();
                let from = self.scalar(&mut outer, from, conditions)?;
                let to = self.scalar(&mut outer, to, conditions)?;
                let low = self.ring.sub(&index, &from)?;
                let high = self.ring.sub(&to, &index)?;
                for form in [low, high] {
                    conditions.push(Condition {
                        form,
                        relation: Relation::GreaterEqual,
                        text: format!("the index of {text} within its range"),
                    });
                }
            }
            self.whole(cx, &index, text)?;
            return Ok(Form::atom(self.ring.intern(Atom::Member(name, index))));
        }
        let Some(sequence) = cx.sequences.get(&name).cloned() else {
            return Err(fault(function.span, &format!("{name} is not a function, family or sequence")));
        };
        self.whole(cx, &index, text)?;
        self.sequence(cx, &sequence, index, text, conditions)
    }

    fn sequence(
        &mut self,
        cx: &mut Context,
        sequence: &Rc<Sequence>,
        index: Form,
        text: &str,
        conditions: &mut Vec<Condition>,
    ) -> Result<Form> {
        self.tick()?;
        let (start, above) = split_constant(self, &index)?;
        // The names of a definition are those of the claim, not of a sum around its use.
        let mut inner = cx.clone();
        inner.indices.clear();
        if start.is_zero() && above == 0 {
            return self.scalar(&mut inner, &sequence.initial, conditions);
        }
        // Only where S is known to be at least 0 does u(S + c) unfold to u(S).
        let safe = start.is_zero() || self.signs(cx, &start)?.within(Signs::NOT_NEGATIVE);
        if above > 0 && safe && above <= WRITTEN_OUT {
            let below = self.ring.add(&[start, Form::integer(above - 1)])?;
            inner.indices.insert(sequence.index.clone(), below);
            return self.scalar(&mut inner, &sequence.step, conditions);
        }
        conditions.push(Condition {
            form: index.clone(),
            relation: Relation::GreaterEqual,
            text: format!("the index of {text}"),
        });
        Ok(Form::atom(self.ring.intern(Atom::Member(sequence.name.clone(), index))))
    }

    /// Whether an index is a whole number: an integer combination of natural variables.
    fn whole(&mut self, cx: &Context, index: &Form, text: &str) -> Result<()> {
        let summands = self.ring.summands(index)?;
        let fine = summands.iter().all(|f| {
            use malachite::base::num::conversion::traits::IsInteger;
            (&f.coefficient).is_integer()
                && f.powers
                    .iter()
                    .all(|(atom, exponent)| exponent.as_integer().is_some_and(|k| k >= 0) && self.is_natural(cx, *atom))
        });
        if fine { Ok(()) } else { Err(Failure::Undefined(format!("the index of {text} need not be a whole number"))) }
    }

    /// Whether an atom is a natural variable.
    pub fn is_natural(&self, cx: &Context, atom: u32) -> bool {
        match &*self.ring.atom(atom) {
            Atom::Variable(name) => {
                name.starts_with('#') || cx.variables.iter().any(|(v, natural)| v == name && *natural)
            }
            Atom::Member(name, _) => cx.families.get(name).is_some_and(|f| f.binding.natural),
            _ => false,
        }
    }

    /// base^exponent as a claim has it, with the condition that the form of the exponent asks of the base.
    fn power_valued(
        &mut self,
        cx: &mut Context,
        base: &Form,
        exponent: &Form,
        kind: definedness::Exponent,
        text: &str,
        conditions: &mut Vec<Condition>,
    ) -> Result<Form> {
        if kind == definedness::Exponent::Real {
            conditions.push(Condition { form: base.clone(), relation: Relation::Greater, text: text.to_string() });
            if base.is_zero() {
                return Err(Failure::Undefined(format!("in {text} the base is 0")));
            }
        }
        // Whole numbers and roots are looked at below; where a whole exponent is no number the base has to be positive.
        self.raise(cx, base, exponent, text, conditions)
    }

    /// base^exponent, where it has a value by the conditions of `Engine::power_valued` or because it was made from
    /// what has one.
    pub fn raise(
        &mut self,
        cx: &mut Context,
        base: &Form,
        exponent: &Form,
        text: &str,
        conditions: &mut Vec<Condition>,
    ) -> Result<Form> {
        let exponent = Exponent::of(exponent.clone());
        if let Some(k) = exponent.as_integer() {
            if k < 0 {
                conditions.push(Condition { form: base.clone(), relation: Relation::NotEqual, text: text.to_string() });
                if base.is_zero() {
                    return Err(Failure::Undefined(format!("{text} divides by 0")));
                }
            }
            return Ok(self.ring.power(base, &exponent)?);
        }
        // A root has no derivative at 0.
        if exponent.number().is_some() && exponent.order_sign().is_gt() && !cx.differentiated {
            if base.is_zero() {
                return Ok(Form::integer(0));
            }
            let base = self.non_negative_factors(cx, base, text, Signs::NOT_NEGATIVE)?;
            return Ok(self.ring.power(&base, &exponent)?);
        }
        if base.is_zero() {
            return Err(Failure::Undefined(format!("in {text} the base is 0")));
        }
        let base = self.non_negative_factors(cx, base, text, Signs::POSITIVE)?;
        Ok(self.ring.power(&base, &exponent)?)
    }

    /// The form with every factor in `wanted` (positive, or not negative); a sum known to be
    /// negative is exchanged for its opposite, in pairs.
    fn non_negative_factors(&mut self, cx: &mut Context, base: &Form, text: &str, wanted: Signs) -> Result<Form> {
        let mut out = base.clone();
        let powers = base.powers.clone();
        for (atom, exponent) in powers {
            let mut signs = self.atom_signs(cx, atom)?;
            if !signs.within(wanted) && !signs.within(Signs::NEGATIVE) {
                signs = self.searched_signs(cx, atom)?;
            }
            if signs.within(wanted) {
                continue;
            }
            if signs.within(Signs::NEGATIVE)
                && let Some(k) = exponent.as_integer()
                && let Some(poly) = self.ring.sum(atom)
            {
                let opposite =
                    crate::algebra::form::Poly { terms: poly.terms.iter().map(|(m, c)| (m.clone(), -c)).collect() };
                let flipped = self.ring.intern(Atom::Sum(Rc::new(opposite)));
                let exchange = Form {
                    coefficient: if k % 2 == 0 { Rational::ONE } else { -Rational::ONE },
                    powers: if atom < flipped {
                        vec![(atom, Exponent::integer(-k)), (flipped, Exponent::integer(k))]
                    } else {
                        vec![(flipped, Exponent::integer(k)), (atom, Exponent::integer(-k))]
                    },
                };
                out = self.ring.mul(&out, &exchange)?;
                let opposite_sign = Signs::POSITIVE;
                let sources = cx.memo.get(&atom).or(cx.signs.get(&atom)).map_or(0, |s| s.1);
                cx.signs.insert(flipped, (opposite_sign, sources));
                continue;
            }
            return Err(Failure::Undefined(format!(
                "in {text} the base is not known to be {}: {}",
                if wanted == Signs::POSITIVE { "positive" } else { "non-negative" },
                super::show::form(&self.ring, &Form::atom(atom))
            )));
        }
        if out.coefficient < 0 {
            return Err(Failure::Undefined(format!("in {text} the base is negative")));
        }
        Ok(out)
    }

    /// exp of a form: c·ln(a) becomes a^c, the rest a power of the base of natural exponentials.
    pub fn exponential(&mut self, form: &Form) -> Result<Form> {
        let mut out = Form::integer(1);
        let mut rest = Vec::new();
        for summand in self.ring.summands(form)? {
            let mut logarithm = None;
            for (place, (atom, exponent)) in summand.powers.iter().enumerate() {
                if let Atom::Logarithm(inner) = &*self.ring.atom(*atom)
                    && exponent.as_integer() == Some(1)
                {
                    logarithm = Some((place, *inner));
                }
            }
            match logarithm {
                Some((place, inner)) => {
                    let mut exponent = summand.clone();
                    exponent.powers.remove(place);
                    let power = self.ring.power(&Form::atom(inner), &Exponent::of(exponent))?;
                    out = self.ring.mul(&out, &power)?;
                }
                None => rest.push(summand),
            }
        }
        let rest = self.ring.add(&rest)?;
        if !rest.is_zero() {
            let euler = Form::atom(self.ring.intern(Atom::Euler));
            let power = self.ring.power(&euler, &Exponent::of(rest))?;
            out = self.ring.mul(&out, &power)?;
        }
        Ok(out)
    }

    /// The logarithm of a form, factor by factor.
    pub fn logarithm(
        &mut self,
        cx: &mut Context,
        form: &Form,
        text: &str,
        conditions: &mut Vec<Condition>,
    ) -> Result<Form> {
        conditions.push(Condition { form: form.clone(), relation: Relation::Greater, text: text.to_string() });
        if form.is_zero() {
            return Err(Failure::Undefined(format!("{text} takes the logarithm of 0")));
        }
        let form = self.non_negative_factors(cx, form, text, Signs::POSITIVE)?;
        let mut sum = vec![self.logarithm_of_number(&form.coefficient)?];
        sum.push(self.logarithm_of_powers(&form)?);
        Ok(self.ring.add(&sum)?)
    }

    /// The logarithm of a positive rational through its primes.
    fn logarithm_of_number(&mut self, q: &Rational) -> Result<Form> {
        let mut sum = Vec::new();
        for (value, sign) in [(q.numerator_ref().clone(), 1), (q.denominator_ref().clone(), -1)] {
            for (prime, k) in factor_number(value) {
                let atom = self.ring.intern(Atom::Prime(prime));
                let log = Form::atom(self.ring.intern(Atom::Logarithm(atom)));
                sum.push(self.ring.mul(&log, &Form::integer(sign * k))?);
            }
        }
        Ok(self.ring.add(&sum)?)
    }

    fn logarithm_of_powers(&mut self, form: &Form) -> Result<Form> {
        let mut sum = Vec::new();
        for (atom, exponent) in &form.powers {
            if matches!(*self.ring.atom(*atom), Atom::Euler) {
                sum.push(exponent.form());
                continue;
            }
            let log = Form::atom(self.ring.intern(Atom::Logarithm(*atom)));
            sum.push(self.ring.mul(&log, &exponent.form())?);
        }
        Ok(self.ring.add(&sum)?)
    }

    /// A sum or product over an index: constant ranges are written out; a last index S + c with a
    /// whole c is brought to S by splitting off members; a first index 0 to 1 likewise.
    fn over(
        &mut self,
        cx: &mut Context,
        index: &Index,
        body: &Expr,
        is_sum: bool,
        conditions: &mut Vec<Condition>,
    ) -> Result<Form> {
        let from = self.scalar(cx, &index.from, conditions)?;
        let to = self.scalar(cx, &index.to, conditions)?;
        let name = index.name.text.clone();
        let text = format!("the range of {name}");
        self.whole(cx, &from, &text)?;
        self.whole(cx, &to, &text)?;
        let (first, low) = split_constant(self, &from)?;
        let (last, high) = split_constant(self, &to)?;
        let mut parts = Vec::new();
        let spread = self.ring.sub(&to, &from)?;
        if let Some(spread) = spread.as_number().cloned() {
            let count = i64::try_from(&spread).unwrap_or(i64::MAX);
            if count < -1 {
                return Err(Failure::Undefined(format!("{text} ends before it begins")));
            }
            if count >= WRITTEN_OUT {
                return Err(Failure::Limit("range"));
            }
            for k in 0..=count {
                let at = self.ring.add(&[from.clone(), Form::integer(k)])?;
                parts.push(self.body_at(cx, &name, at, body, conditions)?);
            }
            return self.combined(&parts, is_sum);
        }
        // Below, the index counts as a natural number. A range that begins below 0 has its meaning all the same: that it
        // does not is nothing that a hypothesis says by mentioning it.
        if !self.not_negative(cx, &from)? {
            return Err(Failure::NotShown(format!("{text} begins at 0 or above")));
        }
        // The part from `first + low` to `last`, and members split off at either end.
        let mut from = from;
        let mut low = low;
        let room = |engine: &mut Self, cx: &mut Context, to: &Form, from: &Form, plus: i64| -> Result<bool> {
            let spread = engine.ring.sub(to, from)?;
            let spread = engine.ring.add(&[spread, Form::integer(plus)])?;
            Ok(engine.searched_form_signs(cx, &spread)?.within(Signs::NOT_NEGATIVE))
        };
        if !room(self, cx, &to, &from, 1)? {
            return Err(Failure::Undefined(format!("{text} may end before it begins")));
        }
        let mut to = to;
        let mut high = high;
        while high > 0 && high <= WRITTEN_OUT {
            let lower = self.ring.add(&[last.clone(), Form::integer(high - 1)])?;
            if !room(self, cx, &lower, &from, 1)? {
                break;
            }
            parts.push(self.body_at(cx, &name, to.clone(), body, conditions)?);
            to = lower;
            high -= 1;
        }
        if first.is_zero() && low == 0 && room(self, cx, &to, &from, 0)? {
            parts.push(self.body_at(cx, &name, from.clone(), body, conditions)?);
            low = 1;
            from = Form::integer(low);
        }
        let mut inner = cx.clone();
        let (bound, atom) = self.free_index(&mut inner);
        inner.indices.insert(name.clone(), Form::atom(atom));
        inner.variables.push((bound.clone(), true));
        // Within the body the index lies in its range.
        for (a, b) in [(Form::atom(atom), from.clone()), (to.clone(), Form::atom(atom))] {
            let difference = self.ring.sub(&a, &b)?;
            self.narrow_form(&mut inner, &difference, Relation::GreaterEqual, 0)?;
        }
        let mut inside = Vec::new();
        let form = self.scalar(&mut inner, body, &mut inside)?;
        for condition in inside {
            if !self.searched_form_signs(&mut inner, &condition.form)?.within(Signs::of(condition.relation)) {
                return Err(Failure::Undefined(condition.text));
            }
        }
        let over = |body: Form| Box::new(Over { index: atom, body, from: from.clone(), to: to.clone() });
        let (mut outside, mut within) = (Form::integer(1), Form::integer(1));
        let count = self.ring.sub(&to, &from)?;
        let count = Exponent::of(self.ring.add(&[count, Form::integer(1)])?);
        for (a, e) in &form.powers {
            let factor = Form { coefficient: Rational::ONE, powers: vec![(*a, e.clone())] };
            if self.ring.mentions(&factor, &|x| x == atom) {
                // An empty product is 1 even where an exponent has no value.
                let fixed = match e {
                    Exponent::Number(_) => true,
                    Exponent::Symbolic(e) => {
                        !is_sum && !self.ring.mentions(e, &|x| x == atom) && self.have_values(cx, &e.powers)?
                    }
                };
                if is_sum || !fixed {
                    within = self.ring.mul(&within, &factor)?;
                } else {
                    // ∏ a^E = (∏ a)^E, E fixed; positive a where E is no whole number.
                    let product = self.ring.intern(Atom::ProductOver(over(Form::atom(*a))));
                    let whole = e.as_integer().is_some();
                    if !whole && !self.atom_signs(&mut inner, *a)?.within(Signs::POSITIVE) {
                        return Err(Failure::Undefined(text.clone()));
                    }
                    let power = self.ring.power(&Form::atom(product), e)?;
                    outside = self.ring.mul(&outside, &power)?;
                }
            } else if !self.has_value(cx, *a, e)? {
                // An empty sum is 0, and an empty product 1, even where members would have no value: what is taken out
                // has one anyway.
                within = self.ring.mul(&within, &factor)?;
            } else if is_sum {
                outside = self.ring.mul(&outside, &factor)?;
            } else {
                let power = self.raise(cx, &factor, &count.form(), &text, conditions)?;
                outside = self.ring.mul(&outside, &power)?;
            }
        }
        let coefficient = Form::number(form.coefficient.clone());
        if form.is_zero() {
            return self
                .combined(&parts, is_sum)
                .and_then(|p| if is_sum { Ok(p) } else { Err(Failure::NotShown(text)) });
        }
        let coefficient =
            if is_sum { coefficient } else { self.raise(cx, &coefficient, &count.form(), &text, conditions)? };
        outside = self.ring.mul(&outside, &coefficient)?;
        if is_sum || !within.powers.is_empty() {
            let kind = if is_sum { Atom::SumOver(over(within)) } else { Atom::ProductOver(over(within)) };
            let whole = self.ring.intern(kind);
            outside = self.ring.mul(&outside, &Form::atom(whole))?;
        }
        parts.push(outside);
        self.combined(&parts, is_sum)
    }

    /// A name for the index of a sum or product: the first that no sum around it has, whose index may stand in what the
    /// names of the scope are short for.
    fn free_index(&mut self, cx: &mut Context) -> (String, u32) {
        loop {
            cx.binders += 1;
            let name = format!("#{}", cx.binders);
            let atom = self.ring.intern(Atom::Variable(name.clone()));
            let mut values = cx.indices.values().chain(cx.environment.values().map(|v| &v.0));
            let taken =
                cx.variables.iter().any(|v| v.0 == name) || values.any(|f| self.ring.mentions(f, &|a| a == atom));
            if !taken {
                return (name, atom);
            }
        }
    }

    /// Whether a power of an atom, which has a value in the body of a sum, has one outside it, too.
    fn has_value(&mut self, cx: &mut Context, atom: u32, exponent: &Exponent) -> Result<bool> {
        let signs = match (exponent.as_integer(), exponent.number()) {
            (Some(k), _) if k > 0 => None,
            (Some(_), _) => Some(Signs::NOT_ZERO),
            (None, Some(q)) if *q > 0 => Some(Signs::NOT_NEGATIVE),
            _ => Some(Signs::POSITIVE),
        };
        if let Some(signs) = signs
            && !self.searched_signs(cx, atom)?.within(signs)
        {
            return Ok(false);
        }
        if let Exponent::Symbolic(form) = exponent
            && !self.have_values(cx, &form.powers)?
        {
            return Ok(false);
        }
        Ok(match &*self.ring.atom(atom) {
            Atom::Variable(_) | Atom::Prime(_) | Atom::Euler => true,
            Atom::Member(name, index) => match cx.families.get(name).cloned() {
                Some(family) => self.in_range(cx, &family, index)?,
                None => self.not_negative(cx, index)?,
            },
            Atom::Sum(poly) => {
                for (monomial, _) in &poly.terms {
                    if !self.have_values(cx, monomial)? {
                        return Ok(false);
                    }
                }
                true
            }
            Atom::Logarithm(inner) => {
                self.has_value(cx, *inner, &Exponent::integer(1))?
                    && self.searched_signs(cx, *inner)?.within(Signs::POSITIVE)
            }
            // The signs that hold within its range are not known here.
            Atom::SumOver(over) | Atom::ProductOver(over) => self.polynomial(&over.body),
        })
    }

    /// Whether all these powers have values.
    fn have_values(&mut self, cx: &mut Context, powers: &[(u32, Exponent)]) -> Result<bool> {
        for (atom, exponent) in powers {
            if !self.has_value(cx, *atom, exponent)? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Whether a form is made by adding and multiplying alone.
    fn polynomial(&self, form: &Form) -> bool {
        form.powers.iter().all(|(atom, exponent)| {
            exponent.as_integer().is_some_and(|k| k > 0)
                && match &*self.ring.atom(*atom) {
                    Atom::Variable(_) | Atom::Prime(_) | Atom::Euler => true,
                    // A family may have a range.
                    Atom::Member(..) => false,
                    Atom::Sum(poly) => poly.terms.iter().all(|(monomial, _)| {
                        self.polynomial(&Form { coefficient: Rational::ONE, powers: monomial.clone() })
                    }),
                    Atom::SumOver(over) | Atom::ProductOver(over) => self.polynomial(&over.body),
                    Atom::Logarithm(_) => false,
                }
        })
    }

    fn combined(&mut self, parts: &[Form], is_sum: bool) -> Result<Form> {
        if is_sum {
            return Ok(self.ring.add(parts)?);
        }
        let mut product = Form::integer(1);
        for part in parts {
            product = self.ring.mul(&product, part)?;
        }
        Ok(product)
    }

    fn body_at(
        &mut self,
        cx: &Context,
        name: &str,
        at: Form,
        body: &Expr,
        conditions: &mut Vec<Condition>,
    ) -> Result<Form> {
        let mut inner = cx.clone();
        inner.indices.insert(name.to_string(), at);
        self.scalar(&mut inner, body, conditions)
    }
}

/// f = S + c with a whole c, S without a constant term (0 where f is a number).
fn split_constant(engine: &mut Engine, form: &Form) -> Result<(Form, i64)> {
    let mut constant = Rational::ZERO;
    let mut rest = Vec::new();
    for summand in engine.ring.summands(form)? {
        match summand.as_number() {
            Some(q) => constant += q,
            None => rest.push(summand),
        }
    }
    let Ok(c) = i64::try_from(&constant) else { return Ok((form.clone(), 0)) };
    Ok((engine.ring.add(&rest)?, c))
}

/// Whether a name stands for natural numbers: a variable, an index, or a family of them.
pub fn is_natural_name(cx: &Context, name: &str) -> bool {
    cx.indices.contains_key(name)
        || cx.variables.iter().any(|(v, natural)| v == name && *natural)
        || cx.families.get(name).is_some_and(|f| f.binding.natural)
}

/// Whether a hypothesis may tie a variable to others.
fn tied(cx: &Context, variable: &str) -> bool {
    let mut said = cx.facts.iter();
    // What a declaration says of the members of a family is not among the facts.
    let members =
        cx.families.values().any(|family| super::expand::names_of_binding(&family.binding).contains(variable));
    members || said.any(|fact| ties(&fact.prop, variable))
}

/// Whether a hypothesis, other than a strict comparison, has a variable and another name in it: alone or with others it
/// may determine one by the other, as `x*y <= 1` and `x*y >= 1` do. Derivatives are partial all the same, all other
/// variables held fast; this only refuses to speak of them where a reader could think of another derivative.
pub fn ties(prop: &Prop, variable: &str) -> bool {
    let strict = [Relation::Less, Relation::Greater, Relation::NotEqual];
    let open = match &prop.kind {
        PropKind::Compare(_, relations) => relations.iter().all(|r| strict.contains(r)),
        _ => false,
    };
    let mut names = super::expand::names_of_prop(prop);
    names.retain(|name| !FUNCTIONS.iter().any(|f| f.0 == name));
    !open && names.contains(variable) && names.len() > 1
}

/// The text of an expression.
pub fn text_of(expr: &Expr) -> String {
    crate::claim::print::expr(expr)
}

/// A fault in the text.
pub fn fault(span: Span, message: &str) -> Failure {
    Failure::Fault(Diagnose { message: message.to_string(), help: None, span })
}
