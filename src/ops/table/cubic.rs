//! Operations on planar cubics, and on the equations of curves and surfaces.

use super::parameters::*;
use super::{Growth, Kind, Operation, Run};
use crate::ops::{cubic, implicit, picture};
use crate::value::Domain;

const CURVES: &[Domain] = &[Domain::Curve];
const SURFACES: &[Domain] = &[Domain::Triangle, Domain::Rectangle];

pub(super) const OPERATIONS: &[Operation] = &[
    Operation {
        name: "cubic.classify",
        verb: "classify",
        domains: CURVES,
        selected_by: &[],
        doc: "The class of a planar cubic, its invariants, special points and normal form",
        example: "casteljau classify '(0,0) (-4,4) (-4,-12) (0,0)' --over -1..3",
        parameters: &[
            EITHER_CURVE,
            EITHER_POINTS,
            optional("frame", Kind::FrameOfPoints, "over", "the frame r..s of the segment, which its features are compared with"),
            optional("details", Kind::Flag, "details", "also what other systems call it, its rational form and its graph (in JSON)"),
            optional(
                "distance",
                Kind::Flag,
                "distance",
                "also the smallest move of one coordinate of a control point that changes the class",
            ),
            optional("other", Kind::Shape, "equivalent", "whether it is the affine image of this cubic, and by which maps"),
        ],
        growth: Growth::Direct,
        run: Run::Numeric(cubic::classify),
    },
    Operation {
        name: "cubic.class",
        verb: "classify",
        domains: CURVES,
        selected_by: &["short"],
        doc: "The class of a planar cubic alone, for streams of many",
        example: "casteljau classify '(t^2, t^3 - t)' --short",
        parameters: &[EITHER_CURVE, EITHER_POINTS, OVER_POINTS, optional("short", Kind::Flag, "short", "the class and nothing else")],
        growth: Growth::Direct,
        run: Run::Numeric(cubic::class),
    },
    Operation {
        name: "cubic.family",
        verb: "classify",
        domains: CURVES,
        selected_by: &["family"],
        doc: "Where the class of a cubic with one symbolic parameter changes, and the classes in between",
        example: "casteljau classify '(t^2, t^3 + k t)' --family",
        parameters: &[
            EITHER_CURVE,
            EITHER_POINTS,
            OVER_POINTS,
            optional("family", Kind::Flag, "family", "treat the symbolic parameter of the coefficients as a number that varies"),
        ],
        growth: Growth::Direct,
        run: Run::Any(cubic::family, cubic::family),
    },
    Operation {
        name: "cubic.from_flexes",
        verb: "cubic",
        domains: CURVES,
        selected_by: &[],
        doc: "The humpy cubic with two given flexes (at the parameters 1 and -1) and a given summit (at 0)",
        example: "casteljau cubic --from-flexes '(1,4) (1,-4) (0,0)'",
        parameters: &[required("from_flexes", Kind::Points, "from-flexes", "both flexes, then the summit")],
        growth: Growth::Direct,
        run: Run::Numeric(cubic::from_flexes),
    },
    Operation {
        name: "implicit.curve",
        verb: "implicit",
        domains: CURVES,
        selected_by: &[],
        doc: "The implicit equation of a plane curve, the gauge of a point, and the parameters of a point",
        example: "casteljau implicit '(t, t^2)' --at '(1, 3)'",
        parameters: &[
            EITHER_CURVE,
            EITHER_POINTS,
            OVER_POINTS,
            optional("at", Kind::Point, "at", "also the gauge of this point: the value of the polynomial, and its sign"),
            optional("contains", Kind::Point, "contains", "whether this point is on the curve, and at which parameters"),
        ],
        growth: Growth::Direct,
        run: Run::Numeric(implicit::implicit),
    },
    Operation {
        name: "gallery",
        verb: "plot",
        domains: CURVES,
        selected_by: &["gallery"],
        doc: "A sheet with all kinds of planar cubics, the ways from one to another, and the tree that tells them apart",
        example: "casteljau plot --gallery -o gallery.svg",
        parameters: &[optional("gallery", Kind::Flag, "gallery", "all kinds of planar cubics instead of one curve")],
        growth: Growth::Direct,
        run: Run::Numeric(picture::gallery),
    },
    Operation {
        name: "quadric.surface",
        verb: "implicit",
        domains: SURFACES,
        selected_by: &[],
        doc: "The quadric that a surface of space lies in, and its affine type",
        example: "casteljau implicit '(u, v, u v)'",
        parameters: &[
            optional("surface", Kind::AnySurface, "", "the equation, such as '(u, v, u v)' or 'z = x y'"),
            EITHER_ROWS,
            OVER_POINTS,
            BIDEGREE,
        ],
        growth: Growth::Direct,
        run: Run::Numeric(implicit::quadric),
    },
];
