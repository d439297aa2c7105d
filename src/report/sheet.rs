//! Answers as LaTeX.

use super::formula::Notation;
use crate::kernel::coefficient::Coefficient;
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
            notation.check_expansion(polar)?;
            for coordinate in 0..polar.dimension() {
                let head = format!("{}({})", notation.name('f', coordinate, polar.dimension()), notation.arguments(polar.degree()));
                let body = notation.polar(polar, coordinate);
                lines.push(format!("{head} &= {body}"));
            }
        }
        Value::Curve(curve) => {
            let head = notation.heading(arguments, name).unwrap_or_else(|| "F".to_owned());
            let (letter, rest) = head.split_at(1);
            for coordinate in 0..curve.dimension() {
                let indexed = notation.name(letter.chars().next().unwrap_or('F'), coordinate, curve.dimension());
                lines.push(format!("{indexed}{rest} &= {}", notation.coordinate(curve, coordinate)));
            }
        }
        Value::Net(segment) => net(segment, notation, lines),
        Value::Piece(segment) => piece(segment, notation, lines),
        Value::Pieces(pieces) => pieces.iter().for_each(|segment| piece(segment, notation, lines)),
        Value::Count(count) => lines.push(format!("\\text{{{}}} &= {count}", name.replace('_', " "))),
        Value::Truth(truth) => {
            lines.push(format!("\\text{{{}: {}}}", name.replace('_', " "), if *truth { "yes" } else { "no" }));
        }
        Value::Scheme(scheme) => {
            for j in 0..=scheme.degree() {
                for (i, point) in scheme.layer(j).enumerate() {
                    lines.push(format!("{} &= {}", scheme.label(i, j), notation.point(point)));
                }
            }
        }
        Value::Point(point) => {
            let head = notation.heading(arguments, name).unwrap_or_else(|| format!("\\text{{{}}}", name.replace('_', " ")));
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
        Value::Record(fields) => record(fields, arguments, notation, lines)?,
        _ => {}
    }
    Ok(())
}

/// A Bernstein polynomial with what is known of it, or the named parts one by one.
fn record<C: Coefficient>(
    fields: &[(&'static str, Value<C>)],
    arguments: &Arguments<C>,
    notation: &Notation,
    lines: &mut Vec<String>,
) -> Result<(), String> {
    let get = |name: &str| fields.iter().find(|(key, _)| *key == name).map(|(_, value)| value);
    let (Some(Value::Count(index)), Some(Value::Curve(curve))) = (get("index"), get("polynomial")) else {
        return fields.iter().try_for_each(|(name, value)| field(name, value, arguments, notation, lines));
    };
    lines.push(format!("B_{{{index}}}({}) &= {}", notation.variable, notation.curve(curve)));
    if let Some(Value::Record(maximum)) = get("maximum")
        && let [(_, Value::Number(t)), (_, Value::Number(value))] = maximum.as_slice()
    {
        lines.push(format!("\\max B_{{{index}}} = B_{{{index}}}({}) &= {}", notation.number(t), notation.number(value)));
    }
    if let (Some(Value::Number(value)), Ok(t)) = (get("value"), arguments.number("t")) {
        lines.push(format!("B_{{{index}}}({}) &= {}", notation.number(t), notation.number(value)));
    }
    Ok(())
}

fn piece<C: Coefficient>(segment: &Segment<C>, notation: &Notation, lines: &mut Vec<String>) {
    let (r, s) = (segment.frame().r(), segment.frame().s());
    lines.push(format!("r = {},\\; s &= {}", notation.number(r), notation.number(s)));
    net(segment, notation, lines);
}

fn net<C: Coefficient>(segment: &Segment<C>, notation: &Notation, lines: &mut Vec<String>) {
    for (i, point) in segment.points().enumerate() {
        let label = segment.label(i);
        lines.push(format!("{label} &= {}", notation.point(point)));
    }
}
