//! `work` and `exercise`: worked solutions and exercises, as worksheets.

use clap::{Arg, ArgAction, ArgMatches, Command, value_parser};

use super::diagnostic::Problem;
use super::flags::text_of;
use super::given::frame_of;
use super::source::Source;
use super::value::{count, counts};
use super::variables;
use crate::syntax;
use crate::worksheet::{self, Exercise, MAX_EXERCISES, MAX_WORK_DEGREE, Task};

/// The command `work`.
pub(super) fn work_command() -> Command {
    Command::new("work")
        .about("A worked solution as a worksheet: polar form, control points, de Casteljau's algorithm, every line a claim")
        .after_help(format!(
            "Examples:\n  casteljau work '(3/4 t^2 - 3/2 t - 9/4, 3/4 t^3 - 3/2 t^2 - 9/4 t)' --over -1..3 --at 1/2 > cubic.md\n  \
             casteljau work 'u v' --over '0..1, 0..1' --at 1/2,1/3\n\n\
             `casteljau verify` proves every line of it. Limit: polar degree {MAX_WORK_DEGREE}."
        ))
        .arg(Arg::new("input").value_name("EXPR").help("The equation, such as '(t, t^2)' or 'z = x y'; `-` for standard input"))
        .arg(Arg::new("file").long("input").value_name("FILE").help("Read the equation from a file"))
        .arg(
            Arg::new("vars")
                .long("vars")
                .value_name("LETTERS")
                .help("The letters of the parameters: one of a curve (t unless said), two of a surface"),
        )
        .arg(Arg::new("over").long("over").value_name("FRAME").help("Also the control points over this frame"))
        .arg(
            Arg::new("at")
                .long("at")
                .value_name("NUMBER")
                .help("Also de Casteljau's algorithm at this parameter; two, such as 1/3,1/4, on a surface"),
        )
        .arg(Arg::new("degree").long("degree").value_name("N").help("The polar degree, if it is to be higher than the degree"))
        .arg(Arg::new("bidegree").long("bidegree").value_name("N,N").help("Read a surface variable by variable, by these degrees"))
        .arg(super::command::color())
}

/// The text of `work`.
pub(super) fn work(matches: &ArgMatches) -> Result<String, Problem> {
    let source = Source::of(matches, "input")?;
    let text = source.expression()?;
    let map = syntax::parse_map(text, variables(matches)?.as_deref()).map_err(|error| Problem::syntax(&source.name, text, error))?;
    let at = text_of(matches, "at").map(|text| {
        let bare = text.trim().strip_prefix('(').and_then(|rest| rest.strip_suffix(')')).unwrap_or(text);
        syntax::parse_scalars(bare).map_err(|error| Problem::syntax("--at", bare, error))
    });
    let frame = text_of(matches, "over").map(|text| frame_of(text, "--over")).transpose()?;
    let at = at.transpose()?;
    if at.is_some() && frame.is_none() {
        return Err(Problem::plain("--at needs the frame of the control points").with_help("say it with --over, as in --over 0..1"));
    }
    let bidegree = match text_of(matches, "bidegree").map(|text| counts("--bidegree", text)).transpose()? {
        None => None,
        Some(list) => match list.as_slice() {
            &[p, q] => Some((p, q)),
            other => return Err(Problem::plain(format!("--bidegree takes two whole numbers, found {}", other.len()))),
        },
    };
    let degree = text_of(matches, "degree").map(|text| count("--degree", text)).transpose()?;
    Ok(worksheet::work(&Task { map, degree, bidegree, frame, at })?)
}

/// The command `exercise`.
pub(super) fn exercise_command() -> Command {
    Command::new("exercise")
        .about("Exercises with pleasant numbers, and apart from them their worked solutions, as worksheets")
        .after_help(
            "Examples:\n  casteljau exercise polar --seed 7 --count 10 > exercises.md\n  \
             casteljau exercise polar --seed 7 --count 10 --solutions > solutions.md\n\n\
             The same seed gives the same exercises. `casteljau verify solutions.md` proves every line of the solutions.",
        )
        .arg(Arg::new("kind").value_name("KIND").required(true).value_parser(Exercise::ALL.map(Exercise::name)).help("What is to be done"))
        .arg(
            Arg::new("seed")
                .long("seed")
                .value_name("N")
                .value_parser(value_parser!(u64))
                .default_value("1")
                .help("Where the numbers come from"),
        )
        .arg(
            Arg::new("count")
                .long("count")
                .value_name("N")
                .value_parser(value_parser!(u16).range(1..=i64::from(MAX_EXERCISES)))
                .default_value("1")
                .help("How many exercises"),
        )
        .arg(Arg::new("solutions").long("solutions").action(ArgAction::SetTrue).help("The worked solutions, not the exercises"))
        .arg(super::command::color())
}

/// The text of `exercise`.
pub(super) fn exercise(matches: &ArgMatches) -> Result<String, Problem> {
    let name = text_of(matches, "kind").map_or("", String::as_str);
    let kind = Exercise::ALL.into_iter().find(|kind| kind.name() == name).unwrap_or(Exercise::Polar);
    let seed = matches.get_one::<u64>("seed").copied().unwrap_or(1);
    let count = matches.get_one::<u16>("count").copied().unwrap_or(1);
    let made = worksheet::exercises(kind, seed, count)?;
    Ok(if matches.get_flag("solutions") { made.solutions } else { made.exercises })
}
