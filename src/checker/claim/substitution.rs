//! Substitution: free names replaced by expressions, all at once.
//!
//! Contract: where a bound name would capture a name of a replacement the substitution is refused, so nothing is ever
//! captured. A value for a variable that moves in a derivative or limit is refused as well. Depth and size of the result
//! are bounded. Reader, kernel and search substitute by this file alone.

use super::free_names::names_in;
use super::syntax::*;
use super::walk::parts;
use std::collections::{BTreeSet, HashMap};
use std::rc::Rc;

/// The deepest nesting of an expression or proposition.
pub const DEPTH_LIMIT: usize = 400;
/// The most nodes that one substitution may write, and all that put the `let`s of one claim in place.
pub const NODES_LIMIT: usize = 200_000;

/// Why a substitution is not made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Obstacle {
    /// A bound name would capture a name of a replacement.
    Capture(String),
    /// The variable moves in a derivative or limit, or what is put in may depend on it.
    Moves(String),
    /// A name with arguments that stands for no function.
    NotAFunction(String),
    /// The named limit was reached.
    Limit(&'static str),
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
    /// Whether the values are the arguments of a definition, put in for its parameters.
    of_arguments: bool,
}

/// Room left: for depth, and for nodes.
pub(crate) struct Room {
    depth: usize,
    nodes: usize,
}

impl Room {
    pub(crate) fn new() -> Room {
        Room { depth: DEPTH_LIMIT, nodes: NODES_LIMIT }
    }

    pub(crate) fn enter(&mut self) -> Result<(), Obstacle> {
        if self.depth == 0 {
            return Err(Obstacle::Limit("depth"));
        }
        if self.nodes == 0 {
            return Err(Obstacle::Limit("size"));
        }
        self.depth -= 1;
        self.nodes -= 1;
        Ok(())
    }

    pub(crate) fn leave(&mut self) {
        self.depth += 1;
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
    pub fn rename_family(&mut self, name: &str, other: &str) {
        Rc::make_mut(&mut self.mentioned).insert(other.to_string());
        Rc::make_mut(&mut self.map).insert(name.to_string(), Replacement::Family(other.to_string()));
    }

    /// Puts a definition in place of a name, or of its applications to arguments.
    pub fn define(&mut self, name: &str, parameters: Vec<String>, value: Expr) {
        let mut names = BTreeSet::new();
        names_in(&value, &mut names);
        Rc::make_mut(&mut self.mentioned).extend(names.into_iter().filter(|n| !parameters.contains(n)));
        Rc::make_mut(&mut self.map).insert(name.to_string(), Replacement::Definition(parameters, value));
    }

    /// The substitution under binders of these names.
    pub(crate) fn without<'n>(
        &self,
        names: impl Iterator<Item = &'n Name>,
        room: &mut Room,
    ) -> Result<Substitution, Obstacle> {
        let mut inner = self.clone();
        for name in names {
            if inner.replacement(&name.text).is_some() {
                inner.hidden.push(name.text.clone());
            }
            if self.mentioned.contains(&name.text) && inner.hidden.len() < self.map.len() {
                return Err(Obstacle::Capture(name.text.clone()));
            }
        }
        room.nodes = room.nodes.saturating_sub(inner.hidden.len());
        Ok(inner)
    }

    /// The substitution under bound names.
    pub(crate) fn under(&self, names: &[Name]) -> Result<Substitution, Obstacle> {
        self.without(names.iter(), &mut Room::new())
    }

    fn replacement(&self, name: &str) -> Option<&Replacement> {
        self.map.get(name).filter(|_| !self.hidden.iter().any(|h| h == name))
    }

    /// Refuses a value for a variable that moves in a derivative or limit, and values that mention it:
    /// `for all y: derivative(x*y, x) = y` says nothing of y = x.
    fn moves(&self, variable: &str) -> Result<(), Obstacle> {
        if self.replacement(variable).is_some() || self.put_in.contains(variable) || self.members_put_in {
            return Err(Obstacle::Moves(variable.to_string()));
        }
        Ok(())
    }

    /// The variables of a derivative in a definition by whose parameters it is taken, if the arguments for these are variables.
    ///
    /// With `v(s) = derivative(F, s)`, v(z) is the derivative of F by s at s = z. Where z stands neither in F nor in another argument,
    /// F with z for s is the same function of z, so that v(z) is its derivative by z. With `F = z*s` it is not.
    fn renamed(&self, body: &Expr, by: &[Name]) -> Option<Vec<Name>> {
        if !self.of_arguments || by.iter().all(|name| self.replacement(&name.text).is_none()) {
            return None;
        }
        let mut inside = BTreeSet::new();
        super::walk::names_in(body, &mut inside);
        let argument = |parameter: &str| match self.replacement(parameter) {
            Some(Replacement::Value(Expr { kind: ExprKind::Name(z), .. })) if z != PI => Some(z),
            _ => None,
        };
        let is_own = |parameter: &str, z: &String| {
            let others = self.map.iter().filter(|(other, _)| *other != parameter);
            let mut names = BTreeSet::new();
            for (_, value) in others {
                if let Replacement::Value(value) = value {
                    super::walk::names_in(value, &mut names);
                }
            }
            !names.contains(z) && (parameter == z || !inside.contains(z))
        };
        by.iter()
            .map(|name| {
                let z = argument(&name.text).filter(|z| is_own(&name.text, z))?;
                Some(Name { text: z.clone(), span: name.span })
            })
            .collect()
    }

