//! Numbers as people write them, read digit by digit: `-7/3`, `0.25`, `1e-3`.

use std::fmt;
use std::str::FromStr;

use num_bigint::BigInt;
use num_traits::{One, Pow};

use super::Rational;

/// The most digits a number may be written with, and the largest power of ten
/// its exponent may ask for.
pub const MAX_DIGITS: usize = 10_000;

/// Why a text is not a number.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ParseNumberError {
    /// The text does not have the form of a number.
    Malformed,
    /// The denominator is zero.
    ZeroDenominator,
    /// More digits, or a larger exponent, than [`MAX_DIGITS`].
    TooLong,
}

impl fmt::Display for ParseNumberError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Malformed => f.write_str("expected a number such as 5, -7/3, 0.25 or 1e-3"),
            Self::ZeroDenominator => f.write_str("the denominator is zero"),
            Self::TooLong => write!(f, "a number may have at most {MAX_DIGITS} digits"),
        }
    }
}

impl std::error::Error for ParseNumberError {}

impl FromStr for Rational {
    type Err = ParseNumberError;

    /// Reads an integer, a fraction or a decimal exactly; nothing is rounded.
    ///
    /// ```
    /// use casteljau::Rational;
    /// let quarter: Rational = "0.25".parse()?;
    /// assert_eq!(quarter, Rational::new(1, 4));
    /// assert_eq!("-6/4".parse::<Rational>()?.to_string(), "-3/2");
    /// # Ok::<(), casteljau::ParseNumberError>(())
    /// ```
    fn from_str(text: &str) -> Result<Self, ParseNumberError> {
        match text.split_once('/') {
            None => parse_decimal(text),
            Some((numer, denom)) => {
                let denom = parse_integer(denom)?;
                if denom == BigInt::ZERO {
                    return Err(ParseNumberError::ZeroDenominator);
                }
                Ok(Rational::from_big(parse_integer(numer)?, denom))
            }
        }
    }
}

fn parse_integer(text: &str) -> Result<BigInt, ParseNumberError> {
    let digits = text.strip_prefix(['-', '+']).unwrap_or(text);
    if digits.is_empty() || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
        return Err(ParseNumberError::Malformed);
    }
    if digits.len() > MAX_DIGITS {
        return Err(ParseNumberError::TooLong);
    }
    text.parse().map_err(|_| ParseNumberError::Malformed)
}

/// A decimal: digits, then optionally a dot with digits on at least one side,
/// then optionally an exponent.
fn parse_decimal(text: &str) -> Result<Rational, ParseNumberError> {
    if let Ok(small) = text.parse::<i64>() {
        return Ok(Rational::from(small));
    }
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        None => (text, 0i64),
        Some((mantissa, exponent)) => {
            let digits = exponent.strip_prefix(['-', '+']).unwrap_or(exponent);
            if digits.is_empty() || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
                return Err(ParseNumberError::Malformed);
            }
            (mantissa, exponent.parse().map_err(|_| ParseNumberError::TooLong)?)
        }
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    if mantissa.contains('.') && fraction.is_empty() {
        return Err(ParseNumberError::Malformed);
    }
    if mantissa.len() > MAX_DIGITS + 2 || exponent.unsigned_abs() > MAX_DIGITS as u64 {
        return Err(ParseNumberError::TooLong);
    }
    if !fraction.bytes().all(|byte| byte.is_ascii_digit()) {
        return Err(ParseNumberError::Malformed);
    }
    let whole =
        if whole.trim_start_matches(['-', '+']).is_empty() && !fraction.is_empty() { format!("{whole}0") } else { whole.to_owned() };
    let digits = parse_integer(&format!("{whole}{fraction}"))?;
    let power = exponent - fraction.len() as i64;
    let ten: BigInt = Pow::pow(BigInt::from(10), power.unsigned_abs());
    Ok(if power < 0 { Rational::from_big(digits, ten) } else { Rational::from_big(digits * ten, BigInt::one()) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_values() {
        for (text, numer, denom) in [
            ("5", 5, 1),
            ("-7/3", -7, 3),
            ("6/-4", -3, 2),
            ("0.25", 1, 4),
            (".5", 1, 2),
            ("-.5", -1, 2),
            ("1e-3", 1, 1000),
            ("2.50E2", 250, 1),
            ("+3", 3, 1),
            ("-0", 0, 1),
        ] {
            assert_eq!(text.parse(), Ok(Rational::new(numer, denom)), "{text}");
        }
    }

    #[test]
    fn what_is_not_a_number() {
        for text in ["", "-", "1.", ".", "e5", "1e", "1/", "/2", "0x1", "1 2", "1.2.3", "1/2/3", "½", "--1", "1e+-3", "-.", "1.-5"] {
            assert_eq!(text.parse::<Rational>(), Err(ParseNumberError::Malformed), "{text}");
        }
        assert_eq!("1/0".parse::<Rational>(), Err(ParseNumberError::ZeroDenominator));
        let long = "9".repeat(MAX_DIGITS + 3);
        assert_eq!(long.parse::<Rational>(), Err(ParseNumberError::TooLong));
        assert_eq!("1e999999999999999999999".parse::<Rational>(), Err(ParseNumberError::TooLong));
        assert_eq!("1e-20000".parse::<Rational>(), Err(ParseNumberError::TooLong));
    }
}
