//! A binary heap of pairs whose keys can be changed in place.
//!
//! Contract: holds each of the numbers `0 … n−1` at most once, with a key that is a number; the first has the least key.
//! Memory is three words a pair for ever: nothing stale is kept.
//!
//! Cost: `O(log n)` comparisons for each change, `O(1)` for the first.

/// Marks a number that is not in the heap.
const ABSENT: u32 = u32::MAX;

/// The heap.
#[derive(Clone, Debug)]
pub(super) struct Queue {
    heap: Vec<(f64, u32)>,
    place: Vec<u32>,
}

impl Queue {
    /// An empty heap for the numbers below `n`.
    pub(super) fn new(n: usize) -> Queue {
        Queue { heap: Vec::with_capacity(n), place: vec![ABSENT; n] }
    }

    /// The first, if there is one.
    #[inline]
    pub(super) fn first(&self) -> Option<usize> {
        self.heap.first().map(|(_, p)| *p as usize)
    }

    /// All present numbers, in no order.
    pub(crate) fn present(&self) -> impl Iterator<Item = usize> + '_ {
        self.heap.iter().map(|(_, p)| *p as usize)
    }

    /// Adds all numbers to the list whose key is not above the bound, the first one first.
    #[inline]
    pub(super) fn up_to(&self, bound: f64, list: &mut Vec<usize>) {
        // Each entry of the list so far may have children; `list` holds places until the end.
        let from = list.len();
        list.extend(self.heap.first().filter(|(key, _)| *key <= bound).map(|_| 0));
        let mut at = from;
        while at < list.len() {
            let child = 2 * list[at] + 1;
            list.extend((child..child + 2).filter(|c| self.heap.get(*c).is_some_and(|(key, _)| *key <= bound)));
            at += 1;
        }
        for place in &mut list[from..] {
            *place = self.heap[*place].1 as usize;
        }
    }

    /// Puts the number where its key belongs, or takes it out.
    pub(super) fn set(&mut self, item: usize, key: Option<f64>) {
        let at = self.place[item];
        match (at == ABSENT, key) {
            (true, None) => {}
            (true, Some(key)) => {
                self.heap.push((key, item as u32));
                self.rise(self.heap.len() - 1, (key, item as u32));
            }
            (false, Some(key)) => {
                let at = self.rise(at as usize, (key, item as u32));
                self.sink(at, (key, item as u32));
            }
            (false, None) => {
                let at = at as usize;
                self.place[item] = ABSENT;
                let last = self.heap.pop();
                if let Some(last) = last.filter(|_| at < self.heap.len()) {
                    let at = self.rise(at, last);
                    self.sink(at, last);
                }
            }
        }
    }

    #[inline]
    fn put(&mut self, at: usize, entry: (f64, u32)) {
        self.heap[at] = entry;
        self.place[entry.1 as usize] = at as u32;
    }

    fn rise(&mut self, mut at: usize, entry: (f64, u32)) -> usize {
        while at > 0 {
            let above = (at - 1) / 2;
            if entry.0 >= self.heap[above].0 {
                break;
            }
            self.put(at, self.heap[above]);
            at = above;
        }
        self.put(at, entry);
        at
    }

    fn sink(&mut self, mut at: usize, entry: (f64, u32)) {
        loop {
            let mut child = 2 * at + 1;
            if child >= self.heap.len() {
                break;
            }
            if child + 1 < self.heap.len() && self.heap[child + 1].0 < self.heap[child].0 {
                child += 1;
            }
            if self.heap[child].0 >= entry.0 {
                break;
            }
            self.put(at, self.heap[child]);
            at = child;
        }
        self.put(at, entry);
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
            queue.set(item, present.then_some(key as f64));
            let least = (0..n).filter(|i| here[*i]).map(|i| keys[i]).min();
            assert_eq!(queue.first().map(|i| keys[i]), least);
            let mut early = Vec::new();
            queue.up_to(20.0, &mut early);
            assert_eq!(early.first().copied(), queue.first().filter(|i| keys[*i] <= 20));
            early.sort_unstable();
            assert_eq!(early, (0..n).filter(|i| here[*i] && keys[*i] <= 20).collect::<Vec<_>>());
            assert_eq!(queue.present().count(), here.iter().filter(|h| **h).count());
        }
    }
}
