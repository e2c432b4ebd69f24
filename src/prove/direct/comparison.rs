//! Comparisons: by signs, by linear programs over products of what is known, from powers, by cases.

use super::facts::{is_settled, minus, opposite, sign_of};
use super::letters::{as_power, natural, product, whole_power};
use super::products::{Kind, Known, combination, completed_squares, contradiction, discriminant_forms, halves};
use super::{Fail, Prover, implies};
use crate::algebra::{Monomial, Polynomial};
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::kernel::order::Signs;
use crate::kernel::statement::{compare, numeral};
use crate::refute::search::literal;
use malachite::Rational;
use malachite::base::num::basic::traits::One;
use std::collections::BTreeSet;

/// The most columns of a linear program, by level.
const COLUMNS: [usize; 3] = [80, 300, 600];

/// Of how many letters the squares of all sums and differences are tried from the second level on.
const FEW_LETTERS: usize = 4;

impl Prover {
    /// Shows a single comparison.
    pub(crate) fn comparison(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let PropKind::Compare(sides, relations) = &goal.kind else { return Err(Fail::No("a comparison is needed")) };
        let ([a, b], [relation]) = (sides.as_slice(), relations.as_slice()) else {
            return Err(Fail::No("a single comparison is needed"));
        };
        self.define(a);
        self.define(b);
        if let Ok(label) = self.combination(goal.clone(), Vec::new()) {
            return Ok(label);
        }
        self.enrich(&[a, b]);
        self.note_squares(a);
        self.note_squares(b);
        if self.instantiate(&[a, b]) {
            self.enrich(&[a, b]);
        }
        if let Ok(label) = self.combination(goal.clone(), Vec::new()) {
            return Ok(label);
        }
        if *relation == Relation::Equal
            && let Ok(label) = self.emit(Rule::Power, goal.clone())
        {
            return Ok(label);
        }
        // With little effort: no cases, and small programs only.
        let quiet = self.splits >= 8;
        let top = if self.splits >= 9 { 1 } else { 2 };
        for level in 0..=top {
            // What roots are about, few linear programs see.
            if level == 2
                && !quiet
                && let Ok(label) = self.by_roots(goal, a, *relation, b)
            {
                return Ok(label);
            }
            if let Ok(label) = self.attempt(|c| c.by_products(goal, level)) {
                return Ok(label);
            }
            if *relation != Relation::Equal
                && let Ok(label) = self.attempt(|c| c.by_contradiction(goal, level))
            {
                return Ok(label);
            }
        }
        if self.speaks_of_numbers(goal)
            && let Ok(label) = self.emit(Rule::Evaluate, goal.clone())
        {
            return Ok(label);
        }
        if let Ok(label) = self.attempt(|c| c.of_logarithms(goal, a, *relation, b)) {
            return Ok(label);
        }
        if !matches!(relation, Relation::Equal | Relation::NotEqual)
            && let Ok(label) = self.attempt(|c| c.by_order_of_logarithms(goal, a, b))
        {
            return Ok(label);
        }
        if let Ok(label) = self.attempt(|c| c.by_bases(goal, a, *relation, b)) {
            return Ok(label);
        }
        let splits = self.splits;
        if *relation == Relation::Equal && self.splits < 8 {
            let halves = [Relation::LessEqual, Relation::GreaterEqual].map(|r| compare(a.clone(), r, b.clone()));
            let both = self.attempt(|c| {
                c.splits = 8;
                let x = c.show(&halves[0])?;
                let y = c.show(&halves[1])?;
                c.logic(&[&x, &y], goal)
            });
            if both.is_ok() {
                self.splits = splits;
                return both;
            }
        }
        if *relation == Relation::NotEqual {
            if !quiet && let Ok(label) = self.attempt(|c| c.by_divisibility(goal, a, b)) {
                return Ok(label);
            }
            for side in [Relation::Greater, Relation::Less] {
                let stronger = compare(a.clone(), side, b.clone());
                if let Ok(label) = self.quietly(&stronger) {
                    return self.logic(&[&label], goal);
                }
            }
        }
        if !quiet
            && let Ok(label) = self.attempt(|c| {
                c.means(goal)?;
                c.quietly(goal)
            })
        {
            return Ok(label);
        }
        if !quiet && let Ok(label) = self.attempt(|c| c.by_means_of_many(goal, a, *relation, b)) {
            return Ok(label);
        }
        // The same with variables written by others, as c = 1/(a·b) where a·b·c = 1.
        if !quiet
            && let Ok(label) = self.attempt(|c| {
                let before = c.equations.len();
                c.solve_equations();
                if c.equations.len() == before {
                    return Err(Fail::No("an equation to solve"));
                }
                c.by_means_of_many(goal, a, *relation, b)
            })
        {
            return Ok(label);
        }
        if !quiet && let Ok(label) = self.attempt(|c| c.by_quadratic(goal, a, *relation, b)) {
            return Ok(label);
        }
        if !quiet && let Ok(label) = self.attempt(|c| c.by_tangents(goal)) {
            return Ok(label);
        }
        if !quiet && let Ok(label) = self.attempt(|c| c.by_sums(goal)) {
            return Ok(label);
        }
        if !quiet && let Ok(label) = self.attempt(|c| c.by_slope(goal, a, *relation, b)) {
            return Ok(label);
        }
        if quiet {
            return Err(Fail::NotShown(crate::claim::print::prop(goal)));
        }
        if self.saturate()
            && let Ok(label) = self.quietly(goal)
        {
            return Ok(label);
        }
        Err(Fail::NotShown(crate::claim::print::prop(goal)))
    }

