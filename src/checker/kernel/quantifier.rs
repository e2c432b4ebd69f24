//! Blocks, instances of statements for all values, induction, existence and extrema.

use super::analysis::at_the_point;
use super::known::Known;
use super::names::{names_in, names_in_prop};
use super::order::Signs;
use super::statement::{compare, constraints, domain, expr, name, numeral, prop};
use super::substitution::Substitution;
use super::tree::{conjuncts, single};
use super::{Block, Checker, Reason, Refusal, key, rejected};
use crate::claim::syntax::*;
use std::collections::BTreeSet;

/// What a binding says of its names: of plain names their domain, of a family that its members lie in theirs.
pub fn domains(binding: &Binding) -> Vec<Prop> {
    let mut out = domain(binding);
    for (family, index) in &binding.names {
        out.extend(index.as_ref().and_then(|index| domain_of_members(binding, family, index)));
    }
    out
}

/// `for all` indices in the range of a family: its member lies in the domain; `None` where the domain is all reals.
fn domain_of_members(binding: &Binding, family: &Name, index: &Name) -> Option<Prop> {
    let member = expr(ExprKind::Apply(family.clone(), vec![name(&index.text)]));
    let mut facts = constraints(binding, &member);
    let body = match (facts.len(), facts.pop()) {
        (1, Some(only)) => only,
        (_, Some(last)) => {
            facts.push(last);
            prop(PropKind::And(facts))
        }
        (_, None) => return None,
    };
    let range = binding.indices.iter().map(|(from, to)| Constraint::Range(from.clone(), to.clone()));
    let over = Binding::of(index.clone(), true, range.collect());
    Some(prop(PropKind::ForAll(vec![over], Box::new(body))))
}

/// `P => Q`.
fn implies(p: &Prop, q: &Prop) -> Prop {
    prop(PropKind::Implies(Box::new(p.clone()), Box::new(q.clone())))
}

impl Checker {
    /// Rule `suppose`: opens a block for `P => Q`, in which P is the fact `Ls` (L the label of the step).
    ///
    /// Sound: P has a value wherever the facts outside are true, and inside it is true. `end` shows Q.
    pub(super) fn may_be_supposed(&mut self, goal: &Prop, known: &mut Known) -> Result<(), Refusal> {
        let PropKind::Implies(p, _) = &goal.kind else { return rejected(Reason::NotAnImplication) };
        self.prop_defined(p, known)
    }

    /// Rule `let`: opens a block for `for all x …: Q`, in which x is a new variable; what its domain says are the
    /// facts `Ld1`, `Ld2`, …
    ///
    /// Sound: nothing is known of x but its domain, whose bounds have values. The name is not in use, so no fact
    /// mentions x.
    pub(super) fn may_be_let(&mut self, goal: &Prop, known: &mut Known) -> Result<(), Refusal> {
        let PropKind::ForAll(bindings, _) = &goal.kind else { return rejected(Reason::NotForAll) };
        if bindings.iter().any(|b| b.names.iter().any(|n| n.1.is_some())) {
            return rejected(Reason::FamilyInBlock);
        }
        self.within(bindings, known, |_, _| Ok(()))
    }

    /// Opens the block of a `suppose` or `let` that is justified.
    pub(super) fn open(&mut self, label: &str, goal: &Prop) -> Result<(), Refusal> {
        let block =
            Block { label: label.to_string(), goal: goal.clone(), facts: self.facts.len(), scope: self.scope.len() };
        let mut facts = Vec::new();
        match &goal.kind {
            PropKind::Implies(p, _) => facts.push((format!("{label}s"), (**p).clone())),
            PropKind::ForAll(bindings, _) => {
                for binding in bindings {
                    self.declare_binding(binding)?;
                }
                let domains = bindings.iter().flat_map(domain).enumerate();
                facts.extend(domains.map(|(place, fact)| (format!("{label}d{}", place + 1), fact)));
            }
            _ => return rejected(Reason::NoBlock),
        }
        for (label, fact) in facts {
            if let Err(refusal) = self.know(&label, fact) {
                self.forget(block.facts, block.scope);
                return Err(refusal);
            }
        }
        self.blocks.push(block);
        Ok(())
    }

