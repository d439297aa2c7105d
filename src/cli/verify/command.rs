//! The command line of `verify`.

use clap::{Arg, ArgAction, Command};

use crate::worksheet::MAX_WORKSHEET_BYTES;

pub(in crate::cli) fn command() -> Command {
    Command::new("verify")
        .about("Prove or refute every claim in worksheets: made for CI")
        .after_help(format!(
            "Examples:\n  casteljau verify notes.md chapters/\n  casteljau verify --list examples/chapter18.md\n  \
             casteljau verify --format json notes.md\n\n\
             The language is in docs/worksheets.md. Exit status: 0 every claim is proved, 1 one is refuted, 2 one cannot be\n\
             decided or read, or there is none. Limit: {MAX_WORKSHEET_BYTES} bytes a worksheet."
        ))
        .arg(
            Arg::new("paths")
                .value_name("PATH")
                .num_args(1..)
                .required(true)
                .help("Worksheets (Markdown, or statements alone in .cj), folders of them, or `-` for standard input"),
        )
        .arg(Arg::new("list").long("list").action(ArgAction::SetTrue).help("Also print what was proved"))
        .arg(
            Arg::new("format")
                .long("format")
                .value_name("FORMAT")
                .value_parser(["text", "json", "sarif", "junit", "github"])
                .default_value("text")
                .help("How to print the verdicts"),
        )
        .arg(Arg::new("output").short('o').long("output").value_name("FILE").help("Write the verdicts to a file"))
        .arg(
            Arg::new("html")
                .long("html")
                .value_name("FOLDER")
                .help("Also write the worksheets as pages, with formulas, verdicts and pictures"),
        )
        .arg(Arg::new("allow-empty").long("allow-empty").action(ArgAction::SetTrue).help("Exit with 0 where there are no claims"))
        .arg(Arg::new("quiet").short('q').long("quiet").action(ArgAction::SetTrue).help("No warnings and no summary"))
        .arg(crate::cli::command::color())
}
