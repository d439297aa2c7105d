//! What an operation found out about a shape, for people to read. The fields
//! of the answer say the same to machines.

use crate::affine::Interval;
use crate::continuity::Continuity;
use crate::cubic::{Cubic, Distance, Equivalence, Family, Intention, NormalForm, Portion, Special};
use crate::curve::Curve;
use crate::exact::Rational;
use crate::geometric::GeometricJoin;
use crate::implicit::{ConicType, ImplicitCurve, Parameters};
use crate::joint::{AffineGroup, Extension, JoinCondition};
use crate::meeting::Meeting;
use crate::piece::Piece;
use crate::quadric::QuadricSurface;
use crate::repair::Repair;
use crate::segment::Segment;
use crate::spline::{KnotJoin, Spline};
use crate::tangent::TangentPlaneJoin;

/// A finding that has a text of its own.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Finding {
    /// The class of a planar cubic.
    Cubic(Box<CubicFinding>),
    /// The classes of a family of cubics.
    Family(Box<Family>),
    /// The implicit equation of a plane curve.
    Implicit(Box<ImplicitFinding>),
    /// The quadric that a surface lies in.
    Quadric(Box<QuadricSurface>),
    /// How two pieces join.
    Join(Box<JoinFinding>),
    /// What a smooth neighbour of a piece is forced to have.
    Extension(Box<Extension>),
    /// The pieces of a spline.
    Spline(Box<SplineFinding>),
}

/// What is known of a planar cubic.
#[derive(Clone, Debug, PartialEq, Eq)]
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
#[derive(Clone, Debug, PartialEq, Eq)]
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

/// What is known of the join of two pieces.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct JoinFinding {
    /// Where they meet.
    pub meeting: Meeting,
    /// Whether they lie on one side of their joint.
    pub overlap: bool,
    /// The order of continuity, where they have a common parameter: of rational pieces the Cartesian one.
    pub order: Option<Continuity>,
    /// The orders of the homogeneous maps of rational pieces: as they are, and up to a factor.
    pub homogeneous: Option<(Continuity, Continuity)>,
    /// The geometric continuity, where that means something.
    pub contact: Option<Contact>,
    /// The conditions one by one.
    pub conditions: Vec<JoinCondition>,
    /// Of two triangles: the barycentric coordinates of `q`, and the groups of four points.
    pub groups: Option<([Rational; 3], Vec<AffineGroup>)>,
    /// What was required, and whether it holds.
    pub requirement: Option<(&'static str, bool)>,
    /// The least change of the second piece, if that was asked for: what is said above is true before it.
    pub repair: Option<RepairFinding>,
}

/// The geometric continuity of a join.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Contact {
    /// Of curves.
    Curves(GeometricJoin),
    /// Of patches.
    Patches(Box<TangentPlaneJoin>),
}

impl Contact {
    /// The highest order found, -1 if the points or edges differ; none where
    /// that is undecided because a normal vanishes.
    #[must_use]
    pub fn order(&self) -> Option<i64> {
        match self {
            Self::Curves(join) => Some(join.order.map_or(-1, |order| order as i64)),
            Self::Patches(join) if !join.same_edge => Some(-1),
            Self::Patches(join) => join.g1().map(i64::from),
        }
    }
}

/// A piece that was changed so that it joins another one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RepairFinding {
    /// The piece as it was.
    pub before: Piece,
    /// The change.
    pub repair: Repair,
    /// Whether the last coordinate of both is the weight.
    pub rational: bool,
    /// The order found afterwards, `C` or geometric.
    pub reached: String,
}

/// What is known of a spline.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SplineFinding {
    /// The spline.
    pub spline: Spline,
    /// Its Bézier pieces.
    pub pieces: Vec<Segment>,
    /// Its knots between pieces.
    pub joins: Vec<KnotJoin>,
    /// The same spline with one more knot, if that was asked for.
    pub inserted: Option<Spline>,
}
