//! Answers as LaTeX.

use super::finding;
use super::formula::Notation;
use super::title;
use crate::kernel::coefficient::Coefficient;
use crate::piece::Piece;
use crate::scheme::polar_label;
use crate::value::{Answer, Arguments, Value};

/// The answer as the lines of an `aligned` block, ready to paste between `$$`.
///
/// # Errors
/// A message if the answer has no formula to typeset, or one that is too long.
pub fn latex<C: Coefficient>(arguments: &Arguments<C>, answer: &Answer<C>, notation: &Notation) -> Result<String, String> {
    let mut lines = Vec::new();
    if let Some(finding) = &answer.finding {
        lines = finding::formulas(finding, notation);
    }
    for (name, value) in answer.fields.iter().filter(|_| answer.finding.is_none()) {
        field(name, value, arguments, answer.weighted, notation, &mut lines)?;
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
    weighted: bool,
    notation: &Notation,
    lines: &mut Vec<String>,
) -> Result<(), String> {
    match value {
        Value::Polar(polar) => {
            notation.check_expansion(polar)?;
            for coordinate in 0..polar.dimension() {
                let head = format!("{}({})", notation.name('f', coordinate, polar.dimension()), notation.arguments(polar.reading()));
                let body = notation.polar(polar, coordinate);
                lines.push(format!("{head} &= {body}"));
            }
        }
        Value::Curve(curve) if weighted => {
            let all: Vec<String> = (0..curve.dimension()).map(|index| notation.coordinate(curve, index)).collect();
            quotients(&format!("({})", notation.variable), &all, notation, lines);
        }
        Value::Surface(surface) if weighted => {
            let all: Vec<String> = (0..surface.dimension()).map(|index| notation.surface_coordinate(surface, index)).collect();
            quotients(&format!("({})", notation.variables.map(|variable| variable.to_string()).join(",")), &all, notation, lines);
        }
        Value::Curve(curve) => {
            let head = notation.heading(arguments, name).unwrap_or_else(|| "F".to_owned());
            let (letter, rest) = head.split_at(1);
            for coordinate in 0..curve.dimension() {
                let indexed = notation.name(letter.chars().next().unwrap_or('F'), coordinate, curve.dimension());
                lines.push(format!("{indexed}{rest} &= {}", notation.coordinate(curve, coordinate)));
            }
        }
        Value::HomogeneousPolar(polar) => {
            for coordinate in 0..polar.dimension() {
                let head = notation.name('f', coordinate, polar.dimension());
                lines.push(format!("{head} &= {}", notation.homogeneous_polar(polar, coordinate)));
            }
        }
        Value::Homogeneous(form) => lines.push(format!("\\text{{{name}}} &= {}", notation.homogeneous(form))),
        Value::Surface(surface) => {
            let head = notation.heading(arguments, name).unwrap_or_else(|| "F".to_owned());
            let (letter, rest) = head.split_at(1);
            for coordinate in 0..surface.dimension() {
                let indexed = notation.name(letter.chars().next().unwrap_or('F'), coordinate, surface.dimension());
                lines.push(format!("{indexed}{rest} &= {}", notation.surface_coordinate(surface, coordinate)));
            }
        }
        Value::Net(value) if name == "points" => net(value, weighted, notation, lines),
        Value::Net(value) => {
            lines.push(format!("\\text{{{name}:}}"));
            piece(value, weighted, notation, lines);
        }
        Value::Counts(counts) => {
            let list: Vec<String> = counts.iter().map(usize::to_string).collect();
            lines.push(format!("\\text{{{}}} &= ({})", title(name), list.join(", ")));
        }
        Value::Word(word) => lines.push(format!("\\text{{{}: {word}}}", title(name))),
        Value::Nothing if name == "point" => lines.push("\\text{the point is at infinity}".to_owned()),
        Value::Nothing if matches!(name, "ast" | "rat" | "rsa") => lines.push(format!("\\text{{{name}: flat}}")),
        Value::Nothing if matches!(name, "ll" | "rl" | "lr" | "rr") => lines.push(format!("\\text{{{name}: without width}}")),
        Value::Piece(value) => piece(value, weighted, notation, lines),
        Value::Pieces(pieces) => pieces.iter().for_each(|value| piece(value, weighted, notation, lines)),
        Value::Layers(layers) => {
            for (label, point) in layers.layers.iter().flatten().flatten() {
                lines.push(format!("{} &= {}", subscripts(label), shown(point, weighted, notation)));
            }
        }
        Value::Matrix(rows) => lines.push(format!("\\text{{{}}} &= {}", title(name), matrix(rows, notation))),
        Value::Numbers(numbers) if name == "barycentric" => {
            let list: Vec<String> = numbers.iter().map(|number| notation.number(number)).collect();
            lines.push(format!("(\\lambda, \\mu, \\nu) &= {}", crate::syntax::printer::point(&list, notation.style)));
        }
        Value::Number(number) => lines.push(format!("\\text{{{}}} &= {}", title(name), notation.number(number))),
        Value::Count(count) => lines.push(format!("\\text{{{}}} &= {count}", title(name))),
        Value::Truth(truth) => {
            lines.push(format!("\\text{{{}: {}}}", title(name), if *truth { "yes" } else { "no" }));
        }
        Value::Scheme(scheme) => {
            for j in 0..=scheme.degree() {
                for (i, point) in scheme.layer(j).enumerate() {
                    lines.push(format!("{} &= {}", scheme.label(i, j), shown(point, weighted, notation)));
                }
            }
        }
        Value::Point(point) => {
            let head = notation.heading(arguments, name).unwrap_or_else(|| format!("\\text{{{}}}", title(name)));
            lines.push(format!("{head} &= {}", shown(point, weighted, notation)));
        }
        Value::Points(points) if !matches!(name, "left" | "right") => {
            lines.extend(points.iter().map(|point| notation.point(point)));
        }
        Value::Numbers(numbers) if name == "values" => {
            lines.extend(numbers.iter().enumerate().map(|(k, number)| format!("\\sigma_{{{k}}} &= {}", notation.number(number))));
        }
        Value::List(values) if name == "order" => {
            for value in values {
                if let Value::Counts(index) = value
                    && let [i, j, k] = index.as_slice()
                {
                    lines.push(format!("b_{{{i},{j},{k}}} &= {}", polar_label(&[("r", *i), ("s", *j), ("t", *k)])));
                }
            }
        }
        Value::List(values) => {
            for value in values {
                field(name, value, arguments, weighted, notation, lines)?;
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
    if let (Some(Value::Word(symmetry)), Some(Value::Word(relation)), Some(Value::Truth(kept))) =
        (get("symmetry"), get("relation"), get("invariant"))
    {
        let kept = if *kept { " = X(u, v)" } else { "" };
        lines.push(format!("\\text{{{symmetry}}} &: {relation}{kept}"));
        return Ok(());
    }
    if let Some(Value::Count(multiplicity)) = get("multiplicity") {
        let place = match (get("t"), get("between")) {
            (Some(Value::Number(exact)), _) => format!("{} &= {}", notation.variable, notation.number(exact)),
            (_, Some(Value::Numbers(ends))) if ends.len() == 2 => {
                format!("{} &\\in \\left({}, {}\\right)", notation.variable, notation.number(&ends[0]), notation.number(&ends[1]))
            }
            _ => return Ok(()),
        };
        let times = if *multiplicity > 1 { format!("\\; \\text{{({multiplicity} times)}}") } else { String::new() };
        lines.push(place + &times);
        return Ok(());
    }
    let (index, letters, body) = match (get("index"), get("polynomial")) {
        (Some(Value::Count(k)), Some(Value::Curve(curve))) => (k.to_string(), notation.variable.to_string(), notation.curve(curve)),
        (Some(Value::Counts(index)), Some(Value::Surface(surface))) => (
            index.iter().map(usize::to_string).collect::<Vec<_>>().join(","),
            notation.variables.map(|variable| variable.to_string()).join(","),
            notation.surface(surface),
        ),
        _ => return fields.iter().try_for_each(|(name, value)| field(name, value, arguments, false, notation, lines)),
    };
    lines.push(format!("B_{{{index}}}({letters}) &= {body}"));
    if let Some(Value::Record(maximum)) = get("maximum")
        && let [(_, at), (_, Value::Number(value))] = maximum.as_slice()
    {
        let at = match at {
            Value::Number(t) => notation.number(t),
            Value::Point(place) => place.iter().map(|number| notation.number(number)).collect::<Vec<_>>().join(","),
            _ => String::new(),
        };
        lines.push(format!("\\max B_{{{index}}} = B_{{{index}}}({at}) &= {}", notation.number(value)));
    }
    if let (Some(Value::Number(value)), Ok(t)) = (get("value"), arguments.numbers("t")) {
        let at: Vec<String> = t.iter().map(|number| notation.number(number)).collect();
        lines.push(format!("B_{{{index}}}({}) &= {}", at.join(","), notation.number(value)));
    }
    Ok(())
}

/// The coordinates of a rational map over the last one.
fn quotients(rest: &str, all: &[String], notation: &Notation, lines: &mut Vec<String>) {
    let Some((weight, coordinates)) = all.split_last() else { return };
    for (index, coordinate) in coordinates.iter().enumerate() {
        let name = notation.name('F', index, coordinates.len());
        lines.push(format!("{name}{rest} &= \\frac{{{coordinate}}}{{{weight}}}"));
    }
}

fn shown<C: Coefficient>(point: &[C], weighted: bool, notation: &Notation) -> String {
    if weighted { notation.weighted(point) } else { notation.point(point) }
}

/// A label such as `f(r1;s2)` with its indices as subscripts.
pub(super) fn subscripts(label: &str) -> String {
    let mut text = String::new();
    for letter in label.chars() {
        match letter {
            '1' => text.push_str("_1"),
            '2' => text.push_str("_2"),
            other => text.push(other),
        }
    }
    text
}

fn matrix<C: Coefficient>(rows: &[Vec<C>], notation: &Notation) -> String {
    let row = |row: &Vec<C>| row.iter().map(|number| notation.number(number)).collect::<Vec<_>>().join(" & ");
    format!("\\begin{{pmatrix}} {} \\end{{pmatrix}}", rows.iter().map(row).collect::<Vec<_>>().join(" \\\\ "))
}

fn piece<C: Coefficient>(value: &Piece<C>, weighted: bool, notation: &Notation, lines: &mut Vec<String>) {
    let numbers: Vec<String> = value.frame().numbers().into_iter().map(|number| notation.number(number)).collect();
    lines.push(match value {
        Piece::Curve(_) => format!("r = {},\\; s &= {}", numbers[0], numbers[1]),
        Piece::Triangle(_) => {
            format!("r = ({},{}),\\; s = ({},{}),\\; t &= ({},{})", numbers[0], numbers[1], numbers[2], numbers[3], numbers[4], numbers[5])
        }
        Piece::Rectangle(_) => {
            format!("r_1 = {},\\; s_1 = {},\\; r_2 = {},\\; s_2 &= {}", numbers[0], numbers[1], numbers[2], numbers[3])
        }
    });
    net(value, weighted, notation, lines);
}

fn net<C: Coefficient>(piece: &Piece<C>, weighted: bool, notation: &Notation, lines: &mut Vec<String>) {
    let is_rectangle = matches!(piece, Piece::Rectangle(_));
    for (label, point) in piece.labels().into_iter().zip(piece.points()) {
        let label = if is_rectangle { subscripts(&label) } else { label };
        lines.push(format!("{label} &= {}", shown(point, weighted, notation)));
    }
}
