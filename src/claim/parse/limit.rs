//! Limits: at infinity, at a point, from one side, and those that are infinite.
//!
//! A limit at infinity with a number as its value is a statement of the language; the others are expanded:
//!
//! | written | stands for |
//! |---|---|
//! | `limit of F as x -> a from above is L` | that of F with a + 1/x for x, as x → ∞ |
//! | `limit of F as x -> a from below is L` | that of F with a − 1/x for x |
//! | `limit of F as x -> a is L` | both |
//! | `limit of F … is infinity` | F > 0 from some x on, and 1/F → 0; `-infinity` with F < 0 |

use super::super::walk;
use super::*;

/// The most nodes of a function, times those of the point that is put into it.
pub(crate) const NODES_LIMIT: usize = 100_000;

/// The stated value of a limit.
enum Target {
    Number(Expr),
    /// Beyond all bounds, upwards or downwards.
    Infinite {
        up: bool,
    },
}

impl Parser {
    /// `of F as x -> a is L`, behind `limit`.
    pub(super) fn limit(&mut self) -> Parsed<Prop> {
        let start = self.span().start;
        self.need_word("of")?;
        let of = self.expr()?;
        self.need_word("as")?;
        let variable = self.name("the variable that moves")?;
        let is_declared = self.declared.contains(&variable.text);
        let domain = self.span();
        let domain_said = self.grows(&variable);
        let natural = domain_said == Some(true);
        self.need_sign("->", "between the variable and where it goes")?;
        let mut sides = vec![of];
        let mut conditions = Vec::new();
        if !self.word("infinity") {
            if is_declared || domain_said.is_some() {
                let message =
                    format!("{} is already declared, so it cannot be the variable of this limit", variable.text);
                let help = "use a new name: the limit itself declares its variable";
                return Err(self.other(
                    &message,
                    Some(help),
                    if domain_said.is_some() { domain } else { variable.span },
                ));
            }
            let point = self.expr()?;
            let mut inside = BTreeSet::new();
            walk::names_in(&sides[0], &mut inside);
            if !inside.contains(&variable.text) {
                // Nothing is left of the point, and it has to have a value.
                let same = PropKind::Compare(vec![point.clone(), point.clone()], vec![Relation::Equal]);
                conditions.push(Prop { kind: same, span: point.span });
            }
            sides = self.sides(sides.remove(0), &variable, point)?;
        }
        self.need_word("is")?;
        let minus =
            matches!(self.peek(), Kind::Sign("-" | "−")) && self.peek_at(1) == &Kind::Word("infinity".to_string());
        if minus {
            self.advance();
        }
        let target = match self.word("infinity") {
            // What is greater than some number has the domain of the variable, which only the limit can say here.
            true if is_declared => {
                let message =
                    format!("{} is already declared, so it cannot be the variable of an infinite limit", variable.text);
                let help = "use a new name, declared by the limit: `as n natural -> infinity`";
                return Err(self.other(&message, Some(help), variable.span));
            }
            true => Target::Infinite { up: !minus },
            false => Target::Number(self.expr()?),
        };
        let span = self.since(start);
        let mut list: Vec<Prop> =
            sides.into_iter().flat_map(|of| says(of, &variable, natural, &target, span)).chain(conditions).collect();
        Ok(match list.len() {
            1 => list.remove(0),
            _ => Prop { kind: PropKind::And(list), span },
        })
    }

    /// The function near a point, on one side or on both, by a variable that grows.
    fn sides(&mut self, of: Expr, variable: &Name, point: Expr) -> Parsed<Vec<Expr>> {
        let mut signs = vec![Sign::Plus, Sign::Minus];
        if self.word("from") {
            let above = self.word("above");
            if !above && !self.word("below") {
                return Err(self.expected("`above` or `below`"));
            }
            signs = vec![if above { Sign::Plus } else { Sign::Minus }];
        }
        let (mut bound, mut inside) = (BTreeSet::new(), BTreeSet::new());
        walk::indices(&of, &mut bound);
        walk::names_in(&point, &mut inside);
        bound.insert(variable.text.clone());
        if let Some(name) = bound.intersection(&inside).next() {
            let message = format!("{name} means one thing in the point and another inside the limit");
            return Err(self.other(&message, Some("give one of them another name"), point.span));
        }
        if walk::nodes_in(&of).saturating_mul(walk::nodes_in(&point)) > NODES_LIMIT {
            let fault = Fault::Limit { name: "nodes of a limit at a point", allowed: NODES_LIMIT };
            self.faults.push(Diagnostic::new(fault, point.span));
            return Err(Reported);
        }
        let at = |kind: ExprKind| Expr { kind, span: variable.span };
        let one = at(ExprKind::Number("1".to_string()));
        let name = at(ExprKind::Name(variable.text.clone()));
        let step = at(ExprKind::Product(vec![(Factor::Times, one), (Factor::Over, name)]));
        let is_zero = matches!(&point.kind, ExprKind::Number(text) if text == "0");
        let near = |sign: Sign| {
            let value = match (is_zero, sign) {
                (false, _) => at(ExprKind::Sum(vec![(Sign::Plus, point.clone()), (sign, step.clone())])),
                (true, Sign::Plus) => step.clone(),
                (true, Sign::Minus) => at(ExprKind::Negate(Box::new(step.clone()))),
            };
            let mut out = of.clone();
            walk::substitute(&mut out, &BTreeMap::from([(variable.text.as_str(), &value)]));
            out
        };
        Ok(signs.into_iter().map(near).collect())
    }
}

/// The statement about a function whose variable grows.
fn says(of: Expr, variable: &Name, natural: bool, target: &Target, span: Span) -> Vec<Prop> {
    let at = |kind: ExprKind| Expr { kind, span };
    let prop = |kind: PropKind| Prop { kind, span };
    let number = |k: u32| at(ExprKind::Number(k.to_string()));
    let limit =
        |of: Expr, value: Expr| prop(PropKind::Limit(Box::new(Limit { of, variable: variable.clone(), value })));
    let up = match target {
        Target::Number(value) => return vec![limit(of, value.clone())],
        Target::Infinite { up } => *up,
    };
    let inverse = at(ExprKind::Product(vec![(Factor::Times, number(1)), (Factor::Over, of.clone())]));
    let name = |end: &str| Name { text: format!("{}_{end}", variable.text), span: variable.span };
    let (from, later) = (name("from"), name("later"));
    let value = |name: &Name| at(ExprKind::Name(name.text.clone()));
    let mut there = of;
    walk::substitute(&mut there, &BTreeMap::from([(variable.text.as_str(), &value(&later))]));
    let binding = |name: &Name, relation: Relation, least: Expr| Binding {
        names: vec![(name.clone(), None)],
        natural,
        constraints: vec![Constraint::Relation(relation, least)],
        indices: None,
        span,
    };
    let relation = if up { Relation::Greater } else { Relation::Less };
    let holds = prop(PropKind::Compare(vec![there, number(0)], vec![relation]));
    let from_there =
        prop(PropKind::ForAll(vec![binding(&later, Relation::GreaterEqual, value(&from))], Box::new(holds)));
    let eventually = prop(PropKind::Exists(vec![binding(&from, Relation::Greater, number(0))], Box::new(from_there)));
    vec![eventually, limit(inverse, number(0))]
}
