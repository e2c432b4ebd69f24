//! Expansions in powers of t = 1/x for a variable x that grows: e = Σ a_i·t^i + ρ·t^n with a bounded number ρ.
//!
//! Method: each part of an expression gets a *node*: the terms below t^n, and a name ρ for what is left over t^n. Sums and
//! products of such are polynomials in t and the ρ of the parts; what lies at t^n and above is the new ρ, and is bounded with
//! |t| <= 1 and the bounds of the parts. For a divisor F = t^v·(b + t·W) there is S with ρ·(b + t·W) = S, and b + t·W keeps away
//! from 0 by |b|/2 where t·2·|W|/|b| <= 1. A function is bounded by its polynomial of Taylor. Nothing is shown here:
//! `expansion_steps` shows what is planned.
//!
//! Limits: [`NODES`], [`ORDER`], [`DEGREE`].

use super::Prover;
use super::arcs::quarter_turn;
use super::facts::{minus, negated};
use super::letters::{as_power, natural, product, whole_power};
use super::limits::over;
use super::taylor::{Function, Side};
use crate::claim::syntax::*;
use crate::kernel::key;
use crate::kernel::order::Signs;
use crate::kernel::statement::{apply, name, numeral, power, sum};
use crate::refute::limit::by_exponentials;
use crate::refute::literal::literal;
use malachite::Rational;
use malachite::base::num::basic::traits::Zero;
use std::collections::{BTreeMap, HashMap};

/// The most parts of an expression.
const NODES: usize = 120;

/// The highest power of t.
const ORDER: i64 = 10;

/// The highest degree of a polynomial of Taylor.
const DEGREE: u32 = 7;

/// The most factors of a product, powers written out.
const FACTORS: usize = 12;

/// Coefficients of products of a power of t and of bounded numbers, each of which may occur more than once.
#[derive(Clone, Default)]
pub(super) struct Series {
    pub terms: BTreeMap<(i64, Vec<usize>), Expr>,
}

impl Series {
    fn constant(c: Expr) -> Series {
        Series { terms: BTreeMap::from([((0, Vec::new()), c)]) }
    }

    /// The same over a power of t.
    pub(super) fn over(&self, power: i64) -> Series {
        let terms = self.terms.iter().map(|((k, list), c)| ((k - power, list.clone()), c.clone()));
        Series { terms: terms.collect() }
    }

    /// The terms of which the power of t is at least this one.
    fn from(&self, power: i64) -> Series {
        let terms = self.terms.iter().filter(|((k, _), _)| *k >= power);
        Series { terms: terms.map(|(m, c)| (m.clone(), c.clone())).collect() }
    }

    /// Whether a term falls with t as a negative power.
    fn is_regular(&self) -> bool {
        self.terms.keys().all(|(k, _)| *k >= 0)
    }
}

/// A part of an expression, and its expansion.
#[derive(Clone)]
pub(super) struct Node {
    pub e: Expr,
    /// The terms below the order, by their powers of t.
    pub terms: BTreeMap<i64, Expr>,
    /// The power of t before what is left; none where nothing is.
    pub order: Option<i64>,
    /// The number before that power.
    pub rest: Option<usize>,
    pub how: How,
}

/// How an expansion comes about.
#[derive(Clone)]
pub(super) enum How {
    /// By reading.
    Exact,
    /// It is another expression, as reading says, or powers and logarithms; of a base the rest and what stands before it.
    Same { child: usize, by_powers: bool, base: Option<[Expr; 3]> },
    /// The expression less its polynomial is the sum of these factors times the same of the parts; what is left.
    Linked { links: Vec<(usize, Factors)>, tail: Series },
    /// 1/F, F = t^power·(lead + t·rest): with ρ·(lead + t·rest) = cofactor.
    Inverse { of: usize, power: i64, lead: Expr, is_negative: bool, rest: Bounded, reach: usize, cofactor: Bounded },
    /// A function at what is near the centre of its expansion.
    Function {
        of: usize,
        function: Function,
        degree: u32,
        small: Bounded,
        reach: usize,
        tail: Series,
        remainder: Series,
    },
    /// Between −1 and 1.
    Turning,
}

