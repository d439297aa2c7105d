//! Common denominators on the way in, lowest terms on the way out.

use num_bigint::{BigInt, BigUint};
use num_traits::{One, Signed, Zero};
use smallvec::SmallVec;

use super::integers::IntegerSlice;
use super::layout::Layout;
use super::shape::Shape;
use crate::exact::Rational;
use crate::exact::gcd::{gcd_big, gcd_u64, remainder_by_word};
use crate::exact::magnitude::Magnitude;
use crate::exact::width::{Entries, Integer, powers};

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

/// The least common denominator of the numbers so far, where all of it is words.
#[derive(Default)]
pub(crate) struct RunningDenominator {
    /// Zero as long as there was no number.
    common: u64,
    /// The largest numerator over it.
    largest: u64,
}

impl RunningDenominator {
    #[inline]
    pub(crate) fn common(&self) -> u64 {
        self.common
    }

    #[inline]
    pub(crate) fn largest(&self) -> u64 {
        self.largest
    }

    /// The numerator of one more number. If that changes the common
    /// denominator, what came before must be multiplied by a number that
    /// `missing` is told. `None` if something is longer than a word.
    #[inline]
    pub(crate) fn numerator(&mut self, value: &Rational, missing: impl FnOnce(i64)) -> Option<i64> {
        let (numer, denom) = value.as_small()?;
        let mut share = 1;
        if denom > self.common {
            match denom.checked_div(self.common) {
                None => self.common = denom,
                Some(mut factor) => {
                    if factor * self.common != denom {
                        (factor, share) = self.cofactors(denom);
                    }
                    self.multiply(factor)?;
                    missing(factor as i64);
                }
            }
        } else if denom < self.common {
            share = self.common / denom;
            if share * denom != self.common {
                let factor;
                (factor, share) = self.cofactors(denom);
                self.multiply(factor)?;
                missing(factor as i64);
            }
        }
        let word = numer.checked_mul(share as i64)?;
        self.largest = self.largest.max(word.unsigned_abs());
        Some(word)
    }

    /// The factors of both denominators that the other one lacks, the new one's first.
    #[inline]
    fn cofactors(&self, denom: u64) -> (u64, u64) {
        let shared = gcd_u64(self.common, denom);
        (denom / shared, self.common / shared)
    }

    /// Multiplies the common denominator, and with it what is over it.
    #[inline]
    fn multiply(&mut self, factor: u64) -> Option<()> {
        self.common = self.common.checked_mul(factor).filter(|&common| common <= i64::MAX as u64)?;
        self.largest = self.largest.checked_mul(factor).filter(|&largest| largest <= i64::MAX as u64)?;
        Some(())
    }
}

/// The least common denominator of the data.
pub(crate) enum CommonDenominator {
    Word(u64),
    Big(BigInt),
}

impl CommonDenominator {
    /// The least common denominator, the numerators over it, and the largest of
    /// them; `None` if they are not all words.
    #[inline]
    pub(crate) fn of_words<'a>(data: impl Iterator<Item = &'a Rational> + Clone, words: &mut Entries<i64>) -> Option<(u64, u64)> {
        let mut denominator = RunningDenominator::default();
        words.extend(data.clone().map(|_| 0));
        let words = &mut words[..];
        for (place, value) in data.enumerate() {
            words[place] = denominator.numerator(value, |missing| words[..place].iter_mut().for_each(|word| *word *= missing))?;
        }
        Some((denominator.common, denominator.largest))
    }

    /// The least common denominator.
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

fn big_integers(integers: IntegerSlice<'_, Rational>) -> Vec<BigInt> {
    match integers {
        IntegerSlice::Words(words) => words.iter().map(|&word| BigInt::from(word)).collect(),
        IntegerSlice::Any(list) => list.iter().map(integer).collect(),
    }
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
    multinomials: Entries<BigInt>,
    /// The product of the scales if it fits a word: every prime of their powers divides it.
    radical: Option<u64>,
}

impl LongDenominators {
    pub(crate) fn new(layout: &Layout<'_, Rational>, common: &CommonDenominator) -> Self {
        let scales = big_integers(layout.scales);
        let radical = scales.iter().product::<BigInt>().abs();
        Self {
            constant: common.to_big() * big_integers(layout.divisors).iter().product::<BigInt>(),
            powers: scales.iter().zip(vertex_degrees(&layout.shape)).map(|(scale, degree)| powers(scale, degree)).collect(),
            multinomials: layout.multinomials(),
            radical: u64::try_from(radical).ok(),
        }
    }

    pub(crate) fn reduce<R: Integer>(&self, layout: &Layout<'_, Rational>, results: &mut [R], reduced: &mut Vec<Rational>) {
        let mut results = results.iter_mut().map(|result| std::mem::replace(result, R::nothing()));
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
    remainder_by_word(value.iter_u64_digits(), divisor)
}
