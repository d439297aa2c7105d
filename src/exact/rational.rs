//! The exact scalar of everything the library returns.

use std::cmp::Ordering;
use std::fmt;
use std::hash::{Hash, Hasher};
use std::num::NonZeroU64;

use num_bigint::{BigInt, Sign};
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::gcd::{gcd_u64, gcd_u128, reduce_big};

/// A rational number, always in lowest terms with a positive denominator.
///
/// Sixteen bytes: numerator and denominator are held inline as long as both
/// fit a signed machine word, and in a boxed [`BigRational`] beyond. Equal
/// numbers have equal representations, so equality and hashing are cheap.
/// Arithmetic never rounds and never overflows.
///
/// Converts from and into [`BigRational`] without loss, and implements the
/// traits of `num-traits`, so that it can be the scalar of `nalgebra`'s
/// matrices and points.
///
/// ```
/// use casteljau::Rational;
/// use num_rational::BigRational;
/// let third = Rational::new(1, 3);
/// assert_eq!((&third + &third + &third).to_string(), "1");
/// let big: BigRational = third.clone().into();
/// assert_eq!(Rational::from(big), third);
/// ```
#[derive(Clone)]
pub struct Rational(pub(super) Repr);

#[derive(Clone)]
pub(super) enum Repr {
    /// `denom` is at most `i64::MAX`.
    Small { numer: i64, denom: NonZeroU64 },
    /// Numerator or denominator does not fit `Small`.
    Big(Box<BigRational>),
}

/// The largest numerator or denominator held inline.
const LARGEST: u128 = i64::MAX as u128;

const _: () = assert!(size_of::<Rational>() == 16);

impl Rational {
    /// The fraction `numer / denom`, reduced.
    ///
    /// # Panics
    /// If `denom` is zero, like `num_rational::Ratio::new`.
    #[must_use]
    pub fn new(numer: i64, denom: i64) -> Self {
        assert!(denom != 0, "a rational number has a non-zero denominator");
        let sign = if denom < 0 { -1 } else { 1 };
        Self::from_i128(sign * i128::from(numer), u128::from(denom.unsigned_abs()))
    }

    /// The fraction of two big integers, reduced. The caller guarantees `denom != 0`.
    pub(crate) fn from_big(mut numer: BigInt, mut denom: BigInt) -> Self {
        debug_assert!(!denom.is_zero());
        if denom.sign() == Sign::Minus {
            numer = -numer;
            denom = -denom;
        }
        if let (Some(numer), Some(denom)) = (numer.to_i128(), denom.to_u128()) {
            return Self::from_i128(numer, denom);
        }
        reduce_big(&mut numer, &mut denom);
        Self::from_reduced_big(numer, denom)
    }

    /// A fraction that is in lowest terms already, with a positive denominator.
    pub(crate) fn from_reduced_big(numer: BigInt, denom: BigInt) -> Self {
        match (numer.to_i64(), denom.to_i64()) {
            (Some(numer), Some(denom)) => Self::small(numer, denom.unsigned_abs()),
            _ => Self(Repr::Big(Box::new(BigRational::new_raw(numer, denom)))),
        }
    }

    /// `numer / denom`, reduced; `denom` is not zero.
    #[inline]
    pub(crate) fn from_i128(numer: i128, denom: u128) -> Self {
        let magnitude = numer.unsigned_abs();
        if magnitude >> 64 == 0 && denom >> 64 == 0 {
            return Self::from_words(numer < 0, magnitude as u64, denom as u64);
        }
        let common = if denom >> 64 == 0 {
            // The common case of a long numerator over a short denominator.
            u128::from(gcd_u64((magnitude % denom) as u64, denom as u64))
        } else {
            gcd_u128(magnitude, denom)
        };
        let (magnitude, denom) = if common == 1 { (magnitude, denom) } else { (magnitude / common, denom / common) };
        let signed = if numer < 0 { (magnitude as i128).wrapping_neg() } else { magnitude as i128 };
        match (i64::try_from(signed), i64::try_from(denom)) {
            (Ok(numer), Ok(denom)) => Self::small(numer, denom.unsigned_abs()),
            _ => Self::from_reduced_big(BigInt::from(signed), BigInt::from(denom)),
        }
    }

