//! Common denominators on the way in, lowest terms on the way out.

use num_bigint::{BigInt, BigUint};
use num_traits::{One, Signed, Zero};
use smallvec::SmallVec;

use super::layout::Layout;
use super::shape::Shape;
use crate::exact::Rational;
use crate::exact::gcd::{gcd_big, gcd_u64};
use crate::exact::magnitude::Magnitude;
use crate::exact::width::{Integer, powers};

#[inline]
pub(crate) fn magnitude_of_integer(value: &Rational) -> Magnitude {
    match value.as_small() {
        Some((numer, _)) => Magnitude::from(numer.unsigned_abs()),
        None => magnitude_of_big(value),
    }
}

#[cold]
fn magnitude_of_big(value: &Rational) -> Magnitude {
    Magnitude::from_big(value.numer().magnitude())
}

/// The least common denominator of the data.
pub(crate) enum CommonDenominator {
    Word(u64),
    Big(BigInt),
}

impl CommonDenominator {
    pub(crate) fn of<'a>(data: impl IntoIterator<Item = &'a Rational> + Clone) -> Self {
        let mut common = 1u64;
        for value in data.clone() {
            let Some((_, denom)) = value.as_small() else { return Self::of_big(data) };
            if common.is_multiple_of(denom) {
                continue;
            }
            if denom.is_multiple_of(common) {
                common = denom;
            } else {
                match (denom / gcd_u64(common, denom)).checked_mul(common) {
                    Some(multiple) if multiple <= i64::MAX as u64 => common = multiple,
                    _ => return Self::of_big(data),
                }
            }
        }
        Self::Word(common)
    }

    /// The numerators and the largest of them, if everything fits a word.
    pub(crate) fn words(&self, data: &[Rational]) -> Option<(Vec<i64>, u64)> {
        let Self::Word(common) = *self else { return None };
        let mut largest = 0;
        let mut words = Vec::with_capacity(data.len());
        for value in data {
            let (numer, denom) = value.as_small()?;
            let word = if denom == common { numer } else { numer.checked_mul((common / denom) as i64)? };
            largest = largest.max(word.unsigned_abs());
            words.push(word);
        }
        Some((words, largest))
    }

    fn of_big<'a>(data: impl IntoIterator<Item = &'a Rational>) -> Self {
        let mut common = BigUint::one();
        for value in data {
            let denom = value.denom().magnitude().clone();
            if !(&common % &denom).is_zero() {
                let shared = gcd_big(&common, &denom);
                common *= denom / shared;
            }
        }
        Self::Big(BigInt::from(common))
    }

    pub(crate) fn largest_numerator(&self, data: &[Rational]) -> Magnitude {
        match self {
            Self::Word(common) => {
                let mut largest = 0u128;
                for value in data {
                    match value.as_small() {
                        Some((numer, denom)) => {
                            largest = largest.max(u128::from(numer.unsigned_abs()) * u128::from(common / denom));
                        }
                        None => return self.largest_big(data),
                    }
                }
                Magnitude::from(largest)
            }
            Self::Big(_) => self.largest_big(data),
        }
    }

    fn largest_big(&self, data: &[Rational]) -> Magnitude {
        let common = self.to_big();
        data.iter().fold(Magnitude::ZERO, |largest, value| {
            largest.max(Magnitude::from_big((value.numer() * (&common / value.denom())).magnitude()))
        })
    }

    pub(crate) fn to_big(&self) -> BigInt {
        match self {
            Self::Word(common) => BigInt::from(*common),
            Self::Big(common) => common.clone(),
        }
    }

    pub(crate) fn numerator<R: Integer>(&self, value: &Rational) -> R {
        match (self, value.as_small()) {
            (Self::Word(common), Some((numer, denom))) if *common == denom => R::from_i64(numer),
            (Self::Word(common), Some((numer, denom))) => R::from_i128(i128::from(numer) * i128::from(common / denom)),
            _ => R::from_big(&(value.numer() * (self.to_big() / value.denom()))),
        }
    }
}

#[inline]
pub(crate) fn integer<R: Integer>(value: &Rational) -> R {
    match value.as_small() {
        Some((numer, _)) => R::from_i64(numer),
        None => integer_of_big(value),
    }
}

#[cold]
fn integer_of_big<R: Integer>(value: &Rational) -> R {
    R::from_big(&value.numer())
}

