//! A test of joins that is prepared once and then asked many times.

use num_bigint::BigInt;
use num_traits::{One, Zero};

use crate::error::Error;
use crate::exact::Rational;
use crate::exact::gcd::gcd_big;
use crate::exact::magnitude::Magnitude;
use crate::exact::width::{Entries, Integer};
use crate::joint::{Joint, arguments_off, over_one_frame};
use crate::kernel::denominator::CommonDenominator;
use crate::piece::Piece;

/// The conditions of a `C^k` join of two pieces of given kinds, degrees and
/// frames, as combinations of their control points with integer coefficients.
///
/// They are prepared once and serve every pair of nets over these frames: two
/// curves at a common end, two triangles, two rectangles, or one of each, across
/// a common side, of any degrees, each with its vertices in any order. The width
/// of the integers is chosen for a pair of nets from a bound, so that nothing is
/// checked on the way. For rational pieces the points are the homogeneous ones,
/// and the order is that of the homogeneous maps.
///
/// ```
/// use casteljau::{Interval, Joint, Piece, Rational, Segment, SmoothnessTest};
/// let q = Rational::from;
/// let over = |from, to, points: [i64; 4]| -> Result<Piece, casteljau::Error> {
///     Ok(Piece::Curve(Segment::new(1, points.map(q).to_vec(), Interval::new(q(from), q(to))?)?))
/// };
/// let (first, second) = (over(0, 1, [0, 1, 3, 4])?, over(1, 3, [4, 6, 9, 0])?);
/// let test = SmoothnessTest::new(&first, &second, &Joint::Parameter(q(1)), 2)?;
/// // Twice as fast over an interval of twice the length: C1, and not C2.
/// assert_eq!(test.order(&[0, 1, 3, 4], &[4, 6, 9, 0])?, Some(1));
/// assert_eq!(test.order(&[0, 1, 3, 4], &[5, 6, 9, 0])?, None);
/// assert_eq!(test.order_of_rationals(first.coordinates(), second.coordinates())?, Some(1));
/// # Ok::<(), casteljau::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct SmoothnessTest {
    /// How many control points each piece has.
    points: [usize; 2],
    /// The highest order that is asked for.
    order: usize,
    /// Points of the first piece that are to be points of the second one.
    shared: Vec<(u32, u32)>,
    /// All other conditions, by their orders.
    conditions: Vec<Condition>,
    /// Their terms where all coefficients fit a word.
    short: Option<Vec<(u32, i64)>>,
    long: Vec<(u32, BigInt)>,
    /// The sum of the absolute coefficients of a condition, at most.
    growth: Magnitude,
    /// The largest `n` so that coordinates up to `2^n` leave every sum in one word.
    room: Option<u32>,
}

/// Where the terms of a condition end: first those of the first piece, then
/// those of the second one, which are to give the same sum.
#[derive(Clone, Copy, Debug)]
struct Condition {
    order: usize,
    middle: usize,
    end: usize,
}

impl SmoothnessTest {
    /// The most control points of a piece.
    pub const MAX_POINTS: usize = 512;

    /// The test for continuity up to `order` of pieces of these kinds, degrees
    /// and frames. Their control points do not matter.
    ///
    /// # Errors
    /// [`Error::WrongShape`] if the joint is not an end or side of both or they
    /// do not join; [`Error::TooLarge`] for more than [`SmoothnessTest::MAX_POINTS`] points.
    pub fn new(first: &Piece, second: &Piece, joint: &Joint, order: usize) -> Result<Self, Error> {
        let points = [first, second].map(|piece| piece.points().len());
        arguments_off(first, joint)?;
        let mut test = Self {
            points,
            order,
            shared: Vec::new(),
            conditions: Vec::new(),
            short: None,
            long: Vec::new(),
            growth: Magnitude::ONE,
            room: None,
        };
        for (off, row) in conditions(first, second, joint, order)? {
            let row = primitive(&row);
            let total = row.iter().fold(Magnitude::ZERO, |sum, x| sum.plus(Magnitude::from_big(x.magnitude())));
            test.growth = test.growth.max(total);
            let (own, other) = row.split_at(points[0]);
            let terms = |part: &[BigInt], sign: i32| {
                let kept = part.iter().enumerate().filter(|(_, x)| !x.is_zero());
                kept.map(|(place, x)| (place as u32, x * sign)).collect::<Vec<_>>()
            };
            let (own, other) = (terms(own, 1), terms(other, -1));
            if let (0, [(a, x)], [(b, y)]) = (off, own.as_slice(), other.as_slice())
                && x == y
            {
                test.shared.push((*a, *b));
                continue;
            }
            test.long.extend(own);
            let middle = test.long.len();
            test.long.extend(other);
            test.conditions.push(Condition { order: off, middle, end: test.long.len() });
        }
        test.short = test.long.iter().map(|(place, x)| Some((*place, i64::try_from(x).ok()?))).collect();
        let fits = |n: &u32| test.growth.times(Magnitude::from(1u64 << n)).bits() < 64;
        test.room = (0..64).rev().find(fits).filter(|_| test.short.is_some());
        Ok(test)
    }

