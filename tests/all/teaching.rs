//! Examples, worksheets, pictures and random chains, as a teacher meets them.

use crate::support::{carom, good, text};
use carom::number::rational::parse;
use malachite::Rational;
use std::path::Path;
use std::process::Command;

fn scene(name: &str) -> String {
    format!("examples/scenes/{name}.toml")
}

fn exact(name: &str) -> serde_json::Value {
    serde_json::from_str(&good(&["eval", &scene(name), "--format", "json"])).expect("JSON")
}

#[test]
fn every_example_runs_and_is_listed() {
    let list = include_str!("../../examples/README.md");
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/scenes");
    let mut count = 0;
    for entry in std::fs::read_dir(folder).expect("there").flatten() {
        let path = entry.path();
        let name = path.file_name().expect("a file").to_string_lossy().into_owned();
        assert!(list.contains(&format!("`scenes/{name}`")), "{name} is listed");
        good(&["eval", &path.display().to_string()]);
        count += 1;
    }
    assert_eq!(count, list.matches("| `scenes/").count(), "everything listed is there");
    for line in list.lines().filter(|l| l.starts_with("carom table") && !l.contains("--check")) {
        let command = line.split('#').next().expect("a command");
        good(&command.split_whitespace().skip(1).collect::<Vec<_>>());
    }
}

#[test]
fn the_examples_show_what_they_say() {
    let value = exact("stacked-balls-16-times");
    let velocities: Vec<&str> =
        value["velocities"].as_array().expect("a list").iter().filter_map(|v| v["exact"].as_str()).collect();
    assert_eq!(velocities, ["0", "0", "0", "4"], "all others stand still");
    assert_eq!((&value["rise"]["exact"], &value["height"]["exact"]), (&"16".into(), &"8".into()));
    assert_eq!(exact("on-the-threshold")["helps"], "exactly on the threshold");
    assert_eq!(exact("on-the-threshold")["threshold"]["exact"], "44/81");
    assert_eq!(exact("measured-restitution")["helps"], "depends");
    assert!(good(&["eval", &scene("car-chain")]).contains("meet again"));
    let eta = exact("elastic-limit")["eta"]["decimal"].as_str().expect("a decimal").to_owned();
    assert!(eta.starts_with("0.99"), "{eta}");
}

/// The numbers of the row of a worksheet's table that begins so.
fn row(table: &str, name: &str) -> Vec<Rational> {
    let line = table.lines().find(|l| l.trim_start().starts_with(name)).unwrap_or_else(|| panic!("{name}: {table}"));
    line.split_whitespace().filter_map(|w| parse(w).ok()).collect()
}

#[test]
fn the_answer_key_obeys_the_laws() {
    for name in ["equal-masses", "car-chain", "stacked-balls-16-times"] {
        let key = good(&["worksheet", &scene(name), "--sheet", "key", "--exact", "--places", "9"]);
        let tolerance = parse("2e-8").expect("a number");
        let near = |a: &Rational, b: &Rational| {
            let d = a - b;
            let d = if d < 0u32 { -d } else { d };
            let scale = if *b < 0u32 { -b } else { b.clone() };
            d <= &tolerance * (Rational::from(1) + scale)
        };
        let tables: Vec<&str> = key.split("\nCollision ").skip(1).collect();
        assert!(tables.len() >= 3, "{key}");
        for table in tables {
            let mass = row(table, "mass");
            let [v, w, dv] = ["before", "after", "change"].map(|part| row(table, &format!("velocity {part}")));
            let [p, q, dp] = ["before", "after", "change"].map(|part| row(table, &format!("momentum {part}")));
            let [k, l, dk] = ["before", "after", "change"].map(|part| row(table, &format!("kinetic energy {part}")));
            let half = parse("1/2").expect("a number");
            for body in 0..2 {
                let (m, v, w) = (&mass[body], &v[body], &w[body]);
                assert!(near(&dv[body], &(w - v)) && near(&p[body], &(m * v)) && near(&q[body], &(m * w)), "{table}");
                assert!(near(&dp[body], &(&q[body] - &p[body])) && near(&dk[body], &(&l[body] - &k[body])), "{table}");
                assert!(near(&k[body], &(m * v * v * &half)) && near(&l[body], &(m * w * w * &half)), "{table}");
            }
            assert_eq!((&p[2], &dp[2]), (&q[2], &Rational::from(0)), "momentum stays: {table}");
            for total in [&p, &q, &k, &l, &dk] {
                assert!(near(&total[2], &(&total[0] + &total[1])), "{name}: {table}");
            }
            assert!(dk[2] <= 0u32, "{table}");
        }
    }
}

