//! The numbers that curves and surfaces are made of, and how a computation on
//! them is run: cleared of denominators, on integers of a width bounded
//! beforehand, and reduced to lowest terms at the end.

use std::fmt;

use num_bigint::BigInt;

use super::combination::Combination;
use super::denominator::{CommonDenominator, LongDenominators, integer, magnitude_of_integer};
use super::integers::IntegerSlice;
use super::layout::Layout;
use super::short::{ShortDenominators, reduce_single};
use crate::exact::Rational;
use crate::exact::fixed::Fixed;
use crate::exact::magnitude::Magnitude;
use crate::exact::width::{Entries, Integer, Ring};
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
    use super::{Combination, Entries, IntegerSlice, Layout, Magnitude, Ring};

    /// What is computed, written once for every ring.
    pub trait Task {
        /// The most that any number on the way exceeds the largest number of
        /// the data by, and at least every parameter to every power it is used in.
        fn growth<R: Ring>(&self, parameters: &[R]) -> Magnitude;
        /// The computation itself, with integer parameters, in place: numerators become results.
        fn run<R: Ring>(&self, entries: &mut Entries<R>, parameters: &[R]);
    }

    /// Running tasks; see the module.
    pub trait Compute: Ring {
        /// Numerator and denominator, both without denominators of their own.
        fn fraction(&self) -> (Self, Self);

        /// The same as words, if they are.
        fn short_fraction(&self) -> Option<(i64, i64)>;

        /// The numbers over their common denominator: integers, and what they are divided by.
        fn clear(data: &[Self]) -> (Vec<Self>, Self);

        /// Runs a task that is linear in `data`: numerators over the common
        /// denominator of the data go in, with parameters that are integers,
        /// and the results are divided by that denominator and by what
        /// `layouts` says of each.
        fn compute<T: Task>(task: &T, data: &[Self], parameters: IntegerSlice<'_, Self>, layouts: &[Layout<'_, Self>]) -> Vec<Self>;

        /// The point that is a combination of points; `None` if that is not quickly done.
        fn combine<I: Iterator<Item: Into<i128>> + Clone>(_: Combination<'_, I>, _data: &[Self], _stride: usize) -> Option<Vec<Self>> {
            None
        }
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

    #[inline]
    fn short_fraction(&self) -> Option<(i64, i64)> {
        self.as_small().map(|(numer, denom)| (numer, denom as i64))
    }

    fn clear(data: &[Self]) -> (Vec<Self>, Self) {
        let common = Self::from(CommonDenominator::of(data).to_big());
        (data.iter().map(|value| value * &common).collect(), common)
    }

    #[inline]
    fn compute<T: Task>(task: &T, data: &[Self], parameters: IntegerSlice<'_, Self>, layouts: &[Layout<'_, Self>]) -> Vec<Self> {
        let mut words = Entries::new();
        let short = CommonDenominator::of_words(data.iter(), &mut words);
        let (common, largest) = match short {
            Some((common, largest)) => (CommonDenominator::Word(common), Magnitude::from(largest)),
            None => {
                let common = CommonDenominator::of(data);
                let largest = common.largest_numerator(data);
                (common, largest)
            }
        };
        let growth = match parameters {
            IntegerSlice::Words(words) => task.growth(words),
            IntegerSlice::Any(list) => task.growth(list),
        };
        let call = Call { task, data, words: short.map(|_| &mut words), parameters, layouts, common: &common };
        match growth.times(largest.max(Magnitude::ONE)).bits() {
            0..=63 => call.run::<i64>(),
            64..=127 => call.run::<i128>(),
            128..=191 => call.run::<Fixed<3>>(),
            192..=255 => call.run::<Fixed<4>>(),
            256..=383 => call.run::<Fixed<6>>(),
            384..=511 => call.run::<Fixed<8>>(),
            512..=767 => call.run::<Fixed<12>>(),
            768..=1023 => call.run::<Fixed<16>>(),
            _ => call.run::<BigInt>(),
        }
    }

    #[inline]
    fn combine<I: Iterator<Item: Into<i128>> + Clone>(combination: Combination<'_, I>, data: &[Self], stride: usize) -> Option<Vec<Self>> {
        combination.of(data, stride)
    }
}

