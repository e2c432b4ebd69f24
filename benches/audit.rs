//! The audit as a whole and one claim for each kind of argument, in this process.

use carom::claim::embedded;
use carom::prove::catalogue::{Catalogue, Limits};
use criterion::{Criterion, criterion_group, criterion_main};

fn audit(only: &[&str]) -> usize {
    let only: Vec<String> = only.iter().map(|s| s.to_string()).collect();
    let claims = embedded::claims(&only).expect("it parses").expect("all there");
    let names: Vec<String> = claims.iter().map(|c| c.name.text.clone()).collect();
    let mut catalogue = Catalogue::new(claims).expect("in order");
    for name in &names {
        catalogue.audit(name, &Limits::default()).expect("it makes sense");
    }
    catalogue.work()
}

fn benches(c: &mut Criterion) {
    let mut group = c.benchmark_group("audit");
    group.sample_size(10);
    group.bench_function("catalogue", |b| b.iter(|| audit(&[])));
    for (kind, name) in [
        ("identity", "eq13"),
        ("elimination", "eq05"),
        ("equivalence", "eq19"),
        ("extremum", "eq14"),
        ("induction", "eq22"),
        ("mean-inequality", "b-grow-bounded"),
        ("limit", "b-limit-inelastic"),
        ("search", "p-final"),
    ] {
        group.bench_function(format!("{kind}/{name}"), |b| b.iter(|| audit(&[name])));
    }
    group.finish();
}

criterion_group!(all, benches);
criterion_main!(all);
