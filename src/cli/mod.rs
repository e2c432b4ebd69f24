//! The command line: one file for each subcommand.
//!
//! `EXIT_CODES` lists the exit codes.

mod audit;
mod check;
mod eval;
mod explain;
mod export;
mod figures;
mod fmt;
mod form;
mod interrupt;
mod junit;
mod latex;
mod list;
mod load;
mod manual;
mod new;
mod output;
mod paper;
mod partial;
mod plot;
mod progress;
mod properties;
mod referee;
mod repair;
mod replay;
mod report;
mod rest;
mod restitution;
mod statements;
mod stream;
mod table;
mod table_certificate;
mod table_check;
mod table_contents;
mod table_cross;
mod table_rows;
mod table_write;
mod terminal;
mod theorems;
mod worksheet;

use clap::{CommandFactory, Parser, Subcommand, ValueEnum};
use output::{deliver, print, write_bytes, write_file};
use std::io::Write;
use std::path::PathBuf;
use std::process::ExitCode;

/// Audits the algebra of one-dimensional chain collisions and computes with it exactly.
#[derive(Parser)]
#[command(name = "carom", version = env!("CAROM_VERSION"), disable_help_subcommand = true, arg_required_else_help = true)]
#[command(after_help = EXIT_CODES)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
    #[command(flatten)]
    terminal: terminal::Flags,
}

/// The exit codes, and how to page through long output.
const EXIT_CODES: &str = "\
Exit codes:
    0  all as expected
    1  a verdict, a check or a comparison is not as expected
    2  bad input or usage
    3  a stated limit was reached
  130  interrupted by Ctrl-C

To page through long output: carom audit --color always | less -R";

