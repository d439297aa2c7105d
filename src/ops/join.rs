//! Operations on pairs of shapes with a given joint, and on the splines that consist of joined pieces.

use crate::continuity::{
    Continuity, RationalContinuity, continuity_of_curves, continuity_of_rational_curves, continuity_of_rational_surfaces,
    continuity_of_surfaces,
};
use crate::error::Error;
use crate::exact::Rational;
use crate::geometric::geometric_join;
use crate::piece::{Equation, Piece};
use crate::segment::Segment;
use crate::side::Side;
use crate::spline::{KnotJoin, Spline};
use crate::surface::Surface;
use crate::tangent::tangent_plane_join;
use crate::value::{Answer, Arguments, Finding, SplineFinding, Value};

pub(super) fn order(order: Continuity) -> Value {
    match order {
        Continuity::Broken => Value::Integer(-1),
        Continuity::C(order) => Value::Count(order),
        Continuity::Same => Value::Word("inf"),
    }
}

fn piece<'a>(arguments: &'a Arguments, name: &str) -> Result<&'a Piece, Error> {
    match arguments.get(name) {
        Some(Value::Piece(piece)) => Ok(piece),
        _ => Err(Error::WrongShape(format!("`{name}` is missing"))),
    }
}

fn surface(arguments: &Arguments, name: &str) -> Result<Surface, Error> {
    match piece(arguments, name)?.equation()? {
        Equation::Surface(surface) => Ok(surface),
        Equation::Curve(_) => Err(Error::WrongShape(format!("`{name}` is a curve, expected a patch"))),
    }
}

fn curve(arguments: &Arguments, name: &str) -> Result<crate::curve::Curve, Error> {
    match piece(arguments, name)?.equation()? {
        Equation::Curve(curve) => Ok(curve),
        Equation::Surface(_) => Err(Error::WrongShape(format!("`{name}` is a patch, expected a curve"))),
    }
}

/// The two shared points of the parameter plane.
fn edge(arguments: &Arguments) -> Result<[[Rational; 2]; 2], Error> {
    let Some(Value::Points(points)) = arguments.get("edge") else {
        return Err(Error::WrongShape("`edge` is missing".into()));
    };
    match points.as_slice() {
        [from, to] if from.len() == 2 => Ok([from, to].map(|point| [point[0].clone(), point[1].clone()])),
        other => Err(Error::WrongCount { what: "points of the parameter plane", expected: 2, found: other.len() }),
    }
}

pub(super) fn curves(arguments: &Arguments) -> Result<Answer, Error> {
    let found = continuity_of_curves(&curve(arguments, "A")?, &curve(arguments, "B")?, arguments.number("at")?)?;
    Ok(Answer::new(vec![("max_k", order(found))]))
}

pub(super) fn surfaces(arguments: &Arguments) -> Result<Answer, Error> {
    let found = continuity_of_surfaces(&surface(arguments, "A")?, &surface(arguments, "B")?, &edge(arguments)?)?;
    Ok(Answer::new(vec![("max_k", order(found))]))
}

pub(super) fn rectangles(arguments: &Arguments) -> Result<Answer, Error> {
    let (at, zero, one) = (arguments.number("at")?.clone(), Rational::from(0), Rational::from(1));
    let joint = match *arguments.word("axis")? {
        "u" => [[at.clone(), zero], [at, one]],
        _ => [[zero, at.clone()], [one, at]],
    };
    let found = continuity_of_surfaces(&surface(arguments, "A")?, &surface(arguments, "B")?, &joint)?;
    Ok(Answer::new(vec![("max_k", order(found))]))
}

pub(super) fn rational_curves(arguments: &Arguments) -> Result<Answer, Error> {
    let found = continuity_of_rational_curves(&curve(arguments, "A")?, &curve(arguments, "B")?, arguments.number("at")?)?;
    let RationalContinuity { cartesian, homogeneous, scaled, scale } = found;
    Ok(Answer::new(vec![
        ("max_k", order(cartesian)),
        ("homogeneous_max_k", order(homogeneous)),
        ("scaled_homogeneous_max_k", order(scaled)),
        ("scale", Value::Number(scale)),
    ]))
}

pub(super) fn rational_triangles(arguments: &Arguments) -> Result<Answer, Error> {
    let found = continuity_of_rational_surfaces(&surface(arguments, "A")?, &surface(arguments, "B")?, &edge(arguments)?)?;
    Ok(Answer::new(vec![("max_k", order(found.cartesian)), ("homogeneous_max_k", order(found.homogeneous))]))
}

pub(super) fn geometric_curves(arguments: &Arguments) -> Result<Answer, Error> {
    let curve = |name: &str| match arguments.get(name) {
        Some(Value::Curve(curve)) => Ok(curve),
        _ => Err(Error::WrongShape(format!("`{name}` is missing"))),
    };
    let join = geometric_join(curve("F")?, curve("G")?, arguments.number("tF")?, arguments.number("tG")?)?;
    let mut fields = vec![
        ("max_g", join.order.map_or(Value::Integer(-1), Value::Count)),
        ("regular", Value::Truth(join.regular)),
        ("betas", Value::Numbers(join.betas)),
    ];
    if join.reversed {
        fields.push(("reversed_tangent", Value::Truth(true)));
    }
    Ok(Answer::new(fields))
}

pub(super) fn geometric_triangles(arguments: &Arguments) -> Result<Answer, Error> {
    let patch = |name: &str| match piece(arguments, name)? {
        patch @ Piece::Triangle(_) => Ok(patch),
        _ => Err(Error::WrongShape(format!("`{name}` is no triangular patch"))),
    };
    let join = tangent_plane_join((patch("A")?, Side::St), (patch("B")?, Side::St), false)?;
    let test = |result: Option<bool>| result.map_or(Value::Nothing, Value::Truth);
    Ok(Answer::new(vec![
        ("g0", Value::Truth(join.same_edge)),
        ("coplanar_identity", test(join.coplanar)),
        ("regular", test(join.regular())),
        ("opposite_sides", test(join.opposite_sides)),
        ("g1", Value::Truth(join.is_g1())),
    ]))
}

pub(super) fn spline(arguments: &Arguments) -> Result<Answer, Error> {
    let Some(Value::Points(points)) = arguments.get("points") else {
        return Err(Error::WrongShape("`points` is missing".into()));
    };
    let spline = Spline::new(*arguments.count("degree")?, arguments.numbers("knots")?.clone(), points.clone())?;
    let (pieces, joins) = (spline.pieces()?, spline.joins()?);
    let inserted = arguments.number("insert").ok().map(|knot| spline.insert(knot)).transpose()?;
    let piece = |segment: &Segment| -> Result<Value, Error> {
        let interval = Value::Frame(segment.frame().clone().into());
        Ok(Value::Record(vec![("interval", interval), ("curve", Value::Curve(segment.curve()?))]))
    };
    let knot = |join: &KnotJoin| Value::Record(vec![("knot", Value::Number(join.knot.clone())), ("max_k", order(join.order))]);
    let mut fields = vec![
        ("pieces", Value::List(pieces.iter().map(piece).collect::<Result<_, _>>()?)),
        ("joins", Value::List(joins.iter().map(knot).collect())),
    ];
    if let Some(inserted) = &inserted {
        let (knots, points) = (inserted.knots().to_vec(), inserted.points().to_vec());
        fields.push(("inserted", Value::Record(vec![("knots", Value::Numbers(knots)), ("points", Value::Points(points))])));
    }
    let finding = SplineFinding { spline, pieces, joins, inserted };
    Ok(Answer::new(fields).with_finding(Finding::Spline(Box::new(finding))))
}
