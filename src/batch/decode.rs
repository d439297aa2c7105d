//! Arguments of operations from JSON.

use serde_json::value::RawValue;

use crate::affine::{AffineMap, Frame, Parameter, PlaneParameter};
use crate::curve::Curve;
use crate::exact::Rational;
use crate::model::{Decimals, Fault, Fields, count, depth, excerpt, frame, list, number, numbers, place, plain, points, rows, weights};
use crate::ops::{Kind, Operation, Weighting};
use crate::piece::Piece;
use crate::reading::Reading;
use crate::rectangular::RectangularPatch;
use crate::segment::Segment;
use crate::surface::{Surface, Term};
use crate::syntax::{self, SyntaxError};
use crate::triangular::TriangularPatch;
use crate::value::{Arguments, Domain, Value};

/// The arguments of an operation from its `input` object.
pub(super) fn arguments(operation: &Operation, input: &RawValue) -> Result<Arguments, Fault> {
    let fields = Fields::of(input, "the input")?;
    let decimals = &mut Decimals::default();
    let known: Vec<&str> = operation.parameters.iter().map(|parameter| parameter.name).collect();
    fields.only(&known, "the input")?;
    let domain = match operation.domains {
        [only] => *only,
        _ => domain(&fields, decimals),
    };
    let mut arguments = Arguments::new(domain);
    for parameter in operation.parameters {
        match fields.get(parameter.name) {
            // `terms` are the surface whose name they stand for.
            Some(raw) if parameter.kind == Kind::Terms => arguments.insert("surface", Value::Surface(terms(raw, decimals)?)),
            Some(raw) => arguments.insert(parameter.name, value(parameter.kind, domain, raw, parameter.name, decimals)?),
            None if parameter.required => {
                return Err(Fault::new("missing-field", format!("{} needs `{}`: {}", operation.name, parameter.name, parameter.help)));
            }
            None => {}
        }
    }
    if let (Some(Value::Rows(rows)), Some(raw)) = (arguments.get("points"), fields.get("weights")) {
        check_parallel(rows, raw)?;
    }
    let given = |name| arguments.get(name).is_some();
    for shapes in [["curve", "surface", "points"], ["other_curve", "other_surface", "other_points"]] {
        let taken: Vec<&str> = shapes.into_iter().filter(|name| operation.parameter(name).is_some()).collect();
        let found: Vec<&str> = taken.iter().copied().filter(|name| given(name)).collect();
        match found.as_slice() {
            [] if taken.len() > 1 => {
                let names: Vec<String> = taken.iter().map(|name| format!("`{name}`")).collect();
                return Err(Fault::new("missing-field", format!("{} needs {}", operation.name, names.join(" or "))));
            }
            [first, second, ..] => return Err(Fault::new("unknown-field", format!("`{first}` and `{second}` exclude each other"))),
            _ => {}
        }
    }
    Ok(arguments)
}

/// Refuses weights that are not arranged like the control points.
fn check_parallel(rows: &[Vec<Vec<Rational>>], raw: &RawValue) -> Result<(), Fault> {
    let weights = list(raw, "the weights")?;
    if weights.len() != rows.len() {
        return Err(Fault::new("wrong-shape", format!("the weights have {} rows, the points {}", weights.len(), rows.len())));
    }
    for (index, (row, raw)) in rows.iter().zip(weights).enumerate() {
        let found = list(raw, "a row of weights")?.len();
        if found != row.len() {
            return Err(Fault::new(
                "wrong-shape",
                format!("row {index} of the weights has length {found}, that of the points {}", row.len()),
            ));
        }
    }
    Ok(())
}

