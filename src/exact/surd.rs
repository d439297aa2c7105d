//! Numbers `a ± √d`.

use std::cmp::Ordering;
use std::fmt;
use std::ops::Neg;

use num_bigint::{BigInt, BigUint, Sign};
use num_traits::{One, Signed, Zero};

use super::Rational;

/// A number `a + √d` or `a - √d` with rational `a` and `d`, exact and comparable.
///
/// A valid value is either rational (sign 0 and radicand 0) or has a sign of
/// 1 or -1 and a positive radicand that is not the square of a rational. So
/// every such number has one representation, found without factoring anything,
/// and equality is equality of the parts. A product `k √d` is kept as
/// `±√(k² d)`.
///
/// The numbers with radicands that differ by the square of a rational form a
/// field; arithmetic stays in one such field and says `None` where it would
/// leave it. Comparison works between any two.
///
/// ```
/// use casteljau::{Rational, Surd};
/// let golden = Surd::new(Rational::new(1, 2), 1, Rational::new(5, 4)).ok_or("a negative radicand")?;
/// assert_eq!(golden.to_string(), "1/2 + 1/2 √5");
/// let square = golden.times(&golden).ok_or("another field")?;
/// assert_eq!(square, golden.plus_rational(&Rational::from(1)));
/// assert!(golden < Surd::from(Rational::new(1619, 1000)));
/// assert_eq!(Surd::root(&Rational::new(9, 4)), Some(Surd::from(Rational::new(3, 2))));
/// # Ok::<(), &str>(())
/// ```
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Surd {
    rational: Rational,
    sign: i8,
    radicand: Rational,
}

impl Surd {
    /// The number `rational + sign · √radicand`; a square is folded into the
    /// rational part. `None` for a negative radicand.
    #[must_use]
    pub fn new(rational: Rational, sign: i8, radicand: Rational) -> Option<Self> {
        if radicand.is_negative() {
            return None;
        }
        let sign = sign.signum();
        if sign == 0 || radicand.is_zero() {
            return Some(Self::from(rational));
        }
        Some(match exact_root(&radicand) {
            Some(root) if sign > 0 => Self::from(rational + root),
            Some(root) => Self::from(rational - root),
            None => Self { rational, sign, radicand },
        })
    }

    /// The root of a number; `None` for a negative one.
    #[must_use]
    pub fn root(radicand: &Rational) -> Option<Self> {
        Self::new(Rational::zero(), 1, radicand.clone())
    }

    /// The number `rational + factor · √radicand`; `None` for a negative radicand.
    #[must_use]
    pub fn with_factor(rational: Rational, factor: &Rational, radicand: &Rational) -> Option<Self> {
        Self::new(rational, sign_of(factor), factor * factor * radicand)
    }

    /// The same for a radicand that is known to be positive and no square.
    fn in_field(rational: Rational, factor: &Rational, radicand: &Rational) -> Self {
        match sign_of(factor) {
            0 => Self::from(rational),
            sign => Self { rational, sign, radicand: factor * factor * radicand },
        }
    }

    /// The rational part `a`.
    #[must_use]
    pub fn rational(&self) -> &Rational {
        &self.rational
    }

    /// The sign of the root: 1, -1, or 0 for a rational number.
    #[must_use]
    pub fn sign(&self) -> i8 {
        self.sign
    }

    /// The number below the root, 0 for a rational number.
    #[must_use]
    pub fn radicand(&self) -> &Rational {
        &self.radicand
    }

    /// The number itself if it is rational.
    #[must_use]
    pub fn as_rational(&self) -> Option<&Rational> {
        (self.sign == 0).then_some(&self.rational)
    }

