//! The fields of a worksheet mark what is typed, in JavaScript: the number that it reads and the answers that it accepts must be
//! the program's. `web/tests/marks.json` holds texts with the program's answers; `web/tests/marks.mjs` asks the script.

use crate::support::good;
use carom::number::decimal::Digits;
use carom::number::typed::read;
use carom::report::worksheet::made::{Wanted, sheets};
use carom::report::worksheet::{Cell, Part, Style, html};
use carom::scene::read::described;
use malachite::Rational;
use serde_json::{Value, json};
use std::path::Path;

/// Pieces of numbers as people type them, well and badly.
const PIECES: [&str; 53] = [
    "0",
    "1",
    "2",
    "5",
    "9",
    "10",
    "12",
    "37",
    "000",
    "007",
    "123",
    "250",
    "1000",
    "31415",
    ".",
    ".",
    ",",
    ",",
    " ",
    " ",
    "\u{202f}",
    "-",
    "−",
    "–",
    "+",
    "%",
    " %",
    "/",
    "/",
    "⁄",
    "*",
    "·",
    " × ",
    "⋅",
    "^",
    "10^",
    "10^-",
    "·10^",
    "*10^{3}",
    "10³",
    "·10⁻²",
    "e",
    "e-",
    "E+2",
    "½",
    "⅔",
    "¼",
    "±",
    "(2)",
    "[",
    "{",
    "m",
    " kg",
];

fn normal(x: &Rational) -> String {
    format!("{}{}/{}", if *x < 0u32 { "-" } else { "" }, x.numerator_ref(), x.denominator_ref())
}

/// Texts of up to six pieces, each with what the program reads: `p/q`, or nothing.
fn readings() -> Vec<Value> {
    let mut state = 33_u64;
    let mut below = |count: usize| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize % count
    };
    let typed = |text: &str| json!([text, read(text).ok().map(|x| normal(&x))]);
    let given = [
        "", " ", "0,9", "90 %", "9/10", "10^3", "1,000", "1 000", "5 1/2", "1/2*3", "2*5/4", "1e10001", "1e-10000",
        "--3", "1/0",
    ];
    let mut found: Vec<Value> = given.iter().map(|text| typed(text)).collect();
    while found.len() < 2000 {
        let text: String = (0..1 + below(6)).map(|_| PIECES[below(PIECES.len())]).collect();
        let reading = typed(&text);
        // Most random texts are no numbers: one in ten of these is enough.
        if !reading[1].is_null() || below(10) == 0 {
            found.push(reading);
        }
    }
    found
}

/// Fields of a page with some numbers, and whether each is right.
fn judged() -> Vec<Value> {
    let text = std::fs::read_to_string("examples/scenes/car-chain.toml").expect("a scene");
    let (about, scene) = described(&text).expect("it reads");
    let mut found = Vec::new();
    for digits in [Digits::Significant(4), Digits::Significant(1), Digits::Places(2)] {
        let style = Style { digits, exact: false };
        let wanted = Wanted { title: "t", standard: None, blank: true, key: false, versions: 1, seed: 5, style };
        let made = sheets(&about, &scene, &wanted).expect("sheets");
        let page = html::page(&made, false);
        for (sheet, place) in made.iter().zip(0..) {
            let tables = sheet.parts.iter().zip(0..).filter_map(|(part, number)| match part {
                Part::Table(table) => Some((table, number)),
                _ => None,
            });
            for (table, number) in tables {
                for (row, line) in table.groups.iter().flatten().zip(1..) {
                    for (cell, column) in row.cells.iter().zip(0..) {
                        let Cell::Blank(Some(expected)) = cell else { continue };
                        let name = format!("s{place}-{number}-{line}-{column}");
                        let salt = format!("{} {name}", sheet.foot);
                        let answers = expected.digests(&salt).join(" ");
                        assert!(page.contains(&format!("name=\"{name}\"")), "{name}");
                        assert!(page.contains(&format!("data-answer=\"{answers}\"")), "{name}: {answers}");
                        let exact = |text: &str| read(text).expect("a number");
                        for typed in
                            ["0", "15", "0.5", "-1.25", "22500", "22504.9", "-7.5", "-7.4996", "1500", "8.335", "-49/3"]
                        {
                            let value = exact(typed);
                            if expected.accepts(&value) || (line + column) % 5 == 0 && typed.len() % 3 == 0 {
                                found.push(json!([salt, answers, typed, expected.accepts(&value)]));
                            }
                        }
                    }
                }
            }
        }
        let fields = page.matches("data-answer=").count();
        assert!(fields > 60, "{fields} fields are marked");
    }
    found
}

