//! The statement of a claim with its definitions put in place, and substitution.
//!
//! Contract: a substitution replaces free names at once; where a bound name would capture a name of a
//! replacement it is refused, so nothing is ever captured. Depth and size of the result are bounded.

use super::{Reason, Refusal, rejected, text};
use crate::claim::syntax::*;
use std::collections::{BTreeSet, HashMap};
use std::rc::Rc;

/// The deepest nesting of an expression or proposition.
pub(crate) const DEPTH_LIMIT: usize = 400;
/// The most nodes that one substitution may write, and all that put the `let`s of one claim in place.
pub const NODES_LIMIT: usize = 200_000;

/// A sequence u by u(0) and u(k + 1).
#[derive(Clone, Debug)]
pub struct Sequence {
    /// Its name u.
    pub name: String,
    /// u(0).
    pub initial: Expr,
    /// The name k.
    pub index: String,
    /// u(k + 1) in terms of k and u(k).
    pub step: Expr,
}

/// What a claim says.
#[derive(Clone, Debug)]
pub struct Statement {
    /// The claim's name.
    pub name: String,
    /// Its variables and families.
    pub bindings: Vec<Binding>,
    /// Its sequences.
    pub sequences: Vec<Sequence>,
    /// Its hypotheses.
    pub assumptions: Vec<Prop>,
    /// What it claims.
    pub goal: Prop,
}

impl Statement {
    /// The statement of a claim: every `let` is put in place, in the order written.
    pub fn of(claim: &Claim) -> Result<Statement, Refusal> {
        let mut lets = Substitution::default();
        let room = &mut Room::new();
        let (mut bindings, mut sequences, mut assumptions) = (Vec::new(), Vec::new(), Vec::new());
        for item in &claim.items {
            match item {
                Item::Given(list) => {
                    for binding in list {
                        bindings.push(lets.binding_in(binding, room)?);
                    }
                }
                Item::Let { name, parameters, value } => {
                    let value = lets.without(parameters.iter(), room)?.expr_in(value, room)?;
                    lets.define(&name.text, parameters.iter().map(|p| p.text.clone()).collect(), value);
                }
                Item::Define { name, initial, index, step, .. } => sequences.push(Sequence {
                    name: name.text.clone(),
                    initial: lets.expr_in(initial, room)?,
                    index: index.text.clone(),
                    step: lets.without([index].into_iter(), room)?.expr_in(step, room)?,
                }),
                Item::Assume { prop, .. } => assumptions.push(lets.prop_in(prop, room)?),
            }
        }
        let goal = lets.prop_in(&claim.goal, room)?;
        Ok(Statement { name: claim.name.text.clone(), bindings, sequences, assumptions, goal })
    }

    /// Every name that occurs, bound ones included.
    pub fn names(&self) -> BTreeSet<String> {
        let mut out = BTreeSet::new();
        self.bindings.iter().for_each(|b| names_in_binding(b, &mut out));
        for u in &self.sequences {
            out.extend([u.name.clone(), u.index.clone()]);
            names_in(&u.initial, &mut out);
            names_in(&u.step, &mut out);
        }
        self.assumptions.iter().chain([&self.goal]).for_each(|p| names_in_prop(p, &mut out));
        out
    }

    /// The statement, one hypothesis on each line: what the kernel understood.
    pub fn text(&self) -> String {
        let mut out = format!("claim {}\n", self.name);
        for binding in &self.bindings {
            out += &format!("given {}\n", text::binding(binding));
        }
        for u in &self.sequences {
            let (name, k) = (&u.name, &u.index);
            out += &format!(
                "define {name} by {name}(0) = {}, {name}({k} + 1) = {}\n",
                text::expr(&u.initial),
                text::expr(&u.step)
            );
        }
        for prop in &self.assumptions {
            out += &format!("assume {}\n", text::prop(prop));
        }
        out + &format!("prove {}\n", text::prop(&self.goal))
    }
}

/// An expression without a place.
pub fn expr(kind: ExprKind) -> Expr {
    Expr { kind, span: Span::default() }
}

/// A numeral.
pub fn numeral(k: u32) -> Expr {
    expr(ExprKind::Number(k.to_string()))
}

/// A name.
pub fn name(text: &str) -> Expr {
    expr(ExprKind::Name(text.to_string()))
}

