//! Shape files: pieces as JSON documents.

use serde_json::value::RawValue;

use super::json::{Fault, Fields, count, depth, list, number, numbers, plain, points, rows};
use crate::affine::{Frame, Interval, Rectangle, Triangle};
use crate::exact::Rational;
use crate::piece::Piece;
use crate::rectangular::RectangularPatch;
use crate::segment::Segment;
use crate::triangular::TriangularPatch;

/// What a shape file holds.
#[derive(Clone, Debug, PartialEq)]
pub struct ShapeFile {
    /// The name, if it has one.
    pub name: Option<String>,
    /// The piece.
    pub piece: Piece,
    /// The weights of its control points, in their order, if it is rational.
    pub weights: Option<Vec<Rational>>,
    /// Whether the file gives a frame; without one it is `0..1`, the unit
    /// square or the standard triangle.
    pub has_frame: bool,
}

/// Reads a shape file:
///
/// ```json
/// {"kind": "curve", "degree": 1, "frame": ["-1", "3"], "points": [["0", "0"], ["1/3", "0.25"]]}
/// {"kind": "triangle", "degree": 1, "frame": [["1", "0"], ["0", "1"], ["0", "0"]], "points": [[["0"], ["1"]], [["2"]]]}
/// {"kind": "rectangle", "degree": [1, 1], "frame": [["0", "1"], ["0", "1"]], "points": [[["0"], ["1"]], [["2"], ["3"]]]}
/// ```
///
/// Optional `weights`, arranged like the points, make the piece rational.
///
/// # Errors
/// What is wrong with it: not JSON, an unknown member, a number or a count
/// that does not fit, a kind that is not supported.
pub fn read_shape(text: &str) -> Result<ShapeFile, Fault> {
    let raw: &RawValue = serde_json::from_str(text).map_err(|error| Fault::new("bad-json", format!("not JSON: {error}")))?;
    let fields = Fields::of(raw, "a shape")?;
    let kind: String = plain(fields.require("kind", "a shape")?, "the name of a kind")?;
    let what = format!("a shape of kind {kind}");
    if !matches!(kind.as_str(), "curve" | "triangle" | "rectangle") {
        return Err(Fault::new(
            "unsupported",
            format!("shapes of kind `{}` are not supported here; curve, triangle and rectangle are", super::json::excerpt(&kind)),
        ));
    }
    fields.only(&["kind", "degree", "frame", "points", "weights", "name"], &what)?;
    let (control, degree) = (fields.require("points", &what)?, fields.require("degree", &what)?);
    let given = fields.get("frame").map(frame).transpose()?;
    let has_frame = given.is_some();
    let wrong_frame = || Fault::new("wrong-shape", format!("the frame is not that of {what}"));
    let piece = match kind.as_str() {
        "triangle" => {
            let frame = match given {
                None => Triangle::standard(),
                Some(Frame::Triangle(frame)) => frame,
                Some(_) => return Err(wrong_frame()),
            };
            let (rows, degree) = (rows(control)?, count(degree, "the degree")?);
            let patch = TriangularPatch::from_rows(rows, frame)?;
            if patch.degree() != degree {
                return Err(Fault::new(
                    "wrong-count",
                    format!("degree {degree} needs {} rows of points, found {}", degree + 1, patch.degree() + 1),
                ));
            }
            Piece::Triangle(patch)
        }
        "rectangle" => {
            let frame = match given {
                None => Rectangle::unit(),
                Some(Frame::Rectangle(frame)) => frame,
                Some(_) => return Err(wrong_frame()),
            };
            let patch = RectangularPatch::from_rows(rows(control)?, frame)?;
            let (p, q): (usize, usize) = plain(degree, "a bidegree [p, q]")?;
            if patch.degree() != (p, q) {
                let found = patch.degree();
                return Err(Fault::new(
                    "wrong-count",
                    format!("bidegree [{p}, {q}] needs {} rows of {} points, found {} of {}", p + 1, q + 1, found.0 + 1, found.1 + 1),
                ));
            }
            Piece::Rectangle(patch)
        }
        _ => {
            let frame = match given {
                None => Interval::unit(),
                Some(Frame::Interval(frame)) => frame,
                Some(_) => return Err(wrong_frame()),
            };
            let (control, degree) = (points(control)?, count(degree, "the degree")?);
            if control.len() != degree + 1 {
                return Err(Fault::new("wrong-count", format!("degree {degree} needs {} points, found {}", degree + 1, control.len())));
            }
            Piece::Curve(Segment::from_points(control, frame)?)
        }
    };
    let weights = fields.get("weights").map(weights).transpose()?;
    if let Some(weights) = weights.as_ref().filter(|weights| weights.len() != piece.points().len()) {
        return Err(Fault::new("wrong-count", format!("{} points need as many weights, found {}", piece.points().len(), weights.len())));
    }
    let name = fields.get("name").map(|raw| plain(raw, "a name")).transpose()?;
    Ok(ShapeFile { name, piece, weights, has_frame })
}

