//! Claims of the catalogue as tests of one chain.
//!
//! Each compares what the code computes by different ways, exactly: nothing is compared "approximately". An
//! order of two numbers is found by narrowing enclosures, which ends because equal ones are rational here.

use super::strategies;
use crate::chain::best::{Best, best};
use crate::chain::optimum::Optimum;
use crate::chain::pass::Pass;
use crate::chain::threshold::{Helps, helps, threshold};
use crate::chain::{ChainError, Positive, Restitution, Restitutions, recollision, transfer};
use crate::number::decimal::{Digits, Rounding};
use crate::number::real::Real;
use crate::scene::answer::{Answers, Value};
use crate::scene::quantity::Quantity;
use crate::scene::{Chain, Inserted, Scene};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::{Pow, Square};
use malachite::base::num::basic::traits::{One, Two, Zero};
use proptest::prelude::*;
use proptest::strategy::BoxedStrategy;
use std::cmp::Ordering;

/// The most bits with which two numbers are compared.
const MAX_BITS: u64 = 1 << 16;

/// Which chains a property is tried on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Chains {
    /// Given masses.
    Given,
    /// Bodies of optimal mass.
    Optimal,
    /// Bodies of optimal mass and a restitution at or near `L_n`.
    NearThreshold,
    /// Given masses, many of them with a restitution at or near the threshold of one inserted body.
    NearInsertion,
}

/// A claim as a property.
pub struct Property {
    /// The claim's name in the catalogue.
    pub id: &'static str,
    /// What must hold.
    pub statement: &'static str,
    /// On which chains.
    pub chains: Chains,
    /// Whether the catalogue expects it to be refuted.
    pub refuted: bool,
    /// What a saved scene asks for.
    pub want: &'static [&'static str],
    /// The test: what is wrong, if anything.
    pub test: fn(&Chain) -> Result<(), String>,
}

impl Property {
    /// The chains that it is tried on.
    pub fn strategy(&self) -> BoxedStrategy<Chain> {
        match self.chains {
            Chains::Given => strategies::chain().boxed(),
            Chains::Optimal => prop_oneof![3 => strategies::optimal_chain(), 1 => strategies::near_threshold()].boxed(),
            Chains::NearThreshold => {
                prop_oneof![1 => strategies::optimal_chain(), 3 => strategies::near_threshold()].boxed()
            }
            Chains::NearInsertion => prop_oneof![1 => strategies::chain(), 1 => strategies::near_insertion()].boxed(),
        }
    }
}

