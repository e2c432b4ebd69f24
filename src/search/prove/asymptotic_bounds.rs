//! Bounds of an expression that are sums of powers of the variable x.
//!
//! Method: each exponential, logarithm, root and divisor of an expression as `asymptotic_form` writes it gets two bounds, the
//! innermost first:
//!
//! - exp(s), ln(1 + s) and (1 + s)^a where s tends to 0: Taylor's polynomial with a remainder C·|s|^(n + 1), for |s| <= 1/2
//!   (Eberl, "Verified real asymptotics in Isabelle/HOL", 2019, has the general theory);
//! - exp(u) where u tends to −infinity: 0 and (−u/j)^(−j), since exp lies above its tangent, and (u/j)^j <= exp(u);
//! - sin(s), cos(s), arcsin(s), arctan(s) where s tends to 0: the same; sine and cosine of another argument −1 and 1,
//!   and so have the powers t^x that `alternating` leaves;
//! - ln(x): 0 and j·x^(1/j), for the same reason.
//!
//! In the expression each stands for its atom, at the end that the sign of the atom's factor asks for. Nothing here is shown:
//! `asymptotic_limits` shows what is found.
//!
//! Limits: [`ATOMS`].

use super::Prover;
use super::asymptotic_form::{Leading, atoms, is_turning, put_for_atom, raised, total};
use super::facts::{minus, negated, power_of};
use super::letters::{product, whole_power};
use super::limits::over;
use super::taylor::{Function, Side, TaylorBound};
use crate::algebra::Polynomial;
use crate::certificate::Label;
use crate::claim::syntax::*;
use crate::kernel::key;
use crate::kernel::order::Signs;
use crate::kernel::statement::{apply, name, numeral, sum};
use crate::refute::literal::literal;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Ceiling;
use malachite::base::num::basic::traits::{One, Zero};

/// The most exponentials, logarithms, roots and divisors.
const ATOMS: usize = 10;

/// How fast a vanishing exponential is taken to fall: like x^(−FALL) for each degree of the polynomials.
const FALL: u32 = 3;

/// What an expression does for large x.
pub(super) enum Tends {
    To(Expr),
    PlusInfinity,
    MinusInfinity,
    Elsewhere,
}

/// A bound, and how it comes about.
#[derive(Clone)]
pub(super) struct Bound {
    pub value: Expr,
    pub steps: Vec<Step>,
}

/// An atom is replaced by a bound of it, the lower (0) or the upper one (1); its factor in the expression.
#[derive(Clone)]
pub(super) struct Step {
    pub atom: Expr,
    pub factor: Expr,
    pub side: usize,
}

/// The lower and the upper bound, as far as there are some.
pub(super) type Bounds = [Option<Bound>; 2];

/// Why a bound of an atom holds.
#[derive(Clone)]
pub(super) enum Reason {
    /// By the expansion of a function of `inside` at a bound of it, which is a small distance from the centre.
    Expansion { lemma: usize, at: Bound, small: usize },
    /// By the tangent of exp at a j-th part of the exponent, or of its opposite.
    Tangent { at: Bound, parts: u32 },
    /// By the tangent of exp at the j-th part of ln(x), or at −ln(x).
    Logarithm { parts: u32 },
}

/// An atom with its bounds.
#[derive(Clone)]
pub(super) struct Piece {
    pub atom: Expr,
    pub function: Function,
    /// The argument of the function, less its limit or over its leading term.
    pub inside: Expr,
    /// The limit of an exponent, or the leading term of another argument, where that is not the centre of the expansion.
    pub scale: Option<Expr>,
    /// Whether that is negative, and the function a divisor's inverse.
    pub turns: bool,
    pub bounds: [Option<Expr>; 2],
    /// Why they hold; where there is no reason, the search shows it.
    pub reasons: [Option<Reason>; 2],
}

impl Piece {
    /// What stands before the function of `inside`, as a factor.
    pub(super) fn factor(&self) -> Expr {
        match (&self.function, &self.scale) {
            (_, None) | (Function::Logarithm, _) => numeral(1),
            (function, Some(c)) => function.at(c),
        }
    }

    /// The atom by the function of `inside`.
    fn whole(&self, value: &Expr) -> Expr {
        match (&self.function, &self.scale) {
            (_, None) => value.clone(),
            (Function::Logarithm, Some(c)) => {
                sum(vec![(Sign::Plus, apply("ln", c.clone())), (Sign::Plus, value.clone())])
            }
            (function, Some(c)) => product(vec![function.at(c), value.clone()]),
        }
    }

