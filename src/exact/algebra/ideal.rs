//! Ideal membership: that a polynomial is a sum of multiples of others, with the steps that show it.
//!
//! Method: Buchberger's algorithm modulo a prime, in the graded reverse lexicographic order, with the criteria of Gebauer and
//! Möller (Becker, Weispfenning, "Gröbner Bases", section 5.5). Nothing but the way to each element is kept: of which pair
//! it is made, and what it was divided by. As soon as the goal is reduced to 0, the elements on which that rests are made
//! again over the rational numbers, each from those before it. The pairs that came to nothing, the most of them, are never made
//! again, and no cofactor in the given polynomials is multiplied out.
//!
//! The prime decides only which way is tried: what [`derivation`] returns is an identity of rational polynomials.

use super::Polynomial;
use super::monomial::Monomial;
use super::residue::{self, add, inverse, multiply, negate};
use malachite::Rational;
use malachite::base::num::basic::traits::One;
use std::collections::{BTreeMap, BTreeSet};

/// The most variables.
const VARIABLES: usize = 31;

/// The highest degree.
const DEGREE: u32 = 60;

/// The most pairs of which an S-polynomial is taken.
const PAIRS: usize = 4_000;

/// The most terms of an element over the rational numbers, and the most bits of its coefficients.
const SIZE: (usize, usize) = (1_500, 1_000);

/// An element made of earlier ones: the given polynomials come first, then the steps in their order.
#[derive(Clone, Debug)]
pub struct Step {
    /// The element.
    pub poly: Polynomial,
    /// It is the sum of these factors times the elements at these places.
    pub parts: Vec<(usize, Polynomial)>,
}

/// How a polynomial is a sum of multiples of given ones.
#[derive(Clone, Debug)]
pub struct Derivation {
    /// The elements between.
    pub steps: Vec<Step>,
    /// The goal is the sum of these factors times the elements at these places.
    pub goal: Vec<(usize, Polynomial)>,
}

/// A monomial: its degree, then 255 − exponent for each variable, the last variable first. Bytes compare as the graded reverse
/// lexicographic order does.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
struct Power([u8; VARIABLES + 1]);

impl Power {
    fn of(m: &Monomial, variables: &[u32]) -> Option<Power> {
        let mut out = [255; VARIABLES + 1];
        out[0] = u8::try_from(m.degree()).ok().filter(|d| u32::from(*d) <= DEGREE)?;
        for (v, k) in m.powers() {
            let place = variables.iter().position(|w| w == v)?;
            out[variables.len() - place] = 255 - u8::try_from(*k).ok()?;
        }
        Some(Power(out))
    }

    fn monomial(&self, variables: &[u32]) -> Option<Monomial> {
        let count = variables.len();
        let powers: Vec<(u32, u32)> = variables
            .iter()
            .enumerate()
            .map(|(place, v)| (*v, u32::from(255 - self.0[count - place])))
            .filter(|p| p.1 > 0)
            .collect();
        Monomial::new(&powers).ok()
    }

    fn degree(&self) -> u32 {
        u32::from(self.0[0])
    }

    fn divides(&self, other: &Power) -> bool {
        self.0[1..].iter().zip(&other.0[1..]).all(|(a, b)| a >= b)
    }

    /// The product; its degree is within bounds, since it is checked before.
    fn times(&self, other: &Power) -> Power {
        let mut out = [0; VARIABLES + 1];
        out[0] = self.0[0].wrapping_add(other.0[0]);
        for (o, (a, b)) in out[1..].iter_mut().zip(self.0[1..].iter().zip(&other.0[1..])) {
            *o = a.wrapping_add(*b).wrapping_add(1);
        }
        Power(out)
    }

    /// The quotient by a divisor.
    fn over(&self, divisor: &Power) -> Power {
        let mut out = [0; VARIABLES + 1];
        out[0] = self.0[0].wrapping_sub(divisor.0[0]);
        for (o, (a, b)) in out[1..].iter_mut().zip(self.0[1..].iter().zip(&divisor.0[1..])) {
            *o = a.wrapping_sub(*b).wrapping_sub(1);
        }
        Power(out)
    }

