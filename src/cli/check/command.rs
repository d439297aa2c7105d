//! The flags of `check`.

use clap::{Arg, ArgAction, Command, value_parser};

use crate::audit::{MAX_DEGREE, MAX_PATCH_DEGREE};
use crate::model::Format;

/// The command.
pub(in crate::cli) fn command() -> Command {
    let text = |name: &'static str, value: &'static str, help: &'static str| Arg::new(name).long(name).value_name(value).help(help);
    Command::new("check")
        .about("Check every join of the curves and patches in files: made for CI")
        .after_help(format!(
            "Examples:\n  \
             casteljau check teapot.patches.txt\n  \
             casteljau check --require G1 --tolerance 0.01deg models/\n  \
             casteljau check --tolerance rounding Font.ufo/glyphs\n\n\
             Formats, by ending or content: {} (see docs/check.md). A font node that is flagged smooth is held to G1;\n\
             without --require other joins are reported and fail nothing. Settings are read from casteljau.toml.\n\n\
             Exit status: 0 all hold, 1 one does not, 2 a file cannot be used or there was nothing to check.\n\
             Limits: degree {MAX_DEGREE}, of patches {MAX_PATCH_DEGREE}; 1 GiB a file.",
            Format::ALL.map(Format::name).join(", ")
        ))
        .arg(Arg::new("paths").value_name("PATH").num_args(1..).required(true).help("Files and folders; `-` for standard input"))
        .arg(text("require", "ORDER", "What every join must have").value_parser(["C0", "C1", "C2", "G1", "G2", "none"]))
        .arg(
            text("tolerance", "BOUND", "What joins may be off by: 0.01deg, 0.5unit, rounding, or several with commas between")
                .action(ArgAction::Append),
        )
        .arg(text("snap", "UNITS", "Match ends of pieces up to this distance"))
        .arg(text("read-as", "FORMAT", "Read all files as this format").value_parser(Format::ALL.map(Format::name)))
        .arg(
            text("format", "FORMAT", "How to print the findings")
                .value_parser(["text", "json", "sarif", "junit", "github"])
                .default_value("text"),
        )
        .arg(Arg::new("output").short('o').long("output").value_name("FILE").help("Write the findings to a file"))
        .arg(text("plot", "FILE.svg", "Draw the pieces with the findings marked"))
        .arg(text("config", "FILE", "Read the settings from this file, not from casteljau.toml").conflicts_with("no-config"))
        .arg(Arg::new("no-config").long("no-config").action(ArgAction::SetTrue).help("Read no settings"))
        .arg(text("baseline", "FILE", "Findings that are known and fail nothing"))
        .arg(text("write-baseline", "FILE", "Write the violations to a baseline, and fail nothing").conflicts_with("baseline"))
        .arg(Arg::new("allow-empty").long("allow-empty").action(ArgAction::SetTrue).help("Exit with 0 where there is nothing to check"))
        .arg(text("jobs", "N", "How many threads to use").value_parser(value_parser!(u16).range(1..=1024)))
        .arg(Arg::new("quiet").short('q').long("quiet").action(ArgAction::SetTrue).help("No notes and no progress on standard error"))
        .arg(Arg::new("verbose").short('v').long("verbose").action(ArgAction::Count).help("Degenerate joins and what was passed over too"))
        .arg(crate::cli::command::color())
}
