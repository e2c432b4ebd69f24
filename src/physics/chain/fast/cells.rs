//! eta of many cells at once: cells that take the same steps are put side by side.

use super::{MAX_COLLISIONS, SORTED, careful, quick};

/// [`super::eta`] for slices of equal length; of slices of unequal length the shortest one counts.
///
/// The cells of a block with as many collisions and `r` on the same side of 1 follow the same steps: they are taken
/// some at a time. Each gets exactly what [`super::eta`] gives it.
pub fn etas(e: &[f64], r: &[f64], collisions: &[u64], out: &mut [(f64, f64)]) {
    let zero: &[f64] = &[];
    side_by_side::<false>(&Cells { e: [e, zero], r: [r, zero], collisions }, out);
}

/// The same for numbers that need not be doubles: each of `e` and `r` as the slices of the first and of the second parts of
/// its [`TwoDoubles`].
///
/// `(NaN, NaN)` where words do not suffice, and for what is no chain: the caller tells the two apart.
pub(crate) fn etas_of_two(e: [&[f64]; 2], r: [&[f64]; 2], collisions: &[u64], out: &mut [(f64, f64)]) {
    side_by_side::<true>(&Cells { e, r, collisions }, out);
}

/// The inputs of many cells; the second parts are read where it is `TWO`.
struct Cells<'a> {
    e: [&'a [f64]; 2],
    r: [&'a [f64]; 2],
    collisions: &'a [u64],
}

fn side_by_side<const TWO: bool>(cells: &Cells<'_>, out: &mut [(f64, f64)]) {
    #[cfg(target_arch = "x86_64")]
    if let pulp::Arch::V3(wide) = pulp::Arch::new() {
        return pulp::Simd::vectorize(wide, Wide::<TWO> { cells, out });
    }
    blocks::<4, false, TWO>(cells, out);
}

/// [`side_by_side`] for processors with fused products and registers for four doubles: compiled for those, where it is called.
#[cfg(target_arch = "x86_64")]
struct Wide<'a, const TWO: bool> {
    cells: &'a Cells<'a>,
    out: &'a mut [(f64, f64)],
}

#[cfg(target_arch = "x86_64")]
impl<const TWO: bool> pulp::NullaryFnOnce for Wide<'_, TWO> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        blocks::<8, true, TWO>(self.cells, self.out);
    }
}

/// Cells that are put in order at a time.
const BLOCK: usize = 2048;

#[inline(always)]
fn blocks<const N: usize, const FUSED: bool, const TWO: bool>(cells: &Cells<'_>, out: &mut [(f64, f64)]) {
    let Cells { e, r, collisions } = cells;
    let mut count = e[0].len().min(r[0].len()).min(collisions.len()).min(out.len());
    if TWO {
        count = count.min(e[1].len()).min(r[1].len());
    }
    for (k, out) in out[..count].chunks_mut(BLOCK).enumerate() {
        let some = k * BLOCK..k * BLOCK + out.len();
        block::<N, FUSED, TWO>(
            &Cells {
                e: [&e[0][some.clone()], if TWO { &e[1][some.clone()] } else { &[] }],
                r: [&r[0][some.clone()], if TWO { &r[1][some.clone()] } else { &[] }],
                collisions: &collisions[some],
            },
            out,
        );
    }
}

/// [`side_by_side`] for at most [`BLOCK`] cells, as many of each input as there is room for answers.
#[inline(always)]
fn block<const N: usize, const FUSED: bool, const TWO: bool>(cells: &Cells<'_>, out: &mut [(f64, f64)]) {
    let Cells { e, r, collisions } = cells;
    let count = out.len();
    let second = |x: [&[f64]; 2], i: usize| if TWO { x[1][i] } else { 0.0 };
    // A key is twice the number of collisions, and one more where r > 1; 0 for what is not sorted.
    let key = |i: usize| match collisions[i] {
        n @ ..=SORTED => 2 * n as usize + usize::from(r[0][i] > 1.0),
        _ => 0,
    };
    // Counting sort: where the cells of each key begin, then their numbers in that order.
    let mut ends = [0_usize; 2 * SORTED as usize + 2];
    for i in 0..count {
        ends[key(i)] += 1;
    }
    let mut sum = 0;
    for end in &mut ends {
        sum += std::mem::replace(end, sum);
    }
    let mut order = [0_usize; BLOCK];
    for i in 0..count {
        let place = &mut ends[key(i)];
        order[*place] = i;
        *place += 1;
    }
    // Now each key's cells end where `ends` says.
    let mut from = 0;
    for (key, to) in ends.into_iter().enumerate() {
        let same = order.get(from..to).unwrap_or_default();
        from = to;
        if key < 2 {
            for &i in same {
                let (e, r) = ([[e[0][i]], [second(*e, i)]], [[r[0][i]], [second(*r, i)]]);
                let found = match collisions[i] {
                    n @ 1..=MAX_COLLISIONS => quick::<1, false, TWO>(e, r, n, r[0][0] > 1.0)[0],
                    _ => None,
                };
                out[i] = found.unwrap_or_else(|| dearer::<TWO>(e[0][0], r[0][0], collisions[i]));
            }
            continue;
        }
        for some in same.chunks(N) {
            // The last ones are filled up with a cell among them.
            let lanes: [usize; N] = std::array::from_fn(|k| *some.get(k).unwrap_or(&some[0]));
            let (count, above) = ((key / 2) as u64, key % 2 == 1);
            let both = |x: [&[f64]; 2]| [lanes.map(|i| x[0][i]), lanes.map(|i| second(x, i))];
            let found = quick::<N, FUSED, TWO>(both(*e), both(*r), count, above);
            for (&i, found) in some.iter().zip(found) {
                out[i] = found.unwrap_or_else(|| dearer::<TWO>(e[0][i], r[0][i], collisions[i]));
            }
        }
    }
}

/// A cell for which words do not suffice.
#[inline(always)]
fn dearer<const TWO: bool>(e: f64, r: f64, collisions: u64) -> (f64, f64) {
    if TWO { (f64::NAN, f64::NAN) } else { careful(e, r, collisions) }
}
