//! The methods that prove comparisons, as a table: in the order of their cost, each with what it serves and what it may spend.
//!
//! A method that is new gets a row here, and a file of its own. Its name is what explanations print, and what `carom audit --without`
//! leaves out.

use super::comparison::single;
use super::{Fail, Prover, ideal};
use crate::certificate::{Label, Rule};
use crate::claim::print;
use crate::claim::syntax::Prop;
use crate::claim::syntax::Relation::{self, Equal, Greater, GreaterEqual, Less, LessEqual, NotEqual};
use crate::refute::outcome::Remaining;

/// How many goals that remained are noted.
const REMAINING: usize = 4;

/// A way to prove a comparison.
struct Method {
    /// Its name; rows of one procedure, with more and more effort, share theirs.
    name: &'static str,
    /// The relations that it serves.
    relations: &'static [Relation],
    /// It is tried within fewer nested case distinctions than this; a goal for which little effort is due counts as within eight or
    /// nine.
    below: usize,
    /// What it may spend.
    effort: Effort,
    /// Shows the goal.
    run: fn(&mut Prover, &Prop) -> Result<Label, Fail>,
}

/// What a method may spend, and what stays if it fails.
#[derive(Clone, Copy)]
enum Effort {
    /// All that is left; facts that it found stay.
    Kept,
    /// All that is left; what it found is undone.
    Undone,
    /// Half of what is left; what it found is undone.
    Half,
    /// As much as a claim of its own; what it found is undone.
    Own,
}
use Effort::{Half, Kept, Own, Undone};

const ALL: &[Relation] = &[Equal, NotEqual, Less, LessEqual, Greater, GreaterEqual];
const ORDERS: &[Relation] = &[Less, LessEqual, Greater, GreaterEqual];
const STRICT: &[Relation] = &[Less, Greater];
const EQUATION: &[Relation] = &[Equal];
const DENIAL: &[Relation] = &[NotEqual];
const NO_EQUATION: &[Relation] = &[NotEqual, Less, LessEqual, Greater, GreaterEqual];
const NO_DENIAL: &[Relation] = &[Equal, Less, LessEqual, Greater, GreaterEqual];

/// Within any number of case distinctions, with little effort too.
const ALWAYS: usize = usize::MAX;
/// Where there is effort for more than one small linear program.
const NOT_LEAST: usize = 9;
/// Where more than little effort is due.
const LOUD: usize = 8;
/// Within two case distinctions at most.
const FEW: usize = 3;

const fn row(
    name: &'static str,
    relations: &'static [Relation],
    below: usize,
    effort: Effort,
    run: fn(&mut Prover, &Prop) -> Result<Label, Fail>,
) -> Method {
    Method { name, relations, below, effort, run }
}

/// The first method, which also says what the kernel is too small for.
const AT_ONCE: &str = "signs and arithmetic";