/// A sum.
pub fn sum(parts: Vec<(Sign, Expr)>) -> Expr {
    expr(ExprKind::Sum(parts))
}

/// A product.
pub fn product(parts: Vec<Expr>) -> Expr {
    expr(ExprKind::Product(parts.into_iter().map(|e| (Factor::Times, e)).collect()))
}

/// A power.
pub fn power(base: &Expr, exponent: &Expr) -> Expr {
    expr(ExprKind::Power(Box::new(base.clone()), Box::new(exponent.clone())))
}

/// `function(argument)`.
pub fn apply(function: &str, argument: Expr) -> Expr {
    expr(ExprKind::Apply(Name { text: function.to_string(), span: Span::default() }, vec![argument]))
}

/// `1 - p`.
pub(crate) fn one_minus(p: &Expr) -> Expr {
    sum(vec![(Sign::Plus, numeral(1)), (Sign::Minus, p.clone())])
}

/// A proposition without a place.
pub fn prop(kind: PropKind) -> Prop {
    Prop { kind, span: Span::default() }
}

/// `a relation b`.
pub fn compare(a: Expr, relation: Relation, b: Expr) -> Prop {
    prop(PropKind::Compare(vec![a, b], vec![relation]))
}

/// What the domain of a binding says of each plain name; families say it of their members.
pub fn domain(binding: &Binding) -> Vec<Prop> {
    let plain = binding.names.iter().filter(|n| n.1.is_none());
    plain.flat_map(|(n, _)| constraints(binding, &name(&n.text))).collect()
}

/// The constraints of a binding about one value.
pub fn constraints(binding: &Binding, value: &Expr) -> Vec<Prop> {
    let mut out = Vec::new();
    let mut push = |relation: Relation, bound: &Expr| out.push(compare(value.clone(), relation, bound.clone()));
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
    out
}

#[derive(Clone, Debug)]
enum Replacement {
    Value(Expr),
    Definition(Vec<String>, Expr),
    Family(String),
}

/// A replacement of free names, all at once.
#[derive(Clone, Debug, Default)]
pub struct Substitution {
    map: Rc<HashMap<String, Replacement>>,
    /// Names of the map that are bound here, so that they are not replaced.
    hidden: Vec<String>,
    /// Names that occur in replacements: no bound name may be one of them.
    mentioned: Rc<BTreeSet<String>>,
    /// Names that occur in values put in for variables. What is put in under `derivative` or `limit` must
    /// not bring in the variable that moves there; a definition may, for it is only written out.
    put_in: Rc<BTreeSet<String>>,
    /// Whether such a value holds a member of a family or sequence, which may depend on anything.
    members_put_in: bool,
}

/// Room left: for depth, and for nodes.
struct Room {
    depth: usize,
    nodes: usize,
}

impl Room {
    fn new() -> Room {
        Room { depth: DEPTH_LIMIT, nodes: NODES_LIMIT }
    }

    fn enter(&mut self) -> Result<(), Refusal> {
        if self.depth == 0 {
            return Err(Refusal::Limit("depth"));
        }
        if self.nodes == 0 {
            return Err(Refusal::Limit("size"));
        }
        self.depth -= 1;
        self.nodes -= 1;
        Ok(())
    }
}

impl Substitution {
    /// Replaces a name by a value.
    pub fn replace(&mut self, name: &str, value: &Expr) {
        names_in(value, Rc::make_mut(&mut self.mentioned));
        names_in(value, Rc::make_mut(&mut self.put_in));
        self.members_put_in |= has_member(value);
        Rc::make_mut(&mut self.map).insert(name.to_string(), Replacement::Value(value.clone()));
    }

    /// Renames a family.
    pub(crate) fn rename_family(&mut self, name: &str, other: &str) {
        Rc::make_mut(&mut self.mentioned).insert(other.to_string());
        Rc::make_mut(&mut self.map).insert(name.to_string(), Replacement::Family(other.to_string()));
    }

    fn define(&mut self, name: &str, parameters: Vec<String>, value: Expr) {
        let mut names = BTreeSet::new();
        names_in(&value, &mut names);
        Rc::make_mut(&mut self.mentioned).extend(names.into_iter().filter(|n| !parameters.contains(n)));
        Rc::make_mut(&mut self.map).insert(name.to_string(), Replacement::Definition(parameters, value));
    }

