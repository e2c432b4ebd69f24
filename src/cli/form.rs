//! The form in which a command writes: from `--format`, or from the name of the output file.
//!
//! Contract: `--format` decides; without it the ending of the `--output` file; without that the form is text. Any other
//! ending is an error, so that no `.svg` or `.docx` file holds a table.

use super::Exit;
use std::path::Path;

/// The forms of a command.
pub(super) trait Form: Copy + 'static {
    /// The form without flag and ending.
    const DEFAULT: Self;
    /// The endings that stand for its other forms, in small letters.
    const ENDINGS: &'static [(&'static str, Self)];
}

/// The file that a flag names; `None` for standard output, which is also written `-`.
pub(super) fn place(output: Option<&Path>) -> Option<&Path> {
    output.filter(|path| path.as_os_str() != "-")
}

/// The form to write.
///
/// # Errors
/// The file's ending stands for no form of the command.
pub(super) fn form<F: Form>(format: Option<F>, output: Option<&Path>) -> Result<F, Exit> {
    match format {
        Some(format) => Ok(format),
        None => Ok(ending(output, F::ENDINGS)?.unwrap_or(F::DEFAULT)),
    }
}

/// What the ending of a file stands for; `None` for `.txt`, without an ending, and for standard output.
///
/// # Errors
/// Any other ending.
pub(super) fn ending<F: Copy>(output: Option<&Path>, endings: &[(&str, F)]) -> Result<Option<F>, Exit> {
    let Some((path, end)) = place(output).and_then(|path| Some((path, path.extension()?))) else { return Ok(None) };
    let end = end.to_string_lossy().to_ascii_lowercase();
    match endings.iter().find(|(known, _)| *known == end) {
        Some((_, form)) => Ok(Some(*form)),
        None if end == "txt" => Ok(None),
        None => {
            let known: Vec<String> = endings.iter().map(|(end, _)| format!(".{end}")).collect();
            let known = if known.is_empty() { String::new() } else { known.join(", ") + " or " };
            let shown = path.display();
            Err(Exit::usage(format!("error: --output {shown}: this command writes no .{end} file; use {known}.txt")))
        }
    }
}

impl Form for super::Format {
    const DEFAULT: Self = Self::Text;
    const ENDINGS: &'static [(&'static str, Self)] =
        &[("json", Self::Json), ("md", Self::Markdown), ("markdown", Self::Markdown), ("xml", Self::Junit)];
}

impl Form for super::ValueFormat {
    const DEFAULT: Self = Self::Text;
    const ENDINGS: &'static [(&'static str, Self)] = &[("json", Self::Json)];
}

impl Form for super::ExplainFormat {
    const DEFAULT: Self = Self::Text;
    const ENDINGS: &'static [(&'static str, Self)] =
        &[("md", Self::Markdown), ("markdown", Self::Markdown), ("tex", Self::Latex)];
}

impl Form for super::PrintFormat {
    const DEFAULT: Self = Self::Text;
    const ENDINGS: &'static [(&'static str, Self)] = &[("tex", Self::Latex), ("claim", Self::Text)];
}

impl Form for super::replay::ReplayFormat {
    const DEFAULT: Self = Self::Text;
    const ENDINGS: &'static [(&'static str, Self)] =
        &[("json", Self::Json), ("csv", Self::Csv), ("svg", Self::Svg), ("html", Self::Html), ("htm", Self::Html)];
}

impl Form for crate::report::table::Form {
    const DEFAULT: Self = Self::Text;
    const ENDINGS: &'static [(&'static str, Self)] = &[
        ("csv", Self::Csv),
        ("json", Self::Json),
        ("md", Self::Markdown),
        ("markdown", Self::Markdown),
        ("tex", Self::Latex),
    ];
}
