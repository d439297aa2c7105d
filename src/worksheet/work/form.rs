//! The formulas of worked solutions.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use super::{Task, is_zero};
use crate::blossom::PolarForm;
use crate::error::Error;
use crate::reading::Reading;
use crate::symbolic::{Polynomial, Symbol};
use crate::syntax::{Style, printer};

/// A vertex of a frame, with the name it has in formulas.
pub(super) struct Vertex {
    pub(super) name: String,
    pub(super) coordinates: Vec<Polynomial>,
}

/// The names that formulas use.
pub(super) struct Names {
    reading: Reading,
    variables: Vec<Symbol>,
    dimension: usize,
    /// Letters that stand for parameters of the map, so that no name may be one.
    taken: BTreeSet<char>,
    /// The index of all names, where several solutions share a worksheet.
    number: Option<u16>,
}

/// An argument of a polar form: a vertex by its place, or the parameter.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Argument {
    Vertex(usize),
    Parameter,
}

const OPEN: &str = "<!-- casteljau -->\n$$\\begin{aligned}\n";
const CLOSE: &str = "\n\\end{aligned}$$\n\n";

impl Names {
    pub(super) fn of(task: &Task, reading: Reading, number: Option<u16>) -> Self {
        let taken = task.map.parameters().into_iter().map(Symbol::letter).collect();
        Self { reading, variables: task.map.variables.symbols(), dimension: task.map.components.len(), taken, number }
    }

    /// A name that no parameter of the map has; a spare one for a letter that is taken.
    fn free(&self, name: &str) -> String {
        let letter = name.chars().next().unwrap_or('r');
        if let Some(number) = self.number {
            return format!("{letter}_{{{number}}}");
        }
        if !self.taken.contains(&letter) {
            return name.to_owned();
        }
        let spare =
            ['p', 'q', 'c', 'd', 'e', 'g', 'h', 'k', 'l', 'n'].into_iter().find(|letter| !self.taken.contains(letter)).unwrap_or('o');
        // Taken letters are replaced one by one in the order of the alphabet, so that different ones stay different.
        let index = self.taken.iter().position(|taken| *taken == letter).unwrap_or(0) + 1;
        format!(
            "{spare}_{{{}}}",
            index * 10 + name.chars().filter(char::is_ascii_digit).filter_map(|c| c.to_digit(10)).next().unwrap_or(0) as usize
        )
    }

    /// The letter of a coordinate of an argument, with the number of the argument.
    fn letter(&self, group: usize, argument: usize, axis: usize) -> Symbol {
        let index = match self.reading {
            Reading::Curve(_) => 0,
            Reading::Total(_) => axis - 1,
            Reading::Bidegree(..) => group,
        };
        self.variables.get(index).copied().unwrap_or(Symbol::new('t', None)).with_index(argument as u32)
    }

    /// The arguments of the polar form as letters.
    fn letters(&self, style: Style) -> String {
        let groups = self.reading.groups().into_iter().enumerate().map(|(group, (count, dimension))| {
            let one = |argument: usize| {
                let axes: Vec<String> = (1..=dimension).map(|axis| printer::symbol(self.letter(group, argument, axis), style)).collect();
                if dimension == 1 { axes.concat() } else { format!("({})", axes.join(",")) }
            };
            (1..=count).map(one).collect::<Vec<_>>().join(", ")
        });
        groups.collect::<Vec<_>>().join("; ")
    }

    /// What one product of powers becomes, as a definition and a claim.
    pub(super) fn power(
        &self,
        reading: Reading,
        exponents: &[usize],
        (h, k): (usize, usize),
        number: usize,
        count: &str,
        text: &mut String,
    ) {
        let variables: Vec<String> = self.variables.iter().map(Symbol::to_string).collect();
        let raised = |letter: &str, exponent: usize| match exponent {
            0 => String::new(),
            1 => letter.to_owned(),
            _ => format!("{letter}^{exponent}"),
        };
        let body = match self.variables.as_slice() {
            [_] => raised(&variables[0], h),
            _ => [raised(&variables[0], h), raised(&variables[1], k)]
                .into_iter()
                .filter(|part| !part.is_empty())
                .collect::<Vec<_>>()
                .join(" "),
        };
        let degree = match reading {
            Reading::Curve(m) | Reading::Total(m) => format!("degree {m}"),
            Reading::Bidegree(p, q) => format!("bidegree {p},{q}"),
        };
        let products = reading.terms(exponents).into_iter().map(|term| {
            let letters = term.iter().filter(|(_, _, axis)| *axis > 0).map(|(group, argument, axis)| self.letter(*group, *argument, *axis));
            letters.map(|letter| letter.to_string()).collect::<Vec<_>>().join(" ")
        });
        let sum = products.collect::<Vec<_>>().join(" + ");
        let average = match count {
            "1" => sum,
            _ => format!("({sum})/{count}"),
        };
        let number = usize::from(self.number.unwrap_or(0)) * 100 + number;
        let _ = writeln!(text, "M{number}({}) = {body} {degree}", variables.join(","));
        let _ = writeln!(text, "m{number}({}) == {average}", self.letters(Style::Text));
    }

