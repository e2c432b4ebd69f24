//! Induction that the claim's own argument does not mention.

use super::values::at_next;
use super::{Fail, Prover, implies, put};
use crate::certificate::{Label, Rule};
use crate::claim::syntax::*;
use crate::kernel::key;
use crate::kernel::names::names_in_prop;
use crate::kernel::statement::{compare, name, numeral, prop};
use std::collections::BTreeSet;

impl Prover {
    /// Proves a goal by induction on one of its natural variables.
    pub(crate) fn by_induction(&mut self, goal: &Prop) -> Result<Label, Fail> {
        if self.inductions >= 2 || self.splits > 0 {
            return Err(Fail::No("induction"));
        }
        let candidates = self.candidates(goal);
        for variable in &candidates {
            if let Ok(label) = self.on_its_own(|c| c.induction_from_zero(goal, variable)) {
                return Ok(label);
            }
        }
        // Without cases first: most steps need none, and cases do not help if the step needs two previous members.
        for splits in [3, 0] {
            for together in [false, true] {
                for variable in &candidates {
                    if let Ok(label) = self.attempt(|c| c.induction_on(goal, variable, together, splits)) {
                        return Ok(label);
                    }
                }
            }
        }
        for variable in &candidates {
            if let Ok(label) = self.attempt(|c| c.with_products_within_one(goal, variable)) {
                return Ok(label);
            }
        }
        Err(Fail::No("induction"))
    }

    /// By induction on what a variable is more than its least value, where an exponent or the end of a sum or product says so:
    /// 2^(n - 1) is a power of that, which the power of the next one is known by.
    fn induction_from_zero(&mut self, goal: &Prop, variable: &str) -> Result<Label, Fail> {
        let mut sides = Vec::new();
        super::goals::sides_in(goal, &mut sides);
        if self.least(variable).is_none() || !sides.iter().any(|e| has_exponent_below(e, variable)) {
            return Err(Fail::No("an exponent that is less"));
        }
        self.counted_from_zero(goal, variable, &mut |c, k, body| c.induction(k, None, body, 3))
    }

    /// By a statement for all natural numbers k of what a variable is more than its least value; `every` shows it.
    pub(super) fn counted_from_zero(
        &mut self,
        goal: &Prop,
        variable: &str,
        every: &mut dyn FnMut(&mut Prover, &str, &Prop) -> Result<Label, Fail>,
    ) -> Result<Label, Fail> {
        let least = self.least(variable).unwrap_or(0);
        let fresh = self.fresh("k");
        let later = if least > 0 { super::limits::plus(&name(&fresh), numeral(least)) } else { name(&fresh) };
        let mut body = put(goal, variable, &later)?;
        in_exponents(&mut body, &mut |e| {
            if let Some(p) = self.letters.polynomial(e) {
                *e = self.letters.written(&p);
            }
        });
        self.inductions += 1;
        let every = every(self, &fresh, &body)?;
        self.inductions -= 1;
        let before = if least > 0 { super::facts::minus(&name(variable), &numeral(least)) } else { name(variable) };
        let shown = self.instance(&every, &before)?;
        self.logic(&[&shown], goal).or_else(|_| {
            let terms = vec![crate::certificate::Term { facts: vec![shown], factor: numeral(1) }];
            self.combination(goal.clone(), terms)
        })
    }

    /// Shows a goal by induction on a variable, without another attempt before.
    pub(super) fn show_by_induction_on(&mut self, goal: &Prop, variable: &str) -> Result<Label, Fail> {
        if self.inductions > 0 {
            return Err(Fail::No("induction"));
        }
        let splits = std::mem::replace(&mut self.splits, 0);
        let shown = self.induction_on(goal, variable, false, 3);
        self.splits = splits;
        shown
    }

    /// The natural variables on which induction may help, the last declared first.
    pub(super) fn candidates(&self, goal: &Prop) -> Vec<String> {
        let mut names = BTreeSet::new();
        names_in_prop(goal, &mut names);
        let some = matches!(goal.kind, PropKind::Exists(..));
        self.naturals
            .iter()
            .rev()
            .filter(|n| names.contains(*n) && (some || is_bound_within(goal, n)))
            .cloned()
            .collect()
    }

    /// Proves a goal by induction on a variable. If a member depends on the two before it, the statement for n and n + 1 is proved
    /// `together`.
    fn induction_on(&mut self, goal: &Prop, variable: &str, together: bool, splits: usize) -> Result<Label, Fail> {
        if together && !self.looks_back() {
            return Err(Fail::No("members that depend on those before them"));
        }
        self.inductions += 1;
        let base = self.least(variable);
        let fresh = self.fresh("k");
        let mut body = put(goal, variable, &name(&fresh))?;
        if together {
            body = prop(PropKind::And(vec![body.clone(), at_next(&body, &fresh)?]));
        }
        let every = self.induction(&fresh, base, &body, splits)?;
        let shown = self.closed(&every, variable)?;
        if together { self.logic(&[&shown], goal) } else { Ok(shown) }
    }

