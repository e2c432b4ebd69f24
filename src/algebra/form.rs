//! Products of powers, with any exponents, of variables and of sums: the normal form of the prover.
//!
//! A [`Form`] is c · ∏ aᵢ^Eᵢ with a rational c, atoms aᵢ and exponents Eᵢ that may hold symbols:
//! `m1^(1/(n + 1))`, `(x + 1)^(i + 1)`. An atom is a variable, a member of a family, a prime under a
//! root, the base of natural exponentials, a logarithm, a sum or product over an index, or a
//! primitive [`Poly`]: a sum of monomials in the other atoms.
//!
//! Contract: two expressions with the same form are equal wherever both are defined and every atom
//! with a fractional or symbolic exponent is positive (or non-negative under a positive numeric
//! exponent); who builds forms checks that. The converse may fail: atoms are treated as independent,
//! which can hide an equality but never invents one. Sums are put over a common monomial and
//! expanded, so the form of a difference is zero iff the difference vanishes identically in the atoms.
//!
//! Method: monomials with exponents from an ordered group form the group's algebra, which has no
//! zero divisors. The order on exponents is that of rational functions with each symbol infinitely
//! larger than all before it; because primitive sums have a positive leading coefficient, the sign of
//! an exponent in that order is the sign of its coefficient. Exponents of which that is not known, as
//! with √2 or √(1 − x) in them, come after all others and have an order of their own
//! ([`Ring::exponent_order`]): quotients of sums with such exponents may not be found, and one that is
//! found is right whatever the order is.
//!
//! Cost: that of expanding: products of term counts, bounded by [`Ring::terms_limit`].

use super::Instant;
use malachite::Natural;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::{Floor, Lcm, Parity, Pow, Reciprocal};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::comparison::traits::PartialOrdAbs;
use malachite::base::num::logic::traits::SignificantBits;
use rustc_hash::FxHashMap as HashMap;
use std::cmp::Ordering;
use std::rc::Rc;

/// The number of an atom in its [`Ring`].
pub type AtomId = u32;

/// A limit that was reached, with its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limit(pub &'static str);

/// An exponent: a number, or a form in natural and real variables.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Exponent {
    /// A rational number.
    Number(Rational),
    /// A form that is not a number.
    Symbolic(Rc<Form>),
}

impl Exponent {
    /// An integer exponent.
    pub fn integer(value: i64) -> Exponent {
        Exponent::Number(Rational::from(value))
    }

    /// Whether it is the number 0.
    pub fn is_zero(&self) -> bool {
        matches!(self, Exponent::Number(q) if *q == 0)
    }

    /// The number, if it is one.
    pub fn number(&self) -> Option<&Rational> {
        match self {
            Exponent::Number(q) => Some(q),
            Exponent::Symbolic(_) => None,
        }
    }

    /// The integer, if it is one that fits.
    pub fn as_integer(&self) -> Option<i64> {
        self.number().and_then(|q| i64::try_from(q).ok())
    }

    /// Whether it is an even integer, of any size.
    pub fn is_even(&self) -> bool {
        self.number().is_some_and(|q| *q.denominator_ref() == 1 && q.numerator_ref().even())
    }

    /// Whether it is an integer, of any size.
    pub fn is_integer(&self) -> bool {
        self.number().is_some_and(|q| *q.denominator_ref() == 1)
    }

    /// The exponent as a form.
    pub fn form(&self) -> Form {
        match self {
            Exponent::Number(q) => Form::number(q.clone()),
            Exponent::Symbolic(form) => (**form).clone(),
        }
    }

    /// The exponent with this form.
    pub fn of(form: Form) -> Exponent {
        if form.powers.is_empty() { Exponent::Number(form.coefficient) } else { Exponent::Symbolic(Rc::new(form)) }
    }

    /// The sign of a number; for a form that of its coefficient, which is how it is written, not what it is.
    pub fn order_sign(&self) -> Ordering {
        match self {
            Exponent::Number(q) => q.partial_cmp(&0).unwrap_or(Ordering::Equal),
            Exponent::Symbolic(form) => form.coefficient.partial_cmp(&0).unwrap_or(Ordering::Equal),
        }
    }
}

/// A product of powers of distinct atoms, sorted by atom, no exponent zero.
pub type Monomial = Vec<(AtomId, Exponent)>;

/// c · ∏ aᵢ^Eᵢ; zero is c = 0 with no powers.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Form {
    /// The rational coefficient.
    pub coefficient: Rational,
    /// The powers, sorted by atom, no exponent zero.
    pub powers: Monomial,
}

impl Form {
    /// A number.
    pub fn number(value: Rational) -> Form {
        Form { coefficient: value, powers: Vec::new() }
    }

    /// An integer.
    pub fn integer(value: i64) -> Form {
        Form::number(Rational::from(value))
    }

    /// A single atom.
    pub fn atom(atom: AtomId) -> Form {
        Form { coefficient: Rational::ONE, powers: vec![(atom, Exponent::integer(1))] }
    }

    /// Whether it is zero.
    pub fn is_zero(&self) -> bool {
        self.coefficient == 0
    }

    /// The number, if it is one.
    pub fn as_number(&self) -> Option<&Rational> {
        self.powers.is_empty().then_some(&self.coefficient)
    }

    /// −f.
    pub fn negated(&self) -> Form {
        Form { coefficient: -&self.coefficient, powers: self.powers.clone() }
    }
}

/// A sum of monomials with rational coefficients, largest monomial first.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Poly {
    /// The terms, no coefficient zero, no monomial twice.
    pub terms: Vec<(Monomial, Rational)>,
}

