//! The command line: an adaptor of the table of operations.

mod arguments;
mod check;
mod clash;
mod command;
mod diagnostic;
mod ending;
mod explain;
mod files;
mod flags;
mod given;
mod read;
mod select;
mod shape;
mod source;
mod target;
mod value;
mod verify;
mod work;

use std::ffi::OsString;
use std::io::{self, IsTerminal, Write};
use std::process::ExitCode;

use clap::ArgMatches;

use crate::draw::glb;
use crate::kernel::coefficient::Coefficient;
use crate::report::{self, Notation};
use crate::symbolic::Symbol;
use crate::syntax::Style;
use crate::value::{Answer, Arguments, Finding, RepairFinding, Value};
use diagnostic::Problem;
use ending::Ending;
use given::Given;

/// Runs the program on its arguments (the first is the program's name) and
/// gives its exit status: 0 done and everything holds, 1 a question was
/// answered no, 2 the input cannot be used.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> ExitCode {
    let mut texts = Vec::new();
    for argument in arguments {
        match argument.into_string() {
            Ok(text) => texts.push(text),
            Err(argument) => {
                let message = format!("the argument {} is not valid UTF-8", argument.to_string_lossy());
                return Problem::plain(message).show(false);
            }
        }
    }
    let program = command::program();
    let matches = match program.clone().try_get_matches_from(arguments::separated(texts, &program)) {
        Ok(matches) => matches,
        Err(error) => {
            // A closed pipe ends quietly, here as everywhere.
            let _ = error.print();
            return ExitCode::from(u8::try_from(error.exit_code()).unwrap_or(2));
        }
    };
    let Some((verb, matches)) = matches.subcommand() else { return ExitCode::from(2) };
    match carry_out(verb, matches) {
        Ok(ending) => ending.into(),
        Err(problem) => problem.show(is_coloured(matches, &io::stderr())),
    }
}

/// Whether what goes to a stream is coloured.
fn is_coloured(matches: &ArgMatches, stream: &impl IsTerminal) -> bool {
    match matches.try_get_one::<String>("color").ok().flatten().map(String::as_str) {
        Some("always") => true,
        Some("never") => false,
        _ => stream.is_terminal() && std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty()),
    }
}

/// Carries out a command.
fn carry_out(verb: &str, matches: &ArgMatches) -> Result<Ending, Problem> {
    match verb {
        "check" => check::check(matches, is_coloured(matches, &io::stdout())),
        "explain" => {
            print(explain::explain(matches)?.as_bytes())?;
            Ok(Ending::Fine)
        }
        "batch" => {
            crate::batch::run(io::stdin().lock(), io::BufWriter::with_capacity(1 << 16, io::stdout().lock())).map_err(Problem::output)?;
            Ok(Ending::Fine)
        }
        "completions" => {
            let mut script = Vec::new();
            if let Some(&shell) = matches.get_one::<clap_complete::Shell>("shell") {
                clap_complete::generate(shell, &mut command::program(), "casteljau", &mut script);
            }
            print(&script)?;
            Ok(Ending::Fine)
        }
        "work" => {
            print(work::work(matches)?.as_bytes())?;
            Ok(Ending::Fine)
        }
        "exercise" => {
            print(work::exercise(matches)?.as_bytes())?;
            Ok(Ending::Fine)
        }
        "verify" => verify::verify(matches, is_coloured(matches, &io::stdout())),
        _ => operate(verb, matches).map(Ending::of_answer),
    }
}

fn operate(verb: &str, matches: &ArgMatches) -> Result<bool, Problem> {
    refuse_decimals(matches)?;
    if let Some(path) = flags::text_of(matches, "output") {
        writable(verb, path)?;
    }
    let mut notes = Vec::new();
    // A gallery is of nothing in particular.
    let given = if flags::is_given(matches, "gallery") { None } else { Given::of(verb, matches, "input", &mut notes)? };
    let other = Given::of(verb, matches, "other", &mut notes)?;
    if let (Some(weight), Some(Given::Points(_) | Given::File(_))) = (flags::text_of(matches, "weight"), &given) {
        return Err(Problem::plain(format!("--weight {weight} goes with an equation; control points have a weight each, as in (1,1):2")));
    }
    let weighted = given.as_ref().is_some_and(Given::is_weighted) || flags::is_given(matches, "weight");
    let selection = select::select(verb, given.as_ref(), other.as_ref(), weighted, matches)?;
    let operation = selection.operation;
    let arguments = read::arguments(&selection, given, other, matches, &mut notes)?;
    if !matches.get_flag("quiet") {
        notes.iter().for_each(|note| tell(note));
    }
    if matches.get_count("verbose") > 0 {
        tell(&format!("this is the operation {}", operation.name));
    }
    match arguments.numeric() {
        Ok(arguments) => finish(matches, &arguments, &operation.on_numbers(&arguments)?),
        Err((symbol, name)) => match operation.on_symbols(&arguments) {
            Some(answer) => finish(matches, &arguments, &answer?),
            None => Err(read::needs_numbers(operation, symbol, name)),
        },
    }
}