/// What shows a comparison without cases and inductions.
const DIRECT: &[Method] = &[
    row("arcs", ALL, ALWAYS, Kept, |c, goal| c.by_arcs(goal)),
    row("angles", ALL, ALWAYS, Kept, |c, goal| c.by_angles(goal)),
    row("chains", ALL, ALWAYS, Kept, |c, goal| c.by_chain(goal)),
    row("absolute values", ALL, ALWAYS, Own, |c, goal| c.with_half_of_the_time(|c| c.by_written_absolute_values(goal))),
    row("integrals", ALL, ALWAYS, Kept, |c, goal| c.by_integrals(goal)),
    row("tangents of a step", ALL, ALWAYS, Kept, |c, goal| c.by_tangent_of_a_step(goal)),
    row("growth of terms", ORDERS, 1, Own, |c, goal| c.by_growth(goal)),
    row("bounds of powers", ORDERS, 1, Own, |c, goal| c.by_bounds_of_powers(goal)),
    row("powers of two bases", ORDERS, 1, Own, |c, goal| c.by_powers_of_two_bases(goal)),
    row("sums in closed form", ALL, LOUD, Undone, |c, goal| c.by_sums(goal)),
    row("ranges of sums", NO_DENIAL, 1, Own, |c, goal| c.by_ranges(goal)),
    row("moving products", ALL, ALWAYS, Kept, |c, goal| c.by_moving_products(goal)),
    row("members in closed form", ALL, ALWAYS, Undone, |c, goal| c.by_members_in_closed_form(goal)),
    row("members of sums", ALL, ALWAYS, Kept, |c, goal| c.by_members(goal)),
    row("weighted tangents", ALL, LOUD, Undone, |c, goal| c.by_weighted_tangents(goal)),
    row("Hölder's inequality", ORDERS, LOUD, Own, |c, goal| c.by_hoelder(goal, true)),
    row("conclusions", ALL, LOUD, Kept, |c, goal| {
        if c.conclude_at_once() { c.quietly(goal) } else { Err(Fail::No("a known premise")) }
    }),
    row("halved sums", ALL, LOUD, Own, |c, goal| c.by_halved_sums(goal)),
    row("parts of pi", EQUATION, ALWAYS, Undone, |c, goal| c.by_parts_of_pi(goal)),
    row("products of facts", ALL, ALWAYS, Undone, |c, goal| c.by_products(goal, 0)),
    row("ideals", EQUATION, ALWAYS, Undone, |c, goal| c.by_ideal(goal)),
    row("completed squares", ORDERS, ALWAYS, Undone, |c, goal| c.by_completed_square(goal)),
    row("differences of variables", ORDERS, ALWAYS, Undone, |c, goal| c.by_differences(goal, 0..=0)),
    row("sums of squares", ORDERS, FEW, Undone, |c, goal| c.by_sums_of_squares(goal)),
    row("contradictions", NO_EQUATION, ALWAYS, Undone, |c, goal| c.by_contradiction(goal, 0)),
    row("products of facts", ALL, ALWAYS, Undone, |c, goal| c.by_products(goal, 1)),
    row("solved equations", EQUATION, ALWAYS, Undone, |c, goal| {
        c.with_solved_equations(|c| {
            // With the letters that came in by the equations.
            c.at_once(goal).or_else(|_| c.by_products(goal, 1)).or_else(|_| c.by_ideal(goal))
        })
    }),
    row("differences of variables", ORDERS, FEW, Undone, |c, goal| c.by_differences(goal, 1..=1)),
    row("roots", ORDERS, LOUD, Undone, |c, goal| c.by_root_bounds(goal)),
    row("Positivstellensatz", NO_EQUATION, FEW, Undone, |c, goal| c.by_positivstellensatz(goal)),
    row("contradictions", NO_EQUATION, ALWAYS, Undone, |c, goal| c.by_contradiction(goal, 1)),
    // Larger linear programs seldom decide comparisons about roots.
    row("roots", NO_DENIAL, LOUD, Kept, |c, goal| c.by_roots(goal)),
    row("products of facts", ALL, NOT_LEAST, Undone, |c, goal| c.by_products(goal, 2)),
    row("Positivstellensatz", EQUATION, FEW, Undone, |c, goal| c.by_positivstellensatz(goal)),
    row("differences of variables", ORDERS, FEW, Undone, |c, goal| c.by_differences(goal, 2..=3)),
    row("contradictions", NO_EQUATION, NOT_LEAST, Undone, |c, goal| c.by_contradiction(goal, 2)),
    row("homogeneous forms", ORDERS, LOUD, Own, |c, goal| c.by_homogeneous(goal)),
    row("a linear unknown", ALL, LOUD, Kept, |c, goal| c.by_linear_unknown(goal)),
    row("evaluation", ALL, ALWAYS, Kept, |c, goal| {
        if c.speaks_of_numbers(goal) { c.emit(Rule::Evaluate, goal.clone()) } else { Err(Fail::No("numbers")) }
    }),
    row("logarithms", ALL, ALWAYS, Undone, |c, goal| c.of_logarithms(goal)),
    row("logarithms", ORDERS, ALWAYS, Undone, |c, goal| c.by_order_of_logarithms(goal)),
    row("powers of exponentials", ALL, ALWAYS, Undone, |c, goal| c.by_power_of_exponential(goal)),
    row("powers of facts", ALL, ALWAYS, Kept, |c, goal| c.by_powers(goal)),
    row("whole numbers", ALL, ALWAYS, Undone, |c, goal| c.by_whole_numbers(goal)),
    row("boxes of whole numbers", ALL, LOUD, Kept, |c, goal| c.by_boxes(goal)),
    row("both orders", EQUATION, LOUD, Kept, |c, goal| c.by_both_orders(goal)),
    row("strict orders", DENIAL, ALWAYS, Kept, |c, goal| c.by_strict_order(goal)),
    row("denied equations", ALL, LOUD, Kept, |c, goal| c.by_denied_equation(goal)),
    row("weak orders", STRICT, LOUD, Own, |c, goal| c.by_weak_order(goal)),
    row("Hölder's inequality", ORDERS, LOUD, Own, |c, goal| c.by_hoelder(goal, false)),
    row("values at means", ORDERS, LOUD, Own, |c, goal| c.by_jensen(goal)),
    row("weighted means", ALL, LOUD, Kept, |c, goal| {
        c.attempt(|c| c.by_means(goal)).or_else(|_| c.with_solved_equations(|c| c.by_means(goal)))
    }),
    row("means", ALL, LOUD, Undone, |c, goal| c.by_means_of_many(goal)),
    // The same with variables written by others, as c = 1/(a·b) where a·b·c = 1.
    row("means", ALL, LOUD, Kept, |c, goal| c.with_solved_equations(|c| c.by_means_of_many(goal))),
    row("tangents", ALL, LOUD, Undone, |c, goal| c.by_tangents(goal)),
    row("sums of tangents", ORDERS, LOUD, Own, |c, goal| c.by_tangent_sums(goal)),
    row("sign charts", ALL, LOUD, Half, |c, goal| c.by_sign_chart(goal)),
    row("values of one function", ALL, LOUD, Kept, |c, goal| c.by_common_function(goal)),
    row("an equation that fails", ALL, LOUD, Undone, |c, goal| c.by_failing_equation(goal)),
    row("logarithms of the sides", ALL, LOUD, Own, |c, goal| c.by_logarithms(goal)),
    row("tails of sums", ALL, LOUD, Undone, |c, goal| c.by_what_is_left(goal)),
    row("steps of sums", NO_DENIAL, 1, Own, |c, goal| c.with_half_of_the_time(|c| c.by_steps_of_sums(goal))),
    row("integral test", ORDERS, LOUD, Own, |c, goal| c.by_integral_test(goal)),
    row("divisors multiplied out", ALL, LOUD, Undone, |c, goal| c.without_divisors(goal)),
    row("slopes", ALL, LOUD, Undone, |c, goal| c.by_slope(goal)),
    row("exponents", ALL, LOUD, Undone, |c, goal| c.by_exponents(goal)),
    row("roots of the sides", ALL, LOUD, Own, |c, goal| c.by_roots_of_sides(goal)),
    row("signs of factors", ALL, LOUD, Undone, |c, goal| c.by_signs_of_factors(goal)),
    row(
        "conclusions",
        ALL,
        LOUD,
        Kept,
        |c, goal| {
            if c.saturate() { c.quietly(goal) } else { Err(Fail::No("a premise")) }
        },
    ),
    row("ideals", ALL, LOUD, Undone, |c, goal| c.absurd_by_ideal(goal, &[ideal::FIRST_WORK])),
    row("ideals", EQUATION, LOUD, Undone, |c, goal| c.by_radical_ideal(goal)),
    row("the opposite", &[NotEqual, Less, Greater], LOUD, Undone, |c, goal| c.by_opposite(goal)),
    row("units", ORDERS, LOUD, Own, |c, goal| c.by_scaling(goal)),
    // Last, for it tries many instances.
    row("instances", ALL, LOUD, Kept, |c, goal| c.by_universal_facts(goal)),
];

