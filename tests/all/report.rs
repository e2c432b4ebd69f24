//! The folder to hand in: complete, well formed, the same everywhere, and closed to markup from claim files.

use crate::support::said;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::process::Command;
use std::sync::OnceLock;

const SOURCE: &str =
    "claim strange \"A <script>alert(1)</script> & 'title' `code` [x](javascript:alert) \\input{y} мир\"
source \"<img src=x onerror=alert(1)>\"
section \"</section><h1> # `s` | ![x](http://x.example/y)\"
note \"</p><b> <https://x.example> ${\\end{document}}\"
given x > 0
prove x^2/(x + 1) < x

claim findings \"Plainly wrong\"
using strange
given x > 0
prove x > 1

claim f' \"A name with a mark\"
given x > 0
prove x^2 > 0
";

fn carom() -> Command {
    Command::new(env!("CARGO_BIN_EXE_carom"))
}

/// All files of a folder, by their paths in it.
fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut out = BTreeMap::new();
    for entry in std::fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        let name = path.file_name().expect("a name").to_str().expect("UTF-8").to_string();
        if path.is_dir() {
            out.extend(files(&path).into_iter().map(|(inner, bytes)| (format!("{name}/{inner}"), bytes)));
        } else {
            out.insert(name, std::fs::read(&path).expect("read"));
        }
    }
    out
}

fn text(files: &BTreeMap<String, Vec<u8>>, name: &str) -> String {
    String::from_utf8(files.get(name).unwrap_or_else(|| panic!("{name} is missing")).clone()).expect("UTF-8")
}

/// The report of the built-in catalogue, made once.
fn catalogue() -> &'static (tempfile::TempDir, BTreeMap<String, Vec<u8>>) {
    static MADE: OnceLock<(tempfile::TempDir, BTreeMap<String, Vec<u8>>)> = OnceLock::new();
    MADE.get_or_init(|| {
        let folder = tempfile::tempdir().expect("a folder");
        let run = carom().arg("report").arg("--out").arg(folder.path()).output().expect("runs");
        assert_eq!(run.status.code(), Some(0), "{}", said(&run));
        let files = files(folder.path());
        (folder, files)
    })
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

/// The values of an attribute.
fn values(page: &str, attribute: &str) -> Vec<String> {
    let opening = format!(" {attribute}=\"");
    page.split(&opening).skip(1).map(|rest| rest.split('"').next().unwrap_or_default().replace("&#39;", "'")).collect()
}

/// An address with its `%XX` as bytes.
fn decoded(address: &str) -> String {
    let mut parts = address.split('%');
    let mut out = parts.next().unwrap_or_default().as_bytes().to_vec();
    for part in parts {
        out.push(u8::from_str_radix(&part[..2], 16).expect("two hexadecimal digits"));
        out.extend(&part.as_bytes()[2..]);
    }
    String::from_utf8(out).expect("UTF-8")
}

/// Checks what the page and the Markdown refer to, that the page asks for nothing from elsewhere, and that all is closed.
fn sound(files: &BTreeMap<String, Vec<u8>>) {
    let page = text(files, "index.html");
    assert_eq!(unbalanced(&page), Vec::<String>::new());
    let ids = values(&page, "id");
    let distinct: BTreeSet<&String> = ids.iter().collect();
    assert_eq!(distinct.len(), ids.len(), "two places have one name");
    let (mut inside, mut outside) = (0, BTreeSet::new());
    for reference in values(&page, "href").iter().chain(&values(&page, "src")) {
        match reference.strip_prefix('#') {
            Some(place) => {
                assert!(distinct.contains(&place.to_string()), "#{place} is nowhere");
                inside += 1;
            }
            None => {
                assert!(files.contains_key(&decoded(reference)), "{reference} is not in the folder");
                outside.insert(decoded(reference));
            }
        }
    }
    for reference in values(&page, "aria-labelledby") {
        assert!(distinct.contains(&reference), "{reference} labels nothing");
    }
    assert!(inside > 0 && !outside.is_empty());
    // The names of SVG and MathML look like addresses and are none.
    let bare = page.replace("http://www.w3.org/2000/svg", "").replace("http://www.w3.org/1998/Math/MathML", "");
    let tags: String = bare.split('<').skip(1).filter_map(|part| part.split('>').next()).collect();
    for network in ["http:", "https:", "src=", "@import", "url(", "<script", "<link", "<iframe", "<object", "srcset"] {
        let place = if network.starts_with('<') { &bare } else { &tags };
        assert!(!place.contains(network), "{network}");
    }
    assert!(!page.contains("http-equiv=\"refresh\"") && page.contains("default-src 'none'"));
    let markdown = text(files, "report.md");
    let mut links = 0;
    for (before, after) in markdown.match_indices("](").map(|(at, _)| (&markdown[..at], &markdown[at + 2..])) {
        // Within code, and where the first bracket is escaped, it is no link.
        if before.ends_with('\\') {
            continue;
        }
        let target = after.split(')').next().unwrap_or_default();
        assert!(files.contains_key(&decoded(target)), "{target} is not in the folder");
        links += 1;
    }
    assert!(links > 0);
}