/// All properties, in the order of the catalogue.
pub const PROPERTIES: &[Property] = &[
    Property {
        id: "eq16",
        statement: "eta is the product (13), (16) of the factors of the collisions",
        chains: Chains::Given,
        refuted: false,
        want: &["eta", "velocities"],
        test: product_formula,
    },
    Property {
        id: "eq19",
        statement: "the n-th body helps if and only if e >= L_n",
        chains: Chains::NearThreshold,
        refuted: false,
        want: &["eta", "threshold", "helps"],
        test: helps_where_eta_rises,
    },
    Property {
        id: "eq20",
        statement: "each inserted mass is the geometric mean of its neighbours",
        chains: Chains::Optimal,
        refuted: false,
        want: &["masses"],
        test: geometric_means,
    },
    Property {
        id: "eq22",
        statement: "the velocities after the pass are (22), (23), (24)",
        chains: Chains::Optimal,
        refuted: false,
        want: &["masses", "velocities"],
        test: velocities,
    },
    Property {
        id: "eq25",
        statement: "eta of the optimal chain is (25)",
        chains: Chains::Optimal,
        refuted: false,
        want: &["eta", "masses"],
        test: optimal_transfer,
    },
    Property {
        id: "p-loss",
        statement: "a collision loses no energy if e = 1, and some if e < 1",
        chains: Chains::Given,
        refuted: false,
        want: &["losses", "velocities"],
        test: losses,
    },
    Property {
        id: "p-order",
        statement: "after its collision no body is faster than the next one",
        chains: Chains::Given,
        refuted: false,
        want: &["velocities"],
        test: order,
    },
    Property {
        id: "p-final",
        statement: "the velocities after one pass are final, as stated",
        chains: Chains::Optimal,
        refuted: true,
        want: &["recollides", "masses", "velocities"],
        test: never_again,
    },
    Property {
        id: "p-final-repaired",
        statement: "they are final if and only if x <= e or x e >= 1",
        chains: Chains::Optimal,
        refuted: false,
        want: &["recollides", "masses", "velocities"],
        test: again_in_between,
    },
    Property {
        id: "p-elastic",
        statement: "elastic: a further body never lowers eta",
        chains: Chains::Optimal,
        refuted: false,
        want: &["eta", "threshold"],
        test: elastic,
    },
    Property {
        id: "p-inelastic",
        statement: "e = 0: a further body always lowers eta",
        chains: Chains::Optimal,
        refuted: false,
        want: &["eta", "threshold"],
        test: inelastic,
    },
    Property {
        id: "b-global",
        statement: "no masses hand on more than the optimal ones",
        chains: Chains::Given,
        refuted: false,
        want: &["eta", "masses"],
        test: global_maximum,
    },
    Property {
        id: "b-closed",
        statement: "eta and L_n do not change when the first and the last mass change places",
        chains: Chains::NearThreshold,
        refuted: false,
        want: &["eta", "threshold"],
        test: symmetry,
    },
    Property {
        id: "b-grow",
        statement: "L_n rises with n, unless the masses are equal",
        chains: Chains::NearThreshold,
        refuted: false,
        want: &["threshold"],
        test: thresholds_rise,
    },
    Property {
        id: "b-best",
        statement: "no number of bodies does better than n*",
        chains: Chains::NearThreshold,
        refuted: false,
        want: &["best-n", "eta"],
        test: best_number,
    },
    Property {
        id: "b-final",
        statement: "where the n-th body helps, the velocities are final",
        chains: Chains::NearThreshold,
        refuted: false,
        want: &["helps", "recollides"],
        test: final_where_it_helps,
    },
    Property {
        id: "b-insert",
        statement: "a given body helps if and only if eta is greater with it than without it",
        chains: Chains::NearInsertion,
        refuted: false,
        want: &["eta", "threshold", "helps"],
        test: given_bodies_help_where_eta_rises,
    },
    Property {
        id: "b-budget",
        statement: "momentum stays, and energy is what is left plus the losses",
        chains: Chains::Given,
        refuted: false,
        want: &["velocities", "losses"],
        test: budget,
    },
];

fn said(error: ChainError) -> String {
    format!("no answer: {error}")
}

/// What is wrong, if the two differ.
fn equal(what: &str, a: &Rational, b: &Rational) -> Result<(), String> {
    if a == b { Ok(()) } else { Err(format!("{what}: {a} is not {b}")) }
}

/// The chain with its given masses, ready for the pass.
fn pass(chain: &Chain) -> Result<Pass, String> {
    let masses = chain.masses().unwrap_or_default().iter().map(|m| m.lo().clone()).collect();
    Pass::from_rest(masses, chain.restitutions().0, Rational::ONE).map_err(said)
}

/// First and last mass, coefficient and number of a chain with bodies of optimal mass.
struct Ends {
    first: Positive,
    last: Positive,
    e: Restitution,
    n: u64,
}

impl Ends {
    fn of(chain: &Chain) -> Result<Ends, String> {
        let e = chain.common_restitution("this property").map_err(said)?.lo().clone();
        Ok(Ends { first: chain.first().lo().clone(), last: chain.last().lo().clone(), e, n: chain.count() })
    }

    fn ratio(&self) -> Positive {
        self.first.over(&self.last)
    }

    fn eta(&self, e: &Restitution, n: u64) -> Result<Real, String> {
        transfer::optimal(&self.ratio(), &Restitutions::Same(e.clone()), n).map_err(said)
    }

