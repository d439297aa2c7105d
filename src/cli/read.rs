//! The arguments of an operation from the words of a command line.

use clap::ArgMatches;

use super::diagnostic::Problem;
use super::given::{Given, frame_of};
use super::select::{Selection, is_given, text_of};
use super::source::Source;
use super::variables;
use crate::affine::{AffineMap, Frame, Parameter as PolarParameter, PlaneParameter};
use crate::curve::Curve;
use crate::model::ShapeFile;
use crate::ops::{Kind, Operation, Parameter, Run};
use crate::piece::Piece;
use crate::reading::Reading;
use crate::surface::{Surface, Term};
use crate::symbolic::{Polynomial, Symbol};
use crate::syntax::limits::MAX_DEGREE;
use crate::syntax::{self, Input, MapInput, Nesting, PointInput, PointsInput, SyntaxError, Variables};
use crate::triangular::triangular_degree;
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
struct Names {
    curve: &'static str,
    surface: &'static str,
    points: &'static str,
    weights: &'static str,
    frame: &'static str,
}

const FIRST: Names = Names { curve: "curve", surface: "surface", points: "points", weights: "weights", frame: "frame" };
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

struct Reader<'a> {
    operation: &'a Operation,
    domain: Domain,
    matches: &'a ArgMatches,
    arguments: Arguments<Polynomial>,
    notes: &'a mut Vec<String>,
    /// The frame that a shape file brought along.
    shape_frame: Option<Frame<Polynomial>>,
}

