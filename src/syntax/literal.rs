//! The values of numbers as they are written.

use num_traits::Signed;

use super::lexer::{VULGAR_FRACTIONS, shorten};
use super::limits::{MAX_BITS, number_cost};
use super::parser::Parser;
use super::{Span, SyntaxError};
use crate::exact::{MAX_DIGITS, ParseNumberError, Rational};

impl Parser<'_> {
    /// The value of an unsigned number as it is written.
    pub(crate) fn number_value(&mut self, text: &str, span: Span) -> Result<Rational, SyntaxError> {
        if let Some(&(_, numer, denom)) = VULGAR_FRACTIONS.iter().find(|entry| text.starts_with(entry.0)) {
            return Ok(Rational::new(numer, denom));
        }
        // A short text can ask for a long number: 1e9999.
        let exponent: u64 =
            text.split_once('e').map_or(0, |(_, exponent)| exponent.trim_start_matches(['+', '-']).parse().unwrap_or(u64::MAX));
        let digits = (text.len() as u64).saturating_add(exponent);
        if digits > 18 && digits <= 2 * MAX_DIGITS as u64 {
            self.budget.spend(number_cost(digits.saturating_mul(4), false), span)?;
        }
        match text.parse::<Rational>() {
            Ok(value) if value.bits() <= MAX_BITS => Ok(value),
            Ok(_) | Err(ParseNumberError::TooLong) => {
                Err(SyntaxError::new(span, format!("found a number with more than {MAX_DIGITS} digits, expected at most {MAX_DIGITS}")))
            }
            Err(ParseNumberError::Malformed | ParseNumberError::ZeroDenominator) => {
                Err(SyntaxError::new(span, format!("found `{}`, expected a number such as 5, 0.25 or 1e-3", shorten(text))))
            }
        }
    }
}

/// The value of an exponent: a non-negative whole number that fits `u32`.
pub(crate) fn exponent_value(value: &Rational) -> Option<u32> {
    if !value.is_integer() || value.is_negative() {
        return None;
    }
    u32::try_from(value.numer()).ok()
}
