//! Quadratic invariants of linear recurrences with constant coefficients: T(n)^2 − (x^2 − 1)·U(n)^2 = 1 where T(k + 1) = x·T(k) +
//! (x^2 − 1)·U(k) and U(k + 1) = T(k) + x·U(k).
//!
//! Method: for s(k + 1) = A·s(k) with a 2×2 matrix A, the determinant of the columns s and A·s is a quadratic form Q in s, and
//! Q(s(k + 1)) = det(A·s, A·A·s) = det A·Q(s(k)). So Q(s(n)) = (det A)^n·Q(s(0)), which an induction shows. A recurrence
//! u(k + 2) = a·u(k + 1) + b·u(k) is one for the pair of u(k + 1) and u(k); its invariant is that of Cassini.
//!
//! Limits: two sequences that look at themselves and each other, or one that looks two members back.

use super::comparison::single;
use super::facts::minus;
use super::instances::members_in;
use super::letters::{product, total, whole_power};
use super::limits::plus;
use super::slopes::put_in;
use super::sums::replace;
use super::{Fail, Prover};
use crate::certificate::Label;
use crate::claim::syntax::*;
use crate::kernel::key;
use crate::kernel::statement::{apply, compare, name, numeral, power, prop};

/// The most systems that are tried for one goal.
const SYSTEMS: usize = 3;

/// A recurrence of two numbers: what each is at k, and the next of each.
struct Pair {
    index: String,
    at: [Expr; 2],
    next: [Expr; 2],
}

impl Prover {
    /// Shows a comparison by the quadratic invariants of the recurrences of its members.
    pub(super) fn by_invariants(&mut self, goal: &Prop) -> Result<Label, Fail> {
        let no = || Fail::No("a linear recurrence of two numbers");
        single(goal)?;
        if self.inductions > 0 || self.splits > 0 {
            return Err(no());
        }
        let mut sides = Vec::new();
        super::goals::sides_in(goal, &mut sides);
        let members = members_met(&sides);
        if members.is_empty() {
            return Err(no());
        }
        let is_met = |pair: &Pair| {
            pair.at
                .iter()
                .any(|e| matches!(&e.kind, ExprKind::Apply(u, _) if members.iter().any(|(v, _)| *v == u.text)))
        };
        let pairs: Vec<Pair> = self.recurrences_of_pairs().into_iter().filter(is_met).take(SYSTEMS).collect();
        let mut any = false;
        for pair in pairs {
            let Ok(every) = self.on_its_own(|c| c.invariant(&pair)) else { continue };
            for (_, at) in &members {
                any |= self.instance(&every, at).is_ok();
            }
        }
        if !any {
            return Err(no());
        }
        // Not once more: an invariant that is known is none that is found.
        self.comparison_or_parts(goal)
    }

    /// The recurrences of two numbers that facts state for all natural numbers.
    fn recurrences_of_pairs(&self) -> Vec<Pair> {
        let mut steps: Vec<(String, u32, String, Expr)> = Vec::new();
        for (_, fact) in self.facts() {
            let PropKind::ForAll(bindings, body) = &fact.kind else { continue };
            let [binding] = bindings.as_slice() else { continue };
            let ([(k, None)], true, true) = (binding.names.as_slice(), binding.natural, binding.constraints.is_empty())
            else {
                continue;
            };
            let Some((left, Relation::Equal, right)) = body.single() else { continue };
            let ExprKind::Apply(u, at) = &left.kind else { continue };
            let Some((n, later)) = at.first().and_then(shifted) else { continue };
            if n != k.text {
                continue;
            }
            steps.push((u.text.clone(), later, k.text.clone(), right.clone()));
        }
        let mut out = Vec::new();
        for (place, (u, later, k, right)) in steps.iter().enumerate() {
            let here = apply(u, name(k));
            let next = apply(u, plus(&name(k), numeral(1)));
            match later {
                2 => out.push(Pair { index: k.clone(), at: [next.clone(), here], next: [right.clone(), next] }),
                1 => {
                    for (v, other, l, also) in &steps[place + 1..] {
                        if let (1, Ok(also)) = (other, put_in(also, l, &name(k))) {
                            let at = [here.clone(), apply(v, name(k))];
                            out.push(Pair { index: k.clone(), at, next: [right.clone(), also] });
                        }
                    }
                }
                _ => {}
            }
        }
        out
    }

