//! The `carom` command.
#![forbid(unsafe_code)]

mod cli;

// The rooms, under the names that they have in the library.
use carom::{
    certificate, chain, claim, export, judge, kernel, latex, number, property, prove, referee, refute, report, scene,
    table, table_checker,
};

/// Whoever embeds the library chooses an allocator; the program has one that is made for many small objects on several threads.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

fn main() -> std::process::ExitCode {
    cli::run()
}
