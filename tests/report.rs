//! The page to hand in: complete, well formed, and closed to markup from claim files.

use std::process::Command;

const SOURCE: &str = "claim strange \"A <script>alert(1)</script> & 'title'\"
source \"<img src=x onerror=alert(1)>\"
section \"</section><h1>\"
note \"</p><b>\"
given x > 0
prove x^2/(x + 1) < x

claim wrong \"Plainly wrong\"
using strange
given x > 0
prove x > 1
";

fn carom() -> Command {
    Command::new(env!("CARGO_BIN_EXE_carom"))
}

/// Elements opened and not closed, or closed and not opened.
fn unbalanced(page: &str) -> Vec<String> {
    let mut open: Vec<String> = Vec::new();
    let mut faults = Vec::new();
    for part in page.split('<').skip(1) {
        let tag = part.split('>').next().unwrap_or_default();
        let name = tag.trim_start_matches('/').split([' ', '/']).next().unwrap_or_default().to_string();
        if tag.starts_with('!') || tag.ends_with('/') || name == "meta" {
            continue;
        }
        if !tag.starts_with('/') {
            open.push(name);
        } else if open.pop().as_ref() != Some(&name) {
            faults.push(name);
        }
    }
    faults.extend(open);
    faults
}

#[test]
fn the_report_of_a_hostile_file_holds_no_markup_of_its() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("strange.claim");
    std::fs::write(&file, SOURCE).expect("written");
    let out = folder.path().join("out");
    let run = carom().arg("report").arg(&file).arg("--out").arg(&out).args(["--title", "<i>"]).output().expect("runs");
    // The second claim is refuted where the file expects it proved.
    assert_eq!(run.status.code(), Some(1), "{}", String::from_utf8_lossy(&run.stderr));
    let page = std::fs::read_to_string(out.join("index.html")).expect("the page");
    for markup in ["<script", "<img", "<h1></", "</p><b>", "<i>"] {
        assert!(!page.contains(markup), "{markup}");
    }
    assert!(page.contains("&lt;script&gt;") && page.contains("not as expected"));
    assert!(page.contains("It fails at <code>x = 1</code>"));
    assert_eq!(unbalanced(&page), Vec::<String>::new());
    assert!(std::fs::read_to_string(out.join("report.md")).expect("Markdown").contains("| strange"));
    let document = std::fs::read_to_string(out.join("report.tex")).expect("LaTeX");
    assert!(document.contains("\\end{document}") && document.contains("\\textless{}script\\textgreater{}"));
}

#[test]
fn nothing_is_written_where_a_file_is_broken() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("broken.claim");
    std::fs::write(&file, "claim broken \"t\"\nprove (\n").expect("written");
    let out = folder.path().join("out");
    let run = carom().arg("report").arg(&file).arg("--out").arg(&out).output().expect("runs");
    assert_eq!(run.status.code(), Some(2));
    assert!(!out.exists());
}

#[test]
fn the_catalogue_has_a_section_for_each_claim() {
    let folder = tempfile::tempdir().expect("a folder");
    let run = carom().arg("report").arg("--out").arg(folder.path()).output().expect("runs");
    assert_eq!(run.status.code(), Some(0));
    let page = std::fs::read_to_string(folder.path().join("index.html")).expect("the page");
    assert_eq!(unbalanced(&page), Vec::<String>::new());
    assert!(page.matches("<section class=\"claim\"").count() >= 84);
    assert!(page.contains("<svg") && page.contains("id=\"eq13\"") && page.contains("id=\"findings\""));
    assert!(!page.contains("http-equiv=\"refresh\"") && !page.contains("<link"));
}
