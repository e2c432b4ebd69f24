//! Tables: every digit against an independent computation, every form, somebody's table judged, and runs
//! that are interrupted and resumed.

use crate::support::{carom, for_nobody, text};
use carom::number::decimal::{Decimal, Digits, Rounding};
use carom::number::rational::parse;
use carom::table::grid::Grid;
use carom::table::shared::Factors;
use carom::table::{Found, Plan, Printing, Quantity};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::{Abs, Pow};
use proptest::prelude::*;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

fn q(text: &str) -> Rational {
    parse(text).expect("a number")
}

/// Rational bounds of `r^(1/k)`, by halving: nothing of the program's roots is used.
fn root(r: &Rational, k: u64, steps: u32) -> (Rational, Rational) {
    let one = Rational::from(1);
    let (mut low, mut high) = (Rational::from(0), if *r > one { r.clone() } else { one });
    for _ in 0..steps {
        let middle = (&low + &high) / Rational::from(2);
        if (&middle).pow(k) <= *r { low = middle } else { high = middle }
    }
    (low, high)
}

/// Rational bounds of (25).
fn eta(r: &Rational, e: &Rational, n: u64) -> (Rational, Rational) {
    let (low, high) = root(r, n + 1, 100);
    let gain = (Rational::from(1) + e).pow(2 * (n + 1)) * r;
    let at = |t: Rational| &gain / (Rational::from(1) + t).pow(2 * (n + 1));
    (at(high), at(low))
}

/// Rational bounds of (19).
fn threshold(r: &Rational, n: u64) -> (Rational, Rational) {
    let (a, b) = (root(r, n + 1, 100), root(r, n, 100));
    let one = || Rational::from(1);
    let at = |a: Rational, b: Rational| (one() + a).pow(n + 1) / (one() + b).pow(n) - one();
    (at(a.0, b.1), at(a.1, b.0))
}

fn plan(quantity: Quantity, ratio: &str, e: Option<&str>, n: Option<&str>, digits: Digits, rounding: Rounding) -> Plan {
    let grid = |text: &str| Grid::parse(text).expect(text);
    Plan::new(quantity, grid(ratio), e.map(grid), n.map(grid), Printing { digits, rounding, extra: 0 }).expect("a plan")
}

/// Checks each row against bounds: the printed decimal is a correct rounding of both.
fn check(plan: &Plan, bounds: impl Fn(u64) -> (Rational, Rational)) {
    let mut factors = Factors::new(plan);
    for row in 0..plan.rows() {
        let found = factors.value(row).expect("no limit");
        let (line, enclosure) = plan.row(row, found).expect("no limit");
        let (low, high) = bounds(row);
        let (printed, enclosure) = (q(&line.value), enclosure.expect("a number has one"));
        let Printing { digits, rounding, .. } = plan.printing();
        let unit = match digits {
            Digits::Places(p) => Rational::from(10).pow(-i64::try_from(p).expect("small")),
            Digits::Significant(d) => {
                // One unit of the last of d digits of the value, from the printed text itself.
                let (mantissa, exponent) = line.value.split_once('e').unwrap_or((&line.value, "0"));
                let places = mantissa.split_once('.').map_or(0, |m| m.1.len() as i64);
                let digits = mantissa.trim_start_matches(['0', '.']).replace('.', "").len() as u64;
                assert_eq!(digits, d, "{}", line.value);
                Rational::from(10).pow(exponent.parse::<i64>().expect("a number") - places)
            }
        };
        for end in [&low, &high] {
            let error = &printed - end;
            let slack = (&high - &low) * Rational::from(2);
            let right = match rounding {
                Rounding::Nearest => (&error).abs() <= &unit / Rational::from(2) + slack,
                Rounding::Up | Rounding::Away => error >= -&slack && error < &unit + slack,
                Rounding::Down | Rounding::Zero => error <= slack && error > -&unit - slack,
            };
            assert!(right, "{}: {} is not {rounding:?} of {end}", plan.in_words(row), line.value);
        }
        let (lower, upper) = (end(enclosure.lower()), end(enclosure.upper()));
        assert!(lower <= high && low <= upper, "{}: the enclosure misses", plan.in_words(row));
        if let Some(exact) = &line.exact {
            assert!(low <= q(exact) && q(exact) <= high, "{}: {exact}", plan.in_words(row));
            assert_eq!(Decimal::of_rational(&q(exact), digits, rounding).expect("no limit").to_string(), line.value);
        } else {
            for end in [lower, upper] {
                assert_eq!(Decimal::of_rational(&end, digits, rounding).expect("no limit").to_string(), line.value);
            }
        }
    }
}

fn end(end: Option<(malachite::Integer, i64)>) -> Rational {
    let (mantissa, exponent) = end.expect("bounded");
    Rational::from(mantissa) * Rational::from(2).pow(exponent)
}

#[test]
fn every_cell_is_the_correct_rounding_of_an_independent_enclosure() {
    let (ratio, e, n) = ("1/7,1,64,10,1e6,3.7", "0,0.35,0.9,1", "0:4:1");
    // The oracle is slow: once for each value.
    let table = plan(Quantity::Eta, ratio, Some(e), Some(n), Digits::Places(1), Rounding::Nearest);
    let shares: Vec<_> = (0..table.rows())
        .filter_map(|row| table.place(row))
        .map(|p| eta(p.ratio.value(), p.e.as_ref().expect("given").value(), p.n.expect("given")))
        .collect();
    let table = plan(Quantity::Threshold, ratio, None, Some("1:5:1"), Digits::Places(1), Rounding::Nearest);
    let bounds: Vec<_> = (0..table.rows())
        .filter_map(|row| table.place(row))
        .map(|p| threshold(p.ratio.value(), p.n.expect("given")))
        .collect();
    for rounding in Rounding::ALL {
        for digits in [Digits::Significant(1), Digits::Significant(6), Digits::Significant(17), Digits::Places(9)] {
            let table = plan(Quantity::Eta, ratio, Some(e), Some(n), digits, rounding);
            check(&table, |row| shares[row as usize].clone());
            let table = plan(Quantity::Threshold, ratio, None, Some("1:5:1"), digits, rounding);
            check(&table, |row| bounds[row as usize].clone());
        }
    }
}