/// Parts before one in a product, by their polynomials, and those behind it.
pub(super) type Factors = (bool, Vec<usize>, Vec<usize>);

/// What is bounded, and by what: a numeral or a name.
#[derive(Clone)]
pub(super) struct Bounded {
    pub of: Series,
    pub by: Expr,
}

/// A plan for the expansion of an expression.
pub(super) struct Expansion {
    pub x: String,
    pub nodes: Vec<Node>,
    /// The bounded numbers: their names and bounds.
    pub numbers: Vec<(String, Expr)>,
    /// Names, and the sums of numbers that are not negative for which they stand.
    pub names: Vec<(String, Vec<Expr>)>,
    /// Numbers M for which t·M is to be at most 1.
    pub reach: Vec<Expr>,
    known: HashMap<String, Vec<usize>>,
}

impl Expansion {
    fn new(x: &str) -> Expansion {
        let (nodes, numbers, names, reach, known) = Default::default();
        Expansion { x: x.to_string(), nodes, numbers, names, reach, known }
    }

    /// The polynomial of a node.
    pub(super) fn series(&self, node: usize) -> Series {
        let node = &self.nodes[node];
        let mut terms: BTreeMap<(i64, Vec<usize>), Expr> =
            node.terms.iter().map(|(k, c)| ((*k, Vec::new()), c.clone())).collect();
        if let (Some(order), Some(rest)) = (node.order, node.rest) {
            terms.insert((order, vec![rest]), numeral(1));
        }
        Series { terms }
    }
}

impl Prover {
    /// The expansion of an expression up to t^order, what is left being bounded; the last node is that of the whole.
    pub(super) fn expansion(&mut self, e: &Expr, x: &str, order: i64) -> Option<Expansion> {
        let mut plan = Expansion::new(x);
        let root = self.node(&mut plan, e, order)?;
        let series = plan.series(root);
        if plan.nodes[root].order.is_some_and(|own| own < order) {
            return None;
        }
        let links = vec![(root, (false, Vec::new(), Vec::new()))];
        let whole = self.cut(&mut plan, e.clone(), &series, Some(order), links, true)?;
        plan.nodes.push(whole);
        Some(plan)
    }

    /// The first term of the expansion of an expression that grows or falls like a whole power: the power of t, and its factor.
    pub(super) fn first_term(&mut self, e: &Expr, x: &str) -> Option<(i64, Expr)> {
        self.lead(&mut Expansion::new(x), e)
    }

    fn lead(&mut self, plan: &mut Expansion, e: &Expr) -> Option<(i64, Expr)> {
        for order in [1, 2, 3, 4, 6, 8] {
            let node = self.node(plan, e, order)?;
            let node = &plan.nodes[node];
            if let Some((k, c)) = node.terms.first_key_value() {
                return Some((*k, c.clone()));
            }
            if node.order.is_none_or(|own| own < order) {
                return None;
            }
        }
        None
    }

    /// A power of t that all terms have.
    fn least_power(&mut self, plan: &mut Expansion, e: &Expr) -> Option<i64> {
        if let Some((k, _)) = self.lead(plan, e) {
            return Some(k);
        }
        let node = self.node(plan, e, 1)?;
        Some(plan.nodes[node].order.unwrap_or(ORDER))
    }

    /// The node of an expression up to an order, or a better one; of a lower order where none is known.
    fn node(&mut self, plan: &mut Expansion, e: &Expr, order: i64) -> Option<usize> {
        // A plan takes no step of the search: its work is bounded by its nodes.
        self.exhausted().is_none().then_some(())?;
        let key = key::expr(e);
        let fits = |own: &Option<i64>| own.is_none_or(|own| own >= order);
        let known = plan.known.get(&key).and_then(|list| list.iter().find(|k| fits(&plan.nodes[**k].order)));
        if let Some(known) = known {
            return Some(*known);
        }
        if order > ORDER {
            return None;
        }
        let node = self.new_node(plan, e, order)?;
        plan.nodes.push(node);
        let place = plan.nodes.len() - 1;
        plan.known.entry(key).or_default().push(place);
        (place < NODES).then_some(place)
    }