/// Polynomials are a ring with rational constants, so nothing needs clearing.
impl Compute for Polynomial {
    fn fraction(&self) -> (Self, Self) {
        (self.clone(), Self::unit())
    }

    fn short_fraction(&self) -> Option<(i64, i64)> {
        None
    }

    fn clear(data: &[Self]) -> (Vec<Self>, Self) {
        (data.to_vec(), Self::unit())
    }

    fn compute<T: Task>(task: &T, data: &[Self], parameters: IntegerSlice<'_, Self>, layouts: &[Layout<'_, Self>]) -> Vec<Self> {
        let mut results = Entries::from(data);
        task.run(&mut results, &parameters.to_elements());
        let mut results = results.into_iter();
        let mut reduced = Vec::new();
        for layout in layouts {
            let mut multinomials = layout.multinomials::<BigInt>().into_iter();
            let (divisors, scales) = (layout.divisors.to_elements(), layout.scales.to_elements());
            layout.shape.for_each(|exponents| {
                let mut divisor = Self::unit();
                divisors.iter().for_each(|factor| divisor.multiply(factor));
                for (scale, &exponent) in scales.iter().zip(exponents) {
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
    words: Option<&'a mut Entries<i64>>,
    parameters: IntegerSlice<'a, Rational>,
    layouts: &'a [Layout<'a, Rational>],
    common: &'a CommonDenominator,
}

impl<T: Task> Call<'_, T> {
    /// One function for each width: together they would share one large stack frame.
    #[inline(never)]
    fn run<R: Integer>(self) -> Vec<Rational> {
        let (mut entries, mut parameters) = (Entries::new(), Entries::new());
        let parameters = match self.parameters {
            IntegerSlice::Words(words) => R::of_words(words, &mut parameters),
            IntegerSlice::Any(list) => {
                parameters.extend(list.iter().map(integer));
                &parameters
            }
        };
        let entries = match self.words {
            Some(words) => R::of_words_mut(words, &mut entries),
            None => {
                entries.extend(self.data.iter().map(|value| self.common.numerator(value)));
                &mut entries
            }
        };
        self.task.run(entries, parameters);
        let mut reduced = Vec::with_capacity(entries.len());
        let mut rest = &mut entries[..];
        for layout in self.layouts {
            let (results, others) = rest.split_at_mut(layout.shape.points() * layout.shape.stride);
            rest = others;
            reduce(layout, self.common, results, &mut reduced);
        }
        reduced
    }
}

/// Brings the results to lowest terms. (Long ones are taken out.)
fn reduce<R: Integer>(layout: &Layout<'_, Rational>, common: &CommonDenominator, results: &mut [R], reduced: &mut Vec<Rational>) {
    if (1..=2).contains(&R::WORDS) {
        let count = reduced.len();
        if reduce_single(layout, common, results, reduced) {
            return;
        }
        reduced.truncate(count);
        if R::WORDS == 1
            && let Some(short) = ShortDenominators::<u64>::new(layout, common)
        {
            return short.reduce(layout, results, reduced);
        }
        if let Some(short) = ShortDenominators::<u128>::new(layout, common) {
            return short.reduce(layout, results, reduced);
        }
    }
    LongDenominators::new(layout, common).reduce(layout, results, reduced);
}

#[cfg(test)]
mod tests {
    use super::super::integers::Integers;
    use super::super::layout::multinomials;
    use super::super::shape::Shape;
    use super::*;
    use proptest::prelude::*;

    /// Words of every length, and those at both ends.
    fn word() -> impl Strategy<Value = i64> {
        prop_oneof![
            2 => -20i64..21,
            4 => (any::<i64>(), 0u32..64).prop_map(|(value, shift)| value >> shift),
            1 => (0i64..3).prop_map(|k| i64::MAX - k),
            1 => (0i64..3).prop_map(|k| i64::MIN + k),
        ]
    }

    fn scale() -> impl Strategy<Value = i64> {
        prop_oneof![3 => Just(1i64), 4 => 1i64..40, 2 => 1i64..1 << 33, 1 => word().prop_map(|value| value.saturating_abs().max(1))]
    }

    /// The definition: every result over its whole denominator.
    fn plainly(layout: &Layout<'_, Rational>, common: &BigInt, results: &[BigInt]) -> Vec<Rational> {
        let (divisors, scales) = (layout.divisors.to_elements(), layout.scales.to_elements());
        let multinomials = multinomials::<BigInt>(&layout.shape);
        let mut points = results.chunks_exact(layout.shape.stride).zip(&multinomials);
        let mut all = Vec::new();
        layout.shape.for_each(|exponents| {
            let (point, multinomial) = points.next().expect("a point for every entry");
            let mut denominator = common * divisors.iter().map(Rational::numer).product::<BigInt>();
            for (scale, &exponent) in scales.iter().zip(exponents) {
                denominator *= scale.numer().pow(exponent as u32);
            }
            if layout.multinomial {
                denominator *= multinomial;
            }
            all.extend(point.iter().map(|x| Rational::from_big(x.clone(), denominator.clone())));
        });
        all
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 1024, ..ProptestConfig::default() })]

        #[test]
        fn numerators_are_those_over_the_common_denominator(parts in prop::collection::vec((word(), scale()), 1..8)) {
            let data: Vec<Rational> = parts.iter().map(|&(numer, denom)| Rational::new(numer, denom)).collect();
            let mut words = Entries::new();
            let found = CommonDenominator::of_words(data.iter(), &mut words);
            let common = CommonDenominator::of(&data);
            let numerators: Vec<BigInt> = data.iter().map(|value| common.numerator(value)).collect();
            let largest = numerators.iter().map(|x| x.magnitude().clone()).max().expect("a number");
            match found {
                Some((denominator, bound)) => {
                    prop_assert_eq!(BigInt::from(denominator), common.to_big());
                    prop_assert_eq!(num_bigint::BigUint::from(bound), largest);
                    prop_assert_eq!(words.iter().map(|&word| BigInt::from(word)).collect::<Vec<_>>(), numerators);
                }
                // The only other reason: what came before, brought over, was too long already.
                None => prop_assert!(largest.bits() > 62 || common.to_big().bits() > 63),
            }
        }

        #[test]
        fn every_route_to_lowest_terms_is_the_same(
            values in prop::collection::vec((any::<i128>(), 0u32..128), 12),
            common in scale(),
            divisors in prop::collection::vec(scale(), 0..5),
            scales in prop::collection::vec(scale(), 3),
            shape in prop_oneof![Just(Shape::curve(0, 1)), Just(Shape::curve(0, 2)), Just(Shape::curve(3, 3)), Just(Shape::triangle(2, 2)), Just(Shape::rectangle(1, 2, 2))],
            kind in 0usize..3,
        ) {
            let count = shape.points() * shape.stride;
            let scales: Integers<Rational> = scales.into_iter().chain([1]).map(Rational::from).take(shape.factors.iter().map(|f| f.dimension + 1).sum()).collect();
            let divisors: Integers<Rational> = divisors.into_iter().map(Rational::from).collect();
            let layout = match kind {
                0 => Layout::constant(shape, divisors.as_slice()),
                1 => Layout { divisors: divisors.as_slice(), ..Layout::net(shape, scales.as_slice()) },
                _ => Layout { divisors: divisors.as_slice(), ..Layout::form(shape, scales.as_slice()) },
            };
            let denominator = CommonDenominator::Word(common.unsigned_abs());
            let values: Vec<i128> = values.iter().map(|&(value, shift)| value >> shift).take(count).collect();
            let long: Vec<BigInt> = values.iter().map(|&value| BigInt::from(value)).collect();
            let expected = plainly(&layout, &BigInt::from(common), &long);
            let mut reduced = Vec::new();
            reduce(&layout, &denominator, &mut values.clone(), &mut reduced);
            prop_assert_eq!(&reduced, &expected);
            reduced.clear();
            reduce(&layout, &denominator, &mut long.clone(), &mut reduced);
            prop_assert_eq!(&reduced, &expected);
            reduced.clear();
            let words: Vec<i64> = values.iter().map(|&value| value as i64).collect();
            let long: Vec<BigInt> = words.iter().map(|&value| BigInt::from(value)).collect();
            reduce(&layout, &denominator, &mut words.clone(), &mut reduced);
            prop_assert_eq!(reduced, plainly(&layout, &BigInt::from(common), &long));
        }
    }
}
