//! Expressions at exact points.
//!
//! Contract: a value is exact, or an interval that contains it. *Undefined* means that the expression has no value at the point;
//! *unknown* that it is not computed.

use super::Moment;
use super::expand::parts;
use super::matrix::{Value, determinant};
use super::number::{
    LARGEST, Missing, Number, Result, add, arc, between, cosine_and_sine, exponential, hyperbolic, invert, large_power,
    logarithm, multiply, negate, of_some_size, pi, root, whole_power,
};
use super::quantified::QUANTIFIERS;
use super::recurrence::{Members, Recurrence};
use crate::claim::definedness::{self, Exponent, Need};
use crate::claim::print;
use crate::claim::syntax::*;
use crate::claim::write_out::Words;
use crate::kernel::statement::{Sequence, steps_once};
use crate::number::rational;
use malachite::base::num::arithmetic::traits::Pow;
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::conversion::traits::IsInteger;
use malachite::{Integer, Rational};
use rustc_hash::{FxHashMap as HashMap, FxHashSet as HashSet};
use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
use std::rc::Rc;

/// How many expressions are evaluated at one point.
pub(crate) const STEPS: u32 = 100_000;

/// Into how many parts the interval of an integral is cut.
const PARTS: u32 = 64;

/// After how many of them the clock is looked at.
const TICK: u32 = 128;

/// A point: values of variables and of members of families.
#[derive(Clone, Debug)]
pub struct Assignment {
    /// How messages call what the reader gave a name.
    pub words: Rc<Words>,
    /// Variables.
    pub values: HashMap<String, Rational>,
    /// Variables with irrational values.
    pub numbers: Rc<HashMap<String, Number>>,
    /// Bound indices: they hide variables in what they bind, but not in the definitions of sequences and ranges.
    pub indices: HashMap<String, Rational>,
    /// Whether `pi` is π: the claim does not declare it.
    pub is_pi: bool,
    /// Variables and families that are natural numbers by their declaration.
    pub naturals: Rc<HashSet<String>>,
    /// Families: values for their members, repeated cyclically.
    pub families: HashMap<String, Vec<Rational>>,
    /// Families that are geometric: the ratio of a member to the one before it; the first of the
    /// family's values is member 0.
    pub ratios: HashMap<String, Rational>,
    /// Pairs of expressions, as printed, that are known to be equal wherever both have values.
    pub identities: Rc<HashSet<(String, String)>>,
    /// Formulas of derivatives, as printed, that have the value of the derivative wherever both have values.
    pub derivatives: Rc<HashMap<String, Expr>>,
    /// Sequences.
    pub sequences: Rc<BTreeMap<String, Rc<Sequence>>>,
    /// Families that recurrences determine.
    pub recurrences: Rc<BTreeMap<String, Recurrence>>,
    /// Their members so far.
    pub members: Members,
    /// Index ranges of families: first and last.
    pub ranges: Rc<HashMap<String, (Expr, Expr)>>,
    /// The members that were evaluated.
    pub seen: RefCell<BTreeMap<(String, i64), Rational>>,
    /// How many expressions may still be evaluated, here and in copies of the point.
    pub steps: Rc<Cell<u32>>,
    /// When no more are evaluated.
    pub until: Option<Moment>,
    /// How many quantifiers may still be decided, here and at the other points of a search.
    pub quantifiers: Rc<Cell<u32>>,
}

impl Default for Assignment {
    fn default() -> Assignment {
        Assignment {
            words: Rc::default(),
            values: HashMap::default(),
            numbers: Rc::default(),
            is_pi: false,
            indices: HashMap::default(),
            naturals: Rc::default(),
            families: HashMap::default(),
            ratios: HashMap::default(),
            identities: Rc::default(),
            derivatives: Rc::default(),
            sequences: Rc::default(),
            recurrences: Rc::default(),
            members: Members::default(),
            ranges: Rc::default(),
            seen: RefCell::default(),
            steps: Rc::new(Cell::new(STEPS)),
            until: None,
            quantifiers: Rc::new(Cell::new(QUANTIFIERS)),
        }
    }
}

impl Assignment {
    /// An expression in the words of the claim's author, as text.
    pub(super) fn said(&self, e: &Expr) -> String {
        print::expr(&self.words.expr(e))
    }

    /// Gives a variable its value.
    pub fn give(&mut self, name: &str, value: Number) {
        match value {
            Number::Exact(q) => drop(self.values.insert(name.to_string(), q)),
            number => {
                self.values.remove(name);
                Rc::make_mut(&mut self.numbers).insert(name.to_string(), number);
            }
        }
    }

