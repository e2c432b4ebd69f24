//! Goals: how a proposition is shown from what is known.
//!
//! Contract: [`Engine::show_goal`] returns `Ok` only if the proposition holds, and every expression in
//! it has a value, at every point that the context allows. Each function here is one rule; what the
//! claim's own argument suggests is only a choice among the rules.

use super::assume::negation;
use super::comparison::{Plain, Reduced};
use super::context::*;
use super::sign::SEARCHED_DEGREE;
use super::translate::{Condition, Value, text_of};
use crate::algebra::form::Form;
use crate::algebra::{Polynomial, Var};
use crate::claim::print;
use crate::claim::syntax::*;

type Result<T> = std::result::Result<T, Failure>;

/// How often cases may be split within one another without being asked for.
const SPLITS: usize = 4;

impl Engine<'_> {
    /// Shows a goal with an argument.
    pub fn follow(&mut self, cx: &mut Context, goal: &Prop, proof: &Proof) -> Result<()> {
        self.tick()?;
        let mut at = 0;
        while at < proof.steps.len() {
            match &proof.steps[at] {
                Step::Have { label, prop, proof } => {
                    let mut inner = cx.clone();
                    self.line("auxiliary", format!("{}: {}", label.text, print::prop(prop)));
                    self.deeper(|engine| engine.follow(&mut inner, prop, proof))?;
                    self.assume(cx, prop, Some(label.text.clone()), Origin::Derived)?;
                    at += 1;
                }
                Step::Obtain { binding, label, prop, witness } => {
                    self.obtain(cx, binding, label, prop, witness)?;
                    at += 1;
                }
                Step::Case { .. } => return self.cases(cx, goal, &proof.steps[at..]),
            }
        }
        match &proof.close {
            None => self.show_goal(cx, goal),
            Some(method) => self.by_method(cx, goal, method),
        }
    }

    fn cases(&mut self, cx: &mut Context, goal: &Prop, steps: &[Step]) -> Result<()> {
        let mut props = Vec::new();
        for step in steps {
            match step {
                Step::Case { prop, .. } => props.push(prop.clone()),
                _ => return Err(Failure::NotShown("a step after cases: cases come last in a block".to_string())),
            }
        }
        let all = Prop { kind: PropKind::Or(props), span: goal.span };
        self.line("cases", format!("one of the cases holds: {}", print::prop(&all)));
        let mut inner = cx.clone();
        self.deeper(|engine| engine.show_goal(&mut inner, &all))?;
        for step in steps {
            let Step::Case { label, prop, proof } = step else { continue };
            self.line("case", format!("{}: {}", label.text, print::prop(prop)));
            let mut inner = cx.clone();
            self.deeper(|engine| {
                engine.assume(&mut inner, prop, Some(label.text.clone()), Origin::Hypothesis)?;
                engine.follow(&mut inner, goal, proof)
            })?;
        }
        Ok(())
    }

    fn obtain(&mut self, cx: &mut Context, binding: &Binding, label: &Name, prop: &Prop, witness: &Expr) -> Result<()> {
        let Some((name, _)) = binding.names.first() else { return Ok(()) };
        if binding.natural {
            return Err(Failure::NotShown("`obtain` names real values".to_string()));
        }
        self.line("obtain", format!("{} = {} with {}", name.text, text_of(witness), print::prop(prop)));
        let mut map = super::expand::Substitution::default();
        map.replace(&name.text, witness.clone());
        self.deeper(|engine| {
            for fact in super::assume::domain(binding).iter().chain([prop]) {
                let fact = map.prop(fact)?;
                engine.show_goal(&mut cx.clone(), &fact)?;
            }
            Ok::<(), Failure>(())
        })?;
        self.declare(cx, std::slice::from_ref(binding))?;
        cx.obtained.push(name.text.clone());
        self.assume(cx, prop, Some(label.text.clone()), Origin::Derived)
    }

    /// Declares variables of a goal, whose bounds must have values.
    pub fn declare_valued(&mut self, cx: &mut Context, bindings: &[Binding]) -> Result<()> {
        for binding in bindings {
            self.bounds_valued(cx, binding)?;
            self.declare(cx, std::slice::from_ref(binding))?;
        }
        Ok(())
    }

    /// Shows a goal by the automatic methods.
    pub fn show_goal(&mut self, cx: &mut Context, goal: &Prop) -> Result<()> {
        self.tick()?;
        if let Some(sources) = cx.contradiction {
            self.used |= sources;
            self.line("contradiction", "the hypotheses of this case exclude each other".to_string());
            return Ok(());
        }
        match &goal.kind {
            PropKind::Compare(sides, relations) => {
                for (pair, relation) in sides.windows(2).zip(relations) {
                    let single = Prop { kind: PropKind::Compare(pair.to_vec(), vec![*relation]), span: goal.span };
                    self.comparison(cx, &pair[0], *relation, &pair[1], &single)?;
                }
                Ok(())
            }
            PropKind::And(list) => list.iter().try_for_each(|p| self.show_goal(cx, p)),
            PropKind::Or(list) => self.disjunction(cx, goal, list),
            PropKind::Not(inner) => {
                match &inner.kind {
                    // A value that fails is not enough: what is denied has to say something for all.
                    PropKind::ForAll(bindings, body) => {
                        let mut there = cx.clone();
                        self.declare_valued(&mut there, bindings)?;
                        self.defined(&mut there, body)?;
                    }
                    PropKind::Exists(_, body) if !quantifies(body) => {}
                    PropKind::Not(_) => {}
                    // Deeper inside it would have to be looked at as well.
                    _ if quantifies(inner) => return Err(not_shown(goal)),
                    _ => {}
                }
                match negation(inner) {
                    Some(prop) => self.show_goal(cx, &prop),
                    None => Err(not_shown(goal)),
                }
            }
            PropKind::Implies(p, q) => {
                self.line("implication", format!("suppose {}", print::prop(p)));
                self.defined(&mut cx.clone(), p)?;
                let mut inner = cx.clone();
                self.deeper(|engine| {
                    engine.assume(&mut inner, p, None, Origin::Hypothesis)?;
                    engine.show_goal(&mut inner, q)
                })
            }
            PropKind::Equivalent(list) => list.windows(2).try_for_each(|pair| self.equivalence(cx, &pair[0], &pair[1])),
            PropKind::ForAll(bindings, body) => {
                let mut inner = cx.clone();
                self.declare_valued(&mut inner, bindings)?;
                self.show_goal(&mut inner, body)
            }
            PropKind::Exists(bindings, body) => self.existence(cx, bindings, body),
            PropKind::Extremum(extremum) => self.extremum(cx, extremum, goal),
            PropKind::Limit(limit) => self.limit(cx, limit, goal),
        }
    }

    /// Shows that an expression has a value.
    pub fn show_conditions(&mut self, cx: &mut Context, conditions: Vec<Condition>) -> Result<()> {
        for condition in conditions {
            let signs = self.searched_form_signs(cx, &condition.form)?;
            if !signs.within(Signs::of(condition.relation)) {
                let what = match condition.relation {
                    Relation::NotEqual => format!("cannot show that {} is not 0", condition.text),
                    _ => format!("cannot show that {} has a value", condition.text),
                };
                return Err(Failure::Undefined(what));
            }
        }
        Ok(())
    }

    fn comparison(&mut self, cx: &mut Context, a: &Expr, relation: Relation, b: &Expr, goal: &Prop) -> Result<()> {
        let direct = self.attempt(|engine| engine.direct_comparison(cx, a, relation, b, goal));
        match direct {
            Err(Failure::NotShown(_)) | Err(Failure::Undefined(_)) => {}
            other => return other,
        }
        if self.saturate(cx)? {
            let again = self.attempt(|engine| engine.direct_comparison(cx, a, relation, b, goal));
            if !matches!(again, Err(Failure::NotShown(_))) {
                return again;
            }
        }
        if cx.contradiction.is_some() {
            return self.show_goal(cx, goal);
        }
        if let Some(chain) = self.transitive(cx, a, relation, b) {
            self.defined(cx, goal)?;
            self.line("transitivity", chain);
            return Ok(());
        }
        if cx.splits < SPLITS {
            // Suppose the opposite; if the facts then contradict each other the goal holds.
            let mut inner = cx.clone();
            inner.splits = SPLITS;
            let opposite = super::method::compare(a.clone(), super::comparison::negated(relation), b.clone());
            let supposed = self.attempt(|engine| {
                engine.defined(&mut inner.clone(), goal)?;
                engine.assume(&mut inner, &opposite, None, Origin::Hypothesis)?;
                match inner.contradiction {
                    Some(sources) => {
                        engine.used |= sources;
                        engine.line(
                            "contradiction",
                            format!("{}: its opposite contradicts the facts", print::prop(goal)),
                        );
                        Ok(())
                    }
                    None => Err(not_shown(goal)),
                }
            });
            if supposed.is_ok() {
                return supposed;
            }
        }
        if let Some(result) = self.split_on_fact(cx, goal) {
            return result;
        }
        // A fact about members of a family or all values of a variable is not searched.
        direct
    }

    /// The comparison of two values, straight from signs and equations.
    fn direct_comparison(
        &mut self,
        cx: &mut Context,
        a: &Expr,
        relation: Relation,
        b: &Expr,
        goal: &Prop,
    ) -> Result<()> {
        let mut conditions = Vec::new();
        let x = self.translate(cx, a, &mut conditions)?;
        let y = self.translate(cx, b, &mut conditions)?;
        self.show_conditions(cx, conditions)?;
        match (x, y) {
            (Value::Scalar(x), Value::Scalar(y)) => self.compare_forms(cx, &x, relation, &y, goal),
            (Value::Matrix(x), Value::Matrix(y)) => {
                if x.len() != y.len() || x[0].len() != y[0].len() {
                    return Err(super::translate::fault(goal.span, "the sizes of these matrices differ"));
                }
                let mut entries = x.iter().flatten().zip(y.iter().flatten());
                match relation {
                    Relation::Equal => entries.try_for_each(|(p, q)| self.compare_forms(cx, p, relation, q, goal)),
                    // They differ where one entry does.
                    Relation::NotEqual => {
                        let mut shown = |(p, q)| self.attempt(|e| e.compare_forms(cx, p, relation, q, goal)).is_ok();
                        if entries.any(&mut shown) { Ok(()) } else { Err(not_shown(goal)) }
                    }
                    _ => Err(super::translate::fault(goal.span, "matrices have no order: compare them by = or !=")),
                }
            }
            _ => Err(super::translate::fault(goal.span, "a matrix is compared with a number")),
        }
    }

    fn compare_forms(&mut self, cx: &mut Context, x: &Form, relation: Relation, y: &Form, goal: &Prop) -> Result<()> {
        let difference = self.difference(cx, x, y)?;
        let wanted = Signs::of(relation);
        if difference.is_zero() {
            if Signs::ZERO.within(wanted) {
                let rule = if cx.environment.is_empty() { "identity" } else { "elimination" };
                let form = self.show(x);
                self.line(rule, format!("{}: both sides are {form}", print::prop(goal)));
                return Ok(());
            }
            return Err(not_shown(goal));
        }
        let signs = self.signs(cx, &difference)?;
        if signs.within(wanted) {
            let form = self.show(&difference);
            self.line("sign", format!("{}: the difference has the sign of {form}", print::prop(goal)));
            return Ok(());
        }
        if matches!(relation, Relation::Equal) && self.vanishes(cx, &difference)? {
            self.line(
                "cofactors",
                format!("{}: the difference is a combination of the equations known", print::prop(goal)),
            );
            return Ok(());
        }
        // The very comparison may be known, as a product of factors of open sign.
        let reduced = normal(&self.reduced(cx, &difference, relation)?);
        if reduced == Reduced::Decided(true) {
            let form = self.show(&difference);
            self.line("sign", format!("{}: the difference has the sign of {form}", print::prop(goal)));
            return Ok(());
        }
        if let Reduced::Open(literal) = reduced {
            let known = cx
                .constraints
                .iter()
                .find(|(other, _)| normal(&Reduced::Open(other.clone())) == Reduced::Open(literal.clone()));
            if let Some((_, sources)) = known {
                self.used |= sources;
                self.line("known", format!("{}: equivalent to a fact", print::prop(goal)));
                return Ok(());
            }
        }
        let signs = self.searched_form_signs(cx, &difference)?;
        if signs.within(wanted) {
            let form = self.show(&difference);
            self.line("sign", format!("{}: the difference has the sign of {form}", print::prop(goal)));
            return Ok(());
        }
        Err(not_shown(goal))
    }

    /// A chain of facts a ≥ … ≥ b (or ≤, or =) with the very same expressions in between.
    fn transitive(&mut self, cx: &Context, a: &Expr, relation: Relation, b: &Expr) -> Option<String> {
        let (from, to, strict) = match relation {
            Relation::GreaterEqual => (a, b, false),
            Relation::Greater => (a, b, true),
            Relation::LessEqual => (b, a, false),
            Relation::Less => (b, a, true),
            _ => return None,
        };
        // Edges x ≥ y.
        let mut edges: Vec<(&Expr, &Expr, bool, usize)> = Vec::new();
        for (place, fact) in cx.facts.iter().enumerate() {
            let PropKind::Compare(sides, relations) = &fact.prop.kind else { continue };
            for (pair, relation) in sides.windows(2).zip(relations) {
                let strict = matches!(relation, Relation::Greater | Relation::Less);
                if matches!(relation, Relation::Greater | Relation::GreaterEqual | Relation::Equal) {
                    edges.push((&pair[0], &pair[1], strict, place));
                }
                if matches!(relation, Relation::Less | Relation::LessEqual | Relation::Equal) {
                    edges.push((&pair[1], &pair[0], strict, place));
                }
            }
        }
        // Paths by length; a path may pass a fact once.
        let mut paths: Vec<(&Expr, bool, Vec<usize>)> = vec![(from, false, Vec::new())];
        for _ in 0..5 {
            let mut next = Vec::new();
            for (at, strict_so_far, path) in &paths {
                for (x, y, edge_strict, place) in &edges {
                    if path.contains(place) || !x.same(at) {
                        continue;
                    }
                    let mut longer = path.clone();
                    longer.push(*place);
                    let is_strict = *strict_so_far || *edge_strict;
                    if y.same(to) && (is_strict || !strict) {
                        for place in &longer {
                            self.used |= source(*place);
                        }
                        let list: Vec<String> = longer.iter().map(|p| print::prop(&cx.facts[*p].prop)).collect();
                        return Some(list.join("; "));
                    }
                    next.push((*y, is_strict, longer));
                }
            }
            next.truncate(200);
            paths = next;
        }
        None
    }

    /// Whether a form vanishes because of equations that determine no variable: its remainder by
    /// them is zero, where the equation's leading coefficient cannot vanish.
    fn vanishes(&mut self, cx: &mut Context, form: &Form) -> Result<bool> {
        for (atom, exponent) in form.powers.clone() {
            if exponent.order_sign().is_lt() || self.ring.sum(atom).is_none() {
                continue;
            }
            let plain = Plain::of(self, cx, &[atom])?;
            let Some(goal) = plain.goals.first().cloned() else { continue };
            let equations: Vec<&Polynomial> = plain.equations.iter().collect();
            if goal.degree() > SEARCHED_DEGREE || equations.iter().any(|p| p.degree() > SEARCHED_DEGREE) {
                continue;
            }
            if reduces_to_zero(&plain, goal, &equations, &mut 300) {
                self.used |= plain.sources;
                return Ok(true);
            }
        }
        Ok(false)
    }

    fn disjunction(&mut self, cx: &mut Context, goal: &Prop, list: &[Prop]) -> Result<()> {
        for part in list {
            self.defined(&mut cx.clone(), part)?;
        }
        if excluded_middle(list) {
            self.line("cases", format!("{}: one of the two holds", print::prop(goal)));
            return Ok(());
        }
        for part in list {
            self.tick()?;
            let mut inner = cx.clone();
            inner.splits = SPLITS;
            if self.attempt(|engine| engine.show_goal(&mut inner, part)).is_ok() {
                return Ok(());
            }
        }
        // If all others fail, this one holds. The parts must have values all the same.
        for (i, part) in list.iter().enumerate() {
            self.tick()?;
            let mut inner = cx.clone();
            let mut fine = true;
            let result = self.attempt(|engine| {
                engine
                    .line("cases", format!("{}: suppose that only {} can hold", print::prop(goal), print::prop(part)));
                engine.deeper(|engine| {
                    for (j, other) in list.iter().enumerate() {
                        if i == j {
                            continue;
                        }
                        match negation(other) {
                            Some(prop) => engine.assume(&mut inner, &prop, None, Origin::Hypothesis)?,
                            None => fine = false,
                        }
                    }
                    if !fine {
                        return Err(not_shown(goal));
                    }
                    engine.show_goal(&mut inner, part)
                })
            });
            if result.is_ok() {
                return Ok(());
            }
        }
        match self.split_on_fact(cx, goal) {
            Some(result) => result,
            None => Err(not_shown(goal)),
        }
    }

    /// Shows that every expression of a proposition has a value.
    fn defined(&mut self, cx: &mut Context, prop: &Prop) -> Result<()> {
        match &prop.kind {
            PropKind::Compare(sides, relations) => {
                let mut conditions = Vec::new();
                // Numbers, or matrices of one size, which have no order.
                let mut sizes = Vec::new();
                for side in sides {
                    sizes.push(match self.translate(cx, side, &mut conditions)? {
                        Value::Scalar(_) => Vec::new(),
                        Value::Matrix(rows) => rows.iter().map(Vec::len).collect(),
                    });
                }
                let ordered = relations.iter().any(|r| !matches!(r, Relation::Equal | Relation::NotEqual));
                if sizes.windows(2).any(|pair| pair[0] != pair[1]) || (ordered && sizes.iter().any(|s| !s.is_empty())) {
                    return Err(not_shown(prop));
                }
                self.show_conditions(cx, conditions)
            }
            PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => {
                list.iter().try_for_each(|p| self.defined(cx, p))
            }
            PropKind::Not(p) => self.defined(cx, p),
            PropKind::Implies(p, q) => {
                self.defined(cx, p)?;
                self.defined(cx, q)
            }
            _ => Err(not_shown(prop)),
        }
    }

    fn equivalence(&mut self, cx: &mut Context, p: &Prop, q: &Prop) -> Result<()> {
        let text = format!("{} <=> {}", print::prop(p), print::prop(q));
        if let (PropKind::Compare(a, r), PropKind::Compare(b, s)) = (&p.kind, &q.kind)
            && a.len() == 2
            && b.len() == 2
        {
            let same = self.attempt(|engine| {
                let mut sides = Vec::new();
                for (pair, relation) in [(a, r[0]), (b, s[0])] {
                    let mut conditions = Vec::new();
                    let x = engine.scalar(cx, &pair[0], &mut conditions)?;
                    let y = engine.scalar(cx, &pair[1], &mut conditions)?;
                    engine.show_conditions(cx, conditions)?;
                    let difference = engine.difference(cx, &x, &y)?;
                    sides.push((engine.reduced(cx, &difference, relation)?, difference));
                }
                if normal(&sides[0].0) != normal(&sides[1].0) {
                    return Err(not_shown(p));
                }
                let form = engine.show(&sides[0].1);
                engine.line("equivalence", format!("{text}: both depend on the sign of {form}"));
                Ok(())
            });
            if same.is_ok() {
                return Ok(());
            }
        }
        self.defined(&mut cx.clone(), p)?;
        self.defined(&mut cx.clone(), q)?;
        for (from, to) in [(p, q), (q, p)] {
            self.line("implication", format!("{} => {}", print::prop(from), print::prop(to)));
            let mut inner = cx.clone();
            self.deeper(|engine| {
                engine.assume(&mut inner, from, None, Origin::Hypothesis)?;
                engine.show_goal(&mut inner, to)
            })?;
        }
        if !self.rules.contains(&"equivalence") {
            self.rules.push("equivalence");
        }
        Ok(())
    }

    /// Uses implications and equivalences among the facts whose premise can be shown at once.
    fn saturate(&mut self, cx: &mut Context) -> Result<bool> {
        let mut changed = false;
        for fact in 0..cx.facts.len() {
            let pairs: Vec<(Prop, Prop)> = match &cx.facts[fact].prop.kind {
                PropKind::Implies(p, q) => vec![((**p).clone(), (**q).clone())],
                PropKind::Equivalent(list) if list.len() == 2 => {
                    let (p, q) = (list[0].clone(), list[1].clone());
                    let mut pairs = vec![(p.clone(), q.clone()), (q.clone(), p.clone())];
                    if let (Some(a), Some(b)) = (negation(&p), negation(&q)) {
                        pairs.push((a.clone(), b.clone()));
                        pairs.push((b, a));
                    }
                    pairs
                }
                _ => continue,
            };
            if cx.spent.contains(&fact) {
                continue;
            }
            for (premise, conclusion) in pairs {
                let mut inner = cx.clone();
                inner.spent.extend(0..cx.facts.len());
                inner.splits = SPLITS;
                if self.attempt(|engine| engine.show_goal(&mut inner, &premise)).is_ok() {
                    cx.spent.insert(fact);
                    self.used |= source(fact);
                    self.assume(cx, &conclusion, None, Origin::Derived)?;
                    changed = true;
                    break;
                }
            }
        }
        Ok(changed)
    }

    /// Splits on a disjunction among the facts.
    fn split_on_fact(&mut self, cx: &mut Context, goal: &Prop) -> Option<Result<()>> {
        if cx.splits >= SPLITS {
            return None;
        }
        for fact in 0..cx.facts.len() {
            if cx.spent.contains(&fact) {
                continue;
            }
            let prop = cx.facts[fact].prop.clone();
            let pushed = match &prop.kind {
                PropKind::Not(inner) => negation(inner),
                _ => Some((*prop).clone()),
            };
            let Some(Prop { kind: PropKind::Or(list), .. }) = pushed else { continue };
            self.used |= source(fact);
            return Some(self.attempt(|engine| {
                for part in &list {
                    engine.line("case", print::prop(part));
                    let mut inner = cx.clone();
                    inner.splits += 1;
                    inner.spent.insert(fact);
                    engine.deeper(|engine| {
                        engine.assume(&mut inner, part, None, Origin::Hypothesis)?;
                        engine.show_goal(&mut inner, goal)
                    })?;
                }
                Ok(())
            }));
        }
        None
    }

    /// The text of a form, shortened where long.
    pub fn show(&self, form: &Form) -> String {
        let text = super::show::form(&self.ring, form);
        if text.chars().count() > 400 { text.chars().take(397).collect::<String>() + "..." } else { text }
    }
}

