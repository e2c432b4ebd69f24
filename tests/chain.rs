//! The chain's numbers: known values, laws, and the statements of `proofs/` evaluated beside the code.

use carom::chain::best::{Best, best};
use carom::chain::optimum::Optimum;
use carom::chain::pass::Pass;
use carom::chain::threshold::{Helps, helps, threshold};
use carom::chain::{Positive, Restitution, Restitutions, recollision, transfer};
use carom::number::decimal::{Decimal, Digits, Rounding};
use carom::number::rational::parse;
use carom::number::real::Real;
use malachite::{Natural, Rational};

fn q(text: &str) -> Rational {
    parse(text).unwrap()
}

fn mass(text: &str) -> Positive {
    Positive::new(q(text)).unwrap()
}

fn e(text: &str) -> Restitution {
    Restitution::new(q(text)).unwrap()
}

fn digits(x: &Real, count: u64) -> String {
    Decimal::of_real(x, Digits::Significant(count), Rounding::Nearest).unwrap().0.to_string()
}

#[test]
fn known_values() {
    let eta = transfer::optimal(&mass("10"), &Restitutions::Same(e("9/10")), 7).unwrap();
    eprintln!("{}", digits(&eta, 15));
    eprintln!("{}", digits(&eta, 60));
    let l2 = threshold(&mass("64"), 2).unwrap();
    assert_eq!(l2.as_rational(), Some(&q("44/81")));
    let l3 = threshold(&mass("64"), 3).unwrap();
    eprintln!("{}", digits(&l3, 40));
    assert_eq!(helps(&e("44/81"), &mass("64"), 2).unwrap().0, Helps::OnTheThreshold);
    eprintln!("{:?}", best(&mass("64"), &e("44/81")).unwrap());
    eprintln!("{:?}", best(&mass("10"), &e("9/10")).unwrap());
    eprintln!("{:?}", best(&mass("1e10"), &e("0.9999999999999999")).unwrap());
    eprintln!("{:?}", best(&mass("1e10"), &e(&format!("0.{}", "9".repeat(200)))).unwrap());
}
