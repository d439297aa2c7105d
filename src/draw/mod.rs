//! Pictures.

mod curve;

pub use curve::CurvePicture;
