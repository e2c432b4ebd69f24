//! Global maxima and minima: the point is in the domain, the value is attained there, and no other
//! point of the domain does better; with `only`, no other point does as well.

use super::context::*;
use super::expand::Substitution;
use super::method::compare;
use crate::claim::print;
use crate::claim::syntax::*;

impl Engine<'_> {
    /// Shows a statement about an extremum.
    pub fn extremum(&mut self, cx: &mut Context, extremum: &Extremum, goal: &Prop) -> Result<(), Failure> {
        let _ = goal;
        let mut at = Substitution::default();
        for (name, value) in &extremum.at {
            self.valued(cx, value)?;
            at.replace(&name.text, value.clone());
        }
        let text: Vec<String> = extremum.at.iter().map(|(n, e)| format!("{} = {}", n.text, print::expr(e))).collect();
        self.line(
            "extremum",
            format!("the point {} lies in the domain and gives {}", text.join(", "), print::expr(&extremum.value)),
        );
        self.deeper(|engine| {
            for binding in &extremum.over {
                if binding.natural || binding.names.iter().any(|n| n.1.is_some()) {
                    return Err(super::translate::fault(binding.span, "extrema are taken over real variables"));
                }
                for prop in super::assume::domain(binding) {
                    let prop = at.prop(&prop)?;
                    engine.show_goal(&mut cx.clone(), &prop)?;
                }
            }
            let there = at.expr(&extremum.of)?;
            engine.show_goal(&mut cx.clone(), &compare(there, Relation::Equal, extremum.value.clone()))
        })?;
        let mut inner = cx.clone();
        self.declare_valued(&mut inner, &extremum.over)?;
        let relation = if extremum.maximum { Relation::LessEqual } else { Relation::GreaterEqual };
        let bound = compare(extremum.of.clone(), relation, extremum.value.clone());
        self.line("extremum", format!("everywhere in the domain {}", print::prop(&bound)));
        self.deeper(|engine| engine.show_goal(&mut inner.clone(), &bound))?;
        if extremum.unique {
            let equal = compare(extremum.of.clone(), Relation::Equal, extremum.value.clone());
            self.line("extremum", "the value is attained nowhere else".to_string());
            self.deeper(|engine| {
                engine.assume(&mut inner, &equal, None, Origin::Hypothesis)?;
                for (name, value) in &extremum.at {
                    let same = compare(name_expr(&name.text), Relation::Equal, value.clone());
                    engine.show_goal(&mut inner.clone(), &same)?;
                }
                Ok::<(), Failure>(())
            })?;
        }
        Ok(())
    }
}