/// A word to the user beside the answer. Unlike the standard macro this does
/// not panic where nobody reads standard error any more.
fn tell(note: &str) {
    let _ = writeln!(io::stderr(), "note: {note}");
}

/// Refuses a file whose ending says nothing about what to write into it.
fn writable(verb: &str, path: &str) -> Result<(), Problem> {
    if verb == "join" {
        if path.ends_with(".json") {
            return Ok(());
        }
        return Err(Problem::plain(format!("the repaired piece is written to a .json shape file: `{path}` ends otherwise")));
    }
    if [".svg", ".obj", ".glb"].iter().any(|ending| path.ends_with(ending)) {
        return Ok(());
    }
    Err(Problem::plain(format!("pictures are written as .svg, meshes as .obj or .glb: `{path}` ends in none of these")))
}

fn finish<C: Coefficient>(matches: &ArgMatches, arguments: &Arguments<C>, answer: &Answer<C>) -> Result<bool, Problem> {
    let Some(path) = flags::text_of(matches, "output") else {
        print(render(matches, arguments, answer)?.as_bytes())?;
        return Ok(answer.holds.unwrap_or(true));
    };
    if let Some(Finding::Join(join)) = &answer.finding {
        // The shape goes into the file, what was done to it is printed.
        let Some(RepairFinding { repair, rational, .. }) = &join.repair else {
            return Err(Problem::plain("--output is for the piece that --repair changes"));
        };
        let shape = crate::model::shape_text(&repair.piece, *rational).map_err(|fault| Problem::plain(fault.message))?;
        target::replace(std::path::Path::new(path), shape.as_bytes())?;
        print(render(matches, arguments, answer)?.as_bytes())?;
        return Ok(answer.holds.unwrap_or(true));
    }
    let document = match answer.fields.as_slice() {
        [(_, Value::Mesh(mesh))] if path.ends_with(".glb") => glb(mesh),
        [(_, Value::Document(_))] if !path.ends_with(".svg") => {
            return Err(Problem::plain("meshes are made of surfaces; this is a curve").with_help("pictures of curves are written as .svg"));
        }
        _ => render(matches, arguments, answer)?.into_bytes(),
    };
    target::replace(std::path::Path::new(path), &document)?;
    Ok(answer.holds.unwrap_or(true))
}

/// Decimals are for readers of text.
fn refuse_decimals(matches: &ArgMatches) -> Result<(), Problem> {
    let format = matches.get_one::<String>("format").map_or("text", String::as_str);
    if matches.get_one::<u16>("decimal").is_some() && format != "text" {
        return Err(Problem::plain(format!("--decimal adds to text; --format {format} is exact")));
    }
    Ok(())
}

fn render<C: Coefficient>(matches: &ArgMatches, arguments: &Arguments<C>, answer: &Answer<C>) -> Result<String, Problem> {
    let notation = |style| Notation {
        variable: arguments.variable(),
        variables: arguments.variables(),
        decimals: matches.get_one::<u16>("decimal").map(|&places| usize::from(places)),
        expand: matches.try_get_one::<bool>("expand").ok().flatten().copied().unwrap_or(false),
        ..Notation::new(style)
    };
    let text = match matches.get_one::<String>("format").map(String::as_str) {
        Some("json") => return Ok(format!("{}\n", report::json::output(answer)?)),
        Some("latex") => report::latex(arguments, answer, &notation(Style::Latex)),
        Some("mathematica") => report::mathematica(answer, &notation(Style::Mathematica)),
        _ => report::text(arguments, answer, &notation(Style::Text)),
    };
    text.map_err(Problem::plain)
}

fn print(bytes: &[u8]) -> Result<(), Problem> {
    let mut output = io::stdout().lock();
    output.write_all(bytes).and_then(|()| output.flush()).map_err(Problem::output)
}

/// The letters of `--vars`.
fn variables(matches: &ArgMatches) -> Result<Option<Vec<Symbol>>, Problem> {
    let Some(text) = matches.try_get_one::<String>("vars").ok().flatten() else { return Ok(None) };
    crate::syntax::parse_variables(text).map(Some).map_err(|error| Problem::syntax("--vars", text, error))
}