/// What kind of shape the fields of a request are about.
fn domain(fields: &Fields, decimals: &mut Decimals) -> Domain {
    match fields.get("frame").map(|raw| frame(raw, decimals)) {
        Some(Ok(Frame::Triangle(_))) => return Domain::Triangle,
        Some(Ok(Frame::Rectangle(_))) => return Domain::Rectangle,
        Some(Ok(Frame::Interval(_))) => return Domain::Curve,
        _ => {}
    }
    if let Some(raw) = fields.get("surface").or(fields.get("other_surface")) {
        let is_bidegree = Fields::of(raw, "a surface").is_ok_and(|surface| surface.get("degree").is_some_and(|degree| depth(degree) > 0));
        return if is_bidegree { Domain::Rectangle } else { Domain::Triangle };
    }
    match fields.get("points").map(|raw| rows(raw, decimals)) {
        Some(Ok(rows)) if depth(fields.get("points").unwrap_or(RawValue::NULL)) >= 3 => {
            let shrinks = rows.len() > 1 && rows[rows.len() - 1].len() < rows[0].len();
            if shrinks { Domain::Triangle } else { Domain::Rectangle }
        }
        _ if fields.get("bidegree").is_some() => Domain::Rectangle,
        _ => Domain::Curve,
    }
}

fn value(kind: Kind, domain: Domain, raw: &RawValue, name: &str, decimals: &mut Decimals) -> Result<Value, Fault> {
    Ok(match kind {
        Kind::Curve => Value::Curve(curve(raw, decimals)?),
        Kind::Surface => Value::Surface(surface(raw, domain, decimals)?),
        Kind::Terms => Value::Surface(terms(raw, decimals)?),
        Kind::AnySurface => Value::Surface(any_surface(raw, domain, decimals)?),
        Kind::Shape if raw.get().starts_with('[') => Value::Points(points(raw, decimals)?),
        Kind::Shape => Value::Curve(curve(raw, decimals)?),
        Kind::Points if domain == Domain::Curve => Value::Points(points(raw, decimals)?),
        Kind::Points => Value::Rows(rows(raw, decimals)?),
        Kind::Weights => Value::Numbers(weights(raw, decimals)?),
        Kind::Weight => Value::Expressions(vec![expression(&plain::<String>(raw, "a polynomial")?)?]),
        Kind::Frame | Kind::FrameOfPoints => Value::Frame(frame(raw, decimals)?),
        Kind::Number | Kind::FirstParameter | Kind::SecondParameter => Value::Number(number(raw, decimals)?),
        Kind::Place => Value::Numbers(place(raw, decimals)?),
        Kind::Numbers | Kind::Arguments => Value::Numbers(numbers(raw, name, decimals)?),
        Kind::Point => Value::Point(numbers(raw, name, decimals)?),
        Kind::Piece => Value::Piece(piece(raw, name, decimals)?),
        Kind::Edge => Value::Points(points(raw, decimals)?),
        Kind::Count => Value::Count(count(raw, name)?),
        Kind::Counts => Value::Counts(counts(raw, name)?),
        Kind::HomogeneousArguments | Kind::FirstArguments(Weighting::Homogeneous) | Kind::SecondArguments(Weighting::Homogeneous) => {
            Value::Arguments(homogeneous(raw, decimals)?)
        }
        Kind::FirstArguments(Weighting::Points) | Kind::SecondArguments(Weighting::Points) => {
            Value::Arguments(numbers(raw, name, decimals)?.into_iter().map(Parameter::from).collect())
        }
        Kind::PlaneArguments(weighting) => Value::PlaneArguments(plane_arguments(raw, weighting, decimals)?),
        Kind::Claim => Value::Expressions(expressions(raw)?),
        Kind::Map => Value::Map(map(raw, decimals)?),
        Kind::Plane => Value::Map(plane(raw, decimals)?),
        Kind::Word(words) => Value::Word(word(raw, name, words)?),
        Kind::Flag => Value::Truth(plain(raw, "true or false")?),
    })
}

fn word(raw: &RawValue, name: &str, words: &'static [&'static str]) -> Result<&'static str, Fault> {
    let found: String = plain(raw, "a word")?;
    words
        .iter()
        .copied()
        .find(|word| *word == found)
        .ok_or_else(|| Fault::new("wrong-shape", format!("`{name}` is one of {}, found {}", words.join(", "), excerpt(&found))))
}