    fn new_node(&mut self, plan: &mut Expansion, e: &Expr, order: i64) -> Option<Node> {
        if let Some(terms) = self.powers_of_t(e, &plan.x.clone()) {
            return Some(Node { e: e.clone(), terms, order: None, rest: None, how: How::Exact });
        }
        if let Some(quotient) = self.as_quotient(e, &plan.x.clone()).filter(|q| key::expr(q) != key::expr(e)) {
            return self.same(plan, e, &quotient, order, false, None);
        }
        if let Some((base, exponent)) = as_power(e) {
            return self.power_node(plan, e, (&base, &exponent), order);
        }
        match &e.kind {
            ExprKind::Negate(a) => {
                let child = self.node(plan, a, order)?;
                let minus_one = Series::constant(literal(&Rational::from(-1)));
                let series = self.times(&plan.series(child), &minus_one)?;
                let own = plan.nodes[child].order;
                self.cut(plan, e.clone(), &series, own, vec![(child, (true, Vec::new(), Vec::new()))], false)
            }
            ExprKind::Sum(list) => self.sum_node(plan, e, list, order),
            ExprKind::Product(list) => match list.as_slice() {
                [(Factor::Times, one), (Factor::Over, of)] if natural(one) == Some(1) => {
                    self.inverse_node(plan, e, of, order)
                }
                _ => {
                    let items = list.iter().map(|(factor, e)| match factor {
                        Factor::Times => e.clone(),
                        Factor::Over => over(numeral(1), e.clone()),
                    });
                    self.product_node(plan, e, &items.collect::<Vec<_>>(), order)
                }
            },
            ExprKind::Apply(f, list) => self.function_node(plan, e, (&f.text, list.first()?), order),
            _ => None,
        }
    }

    /// A sum of powers of t with factors that are free of it.
    fn powers_of_t(&mut self, e: &Expr, x: &str) -> Option<BTreeMap<i64, Expr>> {
        let reading = self.read(e, false)?;
        if reading.number == 0 {
            return Some(BTreeMap::new());
        }
        let mut all = Series::constant(literal(&reading.number));
        for f in &reading.factors {
            let degrees = self.by_degrees(&f.poly, x)?;
            let mut own = Series::default();
            for (degree, c) in degrees {
                own.terms.insert((-i64::try_from(&degree).ok()?, Vec::new()), self.letters.written(&c));
            }
            if let (Some(((k, _), c)), 1) = (own.terms.first_key_value(), own.terms.len()) {
                let power = ((k * f.power, Vec::new()), whole_power(c.clone(), f.power));
                all = self.times(&all, &Series { terms: BTreeMap::from([power]) })?;
                continue;
            }
            for _ in 0..f.power.max(0) {
                all = self.times(&all, &own)?;
            }
            if f.power < 0 {
                return None;
            }
        }
        pure_below(&all, i64::MAX)
    }

    /// A quotient of sums of powers of t, in lowest terms: the one over the other.
    fn as_quotient(&mut self, e: &Expr, x: &str) -> Option<Expr> {
        if let ExprKind::Product(list) = &e.kind
            && matches!(list.as_slice(), [(Factor::Times, one), (Factor::Over, _)] if natural(one) == Some(1))
        {
            return None;
        }
        let reading = self.read(e, false)?;
        for f in &reading.factors {
            self.by_degrees(&f.poly, x)?;
        }
        let reading = self.split(reading);
        let (mut top, mut bottom) = (vec![literal(&reading.number)], Vec::new());
        for f in &reading.factors {
            let base = self.letters.written(&f.poly);
            match f.power {
                1.. => top.push(whole_power(base, f.power)),
                _ => bottom.push(whole_power(base, -f.power)),
            }
        }
        if bottom.is_empty() {
            return None;
        }
        let divisor = over(numeral(1), product(bottom));
        let top = product(top);
        Some(if natural(&top) == Some(1) { divisor } else { product(vec![top, divisor]) })
    }

