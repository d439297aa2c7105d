//! The numbers that curves and surfaces are made of, and how a computation on
//! them is run: cleared of denominators, on integers of a width bounded
//! beforehand, and reduced to lowest terms at the end.

use std::fmt;

use num_bigint::BigInt;
use smallvec::SmallVec;

use super::denominator::{CommonDenominator, LongDenominators, integer, magnitude_of_integer};
use super::layout::Layout;
use super::short::ShortDenominators;
use crate::exact::Rational;
use crate::exact::fixed::Fixed;
use crate::exact::magnitude::Magnitude;
use crate::exact::width::{Integer, Ring};
use crate::symbolic::Polynomial;

/// A scalar that curves can have as coefficients, control points and
/// parameters: [`Rational`] numbers, or [`Polynomial`]s in symbolic parameters.
///
/// This trait is sealed: the kernel clears denominators and chooses integer
/// widths itself, which asks for more than ring operations.
pub trait Coefficient: sealed::Compute + PartialEq + fmt::Debug + fmt::Display + From<Rational> + Into<Polynomial> {
    /// The sum.
    #[must_use]
    fn plus(&self, other: &Self) -> Self {
        let mut sum = self.clone();
        sum.add(other);
        sum
    }

    /// The difference.
    #[must_use]
    fn minus(&self, other: &Self) -> Self {
        let mut difference = self.clone();
        difference.subtract(other);
        difference
    }

    /// The product.
    #[must_use]
    fn times(&self, other: &Self) -> Self {
        let mut product = self.clone();
        product.multiply(other);
        product
    }

    /// The quotient by a non-zero number; `None` for zero, and for what
    /// contains a symbolic parameter.
    #[must_use]
    fn over(&self, divisor: &Self) -> Option<Self> {
        Some(self.times(&Self::from(divisor.as_rational()?.recip()?)))
    }

    /// The value if it contains no symbolic parameter.
    fn as_rational(&self) -> Option<Rational>;

    /// The scalar that a polynomial is; `None` if it contains a symbolic
    /// parameter that scalars of this kind cannot.
    fn from_polynomial(value: &Polynomial) -> Option<Self>;

    /// The number of bits of its longest part, times the number of parts.
    fn bit_length(&self) -> u64;
}

pub(crate) mod sealed {
    use super::{Layout, Magnitude, Ring};

    /// What is computed, written once for every ring.
    pub trait Task {
        /// The most that any number on the way exceeds the largest number of
        /// the data by, and at least every parameter to every power it is used in.
        fn growth<R: Ring>(&self, parameters: &[R]) -> Magnitude;
        /// The computation itself, on numerators and integer parameters.
        fn run<R: Ring>(&self, numerators: Vec<R>, parameters: &[R]) -> Vec<R>;
    }

    /// Running tasks; see the module.
    pub trait Compute: Ring {
        /// Numerator and denominator, both without denominators of their own.
        fn fraction(&self) -> (Self, Self);

        /// The numbers over their common denominator: integers, and what they are divided by.
        fn clear(data: &[Self]) -> (Vec<Self>, Self);

        /// Runs a task that is linear in `data`: numerators over the common
        /// denominator of the data go in, with parameters that are integers,
        /// and the results are divided by that denominator and by what
        /// `layouts` says of each.
        fn compute<T: Task>(task: &T, data: &[Self], parameters: &[Self], layouts: &[Layout<Self>]) -> Vec<Self>;
    }
}

pub(crate) use sealed::{Compute, Task};

impl Coefficient for Rational {
    fn over(&self, divisor: &Self) -> Option<Self> {
        self.checked_div(divisor)
    }

    fn as_rational(&self) -> Option<Rational> {
        Some(self.clone())
    }

    fn from_polynomial(value: &Polynomial) -> Option<Self> {
        value.as_rational()
    }

    fn bit_length(&self) -> u64 {
        self.bits()
    }
}

impl Coefficient for Polynomial {
    fn as_rational(&self) -> Option<Rational> {
        Polynomial::as_rational(self)
    }

    fn from_polynomial(value: &Polynomial) -> Option<Self> {
        Some(value.clone())
    }