/// Whether two of the comparisons are each other's opposite, or <= and >= between the same sides.
fn excluded_middle(list: &[Prop]) -> bool {
    let single = |p: &Prop| match &p.kind {
        PropKind::Compare(sides, relations) if relations.len() == 1 => {
            Some((sides[0].clone(), relations[0], sides[1].clone()))
        }
        _ => None,
    };
    // Each is compared with each; nobody writes so many.
    let singles: Vec<_> = list.iter().filter_map(single).take(200).collect();
    singles.iter().enumerate().any(|(i, (a, r, b))| {
        singles[..i].iter().any(|(c, s, d)| {
            let all = |x: Relation, y: Relation| {
                use Relation::*;
                super::comparison::negated(x) == y
                    || matches!((x, y), (LessEqual, GreaterEqual) | (GreaterEqual, LessEqual))
            };
            (a.same(c) && b.same(d) && all(*r, *s))
                || (a.same(d) && b.same(c) && all(*r, super::comparison::mirrored(*s)))
        })
    })
}

/// Whether p vanishes where the equations do: each equation in turn takes out one variable, by a
/// pseudo-division whose leading coefficient cannot vanish; at most `tries` divisions.
fn reduces_to_zero(plain: &Plain, p: Polynomial, equations: &[&Polynomial], tries: &mut usize) -> bool {
    if p.is_zero() {
        return true;
    }
    for (place, equation) in equations.iter().enumerate() {
        let mut others = equations.to_vec();
        others.remove(place);
        for v in equation.variables() {
            let degree = equation.degree_in(v);
            if degree == 0
                || p.degree_in(v) < degree
                || !plain.signs_by_terms(&equation.leading_coefficient_in(v)).within(Signs::NOT_ZERO)
            {
                continue;
            }
            if *tries == 0 {
                return false;
            }
            *tries -= 1;
            let Ok(rest) = pseudo_remainder(p.clone(), equation, v) else { continue };
            if rest.term_count() <= 400 && reduces_to_zero(plain, rest, &others, tries) {
                return true;
            }
        }
    }
    false
}

