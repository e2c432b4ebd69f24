//! sin, cos, tan and π, written out where a claim is read.
//!
//! Contract: after [`write_out`] a claim has no angles. Each angle θ becomes two real variables `cos_theta` and `sin_theta` with
//! cos_theta² + sin_theta² = 1. The claim means the same as before: (c, s) lies on the unit circle if and only if c = cos θ and
//! s = sin θ for some θ, and a claim uses an angle only through its cosine and sine. Two other uses are allowed and written out:
//! bounds of an angle ([`Bounds::conditions`]) and equations between angles ([`Writer::relation`]). Every other use is an error.
//! So search, kernel and exports never see an angle. A proof or a counterexample of the written claim is one of the claim that was
//! meant.
//!
//! | in the claim | written as |
//! |---|---|
//! | `theta in [0, pi/2]` under `given` or in a quantifier | two real variables with `cos_theta^2 + sin_theta^2 = 1`, `sin_theta >= 0`, `cos_theta >= 0` |
//! | `sin(2*theta - pi/3)` | the addition formulas in `cos_theta` and `sin_theta` |
//! | `cos(theta/2)` | `cos_theta_over_2`; θ is then written as twice θ/2 |
//! | `tan(u)` | `sin(u)/cos(u)` |
//! | `sin(pi/12)` | `(sqrt(6) - sqrt(2))/4`; likewise every multiple of π/120 |
//! | `derivative(f, theta)` | the derivative, carried out |
//! | `maximum of f over theta in [0, pi] at theta = pi/2 is M` | `f <= M` for all θ, and `f = M` there |
//! | `let h = theta/2`, `let R(a) = [cos(a), …]` | the definition, put in where it is used |
//!
//! The names are made by [`super::fresh`]: where `cos_theta` is taken, `cos_theta_2` stands for cos θ.
//!
//! A name that the claim declares keeps its own meaning: where `pi` is declared, it is not π.

mod declaration;
mod definitions;
mod derivative;
mod equation;
mod expression;
mod proposition;
mod tied;
mod value;
mod variables;

use super::angle::{Angle, Bounds, Linear};
use super::diagnostic::{Diagnostic, Fault};
use super::fresh::Fresh;
use super::matrix::numeral;
use super::preamble::{applied, declared};
use super::substitution::{Obstacle, Substitution};
use super::syntax::*;
use super::walk;
use std::collections::{BTreeMap, BTreeSet};

/// The functions of an angle.
const WORDS: [&str; 3] = ["sin", "cos", "tan"];

/// The most nodes that are written for one claim.
pub(crate) const NODES_LIMIT: usize = 100_000;

/// Whether this is sin, cos or tan.
pub(crate) fn is_function(name: &str) -> bool {
    WORDS.contains(&name)
}

/// A variable that is an angle: one inside sin, cos or tan, or with bounds in π.
struct Variable {
    /// The denominator d of the part θ/d that gets names for its cosine and sine. Every multiple of θ in the claim is a whole
    /// multiple of θ/d.
    over: u32,
    /// The first place at which it is used as an angle.
    span: Span,
    /// Whether a declaration of it was found.
    is_declared: bool,
    /// The name of the cosine of its part.
    cos: String,
    /// The name of the sine of its part.
    sin: String,
}

/// The state while the angles of one claim are written out.
struct Writer<'a> {
    /// Those of sin, cos and tan that the claim does not declare as names of its own.
    words: Vec<&'static str>,
    /// Whether `pi` is the number π: the claim does not declare it.
    is_pi: bool,
    /// The definitions without parameters that are linear in variables and π, such as `let h = theta/2`.
    definitions: BTreeMap<String, Linear>,
    /// The variables that are angles.
    angles: BTreeMap<String, Variable>,
    /// The bounds of the angles, from hypotheses and declarations.
    bounds: BTreeMap<String, Bounds>,
    /// The equations between angles in the hypotheses, each as a sum that is 0.
    equations: Vec<Angle>,
    /// All other definitions, written out.
    values: Substitution,
    /// The names that take an argument: families, sequences and definitions with parameters.
    applied: BTreeSet<String>,
    /// Names that a hypothesis or a domain ties to each other, definitions put in.
    ties: Vec<BTreeSet<String>>,
    fresh: &'a mut Fresh,
    /// How many nodes were written so far, at most [`NODES_LIMIT`].
    nodes: usize,
    faults: &'a mut Vec<Diagnostic>,
}

