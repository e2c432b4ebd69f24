//! Carom's side of the comparison with other tools: `cargo run --release --example peers -- JOB WORK [CASE…]`.
//!
//! Runs the cases of a job in this process and prints `{"case", "seconds", "answer"}` for each one, seconds being
//! those of one unit. `benches/peers/run` writes the inputs into WORK, starts every tool and compares the answers.
#![allow(clippy::unwrap_used)] // a benchmark stops where its own input is wrong

use carom::chain::best::{Best, best};
use carom::chain::pass::Pass;
use carom::chain::replay::{Body, Line, Options, follow, replay};
use carom::chain::threshold::{Helps, helps, threshold};
use carom::chain::{Positive, Restitution, Restitutions, fast, transfer};
use carom::claim::{embedded, parse::parse};
use carom::judge::hand::AtHand;
use carom::judge::{Settings, judge};
use carom::number::decimal::{Decimal, Digits, Rounding, bits_of_digits};
use carom::number::fraction::Fraction;
use carom::number::rational;
use carom::number::real::Real;
use carom::refute::catalogue::Catalogue;
use carom::refute::outcome::Verdict;
use malachite::base::num::arithmetic::traits::{ModPowerOf2, PowerOf2};
use malachite::base::num::basic::traits::One;
use malachite::base::num::logic::traits::SignificantBits;
use malachite::{Natural, Rational};
use std::fs;
use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::time::{Duration, Instant};

/// Leading digits that are not compared, since the tools round differently.
const SPARE: u64 = 10;
const IDENTITIES: [&str; 19] = [
    "eq05", "eq06", "eq07", "eq08", "eq09", "eq12", "eq13", "eq16", "eq22", "eq23", "eq24", "eq25", "u1", "u2", "u3",
    "u4", "u5", "u6", "u7",
];

/// A job being run: where its input lies and which cases are wanted.
struct Run {
    work: PathBuf,
    wanted: Vec<String>,
}

/// The median time of one call, and the value. A short call is repeated, unless CAROM_ONCE is set: then the number
/// of instructions does not depend on the clock.
fn measure<T>(mut compute: impl FnMut() -> T) -> (f64, T) {
    let started = Instant::now();
    let value = black_box(compute());
    let once = started.elapsed();
    if once > Duration::from_millis(20) || std::env::var_os("CAROM_ONCE").is_some() {
        return (once.as_secs_f64(), value);
    }
    let calls = (20_000_000 / once.as_nanos().max(20)).max(1) as u32;
    let mut rounds: Vec<f64> = (0..9)
        .map(|_| {
            let started = Instant::now();
            for _ in 0..calls {
                black_box(compute());
            }
            started.elapsed().as_secs_f64() / f64::from(calls)
        })
        .collect();
    rounds.sort_by(f64::total_cmp);
    (rounds[rounds.len() / 2], value)
}

impl Run {
    fn case<T>(&self, case: &str, compute: impl FnMut() -> T, answer: impl FnOnce(T) -> String) {
        if self.wanted.is_empty() || self.wanted.iter().any(|w| w == case) {
            let (seconds, value) = measure(compute);
            println!("{{\"case\": \"{case}\", \"seconds\": {seconds:e}, \"answer\": \"{}\"}}", answer(value));
        }
    }

    /// What any answer to a case takes, in seconds: the work that `render.py` measures Carom by.
    fn least(&self, case: &str, seconds: f64) {
        println!("{{\"case\": \"least/{case}\", \"seconds\": {seconds:e}, \"answer\": \"\"}}");
    }

    fn text(&self, file: &str) -> String {
        fs::read_to_string(self.work.join(file)).unwrap()
    }

    fn doubles(&self, file: &str) -> Vec<f64> {
        let bytes = fs::read(self.work.join(file)).unwrap();
        bytes.chunks_exact(8).map(|b| f64::from_le_bytes(b.try_into().unwrap())).collect()
    }

    /// Writes the ends of all enclosures for the comparison.
    fn ends(&self, name: &str, ends: impl Iterator<Item = f64>) -> String {
        let path = self.work.join(format!("{name}.ends"));
        let bytes: Vec<u8> = ends.flat_map(f64::to_le_bytes).collect();
        fs::write(&path, bytes).unwrap();
        path.display().to_string()
    }
}

fn positive(x: Rational) -> Positive {
    Positive::new(x).unwrap()
}

fn restitution(x: Rational) -> Restitution {
    Restitution::new(x).unwrap()
}

fn audit(names: &[&str], claims: Vec<carom::claim::syntax::Claim>) -> bool {
    let catalogue = Catalogue::new(claims).unwrap();
    let names: Vec<String> = names.iter().map(|name| name.to_string()).collect();
    let found = judge(&catalogue, &names, &AtHand::default(), &Settings::default(), &|_| {});
    found.entries.iter().all(|(_, entry)| entry.as_ref().is_ok_and(|e| e.outcome.verdict == Verdict::Proved))
}

