//! The command line: one file for each subcommand.
//!
//! Exit codes: 0 all as expected; 1 a verdict or a check is not as expected; 2 bad input or usage; 3 a
//! stated limit was reached; 130 interrupted.

mod audit;
mod check;
mod eval;
mod explain;
mod export;
mod figures;
mod fmt;
mod interrupt;
mod latex;
mod load;
mod output;
mod partial;
#[cfg(feature = "plot")]
mod plot;
mod progress;
#[cfg(feature = "proptest")]
mod properties;
mod replay;
mod report;
mod statements;
mod table;
mod table_certificate;
mod table_check;
mod table_contents;
mod table_merge;
mod table_rows;
mod worksheet;

use clap::{CommandFactory, Parser, Subcommand, ValueEnum};
use output::{print, write_bytes, write_file};
use std::io::Write;
use std::path::PathBuf;
use std::process::ExitCode;

/// Audits the algebra of one-dimensional chain collisions and computes with it exactly.
#[derive(Parser)]
#[command(name = "carom", version, disable_help_subcommand = true, arg_required_else_help = true)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

/// The subcommands.
#[derive(Subcommand)]
enum Command {
    /// Judge claims: proved, refuted with an exact counterexample, or undecided with the reason
    Audit {
        /// Claim files and folders; the built-in catalogue if none is given
        paths: Vec<PathBuf>,
        /// Judge only these claims
        #[arg(long, value_name = "ID", num_args = 1..)]
        only: Vec<String>,
        /// The form of the report
        #[arg(long, value_enum, default_value = "text")]
        format: Format,
        /// Write the report to a file
        #[arg(long, value_name = "FILE")]
        output: Option<PathBuf>,
        /// Write the certificate of each proved claim into this folder; in the folder of the claims, or in
        /// `certificates` there, the next audit finds them and has nothing to search
        #[arg(long, value_name = "DIR")]
        certificates: Option<PathBuf>,
        /// Search every proof anew, even where a certificate is at hand
        #[arg(long)]
        anew: bool,
        /// Changes nothing: a proof always counts only where the kernel accepts a certificate of it
        #[arg(long, hide = true)]
        checked: bool,
        #[command(flatten)]
        limits: LimitFlags,
    },
    /// Check certificates again, of claims and of tables, with the small kernel, which trusts nothing of the prover
    Check {
        /// Certificates of claims, folders of them, and what `carom table --certificate FILE` writes, told apart by what
        /// they hold; those of the built-in catalogue if none is given
        paths: Vec<PathBuf>,
        /// Claim files and folders that the certificates are of; the built-in catalogue if none is given
        #[arg(long, value_name = "PATH", num_args = 1..)]
        claims: Vec<PathBuf>,
        /// Print the verdicts only, not the statements as the kernel understood them
        #[arg(long)]
        quiet: bool,
    },
    /// Print the whole argument of one claim
    Explain {
        /// The claim's name
        id: String,
        /// Claim files and folders; the built-in catalogue if none is given
        paths: Vec<PathBuf>,
        /// The form of the argument
        #[arg(long, value_enum, default_value = "text")]
        format: ExplainFormat,
        #[command(flatten)]
        limits: LimitFlags,
    },
    /// Compute with one chain: energy transfer, thresholds, masses, velocities, best number of bodies
    Eval(Box<eval::EvalFlags>),
    /// Print statements: name, hypotheses and goal, without judging them
    Print {
        /// Names of the built-in catalogue, claim files and folders; the whole catalogue if none is given
        claims: Vec<String>,
        /// How to write them
        #[arg(long, value_enum, default_value = "text")]
        format: PrintFormat,
    },
    /// Print a table of certified numbers, or check somebody's
    Table(table::Flags),
    /// Print what each collision of a scene does, blank and as an answer key
    Worksheet(worksheet::Flags),
    /// Write an audit as a folder to hand in: HTML that needs nothing else, Markdown, LaTeX or PDF, certificates, Coq
    /// proofs, certified tables and pictures
    Report(report::Flags),
    /// Draw a picture as SVG or PNG
    #[cfg(feature = "plot")]
    Plot(plot::Flags),
    /// Try the paper's claims on random exact chains
    #[cfg(feature = "proptest")]
    Test(properties::Flags),
    /// Print statements for other provers: for Coq, or for SMT solvers
    Export {
        /// The language; with --list it may be left out
        #[arg(value_enum, required_unless_present = "list")]
        language: Option<Language>,
        /// The claims; all that can be said in the language if none is given
        ids: Vec<String>,
        /// Claim files and folders; the built-in catalogue if none is given
        #[arg(long, value_name = "PATH", num_args = 1..)]
        from: Vec<PathBuf>,
        /// For Coq: theorems with the places of their proofs in proofs/coq, instead of definitions; claims without a
        /// proof there are left out
        #[arg(long)]
        theorems: bool,
        /// Say of each claim whether it can be exported, and why not
        #[arg(long, conflicts_with = "theorems")]
        list: bool,
    },
    /// Rewrite claim files in the one style
    Fmt {
        /// Claim files and folders
        #[arg(required = true)]
        paths: Vec<PathBuf>,
        /// Change nothing; exit 1 if a file is not formatted
        #[arg(long)]
        check: bool,
    },
    /// Replay collisions on a line exactly, one by one
    Replay(Box<replay::ReplayArguments>),
    /// Print a completion script
    Completions {
        /// The shell
        shell: clap_complete::Shell,
    },
    /// Print help: `carom help language` describes the claim language, `carom help scene` scene files
    Help {
        /// A subcommand, `language` or `scene`
        topic: Option<String>,
    },
}

