//! Pictures read back from their files: each label inside its page, no two over one another, two numbers on each axis, and
//! each number where it belongs, over ordinary and extreme inputs.
#![allow(missing_docs, clippy::unwrap_used)]

use crate::support::{carom, text};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

fn plot(arguments: &[&str], file: &Path) -> (Option<i32>, String) {
    let output = carom(&[&["plot"], arguments, &["-o", file.to_str().unwrap()]].concat());
    (output.status.code(), text(&output.stderr))
}

/// A text with the rectangle that its letters cover.
#[derive(Debug)]
struct Label {
    text: String,
    upright: bool,
    left: f64,
    top: f64,
    right: f64,
    bottom: f64,
}

/// What an SVG shows, by its own numbers.
struct Picture {
    width: f64,
    height: f64,
    labels: Vec<Label>,
    /// Left, top, right, bottom.
    frame: (f64, f64, f64, f64),
    curves: Vec<Vec<(f64, f64)>>,
}

fn attribute<'a>(line: &'a str, name: &str) -> &'a str {
    let start = line.find(&format!(" {name}=\"")).unwrap_or_else(|| panic!("{line} has {name}")) + name.len() + 3;
    line[start..].split('"').next().unwrap()
}

fn numbers(text: &str) -> Vec<f64> {
    let signs = |c: char| !(c.is_ascii_digit() || c == '.' || c == '-');
    text.split(signs).filter(|t| !t.is_empty()).map(|t| t.parse().unwrap_or_else(|_| panic!("{t:?}"))).collect()
}

fn points(line: &str) -> Vec<(f64, f64)> {
    numbers(attribute(line, "points")).chunks(2).map(|p| (p[0], p[1])).collect()
}

impl Picture {
    fn read(svg: &str) -> Picture {
        let first = svg.lines().next().unwrap();
        let (mut glyphs, mut labels, mut curves) = (BTreeMap::new(), Vec::<Label>::new(), Vec::new());
        let (mut frame, mut place) = (None, (0.0, 0.0, false));
        for line in svg.lines() {
            if line.starts_with("<path id") {
                // Every control point: the letter lies within.
                let outline: Vec<(f64, f64)> = numbers(attribute(line, "d")).chunks(2).map(|p| (p[0], p[1])).collect();
                glyphs.insert(attribute(line, "id").to_owned(), outline);
            } else if line.starts_with("<g transform") {
                let at = numbers(attribute(line, "transform"));
                place = (at[0], at[1], at.len() == 3);
                let none = (f64::INFINITY, f64::NEG_INFINITY);
                let text = attribute(line, "aria-label").to_owned();
                labels.push(Label { text, upright: place.2, left: none.0, top: none.0, right: none.1, bottom: none.1 });
            } else if line.starts_with("<use ") {
                let at = numbers(attribute(line, "transform"));
                let label = labels.last_mut().unwrap();
                for (x, y) in &glyphs[attribute(line, "href").trim_start_matches('#')] {
                    let (x, y) = (at[0] + at[2] * x, at[1] + at[3] * y);
                    let (x, y) = if place.2 { (place.0 + y, place.1 - x) } else { (place.0 + x, place.1 + y) };
                    (label.left, label.right) = (label.left.min(x), label.right.max(x));
                    (label.top, label.bottom) = (label.top.min(y), label.bottom.max(y));
                }
            } else if line.starts_with("<polyline") {
                match (attribute(line, "stroke"), attribute(line, "stroke-width")) {
                    ("#000000", "1") if points(line).len() == 5 => {
                        let corners = points(line);
                        frame = Some((corners[0].0, corners[2].1, corners[1].0, corners[0].1));
                    }
                    (_, "1.8") => curves.push(points(line)),
                    _ => {}
                }
            }
        }
        let frame = frame.expect("a frame");
        // Legends have their pieces of curves beside the frame.
        curves.retain(|c| c[0].0 <= frame.2 + 1.0);
        let (width, height) = (numbers(attribute(first, "width"))[0], numbers(attribute(first, "height"))[0]);
        Picture { width, height, labels, frame, curves }
    }

