//! The largest least eigenvalue of symmetric matrices under linear equations, in doubles.
//!
//! Contract: [`search`] suggests matrices; nothing here is exact, and nobody may rely on an answer without checking it. The same
//! input gives the same doubles on every machine.
//!
//! Method: matrices Q with A(Q) = b are wanted of which all eigenvalues are at least t. With X = Q − t·1 and s = 1 − t this is a
//! semidefinite program: minimise s >= 0 for X positive semidefinite and A(X) − s·A(1) = b − A(1). A primal-dual
//! interior-point method solves it, with Mehrotra's predictor and corrector in the direction of Helmberg, Kojima and Monteiro (C.
//! Helmberg, F. Rendl, R. Vanderbei, H. Wolkowicz, SIAM J. Optim. 6, 1996; B. Borchers, "CSDP", 1999). Its path leads to matrices of
//! the highest rank, so the kernels that are left belong to every solution.
//!
//! Cost: each of at most [`ITERATIONS`] iterations multiplies the matrices and solves m equations for m conditions.

use super::matrix::Matrix;

/// The most iterations; about twenty are usual.
const ITERATIONS: usize = 60;

/// How far the equations may be violated, relative to their right sides.
const VIOLATION: f64 = 1e-9;

/// The gap between the bounds of the optimum at which it is known well enough.
const GAP: f64 = 1e-10;

/// A least eigenvalue below this says that there are no positive semidefinite matrices.
const NEGATIVE: f64 = -1e-4;

/// The part of the way to the boundary that a step takes.
const STEP: f64 = 0.95;

/// An entry of the symmetric matrix of a condition, and of its mirror image.
#[derive(Clone, Copy, Debug)]
pub(super) struct Entry {
    /// The matrix.
    pub block: usize,
    pub row: usize,
    /// At least the row.
    pub column: usize,
    pub value: f64,
}

/// A linear equation for the entries.
#[derive(Clone, Debug)]
pub(super) struct Condition {
    pub entries: Vec<Entry>,
    pub value: f64,
}

/// Suggested matrices.
#[derive(Debug)]
pub(super) struct Suggestion {
    /// The matrices Q.
    pub grams: Vec<Matrix>,
}

/// A point of the primal or the dual.
type Blocks = Vec<Matrix>;

/// Matrices of these sizes that satisfy the conditions, with the largest least eigenvalue; `None` where it is negative, or the
/// budget of operations is used up.
pub(super) fn search(sizes: &[usize], conditions: &[Condition], budget: &mut usize) -> Option<Suggestion> {
    let program = Program::new(sizes, conditions);
    let cost = program.cost_of_a_step();
    let mut state = program.start();
    let mut best: Option<State> = None;
    for _ in 0..ITERATIONS {
        *budget = budget.checked_sub(cost)?;
        let errors = program.errors(&state);
        let least = 1.0 - state.slack();
        let bound = 1.0 - program.dual_value(&state);
        if errors.dual < 1e-7 && bound < NEGATIVE {
            return None;
        }
        if errors.primal < VIOLATION {
            best = Some(state.clone());
            let known = errors.dual < VIOLATION && (bound - least).abs() < GAP * (1.0 + least.abs());
            // Half of what is possible is room enough to round.
            if known || (errors.dual < 1e-6 && least > 1e-3 && least > bound / 2.0) {
                break;
            }
        }
        match program.step(&state) {
            Some(next) => state = next,
            None => break,
        }
    }
    let state = best?;
    let least = 1.0 - state.slack();
    let count = sizes.len();
    let grams = state.x[..count].iter().map(|x| x.plus(least, &Matrix::diagonal(x.size(), 1.0))).collect();
    Some(Suggestion { grams })
}

#[derive(Clone)]
struct State {
    x: Blocks,
    y: Vec<f64>,
    z: Blocks,
}

impl State {
    /// s.
    fn slack(&self) -> f64 {
        self.x.last().map_or(0.0, |s| s.at(0, 0))
    }
}

struct Errors {
    primal: f64,
    dual: f64,
}

/// The program in standard form; its last block is s.
struct Program {
    sizes: Vec<usize>,
    conditions: Vec<Condition>,
    /// For each block, the entries of all conditions there, with the condition.
    by_block: Vec<Vec<(usize, Entry)>>,
    cost: Blocks,
}