#[test]
fn rows_cover_the_grid_once_with_the_last_axis_running_fastest() {
    let table = plan(Quantity::Eta, "3,5", Some("0,1/2,1"), Some("0:3:1"), Digits::Significant(3), Rounding::Nearest);
    assert_eq!(table.rows(), 24);
    let mut expected = Vec::new();
    for ratio in ["3", "5"] {
        for e in ["0", "1/2", "1"] {
            for n in ["0", "1", "2", "3"] {
                expected.push(vec![ratio.to_owned(), e.to_owned(), n.to_owned()]);
            }
        }
    }
    assert_eq!((0..24).map(|row| table.labels(row)).collect::<Vec<_>>(), expected);
    for (row, labels) in expected.iter().enumerate() {
        let place = table.place(row as u64).expect("in range");
        assert_eq!(place.ratio.value(), &q(&labels[0]));
        assert_eq!(place.e.map(|e| e.value().clone()), Some(q(&labels[1])));
        assert_eq!(place.n.map(Rational::from), Some(q(&labels[2])));
    }
    assert_eq!(table.place(24), None);
    let table = plan(Quantity::Threshold, "3,5", None, Some("1,2"), Digits::Significant(3), Rounding::Nearest);
    assert_eq!((0..4).map(|row| table.labels(row).join(" ")).collect::<Vec<_>>(), ["3 1", "3 2", "5 1", "5 2"]);
}

#[test]
fn the_best_number_is_where_the_greatest_share_is() {
    let table =
        plan(Quantity::BestN, "2,10,1/100,64", Some("0.5,0.9,44/81"), None, Digits::Significant(6), Rounding::Nearest);
    for row in 0..table.rows() {
        let place = table.place(row).expect("in range");
        let (line, _) = table.row(row, Found::Open(table.value(row).expect("no limit"))).expect("no limit");
        let best: u64 = line.value.parse().expect("finite");
        let share = |n| eta(place.ratio.value(), place.e.as_ref().expect("given").value(), n);
        for other in 0..best + 3 {
            assert!(share(best).1 >= share(other).0, "{}: {other} beats {best}", table.in_words(row));
        }
    }
}

/// A list without the numbers that it has already.
fn distinct(list: &str) -> String {
    let mut seen = std::collections::HashSet::new();
    list.split(',').filter(|x| seen.insert(q(x))).collect::<Vec<_>>().join(",")
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]
    #[test]
    fn shared_work_changes_no_row(
        p in 1u32..5000, r in 1u32..5000, e in 0u32..=100, n in 0u64..12, digits in 1u64..30, direction in 0usize..5
    ) {
        let ratio = distinct(&format!("{p}/{r},{r},1e-200,1e250"));
        let e = format!("{e}/100,1/3");
        let n = distinct(&format!("{n},1,{}", n * 7));
        let table = plan(Quantity::Eta, &ratio, Some(&e), Some(&n), Digits::Significant(digits), Rounding::ALL[direction]);
        let mut factors = Factors::new(&table);
        for row in 0..table.rows() {
            let shared = table.row(row, factors.value(row).expect("no limit")).expect("no limit").0;
            let alone = table.row(row, Found::Open(table.value(row).expect("no limit"))).expect("no limit").0;
            prop_assert_eq!(shared, alone);
        }
    }
}

const SMALL: [&str; 7] = ["table", "--ratio", "64;2", "-e", "0.9", "-n", "1,2"];

fn small(more: &[&str]) -> String {
    let out = carom(&[&SMALL[..], more].concat());
    assert_eq!(out.status.code(), Some(0), "{}", text(&out.stderr));
    text(&out.stdout)
}

#[test]
fn every_form_has_head_rows_and_the_certified_value() {
    for (form, signs) in [
        ("text", ["equation: (25)", "to nearest, ties to even", "carom 0.", "0.127123"]),
        ("csv", ["# equation: (25)", "ratio,e,n,eta,exact", "# program: carom", "64,0.9,1,0.127123,"]),
        ("json", ["\"equation\":\"(25)", "\"eta\":\"0.127123\"", "\"count\":4", "\"exact\":"]),
        ("markdown", ["- equation:", "| ratio | e | n | eta | exact |", "| --: |", "| 64 | 0.9 | 1 | 0.127123 |"]),
        ("latex", ["\\toprule", "S[table-format=1.6]", "round-mode = none", "64 & 0.9 & 1 & 0.127123 &"]),
    ] {
        let shown = small(&["--format", form]);
        for sign in signs {
            assert!(shown.contains(sign), "{form}: {sign}: {shown}");
        }
    }
    let value: serde_json::Value = serde_json::from_str(&small(&["--format", "json"])).expect("JSON");
    assert_eq!(value["rows"].as_array().map(Vec::len), Some(4));
}

#[test]
fn directions_places_and_further_digits() {
    let cell = |more: &[&str]| {
        let shown = small(&[&["--format", "csv"], more].concat());
        shown.lines().nth_back(2).expect("a row").split(',').skip(3).map(str::to_owned).collect::<Vec<_>>()
    };
    // 64 : 1, e = 9/10, n = 2: (19/10)^6·64/5^6, exactly 0.192699928576
    assert_eq!(cell(&["--digits", "12"]), ["0.192699928576", "47045881/244140625"]);
    assert_eq!(cell(&["--places", "3"])[0], "0.193");
    assert_eq!(cell(&["--places", "3", "--round", "down"])[0], "0.192");
    assert_eq!(cell(&["--digits", "2", "--round", "away"])[0], "0.20");
    assert_eq!(cell(&["--digits", "2", "--round", "zero"])[0], "0.19");
    assert_eq!(cell(&["--digits", "4", "--extra", "3"])[2..], ["0.1926999", "1e-7"]);
    assert_eq!(cell(&["--digits", "4", "--extra", "8"])[2..], ["0.192699928576", "0"]);
    let shown = small(&["--digits", "4", "--extra", "3", "--format", "latex"]);
    assert!(shown.contains("0.1926{\\scriptsize 999}"), "{shown}");
}