    /// The node of an expression that is another one.
    fn same(
        &mut self,
        plan: &mut Expansion,
        e: &Expr,
        other: &Expr,
        order: i64,
        by_powers: bool,
        base: Option<[Expr; 3]>,
    ) -> Option<Node> {
        if key::expr(e) == key::expr(other) {
            return None;
        }
        let child = self.node(plan, other, order)?;
        Some(Node { e: e.clone(), how: How::Same { child, by_powers, base }, ..plan.nodes[child].clone() })
    }

    fn sum_node(&mut self, plan: &mut Expansion, e: &Expr, list: &[(Sign, Expr)], order: i64) -> Option<Node> {
        let (mut all, mut own, mut links) = (Series::default(), None, Vec::new());
        for (sign, part) in list {
            let child = self.node(plan, part, order)?;
            let times = literal(&Rational::from(if *sign == Sign::Plus { 1 } else { -1 }));
            let series = self.times(&plan.series(child), &Series::constant(times))?;
            all = self.plus(&all, &series)?;
            own = least(own, plan.nodes[child].order);
            links.push((child, (*sign == Sign::Minus, Vec::new(), Vec::new())));
        }
        self.cut(plan, e.clone(), &all, own.map(|own| own.min(order)), links, false)
    }

    fn product_node(&mut self, plan: &mut Expansion, e: &Expr, items: &[Expr], order: i64) -> Option<Node> {
        if items.len() > FACTORS {
            return None;
        }
        let mut powers = Vec::new();
        for item in items {
            powers.push(self.least_power(plan, item)?);
        }
        let total: i64 = powers.iter().sum();
        let (mut children, mut own) = (Vec::new(), None);
        for (item, power) in items.iter().zip(&powers) {
            let child = self.node(plan, item, order - (total - power))?;
            own = least(own, plan.nodes[child].order.map(|own| own + total - power));
            children.push(child);
        }
        let mut all = Series::constant(numeral(1));
        for child in &children {
            all = self.times(&all, &plan.series(*child))?;
        }
        let links = (0..children.len())
            .map(|k| (children[k], (false, children[..k].to_vec(), children[k + 1..].to_vec())))
            .collect();
        self.cut(plan, e.clone(), &all, own.map(|own| own.min(order)), links, false)
    }

