//! Lowest terms without a gcd, where the primes of the denominator are small.
//!
//! The denominators of decimals, of fractions people write, and of binomial
//! numbers are products of small primes. Whether a number is a multiple of an
//! odd `p` takes one product: times the inverse of `p` modulo the word it is
//! at most `MAX / p` exactly for multiples, and then it is the quotient
//! (Granlund and Montgomery, *Division by Invariant Integers using
//! Multiplication*, 1994, section 9). That beats the gcd of two words many times.

use num_traits::{PrimInt, Unsigned, WrappingMul};

use super::gcd::{gcd_u64, gcd_u128};
use super::width::Ring;

const ODD_PRIMES: [usize; 10] = [3, 5, 7, 11, 13, 17, 19, 23, 29, 31];
/// Below this all primes are 2 and [`ODD_PRIMES`].
const FIRST_OTHER: usize = 37;

/// One or two machine words without a sign.
pub(crate) trait Word: PrimInt + Unsigned + WrappingMul {
    /// The integers of the same width.
    type Signed: Ring;
    const BITS: u64;
    const INVERSES: [Inverse<Self>; ODD_PRIMES.len()];
    /// The greatest common divisor.
    fn gcd(self, other: Self) -> Self;
    /// The low words of the number.
    fn from_u128(value: u128) -> Self;
    fn into_u128(self) -> u128;
    /// The absolute value.
    fn of_signed(value: &Self::Signed) -> Self;
}

macro_rules! word {
    ($type:ty, $signed:ty, $gcd:ident) => {
        impl Word for $type {
            type Signed = $signed;
            const BITS: u64 = <$type>::BITS as u64;
            const INVERSES: [Inverse<Self>; ODD_PRIMES.len()] = {
                let mut table = [Inverse { inverse: 0, largest: 0 }; ODD_PRIMES.len()];
                let mut index = 0;
                while index < table.len() {
                    let prime = ODD_PRIMES[index] as $type;
                    // Newton's iteration doubles the bits that are right, from 3 on.
                    let mut inverse = prime;
                    let mut bits = 3;
                    while bits < <$type>::BITS {
                        inverse = inverse.wrapping_mul((2 as $type).wrapping_sub(prime.wrapping_mul(inverse)));
                        bits *= 2;
                    }
                    table[index] = Inverse { inverse, largest: <$type>::MAX / prime };
                    index += 1;
                }
                table
            };
            #[inline]
            fn gcd(self, other: Self) -> Self {
                $gcd(self, other)
            }
            #[inline]
            fn from_u128(value: u128) -> Self {
                value as $type
            }
            #[inline]
            fn into_u128(self) -> u128 {
                u128::from(self)
            }
            #[inline]
            fn of_signed(value: &$signed) -> Self {
                value.unsigned_abs()
            }
        }
    };
}

word!(u64, i64, gcd_u64);
word!(u128, i128, gcd_u128);

/// A set of odd primes, one bit each. (Two is always looked for.)
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct PrimeSet(u16);

impl PrimeSet {
    pub(crate) const EMPTY: Self = Self(0);

    /// The primes up to a bound: those of the multinomial numbers of a degree.
    /// The second part says whether all of them are in the set.
    #[inline]
    pub(crate) fn up_to(bound: usize) -> (Self, bool) {
        let count = ODD_PRIMES.iter().take_while(|&&prime| prime <= bound).count();
        (Self((1 << count) - 1), bound < FIRST_OTHER)
    }

