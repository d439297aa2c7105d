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

pub mod report;
pub mod batch;
pub mod cli;
pub mod model;
mod scheme;
mod segment;
mod symbolic;
pub mod syntax;

pub use affine::*;
pub use bernstein::*;
pub use blossom::{check_polar_form,polar_symbol,sigma,symmetric_terms,PolarForm,PolarDefect};
pub use curve::*;
pub use error::*;
pub use flatness::*;
pub use hull::*;
pub use scheme::*;
pub use segment::*;
pub use symbolic::*;
pub use exact::{MAX_DIGITS, ParseNumberError, Rational, RealRoots, Root, RootPlace};
pub use kernel::coefficient::Coefficient;