    /// The value of a scalar expression.
    pub fn number(&self, e: &Expr) -> Result<Number> {
        match self.value(e)? {
            Value::Scalar(number) => Ok(number),
            Value::Matrix(_) => Err(Missing::Unknown),
        }
    }

    pub(super) fn value(&self, e: &Expr) -> Result<Value> {
        use ExprKind::*;
        // The clock is looked at now and then.
        let is_late = |left: u32| left.is_multiple_of(TICK) && self.until.is_some_and(|end| Moment::now() > end);
        match self.steps.get().checked_sub(1).filter(|left| !is_late(*left)) {
            Some(left) => self.steps.set(left),
            None => return Err(Missing::Unknown),
        }
        Ok(Value::Scalar(match &e.kind {
            Number(text) => self::Number::Exact(rational::parse(text).map_err(|_| Missing::Unknown)?),
            Name(name) => {
                let value = self.indices.get(name).or_else(|| self.values.get(name)).cloned();
                let value = value.map(self::Number::Exact).or_else(|| self.numbers.get(name).cloned());
                let value = value.or_else(|| (self.is_pi && name == PI).then(pi));
                value.ok_or(Missing::Unknown)?
            }
            Negate(a) => return self.value(a).map(Value::negated),
            Sum(list) => return self.sum(list),
            Product(list) => return self.product(list),
            Power(a, b) => {
                let kind =
                    definedness::exponent(b, &|name| self.is_natural_name(name)).map_err(|_| Missing::Unknown)?;
                self.power(&self.number(a)?, &self.number(b)?, kind, e)?
            }
            Apply(name, arguments) => return self.apply(name, arguments, e),
            SumOver(index, body) => self.over(true, index, body)?,
            ProductOver(index, body) => self.over(false, index, body)?,
            IntegralOver(variable, body) => self.integral(variable, body)?,
            Derivative(body, _) => self.derivative(e, body)?,
            Matrix(rows) => {
                let rows: Result<Vec<Vec<self::Number>>> =
                    rows.iter().map(|r| r.iter().map(|x| self.number(x)).collect()).collect();
                return Ok(Value::Matrix(rows?));
            }
        }))
    }

    /// The sum of scalars, or of matrices of one size.
    fn sum(&self, list: &[(Sign, Expr)]) -> Result<Value> {
        let mut sum: Option<Value> = None;
        for (sign, summand) in list {
            let value = self.value(summand)?;
            let value = if *sign == Sign::Plus { value } else { value.negated() };
            sum = Some(match sum {
                None => value,
                Some(sum) => sum.plus(&value)?,
            });
        }
        sum.ok_or(Missing::Unknown)
    }

    /// The product, from the left.
    fn product(&self, list: &[(Factor, Expr)]) -> Result<Value> {
        let mut product = Value::Scalar(Number::Exact(Rational::ONE));
        for (operator, factor) in list {
            let value = self.value(factor)?;
            let divisor = if *operator == Factor::Over { Some(factor) } else { None };
            product = product.times(value, divisor.map(|e| || self.said(e)))?;
        }
        Ok(product)
    }

    /// A derivative, by its formula. It has no value where what is differentiated has none.
    fn derivative(&self, e: &Expr, body: &Expr) -> Result<Number> {
        self.value(body)?;
        let formula = self.derivatives.get(&print::expr(e)).filter(|_| self.is_smooth(body));
        self.number(formula.ok_or(Missing::Unknown)?).map_err(|_| Missing::Unknown)
    }

    /// Whether an expression that has a value here has derivatives here by its form: no root of 0 stands in it.
    fn is_smooth(&self, e: &Expr) -> bool {
        let is_above_0 = |e: &Expr| self.number(e).is_ok_and(|value| *value.ends().0 > 0);
        let Ok(needs) = definedness::needs(e, &|name| self.is_natural_name(name)) else { return false };
        let mut smooth = needs.iter().all(|need| match need {
            Need::NotNegative(base) => is_above_0(base),
            _ => true,
        });
        parts(e, &mut |part| smooth = smooth && self.is_smooth(part));
        smooth
    }