#[test]
fn a_value_next_to_a_decimal_is_rounded_without_a_search_for_ever() {
    // (1.58)^6 = 15.557597153344, and the value lies 10^-83 of itself below it.
    let started = std::time::Instant::now();
    for (round, value) in [("away", "1.5557597153344000e-249"), ("zero", "1.5557597153343999e-249")] {
        let out = carom(&["table", "--ratio", "1e250", "-e", "0.58", "-n", "2", "--digits", "17", "--round", round]);
        assert!(text(&out.stdout).contains(value), "{}", text(&out.stdout));
    }
    assert!(started.elapsed().as_secs() < 5);
}

#[test]
fn bad_tables_are_refused_with_what_would_be_right() {
    for (arguments, sign) in [
        (&["--ratio", "1"][..], "depends on e"),
        (&["--ratio", "1", "-e", "1"], "depends on n"),
        (&["--ratio", "1", "-e", "1", "-n", "1", "--want", "threshold"], "does not depend on e"),
        (&["--ratio", "0;1", "-e", "1", "-n", "1"], "above 0"),
        (&["--ratio", "1", "-e", "0:2:0.5", "-n", "1"], "from 0 to 1"),
        (&["--ratio", "1", "-e", "1", "-n", "1/2"], "whole numbers"),
        (&["--ratio", "1", "-n", "0", "--want", "threshold"], "at least 1"),
        (&["--ratio", "1:2", "-e", "1", "-n", "1"], "three parts"),
        (&["--ratio", "1", "-e", "1", "-n", "1", "--resume", "--output", "x.txt"], "--format csv"),
        (&["--ratio", "1", "-e", "1", "-n", "1", "--digits", "0"], "digit"),
        (&["--ratio", "2;10", "-e", "0.9", "--want", "best-n", "--extra", "2"], "no more digits"),
        (&["--ratio", "2,1,4/2", "-e", "1", "-n", "1"], "4/2 is given twice"),
        (&["--check", "/no/such.csv"], "cannot read"),
        (&[], "--ratio"),
    ] {
        let out = carom(&[&["table"], arguments].concat());
        assert_eq!(out.status.code(), Some(2), "{arguments:?}");
        assert!(text(&out.stderr).contains(sign), "{arguments:?}: {}", text(&out.stderr));
        assert!(!text(&out.stdout).contains("0."), "{arguments:?}: {}", text(&out.stdout));
    }
    let out = carom(&["table", "--ratio", "2", "-e", "1", "-n", "1", "--digits", "100000000"]);
    assert_eq!(out.status.code(), Some(3), "{}", text(&out.stderr));
    // What is wrong is said with its flag, and a number below 0 is a number.
    for (arguments, sign) in [
        (&["--ratio", "1"][..], "error: -e: eta depends on e"),
        (&["--ratio", "-1", "-e", "1", "-n", "1"], "error: --ratio: a ratio of masses is above 0, not -1"),
        (&["--ratio", "-1:1:1", "-e", "1", "-n", "1"], "error: --ratio: a ratio of masses is above 0, not -1"),
        (&["--ratio", "1", "-e", "-0.5", "-n", "1"], "error: -e: a restitution e lies from 0 to 1, not -1/2"),
        (&["--ratio", "1", "-e", "1", "-n", "-3"], "error: -n: a number n of inserted bodies is at least 0"),
        (&["--ratio", "1", "-e", "1", "-n", "1/2"], "error: -n: n is a number of bodies"),
        (&["--ratio", "1", "-e", "1", "-n", "1", "--want", "best-n"], "error: -n: best-n does not depend on n"),
    ] {
        let out = carom(&[&["table"], arguments].concat());
        assert_eq!(out.status.code(), Some(2), "{arguments:?}");
        assert!(text(&out.stderr).contains(sign), "{arguments:?}: {}", text(&out.stderr));
    }
}

#[test]
fn limits_are_told_from_bad_input() {
    for (ratio, n) in
        [("0:1:1e-30", "1"), ("1e99999", "1"), ("1:1e9999:x1.00000000000000000000000000001", "1"), ("1", "1e19")]
    {
        let out = carom(&["table", "--ratio", ratio, "-e", "1", "-n", n]);
        assert_eq!(out.status.code(), Some(3), "{ratio} {n}: {}", text(&out.stderr));
    }
    let long = format!("0.{}", "1".repeat(20_000));
    for (content, code, sign) in [
        ("ratio,e,n,eta\n1e99999,1,1,1\n", 3, "line 2: limit reached: exponent of a numeral"),
        ("ratio,e,n,eta\n1,1,1,1e99999\n", 3, "line 2: limit reached: exponent of a numeral"),
        (&format!("ratio,e,n,eta\n1,1,1,{long}\n"), 3, "line 2: limit reached: digits of a numeral"),
        ("ratio,e,n,eta\n1,1,1e19,1\n", 3, "line 2: limit reached: inserted bodies"),
        (
            &format!("ratio,e,best-n\n64,0.9,5.{}\n", "0".repeat(10_001)),
            3,
            "line 2: limit reached: digits of a numeral",
        ),
        ("ratio,n,threshold\n64,1/2,0.5\n", 2, "n is a number of bodies"),
    ] {
        let (found, _, said) = checked(content, &[]);
        assert_eq!(found, Some(code), "{said}");
        assert!(said.contains(sign), "{said}");
    }
}

fn checked(content: &str, more: &[&str]) -> (Option<i32>, String, String) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("table.csv");
    std::fs::write(&path, content).expect("written");
    let out = carom(&[&["table", "--check", &path.display().to_string()], more].concat());
    (out.status.code(), text(&out.stdout), text(&out.stderr))
}