/// What shows a comparison in several parts. Inside an induction cases come first, since its hypothesis is available.
const IN_PARTS: &[Method] = &[
    row("absolute values", ALL, FEW, Own, |c, goal| c.by_absolute_values(goal)),
    row("signs of divisors", ALL, ALWAYS, Undone, |c, goal| c.by_signs_of_divisors(goal)),
    row("induction", ALL, ALWAYS, Kept, |c, goal| c.within_inductions(false, |c| c.by_induction(goal))),
    row("strengthened inductions", ORDERS, 1, Own, |c, goal| c.by_strengthened_induction(goal)),
    row("points of circles", ORDERS, FEW, Own, |c, goal| c.by_points_of_circles(goal)),
    row("invariants", ALL, 1, Own, |c, goal| c.by_invariants(goal)),
    row("cases", ALL, FEW, Kept, |c, goal| c.by_cases(goal)),
    row("induction", ALL, ALWAYS, Kept, |c, goal| c.within_inductions(true, |c| c.by_induction(goal))),
    row("remainders", ALL, 1, Kept, |c, goal| {
        let is_order = single(goal)?.1.is_greater().is_some();
        if is_order && !Prover::has_a_floor(goal) { Err(Fail::No("remainders")) } else { c.by_residues(goal) }
    }),
];

