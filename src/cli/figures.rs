//! The tables and pictures of a report: each is asked for in the words that follow `carom table` or `carom plot`.

use super::{Exit, table};
use crate::report::handout::numbers::{ROWS, Table};
use crate::report::table::Head;
use clap::Parser;

/// The tables in the report of the built-in catalogue.
pub(super) const TABLES: [&str; 3] = [
    "--want eta --ratio 10 -e 0.8,0.9,1 -n 0:4:1",
    "--want threshold --ratio 2,10,100,1000 -n 1,2,3,5",
    "--want best-n --ratio 10,100,1000,1e6 -e 0.5,0.8,0.9,0.95",
];

/// The pictures there.
pub(crate) const PLOTS: [&str; 4] = ["eta-x", "eta-n", "threshold", "map"];

/// The words after `carom table`.
#[derive(Parser)]
#[command(no_binary_name = true, disable_help_flag = true)]
struct TableWords {
    #[command(flatten)]
    contents: super::table_contents::Contents,
}

/// The words after `carom plot`.
#[derive(Parser)]
#[command(no_binary_name = true, disable_help_flag = true)]
struct PlotWords {
    #[command(flatten)]
    contents: super::plot::Contents,
}

/// A table from its words.
///
/// # Errors
/// Flags that `carom table` does not know, flags that a report sets itself, such as `--format`, or a limit.
pub(super) fn table(text: &str) -> Result<Table, Exit> {
    let within = |exit: Exit| Exit { message: format!("{}\n  in --table '{text}'", exit.message), ..exit };
    let words = words(text).map_err(within)?;
    let parsed = TableWords::try_parse_from(&words).map_err(|e| within(refused(&e)))?;
    let plan = parsed.contents.plan().map_err(within)?;
    if plan.rows() > ROWS {
        let message =
            format!("error: limit reached: rows of a table in a report: {ROWS} allowed, {} asked for", plan.rows());
        return Err(within(Exit { code: 3, message }));
    }
    let (csv, certificate) = table::in_memory(&plan).map_err(within)?;
    let rows = table::rows(&plan).map_err(within)?;
    let command = format!("carom table {}", words.join(" "));
    Ok(Table { command, quantity: plan.quantity(), head: Head::of(&plan), rows, csv, certificate })
}

/// A picture from its words; `place` is its number, from 0.
///
/// # Errors
/// Flags that `carom plot` does not know, flags that a report sets itself, such as `--output`, or a limit.
pub(super) fn plot(place: usize, text: &str) -> Result<crate::report::handout::numbers::Plot, Exit> {
    use crate::report::handout::numbers::Plot;
    use crate::report::plot::{letters, png, svg};
    use std::path::Path;
    let within = |exit: Exit| Exit { message: format!("{}\n  in --plot '{text}'", exit.message), ..exit };
    let words = words(text).map_err(within)?;
    let contents = PlotWords::try_parse_from(&words).map_err(|e| within(refused(&e)))?.contents;
    let page = contents.draw().map_err(within)?;
    let png = png::render(&page, 3.0).map_err(|e| within(Exit { code: 3, message: format!("error: {e}") }))?;
    // A scene's folder belongs to this machine and not to the report.
    let shown = |word: &String| match Path::new(word).file_name() {
        Some(name) if Path::new(word).is_file() => name.to_string_lossy().into_owned(),
        _ => word.clone(),
    };
    Ok(Plot {
        command: format!("carom plot {}", words.iter().map(shown).collect::<Vec<_>>().join(" ")),
        title: letters::plain(&page.title),
        description: page.description.clone(),
        claims: contents.claims(),
        inline: svg::inline(&page, &Plot::prefix(place)),
        svg: svg::render(&page),
        png,
    })
}

fn refused(error: &clap::Error) -> Exit {
    // Only the first paragraph of clap's message is kept: its usage line names a command that does not exist.
    let text = error.to_string();
    Exit::usage(text.split("\n\n").next().unwrap_or_default().trim_end())
}

/// A text cut into words at spaces, but not between quotation marks.
fn words(text: &str) -> Result<Vec<String>, Exit> {
    let (mut out, mut word, mut mark): (Vec<String>, Option<String>, Option<char>) = (Vec::new(), None, None);
    for c in text.chars() {
        match mark {
            Some(open) if c == open => mark = None,
            None if c == '"' || c == '\'' => {
                mark = Some(c);
                word.get_or_insert_default();
            }
            None if c.is_whitespace() => out.extend(word.take()),
            _ => word.get_or_insert_default().push(c),
        }
    }
    if mark.is_some() {
        return Err(Exit::usage("error: a quotation mark is not closed"));
    }
    out.extend(word);
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_end_at_spaces_outside_quotation_marks() {
        let cut = |text: &str| words(text).map_err(|e| e.message);
        let four = ["a", "b c", "de fg", ""].map(str::to_owned).to_vec();
        assert_eq!(cut(" a  'b c' d\"e f\"g ''"), Ok(four));
        assert!(cut("a 'b").is_err());
    }
}
