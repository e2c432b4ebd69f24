//! Linear arithmetic of whole numbers: a contradiction among facts by cuts, and by branch and bound.
//!
//! Method (Schrijver, "Theory of Linear and Integer Programming", chapters 4, 23 and 24; Pugh, "The Omega test", 1991): every
//! monomial of whole letters is a whole number. Equations are solved for whole unknowns, where necessary for sums of them. A bound
//! q >= c of a whole q becomes q >= ceil(c). If the rational relaxation still has a point, an unknown that is not whole there is at
//! most its floor, or at least one more.
//!
//! Certificate: a combination and the rule `integer` for a cut, two blocks for a branch, a combination 0 > 0 at each end.
//!
//! Limits: [`PROGRAMS`] linear programs, [`ROWS`] facts, [`DEPTH`] nested branches. It fails on an unbounded problem without
//! a cut, and knows nothing of products but that they are whole.

use super::products::{Kind, Known, combination, contradiction};
use super::{Fail, Prover, implies};
use crate::algebra::simplex::{Column, SimplexLimits, solve};
use crate::algebra::{Monomial, Polynomial};
use crate::certificate::{Label, Rule};
use crate::claim::syntax::*;
use crate::kernel::statement::{compare, numeral};
use crate::refute::literal::literal;
use malachite::base::num::arithmetic::traits::{Floor, Gcd, Lcm};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::conversion::traits::IsInteger;
use malachite::{Integer, Natural, Rational};
use std::collections::BTreeSet;

/// The most linear programs of one search, with facts alone and with their products.
const PROGRAMS: [usize; 2] = [60, 16];

/// The most facts.
const ROWS: [usize; 2] = [40, 90];

/// The most branches within one another.
const DEPTH: usize = 12;

/// The most cuts of one round.
const CUTS: usize = 24;

/// Limits on one linear program.
const LIMITS: SimplexLimits = SimplexLimits { pivots: 200, work: 200_000 };

/// Weights of columns.
type Weights = Vec<(usize, Rational)>;

/// Why columns contradict each other. A cut and a branch add one column each to those that their parts may use.
enum Tree {
    /// They add up to 0 > 0.
    Contradiction(Weights),
    /// form >= least, since form − least + 1 is this positive sum.
    Cut { form: Polynomial, least: Integer, by: Weights, then: Box<Tree> },
    /// form <= floor, or form >= floor + 1.
    Branch { form: Polynomial, floor: Integer, low: Box<Tree>, high: Box<Tree> },
}

impl Tree {
    /// The columns that are used, where there are this many before it.
    fn used(&self, count: usize) -> BTreeSet<usize> {
        let places = |weights: &Weights| weights.iter().map(|w| w.0).collect::<BTreeSet<usize>>();
        match self {
            Tree::Contradiction(weights) => places(weights),
            Tree::Cut { by, then, .. } => {
                let mut used = then.used(count + 1);
                if used.remove(&count) {
                    used.extend(places(by));
                }
                used
            }
            Tree::Branch { low, high, .. } => {
                let mut used = low.used(count + 1);
                used.extend(high.used(count + 1));
                used.remove(&count);
                used
            }
        }
    }
}

fn column(poly: Polynomial, kind: Kind) -> Known {
    Known { poly, kind, facts: Vec::new(), factors: Vec::new(), order: 1 }
}

/// form >= least as a column.
fn at_least(form: &Polynomial, least: &Integer) -> Polynomial {
    form.sub(&Polynomial::constant(Rational::from(least)))
}

/// Monomials as unknowns of their own, of which some are whole.
struct Unknowns<'w> {
    /// The letters that are whole.
    letters: &'w BTreeSet<u32>,
    /// For each unknown what it is, as a polynomial in letters, and whether it is whole.
    forms: Vec<(Polynomial, bool)>,
    monomials: Vec<(Monomial, u32)>,
    /// Unknowns by others, in the order in which they are put in.
    solved: Vec<(u32, Polynomial)>,
}

