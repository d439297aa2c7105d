//! The table of operations.

use super::{curve, geometry, limits, numbers, picture};
use crate::error::Error;
use crate::exact::Rational;
use crate::symbolic::Polynomial;
use crate::value::{Answer, Arguments};

/// What an argument is, for the adaptors that read it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A curve by its equation.
    Curve,
    /// Control points.
    Points,
    /// A frame of the parameter line.
    Frame,
    /// The frame of control points; an equation does not need it.
    FrameOfPoints,
    /// A number.
    Number,
    /// A list of numbers.
    Numbers,
    /// A point.
    Point,
    /// A small whole number.
    Count,
    /// Arguments of a polar form, numbers only.
    Arguments,
    /// Arguments of a polar form, vectors included.
    HomogeneousArguments,
    /// A polar form that somebody claims.
    Claim,
    /// An affine map of space.
    Map,
    /// The line, plane or hyperplane where an affine function is zero, as a map to the line.
    Plane,
    /// Yes or no.
    Flag,
}

/// One argument of an operation.
#[derive(Clone, Copy, Debug)]
pub struct Parameter {
    /// The name in `batch` requests.
    pub name: &'static str,
    /// What it is.
    pub kind: Kind,
    /// Whether the operation needs it.
    pub required: bool,
    /// The flag on the command line; empty for the shapes, which are positional.
    pub flag: &'static str,
    /// One line of help.
    pub help: &'static str,
}

/// How an operation is carried out.
#[derive(Clone, Copy)]
pub enum Run {
    /// On numbers, and the same on symbolic parameters.
    Any(fn(&Arguments<Rational>) -> Result<Answer<Rational>, Error>, fn(&Arguments<Polynomial>) -> Result<Answer<Polynomial>, Error>),
    /// On numbers only.
    Numeric(fn(&Arguments<Rational>) -> Result<Answer<Rational>, Error>),
}

/// How the size of an answer depends on the size of its arguments.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Growth {
    /// About as many numbers come out as go in, each by itself.
    Direct,
    /// About as many numbers come out as go in, each from all.
    Linear,
    /// Every step of de Casteljau's algorithm.
    Scheme,
    /// A polynomial for every control point.
    Basis,
    /// Twice as much at every depth.
    Doubling,
}

/// One operation.
#[derive(Clone, Copy)]
pub struct Operation {
    /// The name in `batch` requests.
    pub name: &'static str,
    /// The command that carries it out; empty where only `batch` names it.
    pub verb: &'static str,
    /// The arguments each of which makes the command mean this operation instead of its first one.
    pub selected_by: &'static [&'static str],
    /// What it does, in one line.
    pub doc: &'static str,
    /// A command line that shows it.
    pub example: &'static str,
    /// What it takes.
    pub parameters: &'static [Parameter],
    /// How much it gives.
    pub growth: Growth,
    /// How it is carried out.
    pub run: Run,
}

impl Operation {
    /// Carries out the operation on numbers.
    ///
    /// # Errors
    /// What the operation says, and [`Error::TooLarge`] if it would take too long.
    pub fn on_numbers(&self, arguments: &Arguments<Rational>) -> Result<Answer<Rational>, Error> {
        limits::check(self, arguments)?;
        match self.run {
            Run::Any(run, _) | Run::Numeric(run) => run(arguments),
        }
    }

    /// Carries out the operation on symbolic parameters; `None` if it needs numbers.
    #[must_use]
    pub fn on_symbols(&self, arguments: &Arguments<Polynomial>) -> Option<Result<Answer<Polynomial>, Error>> {
        match self.run {
            Run::Any(_, run) => Some(limits::check(self, arguments).and_then(|()| run(arguments))),
            Run::Numeric(_) => None,
        }
    }

    /// The operation with a name.
    #[must_use]
    pub fn named(name: &str) -> Option<&'static Self> {
        OPERATIONS.iter().find(|operation| operation.name == name)
    }

    /// The operations of a command, its own first.
    pub fn of_verb(verb: &str) -> impl Iterator<Item = &'static Self> {
        OPERATIONS.iter().filter(move |operation| operation.verb == verb)
    }

    /// The argument with a name.
    #[must_use]
    pub fn parameter(&self, name: &str) -> Option<&'static Parameter> {
        self.parameters.iter().find(|parameter| parameter.name == name)
    }

    /// Whether one of the shapes `curve` and `points` will do.
    #[must_use]
    pub fn takes_either_shape(&self) -> bool {
        self.parameter("curve").is_some() && self.parameter("points").is_some()
    }
}

const fn required(name: &'static str, kind: Kind, flag: &'static str, help: &'static str) -> Parameter {
    Parameter { name, kind, required: true, flag, help }
}