    /// `end`: closes a block by its conclusion; what the block shows is known outside.
    ///
    /// Sound: inside, Q was true and had a value at every point outside at which P is true (or for every x of the
    /// domain). That is what `P => Q` (or `for all x …: Q`) says. All other facts of the block are forgotten.
    pub(super) fn end(&mut self, conclusion: &str) -> Result<(), Refusal> {
        let Some(block) = self.blocks.last() else { return rejected(Reason::NoBlock) };
        let (PropKind::Implies(_, q) | PropKind::ForAll(_, q)) = &block.goal.kind else {
            return rejected(Reason::NoBlock);
        };
        let fact = self.fact(conclusion)?;
        if key::prop(&fact) != key::prop(q) {
            return rejected(Reason::OtherConclusion(conclusion.to_string()));
        }
        let Some(block) = self.blocks.pop() else { return rejected(Reason::NoBlock) };
        self.forget(block.facts, block.scope);
        self.know(&block.label, block.goal)
    }

    /// Whether a proposition is among these facts or a part of one, or a comparison that signs show.
    pub(super) fn holds(&mut self, p: &Prop, from: &[String], known: &mut Known) -> Result<(), Refusal> {
        let wanted = key::prop(p);
        for label in from {
            let fact = self.fact(label)?;
            if key::prop(&fact) == wanted || conjuncts(&fact).into_iter().any(|part| key::prop(part) == wanted) {
                return Ok(());
            }
        }
        match &p.kind {
            PropKind::And(list) => list.iter().try_for_each(|part| self.holds(part, from, known)),
            PropKind::Compare(sides, relations) => {
                self.prop_defined(p, known)?;
                for (pair, relation) in sides.windows(2).zip(relations) {
                    let [a, b] = pair else { continue };
                    let (a, b) = (self.fraction_with(a, known)?, self.fraction_with(b, known)?);
                    let difference = a.minus(&b, &self.work)?;
                    if !self.signs_as_read(&difference, known)?.within(Signs::of(*relation)) {
                        return rejected(Reason::Needs(p.clone()));
                    }
                }
                Ok(())
            }
            _ => rejected(Reason::Needs(p.clone())),
        }
    }

    /// Rule `instance`: the conclusion of a cited claim, or of a fact `for all`, with values put in for its variables;
    /// variables without one keep their names. Its domain and hypotheses, with the values put in, have to hold.
    ///
    /// Sound: the claim was shown for all values that satisfy them. The values have values, and nothing is captured. A
    /// family is replaced by one with the same domain; sequences must be the same here.
    pub(super) fn instance(
        &mut self,
        goal: &Prop,
        source: &str,
        with: &[(Name, Expr)],
        from: &[String],
        known: &mut Known,
    ) -> Result<(), Refusal> {
        let shown = if let Ok(fact) = self.fact(source) {
            let PropKind::ForAll(bindings, body) = &fact.kind else { return rejected(Reason::NotForAll) };
            let map = self.values(bindings, with, known)?;
            self.satisfied(&map, bindings, &[], from, known)?;
            map.prop(body)?
        } else {
            let cited = self.cited.clone();
            let Some(accepted) = cited.iter().find(|a| a.statement.name == source) else {
                return rejected(Reason::NoFact(source.to_string()));
            };
            let cited = &accepted.statement;
            if self.is_declared(PI) && !cited.declares(PI) && cited.names().contains(PI) {
                return rejected(Reason::Capture(PI.to_string()));
            }
            for u in &cited.sequences {
                let text = |s: &super::statement::Sequence| {
                    format!("{} {} {} {}", s.name, s.index, key::expr(&s.initial), key::expr(&s.step))
                };
                if !with.is_empty() || !self.statement.sequences.iter().any(|v| text(u) == text(v)) {
                    return rejected(Reason::OtherSequence(u.name.clone()));
                }
            }
            let map = self.values(&cited.bindings, with, known)?;
            self.satisfied(&map, &cited.bindings, &cited.assumptions, from, known)?;
            self.rests_on.insert(cited.name.clone());
            self.rests_on.extend(accepted.rests_on.iter().cloned());
            map.prop(&cited.goal)?
        };
        if key::prop(goal) == key::prop(&shown) { Ok(()) } else { rejected(Reason::ItSays(shown)) }
    }

