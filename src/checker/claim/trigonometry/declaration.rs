//! Declarations of angles and hypotheses about them, written out for their cosines and sines.

use super::{Writer, conjunction};
use crate::claim::angle::Bounds;
use crate::claim::circle::{Point, compared};
use crate::claim::matrix::{at, numeral};
use crate::claim::syntax::*;
use crate::claim::walk;

impl Writer<'_> {
    pub(super) fn item(&mut self, item: Item, out: &mut Vec<Item>) {
        match item {
            Item::Given(mut bindings) => {
                let conditions = self.bindings(&mut bindings, true);
                out.push(Item::Given(bindings));
                out.extend(conditions.into_iter().map(|prop| Item::Assume { label: None, prop }));
            }
            Item::Let { name, .. } if self.is_angle(&name.text) => {}
            Item::Assume { label, prop: Prop { kind: PropKind::Compare(sides, relations), span } }
                if self.is_about_angles(&sides) =>
            {
                let mut said = Vec::new();
                for (pair, relation) in sides.windows(2).zip(&relations) {
                    if *relation == Relation::Equal {
                        said.extend(self.relation(&pair[0], &pair[1]));
                    }
                }
                if said.is_empty() && label.is_some() {
                    return self.give_up();
                }
                out.extend(conjunction(said, span).map(|prop| Item::Assume { label, prop }));
            }
            mut other => {
                match &mut other {
                    Item::Assume { prop, .. } => self.prop(prop),
                    Item::Let { parameters, value, .. } => {
                        // A parameter may have the name of an angle elsewhere in the claim.
                        let hidden: Vec<_> =
                            parameters.iter().filter_map(|p| self.angles.remove_entry(&p.text)).collect();
                        self.expr(value);
                        self.angles.extend(hidden);
                    }
                    item => walk::of_item(item, &mut |e| self.expr(e)),
                }
                out.push(other);
            }
        }
    }

    /// Declares cosine and sine in place of every angle that is declared here. Returns what holds of them: c² + s² = 1 and the
    /// bounds.
    pub(super) fn bindings(&mut self, bindings: &mut Vec<Binding>, is_given: bool) -> Vec<Prop> {
        let mut conditions = Vec::new();
        let mut out = Vec::new();
        for mut binding in std::mem::take(bindings) {
            let is_angle = |name: &(Name, Option<Name>)| self.angles.contains_key(&name.0.text);
            let (angles, rest): (Vec<_>, Vec<_>) = std::mem::take(&mut binding.names).into_iter().partition(is_angle);
            let (constraints, span) = (binding.constraints.clone(), binding.span);
            let is_plain = !binding.natural && binding.indices.is_none();
            if !rest.is_empty() {
                binding.names = rest;
                walk::of_binding(&mut binding, &mut |e| self.expr(e));
                out.push(binding);
            }
            for (name, index) in angles {
                if !is_plain || index.is_some() {
                    self.give_up();
                    continue;
                }
                let mut bounds = self.bounds.get(&name.text).filter(|_| is_given).cloned().unwrap_or_default();
                if !constraints.iter().all(|c| self.narrow(&mut bounds, c)) {
                    self.give_up();
                    continue;
                }
                self.bounds.insert(name.text.clone(), bounds.clone());
                let Some(variable) = self.angles.get_mut(&name.text) else { continue };
                variable.is_declared = true;
                let over = variable.over;
                let (cos, sin) = (variable.cos.clone(), variable.sin.clone());
                let part = Point::named(&cos, &sin);
                let value = |text: String| at(name.span, ExprKind::Name(text));
                let names = [&cos, &sin].map(|n| (Name { text: n.clone(), span: name.span }, None)).to_vec();
                out.push(Binding { names, natural: false, constraints: Vec::new(), indices: None, unit: None, span });
                let square = |text: String| {
                    let two = Box::new(numeral(name.span, 2));
                    (Sign::Plus, at(name.span, ExprKind::Power(Box::new(value(text)), two)))
                };
                let squares = at(name.span, ExprKind::Sum(vec![square(cos), square(sin)]));
                conditions.push(compared(squares, Relation::Equal, numeral(name.span, 1)));
                match bounds.conditions(&part, over, span) {
                    Some(list) => conditions.extend(list),
                    None => self.give_up(),
                }
            }
        }
        *bindings = out;
        conditions
    }

    /// Narrows the bounds of an angle by a constraint; whether the constraint is a bound.
    fn narrow(&self, bounds: &mut Bounds, constraint: &Constraint) -> bool {
        let turns = |e: &Expr| self.angle(e).filter(|a| a.of.is_empty()).map(|a| a.turns);
        let closed = |c: bool, or_equal: Relation, strict: Relation| if c { or_equal } else { strict };
        match constraint {
            Constraint::Relation(relation, e) => turns(e).is_some_and(|t| bounds.narrow(*relation, t)),
            Constraint::Interval { from, from_closed, to, to_closed } => match (turns(from), turns(to)) {
                (Some(from), Some(to)) => {
                    bounds.narrow(closed(*from_closed, Relation::GreaterEqual, Relation::Greater), from)
                        && bounds.narrow(closed(*to_closed, Relation::LessEqual, Relation::Less), to)
                }
                _ => false,
            },
            Constraint::Range(..) => false,
        }
    }
}