    /// 1/F from the expansion of F.
    fn inverse_node(&mut self, plan: &mut Expansion, e: &Expr, of: &Expr, order: i64) -> Option<Node> {
        let (power, lead) = self.lead(plan, of)?;
        let Some(signs) = self.sign_of_constant(&lead).filter(|s| s.within(Signs::NOT_ZERO)) else {
            if !self.signs_of(&lead).within(Signs::NOT_ZERO) || matches!(&of.kind, ExprKind::Power(..)) {
                return None;
            }
            // Of a lead of either sign the square is positive.
            let square = over(numeral(1), whole_power(of.clone(), 2));
            return self.same(plan, e, &product(vec![of.clone(), square]), order, false, None);
        };
        let is_negative = !signs.within(Signs::POSITIVE);
        let child = self.node(plan, of, (order + 2 * power).max(power + 1))?;
        let own = plan.nodes[child].order.map_or(order, |own| order.min(own - 2 * power));
        let mut terms: BTreeMap<i64, Expr> = BTreeMap::new();
        for k in 0..own + power {
            let mut list = if k == 0 { vec![numeral(1)] } else { Vec::new() };
            for j in 1..=k {
                if let (Some(b), Some(c)) = (plan.nodes[child].terms.get(&(power + j)), terms.get(&(k - j - power))) {
                    list.push(negated(product(vec![b.clone(), c.clone()])));
                }
            }
            let c = self.simplified(&over(super::asymptotic_form::total(&list), lead.clone()))?;
            if natural(&c) != Some(0) {
                terms.insert(k - power, c);
            }
        }
        let found = Series { terms: terms.iter().map(|(k, c)| ((*k, Vec::new()), negated(c.clone()))).collect() };
        let series = plan.series(child);
        let whole = self.times(&found, &series)?;
        let cofactor = self.plus(&Series::constant(numeral(1)), &whole)?.over(own + power);
        let mut rest = series.over(power);
        rest.terms.remove(&(0, Vec::new()));
        let rest = rest.over(1);
        if !cofactor.is_regular() || !rest.is_regular() {
            return None;
        }
        let (rest, cofactor) = (self.bounded_by_sizes(plan, rest), self.bounded_by_sizes(plan, cofactor));
        let size = if is_negative { negated(lead.clone()) } else { lead.clone() };
        let twice = |e: &Expr| over(product(vec![numeral(2), e.clone()]), size.clone());
        let reach = self.reaches(plan, twice(&rest.by));
        let bound = self.named_sum(plan, vec![twice(&cofactor.by)]);
        let how = How::Inverse { of: child, power, lead, is_negative, rest, reach, cofactor };
        let number = self.number_with(plan, bound);
        Some(Node { e: e.clone(), terms, order: Some(own), rest: Some(number), how })
    }

    /// A power: a product, an inverse, a root of what is near 1, or an exponential.
    fn power_node(
        &mut self,
        plan: &mut Expansion,
        e: &Expr,
        (base, exponent): (&Expr, &Expr),
        order: i64,
    ) -> Option<Node> {
        if let Some(k) = natural(exponent) {
            return match k {
                0 | 1 => None,
                _ => self.product_node(plan, e, &vec![base.clone(); usize::try_from(k).ok()?], order),
            };
        }
        let Some(a) = self.letters.number(exponent) else {
            let log = apply("ln", base.clone());
            let other = apply("exp", product(vec![exponent.clone(), log]));
            return self.same(plan, e, &other, order, true, None);
        };
        if let Ok(k) = i64::try_from(&a)
            && k < 0
        {
            return self.same(plan, e, &over(numeral(1), whole_power(base.clone(), -k)), order, false, None);
        }
        let (k, lead) = self.lead(plan, base)?;
        if k == 0 && self.is_one(&lead) {
            return self.by_taylor(plan, e, (&Function::Root(a), base), order);
        }
        let whole = i64::try_from(&(Rational::from(k) * &a)).ok()?;
        let [rest, scale] = self.rest_and_scale(plan, base, k, &lead)?;
        let mut factors = vec![power(&lead, &literal(&a))];
        if whole != 0 {
            factors.push(whole_power(name(&plan.x), -whole));
        }
        factors.push(power(&rest, &literal(&a)));
        let base = Some([base.clone(), rest, scale]);
        self.same(plan, e, &product(factors), order, true, base)
    }

    /// u/(c·t^k), which tends to 1, and c·t^k; c is positive.
    fn rest_and_scale(&mut self, plan: &Expansion, u: &Expr, k: i64, lead: &Expr) -> Option<[Expr; 2]> {
        if !self.sign_of_constant(lead)?.within(Signs::POSITIVE) {
            return None;
        }
        let scale = match k {
            0 => lead.clone(),
            _ => product(vec![lead.clone(), whole_power(name(&plan.x), -k)]),
        };
        let quotient = over(u.clone(), scale.clone());
        let rest = match self.simplified(&minus(&quotient, &numeral(1))) {
            Some(small) => sum(vec![(Sign::Plus, numeral(1)), (Sign::Plus, small)]),
            None => quotient,
        };
        Some([rest, scale])
    }