impl Program {
    fn new(sizes: &[usize], conditions: &[Condition]) -> Self {
        let last = sizes.len();
        let sizes: Vec<usize> = sizes.iter().copied().chain([1]).collect();
        let norm = |c: &Condition| c.entries.iter().map(|e| e.value * e.value).sum::<f64>().sqrt();
        let with_slack = |c: &Condition| {
            let scale = 1.0 / norm(c).max(1e-12);
            let mut entries: Vec<Entry> = c.entries.iter().map(|e| Entry { value: e.value * scale, ..*e }).collect();
            let trace: f64 = entries.iter().filter(|e| e.row == e.column).map(|e| e.value).sum();
            if trace != 0.0 {
                entries.push(Entry { block: last, row: 0, column: 0, value: -trace });
            }
            Condition { entries, value: c.value * scale - trace }
        };
        let conditions: Vec<Condition> = conditions.iter().map(with_slack).collect();
        let mut by_block = vec![Vec::new(); sizes.len()];
        for (k, condition) in conditions.iter().enumerate() {
            condition.entries.iter().for_each(|e| by_block[e.block].push((k, *e)));
        }
        let mut cost: Blocks = sizes.iter().map(|n| Matrix::zero(*n)).collect();
        cost[last].add_at(0, 0, 1.0);
        Self { sizes, conditions, by_block, cost }
    }

    /// About how many multiplications a step takes: its equations are made and solved, and the matrices multiplied.
    fn cost_of_a_step(&self) -> usize {
        let matrices: usize = self.sizes.iter().map(|n| 30 * n * n * n).sum();
        let made: usize = self.by_block.iter().map(|list| 2 * list.len() * list.len()).sum();
        matrices + made + self.conditions.len().pow(3) / 6
    }

    /// Multiples of the unit matrices, large enough for the right sides.
    fn start(&self) -> State {
        let total: f64 = self.sizes.iter().map(|n| *n as f64).sum();
        let values = self.conditions.iter().map(|c| (1.0 + c.value.abs()) / 2.0);
        let primal = 10.0 * total.sqrt() * values.fold(1.0, f64::max);
        let of = |value: f64| self.sizes.iter().map(|n| Matrix::diagonal(*n, value)).collect();
        State { x: of(primal), y: vec![0.0; self.conditions.len()], z: of(10.0) }
    }

    /// The left sides of the conditions.
    fn left(&self, x: &Blocks) -> Vec<f64> {
        let of = |e: &Entry| {
            let x = &x[e.block];
            if e.row == e.column {
                e.value * x.at(e.row, e.row)
            } else {
                e.value * (x.at(e.row, e.column) + x.at(e.column, e.row))
            }
        };
        self.conditions.iter().map(|c| c.entries.iter().map(of).sum()).collect()
    }

    /// The sum of the conditions' matrices with these weights.
    fn weighted(&self, y: &[f64]) -> Blocks {
        let mut out: Blocks = self.sizes.iter().map(|n| Matrix::zero(*n)).collect();
        for (condition, y) in self.conditions.iter().zip(y) {
            for e in &condition.entries {
                out[e.block].add_at(e.row, e.column, e.value * y);
                if e.row != e.column {
                    out[e.block].add_at(e.column, e.row, e.value * y);
                }
            }
        }
        out
    }

    fn dual_value(&self, state: &State) -> f64 {
        self.conditions.iter().zip(&state.y).map(|(c, y)| c.value * y).sum()
    }

    fn primal_residual(&self, state: &State) -> Vec<f64> {
        self.conditions.iter().zip(self.left(&state.x)).map(|(c, left)| c.value - left).collect()
    }

    fn dual_residual(&self, state: &State) -> Blocks {
        let weighted = self.weighted(&state.y);
        let cost = self.cost.iter().zip(&weighted).zip(&state.z);
        cost.map(|((c, a), z)| c.plus(-1.0, a).plus(-1.0, z)).collect()
    }

    fn errors(&self, state: &State) -> Errors {
        let size = |list: &[f64]| list.iter().map(|x| x * x).sum::<f64>().sqrt();
        let values: Vec<f64> = self.conditions.iter().map(|c| c.value).collect();
        let dual: f64 = self.dual_residual(state).iter().map(|r| r.inner(r)).sum();
        Errors { primal: size(&self.primal_residual(state)) / (1.0 + size(&values)), dual: dual.sqrt() / 2.0 }
    }

    /// The matrix tr(A_k·X·A_l·Z⁻¹) of the equations for the step.
    fn schur(&self, x: &Blocks, inverse: &Blocks) -> Matrix {
        let mut out = Matrix::zero(self.conditions.len());
        for (block, list) in self.by_block.iter().enumerate() {
            let (x, z) = (&x[block], &inverse[block]);
            // An entry of the diagonal is twice the half of itself.
            let half = |e: &Entry| if e.row == e.column { e.value / 2.0 } else { e.value };
            for (k, e) in list {
                let (xi, xj, zi, zj) = (x.row(e.row), x.row(e.column), z.row(e.row), z.row(e.column));
                let value = half(e);
                for (l, f) in list.iter().take_while(|(l, _)| l <= k) {
                    let (p, q) = (f.row, f.column);
                    let trace = xj[p] * zi[q] + xi[p] * zj[q] + xj[q] * zi[p] + xi[q] * zj[p];
                    out.add_at(*k, *l, value * half(f) * trace);
                }
            }
        }
        out
    }

