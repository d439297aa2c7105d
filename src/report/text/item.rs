//! The entries of lists: Bernstein polynomials, roots, defects of a claim.

use super::{Page, join};
use crate::blossom::PolarDefect;
use crate::kernel::coefficient::Coefficient;
use crate::reading::Reading;
use crate::syntax::printer;
use crate::value::{Homogeneous, Value};

impl<C: Coefficient> Page<'_, C> {
    /// One entry of a list of records.
    pub(super) fn item(&mut self, value: &Value<C>) -> Result<(), String> {
        match value {
            Value::Record(fields) => {
                let get = |name: &str| fields.iter().find(|(key, _)| *key == name).map(|(_, value)| value);
                if let Some(Value::Count(multiplicity)) = get("multiplicity") {
                    let letter = self.notation.variable;
                    let place = match (get("t"), get("between")) {
                        (Some(exact), _) => format!("{letter} = {}", self.inline(exact)),
                        (_, Some(Value::Numbers(ends))) if ends.len() == 2 => {
                            let [low, high] = [0, 1].map(|end| self.inline(&Value::Number(ends[end].clone())));
                            format!("{low} < {letter} < {high}")
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

    pub(super) fn basis_function(&mut self, index: &Value<C>, polynomial: &Value<C>, maximum: Option<&Value<C>>, value: Option<&Value<C>>) {
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

    pub(super) fn inline(&self, value: &Value<C>) -> String {
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

    pub(super) fn defect(&mut self, reading: Reading, defect: &PolarDefect) {
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

    pub(super) fn homogeneous(&mut self, name: &str, form: &Homogeneous<C>) {
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
}
