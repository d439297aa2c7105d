//! Answers as LaTeX.

use super::formula::Notation;
use crate::kernel::coefficient::Coefficient;
use crate::scheme::polar_label;
use crate::segment::Segment;
use crate::value::{Answer, Arguments, Value};

/// The answer as the lines of an `aligned` block, ready to paste between `$$`.
///
/// # Errors
/// A message if the answer has no formula to typeset, or one that is too long.
pub fn latex<C: Coefficient>(arguments: &Arguments<C>, answer: &Answer<C>, notation: &Notation) -> Result<String, String> {
    let mut lines = Vec::new();
    for (name, value) in &answer.fields {
        field(name, value, arguments, notation, &mut lines)?;
    }
    match lines.as_slice() {
        [] => Err("this answer has no formula; use --format text or json".into()),
        [only] => Ok(format!("{}\n", only.replace(" &= ", " = "))),
        several => Ok(format!("\\begin{{aligned}}\n{}\n\\end{{aligned}}\n", several.join(" \\\\\n"))),
    }
}

fn field<C: Coefficient>(
    name: &str,
    value: &Value<C>,
    arguments: &Arguments<C>,
    notation: &Notation,
    lines: &mut Vec<String>,
) -> Result<(), String> {
    match value {
        Value::Polar(polar) => {
            for coordinate in 0..polar.dimension() {
                let head = format!("{}({})", notation.name('f', coordinate, polar.dimension()), notation.arguments(polar.degree()));
                let body = notation.polar(polar, coordinate);
                lines.push(format!("{head} &= {body}"));
            }
        }
        Value::Curve(curve) => {
            let variable = crate::syntax::printer::symbol(notation.variable, notation.style);
            for coordinate in 0..curve.dimension() {
                lines.push(format!(
                    "{}({variable}) &= {}",
                    notation.name('F', coordinate, curve.dimension()),
                    notation.coordinate(curve, coordinate)
                ));
            }
        }
        Value::Net(segment) | Value::Piece(segment) => net(segment, notation, lines),
        Value::Pieces(pieces) => pieces.iter().for_each(|piece| net(piece, notation, lines)),
        Value::Scheme(scheme) => {
            for j in 0..=scheme.degree() {
                for (i, point) in scheme.layer(j).enumerate() {
                    lines.push(format!("{} &= {}", scheme.label(i, j), notation.point(point)));
                }
            }
        }
        Value::Point(point) => {
            let head = match (name, arguments.number("t")) {
                ("point", Ok(t)) => format!("F({})", notation.number(t)),
                _ => format!("\\text{{{}}}", name.replace('_', " ")),
            };
            lines.push(format!("{head} &= {}", notation.point(point)));
        }
        Value::Points(points) if !matches!(name, "left" | "right") => {
            lines.extend(points.iter().map(|point| notation.point(point)));
        }
        Value::Numbers(numbers) if name == "values" => {
            lines.extend(numbers.iter().enumerate().map(|(k, number)| format!("\\sigma_{{{k}}} &= {}", notation.number(number))));
        }
        Value::List(values) => {
            for value in values {
                field(name, value, arguments, notation, lines)?;
            }
        }
        Value::Record(fields) => {
            let index = fields.iter().find_map(|(_, value)| if let Value::Count(index) = value { Some(*index) } else { None });
            for (_, value) in fields {
                if let (Value::Curve(curve), Some(index)) = (value, index) {
                    lines.push(format!("B_{{{index}}}({}) &= {}", notation.variable, notation.curve(curve)));
                }
            }
        }
        _ => {}
    }
    Ok(())
}

fn net<C: Coefficient>(segment: &Segment<C>, notation: &Notation, lines: &mut Vec<String>) {
    let degree = segment.degree();
    for (i, point) in segment.points().enumerate() {
        let label = polar_label(&[("r", degree - i), ("s", i)]);
        lines.push(format!("{label} &= {}", notation.point(point)));
    }
}
