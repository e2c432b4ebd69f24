//! Bad inputs over all faces of the program: each gets one clear error, exit code 2 and no answer.
//!
//! `bad_inputs.json` lists them: the arguments, files to make in an empty folder, standard input, and a part of what the
//! error must say. To add one, add a line.

use crate::support::in_folder;
use serde_json::Value;

const INPUTS: &str = include_str!("../bad_inputs.json");

/// Commands that answer for what is good, and name what is not.
const GO_ON: [&str; 2] = ["audit", "eval"];

#[test]
fn each_bad_input_gets_one_error_that_says_what_is_wrong() {
    let inputs: Vec<Value> = serde_json::from_str(INPUTS).expect("JSON");
    assert!(inputs.len() >= 200, "{}", inputs.len());
    let word = |value: &Value| value.as_str().expect("a text").to_owned();
    for input in &inputs {
        let folder = tempfile::tempdir().expect("a folder");
        for (name, text) in input["files"].as_object().into_iter().flatten() {
            let path = folder.path().join(name);
            std::fs::create_dir_all(path.parent().expect("a folder")).expect("made");
            std::fs::write(path, word(text)).expect("written");
        }
        let arguments: Vec<String> = input["run"].as_array().expect("a list").iter().map(word).collect();
        let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
        let out = in_folder(folder.path(), &words, input["stdin"].as_str().unwrap_or(""));
        let said = String::from_utf8_lossy(&out.stderr);
        let errors = said.lines().filter(|line| line.starts_with("error")).count();
        assert_eq!((out.status.code(), errors), (Some(2), 1), "{arguments:?}: {said}");
        assert!(said.contains(&word(&input["says"])), "{arguments:?}: {said}");
        assert!(out.stdout.is_empty() || GO_ON.contains(&&*arguments[0]), "{arguments:?} answers all the same");
    }
}