    fn optimum(&self) -> Result<Optimum, String> {
        let all = Restitutions::Same(self.e.clone());
        Optimum::new(self.first.clone(), self.last.clone(), self.n, all).map_err(said)
    }
}

/// The order of two reals that are rational where they are equal.
fn order_of(a: &Real, b: &Real) -> Result<Ordering, String> {
    if let (Some(a), Some(b)) = (a.as_rational(), b.as_rational()) {
        return Ok(a.cmp(b));
    }
    let mut bits = 64;
    while bits <= MAX_BITS {
        if let Some(order) = a.enclosure(bits).subtract(&b.enclosure(bits), bits).sign() {
            return Ok(order);
        }
        bits *= 2;
    }
    Err(format!("no order was found with {MAX_BITS} bits"))
}

fn product_formula(chain: &Chain) -> Result<(), String> {
    let pass = pass(chain)?;
    let velocities = pass.velocities_after().map_err(said)?;
    let (Some(first), Some(last), Some(speed)) = (pass.masses().first(), pass.masses().last(), velocities.last())
    else {
        return Err("a chain has a first and a last body".to_owned());
    };
    let stepwise = last.value() * speed.square() / first.value();
    equal("eta step by step and by the product", &stepwise, &pass.transfer().map_err(said)?.into())
}

fn helps_where_eta_rises(chain: &Chain) -> Result<(), String> {
    let ends = Ends::of(chain)?;
    let n = ends.n.max(1);
    let change = order_of(&ends.eta(&ends.e, n)?, &ends.eta(&ends.e, n - 1)?)?;
    let answer = helps(&ends.e, &ends.ratio(), n).map_err(|e| said(e.into()))?.0;
    let expected = match change {
        Ordering::Greater => Helps::Yes,
        Ordering::Less => Helps::No,
        Ordering::Equal => Helps::OnTheThreshold,
    };
    if answer == expected {
        Ok(())
    } else {
        Err(format!("whether body {n} helps: {}, but eta tells: {}", answer.text(), expected.text()))
    }
}

/// eta of given masses and a coefficient for each collision, one collision after the other.
fn eta_of(masses: Vec<Positive>, restitutions: Vec<Restitution>) -> Result<Rational, String> {
    let pass = Pass::from_rest(masses, Restitutions::Each(restitutions), Rational::ONE).map_err(said)?;
    let velocities = pass.velocities_after().map_err(said)?;
    match (pass.masses().first(), pass.masses().last(), velocities.last()) {
        (Some(first), Some(last), Some(speed)) => Ok(last.value() * speed.square() / first.value()),
        _ => Err("a chain has a first and a last body".to_owned()),
    }
}