impl Unknowns<'_> {
    fn new(letters: &BTreeSet<u32>) -> Unknowns<'_> {
        Unknowns { letters, forms: Vec::new(), monomials: Vec::new(), solved: Vec::new() }
    }

    fn add(&mut self, form: Polynomial, whole: bool) -> u32 {
        self.forms.push((form, whole));
        u32::try_from(self.forms.len() - 1).unwrap_or(u32::MAX)
    }

    fn of(&mut self, m: &Monomial) -> u32 {
        if let Some((_, v)) = self.monomials.iter().find(|k| k.0 == *m) {
            return *v;
        }
        let whole = m.powers().iter().all(|p| self.letters.contains(&p.0));
        let v = self.add(Polynomial::monomial(m.clone()), whole);
        self.monomials.push((m.clone(), v));
        v
    }

    /// A polynomial in letters as a linear form in the unknowns that are left.
    fn linear(&mut self, p: &Polynomial) -> Polynomial {
        let mut out = Polynomial::constant(p.constant_term());
        for (m, c) in p.terms().filter(|t| !t.0.is_one()) {
            out = out.add(&Polynomial::variable(self.of(m)).scale(c));
        }
        for (v, value) in &self.solved {
            out = put(&out, *v, value);
        }
        out
    }

    fn is_whole(&self, v: u32) -> bool {
        self.forms.get(v as usize).is_some_and(|f| f.1)
    }

    /// What a linear form without a constant is in letters.
    fn form(&self, p: &Polynomial) -> Polynomial {
        p.terms().fold(Polynomial::zero(), |sum, (m, c)| {
            let v = m.powers().first().map(|p| p.0 as usize);
            let form = v.and_then(|v| self.forms.get(v));
            form.map_or(sum.clone(), |f| sum.add(&f.0.scale(c)))
        })
    }

    /// Solves an equation p = 0; where it has no whole solution, a form that has no whole value.
    fn solve(&mut self, p: &Polynomial) -> Option<(Polynomial, Rational)> {
        let mut p = self.linear(p);
        for _ in 0..64 {
            let variables = p.variables();
            if variables.is_empty() {
                return None;
            }
            let slope = |v: u32| p.coefficient(&Monomial::variable(v));
            if let Some(v) = variables.iter().copied().find(|v| !self.is_whole(*v)) {
                let value = put(&p, v, &Polynomial::zero()).scale(&(Rational::from(-1) / slope(v)));
                self.solved.push((v, value));
                return None;
            }
            p = primitive(&p);
            let slope = |v: u32| p.coefficient(&Monomial::variable(v));
            let rest = p.constant_term();
            if !(&rest).is_integer() {
                let form = p.sub(&Polynomial::constant(rest.clone()));
                return Some((self.form(&form), -rest));
            }
            let size = |v: &u32| slope(*v).numerator_ref().clone();
            let v = variables.iter().copied().min_by_key(size)?;
            let lead = slope(v);
            if *lead.numerator_ref() == 1u32 {
                let value = put(&p, v, &Polynomial::zero()).scale(&(Rational::from(-1) / lead));
                self.solved.push((v, value));
                return None;
            }
            // v = t − Σ floor(c/lead)·w for the others: their coefficients become smaller than the leading one.
            let mut others = Polynomial::zero();
            for w in variables.into_iter().filter(|w| *w != v) {
                let times = Rational::from((slope(w) / &lead).floor());
                others = others.add(&Polynomial::variable(w).scale(&times));
            }
            let form = self.form(&Polynomial::variable(v).add(&others));
            let t = self.add(form, true);
            let value = Polynomial::variable(t).sub(&others);
            p = put(&p, v, &value);
            self.solved.push((v, value));
        }
        None
    }

    /// The bound c of q >= c that a row gives, where q is whole with coprime coefficients and c is more than the row says.
    fn cut(&self, row: &Polynomial, kind: Kind) -> Option<(Polynomial, Integer)> {
        let variables = row.variables();
        if variables.is_empty() || variables.iter().any(|v| !self.is_whole(*v)) {
            return None;
        }
        let row = primitive(row);
        let rest = row.constant_term();
        let whole = (&rest).is_integer();
        if whole && kind != Kind::Strict {
            return None;
        }
        let least = if whole { Integer::ONE - (&rest).floor() } else { -(&rest).floor() };
        let form = self.form(&row.sub(&Polynomial::constant(rest)));
        Some((form, least))
    }

    /// An unknown that is not whole at a point at which these rows are not negative, with its value there.
    fn broken(&self, rows: &[Polynomial]) -> Option<(Polynomial, Rational)> {
        let mut variables: Vec<u32> = rows.iter().flat_map(Polynomial::variables).collect();
        variables.sort_unstable();
        variables.dedup();
        let sided = |sign: i32, v: u32| -> Column {
            let entry = |(place, row): (usize, &Polynomial)| (place, row.coefficient(&Monomial::variable(v)));
            let entries = rows.iter().enumerate().map(entry).filter(|e| e.1 != 0);
            entries.map(|(place, c)| (place, c * Rational::from(sign))).collect()
        };
        let mut columns: Vec<Column> = variables.iter().map(|v| sided(1, *v)).collect();
        columns.extend(variables.iter().map(|v| sided(-1, *v)));
        columns.extend((0..rows.len()).map(|place| vec![(place, Rational::from(-1))]));
        let target: Vec<Rational> = rows.iter().map(|row| -row.constant_term()).collect();
        let point = solve(&columns, &target, None, &LIMITS).ok()??;
        let count = variables.len();
        let value = |(place, v): (usize, &u32)| Some((*v, point.get(place)? - point.get(place + count)?));
        let mut values = variables.iter().enumerate().filter_map(value);
        values
            .find(|(v, q)| self.is_whole(*v) && !q.is_integer())
            .map(|(v, q)| (self.form(&Polynomial::variable(v)), q))
    }
}