#[test]
fn somebodys_table_is_judged_cell_by_cell() {
    let (code, shown, _) =
        checked("ratio,e,n,eta\n64,0.9,2,0.1927\n64,0.9,2,0.193\n64,9/10,2,47045881/244140625\n", &[]);
    assert_eq!(code, Some(0), "{shown}");
    assert!(shown.contains("3 cells: 3 right"), "{shown}");
    let content =
        "m1;m2;e;n;eta;threshold;remark\n64;1;0,9;2;0,1926;0,5432;cut off\n64;1;0,9;2;0,1937;;\n64;1;0,9;2;x;44/81;\n";
    let (code, shown, _) = checked(content, &[]);
    assert_eq!(code, Some(1));
    for sign in [
        "not rounded as requested: it is the value rounded down",
        "wrong from significant digit 3 on",
        "not a number",
        "0.1927",
        "5 cells: 2 right, 1 rounded otherwise, 1 wrong; 1 unreadable; 1 empty",
    ] {
        assert!(shown.contains(sign), "{sign}: {shown}");
    }
    let (code, shown, _) = checked("n,eta\n2,0.1926\n", &["--ratio", "64", "-e", "0.9", "--round", "down"]);
    assert_eq!(code, Some(0), "{shown}");
    let (code, shown, _) = checked("ratio,e,n,eta\n64,.9,2,.1927\n64,+.9,2,.193\n", &[]);
    assert_eq!(code, Some(0), "{shown}");
    assert!(shown.contains("   .1927 "), "as it is written: {shown}");
    // What could steer a terminal is shown by its number.
    for form in ["text", "csv", "markdown", "latex", "json"] {
        let (code, shown, _) = checked("ratio,e,n,eta\n64,.9,2,\u{1b}[31m\u{202e}x\u{7}\n", &["--format", form]);
        assert_eq!(code, Some(1), "{shown}");
        assert!(!shown.contains(['\u{1b}', '\u{7}']), "{form}: {shown:?}");
        assert!(form != "text" || shown.contains("\\u{1b}[31m\\u{202e}x\\u{7}"), "{shown}");
    }
    let (code, shown, _) = checked("ratio,e,best-n\n64,0.9,5\n64,1,inf\n", &[]);
    assert_eq!(code, Some(0), "{shown}");
    let (code, shown, _) = checked("ratio\te\tn\teta\tbest-n\n64\t0.9\t2\t19.27%\t80%\n64\t0.9\t2\t0,19\t5\n", &[]);
    assert_eq!(code, Some(1), "{shown}");
    assert!(shown.contains("4 cells: 3 right, 0 rounded otherwise, 1 wrong"), "{shown}");
    let (code, shown, _) = checked("ratio,e,best-n\n64,0.9,6\n", &["--format", "json"]);
    assert_eq!(code, Some(1));
    let value: serde_json::Value = serde_json::from_str(&shown).expect("JSON");
    assert_eq!(value["rows"][0]["certified"], "5");
}

#[test]
fn a_threshold_without_bodies_is_right_where_it_is_empty_and_a_tie_is_said() {
    let (code, shown, said) = checked("ratio,n,threshold\n4,0,\n4,1,0.8\n4,0,None\n4,1,\n", &[]);
    assert_eq!(code, Some(0), "{shown}{said}");
    assert!(shown.contains("3 cells: 3 right") && shown.contains("1 empty"), "{shown}");
    let (code, shown, _) = checked("ratio,n,threshold\n4,0,0.8\n4,1,none\n", &[]);
    assert_eq!(code, Some(1), "{shown}");
    assert!(shown.contains("0 right, 0 rounded otherwise, 1 wrong; 1 unreadable"), "{shown}");
    let (code, shown, _) = checked("ratio,e,best-n\n64,44/81,2\n64,44/81,1\n64,0.55,2\n", &[]);
    assert_eq!(code, Some(1), "{shown}");
    assert!(
        shown.contains("right; a tie: one body fewer") && shown.contains("wrong; a tie: one body fewer"),
        "{shown}"
    );
    assert_eq!(shown.matches("tie: ").count(), 2, "{shown}");
    let (_, shown, _) = checked("ratio,e,n,eta\n1,0,0,0.3\n64,0.9,2,0.1926\n", &[]);
    assert!(shown.contains("rounded up; a tie: the exact value lies midway") && shown.matches("midway").count() == 1);
}

#[test]
fn what_the_program_writes_it_finds_right() {
    for want in [&["--want", "threshold", "-n", "1,2,3"][..], &["--want", "eta", "-n", "0:3:1", "-e", "0.25:1:0.25"]] {
        for round in ["nearest-even", "up", "zero"] {
            let more = ["table", "--ratio", "1/9:100:x3", "--format", "csv", "--digits", "9", "--round", round];
            let table = text(&carom(&[&more, want].concat()).stdout);
            let (code, shown, _) = checked(&table, &["--round", round]);
            assert_eq!(code, Some(0), "{shown}");
            // One digit changed somewhere is always found.
            let changed = table.rsplitn(2, "0.").collect::<Vec<_>>();
            let (rest, before) = (changed[0], changed[1]);
            let digit = rest.as_bytes()[4];
            let other = char::from(if digit == b'9' { b'1' } else { digit + 1 });
            let (code, _, _) = checked(&format!("{before}0.{}{other}{}", &rest[..4], &rest[5..]), &["--round", round]);
            assert_eq!(code, Some(1));
        }
    }
}