    /// The values that are put in for the variables of bindings.
    fn values(
        &mut self,
        bindings: &[Binding],
        with: &[(Name, Expr)],
        known: &mut Known,
    ) -> Result<Substitution, Refusal> {
        let mut map = Substitution::default();
        let mut used = BTreeSet::new();
        for binding in bindings {
            for (variable, index) in &binding.names {
                let given = with.iter().find(|w| w.0.text == variable.text).map(|w| w.1.clone());
                used.extend(given.as_ref().map(|_| variable.text.clone()));
                let value = given.unwrap_or_else(|| name(&variable.text));
                if index.is_some() {
                    let ExprKind::Name(other) = &value.kind else { return rejected(Reason::FamilyForFamily) };
                    self.same_domain(binding, other)?;
                    map.rename_family(&variable.text, other);
                } else {
                    self.defined(&value, known)?;
                    let f = self.fraction(&value)?;
                    if binding.natural {
                        self.whole_by_form(&value)?;
                        if !self.signs_of(&f, known)?.within(Signs::NOT_NEGATIVE) {
                            return rejected(Reason::NoValue { part: value, signs: Signs::NOT_NEGATIVE });
                        }
                    }
                    map.replace(&variable.text, &value);
                }
            }
        }
        if with.iter().any(|w| !used.contains(&w.0.text)) || used.len() != with.len() {
            return rejected(Reason::ValueForNoVariable);
        }
        Ok(map)
    }

    /// Whether the values lie in the domain and satisfy the hypotheses.
    fn satisfied(
        &mut self,
        map: &Substitution,
        bindings: &[Binding],
        assumptions: &[Prop],
        from: &[String],
        known: &mut Known,
    ) -> Result<(), Refusal> {
        for needed in bindings.iter().flat_map(domain).chain(assumptions.iter().cloned()) {
            let needed = map.prop(&needed)?;
            self.holds(&needed, from, known)?;
        }
        Ok(())
    }

    /// Whether a family here has the domain of a cited one, by bounds that are numerals.
    fn same_domain(&mut self, binding: &Binding, other: &str) -> Result<(), Refusal> {
        let Some(here) = self.family(other) else { return rejected(Reason::FamilyForFamily) };
        let text = |b: &Binding| -> Vec<String> { constraints(b, &name("member")).iter().map(key::prop).collect() };
        let mut names = BTreeSet::new();
        constraints(binding, &numeral(0)).iter().for_each(|p| names_in_prop(p, &mut names));
        let plain = names.is_empty() && binding.indices.is_none() && here.indices.is_none();
        if !plain || text(here) != text(binding) || here.natural != binding.natural {
            return rejected(Reason::OtherDomain(other.to_string()));
        }
        // The step does not cite it: the declaration is compared with that of the claim.
        let own = here.names.iter().find(|n| n.0.text == other).and_then(|(family, index)| {
            let domain = key::prop(&domain_of_members(here, family, index.as_ref()?)?);
            self.facts.iter().find(|fact| key::prop(&fact.prop) == domain).map(|fact| fact.label.clone())
        });
        self.assumed.extend(own);
        Ok(())
    }

