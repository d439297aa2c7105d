//! What operations take and give.

use crate::affine::{AffineMap, Interval, Parameter};
use crate::blossom::{PolarDefect, PolarForm};
use crate::curve::Curve;
use crate::exact::Rational;
use crate::scheme::Scheme;
use crate::segment::Segment;
use crate::symbolic::{Polynomial, Symbol};

/// One argument or one part of an answer.
#[derive(Clone, Debug, PartialEq)]
pub enum Value<C = Rational> {
    /// Yes or no.
    Truth(bool),
    /// A small whole number: a degree, a depth, a count.
    Count(usize),
    /// A number, or a polynomial in symbolic parameters.
    Number(C),
    /// A list of numbers.
    Numbers(Vec<C>),
    /// A point or a vector.
    Point(Vec<C>),
    /// Points without labels: a polyline, a hull.
    Points(Vec<Vec<C>>),
    /// A frame of the parameter line.
    Frame(Interval<C>),
    /// Homogeneous arguments of a polar form.
    Arguments(Vec<Parameter<C>>),
    /// A curve by its equation.
    Curve(Curve<C>),
    /// The control points of a segment, where the frame is known from elsewhere.
    Net(Segment<C>),
    /// A segment with its frame.
    Piece(Segment<C>),
    /// Pieces in order.
    Pieces(Vec<Segment<C>>),
    /// A polar form.
    Polar(PolarForm<C>),
    /// The steps of de Casteljau's algorithm.
    Scheme(Scheme<C>),
    /// An affine map.
    Map(AffineMap<C>),
    /// Polynomials in named variables: a claimed polar form, the equation of a line.
    Expressions(Vec<Polynomial>),
    /// The letter that the curve's parameter is written with.
    Variable(Symbol),
    /// What is wrong with a claimed polar form.
    Defects(Vec<PolarDefect>),
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

/// What an operation found.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer<C = Rational> {
    /// The parts, in the order they are printed.
    pub fields: Vec<(&'static str, Value<C>)>,
    /// Whether a yes-or-no question was answered yes; `None` where none was asked.
    pub holds: Option<bool>,
}

impl<C> Answer<C> {
    /// An answer with these parts.
    #[must_use]
    pub fn new(fields: Vec<(&'static str, Value<C>)>) -> Self {
        Self { fields, holds: None }
    }

    /// The same, answering a question.
    #[must_use]
    pub fn that_holds(self, holds: bool) -> Self {
        Self { holds: Some(holds), ..self }
    }
}