#[test]
fn a_table_for_a_spreadsheet_has_no_date_in_it_and_is_found_right() {
    for (form, separator, start) in [("spreadsheet", ',', "9,1⁄2,"), ("spreadsheet-comma", ';', "9;1⁄2;")] {
        let flags = ["table", "--ratio", "1/3,9", "-e", "1/2,2/3", "-n", "0:2:1", "--format", form];
        let table = text(&carom(&flags).stdout);
        assert!(table.starts_with("\u{feff}ratio"), "{table}");
        assert!(!table.contains('#') && !table.contains('/'), "{table}");
        assert!(table.lines().any(|line| line.ends_with(&format!("{separator}1\u{2044}4"))), "1/4 is exact: {table}");
        assert!(table.lines().any(|line| line.starts_with(start)), "{table}");
        assert_eq!(table.contains("0,250000;"), separator == ';', "{table}");
        let (code, shown, said) = checked(&table, &[]);
        assert_eq!(code, Some(0), "{shown}{said}");
        assert!(shown.contains("12 cells: 12 right"), "{shown}");
        // A number changed by one in its last place is found.
        let at = table.rfind("\n9").expect("a row");
        let value = table[at + 1..].split(separator).nth(3).expect("eta").to_owned();
        let last = value.trim_end().chars().last().and_then(|c| c.to_digit(10)).expect("a digit");
        let other = format!("{}{}", &value[..value.len() - 1], (last + 1) % 10);
        let (code, shown, _) = checked(&format!("{}{}", &table[..at], table[at..].replace(&value, &other)), &[]);
        assert_eq!(code, Some(1), "{shown}");
    }
    let out = carom(&[
        "table",
        "--ratio",
        "2",
        "-e",
        "1/2,1/3",
        "-n",
        "0,1",
        "--across",
        "e",
        "--format",
        "spreadsheet-comma",
    ]);
    assert!(text(&out.stdout).contains("e = 1/2;e = 1/3"), "{}", text(&out.stdout));
    let (_, report, _) = checked("ratio,e,n,eta\n64,0.9,2,=1+1\n", &["--format", "spreadsheet"]);
    assert!(report.contains(",'=1+1,"), "a formula stays a text: {report}");
    let resumed =
        carom(&["table", "--ratio", "2", "-e", "1", "-n", "1", "--format", "spreadsheet", "--resume", "-o", "t.csv"]);
    assert!(text(&resumed.stderr).contains("--resume works with CSV only"), "{}", text(&resumed.stderr));
}

#[test]
fn tables_that_cannot_be_checked_say_why() {
    for (content, sign) in [
        ("", "no heading"),
        ("ratio,e,n\n1,1,1\n", "no column to check"),
        ("ratio,n,eta\n1,1,1\n", "no column e"),
        ("ratio,e,n,eta\n1,2,1,1\n", "line 2"),
        ("ratio,e,n,eta\nx,1,1,1\n", "\"x\" is not a number"),
        ("m1,m2,e,n,eta\n1,0,1,1,1\n", "m2 is 0"),
        ("ratio,e,n,eta\n1,1,1\n", "3 fields"),
        ("ratio,e,n,eta\n", "no cell"),
        (
            "m1,m2,ratio,e,n,eta\n2,1,10,0.9,7,0.373137511773739\n",
            "given twice: by the columns m1 and m2, and in a column",
        ),
    ] {
        let (code, _, said) = checked(content, &[]);
        assert_eq!(code, Some(2), "{content}: {said}");
        assert!(said.contains(sign), "{content}: {said}");
    }
    let (code, _, said) = checked("m1,m2,e,n,eta\n2,1,0.9,7,0.373137511773739\n", &["--ratio", "10"]);
    assert_eq!(code, Some(2), "{said}");
    assert!(said.contains("given twice: by the columns m1 and m2, and by --ratio"), "{said}");
}

#[test]
fn certificates_hold_an_enclosure_of_every_cell() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("cells.jsonl");
    small(&["--certificate", &path.display().to_string()]);
    let lines: Vec<serde_json::Value> = std::fs::read_to_string(&path)
        .expect("written")
        .lines()
        .map(|l| serde_json::from_str(l).expect("JSON"))
        .collect();
    assert_eq!((lines.len(), &lines[0]["certificate"]), (5, &"table".into()));
    for line in &lines[1..] {
        let get = |key: &str| q(line[key].as_str().expect(key));
        let end = |key: &str| {
            let mantissa = q(line[key]["mantissa"].as_str().expect(key));
            mantissa * Rational::from(2).pow(line[key]["exponent"].as_i64().expect(key))
        };
        let n: u64 = line["n"].as_str().expect("n").parse().expect("a number");
        let (low, high) = eta(&get("ratio"), &get("e"), n);
        assert!(end("lower") <= high && low <= end("upper"), "{line}");
        for end in [end("lower"), end("upper")] {
            let decimal = Decimal::of_rational(&end, Digits::Significant(6), Rounding::Nearest).expect("no limit");
            assert_eq!(decimal.to_string(), line["printed"], "{line}");
        }
    }
}

fn csv(folder: &Path, more: &[&str]) -> Vec<String> {
    let path = folder.join("table.csv").display().to_string();
    let base = ["table", "--ratio", "1:12:1", "-e", "0:1:0.05", "-n", "0:40:1", "--format", "csv", "--output", &path];
    base.iter().chain(more).map(|s| s.to_string()).collect()
}

fn run(arguments: &[String]) -> Output {
    carom(&arguments.iter().map(String::as_str).collect::<Vec<_>>())
}

/// A table and its certificate, the files in which an interrupted run leaves their rows, and the arguments that make them.
struct Growing {
    path: PathBuf,
    partial: PathBuf,
    certificate: PathBuf,
    grown: PathBuf,
    arguments: Vec<String>,
}

fn growing(folder: &Path) -> Growing {
    let certificate = folder.join("cells.jsonl");
    Growing {
        path: folder.join("table.csv"),
        partial: folder.join("table.csv.partial"),
        grown: folder.join("cells.jsonl.partial"),
        arguments: csv(folder, &["--certificate", &certificate.display().to_string()]),
        certificate,
    }
}

