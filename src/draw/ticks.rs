//! Round numbers along an axis.

use num_bigint::BigInt;
use num_traits::{ToPrimitive, Zero};

use super::number::{ceil, decimal, floor, leading_exponent, power_of_ten, short};
use crate::exact::Rational;

/// The longest text that fits beside an axis.
const LONGEST: usize = 11;
/// More ticks than an axis of the picture has room for.
const MOST: usize = 100;

/// A distance of ticks: 1, 2 or 5 times a power of ten.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Step {
    digit: i64,
    exponent: i64,
}

impl Step {
    /// The smallest such number that is at least `least`, which is positive.
    pub(super) fn at_least(least: &Rational) -> Self {
        let exponent = leading_exponent(least);
        let power = power_of_ten(exponent);
        let digit = [1, 2, 5].into_iter().find(|&digit| &power * Rational::from(digit) >= *least);
        digit.map_or(Self { digit: 1, exponent: exponent + 1 }, |digit| Self { digit, exponent })
    }

    /// The distance.
    pub(super) fn size(&self) -> Rational {
        Rational::from(self.digit) * power_of_ten(self.exponent)
    }

    /// The range made longer until it ends in ticks.
    pub(super) fn widen(&self, low: &Rational, high: &Rational) -> (Rational, Rational) {
        let size = self.size();
        (Rational::from(floor(&(low / &size))) * &size, Rational::from(ceil(&(high / &size))) * &size)
    }

    /// The multiples of the distance in a range, with their labels.
    pub(super) fn ticks(&self, low: &Rational, high: &Rational) -> Vec<(Rational, String)> {
        let size = self.size();
        let first = ceil(&(low / &size));
        let count = (floor(&(high / &size)) - &first + 1u32).to_usize().unwrap_or(0).min(MOST);
        let multiples: Vec<BigInt> = (0..count).map(|index| &first + index).collect();
        let text = |multiple: &BigInt| decimal(&(multiple * self.digit), self.exponent);
        let mut labels: Vec<String> = multiples.iter().map(text).collect();
        if labels.iter().any(|label| label.chars().count() > LONGEST) {
            // Numbers that differ in late digits only: the first one, and what to add.
            let relative = |(index, multiple): (usize, &BigInt)| match index {
                0 => short(&(Rational::from(multiple.clone()) * &size)),
                _ => format!("+{}", text(&BigInt::from(index))),
            };
            labels = multiples.iter().enumerate().map(relative).collect();
        }
        multiples
            .into_iter()
            .map(|multiple| if multiple.is_zero() { Rational::zero() } else { Rational::from(multiple) * &size })
            .zip(labels)
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(least: Rational, low: Rational, high: Rational) -> Vec<String> {
        Step::at_least(&least).ticks(&low, &high).into_iter().map(|(_, label)| label).collect()
    }

    #[test]
    fn steps_are_one_two_five() {
        for (least, size) in
            [((1, 1), (1, 1)), ((11, 10), (2, 1)), ((3, 1), (5, 1)), ((6, 1), (10, 1)), ((3, 1000), (5, 1000)), ((9, 100), (1, 10))]
        {
            assert_eq!(Step::at_least(&Rational::new(least.0, least.1)).size(), Rational::new(size.0, size.1));
        }
    }

    #[test]
    fn ticks_of_ordinary_ranges() {
        assert_eq!(labels(Rational::new(4, 10), Rational::new(-7, 10), Rational::from(1)), ["-0.5", "0", "0.5", "1"]);
        assert_eq!(labels(Rational::from(3), Rational::from(-12), Rational::from(4)), ["-10", "-5", "0"]);
    }

    #[test]
    fn ticks_far_from_the_origin_are_relative() {
        let far = Rational::from(10).pow(40);
        assert_eq!(labels(Rational::from(1), far.clone(), far + Rational::from(2)), ["10⁴⁰", "+1", "+2"]);
    }

    #[test]
    fn ranges_are_widened_to_ticks() {
        let step = Step::at_least(&Rational::from(2));
        assert_eq!(step.widen(&Rational::new(-1, 2), &Rational::from(4)), (Rational::from(-2), Rational::from(4)));
    }
}
