//! The arguments of one operation, by name.

use super::Value;
use crate::affine::{AffineMap, Frame, Interval, Parameter, PlaneParameter, Rectangle, Triangle};
use crate::curve::Curve;
use crate::error::Error;
use crate::exact::Rational;
use crate::kernel::coefficient::Coefficient;
use crate::piece::Piece;
use crate::reading::Reading;
use crate::rectangular::RectangularPatch;
use crate::segment::Segment;
use crate::surface::Surface;
use crate::symbolic::{Polynomial, Symbol};
use crate::triangular::TriangularPatch;
use crate::weights::homogeneous_points;

/// What kind of shape an operation is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Domain {
    /// Curves, over intervals.
    #[default]
    Curve,
    /// Surfaces by their total degree, over triangles.
    Triangle,
    /// Surfaces by their bidegree, over rectangles.
    Rectangle,
}

impl Domain {
    /// What a shape of this kind is called.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Curve => "curve",
            Self::Triangle => "triangle",
            Self::Rectangle => "rectangle",
        }
    }

    /// The frame that is meant where none is given.
    #[must_use]
    pub fn default_frame<C: Coefficient>(self) -> Frame<C> {
        match self {
            Self::Curve => Interval::unit().into(),
            Self::Triangle => Triangle::standard().into(),
            Self::Rectangle => Rectangle::unit().into(),
        }
    }
}