    /// The highest order, up to the one that the test was made for, to which
    /// these nets join; none where they are not even `C0`. The nets are the
    /// coordinates of the control points, point by point.
    ///
    /// # Errors
    /// [`Error::WrongCount`] if these are not the coordinates of as many points
    /// as the pieces have, of one dimension.
    pub fn order(&self, first: &[i64], second: &[i64]) -> Result<Option<usize>, Error> {
        let dimension = self.dimension(first.len(), second.len())?;
        // The highest bit in which a number differs from its double is one above those that
        // it needs beside the sign; the union of these has that of the largest number.
        let changes = |net: &[i64]| net.iter().fold(0, |bits, &value| bits | (value ^ (value << 1)) as u64);
        let bits = 64 - (changes(first) | changes(second)).leading_zeros();
        let exponent = bits.saturating_sub(1);
        Ok(match &self.short {
            Some(terms) if self.room.is_some_and(|room| exponent <= room) => self.order_in_one_word(first, second, dimension, terms),
            _ => self.order_of_words(first, second, dimension, 1 << exponent),
        })
    }

    /// The same for coordinates in rational numbers.
    ///
    /// # Errors
    /// As for [`SmoothnessTest::order`].
    pub fn order_of_rationals(&self, first: &[Rational], second: &[Rational]) -> Result<Option<usize>, Error> {
        let dimension = self.dimension(first.len(), second.len())?;
        let all = first.iter().chain(second);
        let mut words = Entries::new();
        if let Some((_, largest)) = CommonDenominator::of_words(all.clone(), &mut words) {
            let (first, second) = words.split_at(first.len());
            return Ok(self.order_of_words(first, second, dimension, largest));
        }
        let common = CommonDenominator::of(all);
        let numerators = |net: &[Rational]| net.iter().map(|x| common.numerator(x)).collect::<Vec<BigInt>>();
        Ok(self.order_of(&numerators(first), &numerators(second), dimension, &self.long))
    }

    /// The number of coordinates of a point.
    fn dimension(&self, first: usize, second: usize) -> Result<usize, Error> {
        let [own, other] = self.points;
        // In space without a division, which takes longer than a condition.
        let dimension = if first == 3 * own { 3 } else { first / own };
        match (first == dimension * own && dimension > 0, second == dimension * other) {
            (true, true) => Ok(dimension),
            (true, false) => Err(Error::WrongCount { what: "coordinates of the second net", expected: dimension * other, found: second }),
            (false, _) => Err(Error::WrongCount { what: "coordinates of the first net", expected: dimension.max(1) * own, found: first }),
        }
    }

    fn order_of_words(&self, first: &[i64], second: &[i64], dimension: usize, bound: u64) -> Option<usize> {
        let bits = self.growth.times(Magnitude::from(bound)).bits();
        match (&self.short, bits) {
            (Some(terms), 0..=63) => self.order_in_one_word(first, second, dimension, terms),
            (Some(terms), 64..=127) => {
                let wide = |net: &[i64]| net.iter().map(|&x| i128::from(x)).collect::<Vec<_>>();
                let terms: Vec<(u32, i128)> = terms.iter().map(|&(place, x)| (place, i128::from(x))).collect();
                self.order_of(&wide(first), &wide(second), dimension, &terms)
            }
            _ => {
                let long = |net: &[i64]| net.iter().map(|&x| BigInt::from(x)).collect::<Vec<_>>();
                self.order_of(&long(first), &long(second), dimension, &self.long)
            }
        }
    }

    fn order_in_one_word(&self, first: &[i64], second: &[i64], dimension: usize, terms: &[(u32, i64)]) -> Option<usize> {
        match dimension {
            1 => self.order_of_vectors::<1>(first, second, terms),
            2 => self.order_of_vectors::<2>(first, second, terms),
            3 => self.order_of_vectors::<3>(first, second, terms),
            4 => self.order_of_vectors::<4>(first, second, terms),
            _ => self.order_of(first, second, dimension, terms),
        }
    }