/// Weights arranged like control points: a list, or rows.
///
/// # Errors
/// As for [`numbers`].
pub(crate) fn weights(raw: &RawValue) -> Result<Vec<Rational>, Fault> {
    if depth(raw) < 2 {
        return numbers(raw, "weights");
    }
    let rows: Vec<Vec<Rational>> =
        list(raw, "rows of weights")?.into_iter().map(|row| numbers(row, "a row of weights")).collect::<Result<_, _>>()?;
    Ok(rows.into_iter().flatten().collect())
}

/// A frame: `[r, s]`, three points of the plane, or two intervals.
///
/// # Errors
/// `wrong-count` for other numbers of numbers, `degenerate-frame` if the
/// vertices are dependent.
pub(crate) fn frame(raw: &RawValue) -> Result<Frame<Rational>, Fault> {
    let interval = |raw: &RawValue| match <[_; 2]>::try_from(numbers(raw, "a frame")?) {
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
            let vertex = |raw: &RawValue| match <[Rational; 2]>::try_from(numbers(raw, "a vertex")?) {
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
pub(crate) fn place(raw: &RawValue) -> Result<Vec<Rational>, Fault> {
    if depth(raw) == 0 { Ok(vec![number(raw)?]) } else { numbers(raw, "a parameter") }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn code(text: &str) -> &'static str {
        read_shape(text).map_or_else(|fault| fault.code, |_| "fine")
    }

    #[test]
    fn numbers_are_exact_decimals() {
        let shape = read_shape(r#"{"kind":"curve","degree":1,"points":[[0.1],["1/3"]],"name":"a"}"#);
        let shape = shape.expect("a shape");
        assert_eq!(shape.piece.net().point(0)[0].to_string(), "1/10");
        assert_eq!((shape.name.as_deref(), shape.has_frame), (Some("a"), false));
    }

    #[test]
    fn faults() {
        for (text, expected) in [
            ("", "bad-json"),
            ("[]", "wrong-shape"),
            (r#"{"kind":"blob"}"#, "unsupported"),
            (r#"{"kind":"curve","degree":1,"points":[[0],[1]],"colour":1}"#, "unknown-field"),
            (r#"{"kind":"curve","degree":1,"degree":1,"points":[[0],[1]]}"#, "wrong-shape"),
            (r#"{"kind":"curve","degree":2,"points":[[0],[1]]}"#, "wrong-count"),
            (r#"{"kind":"curve","degree":1,"points":[[0],[1,2]]}"#, "wrong-count"),
            (r#"{"kind":"curve","degree":1,"points":[[0],["1/0"]]}"#, "bad-number"),
            (r#"{"kind":"curve","degree":1,"frame":[2,2],"points":[[0],[1]]}"#, "degenerate-frame"),
            (r#"{"kind":"curve","degree":1,"points":[[0],[1e999999999]]}"#, "too-large"),
            (r#"{"kind":"curve","degree":-1,"points":[[0]]}"#, "wrong-shape"),
            (r#"{"kind":"curve","points":[[0]]}"#, "missing-field"),
        ] {
            assert_eq!(code(text), expected, "{text}");
        }
    }
}
