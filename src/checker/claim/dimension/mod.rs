//! Whether a claim adds and compares only what has one dimension.
//!
//! Contract: units are optional, and no part of the mathematical statement: neither the kernel nor the digest of a statement knows
//! them. A claim in which a declaration names a unit is checked before it is judged. Its units must belong to one coherent system,
//! so that an equation between quantities is the same equation between their numbers. A name without a unit gets the dimension
//! that its equations give it, if they do. What cannot be decided, such as the dimension of `x^n`, is never called wrong.
//! Method: dimensions are vectors of rational exponents, with unknowns for names without a unit; each sum and each comparison is a
//! linear equation between them (`size`).
//! Limits: [`STEPS_LIMIT`], [`DEPTH_LIMIT`].

mod expression;
mod proposition;
mod size;

use super::diagnostic::{Diagnostic, Fault};
use super::preamble::Preamble;
use super::syntax::*;
use carom_unit::System;
use expression::Checker;

/// The most expressions that are looked at, those in definitions once for each use.
pub const STEPS_LIMIT: usize = 200_000;
/// The deepest nesting of expressions, definitions put in.
pub const DEPTH_LIMIT: usize = 700;

/// Two parts of a claim whose dimensions differ, though they are added or compared.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mismatch {
    /// The smallest expression or comparison that is wrong.
    pub subterm: String,
    /// Where it stands.
    pub span: Span,
    /// Its first part.
    pub left: String,
    /// The dimension of that in base units; `1` for a number.
    pub left_dimension: String,
    /// Its second part, or the rule that is broken: `the argument of exp`.
    pub right: String,
    /// The dimension of that, or the one that is needed.
    pub right_dimension: String,
    /// The names in it that have no unit of their own, with the dimension that equations give them.
    pub inferred: Vec<(String, String)>,
}

impl Mismatch {
    /// What is wrong, in a sentence.
    #[must_use]
    pub fn message(&self) -> String {
        let Mismatch { subterm, left, left_dimension, right, right_dimension, .. } = self;
        let says = |dimension: &str| match dimension {
            "1" => "is a number".to_string(),
            dimension => format!("is in {dimension}"),
        };
        format!(
            "dimensions differ in {subterm}: {left} {}, and {right} {}",
            says(left_dimension),
            says(right_dimension)
        )
    }

    /// What to do about it.
    #[must_use]
    pub fn help(&self) -> String {
        let list: Vec<String> =
            self.inferred.iter().map(|(name, dimension)| format!("{name} in {dimension}")).collect();
        let other = "a constant with a unit is declared: `given c = 3 in m/s`";
        match list.as_slice() {
            [] => format!("correct the equation or the units; {other}"),
            list => format!("without a unit of their own, by the equations before: {}; {other}", list.join(", ")),
        }
    }
}

