//! Operations on what encloses and approximates a curve.

use crate::error::Error;
use crate::hull::{ConvexHull, bounding_box};
use crate::value::{Answer, Arguments, Value};

pub(super) fn hull(arguments: &Arguments) -> Result<Answer, Error> {
    let piece = arguments.piece()?;
    let (least, largest) = bounding_box(piece.points())?;
    let corners = Value::Record(vec![("least", Value::Point(least)), ("largest", Value::Point(largest))]);
    let planar = piece.dimension() == 2 || arguments.get("point").is_some();
    let hull = if planar { Some(ConvexHull::of(piece.points())?) } else { None };
    let vertices = match &hull {
        Some(hull) => Value::Points(hull.vertices().iter().map(|vertex| vertex.to_vec()).collect()),
        None => Value::Nothing,
    };
    let mut answer = Answer::new(vec![("box", corners), ("hull", vertices)]);
    if let (Some(hull), Ok(point)) = (hull, arguments.point("point")) {
        let [x, y] = point.as_slice() else {
            return Err(Error::WrongCount { what: "coordinates", expected: 2, found: point.len() });
        };
        let inside = hull.contains(&[x.clone(), y.clone()]);
        answer.fields.push(("contains", Value::Truth(inside)));
        answer = answer.that_holds(inside);
    }
    Ok(answer)
}

pub(super) fn flatten(arguments: &Arguments) -> Result<Answer, Error> {
    let segment = arguments.segment()?;
    let flattening = segment.flatten(arguments.number("flatness")?)?;
    Ok(Answer::new(vec![
        ("depth", Value::Count(flattening.depth)),
        ("bound", Value::Numbers(flattening.bound)),
        ("polyline", Value::Points(flattening.polyline)),
    ]))
}
