//! Certificates of tables before the kernel: all kinds accepted, damaged ones refused, and `carom check` as a user meets it.
#![allow(missing_docs, clippy::unwrap_used)]

use crate::support::{carom, said, with_input};
use carom::chain::{Positive, Restitution};
use carom::number::rational::parse;
use carom::table::{Place, Quantity, Value, value};
use carom::table_checker::Checker;
use carom::table_checker::Failure;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::PowerOf2;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;
use std::process::Command;

/// The certificate that `carom table` writes.
fn written(path: &Path, arguments: &str) -> String {
    let mut args = vec!["table", "--certificate", path.to_str().unwrap()];
    args.extend(arguments.split_whitespace());
    let output = carom(&args);
    assert!(output.status.success(), "{arguments}: {}", said(&output));
    std::fs::read_to_string(path).unwrap()
}

fn table(arguments: &str) -> String {
    let folder = tempfile::tempdir().unwrap();
    written(&folder.path().join("t.jsonl"), arguments)
}

/// How many rows the kernel accepts; else the row and why.
fn checked(text: &str) -> Result<u64, (usize, Failure)> {
    let lines: Vec<&str> = text.split('\n').collect();
    let Some((&"", lines)) = lines.split_last() else {
        return Err((0, Failure::Rejected("cut off".to_owned())));
    };
    let (head, rows) = lines.split_first().ok_or((0, Failure::Rejected("empty".to_owned())))?;
    let mut checker = Checker::new(head).map_err(|e| (0, e))?;
    for (place, row) in rows.iter().enumerate() {
        checker.row(row).map_err(|e| (place + 1, e))?;
    }
    checker.finish().map(|table| table.rows()).map_err(|e| (rows.len() + 1, e))
}

fn rows(text: &str) -> u64 {
    text.lines().count() as u64 - 1
}

/// Tables of every kind, small enough to be damaged many times.
const TABLES: [&str; 9] = [
    "--want eta --ratio 1,2,64,1/3 -e 0,0.5,0.9 -n 0,1,5 --digits 6",
    "--want eta --ratio 1:1e6:x1000 -e 1/3,1 -n 0:2:1 --places 4 --round up",
    "--want eta --ratio 10;4 -e 0.5:1:0.25 -n 1,30 --digits 3 --round zero",
    "--want eta --ratio 2;3 -e 0.9 -n 1000000,1000000000 --digits 8 --round away",
    "--want threshold --ratio 1,2,64,1e9 -n 1:4:1 --digits 12 --round down",
    "--want threshold --ratio 1e30,1/7,1 -n 1,20,1000000000 --places 5",
    "--want threshold --ratio 4 -n 1 --digits 1",
    "--want best-n --ratio 1,2,64,1/64,1e9 -e 0,44/81,0.9,1",
    "--want best-n --ratio 2 -e 0.99,0.999999,0.999999999999999",
];

#[test]
fn every_quantity_and_every_rounding_is_accepted() {
    for arguments in TABLES {
        let text = table(arguments);
        assert_eq!(checked(&text), Ok(rows(&text)), "{arguments}");
    }
    for rounding in ["nearest-even", "up", "down", "zero", "away"] {
        for digits in ["--digits 1", "--digits 7", "--digits 40", "--places 0", "--places 3", "--places 25"] {
            for rest in [
                "--want eta --ratio 1,1/2,9,1e-9 -e 0,1/3,0.95,1 -n 0,1,2,11,400",
                "--want threshold --ratio 1,1/2,9,1e-9,64 -n 1,2,11,400",
            ] {
                let arguments = format!("{rest} {digits} --round {rounding}");
                let text = table(&arguments);
                assert_eq!(checked(&text), Ok(rows(&text)), "{arguments}");
            }
        }
    }
}

/// A reproducible sequence of numbers.
struct Random(u64);

impl Random {
    fn below(&mut self, bound: u64) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0 % bound
    }

    fn ratio(&mut self) -> String {
        let digits = 1 + self.below(12) as u32;
        format!("{}/{}", 1 + self.below(10u64.pow(digits)), 1 + self.below(10u64.pow(digits)))
    }
}

