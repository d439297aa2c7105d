//! casteljau
mod exact;
pub use exact::{MAX_DIGITS, ParseNumberError, Rational};