    /// Whether this is zero.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.sign == 0 && self.rational.is_zero()
    }

    /// The other number with the same rational part and radicand.
    #[must_use]
    pub fn conjugate(&self) -> Self {
        Self { sign: -self.sign, ..self.clone() }
    }

    /// The sign of the whole number: -1, 0 or 1.
    #[must_use]
    pub fn signum(&self) -> i8 {
        sign_with_root(&self.rational, self.sign, &self.radicand)
    }

    /// The absolute value.
    #[must_use]
    pub fn abs(&self) -> Self {
        if self.signum() < 0 { -self } else { self.clone() }
    }

    /// The sum with a rational number.
    #[must_use]
    pub fn plus_rational(&self, other: &Rational) -> Self {
        Self { rational: &self.rational + other, ..self.clone() }
    }

    /// The product with a rational number.
    #[must_use]
    pub fn times_rational(&self, other: &Rational) -> Self {
        if other.is_zero() {
            return Self::default();
        }
        Self { rational: &self.rational * other, sign: self.sign * sign_of(other), radicand: &self.radicand * (other * other) }
    }

    /// The root of this number's radicand as a multiple of another's, where both
    /// are in one field.
    fn ratio(&self, other: &Self) -> Option<Rational> {
        if self.radicand == other.radicand {
            return Some(Rational::one());
        }
        exact_root(&self.radicand.checked_div(&other.radicand)?)
    }

    /// The sum; `None` if the two lie in different fields.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Option<Self> {
        if other.sign == 0 {
            return Some(self.plus_rational(&other.rational));
        }
        if self.sign == 0 {
            return Some(other.plus_rational(&self.rational));
        }
        let ratio = self.ratio(other)?;
        let factor = Rational::from(i64::from(self.sign)) * ratio + Rational::from(i64::from(other.sign));
        Some(Self::in_field(&self.rational + &other.rational, &factor, &other.radicand))
    }

    /// The difference; `None` if the two lie in different fields.
    #[must_use]
    pub fn minus(&self, other: &Self) -> Option<Self> {
        self.plus(&-other)
    }

    /// The product; `None` if the two lie in different fields.
    #[must_use]
    pub fn times(&self, other: &Self) -> Option<Self> {
        if other.sign == 0 {
            return Some(self.times_rational(&other.rational));
        }
        if self.sign == 0 {
            return Some(other.times_rational(&self.rational));
        }
        // Both over the root of the other one's radicand.
        let (a, c) = (&self.rational, &other.rational);
        let b = Rational::from(i64::from(self.sign)) * self.ratio(other)?;
        let d = Rational::from(i64::from(other.sign));
        let rational = a * c + &b * &d * &other.radicand;
        Some(Self::in_field(rational, &(a * d + b * c), &other.radicand))
    }

    /// One over the number; `None` for zero.
    #[must_use]
    pub fn recip(&self) -> Option<Self> {
        // The norm of a number that is not zero is not zero: its radicand is no square.
        let norm = (&self.rational * &self.rational - &self.radicand).recip()?;
        Some(self.conjugate().times_rational(&norm))
    }

    /// The quotient; `None` for zero, and if the two lie in different fields.
    #[must_use]
    pub fn over(&self, divisor: &Self) -> Option<Self> {
        self.times(&divisor.recip()?)
    }

    /// The value of the polynomial with these coefficients, in ascending powers, at this number.
    #[must_use]
    pub fn evaluate<'a>(&self, coefficients: impl DoubleEndedIterator<Item = &'a Rational>) -> Self {
        if self.sign == 0 {
            let value =
                coefficients.rev().fold(Rational::zero(), |sum, c| if sum.is_zero() { c.clone() } else { sum * &self.rational + c });
            return Self::from(value);
        }
        // Horner's scheme on pairs: the value is `whole + factor · (sign · √radicand)`.
        let (mut whole, mut factor) = (Rational::zero(), Rational::zero());
        for c in coefficients.rev() {
            (whole, factor) = (&whole * &self.rational + &factor * &self.radicand + c, whole + factor * &self.rational);
        }
        Self::in_field(whole, &(factor * Rational::from(i64::from(self.sign))), &self.radicand)
    }

    /// The number as `a + b √n` with an integer `n` from which the squares of
    /// small primes have been taken, for printing. A rational number has `b = 0`.
    #[must_use]
    pub fn printed_parts(&self) -> (Rational, Rational, BigInt) {
        if self.sign == 0 {
            return (self.rational.clone(), Rational::zero(), BigInt::one());
        }
        // √(p/q) = √(p q) / q
        let denominator = self.radicand.denom();
        let mut rest = self.radicand.numer() * &denominator;
        let mut taken = BigInt::one();
        for prime in SMALL_PRIMES {
            let square = BigInt::from(prime * prime);
            while (&rest % &square).is_zero() {
                rest /= &square;
                taken *= prime;
            }
        }
        // What is left may be the square of a large number times a small one.
        for small in 1..=SMALL_COFACTOR {
            if (&rest % small).is_zero() {
                let quotient = &rest / small;
                let root = quotient.sqrt();
                if !root.is_one() && &root * &root == quotient {
                    (taken, rest) = (taken * root, BigInt::from(small));
                    break;
                }
            }
        }
        (self.rational.clone(), Rational::from_big(taken * i32::from(self.sign), denominator), rest)
    }

    /// Two rational numbers with the number between them that are at most
    /// `2^-bits` apart; both are the number if it is rational.
    #[must_use]
    pub fn enclosure(&self, bits: u32) -> (Rational, Rational) {
        if self.sign == 0 {
            return (self.rational.clone(), self.rational.clone());
        }
        // floor(√(p/q) · 2^bits) = floor(√(p · 4^bits / q))
        let scaled: BigInt = (self.radicand.numer() << (2 * u64::from(bits))) / self.radicand.denom();
        let root = BigInt::from_biguint(Sign::Plus, scaled.magnitude().sqrt());
        let unit = BigInt::one() << bits;
        let (below, above) = (Rational::from_big(root.clone(), unit.clone()), Rational::from_big(root + 1, unit));
        if self.sign > 0 { (&self.rational + below, &self.rational + above) } else { (&self.rational - above, &self.rational - below) }
    }

    /// A rational number strictly between two different numbers.
    #[must_use]
    pub fn between(one: &Self, other: &Self) -> Option<Rational> {
        let (low, high) = match one.cmp(other) {
            Ordering::Less => (one, other),
            Ordering::Equal => return None,
            Ordering::Greater => (other, one),
        };
        let mut bits = 8;
        loop {
            let (below, above) = (low.enclosure(bits).1, high.enclosure(bits).0);
            if below < above {
                return Some((below + above) * Rational::new(1, 2));
            }
            bits *= 2;
        }
    }

    /// The nearest float, or almost; for pictures.
    #[must_use]
    pub fn approximate(&self) -> f64 {
        self.near().approximate()
    }

    /// A rational number so near that the difference is not seen.
    pub(crate) fn near(&self) -> Rational {
        // More bits where a small number is the difference of large ones, or is small itself.
        let size = self.rational.bits().max(self.radicand.bits());
        self.enclosure(u32::try_from(80 + 2 * size).unwrap_or(u32::MAX / 4)).0
    }
}

