//! Decimals that look like fractions cut off, and what they hide.

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, Zero};

use super::{Cubic, CubicClass};
use crate::curve::Curve;
use crate::error::Error;
use crate::exact::Rational;
use crate::segment::Segment;

/// A number and the fraction that it may be meant to be.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Replacement {
    /// The number as it was given.
    pub given: Rational,
    /// How many decimals it has.
    pub decimals: u32,
    /// The fraction.
    pub meant: Rational,
}

/// A class that shows once decimals are read as the fractions they look like.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Intention {
    /// The numbers that were replaced, each once.
    pub replacements: Vec<Replacement>,
    /// The class of the curve as it was given.
    pub given: CubicClass,
    /// The class that small errors hide.
    pub meant: CubicClass,
}

/// The fewest decimals that are taken for a fraction cut off.
const FEWEST: u32 = 2;
/// The most decimals of a number that is looked at.
const MOST: u32 = 60;
/// From so many decimals on, the error may be that of a double.
const DOUBLE: u32 = 12;
/// The largest denominator of a fraction that is suggested.
const LARGEST: i64 = 999;

/// The number of decimals of a number, if it is a decimal fraction.
fn decimals(number: &Rational) -> Option<u32> {
    let mut denominator = number.denom();
    let mut count = [0u32; 2];
    for (count, prime) in count.iter_mut().zip([2u32, 5]) {
        while (&denominator % prime).is_zero() && *count <= MOST {
            denominator /= prime;
            *count += 1;
        }
    }
    denominator.is_one().then(|| count[0].max(count[1])).filter(|count| *count <= MOST)
}

/// The number cut off, and rounded, to so many decimals.
fn shortened(number: &Rational, places: u32) -> [Rational; 2] {
    let scale = BigInt::from(10).pow(places);
    let doubled = number.abs().numer() * &scale * 2u32;
    let sign = BigInt::from(if number.is_negative() { -1 } else { 1 });
    let (cut, rounded) = (&doubled / (number.denom() * 2u32), (&doubled + number.denom()) / (number.denom() * 2u32));
    [cut, rounded].map(|digits| Rational::from_big(digits * &sign, scale.clone()))
}

/// The fraction that a decimal looks like.
fn meant(number: &Rational) -> Option<Replacement> {
    let decimals = decimals(number).filter(|count| *count >= FEWEST)?;
    let unit = Rational::new(1, 10).pow(decimals);
    // A double has 53 bits; what it was printed as differs from the fraction by one or two units of the last one.
    let double = number.abs() * Rational::new(1, 1 << 52);
    let tolerance = if decimals >= DOUBLE && double > unit { double } else { unit };
    // A fraction with a denominator q is near a given number by chance with a probability of about q² times the tolerance.
    let certain = |q: i64| Rational::from(8 * q * q) * &tolerance <= Rational::one();
    for q in (1..=LARGEST).take_while(|q| certain(*q)) {
        let scaled = number * Rational::from(q) + Rational::new(1, 2);
        let fraction = Rational::from_big(scaled.numer().div_floor(&scaled.denom()), BigInt::from(q));
        if fraction == *number {
            return None;
        }
        let error = (&fraction - number).abs();
        let is_shortened = || shortened(&fraction, decimals).contains(number);
        if error <= tolerance && (decimals >= DOUBLE || is_shortened()) {
            return Some(Replacement { given: number.clone(), decimals, meant: fraction });
        }
    }
    None
}

/// Replaces numbers by what they look like, and keeps a list of that.
fn replaced(numbers: impl Iterator<Item = Rational>) -> (Vec<Rational>, Vec<Replacement>) {
    let mut list: Vec<Replacement> = Vec::new();
    let new = numbers
        .map(|number| match meant(&number) {
            None => number,
            Some(found) => {
                let fraction = found.meant.clone();
                if !list.contains(&found) {
                    list.push(found);
                }
                fraction
            }
        })
        .collect();
    (new, list)
}

impl Cubic {
    /// Whether a curve would be of a degenerate class if the decimals among its
    /// coefficients that look like fractions cut off were these fractions.
    ///
    /// # Errors
    /// As for [`Cubic::new`].
    pub fn intention_of_curve(curve: &Curve) -> Result<Option<Intention>, Error> {
        let given = Self::new(curve)?;
        let (coefficients, list) = replaced((0..=curve.degree()).flat_map(|power| curve.vector(power).iter().cloned()));
        intention(&given, list, || Ok(Curve::from_vectors(curve.dimension(), coefficients)))
    }

    /// The same for the control points of a segment.
    ///
    /// ```
    /// use casteljau::{Cubic, CubicClass, Interval, Rational, Segment};
    /// // The middle points of a parabola that ends in (0, 0) and (1, 1), with three decimals.
    /// let q = |n| Rational::new(n, 1000);
    /// let points = [0, 0, 333, 0, 667, 333, 1000, 1000].map(q).to_vec();
    /// let intention = Cubic::intention_of_segment(&Segment::new(2, points, Interval::unit())?)?;
    /// assert_eq!(intention.map(|found| (found.given, found.meant)), Some((CubicClass::Loopy, CubicClass::Parabolic)));
    /// # Ok::<(), casteljau::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`Cubic::new`].
    pub fn intention_of_segment(segment: &Segment) -> Result<Option<Intention>, Error> {
        let given = Self::new(&segment.curve()?)?;
        let (coordinates, list) = replaced(segment.coordinates().iter().cloned());
        intention(&given, list, || Segment::new(segment.dimension(), coordinates, segment.frame().clone())?.curve())
    }
}

fn intention(given: &Cubic, list: Vec<Replacement>, curve: impl FnOnce() -> Result<Curve, Error>) -> Result<Option<Intention>, Error> {
    if list.is_empty() {
        return Ok(None);
    }
    let (given, meant) = (given.class(), Cubic::new(&curve()?)?.class());
    Ok((given != meant && !meant.is_stable()).then_some(Intention { replacements: list, given, meant }))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn looks_like(text: &str) -> Option<String> {
        meant(&text.parse().expect("a number")).map(|found| found.meant.to_string())
    }

    #[test]
    fn fractions_cut_off_are_recognized() {
        for (text, fraction) in [
            ("0.33", "1/3"),
            ("0.333", "1/3"),
            ("0.667", "2/3"),
            ("0.666", "2/3"),
            ("-0.6667", "-2/3"),
            ("183.33333333333331", "550/3"),
            ("0.142857", "1/7"),
            ("0.30000000000000004", "3/10"),
            ("0.09090909", "1/11"),
        ] {
            assert_eq!(looks_like(text).as_deref(), Some(fraction), "{text}");
        }
    }

    #[test]
    fn ordinary_decimals_are_left_alone() {
        for text in ["0", "3", "0.3", "0.5", "0.25", "0.34", "0.99", "0.125", "2.718", "3.14159", "0.1534567", "7/3", "0.332", "149.325"] {
            assert_eq!(looks_like(text), None, "{text}");
        }
    }
}
