//! The arguments of an operation from the words of a command line.

use clap::ArgMatches;

use super::diagnostic::Problem;
use super::flags::{is_given, text_of};
use super::given::{Given, frame_of};
use super::select::Selection;
use super::source::Source;
use crate::affine::Frame;
use crate::ops::{Kind, Operation, Parameter, Run};
use crate::symbolic::{Polynomial, Symbol};
use crate::syntax::{self};
use crate::value::{Arguments, Domain, Value};

/// Why an operation on numbers refuses a symbolic parameter.
pub(super) fn needs_numbers(operation: &Operation, symbol: Symbol, name: &str) -> Problem {
    let place = match operation.parameter(name) {
        Some(parameter) if !parameter.flag.is_empty() => format!("--{}", parameter.flag),
        _ => "the input".to_owned(),
    };
    let problem = Problem::plain(format!("`{}` needs numbers, but {place} contains the symbolic parameter `{symbol}`", operation.verb));
    let on_symbols = Operation::of_verb(operation.verb).filter(|other| matches!(other.run, Run::Any(..)));
    match on_symbols.flat_map(|other| other.selected_by.iter().filter_map(|name| other.parameter(name))).next() {
        Some(parameter) => problem.with_help(format!("--{} takes symbolic parameters", parameter.flag)),
        None => problem,
    }
}

/// The names of the arguments that a shape becomes.
pub(super) struct Names {
    pub(super) curve: &'static str,
    pub(super) surface: &'static str,
    pub(super) points: &'static str,
    pub(super) weights: &'static str,
    pub(super) frame: &'static str,
}

pub(super) const FIRST: Names = Names { curve: "curve", surface: "surface", points: "points", weights: "weights", frame: "frame" };
const SECOND: Names =
    Names { curve: "other_curve", surface: "other_surface", points: "other_points", weights: "other_weights", frame: "other_frame" };

/// All arguments of an operation, and what the user should know about defaults.
pub(super) fn arguments(
    selection: &Selection,
    given: Option<Given>,
    other: Option<Given>,
    matches: &ArgMatches,
    notes: &mut Vec<String>,
) -> Result<Arguments<Polynomial>, Problem> {
    let Selection { operation, domain, chose_reading } = *selection;
    let mut reader = Reader { operation, domain, matches, arguments: Arguments::new(domain), notes, shape_frame: None };
    reader.letters(given.as_ref())?;
    if operation.parameter("values").is_some() {
        let source = Source::of(matches, "input")?;
        let text = source.expression()?;
        let values = syntax::parse_scalars(text).map_err(|error| Problem::syntax(&source.name, text, error))?;
        reader.arguments.insert("values", Value::Numbers(values));
    }
    if let Some(given) = given {
        reader.shape(given, &FIRST)?;
    }
    if let Some(other) = other {
        // Two pieces that are compared may be of different kinds, each over a frame of its own.
        let frame = text_of(matches, "other-over").map(|text| frame_of(text, "--other-over")).transpose()?;
        let own = match &other {
            Given::Equation(_) => domain,
            shape => shape.domain(frame.as_ref(), false, domain == Domain::Triangle),
        };
        let alike = (own == Domain::Curve) == (domain == Domain::Curve);
        if own != domain && alike && frame.is_none() && operation.parameter(SECOND.frame).is_some() {
            reader.arguments.insert(SECOND.frame, Value::Frame(own.default_frame()));
        }
        reader.domain = if alike { own } else { domain };
        reader.shape(other, &SECOND)?;
        reader.domain = domain;
    }
    for parameter in operation.parameters.iter().filter(|parameter| !parameter.flag.is_empty()) {
        reader.flag(parameter)?;
    }
    reader.default_frame()?;
    reader.refuse_clashes()?;
    if chose_reading {
        reader.tell_reading();
    }
    Ok(reader.arguments)
}

pub(super) struct Reader<'a> {
    pub(super) operation: &'a Operation,
    pub(super) domain: Domain,
    pub(super) matches: &'a ArgMatches,
    pub(super) arguments: Arguments<Polynomial>,
    notes: &'a mut Vec<String>,
    /// The frame that a shape file brought along.
    pub(super) shape_frame: Option<Frame<Polynomial>>,
}

