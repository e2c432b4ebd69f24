//! The files of the folder.

use super::Folder;
use crate::export::coq;
use carom_catalogue as embedded;
use std::collections::BTreeMap;

/// The file that `check` reads the order of compiling from: a file on each line, and the files that it needs.
const ORDER: &str = "order.txt";
/// The file that `check` reads the theorems from: file, theorem, what it says.
const THEOREMS: &str = "theorems.txt";
/// The library's own files, in the order of compiling.
const LIBRARY: &str = "library.txt";

/// The Coq files that generated proofs rest on, in the order of compiling: `values`, `points` and what they import.
fn library() -> Vec<embedded::File> {
    let files = embedded::coq_files();
    let mut out: Vec<embedded::File> = Vec::new();
    let mut open = vec![("points".to_string(), false), ("values".to_string(), false)];
    while let Some((name, ready)) = open.pop() {
        let Some(file) = files.iter().find(|f| f.path == name) else { continue };
        if out.iter().any(|f| f.path == name) {
            continue;
        }
        if ready {
            out.push(*file);
            continue;
        }
        open.push((name, true));
        let imports = file.text.lines().filter_map(|line| line.strip_prefix("From Carom Require ")?.strip_suffix('.'));
        let words = imports.flat_map(str::split_whitespace).filter(|w| !["Import", "Export"].contains(w));
        open.extend(words.map(|w| (w.to_string(), false)));
    }
    out
}

/// The names that no claim's file may take.
pub(crate) fn own_modules() -> Vec<String> {
    library()
        .iter()
        .map(|f| f.path.to_string())
        .chain(["statements", "stated", "assumptions"].map(str::to_string))
        .collect()
}

impl Folder {
    /// The files of the folder, with their names.
    pub fn contents(&self) -> Vec<(String, String)> {
        let library = library();
        let mut out: Vec<(String, String)> =
            library.iter().map(|f| (format!("{}.v", f.path), f.text.to_string())).collect();
        out.push(("statements.v".to_string(), coq::definitions(&self.statements)));
        let (mut order, mut theorems) = (String::new(), String::new());
        for file in &self.files {
            let Some(module) = &file.module else { continue };
            out.push((format!("{module}.v"), file.text.clone()));
            if file.theorems.is_empty() {
                continue;
            }
            let needs: Vec<&str> = file.needs.iter().map(String::as_str).collect();
            order += format!("{module} {}", needs.join(" ")).trim_end();
            order.push('\n');
            for theorem in &file.theorems {
                theorems += &format!("{module} {} {}\n", theorem.name, theorem.says);
            }
        }
        let project: String = out.iter().map(|(name, _)| format!("{name}\n")).collect();
        let own: String = library.iter().map(|f| format!("{}\n", f.path)).collect();
        out.extend([
            ("_CoqProject".to_string(), format!("-Q . Carom\n{project}")),
            (LIBRARY.to_string(), format!("{own}statements\n")),
            (ORDER.to_string(), order),
            (THEOREMS.to_string(), theorems),
            ("check".to_string(), include_str!("check.sh").to_string()),
            ("README.md".to_string(), self.readme()),
        ]);
        out
    }

    /// The page of the theorems, each in full with the place of its proof.
    pub fn page(&self) -> String {
        let mut proved = BTreeMap::new();
        for file in &self.files {
            let Some(module) = &file.module else { continue };
            proved.extend(file.theorems.iter().map(|theorem| (theorem.name.clone(), module.clone())));
        }
        coq::theorems(&self.statements, &proved)
    }

    /// How many theorems the files have.
    pub fn theorems(&self) -> usize {
        self.files.iter().map(|f| f.theorems.len()).sum()
    }

    fn readme(&self) -> String {
        let mut out = format!(
            "{}\n| claim | file | theorems | without a proof |\n|---|---|---|---|\n",
            include_str!("README.md")
        );
        for file in &self.files {
            let module = file.module.as_ref().map_or("none".to_string(), |m| format!("`{m}.v`"));
            let theorems: Vec<String> = file.theorems.iter().map(|t| format!("`{}`", t.name)).collect();
            let open: Vec<String> = file.open.iter().map(|(name, why)| format!("`{name}`: {}", cell(why))).collect();
            out += &format!("| {} | {module} | {} | {} |\n", file.claim, theorems.join(", "), open.join("; "));
        }
        out
    }
}

/// A text in a cell of a table.
fn cell(text: &str) -> String {
    text.replace('|', "\\|").replace(['\n', '\r'], " ")
}
