//! The program: everything is in the library's command line.

use std::process::ExitCode;

fn main() -> ExitCode {
    casteljau::cli::run(std::env::args_os())
}
