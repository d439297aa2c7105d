//! The values of flags.

use super::diagnostic::Problem;
use super::read::Reader;
use super::variables;
use crate::affine::{AffineMap, Parameter as PolarParameter, PlaneParameter};
use crate::curve::Curve;
use crate::ops::{Kind, Parameter};
use crate::symbolic::{Polynomial, Symbol};
use crate::syntax::limits::MAX_DEGREE;
use crate::syntax::{self, Input, Nesting, SyntaxError, Variables};
use crate::value::{Domain, Value};

impl Reader<'_> {
    pub(super) fn value(&self, parameter: &Parameter, text: &str) -> Result<Value<Polynomial>, Problem> {
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
                // A rectangle is continued to one parameter.
                let single = self.domain == Domain::Curve || (self.domain == Domain::Rectangle && parameter.name == "extend");
                let expected = if single { 1 } else { 2 };
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
            Kind::Flag | Kind::Piece | Kind::Edge | Kind::Curve | Kind::Surface | Kind::AnySurface | Kind::Terms | Kind::Weights => {
                Value::Nothing
            }
        })
    }

    /// An affine map of the space of the input, from the images of its coordinates.
    pub(super) fn map(&self, name: &str, text: &str, images: &[Polynomial]) -> Result<AffineMap<Polynomial>, Problem> {
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

pub(super) fn count(name: &str, text: &str) -> Result<usize, Problem> {
    match text.parse::<usize>() {
        Ok(count) if count <= MAX_DEGREE as usize => Ok(count),
        _ if !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit()) => {
            Err(Problem::plain(format!("{name} is at most {MAX_DEGREE}, found {}", crate::model::excerpt(text))))
        }
        _ => Err(Problem::plain(format!("{name} takes a whole number from 0 on, found `{}`", crate::model::excerpt(text)))),
    }
}

/// Small whole numbers separated by commas or blanks.
pub(super) fn counts(name: &str, text: &str) -> Result<Vec<usize>, Problem> {
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