/// What `helps` and `threshold` say of each inserted body, against eta of the chain without it.
fn given_bodies_help_where_eta_rises(chain: &Chain) -> Result<(), String> {
    let inputs = chain.clone().into();
    let want = vec![Quantity::Helps, Quantity::Threshold];
    let scene = Scene { want, digits: Digits::Significant(6), rounding: Rounding::Nearest, inputs };
    let answers = Answers::new(&scene);
    if chain.count() == 0 {
        return Ok(());
    }
    let (Value::EachHelps(found), Value::List(thresholds)) =
        (answers.get(Quantity::Helps).map_err(said)?.0, answers.get(Quantity::Threshold).map_err(said)?.0)
    else {
        return Err("given masses have an answer for each inserted body".to_owned());
    };
    let masses: Vec<Positive> = chain.masses().unwrap_or_default().iter().map(|m| m.lo().clone()).collect();
    let restitutions = chain.restitutions().0;
    let all: Vec<Restitution> = (0..=chain.count()).filter_map(|i| restitutions.at(i).cloned()).collect();
    let with = eta_of(masses.clone(), all.clone())?;
    for (k, (answer, threshold)) in (1..).zip(found.iter().zip(thresholds)) {
        let mut others = masses.clone();
        others.remove(k);
        let change = |direct: &Restitution| {
            let mut list = all.clone();
            list.splice(k - 1..=k, [direct.clone()]);
            Ok::<_, String>(match with.cmp(&eta_of(others.clone(), list)?) {
                Ordering::Greater => Helps::Yes,
                Ordering::Less => Helps::No,
                Ordering::Equal => Helps::OnTheThreshold,
            })
        };
        let [before, after] = all.get(k - 1..=k).unwrap_or_default() else {
            return Err("each body has two collisions".to_owned());
        };
        let (one, other) = (change(before)?, change(after)?);
        let expected = (one == other).then_some(one);
        if *answer != expected {
            return Err(format!("whether body {k} helps: {answer:?}, but eta tells {expected:?}"));
        }
        // One coefficient for the three collisions: its order against the threshold is the answer.
        if before == after {
            let exact = threshold.exact.as_ref().ok_or("the threshold is rational")?;
            let order = before.value().cmp(exact);
            let wanted = [(Helps::Yes, Ordering::Greater), (Helps::No, Ordering::Less)];
            let wanted = wanted.iter().find(|pair| pair.0 == one).map_or(Ordering::Equal, |pair| pair.1);
            if order != wanted {
                return Err(format!("body {k}: e against its threshold {exact}: {order:?}, but eta tells {one:?}"));
            }
        }
    }
    Ok(())
}

/// The ratio of neighbours and all masses, where they are rational.
fn exact_masses(optimum: &Optimum) -> Option<(Rational, Vec<Rational>)> {
    let x = optimum.step().as_rational()?.clone();
    let masses = (0..=optimum.collisions()).map(|i| optimum.mass(i).as_rational().cloned()).collect::<Option<_>>()?;
    Some((x, masses))
}

fn geometric_means(chain: &Chain) -> Result<(), String> {
    let optimum = Ends::of(chain)?.optimum()?;
    let Some((x, masses)) = exact_masses(&optimum) else { return Ok(()) };
    for window in masses.windows(3) {
        let [a, m, b] = window else { continue };
        equal("a mass squared and the product of its neighbours", &m.square(), &(a * b))?;
    }
    for pair in masses.windows(2) {
        let [a, b] = pair else { continue };
        equal("the ratio of neighbours", &(a / b), &x)?;
    }
    Ok(())
}

/// The pass along the exact masses of an optimal chain.
fn exact_pass(ends: &Ends, masses: Vec<Rational>) -> Result<Pass, String> {
    let masses = masses.into_iter().map(Positive::new).collect::<Result<Vec<_>, _>>().map_err(said)?;
    Pass::from_rest(masses, Restitutions::Same(ends.e.clone()), Rational::ONE).map_err(said)
}

fn velocities(chain: &Chain) -> Result<(), String> {
    let ends = Ends::of(chain)?;
    let optimum = ends.optimum()?;
    let Some((x, masses)) = exact_masses(&optimum) else { return Ok(()) };
    let stepwise = exact_pass(&ends, masses)?.velocities_after().map_err(said)?;
    let (e, above) = (ends.e.value(), &x + Rational::ONE);
    let gain = &x * ends.e.plus_one() / &above;
    for (i, found) in stepwise.iter().enumerate() {
        let i = i as u64;
        let printed = if i == optimum.collisions() { (&gain).pow(i) } else { (&gain).pow(i) * (&x - e) / &above };
        equal(&format!("velocity of body {} step by step and by the formula", i + 1), found, &printed)?;
        let computed = optimum.velocity(i, &Rational::ONE);
        equal("the same as computed", computed.as_rational().unwrap_or(&Rational::TWO), &printed)?;
    }
    Ok(())
}

