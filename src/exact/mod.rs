//! Exact numbers: rationals with an inline small form, decimals read digit by
//! digit, greatest common divisors, and the integer widths the kernel runs on.

mod arithmetic;
pub(crate) mod decimal;
pub(crate) mod fixed;
pub(crate) mod gcd;
pub(crate) mod lowest;
pub(crate) mod magnitude;
mod rational;
mod surd;
pub(crate) mod univariate;
pub(crate) mod width;

pub use decimal::{MAX_DIGITS, ParseNumberError};
pub use rational::Rational;
pub use surd::Surd;
