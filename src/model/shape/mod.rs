//! Shape files: pieces as JSON documents.

mod frame;
mod model;

use serde_json::value::RawValue;

use super::decimals::Decimals;
use super::json::{Fault, Fields, count, depth, excerpt, list, numbers, plain, points, points_up_to, rows};
use crate::affine::{Frame, Interval, Rectangle, Triangle};
use crate::exact::Rational;
use crate::piece::Piece;
use crate::rectangular::RectangularPatch;
use crate::segment::Segment;
use crate::triangular::TriangularPatch;
use crate::weights::homogeneous_points;

pub(crate) use frame::{frame, place};
pub(super) use model::read;

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

/// Reads a shape file that holds one piece:
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
    let shape = Shape::of(serde_json::from_str(text).map_err(|error| Fault::new("bad-json", format!("not JSON: {error}")))?)?;
    match shape.kind {
        Kind::Spline | Kind::Model => Err(Fault::new(
            "unsupported",
            format!("shapes of kind `{}` are not supported here; curve, triangle and rectangle are", shape.kind.name()),
        )),
        kind => shape.piece(kind, &mut Decimals::default()),
    }
}

/// The kinds of shapes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Curve,
    Triangle,
    Rectangle,
    Spline,
    Model,
}

impl Kind {
    const ALL: [Self; 5] = [Self::Curve, Self::Triangle, Self::Rectangle, Self::Spline, Self::Model];

    fn name(self) -> &'static str {
        match self {
            Self::Curve => "curve",
            Self::Triangle => "triangle",
            Self::Rectangle => "rectangle",
            Self::Spline => "spline",
            Self::Model => "model",
        }
    }
}

/// An object that says what kind of shape it is.
struct Shape<'a> {
    kind: Kind,
    fields: Fields<'a>,
    what: String,
}

/// A spline of a shape file; its points have the weight as their last coordinate if it is rational.
struct SplineFile {
    name: Option<String>,
    degree: usize,
    knots: Vec<Rational>,
    points: Vec<Vec<Rational>>,
    rational: bool,
}

impl<'a> Shape<'a> {
    fn of(raw: &'a RawValue) -> Result<Self, Fault> {
        let fields = Fields::of(raw, "a shape")?;
        let name: String = plain(fields.require("kind", "a shape")?, "the name of a kind")?;
        match Kind::ALL.into_iter().find(|kind| kind.name() == name) {
            Some(kind) => Ok(Self { kind, fields, what: format!("a shape of kind {name}") }),
            None => {
                let known = Kind::ALL.map(Kind::name).join(", ");
                Err(Fault::new("unsupported", format!("shapes of kind `{}` are not supported; {known} are", excerpt(&name))))
            }
        }
    }

