//! Pictures as answers.

use crate::draw::{CurvePicture, PatchPicture};
use crate::error::Error;
use crate::exact::Rational;
use crate::mesh::Mesh;
use crate::piece::Piece;
use crate::value::{Answer, Arguments, Value};

pub(super) fn plot(arguments: &Arguments) -> Result<Answer, Error> {
    let (piece, weighted) = (arguments.piece()?, arguments.is_weighted());
    let (at, depth) = (arguments.numbers("t").ok().map(Vec::as_slice), arguments.count("depth").ok().copied());
    let view = arguments.numbers("view").ok().map(|angles| view(angles)).transpose()?;
    let wrong_count = |found: usize| Error::WrongCount { what: "parameters", expected: if found == 1 { 2 } else { 1 }, found };
    let svg = match piece {
        Piece::Curve(segment) => {
            let mut picture = if weighted { CurvePicture::rational(&segment)? } else { CurvePicture::new(segment) };
            match at {
                Some([t]) => picture = picture.with_scheme(t.clone()),
                Some(other) => return Err(wrong_count(other.len())),
                None => {}
            }
            picture = depth.into_iter().fold(picture, CurvePicture::with_subdivision);
            if arguments.flag("features") {
                picture = picture.with_features();
            }
            view.into_iter().fold(picture, |picture, [azimuth, elevation]| picture.with_view(azimuth, elevation)).svg()?
        }
        patch => {
            let mut picture = PatchPicture::new(patch, weighted);
            match at {
                Some([u, v]) => picture = picture.with_point([u.clone(), v.clone()]),
                Some(other) => return Err(wrong_count(other.len())),
                None => {}
            }
            picture = depth.into_iter().fold(picture, PatchPicture::with_subdivision);
            view.into_iter().fold(picture, |picture, [azimuth, elevation]| picture.with_view(azimuth, elevation)).svg()?
        }
    };
    Ok(Answer::new(vec![("svg", Value::Document(svg))]))
}

/// All kinds of planar cubics.
pub(super) fn gallery(_: &Arguments) -> Result<Answer, Error> {
    Ok(Answer::new(vec![("svg", Value::Document(crate::draw::gallery()?))]))
}

pub(super) fn mesh(arguments: &Arguments) -> Result<Answer, Error> {
    let depth = arguments.count("depth").copied().unwrap_or(4);
    Ok(Answer::new(vec![("mesh", Value::Mesh(Mesh::of(&arguments.piece()?, arguments.is_weighted(), depth)?))]))
}

fn view(angles: &[Rational]) -> Result<[i32; 2], Error> {
    match angles {
        [azimuth, elevation] => Ok([degrees(azimuth)?, degrees(elevation)?]),
        other => Err(Error::WrongCount { what: "angles", expected: 2, found: other.len() }),
    }
}

/// A whole number of degrees, at most a full turn either way.
fn degrees(angle: &Rational) -> Result<i32, Error> {
    let whole = i32::try_from(angle.numer()).ok().filter(|degrees| angle.is_integer() && degrees.abs() <= 360);
    whole.ok_or_else(|| Error::WrongShape(format!("an angle of the view is a whole number of degrees from -360 to 360, found {angle}")))
}
