//! Answers as people read them.

use super::decimal::decimal;
use super::finding;
use super::formula::Notation;
use crate::affine::{Frame, Interval};
use crate::blossom::{PolarDefect, PolarForm};
use crate::draw::obj;
use crate::exact::Rational;
use crate::kernel::coefficient::Coefficient;
use crate::piece::Piece;
use crate::reading::Reading;
use crate::scheme::Scheme;
use crate::syntax::printer;
use crate::value::{Answer, Arguments, Homogeneous, Layers, Value};
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
    fn field(&mut self, name: &str, value: &Value<C>, named: bool) -> Result<(), String> {
        let title = match name {
            "distinct_roots_open" => "roots inside the frame".to_owned(),
            "roots_with_multiplicity_open" => "counted with multiplicity".to_owned(),
            _ => name.replace('_', " "),
        };
        match value {
            Value::Truth(truth) => self.truth(name, &title, *truth),
            Value::Count(count) => self.lines.push(format!("{title}: {count}")),
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
    fn point(&self, point: &[C], homogeneous: bool) -> String {
        if !(self.weighted && homogeneous) {
            return format!("{}{}", self.notation.point(point), self.approximately(point));
        }
        let decimals = projected(point).map_or_else(String::new, |point| self.approximately(&point));
        format!("{}{decimals}", self.notation.weighted(point))
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

    fn net(&mut self, piece: &Piece<C>) {
        let labels = piece.labels();
        let width = labels.iter().map(|label| label.chars().count()).max().unwrap_or(0);
        for (label, point) in labels.iter().zip(piece.points()) {
            self.lines.push(format!("{label:width$} = {}", self.point(point, true)));
        }
    }

    fn piece(&mut self, piece: &Piece<C>) {
        self.lines.push(format!("over {}:", self.notation.frame(&piece.frame())));
        self.indented(|page| page.net(piece));
    }

    fn indented(&mut self, write: impl FnOnce(&mut Self)) {
        let start = self.lines.len();
        write(self);
        for line in &mut self.lines[start..] {
            line.insert_str(0, "  ");
        }
    }

    fn frame(&mut self, title: &str, frame: &Frame<C>) {
        let numbers: Vec<String> = frame.numbers().into_iter().map(|number| self.notation.number(number)).collect();
        self.lines.push(match frame {
            Frame::Triangle(_) => {
                format!("r = ({}, {}), s = ({}, {}), t = ({}, {})", numbers[0], numbers[1], numbers[2], numbers[3], numbers[4], numbers[5])
            }
            _ => format!("{title}: {}", self.notation.frame(frame)),
        });
    }

    fn matrix(&mut self, title: &str, rows: &[Vec<C>]) {
        let cells: Vec<Vec<String>> = rows.iter().map(|row| row.iter().map(|number| self.notation.number(number)).collect()).collect();
        let columns = cells.first().map_or(0, Vec::len);
        let widths: Vec<usize> = (0..columns).map(|k| cells.iter().map(|row| row[k].chars().count()).max().unwrap_or(0)).collect();
        self.lines.push(format!("{title}:"));
        for row in cells {
            let padded: Vec<String> = row.iter().zip(&widths).map(|(cell, &width)| format!("{cell:>width$}")).collect();
            self.lines.push(format!("  [ {} ]", padded.join("  ")));
        }
    }

    fn homogeneous(&mut self, name: &str, form: &Homogeneous<C>) {
        let degree = |places: &[usize]| {
            let of = |term: &(Vec<usize>, C)| places.iter().map(|&place| term.0[place]).sum::<usize>();
            form.terms.first().map_or(0, of)
        };
        let text = self.notation.homogeneous(form);
        self.lines.push(match name {
            "total" => {
                let m = degree(&[0, 1, 2]);
                format!("by total degree {m}, u/c and v/c, times c^{m}, which is the weight: {text}")
            }
            _ => {
                let (p, q) = (degree(&[0, 1]), degree(&[2, 3]));
                format!("by bidegree ({p},{q}), u/a and v/b, times a^{p} b^{q}, which is the weight: {text}")
            }
        });
    }

    /// The steps on a patch: under a heading for each layer its rows, aligned.
    fn layers(&mut self, layers: &Layers<C>) {
        for (number, layer) in layers.layers.iter().enumerate() {
            let cell = |(label, point): &(String, Vec<C>)| format!("{label} = {}", self.point(point, true));
            let cells: Vec<Vec<String>> = layer.iter().map(|row| row.iter().map(cell).collect()).collect();
            let columns = cells.iter().map(Vec::len).max().unwrap_or(0);
            let width = |column: usize| cells.iter().filter_map(|row| row.get(column)).map(|text| text.chars().count()).max().unwrap_or(0);
            let widths: Vec<usize> = (0..columns).map(width).collect();
            let fits = widths.iter().sum::<usize>() + 3 * columns <= 160;
            self.lines.push(format!("{} {number}:", layers.name));
            for row in cells {
                if !fits {
                    self.lines.extend(row.into_iter().map(|text| format!("  {text}")));
                    continue;
                }
                let mut line = String::from(" ");
                for (text, &width) in row.iter().zip(&widths) {
                    line += &format!(" {text}");
                    line.extend(std::iter::repeat_n(' ', width + 2 - text.chars().count()));
                }
                self.lines.push(line.trim_end().to_owned());
            }
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
        let cell = |i: usize, j: usize| format!("{} = {}", scheme.label(i, j), self.point(scheme.get(i, j), true));
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

    fn defect(&mut self, reading: Reading, defect: &PolarDefect) {
        let style = self.notation.style;
        let text = match defect {
            PolarDefect::NotSymmetric { coordinate, group, arguments: (a, b), difference } => format!(
                "coordinate {}: not symmetric: exchanging {} and {} changes it by {}",
                coordinate + 1,
                reading.argument(*group, *a),
                reading.argument(*group, *b),
                printer::polynomial(difference, &[], style)
            ),
            PolarDefect::NotAffine { coordinate, group, argument, degree } => {
                let argument = reading.argument(*group, *argument);
                format!("coordinate {}: not affine in {argument}: it has degree {degree} in it", coordinate + 1)
            }
            PolarDefect::WrongDiagonal { coordinate, difference } => {
                let (what, variables) = match reading {
                    Reading::Curve(_) => ("curve", vec![self.notation.variable]),
                    _ => ("surface", self.notation.variables.to_vec()),
                };
                let place = variables.iter().map(ToString::to_string).collect::<Vec<_>>().join(",");
                let place = if variables.len() > 1 { format!("({place})") } else { place };
                format!(
                    "coordinate {}: wrong on the diagonal: with all arguments equal to {place} it exceeds the {what} by {}",
                    coordinate + 1,
                    printer::polynomial(difference, &variables, style)
                )
            }
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
                if let (Some(index), Some(polynomial)) = (get("index"), get("polynomial")) {
                    self.basis_function(index, polynomial, get("maximum"), get("value"));
                } else if let (
                    Some(Value::Word(name)),
                    Some(Value::Word(relation)),
                    Some(Value::Counts(degree)),
                    Some(Value::Truth(kept)),
                ) = (get("symmetry"), get("relation"), get("degree"), get("invariant"))
                {
                    let kept = if *kept { ", which leaves this net as it is" } else { "" };
                    self.lines.push(format!("{name:17}  {relation:11}  of bidegree ({}){kept}", join(degree)));
                } else if fields.iter().all(|(_, value)| matches!(value, Value::Matrix(_) | Value::Homogeneous(_))) {
                    for (name, value) in fields {
                        self.field(name, value, true)?;
                    }
                } else {
                    let parts: Vec<String> =
                        fields.iter().map(|(name, value)| format!("{} {}", name.replace('_', " "), self.inline(value))).collect();
                    self.lines.push(parts.join(", "));
                }
                Ok(())
            }
            other => self.field("", other, false),
        }
    }

    fn basis_function(&mut self, index: &Value<C>, polynomial: &Value<C>, maximum: Option<&Value<C>>, value: Option<&Value<C>>) {
        let (name, body) = match (index, polynomial) {
            (Value::Count(k), Value::Curve(curve)) => (format!("B{k}({})", self.notation.variable), self.notation.curve(curve)),
            (Value::Counts(index), Value::Surface(surface)) => {
                let [u, v] = self.notation.variables;
                (format!("B{}({u},{v})", join(index)), self.notation.surface(surface))
            }
            _ => return,
        };
        let mut line = format!("{name} = {body}");
        if let Some(Value::Record(maximum)) = maximum {
            let parts: Vec<String> = maximum.iter().map(|(_, value)| self.inline(value)).collect();
            line += &format!(", largest at {} where it is {}", parts[0], parts[1]);
        }
        if let (Some(value), Ok(at)) = (value, self.arguments.numbers("t")) {
            let at: Vec<String> = at.iter().map(|number| self.notation.number(number)).collect();
            let head = name.split('(').next().unwrap_or_default();
            line += &format!(", {head}({}) = {}", at.join(","), self.inline(value));
        }
        self.lines.push(line);
    }

    fn inline(&self, value: &Value<C>) -> String {
        match value {
            Value::Number(number) => format!("{}{}", self.notation.number(number), self.approximately(std::slice::from_ref(number))),
            Value::Point(point) => format!("{}{}", self.notation.point(point), self.approximately(point)),
            Value::Count(count) => count.to_string(),
            Value::Curve(curve) => self.notation.curve(curve),
            Value::Surface(surface) => self.notation.surface(surface),
            Value::Numbers(numbers) => {
                numbers.iter().map(|number| self.inline(&Value::Number(number.clone()))).collect::<Vec<_>>().join(" and ")
            }
            _ => String::new(),
        }
    }
}

fn join(counts: &[usize]) -> String {
    counts.iter().map(usize::to_string).collect::<Vec<_>>().join(",")
}
