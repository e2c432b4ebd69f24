//! What a teacher makes and reads: versions of sheets, measured balls, readings of bounces, cross tables, own points.

use crate::support::{carom, good, text, with_input};
use carom::number::decimal::Digits;
use carom::number::rational::parse;
use carom::report::worksheet::Style;
use carom::report::worksheet::made::{STANDARD, Wanted, sheets};
use carom::report::worksheet::pages::pages;
use carom::scene::read::described;
use malachite::Rational;
use std::process::Command;

fn scene(name: &str) -> String {
    format!("examples/scenes/{name}.toml")
}

#[test]
fn versions_differ_and_their_seed_gives_them_again() {
    let made = |seed: &str| good(&["worksheet", &scene("car-chain"), "--versions", "3", "--seed", seed]);
    let text = made("7");
    let masses: Vec<&str> = text.lines().filter(|l| l.trim_start().starts_with("mass (kg)")).collect();
    // The table of all bodies, then one for each collision, on six sheets.
    assert_eq!(masses.len(), 6 * 4, "{text}");
    assert!(masses[0] != masses[4] && masses[4] != masses[8] && masses[0] != masses[8], "{text}");
    let cells =
        |lines: &[&str]| lines.iter().map(|l| l.split_whitespace().collect::<Vec<_>>().join(" ")).collect::<Vec<_>>();
    assert_eq!(cells(&masses[..12]), cells(&masses[12..]), "the keys are those of the sheets");
    assert!(text.contains("worksheet, version C") && text.contains("answer key, version C"), "{text}");
    assert_eq!(text, made("7"));
    assert_ne!(text, made("8"));
    let out = carom(&["worksheet", &scene("car-chain"), "--versions", "27"]);
    assert_eq!(out.status.code(), Some(2));
}

#[test]
fn neighbours_guess_the_same() {
    for name in ["car-chain", "stacked-balls"] {
        for seed in ["1", "2", "3"] {
            let text = good(&["worksheet", &scene(name), "--versions", "4", "--seed", seed, "--sheet", "blank"]);
            let asked: Vec<Vec<&str>> = text
                .split("Predict first")
                .skip(1)
                .map(|sheet| {
                    let sheet = sheet.split("Compute").next().expect("a part");
                    let asks = sheet.lines().filter(|l| l.starts_with(|c: char| c.is_ascii_digit()));
                    asks.map(|ask| ask.split_once(". ").expect("a number").1).collect()
                })
                .collect();
            assert!(asked.len() == 4 && asked.iter().all(|list| list.len() == 3), "{name} {seed}: {asked:?}");
            let same = asked[0].iter().filter(|ask| asked[1].contains(ask)).count();
            assert_eq!(same, 0, "{name} {seed}: A and B have questions in common");
        }
    }
}

#[test]
fn a_sheet_with_its_key_needs_more_than_a_page_for_each() {
    // Twenty scenes, on both papers, every second one with a version: a page for the pupil, a page for the teacher.
    let names = ["car-chain", "stacked-balls", "stacked-balls-16-times", "three-balls-measured"];
    let shipped = names.map(|name| std::fs::read_to_string(scene(name)).expect("a scene"));
    let random = (0..).map(crate::teaching::random_chain);
    let style = Style { digits: Digits::Significant(4), exact: false };
    let wanted = |versions| Wanted {
        title: "Carts on a long track",
        standard: Some(STANDARD),
        blank: true,
        key: true,
        versions,
        seed: 7,
        style,
    };
    let mut tried = 0;
    for (text, place) in shipped.into_iter().chain(random).zip(0..30) {
        let (about, subject) = described(&text).expect("a scene");
        // A pass that does not take place makes no sheet.
        let Ok(made) = sheets(&about, &subject, &wanted(place % 2)) else { continue };
        tried += 1;
        for letter in [false, true] {
            let count = pages(&made, letter).len();
            assert_eq!(count, made.len(), "letter paper {letter}: {text}");
        }
    }
    assert!(tried >= 20, "{tried} scenes");
}