    /// A sum or product over an index.
    fn over(&self, is_sum: bool, index: &Index, body: &Expr) -> Result<Number> {
        let (from, to) = (self.whole(&index.from)?, self.whole(&index.to)?);
        let Some(length) = to.checked_sub(from) else { return Err(Missing::Unknown) };
        if length < -1 {
            return Err(Missing::Undefined(format!("the range of {} ends before it begins", index.name.text)));
        }
        if length > LARGEST {
            return Err(Missing::Unknown);
        }
        let mut total = Number::Exact(if is_sum { Rational::ZERO } else { Rational::ONE });
        let mut inner = self.clone();
        for k in from..=to {
            inner.indices.insert(index.name.text.clone(), Rational::from(k));
            let value = inner.number(body)?;
            total = of_some_size(if is_sum { add(&total, &value) } else { multiply(&total, &value) })?;
        }
        self.seen.replace(inner.seen.take());
        Ok(total)
    }

    /// An integral: the run b − a times the integral of f(a + u·(b − a)) for u from 0 to 1. The integrand has a value on each of so many
    /// parts of the interval, and the mean of these values contains that integral.
    fn integral(&self, variable: &Index, body: &Expr) -> Result<Number> {
        let (from, to) = (self.number(&variable.from)?, self.number(&variable.to)?);
        let run = add(&to, &negate(&from));
        let part = Number::Exact(Rational::from_unsigneds(1, PARTS));
        let mut inner = self.clone();
        inner.indices.remove(&variable.name.text);
        inner.values.remove(&variable.name.text);
        let mut total = Number::Exact(Rational::ZERO);
        for k in 0..PARTS {
            let [low, high] = [k, k + 1].map(|k| Rational::from_unsigneds(k, PARTS));
            let x = add(&from, &multiply(&between(low, high), &run));
            Rc::make_mut(&mut inner.numbers).insert(variable.name.text.clone(), x);
            let value = inner.number(body).map_err(|_| Missing::Unknown)?;
            total = of_some_size(add(&total, &multiply(&part, &value)))?;
        }
        Ok(multiply(&run, &total))
    }

    fn whole(&self, e: &Expr) -> Result<i64> {
        match self.number(e)? {
            Number::Exact(q) => i64::try_from(&q).map_err(|_| match (&q).is_integer() {
                true => Missing::Unknown,
                false => Missing::Undefined(format!("{} is no whole number", self.said(e))),
            }),
            Number::Between(..) => Err(Missing::Unknown),
        }
    }

    pub(super) fn power(&self, a: &Number, b: &Number, kind: Exponent, e: &Expr) -> Result<Number> {
        let text = || self.said(e);
        let (low, high) = a.ends();
        let missing = match kind {
            Exponent::Whole => false,
            Exponent::Root => *high < 0,
            Exponent::Real => *high <= 0,
        };
        if missing {
            let wanted = if kind == Exponent::Root { "at least 0" } else { "above 0" };
            return Err(Missing::Undefined(format!("{} has a value only where the base is {wanted}", text())));
        }
        if kind != Exponent::Whole && (*low < 0 || kind == Exponent::Real && *low == 0) {
            return Err(Missing::Unknown);
        }
        let Number::Exact(q) = b else {
            // a^b = exp(b·ln a) for a > 0.
            if *a.ends().0 <= 0 {
                return Err(Missing::Unknown);
            }
            return exponential(&multiply(b, &logarithm(a, text)?));
        };
        let (Ok(p), Ok(k)) =
            (i64::try_from(&Integer::from(q.numerator_ref())), i64::try_from(&Integer::from(q.denominator_ref())))
        else {
            return Err(Missing::Unknown);
        };
        if k == 1 && p.unsigned_abs() > LARGEST.unsigned_abs() {
            return large_power(a, p, *q < 0, text);
        }
        if p.unsigned_abs() > LARGEST.unsigned_abs() || k > LARGEST {
            return Err(Missing::Unknown);
        }
        let base = if k == 1 { a.clone() } else { root(a, k.unsigned_abs()) };
        let power = whole_power(&base, p.unsigned_abs())?;
        if *q < 0 { invert(&power, text) } else { Ok(power) }
    }

    /// Whether a name stands for natural numbers: a variable, an index, or a family of them.
    fn is_natural_name(&self, name: &str) -> bool {
        self.indices.contains_key(name) || self.naturals.contains(name)
    }

