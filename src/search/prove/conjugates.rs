//! Equations with roots, freed of them: an equation is multiplied by its conjugates until whole powers are left, which are factored.
//!
//! Method: let r be a root, so that l·r^d = q with polynomials l and q. An equation E + O = 0, with E of even and O of odd powers of r,
//! is multiplied by E − O. This leaves even powers. For 3 in d, A + B + C = 0, with the powers 3·k, 3·k + 1 and 3·k + 2 of r, is multiplied by
//! A² + B² + C² − A·B − B·C − C·A. This leaves A³ + B³ + C³ − 3·A·B·C, so powers of r³. One prime factor of d after the other leaves powers of
//! r^d, for which q/l is put in.
//!
//! Sound: what is multiplied by may be 0, so the new equation follows from the old one, and not the other way round. The certificate states
//! it as a combination of the equation and of l·r^d = q.
//!
//! Use: a value is taken at one place only. Of the equation that says so, all factors but one are not 0, and this one gives the place.
//!
//! Limits: [`ROOTS`], [`TERMS`], [`DEGREE`], [`FACTORS`].

use super::facts::opposite;
use super::letters::{product, whole_power};
use super::products::{Kind, Known};
use super::{Fail, Prover, implies};
use crate::algebra::Polynomial;
use crate::certificate::{Label, Term};
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, numeral};

/// The most roots that an equation is freed of, one after the other.
const ROOTS: usize = 6;

/// The most terms of a polynomial on the way, and its largest degree.
const TERMS: usize = 250;
const DEGREE: u32 = 40;

/// The most factors without a sign that are distinguished.
const FACTORS: usize = 3;

/// A fact l·r^d = q about a letter r that is a root.
struct RootOf {
    letter: u32,
    degree: i64,
    known: Known,
}

impl Prover {
    /// Shows a goal by an equation that holds a root: it is freed of its roots and factored.
    pub(super) fn by_conjugates(&mut self, goal: &Prop, equation: &str) -> Result<Label, Fail> {
        let without = self.freed_of_roots(equation)?;
        self.by_factors_of(goal, &without, FACTORS)
    }

    /// Adds an equation without roots that follows from one with roots, and returns it.
    fn freed_of_roots(&mut self, equation: &str) -> Result<Label, Fail> {
        let no = || Fail::No("an equation with roots");
        let fact = self.fact(equation).ok_or_else(no)?;
        self.take_in(equation, &fact)?;
        let mut known = self.known_of(equation, &fact).filter(|k| k.kind == Kind::Zero).ok_or_else(no)?;
        let mut last = None;
        for _ in 0..ROOTS {
            let Some(root) = self.outermost_root(&known.poly) else { break };
            let (label, poly) = self.freed_of(&known, &root)?;
            known = Known { poly, kind: Kind::Zero, facts: vec![label.clone()], factors: Vec::new(), order: 1 };
            last = Some(label);
        }
        last.ok_or_else(no)
    }

    /// A root in a polynomial that stands in no other one, for it is written longest.
    fn outermost_root(&mut self, poly: &Polynomial) -> Option<RootOf> {
        let mut found: Option<(usize, RootOf)> = None;
        for letter in poly.variables() {
            let Some(e) = self.letters.expr(letter).cloned() else { continue };
            let (Some(degree), ExprKind::Power(base, _)) = (self.degree(&e), &e.kind) else { continue };
            let length = crate::kernel::key::expr(&e).len();
            if found.as_ref().is_some_and(|f| f.0 >= length) {
                continue;
            }
            self.enrich(&[&e]);
            let fact = compare(whole_power(e.clone(), degree), Relation::Equal, (**base).clone());
            let known = self.known(&fact).and_then(|label| self.known_of(&label, &fact));
            found = Some((length, RootOf { letter, degree, known: known.filter(|k| k.kind == Kind::Zero)? }));
        }
        found.map(|f| f.1)
    }

    /// Frees an equation of one root, and adds it as a fact.
    fn freed_of(&mut self, equation: &Known, root: &RootOf) -> Result<(Label, Polynomial), Fail> {
        let no = || Fail::No("an equation of less degree");
        let freed = Freed::of(&equation.poly, root).ok_or_else(no)?;
        if freed.poly.is_zero() || freed.poly.term_count() > TERMS || freed.poly.degree() > DEGREE {
            return Err(no());
        }
        let mut terms = Vec::new();
        for (known, weight) in [(equation, &freed.of_equation), (&root.known, &freed.of_root)] {
            if !weight.is_zero() {
                let own = self.letters.written(weight);
                let factor = product([own].into_iter().chain(known.factors.iter().cloned()).collect());
                terms.push(Term { facts: known.facts.clone(), factor });
            }
        }
        let shown = compare(self.letters.written(&freed.poly), Relation::Equal, numeral(0));
        let label = self.combination(shown, terms)?;
        Ok((label, freed.poly))
    }

    /// Shows a goal by an equation f·g·… = 0: by what follows where all factors but one are not 0, or in the cases of a factor.
    fn by_factors_of(&mut self, goal: &Prop, equation: &str, cases: usize) -> Result<Label, Fail> {
        let fact = self.fact(equation).ok_or(Fail::No("an equation"))?;
        let PropKind::Compare(sides, _) = &fact.kind else { return Err(Fail::No("an equation")) };
        let reading = self.read(&sides[0], true).ok_or(Fail::No("an equation"))?;
        let reading = self.split_open(reading);
        let mut open = Vec::new();
        for f in reading.factors.iter().filter(|f| f.power > 0 && !f.signs.within(Signs::NOT_ZERO)) {
            let e = self.letters.written(&f.poly);
            self.nonzero(&e);
            if !self.signs_of(&e).within(Signs::NOT_ZERO) {
                open.push(e);
            }
        }
        self.take_in(equation, &fact)?;
        if let (Some(first), true) = (open.first(), open.len() > 1) {
            let zero = compare(first.clone(), Relation::Equal, numeral(0));
            let other = opposite(&zero).filter(|_| cases > 0).ok_or(Fail::No("few factors"))?;
            let x = self.block(&implies(&zero, goal), |c, block| {
                c.take_in(&format!("{block}s"), &zero)?;
                c.without_cases(goal)
            })?;
            let y = self.block(&implies(&other, goal), |c, _| c.by_factors_of(goal, equation, cases - 1))?;
            return self.logic(&[&x, &y], goal);
        }
        self.without_cases(goal)
    }
}

