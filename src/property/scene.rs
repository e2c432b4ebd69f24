//! A chain as a scene file that `carom eval` reads.

use carom_physics::chain::Restitution;
use carom_physics::chain::uncertain::Range;
use carom_physics::scene::{Chain, Inserted, Start};
use malachite::Rational;

/// The text of the file: remarks, what is wanted, the chain.
#[must_use]
pub fn write(chain: &Chain, remarks: &[String], want: &[&str]) -> String {
    let mut out: String = remarks.iter().flat_map(|r| r.lines()).map(|line| format!("# {line}\n")).collect();
    let names: Vec<String> = want.iter().map(|name| format!("\"{name}\"")).collect();
    out.push_str(&format!("want = [{}]\n\n[chain]\n", names.join(", ")));
    out.push_str(&format!("first = {}\n", range(chain.first(), |m| m.value())));
    match chain.inserted() {
        Inserted::Optimal(n) => out.push_str(&format!("inserted = {n}\n")),
        Inserted::Given(list) => {
            let list: Vec<String> = list.iter().map(|m| range(m, |m| m.value())).collect();
            out.push_str(&format!("inserted = [{}]\n", list.join(", ")));
        }
    }
    out.push_str(&format!("last = {}\n", range(chain.last(), |m| m.value())));
    let e = |e: &Range<Restitution>| range(e, |e| e.value());
    let coefficients = match chain.coefficients() {
        carom_physics::scene::Coefficients::Same(one) => e(one),
        carom_physics::scene::Coefficients::Each(list) => {
            format!("[{}]", list.iter().map(e).collect::<Vec<_>>().join(", "))
        }
    };
    out.push_str(&format!("restitution = {coefficients}\n"));
    match chain.start() {
        Start::Speed(speed) => out.push_str(&format!("speed = \"{speed}\"\n")),
        Start::Velocities(list) => {
            let list: Vec<String> = list.iter().map(|v| format!("\"{v}\"")).collect();
            out.push_str(&format!("velocities = [{}]\n", list.join(", ")));
        }
    }
    out
}

/// A number, or a range of them.
fn range<T: Clone + PartialOrd>(range: &Range<T>, value: impl Fn(&T) -> &Rational) -> String {
    match range.single() {
        Some(single) => format!("\"{}\"", value(single)),
        None => format!("\"[{}, {}]\"", value(range.lo()), value(range.hi())),
    }
}
