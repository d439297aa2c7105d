//! Shape files: pieces as JSON documents.

use serde_json::value::RawValue;

use super::json::{Fault, Fields, count, numbers, plain, points};
use crate::affine::Interval;
use crate::segment::Segment;

/// What a shape file holds.
#[derive(Clone, Debug, PartialEq)]
pub struct ShapeFile {
    /// The name, if it has one.
    pub name: Option<String>,
    /// The curve.
    pub segment: Segment,
    /// Whether the file gives a frame; without one it is `0..1`.
    pub has_frame: bool,
}

/// Reads a shape file:
///
/// ```json
/// {"kind": "curve", "degree": 1, "frame": ["-1", "3"], "points": [["0", "0"], ["1/3", "0.25"]]}
/// ```
///
/// # Errors
/// What is wrong with it: not JSON, an unknown member, a number or a count
/// that does not fit, a kind that is not supported.
pub fn read_shape(text: &str) -> Result<ShapeFile, Fault> {
    let raw: &RawValue = serde_json::from_str(text).map_err(|error| Fault::new("bad-json", format!("not JSON: {error}")))?;
    let what = "a shape of kind curve";
    let fields = Fields::of(raw, "a shape")?;
    let kind: String = plain(fields.require("kind", "a shape")?, "the name of a kind")?;
    if kind != "curve" {
        return Err(Fault::new(
            "unsupported",
            format!("shapes of kind `{}` are not supported here; `curve` is", super::json::excerpt(&kind)),
        ));
    }
    fields.only(&["kind", "degree", "frame", "points", "name"], what)?;
    let control = points(fields.require("points", what)?)?;
    let degree = count(fields.require("degree", what)?, "the degree")?;
    if control.len() != degree + 1 {
        return Err(Fault::new("wrong-count", format!("degree {degree} needs {} points, found {}", degree + 1, control.len())));
    }
    let frame = fields.get("frame").map(frame).transpose()?;
    let name = fields.get("name").map(|raw| plain(raw, "a name")).transpose()?;
    let has_frame = frame.is_some();
    Ok(ShapeFile { name, segment: Segment::from_points(control, frame.unwrap_or_else(Interval::unit))?, has_frame })
}

/// The frame `[r, s]` of a curve.
///
/// # Errors
/// `wrong-count` unless there are two numbers, `degenerate-frame` if they are equal.
pub(crate) fn frame(raw: &RawValue) -> Result<Interval, Fault> {
    let ends = numbers(raw, "a frame")?;
    match <[_; 2]>::try_from(ends) {
        Ok([r, s]) => Ok(Interval::new(r, s)?),
        Err(ends) => Err(Fault::new("wrong-count", format!("a frame has 2 numbers [r, s], found {}", ends.len()))),
    }
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
        assert_eq!(shape.segment.point(0)[0].to_string(), "1/10");
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