/// A linear form with a value for one of its unknowns.
fn put(p: &Polynomial, v: u32, value: &Polynomial) -> Polynomial {
    let c = p.coefficient(&Monomial::variable(v));
    if c == 0 { p.clone() } else { p.sub(&Polynomial::variable(v).scale(&c)).add(&value.scale(&c)) }
}

/// A positive multiple of a linear form whose coefficients, but for the constant, are whole and have no common divisor.
fn primitive(p: &Polynomial) -> Polynomial {
    let slopes = || p.terms().filter(|t| !t.0.is_one()).map(|t| t.1);
    let below = slopes().fold(Natural::ONE, |n, c| n.lcm(c.denominator_ref()));
    let scaled = |c: &Rational| (c * Rational::from(&below)).numerator_ref().clone();
    let common = slopes().fold(Natural::ZERO, |n, c| n.gcd(scaled(c)));
    if common == 0u32 { p.clone() } else { p.scale(&Rational::from_naturals(below, common)) }
}

/// A search for a contradiction.
struct Search<'w> {
    letters: &'w BTreeSet<u32>,
    /// How many linear programs may still be solved.
    programs: usize,
}

impl Search<'_> {
    fn spend(&mut self) -> Option<()> {
        self.programs = self.programs.checked_sub(1)?;
        Some(())
    }

    /// A contradiction among columns, one of which is the number 1.
    fn tree(&mut self, mut columns: Vec<Known>, depth: usize) -> Option<Tree> {
        let mut cuts: Vec<(Polynomial, Integer, Weights)> = Vec::new();
        let found = loop {
            self.spend()?;
            if let Some(weights) = contradiction(&columns) {
                break Tree::Contradiction(weights);
            }
            let mut unknowns = Unknowns::new(self.letters);
            let zeros = columns.iter().filter(|k| k.kind == Kind::Zero);
            let broken = zeros.filter_map(|k| unknowns.solve(&k.poly)).next();
            let rows: Vec<(Polynomial, Kind)> = columns
                .iter()
                .filter(|k| k.kind != Kind::Zero && !k.poly.is_constant())
                .map(|k| (unknowns.linear(&k.poly), k.kind))
                .collect();
            let (form, value) = match broken {
                Some(broken) => broken,
                None => {
                    let more = self.cuts(&rows, &unknowns, &mut columns);
                    if !more.is_empty() {
                        cuts.extend(more);
                        continue;
                    }
                    let rows: Vec<Polynomial> = rows.into_iter().map(|r| r.0).collect();
                    self.spend()?;
                    unknowns.broken(&rows)?
                }
            };
            if depth == 0 {
                return None;
            }
            break self.branch(&columns, form, value.floor(), depth)?;
        };
        let cut = |then, (form, least, by)| Tree::Cut { form, least, by, then: Box::new(then) };
        Some(cuts.into_iter().rev().fold(found, cut))
    }

    /// The bounds that the rows give beyond what they say, added as columns.
    fn cuts(
        &mut self,
        rows: &[(Polynomial, Kind)],
        unknowns: &Unknowns<'_>,
        columns: &mut Vec<Known>,
    ) -> Vec<(Polynomial, Integer, Weights)> {
        let mut out = Vec::new();
        for (form, least) in rows.iter().filter_map(|(row, kind)| unknowns.cut(row, *kind)) {
            let poly = at_least(&form, &least);
            if out.len() >= CUTS || columns.iter().any(|k| k.poly == poly) {
                continue;
            }
            let before = at_least(&form, &(&least - Integer::ONE));
            if let Some(by) = combination(&before, columns, true) {
                columns.push(column(poly, Kind::Weak));
                out.push((form, least, by));
            }
        }
        out
    }

    /// Two cases; where one of them is absurd at once, the other is a cut.
    fn branch(&mut self, columns: &[Known], form: Polynomial, floor: Integer, depth: usize) -> Option<Tree> {
        let with = |poly: Polynomial| {
            let mut list = columns.to_vec();
            list.push(column(poly, Kind::Weak));
            list
        };
        let above = &floor + Integer::ONE;
        let (low, high) = (at_least(&form.neg(), &-&floor), at_least(&form, &above));
        let last = columns.len();
        // Σ w·p + m·(floor − form) = 0 says that form − floor is the positive Σ (w/m)·p.
        let others = |weights: &Weights| -> Option<Weights> {
            let own = weights.iter().find(|w| w.0 == last)?.1.clone();
            Some(weights.iter().filter(|w| w.0 != last).map(|(place, w)| (*place, w / &own)).collect())
        };
        let low_tree = self.tree(with(low.clone()), depth - 1)?;
        if let Tree::Contradiction(weights) = &low_tree
            && let Some(by) = others(weights)
        {
            let then = Box::new(self.tree(with(high), depth - 1)?);
            return Some(Tree::Cut { form, least: above, by, then });
        }
        let high_tree = self.tree(with(high), depth - 1)?;
        if let Tree::Contradiction(weights) = &high_tree
            && let Some(by) = others(weights)
        {
            return Some(Tree::Cut { form: form.neg(), least: -floor, by, then: Box::new(low_tree) });
        }
        Some(Tree::Branch { form, floor, low: Box::new(low_tree), high: Box::new(high_tree) })
    }
}