    /// A letter with the index of all names.
    pub(super) fn indexed(&self, letter: char, style: Style) -> String {
        match (self.number, style) {
            (None, _) => letter.to_string(),
            (Some(number), Style::Latex) => format!("{letter}_{{{number}}}"),
            (Some(number), _) => format!("{letter}{number}"),
        }
    }

    /// The name of the polar form of a coordinate.
    fn coordinate(&self, coordinate: usize) -> String {
        if self.dimension == 1 { "f".to_owned() } else { format!("f_{{{}}}", coordinate + 1) }
    }

    /// The whole polar form, a claim for each coordinate.
    pub(super) fn polar_form(&self, form: &PolarForm<Polynomial>, text: &mut String) {
        text.push_str("Together:\n\n");
        let sum = |coordinate| {
            self.sum(form, coordinate, &|group, argument, axis| printer::symbol(self.letter(group, argument, axis), Style::Latex))
        };
        let letters = self.letters(Style::Latex);
        let rows: Vec<String> = if self.number.is_some() {
            let sums: Vec<String> = (0..form.dimension()).map(sum).collect();
            let whole = if let [only] = sums.as_slice() { only.clone() } else { printer::point(&sums, Style::Latex) };
            vec![format!("{}({letters}) &= {whole}", self.indexed('f', Style::Latex))]
        } else {
            (0..form.dimension()).map(|coordinate| format!("{}({letters}) &= {}", self.coordinate(coordinate), sum(coordinate))).collect()
        };
        text.push_str(&format!("{OPEN}{}{CLOSE}", rows.join(" \\\\\n")));
    }

    /// One coordinate of the polar form, with something in the place of every letter.
    fn sum(&self, form: &PolarForm<Polynomial>, coordinate: usize, letter: &dyn Fn(usize, usize, usize) -> String) -> String {
        let mut text = String::new();
        let mut terms = form.terms(coordinate);
        // The highest powers first.
        terms.reverse();
        for (exponents, coefficient) in terms {
            let products: Vec<String> = self
                .reading
                .terms(&exponents)
                .into_iter()
                .map(|term| {
                    let factors =
                        term.iter().filter(|(_, _, axis)| *axis > 0).map(|(group, argument, axis)| letter(*group, *argument, *axis));
                    factors.collect::<Vec<_>>().join(" ")
                })
                .collect();
            let products = match products.as_slice() {
                [only] => only.clone(),
                several => format!("({})", several.join(" + ")),
            };
            let negative = coefficient.terms().next().is_some_and(|(_, number)| num_traits::Signed::is_negative(number));
            let size = if negative { -coefficient.clone() } else { coefficient.clone() };
            let is_one = size.as_rational().is_some_and(|number| num_traits::One::is_one(&number));
            let shown = printer::polynomial(&size, &[], Style::Latex);
            let shown = if size.len() > 1 && !products.is_empty() { format!("({shown})") } else { shown };
            text.push_str(match (text.is_empty(), negative) {
                (true, false) => "",
                (true, true) => "-",
                (false, false) => " + ",
                (false, true) => " - ",
            });
            text.push_str(&match (is_one, products.is_empty()) {
                (true, false) => products,
                (_, true) => shown,
                (false, false) => format!("{shown} {products}"),
            });
        }
        if text.is_empty() { "0".to_owned() } else { text }
    }

    /// The vertices as definitions.
    pub(super) fn frame(&self, groups: &[Vec<Vertex>], text: &mut String) {
        text.push_str("## Control points\n\n");
        let _ = writeln!(text, "The control points are the polar values at the vertices of the frame, repeated:\n");
        let rows = groups.iter().flatten().map(|vertex| format!("{} &= {}", self.free(&vertex.name), place(&vertex.coordinates)));
        let rows = rows.collect::<Vec<_>>().join(" \\\\\n");
        text.push_str(&format!("{OPEN}{rows}{CLOSE}"));
    }

