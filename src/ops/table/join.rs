//! Operations on joins and splines.

use super::parameters::{optional, required};
use super::{Growth, Kind, Operation, Parameter, Run};
use crate::ops::join;
use crate::value::Domain;

const CURVES: &[Domain] = &[Domain::Curve];
const TRIANGLES: &[Domain] = &[Domain::Triangle];
const RECTANGLES: &[Domain] = &[Domain::Rectangle];

const A: Parameter = required("A", Kind::Piece, "", "the first piece: frame and points, or homogeneous_points");
const B: Parameter = required("B", Kind::Piece, "", "the second piece");
const AT: Parameter = required("at", Kind::Number, "", "the parameter of the joint");
const EDGE: Parameter = required("edge", Kind::Edge, "", "the two shared points of the parameter plane");
const AXIS: Parameter = required("axis", Kind::Word(&["u", "v"]), "", "the parameter that is constant on the joint");

const fn row(name: &'static str, domains: &'static [Domain], doc: &'static str, parameters: &'static [Parameter], run: Run) -> Operation {
    Operation { name, verb: "", domains, selected_by: &[], doc, example: "", parameters, growth: Growth::Linear, run }
}

pub(super) const OPERATIONS: &[Operation] = &[
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
        growth: Growth::Scheme,
        run: Run::Numeric(join::spline),
    },
    row("join.curve", CURVES, "The order of continuity of two curves at a parameter", &[A, B, AT], Run::Numeric(join::curves)),
    row("join.triangle", TRIANGLES, "The order of continuity of two triangles across an edge", &[A, B, EDGE], Run::Numeric(join::surfaces)),
    row(
        "join.rectangle",
        RECTANGLES,
        "The order of continuity of two rectangles along a constant parameter",
        &[A, B, AXIS, AT],
        Run::Numeric(join::rectangles),
    ),
    row("join.mixed", RECTANGLES, "The order of continuity of a rectangle and a triangle", &[A, B, EDGE], Run::Numeric(join::surfaces)),
    row(
        "join.curve_rational",
        CURVES,
        "The Cartesian and the homogeneous order of continuity of two rational curves",
        &[A, B, AT],
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
