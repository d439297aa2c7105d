//! Greatest common divisors: binary for machine words, Lehmer beyond.
//!
//! `num-integer` computes the gcd of big integers by shifting and subtracting
//! whole numbers; Lehmer's method (Knuth, *The Art of Computer Programming*,
//! vol. 2, section 4.5.2, algorithm L) runs most of Euclid's steps on the
//! leading 62 bits and is several times faster from two words up.

use num_bigint::BigUint;
use num_traits::Zero;

/// The greatest common divisor of two words; `gcd(0, b) = b`.
pub(crate) fn gcd_u64(mut a: u64, mut b: u64) -> u64 {
    if a == 0 {
        return b;
    }
    if b == 0 {
        return a;
    }
    let shift = (a | b).trailing_zeros();
    a >>= a.trailing_zeros();
    b >>= b.trailing_zeros();
    while a != b {
        // Both odd: the difference is even, so every round drops a bit at least.
        // Its trailing zeros do not wait for its sign.
        let (difference, opposite) = (b.wrapping_sub(a), a.wrapping_sub(b));
        let zeros = difference.trailing_zeros();
        (a, b) = if a < b { (difference >> zeros, a) } else { (opposite >> zeros, b) };
    }
    a << shift
}

/// The greatest common divisor of two double words.
pub(crate) fn gcd_u128(mut a: u128, mut b: u128) -> u128 {
    if a < b {
        std::mem::swap(&mut a, &mut b);
    }
    if b == 0 {
        return a;
    }
    // One division brings unbalanced operands to the same size.
    if a.leading_zeros() + 8 < b.leading_zeros() {
        (a, b) = (b, a % b);
        if b == 0 {
            return a;
        }
    }
    let shift = (a | b).trailing_zeros();
    a >>= a.trailing_zeros();
    b >>= b.trailing_zeros();
    while (a | b) >> 64 != 0 {
        if a == b {
            return a << shift;
        }
        let difference = a.abs_diff(b);
        b = a.min(b);
        a = difference >> difference.trailing_zeros();
    }
    u128::from(gcd_u64(a as u64, b as u64)) << shift
}

/// The greatest common divisor of two big integers.
pub(crate) fn gcd_big(a: &BigUint, b: &BigUint) -> BigUint {
    let (mut x, mut y) = if a >= b { (a.to_u64_digits(), b.to_u64_digits()) } else { (b.to_u64_digits(), a.to_u64_digits()) };
    loop {
        if y.is_empty() {
            return from_digits(&x);
        }
        if x.len() <= 2 {
            return BigUint::from(gcd_u128(double_word(&x), double_word(&y)));
        }
        if y.len() == 1 {
            let rest = remainder_by_word(x.iter().copied(), y[0]);
            return BigUint::from(gcd_u64(rest, y[0]));
        }
        match lehmer_cofactors(&x, &y) {
            Some(cofactors) => apply(&mut x, &mut y, cofactors),
            None => {
                let rest = from_digits(&x) % from_digits(&y);
                x = std::mem::replace(&mut y, if rest.is_zero() { Vec::new() } else { rest.to_u64_digits() });
            }
        }
    }
}

/// The remainder of a number given by its words, least significant first.
pub(crate) fn remainder_by_word(digits: impl DoubleEndedIterator<Item = u64>, divisor: u64) -> u64 {
    digits.rev().fold(0, |rest, digit| ((u128::from(rest) << 64 | u128::from(digit)) % u128::from(divisor)) as u64)
}

/// Reduces `numer / denom` to lowest terms in place.
pub(crate) fn reduce_big(numer: &mut num_bigint::BigInt, denom: &mut num_bigint::BigInt) {
    let common = gcd_big(numer.magnitude(), denom.magnitude());
    if common != BigUint::from(1u32) && !common.is_zero() {
        let common = num_bigint::BigInt::from(common);
        *numer /= &common;
        *denom /= &common;
    }
}

fn from_digits(digits: &[u64]) -> BigUint {
    let mut halves = Vec::with_capacity(2 * digits.len());
    for &digit in digits {
        halves.push(digit as u32);
        halves.push((digit >> 32) as u32);
    }
    BigUint::new(halves)
}

fn double_word(digits: &[u64]) -> u128 {
    let low = digits.first().copied().unwrap_or(0);
    let high = digits.get(1).copied().unwrap_or(0);
    u128::from(high) << 64 | u128::from(low)
}

/// The leading 62 bits of `x` and the bits of `y` at the same place.
fn leading_bits(x: &[u64], y: &[u64]) -> (i64, i64) {
    let top = x.len() - 1;
    let shift = x[top].leading_zeros();
    let window = |digits: &[u64]| {
        let at = |index: usize| digits.get(index).copied().unwrap_or(0);
        let pair = u128::from(at(top)) << 64 | u128::from(at(top - 1));
        ((pair << shift) >> 66) as i64
    };
    (window(x), window(y))
}

