//! A polynomial modulo the prime that terms are taken from and added to many times.
//!
//! Method: geometric buckets (Yan, "The geobucket data structure for polynomials", Journal of Symbolic Computation 25, 1998). Bucket k
//! holds at most 4^(k+1) terms in their order; what is added goes into the bucket of its length, and a bucket that is too full
//! goes into the next. Each term is moved at most once for each bucket, so adding n polynomials of t terms costs
//! O(n·t·log(n·t)), where one ordered list would cost O(n²·t).

use super::residue::add;
use std::cmp::Ordering;

/// Terms by monomial, each with its residue; the largest monomial is last in each bucket.
pub(super) struct Geobucket<M> {
    buckets: Vec<Vec<(M, u64)>>,
}

impl<M: Copy + Ord> Geobucket<M> {
    /// The polynomial 0.
    pub(super) fn new() -> Geobucket<M> {
        Geobucket { buckets: Vec::new() }
    }

    /// Adds terms, the smallest monomial first, each monomial once and no residue 0.
    pub(super) fn add(&mut self, mut terms: Vec<(M, u64)>) {
        let mut place = 0;
        loop {
            while terms.len() > capacity(place) {
                place += 1;
            }
            if self.buckets.len() <= place {
                self.buckets.resize_with(place + 1, Vec::new);
            }
            let old = std::mem::take(&mut self.buckets[place]);
            terms = if old.is_empty() { terms } else { sum(&old, &terms) };
            if terms.len() <= capacity(place) {
                self.buckets[place] = terms;
                return;
            }
        }
    }

    /// Takes the leading term away; nothing of 0.
    pub(super) fn pop(&mut self) -> Option<(M, u64)> {
        loop {
            let top = self.buckets.iter().filter_map(|b| b.last()).map(|t| t.0).max()?;
            let mut total = 0;
            for bucket in &mut self.buckets {
                if let Some((_, c)) = bucket.pop_if(|t| t.0 == top) {
                    total = add(total, c);
                }
            }
            if total != 0 {
                return Some((top, total));
            }
        }
    }

    /// All terms, the largest monomial first.
    pub(super) fn into_terms(mut self) -> Vec<(M, u64)> {
        std::iter::from_fn(|| self.pop()).collect()
    }
}

fn capacity(place: usize) -> usize {
    4 << (2 * place)
}

/// The sum of two lists of terms, both with the smallest monomial first.
fn sum<M: Copy + Ord>(a: &[(M, u64)], b: &[(M, u64)]) -> Vec<(M, u64)> {
    let mut out = Vec::with_capacity(a.len() + b.len());
    let (mut i, mut j) = (0, 0);
    while let (Some(x), Some(y)) = (a.get(i), b.get(j)) {
        match x.0.cmp(&y.0) {
            Ordering::Less => {
                out.push(*x);
                i += 1;
            }
            Ordering::Greater => {
                out.push(*y);
                j += 1;
            }
            Ordering::Equal => {
                let c = add(x.1, y.1);
                if c != 0 {
                    out.push((x.0, c));
                }
                (i, j) = (i + 1, j + 1);
            }
        }
    }
    out.extend_from_slice(&a[i..]);
    out.extend_from_slice(&b[j..]);
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::residue::negate;
    use std::collections::BTreeMap;

    #[test]
    fn a_bucket_holds_the_same_as_a_map() {
        let (mut bucket, mut map) = (Geobucket::new(), BTreeMap::new());
        for k in 0u32..200 {
            let terms: Vec<(u32, u64)> = (0..k % 37).map(|m| (m * 3 + k % 5, u64::from(k) + 1)).collect();
            for (m, c) in &terms {
                let entry = map.entry(*m).or_insert(0);
                *entry = add(*entry, *c);
            }
            bucket.add(terms);
        }
        assert_eq!(bucket.into_terms(), map.into_iter().rev().collect::<Vec<_>>());
    }

    #[test]
    fn what_cancels_is_gone() {
        let mut bucket = Geobucket::new();
        bucket.add(vec![(1, 5), (2, 7)]);
        bucket.add(vec![(1, 6), (2, negate(7))]);
        assert_eq!(bucket.pop(), Some((1, 11)));
        assert_eq!(bucket.pop(), None);
    }
}
