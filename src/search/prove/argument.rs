//! The claim's own argument, followed step by step. What it states is a goal like any other, with all methods.

use super::facts::negated;
use super::letters::product;
use super::means::positive;
use super::{Fail, Prover, implies};
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::kernel::statement::{Statement, compare, domain, name, numeral, one_minus, power, prop};
use crate::kernel::substitution::Substitution;

/// What an argument has named so far.
#[derive(Clone, Default)]
pub(super) struct Named {
    /// Its labels, each with the fact that it stands for; the newest is last.
    facts: Vec<(String, Label)>,
    /// The names that it obtained, with their values.
    values: Substitution,
    /// The steps that gave these.
    steps: Vec<Step>,
}

impl Named {
    /// The labels of the hypotheses.
    pub(super) fn hypotheses(facts: Vec<(String, Label)>) -> Named {
        Named { facts, ..Named::default() }
    }

    fn prop(&self, p: &Prop) -> Result<Prop, Fail> {
        self.values.prop(p).map_err(Fail::from)
    }

    fn expr(&self, e: &Expr) -> Result<Expr, Fail> {
        self.values.expr(e).map_err(Fail::from)
    }

    fn with(&self, with: &[(Name, Expr)]) -> Result<Vec<(Name, Expr)>, Fail> {
        with.iter().map(|(n, e)| Ok((n.clone(), self.expr(e)?))).collect()
    }

    fn fact(&self, label: &str) -> Option<Label> {
        self.facts.iter().rev().find(|f| f.0 == label).map(|f| f.1.clone())
    }
}

impl Prover {
    /// Proves a goal by an argument, which may speak of what is `named`.
    pub(super) fn follow(&mut self, goal: &Prop, proof: &Proof, named: &Named) -> Result<Label, Fail> {
        let mut named = named.clone();
        for (at, step) in proof.steps.iter().enumerate() {
            self.renew();
            match step {
                Step::Have { label, prop, proof } => {
                    let fact = named.prop(prop)?;
                    let shown = self.follow(&fact, proof, &named).map_err(|e| e.within(&label.text))?;
                    self.take_in(&shown, &fact)?;
                    named.facts.push((label.text.clone(), shown));
                }
                Step::Obtain { binding, label, prop, witness } => {
                    let value = named.expr(witness)?;
                    self.define(&value);
                    if let Some((variable, _)) = binding.names.first() {
                        named.values.replace(&variable.text, &value);
                    }
                    for fact in domain(binding) {
                        let fact = named.prop(&fact)?;
                        let shown = self.show(&fact)?;
                        self.take_in(&shown, &fact)?;
                    }
                    let fact = named.prop(prop)?;
                    let shown = self.show(&fact)?;
                    self.take_in(&shown, &fact)?;
                    named.facts.push((label.text.clone(), shown));
                }
                Step::Case { .. } => {
                    return self.by_these_cases(goal, proof.steps.get(at..).unwrap_or_default(), &named);
                }
            }
            named.steps.push(step.clone());
        }
        self.renew();
        match &proof.close {
            None => self.show(goal),
            Some(method) => self.by_method(goal, method, &named),
        }
    }

    /// Proves a limit between two others. What the steps so far show of the variable that grows holds of each of its values: they
    /// are followed again for all of them.
    fn by_this_squeeze(
        &mut self,
        goal: &Prop,
        limit: &Limit,
        [lower, upper]: &[Expr; 2],
        named: &Named,
    ) -> Result<Label, Fail> {
        let variable = &limit.variable.text;
        let least = self.least(variable).unwrap_or(0);
        let again = Proof { steps: named.steps.clone(), close: None };
        self.squeeze(goal, limit, [lower, upper], &numeral(least), &mut |c, k, every, body| {
            let mut inside = named.clone();
            inside.values.replace(variable, k);
            let followed = c.attempt(|c| c.block(every, |c, _| c.follow(body, &again, &inside)));
            if followed.is_ok() || again.steps.is_empty() {
                return followed;
            }
            c.renew();
            c.block(every, |c, _| c.show(body))
        })
    }

    /// Proves a goal in the cases of an argument.
    fn by_these_cases(&mut self, goal: &Prop, steps: &[Step], named: &Named) -> Result<Label, Fail> {
        let mut cases = Vec::new();
        for step in steps {
            let Step::Case { label, prop, proof } = step else { return Err(Fail::No("cases come last")) };
            cases.push((label.text.clone(), named.prop(prop)?, proof));
        }
        let all = prop(PropKind::Or(cases.iter().map(|c| c.1.clone()).collect()));
        let mut from = vec![self.show(&all)?];
        for (label, case, proof) in cases {
            from.push(self.block(&implies(&case, goal), |c, block| {
                let mut named = named.clone();
                named.facts.push((label, format!("{block}s")));
                c.follow(goal, proof, &named)
            })?);
        }
        self.emit(Rule::Logic { from }, goal.clone())
    }

