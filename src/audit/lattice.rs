//! The coordinates of a model as integers: all over one common denominator, so
//! that joins are judged without fractions.

use num_bigint::{BigInt, BigUint};

use crate::exact::Rational;
use crate::exact::gcd::gcd_big;
use crate::exact::width::Ring;
use crate::model::Part;
use crate::side::{Arrangement, Side};

/// The integers that joins are judged with, wide enough by a bound beforehand.
pub(super) trait Whole: Ring + Ord + Into<BigInt> + Send + Sync {
    /// The number of bits of the absolute value.
    fn bits(&self) -> u64;
    /// The number over a power of two, rounded down; the caller knows that it fits.
    fn shifted(&self, shift: u64) -> i64;
    /// The integer.
    fn of_big(value: &BigInt) -> Option<Self>;
}

impl Whole for i128 {
    fn bits(&self) -> u64 {
        u64::from(128 - self.unsigned_abs().leading_zeros())
    }

    fn shifted(&self, shift: u64) -> i64 {
        (self >> shift.min(127)) as i64
    }

    fn of_big(value: &BigInt) -> Option<Self> {
        Self::try_from(value).ok()
    }
}

impl Whole for BigInt {
    fn bits(&self) -> u64 {
        Self::bits(self)
    }

    fn shifted(&self, shift: u64) -> i64 {
        // A shift of a negative number rounds down too.
        i64::try_from(self >> shift).unwrap_or(if self.sign() == num_bigint::Sign::Minus { i64::MIN } else { i64::MAX })
    }

    fn of_big(value: &BigInt) -> Option<Self> {
        Some(value.clone())
    }
}

/// The coordinates of all control points, times the common denominator.
#[derive(Debug)]
pub(super) struct Lattice {
    /// The common denominator.
    pub(super) scale: BigUint,
    numbers: Numbers,
    parts: Vec<Placed>,
    /// The indices of the parts, if these are two of many.
    pair: Option<[usize; 2]>,
}

#[derive(Debug)]
enum Numbers {
    Narrow(Vec<i64>),
    Wide(Vec<BigInt>),
}

/// Where the numbers of a part begin, and how they are arranged.
#[derive(Clone, Copy, Debug)]
pub(super) struct Placed {
    pub(super) arrangement: Arrangement,
    pub(super) dimension: usize,
    start: usize,
}

/// Something that gives control points as integers of a width.
pub(super) trait Points: Sync {
    type Number: Whole;
    fn number(&self, index: usize) -> Self::Number;
}

impl Points for [i64] {
    type Number = i128;
    fn number(&self, index: usize) -> i128 {
        i128::from(self[index])
    }
}

impl Points for [BigInt] {
    type Number = BigInt;
    fn number(&self, index: usize) -> BigInt {
        self[index].clone()
    }
}

/// A side of a part as seen from a joint: layers of control points, the joint
/// itself first, in the direction that both parts share.
#[derive(Debug)]
pub(super) struct View<'a, P: Points + ?Sized> {
    points: &'a P,
    placed: Placed,
    side: Side,
    reversed: bool,
}

impl<P: Points + ?Sized> Clone for View<'_, P> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<P: Points + ?Sized> Copy for View<'_, P> {}

impl<P: Points + ?Sized> View<'_, P> {
    pub(super) fn arrangement(&self) -> Arrangement {
        self.placed.arrangement
    }

    pub(super) fn dimension(&self) -> usize {
        self.placed.dimension
    }

    pub(super) fn degree_along(&self) -> usize {
        self.placed.arrangement.degree_along(self.side)
    }

    pub(super) fn degree_across(&self) -> usize {
        self.placed.arrangement.degree_across(self.side)
    }

    pub(super) fn columns(&self, layer: usize) -> usize {
        self.placed.arrangement.columns(self.side, layer)
    }

    /// One coordinate of a control point.
    pub(super) fn get(&self, layer: usize, column: usize, axis: usize) -> P::Number {
        let Placed { arrangement, dimension, start } = self.placed;
        let column = if self.reversed { self.columns(layer) - 1 - column } else { column };
        self.points.number(start + arrangement.index(self.side, layer, column) * dimension + axis)
    }

    /// A control point.
    pub(super) fn point(&self, layer: usize, column: usize) -> Vec<P::Number> {
        (0..self.placed.dimension).map(|axis| self.get(layer, column, axis)).collect()
    }
}

