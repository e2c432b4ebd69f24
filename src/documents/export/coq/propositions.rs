//! Propositions: comparisons, quantifiers, extrema and limits.

use super::super::kinds::{Kind, is_matrix, is_natural};
use super::super::values::Collector;
use super::super::{Result, Unsupported, unsupported};
use super::expressions::same_variable;
use super::printer::*;
use super::words::mentions;
use crate::claim::syntax::*;

impl Printer {
    pub(super) fn comparison(&mut self, a: &Expr, relation: Relation, b: &Expr) -> Result<Text> {
        let sign = match relation {
            Relation::Equal => "=",
            Relation::NotEqual => "<>",
            Relation::Less => "<",
            Relation::LessEqual => "<=",
            Relation::Greater => ">",
            Relation::GreaterEqual => ">=",
        };
        if let (ExprKind::Derivative(..), Relation::NotEqual, true) = (&a.kind, relation, self.inside) {
            // The contrary of the equation, so that the rules of logic see the one in the other.
            let (equal, _) = self.comparison(a, Relation::Equal, b)?;
            return Ok((format!("~ ({equal})"), NOT));
        }
        if let (ExprKind::Derivative(body, by), Relation::Equal) = (&a.kind, relation) {
            let (name, order) = same_variable(by, a.span)?;
            let (function, x, value) = (self.function_of(body, name)?, self.word(&name.text), self.real_at(b, ATOM)?);
            let text = match order {
                1 => format!("is_derive {function} {x} {value}"),
                _ => format!("is_derive_n {function} {order} {x} {value}"),
            };
            return Ok((text, APPLICATION));
        }
        if is_matrix(a, &self.kinds) || is_matrix(b, &self.kinds) {
            let (a, b) = (self.matrix(a)?, self.matrix(b)?);
            return match relation {
                Relation::Equal | Relation::NotEqual => {
                    Ok((format!("{} {sign} {}", at(a, APPLICATION), at(b, APPLICATION)), COMPARISON))
                }
                _ => unsupported(Span::default(), "an order of matrices"),
            };
        }
        let symbolic = |e: &Expr| !matches!(e.kind, ExprKind::Number(_));
        if !self.inside && is_natural(a, &self.kinds) && is_natural(b, &self.kinds) && (symbolic(a) || symbolic(b)) {
            let (a, b) = (at(self.natural(a)?, SUM), at(self.natural(b)?, SUM));
            return Ok((format!("({a} {sign} {b})%nat"), ATOM));
        }
        Ok((format!("{} {sign} {}", self.real_at(a, SUM)?, self.real_at(b, SUM)?), COMPARISON))
    }

    pub(super) fn prop_at(&mut self, prop: &Prop, most: u8) -> Result<String> {
        Ok(at(self.prop(prop)?, most))
    }

    pub(super) fn props(&mut self, list: &[Prop], sign: &str, least: u8) -> Result<String> {
        let parts: Vec<String> = list.iter().map(|p| self.prop_at(p, least - 1)).collect::<Result<_>>()?;
        Ok(parts.join(sign))
    }

    pub(super) fn prop(&mut self, prop: &Prop) -> Result<Text> {
        Ok(match &prop.kind {
            PropKind::Compare(sides, relations) => {
                let mut parts = Vec::new();
                for (pair, relation) in sides.windows(2).zip(relations) {
                    if let [a, b] = pair {
                        parts.push(self.comparison(a, *relation, b)?);
                    }
                }
                match <[Text; 1]>::try_from(parts) {
                    Ok([one]) => one,
                    Err(parts) => (parts.into_iter().map(|t| at(t, AND - 1)).collect::<Vec<_>>().join(" /\\ "), AND),
                }
            }
            PropKind::And(list) => (self.props(list, " /\\ ", AND)?, AND),
            PropKind::Or(list) => (self.props(list, " \\/ ", OR)?, OR),
            PropKind::Not(p) => (format!("~ {}", self.prop_at(p, APPLICATION)?), NOT),
            PropKind::Implies(p, q) => (format!("{} -> {}", self.prop_at(p, AND)?, self.prop_at(q, AND)?), IMPLIES),
            PropKind::Equivalent(list) => {
                let mut pairs = Vec::new();
                for pair in list.windows(2) {
                    if let [p, q] = pair {
                        pairs.push(format!("{} <-> {}", self.prop_at(p, OR)?, self.prop_at(q, OR)?));
                    }
                }
                match pairs.as_slice() {
                    [one] => (one.clone(), IFF),
                    _ => (pairs.iter().map(|p| format!("({p})")).collect::<Vec<_>>().join(" /\\ "), AND),
                }
            }
            PropKind::Exists(bindings, body) => self.within_bindings(bindings, |p| {
                let mut out = String::new();
                for binding in bindings {
                    out.push_str(&format!("exists {}, ", p.binders(binding)?));
                    for hypothesis in p.hypotheses(binding)? {
                        out.push_str(&format!("{hypothesis} /\\ "));
                    }
                }
                // That the body has a value is part of what exists.
                let placed =
                    p.definitions.prop(body).map_err(|obstacle| Unsupported::not_put_in(obstacle, body.span))?;
                let mut values = Collector::new(&p.kinds, &p.positive);
                values.prop(&placed)?;
                for need in p.conditions(&values.found)? {
                    out.push_str(&format!("{need} /\\ "));
                }
                out.push_str(&p.prop_at(body, AND)?);
                Ok((out, BINDER))
            })?,
            PropKind::ForAll(bindings, body) => self.within_bindings(bindings, |p| {
                let mut out = p.all_given(bindings)?;
                out.push_str(&p.prop_at(body, IMPLIES)?);
                Ok((out, BINDER))
            })?,
            PropKind::Extremum(extremum) => self.extremum(extremum)?,
            PropKind::Limit(limit) => self.limit(limit)?,
            PropKind::WrittenLimit(_) => return unsupported(prop.span, "a limit as it is written"),
        })
    }

