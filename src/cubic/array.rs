//! The classes of many cubics at once, from integers or from rationals.
//!
//! From the edges `a`, `d`, `e` of the control polygon and `A = det(a, d)`,
//! `B = det(a, e)`, `C = det(d, e)` one has, in the parameter of the frame,
//! `κ12 = 9 A`, `κ31 = 3 (2A - B)`, `κ23 = 3 (A - B + C)` and
//! `D = 27 (B² - 4 A C)`; none of the classes depends on the frame.

use super::{Branch, CubicClass, Invariants};
use crate::affine::Interval;
use crate::error::Error;
use crate::exact::{Rational, gcd::gcd_u64};
use crate::segment::Segment;

/// Coordinates below this are classified in words.
const ONE_WORD: u64 = 1 << 29;
/// Coordinates below this are classified in two words, with products of four.
const TWO_WORDS: u64 = 1 << 60;

/// How many cubics share the choice of a width.
const BLOCK: usize = 256;

/// The class of each of these cubics, given by its four control points
/// `x0, y0, …, x3, y3` in integers of any size that fits.
///
/// The width of the integers is chosen for blocks of cubics from a bound of
/// their coordinates, so that nothing is checked on the way.
///
/// ```
/// use casteljau::{CubicClass, classify_array};
/// let cubics = [[0, 0, -4, 4, -4, -12, 0, 0], [0, 0, 1, 1, 2, 2, 3, 3]];
/// assert_eq!(classify_array(&cubics), [CubicClass::Loopy, CubicClass::Straight]);
/// ```
#[must_use]
pub fn classify_array(cubics: &[[i64; 8]]) -> Vec<CubicClass> {
    let mut classes = Vec::with_capacity(cubics.len());
    for block in cubics.chunks(BLOCK) {
        // The bitwise union of absolute values has the bits of the largest.
        let bound = block.iter().flatten().fold(0, |bits, value| bits | value.unsigned_abs());
        if bound < ONE_WORD {
            classes.extend(block.iter().map(in_one_word));
        } else {
            classes.extend(block.iter().map(in_words));
        }
    }
    classes
}

/// The class of each of these cubics, given by its four control points.
///
/// ```
/// use casteljau::{CubicClass, Rational, classify_rationals};
/// let polygon = [0, 0, 1, 3, 2, 3, 3, 0].map(|n| Rational::new(n, 1000));
/// assert_eq!(classify_rationals(&[polygon]), [CubicClass::Parabolic]);
/// ```
#[must_use]
pub fn classify_rationals(cubics: &[[Rational; 8]]) -> Vec<CubicClass> {
    cubics.iter().map(rational_class).collect()
}

fn rational_class(points: &[Rational; 8]) -> CubicClass {
    match cleared(points) {
        Some(points) => in_words(&points),
        None => by_invariants(points),
    }
}

/// The numbers times a common denominator, if all of that fits words.
fn cleared(numbers: &[Rational; 8]) -> Option<[i64; 8]> {
    let mut common = 1u64;
    let mut parts = [(0i64, 1u64); 8];
    for (part, number) in parts.iter_mut().zip(numbers) {
        *part = number.as_small()?;
        let denominator = part.1;
        if denominator != common && denominator != 1 && remainder(common, denominator) != 0 {
            let shared = gcd_u64(common, denominator);
            common = common.checked_mul(denominator / shared)?;
        }
    }
    let mut integers = [0; 8];
    for (integer, (numerator, denominator)) in integers.iter_mut().zip(parts) {
        let factor = if denominator == common { 1 } else { quotient(common, denominator) };
        *integer = numerator.checked_mul(i64::try_from(factor).ok()?)?;
    }
    Some(integers)
}

/// Short divisions take half the time of long ones.
#[inline]
fn remainder(a: u64, b: u64) -> u64 {
    match (u32::try_from(a), u32::try_from(b)) {
        (Ok(a), Ok(b)) => u64::from(a % b),
        _ => a % b,
    }
}

#[inline]
fn quotient(a: u64, b: u64) -> u64 {
    match (u32::try_from(a), u32::try_from(b)) {
        (Ok(a), Ok(b)) => u64::from(a / b),
        _ => a / b,
    }
}

/// The slow and obvious way, for coordinates of any length.
fn by_invariants(points: &[Rational; 8]) -> CubicClass {
    let class =
        || -> Result<CubicClass, Error> { Ok(Invariants::of(&Segment::new(2, points.to_vec(), Interval::unit())?.curve()?)?.class()) };
    // Four points of the plane are a planar cubic, and none of the steps can fail.
    class().unwrap_or(CubicClass::Straight)
}

