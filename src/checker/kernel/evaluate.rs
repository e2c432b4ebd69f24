//! Rule `evaluate`: propositions at a point, by arithmetic alone.
//!
//! Contract: [`Checker::evaluate`] returns only if the proposition is true and has a value wherever the cited equations
//! hold, which give names and members numbers. Values are exact or enclosed ([`super::enclosure`]); what enclosures do not decide
//! is not shown.

use super::enclosure::Enclosure;
use super::fraction::Work;
use super::names::free_names;
use super::order::Signs;
use super::statement::Statement;
use super::term::numeral;
use super::value::{Value, all, determinant, real_power, transposed};
use super::{Checker, Reason, Refusal, rejected};
use crate::claim::definedness::{Exponent, exponent, from_one, is_whole};
use crate::claim::syntax::*;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use std::collections::{BTreeMap, BTreeSet};

/// What names stand for.
struct Point<'a> {
    statement: &'a Statement,
    work: &'a Work,
    /// Names that stand for natural numbers.
    natural: BTreeSet<String>,
    values: BTreeMap<String, BigRational>,
    /// Members of families that are given, and of sequences as they were computed.
    members: BTreeMap<(String, BigInt), Enclosure>,
    /// Indices of the sums, products and quantifiers around, innermost last.
    indices: Vec<(String, BigInt)>,
}

type Fallible<T> = Result<T, Refusal>;

impl Checker {
    /// Rule `evaluate`: a proposition without limits, extrema and derivatives, quantified over ranges at most.
    ///
    /// Sound: wherever the equations under `using` hold, each name has the number that its equation gives, and every
    /// expression lies within its enclosure. Where a part may have no value, the step is rejected; what stands behind
    /// `=>` needs none where what stands before it is false.
    pub(super) fn evaluate(&mut self, goal: &Prop, using: &[String]) -> Fallible<()> {
        let mut names = BTreeSet::new();
        free_names(goal, &mut names);
        if let Some(other) = names.into_iter().find(|n| !is_built_in(n) && n != PI && !self.is_declared(n)) {
            return rejected(Reason::Undeclared(other));
        }
        let facts = using.iter().map(|label| self.fact(label)).collect::<Fallible<Vec<_>>>()?;
        let mut point = Point {
            statement: &self.statement,
            work: &self.work,
            natural: self.natural_names(),
            values: BTreeMap::new(),
            members: BTreeMap::new(),
            indices: Vec::new(),
        };
        for fact in &facts {
            point.take(fact)?;
        }
        match point.truth(goal)? {
            Some(true) => Ok(()),
            Some(false) => rejected(Reason::False),
            None => rejected(Reason::NotDecided),
        }
    }
}

