//! Lowest terms where all denominators are short: by their primes, without big integers.

use super::denominator::CommonDenominator;
use super::form::Form;
use super::integers::IntegerSlice;
use super::layout::{Layout, push_multinomials};
use super::shape::{Factor, Shape};
use crate::exact::Rational;
use crate::exact::gcd::gcd_u64;
use crate::exact::lowest::{PrimeSet, Word, lowest};
use crate::exact::magnitude::Magnitude;
use crate::exact::width::{Entries, Integer, Ring};

/// Denominators that fit one or two words: `W` without a sign.
pub(crate) struct ShortDenominators<W: Word> {
    constant: W::Signed,
    primes: Primes,
}

/// What is known of the odd primes of the denominators.
enum Primes {
    /// They are among these.
    Only(PrimeSet),
    /// There are others beside these.
    Also(PrimeSet),
}

/// The integers as words, if they are and none of them is negative or zero.
fn positive_words<'a>(integers: IntegerSlice<'a, Rational>) -> Option<&'a [i64]> {
    match integers {
        IntegerSlice::Words(words) if words.iter().all(|&word| word > 0) => Some(words),
        _ => None,
    }
}

impl<W: Word> ShortDenominators<W> {
    /// `None` if a denominator might not fit, or is negative.
    #[inline]
    pub(crate) fn new(layout: &Layout<'_, Rational>, common: &CommonDenominator) -> Option<Self> {
        let CommonDenominator::Word(common) = *common else { return None };
        let (mut scales, divisors) = (positive_words(layout.scales)?, positive_words(layout.divisors)?);
        let (mut primes, mut smooth) = (PrimeSet::EMPTY, true);
        let mut note = |value: i64| {
            if value > 1 {
                let (found, rest) = PrimeSet::of(value.unsigned_abs());
                primes = primes.union(found);
                smooth &= rest == 1;
            }
        };
        let mut bound = Magnitude::from(common);
        let mut constant = <W::Signed as Ring>::from_word(common as i64);
        note(common as i64);
        for &divisor in divisors {
            note(divisor);
            bound = bound.times(Magnitude::from(divisor.unsigned_abs()));
            constant.multiply(&<W::Signed as Ring>::from_word(divisor));
        }
        for &Factor { dimension, degree } in layout.shape.factors.iter() {
            let (own, others) = scales.split_at(scales.len().min(dimension + 1));
            scales = others;
            let mut largest = 1;
            for &scale in own {
                note(scale);
                largest = largest.max(scale.unsigned_abs());
            }
            bound = bound.times(Magnitude::from(largest).power(degree));
            if layout.multinomial {
                // Computing a multinomial number multiplies before it divides.
                bound = bound.times(Magnitude::from(dimension as u64 + 1).power(degree)).times(Magnitude::from(degree as u64 + 1));
            }
        }
        if layout.multinomial {
            for factor in layout.shape.factors.iter() {
                let (found, all) = PrimeSet::up_to(factor.degree);
                primes = primes.union(found);
                smooth &= all;
            }
        }
        if bound.bits() > W::BITS - 1 {
            return None;
        }
        let primes = if smooth { Primes::Only(primes) } else { Primes::Also(primes) };
        Some(Self { constant, primes })
    }

    #[inline]
    pub(crate) fn reduce<R: Integer>(&self, layout: &Layout<'_, Rational>, results: &[R], reduced: &mut Vec<Rational>) {
        let mut denominators = Entries::new();
        push_denominators(layout, &self.constant, &mut denominators);
        for (denominator, results) in denominators.iter().zip(results.chunks_exact(layout.shape.stride)) {
            let denominator = W::of_signed(denominator);
            let (primes, rest) = match self.primes {
                Primes::Only(primes) => (primes, W::one()),
                Primes::Also(primes) => (primes, PrimeSet::of(denominator).1),
            };
            for result in results {
                let value = result.as_i128().unwrap_or_default();
                let magnitude = W::from_u128(value.unsigned_abs());
                if magnitude.is_zero() {
                    reduced.push(Rational::from(0));
                } else {
                    let (numer, denom) = lowest(magnitude, denominator, primes, rest);
                    Rational::push_lowest(reduced, value < 0, numer.into_u128(), denom.into_u128());
                }
            }
        }
    }
}

