//! Arithmetic of rational numbers, and the traits of `num-traits`.

use std::iter::{Product, Sum};
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Rem, RemAssign, Sub, SubAssign};

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Num, One, Signed, Zero};

use super::Rational;
use super::rational::Repr;

fn add(a: &Rational, b: &Rational) -> Rational {
    match (a.as_small(), b.as_small()) {
        (Some((a, b)), Some((c, d))) => add_small((i128::from(a), b), (i128::from(c), d)),
        _ => Rational::from_big(a.numer() * b.denom() + b.numer() * a.denom(), a.denom() * b.denom()),
    }
}

fn subtract(a: &Rational, b: &Rational) -> Rational {
    match (a.as_small(), b.as_small()) {
        (Some((a, b)), Some((c, d))) => add_small((i128::from(a), b), (-i128::from(c), d)),
        _ => Rational::from_big(a.numer() * b.denom() - b.numer() * a.denom(), a.denom() * b.denom()),
    }
}

/// The sum of two fractions of words in lowest terms.
#[inline]
fn add_small((a, b): (i128, u64), (c, d): (i128, u64)) -> Rational {
    if b == 1 || d == 1 {
        // An integer changes nothing about what a fraction's terms share.
        let sum = a * i128::from(d) + c * i128::from(b);
        return Rational::from_lowest(sum < 0, sum.unsigned_abs(), u128::from(b * d));
    }
    if b == d {
        return Rational::from_i128(a + c, u128::from(b));
    }
    // Both products are below 2^126, so the sum fits.
    Rational::from_i128(a * i128::from(d) + c * i128::from(b), u128::from(b) * u128::from(d))
}

fn multiply(a: &Rational, b: &Rational) -> Rational {
    if a.is_one() {
        return b.clone();
    }
    match (&a.0, &b.0) {
        (Repr::Small { numer: a, denom: b }, Repr::Small { numer: c, denom: d }) => {
            if let (1, 1, Some(product)) = (b.get(), d.get(), a.checked_mul(*c)) {
                return Rational::small(product, 1);
            }
            Rational::from_i128(i128::from(*a) * i128::from(*c), u128::from(b.get()) * u128::from(d.get()))
        }
        _ => Rational::from_big(a.numer() * b.numer(), a.denom() * b.denom()),
    }
}

fn divide(a: &Rational, b: &Rational) -> Rational {
    match a.checked_div(b) {
        Some(quotient) => quotient,
        None => panic!("division of a rational number by zero"),
    }
}

fn remainder(a: &Rational, b: &Rational) -> Rational {
    let quotient = divide(a, b);
    let truncated = Rational::from(quotient.numer() / quotient.denom());
    subtract(a, &multiply(b, &truncated))
}

macro_rules! operators {
    ($($operator:ident $method:ident $assign:ident $assign_method:ident $function:ident;)*) => {$(
        impl $operator<&Rational> for &Rational {
            type Output = Rational;
            fn $method(self, other: &Rational) -> Rational { $function(self, other) }
        }
        impl $operator<Rational> for &Rational {
            type Output = Rational;
            fn $method(self, other: Rational) -> Rational { $function(self, &other) }
        }
        impl $operator<&Rational> for Rational {
            type Output = Rational;
            fn $method(self, other: &Rational) -> Rational { $function(&self, other) }
        }
        impl $operator for Rational {
            type Output = Rational;
            fn $method(self, other: Rational) -> Rational { $function(&self, &other) }
        }
        impl $assign<&Rational> for Rational {
            fn $assign_method(&mut self, other: &Rational) { *self = $function(self, other); }
        }
        impl $assign for Rational {
            fn $assign_method(&mut self, other: Rational) { *self = $function(self, &other); }
        }
    )*};
}

operators! {
    Add add AddAssign add_assign add;
    Sub sub SubAssign sub_assign subtract;
    Mul mul MulAssign mul_assign multiply;
    Div div DivAssign div_assign divide;
    Rem rem RemAssign rem_assign remainder;
}

impl Neg for &Rational {
    type Output = Rational;
    fn neg(self) -> Rational {
        match &self.0 {
            Repr::Small { numer, denom } => match numer.checked_neg() {
                Some(numer) => Rational(Repr::Small { numer, denom: *denom }),
                None => Rational::from_reduced_big(-BigInt::from(*numer), BigInt::from(denom.get())),
            },
            Repr::Big(big) => Rational::from_reduced_big(-big.numer(), big.denom().clone()),
        }
    }
}

impl Neg for Rational {
    type Output = Rational;
    fn neg(self) -> Rational {
        -&self
    }
}

impl Zero for Rational {
    #[inline]
    fn zero() -> Self {
        Self::from(0)
    }
    #[inline]
    fn is_zero(&self) -> bool {
        matches!(self.0, Repr::Small { numer: 0, .. })
    }
}

impl One for Rational {
    #[inline]
    fn one() -> Self {
        Self::from(1)
    }
    #[inline]
    fn is_one(&self) -> bool {
        self.as_small() == Some((1, 1))
    }
}

impl Default for Rational {
    fn default() -> Self {
        Self::zero()
    }
}

impl Num for Rational {
    type FromStrRadixErr = num_rational::ParseRatioError;
    fn from_str_radix(text: &str, radix: u32) -> Result<Self, Self::FromStrRadixErr> {
        BigRational::from_str_radix(text, radix).map(Self::from)
    }
}

impl Signed for Rational {
    fn abs(&self) -> Self {
        if self.is_negative() { -self } else { self.clone() }
    }
    fn abs_sub(&self, other: &Self) -> Self {
        if self <= other { Self::zero() } else { self - other }
    }
    fn signum(&self) -> Self {
        Self::from(i64::from(self.is_positive()) - i64::from(self.is_negative()))
    }
    fn is_positive(&self) -> bool {
        match &self.0 {
            Repr::Small { numer, .. } => *numer > 0,
            Repr::Big(big) => big.numer().is_positive(),
        }
    }
    fn is_negative(&self) -> bool {
        match &self.0 {
            Repr::Small { numer, .. } => *numer < 0,
            Repr::Big(big) => big.numer().is_negative(),
        }
    }
}

impl Sum for Rational {
    fn sum<I: Iterator<Item = Self>>(terms: I) -> Self {
        terms.fold(Self::zero(), |sum, term| sum + term)
    }
}

impl<'a> Sum<&'a Rational> for Rational {
    fn sum<I: Iterator<Item = &'a Rational>>(terms: I) -> Self {
        terms.fold(Self::zero(), |sum, term| sum + term)
    }
}

impl Product for Rational {
    fn product<I: Iterator<Item = Self>>(factors: I) -> Self {
        factors.fold(Self::one(), |product, factor| product * factor)
    }
}

impl<'a> Product<&'a Rational> for Rational {
    fn product<I: Iterator<Item = &'a Rational>>(factors: I) -> Self {
        factors.fold(Self::one(), |product, factor| product * factor)
    }
}