    /// A comparison in which roots stand.
    fn by_roots(&mut self, goal: &Prop, a: &Expr, relation: Relation, b: &Expr) -> Result<Label, Fail> {
        if relation == Relation::NotEqual || self.roots_in(&minus(a, b)).is_empty() {
            return Err(Fail::No("a root"));
        }
        let splits = std::mem::replace(&mut self.splits, 8);
        let shown = self
            .attempt(|c| c.by_squares(goal, a, relation, b))
            .or_else(|_| self.attempt(|c| c.by_radicals(goal, a, relation, b)));
        self.splits = splits;
        shown
    }

    /// Whether nothing in a proposition depends on a variable: arithmetic decides it.
    fn speaks_of_numbers(&self, p: &Prop) -> bool {
        let mut names = BTreeSet::new();
        crate::kernel::statement::names_in_prop(p, &mut names);
        let sequences = &self.checker.statement().sequences;
        names.iter().all(|n| FUNCTIONS.iter().any(|f| f.0 == n) || sequences.iter().any(|s| s.name == *n))
    }

    /// Notes the bases of even powers as they are written: what is squared is lost where it is multiplied out.
    pub(crate) fn note_squares(&mut self, e: &Expr) {
        match &e.kind {
            ExprKind::Negate(a) => self.note_squares(a),
            ExprKind::Sum(list) => list.iter().for_each(|(_, e)| self.note_squares(e)),
            ExprKind::Product(list) => list.iter().for_each(|(_, e)| self.note_squares(e)),
            ExprKind::Power(base, exponent) => {
                self.note_squares(base);
                if natural(exponent).is_some_and(|k| k % 2 == 0)
                    && matches!(base.kind, ExprKind::Sum(_))
                    && let Some(reading) = self.read(base, false)
                {
                    for f in reading.factors {
                        if !self.squares_written.contains(&f.poly) && self.squares_written.len() < 12 {
                            self.squares_written.push(f.poly);
                        }
                    }
                }
            }
            _ => {}
        }
    }

