//! Integers of a fixed number of words.

use num_bigint::{BigInt, Sign};

use super::magnitude::Magnitude;
use super::width::{Integer, Ring};

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

    /// `self -= a * digit`
    #[inline(never)]
    fn subtract_row(&mut self, a: &Self, digit: u64) {
        let mut carry = 0u128;
        for (target, &word) in self.0.iter_mut().zip(&a.0) {
            carry += u128::from(word) * u128::from(digit);
            let (difference, borrow) = target.overflowing_sub(carry as u64);
            *target = difference;
            carry = (carry >> 64) + u128::from(borrow);
        }
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
    const LONG: bool = N > 4;
    const WRAPS: bool = true;
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
        // value skips the zero words instead. (Negating many words costs more
        // than finding out that only one of them counts.)
        if N > 8
            && b.is_negative()
            && let Some(word) = b.as_word()
        {
            self.subtract_row(a, word.unsigned_abs());
        } else if b.is_negative() {
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
        let word = self.0[0] as i64;
        let sign = if word < 0 { u64::MAX } else { 0 };
        self.0[1..].iter().all(|&above| above == sign).then_some(word)
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