#[test]
fn thousands_of_random_cells_are_accepted() {
    let mut random = Random(20_261_121);
    let mut cells = 0;
    for round in 0..14 {
        let mut list = |count: u64, make: &mut dyn FnMut(&mut Random) -> String| {
            // A grid has no number twice.
            let mut seen = std::collections::HashSet::new();
            let list = (0..count).map(|_| make(&mut random)).filter(|x| seen.insert(parse(x).unwrap()));
            list.collect::<Vec<_>>().join(",")
        };
        let ratios = list(12, &mut Random::ratio);
        let e = list(4, &mut |random| {
            let whole = 1 + random.below(10_000);
            format!("{}/{whole}", random.below(whole + 1))
        });
        let n = list(6, &mut |random| {
            let size = random.below(5) as u32;
            (1 + random.below(10u64.pow(1 + size))).to_string()
        });
        let rounding = ["nearest-even", "up", "down", "zero", "away"][round % 5];
        let digits = 1 + (round * 7) % 23;
        for arguments in [
            format!("--want eta --ratio {ratios} -e {e} -n {n} --digits {digits} --round {rounding}"),
            format!("--want threshold --ratio {ratios} -n {n} --places {digits} --round {rounding}"),
            format!("--want best-n --ratio {ratios} -e {e}"),
        ] {
            let text = table(&arguments);
            assert_eq!(checked(&text), Ok(rows(&text)), "{arguments}");
            cells += rows(&text);
        }
    }
    println!("{cells} cells");
    assert!(cells > 5_000);
}

/// The text between two marks of a row.
fn part<'a>(row: &'a str, from: &str, to: &str) -> &'a str {
    let (_, rest) = row.split_once(from).unwrap_or_else(|| panic!("{row} has {from}"));
    rest.split_once(to).unwrap().0
}

/// The row with the digits at a place of a number moved by one.
fn moved(digits: &str, place: usize, up: bool) -> Option<String> {
    let digit = digits.get(place..=place)?.parse::<u8>().ok()?;
    let next = if up { digit.checked_add(1).filter(|d| *d < 10)? } else { digit.checked_sub(1)? };
    Some(format!("{}{next}{}", &digits[..place], &digits[place + 1..]))
}

/// A number, as it is written, one greater or smaller.
fn next(number: &str, up: bool) -> Option<String> {
    let number: num_bigint::BigInt = number.parse().ok()?;
    let moved: num_bigint::BigInt = if up { number + 1 } else { number - 1 };
    Some(moved.to_string())
}

