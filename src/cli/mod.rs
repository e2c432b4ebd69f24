//! The command line: one file for each subcommand.
//!
//! The exit codes stand in `EXIT_CODES`.

mod audit;
mod check;
mod eval;
mod explain;
mod export;
mod figures;
mod fmt;
mod form;
mod interrupt;
mod latex;
mod list;
mod load;
mod manual;
mod new;
mod output;
mod partial;
#[cfg(feature = "plot")]
mod plot;
mod progress;
#[cfg(feature = "proptest")]
mod properties;
mod referee;
mod repair;
mod replay;
mod report;
mod restitution;
mod statements;
mod table;
mod table_certificate;
mod table_check;
mod table_contents;
mod table_cross;
mod table_merge;
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

/// What the exit code says, and how to read on.
const EXIT_CODES: &str = "\
Exit codes:
    0  all as expected
    1  a verdict, a check or a comparison is not as expected
    2  bad input or usage
    3  a stated limit was reached
  130  interrupted by Ctrl-C

There is no pager: what is printed is the same on a screen and in a pipe.
To read page by page: carom audit --color always | less -R";

/// The subcommands.
#[derive(Subcommand)]
enum Command {
    /// Judge claims: proved, refuted with an exact counterexample, or undecided with the reason
    Audit {
        /// Claim files and folders; the built-in catalogue if none is given
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
        /// Write the report to a file, - for standard output
        #[arg(short, long, value_name = "FILE")]
        output: Option<PathBuf>,
    },
    /// Print the whole argument of one claim
    Explain {
        /// The claim's name
        id: String,
        /// Claim files and folders; the built-in catalogue if none is given
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
    /// Find the hypothesis that a refuted claim lacks, and prove the claim with it
    #[command(
        after_help = "Tried are the signs of the factors of left side - right side, what the goal needs for its value, bounds on one variable,
the order of two, and a least natural number. `holds exactly where H` means that goal <=> H is proved; `holds where H` that
the goal is proved with H among the hypotheses. Exit code 1: the claim is not refuted, or no such hypothesis is shown to
be enough."
    )]
    Repair {
        /// The claim's name
        id: String,
        /// Claim files and folders; the built-in catalogue if none is given
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
        /// Names of the built-in catalogue, claim files and folders; the whole catalogue if none is given
        claims: Vec<String>,
        /// How to write them [default: by the ending of --output (.tex), else text]
        #[arg(long, value_enum)]
        format: Option<PrintFormat>,
        /// Write them to a file, - for standard output
        #[arg(short, long, value_name = "FILE")]
        output: Option<PathBuf>,
    },
    /// List claims: name, number and title, and the verdict that the file expects
    List {
        /// Claim files and folders; the built-in catalogue if none is given
        paths: Vec<PathBuf>,
        /// The form of the list [default: by the ending of --output (.json), else text]
        #[arg(long, value_enum)]
        format: Option<ValueFormat>,
        /// Write the list to a file, - for standard output
        #[arg(short, long, value_name = "FILE")]
        output: Option<PathBuf>,
    },
    /// Print a table of certified numbers, or check somebody's
    Table(table::Flags),
    /// Make a worksheet of a scene and its answer key: text, PDF, HTML, LaTeX or Markdown
    Worksheet(worksheet::Flags),
    /// Find the coefficient of restitution from measured heights or times of bounces
    Restitution(restitution::Flags),
    /// Judge a simulator of collisions by exact reference scenes: right, or wrong from which digit on
    Referee(referee::Flags),
    /// Write an audit as a folder to hand in: HTML that needs nothing else, Markdown, LaTeX or PDF, certificates, Coq
    /// proofs, certified tables and pictures
    Report(report::Flags),
    /// Draw a picture as SVG or PNG
    #[cfg(feature = "plot")]
    Plot(plot::Flags),
    /// Try claims at random exact points that satisfy their hypotheses
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
        /// For Coq: theorems, each with the place of its proof in a folder of --proofs, instead of definitions; claims
        /// without a proof are left out
        #[arg(long)]
        theorems: bool,
        /// For Coq: write a folder that stands alone, with a proof of each claim, made from its certificate, the library
        /// that the proofs rest on, and a script `check` that has Coq verify them; the folder is --output DIR, or --out DIR
        #[arg(long, requires = "output", conflicts_with = "theorems")]
        proofs: bool,
        /// Say of each claim whether it can be exported, and why not
        #[arg(long, conflicts_with_all = ["theorems", "proofs"])]
        list: bool,
        /// Write to a file, - for standard output; with --proofs the folder, which has to be new or empty
        #[arg(short, long, value_name = "FILE", visible_alias = "out")]
        output: Option<PathBuf>,
        #[command(flatten)]
        limits: LimitFlags,
    },
    /// Begin a paper of your own: a folder with a preamble, a claim and a README
    New {
        /// The folder to make; if it is there, it must be empty
        dir: PathBuf,
        /// The title of the paper
        #[arg(long, default_value = "My paper")]
        title: String,
    },
    /// Rewrite claim files in the one style
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
    /// Print a completion script, which knows the names of the catalogue's claims and of the quantities
    Completions {
        /// The shell
        shell: clap_complete::Shell,
        /// Write the script to a file, - for standard output
        #[arg(short, long, value_name = "FILE")]
        output: Option<PathBuf>,
    },
    /// Print a manual page, or write all of them into a folder
    Man {
        /// The subcommand; the program itself if none is given
        #[arg(conflicts_with = "output")]
        topic: Option<String>,
        /// Write the page of the program and one of each subcommand into this folder
        #[arg(short, long, value_name = "DIR")]
        output: Option<PathBuf>,
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
    /// Accepted, and without effect: what these flags limited is no longer there
    #[arg(long = "max-degree", value_name = "N", hide = true, alias = "max-terms", aliases = ["max-bits", "max-digits"])]
    #[arg(action = clap::ArgAction::Append)]
    _former: Vec<u64>,
    /// The most steps of the search for each claim
    #[arg(long, value_name = "N", default_value_t = 400_000)]
    max_steps: usize,
    /// The most seconds of work for each claim, on one core
    #[arg(long, value_name = "SECONDS", default_value_t = 10)]
    time: u64,
}

