//! Names: each is declared exactly once, and used according to its declaration.

use super::definedness::is_natural;
use super::diagnostic::{Diagnostic, Fault, binds, nearest};
use super::preamble::Preamble;
use super::syntax::*;
use super::walk;
use std::collections::{BTreeMap, BTreeSet};

/// Functions that [`super::trigonometry`] and [`super::floor`] write out.
const WRITTEN_OUT: [&str; 3] = ["tan", "floor", "ceil"];

/// The kind of a declared name.
#[derive(Clone, Copy, PartialEq)]
enum Role {
    /// A variable or a definition without parameters.
    Value,
    /// A family or a sequence, or a definition with so many parameters.
    Function(usize),
}

struct Names<'a> {
    roles: BTreeMap<String, Role>,
    /// The names that stand for natural numbers.
    natural: BTreeSet<String>,
    /// The names in scope in the order of their declaration: a scope ends by taking back its own.
    scope: Vec<String>,
    /// The names that were reported as declared nowhere: each is one fault.
    missing: BTreeSet<String>,
    faults: &'a mut Vec<Diagnostic>,
}

/// Reports every fault of names in a claim. `pi` needs no declaration.
pub(super) fn check(claim: &Claim, faults: &mut Vec<Diagnostic>) {
    let mut found = Vec::new();
    names(claim, &mut found);
    // The form that stands for `lim(f, x, 0)` or `int(f, x, 0, 1)` declares its variable.
    let is_bound = found.iter().any(|fault| matches!(&fault.fault, Fault::Undeclared { name, .. } if binds(name)));
    let is_variable = |fault: &Diagnostic| match &fault.fault {
        Fault::Undeclared { name, applied, .. } => name.len() == 1 && !applied,
        _ => false,
    };
    faults.extend(found.into_iter().filter(|fault| !(is_pi(fault) || is_bound && is_variable(fault))));
}

/// Whether a fault is that nothing declares `pi`, which needs no declaration.
fn is_pi(fault: &Diagnostic) -> bool {
    matches!(&fault.fault, Fault::Undeclared { name, .. } if name == PI)
}

fn names(claim: &Claim, faults: &mut Vec<Diagnostic>) {
    let mut names = Names::new(faults);
    names.items(&claim.items);
    names.prop(&claim.goal);
    names.proof(&claim.proof);
    names.sample(claim);
    let declared = std::mem::take(&mut names.roles);
    for fault in faults.iter_mut() {
        if let Fault::Undeclared { name, later, .. } = &mut fault.fault {
            *later = declared.contains_key(name);
        }
    }
    let mut seen = BTreeSet::new();
    for cited in &claim.using {
        if !seen.insert(&cited.text) {
            faults.push(Diagnostic::new(Fault::Twice(cited.text.clone()), cited.span));
        }
    }
}

/// Reports every fault of names in a preamble.
pub(super) fn preamble(preamble: &Preamble, faults: &mut Vec<Diagnostic>) {
    let mut found = Vec::new();
    Names::new(&mut found).items(&preamble.items);
    faults.extend(found.into_iter().filter(|fault| !is_pi(fault)));
}

/// The names that a claim uses and does not declare.
pub(crate) fn undeclared(claim: &Claim) -> BTreeSet<String> {
    let mut faults = Vec::new();
    names(claim, &mut faults);
    missing(faults)
}

/// The names that a declaration or hypothesis uses and does not declare, and those that it declares.
pub(crate) fn names_of(item: &Item) -> BTreeSet<String> {
    let mut faults = Vec::new();
    Names::new(&mut faults).items(std::slice::from_ref(item));
    missing(faults)
}

fn missing(faults: Vec<Diagnostic>) -> BTreeSet<String> {
    let name = |fault: Diagnostic| match fault.fault {
        Fault::Undeclared { name, .. } => Some(name),
        _ => None,
    };
    faults.into_iter().filter_map(name).collect()
}

impl<'a> Names<'a> {
    fn new(faults: &'a mut Vec<Diagnostic>) -> Names<'a> {
        Names { roles: BTreeMap::new(), natural: BTreeSet::new(), scope: Vec::new(), missing: BTreeSet::new(), faults }
    }
}

impl Names<'_> {
    fn items(&mut self, items: &[Item]) {
        items.iter().for_each(|item| self.item(item));
    }