impl Reader<'_> {
    fn flag(&mut self, parameter: &'static Parameter) -> Result<(), Problem> {
        if parameter.kind == Kind::Flag {
            self.arguments.insert(parameter.name, Value::Truth(is_given(self.matches, parameter.flag)));
            return Ok(());
        }
        let Some(text) = text_of(self.matches, parameter.flag) else {
            if parameter.required {
                return self.without(parameter);
            }
            return Ok(());
        };
        let value = self.value(parameter, text)?;
        self.arguments.insert(parameter.name, value);
        Ok(())
    }

    /// A required flag that is not there; a shape file may stand in for a frame.
    fn without(&mut self, parameter: &Parameter) -> Result<(), Problem> {
        if parameter.name == "frame" && self.shape_frame.is_some() {
            return Ok(());
        }
        Err(Problem::plain(format!("`{}` needs --{}: {}", self.operation.verb, parameter.flag, parameter.help))
            .with_help(format!("for example: {}", self.operation.example)))
    }

    pub(super) fn frame(&self, parameter: &Parameter, text: &str, name: &str) -> Result<Value<Polynomial>, Problem> {
        let frame = frame_of(text, name)?;
        let found = super::given::domain_of(&frame);
        // A conversion and a frame alone may be of any kind.
        let shapes = ["points", "curve", "surface"];
        let free = self.operation.verb == "convert" || !shapes.iter().any(|name| self.operation.parameter(name).is_some());
        if found == self.domain || parameter.name == SECOND.frame || free && parameter.name != "new_frame" {
            return Ok(Value::Frame(frame));
        }
        Err(Problem::plain(match self.domain {
            Domain::Curve => format!("{name} takes the frame r..s of a curve, such as -1..3"),
            _ if found == Domain::Curve => {
                format!("{name} takes a triangle '(1,0) (0,1) (0,0)' or a rectangle '0..1, 0..1' here: this is a surface")
            }
            Domain::Triangle => format!("{name} takes a triangle here, such as '(1,0) (0,1) (0,0)'"),
            Domain::Rectangle => format!("{name} takes a rectangle here, such as '0..1, 0..1'"),
        }))
    }

    /// The frame of the shape file, or a word about the default.
    fn default_frame(&mut self) -> Result<(), Problem> {
        let Some(parameter) = self.operation.parameters.iter().find(|parameter| parameter.flag == "over") else { return Ok(()) };
        let given = |name| self.arguments.get(name).is_some();
        let equation = given("curve") || given("surface");
        // What these give does not depend on the frame of control points.
        let free = matches!(self.operation.verb, "hull" | "elevate" | "product" | "reduce" | "symmetry" | "transform" | "matrix");
        let needed = (given("points") && !free) || (equation && parameter.kind == Kind::Frame);
        match (self.arguments.any_frame(parameter.name).ok(), self.shape_frame.take()) {
            (Some(given), Some(file)) if *given != file => {
                return Err(Problem::plain(format!("--over {given} contradicts the frame {file} of the shape file"))
                    .with_help("`casteljau reframe` brings the control points over another frame"));
            }
            (None, Some(file)) => self.arguments.insert(parameter.name, Value::Frame(file)),
            // `polar` has control points only where a frame is given, `convert` needs none of an equation.
            (None, None) if needed && self.operation.verb != "polar" && !(equation && self.operation.verb == "convert") => {
                self.notes.push(
                    match self.domain {
                        Domain::Curve => "the frame is 0..1; --over r..s says otherwise",
                        Domain::Triangle => "the frame is the triangle (1,0) (0,1) (0,0); --over '(u,v) (u,v) (u,v)' says otherwise",
                        Domain::Rectangle => "the frame is the unit square; --over 'a..b, c..d' says otherwise",
                    }
                    .to_owned(),
                );
            }
            _ => {}
        }
        Ok(())
    }

    /// Which of its two readings a surface was given.
    fn tell_reading(&mut self) {
        if !matches!(self.operation.verb, "polar" | "describe" | "homogenize") || self.operation.name == "homogenize" {
            return;
        }
        if let Some(Value::Surface(surface)) = self.arguments.get("surface") {
            let (p, q) = surface.true_bidegree();
            self.notes.push(format!(
                "read by its total degree {}; --bidegree {p},{q} reads it variable by variable, --both does both",
                surface.true_total_degree()
            ));
        }
    }
}
