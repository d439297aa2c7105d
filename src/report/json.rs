//! Answers in the data model of `batch`.

use serde_json::{Map, Value as Json, json};

use super::formula::Notation;
use crate::blossom::{PolarDefect, PolarForm, symmetric_terms};
use crate::error::Error;
use crate::kernel::coefficient::Coefficient;
use crate::segment::Segment;
use crate::value::{Answer, Value};

/// The answer as the `output` of a `batch` answer.
///
/// # Errors
/// [`Error::TooLarge`] if a polar form has too many terms to be written out.
pub fn output<C: Coefficient>(answer: &Answer<C>) -> Result<Json, Error> {
    record(&answer.fields)
}

fn record<C: Coefficient>(fields: &[(&'static str, Value<C>)]) -> Result<Json, Error> {
    let mut object = Map::new();
    for (name, value) in fields {
        object.insert((*name).to_owned(), encode(value)?);
    }
    Ok(Json::Object(object))
}

fn number<C: Coefficient>(number: &C) -> Json {
    Json::String(number.to_string())
}

fn point<C: Coefficient>(coordinates: &[C]) -> Json {
    coordinates.iter().map(number).collect()
}

fn piece<C: Coefficient>(segment: &Segment<C>) -> Json {
    json!({
        "degree": segment.degree(),
        "frame": [number(segment.frame().r()), number(segment.frame().s())],
        "points": segment.points().map(point).collect::<Json>(),
    })
}

fn encode<C: Coefficient>(value: &Value<C>) -> Result<Json, Error> {
    Ok(match value {
        Value::Truth(truth) => Json::Bool(*truth),
        Value::Count(count) => json!(count),
        Value::Word(word) => json!(word),
        Value::Document(text) => json!(text),
        Value::Number(value) => number(value),
        Value::Numbers(values) | Value::Point(values) => point(values),
        Value::Points(points) => points.iter().map(|coordinates| point(coordinates)).collect(),
        Value::Frame(frame) => json!([number(frame.r()), number(frame.s())]),
        Value::Arguments(arguments) => arguments.iter().map(|argument| point(&[argument.t.clone(), argument.w.clone()])).collect(),
        Value::Curve(curve) => json!({
            "degree": curve.degree(),
            "coeffs": (0..curve.dimension()).map(|index| curve.coordinate(index).map(number).collect::<Json>()).collect::<Json>(),
        }),
        Value::Net(segment) => segment.points().map(point).collect(),
        Value::Piece(segment) => piece(segment),
        Value::Pieces(pieces) => pieces.iter().map(piece).collect(),
        Value::Polar(polar) => (0..polar.dimension()).map(|coordinate| polar_map(polar, coordinate)).collect::<Result<Json, _>>()?,
        Value::Scheme(scheme) => scheme.layers().map(|layer| layer.map(point).collect::<Json>()).collect(),
        Value::Defects(defects) => defects.iter().map(defect).collect(),
        Value::List(values) => values.iter().map(encode).collect::<Result<Json, _>>()?,
        Value::Record(fields) => record(fields)?,
        Value::Expressions(expressions) => expressions.iter().map(|expression| json!(expression.to_string())).collect(),
        Value::Variable(symbol) => json!(symbol.to_string()),
        Value::Map(_) | Value::Nothing => Json::Null,
    })
}

/// One coordinate as an object from monomials, such as `t1*t2`, to coefficients.
fn polar_map<C: Coefficient>(polar: &PolarForm<C>, coordinate: usize) -> Result<Json, Error> {
    let limit = Notation::MAX_EXPANDED_TERMS;
    if polar.term_count(coordinate) > crate::exact::Rational::from(limit as i64) {
        return Err(Error::TooLarge { what: "number of terms of the polar form", limit });
    }
    let mut map = Map::new();
    for k in 0..=polar.degree() {
        let coefficient = polar.coefficient(coordinate, k);
        if coefficient.is_nothing() {
            continue;
        }
        for monomial in symmetric_terms(polar.degree(), k) {
            let factors: Vec<String> = monomial.factors().iter().map(|(symbol, _)| symbol.to_string()).collect();
            map.insert(if factors.is_empty() { "1".to_owned() } else { factors.join("*") }, number(coefficient));
        }
    }
    Ok(Json::Object(map))
}

fn defect(defect: &PolarDefect) -> Json {
    match defect {
        PolarDefect::NotSymmetric { coordinate, arguments: (first, second), difference } => {
            json!({"kind": "not-symmetric", "coordinate": coordinate, "arguments": [first, second], "difference": difference.to_string()})
        }
        PolarDefect::NotAffine { coordinate, argument, degree } => {
            json!({"kind": "not-affine", "coordinate": coordinate, "argument": argument, "degree": degree})
        }
        PolarDefect::WrongDiagonal { coordinate, difference } => {
            json!({"kind": "wrong-diagonal", "coordinate": coordinate, "difference": difference.to_string()})
        }
    }
}