/// `{"frame", "points"}` or `{"frame", "homogeneous_points"}`, for triangles with their degree.
fn piece(raw: &RawValue, name: &str, decimals: &mut Decimals) -> Result<Piece, Fault> {
    let fields = Fields::of(raw, name)?;
    fields.only(&["frame", "points", "homogeneous_points", "degree"], name)?;
    let control = match (fields.get("points"), fields.get("homogeneous_points")) {
        (Some(raw), None) | (None, Some(raw)) => raw,
        (None, None) => return Err(Fault::new("missing-field", format!("{name} needs `points` or `homogeneous_points`"))),
        _ => return Err(Fault::new("unknown-field", "`points` and `homogeneous_points` exclude each other")),
    };
    let piece = match frame(fields.require("frame", name)?, decimals)? {
        Frame::Interval(frame) => Piece::Curve(Segment::from_points(points(control, decimals)?, frame)?),
        Frame::Triangle(frame) => Piece::Triangle(TriangularPatch::from_rows(rows(control, decimals)?, frame)?),
        Frame::Rectangle(frame) => Piece::Rectangle(RectangularPatch::from_rows(rows(control, decimals)?, frame)?),
    };
    if let (Piece::Triangle(patch), Some(raw)) = (&piece, fields.get("degree")) {
        let degree = count(raw, "the degree")?;
        if degree != patch.degree() {
            return Err(Fault::new(
                "wrong-count",
                format!("degree {degree} needs {} rows of points, found {}", degree + 1, patch.degree() + 1),
            ));
        }
    }
    Ok(piece)
}

/// Small whole numbers; one alone need not be a list.
fn counts(raw: &RawValue, name: &str) -> Result<Vec<usize>, Fault> {
    if depth(raw) == 0 {
        return Ok(vec![count(raw, name)?]);
    }
    list(raw, "the value")?.into_iter().map(|item| count(item, name)).collect()
}

/// `{"degree": m or [p, q], "terms": [[[h, k, c], …], …]}`
fn surface(raw: &RawValue, domain: Domain, decimals: &mut Decimals) -> Result<Surface, Fault> {
    let fields = Fields::of(raw, "a surface")?;
    fields.only(&["degree", "terms"], "a surface")?;
    let degree = fields.require("degree", "a surface")?;
    let reading = match (depth(degree), domain) {
        (0, Domain::Rectangle) => return Err(Fault::new("wrong-shape", "the degree of this surface is a bidegree [p, q]")),
        (1, Domain::Triangle) => return Err(Fault::new("wrong-shape", "the degree of this surface is its total degree, one number")),
        (0, _) => Reading::Total(count(degree, "the degree")?),
        _ => match counts(degree, "a degree")?.as_slice() {
            &[p, q] => Reading::Bidegree(p, q),
            other => return Err(Fault::new("wrong-count", format!("a bidegree has 2 numbers [p, q], found {}", other.len()))),
        },
    };
    let lists = list(fields.require("terms", "a surface")?, "the terms")?;
    Ok(Surface::new(reading, lists.into_iter().map(|raw| terms_of(raw, decimals)).collect::<Result<_, _>>()?)?)
}

/// A surface whose degree may be left out; it is the least total degree then.
fn any_surface(raw: &RawValue, domain: Domain, decimals: &mut Decimals) -> Result<Surface, Fault> {
    let fields = Fields::of(raw, "a surface")?;
    if fields.get("degree").is_some() {
        return surface(raw, domain, decimals);
    }
    fields.only(&["terms"], "a surface")?;
    let lists = list(fields.require("terms", "a surface")?, "the terms")?;
    Ok(Surface::total(lists.into_iter().map(|raw| terms_of(raw, decimals)).collect::<Result<_, _>>()?)?)
}

/// The terms of one coordinate, read by the least total degree.
fn terms(raw: &RawValue, decimals: &mut Decimals) -> Result<Surface, Fault> {
    Ok(Surface::total(vec![terms_of(raw, decimals)?])?)
}

fn terms_of(raw: &RawValue, decimals: &mut Decimals) -> Result<Vec<Term>, Fault> {
    let term = |raw: &RawValue| match list(raw, "the value")?.as_slice() {
        [h, k, c] => Ok((count(h, "an exponent")?, count(k, "an exponent")?, number(c, decimals)?)),
        other => Err(Fault::new("wrong-count", format!("a term is [h, k, coefficient], found {} entries", other.len()))),
    };
    list(raw, "the value")?.into_iter().map(term).collect()
}

