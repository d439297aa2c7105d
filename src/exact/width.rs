//! The rings the kernel runs on, and the integers of every width among them.
//!
//! A width is chosen once for a whole computation from a bound computed
//! beforehand ([`Magnitude`]), so the arithmetic itself never checks for
//! overflow: it is arithmetic modulo a power of two. A sum of products that
//! fits comes out right even where the terms on the way did not fit, and so
//! does a quotient by an odd number ([`Ring::undo`]).

use num_bigint::{BigInt, Sign};
use num_traits::{One, Zero};

use super::magnitude::Magnitude;

/// What the kernel needs of its scalars: ring operations, no division but the
/// one that undoes an earlier multiplication.
pub trait Ring: Clone {
    /// Whether a product costs many times a sum.
    const LONG: bool = false;
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

/// The integers of one width.
pub(crate) trait Integer: Ring {
    /// The words of the width; none for integers of any length.
    const WORDS: usize;
    /// The integer, which the caller has bounded to fit.
    fn from_i64(value: i64) -> Self;
    /// The integer, which the caller has bounded to fit.
    fn from_i128(value: i128) -> Self;
    /// The integer modulo the width.
    fn from_big(value: &BigInt) -> Self;
    /// The value if the width is at most two words.
    fn as_i128(&self) -> Option<i128>;
    fn into_big(self) -> BigInt;
}

macro_rules! machine_integer {
    ($type:ty, $words:expr) => {
        impl Ring for $type {
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
        }
    };
}

machine_integer!(i64, 1);
machine_integer!(i128, 2);

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

/// An integer of `N` words in two's complement, least significant word first.
///
/// Arithmetic wraps; whoever chooses the width has bounded every value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Fixed<const N: usize>([u64; N]);

impl<const N: usize> Fixed<N> {
    fn is_negative(&self) -> bool {
        self.0[N - 1] >> 63 == 1
    }

    fn negated(&self) -> Self {
        let mut carry = true;
        Self(self.0.map(|word| {
            let (word, overflow) = (!word).overflowing_add(u64::from(carry));
            carry = overflow;
            word
        }))
    }

    /// `self += a * b`, all of it modulo `2^(64 N)`, where two's complement
    /// needs no regard for signs.
    #[inline]
    fn accumulate(&mut self, a: &Self, b: &Self) {
        for (i, &digit) in b.0.iter().enumerate() {
            if digit == 0 {
                continue;
            }
            let mut carry = 0u128;
            for (target, &word) in self.0[i..].iter_mut().zip(&a.0) {
                carry += u128::from(*target) + u128::from(word) * u128::from(digit);
                *target = carry as u64;
                carry >>= 64;
            }
        }
    }
}

impl<const N: usize> Ring for Fixed<N> {
    fn nothing() -> Self {
        Self([0; N])
    }
    fn unit() -> Self {
        Self::from_i64(1)
    }
    fn from_count(count: usize) -> Self {
        Self::from_i64(count as i64)
    }
    fn is_nothing(&self) -> bool {
        self.0.iter().all(|&word| word == 0)
    }
    fn is_unit(&self) -> bool {
        self.0[0] == 1 && self.0[1..].iter().all(|&word| word == 0)
    }
    #[inline]
    fn add(&mut self, other: &Self) {
        let mut carry = false;
        for (target, &word) in self.0.iter_mut().zip(&other.0) {
            let (sum, first) = target.overflowing_add(word);
            let (sum, second) = sum.overflowing_add(u64::from(carry));
            *target = sum;
            carry = first | second;
        }
    }
    #[inline]
    fn subtract(&mut self, other: &Self) {
        let mut borrow = false;
        for (target, &word) in self.0.iter_mut().zip(&other.0) {
            let (difference, first) = target.overflowing_sub(word);
            let (difference, second) = difference.overflowing_sub(u64::from(borrow));
            *target = difference;
            borrow = first | second;
        }
    }
    fn multiply(&mut self, other: &Self) {
        let mut product = Self::nothing();
        product.add_product(self, other);
        *self = product;
    }
    #[inline]
    fn add_product(&mut self, a: &Self, b: &Self) {
        // Negative factors are all ones on top: multiplying by their absolute
        // value skips the zero words instead.
        if b.is_negative() {
            self.accumulate(&a.negated(), &b.negated());
        } else {
            self.accumulate(a, b);
        }
    }
    fn divide_exactly(&mut self, other: &Self) {
        let negative = self.is_negative() != other.is_negative();
        let magnitude = if self.is_negative() { self.negated() } else { *self };
        let divisor = if other.is_negative() { other.negated() } else { *other };
        let quotient = if divisor.0[1..].iter().all(|&word| word == 0) {
            let (mut quotient, mut rest) = (magnitude, 0u128);
            for word in quotient.0.iter_mut().rev() {
                rest = rest << 64 | u128::from(*word);
                *word = (rest / u128::from(divisor.0[0])) as u64;
                rest %= u128::from(divisor.0[0]);
            }
            debug_assert_eq!(rest, 0);
            quotient
        } else {
            Self::from_big(&(magnitude.into_big() / divisor.into_big()))
        };
        *self = if negative { quotient.negated() } else { quotient };
    }
    fn undo(&self) -> Option<Self> {
        if !self.is_odd() {
            return None;
        }
        let mut inverse = *self;
        let mut bits = 3;
        while bits < 64 * N {
            let mut correction = Self::from_i64(2);
            let mut product = *self;
            product.multiply(&inverse);
            correction.subtract(&product);
            inverse.multiply(&correction);
            bits *= 2;
        }
        Some(inverse)
    }
    fn is_odd(&self) -> bool {
        self.0[0] & 1 == 1
    }
    fn as_word(&self) -> Option<i64> {
        self.into_big().as_word()
    }
    fn from_word(value: i64) -> Self {
        <Self as Integer>::from_i64(value)
    }
    fn magnitude(&self) -> Magnitude {
        Magnitude::from_big(self.into_big().magnitude())
    }
}

impl<const N: usize> Integer for Fixed<N> {
    const WORDS: usize = N;
    fn from_i64(value: i64) -> Self {
        let mut words = [if value < 0 { u64::MAX } else { 0 }; N];
        words[0] = value as u64;
        Self(words)
    }
    fn from_i128(value: i128) -> Self {
        let mut words = [if value < 0 { u64::MAX } else { 0 }; N];
        words[0] = value as u64;
        words[1] = (value >> 64) as u64;
        Self(words)
    }
    fn from_big(value: &BigInt) -> Self {
        let mut words = [0; N];
        for (word, digit) in words.iter_mut().zip(value.magnitude().iter_u64_digits()) {
            *word = digit;
        }
        let magnitude = Self(words);
        if value.sign() == Sign::Minus { magnitude.negated() } else { magnitude }
    }
    fn as_i128(&self) -> Option<i128> {
        None
    }
    fn into_big(self) -> BigInt {
        let (sign, magnitude) = if self.is_negative() { (Sign::Minus, self.negated()) } else { (Sign::Plus, self) };
        let halves = magnitude.0.iter().flat_map(|&word| [word as u32, (word >> 32) as u32]).collect();
        BigInt::new(sign, halves)
    }
}

#[cfg(test)]
mod tests {
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