    fn apply(&self, name: &Name, arguments: &[Expr], e: &Expr) -> Result<Value> {
        let text = name.text.as_str();
        if matches!(text, "det" | "transpose") {
            let Some(Value::Matrix(m)) = arguments.first().map(|a| self.value(a)).transpose()? else {
                return Err(Missing::Unknown);
            };
            if text == "transpose" {
                return Ok(Value::Matrix((0..m[0].len()).map(|j| m.iter().map(|r| r[j].clone()).collect()).collect()));
            }
            return determinant(&m).map(Value::Scalar);
        }
        let argument = arguments.first().ok_or(Missing::Unknown)?;
        let half = |k: i64| Number::Exact(Rational::from_signeds(1, k));
        Ok(Value::Scalar(match text {
            "sqrt" => self.power(&self.number(argument)?, &half(2), Exponent::Root, e)?,
            "cbrt" => self.power(&self.number(argument)?, &half(3), Exponent::Root, e)?,
            "exp" => exponential(&self.number(argument)?)?,
            "cos" => cosine_and_sine(&self.number(argument)?)?.0,
            "sin" => cosine_and_sine(&self.number(argument)?)?.1,
            "ln" => logarithm(&self.number(argument)?, || self.said(e))?,
            "arcsin" | "arccos" | "arctan" => arc(text, &self.number(argument)?, || self.said(e))?,
            "cosh" | "sinh" | "tanh" | "sech" => hyperbolic(text, &self.number(argument)?)?,
            _ => self.indexed(name, argument)?,
        }))
    }

    /// A member of a family or sequence.
    fn indexed(&self, name: &Name, argument: &Expr) -> Result<Number> {
        let text = name.text.as_str();
        let index = self.whole(argument)?;
        if index < 0 {
            return Err(Missing::Undefined(format!("{} has no member {index}", name.text)));
        }
        if let Some((from, to)) = self.ranges.get(text)
            && let point = self.without_indices()
            && !(point.whole(from)? <= index && index <= point.whole(to)?)
        {
            return Err(Missing::Undefined(format!("{text}({index}) lies outside the range of {text}")));
        }
        if index > LARGEST {
            return Err(Missing::Unknown);
        }
        Ok(if let Some(recurrence) = self.recurrences.get(text) {
            let index = usize::try_from(index).map_err(|_| Missing::Unknown)?;
            let value = self.recurrent(text, index)?;
            let members = self.members.borrow();
            let first = members.get(text).into_iter().flatten().take(recurrence.order);
            let first = (0i64..).zip(first).map(|(k, q)| ((name.text.clone(), k), q.clone()));
            self.seen.borrow_mut().extend(first);
            Number::Exact(value)
        } else if let (Some(list), Some(ratio)) = (self.families.get(text), self.ratios.get(text)) {
            let value = list.first().ok_or(Missing::Unknown)? * ratio.pow(index);
            self.seen.borrow_mut().insert((name.text.clone(), index), value.clone());
            Number::Exact(value)
        } else if let Some(list) = self.families.get(text) {
            let place = usize::try_from(index).unwrap_or(0) % list.len().max(1);
            let value = list.get(place).cloned().ok_or(Missing::Unknown)?;
            self.seen.borrow_mut().insert((name.text.clone(), index), value.clone());
            Number::Exact(value)
        } else if let Some(sequence) = self.sequences.get(text).cloned() {
            self.member(&sequence, index)?
        } else {
            return Err(Missing::Unknown);
        })
    }

    /// The point as definitions see it: the claim's variables alone.
    fn without_indices(&self) -> Assignment {
        Assignment { indices: HashMap::default(), ..self.clone() }
    }

    /// u(k), each member evaluated once: the step may mention the member before it, which is bound
    /// as a value of its own.
    fn member(&self, sequence: &Sequence, index: i64) -> Result<Number> {
        if !steps_once(&sequence.step, &sequence.name, &sequence.index) {
            return Err(Missing::Unknown);
        }
        let outer = self.without_indices();
        let mut value = outer.number(&sequence.initial)?;
        self.seen.borrow_mut().extend(outer.seen.take());
        let mut inner = outer;
        Rc::make_mut(&mut inner.sequences).remove(&sequence.name);
        for k in 0..index {
            let Number::Exact(known) = value else { return Err(Missing::Unknown) };
            inner.indices.insert(sequence.index.clone(), Rational::from(k));
            inner.families.insert(sequence.name.clone(), vec![known]);
            value = inner.number(&sequence.step)?;
        }
        let seen = inner.seen.take();
        self.seen.borrow_mut().extend(seen.into_iter().filter(|s| s.0.0 != sequence.name));
        Ok(value)
    }
}
