//! Answers as people read them.

use super::decimal::decimal;
use super::formula::Notation;
use crate::affine::Interval;
use crate::blossom::{PolarDefect, PolarForm};
use crate::exact::Rational;
use crate::kernel::coefficient::Coefficient;
use crate::scheme::Scheme;
use crate::segment::Segment;
use crate::syntax::printer;
use crate::value::{Answer, Arguments, Value};

/// The answer to an operation, as lines of text ending in a line end.
///
/// # Errors
/// A message if a polar form has more terms than are ever written out.
pub fn text<C: Coefficient>(arguments: &Arguments<C>, answer: &Answer<C>, notation: &Notation) -> Result<String, String> {
    let mut page = Page { notation, arguments, lines: Vec::new() };
    for (name, value) in &answer.fields {
        page.field(name, value, answer.fields.len() > 1)?;
    }
    let mut text = page.lines.join("\n");
    text.push('\n');
    Ok(text)
}

struct Page<'a, C> {
    notation: &'a Notation,
    arguments: &'a Arguments<C>,
    lines: Vec<String>,
}

impl<C: Coefficient> Page<'_, C> {
    fn field(&mut self, name: &str, value: &Value<C>, named: bool) -> Result<(), String> {
        let title = match name {
            "distinct_roots_open" => "roots inside the frame".to_owned(),
            "roots_with_multiplicity_open" => "counted with multiplicity".to_owned(),
            _ => name.replace('_', " "),
        };
        match value {
            Value::Truth(truth) => self.truth(name, &title, *truth),
            Value::Count(count) => self.lines.push(format!("{title}: {count}")),
            Value::Word(word) => self.lines.push(format!("{title}: {word}")),
            Value::Number(number) => {
                self.lines.push(format!("{title}: {}{}", self.notation.number(number), self.approximately(std::slice::from_ref(number))))
            }
            Value::Numbers(numbers) => self.numbers(name, &title, numbers),
            Value::Point(point) => {
                let heading = self.notation.heading(self.arguments, name).unwrap_or(title);
                let equals = if heading.contains('(') { " =" } else { ":" };
                self.lines.push(format!("{heading}{equals} {}{}", self.notation.point(point), self.approximately(point)));
            }
            // The ends of the scheme repeat what its table shows.
            Value::Points(_) if matches!(name, "left" | "right") => {}
            Value::Points(points) => {
                if named {
                    self.lines.push(format!("{title}:"));
                }
                for point in points {
                    self.lines.push(format!("{}{}", self.notation.point(point), self.approximately(point)));
                }
            }
            Value::Frame(frame) => self.lines.push(format!("{title}: {frame}")),
            Value::Curve(curve) => {
                let heading = self.notation.heading(self.arguments, name).unwrap_or_else(|| format!("F({})", self.notation.variable));
                self.lines.push(format!("{heading} = {}", self.notation.curve(curve)));
            }
            Value::Net(segment) => self.net(segment),
            Value::Piece(segment) => self.piece(segment),
            Value::Pieces(pieces) => pieces.iter().for_each(|piece| self.piece(piece)),
            Value::Polar(polar) => self.polar(polar)?,
            Value::Scheme(scheme) => self.scheme(scheme),
            Value::Defects(defects) => defects.iter().for_each(|defect| self.defect(defect)),
            Value::Document(text) => self.lines.push(text.trim_end().to_owned()),
            Value::List(values) => {
                for value in values {
                    self.item(value)?;
                }
            }
            Value::Record(fields) => {
                let parts: Vec<String> =
                    fields.iter().map(|(name, value)| format!("{} {}", name.replace('_', " "), self.inline(value))).collect();
                self.lines.push(format!("{title}: {}", parts.join(", ")));
            }
            Value::Nothing | Value::Arguments(_) | Value::Map(_) | Value::Expressions(_) | Value::Variable(_) => {}
        }
        Ok(())
    }

    /// Decimals behind an exact point, if asked for.
    fn approximately(&self, point: &[C]) -> String {
        let Some(places) = self.notation.decimals else { return String::new() };
        let numbers: Option<Vec<Rational>> = point.iter().map(Coefficient::as_rational).collect();
        match numbers {
            Some(numbers) if numbers.iter().any(|number| !number.is_integer()) => {
                let decimals: Vec<String> = numbers.iter().map(|number| decimal(number, places)).collect();
                match decimals.as_slice() {
                    [only] => format!(" ≈ {only}"),
                    several => format!(" ≈ ({})", several.join(", ")),
                }
            }
            _ => String::new(),
        }
    }

    fn truth(&mut self, name: &str, title: &str, truth: bool) {
        let answer = if truth { "yes" } else { "no" };
        self.lines.push(match (name, truth) {
            ("holds", true) => "this is the polar form: symmetric, affine in every argument, and right on the diagonal".to_owned(),
            ("holds", false) => "this is not the polar form:".to_owned(),
            ("equal", true) => "the same polynomial map".to_owned(),
            ("equal", false) => "different polynomial maps".to_owned(),
            ("inside", true) => "inside the frame".to_owned(),
            ("inside", false) => "outside the frame".to_owned(),
            _ => format!("{title}: {answer}"),
        });
    }

    fn numbers(&mut self, name: &str, title: &str, numbers: &[C]) {
        if name == "values" {
            for (k, number) in numbers.iter().enumerate() {
                self.lines.push(format!("σ{k} = {}{}", self.notation.number(number), self.approximately(std::slice::from_ref(number))));
            }
        } else {
            self.lines.push(format!("{title}: {}", self.inline(&Value::Numbers(numbers.to_vec()))));
        }
    }

    fn polar(&mut self, polar: &PolarForm<C>) -> Result<(), String> {
        self.notation.check_expansion(polar)?;
        let degree = polar.degree();
        let mut all_written_out = true;
        for coordinate in 0..polar.dimension() {
            let written_out = self.notation.writes_out(polar, coordinate);
            all_written_out &= written_out;
            let name = self.notation.name('f', coordinate, polar.dimension());
            self.lines.push(format!("{name}({}) = {}", self.notation.arguments(degree), self.notation.polar(polar, coordinate)));
        }
        if !all_written_out {
            self.lines.push(format!("(σk is the sum of all products of k of the {degree} arguments; --expand writes them out)"));
        }
        Ok(())
    }

    fn net(&mut self, segment: &Segment<C>) {
        let labels: Vec<String> = (0..=segment.degree()).map(|i| segment.label(i)).collect();
        let width = labels.iter().map(|label| label.chars().count()).max().unwrap_or(0);
        for (label, point) in labels.iter().zip(segment.points()) {
            self.lines.push(format!("{label:width$} = {}{}", self.notation.point(point), self.approximately(point)));
        }
    }

    fn piece(&mut self, segment: &Segment<C>) {
        self.lines.push(format!("over {}..{}:", self.notation.number(segment.frame().r()), self.notation.number(segment.frame().s())));
        let start = self.lines.len();
        self.net(segment);
        for line in &mut self.lines[start..] {
            line.insert_str(0, "  ");
        }
    }

    /// Whether the parameter of a scheme lies in the closed frame, so that all
    /// points are convex combinations; symbols do not tell.
    fn is_inside(&self, scheme: &Scheme<C>) -> Option<bool> {
        let frame = scheme.frame();
        let frame = Interval::new(frame.r().as_rational()?, frame.s().as_rational()?).ok()?;
        Some(frame.contains(&scheme.parameter().as_rational()?))
    }

    /// The triangular scheme: a column a step, each point between the two it comes from.
    fn scheme(&mut self, scheme: &Scheme<C>) {
        let degree = scheme.degree();
        let cell = |i: usize, j: usize| {
            format!("{} = {}{}", scheme.label(i, j), self.notation.point(scheme.get(i, j)), self.approximately(scheme.get(i, j)))
        };
        let columns: Vec<Vec<String>> = (0..=degree).map(|j| (0..=degree - j).map(|i| cell(i, j)).collect()).collect();
        let widths: Vec<usize> = columns.iter().map(|column| column.iter().map(|text| text.chars().count()).max().unwrap_or(0)).collect();
        let frame = format!(
            "r = {}, s = {}, t = {}",
            self.notation.number(scheme.frame().r()),
            self.notation.number(scheme.frame().s()),
            self.notation.number(scheme.parameter())
        );
        let frame = match self.is_inside(scheme) {
            Some(true) => format!("{frame} (inside the frame)"),
            Some(false) => format!("{frame} (outside the frame)"),
            None => frame,
        };
        self.lines.push(frame);
        if widths.iter().sum::<usize>() > 160 {
            // Too wide for a triangle: one step after the other.
            for (j, column) in columns.iter().enumerate() {
                self.lines.push(format!("step {j}:"));
                self.lines.extend(column.iter().map(|text| format!("  {text}")));
            }
            return;
        }
        for row in 0..=2 * degree {
            let mut line = String::new();
            for (j, column) in columns.iter().enumerate() {
                let text = match row.checked_sub(j) {
                    Some(offset) if offset % 2 == 0 => column.get(offset / 2).map_or("", String::as_str),
                    _ => "",
                };
                line += text;
                line.extend(std::iter::repeat_n(' ', widths[j] + 3 - text.chars().count()));
            }
            self.lines.push(line.trim_end().to_owned());
        }
    }

    fn defect(&mut self, defect: &PolarDefect) {
        let style = self.notation.style;
        let text = match defect {
            PolarDefect::NotSymmetric { coordinate, arguments: (a, b), difference } => format!(
                "coordinate {}: not symmetric: exchanging t{a} and t{b} changes it by {}",
                coordinate + 1,
                printer::polynomial(difference, &[], style)
            ),
            PolarDefect::NotAffine { coordinate, argument, degree } => {
                format!("coordinate {}: not affine in t{argument}: it has degree {degree} in it", coordinate + 1)
            }
            PolarDefect::WrongDiagonal { coordinate, difference } => format!(
                "coordinate {}: wrong on the diagonal: with all arguments equal to {} it exceeds the curve by {}",
                coordinate + 1,
                self.notation.variable,
                printer::polynomial(difference, &[self.notation.variable], style)
            ),
        };
        self.lines.push(text);
    }

    /// One entry of a list of records.
    fn item(&mut self, value: &Value<C>) -> Result<(), String> {
        match value {
            Value::Record(fields) => {
                let get = |name: &str| fields.iter().find(|(key, _)| *key == name).map(|(_, value)| value);
                if let Some(Value::Count(multiplicity)) = get("multiplicity") {
                    let letter = self.notation.variable;
                    let place = match (get("t"), get("between")) {
                        (Some(exact), _) => format!("{letter} = {}", self.inline(exact)),
                        (_, Some(Value::Numbers(ends))) if ends.len() == 2 => {
                            format!("{} < {letter} < {}", self.notation.number(&ends[0]), self.notation.number(&ends[1]))
                        }
                        _ => String::new(),
                    };
                    let times = if *multiplicity > 1 { format!(" ({multiplicity} times)") } else { String::new() };
                    self.lines.push(format!("{place}{times}"));
                    return Ok(());
                }
                match (get("index"), get("polynomial")) {
                    (Some(Value::Count(index)), Some(Value::Curve(curve))) => {
                        let mut line = format!("B{index}({}) = {}", self.notation.variable, self.notation.curve(curve));
                        if let Some(Value::Record(maximum)) = get("maximum") {
                            let parts: Vec<String> = maximum.iter().map(|(_, value)| self.inline(value)).collect();
                            line += &format!(", largest at {} where it is {}", parts[0], parts[1]);
                        }
                        if let (Some(Value::Number(value)), Ok(t)) = (get("value"), self.arguments.number("t")) {
                            line += &format!(
                                ", B{index}({}) = {}{}",
                                self.notation.number(t),
                                self.notation.number(value),
                                self.approximately(std::slice::from_ref(value))
                            );
                        }
                        self.lines.push(line);
                    }
                    _ => {
                        let parts: Vec<String> =
                            fields.iter().map(|(name, value)| format!("{} {}", name.replace('_', " "), self.inline(value))).collect();
                        self.lines.push(parts.join(", "));
                    }
                }
                Ok(())
            }
            other => self.field("", other, false),
        }
    }

    fn inline(&self, value: &Value<C>) -> String {
        match value {
            Value::Number(number) => format!("{}{}", self.notation.number(number), self.approximately(std::slice::from_ref(number))),
            Value::Point(point) => format!("{}{}", self.notation.point(point), self.approximately(point)),
            Value::Count(count) => count.to_string(),
            Value::Numbers(numbers) => {
                numbers.iter().map(|number| self.inline(&Value::Number(number.clone()))).collect::<Vec<_>>().join(" and ")
            }
            _ => String::new(),
        }
    }
}