    /// The substitution under binders of these names.
    fn without<'n>(&self, names: impl Iterator<Item = &'n Name>, room: &mut Room) -> Result<Substitution, Refusal> {
        let mut inner = self.clone();
        for name in names {
            if inner.replacement(&name.text).is_some() {
                inner.hidden.push(name.text.clone());
            }
            if self.mentioned.contains(&name.text) && inner.hidden.len() < self.map.len() {
                return rejected(Reason::Capture(name.text.clone()));
            }
        }
        room.nodes = room.nodes.saturating_sub(inner.hidden.len());
        Ok(inner)
    }

    fn replacement(&self, name: &str) -> Option<&Replacement> {
        self.map.get(name).filter(|_| !self.hidden.iter().any(|h| h == name))
    }

    /// Refuses a value for a variable that moves in a derivative or limit, and values that mention it:
    /// `for all y: derivative(x*y, x) = y` says nothing of y = x.
    fn moves(&self, variable: &str) -> Result<(), Refusal> {
        if self.replacement(variable).is_some() || self.put_in.contains(variable) || self.members_put_in {
            return rejected(Reason::Moves(variable.to_string()));
        }
        Ok(())
    }

    /// The expression with the names replaced.
    pub fn expr(&self, e: &Expr) -> Result<Expr, Refusal> {
        self.expr_in(e, &mut Room::new())
    }

    /// The proposition with the names replaced.
    pub fn prop(&self, p: &Prop) -> Result<Prop, Refusal> {
        self.prop_in(p, &mut Room::new())
    }

    /// The binding with the names in its constraints replaced.
    pub fn binding(&self, b: &Binding) -> Result<Binding, Refusal> {
        self.binding_in(b, &mut Room::new())
    }

    fn expr_in(&self, e: &Expr, room: &mut Room) -> Result<Expr, Refusal> {
        room.enter()?;
        use ExprKind::*;
        let all = |list: &[Expr], room: &mut Room| -> Result<Vec<Expr>, Refusal> {
            list.iter().map(|e| self.expr_in(e, room)).collect()
        };
        let kind = match &e.kind {
            Number(text) => Number(text.clone()),
            Name(text) => match self.replacement(text) {
                // The copy is walked through to count it.
                Some(Replacement::Value(value)) => Substitution::default().expr_in(value, room)?.kind,
                Some(Replacement::Definition(parameters, value)) if parameters.is_empty() => {
                    Substitution::default().expr_in(value, room)?.kind
                }
                _ => Name(text.clone()),
            },
            Apply(function, arguments) => {
                let arguments = all(arguments, room)?;
                match self.replacement(&function.text) {
                    Some(Replacement::Definition(parameters, value)) if parameters.len() == arguments.len() => {
                        let mut inner = Substitution::default();
                        for (parameter, argument) in parameters.iter().zip(&arguments) {
                            inner.replace(parameter, argument);
                        }
                        inner.expr_in(value, room)?.kind
                    }
                    Some(Replacement::Family(other)) => {
                        Apply(crate::claim::syntax::Name { text: other.clone(), span: function.span }, arguments)
                    }
                    Some(_) => return rejected(Reason::NotAFunction(function.text.clone())),
                    None => Apply(function.clone(), arguments),
                }
            }
            Negate(a) => Negate(Box::new(self.expr_in(a, room)?)),
            Sum(list) => {
                Sum(list.iter().map(|(s, e)| Ok((*s, self.expr_in(e, room)?))).collect::<Result<_, Refusal>>()?)
            }
            Product(list) => {
                Product(list.iter().map(|(s, e)| Ok((*s, self.expr_in(e, room)?))).collect::<Result<_, Refusal>>()?)
            }
            Power(a, b) => Power(Box::new(self.expr_in(a, room)?), Box::new(self.expr_in(b, room)?)),
            SumOver(index, body) => {
                let (index, body) = self.over(index, body, room)?;
                SumOver(index, body)
            }
            ProductOver(index, body) => {
                let (index, body) = self.over(index, body, room)?;
                ProductOver(index, body)
            }
            Derivative(body, by) => {
                for name in by {
                    self.moves(&name.text)?;
                }
                Derivative(Box::new(self.expr_in(body, room)?), by.clone())
            }
            Matrix(rows) => Matrix(rows.iter().map(|row| all(row, room)).collect::<Result<_, Refusal>>()?),
        };
        room.depth += 1;
        Ok(Expr { kind, span: e.span })
    }

    fn over(&self, index: &Index, body: &Expr, room: &mut Room) -> Result<(Index, Box<Expr>), Refusal> {
        let from = Box::new(self.expr_in(&index.from, room)?);
        let to = Box::new(self.expr_in(&index.to, room)?);
        let body = self.without([&index.name].into_iter(), room)?.expr_in(body, room)?;
        Ok((Index { name: index.name.clone(), from, to }, Box::new(body)))
    }

    fn binding_in(&self, b: &Binding, room: &mut Room) -> Result<Binding, Refusal> {
        let inner = self.without(b.names.iter().filter_map(|n| n.1.as_ref()), room)?;
        let mut out = b.clone();
        for constraint in &mut out.constraints {
            match constraint {
                Constraint::Relation(_, e) => *e = inner.expr_in(e, room)?,
                Constraint::Interval { from, to, .. } | Constraint::Range(from, to) => {
                    *from = inner.expr_in(from, room)?;
                    *to = inner.expr_in(to, room)?;
                }
            }
        }
        if let Some((from, to)) = &mut out.indices {
            *from = inner.expr_in(from, room)?;
            *to = inner.expr_in(to, room)?;
        }
        Ok(out)
    }

    fn prop_in(&self, p: &Prop, room: &mut Room) -> Result<Prop, Refusal> {
        room.enter()?;
        use PropKind::*;
        let all = |list: &[Prop], room: &mut Room| -> Result<Vec<Prop>, Refusal> {
            list.iter().map(|p| self.prop_in(p, room)).collect()
        };
        let bound = |bindings: &[Binding], room: &mut Room| -> Result<(Vec<Binding>, Substitution), Refusal> {
            let inner = self.without(bindings.iter().flat_map(|b| b.names.iter().map(|n| &n.0)), room)?;
            let list = bindings.iter().map(|b| inner.binding_in(b, room)).collect::<Result<_, Refusal>>()?;
            Ok((list, inner))
        };
        let kind = match &p.kind {
            Compare(sides, relations) => {
                let sides = sides.iter().map(|e| self.expr_in(e, room)).collect::<Result<_, Refusal>>()?;
                Compare(sides, relations.clone())
            }
            And(list) => And(all(list, room)?),
            Or(list) => Or(all(list, room)?),
            Not(inner) => Not(Box::new(self.prop_in(inner, room)?)),
            Implies(a, b) => Implies(Box::new(self.prop_in(a, room)?), Box::new(self.prop_in(b, room)?)),
            Equivalent(list) => Equivalent(all(list, room)?),
            Exists(bindings, body) => {
                let (bindings, inner) = bound(bindings, room)?;
                Exists(bindings, Box::new(inner.prop_in(body, room)?))
            }
            ForAll(bindings, body) => {
                let (bindings, inner) = bound(bindings, room)?;
                ForAll(bindings, Box::new(inner.prop_in(body, room)?))
            }
            PropKind::Extremum(e) => {
                // The point and the value stand outside the scope of the bound names.
                let (over, inner) = bound(&e.over, room)?;
                let at: Result<Vec<_>, Refusal> =
                    e.at.iter().map(|(n, v)| Ok((n.clone(), self.expr_in(v, room)?))).collect();
                PropKind::Extremum(Box::new(crate::claim::syntax::Extremum {
                    of: inner.expr_in(&e.of, room)?,
                    over,
                    at: at?,
                    value: self.expr_in(&e.value, room)?,
                    ..**e
                }))
            }
            PropKind::Limit(l) => {
                self.moves(&l.variable.text)?;
                PropKind::Limit(Box::new(crate::claim::syntax::Limit {
                    of: self.expr_in(&l.of, room)?,
                    variable: l.variable.clone(),
                    value: self.expr_in(&l.value, room)?,
                }))
            }
        };
        room.depth += 1;
        Ok(Prop { kind, span: p.span })
    }
}