    fn item(&mut self, item: &Item) {
        let names = self;
        match item {
            Item::Given(bindings) => names.bindings(bindings, Names::declare),
            Item::Let { name, parameters, value } => {
                let outside = names.scope.len();
                for parameter in parameters {
                    names.bind(parameter, Role::Value);
                }
                names.expr(value);
                names.leave(outside);
                let role = if parameters.is_empty() { Role::Value } else { Role::Function(parameters.len()) };
                if parameters.is_empty() && names.is_natural(value) {
                    names.natural.insert(name.text.clone());
                }
                names.declare(name, role);
            }
            Item::Define { name, initial, index, step, .. } => {
                names.expr(initial);
                names.declare(name, Role::Function(1));
                let outside = names.scope.len();
                names.bind(index, Role::Value);
                names.natural.insert(index.text.clone());
                names.expr(step);
                names.leave(outside);
            }
            Item::Assume { prop, .. } => names.prop(prop),
        }
    }

    /// A sample gives values to variables, in numbers alone.
    fn sample(&mut self, claim: &Claim) {
        let mut seen = BTreeSet::new();
        for (name, value) in &claim.sample {
            if !seen.insert(&name.text) {
                self.faults.push(Diagnostic::new(Fault::Twice(name.text.clone()), name.span));
            }
            self.used(&name.text, Role::Value, name.span);
            let mut inside = BTreeSet::new();
            walk::names_in(value, &mut inside);
            let is_number = |n: &str| n == PI || is_built_in(n);
            if let Some(other) = inside.iter().find(|n| !is_number(n)) {
                let message = format!("the sample value of {} mentions {other}", name.text);
                let help = Some("give a number, such as 3/5 or sqrt(2)".to_string());
                self.faults.push(Diagnostic::new(Fault::Other { message, help }, value.span));
            }
        }
    }

    /// Declares a bound name, which cannot be `pi`.
    fn bind(&mut self, name: &Name, role: Role) {
        if name.text == PI {
            self.faults.push(Diagnostic::new(Fault::Pi, name.span));
        } else {
            self.declare(name, role);
        }
    }

    /// Declares a name, bound ones included. A name has one meaning at a place: nothing is hidden by another of the
    /// same name, so that text can be put in place of a name without a change of meaning.
    fn declare(&mut self, name: &Name, role: Role) {
        if name.text == PI && self.faults.iter().any(is_pi) {
            let message = "pi is used as the number π before it is declared".to_string();
            let help = Some("declare it first, or choose another name".to_string());
            self.faults.push(Diagnostic::new(Fault::Other { message, help }, name.span));
        } else if is_built_in(&name.text) {
            let message = format!("{} is a built-in function", name.text);
            let fault = Fault::Other { message, help: Some("choose another name".to_string()) };
            self.faults.push(Diagnostic::new(fault, name.span));
        } else if self.roles.contains_key(&name.text) {
            self.faults.push(Diagnostic::new(Fault::Twice(name.text.clone()), name.span));
        } else {
            self.roles.insert(name.text.clone(), role);
            self.scope.push(name.text.clone());
        }
    }

    /// Ends a scope: only the first `outside` names stay.
    fn leave(&mut self, outside: usize) {
        for name in self.scope.drain(outside..) {
            self.roles.remove(&name);
            self.natural.remove(&name);
        }
    }

    /// Declares the names of bindings, each in this way.
    fn bindings(&mut self, bindings: &[Binding], declare: fn(&mut Self, &Name, Role)) {
        for binding in bindings {
            for (name, index) in &binding.names {
                let outside = self.scope.len();
                if let Some(index) = index {
                    self.bind(index, Role::Value);
                    self.natural.insert(index.text.clone());
                }
                for constraint in &binding.constraints {
                    match constraint {
                        Constraint::Relation(_, e) => self.expr(e),
                        Constraint::Interval { from, to, .. } => {
                            self.expr(from);
                            self.expr(to);
                        }
                        Constraint::Range(from, to) => {
                            self.expr(from);
                            self.expr(to);
                            self.begins_at_0(&name.text, from);
                        }
                    }
                }
                self.leave(outside);
                if let Some((from, to)) = &binding.indices {
                    self.expr(from);
                    self.expr(to);
                    self.begins_at_0(&format!("the index of {}", name.text), from);
                }
                if binding.natural {
                    self.natural.insert(name.text.clone());
                }
                declare(self, name, if index.is_some() { Role::Function(1) } else { Role::Value });
            }
        }
    }