impl Prover {
    /// Shows a comparison by arithmetic of whole numbers, against its opposite.
    pub(super) fn by_whole_numbers(&mut self, goal: &Prop) -> Result<Label, Fail> {
        if self.naturals.is_empty() {
            return Err(Fail::No("whole numbers"));
        }
        let Some((a, relation, b)) = goal.single() else {
            return Err(Fail::No("a single comparison is needed"));
        };
        if relation == Relation::Equal {
            let mut both = Vec::new();
            for relation in [Relation::LessEqual, Relation::GreaterEqual] {
                both.push(self.by_whole_numbers(&compare(a.clone(), relation, b.clone()))?);
            }
            return self.emit(Rule::Logic { from: both }, goal.clone());
        }
        self.against_opposite(goal, |c, _| {
            c.solve_equations();
            // With little effort: no products.
            let quiet = c.splits >= 8;
            c.absurd_in_whole_numbers(goal, 0)
                .or_else(|fail| if quiet { Err(fail) } else { c.absurd_in_whole_numbers(goal, 1) })
        })
    }

    /// Shows any goal from facts that no whole numbers satisfy; at level 1 with products of facts.
    pub(super) fn absurd_in_whole_numbers(&mut self, goal: &Prop, level: usize) -> Result<Label, Fail> {
        let no = || Fail::No("a contradiction in whole numbers");
        let mut columns = if level == 0 { self.all_known(&[]) } else { self.columns(&[], level) };
        columns.truncate(ROWS[level.min(1)]);
        let letters = self.whole_letters(columns.iter().flat_map(|k| k.poly.variables()));
        if letters.is_empty() {
            return Err(no());
        }
        columns.push(Known::one());
        self.spend(&columns)?;
        let mut search = Search { letters: &letters, programs: PROGRAMS[level.min(1)] };
        let tree = search.tree(columns.clone(), DEPTH).ok_or_else(no)?;
        self.follow_tree(goal, &tree, columns)
    }

