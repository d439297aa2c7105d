//! Operations on joins and splines.

use super::parameters::*;
use super::{Growth, Kind, Operation, Parameter, Run};
use crate::ops::join;
use crate::value::Domain;

const CURVES: &[Domain] = &[Domain::Curve];
const TRIANGLES: &[Domain] = &[Domain::Triangle];
const RECTANGLES: &[Domain] = &[Domain::Rectangle];

const A: Parameter = required("A", Kind::Piece, "", "the first piece: frame and points, or homogeneous_points");
const B: Parameter = required("B", Kind::Piece, "", "the second piece");
const PARAMETER: Parameter = required("at", Kind::Number, "", "the parameter of the joint");
const EDGE: Parameter = required("edge", Kind::Edge, "", "the two shared points of the parameter plane");
const AXIS: Parameter = required("axis", Kind::Word(&["u", "v"]), "", "the parameter that is constant on the joint");

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
        doc: "The order of continuity between two pieces, condition by condition",
        example: "casteljau join '(0,0) (1,2) (3,2) (4,0)' '(4,0) (5,-2) (7,1)' --over 0..1 --other-over 1..2",
        parameters: &[
            EITHER_POINTS,
            WEIGHTS,
            OVER,
            OTHER_POINTS,
            optional("other_weights", Kind::Weights, "", "the weights of the second piece"),
            OTHER_OVER,
            optional("at", Kind::Number, "at", "the parameter where two curves join, if their frames do not say"),
            optional("order", Kind::Count, "order", "list the conditions up to this order"),
            optional("require", Kind::Word(&["C0", "C1", "C2", "C3", "C4"]), "require", "exit status 1 unless it is at least this smooth"),
        ],
        growth: Growth::Scheme,
        run: Run::Numeric(join::join),
    },
    Operation {
        name: "join.extend",
        verb: "join",
        domains: ALL,
        selected_by: &["extend"],
        doc: "The control points that a neighbour with continuity of some order is forced to have, and the free ones",
        example: "casteljau join '(0,0) (1,2) (3,2) (4,0)' --over 0..1 --extend 2 --order 1",
        parameters: &[
            EITHER_POINTS,
            OVER,
            required(
                "extend",
                Kind::Place,
                "extend",
                "the neighbour's vertex off the joint: where a curve or rectangle ends, or a point of the plane",
            ),
            optional("at", Kind::Number, "at", "the end of a curve that it is continued from (s unless said)"),
            optional("edge", Kind::Word(EDGES), "edge", "the edge of a patch: rs, st (unless said) or tr; u0, u1 (unless said), v0 or v1"),
            required("order", Kind::Count, "order", "the order of continuity"),
        ],
        growth: Growth::Linear,
        run: Run::Numeric(join::extension),
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
