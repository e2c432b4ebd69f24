//! The methods that an argument can name: induction, powers and products of inequalities, the mean
//! inequality, Hölder's inequality, instances, witnesses.
//!
//! The one analytic lemma is the weighted mean inequality for two values: for a, b > 0 and
//! 0 ≤ p ≤ 1, a^(1−p)·b^p ≤ (1−p)·a + p·b, strict for a ≠ b and 0 < p < 1 (the exponential function
//! lies above its tangents). Hölder's inequality for two pairs follows from it: with S = a + b and
//! T = c + d, (a/S)^(1−p)(c/T)^p ≤ (1−p)·a/S + p·c/T, the same with b and d, and the right sides
//! add up to 1; multiply by S^(1−p)·T^p.

use super::argument::not_shown;
use super::context::*;
use super::expand::{Substitution, names_of_prop};
use crate::algebra::form::{Atom, Form};
use crate::claim::definedness;
use crate::claim::print;
use crate::claim::syntax::*;
use malachite::Rational;
use malachite::base::num::basic::traits::Zero;
use malachite::base::num::conversion::traits::IsInteger;
use std::collections::BTreeSet;

type Result<T> = std::result::Result<T, Failure>;

impl Engine<'_> {
    /// Shows a goal by a named method.
    pub fn by_method(&mut self, cx: &mut Context, goal: &Prop, method: &Method) -> Result<()> {
        match method {
            Method::Algebra(facts) => {
                for fact in facts {
                    self.fact(cx, fact)?;
                }
                self.show_goal(cx, goal)
            }
            Method::Induction(variable, step) => self.induction(cx, goal, variable, step),
            Method::Power { fact, exponent } => self.power_of_fact(cx, goal, fact, exponent),
            Method::Product(list) => self.product_of_facts(cx, goal, list),
            Method::Mean { a, b, weight } => self.mean(cx, goal, a, b, weight),
            Method::Hoelder { first, second, weight } => self.hoelder(cx, goal, first, second, weight),
            Method::Instance { claim, with } => self.instance(cx, goal, claim, with),
            Method::Witness(values) => self.witness(cx, goal, values),
            Method::Squeeze { lower, upper } => self.squeeze(cx, goal, lower, upper),
        }
    }

    /// The fact with a label: a comparison of two sides.
    fn fact(&mut self, cx: &Context, label: &Name) -> Result<(usize, Prop)> {
        let found = cx.facts.iter().rposition(|f| f.label.as_deref() == Some(&label.text));
        match found {
            Some(place) => {
                self.used |= source(place);
                Ok((place, (*cx.facts[place].prop).clone()))
            }
            None => {
                let known: Vec<&str> = cx.facts.iter().filter_map(|f| f.label.as_deref()).collect();
                let nearest = crate::claim::diagnostic::nearest(&label.text, known);
                let message = format!("no fact is called {}", label.text);
                let help = nearest.map(|n| format!("did you mean {n}?"));
                Err(Failure::Fault(Diagnose { message, help, span: label.span }))
            }
        }
    }

    fn two_sides(&mut self, cx: &Context, label: &Name) -> Result<(Expr, Relation, Expr)> {
        let (_, prop) = self.fact(cx, label)?;
        match &prop.kind {
            PropKind::Compare(sides, relations) if sides.len() == 2 && relations[0] != Relation::NotEqual => {
                let (a, b) = (sides[0].clone(), sides[1].clone());
                Ok(match relations[0] {
                    Relation::Less => (b, Relation::Greater, a),
                    Relation::LessEqual => (b, Relation::GreaterEqual, a),
                    other => (a, other, b),
                })
            }
            _ => Err(super::translate::fault(label.span, "a comparison of two sides is needed here")),
        }
    }

    /// From A ≥ B > 0 and E > 0 to A^E ≥ B^E.
    fn power_of_fact(&mut self, cx: &mut Context, goal: &Prop, label: &Name, exponent: &Expr) -> Result<()> {
        let (a, relation, b) = self.two_sides(cx, label)?;
        self.positive(cx, exponent)?;
        // A ≥ B > 0 makes A positive as well; shown anyway, so that the powers are defined.
        self.positive(cx, &b)?;
        self.positive(cx, &a)?;
        let fact = compare(power(a, exponent), relation, power(b, exponent));
        self.line("power", format!("{} to the power {}: {}", label.text, print::expr(exponent), print::prop(&fact)));
        self.assume(cx, &fact, None, Origin::Derived)?;
        self.show_goal(cx, goal)
    }

    /// The product of inequalities between positive sides, each to a positive power.
    fn product_of_facts(&mut self, cx: &mut Context, goal: &Prop, list: &[(Name, Option<Expr>)]) -> Result<()> {
        let (mut left, mut right) = (Vec::new(), Vec::new());
        let mut relation = Relation::Equal;
        for (label, exponent) in list {
            let (a, r, b) = self.two_sides(cx, label)?;
            self.positive(cx, &b)?;
            self.positive(cx, &a)?;
            if let Some(exponent) = exponent {
                self.positive(cx, exponent)?;
            }
            relation = match (relation, r) {
                (Relation::Greater, _) | (_, Relation::Greater) => Relation::Greater,
                (Relation::GreaterEqual, _) | (_, Relation::GreaterEqual) => Relation::GreaterEqual,
                _ => Relation::Equal,
            };
            let raised = |e: Expr| match exponent {
                Some(exponent) => power(e, exponent),
                None => e,
            };
            left.push((Factor::Times, raised(a)));
            right.push((Factor::Times, raised(b)));
        }
        let fact = compare(expr(ExprKind::Product(left)), relation, expr(ExprKind::Product(right)));
        self.line("product", format!("the product of the facts: {}", print::prop(&fact)));
        self.assume(cx, &fact, None, Origin::Derived)?;
        self.show_goal(cx, goal)
    }

    /// The weighted mean inequality.
    fn mean(&mut self, cx: &mut Context, goal: &Prop, a: &Expr, b: &Expr, weight: &Expr) -> Result<()> {
        self.positive(cx, a)?;
        self.positive(cx, b)?;
        let strict = self.weight_and_difference(cx, weight, a, b)?;
        let rest = difference(number(1), weight.clone());
        let left = times(power(a.clone(), &rest), power(b.clone(), weight));
        let right = plus(times(rest, a.clone()), times(weight.clone(), b.clone()));
        let relation = if strict { Relation::Less } else { Relation::LessEqual };
        let fact = compare(left, relation, right);
        self.line("mean inequality", print::prop(&fact));
        self.assume(cx, &fact, None, Origin::Derived)?;
        self.show_goal(cx, goal)
    }

    /// Shows 0 ≤ p ≤ 1; true if 0 < p < 1 and x ≠ y can be shown as well.
    fn weight_and_difference(&mut self, cx: &mut Context, weight: &Expr, x: &Expr, y: &Expr) -> Result<bool> {
        let range = |relation| {
            let sides = vec![number(0), weight.clone(), number(1)];
            Prop { kind: PropKind::Compare(sides, vec![relation, relation]), span: weight.span }
        };
        self.quietly(cx, &range(Relation::LessEqual))?;
        let distinct = compare(x.clone(), Relation::NotEqual, y.clone());
        Ok(self.quietly(cx, &range(Relation::Less)).is_ok() && self.quietly(cx, &distinct).is_ok())
    }

    /// Hölder's inequality for two pairs.
    fn hoelder(
        &mut self,
        cx: &mut Context,
        goal: &Prop,
        first: &(Expr, Expr),
        second: &(Expr, Expr),
        weight: &Expr,
    ) -> Result<()> {
        for e in [&first.0, &first.1, &second.0, &second.1] {
            self.positive(cx, e)?;
        }
        // Equality needs a/S = c/T and b/S = d/T, that is, a·d = b·c.
        let ad = times(first.0.clone(), second.1.clone());
        let bc = times(first.1.clone(), second.0.clone());
        let strict = self.weight_and_difference(cx, weight, &ad, &bc)?;
        let rest = difference(number(1), weight.clone());
        let product = |a: &Expr, c: &Expr| times(power(a.clone(), &rest), power(c.clone(), weight));
        let left = times(
            power(plus(first.0.clone(), first.1.clone()), &rest),
            power(plus(second.0.clone(), second.1.clone()), weight),
        );
        let right = plus(product(&first.0, &second.0), product(&first.1, &second.1));
        let relation = if strict { Relation::Greater } else { Relation::GreaterEqual };
        let fact = compare(left, relation, right);
        self.line("mean inequality", format!("in the form of Hoelder: {}", print::prop(&fact)));
        self.assume(cx, &fact, None, Origin::Derived)?;
        self.show_goal(cx, goal)
    }

    /// Base and step. Hypotheses about the variable other than its own lower bound are set aside.
    fn induction(&mut self, cx: &mut Context, goal: &Prop, variable: &Name, steps: &Proof) -> Result<()> {
        if !cx.variables.iter().any(|(v, natural)| *v == variable.text && *natural) {
            return Err(super::translate::fault(variable.span, "induction needs a natural variable of the claim"));
        }
        // A family or sequence that depends on the variable is another one at n + 1.
        for family in cx.families.values() {
            if super::expand::names_of_binding(&family.binding).contains(&variable.text) {
                return Err(Failure::NotShown(format!("induction on {}: a family depends on it", variable.text)));
            }
        }
        for sequence in cx.sequences.values() {
            if sequence_names(sequence).contains(&variable.text) {
                return Err(Failure::NotShown(format!("induction on {}: a sequence depends on it", variable.text)));
            }
        }
        let (mut base, mut least) = (number(0), Rational::ZERO);
        let (mut kept, mut aside) = (Vec::new(), cx.aside.clone());
        for fact in &cx.facts {
            if !names_of_prop(&fact.prop).contains(&variable.text) {
                kept.push(fact.clone());
                continue;
            }
            if let PropKind::Compare(sides, relations) = &fact.prop.kind
                && fact.origin == Origin::Domain
                && let [left, bound] = sides.as_slice()
                && matches!(&left.kind, ExprKind::Name(n) if *n == variable.text)
                && relations[0] == Relation::GreaterEqual
                && let ExprKind::Number(text) = &bound.kind
            {
                // The greatest of the bounds is where n begins; the base has to be a number that n can be.
                let whole = crate::number::rational::parse(text).ok().filter(|q| q.is_integer());
                let Some(from) = whole else {
                    return Err(Failure::NotShown(format!(
                        "induction on {}: {text} is no whole number",
                        variable.text
                    )));
                };
                if from > least {
                    (base, least) = (bound.clone(), from);
                }
                kept.push(fact.clone());
            } else {
                aside.push(fact.clone());
                // Keeps the numbering of facts.
                let nothing = Prop { kind: PropKind::And(Vec::new()), span: fact.prop.span };
                kept.push(Fact { prop: std::rc::Rc::new(nothing), label: None, origin: fact.origin });
            }
        }
        let mut clean = cx.clone();
        clean.facts = kept;
        clean.aside = aside;
        clean.environment.clear();
        clean.contradiction = None;
        self.rebuild(&mut clean)?;
        let at = |value: Expr| -> Result<Prop> {
            let mut map = Substitution::default();
            map.replace(&variable.text, value);
            Ok(map.prop(goal)?)
        };
        let first = at(base.clone())?;
        self.line("induction", format!("base {} = {}: {}", variable.text, print::expr(&base), print::prop(&first)));
        let mut inner = clean.clone();
        self.deeper(|engine| engine.show_goal(&mut inner, &first))?;
        let next = at(plus(name_expr(&variable.text), number(1)))?;
        self.line("induction", format!("step to {} + 1: {}", variable.text, print::prop(&next)));
        self.deeper(|engine| {
            engine.assume(&mut clean, goal, Some("induction".to_string()), Origin::Hypothesis)?;
            engine.follow(&mut clean, &next, steps)
        })
    }

    /// An instance of a proved claim, or of a fact `for all`.
    fn instance(&mut self, cx: &mut Context, goal: &Prop, claim: &Name, with: &[(Name, Expr)]) -> Result<()> {
        let mut map = Substitution::default();
        let mut local = None;
        if let Some(place) = cx.facts.iter().rposition(|f| f.label.as_deref() == Some(&claim.text)) {
            local = Some((*cx.facts[place].prop).clone());
            self.used |= source(place);
        }
        let (bindings, assumptions, conclusion) = match local {
            Some(Prop { kind: PropKind::ForAll(bindings, body), .. }) => (bindings, Vec::new(), *body),
            Some(prop) => (Vec::new(), Vec::new(), prop),
            None => {
                if self.unproved.contains(&claim.text) {
                    return Err(Failure::RestsOn(claim.text.clone()));
                }
                let Some(statement) = self.cited.get(&claim.text).cloned() else {
                    let message = format!("no claim or fact called {} is cited here", claim.text);
                    let help = Some("name the claim under `using`".to_string());
                    return Err(Failure::Fault(Diagnose { message, help, span: claim.span }));
                };
                for sequence in &statement.sequences {
                    let same = cx.sequences.get(&sequence.name).is_some_and(|s| {
                        s.initial.same(&sequence.initial) && s.step.same(&sequence.step) && s.index == sequence.index
                    });
                    let names = sequence_names(sequence);
                    if !same || with.iter().any(|w| names.contains(&w.0.text)) {
                        return Err(Failure::NotShown(format!(
                            "the sequence {} of {} is not the same here",
                            sequence.name, claim.text
                        )));
                    }
                }
                let assumptions = statement.assumptions.iter().map(|a| a.1.clone()).collect();
                (statement.bindings.clone(), assumptions, statement.goal.clone())
            }
        };
        let declared: BTreeSet<&str> =
            bindings.iter().flat_map(|b| b.names.iter().map(|n| n.0.text.as_str())).collect();
        for (place, (name, _)) in with.iter().enumerate() {
            if with.iter().take(place).any(|w| w.0.text == name.text) {
                return Err(super::translate::fault(name.span, "one value for each variable"));
            }
            if !declared.contains(name.text.as_str()) {
                let message = format!("{} has no variable {}", claim.text, name.text);
                let help = crate::claim::diagnostic::nearest(&name.text, declared.iter().copied());
                return Err(Failure::Fault(Diagnose { message, help, span: name.span }));
            }
        }
        let mut obligations: Vec<Prop> = Vec::new();
        let mut families: Vec<&Binding> = Vec::new();
        for binding in &bindings {
            for (name, index) in &binding.names {
                let given = with.iter().find(|w| w.0.text == name.text).map(|w| &w.1);
                match (index, given) {
                    (Some(_), Some(Expr { kind: ExprKind::Name(other), .. })) => map.rename_family(&name.text, other),
                    (Some(_), Some(value)) => {
                        return Err(super::translate::fault(
                            value.span,
                            "a family is replaced by the name of a family",
                        ));
                    }
                    (None, Some(value)) => {
                        self.valued(cx, value)?;
                        map.replace(&name.text, value.clone());
                    }
                    (_, None) => {
                        let known = if index.is_some() {
                            cx.families.contains_key(&name.text)
                        } else {
                            cx.variables.iter().any(|v| v.0 == name.text)
                        };
                        if !known {
                            return Err(Failure::NotShown(format!("no value for {} of {}", name.text, claim.text)));
                        }
                    }
                }
            }
            if binding.names.iter().any(|n| n.1.is_some()) {
                families.push(binding);
            }
            obligations.extend(super::assume::domain(binding));
        }
        obligations.extend(assumptions);
        let label = if with.is_empty() {
            claim.text.clone()
        } else {
            let list: Vec<String> = with.iter().map(|(n, e)| format!("{} = {}", n.text, print::expr(e))).collect();
            format!("{} with {}", claim.text, list.join(", "))
        };
        let conclusion = map.prop(&conclusion)?;
        self.line("instance", format!("{label}: {}", print::prop(&conclusion)));
        self.deeper(|engine| {
            for binding in &bindings {
                if binding.natural {
                    for (name, index) in &binding.names {
                        if index.is_none() {
                            let value = map.expr(&name_expr(&name.text))?;
                            engine.natural(cx, &value)?;
                        }
                    }
                }
            }
            for binding in families {
                engine.family_domain(cx, binding, &mut map)?;
            }
            for obligation in &obligations {
                let prop = map.prop(obligation)?;
                engine.quietly(cx, &prop)?;
            }
            Ok::<(), Failure>(())
        })?;
        self.assume(cx, &conclusion, None, Origin::Derived)?;
        self.show_goal(cx, goal)
    }

    /// Shows that a value to be put in exists: what is shown with it says so nowhere if it does not mention it.
    pub fn valued(&mut self, cx: &mut Context, value: &Expr) -> Result<Form> {
        let mut conditions = Vec::new();
        let form = self.scalar(cx, value, &mut conditions)?;
        self.show_conditions(cx, conditions)?;
        Ok(form)
    }

    /// Shows that the bounds of a binding have values, in the scope in which they stand.
    pub fn bounds_valued(&mut self, cx: &Context, binding: &Binding) -> Result<()> {
        let mut put = Substitution::default();
        let mut inner = cx.clone();
        for index in binding.names.iter().filter_map(|n| n.1.as_ref()) {
            // No name that anybody can write has an apostrophe before its end.
            let any = format!("{}'any", index.text);
            inner.variables.push((any.clone(), true));
            put.replace(&index.text, name_expr(&any));
        }
        let mut bounds = Vec::new();
        for constraint in &binding.constraints {
            match constraint {
                Constraint::Relation(_, e) => bounds.push(e),
                Constraint::Interval { from, to, .. } | Constraint::Range(from, to) => bounds.extend([from, to]),
            }
        }
        bounds.extend(binding.indices.iter().flat_map(|(from, to)| [from, to]));
        for bound in bounds {
            let bound = put.expr(bound)?;
            self.valued(&mut inner, &bound)?;
        }
        Ok(())
    }

    /// Shows that every member of a sequence has a value: u(0), and u(k + 1) for any natural k and any number u(k).
    pub fn members_valued(&mut self, cx: &Context, sequence: &super::expand::Sequence) -> Result<()> {
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
            Ok(_) => Ok(()),
            Err(Failure::Undefined(what)) => {
                let what = what
                    .replace(index, &sequence.index)
                    .replace(before, &format!("{}({})", sequence.name, sequence.index));
                Err(Failure::Undefined(format!("in the sequence {} {what}", sequence.name)))
            }
            Err(failure) => Err(failure),
        }
    }

    /// Shows that a value is a natural number: an integer combination of natural variables, not
    /// negative.
    fn natural(&mut self, cx: &mut Context, value: &Expr) -> Result<()> {
        // By its form as well, so that a power keeps its meaning where the value is put into the exponent.
        if !definedness::is_whole(value, &|name| super::translate::is_natural_name(cx, name)) {
            return Err(Failure::NotShown(format!("{} is a whole number by its form", print::expr(value))));
        }
        let form = self.valued(cx, value)?;
        for summand in self.ring.summands(&form)? {
            let whole = (&summand.coefficient).is_integer()
                && summand.powers.iter().all(|(a, e)| e.as_integer().is_some_and(|k| k > 0) && self.is_natural(cx, *a));
            if !whole {
                return Err(Failure::NotShown(format!("{} is a natural number", print::expr(value))));
            }
        }
        self.quietly(cx, &compare(value.clone(), Relation::GreaterEqual, number(0)))
    }

    /// Shows that a family here has the domain that a cited claim asks of its family.
    fn family_domain(&mut self, cx: &mut Context, binding: &Binding, map: &mut Substitution) -> Result<()> {
        for (name, index) in &binding.names {
            let Some(index) = index else { continue };
            let mut inner = cx.clone();
            // No name that anybody can write has an apostrophe before its end.
            let bound = format!("{}'any", index.text);
            inner.variables.push((bound.clone(), true));
            if let Some((from, to)) = &binding.indices {
                for (a, b) in [(map.expr(from)?, name_expr(&bound)), (name_expr(&bound), map.expr(to)?)] {
                    self.assume(&mut inner, &compare(a, Relation::LessEqual, b), None, Origin::Hypothesis)?;
                }
            }
            let member = Expr { kind: ExprKind::Apply(name.clone(), vec![name_expr(&bound)]), span: name.span };
            let member = map.expr(&member)?;
            let whole = |family: &Family| family.binding.natural;
            if binding.natural
                && !matches!(&member.kind, ExprKind::Apply(f, _) if cx.families.get(&f.text).is_some_and(|f| whole(f)))
            {
                return Err(Failure::NotShown(format!("{} is a family of natural numbers", print::expr(&member))));
            }
            self.quietly(&inner, &compare(member.clone(), Relation::Equal, member.clone()))?;
            let variable = Name { text: "'member".to_string(), span: name.span };
            let single = Binding { names: vec![(variable.clone(), None)], indices: None, ..binding.clone() };
            // The bounds are those of the cited claim, and the member is already one of this claim: it is put in last.
            let (mut place, mut put) = (Substitution::default(), Substitution::default());
            place.replace(&index.text, name_expr(&bound));
            put.replace(&variable.text, member);
            for prop in super::assume::domain(&single) {
                let prop = place.prop(&prop)?;
                let prop = map.prop(&prop)?;
                let prop = put.prop(&prop)?;
                self.quietly(&inner, &prop)?;
            }
        }
        Ok(())
    }

    fn witness(&mut self, cx: &mut Context, goal: &Prop, values: &[(Name, Expr)]) -> Result<()> {
        let PropKind::Exists(bindings, body) = &goal.kind else {
            return Err(super::translate::fault(goal.span, "a witness is for `exists`"));
        };
        let mut map = Substitution::default();
        for (place, (name, value)) in values.iter().enumerate() {
            let bound = bindings.iter().flat_map(|b| &b.names).any(|n| n.0.text == name.text);
            if !bound || values.iter().take(place).any(|v| v.0.text == name.text) {
                return Err(super::translate::fault(name.span, "a witness gives each variable of `exists` one value"));
            }
            self.valued(cx, value)?;
            map.replace(&name.text, value.clone());
        }
        let text: Vec<String> = values.iter().map(|(n, e)| format!("{} = {}", n.text, print::expr(e))).collect();
        self.line("witness", text.join(", "));
        for binding in bindings {
            for (name, index) in &binding.names {
                let Some((_, value)) = values.iter().find(|v| v.0.text == name.text) else {
                    return Err(super::translate::fault(goal.span, "the witness leaves a variable without a value"));
                };
                if index.is_some() {
                    return Err(super::translate::fault(goal.span, "a witness cannot name a family"));
                }
                if binding.natural {
                    self.natural(cx, value)?;
                }
            }
            for prop in super::assume::domain(binding) {
                let prop = map.prop(&prop)?;
                self.quietly(cx, &prop)?;
            }
        }
        let body = map.prop(body)?;
        self.deeper(|engine| engine.show_goal(cx, &body))
    }

    /// Existence without a stated witness: small exact values are tried.
    pub fn existence(&mut self, cx: &mut Context, bindings: &[Binding], body: &Prop) -> Result<()> {
        let goal = Prop { kind: PropKind::Exists(bindings.to_vec(), Box::new(body.clone())), span: body.span };
        let Some(point) = super::refute::example(bindings, body, self.deadline) else { return Err(not_shown(&goal)) };
        let values: Vec<(Name, Expr)> = point
            .into_iter()
            .map(|(name, value)| (Name { text: name, span: body.span }, super::refute::literal(&value)))
            .collect();
        self.witness(cx, &goal, &values)
    }

    /// Shows e > 0.
    pub fn positive(&mut self, cx: &mut Context, e: &Expr) -> Result<()> {
        self.quietly(cx, &compare(e.clone(), Relation::Greater, number(0)))
    }

    /// Shows a side condition without writing its argument.
    pub fn quietly(&mut self, cx: &Context, prop: &Prop) -> Result<()> {
        let (lines, rules) = (self.log.len(), self.rules.len());
        let result = self.attempt(|engine| engine.show_goal(&mut cx.clone(), prop));
        self.log.truncate(lines);
        self.rules.truncate(rules);
        result
    }

    /// Whether a form is free of a variable.
    pub fn free_of(&mut self, form: &Form, name: &str) -> bool {
        let atom = self.ring.intern(Atom::Variable(name.to_string()));
        !self.ring.mentions(form, &|a| a == atom)
    }
}