    /// The columns of a linear program: what is known, and products of it.
    fn columns(&mut self, wanted: &[Polynomial], level: usize) -> Vec<Known> {
        let all = self.all_known(wanted);
        // What shares letters with what is wanted, or with what shares letters with it.
        let mut near: BTreeSet<u32> = wanted.iter().flat_map(Polynomial::variables).collect();
        for _ in 0..3 {
            for k in &all {
                let letters = k.poly.variables();
                if letters.iter().any(|v| near.contains(v)) && near.len() + letters.len() < 14 {
                    near.extend(letters);
                }
            }
        }
        let base: Vec<Known> = all
            .into_iter()
            .filter(|k| {
                wanted.is_empty() || k.poly.is_constant() || k.poly.variables().iter().all(|v| near.contains(v))
            })
            .take(26)
            .collect();
        let mut out = base.clone();
        let one = Known {
            poly: Polynomial::one(),
            kind: Kind::Strict,
            facts: Vec::new(),
            factors: vec![numeral(1)],
            order: 0,
        };
        out.push(one);
        let degree = wanted.iter().chain(base.iter().map(|k| &k.poly)).map(Polynomial::degree).max().unwrap_or(0);
        let most = if level > 1 { 24 } else { 14 };
        let mut roots: Vec<Polynomial> = wanted.iter().flat_map(|p| halves(p, most)).collect();
        let equal = wanted.iter().filter_map(|p| made_homogeneous(p, &base));
        roots.extend(equal.flat_map(|p| halves(&p, most)).filter(|m| !roots.contains(m)).collect::<Vec<_>>());
        let mut squares: Vec<Polynomial> = wanted.iter().flat_map(completed_squares).collect();
        squares.extend(self.squares_written.iter().filter(|p| p.variables().iter().all(|v| near.contains(v))).cloned());
        squares.extend(roots.iter().filter(|m| !m.is_constant()).cloned());
        squares.extend(near.iter().map(|v| Polynomial::variable(*v)));
        if level > 0 {
            squares.extend(wanted.iter().flat_map(discriminant_forms));
            let zeros = base.iter().filter(|k| k.kind == Kind::Zero);
            squares.extend(zeros.flat_map(|k| discriminant_forms(&k.poly)).take(FEW_LETTERS));
        }
        out.extend(squares.iter().map(|m| self.squared(m)));
        if level == 0 {
            return out;
        }
        let (zeros, signed): (Vec<Known>, Vec<Known>) = base.iter().cloned().partition(|k| k.kind == Kind::Zero);
        // Facts times facts.
        let mut pairs = Vec::new();
        for (i, x) in signed.iter().enumerate() {
            pairs.extend(
                signed.iter().skip(i).filter(|y| level > 1 || x.order + y.order < 3).filter_map(|y| x.times(y)),
            );
        }
        // Equations times monomials.
        let mut monomials: Vec<Polynomial> = near.iter().map(|v| Polynomial::variable(*v)).collect();
        if level > 1 || zeros.len() <= 2 {
            let firsts = monomials.clone();
            for (i, x) in firsts.iter().enumerate() {
                monomials.extend(firsts.iter().skip(i).map(|y| x.mul(y)));
            }
        }
        for z in &zeros {
            for m in &monomials {
                let multiplier = self.free(m);
                if z.poly.degree() + m.degree() <= degree.max(3) + 1 {
                    out.extend(z.times(&multiplier));
                }
            }
        }
        if roots.is_empty() || level > 1 {
            roots.extend(near.iter().map(|v| Polynomial::variable(*v)));
            roots.push(Polynomial::one());
        }
        roots.dedup();
        if near.len() <= FEW_LETTERS {
            let letters = near.iter().map(|v| Polynomial::variable(*v));
            roots.extend(letters.filter(|x| !roots.contains(x)).collect::<Vec<_>>());
        }
        let mut squares = Vec::new();
        for (i, x) in roots.iter().enumerate() {
            for y in roots.iter().skip(i + 1) {
                squares.push(x.add(y));
                squares.push(x.sub(y));
            }
        }
        out.extend(pairs.iter().cloned());
        let squares: Vec<Known> = squares.iter().map(|s| self.squared(s)).collect();
        out.extend(squares.iter().cloned());
        if level > 1 {
            for x in &signed {
                out.extend(
                    pairs.iter().filter(|p| p.poly.degree() + x.poly.degree() <= degree + 1).filter_map(|p| x.times(p)),
                );
            }
            // Two letters times the square of a difference of letters, as in an energy in the frame of the masses.
            let letters: Vec<Polynomial> = near.iter().map(|v| Polynomial::variable(*v)).collect();
            let differences = letters
                .iter()
                .enumerate()
                .flat_map(|(i, x)| letters.iter().skip(i + 1).map(move |y| x.sub(y)).collect::<Vec<_>>());
            let differences: Vec<Known> = differences.map(|d| self.squared(&d)).collect();
            for pair in pairs.iter().filter(|p| p.poly.term_count() == 1 && p.poly.degree() + 2 == degree) {
                let apart = |s: &&Known| s.poly.variables().iter().all(|v| !pair.poly.contains(*v));
                out.extend(differences.iter().filter(apart).filter_map(|s| pair.times(s)));
            }
            for x in signed.iter().take(8) {
                out.extend(
                    squares
                        .iter()
                        .filter(|s| x.poly.degree() + s.poly.degree() <= degree + 1)
                        .filter_map(|s| x.times(s)),
                );
            }
        }
        let mut seen = Vec::new();
        out.retain(|k| {
            let new = !seen.contains(&(k.poly.clone(), k.kind));
            if new {
                seen.push((k.poly.clone(), k.kind));
            }
            new
        });
        out.truncate(COLUMNS[level.min(2)]);
        out
    }

    /// The square of a polynomial.
    fn squared(&self, p: &Polynomial) -> Known {
        let factors = vec![whole_power(self.letters.written(p), 2)];
        Known { poly: p.mul(p), kind: Kind::Weak, facts: Vec::new(), factors, order: 0 }
    }

    /// A multiplier of any sign, for equations.
    fn free(&self, p: &Polynomial) -> Known {
        Known { poly: p.clone(), kind: Kind::Zero, facts: Vec::new(), factors: vec![self.letters.written(p)], order: 0 }
    }

