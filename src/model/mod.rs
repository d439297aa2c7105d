//! Shapes in files and requests: JSON whose numbers are read digit by digit.

mod json;
mod shape;

pub use json::{Fault, Fields, number, numbers, points};
pub(crate) use json::{count, excerpt, plain};
pub(crate) use shape::frame;
pub use shape::{ShapeFile, read_shape};