/// The primes whose squares are taken out of printed roots.
const SMALL_PRIMES: [u32; 25] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53, 59, 61, 67, 71, 73, 79, 83, 89, 97];
/// Printed roots of this many times a square are told apart from others.
const SMALL_COFACTOR: u32 = 30;

fn sign_of(value: &Rational) -> i8 {
    i8::from(value.is_positive()) - i8::from(value.is_negative())
}

/// The sign of `a + sign · √radicand` (no case of it needs the root).
fn sign_with_root(a: &Rational, sign: i8, radicand: &Rational) -> i8 {
    let of_a = sign_of(a);
    if sign == 0 || radicand.is_zero() {
        return of_a;
    }
    if of_a == 0 || of_a == sign {
        return sign;
    }
    match (a * a).cmp(radicand) {
        Ordering::Greater => of_a,
        Ordering::Equal => 0,
        Ordering::Less => sign,
    }
}

/// The root of a non-negative number if it is rational.
pub(crate) fn exact_root(value: &Rational) -> Option<Rational> {
    if let Some((numer, denom)) = value.as_small() {
        let root = |square: u64| {
            // A square ends in one of 12 patterns of 6 bits.
            const SQUARES: u64 = 0x0202_0212_0203_0213;
            if SQUARES >> (square & 63) & 1 == 0 {
                return None;
            }
            let root = square.isqrt();
            (root * root == square).then_some(root as i64)
        };
        return Some(Rational::small(root(u64::try_from(numer).ok()?)?, root(denom)? as u64));
    }
    if value.is_negative() {
        return None;
    }
    let root = |square: BigInt| {
        let square: BigUint = square.into_parts().1;
        let low = square.iter_u64_digits().next().unwrap_or(0);
        if 0x0202_0212_0203_0213u64 >> (low & 63) & 1 == 0 {
            return None;
        }
        let root = square.sqrt();
        (&root * &root == square).then(|| BigInt::from(root))
    };
    // The root of a fraction in lowest terms is in lowest terms.
    Some(Rational::from_reduced_big(root(value.numer())?, root(value.denom())?))
}

