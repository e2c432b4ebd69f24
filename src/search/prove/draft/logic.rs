//! The rules of logic: blocks, connectives, quantifiers, instances, induction.

use super::step::Step;
use super::translate::{Atom, Value};
use super::{Block, Draft, Failure, rejected};
use crate::claim::syntax::*;
use crate::kernel::fraction::Fraction;
use crate::kernel::names::names_in_prop;
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, constraints, domain, expr, name, numeral, prop};
use crate::kernel::substitution::Substitution;
use crate::kernel::{Accepted, text};
use std::collections::BTreeSet;

impl Draft {
    /// Rule `suppose`: opens a block for `P => Q`, in which P is a fact; its end shows `P => Q`.
    ///
    /// Sound: P has a value wherever the facts outside hold, as `end` says of Q where P holds as well.
    pub(super) fn suppose(&mut self, step: &Step) -> Result<(), Failure> {
        let goal = Self::shown(step)?;
        let PropKind::Implies(p, _) = &goal.kind else { return rejected("an implication is needed") };
        self.has_values(p)?;
        self.open(step, goal.clone());
        self.know(&format!("{}s", step.label), (**p).clone())
    }

    /// Rule `let`: opens a block for `for all x …: Q`, in which x is a new variable of that domain.
    ///
    /// Sound: nothing is known of x but its domain, whose bounds have values; no name in use is taken,
    /// so no fact mentions x.
    pub(super) fn let_values(&mut self, step: &Step) -> Result<(), Failure> {
        let goal = Self::shown(step)?;
        let PropKind::ForAll(bindings, _) = &goal.kind else { return rejected("`for all …` is needed") };
        if bindings.iter().any(|b| b.names.iter().any(|n| n.1.is_some())) {
            return rejected("a block has no families of its own");
        }
        self.open(step, goal.clone());
        for binding in bindings {
            self.declare(binding, self.now)?;
        }
        for (place, fact) in bindings.iter().flat_map(domain).enumerate() {
            self.has_values(&fact)?;
            self.know(&format!("{}d{}", step.label, place + 1), fact)?;
        }
        Ok(())
    }

    fn open(&mut self, step: &Step, goal: Prop) {
        self.blocks.push(Block { label: step.label.clone(), goal, kept: self.sizes(), source: self.now });
    }

    /// Rule `end`: closes a block whose conclusion is a fact; what it shows is known outside.
    ///
    /// Sound: inside, Q held at every point outside at which P holds (or for every x of the domain),
    /// which is what the implication (or `for all`) says. All other facts, signs, powers and
    /// replacements of the block are forgotten.
    pub(super) fn end(&mut self) -> Result<(), Failure> {
        let Some(block) = self.blocks.last() else { return rejected("no block is open") };
        match &block.goal.kind {
            PropKind::Implies(_, q) | PropKind::ForAll(_, q) => self.need(q)?,
            _ => return rejected("no block is open"),
        }
        let Some(block) = self.blocks.pop() else { return rejected("no block is open") };
        self.consult(block.source);
        self.forget(block.kept);
        self.know(&block.label, block.goal)
    }

    /// Whether every expression of a proposition has a value here; what stands behind `=>` may suppose
    /// what stands before it only in a block, and quantified statements are not followed.
    fn has_values(&mut self, p: &Prop) -> Result<(), Failure> {
        match &p.kind {
            PropKind::Compare(sides, relations) => {
                // Numbers, or matrices of one size, which have no order.
                let mut sizes = BTreeSet::new();
                for e in sides {
                    sizes.insert(match self.value(e, crate::kernel::substitution::DEPTH_LIMIT)? {
                        Value::Scalar(_) => Vec::new(),
                        Value::Matrix(rows) => rows.iter().map(Vec::len).collect(),
                    });
                }
                let ordered = relations.iter().any(|r| !matches!(r, Relation::Equal | Relation::NotEqual));
                if sizes.len() != 1 || (ordered && !sizes.contains(&Vec::new())) {
                    return rejected("matrices are compared with matrices of their size, by `=` or `!=`");
                }
                Ok(())
            }
            PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => {
                list.iter().try_for_each(|p| self.has_values(p))
            }
            PropKind::Not(inner) => self.has_values(inner),
            PropKind::Implies(a, b) => {
                self.has_values(a)?;
                self.has_values(b)
            }
            _ if self.knows(p) => Ok(()),
            _ => rejected("a quantified statement is supposed, which the kernel does not follow"),
        }
    }