/// Points `[u, v]`, or homogeneous ones `[u, v, w]`.
fn plane_arguments(raw: &RawValue, weighting: Weighting, decimals: &mut Decimals) -> Result<Vec<PlaneParameter>, Fault> {
    let size = if weighting == Weighting::Points { 2 } else { 3 };
    let argument = |raw: &RawValue| {
        let mut found = numbers(raw, "an argument", decimals)?;
        if found.len() != size {
            return Err(Fault::new("wrong-count", format!("an argument has {size} numbers, found {}", found.len())));
        }
        let w = if size == 3 { found.pop() } else { None }.unwrap_or_else(|| Rational::from(1));
        let v = found.pop().unwrap_or_else(|| Rational::from(0));
        let u = found.pop().unwrap_or_else(|| Rational::from(0));
        Ok(PlaneParameter::homogeneous(w, u, v))
    };
    list(raw, "the value")?.into_iter().map(argument).collect()
}

fn curve(raw: &RawValue, decimals: &mut Decimals) -> Result<Curve, Fault> {
    let fields = Fields::of(raw, "a curve")?;
    fields.only(&["degree", "coeffs"], "a curve")?;
    let degree = count(fields.require("degree", "a curve")?, "the degree")?;
    let lists: Vec<&RawValue> = list(fields.require("coeffs", "a curve")?, "the coefficients")?;
    let mut coordinates = Vec::with_capacity(lists.len());
    for list in lists {
        let coefficients = numbers(list, "a coordinate", decimals)?;
        if coefficients.len() != degree + 1 {
            let message = format!("degree {degree} needs {} coefficients a coordinate, found {}", degree + 1, coefficients.len());
            return Err(Fault::new("wrong-count", message));
        }
        coordinates.push(coefficients);
    }
    Ok(Curve::new(coordinates)?)
}

/// Pairs `[t, w]`.
fn homogeneous(raw: &RawValue, decimals: &mut Decimals) -> Result<Vec<Parameter>, Fault> {
    points(raw, decimals)
        .or_else(|fault| if raw.get().trim() == "[]" { Ok(Vec::new()) } else { Err(fault) })?
        .into_iter()
        .map(|pair| match <[_; 2]>::try_from(pair) {
            Ok([t, w]) => Ok(Parameter::homogeneous(w, t)),
            Err(pair) => Err(Fault::new("wrong-count", format!("a homogeneous argument is [t, w], found {} numbers", pair.len()))),
        })
        .collect()
}

/// A claimed polar form: one text a coordinate, such as `"t1 t2"`.
fn expressions(raw: &RawValue) -> Result<Vec<crate::symbolic::Polynomial>, Fault> {
    let texts: Vec<String> = plain(raw, "a list of expressions")?;
    texts.iter().map(|text| expression(text)).collect()
}

fn expression(text: &str) -> Result<crate::symbolic::Polynomial, Fault> {
    syntax::parse_scalar(text).map_err(|error| syntax_fault(&error, text))
}

fn syntax_fault(error: &SyntaxError, text: &str) -> Fault {
    let (line, column) = error.position(text);
    Fault::new("wrong-shape", format!("line {line}, column {column}: {error}"))
}

/// `{"matrix": [[…], …], "shift": […]}`
fn map(raw: &RawValue, decimals: &mut Decimals) -> Result<AffineMap, Fault> {
    let fields = Fields::of(raw, "an affine map")?;
    fields.only(&["matrix", "shift"], "an affine map")?;
    let rows = points(fields.require("matrix", "an affine map")?, decimals)?;
    Ok(AffineMap::new(rows, numbers(fields.require("shift", "an affine map")?, "the shift", decimals)?)?)
}

/// `{"normal": […], "offset": c}` for the points where `normal · x + c = 0`.
fn plane(raw: &RawValue, decimals: &mut Decimals) -> Result<AffineMap, Fault> {
    let fields = Fields::of(raw, "a plane")?;
    fields.only(&["normal", "offset"], "a plane")?;
    let normal = numbers(fields.require("normal", "a plane")?, "the normal", decimals)?;
    Ok(AffineMap::new(vec![normal], vec![number(fields.require("offset", "a plane")?, decimals)?])?)
}
