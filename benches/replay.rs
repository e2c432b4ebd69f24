//! What a replay costs: `cargo bench --bench replay [-- lines|sizes|heavy]`.
//!
//! `lines`: dilute lines of n bodies with random small data, ten collisions a body: time for each collision, the size
//! of exact numbers, the most memory in use. `sizes`: the same state kept as intercepts and velocities, against
//! positions that are brought up to date at every collision. `heavy`: 100^k : 1 and a wall.

use carom::chain::replay::{Body, Line, Options, Status, Wall, replay};
use malachite::Rational;
use malachite::base::num::logic::traits::SignificantBits;
use std::time::Instant;

/// A small generator, so that every run has the same lines.
struct Random(u64);

impl Random {
    fn below(&mut self, n: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % n
    }
}

fn dilute(n: usize, seed: u64) -> Line {
    let mut random = Random(seed);
    let mut at = Rational::from(0);
    let mut bodies = Vec::with_capacity(n);
    for _ in 0..n {
        at += Rational::from_unsigneds(997 + random.below(997), 997);
        bodies.push(Body {
            mass: Rational::from(1 + random.below(4)),
            position: at.clone(),
            velocity: Rational::from_signeds(random.below(2001) as i64 - 1000, 1009),
            length: Rational::from(0),
        });
    }
    let e: Vec<Rational> = (1..n).map(|_| Rational::from_unsigneds(9 + random.below(2), 10u64)).collect();
    Line::new(&bodies, &e, None, None).expect("a valid line")
}

fn heavy(k: u32) -> Line {
    let body = |mass: Rational, x: i32, v: i32| Body {
        mass,
        position: Rational::from(x),
        velocity: Rational::from(v),
        length: Rational::from(0),
    };
    let one = Rational::from(1);
    let wall = Wall { position: Rational::from(0), restitution: one.clone() };
    let bodies = [body(one.clone(), 1, 0), body(Rational::from(100u64.pow(k)), 2, -1)];
    Line::new(&bodies, &[one], Some(&wall), None).expect("a valid line")
}

/// The most memory that this process has had, in MB.
fn peak() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find(|l| l.starts_with("VmHWM")).unwrap_or("");
    line.split_whitespace().nth(1).and_then(|k| k.parse::<u64>().ok()).unwrap_or(0) / 1024
}

fn lines() {
    println!("\nDilute lines, ten collisions a body");
    println!("| bodies | collisions | seconds | us a collision | bits at n, 2n, 4n, ... collisions | peak MB |");
    println!("|---|---|---|---|---|---|");
    for n in [100usize, 316, 1000, 3162, 10_000, 31_623, 100_000] {
        let line = dilute(n, 7);
        let events = 10 * n as u64;
        let options = Options { max_events: events, list: 0, exact_bits: None, ..Options::default() };
        // Small lines are repeated until the clock can see them.
        let rounds = (100_000 / events).max(1);
        let started = Instant::now();
        let mut outcome = None;
        for _ in 0..rounds {
            outcome = Some(replay(&line, &options).expect("the ledger balances"));
        }
        let time = started.elapsed().as_secs_f64() / rounds as f64;
        let outcome = outcome.expect("one round at least");
        assert!(matches!(outcome.status, Status::Limit(_)), "{n} bodies stopped early: {:?}", outcome.status);
        let sizes: Vec<String> = outcome.growth.iter().filter(|g| g.0 >= n as u64).map(|g| g.1.to_string()).collect();
        println!(
            "| {n} | {} | {time:.3} | {:.2} | {} | {} |",
            outcome.count,
            time * 1e6 / outcome.count as f64,
            sizes.join(", "),
            peak()
        );
    }
    println!("\nOne line of 10,000 bodies, more and more collisions: memory stays flat");
    println!("| collisions | seconds | bits | peak MB |");
    println!("|---|---|---|---|");
    let line = dilute(10_000, 7);
    for events in [10_000u64, 30_000, 100_000, 300_000, 1_000_000] {
        let options = Options { max_events: events, list: 0, exact_bits: None, ..Options::default() };
        let started = Instant::now();
        let outcome = replay(&line, &options).expect("the ledger balances");
        let bits = outcome.growth.last().map_or(0, |g| g.1);
        println!("| {} | {:.2} | {bits} | {} |", outcome.count, started.elapsed().as_secs_f64(), peak());
    }
}