    /// Every control point: the polar form with numbers in it, and what they give.
    pub(super) fn control_points(&self, form: &PolarForm<Polynomial>, groups: &[Vec<Vertex>], text: &mut String) -> Result<(), Error> {
        let mut rows = Vec::new();
        let degrees: Vec<usize> = self.reading.groups().iter().map(|group| group.0).collect();
        for arguments in all(&degrees, groups) {
            let places: Vec<Vec<&[Polynomial]>> = arguments
                .iter()
                .zip(groups)
                .map(|(group, vertices)| {
                    let place = |argument: &Argument| match argument {
                        Argument::Vertex(index) => vertices[*index].coordinates.as_slice(),
                        Argument::Parameter => &[],
                    };
                    group.iter().map(place).collect()
                })
                .collect();
            let value = value(form, &places)?;
            let label = self.label(&arguments, groups);
            let sums: Vec<String> = (0..form.dimension())
                .map(|coordinate| self.sum(form, coordinate, &|group, argument, axis| bracketed(&places[group][argument - 1][axis - 1])))
                .collect();
            let result = place(&value);
            let sums = match sums.as_slice() {
                [only] => only.clone(),
                several => printer::point(several, Style::Latex),
            };
            rows.push(if sums == result { format!("{label} &= {result}") } else { format!("{label} &= {sums} = {result}") });
        }
        text.push_str(&format!("{OPEN}{}{CLOSE}", rows.join(" \\\\\n")));
        Ok(())
    }

    /// The name of the parameter of a group.
    fn parameter(&self, group: usize) -> String {
        match self.reading {
            Reading::Curve(_) => self.free("t"),
            Reading::Total(_) => self.free("a"),
            Reading::Bidegree(..) => self.free(["u_0", "v_0"][group]),
        }
    }

    /// A polar value with its arguments by name.
    fn label(&self, arguments: &[Vec<Argument>], groups: &[Vec<Vertex>]) -> String {
        let group = |(index, (list, vertices)): (usize, (&Vec<Argument>, &Vec<Vertex>))| {
            let name = |argument: &Argument| match argument {
                Argument::Parameter => self.parameter(index),
                Argument::Vertex(vertex) => self.free(&vertices[*vertex].name),
            };
            list.iter().map(name).collect::<Vec<_>>().join(",")
        };
        let groups: Vec<String> = arguments.iter().zip(groups).enumerate().map(group).collect();
        format!("{}({})", self.indexed('f', Style::Latex), groups.join(";\\, "))
    }

    /// The steps of the algorithm, each from the ones before.
    pub(super) fn scheme(
        &self,
        form: &PolarForm<Polynomial>,
        groups: &[Vec<Vertex>],
        places: &[Vec<Polynomial>],
        weights: &[Vec<Polynomial>],
        text: &mut String,
    ) -> Result<(), Error> {
        let definitions: Vec<String> =
            places.iter().enumerate().map(|(group, at)| format!("{} &= {}", self.parameter(group), place(at))).collect();
        let combinations: Vec<String> = (0..groups.len())
            .map(|group| {
                let parts = weights[group].iter().zip(&groups[group]);
                let sum: Vec<String> =
                    parts.filter(|(weight, _)| !is_zero(weight)).map(|(weight, vertex)| times(weight, &self.free(&vertex.name))).collect();
                format!("{} &= {}", self.parameter(group), sum.join(" + "))
            })
            .collect();
        let _ =
            writeln!(text, "The parameter is a combination of the vertices, and every step takes it in once more with the same weights:\n");
        text.push_str(&format!("{OPEN}{} \\\\\n{}{CLOSE}", definitions.join(" \\\\\n"), combinations.join(" \\\\\n")));
        let degrees: Vec<usize> = self.reading.groups().iter().map(|group| group.0).collect();
        // How many arguments of each group are the parameter already.
        let mut taken = vec![0; groups.len()];
        let steps: usize = degrees.iter().sum();
        for step in 1..=steps {
            let group = (0..groups.len()).find(|&group| taken[group] < degrees[group]).unwrap_or(0);
            taken[group] += 1;
            let rest: Vec<usize> = degrees.iter().zip(&taken).map(|(degree, taken)| degree - taken).collect();
            let mut rows = Vec::new();
            for vertices in all(&rest, groups) {
                let with = |index: usize, own: Option<Argument>| -> Vec<Argument> {
                    let parameters = taken[index] - usize::from(index == group && own.is_some());
                    let mut list: Vec<Argument> =
                        std::iter::repeat_n(Argument::Parameter, parameters).chain(own).chain(vertices[index].iter().copied()).collect();
                    list.sort_unstable();
                    list
                };
                let arguments = |own: Option<Argument>| -> Vec<Vec<Argument>> {
                    (0..groups.len()).map(|index| with(index, own.filter(|_| index == group))).collect()
                };
                let coordinates = |arguments: &[Vec<Argument>]| -> Result<Vec<Polynomial>, Error> {
                    let places: Vec<Vec<&[Polynomial]>> = arguments
                        .iter()
                        .enumerate()
                        .map(|(index, list)| {
                            let place = |argument: &Argument| match argument {
                                Argument::Parameter => places[index].as_slice(),
                                Argument::Vertex(vertex) => groups[index][*vertex].coordinates.as_slice(),
                            };
                            list.iter().map(place).collect()
                        })
                        .collect();
                    value(form, &places)
                };
                let (mut labels, mut numbers) = (Vec::new(), Vec::new());
                for (vertex, weight) in weights[group].iter().enumerate().filter(|(_, weight)| !is_zero(weight)) {
                    let before = arguments(Some(Argument::Vertex(vertex)));
                    labels.push(times(weight, &self.label(&before, groups)));
                    let point = coordinates(&before)?;
                    let shown = place(&point);
                    numbers.push(times(weight, &if point.len() == 1 { bracketed(&point[0]) } else { shown }));
                }
                let now = arguments(None);
                let result = place(&coordinates(&now)?);
                rows.push(format!("{} &= {} = {} = {result}", self.label(&now, groups), labels.join(" + "), numbers.join(" + ")));
            }
            let _ = writeln!(text, "Step {step}:\n");
            text.push_str(&format!("{OPEN}{}{CLOSE}", rows.join(" \\\\\n")));
        }
        let at: Vec<String> = (0..groups.len()).map(|group| self.parameter(group)).collect();
        let last: Vec<Vec<&[Polynomial]>> = degrees.iter().zip(places).map(|(degree, place)| vec![place.as_slice(); *degree]).collect();
        let _ = writeln!(text, "This is the point of the shape:\n");
        text.push_str(&format!(
            "<!-- casteljau -->\n$${}({}) = {}$$\n\n",
            self.indexed('F', Style::Latex),
            at.join(","),
            place(&value(form, &last)?)
        ));
        Ok(())
    }
}