/// A polynomial freed of a root: poly = of_equation·equation + of_root·(l·r^d − q).
struct Freed {
    poly: Polynomial,
    of_equation: Polynomial,
    of_root: Polynomial,
}

impl Freed {
    fn of(equation: &Polynomial, root: &RootOf) -> Option<Freed> {
        let divisor = root.known.poly.coefficients_in(root.letter);
        let is_pure = divisor.iter().skip(1).rev().skip(1).all(Polynomial::is_zero);
        if i64::try_from(divisor.len()).ok()? != root.degree + 1 || !is_pure {
            return None;
        }
        let mut out = Freed { poly: equation.clone(), of_equation: Polynomial::one(), of_root: Polynomial::zero() };
        out.divide(&root.known.poly, root.letter)?;
        let (mut left, mut step) = (usize::try_from(root.degree).ok()?, 1);
        while left > 1 {
            let prime: usize = [2, 3].into_iter().find(|p| left % p == 0)?;
            let conjugate = conjugate(&out.poly, root.letter, step, prime)?;
            out.multiply(&conjugate)?;
            (left, step) = (left / prime, step * prime);
        }
        out.divide(&root.known.poly, root.letter)?;
        (!out.poly.contains(root.letter)).then_some(out)
    }

    /// Multiplies the whole equation.
    fn multiply(&mut self, by: &Polynomial) -> Option<()> {
        for p in [&mut self.poly, &mut self.of_equation, &mut self.of_root] {
            *p = p.try_mul(by).ok().filter(|p| p.term_count() <= 4 * TERMS)?;
        }
        Some(())
    }

    /// Leaves less than the d-th power of a letter r: while there is more, l·poly − lead·r^k·(l·r^d − q).
    fn divide(&mut self, divisor: &Polynomial, letter: u32) -> Option<()> {
        let degree = divisor.degree_in(letter);
        let lead = divisor.coefficients_in(letter).pop()?;
        while let Some(excess) = self.poly.degree_in(letter).checked_sub(degree) {
            let own = self.poly.coefficients_in(letter).pop()?;
            let step = own.try_mul(&Polynomial::variable(letter).pow(excess).ok()?).ok()?;
            self.multiply(&lead)?;
            self.poly = self.poly.sub(&step.try_mul(divisor).ok()?);
            self.of_root = self.of_root.sub(&step);
        }
        Some(())
    }
}

/// What a polynomial in r^step is multiplied by to become one in r^(step·prime), for the primes 2 and 3.
fn conjugate(poly: &Polynomial, letter: u32, step: usize, prime: usize) -> Option<Polynomial> {
    let coefficients = poly.coefficients_in(letter);
    let class = |of: usize| {
        let keep = |(k, c): (usize, &Polynomial)| {
            if k % (step * prime) == of * step { c.clone() } else { Polynomial::zero() }
        };
        Polynomial::from_coefficients_in(letter, &coefficients.iter().enumerate().map(keep).collect::<Vec<_>>())
    };
    let (a, b) = (class(0), class(1));
    if prime == 2 {
        return Some(a.sub(&b));
    }
    let c = class(2);
    let times = |x: &Polynomial, y: &Polynomial| x.try_mul(y).ok();
    let squares = times(&a, &a)?.add(&times(&b, &b)?).add(&times(&c, &c)?);
    Some(squares.sub(&times(&a, &b)?).sub(&times(&b, &c)?).sub(&times(&c, &a)?))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// r^d = 2 for the letter 0.
    fn root(degree: i64) -> RootOf {
        let r = Polynomial::variable(0).pow(u32::try_from(degree).expect("small")).expect("small");
        let poly = r.sub(&Polynomial::integer(2));
        let known = Known { poly, kind: Kind::Zero, facts: Vec::new(), factors: Vec::new(), order: 1 };
        RootOf { letter: 0, degree, known }
    }

    #[test]
    fn the_norm_of_a_sum_with_a_root_is_a_combination_of_both_equations() {
        let (r, x) = (Polynomial::variable(0), Polynomial::variable(1));
        // x − r − r² is 0.
        let equation = x.sub(&r).sub(&r.mul(&r));
        for degree in [2, 3, 4, 6, 8] {
            let root = root(degree);
            let freed = Freed::of(&equation, &root).expect("a norm");
            assert!(!freed.poly.contains(0) && !freed.poly.is_zero(), "{degree}");
            let sum = freed.of_equation.mul(&equation).add(&freed.of_root.mul(&root.known.poly));
            assert_eq!(sum, freed.poly, "{degree}");
        }
        // Of x − r − 2, where r² = 2.
        let freed = Freed::of(&equation, &root(2)).expect("a norm");
        let two = Polynomial::integer(2);
        let expected = x.mul(&x).sub(&x.scale(&4.into())).add(&two);
        assert_eq!(freed.poly, expected);
        assert!(Freed::of(&equation, &root(5)).is_none());
    }
}