#[test]
fn a_blank_sheet_gives_nothing_away_and_every_form_is_whole() {
    let blank = good(&["worksheet", &scene("car-chain"), "--sheet", "blank"]);
    assert!(blank.contains("1500") && blank.contains("_______") && blank.contains("Name:"), "{blank}");
    assert!(!blank.contains("[x]"), "no prediction is ticked: {blank}");
    let key = good(&["worksheet", &scene("car-chain"), "--sheet", "key"]);
    for number in key.split_whitespace().filter(|w| w.contains('.') && w.len() > 4 && parse(w).is_ok()) {
        assert!(!blank.contains(number), "{number}: {blank}");
    }
    assert!(key.contains("meet again") && key.contains("[x] no\n"), "{key}");
    let both = good(&["worksheet", &scene("car-chain"), "--format", "markdown"]);
    assert_eq!(both.matches("kinetic energy change").count(), 6, "{both}");
    let latex = good(&["worksheet", &scene("stacked-balls"), "--format", "latex"]);
    assert!(latex.contains("\\newpage\n") && latex.contains("answer key}"), "pupils do not get the key");
    assert!(latex.contains("a4paper") && latex.ends_with("\\end{document}\n"), "{latex}");
    let html = good(&["worksheet", &scene("stacked-balls"), "--format", "html", "--paper", "letter"]);
    assert!(html.contains("size: letter") && html.contains("break-after: page") && html.contains("<script>"), "{html}");
    let fields = html.matches(" aria-label=\"Collision ").count();
    // In each of three collisions: velocities after and changed, momenta and energies with their sums; and the velocity
    // with which the first body of the second and third arrives.
    assert_eq!(fields, 3 * (4 + 9 + 9) + 2);
    assert_eq!(html.matches(" checked>").count(), 4, "one answer to each prediction, on the key alone");
    let out = carom(&["worksheet", &scene("elastic-limit")]);
    assert_eq!(out.status.code(), Some(3), "1001 collisions: {}", text(&out.stderr));
    let out = carom(&["worksheet", &scene("measured-restitution")]);
    assert_eq!(out.status.code(), Some(2), "optimal masses, measured: {}", text(&out.stderr));
    // Irrational masses: to any number of digits.
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("root.toml");
    std::fs::write(&path, "[chain]\nfirst = \"2\"\nlast = \"1\"\ninserted = 1\nrestitution = \"1/2\"\n")
        .expect("written");
    let shown = good(&["worksheet", &path.display().to_string(), "--digits", "30"]);
    assert!(shown.contains("1.41421356237309504880168872421"), "{shown}");
}

/// A picture's file.
fn drawn(folder: &Path, arguments: &[&str], end: &str) -> Vec<u8> {
    let path = folder.join(format!("picture.{end}"));
    let _ = std::fs::remove_file(&path);
    good(&[&["plot"], arguments, &["-o", &path.display().to_string()]].concat());
    std::fs::read(&path).expect("written")
}