const fn optional(name: &'static str, kind: Kind, flag: &'static str, help: &'static str) -> Parameter {
    Parameter { name, kind, required: false, flag, help }
}

const CURVE: Parameter = required("curve", Kind::Curve, "", "the equation, such as '(t, t^2)'");
const POINTS: Parameter = required("points", Kind::Points, "", "the control points, such as '(0,0) (1,2) (2,0)'");
const EITHER_CURVE: Parameter = optional("curve", Kind::Curve, "", "the equation, such as '(t, t^2)'");
const EITHER_POINTS: Parameter = optional("points", Kind::Points, "", "or the control points, such as '(0,0) (1,2) (2,0)'");
const OVER: Parameter = optional("frame", Kind::Frame, "over", "the frame r..s (0..1 unless said)");
const OVER_POINTS: Parameter = optional("frame", Kind::FrameOfPoints, "over", "the frame r..s of control points (0..1 unless said)");
const DEGREE: Parameter = optional("degree", Kind::Count, "degree", "the polar degree, if it is to be higher than the degree");
const AT: Parameter = required("t", Kind::Number, "at", "the parameter");
const OTHER_CURVE: Parameter = optional("other_curve", Kind::Curve, "", "the second equation");
const OTHER_POINTS: Parameter = optional("other_points", Kind::Points, "", "or the second control points");
const OTHER_OVER: Parameter = optional("other_frame", Kind::Frame, "other-over", "the frame of the second curve, if it is another");

