//! Polar values where every number is short: one pass over the arguments, one over the data.
//!
//! The polar value of an equation is a combination of its coefficients, whose
//! weights come from the arguments alone. At low degrees finding a common
//! denominator, choosing a width and bringing the data to it would take more
//! time than these few products.

use smallvec::SmallVec;

use super::coefficient::Compute;
use super::denominator::RunningDenominator;
use super::short::push_over_words;
use crate::exact::Rational;
use crate::exact::width::{Entries, Ring};

/// The most forms in a [`ShortProduct`]: more of them rarely fit words.
const FORMS: usize = 15;

/// A product of linear forms `w + t X` with coefficients of one word.
pub(crate) struct ShortProduct {
    /// The coefficients, then zeros.
    coefficients: [i64; FORMS + 1],
    /// The number of forms.
    degree: usize,
    /// Not less than the sum of the absolute coefficients.
    bound: u64,
}

impl Default for ShortProduct {
    #[inline]
    fn default() -> Self {
        let mut coefficients = [0; FORMS + 1];
        coefficients[0] = 1;
        Self { coefficients, degree: 0, bound: 1 }
    }
}

impl ShortProduct {
    #[inline]
    fn coefficients(&self) -> &[i64] {
        &self.coefficients[..=self.degree]
    }

    /// Takes in a form if the product certainly fits words.
    #[inline]
    pub(crate) fn take(&mut self, [w, t]: [i64; 2]) -> bool {
        let sum = w.unsigned_abs().checked_add(t.unsigned_abs());
        let Some(bound) = sum.and_then(|sum| sum.checked_mul(self.bound)).filter(|&bound| bound <= i64::MAX as u64) else { return false };
        let Some(coefficients) = self.coefficients.get_mut(..self.degree + 2) else { return false };
        (self.degree, self.bound) = (self.degree + 1, bound);
        let mut before = 0;
        for coefficient in coefficients {
            (*coefficient, before) = (*coefficient * w + before * t, *coefficient);
        }
        true
    }

    /// Multiplies a longer product by this one, which becomes 1.
    pub(crate) fn multiply_into<R: Ring>(&mut self, product: &mut Entries<R>) {
        let factor: Entries<R> = self.coefficients().iter().map(|&word| R::from_word(word)).collect();
        if product.len() == 1 && product[0].is_unit() {
            *product = factor;
        } else {
            multiply_by(product, &factor);
        }
        *self = Self::default();
    }
}

/// The product of two polynomials, in place of the first one.
fn multiply_by<R: Ring>(product: &mut Entries<R>, factor: &[R]) {
    let count = product.len();
    product.extend(factor[1..].iter().map(|_| R::nothing()));
    // From the top down: what is still needed lies below.
    for place in (0..product.len()).rev() {
        let skipped = place.saturating_sub(count - 1);
        let mut sum = R::nothing();
        for (entry, coefficient) in product[..=place - skipped].iter().rev().zip(&factor[skipped..]) {
            sum.add_product(entry, coefficient);
        }
        product[place] = sum;
    }
}

/// The arguments of a polar value, multiplied out as they come: numbers `t / w`
/// as the linear forms `w + t X`.
#[derive(Default)]
pub(crate) struct ShortArguments {
    /// Those that the product is still of words with.
    last: ShortProduct,
    /// Those before, and what `bound` is to a [`ShortProduct`].
    before: Option<(Entries<i128>, u128)>,
    /// The numbers `w`, as many at a time as make a word.
    scales: SmallVec<[i64; 4]>,
}

impl ShortArguments {
    /// Takes in the number `t / w` with positive `w`; `None` if the product may become too long.
    #[inline]
    pub(crate) fn take(&mut self, (t, w): (i64, i64)) -> Option<()> {
        if self.last.take([w, t]) {
            return Some(());
        }
        self.carry()?;
        self.last.take([w, t]).then_some(())
    }

    /// Puts the last ones among those before.
    #[inline(never)]
    fn carry(&mut self) -> Option<()> {
        let (product, bound) = self.before.get_or_insert_with(|| (Entries::from_elem(1, 1), 1));
        *bound = bound.checked_mul(u128::from(self.last.bound)).filter(|&bound| bound <= i128::MAX as u128)?;
        self.scales.push(self.last.coefficients[0]);
        self.last.multiply_into(product);
        Some(())
    }