/// All changes of one row, each with its name.
fn damaged(row: &str) -> Vec<(&'static str, String)> {
    let mut out = Vec::new();
    let mut put = |how, from: String, to: String| {
        if from != to && row.contains(&from) {
            out.push((how, row.replacen(&from, &to, 1)));
        }
    };
    let printed = part(row, "\"printed\":\"", "\"");
    let field = |name: &str, value: &str| format!("\"{name}\":\"{value}\"");
    for up in [true, false] {
        for place in 0..printed.len() {
            if let Some(other) = moved(printed, place, up) {
                put("printed digit", field("printed", printed), field("printed", &other));
                let (from, to) = (field("printed", printed), field("printed", &other));
                put(
                    "printed and exact",
                    format!("{from},{}", field("exact", printed)),
                    format!("{to},{}", field("exact", &other)),
                );
            }
        }
        for name in ["ratio", "e", "n", "exact"] {
            if let Some((_, rest)) = row.split_once(&format!("\"{name}\":\"")) {
                let text = rest.split_once('"').unwrap().0;
                let (above, below) = text.split_once('/').unwrap_or((text, ""));
                let how = if name == "exact" { "exact" } else { "place" };
                if let Some(other) = next(above, up) {
                    let other = if below.is_empty() { other } else { format!("{other}/{below}") };
                    put(how, field(name, text), field(name, &other));
                }
                put(how, field(name, text), format!("\"{name}\":null"));
                put(how, field(name, text), field(name, &format!("0{text}")));
                put(
                    how,
                    field(name, text),
                    field(name, &format!("{above}0/{}0", if below.is_empty() { "1" } else { below })),
                );
            }
        }
        for end in ["lower", "upper"] {
            let Some((_, rest)) = row.split_once(&format!("\"{end}\":{{\"mantissa\":\"")) else { continue };
            let (mantissa, rest) = rest.split_once('"').unwrap();
            let exponent = part(rest, ":", "}");
            let written = |m: &str, e: &str| format!("\"{end}\":{{\"mantissa\":\"{m}\",\"exponent\":{e}}}");
            let old = written(mantissa, exponent);
            put("enclosure", old.clone(), written(&next(mantissa, up).unwrap(), exponent));
            put("enclosure", old.clone(), written(mantissa, &next(exponent, up).unwrap()));
            for place in [0, 1, mantissa.len() / 2, mantissa.len() - 1] {
                if let Some(other) = moved(mantissa, place, up) {
                    put("enclosure", old.clone(), written(&other, exponent));
                }
            }
            put("enclosure", old.clone(), format!("\"{end}\":null"));
            put("enclosure", old, written("0", "0"));
        }
    }
    put("printed length", field("printed", printed), field("printed", &format!("{printed}0")));
    put("printed length", field("printed", printed), field("printed", &printed[..printed.len() - 1]));
    put("printed length", field("printed", printed), field("printed", &format!("0{printed}")));
    put("printed length", field("printed", printed), field("printed", &format!("-{printed}")));
    put("exact", "\"exact\":null".to_owned(), "\"exact\":\"1/2\"".to_owned());
    for (from, to) in [("true", "false"), ("false", "true"), ("null", "false"), ("false", "null"), ("true", "null")] {
        put("tie", format!("\"tie\":{from}"), format!("\"tie\":{to}"));
    }
    put("form", ",\"exact\"".to_owned(), ", \"exact\"".to_owned());
    put("form", ",\"tie\"".to_owned(), ",\"printed\":\"9\",\"tie\"".to_owned());
    if let (Some(lower), Some(upper)) = (row.find("\"lower\""), row.find("\"upper\"")) {
        let tie = row.find(",\"tie\"").unwrap();
        let swapped = row[lower..tie].replace("lower", "other").replace("upper", "lower").replace("other", "upper");
        let (a, b) = swapped.split_at(upper - lower);
        let swapped = format!("{}{b},{}{}", &row[..lower], a.trim_end_matches(','), &row[tie..]);
        if swapped != row {
            out.push(("enclosure", swapped));
        }
    }
    out
}

/// All changes of the head.
fn damaged_head(head: &str) -> Vec<(&'static str, String)> {
    let mut out = Vec::new();
    let mut place = 0;
    // Every number one greater and one smaller, every word with another letter.
    while let Some(at) = head[place..].find(|c: char| c.is_ascii_alphanumeric()).map(|at| place + at) {
        let end = head[at..].find(|c: char| !c.is_ascii_alphanumeric()).map_or(head.len(), |end| at + end);
        let word = &head[at..end];
        let with = |other: &str| format!("{}{other}{}", &head[..at], &head[end..]);
        let program =
            head[..at].ends_with("\"carom ") || head[..at].contains("\"carom ") && !head[..at].contains("version");
        let how = if program || word == "carom" { "program's name" } else { "head" };
        if word.bytes().all(|b| b.is_ascii_digit()) {
            out.extend([true, false].into_iter().filter_map(|up| next(word, up)).map(|other| (how, with(&other))));
        } else {
            out.push((how, with(&format!("{word}x"))));
            out.push((how, with(&word[1..])));
        }
        place = end;
    }
    for (from, to) in [
        ("nearest-even", "up"),
        ("\"up\"", "\"down\""),
        ("\"zero\"", "\"away\""),
        ("significant\"", "places\""),
        ("\"places\"", "\"significant\""),
        ("\"step\"", "\"factor\""),
        ("\"factor\"", "\"step\""),
        ("{\"list\":[", "{\"list\":[\"1\","),
        ("\"want\":\"eta\"", "\"want\":\"threshold\""),
        (",\"rows\"", ",\"rounding\":\"up\",\"rows\""),
    ] {
        if head.contains(from) {
            out.push(("head", head.replacen(from, to, 1)));
        }
    }
    out
}

