//! Answers in the data model of `batch`.

use serde_json::{Map, Value as Json, json};

use super::formula::Notation;
use crate::affine::Frame;
use crate::blossom::{PolarDefect, PolarForm};
use crate::error::Error;
use crate::exact::Surd;
use crate::kernel::coefficient::Coefficient;
use crate::piece::Piece;
use crate::reading::{PolarTerm, Reading};
use crate::surface::Surface;
use crate::value::{Answer, LabelledRow, Layers, Value};

/// The answer as the `output` of a `batch` answer.
///
/// # Errors
/// [`Error::TooLarge`] if a polar form has too many terms to be written out.
pub fn output<C: Coefficient>(answer: &Answer<C>) -> Result<Json, Error> {
    let mut object = Map::new();
    for (name, value) in &answer.fields {
        // Points with weights are named as what they are; pieces say it themselves.
        let is_plain =
            matches!(value, Value::Piece(_) | Value::Pieces(_) | Value::Truth(_) | Value::Count(_) | Value::Counts(_) | Value::Nothing);
        let of_frame = matches!(*name, "frame" | "barycentric" | "polyline");
        let name = if answer.weighted && !is_plain && !of_frame { format!("homogeneous_{name}") } else { (*name).to_owned() };
        object.insert(name, encode(value, answer.weighted)?);
    }
    Ok(Json::Object(object))
}