/// What an atom stands for.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Atom {
    /// A variable or a bound index.
    Variable(String),
    /// A member of a family or of a sequence: name and index.
    Member(String, Form),
    /// A prime (or a number too large to factor) under a root or a symbolic exponent.
    Prime(Natural),
    /// A primitive sum of at least two terms.
    Sum(Rc<Poly>),
    /// The base of natural exponentials.
    Euler,
    /// The logarithm of an atom.
    Logarithm(AtomId),
    /// The sum of a form over `index` from `from` to `to`.
    SumOver(Box<Over>),
    /// The product of a form over `index` from `from` to `to`.
    ProductOver(Box<Over>),
}

/// A sum or product over an index: its body in terms of the bound variable's atom, and its range.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Over {
    /// The atom of the bound index; the same for all sums and products.
    pub index: AtomId,
    /// The summand or factor.
    pub body: Form,
    /// First index.
    pub from: Form,
    /// Last index.
    pub to: Form,
}

/// Atoms and the arithmetic of forms over them.
pub struct Ring {
    atoms: Vec<Rc<Atom>>,
    index: HashMap<Rc<Atom>, AtomId>,
    /// The largest number of terms a sum may have.
    pub terms_limit: usize,
    /// The largest integer exponent that is expanded.
    pub degree_limit: u32,
    /// The largest number of bits of a coefficient's numerator or denominator after a power.
    pub bits_limit: u64,
    /// Sums of symbolic exponents that were formed before: the same few come up all the time.
    exponent_sums: HashMap<(Exponent, Exponent), Exponent>,
    /// Quotients of sums that were tried before, by the atoms of the sums.
    quotients: HashMap<(AtomId, AtomId), Option<Form>>,
    /// Whether each atom may stand in exponents that are ordered by their leading coefficients.
    ordered: Vec<bool>,
    /// When to give up.
    pub deadline: Option<Instant>,
    /// Terms that were added up, for a look at the clock now and then.
    accumulated: u32,
}

/// The largest size of a number in an exponent: it fits in 64 bits with room to add, and what is whole is seen to be whole.
const LARGEST_EXPONENT: u64 = 1 << 31;

/// The most bits of a coefficient in a product or a sum.
const COEFFICIENT_BITS: u64 = 1_000_000;

fn too_large(q: &Rational) -> bool {
    q.gt_abs(&Rational::from(LARGEST_EXPONENT))
}

/// The exponent, where no number in it is too large.
fn bounded(exponent: Exponent) -> Result<Exponent> {
    let number = match &exponent {
        Exponent::Number(q) => q,
        Exponent::Symbolic(form) => &form.coefficient,
    };
    if too_large(number) { Err(Limit("exponent")) } else { Ok(exponent) }
}

/// An order of exponents as they are written.
fn written_order(a: &Exponent, b: &Exponent) -> Ordering {
    match (a, b) {
        (Exponent::Number(a), Exponent::Number(b)) => a.cmp(b),
        (Exponent::Number(_), Exponent::Symbolic(_)) => Ordering::Less,
        (Exponent::Symbolic(_), Exponent::Number(_)) => Ordering::Greater,
        (Exponent::Symbolic(a), Exponent::Symbolic(b)) => {
            let mut pairs = a.powers.iter().zip(&b.powers);
            let first = pairs.find_map(|(p, q)| {
                Some(p.0.cmp(&q.0).then_with(|| written_order(&p.1, &q.1))).filter(|order| order.is_ne())
            });
            first.unwrap_or(a.powers.len().cmp(&b.powers.len())).then_with(|| a.coefficient.cmp(&b.coefficient))
        }
    }
}

/// The most sums of exponents that are kept.
const REMEMBERED: usize = 50_000;

impl Default for Ring {
    fn default() -> Ring {
        Ring {
            atoms: Vec::new(),
            index: HashMap::default(),
            terms_limit: 5_000,
            degree_limit: 100,
            bits_limit: 100_000,
            exponent_sums: HashMap::default(),
            quotients: HashMap::default(),
            ordered: Vec::new(),
            deadline: None,
            accumulated: 0,
        }
    }
}

type Result<T> = std::result::Result<T, Limit>;

impl Ring {
    /// The atom's number, made if new.
    pub fn intern(&mut self, atom: Atom) -> AtomId {
        if let Some(&id) = self.index.get(&atom) {
            return id;
        }
        let id = u32::try_from(self.atoms.len()).unwrap_or(u32::MAX);
        let ordered = match &atom {
            Atom::Variable(_) => true,
            Atom::Member(_, index) => self.is_ordered(index),
            // The opposite of a primitive sum, made to have a positive base, has a negative leading coefficient.
            Atom::Sum(poly) => {
                poly.terms.first().is_some_and(|t| t.1 > 0) && poly.terms.iter().all(|t| self.are_ordered(&t.0))
            }
            _ => false,
        };
        self.ordered.push(ordered);
        let atom = Rc::new(atom);
        self.atoms.push(atom.clone());
        self.index.insert(atom, id);
        id
    }

    /// What an atom stands for.
    pub fn atom(&self, id: AtomId) -> Rc<Atom> {
        self.atoms[id as usize].clone()
    }

    /// The form of a variable.
    pub fn variable(&mut self, name: &str) -> Form {
        Form::atom(self.intern(Atom::Variable(name.to_string())))
    }

    /// The sum under an atom, if it is one.
    pub fn sum(&self, id: AtomId) -> Option<Rc<Poly>> {
        match &*self.atoms[id as usize] {
            Atom::Sum(poly) => Some(poly.clone()),
            _ => None,
        }
    }

    // ---- exponents ----

    /// a + b.
    pub fn exponent_sum(&mut self, a: &Exponent, b: &Exponent) -> Result<Exponent> {
        if let (Exponent::Number(a), Exponent::Number(b)) = (a, b) {
            return bounded(Exponent::Number(a + b));
        }
        if a.is_zero() {
            return Ok(b.clone());
        }
        if b.is_zero() {
            return Ok(a.clone());
        }
        let key = (a.clone(), b.clone());
        if let Some(sum) = self.exponent_sums.get(&key) {
            return Ok(sum.clone());
        }
        let sum = bounded(Exponent::of(self.add(&[a.form(), b.form()])?))?;
        if self.exponent_sums.len() < REMEMBERED {
            self.exponent_sums.insert(key, sum.clone());
        }
        Ok(sum)
    }