#[test]
fn a_sheet_asks_for_e_and_does_not_say_what_it_is() {
    for (name, given) in [
        ("car-chain", "The coefficient of restitution is e = 0.2 in collision 1,"),
        ("stacked-balls", "The coefficient of restitution of two balls is e = 0.9 in every collision."),
    ] {
        let sheet = good(&["worksheet", &scene(name), "--sheet", "blank"]);
        let sheet = sheet.split_whitespace().collect::<Vec<_>>().join(" ");
        let meaning = "It is the speed at which two bodies move apart after a collision, divided by the speed at which they came together.";
        assert!(sheet.contains(given) && sheet.contains(meaning), "{sheet}");
    }
}

#[test]
fn a_sheet_says_what_cannot_happen() {
    let sheet = |scene: &str| {
        let out = with_input(&["worksheet", "-", "--sheet", "key"], scene);
        assert_eq!(out.status.code(), Some(0), "{scene}: {}", text(&out.stderr));
        text(&out.stdout).split_whitespace().collect::<Vec<_>>().join(" ")
    };
    let chain = |rest: &str| sheet(&format!("[chain]\nfirst = \"1\"\nlast = \"1\"\n{rest}"));
    let drop = |rest: &str| sheet(&format!("[drop]\nmasses = [\"3\", \"1\"]\n{rest}"));
    for (shown, right, wrong) in [
        // A ball that does not leave the floor; its collision with the floor is not elastic.
        (
            drop("floor = \"0\"\nrestitution = \"1\"\n"),
            "and stays there. The ball above, which still falls, strikes it",
            "comes back up",
        ),
        (drop("floor = \"0\"\nrestitution = \"1\"\n"), "body 1 and body 2 collide", "downwards"),
        (drop("floor = \"1\"\nrestitution = \"1\"\n"), "will collision 1 turn into heat", "all collisions"),
        (drop("floor = \"[0, 0.1]\"\nrestitution = \"0.5\"\n"), "or stays there if e is 0", "downwards"),
        // Infinitely many collisions have no last one, and no order to be written down.
        (
            chain("inserted = [\"1\"]\nrestitution = \"0.05\"\n"),
            "fastest in the end? [ ] body 1 [ ] body 2 [ ] body 3 [x] all",
            "last collision",
        ),
        (chain("inserted = [\"1\"]\nrestitution = \"0.05\"\n"), "How often?", "in which order"),
        // Two bodies never meet again.
        (chain("restitution = \"[0, 1]\"\n"), "turned into other forms by the collision?", "meet again"),
        // To the left, the body in front strikes the one behind.
        (chain("restitution = \"1\"\nvelocities = [\"-1\", \"-3\"]\n"), "body 1 and body 2 collide", "strikes"),
    ] {
        assert!(shown.contains(right) && !shown.contains(wrong), "{right}, not {wrong}: {shown}");
    }
}

#[test]
fn a_sketch_has_each_body_with_its_mass_and_its_velocity() {
    let sheet = |name: &str, form: &str| good(&["worksheet", &scene(name), "--sheet", "blank", "--format", form]);
    let cars = sheet("car-chain", "text");
    let drawn = [
        "  [1]-->   [2]      [3]      [4]",
        "  ====================================",
        "  1500 kg  1200 kg  1800 kg  1100 kg",
        "  15 m/s   at rest  at rest  at rest",
    ];
    assert!(cars.contains(&drawn.join("\n")), "{cars}");
    // Balls stand on a floor; the lowest comes back up while the others fall.
    let balls = sheet("stacked-balls", "text");
    for line in ["[4] v   m = 1      −1 v", "[1] ^   m = 11.9   1 v", "floor"] {
        assert!(balls.contains(line), "{line}: {balls}");
    }
    let page = sheet("car-chain", "html");
    let picture =
        page.split("<svg class=\"sketch\"").nth(1).expect("a picture").split("</svg>").next().expect("its end");
    assert!(picture.contains("from left to right: body 1: 1500 kg, 15 m/s; body 2: 1200 kg, at rest"), "{picture}");
    assert!(picture.contains(">1800 kg</text>") && picture.contains("<polyline"), "{picture}");
    let latex = sheet("car-chain", "latex");
    assert!(latex.contains("\\begin{picture}") && latex.contains("1500 kg"), "{latex}");
    // Where many bodies stand in a row, the table alone lists them.
    let many = "[chain]\nfirst = 2\nlast = 1\ninserted = 12\nrestitution = 1\n";
    let out = crate::support::with_input(&["worksheet", "-", "--sheet", "blank"], many);
    assert!(!crate::support::text(&out.stdout).contains("[1]--"), "{}", crate::support::text(&out.stdout));
}