impl LimitFlags {
    fn limits(&self) -> crate::refute::catalogue::Limits {
        crate::refute::catalogue::Limits { steps: self.max_steps, time: std::time::Duration::from_secs(self.time) }
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

/// Expressions nest up to a limit; a stack of so many bytes holds the deepest with room to spare.
const STACK: usize = 64 << 20;

/// Runs the program.
pub fn run() -> ExitCode {
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

fn dispatch(command: Command) -> Result<u8, Exit> {
    interrupt::at_once()?;
    match command {
        Command::Audit { paths, only, format, output, certificates, anew, checked: _, limits } => {
            let settings = crate::judge::Settings { limits: limits.limits(), anew, argument: false };
            let (output, format) = (form::place(output.as_deref()), form::form(format, output.as_deref())?);
            audit::run(&paths, &only, format, output, certificates.as_deref(), &settings)
        }
        Command::Check { paths, claims, output } => check::run(&paths, &claims, output.as_deref()),
        Command::Explain { id, paths, format, output, limits } => {
            let text = explain::run(&id, &paths, form::form(format, output.as_deref())?, &limits.limits())?;
            deliver(output.as_deref(), &text.0).map(|()| text.1)
        }
        Command::Repair { id, paths, certificates, output, limits } => {
            let text = repair::run(&id, &paths, certificates.as_deref(), &limits.limits())?;
            deliver(output.as_deref(), &text.0).map(|()| text.1)
        }
        Command::Eval(flags) => eval::run(&flags),
        Command::Worksheet(flags) => worksheet::run(&flags),
        Command::Restitution(flags) => restitution::run(&flags),
        Command::Referee(flags) => referee::run(&flags),
        #[cfg(feature = "plot")]
        Command::Plot(flags) => plot::run(&flags),
        #[cfg(feature = "proptest")]
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
            let text = theorems::page(language, &ids, &from, &limits.limits())?;
            deliver(output.as_deref(), &text).map(|()| 0)
        }
        Command::Export { language, ids, from, theorems: false, proofs: false, list, output, limits: _ } => {
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

/// What there is help on besides the subcommands.
const TOPICS: [&str; 2] = ["language", "scene"];

/// The error for help, or a manual page, on something that is neither a subcommand nor one of `more`.
fn no_topic(command: &clap::Command, name: &str, more: &[&str]) -> Exit {
    let topics: Vec<&str> =
        command.get_subcommands().map(clap::Command::get_name).chain(more.iter().copied()).collect();
    let near = match crate::claim::diagnostic::nearest(name, topics.iter().copied()) {
        Some(near) => format!("did you mean {near}?"),
        None => format!("topics are {}", topics.join(", ")),
    };
    Exit::usage(format!("error: there is no help on {name}; {near}"))
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
            None => return Err(no_topic(&command, name, &TOPICS)),
        },
    }
    Ok(0)
}
