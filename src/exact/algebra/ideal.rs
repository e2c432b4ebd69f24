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
use super::geobucket::Geobucket;
use super::monomial::Monomial;
use super::residue::{self, inverse, multiply, negate};
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

    /// The variables that occur, a bit for each.
    fn mask(&self) -> u32 {
        self.0[1..].iter().enumerate().filter(|(_, b)| **b != 255).fold(0, |mask, (k, _)| mask | 1 << k)
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
type Residue = Geobucket<Power>;

/// Its terms in order.
type Terms = Vec<(Power, u64)>;

/// What was divided by: elements times monomials, in turn.
type Divisions = Vec<(usize, Power)>;

/// What an element is made of.
enum Origin {
    Given,
    /// Of this pair, then divided.
    Pair(usize, usize, Divisions),
}

struct Element {
    /// Its terms behind the leading one, whose coefficient is 1; the smallest comes first.
    tail: Terms,
    lead: Power,
    /// The variables of the leading term, a bit for each.
    mask: u32,
    sugar: u32,
    origin: Origin,
}

struct Buchberger {
    elements: Vec<Element>,
    /// The elements whose leading term no later one's divides, the shortest first.
    minimal: Vec<usize>,
    /// Pairs by sugar and by the least common multiple of the leading terms.
    pairs: BTreeSet<(u32, Power, usize, usize)>,
    work: usize,
}

impl Buchberger {
    /// Subtracts `c·m·element` without its leading term, which is gone already.
    fn subtract(&mut self, from: &mut Residue, c: u64, m: &Power, element: usize) -> Option<()> {
        let g = &self.elements[element];
        self.work = self.work.checked_sub(g.tail.len() + 1)?;
        let less = negate(c);
        from.add(g.tail.iter().map(|(power, k)| (m.times(power), multiply(less, *k))).collect());
        Some(())
    }

    /// The element with the fewest terms whose leading term divides a monomial.
    fn divisor(&self, of: &Power) -> Option<usize> {
        let absent = !of.mask();
        self.minimal.iter().copied().find(|k| {
            let g = &self.elements[*k];
            g.mask & absent == 0 && g.lead.divides(of)
        })
    }

    /// Divides the leading terms away as long as that is possible; returns by what, and what is left, the largest term first.
    fn divide(&mut self, mut p: Residue) -> Option<(Divisions, Terms)> {
        let mut by = Vec::new();
        while let Some((top, c)) = p.pop() {
            let Some(k) = self.divisor(&top) else {
                let mut rest = vec![(top, c)];
                rest.extend(p.into_terms());
                return Some((by, rest));
            };
            let m = top.over(&self.elements[k].lead);
            self.subtract(&mut p, c, &m, k)?;
            by.push((k, m));
        }
        Some((by, Vec::new()))
    }

    /// Adds an element of these terms, the largest first; pairs with it that cannot give anything new are left out, and so are old
    /// ones.
    fn add(&mut self, terms: &[(Power, u64)], origin: Origin, sugar: u32) -> Option<()> {
        let ((lead, c), rest) = terms.split_first()?;
        let (lead, scale) = (*lead, inverse(*c));
        let tail: Vec<_> = rest.iter().rev().map(|(m, k)| (*m, multiply(*k, scale))).collect();
        let new = self.elements.len();
        // An old pair whose multiple the new leading term divides goes, unless it is the multiple with one of its own.
        let leads: Vec<Power> = self.elements.iter().map(|g| g.lead).collect();
        self.pairs.retain(|(_, both, i, j)| {
            !lead.divides(both)
                || leads[*i].least_common_multiple(&lead) == *both
                || leads[*j].least_common_multiple(&lead) == *both
        });
        let mut old = self.minimal.clone();
        old.sort_unstable();
        let open: Vec<(Power, usize)> = old.into_iter().map(|i| (leads[i].least_common_multiple(&lead), i)).collect();
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
        self.minimal.retain(|k| !lead.divides(&leads[*k]));
        let place = self.minimal.partition_point(|k| self.elements[*k].tail.len() <= tail.len());
        self.minimal.insert(place, new);
        self.elements.push(Element { tail, lead, mask: lead.mask(), sugar, origin });
        Some(())
    }

    /// Divides every term of the goal, the largest first, that can be divided now; returns what is left.
    fn divide_goal(&mut self, goal: &[(Power, u64)], by: &mut Divisions) -> Option<Terms> {
        let mut open = Residue::new();
        open.add(goal.iter().rev().copied().collect());
        let mut left = Vec::new();
        while let Some((top, c)) = open.pop() {
            match self.divisor(&top) {
                Some(k) => {
                    let m = top.over(&self.elements[k].lead);
                    self.subtract(&mut open, c, &m, k)?;
                    by.push((k, m));
                }
                None => left.push((top, c)),
            }
        }
        Some(left)
    }

    /// By which elements the goal, the largest term first, is divided until nothing is left.
    fn search(&mut self, goal: &[(Power, u64)]) -> Option<Divisions> {
        let mut by = Vec::new();
        let mut left = self.divide_goal(goal, &mut by)?;
        for _ in 0..PAIRS {
            if left.is_empty() {
                return Some(by);
            }
            let (sugar, both, i, j) = self.pairs.pop_first()?;
            let mut s = Residue::new();
            for (element, c) in [(i, 1), (j, negate(1))] {
                let m = both.over(&self.elements[element].lead);
                self.subtract(&mut s, c, &m, element)?;
            }
            let (divided, rest) = self.divide(s)?;
            if !rest.is_empty() {
                self.add(&rest, Origin::Pair(i, j, divided), sugar)?;
                left = self.divide_goal(&left, &mut by)?;
            }
        }
        None
    }
}

/// How a goal is a sum of multiples of equations, if that is found within this many steps of work, of which what is left is
/// returned: a step takes a term from another.
pub fn derivation(goal: &Polynomial, equations: &[Polynomial], work: &mut usize) -> Option<Derivation> {
    let names: BTreeSet<u32> = equations.iter().chain([goal]).flat_map(Polynomial::variables).collect();
    let mut variables: Vec<u32> = names.into_iter().collect();
    // What few equations speak of goes first: those equations give it by the rest. On theorems of geometry this takes a tenth of the work.
    variables.sort_by_key(|v| equations.iter().filter(|p| p.variables().contains(v)).count());
    if variables.len() > VARIABLES {
        return None;
    }
    let terms = |p: &Polynomial| -> Option<Terms> {
        let mut out = BTreeMap::new();
        for (m, c) in p.terms() {
            out.insert(Power::of(m, &variables)?, residue::residue(c)?);
        }
        Some(out.into_iter().rev().filter(|t| t.1 != 0).collect())
    };
    let mut search = Buchberger { elements: Vec::new(), minimal: Vec::new(), pairs: BTreeSet::new(), work: *work };
    for p in equations {
        search.add(&terms(p)?, Origin::Given, p.degree())?;
    }
    let by = search.search(&terms(goal)?);
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