    /// Rule `induction`: `for all n natural: P` from P at 0 and `for all n natural: P => P at n + 1`; with
    /// `n natural >= b` in both, from P at the numeral b.
    ///
    /// Sound: induction on n from b. Families and sequences do not depend on n, for they are declared outside.
    pub(super) fn induction(&mut self, goal: &Prop, base: &str, advance: &str) -> Result<(), Refusal> {
        let PropKind::ForAll(bindings, body) = &goal.kind else { return rejected(Reason::NotForAll) };
        let [binding] = bindings.as_slice() else { return rejected(Reason::InductionDomain) };
        let ([(variable, None)], true, None) = (binding.names.as_slice(), binding.natural, &binding.indices) else {
            return rejected(Reason::InductionDomain);
        };
        if self.is_declared(&variable.text) {
            return rejected(Reason::NameInUse(variable.text.clone()));
        }
        let first = match binding.constraints.as_slice() {
            [] => numeral(0),
            [Constraint::Relation(Relation::GreaterEqual, bound @ Expr { kind: ExprKind::Number(text), .. })]
                if text.bytes().all(|b| b.is_ascii_digit()) =>
            {
                bound.clone()
            }
            _ => return rejected(Reason::InductionDomain),
        };
        let at = |value: &Expr| -> Result<Prop, Refusal> {
            let mut map = Substitution::default();
            map.replace(&variable.text, value);
            Ok(map.prop(body)?)
        };
        let next = expr(ExprKind::Sum(vec![(Sign::Plus, name(&variable.text)), (Sign::Plus, numeral(1))]));
        let whole = prop(PropKind::ForAll(bindings.clone(), Box::new(implies(body, &at(&next)?))));
        for (label, expected) in [(base, at(&first)?), (advance, whole)] {
            if key::prop(&*self.fact(label)?) != key::prop(&expected) {
                return rejected(Reason::Needs(expected));
            }
        }
        Ok(())
    }

    /// Rule `existence`: Q, in which no x occurs, from `exists x …: P` and `for all x …: P => Q` with the same domains.
    ///
    /// Sound: P => Q holds for an x that has P, so Q holds; it says the same for every x.
    pub(super) fn existence(&mut self, goal: &Prop, some: &str, all: &str) -> Result<(), Refusal> {
        let all = self.fact(all)?;
        let PropKind::ForAll(bindings, body) = &all.kind else { return rejected(Reason::NotForAll) };
        let PropKind::Implies(property, conclusion) = &body.kind else { return rejected(Reason::NotAnImplication) };
        let mut names = BTreeSet::new();
        names_in_prop(goal, &mut names);
        for (name, index) in bindings.iter().flat_map(|b| &b.names) {
            if index.is_some() {
                return rejected(Reason::FamilyInBlock);
            }
            if names.contains(&name.text) {
                return rejected(Reason::NameInUse(name.text.clone()));
            }
        }
        let exists = prop(PropKind::Exists(bindings.clone(), property.clone()));
        if key::prop(conclusion) != key::prop(goal) {
            return rejected(Reason::Needs((**conclusion).clone()));
        }
        if key::prop(&*self.fact(some)?) != key::prop(&exists) {
            return rejected(Reason::Needs(exists));
        }
        Ok(())
    }

    /// Rule `witness`: `exists x …: P` from values for x that lie in the domain and have the property.
    ///
    /// Sound: the values are such.
    pub(super) fn witness(
        &mut self,
        goal: &Prop,
        with: &[(Name, Expr)],
        from: &[String],
        known: &mut Known,
    ) -> Result<(), Refusal> {
        let PropKind::Exists(bindings, body) = &goal.kind else { return rejected(Reason::NotExists) };
        if bindings.iter().any(|b| b.names.iter().any(|n| n.1.is_some())) {
            return rejected(Reason::FamilyInBlock);
        }
        if with.len() != bindings.iter().map(|b| b.names.len()).sum::<usize>() {
            return rejected(Reason::ValueForNoVariable);
        }
        let map = self.values(bindings, with, known)?;
        self.satisfied(&map, bindings, &[], from, known)?;
        let property = map.prop(body)?;
        self.holds(&property, from, known)
    }

