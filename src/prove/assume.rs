//! Facts taken into a context: what they say of signs, and the variables that equations determine.
//!
//! An equation that is linear in a real variable with a coefficient that cannot vanish determines it;
//! the variable is then replaced everywhere by its value. Declared later means determined first, so
//! that from the laws of a collision the velocities after it are found, not the masses.

use super::context::*;
use super::expand::{Sequence, Substitution};
use super::translate::Value;
use crate::algebra::factor;
use crate::algebra::form::{Atom, AtomId, Exponent, Form};
use crate::claim::syntax::*;
use crate::prove::comparison::{Plain, Reduced, negated, truth_of};
use std::rc::Rc;

type Result<T> = std::result::Result<T, Failure>;

/// The most variables that equations may determine in one context.
const ELIMINATIONS: usize = 24;

impl Engine {
    /// Declares variables with their domains.
    pub fn declare(&mut self, cx: &mut Context, bindings: &[Binding]) -> Result<()> {
        for binding in bindings {
            for (name, index) in &binding.names {
                let text = &name.text;
                if cx.variables.iter().any(|v| v.0 == *text)
                    || cx.families.contains_key(text)
                    || cx.sequences.contains_key(text)
                {
                    return Err(Failure::NotShown(format!("{text} has a meaning here already")));
                }
                match index {
                    Some(index) => {
                        let family = Family {
                            binding: binding.clone(),
                            index: index.text.clone(),
                            source: source(cx.facts.len()),
                        };
                        cx.families.insert(name.text.clone(), Rc::new(family));
                    }
                    None => cx.variables.push((name.text.clone(), binding.natural)),
                }
            }
        }
        for binding in bindings {
            for prop in domain(binding) {
                cx.facts.push(Fact { prop: Rc::new(prop) });
            }
        }
        self.rebuild(cx)
    }

    /// Shows that every member of a sequence has a value: u(0), and u(k + 1) for any natural k and any number u(k).
    pub fn members_valued(&mut self, cx: &Context, sequence: &Sequence) -> Result<()> {
        if !sequence.steps_once() {
            return Err(Failure::NotShown(format!("the sequence {} is defined by the member before", sequence.name)));
        }
        self.valued(&mut cx.clone(), &sequence.initial)?;
        let (index, before) = ("'index", "'before");
        let mut put = Substitution::default();
        put.replace(&sequence.index, name_expr(index));
        put.define(&sequence.name, vec!["'place".to_string()], name_expr(before));
        let step = put.expr(&sequence.step)?;
        let mut inner = cx.clone();
        inner.variables.extend([(index.to_string(), true), (before.to_string(), false)]);
        match self.valued(&mut inner, &step) {
            Err(Failure::Undefined(what)) => {
                let what = what
                    .replace(index, &sequence.index)
                    .replace(before, &format!("{}({})", sequence.name, sequence.index));
                Err(Failure::Undefined(format!("in the sequence {} {what}", sequence.name)))
            }
            other => other,
        }
    }

    fn valued(&mut self, cx: &mut Context, value: &Expr) -> Result<()> {
        let mut conditions = Vec::new();
        self.scalar(cx, value, &mut conditions)?;
        self.show_conditions(cx, conditions)
    }

    /// Takes a proposition as known.
    pub fn assume(&mut self, cx: &mut Context, prop: &Prop) -> Result<()> {
        cx.facts.push(Fact { prop: Rc::new(prop.clone()) });
        if let PropKind::And(list) = &prop.kind {
            // The parts are facts of their own.
            return list.iter().try_for_each(|part| self.assume(cx, part));
        }
        let last = cx.facts.len() - 1;
        if self.take(cx, last)? {
            self.rebuild(cx)?;
        }
        self.resolve(cx)
    }

    /// Derives everything anew from the facts.
    pub fn rebuild(&mut self, cx: &mut Context) -> Result<()> {
        for _ in 0..ELIMINATIONS {
            cx.signs.clear();
            cx.memo.clear();
            cx.searched.clear();
            cx.members.clear();
            cx.constraints.clear();
            let mut again = false;
            let mut late = Vec::new();
            for fact in 0..cx.facts.len() {
                match self.attempt(|engine| engine.take(cx, fact)) {
                    Ok(true) => {
                        again = true;
                        break;
                    }
                    Ok(false) => {}
                    Err(Failure::Fault(diagnose)) => return Err(Failure::Fault(diagnose)),
                    Err(_) => late.push(fact),
                }
            }
            if !again {
                for fact in late {
                    if let Ok(true) = self.attempt(|engine| engine.take(cx, fact)) {
                        again = true;
                        break;
                    }
                }
            }
            if !again {
                return self.resolve(cx);
            }
        }
        Err(Failure::Limit("eliminations"))
    }