    fn function_node(
        &mut self,
        plan: &mut Expansion,
        e: &Expr,
        (function, u): (&str, &Expr),
        order: i64,
    ) -> Option<Node> {
        match function {
            "exp" => {
                let c = self.limit_by(plan, u)?;
                if self.is_zero(&c) {
                    return self.by_taylor(plan, e, (&Function::Exponential, u), order);
                }
                let rest = self.simplified(&minus(u, &c))?;
                let other = product(vec![apply("exp", c), apply("exp", rest)]);
                self.same(plan, e, &other, order, true, None)
            }
            "ln" => {
                let (k, lead) = self.lead(plan, u)?;
                if k != 0 {
                    return None;
                }
                if self.is_one(&lead) {
                    return self.by_taylor(plan, e, (&Function::Logarithm, u), order);
                }
                let [rest, scale] = self.rest_and_scale(plan, u, k, &lead)?;
                let terms = [lead, rest.clone()].map(|e| (Sign::Plus, apply("ln", e)));
                self.same(plan, e, &sum(terms.to_vec()), order, true, Some([u.clone(), rest, scale]))
            }
            "sin" | "cos" => self.turning_node(plan, e, (function, u), order),
            "arcsin" => self.by_taylor(plan, e, (&Function::Arcsine, u), order),
            "arccos" => {
                let other = minus(&quarter_turn(1), &apply("arcsin", u.clone()));
                self.same(plan, e, &other, order, false, None)
            }
            "arctan" => self.arctangent_node(plan, e, u, order),
            "cosh" | "sinh" | "tanh" | "sech" => self.same(plan, e, &by_exponentials(function, u), order, false, None),
            // What is defined.
            _ => {
                let other = self.simplified(e)?;
                self.same(plan, e, &other, order, false, None)
            }
        }
    }

    /// The limit of an expression, where it has one.
    fn limit_by(&mut self, plan: &mut Expansion, u: &Expr) -> Option<Expr> {
        let node = self.node(plan, u, 1)?;
        let node = &plan.nodes[node];
        let is_regular = node.terms.keys().all(|k| *k >= 0) && node.order.is_none_or(|own| own >= 1);
        is_regular.then(|| node.terms.get(&0).cloned().unwrap_or(numeral(0)))
    }

    /// sin and cos: between −1 and 1 where the argument grows; by the limit of the argument, and what is left of it.
    fn turning_node(
        &mut self,
        plan: &mut Expansion,
        e: &Expr,
        (function, u): (&str, &Expr),
        order: i64,
    ) -> Option<Node> {
        let Some(c) = self.limit_by(plan, u) else {
            let rest = Some(self.number_with(plan, numeral(1)));
            return Some(Node { e: e.clone(), terms: BTreeMap::new(), order: Some(0), rest, how: How::Turning });
        };
        let is_sine = function == "sin";
        if self.is_zero(&c) {
            let function = if is_sine { Function::Sine } else { Function::Cosine };
            return self.by_taylor(plan, e, (&function, u), order);
        }
        let rest = self.simplified(&minus(u, &c))?;
        let both = |f: &str, g: &str| product(vec![apply(f, c.clone()), apply(g, rest.clone())]);
        let other = match is_sine {
            true => sum(vec![(Sign::Plus, both("sin", "cos")), (Sign::Plus, both("cos", "sin"))]),
            false => minus(&both("cos", "cos"), &both("sin", "sin")),
        };
        self.same(plan, e, &other, order, false, None)
    }

    fn arctangent_node(&mut self, plan: &mut Expansion, e: &Expr, u: &Expr, order: i64) -> Option<Node> {
        let (k, lead) = self.lead(plan, u)?;
        let other = match k {
            1.. => return self.by_taylor(plan, e, (&Function::Arctangent, u), order),
            0 => {
                let below = sum(vec![(Sign::Plus, numeral(1)), (Sign::Plus, product(vec![lead.clone(), u.clone()]))]);
                let rest = apply("arctan", over(minus(u, &lead), below));
                sum(vec![(Sign::Plus, apply("arctan", lead)), (Sign::Plus, rest)])
            }
            _ => {
                let positive = self.sign_of_constant(&lead)?.within(Signs::POSITIVE);
                minus(&quarter_turn(if positive { 1 } else { -1 }), &apply("arctan", over(numeral(1), u.clone())))
            }
        };
        self.same(plan, e, &other, order, true, None)
    }

