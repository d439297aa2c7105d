//! Points of the parameter line and plane and of space: frames, homogeneous
//! parameters, affine maps.

mod frame;
mod interval;
mod map;
mod parameter;
mod rectangle;
mod triangle;
mod weights;

pub use frame::Frame;
pub use interval::Interval;
pub use map::AffineMap;
pub use parameter::{Parameter, PlaneParameter};
pub use rectangle::Rectangle;
pub use triangle::{Place, Triangle};
pub(crate) use weights::Weights;