/// What a computation on a lattice does, whatever the width of its numbers.
pub(super) trait Visitor {
    type Output;
    fn visit<P: Points + ?Sized>(&self, points: &P) -> Self::Output;
}

impl Lattice {
    /// The most bits of a denominator that all parts of a model share. Where they
    /// would need more, every join has a lattice of its own.
    const MAX_COMMON_BITS: u64 = 512;

    /// The lattice of all parts of a model; none if their common denominator is long.
    pub(super) fn of_all(parts: &[Part]) -> Option<Self> {
        Self::of(parts.iter(), Self::MAX_COMMON_BITS)
    }

    /// The lattice of two parts.
    pub(super) fn of_two(parts: &[Part], [first, second]: [usize; 2]) -> Self {
        let own = [first, second].map(|index| &parts[index]);
        // Without a limit there always is one.
        let mut lattice = Self::of(own.into_iter(), u64::MAX).unwrap_or_else(|| unreachable!("there is no limit"));
        lattice.pair = Some([first, second]);
        lattice
    }

    fn of<'a>(parts: impl Iterator<Item = &'a Part> + Clone, most_bits: u64) -> Option<Self> {
        let mut scale = BigUint::from(1u32);
        let mut small = 1u64;
        for number in parts.clone().flat_map(|part| part.piece.coordinates()) {
            match number.as_small() {
                Some((_, denom)) if small.is_multiple_of(denom) => {}
                _ => {
                    let denom = number.denom();
                    // The common divisor is that of the shorter number and a remainder.
                    scale *= denom.magnitude() / gcd_big(&scale, denom.magnitude());
                    if scale.bits() > most_bits {
                        return None;
                    }
                    // While it fits a word, most numbers are seen to divide it at once.
                    small = u64::try_from(&scale).unwrap_or(small);
                }
            }
        }
        let mut placed = Vec::new();
        let (mut start, mut degree, mut rational) = (0, 0, false);
        for part in parts.clone() {
            let arrangement = Arrangement::of(&part.piece);
            placed.push(Placed { arrangement, dimension: part.piece.dimension(), start });
            start += part.piece.coordinates().len();
            degree = arrangement
                .sides()
                .iter()
                .fold(degree, |degree, &side| degree.max(arrangement.degree_along(side)).max(arrangement.degree_across(side)));
            rational |= part.rational;
        }
        let coordinates = || parts.clone().flat_map(|part| part.piece.coordinates());
        let numbers = Self::narrow(coordinates(), &scale, start, degree, rational).map_or_else(
            || {
                let whole = |number: &Rational| number.numer() * BigInt::from(&scale / number.denom().magnitude());
                Numbers::Wide(coordinates().map(whole).collect())
            },
            Numbers::Narrow,
        );
        Some(Self { scale, numbers, parts: placed, pair: None })
    }

    /// The numbers in a word each, if everything computed from them fits two:
    /// the determinant of three fields along an edge is a sum of products of
    /// three coordinates (of six in homogeneous coordinates), times binomial numbers.
    fn narrow<'a>(
        coordinates: impl Iterator<Item = &'a Rational>,
        scale: &BigUint,
        count: usize,
        degree: usize,
        rational: bool,
    ) -> Option<Vec<i64>> {
        let scale = u64::try_from(scale).ok()?;
        let factors = if rational { 6 } else { 3 };
        let spare = 126usize.checked_sub(10 + 2 * factors * (degree + 1))?;
        let bits = u32::try_from(spare / factors).unwrap_or(0).min(62);
        let mut numbers = Vec::with_capacity(count);
        for number in coordinates {
            let (numer, denom) = number.as_small()?;
            let whole = i64::try_from(i128::from(numer) * i128::from(scale / denom)).ok()?;
            if 64 - whole.unsigned_abs().leading_zeros() > bits {
                return None;
            }
            numbers.push(whole);
        }
        Some(numbers)
    }

    /// Runs a computation on the numbers.
    pub(super) fn visit<V: Visitor>(&self, visitor: &V) -> V::Output {
        match &self.numbers {
            Numbers::Narrow(numbers) => visitor.visit(numbers.as_slice()),
            Numbers::Wide(numbers) => visitor.visit(numbers.as_slice()),
        }
    }

    /// A side of a part.
    pub(super) fn view<'a, P: Points + ?Sized>(&self, points: &'a P, part: usize, side: Side, reversed: bool) -> View<'a, P> {
        let index = self.pair.map_or(part, |pair| usize::from(pair[0] != part));
        View { points, placed: self.parts[index], side, reversed }
    }
}
