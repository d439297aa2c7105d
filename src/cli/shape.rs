//! The shapes of a command line as arguments of an operation.

use super::diagnostic::Problem;
use super::flags::{is_given, text_of};
use super::given::Given;
use super::read::{FIRST, Names, Reader};
use super::value::counts;
use super::variables;
use crate::curve::Curve;
use crate::exact::Rational;
use crate::model::ShapeFile;
use crate::piece::{Equation, Piece};
use crate::surface::{Surface, Term};
use crate::symbolic::Polynomial;
use crate::syntax::{MapInput, Nesting, PointInput, PointsInput, Variables};
use crate::triangular::triangular_degree;
use crate::value::{Domain, Value};

impl Reader<'_> {
    /// The letters of the parameters, by `--vars` or by the equation.
    pub(super) fn letters(&mut self, given: Option<&Given>) -> Result<(), Problem> {
        let letters = match (variables(self.matches)?, given) {
            (Some(letters), _) => letters,
            (None, Some(Given::Equation(map))) => map.variables.symbols(),
            _ => return Ok(()),
        };
        let expected = if self.domain == Domain::Curve { 1 } else { 2 };
        if letters.len() == expected {
            self.arguments.insert("variables", Value::Variables(letters));
            return Ok(());
        }
        // A constant surface may have been read as a constant curve.
        if is_given(self.matches, "vars") || !matches!(given, Some(Given::Equation(_))) {
            let (one, letters) =
                if expected == 1 { ("a curve has one parameter", "one letter") } else { ("a surface has two", "two letters") };
            return Err(Problem::plain(format!("{one}: --vars takes {letters} here")));
        }
        Ok(())
    }

    /// Puts a shape where the operation expects it.
    pub(super) fn shape(&mut self, given: Given, names: &Names) -> Result<(), Problem> {
        match given {
            Given::Equation(map) => self.equation(&map, names),
            Given::Points(input) => self.points(input, names),
            Given::File(file) => self.shape_file(*file, names),
        }
    }

    pub(super) fn equation(&mut self, map: &MapInput, names: &Names) -> Result<(), Problem> {
        match (map.variables, self.domain) {
            (Variables::Curve(variable), Domain::Curve) => {
                let coordinates = map.components.iter().map(|component| component.coefficients_in(variable)).collect();
                self.arguments.insert(names.curve, Value::Curve(Curve::new(coordinates)?));
            }
            (Variables::Surface(first, second), Domain::Triangle | Domain::Rectangle) => {
                let terms = |component: &Polynomial| {
                    let rows = component.coefficients_in(first);
                    let row = |(h, row): (usize, &Polynomial)| {
                        row.coefficients_in(second).into_iter().enumerate().map(move |(k, c)| (h, k, c)).collect::<Vec<Term<Polynomial>>>()
                    };
                    rows.iter().enumerate().flat_map(row).collect()
                };
                let lists: Vec<Vec<Term<Polynomial>>> = map.components.iter().map(terms).collect();
                let surface = if self.domain == Domain::Triangle { Surface::total(lists)? } else { Surface::tensor(lists)? };
                self.arguments.insert(names.surface, Value::Surface(surface));
            }
            (Variables::Curve(_), Domain::Triangle | Domain::Rectangle) => {
                let constants = map.components.iter().map(|component| vec![(0, 0, component.clone())]).collect();
                let surface = if self.domain == Domain::Triangle { Surface::total(constants)? } else { Surface::tensor(constants)? };
                self.arguments.insert(names.surface, Value::Surface(surface));
            }
            (Variables::Surface(first, second), Domain::Curve) => {
                let verb = self.operation.verb;
                return Err(Problem::plain(format!("`{verb}` takes a curve here; this was read as a surface in {first} and {second}"))
                    .with_help(format!("say which letter is the parameter of the curve, as in --vars {first}")));
            }
        }
        Ok(())
    }

    pub(super) fn points(&mut self, input: PointsInput, names: &Names) -> Result<(), Problem> {
        let lists = match (input.nesting, self.domain) {
            (Nesting::Flat(points), Domain::Curve) => vec![points],
            (Nesting::Rows(_), Domain::Curve) => {
                return Err(Problem::plain("these are rows of points; a curve has one list of them"));
            }
            (Nesting::Rows(rows), _) => rows,
            (Nesting::Flat(points), Domain::Triangle) => self.triangle_of(points)?,
            (Nesting::Flat(points), Domain::Rectangle) => self.rectangle_of(points)?,
        };
        let all = || lists.iter().flatten();
        if all().any(|point| point.weight.is_some()) {
            let weights = all().map(|point| point.weight.clone().unwrap_or_else(num_traits::One::one)).collect();
            if self.operation.parameter(names.weights).is_none() {
                return Err(Problem::plain(format!("`{}` takes points without weights here", self.operation.verb)));
            }
            self.arguments.insert(names.weights, Value::Numbers(weights));
        }
        let rows: Vec<Vec<Vec<Polynomial>>> =
            lists.into_iter().map(|row| row.into_iter().map(|point| point.coordinates).collect()).collect();
        self.insert_rows(rows, names);
        Ok(())
    }

    pub(super) fn insert_rows(&mut self, mut rows: Vec<Vec<Vec<Polynomial>>>, names: &Names) {
        let value = if self.domain == Domain::Curve { Value::Points(rows.swap_remove(0)) } else { Value::Rows(rows) };
        self.arguments.insert(names.points, value);
    }

    /// The rows of a triangular net that is given as one list.
    pub(super) fn triangle_of(&self, points: Vec<PointInput>) -> Result<Vec<Vec<PointInput>>, Problem> {
        let Some(degree) = triangular_degree(points.len()) else {
            return Err(Problem::plain(format!(
                "a triangular net has 1, 3, 6, 10, … points, (m+1)(m+2)/2 for degree m; found {}",
                points.len()
            )));
        };
        let mut points = points.into_iter();
        Ok((0..=degree).map(|i| points.by_ref().take(degree + 1 - i).collect()).collect())
    }

    /// The rows of a rectangular net that is given as one list.
    pub(super) fn rectangle_of(&self, points: Vec<PointInput>) -> Result<Vec<Vec<PointInput>>, Problem> {
        let Some(text) = text_of(self.matches, "bidegree") else {
            return Err(Problem::plain(format!("{} points in one list need --bidegree P,Q to be a rectangular net", points.len()))
                .with_help("or separate the rows by semicolons"));
        };
        let (p, q) = match counts("--bidegree", text)?.as_slice() {
            &[p, q] => (p, q),
            other => return Err(Problem::plain(format!("--bidegree takes two whole numbers P,Q, found {}", other.len()))),
        };
        if points.len() != (p + 1) * (q + 1) {
            let needed = (p + 1) * (q + 1);
            return Err(Problem::plain(format!("a net of bidegree ({p},{q}) has {needed} points, found {}", points.len())));
        }
        let mut points = points.into_iter();
        Ok((0..=p).map(|_| points.by_ref().take(q + 1).collect()).collect())
    }

    pub(super) fn shape_file(&mut self, file: ShapeFile, names: &Names) -> Result<(), Problem> {
        let kind = match &file.piece {
            Piece::Curve(_) => Domain::Curve,
            Piece::Triangle(_) => Domain::Triangle,
            Piece::Rectangle(_) => Domain::Rectangle,
        };
        if kind != self.domain {
            let verb = self.operation.verb;
            return Err(Problem::plain(format!("`{verb}` takes a {} here; the shape file holds a {}", self.domain.name(), kind.name())));
        }
        let takes_points = self.operation.parameter(names.points).is_some();
        if takes_points {
            let lift = |point: &[Rational]| point.iter().cloned().map(Polynomial::from).collect();
            let rows = file.piece.rows().into_iter().map(|row| row.into_iter().map(lift).collect()).collect();
            self.insert_rows(rows, names);
        } else {
            let mut lift = |number: &Rational| Ok::<_, Problem>(Polynomial::from(number.clone()));
            match file.piece.equation()? {
                Equation::Curve(curve) => self.arguments.insert(names.curve, Value::Curve(curve.map(&mut lift)?)),
                Equation::Surface(surface) => self.arguments.insert(names.surface, Value::Surface(surface.map(&mut lift)?)),
            }
        }
        if let Some(weights) = file.weights {
            if self.operation.parameter(names.weights).is_none() {
                return Err(Problem::plain(format!("`{}` takes shapes without weights here", self.operation.verb)));
            }
            self.arguments.insert(names.weights, Value::Numbers(weights.into_iter().map(Polynomial::from).collect()));
        }
        // The frame of an equation is only the usual one.
        let is_replaced = !takes_points && is_given(self.matches, "over");
        if file.has_frame && !is_replaced {
            let frame = file.piece.frame().map(&mut |number| Ok::<_, Problem>(Polynomial::from(number.clone())))?;
            if names.points == FIRST.points {
                self.shape_frame = Some(frame);
            } else {
                self.arguments.insert(names.frame, Value::Frame(frame));
            }
        }
        Ok(())
    }
}
