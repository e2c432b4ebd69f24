//! sin, cos, tan and π, written out where a claim is read.
//!
//! Contract: after [`write_out`] a claim speaks of no angle. For every angle θ it has two real numbers `cos_theta` and
//! `sin_theta` with cos_theta² + sin_theta² = 1 instead, and it says exactly the same: (c, s) lies on the unit circle if and only
//! if c = cos θ and s = sin θ for some θ, and an angle is spoken of through its cosine and sine alone. What else is
//! said of an angle is refused, but for its bounds and for equations between angles, see [`Bounds::conditions`] and
//! [`Writer::relation`]. So search, kernel and exports know nothing of angles, and a proof or a counterexample for what is
//! written is one for what was meant.
//!
//! | written | stands for |
//! |---|---|
//! | `theta in [0, pi/2]` under `given`, in a quantifier | two real numbers, their squares' sum, `sin_theta >= 0`, `cos_theta >= 0` |
//! | `sin(2*theta - pi/3)` | the addition formulas in `cos_theta` and `sin_theta` |
//! | `cos(theta/2)` | a name of its own, `cos_theta_over_2`; θ itself is its double |
//! | `tan(u)` | `sin(u)/cos(u)` |
//! | `sin(pi/12)` | `(sqrt(6) - sqrt(2))/4`, and so for every multiple of π/120 |
//! | `derivative(f, theta)` | what the rules for derivatives give |
//! | `maximum of f over theta in [0, pi] at theta = pi/2 is M` | `f <= M` for all θ, and `f = M` there |
//! | `let h = theta/2`, `let R(a) = [cos(a), …]` | put in where they stand |
//!
//! A name that the claim declares keeps its own meaning: where `pi` is declared, it is not π.

use super::angle::{Angle, Bounds, Linear, linear};
use super::circle::{MULTIPLE_LIMIT, Point, TERMS_LIMIT, compared, cosine_name, sine_name};
use super::definedness::number;
use super::diagnostic::{Diagnostic, Fault};
use super::matrix::{at, numeral};
use super::preamble::{applied, declared};
use super::syntax::*;
use super::total;
use super::walk;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};
use std::collections::{BTreeMap, BTreeSet};

/// The functions of an angle.
const WORDS: [&str; 3] = ["sin", "cos", "tan"];

/// The most nodes that are written for one claim.
pub(crate) const NODES_LIMIT: usize = 100_000;

/// The deepest expression that is written.
const DEPTH_LIMIT: usize = 400;

/// Whether this is a function of an angle; it takes one argument.
pub(crate) fn is_function(name: &str) -> bool {
    WORDS.contains(&name)
}

/// A variable that stands under sin, cos or tan.
struct Variable {
    /// The angle that is named is the variable over this.
    over: u32,
    /// Where it stands under them first.
    span: Span,
    /// Whether a declaration was found.
    is_declared: bool,
}

struct Writer<'a> {
    /// The words that keep their meaning here.
    words: Vec<&'static str>,
    is_pi: bool,
    /// Definitions with parameters that speak of angles.
    functions: BTreeMap<String, (Vec<Name>, Expr)>,
    /// Definitions that are sums of variables and numbers.
    definitions: BTreeMap<String, Linear>,
    angles: BTreeMap<String, Variable>,
    /// What hypotheses say of the variables beside their declarations.
    bounds: BTreeMap<String, Bounds>,
    /// The equations between angles: sums that are 0.
    equations: Vec<Angle>,
    /// What definitions without parameters stand for, written out.
    values: BTreeMap<String, Expr>,
    /// The names that take an argument.
    applied: BTreeSet<String>,
    nodes: usize,
    faults: &'a mut Vec<Diagnostic>,
}