    /// A function at an argument that tends to the centre of its expansion.
    fn by_taylor(
        &mut self,
        plan: &mut Expansion,
        e: &Expr,
        (function, u): (&Function, &Expr),
        order: i64,
    ) -> Option<Node> {
        let child = self.node(plan, u, order.max(1))?;
        let centre = literal(&Rational::from(-i64::from(function.centre())));
        let small = self.plus(&plan.series(child), &Series::constant(centre))?;
        let least = small.terms.keys().map(|m| m.0).min().unwrap_or(1);
        if least < 1 {
            return None;
        }
        let own = plan.nodes[child].order.map_or(order, |own| own.min(order)).max(0);
        let degree = (1..=DEGREE).step_by(2).find(|d| i64::from(d + 1) * least >= own)?;
        let (mut polynomial, mut high) = (Series::default(), Series::constant(numeral(1)));
        for c in function.coefficients(degree) {
            let term = self.times(&high, &Series::constant(literal(&c)))?;
            polynomial = self.plus(&polynomial, &term)?;
            high = self.times(&high, &small)?;
        }
        let c = numeral(function.remainder(degree));
        let remainder = self.times(&high, &Series::constant(c))?.over(own);
        let small = self.bounded_by_sizes(plan, small.over(1));
        let reach = self.reaches(plan, product(vec![numeral(2), small.by.clone()]));
        let tail = polynomial.from(own).over(own);
        let sizes = [self.size(plan, &tail), self.size(plan, &remainder)].concat();
        let bound = self.named_sum(plan, sizes);
        let terms = pure_below(&polynomial, own)?;
        let how = How::Function { of: child, function: function.clone(), degree, small, reach, tail, remainder };
        let rest = Some(self.number_with(plan, bound));
        Some(Node { e: e.clone(), terms, order: Some(own), rest, how })
    }

    /// The node of an expression with this polynomial, of which what lies at the order and above gets a name.
    fn cut(
        &mut self,
        plan: &mut Expansion,
        e: Expr,
        series: &Series,
        order: Option<i64>,
        links: Vec<(usize, Factors)>,
        is_whole: bool,
    ) -> Option<Node> {
        let Some(own) = order else {
            let terms = pure_below(series, i64::MAX)?;
            let how = How::Linked { links, tail: Series::default() };
            return Some(Node { e, terms, order: None, rest: None, how });
        };
        let terms = pure_below(series, own)?;
        let tail = series.from(own).over(own);
        if tail.terms.is_empty() && !is_whole {
            let how = How::Linked { links, tail };
            return Some(Node { e, terms, order: None, rest: None, how });
        }
        let sizes = self.size(plan, &tail);
        let bound = self.named_sum(plan, sizes);
        let rest = Some(self.number_with(plan, bound));
        Some(Node { e, terms, order, rest, how: How::Linked { links, tail } })
    }

    /// A new bounded number.
    fn number_with(&mut self, plan: &mut Expansion, bound: Expr) -> usize {
        let name = self.fresh("r");
        plan.numbers.push((name, bound));
        plan.numbers.len() - 1
    }

    fn bounded_by_sizes(&mut self, plan: &mut Expansion, of: Series) -> Bounded {
        let sizes = self.size(plan, &of);
        Bounded { by: self.named_sum(plan, sizes), of }
    }

    /// Numbers that are not negative, whose sum bounds a polynomial for 0 < t <= 1.
    fn size(&mut self, plan: &Expansion, series: &Series) -> Vec<Expr> {
        let mut out = Vec::new();
        for ((_, list), c) in &series.terms {
            let bounds: Vec<Expr> = list.iter().map(|number| plan.numbers[*number].1.clone()).collect();
            for size in self.sizes_of(c) {
                out.push(product([vec![size], bounds.clone()].concat()));
            }
        }
        out
    }