fn optimal_transfer(chain: &Chain) -> Result<(), String> {
    let ends = Ends::of(chain)?;
    let Some((_, masses)) = exact_masses(&ends.optimum()?) else { return Ok(()) };
    let stepwise = Rational::from(exact_pass(&ends, masses)?.transfer().map_err(said)?);
    match ends.eta(&ends.e, ends.n)?.as_rational() {
        Some(formula) => equal("eta of the masses and by (25)", &stepwise, formula),
        None => Err("eta is rational, and not found to be".to_owned()),
    }
}

fn losses(chain: &Chain) -> Result<(), String> {
    let restitutions = chain.restitutions().0;
    for (i, loss) in pass(chain)?.losses().map_err(said)?.iter().enumerate() {
        let elastic = restitutions.at(i as u64).is_some_and(|e| *e.value() == Rational::ONE);
        let right = if elastic { *loss == Rational::ZERO } else { *loss > Rational::ZERO };
        if !right {
            return Err(format!("the loss of collision {} is {loss}", i + 1));
        }
    }
    Ok(())
}

fn order(chain: &Chain) -> Result<(), String> {
    for (i, collision) in pass(chain)?.collisions().map_err(said)?.iter().enumerate() {
        let (behind, front) = &collision.after;
        if behind > front {
            return Err(format!("after collision {} the body behind has {behind}, the one in front {front}", i + 1));
        }
    }
    Ok(())
}

fn again(ends: &Ends) -> Result<bool, String> {
    Ok(recollision::of_optimum(&ends.optimum()?).map_err(said)?.0)
}

fn never_again(chain: &Chain) -> Result<(), String> {
    let ends = Ends::of(chain)?;
    if again(&ends)? { Err("bodies meet again after the pass".to_owned()) } else { Ok(()) }
}

fn again_in_between(chain: &Chain) -> Result<(), String> {
    let ends = Ends::of(chain)?;
    let (found, e) = (again(&ends)?, ends.e.value());
    let Some((x, masses)) = exact_masses(&ends.optimum()?) else { return Ok(()) };
    // Two bodies separate, and that is all.
    let between = ends.n > 0 && *e < x && e * &x < Rational::ONE;
    let stepwise = exact_pass(&ends, masses)?.velocities_after().map_err(said)?;
    let faster = recollision::of_velocities(&stepwise);
    if found == between && found == faster {
        Ok(())
    } else {
        Err(format!("meet again: {found}; e < x < 1/e: {between}; some body is faster than the next: {faster}"))
    }
}

/// eta with the chain's number of bodies against one less, for another restitution.
fn change_at(chain: &Chain, e: Rational) -> Result<Ordering, String> {
    let ends = Ends::of(chain)?;
    let (e, n) = (Restitution::new(e).map_err(said)?, ends.n.max(1));
    order_of(&ends.eta(&e, n)?, &ends.eta(&e, n - 1)?)
}

fn elastic(chain: &Chain) -> Result<(), String> {
    let equal = chain.first() == chain.last();
    match change_at(chain, Rational::ONE)? {
        Ordering::Greater if !equal => Ok(()),
        Ordering::Equal if equal => Ok(()),
        found => Err(format!("equal masses: {equal}; the change of eta: {found:?}")),
    }
}

fn inelastic(chain: &Chain) -> Result<(), String> {
    match change_at(chain, Rational::ZERO)? {
        Ordering::Less => Ok(()),
        found => Err(format!("the change of eta: {found:?}")),
    }
}

fn global_maximum(chain: &Chain) -> Result<(), String> {
    let given = Real::rational(pass(chain)?.transfer().map_err(said)?.into());
    let ratio = chain.first().lo().over(chain.last().lo());
    let most = transfer::optimal(&ratio, &chain.restitutions().0, chain.count()).map_err(said)?;
    match order_of(&given, &most)? {
        Ordering::Greater => Err("the given masses hand on more than the optimal ones".to_owned()),
        _ => Ok(()),
    }
}

