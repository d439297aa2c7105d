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

/// A decimal with at most 18 digits and a moderate exponent, and the number of
/// places behind the dot that it states; none for any other text, also for one
/// that is no number. Files are full of such numbers: no big integers, and a
/// denominator `2^a 5^b` that only those primes can shorten.
pub(crate) fn short_decimal(text: &str) -> Option<(Rational, u32)> {
    let (negative, digits) = match text.as_bytes() {
        [b'-', digits @ ..] => (true, digits),
        [b'+', digits @ ..] => (false, digits),
        digits => (false, digits),
    };
    let (mut mantissa, mut behind, mut has_dot, mut exponent, mut count) = (0u64, 0i32, false, 0i32, 0usize);
    for (place, &byte) in digits.iter().enumerate() {
        match byte {
            b'0'..=b'9' if count < SHORT_DIGITS => {
                mantissa = 10 * mantissa + u64::from(byte - b'0');
                count += 1;
                behind += i32::from(has_dot);
            }
            b'.' if !has_dot => has_dot = true,
            b'e' | b'E' => {
                exponent = short_exponent(&digits[place + 1..])?;
                break;
            }
            _ => return None,
        }
    }
    if count == 0 || (has_dot && behind == 0) {
        return None;
    }
    let power = exponent - behind;
    let shift = power.unsigned_abs();
    let places = power.min(0).unsigned_abs();
    if shift as usize > SHORT_DIGITS {
        return None;
    }
    let signed = |magnitude: u64| i64::try_from(magnitude).ok().map(|value| if negative { -value } else { value });
    if power >= 0 {
        let whole = mantissa.checked_mul(10u64.pow(shift)).and_then(signed)?;
        return Some((Rational::from(whole), places));
    }
    if mantissa == 0 {
        return Some((Rational::from(0), places));
    }
    let halvings = mantissa.trailing_zeros().min(shift);
    mantissa >>= halvings;
    let mut fives = shift;
    while fives > 0 && mantissa.is_multiple_of(5) {
        mantissa /= 5;
        fives -= 1;
    }
    Some((Rational::small(signed(mantissa)?, 5u64.pow(fives) << (shift - halvings)), places))
}

/// So many digits fit a machine word, and so does ten to that power.
const SHORT_DIGITS: usize = 18;

/// An exponent of one to four digits with an optional sign.
fn short_exponent(text: &[u8]) -> Option<i32> {
    let (negative, digits) = match text {
        [b'-', digits @ ..] => (true, digits),
        [b'+', digits @ ..] => (false, digits),
        digits => (false, digits),
    };
    if digits.is_empty() || digits.len() > 4 || !digits.iter().all(u8::is_ascii_digit) {
        return None;
    }
    let value = digits.iter().fold(0, |value, digit| 10 * value + i32::from(digit - b'0'));
    Some(if negative { -value } else { value })
}

/// A decimal: digits, then optionally a dot with digits on at least one side,
/// then optionally an exponent.
fn parse_decimal(text: &str) -> Result<Rational, ParseNumberError> {
    match short_decimal(text) {
        Some((number, _)) => Ok(number),
        None => parse_long_decimal(text),
    }
}

fn parse_long_decimal(text: &str) -> Result<Rational, ParseNumberError> {
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
    use proptest::prelude::*;

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

    proptest! {
        #[test]
        fn short_decimals_are_read_like_long_ones(text in "[-+]?[0-9]{0,10}(\\.[0-9]{0,10})?([eE][-+]?[0-9]{0,3})?", zeros in 0usize..8) {
            for text in [text.clone(), text.replacen('.', &format!("{}.", "0".repeat(zeros)), 1), format!("{text}{}", "0".repeat(zeros))] {
                prop_assert_eq!(text.parse::<Rational>(), parse_long_decimal(&text), "{}", text);
            }
        }
    }

    #[test]
    fn short_decimals_take_the_short_way() {
        for text in ["0", "-12.500", "999999999999999999", "1.5e-05", "2E18", ".000000000000000001", "-0.125000"] {
            assert_eq!(short_decimal(text).map(|found| found.0), parse_long_decimal(text).ok(), "{text}");
        }
        for text in ["1e19", "10E18", "1234567890.123456789", "1/2", "", ".", "1.", "e1", "1e", "0x1"] {
            assert_eq!(short_decimal(text), None, "{text}");
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
