//! Which operation a command means.

use clap::ArgMatches;

use super::command::parameters;
use super::diagnostic::Problem;
use super::flags::{is_given, text_of};
use super::given::{Given, domain_of, frame_of};
use crate::affine::Frame;
use crate::ops::{Operation, Parameter};
use crate::symbolic::Polynomial;
use crate::syntax::Variables;
use crate::value::Domain;

/// The operation that a command means, by what it is given, and whether it
/// decided by itself how to read a surface.
pub(super) struct Selection {
    pub(super) operation: &'static Operation,
    pub(super) domain: Domain,
    pub(super) chose_reading: bool,
}

pub(super) fn select(
    verb: &str,
    given: Option<&Given>,
    other: Option<&Given>,
    weighted: bool,
    matches: &ArgMatches,
) -> Result<Selection, Problem> {
    let (mut domain, chose_reading) = domain(verb, given, matches)?;
    if let (true, Some(other @ (Given::Points(_) | Given::File(_)))) = (chose_reading, other) {
        // An equation is read as what it is compared with or multiplied by.
        domain = other.domain(None, false, false);
    }
    refuse_contradictions(verb, domain, given, matches)?;
    let here = |operation: &&'static Operation| operation.domains.contains(&domain);
    if !Operation::of_verb(verb).any(|operation| here(&operation)) {
        return Err(unfit(verb, domain, given));
    }
    let chosen = Operation::of_verb(verb).filter(here).find(|operation| is_selected(operation, weighted, matches));
    let plain = || Operation::of_verb(verb).filter(here).find(|operation| operation.selected_by.is_empty());
    let operation = chosen.or_else(plain).ok_or_else(|| Problem::plain(format!("there is no command `{verb}`")))?;
    for parameter in parameters(verb) {
        let fits = operation.parameters.iter().any(|own| own.flag == parameter.flag);
        if !parameter.flag.is_empty() && is_given(matches, parameter.flag) && !fits {
            return Err(misplaced(verb, operation, parameter, domain, matches));
        }
    }
    if weighted && operation.parameter("weights").is_none() && operation.parameter("weight").is_none() {
        return Err(Problem::plain(format!("`{verb}` takes polynomial shapes here, without weights"))
            .with_help("weights that are all equal can be left out; `eval`, `split`, `reframe` and `equation` take others"));
    }
    Ok(Selection { operation, domain, chose_reading })
}

/// Refuses a degree in one reading for a shape in the other one.
fn refuse_contradictions(verb: &str, domain: Domain, given: Option<&Given>, matches: &ArgMatches) -> Result<(), Problem> {
    let (degree, bidegree) = (is_given(matches, "degree"), is_given(matches, "bidegree"));
    if matches!(verb, "homogenize") || is_given(matches, "both") {
        return Ok(());
    }
    if degree && bidegree {
        return Err(Problem::plain("--degree and --bidegree exclude each other: a surface is read in one of two ways")
            .with_help("`casteljau polar --both` shows them side by side"));
    }
    match domain {
        Domain::Rectangle if degree && given.is_some() => {
            Err(Problem::plain("--degree is that of a curve or a triangle; a rectangle has a --bidegree P,Q"))
        }
        Domain::Curve | Domain::Triangle if bidegree => {
            Err(Problem::plain(format!("--bidegree is that of a rectangle, and this is a {}", domain.name())))
        }
        _ => Ok(()),
    }
}

/// Whether one of the arguments is there that make a command mean an operation.
fn is_selected(operation: &Operation, weighted: bool, matches: &ArgMatches) -> bool {
    operation.selected_by.iter().any(|selector| match selector.split_once('=') {
        // The ending of a file says what is to be written into it.
        Some((flag, ending)) if ending.starts_with('.') => text_of(matches, flag).is_some_and(|path| path.ends_with(ending)),
        Some((flag, word)) => is_given(matches, flag) && text_of(matches, flag).is_some_and(|given| given == word),
        None if *selector == "weights" => weighted,
        None => operation.parameter(selector).is_some_and(|parameter| is_given(matches, parameter.flag)),
    })
}

/// A flag that another operation of the command takes.
fn misplaced(verb: &str, operation: &Operation, parameter: &Parameter, domain: Domain, matches: &ArgMatches) -> Problem {
    let takes = |other: &&Operation| other.parameters.iter().any(|own| own.flag == parameter.flag);
    let others = || Operation::of_verb(verb).filter(takes);
    if !others().any(|other| other.domains.contains(&domain)) {
        let kinds: Vec<&str> = others().flat_map(|other| other.domains).map(|domain| domain.name()).collect();
        let mut distinct = kinds.clone();
        distinct.dedup();
        return Problem::plain(format!("--{} goes with a {}, and this is a {}", parameter.flag, distinct.join(" or a "), domain.name()));
    }
    let spelled = |operation: &Operation, name: &str| match name.split_once('=') {
        Some((flag, word)) => format!("--{flag} {word}"),
        None => operation.parameter(name).map_or_else(|| format!("`{name}`"), |parameter| format!("--{}", parameter.flag)),
    };
    let mut wanted: Vec<String> = others()
        .filter(|other| other.domains.contains(&domain))
        .flat_map(|other| other.selected_by.iter().filter(|name| **name != "weights").map(|name| spelled(other, name)))
        .collect();
    wanted.dedup();
    let given = operation.selected_by.iter().find(|name| operation.parameter(name).is_some_and(|own| is_given(matches, own.flag)));
    Problem::plain(match given {
        Some(flag) => format!("--{} does not go with {}", parameter.flag, spelled(operation, flag)),
        None if wanted.is_empty() => format!("--{} does not go with this kind of input", parameter.flag),
        None => format!("--{} goes with {} only", parameter.flag, wanted.join(" or ")),
    })
}

