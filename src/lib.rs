//! casteljau
#![allow(dead_code)]
mod affine;
mod blossom;
mod curve;
mod error;
mod exact;
mod kernel;
mod scheme;
mod segment;
mod symbolic;
pub use affine::*;
pub use blossom::*;
pub use curve::*;
pub use error::*;
pub use exact::{MAX_DIGITS, ParseNumberError, Rational};
pub use kernel::coefficient::Coefficient;
pub use scheme::*;
pub use segment::*;
pub use symbolic::*;
