//! What the names and expressions of a worksheet stand for.

use crate::affine::Frame;
use crate::continuity::Continuity;
use crate::curve::Curve;
use crate::error::Error;
use crate::exact::Rational;
use crate::kernel::coefficient::Coefficient;
use crate::piece::{Equation, Piece};
use crate::reading::Reading;
use crate::rectangular::RectangularPatch;
use crate::segment::Segment;
use crate::surface::{Surface, Term};
use crate::symbolic::{Polynomial, Symbol};
use crate::syntax::{Style, printer};
use crate::triangular::TriangularPatch;

/// A value.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Quantity {
    /// A number, or a polynomial in symbolic parameters. Roots of numbers are in simple form.
    Number(Polynomial),
    /// A point of two or more coordinates, or of any number with a weight.
    Point(Point),
    /// A list.
    List(Vec<Quantity>),
    /// A polynomial or rational map.
    Map(Map),
    /// A control net with its frame.
    Net(Net),
    /// The left side of an equation `P = 0`, which is as good as any multiple of it.
    Equation(Polynomial),
    /// How smoothly two shapes join.
    Order(Order),
    /// A class or another answer with a name.
    Word(&'static str),
}

/// A point, perhaps with a weight.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Point {
    pub(super) coordinates: Vec<Polynomial>,
    pub(super) weight: Option<Polynomial>,
}

/// A map by its equation.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Map {
    pub(super) components: Vec<Polynomial>,
    /// One variable of a curve, two of a surface.
    pub(super) variables: Vec<Symbol>,
    pub(super) degrees: Degrees,
    /// What the components are divided by.
    pub(super) weight: Option<Polynomial>,
}

/// The polar degrees of a map, where they are more than its own.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Degrees {
    /// Of a curve, or of a surface by its total degree.
    pub(super) total: Option<usize>,
    /// Of a surface by its bidegree.
    pub(super) pair: Option<(usize, usize)>,
}

impl Degrees {
    /// Those of one reading.
    pub(super) fn of(reading: Reading) -> Self {
        match reading {
            Reading::Curve(degree) | Reading::Total(degree) => Self { total: Some(degree), pair: None },
            Reading::Bidegree(p, q) => Self { total: None, pair: Some((p, q)) },
        }
    }
}

/// A control net with its frame; homogeneous points if it has weights.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Net {
    pub(super) piece: Piece<Polynomial>,
    pub(super) weighted: bool,
}

/// How smoothly two shapes join, or how smoothly they are to.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Order {
    /// What was found: the order of geometric continuity is -1 for none, or why it is not known.
    Found { parametric: Continuity, geometric: Result<i64, String> },
    /// `C1`, or `same`.
    Parametric(Continuity),
    /// `G1`.
    Geometric(i64),
}

impl From<Polynomial> for Quantity {
    fn from(value: Polynomial) -> Self {
        Self::Number(value.with_simple_roots())
    }
}

impl Quantity {
    /// A point, which with one coordinate is its number.
    pub(super) fn point(coordinates: Vec<Polynomial>) -> Self {
        let mut coordinates: Vec<Polynomial> = coordinates.iter().map(Polynomial::with_simple_roots).collect();
        if coordinates.len() == 1
            && let Some(only) = coordinates.pop()
        {
            return Self::Number(only);
        }
        Self::Point(Point { coordinates, weight: None })
    }

    /// A point that is given by homogeneous coordinates `(w x, …, w)`.
    pub(super) fn homogeneous(coordinates: &[Polynomial]) -> Result<Self, Error> {
        let Some((weight, rest)) = coordinates.split_last() else { return Ok(Self::point(Vec::new())) };
        let weight = weight.with_simple_roots();
        let inverse = weight.reciprocal().ok_or_else(|| {
            let text = printer::polynomial(&weight, &[], Style::Text);
            Error::Unsupported(if text == "0" {
                "the weight is 0: this is a direction and no point".into()
            } else {
                format!("dividing by the weight {text} needs a number")
            })
        })?;
        let coordinates = rest.iter().map(|x| (x * &inverse).with_simple_roots()).collect();
        Ok(Self::Point(Point { coordinates, weight: Some(weight) }))
    }

    /// A whole number.
    pub(super) fn count(count: usize) -> Self {
        Self::Number(Polynomial::from(Rational::from(count as i64)))
    }

    /// Yes or no.
    pub(super) fn truth(truth: bool) -> Self {
        Self::Word(if truth { "true" } else { "false" })
    }