/// Writes out every angle of a claim.
pub(super) fn write_out(claim: &mut Claim, fresh: &mut Fresh, faults: &mut Vec<Diagnostic>) {
    let mut own: BTreeSet<String> = claim.items.iter().flat_map(declared).map(|n| n.text.clone()).collect();
    walk::bound_names(claim, &mut |name| {
        own.insert(name.to_string());
    });
    let mut names = BTreeSet::new();
    walk::expressions(claim, &mut |e| walk::names_in(e, &mut names));
    let words: Vec<&str> = WORDS.into_iter().filter(|w| !own.contains(*w)).collect();
    let is_pi = !own.contains(PI);
    let speaks_of_angles = words.iter().any(|w| names.contains(*w)) || is_pi && names.contains(PI);
    if !speaks_of_angles {
        return;
    }
    let mut found = Vec::new();
    let mut writer = Writer {
        words,
        is_pi,
        definitions: BTreeMap::new(),
        angles: BTreeMap::new(),
        bounds: BTreeMap::new(),
        equations: Vec::new(),
        values: Substitution::default(),
        applied: claim.items.iter().flat_map(applied).map(|n| n.text.clone()).collect(),
        ties: Vec::new(),
        fresh,
        nodes: 0,
        faults: &mut found,
    };
    writer.put_in_functions(claim);
    if writer.faults.is_empty() {
        writer.find_angles(claim);
        if writer.differentiates_by_an_angle(claim) {
            writer.find_ties(claim);
        }
    }
    if writer.faults.is_empty() {
        writer.name_cosines_and_sines();
        writer.claim(claim);
    }
    faults.extend(found);
}

impl Writer<'_> {
    fn fault(&mut self, message: String, help: &str, span: Span) {
        let fault = Diagnostic::new(Fault::Other { message, help: Some(help.to_string()) }, span);
        if !self.faults.contains(&fault) {
            self.faults.push(fault);
        }
    }

    fn limit(&mut self, name: &'static str, allowed: usize, span: Span) {
        self.faults.push(Diagnostic::new(Fault::Limit { name, allowed }, span));
    }

    /// `sin(u)`, `cos(u)` or `tan(u)` as the function and its argument u.
    fn function<'e>(&self, e: &'e Expr) -> Option<(&'static str, &'e Expr)> {
        match &e.kind {
            ExprKind::Apply(name, arguments) => {
                let word = self.words.iter().find(|w| **w == name.text)?;
                Some((word, arguments.first()?))
            }
            _ => None,
        }
    }

    /// Whether sin, cos or tan occurs.
    fn has_function(&self, e: &Expr) -> bool {
        let mut found = self.function(e).is_some();
        walk::parts(e, &mut |part| found = found || self.has_function(part));
        found
    }

    /// An angle used outside sin, cos and tan in another way than bounds and equations.
    fn not_about_angles(&mut self, span: Span) {
        let help = "bound an angle by multiples of pi, such as `0 < theta < pi/2`, or equate sums of angles, such as \
                    `alpha + beta + gamma = pi`; write everything else with sin, cos and tan";
        self.fault("an angle cannot be used here".to_string(), help, span);
    }

    /// Why a definition is not put in, or the place of an extremum.
    fn refused(&mut self, obstacle: Obstacle, span: Span) {
        match obstacle {
            Obstacle::Capture(name) => {
                let message = format!("a definition and what it is applied to both use the name {name}");
                self.fault(message, "rename the index in the definition", span);
            }
            Obstacle::Moves(name) => {
                let message = format!("a definition that differentiates by {name} cannot be applied here");
                self.fault(message, "write the derivative out in the definition", span);
            }
            Obstacle::NotAFunction(name) => {
                self.fault(format!("{name} is not a function"), "write a product with `*`", span);
            }
            Obstacle::Limit(_) => self.limit("nodes of angles written out", NODES_LIMIT, span),
        }
    }

    /// A variable used as an angle that is a natural number, a bound index or a family.
    fn cannot_be_an_angle(&mut self, name: &str, span: Span) {
        let help = "declare an angle as a real variable, such as `theta real` or `theta in [0, pi/2]`";
        self.fault(format!("{name} cannot be an angle: it is a natural number or has an index"), help, span);
    }

    /// Writes out declarations, sample, goal and argument.
    fn claim(&mut self, claim: &mut Claim) {
        for item in std::mem::take(&mut claim.items) {
            self.item(item, &mut claim.items);
        }
        self.values(&mut claim.sample, false);
        self.prop(&mut claim.goal);
        self.proof(&mut claim.proof);
        let hidden = self.angles.iter().find(|(_, v)| !v.is_declared).map(|(name, v)| (name.clone(), v.span));
        if let Some((name, span)) = hidden.filter(|_| self.faults.is_empty()) {
            self.cannot_be_an_angle(&name, span);
        }
    }
}

/// A part of an angle by its name and as an expression: `theta`; `theta_over_2`, which is `theta/2`.
fn part_of(variable: &str, over: u32) -> (String, Expr) {
    let span = Span::default();
    let name = Expr { kind: ExprKind::Name(variable.to_string()), span };
    if over == 1 {
        return (variable.to_string(), name);
    }
    let part = ExprKind::Product(vec![(Factor::Times, name), (Factor::Over, numeral(span, over))]);
    (format!("{variable}_over_{over}"), Expr { kind: part, span })
}

/// The conjunction; `None` of an empty list.
fn conjunction(mut list: Vec<Prop>, span: Span) -> Option<Prop> {
    match list.len() {
        0 | 1 => list.pop(),
        _ => Some(Prop { kind: PropKind::And(list), span }),
    }
}