    /// Takes one fact; true if it determined a variable.
    fn take(&mut self, cx: &mut Context, fact: usize) -> Result<bool> {
        let prop = cx.facts[fact].prop.clone();
        self.take_prop(cx, &prop, source(fact))
    }

    fn take_prop(&mut self, cx: &mut Context, prop: &Prop, sources: Sources) -> Result<bool> {
        match &prop.kind {
            PropKind::Not(inner) => match negation(inner) {
                Some(prop) if !matches!(prop.kind, PropKind::Not(_)) => self.take_prop(cx, &prop, sources),
                _ => Ok(false),
            },
            PropKind::Compare(sides, relations) => {
                let mut changed = false;
                let mut conditions = Vec::new();
                let before = std::mem::replace(&mut self.used, 0);
                let values: Vec<Value> =
                    sides.iter().map(|e| self.translate(cx, e, &mut conditions)).collect::<Result<_>>()?;
                let sources = sources | self.used;
                self.used = before;
                // A fact that divides is understood to be defined.
                for condition in conditions {
                    self.narrow_form(cx, &condition.form, condition.relation, sources)?;
                }
                for (pair, relation) in values.windows(2).zip(relations) {
                    match (&pair[0], &pair[1]) {
                        (Value::Scalar(a), Value::Scalar(b)) => {
                            changed |= self.take_comparison(cx, a, *relation, b, sources)?;
                        }
                        (Value::Matrix(a), Value::Matrix(b)) if *relation == Relation::Equal => {
                            for (x, y) in a.iter().flatten().zip(b.iter().flatten()) {
                                changed |= self.take_comparison(cx, x, Relation::Equal, y, sources)?;
                            }
                        }
                        _ => {}
                    }
                }
                Ok(changed)
            }
            _ => Ok(false),
        }
    }

    fn take_comparison(
        &mut self,
        cx: &mut Context,
        a: &Form,
        relation: Relation,
        b: &Form,
        sources: Sources,
    ) -> Result<bool> {
        let difference = self.difference(cx, a, b)?;
        if relation == Relation::Equal
            && let Reduced::Open(literal) = self.reduced(cx, &difference, relation)?
        {
            // One factor left: try to solve for a variable; else it may be known not to vanish.
            if let [(atom, _)] = literal.atoms.as_slice() {
                if self.solve(cx, *atom, sources)? {
                    return Ok(true);
                }
                if self.split_equation(cx, *atom, sources)? {
                    return Ok(true);
                }
                let small = self.ring.sum(*atom).is_some_and(|p| p.terms.len() <= 12);
                if small && !cx.signs.contains_key(atom) {
                    let before = std::mem::replace(&mut self.used, sources);
                    let signs = self.searched_signs(cx, *atom)?;
                    let all = std::mem::replace(&mut self.used, before);
                    if signs.within(Signs::NOT_ZERO) {
                        cx.contradiction = Some(all);
                        return Ok(false);
                    }
                }
            }
        }
        // Without common roots as well: certificates work with the exponents as they stand.
        let plain = self.ring.sub(a, b)?;
        if plain != difference {
            self.narrow_form(cx, &plain, relation, sources)?;
        }
        self.narrow_form(cx, &difference, relation, sources)?;
        Ok(false)
    }