    /// By induction together with 0 <= P and P <= 1 for each product P that ends at the variable: what is shown of products of
    /// factors from 0 to 1 mostly needs it.
    fn with_products_within_one(&mut self, goal: &Prop, variable: &str) -> Result<Label, Fail> {
        let mut sides = Vec::new();
        super::goals::sides_in(goal, &mut sides);
        let mut products = Vec::new();
        sides.iter().for_each(|e| products_to(e, variable, &mut products));
        if products.is_empty() {
            return Err(Fail::No("a product"));
        }
        let within = |e: &Expr| {
            [(Relation::GreaterEqual, 0), (Relation::LessEqual, 1)].map(|(r, k)| compare(e.clone(), r, numeral(k)))
        };
        let parts = products.iter().flat_map(within).chain([goal.clone()]).collect();
        self.inductions += 1;
        let base = self.least(variable);
        let fresh = self.fresh("k");
        let body = put(&prop(PropKind::And(parts)), variable, &name(&fresh))?;
        let every = self.induction(&fresh, base, &body, 3)?;
        let all = self.closed(&every, variable)?;
        self.logic(&[&all], goal)
    }

    /// An instance of a statement for all natural numbers, at its own variable.
    fn closed(&mut self, every: &str, variable: &str) -> Result<Label, Fail> {
        self.inductions -= 1;
        self.instance(every, &name(variable))
    }

    /// Whether a `for all` fact, or the definition of a sequence, relates members to each other.
    pub(super) fn looks_back(&self) -> bool {
        self.checker.facts().any(|(_, p)| matches!(p.kind, PropKind::ForAll(..)))
    }

    /// Proves a statement for all natural numbers by induction. The step may distinguish cases if `splits` is less than 3.
    pub(crate) fn all_by_induction(&mut self, goal: &Prop, splits: usize) -> Result<Label, Fail> {
        let PropKind::ForAll(bindings, body) = &goal.kind else { return Err(Fail::No("a statement for all values")) };
        let ([binding], true) = (bindings.as_slice(), self.inductions < 2 && self.splits == 0) else {
            return Err(Fail::No("induction"));
        };
        let ([(variable, None)], true) = (binding.names.as_slice(), binding.natural) else {
            return Err(Fail::No("induction"));
        };
        let base = match binding.constraints.as_slice() {
            [] => None,
            [Constraint::Relation(Relation::GreaterEqual, bound)] => super::letters::natural(bound),
            _ => return Err(Fail::No("induction")),
        };
        self.attempt(|c| {
            c.inductions += 1;
            let label = c.induction(&variable.text, base, body, splits)?;
            c.inductions -= 1;
            Ok(label)
        })
    }

    /// Substitutes the equations that give a member at a numeral: `u(0) = 1`.
    pub(super) fn put_in_first_members(&mut self) {
        let is_member = |e: &Expr| match &e.kind {
            ExprKind::Apply(f, at) => at.iter().all(|e| super::letters::natural(e).is_some()) && !is_built_in(&f.text),
            _ => false,
        };
        let is_first = |p: &Prop| match &p.kind {
            PropKind::Compare(sides, relations) => *relations == [Relation::Equal] && is_member(&sides[0]),
            _ => false,
        };
        let first: Vec<Label> =
            self.checker.facts().filter(|(_, p)| is_first(p)).map(|(label, _)| label.to_string()).collect();
        first.iter().for_each(|label| self.put_in(label));
    }

    /// The largest known numeral that is a lower bound of a natural variable.
    pub(super) fn least(&self, variable: &str) -> Option<u32> {
        let is_variable = |e: &Expr| matches!(&e.kind, ExprKind::Name(n) if n == variable);
        let bounds = self.checker.facts().filter_map(|(_, p)| match p.single() {
            Some((a, Relation::GreaterEqual, b)) if is_variable(a) => super::letters::natural(b),
            Some((a, Relation::LessEqual, b)) if is_variable(b) => super::letters::natural(a),
            Some((a, Relation::Greater, b)) if is_variable(a) => super::letters::natural(b).map(|k| k + 1),
            _ => None,
        });
        bounds.max().filter(|k| *k > 0)
    }

    fn induction(&mut self, variable: &str, base: Option<u32>, body: &Prop, splits: usize) -> Result<Label, Fail> {
        self.induction_by(variable, base, body, &mut |c, _, next| {
            let before = std::mem::replace(&mut c.splits, splits);
            let shown = c.show(next);
            c.splits = before;
            shown
        })
    }

