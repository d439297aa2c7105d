//! Shape files as they are written.

use serde_json::{Value as Json, json};

use super::json::Fault;
use crate::exact::Rational;
use crate::piece::Piece;
use crate::weights::projected;

/// The text of a shape file; see [`read_shape`](super::read_shape). With `rational` the last
/// coordinate of the control points is the weight.
///
/// # Errors
/// `unsupported` where a control point is at infinity: a shape file has no place for one.
pub fn shape_text(piece: &Piece, rational: bool) -> Result<String, Fault> {
    let infinite = || Fault::new("unsupported", "a control point has the weight 0, and shape files have no place for points at infinity");
    let point = |homogeneous: &[Rational]| -> Result<Json, Fault> {
        let point = if rational { projected(homogeneous).ok_or_else(infinite)? } else { homogeneous.to_vec() };
        Ok(point.iter().map(Rational::to_string).collect())
    };
    let weight = |homogeneous: &[Rational]| Json::from(homogeneous.last().map_or_else(String::new, Rational::to_string));
    let pair = |pair: &[&Rational]| pair.iter().map(|number| number.to_string()).collect::<Json>();
    let frame = piece.frame();
    let numbers = frame.numbers();
    let (kind, degree, frame) = match piece {
        Piece::Curve(segment) => ("curve", json!(segment.degree()), pair(&numbers)),
        Piece::Triangle(patch) => ("triangle", json!(patch.degree()), numbers.chunks(2).map(pair).collect()),
        Piece::Rectangle(patch) => ("rectangle", json!([patch.degree().0, patch.degree().1]), numbers.chunks(2).map(pair).collect()),
    };
    let rows = piece.rows();
    let mut points = rows.iter().map(|row| row.iter().map(|found| point(found)).collect()).collect::<Result<Vec<Json>, Fault>>()?;
    let mut weights: Vec<Json> = rows.iter().map(|row| row.iter().map(|found| weight(found)).collect()).collect();
    let whole = |rows: &mut Vec<Json>| if kind == "curve" { rows.swap_remove(0) } else { Json::from(std::mem::take(rows)) };
    let mut shape = json!({"kind": kind, "degree": degree, "frame": frame, "points": whole(&mut points)});
    if rational {
        shape["weights"] = whole(&mut weights);
    }
    Ok(format!("{shape}\n"))
}

#[cfg(test)]
mod tests {
    use super::super::read_shape;
    use super::*;

    #[test]
    fn what_is_written_is_read_again() {
        for text in [
            r#"{"kind":"curve","degree":1,"frame":["1","7/3"],"points":[["1/10","2"],["1/3","-4"]],"weights":["1","2/3"]}"#,
            r#"{"kind":"triangle","degree":1,"frame":[["0","0"],["1","0"],["1","1"]],"points":[[["0"],["1"]],[["2"]]]}"#,
            r#"{"kind":"rectangle","degree":[1,0],"frame":[["0","1"],["2","3"]],"points":[[["0"]],[["1"]]],"weights":[["1"],["5"]]}"#,
        ] {
            let shape = read_shape(text).expect("a shape");
            let points: Vec<Vec<Rational>> = shape.piece.points().map(<[Rational]>::to_vec).collect();
            let written = match &shape.weights {
                None => shape_text(&shape.piece, false),
                Some(weights) => {
                    let lifted = crate::weights::homogeneous_points(&points, weights).expect("as many");
                    shape_text(&shape.piece.with_points(lifted).expect("as many"), true)
                }
            };
            assert_eq!(read_shape(&written.expect("finite")), Ok(shape));
        }
    }
}