    /// On which side of 0 a number lies.
    pub(super) fn side_of(&mut self, c: &Expr) -> Side {
        match self.letters.number(c) {
            Some(q) if q < 0 => Side::Below,
            Some(_) => Side::Above,
            None => Side::of(self.signs_of(c)),
        }
    }

    /// Numbers that are not negative, whose sum is at least the size of a number: 1/2 and c²/2 for one of either sign.
    fn sizes_of(&mut self, c: &Expr) -> Vec<Expr> {
        let half = literal(&Rational::from_unsigneds(1u32, 2));
        match self.side_of(c) {
            Side::Above => vec![self.letters.number(c).map_or(c.clone(), |q| literal(&q))],
            Side::Below => vec![self.letters.number(c).map_or(negated(c.clone()), |q| literal(&-q))],
            Side::Both => vec![half.clone(), product(vec![half, whole_power(c.clone(), 2)])],
        }
    }

    /// A sum of numbers that are not negative as a numeral, or as a new name.
    fn named_sum(&mut self, plan: &mut Expansion, list: Vec<Expr>) -> Expr {
        if let Some(q) = self.number_of(&list) {
            return literal(&q);
        }
        let fresh = self.fresh("b");
        plan.names.push((fresh.clone(), list));
        name(&fresh)
    }

    /// The place of a number among those that tell how small t is to be.
    fn reaches(&mut self, plan: &mut Expansion, number: Expr) -> usize {
        let number = self.named_sum(plan, vec![number]);
        plan.reach.push(number);
        plan.reach.len() - 1
    }

    fn plus(&mut self, a: &Series, b: &Series) -> Option<Series> {
        let mut all: BTreeMap<(i64, Vec<usize>), Vec<Expr>> = BTreeMap::new();
        for (m, c) in a.terms.iter().chain(&b.terms) {
            all.entry(m.clone()).or_default().push(c.clone());
        }
        self.collected(all)
    }

    fn times(&mut self, a: &Series, b: &Series) -> Option<Series> {
        let mut all: BTreeMap<(i64, Vec<usize>), Vec<Expr>> = BTreeMap::new();
        for ((j, list), c) in &a.terms {
            for ((k, other), d) in &b.terms {
                let mut both = [list.as_slice(), other.as_slice()].concat();
                both.sort_unstable();
                all.entry((j + k, both)).or_default().push(product(vec![c.clone(), d.clone()]));
            }
        }
        self.collected(all)
    }

    fn collected(&mut self, all: BTreeMap<(i64, Vec<usize>), Vec<Expr>>) -> Option<Series> {
        self.exhausted().is_none().then_some(())?;
        let mut terms = BTreeMap::new();
        for (m, list) in all {
            let c = match (self.number_of(&list), list.as_slice()) {
                (Some(q), _) => literal(&q),
                (None, [only @ Expr { kind: ExprKind::Name(_), .. }]) => only.clone(),
                (None, _) => self.simplified(&super::asymptotic_form::total(&list))?,
            };
            if self.letters.number(&c).is_none_or(|q| q != Rational::ZERO) {
                terms.insert(m, c);
            }
        }
        Some(Series { terms })
    }
}

/// The less of two orders, of which none is greater than all.
fn least(a: Option<i64>, b: Option<i64>) -> Option<i64> {
    match (a, b) {
        (Some(a), Some(b)) => Some(a.min(b)),
        (a, b) => a.or(b),
    }
}

/// The terms below a power of t, if they hold no bounded numbers.
fn pure_below(series: &Series, power: i64) -> Option<BTreeMap<i64, Expr>> {
    let below = series.terms.iter().filter(|((k, _), _)| *k < power);
    below.map(|((k, list), c)| list.is_empty().then(|| (*k, c.clone()))).collect()
}
