//! Expressions and propositions at exact points.
//!
//! Contract: a value is exact, or an interval that contains it; a truth value is given only when it is
//! certain. *Undefined* means that the expression has no value at the point. *Unknown* means that intervals
//! do not decide. Neither counts as false.

use super::expand::Sequence;
use super::number::{
    LARGEST, Missing, Number, Result, add, exponential, holds, hyperbolic, invert, large_power, logarithm, multiply,
    negate, of_some_size, root, whole_power,
};
use super::recurrence::{Members, Recurrence};
use crate::claim::definedness::{self, Exponent};
use crate::claim::syntax::*;
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

/// A point: values of variables and of members of families.
#[derive(Clone, Debug)]
pub struct Assignment {
    /// Variables.
    pub values: HashMap<String, Rational>,
    /// Bound indices: they hide variables in what they bind, but not in the definitions of sequences and ranges.
    pub indices: HashMap<String, Rational>,
    /// Variables and families that are natural numbers by their declaration.
    pub naturals: Rc<HashSet<String>>,
    /// Families: values for their members, repeated cyclically.
    pub families: HashMap<String, Vec<Rational>>,
    /// Families that are geometric: the ratio of a member to the one before it; the first of the
    /// family's values is member 0.
    pub ratios: HashMap<String, Rational>,
    /// Pairs of expressions, as printed, that are known to be equal wherever both have values.
    pub identities: Rc<HashSet<(String, String)>>,
    /// Sequences.
    pub sequences: BTreeMap<String, Sequence>,
    /// Families that recurrences determine.
    pub recurrences: Rc<BTreeMap<String, Recurrence>>,
    /// Their members so far.
    pub members: Members,
    /// Index ranges of families: first and last.
    pub ranges: HashMap<String, (Expr, Expr)>,
    /// The members that were evaluated.
    pub seen: RefCell<BTreeMap<(String, i64), Rational>>,
    /// How many expressions may still be evaluated, here and in copies of the point.
    pub steps: Rc<Cell<u32>>,
}

impl Default for Assignment {
    fn default() -> Assignment {
        Assignment {
            values: HashMap::default(),
            indices: HashMap::default(),
            naturals: Rc::default(),
            families: HashMap::default(),
            ratios: HashMap::default(),
            identities: Rc::default(),
            sequences: BTreeMap::new(),
            recurrences: Rc::default(),
            members: Members::default(),
            ranges: HashMap::default(),
            seen: RefCell::default(),
            steps: Rc::new(Cell::new(STEPS)),
        }
    }
}

/// A scalar or a matrix of numbers.
enum Value {
    Scalar(Number),
    Matrix(Vec<Vec<Number>>),
}

impl Assignment {
    /// The value of a scalar expression.
    pub fn number(&self, e: &Expr) -> Result<Number> {
        match self.value(e)? {
            Value::Scalar(number) => Ok(number),
            Value::Matrix(_) => Err(Missing::Unknown),
        }
    }