    fn require(&self, name: &str) -> Result<&'a RawValue, Fault> {
        self.fields.require(name, &self.what)
    }

    fn name(&self) -> Result<Option<String>, Fault> {
        self.fields.get("name").map(|raw| plain(raw, "a name")).transpose()
    }

    /// The pieces of a model.
    fn pieces(&self) -> Result<Vec<&'a RawValue>, Fault> {
        self.fields.only(&["kind", "pieces", "name"], &self.what)?;
        self.name()?;
        list(self.require("pieces")?, "the pieces")
    }

    fn spline(&self, decimals: &mut Decimals) -> Result<SplineFile, Fault> {
        self.fields.only(&["kind", "degree", "knots", "points", "weights", "name"], &self.what)?;
        let control = points_up_to(self.require("points")?, MAX_SPLINE_POINTS, decimals)?;
        let finest = decimals.finest();
        let knots = numbers(self.require("knots")?, "the knots", decimals)?;
        let weights = self.weights(control.len(), decimals)?;
        decimals.restore(finest);
        let degree = count(self.require("degree")?, "the degree")?;
        let (points, rational) = match weights {
            Some(weights) => (homogeneous_points(&control, &weights)?, true),
            None => (control, false),
        };
        Ok(SplineFile { name: self.name()?, degree, knots, points, rational })
    }

    fn weights(&self, count: usize, decimals: &mut Decimals) -> Result<Option<Vec<Rational>>, Fault> {
        let weights = self.fields.get("weights").map(|raw| weights(raw, decimals)).transpose()?;
        match weights {
            Some(weights) if weights.len() != count => {
                Err(Fault::new("wrong-count", format!("{count} points need as many weights, found {}", weights.len())))
            }
            weights => Ok(weights),
        }
    }

    fn piece(&self, kind: Kind, decimals: &mut Decimals) -> Result<ShapeFile, Fault> {
        self.fields.only(&["kind", "degree", "frame", "points", "weights", "name"], &self.what)?;
        let (control, degree) = (self.require("points")?, self.require("degree")?);
        let finest = decimals.finest();
        let given = self.fields.get("frame").map(|raw| frame(raw, decimals)).transpose()?;
        decimals.restore(finest);
        let has_frame = given.is_some();
        let wrong_frame = || Fault::new("wrong-shape", format!("the frame is not that of {}", self.what));
        let piece = match kind {
            Kind::Triangle => {
                let frame = match given {
                    None => Triangle::standard(),
                    Some(Frame::Triangle(frame)) => frame,
                    Some(_) => return Err(wrong_frame()),
                };
                Piece::Triangle(triangle(rows(control, decimals)?, count(degree, "the degree")?, frame)?)
            }
            Kind::Rectangle => {
                let frame = match given {
                    None => Rectangle::unit(),
                    Some(Frame::Rectangle(frame)) => frame,
                    Some(_) => return Err(wrong_frame()),
                };
                Piece::Rectangle(rectangle(rows(control, decimals)?, plain(degree, "a bidegree [p, q]")?, frame)?)
            }
            _ => {
                let frame = match given {
                    None => Interval::unit(),
                    Some(Frame::Interval(frame)) => frame,
                    Some(_) => return Err(wrong_frame()),
                };
                Piece::Curve(curve(points(control, decimals)?, count(degree, "the degree")?, frame)?)
            }
        };
        let finest = decimals.finest();
        let weights = self.weights(piece.points().len(), decimals)?;
        decimals.restore(finest);
        Ok(ShapeFile { name: self.name()?, piece, weights, has_frame })
    }
}

/// The most points of one spline; its work has a limit of its own.
const MAX_SPLINE_POINTS: usize = 1 << 20;

fn triangle(rows: Vec<Vec<Vec<Rational>>>, degree: usize, frame: Triangle) -> Result<TriangularPatch, Fault> {
    let patch = TriangularPatch::from_rows(rows, frame)?;
    if patch.degree() != degree {
        return Err(Fault::new(
            "wrong-count",
            format!("degree {degree} needs {} rows of points, found {}", degree + 1, patch.degree() + 1),
        ));
    }
    Ok(patch)
}

fn rectangle(rows: Vec<Vec<Vec<Rational>>>, (p, q): (usize, usize), frame: Rectangle) -> Result<RectangularPatch, Fault> {
    let patch = RectangularPatch::from_rows(rows, frame)?;
    let found = patch.degree();
    if found != (p, q) {
        let (rows, columns) = (p.saturating_add(1), q.saturating_add(1));
        return Err(Fault::new(
            "wrong-count",
            format!("bidegree [{p}, {q}] needs {rows} rows of {columns} points, found {} of {}", found.0 + 1, found.1 + 1),
        ));
    }
    Ok(patch)
}

fn curve(points: Vec<Vec<Rational>>, degree: usize, frame: Interval) -> Result<Segment, Fault> {
    if points.len() != degree + 1 {
        return Err(Fault::new("wrong-count", format!("degree {degree} needs {} points, found {}", degree + 1, points.len())));
    }
    Ok(Segment::from_points(points, frame)?)
}
/// Weights arranged like control points: a list, or rows.
///
/// # Errors
/// As for [`numbers`].
pub(crate) fn weights(raw: &RawValue, decimals: &mut Decimals) -> Result<Vec<Rational>, Fault> {
    if depth(raw) < 2 {
        return numbers(raw, "weights", decimals);
    }
    let rows: Vec<Vec<Rational>> =
        list(raw, "rows of weights")?.into_iter().map(|row| numbers(row, "a row of weights", decimals)).collect::<Result<_, _>>()?;
    Ok(rows.into_iter().flatten().collect())
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