    /// The same, where there is something to say.
    pub(super) fn split(&self) -> Option<Expr> {
        self.scale.as_ref().map(|_| self.whole(&self.function.at(&self.inside)))
    }
}

/// A sum of terms c·x^(−r), r > 0, which tends to 0 and is to lie within ±1/2.
pub(super) struct Small {
    pub value: Expr,
    pub terms: Vec<SmallTerm>,
    /// A whole number with r >= 1/d for each r.
    pub d: u32,
}

/// c·x^(−r).
pub(super) struct SmallTerm {
    pub c: Expr,
    pub r: Rational,
    /// x^(−r) as it stands, such as x^(1/2)/x.
    pub power: Expr,
    /// The sign of c.
    pub side: Side,
}

/// Numbers that are not negative and whose sum is at least 2·|c|: for c of an unknown sign 1 and c².
pub(super) fn twice_size(side: Side, c: &Expr) -> Vec<Expr> {
    let times = |k: i64| product(vec![literal(&Rational::from(k)), c.clone()]);
    match side {
        Side::Above => vec![times(2)],
        Side::Below => vec![times(-2)],
        Side::Both => vec![numeral(1), whole_power(c.clone(), 2)],
    }
}

impl Small {
    /// 1 and twice the sizes: from the d-th power of their sum on, it lies within ±1/2.
    pub(super) fn base(&self) -> Vec<Expr> {
        let sizes = self.terms.iter().flat_map(|t| twice_size(t.side, &t.c));
        std::iter::once(numeral(1)).chain(sizes).collect()
    }
}

/// What is found out about one limit.
pub(super) struct Plan {
    pub x: String,
    /// The degree of Taylor's polynomials.
    pub degree: u32,
    /// The j in ln(x) <= j·x^(1/j).
    pub root: u32,
    pub pieces: Vec<Piece>,
    /// What the expansions need, for all y near the centre.
    pub lemmas: Vec<TaylorBound>,
    pub small: Vec<Small>,
    /// What is known for all values of x.
    pub facts: Vec<Label>,
}

impl Prover {
    /// Bounds of an expression by those of its atoms: each at the end that the sign of its factor asks for.
    pub(super) fn bounds_of(&mut self, e: &Expr, plan: &mut Plan) -> Option<Bounds> {
        let mut list = Vec::new();
        atoms(e, &plan.x, &mut list)?;
        let mut pieces = list.iter().map(|atom| self.piece(atom, plan)).collect::<Option<Vec<_>>>()?;
        // The factor of an atom holds the bounds of those before it: what changes its sign comes first, then those whose bounds have
        // an obvious sign.
        let is_bounded = |p: &Piece| p.reasons.iter().all(Option::is_none) && p.function.turns();
        pieces.sort_by_key(|p| {
            (!is_bounded(p), p.reasons.iter().flatten().any(|r| matches!(r, Reason::Expansion { .. })))
        });
        let mut bounds = [None, None];
        for (k, bound) in bounds.iter_mut().enumerate() {
            *bound = self.bound_of(e, &pieces, k, &plan.x)?;
        }
        Some(bounds)
    }

    /// The lower (0) or the upper bound (1), where all atoms have the bounds that it needs.
    fn bound_of(&mut self, e: &Expr, pieces: &[Piece], k: usize, x: &str) -> Option<Option<Bound>> {
        let (mut value, mut steps) = (e.clone(), Vec::new());
        for (place, piece) in pieces.iter().enumerate() {
            // The factor of the atom, with some bound for each of those behind.
            let mut other = value.clone();
            for p in pieces.iter().skip(place + 1) {
                let bounds: Vec<&Expr> = p.bounds.iter().flatten().collect();
                let bound = bounds.iter().find(|b| !self.is_zero(b)).or(bounds.first())?;
                put_for_atom(&mut other, &p.atom, bound);
            }
            let lead = self.leading(&factor_of(&piece.atom, &other), x)?;
            let factor = factor_of(&piece.atom, &value);
            let Some(signs) = self.sign_of_constant(&lead.c) else {
                // Of a factor of either sign, what is positive takes one bound and what is negative the other.
                let (Some(near), Some(far)) = (&piece.bounds[k], &piece.bounds[1 - k]) else { return Some(None) };
                let [up, down] = self.rising_and_falling(&piece.atom, &value, x)?;
                put_for_atom(&mut value, &piece.atom, &numeral(0));
                let parts =
                    [product(vec![up.clone(), near.clone()]), negated(product(vec![down.clone(), far.clone()]))];
                value = total(&[vec![value], parts.to_vec()].concat());
                let both = [(up, k), (negated(down), 1 - k)];
                steps.extend(both.map(|(factor, side)| Step { atom: piece.atom.clone(), factor, side }));
                continue;
            };
            let side = if signs.within(Signs::NOT_NEGATIVE) { k } else { 1 - k };
            steps.push(Step { atom: piece.atom.clone(), factor, side });
            let Some(bound) = &piece.bounds[side] else { return Some(None) };
            put_for_atom(&mut value, &piece.atom, bound);
        }
        Some(Some(Bound { value, steps }))
    }