/// The row's enclosure holds the value, as the engine's numbers say, with hundreds of bits.
fn holds_the_value(quantity: Quantity, row: &str) -> bool {
    let place = Place {
        ratio: Positive::new(parse(part(row, "\"ratio\":\"", "\"")).unwrap()).unwrap(),
        e: (quantity == Quantity::Eta).then(|| Restitution::new(parse(part(row, "\"e\":\"", "\"")).unwrap()).unwrap()),
        n: Some(part(row, "\"n\":\"", "\"").parse().unwrap()),
    };
    let Ok(Value::Real(real)) = value(quantity, &place) else { panic!("{row}") };
    let end = |name: &str| {
        let rest = row.split_once(&format!("\"{name}\":{{")).unwrap().1;
        let mantissa = parse(part(rest, "\"mantissa\":\"", "\"")).unwrap();
        mantissa * Rational::power_of_2(part(rest, "\"exponent\":", "}").parse::<i64>().unwrap())
    };
    let found = real.enclosure(400);
    let of = |end: Option<(malachite::Integer, i64)>| {
        let (mantissa, exponent) = end.unwrap();
        Rational::from(mantissa) * Rational::power_of_2(exponent)
    };
    end("lower") <= of(found.lower()) && of(found.upper()) <= end("upper")
}

/// What became of mutants: how many were tried and how many are still valid, by kind.
type Counts = BTreeMap<&'static str, (usize, usize)>;

/// Counts a mutant of a table; one that is accepted has to be as valid as the table.
fn judged(counts: &mut Counts, how: &'static str, text: &str, mutant: &str) {
    let count = counts.entry(how).or_default();
    count.0 += 1;
    let Ok(accepted) = checked(mutant) else { return };
    count.1 += 1;
    assert_eq!(accepted, rows(text), "{how}: another number of rows");
    let (old, new) = text.lines().zip(mutant.lines()).find(|(a, b)| a != b).unwrap();
    match how {
        // Nothing else is changed in the row, and the enclosure still holds the value: as valid as before.
        "enclosure" => {
            let quantity = if text.contains("\"want\":\"eta\"") { Quantity::Eta } else { Quantity::Threshold };
            let (before, after) = (old.split_once("\"lower\"").unwrap(), new.split_once("\"lower\"").unwrap());
            assert_eq!(before.0, after.0);
            assert!(holds_the_value(quantity, new), "{new}");
        }
        // Who wrote the file says nothing of its numbers.
        "program's name" => {}
        _ => panic!("{how} is accepted: {new} for {old}"),
    }
}

/// Tries every mutant of a table.
fn attack(text: &str, counts: &mut Counts) {
    let lines: Vec<&str> = text.lines().collect();
    let with = |place: usize, lines_there: &[&str]| {
        let mut out = String::new();
        for line in lines[..place].iter().chain(lines_there).chain(&lines[place + 1..]) {
            writeln!(out, "{line}").unwrap();
        }
        out
    };
    for (how, head) in damaged_head(lines[0]) {
        judged(counts, how, text, &with(0, &[&head]));
    }
    let mut checker = Checker::new(lines[0]).unwrap();
    for place in 1..lines.len() {
        for (how, row) in damaged(lines[place]) {
            // A row that is rejected after the rows before it is rejected in the file.
            if checker.clone().row(&row).is_err() {
                counts.entry(how).or_default().0 += 1;
            } else {
                judged(counts, how, text, &with(place, &[&row]));
            }
        }
        checker.row(lines[place]).unwrap();
        judged(counts, "row left out", text, &with(place, &[]));
        judged(counts, "row twice", text, &with(place, &[lines[place], lines[place]]));
        if place + 1 < lines.len() {
            let mut swapped = lines.clone();
            swapped.swap(place, place + 1);
            judged(counts, "rows swapped", text, &(swapped.join("\n") + "\n"));
            // Numbered as if it had been so from the beginning.
            let renumbered = [lines[place + 1], lines[place]].map(|row| row.split_once(',').unwrap().1);
            let numbered: Vec<String> =
                renumbered.iter().zip(place - 1..).map(|(row, number)| format!("{{\"row\":{number},{row}")).collect();
            swapped[place] = &numbered[0];
            swapped[place + 1] = &numbered[1];
            judged(counts, "rows swapped", text, &(swapped.join("\n") + "\n"));
        }
        judged(counts, "file cut off", text, &(lines[..place].join("\n") + "\n"));
        let whole: usize = lines[..place].iter().map(|line| line.len() + 1).sum();
        judged(counts, "file cut off", text, &text[..whole + lines[place].len() / 2]);
    }
    judged(counts, "file cut off", text, &text[..text.len() - 1]);
}

