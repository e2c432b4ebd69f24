//! sin, cos, tan and π, written out where a claim is read.
//!
//! Contract: [`write_out`] leaves a claim as its author wrote it, but for `tan(u)`, unless every use of sin, cos and π in it is one of
//! an angle. Otherwise it has no angles afterwards. Each angle θ becomes two real variables `cos_theta` and `sin_theta` with
//! cos_theta² + sin_theta² = 1. The claim means the same as before: (c, s) lies on the unit circle if and only if c = cos θ and
//! s = sin θ for some θ, and a claim uses an angle only through its cosine and sine. Two other uses are allowed and written out:
//! bounds of an angle ([`Bounds::conditions`]) and equations between angles ([`Writer::relation`]). A proof or a counterexample of the written claim is one of the claim that was
//! meant.
//!
//! | in the claim | written as |
//! |---|---|
//! | `theta in [0, pi/2]` under `given` or in a quantifier | two real variables with `cos_theta^2 + sin_theta^2 = 1`, `sin_theta >= 0`, `cos_theta >= 0` |
//! | `sin(2*theta - pi/3)` | the addition formulas in `cos_theta` and `sin_theta` |
//! | `cos(theta/2)` | `cos_theta_over_2`; θ is then written as twice θ/2 |
//! | `tan(u)` | `sin(u)/cos(u)` |
//! | `sin(pi/12)` | `(sqrt(6) - sqrt(2))/4`; likewise every multiple of π/120 |
//! | `maximum of f over theta in [0, pi] at theta = pi/2 is M` | `f <= M` for all θ, and `f = M` there |
//! | `let h = theta/2`, `let R(a) = [cos(a), …]` | the definition, put in where it is used |
//!
//! The names are made by [`super::fresh`]: where `cos_theta` is taken, `cos_theta_2` stands for cos θ.
//!
//! A name that the claim declares keeps its own meaning: where `pi` is declared, it is not π.

mod declaration;
mod definitions;
mod equation;
mod expression;
mod proposition;
mod value;
mod variables;

use super::angle::{Angle, Bounds, Linear};
use super::fresh::Fresh;
use super::matrix::{apply, numeral};
use super::preamble::declared;
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
    fresh: &'a mut Fresh,
    /// How many nodes were written so far, at most [`NODES_LIMIT`].
    nodes: usize,
    /// Whether every use so far is one of an angle.
    is_possible: bool,
}

/// Writes out every angle of a claim. Where a variable is used in another way than as an angle, or π as a number, `sin` and `cos`
/// stay what they are, functions of real numbers, and only `tan(u)` is written out.
pub(super) fn write_out(claim: &mut Claim, fresh: &mut Fresh) {
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
    let (author, names_before) = (claim.clone(), fresh.clone());
    let mut writer = Writer {
        words: words.clone(),
        is_pi,
        definitions: BTreeMap::new(),
        angles: BTreeMap::new(),
        bounds: BTreeMap::new(),
        equations: Vec::new(),
        fresh,
        nodes: 0,
        is_possible: true,
    };
    writer.put_in_functions(claim);
    if writer.is_possible {
        writer.find_angles(claim);
        writer.find_derivatives(claim);
    }
    if writer.is_possible {
        writer.name_cosines_and_sines();
        writer.claim(claim);
    }
    if writer.is_possible {
        return;
    }
    (*claim, *fresh) = (author, names_before);
    if words.contains(&"tan") {
        walk::expressions(claim, &mut |e| tangents_written(e));
    }
}

/// `sin(u)/cos(u)` for every `tan(u)`.
fn tangents_written(e: &mut Expr) {
    walk::parts_mut(e, &mut |part| tangents_written(part));
    let span = e.span;
    if let ExprKind::Apply(f, arguments) = &e.kind
        && let ("tan", [u]) = (f.text.as_str(), arguments.as_slice())
    {
        let of = |word: &str| apply(span, word, u.clone());
        e.kind = ExprKind::Product(vec![(Factor::Times, of("sin")), (Factor::Over, of("cos"))]);
    }
}

impl Writer<'_> {
    /// A variable is used otherwise than as an angle, or the claim is too long when it is written out.
    fn give_up(&mut self) {
        self.is_possible = false;
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

    /// Writes out declarations, sample, goal and argument.
    fn claim(&mut self, claim: &mut Claim) {
        for item in std::mem::take(&mut claim.items) {
            self.item(item, &mut claim.items);
        }
        self.values(&mut claim.sample, false);
        self.prop(&mut claim.goal);
        self.proof(&mut claim.proof);
        // What is declared elsewhere is a natural number, an index or a family.
        if self.angles.values().any(|v| !v.is_declared) {
            self.give_up();
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