fn symmetry(chain: &Chain) -> Result<(), String> {
    let ends = Ends::of(chain)?;
    let turned = Ends { first: ends.last.clone(), last: ends.first.clone(), ..Ends::of(chain)? };
    let n = ends.n.max(1);
    let both = |a: &Real, b: &Real, what: &str| match (a.as_rational(), b.as_rational()) {
        (Some(a), Some(b)) => equal(what, a, b),
        (None, None) => {
            // Both irrational: their enclosures must overlap at every precision that is tried.
            let apart = [64, 256, 1024]
                .into_iter()
                .any(|bits| a.enclosure(bits).subtract(&b.enclosure(bits), bits).sign().is_some());
            if apart { Err(format!("{what} differ")) } else { Ok(()) }
        }
        _ => Err(format!("{what}: one is rational, the other is not")),
    };
    both(&ends.eta(&ends.e, n)?, &turned.eta(&ends.e, n)?, "eta and eta of the chain turned round")?;
    let bound = |ends: &Ends| threshold(&ends.ratio(), n).map_err(|e| said(e.into()));
    both(&bound(&ends)?, &bound(&turned)?, "L_n and L_n of the chain turned round")
}

fn thresholds_rise(chain: &Chain) -> Result<(), String> {
    let ends = Ends::of(chain)?;
    let n = ends.n.max(1);
    let bound = |n| threshold(&ends.ratio(), n).map_err(|e| said(e.into()));
    let expected = if ends.first == ends.last { Ordering::Equal } else { Ordering::Less };
    let found = order_of(&bound(n)?, &bound(n + 1)?)?;
    if found == expected { Ok(()) } else { Err(format!("L_{n} against L_{}: {found:?}", n + 1)) }
}

fn best_number(chain: &Chain) -> Result<(), String> {
    let ends = Ends::of(chain)?;
    let (found, _) = best(&ends.ratio(), &ends.e).map_err(said)?;
    let Best::Finite { count, tie } = found else {
        return if *ends.e.value() == Rational::ONE { Ok(()) } else { Err(format!("{found:?} although e < 1")) };
    };
    let Ok(count) = u64::try_from(&count) else { return Ok(()) };
    if count > 1_000 {
        return Ok(());
    }
    let at = |n| ends.eta(&ends.e, n);
    if order_of(&at(count)?, &at(count + 1)?)? != Ordering::Greater {
        return Err(format!("{} bodies do as well as n* = {count}", count + 1));
    }
    let Some(fewer) = count.checked_sub(1) else { return Ok(()) };
    let expected = if tie { Ordering::Equal } else { Ordering::Greater };
    let order = order_of(&at(count)?, &at(fewer)?)?;
    if order == expected { Ok(()) } else { Err(format!("n* = {count} against {fewer}: {order:?}, tie: {tie}")) }
}

fn final_where_it_helps(chain: &Chain) -> Result<(), String> {
    let ends = Ends::of(chain)?;
    if ends.n == 0 {
        return Ok(());
    }
    let answer = helps(&ends.e, &ends.ratio(), ends.n).map_err(|e| said(e.into()))?.0;
    if answer != Helps::No && again(&ends)? {
        return Err("the last body helps, and bodies meet again".to_owned());
    }
    Ok(())
}

fn budget(chain: &Chain) -> Result<(), String> {
    if matches!(chain.inserted(), Inserted::Optimal(_)) {
        return Ok(());
    }
    let pass = pass(chain)?;
    let after = pass.velocities_after().map_err(said)?;
    let sum = |of: fn(&Rational) -> Rational, velocities: &[Rational]| {
        let terms = pass.masses().iter().zip(velocities).map(|(m, v)| m.value() * of(v));
        terms.fold(Rational::ZERO, |a, b| a + b)
    };
    let before = pass.velocities_before();
    equal("momentum before and after", &sum(Clone::clone, before), &sum(Clone::clone, &after))?;
    let energy = |velocities: &[Rational]| sum(|v| v.square(), velocities) / Rational::TWO;
    let lost = pass.losses().map_err(said)?.into_iter().fold(Rational::ZERO, |a, b| a + b);
    equal("energy before, and after with the losses", &energy(before), &(energy(&after) + lost))
}
