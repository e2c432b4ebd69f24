//! Square matrices of doubles: what an interior-point method needs of them.
//!
//! Only additions, products, quotients and square roots occur, which every machine rounds in the same way.

/// The most sweeps of Jacobi's method; it converges quadratically, after about six.
const SWEEPS: usize = 30;

/// A square matrix, row by row.
#[derive(Clone, Debug)]
pub(super) struct Matrix {
    size: usize,
    entries: Vec<f64>,
}

impl Matrix {
    pub(super) fn zero(size: usize) -> Self {
        Self { size, entries: vec![0.0; size * size] }
    }

    /// A multiple of the unit matrix.
    pub(super) fn diagonal(size: usize, value: f64) -> Self {
        let mut out = Self::zero(size);
        (0..size).for_each(|i| out.entries[i * size + i] = value);
        out
    }

    pub(super) fn size(&self) -> usize {
        self.size
    }

    pub(super) fn at(&self, row: usize, column: usize) -> f64 {
        self.entries[row * self.size + column]
    }

    pub(super) fn row(&self, row: usize) -> &[f64] {
        &self.entries[row * self.size..(row + 1) * self.size]
    }

    pub(super) fn add_at(&mut self, row: usize, column: usize, value: f64) {
        self.entries[row * self.size + column] += value;
    }

    /// self + factor·other.
    pub(super) fn plus(&self, factor: f64, other: &Self) -> Self {
        let entries = self.entries.iter().zip(&other.entries).map(|(a, b)| a + factor * b).collect();
        Self { size: self.size, entries }
    }

    pub(super) fn scaled(&self, factor: f64) -> Self {
        Self { size: self.size, entries: self.entries.iter().map(|a| a * factor).collect() }
    }

    pub(super) fn times(&self, other: &Self) -> Self {
        let mut out = Self::zero(self.size);
        for i in 0..self.size {
            let sums = &mut out.entries[i * self.size..(i + 1) * self.size];
            for (k, a) in self.row(i).iter().enumerate() {
                if *a != 0.0 {
                    sums.iter_mut().zip(other.row(k)).for_each(|(sum, b)| *sum += a * b);
                }
            }
        }
        out
    }

    /// (self + selfᵀ)/2.
    pub(super) fn symmetric(&self) -> Self {
        let mut out = Self::zero(self.size);
        for i in 0..self.size {
            for j in 0..self.size {
                out.entries[i * self.size + j] = (self.at(i, j) + self.at(j, i)) / 2.0;
            }
        }
        out
    }

    /// The sum of the products of equal entries.
    pub(super) fn inner(&self, other: &Self) -> f64 {
        self.entries.iter().zip(&other.entries).map(|(a, b)| a * b).sum()
    }

    /// The lower triangle L with L·Lᵀ = self; `None` where the matrix is not positive definite.
    pub(super) fn cholesky(&self) -> Option<Self> {
        let n = self.size;
        let mut lower = Self::zero(n);
        for i in 0..n {
            for j in 0..=i {
                let products: f64 = lower.row(i)[..j].iter().zip(&lower.row(j)[..j]).map(|(a, b)| a * b).sum();
                let left = self.at(i, j) - products;
                let entry = if i == j {
                    // A NaN is not greater either.
                    if left > 0.0 && left.is_finite() { left.sqrt() } else { return None }
                } else {
                    left / lower.at(j, j)
                };
                lower.entries[i * n + j] = entry;
            }
        }
        Some(lower)
    }

    /// The solution of L·Lᵀ·x = b for a lower triangle L.
    pub(super) fn solve_by_cholesky(&self, b: &[f64]) -> Vec<f64> {
        let n = self.size;
        let mut x = b.to_vec();
        for i in 0..n {
            let products: f64 = self.row(i)[..i].iter().zip(&x[..i]).map(|(a, b)| a * b).sum();
            x[i] = (x[i] - products) / self.at(i, i);
        }
        for i in (0..n).rev() {
            x[i] /= self.at(i, i);
            let solved = x[i];
            x[..i].iter_mut().zip(self.row(i)).for_each(|(left, entry)| *left -= entry * solved);
        }
        x
    }

