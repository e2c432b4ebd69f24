//! `carom man` and `carom completions`: what a system knows of the program.

use super::output::write_bytes;
use super::{Exit, print};
use crate::claim::embedded;
use crate::scene::quantity::Quantity;
use clap::Command;
use clap::builder::PossibleValuesParser;
use std::path::Path;

/// Subcommands with the arguments that are names of claims.
const CLAIMS: [(&str, &str); 6] =
    [("audit", "only"), ("explain", "id"), ("repair", "id"), ("print", "claims"), ("export", "ids"), ("test", "only")];

/// A completion script. For bash, zsh and fish it knows the claims of the catalogue, the quantities and the topics of the help.
pub(super) fn completions(mut command: Command, shell: clap_complete::Shell) -> String {
    let claims: Vec<&str> = embedded::files().into_iter().map(|f| embedded::stem(f.path)).collect();
    let topics: Vec<String> = command.get_subcommands().map(|c| c.get_name().to_owned()).collect();
    for (name, argument) in CLAIMS {
        command = with(command, name, argument, PossibleValuesParser::new(claims.clone()));
    }
    command = with(command, "eval", "want", PossibleValuesParser::new(Quantity::names()));
    command = with(command, "man", "topic", PossibleValuesParser::new(topics.clone()));
    let all = topics.into_iter().chain(super::TOPICS.map(str::to_owned));
    command = with(command, "help", "topic", PossibleValuesParser::new(all));
    let mut out = Vec::new();
    clap_complete::generate(shell, &mut command, "carom", &mut out);
    String::from_utf8_lossy(&out).into_owned()
}

/// The command with a closed list of values for an argument of a subcommand, where there is one.
fn with(command: Command, name: &str, argument: &str, values: PossibleValuesParser) -> Command {
    let known = |sub: &Command| sub.get_arguments().any(|a| a.get_id() == argument);
    if !command.find_subcommand(name).is_some_and(known) {
        return command;
    }
    // In place: the order of the arguments is that of the command line.
    let mended = |arg: clap::Arg| if arg.get_id() == argument { arg.value_parser(values.clone()) } else { arg };
    command.mut_subcommand(name, |sub| sub.mut_args(mended))
}

/// Prints one page, or writes all of them.
pub(super) fn run(mut command: Command, topic: Option<&str>, folder: Option<&Path>) -> Result<u8, Exit> {
    if let Some(folder) = super::form::place(folder) {
        let cannot = |e: std::io::Error| Exit::usage(format!("error: cannot make {}: {e}", folder.display()));
        std::fs::create_dir_all(folder).map_err(cannot)?;
        let subcommands: Vec<Command> = command.get_subcommands().cloned().collect();
        write_bytes(&folder.join("carom.1"), page(command).as_bytes())?;
        for sub in subcommands {
            let name = format!("carom-{}.1", sub.get_name());
            write_bytes(&folder.join(name), page(sub).as_bytes())?;
        }
        return Ok(0);
    }
    let page = match topic {
        None => page(command),
        Some(name) => match command.find_subcommand_mut(name) {
            Some(sub) => page(sub.clone()),
            None => return Err(super::no_topic(&command, name, &[])),
        },
    };
    print(&page).map(|()| 0)
}

/// A manual page in the language of `man`.
fn page(command: Command) -> String {
    let name = command.get_display_name().unwrap_or("carom").to_owned();
    let mut out = Vec::new();
    // A vector takes everything.
    let _ = clap_mangen::Man::new(command.disable_help_flag(true)).title(name.to_uppercase()).render(&mut out);
    String::from_utf8_lossy(&out).into_owned()
}