/// The forms of a report.
#[derive(Clone, Copy, ValueEnum)]
enum Format {
    Text,
    Json,
    Markdown,
    Junit,
}

/// The forms of answers.
#[derive(Clone, Copy, ValueEnum)]
enum ValueFormat {
    Text,
    Json,
}

/// The languages of other provers.
#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Language {
    /// Coq, over its real numbers
    Coq,
    /// SMT-LIB 2 in the logic QF_NRA: the negation, to be found unsatisfiable; several claims are one script, with a
    /// reset between them
    Smt2,
}

/// The forms of an argument.
#[derive(Clone, Copy, ValueEnum)]
enum ExplainFormat {
    Text,
    Markdown,
    Latex,
}

/// The ways of writing a statement.
#[derive(Clone, Copy, ValueEnum)]
enum PrintFormat {
    /// The claim language
    Text,
    /// Signs such as ≤ and ·
    Unicode,
    /// For a document with amsmath
    Latex,
}

/// Flags that raise or lower the limits.
#[derive(clap::Args)]
struct LimitFlags {
    /// The largest power of a sum that is expanded
    #[arg(long, value_name = "N", default_value_t = 100)]
    max_degree: u32,
    /// The most terms of a sum
    #[arg(long, value_name = "N", default_value_t = 5000)]
    max_terms: usize,
    /// The most bits of a coefficient after a power
    #[arg(long, value_name = "BITS", default_value_t = 100_000)]
    max_digits: u64,
    /// The most steps of the search for each claim
    #[arg(long, value_name = "N", default_value_t = 400_000)]
    max_steps: usize,
    /// The most seconds for each claim
    #[arg(long, value_name = "SECONDS", default_value_t = 10)]
    time: u64,
}

impl LimitFlags {
    fn limits(&self) -> crate::prove::catalogue::Limits {
        crate::prove::catalogue::Limits {
            degree: self.max_degree,
            terms: self.max_terms,
            digits: self.max_digits,
            steps: self.max_steps,
            time: std::time::Duration::from_secs(self.time),
        }
    }
}

/// A failure that ends the program: what to print, and the exit code.
struct Exit {
    code: u8,
    message: String,
}

impl Exit {
    fn usage(message: impl Into<String>) -> Exit {
        Exit { code: 2, message: message.into() }
    }

    /// Faults of input: 3 if they are limits and nothing else is wrong.
    fn faults(messages: &[String], only_limits: bool) -> Exit {
        Exit { code: if only_limits { 3 } else { 2 }, message: messages.join("\n") }
    }
}

/// Runs the program.
pub fn run() -> ExitCode {
    let arguments = Arguments::parse();
    // Expressions nest up to a limit; this stack holds the deepest with room to spare.
    let worker = std::thread::Builder::new().stack_size(64 << 20).spawn(move || dispatch(arguments.command));
    let result = match worker.map(std::thread::JoinHandle::join) {
        Ok(Ok(result)) => result,
        _ => Err(Exit { code: 101, message: "the program failed; please report this".to_string() }),
    };
    match result {
        Ok(code) => ExitCode::from(code),
        Err(exit) => {
            let _ = writeln!(anstream::stderr(), "{}", output::message(&exit.message, load::colour()));
            ExitCode::from(exit.code)
        }
    }
}

fn dispatch(command: Command) -> Result<u8, Exit> {
    match command {
        Command::Audit { paths, only, format, output, certificates, anew, checked: _, limits } => {
            let settings = crate::judge::Settings { limits: limits.limits(), anew, argument: false };
            audit::run(&paths, &only, format, output.as_deref(), certificates.as_deref(), &settings)
        }
        Command::Check { paths, claims, quiet } => check::run(&paths, &claims, quiet),
        Command::Explain { id, paths, format, limits } => explain::run(&id, &paths, format, &limits.limits()),
        Command::Eval(flags) => eval::run(&flags),
        Command::Worksheet(flags) => worksheet::run(&flags),
        #[cfg(feature = "plot")]
        Command::Plot(flags) => plot::run(&flags),
        #[cfg(feature = "proptest")]
        Command::Test(flags) => properties::run(&flags),
        Command::Table(flags) => table::run(&flags),
        Command::Print { claims, format } => statements::run(&claims, format),
        Command::Report(flags) => report::run(&flags),
        Command::Export { language, ids, from, theorems, list } => export::run(language, &ids, &from, theorems, list),
        Command::Fmt { paths, check } => fmt::run(&paths, check),
        Command::Replay(arguments) => replay::run(&arguments),
        Command::Completions { shell } => {
            let mut out = Vec::new();
            clap_complete::generate(shell, &mut Arguments::command(), "carom", &mut out);
            print(&String::from_utf8_lossy(&out)).map(|()| 0)
        }
        Command::Help { topic } => help(topic.as_deref()),
    }
}

fn help(topic: Option<&str>) -> Result<u8, Exit> {
    let mut command = Arguments::command();
    // Without this a subcommand does not know the name of the program.
    command.build();
    match topic {
        None => print(&command.render_long_help().to_string())?,
        Some("language") => print(crate::claim::LANGUAGE)?,
        Some("scene") => print(&eval::scene_help())?,
        Some(name) => match command.find_subcommand_mut(name) {
            Some(sub) => print(&sub.render_long_help().to_string())?,
            None => {
                let topics: Vec<String> = command.get_subcommands().map(|c| c.get_name().to_string()).collect();
                return Err(Exit::usage(format!(
                    "error: there is no help on {name}; topics are {}, language, scene",
                    topics.join(", ")
                )));
            }
        },
    }
    Ok(0)
}