    /// What a value of this kind is called.
    pub(super) fn kind(&self) -> String {
        match self {
            Self::Number(value) if value.is_number() => "a number".to_owned(),
            Self::Number(_) => "a polynomial".to_owned(),
            Self::Point(point) => format!("a point with {} coordinates", point.coordinates.len()),
            Self::List(list) => format!("a list of {}", list.len()),
            Self::Map(map) if map.variables.len() == 1 => "a curve".to_owned(),
            Self::Map(_) => "a surface".to_owned(),
            Self::Net(net) => match net.piece {
                Piece::Curve(_) => "a control polygon".to_owned(),
                Piece::Triangle(_) => "a triangular net".to_owned(),
                Piece::Rectangle(_) => "a rectangular net".to_owned(),
            },
            Self::Equation(_) => "an equation".to_owned(),
            Self::Order(_) => "an order of continuity".to_owned(),
            Self::Word(word) => format!("`{word}`"),
        }
    }

    /// The value as it would be written in a worksheet.
    pub(super) fn shown(&self, style: Style) -> String {
        match self {
            Self::Number(value) | Self::Equation(value) => number(value, style),
            Self::Point(point) => point.shown(style),
            Self::List(list) => bracketed(list.iter().map(|item| item.shown(style)), style),
            Self::Map(map) => map.shown(style),
            Self::Net(net) => net.list().shown(style),
            Self::Order(order) => order.shown(),
            Self::Word(word) if style == Style::Latex => format!("\\text{{{}}}", word.replace('_', "\\_")),
            Self::Word(word) => (*word).to_owned(),
        }
    }
}

/// A number that must be rational.
pub(super) fn rational(value: &Polynomial) -> Result<Rational, Error> {
    value.as_rational().ok_or_else(|| match value.symbols().iter().find(|symbol| symbol.radicand().is_none()) {
        Some(symbol) => Error::Unsupported(format!("this needs numbers, found the symbolic parameter `{symbol}`")),
        None => Error::Unsupported("this needs rational numbers, found roots".into()),
    })
}

/// A number or polynomial; numbers with roots begin with their rational part.
pub(super) fn number(value: &Polynomial, style: Style) -> String {
    if !value.has_roots() {
        return printer::polynomial(value, &[], style);
    }
    printer::roots_last(value, style)
}

fn bracketed(items: impl Iterator<Item = String>, style: Style) -> String {
    let inside = items.collect::<Vec<_>>().join(", ");
    match style {
        Style::Latex => format!("\\left[{inside}\\right]"),
        _ => format!("[{inside}]"),
    }
}

impl Point {
    pub(super) fn shown(&self, style: Style) -> String {
        let coordinates: Vec<String> = self.coordinates.iter().map(|x| number(x, style)).collect();
        let point = match coordinates.as_slice() {
            [only] => only.clone(),
            _ => printer::point(&coordinates, style),
        };
        match &self.weight {
            Some(weight) => format!("{point}:{}", number(weight, style)),
            None => point,
        }
    }
}

impl Map {
    pub(super) fn shown(&self, style: Style) -> String {
        let shown = |value: &Polynomial| {
            if value.has_roots() { number(value, style) } else { printer::polynomial(value, &self.variables, style) }
        };
        let components: Vec<String> = self.components.iter().map(shown).collect();
        let map = match components.as_slice() {
            [only] => only.clone(),
            _ => printer::point(&components, style),
        };
        match &self.weight {
            Some(weight) => format!("{map} weight {}", shown(weight)),
            None => map,
        }
    }

    /// The coordinates with the weight, if there is one, behind them.
    pub(super) fn homogeneous(&self) -> impl Iterator<Item = &Polynomial> {
        self.components.iter().chain(&self.weight)
    }

    /// The equation of a curve, at its polar degree.
    pub(super) fn curve(&self) -> Result<Curve<Polynomial>, Error> {
        let [variable] = self.variables.as_slice() else {
            return Err(Error::WrongShape("found a surface, expected a curve".into()));
        };
        let curve = Curve::new(self.homogeneous().map(|component| component.coefficients_in(*variable)).collect())?;
        match self.degrees.total {
            Some(degree) => curve.with_degree(degree),
            None => Ok(curve),
        }
    }

    /// The equation of a surface, read by its total degree or by its bidegree.
    pub(super) fn surface(&self, by_total: bool) -> Result<Surface<Polynomial>, Error> {
        let [first, second] = self.variables.as_slice() else {
            return Err(Error::WrongShape("found a curve, expected a surface".into()));
        };
        let terms = |component: &Polynomial| -> Vec<Term<Polynomial>> {
            let rows = component.coefficients_in(*first).into_iter().enumerate();
            rows.flat_map(|(h, row)| row.coefficients_in(*second).into_iter().enumerate().map(move |(k, c)| (h, k, c))).collect()
        };
        let lists = self.homogeneous().map(terms).collect();
        let surface = if by_total { Surface::total(lists)? } else { Surface::tensor(lists)? };
        match (self.degrees.total, self.degrees.pair) {
            (Some(degree), _) if by_total => surface.read_as(Reading::Total(degree)),
            (_, Some((p, q))) if !by_total => surface.read_as(Reading::Bidegree(p, q)),
            _ => Ok(surface),
        }
    }