#[test]
fn a_run_that_was_cut_off_is_resumed_to_the_same_bytes() {
    let folder = tempfile::tempdir().expect("a folder");
    let Growing { path, partial, certificate, grown, arguments } = growing(folder.path());
    assert_eq!(run(&arguments).status.code(), Some(0));
    assert!(!partial.exists() && !grown.exists());
    let (whole, cells) = (std::fs::read(&path).expect("there"), std::fs::read(&certificate).expect("there"));
    let resume = [&arguments[..], &["--resume".to_owned()]].concat();
    // Cut inside a line, at different places of the two files; the last one inside the head.
    for (at, other) in [(whole.len() / 2, cells.len() / 3), (whole.len() / 3, cells.len() - 5), (40, 10)] {
        std::fs::write(&partial, &whole[..at]).expect("written");
        std::fs::write(&grown, &cells[..other]).expect("written");
        let out = run(&resume);
        assert_eq!(out.status.code(), Some(0), "{}", text(&out.stderr));
        assert!(std::fs::read(&path).expect("there") == whole && std::fs::read(&certificate).expect("there") == cells);
        assert!(!partial.exists() && !grown.exists());
    }
    std::fs::write(&partial, b"# another table\n1,2,3\n").expect("written");
    std::fs::write(&grown, &cells[..cells.len() / 3]).expect("written");
    let out = run(&resume);
    assert_eq!(out.status.code(), Some(2));
    assert!(text(&out.stderr).contains("other settings"), "{}", text(&out.stderr));
}

#[test]
fn rows_that_an_interrupted_run_left_are_lost_to_a_run_without_resume() {
    let folder = tempfile::tempdir().expect("a folder");
    let Growing { path, partial, certificate, grown, arguments } = growing(folder.path());
    for left in [&partial, &grown] {
        std::fs::write(left, "# the rows of many hours\n").expect("written");
        let out = run(&arguments);
        assert_eq!(out.status.code(), Some(2));
        let said = text(&out.stderr);
        assert!(said.contains(&left.display().to_string()) && said.contains("--resume"), "{said}");
        assert_eq!(std::fs::read_to_string(left).expect("there"), "# the rows of many hours\n");
        assert!(!path.exists() && !certificate.exists());
        std::fs::remove_file(left).expect("there");
    }
    // What was begun and has no row yet is no loss.
    std::fs::write(&partial, "").expect("written");
    assert_eq!(run(&arguments).status.code(), Some(0));
}

#[test]
fn what_an_earlier_run_left_is_gone_on_with_only_where_every_row_fits() {
    let folder = tempfile::tempdir().expect("a folder");
    let (path, partial) = (folder.path().join("u.csv"), folder.path().join("u.csv.partial"));
    let (certificate, grown) = (folder.path().join("u.jsonl"), folder.path().join("u.jsonl.partial"));
    let of = |grid: [&str; 3], more: &[&str]| {
        let [ratio, e, n] = grid;
        let (path, certificate) = (path.display().to_string(), certificate.display().to_string());
        let base = ["table", "--ratio", ratio, "-e", e, "-n", n, "--format", "csv", "--output", &path];
        carom(&[&base[..], &["--certificate", &certificate], more].concat())
    };
    let asked = ["500,600,700", "0.5,0.9", "3"];
    let made = |grid| {
        let out = of(grid, &[]);
        assert_eq!(out.status.code(), Some(0), "{}", text(&out.stderr));
        [&path, &certificate].map(|path| {
            let content = std::fs::read_to_string(path).expect("written");
            std::fs::remove_file(path).expect("there");
            content
        })
    };
    let (right, other) = (made(asked), made(["100,200,300", "0.5,0.9", "7"]));
    let shorter = made(["500,600", "0.5,0.9", "3"]);
    let longer = made(["500,600,700,800", "0.5,0.9", "3"]);
    let resumed = |table: &str, cells: &str| {
        std::fs::write(&partial, table).expect("written");
        std::fs::write(&grown, cells).expect("written");
        of(asked, &["--resume"])
    };
    let lines = |text: &str| text.lines().map(str::to_owned).collect::<Vec<_>>();
    let joined = |lines: &[String]| lines.iter().map(|l| format!("{l}\n")).collect::<String>();
    let head = lines(&right[0]).iter().position(|l| l.starts_with("ratio,")).expect("a heading") + 1;
    let changed = |file: usize, change: &dyn Fn(&mut Vec<String>)| {
        let mut all = lines(&right[file]);
        change(&mut all);
        joined(&all)
    };
    // The table's rows, then those of its certificate: of another grid, of a longer one, lost, doubled, altered, empty.
    let tables = [
        other[0].clone(),
        longer[0].clone(),
        changed(0, &|all| drop(all.remove(head + 1))),
        changed(0, &|all| all.insert(head + 1, all[head].clone())),
        changed(0, &|all| all[head + 2] = all[head + 2].replacen("600", "601", 1)),
        changed(0, &|all| all[head] = "500,0.5,3".to_owned()),
        changed(0, &|all| all[head] = "500,0.5,3,,".to_owned()),
        changed(0, &|all| all[head].clear()),
    ];
    let cells = [
        other[1].clone(),
        longer[1].clone(),
        changed(1, &|all| drop(all.remove(2))),
        changed(1, &|all| all[3] = all[3].replacen("600", "601", 1)),
        changed(1, &|all| all[3].truncate(60)),
    ];
    let pairs = tables.iter().map(|t| (t, &right[1])).chain(cells.iter().map(|c| (&right[0], c)));
    for (table, cells) in pairs {
        let out = resumed(table, cells);
        assert_eq!(out.status.code(), Some(2), "{table}{cells}");
        assert!(text(&out.stderr).contains("written with other settings"), "{}", text(&out.stderr));
        assert!(!path.exists() && !certificate.exists());
        let left = [&partial, &grown].map(|path| std::fs::read_to_string(path).expect("there"));
        assert!(left == [table.clone(), cells.clone()], "nothing of it is touched");
    }
    // The first rows of the same table are kept, also of a grid that goes on otherwise, and a line cut off is dropped.
    for (table, cells) in [(&right[0], &right[1]), (&shorter[0], &right[1])] {
        for cut in [0, 3] {
            let out = resumed(&table[..table.len() - cut], cells);
            assert_eq!(out.status.code(), Some(0), "{}", text(&out.stderr));
            assert!([&path, &certificate].map(|p| std::fs::read_to_string(p).expect("there")) == right);
        }
    }
}