    /// The sum of the data times the elementary symmetric functions of the
    /// arguments, each over its binomial number: `multiples` are the least
    /// common multiple of these numbers divided by each of them. `None` if a number is too long.
    #[inline]
    pub(crate) fn combine<C: Compute>(&mut self, multiples: &[i64], data: &[C], stride: usize) -> Option<Vec<C>> {
        // The first coefficient is the product of all `w`, the first multiple the common one.
        if self.before.is_none()
            && let Some(bound) = self.last.bound.checked_mul(multiples[0].unsigned_abs()).filter(|&bound| bound <= i64::MAX as u64)
        {
            let weights = self.last.coefficients().iter().zip(multiples).map(|(symmetric, multiple)| symmetric * multiple);
            let divisor = self.last.coefficients[0] * multiples[0];
            return C::combine(Combination { weights, bound: u128::from(bound), divisors: &[divisor] }, data, stride);
        }
        self.carry()?;
        self.scales.push(multiples[0]);
        let (symmetric, bound) = self.before.as_ref()?;
        let bound = bound.checked_mul(multiples[0] as u128)?;
        let weights = symmetric.iter().zip(multiples).map(|(symmetric, &multiple)| symmetric.wrapping_mul(i128::from(multiple)));
        C::combine(Combination { weights, bound, divisors: &self.scales }, data, stride)
    }
}

/// A sum of points times short weights, divided by some words.
pub struct Combination<'a, I> {
    weights: I,
    /// Not less than the sum of the absolute weights.
    bound: u128,
    divisors: &'a [i64],
}

