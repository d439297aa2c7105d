//! The rings the kernel runs on, and the integers of every width among them.
//!
//! A width is chosen once for a whole computation from a bound computed
//! beforehand ([`Magnitude`]), so the arithmetic itself never checks for
//! overflow: it is arithmetic modulo a power of two. A sum of products that
//! fits comes out right even where the terms on the way did not fit, and so
//! does a quotient by an odd number ([`Ring::undo`]).

use num_bigint::{BigInt, Sign};
use num_traits::{One, Zero};
use smallvec::SmallVec;

use super::magnitude::Magnitude;

/// What the kernel needs of its scalars: ring operations, no division but the
/// one that undoes an earlier multiplication.
pub trait Ring: Clone {
    /// Whether a product costs many times a sum.
    const LONG: bool = false;
    /// Whether numbers are kept modulo a power of two, where only odd factors can be undone.
    const WRAPS: bool = false;
    /// Whether a product costs more than one of words.
    const WIDE: bool = true;
    /// Zero.
    fn nothing() -> Self;
    /// One.
    fn unit() -> Self;
    /// The sum of `count` ones.
    fn from_count(count: usize) -> Self;
    /// Whether this is zero.
    fn is_nothing(&self) -> bool;
    /// Whether this is one.
    fn is_unit(&self) -> bool;
    /// `self += other`
    fn add(&mut self, other: &Self);
    /// `self -= other`
    fn subtract(&mut self, other: &Self);
    /// `self *= other`
    fn multiply(&mut self, other: &Self);
    /// `self += a * b`
    fn add_product(&mut self, a: &Self, b: &Self);
    /// `self /= other`, where `other` is known to divide without remainder.
    fn divide_exactly(&mut self, other: &Self);
    /// The factor that undoes multiplying by `self`, for integers modulo a
    /// power of two where `self` is odd. Unlike dividing, multiplying by it is
    /// right even if the product had wrapped.
    fn undo(&self) -> Option<Self> {
        None
    }
    /// Whether this is an odd integer.
    fn is_odd(&self) -> bool;
    /// The value if it is an integer of one word.
    fn as_word(&self) -> Option<i64>;
    /// The integer, which the caller has bounded to fit.
    fn from_word(value: i64) -> Self;
    /// A bound of an integer. (Other elements have no use for one.)
    fn magnitude(&self) -> Magnitude;
}

/// The numbers of a computation: on the stack where they are few.
pub(crate) type Entries<R> = SmallVec<[R; 32]>;

/// The powers `1, base, …, base^degree`.
pub(crate) fn powers<R: Ring>(base: &R, degree: usize) -> SmallVec<[R; 16]> {
    let mut powers = SmallVec::with_capacity(degree + 1);
    let mut power = R::unit();
    for _ in 0..degree {
        powers.push(power.clone());
        power.multiply(base);
    }
    powers.push(power);
    powers
}

/// The integers of one width.
pub(crate) trait Integer: Ring {
    /// The words of the width; none for integers of any length.
    const WORDS: usize;
    /// The integer, which the caller has bounded to fit.
    fn from_i64(value: i64) -> Self;
    /// Words as integers of this width, put into `room` unless they are that already.
    #[inline]
    fn of_words<'a>(words: &'a [i64], room: &'a mut Entries<Self>) -> &'a [Self] {
        room.extend(words.iter().map(|&word| Self::from_i64(word)));
        room
    }
    /// The same, to be changed.
    #[inline]
    fn of_words_mut<'a>(words: &'a mut Entries<i64>, room: &'a mut Entries<Self>) -> &'a mut Entries<Self> {
        room.extend(words.iter().map(|&word| Self::from_i64(word)));
        room
    }
    /// The integer, which the caller has bounded to fit.
    fn from_i128(value: i128) -> Self;
    /// The integer modulo the width.
    fn from_big(value: &BigInt) -> Self;
    /// The value if the width is at most two words.
    fn as_i128(&self) -> Option<i128>;
    fn into_big(self) -> BigInt;
}