    #[inline]
    fn from_words(negative: bool, magnitude: u64, denom: u64) -> Self {
        let common = gcd_u64(magnitude, denom);
        let (magnitude, denom) = if common == 1 { (magnitude, denom) } else { (magnitude / common, denom / common) };
        let signed = if negative { -i128::from(magnitude) } else { i128::from(magnitude) };
        match (i64::try_from(signed), i64::try_from(denom)) {
            (Ok(numer), Ok(_)) => Self::small(numer, denom),
            _ => Self::from_reduced_big(BigInt::from(signed), BigInt::from(denom)),
        }
    }

    /// `numer / denom` with a sign, in lowest terms already; `denom` is not zero.
    #[inline]
    pub(crate) fn from_lowest(negative: bool, numer: u128, denom: u128) -> Self {
        if numer <= LARGEST && denom <= LARGEST {
            return Self::small(if negative { -(numer as i64) } else { numer as i64 }, denom as u64);
        }
        Self::from_long_lowest(negative, numer, denom)
    }

    /// Appends such a fraction. (A number that may be of either form is put
    /// together elsewhere first, and moving it from there waits for that.)
    #[inline]
    pub(crate) fn push_lowest(list: &mut Vec<Self>, negative: bool, numer: u128, denom: u128) {
        if numer <= LARGEST && denom <= LARGEST {
            list.push(Self::small(if negative { -(numer as i64) } else { numer as i64 }, denom as u64));
        } else {
            list.push(Self::from_long_lowest(negative, numer, denom));
        }
    }

    #[cold]
    fn from_long_lowest(negative: bool, numer: u128, denom: u128) -> Self {
        let sign = if negative { Sign::Minus } else { Sign::Plus };
        Self::from_reduced_big(BigInt::from_biguint(sign, numer.into()), BigInt::from(denom))
    }

    #[inline]
    pub(super) fn small(numer: i64, denom: u64) -> Self {
        match NonZeroU64::new(denom) {
            Some(denom) => Self(Repr::Small { numer, denom }),
            None => unreachable!("denominators are checked where they come in"),
        }
    }

    /// Numerator and denominator if both fit a machine word.
    #[inline]
    pub(crate) fn as_small(&self) -> Option<(i64, u64)> {
        match &self.0 {
            Repr::Small { numer, denom } => Some((*numer, denom.get())),
            Repr::Big(_) => None,
        }
    }

    /// The numerator, with the sign of the number.
    #[must_use]
    pub fn numer(&self) -> BigInt {
        match &self.0 {
            Repr::Small { numer, .. } => BigInt::from(*numer),
            Repr::Big(big) => big.numer().clone(),
        }
    }

    /// The denominator, positive.
    #[must_use]
    pub fn denom(&self) -> BigInt {
        match &self.0 {
            Repr::Small { denom, .. } => BigInt::from(denom.get()),
            Repr::Big(big) => big.denom().clone(),
        }
    }

    /// Whether the denominator is 1.
    #[must_use]
    pub fn is_integer(&self) -> bool {
        match &self.0 {
            Repr::Small { denom, .. } => denom.get() == 1,
            Repr::Big(big) => big.denom().is_one(),
        }
    }

    /// The number of bits of the longer of numerator and denominator.
    #[must_use]
    pub fn bits(&self) -> u64 {
        match &self.0 {
            Repr::Small { numer, denom } => u64::from((64 - numer.unsigned_abs().leading_zeros()).max(64 - denom.get().leading_zeros())),
            Repr::Big(big) => big.numer().bits().max(big.denom().bits()),
        }
    }

    /// One over the number, or `None` for zero.
    #[must_use]
    pub fn recip(&self) -> Option<Self> {
        if self.is_zero() {
            return None;
        }
        Some(match &self.0 {
            Repr::Small { numer, denom } => {
                let sign = if *numer < 0 { -1 } else { 1 };
                Self::from_i128(sign * i128::from(denom.get()), u128::from(numer.unsigned_abs()))
            }
            Repr::Big(big) => {
                let (numer, denom) = (big.numer().clone(), big.denom().clone());
                if numer.is_negative() { Self::from_reduced_big(-denom, -numer) } else { Self::from_reduced_big(denom, numer) }
            }
        })
    }