#[test]
fn a_power_of_ten_has_two_notations_on_one_page() {
    let page = good(&["worksheet", &scene("car-chain"), "--sheet", "key", "--format", "html"]);
    assert!(page.contains("<td>2.250·10<sup>4</sup></td>"), "a cell");
    assert!(page.contains("2.250·10<sup>4</sup> kg·m/s both times"), "an answer");
    assert!(!page.contains("250e4"), "{page}");
    let latex = good(&["worksheet", &scene("car-chain"), "--sheet", "key", "--format", "latex"]);
    assert!(latex.contains("$2.250\\cdot 10^{4}$ kg") && !latex.contains("250e4"), "{latex}");
}

#[test]
fn a_sheet_is_a_pdf_whose_objects_are_where_its_table_says() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("sheet.pdf");
    good(&["worksheet", &scene("three-balls-measured"), "-o", &path.display().to_string()]);
    let bytes = std::fs::read(&path).expect("written");
    let pdf = text(&bytes);
    assert!(pdf.starts_with("%PDF-1.4") && pdf.ends_with("%%EOF\n") && pdf.is_ascii());
    let start: usize =
        pdf.rsplit("startxref\n").next().and_then(|t| t.lines().next()).expect("a place").parse().expect("a number");
    let table: Vec<&str> = pdf[start..].lines().skip(3).take_while(|l| l.ends_with(" n ")).collect();
    for (number, line) in table.iter().enumerate() {
        let place: usize = line[..10].parse().expect("a place");
        assert!(pdf[place..].starts_with(&format!("{} 0 obj", number + 1)), "{line}");
    }
    assert!(table.len() > 20 && pdf.contains("/MediaBox [0 0 595 842]"));
    for stream in pdf.split("/Length ").skip(1) {
        let (length, rest) = stream.split_once(" >>\nstream\n").expect("a stream");
        let length: usize = length.parse().expect("a number");
        assert!(rest[length..].starts_with("\nendstream"), "a stream is as long as it says");
    }
    let out = carom(&["worksheet", &scene("car-chain"), "--format", "pdf"]);
    assert_eq!(out.status.code(), Some(2), "a PDF goes to a file");
}

#[test]
fn measured_balls_have_answers_with_as_many_digits_as_are_known() {
    let shown = good(&["eval", &scene("three-balls-measured")]);
    assert!(shown.contains("rises to 15.5 ± 1.6 times the height"), "{shown}");
    assert!(shown.contains("from 1.20 ± 0.01 m to 19 ± 3 m"), "{shown}");
    let key = good(&["worksheet", &scene("three-balls-measured"), "--sheet", "key"]);
    assert!(key.contains("[x] body 3") && key.contains("57.7 ± 0.1"), "{key}");
    let blank = good(&["worksheet", &scene("three-balls-measured"), "--sheet", "blank"]);
    assert!(blank.contains("dropped together from a height of 1.20 ± 0.01 m") && !blank.contains("15.5"), "{blank}");
    // A chain: the numbers of the sheet hold those of every corner of the box.
    let folder = tempfile::tempdir().expect("a folder");
    let sheet = |first: &str, middle: &str, e: &str| {
        let path = folder.path().join("chain.toml");
        let file = format!(
            "[chain]\nfirst = \"{first}\"\ninserted = [\"{middle}\"]\nlast = \"1\"\nrestitution = [\"{e}\", \"0.8\"]\n"
        );
        std::fs::write(&path, file).expect("written");
        good(&["worksheet", &path.display().to_string(), "--sheet", "key", "--digits", "12"])
    };
    let cells = |text: &str| -> Vec<(Rational, Rational)> {
        let lines = text.split("\nCollision ").skip(1).flat_map(str::lines);
        let lines =
            lines.filter(|l| ["velocity", "momentum", "kinetic"].iter().any(|name| l.trim_start().starts_with(name)));
        let range = |cell: &str| carom::chain::uncertain::Range::read(cell).ok();
        let cells = lines.flat_map(|l| l.split("  ").map(str::trim).filter_map(range).collect::<Vec<_>>());
        cells.map(|range| (range.lo().clone(), range.hi().clone())).collect()
    };
    let box_ = cells(&sheet("9.0 ± 0.3", "3.0(2)", "0.9 ± 5 %"));
    assert!(box_.iter().filter(|(lo, hi)| lo < hi).count() > 30);
    let slack = parse("1e-9").expect("a number");
    for first in ["8.7", "9", "9.3"] {
        for middle in ["2.8", "3.1", "3.2"] {
            for e in ["0.855", "0.9", "0.945"] {
                let point = cells(&sheet(first, middle, e));
                assert_eq!(point.len(), box_.len());
                for ((lo, hi), (value, _)) in box_.iter().zip(&point) {
                    assert!(lo - &slack <= *value && *value <= hi + &slack, "{value} is outside of {lo} to {hi}");
                }
            }
        }
    }
}