    /// a · b.
    pub fn exponent_product(&mut self, a: &Exponent, b: &Exponent) -> Result<Exponent> {
        if let (Exponent::Number(a), Exponent::Number(b)) = (a, b) {
            return bounded(Exponent::Number(a * b));
        }
        bounded(Exponent::of(self.mul(&a.form(), &b.form())?))
    }

    /// −a.
    pub fn exponent_negated(&mut self, a: &Exponent) -> Exponent {
        match a {
            Exponent::Number(q) => Exponent::Number(-q),
            Exponent::Symbolic(form) => Exponent::Symbolic(Rc::new(form.negated())),
        }
    }

    fn are_ordered(&self, powers: &Monomial) -> bool {
        powers.iter().all(|(atom, exponent)| {
            self.ordered.get(*atom as usize) == Some(&true)
                && match exponent {
                    Exponent::Number(_) => true,
                    Exponent::Symbolic(form) => self.is_ordered(form),
                }
        })
    }

    fn is_ordered(&self, form: &Form) -> bool {
        self.are_ordered(&form.powers)
    }

    /// The order of the ring: that of a − b. The others are larger than those for which that is an order, and among
    /// themselves are ordered as they are written: a total order, but none that sums keep.
    pub fn exponent_order(&mut self, a: &Exponent, b: &Exponent) -> Result<Ordering> {
        if let (Exponent::Number(a), Exponent::Number(b)) = (a, b) {
            return Ok(a.cmp(b));
        }
        if a == b {
            return Ok(Ordering::Equal);
        }
        let ordered = |e: &Exponent| match e {
            Exponent::Number(_) => true,
            Exponent::Symbolic(form) => self.is_ordered(form),
        };
        match (ordered(a), ordered(b)) {
            (true, true) => {}
            (false, false) => return Ok(written_order(a, b)),
            (first, second) => return Ok(second.cmp(&first)),
        }
        let minus = self.exponent_negated(b);
        Ok(self.exponent_sum(a, &minus)?.order_sign())
    }

    /// Splits E = S + k, k an integer: the floor of a number, or of the constant among the summands
    /// of a form: (n + 1)/n is 1/n + 1.
    fn split_integer(&mut self, exponent: &Exponent) -> Result<(Exponent, i64)> {
        let whole = match exponent {
            Exponent::Number(q) => q.floor(),
            Exponent::Symbolic(form) => {
                let mut constant = Rational::ZERO;
                for summand in self.summands(form)? {
                    if let Some(q) = summand.as_number() {
                        constant += q;
                    }
                }
                constant.floor()
            }
        };
        let k = i64::try_from(&whole).map_err(|_| Limit("exponent"))?;
        if k == 0 {
            return Ok((exponent.clone(), 0));
        }
        let rest = self.exponent_sum(exponent, &Exponent::integer(-k))?;
        Ok((rest, k))
    }

    // ---- monomials ----

    fn monomial_product(&mut self, a: &Monomial, b: &Monomial) -> Result<Monomial> {
        let mut out = Vec::with_capacity(a.len() + b.len());
        let (mut i, mut j) = (0, 0);
        while i < a.len() || j < b.len() {
            if j >= b.len() || (i < a.len() && a[i].0 < b[j].0) {
                out.push(a[i].clone());
                i += 1;
            } else if i >= a.len() || b[j].0 < a[i].0 {
                out.push(b[j].clone());
                j += 1;
            } else {
                let sum = self.exponent_sum(&a[i].1, &b[j].1)?;
                if !sum.is_zero() {
                    out.push((a[i].0, sum));
                }
                i += 1;
                j += 1;
            }
        }
        Ok(out)
    }

    fn monomial_order(&mut self, a: &Monomial, b: &Monomial) -> Result<Ordering> {
        let (mut i, mut j) = (0, 0);
        while i < a.len() || j < b.len() {
            if j >= b.len() || (i < a.len() && a[i].0 < b[j].0) {
                return self.exponent_order(&a[i].1, &Exponent::integer(0));
            }
            if i >= a.len() || b[j].0 < a[i].0 {
                return self.exponent_order(&Exponent::integer(0), &b[j].1);
            }
            match self.exponent_order(&a[i].1, &b[j].1)? {
                Ordering::Equal => {}
                other => return Ok(other),
            }
            i += 1;
            j += 1;
        }
        Ok(Ordering::Equal)
    }

    // ---- polynomials ----

    fn collect(&mut self, terms: HashMap<Monomial, Rational>) -> Result<Poly> {
        let mut terms: Vec<(Monomial, Rational)> = terms.into_iter().filter(|t| t.1 != 0).collect();
        if terms.len() > self.terms_limit {
            return Err(Limit("terms"));
        }
        let mut fault = None;
        terms.sort_by(|a, b| match self.monomial_order(&b.0, &a.0) {
            Ok(order) => order,
            Err(limit) => {
                fault = Some(limit);
                Ordering::Equal
            }
        });
        match fault {
            Some(limit) => Err(limit),
            None => Ok(Poly { terms }),
        }
    }

