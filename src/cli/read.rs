//! The arguments of an operation from the words of a command line.

use clap::ArgMatches;

use super::command::parameters;
use super::diagnostic::Problem;
use super::source::Source;
use super::variables;
use crate::affine::{AffineMap, Interval, Parameter as PolarParameter};
use crate::curve::Curve;
use crate::model::read_shape;
use crate::ops::{Kind, Operation, Parameter};
use crate::symbolic::{Polynomial, Symbol};
use crate::syntax::limits::MAX_DEGREE;
use crate::syntax::{self, FrameInput, Input, Nesting, PointsInput, SyntaxError, Variables};
use crate::value::{Arguments, Value};

/// The operation that a command means, by the flags that are given.
pub(super) fn selected(verb: &str, matches: &ArgMatches) -> Result<&'static Operation, Problem> {
    let chosen = Operation::of_verb(verb).find(|operation| operation.selected_by.iter().any(|name| is_given(matches, name)));
    let plain = || Operation::of_verb(verb).find(|operation| operation.selected_by.is_empty());
    let operation = chosen.or_else(plain).ok_or_else(|| Problem::plain(format!("there is no command `{verb}`")))?;
    for parameter in parameters(verb) {
        if is_given(matches, parameter.name) && operation.parameter(parameter.name).is_none() {
            let others = Operation::of_verb(verb).filter(|other| other.parameter(parameter.name).is_some());
            let wanted: Vec<String> = others.flat_map(|other| other.selected_by.iter().map(|name| spelled(other, name))).collect();
            let given = operation.selected_by.iter().find(|name| is_given(matches, name));
            return Err(Problem::plain(match given {
                None => format!("--{} goes with {} only", parameter.flag, wanted.join(" or ")),
                Some(flag) => format!("--{} does not go with {}", parameter.flag, spelled(operation, flag)),
            }));
        }
    }
    Ok(operation)
}

fn spelled(operation: &Operation, name: &str) -> String {
    operation.parameter(name).map_or_else(|| format!("`{name}`"), |parameter| format!("--{}", parameter.flag))
}

fn is_given(matches: &ArgMatches, name: &str) -> bool {
    matches!(matches.try_contains_id(name), Ok(true)) && matches.value_source(name) == Some(clap::parser::ValueSource::CommandLine)
}

/// Why an operation on numbers refuses a symbolic parameter.
pub(super) fn needs_numbers(operation: &Operation, symbol: Symbol, name: &str) -> Problem {
    let place = match operation.parameter(name) {
        Some(parameter) if !parameter.flag.is_empty() => format!("--{}", parameter.flag),
        _ => "the input".to_owned(),
    };
    Problem::plain(format!("`{}` needs numbers, but {place} contains the symbolic parameter `{symbol}`", operation.verb))
}

/// All arguments of an operation, and what the user should know about defaults.
pub(super) fn arguments(operation: &Operation, matches: &ArgMatches) -> Result<(Arguments<Polynomial>, Vec<String>), Problem> {
    let mut reader = Reader { operation, matches, arguments: Arguments::default(), notes: Vec::new(), shape_frame: None };
    if let Some(letters) = variables(matches)? {
        match letters.as_slice() {
            [letter] => reader.arguments.insert("variable", Value::Variable(*letter)),
            _ => return Err(Problem::plain("a curve has one parameter: --vars takes one letter here")),
        }
    }
    if operation.parameter("values").is_some() {
        let source = Source::of(matches, "input")?;
        let text = source.expression()?;
        let values = syntax::parse_scalars(text).map_err(|error| Problem::syntax(&source.name, text, error))?;
        reader.arguments.insert("values", Value::Numbers(values));
    } else if operation.parameter("curve").is_some() || operation.parameter("points").is_some() {
        reader.shape("input", "curve", "points")?;
    }
    if operation.parameter("other_points").is_some() {
        reader.shape("other", "other_curve", "other_points")?;
    }
    for parameter in operation.parameters.iter().filter(|parameter| !parameter.flag.is_empty()) {
        reader.flag(parameter)?;
    }
    reader.default_frame()?;
    reader.refuse_clashes()?;
    Ok((reader.arguments, reader.notes))
}

/// A word that became a product of letters, which is rarely what was meant.
fn word_note(text: &str) -> Option<String> {
    if text.contains('\\') {
        return None;
    }
    let word = text.split(|letter: char| !letter.is_ascii_alphabetic()).find(|word| word.len() >= 3)?;
    let letters: Vec<String> = word.chars().map(String::from).collect();
    Some(format!("`{word}` is read as the product {}: there are no functions here", letters.join(" ")))
}

