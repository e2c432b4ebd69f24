//! What expressions were read as, so that none is read twice.
//!
//! Contract: an entry holds what reading the expression again would give. That depends on the names in scope and on the
//! equations that are put in. So entries are kept while the names that were in scope stay, for a few lists of equations;
//! nothing is kept of what was read under a bound index or a name that a step declares for itself.

use super::fraction::Fraction;
use super::known::{Equation, Known, Lesson};
use super::scope::Variable;
use crate::claim::syntax::{Expr, Prop};
use std::collections::{BTreeSet, HashMap};
use std::rc::Rc;

/// A fraction that was read, with the places of the equations that were put in for it.
pub(super) type Entry = (Fraction, Rc<BTreeSet<usize>>);

/// The most lists of equations that something is kept for.
const CONTEXTS: usize = 8;

/// Of so few facts what they say is found anew: a step with few citations stands between steps with many.
const FEW: usize = 8;

/// What was read with the same equations put in.
#[derive(Clone, Default)]
struct Context {
    /// The facts that are put in, and what they say.
    facts: Vec<Rc<Prop>>,
    equations: Rc<Vec<Equation>>,
    entries: HashMap<Expr, Entry>,
    /// What facts say, by their place in memory; they are held, so that the place is theirs.
    lessons: HashMap<*const Prop, (Rc<Prop>, Rc<Vec<Lesson>>)>,
    told: Told,
}

impl Context {
    /// Whether its facts are the first of these.
    fn begins(&self, facts: &[Rc<Prop>]) -> bool {
        self.facts.len() <= facts.len() && self.facts.iter().zip(facts).all(|(a, b)| Rc::ptr_eq(a, b))
    }
}

/// What is known from the last long list of facts that was cited. A copy of a check begins without: it may number atoms in
/// another way.
#[derive(Default)]
struct Told(Option<Known>);

impl Clone for Told {
    fn clone(&self) -> Told {
        Told(None)
    }
}

/// What was read so far.
#[derive(Clone, Default)]
pub(super) struct Memo {
    /// The names that were in scope when the step began.
    scope: Vec<Variable>,
    /// What was read as it stands.
    plain: HashMap<Expr, Entry>,
    /// That of this step last.
    contexts: Vec<Context>,
}

impl Memo {
    /// A step begins, with these names in scope.
    pub(super) fn begin(&mut self, scope: &[Variable]) {
        if !scope.starts_with(&self.scope) {
            self.plain.clear();
            self.contexts.clear();
        }
        if self.scope.len() != scope.len() || !self.scope.starts_with(scope) {
            self.scope = scope.to_vec();
        }
    }

    /// What these facts say as equations, if it is kept; from here on they are put in.
    pub(super) fn equations(&mut self, facts: &[Rc<Prop>]) -> Option<Rc<Vec<Equation>>> {
        let place = self.contexts.iter().rposition(|c| c.facts.len() == facts.len() && c.begins(facts))?;
        let context = self.contexts.remove(place);
        let equations = context.equations.clone();
        self.contexts.push(context);
        Some(equations)
    }

    /// What the first of these facts say as equations, as many as are kept for a list of their own.
    pub(super) fn first_equations(&self, facts: &[Rc<Prop>]) -> Vec<Equation> {
        let longest = self.contexts.iter().filter(|c| c.begins(facts)).max_by_key(|c| c.facts.len());
        longest.map(|c| (*c.equations).clone()).unwrap_or_default()
    }

    /// From here on these equations are put in.
    pub(super) fn put_in(&mut self, facts: Vec<Rc<Prop>>, equations: &Rc<Vec<Equation>>) {
        if self.contexts.len() >= CONTEXTS {
            self.contexts.remove(0);
        }
        self.contexts.push(Context { facts, equations: equations.clone(), ..Context::default() });
    }

    /// What a fact says with the equations of this step put in, if it is kept.
    pub(super) fn lessons(&self, fact: &Rc<Prop>) -> Option<Rc<Vec<Lesson>>> {
        self.contexts.last()?.lessons.get(&Rc::as_ptr(fact)).map(|kept| kept.1.clone())
    }

    /// Keeps what a fact says with the equations of this step put in.
    pub(super) fn keep_lessons(&mut self, fact: &Rc<Prop>, lessons: &Rc<Vec<Lesson>>) {
        if let Some(context) = self.contexts.last_mut() {
            context.lessons.insert(Rc::as_ptr(fact), (fact.clone(), lessons.clone()));
        }
    }

    /// What is known from the first of these facts with the equations of this step put in, if most of them were cited before.
    /// What facts say depends on those before them, not on those behind.
    pub(super) fn told(&mut self, facts: &[Rc<Prop>]) -> Option<Known> {
        let told = &mut self.contexts.last_mut()?.told.0;
        let shared = told.as_ref()?.shared(facts);
        if facts.len() <= FEW || 2 * shared < facts.len() {
            return None;
        }
        let mut known = told.take()?;
        known.only(shared);
        Some(known)
    }

    /// Keeps what was known in a step that ends.
    pub(super) fn keep(&mut self, mut known: Known) {
        let context = self.contexts.last_mut().filter(|c| Rc::ptr_eq(&c.equations, &known.equations));
        if let Some(context) = context
            && known.count() > FEW
        {
            known.only(known.count());
            context.told = Told(Some(known));
        }
    }

    /// The entries for expressions that are read with these names and equations, if any are kept.
    pub(super) fn entries(&mut self, scope: usize, equations: &Rc<Vec<Equation>>) -> Option<&mut HashMap<Expr, Entry>> {
        if scope != self.scope.len() {
            return None;
        }
        if equations.is_empty() {
            return Some(&mut self.plain);
        }
        self.contexts.last_mut().filter(|c| Rc::ptr_eq(&c.equations, equations)).map(|c| &mut c.entries)
    }
}