    /// Solves `atom = 0` for a real variable, if it is linear in one with a coefficient that cannot
    /// vanish. The variable may occur nowhere else in the equation.
    fn solve(&mut self, cx: &mut Context, atom: AtomId, sources: Sources) -> Result<bool> {
        let poly = crate::prove::comparison::sum_or_atom(self, atom);
        let candidates: Vec<String> =
            cx.variables.iter().rev().filter(|v| !v.1 && !v.0.starts_with('#')).map(|v| v.0.clone()).collect();
        for name in candidates {
            if cx.environment.contains_key(&name) || cx.indices.contains_key(&name) {
                continue;
            }
            let variable = self.ring.intern(Atom::Variable(name.clone()));
            let (mut with, mut without) = (Vec::new(), Vec::new());
            let mut fine = true;
            for (monomial, c) in &poly.terms {
                let mut rest = Form { coefficient: c.clone(), powers: monomial.clone() };
                match monomial.binary_search_by_key(&variable, |p| p.0) {
                    Ok(place) => {
                        fine &= monomial[place].1.as_integer() == Some(1);
                        rest.powers.remove(place);
                        with.push(rest.clone());
                    }
                    Err(_) => without.push(rest.clone()),
                }
                fine &= !self.ring.mentions(&rest, &|a| a == variable);
            }
            if !fine || with.is_empty() {
                continue;
            }
            let coefficient = self.ring.add(&with)?;
            let before = std::mem::replace(&mut self.used, 0);
            let signs = self.searched_form_signs(cx, &coefficient)?;
            let sources = sources | self.used;
            self.used = before;
            if !signs.within(Signs::NOT_ZERO) {
                continue;
            }
            let rest = self.ring.add(&without)?;
            let value = self.ring.div(&rest.negated(), &coefficient)?;
            self.eliminate(cx, &name, variable, value, sources)?;
            return Ok(true);
        }
        Ok(false)
    }

    /// Records the value of a variable and puts it into the values found before.
    fn eliminate(
        &mut self,
        cx: &mut Context,
        name: &str,
        variable: AtomId,
        value: Form,
        sources: Sources,
    ) -> Result<()> {
        let mut changed = Vec::new();
        for (other, (form, from)) in &cx.environment {
            if self.ring.mentions(form, &|a| a == variable) {
                changed.push((other.clone(), form.clone(), *from));
            }
        }
        for (other, form, from) in changed {
            let form = self.substituted(cx, &form, variable, &value)?;
            cx.environment.insert(other, (form, from | sources));
        }
        cx.environment.insert(name.to_string(), (value, sources));
        Ok(())
    }

    /// The form with a value put for a variable.
    pub fn substituted(&mut self, cx: &mut Context, form: &Form, variable: AtomId, value: &Form) -> Result<Form> {
        let mut out = Form::number(form.coefficient.clone());
        for (atom, exponent) in &form.powers {
            let base = if *atom == variable {
                value.clone()
            } else if !self.ring.atom_mentions(*atom, &|a| a == variable) {
                Form::atom(*atom)
            } else if let Some(poly) = self.ring.sum(*atom) {
                let mut sum = Vec::new();
                for (monomial, c) in &poly.terms {
                    let term = Form { coefficient: c.clone(), powers: monomial.clone() };
                    sum.push(self.substituted(cx, &term, variable, value)?);
                }
                self.ring.add(&sum)?
            } else {
                return Err(Failure::NotShown("a value put inside an index, sum or logarithm".to_string()));
            };
            if let Exponent::Symbolic(e) = exponent
                && self.ring.mentions(e, &|a| a == variable)
            {
                return Err(Failure::NotShown("a value put into an exponent".to_string()));
            }
            let power = self.raise(cx, &base, &exponent.form(), "a substituted power", &mut Vec::new())?;
            out = self.ring.mul(&out, &power)?;
        }
        Ok(out)
    }

    /// An equation whose sum factors: keeps the factors that may vanish. True if that determined a
    /// variable.
    fn split_equation(&mut self, cx: &mut Context, atom: AtomId, sources: Sources) -> Result<bool> {
        if self.ring.sum(atom).is_none_or(|p| p.terms.len() > 60) {
            return Ok(false);
        }
        let plain = Plain::of(self, cx, &[atom])?;
        let Some(goal) = plain.goals.first() else { return Ok(false) };
        if goal.degree() > super::sign::SEARCHED_DEGREE {
            return Ok(false);
        }
        let Ok(factors) = factor::factor(goal) else { return Ok(false) };
        if factors.factors.len() < 2 && factors.factors.iter().all(|f| f.1 == 1) {
            return Ok(false);
        }
        let mut product = Form::integer(1);
        for (poly, _) in &factors.factors {
            let form = plain.form_of(self, poly)?;
            product = self.ring.mul(&product, &form)?;
        }
        if let Reduced::Open(literal) = self.reduced(cx, &product, Relation::Equal)? {
            if let [(one, _)] = literal.atoms.as_slice()
                && *one != atom
                && self.solve(cx, *one, sources)?
            {
                return Ok(true);
            }
            self.narrow_form(cx, &product, Relation::Equal, sources)?;
        }
        Ok(false)
    }

