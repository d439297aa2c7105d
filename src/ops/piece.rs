//! Operations on pieces of every kind, for numbers and for symbolic parameters alike.

use crate::affine::AffineMap;
use crate::error::Error;
use crate::kernel::coefficient::Coefficient;
use crate::piece::{Equation, Piece};
use crate::reading::Reading;
use crate::value::{Answer, Arguments, Value};

type Outcome<C> = Result<Answer<C>, Error>;

/// The control points of a piece as an answer.
pub(super) fn net<C: Coefficient>(arguments: &Arguments<C>, piece: Piece<C>) -> Outcome<C> {
    Ok(Answer::new(vec![("points", Value::Net(piece))]).weighted(arguments.is_weighted()))
}

pub(super) fn points<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    net(arguments, arguments.piece()?)
}

pub(super) fn equation<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let equation = arguments.piece()?.equation()?;
    let name = match equation {
        Equation::Curve(_) => "curve",
        Equation::Surface(_) => "surface",
    };
    Ok(Answer::new(vec![(name, equation.into())]).weighted(arguments.is_weighted()))
}

pub(super) fn reframe<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let piece = match arguments.piece()? {
        Piece::Curve(segment) => Piece::Curve(segment.reframe(arguments.frame("new_frame")?)?),
        Piece::Triangle(patch) => Piece::Triangle(patch.reframe(arguments.triangle("new_frame")?)?),
        Piece::Rectangle(patch) => Piece::Rectangle(patch.reframe(arguments.rectangle("new_frame")?)?),
    };
    net(arguments, piece)
}

pub(super) fn elevate<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let by = arguments.count("by").copied().unwrap_or(1);
    let piece = match arguments.piece()? {
        Piece::Curve(segment) => Piece::Curve(segment.elevate(by)?),
        Piece::Triangle(patch) => Piece::Triangle(patch.elevate(by)?),
        Piece::Rectangle(patch) => {
            let (in_u, in_v) = if arguments.get("by").is_some() { arguments.pair("by")? } else { (1, 1) };
            Piece::Rectangle(patch.elevate(in_u, in_v)?)
        }
    };
    net(arguments, piece)
}

/// The pieces of repeated subdivision in the middle.
pub(super) fn pieces<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let depth = arguments.count("depth").copied().unwrap_or(1);
    let pieces = match arguments.piece()? {
        Piece::Curve(segment) => segment.subdivide(depth)?.into_iter().map(Piece::Curve).collect(),
        Piece::Triangle(patch) => patch.subdivide(depth)?.into_iter().map(Piece::Triangle).collect(),
        Piece::Rectangle(patch) => patch.subdivide(depth)?.into_iter().map(Piece::Rectangle).collect(),
    };
    Ok(Answer::new(vec![("pieces", Value::Pieces(pieces))]).weighted(arguments.is_weighted()))
}

pub(super) fn product<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    net(arguments, arguments.piece()?.product(&arguments.other_piece()?)?)
}

pub(super) fn transform<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    // Points with weights are mapped where their weights are the last coordinate.
    let lifted = arguments.is_weighted().then(|| arguments.map("map").map(AffineMap::homogeneous)).transpose()?;
    let map = lifted.as_ref().map_or_else(|| arguments.map("map"), Ok)?;
    Ok(Answer::new(vec![match (arguments.get("points"), arguments.get("surface")) {
        (Some(_), _) => ("points", Value::Net(arguments.piece()?.transform(map)?)),
        (None, Some(_)) => ("surface", Value::Surface(arguments.surface()?.transform(map)?)),
        (None, None) => ("curve", Value::Curve(arguments.curve()?.transform(map)?)),
    }])
    .weighted(arguments.is_weighted()))
}

pub(super) fn equal<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let same = arguments.piece()?.equation()?.same_map(&arguments.other_piece()?.equation()?);
    Ok(Answer::new(vec![("equal", Value::Truth(same))]).that_holds(same))
}

pub(super) fn describe<C: Coefficient>(arguments: &Arguments<C>) -> Outcome<C> {
    let piece = arguments.piece()?;
    let dimension = piece.dimension();
    let (parameters, reading) = match &piece {
        Piece::Curve(segment) => (1, Reading::Curve(segment.degree())),
        Piece::Triangle(patch) => (2, Reading::Total(patch.degree())),
        Piece::Rectangle(patch) => (2, Reading::Bidegree(patch.degree().0, patch.degree().1)),
    };
    let mut fields = vec![
        ("parameter_dimension", Value::Count(parameters)),
        ("object_dimension", Value::Count(dimension)),
        ("gauge_dimension", Value::Count(dimension.saturating_sub(parameters))),
    ];
    let degenerate = match piece.equation()? {
        Equation::Curve(curve) => {
            let true_degree = curve.true_degree();
            fields.extend([("polar_degree", Value::Count(curve.degree())), ("true_degree", Value::Count(true_degree))]);
            true_degree < curve.degree()
        }
        Equation::Surface(surface) => {
            let (total, (p, q)) = (surface.true_total_degree(), surface.true_bidegree());
            let degenerate = match reading {
                Reading::Bidegree(polar_p, polar_q) => {
                    fields.push(("bidegree", Value::Counts(vec![polar_p, polar_q])));
                    p < polar_p || q < polar_q
                }
                Reading::Total(degree) | Reading::Curve(degree) => {
                    fields.push(("polar_degree", Value::Count(degree)));
                    total < degree
                }
            };
            fields.extend([("true_total_degree", Value::Count(total)), ("true_bidegree", Value::Counts(vec![p, q]))]);
            degenerate
        }
    };
    fields.push(("degenerate", Value::Truth(degenerate)));
    if let Reading::Curve(degree) = reading {
        let names = ["constant", "affine", "quadratic", "cubic", "quartic", "quintic"];
        fields.push(("name", Value::Word(names.get(degree).unwrap_or(&"n-ic"))));
    }
    fields.extend([("control_points", Value::Count(reading.points())), ("degrees_of_freedom", Value::Count(reading.points() * dimension))]);
    Ok(Answer::new(fields))
}
