//! One claim or two for each method, and false neighbours of them.

use super::certificate;
use crate::claim::parse::parse;
use crate::refute::catalogue::Limits;

fn is_shown(body: &str) -> bool {
    let claims = parse(&format!("claim trial \"A trial\"\n{body}\n")).unwrap_or_default();
    let worker = std::thread::Builder::new().stack_size(64 << 20);
    let found =
        worker.spawn(move || claims.first().is_some_and(|claim| certificate(claim, &[], &Limits::default()).is_ok()));
    found.ok().and_then(|thread| thread.join().ok()).unwrap_or_default()
}

/// Each of these is shown.
fn all_are_shown(list: &[&str]) {
    let open: Vec<&&str> = list.iter().filter(|body| !is_shown(body)).collect();
    assert!(open.is_empty(), "not shown: {open:#?}");
}

#[test]
fn products_of_facts_and_squares_are_weighed() {
    all_are_shown(&[
        "given x, y real\nprove (x - 3)^2 + (y - 2)^2 >= 0",
        "given E, m > 0;  p real\nassume E^2 = p^2 + m^2\nprove E > p",
        "given x, y real\nprove x^4 + y^4 >= x^3*y + x*y^3",
        "given a, b real\nassume a^2 + b^2 <= 0\nprove a = 0",
    ]);
}

#[test]
fn sums_of_squares_need_multipliers_hypotheses_and_equations() {
    all_are_shown(&[
        "given x, y real\nprove x^4*y^2 + x^2*y^4 + 1 >= 3*x^2*y^2",
        "given x, y, z real\nprove x^4*y^2 + y^4*z^2 + z^4*x^2 >= 3*x^2*y^2*z^2",
        "given x, y, z real\nprove x^4 + y^4 + z^4 - 4*x*y*z + x + y + z + 3 > 1/7",
        "given x, y real\nassume x^2 + y^2 <= 1\nprove x + 2*y <= 9/4",
        "given a, b, c real\nassume a^2 + b^2 + c^2 = a*b + b*c + c*a\nprove a = b",
    ]);
    assert!(!is_shown("given x, y real\nprove x^4*y^2 + x^2*y^4 + 1 >= 3.01*x^2*y^2"));
    assert!(!is_shown("given x, y real\nassume x^2 + y^2 <= 1\nprove x + 2*y <= 2"));
}

#[test]
fn roots_are_known_by_their_powers_and_bounds() {
    all_are_shown(&[
        "given p, m real\nprove sqrt(p^2 + m^2) >= p",
        "given x real\nprove (2 - sqrt(3))^2 = 7 - 4*sqrt(3)",
        "given v in (-1, 1)\nprove sqrt(1 - v^2) <= 1",
        "given x real\nprove sqrt(2) + sqrt(3) < sqrt(10)",
        "given p real;  m > 0\nassume p != 0\nprove sqrt(p^2 + m^2) - m < p^2/(2*m)",
    ]);
}

#[test]
fn absolute_values_are_told_by_signs() {
    all_are_shown(&[
        "given x, y real\nprove |x + y| <= |x| + |y|",
        "given x, y real\nprove ||x| - |y|| <= |x - y|",
        "given a, b real\nprove |a - b| = max(a, b) - min(a, b)",
        "given x real;  r in (0, 1)\nprove |r*x| <= |x|",
    ]);
}

#[test]
fn induction_needs_no_hint() {
    all_are_shown(&[
        "given n natural >= 1\nprove sum(i = 1..n, i^2) = n*(n + 1)*(2*n + 1)/6",
        "given n natural\nprove 2^n >= n + 1",
    ]);
}

#[test]
fn products_are_continued_whatever_the_sign_of_their_members() {
    all_are_shown(&[
        // Which of n - i and i - n the kernel writes may not depend on what it read before.
        "given k natural;  n, X real\nassume product(i = 1..k, n - i) = X\nprove product(i = 1..k + 1, n - i) = X*(n - 1 - k)",
        "given n, k natural\nprove binomial(n + 1, k + 1) = binomial(n, k) + binomial(n, k + 1)",
        "given n natural;  u(k) in [0, 1]\nprove product(i = 1..n, 1 - u(i)) >= 1 - sum(i = 1..n, u(i))",
    ]);
}