/// The command takes other kinds of shapes.
fn unfit(verb: &str, domain: Domain, given: Option<&Given>) -> Problem {
    let mut kinds: Vec<&str> = Vec::new();
    for operation in Operation::of_verb(verb) {
        for domain in operation.domains {
            if !kinds.contains(&domain.name()) {
                kinds.push(domain.name());
            }
        }
    }
    let found = match (given, domain) {
        (Some(Given::Equation(map)), _) => match map.variables {
            Variables::Surface(first, second) => format!("this was read as a surface in {first} and {second}"),
            Variables::Curve(variable) => format!("this was read as a curve in {variable}"),
        },
        (_, domain) => format!("this is a {}", domain.name()),
    };
    let problem = Problem::plain(format!("`{verb}` takes a {}; {found}", kinds.join(" or a ")));
    match given {
        Some(Given::Equation(map)) => match map.variables {
            Variables::Surface(first, _) => {
                problem.with_help(format!("say which letter is the parameter of the curve, as in --vars {first}"))
            }
            Variables::Curve(_) => problem.with_help("say which letters are the parameters of the surface, as in --vars u,v"),
        },
        _ => problem,
    }
}

/// What kind of shape a command is about.
fn domain(verb: &str, given: Option<&Given>, matches: &ArgMatches) -> Result<(Domain, bool), Problem> {
    let frame: Option<Frame<Polynomial>> = text_of(matches, "over").map(|text| frame_of(text, "--over")).transpose()?;
    let only = |domain: Domain| Operation::of_verb(verb).all(|operation| operation.domains == [domain]);
    if let Some(domain) = [Domain::Triangle, Domain::Rectangle].into_iter().find(|&domain| only(domain)) {
        // A command about one kind of surface; a curve is refused, unless it says nothing.
        return Ok((given.map_or(domain, |given| reread(given, domain, frame.as_ref())), false));
    }
    let word = |flag: &str, word: &str| text_of(matches, flag).is_some_and(|given| given == word);
    // What only one of the readings has.
    let says_rectangle = is_given(matches, "bidegree")
        || is_given(matches, "method")
        || is_given(matches, "first")
        || is_given(matches, "diagonal")
        || (verb == "segment" && (is_given(matches, "u") || is_given(matches, "v")))
        || ["u0", "u1", "v0", "v1"].iter().any(|edge| word("edge", edge))
        || (verb == "polar" && text_of(matches, "at").is_some_and(|text| outer_semicolon(text)));
    let says_total = is_given(matches, "both") || (is_given(matches, "degree") && !is_given(matches, "bidegree"));
    // A conversion starts from the kind it does not lead to.
    let converted = match (verb, text_of(matches, "to")) {
        ("convert", _) if is_given(matches, "bidegree") => Some(Domain::Rectangle),
        ("convert", _) if is_given(matches, "degree") => Some(Domain::Triangle),
        ("convert", Some(text)) => match domain_of(&frame_of(text, "--to")?) {
            Domain::Triangle => Some(Domain::Rectangle),
            Domain::Rectangle => Some(Domain::Triangle),
            Domain::Curve => None,
        },
        _ => None,
    };
    Ok(match given {
        None => (frame.as_ref().map_or(if says_rectangle { Domain::Rectangle } else { Domain::Curve }, domain_of), false),
        Some(Given::Equation(map)) if matches!(map.variables, Variables::Surface(..)) => match converted {
            Some(domain) => (domain, false),
            None => {
                let found = given.map_or(Domain::Triangle, |given| given.domain(frame.as_ref(), says_rectangle, says_total));
                (found, frame.is_none() && !says_rectangle && !says_total)
            }
        },
        Some(given) => (given.domain(frame.as_ref(), says_rectangle, says_total), false),
    })
}

/// The kind of a shape for a command about one kind of surfaces: rows that do
/// not shrink are no triangle, whatever they are asked to be.
fn reread(given: &Given, wanted: Domain, frame: Option<&Frame<Polynomial>>) -> Domain {
    match given {
        Given::Equation(map) if matches!(map.variables, Variables::Surface(..)) => wanted,
        other => match other.domain(frame, wanted == Domain::Rectangle, wanted == Domain::Triangle) {
            Domain::Curve if matches!(other, Given::Equation(_)) => Domain::Curve,
            found => found,
        },
    }
}

/// Whether a semicolon stands outside all square brackets: the two groups of a bidegree form.
fn outer_semicolon(text: &str) -> bool {
    let mut depth = 0;
    text.chars().any(|letter| {
        match letter {
            '[' => depth += 1,
            ']' => depth -= 1,
            _ => {}
        }
        letter == ';' && depth == 0
    })
}
