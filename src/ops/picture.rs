//! Pictures as answers.

use crate::draw::CurvePicture;
use crate::error::Error;
use crate::exact::Rational;
use crate::value::{Answer, Arguments, Value};

pub(super) fn plot(arguments: &Arguments) -> Result<Answer, Error> {
    let mut picture = CurvePicture::new(arguments.segment()?);
    if let Ok(t) = arguments.numbers("t") {
        let [t] = t.as_slice() else {
            return Err(Error::WrongCount { what: "parameters", expected: 1, found: t.len() });
        };
        picture = picture.with_scheme(t.clone());
    }
    if let Ok(&depth) = arguments.count("depth") {
        picture = picture.with_subdivision(depth);
    }
    if let Ok(angles) = arguments.numbers("view") {
        let [azimuth, elevation] = angles.as_slice() else {
            return Err(Error::WrongCount { what: "angles", expected: 2, found: angles.len() });
        };
        picture = picture.with_view(degrees(azimuth)?, degrees(elevation)?);
    }
    Ok(Answer::new(vec![("svg", Value::Document(picture.svg()?))]))
}

/// A whole number of degrees, at most a full turn either way.
fn degrees(angle: &Rational) -> Result<i32, Error> {
    let whole = i32::try_from(angle.numer()).ok().filter(|degrees| angle.is_integer() && degrees.abs() <= 360);
    whole.ok_or_else(|| Error::WrongShape(format!("an angle of the view is a whole number of degrees from -360 to 360, found {angle}")))
}