    fn is_natural(&self, e: &Expr) -> bool {
        is_natural(e, &|name| self.natural.contains(name))
    }

    /// A range contains natural numbers only, so it must not begin below 0: the author of -2..2 means -2 too.
    fn begins_at_0(&mut self, what: &str, from: &Expr) {
        if !self.is_natural(from) {
            let from_text = super::print::expr(from);
            let message = format!("the range of {what} must begin at a natural number, but {from_text} may be below 0");
            let help =
                "begin the range at 0, 1, n or a sum of these; or write `k natural >= n - 1 and <= m`".to_string();
            self.faults.push(Diagnostic::new(Fault::Other { message, help: Some(help) }, from.span));
        }
    }

    fn used(&mut self, name: &str, role: Role, span: Span) {
        match self.roles.get(name) {
            None if self.missing.contains(name) => {}
            None => {
                self.missing.insert(name.to_string());
                let mut known: Vec<&str> = self.roles.keys().map(String::as_str).collect();
                if role != Role::Value {
                    FUNCTIONS.iter().for_each(|f| known.push(f.0));
                    super::abbreviation::names().for_each(|f| known.push(f));
                    WRITTEN_OUT.iter().for_each(|f| known.push(f));
                }
                // Another variable is no typing error of a letter.
                known.retain(|near| name.len() > 1 || near.len() > 1);
                let nearest = nearest(name, known);
                let fault =
                    Fault::Undeclared { name: name.to_string(), nearest, applied: role != Role::Value, later: false };
                self.faults.push(Diagnostic::new(fault, span));
            }
            Some(declared) if *declared == role => {}
            Some(declared) => {
                let (message, help) = match (declared, role) {
                    (Role::Value, _) => {
                        (format!("{name} is a variable, not a function"), format!("for a product write {name}*(…)"))
                    }
                    (Role::Function(1), Role::Value) => {
                        (format!("{name} needs an index or argument"), format!("write {name}(k)"))
                    }
                    (Role::Function(n), _) => (format!("{name} takes {n} arguments"), format!("give {n}")),
                };
                self.faults.push(Diagnostic::new(Fault::Other { message, help: Some(help) }, span));
            }
        }
    }

    fn expr(&mut self, expr: &Expr) {
        match &expr.kind {
            ExprKind::Name(name) => self.used(name, Role::Value, expr.span),
            ExprKind::Apply(name, arguments) => {
                let abbreviation = match self.roles.contains_key(&name.text) {
                    true => None,
                    false if super::trigonometry::is_function(&name.text) || super::floor::is_function(&name.text) => {
                        Some((1, 1))
                    }
                    false => super::abbreviation::arguments(&name.text),
                };
                match FUNCTIONS.iter().find(|f| f.0 == name.text) {
                    Some((_, n)) if *n == arguments.len() => {}
                    Some((_, n)) => {
                        let message = format!("{} takes {n} argument", name.text);
                        self.faults.push(Diagnostic::new(Fault::Other { message, help: None }, name.span));
                    }
                    None => match abbreviation {
                        Some((least, most)) if (least..=most).contains(&arguments.len()) => {}
                        Some((least, most)) => {
                            let number = if least == most { least.to_string() } else { format!("{least} to {most}") };
                            let message =
                                format!("{} takes {number} argument{}", name.text, if most == 1 { "" } else { "s" });
                            self.faults.push(Diagnostic::new(Fault::Other { message, help: None }, name.span));
                        }
                        None => self.used(&name.text, Role::Function(arguments.len()), name.span),
                    },
                }
                arguments.iter().for_each(|a| self.expr(a));
            }
            ExprKind::SumOver(index, body)
            | ExprKind::ProductOver(index, body)
            | ExprKind::IntegralOver(index, body) => {
                self.expr(&index.from);
                self.expr(&index.to);
                let outside = self.scope.len();
                self.bind(&index.name, Role::Value);
                if !matches!(expr.kind, ExprKind::IntegralOver(..)) && self.is_natural(&index.from) {
                    self.natural.insert(index.name.text.clone());
                }
                self.expr(body);
                self.leave(outside);
            }
            ExprKind::Derivative(body, by) => {
                self.expr(body);
                by.iter().for_each(|n| self.used(&n.text, Role::Value, n.span));
            }
            ExprKind::Number(_) => {}
            ExprKind::Negate(a) => self.expr(a),
            ExprKind::Sum(list) => list.iter().for_each(|(_, e)| self.expr(e)),
            ExprKind::Product(list) => list.iter().for_each(|(_, e)| self.expr(e)),
            ExprKind::Power(a, b) => {
                self.expr(a);
                self.expr(b);
            }
            ExprKind::Matrix(rows) => rows.iter().flatten().for_each(|e| self.expr(e)),
        }
    }