    /// The four coefficients of a linear recurrence of two numbers, which hold neither the index k nor members at it.
    fn matrix(&mut self, k: &str, at: &[Expr; 2], next: &[Expr; 2]) -> Result<Vec<Expr>, Fail> {
        let no = || Fail::No("constant coefficients");
        let own = |e: &Expr, values: [u32; 2]| {
            let mut e = e.clone();
            at.iter().zip(values).for_each(|(of, value)| replace(&mut e, of, &numeral(value)));
            e
        };
        let mut matrix = Vec::new();
        self.where_it_is_bound(index_of(k), |c| {
            for e in next {
                let row = [own(e, [1, 0]), own(e, [0, 1])].map(|e| c.simplified(&e).unwrap_or(e));
                let terms = row.iter().zip(at).map(|(c, x)| (Sign::Plus, product(vec![c.clone(), x.clone()])));
                let is_linear = c.is_zero(&minus(e, &total(terms.collect())));
                if members_met(&row).is_empty() && row.iter().all(|e| !super::limits::holds(e, k)) && is_linear {
                    matrix.extend(row);
                }
            }
        });
        if matrix.len() == 4 { Ok(matrix) } else { Err(no()) }
    }

    /// A form without the factors that hold no member, which may be 0.
    fn without_common_factors(&mut self, k: &str, form: &Expr) -> Option<Expr> {
        let mut out = None;
        self.where_it_is_bound(index_of(k), |c| {
            let Some(reading) = c.read(form, false) else { return };
            let own = reading.factors.iter().map(|f| whole_power(c.letters.written(&f.poly), f.power));
            let own: Vec<Expr> = own.filter(|e| super::limits::holds(e, k)).collect();
            out = Some(product(own)).filter(|_| reading.number != 0);
        });
        out
    }

    /// The invariant of a recurrence, for all natural numbers.
    fn invariant(&mut self, pair: &Pair) -> Result<Label, Fail> {
        let no = || Fail::No("a linear recurrence");
        let k = self.fresh("k");
        let here = |e: &Expr| put_in(e, &pair.index, &name(&k));
        let at = [here(&pair.at[0])?, here(&pair.at[1])?];
        let next = [here(&pair.next[0])?, here(&pair.next[1])?];
        let matrix = self.matrix(&k, &at, &next)?;
        let [p, q, r, w] = matrix.as_slice() else { return Err(no()) };
        // det(s, A·s) = r·x² + (w − p)·x·y − q·y².
        let form = total(vec![
            (Sign::Plus, product(vec![r.clone(), whole_power(at[0].clone(), 2)])),
            (Sign::Plus, product(vec![minus(w, p), at[0].clone(), at[1].clone()])),
            (Sign::Minus, product(vec![q.clone(), whole_power(at[1].clone(), 2)])),
        ]);
        let factor = minus(&product(vec![p.clone(), w.clone()]), &product(vec![q.clone(), r.clone()]));
        let factor = self.simplified(&factor).unwrap_or(factor);
        let form = self.without_common_factors(&k, &form).ok_or_else(no)?;
        let first = put_in(&form, &k, &numeral(0))?;
        let is_kept = self.quietly(&compare(factor.clone(), Relation::Equal, numeral(1))).is_ok();
        let value = if is_kept { first } else { product(vec![power(&factor, &name(&k)), first]) };
        let body = compare(form, Relation::Equal, value);
        let every = prop(PropKind::ForAll(vec![index_of(&k)], Box::new(body)));
        if self.known(&every).is_some() {
            return Err(Fail::No("a new invariant"));
        }
        self.all_by_induction(&every, 3)
    }
}

/// A natural number.
fn index_of(k: &str) -> Binding {
    Binding::of(Name::new(k), true, Vec::new())
}

/// The members of families and sequences at an index that is no number, each once; that of u(n + 1) is n.
pub(super) fn members_met(exprs: &[Expr]) -> Vec<(String, Expr)> {
    let mut all = Vec::new();
    exprs.iter().for_each(|e| members_in(e, &mut all));
    let mut out: Vec<(String, Expr)> = Vec::new();
    for (u, at) in all.into_iter().filter(|(_, at)| !matches!(at.kind, ExprKind::Number(_))) {
        let index = shifted(&at).map_or_else(|| at.clone(), |(n, _)| name(n));
        if !out.iter().any(|(v, old)| *v == u && key::expr(old) == key::expr(&index)) {
            out.push((u, index));
        }
    }
    out
}

/// A name and by how much an index is later.
fn shifted(index: &Expr) -> Option<(&str, u32)> {
    let ExprKind::Sum(list) = &index.kind else { return None };
    match list.as_slice() {
        [(Sign::Plus, Expr { kind: ExprKind::Name(n), .. }), (Sign::Plus, later)] => {
            Some((n, super::letters::natural(later)?))
        }
        _ => None,
    }
}
