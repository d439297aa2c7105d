//! Frames and parameters in JSON.

use serde_json::value::RawValue;

use crate::affine::{Frame, Interval, Rectangle, Triangle};
use crate::exact::Rational;
use crate::model::decimals::Decimals;
use crate::model::json::{Fault, depth, list, number, numbers};

/// A frame: `[r, s]`, three points of the plane, or two intervals.
///
/// # Errors
/// `wrong-count` for other numbers of numbers, `degenerate-frame` if the
/// vertices are dependent.
pub(crate) fn frame(raw: &RawValue, decimals: &mut Decimals) -> Result<Frame<Rational>, Fault> {
    let mut interval = |raw: &RawValue| match <[_; 2]>::try_from(numbers(raw, "a frame", decimals)?) {
        Ok([r, s]) => Ok(Interval::new(r, s)?),
        Err(ends) => Err(Fault::new("wrong-count", format!("a frame has 2 numbers [r, s], found {}", ends.len()))),
    };
    if depth(raw) < 2 {
        return Ok(interval(raw)?.into());
    }
    let parts = list(raw, "a frame")?;
    match parts.as_slice() {
        [u, v] => Ok(Rectangle::new(interval(u)?, interval(v)?).into()),
        [_, _, _] => {
            let mut vertex = |raw: &RawValue| match <[Rational; 2]>::try_from(numbers(raw, "a vertex", decimals)?) {
                Ok(vertex) => Ok(vertex),
                Err(found) => Err(Fault::new("wrong-count", format!("a vertex of a triangle has 2 numbers, found {}", found.len()))),
            };
            Ok(Triangle::new(vertex(parts[0])?, vertex(parts[1])?, vertex(parts[2])?)?.into())
        }
        other => Err(Fault::new("wrong-count", format!("a frame has 3 vertices or 2 intervals, found {}", other.len()))),
    }
}

/// A number or a list of numbers.
///
/// # Errors
/// As for [`numbers`].
pub(crate) fn place(raw: &RawValue, decimals: &mut Decimals) -> Result<Vec<Rational>, Fault> {
    if depth(raw) == 0 { Ok(vec![number(raw, decimals)?]) } else { numbers(raw, "a parameter", decimals) }
}
