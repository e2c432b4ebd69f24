//! Positivstellensatz certificates: a polynomial inequality from polynomial hypotheses, by sums of squares.
//!
//! Method: the goal's polynomial p, or p times a multiplier that is positive, is a sum of products of hypotheses, each times a sum of
//! squares, and of multiples of equations. A semidefinite program finds the squares (`algebra::semidefinite`). If p itself is no such
//! sum, the same is tried for a contradiction among the hypotheses and the opposite of the goal, which then has a sum of
//! squares as its multiplier too. (J. Harrison, "Verifying nonlinear real formulas via sums of squares", TPHOLs 2007; G. Stengle, 1974.)
//!
//! Certificate: one combination; with a multiplier that may be 0, two cases.
//!
//! Limits: [`LETTERS`], [`DEGREE`], [`HYPOTHESES`], [`PLACES`] and [`WORK`].

use super::columns::letters_near;
use super::facts::minus;
use super::letters::{product, whole_power};
use super::products::{Kind, Known, combination};
use super::{Fail, Prover, implies};
use crate::algebra::semidefinite::{Identities, Program, Square, Summand, half_newton_polytope, monomials};
use crate::algebra::{Monomial, Polynomial};
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, numeral};
use crate::refute::literal::literal;
use malachite::Rational;
use malachite::base::num::basic::traits::One;

/// The most letters of a program.
const LETTERS: usize = 8;

/// The highest degree of the polynomial in a program.
const DEGREE: u32 = 20;

/// The most polynomials that facts deny to be 0 whose squares are taken.
const DENIED: usize = 2;

/// The most hypotheses that are multiplied with one another, and the most equations.
const HYPOTHESES: usize = 10;

/// The most factors of a product of hypotheses.
const FACTORS: usize = 3;

/// The most entries of the Gram matrices of a program with hypotheses.
const PLACES: usize = 700;

/// The most multiples of equations in a program.
const MULTIPLES: usize = 120;

/// The most monomials that are squared.
const ROOTS: usize = 60;

/// The operations of all programs of one claim.
pub(super) const WORK: usize = 300_000_000;

/// The operations of one program.
const WORK_AT_ONCE: usize = 100_000_000;

/// What a program is made of: the polynomials of its summands and equations, with the facts that they come from.
struct Parts {
    summands: Vec<(Known, Vec<Polynomial>, bool)>,
    equations: Vec<(Known, Polynomial)>,
}

/// What the terms of a certificate are multiplied by.
struct Writing<'a> {
    number: Rational,
    rest: &'a [Expr],
}

/// The most columns of a linear program of single monomials.
const SINGLE: usize = 400;

impl Prover {
    /// Shows a comparison by the difference of its sides as a sum, or times a positive multiplier.
    pub(super) fn by_sums_of_squares(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("a sum of squares");
        let PropKind::Compare(_, relations) = &goal.kind else { return Err(no()) };
        if matches!(relations[0], Relation::Equal | Relation::NotEqual) {
            return Err(no());
        }
        let strict = matches!(relations[0], Relation::Greater | Relation::Less);
        let open = self.open_factors(goal, 1)?;
        let target = if open.flip { open.poly.neg() } else { open.poly.clone() };
        if !is_small(&target) {
            return Err(no());
        }
        // The first factor of the rest is its number.
        let number = if open.flip { -open.number.clone() } else { open.number.clone() };
        let writing = Writing { number, rest: open.rest.get(1..).unwrap_or_default() };
        let known = self.near(std::slice::from_ref(&target));
        let mut last = Err(no());
        for known in choices(&known, &target) {
            for (form, always) in self.forms(&target, &known, &open.rest, open.flip) {
                // A form needs no equation any more, and only hypotheses that are forms.
                let known: Vec<Known> =
                    known.iter().filter(|k| always.is_empty() || is_form(&k.poly)).cloned().collect();
                for (times, signs) in self.multipliers(&form) {
                    let Ok(whole) = form.try_mul(&times) else { continue };
                    let Some(parts) = self.parts(&whole, &known, whole.degree(), strict) else { continue };
                    let Some(found) = self.identity_of(&whole, &parts) else { continue };
                    let mut terms = self.terms_of(&found, &parts, &writing);
                    let times = (!times.is_one()).then(|| self.letters.written(&times));
                    terms.extend(always.iter().map(|term| Term {
                        factor: product(times.iter().cloned().chain([term.factor.clone()]).collect()),
                        ..term.clone()
                    }));
                    last = match times {
                        Some(e) if !signs.within(Signs::NOT_ZERO) => {
                            self.attempt(|c| c.by_multiplier_that_vanishes(goal, &target, &e, &terms))
                        }
                        times => self.emit(Rule::Combination { times, terms }, goal.clone()),
                    };
                    if last.is_ok() {
                        return last;
                    }
                }
            }
        }
        last
    }

