//! Answers as people read them.

mod item;
mod net;

use super::finding;
use super::formula::Notation;
use super::title;
use crate::blossom::PolarForm;
use crate::draw::obj;
use crate::kernel::coefficient::Coefficient;
use crate::reading::Reading;
use crate::scheme::polar_label;
use crate::syntax::printer;
use crate::value::{Answer, Arguments, Value};
use crate::weights::projected;

/// The answer to an operation, as lines of text ending in a line end.
///
/// # Errors
/// A message if a polar form has more terms than are ever written out.
pub fn text<C: Coefficient>(arguments: &Arguments<C>, answer: &Answer<C>, notation: &Notation) -> Result<String, String> {
    if let Some(finding) = &answer.finding {
        return Ok(finding::text(finding, notation));
    }
    let mut page = Page { notation, arguments, weighted: answer.weighted, lines: Vec::new() };
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
    weighted: bool,
    lines: Vec<String>,
}

impl<C: Coefficient> Page<'_, C> {
    pub(super) fn field(&mut self, name: &str, value: &Value<C>, named: bool) -> Result<(), String> {
        let title = title(name);
        match value {
            Value::Truth(truth) => self.truth(name, &title, *truth),
            Value::Count(count) => self.lines.push(format!("{title}: {count}")),
            Value::Integer(number) => self.lines.push(format!("{title}: {number}")),
            Value::Counts(counts) => self.lines.push(format!("{title}: ({})", join(counts))),
            // The place says more than whether it is inside.
            Value::Word("vertex") if name == "place" => self.lines.push("on a vertex".to_owned()),
            Value::Word("edge") if name == "place" => self.lines.push("on an edge".to_owned()),
            Value::Word(_) if name == "place" => {}
            Value::Word(word) => self.lines.push(format!("{title}: {word}")),
            Value::Number(number) => {
                self.lines.push(format!("{title}: {}{}", self.notation.number(number), self.approximately(std::slice::from_ref(number))))
            }
            Value::Numbers(numbers) => self.numbers(name, &title, numbers),
            Value::Surd(surd) => self.lines.push(format!("{title}: {}", self.notation.surd(surd))),
            Value::Surds(surds) => self.lines.push(format!("{title}: {}", self.notation.surds(surds))),
            Value::Point(point) => {
                let heading = self.notation.heading(self.arguments, name).unwrap_or(title);
                let equals = if heading.contains('(') { " =" } else { ":" };
                self.lines.push(format!("{heading}{equals} {}", self.point(point, name != "homogeneous")));
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
            Value::Rows(rows) => {
                for point in rows.iter().flatten() {
                    self.lines.push(format!("{}{}", self.notation.point(point), self.approximately(point)));
                }
            }
            Value::Matrix(rows) => self.matrix(&title, rows),
            Value::Frame(frame) if name == "local_frame" => {
                self.lines.push(format!("X = B(x)ᵀ P B(y), where x and y run from 0 to 1 over {}", self.notation.frame(frame)));
            }
            Value::Frame(frame) => self.frame(&title, frame),
            Value::Curve(_) | Value::Surface(_) if name == "change" => {
                self.lines.push(format!("the map changes by {}", self.inline(value)));
            }
            Value::Curve(curve) if self.weighted => {
                let coordinates = (0..curve.dimension()).map(|index| self.notation.coordinate(curve, index)).collect();
                self.quotient(&self.notation.variable.to_string(), coordinates);
            }
            Value::Surface(surface) if self.weighted => {
                let coordinates = (0..surface.dimension()).map(|index| self.notation.surface_coordinate(surface, index)).collect();
                self.quotient(&self.notation.variables.map(|variable| variable.to_string()).join(","), coordinates);
            }
            Value::Curve(curve) => {
                let heading = self.notation.heading(self.arguments, name).unwrap_or_else(|| format!("F({})", self.notation.variable));
                self.lines.push(format!("{heading} = {}", self.notation.curve(curve)));
            }
            Value::Surface(surface) => {
                let names = self.notation.variables;
                let heading = self.notation.heading(self.arguments, name).unwrap_or_else(|| format!("F({},{})", names[0], names[1]));
                self.lines.push(format!("{heading} = {}", self.notation.surface(surface)));
            }
            Value::Net(piece) if name == "points" => self.net(piece),
            Value::Net(piece) => {
                self.lines.push(format!("{title}, over {}:", self.notation.frame(&piece.frame())));
                self.indented(|page| page.net(piece));
            }
            Value::Piece(piece) => self.piece(piece),
            Value::Pieces(pieces) => pieces.iter().for_each(|piece| self.piece(piece)),
            Value::Polar(polar) => {
                match (name, polar.reading()) {
                    ("total", Reading::Total(degree)) => self.lines.push(format!("by total degree {degree}:")),
                    ("tensor", Reading::Bidegree(p, q)) => self.lines.push(format!("by bidegree ({p},{q}):")),
                    _ => {}
                }
                self.polar(polar)?;
            }
            Value::HomogeneousPolar(polar) => {
                for coordinate in 0..polar.dimension() {
                    let name = self.notation.name('f', coordinate, polar.dimension());
                    self.lines.push(format!("{name} = {}", self.notation.homogeneous_polar(polar, coordinate)));
                }
            }
            Value::Homogeneous(form) => self.homogeneous(name, form),
            Value::Scheme(scheme) => self.scheme(scheme),
            Value::Layers(layers) => self.layers(layers),
            Value::Mesh(mesh) => self.lines.push(obj(mesh).trim_end().to_owned()),
            Value::Defects(reading, defects) => defects.iter().for_each(|defect| self.defect(*reading, defect)),
            Value::Document(text) if name == "label" => self.lines.push(format!("the control point {text}")),
            Value::Document(text) => self.lines.push(text.trim_end().to_owned()),
            Value::Nothing if matches!(name, "ast" | "rat" | "rsa") => {
                self.lines.push(format!("{title}: none, the triangle is flat: the point lies on the line {}", name.replace('a', "")));
            }
            Value::Nothing if matches!(name, "ll" | "rl" | "lr" | "rr") => {
                self.lines.push(format!("{title}: none, the rectangle has no width"));
            }
            Value::Nothing if name == "point" => self.lines.push("the point is at infinity: its weight is 0".to_owned()),
            Value::Record(fields) if name == "largest" => {
                let get =
                    |name: &str| fields.iter().find(|(key, _)| *key == name).map_or_else(String::new, |(_, value)| self.inline(value));
                self.lines.push(format!("largest at {}, where it is {}", get("t"), get("value")));
            }
            Value::List(values) if name == "order" => {
                for value in values {
                    if let Value::Counts(index) = value
                        && let [i, j, k] = index.as_slice()
                    {
                        let label = polar_label(&[("r", *i), ("s", *j), ("t", *k)]);
                        self.lines.push(format!("b{} = {label}", index.iter().map(usize::to_string).collect::<Vec<_>>().join(",")));
                    }
                }
            }
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
            Value::Nothing
            | Value::Arguments(_)
            | Value::PlaneArguments(_)
            | Value::Map(_)
            | Value::Expressions(_)
            | Value::Variables(_) => {}
        }
        Ok(())
    }

    /// The equation of a rational map, whose last coordinate is the weight.
    fn quotient(&mut self, variables: &str, mut coordinates: Vec<String>) {
        let weight = coordinates.pop().unwrap_or_default();
        let numerator = match coordinates.as_slice() {
            [only] => format!("({only})"),
            several => printer::point(several, self.notation.style),
        };
        self.lines.push(format!("F({variables}) = {numerator}/({weight})"));
    }

    /// A point, with its weight if `homogeneous` and control points have some.
    pub(super) fn point(&self, point: &[C], homogeneous: bool) -> String {
        if !(self.weighted && homogeneous) {
            return format!("{}{}", self.notation.point(point), self.approximately(point));
        }
        let decimals = projected(point).map_or_else(String::new, |point| self.approximately(&point));
        format!("{}{decimals}", self.notation.weighted(point))
    }

    pub(super) fn approximately(&self, point: &[C]) -> String {
        self.notation.approximately(point)
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
        if name == "barycentric" {
            let list: Vec<String> = numbers.iter().map(|number| self.notation.number(number)).collect();
            self.lines.push(format!("(λ, μ, ν) = ({}){}", list.join(", "), self.approximately(numbers)));
        } else if name == "values" {
            for (k, number) in numbers.iter().enumerate() {
                self.lines.push(format!("σ{k} = {}{}", self.notation.number(number), self.approximately(std::slice::from_ref(number))));
            }
        } else {
            self.lines.push(format!("{title}: {}", self.inline(&Value::Numbers(numbers.to_vec()))));
        }
    }

    fn polar(&mut self, polar: &PolarForm<C>) -> Result<(), String> {
        self.notation.check_expansion(polar)?;
        let mut all_written_out = true;
        for coordinate in 0..polar.dimension() {
            let written_out = self.notation.writes_out(polar, coordinate);
            all_written_out &= written_out;
            let name = self.notation.name('f', coordinate, polar.dimension());
            self.lines.push(format!("{name}({}) = {}", self.notation.arguments(polar.reading()), self.notation.polar(polar, coordinate)));
        }
        if !all_written_out {
            self.lines.push(match polar.reading() {
                Reading::Curve(degree) => {
                    format!("(σk is the sum of all products of k of the {degree} arguments; --expand writes them out)")
                }
                _ => "(σ(h,k) is the sum of all products with h first and k second coordinates; --expand writes them out)".to_owned(),
            });
        }
        Ok(())
    }
}

fn join(counts: &[usize]) -> String {
    counts.iter().map(usize::to_string).collect::<Vec<_>>().join(",")
}