#[test]
fn every_damaged_table_is_rejected_or_still_valid() {
    let mut counts = Counts::new();
    for arguments in TABLES {
        attack(&table(arguments), &mut counts);
    }
    let (tried, valid) = counts.values().fold((0, 0), |all, count| (all.0 + count.0, all.1 + count.1));
    println!("{tried} mutants, {valid} still valid: {counts:?}");
    assert!(tried >= 2_000, "{tried}");
    assert!(valid * 4 < tried, "{valid} of {tried} are still valid");
}

#[test]
fn a_shifted_last_digit_is_rejected_in_every_random_cell() {
    let mut random = Random(7);
    let ratios: Vec<String> = (0..8).map(|_| random.ratio()).collect();
    let ratios = ratios.join(",");
    let mut tried = 0;
    for arguments in [
        format!("--want eta --ratio {ratios} -e 1/7,0.9,1 -n 1,4,33 --digits 9"),
        format!("--want threshold --ratio {ratios} -n 1,2,5,60 --digits 9 --round up"),
    ] {
        let text = table(&arguments);
        for (place, row) in text.lines().enumerate().skip(1) {
            let printed = part(row, "\"printed\":\"", "\"");
            let end = printed.find('e').unwrap_or(printed.len()) - 1;
            for up in [true, false] {
                let Some(other) = moved(printed, end, up) else { continue };
                let mutant = text.replacen(row, &row.replacen(printed, &other, 1), 1);
                assert!(matches!(checked(&mutant), Err((at, Failure::Rejected(_))) if at == place), "{row} as {other}");
                tried += 1;
            }
        }
    }
    assert!(tried > 150, "{tried}");
}

#[test]
fn what_is_beyond_a_limit_is_declined_by_name() {
    let text = table("--want eta --ratio 2 -e 0.5 -n 1 --digits 3");
    let long = text.replacen("\"significant\":3", "\"significant\":10001", 1);
    assert_eq!(checked(&long), Err((0, Failure::Declined("digits of a table"))));
    let many = text.replacen("\"rows\":1}", "\"rows\":99999999999999999999}", 1);
    assert_eq!(checked(&many), Err((0, Failure::Declined("rows of a table"))));
    let far = text.replacen("\"exponent\":-", "\"exponent\":-99999999999999999999", 1);
    assert_eq!(checked(&far), Err((1, Failure::Declined("exponents of dyadic numbers"))));
    let digits = text.replacen("\"mantissa\":\"", &format!("\"mantissa\":\"{}", "7".repeat(50_000)), 1);
    assert_eq!(checked(&digits), Err((1, Failure::Declined("digits of a number"))));
    // A value that nobody can compute in time does not make the kernel hang.
    let text = table("--want best-n --ratio 2 -e 0.5");
    let huge = text.replacen(
        "\"printed\":\"0\",\"exact\":\"0\"",
        &format!("\"printed\":\"1{0}\",\"exact\":\"1{0}\"", "0".repeat(700)),
        1,
    );
    assert_ne!(huge, text);
    assert_eq!(checked(&huge), Err((1, Failure::Declined("bits of a number of bodies"))));
}