fn record<C: Coefficient>(fields: &[(&'static str, Value<C>)]) -> Result<Json, Error> {
    let mut object = Map::new();
    for (name, value) in fields {
        object.insert((*name).to_owned(), encode(value, false)?);
    }
    Ok(Json::Object(object))
}

fn number<C: Coefficient>(number: &C) -> Json {
    Json::String(number.to_string())
}

fn point<C: Coefficient>(coordinates: &[C]) -> Json {
    coordinates.iter().map(number).collect()
}

fn frame<C: Coefficient>(frame: &Frame<C>) -> Json {
    let numbers: Vec<Json> = frame.numbers().into_iter().map(number).collect();
    match frame {
        Frame::Interval(_) => Json::Array(numbers),
        _ => numbers.chunks(2).map(|pair| Json::Array(pair.to_vec())).collect(),
    }
}

/// Control points: a list for a curve, rows for a patch.
fn net<C: Coefficient>(piece: &Piece<C>) -> Json {
    match piece {
        Piece::Curve(segment) => segment.points().map(point).collect(),
        patch => patch.rows().into_iter().map(|row| row.into_iter().map(point).collect::<Json>()).collect(),
    }
}

fn surd(surd: &Surd) -> Json {
    json!({"a": surd.rational().to_string(), "sgn": surd.sign(), "rad": surd.radicand().to_string()})
}

fn piece<C: Coefficient>(piece: &Piece<C>, weighted: bool) -> Json {
    let degree = match piece {
        Piece::Curve(segment) => json!(segment.degree()),
        Piece::Triangle(patch) => json!(patch.degree()),
        Piece::Rectangle(patch) => json!([patch.degree().0, patch.degree().1]),
    };
    let points = if weighted { "homogeneous_points" } else { "points" };
    let mut object = Map::new();
    object.insert("degree".to_owned(), degree);
    object.insert("frame".to_owned(), frame(&piece.frame()));
    object.insert(points.to_owned(), net(piece));
    Json::Object(object)
}

fn surface<C: Coefficient>(surface: &Surface<C>) -> Json {
    let degree = match surface.reading() {
        Reading::Bidegree(p, q) => json!([p, q]),
        Reading::Total(degree) | Reading::Curve(degree) => json!(degree),
    };
    let terms = |coordinate| surface.terms(coordinate).into_iter().map(|(h, k, c)| json!([h, k, c.to_string()])).collect::<Json>();
    json!({"degree": degree, "terms": (0..surface.dimension()).map(terms).collect::<Json>()})
}

fn layers<C: Coefficient>(layers: &Layers<C>) -> Json {
    let row = |row: &LabelledRow<C>| row.iter().map(|(_, coordinates)| point(coordinates)).collect::<Json>();
    let layer = |layer: &Vec<LabelledRow<C>>| match layer.as_slice() {
        [only] if !layers.in_rows => row(only),
        rows => rows.iter().map(row).collect(),
    };
    layers.layers.iter().map(layer).collect()
}

pub(super) fn encode<C: Coefficient>(value: &Value<C>, weighted: bool) -> Result<Json, Error> {
    Ok(match value {
        Value::Truth(truth) => Json::Bool(*truth),
        Value::Count(count) => json!(count),
        Value::Integer(number) => json!(number),
        Value::Counts(counts) => json!(counts),
        Value::Word(word) => json!(word),
        Value::Document(text) => json!(text),
        Value::Number(value) => number(value),
        Value::Numbers(values) | Value::Point(values) => point(values),
        Value::Surd(value) => surd(value),
        Value::Surds(values) => values.iter().map(surd).collect(),
        Value::Points(points) | Value::Matrix(points) => points.iter().map(|coordinates| point(coordinates)).collect(),
        Value::Rows(rows) => rows.iter().map(|row| row.iter().map(|coordinates| point(coordinates)).collect::<Json>()).collect(),
        Value::Frame(value) => frame(value),
        Value::Arguments(arguments) => arguments.iter().map(|argument| point(&[argument.t.clone(), argument.w.clone()])).collect(),
        Value::PlaneArguments(arguments) => {
            arguments.iter().map(|argument| point(&[argument.u.clone(), argument.v.clone(), argument.w.clone()])).collect()
        }
        Value::Curve(curve) => json!({
            "degree": curve.degree(),
            "coeffs": (0..curve.dimension()).map(|index| curve.coordinate(index).map(number).collect::<Json>()).collect::<Json>(),
        }),
        Value::Surface(value) => surface(value),
        Value::Net(value) => net(value),
        Value::Piece(value) => piece(value, weighted),
        Value::Pieces(pieces) => pieces.iter().map(|value| piece(value, weighted)).collect(),
        Value::Polar(polar) => (0..polar.dimension()).map(|coordinate| polar_map(polar, coordinate, false)).collect::<Result<Json, _>>()?,
        Value::HomogeneousPolar(polar) => {
            (0..polar.dimension()).map(|coordinate| polar_map(polar, coordinate, true)).collect::<Result<Json, _>>()?
        }
        Value::Homogeneous(form) => {
            let term =
                |(exponents, c): &(Vec<usize>, C)| exponents.iter().map(|exponent| json!(exponent)).chain([number(c)]).collect::<Json>();
            json!({"vars": form.letters.iter().map(char::to_string).collect::<Vec<_>>(), "terms": form.terms.iter().map(term).collect::<Json>()})
        }
        Value::Scheme(scheme) => scheme.layers().map(|layer| layer.map(point).collect::<Json>()).collect(),
        Value::Layers(value) => layers(value),
        Value::Mesh(mesh) => json!({
            "vertices": mesh.vertices().iter().map(|vertex| point(vertex)).collect::<Json>(),
            "triangles": mesh.triangles(),
        }),
        Value::Defects(_, defects) => defects.iter().map(defect).collect(),
        Value::List(values) => values.iter().map(|value| encode(value, weighted)).collect::<Result<Json, _>>()?,
        Value::Record(fields) => record(fields)?,
        Value::Expressions(expressions) => expressions.iter().map(|expression| json!(expression.to_string())).collect(),
        Value::Variables(symbols) => symbols.iter().map(|symbol| json!(symbol.to_string())).collect(),
        Value::Map(_) | Value::Nothing => Json::Null,
    })
}

/// One coordinate as an object from products, such as `t1*t2`, to
/// coefficients; the factors stand in the order of the arguments.
fn polar_map<C: Coefficient>(polar: &PolarForm<C>, coordinate: usize, weights: bool) -> Result<Json, Error> {
    let limit = Notation::MAX_EXPANDED_TERMS;
    if polar.term_count(coordinate) > crate::exact::Rational::from(limit) {
        return Err(Error::TooLarge { what: "number of terms of the polar form", limit });
    }
    let reading = polar.reading();
    let name = |term: &PolarTerm| {
        let kept = term.iter().filter(|factor| weights || factor.2 > 0);
        let factors: Vec<String> = kept.map(|&(group, argument, c)| reading.symbol(group, argument, c).to_string()).collect();
        if factors.is_empty() { "1".to_owned() } else { factors.join("*") }
    };
    let mut map = Map::new();
    for (exponents, coefficient) in polar.terms(coordinate) {
        map.extend(reading.terms(&exponents).iter().map(|term| (name(term), number(coefficient))));
    }
    Ok(Json::Object(map))
}

fn defect(defect: &PolarDefect) -> Json {
    match defect {
        PolarDefect::NotSymmetric { coordinate, group, arguments: (first, second), difference } => json!({
            "kind": "not-symmetric", "coordinate": coordinate, "group": group, "arguments": [first, second],
            "difference": difference.to_string()
        }),
        PolarDefect::NotAffine { coordinate, group, argument, degree } => {
            json!({"kind": "not-affine", "coordinate": coordinate, "group": group, "argument": argument, "degree": degree})
        }
        PolarDefect::WrongDiagonal { coordinate, difference } => {
            json!({"kind": "wrong-diagonal", "coordinate": coordinate, "difference": difference.to_string()})
        }
    }
}