    /// Proves a statement for all natural numbers from `base` on by induction. `advance` shows it of the next number; it is told
    /// the label of the hypothesis.
    pub(super) fn induction_by(
        &mut self,
        variable: &str,
        base: Option<u32>,
        body: &Prop,
        advance: &mut dyn FnMut(&mut Prover, Label, &Prop) -> Result<Label, Fail>,
    ) -> Result<Label, Fail> {
        let first = numeral(base.unwrap_or(0));
        let at_base = put(body, variable, &first)?;
        let start = self.attempt(|c| {
            c.splits += 1;
            c.put_in_first_members();
            c.show(&at_base)
        })?;
        let constraints = base.map(|k| Constraint::Relation(Relation::GreaterEqual, numeral(k)));
        let binding = Binding::of(Name::new(variable), true, constraints.into_iter().collect());
        let every = |p: Prop| prop(PropKind::ForAll(vec![binding.clone()], Box::new(p)));
        let next = at_next(body, variable)?;
        let step = implies(body, &next);
        let advance = self.block(&every(step.clone()), |c, _| {
            c.take_signs_at(variable);
            c.define_sides(&step);
            c.block(&step, |c, block| advance(c, format!("{block}s"), &next))
        })?;
        self.emit(Rule::Induction { base: start, advance }, every(body.clone()))
    }
}

/// All of these at once.
pub(super) fn all(mut parts: Vec<Prop>) -> Prop {
    match (parts.len(), parts.pop()) {
        (1, Some(only)) => only,
        (_, last) => prop(PropKind::And(parts.into_iter().chain(last).collect())),
    }
}

/// The products over an index that end at a variable, each once.
fn products_to(e: &Expr, variable: &str, out: &mut Vec<Expr>) {
    if let ExprKind::ProductOver(index, _) = &e.kind
        && matches!(&index.to.kind, ExprKind::Name(n) if n == variable)
        && !out.iter().any(|p| key::expr(p) == key::expr(e))
    {
        out.push(e.clone());
    }
    crate::refute::expand::parts(e, &mut |part| products_to(part, variable, out));
}

/// Whether a power or the end of a sum or product says a variable less a number.
fn has_exponent_below(e: &Expr, variable: &str) -> bool {
    let less = |e: &Expr| {
        matches!(&e.kind, ExprKind::Sum(list)
            if list.iter().any(|(sign, e)| *sign == Sign::Minus && super::letters::natural(e).is_some()))
            && super::limits::holds(e, variable)
    };
    let own = match &e.kind {
        ExprKind::Power(_, exponent) => less(exponent),
        ExprKind::SumOver(index, _) | ExprKind::ProductOver(index, _) => less(&index.to),
        _ => false,
    };
    let mut found = own;
    crate::refute::expand::parts(e, &mut |part| found |= has_exponent_below(part, variable));
    found
}

/// Changes the exponents and the ends of sums and products in a comparison.
fn in_exponents(p: &mut Prop, change: &mut dyn FnMut(&mut Expr)) {
    fn within(e: &mut Expr, change: &mut dyn FnMut(&mut Expr)) {
        match &mut e.kind {
            ExprKind::Power(_, exponent) => change(exponent),
            ExprKind::SumOver(index, _) | ExprKind::ProductOver(index, _) => change(&mut index.to),
            _ => {}
        }
        crate::claim::walk::parts_mut(e, &mut |part| within(part, change));
    }
    if let PropKind::Compare(sides, _) = &mut p.kind {
        sides.iter_mut().for_each(|e| within(e, change));
    }
}

/// Whether induction on a variable may help: it occurs in an exponent, as the end of a sum or product, or in an index.
pub(super) fn is_bound_within(p: &Prop, variable: &str) -> bool {
    let mut sides = Vec::new();
    super::goals::sides_in(p, &mut sides);
    sides.iter().any(|e| within(e, variable))
}

fn within(e: &Expr, variable: &str) -> bool {
    let holds = |e: &Expr| {
        let mut names = BTreeSet::new();
        crate::kernel::names::names_in(e, &mut names);
        names.contains(variable)
    };
    match &e.kind {
        ExprKind::Number(_) | ExprKind::Name(_) => false,
        ExprKind::Apply(f, list) => {
            (!is_built_in(&f.text) && list.iter().any(holds)) || list.iter().any(|e| within(e, variable))
        }
        ExprKind::Negate(a) => within(a, variable),
        ExprKind::Sum(list) => list.iter().any(|(_, e)| within(e, variable)),
        ExprKind::Product(list) => list.iter().any(|(_, e)| within(e, variable)),
        ExprKind::Power(a, b) => holds(b) || within(a, variable),
        ExprKind::SumOver(index, body) | ExprKind::ProductOver(index, body) | ExprKind::IntegralOver(index, body) => {
            holds(&index.to) || within(body, variable)
        }
        ExprKind::Derivative(a, _) => within(a, variable),
        ExprKind::Matrix(rows) => rows.iter().flatten().any(|e| within(e, variable)),
    }
}