    /// Shows a comparison by a contradiction of its opposite with what is known.
    pub(super) fn by_positivstellensatz(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("a contradiction of squares");
        let PropKind::Compare(sides, relations) = &goal.kind else { return Err(no()) };
        let relation = relations[0];
        let reading = self.read(&minus(&sides[0], &sides[1]), false).ok_or_else(no)?;
        let wanted: Vec<Polynomial> = reading.factors.into_iter().filter(|f| f.power > 0).map(|f| f.poly).collect();
        if !wanted.iter().all(is_small) {
            return Err(no());
        }
        // What is not 0 has a positive square.
        let square_of = |c: &Prover, poly: &Polynomial| {
            let factors = vec![whole_power(c.letters.written(poly), 2)];
            Some(Known { poly: poly.try_mul(poly).ok()?, kind: Kind::Strict, facts: Vec::new(), factors, order: 1 })
        };
        let supposed = match relation {
            Relation::Equal => Some(self.open_factors(goal, 1)?.poly),
            _ => None,
        };
        self.against_opposite(goal, |c, _| {
            let mut known = c.near(&wanted);
            let near = letters_near(&wanted, &known);
            let mut denied = c.not_zero();
            denied.extend(known.iter().filter(|k| k.kind == Kind::Strict && k.order == 1).map(|k| k.poly.clone()));
            denied.retain(|d| d.variables().len() > 1 && is_small(d) && d.variables().iter().all(|v| near.contains(v)));
            denied.truncate(DENIED);
            let squares = supposed.iter().chain(&denied).filter_map(|d| square_of(c, d));
            known.splice(0..0, squares.collect::<Vec<_>>());
            let unit = Polynomial::variable(u32::MAX);
            let degree = known.iter().map(|k| k.poly.degree()).max().unwrap_or(0);
            let mut last = Err(no());
            for degree in [even(degree), even(degree) + 2] {
                let Some(mut parts) = c.parts(&Polynomial::zero(), &known, degree, true) else { continue };
                // The weights of what is positive add up to 1.
                for (known, ..) in parts.summands.iter_mut().filter(|s| s.2) {
                    known.poly = known.poly.add(&unit);
                }
                let Some(found) = c.identity_of(&unit, &parts) else { continue };
                let terms = c.terms_of(&found, &parts, &Writing { number: Rational::ONE, rest: &[] });
                last = c.combination(compare(numeral(0), Relation::Greater, numeral(0)), terms);
                if last.is_ok() {
                    break;
                }
            }
            c.logic(&[&last?], goal)
        })
    }