impl Default for Surd {
    fn default() -> Self {
        Self::from(Rational::zero())
    }
}

impl From<Rational> for Surd {
    fn from(rational: Rational) -> Self {
        Self { rational, sign: 0, radicand: Rational::zero() }
    }
}

impl From<&Rational> for Surd {
    fn from(rational: &Rational) -> Self {
        Self::from(rational.clone())
    }
}

impl Neg for &Surd {
    type Output = Surd;
    fn neg(self) -> Surd {
        Surd { rational: -&self.rational, sign: -self.sign, radicand: self.radicand.clone() }
    }
}

impl Neg for Surd {
    type Output = Self;
    fn neg(self) -> Self {
        -&self
    }
}

impl Ord for Surd {
    fn cmp(&self, other: &Self) -> Ordering {
        let a = &self.rational - &other.rational;
        let (p, q) = ((self.sign, &self.radicand), (-other.sign, &other.radicand));
        // The sign of the sum of the two roots.
        let of_roots = match (p.0, q.0) {
            (sign, 0) | (0, sign) => sign,
            (one, two) if one == two => one,
            (one, _) => match p.1.cmp(q.1) {
                Ordering::Greater => one,
                Ordering::Equal => 0,
                Ordering::Less => -one,
            },
        };
        let of_a = sign_of(&a);
        let sign = if of_a == 0 || of_a == of_roots {
            of_roots
        } else if of_roots == 0 {
            of_a
        } else {
            // Squares decide: a² against d + e ± 2 √(d e).
            let excess = &a * &a - p.1 - q.1;
            of_a * sign_with_root(&excess, -p.0 * q.0, &(Rational::from(4) * p.1 * q.1))
        };
        sign.cmp(&0)
    }
}

impl PartialOrd for Surd {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl fmt::Display for Surd {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (rational, factor, radicand) = self.printed_parts();
        if factor.is_zero() {
            return write!(f, "{rational}");
        }
        let size = factor.abs();
        let root = if size.is_one() { format!("√{radicand}") } else { format!("{size} √{radicand}") };
        match (rational.is_zero(), factor.is_negative()) {
            (true, false) => write!(f, "{root}"),
            (true, true) => write!(f, "-{root}"),
            (false, false) => write!(f, "{rational} + {root}"),
            (false, true) => write!(f, "{rational} - {root}"),
        }
    }
}

impl fmt::Debug for Surd {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn rational() -> impl Strategy<Value = Rational> {
        prop_oneof![
            4 => (-9i64..10, 1i64..5).prop_map(|(n, d)| Rational::new(n, d)),
            1 => (any::<i64>(), 1i64..i64::MAX).prop_map(|(n, d)| Rational::new(n, d)),
            1 => (any::<i64>(), any::<i64>()).prop_map(|(a, b)| Rational::from(a) * Rational::from(b)),
        ]
    }

    /// Numbers of the field of √2 and of others, squares below the root included.
    fn surd() -> impl Strategy<Value = Surd> {
        let radicand =
            prop_oneof![3 => Just(Rational::from(2)), 1 => (0i64..10).prop_map(Rational::from), 1 => rational().prop_map(|r| r.abs())];
        (rational(), rational(), radicand).prop_filter_map("a radicand", |(a, b, d)| Surd::with_factor(a, &b, &d))
    }

    fn canonical(value: &Surd) -> bool {
        match value.sign {
            0 => value.radicand.is_zero(),
            1 | -1 => {
                let (p, q) = (value.radicand.numer(), value.radicand.denom());
                value.radicand.is_positive() && (p.sqrt().pow(2) != p || q.sqrt().pow(2) != q)
            }
            _ => false,
        }
    }