/// Writes out every angle of a claim.
pub(crate) fn write_out(claim: &mut Claim, faults: &mut Vec<Diagnostic>) {
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
    names.extend(own);
    let mut found = Vec::new();
    let mut writer = Writer {
        words,
        is_pi,
        functions: BTreeMap::new(),
        definitions: BTreeMap::new(),
        angles: BTreeMap::new(),
        bounds: BTreeMap::new(),
        equations: Vec::new(),
        values: BTreeMap::new(),
        applied: claim.items.iter().flat_map(applied).map(|n| n.text.clone()).collect(),
        nodes: 0,
        faults: &mut found,
    };
    writer.put_in_functions(claim);
    if writer.faults.is_empty() {
        writer.find_angles(claim);
        writer.names_are_free(&names);
    }
    if writer.faults.is_empty() {
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

    /// Which function of an angle an expression is, and of what.
    fn function<'e>(&self, e: &'e Expr) -> Option<(&'static str, &'e Expr)> {
        match &e.kind {
            ExprKind::Apply(name, arguments) => {
                let word = self.words.iter().find(|w| **w == name.text)?;
                Some((word, arguments.first()?))
            }
            _ => None,
        }
    }

    fn has_function(&self, e: &Expr) -> bool {
        let mut found = self.function(e).is_some();
        walk::parts(e, &mut |part| found = found || self.has_function(part));
        found
    }

    /// Puts in every definition with parameters that speaks of sin, cos or tan.
    fn put_in_functions(&mut self, claim: &mut Claim) {
        for mut item in std::mem::take(&mut claim.items) {
            walk::of_item(&mut item, &mut |e| self.put_in(e));
            match item {
                Item::Let { name, parameters, value } if !parameters.is_empty() && self.has_function(&value) => {
                    self.functions.insert(name.text, (parameters, value));
                }
                item => claim.items.push(item),
            }
        }
        walk::expressions(claim, &mut |e| self.put_in(e));
    }

    fn put_in(&mut self, e: &mut Expr) {
        if !self.faults.is_empty() {
            return;
        }
        walk::parts_mut(e, &mut |part| self.put_in(part));
        let ExprKind::Apply(name, arguments) = &e.kind else { return };
        let Some((parameters, value)) = self.functions.get(&name.text) else { return };
        self.nodes += walk::nodes_in(value) * arguments.iter().map(walk::nodes_in).sum::<usize>();
        if self.nodes > NODES_LIMIT {
            return self.limit("nodes of angles written out", NODES_LIMIT, e.span);
        }
        let mut bound = BTreeSet::new();
        walk::indices(value, &mut bound);
        let mut inside = BTreeSet::new();
        arguments.iter().for_each(|a| walk::names_in(a, &mut inside));
        if let Some(index) = bound.intersection(&inside).next() {
            let message = format!("{} has an index {index}, and so has what it is applied to", name.text);
            return self.fault(message, "give one of them another name", e.span);
        }
        let values: BTreeMap<&str, &Expr> = parameters.iter().map(|p| p.text.as_str()).zip(arguments).collect();
        let mut written = value.clone();
        walk::substitute(&mut written, &values);
        if walk::depth(&written) > DEPTH_LIMIT {
            return self.limit("levels of definitions put in", DEPTH_LIMIT, e.span);
        }
        e.kind = written.kind;
    }

    /// Notes the variables under sin, cos and tan, the definitions that are angles, and what hypotheses say of them.
    fn find_angles(&mut self, claim: &mut Claim) {
        for item in &claim.items {
            if let Item::Let { name, parameters, value } = item
                && parameters.is_empty()
                && let Some(value) = linear(value, &self.definitions, self.is_pi)
            {
                self.definitions.insert(name.text.clone(), value);
            }
        }
        walk::expressions(claim, &mut |e| self.find(e));
        self.find_by_bounds(&claim.items);
        for item in &claim.items {
            if let Item::Assume { prop, .. } = item
                && let PropKind::Compare(sides, relations) = &prop.kind
                && self.is_about_angles(sides)
            {
                for (pair, relation) in sides.windows(2).zip(relations) {
                    self.bound(&pair[0], *relation, &pair[1]);
                }
            }
        }
    }

    fn find(&mut self, e: &Expr) {
        let Some((_, argument)) = self.function(e) else {
            return walk::parts(e, &mut |part| self.find(part));
        };
        let Some(angle) = self.angle(argument) else {
            let help = "an angle is a sum of variables and pi with rational numbers before them, such as 2*theta - pi/3; \
                        give a product such as omega*t a name of its own: `given phi real`";
            return self.fault("this is no angle".to_string(), help, argument.span);
        };
        self.note(&angle, argument.span);
    }

    /// Notes the variables of an angle.
    fn note(&mut self, angle: &Angle, span: Span) {
        for (name, k) in &angle.of {
            let known = self.angles.get(name).map_or(1, |v| v.over);
            let Some(over) = common_multiple(known, k.denom()) else {
                return self.limit("parts of an angle", MULTIPLE_LIMIT as usize, span);
            };
            self.angles.entry(name.clone()).or_insert(Variable { over, span, is_declared: false }).over = over;
        }
    }

    /// Notes the variables that are declared with bounds in π.
    fn find_by_bounds(&mut self, items: &[Item]) {
        let speaks_of_pi = |e: &Expr| self.angle(e).is_some_and(|a| !a.turns.is_zero());
        let is_angle = |binding: &&Binding| {
            binding.constraints.iter().any(|c| match c {
                Constraint::Relation(_, e) => speaks_of_pi(e),
                Constraint::Interval { from, to, .. } | Constraint::Range(from, to) => {
                    speaks_of_pi(from) || speaks_of_pi(to)
                }
            })
        };
        let bindings = items.iter().filter_map(|item| if let Item::Given(list) = item { Some(list) } else { None });
        let names: Vec<Name> =
            bindings.flatten().filter(is_angle).flat_map(|b| b.names.iter().map(|n| n.0.clone())).collect();
        for name in names {
            let of = BTreeMap::from([(name.text.clone(), BigRational::one())]);
            self.note(&Angle { turns: BigRational::zero(), of }, name.span);
        }
    }

    fn angle(&self, e: &Expr) -> Option<Angle> {
        linear(e, &self.definitions, self.is_pi)?.as_angle().cloned()
    }

    /// Whether an angle stands in these expressions, not under sin, cos or tan.
    fn is_about_angles(&self, sides: &[Expr]) -> bool {
        sides.iter().any(|e| self.shows_an_angle(e))
    }

    fn shows_an_angle(&self, e: &Expr) -> bool {
        if self.function(e).is_some() {
            return false;
        }
        let mut found = matches!(&e.kind, ExprKind::Name(name) if self.is_angle(name));
        walk::parts(e, &mut |part| found = found || self.shows_an_angle(part));
        found
    }

    /// Whether a name is a variable that stands under sin, cos or tan, or is defined by such.
    fn is_angle(&self, name: &str) -> bool {
        self.angles.contains_key(name)
            || self
                .definitions
                .get(name)
                .and_then(Linear::as_angle)
                .is_some_and(|angle| !angle.turns.is_zero() || angle.of.keys().any(|of| self.angles.contains_key(of)))
    }

    /// Notes what a hypothesis says of the bounds of one variable.
    fn bound(&mut self, a: &Expr, relation: Relation, b: &Expr) {
        let span = Span { start: a.span.start, end: b.span.end };
        let Some(difference) = self.difference(a, b) else { return self.no_statement_of_angles(span) };
        let mut left = difference.of.iter();
        match (relation, left.next(), left.next()) {
            (Relation::Equal, ..) => {
                self.note(&difference, span);
                self.equations.push(difference);
            }
            (_, Some((name, k)), None) => {
                let turns = -&difference.turns / k;
                let relation = if k.is_negative() { relation.turned() } else { relation };
                if !self.bounds.entry(name.clone()).or_default().narrow(relation, turns) {
                    self.no_statement_of_angles(span);
                }
            }
            _ => self.no_statement_of_angles(span),
        }
    }

    /// The first angle less the second.
    fn difference(&self, a: &Expr, b: &Expr) -> Option<Angle> {
        let (mut out, b) = (self.angle(a)?, self.angle(b)?);
        out.turns -= &b.turns;
        for (name, k) in &b.of {
            *out.of.entry(name.clone()).or_insert_with(BigRational::zero) -= k;
        }
        out.of.retain(|_, k| !k.is_zero());
        Some(out)
    }

    fn no_statement_of_angles(&mut self, span: Span) {
        let help = "bounds that are multiples of pi, such as `0 < theta < pi/2`, and equations such as \
                    `alpha + beta + gamma = pi` may be said; else speak of sin, cos and tan";
        self.fault("this cannot be said of an angle".to_string(), help, span);
    }

    /// The names of cosines and sines are not taken.
    fn names_are_free(&mut self, names: &BTreeSet<String>) {
        let taken: Vec<(String, Span)> = self
            .angles
            .iter()
            .flat_map(|(name, v)| {
                [cosine_name(&named(name, v.over)), sine_name(&named(name, v.over))].map(|n| (n, v.span))
            })
            .filter(|(name, _)| names.contains(name))
            .collect();
        for (name, span) in taken {
            self.fault(format!("{name} stands for this here"), &format!("give your {name} another name"), span);
        }
    }

    fn claim(&mut self, claim: &mut Claim) {
        for item in std::mem::take(&mut claim.items) {
            self.item(item, &mut claim.items);
        }
        self.values(&mut claim.sample, false);
        self.prop(&mut claim.goal);
        self.proof(&mut claim.proof);
        let hidden = self.angles.iter().find(|(_, v)| !v.is_declared).map(|(name, v)| (name.clone(), v.span));
        if let Some((name, span)) = hidden.filter(|_| self.faults.is_empty()) {
            let help = "an angle is a real variable of `given` or of a quantifier";
            self.fault(format!("{name} is no angle: it counts, or has an index"), help, span);
        }
    }

    fn item(&mut self, item: Item, out: &mut Vec<Item>) {
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
                    let help = "take the label away: bounds of an angle are known without it";
                    return self.fault("bounds of an angle have no label".to_string(), help, span);
                }
                out.extend(conjunction(said, span).map(|prop| Item::Assume { label, prop }));
            }
            mut other => {
                match &mut other {
                    Item::Assume { prop, .. } => self.prop(prop),
                    Item::Let { parameters, value, .. } => {
                        // A parameter may have the name of an angle of another place.
                        let hidden: Vec<_> =
                            parameters.iter().filter_map(|p| self.angles.remove_entry(&p.text)).collect();
                        self.expr(value);
                        self.angles.extend(hidden);
                    }
                    item => walk::of_item(item, &mut |e| self.expr(e)),
                }
                if let Item::Let { name, parameters, value } = &other
                    && parameters.is_empty()
                {
                    self.values.insert(name.text.clone(), value.clone());
                }
                out.push(other);
            }
        }
    }

    /// Names cosine and sine in place of every angle that is bound here, and says what is known of them.
    fn bindings(&mut self, bindings: &mut Vec<Binding>, is_given: bool) -> Vec<Prop> {
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
                    let help = "an angle is declared as `theta real` or `theta in [0, pi/2]`";
                    self.fault(format!("{} is no angle: it counts, or has an index", name.text), help, name.span);
                    continue;
                }
                let mut bounds = self.bounds.get(&name.text).filter(|_| is_given).cloned().unwrap_or_default();
                if !constraints.iter().all(|c| self.narrow(&mut bounds, c)) {
                    self.no_statement_of_angles(span);
                    continue;
                }
                self.bounds.insert(name.text.clone(), bounds.clone());
                let Some(variable) = self.angles.get_mut(&name.text) else { continue };
                variable.is_declared = true;
                let over = variable.over;
                let angle = named(&name.text, over);
                let value = |text: String| at(name.span, ExprKind::Name(text));
                let (cos, sin) = (cosine_name(&angle), sine_name(&angle));
                let names = [&cos, &sin].map(|n| (Name { text: n.clone(), span: name.span }, None)).to_vec();
                out.push(Binding { names, natural: false, constraints: Vec::new(), indices: None, span });
                let square = |text: String| {
                    let two = Box::new(numeral(name.span, 2));
                    (Sign::Plus, at(name.span, ExprKind::Power(Box::new(value(text)), two)))
                };
                let squares = at(name.span, ExprKind::Sum(vec![square(cos), square(sin)]));
                conditions.push(compared(squares, Relation::Equal, numeral(name.span, 1)));
                match bounds.conditions(&angle, over, span) {
                    Some(list) => conditions.extend(list),
                    None => {
                        let help = "the ends are multiples of pi/120, and the first is less than the second";
                        self.fault(format!("these bounds of {} cannot be used", name.text), help, span);
                    }
                }
            }
        }
        *bindings = out;
        conditions
    }

    /// Whether a constraint is a bound of an angle.
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

    /// An equation between angles, as two of cosines and sines.
    ///
    /// These say that both sides differ by whole turns. The equation says the same if the bounds leave no other number
    /// of turns than none. It also does if one of the angles has no bounds, stands in no other equation, and turns the sum
    /// once when it is turned once. Then it may be turned until both sides agree.
    fn relation(&mut self, a: &Expr, b: &Expr) -> Vec<Prop> {
        let span = Span { start: a.span.start, end: b.span.end };
        let Some(sum) = self.difference(a, b) else {
            self.no_statement_of_angles(span);
            return Vec::new();
        };
        // The coefficient of the named angle is 1 or -1: cosine and sine can be solved for.
        let single = |name: &String, k: &BigRational| {
            self.angles.get(name).is_some_and(|v| (k * BigRational::from_integer(v.over.into())).abs().is_one())
        };
        let solved = sum.of.iter().rev().find(|(name, k)| single(name, k));
        let free = sum.of.iter().rev().find(|(name, k)| {
            let others = self.equations.iter().filter(|e| e.of.contains_key(*name)).count();
            single(name, k) && self.bounds.get(*name).is_none_or(Bounds::are_none) && others == 1
        });
        if free.is_none() && !self.turns_are_known(&sum) {
            let help = "give the angles bounds that leave one number of turns, such as `alpha, beta, gamma in (0, pi)`";
            self.fault("the angles may differ by whole turns here".to_string(), help, span);
            return Vec::new();
        }
        let Some((name, k)) = free.or(solved).map(|(name, k)| (name.clone(), k.clone())) else {
            let is = |value: Expr, k: u32| compared(value, Relation::Equal, numeral(span, k));
            let zero = self.point(&sum, span);
            return zero.map_or(Vec::new(), |p| vec![is(p.cosine(span), 1), is(p.sine(span), 0)]);
        };
        let mut rest = sum;
        rest.of.remove(&name);
        let sign = if k.is_positive() { -BigRational::one() } else { BigRational::one() };
        rest.turns *= &sign;
        rest.of.values_mut().for_each(|k| *k *= &sign);
        let over = self.angles.get(&name).map_or(1, |v| v.over);
        let angle = named(&name, over);
        let Some(point) = self.point(&rest, span) else { return Vec::new() };
        let value = |text: String| at(span, ExprKind::Name(text));
        vec![
            compared(value(cosine_name(&angle)), Relation::Equal, point.cosine(span)),
            compared(value(sine_name(&angle)), Relation::Equal, point.sine(span)),
        ]
    }

    /// Whether the bounds allow the sum no other multiple of 2π than 0.
    fn turns_are_known(&self, sum: &Angle) -> bool {
        let (mut low, mut high, mut closed) = (sum.turns.clone(), sum.turns.clone(), true);
        for (name, k) in &sum.of {
            let Some((from, to)) = self.bounds.get(name).and_then(Bounds::ends) else { return false };
            let (from, to) = if k.is_negative() { (to, from) } else { (from, to) };
            low += k * &from.0;
            high += k * &to.0;
            closed = closed && from.1 && to.1;
        }
        let two = BigRational::from_integer(BigInt::from(2));
        if closed { low > -&two && high < two } else { low >= -&two && high <= two }
    }

    /// The point of an angle, in the named angles.
    fn point(&mut self, angle: &Angle, span: Span) -> Option<Point> {
        if self.nodes > NODES_LIMIT {
            return None;
        }
        let Some(mut out) = Point::of_turns(&angle.turns) else {
            let help = "cosines and sines are known of the multiples of pi/120; name the angle: `given phi real`";
            self.fault("the value at this multiple of pi is not known".to_string(), help, span);
            return None;
        };
        for (name, k) in &angle.of {
            let over = self.angles.get(name).map_or(1, |v| v.over);
            let times = (k * BigRational::from_integer(over.into())).to_integer().to_i64();
            let Some(part) = times.and_then(|times| Point::named(&named(name, over)).times(times)) else {
                self.limit("multiple of an angle", MULTIPLE_LIMIT as usize, span);
                return None;
            };
            let Some(sum) = out.plus(&part) else {
                self.limit("products for a cosine or sine", TERMS_LIMIT, span);
                return None;
            };
            out = sum;
        }
        self.nodes += 10 * out.terms();
        if self.nodes > NODES_LIMIT {
            self.limit("nodes of angles written out", NODES_LIMIT, span);
            return None;
        }
        Some(out)
    }

    fn expr(&mut self, e: &mut Expr) {
        let span = e.span;
        if let Some((word, argument)) = self.function(e) {
            let Some(point) = self.angle(argument).and_then(|angle| self.point(&angle, span)) else { return };
            *e = match word {
                "cos" => point.cosine(span),
                "sin" => point.sine(span),
                _ => at(
                    span,
                    ExprKind::Product(vec![(Factor::Times, point.sine(span)), (Factor::Over, point.cosine(span))]),
                ),
            };
            return;
        }
        match &mut e.kind {
            ExprKind::Name(name) if name == PI && self.is_pi => {
                let help = "it is known under sin, cos and tan and in bounds of angles; as a number, declare it with bounds: \
                            `given pi in (3.14159, 3.1416)`";
                self.fault("pi stands alone here".to_string(), help, span);
            }
            ExprKind::Name(name) if self.is_angle(name) => {
                let message = format!("{name} is an angle, and stands outside sin, cos and tan here");
                let help = "state its bounds where it is declared, `theta in (0, pi/2)`, and let another variable stand \
                            for the number";
                self.fault(message, help, span);
            }
            ExprKind::Derivative(body, by) if by.iter().any(|name| self.angles.contains_key(&name.text)) => {
                self.expr(body);
                let mut out = (**body).clone();
                for name in by.clone() {
                    let found = match self.angles.get(&name.text).map(|v| v.over) {
                        Some(over) => self
                            .derivative(&out, &named(&name.text, over), over)
                            .map(|d| self.with_the_value_of(d, &out)),
                        None => Some(at(span, ExprKind::Derivative(Box::new(out), vec![name]))),
                    };
                    let Some(found) = found else {
                        if self.nodes > NODES_LIMIT {
                            return self.limit("nodes of angles written out", NODES_LIMIT, span);
                        }
                        let help = "by an angle are derived sums, products, quotients, whole powers, sqrt, exp and ln; \
                                    write the derivative out";
                        return self.fault("this is not derived by an angle".to_string(), help, span);
                    };
                    out = found;
                }
                *e = out;
            }
            _ => walk::parts_mut(e, &mut |part| self.expr(part)),
        }
    }

    /// A derivative that has a value only where the function has one: a summand without the angle leaves nothing behind, and
    /// it may divide by what can be 0.
    fn with_the_value_of(&self, derivative: Expr, function: &Expr) -> Expr {
        let plain = |name: &str| !self.applied.contains(name) && !self.values.contains_key(name);
        let named = |name: &str| match self.values.get(name) {
            Some(value) => total::has_a_value(value, &plain),
            None => plain(name),
        };
        if total::has_a_value(function, &named) {
            return derivative;
        }
        let span = derivative.span;
        let nothing = vec![(Factor::Times, numeral(span, 0)), (Factor::Times, function.clone())];
        let nothing = at(span, ExprKind::Product(nothing));
        at(span, ExprKind::Sum(vec![(Sign::Plus, derivative), (Sign::Plus, nothing)]))
    }

    /// The derivative of what is written out already, by the rules for sums, products, quotients, whole powers, roots, exp
    /// and ln. Where the function has a value, this has one where there are derivatives: it divides by what the function divides
    /// by, and by its roots.
    fn derivative(&mut self, of: &Expr, angle: &str, over: u32) -> Option<Expr> {
        let span = of.span;
        // A product of k factors has k terms, each with all factors.
        let copies = if let ExprKind::Product(list) = &of.kind { list.len() } else { 1 };
        self.nodes = self.nodes.saturating_add(walk::nodes_in(of).saturating_mul(copies));
        if self.nodes > NODES_LIMIT {
            return None;
        }
        let mut part = |e: &Expr| self.derivative(e, angle, over);
        let zero = || numeral(span, 0);
        let times = |factors: Vec<(Factor, Expr)>| at(span, ExprKind::Product(factors));
        let by = |e: &Expr| (Factor::Times, e.clone());
        let over_ = |e: Expr| (Factor::Over, e);
        let is_zero = |e: &Expr| matches!(&e.kind, ExprKind::Number(text) if text == "0");
        let sum = |list: Vec<(Sign, Expr)>| match list.as_slice() {
            [] => zero(),
            [(Sign::Plus, only)] => only.clone(),
            _ => at(span, ExprKind::Sum(list)),
        };
        Some(match &of.kind {
            ExprKind::Name(name) if *name == cosine_name(angle) || *name == sine_name(angle) => {
                let is_cosine = *name == cosine_name(angle);
                let other = if is_cosine { sine_name(angle) } else { cosine_name(angle) };
                let mut e = at(span, ExprKind::Name(other));
                if is_cosine {
                    e = at(span, ExprKind::Negate(Box::new(e)));
                }
                if over > 1 { times(vec![by(&e), over_(numeral(span, over))]) } else { e }
            }
            ExprKind::Name(name) => match self.values.get(name).cloned() {
                Some(value) => self.derivative(&value, angle, over)?,
                None => zero(),
            },
            ExprKind::Number(_) => zero(),
            ExprKind::Negate(a) => {
                let d = part(a)?;
                if is_zero(&d) { d } else { at(span, ExprKind::Negate(Box::new(d))) }
            }
            ExprKind::Sum(list) => {
                let parts = list.iter().map(|(sign, a)| Some((*sign, part(a)?))).collect::<Option<Vec<_>>>()?;
                sum(parts.into_iter().filter(|(_, d)| !is_zero(d)).collect())
            }
            ExprKind::Product(list) => {
                let mut terms = Vec::new();
                for (place, (factor, a)) in list.iter().enumerate() {
                    let d = part(a)?;
                    if is_zero(&d) {
                        continue;
                    }
                    let mut factors = list.clone();
                    let sign = match factor {
                        Factor::Times => {
                            factors[place] = (Factor::Times, d);
                            Sign::Plus
                        }
                        // (1/a)′ = −a′/a².
                        Factor::Over => {
                            factors[place] =
                                over_(at(span, ExprKind::Power(Box::new(a.clone()), Box::new(numeral(span, 2)))));
                            factors.push((Factor::Times, d));
                            Sign::Minus
                        }
                    };
                    if factors[0].0 == Factor::Over {
                        factors.insert(0, (Factor::Times, numeral(span, 1)));
                    }
                    terms.push((sign, times(factors)));
                }
                if let [(Sign::Minus, only)] = terms.as_slice() {
                    return Some(at(span, ExprKind::Negate(Box::new(only.clone()))));
                }
                if let Some((Sign::Minus, _)) = terms.first() {
                    terms.insert(0, (Sign::Plus, zero()));
                }
                sum(terms)
            }
            ExprKind::Power(base, exponent) => {
                let d = part(base)?;
                match number(exponent) {
                    _ if is_zero(&d) && is_zero(&part(exponent)?) => zero(),
                    Some((0, 1)) => zero(),
                    Some((k, 1)) => {
                        let less = |k: i128| match u32::try_from(k) {
                            Ok(k) => Some(numeral(span, k)),
                            Err(_) => {
                                Some(at(span, ExprKind::Negate(Box::new(numeral(span, u32::try_from(-k).ok()?)))))
                            }
                        };
                        let power = at(span, ExprKind::Power(base.clone(), Box::new(less(k - 1)?)));
                        times(vec![by(exponent), by(&power), by(&d)])
                    }
                    _ => return None,
                }
            }
            ExprKind::Apply(function, list) => {
                let a = list.first()?;
                let d = part(a)?;
                match function.text.as_str() {
                    _ if list.len() == 1 && is_zero(&d) => zero(),
                    "sqrt" => times(vec![by(&d), over_(numeral(span, 2)), over_(of.clone())]),
                    "exp" => times(vec![by(&d), by(of)]),
                    "ln" => times(vec![by(&d), over_(a.clone())]),
                    _ => return None,
                }
            }
            _ => return None,
        })
    }

    fn prop(&mut self, p: &mut Prop) {
        let span = p.span;
        match &mut p.kind {
            PropKind::Compare(sides, _) => sides.iter_mut().for_each(|e| self.expr(e)),
            PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => {
                list.iter_mut().for_each(|p| self.prop(p));
            }
            PropKind::Not(p) => self.prop(p),
            PropKind::Implies(a, b) => {
                self.prop(a);
                self.prop(b);
            }
            PropKind::Exists(bindings, body) => {
                let mut conditions = self.bindings(bindings, false);
                self.prop(body);
                if !conditions.is_empty() {
                    conditions.push((**body).clone());
                    body.kind = PropKind::And(conditions);
                }
            }
            PropKind::ForAll(bindings, body) => {
                let conditions = self.bindings(bindings, false);
                self.prop(body);
                if let Some(conditions) = conjunction(conditions, span) {
                    body.kind = PropKind::Implies(Box::new(conditions), Box::new((**body).clone()));
                }
            }
            PropKind::Extremum(extremum) => {
                let mut names =
                    extremum.over.iter().flat_map(|b| &b.names).map(|n| self.angles.contains_key(&n.0.text));
                if !names.clone().any(|is_angle| is_angle) {
                    extremum.over.iter_mut().for_each(|b| walk::of_binding(b, &mut |e| self.expr(e)));
                    let at = extremum.at.iter_mut().map(|(_, e)| e);
                    [&mut extremum.of, &mut extremum.value].into_iter().chain(at).for_each(|e| self.expr(e));
                } else if names.all(|is_angle| is_angle) {
                    let written = self.extremum((**extremum).clone(), span);
                    p.kind = written;
                } else {
                    let help =
                        "say it for all, and for the place: `for all theta real; x > 0: f <= M`, and `f = M` there";
                    self.fault("an extremum over angles and numbers at once is not there".to_string(), help, span);
                }
            }
            PropKind::Limit(limit) => {
                self.expr(&mut limit.of);
                self.expr(&mut limit.value);
            }
        }
    }

    /// An extremum over angles: no value is beyond that at the place, and, where it is the only place, no other has it.
    fn extremum(&mut self, mut e: Extremum, span: Span) -> PropKind {
        let mut of_place = e.of.clone();
        walk::substitute(&mut of_place, &e.at.iter().map(|(name, value)| (name.text.as_str(), value)).collect());
        self.expr(&mut of_place);
        let conditions = self.bindings(&mut e.over, false);
        self.expr(&mut e.of);
        self.expr(&mut e.value);
        let mut same = Vec::new();
        for (name, value) in &e.at {
            let bounds = self.bounds.get(&name.text).cloned().unwrap_or_default();
            let Some(angle) = self.angle(value).filter(|a| a.of.is_empty() && bounds.hold(&a.turns)) else {
                let help = "the place is a multiple of pi within the bounds of the angle";
                self.fault("this is no place of an extremum".to_string(), help, value.span);
                continue;
            };
            if e.unique && !bounds.are_less_than_a_turn() {
                let help = "give the angle bounds that are no more than one turn apart, such as `theta in [0, 2*pi)`";
                self.fault("an extremum over all angles has no only place".to_string(), help, span);
            }
            for (name, value) in self.cosine_and_sine(name, &angle, value.span) {
                same.push(compared(at(name.span, ExprKind::Name(name.text)), Relation::Equal, value));
            }
        }
        let relation = if e.maximum { Relation::LessEqual } else { Relation::GreaterEqual };
        // All of it stands under one `for all`: the place lies within the bounds, so that there are such angles.
        let mut said = vec![
            compared(e.of.clone(), relation, e.value.clone()),
            compared(of_place, Relation::Equal, e.value.clone()),
        ];
        if e.unique
            && let Some(only) = conjunction(same, span)
        {
            let there = compared(e.of, Relation::Equal, e.value);
            said.push(Prop { kind: PropKind::Implies(Box::new(there), Box::new(only)), span });
        }
        let mut body = Prop { kind: PropKind::And(said), span };
        if let Some(conditions) = conjunction(conditions, span) {
            body.kind = PropKind::Implies(Box::new(conditions), Box::new(body.clone()));
        }
        PropKind::ForAll(e.over, Box::new(body))
    }

    /// Values for the cosine and the sine of what is named.
    fn cosine_and_sine(&mut self, name: &Name, angle: &Angle, span: Span) -> Vec<(Name, Expr)> {
        let over = self.angles.get(&name.text).map_or(1, |v| v.over);
        let part = BigRational::new(BigInt::one(), over.into());
        let angle = Angle {
            turns: &angle.turns * &part,
            of: angle.of.iter().map(|(name, k)| (name.clone(), k * &part)).collect(),
        };
        let named = named(&name.text, over);
        let value = |text: String| Name { text, span: name.span };
        let point = self.point(&angle, span);
        point.map_or(Vec::new(), |p| {
            vec![(value(cosine_name(&named)), p.cosine(span)), (value(sine_name(&named)), p.sine(span))]
        })
    }

    /// Values of variables: an angle has that of its cosine and of its sine.
    ///
    /// In what a cited claim is told, the names are those of that claim: there an angle is known by its value.
    fn values(&mut self, values: &mut Vec<(Name, Expr)>, are_cited: bool) {
        for (name, mut value) in std::mem::take(values) {
            let angle = self.angle(&value).filter(|angle| {
                let is_named = self.angles.contains_key(&name.text);
                is_named
                    || are_cited && (!angle.turns.is_zero() || angle.of.keys().any(|of| self.angles.contains_key(of)))
            });
            match angle {
                Some(angle) => values.extend(self.cosine_and_sine(&name, &angle, value.span)),
                None if self.angles.contains_key(&name.text) => self.no_statement_of_angles(value.span),
                None => {
                    self.expr(&mut value);
                    values.push((name, value));
                }
            }
        }
    }

    fn proof(&mut self, proof: &mut Proof) {
        for step in &mut proof.steps {
            match step {
                Step::Have { prop, proof, .. } | Step::Case { prop, proof, .. } => {
                    self.prop(prop);
                    self.proof(proof);
                }
                Step::Obtain { binding, prop, witness, .. } => {
                    walk::of_binding(binding, &mut |e| self.expr(e));
                    self.prop(prop);
                    self.expr(witness);
                }
            }
        }
        match &mut proof.close {
            Some(Method::Induction(_, step)) => self.proof(step),
            Some(Method::Instance { with, .. }) => self.values(with, true),
            Some(Method::Witness(with)) => self.values(with, false),
            Some(method) => walk::of_method(method, &mut |e| self.expr(e)),
            None => {}
        }
    }
}

/// What stands for a part of a variable: `theta`, `theta_over_2`.
fn named(variable: &str, over: u32) -> String {
    if over == 1 { variable.to_string() } else { format!("{variable}_over_{over}") }
}

/// The least common multiple, if it is at most [`MULTIPLE_LIMIT`].
fn common_multiple(a: u32, b: &BigInt) -> Option<u32> {
    let b = b.to_u32().filter(|b| i64::from(*b) <= MULTIPLE_LIMIT)?;
    (1..=MULTIPLE_LIMIT as u32).find(|k| k % a == 0 && k % b == 0)
}

fn conjunction(mut list: Vec<Prop>, span: Span) -> Option<Prop> {
    match list.len() {
        0 | 1 => list.pop(),
        _ => Some(Prop { kind: PropKind::And(list), span }),
    }
}