    /// Rule `all`: `P and Q` from P and Q, or `a < b < c` from `a < b` and `b < c`.
    ///
    /// Sound: that is what they mean.
    pub(super) fn all(&mut self, step: &Step) -> Result<(), Failure> {
        let goal = Self::shown(step)?;
        for part in parts(goal)? {
            self.need(&part)?;
        }
        self.know(&step.label, goal.clone())
    }

    /// Rule `part`: P from `P and Q`, or `a < b` from `a < b < c`.
    ///
    /// Sound: that is what they mean.
    pub(super) fn part(&mut self, step: &Step) -> Result<(), Failure> {
        let goal = Self::shown(step)?;
        let whole = self.cited_fact(step)?;
        let key = text::prop(goal);
        if parts(&whole)?.iter().any(|p| text::prop(p) == key) {
            return self.know(&step.label, goal.clone());
        }
        rejected("this is not a part of the fact")
    }

    /// Rule `either`: `P or Q` from P.
    ///
    /// Sound: one part holds, and the others have values.
    pub(super) fn either(&mut self, step: &Step) -> Result<(), Failure> {
        let goal = Self::shown(step)?;
        let PropKind::Or(list) = &goal.kind else { return rejected("a disjunction is needed") };
        if !list.iter().any(|p| self.knows(p)) {
            return rejected("no part of the disjunction is known");
        }
        self.has_values(goal)?;
        self.know(&step.label, goal.clone())
    }

    /// Rule `excluded`: `P or Q` where Q is the negation of P, or where P, Q, … are comparisons of the
    /// same two expressions that leave out none of <, = and >.
    ///
    /// Sound: all parts have values; the order of the reals is total.
    pub(super) fn excluded(&mut self, step: &Step) -> Result<(), Failure> {
        let goal = Self::shown(step)?;
        let PropKind::Or(list) = &goal.kind else { return rejected("a disjunction is needed") };
        self.has_values(goal)?;
        let opposite = match list.as_slice() {
            [p, q] => match negation(p) {
                Some(n) => text::prop(&n) == text::prop(q),
                None => false,
            },
            _ => false,
        };
        let mut covered = 0;
        let mut sides_key = None;
        for part in list {
            let PropKind::Compare(sides, relations) = &part.kind else { continue };
            let ([a, b], [relation]) = (sides.as_slice(), relations.as_slice()) else { continue };
            let key = (text::expr(a), text::expr(b));
            if *sides_key.get_or_insert_with(|| key.clone()) == key {
                covered |= [Relation::Less, Relation::Equal, Relation::Greater]
                    .into_iter()
                    .enumerate()
                    .filter(|(_, r)| Signs::of(*r).within(Signs::of(*relation)))
                    .fold(0, |all, (place, _)| all | 1 << place);
            }
        }
        if opposite || covered == 7 {
            return self.know(&step.label, goal.clone());
        }
        rejected("the parts may all be false")
    }

    /// Rule `cases`: G from `P or Q`, `P => G` and `Q => G`.
    ///
    /// Sound: one of the cases holds, and each implies G with a value.
    pub(super) fn cases(&mut self, step: &Step) -> Result<(), Failure> {
        let goal = Self::shown(step)?;
        let fact = self.cited_fact(step)?;
        let PropKind::Or(list) = &fact.kind else { return rejected("a disjunction is needed") };
        for case in list {
            self.need(&implies(case, goal))?;
        }
        self.know(&step.label, goal.clone())
    }