#[test]
fn the_answers_that_the_script_of_a_sheet_must_give_are_those_of_the_program() {
    let lines = |list: Vec<Value>| list.iter().map(Value::to_string).collect::<Vec<_>>().join(",\n");
    let text = format!("{{\"read\": [\n{}\n],\n\"judged\": [\n{}\n]}}\n", lines(readings()), lines(judged()));
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("web/tests/marks.json");
    if std::env::var_os("CAROM_WRITE").is_some() {
        std::fs::write(&path, &text).expect("the file is written");
    }
    assert!(
        std::fs::read_to_string(&path).unwrap_or_default() == text,
        "run CAROM_WRITE=1 cargo test --test all marks"
    );
}

#[test]
fn every_number_of_a_key_is_right_in_the_field_of_its_sheet() {
    for name in ["car-chain", "stacked-balls", "stacked-balls-16-times", "three-balls-measured"] {
        let text = std::fs::read_to_string(format!("examples/scenes/{name}.toml")).expect("a scene");
        let (about, scene) = described(&text).expect("it reads");
        for digits in [Digits::Significant(1), Digits::Significant(3), Digits::Places(3)] {
            for exact in [false, true] {
                let style = Style { digits, exact };
                let wanted = Wanted { title: "t", standard: None, blank: true, key: true, versions: 0, seed: 1, style };
                let made = sheets(&about, &scene, &wanted).expect("sheets");
                let cells = |sheet: &carom::report::worksheet::Sheet| -> Vec<Cell> {
                    let tables = sheet.parts.iter().filter_map(|part| match part {
                        Part::Table(table) => Some(table.groups.concat()),
                        _ => None,
                    });
                    tables.flatten().flat_map(|row| row.cells).collect()
                };
                let mut marked = 0;
                for pair in cells(&made[0]).iter().zip(&cells(&made[1])) {
                    match pair {
                        (Cell::Blank(Some(expected)), Cell::Number(text)) => {
                            let value = read(text).expect("a number");
                            assert!(expected.accepts(&value), "{name}: {text} {expected:?}");
                            let other = if value == 0u32 { Rational::from(1) } else { &value * Rational::from(7) };
                            assert!(!expected.accepts(&other), "{name}: {other} for {text}");
                            marked += 1;
                        }
                        // What has an uncertainty is not marked.
                        (Cell::Blank(None), Cell::Number(text)) => assert!(text.contains('±'), "{name}: {text}"),
                        (blank, key) => assert_eq!(blank, key, "{name}"),
                    }
                }
                // Of measured balls only the total change of momentum, zero, is known.
                assert_eq!(marked > 10, name != "three-balls-measured", "{name}: {marked}");
            }
        }
    }
}

#[test]
fn a_page_without_fields_to_mark_has_no_script_and_no_page_shows_its_answers() {
    let page = |arguments: &[&str]| {
        let scene = ["worksheet", "examples/scenes/car-chain.toml", "--format", "html"];
        good(&[&scene, arguments].concat())
    };
    let (blank, key) = (page(&["--sheet", "blank"]), page(&["--sheet", "key"]));
    assert!(
        blank.contains("<script>") && blank.contains("data-answer=") && !key.contains("<script"),
        "a key marks nothing"
    );
    // The momentum of all cars is on the key and nowhere on the sheet.
    assert!(key.contains("2.250·10<sup>4</sup>") && !blank.contains("2.250") && !blank.contains("22500"), "{blank}");
    for far in ["http:", "https:", "src=", "import(", "fetch("] {
        assert!(!blank.contains(far), "the page loads {far}");
    }
}
