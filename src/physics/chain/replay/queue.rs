//! A binary heap of pairs that can be changed in place.
//!
//! Contract: holds each of the numbers `0 … n−1` at most once, ordered by the `less` given to each call, which
//! must order the present numbers in the same way every time until one is [`Queue::set`] again. Memory is two
//! words a pair for ever: nothing stale is kept.
//!
//! Cost: `O(log n)` comparisons for each change, `O(1)` for the first.

/// Marks a number that is not in the heap.
const ABSENT: u32 = u32::MAX;

/// The heap.
#[derive(Clone, Debug)]
pub(super) struct Queue {
    heap: Vec<u32>,
    place: Vec<u32>,
}

impl Queue {
    /// An empty heap for the numbers below `n`.
    pub(super) fn new(n: usize) -> Queue {
        Queue { heap: Vec::with_capacity(n), place: vec![ABSENT; n] }
    }

    /// The first, if there is one.
    pub(super) fn first(&self) -> Option<usize> {
        self.heap.first().map(|p| *p as usize)
    }

    /// All present numbers, in no order.
    pub(crate) fn present(&self) -> impl Iterator<Item = usize> + '_ {
        self.heap.iter().map(|p| *p as usize)
    }

    /// Puts the number where it belongs now, or takes it out.
    pub(super) fn set(&mut self, item: usize, present: bool, less: impl Fn(usize, usize) -> bool) {
        let at = self.place[item];
        match (at == ABSENT, present) {
            (true, false) => {}
            (true, true) => {
                self.place[item] = self.heap.len() as u32;
                self.heap.push(item as u32);
                self.rise(self.heap.len() - 1, &less);
            }
            (false, true) => {
                let at = self.rise(at as usize, &less);
                self.sink(at, &less);
            }
            (false, false) => {
                let at = at as usize;
                self.place[item] = ABSENT;
                let last = self.heap.pop();
                if let Some(last) = last.filter(|_| at < self.heap.len()) {
                    self.heap[at] = last;
                    self.place[last as usize] = at as u32;
                    let at = self.rise(at, &less);
                    self.sink(at, &less);
                }
            }
        }
    }

    fn exchange(&mut self, a: usize, b: usize) {
        self.heap.swap(a, b);
        self.place[self.heap[a] as usize] = a as u32;
        self.place[self.heap[b] as usize] = b as u32;
    }

    fn rise(&mut self, mut at: usize, less: &impl Fn(usize, usize) -> bool) -> usize {
        while at > 0 {
            let above = (at - 1) / 2;
            if !less(self.heap[at] as usize, self.heap[above] as usize) {
                break;
            }
            self.exchange(at, above);
            at = above;
        }
        at
    }

    fn sink(&mut self, mut at: usize, less: &impl Fn(usize, usize) -> bool) {
        loop {
            let (left, right) = (2 * at + 1, 2 * at + 2);
            let mut least = at;
            for child in [left, right] {
                if child < self.heap.len() && less(self.heap[child] as usize, self.heap[least] as usize) {
                    least = child;
                }
            }
            if least == at {
                return;
            }
            self.exchange(at, least);
            at = least;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Queue;

    #[test]
    fn the_first_is_the_least_after_any_changes() {
        let mut seed = 12345u64;
        let mut next = move || {
            seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (seed >> 33) as usize
        };
        let n = 37;
        let mut keys = vec![0usize; n];
        let mut here = vec![false; n];
        let mut queue = Queue::new(n);
        for _ in 0..5000 {
            let (item, key, present) = (next() % n, next() % 50, next() % 3 > 0);
            keys[item] = key;
            here[item] = present;
            queue.set(item, present, |a, b| keys[a] < keys[b]);
            let least = (0..n).filter(|i| here[*i]).map(|i| keys[i]).min();
            assert_eq!(queue.first().map(|i| keys[i]), least);
            assert_eq!(queue.present().count(), here.iter().filter(|h| **h).count());
        }
    }
}
