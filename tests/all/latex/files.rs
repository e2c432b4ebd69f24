//! Papers in several files: `\input` and `\include`.

use crate::support::{in_folder, said};
use std::path::Path;

fn written(folder: &Path, files: &[(&str, &str)]) {
    for (name, text) in files {
        let path = folder.join(name);
        std::fs::create_dir_all(path.parent().expect("a folder")).expect("it is made");
        std::fs::write(path, text).expect("it is written");
    }
}

fn run(folder: &Path, arguments: &str) -> (i32, String) {
    let out = in_folder(folder, &arguments.split(' ').collect::<Vec<_>>(), "");
    (out.status.code().expect("an exit code"), said(&out))
}

#[test]
fn a_file_that_a_paper_calls_for_is_not_read_or_its_places_are_wrong() {
    let folder = tempfile::tempdir().expect("a folder");
    let here = folder.path();
    written(
        here,
        &[
            (
                "p/main.tex",
                "\\input{macros}\n\\input parts/one\n\\include{parts/two}\n% \\input{nothing}\n\\[ x = x \\]\n",
            ),
            ("p/macros.tex", "\\newcommand{\\half}{\\frac{1}{2}}\n%carom given x, y > 0"),
            ("p/parts/one.tex", "\n\\begin{equation} \\half x > 0 \\end{equation}\n\\[ x > 1 \\]"),
            (
                "p/parts/two.tex",
                "\n\n\\begin{equation} x = \\foo \\end{equation}\n\\begin{equation}\\label{eq:both} x + y > y \\end{equation}\n",
            ),
        ],
    );
    let (code, text) = run(here, "read p/main.tex");
    assert_eq!(code, 2, "{text}");
    for wanted in [
        "# p/main.tex: 4 claims read, 1 not read",
        "# p/parts/one.tex line 2 (1): read as claim eq-1",
        "# p/parts/one.tex line 3: read as claim one-line-3",
        "# p/parts/two.tex line 4 (3): read as claim both",
        "# line 5: read as claim line-5",
        "--> p/parts/two.tex:3:",
    ] {
        assert!(text.contains(wanted), "{wanted}: {text}");
    }
    let (_, junit) = run(here, "audit p/main.tex --format junit");
    assert!(junit.contains("Line 3 of one") && junit.contains("p/parts/one.tex"), "{junit}");
}

#[test]
fn a_file_that_cannot_be_read_ends_the_paper_or_is_passed_over_in_silence() {
    let folder = tempfile::tempdir().expect("a folder");
    let here = folder.path();
    let deep: Vec<(String, String)> =
        (0..30).map(|k| (format!("p/deep{k}.tex"), format!("\\input{{deep{}}}\n", k + 1))).collect();
    written(here, &deep.iter().map(|file| (file.0.as_str(), file.1.as_str())).collect::<Vec<_>>());
    let long = "% a line\n".repeat(100_000);
    written(here, &[("secret.tex", "\\[ 1 = 1 \\]"), ("p/long.tex", &long), ("p/folder.tex/x", "")]);
    std::fs::write(here.join("p/latin.tex"), b"\xe9").expect("it is written");
    for (called, why, limit) in [
        ("missing", "there is no file missing.tex or missing", false),
        ("paper", "it would stand in itself", false),
        ("../secret", "outside of the paper's folder", false),
        ("latin", "it is not UTF-8 text", false),
        ("folder", "it is no file of text", false),
        ("deep0", "at most 16 files that stand in one another", true),
        ("long}\\input{long", "at most 1048576 bytes in a paper", true),
    ] {
        written(here, &[("p/paper.tex", &format!("\\input{{{called}}}\n\\[ 2 = 2 \\]\n"))]);
        let (code, text) = run(here, "read p/paper.tex");
        assert_eq!(code, if limit { 3 } else { 2 }, "{called}: {text}");
        // What the file holds may be a hypothesis.
        assert!(text.contains(why) && text.contains("line 2: not read: waits for "), "{called}: {text}");
    }
    // A file that calls twice for one that does so again would be read without end.
    let twice: Vec<(String, String)> =
        (0..15).map(|k| (format!("p/t{k}.tex"), format!("\\input{{t{0}}}\\input{{t{0}}}\n", k + 1))).collect();
    written(here, &twice.iter().map(|file| (file.0.as_str(), file.1.as_str())).collect::<Vec<_>>());
    written(here, &[("p/t15.tex", "%\n")]);
    let (code, text) = run(here, "read p/t0.tex");
    assert_eq!((code, text.contains("at most 1000 commands that call for a file")), (3, true), "{text}");
}