/// The names of all methods that can be left out, each once.
pub fn names() -> Vec<&'static str> {
    let mut names = Vec::new();
    for method in DIRECT.iter().chain(IN_PARTS) {
        if !names.contains(&method.name) {
            names.push(method.name);
        }
    }
    names
}

impl Prover {
    /// Shows a single comparison, by the methods in their order.
    pub(super) fn comparison_or_parts(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let mut tried = vec![AT_ONCE];
        self.within_comparisons += 1;
        let shown = match self.attempt(|c| c.directly(goal, &mut tried)) {
            Err(first) => self.one_of(IN_PARTS, goal, &mut tried).map_err(|_| first),
            shown => shown,
        };
        self.within_comparisons -= 1;
        if shown.is_err() && self.within_comparisons == 0 {
            self.note_remaining(goal, tried);
        }
        shown
    }

    /// Shows a single comparison without cases and inductions.
    pub(super) fn comparison(&mut self, goal: &Prop) -> Result<Label, Fail> {
        self.directly(goal, &mut Vec::new())
    }

    fn directly(&mut self, goal: &Prop, tried: &mut Vec<&'static str>) -> Result<Label, Fail> {
        let first = match self.at_once(goal) {
            Ok(label) => {
                self.found_by.push(AT_ONCE);
                return Ok(label);
            }
            Err(fail) => fail,
        };
        // What the kernel is too small for, no other way makes smaller.
        self.one_of(DIRECT, goal, tried).map_err(|_| match first.limit() {
            Some(_) => Fail::Goal(print::prop(goal), Box::new(first)),
            None => Fail::NotShown(print::prop(goal)),
        })
    }

    /// Shows a comparison by the first method of a table that does, and adds the names of those that were tried.
    fn one_of(&mut self, methods: &[Method], goal: &Prop, tried: &mut Vec<&'static str>) -> Result<Label, Fail> {
        let relation = single(goal)?.1;
        for method in methods {
            if self.splits >= method.below
                || !method.relations.contains(&relation)
                || self.without.iter().any(|name| name == method.name)
            {
                continue;
            }
            if self.is_late() {
                return Err(Fail::Limit("time"));
            }
            let before = self.ticks;
            let shown = match method.effort {
                Kept => (method.run)(self, goal),
                Undone => self.attempt(|c| (method.run)(c, goal)),
                Half => self.with_half(|c| (method.run)(c, goal)),
                Own => self.on_its_own(|c| (method.run)(c, goal)),
            };
            if shown.is_ok() {
                self.found_by.push(method.name);
                return shown;
            }
            // A method that the goal does not fit takes no step.
            if self.ticks > before && !tried.contains(&method.name) {
                tried.push(method.name);
            }
        }
        Err(Fail::No("a method"))
    }

    /// Notes a goal that no method showed, with the parts of its difference whose sign is open.
    fn note_remaining(&mut self, goal: &Prop, tried: Vec<&'static str>) {
        let goal_text = print::prop(goal);
        if self.remaining.len() < REMAINING && self.remaining.iter().all(|r| r.goal != goal_text) {
            let open = self.open_parts(goal);
            self.remaining.push(Remaining { goal: goal_text, tried, open });
        }
    }
}
