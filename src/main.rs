//! The `carom` command.
use carom::claim::parse::parse;
use carom::prove::catalogue::{Catalogue, Limits};
fn main() { std::thread::Builder::new().stack_size(256<<20).spawn(run).unwrap().join().unwrap() }
fn run() {
    let mut claims = Vec::new();
    for f in std::env::args().skip(1) {
        let s = std::fs::read_to_string(&f).unwrap();
        match parse(&s) {
            Ok(c) => claims.extend(c),
            Err(d) => for d in d { println!("{}", d.render(&f, &s, false)); },
        }
    }
    let mut cat = match Catalogue::new(claims) { Ok(c) => c, Err(e) => { for (n, d) in e { println!("{n}: {}", d.message()); } return; } };
    let names: Vec<_> = cat.claims().iter().map(|c| (c.name.text.clone(), c.expect)).collect();
    for (n, x) in names {
        let t = std::time::Instant::now();
        match cat.audit(&n, &Limits::default()) {
            Ok(o) => println!("{}{:22} {:10} {:16} {:>7.2?} {} {}", if o.verdict.is_expected(x) {"  "} else {"!!"}, n, o.verdict.name(), o.method, t.elapsed(), o.reason.unwrap_or_default(), o.witness.map(|w| format!("{:?}", w.point.values)).unwrap_or_default()),
            Err(f) => println!("!!{n:22} FAULT {f:?}"),
        }
    }
}