    fn bit_length(&self) -> u64 {
        self.terms().map(|(_, coefficient)| coefficient.bits()).max().unwrap_or(0).saturating_mul(self.len() as u64)
    }
}

impl Rational {
    /// Numbers times their common denominator.
    pub(crate) fn clear_to_integers(numbers: &[Self]) -> Vec<BigInt> {
        Self::clear(numbers).0.iter().map(Self::numer).collect()
    }

    /// The least common denominator of numbers.
    pub(crate) fn common_denominator(numbers: &[Self]) -> BigInt {
        CommonDenominator::of(numbers).to_big()
    }
}

impl Ring for Rational {
    #[inline]
    fn nothing() -> Self {
        <Self as num_traits::Zero>::zero()
    }
    #[inline]
    fn unit() -> Self {
        <Self as num_traits::One>::one()
    }
    fn from_count(count: usize) -> Self {
        Self::from(count as i64)
    }
    fn is_nothing(&self) -> bool {
        num_traits::Zero::is_zero(self)
    }
    #[inline]
    fn is_unit(&self) -> bool {
        self.as_small() == Some((1, 1))
    }
    #[inline]
    fn add(&mut self, other: &Self) {
        *self += other;
    }
    #[inline]
    fn subtract(&mut self, other: &Self) {
        *self -= other;
    }
    #[inline]
    fn multiply(&mut self, other: &Self) {
        *self *= other;
    }
    fn add_product(&mut self, a: &Self, b: &Self) {
        *self += a * b;
    }
    fn divide_exactly(&mut self, other: &Self) {
        *self /= other;
    }
    fn is_odd(&self) -> bool {
        match self.as_small() {
            Some((numer, denom)) => denom == 1 && numer & 1 == 1,
            None => self.is_integer() && self.numer().bit(0),
        }
    }
    #[inline]
    fn as_word(&self) -> Option<i64> {
        self.as_small().and_then(|(numer, denom)| (denom == 1).then_some(numer))
    }
    #[inline]
    fn from_word(value: i64) -> Self {
        Self::from(value)
    }
    #[inline]
    fn magnitude(&self) -> Magnitude {
        magnitude_of_integer(self)
    }
}

impl Ring for Polynomial {
    fn nothing() -> Self {
        Self::default()
    }
    fn unit() -> Self {
        Self::from(Rational::from(1))
    }
    fn from_count(count: usize) -> Self {
        Self::from(Rational::from(count as i64))
    }
    fn is_nothing(&self) -> bool {
        self.is_empty()
    }
    fn is_unit(&self) -> bool {
        Polynomial::as_rational(self).is_some_and(|value| value.is_unit())
    }
    fn add(&mut self, other: &Self) {
        *self += other;
    }
    fn subtract(&mut self, other: &Self) {
        *self -= other;
    }
    fn multiply(&mut self, other: &Self) {
        *self *= other;
    }
    fn add_product(&mut self, a: &Self, b: &Self) {
        *self += &(a * b);
    }
    fn divide_exactly(&mut self, other: &Self) {
        // The nouns take care that only numbers are divided by.
        if let Some(quotient) = self.over(other) {
            *self = quotient;
        }
    }
    fn is_odd(&self) -> bool {
        Polynomial::as_rational(self).is_some_and(|value| Ring::is_odd(&value))
    }
    fn as_word(&self) -> Option<i64> {
        Polynomial::as_rational(self).and_then(|value| value.as_word())
    }
    fn from_word(value: i64) -> Self {
        Self::from(Rational::from(value))
    }
    fn magnitude(&self) -> Magnitude {
        Magnitude::ONE
    }
}

impl Compute for Rational {
    #[inline]
    fn fraction(&self) -> (Self, Self) {
        match self.as_small() {
            Some((numer, denom)) => (Self::from(numer), Self::from(denom as i64)),
            None => (Self::from(self.numer()), Self::from(self.denom())),
        }
    }

    fn clear(data: &[Self]) -> (Vec<Self>, Self) {
        let common = Self::from(CommonDenominator::of(data).to_big());
        (data.iter().map(|value| value * &common).collect(), common)
    }