#[test]
fn the_report_of_a_hostile_file_holds_no_markup_of_its() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("<b>&'strange.claim");
    std::fs::write(&file, SOURCE).expect("written");
    let scene = folder.path().join("a <b>&\u{201d} scene.toml");
    std::fs::copy("examples/scenes/stacked-balls.toml", &scene).expect("copied");
    let out = folder.path().join("out");
    let run = carom()
        .arg("report")
        .arg(&file)
        .args(["--out", out.to_str().expect("UTF-8"), "--title", "<i> \\input{z} `x`"])
        .args(["--plot", &format!("velocities \"{}\"", scene.display()), "--table", "--ratio 2 -e 1 -n 1"])
        .output()
        .expect("runs");
    // The second claim is refuted where the file expects it proved.
    assert_eq!(run.status.code(), Some(1), "{}", said(&run));
    let files = files(&out);
    sound(&files);
    let page = text(&files, "index.html");
    for markup in ["<script", "<img", "<h1></", "</p><b>", "<i>", "<b>", "<h1> #"] {
        assert!(!page.contains(markup), "{markup}");
    }
    assert!(page.contains("&lt;script&gt;") && page.contains("not as expected"));
    assert!(page.contains("It fails at <code>x = 1</code>"));
    assert!(page.contains("plot velocities a &lt;b&gt;&amp;\u{201d} scene.toml"));
    let markdown = text(&files, "report.md");
    assert!(markdown.contains("| strange") && !markdown.contains("\n# `"));
    for markup in ["<img", "<script", "<i>", "<b>", "</p>", "![x]", "[x]", "`code`"] {
        for (at, _) in markdown.match_indices(markup) {
            let in_code = markdown[..at].rsplit('\n').next().is_some_and(|line| line.starts_with("`carom"));
            assert!(markdown[..at].ends_with('\\') || in_code, "{markup} in {}", &markdown[at..]);
        }
    }
    let document = text(&files, "report.tex");
    assert!(document.contains("\\textless{}script\\textgreater{}") && document.contains("[U+043C]"));
    assert_eq!(document.matches("\\end{document}").count(), 1);
    assert!(!document.contains("\\input{") && !document.contains("\\begin{document}\\input"));
    // What was shown by whom, in each form, and counted.
    for form in [&page, &markdown, &document] {
        assert!(form.contains("checked by the kernel") && form.contains("not in Coq"));
        assert!(form.contains("refutation checked by the kernel"));
    }
    assert!(
        page.contains("The kernel accepted 2 of the 2 proofs, and 1 of the 1 refutation in this run.")
            && page.contains("Coq checked none of the verdicts.")
    );
    assert!(page.contains("0 verdicts rest only on the evaluation of a witness."));
    assert!(page.contains("certificates/f%27.cert") && !page.contains("href=\"coq/"));
    let check = carom().arg("check").arg(out.join("certificates")).arg("--claims").arg(&file).output().expect("runs");
    assert_eq!(check.status.code(), Some(0), "{}", said(&check));
}

#[test]
fn nothing_is_written_where_something_is_broken() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("broken.claim");
    std::fs::write(&file, "claim broken \"t\"\nprove (\n").expect("written");
    let out = folder.path().join("out");
    let broken = file.to_str().expect("UTF-8");
    for (arguments, code, message) in [
        (vec![broken], 2, "broken.claim"),
        (vec!["--table", "--ratio 2 -e 1"], 2, "eta depends on n"),
        (vec!["--table", "--ratio 2 -e 1 -n 1 --output x.csv"], 2, "--output"),
        (vec!["--table", "--ratio '2 -e 1 -n 1"], 2, "quotation mark"),
        (vec!["--table", "--ratio 1:2000:1 -e 1 -n 1"], 3, "rows of a table in a report: 1000 allowed"),
        (vec!["--plot", "map -n 2"], 2, "`plot map` does not take -n"),
        (vec!["--plot", "velocities /nowhere.toml"], 2, "nowhere.toml"),
    ] {
        let run = carom().arg("report").args(&arguments).arg("--out").arg(&out).output().expect("runs");
        assert_eq!(run.status.code(), Some(code), "{arguments:?}: {}", said(&run));
        assert!(said(&run).contains(message), "{arguments:?}: {}", said(&run));
        assert!(!out.exists(), "{arguments:?}");
    }
}

