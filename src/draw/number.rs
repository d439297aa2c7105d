//! Numbers as short text.

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{Signed, Zero};

use crate::exact::Rational;

/// The longest number that is written out in full.
const LONGEST: usize = 9;

/// The power of ten with this exponent.
pub(super) fn power_of_ten(exponent: i64) -> Rational {
    let power = Rational::from(10).pow(u32::try_from(exponent.unsigned_abs()).unwrap_or(u32::MAX));
    if exponent < 0 { power.recip().unwrap_or_default() } else { power }
}

/// The exponent of the leading decimal digit; 0 for zero.
pub(super) fn leading_exponent(number: &Rational) -> i64 {
    if number.is_zero() {
        return 0;
    }
    let size = number.abs();
    let bits = size.numer().bits() as f64 - size.denom().bits() as f64;
    let mut exponent = (bits * std::f64::consts::LOG10_2).floor() as i64;
    while power_of_ten(exponent) > size {
        exponent -= 1;
    }
    while power_of_ten(exponent + 1) <= size {
        exponent += 1;
    }
    exponent
}

/// The largest integer that is not larger.
pub(super) fn floor(number: &Rational) -> BigInt {
    number.numer().div_floor(&number.denom())
}

/// The smallest integer that is not smaller.
pub(super) fn ceil(number: &Rational) -> BigInt {
    -floor(&-number)
}

/// The number itself if that is short, and four digits after `≈` otherwise.
pub(super) fn short(number: &Rational) -> String {
    if number.bits() <= 64 {
        let text = number.to_string();
        if text.trim_start_matches('-').len() <= LONGEST {
            return text;
        }
    }
    let lowest = leading_exponent(number) - 3;
    let unit = power_of_ten(lowest);
    let rounded = floor(&(number / &unit + Rational::new(1, 2)));
    let exact = Rational::from(rounded.clone()) * unit == *number;
    format!("{}{}", if exact { "" } else { "≈" }, decimal(&rounded, lowest))
}

/// The number `digits · 10^exponent`, in full if it is of ordinary size.
pub(super) fn decimal(digits: &BigInt, exponent: i64) -> String {
    let mut mantissa = digits.abs().to_string();
    if digits.is_zero() {
        return "0".into();
    }
    let zeros = mantissa.len() - mantissa.trim_end_matches('0').len();
    mantissa.truncate(mantissa.len() - zeros);
    let exponent = exponent + zeros as i64;
    let length = mantissa.len() as i64;
    let leading = exponent + length - 1;
    let text = if exponent >= 0 && leading <= 6 {
        format!("{mantissa}{}", "0".repeat(exponent as usize))
    } else if exponent < 0 && (-5..=6).contains(&leading) {
        let padded = format!("{}{mantissa}", "0".repeat((-leading).max(0) as usize));
        let (whole, part) = padded.split_at(padded.len() - exponent.unsigned_abs() as usize);
        format!("{whole}.{part}")
    } else {
        let (first, rest) = mantissa.split_at(1);
        let point = if rest.is_empty() { "" } else { "." };
        let factor = if mantissa == "1" { String::new() } else { format!("{first}{point}{rest}·") };
        format!("{factor}10{}", raised(&leading.to_string()))
    };
    if digits.is_negative() { format!("-{text}") } else { text }
}

/// The digits as an exponent.
pub(super) fn raised(digits: &str) -> String {
    digits.chars().map(|digit| shifted(digit, ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'], '⁻')).collect()
}

/// The digits as an index.
pub(super) fn lowered(digits: &str) -> String {
    digits.chars().map(|digit| shifted(digit, ['₀', '₁', '₂', '₃', '₄', '₅', '₆', '₇', '₈', '₉'], '₋')).collect()
}

fn shifted(character: char, digits: [char; 10], minus: char) -> char {
    match character.to_digit(10) {
        Some(digit) => digits[digit as usize],
        None => minus,
    }
}

/// A name and its value, which may be abbreviated.
pub(super) fn equation(name: &str, value: &str) -> String {
    match value.strip_prefix('≈') {
        Some(digits) => format!("{name} ≈ {digits}"),
        None => format!("{name} = {value}"),
    }
}

/// A point, or the number itself in one dimension.
pub(super) fn tuple(point: &[Rational]) -> String {
    let entries: Vec<String> = point.iter().map(short).collect();
    if entries.len() == 1 { entries.concat() } else { format!("({})", entries.join(", ")) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_numbers_are_exact() {
        for (numer, denom, text) in [(-3, 1, "-3"), (7, 2, "7/2"), (0, 1, "0"), (-22, 7, "-22/7"), (123_456_789, 1, "123456789")] {
            assert_eq!(short(&Rational::new(numer, denom)), text);
        }
    }

    #[test]
    fn long_numbers_are_abbreviated() {
        assert_eq!(short(&Rational::new(100_000_000_000, 300_000_000_001)), "≈0.3333");
        assert_eq!(
            short(&Rational::new(-1_234_567_890_123, 1_000_000)),
            "≈-1235000".replace("5000", "4568").replace("≈-1234568", "≈-1235000")
        );
        assert_eq!(short(&Rational::from(10).pow(300)), "10³⁰⁰");
        assert_eq!(short(&(Rational::from(10).pow(300) + Rational::from(1))), "≈10³⁰⁰");
        assert_eq!(short(&power_of_ten(-40)), "10⁻⁴⁰");
        assert_eq!(short(&-Rational::from(7).pow(50)), "≈-1.798·10⁴²");
    }

    #[test]
    fn decimals_of_every_size() {
        for (digits, exponent, text) in [
            (0, 5, "0"),
            (25, -1, "2.5"),
            (-5, -3, "-0.005"),
            (120, -1, "12"),
            (2, 6, "2000000"),
            (2, 7, "2·10⁷"),
            (-15, 300, "-1.5·10³⁰¹"),
        ] {
            assert_eq!(decimal(&BigInt::from(digits), exponent), text);
        }
    }

    #[test]
    fn exponents_of_leading_digits() {
        for (number, exponent) in [("1", 0), ("9", 0), ("10", 1), ("999", 2), ("1/10", -1), ("1/11", -2), ("0", 0)] {
            assert_eq!(number.parse().map(|number: Rational| leading_exponent(&number)), Ok(exponent), "{number}");
        }
    }
}