impl<W: Into<i128>, I: Iterator<Item = W> + Clone> Combination<'_, I> {
    /// The combination of points given by their coordinates; `None` if a number is too long.
    #[inline]
    pub(crate) fn of(self, data: &[Rational], stride: usize) -> Option<Vec<Rational>> {
        let mut point = Vec::with_capacity(stride);
        for coordinate in 0..stride {
            let mut denominator = RunningDenominator::default();
            let mut sum = 0i128;
            // Whatever wraps on the way is right in the end, if the sum fits.
            let mut place = coordinate;
            for weight in self.weights.clone() {
                let word = denominator.numerator(data.get(place)?, |missing| sum = sum.wrapping_mul(i128::from(missing)))?;
                sum = sum.wrapping_add(i128::from(word).wrapping_mul(weight.into()));
                place += stride;
            }
            self.bound.checked_mul(u128::from(denominator.largest())).filter(|&largest| largest <= i128::MAX as u128)?;
            push_over_words(sum, denominator.common(), self.divisors, &mut point)?;
        }
        Some(point)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_bigint::BigInt;
    use num_integer::lcm;
    use num_rational::BigRational;
    use proptest::prelude::*;

    fn binomial(m: usize, k: usize) -> i64 {
        (1..=k).fold(1, |c, i| c * (m + 1 - i) as i64 / i as i64)
    }

    fn multiples(degree: usize) -> Vec<i64> {
        let common = (0..=degree).map(|k| binomial(degree, k)).fold(1, lcm);
        (0..=degree).map(|k| common / binomial(degree, k)).collect()
    }

    fn short(arguments: &[Rational], data: &[Rational], stride: usize) -> Option<Vec<Rational>> {
        let mut product = ShortArguments::default();
        for argument in arguments {
            product.take(argument.short_fraction()?)?;
        }
        product.combine(&multiples(arguments.len()), data, stride)
    }

    /// The sum of `F_k e_k / C(m, k)`, the `e_k` by their definition one argument after the other.
    fn by_definition(arguments: &[Rational], data: &[Rational], stride: usize) -> Vec<BigRational> {
        let of = |value: &Rational| BigRational::from(value.clone());
        let mut symmetric = vec![BigRational::from_integer(1.into())];
        for argument in arguments {
            symmetric.push(BigRational::from_integer(0.into()));
            for k in (1..symmetric.len()).rev() {
                let more = &symmetric[k - 1] * of(argument);
                symmetric[k] += more;
            }
        }
        let sum = |coordinate: usize| {
            let terms = symmetric.iter().enumerate().map(|(k, e)| {
                let binomial = BigRational::from_integer(binomial(arguments.len(), k).into());
                of(&data[k * stride + coordinate]) * e / binomial
            });
            terms.sum()
        };
        (0..stride).map(sum).collect()
    }

    /// Fractions people write, words of every length, those at both ends, and what is no word.
    fn number() -> impl Strategy<Value = Rational> {
        let word =
            |bits: u32| (any::<i64>(), 1..=i64::MAX).prop_map(move |(n, d)| Rational::new(n >> (64 - bits), (d >> (64 - bits)).max(1)));
        prop_oneof![
            3 => (-1000i64..1001).prop_map(|k| Rational::new(k, 1000)),
            3 => word(8),
            2 => (1u32..64).prop_flat_map(word),
            1 => (0i64..2, 1i64..3).prop_map(|(k, d)| Rational::new(i64::MAX - k, d)),
            1 => (0i64..2, 1i64..3).prop_map(|(k, d)| Rational::new(i64::MIN + k, d)),
            1 => (0i64..2).prop_map(|k| Rational::new(1, i64::MAX - k)),
        ]
    }

    /// Lists of one kind of number each, so that many of them stay short.
    fn numbers(count: usize) -> impl Strategy<Value = Vec<Rational>> {
        prop_oneof![
            2 => prop::collection::vec((-1000i64..1001).prop_map(|k| Rational::new(k, 1000)), count),
            2 => prop::collection::vec((-128i64..128, 1i64..256).prop_map(|(n, d)| Rational::new(n, d)), count),
            1 => prop::collection::vec(number(), count),
        ]
    }

    fn sample() -> impl Strategy<Value = (Vec<Rational>, Vec<Rational>, usize)> {
        (0usize..=16, 1usize..4).prop_flat_map(|(degree, stride)| (numbers(degree), numbers((degree + 1) * stride), Just(stride)))
    }

    proptest! {
        #[test]
        fn what_is_answered_is_the_polar_value((arguments, data, stride) in sample()) {
            if let Some(value) = short(&arguments, &data, stride) {
                let value: Vec<BigRational> = value.into_iter().map(BigRational::from).collect();
                prop_assert_eq!(value, by_definition(&arguments, &data, stride));
            }
        }
    }

    /// The weight `2 · 2^(2a)` at numerators of `c` bits, on both sides of the largest double word.
    #[test]
    fn sums_at_the_border_are_right_or_refused() {
        let mut answered = 0;
        for (a, c) in (58..63).flat_map(|a| (0..63).map(move |c| (a, c))) {
            let arguments = vec![Rational::from(1i64 << a); 2];
            let data: Vec<Rational> = [1, 1, 1i64 << c].map(Rational::from).into();
            if let Some(value) = short(&arguments, &data, 1) {
                answered += 1;
                assert_eq!(BigRational::from(value[0].clone()), by_definition(&arguments, &data, 1)[0], "{a} {c}");
            }
        }
        assert!((20..100).contains(&answered), "{answered}");
    }

    #[test]
    fn short_numbers_are_answered_and_long_ones_refused() {
        let small = |count: usize| -> Vec<Rational> { (0..count as i64).map(|k| Rational::new(3 * k - 7, 1 + k % 3)).collect() };
        let data = |count: usize| -> Vec<Rational> { (0..count as i64).map(|k| Rational::new(k * k - 5, 1000)).collect() };
        // One product of words, several of them, more forms than fit one.
        for degree in 0..=16 {
            assert!(short(&small(degree), &data(2 * degree + 2), 2).is_some(), "degree {degree}");
        }
        assert!(short(&vec![Rational::from(1); 16], &data(17), 1).is_some());
        // The sum, one numerator over the common denominator, the common denominator, the product of the arguments.
        let (one, long) = (Rational::from(1), Rational::from(i64::MAX));
        let edge = [long.clone(), long.clone()];
        assert_eq!(short(std::slice::from_ref(&one), &edge, 1).map(|value| value[0].numer()), Some(BigInt::from(i64::MAX) * 2));
        for (arguments, data) in [
            (vec![Rational::new(i64::MAX, 3); 2], vec![long.clone(); 3]),
            (vec![one.clone()], vec![long.clone(), Rational::new(1, 3)]),
            (vec![one.clone()], vec![Rational::new(1, i64::MAX), Rational::new(1, i64::MAX - 1)]),
            (vec![Rational::new(i64::MAX, 3); 4], vec![one.clone(); 5]),
            (vec![one], vec![Rational::from(BigInt::from(1) << 64), long]),
        ] {
            assert_eq!(short(&arguments, &data, 1), None, "{arguments:?} {data:?}");
        }
    }
}