    /// Adds c·monomial to the terms, expanding powers of sums whose exponent has an integer part.
    fn accumulate(&mut self, into: &mut HashMap<Monomial, Rational>, monomial: Monomial, c: &Rational) -> Result<()> {
        self.look_at_the_clock()?;
        let mut c = c.clone();
        let mut kept = Vec::with_capacity(monomial.len());
        let mut expanded: Option<Poly> = None;
        for (atom, exponent) in &monomial {
            let kind = self.atom(*atom);
            if !matches!(*kind, Atom::Sum(_) | Atom::Prime(_)) {
                kept.push((*atom, exponent.clone()));
                continue;
            }
            let (rest, k) = self.split_integer(exponent)?;
            if !rest.is_zero() {
                kept.push((*atom, rest));
            }
            match &*kind {
                _ if k == 0 => {}
                Atom::Prime(p) => c *= self.rational_power(&Rational::from(p.clone()), k)?,
                Atom::Sum(_) if k < 0 => return Err(Limit("negative power of a sum inside a sum")),
                Atom::Sum(poly) => {
                    let power = self.poly_power(poly, u32::try_from(k).map_err(|_| Limit("degree"))?)?;
                    // One after the other, so that like terms meet before the next is multiplied out.
                    expanded = Some(match expanded {
                        Some(before) => self.poly_product(&before, &power)?,
                        None => power,
                    });
                }
                _ => {}
            }
        }
        if let Some(sum) = expanded {
            for (other, d) in &sum.terms {
                let product = self.monomial_product(&kept, other)?;
                self.accumulate(into, product, &(&c * d))?;
            }
            return Ok(());
        }
        if into.len() > self.terms_limit {
            return Err(Limit("terms"));
        }
        let sum = into.entry(kept).or_insert(Rational::ZERO);
        *sum += c;
        if sum.significant_bits() > COEFFICIENT_BITS { Err(Limit("digits")) } else { Ok(()) }
    }

    /// Gives up where the time is over.
    fn look_at_the_clock(&mut self) -> Result<()> {
        self.accumulated = self.accumulated.wrapping_add(1);
        if self.accumulated.is_multiple_of(1024)
            && let Some(deadline) = self.deadline
            && Instant::now() > deadline
        {
            return Err(Limit("time"));
        }
        Ok(())
    }

    /// p · q.
    pub fn poly_product(&mut self, p: &Poly, q: &Poly) -> Result<Poly> {
        let mut terms = HashMap::default();
        for (a, c) in &p.terms {
            for (b, d) in &q.terms {
                let product = self.monomial_product(a, b)?;
                self.accumulate(&mut terms, product, &(c * d))?;
            }
        }
        self.collect(terms)
    }

    fn poly_power(&mut self, p: &Poly, k: u32) -> Result<Poly> {
        if k > self.degree_limit {
            return Err(Limit("degree"));
        }
        let mut out = Poly { terms: vec![(Vec::new(), Rational::ONE)] };
        for _ in 0..k {
            out = self.poly_product(&out, p)?;
        }
        Ok(out)
    }

    fn rational_power(&self, base: &Rational, k: i64) -> Result<Rational> {
        let bits = base.significant_bits();
        if bits.saturating_mul(k.unsigned_abs()) > self.bits_limit && bits > 2 {
            return Err(Limit("digits"));
        }
        Ok(base.pow(k))
    }

    /// The least and the largest exponent of each atom.
    fn spread(&mut self, p: &Poly) -> Result<Vec<(AtomId, Exponent, Exponent)>> {
        let mut atoms: Vec<AtomId> = p.terms.iter().flat_map(|t| t.0.iter().map(|x| x.0)).collect();
        atoms.sort_unstable();
        atoms.dedup();
        let mut out = Vec::with_capacity(atoms.len());
        for atom in atoms {
            let (mut low, mut high) = (exponent_in(&p.terms[0].0, atom), exponent_in(&p.terms[0].0, atom));
            for (monomial, _) in &p.terms[1..] {
                let e = exponent_in(monomial, atom);
                if self.exponent_order(&e, &low)? == Ordering::Less {
                    low = e;
                } else if self.exponent_order(&e, &high)? == Ordering::Greater {
                    high = e;
                }
            }
            out.push((atom, low, high));
        }
        Ok(out)
    }

    /// The quotient of the sums under two atoms if the division is exact.
    pub fn atom_quotient(&mut self, above: AtomId, below: AtomId) -> Result<Option<Form>> {
        if let Some(known) = self.quotients.get(&(above, below)) {
            return Ok(known.clone());
        }
        let (Some(p), Some(q)) = (self.sum(above), self.sum(below)) else { return Ok(None) };
        let quotient = match self.poly_quotient(&p, &q)? {
            Some(quotient) => Some(self.poly_form(quotient)?),
            None => None,
        };
        self.quotients.insert((above, below), quotient.clone());
        Ok(quotient)
    }

    /// p / q if the division is exact.
    ///
    /// In each atom the least and largest exponents of a product are the sums of those of its
    /// factors, which bounds the exponents of the quotient: a term outside these bounds shows that
    /// the division is not exact. `None` also after |p| + 16 terms of the quotient.
    fn poly_quotient(&mut self, p: &Poly, q: &Poly) -> Result<Option<Poly>> {
        let Some((lead, c)) = q.terms.first().cloned() else { return Ok(None) };
        if p.terms.is_empty() {
            return Ok(Some(p.clone()));
        }
        if self.leaves_a_rest(p, q)? {
            return Ok(None);
        }
        let mut bounds = self.spread(p)?;
        for (atom, low, high) in self.spread(q)? {
            let Some(place) = bounds.iter().position(|b| b.0 == atom) else { return Ok(None) };
            let (minus_low, minus_high) = (self.exponent_negated(&low), self.exponent_negated(&high));
            let least = self.exponent_sum(&bounds[place].1, &minus_low)?;
            let most = self.exponent_sum(&bounds[place].2, &minus_high)?;
            if self.exponent_order(&least, &most)? == Ordering::Greater {
                return Ok(None);
            }
            bounds[place] = (atom, least, most);
        }
        let mut minus = Vec::with_capacity(lead.len());
        for (a, e) in &lead {
            minus.push((*a, self.exponent_negated(e)));
        }
        let mut rest = p.terms.clone();
        let mut quotient: HashMap<Monomial, Rational> = HashMap::default();
        for _ in 0..p.terms.len() + 16 {
            let Some((top, d)) = rest.first() else {
                return Ok(Some(self.collect(quotient)?));
            };
            let monomial = self.monomial_product(top, &minus)?;
            for (atom, low, high) in &bounds {
                let e = exponent_in(&monomial, *atom);
                if self.exponent_order(&e, low)? == Ordering::Less
                    || self.exponent_order(&e, high)? == Ordering::Greater
                {
                    return Ok(None);
                }
            }
            let factor = d / &c;
            let mut product = Vec::with_capacity(q.terms.len());
            for (other, k) in &q.terms {
                product.push((self.monomial_product(&monomial, other)?, -(k * &factor)));
            }
            rest = self.merged(rest, product)?;
            if rest.len() > self.terms_limit {
                return Err(Limit("terms"));
            }
            // Where sums do not keep the order a term may come up again. What was subtracted so far is the product with
            // all terms, each counted once.
            if quotient.insert(monomial, factor).is_some() {
                return Ok(None);
            }
        }
        Ok(None)
    }