/// The remainder of lᵏ·p by q in v, l the leading coefficient of q in v: where q vanishes and l does
/// not, p vanishes if the remainder does.
fn pseudo_remainder(p: Polynomial, q: &Polynomial, v: Var) -> Result<Polynomial> {
    let degree = q.degree_in(v);
    let lead = q.leading_coefficient_in(v);
    let mut rest = p;
    while !rest.is_zero() && rest.degree_in(v) >= degree {
        let k = rest.degree_in(v);
        let top = rest.leading_coefficient_in(v);
        let mut shifted = vec![Polynomial::zero(); (k - degree) as usize];
        shifted.push(top);
        let multiple = Polynomial::from_coefficients_in(v, &shifted).try_mul(q)?;
        rest = rest.try_mul(&lead)?.sub(&multiple);
    }
    Ok(rest)
}

/// A reduced comparison with its atoms in order.
fn normal(reduced: &Reduced) -> Reduced {
    match reduced {
        Reduced::Open(literal) => {
            let mut literal = literal.clone();
            literal.atoms.sort_unstable();
            Reduced::Open(literal)
        }
        decided => decided.clone(),
    }
}

/// The failure that names what was not shown.
pub fn not_shown(goal: &Prop) -> Failure {
    Failure::NotShown(print::prop(goal))
}

/// Whether a quantifier stands in a proposition.
fn quantifies(prop: &Prop) -> bool {
    match &prop.kind {
        PropKind::Compare(..) | PropKind::Limit(_) => false,
        PropKind::ForAll(..) | PropKind::Exists(..) | PropKind::Extremum(_) => true,
        PropKind::Not(p) => quantifies(p),
        PropKind::Implies(p, q) => quantifies(p) || quantifies(q),
        PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => list.iter().any(quantifies),
    }
}