fn identities(run: &Run) {
    let names: Vec<String> = IDENTITIES.iter().map(|n| (*n).to_owned()).collect();
    let judged = || audit(&IDENTITIES, embedded::claims(&names).unwrap().unwrap());
    run.case("19 identities", judged, |all| all.to_string());
}

fn scattered(run: &Run) {
    let all = run.doubles("J2a.bin");
    let count = all.len() / 3;
    let collisions: Vec<u64> = all[2 * count..].iter().map(|n| *n as u64).collect();
    let mut out = vec![(0.0, 0.0); count];
    let name = "one of 100000 cells";
    let (seconds, ()) = measure(|| fast::etas(&all[..count], &all[count..2 * count], &collisions, &mut out));
    let mut cells = vec![(0.0, 0.0); count];
    let least = || {
        for (i, cell) in cells.iter_mut().enumerate() {
            *cell = black_box((all[i] + all[count + i], all[2 * count + i]));
        }
    };
    run.least(name, measure(least).0 / count as f64);
    let path = run.ends("J2a-carom", out.iter().map(|c| c.0).chain(out.iter().map(|c| c.1)));
    println!("{{\"case\": \"{name}\", \"seconds\": {:e}, \"answer\": \"{path}\"}}", seconds / count as f64);
}

fn grid(run: &Run) {
    let all = run.doubles("J2b.bin");
    let (e, r) = all.split_at(all.len() / 2);
    let cells = e.len() * r.len();
    let (mut lower, mut upper) = (vec![0.0; cells], vec![0.0; cells]);
    let (seconds, ()) = measure(|| {
        let (a, b) = (fast::Factors::of_restitutions(e, 8), fast::Factors::of_ratios(r, 8));
        fast::grid(&a, &b, &mut lower, &mut upper);
    });
    let path = run.ends("J2b-carom", lower.iter().chain(&upper).copied());
    let least = || {
        lower.fill(black_box(0.5));
        upper.fill(black_box(0.75));
    };
    run.least("one of 1000000 cells", measure(least).0 / cells as f64);
    let name = "one of 1000000 cells";
    println!("{{\"case\": \"{name}\", \"seconds\": {:e}, \"answer\": \"{path}\"}}", seconds / cells as f64);
}

fn prime() -> Natural {
    Natural::power_of_2(127) - Natural::ONE
}

/// `floor(x·10^places)` modulo the prime that long answers are compared by.
fn remainder(x: &Real, places: u64) -> String {
    let text = Decimal::of_real(x, Digits::Places(places), Rounding::Down).unwrap().0.to_string();
    let digits: String = text.chars().filter(char::is_ascii_digit).collect();
    (Natural::from_str(&digits).unwrap() % prime()).to_string()
}

fn digits(run: &Run) {
    let r = positive(Rational::from(10));
    let e = Restitutions::Same(restitution(Rational::from_unsigneds(9u32, 10)));
    let (eta, l) = (transfer::optimal(&r, &e, 7).unwrap(), threshold(&r, 7).unwrap());
    for count in [100u64, 150, 200, 600, 1_000, 10_000, 100_000, 1_000_000] {
        let bits = bits_of_digits(count);
        let answer = |x: &Real| remainder(x, count - SPARE);
        run.case(&format!("eta/{count}"), || eta.enclosure(black_box(bits)), |_| answer(&eta));
        run.case(&format!("L_7/{count}"), || l.enclosure(black_box(bits)), |_| answer(&l));
        // What the others are measured by.
        let all_bits = Natural::power_of_2(bits) - Natural::ONE;
        let (x, y) = (&all_bits / Natural::from(3u32), &all_bits / Natural::from(7u32));
        run.case(&format!("product/{count}"), || black_box(&x) * black_box(&y), |_| String::new());
    }
}

fn signs(run: &Run) {
    for line in run.text("J4.txt").lines() {
        let [case, n, e, r] = line.split(' ').collect::<Vec<_>>().try_into().unwrap();
        let n: u64 = n.parse().unwrap();
        let (e, r) = (restitution(rational::parse(e).unwrap()), positive(rational::parse(r).unwrap()));
        let sign = |answer: Helps| match answer {
            Helps::Yes => "1",
            Helps::No => "-1",
            Helps::OnTheThreshold => "0",
        };
        run.case(case, || helps(black_box(&e), black_box(&r), n).unwrap().0, |h| sign(h).to_owned());
    }
}