    /// Two sums of powers of x, neither of them negative, whose difference is the factor of an atom in an expression that is linear
    /// in it: c of either sign is ((c + 1)/2)² − ((c − 1)/2)².
    fn rising_and_falling(&mut self, atom: &Expr, e: &Expr, x: &str) -> Option<[Expr; 2]> {
        let factor = factor_of(atom, e);
        if !self.is_zero(&minus(&factor, &rise(atom, e, 0))) {
            return None;
        }
        let reading = self.read(&factor, false)?;
        let (mut top, mut bottom) = (Polynomial::constant(reading.number.clone()), Vec::new());
        for f in &reading.factors {
            match u32::try_from(f.power) {
                Ok(power) => top = top.try_mul(&f.poly.pow(power).ok()?).ok()?,
                Err(_) => bottom.push(whole_power(self.letters.written(&f.poly), -f.power)),
            }
        }
        let divisor = product(bottom);
        let divides = self.sign_of_constant(&divisor)?;
        let mut sides = [Vec::new(), Vec::new()];
        for (monomial, c) in top.terms() {
            let (_, rest, power) = self.apart(monomial, x)?;
            let mut c = self.letters.written(&Polynomial::term(rest, c.clone()));
            if !divides.within(Signs::POSITIVE) {
                c = negated(c);
            }
            let quarter = |sign: i64| {
                let whole = whole_power(total(&[c.clone(), literal(&Rational::from(sign))]), 2);
                product(vec![literal(&Rational::from_unsigneds(1u32, 4)), whole])
            };
            let parts = match Side::of(self.signs_of(&c)) {
                Side::Above => [Some(c), None],
                Side::Below => [None, Some(negated(c))],
                Side::Both => [Some(quarter(1)), Some(quarter(-1))],
            };
            for (side, part) in sides.iter_mut().zip(parts) {
                side.extend(part.map(|c| product(vec![c, power.clone()])));
            }
        }
        let size = if divides.within(Signs::POSITIVE) { divisor } else { negated(divisor) };
        Some(sides.map(|list| over(total(&list), size.clone())))
    }

    pub(super) fn tends(&mut self, e: &Expr, x: &str) -> Tends {
        let Some(lead) = self.leading(e, x) else { return Tends::Elsewhere };
        match lead.exponent {
            r if r < 0 => Tends::To(numeral(0)),
            r if r == 0 => Tends::To(lead.c),
            _ => match self.sign_of_constant(&lead.c) {
                Some(s) if s.within(Signs::POSITIVE) => Tends::PlusInfinity,
                Some(s) if s.within(Signs::of(Relation::Less)) => Tends::MinusInfinity,
                _ => Tends::Elsewhere,
            },
        }
    }