    /// The quotient, or `None` if `divisor` is zero.
    #[must_use]
    pub fn checked_div(&self, divisor: &Self) -> Option<Self> {
        if divisor.is_one() {
            return Some(self.clone());
        }
        divisor.recip().map(|inverse| self * &inverse)
    }

    /// The number to a whole power; `0^0 = 1`.
    #[must_use]
    pub fn pow(&self, exponent: u32) -> Self {
        match &self.0 {
            Repr::Small { numer, denom } => {
                if let (Some(numer), Some(denom)) = (numer.checked_pow(exponent), denom.get().checked_pow(exponent))
                    && denom <= i64::MAX as u64
                {
                    return Self::small(numer, denom);
                }
                Self::from_reduced_big(self.numer().pow(exponent), self.denom().pow(exponent))
            }
            Repr::Big(big) => Self::from_reduced_big(big.numer().pow(exponent), big.denom().pow(exponent)),
        }
    }

    /// The nearest double, the only way from a rational number to a float.
    #[must_use]
    pub fn approximate(&self) -> f64 {
        match &self.0 {
            Repr::Small { numer, denom } if numer.unsigned_abs() < 1 << 53 && denom.get() < 1 << 53 => *numer as f64 / denom.get() as f64,
            _ => BigRational::from(self.clone()).to_f64().unwrap_or(f64::NAN),
        }
    }
}

impl From<i64> for Rational {
    #[inline]
    fn from(value: i64) -> Self {
        Self::small(value, 1)
    }
}

impl From<i32> for Rational {
    fn from(value: i32) -> Self {
        Self::small(i64::from(value), 1)
    }
}

impl From<u32> for Rational {
    fn from(value: u32) -> Self {
        Self::small(i64::from(value), 1)
    }
}

impl From<u64> for Rational {
    #[inline]
    fn from(value: u64) -> Self {
        i64::try_from(value).map_or_else(|_| Self::from(BigInt::from(value)), Self::from)
    }
}

impl From<usize> for Rational {
    #[inline]
    fn from(value: usize) -> Self {
        // No machine has words of more than 64 bits.
        Self::from(value as u64)
    }
}

impl From<BigInt> for Rational {
    fn from(value: BigInt) -> Self {
        Self::from_reduced_big(value, BigInt::one())
    }
}

impl From<BigRational> for Rational {
    fn from(value: BigRational) -> Self {
        let (numer, denom) = value.into();
        Self::from_big(numer, denom)
    }
}

impl From<Rational> for BigRational {
    fn from(value: Rational) -> Self {
        match value.0 {
            Repr::Small { numer, denom } => Self::new_raw(BigInt::from(numer), BigInt::from(denom.get())),
            Repr::Big(big) => *big,
        }
    }
}

impl PartialEq for Rational {
    fn eq(&self, other: &Self) -> bool {
        match (&self.0, &other.0) {
            (Repr::Small { numer: a, denom: b }, Repr::Small { numer: c, denom: d }) => a == c && b == d,
            // `Ratio` compares by continued fractions; in lowest terms the parts decide.
            (Repr::Big(a), Repr::Big(b)) => a.numer() == b.numer() && a.denom() == b.denom(),
            _ => false,
        }
    }
}

impl Eq for Rational {}

impl Hash for Rational {
    fn hash<H: Hasher>(&self, state: &mut H) {
        match &self.0 {
            Repr::Small { numer, denom } => (numer, denom.get()).hash(state),
            Repr::Big(big) => (big.numer(), big.denom()).hash(state),
        }
    }
}

impl Ord for Rational {
    fn cmp(&self, other: &Self) -> Ordering {
        match (&self.0, &other.0) {
            (Repr::Small { numer: a, denom: b }, Repr::Small { numer: c, denom: d }) => {
                (i128::from(*a) * i128::from(d.get())).cmp(&(i128::from(*c) * i128::from(b.get())))
            }
            _ => (self.numer() * other.denom()).cmp(&(other.numer() * self.denom())),
        }
    }
}