/// The denominators in the order of the points: the constant, or its multiples
/// by the multinomial numbers, with every vertex scaled like a form's.
fn push_denominators<R: Ring>(layout: &Layout<'_, Rational>, constant: &R, entries: &mut Entries<R>) {
    if layout.multinomial {
        push_multinomials(&layout.shape, constant, entries);
    } else {
        entries.resize(layout.shape.points(), constant.clone());
    }
    if let (&[Factor { dimension: 1, degree }], IntegerSlice::Words(&[first, last])) = (&layout.shape.factors[..], layout.scales) {
        // The two ends of a curve at once.
        let (first, last) = (R::from_word(first), R::from_word(last));
        let (mut first_power, mut last_power) = (R::unit(), R::unit());
        for k in 1..=degree {
            last_power.multiply(&last);
            entries[k].multiply(&last_power);
            first_power.multiply(&first);
            entries[degree - k].multiply(&first_power);
        }
    } else if let IntegerSlice::Words(mut scales) = layout.scales
        && !scales.is_empty()
    {
        let mut form = Form { shape: Shape { stride: 1, ..layout.shape }, entries: &mut entries[..] };
        for (position, factor) in layout.shape.factors.iter().enumerate() {
            let (own, others) = scales.split_at(factor.dimension + 1);
            scales = others;
            for (vertex, &scale) in own.iter().enumerate() {
                form.scale(position, vertex, &R::from_word(scale));
            }
        }
    }
}

/// Brings a result or two over one denominator to lowest terms, where looking
/// for primes would cost more than a gcd. The answer is whether that was possible.
#[inline]
pub(crate) fn reduce_single<R: Integer>(
    layout: &Layout<'_, Rational>,
    common: &CommonDenominator,
    results: &[R],
    reduced: &mut Vec<Rational>,
) -> bool {
    let (CommonDenominator::Word(common), Some(divisors)) = (common, positive_words(layout.divisors)) else { return false };
    if results.len() > 2 || layout.shape.points() != 1 || layout.scales.len() > 0 || layout.multinomial {
        return false;
    }
    results.iter().try_for_each(|result| push_over_words(result.as_i128().unwrap_or_default(), *common, divisors, reduced)).is_some()
}

/// Appends an integer over a product of positive words, in lowest terms; `None` if the denominator is too long.
#[inline]
pub(crate) fn push_over_words(value: i128, mut word: u64, divisors: &[i64], list: &mut Vec<Rational>) -> Option<()> {
    let numer = value.unsigned_abs();
    let product = divisors.iter().try_fold(word, |product, &divisor| product.checked_mul(divisor.unsigned_abs()));
    if let (Ok(numer), Some(denom)) = (u64::try_from(numer), product) {
        let common = gcd_u64(numer % denom, denom);
        Rational::push_lowest(list, value < 0, u128::from(numer / common), u128::from(denom / common));
        return Some(());
    }
    let mut fraction = Fraction { numer, denom: 1 };
    // As many divisors at a time as make a word.
    for &divisor in divisors {
        let divisor = divisor.unsigned_abs();
        match word.checked_mul(divisor) {
            Some(product) => word = product,
            None => fraction.divide(std::mem::replace(&mut word, divisor))?,
        }
    }
    fraction.divide(word)?;
    Rational::push_lowest(list, value < 0, fraction.numer, fraction.denom);
    Some(())
}

/// A fraction in lowest terms.
struct Fraction {
    numer: u128,
    denom: u128,
}

impl Fraction {
    /// Divides by a word, or says that the denominator becomes too long.
    #[inline]
    fn divide(&mut self, word: u64) -> Option<()> {
        let common = if let Ok(numer) = u64::try_from(self.numer) {
            let common = gcd_u64(numer % word, word);
            self.numer = u128::from(numer / common);
            common
        } else {
            let common = gcd_u64((self.numer % u128::from(word)) as u64, word);
            if common != 1 {
                self.numer /= u128::from(common);
            }
            common
        };
        self.denom = self.denom.checked_mul(u128::from(word / common))?;
        Some(())
    }
}