    /// The bounds of an atom, and why they hold.
    fn piece(&mut self, atom: &Expr, plan: &mut Plan) -> Option<Piece> {
        if let Some(known) = plan.pieces.iter().find(|p| key::expr(&p.atom) == key::expr(atom)) {
            return Some(known.clone());
        }
        let (function, argument) = match &atom.kind {
            ExprKind::Apply(f, list) if f.text == "exp" => (Function::Exponential, list.first()?.clone()),
            ExprKind::Apply(f, list) if f.text == "sin" => (Function::Sine, list.first()?.clone()),
            ExprKind::Apply(f, list) if f.text == "cos" => (Function::Cosine, list.first()?.clone()),
            ExprKind::Apply(f, list) if f.text == "arcsin" => (Function::Arcsine, list.first()?.clone()),
            ExprKind::Apply(f, list) if f.text == "arctan" => (Function::Arctangent, list.first()?.clone()),
            ExprKind::Apply(_, list) => (Function::Logarithm, list.first()?.clone()),
            ExprKind::Power(base, exponent) if is_turning(base, exponent, &plan.x) => {
                (Function::Turning((**base).clone()), (**exponent).clone())
            }
            ExprKind::Power(base, exponent) => (Function::Root(self.letters.number(exponent)?), (**base).clone()),
            _ => return None,
        };
        let (inside, scale) = (argument.clone(), None);
        let (bounds, reasons) = Default::default();
        let mut piece = Piece { atom: atom.clone(), function, inside, scale, turns: false, bounds, reasons };
        if piece.function == Function::Logarithm && matches!(&argument.kind, ExprKind::Name(n) if *n == plan.x) {
            let root = raised(&name(&plan.x), &Rational::from_unsigneds(1, plan.root));
            piece.bounds = [Some(numeral(0)), Some(product(vec![numeral(plan.root), root]))];
            piece.reasons = [1, plan.root].map(|parts| Some(Reason::Logarithm { parts }));
        } else if matches!(piece.function, Function::Turning(_)) {
            piece.bounds = [-1, 1].map(|k| Some(literal(&Rational::from(k))));
        } else {
            let ends = self.bounds_of(&argument, plan)?;
            match piece.function {
                Function::Exponential => self.exponential_piece(&mut piece, ends, plan)?,
                Function::Sine | Function::Cosine => self.circular_piece(&mut piece, ends, plan)?,
                Function::Arcsine | Function::Arctangent => self.arc_piece(&mut piece, ends, plan)?,
                _ => self.other_piece(&mut piece, ends, plan)?,
            }
        }
        plan.pieces.push(piece.clone());
        (plan.pieces.len() <= ATOMS).then_some(piece)
    }

    /// exp(u): by its expansion where u has a limit, else by tangents.
    fn exponential_piece(&mut self, piece: &mut Piece, ends: Bounds, plan: &mut Plan) -> Option<()> {
        let tend = ends.each_ref().map(|e| e.as_ref().map(|e| self.tends(&e.value, &plan.x)));
        match (tend, ends) {
            ([Some(Tends::To(a)), Some(Tends::To(b))], ends) => {
                if !self.is_zero(&minus(&a, &b)) {
                    return None;
                }
                if !self.is_zero(&a) {
                    let limit = self.simplified(&a)?;
                    piece.inside = minus(&piece.inside, &limit);
                    piece.scale = Some(limit);
                }
                let less = |b: Bound| match &piece.scale {
                    Some(c) => Bound { value: minus(&b.value, c), ..b },
                    None => b,
                };
                let ends = ends.map(|e| e.map(less));
                self.expanded(piece, ends, plan)
            }
            ([_, Some(Tends::MinusInfinity)], [_, Some(at)]) => {
                let parts = self.parts_of(&at.value, plan)?;
                let upper = whole_power(part(&at.value, -1, parts), -i64::from(parts));
                piece.bounds = [Some(numeral(0)), Some(upper)];
                piece.reasons = [None, Some(Reason::Tangent { at, parts })];
                Some(())
            }
            ([Some(Tends::PlusInfinity), _], [Some(at), _]) => {
                let parts = self.parts_of(&at.value, plan)?;
                piece.bounds = [Some(whole_power(part(&at.value, 1, parts), i64::from(parts))), None];
                piece.reasons = [Some(Reason::Tangent { at, parts }), None];
                Some(())
            }
            _ => None,
        }
    }

    /// sin(u) and cos(u): by the expansion at 0 where u tends to it and has no atoms itself, else between −1 and 1.
    fn circular_piece(&mut self, piece: &mut Piece, ends: Bounds, plan: &mut Plan) -> Option<()> {
        let is_plain = ends.iter().flatten().all(|end| end.steps.is_empty());
        let argument = piece.inside.clone();
        if is_plain && matches!(self.tends(&argument, &plan.x), Tends::To(limit) if self.is_zero(&limit)) {
            return self.expanded(piece, ends, plan);
        }
        piece.bounds = [-1, 1].map(|k| Some(literal(&Rational::from(k))));
        Some(())
    }

    /// arcsin(u) and arctan(u): by the expansion at 0 where u tends to it.
    fn arc_piece(&mut self, piece: &mut Piece, ends: Bounds, plan: &mut Plan) -> Option<()> {
        for end in ends.iter().flatten() {
            match self.tends(&end.value, &plan.x) {
                Tends::To(limit) if self.is_zero(&limit) => {}
                _ => return None,
            }
        }
        self.expanded(piece, ends, plan)
    }