    fn least_common_multiple(&self, other: &Power) -> Power {
        let mut out = [255; VARIABLES + 1];
        let mut degree = 0u32;
        for (o, (a, b)) in out[1..].iter_mut().zip(self.0[1..].iter().zip(&other.0[1..])) {
            *o = *a.min(b);
            degree += u32::from(255 - *o);
        }
        out[0] = u8::try_from(degree).unwrap_or(u8::MAX);
        Power(out)
    }
}

/// A polynomial modulo the prime.
type Residue = BTreeMap<Power, u64>;

/// What an element is made of.
enum Origin {
    Given,
    /// Of this pair, then divided by these elements times these monomials in turn.
    Pair(usize, usize, Vec<(usize, Power)>),
}

struct Element {
    /// Its terms behind the leading one, whose coefficient is 1.
    tail: Vec<(Power, u64)>,
    lead: Power,
    sugar: u32,
    origin: Origin,
    /// Whether no later element's leading term divides its own.
    is_minimal: bool,
}

struct Buchberger {
    elements: Vec<Element>,
    /// Pairs by sugar and by the least common multiple of the leading terms.
    pairs: BTreeSet<(u32, Power, usize, usize)>,
    work: usize,
}

impl Buchberger {
    /// Subtracts `c·m·element` from a residue whose term `m·lead` is to vanish.
    fn subtract(&mut self, from: &mut Residue, c: u64, m: &Power, element: usize) -> Option<()> {
        let g = &self.elements[element];
        self.work = self.work.checked_sub(g.tail.len() + 1)?;
        from.remove(&m.times(&g.lead));
        for (power, k) in &g.tail {
            let less = multiply(c, *k);
            let at = m.times(power);
            let entry = from.entry(at).or_insert(0);
            *entry = add(*entry, negate(less));
            if *entry == 0 {
                from.remove(&at);
            }
        }
        Some(())
    }

    /// The element with the fewest terms whose leading term divides a monomial.
    fn divisor(&self, of: &Power) -> Option<usize> {
        let all = self.elements.iter().enumerate().filter(|(_, g)| g.is_minimal && g.lead.divides(of));
        all.min_by_key(|(_, g)| g.tail.len()).map(|(k, _)| k)
    }

    /// Divides the leading terms away as long as that is possible; returns by what.
    fn divide(&mut self, p: &mut Residue) -> Option<Vec<(usize, Power)>> {
        let mut by = Vec::new();
        while let Some((top, c)) = p.last_key_value().map(|(m, c)| (*m, *c)) {
            let Some(k) = self.divisor(&top) else { break };
            let m = top.over(&self.elements[k].lead);
            self.subtract(p, c, &m, k)?;
            by.push((k, m));
        }
        Some(by)
    }

    /// Adds an element; pairs with it that cannot give anything new are left out, and so are old ones.
    fn add(&mut self, mut p: Residue, origin: Origin, sugar: u32) -> Option<()> {
        let (lead, c) = p.pop_last()?;
        let scale = inverse(c);
        let tail = p.into_iter().rev().map(|(m, k)| (m, multiply(k, scale))).collect();
        let new = self.elements.len();
        // An old pair whose multiple the new leading term divides goes, unless it is the multiple with one of its own.
        let leads: Vec<Power> = self.elements.iter().map(|g| g.lead).collect();
        self.pairs.retain(|(_, both, i, j)| {
            !lead.divides(both)
                || leads[*i].least_common_multiple(&lead) == *both
                || leads[*j].least_common_multiple(&lead) == *both
        });
        let open: Vec<(Power, usize)> = (0..new)
            .filter(|i| self.elements[*i].is_minimal)
            .map(|i| (leads[i].least_common_multiple(&lead), i))
            .collect();
        for (at, (both, i)) in open.iter().enumerate() {
            let is_implied = open.iter().enumerate().any(|(other, (multiple, _))| {
                other != at && multiple.divides(both) && (multiple != both || other < at)
            });
            let is_coprime = both.degree() == leads[*i].degree() + lead.degree();
            if !is_implied && !is_coprime && both.degree() <= DEGREE {
                let own = |sugar: u32, lead: &Power| sugar + both.degree() - lead.degree();
                let sugar = own(self.elements[*i].sugar, &leads[*i]).max(own(sugar, &lead));
                self.pairs.insert((sugar, *both, *i, new));
            }
        }
        for g in self.elements.iter_mut().filter(|g| lead.divides(&g.lead)) {
            g.is_minimal = false;
        }
        self.elements.push(Element { tail, lead, sugar, origin, is_minimal: true });
        Some(())
    }