    /// Whether a surface is read by its total degree, unless a frame or arguments say otherwise.
    pub(super) fn is_by_total(&self) -> bool {
        self.degrees.pair.is_none() || self.degrees.total.is_some()
    }

    /// The polar degrees of the map as a whole, which its components have too.
    pub(super) fn own_degrees(&self) -> Result<Degrees, Error> {
        if self.variables.len() == 1 {
            return Ok(Degrees { total: Some(self.curve()?.degree()), pair: None });
        }
        let total = Degrees::of(self.surface(true)?.reading()).total;
        Ok(Degrees { total, pair: Degrees::of(self.surface(false)?.reading()).pair })
    }

    /// A map by its equation, with these letters.
    pub(super) fn of<C: Coefficient>(equation: &Equation<C>, variables: &[Symbol], weighted: bool) -> Self {
        let mut components = match equation {
            Equation::Curve(curve) => curve.polynomials(variables[0]),
            Equation::Surface(surface) => surface.polynomials([variables[0], variables[1]]),
        };
        let weight = if weighted { components.pop() } else { None };
        let degrees = Degrees::of(match equation {
            Equation::Curve(curve) => Reading::Curve(curve.degree()),
            Equation::Surface(surface) => surface.reading(),
        });
        Self { components, variables: variables.to_vec(), degrees, weight }
    }
}

/// The letters of maps that come without their own: t, or u and v.
pub(super) fn usual_variables<C: Coefficient>(equation: &Equation<C>) -> Vec<Symbol> {
    match equation {
        Equation::Curve(_) => vec![Symbol::new('t', None)],
        Equation::Surface(_) => vec![Symbol::new('u', None), Symbol::new('v', None)],
    }
}

impl Net {
    /// The points as a list, nested for patches. A weight that cannot be divided by leaves homogeneous coordinates.
    pub(super) fn list(&self) -> Quantity {
        let point = |point: &[Polynomial]| match self.weighted {
            true => Quantity::homogeneous(point).unwrap_or_else(|_| Quantity::point(point.to_vec())),
            false => Quantity::point(point.to_vec()),
        };
        let mut rows: Vec<Quantity> =
            self.piece.rows().into_iter().map(|row| Quantity::List(row.into_iter().map(point).collect())).collect();
        match (&self.piece, rows.len()) {
            (Piece::Curve(_), 1) => rows.pop().unwrap_or(Quantity::List(Vec::new())),
            _ => Quantity::List(rows),
        }
    }

    /// The equation.
    pub(super) fn map(&self) -> Result<Map, Error> {
        let equation = self.piece.equation()?;
        Ok(Map::of(&equation, &usual_variables(&equation), self.weighted))
    }

    /// The net with rational numbers.
    pub(super) fn numeric(&self) -> Result<Piece, Error> {
        let points = self.piece.points().map(|point| point.iter().map(rational).collect());
        let points: Vec<Vec<Rational>> = points.collect::<Result<_, _>>()?;
        Ok(match (&self.piece, self.frame().map(&mut rational)?) {
            (_, Frame::Interval(frame)) => Piece::Curve(Segment::from_points(points, frame)?),
            (_, Frame::Triangle(frame)) => Piece::Triangle(TriangularPatch::from_points(points, frame)?),
            (Piece::Rectangle(patch), Frame::Rectangle(frame)) => {
                Piece::Rectangle(RectangularPatch::from_points(patch.degree(), points, frame)?)
            }
            _ => return Err(Error::WrongShape("a piece over a rectangle is a rectangular one".into())),
        })
    }

    /// The frame.
    pub(super) fn frame(&self) -> Frame<Polynomial> {
        self.piece.frame()
    }
}

impl Order {
    pub(super) fn shown(&self) -> String {
        let shown = |parametric: &Continuity| match parametric {
            Continuity::Broken => "not even C0".to_owned(),
            Continuity::C(order) => format!("C{order}"),
            Continuity::Same => "same".to_owned(),
        };
        match self {
            Self::Found { parametric: parametric @ Continuity::C(_), geometric: Ok(order) } => {
                format!("{} and G{order}", shown(parametric))
            }
            Self::Found { parametric, .. } | Self::Parametric(parametric) => shown(parametric),
            Self::Geometric(order) => format!("G{order}"),
        }
    }
}