    /// Proves a goal by a method.
    fn by_method(&mut self, goal: &Prop, method: &Method, named: &Named) -> Result<Label, Fail> {
        match method {
            Method::Algebra(_) => self.show(goal),
            Method::Witness(values) => {
                let PropKind::Exists(bindings, body) = &goal.kind else {
                    return Err(Fail::No("a witness proves `exists` only"));
                };
                let values = named.with(values)?;
                values.iter().for_each(|(_, value)| self.define(value));
                self.by_values(goal, bindings, body, values.into_iter().map(|(n, e)| (n.text, e)).collect())
            }
            Method::Induction(variable, steps) => self.by_this_induction(goal, variable, steps, named),
            Method::Instance { claim, with } => {
                let fact = self.take_instance(&claim.text, named.with(with)?, named)?;
                self.show_by(goal, &fact)
            }
            Method::Power { fact, exponent } => {
                let exponent = named.expr(exponent)?;
                let fact = self.power_of(&fact.text, &exponent, named)?;
                self.show_by(goal, &fact)
            }
            Method::Product(list) => {
                let fact = self.product_of(list, named)?;
                self.show_by(goal, &fact)
            }
            Method::Mean { a, b, weight } => {
                let [a, b, p] = [a, b, weight].map(|e| named.expr(e));
                let (fact, _) = self.this_mean(&a?, &b?, &p?)?;
                self.show_by(goal, &fact)
            }
            Method::Hoelder { first, second, weight } => {
                let p = named.expr(weight)?;
                let [a, b, c, d] = [&first.0, &first.1, &second.0, &second.1].map(|e| named.expr(e));
                let fact = self.hoelder(&[a?, b?], &[c?, d?], &p)?;
                self.show_by(goal, &fact)
            }
            Method::Squeeze { lower, upper } => {
                let PropKind::Limit(limit) = &goal.kind else { return Err(Fail::No("`squeeze` proves limits only")) };
                let bounds = [named.expr(lower)?, named.expr(upper)?];
                self.by_this_squeeze(goal, limit, &bounds, named)
            }
        }
    }

    /// Proves a goal with a fact that the argument names for it: the two may differ in how they are written only. The search finds
    /// such goals by itself, but this step names the fact as its reason, and so does the explanation.
    fn show_by(&mut self, goal: &Prop, fact: &str) -> Result<Label, Fail> {
        let is_comparison = |p: &Prop| matches!(&p.kind, PropKind::Compare(_, relations) if relations.len() == 1);
        if self.known(goal).is_none() && is_comparison(goal) && self.fact(fact).as_ref().is_some_and(is_comparison) {
            for factor in [numeral(1), negated(numeral(1))] {
                if let Ok(label) = self.combination(goal.clone(), vec![Term { facts: vec![fact.to_string()], factor }])
                {
                    return Ok(label);
                }
            }
        }
        self.show(goal)
    }

    /// Proves a goal by induction on one of the claim's variables; the step follows an argument.
    fn by_this_induction(&mut self, goal: &Prop, variable: &Name, steps: &Proof, named: &Named) -> Result<Label, Fail> {
        let base = self.least(&variable.text);
        let fresh = self.fresh("k");
        let body = super::put(goal, &variable.text, &name(&fresh))?;
        let mut inside = named.clone();
        inside.values.replace(&variable.text, &name(&fresh));
        let every = self.induction_by(&fresh, base, &body, &mut |c, hypothesis, next| {
            inside.facts.push(("induction".to_string(), hypothesis));
            c.follow(next, steps, &inside)
        })?;
        self.instance(&every, &name(&variable.text))
    }

    /// An instance of a cited claim or of a fact, taken in. Returns its label.
    fn take_instance(&mut self, source: &str, with: Vec<(Name, Expr)>, named: &Named) -> Result<Label, Fail> {
        if let Some(label) = named.fact(source) {
            let Some(Prop { kind: PropKind::ForAll(bindings, body), .. }) = self.fact(&label) else { return Ok(label) };
            let mut map = Substitution::default();
            with.iter().for_each(|(n, e)| map.replace(&n.text, e));
            let mut from = Vec::new();
            for fact in bindings.iter().flat_map(domain) {
                from.push(self.show(&map.prop(&fact).map_err(Fail::from)?)?);
            }
            let shown = map.prop(&body).map_err(Fail::from)?;
            let label = self.emit(Rule::Instance { source: label, with, from }, shown.clone())?;
            return self.take_in(&label, &shown).map(|()| label);
        }
        let cited = self.checker.cited_statement(source).ok_or_else(|| Fail::NoProofOf(source.to_string()))?.clone();
        let (with, map) = values_for(&cited, with, &|e| named.expr(e))?;
        with.iter().for_each(|(_, value)| self.define(value));
        let mut from = Vec::new();
        for fact in cited.bindings.iter().flat_map(domain).chain(cited.assumptions.iter().cloned()) {
            let fact = map.prop(&fact).map_err(Fail::from)?;
            from.push(self.show(&fact).map_err(|e| e.within(source))?);
        }
        let shown = map.prop(&cited.goal).map_err(Fail::from)?;
        let label = self.emit(Rule::Instance { source: source.to_string(), with, from }, shown.clone())?;
        self.take_in(&label, &shown).map(|()| label)
    }

