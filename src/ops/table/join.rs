//! Operations on joins and splines.

use super::parameters::*;
use super::{Growth, Kind, Operation, Parameter, Run};
use crate::ops::{extension, join, joint};
use crate::value::Domain;

const CURVES: &[Domain] = &[Domain::Curve];
const TRIANGLES: &[Domain] = &[Domain::Triangle];
const RECTANGLES: &[Domain] = &[Domain::Rectangle];

const A: Parameter = required("A", Kind::Piece, "", "the first piece: frame and points, or homogeneous_points");
const B: Parameter = required("B", Kind::Piece, "", "the second piece");
const PARAMETER: Parameter = required("at", Kind::Number, "", "the parameter of the joint");
const EDGE: Parameter = required("edge", Kind::Edge, "", "the two shared points of the parameter plane");
const AXIS: Parameter = required("axis", Kind::Word(&["u", "v"]), "", "the parameter that is constant on the joint");

const OTHER_WEIGHTS: Parameter = optional("other_weights", Kind::Weights, "", "the weights of the second piece");
const JOINT: Parameter =
    optional("at", Kind::Number, "at", "the parameter of the joint of curves, if the frames do not say (to extend: s unless said)");
const END: Parameter = optional(
    "edge",
    Kind::Word(ENDS),
    "edge",
    "the end or edge of the first piece: start, end; rs, st, tr; u0, u1, v0, v1 (to extend: end, st or u1 unless said)",
);
const OTHER_END: Parameter = optional(
    "other_edge",
    Kind::Word(ENDS),
    "other-edge",
    "that of the second piece, where the two meet in space whatever their parameters",
);
const ENDS: &[&str] = &["start", "end", "rs", "st", "tr", "u0", "u1", "v0", "v1"];
const ORDERS: &[&str] = &["C0", "C1", "C2", "C3", "C4", "G1", "G2", "G3"];
const REQUIRE: &str = "exit status 1 unless it is at least this smooth: C0 to C4, or G1 to G3 (patches to G1)";

const fn row(name: &'static str, domains: &'static [Domain], doc: &'static str, parameters: &'static [Parameter], run: Run) -> Operation {
    Operation { name, verb: "", domains, selected_by: &[], doc, example: "", parameters, growth: Growth::Linear, run }
}

const ALL: &[Domain] = &[Domain::Curve, Domain::Triangle, Domain::Rectangle];