    /// The slow twin of comparison: intervals that shrink until they are apart.
    fn by_enclosures(one: &Surd, other: &Surd) -> Ordering {
        if one == other {
            return Ordering::Equal;
        }
        (1..)
            .map(|k| 64 * k)
            .find_map(|bits| {
                let ((a, b), (c, d)) = (one.enclosure(bits), other.enclosure(bits));
                if b < c {
                    Some(Ordering::Less)
                } else if d < a {
                    Some(Ordering::Greater)
                } else {
                    None
                }
            })
            .expect("different numbers have disjoint intervals at last")
    }

    proptest! {
        #[test]
        fn comparison_agrees_with_shrinking_intervals(one in surd(), other in surd()) {
            prop_assert!(canonical(&one) && canonical(&other));
            prop_assert_eq!(one.cmp(&other), by_enclosures(&one, &other));
            prop_assert_eq!(one.signum().cmp(&0), by_enclosures(&one, &Surd::default()));
            if let Some(middle) = Surd::between(&one, &other) {
                let middle = Surd::from(middle);
                prop_assert!((one < middle) == (middle < other));
            }
        }

        #[test]
        fn arithmetic_of_one_field(a in rational(), b in rational(), c in rational(), d in rational(), e in 0i64..9) {
            let radicand = Rational::from(e);
            let make = |x: &Rational, y: &Rational| Surd::with_factor(x.clone(), y, &radicand).expect("not negative");
            let (one, other) = (make(&a, &b), make(&c, &d));
            let product = one.times(&other).expect("one field");
            prop_assert!(canonical(&product));
            prop_assert_eq!(&product, &make(&(&a * &c + &b * &d * &radicand), &(&a * &d + &b * &c)));
            prop_assert_eq!(one.plus(&other).expect("one field"), make(&(&a + &c), &(&b + &d)));
            prop_assert_eq!(one.minus(&one).expect("one field"), Surd::default());
            match other.recip() {
                Some(inverse) => prop_assert_eq!(product.times(&inverse).expect("one field"), one.clone()),
                None => prop_assert!(other.is_zero()),
            }
            let polynomial = [c, d, a, b];
            let slow = polynomial.iter().rev().fold(Surd::default(), |sum, k| sum.times(&one).expect("one field").plus_rational(k));
            prop_assert_eq!(one.evaluate(polynomial.iter()), slow);
        }

        #[test]
        fn what_is_printed_is_the_number(value in surd()) {
            let (a, b, n) = value.printed_parts();
            prop_assert_eq!(Surd::with_factor(a, &b, &Rational::from(n)), Some(value.clone()));
            let (low, high) = value.enclosure(40);
            prop_assert!(Surd::from(&low) <= value && value <= Surd::from(high));
            prop_assert!((value.approximate() - low.approximate()).abs() <= 1e-11 * (1.0 + low.approximate().abs()));
        }

        #[test]
        fn roots_of_squares_are_found(value in rational()) {
            prop_assert_eq!(exact_root(&(&value * &value)), Some(value.abs()));
            prop_assert_eq!(exact_root(&(&value * &value * Rational::from(2))).is_some(), value.is_zero());
        }
    }

    #[test]
    fn different_fields_do_not_mix() {
        let root = |n: i64| Surd::root(&Rational::from(n)).expect("not negative");
        assert_eq!(root(2).plus(&root(3)), None);
        assert_eq!(root(2).plus(&root(8)), Some(root(18)));
        assert_eq!(root(2).times(&root(8)), Some(Surd::from(Rational::from(4))));
        assert_eq!(Surd::root(&Rational::from(-1)), None);
        assert!(root(2) < root(3) && -root(2) > -root(3));
    }

    #[test]
    fn printing() {
        let surd = |n, d, sign, p, q| Surd::new(Rational::new(n, d), sign, Rational::new(p, q)).map(|surd| surd.to_string());
        assert_eq!(surd(-30, 7, -1, 2896, 147).as_deref(), Some("-30/7 - 4/21 √543"));
        assert_eq!(surd(0, 1, -1, 3, 1).as_deref(), Some("-√3"));
        assert_eq!(surd(1, 3, 1, 4, 9).as_deref(), Some("1"));
        assert_eq!(surd(2, 1, 1, 1_000_003 * 1_000_003, 2).as_deref(), Some("2 + 1000003/2 √2"));
    }
}