    /// For points with a number of coordinates known beforehand, below 2^63 all along.
    #[inline(never)]
    fn order_of_vectors<const D: usize>(&self, first: &[i64], second: &[i64], terms: &[(u32, i64)]) -> Option<usize> {
        let (first, second) = (first.as_chunks::<D>().0, second.as_chunks::<D>().0);
        // Written out: closures cost a quarter more here.
        for &(own, other) in &self.shared {
            if first[own as usize] != second[other as usize] {
                return None;
            }
        }
        let mut start = 0;
        for condition in &self.conditions {
            let mut sum = [0i64; D];
            for &(place, factor) in &terms[start..condition.middle] {
                let point = &first[place as usize];
                for axis in 0..D {
                    sum[axis] = sum[axis].wrapping_add(point[axis].wrapping_mul(factor));
                }
            }
            for &(place, factor) in &terms[condition.middle..condition.end] {
                let point = &second[place as usize];
                for axis in 0..D {
                    sum[axis] = sum[axis].wrapping_sub(point[axis].wrapping_mul(factor));
                }
            }
            // Compared with zeros, the sum stays in registers.
            if sum != [0; D] {
                return condition.order.checked_sub(1);
            }
            start = condition.end;
        }
        Some(self.order)
    }

    fn order_of<R: Integer>(&self, first: &[R], second: &[R], dimension: usize, terms: &[(u32, R)]) -> Option<usize> {
        let value = |net: &[R], terms: &[(u32, R)], axis: usize| {
            terms.iter().fold(R::nothing(), |mut sum, (place, factor)| {
                sum.add_product(factor, &net[*place as usize * dimension + axis]);
                sum
            })
        };
        let vanishes = |mut difference: R, other: &R| {
            difference.subtract(other);
            difference.is_nothing()
        };
        let same = |&(own, other): &(u32, u32)| {
            let (own, other) = (own as usize * dimension, other as usize * dimension);
            (0..dimension).all(|axis| vanishes(first[own + axis].clone(), &second[other + axis]))
        };
        if !self.shared.iter().all(same) {
            return None;
        }
        let mut start = 0;
        for condition in &self.conditions {
            let (own, other) = (&terms[start..condition.middle], &terms[condition.middle..condition.end]);
            if !(0..dimension).all(|axis| vanishes(value(first, own, axis), &value(second, other, axis))) {
                return condition.order.checked_sub(1);
            }
            start = condition.end;
        }
        Some(self.order)
    }
}

/// The conditions of the orders up to `order`, by their orders: the coefficients
/// of all control points of the first piece, then those of the second one, of a
/// combination that is to be zero.
///
/// # Errors
/// As for [`SmoothnessTest::new`], where the first piece need not have the joint as an end or side.
pub(crate) fn conditions(first: &Piece, second: &Piece, joint: &Joint, order: usize) -> Result<Vec<(usize, Vec<Rational>)>, Error> {
    let [a, b] = over_one_frame(&unit_net(first)?, &unit_net(second)?)?;
    let off = arguments_off(&b, joint)?;
    let rows = a.points().zip(b.points()).zip(off).filter(|(_, off)| *off <= order);
    let mut rows: Vec<(usize, Vec<Rational>)> =
        rows.map(|((a, b), off)| (off, a.iter().cloned().chain(b.iter().map(|x| -x)).collect())).collect();
    rows.sort_by_key(|(off, _)| *off);
    Ok(rows)
}

/// The piece with the unit vectors as control points, so that every point of it
/// is its own combination of them.
///
/// # Errors
/// [`Error::TooLarge`] for more than [`SmoothnessTest::MAX_POINTS`].
pub(crate) fn unit_net(piece: &Piece) -> Result<Piece, Error> {
    let count = piece.points().len();
    if count > SmoothnessTest::MAX_POINTS {
        return Err(Error::TooLarge { what: "number of control points of a piece of a join", limit: SmoothnessTest::MAX_POINTS });
    }
    let point = |place: usize| (0..count).map(|axis| Rational::from(i64::from(axis == place))).collect();
    piece.with_points((0..count).map(point).collect())
}

/// The integers without a common divisor that are in proportion to these numbers.
fn primitive(row: &[Rational]) -> Vec<BigInt> {
    let mut integers = Rational::clear_to_integers(row);
    let common = integers.iter().fold(BigInt::zero(), |common, x| gcd_big(common.magnitude(), x.magnitude()).into());
    if !common.is_one() && !common.is_zero() {
        integers.iter_mut().for_each(|x| *x /= &common);
    }
    integers
}
