//! Decimals beside exact numbers, marked as what they are.

use num_bigint::BigInt;
use num_traits::Signed;

use super::formula::Notation;
use crate::exact::Rational;
use crate::kernel::coefficient::Coefficient;

/// The number rounded to `places` decimals, halves away from zero. The caller
/// prints it behind `≈`, or behind `=` where [`Rational`] and decimal agree.
///
/// ```
/// use casteljau::{Rational, report::decimal};
/// assert_eq!(decimal(&Rational::new(-2, 3), 3), "-0.667");
/// assert_eq!(decimal(&Rational::new(1, 2), 0), "1");
/// ```
#[must_use]
pub fn decimal(value: &Rational, places: usize) -> String {
    let scaled: BigInt = value.numer().abs() * BigInt::from(10).pow(places as u32) * 2u32 + value.denom();
    let digits = (scaled / (value.denom() * 2u32)).to_string();
    let digits = format!("{digits:0>width$}", width = places + 1);
    let (whole, fraction) = digits.split_at(digits.len() - places);
    let sign = if value.is_negative() && digits.bytes().any(|digit| digit != b'0') { "-" } else { "" };
    if places == 0 { format!("{sign}{whole}") } else { format!("{sign}{whole}.{fraction}") }
}

impl Notation {
    /// Decimals behind an exact point, if asked for.
    pub(super) fn approximately<C: Coefficient>(&self, point: &[C]) -> String {
        let Some(places) = self.decimals else { return String::new() };
        let numbers: Option<Vec<Rational>> = point.iter().map(Coefficient::as_rational).collect();
        match numbers {
            Some(numbers) if numbers.iter().any(|number| !number.is_integer()) => {
                let decimals: Vec<String> = numbers.iter().map(|number| decimal(number, places)).collect();
                match decimals.as_slice() {
                    [only] => format!(" ≈ {only}"),
                    several => format!(" ≈ ({})", several.join(", ")),
                }
            }
            _ => String::new(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding() {
        for (numer, denom, places, text) in [
            (1, 3, 2, "0.33"),
            (-1, 3, 0, "0"),
            (5, 2, 0, "3"),
            (-5, 2, 0, "-3"),
            (1, 1000, 2, "0.00"),
            (-1, 1000, 2, "0.00"),
            (999, 1000, 2, "1.00"),
            (7, 1, 3, "7.000"),
        ] {
            assert_eq!(decimal(&Rational::new(numer, denom), places), text);
        }
    }
}