#[test]
fn the_catalogue_has_a_section_for_each_claim_and_every_reference_is_there() {
    let (_, files) = catalogue();
    sound(files);
    let page = text(files, "index.html");
    assert!(page.matches("<section class=\"claim\"").count() >= 84);
    assert!(
        page.contains("id=\"eq13\"") && page.contains("id=\"page.findings\"") && page.contains("id=\"page.graph\"")
    );
    for entry in ["page.table.3", "page.plot.4"] {
        assert!(page.contains(&format!("id=\"{entry}\"")), "{entry}");
    }
    assert_eq!(page.matches("Every cell accepted by the checker of tables").count(), 3);
    assert!(page.contains("<td class=\"number\">0.267769</td><td>162/605</td>"));
    // The theorem in full, and its proof.
    assert!(page.contains("Theorem eq13 :\n  forall (m1 m2 mu : R)") && page.contains("href=\"coq/eq13.v\""));
    assert!(text(files, "coq/eq13.v").contains("Theorem eq13 :\n  forall (m1 m2 mu : R)"));
    // Every refutation is checked by the kernel, also of the one claim that Coq cannot say.
    assert_eq!(page.matches("refutation checked by the kernel</span>").count(), 9);
    assert_eq!(page.matches("evaluated, not certified</span>").count(), 0);
    assert!(page.contains("0 verdicts rest only on the evaluation of a witness."));
}

#[test]
fn certificates_and_tables_of_the_folder_are_accepted() {
    let (folder, files) = catalogue();
    let page = text(files, "index.html");
    let certificates: Vec<&String> = files.keys().filter(|name| name.starts_with("certificates/")).collect();
    assert_eq!(page.matches("checked by the kernel</span>").count(), certificates.len());
    let check = carom().arg("check").arg("--quiet").arg(folder.path().join("certificates")).output().expect("runs");
    assert_eq!(check.status.code(), Some(0), "{}", said(&check));
    assert!(said(&check).contains(&format!("{0} of {0} certificates accepted", certificates.len())));
    for place in 1..=3 {
        let table = folder.path().join(format!("tables/table-{place}.jsonl"));
        let check = carom().arg("check").arg(&table).output().expect("runs");
        assert_eq!(check.status.code(), Some(0), "{}", said(&check));
    }
    // What lies in the folder is what the project committed, and its digests are those that the page shows.
    for name in certificates {
        let here = text(files, name);
        assert_eq!(here, std::fs::read_to_string(Path::new("proofs").join(name)).expect("committed"), "{name}");
        let digest = here.lines().find_map(|l| l.strip_prefix("statement sha256 ")).expect("a digest");
        assert!(page.contains(digest), "{name}");
    }
    for name in ["vocabulary", "rules", "bounds", "points", "values"].map(|name| format!("coq/{name}.v")) {
        assert!(files[&name] == std::fs::read(Path::new("proofs").join(&name)).expect("committed"), "{name} differs");
    }
}

#[test]
fn the_folder_is_the_same_at_every_time_and_place() {
    let (folder, files_before) = catalogue();
    let other = tempfile::tempdir().expect("a folder");
    let run = carom().current_dir(other.path()).args(["report", "--out", "deeper/out"]).output().expect("runs");
    assert_eq!(run.status.code(), Some(0), "{}", said(&run));
    let again = files(&other.path().join("deeper/out"));
    assert_eq!(files_before.keys().collect::<Vec<_>>(), again.keys().collect::<Vec<_>>());
    for (name, bytes) in &again {
        assert!(files_before.get(name) == Some(bytes), "{name} differs");
        let text = String::from_utf8_lossy(bytes);
        for place in [folder.path(), other.path(), Path::new(env!("CARGO_MANIFEST_DIR"))] {
            assert!(!text.contains(&place.display().to_string()), "{name} holds {}", place.display());
        }
    }
}

