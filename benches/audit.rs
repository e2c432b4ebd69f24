//! The audit as a whole and claims for each kind of argument, in this process.

use carom::claim::embedded;
use carom::judge::hand::AtHand;
use carom::judge::{Settings, judge};
use carom::refute::catalogue::Catalogue;
use criterion::{Criterion, criterion_group, criterion_main};

fn audit(only: &[&str]) -> usize {
    let only: Vec<String> = only.iter().map(|s| s.to_string()).collect();
    let claims = embedded::claims(&only).expect("it parses").expect("all there");
    let names: Vec<String> = claims.iter().map(|c| c.name.text.clone()).collect();
    let catalogue = Catalogue::new(claims).expect("in order");
    judge(&catalogue, &names, &AtHand::default(), &Settings::default(), &|_| {}).judged
}

/// Claims by the rule that carries their argument; what a claim cites is judged with it.
const METHODS: &[(&str, &[&str])] = &[
    ("identity", &["eq13", "b-closed"]),
    ("elimination", &["eq05", "eq07"]),
    ("equivalence", &["eq19", "b-best"]),
    ("extremum", &["eq11", "eq14"]),
    ("sign", &["p-order", "u6"]),
    ("induction", &["eq22", "b-budget"]),
    ("power", &["b-final"]),
    ("mean-inequality", &["b-grow", "b-grow-bounded"]),
    ("instance", &["b-global", "b-power"]),
    ("limit", &["b-limit-inelastic", "b-grow-limit"]),
    ("witness", &["p-frame-energy"]),
    ("search", &["p-final", "eq18-extracted"]),
    ("definedness", &["eq20-extracted"]),
];

fn benches(c: &mut Criterion) {
    let mut group = c.benchmark_group("audit");
    group.sample_size(10);
    group.bench_function("catalogue", |b| b.iter(|| audit(&[])));
    group.finish();
    for (method, names) in METHODS {
        let mut group = c.benchmark_group(*method);
        group.sample_size(10);
        for name in *names {
            group.bench_function(*name, |b| b.iter(|| audit(&[name])));
        }
        group.finish();
    }
}

criterion_group!(all, benches);
criterion_main!(all);
