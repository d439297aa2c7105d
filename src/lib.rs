//! casteljau
mod affine;

mod bernstein;
mod blossom;

mod curve;
pub mod draw;
mod error;
mod exact;
mod flatness;
mod hull;
mod kernel;

pub mod ops;

pub mod batch;
pub mod cli;
pub mod model;
pub mod report;
mod scheme;
mod segment;
mod symbolic;
pub mod syntax;

pub use affine::*;
pub use bernstein::*;
pub use blossom::{PolarDefect, PolarForm, check_polar_form, polar_symbol, sigma, symmetric_terms};
pub use curve::*;
pub use error::*;
pub use exact::{MAX_DIGITS, ParseNumberError, Rational, RealRoots, Root, RootPlace};
pub use flatness::*;
pub use hull::*;
pub use kernel::coefficient::Coefficient;
pub use scheme::*;
pub use segment::*;
pub use symbolic::*;