    /// The numbers of the horizontal and of the vertical axis: middle of the label, value.
    fn axes(&self) -> [Vec<(f64, f64)>; 2] {
        let (left, top, right, bottom) = self.frame;
        let mut axes = [Vec::new(), Vec::new()];
        for label in self.labels.iter().filter(|l| !l.upright) {
            let (x, y) = ((label.left + label.right) / 2.0, (label.top + label.bottom) / 2.0);
            if y > bottom && y < bottom + 24.0 && x > left - 60.0 && x < right + 60.0 {
                axes[0].push((x, said(&label.text)));
            } else if label.right < left && y > top - 8.0 && y < bottom + 8.0 {
                axes[1].push((y, said(&label.text)));
            }
        }
        axes
    }

    /// What is wrong with it.
    fn faults(&self) -> Vec<String> {
        let mut out = Vec::new();
        for label in &self.labels {
            // A text of spaces has no letters.
            if label.left < 1.0 || label.top < 1.0 || label.right > self.width - 1.0 || label.bottom > self.height - 1.0
            {
                out.push(format!("{label:?} is not on the page of {} by {}", self.width, self.height));
            }
        }
        for (place, a) in self.labels.iter().enumerate() {
            for b in &self.labels[place + 1..] {
                if a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom {
                    out.push(format!("{:?} lies over {:?}", a.text, b.text));
                }
            }
        }
        for (axis, ticks) in ["horizontal", "vertical"].iter().zip(self.axes()) {
            if ticks.len() < 2 {
                out.push(format!("the {axis} axis has the numbers {ticks:?}"));
            } else if !(even(&ticks, |v| v) || ticks.iter().all(|t| t.1 > 0.0) && even(&ticks, f64::ln)) {
                out.push(format!("the numbers of the {axis} axis do not stand where they belong: {ticks:?}"));
            }
        }
        let (left, top, right, bottom) = self.frame;
        for curve in &self.curves {
            let inside =
                |p: &(f64, f64)| p.0 > left - 0.1 && p.0 < right + 0.1 && p.1 > top - 0.1 && p.1 < bottom + 0.1;
            if curve.len() < 2 || !curve.iter().all(inside) {
                out.push(format!("a curve leaves the frame: {:?}", curve.iter().find(|p| !inside(p))));
            }
            if curve.iter().all(|p| (p.1 - top).abs() < 1.0) || curve.iter().all(|p| (p.1 - bottom).abs() < 1.0) {
                out.push("a curve lies on the frame".to_owned());
            }
        }
        // Curves that fill less than a tenth of the height could be drawn larger.
        let heights = || self.curves.iter().flatten().map(|p| p.1);
        let span = heights().fold(f64::NEG_INFINITY, f64::max) - heights().fold(f64::INFINITY, f64::min);
        if self.curves.len() > 1 && span < 0.1 * (bottom - top) {
            out.push(format!("the curves fill {span} of {}", bottom - top));
        }
        out
    }
}

/// The number that a label says: `0.5`, `−2`, `10^3`, `2.5·10^−17`.
fn said(label: &str) -> f64 {
    let label = label.replace('−', "-");
    let text = match label.split_once("10^") {
        Some(("", power)) => format!("1e{power}"),
        Some((factor, power)) => format!("{}e{power}", factor.trim_end_matches('·')),
        None => label.clone(),
    };
    text.parse().unwrap_or_else(|_| panic!("{label:?} is no number"))
}

/// Whether the places are even in a function of the values, to a point and a half (labels are centred by their letters).
fn even(ticks: &[(f64, f64)], of: impl Fn(f64) -> f64) -> bool {
    let values: Vec<(f64, f64)> = ticks.iter().map(|(place, value)| (*place, of(*value))).collect();
    let (first, last) = (values[0], values[values.len() - 1]);
    let rate = (last.0 - first.0) / (last.1 - first.1);
    rate.is_finite() && rate != 0.0 && values.iter().all(|(at, v)| (first.0 + (v - first.1) * rate - at).abs() < 3.0)
}