    /// Shows a comparison where the multiplier is positive by these terms, and where it is 0 all its letters are.
    fn by_multiplier_that_vanishes(
        &mut self,
        goal: &Prop,
        target: &Polynomial,
        times: &Expr,
        terms: &[Term],
    ) -> Result<Label, Fail> {
        let positive = compare(times.clone(), Relation::Greater, numeral(0));
        let zero = compare(times.clone(), Relation::LessEqual, numeral(0));
        let rule = Rule::Combination { times: Some(times.clone()), terms: terms.to_vec() };
        let x = self.block(&implies(&positive, goal), |c, _| c.emit(rule, goal.clone()))?;
        let letters: Vec<Expr> = target.variables().iter().filter_map(|v| self.letters.expr(*v).cloned()).collect();
        let y = self.block(&implies(&zero, goal), |c, block| {
            for v in &letters {
                let others = letters.iter().filter(|w| *w != v);
                let minus = |w: &Expr| product(vec![literal(&Rational::from(-1)), whole_power(w.clone(), 2)]);
                let mut terms: Vec<Term> = others.map(|w| Term { facts: Vec::new(), factor: minus(w) }).collect();
                terms.push(Term { facts: vec![format!("{block}s")], factor: numeral(1) });
                c.combination(compare(whole_power(v.clone(), 2), Relation::LessEqual, numeral(0)), terms)?;
                let label = c.combination(compare(v.clone(), Relation::Equal, numeral(0)), Vec::new())?;
                c.put_in(&label);
            }
            c.combination(goal.clone(), Vec::new())
        })?;
        self.logic(&[&x, &y], goal)
    }

    /// What the polynomial is multiplied by, with its signs: 1, and sums of letters or of their squares.
    fn multipliers(&mut self, p: &Polynomial) -> Vec<(Polynomial, Signs)> {
        let mut out = vec![(Polynomial::one(), Signs::POSITIVE)];
        let letters = p.variables();
        if letters.len() < 2 {
            return out;
        }
        let is_form = is_form(p);
        let positive = letters
            .iter()
            .all(|v| self.letters.expr(*v).cloned().is_some_and(|e| self.signs_of(&e).within(Signs::POSITIVE)));
        let of = |v: &u32| {
            if positive { Polynomial::variable(*v) } else { Polynomial::variable(*v).mul(&Polynomial::variable(*v)) }
        };
        let sum = letters.iter().fold(Polynomial::zero(), |s, v| s.add(&of(v)));
        let sum = if is_form { sum } else { sum.add(&Polynomial::one()) };
        let signs = if positive || !is_form { Signs::POSITIVE } else { Signs::NOT_NEGATIVE };
        out.extend([(sum.clone(), signs), (sum.mul(&sum), signs)]);
        // Where the multiplier may be 0, it is a sum of squares itself.
        if is_form && !positive {
            out.truncate(2);
        }
        out
    }

    /// What is known about the letters of these polynomials, as far as limits allow.
    fn near(&mut self, wanted: &[Polynomial]) -> Vec<Known> {
        let mut known = self.all_known(wanted);
        let near = letters_near(wanted, &known);
        known.retain(|k| k.poly.variables().iter().all(|v| near.contains(v)) && k.poly.degree() <= DEGREE);
        let own: Vec<u32> = wanted.iter().flat_map(Polynomial::variables).collect();
        known.sort_by_key(|k| (!k.poly.variables().iter().all(|v| own.contains(v)), k.poly.degree()));
        known
    }