    fn terms(columns: &[Known], weights: &[(usize, Rational)], times: &[Expr], negative: bool) -> Vec<Term> {
        let term = |(place, weight): &(usize, Rational)| {
            let column = columns.get(*place)?;
            let weight = if negative { -weight } else { weight.clone() };
            let mut factors = Vec::new();
            let plain = column.factors.len() + times.len() > 0;
            if weight != Rational::ONE || !plain {
                factors.push(literal(&weight));
            }
            factors.extend(times.iter().chain(&column.factors).filter(|e| !is_one(e)).cloned());
            Some(Term { facts: column.facts.clone(), factor: product(factors) })
        };
        weights.iter().filter_map(term).collect()
    }

    /// The goal as a sum of products of what is known.
    pub(crate) fn by_products(&mut self, goal: &Prop, level: usize) -> Result<Label, Fail> {
        let PropKind::Compare(sides, relations) = &goal.kind else { return Err(Fail::No("a comparison is needed")) };
        let (a, b, relation) = (&sides[0], &sides[1], relations[0]);
        let mut reading = self.read(&minus(a, b), true).ok_or(Fail::No("a difference"))?;
        if level > 0 {
            reading = self.split(reading);
        }
        // a − b = rest·poly, where the sign of rest is known.
        let mut poly = Polynomial::one();
        let mut signs = sign_of(&reading.number);
        let mut rest = vec![literal(&reading.number)];
        let weak = matches!(relation, Relation::GreaterEqual | Relation::LessEqual);
        for f in &reading.factors {
            let e = self.letters.written(&f.poly);
            let own = f.signs.power(f.power);
            let settled = match relation {
                Relation::Equal => f.power < 0 || f.signs.within(Signs::NOT_ZERO),
                Relation::NotEqual => f.signs.within(Signs::NOT_ZERO),
                _ => is_settled(own) || (weak && own.within(Signs::NOT_NEGATIVE)),
            };
            if settled {
                signs = signs.times(own);
                rest.push(whole_power(e, f.power));
            } else if f.power > 0 {
                let power = u32::try_from(f.power).map_err(|_| Fail::No("an exponent"))?;
                poly = poly
                    .try_mul(&f.poly.pow(power).map_err(|_| Fail::No("a power"))?)
                    .map_err(|_| Fail::No("a product"))?;
            } else {
                // p^-k = p·p^(-k-1), where one of the exponents is even.
                poly = poly.try_mul(&f.poly).map_err(|_| Fail::No("a product"))?;
                rest.push(whole_power(e, f.power - 1));
            }
        }
        let up = match relation {
            Relation::Greater | Relation::GreaterEqual => true,
            Relation::Less | Relation::LessEqual => false,
            Relation::Equal => true,
            Relation::NotEqual => return Err(Fail::No("a sign")),
        };
        if poly.term_count() > 120 {
            return Err(Fail::No("a small polynomial"));
        }
        let flip = relation != Relation::Equal && signs.within(Signs::NOT_NEGATIVE) != up;
        let target = if flip { poly.neg() } else { poly.clone() };
        let mut columns = self.columns(std::slice::from_ref(&poly), level);
        if relation == Relation::Equal {
            columns.retain(|k| k.kind == Kind::Zero);
            for known in columns.iter().filter(|k| k.order == 1) {
                if let Ok(label) = self.attempt(|c| c.by_cofactor(goal, &poly, known, &rest)) {
                    return Ok(label);
                }
            }
        }
        let strict = matches!(relation, Relation::Greater | Relation::Less);
        self.spend(&columns)?;
        let weights = combination(&target, &columns, strict).ok_or(Fail::No("a combination"))?;
        let terms = Self::terms(&columns, &weights, &rest, flip);
        self.combination(goal.clone(), terms)
    }