/// The parts of an expression.
fn parts(e: &Expr) -> Vec<&Expr> {
    use ExprKind::*;
    match &e.kind {
        Number(_) | Name(_) => Vec::new(),
        Apply(_, arguments) => arguments.iter().collect(),
        Negate(a) | Derivative(a, _) => vec![a],
        Sum(list) => list.iter().map(|(_, e)| e).collect(),
        Product(list) => list.iter().map(|(_, e)| e).collect(),
        Power(a, b) => vec![a, b],
        SumOver(index, body) | ProductOver(index, body) => vec![&index.from, &index.to, body],
        Matrix(rows) => rows.iter().flatten().collect(),
    }
}

/// Whether a member of a family or sequence occurs.
fn has_member(e: &Expr) -> bool {
    let here = matches!(&e.kind, ExprKind::Apply(f, _) if !super::term::FUNCTIONS.contains(&f.text.as_str()));
    here || parts(e).into_iter().any(has_member)
}

/// Whether a sequence occurs in its own step as the member at the index only, which nothing binds again.
pub(crate) fn steps_once(step: &Expr, sequence: &str, index: &str) -> bool {
    let here = match &step.kind {
        ExprKind::Name(text) => text != sequence,
        ExprKind::Apply(f, arguments) if f.text == sequence => {
            return matches!(arguments.as_slice(), [Expr { kind: ExprKind::Name(text), .. }] if text == index);
        }
        ExprKind::SumOver(i, _) | ExprKind::ProductOver(i, _) => i.name.text != index,
        ExprKind::Derivative(_, by) => by.iter().all(|n| n.text != sequence && n.text != index),
        _ => true,
    };
    here && parts(step).into_iter().all(|e| steps_once(e, sequence, index))
}

