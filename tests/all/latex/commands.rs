//! The commands that take a paper where they take claim files.

use crate::support::{in_folder, said};
use std::path::Path;

const PAPER: &str = r"\newcommand{\half}{\frac{1}{2}}
%carom given m, M > 0 in \mathrm{kg};  v real in m/\mathrm{s};  R > 0 in \Omega;  I, U real
\begin{align}
  \half m v^2 &\ge 0 , \label{eq:energy} \\
  (m + M) v^2 &= m v^2 \\
              &\quad + M v^2 \label{eq:sum}
\end{align}
\begin{equation}\label{eq:bad} m v = m v^2 \end{equation}
\begin{equation}\label{eq:ohm} %carom assume
  U = R I
\end{equation}
\begin{equation}\label{eq:power} U I = R I^2 \end{equation}
\begin{equation}\label{eq:unread} \oint v = 0 \end{equation}
";

fn run(folder: &Path, arguments: &str) -> (i32, String) {
    let out = in_folder(folder, &arguments.split(' ').collect::<Vec<_>>(), "");
    (out.status.code().expect("an exit code"), said(&out))
}

#[test]
fn a_command_fails_on_a_paper() {
    let folder = tempfile::tempdir().expect("a folder");
    let here = folder.path();
    std::fs::write(here.join("p.tex"), PAPER).expect("it is written");
    for (arguments, code, wanted) in [
        (
            "audit p.tex --certificates c",
            2,
            &["3 proved, 1 refuted", "is in kg·m/s, and", "p.tex:8:", "\\oint is not read"][..],
        ),
        ("explain power p.tex", 0, &["proved (identity)", "U real", "in ohm"]),
        ("explain bad p.tex", 1, &["Why it is refuted", "dimensions differ"]),
        ("explain unread p.tex", 2, &["\\oint is not read"]),
        ("repair bad p.tex", 1, &["No hypothesis changes that"]),
        ("check p.tex", 2, &["holds claims, not certificates", "carom audit p.tex --certificates DIR"]),
        ("export smt2 p.tex", 2, &["--from p.tex"]),
        ("read p.tex", 2, &["given m > 0 in kg; v real in m/s", "6"]),
        ("report p.tex -o r", 2, &["\\oint is not read", "1 claim is refuted by its dimensions."]),
    ] {
        let (found, text) = run(here, arguments);
        assert_eq!(found, code, "{arguments}: {text}");
        for part in wanted {
            assert!(text.contains(part), "{arguments}: {part}: {text}");
        }
    }
    std::fs::write(here.join("q.tex"), PAPER.replace("\\oint v = 0", "v^2 \\ge 0")).expect("it is written");
    let (code, text) = run(here, "check c --claims q.tex");
    assert_eq!((code, text.contains("3 of 3 certificates accepted")), (0, true), "{text}");
}

#[test]
fn a_report_does_not_show_the_papers_own_formula() {
    let folder = tempfile::tempdir().expect("a folder");
    let here = folder.path();
    std::fs::write(here.join("p.tex"), PAPER).expect("it is written");
    run(here, "report p.tex -o r");
    let page = std::fs::read_to_string(here.join("r/index.html")).expect("a page");
    assert_eq!(page.matches("In the paper").count(), 4, "one for each claim");
    assert!(page.contains("aria-label=\"\\frac {1}{2} m v^2 \\ge 0 ,\""), "macros are written out");
    assert!(page.contains("<mtext>kg</mtext>") && page.contains("\\oint is not read"));
    let document = std::fs::read_to_string(here.join("r/report.tex")).expect("a document");
    assert!(document.contains("\\begin{aligned} (m + M) v^2 & = m v^2 \\\\  & \\quad + M v^2"), "{document}");
    assert!(document.contains("\\[ \\frac {1}{2} m v^2 \\ge 0 , \\]"), "{document}");
}

#[test]
fn a_formula_brings_commands_into_the_report() {
    let folder = tempfile::tempdir().expect("a folder");
    let here = folder.path();
    let paper = "%carom given x real\n\\[ \\input{/etc/passwd} x = x \\] %carom prove x = x\n";
    std::fs::write(here.join("p.tex"), paper).expect("it is written");
    let (code, text) = run(here, "report p.tex -o r");
    assert_eq!(code, 0, "{text}");
    let document = std::fs::read_to_string(here.join("r/report.tex")).expect("a document");
    assert!(!document.contains("input{/etc"), "{document}");
}