    /// Whether division of p by a binomial u ± v is seen to leave a rest: modulo it u is ∓v, so each monomial m is
    /// ±m·(v/u)^k for every k, and one representative of each class is enough. One step for each term of p.
    fn leaves_a_rest(&mut self, p: &Poly, q: &Poly) -> Result<bool> {
        let [(u, c), (v, d)] = q.terms.as_slice() else { return Ok(false) };
        let alternating = c == d;
        if !alternating && *c != -d {
            return Ok(false);
        }
        let mut minus = Vec::with_capacity(u.len());
        for (atom, e) in u {
            minus.push((*atom, self.exponent_negated(e)));
        }
        let mut ratio: Vec<(AtomId, Rational)> = Vec::new();
        for (atom, e) in self.monomial_product(v, &minus)? {
            let Exponent::Number(e) = e else { return Ok(false) };
            ratio.push((atom, e));
        }
        let Some((atom, step)) = ratio.first() else { return Ok(false) };
        let mut classes: HashMap<Monomial, Rational> = HashMap::default();
        for (monomial, coefficient) in &p.terms {
            let Exponent::Number(e) = exponent_in(monomial, *atom) else { return Ok(false) };
            let k = -(e / step).floor();
            let factor = Rational::from(&k);
            let shift: Monomial = ratio.iter().map(|(a, e)| (*a, Exponent::Number(e * &factor))).collect();
            let class = if k == 0 { monomial.clone() } else { self.monomial_product(monomial, &shift)? };
            let sum = classes.entry(class).or_insert(Rational::ZERO);
            if alternating && (&k).odd() {
                *sum -= coefficient;
            } else {
                *sum += coefficient;
            }
        }
        Ok(classes.values().any(|c| *c != 0))
    }

    /// The sum of two lists of terms, both in decreasing order; few of `b` against many of `a`.
    fn merged(
        &mut self,
        a: Vec<(Monomial, Rational)>,
        b: Vec<(Monomial, Rational)>,
    ) -> Result<Vec<(Monomial, Rational)>> {
        let mut out = Vec::with_capacity(a.len() + b.len());
        let mut rest = a.into_iter();
        for (monomial, c) in b {
            let list = rest.as_slice();
            let (mut low, mut high) = (0, list.len());
            while low < high {
                let middle = usize::midpoint(low, high);
                match self.monomial_order(&list[middle].0, &monomial)? {
                    Ordering::Greater => low = middle + 1,
                    _ => high = middle,
                }
            }
            out.extend(rest.by_ref().take(low));
            match rest.as_slice().first() {
                Some((same, d)) if *same == monomial => {
                    let sum = d + c;
                    rest.next();
                    if sum != 0 {
                        out.push((monomial, sum));
                    }
                }
                _ => out.push((monomial, c)),
            }
        }
        out.extend(rest);
        Ok(out)
    }

    // ---- forms ----

    fn normalise(&mut self, mut form: Form) -> Result<Form> {
        if form.coefficient == 0 {
            return Ok(Form::integer(0));
        }
        let mut place = 0;
        while place < form.powers.len() {
            let (atom, exponent) = form.powers[place].clone();
            if let Atom::Prime(p) = &*self.atom(atom) {
                let (rest, k) = self.split_integer(&exponent)?;
                if k != 0 {
                    form.coefficient *= self.rational_power(&Rational::from(p.clone()), k)?;
                    if rest.is_zero() {
                        form.powers.remove(place);
                        continue;
                    }
                    form.powers[place].1 = rest;
                }
            }
            place += 1;
        }
        Ok(form)
    }

    /// a · b.
    pub fn mul(&mut self, a: &Form, b: &Form) -> Result<Form> {
        if a.is_zero() || b.is_zero() {
            return Ok(Form::integer(0));
        }
        if a.coefficient.significant_bits() + b.coefficient.significant_bits() > COEFFICIENT_BITS {
            return Err(Limit("digits"));
        }
        let powers = self.monomial_product(&a.powers, &b.powers)?;
        self.normalise(Form { coefficient: &a.coefficient * &b.coefficient, powers })
    }

    /// 1 / a, a not zero.
    pub fn inverse(&mut self, a: &Form) -> Result<Form> {
        let mut powers = Vec::with_capacity(a.powers.len());
        for (atom, exponent) in &a.powers {
            powers.push((*atom, self.exponent_negated(exponent)));
        }
        self.normalise(Form { coefficient: (&a.coefficient).reciprocal(), powers })
    }

    /// a / b, b not zero.
    pub fn div(&mut self, a: &Form, b: &Form) -> Result<Form> {
        let inverse = self.inverse(b)?;
        self.mul(a, &inverse)
    }

