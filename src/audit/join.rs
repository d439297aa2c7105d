//! Joins: what is found of them, and what they are held to.

use super::requirement::Requirement;
use super::tangent::Contact;
use super::tolerance::Tolerance;
use super::verdict::{Rounding, Verdict};
use crate::continuity::Continuity;
use crate::exact::Rational;
use crate::side::Side;

/// A join of a model and what was found of it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Join {
    /// The part and its side with the smaller index.
    pub first: (usize, Side),
    /// The other part and its side.
    pub second: (usize, Side),
    /// Whether the two sides run in opposite directions.
    pub reversed: bool,
    /// The index of the joint that the file states, in an outline or a spline.
    pub stated: Option<usize>,
    /// The order of parametric continuity.
    pub parametric: Continuity,
    /// The order of geometric continuity, at most 3 for curves and 1 for patches;
    /// none if the points differ.
    pub geometric: Option<usize>,
    /// What the tangents or tangent planes have in common.
    pub contact: Contact,
    /// The constant ratio of the second cross-boundary difference to the first.
    pub ratio: Option<Rational>,
    /// A lower and an upper bound of the largest squared sine of the angle.
    pub sin2: Option<[Rational; 2]>,
    /// Whether the angle is a right one or larger somewhere.
    pub obtuse: bool,
    /// The least squared move of the control points behind one side that makes
    /// the tangents run on.
    pub offset2: Option<Rational>,
    /// Whether rounding explains what is missing.
    pub rounding: Rounding,
    /// What was required of it.
    pub requirement: Option<Requirement>,
    /// The verdict.
    pub verdict: Verdict,
    /// The joint itself: the control points of the first part there; of patches
    /// only where there is something to find.
    pub points: Vec<Vec<Rational>>,
    /// The differences behind the joint, first into the first part, then into the
    /// second; as for `points`, and none of rational pieces.
    pub handles: [Vec<Vec<Rational>>; 2],
}

/// How joins are judged.
#[derive(Clone, Debug, Default)]
pub struct Terms {
    /// What every join must have; a promise in the file holds without it.
    pub require: Option<Requirement>,
    /// Whether promises in the file are not held to.
    pub ignores_promises: bool,
    /// What it may be off by.
    pub tolerance: Tolerance,
}