/// The subcommands.
#[derive(Subcommand)]
enum Command {
    /// Judge claims: prove each, refute it with an exact counterexample, or say why it stays undecided
    #[command(
        after_help = "A file that ends in .tex or .md is a paper: its displayed equations are judged, and its comments `%carom given m > 0` \
                      hold the hypotheses. `carom help latex` describes them, `carom read FILE` shows what was read."
    )]
    Audit {
        /// Claim files, papers (.tex, .md) and folders [default: the built-in catalogue]
        paths: Vec<PathBuf>,
        /// Judge only these claims
        #[arg(long, value_name = "ID", num_args = 1.., value_delimiter = ',')]
        only: Vec<String>,
        /// The form of the report [default: by the ending of --output (.json, .md, .xml), else text]
        #[arg(long, value_enum)]
        format: Option<Format>,
        /// Write the report to a file, - for standard output
        #[arg(short, long, value_name = "FILE")]
        output: Option<PathBuf>,
        /// Write the certificate of each proved or refuted claim into this folder. The next audit reads those in the folder of
        /// the claims, and in its subfolder `certificates`, and then need not search
        #[arg(long, value_name = "DIR")]
        certificates: Option<PathBuf>,
        /// Search for every proof again, even if a stored certificate exists
        #[arg(long)]
        anew: bool,
        /// Accepted, and without effect: the kernel always checks the certificate of a proof
        #[arg(long, hide = true)]
        checked: bool,
        #[command(flatten)]
        limits: LimitFlags,
    },
    /// Read a paper in LaTeX or Markdown: print its equations as a claim file, with a list of what was read, what not and why, and of
    /// the names
    Read {
        /// The paper, a .tex or .md file
        path: PathBuf,
        /// Write the claim file to a file, - for standard output
        #[arg(short, long, value_name = "FILE")]
        output: Option<PathBuf>,
    },
    /// Check stored certificates of claims and of tables, with two small checkers that use no code of the search
    Check {
        /// Certificates of claims (files or folders) and of tables (the FILE of `carom table --certificate FILE`)
        /// [default: the certificates of the built-in catalogue]
        paths: Vec<PathBuf>,
        /// Claim files and folders with the statements that the certificates prove [default: the built-in catalogue]
        #[arg(long, value_name = "PATH", num_args = 1..)]
        claims: Vec<PathBuf>,
        /// Write the report to a file, - for standard output
        #[arg(short, long, value_name = "FILE")]
        output: Option<PathBuf>,
    },
    /// Print the proof, the refutation, or what was tried, for one claim
    Explain {
        /// The claim's name
        id: String,
        /// Claim files and folders [default: the built-in catalogue]
        paths: Vec<PathBuf>,
        /// The form of the argument [default: by the ending of --output (.md, .tex), else text]
        #[arg(long, value_enum)]
        format: Option<ExplainFormat>,
        /// Write the argument to a file, - for standard output
        #[arg(short, long, value_name = "FILE")]
        output: Option<PathBuf>,
        #[command(flatten)]
        limits: LimitFlags,
    },
    /// Find a hypothesis that a refuted claim lacks, and prove the claim with it
    #[command(
        after_help = "It tries the signs of the factors of left side - right side, the conditions under which both sides have \
                      values, the signs of differences in them, bounds on one variable, the order of two variables, and a \
                      least natural number.\n\n\
                      `holds where H` means: the goal is proved with the hypothesis H added. `holds exactly where H` means: \
                      goal <=> H is proved. The exit code is 1 if the claim is not refuted, or if the goal is not proved with \
                      any of these hypotheses."
    )]
    Repair {
        /// The claim's name
        id: String,
        /// Claim files and folders [default: the built-in catalogue]
        paths: Vec<PathBuf>,
        /// Write the certificate of the repaired claim into this folder
        #[arg(long, value_name = "DIR")]
        certificates: Option<PathBuf>,
        /// Write the repaired claim to a file, - for standard output
        #[arg(short, long, value_name = "FILE")]
        output: Option<PathBuf>,
        #[command(flatten)]
        limits: LimitFlags,
    },
    /// Compute with one chain: energy transfer, thresholds, masses, velocities, best number of bodies
    Eval(Box<eval::EvalFlags>),
    /// Print statements: name, hypotheses and goal, without judging them
    Print {
        /// Names of claims of the built-in catalogue, claim files and folders [default: the built-in catalogue]
        claims: Vec<String>,
        /// The form of the statements [default: by the ending of --output (.tex), else text]
        #[arg(long, value_enum)]
        format: Option<PrintFormat>,
        /// Write them to a file, - for standard output
        #[arg(short, long, value_name = "FILE")]
        output: Option<PathBuf>,
    },
    /// List claims: name, number, title and the verdict that the file expects
    List {
        /// Claim files and folders [default: the built-in catalogue]
        paths: Vec<PathBuf>,
        /// The form of the list [default: by the ending of --output (.json), else text]
        #[arg(long, value_enum)]
        format: Option<ValueFormat>,
        /// Write the list to a file, - for standard output
        #[arg(short, long, value_name = "FILE")]
        output: Option<PathBuf>,
    },
    /// Print a table of certified numbers, or check somebody else's table
    Table(table::Flags),
    /// Make a worksheet and its answer key from a scene file: text, PDF, HTML, LaTeX or Markdown
    Worksheet(worksheet::Flags),
    /// Find the coefficient of restitution from measured heights or times of bounces
    Restitution(restitution::Flags),
    /// Compare a collision simulator's results with exact reference scenes, digit by digit
    Referee(referee::Flags),
    /// Write an audit as a folder to hand in: a self-contained HTML page, Markdown, LaTeX or PDF, certificates, Coq
    /// proofs, certified tables and pictures
    Report(report::Flags),
    /// Draw a picture as SVG, PNG or PDF
    Plot(plot::Flags),
    /// Try claims at random exact points that satisfy their hypotheses
    Test(properties::Flags),
    /// Print statements for Coq or for SMT solvers, or write Coq proofs
    Export {
        /// The language of the other prover; --list does not need it
        #[arg(value_enum, required_unless_present = "list")]
        language: Option<Language>,
        /// Names of claims [default: all claims that the language can state]
        ids: Vec<String>,
        /// Claim files and folders [default: the built-in catalogue]
        #[arg(long, value_name = "PATH", num_args = 1..)]
        from: Vec<PathBuf>,
        /// For Coq: print theorems instead of definitions. Each names its proof in the folder that --proofs writes. Claims
        /// without a proof are left out
        #[arg(long)]
        theorems: bool,
        /// For Coq: write a self-contained folder (--output DIR). It holds a proof of each claim, made from its certificate,
        /// the library that the proofs import, and a script `check` that runs Coq on them
        #[arg(long, requires = "output", conflicts_with = "theorems")]
        proofs: bool,
        /// List the claims, and for each whether it can be exported, or why not
        #[arg(long, conflicts_with_all = ["theorems", "proofs"])]
        list: bool,
        /// Write to a file, - for standard output; with --proofs, a folder that is new or empty
        #[arg(short, long, value_name = "FILE", visible_alias = "out")]
        output: Option<PathBuf>,
        #[command(flatten)]
        limits: LimitFlags,
    },
    /// Start a paper of your own: make a folder with a preamble, an example claim and a README
    New {
        /// The folder to make; an existing one must be empty
        dir: PathBuf,
        /// The title of the paper
        #[arg(long, default_value = "My paper")]
        title: String,
    },
    /// Format claim files
    Fmt {
        /// Claim files and folders; - formats standard input to standard output
        #[arg(required = true)]
        paths: Vec<PathBuf>,
        /// Change nothing; exit 1 if a file is not formatted
        #[arg(long)]
        check: bool,
    },
    /// Replay collisions on a line exactly, one by one
    Replay(Box<replay::ReplayArguments>),
    /// Print a shell completion script; it also completes names of claims and quantities
    Completions {
        /// The shell
        shell: clap_complete::Shell,
        /// Write the script to a file, - for standard output
        #[arg(short, long, value_name = "FILE")]
        output: Option<PathBuf>,
    },
    /// Print a manual page, or write all manual pages into a folder
    Man {
        /// A subcommand [default: the page of the program]
        #[arg(conflicts_with = "output")]
        topic: Option<String>,
        /// Write the page of the program and of each subcommand into this folder
        #[arg(short, long, value_name = "DIR")]
        output: Option<PathBuf>,
    },
    /// Print help: `carom help language` describes the claim language, `carom help scene` scene files
    Help {
        /// A subcommand, `language`, `latex` or `scene`
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
    /// SMT-LIB 2 in the logic QF_NRA: the negation of the claim, so `unsat` means that the claim is true. Several claims
    /// become one script, with a reset between them
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
    /// The claim language with mathematical signs such as ≤ and ·
    Unicode,
    /// LaTeX with amsmath
    Latex,
}