impl PartialOrd for Rational {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl fmt::Display for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if f.width().is_none() && !f.sign_plus() {
            return match &self.0 {
                Repr::Small { numer, denom } if denom.get() == 1 => write!(f, "{numer}"),
                Repr::Small { numer, denom } => write!(f, "{numer}/{denom}"),
                Repr::Big(big) => write!(f, "{big}"),
            };
        }
        let text = match &self.0 {
            Repr::Small { numer, denom } if denom.get() == 1 => numer.to_string(),
            Repr::Small { numer, denom } => format!("{numer}/{denom}"),
            Repr::Big(big) => big.to_string(),
        };
        let digits = text.strip_prefix('-').unwrap_or(&text);
        f.pad_integral(digits.len() == text.len(), "", digits)
    }
}

impl fmt::Debug for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Numbers around every border of the inline form, and far beyond it.
    fn big_integer() -> impl Strategy<Value = BigInt> {
        prop_oneof![
            (-40i64..40).prop_map(BigInt::from),
            any::<i64>().prop_map(BigInt::from),
            (-2i64..3).prop_map(|k| BigInt::from(i64::MAX) + k),
            (-2i64..3).prop_map(|k| BigInt::from(i64::MIN) + k),
            (-2i64..3).prop_map(|k| BigInt::from(u64::MAX) + k),
            any::<i128>().prop_map(BigInt::from),
            (any::<i128>(), any::<i128>()).prop_map(|(a, b)| BigInt::from(a) * BigInt::from(b)),
        ]
    }

    fn big_rational() -> impl Strategy<Value = BigRational> {
        (big_integer(), big_integer().prop_filter("non-zero", |d| !d.is_zero())).prop_map(|(n, d)| BigRational::new(n, d))
    }

    fn canonical(value: &Rational) -> bool {
        let (numer, denom) = (value.numer(), value.denom());
        let fits = numer.to_i64().is_some() && denom.to_i64().is_some();
        denom.is_positive() && num_integer::Integer::gcd(&numer, &denom).is_one() && value.as_small().is_some() == fits
    }

    proptest! {
        #[test]
        fn agrees_with_big_rational(a in big_rational(), b in big_rational()) {
            let (x, y) = (Rational::from(a.clone()), Rational::from(b.clone()));
            prop_assert!(canonical(&x) && canonical(&y));
            for (ours, theirs) in [(&x + &y, &a + &b), (&x - &y, &a - &b), (&x * &y, &a * &b), (-&x, -&a), (x.abs(), a.abs())] {
                prop_assert!(canonical(&ours));
                prop_assert_eq!(BigRational::from(ours), theirs);
            }
            if !b.is_zero() {
                prop_assert_eq!(BigRational::from(&x / &y), &a / &b);
                prop_assert_eq!(BigRational::from(&x % &y), &a % &b);
            }
            prop_assert_eq!(x.cmp(&y), a.cmp(&b));
            prop_assert_eq!(x == y, a == b);
            prop_assert_eq!(BigRational::from(x.pow(3)), a.pow(3));
            prop_assert_eq!(x.to_string(), a.to_string());
            prop_assert_eq!(x.to_string().parse::<Rational>(), Ok(x));
        }
    }

    #[test]
    fn borders_of_the_inline_form() {
        let smallest = Rational::from(i64::MIN);
        assert!(canonical(&-&smallest));
        assert_eq!(-(-&smallest), smallest);
        assert!(canonical(&Rational::new(1, i64::MIN)));
        assert_eq!(Rational::new(3, i64::MIN).recip().map(|x| x.to_string()), Some("-9223372036854775808/3".to_owned()));
        assert_eq!(Rational::zero().recip(), None);
    }

    #[test]
    fn serves_as_the_scalar_of_nalgebra() {
        use nalgebra::{DMatrix, DVector};
        let third = Rational::new(1, 3);
        let matrix = DMatrix::from_element(2, 2, third.clone());
        let product = &matrix * DVector::from_element(2, Rational::from(3));
        assert_eq!(product, DVector::from_element(2, Rational::from(2)));
    }

    #[test]
    fn counts_of_every_size_are_exact() {
        for count in [0, 1, i64::MAX as u64, i64::MAX as u64 + 1, u64::MAX] {
            assert_eq!(Rational::from(count), Rational::from(BigInt::from(count)));
            assert_eq!(Rational::from(count).to_string(), count.to_string());
        }
        assert_eq!(Rational::from(usize::MAX), Rational::from(BigInt::from(usize::MAX)));
    }
}