    fn prop(&mut self, prop: &Prop) {
        match &prop.kind {
            PropKind::Compare(sides, _) => sides.iter().for_each(|e| self.expr(e)),
            PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => {
                list.iter().for_each(|p| self.prop(p));
            }
            PropKind::Not(p) => self.prop(p),
            PropKind::Implies(p, q) => {
                self.prop(p);
                self.prop(q);
            }
            PropKind::Exists(bindings, body) | PropKind::ForAll(bindings, body) => {
                let outside = self.scope.len();
                self.bindings(bindings, Names::bind);
                self.prop(body);
                self.leave(outside);
            }
            PropKind::Extremum(extremum) => {
                extremum.at.iter().for_each(|(_, e)| self.expr(e));
                self.expr(&extremum.value);
                let outside = self.scope.len();
                self.bindings(&extremum.over, Names::bind);
                self.expr(&extremum.of);
                self.leave(outside);
                let over: Vec<&Name> = extremum.over.iter().flat_map(|b| b.names.iter().map(|n| &n.0)).collect();
                let same = over.len() == extremum.at.len()
                    && over.iter().all(|n| extremum.at.iter().any(|(m, _)| m.text == n.text));
                if !same {
                    let message = "`at` gives one value for each variable under `over`".to_string();
                    self.faults.push(Diagnostic::new(Fault::Other { message, help: None }, prop.span));
                }
            }
            PropKind::Limit(limit) => {
                self.used(&limit.variable.text, Role::Value, limit.variable.span);
                self.expr(&limit.of);
                self.expr(&limit.value);
            }
            PropKind::WrittenLimit(limit) => {
                self.used(&limit.variable.text, Role::Value, limit.variable.span);
                limit.parts().for_each(|e| self.expr(e));
            }
        }
    }

    fn proof(&mut self, proof: &Proof) {
        let outside = self.scope.len();
        for step in &proof.steps {
            match step {
                Step::Have { prop, proof, .. } | Step::Case { prop, proof, .. } => {
                    self.prop(prop);
                    self.proof(proof);
                }
                Step::Obtain { binding, prop, witness, .. } => {
                    self.expr(witness);
                    self.bindings(std::slice::from_ref(binding), Names::bind);
                    self.prop(prop);
                }
            }
        }
        match &proof.close {
            Some(Method::Power { exponent, .. }) => self.expr(exponent),
            Some(Method::Product(list)) => list.iter().filter_map(|p| p.1.as_ref()).for_each(|e| self.expr(e)),
            Some(Method::Mean { a, b, weight }) => [a, b, weight].into_iter().for_each(|e| self.expr(e)),
            Some(Method::Hoelder { first, second, weight }) => {
                [&first.0, &first.1, &second.0, &second.1, weight].into_iter().for_each(|e| self.expr(e));
            }
            Some(Method::Instance { with, .. } | Method::Witness(with)) => {
                for (_, e) in with {
                    let renames_family =
                        matches!(&e.kind, ExprKind::Name(n) if matches!(self.roles.get(n), Some(Role::Function(1))));
                    if !renames_family {
                        self.expr(e);
                    }
                }
            }
            Some(Method::Squeeze { lower, upper }) => {
                self.expr(lower);
                self.expr(upper);
            }
            Some(Method::Induction(_, step)) => self.proof(step),
            Some(Method::Algebra(_)) | None => {}
        }
        self.leave(outside);
    }
}