impl Reader<'_> {
    /// The letters of the parameters, by `--vars` or by the equation.
    fn letters(&mut self, given: Option<&Given>) -> Result<(), Problem> {
        let letters = match (variables(self.matches)?, given) {
            (Some(letters), _) => letters,
            (None, Some(Given::Equation(map))) => map.variables.symbols(),
            _ => return Ok(()),
        };
        let expected = if self.domain == Domain::Curve { 1 } else { 2 };
        if letters.len() == expected {
            self.arguments.insert("variables", Value::Variables(letters));
            return Ok(());
        }
        // A constant surface may have been read as a constant curve.
        if matches!(given, Some(Given::Equation(_))) && is_given(self.matches, "vars") || !matches!(given, Some(Given::Equation(_))) {
            let (one, letters) =
                if expected == 1 { ("a curve has one parameter", "one letter") } else { ("a surface has two", "two letters") };
            return Err(Problem::plain(format!("{one}: --vars takes {letters} here")));
        }
        Ok(())
    }

    /// Puts a shape where the operation expects it.
    fn shape(&mut self, given: Given, names: &Names) -> Result<(), Problem> {
        match given {
            Given::Equation(map) => self.equation(&map, names),
            Given::Points(input) => self.points(input, names),
            Given::File(file) => self.shape_file(*file, names),
        }
    }

    fn equation(&mut self, map: &MapInput, names: &Names) -> Result<(), Problem> {
        match (map.variables, self.domain) {
            (Variables::Curve(variable), Domain::Curve) => {
                let coordinates = map.components.iter().map(|component| component.coefficients_in(variable)).collect();
                self.arguments.insert(names.curve, Value::Curve(Curve::new(coordinates)?));
            }
            (Variables::Surface(first, second), Domain::Triangle | Domain::Rectangle) => {
                let terms = |component: &Polynomial| {
                    let rows = component.coefficients_in(first);
                    let row = |(h, row): (usize, &Polynomial)| {
                        row.coefficients_in(second).into_iter().enumerate().map(move |(k, c)| (h, k, c)).collect::<Vec<Term<Polynomial>>>()
                    };
                    rows.iter().enumerate().flat_map(row).collect()
                };
                let lists: Vec<Vec<Term<Polynomial>>> = map.components.iter().map(terms).collect();
                let surface = if self.domain == Domain::Triangle { Surface::total(lists)? } else { Surface::tensor(lists)? };
                self.arguments.insert(names.surface, Value::Surface(surface));
            }
            (Variables::Curve(_), Domain::Triangle | Domain::Rectangle) => {
                let constants = map.components.iter().map(|component| vec![(0, 0, component.clone())]).collect();
                let surface = if self.domain == Domain::Triangle { Surface::total(constants)? } else { Surface::tensor(constants)? };
                self.arguments.insert(names.surface, Value::Surface(surface));
            }
            (Variables::Surface(first, second), Domain::Curve) => {
                let verb = self.operation.verb;
                return Err(Problem::plain(format!("`{verb}` takes a curve here; this was read as a surface in {first} and {second}"))
                    .with_help(format!("say which letter is the parameter of the curve, as in --vars {first}")));
            }
        }
        Ok(())
    }

    fn points(&mut self, input: PointsInput, names: &Names) -> Result<(), Problem> {
        let lists = match (input.nesting, self.domain) {
            (Nesting::Flat(points), Domain::Curve) => vec![points],
            (Nesting::Rows(_), Domain::Curve) => {
                return Err(Problem::plain("these are rows of points; a curve has one list of them"));
            }
            (Nesting::Rows(rows), _) => rows,
            (Nesting::Flat(points), Domain::Triangle) => self.triangle_of(points)?,
            (Nesting::Flat(points), Domain::Rectangle) => self.rectangle_of(points)?,
        };
        let all = || lists.iter().flatten();
        if all().any(|point| point.weight.is_some()) {
            let weights = all().map(|point| point.weight.clone().unwrap_or_else(num_traits::One::one)).collect();
            if self.operation.parameter(names.weights).is_none() {
                return Err(Problem::plain(format!("`{}` takes points without weights here", self.operation.verb)));
            }
            self.arguments.insert(names.weights, Value::Numbers(weights));
        }
        let rows: Vec<Vec<Vec<Polynomial>>> =
            lists.into_iter().map(|row| row.into_iter().map(|point| point.coordinates).collect()).collect();
        self.insert_rows(rows, names);
        Ok(())
    }

    fn insert_rows(&mut self, mut rows: Vec<Vec<Vec<Polynomial>>>, names: &Names) {
        let value = if self.domain == Domain::Curve { Value::Points(rows.swap_remove(0)) } else { Value::Rows(rows) };
        self.arguments.insert(names.points, value);
    }

    /// The rows of a triangular net that is given as one list.
    fn triangle_of(&self, points: Vec<PointInput>) -> Result<Vec<Vec<PointInput>>, Problem> {
        let Some(degree) = triangular_degree(points.len()) else {
            return Err(Problem::plain(format!(
                "a triangular net has 1, 3, 6, 10, … points, (m+1)(m+2)/2 for degree m; found {}",
                points.len()
            )));
        };
        let mut points = points.into_iter();
        Ok((0..=degree).map(|i| points.by_ref().take(degree + 1 - i).collect()).collect())
    }

    /// The rows of a rectangular net that is given as one list.
    fn rectangle_of(&self, points: Vec<PointInput>) -> Result<Vec<Vec<PointInput>>, Problem> {
        let Some(text) = text_of(self.matches, "bidegree") else {
            return Err(Problem::plain(format!("{} points in one list need --bidegree P,Q to be a rectangular net", points.len()))
                .with_help("or separate the rows by semicolons"));
        };
        let (p, q) = match counts("--bidegree", text)?.as_slice() {
            &[p, q] => (p, q),
            other => return Err(Problem::plain(format!("--bidegree takes two whole numbers P,Q, found {}", other.len()))),
        };
        if points.len() != (p + 1) * (q + 1) {
            let needed = (p + 1) * (q + 1);
            return Err(Problem::plain(format!("a net of bidegree ({p},{q}) has {needed} points, found {}", points.len())));
        }
        let mut points = points.into_iter();
        Ok((0..=p).map(|_| points.by_ref().take(q + 1).collect()).collect())
    }

    fn shape_file(&mut self, file: ShapeFile, names: &Names) -> Result<(), Problem> {
        let kind = match &file.piece {
            Piece::Curve(_) => Domain::Curve,
            Piece::Triangle(_) => Domain::Triangle,
            Piece::Rectangle(_) => Domain::Rectangle,
        };
        if kind != self.domain {
            let verb = self.operation.verb;
            return Err(Problem::plain(format!("`{verb}` takes a {} here; the shape file holds a {}", self.domain.name(), kind.name())));
        }
        let lift = |point: &[crate::exact::Rational]| point.iter().cloned().map(Polynomial::from).collect();
        let rows = file.piece.rows().into_iter().map(|row| row.into_iter().map(lift).collect()).collect();
        self.insert_rows(rows, names);
        if let Some(weights) = file.weights {
            if self.operation.parameter(names.weights).is_none() {
                return Err(Problem::plain(format!("`{}` takes shapes without weights here", self.operation.verb)));
            }
            self.arguments.insert(names.weights, Value::Numbers(weights.into_iter().map(Polynomial::from).collect()));
        }
        if file.has_frame {
            let frame = file.piece.frame().map(&mut |number| Ok::<_, Problem>(Polynomial::from(number.clone())))?;
            if names.points == FIRST.points {
                self.shape_frame = Some(frame);
            } else {
                self.arguments.insert(names.frame, Value::Frame(frame));
            }
        }
        Ok(())
    }

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

    fn value(&self, parameter: &Parameter, text: &str) -> Result<Value<Polynomial>, Problem> {
        let name = format!("--{}", parameter.flag);
        let problem = |error: SyntaxError| Problem::syntax(&name, text, error);
        let list = || {
            syntax::parse_scalars(text.trim().strip_prefix('(').and_then(|rest| rest.strip_suffix(')')).unwrap_or(text)).map_err(problem)
        };
        Ok(match parameter.kind {
            Kind::Frame | Kind::FrameOfPoints => self.frame(parameter, text, &name)?,
            Kind::Number => Value::Number(syntax::parse_scalar(text).map_err(problem)?),
            Kind::Place => {
                let place = list()?;
                let expected = if self.domain == Domain::Curve { 1 } else { 2 };
                if place.len() != expected {
                    return Err(parameters_wanted(&name, self.domain, place.len()));
                }
                Value::Numbers(place)
            }
            Kind::FirstParameter | Kind::SecondParameter => match <[Polynomial; 2]>::try_from(list()?) {
                Ok([u, v]) => Value::Number(if parameter.kind == Kind::FirstParameter { u } else { v }),
                Err(found) => return Err(parameters_wanted(&name, self.domain, found.len())),
            },
            Kind::Numbers => Value::Numbers(syntax::parse_scalars(text).map_err(problem)?),
            // A point of the parameter plane may be written without brackets.
            Kind::Point if matches!(parameter.name, "a" | "A" | "B" | "direction") => match list()? {
                point if point.len() == 2 => Value::Point(point),
                found => return Err(parameters_wanted(&name, self.domain, found.len())),
            },
            Kind::Point => match points_of(text).map_err(problem)?.as_slice() {
                [point] => Value::Point(point.clone()),
                // A point without its brackets.
                numbers if numbers.iter().all(|number| number.len() == 1) => Value::Point(numbers.concat()),
                points => return Err(Problem::plain(format!("{name} takes one point, found {}", points.len()))),
            },
            Kind::Count => Value::Count(count(&name, text)?),
            Kind::Counts => Value::Counts(counts(&name, text)?),
            Kind::Arguments | Kind::HomogeneousArguments => Value::Arguments(polar_arguments(&name, text, 0, 1)?),
            Kind::FirstArguments(_) => Value::Arguments(polar_arguments(&name, text, 0, 2)?),
            Kind::SecondArguments(_) => Value::Arguments(polar_arguments(&name, text, 1, 2)?),
            Kind::PlaneArguments(_) => Value::PlaneArguments(plane_arguments(&name, text)?),
            Kind::Claim => Value::Expressions(syntax::parse_components(text).map_err(problem)?),
            Kind::Weight => Value::Expressions(vec![syntax::parse_scalar(text).map_err(problem)?]),
            Kind::Map => Value::Map(self.map(&name, text, &syntax::parse_components(text).map_err(problem)?)?),
            Kind::Plane => {
                let sides = text.split_once('=').unwrap_or((text, "0"));
                let side = |part| syntax::parse_scalar(part).map_err(|error| Problem::syntax(&name, part, error));
                Value::Map(self.map(&name, text, &[side(sides.0)? - side(sides.1)?])?)
            }
            Kind::Word(words) => match words.iter().find(|word| **word == text) {
                Some(word) => Value::Word(word),
                None => {
                    return Err(Problem::plain(format!("{name} is one of {}, found `{}`", words.join(", "), crate::model::excerpt(text))));
                }
            },
            Kind::Points => Value::Points(points_of(text).map_err(problem)?),
            Kind::Shape => match syntax::parse_input(text, variables(self.matches)?.as_deref()).map_err(problem)? {
                Input::Points(_) => Value::Points(points_of(text).map_err(problem)?),
                Input::Map(map) => match map.variables {
                    Variables::Curve(variable) => {
                        let coordinates = map.components.iter().map(|component| component.coefficients_in(variable)).collect();
                        Value::Curve(Curve::new(coordinates)?)
                    }
                    Variables::Surface(..) => return Err(Problem::plain(format!("{name} takes a curve; this was read as a surface"))),
                },
            },
            Kind::Flag | Kind::Curve | Kind::Surface | Kind::AnySurface | Kind::Terms | Kind::Weights => Value::Nothing,
        })
    }

    fn frame(&self, parameter: &Parameter, text: &str, name: &str) -> Result<Value<Polynomial>, Problem> {
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

    /// An affine map of the space of the input, from the images of its coordinates.
    fn map(&self, name: &str, text: &str, images: &[Polynomial]) -> Result<AffineMap<Polynomial>, Problem> {
        let dimension = match (self.arguments.get("points"), self.arguments.get("curve").or(self.arguments.get("surface"))) {
            (Some(Value::Points(points)), _) => points.first().map_or(0, Vec::len),
            (Some(Value::Rows(rows)), _) => rows.first().and_then(|row| row.first()).map_or(0, Vec::len),
            (_, Some(Value::Curve(curve))) => curve.dimension(),
            (_, Some(Value::Surface(surface))) => surface.dimension(),
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

    /// Refuses symbols that would be taken for a parameter of the map, or for an
    /// argument of its polar form, in what is printed.
    fn refuse_clashes(&self) -> Result<(), Problem> {
        let (parameters, kind): (Vec<Symbol>, &str) = match self.domain {
            Domain::Curve => (vec![self.arguments.variable()], "curve"),
            _ => (self.arguments.variables().to_vec(), "surface"),
        };
        let mut symbols: Vec<Symbol> = Vec::new();
        for (_, value) in self.arguments.iter() {
            match value {
                Value::Curve(curve) => {
                    symbols.extend((0..curve.dimension()).flat_map(|index| curve.coordinate(index)).flat_map(Polynomial::symbols));
                }
                Value::Surface(surface) => symbols.extend(surface.coefficients().iter().flat_map(Polynomial::symbols)),
                Value::Points(points) => symbols.extend(points.iter().flatten().flat_map(Polynomial::symbols)),
                Value::Rows(rows) => symbols.extend(rows.iter().flatten().flatten().flat_map(Polynomial::symbols)),
                Value::Map(map) => symbols.extend(map.numbers().flat_map(Polynomial::symbols)),
                _ => {}
            }
        }
        if let Some(variable) = parameters.iter().find(|variable| symbols.contains(variable)) {
            let equation = self.operation.parameter("curve").is_some() || self.operation.parameter("surface").is_some();
            let help = if equation {
                "use another letter for one of them; --vars says what the parameter is called".to_owned()
            } else {
                format!("`{}` takes control points; `casteljau points` turns an equation into some", self.operation.verb)
            };
            return Err(Problem::plain(format!("the symbol `{variable}` is also the parameter of the {kind}")).with_help(help));
        }
        let weights = |symbol: &&Symbol| matches!((symbol.letter(), symbol.index()), ('a' | 'b' | 'c' | 'u' | 'v', None));
        if let Some(letter) = symbols.iter().find(weights).filter(|_| self.operation.verb == "homogenize") {
            return Err(Problem::plain(format!("the symbol `{letter}` is also a letter of the homogenized polynomials"))
                .with_help("these are a, b, c, u and v; use another letter for it"));
        }
        if self.operation.verb != "polar" {
            return Ok(());
        }
        let reading = match self.domain {
            Domain::Curve => Reading::Curve(self.arguments.curve()?.degree()),
            _ => self.arguments.surface()?.reading(),
        };
        // Any index: more arguments than there are would look like one.
        let weights = self.arguments.flag("homogeneous");
        let letters: Vec<char> = match reading {
            Reading::Curve(_) => vec!['t'],
            Reading::Total(_) => ['U', 'V', 'C'].into_iter().take(if weights { 3 } else { 2 }).collect(),
            Reading::Bidegree(..) => ['u', 'v', 'a', 'b'].into_iter().take(if weights { 4 } else { 2 }).collect(),
        };
        if let Some(argument) = symbols.iter().find(|symbol| letters.contains(&symbol.letter()) && symbol.index().is_some()) {
            return Err(Problem::plain(format!("the symbol `{argument}` is also an argument of the polar form"))
                .with_help("use another letter for it"));
        }
        // A claim is about the arguments and the parameters of the map; anything else cannot be decided.
        let known: Vec<Symbol> = reading.symbols().collect();
        let mut claimed = self.arguments.expressions("claim").ok().into_iter().flatten().flat_map(Polynomial::symbols);
        if let Some(foreign) = claimed.find(|symbol| !symbols.contains(symbol) && !known.contains(symbol)) {
            return Err(Problem::plain(format!(
                "the claim contains `{foreign}`, which is neither an argument of the polar form nor a parameter of the {kind}"
            ))
            .with_help(match (known.first(), known.last()) {
                (Some(first), Some(last)) => format!("its arguments are {first} to {last}"),
                _ => format!("a {kind} of polar degree 0 has no arguments"),
            }));
        }
        Ok(())
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

fn parameters_wanted(name: &str, domain: Domain, found: usize) -> Problem {
    Problem::plain(match domain {
        Domain::Curve => format!("{name} takes one parameter on a curve, found {found}"),
        _ => format!("{name} takes two parameters on a surface, such as 1/3,1/4; found {found}"),
    })
}

fn listed(symbols: &[Symbol]) -> String {
    symbols.iter().map(Symbol::to_string).collect::<Vec<_>>().join(", ")
}

/// Points without weights, in one list.
fn points_of(text: &str) -> Result<Vec<Vec<Polynomial>>, SyntaxError> {
    match syntax::parse_points(text)?.nesting {
        Nesting::Flat(points) => points
            .into_iter()
            .map(|point| match point.weight {
                None => Ok(point.coordinates),
                Some(_) => Err(SyntaxError::new(point.span, "found a point with a weight, expected one without")),
            })
            .collect(),
        Nesting::Rows(rows) => {
            let span = rows.get(1).and_then(|row| row.first()).map_or_else(syntax::Span::default, |point| point.span);
            Err(SyntaxError::new(span, "found rows of points, expected one list"))
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

/// Small whole numbers separated by commas or blanks.
fn counts(name: &str, text: &str) -> Result<Vec<usize>, Problem> {
    let text = text.trim().strip_prefix('(').and_then(|rest| rest.strip_suffix(')')).unwrap_or(text);
    let words = text.split([',', ' ']).map(str::trim).filter(|word| !word.is_empty());
    let counts: Vec<usize> = words.map(|word| count(name, word)).collect::<Result<_, _>>()?;
    if counts.is_empty() {
        return Err(Problem::plain(format!("{name} takes whole numbers such as 3,2, found nothing")));
    }
    Ok(counts)
}

/// One of the groups of arguments on the line.
fn polar_arguments(name: &str, text: &str, group: usize, groups: usize) -> Result<Vec<PolarParameter<Polynomial>>, Problem> {
    let problem = |error: SyntaxError| Problem::syntax(name, text, error);
    let parsed = syntax::parse_polar_arguments(text).map_err(problem)?;
    if parsed.groups.len() != groups {
        return Err(Problem::plain(if groups == 1 {
            format!("{name}: a semicolon separates the two groups of a bidegree form; a curve has one group")
        } else {
            format!("{name}: a bidegree form takes two groups of arguments, separated by a semicolon, as in '1 0; 0 1'")
        }));
    }
    parsed.groups[group]
        .iter()
        .map(|argument| match argument.coordinates.as_slice() {
            [t] => Ok(PolarParameter::homogeneous(argument.weight.clone(), t.clone())),
            _ => Err(problem(SyntaxError::new(argument.span, "found a point of the plane, expected a parameter of a curve"))),
        })
        .collect()
}

/// Arguments in the plane.
fn plane_arguments(name: &str, text: &str) -> Result<Vec<PlaneParameter<Polynomial>>, Problem> {
    let problem = |error: SyntaxError| Problem::syntax(name, text, error);
    let parsed = syntax::parse_polar_arguments(text).map_err(problem)?;
    let [group] = parsed.groups.as_slice() else {
        return Err(Problem::plain(format!(
            "{name}: a semicolon separates the two groups of a bidegree form; by the total degree there is one"
        )));
    };
    group
        .iter()
        .map(|argument| match argument.coordinates.as_slice() {
            [u, v] => Ok(PlaneParameter::homogeneous(argument.weight.clone(), u.clone(), v.clone())),
            _ => Err(problem(SyntaxError::new(argument.span, "found a number, expected a point `(u,v)` or a vector `[0; u,v]`"))
                .with_help("numbers are the arguments of the bidegree form, in two groups separated by a semicolon")),
        })
        .collect()
}