/// A folder with a program `pdflatex` that is a script.
#[cfg(unix)]
fn pretended(script: &str) -> tempfile::TempDir {
    use std::os::unix::fs::PermissionsExt;
    let folder = tempfile::tempdir().expect("a folder");
    let program = folder.path().join("pdflatex");
    std::fs::write(&program, format!("#!/bin/sh\n[ \"$1\" = --version ] && exit 0\n{script}\n")).expect("written");
    std::fs::set_permissions(&program, std::fs::Permissions::from_mode(0o755)).expect("permissions");
    folder
}

#[cfg(unix)]
#[test]
fn a_pdf_is_made_by_latex_without_shell_escape_and_its_lack_loses_nothing() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("a.claim");
    std::fs::write(&file, "claim a \"t\"\ngiven x > 0\nprove x^2 > 0\n").expect("written");
    let out = folder.path().join("out");
    let report = |path: &Path| {
        let mut run = carom();
        run.arg("report").arg(&file).arg("--pdf").arg("--out").arg(&out).env("PATH", path);
        run.output().expect("runs")
    };
    // None is there: the rest is written, and an older PDF is not touched.
    let none = tempfile::tempdir().expect("a folder");
    let run = report(none.path());
    assert_eq!(run.status.code(), Some(2), "{}", said(&run));
    assert!(said(&run).contains("needs pdflatex or lualatex") && said(&run).contains("texlive-latex-recommended"));
    assert!(["index.html", "report.md", "report.tex"].iter().all(|name| out.join(name).is_file()));
    assert!(!out.join("report.pdf").exists());
    // One that writes what it was asked.
    let good = pretended("[ -f report.tex ] || exit 1\necho \"$@ $openin_any $openout_any\" > report.pdf");
    let run = report(good.path());
    assert_eq!(run.status.code(), Some(0), "{}", said(&run));
    let asked = std::fs::read_to_string(out.join("report.pdf")).expect("the PDF");
    assert!(asked.contains("-no-shell-escape") && asked.trim_end().ends_with("p p"), "{asked}");
    // One that fails: its words are shown, and the PDF from before is there still.
    let bad = pretended("echo '! LaTeX Error: File `booktabs.sty missing' > report.log\nexit 1");
    let run = report(bad.path());
    assert_eq!(run.status.code(), Some(2));
    assert!(said(&run).contains("booktabs.sty missing"), "{}", said(&run));
    assert_eq!(std::fs::read_to_string(out.join("report.pdf")).expect("the PDF"), asked);
}

#[test]
fn a_claim_of_ones_own_is_told_from_its_hypotheses_and_restored_by_nobody() {
    let folder = tempfile::tempdir().expect("a folder");
    let (file, out) = (folder.path().join("a.claim"), folder.path().join("out"));
    std::fs::write(&file, "claim a \"t\"\ngiven x > 0\nassume x > 1\nprove x^2 > 1\n").expect("written");
    let picture = ["--plot", "map --ratio 1/2,2"];
    let run = carom().arg("report").arg(&file).arg("--out").arg(&out).args(picture).output().expect("runs");
    assert_eq!(run.status.code(), Some(0), "{}", said(&run));
    let written = files(&out);
    for name in ["index.html", "report.md", "report.tex"] {
        assert!(!text(&written, name).contains("restored"), "{name}");
    }
    let tex = text(&written, "report.tex");
    let place = |what: &str| tex.find(what).unwrap_or_else(|| panic!("{what} in {tex}"));
    let (given, assumed, claim) = (place("\\textit{Given}"), place("\\textit{Assume}"), place("\\textit{Prove}"));
    assert!(given < assumed && assumed < place("x > 1}") && place("x > 1}") < claim, "{tex}");
    assert!(claim < place("x^{2} > 1}") && place("x^{2} > 1}") < place("\\textit{Proof}"), "{tex}");
    // Without the picture, what is left of it is named.
    let run = carom().arg("report").arg(&file).arg("--out").arg(&out).output().expect("runs");
    assert!(said(&run).contains("do not belong to this report: plots/plot-1.png, plots/plot-1.svg"), "{}", said(&run));
}

#[cfg(unix)]
#[test]
fn latex_that_was_stopped_is_not_blamed_on_packages() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("a.claim");
    std::fs::write(&file, "claim a \"t\"\ngiven x > 0\nprove x^2 > 0\n").expect("written");
    let stopped = pretended("kill -9 $$");
    let mut run = carom();
    run.arg("report").arg(&file).arg("--pdf").arg("--out").arg(folder.path().join("out")).env("PATH", stopped.path());
    let run = run.output().expect("runs");
    assert_eq!(run.status.code(), Some(2), "{}", said(&run));
    assert!(said(&run).contains("was stopped from outside (signal: 9"), "{}", said(&run));
    assert!(!said(&run).contains("packages"), "{}", said(&run));
}