    /// a^E. The caller sees to it that the power is defined and distributes over the product.
    pub fn power(&mut self, a: &Form, exponent: &Exponent) -> Result<Form> {
        if exponent.number().is_some_and(too_large) {
            return Err(Limit("exponent"));
        }
        if exponent.is_zero() {
            return Ok(Form::integer(1));
        }
        if a.is_zero() {
            return Ok(Form::integer(0));
        }
        let mut out = match exponent.as_integer() {
            Some(k) => Form::number(self.rational_power(&a.coefficient, k)?),
            None => self.number_power(&a.coefficient, exponent)?,
        };
        for (atom, e) in &a.powers {
            let e = self.exponent_product(e, exponent)?;
            out = self.mul(&out, &Form { coefficient: Rational::ONE, powers: vec![(*atom, e)] })?;
        }
        Ok(out)
    }

    /// c^E for c > 0 and E not an integer: through the primes of c.
    fn number_power(&mut self, c: &Rational, exponent: &Exponent) -> Result<Form> {
        let mut out = Form::integer(1);
        let minus = self.exponent_negated(exponent);
        for (value, exponent) in [(c.numerator_ref().clone(), exponent), (c.denominator_ref().clone(), &minus)] {
            for (prime, k) in factor_number(value) {
                let atom = self.intern(Atom::Prime(prime));
                let e = self.exponent_product(&Exponent::integer(k), exponent)?;
                let power = self.normalise(Form { coefficient: Rational::ONE, powers: vec![(atom, e)] })?;
                out = self.mul(&out, &power)?;
            }
        }
        Ok(out)
    }

    /// The sum of forms.
    pub fn add(&mut self, forms: &[Form]) -> Result<Form> {
        let forms: Vec<&Form> = forms.iter().filter(|f| !f.is_zero()).collect();
        match forms.as_slice() {
            [] => return Ok(Form::integer(0)),
            [one] => return Ok((*one).clone()),
            _ => {}
        }
        if forms.iter().all(|f| f.powers == forms[0].powers) {
            let mut coefficient = Rational::ZERO;
            for form in &forms {
                coefficient += &form.coefficient;
                if coefficient.significant_bits() > COEFFICIENT_BITS {
                    return Err(Limit("digits"));
                }
            }
            return Ok(if coefficient == 0 {
                Form::integer(0)
            } else {
                Form { coefficient, powers: forms[0].powers.clone() }
            });
        }
        let mut atoms: Vec<AtomId> = forms.iter().flat_map(|f| f.powers.iter().map(|p| p.0)).collect();
        atoms.sort_unstable();
        atoms.dedup();
        let mut common: Monomial = Vec::new();
        for atom in atoms {
            let exponents: Vec<Exponent> = forms.iter().map(|f| exponent_in(&f.powers, atom)).collect();
            let least = self.common_exponent(atom, &exponents)?;
            if !least.is_zero() {
                common.push((atom, least));
            }
        }
        let mut minus = Vec::with_capacity(common.len());
        for (atom, exponent) in &common {
            minus.push((*atom, self.exponent_negated(exponent)));
        }
        let mut terms = HashMap::default();
        for form in forms {
            let rest = self.monomial_product(&form.powers, &minus)?;
            self.accumulate(&mut terms, rest, &form.coefficient)?;
        }
        let poly = self.collect(terms)?;
        let sum = self.poly_form(poly)?;
        let mut total = self.mul(&sum, &Form { coefficient: Rational::ONE, powers: common })?;
        self.cancel(&mut total)?;
        Ok(total)
    }

    /// The largest power of an atom that all terms share.
    fn common_exponent(&mut self, atom: AtomId, exponents: &[Exponent]) -> Result<Exponent> {
        if exponents.iter().all(|e| *e == exponents[0]) {
            return Ok(exponents[0].clone());
        }
        if matches!(*self.atom(atom), Atom::Sum(_)) {
            let mut least = i64::MAX;
            for exponent in exponents {
                least = least.min(self.split_integer(exponent)?.1);
            }
            // All in one class modulo integers: the least of them; else only the integer part.
            let mut smallest = exponents[0].clone();
            for exponent in &exponents[1..] {
                let minus = self.exponent_negated(&smallest);
                let difference = self.exponent_sum(exponent, &minus)?;
                match difference.as_integer() {
                    Some(d) if d < 0 => smallest = exponent.clone(),
                    Some(_) => {}
                    None => return Ok(Exponent::integer(least)),
                }
            }
            return Ok(smallest);
        }
        let mut smallest = exponents[0].clone();
        for exponent in &exponents[1..] {
            if self.exponent_order(exponent, &smallest)? == Ordering::Less {
                smallest = exponent.clone();
            }
        }
        Ok(smallest)
    }

    /// The form of a sum: content, common monomial and a primitive rest.
    pub fn poly_form(&mut self, poly: Poly) -> Result<Form> {
        if poly.terms.is_empty() {
            return Ok(Form::integer(0));
        }
        if poly.terms.len() == 1 {
            let (powers, coefficient) = poly.terms.into_iter().next().unwrap_or_default();
            return self.normalise(Form { coefficient, powers });
        }
        let mut atoms: Vec<AtomId> = poly.terms.iter().flat_map(|t| t.0.iter().map(|p| p.0)).collect();
        atoms.sort_unstable();
        atoms.dedup();
        let mut common: Monomial = Vec::new();
        for atom in atoms {
            let kind = self.atom(atom);
            let exponents: Vec<Exponent> = poly.terms.iter().map(|t| exponent_in(&t.0, atom)).collect();
            if matches!(*kind, Atom::Sum(_) | Atom::Prime(_)) && !exponents.iter().all(|e| *e == exponents[0]) {
                continue;
            }
            let least = self.common_exponent(atom, &exponents)?;
            if !least.is_zero() {
                common.push((atom, least));
            }
        }
        let mut minus = Vec::with_capacity(common.len());
        for (atom, exponent) in &common {
            minus.push((*atom, self.exponent_negated(exponent)));
        }
        let mut content = content_of(&poly);
        if poly.terms[0].1 < 0 {
            content = -content;
        }
        let mut terms = Vec::with_capacity(poly.terms.len());
        for (monomial, c) in &poly.terms {
            terms.push((self.monomial_product(monomial, &minus)?, c / &content));
        }
        let atom = self.intern(Atom::Sum(Rc::new(Poly { terms })));
        let powers = self.monomial_product(&common, &vec![(atom, Exponent::integer(1))])?;
        self.normalise(Form { coefficient: content, powers })
    }

