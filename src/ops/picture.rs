//! Pictures as answers.

use crate::draw::CurvePicture;
use crate::error::Error;
use crate::value::{Answer, Arguments, Value};

pub(super) fn plot(arguments: &Arguments) -> Result<Answer, Error> {
    let mut picture = CurvePicture::new(arguments.segment()?);
    if let Ok(t) = arguments.number("t") {
        picture = picture.with_scheme(t.clone());
    }
    if let Ok(&depth) = arguments.count("depth") {
        picture = picture.with_subdivision(depth);
    }
    Ok(Answer::new(vec![("svg", Value::Document(picture.svg()?))]))
}
