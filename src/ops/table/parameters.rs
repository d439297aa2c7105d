//! The arguments that several operations share.

use super::{Kind, Parameter};

pub(super) const fn required(name: &'static str, kind: Kind, flag: &'static str, help: &'static str) -> Parameter {
    Parameter { name, kind, required: true, flag, help }
}

pub(super) const fn optional(name: &'static str, kind: Kind, flag: &'static str, help: &'static str) -> Parameter {
    Parameter { name, kind, required: false, flag, help }
}

pub(super) const CURVE: Parameter = required("curve", Kind::Curve, "", "the equation, such as '(t, t^2)'");
pub(super) const SURFACE: Parameter = required("surface", Kind::Surface, "", "the equation, such as '(u, v, u v)' or 'z = x y'");
pub(super) const POINTS: Parameter = required("points", Kind::Points, "", "the control points, such as '(0,0) (1,2) (2,0)'");
pub(super) const ROWS: Parameter = required("points", Kind::Points, "", "the control net, row by row, such as '0 1; 2' or '0 1; 2 3'");
pub(super) const EITHER_CURVE: Parameter = optional("curve", Kind::Curve, "", "the equation, such as '(t, t^2)'");
pub(super) const EITHER_SURFACE: Parameter = optional("surface", Kind::Surface, "", "the equation, such as '(u, v, u v)' or 'z = x y'");
pub(super) const EITHER_POINTS: Parameter = optional("points", Kind::Points, "", "or the control points, such as '(0,0) (1,2) (2,0)'");
pub(super) const EITHER_ROWS: Parameter = optional("points", Kind::Points, "", "or the control net, row by row, such as '0 1; 2 3'");
pub(super) const WEIGHTS: Parameter =
    optional("weights", Kind::Weights, "", "the weights of the control points, on the command line behind them as in '(1,1):2'");
pub(super) const WEIGHT: Parameter = optional("weight", Kind::Weight, "weight", "what the equation is divided by, as in '1 + t^2'");
pub(super) const OVER: Parameter = optional(
    "frame",
    Kind::Frame,
    "over",
    "the frame: r..s (0..1 unless said), a triangle '(1,0) (0,1) (0,0)' or a rectangle '0..1, 0..1'",
);
pub(super) const OVER_POINTS: Parameter = optional("frame", Kind::FrameOfPoints, "over", OVER.help);
pub(super) const OVER_REQUIRED: Parameter = required(
    "frame",
    Kind::Frame,
    "over",
    "the frame: r..s (r > s is allowed), a triangle '(1,0) (0,1) (0,0)' or a rectangle '0..1, 0..1'",
);
pub(super) const NEW_FRAME: Parameter = required("new_frame", Kind::Frame, "to", "the new frame");
pub(super) const DEGREE: Parameter =
    optional("degree", Kind::Count, "degree", "the polar degree, if it is to be higher than the degree; of a surface the total degree");
pub(super) const NET_DEGREE: Parameter = optional("degree", Kind::Count, "degree", "the total degree, which the number of points says too");
pub(super) const BIDEGREE: Parameter =
    optional("bidegree", Kind::Counts, "bidegree", "the bidegree P,Q: the surface is read variable by variable");
pub(super) const AT: Parameter = required("t", Kind::Number, "at", "the parameter: a number, or two, such as 1/3,1/4, on a surface");
pub(super) const AT_POINT: Parameter = required("a", Kind::Point, "at", AT.help);
pub(super) const AT_U: Parameter = required("u", Kind::FirstParameter, "at", AT.help);
pub(super) const AT_V: Parameter = required("v", Kind::SecondParameter, "at", AT.help);
pub(super) const PLACE: Parameter = required("t", Kind::Place, "at", AT.help);
pub(super) const STEPS: Parameter = optional("steps", Kind::Flag, "steps", "all intermediate points with their polar labels");
pub(super) const OTHER_CURVE: Parameter = optional("other_curve", Kind::Curve, "", "the second equation");
pub(super) const OTHER_SURFACE: Parameter = optional("other_surface", Kind::Surface, "", "the second equation");
pub(super) const OTHER_POINTS: Parameter = optional("other_points", Kind::Points, "", "or the second control points");
pub(super) const OTHER_OVER: Parameter =
    optional("other_frame", Kind::Frame, "other-over", "the frame of the second piece, if it is another");
pub(super) const CLAIM: Parameter =
    required("claim", Kind::Claim, "check", "a claimed polar form in t1, t2, … or U1, V1, U2, … or u1, …, v1, …");
pub(super) const BY: Parameter =
    optional("by", Kind::Count, "by", "how many degrees more (1 unless said); for a rectangle two, such as 1,0");
pub(super) const ORDER: Parameter = optional("order", Kind::Count, "order", "the order (1 unless said)");
pub(super) const DEPTH: Parameter = optional("depth", Kind::Count, "depth", "split in the middle this many times");
pub(super) const MIDPOINTS: Parameter = optional(
    "midpoints",
    Kind::Flag,
    "midpoints",
    "split in the middle, once unless a depth is given; a triangle at the midpoints of its edges",
);
pub(super) const FROM: Parameter = required("A", Kind::Point, "from", "where the segment begins, such as 0,0");
pub(super) const TO: Parameter = required("B", Kind::Point, "to", "where it ends");
pub(super) const DIRECTION: Parameter =
    optional("direction", Kind::Point, "direction", "the direction in the parameter plane, such as 1,0 (which is the first variable)");
pub(super) const METHOD: Parameter =
    optional("method", Kind::Word(&["two-step", "one-step"]), "method", "two-step: one parameter after the other; one-step: both at once");
pub(super) const EDGES: &[&str] = &["rs", "st", "tr", "u0", "u1", "v0", "v1"];