/// Ctrl-C, sent to the program alone.
#[cfg(unix)]
fn interrupted(mut command: std::process::Command, ready: impl Fn() -> bool) -> std::process::Output {
    use std::process::Stdio;
    let child = command.stdout(Stdio::null()).stderr(Stdio::piped()).spawn().expect("it starts");
    let begun = std::time::Instant::now();
    while !ready() && begun.elapsed().as_secs() < 120 {
        std::thread::sleep(std::time::Duration::from_millis(20));
    }
    let kill = std::process::Command::new("kill").args(["-INT", &child.id().to_string()]).status();
    assert!(kill.expect("kill is there").success());
    child.wait_with_output().expect("it ends")
}

#[cfg(unix)]
#[test]
fn one_ctrl_c_ends_a_report() {
    let folder = tempfile::tempdir().expect("a folder");
    // During the tables, during the audit of the catalogue: nothing is written.
    for wait in [50u64, 400, 1000] {
        let out = folder.path().join(format!("out-{wait}"));
        let mut command = carom();
        command.arg("report").arg("--out").arg(&out);
        let begun = std::time::Instant::now();
        let run = interrupted(command, || begun.elapsed().as_millis() as u64 >= wait);
        // Before the program listens, the signal ends it by itself.
        assert!(matches!(run.status.code(), Some(130) | None), "{wait}: {} {}", run.status, said(&run));
        assert!(!out.exists(), "{wait}: nothing is written");
    }
    // During LaTeX: it is stopped as well, and the rest is there.
    let slow = pretended("echo $$ > \"$STARTED\"\nexec sleep 100");
    let (out, started) = (folder.path().join("out"), folder.path().join("started"));
    let file = folder.path().join("a.claim");
    std::fs::write(&file, "claim a \"t\"\ngiven x > 0\nprove x^2 > 0\n").expect("written");
    let mut command = carom();
    let path = format!("{}:/bin:/usr/bin", slow.path().display());
    command.arg("report").arg(&file).arg("--pdf").arg("--out").arg(&out).env("PATH", path).env("STARTED", &started);
    let begun = std::time::Instant::now();
    let run = interrupted(command, || std::fs::read_to_string(&started).is_ok_and(|t| t.ends_with('\n')));
    assert_eq!(run.status.code(), Some(130), "{}", said(&run));
    assert!(said(&run).contains("interrupted: everything but report.pdf is written"), "{}", said(&run));
    assert!(out.join("index.html").is_file() && !out.join("report.pdf").exists());
    assert!(begun.elapsed().as_secs() < 90, "it did not wait for LaTeX");
    let latex = std::fs::read_to_string(&started).expect("its number");
    let alive = std::process::Command::new("kill").args(["-0", latex.trim()]).status().expect("kill is there");
    assert!(!alive.success(), "LaTeX goes on");
}

#[test]
fn a_claim_of_the_catalogue_in_a_users_file_has_its_theorem_and_a_changed_one_has_none() {
    let folder = tempfile::tempdir().expect("a folder");
    let source = std::fs::read_to_string("proofs/ricardo-lee-2015/eq01.claim").expect("the claim");
    for (name, statement, theorem) in
        [("same", source.clone(), true), ("other", source.replace("claim eq01", "claim eq02"), false)]
    {
        let file = folder.path().join(format!("{name}.claim"));
        std::fs::write(&file, statement).expect("written");
        let out = folder.path().join(name);
        let run = carom().arg("report").arg(&file).arg("--out").arg(&out).output().expect("runs");
        assert_eq!(run.status.code(), Some(0), "{}", said(&run));
        let files = files(&out);
        let page = text(&files, "index.html");
        assert_eq!(page.contains("proved in Coq</span>"), theorem, "{name}");
        // A proof is made of both; only the catalogue's theorem is known to be accepted without running Coq.
        assert!(files.contains_key(if theorem { "coq/eq01.v" } else { "coq/eq02.v" }), "{name}");
        assert_eq!(page.contains("holds a proof that Coq was not run on"), !theorem, "{name}");
        assert!(page.contains("checked by the kernel</span>"), "{name}");
        // The certificate is that of the statement in the file, whatever its name promises.
        let claims =
            carom().arg("check").arg(out.join("certificates")).arg("--claims").arg(&file).output().expect("runs");
        assert_eq!(claims.status.code(), Some(0), "{}", said(&claims));
    }
}
