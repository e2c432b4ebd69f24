//! Orders of powers of two numbers with one natural exponent, in the step of an induction: (a - b)·(a^k - b^k) >= 0 for a, b >= 0, so
//! that ((a + b)/2)^k <= (a^k + b^k)/2 passes on to k + 1.
//!
//! Limits: [`PAIRS`].

use super::facts::minus;
use super::letters::product;
use super::limits::holds;
use super::{Fail, Prover, implies};
use crate::certificate::{Label, Rule, Term};
use crate::claim::syntax::*;
use crate::claim::walk::parts;
use crate::kernel::key;
use crate::kernel::statement::{compare, name, numeral, power};

/// The most pairs of bases.
const PAIRS: usize = 3;

impl Prover {
    /// In the step of an induction, by how the powers of two bases in the goal are ordered.
    pub(super) fn by_powers_of_two_bases(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("powers of two bases in the step of an induction");
        if self.inductions == 0 {
            return Err(no());
        }
        let k = self.naturals.last().cloned().ok_or_else(no)?;
        let (mut sides, mut bases) = (Vec::new(), Vec::new());
        super::goals::sides_in(goal, &mut sides);
        sides.iter().for_each(|e| bases_of(e, &k, &mut bases));
        let mut any = false;
        let pairs = (0..bases.len()).flat_map(|i| (i + 1..bases.len()).map(move |j| (i, j)));
        for (i, j) in pairs.take(PAIRS) {
            if let (Some(a), Some(b)) = (bases.get(i), bases.get(j)) {
                any |= self.attempt(|c| c.ordered_powers(a, b, &k)).is_ok();
            }
        }
        if any { self.without_cases(goal) } else { Err(no()) }
    }

    /// (a - b)·(a^k - b^k) >= 0, as a fact.
    fn ordered_powers(&mut self, a: &Expr, b: &Expr, k: &str) -> Result<Label, Fail> {
        let to_k = |e: &Expr| power(e, &name(k));
        let both = product(vec![minus(a, b), minus(&to_k(a), &to_k(b))]);
        let shown = compare(both, Relation::GreaterEqual, numeral(0));
        if self.known(&shown).is_some() {
            return Err(Fail::No("a new fact"));
        }
        let (above, below) = (compare(a.clone(), Relation::GreaterEqual, b.clone()), compare(a.clone(), Relation::Less, b.clone()));
        let mut cases = Vec::new();
        for case in [above, below] {
            let case = self.block(&implies(&case, &shown), |c, block| {
                let mut from = format!("{block}s");
                let (mut large, mut small) = (a, b);
                if matches!(case.single(), Some((_, Relation::Less, _))) {
                    (large, small) = (b, a);
                    let weak = compare(b.clone(), Relation::GreaterEqual, a.clone());
                    from = c.combination(weak, vec![Term { facts: vec![from], factor: crate::refute::literal::literal(&malachite::Rational::from(-1)) }])?;
                }
                let powers = compare(to_k(large), Relation::GreaterEqual, to_k(small));
                let powers = c.emit(Rule::Monotone { from: from.clone() }, powers)?;
                c.combination(shown.clone(), vec![Term { facts: vec![from, powers], factor: numeral(1) }])
            })?;
            cases.push(case);
        }
        let label = self.emit(Rule::Logic { from: cases }, shown.clone())?;
        self.take_in(&label, &shown)?;
        Ok(label)
    }
}

/// The bases of powers whose exponents hold a name that the bases do not, each once.
fn bases_of(e: &Expr, k: &str, out: &mut Vec<Expr>) {
    if let ExprKind::Power(base, exponent) = &e.kind
        && holds(exponent, k)
        && !holds(base, k)
        && matches!(base.kind, ExprKind::Name(_))
        && !out.iter().any(|old| key::expr(old) == key::expr(base))
    {
        out.push((**base).clone());
    }
    parts(e, &mut |part| bases_of(part, k, out));
}