    fn value(&self, e: &Expr) -> Result<Value> {
        use ExprKind::*;
        match self.steps.get().checked_sub(1) {
            Some(left) => self.steps.set(left),
            None => return Err(Missing::Unknown),
        }
        Ok(Value::Scalar(match &e.kind {
            Number(text) => self::Number::Exact(rational::parse(text).map_err(|_| Missing::Unknown)?),
            Name(name) => {
                let value = self.indices.get(name).or_else(|| self.values.get(name));
                self::Number::Exact(value.cloned().ok_or(Missing::Unknown)?)
            }
            Negate(a) => match self.value(a)? {
                Value::Scalar(a) => negate(&a),
                Value::Matrix(rows) => {
                    return Ok(Value::Matrix(rows.iter().map(|r| r.iter().map(negate).collect()).collect()));
                }
            },
            Sum(list) => {
                let mut sum: Option<Value> = None;
                for (sign, summand) in list {
                    let flip = |n: self::Number| if *sign == Sign::Plus { n } else { negate(&n) };
                    let value = match self.value(summand)? {
                        Value::Scalar(n) => Value::Scalar(flip(n)),
                        Value::Matrix(rows) => {
                            Value::Matrix(rows.into_iter().map(|r| r.into_iter().map(flip).collect()).collect())
                        }
                    };
                    sum = Some(match (sum, value) {
                        (None, value) => value,
                        (Some(Value::Scalar(a)), Value::Scalar(b)) => Value::Scalar(of_some_size(add(&a, &b))?),
                        (Some(Value::Matrix(a)), Value::Matrix(b)) if !same_size(&a, &b) => {
                            return Err(Missing::Unknown);
                        }
                        (Some(Value::Matrix(a)), Value::Matrix(b)) => Value::Matrix(
                            a.iter().zip(&b).map(|(r, s)| r.iter().zip(s).map(|(x, y)| add(x, y)).collect()).collect(),
                        ),
                        _ => return Err(Missing::Unknown),
                    });
                }
                return sum.ok_or(Missing::Unknown);
            }
            Product(list) => {
                let mut product = Value::Scalar(self::Number::Exact(Rational::ONE));
                for (operator, factor) in list {
                    let value = self.value(factor)?;
                    product = match (product, value) {
                        (Value::Scalar(a), Value::Scalar(b)) => {
                            let b = if *operator == Factor::Over {
                                invert(&b, || crate::claim::print::expr(factor))?
                            } else {
                                b
                            };
                            Value::Scalar(of_some_size(multiply(&a, &b))?)
                        }
                        (Value::Matrix(m), Value::Scalar(b)) | (Value::Scalar(b), Value::Matrix(m)) => {
                            let b = if *operator == Factor::Over {
                                invert(&b, || crate::claim::print::expr(factor))?
                            } else {
                                b
                            };
                            Value::Matrix(m.iter().map(|r| r.iter().map(|x| multiply(x, &b)).collect()).collect())
                        }
                        (Value::Matrix(a), Value::Matrix(b)) => {
                            if a[0].len() != b.len() {
                                return Err(Missing::Unknown);
                            }
                            let cell = |row: &Vec<self::Number>, j: usize| {
                                row.iter().zip(&b).fold(self::Number::Exact(Rational::ZERO), |sum, (x, r)| {
                                    add(&sum, &multiply(x, &r[j]))
                                })
                            };
                            Value::Matrix(a.iter().map(|row| (0..b[0].len()).map(|j| cell(row, j)).collect()).collect())
                        }
                    };
                }
                return Ok(product);
            }
            Power(a, b) => {
                let kind = definedness::exponent(b, &|name| self.is_natural_name(name));
                self.power(&self.number(a)?, &self.number(b)?, kind, e)?
            }
            Apply(name, arguments) => return self.apply(name, arguments, e),
            SumOver(index, body) | ProductOver(index, body) => {
                let is_sum = matches!(&e.kind, SumOver(..));
                let (from, to) = (self.whole(&index.from)?, self.whole(&index.to)?);
                let Some(length) = to.checked_sub(from) else { return Err(Missing::Unknown) };
                if length < -1 {
                    return Err(Missing::Undefined(format!("the range of {} ends before it begins", index.name.text)));
                }
                if length > LARGEST {
                    return Err(Missing::Unknown);
                }
                let mut total = self::Number::Exact(if is_sum { Rational::ZERO } else { Rational::ONE });
                for k in from..=to {
                    let mut inner = self.clone();
                    inner.indices.insert(index.name.text.clone(), Rational::from(k));
                    let value = inner.number(body)?;
                    self.seen.borrow_mut().extend(inner.seen.into_inner());
                    total = of_some_size(if is_sum { add(&total, &value) } else { multiply(&total, &value) })?;
                }
                total
            }
            // A derivative has no value where what is differentiated has none.
            Derivative(body, _) => return self.value(body).and(Err(Missing::Unknown)),
            Matrix(rows) => {
                let rows: Result<Vec<Vec<self::Number>>> =
                    rows.iter().map(|r| r.iter().map(|x| self.number(x)).collect()).collect();
                return Ok(Value::Matrix(rows?));
            }
        }))
    }