/// The arguments of one operation. The adaptor that filled them has seen to it
/// that required ones are there and that each has the kind its row asks for.
#[derive(Clone, Debug, PartialEq)]
pub struct Arguments<C = Rational> {
    domain: Domain,
    values: Vec<(&'static str, Value<C>)>,
}

fn missing(name: &str) -> Error {
    Error::WrongShape(format!("`{name}` is missing"))
}

macro_rules! getters {
    ($($(#[$doc:meta])* $method:ident: $variant:ident -> $type:ty;)*) => {$(
        $(#[$doc])*
        ///
        /// # Errors
        /// [`Error::WrongShape`] if it is missing.
        pub fn $method(&self, name: &str) -> Result<&$type, Error> {
            match self.get(name) {
                Some(Value::$variant(value)) => Ok(value),
                _ => Err(missing(name)),
            }
        }
    )*};
}

impl<C: Coefficient> Arguments<C> {
    /// No arguments yet, of an operation on a kind of shape.
    #[must_use]
    pub fn new(domain: Domain) -> Self {
        Self { domain, values: Vec::new() }
    }

    /// The kind of shape that the operation is about.
    #[must_use]
    pub fn domain(&self) -> Domain {
        self.domain
    }

    /// Adds an argument.
    pub fn insert(&mut self, name: &'static str, value: Value<C>) {
        self.values.push((name, value));
    }

    /// The argument with this name.
    #[must_use]
    pub fn get(&self, name: &str) -> Option<&Value<C>> {
        self.values.iter().find(|(key, _)| *key == name).map(|(_, value)| value)
    }

    /// All arguments, in the order they were given.
    pub fn iter(&self) -> impl Iterator<Item = (&'static str, &Value<C>)> {
        self.values.iter().map(|(name, value)| (*name, value))
    }

    getters! {
        /// A number.
        number: Number -> C;
        /// A list of numbers.
        numbers: Numbers -> Vec<C>;
        /// A point.
        point: Point -> Vec<C>;
        /// A frame of any kind.
        any_frame: Frame -> Frame<C>;
        /// Polar arguments on the line.
        polar_arguments: Arguments -> Vec<Parameter<C>>;
        /// Polar arguments in the plane.
        plane_arguments: PlaneArguments -> Vec<PlaneParameter<C>>;
        /// A count.
        count: Count -> usize;
        /// Several counts.
        counts: Counts -> Vec<usize>;
        /// A word.
        word: Word -> &'static str;
        /// An affine map.
        map: Map -> AffineMap<C>;
        /// Polynomials in named variables.
        expressions: Expressions -> Vec<Polynomial>;
    }

    /// A frame of the parameter line.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if it is missing or of another kind.
    pub fn frame(&self, name: &str) -> Result<&Interval<C>, Error> {
        match self.get(name) {
            Some(Value::Frame(Frame::Interval(frame))) => Ok(frame),
            Some(Value::Frame(frame)) => Err(wrong_frame("an interval `r..s`", frame)),
            _ => Err(missing(name)),
        }
    }

    /// A triangle of the parameter plane.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if it is missing or of another kind.
    pub fn triangle(&self, name: &str) -> Result<&Triangle<C>, Error> {
        match self.get(name) {
            Some(Value::Frame(Frame::Triangle(frame))) => Ok(frame),
            Some(Value::Frame(frame)) => Err(wrong_frame("a triangle `(1,0) (0,1) (0,0)`", frame)),
            _ => Err(missing(name)),
        }
    }

    /// A rectangle of the parameter plane.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if it is missing or of another kind.
    pub fn rectangle(&self, name: &str) -> Result<&Rectangle<C>, Error> {
        match self.get(name) {
            Some(Value::Frame(Frame::Rectangle(frame))) => Ok(frame),
            Some(Value::Frame(frame)) => Err(wrong_frame("a rectangle `a..b, c..d`", frame)),
            _ => Err(missing(name)),
        }
    }

    /// A point of the parameter plane.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if it is missing, [`Error::WrongCount`] unless it
    /// has two coordinates.
    pub fn parameter_point(&self, name: &str) -> Result<[C; 2], Error> {
        match self.point(name)?.as_slice() {
            [u, v] => Ok([u.clone(), v.clone()]),
            other => Err(Error::WrongCount { what: "parameters", expected: 2, found: other.len() }),
        }
    }

    /// Two counts.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if they are missing, [`Error::WrongCount`] unless there are two.
    pub fn pair(&self, name: &str) -> Result<(usize, usize), Error> {
        match self.counts(name)?.as_slice() {
            &[first, second] => Ok((first, second)),
            other => Err(Error::WrongCount { what: "whole numbers", expected: 2, found: other.len() }),
        }
    }

    /// Whether a flag is set.
    #[must_use]
    pub fn flag(&self, name: &str) -> bool {
        matches!(self.get(name), Some(Value::Truth(true)))
    }

    /// The letter of the curve's parameter, `t` unless another was chosen.
    #[must_use]
    pub fn variable(&self) -> Symbol {
        match self.get("variables") {
            Some(Value::Variables(symbols)) if symbols.len() == 1 => symbols[0],
            _ => Symbol::new('t', None),
        }
    }

    /// The letters of a surface's parameters, `u` and `v` unless others were chosen.
    #[must_use]
    pub fn variables(&self) -> [Symbol; 2] {
        match self.get("variables") {
            Some(Value::Variables(symbols)) if symbols.len() == 2 => [symbols[0], symbols[1]],
            _ => [Symbol::new('u', None), Symbol::new('v', None)],
        }
    }

    /// The frame if one was given, else the usual one of the kind the operation is about.
    #[must_use]
    pub fn frame_or_default(&self, name: &str) -> Frame<C> {
        self.any_frame(name).cloned().unwrap_or_else(|_| self.domain.default_frame())
    }

    /// Whether the shape has weights, so that its last coordinate is the weight.
    #[must_use]
    pub fn is_weighted(&self) -> bool {
        self.get("weights").is_some() || self.get("weight").is_some()
    }

    /// The curve, by its equation or by its control points.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if there is neither, and what making it of control points says.
    pub fn curve(&self) -> Result<Curve<C>, Error> {
        match (self.get("curve"), self.get("points")) {
            (Some(Value::Curve(curve)), None) => self.raised(curve.clone()),
            (None, Some(Value::Points(_))) => self.segment()?.curve(),
            _ => Err(missing("curve")),
        }
    }

    /// The surface, by its equation or by its control points, read as the
    /// operation reads surfaces.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if there is neither, and what making it of control points says.
    pub fn surface(&self) -> Result<Surface<C>, Error> {
        match (self.get("surface"), self.get("points")) {
            (Some(Value::Surface(surface)), None) => self.read(surface.clone()),
            (None, Some(_)) => match self.piece()? {
                Piece::Triangle(patch) => patch.surface(),
                Piece::Rectangle(patch) => patch.surface(),
                Piece::Curve(_) => Err(missing("surface")),
            },
            _ => Err(missing("surface")),
        }
    }

    /// The segment over `frame`, by control points or by an equation.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if there is neither, and what making it says.
    pub fn segment(&self) -> Result<Segment<C>, Error> {
        match self.piece()? {
            Piece::Curve(segment) => Ok(segment),
            _ => Err(missing("points")),
        }
    }

    /// The triangular patch, by control points or by an equation.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if there is neither, and what making it says.
    pub fn triangular(&self) -> Result<TriangularPatch<C>, Error> {
        match self.piece()? {
            Piece::Triangle(patch) => Ok(patch),
            _ => Err(missing("points")),
        }
    }

    /// The rectangular patch, by control points or by an equation.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if there is neither, and what making it says.
    pub fn rectangular(&self) -> Result<RectangularPatch<C>, Error> {
        match self.piece()? {
            Piece::Rectangle(patch) => Ok(patch),
            _ => Err(missing("points")),
        }
    }

    /// The piece over `frame`, of the kind the operation is about.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if there is none, and what making it says.
    pub fn piece(&self) -> Result<Piece<C>, Error> {
        self.piece_over(self.frame_or_default("frame"))
    }

    /// The piece over a frame.
    ///
    /// # Errors
    /// As for [`Arguments::piece`].
    pub fn piece_over(&self, frame: Frame<C>) -> Result<Piece<C>, Error> {
        self.piece_of(["curve", "surface", "points", "weights"], frame)
    }

    /// The second piece of an operation on two, over the frame of the first
    /// unless it has its own.
    ///
    /// # Errors
    /// As for [`Arguments::piece`].
    pub fn other_piece(&self) -> Result<Piece<C>, Error> {
        let frame = self.any_frame("other_frame").cloned().unwrap_or_else(|_| self.frame_or_default("frame"));
        self.piece_of(["other_curve", "other_surface", "other_points", "other_weights"], frame)
    }

    fn piece_of(&self, [curve, surface, points, weights]: [&str; 4], frame: Frame<C>) -> Result<Piece<C>, Error> {
        if self.get("weight").is_some() && self.get(points).is_some() {
            return Err(Error::WrongShape("`weight` goes with an equation; control points have a weight each, as in (1,1):2".into()));
        }
        let lifted = |points: Vec<Vec<C>>| match self.get(weights) {
            Some(Value::Numbers(weights)) => homogeneous_points(&points, weights),
            _ => Ok(points),
        };
        Ok(match (self.get(points), self.get(curve), self.get(surface), frame) {
            (Some(Value::Points(points)), _, _, Frame::Interval(frame)) => {
                self.check_count(points.len())?;
                Piece::Curve(Segment::from_points(lifted(points.clone())?, frame)?)
            }
            (Some(Value::Rows(rows)), _, _, Frame::Triangle(frame)) => {
                // Made of rows first, so that an odd row is named.
                let degree = TriangularPatch::from_rows(rows.clone(), frame.clone())?.degree();
                self.check_degree(degree)?;
                Piece::Triangle(TriangularPatch::from_points(lifted(rows.iter().flatten().cloned().collect())?, frame)?)
            }
            (Some(Value::Rows(rows)), _, _, Frame::Rectangle(frame)) => {
                let degree = RectangularPatch::from_rows(rows.clone(), frame.clone())?.degree();
                self.check_bidegree(degree)?;
                Piece::Rectangle(RectangularPatch::from_points(degree, lifted(rows.iter().flatten().cloned().collect())?, frame)?)
            }
            (None, Some(Value::Curve(curve)), _, Frame::Interval(frame)) => Piece::Curve(self.raised(curve.clone())?.segment(&frame)?),
            (None, _, Some(Value::Surface(surface)), Frame::Triangle(frame)) => {
                Piece::Triangle(self.read(surface.clone())?.over_triangle(&frame)?)
            }
            (None, _, Some(Value::Surface(surface)), Frame::Rectangle(frame)) => {
                Piece::Rectangle(self.read(surface.clone())?.over_rectangle(&frame)?)
            }
            (None, None, None, _) => return Err(missing(points)),
            (_, _, _, frame) => return Err(wrong_frame(&format!("the frame of a {}", self.domain.name()), &frame)),
        })
    }

    fn check_bidegree(&self, found: (usize, usize)) -> Result<(), Error> {
        match self.pair("bidegree") {
            Ok((p, q)) if (p, q) != found => {
                Err(Error::WrongCount { what: "control points", expected: (p + 1) * (q + 1), found: (found.0 + 1) * (found.1 + 1) })
            }
            _ => Ok(()),
        }
    }

    /// The degree of a curve, where it is given beside the points.
    fn check_count(&self, found: usize) -> Result<(), Error> {
        match self.get("degree") {
            Some(Value::Count(degree)) if degree + 1 != found => {
                Err(Error::WrongCount { what: "control points", expected: degree + 1, found })
            }
            _ => Ok(()),
        }
    }

    /// The degree of a net, where it is given beside the points.
    fn check_degree(&self, found: usize) -> Result<(), Error> {
        match self.get("degree") {
            Some(Value::Count(degree)) if *degree != found => {
                let expected = (degree + 1) * (degree + 2) / 2;
                Err(Error::WrongCount { what: "control points", expected, found: (found + 1) * (found + 2) / 2 })
            }
            _ => Ok(()),
        }
    }

    fn raised(&self, mut curve: Curve<C>) -> Result<Curve<C>, Error> {
        if let Some(weight) = self.weight()? {
            let [variable] = [self.variable()];
            let weight = weight.coefficients_in(variable).iter().map(number_of).collect::<Result<_, _>>()?;
            curve = curve.with_coordinate(weight)?;
        }
        match self.get("degree") {
            Some(Value::Count(degree)) => curve.with_degree(*degree),
            _ => Ok(curve),
        }
    }

    /// The weight that a map is divided by, if it has one.
    fn weight(&self) -> Result<Option<Polynomial>, Error> {
        match self.get("weight") {
            Some(Value::Expressions(list)) => match list.as_slice() {
                [weight] => Ok(Some(weight.clone())),
                other => Err(Error::WrongCount { what: "weights", expected: 1, found: other.len() }),
            },
            _ => Ok(None),
        }
    }

    /// A surface in the way that the arguments or the kind of shape ask for.
    fn read(&self, mut surface: Surface<C>) -> Result<Surface<C>, Error> {
        if let Some(weight) = self.weight()? {
            let [u, v] = self.variables();
            let mut terms = Vec::new();
            for (h, row) in weight.coefficients_in(u).iter().enumerate() {
                for (k, c) in row.coefficients_in(v).iter().enumerate() {
                    terms.push((h, k, number_of(c)?));
                }
            }
            surface = surface.with_coordinate(terms)?;
        }
        match (self.get("degree"), self.get("bidegree")) {
            (Some(Value::Count(degree)), _) => surface.read_as(Reading::Total(*degree)),
            (_, Some(Value::Counts(_))) => {
                let (p, q) = self.pair("bidegree")?;
                surface.read_as(Reading::Bidegree(p, q))
            }
            _ => Ok(surface),
        }
    }
}

/// A coefficient from a polynomial in symbolic parameters.
fn number_of<C: Coefficient>(value: &Polynomial) -> Result<C, Error> {
    C::from_polynomial(value).ok_or_else(|| {
        let symbol = value.symbols().first().map_or_else(String::new, ToString::to_string);
        Error::Unsupported(format!("the weight contains the symbolic parameter `{symbol}`; the variables are those of the map"))
    })
}

fn wrong_frame<C: Coefficient>(expected: &str, found: &Frame<C>) -> Error {
    Error::WrongShape(format!("the frame {found} does not fit: expected {expected}"))
}

impl Arguments<Polynomial> {
    /// The same arguments as numbers, or the name of a symbolic parameter and
    /// of the argument that contains it.
    ///
    /// # Errors
    /// The symbol and the name of the argument.
    pub fn numeric(&self) -> Result<Arguments<Rational>, (Symbol, &'static str)> {
        let mut numeric = Arguments::new(self.domain);
        for (name, value) in &self.values {
            let converted =
                convert(value, &mut |number| number.as_rational().ok_or_else(|| number.symbols()[0])).map_err(|symbol| (symbol, *name))?;
            numeric.insert(name, converted);
        }
        Ok(numeric)
    }
}

/// Brings the numbers of an argument into another ring.
fn convert<A: Coefficient, B: Coefficient, E>(value: &Value<A>, number: &mut impl FnMut(&A) -> Result<B, E>) -> Result<Value<B>, E> {
    let mut list = |values: &[A]| values.iter().map(&mut *number).collect::<Result<Vec<B>, E>>();
    Ok(match value {
        Value::Truth(truth) => Value::Truth(*truth),
        Value::Count(count) => Value::Count(*count),
        Value::Counts(counts) => Value::Counts(counts.clone()),
        Value::Word(word) => Value::Word(word),
        Value::Variables(symbols) => Value::Variables(symbols.clone()),
        Value::Expressions(expressions) => Value::Expressions(expressions.clone()),
        Value::Document(text) => Value::Document(text.clone()),
        Value::Number(value) => Value::Number(number(value)?),
        Value::Numbers(values) => Value::Numbers(list(values)?),
        Value::Point(values) => Value::Point(list(values)?),
        Value::Points(points) => Value::Points(points.iter().map(|point| list(point)).collect::<Result<_, E>>()?),
        Value::Rows(rows) => {
            let mut row = |points: &Vec<Vec<A>>| points.iter().map(|point| list(point)).collect::<Result<_, E>>();
            Value::Rows(rows.iter().map(&mut row).collect::<Result<_, E>>()?)
        }
        Value::Frame(frame) => Value::Frame(frame.map(number)?),
        Value::Arguments(arguments) => Value::Arguments(
            arguments
                .iter()
                .map(|argument| Ok(Parameter::homogeneous(number(&argument.w)?, number(&argument.t)?)))
                .collect::<Result<_, E>>()?,
        ),
        Value::PlaneArguments(arguments) => Value::PlaneArguments(
            arguments
                .iter()
                .map(|argument| Ok(PlaneParameter::homogeneous(number(&argument.w)?, number(&argument.u)?, number(&argument.v)?)))
                .collect::<Result<_, E>>()?,
        ),
        Value::Curve(curve) => Value::Curve(curve.map(number)?),
        Value::Surface(surface) => Value::Surface(surface.map(number)?),
        Value::Map(map) => Value::Map(map.map(number)?),
        // Only answers hold these.
        Value::Matrix(_)
        | Value::Net(_)
        | Value::Piece(_)
        | Value::Pieces(_)
        | Value::Surd(_)
        | Value::Surds(_)
        | Value::Polar(_)
        | Value::HomogeneousPolar(_)
        | Value::Homogeneous(_)
        | Value::Scheme(_)
        | Value::Layers(_)
        | Value::Mesh(_)
        | Value::Defects(..)
        | Value::List(_)
        | Value::Record(_)
        | Value::Nothing => Value::Nothing,
    })
}