/// Why a check ended.
pub(super) enum Stop {
    Differ(Box<Mismatch>),
    Limit(&'static str, usize, Span),
}

/// Whether a declaration names a unit.
fn has_units(items: &[Item]) -> bool {
    items.iter().any(|item| matches!(item, Item::Given(bindings) if bindings.iter().any(|b| b.unit.is_some())))
}

/// Reports what is wrong with the units of a claim before it is judged: units of two scales, and dimensions that differ in a
/// declaration or a hypothesis. Those of the goal are a verdict, [`of_goal`].
pub(super) fn check(claim: &Claim, faults: &mut Vec<Diagnostic>) {
    if !has_units(&claim.items) {
        return;
    }
    let mut system = System::default();
    for binding in claim.items.iter().filter_map(given).flatten() {
        if let Some(unit) = &binding.unit
            && let Err(list) = system.add(unit)
        {
            let (last, rest) = list.split_last().map_or(("", &list[..]), |(last, rest)| (last.as_str(), rest));
            let message = match rest {
                [] => format!("the unit {last} is a plain factor"),
                rest => {
                    format!("the units {} and {last} do not fit: they measure by different scales", rest.join(", "))
                }
            };
            let help = "an equation of numbers is one of quantities if all units belong to one system: kg, m, s, N, J or g, cm, s, dyn, erg";
            let fault = Fault::Other { message, help: Some(help.to_string()) };
            faults.push(Diagnostic::new(fault, claim.name.span));
            return;
        }
    }
    let mut checker = Checker::default();
    if let Err(stop) = checker.items(&claim.items) {
        faults.push(diagnostic(stop));
    } else if let Err(stop @ Stop::Limit(..)) = checker.goal(&claim.goal) {
        faults.push(diagnostic(stop));
    }
}

/// The same of the declarations that claims share.
pub(super) fn preamble(preamble: &Preamble, faults: &mut Vec<Diagnostic>) {
    if has_units(&preamble.items)
        && let Err(stop) = Checker::default().items(&preamble.items)
    {
        faults.push(diagnostic(stop));
    }
}

/// Where dimensions differ in what a claim proves.
#[must_use]
pub fn of_goal(claim: &Claim) -> Option<Mismatch> {
    let items = claim.written_items();
    if !has_units(items) {
        return None;
    }
    let mut checker = Checker::default();
    match checker.items(items).and_then(|()| checker.goal(claim.written_goal())) {
        Err(Stop::Differ(mismatch)) => Some(*mismatch),
        // Limits were reported when the claim was read.
        Ok(()) | Err(Stop::Limit(..)) => None,
    }
}

fn given(item: &Item) -> Option<&Vec<Binding>> {
    if let Item::Given(bindings) = item { Some(bindings) } else { None }
}

fn diagnostic(stop: Stop) -> Diagnostic {
    match stop {
        Stop::Differ(mismatch) => {
            let help = Some(mismatch.help());
            Diagnostic::new(Fault::Other { message: mismatch.message(), help }, mismatch.span)
        }
        Stop::Limit(name, allowed, span) => Diagnostic::new(Fault::Limit { name, allowed }, span),
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::of_goal;
    use crate::claim::parse::parse;
    use crate::claim::print::{Style, statement};

    const GIVEN: &str = "given m1, m2 > 0 in kg; u, v real in m/s; t > 0 in s; x real in m; n natural >= 1; k1 > 0 in N/m\n\
        given e in [0, 1]; theta real; a real; F(i) real in N; q real; M(i) > 0 in kg\n";

    /// The parts whose dimensions differ, `[left] [right]`, in the goal; or the fault of the hypotheses; or nothing.
    fn found(rest: &str) -> String {
        match parse(&format!("claim c \"t\"\n{GIVEN}{rest}\n")) {
            Err(faults) => format!("fault: {}", faults[0].message()),
            Ok(claims) => of_goal(&claims[0]).map_or(String::new(), |m| {
                format!("{}: {} [{}], {} [{}]", m.subterm, m.left, m.left_dimension, m.right, m.right_dimension)
            }),
        }
    }

    #[test]
    fn a_true_equation_of_quantities_is_called_wrong() {
        for goal in [
            "prove (m1*u + m2*v)^2 <= (m1 + m2)*(m1*u^2 + m2*v^2)",
            "prove sqrt(k1/m1)*t = t*sqrt(k1/m1) and cbrt(x^3) = x and abs(v) >= 0 and max(u, v) >= u",
            "prove x = 0 => 0 = x and x >= -0",
            "prove m1^(1/(n + 1))*m2^(1 - 1/(n + 1)) <= (m1 + m2)",
            "prove (1 + e)^n*v = v*(1 + e)^n and (u/v)^n = u^n/v^n",
            "prove sum(i = 1..n, M(i)*v) = v*sum(i = 1..n, M(i))",
            "prove product(i = 1..2, M(i)) = M(1)*M(2) and product(i = 1..n, 1 + e) >= 1",
            "prove derivative(v*t + a*t^2/2, t) = v + a*t",
            "prove v*cos(theta)*t = x => exp(-t*v/x) > 0",
            "let f(y) = 2*y\nprove f(m1) = m1 + m1 and f(v) = v + v",
            "let E = m1*v^2/2\nlet p = 1/2\nprove E^p = sqrt(E)",
            "define w by w(0) = v, w(j + 1) = e*w(j)\nprove w(n) + v = v + w(n)",
            "prove for all y > 0: y + x = x + y",
            "prove (maximum of v*s - a*s^2/2 over s real at s = v/a is v^2/(2*a))",
            "prove limit of x*n/(n + 1) as n -> infinity is x",
            "prove limit of v*s as s -> t is v*t",
            "prove limit of x + v*s as s -> infinity is infinity",
            "prove det([v, v; x, x]) = v*x - v*x",
            "prove F(1)*x = m1*v^2",
            "given h >= 1 in m; C = 3e8 in m/s; D = 2*pi*10^3 in m; r in [0, sqrt(2)] in m\nprove D/C >= 0*t",
            "given h >= 1 in m; r in [0, 2] in m; c = 3 in m/s; 0 < b < d in kg\nprove h + r + x > c*t and b < d",
        ] {
            assert_eq!(found(goal), "", "{goal}");
        }
    }

    #[test]
    fn dimensions_that_differ_are_not_seen() {
        let mut wrong = Vec::new();
        for (goal, wanted) in [
            ("prove m1*v = m1*v^2", "m1*v = m1*v^2: m1*v [kg·m/s], m1*v^2 [kg·m²/s²]"),
            ("prove 0 <= x + v", "x + v: x [m], v [m/s]"),
            ("prove exp(x) > 0", "exp(x): x [m], the argument of exp [1]"),
            ("prove sin(2*m1) <= 1", "sin(2*m1): 2*m1 [kg], the argument of sin [1]"),
            ("prove m1^v > 0", "m1^v: v [m/s], an exponent [1]"),
            ("prove v*t = t*v + 1", "t*v + 1: t*v [m], 1 [1]"),
            ("prove sqrt(x) = x", "sqrt(x) = x: sqrt(x) [m^(1/2)], x [m]"),
            ("prove max(x, v) >= x", "max(x, v): x [m], v [m/s]"),
            ("prove q + v = v + q and q + x = x + q", "q + x: q [m/s], x [m]"),
            ("prove derivative(x*t, t) = v", "derivative(x*t, t) = v: derivative(x*t, t) [m], v [m/s]"),
            ("prove F(1) = m1*v", "F(1) = m1*v: F(1) [kg·m/s²], m1*v [kg·m/s]"),
            ("prove F(t) = F(t)", "F(t): t [s], an index [1]"),
            ("prove limit of x + j as j natural -> infinity is infinity", "x + j: x [m], j [1]"),
            ("prove limit of y*x + y*x^2 as y -> 0 is 0", "y*x + y*x^2: y*x [m·[y]], y*x^2 [m²·[y]]"),
            ("prove for all y > 1: y + x > 0", "y + x: y [1], x [m]"),
            ("let f(y) = y + v\nprove f(x) = f(x)", "y + v: y [m], v [m/s]"),
            ("prove q^n = q^n and q = x*q", "q = x*q: q [[q]], x*q [m·[q]]"),
            ("assume v = x\nprove 1 = 1", "fault: dimensions differ in v = x: v is in m/s, and x is in m"),
            (
                "let E = m1*v + m1\nprove E = E",
                "fault: dimensions differ in m1*v + m1: m1*v is in kg·m/s, and m1 is in kg",
            ),
            (
                "given w > v in kg\nprove w = w",
                "fault: dimensions differ in the bound v of w: v is in m/s, and w is in kg",
            ),
            (
                "given h > 0 in cm\nprove h = h",
                "fault: the units m and cm do not fit: they measure by different scales",
            ),
            (
                "given E > 0 in erg\nprove E = E",
                "fault: the units kg, m/s and erg do not fit: they measure by different scales",
            ),
            ("given h > 0 in furlong\nprove h = h", "fault: furlong is no unit that is known"),
            ("given j natural in kg\nprove j = j", "fault: a natural number has no unit"),
            (
                "given j integer in kg\nprove j = j",
                "fault: `integer` cannot be combined with a family, a range, a unit or `natural`",
            ),
            ("prove for all y > 0 in m: y > 0", "fault: a unit is declared under `given` only"),
            ("given j in N\nprove j = j", "fault: the set N is no domain here"),
        ] {
            let said = found(goal);
            if said != wanted {
                wrong.push(format!("{goal}: {said}"));
            }
        }
        assert_eq!(wrong, Vec::<String>::new());
    }

    #[test]
    fn a_check_does_not_end() {
        let mut text = "let f0(y) = y*y".to_string();
        for k in 1..40 {
            text += &format!("\nlet f{k}(y) = f{}(y) + f{}(y)", k - 1, k - 1);
        }
        assert_eq!(
            found(&format!("{text}\nprove f39(x) = 0")),
            "fault: limit reached: at most 200000 steps of the check of dimensions"
        );
        let mut text = "let f0(y) = y".to_string();
        for k in 1..900 {
            text += &format!("\nlet f{k}(y) = f{}(y)", k - 1);
        }
        let said = found(&format!("{text}\nprove f899(x) = x"));
        assert!(said.contains("levels of nesting"), "{said}");
        assert!(found("prove x^9223372036854775807*x^9223372036854775807 = 0").contains("limit reached"));
    }

    #[test]
    fn a_unit_changes_a_statement() {
        let with = "claim c \"t\"\ngiven m, M > 0 in kg*m^2/s^(1/2); x in [0, 1] in 1/s; y real in Hz\nprove m*x = m*x";
        let without = "claim c \"t\"\ngiven m, M > 0; x in [0, 1]; y real\nprove m*x = m*x";
        let digest = |text: &str| {
            let claims = parse(text).unwrap();
            crate::kernel::statement::Statement::of(&claims[0]).unwrap().text()
        };
        assert_eq!(digest(with), digest(without));
        let claim = &parse(with).unwrap()[0];
        let printed = statement(claim, Style::Text);
        assert_eq!(printed[0], "given m, M > 0 in kg*m^2/s^(1/2); x in [0, 1] in 1/s; y real in Hz");
        let again = parse(&format!("claim c \"t\"\n{}", printed.join("\n"))).unwrap();
        assert_eq!(statement(&again[0], Style::Text), printed);
        assert_eq!(
            statement(claim, Style::Unicode)[0],
            "given m, M > 0 in kg·m²/s^(1/2); x ∈ [0, 1] in 1/s; y real in Hz"
        );
        assert_eq!(crate::claim::format::format(with).unwrap(), with.replace("; ", ";  ") + "\n");
    }
}