    /// Divides every term of the goal that can be divided now.
    fn divide_goal(&mut self, goal: &mut Residue, by: &mut Vec<(usize, Power)>) -> Option<()> {
        let mut below: Option<Power> = None;
        loop {
            let next = match below {
                None => goal.last_key_value().map(|(m, c)| (*m, *c)),
                Some(bound) => goal.range(..bound).next_back().map(|(m, c)| (*m, *c)),
            };
            let Some((top, c)) = next else { return Some(()) };
            match self.divisor(&top) {
                Some(k) => {
                    let m = top.over(&self.elements[k].lead);
                    self.subtract(goal, c, &m, k)?;
                    by.push((k, m));
                }
                None => below = Some(top),
            }
        }
    }

    /// By which elements the goal is divided until nothing is left.
    fn search(&mut self, goal: &mut Residue) -> Option<Vec<(usize, Power)>> {
        let mut by = Vec::new();
        self.divide_goal(goal, &mut by)?;
        for _ in 0..PAIRS {
            if goal.is_empty() {
                return Some(by);
            }
            let (sugar, both, i, j) = self.pairs.pop_first()?;
            let mut s = Residue::new();
            for (element, c) in [(i, negate(1)), (j, 1)] {
                let m = both.over(&self.elements[element].lead);
                self.subtract(&mut s, c, &m, element)?;
            }
            let divided = self.divide(&mut s)?;
            if !s.is_empty() {
                self.add(s, Origin::Pair(i, j, divided), sugar)?;
                self.divide_goal(goal, &mut by)?;
            }
        }
        None
    }
}

/// How a goal is a sum of multiples of equations, if that is found within this many steps of work, of which what is left is
/// returned: a step takes a term from another.
pub fn derivation(goal: &Polynomial, equations: &[Polynomial], work: &mut usize) -> Option<Derivation> {
    let names: BTreeSet<u32> = equations.iter().chain([goal]).flat_map(Polynomial::variables).collect();
    let variables: Vec<u32> = names.into_iter().collect();
    if variables.len() > VARIABLES {
        return None;
    }
    let residue = |p: &Polynomial| -> Option<Residue> {
        let mut out = Residue::new();
        for (m, c) in p.terms() {
            let c = residue::residue(c)?;
            if c != 0 {
                out.insert(Power::of(m, &variables)?, c);
            }
        }
        Some(out)
    };
    let mut search = Buchberger { elements: Vec::new(), pairs: BTreeSet::new(), work: *work };
    for p in equations {
        search.add(residue(p).filter(|r| !r.is_empty())?, Origin::Given, p.degree())?;
    }
    let by = search.search(&mut residue(goal)?);
    *work = search.work;
    let by = by?;
    again(goal, equations, &search.elements, &by, &variables)
}

