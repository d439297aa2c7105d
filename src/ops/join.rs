//! Operations on joins, and on the splines that consist of joined pieces.

use crate::affine::{Frame, Interval, Rectangle, Triangle};
use crate::continuity::{
    Continuity, RationalContinuity, continuity_of_curves, continuity_of_rational_curves, continuity_of_rational_surfaces,
    continuity_of_surfaces,
};
use crate::error::Error;
use crate::exact::Rational;
use crate::geometric::geometric_join;
use crate::joint::{Extension, JoinCondition, Joint, extend, join_conditions};
use crate::piece::{Equation, Piece};
use crate::side::Side;
use crate::spline::Spline;
use crate::surface::Surface;
use crate::tangent::tangent_plane_join;
use crate::value::{Answer, Arguments, Value};

fn order(order: Continuity) -> Value {
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
    let mut pieces = Vec::new();
    for segment in spline.pieces()? {
        let interval = Value::Frame(segment.frame().clone().into());
        pieces.push(Value::Record(vec![("interval", interval), ("curve", Value::Curve(segment.curve()?))]));
    }
    let joins =
        spline.joins()?.into_iter().map(|join| Value::Record(vec![("knot", Value::Number(join.knot)), ("max_k", order(join.order))]));
    let mut fields = vec![("pieces", Value::List(pieces)), ("joins", Value::List(joins.collect()))];
    if let Ok(knot) = arguments.number("insert") {
        let inserted = spline.insert(knot)?;
        fields.push((
            "inserted",
            Value::Record(vec![
                ("knots", Value::Numbers(inserted.knots().to_vec())),
                ("points", Value::Points(inserted.points().to_vec())),
            ]),
        ));
    }
    Ok(Answer::new(fields))
}

/// Two pieces at their joint: the order, and the conditions one by one.
pub(super) fn join(arguments: &Arguments) -> Result<Answer, Error> {
    let (first, second) = (arguments.piece()?, arguments.other_piece()?);
    let weighted = arguments.is_weighted();
    if weighted != (arguments.get("other_weights").is_some()) {
        return Err(Error::WrongShape(
            "one of the pieces has weights and the other has none: give both some, 1 where there is none".into(),
        ));
    }
    let joint = match arguments.number("at") {
        Ok(at) => Joint::Parameter(at.clone()),
        Err(_) => Joint::between(&first, &second).ok_or_else(|| {
            Error::WrongShape(format!(
                "the frames {} and {} do not share one end or side: give the pieces their frames (--over, --other-over), or curves --at T",
                first.frame(),
                second.frame()
            ))
        })?,
    };
    let mut fields = vec![match &joint {
        Joint::Parameter(at) => ("at", Value::Number(at.clone())),
        Joint::Edge(ends) => ("edge", Value::Points(ends.iter().map(|end| end.to_vec()).collect())),
    }];
    let (a, b) = (first.equation()?, second.equation()?);
    let found = match (&a, &b, &joint, weighted) {
        (Equation::Curve(a), Equation::Curve(b), Joint::Parameter(at), false) => continuity_of_curves(a, b, at)?,
        (Equation::Surface(a), Equation::Surface(b), Joint::Edge(edge), false) => continuity_of_surfaces(a, b, edge)?,
        (Equation::Curve(a), Equation::Curve(b), Joint::Parameter(at), true) => {
            let join = continuity_of_rational_curves(a, b, at)?;
            fields.extend([("homogeneous_max_k", order(join.homogeneous)), ("scaled_homogeneous_max_k", order(join.scaled))]);
            join.cartesian
        }
        (Equation::Surface(a), Equation::Surface(b), Joint::Edge(edge), true) => {
            let join = continuity_of_rational_surfaces(a, b, edge)?;
            fields.push(("homogeneous_max_k", order(join.homogeneous)));
            join.cartesian
        }
        _ => return Err(Error::WrongShape("a curve and a patch do not join".into())),
    };
    fields.push(("max_k", order(found)));
    // One order more than holds, to show what fails; of maps that are the same, as many as they have.
    let shown = match (arguments.count("order"), found) {
        (Ok(&order), _) => order,
        (Err(_), Continuity::Broken) => 0,
        (Err(_), Continuity::C(order)) => order + 1,
        (Err(_), Continuity::Same) => usize::MAX,
    };
    let conditions = join_conditions(&first, &second, &joint, shown)?;
    let record = |condition: JoinCondition| {
        let mut fields = vec![
            ("order", Value::Count(condition.order)),
            ("label", Value::Document(condition.label.clone())),
            ("first", Value::Point(condition.first.clone())),
            ("second", Value::Point(condition.second.clone())),
        ];
        if !condition.holds() {
            fields.push(("defect", Value::Point(condition.defect())));
        }
        Value::Record(fields)
    };
    fields.push(("conditions", Value::List(conditions.into_iter().map(record).collect())));
    let answer = Answer::new(fields);
    Ok(match arguments.word("require") {
        Ok(word) => {
            let needed = word.trim_start_matches('C').parse().unwrap_or(0);
            answer.that_holds(found >= Continuity::C(needed))
        }
        Err(_) => answer,
    })
}

