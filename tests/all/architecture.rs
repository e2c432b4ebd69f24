//! The table of crates and rooms in `docs/architecture.md`, compared with the manifests and with what the sources import.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::Command;

const ROOT: &str = env!("CARGO_MANIFEST_DIR");
/// What stands where a room may import every other.
const ALL: &str = "all above";

/// A line of the table.
struct Room {
    package: String,
    paths: Vec<String>,
    imports: Vec<String>,
}

impl Room {
    /// The name that other rooms import it by.
    fn name(&self) -> &str {
        let path = self.paths.first().expect("a path");
        path.rsplit('/').next().unwrap_or(path)
    }
}

/// The texts in backquotes.
fn quoted(cell: &str) -> Vec<String> {
    cell.split('`').skip(1).step_by(2).map(str::to_string).collect()
}

fn rooms() -> Vec<Room> {
    let page = include_str!("../../docs/architecture.md");
    let room = |line: &str| -> Option<Room> {
        let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
        let [package, paths, _, imports] = cells.as_slice() else { return None };
        let imports = imports.split(", ").filter(|import| *import != "–").map(str::to_string).collect();
        Some(Room { package: quoted(package).pop()?, paths: quoted(paths), imports })
    };
    let found: Vec<Room> = page.lines().filter(|line| line.starts_with("| `carom")).filter_map(room).collect();
    assert!(found.len() > 20, "the table is read");
    found
}

struct Manifest {
    folder: PathBuf,
    /// The crates of this workspace that it depends on, outside of tests.
    needs: BTreeSet<String>,
    /// Whether `cargo test` runs its tests.
    is_default: bool,
}

fn manifests() -> BTreeMap<String, Manifest> {
    let out = Command::new(env!("CARGO"))
        .args(["metadata", "--no-deps", "--locked", "--offline", "--format-version", "1"])
        .current_dir(ROOT)
        .output()
        .expect("cargo is there");
    assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stderr));
    let value: serde_json::Value = serde_json::from_slice(&out.stdout).expect("JSON");
    let text = |value: &serde_json::Value| value.as_str().unwrap_or_default().to_string();
    let default: BTreeSet<String> = value["workspace_default_members"].as_array().unwrap().iter().map(text).collect();
    let packages = value["packages"].as_array().unwrap().iter().map(|package| {
        let needs = package["dependencies"].as_array().unwrap().iter().filter(|need| need["kind"].is_null());
        let folder = PathBuf::from(text(&package["manifest_path"])).parent().unwrap().to_path_buf();
        let needs = needs.map(|need| text(&need["name"])).filter(|name| name.starts_with("carom")).collect();
        let is_default = default.contains(&text(&package["id"]));
        (text(&package["name"]), Manifest { folder, needs, is_default })
    });
    packages.collect()
}

/// The lines of code in a file or a folder, without comments and without the unit tests at the end of a file.
fn code(path: &Path) -> Vec<String> {
    if path.is_dir() {
        return std::fs::read_dir(path).unwrap().flat_map(|entry| code(&entry.unwrap().path())).collect();
    }
    if path.extension().is_none_or(|end| end != "rs") {
        return Vec::new();
    }
    let text = std::fs::read_to_string(path).unwrap();
    let shipped = text.split("\n#[cfg(test)]\n#[allow(clippy::unwrap_used)]").next().unwrap_or_default();
    shipped.lines().filter(|line| !line.trim_start().starts_with("//")).map(str::to_string).collect()
}

/// The names that follow `crate::` or the name of a crate of ours; a crate that is one room stands for itself.
fn imported(line: &str) -> Vec<String> {
    let words: Vec<&str> = line.split(|c: char| !c.is_alphanumeric() && c != '_' && c != ':').collect();
    let of = |word: &&str| -> Option<String> {
        let (first, rest) = word.split_once("::").unwrap_or((word, ""));
        match first {
            "carom_diagnostic" => Some("diagnostic".to_string()),
            "carom_catalogue" => Some("proofs".to_string()),
            "carom_unit" => Some("unit".to_string()),
            _ if first == "crate" || first.starts_with("carom_") => rest.split("::").next().map(str::to_string),
            _ => None,
        }
    };
    words.iter().filter_map(of).collect()
}

