//! The form in which a command writes: from `--format`, or from the name of the output file.
//!
//! Contract: `--format` decides; without it the ending of the `--output` file; without that the form is text. The ending
//! of a form that the command does not write is an error, so that no `.svg` file holds a table.

use super::Exit;
use std::path::Path;

/// Endings of file names that stand for a form.
const KNOWN: [&str; 12] = ["txt", "csv", "json", "md", "markdown", "tex", "xml", "html", "htm", "svg", "png", "pdf"];

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
/// The file's ending stands for a form that the command does not have.
pub(super) fn form<F: Form>(format: Option<F>, output: Option<&Path>) -> Result<F, Exit> {
    if let Some(format) = format {
        return Ok(format);
    }
    let end = place(output).and_then(Path::extension).map(|end| end.to_string_lossy().to_ascii_lowercase());
    let Some(end) = end else { return Ok(F::DEFAULT) };
    if let Some((_, form)) = F::ENDINGS.iter().find(|(known, _)| *known == end) {
        return Ok(*form);
    }
    if end == "txt" || !KNOWN.contains(&end.as_str()) {
        return Ok(F::DEFAULT);
    }
    let endings: Vec<String> = F::ENDINGS.iter().map(|(end, _)| format!(".{end}")).collect();
    let shown = output.map_or(String::new(), |path| path.display().to_string());
    Err(Exit::usage(format!(
        "error: --output {shown}: this command writes no .{end} file; use {} or .txt",
        endings.join(", ")
    )))
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
    const ENDINGS: &'static [(&'static str, Self)] = &[("tex", Self::Latex)];
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