/// The names in the definition of a sequence, but for its own index.
pub fn sequence_names(sequence: &super::expand::Sequence) -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    super::expand::names_in(&sequence.step, &mut names);
    names.remove(&sequence.index);
    super::expand::names_in(&sequence.initial, &mut names);
    names
}

fn expr(kind: ExprKind) -> Expr {
    Expr { kind, span: Span::default() }
}

/// A numeral.
pub fn number(value: u32) -> Expr {
    expr(ExprKind::Number(value.to_string()))
}

fn power(base: Expr, exponent: &Expr) -> Expr {
    expr(ExprKind::Power(Box::new(base), Box::new(exponent.clone())))
}

fn times(a: Expr, b: Expr) -> Expr {
    expr(ExprKind::Product(vec![(Factor::Times, a), (Factor::Times, b)]))
}

fn plus(a: Expr, b: Expr) -> Expr {
    expr(ExprKind::Sum(vec![(Sign::Plus, a), (Sign::Plus, b)]))
}

fn difference(a: Expr, b: Expr) -> Expr {
    expr(ExprKind::Sum(vec![(Sign::Plus, a), (Sign::Minus, b)]))
}

/// `a relation b`.
pub fn compare(a: Expr, relation: Relation, b: Expr) -> Prop {
    Prop { kind: PropKind::Compare(vec![a, b], vec![relation]), span: Span::default() }
}
