//! Answers as Mathematica expressions.

use super::formula::Notation;
use crate::affine::Frame;
use crate::kernel::coefficient::Coefficient;
use crate::value::{Answer, LabelledRow, Value};

/// The answer as one expression: the only part, or the list of the parts.
///
/// # Errors
/// A message if a polar form is to be written out that has too many terms.
pub fn mathematica<C: Coefficient>(answer: &Answer<C>, notation: &Notation) -> Result<String, String> {
    for (_, value) in &answer.fields {
        if let Value::Polar(polar) = value {
            notation.check_expansion(polar)?;
        }
    }
    let parts: Vec<String> = answer.fields.iter().map(|(_, value)| expression(value, notation)).collect();
    Ok(match parts.as_slice() {
        [only] => format!("{only}\n"),
        several => format!("{}\n", list(several)),
    })
}

fn list(parts: &[String]) -> String {
    format!("{{{}}}", parts.join(", "))
}

/// Points of a line stay in brackets: a net is a list of points.
fn point<C: Coefficient>(point: &[C], notation: &Notation) -> String {
    list(&point.iter().map(|coordinate| notation.number(coordinate)).collect::<Vec<_>>())
}

fn expression<C: Coefficient>(value: &Value<C>, notation: &Notation) -> String {
    let points = |points: &mut dyn Iterator<Item = &[C]>| list(&points.map(|p| point(p, notation)).collect::<Vec<_>>());
    let all = |values: &[Value<C>]| values.iter().map(|value| expression(value, notation)).collect::<Vec<_>>();
    match value {
        Value::Truth(truth) => if *truth { "True" } else { "False" }.to_owned(),
        Value::Count(count) => count.to_string(),
        Value::Integer(number) => number.to_string(),
        Value::Number(number) => notation.number(number),
        Value::Numbers(numbers) => point(numbers, notation),
        Value::Surd(surd) => notation.surd(surd),
        Value::Surds(surds) => list(&surds.iter().map(|surd| notation.surd(surd)).collect::<Vec<_>>()),
        Value::Point(value) => point(value, notation),
        Value::Points(values) => points(&mut values.iter().map(Vec::as_slice)),
        Value::Frame(Frame::Interval(frame)) => point(&[frame.r().clone(), frame.s().clone()], notation),
        Value::Frame(frame) => {
            let numbers: Vec<C> = frame.numbers().into_iter().cloned().collect();
            points(&mut numbers.chunks(2))
        }
        Value::Counts(counts) => list(&counts.iter().map(usize::to_string).collect::<Vec<_>>()),
        Value::Rows(rows) => list(&rows.iter().map(|row| points(&mut row.iter().map(Vec::as_slice))).collect::<Vec<_>>()),
        Value::Matrix(rows) => points(&mut rows.iter().map(Vec::as_slice)),
        Value::HomogeneousPolar(polar) => {
            list(&(0..polar.dimension()).map(|index| notation.homogeneous_polar(polar, index)).collect::<Vec<_>>())
        }
        Value::Homogeneous(form) => notation.homogeneous(form),
        Value::Mesh(mesh) => {
            let vertices: Vec<String> = mesh.vertices().iter().map(|vertex| point(vertex, notation)).collect();
            let corners = |triangle: &[u32; 3]| list(&triangle.map(|index| (index + 1).to_string()));
            let triangles: Vec<String> = mesh.triangles().iter().map(corners).collect();
            format!("MeshRegion[{}, Triangle[{}]]", list(&vertices), list(&triangles))
        }
        Value::Layers(layers) => {
            let row = |row: &LabelledRow<C>| points(&mut row.iter().map(|entry| entry.1.as_slice()));
            let layer = |layer: &Vec<LabelledRow<C>>| list(&layer.iter().map(row).collect::<Vec<_>>());
            list(&layers.layers.iter().map(layer).collect::<Vec<_>>())
        }
        Value::Curve(curve) => list(&(0..curve.dimension()).map(|index| notation.coordinate(curve, index)).collect::<Vec<_>>()),
        // The list of all points, row after row, as Gallier's programs take a net.
        Value::Net(piece) | Value::Piece(piece) => points(&mut piece.points()),
        Value::Pieces(pieces) => list(&pieces.iter().map(|piece| points(&mut piece.points())).collect::<Vec<_>>()),
        Value::Surface(surface) => {
            list(&(0..surface.dimension()).map(|index| notation.surface_coordinate(surface, index)).collect::<Vec<_>>())
        }
        Value::Polar(polar) => list(&(0..polar.dimension()).map(|index| notation.polar(polar, index)).collect::<Vec<_>>()),
        Value::Scheme(scheme) => list(&scheme.layers().map(|mut layer| points(&mut layer)).collect::<Vec<_>>()),
        Value::List(values) => list(&all(values)),
        Value::Record(fields) => list(&all(&fields.iter().map(|(_, value)| value.clone()).collect::<Vec<_>>())),
        Value::Word(word) => format!("\"{word}\""),
        Value::Document(text) => format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\"")),
        Value::Nothing
        | Value::Arguments(_)
        | Value::PlaneArguments(_)
        | Value::Map(_)
        | Value::Expressions(_)
        | Value::Variables(_)
        | Value::Defects(..) => "Null".to_owned(),
    }
}
