//! The `carom` command.
#![forbid(unsafe_code)]

fn main() -> std::process::ExitCode {
    carom::cli::run()
}
