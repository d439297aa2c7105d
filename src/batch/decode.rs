//! Arguments of operations from JSON.

use serde_json::value::RawValue;

use crate::affine::{AffineMap, Parameter};
use crate::curve::Curve;
use crate::model::{Fault, Fields, count, frame, number, numbers, plain, points};
use crate::ops::{Kind, Operation};
use crate::syntax::{self, SyntaxError};
use crate::value::{Arguments, Value};

/// The arguments of an operation from its `input` object.
pub(super) fn arguments(operation: &Operation, input: &RawValue) -> Result<Arguments, Fault> {
    let fields = Fields::of(input, "the input")?;
    let known: Vec<&str> = operation.parameters.iter().map(|parameter| parameter.name).collect();
    fields.only(&known, "the input")?;
    let mut arguments = Arguments::default();
    for parameter in operation.parameters {
        match fields.get(parameter.name) {
            Some(raw) => arguments.insert(parameter.name, value(parameter.kind, raw, parameter.name)?),
            None if parameter.required => {
                return Err(Fault::new("missing-field", format!("{} needs `{}`: {}", operation.name, parameter.name, parameter.help)));
            }
            None => {}
        }
    }
    let given = |name| arguments.get(name).is_some();
    for (curve, control) in [("curve", "points"), ("other_curve", "other_points")] {
        if operation.parameter(curve).is_some() && operation.parameter(control).is_some() {
            match (given(curve), given(control)) {
                (false, false) => return Err(Fault::new("missing-field", format!("{} needs `{curve}` or `{control}`", operation.name))),
                (true, true) => return Err(Fault::new("unknown-field", format!("`{curve}` and `{control}` exclude each other"))),
                _ => {}
            }
        }
    }
    Ok(arguments)
}

fn value(kind: Kind, raw: &RawValue, name: &str) -> Result<Value, Fault> {
    Ok(match kind {
        Kind::Curve => Value::Curve(curve(raw)?),
        Kind::Points => Value::Points(points(raw)?),
        Kind::Frame | Kind::FrameOfPoints => Value::Frame(frame(raw)?),
        Kind::Number => Value::Number(number(raw)?),
        Kind::Numbers | Kind::Arguments => Value::Numbers(numbers(raw, name)?),
        Kind::Point => Value::Point(numbers(raw, name)?),
        Kind::Count => Value::Count(count(raw, name)?),
        Kind::HomogeneousArguments => Value::Arguments(homogeneous(raw)?),
        Kind::Claim => Value::Expressions(expressions(raw)?),
        Kind::Map => Value::Map(map(raw)?),
        Kind::Plane => Value::Map(plane(raw)?),
        Kind::Flag => Value::Truth(plain(raw, "true or false")?),
    })
}

fn curve(raw: &RawValue) -> Result<Curve, Fault> {
    let fields = Fields::of(raw, "a curve")?;
    fields.only(&["degree", "coeffs"], "a curve")?;
    let degree = count(fields.require("degree", "a curve")?, "the degree")?;
    let lists: Vec<&RawValue> = plain_list(fields.require("coeffs", "a curve")?)?;
    let mut coordinates = Vec::with_capacity(lists.len());
    for list in lists {
        let coefficients = numbers(list, "a coordinate")?;
        if coefficients.len() != degree + 1 {
            let message = format!("degree {degree} needs {} coefficients a coordinate, found {}", degree + 1, coefficients.len());
            return Err(Fault::new("wrong-count", message));
        }
        coordinates.push(coefficients);
    }
    Ok(Curve::new(coordinates)?)
}

fn plain_list(raw: &RawValue) -> Result<Vec<&RawValue>, Fault> {
    serde_json::from_str(raw.get()).map_err(|_| Fault::new("wrong-shape", "expected a list"))
}

/// Pairs `[t, w]`.
fn homogeneous(raw: &RawValue) -> Result<Vec<Parameter>, Fault> {
    points(raw)
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
    texts.iter().map(|text| syntax::parse_scalar(text).map_err(|error| syntax_fault(&error, text))).collect()
}

fn syntax_fault(error: &SyntaxError, text: &str) -> Fault {
    let (line, column) = error.position(text);
    Fault::new("wrong-shape", format!("line {line}, column {column}: {error}"))
}

/// `{"matrix": [[…], …], "shift": […]}`
fn map(raw: &RawValue) -> Result<AffineMap, Fault> {
    let fields = Fields::of(raw, "an affine map")?;
    fields.only(&["matrix", "shift"], "an affine map")?;
    let rows = points(fields.require("matrix", "an affine map")?)?;
    Ok(AffineMap::new(rows, numbers(fields.require("shift", "an affine map")?, "the shift")?)?)
}

/// `{"normal": […], "offset": c}` for the points where `normal · x + c = 0`.
fn plane(raw: &RawValue) -> Result<AffineMap, Fault> {
    let fields = Fields::of(raw, "a plane")?;
    fields.only(&["normal", "offset"], "a plane")?;
    let normal = numbers(fields.require("normal", "a plane")?, "the normal")?;
    Ok(AffineMap::new(vec![normal], vec![number(fields.require("offset", "a plane")?)?])?)
}