#[test]
fn measured_bounces_give_e_or_the_readings_that_exclude_each_other() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("pupils.csv").display().to_string();
    let ask = |file: &str, more: &[&str]| {
        std::fs::write(&path, file).expect("written");
        let out = carom(&[&["restitution", &path], more].concat());
        (out.status.code(), text(&out.stdout) + &text(&out.stderr))
    };
    // √(0.64 ± 0.15) with an exact height of 1: from 0.7 to √0.79 = 0.88881….
    let (code, said) = ask("height\n1.00\n0.64 ± 0.15\n", &[]);
    assert_eq!(code, Some(0), "{said}");
    assert!(said.contains("consistent with one e: 2 readings, e from 0.7000 to 0.8889"), "{said}");
    assert!(said.contains("lines 2 and 3 (1.00 and 0.64 ± 0.15)"), "{said}");
    // Times, a semicolon with decimal commas, runs, and an uncertainty that all share.
    let times = "run;time\nA;0,800\nB;0,640\nA;0,640\nB;0,510\n";
    let (code, said) = ask(times, &["--within", "1 %"]);
    assert_eq!(code, Some(0), "{said}");
    assert!(said.contains("e = 0.799 ± 0.015") && said.contains("4 readings"), "{said}");
    let (code, said) = ask(times, &["--within", "0.0001"]);
    assert_eq!(code, Some(1), "0.640/0.800 and 0.510/0.640 differ: {said}");
    let (code, said) = ask("drop,bounce\n1.00(1),0.64(1)\n1.00(1),0.49(1)\n", &[]);
    assert_eq!(code, Some(1), "{said}");
    assert!(
        said.contains("no e fits 4 readings") && said.contains("line 2 (1.00(1) and 0.64(1)): e is at least 0.78"),
        "{said}"
    );
    assert!(said.contains("line 3 (1.00(1) and 0.49(1)): e is at most 0.71"), "{said}");
    let (code, said) = ask("drop,bounce\n1.00,1.01\n", &["--format", "json"]);
    assert_eq!(code, Some(1), "{said}");
    let value: serde_json::Value = serde_json::from_str(&said).expect("JSON");
    assert_eq!(
        (&value["consistent"], &value["at_most"]["decimal"], &value["at_most"]["lines"]),
        (&false.into(), &"1.000".into(), &serde_json::Value::Null)
    );
    for (file, sign) in [
        ("", "no heading"),
        ("width\n1\n", "expected a column height"),
        ("height,time\n1,2\n", "keep only one of the two columns"),
        ("height\n1\n", "2 readings of a run are needed"),
        ("height\n1\n-1\n", "must be above 0"),
        ("height\n1\n0.5 ± 0.6\n", "must be above 0"),
        ("height\n1\none\n", "pupils.csv:3"),
        ("height\n1\n2(\n", "57.1(1)"),
    ] {
        let (code, said) = ask(file, &[]);
        assert_eq!(code, Some(2), "{file:?}: {said}");
        assert!(said.contains(sign), "{file:?}: {said}");
    }
}

