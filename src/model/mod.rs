//! Shapes in files and requests: JSON whose numbers are read digit by digit.

mod json;
mod shape;

pub use json::{Fault, Fields, number, numbers, points, rows};
pub(crate) use json::{count, depth, excerpt, list, plain};
pub use shape::{ShapeFile, read_shape};
pub(crate) use shape::{frame, place, weights};