    /// ln(u) and u^a: by the expansion at 1, u over its leading term; a divisor without one is between 0 and the inverse of its
    /// lower bound.
    fn other_piece(&mut self, piece: &mut Piece, ends: Bounds, plan: &mut Plan) -> Option<()> {
        let leads: Vec<Leading> = ends.iter().flatten().filter_map(|e| self.leading(&e.value, &plan.x)).collect();
        if let [a, b] = leads.as_slice()
            && a.exponent == b.exponent
            && self.is_zero(&minus(&a.c, &b.c))
            && (piece.function != Function::Logarithm || a.exponent == 0)
        {
            let positive = self.sign_of_constant(&a.c)?.within(Signs::POSITIVE);
            if a.exponent == 0 && self.is_one(&a.c) {
                return self.expanded(piece, ends, plan);
            }
            piece.turns = !positive;
            if piece.turns && !matches!(&piece.function, Function::Root(a) if *a == -1) {
                return None;
            }
            let c = self.simplified(&a.c)?;
            let scale = match &a.exponent {
                r if *r == 0 => c,
                r => product(vec![c, raised(&name(&plan.x), r)]),
            };
            let mut ends = ends.map(|e| e.map(|e| e.over(&scale)));
            piece.inside = over(piece.inside.clone(), scale.clone());
            piece.scale = Some(scale);
            if piece.turns {
                ends.reverse();
            }
            self.expanded(piece, ends, plan)?;
            if piece.turns {
                piece.bounds.reverse();
                piece.reasons.reverse();
            }
            return Some(());
        }
        match (&piece.function, &ends[0]) {
            (Function::Root(a), Some(low))
                if *a == -1 && matches!(self.tends(&low.value, &plan.x), Tends::PlusInfinity) =>
            {
                piece.bounds = [Some(numeral(0)), Some(over(numeral(1), low.value.clone()))];
                Some(())
            }
            _ => None,
        }
    }

    /// The j for which (u/j)^j grows as fast as is asked for.
    fn parts_of(&mut self, u: &Expr, plan: &Plan) -> Option<u32> {
        let lead = self.leading(u, &plan.x)?;
        let parts = Ceiling::ceiling(Rational::from(FALL * plan.degree) / lead.exponent);
        u32::try_from(&parts).ok().map(|j| j.clamp(1, 12))
    }

    /// The bounds of a function whose argument lies between two ends that tend to the centre of its expansion.
    fn expanded(&mut self, piece: &mut Piece, ends: Bounds, plan: &mut Plan) -> Option<()> {
        let function = piece.function.clone();
        let centre = numeral(function.centre());
        for k in 0..2 {
            let Some(end) = &ends[if function.falls() { 1 - k } else { k }] else { continue };
            let s = self.simplified(&minus(&end.value, &centre))?;
            let lead = self.leading(&s, &plan.x)?;
            if !self.is_zero(&s) && lead.exponent >= 0 {
                return None;
            }
            let mut side = Side::of(self.signs_of(&lead.c));
            // A remainder of odd degree changes its sign.
            if plan.degree.is_multiple_of(2) && side == Side::Both {
                return None;
            }
            let small = self.small(s.clone(), &plan.x)?;
            // Where terms of other signs stand behind the first, its sign is that of the whole from some number on only.
            if !plan.degree.is_multiple_of(2) && small.terms.iter().any(|term| term.side == Side::Both) {
                side = Side::Both;
            }
            let value = match function.centre() {
                0 => s.clone(),
                _ => sum(vec![(Sign::Plus, numeral(1)), (Sign::Plus, s.clone())]),
            };
            piece.bounds[k] = Some(piece.whole(&function.bound(&s, plan.degree, k == 1, side)));
            let lemma = plan.lemma(&function, side, k == 1);
            let (at, place) = (Bound { value, steps: end.steps.clone() }, plan.small.len());
            piece.reasons[k] = Some(Reason::Expansion { lemma, at, small: place });
            plan.small.push(small);
        }
        Some(())
    }