#[test]
fn a_drop_is_the_chain_in_the_frame_that_falls_with_the_upper_balls() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("drop.toml").display().to_string();
    // Unequal ratios; 1 + u = (1 + e_f)·∏ (1 + e)·m/(m + m'): 3/2 · (3/2·6/8) · (1·2/3) = 9/8, and u = 1/8.
    std::fs::write(
        &path,
        "[drop]\nmasses = [\"6\", \"2\", \"1\"]\nfloor = \"1/2\"\nrestitution = [\"1/2\", \"0\"]\nheight = \"2\"\n",
    )
    .expect("written");
    let found: serde_json::Value = serde_json::from_str(&good(&["eval", &path, "--format", "json"])).expect("JSON");
    assert_eq!((&found["velocities"][2]["exact"], &found["rise"]["exact"]), (&"1/8".into(), &"1/64".into()), "{found}");
    assert_eq!(found["height"]["exact"], "1/32");
    // Elastic, three to one: the lower ball stops and the upper one leaves with 2v, so it rises to 4 times the height.
    std::fs::write(&path, "[drop]\nmasses = [3, 1]\nrestitution = 1\n").expect("written");
    assert!(
        good(&["eval", &path]).contains("rises to 4.00000000000000 times"),
        "the frame: {}",
        good(&["eval", &path])
    );
    let want = carom(&["eval", &path, "--want", "eta"]);
    assert_eq!(want.status.code(), Some(2));
    for (slip, sign) in [
        ("[drop]\nmasses = [3]\nrestitution = 1\n", "2 masses are needed"),
        ("[drop]\nmasses = [3, 1]\n", "[drop] has no restitution"),
        ("[drop]\nmasses = [3, 1]\nrestitution = [1, 1]\n", "1 coefficients of restitution are needed"),
        ("[drop]\nmasses = [3, 1]\nrestitution = 1\nfloor = 2\n", "from 0 to 1"),
        ("[drop]\nmasses = [3, 1]\nrestitution = 1\nhight = 2\n", "did you mean height?"),
        ("units = { mass = \"5\" }\n[drop]\nmasses = [3, 1]\nrestitution = 1\n", "is not a unit"),
    ] {
        std::fs::write(&path, slip).expect("written");
        let out = carom(&["eval", &path]);
        assert_eq!(out.status.code(), Some(2), "{slip}");
        assert!(text(&out.stderr).contains(sign), "{slip}: {}", text(&out.stderr));
    }
}