#[test]
fn every_picture_is_drawn_in_both_forms() {
    let folder = tempfile::tempdir().expect("a folder");
    let cradle = scene("equal-masses");
    for arguments in [
        &["eta-x", "-n", "0,1,5"][..],
        &["eta-n", "--ratio", "100", "-e", "0.5,0.9,1"],
        &["threshold"],
        &["map", "--ratio", "1/100,100"],
        &["velocities", &cradle],
    ] {
        let svg = text(&drawn(folder.path(), arguments, "svg"));
        assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"), "{arguments:?}");
        assert!(svg.contains("<title>") && svg.matches("aria-label").count() > 8, "axes have labels: {arguments:?}");
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{arguments:?}");
        let png = drawn(folder.path(), arguments, "png");
        assert_eq!(&png[..8], b"\x89PNG\r\n\x1a\n");
        // The size stands in the header: two pixels for each point. Only a note makes an ordinary page higher.
        let height = if arguments[0] == "velocities" { 458u32 } else { 440 };
        assert!(svg.contains(&format!("width=\"690\" height=\"{height}\"")), "{arguments:?}");
        assert_eq!((&png[16..20], &png[20..24]), (&1380u32.to_be_bytes()[..], &(2 * height).to_be_bytes()[..]));
    }
    // What is raised is said to be.
    let svg = text(&drawn(folder.path(), &["map", "--ratio", "1/1000,1000"], "svg"));
    assert!(svg.contains("aria-label=\"10^2\"") && svg.contains("aria-label=\"10^−2\""), "ticks are powers of ten");
    assert!(svg.contains("mass ratio m1/m2"), "{svg}");
    // n* = 6 for 100 : 1 at 0.9 (the published value) is what the legend says.
    let svg = text(&drawn(folder.path(), &["eta-n", "-e", "0.9"], "svg"));
    assert!(svg.contains("e = 0.9, n* = 6"), "n* is marked");
}

#[test]
fn pictures_that_cannot_be_drawn_are_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).display().to_string();
    for (arguments, code, sign) in [
        (vec!["eta-x", "-o", "PICTURE.gif"], 2, ".svg, .png or .pdf"),
        (vec!["eta-x", "--ratio", "10;1", "-o", "PICTURE.svg"], 2, "smaller one first"),
        (vec!["eta-x", "-n", "0,1,2,3,4,5,6,7", "-o", "PICTURE.svg"], 2, "at most 7 curves"),
        (vec!["eta-n", "--ratio", "1;2", "-o", "PICTURE.svg"], 2, "one mass ratio"),
        (vec!["velocities", "-o", "PICTURE.svg"], 2, "scene file"),
        (vec!["map", "-e", "1", "-o", "PICTURE.svg"], 2, "`plot map` does not take -e"),
        (vec!["map", "--scale", "1000", "-o", "PICTURE.png"], 3, "limit reached"),
        (vec!["map", "--scale", "inf", "-o", "PICTURE.png"], 3, "limit reached"),
        (vec!["map", "--scale", "NaN", "-o", "PICTURE.png"], 2, "--scale: NaN is not a usable scale"),
        (vec!["map", "--scale", "0", "-o", "PICTURE.png"], 2, "--scale: 0 is not a usable scale"),
        (vec!["map", "--scale", "-1", "-o", "PICTURE.png"], 2, "--scale: -1 is not a usable scale"),
        (vec!["eta-x", "--ratio", "1e99999,2", "-o", "PICTURE.svg"], 3, "limit reached"),
        (vec!["eta-x", "--ratio", "-1,2", "-o", "PICTURE.svg"], 2, "--ratio: a mass must be above 0"),
        (vec!["eta-x", "-e", "-0.5", "-o", "PICTURE.svg"], 2, "-e: a coefficient of restitution"),
        (vec!["eta-n", "-e", "0.5,1/2", "-o", "PICTURE.svg"], 2, "1/2 is given twice"),
        (
            vec!["map", "--ratio", "1,1.0", "-o", "PICTURE.svg"],
            2,
            "--ratio 1,1.0: the two ends are the same; write a range",
        ),
        (
            vec!["velocities", "examples/scenes/measured-restitution.toml", "-o", "PICTURE.svg"],
            2,
            "picture of velocities of optimal masses",
        ),
    ] {
        let arguments: Vec<String> =
            arguments.iter().map(|a| if a.starts_with("PICTURE") { path(a) } else { (*a).to_owned() }).collect();
        let out = carom(&[&["plot"], &arguments.iter().map(String::as_str).collect::<Vec<_>>()[..]].concat());
        assert_eq!(out.status.code(), Some(code), "{arguments:?}");
        assert!(text(&out.stderr).contains(sign), "{arguments:?}: {}", text(&out.stderr));
    }
    assert_eq!(std::fs::read_dir(folder.path()).expect("there").count(), 0, "nothing is left behind");
}