/// The claim `L_(n+1) >= L_n` as a user writes it.
fn rising(n: u64) -> String {
    let power = |k: u64| format!("(m1^(1/{k}) + m2^(1/{k}))^{k}");
    let (a, b, c) = (power(n), power(n + 1), power(n + 2));
    format!("claim grow \"The bound rises\"\ngiven m1, m2 > 0\nprove {c}/{b} - 1 >= {b}/{a} - 1\n")
}

fn growth(run: &Run) {
    for n in 1..=24 {
        let text = rising(n);
        let proved = || audit(&["grow"], parse(&text).unwrap());
        // The exponents of the polynomial grow like n², and the kernel has a limit for them.
        if !proved() {
            break;
        }
        run.case(&n.to_string(), proved, |proved| proved.to_string());
    }
}

fn chain(run: &Run, bodies: usize) -> Pass {
    let rows: Vec<[u64; 4]> = run
        .text(&format!("J6-{bodies}.txt"))
        .lines()
        .map(|line| {
            let words: Vec<u64> = line.split(' ').map(|w| w.parse().unwrap()).collect();
            words.try_into().unwrap()
        })
        .collect();
    let masses = rows.iter().map(|w| positive(Rational::from_unsigneds(w[0], w[1]))).collect();
    let e = rows[1..].iter().map(|w| restitution(Rational::from_unsigneds(w[2], w[3]))).collect();
    Pass::from_rest(masses, Restitutions::Each(e), Rational::ONE).unwrap()
}

fn long_chains(run: &Run) {
    let modulo = |above: &Natural, below: &Natural| (above % prime(), below % prime());
    let parts = |v: &Fraction| {
        let (up, down) = modulo(v.numerator(), v.denominator());
        (if v.is_negative() { prime() - up } else { up }, down)
    };
    let all = |list: Vec<Fraction>| {
        let sum: Natural = (1u64..)
            .zip(&list)
            .map(|(i, v)| (parts(v), i))
            .fold(Natural::from(0u32), |sum, ((p, q), i)| sum + Natural::from(i) * (p + Natural::from(3u32) * q));
        (sum % prime()).to_string()
    };
    if run.wanted.is_empty() || run.wanted.iter().any(|w| w == "all/1000") {
        let pass = chain(run, 1_000);
        run.case("all/1000", || pass.velocities_from_rest().unwrap(), all);
        // Each velocity differs from the one before by short factors: a long number by a short one, above and below.
        let found = pass.velocities_from_rest().unwrap();
        let short = Natural::from(u64::MAX);
        let least = || found.iter().map(|v| (v.numerator() * &short, v.denominator() * &short)).collect::<Vec<_>>();
        run.least("all/1000", measure(least).0);
    }
    for bodies in [100, 1_000, 10_000, 100_000, 1_000_000] {
        let name = format!("last/{bodies}");
        if !run.wanted.is_empty() && !run.wanted.contains(&name) {
            continue;
        }
        let pass = chain(run, bodies);
        run.case(
            &name,
            || pass.last_velocity().unwrap(),
            |v| {
                let (p, q) = modulo(v.numerator(), v.denominator());
                format!("{p}/{q}")
            },
        );
        // Numerator and denominator are products: the last one is of two numbers of half the length.
        let v = pass.last_velocity().unwrap();
        let halves = [v.numerator(), v.denominator()].map(|x| (x >> (x.significant_bits() / 2), x.clone()));
        let halves = halves.map(|(high, x)| (x.mod_power_of_2(high.significant_bits()), high));
        let least = || halves.each_ref().map(|(low, high)| low * high);
        run.least(&name, measure(least).0);
    }
}

fn best_numbers(run: &Run) {
    for line in run.text("J7.txt").lines() {
        let [case, r, e] = line.split(' ').collect::<Vec<_>>().try_into().unwrap();
        let (r, e) = (positive(rational::parse(r).unwrap()), restitution(rational::parse(e).unwrap()));
        let count = |found: Best| match found {
            Best::Finite { count, tie: false } => count.to_string(),
            other => format!("{other:?}"),
        };
        run.case(case, || best(black_box(&r), black_box(&e)).unwrap().0, count);
    }
}

/// A line of bodies from its file.
fn line(run: &Run, bodies: u64) -> Line {
    let rows: Vec<[i64; 7]> = run
        .text(&format!("J9-{bodies}.txt"))
        .lines()
        .map(|line| line.split(' ').map(|w| w.parse().unwrap()).collect::<Vec<_>>().try_into().unwrap())
        .collect();
    let body = |w: &[i64; 7]| Body {
        mass: Rational::from(w[0]),
        position: Rational::from_signeds(w[1], w[2]),
        velocity: Rational::from_signeds(w[3], w[4]),
        length: Rational::from(0),
    };
    let e: Vec<Rational> = rows[..rows.len() - 1].iter().map(|w| Rational::from_signeds(w[5], w[6])).collect();
    Line::new(&rows.iter().map(body).collect::<Vec<_>>(), &e, None, None).unwrap()
}