#[test]
fn the_command_tells_tables_from_claims_by_what_they_hold() {
    let folder = tempfile::tempdir().unwrap();
    // Not by name.
    let path = folder.path().join("cells.cert");
    let text = written(&path, "--want eta --ratio 1;10 -e 0.9 -n 0:2:1");
    let name = path.to_str().unwrap();
    let output = carom(&["check", name]);
    let printed = said(&output);
    assert_eq!(output.status.code(), Some(0), "{printed}");
    assert!(printed.starts_with(&format!("accepted  {name}: 6 rows\n    eta = (1 + e)^(2(n + 1)) r")), "{printed}");
    assert!(
        printed.contains("\n    ratio = 1, 10\n    e = 9/10\n    n = 3 from 0 by steps of 1\n    6 significant"),
        "{printed}"
    );
    let quiet = said(&carom(&["check", "--quiet", name]));
    assert_eq!(quiet, format!("accepted  {name}: 6 rows\n"));

    let claim = concat!(env!("CARGO_MANIFEST_DIR"), "/proofs/certificates/eq13.cert");
    let both = carom(&["check", "--quiet", name, claim]);
    assert_eq!(both.status.code(), Some(0), "{}", said(&both));
    assert!(said(&both).ends_with("accepted  eq13\n1 of 1 certificates accepted\n"), "{}", said(&both));

    for (from, to, code, why) in [
        ("\"printed\":\"0.298", "\"printed\":\"0.398", 1, "row 3, ratio 10, e 9/10, n 0: the file has 0.398"),
        ("\"rows\":6", "\"rows\":7", 1, "head: the axes make 6 rows, not 7"),
        ("\"significant\":6", "\"significant\":999999", 3, "head: limit reached: digits of a table"),
        ("{\"certificate\"", "{\"certificates\"", 1, "head: "),
        ("\"row\":5", "\"row\":5é", 1, "row 5, ratio 10, e 9/10, n 2: "),
    ] {
        let mutant = text.replacen(from, to, 1);
        assert_ne!(mutant, text, "{from}");
        std::fs::write(&path, mutant).unwrap();
        let output = carom(&["check", name]);
        assert_eq!(output.status.code(), Some(code), "{to}: {}", said(&output));
        assert!(said(&output).contains(why), "{to}: {}", said(&output));
    }
    std::fs::write(&path, &text[..text.len() - 1]).unwrap();
    let output = carom(&["check", name, claim]);
    assert_eq!(output.status.code(), Some(1));
    assert!(said(&output).contains("the file was cut off"), "{}", said(&output));
    std::fs::write(&path, b"{\xff\n").unwrap();
    assert!(said(&carom(&["check", name])).contains("head: the line is not UTF-8"));
}

#[test]
fn enclosures_of_any_size_are_answered() {
    let text = table("--want eta --ratio 2 -e 0.5 -n 1 --digits 3");
    let row = text.lines().nth(1).unwrap();
    for lower in ["-9223372036854775807", "9223372036854775807", "-400", "0"] {
        for upper in ["-9223372036854775807", "9223372036854775807", "400"] {
            let old = &row[row.find("\"lower\"").unwrap()..row.find(",\"tie\"").unwrap()];
            let end = |name: &str, e: &str| format!("\"{name}\":{{\"mantissa\":\"1\",\"exponent\":{e}}}");
            let mutant = text.replacen(old, &format!("{},{}", end("lower", lower), end("upper", upper)), 1);
            assert!(checked(&mutant).is_err(), "{lower} {upper}");
        }
    }
    let many = text.replace("\"n\":{\"list\":[\"1\"]}", &format!("\"n\":{{\"list\":[\"1{}\"]}}", "0".repeat(5_000)));
    let many = many.replace("\"n\":\"1\"", &format!("\"n\":\"1{}\"", "0".repeat(5_000)));
    assert_ne!(many, text);
    assert_eq!(checked(&many), Err((1, Failure::Declined("bits of a number of bodies"))));
}