/// What the program prints within some seconds; it is ended where it does not end.
fn within(seconds: u64, arguments: &[&str]) -> String {
    let mut child = Command::new(env!("CARGO_BIN_EXE_carom"))
        .args(arguments)
        .stdout(std::process::Stdio::piped())
        .spawn()
        .expect("the program starts");
    let started = std::time::Instant::now();
    while child.try_wait().expect("it can be asked").is_none() {
        if started.elapsed().as_secs() >= seconds {
            child.kill().expect("it runs");
            child.wait().expect("it ends");
            panic!("{arguments:?} does not end");
        }
        std::thread::sleep(std::time::Duration::from_millis(10));
    }
    let out = child.wait_with_output().expect("it ends");
    assert_eq!(out.status.code(), Some(0), "{arguments:?}");
    text(&out.stdout)
}

#[test]
fn rational_entries_of_irrational_chains_are_known_to_be_rational() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("tie.toml").display().to_string();
    let sheet = |chain: &str, digits: &str| {
        std::fs::write(&path, format!("[chain]\n{chain}\n")).expect("written");
        let more: &[&str] = if digits == "exact" { &["--exact"] } else { &["--digits", digits] };
        let shown = within(20, &[&["worksheet", &path, "--sheet", "key"], more].concat());
        // For each collision the cells of the first body, of the second one, and of both together.
        let mut rows: Vec<Vec<String>> = Vec::new();
        for table in shown.split("\nCollision ").skip(1) {
            let lines: Vec<Vec<&str>> = table
                .lines()
                .map(|l| l.trim().split("  ").map(str::trim).filter(|c| !c.is_empty()).collect())
                .collect();
            let column = |place: usize, head: String| {
                let cells = lines.iter().skip(2).take_while(|l| l.len() > 1).filter_map(|l| l.get(place));
                std::iter::once(head).chain(cells.map(|c| (*c).to_owned())).collect::<Vec<_>>()
            };
            let body = |place: usize| lines[1][place].trim_start_matches("body ").to_owned();
            rows.extend([column(1, body(0)), column(2, body(1)), column(3, "total".to_owned())]);
        }
        rows
    };
    // Energies of the first body, and of both, end in a tie: 6172.5 and 0.50025.
    let rows = sheet("first = \"12345\"\nlast = \"1\"\ninserted = 1\nrestitution = \"1\"", "4");
    assert_eq!(rows.iter().filter(|r| r.concat().contains("6172")).count(), 2, "{rows:?}");
    let rows = sheet("first = \"1.0005\"\nlast = \"1\"\ninserted = 1\nrestitution = \"1\"", "4");
    assert!(rows.iter().flatten().any(|c| c == "0.5002"), "{rows:?}");
    let rows = sheet("first = 1\nlast = 2\ninserted = 3\nspeed = \"1.0005\"\nrestitution = \"1/3\"", "4");
    assert!(rows.iter().flatten().any(|c| c == "1.000"), "{rows:?}");
    // x² = 1/5 and e = 1/7: the second body loses m1·320/2401 in the second collision, though x is irrational.
    let chain = "first = \"7.50350015625\"\nlast = \"37.51750078125\"\ninserted = 1\nrestitution = \"1/7\"";
    let rows = sheet(chain, "5");
    let second: Vec<_> = rows.iter().filter(|r| r[0] == "2").collect();
    assert_eq!(second[1].last().map(String::as_str), Some("-1.0000"), "{rows:?}");
    let chain = "first = \"2401\"\nlast = \"12005\"\ninserted = 1\nrestitution = \"1/7\"";
    let rows = sheet(chain, "exact");
    let second: Vec<_> = rows.iter().filter(|r| r[0] == "2").collect();
    assert_eq!(second[1].last().map(String::as_str), Some("-320"), "{rows:?}");
    assert_ne!(second[0].last().map(String::as_str), Some("-320"));
    // The same with more bodies and other collisions: x² = 1/5 with e = 1/10 in the third, 1/6 with 1857/10033 in the fourth.
    for (last, inserted, e, place) in [("25", 3, "1/10", 2), ("216", 5, "1857/10033", 3), ("625", 7, "29/275", 4)] {
        let x2 = if last == "216" { 6.0 } else { 5.0 };
        let (x, e_value) = (f64::sqrt(1.0 / x2), e.split_once('/').expect("p/q"));
        let e_value = e_value.0.parse::<f64>().expect("p") / e_value.1.parse::<f64>().expect("q");
        let chain = format!("first = 1\nlast = {last}\ninserted = {inserted}\nrestitution = \"{e}\"");
        let rows = sheet(&chain, "12");
        let arrival = ((1.0 + e_value) * x / (1.0 + x)).powi(place);
        let energy = 0.5 * x.powi(-place) * arrival * arrival;
        let wanted = energy * (((x - e_value) / (x + 1.0)).powi(2) - 1.0);
        let row = rows.iter().filter(|r| r[0] == (place + 1).to_string()).nth(usize::from(place > 0)).expect("a row");
        let found: f64 = row.last().expect("a cell").parse().expect("a number");
        assert!((found / wanted - 1.0).abs() < 1e-9, "{found} {wanted}: {rows:?}");
    }
}