    fn whole(&self, e: &Expr) -> Result<i64> {
        match self.number(e)? {
            Number::Exact(q) => i64::try_from(&q).map_err(|_| match (&q).is_integer() {
                true => Missing::Unknown,
                false => Missing::Undefined(format!("{} is no whole number", crate::claim::print::expr(e))),
            }),
            Number::Between(..) => Err(Missing::Unknown),
        }
    }

    pub(super) fn power(&self, a: &Number, b: &Number, kind: Exponent, e: &Expr) -> Result<Number> {
        let text = || crate::claim::print::expr(e);
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
            "ln" => logarithm(&self.number(argument)?, || crate::claim::print::expr(e))?,
            "cosh" | "sinh" | "tanh" | "sech" => hyperbolic(text, &self.number(argument)?)?,
            _ => {
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
                if let Some(recurrence) = self.recurrences.get(text) {
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
                }
            }
        }))
    }

    /// The point as definitions see it: the claim's variables alone.
    fn without_indices(&self) -> Assignment {
        Assignment { indices: HashMap::default(), ..self.clone() }
    }

    /// u(k), each member evaluated once: the step may mention the member before it, which is bound
    /// as a value of its own.
    fn member(&self, sequence: &Sequence, index: i64) -> Result<Number> {
        if !sequence.steps_once() {
            return Err(Missing::Unknown);
        }
        let outer = self.without_indices();
        let mut value = outer.number(&sequence.initial)?;
        self.seen.borrow_mut().extend(outer.seen.take());
        for k in 0..index {
            let Number::Exact(known) = &value else { return Err(Missing::Unknown) };
            let mut inner = outer.clone();
            inner.indices.insert(sequence.index.clone(), Rational::from(k));
            inner.sequences.remove(&sequence.name);
            inner.families.insert(sequence.name.clone(), vec![known.clone()]);
            value = inner.number(&sequence.step)?;
            let seen = inner.seen.into_inner();
            self.seen.borrow_mut().extend(seen.into_iter().filter(|s| s.0.0 != sequence.name));
        }
        Ok(value)
    }

    /// Whether a side of some comparison certainly has no value.
    pub fn undefined(&self, prop: &Prop) -> bool {
        match &prop.kind {
            PropKind::Compare(sides, _) => sides.iter().any(|e| matches!(self.value(e), Err(Missing::Undefined(_)))),
            PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => {
                list.iter().any(|p| self.undefined(p))
            }
            PropKind::Not(p) => self.undefined(p),
            PropKind::Implies(p, q) => self.undefined(p) || self.undefined(q),
            _ => false,
        }
    }

    /// The truth of a proposition, if certain. Quantifiers and extrema are not decided here.
    pub fn truth(&self, prop: &Prop) -> Result<bool> {
        match &prop.kind {
            PropKind::Compare(sides, relations) => {
                let values: Vec<Value> = sides.iter().map(|e| self.value(e)).collect::<Result<_>>()?;
                let mut unknown = false;
                for (place, (pair, relation)) in values.windows(2).zip(relations).enumerate() {
                    match (&pair[0], &pair[1]) {
                        (Value::Scalar(_), Value::Scalar(_)) if self.identical(&sides[place], &sides[place + 1]) => {
                            if !matches!(relation, Relation::Equal | Relation::LessEqual | Relation::GreaterEqual) {
                                return Ok(false);
                            }
                        }
                        (Value::Scalar(a), Value::Scalar(b)) => match holds(a, *relation, b) {
                            Some(false) => return Ok(false),
                            Some(true) => {}
                            None => unknown = true,
                        },
                        (Value::Matrix(a), Value::Matrix(b)) => {
                            let sizes = |m: &Vec<Vec<Number>>| m.iter().map(Vec::len).collect::<Vec<_>>();
                            if sizes(a) != sizes(b) || !matches!(relation, Relation::Equal | Relation::NotEqual) {
                                return Err(Missing::Unknown);
                            }
                            let entries = a.iter().flatten().zip(b.iter().flatten());
                            let same: Vec<Option<bool>> = entries.map(|(x, y)| holds(x, Relation::Equal, y)).collect();
                            // Equal where all entries are, different where one is.
                            let equal = match () {
                                () if same.contains(&Some(false)) => Some(false),
                                () if same.contains(&None) => None,
                                () => Some(true),
                            };
                            match equal.map(|equal| equal == (*relation == Relation::Equal)) {
                                Some(false) => return Ok(false),
                                Some(true) => {}
                                None => unknown = true,
                            }
                        }
                        _ => return Err(Missing::Unknown),
                    }
                }
                if unknown { Err(Missing::Unknown) } else { Ok(true) }
            }
            PropKind::And(list) => {
                let mut unknown = None;
                for part in list {
                    match self.truth(part) {
                        Ok(false) => return Ok(false),
                        Ok(true) => {}
                        Err(missing) => unknown = Some(missing),
                    }
                }
                unknown.map_or(Ok(true), Err)
            }
            PropKind::Or(list) => {
                let (mut unknown, mut holds) = (None, false);
                for part in list {
                    match self.truth(part) {
                        Ok(truth) => holds |= truth,
                        // Whether a part without a value makes the whole undefined is a convention; no verdict depends on it.
                        Err(missing) => unknown = Some(missing),
                    }
                }
                match unknown {
                    Some(Missing::Undefined(_)) if holds => Err(Missing::Unknown),
                    Some(missing) if !holds => Err(missing),
                    _ => Ok(holds),
                }
            }
            PropKind::Not(inner) => Ok(!self.truth(inner)?),
            PropKind::Implies(p, q) => {
                if self.truth(p)? {
                    self.truth(q)
                } else {
                    Ok(true)
                }
            }
            PropKind::Equivalent(list) => {
                let first = list.first().map_or(Ok(true), |p| self.truth(p))?;
                for part in &list[1..] {
                    if self.truth(part)? != first {
                        return Ok(false);
                    }
                }
                Ok(true)
            }
            PropKind::ForAll(bindings, body) => self.for_all_indices(bindings, body),
            _ => Err(Missing::Unknown),
        }
    }

    fn identical(&self, a: &Expr, b: &Expr) -> bool {
        !self.identities.is_empty()
            && self.identities.contains(&(crate::claim::print::expr(a), crate::claim::print::expr(b)))
    }

    /// `for all k natural: P` where every family is constant and k stands in indices only: then P does
    /// not depend on k, and one value decides.
    fn for_all_indices(&self, bindings: &[Binding], body: &Prop) -> Result<bool> {
        let [Binding { names, natural: true, constraints, indices: None, .. }] = bindings else {
            return Err(Missing::Unknown);
        };
        let constant = self.families.values().all(|list| list.iter().all(|q| *q == list[0]));
        let [(name, None)] = names.as_slice() else { return Err(Missing::Unknown) };
        // A member out of its range has no value.
        if !constraints.is_empty() || !self.ranges.is_empty() {
            return Err(Missing::Unknown);
        }
        if !self.ratios.is_empty() {
            return self.for_all_powers(body, &name.text);
        }
        if !constant || !self.only_index(body, &name.text) {
            return Err(Missing::Unknown);
        }
        let mut inner = self.clone();
        inner.indices.insert(name.text.clone(), Rational::ZERO);
        inner.truth(body)
    }

    /// `for all k natural: A = B` where families are geometric and both sides are products of powers
    /// of members with indices k + c: then A = a·ρ^k and B = b·σ^k, equal for all k if for 0 and 1.
    fn for_all_powers(&self, body: &Prop, name: &str) -> Result<bool> {
        fn monomial(point: &Assignment, e: &Expr, index: &str) -> bool {
            match &e.kind {
                ExprKind::Name(n) => n != index,
                ExprKind::Number(_) => true,
                ExprKind::Apply(f, list) => point.ratios.contains_key(&f.text) && list.iter().all(shifted),
                ExprKind::Product(list) => list.iter().all(|(_, a)| monomial(point, a, index)),
                ExprKind::Power(a, b) => monomial(point, a, index) && matches!(b.kind, ExprKind::Number(_)),
                _ => false,
            }
        }
        let PropKind::Compare(sides, relations) = &body.kind else { return Err(Missing::Unknown) };
        let fine = relations.iter().all(|r| *r == Relation::Equal) && sides.iter().all(|e| monomial(self, e, name));
        for k in [0, 1] {
            let mut inner = self.clone();
            inner.indices.insert(name.to_string(), Rational::from(k));
            if !inner.truth(body)? {
                return Ok(false);
            }
        }
        if fine { Ok(true) } else { Err(Missing::Unknown) }
    }

    fn only_index(&self, prop: &Prop, name: &str) -> bool {
        fn inside(point: &Assignment, e: &Expr, name: &str) -> bool {
            match &e.kind {
                ExprKind::Name(n) => n != name,
                ExprKind::Apply(f, list) if point.families.contains_key(&f.text) => list.iter().all(shifted),
                _ => {
                    let mut fine = true;
                    super::expand::parts(e, &mut |part| fine &= inside(point, part, name));
                    fine
                }
            }
        }
        match &prop.kind {
            PropKind::Compare(sides, _) => sides.iter().all(|e| inside(self, e, name)),
            PropKind::And(list) | PropKind::Or(list) => list.iter().all(|p| self.only_index(p, name)),
            _ => false,
        }
    }

    /// The comparisons that fail in a false proposition, with both sides.
    pub fn broken(&self, prop: &Prop, into: &mut Vec<super::outcome::Broken>) {
        match &prop.kind {
            PropKind::Compare(sides, relations) => {
                for (pair, relation) in sides.windows(2).zip(relations) {
                    let single = Prop { kind: PropKind::Compare(pair.to_vec(), vec![*relation]), span: prop.span };
                    if let (Ok(a), Ok(b)) = (self.number(&pair[0]), self.number(&pair[1])) {
                        into.push(super::outcome::Broken {
                            statement: crate::claim::print::prop(&single),
                            left: a.text(),
                            right: b.text(),
                        });
                    }
                }
            }
            PropKind::And(list) => {
                for part in list.iter().filter(|p| self.truth(p) == Ok(false)) {
                    self.broken(part, into);
                }
            }
            PropKind::Or(list) | PropKind::Equivalent(list) => list.iter().for_each(|p| self.broken(p, into)),
            PropKind::Not(p) => self.broken(p, into),
            PropKind::Implies(p, q) => {
                self.broken(p, into);
                self.broken(q, into);
            }
            _ => {}
        }
    }
}