#[test]
fn a_table_and_its_certificate_go_into_two_files() {
    let folder = tempfile::tempdir().expect("a folder");
    let sub = folder.path().join("sub");
    std::fs::create_dir(&sub).expect("made");
    std::fs::write(folder.path().join("old.csv"), "old\n").expect("written");
    let run = |output: &str, certificate: &str| {
        Command::new(env!("CARGO_BIN_EXE_carom"))
            .args(["table", "--ratio", "2", "-e", "1", "-n", "1", "--format", "csv"])
            .args(["--output", output, "--certificate", certificate])
            .current_dir(folder.path())
            .output()
            .expect("it starts")
    };
    for (output, certificate) in [
        ("old.csv", "old.csv"),
        ("old.csv", "./old.csv"),
        ("old.csv", "sub/../old.csv"),
        ("old.csv", "old.csv.partial"),
        ("old.csv.partial", "old.csv"),
        ("new.csv", "./new.csv"),
        ("new.csv", "sub/../new.csv.partial"),
    ] {
        let out = run(output, certificate);
        assert_eq!(out.status.code(), Some(2), "{output} {certificate}");
        assert!(text(&out.stderr).contains("overwrite each other"), "{}", text(&out.stderr));
        let mut names: Vec<_> =
            std::fs::read_dir(folder.path()).expect("there").flatten().map(|e| e.file_name()).collect();
        names.sort();
        assert_eq!(names, ["old.csv", "sub"]);
        assert_eq!(std::fs::read_to_string(folder.path().join("old.csv")).expect("there"), "old\n");
    }
    assert_eq!(run("a.csv", "sub/a.csv").status.code(), Some(0), "the control");
    #[cfg(unix)]
    assert_eq!(run("/dev/null", "/dev/null").status.code(), Some(0), "nothing is overwritten");
}

#[test]
fn cells_of_any_length_are_aligned() {
    for format in ["text", "markdown", "latex", "csv"] {
        let out = carom(&["table", "--ratio", "2", "-e", "1/2", "-n", "1", "--digits", "70000", "--format", format]);
        assert_eq!(out.status.code(), Some(0), "{format}: {}", text(&out.stderr));
        assert!(out.stdout.len() > 70_000);
    }
    let (code, shown, said) = checked(&format!("ratio,e,n,eta\n2,1/2,1,{}\n", "x".repeat(70_000)), &[]);
    assert_eq!(code, Some(1), "{said}");
    assert!(shown.contains("0 wrong; 1 unreadable"));
}

/// Every row of a table that all cores work on is the row that is computed by itself, in its place, in every form.
#[test]
fn rows_made_side_by_side_are_those_made_one_by_one() {
    let axes = ["table", "--ratio", "1:40:1", "-e", "0:1:0.005", "-n", "1:3:1", "--digits", "8"];
    let form = |name: &str| text(&carom(&[&axes[..], &["--format", name]].concat()).stdout);
    let plan =
        plan(Quantity::Eta, "1:40:1", Some("0:1:0.005"), Some("1:3:1"), Digits::Significant(8), Rounding::Nearest);
    let rows: Vec<_> = (0..plan.rows())
        .map(|row| {
            let found = plan.value(row).expect("a value");
            plan.row(row, Found::Open(found)).expect("a row").0
        })
        .collect();
    assert_eq!(rows.len(), 40 * 201 * 3);
    let lines = |text: &str| text.lines().map(str::to_owned).collect::<Vec<_>>();
    let csv = lines(&form("csv"));
    let csv: Vec<_> = csv.iter().filter(|line| line.starts_with(|c: char| c.is_ascii_digit())).collect();
    assert_eq!(csv.len(), rows.len());
    let aligned = lines(&form("text"));
    let aligned = &aligned[aligned.len() - rows.len()..];
    let json: serde_json::Value = serde_json::from_str(&form("json")).expect("JSON");
    let json = json["rows"].as_array().expect("rows");
    assert_eq!(json.len(), rows.len());
    for (place, row) in rows.iter().enumerate() {
        let exact = row.exact.clone().unwrap_or_default();
        let fields = [row.labels.join(","), row.value.clone(), exact.clone()].join(",");
        assert_eq!(*csv[place], fields, "row {place} as CSV");
        let words: Vec<&str> = aligned[place].split_whitespace().collect();
        let expected: Vec<&str> = fields.split(',').filter(|word| !word.is_empty()).collect();
        assert_eq!(words, expected, "row {place} as text");
        assert_eq!(json[place]["eta"].as_str(), Some(row.value.as_str()), "row {place} as JSON");
    }
}

#[cfg(unix)]
#[test]
fn ctrl_c_leaves_whole_rows_or_nothing() {
    let folder = tempfile::tempdir().expect("a folder");
    let (path, partial) = (folder.path().join("table.csv"), folder.path().join("table.csv.partial"));
    let long = ["table", "--ratio", "1:100000:1", "-e", "0:1:0.01", "-n", "0:40:1"];
    let interrupted = |more: &[&str]| {
        let child = Command::new(env!("CARGO_BIN_EXE_carom"))
            .args(long)
            .args(more)
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .expect("it starts");
        std::thread::sleep(std::time::Duration::from_millis(700));
        let kill = Command::new("kill").args(["-INT", &child.id().to_string()]).status().expect("kill is there");
        assert!(kill.success());
        child.wait_with_output().expect("it ends")
    };
    let out = interrupted(&["--format", "csv", "--output", &path.display().to_string()]);
    assert_eq!(out.status.code(), Some(130), "{}", text(&out.stderr));
    assert!(text(&out.stderr).contains("--resume"), "{}", text(&out.stderr));
    assert!(!path.exists());
    let left = std::fs::read_to_string(&partial).expect("it is left");
    assert!(left.ends_with('\n') && left.lines().count() > 10);
    let whole = text(
        &carom(&[&["table", "--ratio", "1:3:1", "-e", "0:1:0.01", "-n", "0:40:1", "--format", "csv"][..]].concat())
            .stdout,
    );
    let lines = left.lines().count().min(whole.lines().count());
    assert!(left.lines().take(lines).eq(whole.lines().take(lines)), "the rows that are left are right");
    let other = folder.path().join("table.md");
    let out = interrupted(&["--format", "markdown", "--output", &other.display().to_string()]);
    assert_eq!(out.status.code(), Some(130));
    assert!(text(&out.stderr).contains("nothing is left behind"), "{}", text(&out.stderr));
    let names: Vec<_> = std::fs::read_dir(folder.path()).expect("there").flatten().map(|e| e.file_name()).collect();
    assert_eq!(names, ["table.csv.partial"]);
}