#[test]
fn worksheets_have_cells_of_any_length() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("long.toml").display().to_string();
    std::fs::write(&path, "[chain]\nfirst = 2\nlast = 1\ninserted = [1]\nrestitution = \"1/3\"\n").expect("written");
    for format in ["text", "markdown", "latex"] {
        assert!(good(&["worksheet", &path, "--digits", "70000", "--format", format]).len() > 70_000);
    }
}

/// A random chain of a few bodies as a scene file.
pub(crate) fn random_chain(seed: u64) -> String {
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15).wrapping_add(1);
    let mut below = |count: u64| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) % count
    };
    let bodies = 2 + below(4);
    let masses: Vec<String> = (0..bodies).map(|_| format!("\"{}\"", 1 + below(9))).collect();
    let choices = ["1", "1/2", "1/5", "9/10", "3/4", "0"];
    let e: Vec<String> = (1..bodies).map(|_| format!("\"{}\"", choices[below(6) as usize])).collect();
    let start = match below(3) {
        0 => format!("velocities = [{}]", (0..bodies).map(|k| (bodies - k).to_string()).collect::<Vec<_>>().join(", ")),
        _ => format!("speed = {}", 1 + below(12)),
    };
    let inserted = masses[1..masses.len() - 1].join(", ");
    format!(
        "[chain]\nfirst = {}\nlast = {}\ninserted = [{inserted}]\nrestitution = [{}]\n{start}\n",
        masses[0],
        masses[masses.len() - 1],
        e.join(", ")
    )
}