    /// Rule `apply`: Q from `P => Q` and P; also from an equivalence with P and Q among its parts.
    ///
    /// Sound: modus ponens.
    pub(super) fn apply(&mut self, step: &Step) -> Result<(), Failure> {
        let goal = Self::shown(step)?;
        let fact = self.cited_fact(step)?;
        let key = text::prop(goal);
        let applies = match &fact.kind {
            PropKind::Implies(p, q) => text::prop(q) == key && self.knows(p),
            PropKind::Equivalent(list) => {
                list.iter().any(|p| text::prop(p) == key) && list.iter().any(|p| self.knows(p))
            }
            _ => return rejected("an implication or equivalence is needed"),
        };
        if applies { self.know(&step.label, goal.clone()) } else { rejected("the premise is not known") }
    }

    /// Rule `equivalent`: `P <=> Q <=> …` from the implications between neighbours, both ways.
    ///
    /// Sound: neighbours are true at the same points, hence all are; each was shown to have a value
    /// where it was supposed.
    pub(super) fn equivalent(&mut self, step: &Step) -> Result<(), Failure> {
        let goal = Self::shown(step)?;
        let PropKind::Equivalent(list) = &goal.kind else { return rejected("an equivalence is needed") };
        for pair in list.windows(2) {
            if let [p, q] = pair {
                self.need(&implies(p, q))?;
                self.need(&implies(q, p))?;
            }
        }
        self.know(&step.label, goal.clone())
    }

    /// Rule `negation`: a fact with its negations moved inwards, or outwards.
    ///
    /// Sound: `not a < b` is `a >= b`, and De Morgan's laws.
    pub(super) fn negation(&mut self, step: &Step) -> Result<(), Failure> {
        let goal = Self::shown(step)?;
        let fact = self.cited_fact(step)?;
        match (inward(goal), inward(&fact)) {
            (Some(p), Some(q)) if text::prop(&p) == text::prop(&q) => self.know(&step.label, goal.clone()),
            _ => rejected("this is not the fact with its negations moved"),
        }
    }

    /// Rule `absurd`: anything, from a fact that compares two numbers and is false.
    ///
    /// Sound: no point satisfies the suppositions, so all is true at all of them.
    pub(super) fn absurd(&mut self, step: &Step) -> Result<(), Failure> {
        let goal = Self::shown(step)?;
        let fact = self.cited_fact(step)?;
        let (difference, relation) = self.difference(&fact)?;
        match difference.as_number() {
            Some(number) if !Signs::of_number(number).within(Signs::of(relation)) => {
                self.know(&step.label, goal.clone())
            }
            _ => rejected("the fact is not a false comparison of numbers"),
        }
    }

    /// Rule `instance`: the conclusion of a cited claim, or of a fact `for all`, with values put in for
    /// its variables; variables without one keep their names. Its domain and hypotheses, with the
    /// values put in, must be facts.
    ///
    /// Sound: the claim was shown for all values that satisfy them; the values exist, and nothing is
    /// captured. A family is replaced by one with the same domain; sequences must be the same here.
    pub(super) fn instance(&mut self, step: &Step) -> Result<(), Failure> {
        let goal = Self::shown(step)?;
        let source = step.from.first().map_or("", String::as_str);
        if let Ok(fact) = self.fact(source) {
            let PropKind::ForAll(bindings, body) = &fact.kind else { return rejected("a fact `for all` is needed") };
            let shown = self.instantiate(step, bindings, &[], body, None)?;
            return self.conclude(step, goal, &shown);
        }
        let cited = self.cited.clone();
        let Some(accepted) = cited.iter().find(|a| a.statement().name == source) else {
            return rejected(&format!("no fact and no accepted claim under `using` is called {source}"));
        };
        let s = &accepted.statement();
        let shown = self.instantiate(step, &s.bindings, &s.assumptions, &s.goal, Some(accepted))?;
        self.conclude(step, goal, &shown)?;
        Ok(())
    }

    fn conclude(&mut self, step: &Step, goal: &Prop, shown: &Prop) -> Result<(), Failure> {
        if text::prop(goal) == text::prop(shown) {
            return self.know(&step.label, goal.clone());
        }
        rejected(&format!("with these values it says {}", text::prop(shown)))
    }

