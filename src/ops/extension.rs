//! The continuation of a piece beyond one of its ends or sides.

use crate::affine::{Frame, Interval, Rectangle, Triangle};
use crate::error::Error;
use crate::exact::Rational;
use crate::joint::{Extension, Joint, extend};
use crate::piece::Piece;
use crate::side::Side;
use crate::value::{Answer, Arguments, Finding, Value};

/// What continuity forces on a neighbour across an end or side of a piece.
pub(super) fn extension(arguments: &Arguments) -> Result<Answer, Error> {
    let piece = arguments.piece()?;
    let (to, order) = (arguments.numbers("extend")?, *arguments.count("order")?);
    let unless_said = match piece {
        Piece::Curve(_) => Side::End,
        Piece::Triangle(_) => Side::St,
        Piece::Rectangle(_) => Side::U1,
    };
    let side = arguments.word("edge").map_or(Ok(unless_said), |name| Side::named(&piece, name))?;
    let joint = match arguments.number("at") {
        Ok(at) => Joint::Parameter(at.clone()),
        Err(_) => side.joint(&piece.frame())?,
    };
    // The neighbour begins at the joint and ends at the new vertex.
    let frame: Frame<Rational> = match (piece.frame(), &joint, to.as_slice()) {
        (Frame::Interval(_), Joint::Parameter(at), [end]) => Interval::new(at.clone(), end.clone())?.into(),
        (Frame::Triangle(_), Joint::Edge([from, along]), [u, v]) => {
            Triangle::new([u.clone(), v.clone()], from.clone(), along.clone())?.into()
        }
        (Frame::Rectangle(frame), Joint::Edge([from, _]), [end]) => {
            let beside = |at: &Rational| Interval::new(at.clone(), end.clone());
            match side {
                Side::U0 | Side::U1 => Rectangle::new(beside(&from[0])?, frame.v().clone()).into(),
                _ => Rectangle::new(frame.u().clone(), beside(&from[1])?).into(),
            }
        }
        (Frame::Triangle(_), ..) => {
            return Err(Error::WrongCount { what: "parameters of the neighbour's vertex", expected: 2, found: to.len() });
        }
        _ => return Err(Error::WrongCount { what: "parameters of the neighbour's vertex", expected: 1, found: to.len() }),
    };
    let found = extend(&piece, &frame, &joint, order)?;
    let Extension { continuation, forced } = &found;
    let entries = continuation.labels().into_iter().zip(continuation.points()).zip(forced).map(|((label, point), forced)| {
        let point = if *forced { Value::Point(point.to_vec()) } else { Value::Nothing };
        Value::Record(vec![("label", Value::Document(label)), ("forced", point)])
    });
    let fields = vec![("frame", Value::Frame(frame)), ("neighbour", Value::List(entries.collect()))];
    Ok(Answer::new(fields).with_finding(Finding::Extension(Box::new(found))))
}