/// Up to ten collisions a body; their number and the sum of the places of their pairs is the answer. Order and number are
/// certified; with exact values, each collision is checked exactly too, and the values at the end are.
fn replays(run: &Run, exact: bool) {
    for bodies in [10u64, 100, 1_000, 10_000] {
        let name = bodies.to_string();
        if !run.wanted.is_empty() && !run.wanted.contains(&name) {
            continue;
        }
        let line = line(run, bodies);
        let options = |list| Options { max_events: 10 * bodies, list, ..Options::default() };
        let unlisted = options(0);
        let (seconds, count) = if exact {
            measure(|| replay(&line, &unlisted).unwrap().count)
        } else {
            measure(|| follow(&line, &unlisted).unwrap().count().unwrap())
        };
        let found = replay(&line, &options(10 * bodies as usize)).unwrap();
        let sum: usize = found.events.iter().map(|event| event.pair).sum();
        let per = seconds / count as f64;
        println!("{{\"case\": \"{name}\", \"seconds\": {per:e}, \"answer\": \"{count} {sum}\"}}");
    }
}

/// Work beyond the jobs, for the curves of `benches/results/growth.md`.
fn growing(run: &Run) {
    let ten = positive(Rational::from(10));
    let nine = restitution(Rational::from_unsigneds(9u32, 10));
    let same = Restitutions::Same(nine.clone());
    for k in 3..=13u32 {
        let cells = 1usize << k;
        let e: Vec<f64> = (0..cells).map(|i| i as f64 / cells as f64).collect();
        let mut out = vec![(0.0, 0.0); cells];
        let (r, n) = (vec![10.0; cells], vec![8; cells]);
        run.case(&format!("scattered cells/{cells}"), || fast::etas(&e, &r, &n, &mut out), |()| String::new());
        let side = 1usize << (k / 2 + 2);
        let ends = vec![0.5; side];
        let (mut lower, mut upper) = (vec![0.0; side * side], vec![0.0; side * side]);
        if k % 2 == 1 {
            let table = || {
                let (a, b) = (fast::Factors::of_restitutions(&ends, 8), fast::Factors::of_ratios(&ends, 8));
                fast::grid(&a, &b, &mut lower, &mut upper);
            };
            run.case(&format!("grid cells/{}", side * side), table, |()| String::new());
        }
    }
    for k in 0..=30u32 {
        let n = 1u64 << k;
        run.case(
            &format!("eta, n/{n}"),
            || transfer::optimal(&ten, &same, n).unwrap().enclosure(128),
            |_| String::new(),
        );
        run.case(&format!("sign of e - L_n, n/{n}"), || helps(&nine, &ten, n).unwrap().0, |_| String::new());
    }
    for k in 0..=6u32 {
        let degree = 1u64 << k;
        let text = format!("claim g \"g\"\ngiven a, b > 0\nprove (a + b)^{degree}*(a - b)^2*(a + 2*b) = ({})\n", {
            let powers = (0..=degree).map(|i| format!("{}*a^{}*b^{i}", binomial(degree, i), degree - i));
            format!("({})*(a^3 - 3*a*b^2 + 2*b^3)", powers.collect::<Vec<_>>().join(" + "))
        });
        run.case(&format!("identity, degree/{degree}"), || audit(&["g"], parse(&text).unwrap()), |ok| ok.to_string());
    }
}

fn binomial(n: u64, k: u64) -> Natural {
    (0..k).fold(Natural::ONE, |c, i| c * Natural::from(n - i) / Natural::from(i + 1))
}

fn main() {
    let mut arguments = std::env::args().skip(1);
    let (Some(job), Some(work)) = (arguments.next(), arguments.next()) else {
        eprintln!("usage: peers JOB WORK [CASE…]; JOB is J1, J2a, J2b, J3, J4, J5, J6, J7, J9, J9-exact or growth");
        std::process::exit(2);
    };
    let run = Run { work: Path::new(&work).to_owned(), wanted: arguments.collect() };
    match job.as_str() {
        "J1" => identities(&run),
        "J2a" => scattered(&run),
        "J2b" => grid(&run),
        "J3" => digits(&run),
        "J4" => signs(&run),
        "J5" => growth(&run),
        "J6" => long_chains(&run),
        "J7" => best_numbers(&run),
        "J9" => replays(&run, false),
        "J9-exact" => replays(&run, true),
        "growth" => growing(&run),
        other => {
            eprintln!("no job is called {other}");
            std::process::exit(2);
        }
    }
}