/// Whether two matrices have as many rows and columns.
fn same_size(a: &[Vec<Number>], b: &[Vec<Number>]) -> bool {
    a.iter().map(Vec::len).eq(b.iter().map(Vec::len))
}

/// The determinant, by the first row, of a square matrix of at most five rows.
fn determinant(rows: &[Vec<Number>]) -> Result<Number> {
    let Some((first, others)) = rows.split_first() else { return Ok(Number::Exact(Rational::ONE)) };
    if rows.len() > 5 || rows.iter().any(|row| row.len() != rows.len()) {
        return Err(Missing::Unknown);
    }
    let mut sum = Number::Exact(Rational::ZERO);
    for (place, a) in first.iter().enumerate() {
        let without = |row: &Vec<Number>| {
            row.iter().enumerate().filter(|(k, _)| *k != place).map(|(_, x)| x.clone()).collect::<Vec<_>>()
        };
        let minor = determinant(&others.iter().map(without).collect::<Vec<_>>())?;
        let term = multiply(a, &minor);
        sum = add(&sum, &if place % 2 == 0 { term } else { negate(&term) });
    }
    Ok(sum)
}

/// Whether an index is a natural number for all natural values of what stands in it, if it is for one.
fn shifted(e: &Expr) -> bool {
    match &e.kind {
        ExprKind::Name(_) | ExprKind::Number(_) => true,
        ExprKind::Sum(list) => list.iter().all(|(sign, a)| *sign == Sign::Plus && shifted(a)),
        _ => false,
    }
}
