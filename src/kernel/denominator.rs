//! Common denominators on the way in, lowest terms on the way out.

use num_bigint::{BigInt, BigUint};
use num_traits::{One, Signed, Zero};
use smallvec::SmallVec;

use super::layout::Layout;
use super::shape::Shape;
use crate::exact::Rational;
use crate::exact::gcd::{gcd_big, gcd_u64};
use crate::exact::magnitude::Magnitude;
use crate::exact::width::{Integer, Ring};

pub(crate) fn magnitude_of_integer(value: &Rational) -> Magnitude {
    match value.as_small() {
        Some((numer, _)) => Magnitude::from(numer.unsigned_abs()),
        None => Magnitude::from_big(value.numer().magnitude()),
    }
}

/// The least common denominator of the data.
pub(crate) enum CommonDenominator {
    Word(u64),
    Big(BigInt),
}

impl CommonDenominator {
    pub(crate) fn of(data: &[Rational]) -> Self {
        let mut common = 1u64;
        for value in data {
            let Some((_, denom)) = value.as_small() else { return Self::of_big(data) };
            if common % denom != 0 {
                match (denom / gcd_u64(common, denom)).checked_mul(common) {
                    Some(multiple) if multiple <= i64::MAX as u64 => common = multiple,
                    _ => return Self::of_big(data),
                }
            }
        }
        Self::Word(common)
    }

    fn of_big(data: &[Rational]) -> Self {
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

pub(crate) fn integer<R: Integer>(value: &Rational) -> R {
    match value.as_small() {
        Some((numer, _)) => R::from_i64(numer),
        None => R::from_big(&value.numer()),
    }
}

/// The powers `1, base, …, base^degree`.
fn powers<R: Integer>(base: R, degree: usize) -> SmallVec<[R; 16]> {
    let mut powers = SmallVec::with_capacity(degree + 1);
    let mut power = R::unit();
    for _ in 0..degree {
        powers.push(power.clone());
        power.multiply(&base);
    }
    powers.push(power);
    powers
}

/// The degree at every vertex of a shape, factor by factor.
fn vertex_degrees(shape: &Shape) -> impl Iterator<Item = usize> {
    shape.factors.iter().flat_map(|factor| std::iter::repeat_n(factor.degree, factor.dimension + 1))
}

/// Denominators that fit two words, whatever the entry.
pub(crate) struct ShortDenominators {
    constant: i128,
    powers: SmallVec<[SmallVec<[i128; 16]>; 3]>,
    multinomials: Vec<i128>,
}

impl ShortDenominators {
    pub(crate) fn new(layout: &Layout<Rational>, common: &CommonDenominator) -> Option<Self> {
        let CommonDenominator::Word(common) = common else { return None };
        let mut bound = magnitude_of_integer(&layout.constant).times(Magnitude::from(*common));
        for factor in &layout.shape.factors {
            if layout.multinomial {
                bound = bound.times(Magnitude::from(factor.dimension as u64 + 1).power(factor.degree));
                // Computing a multinomial number multiplies before it divides.
                bound = bound.times(Magnitude::from(factor.degree as u64 + 1));
            }
        }
        for (scale, degree) in layout.scales.iter().zip(vertex_degrees(&layout.shape)) {
            bound = bound.times(magnitude_of_integer(scale).max(Magnitude::ONE).power(degree));
        }
        if bound.bits() > 126 {
            return None;
        }
        let scale_powers = |(scale, degree): (&Rational, usize)| powers(integer::<i128>(scale), degree);
        Some(Self {
            constant: integer::<i128>(&layout.constant) * i128::from(*common),
            powers: layout.scales.iter().zip(vertex_degrees(&layout.shape)).map(scale_powers).collect(),
            multinomials: layout.multinomials(),
        })
    }

    pub(crate) fn reduce<R: Integer>(&self, layout: &Layout<Rational>, results: &mut impl Iterator<Item = R>, reduced: &mut Vec<Rational>) {
        let plain = layout.scales.iter().all(Ring::is_unit);
        let mut multinomials = self.multinomials.iter();
        layout.shape.for_each(|exponents| {
            let mut denominator = self.constant;
            if !plain {
                for (powers, &exponent) in self.powers.iter().zip(exponents) {
                    denominator *= powers[exponent];
                }
            }
            denominator *= multinomials.next().copied().unwrap_or(1);
            let magnitude = denominator.unsigned_abs();
            for result in results.by_ref().take(layout.shape.stride) {
                reduced.push(match result.as_i128() {
                    Some(numerator) => Rational::from_i128(if denominator < 0 { -numerator } else { numerator }, magnitude),
                    None => Rational::from_big(result.into_big(), BigInt::from(denominator)),
                });
            }
        });
    }
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
            constant: integer::<BigInt>(&layout.constant) * common.to_big(),
            powers: scales().zip(vertex_degrees(&layout.shape)).map(|(scale, degree)| powers(scale, degree)).collect(),
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
