//! The commands and their flags, made from the table of operations.

use clap::{Arg, ArgAction, Command, value_parser};

use crate::control::MAX_PATCH_DEPTH;
use crate::exact::MAX_DIGITS;
use crate::ops::limits::{MAX_NUMBERS, MAX_STEPS};
use crate::ops::{Kind, Operation, Parameter, about, operations};
use crate::segment::Segment;
use crate::syntax::limits::{MAX_DEGREE, MAX_INPUT_BYTES, MAX_NESTING, MAX_TERMS};

/// The names of the commands that carry out operations, in the order of the table.
pub(super) fn verbs() -> Vec<&'static str> {
    let mut verbs: Vec<&str> = Vec::new();
    for operation in operations() {
        if !operation.verb.is_empty() && !verbs.contains(&operation.verb) {
            verbs.push(operation.verb);
        }
    }
    verbs
}

/// The parameters of all operations of a command, each once. One that is
/// required by only some of them is required by the operation, not by the command.
pub(super) fn parameters(verb: &str) -> Vec<&'static Parameter> {
    let mut parameters: Vec<&Parameter> = Vec::new();
    for parameter in Operation::of_verb(verb).flat_map(|operation| operation.parameters) {
        let is_known =
            |known: &&Parameter| if parameter.flag.is_empty() { known.name == parameter.name } else { known.flag == parameter.flag };
        if !parameters.iter().any(is_known) {
            parameters.push(parameter);
        }
    }
    parameters
}

/// The whole program.
pub(super) fn program() -> Command {
    let limits = format!(
        "Limits: {MAX_INPUT_BYTES} bytes of input, {MAX_DIGITS} digits a number, degree {MAX_DEGREE}, {MAX_TERMS} terms,\n\
         nesting {MAX_NESTING}, depth of subdivision {} for curves and {MAX_PATCH_DEPTH} for patches; {MAX_NUMBERS} numbers\n\
         an answer, and {MAX_STEPS} steps on machine words as estimated before the work.\n\
         Exit status: 0 done, 1 the answer is no, 2 the input cannot be used.",
        Segment::<crate::exact::Rational>::MAX_DEPTH
    );
    let mut program = Command::new("casteljau")
        .version(clap::crate_version!())
        .about("Exact polar forms, control points and subdivision of polynomial curves and surfaces")
        .after_help(limits)
        .subcommand_required(true)
        .arg_required_else_help(true)
        .infer_long_args(false);
    for verb in verbs() {
        program = program.subcommand(subcommand(verb));
    }
    program
        .subcommand(super::check::command())
        .subcommand(super::explain::command())
        .subcommand(super::verify::command())
        .subcommand(super::work::work_command())
        .subcommand(super::work::exercise_command())
        .subcommand(
            Command::new("batch")
                .about("Answer requests on standard input, one JSON object a line")
                .after_help("Example: echo '{\"id\": 1, \"op\": \"sigma\", \"input\": {\"values\": [\"1\", \"2\"]}}' | casteljau batch")
                .arg(color()),
        )
        .subcommand(
            Command::new("completions")
                .about("Print a completion script for a shell")
                .after_help("Example: casteljau completions bash > /etc/bash_completion.d/casteljau")
                .arg(Arg::new("shell").required(true).value_parser(value_parser!(clap_complete::Shell)).value_name("SHELL"))
                .arg(color()),
        )
}