    /// Cancels sums in the denominator that divide sums in the numerator.
    fn cancel(&mut self, form: &mut Form) -> Result<()> {
        for _ in 0..64 {
            let mut change = None;
            'search: for (below, e) in &form.powers {
                if e.as_integer().is_none_or(|k| k >= 0) {
                    continue;
                }
                let Some(q) = self.sum(*below) else { continue };
                for (above, f) in &form.powers {
                    if f.as_integer().is_none_or(|k| k <= 0) {
                        continue;
                    }
                    let Some(p) = self.sum(*above) else { continue };
                    if p.terms.len() > 400 || p.terms.len() < 2 || q.terms.len() > p.terms.len() * 4 {
                        continue;
                    }
                    if let Some(quotient) = self.atom_quotient(*above, *below)? {
                        change = Some((*above, *below, quotient));
                        break 'search;
                    }
                }
            }
            let Some((above, below, quotient)) = change else { return Ok(()) };
            let exchange = Form {
                coefficient: Rational::ONE,
                powers: if above < below {
                    vec![(above, Exponent::integer(-1)), (below, Exponent::integer(1))]
                } else {
                    vec![(below, Exponent::integer(1)), (above, Exponent::integer(-1))]
                },
            };
            let rest = self.mul(form, &exchange)?;
            *form = self.mul(&rest, &quotient)?;
        }
        Ok(())
    }

    /// a − b.
    pub fn sub(&mut self, a: &Form, b: &Form) -> Result<Form> {
        self.add(&[a.clone(), b.negated()])
    }

    /// The form as summands: sums with a positive integer exponent are multiplied out.
    pub fn summands(&mut self, form: &Form) -> Result<Vec<Form>> {
        for (place, (atom, exponent)) in form.powers.iter().enumerate() {
            let (Some(k), Some(poly)) = (exponent.as_integer(), self.sum(*atom)) else { continue };
            if k < 1 {
                continue;
            }
            let mut rest = form.clone();
            rest.powers.remove(place);
            let power = self.poly_power(&poly, u32::try_from(k).map_err(|_| Limit("degree"))?)?;
            let mut out = Vec::new();
            for (monomial, c) in &power.terms {
                let term = self.mul(&rest, &Form { coefficient: c.clone(), powers: monomial.clone() })?;
                out.extend(self.summands(&term)?);
            }
            return Ok(out);
        }
        Ok(vec![form.clone()])
    }

    /// Whether the form mentions an atom for which `test` holds, at any depth.
    pub fn mentions(&self, form: &Form, test: &dyn Fn(AtomId) -> bool) -> bool {
        form.powers.iter().any(|(atom, exponent)| {
            self.atom_mentions(*atom, test)
                || match exponent {
                    Exponent::Number(_) => false,
                    Exponent::Symbolic(form) => self.mentions(form, test),
                }
        })
    }

    /// Whether the atom is, or is built from, one for which `test` holds.
    pub fn atom_mentions(&self, atom: AtomId, test: &dyn Fn(AtomId) -> bool) -> bool {
        if test(atom) {
            return true;
        }
        match &*self.atoms[atom as usize] {
            Atom::Variable(_) | Atom::Prime(_) | Atom::Euler => false,
            Atom::Member(_, index) => self.mentions(index, test),
            Atom::Sum(poly) => poly.terms.iter().any(|(monomial, _)| {
                self.mentions(&Form { coefficient: Rational::ONE, powers: monomial.clone() }, test)
            }),
            Atom::Logarithm(inner) => self.atom_mentions(*inner, test),
            Atom::SumOver(over) | Atom::ProductOver(over) => {
                self.mentions(&over.body, test) || self.mentions(&over.from, test) || self.mentions(&over.to, test)
            }
        }
    }

    /// The derivative by a variable: (∏ aᵢ^Eᵢ)′ = ∏ aᵢ^Eᵢ · Σ (Eᵢ aᵢ′/aᵢ + Eᵢ′ ln aᵢ). `None` where an
    /// index or a bound of a sum depends on the variable.
    pub fn derivative(&mut self, form: &Form, variable: AtomId) -> Result<Option<Form>> {
        let mut sum = Vec::new();
        for (atom, exponent) in &form.powers {
            if let Exponent::Symbolic(e) = exponent
                && self.mentions(e, &|a| a == variable)
            {
                // (a^E)' = a^E·(E'·ln a + E·a'/a); a symbolic exponent has a positive base.
                let Some(change) = self.derivative(e, variable)? else { return Ok(None) };
                let change = if matches!(*self.atom(*atom), Atom::Euler) {
                    change
                } else {
                    let logarithm = Form::atom(self.intern(Atom::Logarithm(*atom)));
                    self.mul(&change, &logarithm)?
                };
                sum.push(self.mul(form, &change)?);
            }
            let Some(inner) = self.atom_derivative(*atom, variable)? else { return Ok(None) };
            if inner.is_zero() {
                continue;
            }
            let scaled = self.mul(&inner, &exponent.form())?;
            let lowered = Form { coefficient: Rational::ONE, powers: vec![(*atom, Exponent::integer(-1))] };
            let rest = self.mul(form, &lowered)?;
            sum.push(self.mul(&rest, &scaled)?);
        }
        Ok(Some(self.add(&sum)?))
    }

    fn atom_derivative(&mut self, atom: AtomId, variable: AtomId) -> Result<Option<Form>> {
        if atom == variable {
            return Ok(Some(Form::integer(1)));
        }
        if !self.atom_mentions(atom, &|a| a == variable) {
            return Ok(Some(Form::integer(0)));
        }
        match &*self.atom(atom) {
            Atom::Sum(poly) => {
                let mut sum = Vec::new();
                for (monomial, c) in &poly.terms {
                    let term = Form { coefficient: c.clone(), powers: monomial.clone() };
                    match self.derivative(&term, variable)? {
                        Some(d) => sum.push(d),
                        None => return Ok(None),
                    }
                }
                Ok(Some(self.add(&sum)?))
            }
            Atom::Logarithm(inner) => {
                let Some(d) = self.atom_derivative(*inner, variable)? else { return Ok(None) };
                Ok(Some(self.div(&d, &Form::atom(*inner))?))
            }
            _ => Ok(None),
        }
    }
}