/// What continuity forces on a neighbour across an end or side of a piece.
pub(super) fn extension(arguments: &Arguments) -> Result<Answer, Error> {
    let piece = arguments.piece()?;
    let (to, order) = (arguments.numbers("extend")?, *arguments.count("order")?);
    let edge = arguments.word("edge").copied().ok();
    let unknown = |name: &str, known: &str| Error::WrongShape(format!("there is no edge `{name}` here; there are {known}"));
    let wrong_count = |expected| Error::WrongCount { what: "parameters of the neighbour's vertex", expected, found: to.len() };
    let (frame, joint): (Frame<Rational>, Joint) = match piece.frame() {
        Frame::Interval(frame) => {
            let [end] = to.as_slice() else { return Err(wrong_count(1)) };
            // The neighbour begins where this piece ends, on the side of its other end.
            let at = arguments.number("at").unwrap_or(frame.s()).clone();
            (Interval::new(at.clone(), end.clone())?.into(), Joint::Parameter(at))
        }
        Frame::Triangle(frame) => {
            let [u, v] = to.as_slice() else { return Err(wrong_count(2)) };
            let [r, s, t] = frame.vertices();
            let (from, to) = match edge.unwrap_or("st") {
                "rs" => (r, s),
                "st" => (s, t),
                "tr" => (t, r),
                other => return Err(unknown(other, "rs, st and tr")),
            };
            let neighbour = Triangle::new([u.clone(), v.clone()], from.clone(), to.clone())?;
            (neighbour.into(), Joint::Edge([from.clone(), to.clone()]))
        }
        Frame::Rectangle(frame) => {
            let [end] = to.as_slice() else { return Err(wrong_count(1)) };
            let (u, v) = (frame.u(), frame.v());
            let beside = |at: &Rational| Interval::new(at.clone(), end.clone());
            match edge.unwrap_or("u1") {
                name @ ("u0" | "u1") => {
                    let at = if name == "u0" { u.r() } else { u.s() };
                    let side = [v.r(), v.s()].map(|end| [at.clone(), end.clone()]);
                    (Rectangle::new(beside(at)?, v.clone()).into(), Joint::Edge(side))
                }
                name @ ("v0" | "v1") => {
                    let at = if name == "v0" { v.r() } else { v.s() };
                    let side = [u.r(), u.s()].map(|end| [end.clone(), at.clone()]);
                    (Rectangle::new(u.clone(), beside(at)?).into(), Joint::Edge(side))
                }
                other => return Err(unknown(other, "u0, u1, v0 and v1")),
            }
        }
    };
    let Extension { continuation, forced } = extend(&piece, &frame, &joint, order)?;
    let entries = continuation.labels().into_iter().zip(continuation.points()).zip(forced).map(|((label, point), forced)| {
        let point = if forced { Value::Point(point.to_vec()) } else { Value::Nothing };
        Value::Record(vec![("label", Value::Document(label)), ("forced", point)])
    });
    let entries = entries.collect();
    Ok(Answer::new(vec![("frame", Value::Frame(frame)), ("neighbour", Value::List(entries))]))
}