#[test]
fn a_cross_table_has_each_value_once_under_its_heading() {
    let grid = ["table", "--ratio", "2;10", "-e", "0.5,0.8,1", "-n", "0:4:1", "--digits", "5"];
    let cross = good(&[&grid[..], &["--across", "n"]].concat());
    let long = good(&[&grid[..], &["--format", "csv"]].concat());
    // Two tables, one for each ratio, with three rows and five columns of numbers.
    let tables: Vec<&str> = cross.split("ratio = ").skip(1).collect();
    assert_eq!(tables.len(), 2, "{cross}");
    for line in long.lines().filter(|l| l.starts_with(|c: char| c.is_ascii_digit())) {
        let cells: Vec<&str> = line.split(',').collect();
        let [ratio, e, n, eta] = cells[..4] else { panic!("{line}") };
        let table = tables.iter().find(|t| t.starts_with(&format!("{ratio};"))).expect("a table");
        let row = table.lines().find(|l| l.split_whitespace().next() == Some(e)).expect("a row");
        let place: usize = n.parse().expect("a number");
        assert_eq!(row.split_whitespace().nth(place + 1), Some(eta), "{line}: {cross}");
    }
    assert!(
        cross.lines().all(|l| l.starts_with("further:")
            || l.starts_with("formula:")
            || l.starts_with("equation:")
            || l.chars().count() <= 84),
        "{cross}"
    );
    // Wider than a page: cut into several tables, and every column is there.
    let wide = good(&["table", "--ratio", "7", "-e", "0.5,1", "-n", "0:30:1", "--digits", "12", "--across", "n"]);
    assert_eq!(
        (0..=30)
            .filter(|n| wide.matches(&format!("n = {n} ")).count() + wide.matches(&format!("n = {n}\n")).count() == 1)
            .count(),
        31,
        "{wide}"
    );
    assert!(wide.lines().skip(5).all(|l| l.chars().count() <= 84), "{wide}");
    let fractions = good(&["table", "--ratio", "1;4", "-e", "0.5,1", "-n", "0,1", "--across", "e", "--fractions"]);
    assert!(fractions.contains("9/16") && fractions.contains("16/25"), "{fractions}");
    let latex = good(&[&grid[..], &["--across", "e", "--format", "latex"]].concat());
    assert_eq!(latex.matches("\\toprule").count(), 2);
    assert!(
        latex.contains("{$m_1/m_2 = 10$, $n$}") && latex.contains("{$e = 0.8$}") && latex.contains("table-format=1.5"),
        "{latex}"
    );
    let csv = good(&[&grid[..], &["--across", "n", "--format", "csv"]].concat());
    assert_eq!(csv.lines().filter(|l| !l.starts_with('#')).count(), 1 + 2 * 3, "one table for other programs: {csv}");
    let plain = good(&["table", "--ratio", "4", "-e", "1", "-n", "0", "--no-exact", "--format", "csv"]);
    assert!(plain.ends_with("ratio,e,n,eta\n4,1,0,0.640000\n") && !plain.contains("# exact"), "{plain}");
    for (more, sign) in [
        (&["--across", "n", "--want", "best-n"][..], "has the axes"),
        (&["--across", "e", "--format", "json"], "leave --across out"),
        (&["--fractions"], "--across"),
    ] {
        let mut arguments = vec!["table", "--ratio", "2;10", "-e", "0.5"];
        if !more.contains(&"best-n") {
            arguments.extend(["-n", "1"]);
        }
        arguments.extend(more);
        let out = carom(&arguments);
        assert_eq!(out.status.code(), Some(2), "{more:?}");
        assert!(text(&out.stderr).contains(sign), "{more:?}: {}", text(&out.stderr));
    }
}

