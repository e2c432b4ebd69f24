//! Powers of a matrix to a variable exponent: `M^n` becomes the matrix of `M_11(n)`, `M_12(n)`, ….
//!
//! Contract: these are families with M^0 = 1 and M^(k + 1) = M·M^k as hypotheses. Such families exist and are determined wherever the
//! entries of M have values, so the claim says the same. Where the entries may lack a value at a point that the claim is
//! about, a hypothesis that holds them would leave that point out; such matrices are refused.

use super::abbreviation::Writer;
use super::matrix::{Rows, at, numeral};
use super::syntax::*;
use super::total::Values;
use super::walk;
use std::collections::BTreeSet;

/// The most rows of a matrix to a variable power: an entry's place is written with two digits.
const ROWS_LIMIT: usize = 9;

/// The powers of matrices that a claim speaks of.
pub(super) struct Powers {
    /// Names that stand for several values in the claim.
    pub(super) bound: BTreeSet<String>,
    /// What the items so far tell of names.
    pub(super) values: Values,
    /// The entries of each matrix with the names of the families of its powers.
    pub(super) known: Vec<(Rows, Vec<Vec<Name>>)>,
    /// Declarations and hypotheses that stand before the next item.
    pub(super) open: Vec<Item>,
}

impl Writer<'_> {
    /// `base^exponent` for an exponent that is no numeral, as a matrix of members.
    pub(super) fn variable_power(&mut self, base: &Expr, exponent: &Expr, span: Span) -> Option<ExprKind> {
        let rows = match self.matrices.square(base) {
            Ok(rows) => rows,
            Err(unfit) => {
                self.unfit("a power", unfit, span);
                return None;
            }
        };
        let known = self.powers.known.iter().find(|known| known.0 == rows).map(|known| known.1.clone());
        let families = match known {
            Some(families) => families,
            None => self.families(base, rows, span)?,
        };
        let member = |name: &Name| at(span, ExprKind::Apply(name.clone(), vec![exponent.clone()]));
        Some(ExprKind::Matrix(families.iter().map(|row| row.iter().map(member).collect()).collect()))
    }

    /// Declares families for the entries of the powers of a matrix.
    fn families(&mut self, base: &Expr, rows: Rows, span: Span) -> Option<Vec<Vec<Name>>> {
        let count = rows.len();
        if count > ROWS_LIMIT {
            self.limit("rows of a matrix to a variable power", ROWS_LIMIT, span);
            return None;
        }
        let mut inside = BTreeSet::new();
        rows.iter().flatten().for_each(|entry| walk::names_in(entry, &mut inside));
        if let Some(bound) = inside.intersection(&self.powers.bound).next() {
            let message = format!("a matrix to a variable power depends on the bound variable {bound}");
            self.fault(&message, "declare what its entries are made of under `given`", span);
            return None;
        }
        if !rows.iter().flatten().all(|entry| self.powers.values.exist_for(entry)) {
            let help = "declare the names in its divisors positive, or give an entry a name: `given q real` with \
                        `assume q*m = a`";
            self.fault("the entries of a matrix to a variable power must have values everywhere", help, span);
            return None;
        }
        let size: usize = rows.iter().flatten().map(walk::nodes_in).sum();
        if !self.room((size + 20 * count).saturating_mul(count), span) {
            return None;
        }
        let stems = match &base.kind {
            ExprKind::Name(name) => vec![name.clone()],
            _ => ["P", "Q", "R", "S"].map(str::to_string).to_vec(),
        };
        let is_free =
            |stem: &String| (1..=count).all(|i| (1..=count).all(|j| self.fresh.is_free(&format!("{stem}_{i}{j}"))));
        let later = |k: u32| stems.iter().map(move |stem| format!("{stem}{k}"));
        let stem = stems.iter().cloned().chain((2..).flat_map(later)).find(is_free)?;
        let name = |text: String| Name { text, span };
        let families: Vec<Vec<Name>> =
            (1..=count).map(|i| (1..=count).map(|j| name(format!("{stem}_{i}{j}"))).collect()).collect();
        families.iter().flatten().for_each(|n| self.fresh.take(&n.text));
        self.names.extend(families.iter().flatten().map(|n| n.text.clone()));
        let index = self.index(&rows.iter().flatten().collect::<Vec<_>>(), span);
        let k = at(span, ExprKind::Name(index.text.clone()));
        let next = at(span, ExprKind::Sum(vec![(Sign::Plus, k.clone()), (Sign::Plus, numeral(span, 1))]));
        let member = |family: &Name, index: Expr| at(span, ExprKind::Apply(family.clone(), vec![index]));
        let says = |a: Expr, b: Expr| Prop { kind: PropKind::Compare(vec![a, b], vec![Relation::Equal]), span };
        let binding = |names: Vec<(Name, Option<Name>)>, natural: bool| Binding::new(names, natural, Vec::new(), span);
        let declared = families.iter().flatten().map(|family| (family.clone(), Some(index.clone()))).collect();
        self.powers.open.push(Item::Given(vec![binding(declared, false)]));
        for (i, row) in families.iter().enumerate() {
            for (j, family) in row.iter().enumerate() {
                let first = says(member(family, numeral(span, 0)), numeral(span, u32::from(i == j)));
                let column = families.iter().map(|row| member(&row[j], k.clone()));
                let step = says(member(family, next.clone()), sum_of_products(rows[i].iter().zip(column), span));
                let every = PropKind::ForAll(vec![binding(vec![(index.clone(), None)], true)], Box::new(step));
                let props = [first, Prop { kind: every, span }];
                self.powers.open.extend(props.map(|prop| Item::Assume { label: None, prop }));
            }
        }
        self.powers.known.push((rows, families.clone()));
        Some(families)
    }
}

/// a·x + b·y + …, without what is 0 and with no factor 1.
fn sum_of_products<'a>(parts: impl Iterator<Item = (&'a Expr, Expr)>, span: Span) -> Expr {
    let is = |e: &Expr, k: &str| matches!(&e.kind, ExprKind::Number(text) if text == k);
    let mut terms: Vec<(Sign, Expr)> = Vec::new();
    for (a, x) in parts.filter(|(a, _)| !is(a, "0")) {
        let product = vec![(Factor::Times, a.clone()), (Factor::Times, x.clone())];
        terms.push((Sign::Plus, if is(a, "1") { x } else { at(span, ExprKind::Product(product)) }));
    }
    match (terms.len(), terms.pop()) {
        (_, None) => numeral(span, 0),
        (1, Some((_, only))) => only,
        (_, last) => at(span, ExprKind::Sum(terms.into_iter().chain(last).collect())),
    }
}