    /// The point lies in the domain and has the value; nothing in the domain has a larger one (for a
    /// maximum); with `only`, no other point has it.
    fn extremum(&mut self, extremum: &Extremum) -> Result<Text> {
        let names: Vec<&Name> = extremum.over.iter().flat_map(|b| b.names.iter().map(|n| &n.0)).collect();
        let mut point = Vec::new();
        for name in &names {
            match extremum.at.iter().find(|(n, _)| n.text == name.text) {
                Some((_, value)) => point.push(value),
                None => return unsupported(name.span, "an extremum without its point"),
            }
        }
        let f = self.word(&self.free_name("f"));
        let mut parts = Vec::new();
        let (mut binders, mut words) = (Vec::new(), Vec::new());
        for binding in &extremum.over {
            if binding.natural {
                return unsupported(binding.span, "an extremum over natural numbers");
            }
            binders.push(self.binders(binding)?);
            words.extend(binding.names.iter().map(|n| self.word(&n.0.text)));
            for (name, _) in &binding.names {
                if let Some((_, value)) = extremum.at.iter().find(|(n, _)| n.text == name.text) {
                    for constraint in &binding.constraints {
                        parts.push(self.constraint(value, false, constraint)?);
                    }
                }
            }
        }
        let arguments: Vec<String> = point.iter().map(|e| self.real_at(e, ATOM)).collect::<Result<_>>()?;
        let value = self.real_at(&extremum.value, SUM)?;
        parts.push(format!("{f} {} = {value}", arguments.join(" ")));
        let sign = if extremum.maximum { "<=" } else { ">=" };
        let (of, domain) = self.within_bindings(&extremum.over, |p| {
            let mut domain = String::new();
            for binding in &extremum.over {
                domain.push_str(&format!("{} ", p.given(binding)?));
            }
            Ok((p.real(&extremum.of)?.0, domain))
        })?;
        let here = format!("{f} {}", words.join(" "));
        let mut all = format!("{here} {sign} {value}");
        if extremum.unique {
            let same: Vec<String> = words
                .iter()
                .zip(&point)
                .map(|(w, e)| Ok(format!("{w} = {}", self.real_at(e, SUM)?)))
                .collect::<Result<_>>()?;
            all = format!("{all} /\\ ({here} = {value} -> {})", same.join(" /\\ "));
        }
        parts.push(format!("({domain}{all})"));
        Ok((format!("let {f} := fun {} => {of} in\n{}", binders.join(" "), parts.join(" /\\\n")), BINDER))
    }

    /// A name that the claim does not use.
    fn free_name(&self, wish: &str) -> String {
        let mut name = wish.to_string();
        while self.kinds.contains_key(&name) || self.words.contains_key(&name) {
            name.push('_');
        }
        name
    }

    fn limit(&mut self, limit: &Limit) -> Result<Text> {
        let of = self.in_place(&limit.of)?;
        let value = self.real_at(&limit.value, ATOM)?;
        let x = self.word(&limit.variable.text);
        if !self.inside && self.tied.iter().any(|text| mentions(text, &x)) {
            return unsupported(limit.variable.span, "a limit by a variable that a hypothesis restricts");
        }
        match self.kinds.get(&limit.variable.text) {
            Some(Kind::Natural) => {
                Ok((format!("is_lim_seq (fun {x} : nat => {}) {value}", self.real(&of)?.0), APPLICATION))
            }
            Some(Kind::Real) => {
                Ok((format!("is_lim (fun {x} : R => {}) p_infty {value}", self.real(&of)?.0), APPLICATION))
            }
            _ => unsupported(limit.variable.span, "a limit by what is no variable"),
        }
    }
}