    /// The next point; `None` where doubles are too coarse for one.
    fn step(&self, state: &State) -> Option<State> {
        let inverse: Blocks =
            state.z.iter().map(|z| z.cholesky().map(|l| l.inverse_by_cholesky())).collect::<Option<_>>()?;
        let mut schur = self.schur(&state.x, &inverse);
        let trace: f64 = (0..schur.size()).map(|i| schur.at(i, i)).sum();
        let factor = schur.cholesky().or_else(|| {
            // Conditions that depend on one another as far as doubles tell.
            (0..schur.size()).for_each(|i| schur.add_at(i, i, 1e-13 * trace));
            schur.cholesky()
        })?;
        let total: f64 = self.sizes.iter().map(|n| *n as f64).sum();
        let mean = |x: &Blocks, z: &Blocks| x.iter().zip(z).map(|(x, z)| x.inner(z)).sum::<f64>() / total;
        let mu = mean(&state.x, &state.z);
        let aim = Aim {
            primal: self.primal_residual(state),
            dual: self.dual_residual(state),
            inverse: &inverse,
            factor: &factor,
        };
        let none: Blocks = self.sizes.iter().map(|n| Matrix::zero(*n)).collect();
        let (dx, _, dz) = self.direction(state, &aim, 0.0, &none);
        let along =
            |x: &Blocks, step: f64, d: &Blocks| -> Blocks { x.iter().zip(d).map(|(x, d)| x.plus(step, d)).collect() };
        let (a, b) = (longest(&state.x, &dx), longest(&state.z, &dz));
        let reached = mean(&along(&state.x, a, &dx), &along(&state.z, b, &dz)) / mu;
        let sigma = (reached * reached * reached).clamp(1e-4, 0.9);
        let second: Blocks = dx.iter().zip(&dz).map(|(x, z)| x.times(z)).collect();
        let (dx, dy, dz) = self.direction(state, &aim, sigma * mu, &second);
        let (a, b) = (longest(&state.x, &dx), longest(&state.z, &dz));
        if a.max(b) < 1e-7 || !(a.is_finite() && b.is_finite()) {
            return None;
        }
        let y = state.y.iter().zip(&dy).map(|(y, d)| y + b * d).collect();
        Some(State { x: along(&state.x, a, &dx), y, z: along(&state.z, b, &dz) })
    }

    /// The direction to the point of the path with this mean, with the products of a first direction as a correction.
    fn direction(&self, state: &State, aim: &Aim, mean: f64, second: &Blocks) -> (Blocks, Vec<f64>, Blocks) {
        // X + dX = mean·Z⁻¹ − (X·dZ + second)·Z⁻¹, where dZ = dual − Aᵀ(dy).
        let constant: Blocks = (0..self.sizes.len())
            .map(|i| {
                let product = state.x[i].times(&aim.dual[i]).plus(1.0, &second[i]).times(&aim.inverse[i]);
                product.plus(1.0, &state.x[i]).plus(-mean, &aim.inverse[i]).scaled(-1.0)
            })
            .collect();
        let right: Vec<f64> = aim.primal.iter().zip(self.left(&constant)).map(|(p, l)| p - l).collect();
        let dy = aim.factor.solve_by_cholesky(&right);
        let weighted = self.weighted(&dy);
        let dx = (0..self.sizes.len())
            .map(|i| {
                let moved = state.x[i].times(&weighted[i]).times(&aim.inverse[i]);
                constant[i].plus(1.0, &moved).symmetric()
            })
            .collect();
        let dz = aim.dual.iter().zip(&weighted).map(|(r, w)| r.plus(-1.0, w)).collect();
        (dx, dy, dz)
    }
}

/// What a direction is for.
struct Aim<'a> {
    primal: Vec<f64>,
    dual: Blocks,
    /// Z⁻¹.
    inverse: &'a Blocks,
    /// The Cholesky factor of the equations for the step.
    factor: &'a Matrix,
}

/// How far to go in a direction so that all matrices stay positive definite, at most 1.
fn longest(x: &Blocks, d: &Blocks) -> f64 {
    let mut step = 1.0;
    for (x, d) in x.iter().zip(d) {
        while x.plus(step, d).cholesky().is_none() {
            step *= 0.8;
            if step < 1e-9 {
                return 0.0;
            }
        }
    }
    STEP * step
}