    /// Rule `extremum`: from the domain at the point, the value there, and `for all x …: F <= value` (>= for a
    /// minimum); with `only`, also `for all x …: F = value => x = A` (`and y = B` …).
    ///
    /// Sound: that is the definition of a global extremum that is attained.
    pub(super) fn extremum(&mut self, goal: &Prop, from: &[String], known: &mut Known) -> Result<(), Refusal> {
        let PropKind::Extremum(e) = &goal.kind else { return rejected(Reason::NotAnExtremum) };
        let mut at = Substitution::default();
        let names: BTreeSet<&str> = e.at.iter().map(|a| a.0.text.as_str()).collect();
        for (variable, value) in &e.at {
            self.number_defined(value, known)?;
            at.replace(&variable.text, value);
        }
        for binding in &e.over {
            if binding.natural || binding.names.iter().any(|n| n.1.is_some() || !names.contains(n.0.text.as_str())) {
                return rejected(Reason::ExtremumDomain);
            }
        }
        let mut free = BTreeSet::new();
        names_in(&e.value, &mut free);
        e.at.iter().for_each(|a| names_in(&a.1, &mut free));
        if names.len() != e.over.iter().map(|b| b.names.len()).sum::<usize>()
            || names.len() != e.at.len()
            || names.iter().any(|n| free.contains(*n))
        {
            return rejected(Reason::ExtremumDomain);
        }
        for fact in e.over.iter().flat_map(domain) {
            let fact = at.prop(&fact)?;
            self.holds(&fact, from, known)?;
        }
        let there = compare(at.expr(&e.of)?, Relation::Equal, e.value.clone());
        self.holds(&there, from, known)?;
        let every = |body: Prop| prop(PropKind::ForAll(e.over.clone(), Box::new(body)));
        let relation = if e.maximum { Relation::LessEqual } else { Relation::GreaterEqual };
        self.holds(&every(compare(e.of.clone(), relation, e.value.clone())), from, known)?;
        if e.unique {
            let Some(point) = at_the_point(e) else { return rejected(Reason::ExtremumDomain) };
            let equal = compare(e.of.clone(), Relation::Equal, e.value.clone());
            self.holds(&every(implies(&equal, &point)), from, known)?;
        }
        Ok(())
    }

    /// Refuses a statement in which a variable that grows without bound is tied to something: it has to be declared
    /// by the claim, with lower bounds by numerals at most, and no family or sequence may depend on it.
    pub(super) fn moving_variables_are_free(&self) -> Result<(), Refusal> {
        let mut moving = BTreeSet::new();
        let statement = &self.statement;
        statement.assumptions.iter().chain([&statement.goal]).for_each(|p| limit_variables(p, &mut moving));
        for variable in moving {
            let tied = || Refusal::Rejected(Reason::Tied(variable.clone()));
            if !self.scope.iter().any(|v| v.name == variable) {
                return rejected(Reason::Undeclared(variable));
            }
            if self.is_tied_by_sequence(&variable) {
                return Err(tied());
            }
            for p in statement.bindings.iter().flat_map(domains).chain(statement.assumptions.iter().cloned()) {
                let mut names = BTreeSet::new();
                names_in_prop(&p, &mut names);
                let lower = match single(&p) {
                    Ok((left, Relation::Greater | Relation::GreaterEqual, right)) => {
                        matches!(&left.kind, ExprKind::Name(n) if *n == variable)
                            && matches!(right.kind, ExprKind::Number(_))
                    }
                    _ => false,
                };
                if names.contains(&variable) && !lower {
                    return Err(tied());
                }
            }
        }
        Ok(())
    }

    /// Whether the members of a sequence depend on a variable.
    pub(super) fn is_tied_by_sequence(&self, variable: &str) -> bool {
        self.statement.sequences.iter().any(|u| {
            let mut names = BTreeSet::new();
            names_in(&u.step, &mut names);
            names.remove(&u.index);
            names_in(&u.initial, &mut names);
            names.contains(variable)
        })
    }
}

/// The variables of the limits in a proposition.
fn limit_variables(p: &Prop, out: &mut BTreeSet<String>) {
    match &p.kind {
        PropKind::Limit(l) => {
            out.insert(l.variable.text.clone());
        }
        PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => {
            list.iter().for_each(|p| limit_variables(p, out));
        }
        PropKind::Not(a) | PropKind::Exists(_, a) | PropKind::ForAll(_, a) => limit_variables(a, out),
        PropKind::Implies(a, b) => {
            limit_variables(a, out);
            limit_variables(b, out);
        }
        PropKind::Compare(..) | PropKind::Extremum(_) | PropKind::WrittenLimit(_) => {}
    }
}