    fn compute<T: Task>(task: &T, data: &[Self], parameters: &[Self], layouts: &[Layout<Self>]) -> Vec<Self> {
        let common = CommonDenominator::of(data);
        let words = common.words(data);
        let largest = match &words {
            Some((_, largest)) => Magnitude::from(*largest),
            None => common.largest_numerator(data),
        };
        let bound = task.growth(parameters).times(largest.max(Magnitude::ONE));
        let call = Call { task, data, words: words.map(|(words, _)| words), parameters, layouts, common: &common };
        match bound.bits() {
            0..=63 => call.run::<i64>(),
            64..=127 => call.run::<i128>(),
            128..=191 => call.run::<Fixed<3>>(),
            192..=255 => call.run::<Fixed<4>>(),
            256..=383 => call.run::<Fixed<6>>(),
            384..=511 => call.run::<Fixed<8>>(),
            _ => call.run::<BigInt>(),
        }
    }
}

/// Polynomials are a ring with rational constants, so nothing needs clearing.
impl Compute for Polynomial {
    fn fraction(&self) -> (Self, Self) {
        (self.clone(), Self::unit())
    }

    fn clear(data: &[Self]) -> (Vec<Self>, Self) {
        (data.to_vec(), Self::unit())
    }

    fn compute<T: Task>(task: &T, data: &[Self], parameters: &[Self], layouts: &[Layout<Self>]) -> Vec<Self> {
        let mut results = task.run(data.to_vec(), parameters).into_iter();
        let mut reduced = Vec::new();
        for layout in layouts {
            let mut multinomials = layout.multinomials::<BigInt>().into_iter();
            layout.shape.for_each(|exponents| {
                let mut divisor = layout.constant.clone();
                layout.divisors.iter().for_each(|factor| divisor.multiply(factor));
                for (scale, &exponent) in layout.scales.iter().zip(exponents) {
                    (0..exponent).for_each(|_| divisor.multiply(scale));
                }
                if let Some(multinomial) = multinomials.next() {
                    divisor.multiply(&Self::from(Rational::from(multinomial)));
                }
                for result in results.by_ref().take(layout.shape.stride) {
                    // The nouns refuse symbolic divisors by name beforehand.
                    reduced.push(result.over(&divisor).unwrap_or(result));
                }
            });
        }
        reduced
    }
}

/// A task with its data cleared, whose width is about to be chosen.
struct Call<'a, T> {
    task: &'a T,
    data: &'a [Rational],
    /// The numerators, if all of them fit a word.
    words: Option<Vec<i64>>,
    parameters: &'a [Rational],
    layouts: &'a [Layout<Rational>],
    common: &'a CommonDenominator,
}

impl<T: Task> Call<'_, T> {
    fn run<R: Integer>(self) -> Vec<Rational> {
        let numerators: Vec<R> = match self.words {
            Some(words) => words.into_iter().map(R::from_i64).collect(),
            None => self.data.iter().map(|value| self.common.numerator(value)).collect(),
        };
        let mut parameters: SmallVec<[R; 32]> = SmallVec::new();
        self.parameters.iter().for_each(|parameter| parameters.push(integer(parameter)));
        let results = self.task.run(numerators, &parameters);
        let mut reduced = Vec::with_capacity(results.len());
        let mut results = results.into_iter();
        for layout in self.layouts {
            reduce(layout, self.common, &mut results, &mut reduced);
        }
        reduced
    }
}

/// Brings as many results as the layout has entries to lowest terms.
fn reduce<R: Integer>(
    layout: &Layout<Rational>,
    common: &CommonDenominator,
    results: &mut impl Iterator<Item = R>,
    reduced: &mut Vec<Rational>,
) {
    if R::WORDS == 1
        && let Some(short) = ShortDenominators::<u64>::new(layout, common)
    {
        return short.reduce(layout, results, reduced);
    }
    if (1..=2).contains(&R::WORDS)
        && let Some(short) = ShortDenominators::<u128>::new(layout, common)
    {
        return short.reduce(layout, results, reduced);
    }
    LongDenominators::new(layout, common).reduce(layout, results, reduced);
}