/// All choices of vertices, as many of each group as is said, the first one most often first.
fn all(counts: &[usize], groups: &[Vec<Vertex>]) -> Vec<Vec<Vec<Argument>>> {
    let mut choices: Vec<Vec<Vec<Argument>>> = vec![Vec::new()];
    for (count, vertices) in counts.iter().zip(groups) {
        let own = multisets(*count, vertices.len());
        choices = choices.iter().flat_map(|before| own.iter().map(|list| before.iter().cloned().chain([list.clone()]).collect())).collect();
    }
    choices
}

/// The vertices with repetition, in order.
fn multisets(count: usize, vertices: usize) -> Vec<Vec<Argument>> {
    let mut lists: Vec<Vec<usize>> = vec![Vec::new()];
    for _ in 0..count {
        lists = lists
            .into_iter()
            .flat_map(|list| {
                let first = list.last().copied().unwrap_or(0);
                (first..vertices).map(move |vertex| list.iter().copied().chain([vertex]).collect())
            })
            .collect();
    }
    lists.into_iter().map(|list| list.into_iter().map(Argument::Vertex).collect()).collect()
}

/// The value of a polar form at points.
fn value(form: &PolarForm<Polynomial>, places: &[Vec<&[Polynomial]>]) -> Result<Vec<Polynomial>, Error> {
    if let Reading::Total(_) = form.reading() {
        let points = places.iter().flatten().map(|place| [place[0].clone(), place[1].clone()]).collect::<Vec<_>>();
        return form.value_at_points(&points);
    }
    form.value(&places.iter().flatten().map(|place| place[0].clone()).collect::<Vec<_>>())
}

/// A number as a factor: in brackets, unless it is a plain positive one at the beginning.
fn bracketed(value: &Polynomial) -> String {
    format!("({})", printer::polynomial(value, &[], Style::Latex))
}

/// A number or a point.
fn place(coordinates: &[Polynomial]) -> String {
    let shown: Vec<String> = coordinates.iter().map(|value| printer::polynomial(value, &[], Style::Latex)).collect();
    match shown.as_slice() {
        [only] => only.clone(),
        several => printer::point(several, Style::Latex),
    }
}

fn times(weight: &Polynomial, what: &str) -> String {
    match weight.as_rational() {
        Some(number) if num_traits::One::is_one(&number) => what.to_owned(),
        Some(number) if !num_traits::Signed::is_negative(&number) => format!("{} {what}", printer::rational(&number, Style::Latex)),
        _ => format!("\\left({}\\right) {what}", printer::polynomial(weight, &[], Style::Latex)),
    }
}