fn subcommand(verb: &'static str) -> Command {
    let operations: Vec<&Operation> = Operation::of_verb(verb).collect();
    let examples: Vec<&str> = operations.iter().map(|operation| operation.example).collect();
    let mut command = Command::new(verb).about(about(verb)).after_help(format!("Examples:\n  {}", examples.join("\n  ")));
    let parameters = parameters(verb);
    let positional = |names: &[&str]| parameters.iter().any(|parameter| parameter.flag.is_empty() && names.contains(&parameter.name));
    if positional(&["curve", "surface", "points", "values"]) {
        let names = if positional(&["values"]) {
            "NUMBERS"
        } else if !positional(&["points"]) {
            "EXPR"
        } else if positional(&["curve", "surface"]) {
            "EXPR|POINTS"
        } else {
            "POINTS"
        };
        let help = if names == "NUMBERS" {
            "The numbers themselves, or `-` for standard input"
        } else {
            "The input itself, `-` for standard input, or the path of a .json shape file"
        };
        command = command
            .arg(Arg::new("input").value_name(names).help(help))
            .arg(Arg::new("file").long("input").value_name("FILE").help("Read the input from a file"));
        if names.starts_with("EXPR") {
            let letters = "The letters of the parameters: one of a curve (t unless said), two of a surface";
            command = command.arg(Arg::new("vars").long("vars").value_name("LETTERS").help(letters));
        }
    }
    if positional(&["other_curve", "other_surface", "other_points"]) {
        command = command.arg(Arg::new("other").value_name("OTHER").help(
            if positional(&["other_points"]) && positional(&["other_curve", "other_surface"]) {
                "The second curve or surface, as an equation, as points, or the path of a .json shape file"
            } else if positional(&["other_points"]) {
                "The control points of the second curve or surface, or the path of a .json shape file"
            } else {
                "The second curve or surface, as an equation, or the path of a .json shape file"
            },
        ));
    }
    for parameter in parameters.iter().filter(|parameter| !parameter.flag.is_empty()) {
        command = command.arg(flag(parameter));
    }
    if verb == "polar" {
        command =
            command.arg(Arg::new("expand").long("expand").action(ArgAction::SetTrue).help("Write out a polar form of more than 64 terms"));
    }
    if verb == "plot" {
        command = command.arg(
            Arg::new("output")
                .short('o')
                .long("output")
                .value_name("FILE")
                .help("Write the picture to a .svg file, or the mesh of a surface to .obj or .glb"),
        );
    }
    if parameters.iter().any(|parameter| parameter.flag == "repair") {
        command = command.arg(
            Arg::new("output").short('o').long("output").value_name("FILE").help("Also write the repaired piece to a .json shape file"),
        );
    }
    command
        .arg(
            Arg::new("format")
                .long("format")
                .value_parser(["text", "json", "latex", "mathematica"])
                .default_value("text")
                .help("How to print the answer"),
        )
        .arg(
            Arg::new("decimal")
                .long("decimal")
                .value_name("N")
                .value_parser(value_parser!(u16).range(0..=1000))
                .help("Add decimals, marked ≈, to numbers that are not whole"),
        )
        .arg(Arg::new("quiet").short('q').long("quiet").action(ArgAction::SetTrue).help("No notes on standard error"))
        .arg(Arg::new("verbose").short('v').long("verbose").action(ArgAction::Count).help("More notes on standard error"))
        .arg(color())
}

pub(super) fn color() -> Arg {
    Arg::new("color").long("color").value_parser(["auto", "always", "never"]).default_value("auto").help("Colours in messages")
}

fn flag(parameter: &'static Parameter) -> Arg {
    let argument = Arg::new(parameter.flag).long(parameter.flag).help(parameter.help);
    let name = match parameter.kind {
        Kind::Flag => return argument.action(ArgAction::SetTrue),
        Kind::Frame | Kind::FrameOfPoints => "FRAME",
        Kind::Number | Kind::Place | Kind::FirstParameter | Kind::SecondParameter => "NUMBER",
        Kind::Count => "N",
        Kind::Counts => "N,N",
        Kind::Arguments | Kind::HomogeneousArguments | Kind::FirstArguments(_) | Kind::SecondArguments(_) | Kind::PlaneArguments(_) => {
            "ARGUMENTS"
        }
        Kind::Weight => "EXPR",
        Kind::Word(_) => "WORD",
        Kind::Claim => "FORM",
        Kind::Map => "IMAGE",
        Kind::Plane => "EQUATION",
        Kind::Point => "POINT",
        Kind::Shape => "OTHER",
        Kind::Piece
        | Kind::Edge
        | Kind::Curve
        | Kind::Surface
        | Kind::AnySurface
        | Kind::Terms
        | Kind::Points
        | Kind::Weights
        | Kind::Numbers => "VALUE",
    };
    argument.value_name(name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::value::Domain;

    #[test]
    fn the_commands_are_well_formed() {
        program().debug_assert();
    }

    #[test]
    fn every_command_has_one_operation_a_kind_of_shape_without_a_selecting_flag() {
        for verb in verbs() {
            for domain in [Domain::Curve, Domain::Triangle, Domain::Rectangle] {
                let here: Vec<_> = Operation::of_verb(verb).filter(|operation| operation.domains.contains(&domain)).collect();
                let plain = here.iter().filter(|operation| operation.selected_by.is_empty()).count();
                assert_eq!(plain, usize::from(!here.is_empty()), "{verb}");
            }
        }
    }
}