pub(super) const OPERATIONS: &[Operation] = &[
    Operation {
        name: "join",
        verb: "join",
        domains: ALL,
        selected_by: &[],
        doc: "The parametric and geometric order of continuity between two pieces, condition by condition",
        example: "casteljau join '(0,0) (1,2) (3,2) (4,0)' '(4,0) (5,-2) (7,1)' --over 0..1 --other-over 1..2",
        parameters: &[
            EITHER_CURVE,
            EITHER_SURFACE,
            EITHER_POINTS,
            WEIGHTS,
            OVER,
            OTHER_CURVE,
            OTHER_SURFACE,
            OTHER_POINTS,
            OTHER_WEIGHTS,
            OTHER_OVER,
            JOINT,
            END,
            OTHER_END,
            optional("order", Kind::Count, "order", "list the conditions up to this order"),
            optional("require", Kind::Word(ORDERS), "require", REQUIRE),
        ],
        growth: Growth::Scheme,
        run: Run::Numeric(joint::join),
    },
    Operation {
        name: "join.repair",
        verb: "join",
        domains: ALL,
        selected_by: &["repair"],
        doc: "The change of the second piece with the least sum of squared displacements that makes the join as smooth as required",
        example: "casteljau join '(0,0) (1,2) (3,2) (4,0)' '(4,0) (5,-1) (7,1)' --over 0..1 --other-over 1..2 --repair --require G1",
        parameters: &[
            EITHER_CURVE,
            EITHER_SURFACE,
            EITHER_POINTS,
            WEIGHTS,
            OVER,
            OTHER_CURVE,
            OTHER_SURFACE,
            OTHER_POINTS,
            OTHER_WEIGHTS,
            OTHER_OVER,
            JOINT,
            END,
            OTHER_END,
            optional("repair", Kind::Flag, "repair", "move control points of the second piece; weights stay as they are"),
            required("require", Kind::Word(ORDERS), "require", "what the join is to be: C0 to C4, or G1 with a constant ratio"),
        ],
        growth: Growth::Scheme,
        run: Run::Numeric(joint::repair),
    },
    Operation {
        name: "join.extend",
        verb: "join",
        domains: ALL,
        selected_by: &["extend"],
        doc: "The control points that a neighbour with continuity of some order is forced to have, and the free ones",
        example: "casteljau join '(0,0) (1,2) (3,2) (4,0)' --over 0..1 --extend 2 --order 1",
        parameters: &[
            EITHER_CURVE,
            EITHER_SURFACE,
            EITHER_POINTS,
            OVER,
            required(
                "extend",
                Kind::Place,
                "extend",
                "the neighbour's vertex off the joint: where a curve or rectangle ends, or a point of the plane",
            ),
            JOINT,
            END,
            required("order", Kind::Count, "order", "the order of continuity"),
        ],
        growth: Growth::Linear,
        run: Run::Numeric(extension::extension),
    },
    Operation {
        name: "bspline.pieces",
        verb: "spline",
        domains: CURVES,
        selected_by: &[],
        doc: "The Bézier pieces of a B-spline, and the order of continuity at each knot",
        example: "casteljau spline '(0,0) (1,2) (3,2) (4,0)' --degree 2 --knots '0 0 0 1 2 2 2' --insert 1/2",
        parameters: &[
            required("points", Kind::Points, "", "the de Boor points"),
            required("knots", Kind::Numbers, "knots", "the knots, degree + 1 more than points"),
            required("degree", Kind::Count, "degree", "the degree"),
            optional("insert", Kind::Number, "insert", "also the points with this knot inserted"),
        ],
        growth: Growth::Counted,
        run: Run::Numeric(join::spline),
    },
    row("join.curve", CURVES, "The order of continuity of two curves at a parameter", &[A, B, PARAMETER], Run::Numeric(join::curves)),
    row("join.triangle", TRIANGLES, "The order of continuity of two triangles across an edge", &[A, B, EDGE], Run::Numeric(join::surfaces)),
    row(
        "join.rectangle",
        RECTANGLES,
        "The order of continuity of two rectangles along a constant parameter",
        &[A, B, AXIS, PARAMETER],
        Run::Numeric(join::rectangles),
    ),
    row("join.mixed", RECTANGLES, "The order of continuity of a rectangle and a triangle", &[A, B, EDGE], Run::Numeric(join::surfaces)),
    row(
        "join.curve_rational",
        CURVES,
        "The Cartesian and the homogeneous order of continuity of two rational curves",
        &[A, B, PARAMETER],
        Run::Numeric(join::rational_curves),
    ),
    row(
        "join.triangle_rational",
        TRIANGLES,
        "The Cartesian and the homogeneous order of continuity of two rational triangles",
        &[A, B, EDGE],
        Run::Numeric(join::rational_triangles),
    ),
    row(
        "geometric.curve",
        CURVES,
        "The order of geometric continuity of two curves, with its shape parameters",
        &[
            required("F", Kind::Curve, "", "the first curve"),
            required("G", Kind::Curve, "", "the second curve"),
            required("tF", Kind::Number, "", "the parameter of the first curve"),
            required("tG", Kind::Number, "", "that of the second one"),
        ],
        Run::Numeric(join::geometric_curves),
    ),
    row(
        "geometric.triangle",
        TRIANGLES,
        "Whether two triangles, each with its inner vertex first, have common tangent planes along their edge",
        &[A, B],
        Run::Numeric(join::geometric_triangles),
    ),
];