#[test]
fn no_crate_depends_on_one_that_the_table_does_not_give_it() {
    let (rooms, manifests) = (rooms(), manifests());
    for (name, manifest) in &manifests {
        let own: Vec<&Room> = rooms.iter().filter(|room| room.package == *name).collect();
        // The crates that only hand the functions of another to a browser.
        if ["bindings", "carom-first", "carom-whole"].contains(&name.as_str()) {
            continue;
        }
        let first =
            rooms.iter().position(|room| room.package == *name).unwrap_or_else(|| panic!("{name} is not there"));
        let above: BTreeSet<String> = rooms[..first].iter().map(|room| room.package.clone()).collect();
        assert!(manifest.needs.is_subset(&above), "{name} needs a crate below it: {:?}", manifest.needs);
        if own.iter().any(|room| room.imports.iter().any(|import| import == ALL)) {
            continue;
        }
        let imports = own.iter().flat_map(|room| &room.imports);
        let crates = imports.map(|import| {
            rooms
                .iter()
                .find(|room| room.name() == import)
                .unwrap_or_else(|| panic!("{name}: {import}"))
                .package
                .clone()
        });
        let given: BTreeSet<String> = crates.filter(|package| package != name).collect();
        assert_eq!(manifest.needs, given, "{name}: the manifest, and the table");
    }
}

#[test]
fn no_room_imports_what_the_table_does_not_give_it() {
    let rooms = rooms();
    let names: BTreeSet<&str> = rooms.iter().map(Room::name).collect();
    for (place, room) in rooms.iter().enumerate() {
        let above: BTreeSet<&str> = rooms[..place].iter().map(Room::name).collect();
        if room.imports.iter().any(|import| import == ALL) {
            continue;
        }
        let given: BTreeSet<&str> = room.imports.iter().map(String::as_str).collect();
        assert!(given.is_subset(&above), "{} imports a room below it", room.name());
        let lines: Vec<String> = room.paths.iter().flat_map(|path| code(&Path::new(ROOT).join(path))).collect();
        let found: BTreeSet<String> = lines.iter().flat_map(|line| imported(line)).collect();
        let found: BTreeSet<&str> =
            found.iter().map(String::as_str).filter(|name| names.contains(name) && *name != room.name()).collect();
        assert_eq!(found, given, "{}: the sources, and the table", room.name());
    }
}

#[test]
fn no_room_is_elsewhere_than_the_table_says() {
    let manifests = manifests();
    for room in rooms() {
        for path in &room.paths {
            let path = Path::new(ROOT).join(path);
            assert!(path.exists(), "{}", path.display());
            let folder = path.ancestors().find(|folder| folder.join("Cargo.toml").exists()).unwrap();
            assert_eq!(folder, manifests[&room.package].folder, "{}", path.display());
        }
    }
}

#[test]
fn no_crate_of_the_program_is_left_out_of_cargo_test() {
    for (name, manifest) in manifests() {
        let needs_tools = manifest.folder.starts_with(Path::new(ROOT).join("web")) || name == "carom-python";
        assert_eq!(manifest.is_default, !needs_tools, "{name}");
    }
}

/// Which of the language the kernel may use: the syntax tree, its names and substitution, and when an expression has a value. It
/// reads no text.
#[test]
fn the_kernel_uses_the_syntax_tree_alone_and_no_floating_point() {
    for room in ["kernel", "table_checker"] {
        let lines = code(&Path::new(ROOT).join("src/checker").join(room));
        assert!(lines.len() > 1000, "the folder is read");
        for line in &lines {
            for (place, start) in line.match_indices("crate::claim::") {
                let used = &line[place + start.len()..];
                let may_be = ["syntax::", "definedness::", "free_names::", "substitution", "circle::Point"];
                assert!(may_be.iter().any(|file| used.starts_with(file)), "{room}: {line}");
            }
            for word in ["f64", "f32", "unsafe", ".unwrap()", ".expect("] {
                assert!(!line.contains(word), "{room}: {line}");
            }
        }
    }
}