macro_rules! machine_integer {
    ($type:ty, $words:expr, {$($more:tt)*}) => {
        impl Ring for $type {
            const WRAPS: bool = true;
            const WIDE: bool = $words > 1;
            #[inline]
            fn nothing() -> Self {
                0
            }
            #[inline]
            fn unit() -> Self {
                1
            }
            #[inline]
            fn from_count(count: usize) -> Self {
                count as $type
            }
            #[inline]
            fn is_nothing(&self) -> bool {
                *self == 0
            }
            #[inline]
            fn is_unit(&self) -> bool {
                *self == 1
            }
            #[inline]
            fn add(&mut self, other: &Self) {
                *self = self.wrapping_add(*other);
            }
            #[inline]
            fn subtract(&mut self, other: &Self) {
                *self = self.wrapping_sub(*other);
            }
            #[inline]
            fn multiply(&mut self, other: &Self) {
                *self = self.wrapping_mul(*other);
            }
            #[inline]
            fn add_product(&mut self, a: &Self, b: &Self) {
                *self = self.wrapping_add(a.wrapping_mul(*b));
            }
            #[inline]
            fn divide_exactly(&mut self, other: &Self) {
                debug_assert_eq!(*self % *other, 0);
                *self /= other;
            }
            #[inline]
            fn undo(&self) -> Option<Self> {
                // Newton's iteration: right in 3 bits at first, then twice as many each time.
                let mut inverse = *self;
                for _ in 0..4 + $words {
                    inverse = inverse.wrapping_mul((2 as $type).wrapping_sub(self.wrapping_mul(inverse)));
                }
                self.is_odd().then_some(inverse)
            }
            #[inline]
            fn is_odd(&self) -> bool {
                self & 1 == 1
            }
            #[inline]
            fn as_word(&self) -> Option<i64> {
                i64::try_from(*self).ok()
            }
            #[inline]
            fn from_word(value: i64) -> Self {
                <$type>::from(value)
            }
            #[inline]
            fn magnitude(&self) -> Magnitude {
                Magnitude::from(self.unsigned_abs())
            }
        }
        impl Integer for $type {
            const WORDS: usize = $words;
            #[inline]
            fn from_i64(value: i64) -> Self {
                <$type>::from(value)
            }
            #[inline]
            fn from_i128(value: i128) -> Self {
                value as $type
            }
            fn from_big(value: &BigInt) -> Self {
                // Modulo the width: a parameter may be longer than every result.
                let digits = value.magnitude().iter_u64_digits().take($words);
                let low = digits.enumerate().fold(0, |low, (place, digit)| low | (digit as $type) << (64 * place));
                if value.sign() == Sign::Minus { <$type>::wrapping_neg(low) } else { low }
            }
            #[inline]
            fn as_i128(&self) -> Option<i128> {
                Some(i128::from(*self))
            }
            fn into_big(self) -> BigInt {
                BigInt::from(self)
            }
            $($more)*
        }
    };
}

machine_integer!(i64, 1, {
    #[inline]
    fn of_words<'a>(words: &'a [i64], _: &'a mut Entries<Self>) -> &'a [Self] {
        words
    }
    #[inline]
    fn of_words_mut<'a>(words: &'a mut Entries<i64>, _: &'a mut Entries<Self>) -> &'a mut Entries<Self> {
        words
    }
});
machine_integer!(i128, 2, {});

impl Ring for BigInt {
    const LONG: bool = true;
    fn nothing() -> Self {
        Self::ZERO
    }
    fn unit() -> Self {
        One::one()
    }
    fn from_count(count: usize) -> Self {
        Self::from(count)
    }
    fn is_nothing(&self) -> bool {
        Zero::is_zero(self)
    }
    fn is_unit(&self) -> bool {
        One::is_one(self)
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
        if a.is_one() {
            *self += b;
        } else {
            *self += a * b;
        }
    }
    fn divide_exactly(&mut self, other: &Self) {
        debug_assert!((&*self % other).is_zero());
        *self /= other;
    }
    fn is_odd(&self) -> bool {
        self.bit(0)
    }
    fn as_word(&self) -> Option<i64> {
        i64::try_from(self).ok()
    }
    fn from_word(value: i64) -> Self {
        Self::from(value)
    }
    fn magnitude(&self) -> Magnitude {
        Magnitude::from_big(self.magnitude())
    }
}