impl Point<'_> {
    /// An equation `PLACE = NUMBER`, whose right side uses what is known so far.
    fn take(&mut self, fact: &Prop) -> Fallible<()> {
        let Some((place, Relation::Equal, value)) = fact.single() else {
            return rejected(Reason::NotAnEquation);
        };
        let value = self.exact(value)?;
        match &place.kind {
            ExprKind::Name(name) => {
                self.values.insert(name.clone(), value);
            }
            ExprKind::Apply(family, arguments) if !is_built_in(&family.text) => {
                let [index] = arguments.as_slice() else { return rejected(Reason::Arguments(family.text.clone())) };
                let index = self.whole(index)?;
                self.members.insert((family.text.clone(), index), Enclosure::exact(value));
            }
            _ => return rejected(Reason::NotAnAtom),
        }
        Ok(())
    }

    fn exact(&mut self, e: &Expr) -> Fallible<BigRational> {
        match self.number(e)?.number() {
            Some(q) => Ok(q.clone()),
            None => rejected(Reason::NotDecided),
        }
    }

    /// The value of an expression that is whole by its form.
    fn whole(&mut self, e: &Expr) -> Fallible<BigInt> {
        let q = self.exact(e)?;
        if self.is_whole(e) && q.is_integer() { Ok(q.to_integer()) } else { rejected(Reason::NotWhole) }
    }

    fn is_natural(&self, name: &str) -> bool {
        self.indices.iter().any(|i| i.0 == name) || self.natural.contains(name)
    }

    fn is_whole(&self, e: &Expr) -> bool {
        is_whole(e, &|name| self.is_natural(name))
    }

    fn number(&mut self, e: &Expr) -> Fallible<Enclosure> {
        match self.value(e)? {
            Value::Number(number) => Ok(number),
            Value::Matrix(_) => rejected(Reason::MatrixForNumber),
        }
    }

    /// The number of a part, whose signs have to be among these.
    fn number_that_is(&mut self, part: &Expr, signs: Signs) -> Fallible<Enclosure> {
        let number = self.number(part)?;
        if number.signs().within(signs) { Ok(number) } else { rejected(Reason::NoValue { part: part.clone(), signs }) }
    }

    fn value(&mut self, e: &Expr) -> Fallible<Value> {
        self.work.count(1)?;
        let work = self.work;
        Ok(Value::Number(match &e.kind {
            ExprKind::Number(text) => Enclosure::exact(numeral(text)?),
            ExprKind::Name(name) => match self.indices.iter().rev().find(|i| i.0 == *name) {
                Some((_, index)) => Enclosure::exact(BigRational::from_integer(index.clone())),
                None => match self.values.get(name) {
                    Some(value) => Enclosure::exact(value.clone()),
                    None if name == PI && !self.statement.declares(PI) => Enclosure::pi(work)?,
                    None => return rejected(Reason::NoNumber(e.clone())),
                },
            },
            ExprKind::Negate(a) => return self.value(a)?.each(&|x| Ok(x.negated())),
            ExprKind::Sum(list) => {
                let mut sum: Option<Value> = None;
                for (sign, part) in list {
                    let part =
                        self.value(part)?.each(&|x| Ok(if *sign == Sign::Plus { x.clone() } else { x.negated() }))?;
                    sum = Some(match sum {
                        None => part,
                        Some(sum) => sum.plus(&part, work)?,
                    });
                }
                return sum.ok_or(Refusal::Rejected(Reason::NotDecided));
            }
            ExprKind::Product(list) => {
                let mut product = Value::Number(Enclosure::exact(BigRational::one()));
                for (operator, part) in list {
                    product = match operator {
                        Factor::Times => product.times(&self.value(part)?, work)?,
                        Factor::Over => {
                            let inverse = self.number_that_is(part, Signs::NOT_ZERO)?.inverse(work)?;
                            product.times(&Value::Number(inverse), work)?
                        }
                    };
                }
                return Ok(product);
            }
            ExprKind::Power(base, e) => match exponent(e, &|name| self.is_natural(name))? {
                Exponent::Whole => self.whole_power(base, e)?,
                Exponent::Root => {
                    let power = self.exact(e)?;
                    let base = self.number_that_is(base, Signs::NOT_NEGATIVE)?;
                    real_power(&base, &Enclosure::exact(power), work)?
                }
                Exponent::Real => {
                    let power = self.number(e)?;
                    let base = self.number_that_is(base, Signs::POSITIVE)?;
                    real_power(&base, &power, work)?
                }
            },
            ExprKind::Apply(f, arguments) => {
                let [argument] = arguments.as_slice() else { return rejected(Reason::Arguments(f.text.clone())) };
                return self.apply(&f.text, argument);
            }
            ExprKind::SumOver(index, body) | ExprKind::ProductOver(index, body) => {
                let (from, to) = (self.whole(&index.from)?, self.whole(&index.to)?);
                if from.is_negative() || &to + BigInt::one() < from {
                    return rejected(Reason::Range(e.clone()));
                }
                let is_sum = matches!(&e.kind, ExprKind::SumOver(..));
                let mut total = Enclosure::exact(BigRational::from_integer(BigInt::from(i32::from(!is_sum))));
                let mut k = from;
                while k <= to {
                    let part = self.at_index(&index.name.text, &k, |point| point.number(body))?;
                    total = if is_sum { total.plus(&part, work)? } else { total.times(&part, work)? };
                    k += 1;
                }
                total
            }
            ExprKind::Matrix(rows) => {
                let rows: Vec<Vec<Enclosure>> =
                    rows.iter().map(|row| row.iter().map(|e| self.number(e)).collect()).collect::<Fallible<_>>()?;
                return Ok(Value::Matrix(rows));
            }
            ExprKind::IntegralOver(..) | ExprKind::Derivative(..) => return rejected(Reason::NotEvaluated),
        }))
    }

    fn at_index<T>(&mut self, name: &str, k: &BigInt, run: impl FnOnce(&mut Self) -> Fallible<T>) -> Fallible<T> {
        self.work.count(1)?;
        self.indices.push((name.to_string(), k.clone()));
        let result = run(self);
        self.indices.pop();
        result
    }

    fn whole_power(&mut self, base: &Expr, e: &Expr) -> Fallible<Enclosure> {
        let k = self.whole(e)?;
        if k.is_negative() {
            return self.number_that_is(base, Signs::NOT_ZERO)?.power(&k.abs(), self.work)?.inverse(self.work);
        }
        self.number(base)?.power(&k, self.work)
    }

    fn apply(&mut self, f: &str, argument: &Expr) -> Fallible<Value> {
        let work = self.work;
        Ok(Value::Number(match f {
            "sqrt" => self.number_that_is(argument, Signs::NOT_NEGATIVE)?.root(2, work)?,
            "cbrt" => self.number_that_is(argument, Signs::NOT_NEGATIVE)?.root(3, work)?,
            "exp" => self.number(argument)?.exp(work)?,
            "ln" => self.number_that_is(argument, Signs::POSITIVE)?.ln(work)?,
            "cos" => self.number(argument)?.cosine_and_sine(work)?.0,
            "sin" => self.number(argument)?.cosine_and_sine(work)?.1,
            "arctan" => self.number(argument)?.arctan(work)?,
            "arcsin" | "arccos" => {
                for distance in from_one(argument) {
                    self.number_that_is(&distance, Signs::NOT_NEGATIVE)?;
                }
                let arc = self.number(argument)?.arcsin(work)?;
                if f == "arcsin" { arc } else { Enclosure::quarter_turn(work)?.minus(&arc, work)? }
            }
            "cosh" | "sinh" | "sech" | "tanh" => {
                let x = self.number(argument)?;
                let (up, down) = (x.exp(work)?, x.negated().exp(work)?);
                let (sum, difference) = (up.plus(&down, work)?, up.minus(&down, work)?);
                let half = Enclosure::exact(BigRational::new(BigInt::one(), BigInt::from(2)));
                let inverse = |x: Enclosure| x.inverse(work);
                match f {
                    "cosh" => sum.times(&half, work)?,
                    "sinh" => difference.times(&half, work)?,
                    "sech" => inverse(sum.times(&half, work)?)?,
                    _ => difference.times(&inverse(sum)?, work)?,
                }
            }
            "det" => match self.value(argument)? {
                Value::Matrix(rows) => determinant(&rows, work)?,
                Value::Number(_) => return rejected(Reason::NumberForMatrix),
            },
            "transpose" => match self.value(argument)? {
                Value::Matrix(rows) => return Ok(Value::Matrix(transposed(&rows))),
                Value::Number(_) => return rejected(Reason::NumberForMatrix),
            },
            _ => {
                let k = self.whole(argument)?;
                if k.is_negative() {
                    return rejected(Reason::NoValue { part: argument.clone(), signs: Signs::NOT_NEGATIVE });
                }
                self.member(f, &k)?
            }
        }))
    }

    /// A member: given, or of a sequence, whose definition sees no index around.
    fn member(&mut self, f: &str, k: &BigInt) -> Fallible<Enclosure> {
        if let Some(value) = self.members.get(&(f.to_string(), k.clone())) {
            return Ok(value.clone());
        }
        let Some(u) = self.statement.sequences.iter().find(|u| u.name == f) else {
            return rejected(Reason::NoNumber(crate::kernel::statement::name(f)));
        };
        let outside = std::mem::take(&mut self.indices);
        let result = self.members_up_to(u, k);
        self.indices = outside;
        result
    }

    fn members_up_to(&mut self, u: &super::statement::Sequence, k: &BigInt) -> Fallible<Enclosure> {
        let mut value = self.number(&u.initial)?;
        self.members.insert((u.name.clone(), BigInt::zero()), value.clone());
        let mut before = BigInt::zero();
        while before < *k {
            value = self.at_index(&u.index, &before, |point| point.number(&u.step))?;
            before += 1;
            self.members.insert((u.name.clone(), before.clone()), value.clone());
        }
        Ok(value)
    }

    /// Whether a proposition is true, where enclosures decide it. All parts have values, but those behind `=>` only where
    /// what stands before it may be true.
    fn truth(&mut self, p: &Prop) -> Fallible<Option<bool>> {
        match &p.kind {
            PropKind::Compare(sides, relations) => {
                let values = sides.iter().map(|e| self.value(e)).collect::<Fallible<Vec<_>>>()?;
                let pairs = values.windows(2).zip(relations);
                let truths = pairs.map(|(pair, relation)| match pair {
                    [a, b] => a.compared(*relation, b, self.work),
                    _ => rejected(Reason::NotSingle),
                });
                Ok(all(&truths.collect::<Fallible<Vec<_>>>()?))
            }
            PropKind::And(list) => Ok(all(&self.truths(list)?)),
            PropKind::Or(list) => {
                let denied: Vec<Option<bool>> = self.truths(list)?.into_iter().map(|t| t.map(|t| !t)).collect();
                Ok(all(&denied).map(|t| !t))
            }
            PropKind::Not(inner) => Ok(self.truth(inner)?.map(|t| !t)),
            PropKind::Equivalent(list) => {
                let truths = self.truths(list)?;
                let has = |t: bool| truths.contains(&Some(t));
                Ok(match (has(true), has(false)) {
                    (true, true) => Some(false),
                    _ if truths.contains(&None) => None,
                    _ => Some(true),
                })
            }
            PropKind::Implies(before, behind) => match self.truth(before)? {
                Some(false) => Ok(Some(true)),
                open => Ok(match (open, self.truth(behind)?) {
                    (_, Some(true)) => Some(true),
                    (Some(true), other) => other,
                    _ => None,
                }),
            },
            PropKind::ForAll(bindings, body) => {
                let names = ranges(bindings)?;
                let mut truths = Vec::new();
                self.each(&names, body, &mut truths)?;
                Ok(all(&truths))
            }
            PropKind::Exists(bindings, body) => {
                let names = ranges(bindings)?;
                let mut truths = Vec::new();
                self.each(&names, body, &mut truths)?;
                let denied: Vec<Option<bool>> = truths.into_iter().map(|t| t.map(|t| !t)).collect();
                Ok(all(&denied).map(|t| !t))
            }
            PropKind::Extremum(_) | PropKind::Limit(_) | PropKind::WrittenLimit(_) => rejected(Reason::NotEvaluated),
        }
    }

    fn truths(&mut self, list: &[Prop]) -> Fallible<Vec<Option<bool>>> {
        list.iter().map(|p| self.truth(p)).collect()
    }

    /// The truth of a proposition for all values in ranges.
    fn each(&mut self, names: &[(&str, &Expr, &Expr)], body: &Prop, truths: &mut Vec<Option<bool>>) -> Fallible<()> {
        let Some(((name, from, to), rest)) = names.split_first() else {
            truths.push(self.truth(body)?);
            return Ok(());
        };
        let (from, to) = (self.exact(from)?.ceil().to_integer(), self.exact(to)?);
        // They are natural.
        let mut k = from.max(BigInt::zero());
        while BigRational::from_integer(k.clone()) <= to {
            self.at_index(name, &k, |point| point.each(rest, body, truths))?;
            k += 1;
        }
        Ok(())
    }
}

/// The names of bindings `k, … in a..b`, with their ranges.
fn ranges(bindings: &[Binding]) -> Fallible<Vec<(&str, &Expr, &Expr)>> {
    let mut out = Vec::new();
    for binding in bindings {
        let [Constraint::Range(from, to)] = binding.constraints.as_slice() else {
            return rejected(Reason::NotEvaluated);
        };
        for (name, index) in &binding.names {
            if index.is_some() || !binding.natural {
                return rejected(Reason::NotEvaluated);
            }
            out.push((name.text.as_str(), from, to));
        }
    }
    Ok(out)
}