struct Reader<'a> {
    operation: &'a Operation,
    matches: &'a ArgMatches,
    arguments: Arguments<Polynomial>,
    notes: Vec<String>,
    /// The frame that a shape file brought along.
    shape_frame: Option<Interval<Polynomial>>,
}

impl Reader<'_> {
    /// Reads a curve or control points into one of two arguments.
    fn shape(&mut self, argument: &str, curve: &'static str, points: &'static str) -> Result<(), Problem> {
        let source = Source::of(self.matches, argument)?;
        if source.is_shape() {
            return self.shape_file(&source, points);
        }
        let text = source.expression()?;
        let letters = variables(self.matches)?;
        let problem = |error: SyntaxError| Problem::syntax(&source.name, text, error);
        // Only where both may stand does the text decide which it is.
        let takes = |name| self.operation.parameter(name).is_some();
        let input = match (takes(curve), takes(points)) {
            (true, false) => syntax::parse_map(text, letters.as_deref()).map(Input::Map),
            (false, true) => syntax::parse_points(text).map(Input::Points),
            _ => syntax::parse_input(text, letters.as_deref()),
        };
        // A text of the other kind deserves to be told so.
        let input = input.or_else(|error| syntax::parse_input(text, letters.as_deref()).map_err(|_| error));
        match input.map_err(problem)? {
            Input::Map(map) => {
                let variable = match map.variables {
                    Variables::Curve(variable) => variable,
                    Variables::Surface(first, second) => {
                        return Err(Problem::plain(format!(
                            "`{}` takes a curve; this was read as a surface in {first} and {second}",
                            self.operation.verb
                        ))
                        .with_help(format!("say which letter is the parameter of the curve, as in --vars {first}")));
                    }
                };
                self.notes.extend(word_note(text));
                if self.operation.parameter(curve).is_none() {
                    return Err(Problem::plain(format!("`{}` takes control points; this is an equation", self.operation.verb))
                        .with_help("`casteljau points` turns an equation into control points"));
                }
                let coordinates = map.components.iter().map(|component| component.coefficients_in(variable)).collect();
                self.arguments.insert(curve, Value::Curve(Curve::new(coordinates)?));
                if self.arguments.get("variable").is_none() {
                    self.arguments.insert("variable", Value::Variable(variable));
                }
            }
            Input::Points(input) => {
                if self.operation.parameter(points).is_none() {
                    return Err(Problem::plain(format!("`{}` takes an equation; these are control points", self.operation.verb))
                        .with_help("`casteljau equation` turns control points into an equation, `casteljau reframe` brings them over another frame"));
                }
                self.arguments.insert(points, Value::Points(flat(input).map_err(problem)?));
            }
        }
        Ok(())
    }

    fn shape_file(&mut self, source: &Source, points: &'static str) -> Result<(), Problem> {
        if self.operation.parameter(points).is_none() {
            return Err(Problem::plain(format!("`{}` takes an equation; {} holds control points", self.operation.verb, source.name)));
        }
        let shape = read_shape(&source.text).map_err(|fault| Problem::plain(format!("{}: {}", source.name, fault.message)))?;
        let lift = |point: &[crate::exact::Rational]| point.iter().cloned().map(Polynomial::from).collect();
        let control = shape.segment.points().map(lift).collect();
        self.arguments.insert(points, Value::Points(control));
        if shape.has_frame {
            let frame = shape.segment.frame().map(&mut |end| Ok::<_, Problem>(Polynomial::from(end.clone())))?;
            if points == "points" {
                self.shape_frame = Some(frame);
            } else {
                self.arguments.insert("other_frame", Value::Frame(frame));
            }
        }
        Ok(())
    }

    fn flag(&mut self, parameter: &'static Parameter) -> Result<(), Problem> {
        if parameter.kind == Kind::Flag {
            self.arguments.insert(parameter.name, Value::Truth(is_given(self.matches, parameter.name)));
            return Ok(());
        }
        let Some(text) = self.matches.try_get_one::<String>(parameter.name).ok().flatten() else {
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

    fn value(&self, parameter: &Parameter, text: &str) -> Result<Value<Polynomial>, Problem> {
        let name = format!("--{}", parameter.flag);
        let problem = |error: SyntaxError| Problem::syntax(&name, text, error);
        Ok(match parameter.kind {
            Kind::Frame | Kind::FrameOfPoints => match syntax::parse_frame(text).map_err(problem)? {
                FrameInput::Interval(r, s) => Value::Frame(Interval::new(r, s)?),
                _ => return Err(Problem::plain(format!("{name} takes the frame r..s of a curve, such as -1..3"))),
            },
            Kind::Number => Value::Number(syntax::parse_scalar(text).map_err(problem)?),
            Kind::Numbers => Value::Numbers(syntax::parse_scalars(text).map_err(problem)?),
            Kind::Point => match flat(syntax::parse_points(text).map_err(problem)?).map_err(problem)?.as_slice() {
                [point] => Value::Point(point.clone()),
                points => return Err(Problem::plain(format!("{name} takes one point, found {}", points.len()))),
            },
            Kind::Count => Value::Count(count(&name, text)?),
            Kind::Arguments | Kind::HomogeneousArguments => Value::Arguments(polar_arguments(&name, text)?),
            Kind::Claim => Value::Expressions(syntax::parse_components(text).map_err(problem)?),
            Kind::Map => Value::Map(self.map(&name, text, &syntax::parse_components(text).map_err(problem)?)?),
            Kind::Plane => {
                let sides = text.split_once('=').unwrap_or((text, "0"));
                let side = |part| syntax::parse_scalar(part).map_err(|error| Problem::syntax(&name, part, error));
                Value::Map(self.map(&name, text, &[side(sides.0)? - side(sides.1)?])?)
            }
            Kind::Flag | Kind::Curve | Kind::Points => Value::Nothing,
        })
    }

    /// An affine map of the space of the input, from the images of its coordinates.
    fn map(&self, name: &str, text: &str, images: &[Polynomial]) -> Result<AffineMap<Polynomial>, Problem> {
        let dimension = match (self.arguments.get("points"), self.arguments.get("curve")) {
            (Some(Value::Points(points)), _) => points.first().map_or(0, Vec::len),
            (_, Some(Value::Curve(curve))) => curve.dimension(),
            _ => 0,
        };
        let numbered: Vec<Symbol> = (1..=dimension).map(|index| Symbol::new('x', Some(index as u32))).collect();
        let lettered: Vec<Symbol> = ['x', 'y', 'z'].into_iter().take(dimension).map(|letter| Symbol::new(letter, None)).collect();
        let uses_numbers = images.iter().any(|image| numbered.iter().any(|&symbol| image.degree_in(symbol) > 0));
        let coordinates = if dimension > 3 || uses_numbers { numbered } else { lettered };
        let mut rows = Vec::new();
        let mut shift = Vec::new();
        for image in images {
            let mut rest = image.clone();
            let mut row = Vec::new();
            for &symbol in &coordinates {
                let coefficient = rest.coefficients_in(symbol).into_iter().nth(1).unwrap_or_default();
                rest -= &coefficient * &Polynomial::from(symbol);
                row.push(coefficient);
            }
            let mixed = row.iter().chain([&rest]).any(|part| coordinates.iter().any(|&symbol| part.degree_in(symbol) > 0));
            let foreign = rest.symbols().into_iter().find(|symbol| matches!(symbol.letter(), 'x' | 'y' | 'z'));
            if mixed {
                return Err(Problem::plain(format!("{name}: `{text}` is not affine in {}", listed(&coordinates))));
            }
            if let Some(symbol) = foreign {
                return Err(Problem::plain(format!(
                    "{name}: `{symbol}` is not a coordinate of the input; those are {}",
                    listed(&coordinates)
                )));
            }
            rows.push(row);
            shift.push(rest);
        }
        Ok(AffineMap::new(rows, shift)?)
    }

    /// Refuses symbols that would be taken for the curve's parameter, or for an
    /// argument of its polar form, in what is printed.
    fn refuse_clashes(&self) -> Result<(), Problem> {
        let variable = self.arguments.variable();
        let mut symbols: Vec<Symbol> = Vec::new();
        let mut degree = 0;
        for (_, value) in self.arguments.iter() {
            match value {
                Value::Curve(curve) => {
                    degree = curve.degree();
                    symbols.extend((0..curve.dimension()).flat_map(|index| curve.coordinate(index)).flat_map(Polynomial::symbols));
                }
                Value::Points(points) => symbols.extend(points.iter().flatten().flat_map(Polynomial::symbols)),
                Value::Map(map) => symbols.extend(map.numbers().flat_map(Polynomial::symbols)),
                _ => {}
            }
        }
        if symbols.contains(&variable) {
            let help = if self.operation.parameter("curve").is_none() {
                format!("`{}` takes control points; `casteljau points` turns an equation into some", self.operation.verb)
            } else {
                "use another letter for one of them; --vars says what the parameter is called".to_owned()
            };
            return Err(Problem::plain(format!("the symbol `{variable}` is also the parameter of the curve")).with_help(help));
        }
        let argument = symbols.iter().find(|symbol| symbol.letter() == 't' && symbol.index().is_some());
        if let (Some(argument), "polar") = (argument, self.operation.verb) {
            return Err(Problem::plain(format!("the symbol `{argument}` is also an argument of the polar form"))
                .with_help("use another letter for it"));
        }
        degree = degree.max(self.arguments.count("degree").copied().unwrap_or(0));
        // A claim is about t1, …, tm and the parameters of the curve; anything else cannot be decided.
        let is_known = |symbol: &Symbol| {
            symbols.contains(symbol)
                || (symbol.letter() == 't' && symbol.index().is_some_and(|index| index >= 1 && index as usize <= degree))
        };
        let mut claimed = self.arguments.expressions("claim").ok().into_iter().flatten().flat_map(Polynomial::symbols);
        if let Some(foreign) = claimed.find(|symbol| !is_known(symbol)) {
            return Err(Problem::plain(format!(
                "the claim contains `{foreign}`, which is neither an argument of the polar form nor a parameter of the curve"
            ))
            .with_help(if degree == 0 {
                "a curve of polar degree 0 has no arguments".to_owned()
            } else {
                format!("its arguments are t1 to t{degree}")
            }));
        }
        Ok(())
    }

    /// The frame of the shape file, or a word about the default.
    fn default_frame(&mut self) -> Result<(), Problem> {
        let Some(parameter) = self.operation.parameter("frame") else { return Ok(()) };
        let needed = self.arguments.get("points").is_some() || (self.arguments.get("curve").is_some() && parameter.kind == Kind::Frame);
        match (self.arguments.frame("frame").ok(), self.shape_frame.take()) {
            (Some(given), Some(file)) if *given != file => {
                return Err(Problem::plain(format!("--over {given} contradicts the frame {file} of the shape file"))
                    .with_help("`casteljau reframe` brings the control points over another frame"));
            }
            (None, Some(file)) => self.arguments.insert("frame", Value::Frame(file)),
            // `polar` has control points only where a frame is given.
            (None, None) if needed && self.operation.verb != "polar" => {
                self.notes.push("the frame is 0..1; --over r..s says otherwise".to_owned());
            }
            _ => {}
        }
        Ok(())
    }
}

fn listed(symbols: &[Symbol]) -> String {
    symbols.iter().map(Symbol::to_string).collect::<Vec<_>>().join(", ")
}

/// The points of a flat list.
fn flat(input: PointsInput) -> Result<Vec<Vec<Polynomial>>, SyntaxError> {
    match input.nesting {
        Nesting::Flat(points) => points
            .into_iter()
            .map(|point| match point.weight {
                None => Ok(point.coordinates),
                Some(_) => {
                    Err(SyntaxError::new(point.span, "found a point with a weight, expected one without: this operation is polynomial"))
                }
            })
            .collect(),
        Nesting::Rows(rows) => {
            let span = rows.get(1).and_then(|row| row.first()).map_or_else(syntax::Span::default, |point| point.span);
            Err(SyntaxError::new(span, "found rows of points, expected one list: a curve has a control polygon"))
        }
    }
}

fn count(name: &str, text: &str) -> Result<usize, Problem> {
    match text.parse::<usize>() {
        Ok(count) if count <= MAX_DEGREE as usize => Ok(count),
        _ if !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit()) => {
            Err(Problem::plain(format!("{name} is at most {MAX_DEGREE}, found {}", crate::model::excerpt(text))))
        }
        _ => Err(Problem::plain(format!("{name} takes a whole number from 0 on, found `{}`", crate::model::excerpt(text)))),
    }
}

fn polar_arguments(name: &str, text: &str) -> Result<Vec<PolarParameter<Polynomial>>, Problem> {
    let problem = |error: SyntaxError| Problem::syntax(name, text, error);
    let parsed = syntax::parse_polar_arguments(text).map_err(problem)?;
    let [group] = parsed.groups.as_slice() else {
        return Err(Problem::plain(format!("{name}: a semicolon separates the two groups of a bidegree form; a curve has one group")));
    };
    group
        .iter()
        .map(|argument| match argument.coordinates.as_slice() {
            [t] => Ok(PolarParameter::homogeneous(argument.weight.clone(), t.clone())),
            _ => Err(problem(SyntaxError::new(argument.span, "found a point of the plane, expected a parameter of a curve"))),
        })
        .collect()
}