/// The exponent of an atom in a monomial, 0 where it is absent.
pub fn exponent_in(monomial: &Monomial, atom: AtomId) -> Exponent {
    match monomial.binary_search_by_key(&atom, |p| p.0) {
        Ok(place) => monomial[place].1.clone(),
        Err(_) => Exponent::integer(0),
    }
}

/// The positive rational c such that p / c has coprime integer coefficients.
fn content_of(poly: &Poly) -> Rational {
    use malachite::base::num::arithmetic::traits::Gcd;
    let mut top = Natural::ZERO;
    let mut bottom = Natural::ONE;
    for (_, c) in &poly.terms {
        top = top.gcd(c.numerator_ref().clone());
        bottom = bottom.lcm(c.denominator_ref().clone());
    }
    Rational::from_naturals(top, bottom)
}

/// Primes below 10⁴ with multiplicities; what remains is left whole (as one more base).
pub fn factor_number(mut value: Natural) -> Vec<(Natural, i64)> {
    use malachite::base::num::arithmetic::traits::DivisibleBy;
    let mut out = Vec::new();
    let mut p = 2u32;
    while p < 10_000 && value > 1 {
        let prime = Natural::from(p);
        if &prime * &prime > value {
            break;
        }
        let mut k = 0;
        while (&value).divisible_by(&prime) {
            value /= &prime;
            k += 1;
        }
        if k > 0 {
            out.push((prime, k));
        }
        p += 1;
    }
    if value > 1 {
        out.push((value, 1));
    }
    out
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Σ c·a^(i/6)·b^(j/6), and 1 on top so that it is a sum of at least two terms.
    fn sum(ring: &mut Ring, terms: &[(i64, i64, i64)]) -> Form {
        let (a, b) = (ring.variable("a"), ring.variable("b"));
        let mut forms = Vec::new();
        for (c, i, j) in terms {
            let sixths = |k: &i64| Exponent::Number(Rational::from_signeds(*k, 6));
            let (x, y) = (ring.power(&a, &sixths(i)).unwrap(), ring.power(&b, &sixths(j)).unwrap());
            let term = ring.mul(&x, &y).unwrap();
            forms.push(ring.mul(&Form::integer(*c), &term).unwrap());
        }
        ring.add(&forms).unwrap()
    }

    /// The atom of a form that is a primitive sum and nothing else.
    fn only(ring: &Ring, form: &Form) -> Option<AtomId> {
        match form.powers.as_slice() {
            [(atom, e)] if e.as_integer() == Some(1) && ring.sum(*atom).is_some() => Some(*atom),
            _ => None,
        }
    }

    fn terms(most: usize) -> impl Strategy<Value = Vec<(i64, i64, i64)>> {
        prop::collection::vec((prop::sample::select(vec![-2i64, -1, 1, 1, 3]), 0i64..9, 0i64..9), 2..most)
    }

    proptest! {
        #[test]
        fn a_product_is_divided_by_its_factor_and_nothing_else(
            sign in prop::sample::select(vec![-1i64, 1]), (i, j) in (1i64..7, 0i64..7), binomial in any::<bool>(),
            other in terms(4), cofactor in terms(6), (place, more) in (0usize..5, -2i64..3),
        ) {
            let mut ring = Ring::default();
            let divisor = if binomial { vec![(1, i, 0), (sign, 0, j)] } else { other };
            // The product term by term, and then with one coefficient changed.
            let mut product: Vec<(i64, i64, i64)> = Vec::new();
            for (c, k, l) in &cofactor {
                product.extend(divisor.iter().map(|(d, x, y)| (c * d, k + x, l + y)));
            }
            let (q, whole) = (sum(&mut ring, &divisor), sum(&mut ring, &product));
            let changed = product.len().min(place);
            if let Some(term) = product.get_mut(changed) {
                term.0 += more;
            }
            let p = sum(&mut ring, &product);
            let Some(below) = only(&ring, &q) else { return Ok(()) };
            if let Some(above) = only(&ring, &whole) {
                prop_assert!(above == below || ring.atom_quotient(above, below).unwrap().is_some());
            }
            if let Some(above) = only(&ring, &p)
                && let Some(quotient) = ring.atom_quotient(above, below).unwrap()
            {
                let back = ring.mul(&quotient, &Form::atom(below)).unwrap();
                let difference = ring.sub(&Form::atom(above), &back).unwrap();
                prop_assert!(difference.is_zero());
                // A monomial is no multiple of a sum: one changed coefficient spoils the division.
                prop_assert!(more == 0 || changed >= product.len());
            }
        }
    }
}