    fn instantiate(
        &mut self,
        step: &Step,
        bindings: &[Binding],
        assumptions: &[Prop],
        conclusion: &Prop,
        cited: Option<&Accepted>,
    ) -> Result<Prop, Failure> {
        let mut map = Substitution::default();
        let mut used = BTreeSet::new();
        for binding in bindings {
            for (variable, index) in &binding.names {
                let given = step.with.iter().find(|w| w.0.text == variable.text).map(|w| w.1.clone());
                used.extend(given.as_ref().map(|_| variable.text.clone()));
                let value = given.unwrap_or_else(|| name(&variable.text));
                if index.is_some() {
                    let ExprKind::Name(other) = &value.kind else { return rejected("a family is put for a family") };
                    self.same_domain(binding, other)?;
                    map.rename_family(&variable.text, other);
                } else {
                    if binding.natural {
                        self.natural_by_form(&value)?;
                    } else {
                        self.scalar(&value)?;
                    }
                    map.replace(&variable.text, &value);
                }
            }
        }
        if step.with.iter().any(|w| !used.contains(&w.0.text)) || used.len() != step.with.len() {
            return rejected("a value for a name that is no variable, or two for one");
        }
        if let Some(accepted) = cited {
            for u in &accepted.statement().sequences {
                let same = self.statement.sequences.iter().any(|v| {
                    let key = |s: &crate::kernel::statement::Sequence| {
                        format!("{} {} {} {}", s.name, s.index, text::expr(&s.initial), text::expr(&s.step))
                    };
                    key(u) == key(v)
                });
                if !same || !step.with.is_empty() {
                    return rejected("a sequence of the cited claim is not the same here");
                }
            }
        }
        for needed in bindings.iter().flat_map(domain).chain(assumptions.iter().cloned()) {
            let needed = map.prop(&needed)?;
            self.need(&needed)?;
        }
        Ok(map.prop(conclusion)?)
    }

    /// Whether a family here has the domain of a cited one, word for word.
    fn same_domain(&self, binding: &Binding, other: &str) -> Result<(), Failure> {
        let Some(family) = self.family(other) else { return rejected(&format!("{other} is not a family here")) };
        let here = family.binding;
        self.consult(family.source);
        let key = |b: &Binding| -> Vec<String> { constraints(b, &name("member")).iter().map(text::prop).collect() };
        let mut names = BTreeSet::new();
        constraints(binding, &numeral(0)).iter().for_each(|p| names_in_prop(p, &mut names));
        let plain = names.is_empty() && binding.indices.is_none() && here.indices.is_none();
        if plain && key(here) == key(binding) && here.natural == binding.natural {
            return Ok(());
        }
        rejected("the families have different domains")
    }

    /// Rule `induction`: `for all n natural: P` from P at 0 and `for all n natural: P => P at n + 1`;
    /// with `n natural >= b` in both, from P at the numeral b.
    ///
    /// Sound: induction on n from b. The family of the statements P is one: P mentions n as a
    /// variable, and families and sequences do not depend on it, for they are declared outside.
    pub(super) fn induction(&mut self, step: &Step) -> Result<(), Failure> {
        let goal = Self::shown(step)?;
        let PropKind::ForAll(bindings, body) = &goal.kind else { return rejected("`for all n natural` is needed") };
        let [binding] = bindings.as_slice() else { return rejected("induction is on one variable") };
        let ([(variable, None)], true, None) = (binding.names.as_slice(), binding.natural, &binding.indices) else {
            return rejected("induction is on one natural variable");
        };
        if self.is_declared(&variable.text) {
            return rejected(&format!("the name {} is in use", variable.text));
        }
        let base = match binding.constraints.as_slice() {
            [] => numeral(0),
            [Constraint::Relation(Relation::GreaterEqual, bound)] => {
                let f = self.scalar(bound)?;
                if f.as_integer().is_none_or(|k| k < 0) || !matches!(bound.kind, ExprKind::Number(_)) {
                    return rejected("induction begins at a numeral");
                }
                bound.clone()
            }
            _ => return rejected("the domain of the induction is `natural` or `natural >= b`"),
        };
        let at = |value: &Expr| -> Result<Prop, Failure> {
            let mut map = Substitution::default();
            map.replace(&variable.text, value);
            Ok(map.prop(body)?)
        };
        self.need(&at(&base)?)?;
        let next = expr(ExprKind::Sum(vec![(Sign::Plus, name(&variable.text)), (Sign::Plus, numeral(1))]));
        let advance = implies(body, &at(&next)?);
        self.need(&prop(PropKind::ForAll(bindings.clone(), Box::new(advance))))?;
        self.know(&step.label, goal.clone())
    }

