//! Points of the parameter line and of space: frames, homogeneous parameters,
//! affine maps, and the doors to `nalgebra`.

mod interval;
mod map;
mod parameter;

pub use interval::Interval;
pub use map::AffineMap;
pub use parameter::Parameter;
