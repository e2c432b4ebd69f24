//! The rules of logic: instances, induction, and what follows from facts by the propositions' form.

use super::identity::Side;
use super::*;

impl Writer<'_> {
    pub(super) fn induction(&mut self, goal: &Prop, base: &str, advance: &str) -> Found<String> {
        let PropKind::ForAll(bindings, _) = &goal.kind else {
            return Err(Open::Untranslated("induction".to_string(), "a goal for all"));
        };
        let bound = bindings.first().and_then(|b| b.constraints.first()).is_some();
        let lemma = if bound { "induct_from" } else { "induct" };
        Ok(format!("{lemma} {} {}", fact(base), fact(advance)))
    }

    /// The facts and the goal with expressions and other statements as variables, and what these stand for.
    pub(super) fn logic(&mut self, goal: &Prop, from: &[Label]) -> Found<String> {
        let mut parts = Skeleton::default();
        let mut premises = String::new();
        for label in from {
            let p = self.fact_prop(label)?;
            premises += &format!("{} -> ", self.skeleton(&p, &mut parts)?);
        }
        let conclusion = self.skeleton(goal, &mut parts)?;
        let mut statement = String::from("forall");
        for (place, kind) in parts.list.iter().map(|(_, _, kind)| kind).enumerate() {
            statement += &format!(" (x__{place} : {kind})");
        }
        let body = format!("{premises}{conclusion}");
        let statement = if parts.list.is_empty() { body } else { format!("{statement}, {body}") };
        let values: Vec<String> = parts.list.iter().map(|(_, text, _)| text.clone()).collect();
        let facts: Vec<String> = from.iter().map(|f| fact(f)).collect();
        Ok(format!(
            "assert (z__ : {statement}) by (clear; logic); exact (z__ {} {})",
            values.join(" "),
            facts.join(" ")
        ))
    }

    pub(super) fn skeleton(&mut self, p: &Prop, parts: &mut Skeleton) -> Found<String> {
        Ok(match &p.kind {
            PropKind::Compare(sides, relations) => {
                let mut out = Vec::new();
                for (pair, relation) in sides.windows(2).zip(relations) {
                    let [a, b] = pair else { continue };
                    let contrary = *relation == Relation::NotEqual;
                    if matches!(a.kind, ExprKind::Derivative(..)) && (contrary || *relation == Relation::Equal) {
                        let text = self.prop(&compare(a.clone(), Relation::Equal, b.clone()))?;
                        let word = parts.get(text, "Prop");
                        out.push(if contrary { format!("~ {word}") } else { word });
                        continue;
                    }
                    let sign = match relation {
                        Relation::Equal => "=",
                        Relation::NotEqual => "<>",
                        Relation::Less => "<",
                        Relation::LessEqual => "<=",
                        Relation::Greater => ">",
                        Relation::GreaterEqual => ">=",
                    };
                    let a = self.skeleton_side(a, parts)?;
                    let b = self.skeleton_side(b, parts)?;
                    out.push(format!("{a} {sign} {b}"));
                }
                format!("({})", out.join(" /\\ "))
            }
            PropKind::And(list) | PropKind::Or(list) => {
                let sign = if matches!(p.kind, PropKind::And(_)) { " /\\ " } else { " \\/ " };
                let list = list.iter().map(|p| self.skeleton(p, parts)).collect::<Found<Vec<_>>>()?;
                format!("({})", list.join(sign))
            }
            PropKind::Not(inner) => format!("(~ {})", self.skeleton(inner, parts)?),
            PropKind::Implies(a, b) => format!("({} -> {})", self.skeleton(a, parts)?, self.skeleton(b, parts)?),
            PropKind::Equivalent(list) => {
                let list = list.iter().map(|p| self.skeleton(p, parts)).collect::<Found<Vec<_>>>()?;
                let pairs: Vec<String> = list
                    .windows(2)
                    .filter_map(|pair| Some(format!("({} <-> {})", pair.first()?, pair.get(1)?)))
                    .collect();
                match pairs.as_slice() {
                    [one] => one.clone(),
                    _ => format!("({})", pairs.join(" /\\ ")),
                }
            }
            _ => {
                let text = self.prop(p)?;
                parts.get(text, "Prop")
            }
        })
    }

    pub(super) fn skeleton_side(&mut self, e: &Expr, parts: &mut Skeleton) -> Found<String> {
        if matches!(e.kind, ExprKind::Number(_)) {
            return self.expr(e);
        }
        if self.checker.is_matrix(e) {
            let text = at(self.printer.matrix(e)?, ATOM);
            return Ok(parts.get(text, "matrix"));
        }
        let text = self.expr(e)?;
        Ok(parts.get(text, "R"))
    }

    pub(super) fn instance(
        &mut self,
        show: &Show,
        source: &str,
        with: &[(Name, Expr)],
        from: &[Label],
        given: &Given,
    ) -> Found<String> {
        let is_fact = self.checker.facts().any(|f| f.0 == source);
        let mut out = String::new();
        // Each once: two premises may be one fact.
        for (place, label) in from.iter().enumerate() {
            if !from[..place].contains(label) {
                out += &format!("assert (y__{label} := {}); ", fact(label));
            }
        }
        let value = |text: &str| with.iter().find(|w| w.0.text == text).map_or_else(|| name(text), |w| w.1.clone());
        if is_fact {
            let p = self.fact_prop(source)?;
            let PropKind::ForAll(bindings, _) = &p.kind else {
                return Err(Open::Untranslated(show.label.clone(), "an instance of no statement for all"));
            };
            out += &format!("assert (z__ := {}); ", fact(source));
            for binding in bindings {
                self.domain(binding, &value, given)?;
                for (n, _) in &binding.names {
                    let text = self.value(&value(&n.text), binding.natural)?;
                    out += &format!("give z__ {text}; ");
                }
            }
            return Ok(format!("{out}premises z__; same z__"));
        }
        let Some(claim) = (self.claims)(source) else {
            return Err(Open::Untranslated(show.label.clone(), "a cited claim that is not there"));
        };
        self.cites.insert(source.to_string());
        let word = identifier(source);
        out += &format!("assert (z__ := {word}.{word}); cbv beta zeta in z__; ");
        let mut domains = Vec::new();
        for item in &claim.items {
            match item {
                Item::Given(bindings) => {
                    for binding in bindings {
                        for (n, index) in &binding.names {
                            let text = match index {
                                Some(_) => {
                                    let family = match value(&n.text).kind {
                                        ExprKind::Name(family) => family,
                                        _ => n.text.clone(),
                                    };
                                    self.printer.word(&family)
                                }
                                None => self.value(&value(&n.text), binding.natural)?,
                            };
                            out += &format!("give z__ {text}; ");
                        }
                        domains.push(binding.clone());
                    }
                }
                Item::Define { name, .. } => {
                    let text = self.printer.word(&name.text);
                    out += &format!("give z__ {text}; ");
                }
                Item::Let { .. } | Item::Assume { .. } => {}
            }
        }
        for binding in &domains {
            self.domain(binding, &value, given)?;
        }
        Ok(format!("{out}premises z__; same z__"))
    }

    pub(super) fn value(&mut self, e: &Expr, natural: bool) -> Found<String> {
        if natural {
            return Ok(format!("{}%nat", at(self.printer.natural(e)?, ATOM)));
        }
        self.expr(e)
    }

    /// Asserts what the domain of a binding says of values, where signs show it.
    pub(super) fn domain(&mut self, binding: &Binding, value: &dyn Fn(&str) -> Expr, given: &Given) -> Found<()> {
        for (n, index) in &binding.names {
            if index.is_some() {
                continue;
            }
            for p in constraints(binding, &value(&n.text)) {
                self.comparison(&p, given)?;
            }
        }
        Ok(())
    }

    /// Asserts a comparison, where signs show it.
    pub(super) fn comparison(&mut self, p: &Prop, given: &Given) -> Found<()> {
        let (a, relation, b) = self.sides(p, "instance")?;
        let (Ok(x), Ok(y)) = (self.checker.read(a, &given.using), self.checker.read(b, &given.using)) else {
            return Ok(());
        };
        let f = self.checker.difference_of(&x, &y)?;
        if !self.checker.signs(&f, &given.signed)?.within(Signs::of(relation)) {
            return Ok(());
        }
        let side = Side::Expr(a.clone()).minus(Side::Expr(b.clone()));
        let (text_a, text_b) = (self.expr(a)?, self.expr(b)?);
        let h = self.sign(&format!("{text_a} - {text_b}"), &side, &given.using, &f, Signs::of(relation), given)?;
        let text = self.prop(p)?;
        self.lemma("B", &text, &format!("exact (to_{} _ _ {h})", lower(relation)));
        Ok(())
    }
}

/// The variables that stand for expressions and statements: what they stand for, as text, and their type.
#[derive(Default)]
pub(super) struct Skeleton {
    list: Vec<(String, String, &'static str)>,
}

impl Skeleton {
    pub(super) fn get(&mut self, text: String, kind: &'static str) -> String {
        let place = self.list.iter().position(|part| part.0 == text).unwrap_or_else(|| {
            self.list.push((text.clone(), format!("({text})"), kind));
            self.list.len() - 1
        });
        format!("x__{place}")
    }
}