    #[inline]
    pub(crate) fn union(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// The small primes of a non-zero number, and what dividing by all of them leaves.
    #[inline]
    pub(crate) fn of<W: Word>(value: W) -> (Self, W) {
        let mut rest = value >> value.trailing_zeros() as usize;
        let mut found = Self::EMPTY;
        for (index, inverse) in W::INVERSES.iter().enumerate() {
            if rest == W::one() {
                break;
            }
            while let Some(quotient) = inverse.quotient(rest) {
                rest = quotient;
                found.0 |= 1 << index;
            }
        }
        (found, rest)
    }
}

/// For an odd prime its inverse modulo the word, and the quotient of the largest multiple.
#[derive(Clone, Copy)]
pub(crate) struct Inverse<W> {
    inverse: W,
    largest: W,
}

impl<W: Word> Inverse<W> {
    /// The exact quotient by the prime, if there is one.
    #[inline]
    fn quotient(self, value: W) -> Option<W> {
        let quotient = value.wrapping_mul(&self.inverse);
        if quotient <= self.largest { Some(quotient) } else { None }
    }
}

/// Divides two non-zero numbers by their greatest common divisor, where 2, the
/// primes of the set, and the primes of the odd `rest` are all those of the second
/// one, each in one place only.
#[inline]
pub(crate) fn lowest<W: Word>(mut numer: W, mut denom: W, primes: PrimeSet, rest: W) -> (W, W) {
    let twos = numer.trailing_zeros().min(denom.trailing_zeros()) as usize;
    numer = numer >> twos;
    denom = denom >> twos;
    let mut left = primes.0;
    while let Some(inverse) = W::INVERSES.get(left.trailing_zeros() as usize) {
        left &= left - 1;
        while let Some(short) = inverse.quotient(denom)
            && let Some(shorter) = inverse.quotient(numer)
        {
            (numer, denom) = (shorter, short);
        }
    }
    if rest != W::one() {
        let common = numer.gcd(rest);
        if common != W::one() {
            numer = numer / common;
            denom = denom / common;
        }
    }
    (numer, denom)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn agrees<W: Word + std::fmt::Debug>(a: W, b: W, primes: PrimeSet, rest: W) -> Result<(), TestCaseError> {
        let common = a.gcd(b);
        prop_assert_eq!(lowest(a, b, primes, rest), (a / common, b / common));
        Ok(())
    }

    proptest! {
        #[test]
        fn lowest_terms_are_those_of_the_gcd(
            a in 1u64..,
            shared in 1u64..5_000_000,
            exponents in prop::array::uniform4(0u32..4),
            other in 1u64..2000,
            index in 0usize..10,
        ) {
            let small = 2u64.pow(exponents[0]) * 3u64.pow(exponents[1]) * 5u64.pow(exponents[2]) * (ODD_PRIMES[index] as u64).pow(exponents[3]);
            let b = small * other;
            for a in [a, a >> 40 | 1, shared.saturating_mul(b).max(1), shared * small] {
                let (primes, rest) = PrimeSet::of(b);
                agrees(a, b, primes, rest)?;
                agrees(u128::from(a), u128::from(b), primes, u128::from(rest))?;
                let (a, b) = (u128::from(a) * u128::from(shared), u128::from(b) * u128::from(shared));
                let (primes, rest) = PrimeSet::of(b);
                agrees(a, b, primes, rest)?;
            }
        }

        #[test]
        fn a_number_is_its_small_primes_and_the_rest(value in 1u64..) {
            let (primes, rest) = PrimeSet::of(value);
            prop_assert_eq!(value % rest, 0);
            for (index, &prime) in ODD_PRIMES.iter().enumerate() {
                prop_assert!(rest % prime as u64 != 0);
                prop_assert_eq!(primes.0 >> index & 1 == 1, value % prime as u64 == 0);
            }
        }
    }

    #[test]
    fn primes_up_to_a_degree() {
        assert_eq!(PrimeSet::up_to(2), (PrimeSet::EMPTY, true));
        assert_eq!(PrimeSet::up_to(7), (PrimeSet(0b111), true));
        let all = PrimeSet((1 << ODD_PRIMES.len()) - 1);
        assert_eq!(PrimeSet::up_to(36), (all, true));
        assert_eq!(PrimeSet::up_to(37), (all, false));
    }
}