    /// The inverse of L·Lᵀ for a lower triangle L.
    pub(super) fn inverse_by_cholesky(&self) -> Self {
        let n = self.size;
        let mut out = Self::zero(n);
        for j in 0..n {
            let mut unit = vec![0.0; n];
            unit[j] = 1.0;
            for (i, value) in self.solve_by_cholesky(&unit).into_iter().enumerate() {
                out.entries[i * n + j] = value;
            }
        }
        out.symmetric()
    }

    /// The eigenvalues of a symmetric matrix with their eigenvectors, by Jacobi's rotations.
    pub(super) fn eigenvectors(&self) -> Vec<(f64, Vec<f64>)> {
        let n = self.size;
        let mut a = self.clone();
        let mut vectors = Self::diagonal(n, 1.0);
        let total = self.inner(self);
        for _ in 0..SWEEPS {
            let outside: f64 = (0..n).map(|i| a.row(i)[..i].iter().map(|x| x * x).sum::<f64>()).sum();
            if outside <= 1e-30 * total {
                break;
            }
            for p in 0..n {
                for q in p + 1..n {
                    a.rotate(p, q, &mut vectors);
                }
            }
        }
        let vector = |j: usize| (0..n).map(|i| vectors.at(i, j)).collect();
        (0..n).map(|j| (a.at(j, j), vector(j))).collect()
    }

    /// One rotation that makes the entry (p, q) zero.
    fn rotate(&mut self, p: usize, q: usize, vectors: &mut Self) {
        let n = self.size;
        let off = self.at(p, q);
        if off == 0.0 {
            return;
        }
        let theta = (self.at(q, q) - self.at(p, p)) / (2.0 * off);
        let sign = if theta < 0.0 { -1.0 } else { 1.0 };
        let t = sign / (theta.abs() + (theta * theta + 1.0).sqrt());
        let c = 1.0 / (t * t + 1.0).sqrt();
        let s = t * c;
        for k in 0..n {
            let (x, y) = (self.at(k, p), self.at(k, q));
            self.entries[k * n + p] = c * x - s * y;
            self.entries[k * n + q] = s * x + c * y;
        }
        for k in 0..n {
            let (x, y) = (self.at(p, k), self.at(q, k));
            self.entries[p * n + k] = c * x - s * y;
            self.entries[q * n + k] = s * x + c * y;
        }
        for k in 0..n {
            let (x, y) = (vectors.at(k, p), vectors.at(k, q));
            vectors.entries[k * n + p] = c * x - s * y;
            vectors.entries[k * n + q] = s * x + c * y;
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // a test stops where it fails
mod tests {
    use super::*;

    fn example() -> Matrix {
        Matrix { size: 3, entries: vec![4.0, 2.0, -1.0, 2.0, 5.0, 3.0, -1.0, 3.0, 6.0] }
    }

    #[test]
    fn an_inverse_times_the_matrix_is_the_unit() {
        let inverse = example().cholesky().unwrap().inverse_by_cholesky();
        let distance = inverse.times(&example()).plus(-1.0, &Matrix::diagonal(3, 1.0));
        assert!(distance.inner(&distance) < 1e-20);
    }

    #[test]
    fn a_matrix_with_a_negative_eigenvalue_has_no_cholesky_factor() {
        let shifted = example().plus(-1.5, &Matrix::diagonal(3, 1.0));
        assert!(shifted.eigenvectors().iter().any(|e| e.0 < 0.0));
        assert!(shifted.cholesky().is_none());
    }

    #[test]
    fn every_eigenvector_is_one() {
        for (value, vector) in example().eigenvectors() {
            for i in 0..3 {
                let image: f64 = example().row(i).iter().zip(&vector).map(|(a, b)| a * b).sum();
                assert!((image - value * vector[i]).abs() < 1e-12);
            }
        }
    }
}