#[test]
fn forty_answer_keys_are_what_the_exact_replay_shows() {
    use carom::chain::replay::{Body, Line, Options, Status, replay};
    use carom::number::decimal::Digits;
    use carom::report::worksheet::made::{Wanted, sheets};
    use carom::report::worksheet::{Cell, Part, Style};
    use carom::scene::read::described;
    let style = Style { digits: Digits::Significant(12), exact: true };
    let wanted = |versions| Wanted { title: "t", standard: None, blank: false, key: true, versions, seed: 1, style };
    let mut asked = std::collections::BTreeSet::new();
    let (mut judged, mut met_again, mut open) = (0, 0, 0);
    for seed in 0.. {
        if judged == 40 {
            break;
        }
        let scene = random_chain(seed);
        let (about, subject) = described(&scene).expect("a scene");
        // A pass that does not take place makes no sheet.
        let (Ok(made), Ok(versions)) = (sheets(&about, &subject, &wanted(0)), sheets(&about, &subject, &wanted(3)))
        else {
            continue;
        };
        judged += 1;
        for (place, key) in made.iter().chain(&versions).enumerate() {
            let texts: Vec<&str> = key
                .parts
                .iter()
                .filter_map(|part| if let Part::Text(text) = part { Some(text.as_str()) } else { None })
                .collect();
            let all = texts.join(" ");
            // The pass, from the tables.
            let tables: Vec<_> = key
                .parts
                .iter()
                .filter_map(|part| if let Part::Table(table) = part { Some(table) } else { None })
                .collect();
            let row = |table: &carom::report::worksheet::Table, name: &str| -> Vec<Rational> {
                let row = table.groups.iter().flatten().find(|row| row.name == name).expect(name);
                let read = |cell: &Cell| if let Cell::Number(text) = cell { parse(text).ok() } else { None };
                row.cells.iter().filter_map(read).collect()
            };
            let (masses, before) = (row(tables[0], "mass"), row(tables[0], "velocity before"));
            let collisions = &tables[1..];
            let e: Vec<Rational> = collisions
                .iter()
                .map(|table| parse(table.title.split("e = ").nth(1).expect("e")).expect("a number"))
                .collect();
            // The key is judged where it speaks of the end: by a replay at the gaps that the sheet names.
            let ratio = match all.split("each gap is ").nth(1) {
                Some(rest) => parse(rest.split(' ').next().expect("a word")).expect("a ratio"),
                None => Rational::from(1),
            };
            let again = all.contains("meet again");
            if all.contains("the sheet ends before") {
                // Then nothing is asked about the end.
                open += u64::from(place == 0);
                for part in &key.parts {
                    if let Part::Choice { ask, .. } = part {
                        assert!(!ask.contains("last collision"), "{scene}: {ask}");
                    }
                }
                continue;
            }
            met_again += u64::from(again && place == 0);
            let (mut place, mut gap) = (Rational::from(0), Rational::from(1));
            let bodies: Vec<Body> = masses
                .iter()
                .zip(&before)
                .map(|(mass, velocity)| {
                    let position = place.clone();
                    place += &gap;
                    gap *= &ratio;
                    Body { mass: mass.clone(), position, velocity: velocity.clone(), length: Rational::from(0) }
                })
                .collect();
            let line = Line::new(&bodies, &e, None, None).expect("a line");
            let options = Options { through_collapse: true, ..Options::default() };
            let outcome = replay(&line, &options).expect("the ledger balances");
            let end: Vec<Rational> = outcome.velocities.iter().map(|v| v.rational().expect("exact").clone()).collect();
            // Without a second meeting the order is that of the sheet; its own velocities are the last ones.
            let end = if again {
                assert!(matches!(outcome.status, Status::Complete), "{scene}");
                for (k, event) in outcome.events.iter().take(collisions.len()).enumerate() {
                    let after: Vec<Rational> =
                        event.after.iter().map(|v| v.rational().expect("exact").clone()).collect();
                    assert_eq!(event.pair, k + 1, "{scene}");
                    assert_eq!(row(collisions[k], "velocity after"), after, "{scene}");
                }
                end
            } else {
                let first = collisions.iter().map(|table| row(table, "velocity after")[0].clone());
                first.chain(collisions.last().map(|table| row(table, "velocity after")[1].clone())).collect()
            };
            assert!(end.windows(2).all(|pair| pair[0] <= pair[1]), "{scene}: a body moves through another: {end:?}");
            let size = |v: &Rational| if *v < 0u32 { -v } else { v.clone() };
            let change = |name: &str| row(collisions[0], name).iter().take(2).map(size).collect::<Vec<_>>();
            // Which of some sizes is the greatest, in the words of the sheet.
            let greatest = |sizes: &[Rational], all: &str| {
                let top = sizes.iter().max().expect("bodies");
                let right: Vec<usize> = (0..sizes.len()).filter(|k| sizes[*k] == *top).collect();
                match right.as_slice() {
                    [only] => format!("body {}", only + 1),
                    list => {
                        assert_eq!(list.len(), sizes.len(), "{scene}: {sizes:?}");
                        all.to_owned()
                    }
                }
            };
            let of = |yes: bool| if yes { "yes" } else { "no" }.to_owned();
            let speeds: Vec<Rational> = end.iter().map(size).collect();
            let less: Vec<Rational> = speeds.iter().map(|v| -v).collect();
            let energies: Vec<Rational> = end.iter().zip(&masses).map(|(v, m)| m * v * v).collect();
            for part in &key.parts {
                match part {
                    Part::Choice { ask, options, right } => {
                        let kind: &str = ask.split_once(". ").expect("a number").1;
                        let words =
                            kind.split(" after ").next().expect("a word").split(" in the end").next().expect("a word");
                        let answer = match words {
                            "Which body will be the fastest" => greatest(&speeds, "all are equally fast"),
                            "Which body will be the slowest" => greatest(&less, "all are equally fast"),
                            "Which body will have the most kinetic energy" => {
                                greatest(&energies, "all have equally much")
                            }
                            "Will any body move backwards" => of(end.iter().any(|v| *v < 0u32)),
                            "Will any body be at rest" => of(end.iter().any(|v| *v == 0u32)),
                            "Which way will body 1 move" => {
                                let way = ["to the left", "not at all", "to the right"];
                                way[(end[0].cmp(&Rational::from(0)) as i8 + 1) as usize].to_owned()
                            }
                            "Whose velocity will change more in collision 1?" => {
                                greatest(&change("velocity change"), "both change equally")
                            }
                            "Whose momentum will change more in collision 1?" => {
                                greatest(&change("momentum change"), "both change equally")
                            }
                            how_fast if how_fast.starts_with("How fast will body ") => {
                                let words = ["slower", "equally fast", "faster"];
                                words[(speeds[speeds.len() - 1].cmp(&size(&before[0])) as i8 + 1) as usize].to_owned()
                            }
                            lost => {
                                assert!(lost.starts_with("How much of the kinetic energy"), "{scene}: {ask}");
                                let lost = collisions.iter().map(|t| row(t, "kinetic energy change")[2].clone());
                                let first = masses.iter().zip(&before).map(|(m, v)| m * v * v / Rational::from(2));
                                let gone = lost.fold(Rational::from(0), |sum, c| sum - c);
                                let share = gone / first.fold(Rational::from(0), |sum, e| sum + e) * Rational::from(4);
                                let place = match share {
                                    share if share == 0u32 => 0,
                                    share if share < 1u32 => 1,
                                    share if share <= 2u32 => 2,
                                    _ => 3,
                                };
                                options[place].0.clone()
                            }
                        };
                        asked.insert(words.split(" body ").next().expect("a word").to_owned());
                        let ticked: Vec<&str> = options.iter().filter(|o| o.1).map(|o| o.0.as_str()).collect();
                        assert_eq!(ticked, [answer.as_str()], "{scene}: {ask}");
                        assert_eq!(
                            right.map(|right| options[right].0.as_str()),
                            Some(answer.as_str()),
                            "{scene}: {ask}"
                        );
                    }
                    Part::Open { ask, answer: Some(answer), .. } if ask.contains("meet again after") => {
                        if let Some(list) = answer.strip_prefix("Then these collide: ") {
                            let named: Vec<&str> = list.split(". In").next().expect("a list").split(", ").collect();
                            let later = outcome.events.iter().skip(collisions.len());
                            let later: Vec<String> = later.map(|e| format!("{}–{}", e.pair, e.pair + 1)).collect();
                            assert_eq!(named, later, "{scene}");
                        }
                        let list = answer.split("velocities are ").nth(1).expect("velocities");
                        let list: Vec<Rational> =
                            list.split(':').next().expect("a list").split(", ").filter_map(|v| parse(v).ok()).collect();
                        assert!(
                            list.iter().zip(&end).all(|(a, b)| size(&(a - b)) * Rational::from(10u64.pow(9)) < 1000u32)
                        );
                    }
                    _ => {}
                }
            }
        }
    }
    assert!(asked.len() >= 9, "kinds of questions that were judged: {asked:?}");
    assert!(met_again >= 8 && open <= 20, "{met_again} met again, {open} are open");
}

#[test]
fn a_sheet_of_stacked_balls_has_a_floor_and_heights() {
    for name in ["stacked-balls", "stacked-balls-16-times"] {
        let sheet = good(&["worksheet", &scene(name)]);
        for word in ["floor", "upwards", "height", "downwards", "dropped"] {
            assert!(sheet.contains(word), "{word}: {sheet}");
        }
        assert!(!sheet.contains("straight track") && !sheet.contains("to the right"), "{sheet}");
    }
    assert!(good(&["worksheet", &scene("stacked-balls-16-times"), "--sheet", "key"]).contains("To 16.00 times"));
}

#[test]
fn a_key_names_the_collisions_after_the_pass_and_the_last_velocities() {
    let blank = good(&["worksheet", &scene("car-chain"), "--sheet", "blank"]);
    assert!(blank.contains("After that, bodies meet again."), "{blank}");
    let key = good(&["worksheet", &scene("car-chain"), "--sheet", "key"]);
    assert!(key.contains("Then these collide: ") && key.contains("In the end the velocities are "), "{key}");
}