/// Chains for the picture of velocities.
const SCENES: [(&str, &str); 6] = [
    ("car", "first = \"1500\"\nlast = \"1\"\ninserted = 3\nrestitution = \"0.8\""),
    ("large", "first = \"1e9\"\nlast = \"1e-9\"\ninserted = 12\nrestitution = \"1\"\nspeed = \"1e200\""),
    ("small", "first = \"3\"\nlast = \"2\"\ninserted = 1\nrestitution = \"1/2\"\nspeed = \"1e-250\""),
    ("back", "first = \"1\"\nlast = \"1000\"\ninserted = [\"5\", \"200\"]\nrestitution = \"1\""),
    ("long", "first = \"2\"\nlast = \"1\"\ninserted = 400\nrestitution = \"0.99\""),
    (
        "a name that is much longer than any title has room for and goes on in several lines until the page has no more of them 一二三",
        "first = \"2\"\nlast = \"1\"\ninserted = 1\nrestitution = \"0\"",
    ),
];

/// The pictures that are tried: their arguments, and whether there may be none.
fn asked(folder: &Path) -> Vec<Vec<String>> {
    let mut out: Vec<Vec<String>> = Vec::new();
    let ranges = [
        "1/1000,1000",
        "1/100,100",
        "1/2,2",
        "2,3",
        "2,5",
        "9,11",
        "20,80",
        "3,40",
        "1,1.0001",
        "1,1.00001",
        "0.999,1.001",
        "7,7.00001",
        "123456.7,123457.8",
        "1e-9,1",
        "1e-100,1e100",
        "1e-200,1e200",
        "1e-300,1e300",
        "1e250,2e250",
        "1e-300,3e-300",
        "1e299,1e300",
    ];
    let mut add = |words: &[&str]| out.push(words.iter().map(|w| (*w).to_owned()).collect());
    for range in ranges {
        add(&["map", "--ratio", range]);
        for n in ["1", "1,2,3,5,10", "1000000,1000000000000000000"] {
            add(&["threshold", "--ratio", range, "-n", n]);
        }
        for e in ["0.9", "0", "1", "0.123456789123"] {
            add(&["eta-x", "--ratio", range, "-e", e, "-n", "0,1,5"]);
        }
    }
    for ratio in ["1", "2", "100", "229", "1e-200", "1e300", "123456789.123456789", "1/3"] {
        for e in ["0.5,0.8,0.9,0.95,1", "0.7,0.8", "0", "1", "0.999999", "0.123456789123,0.2,1/3", "0.99999999999999"] {
            add(&["eta-n", "--ratio", ratio, "-e", e]);
            for n in ["1", "5", "1000", "1000000", "1000000000000000000"] {
                add(&["eta-n", "--ratio", ratio, "-e", e, "-n", n]);
            }
        }
    }
    for (name, chain) in SCENES {
        let path = folder.join(format!("{name}.toml"));
        std::fs::write(&path, format!("[chain]\n{chain}\n")).unwrap();
        add(&["velocities", path.to_str().unwrap()]);
    }
    out
}

#[test]
fn every_picture_can_be_read_or_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("p.svg");
    let (mut drawn, mut refused, mut report) = (0, BTreeMap::new(), String::new());
    for words in asked(folder.path()) {
        let words: Vec<&str> = words.iter().map(String::as_str).collect();
        let (code, message) = plot(&words, &file);
        if code == Some(0) {
            drawn += 1;
            for fault in Picture::read(&std::fs::read_to_string(&file).unwrap()).faults() {
                let _ = writeln!(report, "{words:?}: {fault}");
            }
        } else {
            // What cannot be told apart or seen says what to do instead.
            let known = ["the curves cannot be told apart", "every value is below 1e-290"];
            match known.iter().find(|k| message.contains(*k) && message.contains("print")) {
                Some(why) if code == Some(2) => *refused.entry(*why).or_insert(0) += 1,
                _ => _ = writeln!(report, "{words:?}: {code:?} {message}"),
            }
        }
    }
    println!("{drawn} pictures drawn, refused: {refused:?}");
    assert!(report.is_empty(), "{report}");
    assert!(drawn > 250 && refused.len() == 2, "{drawn} {refused:?}");
}