/// Every name that occurs free.
pub fn names_in(e: &Expr, out: &mut BTreeSet<String>) {
    use ExprKind::*;
    match &e.kind {
        Number(_) => {}
        Name(text) => {
            out.insert(text.clone());
        }
        Apply(function, arguments) => {
            out.insert(function.text.clone());
            arguments.iter().for_each(|e| names_in(e, out));
        }
        Negate(a) => names_in(a, out),
        Sum(list) => list.iter().for_each(|(_, e)| names_in(e, out)),
        Product(list) => list.iter().for_each(|(_, e)| names_in(e, out)),
        Power(a, b) => {
            names_in(a, out);
            names_in(b, out);
        }
        SumOver(index, body) | ProductOver(index, body) => {
            names_in(&index.from, out);
            names_in(&index.to, out);
            let mut inside = BTreeSet::new();
            names_in(body, &mut inside);
            inside.remove(&index.name.text);
            out.extend(inside);
        }
        Derivative(body, by) => {
            out.extend(by.iter().map(|n| n.text.clone()));
            names_in(body, out);
        }
        Matrix(rows) => rows.iter().flatten().for_each(|e| names_in(e, out)),
    }
}

/// Every name that occurs in a proposition, bound ones as well.
pub fn names_in_prop(p: &Prop, out: &mut BTreeSet<String>) {
    use PropKind::*;
    match &p.kind {
        Compare(sides, _) => sides.iter().for_each(|e| names_in(e, out)),
        And(list) | Or(list) | Equivalent(list) => list.iter().for_each(|p| names_in_prop(p, out)),
        Not(inner) => names_in_prop(inner, out),
        Implies(a, b) => {
            names_in_prop(a, out);
            names_in_prop(b, out);
        }
        Exists(bindings, body) | ForAll(bindings, body) => {
            bindings.iter().for_each(|b| names_in_binding(b, out));
            names_in_prop(body, out);
        }
        Extremum(e) => {
            e.over.iter().for_each(|b| names_in_binding(b, out));
            [&e.of, &e.value].into_iter().chain(e.at.iter().map(|a| &a.1)).for_each(|e| names_in(e, out));
        }
        Limit(l) => {
            out.insert(l.variable.text.clone());
            names_in(&l.of, out);
            names_in(&l.value, out);
        }
    }
}

/// Every name that occurs in a binding.
pub fn names_in_binding(b: &Binding, out: &mut BTreeSet<String>) {
    for (name, index) in &b.names {
        out.insert(name.text.clone());
        out.extend(index.iter().map(|n| n.text.clone()));
    }
    for constraint in &b.constraints {
        match constraint {
            Constraint::Relation(_, e) => names_in(e, out),
            Constraint::Interval { from, to, .. } | Constraint::Range(from, to) => {
                names_in(from, out);
                names_in(to, out);
            }
        }
    }
    if let Some((from, to)) = &b.indices {
        names_in(from, out);
        names_in(to, out);
    }
}