/// The degree at every vertex of a shape, factor by factor.
fn vertex_degrees(shape: &Shape) -> impl Iterator<Item = usize> {
    shape.factors.iter().flat_map(|factor| std::iter::repeat_n(factor.degree, factor.dimension + 1))
}

/// Denominators of any size, kept in factors.
///
/// A gcd of the whole numerator with the whole denominator would cost more
/// than the computation before it. The factors are short or powers of short
/// numbers, so most of the work is on remainders of one word.
pub(crate) struct LongDenominators {
    constant: BigInt,
    powers: SmallVec<[SmallVec<[BigInt; 16]>; 3]>,
    multinomials: Vec<BigInt>,
    /// The product of the scales if it fits a word: every prime of their powers divides it.
    radical: Option<u64>,
}

impl LongDenominators {
    pub(crate) fn new(layout: &Layout<Rational>, common: &CommonDenominator) -> Self {
        let scales = || layout.scales.iter().map(integer::<BigInt>);
        let radical = scales().product::<BigInt>().abs();
        Self {
            constant: layout
                .divisors
                .iter()
                .fold(integer::<BigInt>(&layout.constant) * common.to_big(), |constant, divisor| constant * integer::<BigInt>(divisor)),
            powers: scales().zip(vertex_degrees(&layout.shape)).map(|(scale, degree)| powers(&scale, degree)).collect(),
            multinomials: layout.multinomials(),
            radical: u64::try_from(radical).ok(),
        }
    }

    pub(crate) fn reduce<R: Integer>(&self, layout: &Layout<Rational>, results: &mut impl Iterator<Item = R>, reduced: &mut Vec<Rational>) {
        let mut multinomials = self.multinomials.iter();
        let one = BigInt::one();
        layout.shape.for_each(|exponents| {
            let mut scale = one.clone();
            for (powers, &exponent) in self.powers.iter().zip(exponents) {
                if exponent > 0 && !powers[1].is_one() {
                    scale *= &powers[exponent];
                }
            }
            let multinomial = multinomials.next().unwrap_or(&one);
            for result in results.by_ref().take(layout.shape.stride) {
                reduced.push(self.reduce_one(result.into_big(), multinomial.clone(), scale.clone()));
            }
        });
    }

    fn reduce_one(&self, mut numerator: BigInt, mut multinomial: BigInt, mut scale: BigInt) -> Rational {
        if numerator.is_zero() {
            return Rational::from(0);
        }
        let mut constant = self.constant.clone();
        cancel(&mut numerator, &mut multinomial);
        cancel(&mut numerator, &mut constant);
        match self.radical {
            Some(1) => {}
            Some(radical) => cancel_powers(&mut numerator, &mut scale, radical),
            None => cancel(&mut numerator, &mut scale),
        }
        let denominator = multinomial * constant * scale;
        if denominator.is_negative() {
            Rational::from_reduced_big(-numerator, -denominator)
        } else {
            Rational::from_reduced_big(numerator, denominator)
        }
    }
}

/// Divides both by their greatest common divisor.
fn cancel(numerator: &mut BigInt, factor: &mut BigInt) {
    if factor.magnitude().is_one() {
        return;
    }
    let mut digits = factor.magnitude().iter_u64_digits();
    let common = match (digits.next(), digits.next()) {
        (Some(word), None) => BigInt::from(gcd_u64(remainder(numerator, word), word)),
        _ => BigInt::from(gcd_big(&(numerator.magnitude() % factor.magnitude()), factor.magnitude())),
    };
    if !common.is_one() {
        *numerator /= &common;
        *factor /= &common;
    }
}

/// The same where every prime of `factor` divides the word `radical`.
fn cancel_powers(numerator: &mut BigInt, factor: &mut BigInt, radical: u64) {
    // Beyond a few rounds the two share a high power: one full gcd is cheaper.
    for _ in 0..3 {
        let common = gcd_u64(gcd_u64(remainder(numerator, radical), radical), remainder(factor, radical));
        if common <= 1 {
            return;
        }
        *numerator /= common;
        *factor /= common;
    }
    cancel(numerator, factor);
}

/// `|value| mod divisor`
fn remainder(value: &BigInt, divisor: u64) -> u64 {
    u64::try_from(value.magnitude() % divisor).unwrap_or(0)
}