    /// The terms of what tends to 0.
    fn small(&mut self, value: Expr, x: &str) -> Option<Small> {
        let reading = self.read(&value, false)?;
        let (mut top, mut below) = (Polynomial::constant(reading.number.clone()), Rational::ZERO);
        let (mut bottom, mut divisors) = (Vec::new(), Vec::new());
        for f in &reading.factors {
            if f.power > 0 {
                top = top.try_mul(&f.poly.pow(u32::try_from(f.power).ok()?).ok()?).ok()?;
                continue;
            }
            let [(monomial, c)] = f.poly.terms().collect::<Vec<_>>()[..] else {
                if self.by_degrees(&f.poly, x)?.keys().any(|k| *k != 0) {
                    return None;
                }
                bottom.push(whole_power(self.letters.written(&f.poly), -f.power));
                continue;
            };
            let (degree, rest, power) = self.apart(monomial, x)?;
            below += degree * Rational::from(-f.power);
            bottom.push(whole_power(self.letters.written(&Polynomial::term(rest, c.clone())), -f.power));
            divisors.push(whole_power(power, -f.power));
        }
        let (mut terms, mut d) = (Vec::new(), 1);
        for (monomial, c) in top.terms() {
            let (degree, rest, power) = self.apart(monomial, x)?;
            let r = &below - degree;
            if r <= 0 {
                return None;
            }
            d = d.max(u32::try_from(&Ceiling::ceiling(Rational::ONE / &r)).ok()?);
            let c = self.letters.written(&Polynomial::term(rest, c.clone()));
            let c = self.simplified(&over(c, product(bottom.clone())))?;
            let side = Side::of(self.signs_of(&c));
            terms.push(SmallTerm { c, r, power: over(power, product(divisors.clone())), side });
        }
        Some(Small { value, terms, d })
    }

    /// Numbers from whose sum on all that is small lies within ±1/2: the first is a numeral, and enough for what has no parameters;
    /// then the number for each other that is small.
    ///
    /// For y = x^(1/d) >= 1 + 2·Σ|c|, each |c|·x^(−r) is at most |c|/y, and Σ|c|/y at most 1/2.
    pub(super) fn beginnings(&mut self, plan: &Plan) -> Vec<Vec<Expr>> {
        let (mut least, mut others) = (Rational::from(4), Vec::new());
        for small in &plan.small {
            let base = small.base();
            match self.number_of(&base) {
                Some(number) => {
                    least = least.max(power_of(&Rational::from(Ceiling::ceiling(number)), i64::from(small.d)))
                }
                None if small.d == 1 => others.push(base),
                None => others.push(vec![whole_power(total(&base), i64::from(small.d))]),
            }
        }
        others.insert(0, vec![literal(&least)]);
        others.dedup();
        others
    }

    /// The sum of expressions, if it is a rational number.
    pub(super) fn number_of(&mut self, list: &[Expr]) -> Option<Rational> {
        list.iter().try_fold(Rational::ZERO, |sum, e| Some(sum + self.letters.number(e)?))
    }
}

impl Bound {
    /// The bound of the expression over another; where that is negative, the two bounds change places.
    fn over(self, scale: &Expr) -> Bound {
        let by = |e: Expr| over(e, scale.clone());
        let steps = self.steps.into_iter().map(|s| Step { factor: by(s.factor), ..s });
        Bound { steps: steps.collect(), value: by(self.value) }
    }
}

/// What an atom is multiplied with, in an expression that is linear in it.
fn factor_of(atom: &Expr, e: &Expr) -> Expr {
    rise(atom, e, 1)
}

/// How much an expression rises as an atom in it goes from a number to the next.
fn rise(atom: &Expr, e: &Expr, from: u32) -> Expr {
    let with = |value: u32| {
        let mut e = e.clone();
        put_for_atom(&mut e, atom, &numeral(value));
        e
    };
    minus(&with(from + 1), &with(from))
}

/// ±e/j.
pub(super) fn part(e: &Expr, sign: i64, j: u32) -> Expr {
    product(vec![literal(&Rational::from_signeds(sign, i64::from(j))), e.clone()])
}

impl Plan {
    /// Whether ln(x) is among the atoms.
    pub(super) fn has_logarithm(&self) -> bool {
        self.pieces.iter().flat_map(|p| &p.reasons).any(|r| matches!(r, Some(Reason::Logarithm { .. })))
    }

    /// The place of the statement for all y near the centre that an expansion needs.
    fn lemma(&mut self, function: &Function, side: Side, upper: bool) -> usize {
        let bound = TaylorBound { function: function.clone(), degree: self.degree, upper, side };
        let place = self.lemmas.iter().position(|known| *known == bound);
        place.unwrap_or_else(|| {
            self.lemmas.push(bound);
            self.lemmas.len() - 1
        })
    }
}
