//! A table's cells as pairs of neighbouring doubles: the job that `python/benchmark.py` compares Python's arrays with.
//!
//! `cargo run --release --example cells 5` computes 10^6 cells of eta so many times, and prints the seconds of the fastest
//! time and the sums of the ends.

use carom::number::decimal::{Digits, Rounding};
use carom::table::grid::Grid;
use carom::table::shared::Factors;
use carom::table::{Plan, Printing, Quantity};
use std::time::Instant;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let (ratio, e, n) = (Grid::parse("2:1001:1")?, Grid::parse("0.0005:0.9995:0.001")?, Grid::parse("7")?);
    let printing = Printing { digits: Digits::Significant(15), rounding: Rounding::Nearest, extra: 0 };
    let plan = Plan::new(Quantity::Eta, ratio, Some(e), Some(n), printing)?;
    let mut least = f64::INFINITY;
    let mut sums = (0.0, 0.0);
    let times: u32 = std::env::args().nth(1).as_deref().unwrap_or("5").parse()?;
    for _ in 0..times {
        let begin = Instant::now();
        let (mut lower, mut upper) = (Vec::with_capacity(1_000_000), Vec::with_capacity(1_000_000));
        let mut factors = Factors::new(&plan);
        for row in 0..plan.rows() {
            let (lo, hi) = factors.neighbours(row)?;
            lower.push(lo);
            upper.push(hi);
        }
        least = least.min(begin.elapsed().as_secs_f64());
        sums = (lower.iter().sum::<f64>(), upper.iter().sum::<f64>());
    }
    println!("{least} {} {}", sums.0, sums.1);
    Ok(())
}