#[test]
fn no_cell_is_given_twice() {
    for (arguments, axis, twice) in [
        ("--want threshold --ratio 2 -n 3", "ratio", "2"),
        ("--want threshold --ratio 2 -n 3", "n", "3"),
        ("--want eta --ratio 2 -e 1/2 -n 1", "e", "1/2"),
    ] {
        let text = table(arguments);
        assert_eq!(checked(&text), Ok(1));
        let (head, row) = text.split_once('\n').unwrap();
        let rows = format!("{row}{}", row.replacen("\"row\":0,", "\"row\":1,", 1));
        let single = format!("\"{axis}\":{{\"list\":[\"{twice}\"]}}");
        assert!(head.contains(&single), "{head}");
        for values in [
            format!("{{\"list\":[\"{twice}\",\"{twice}\"]}}"),
            format!("{{\"start\":\"{twice}\",\"step\":\"0\",\"count\":2}}"),
            format!("{{\"start\":\"{twice}\",\"factor\":\"1\",\"count\":2}}"),
        ] {
            let head =
                head.replacen(&single, &format!("\"{axis}\":{values}"), 1).replacen("\"rows\":1", "\"rows\":2", 1);
            let found = checked(&format!("{head}\n{rows}"));
            let Err((0, Failure::Rejected(reason))) = found else { panic!("{values}: {found:?}") };
            assert!(reason.contains("twice"), "{reason}");
        }
    }
    // The program does not write such a table.
    let output = carom(&["table", "--want", "threshold", "--ratio", "2,3,4/2", "-n", "3"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(said(&output).contains("4/2 is given twice"), "{}", said(&output));
}

/// What would rewrite a line of a terminal, or turn it around.
const HOSTILE: [&str; 5] = ["\r", "\u{1b}[K", "\u{202e}", "\u{9b}2K", "\u{2066}"];

/// What `carom check` writes for a terminal that wants colours: only ends of lines may steer it.
fn steered(path: &Path) -> (Option<i32>, String) {
    let output = Command::new(env!("CARGO_BIN_EXE_carom"))
        .args(["check", path.to_str().unwrap()])
        .env("CLICOLOR_FORCE", "1")
        .output()
        .unwrap();
    let shown = said(&output);
    let steers = |c: char| c.is_control() && c != '\n' || ('\u{2028}'..='\u{202e}').contains(&c) || c == '\u{2066}';
    assert!(!shown.contains(steers), "{shown:?}");
    (output.status.code(), shown)
}

#[test]
fn no_reason_steers_the_terminal() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("t.jsonl");
    let certificate = include_str!("../../proofs/certificates/eq13.cert");
    let tables = ["--want eta --ratio 2 -e 0.5 -n 1 --digits 3", "--want best-n --ratio 64 -e 0.9"].map(table);
    let mut quoted = 0;
    for text in tables.iter().map(String::as_str).chain([certificate]) {
        let places: Vec<usize> = text.char_indices().map(|(place, _)| place).chain([text.len()]).collect();
        for (turn, place) in places.iter().enumerate().step_by(3) {
            let mark = HOSTILE[turn / 3 % HOSTILE.len()];
            std::fs::write(&path, format!("{}{mark}{}", &text[..*place], &text[*place..])).unwrap();
            let (code, shown) = steered(&path);
            // The head may say anything of the program that wrote it, and a claim's certificate has spaces where it likes.
            let program = text[..*place].contains("\"program\":") && !text[..*place].contains("\"version\":");
            assert!(code != Some(0) || program || text == certificate, "{place}: {shown}");
            quoted += usize::from(shown.contains("\\u{"));
        }
    }
    assert!(quoted > 100, "{quoted} of the messages quote what was put in");
    // The whole line would read `accepted`.
    let text = tables[0].replacen("\"printed\":\"", "\"printed\":\"\u{202e}", 1);
    std::fs::write(&path, &text).unwrap();
    let (code, shown) = steered(&path);
    assert_eq!(code, Some(1), "{shown}");
    assert!(shown.starts_with("rejected") && shown.contains("\\u{202e}"), "{shown}");
}

#[test]
fn a_table_of_costly_rows_is_declined_as_a_whole() {
    // Each row alone is checked; the file costs more than its length explains.
    let text = table("--want eta --ratio 1 -e 1/3 -n 200000:200400:1 --digits 1");
    assert!(matches!(checked(&text), Err((row, Failure::Declined("work for the whole table"))) if row > 2));
    let one = table("--want eta --ratio 1 -e 1/3 -n 200000 --digits 1");
    assert_eq!(checked(&one), Ok(1));
}

#[cfg(unix)]
#[test]
fn a_pipe_is_checked_like_the_file() {
    let table = table("--want eta --ratio 2 -e 0.5 -n 1 --digits 3");
    let certificate = include_str!("../../proofs/certificates/eq13.cert");
    for (text, sign) in [(table.as_str(), "accepted  -: 1 row"), (certificate, "accepted  eq13")] {
        let output = with_input(&["check", "--quiet", "-"], text);
        assert_eq!(output.status.code(), Some(0), "{}", said(&output));
        assert!(said(&output).starts_with(sign), "{}", said(&output));
        // As a shell gives `<(…)`.
        let folder = tempfile::tempdir().unwrap();
        let (file, pipe) = (folder.path().join("t"), folder.path().join("pipe"));
        std::fs::write(&file, text).unwrap();
        assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
        let feed = std::thread::spawn({
            let (file, pipe) = (file.clone(), pipe.clone());
            move || std::fs::write(pipe, std::fs::read(file).unwrap())
        });
        let output = carom(&["check", "--quiet", pipe.to_str().unwrap()]);
        feed.join().unwrap().unwrap();
        assert_eq!(output.status.code(), Some(0), "{}", said(&output));
        assert_eq!(said(&output).contains("row"), text.starts_with('{'), "{}", said(&output));
    }
}
