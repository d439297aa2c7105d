//! How large an input may be. Every limit is checked before the work it limits.

use super::{Span, SyntaxError};
use crate::exact::MAX_DIGITS;

/// The most bytes of one expression, list or frame: one mebibyte.
pub const MAX_INPUT_BYTES: usize = 1 << 20;

/// How deep brackets, fractions and roots may be nested.
pub const MAX_NESTING: usize = 128;

/// The largest total degree of a polynomial, symbolic parameters included, and
/// the largest number of polar arguments.
pub const MAX_DEGREE: u32 = 4096;

/// The most terms of one polynomial.
pub const MAX_TERMS: usize = 1_000_000;

/// How much arithmetic one input may ask for, in units of roughly one
/// multiplication of machine words.
pub const MAX_WORK: u64 = 4_000_000;

/// Bits of the longest number: the smallest count that holds any number of
/// [`MAX_DIGITS`] digits. (log2 10 is a little less than 3322/1000.)
pub(crate) const MAX_BITS: u64 = MAX_DIGITS as u64 * 3322 / 1000;

/// What is left of [`MAX_WORK`].
#[derive(Debug)]
pub(crate) struct Budget {
    left: u64,
}

impl Budget {
    pub(crate) fn new() -> Self {
        Self { left: MAX_WORK }
    }

    /// How much was taken.
    #[cfg(feature = "cli")]
    pub(crate) fn spent(&self) -> u64 {
        MAX_WORK - self.left
    }

    /// Takes the cost of work that is about to be done.
    pub(crate) fn spend(&mut self, cost: u64, span: Span) -> Result<(), SyntaxError> {
        match self.left.checked_sub(cost) {
            Some(left) => {
                self.left = left;
                Ok(())
            }
            None => Err(SyntaxError::new(
                span,
                format!("found an expression that takes too much work to multiply out, expected at most {MAX_WORK} steps"),
            )),
        }
    }
}

/// The cost of one operation on numbers of so many bits together. Beyond a
/// machine word numbers are allocated, and a sum of fractions takes a greatest
/// common divisor, which is quadratic.
pub(crate) fn number_cost(bits: u64, integers: bool) -> u64 {
    let words = bits / 64;
    match (words, integers) {
        (0, _) => 1,
        (_, true) => 4 + words,
        (_, false) => 4 + words.saturating_mul(words) / 4,
    }
}