#[test]
fn facts_for_all_indices_are_put_to_use() {
    all_are_shown(&["given d(k) real\nassume for all k natural: d(k + 1) = 2*d(k)\nprove d(3) = 8*d(0)"]);
}

#[test]
fn whole_numbers_have_gaps() {
    all_are_shown(&["given n natural\nassume n > 0\nprove n >= 1", "given n natural\nprove n*(n - 1) >= 0"]);
}

#[test]
fn an_integer_is_a_real_number_and_whole() {
    all_are_shown(&[
        "given a, b, c, x integer\nassume a*x^2 + b*x + c = 0\nprove b^2 >= 4*a*c",
        "given x, y integer\nprove not (2*x + 2*y = 1)",
        "given n natural\nassume n - 8*floor(n/8) = 7\nprove n - 4*floor(n/4) = 3",
    ]);
}

#[test]
fn a_witness_may_depend_on_variables_and_cases() {
    all_are_shown(&[
        "given x, y real\nprove exists z real: z > x and z > y",
        "prove for all x, y real: x < y => (exists z real: x < z and z < y)",
        "given b real\nprove not (for all x real: x <= b)",
    ]);
}

#[test]
fn facts_for_all_real_numbers_have_instances() {
    all_are_shown(&["given a, b real\nassume for all x real: a*x + b = 2*x + 3\nprove a = 2 and b = 3"]);
}

#[test]
fn logarithms_of_facts_give_exponents() {
    all_are_shown(&[
        "given x real\nassume 10^x*100^(2*x) = 1000^5\nprove x = 3",
        "given x real\nassume 2^x < 8\nprove x < 3",
    ]);
}

#[test]
fn exponentials_and_means_have_their_bounds() {
    all_are_shown(&[
        "given x > 0\nprove exp(x) > 1",
        "given a, b > 0\nassume ln(a) < ln(b)\nprove a < b",
        "given a, b > 0;  p in [0, 1]\nprove a^(1 - p)*b^p <= (1 - p)*a + p*b",
    ]);
}

#[test]
fn limits_are_squeezed() {
    all_are_shown(&[
        "given n natural;  r in (0, 1)\nprove limit of r^n as n -> infinity is 0",
        "given n natural\nprove limit of sqrt(n^2 + n) - n as n -> infinity is 1/2",
    ]);
}

#[test]
fn nothing_false_is_shown() {
    let shown: Vec<&&str> = [
        "given x, y real\nprove x^4 + y^4 >= 2*x^3*y",
        "given p, m real\nprove sqrt(p^2 + m^2) > p",
        "given n natural\nprove 2^n >= n + 2",
        "given x, y integer\nprove not (2*x + 3*y = 1)",
        "given n natural\nassume n - 8*floor(n/8) = 7\nprove n - 5*floor(n/5) = 3",
        "given x, y real\nprove exists z real: x < z and z < y",
        "given a, b real\nassume for all x > 0: a*x + b >= 0\nprove b > 0",
        "given x real\nassume 2^x < 8\nprove x < 2",
        "given k natural\nassume k*k = 5*k\nprove k = 0",
        "given n natural;  r in (0, 1]\nprove limit of r^n as n -> infinity is 0",
    ]
    .iter()
    .filter(|body| is_shown(body))
    .collect();
    assert!(shown.is_empty(), "{shown:#?}");
}

#[test]
fn integrals_that_are_arcs_are_found() {
    all_are_shown(&[
        "prove integral(x = 0..1, 1/(x^2 + x + 1)) = pi/(3*sqrt(3))",
        "prove integral(x = 0..1, sqrt(1 - x^2)) = pi/4",
        "prove integral(x = 0..1, x/(1 + x^4)) = pi/8",
        "given a, b > 0\nprove integral(x = 0..b, 1/(a^2 + x^2)) = arctan(b/a)/a",
    ]);
}

#[test]
fn an_integral_ends_at_a_symbolic_bound_below_its_pole() {
    all_are_shown(&[
        "given m, b, T > 0\nassume b*T < m\nprove integral(t = 0..T, b/(m - b*t)) = ln(m/(m - b*T))",
        "given a > 0; c in (0, a)\nprove integral(s = 0..c, 1/(a^2 - s^2)) = ln((a + c)/(a - c))/(2*a)",
    ]);
}