    /// Comparisons of products of which all factors but one have a known sign say the sign of the
    /// last one; if all are known they may contradict the comparison.
    fn resolve(&mut self, cx: &mut Context) -> Result<()> {
        for _ in 0..8 {
            let mut found = None;
            for (literal, sources) in cx.constraints.clone() {
                let equality = literal.relation == Relation::Equal;
                let mut open = Vec::new();
                let mut rest = Signs::POSITIVE;
                let before = std::mem::replace(&mut self.used, sources);
                for (atom, even) in &literal.atoms {
                    let signs = self.atom_signs(cx, *atom)?;
                    let signs = if *even { signs.squared() } else { signs };
                    if signs.within(Signs::POSITIVE)
                        || signs.within(Signs::NEGATIVE)
                        || equality && signs.within(Signs::NOT_ZERO)
                    {
                        rest = rest.times(signs);
                    } else {
                        open.push((*atom, *even));
                    }
                }
                let sources = std::mem::replace(&mut self.used, before);
                let negative = !equality && rest.within(Signs::NEGATIVE);
                let relation = if negative { super::comparison::mirrored(literal.relation) } else { literal.relation };
                match open.as_slice() {
                    [] if truth_of(Signs::POSITIVE, relation) == Some(false) => cx.contradiction = Some(sources),
                    [(one, false)] => {
                        let known = self.atom_signs(cx, *one)?;
                        if !known.within(Signs::of(relation)) {
                            found = Some((*one, relation, sources));
                        }
                    }
                    _ => {}
                }
            }
            let Some((atom, relation, sources)) = found else { return Ok(()) };
            if relation == Relation::Equal && self.solve(cx, atom, sources)? {
                return self.rebuild(cx);
            }
            self.narrow_form(cx, &Form::atom(atom), relation, sources)?;
        }
        Ok(())
    }
}

/// The domain of a binding's plain variables as propositions.
pub fn domain(binding: &Binding) -> Vec<Prop> {
    let mut out = Vec::new();
    for (name, index) in &binding.names {
        if index.is_some() {
            continue;
        }
        let this = || Expr { kind: ExprKind::Name(name.text.clone()), span: name.span };
        let mut push = |relation: Relation, bound: &Expr| {
            out.push(Prop { kind: PropKind::Compare(vec![this(), bound.clone()], vec![relation]), span: binding.span });
        };
        for constraint in &binding.constraints {
            match constraint {
                Constraint::Relation(relation, e) => push(*relation, e),
                Constraint::Interval { from, from_closed, to, to_closed } => {
                    push(if *from_closed { Relation::GreaterEqual } else { Relation::Greater }, from);
                    push(if *to_closed { Relation::LessEqual } else { Relation::Less }, to);
                }
                Constraint::Range(from, to) => {
                    push(Relation::GreaterEqual, from);
                    push(Relation::LessEqual, to);
                }
            }
        }
    }
    out
}

/// The negation with `not` pushed inwards; `None` for extrema and limits.
pub fn negation(prop: &Prop) -> Option<Prop> {
    let span = prop.span;
    let kind = match &prop.kind {
        PropKind::Compare(sides, relations) => {
            let list: Vec<Prop> = sides
                .windows(2)
                .zip(relations)
                .map(|(pair, r)| Prop { kind: PropKind::Compare(pair.to_vec(), vec![negated(*r)]), span })
                .collect();
            if let [one] = list.as_slice() {
                return Some(one.clone());
            }
            PropKind::Or(list)
        }
        PropKind::And(list) => PropKind::Or(list.iter().map(negation).collect::<Option<_>>()?),
        PropKind::Or(list) => PropKind::And(list.iter().map(negation).collect::<Option<_>>()?),
        PropKind::Not(inner) => return Some((**inner).clone()),
        PropKind::Implies(p, q) => PropKind::And(vec![(**p).clone(), negation(q)?]),
        PropKind::Equivalent(list) => {
            let [p, q] = list.as_slice() else { return None };
            let both = |a: Prop, b: Prop| Prop { kind: PropKind::And(vec![a, b]), span };
            PropKind::Or(vec![both(p.clone(), negation(q)?), both(negation(p)?, q.clone())])
        }
        PropKind::Exists(bindings, body) => PropKind::ForAll(bindings.clone(), Box::new(negation(body)?)),
        PropKind::ForAll(bindings, body) => PropKind::Exists(bindings.clone(), Box::new(negation(body)?)),
        PropKind::Extremum(_) | PropKind::Limit(_) => return None,
    };
    Some(Prop { kind, span })
}
