//! Lowest terms where all denominators are short: by their primes, without big integers.

use super::denominator::CommonDenominator;
use super::form::Form;
use super::layout::Layout;
use super::shape::{Factor, Shape};
use crate::exact::Rational;
use crate::exact::lowest::{PrimeSet, Word, lowest};
use crate::exact::magnitude::Magnitude;
use crate::exact::width::{Integer, Ring};

/// Denominators that fit one or two words: `W` without a sign.
pub(crate) struct ShortDenominators<W: Word> {
    denominators: Form<W::Signed>,
    primes: Primes,
}

/// What is known of the odd primes of the denominators.
enum Primes {
    /// They are among these.
    Only(PrimeSet),
    /// There are others beside these.
    Also(PrimeSet),
    /// Nothing: for a result or two, looking for them would cost more than a gcd.
    Unknown,
}

impl<W: Word> ShortDenominators<W> {
    /// `None` if a denominator might not fit, or is negative.
    pub(crate) fn new(layout: &Layout<Rational>, common: &CommonDenominator) -> Option<Self> {
        let CommonDenominator::Word(common) = *common else { return None };
        let positive = |value: &Rational| value.as_small().filter(|&(numer, _)| numer > 0).map(|(numer, _)| numer);
        // A gcd or two cost less than looking for primes.
        let few = layout.shape.points() * layout.shape.stride < 3;
        let (mut primes, mut smooth) = (PrimeSet::EMPTY, true);
        let mut note = |value: i64| {
            if value > 1 && !few {
                let (found, rest) = PrimeSet::of(value.unsigned_abs());
                primes = primes.union(found);
                smooth &= rest == 1;
            }
        };
        let mut bound = Magnitude::from(common);
        let mut constant = <W::Signed as Ring>::from_word(common as i64);
        note(common as i64);
        for factor in std::iter::once(&layout.constant).chain(&layout.divisors) {
            let factor = positive(factor)?;
            note(factor);
            bound = bound.times(Magnitude::from(factor.unsigned_abs()));
            constant.multiply(&<W::Signed as Ring>::from_word(factor));
        }
        let mut scales = layout.scales.iter();
        for &Factor { dimension, degree } in &layout.shape.factors {
            let mut largest = 1;
            for scale in scales.by_ref().take(dimension + 1) {
                let scale = positive(scale)?;
                note(scale);
                largest = largest.max(scale.unsigned_abs());
            }
            bound = bound.times(Magnitude::from(largest).power(degree));
            if layout.multinomial {
                // Computing a multinomial number multiplies before it divides.
                bound = bound.times(Magnitude::from(dimension as u64 + 1).power(degree)).times(Magnitude::from(degree as u64 + 1));
            }
        }
        if layout.multinomial && !few {
            for factor in &layout.shape.factors {
                let (found, all) = PrimeSet::up_to(factor.degree);
                primes = primes.union(found);
                smooth &= all;
            }
        }
        if bound.bits() > W::BITS - 1 {
            return None;
        }
        let primes = match smooth {
            _ if few => Primes::Unknown,
            true => Primes::Only(primes),
            false => Primes::Also(primes),
        };
        Some(Self { denominators: form_of_denominators(layout, &constant), primes })
    }

    pub(crate) fn reduce<R: Integer>(&self, layout: &Layout<Rational>, results: &mut impl Iterator<Item = R>, reduced: &mut Vec<Rational>) {
        for denominator in &self.denominators.entries {
            let denominator = W::of_signed(denominator);
            let (primes, rest) = match self.primes {
                Primes::Only(primes) => (primes, W::one()),
                Primes::Also(primes) => (primes, PrimeSet::of(denominator).1),
                Primes::Unknown => (PrimeSet::EMPTY, denominator >> denominator.trailing_zeros() as usize),
            };
            for result in results.by_ref().take(layout.shape.stride) {
                let value = result.as_i128().unwrap_or_default();
                let magnitude = W::from_u128(value.unsigned_abs());
                reduced.push(if magnitude.is_zero() {
                    Rational::from(0)
                } else {
                    let (numer, denom) = lowest(magnitude, denominator, primes, rest);
                    Rational::from_lowest(value < 0, numer.into_u128(), denom.into_u128())
                });
            }
        }
    }
}

/// The denominators in the order of the points: the constant, or its multiples
/// by the multinomial numbers, with every vertex scaled like a form's.
fn form_of_denominators<R: Ring>(layout: &Layout<Rational>, constant: &R) -> Form<R> {
    let mut entries = if layout.multinomial { layout.multinomials() } else { vec![R::unit(); layout.shape.points()] };
    if !constant.is_unit() {
        entries.iter_mut().for_each(|entry| entry.multiply(constant));
    }
    let mut form = Form { shape: Shape { stride: 1, ..layout.shape.clone() }, entries };
    let mut scales = layout.scales.iter();
    for (position, factor) in layout.shape.factors.iter().enumerate() {
        for vertex in 0..=factor.dimension {
            let Some(scale) = scales.next() else { return form };
            if let Some(word) = scale.as_word() {
                form.scale(position, vertex, &R::from_word(word));
            }
        }
    }
    form
}