/// The elements that are needed, over the rational numbers.
fn again(
    goal: &Polynomial,
    equations: &[Polynomial],
    elements: &[Element],
    by: &[(usize, Power)],
    variables: &[u32],
) -> Option<Derivation> {
    let mut needed: BTreeSet<usize> = BTreeSet::new();
    let mut open: Vec<usize> = by.iter().map(|b| b.0).collect();
    while let Some(k) = open.pop() {
        if needed.insert(k)
            && let Origin::Pair(i, j, divided) = &elements[k].origin
        {
            open.extend([*i, *j].into_iter().chain(divided.iter().map(|d| d.0)));
        }
    }
    let mut made: BTreeMap<usize, (usize, Polynomial)> = BTreeMap::new();
    let mut steps: Vec<Step> = Vec::new();
    let take = |p: &mut Polynomial,
                parts: &mut BTreeMap<usize, Polynomial>,
                made: &BTreeMap<usize, (usize, Polynomial)>,
                (k, m): &(usize, Power),
                c: Option<Rational>| {
        let (place, g) = made.get(k)?;
        let lead = elements[*k].lead;
        let first = g.coefficient(&lead.monomial(variables)?);
        if first == 0 {
            return None;
        }
        let c = c.unwrap_or_else(|| p.coefficient(&m.times(&lead).monomial(variables).unwrap_or_else(Monomial::one)));
        let factor = Polynomial::term(m.monomial(variables)?, c / first);
        *p = p.sub(&g.try_mul(&factor).ok()?);
        let part = parts.entry(*place).or_insert_with(Polynomial::zero);
        *part = part.add(&factor);
        (p.term_count() <= SIZE.0 && p.height_bits() <= SIZE.1).then_some(())
    };
    for k in needed {
        match &elements[k].origin {
            Origin::Given => {
                made.insert(k, (k, equations.get(k)?.clone()));
            }
            Origin::Pair(i, j, divided) => {
                let both = elements[*i].lead.least_common_multiple(&elements[*j].lead);
                let (mut p, mut parts) = (Polynomial::zero(), BTreeMap::new());
                for (element, c) in [(*i, -1), (*j, 1)] {
                    let m = both.over(&elements[element].lead);
                    take(&mut p, &mut parts, &made, &(element, m), Some(Rational::from(c)))?;
                }
                for one in divided {
                    take(&mut p, &mut parts, &made, one, None)?;
                }
                // What is taken away is a part with the opposite sign; the element is made primitive.
                let content = Some(p.content()).filter(|c| *c != 0)?;
                let scale = Rational::ONE / content;
                let parts = parts.into_iter().map(|(place, q)| (place, q.scale(&-scale.clone()))).collect();
                let poly = p.scale(&scale);
                made.insert(k, (equations.len() + steps.len(), poly.clone()));
                steps.push(Step { poly, parts });
            }
        }
    }
    let (mut p, mut parts) = (goal.clone(), BTreeMap::new());
    for one in by {
        take(&mut p, &mut parts, &made, one, None)?;
    }
    p.is_zero().then(|| Derivation { steps, goal: parts.into_iter().filter(|(_, q)| !q.is_zero()).collect() })
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // a test stops where it fails
mod tests {
    use super::*;

    /// Whether the steps and the goal are what their parts say.
    fn holds(goal: &Polynomial, equations: &[Polynomial], found: &Derivation) -> bool {
        let mut all = equations.to_vec();
        let sum = |all: &[Polynomial], parts: &[(usize, Polynomial)]| {
            parts.iter().fold(Polynomial::zero(), |s, (k, q)| s.add(&all[*k].mul(q)))
        };
        for step in &found.steps {
            if sum(&all, &step.parts) != step.poly {
                return false;
            }
            all.push(step.poly.clone());
        }
        sum(&all, &found.goal) == *goal
    }

    #[test]
    fn every_step_is_the_sum_of_its_parts() {
        let [x, y, z] = [0, 1, 2].map(Polynomial::variable);
        let n = Polynomial::integer;
        // Power sums of three numbers: x + y + z = 1, squares 2, cubes 3, then fourth powers 25/6.
        let power = |k: u32| x.pow(k).unwrap().add(&y.pow(k).unwrap()).add(&z.pow(k).unwrap());
        let equations = [power(1).sub(&n(1)), power(2).sub(&n(2)), power(3).sub(&n(3))];
        let goal = power(4).scale(&Rational::from(6)).sub(&n(25));
        let found = derivation(&goal, &equations, &mut 100_000).unwrap();
        assert!(!found.steps.is_empty() && holds(&goal, &equations, &found));
        assert!(derivation(&goal.add(&n(1)), &equations, &mut 100_000).is_none());
    }

    #[test]
    fn what_lies_outside_an_ideal_is_not_derived() {
        let [x, y] = [0, 1].map(Polynomial::variable);
        assert!(derivation(&x.add(&y), &[x.sub(&y)], &mut 1_000).is_none());
        // x is in the radical only.
        assert!(derivation(&x, &[x.pow(2).unwrap()], &mut 1_000).is_none());
    }

    #[test]
    fn powers_multiply_divide_and_come_back() {
        let variables = [3, 5, 9];
        let m = Monomial::new(&[(3, 2), (9, 1)]).unwrap();
        let n = Monomial::new(&[(3, 1), (5, 4)]).unwrap();
        let [p, q] = [&m, &n].map(|m| Power::of(m, &variables).unwrap());
        assert_eq!(p.times(&q).over(&q), p);
        assert_eq!(p.monomial(&variables), Some(m));
        assert!(p.divides(&p.times(&q)) && !p.divides(&q));
        assert_eq!(p.least_common_multiple(&q).degree(), 7);
    }
}