/// Euclid's steps on the leading bits as long as they are certainly those of
/// the whole numbers: the matrix `(a, b, c, d)` with `x' = a x + b y` and
/// `y' = c x + d y`, or `None` when not even one step is certain.
fn lehmer_cofactors(x: &[u64], y: &[u64]) -> Option<(i64, i64, i64, i64)> {
    let (mut xh, mut yh) = leading_bits(x, y);
    let (mut a, mut b, mut c, mut d) = (1i64, 0i64, 0i64, 1i64);
    while yh + c != 0 && yh + d != 0 {
        let quotient = (xh + a) / (yh + c);
        if quotient != (xh + b) / (yh + d) {
            break;
        }
        // The cofactors stay below the square root of the 62-bit window as
        // long as the two quotients agree, so none of this overflows.
        (a, c) = (c, a - quotient * c);
        (b, d) = (d, b - quotient * d);
        (xh, yh) = (yh, xh - quotient * yh);
    }
    (b != 0).then_some((a, b, c, d))
}

fn apply(x: &mut Vec<u64>, y: &mut Vec<u64>, (a, b, c, d): (i64, i64, i64, i64)) {
    y.resize(x.len(), 0);
    let (mut carry_x, mut carry_y) = (0i128, 0i128);
    for (xi, yi) in x.iter_mut().zip(y.iter_mut()) {
        let (old_x, old_y) = (i128::from(*xi), i128::from(*yi));
        carry_x += i128::from(a) * old_x + i128::from(b) * old_y;
        carry_y += i128::from(c) * old_x + i128::from(d) * old_y;
        *xi = carry_x as u64;
        *yi = carry_y as u64;
        carry_x >>= 64;
        carry_y >>= 64;
    }
    trim(x);
    trim(y);
}

fn trim(digits: &mut Vec<u64>) {
    while digits.last() == Some(&0) {
        digits.pop();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_bigint::BigInt;
    use num_integer::Integer;
    use proptest::prelude::*;

    fn big(digits: Vec<u32>) -> BigUint {
        BigUint::new(digits)
    }

    proptest! {
        #[test]
        fn words_agree_with_num_integer(a: u64, b: u64, k in 0u32..64, l in 0u32..64) {
            let (a, b) = (a >> k, b >> l);
            prop_assert_eq!(gcd_u64(a, b), a.gcd(&b));
        }

        #[test]
        fn double_words_agree_with_num_integer(a: u128, b: u128, c: u64, k in 0u32..128, l in 0u32..128) {
            let (a, b) = (a >> k, b >> l);
            prop_assert_eq!(gcd_u128(a, b), a.gcd(&b));
            let (a, b) = ((a >> 65) * u128::from(c), (b >> 65) * u128::from(c));
            prop_assert_eq!(gcd_u128(a, b), a.gcd(&b));
        }

        #[test]
        fn big_numbers_agree_with_num_integer(
            a in prop::collection::vec(any::<u32>(), 0..14),
            b in prop::collection::vec(any::<u32>(), 0..14),
            c in prop::collection::vec(any::<u32>(), 0..8),
        ) {
            // A planted common factor makes the interesting case certain.
            let (a, b, c) = (big(a), big(b), big(c));
            prop_assert_eq!(gcd_big(&a, &b), a.gcd(&b));
            let (a, b) = (a * &c, b * &c);
            prop_assert_eq!(gcd_big(&a, &b), a.gcd(&b));
        }

        #[test]
        fn fibonacci_like_quotients_and_long_runs_of_ones(n in 60usize..600, ones in 65u64..400) {
            let (mut a, mut b) = (BigUint::from(1u32), BigUint::from(1u32));
            for _ in 0..n {
                (a, b) = (&a + &b, a);
            }
            prop_assert_eq!(gcd_big(&a, &b), BigUint::from(1u32));
            let power = (BigUint::from(1u32) << ones) - 1u32;
            prop_assert_eq!(gcd_big(&power, &(&power * &a)), power.clone());
            prop_assert_eq!(gcd_big(&(&power + 1u32), &power), BigUint::from(1u32));
        }
    }

    #[test]
    fn reduction_keeps_the_value() {
        let (mut numer, mut denom) = (BigInt::from(-84) << 200, BigInt::from(36) << 190);
        reduce_big(&mut numer, &mut denom);
        assert_eq!((numer, denom), (BigInt::from(-7) << 10, BigInt::from(3)));
    }
}