/// Flags that raise or lower the limits.
#[derive(clap::Args)]
struct LimitFlags {
    /// Largest number of search steps for each claim
    #[arg(long, value_name = "N", default_value_t = 400_000)]
    max_steps: usize,
    /// Largest number of seconds for each claim, on one core
    #[arg(long, value_name = "SECONDS", default_value_t = 10, value_parser = seconds)]
    time: u64,
    /// Leave out a method of the search for proofs, to see what it alone decides (repeatable)
    #[arg(long, value_name = "METHOD", hide_possible_values = true)]
    #[arg(value_parser = clap::builder::PossibleValuesParser::new(crate::prove::methods()))]
    without: Vec<String>,
}

/// Whole seconds, with or without their unit.
fn seconds(text: &str) -> Result<u64, String> {
    let number = text.trim().trim_end_matches('s').trim();
    number.parse().map_err(|_| "write whole seconds, as in 2".to_string())
}

impl LimitFlags {
    fn limits(&self) -> crate::refute::catalogue::Limits {
        let time = std::time::Duration::from_secs(self.time);
        crate::refute::catalogue::Limits { steps: self.max_steps, time, without: self.without.clone() }
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

/// Bytes of stack for the worker thread: more than enough for the deepest nesting of expressions that is allowed.
const STACK: usize = 64 << 20;

/// Runs the program.
pub(crate) fn run() -> ExitCode {
    let arguments = Arguments::parse();
    arguments.terminal.apply();
    let worker = std::thread::Builder::new().stack_size(STACK).spawn(move || dispatch(arguments.command));
    let result = match worker.map(std::thread::JoinHandle::join) {
        Ok(Ok(result)) => result,
        _ => Err(Exit { code: 101, message: "the program failed; please report this".to_string() }),
    };
    match result {
        Ok(code) => ExitCode::from(code),
        Err(exit) => {
            let _ = writeln!(anstream::stderr(), "{}", output::message(&exit.message, terminal::colour()));
            ExitCode::from(exit.code)
        }
    }
}

/// The ending of claim files.
const CLAIMS: &[(&str, ())] = &[("claim", ())];
/// The endings of files for other provers.
const PROVERS: &[(&str, ())] = &[("v", ()), ("smt2", ())];

fn dispatch(command: Command) -> Result<u8, Exit> {
    interrupt::at_once()?;
    match command {
        Command::Audit { paths, only, format, output, certificates, anew, checked: _, limits } => {
            let settings = crate::judge::Settings { limits: limits.limits(), anew, argument: false };
            let (output, format) = (form::place(output.as_deref()), form::form(format, output.as_deref())?);
            audit::run(&paths, &only, format, output, certificates.as_deref(), &settings)
        }
        Command::Read { path, output } => {
            form::ending(output.as_deref(), CLAIMS)?;
            let (text, code, faults) = paper::run(&path)?;
            deliver(output.as_deref(), &text)?;
            if faults.is_empty() { Ok(code) } else { Err(Exit { code, message: faults.join("\n") }) }
        }
        Command::Check { paths, claims, output } => check::run(&paths, &claims, output.as_deref()),
        Command::Explain { id, paths, format, output, limits } => {
            let text = explain::run(&id, &paths, form::form(format, output.as_deref())?, &limits.limits())?;
            deliver(output.as_deref(), &text.0).map(|()| text.1)
        }
        Command::Repair { id, paths, certificates, output, limits } => {
            form::ending(output.as_deref(), CLAIMS)?;
            let text = repair::run(&id, &paths, certificates.as_deref(), &limits.limits())?;
            deliver(output.as_deref(), &text.0).map(|()| text.1)
        }
        Command::Eval(flags) => eval::run(&flags),
        Command::Worksheet(flags) => worksheet::run(&flags),
        Command::Restitution(flags) => restitution::run(&flags),
        Command::Referee(flags) => referee::run(&flags),
        Command::Plot(flags) => plot::run(&flags),
        Command::Test(flags) => properties::run(&flags),
        Command::Table(flags) => table::run(&flags),
        Command::Print { claims, format, output } => {
            let text = statements::run(&claims, form::form(format, output.as_deref())?)?;
            deliver(output.as_deref(), &text).map(|()| 0)
        }
        Command::List { paths, format, output } => {
            let text = list::run(&paths, form::form(format, output.as_deref())?)?;
            deliver(output.as_deref(), &text).map(|()| 0)
        }
        Command::Report(flags) => report::run(&flags),
        Command::Export { language, ids, from, theorems: _, proofs: true, list: _, output, limits } => {
            theorems::run(language, &ids, &from, output.as_deref(), &limits.limits())
        }
        Command::Export { language, ids, from, theorems: true, proofs: _, list: _, output, limits } => {
            form::ending(output.as_deref(), PROVERS)?;
            let text = theorems::page(language, &ids, &from, &limits.limits())?;
            deliver(output.as_deref(), &text).map(|()| 0)
        }
        Command::Export { language, ids, from, theorems: false, proofs: false, list, output, limits: _ } => {
            form::ending(output.as_deref(), PROVERS)?;
            let text = export::run(language, &ids, &from, list)?;
            deliver(output.as_deref(), &text).map(|()| 0)
        }
        Command::New { dir, title } => new::run(&dir, &title),
        Command::Fmt { paths, check } => fmt::run(&paths, check),
        Command::Replay(arguments) => replay::run(&arguments),
        Command::Completions { shell, output } => {
            deliver(output.as_deref(), &manual::completions(Arguments::command(), shell)).map(|()| 0)
        }
        Command::Man { topic, output } => {
            let mut command = Arguments::command();
            command.build();
            manual::run(command, topic.as_deref(), output.as_deref())
        }
        Command::Help { topic } => help(topic.as_deref()),
    }
}

/// How a paper is written that `carom audit` reads, for `carom help latex`.
const LATEX: &str = include_str!("../../docs/latex.md");

/// Topics of help that are not subcommands.
const TOPICS: [&str; 3] = ["language", "latex", "scene"];

/// The error for help, or a manual page, on something that is neither a subcommand nor one of `more`.
fn no_topic(command: &clap::Command, name: &str, more: &[&str]) -> Exit {
    let topics: Vec<&str> =
        command.get_subcommands().map(clap::Command::get_name).chain(more.iter().copied()).collect();
    let near = match crate::claim::diagnostic::nearest(name, topics.iter().copied()) {
        Some(near) => format!("did you mean {near}?"),
        None => format!("the topics are {}", topics.join(", ")),
    };
    Exit::usage(format!("error: there is no help topic called {name}; {near}"))
}

fn help(topic: Option<&str>) -> Result<u8, Exit> {
    let mut command = Arguments::command();
    // Without this a subcommand does not know the name of the program.
    command.build();
    match topic {
        None => print(&command.render_long_help().to_string())?,
        Some("language") => print(crate::claim::LANGUAGE)?,
        Some("latex") => print(LATEX)?,
        Some("scene") => print(&eval::scene_help())?,
        Some(name) => match command.find_subcommand_mut(name) {
            Some(sub) => print(&sub.render_long_help().to_string())?,
            None => return Err(no_topic(&command, name, &TOPICS)),
        },
    }
    Ok(0)
}
