//! What an operation found out about a shape, for people to read. The fields
//! of the answer say the same to machines.

use crate::affine::Interval;
use crate::cubic::{Cubic, Distance, Equivalence, Family, Intention, NormalForm, Portion, Special};
use crate::curve::Curve;
use crate::exact::Rational;
use crate::implicit::{ConicType, ImplicitCurve, Parameters};
use crate::quadric::QuadricSurface;

/// A finding that has a text of its own.
#[derive(Clone, Debug, PartialEq)]
pub enum Finding {
    /// The class of a planar cubic.
    Cubic(Box<CubicFinding>),
    /// The classes of a family of cubics.
    Family(Box<Family>),
    /// The implicit equation of a plane curve.
    Implicit(Box<ImplicitFinding>),
    /// The quadric that a surface lies in.
    Quadric(Box<QuadricSurface>),
}

/// What is known of a planar cubic.
#[derive(Clone, Debug, PartialEq)]
pub struct CubicFinding {
    /// The cubic.
    pub cubic: Cubic,
    /// Its special points.
    pub special: Special,
    /// The maps from the standard cubic.
    pub normal: Option<NormalForm>,
    /// The features of the segment, where a frame is known.
    pub portion: Option<Portion>,
    /// The distance to another class, if it was asked for.
    pub distance: Option<Distance>,
    /// What decimals may be meant to be, if that was asked for.
    pub intention: Option<Intention>,
    /// The maps to another cubic, or why there are none, if that was asked.
    pub equivalence: Option<Result<Equivalence, String>>,
}

/// What is known of a plane curve as a set of points.
#[derive(Clone, Debug, PartialEq)]
pub struct ImplicitFinding {
    /// The curve.
    pub curve: Curve,
    /// Its equation.
    pub implicit: ImplicitCurve,
    /// The type, if it is a conic.
    pub conic: Option<ConicType>,
    /// A point and its gauge, if that was asked for.
    pub gauge: Option<(Vec<Rational>, Rational)>,
    /// A point and its parameters, if that was asked for.
    pub membership: Option<(Vec<Rational>, Parameters)>,
    /// The frame, where one is known.
    pub frame: Option<Interval>,
}
