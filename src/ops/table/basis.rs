//! Operations on numbers, and on Bernstein polynomials.

use super::parameters::*;
use super::{Growth, Kind, Operation, Run};
use crate::ops::numbers;
use crate::value::Domain;

const NUMBERS: &[Domain] = &[Domain::Curve];
const TRIANGLES: &[Domain] = &[Domain::Triangle];
const ALL: &[Domain] = &[Domain::Curve, Domain::Triangle, Domain::Rectangle];

pub(super) const OPERATIONS: &[Operation] = &[
    Operation {
        name: "bernstein",
        verb: "bernstein",
        domains: ALL,
        selected_by: &[],
        doc: "The Bernstein polynomials of a degree over a frame, their maxima, and their values",
        example: "casteljau bernstein --degree 3 --over 0..1",
        parameters: &[
            optional("degree", Kind::Count, "degree", "the degree, or the total degree on a triangle"),
            optional("bidegree", Kind::Counts, "bidegree", "the bidegree P,Q of the products on a rectangle"),
            optional("index", Kind::Counts, "index", "only this one: k, or i,j,k on a triangle, or i,j on a rectangle"),
            OVER,
            optional("t", Kind::Place, "at", "also the values at this parameter"),
        ],
        growth: Growth::Basis,
        run: Run::Numeric(numbers::bernstein),
    },
    Operation {
        name: "influence",
        verb: "influence",
        domains: ALL,
        selected_by: &[],
        doc: "What moving one control point does: by which function the curve or patch changes, and where most",
        example: "casteljau influence '(0,0,0) (0,1,0); (1,0,0) (1,1,1)' --index 1,1 --by '(0,0,2)'",
        parameters: &[
            EITHER_POINTS,
            OVER,
            required("index", Kind::Counts, "index", "the control point: k, or i,j,k in a triangle, or i,j in a rectangle"),
            optional("by", Kind::Point, "by", "the vector that the control point is moved by"),
        ],
        growth: Growth::Linear,
        run: Run::Numeric(numbers::influence),
    },
    Operation {
        name: "barycentric",
        verb: "barycentric",
        domains: TRIANGLES,
        selected_by: &[],
        doc: "The barycentric coordinates of a point of the parameter plane",
        example: "casteljau barycentric --over '(1,0) (0,1) (0,0)' --at 1/2,1/3",
        parameters: &[OVER, AT_POINT],
        growth: Growth::Direct,
        run: Run::Any(numbers::barycentric, numbers::barycentric),
    },
    Operation {
        name: "sigma",
        verb: "sigma",
        domains: NUMBERS,
        selected_by: &[],
        doc: "The elementary symmetric functions of a list of numbers",
        example: "casteljau sigma '1 2 3'",
        parameters: &[required("values", Kind::Numbers, "", "the numbers, such as '1 2 3'")],
        growth: Growth::Linear,
        run: Run::Any(numbers::sigma, numbers::sigma),
    },
    Operation {
        name: "roots.bernstein",
        verb: "roots",
        domains: NUMBERS,
        selected_by: &[],
        doc: "How often a curve crosses a line or plane inside its frame: sign variations, and the exact number of roots",
        example: "casteljau roots '(0,0) (1,2) (2,-2) (3,1)' --plane 'y' --isolate",
        parameters: &[
            EITHER_CURVE,
            EITHER_POINTS,
            OVER,
            optional("plane", Kind::Plane, "plane", "the line or plane, such as 'x - 2y + 1' (zero on it)"),
            optional("isolate", Kind::Flag, "isolate", "also the roots, exact or in disjoint intervals"),
            optional("width", Kind::Number, "width", "what these intervals are at most wide"),
        ],
        growth: Growth::Linear,
        run: Run::Numeric(numbers::roots),
    },
];