/// The textbook state: positions, brought up to date at every collision. Bodies between walls, elastic.
fn textbook(line: &Line, events: u64) -> u64 {
    let n = line.bodies();
    let start: Vec<(Rational, Rational)> = (1..=n).filter_map(|b| line.start(b)).collect();
    let (mut x, mut v): (Vec<Rational>, Vec<Rational>) = start.into_iter().unzip();
    let m: Vec<Rational> = (1..=n).filter_map(|b| line.mass(b).cloned()).collect();
    let (Some(left), Some(right)) = line.walls() else { return 0 };
    let bits = |q: &Rational| q.numerator_ref().significant_bits().max(q.denominator_ref().significant_bits());
    let mut largest = 0;
    for _ in 0..events {
        let mut best: Option<(Rational, usize)> = None;
        for p in 0..=n {
            let (gap, closing) = match p {
                0 => (&x[0] - &left, -&v[0]),
                p if p == n => (&right - &x[n - 1], v[n - 1].clone()),
                p => (&x[p] - &x[p - 1], &v[p - 1] - &v[p]),
            };
            if closing > 0 {
                let wait = gap / closing;
                if best.as_ref().is_none_or(|(t, _)| wait < *t) {
                    best = Some((wait, p));
                }
            }
        }
        let Some((wait, p)) = best else { break };
        for (x, v) in x.iter_mut().zip(&v) {
            *x += v * &wait;
            largest = largest.max(bits(x));
        }
        if p == 0 {
            v[0] = -&v[0];
        } else if p == n {
            v[n - 1] = -&v[n - 1];
        } else {
            let push = (&v[p - 1] - &v[p]) * Rational::from(2) / (&m[p - 1] + &m[p]);
            v[p - 1] -= &m[p] * &push;
            v[p] += &m[p - 1] * push;
        }
    }
    largest
}

fn sizes() {
    println!("\nBits of the largest number of the state: four elastic bodies between walls, small random data");
    println!("| collisions | intercepts and velocities | positions |");
    println!("|---|---|---|");
    let open = dilute(4, 11);
    let bodies: Vec<Body> = (1..=4)
        .filter_map(|b| {
            let (position, velocity) = open.start(b)?;
            Some(Body { mass: open.mass(b)?.clone(), position, velocity, length: Rational::from(0) })
        })
        .collect();
    let wall = |x: i32| Wall { position: Rational::from(x), restitution: Rational::from(1) };
    let elastic = vec![Rational::from(1); 3];
    let line = Line::new(&bodies, &elastic, Some(&wall(0)), Some(&wall(9))).expect("a valid line");
    for events in [1u64, 3, 10, 30, 60] {
        let options = Options { max_events: events, list: 0, exact_bits: None, ..Options::default() };
        let outcome = replay(&line, &options).expect("the ledger balances");
        let ours = outcome.growth.last().map_or(0, |g| g.1);
        println!("| {} | {ours} | {} |", outcome.count, textbook(&line, events));
    }
    println!("\nWhere the exact part of 100^6 : 1 ends, 20,000 collisions");
    println!("| bits allowed | exact collisions | seconds |");
    println!("|---|---|---|");
    for bits in [512u64, 2048, 8192, 32_768] {
        let options = Options { max_events: 20_000, list: 0, exact_bits: Some(bits), ..Options::default() };
        let started = Instant::now();
        let outcome = replay(&heavy(6), &options).expect("the ledger balances");
        let exact = outcome.enclosed.map_or(outcome.count, |e| e.after);
        println!("| {bits} | {exact} | {:.3} |", started.elapsed().as_secs_f64());
    }
}

fn heavies() {
    println!("\n100^k : 1 and a wall, elastic");
    println!("| k | collisions | bits of the enclosures | seconds | entries of the order |");
    println!("|---|---|---|---|---|");
    for k in 0..=7 {
        let options = Options { max_events: 40_000_000, list: 0, ..Options::default() };
        let started = Instant::now();
        let outcome = replay(&heavy(k), &options).expect("the ledger balances");
        let time = started.elapsed().as_secs_f64();
        let (bits, entries) = outcome.enclosed.map_or(("exact".to_string(), 0), |e| (e.bits.to_string(), e.entries));
        println!("| {k} | {} | {bits} | {time:.3} | {entries} |", outcome.count);
    }
    println!("\nExact final velocities of 100^k : 1, evaluated as a power of a product");
    println!("| k | digits of the longest | seconds |");
    println!("|---|---|---|");
    for k in 2..=4 {
        let options = Options { max_events: 4_000_000, list: 0, exact_values: true, ..Options::default() };
        let started = Instant::now();
        let outcome = replay(&heavy(k), &options).expect("the ledger balances");
        let time = started.elapsed().as_secs_f64();
        let bits =
            outcome.velocities.iter().filter_map(|v| v.rational()).map(|q| q.denominator_ref().significant_bits());
        let digits = bits.max().unwrap_or(0) as f64 * std::f64::consts::LOG10_2;
        println!("| {k} | {digits:.0} | {time:.3} |");
    }
}

fn main() {
    let asked: Vec<String> = std::env::args().skip(1).filter(|a| !a.starts_with('-')).collect();
    let all = asked.is_empty();
    for (name, part) in [("heavy", heavies as fn()), ("sizes", sizes), ("lines", lines)] {
        if all || asked.iter().any(|a| a == name) {
            part();
        }
    }
}