    /// Rule `witness`: `exists x …: P` from the domain and P with values put in for x.
    ///
    /// Sound: the values are such.
    pub(super) fn witness(&mut self, step: &Step) -> Result<(), Failure> {
        let goal = Self::shown(step)?;
        let PropKind::Exists(bindings, body) = &goal.kind else { return rejected("`exists` is needed") };
        if bindings.iter().any(|b| b.names.iter().any(|n| n.1.is_some())) {
            return rejected("a family has no witness");
        }
        if step.with.len() != bindings.iter().map(|b| b.names.len()).sum::<usize>() {
            return rejected("a witness has a value for each variable");
        }
        let shown = self.instantiate(step, bindings, &[], body, None)?;
        self.need(&shown)?;
        self.know(&step.label, goal.clone())
    }

    /// Whether a fraction is free of a variable, at any depth. Each atom is looked at once.
    pub(crate) fn is_free_of(&self, f: &Fraction, variable: &str) -> Result<bool, Failure> {
        let mut open: Vec<usize> = f.atoms().collect();
        let mut seen = BTreeSet::new();
        while let Some(place) = open.pop() {
            if !seen.insert(place) {
                continue;
            }
            let before = open.len();
            match self.atom(place) {
                Some(Atom::Variable(name)) if name == variable => return Ok(false),
                None => return Ok(false),
                Some(Atom::Variable(_) | Atom::Bound(_)) => {}
                Some(Atom::Member(_, inner) | Atom::Logarithm(inner)) => open.extend(inner.atoms()),
                Some(Atom::Over(_, _, from, to, body)) => {
                    open.extend(from.atoms().chain(to.atoms()).chain(body.atoms()));
                }
                Some(Atom::Exponential(inner)) => open.extend(inner.atoms()),
            }
            self.work.count(1 + open.len() - before)?;
        }
        Ok(true)
    }
}

/// `P => Q`.
fn implies(p: &Prop, q: &Prop) -> Prop {
    prop(PropKind::Implies(Box::new(p.clone()), Box::new(q.clone())))
}

/// The parts of a conjunction or chain.
fn parts(p: &Prop) -> Result<Vec<Prop>, Failure> {
    match &p.kind {
        PropKind::And(list) => Ok(list.clone()),
        PropKind::Compare(sides, relations) if relations.len() > 1 => Ok(sides
            .windows(2)
            .zip(relations)
            .filter_map(|(pair, r)| match pair {
                [a, b] => Some(compare(a.clone(), *r, b.clone())),
                _ => None,
            })
            .collect()),
        _ => rejected("a conjunction or a chain of comparisons is needed"),
    }
}

/// The negation of a comparison, conjunction, disjunction or negation, moved inwards.
pub(crate) fn negation(p: &Prop) -> Option<Prop> {
    Some(match &p.kind {
        PropKind::Compare(sides, relations) => match (sides.as_slice(), relations.as_slice()) {
            ([a, b], [relation]) => compare(a.clone(), relation.negated(), b.clone()),
            _ => return None,
        },
        PropKind::And(list) => prop(PropKind::Or(list.iter().map(negation).collect::<Option<_>>()?)),
        PropKind::Or(list) => prop(PropKind::And(list.iter().map(negation).collect::<Option<_>>()?)),
        PropKind::Not(inner) => inward(inner)?,
        _ => return None,
    })
}

/// A proposition with its negations moved inwards.
pub(crate) fn inward(p: &Prop) -> Option<Prop> {
    Some(match &p.kind {
        PropKind::Compare(..) => p.clone(),
        PropKind::And(list) => prop(PropKind::And(list.iter().map(inward).collect::<Option<_>>()?)),
        PropKind::Or(list) => prop(PropKind::Or(list.iter().map(inward).collect::<Option<_>>()?)),
        PropKind::Not(inner) => negation(inner)?,
        _ => return None,
    })
}