#[test]
fn a_legend_is_never_cut_off() {
    let folder = tempfile::tempdir().unwrap();
    let file: PathBuf = folder.path().join("p.svg");
    let (code, message) = plot(&["eta-n", "--ratio", "2", "-e", "0.999999", "-n", "1000000"], &file);
    assert_eq!(code, Some(0), "{message}");
    let picture = Picture::read(&std::fs::read_to_string(&file).unwrap());
    let legend = picture.labels.iter().find(|l| l.text == "e = 0.999999, n* = 346").expect("the whole legend");
    assert!(legend.right < picture.width, "{legend:?}");
    // The peak is drawn, though the dots of even steps lie far beyond it.
    let highest = picture.curves[0].iter().fold(f64::INFINITY, |y, p| y.min(p.1));
    assert!(highest < picture.frame.1 + 30.0, "{highest}");
    assert!(picture.faults().is_empty(), "{:?}", picture.faults());
}

#[test]
fn what_no_picture_can_show_is_refused_with_what_to_write() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("p.svg");
    let long = format!("0.{}", "123456789".repeat(5));
    for (words, sign) in [
        (vec!["threshold", "--ratio", "1,1.00000001"], "write a wider range"),
        (vec!["threshold", "--ratio", "1,1.000001"], "draw one curve or a wider range"),
        (vec!["eta-x", "--ratio", "1e-300,1e-299", "-e", "0", "-n", "0"], "print the values with `carom table`"),
        (vec!["eta-n", "-e", &long], "e takes 92 characters, and a picture has room for 40"),
    ] {
        let (code, message) = plot(&words, &file);
        assert_eq!(code, Some(2), "{words:?}: {message}");
        assert!(message.starts_with("error: ") && message.contains(sign), "{words:?}: {message}");
        assert!(!file.exists(), "{words:?}");
    }
}

#[test]
fn a_picture_of_velocities_has_no_unit() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("p.svg");
    for (scene, axis) in [
        ("car-chain", "<desc>velocity (m/s) from"),
        ("stacked-balls", "<desc>velocity (v) from"),
        ("equal-masses", "<desc>velocity from"),
    ] {
        let (code, message) = plot(&["velocities", &format!("examples/scenes/{scene}.toml")], &file);
        assert_eq!(code, Some(0), "{message}");
        let picture = std::fs::read_to_string(&file).unwrap();
        assert!(picture.contains(axis), "{scene}");
    }
}

#[test]
fn dots_without_colours_match_no_curve() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("p.svg");
    let (code, message) = plot(&["eta-x", "--grey", "--at", "10", "-n", "0,1"], &file);
    assert_eq!((code, message.as_str()), (Some(0), ""));
    let picture = std::fs::read_to_string(&file).unwrap();
    assert!(picture.contains("Legend: n = 0; n = 1; at 10:; n = 0: 0.2"), "{}", &picture[..400]);
    let circles: Vec<&str> = picture.lines().filter(|line| line.contains("<circle")).collect();
    assert!(circles.len() >= 4 && circles.iter().all(|line| line.contains("#000000")), "{circles:?}");
}

#[test]
fn characters_become_boxes_without_a_word() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("p.svg");
    let (code, message) = plot(&["eta-n", "--title", "能量 μ₁ ≤ 能"], &file);
    assert_eq!(code, Some(0));
    assert_eq!(message, "note: the picture shows 能 量 as empty boxes: its font, DejaVu Sans, lacks them\n");
    assert_eq!(plot(&["eta-n", "--title", "Énergie, η₁ ≤ ½"], &file), (Some(0), String::new()));
    let scene = folder.path().join("s.toml");
    let chain = "title = \"小車\"\n[chain]\nfirst = 10\nlast = 1\ninserted = 1\nrestitution = \"1/2\"\n";
    std::fs::write(&scene, chain).unwrap();
    let sheet = folder.path().join("s.pdf");
    let out = carom(&["worksheet", scene.to_str().unwrap(), "-o", sheet.to_str().unwrap()]);
    assert_eq!(out.status.code(), Some(0));
    assert!(text(&out.stderr).starts_with("note: the PDF shows 小 車 as empty boxes"), "{}", text(&out.stderr));
}

#[test]
fn the_readme_shows_what_its_command_draws() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("energy.svg");
    assert_eq!(plot(&["eta-n", "--ratio", "100"], &file).0, Some(0));
    assert_eq!(std::fs::read_to_string(&file).unwrap(), include_str!("../../docs/energy.svg"));
}