/// Every operation, in the order of the help.
pub const OPERATIONS: &[Operation] = &[
    Operation {
        name: "curve.polar",
        verb: "polar",
        selected_by: &[],
        doc: "The polar form (blossom) of a curve",
        example: "casteljau polar '(3/4 t^2 - 3/2 t - 9/4, 3/4 t^3 - 3/2 t^2 - 9/4 t)'",
        parameters: &[CURVE, DEGREE, optional("frame", Kind::Frame, "over", "also the control points over this frame r..s")],
        growth: Growth::Direct,
        run: Run::Any(curve::polar, curve::polar),
    },
    Operation {
        name: "curve.blossom_homogeneous",
        verb: "polar",
        selected_by: &["args"],
        doc: "A polar value at homogeneous arguments",
        example: "casteljau polar 't^3' --at '1 2 [0; 1]'",
        parameters: &[
            CURVE,
            DEGREE,
            required("args", Kind::HomogeneousArguments, "at", "the value at these arguments, such as '-1 -1 3', '2^2 1' or '1 2 [0; 1]'"),
        ],
        growth: Growth::Linear,
        run: Run::Any(curve::blossom_homogeneous, curve::blossom_homogeneous),
    },
    Operation {
        name: "polar.check",
        verb: "polar",
        selected_by: &["claim"],
        doc: "Whether a claimed polar form is symmetric, affine in every argument, and right on the diagonal",
        example: "casteljau polar 't^2 + t' --check 't1 t2 + (t1 + t2)/2'",
        parameters: &[CURVE, DEGREE, required("claim", Kind::Claim, "check", "a claimed polar form in t1, t2, …")],
        growth: Growth::Direct,
        run: Run::Any(curve::check, curve::check),
    },
    Operation {
        name: "curve.blossom",
        verb: "",
        selected_by: &[],
        doc: "A polar value",
        example: "",
        parameters: &[CURVE, required("args", Kind::Arguments, "at", "the arguments")],
        growth: Growth::Linear,
        run: Run::Any(curve::blossom, curve::blossom),
    },
    Operation {
        name: "curve.points",
        verb: "points",
        selected_by: &[],
        doc: "The control points of a curve over a frame",
        example: "casteljau points '(3/4 t^2 - 3/2 t - 9/4, 3/4 t^3 - 3/2 t^2 - 9/4 t)' --over -1..3",
        parameters: &[CURVE, required("frame", Kind::Frame, "over", "the frame r..s; r > s is allowed"), DEGREE],
        growth: Growth::Linear,
        run: Run::Any(curve::points, curve::points),
    },
    Operation {
        name: "curve.equation",
        verb: "equation",
        selected_by: &[],
        doc: "The equation of the curve with these control points",
        example: "casteljau equation '(0,0) (-4,4) (-4,-12) (0,0)' --over -1..3",
        parameters: &[POINTS, OVER],
        growth: Growth::Linear,
        run: Run::Any(curve::equation, curve::equation),
    },
    Operation {
        name: "curve.eval",
        verb: "eval",
        selected_by: &[],
        doc: "The point of a curve at a parameter",
        example: "casteljau eval '(0,0) (-4,4) (-4,-12) (0,0)' --over -1..3 --at 1",
        parameters: &[EITHER_CURVE, EITHER_POINTS, OVER_POINTS, AT],
        growth: Growth::Linear,
        run: Run::Any(curve::eval, curve::eval),
    },
    Operation {
        name: "curve.casteljau",
        verb: "eval",
        selected_by: &["steps"],
        doc: "De Casteljau's algorithm step by step",
        example: "casteljau eval '(0,0) (-4,4) (-4,-12) (0,0)' --over -1..3 --at 1 --steps",
        parameters: &[
            EITHER_CURVE,
            EITHER_POINTS,
            OVER,
            AT,
            optional("steps", Kind::Flag, "steps", "all intermediate points with their polar labels"),
        ],
        growth: Growth::Scheme,
        run: Run::Any(curve::casteljau, curve::casteljau),
    },
    Operation {
        name: "curve.split",
        verb: "split",
        selected_by: &[],
        doc: "The control points of the two parts of a segment",
        example: "casteljau split '(0,0) (1,2) (3,2) (4,0)' --at 1/3",
        parameters: &[EITHER_CURVE, EITHER_POINTS, OVER, AT],
        growth: Growth::Linear,
        run: Run::Any(curve::split, curve::split),
    },
    Operation {
        name: "curve.subdivide",
        verb: "split",
        selected_by: &["depth", "midpoints"],
        doc: "The pieces, or the polyline, of repeated splitting in the middle",
        example: "casteljau split '(0,0) (1,2) (3,2) (4,0)' --depth 2",
        parameters: &[
            EITHER_CURVE,
            EITHER_POINTS,
            OVER,
            optional("midpoints", Kind::Flag, "midpoints", "split in the middle, once unless a depth is given"),
            optional("depth", Kind::Count, "depth", "split in the middle this many times"),
            optional("polyline", Kind::Flag, "polyline", "the ends of the pieces instead of the pieces"),
        ],
        growth: Growth::Doubling,
        run: Run::Any(curve::subdivide, curve::subdivide),
    },
    Operation {
        name: "curve.flatten",
        verb: "split",
        selected_by: &["flatness"],
        doc: "The polyline that stays within a bound of the curve, in every coordinate",
        example: "casteljau split '(0,0) (1,2) (3,2) (4,0)' --flatness 1/10",
        parameters: &[EITHER_CURVE, EITHER_POINTS, OVER, required("flatness", Kind::Number, "flatness", "the bound, exact")],
        growth: Growth::Linear,
        run: Run::Numeric(geometry::flatten),
    },
    Operation {
        name: "curve.reframe",
        verb: "reframe",
        selected_by: &[],
        doc: "The control points of the same curve over another frame",
        example: "casteljau reframe '(0,0) (-4,4) (-4,-12) (0,0)' --over -1..3 --to 0..1",
        parameters: &[POINTS, OVER, required("new_frame", Kind::Frame, "to", "the new frame r..s")],
        growth: Growth::Linear,
        run: Run::Any(curve::reframe, curve::reframe),
    },
    Operation {
        name: "curve.elevate",
        verb: "elevate",
        selected_by: &[],
        doc: "The same curve with more control points",
        example: "casteljau elevate '(0,0) (1,2) (2,0)' --by 1",
        parameters: &[POINTS, OVER, optional("by", Kind::Count, "by", "how many more (1 unless said)")],
        growth: Growth::Linear,
        run: Run::Any(curve::elevate, curve::elevate),
    },
    Operation {
        name: "curve.reduce",
        verb: "reduce",
        selected_by: &[],
        doc: "The true degree, and the same curve with as few control points as it can have",
        example: "casteljau reduce '(0,1) (1,3) (2,5) (3,7)'",
        parameters: &[POINTS, OVER],
        growth: Growth::Linear,
        run: Run::Any(curve::reduce, curve::reduce),
    },
    Operation {
        name: "curve.derivative",
        verb: "derivative",
        selected_by: &[],
        doc: "A derivative of any order, as a curve or at a parameter",
        example: "casteljau derivative '(t, t^3)' --order 2 --at 1/2",
        parameters: &[
            EITHER_CURVE,
            EITHER_POINTS,
            OVER_POINTS,
            optional("order", Kind::Count, "order", "the order (1 unless said)"),
            optional("t", Kind::Number, "at", "the parameter; without it the derivative is given as a curve"),
        ],
        growth: Growth::Linear,
        run: Run::Any(curve::derivative, curve::derivative),
    },
    Operation {
        name: "curve.product",
        verb: "product",
        selected_by: &[],
        doc: "The product of two curves in Bernstein form",
        example: "casteljau product '[1, 2]' '(0,0) (1,2) (2,0)'",
        parameters: &[EITHER_CURVE, EITHER_POINTS, OVER, OTHER_CURVE, OTHER_POINTS],
        growth: Growth::Linear,
        run: Run::Any(curve::product, curve::product),
    },
    Operation {
        name: "curve.transform",
        verb: "transform",
        selected_by: &[],
        doc: "The image under an affine map of the plane or of space",
        example: "casteljau transform '(0,0) (1,2) (2,0)' --map '(x + 2y, y - 1)'",
        parameters: &[
            EITHER_CURVE,
            EITHER_POINTS,
            OVER_POINTS,
            required("map", Kind::Map, "map", "the image of (x, y) or (x, y, z) or (x1, x2, …)"),
        ],
        growth: Growth::Direct,
        run: Run::Any(curve::transform, curve::transform),
    },
    Operation {
        name: "curve.equal",
        verb: "equal",
        selected_by: &[],
        doc: "Whether two curves or pieces are the same polynomial map",
        example: "casteljau equal '(0,0) (1/2,0) (1,1)' '(t, t^2)'",
        parameters: &[EITHER_CURVE, EITHER_POINTS, OVER_POINTS, OTHER_CURVE, OTHER_POINTS, OTHER_OVER],
        growth: Growth::Linear,
        run: Run::Any(curve::equal, curve::equal),
    },
    Operation {
        name: "curve.describe",
        verb: "describe",
        selected_by: &[],
        doc: "Dimensions and degrees of a curve",
        example: "casteljau describe '(t, t^2, t^3)'",
        parameters: &[EITHER_CURVE, EITHER_POINTS, OVER_POINTS, DEGREE],
        growth: Growth::Direct,
        run: Run::Any(curve::describe, curve::describe),
    },
    Operation {
        name: "contains",
        verb: "contains",
        selected_by: &[],
        doc: "Whether a parameter lies inside a frame",
        example: "casteljau contains --over -1..3 --at 1/2",
        parameters: &[required("frame", Kind::Frame, "over", "the frame r..s"), AT],
        growth: Growth::Direct,
        run: Run::Numeric(numbers::contains),
    },
    Operation {
        name: "bernstein",
        verb: "bernstein",
        selected_by: &[],
        doc: "The Bernstein polynomials of a degree over a frame, their maxima, and their values",
        example: "casteljau bernstein --degree 3 --over 0..1",
        parameters: &[
            required("degree", Kind::Count, "degree", "the degree"),
            optional("index", Kind::Count, "index", "only this one, counted from 0"),
            optional("frame", Kind::Frame, "over", "the frame r..s (0..1 unless said)"),
            optional("t", Kind::Number, "at", "also the values at this parameter"),
        ],
        growth: Growth::Basis,
        run: Run::Numeric(numbers::bernstein),
    },
    Operation {
        name: "sigma",
        verb: "sigma",
        selected_by: &[],
        doc: "The elementary symmetric functions of a list of numbers",
        example: "casteljau sigma '1 2 3'",
        parameters: &[required("values", Kind::Numbers, "", "the numbers, such as '1 2 3'")],
        growth: Growth::Linear,
        run: Run::Any(numbers::sigma, numbers::sigma),
    },
    Operation {
        name: "hull",
        verb: "hull",
        selected_by: &[],
        doc: "The bounding box of the control points, and in the plane their convex hull",
        example: "casteljau hull '(0,0) (0,1) (1,1) (1,0)' --contains '(1/2, 3/4)'",
        parameters: &[
            EITHER_CURVE,
            EITHER_POINTS,
            OVER,
            optional("point", Kind::Point, "contains", "whether the hull contains this point of the plane"),
        ],
        growth: Growth::Direct,
        run: Run::Numeric(geometry::hull),
    },
    Operation {
        name: "roots.bernstein",
        verb: "roots",
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
    Operation {
        name: "plot",
        verb: "plot",
        selected_by: &[],
        doc: "A picture of the curve with its control polygon and labels (SVG)",
        example: "casteljau plot '(0,0) (-4,4) (-4,-12) (0,0)' --over -1..3 --at 1 -o cubic.svg",
        parameters: &[
            EITHER_CURVE,
            EITHER_POINTS,
            OVER,
            optional("t", Kind::Number, "at", "also the steps of de Casteljau's algorithm at this parameter"),
            optional("depth", Kind::Count, "depth", "also the control polygons of this many subdivisions"),
            optional("view", Kind::Numbers, "view", "azimuth and elevation in whole degrees, for a curve in space: 30,25 unless said"),
        ],
        growth: Growth::Linear,
        run: Run::Numeric(picture::plot),
    },
];