    /// The summands of a program for a polynomial up to this degree; `None` where a limit is reached.
    fn parts(&self, target: &Polynomial, known: &[Known], degree: u32, strict: bool) -> Option<Parts> {
        let (zeros, signed): (Vec<&Known>, Vec<&Known>) =
            known.iter().filter(|k| !k.poly.is_constant()).partition(|k| k.kind == Kind::Zero);
        let mut letters = target.variables();
        letters.extend(known.iter().flat_map(|k| k.poly.variables()));
        letters.sort_unstable();
        letters.dedup();
        if letters.len() > LETTERS || degree > DEGREE {
            return None;
        }
        let one =
            Known { poly: Polynomial::one(), kind: Kind::Strict, facts: Vec::new(), factors: Vec::new(), order: 0 };
        if zeros.is_empty() && signed.is_empty() {
            let roots = half_newton_polytope(target, ROOTS)?;
            let mut summands = vec![(one.clone(), roots, false)];
            if strict {
                summands.push((one, vec![Polynomial::one()], true));
            }
            return Some(Parts { summands, equations: Vec::new() });
        }
        let zeros: Vec<&Known> = zeros.into_iter().take(HYPOTHESES).collect();
        // In a sum that is a form, everything else cancels.
        let forms = !target.is_zero() && is_form(target) && known.iter().all(|k| is_form(&k.poly));
        let degree = if forms { degree } else { even(degree) };
        let leads: Vec<Monomial> = zeros.iter().filter_map(|z| z.poly.terms().next().map(|t| t.0.clone())).collect();
        let mut summands = Vec::new();
        let mut places = 0;
        for known in products(&one, &signed, degree) {
            let room = degree - known.poly.degree();
            if forms && room % 2 != 0 {
                continue;
            }
            let Some(mut roots) = monomials(&letters, room / 2, &leads) else { continue };
            roots.retain(|m| !forms || m.degree() == room / 2);
            let more = roots.len() * (roots.len() + 1) / 2;
            if places + more > PLACES {
                continue;
            }
            places += more;
            if strict && known.kind == Kind::Strict && (!forms || room == 0) {
                summands.push((known.clone(), vec![Polynomial::one()], true));
            }
            summands.push((known, roots, false));
        }
        let mut equations = Vec::new();
        for zero in zeros {
            let room = degree.saturating_sub(zero.poly.degree());
            let Some(multiples) = monomials(&letters, room, &[]) else { continue };
            equations.extend(multiples.into_iter().map(|m| (zero.clone(), m)));
        }
        // Products with small monomials first.
        equations.sort_by_key(|(z, m)| z.poly.degree() + m.degree());
        equations.truncate(MULTIPLES);
        Some(Parts { summands, equations })
    }

    /// The identity of a program, where there is one within the limits of work. A program that failed fails again.
    fn identity_of(&mut self, target: &Polynomial, parts: &Parts) -> Option<Identities> {
        let summand = |(known, roots, wanted): &(Known, Vec<Polynomial>, bool)| Summand {
            multiplier: known.poly.clone(),
            roots: roots.clone(),
            wanted: *wanted,
        };
        let program = Program {
            target: target.clone(),
            summands: parts.summands.iter().map(summand).collect(),
            zeros: parts.equations.iter().map(|(z, m)| z.poly.mul(m)).collect(),
        };
        if self.failed_programs.contains(&program) {
            return None;
        }
        if let Some(found) = by_single_monomials(&program) {
            return Some(found);
        }
        let before = self.program_work.min(WORK_AT_ONCE);
        let mut budget = before;
        let found = program.solve(&mut budget);
        self.program_work -= before - budget;
        self.ticks += 1;
        if found.is_none() {
            self.failed_programs.insert(program);
        }
        found
    }

    /// The terms of a combination that an identity gives.
    fn terms_of(&self, found: &Identities, parts: &Parts, writing: &Writing) -> Vec<Term> {
        let mut terms = Vec::new();
        for square in &found.squares {
            let Some((known, ..)) = parts.summands.get(square.summand) else { continue };
            let mut factors = vec![literal(&(&square.weight * &writing.number))];
            factors.extend(writing.rest.iter().chain(&known.factors).filter(|e| !is_one(e)).cloned());
            if !square.root.is_one() {
                factors.push(whole_power(self.letters.written(&square.root), 2));
            }
            if factors.len() > 1 && is_one(&factors[0]) {
                factors.remove(0);
            }
            terms.push(Term { facts: known.facts.clone(), factor: product(factors) });
        }
        let mut cofactors: Vec<(&Known, Polynomial)> = Vec::new();
        for (place, weight) in &found.zeros {
            let Some((zero, m)) = parts.equations.get(*place) else { continue };
            let multiple = m.scale(&(weight * &writing.number));
            match cofactors.iter_mut().find(|c| c.0.poly == zero.poly) {
                Some(old) => old.1 = old.1.add(&multiple),
                None => cofactors.push((zero, multiple)),
            }
        }
        for (zero, cofactor) in cofactors {
            let mut factors = vec![self.letters.written(&cofactor)];
            factors.extend(writing.rest.iter().chain(&zero.factors).filter(|e| !is_one(e)).cloned());
            terms.push(Term { facts: zero.facts.clone(), factor: product(factors) });
        }
        terms
    }
}