    /// An equation p = 0 from p·h = 0, where h is not 0: the quotient of something that is 0 by p in a variable of which p is
    /// a linear form. Whether there is a remainder, the kernel tells: letters such as roots of numbers have powers.
    fn by_cofactor(&mut self, goal: &Prop, p: &Polynomial, zero: &Known, rest: &[Expr]) -> Result<Label, Fail> {
        for v in p.variables() {
            let parts = p.coefficients_in(v);
            let [constant, slope] = parts.as_slice() else { continue };
            let (Some(slope), true) = (slope.as_constant(), zero.poly.degree_in(v) > 1) else { continue };
            // Horner's scheme at v = −constant/slope.
            let root = constant.scale(&-(Rational::ONE / &slope));
            let mut quotient = Vec::new();
            let mut carried = Polynomial::zero();
            for c in zero.poly.coefficients_in(v).iter().rev() {
                carried = carried.try_mul(&root).map_err(|_| Fail::No("a product"))?.add(c);
                quotient.push(carried.clone());
            }
            quotient.pop();
            quotient.reverse();
            let cofactor = Polynomial::from_coefficients_in(v, &quotient).scale(&(Rational::ONE / &slope));
            let e = self.letters.written(&cofactor);
            if cofactor.is_constant() || !self.signs_of(&e).within(Signs::NOT_ZERO) {
                continue;
            }
            let mut factors = rest.to_vec();
            factors.push(whole_power(e, -1));
            factors.extend(zero.factors.iter().cloned());
            let term = Term { facts: zero.facts.clone(), factor: product(factors) };
            if let Ok(label) = self.combination(goal.clone(), vec![term]) {
                return Ok(label);
            }
        }
        Err(Fail::No("a cofactor"))
    }

    /// A contradiction among the facts and the opposite of the goal.
    pub(crate) fn by_contradiction(&mut self, goal: &Prop, level: usize) -> Result<Label, Fail> {
        let other = opposite(goal).ok_or(Fail::No("an opposite"))?;
        let block = self.block(&implies(&other, goal), |c, _| {
            if level > 0 {
                c.solve_equations();
            }
            c.absurd(level, goal, Some(goal))
        })?;
        self.logic(&[&block], goal)
    }

    /// Shows anything where facts contradict each other.
    pub(crate) fn absurd(&mut self, level: usize, goal: &Prop, about: Option<&Prop>) -> Result<Label, Fail> {
        let mut wanted = Vec::new();
        if let Some(Prop { kind: PropKind::Compare(sides, _), .. }) = about
            && let Some(reading) = self.read(&minus(&sides[0], &sides[1]), false)
        {
            let parts = reading.factors.iter().filter(|f| f.power > 0 && f.poly.term_count() < 40);
            wanted = parts.map(|f| f.poly.clone()).collect();
        }
        let columns = self.columns(&wanted, level);
        self.spend(&columns)?;
        let weights = contradiction(&columns).ok_or(Fail::No("a contradiction"))?;
        let terms = Self::terms(&columns, &weights, &[], false);
        let shown = self.combination(compare(numeral(0), Relation::Greater, numeral(0)), terms)?;
        self.logic(&[&shown], goal)
    }

    /// A comparison of powers with one exponent from that of their bases.
    fn by_bases(&mut self, goal: &Prop, a: &Expr, relation: Relation, b: &Expr) -> Result<Label, Fail> {
        match (as_power(a), as_power(b)) {
            (Some((x, p)), Some((y, q))) if p == q => {
                let from = self.quietly(&compare(x, relation, y))?;
                self.emit(Rule::Monotone { from }, goal.clone())
            }
            _ => Err(Fail::No("powers with one exponent")),
        }
    }
}

/// A polynomial in which every term has the same degree in the letters of a form h, where an equation among the facts says
/// that h is a number other than 0: terms of a lower degree are multiplied by h over that number. From c² + s² = 1 one has
/// A² + B² − (A·c + B·s)² = (A·s − B·c)². `None` where nothing changes.
fn made_homogeneous(p: &Polynomial, facts: &[Known]) -> Option<Polynomial> {
    let mut out = p.clone();
    for fact in facts.iter().filter(|k| k.kind == Kind::Zero) {
        let c = -fact.poly.constant_term();
        let form = fact.poly.add(&Polynomial::constant(c.clone()));
        let letters = form.variables();
        let degree_of = |m: &Monomial| m.powers().iter().filter(|p| letters.contains(&p.0)).map(|p| p.1).sum::<u32>();
        let (degree, most) = (form.degree(), out.terms().map(|(m, _)| degree_of(m)).max()?);
        if c == 0 || degree == 0 || most > 8 || form.terms().any(|(m, _)| degree_of(m) != degree) {
            continue;
        }
        let unit = form.scale(&(Rational::ONE / c));
        let mut sum = Polynomial::zero();
        for (m, coefficient) in out.terms() {
            let missing = most - degree_of(m);
            let term = Polynomial::term(m.clone(), coefficient.clone());
            let factor = if missing % degree == 0 { unit.pow(missing / degree).ok()? } else { Polynomial::one() };
            sum = sum.add(&term.try_mul(&factor).ok()?);
        }
        out = sum;
    }
    (out != *p && out.term_count() <= 120).then_some(out)
}

fn is_one(e: &Expr) -> bool {
    matches!(&e.kind, ExprKind::Number(text) if text == "1")
}