/// For coordinates below `2^29`: the determinants are below `8 · 2^58`, and so
/// are below `2^63` when three are added.
#[inline]
fn in_one_word(p: &[i64; 8]) -> CubicClass {
    let edge = |i: usize| (p[2 * i + 2] - p[2 * i], p[2 * i + 3] - p[2 * i + 1]);
    let (first, second, third) = (edge(0), edge(1), edge(2));
    let det = |v: (i64, i64), w: (i64, i64)| v.0 * w.1 - v.1 * w.0;
    let (a, b, c) = (det(first, second), det(first, third), det(second, third));
    let (square, product) = (i128::from(b) * i128::from(b), i128::from(a) * i128::from(c) * 4);
    Branch::of(a - b + c == 0, || square.cmp(&product), || 2 * a == b, || a == 0).class()
}

/// For coordinates of any length: below `2^60` the edges fit a word, and three
/// determinants, each below `8 · 2^120`, fit two.
fn in_words(p: &[i64; 8]) -> CubicClass {
    let bound = p.iter().fold(0, |bits, value| bits | value.unsigned_abs());
    if bound < ONE_WORD {
        return in_one_word(p);
    }
    if bound >= TWO_WORDS {
        return by_invariants(&p.map(Rational::from));
    }
    let edge = |i: usize| (p[2 * i + 2] - p[2 * i], p[2 * i + 3] - p[2 * i + 1]);
    let (first, second, third) = (edge(0), edge(1), edge(2));
    let det = |v: (i64, i64), w: (i64, i64)| i128::from(v.0) * i128::from(w.1) - i128::from(v.1) * i128::from(w.0);
    let (a, b, c) = (det(first, second), det(first, third), det(second, third));
    let discriminant = if (a < 0) == (c < 0) && a != 0 && c != 0 {
        square(b.unsigned_abs()).cmp(&product(2 * a.unsigned_abs(), 2 * c.unsigned_abs()))
    } else {
        // B² - 4 A C with A C ≤ 0
        (a != 0 && c != 0 || b != 0).cmp(&false)
    };
    Branch::of(a - b + c == 0, || discriminant, || 2 * a == b, || a == 0).class()
}

fn square(value: u128) -> (u128, u128) {
    product(value, value)
}

/// The product of two numbers in four words, the high half first.
#[inline]
fn product(x: u128, y: u128) -> (u128, u128) {
    const LOW: u128 = u64::MAX as u128;
    let (x1, x0, y1, y0) = (x >> 64, x & LOW, y >> 64, y & LOW);
    let low = x0 * y0;
    let (middle, carry) = (x1 * y0).overflowing_add(x0 * y1);
    let (sum, more) = low.overflowing_add(middle << 64);
    (x1 * y1 + (middle >> 64) + (u128::from(carry) << 64) + u128::from(more), sum)
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_bigint::BigUint;
    use proptest::prelude::*;

    /// Coordinates around the borders of the widths, and small ones, which degenerate often.
    fn coordinate() -> impl Strategy<Value = i64> {
        prop_oneof![
            4 => -3i64..4,
            1 => any::<i32>().prop_map(i64::from),
            1 => (-2i64..3).prop_map(|k| ONE_WORD as i64 + k),
            1 => (-2i64..3).prop_map(|k| -(TWO_WORDS as i64) + k),
            1 => any::<i64>(),
        ]
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 2000, ..ProptestConfig::default() })]

        #[test]
        fn every_width_agrees_with_the_invariants(points in prop::array::uniform8(coordinate()), scale in 1i64..1000, straight: bool) {
            let mut points = points;
            if straight {
                // On one line, and near it.
                for k in [3, 5, 7] { points[k] = points[k - 1]; }
                points[1] = points[0];
            }
            let expected = by_invariants(&points.map(Rational::from));
            prop_assert_eq!(classify_array(&[points]), [expected]);
            prop_assert_eq!(classify_rationals(&[points.map(|n| Rational::new(n, scale))]), [expected]);
            let distinct = std::array::from_fn(|k| Rational::new(points[k], [1, 2, 5, 8, 10, 25, 3, 1000][k]));
            prop_assert_eq!(classify_rationals(std::slice::from_ref(&distinct)), [by_invariants(&distinct)]);
        }

        #[test]
        fn products_of_two_words(x: u128, y: u128) {
            let (high, low) = product(x, y);
            prop_assert_eq!((BigUint::from(high) << 128u32) + low, BigUint::from(x) * BigUint::from(y));
        }
    }
}