#[test]
fn pictures_have_the_title_the_limits_and_the_own_points_that_are_asked_for() {
    let folder = tempfile::tempdir().expect("a folder");
    let drawn = |arguments: &[&str], end: &str| {
        let path = folder.path().join(format!("picture.{end}"));
        good(&[&["plot"], arguments, &["-o", &path.display().to_string()]].concat());
        text(&std::fs::read(&path).expect("written"))
    };
    let svg = drawn(
        &[
            "eta-x",
            "-e",
            "0.8",
            "-n",
            "0,1",
            "--ratio",
            "1,20",
            "--title",
            "Two balls",
            "--ylim",
            "0.2,0.6",
            "--mark",
            "10.6 ± 0.4,0.31(2)",
            "--at",
            "10",
        ],
        "svg",
    );
    assert!(svg.contains("<title>Two balls</title>") && svg.contains("η from 0.2 to 0.6"), "{svg}");
    assert!(svg.contains("aria-label=\"measured\"") && svg.contains("aria-label=\"at 10:\""));
    // eta of the table is what the legend says at the marked ratio.
    for n in ["0", "1"] {
        let table = good(&["table", "--ratio", "10", "-e", "0.8", "-n", n, "--format", "csv"]);
        let eta = table.lines().last().and_then(|l| l.split(',').nth(3)).expect("a value").to_owned();
        assert!(svg.contains(&format!("aria-label=\"n = {n}: {eta}\"")), "{eta}: {svg}");
    }
    // Nothing is drawn outside of the frame, from 78 to 510 across and from 44 to 378 down.
    let (curves, _) = svg.rsplit_once("stroke-width=\"1.8\"").expect("curves");
    for curve in curves.split("stroke-width=\"1.8\"") {
        let points = curve.rsplit("points=\"").next().and_then(|t| t.split('"').next()).expect("points");
        for point in points.split(' ') {
            let (x, y) = point.split_once(',').expect("a point");
            let (x, y): (f64, f64) = (x.parse().expect("x"), y.parse().expect("y"));
            // The keys of the legend stand right of the frame.
            assert!((77.9..=510.1).contains(&x) && (43.9..=378.1).contains(&y) || x > 520.0, "{x} {y}");
        }
    }
    for picture in [
        &["map", "--ylim", "0.5,0.9"][..],
        &["threshold", "--xlim", "2,50"],
        &["eta-n", "--xlim", "0,5", "--ylim", "0,0.5"],
    ] {
        let grey = drawn(&[picture, &["--grey"]].concat(), "svg");
        for colour in
            grey.split('#').skip(1).filter_map(|t| t.get(..6)).filter(|t| t.bytes().all(|b| b.is_ascii_hexdigit()))
        {
            assert!(colour[..2] == colour[2..4] && colour[2..4] == colour[4..], "{picture:?}: {colour} is no grey");
        }
    }
    let pdf = drawn(&["velocities", &scene("three-balls-measured")], "pdf");
    assert!(pdf.starts_with("%PDF-1.4") && pdf.contains("/ToUnicode"));
    for (more, sign) in [
        (&["eta-x", "--ylim", "1,0"][..], "write the smaller number first"),
        (&["eta-x", "--ylim", "1"], "write two numbers"),
        (&["eta-x", "--xlim", "0,1"], "begins above 0"),
        (&["eta-x", "--mark", "1e9,0.5"], "outside of the picture"),
        (&["eta-x", "--mark", "3"], "write X,Y"),
        (&["map", "--at", "3"], "no curves to mark"),
    ] {
        let out = carom(&[&["plot"], more, &["-o", &folder.path().join("no.svg").display().to_string()]].concat());
        assert_eq!(out.status.code(), Some(2), "{more:?}");
        assert!(text(&out.stderr).contains(sign), "{more:?}: {}", text(&out.stderr));
    }
}

/// The words of a line, with those in quotation marks in one piece, up to a comment.
fn words(line: &str) -> Vec<String> {
    let line = line.split(" #").next().unwrap_or(line);
    let pieces = line.split('"').enumerate();
    pieces
        .flat_map(|(place, piece)| match place % 2 {
            1 => vec![piece.to_owned()],
            _ => piece.split_whitespace().map(str::to_owned).collect(),
        })
        .collect()
}

#[test]
fn every_command_of_the_page_for_teachers_runs_and_prints_what_it_shows() {
    let page = include_str!("../../docs/classroom.md");
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name);
    std::fs::write(path("pupils.csv"), "height\n1.20\n0.77\n0.49\n0.31\n").expect("written");
    std::fs::write(path("pairs.csv"), "drop,bounce\n1.00 ± 0.01,0.64 ± 0.01\n1.00 ± 0.01,0.49 ± 0.01\n")
        .expect("written");
    let run = |line: &str| {
        let examples = format!("{}/examples/", env!("CARGO_MANIFEST_DIR"));
        let arguments: Vec<String> =
            words(line).into_iter().skip(1).map(|word| word.replace("examples/", &examples)).collect();
        let out = Command::new(env!("CARGO_BIN_EXE_carom")).args(&arguments).current_dir(folder.path()).output();
        let out = out.expect("the program starts");
        assert!(matches!(out.status.code(), Some(0 | 1)), "{line}: {}", text(&out.stderr));
        text(&out.stdout)
    };
    let commands: Vec<&str> = page.lines().filter(|l| l.starts_with("carom ")).collect();
    assert!(commands.len() >= 10, "{commands:?}");
    commands.iter().for_each(|line| drop(run(line)));
    let mut shown = 0;
    for block in page.split("```console\n").skip(1) {
        let block = block.split("```").next().expect("it ends");
        for part in block.split("$ ").filter(|part| part.starts_with("carom ")) {
            let (line, answer) = part.split_once('\n').expect("an answer");
            assert_eq!(run(line), answer, "{line}");
            shown += 1;
        }
    }
    assert_eq!(shown, 3);
}