    /// A fact with both sides to a power, and its label. That they and the exponent are positive is shown first.
    fn power_of(&mut self, fact: &str, exponent: &Expr, named: &Named) -> Result<Label, Fail> {
        let label = named.fact(fact).ok_or_else(|| Fail::NoFact(fact.to_string()))?;
        let fact = self.fact(&label);
        let Some((a, relation, b)) = fact.as_ref().and_then(Prop::single) else {
            return Err(Fail::No("a comparison is needed"));
        };
        for e in [a, b, exponent] {
            self.show(&positive(e))?;
        }
        let shown = compare(power(a, exponent), relation, power(b, exponent));
        let label = self.emit(Rule::Monotone { from: label }, shown.clone())?;
        self.take_in(&label, &shown).map(|()| label)
    }

    /// The product of comparisons a_i >= b_i between positive sides: a_1…a_n − b_1…b_n is the sum of
    /// b_1…b_(i−1)·(a_i − b_i)·a_(i+1)…a_n.
    fn product_of(&mut self, list: &[(Name, Option<Expr>)], named: &Named) -> Result<Label, Fail> {
        let (mut highs, mut lows, mut facts) = (Vec::new(), Vec::new(), Vec::new());
        let mut strict = false;
        for (fact, exponent) in list {
            if exponent.is_some() {
                return Err(Fail::No("powers in a product"));
            }
            let label = named.fact(&fact.text).ok_or_else(|| Fail::NoFact(fact.text.clone()))?;
            let Some(Prop { kind: PropKind::Compare(sides, relations), .. }) = self.fact(&label) else {
                return Err(Fail::No("a comparison is needed"));
            };
            strict |= matches!(relations[0], Relation::Greater | Relation::Less);
            let up = matches!(relations[0], Relation::Greater | Relation::GreaterEqual);
            let (high, low) = if up { (&sides[0], &sides[1]) } else { (&sides[1], &sides[0]) };
            highs.push(high.clone());
            lows.push(low.clone());
            facts.push((label, up));
        }
        let mut terms = Vec::new();
        for (place, (label, up)) in facts.into_iter().enumerate() {
            let factor = product(lows.iter().take(place).chain(highs.iter().skip(place + 1)).cloned().collect());
            terms.push(Term { facts: vec![label], factor: if up { factor } else { negated(factor) } });
        }
        let relation = if strict { Relation::Greater } else { Relation::GreaterEqual };
        let shown = compare(product(highs), relation, product(lows));
        let label = self.combination(shown.clone(), terms)?;
        self.take_in(&label, &shown).map(|()| label)
    }
}

/// The values for the names of a cited claim, and what they put in place of these. A variable without a value keeps its name; an
/// obtained name stands for its value.
pub(super) fn values_for(
    cited: &Statement,
    mut with: Vec<(Name, Expr)>,
    value_of: &dyn Fn(&Expr) -> Result<Expr, Fail>,
) -> Result<(Vec<(Name, Expr)>, Substitution), Fail> {
    let names = || cited.bindings.iter().flat_map(|b| &b.names);
    for (variable, index) in names() {
        let value = value_of(&name(&variable.text))?;
        let given = with.iter().any(|w| w.0.text == variable.text);
        if index.is_none() && !given && !matches!(&value.kind, ExprKind::Name(n) if *n == variable.text) {
            with.push((variable.clone(), value));
        }
    }
    let mut map = Substitution::default();
    for (variable, value) in &with {
        let family = names().any(|n| n.0.text == variable.text && n.1.is_some());
        match (&value.kind, family) {
            (ExprKind::Name(other), true) => map.rename_family(&variable.text, other),
            _ => map.replace(&variable.text, value),
        }
    }
    Ok((with, map))
}

/// Every expression of an argument; `of` gives those of a proposition.
pub(super) fn exprs_in(proof: &Proof, of: &dyn Fn(&Prop, &mut Vec<Expr>), out: &mut Vec<Expr>) {
    for step in &proof.steps {
        match step {
            Step::Have { prop, proof, .. } | Step::Case { prop, proof, .. } => {
                of(prop, out);
                exprs_in(proof, of, out);
            }
            Step::Obtain { witness, .. } => out.push(witness.clone()),
        }
    }
    match &proof.close {
        Some(Method::Mean { a, b, weight }) => out.extend([power(a, &one_minus(weight)), power(b, weight)]),
        Some(Method::Hoelder { first, second, weight }) => {
            let rest = one_minus(weight);
            for (x, q) in [(&first.0, &rest), (&first.1, &rest), (&second.0, weight), (&second.1, weight)] {
                out.push(power(x, q));
            }
        }
        Some(Method::Squeeze { lower, upper }) => out.extend([lower.clone(), upper.clone()]),
        Some(Method::Instance { with, .. }) => out.extend(with.iter().map(|w| w.1.clone())),
        _ => {}
    }
}