/// The facts that are used, in turn: equations alone, for which the program is small; all; those about the letters of the goal. What
/// more facts say, fewer may show sooner, since a program with many products is harder to solve.
fn choices(known: &[Known], target: &Polynomial) -> Vec<Vec<Known>> {
    let all = known.to_vec();
    let own = target.variables();
    let of = |keep: &dyn Fn(&Known) -> bool| -> Vec<Known> { all.iter().filter(|k| keep(k)).cloned().collect() };
    let equations = of(&|k| k.kind == Kind::Zero);
    let about = of(&|k| k.poly.variables().iter().all(|v| own.contains(v)));
    let (some, fewer) = (!equations.is_empty() && equations.len() < all.len(), about.len() < all.len());
    let mut out = Vec::new();
    out.extend(some.then_some(equations));
    out.push(all);
    out.extend(fewer.then_some(about));
    out
}

/// The identity of a program where squares of single monomials suffice: a linear program finds it, with small weights.
fn by_single_monomials(program: &Program) -> Option<Identities> {
    let known = |poly: Polynomial, kind: Kind| Known { poly, kind, facts: Vec::new(), factors: Vec::new(), order: 0 };
    let (mut columns, mut squares) = (Vec::new(), Vec::new());
    for (summand, s) in program.summands.iter().enumerate() {
        for root in &s.roots {
            let poly = s.multiplier.try_mul(&root.try_mul(root).ok()?).ok()?;
            columns.push(known(poly, if s.wanted { Kind::Strict } else { Kind::Weak }));
            squares.push((summand, root.clone()));
        }
    }
    columns.extend(program.zeros.iter().map(|z| known(z.clone(), Kind::Zero)));
    if columns.len() > SINGLE {
        return None;
    }
    let weights = combination(&program.target, &columns, program.summands.iter().any(|s| s.wanted))?;
    let mut found = Identities { squares: Vec::new(), zeros: Vec::new() };
    for (place, weight) in weights {
        match squares.get(place) {
            Some((summand, root)) => found.squares.push(Square { summand: *summand, weight, root: root.clone() }),
            None => found.zeros.push((place - squares.len(), weight)),
        }
    }
    Some(found)
}

/// 1 and the products of at most [`FACTORS`] different hypotheses up to a degree, by their degree.
fn products(one: &Known, signed: &[&Known], degree: u32) -> Vec<Known> {
    let mut out = vec![(one.clone(), 0)];
    let mut from = 0;
    for _ in 0..FACTORS {
        let to = out.len();
        for at in from..to {
            for (place, factor) in signed.iter().enumerate().take(HYPOTHESES).skip(out[at].1) {
                if out[at].0.poly.degree() + factor.poly.degree() <= degree
                    && let Some(known) = out[at].0.times(factor)
                {
                    out.push((known, place + 1));
                }
            }
        }
        from = to;
    }
    out.sort_by_key(|(known, _)| known.poly.degree());
    out.into_iter().map(|p| p.0).collect()
}

/// Whether all terms have one degree.
fn is_form(p: &Polynomial) -> bool {
    p.terms().all(|(m, _)| m.degree() == p.degree())
}

/// The next even number.
fn even(degree: u32) -> u32 {
    degree + degree % 2
}

/// Whether a polynomial is within the limits of a program.
fn is_small(p: &Polynomial) -> bool {
    !p.is_constant() && p.degree() <= DEGREE && p.variables().len() <= LETTERS
}

fn is_one(e: &Expr) -> bool {
    matches!(&e.kind, ExprKind::Number(text) if text == "1")
}