    /// The expression with the names replaced.
    pub fn expr(&self, e: &Expr) -> Result<Expr, Obstacle> {
        self.expr_in(e, &mut Room::new())
    }

    /// The proposition with the names replaced.
    pub fn prop(&self, p: &Prop) -> Result<Prop, Obstacle> {
        self.prop_in(p, &mut Room::new())
    }

    /// The binding with the names in its constraints replaced.
    pub fn binding(&self, b: &Binding) -> Result<Binding, Obstacle> {
        self.binding_in(b, &mut Room::new())
    }

    pub(crate) fn expr_in(&self, e: &Expr, room: &mut Room) -> Result<Expr, Obstacle> {
        room.enter()?;
        use ExprKind::*;
        let all = |list: &[Expr], room: &mut Room| -> Result<Vec<Expr>, Obstacle> {
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
                        let mut inner = Substitution { of_arguments: true, ..Substitution::default() };
                        for (parameter, argument) in parameters.iter().zip(&arguments) {
                            inner.replace(parameter, argument);
                        }
                        inner.expr_in(value, room)?.kind
                    }
                    Some(Replacement::Family(other)) => {
                        Apply(crate::claim::syntax::Name { text: other.clone(), span: function.span }, arguments)
                    }
                    Some(_) => return Err(Obstacle::NotAFunction(function.text.clone())),
                    None => Apply(function.clone(), arguments),
                }
            }
            Negate(a) => Negate(Box::new(self.expr_in(a, room)?)),
            Sum(list) => {
                Sum(list.iter().map(|(s, e)| Ok((*s, self.expr_in(e, room)?))).collect::<Result<_, Obstacle>>()?)
            }
            Product(list) => {
                Product(list.iter().map(|(s, e)| Ok((*s, self.expr_in(e, room)?))).collect::<Result<_, Obstacle>>()?)
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
            IntegralOver(variable, body) => {
                let (variable, body) = self.over(variable, body, room)?;
                IntegralOver(variable, body)
            }
            Derivative(body, by) => {
                let by = match self.renamed(body, by) {
                    Some(by) => by,
                    None => {
                        by.iter().try_for_each(|name| self.moves(&name.text))?;
                        by.clone()
                    }
                };
                Derivative(Box::new(self.expr_in(body, room)?), by)
            }
            Matrix(rows) => Matrix(rows.iter().map(|row| all(row, room)).collect::<Result<_, Obstacle>>()?),
        };
        room.leave();
        Ok(Expr { kind, span: e.span })
    }

    fn over(&self, index: &Index, body: &Expr, room: &mut Room) -> Result<(Index, Box<Expr>), Obstacle> {
        let from = Box::new(self.expr_in(&index.from, room)?);
        let to = Box::new(self.expr_in(&index.to, room)?);
        let body = self.without([&index.name].into_iter(), room)?.expr_in(body, room)?;
        Ok((Index { name: index.name.clone(), from, to }, Box::new(body)))
    }

    pub(crate) fn binding_in(&self, b: &Binding, room: &mut Room) -> Result<Binding, Obstacle> {
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

    pub(crate) fn prop_in(&self, p: &Prop, room: &mut Room) -> Result<Prop, Obstacle> {
        room.enter()?;
        use PropKind::*;
        let all = |list: &[Prop], room: &mut Room| -> Result<Vec<Prop>, Obstacle> {
            list.iter().map(|p| self.prop_in(p, room)).collect()
        };
        let bound = |bindings: &[Binding], room: &mut Room| -> Result<(Vec<Binding>, Substitution), Obstacle> {
            let inner = self.without(bindings.iter().flat_map(|b| b.names.iter().map(|n| &n.0)), room)?;
            let list = bindings.iter().map(|b| inner.binding_in(b, room)).collect::<Result<_, Obstacle>>()?;
            Ok((list, inner))
        };
        let kind = match &p.kind {
            Compare(sides, relations) => {
                let sides = sides.iter().map(|e| self.expr_in(e, room)).collect::<Result<_, Obstacle>>()?;
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
                let at: Result<Vec<_>, Obstacle> =
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
            PropKind::WrittenLimit(l) => {
                self.moves(&l.variable.text)?;
                let mut out = (**l).clone();
                for part in out.parts_mut() {
                    *part = self.expr_in(part, room)?;
                }
                PropKind::WrittenLimit(Box::new(out))
            }
        };
        room.leave();
        Ok(Prop { kind, span: p.span })
    }
}

/// Whether a member of a family or sequence occurs.
fn has_member(e: &Expr) -> bool {
    let here = matches!(&e.kind, ExprKind::Apply(f, _) if !is_built_in(&f.text));
    let mut found = here;
    parts(e, &mut |part| found = found || has_member(part));
    found
}