impl Integer for BigInt {
    const WORDS: usize = 0;
    fn from_i64(value: i64) -> Self {
        Self::from(value)
    }
    fn from_i128(value: i128) -> Self {
        Self::from(value)
    }
    fn from_big(value: &BigInt) -> Self {
        value.clone()
    }
    fn as_i128(&self) -> Option<i128> {
        None
    }
    fn into_big(self) -> BigInt {
        self
    }
}

#[cfg(test)]
mod tests {
    use super::super::fixed::Fixed;
    use super::*;
    use proptest::prelude::*;

    fn integer() -> impl Strategy<Value = BigInt> {
        prop_oneof![
            (-3i64..4).prop_map(BigInt::from),
            any::<i64>().prop_map(BigInt::from),
            any::<i128>().prop_map(BigInt::from),
            (any::<i64>(), 0u32..60).prop_map(|(value, shift)| BigInt::from(value) << shift),
        ]
    }

    /// Every operation on a width against the same on big integers.
    fn agrees<R: Integer>(a: &BigInt, b: &BigInt, c: &BigInt) -> Result<(), TestCaseError> {
        let of = |value: &BigInt| R::from_big(value);
        let check = |ours: R, theirs: BigInt| -> Result<(), TestCaseError> {
            prop_assert_eq!(ours.into_big(), theirs);
            Ok(())
        };
        let mut sum = of(a);
        sum.add(&of(b));
        check(sum, a + b)?;
        let mut difference = of(a);
        difference.subtract(&of(b));
        check(difference, a - b)?;
        let mut product = of(a);
        product.multiply(&of(b));
        check(product.clone(), a * b)?;
        if !b.is_zero() {
            product.divide_exactly(&of(b));
            check(product, a.clone())?;
        }
        let mut fused = of(c);
        fused.add_product(&of(a), &of(b));
        check(fused, c + a * b)?;
        if let Some(inverse) = of(b).undo() {
            // The product may wrap: undoing it is right all the same.
            let mut product = of(a);
            for factor in [&of(b), &of(b), &of(b), &inverse, &inverse, &inverse] {
                product.multiply(factor);
            }
            check(product, a.clone())?;
        }
        prop_assert_eq!(of(a).is_odd(), a.bit(0));
        prop_assert_eq!(of(a).is_nothing(), a.is_zero());
        prop_assert_eq!(of(a).is_unit(), a.is_one());
        Ok(())
    }

    proptest! {
        #[test]
        fn every_width_agrees_with_big_integers(a in integer(), b in integer(), c in integer()) {
            agrees::<Fixed<6>>(&a, &b, &c)?;
            agrees::<Fixed<8>>(&a, &b, &c)?;
            agrees::<Fixed<12>>(&a, &b, &c)?;
            agrees::<BigInt>(&a, &b, &c)?;
            let (a, b, c) = (a >> 66, b >> 66, c >> 66);
            agrees::<Fixed<3>>(&a, &b, &c)?;
            agrees::<i128>(&a, &b, &c)?;
            let (a, b, c) = (a >> 31, b >> 31, c >> 31);
            agrees::<i64>(&a, &b, &c)?;
        }

        #[test]
        fn words_widen_with_their_sign(value: i64, double: i128) {
            prop_assert_eq!(Fixed::<4>::from_i64(value).into_big(), BigInt::from(value));
            prop_assert_eq!(Fixed::<3>::from_i128(double).into_big(), BigInt::from(double));
        }
    }
}
