//! Pictures as answers.

use super::arguments::Arguments;
use super::value::{Answer, Value};
use crate::draw::CurvePicture;
use crate::error::Error;

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