    /// The steps of a contradiction.
    fn follow_tree(&mut self, goal: &Prop, tree: &Tree, mut columns: Vec<Known>) -> Result<Label, Fail> {
        let bound = |form: &Polynomial, label: Label, least: &Integer| Known {
            facts: vec![label],
            factors: vec![numeral(1)],
            ..column(at_least(form, least), Kind::Weak)
        };
        match tree {
            Tree::Contradiction(weights) => {
                let terms = Self::terms(&columns, weights, &[], false);
                let shown = self.combination(compare(numeral(0), Relation::Greater, numeral(0)), terms)?;
                self.logic(&[&shown], goal)
            }
            Tree::Cut { form, least, by, then } => {
                let needed = then.used(columns.len() + 1).contains(&columns.len());
                columns.push(if needed {
                    let before = literal(&Rational::from(least - Integer::ONE));
                    let whole = self.in_naturals(&self.letters.written(form));
                    let terms = Self::terms(&columns, by, &[], false);
                    let from = self.combination(compare(whole.clone(), Relation::Greater, before), terms)?;
                    let shown = compare(whole, Relation::GreaterEqual, literal(&Rational::from(least)));
                    bound(form, self.emit(Rule::Integer { from }, shown)?, least)
                } else {
                    column(Polynomial::zero(), Kind::Weak)
                });
                self.follow_tree(goal, then, columns)
            }
            Tree::Branch { form, floor, low, high } => {
                let whole = self.in_naturals(&self.letters.written(form));
                let (number, above) = (literal(&Rational::from(floor)), floor + Integer::ONE);
                let mut lower = columns.clone();
                let case = compare(whole.clone(), Relation::LessEqual, number.clone());
                let below = self.block(&implies(&case, goal), |c, block| {
                    lower.push(Known {
                        facts: vec![format!("{block}s")],
                        factors: vec![literal(&Rational::from(-1))],
                        ..column(at_least(&form.neg(), &-floor), Kind::Weak)
                    });
                    c.follow_tree(goal, low, lower)
                })?;
                let case = compare(whole.clone(), Relation::Greater, number);
                let beyond = self.block(&implies(&case, goal), |c, block| {
                    let shown = compare(whole, Relation::GreaterEqual, literal(&Rational::from(&above)));
                    let label = match c.known(&shown) {
                        Some(label) => label,
                        None => c.emit(Rule::Integer { from: format!("{block}s") }, shown)?,
                    };
                    columns.push(bound(form, label, &above));
                    c.follow_tree(goal, high, columns)
                })?;
                self.logic(&[&below, &beyond], goal)
            }
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // a test stops where it fails
mod tests {
    use super::*;

    /// c0 + c1·x1 + c2·x2 + …
    fn row(c: &[i64], kind: Kind) -> Known {
        let term = |(v, k): (u32, &i64)| Polynomial::variable(v).scale(&Rational::from(*k));
        let sum = (1..).zip(&c[1..]).map(term).fold(Polynomial::integer(c[0]), |s, t| s.add(&t));
        column(sum, kind)
    }

    /// Whether no whole numbers x1, x2, x3 satisfy these, as far as the search tells.
    fn is_absurd(rows: Vec<Known>) -> bool {
        let letters: BTreeSet<u32> = (1..=3).collect();
        let columns: Vec<Known> = rows.into_iter().chain([Known::one()]).collect();
        let mut search = Search { letters: &letters, programs: PROGRAMS[0] };
        search.tree(columns, DEPTH).is_some()
    }

    #[test]
    fn whole_numbers_that_do_not_exist_are_seen() {
        use Kind::{Strict, Weak, Zero};
        // 2·x + 4·y = 1; 6·x + 10·y + 15·z = 1 has solutions.
        assert!(is_absurd(vec![row(&[-1, 2, 4], Zero)]));
        assert!(!is_absurd(vec![row(&[-1, 6, 10, 15], Zero)]));
        // 0 < 3·x < 3, and 0 < 3·x < 4.
        assert!(is_absurd(vec![row(&[0, 3], Strict), row(&[3, -3], Strict)]));
        assert!(!is_absurd(vec![row(&[0, 3], Strict), row(&[4, -3], Strict)]));
        // 7·x = 5 + 11·y: x = 7 + 11·k.
        assert!(!is_absurd(vec![row(&[-5, 7, -11], Zero), row(&[0, 1], Weak), row(&[10, -1], Weak)]));
        assert!(is_absurd(vec![row(&[-5, 7, -11], Zero), row(&[0, 1], Weak), row(&[3, -1], Weak)]));
        // 27 <= 11·x + 13·y <= 45 and −10 <= 7·x − 9·y <= 4, of Pugh's paper.
        assert!(is_absurd(vec![
            row(&[-27, 11, 13], Weak),
            row(&[45, -11, -13], Weak),
            row(&[10, 7, -9], Weak),
            row(&[4, -7, 9], Weak),
        ]));
    }
}