#[test]
fn a_reader_of_a_table_may_go_away() {
    let out = for_nobody(&["table", "--ratio", "1:100000:1", "-e", "0:1:0.01", "-n", "0:40:1", "--format", "csv"]);
    assert_eq!((text(&out.stderr), out.status.code()), (String::new(), Some(0)));
}

/// Whether two doubles are the nearest ones around an exact number between two bounds.
fn around((lo, hi): (f64, f64), bounds: &(Rational, Rational)) -> bool {
    let exact = |x: f64| Rational::try_from(x).expect("finite");
    let inside = exact(lo) <= bounds.0 && (hi.is_infinite() || bounds.1 <= exact(hi));
    inside && (lo == hi || lo.next_up() == hi)
}

#[test]
fn doubles_around_a_cell_are_its_neighbours() {
    let six = Digits::Significant(6);
    for (quantity, ratio, e, n, steps) in [
        (Quantity::Eta, "1:40:3/2", Some("0:1:0.09"), Some("0,1,2,3,7,20"), 130),
        (Quantity::Eta, "1e-30:1e30:x1e7", Some("0,1/3,1"), Some("0:6:1"), 300),
        (Quantity::Threshold, "1/7:30:x3/2", None, Some("1:9:2"), 100),
        // Below the least double, among the subnormal ones, and beyond the greatest.
        (Quantity::Eta, "1e-330,1e-324,1e-310,1e310,1e330", Some("0,1"), Some("0,1"), 1200),
    ] {
        let plan = plan(quantity, ratio, e, n, six, Rounding::Nearest);
        let mut factors = Factors::new(&plan);
        for row in 0..plan.rows() {
            let place = plan.place(row).expect("a place");
            let (r, n) = (place.ratio.value(), place.n.expect("a number"));
            let near = match &place.e {
                Some(e) => {
                    let (low, high) = root(r, n + 1, steps);
                    let gain = (Rational::from(1) + e.value()).pow(2 * (n + 1)) * r;
                    let at = |t: Rational| &gain / (Rational::from(1) + t).pow(2 * (n + 1));
                    (at(high), at(low))
                }
                None => threshold(r, n),
            };
            let found = factors.neighbours(row).expect("no limit");
            // Where the root is rational, halving only comes near to it; the cell itself is exact then.
            let exact = match plan.value(row).expect("no limit") {
                carom::table::Value::Real(real) => real.as_rational().map(|x| (x.clone(), x.clone())),
                carom::table::Value::Count(_) => None,
            };
            if let Some((x, _)) = &exact {
                assert!(near.0 <= *x && *x <= near.1, "{}", plan.in_words(row));
            }
            assert!(around(found, &exact.unwrap_or(near)), "{}: {found:?}", plan.in_words(row));
        }
    }
    let best = plan(Quantity::BestN, "1,4,1e40", Some("0.9,1"), None, six, Rounding::Nearest);
    let mut factors = Factors::new(&best);
    let found: Vec<(f64, f64)> = (0..6).map(|row| factors.neighbours(row).expect("no limit")).collect();
    let infinity = f64::INFINITY;
    assert_eq!((found[1], found[3], found[5]), ((0.0, infinity), (infinity, infinity), (infinity, infinity)));
    assert!([0, 2, 4].iter().all(|i| found[*i].0 == found[*i].1 && found[*i].0.fract() == 0.0));
}

#[test]
fn the_form_is_that_of_the_files_name() {
    let folder = tempfile::tempdir().expect("a folder");
    let small = ["table", "--ratio", "2", "-e", "1/2", "-n", "1"];
    for (name, sign) in
        [("t.csv", "ratio,e,n,eta"), ("t.json", "\"rows\""), ("t.tex", "\\toprule"), ("t.md", "| --: |")]
    {
        let path = folder.path().join(name).display().to_string();
        assert_eq!(carom(&[&small[..], &["--output", &path]].concat()).status.code(), Some(0));
        let written = std::fs::read_to_string(&path).expect("written");
        assert!(written.contains(sign), "{name}: {written}");
        // What is asked for in words counts.
        assert_eq!(carom(&[&small[..], &["--output", &path, "--format", "text"]].concat()).status.code(), Some(0));
        assert!(!std::fs::read_to_string(&path).expect("written").contains(sign), "{name}");
    }
    let out = carom(&[&small[..], &["--output", "-"]].concat());
    assert_eq!((out.status.code(), text(&out.stdout).contains("eta")), (Some(0), true));
    assert!(!std::path::Path::new("-").exists());
    // The error of a missing folder names no temporary file.
    let out = carom(&[&small[..], &["--output", "/nonexistent/t.csv"]].concat());
    assert_eq!(out.status.code(), Some(2));
    assert!(!text(&out.stderr).contains(".tmp"), "{}", text(&out.stderr));
}

#[test]
fn a_table_longer_than_a_page_goes_on_with_its_heading() {
    let latex = |n: &str| text(&carom(&["table", "--ratio", "2", "-e", "1/2", "-n", n, "--format", "latex"]).stdout);
    let (short, long) = (latex("1:40:1"), latex("1:41:1"));
    assert!(short.contains("\\begin{tabular}") && !short.contains("{longtable}"), "{short}");
    assert!(
        long.contains("\\begin{longtable}") && long.contains("\\midrule\n\\endhead\n\\bottomrule\n\\endfoot"),
        "{long}"
    );
    assert_eq!(long.matches("\\bottomrule").count(), 1);
    assert!(long.trim_end().ends_with("\\end{longtable}\n\\endgroup"), "{long}");
}
