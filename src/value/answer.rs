//! What operations take and give.

use crate::affine::{AffineMap, Frame, Parameter, PlaneParameter};
use crate::blossom::{PolarDefect, PolarForm};
use crate::curve::Curve;
use crate::exact::{Rational, Surd};
use crate::mesh::Mesh;
use crate::piece::{Equation, Piece};
use crate::reading::Reading;
use crate::scheme::Scheme;
use crate::surface::Surface;
use crate::symbolic::{Polynomial, Symbol};

use super::Finding;

/// One argument or one part of an answer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Value<C = Rational> {
    /// Yes or no.
    Truth(bool),
    /// A small whole number: a degree, a depth, a count.
    Count(usize),
    /// A whole number that may be negative.
    Integer(i64),
    /// Several counts: a bidegree, the index of a control point.
    Counts(Vec<usize>),
    /// A number, or a polynomial in symbolic parameters.
    Number(C),
    /// A list of numbers.
    Numbers(Vec<C>),
    /// A number `a ± √d`.
    Surd(Surd),
    /// Numbers `a ± √d`: a point, or a list of parameters.
    Surds(Vec<Surd>),
    /// A point or a vector.
    Point(Vec<C>),
    /// Points without labels: a polyline, a hull, the control points of a curve.
    Points(Vec<Vec<C>>),
    /// The control points of a patch, row by row.
    Rows(Vec<Vec<Vec<C>>>),
    /// Rows of numbers.
    Matrix(Vec<Vec<C>>),
    /// A frame.
    Frame(Frame<C>),
    /// Homogeneous arguments of a polar form, on the line.
    Arguments(Vec<Parameter<C>>),
    /// Homogeneous arguments of a polar form, in the plane.
    PlaneArguments(Vec<PlaneParameter<C>>),
    /// A curve by its equation.
    Curve(Curve<C>),
    /// A surface by its equation.
    Surface(Surface<C>),
    /// The control points of a piece, where the frame is known from elsewhere.
    Net(Piece<C>),
    /// A piece with its frame.
    Piece(Piece<C>),
    /// Pieces in order.
    Pieces(Vec<Piece<C>>),
    /// A polar form.
    Polar(PolarForm<C>),
    /// A polar form with the weights of homogeneous arguments.
    HomogeneousPolar(PolarForm<C>),
    /// A homogenized polynomial.
    Homogeneous(Homogeneous<C>),
    /// The steps of de Casteljau's algorithm on a curve.
    Scheme(Scheme<C>),
    /// The steps of de Casteljau's algorithm on a patch.
    Layers(Layers<C>),
    /// A triangle mesh.
    Mesh(Mesh),
    /// An affine map.
    Map(AffineMap<C>),
    /// Polynomials in named variables: a claimed polar form, a weight.
    Expressions(Vec<Polynomial>),
    /// The letters that the parameters are written with.
    Variables(Vec<Symbol>),
    /// What is wrong with a claimed polar form, in some reading.
    Defects(Reading, Vec<PolarDefect>),
    /// A name from a fixed list.
    Word(&'static str),
    /// A finished document, such as a picture.
    Document(String),
    /// Several values.
    List(Vec<Value<C>>),
    /// Named values in order.
    Record(Vec<(&'static str, Value<C>)>),
    /// What does not exist.
    Nothing,
}

/// A homogenized polynomial: terms with an exponent for every letter.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Homogeneous<C = Rational> {
    /// The letters, each weight before what it belongs to.
    pub letters: &'static [char],
    /// The terms: exponents and coefficient.
    pub terms: Vec<(Vec<usize>, C)>,
}

/// Points with their polar labels.
pub type LabelledRow<C = Rational> = Vec<(String, Vec<C>)>;

/// Points with their polar labels, row by row in each of several layers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Layers<C = Rational> {
    /// What a layer is called: "step", "layer".
    pub name: &'static str,
    /// The layers.
    pub layers: Vec<Vec<LabelledRow<C>>>,
    /// Whether the rows are part of the data, or each layer is one list.
    pub in_rows: bool,
}

/// What an operation found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Answer<C = Rational> {
    /// The parts, in the order they are printed.
    pub fields: Vec<(&'static str, Value<C>)>,
    /// Whether a yes-or-no question was answered yes; `None` where none was asked.
    pub holds: Option<bool>,
    /// Whether control points are homogeneous, their last coordinate being the weight.
    pub weighted: bool,
    /// The same for people, where that has a text of its own.
    pub finding: Option<Finding>,
}

impl<C> Answer<C> {
    /// An answer with these parts.
    #[must_use]
    pub fn new(fields: Vec<(&'static str, Value<C>)>) -> Self {
        Self { fields, holds: None, weighted: false, finding: None }
    }

    /// The same with a text of its own for people.
    #[must_use]
    pub fn with_finding(self, finding: Finding) -> Self {
        Self { finding: Some(finding), ..self }
    }

    /// The same, answering a question.
    #[must_use]
    pub fn that_holds(self, holds: bool) -> Self {
        Self { holds: Some(holds), ..self }
    }

    /// The same, its control points being homogeneous or not.
    #[must_use]
    pub fn weighted(self, weighted: bool) -> Self {
        Self { weighted, ..self }
    }
}

impl<C> From<Equation<C>> for Value<C> {
    fn from(equation: Equation<C>) -> Self {
        match equation {
            Equation::Curve(curve) => Self::Curve(curve),
            Equation::Surface(surface) => Self::Surface(surface),
        }
    }
}
